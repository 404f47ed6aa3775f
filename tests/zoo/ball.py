"""A ball that bounces: what is known of it by hand stands in the tests."""

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.solvers import Event
from pydy.system import System
from zoo import inertial_frame

__all__ = ["bouncing_ball"]


def bouncing_ball(reset=None, **numbers):
    """A ball above a floor of height d, thrown upwards, with restitution e; and its bounce."""
    q, u = me.dynamicsymbols("q, u")
    m, g = sm.symbols("m, g")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", q * frame.y)
    point.set_vel(frame, u * frame.y)
    kane = me.KanesMethod(
        frame,
        q_ind=[q],
        u_ind=[u],
        kd_eqs=[q.diff() - u],
        bodies=[me.Particle("ball", point, m)],
        forcelist=[(point, -m * g * frame.y)],
    )
    d, e = sm.symbols("d, e")
    system = System(kane, outputs={sm.Symbol("used"): e * d}, ode_solver="dop853")
    system.constants = {"g": 9.81, "e": 0.8, "d": 0.1, **numbers}
    system.initial_conditions, system.times = {"q": 1.0, "u": 0.5}, np.linspace(0.0, 2.0, 9)
    bounce = Event(
        q - d, direction=-1, reset={u: -e * u} if reset is None else reset, name="bounce"
    )
    return system, bounce
