"""The tire of CommonRoad: a Magic Formula whose coefficients do not depend on the load."""

from __future__ import annotations

import sympy as sm

from pydy.vehicles.algebra import Operand, SymbolicAlgebra, Zero
from pydy.vehicles.cars import STIFFNESS_PER_LOAD
from pydy.vehicles.equations import cos_of_atan

# Table 7 of CommonRoad: Vehicle Models, 2020, with the digits of the package
# commonroad-vehicle-models 3.0.2.
LONGITUDINAL = {
    "cx1": 1.6411, "dx1": 1.1739, "dx3": 0.0, "ex1": 0.46403, "kx1": 22.303, "hx1": 0.0012297,
    "vx1": -8.8098e-06,
}  # fmt: skip
LATERAL = {
    "cy1": 1.3507, "dy1": 1.0489, "dy3": -2.8821, "ey1": -0.0074722, "ky1": -STIFFNESS_PER_LOAD,
    "hy1": 0.0026747, "hy3": 0.031415, "vy1": 0.037318, "vy3": -0.32931,
}  # fmt: skip
COMBINED_LONGITUDINAL = {
    "bx1": 13.276, "bx2": -13.778, "cx1": 1.2568, "ex1": 0.65225, "hx1": 0.0050722,
}  # fmt: skip
COMBINED_LATERAL = {
    "by1": 7.1433, "by2": 9.1916, "by3": -0.027856, "cy1": 1.0719, "ey1": -0.27572,
    "hy1": 5.7448e-06, "vy1": -0.027825, "vy3": -0.27568, "vy4": 12.12, "vy5": 1.9, "vy6": -10.704,
}  # fmt: skip


_m = SymbolicAlgebra()
_UPRIGHT = Zero()


def tire_forces(
    Fz: sm.Expr, kappa: sm.Expr, alpha: sm.Expr, gamma: Operand = _UPRIGHT
) -> tuple[sm.Expr, sm.Expr]:
    """Return F_x and F_y of a tire. Without camber its side force has no shifts."""
    sign = _m.sign(gamma)
    p = _constants(LONGITUDINAL)
    friction = p["dx1"] * (1 - p["dx3"] * gamma**2)
    angle = _angle(p["kx1"] / (p["cx1"] * friction), p["cx1"], p["ex1"], kappa + p["hx1"])
    pure_x = friction * Fz * _m.sin(angle + Fz * p["vx1"])
    p = _constants(LATERAL)
    friction = p["dy1"] * (1 - p["dy3"] * gamma**2)
    shifted = alpha + p["hy1"] * sign + p["hy3"] * gamma
    angle = _angle(p["ky1"] / (p["cy1"] * friction), p["cy1"], p["ey1"], shifted)
    pure_y = Fz * (friction * _m.sin(angle) + p["vy1"] * sign + p["vy3"] * gamma)
    r = _constants(COMBINED_LONGITUDINAL)
    weight_x = _weight(
        r["bx1"] * cos_of_atan(_m, r["bx2"] * kappa), r["cx1"], r["ex1"], alpha, r["hx1"]
    )
    r = _constants(COMBINED_LATERAL)
    steepness = r["by1"] * cos_of_atan(_m, r["by2"] * (alpha - r["by3"]))
    weight_y = _weight(steepness, r["cy1"], r["ey1"], -kappa, r["hy1"])
    size = friction * Fz * (r["vy1"] + r["vy3"] * gamma) * cos_of_atan(_m, r["vy4"] * alpha)
    side = size * _m.sin(r["vy5"] * _m.atan(-r["vy6"] * kappa))
    return pure_x * weight_x, pure_y * weight_y + side


def _constants(table: dict[str, float]) -> dict[str, Operand]:
    return {name: _m.constant(value) for name, value in table.items()}


def _angle(steepness: Operand, shape: float, curvature: float, slip: Operand) -> sm.Expr:
    """Return the angle of the Magic Formula, whose sine or cosine is the force or its weight."""
    x = steepness * slip
    return shape * _m.atan(x - curvature * (x - _m.atan(x)))


def _weight(
    steepness: Operand, shape: float, curvature: float, slip: Operand, shift: float
) -> sm.Expr:
    """Return the share of a force that is left at the slip in the other direction."""
    at, without = (_angle(steepness, shape, curvature, s) for s in (slip + shift, shift))
    return _m.cos(at) / _m.cos(without)
