"""The elastic carcass of a tire: relaxation lengths, normal force and effective rolling radius."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pydy.vehicles.algebra import Algebra, Operand, is_symbolic
from pydy.vehicles.coefficients import Coefficients
from pydy.vehicles.equations import EquationInputs, cornering_stiffness, longitudinal


def relaxation_lengths(s: EquationInputs) -> tuple[Operand, Operand]:
    """Return σ_κ and σ_α (m) by the form of the equations."""
    return _of_carcass(s) if s.form.camber_stiffness else _empirical(s)


def _of_carcass(s: EquationInputs) -> tuple[Operand, Operand]:
    """Return slip stiffness divided by carcass stiffness, Besselink et al. 2010, (17) to (19)."""
    m, c, dfz = s.m, s.c, s.dfz
    Cx = c.LONGITUDINAL_STIFFNESS * (1 + c.PCFX1 * dfz + c.PCFX2 * dfz**2) * (1 + c.PCFX3 * s.dpi)
    Cy = c.LATERAL_STIFFNESS * (1 + c.PCFY1 * dfz + c.PCFY2 * dfz**2) * (1 + c.PCFY3 * s.dpi)
    Kx = longitudinal(s).stiffness
    Ky = cornering_stiffness(s, s.camber)
    return s.Fz * m.abs(Kx / Cx), s.Fz * m.abs(Ky / Cy)


def _empirical(s: EquationInputs) -> tuple[Operand, Operand]:
    """Return the lengths of MF 5.2 and PAC2002; the sign of PTX3 is that of the form."""
    m, c, dfz = s.m, s.c, s.dfz
    growth = m.exp(s.form.relaxation_sign * c.PTX3 * dfz)
    sigma_x = s.Fz * (c.PTX1 + c.PTX2 * dfz) * growth * (s.radius / c.FNOMIN) * c.LSGKP
    x = s.Fz / (c.PTY2 * s.Fz0)
    rise = 2 * x / (1 + x**2)  # the sine of twice the arctangent
    bent = 1 - c.PKY3 * m.abs(s.camber * c.LGAY)
    return sigma_x, c.PTY1 * rise * bent * s.radius * c.LFZO * c.LSGAL


@dataclass(frozen=True)
class VerticalState:
    """The distance of a tire to the road and its derivative."""

    gap: Operand
    rate: Operand


def normal_force(m: Algebra, values: Mapping[str, Operand], state: VerticalState) -> Operand:
    """Return the normal force of spring and damper, Pacejka 2012, (A3.3) without other effects.

    LCZ scales the spring, (4.E68).

    Q_FZ1, the slope without a load, follows from the stiffness at the nominal load:
    Q_FZ1² = (k R_0/F_z0)² − 4 Q_FZ2.
    """
    c = Coefficients({name: m.constant(value) for name, value in values.items()})
    depth = -state.gap
    force = c.VERTICAL_STIFFNESS * depth
    if is_symbolic(c.Q_FZ2) or c.Q_FZ2:
        x = depth / c.UNLOADED_RADIUS
        slope = m.sqrt((c.VERTICAL_STIFFNESS * c.UNLOADED_RADIUS / c.FNOMIN) ** 2 - 4 * c.Q_FZ2)
        force = c.FNOMIN * (slope + c.Q_FZ2 * x) * x
    force = c.LCZ * force
    force = m.maximum(force - c.VERTICAL_DAMPING * state.rate, 0)
    return m.where_negative(state.gap, force, 0)


@dataclass(frozen=True)
class LoadState:
    """The load of a tire."""

    Fz: Operand


def rolling_radius(m: Algebra, values: Mapping[str, Operand], state: LoadState) -> Operand:
    """Return the effective rolling radius, Besselink et al. 2010, (1) and (7), without speed."""
    c = Coefficients({name: m.constant(value) for name, value in values.items()})
    x = m.maximum(state.Fz, 0) / c.FNOMIN
    fall = c.DREFF * m.atan(c.BREFF * x) + c.FREFF * x
    return c.UNLOADED_RADIUS * c.Q_RE0 - c.FNOMIN / (c.LCZ * c.VERTICAL_STIFFNESS) * fall
