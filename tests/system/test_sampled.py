"""Sampled data as specifieds of a System, in evaluations and in every solver."""

from contextlib import nullcontext

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import quad
from scipy.linalg import expm

import zoo
from oracles.oracle import oracle
from pydy.errors import PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.models import multi_mass_spring_damper
from registry import ADAPTIVE_NAMES, SOLVER_NAMES, step_options
from zoo.cases import Recorder, close, system_of

T = zoo.T
F, T1, T2 = me.dynamicsymbols("F T1 T2")
KINDS = ["linear", "previous", "pchip"]
GENERATORS = ["llvm", "lambdify", "cython"]
TIMES = np.array([0.0, 0.6, 1.0, 2.1])
VALUES = np.array([[0.3, 1.0], [1.2, -1.0], [-0.4, 0.2], [0.8, 0.9]])
TIGHT = {"rtol": 1e-11, "atol": 1e-11}


def sampled(kind="linear"):
    return SampledInput(TIMES, VALUES, kind)


def both(kind="linear"):
    """T2 and F from samples, T1 a number."""
    return {(T2, F): sampled(kind), T1: 0.5}


def numbers_at(t, kind="linear"):
    t2, f = sampled(kind)(t)
    return {F: f, T1: 0.5, T2: t2}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("generator", GENERATORS)
def test_samples_give_their_values_at_every_time(generator, kind):
    system = system_of(zoo.pendulum(), specifieds=both(kind))
    system.generate_ode_function(generator=generator)
    x, _ = zoo.pendulum().sample(1)
    for t in (0.0, 0.3, 0.6, 1.7, 2.1):
        expected = oracle(zoo.pendulum()).xdot(x, t, numbers_at(t, kind))
        close(system.evaluate_ode(x, t), expected)


FORMATS = {
    "one by one": {
        F: SampledInput(TIMES, VALUES[:, 1]),
        T2: SampledInput(TIMES, VALUES[:, :1]),
        T1: 0.5,
    },
    "format 2": {
        "symbols": (T1, T2, F),
        "values": SampledInput(TIMES, np.column_stack([np.full(4, 0.5), VALUES])),
    },
    "beside a function": {(T2, F): sampled(), T1: lambda x, t: 0.5},
    "beside an expression": {(T2, F): sampled(), T1: sm.cos(T) ** 2 / 2 + sm.sin(T) ** 2 / 2},
    "inside an expression": {
        me.dynamicsymbols("e"): SampledInput(TIMES, VALUES[:, 1] / 2),
        F: 2 * me.dynamicsymbols("e"),
        T2: SampledInput(TIMES, VALUES[:, 0]),
        T1: 0.5,
    },
}


@pytest.mark.parametrize("name", FORMATS)
def test_every_format_takes_samples(name):
    system = system_of(zoo.pendulum(), specifieds=FORMATS[name])
    x, t = zoo.pendulum().sample(1, 6)
    expected = [oracle(zoo.pendulum()).xdot(a, b, numbers_at(b)) for a, b in zip(x, t, strict=True)]
    close(system.evaluate_ode(x, t), expected)
    close(system.evaluate_ode(x[0], t[0]), expected[0])


@pytest.mark.parametrize("kind", KINDS)
def test_samples_and_the_same_as_a_function_integrate_alike(kind):
    times = np.linspace(0.0, 2.1, 8)
    a = system_of(zoo.pendulum(), specifieds=both(kind), times=times)
    values = {(T2, F): lambda x, t: sampled(kind)(t), T1: 0.5}
    b = system_of(zoo.pendulum(), specifieds=values, times=times)
    close(a.integrate(rtol=1e-9, atol=1e-9), b.integrate(rtol=1e-9, atol=1e-9), 1e-12)


def free_mass(value, times):
    """m v' = f alone: the spring and the damper are zero."""
    system = multi_mass_spring_damper(1, apply_external_forces=True)
    c, k, m = system.constants_symbols
    (force,) = system.specifieds_symbols
    system.constants = {c: 0.0, k: 0.0, m: 2.0}
    system.specifieds = {force: value}
    system.times = times
    return system


def test_a_ramp_moves_a_mass_along_a_cubic():
    times = np.linspace(0.0, 3.0, 7)
    system = free_mass(SampledInput([0.0, 3.0], [0.0, 6.0]), times)
    close(system.integrate(**TIGHT)[:, 0], 2 * times**3 / 12, 1e-9)


def test_a_staircase_adds_up_its_steps():
    times = np.array([0.0, 1.0, 2.0, 3.0])
    system = free_mass(SampledInput(times, [1.0, -3.0, 0.5, 9.0], "previous"), times)
    states = system.integrate(hmax=0.01, **TIGHT)
    close(states[:, 1], np.array([0.0, 1.0, -2.0, -1.5]) / 2.0, 1e-6)


def held_spring(t, breaks, values):
    """The states of x'' = f − x from rest, for an f that is held between breaks."""
    x, v = 0.0, 0.0
    for start, end, f in zip(breaks, breaks[1:], values, strict=False):
        h = max(0.0, min(end, t) - start)
        c, s = np.cos(h), np.sin(h)
        x, v = f + (x - f) * c + v * s, (f - x) * s + v * c
    return [x, v]


@pytest.mark.parametrize("start", [0.0, 1.7e9])  # the latter is a Unix time
@pytest.mark.parametrize("solver", ["dop853", "tsit5", "radau", "rk4"])
def test_steps_end_where_an_input_jumps(solver, start):
    system = multi_mass_spring_damper(1, apply_external_forces=True)
    c, k, m = system.constants_symbols
    system.constants = {c: 0.0, k: 1.0, m: 1.0}
    breaks, values = start + np.array([0.0, 0.37, 1.1, 1.9, 3.0]), [1.0, -2.0, 0.5, 3.0, 3.0]
    (force,) = system.specifieds_symbols
    system.specifieds = {force: SampledInput(breaks, values, "previous")}
    system.times = start + np.linspace(0.0, 3.0, 31)
    system.ode_solver = solver
    options = step_options(solver, 1e-10, 0.01)
    motion = system.simulate(**options)
    close(motion.states, np.array([held_spring(t, breaks, values) for t in motion.times]), 2e-9)
    between = motion.at(start + np.linspace(0.0, 3.0, 977))
    close(between.states, np.array([held_spring(t, breaks, values) for t in between.times]), 2e-9)
    assert motion.statistics["rejected"] <= 3  # error control alone rejects nine at each jump


def test_pchip_adds_up_to_its_integral():
    samples = SampledInput(TIMES, VALUES[:, 0], "pchip")
    system = free_mass(samples, TIMES)
    expected = [quad(samples, 0.0, t, points=TIMES[1:3], epsabs=1e-12)[0] / 2.0 for t in TIMES]
    close(system.integrate(hmax=0.01, **TIGHT)[:, 1], expected, 1e-8)


def test_a_solver_may_step_past_the_end():
    system = system_of(zoo.pendulum(), specifieds=both(), times=[0.0, 2.1])
    system.ode_solver = recorder = Recorder()
    system.integrate()
    x, _ = zoo.pendulum().sample(1)
    expected = oracle(zoo.pendulum()).xdot(x, 9.0, numbers_at(2.1))
    close(recorder.f(x, 9.0, *recorder.args), expected)


def heights(samples):
    """A sampled height with the constant derivatives that belong to it."""
    s = me.dynamicsymbols("s")
    return {s: samples, s.diff(zoo.T): lambda x, t: 2.0, s.diff(zoo.T, 2): lambda x, t: 0.0}


def test_outputs_constraints_and_jacobians_see_the_samples():
    system = system_of(zoo.pendulum(), specifieds=both(), outputs={sm.Symbol("o"): 2 * F})
    x, t = zoo.pendulum().sample(1, 5)
    close(system.evaluate_outputs(x, t)[:, 0], 2 * sampled()(t)[:, 1])
    fixed = system_of(zoo.pendulum(), specifieds=numbers_at(t[2]))
    for wrt in ("states", "specifieds", "constants"):
        close(system.evaluate_jacobian(x, t, wrt)[2], fixed.evaluate_jacobian(x[2], t[2], wrt))
    lifted = system_of(zoo.lifted(), specifieds=heights(SampledInput([0, 1], [2, 4])))
    fixed = system_of(zoo.lifted(), specifieds={me.dynamicsymbols("s"): 3.0})
    x, _ = zoo.lifted().sample(1)
    close(lifted.evaluate_constraints(x, 0.5), fixed.evaluate_constraints(x, 0.5))


def test_r_for_one_call_takes_samples():
    system = system_of(zoo.pendulum(), specifieds={F: 0.1, T1: 0.2, T2: 0.3})
    x, _ = zoo.pendulum().sample(1)
    expected = oracle(zoo.pendulum()).xdot(x, 0.9, {**numbers_at(0.9), T1: 0.2})
    close(system.evaluate_ode(x, 0.9, r={(T2, F): sampled()}), expected)
    whole = SampledInput(TIMES, np.column_stack([VALUES, np.zeros(4)]))
    f, t1, t2 = whole(0.9)
    expected = oracle(zoo.pendulum()).xdot(x, 0.9, {F: f, T1: t1, T2: t2})
    close(system.evaluate_ode(x, 0.9, r=whole), expected)


def test_half_of_the_samples_can_be_replaced_for_one_call():
    system = system_of(zoo.pendulum(), specifieds=both())
    x, _ = zoo.pendulum().sample(1)
    expected = oracle(zoo.pendulum()).xdot(x, 0.9, {**numbers_at(0.9), F: 5.0})
    close(system.evaluate_ode(x, 0.9, r={F: 5.0}), expected)


def test_integrating_past_the_samples_is_refused():
    system = system_of(zoo.pendulum(), specifieds=both(), times=[0.0, 2.2])
    with pytest.raises(
        ValueError, match=r"`times`.*T2\(t\), F\(t\), 0\.0 to 2\.1, got 0\.0 to 2\.2\. Ask"
    ):
        system.integrate()


def test_evaluating_past_the_samples_is_refused():
    system = system_of(zoo.pendulum(), specifieds=both())
    x, _ = zoo.pendulum().sample(1)
    with pytest.raises(ValueError, match=r"`t`.*T2\(t\), F\(t\), 0\.0 to 2\.1, got -0\.5"):
        system.evaluate_ode(x, -0.5)
    with pytest.raises(ValueError, match=r"`t`.*got 0\.0 to 3\.0"):
        system.evaluate_outputs([x, x], [0.0, 3.0], r={F: sampled().of([0])})
    system.times = [2.5, 3.0]
    with pytest.raises(ValueError, match=r"`times`.*got 2\.5 to 2\.5"):
        system.evaluate_ode(x)


def test_dependent_initial_conditions_past_the_samples_are_refused():
    samples = SampledInput([0, 1], [2, 4])
    system = system_of(zoo.lifted(), specifieds=heights(samples), times=[2.0, 3.0])
    with pytest.raises(ValueError, match=r"`times`.*s\(t\), 0\.0 to 1\.0, got 2\.0"):
        system.set_dependent_initial_conditions()


def test_times_and_values_in_a_tuple_are_not_guessed_to_be_samples():
    with pytest.raises(ValueError, match=r"F\(t\).*pydy\.inputs\.SampledInput\(times, values\)"):
        system_of(zoo.pendulum(), specifieds={F: (TIMES, VALUES[:, 0])})


def test_samples_of_the_wrong_width_are_refused_by_name():
    with pytest.raises(ValueError, match=r"F\(t\), T1\(t\), T2\(t\).*of 3 values.*\(4, 2\)"):
        system_of(zoo.pendulum(), specifieds={(F, T1, T2): sampled()})
    with pytest.raises(ValueError, match=r"specifieds\['values'\].*of 3 values.*\(4, 2\)"):
        system_of(zoo.pendulum(), specifieds={"symbols": (F, T1, T2), "values": sampled()})


PULSE = {None: "hmax", "DOP853": "max_step", "BDF": "max_step"}


@pytest.mark.parametrize("solver", PULSE)
@pytest.mark.parametrize("force", [100.0, 1e-8])
def test_a_pulse_between_two_evaluations_of_scipys_solvers_is_told(solver, force):
    # An undamped oscillator at rest: the impulse leaves a difference of cosines.
    system = multi_mass_spring_damper(apply_external_forces=True)
    (F,) = system.specifieds_symbols
    system.specifieds = {F: SampledInput([0.0, 5.0, 5.01, 10.0], [0, force, 0, 0], "previous")}
    system.constants, system.times = {"c0": 0.0}, [0.0, 10.0]
    expected = force * (np.cos(5.0 - 0.01) - np.cos(5.0))
    tight = {"rtol": 1e-9, "atol": 1e-9}
    message = r"evaluated nothing from t = 5 to 5\.01, .* v0\(t\) by 1\. Set `.*`hmax=` of odeint"
    system.ode_solver = solver
    with pytest.warns(PyDyUserWarning, match=message) if force > 1.0 else nullcontext():
        missed = system.integrate(**tight)[-1, 0]
    assert abs(missed - expected) == pytest.approx(abs(expected))
    limited = {PULSE[solver]: 5e-3, **({} if solver else {"mxstep": 50000})}
    found = system.integrate(**tight, **limited)
    assert found[-1, 0] == pytest.approx(expected, abs=1e-7)
    system.ode_solver = "dop853"
    assert system.integrate(**tight)[-1, 0] == pytest.approx(expected, abs=1e-8)


@pytest.mark.parametrize("solver", SOLVER_NAMES)
def test_native_solvers_end_steps_at_jumps_beside_functions_too(solver):
    system = multi_mass_spring_damper(2, apply_external_forces=True)
    system.ode_solver = solver
    first, second = sorted(system.specifieds_symbols, key=str)
    jumps = SampledInput([0.0, 5.0, 5.001, 7.3, 10.0], [0.0, 1000.0, 0.0, -1.0, -1.0], "previous")
    system.times = [0.0, 2.5, 10.0]
    options = step_options(solver, 1e-9, 0.02)
    system.specifieds = {first: jumps, second: sm.sin(T)}
    expected, known = system.integrate(full_output=True, **options)
    system.specifieds = {first: jumps, second: lambda x, t: np.sin(t)}
    called, info = system.integrate(full_output=True, **options)
    close(called, expected, 1e-13)
    assert [info[k] for k in ("steps", "evaluations")] == [known["steps"], known["evaluations"]]
    system.specifieds = {first: jumps, second: sm.sin(T)}
    system.generate_ode_function(generator="lambdify")
    close(system.integrate(**options), expected, 1e-13)


# -- kinks: whether one matters, the error of a step across it tells -------------------------------


def on_a_road(times, heights, start=0.0):
    """A wheel on a spring and a damper that a road of straight pieces moves, and its states."""
    system = multi_mass_spring_damper(1, apply_external_forces=True)
    c, k, m = system.constants_symbols
    system.constants = {c: 2.0, k: 400.0, m: 1.0}
    (force,) = system.specifieds_symbols
    system.specifieds = {force: SampledInput(start + times, 400.0 * heights)}
    system.times = start + times[:: (len(times) - 1) // 100]
    h = times[1]
    rates = np.zeros((4, 4))  # of x, v, the force and its slope
    rates[0, 1] = rates[2, 3] = 1.0
    rates[1, :3] = -400.0, -2.0, 1.0
    step, slopes = expm(h * rates), np.diff(heights) / h
    states = [np.zeros(2)]
    for height, slope in zip(heights, slopes, strict=False):
        states.append((step @ [*states[-1], 400.0 * height, 400.0 * slope])[:2])
    return system, np.array(states)[:: (len(times) - 1) // 100]


TRIES = {"dop853": 1.6, "vern9": 1.6, "tsit5": 3.2, "radau": 7.2}  # for each kink


@pytest.mark.parametrize("start", [0.0, 1e4])
@pytest.mark.parametrize("solver", ADAPTIVE_NAMES)
def test_steps_end_at_the_kinks_that_matter(solver, start):
    """Of high orders three tries for two kinks; by error control alone they are 27."""
    times = np.linspace(0.0, 4.0, 401)
    heights = np.cumsum(np.random.default_rng(4).normal(0.0, 1e-2, 401))
    system, expected = on_a_road(times, heights, start)
    system.ode_solver = solver
    motion = system.simulate(rtol=1e-8, atol=1e-8)
    assert motion.states == pytest.approx(expected, abs=1e-6)
    tries = motion.statistics["steps"] + motion.statistics["rejected"]
    assert tries < TRIES[solver] * 400


@pytest.mark.parametrize("solver", ADAPTIVE_NAMES)
def test_steps_pass_over_the_kinks_of_dense_samples(solver):
    times = np.linspace(0.0, 4.0, 100_001)
    system, expected = on_a_road(times, 0.05 * np.sin(6.0 * times))
    system.ode_solver = solver
    motion = system.simulate(rtol=1e-6, atol=1e-6)
    assert motion.states == pytest.approx(expected, abs=1e-4)
    assert motion.statistics["steps"] + motion.statistics["rejected"] < 500


@pytest.mark.parametrize("solver", ADAPTIVE_NAMES)
def test_a_kink_that_a_step_begins_or_ends_at_is_no_reason_to_repeat_it(solver):
    """A ramp that ends where the motion does, and one that begins there."""
    system = free_mass(SampledInput([0.0, 1.0, 2.0], [0.0, 1.0, 0.0]), [1.0, 2.0])
    system.ode_solver = solver
    states = system.integrate(**TIGHT)
    close(states[-1], np.array([1.0 / 6.0, 0.25]), 1e-10)  # v = (s − s² / 2) / 2, with s = t − 1


@pytest.mark.parametrize("solver", ADAPTIVE_NAMES)
def test_a_kink_just_before_the_end_does_not_stop_the_motion(solver):
    """A step up to it is stretched to the end, which is nearer than a step may be short."""
    samples = SampledInput([0.0, 1.0 - 2e-6, 1.0 - 1e-6, 1.0], [0.0, 0.0, 2e4, 2e4])
    system = free_mass(samples, [0.0, 1.0])
    system.ode_solver = solver
    motion = system.simulate(rtol=1e-11, atol=1e-11, max_steps=10_000)
    close(motion.states[-1, 1], 1.5e-2, 1e-9)  # 1.5e-6 s · 2e4 N / 2 kg
