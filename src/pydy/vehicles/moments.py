"""Combined slip and the moments of the Magic Formula; equations (4.E…) of Pacejka 2012."""

from __future__ import annotations

from math import pi

from pydy.vehicles.algebra import Operand, is_symbolic
from pydy.vehicles.equations import (
    EquationInputs,
    Lateral,
    Longitudinal,
    cos_of_atan,
    curve,
    lateral,
    limited,
)
from pydy.vehicles.tuning import SMALLEST_SLIP


def longitudinal_weight(s: EquationInputs) -> Operand:
    """Return G_xα, by which side slip reduces the longitudinal force, (4.E51) to (4.E57)."""
    m, c = s.m, s.c
    B = (c.RBX1 + c.RBX3 * s.camber**2) * cos_of_atan(m, c.RBX2 * s.kappa) * c.LXAL
    E = limited(m, c.REX1 + c.REX2 * s.dfz)
    weight = curve(m, m.cos, c.RCX1, E, B * (s.slip + c.RHX1))
    return weight / curve(m, m.cos, c.RCX1, E, B * c.RHX1)


def lateral_weight(s: EquationInputs, *, upright: bool = False) -> Operand:
    """Return G_yκ, by which longitudinal slip reduces the side force, (4.E59) to (4.E65)."""
    m, c = s.m, s.c
    camber = 0 if upright else s.camber
    B = (c.RBY1 + c.RBY4 * camber**2) * c.LYKA
    B = B * cos_of_atan(m, c.RBY2 * (s.slip - c.RBY3))
    E = limited(m, c.REY1 + c.REY2 * s.dfz)
    shift = c.RHY1 + c.RHY2 * s.dfz
    weight = curve(m, m.cos, c.RCY1, E, B * (s.kappa + shift))
    return weight / curve(m, m.cos, c.RCY1, E, B * shift)


def ellipse_weights(s: EquationInputs, x: Longitudinal, y: Lateral) -> tuple[Operand, Operand]:
    """Return weights of both forces by friction ellipses, which need no coefficients.

    An ellipse combines the friction that pure slip uses in one direction with the largest friction
    in the other direction. The direction of slip selects the point on it.
    """
    m, tiny = s.m, SMALLEST_SLIP
    kappa = m.abs(x.slip + x.shift / x.stiffness)
    alpha = m.abs(m.sin(s.angle + y.shift_h + y.shift_v / y.stiffness))
    # Secants of the characteristics, which are their tangents where the slip is zero.
    rise_x = (m.abs(x.force - x.shift) + m.abs(x.stiffness) * tiny) / (kappa + tiny)
    rise_y = (m.abs(y.force - y.shift_v) + m.abs(y.stiffness) * tiny) / (alpha + tiny)
    return (
        1 / m.sqrt(1 + (rise_x * alpha / y.friction) ** 2),
        1 / m.sqrt(1 + (rise_y * kappa / x.friction) ** 2),
    )


def induced_side_force(s: EquationInputs, pure: Lateral) -> Operand:
    """Return S_Vyκ divided by the load: ply steer that κ induces, (4.E66) and (4.E67)."""
    m, c = s.m, s.c
    D = pure.friction * (c.RVY1 + c.RVY2 * s.dfz + c.RVY3 * s.camber)
    D = D * cos_of_atan(m, c.RVY4 * s.slip)
    return D * m.sin(c.RVY5 * m.atan(c.RVY6 * s.kappa)) * c.LVYKA * s.fade


def aligning_moment(
    s: EquationInputs,
    x: Longitudinal | None,
    y: Lateral,
    Fx: Operand,
    Fy: Operand,
    induced: Operand,
    weight: Operand,
) -> Operand:
    """Return the aligning moment M_z, (4.E31) to (4.E49) and (4.E71) to (4.E78).

    If `x` is None, the slip is pure side slip: `induced` is then 0 and `weight` is 1. Some forms
    compute the moment with the side force without camber, whose weight is `weight`.
    """
    m, c, dfz = s.m, s.c, s.dfz
    camber = s.camber * c.LGAZ
    shift = c.QHZ1 + c.QHZ2 * dfz + (c.QHZ3 + c.QHZ4 * dfz) * camber
    alpha_t = s.slip + shift * s.fade
    alpha_r = s.slip + y.shift_h + y.shift_v / y.stiffness
    stiffness = c.LKY / s.muy
    B = (c.QBZ1 + c.QBZ2 * dfz + c.QBZ3 * dfz**2) * stiffness
    B = B * (1 + c.QBZ4 * camber + c.QBZ5 * m.abs(camber) + c.QBZ6 * camber**2)
    C = c.QCZ1
    bent = m.abs(camber) if s.form.trail_by_size else camber
    D = (c.QDZ1 + c.QDZ2 * dfz) * (1 - c.PPZ1 * s.dpi) * c.LTR * s.radius
    D = D * s.load / (s.Fz0 if s.form.scaled_trail else c.FNOMIN)
    D = D * (1 + c.QDZ3 * bent + c.QDZ4 * camber**2) * s.direction
    E = c.QEZ1 + c.QEZ2 * dfz + c.QEZ3 * dfz**2
    asymmetry = (c.QEZ4 + c.QEZ5 * camber) * (2 / pi) * m.atan(B * C * alpha_t)
    E = limited(m, E * (1 + asymmetry))
    if x is not None:
        ratio = x.stiffness / y.stiffness * s.kappa
        alpha_t, alpha_r = (_equivalent(s, alpha, ratio) for alpha in (alpha_t, alpha_r))
    trail = D * curve(m, m.cos, C, E, B * alpha_t) * s.cos_alpha
    side_force = Fy - induced
    if s.form.uncambered:
        side_force = weight * lateral(s, upright=True).force
    moment = -trail * side_force + _residual(s, y, camber, alpha_r, stiffness)
    if x is not None:
        reference = s.Fz0 if s.form.scaled_arm else c.FNOMIN
        arm = c.SSZ1 + c.SSZ2 * Fy * s.load / reference + (c.SSZ3 + c.SSZ4 * dfz) * s.camber
        moment = moment + s.radius * arm * c.LS * Fx
    return moment


def _residual(
    s: EquationInputs, y: Lateral, camber: Operand, alpha: Operand, stiffness: Operand
) -> Operand:
    """Return the residual moment M_zr divided by the load, (4.E36), (4.E45) to (4.E47)."""
    m, c, dfz = s.m, s.c, s.dfz
    B = c.QBZ9 * stiffness + c.QBZ10 * y.BC
    D = (c.QDZ8 + c.QDZ9 * dfz) * (1 + c.PPZ2 * s.dpi)
    D = (D + (c.QDZ10 + c.QDZ11 * dfz) * m.abs(camber)) * camber * c.LKZC
    D = (D + (c.QDZ6 + c.QDZ7 * dfz) * c.LRES) * s.radius * s.muy * s.direction * s.fade
    return D * cos_of_atan(m, B * alpha) * s.cos_alpha


def _equivalent(s: EquationInputs, alpha: Operand, ratio: Operand) -> Operand:
    """Return the equivalent slip of α and κ combined, with the sign of α, (4.E77).

    It is a tangent in forms whose slips are tangents.
    """
    m, tiny = s.m, SMALLEST_SLIP**2
    if s.form.equivalent_tangent and not s.form.tangent:
        size = m.atan(m.sqrt(m.tan(alpha) ** 2 + ratio**2 + tiny))
    else:
        size = m.sqrt(alpha**2 + ratio**2 + tiny)
    return size * m.side(alpha)


def overturning_moment(s: EquationInputs, Fy: Operand) -> Operand:
    """Return M_x divided by the load, (4.E69); `Fy` is divided by it too."""
    m, c, gamma = s.m, s.c, s.gamma
    ratio = s.load / c.FNOMIN
    side = Fy * ratio
    offset = c.QSX1 * c.LVMX
    moment = -c.QSX2 * gamma * (1 + c.PPMX1 * s.dpi) + c.QSX3 * side
    moment = moment - c.QSX12 * gamma * m.abs(gamma)
    bent = m.sin(c.QSX7 * gamma + c.QSX8 * m.atan(c.QSX9 * side))
    moment = moment + c.QSX4 * m.cos(c.QSX5 * m.atan((c.QSX6 * ratio) ** 2)) * bent
    moment = moment + c.QSX10 * m.atan(c.QSX11 * ratio) * gamma
    moment = moment + Fy * (c.QSX13 + c.QSX14 * m.abs(gamma))
    if s.form.whole_overturning:
        return s.radius * c.LMX * (offset + moment)
    return s.radius * (offset + c.LMX * moment)


def rolling_resistance(s: EquationInputs, Fx: Operand) -> Operand:
    """Return M_y divided by the load, against rolling; `Fx` is divided by it too.

    The load of (4.E70) appears inside the power alone, as in Besselink 2010, (A48).
    """
    m, c = s.m, s.c
    ratio = s.load / c.FNOMIN
    V = s.speed_ratio
    size = c.QSY1 + c.QSY2 * Fx * ratio + c.QSY3 * m.abs(V) + c.QSY4 * V**4
    size = size + (c.QSY5 + c.QSY6 * ratio) * s.gamma**2
    if is_symbolic(c.QSY7) or c.QSY7 != 1:
        size = size * ratio ** (c.QSY7 - 1)
    if is_symbolic(c.QSY8) or c.QSY8:
        size = size * (1 + s.dpi) ** c.QSY8
    return -s.radius * size * c.LMY * s.direction
