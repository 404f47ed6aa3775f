"""Optimal control problems with known answers, as Systems.

A particle's law of motion stands for any ordinary differential equations: kinematic equations may
hold anything, and so may its loads.
"""

import sys
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.optimize import brentq

from pydy import System
from pydy.control import OptimalControl
from pydy.mechanics import Definition

sys.path.append(str(Path(__file__).parents[2] / "benchmarks"))
from harness import standing

from zoo import inertial_frame

T = me.dynamicsymbols._t
TF = sm.Symbol("tf")


def installed(name):
    missing = find_spec(name) is None
    return pytest.param(name, marks=pytest.mark.skipif(missing, reason=f"needs {name}"))


SOLVERS = [installed("cyipopt"), installed("pounce")]  # beside IPOPT


def first_order(coordinates, speed, force, mass=1, kinematics=None, constants=None):
    """Return a System of some coordinates and one particle with a speed along x."""
    ground = me.ReferenceFrame("N")
    point = me.Point("P")
    point.set_vel(ground, speed * ground.x)
    definition = Definition(
        ground,
        coordinates,
        [speed],
        bodies=[me.Particle("mass", point, mass)],
        loads=[(point, force * ground.x)],
        kinematic_equations=kinematics,
    )
    return System(definition, constants or {})


def double_integrator(mass=1):
    """Return x'' = F / m and its symbols x, v, F."""
    x, v, F = me.dynamicsymbols("x v F")
    return first_order([x], v, F, mass), (x, v, F)


def brachistochrone():
    """Return a bead that falls along a wire of free angle, with x, y, v, θ; Bryson and Ho, 2.7."""
    x, y, v, angle = me.dynamicsymbols("x y v angle")
    g = sm.Symbol("g")
    kinematics = [x.diff() - v * sm.sin(angle), y.diff() - v * sm.cos(angle)]
    made = first_order([x, y], v, g * sm.cos(angle), 1, kinematics, {g: 9.81})
    return made, (x, y, v, angle)


def cycloid_time(x, y, g):
    """Return the time along the cycloid (Johann Bernoulli 1697): r (a − sin a), r (1 − cos a)."""
    a = brentq(lambda a: (a - np.sin(a)) / (1 - np.cos(a)) - x / y, 0.1, 6.2)
    return a * np.sqrt(y / (1 - np.cos(a)) / g)


def hypersensitive():
    """Return x' = −x³ + u, with x, u; its integral is a further state."""
    position, x, u = me.dynamicsymbols("position x u")
    return first_order([position], x, -(x**3) + u), (x, u)


def goddard():
    """Return the rocket of COPS with h, m, v and the thrust.

    The momentum of what has a changing mass m changes by m' v too, which is no force here.
    """
    h, m, v, thrust = me.dynamicsymbols("h m v thrust")
    drag = 310 * v**2 * sm.exp(-500 * (h - 1))
    flow = thrust / sm.Rational(1, 2)
    kinematics = [h.diff() - v, m.diff() + flow]
    made = first_order([h, m], v, thrust - drag - m / h**2 - flow * v, m, kinematics)
    return made, (h, m, v, thrust)


def robot_arm():
    """Return the arm of COPS with ρ, θ, φ, their rates and the controls."""
    rho, theta, phi, a, b, c, *controls = me.dynamicsymbols("rho theta phi a b c u1:4")
    length = 5
    inertia = ((length - rho) ** 3 + rho**3) / 3
    kinematics = [
        rho.diff() - a,
        theta.diff() - b,
        phi.diff() - c,
        a.diff() - controls[0] / length,
        b.diff() - controls[1] / (inertia * sm.sin(phi) ** 2),
    ]
    made = first_order([rho, theta, phi, a, b], c, controls[2] / inertia, 1, kinematics)
    return made, (rho, theta, phi, a, b, c, *controls)


def cart_pole():
    """Return Kelly's cart-pole with q1, q2 (from hanging), u1, u2 and the force F."""
    q1, q2, u1, u2, F = me.dynamicsymbols("q1 q2 u1 u2 F")
    m1, m2, l, g = sm.symbols("m1 m2 l g")
    ground, rest = inertial_frame()
    cart = rest.locatenew("C", q1 * ground.x)
    cart.set_vel(ground, u1 * ground.x)
    rod = me.ReferenceFrame("A")
    rod.orient_axis(ground, q2, ground.z)
    rod.set_ang_vel(ground, u2 * ground.z)
    bob = cart.locatenew("B", -l * rod.y)
    bob.v2pt_theory(cart, ground, rod)
    bodies = [me.Particle("cart", cart, m1), me.Particle("bob", bob, m2)]
    loads = [(cart, F * ground.x), (bob, -m2 * g * ground.y)]
    definition = Definition(ground, [q1, q2], [u1, u2], bodies=bodies, loads=loads)
    return System(definition, {m1: 1.0, m2: 0.3, l: 0.5, g: 9.81}), (q1, q2, u1, u2, F)


def kelly(**options):
    """Return the cart-pole's swing-up by Kelly and its force; the optimum is 58.80766746.

    M. Kelly, An introduction to trajectory optimization, SIAM Rev. 59 (2017), 6 and appendix E; the
    value to ten digits is that of Dymos' benchmark.
    """
    system, (q1, q2, u1, u2, F) = cart_pole()
    end = {q1: 1.0, q2: np.pi, u1: 0.0, u2: 0.0}
    bounds = {F: (-20.0, 20.0), q1: (-2.0, 2.0)}
    effort = sm.Integral(F**2, T)
    return OptimalControl(system, effort, 2.0, end=end, bounds=bounds, **options), F


def standing_person():
    """Return the person of `harness.standing`, and the symbols of states, gains and torques.

    The torques are specifieds that feed all states back.
    """
    states, gains = standing.STATES, standing.gains
    torques = me.dynamicsymbols("T_ankle T_hip")
    ground, bodies, loads = standing.person(torques)
    system = System(Definition(ground, states[:2], states[2:], bodies=bodies, loads=loads))
    feedback = -(sm.Matrix(2, 4, gains) * sm.Matrix(states))
    system.specifieds = {
        standing.ACCELERATION: standing.accelerations(T, sm.sin),
        **dict(zip(torques, feedback, strict=True)),
    }
    return system, (states, gains, torques)
