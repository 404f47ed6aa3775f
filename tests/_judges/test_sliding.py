"""Motions that stay at a jump of the loads: the jump is named, early and in the error."""

import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._judges import stuck_at
from pydy.errors import IntegrationError, PyDyUserWarning
from pydy.mechanics import Definition
from pydy.system import System

X, V = me.dynamicsymbols("x v")
N, O = me.ReferenceFrame("N"), me.Point("O")
O.set_vel(N, 0)


def block(load, unit=1.0, **more):
    """A block on a spring; lengths are in units of so many metres."""
    point = O.locatenew("P", X * N.x)
    particle = me.Particle("p", point, 1)
    model = Definition(N, [X], [V], bodies=[particle], loads=[(point, load * N.x)])
    times = np.linspace(0.0, 4 * np.pi, num=101)
    return System(model, initial_conditions={X: 5.5 / unit}, times=times, **more)


def coulomb(unit=1.0, **more):
    # it sticks at |x| < 0.981 m
    return block(-X - sm.Float(0.981 / unit) * sm.sign(V), unit, **more)


STICKS = r"the load on v\(t\) jumps where `v\(t\)` passes zero, and both sides drive"


@pytest.mark.parametrize("unit", [1.0, 1e-9, 1e9])
@pytest.mark.parametrize("solver", ["odeint", "dop853", "radau", "tsit5"])
def test_dry_friction_that_holds_a_block_is_named(solver, unit):
    system = coulomb(unit, ode_solver=solver)
    options = {} if solver == "odeint" else {"max_steps": 20_000}
    with pytest.raises(IntegrationError, match=STICKS) as told:
        system.integrate(rtol=1e-8, atol=1e-8 / unit, **options)
    assert 3 * np.pi - 0.01 < told.value.time < 3 * np.pi + 0.01  # three half-cycles
    for advice in ("mxstep", "max_steps`, loosen", "dop853'"):
        assert advice not in str(told.value)


def test_it_is_named_before_all_steps_are_taken():
    system = coulomb(ode_solver="dop853")
    with pytest.warns(PyDyUserWarning, match=rf"more than 100000 steps .* {STICKS}"):  # noqa: SIM117
        with pytest.raises(IntegrationError, match=STICKS):
            system.integrate(max_steps=400_000)


def test_the_same_is_told_backward():
    # backward in time, driving friction is what holds
    system = block(-X + sm.Float(0.981) * sm.sign(V), ode_solver="dop853")
    system.times = -system.times
    with pytest.raises(IntegrationError, match=STICKS):
        system.integrate(max_steps=20_000)


def test_jumps_that_are_passed_are_not_blamed():
    """Without friction enough to hold it, the block passes v = 0 in each half-cycle."""
    system = block(-X - sm.sign(V) / 1000, ode_solver="dop853")
    with pytest.raises(IntegrationError, match="Raise `max_steps`"):
        system.integrate(max_steps=50)
    system.ode_solver = "odeint"
    with pytest.raises(IntegrationError, match="Raise `mxstep`"):
        system.integrate(mxstep=3)


def test_many_steps_alone_are_no_cause_for_a_warning():
    system = block(-X, ode_solver="dop853")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        system.integrate(max_step=1e-4)


def test_a_jump_in_a_condition_on_several_states_is_described():
    system = block(-10 * sm.sign(V + X), ode_solver="dop853")
    with pytest.raises(IntegrationError, match=r"jumps where a condition on x\(t\), v\(t\) turns"):
        system.integrate(max_steps=20_000)


@pytest.mark.parametrize("first", [0, 1])
def test_of_two_jumps_the_one_that_is_reached_first_is_named(first):
    """Two blocks on the plane slow down by 1 and 2 m/s²; one of them stops after 1 ns."""
    y, w = me.dynamicsymbols("y w")
    points = O.locatenew("P", X * N.x), O.locatenew("Q", y * N.x)
    loads = [(points[0], -sm.sign(V) * N.x), (points[1], -2 * sm.sign(w) * N.x)]
    bodies = [me.Particle(point.name, point, 1) for point in points]
    problem = System(Definition(N, [X, y], [V, w], bodies=bodies, loads=loads))._now()
    speeds = [1e-9, 2e-8] if first == 0 else [1e-8, 2e-9]
    state = np.array([[0.0, 0.0, *speeds]])
    name, rates = (("v", "-1 and 1"), ("w", "-2 and 2"))[first]
    told = stuck_at(problem.at(np.zeros(1), state), 1.0)
    assert f"the load on {name}(t) jumps where `{name}(t)` passes zero" in told
    assert f"(at {rates} a second)" in told
    # At a thousand times the speed the stop is not at this time, to six digits of the span.
    assert stuck_at(problem.at(np.zeros(1), 1e3 * state), 1e-6) is None


@pytest.mark.parametrize("solver", ["odeint", "dop853", "radau"])
def test_an_input_that_draws_random_numbers_is_named(solver):
    f = me.dynamicsymbols("f")
    noise = np.random.default_rng(0)
    system = block(f, specifieds={f: lambda x, t: -1e3 * x[0] + noise.normal()}, ode_solver=solver)
    options = {} if solver == "odeint" else {"max_steps": 2_000}
    with pytest.raises(IntegrationError, match=r"for `f\(t\)` has several values at one time") as e:
        system.integrate(**options)
    assert "Draw random numbers before" in str(e.value)
