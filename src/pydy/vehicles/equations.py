"""The forms of the Magic Formula, and what all its equations depend on.

Published versions share most equations; a `FormulaVariant` names those that differ. The
equations are those of Pacejka 2012, section 4.3.2, numbered (4.E…) there, without turn slip: all
ζ are 1.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from pydy.vehicles.algebra import Algebra, Operand, is_symbolic
from pydy.vehicles.coefficients import Coefficients
from pydy.vehicles.forces import TireInputs, direction
from pydy.vehicles.tuning import SMALLEST_LOAD, SMALLEST_SLIP


@dataclass(frozen=True)
class FormulaVariant:
    """Where published forms of the Magic Formula differ.

    Attributes
    ----------
    tangent : bool
        Whether α and γ enter as tan α and sin γ, (4.E3) and (4.E4), or as angles.
    pressure : bool
        Whether the inflation pressure has an effect.
    camber_stiffness : bool
        Whether the horizontal shift follows from the camber stiffness (4.E27), or is PHY3 γ.
    trail_by_size : bool
        Whether the trail depends on the size of γ by QDZ3 (4.E43), or on γ.
    equivalent_tangent : bool
        Whether the equivalent slip of the trail combines tan α with κ, or α (4.E77).
    uncambered : bool
        Whether the trail acts on the side force without camber (4.E74), or on F_y − S_Vyκ.
    upright_weight : bool
        Whether the weight of that side force G_yκ is without camber, too.
    scaled_trail, scaled_arm : bool
        Whether the trail (4.E42) and the arm of F_x (4.E76) refer to the scaled nominal load, or
        to the nominal load itself.
    saturation : float
        A_μ of (4.E8).
    relaxation_sign : float
        Sign of PTX3 in the exponent of the relaxation length σ_κ.
    whole_overturning : bool
        Whether LMX scales all of Mx, or not its offset QSX1.
    """

    tangent: bool
    pressure: bool
    camber_stiffness: bool
    trail_by_size: bool
    equivalent_tangent: bool
    uncambered: bool
    upright_weight: bool
    scaled_trail: bool
    scaled_arm: bool
    saturation: float
    relaxation_sign: float
    whole_overturning: bool


_BOOK = FormulaVariant(
    tangent=True,
    pressure=True,
    camber_stiffness=True,
    trail_by_size=True,
    equivalent_tangent=False,
    uncambered=True,
    upright_weight=True,
    scaled_trail=True,
    scaled_arm=True,
    saturation=10.0,
    relaxation_sign=-1.0,
    whole_overturning=True,
)
_PAPER = replace(
    _BOOK,
    tangent=False,
    trail_by_size=False,
    equivalent_tangent=True,
    upright_weight=False,
    scaled_arm=False,
    saturation=1.0,
)
_MF52 = FormulaVariant(
    tangent=False,
    pressure=False,
    camber_stiffness=False,
    trail_by_size=False,
    equivalent_tangent=True,
    uncambered=False,
    upright_weight=False,
    scaled_trail=False,
    scaled_arm=False,
    saturation=1.0,
    relaxation_sign=-1.0,
    whole_overturning=False,
)
_PAC2002 = replace(_MF52, pressure=True, relaxation_sign=1.0, whole_overturning=True)
# By version and by the source of its equations; the first of a version is its default.
FORMS: dict[str, dict[str, FormulaVariant]] = {
    "5.2": {"tno": _MF52},
    "PAC2002": {"adams": _PAC2002},
    "6.1": {"pacejka": _BOOK, "besselink": _PAPER},
    "6.2": {"pacejka": _BOOK, "besselink": _PAPER},
}


@dataclass(frozen=True)
class EquationInputs:
    """A state of the contact, as the equations use it.

    Attributes
    ----------
    m, c, form
        Algebra, coefficients, and form of the equations.
    Fz : quantity
        Normal force, not negative.
    load : quantity
        The same, but never zero: what ratios are computed from.
    Fz0 : quantity
        Scaled nominal load F'z0.
    dfz, dpi : quantity
        Relative changes of load and pressure, (4.E2).
    kappa, slip, camber, angle, gamma, cos_alpha : quantity
        κ; α* and γ*; α and γ themselves; the cosine of α.
    direction, fade : quantity
        Sign of the rolling speed, and the factor of shifts that vanishes at rest.
    speed_ratio : quantity
        V_x/V_0.
    mux, muy : quantity
        Scaling factors of friction λ*μ, (4.E7).
    offset_x, offset_y : quantity
        Those of vertical shifts λ'μ, (4.E8).
    """

    m: Algebra
    c: Operand
    form: FormulaVariant
    Fz: Operand
    load: Operand
    Fz0: Operand
    dfz: Operand
    dpi: Operand
    kappa: Operand
    slip: Operand
    camber: Operand
    angle: Operand
    gamma: Operand
    cos_alpha: Operand
    direction: Operand
    fade: Operand
    speed_ratio: Operand
    mux: Operand
    muy: Operand
    offset_x: Operand
    offset_y: Operand

    @property
    def radius(self) -> Operand:
        """Unloaded radius (m)."""
        return self.c.UNLOADED_RADIUS


def condition(
    m: Algebra, form: FormulaVariant, values: dict[str, Operand], state: TireInputs
) -> EquationInputs:
    """Return what the equations need of the inputs."""
    c = Coefficients({name: m.constant(value) for name, value in values.items()})
    Fz0 = c.FNOMIN * c.LFZO
    load = m.maximum(state.Fz, SMALLEST_LOAD * Fz0)
    alpha, gamma = state.alpha, state.gamma
    tangent = m.tan(alpha)
    sign, fade, ratio = _rolling(m, c, state.speed)
    slow = 1
    if is_symbolic(c.LMUV) or c.LMUV:
        sliding = m.sqrt(state.kappa**2 + tangent**2 + SMALLEST_SLIP**2)
        slow = 1 / (1 + c.LMUV * m.abs(ratio) * sliding)
    mux, muy = c.LMUX * slow, c.LMUY * slow
    A = form.saturation
    return EquationInputs(
        m=m,
        c=c,
        form=form,
        Fz=m.maximum(state.Fz, 0),
        load=load,
        Fz0=Fz0,
        dfz=load / Fz0 - 1,
        dpi=_pressure_change(c, form, state.pressure),
        kappa=state.kappa,
        slip=tangent if form.tangent else alpha,
        camber=m.sin(gamma) if form.tangent else gamma,
        angle=alpha,
        gamma=gamma,
        cos_alpha=m.cos(alpha),
        direction=sign,
        fade=fade,
        speed_ratio=ratio,
        mux=mux,
        muy=muy,
        offset_x=mux if A == 1.0 else A * mux / (1 + (A - 1.0) * mux),
        offset_y=muy if A == 1.0 else A * muy / (1 + (A - 1.0) * muy),
    )


def _rolling(m: Algebra, c: Operand, speed: Operand) -> tuple[Operand, Operand, Operand]:
    """Return the direction of rolling, the factor of shifts, and the speed relative to LONGVL.

    Below VXLOW both factors are polynomials with continuous derivatives.
    """
    if speed is None:
        return 1, 1, 1
    size = m.minimum(m.abs(speed / c.VXLOW), 1)
    return direction(m, speed / c.VXLOW), size**2 * (3 - 2 * size), speed / c.LONGVL


def _pressure_change(c: Operand, form: FormulaVariant, pressure: Operand) -> Operand:
    if not form.pressure:
        return 0
    if not is_symbolic(c.NOMPRES) and c.NOMPRES == 0.0:
        if pressure is not None:
            raise ValueError(
                "`pressure` needs the coefficient NOMPRES, the pressure that the tire was measured "
                "at, which is missing: leave `pressure` out, or give it with `replace`."
            )
        return 0
    if pressure is None:
        pressure = c.INFLPRES
        if not is_symbolic(pressure) and pressure == 0.0:
            return 0
    return pressure / c.NOMPRES - 1


def curve(m: Algebra, outer: Operand, shape: Operand, curvature: Operand, x: Operand) -> Operand:
    """Return sin or cos (`outer`) of C arctan(x − E (x − arctan x)), with x = B times a slip."""
    return outer(shape * m.atan(x - curvature * (x - m.atan(x))))


def limited(m: Algebra, curvature: Operand) -> Operand:
    """Return a curvature factor E, at most 1."""
    return m.minimum(curvature, 1)


def cos_of_atan(m: Algebra, x: Operand) -> Operand:
    """Return cos(arctan x)."""
    return 1 / m.sqrt(1 + x**2)


@dataclass(frozen=True)
class Longitudinal:
    """Pure longitudinal slip; all but `slip`, which is shifted, are divided by the load."""

    force: Operand
    friction: Operand
    stiffness: Operand
    shift: Operand
    slip: Operand


def longitudinal(s: EquationInputs) -> Longitudinal:
    """Return the pure longitudinal force, (4.E9) to (4.E18)."""
    m, c, dfz, dpi = s.m, s.c, s.dfz, s.dpi
    camber = s.camber * c.LGAX
    C = c.PCX1 * c.LCX
    mu = (c.PDX1 + c.PDX2 * dfz) * (1 + c.PPX3 * dpi + c.PPX4 * dpi**2)
    mu = mu * (1 - c.PDX3 * camber**2) * s.mux
    K = (c.PKX1 + c.PKX2 * dfz) * m.exp(c.PKX3 * dfz) * (1 + c.PPX1 * dpi + c.PPX2 * dpi**2) * c.LKX
    kappa = s.kappa + (c.PHX1 + c.PHX2 * dfz) * c.LHX * s.fade
    E = (c.PEX1 + c.PEX2 * dfz + c.PEX3 * dfz**2) * c.LEX
    E = limited(m, E * (1 - c.PEX4 * m.sign(kappa)))
    shift = (c.PVX1 + c.PVX2 * dfz) * c.LVX * s.offset_x * s.fade
    force = mu * curve(m, m.sin, C, E, K / (C * mu) * kappa) + shift
    return Longitudinal(force, mu, K, shift, kappa)


@dataclass(frozen=True)
class Lateral:
    """Pure side slip; `force`, `friction`, `stiffness` and `shift_v` are divided by the load."""

    force: Operand
    friction: Operand
    stiffness: Operand
    shift_h: Operand
    shift_v: Operand
    BC: Operand


def cornering_stiffness(s: EquationInputs, camber: Operand) -> Operand:
    """Return the cornering stiffness K_yα divided by the load, (4.E25)."""
    m, c = s.m, s.c
    ratio = s.load / s.Fz0
    x = ratio / ((c.PKY2 + c.PKY5 * camber**2) * (1 + c.PPY2 * s.dpi))
    # The sine of twice an arctangent, for the usual PKY4, needs no functions.
    rise = 2 * x / (1 + x**2) if c.PKY4 == 2 else m.sin(c.PKY4 * m.atan(x))
    K = c.PKY1 * (1 + c.PPY1 * s.dpi) * (1 - c.PKY3 * m.abs(camber)) * c.LKY
    return K * rise / ratio


def camber_stiffness(s: EquationInputs) -> Operand:
    """Return the camber stiffness K_yγ0 divided by the load.

    It is (4.E30), or in forms without it the slope of the camber's shifts.
    """
    c = s.c
    if s.form.camber_stiffness:
        return (c.PKY6 + c.PKY7 * s.dfz) * (1 + c.PPY5 * s.dpi) * c.LKYC
    shift_v = (c.PVY3 + c.PVY4 * s.dfz) * s.offset_y
    return (cornering_stiffness(s, 0) * c.PHY3 + shift_v) * c.LKYC


def lateral(s: EquationInputs, *, upright: bool = False) -> Lateral:
    """Return the pure side force, (4.E19) to (4.E30); of an `upright` wheel without its camber."""
    m, c, dfz, dpi = s.m, s.c, s.dfz, s.dpi
    camber = 0 if upright else s.camber * c.LGAY
    C = c.PCY1 * c.LCY
    mu = (c.PDY1 + c.PDY2 * dfz) * (1 + c.PPY3 * dpi + c.PPY4 * dpi**2)
    mu = mu * (1 - c.PDY3 * camber**2) * s.muy
    K = cornering_stiffness(s, camber)
    thrust = (c.PVY3 + c.PVY4 * dfz) * camber * c.LKYC * s.offset_y
    shift_h = (c.PHY1 + c.PHY2 * dfz) * c.LHY
    if s.form.camber_stiffness:
        shift_h = shift_h + (camber_stiffness(s) * camber - thrust) / K
    else:
        shift_h = shift_h + c.PHY3 * camber * c.LKYC
    shift_h = shift_h * s.fade
    shift_v = ((c.PVY1 + c.PVY2 * dfz) * c.LVY * s.offset_y + thrust) * s.fade
    alpha = s.slip + shift_h
    E = (c.PEY1 + c.PEY2 * dfz) * c.LEY
    asymmetry = (c.PEY3 + c.PEY4 * camber) * m.sign(alpha)
    E = limited(m, E * (1 + c.PEY5 * camber**2 - asymmetry))
    force = mu * curve(m, m.sin, C, E, K / (C * mu) * alpha) + shift_v
    return Lateral(force, mu, K, shift_h, shift_v, K / mu)
