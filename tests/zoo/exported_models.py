"""Systems that are exported in tests."""

from __future__ import annotations

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.models import n_link_pendulum_on_cart
from pydy.solvers import Event
from pydy.system import System

TIMES = np.linspace(0.0, 2.0, num=41)


def pendulum():
    """Two links on a cart with a force on it; the energy and an acceleration are outputs."""
    system = n_link_pendulum_on_cart(2)
    system.constants = {"g": 9.81, "l0": 0.7}
    system.initial_conditions = {"q1": 0.4, "q2": -0.2, "u0": 0.1}
    system.specifieds = {"F": 0.5}
    system.outputs = {
        sm.Symbol("T"): system.kinetic_energy,
        sm.Symbol("a"): system.speeds[0].diff(),
    }
    system.times = TIMES
    system.ode_solver = "dop853"
    return system


def ball():
    """A ball that falls on the ground; returns the system and the event of its bounce."""
    y, v = me.dynamicsymbols("y v")
    m, g, e = sm.symbols("m g e")
    N, O, P = me.ReferenceFrame("N"), me.Point("O"), me.Point("P")
    O.set_vel(N, 0)
    P.set_pos(O, y * N.y)
    P.set_vel(N, v * N.y)
    kane = me.KanesMethod(N, [y], [v], kd_eqs=[v - y.diff()])
    kane.kanes_equations([me.Particle("ball", P, m)], [(P, -m * g * N.y)])
    system = System(kane, constants={m: 0.2, g: 9.81}, initial_conditions={y: 1.0}, times=TIMES)
    system.constants = {m: 0.2, g: 9.81, **({e: 0.8} if e in system.constants_symbols else {})}
    system.ode_solver = "dop853"
    bounce = Event(y, direction=-1, reset={v: -sm.Rational(4, 5) * v}, name="bounce")
    return system, bounce


def hostile():
    """A mass whose names try to end strings, comments, elements and scripts."""
    q, u = me.dynamicsymbols('q*/"; u')
    m = sm.Symbol("m</script><script>alert('1')</script>*/ // \\ \" ${x} `")
    k = sm.Symbol("k/*CODE*/{{APP}} ??/ <b>&amp;\u2028\ue000日本")
    N, O, P = me.ReferenceFrame("N"), me.Point("O"), me.Point("P")
    O.set_vel(N, 0)
    P.set_pos(O, q * N.x)
    P.set_vel(N, u * N.x)
    kane = me.KanesMethod(N, [q], [u], kd_eqs=[u - q.diff()])
    kane.kanes_equations([me.Particle("mass", P, m)], [(P, -k * q * N.x)])
    system = System(kane, constants={m: 2.0, k: 3.0}, initial_conditions={q: 1.0}, times=TIMES)
    system.ode_solver = "dop853"
    return system


def spring_of(*names):
    """A mass on springs, whose stiffnesses k, 2 k, … have the given names; x = 1 at the start."""
    x, v = me.dynamicsymbols("x v")
    N, O, P = me.ReferenceFrame("N"), me.Point("O"), me.Point("P")
    O.set_vel(N, 0)
    P.set_pos(O, x * N.x)
    P.set_vel(N, v * N.x)
    stiffness = sum(sm.Symbol(name) * (k + 1) for k, name in enumerate(names))
    kane = me.KanesMethod(N, [x], [v], kd_eqs=[v - x.diff()])
    kane.kanes_equations([me.Particle("mass", P, 1)], [(P, -stiffness * x * N.x)])
    return System(kane, initial_conditions={x: 1.0}, times=TIMES)


def kicked():
    """A mass of 2 kg at rest, which a force of 500 N pushes from t = t0 to t0 + w.

    Constants a and b switch nothing, by a t > b, while they are zero.
    """
    x, v, push = me.dynamicsymbols("x v F")
    t, t0, w, a, b = me.dynamicsymbols._t, *sm.symbols("t0 w a b")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    place = O.locatenew("P", x * N.x)
    bodies, loads = [me.Particle("mass", place, 2)], [(place, push * N.x)]
    system = System(Definition(N, [x], [v], bodies=bodies, loads=loads), times=[0.0, 20.0])
    never = sm.Piecewise((1, a * t > b), (0, True))
    pulse = sm.Piecewise((500, (t > t0) & (t < t0 + w)), (0, True))
    system.specifieds = {push: pulse + never}
    system.constants = {t0: 5.0, w: 0.01, a: 0.0, b: 0.0}
    return system


def kicked_at_an_input():
    """The same mass; when the force begins is an input D."""
    x, v, begin = me.dynamicsymbols("x v D")
    t, w = me.dynamicsymbols._t, sm.Symbol("w")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    place = O.locatenew("P", x * N.x)
    pulse = sm.Piecewise((500, (t > begin) & (t < begin + w)), (0, True))
    bodies, loads = [me.Particle("mass", place, 2)], [(place, pulse * N.x)]
    system = System(Definition(N, [x], [v], bodies=bodies, loads=loads), times=[0.0, 20.0])
    system.specifieds, system.constants = {begin: 5.0}, {w: 0.01}
    return system


def kicked_to(t, t0, w):
    """Its place and speed at a time after the push."""
    return 250 * w * (t - t0 - w / 2), 250 * w


def pulled_by_error_functions():
    """Two masses of 1 kg at x and y, with the forces erf(x) and erfc(y)."""
    x, y = me.dynamicsymbols("x y")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    points = [O.locatenew(f"P{k}", q * N.x) for k, q in enumerate((x, y))]
    masses = [me.Particle(f"mass {k}", P, 1) for k, P in enumerate(points)]
    loads = [(points[0], sm.erf(x) * N.x), (points[1], sm.erfc(y) * N.x)]
    return System(Definition(N, [x, y], bodies=masses, loads=loads))


def rope(start=0.0):
    """A ball that hangs at rest below a winch: its rope is 1 + b sin(w t) long."""
    x, y, vx, vy = me.dynamicsymbols("x y vx vy")
    t, (m, g, b, w) = me.dynamicsymbols._t, sm.symbols("m g b w")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    P = O.locatenew("P", x * N.x + y * N.y)
    P.set_vel(N, vx * N.x + vy * N.y)
    length = 1 + b * sm.sin(w * t)
    definition = Definition(
        N,
        [x, y],
        [vx, vy],
        bodies=[me.Particle("ball", P, m)],
        loads=[(P, -m * g * N.y)],
        holonomic_constraints=[x**2 + y**2 - length**2],
    )
    system = System(
        definition,
        constants={m: 1.0, g: 9.81, b: 0.2, w: 3.0},
        initial_conditions={y: -1.0},
        times=start + TIMES,
    )
    system.set_dependent_initial_conditions([y, vy])
    return system
