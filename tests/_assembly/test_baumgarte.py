"""constraints='baumgarte': residuals that die out, in every solver."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import odeint

import zoo
from pydy import System
from pydy._errors import PyDyUserWarning
from registry import SOLVER_NAMES, step_options
from zoo.cases import close, system_of, wide

SOLVERS = [odeint, *SOLVER_NAMES]


def at_times(model, end, num=31, solver=odeint, **options):
    return system_of(model, times=np.linspace(0.0, end, num=num), ode_solver=solver, **options)


def options_of(solver, tolerance=1e-9):
    return step_options(solver, tolerance, 2e-3)


@pytest.mark.parametrize("solver", SOLVERS)
def test_the_four_bar_drifts_less(solver):
    system = at_times(zoo.fourbar(), 30.0, 301, solver)
    loose = step_options(solver, 1e-5, 0.02)

    def worst(**options):
        x = system.integrate(**loose, **options)
        return np.abs(system.evaluate_holonomic_constraints(x, system.times)).max()

    free = worst()
    assert free > 2e-6
    assert worst(constraints="baumgarte", gain=5.0) < 0.05 * free


@pytest.mark.parametrize("solver", SOLVERS)
def test_consistent_motion_is_not_changed(solver):
    system = at_times(zoo.fourbar(), 1.0, 11, solver)
    options = options_of(solver, 1e-11)
    x = system.integrate(constraints="baumgarte", gain=3.0, **options)
    close(x, system.integrate(**options), 1e-7)


def test_a_holonomic_residual_dies_out_as_critically_damped():
    model, gain = zoo.fourbar(), 4.0
    system = at_times(model, 1.5, 16)
    system.initial_conditions[model.states[1]] += 1e-4
    x = system.integrate(constraints="baumgarte", gain=gain, rtol=1e-11, atol=1e-11)
    c = system.evaluate_holonomic_constraints(x, system.times)
    rates = system.evaluate_velocity_constraints(x[0], 0.0)
    # c'' + 2 g c' + g² c = 0 from c(0) and c'(0), the velocity residual
    t = system.times[:, None]
    expected = np.exp(-gain * t) * (c[0] + t * (rates + gain * c[0]))
    close(1e4 * c, 1e4 * expected, 1e-6)


@pytest.mark.parametrize("name", ["disc", "sleigh"])
def test_a_nonholonomic_residual_dies_out_exponentially(name):
    model, gain = zoo.MODELS[name](), 3.0
    system = at_times(model, 1.0, 11)
    dependent = model.states[-1]
    system.initial_conditions[dependent] += 0.01
    with pytest.warns(PyDyUserWarning, match="do not satisfy the constraints"):
        free = system.integrate(rtol=1e-11, atol=1e-11)
    held = system.integrate(constraints="baumgarte", gain=gain, rtol=1e-11, atol=1e-11)

    def residual(x):
        return system.evaluate_velocity_constraints(x, system.times)

    close(
        100 * residual(free),
        np.broadcast_to(100 * residual(free)[0], (11, 1 + (name == "disc"))),
        1e-6,
    )
    decay = np.exp(-2 * gain * system.times)[:, None]
    close(100 * residual(held), 100 * residual(held)[0] * decay, 1e-6)


@pytest.mark.parametrize("name", ["track", "track_reversed"])
def test_rows_may_come_in_any_order_and_length(name):
    model, gain = zoo.MODELS[name](), 2.0
    system = at_times(model, 1.0, 6)
    z = model.states[2]
    system.initial_conditions[z] += 1e-3
    x = system.integrate(constraints="baumgarte", gain=gain, rtol=1e-11, atol=1e-11)
    c = system.evaluate_holonomic_constraints(x, system.times)[:, 0]
    t = system.times
    close(1e3 * c, 1e3 * c[0] * np.exp(-gain * t) * (1 + gain * t), 1e-5)


def test_outputs_see_the_accelerations_with_the_stabilising_forces():
    a = zoo.sm.Symbol("a")
    model = zoo.sleigh()
    omega = model.kane.u[1]
    system = at_times(model, 1.0, 6, outputs={a: a - omega.diff(zoo.T)})
    system.initial_conditions[model.states[-1]] += 0.01
    x = system.integrate(constraints="baumgarte", gain=3.0, rtol=1e-11, atol=1e-11)
    k = list(system.states).index(omega)
    close(x[:, -1], x[:, k] - x[0, k], 1e-8)


def test_each_gain_has_its_own_equations():
    model = zoo.sleigh()
    system = at_times(model, 1.0, 6)
    system.initial_conditions[model.states[-1]] += 0.01
    first = system.integrate(constraints="baumgarte", gain=1.0)
    second = system.integrate(constraints="baumgarte", gain=5.0)
    assert np.abs(first - second).max() > 1e-4
    np.testing.assert_array_equal(system.integrate(constraints="baumgarte", gain=1.0), first)


def test_evaluations_are_those_of_the_plain_equations():
    model = zoo.sleigh()
    system = at_times(model, 1.0, 6)
    x = wide(system, model.sample()[0])
    before = system.evaluate_ode(x, 0.0)
    system.integrate(constraints="baumgarte", gain=1.0)
    np.testing.assert_array_equal(system.evaluate_ode(x, 0.0), before)


WRONG = [
    ({"constraints": "baumgarte"}, ValueError, "`gain` and `constraints='baumgarte'` belong tog"),
    ({"gain": 1.0}, ValueError, "`gain` and `constraints='baumgarte'` belong together"),
    ({"constraints": "baumgarte", "gain": 0.0}, ValueError, r"`gain` must be positive, got 0\.0"),
    ({"constraints": "baumgarte", "gain": -2}, ValueError, r"`gain` must be positive, got -2"),
    ({"constraints": "baumgarte", "gain": np.inf}, ValueError, "`gain` must be finite"),
    ({"constraints": "baumgarte", "gain": "much"}, (TypeError, ValueError), "`gain` must be"),
]


@pytest.mark.parametrize(("options", "kind", "message"), WRONG)
def test_a_wrong_gain_says_what_it_must_be(options, kind, message):
    with pytest.raises(kind, match=message):
        at_times(zoo.fourbar(), 1.0).integrate(**options)


@pytest.mark.parametrize("name", ["pendulum", "gyro"])
def test_velocity_constraints_are_needed(name):
    with pytest.raises(ValueError, match="works on velocity constraints, but the system has none"):
        at_times(zoo.MODELS[name](), 1.0).integrate(constraints="baumgarte", gain=1.0)


@pytest.mark.parametrize("unit", [1.0, 1e-14, 1e14])
def test_acceleration_constraints_of_another_scale_are_refused_in_any_unit(unit):
    x, y, v, w = me.dynamicsymbols("x y v w")
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, v * frame.x + w * frame.y)
    rate = unit * (w - 0.7 * v * sm.cos(x))
    own_rate = rate.diff(zoo.T).subs(x.diff(zoo.T), v)
    for factor, match in ((2, "the rates of the velocity constraints, in the same order"), (1, "")):
        kane = me.KanesMethod(
            frame,
            [x, y],
            [v],
            kd_eqs=[x.diff(zoo.T) - v, y.diff(zoo.T) - w],
            u_dependent=[w],
            velocity_constraints=[rate],
            acceleration_constraints=[factor * own_rate],
            bodies=[me.Particle("p", point, 1)],
            forcelist=[(point, -9.81 * frame.y)],
        )
        system = System(kane, times=np.linspace(0.0, 0.1, 3), initial_conditions={v: 1.0, w: 0.7})
        if match:
            with pytest.raises(ValueError, match=match):
                system.integrate(constraints="baumgarte", gain=1.0)
        else:
            motion = system.integrate(constraints="baumgarte", gain=1.0)
            close(motion[:, 3], 0.7 * motion[:, 2] * np.cos(motion[:, 0]), 1e-6)
