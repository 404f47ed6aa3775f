"""Vehicles for laps: a point mass with a friction circle."""

from __future__ import annotations

import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.mechanics import Definition


def point_mass(speed=20.0):
    """A point whose controls are its longitudinal and lateral acceleration."""
    x, y, psi, u, a_x, a_y = me.dynamicsymbols("x y psi u a_x a_y")
    N, B, O = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    O.set_vel(N, 0)
    B.orient_axis(N, N.z, psi)
    P = O.locatenew("P", x * N.x + y * N.y)
    P.set_vel(N, u * B.x)
    definition = Definition(
        N,
        [x, y, psi],
        [u],
        bodies=[me.Particle("point", P, 1)],
        loads=[(P, a_x * B.x)],
        kinematic_equations=[
            x.diff() - u * sm.cos(psi),
            y.diff() - u * sm.sin(psi),
            psi.diff() - a_y / u,
        ],
    )
    return System(definition, initial_conditions={u: speed})


def friction_circle(largest):
    """The limit of the point mass's acceleration."""
    a_x, a_y = me.dynamicsymbols("a_x a_y")
    return [a_x**2 + a_y**2 <= largest**2]
