"""A bead on a turning hoop, which leaves the bottom where the hoop turns fast enough."""

import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.system import System

__all__ = ["bead_on_a_hoop"]


def bead_on_a_hoop():
    """A bead on a hoop that turns about its vertical diameter at a prescribed rate."""
    angle, speed, turn = me.dynamicsymbols("theta omega Omega")
    m, r, g = sm.symbols("m r g")
    ground, hoop, radius = (me.ReferenceFrame(name) for name in "NHR")
    hoop.orient_axis(ground, ground.z, 0)
    hoop.set_ang_vel(ground, turn * ground.z)
    radius.orient_axis(hoop, hoop.x, angle)
    radius.set_ang_vel(hoop, speed * hoop.x)
    origin = me.Point("O")
    origin.set_vel(ground, 0)
    bead = origin.locatenew("P", -r * radius.z)
    bead.v2pt_theory(origin, ground, radius)
    kane = me.KanesMethod(ground, [angle], [speed], [angle.diff(zoo.T) - speed])
    kane.kanes_equations([me.Particle("P", bead, m)], [(bead, -m * g * ground.z)])
    return System(kane, constants={m: 0.3, r: 0.5, g: 9.81}), angle, turn
