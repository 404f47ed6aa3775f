"""Wheels: one that moves freely, with yaw, lean to the right and spin; one in its plane."""

from functools import cache
from types import SimpleNamespace

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from zoo import inertial_frame

COORDINATES, SPEEDS = "x y z yaw lean spin", "vx vy vz w1 w2 w3"


def free_wheel(mass=10.0, axial=0.5, diametral=0.3):
    """Return the wheel; its angular velocity has components in the axes B, which lean."""
    names, rates = me.dynamicsymbols(COORDINATES), me.dynamicsymbols(SPEEDS)
    x, y, z, yaw, lean, spin = names
    N, O = inertial_frame()
    A = N.orientnew("A", "Axis", (yaw, N.z))
    B = A.orientnew("B", "Axis", (lean, A.x))
    W = me.ReferenceFrame("W")
    W.orient_axis(B, B.y, spin)
    turning = W.ang_vel_in(N)
    W.set_ang_vel(N, sum(w * v for w, v in zip(rates[3:], B, strict=True)))
    G = O.locatenew("G", x * N.x + y * N.y + z * N.z)
    G.set_vel(N, sum(v * e for v, e in zip(rates[:3], N, strict=True)))
    body = me.RigidBody("wheel", G, W, mass, (me.inertia(B, diametral, axial, diametral), G))
    kinematics = [q.diff() - u for q, u in zip(names[:3], rates[:3], strict=True)]
    kinematics += [(turning - W.ang_vel_in(N)).dot(e) for e in B]
    return SimpleNamespace(**locals())


def planar_wheel(mass, axial):
    """Return a wheel in the plane of x and z, its coordinates and speeds in `q` and `u`."""
    q, u = me.dynamicsymbols("x z q"), me.dynamicsymbols("vx vz w")
    N, O = inertial_frame()
    W = me.ReferenceFrame("W")
    W.orient_axis(N, N.y, q[2])
    W.set_ang_vel(N, u[2] * N.y)
    C = O.locatenew("C", q[0] * N.x + q[1] * N.z)
    C.set_vel(N, u[0] * N.x + u[1] * N.z)
    body = me.RigidBody("wheel", C, W, mass, (me.inertia(W, 0, axial, 0), C))
    return SimpleNamespace(**locals())


@cache
def _function(names, expression):
    return sm.lambdify(me.dynamicsymbols(" ".join(names)), expression, cse=True)


def values(wheel, expression, state):
    """Return an expression, or the components of a vector in N, at a state by names."""
    if isinstance(expression, me.Vector):
        expression = sm.ImmutableMatrix(expression.to_matrix(wheel.N))
    result = _function(tuple(state), expression)(*state.values())
    return np.ravel(result) if isinstance(expression, sm.MatrixBase) else float(result)


def derivative(wheel, expression, state):
    """Return the time derivative of an expression of the coordinates, by differences."""
    turn = state["w3"] / np.cos(state["lean"])
    rates = {
        "x": state["vx"], "y": state["vy"], "z": state["vz"],
        "yaw": turn, "lean": state["w1"], "spin": state["w2"] - turn * np.sin(state["lean"]),
    }  # fmt: skip
    step = 1e-7
    after, before = (
        values(wheel, expression, {k: v + h * rates.get(k, 0.0) for k, v in state.items()})
        for h in (step, -step)
    )
    return (after - before) / (2 * step)
