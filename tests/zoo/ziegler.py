"""A column that flutters under a force along its end."""

import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.mechanics import Definition
from zoo import inertial_frame

__all__ = ["zieglers_pendulum"]


def zieglers_pendulum(damping):
    """Two bars with a force along the second, as published: masses 2 m and m, equal springs."""
    q1, q2, u1, u2 = me.dynamicsymbols("q1 q2 u1 u2")
    P, c = sm.symbols("P c")
    N, O = inertial_frame()
    A, B = (N.orientnew(name, "Axis", (q, N.z)) for name, q in (("A", q1), ("B", q2)))
    knee = O.locatenew("K", A.x)
    end = knee.locatenew("E", B.x)
    lower, upper = q1 + c * u1, q2 - q1 + c * (u2 - u1)
    loads = [(end, -P * B.x), (A, (upper - lower) * N.z), (B, -upper * N.z)]
    bodies = [me.Particle("knee", knee, 2), me.Particle("end", end, 1)]
    definition = Definition(N, [q1, q2], [u1, u2], bodies=bodies, loads=loads)
    return System(definition, constants={"c": damping})
