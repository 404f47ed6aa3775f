"""A particle on a circle, whose constraints tie coordinates and speeds of any unit of time."""

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from zoo import inertial_frame


def on_a_circle(angle, speed):
    """A particle on a circle of one metre, whose y and v follow from x and u."""
    x, y, u, v = me.dynamicsymbols("x y u v")
    frame, origin = inertial_frame()
    bob = me.Particle("bob", origin.locatenew("P", x * frame.x + y * frame.y), sm.Symbol("m"))
    place = {x: np.cos(angle), y: np.sin(angle)}
    equations = Definition(
        frame, [x, y], [u, v], bodies=[bob], kinematic_equations=[x.diff() - u, y.diff() - v],
        holonomic_constraints=[x**2 + y**2 - 1], configuration={x: 0.8, y: 0.6},
    )  # fmt: skip
    system = System(equations, ode_solver="dop853", times=[0.0, 1e-3 / speed])
    system.initial_conditions = {**place, u: -speed * place[y], v: speed * place[x]}
    system.set_dependent_initial_conditions([y, v])
    return system
