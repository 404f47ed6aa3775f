"""Resets of events of constrained systems: they keep the constraints, or are reported."""

import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.errors import IntegrationError, PyDyUserWarning
from pydy.mechanics import Definition
from pydy.solvers import Event
from pydy.system import System
from registry import has_fixed_step
from zoo import inertial_frame
from zoo.cases import close


def bob():
    """A pendulum in Cartesian coordinates, let go beside its pivot: it swings over x = -1/2."""
    frame, origin = inertial_frame()
    x, y, vx, vy = me.dynamicsymbols("x y vx vy")
    m, g, l = sm.symbols("m g l")
    end = origin.locatenew("P", x * frame.x + y * frame.y)
    definition = Definition(
        frame,
        [x, y],
        [vx, vy],
        bodies=[me.Particle("bob", end, m)],
        loads=[(end, -m * g * frame.y)],
        holonomic_constraints=[x**2 + y**2 - l**2],
    )
    system = System(definition, {g: 10.0}, times=np.linspace(0.0, 0.9, 10), ode_solver="dop853")
    system.initial_conditions = {x: 1.0}
    return system, (x, y, vx, vy)


def wall(x, reset):
    return Event(x + 0.5, direction=-1, reset=reset, name="wall")


SOLVERS = ["dop853", "radau", "rk4"]


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("method", ["integrate", "simulate"])
def test_a_reset_that_leaves_the_constraints_warns_with_residual_and_remedy(method, solver):
    system, (x, _, vx, _) = bob()
    system.ode_solver = solver
    system.times = system.times[:9]  # the motion it leads to soon comes to nothing
    message = r"reset of the event `wall` leaves .* velocity constraint 0.*dependent ones"
    with pytest.warns(PyDyUserWarning, match=message) as told:
        result = getattr(system, method)(
            events=[wall(x, {vx: -vx})], **({"step": 0.01} if has_fixed_step(solver) else {})
        )
    assert [str(w.message)[:9] for w in told].count("The reset") == 1
    if method == "integrate":
        assert result.shape == (9, 4)


def test_a_gradient_tells_it_and_refuses_a_motion_that_left_the_constraints():
    system, (x, _, vx, vy) = bob()
    system.times = system.times[:9]
    with pytest.warns(PyDyUserWarning, match="reset of the event `wall` leaves") as told:
        system.adjoint_gradient("l", final=x, events=[wall(x, {vx: -vx})])
    assert len(told) == 1
    system.adjoint_gradient("l", final=x, events=[wall(x, {vx: -vx, vy: -vy})])


@pytest.mark.parametrize("more", [{}, {"sensitivities": "l"}, {"reduce": "final"}])
def test_an_ensemble_tells_it_once(more):
    system, (x, _, vx, vy) = bob()
    system.times = system.times[:9]
    starts = {"initial_conditions": {"y": np.zeros(40)}, **more}
    message = r"In one sample or more, the reset of the event `wall` leaves .* velocity .* 0"
    with pytest.warns(PyDyUserWarning, match=message) as told:
        system.integrate_ensemble(events=[wall(x, {vx: -vx})], **starts)
    assert len(told) == 1
    system.integrate_ensemble(events=[wall(x, {vx: -vx, vy: -vy})], **starts)  # nothing is told
    system.integrate_ensemble(events=[wall(x, {vx: -vx})], constraints="baumgarte", gain=5.0)


def test_drift_that_a_reset_passes_on_is_not_its_own(recwarn):
    # At the bottom y' is drift alone, as is all of the residual x x' + y y'.
    system, (x, _, vx, vy) = bob()
    system.initial_conditions = {x: 0.6, "y": -0.8}
    back = Event(x, reset={vx: -0.8 * vx, vy: -0.8 * vy}, name="back")
    motion = system.simulate(events=[back], rtol=1e-10, atol=1e-10)
    assert [event.name for event in motion.events] == ["back"]
    assert not [w for w in recwarn if "reset" in str(w.message)]


def test_it_also_warns_where_the_motion_comes_to_nothing():
    system, (x, _, vx, _) = bob()
    system.times = np.linspace(0.0, 3.0, 31)
    with (
        pytest.warns(PyDyUserWarning, match="reset of the event `wall` leaves"),
        pytest.raises(IntegrationError),
    ):
        system.simulate(events=[wall(x, {vx: -vx})])


@pytest.mark.parametrize("solver", SOLVERS)
def test_projection_refuses_a_reset_that_leaves_the_constraints(solver):
    # It used to go on from there, with an energy that the first step decided.
    system, (x, _, vx, _) = bob()
    system.ode_solver = solver
    options = {"step": 0.01} if has_fixed_step(solver) else {}
    message = r"met the event `wall`, whose reset leaves the constraints \(the projection moved vy"
    with pytest.raises(IntegrationError, match=message) as caught:
        system.simulate(events=[wall(x, {vx: -vx})], constraints="project", **options)
    assert caught.value.info["status"].startswith("met the event `wall`")
    close(caught.value.state[system.states.index(x)], -0.5, 1e-2)


@pytest.mark.parametrize("constraints", [None, "project"])
@pytest.mark.parametrize("full_output", [False, True])
def test_a_reset_of_all_speeds_bounces_back(constraints, full_output):
    system, (x, _, vx, vy) = bob()
    event = wall(x, {vx: -0.5 * vx, vy: -0.5 * vy})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        result = system.integrate(events=[event], constraints=constraints, full_output=full_output)
    states = result[0] if full_output else result
    before, after = 0.0, 0.75 * -10.0 * np.sqrt(0.75)  # three quarters of the kinetic energy go
    energies = system.evaluate_energy(states, system.times).total
    close(energies[[0, -1]], [before, after], 1e-6)


def test_what_a_reset_rounds_off_is_brought_back():
    system, (x, _, vx, vy) = bob()
    event = wall(x, {vx: -vx * (1 + 1e-5), vy: -vy})
    run = system.simulate(events=[event], constraints="project")
    after = run.events[0].after
    assert np.abs(system.evaluate_velocity_constraints(after)).max() < 1e-14


def test_other_events_and_unconstrained_systems_are_not_looked_at():
    system, (x, *_) = bob()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        run = system.simulate(events=[Event(x + 0.5, name="passage")])
    assert len(run.events) >= 1


def cradle(gap):
    """Three equal balls on long strings, the first one drawn aside, which hit each other."""
    frame, origin = inertial_frame()
    x, v = me.dynamicsymbols("x1:4"), me.dynamicsymbols("v1:4")
    w = sm.Symbol("w")
    places = [origin.locatenew(f"P{k}", x[k] * frame.x) for k in range(3)]
    definition = Definition(
        frame,
        x,
        v,
        bodies=[me.Particle(f"ball{k}", place, 1) for k, place in enumerate(places)],
        loads=[(place, -(w**2) * x[k] * frame.x) for k, place in enumerate(places)],
    )
    system = System(definition, {w: 2 * np.pi}, ode_solver="dop853", times=np.linspace(0, 1, 101))
    system.initial_conditions = {x[0]: -1.0}
    hits = [
        Event(x[k + 1] - x[k] + k * gap, -1, reset={v[k]: v[k + 1], v[k + 1]: v[k]}, name=f"hit{k}")
        for k in (0, 1)
    ]
    return system, hits


@pytest.mark.parametrize("many", [False, True])
def test_an_event_at_zero_that_a_reset_sets_going_is_told_of(many):
    """The third ball touches the second, which went through it without a word."""
    system, hits = cradle(0.0)
    run = system.integrate_ensemble if many else system.simulate
    more = {"constants": {"w": [2 * np.pi] * 9}} if many else {}
    with pytest.warns(PyDyUserWarning, match=r"At t = 0.25 .*`hit1` was zero .*`hit0` sent it bel"):
        run(events=hits, **more)


def test_balls_with_a_small_gap_hand_the_blow_on():
    system, hits = cradle(1e-9)
    motion = system.simulate(events=hits, rtol=1e-12, atol=1e-14)
    swing = np.sin(2 * np.pi * (system.times - 0.25))
    late = system.times > 0.25
    np.testing.assert_allclose(motion["x1"][~late], swing[~late], atol=1e-8)
    until = late & (system.times < 0.75)
    np.testing.assert_allclose(motion["x3"][until], swing[until], atol=1e-8)
    np.testing.assert_allclose(motion["x2"], 0.0, atol=1e-8)


def test_an_event_at_zero_that_a_reset_sends_the_other_way_is_not_told_of(recwarn):
    """A ball at rest on the floor is kicked upwards, and comes down after a second."""
    frame, origin = inertial_frame()
    y, v, clock = me.dynamicsymbols("y v clock")
    place = origin.locatenew("P", y * frame.y)
    definition = Definition(
        frame,
        [y, clock],
        [v],
        bodies=[me.Particle("ball", place, 1)],
        loads=[(place, sm.Piecewise((-10.0, y > 0), (0, True)) * frame.y)],
        kinematic_equations=[y.diff() - v, clock.diff() - 1],
    )
    system = System(definition, ode_solver="dop853", times=np.linspace(0.0, 3.0, 4))
    kick = Event(clock - 0.5, reset={v: 5.0}, name="kick")
    landing = Event(y, direction=-1, terminal=True, name="landing")
    motion = system.simulate(events=[kick, landing])
    assert motion.events[-1].name == "landing"
    assert motion.events[-1].time == pytest.approx(1.5, abs=1e-6)
    assert not recwarn
