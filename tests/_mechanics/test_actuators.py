"""Actuators of SymPy along every kind of pathway, against SymPy's own equations in 30 digits."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics.biomechanics import (
    FirstOrderActivationDeGroote2016,
    MusculotendonDeGroote2016,
)
from sympy.physics.biomechanics.musculotendon import MusculotendonFormulation

from oracles.oracle import Oracle
from pydy._errors import PyDyUserWarning
from pydy._mechanics.reader import read_loads
from pydy.mechanics import Definition
from pydy.system import System
from zoo import Model, T, _numbers, inertial_frame
from zoo.by_hand import derived
from zoo.cases import close


def _arm():
    """A rod about a vertical axis; returns what a test needs to pull at it."""
    frame, origin = inertial_frame()
    q, u = me.dynamicsymbols("q u")
    arm = me.ReferenceFrame("A")
    arm.orient_axis(frame, frame.z, q)
    arm.set_ang_vel(frame, u * frame.z)
    return frame, origin, arm, q, u


def _model(frame, origin, arm, q, u, load, numbers, inputs=None):
    m, l, g, size = sm.symbols("m l g I")
    centre = origin.locatenew("C", l * arm.x)
    centre.v2pt_theory(origin, frame, arm)
    body = me.RigidBody("arm", centre, arm, m, (me.inertia(arm, 0, 0, size), centre))
    loads = [load, (centre, -m * g * frame.y)]
    kane = me.KanesMethod(frame, [q], [u], kd_eqs=[q.diff(T) - u], bodies=[body], forcelist=loads)
    return Model(kane, _numbers(m, l, g, size) | numbers, inputs or {})


def _muscle(formulation):
    frame, origin, arm, q, u = _arm()
    wrist, shoulder = origin.locatenew("W", 0.3 * arm.x), origin.locatenew("S", 0.5 * frame.y)
    wrist.v2pt_theory(origin, frame, arm)
    shoulder.set_vel(frame, 0)
    muscle = MusculotendonDeGroote2016.with_defaults(
        "biceps",
        me.LinearPathway(wrist, shoulder),
        FirstOrderActivationDeGroote2016("biceps"),
        musculotendon_dynamics=formulation,
        tendon_slack_length=sm.Rational(1, 10),
        peak_isometric_force=sm.Integer(30),
        optimal_fiber_length=sm.Rational(2, 5),
        maximal_fiber_velocity=sm.Integer(10),
        optimal_pennation_angle=sm.Rational(1, 10),
        fiber_damping_coefficient=sm.Rational(1, 10),
    )
    inputs = {s: 0.4 + 0.2 * k for k, s in enumerate(muscle.x)}
    return _model(frame, origin, arm, q, u, muscle, {}, inputs)


def _wrapped():
    """A spring that wraps a cylinder, from the ground to the arm."""
    frame, origin, arm, q, u = _arm()
    r, k, free = sm.symbols("r k L", positive=True)
    start, end = me.Point("E"), me.Point("F")
    start.set_pos(origin, r * frame.x)
    start.set_vel(frame, 0)
    end.set_pos(origin, r * sm.cos(q) * frame.x + r * sm.sin(q) * frame.y)
    end.set_vel(frame, r * u * (sm.cos(q) * frame.y - sm.sin(q) * frame.x))
    path = me.WrappingPathway(start, end, me.WrappingCylinder(r, origin, frame.z))
    spring = me.ForceActuator(k * (path.length - free), path)
    return _model(frame, origin, arm, q, u, spring, _numbers(r, k, free))


def _over_an_obstacle():
    frame, origin, arm, q, u = _arm()
    k = sm.Symbol("k")
    tip, peg = origin.locatenew("F", 0.8 * arm.x), origin.locatenew("K", frame.x + frame.y)
    tip.v2pt_theory(origin, frame, arm)
    peg.set_vel(frame, 0)
    wall = origin.locatenew("L", 2 * frame.x)
    wall.set_vel(frame, 0)
    pull = me.ForceActuator(k * q * u, me.ObstacleSetPathway(tip, peg, wall))
    return _model(frame, origin, arm, q, u, pull, _numbers(k))


ACTUATORS = {
    "a muscle with a rigid tendon": lambda: _muscle(MusculotendonFormulation.RIGID_TENDON),
    "a muscle with a tendon": lambda: _muscle(MusculotendonFormulation.FIBER_LENGTH_EXPLICIT),
    "around a cylinder": _wrapped,
    "over an obstacle": _over_an_obstacle,
}


@pytest.mark.parametrize("name", ACTUATORS)
def test_actuators_pull_as_sympys_equations_say(name):
    model = ACTUATORS[name]()
    systems = [System(model.kane, equations="graph")]
    oracle = Oracle(derived(model))
    systems.append(System(model.kane, equations="method"))
    for system in systems:
        system.constants = dict(model.constants)
        system.specifieds = {s: model.specifieds[s] for s in system.specifieds_symbols}
        for seed in (1, 2):
            x = np.random.default_rng(seed).uniform(0.3, 0.9, 2)
            close(system.evaluate_ode(x, 0.4), oracle.xdot(x, 0.4), 1e-11)


@pytest.mark.parametrize("number", [0, 1, 2])
def test_states_of_muscles_are_coordinates_whose_rates_muscles_know(number):
    formulation = MusculotendonFormulation(number)
    frame, origin, _, q, u = _arm()
    load = origin.locatenew("P", q * frame.x)
    muscle = MusculotendonDeGroote2016.with_defaults(
        "calf",
        me.LinearPathway(origin, load),
        FirstOrderActivationDeGroote2016.with_defaults("calf"),
        musculotendon_dynamics=formulation,
        tendon_slack_length=sm.Rational(1, 5),
        peak_isometric_force=sm.Integer(900),
        optimal_fiber_length=sm.Rational(1, 10),
    )
    rates = [*muscle.x.diff(T) - muscle.rhs()]
    body = me.Particle("load", load, 2)
    definition = Definition(
        frame,
        [q, *muscle.x],
        [u],
        bodies=[body],
        loads=[muscle],
        kinematic_equations=[q.diff(T) - u, *rates],
    )
    system = System(definition, specifieds={muscle.r[0]: 0.7})
    x = [0.31, *[1.02, 0.4][-len(muscle.x) :], 0.03]
    values = dict(zip(system.states, x, strict=True)) | {muscle.r[0]: 0.7}
    known = sm.Matrix([muscle.force / 2, *muscle.rhs()]).subs(q.diff(T), u).doit()
    pull, *changes = [float(e.subs(values).doit()) for e in known]
    close(system.evaluate_ode(x, 0.0), [0.03, *changes, pull], 1e-11)


def test_the_rate_of_a_dampers_length_is_not_differentiated_as_a_root(monkeypatch):
    """A damper between two arms of three joints each took half a minute; its force is the same."""
    c, *q = sm.symbols("c"), *me.dynamicsymbols("q:4")
    frame, origin, hands = me.ReferenceFrame("N"), me.Point("O"), []
    for first, second in (q[:2], q[2:]):
        upper, lower = me.ReferenceFrame("A"), me.ReferenceFrame("B")
        upper.orient_axis(frame, frame.z, first)
        lower.orient_axis(upper, upper.x, second)
        hands.append(origin.locatenew("H", upper.x + lower.y / 3 + first * frame.y))
    damper = me.LinearDamper(c, me.LinearPathway(*hands))
    speed = damper.pathway.extension_velocity
    monkeypatch.setattr(me.LinearPathway, "extension_velocity", None)
    (start, pull), (end, push) = read_loads([damper])
    assert [start, end] == hands
    way = hands[1].pos_from(hands[0])
    values = {s.diff(T): 1.1 - 0.3 * k for k, s in enumerate(q)}
    numbers = {c: 0.7} | {s: 0.3 + 0.2 * k for k, s in enumerate(q)}
    along = (pull.dot(way), push.dot(way), c * speed * damper.pathway.length)
    pulled, pushed, wanted = (float(e.xreplace(values).xreplace(numbers)) for e in along)
    assert pulled == pytest.approx(wanted, rel=1e-12)
    assert pushed == -pulled


@pytest.mark.parametrize("place", [-0.4, 0.0, 0.4])
def test_a_damper_along_one_axis_passes_the_length_zero(place):
    frame, (start, end) = me.ReferenceFrame("N"), (me.Point("P"), me.Point("Q"))
    q = me.dynamicsymbols("q")
    end.set_pos(start, q * frame.x)
    (_, pull), _ = read_loads([me.LinearDamper(3, me.LinearPathway(start, end))])
    assert pull.dot(frame.x).subs(q.diff(T), 2).subs(q, place) == 6


@pytest.mark.parametrize("kind", [me.LinearSpring, me.LinearDamper])
@pytest.mark.parametrize("linear", [True, False])
def test_springs_and_dampers_that_push_where_they_should_pull_say_so(kind, linear):
    """SymPy's forces along wrapping pathways have the other sign; the power tells."""
    frame, origin, arm, q, u = _arm()
    start, end = origin.locatenew("E", 2 * frame.x), origin.locatenew("F", 2 * arm.x)
    path = me.LinearPathway(start, end)
    if not linear:
        path = me.WrappingPathway(start, end, me.WrappingCylinder(2, origin, frame.z))
    actuator = kind(3, path)
    values = {q.diff(T): 0.3, u: 0.3, q: 0.4}

    def power(loads):
        rate = 2 * q.diff(T) * arm.y  # of F
        gained = sum(vector.dot(rate) for point, vector in loads if point is end)
        wanted = actuator.force * path.length.diff(T)
        return [float(e.doit().subs(values)) for e in (gained, wanted)]

    if linear:
        gained, wanted = power(read_loads([actuator]))
    else:
        with pytest.warns(PyDyUserWarning, match=f"A {kind.__name__} along a WrappingPathway"):
            gained, wanted = power(read_loads([actuator]))
        assert gained == pytest.approx(-wanted, rel=1e-12)
        gained, wanted = power(read_loads([me.ForceActuator(-actuator.force, path)]))
    assert wanted < 0  # it is stretched
    assert gained == pytest.approx(wanted, rel=1e-12)
