"""Relaxation lengths of the Magic Formula."""

from __future__ import annotations

from typing import Any

from pydy.vehicles.equations import Condition, cornering_stiffness, longitudinal


def relaxation_lengths(s: Condition) -> tuple[Any, Any]:
    """Return σ_κ and σ_α (m) by the form of the equations."""
    return _of_carcass(s) if s.form.camber_stiffness else _empirical(s)


def _of_carcass(s: Condition) -> tuple[Any, Any]:
    """Return slip stiffness divided by carcass stiffness, Besselink et al. 2010, (17) to (19)."""
    m, c, dfz = s.m, s.c, s.dfz
    Cx = c.LONGITUDINAL_STIFFNESS * (1 + c.PCFX1 * dfz + c.PCFX2 * dfz**2) * (1 + c.PCFX3 * s.dpi)
    Cy = c.LATERAL_STIFFNESS * (1 + c.PCFY1 * dfz + c.PCFY2 * dfz**2) * (1 + c.PCFY3 * s.dpi)
    Kx = longitudinal(s).stiffness
    Ky = cornering_stiffness(s, s.camber)
    return s.Fz * m.abs(Kx / Cx), s.Fz * m.abs(Ky / Cy)


def _empirical(s: Condition) -> tuple[Any, Any]:
    """Return the lengths of MF 5.2 and PAC2002; the sign of PTX3 is that of the form."""
    m, c, dfz = s.m, s.c, s.dfz
    growth = m.exp(s.form.relaxation_sign * c.PTX3 * dfz)
    sigma_x = s.Fz * (c.PTX1 + c.PTX2 * dfz) * growth * (s.radius / c.FNOMIN) * c.LSGKP
    x = s.Fz / (c.PTY2 * s.Fz0)
    rise = 2 * x / (1 + x**2)  # the sine of twice the arctangent
    bent = 1 - c.PKY3 * m.abs(s.camber * c.LGAY)
    return sigma_x, c.PTY1 * rise * bent * s.radius * c.LFZO * c.LSGAL
