"""Fits by collocation against other estimators, and where simulations fail."""

from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.optimize import minimize

from oracles import optima
from oracles.optima import SOLVERS, T
from pydy._interrupts import Interrupts
from pydy.analysis import Trial
from pydy.control import identification, refine
from pydy.errors import FitInterrupted, IntegrationError, PyDyUserWarning
from pydy.inputs import SampledInput

GAINS = optima.standing.GAINS
QUARTER = np.deg2rad(0.25)


def standing(seed, seconds=10.0, noise=None):
    """Return a person with gains of zero, measured states, gains, torques and the truth."""
    system, (states, gains, torques) = optima.standing_person()
    rng = np.random.default_rng(seed)
    times = np.linspace(0.0, seconds, num=int(50 * seconds) + 1)
    known = dict(system.specifieds)
    if noise is not None:
        grid = np.linspace(0.0, seconds, num=2 * len(times) - 1)
        for torque in torques:
            own = me.dynamicsymbols(f"w_{torque.func}")
            values = rng.normal(0.0, noise / np.sqrt(grid[1]), len(grid))
            system.specifieds[torque] = known[torque] + own
            system.specifieds[own] = SampledInput(grid, values, "previous")
    system.constants = dict(zip(gains, GAINS.ravel(), strict=True))
    system.times, system.ode_solver = times, "dop853"
    ride = system.simulate(rtol=1e-8, atol=1e-8)
    measured = {s: ride[s] + rng.normal(0.0, QUARTER, len(times)) for s in states}
    system.specifieds, system.constants = known, dict.fromkeys(gains, 0.0)
    return system, Trial(times, measured, noise=QUARTER), gains, torques


@pytest.mark.parametrize("seed", range(2))
def test_the_gains_of_a_standing_person_from_zeros(seed):
    """With gains of zero the person falls: no simulation gets near the data."""
    system, trial, gains, _ = standing(seed)
    found = system.fit(gains, trial, method="collocation")
    distance = (found.estimates - GAINS.ravel()) / found.standard_errors
    assert np.abs(distance).max() < 3.0
    assert found.noise == pytest.approx(1.0, abs=0.08)
    assert (found.standard_errors < 0.02 * GAINS.ravel()).all()


def test_the_gains_of_a_standing_person_whose_torques_are_disturbed():
    system, trial, gains, torques = standing(0, 6.0, noise=2.0)
    disturbed = dict.fromkeys(torques, 2.0)
    found = system.fit(gains, trial, method="collocation", process_noise=disturbed, mesh=120)
    distance = (found.estimates - GAINS.ravel()) / found.standard_errors
    assert np.abs(distance).max() < 3.0
    assert found.noise == pytest.approx(1.0, abs=0.1)


def test_disturbed_motion_has_the_estimates_of_a_kalman_filter():
    """v' = −a v + b + w in white noise: the filter gives the exact likelihood of a and b."""
    x, v, F, w = me.dynamicsymbols("x v F w")
    a, b = sm.symbols("a b")
    a_, b_, intensity, deviation = 1.3, 0.7, 0.3, 0.05
    times = np.linspace(0.0, 20.0, num=201)
    rng = np.random.default_rng(3)

    def step(a):
        h = times[1]
        return np.exp(-a * h), -np.expm1(-a * h) / a, -(intensity**2) * np.expm1(-2 * a * h) / 2 / a

    rate, gain, spread = step(a_)
    truth = np.ones(len(times))
    for k in range(1, len(times)):
        truth[k] = rate * truth[k - 1] + gain * b_ + rng.normal(0.0, np.sqrt(spread))
    samples = truth + rng.normal(0.0, deviation, len(times))

    def surprise(z):
        """Return −log of the likelihood, but for a constant."""
        rate, gain, spread = step(z[0])
        mean, variance, total = 1.0, 0.0, 0.0
        for k, sample in enumerate(samples):
            if k:
                mean, variance = rate * mean + gain * z[1], rate**2 * variance + spread
            sure = variance + deviation**2
            total += 0.5 * (np.log(sure) + (sample - mean) ** 2 / sure)
            mean += variance / sure * (sample - mean)
            variance *= deviation**2 / sure
        return total

    best = minimize(surprise, [a_, b_], method="Nelder-Mead", options={"xatol": 1e-7}).x
    steps = 1e-3 * np.eye(2)
    H = [[(surprise(best + s + t) - surprise(best + s - t) - surprise(best - s + t)
           + surprise(best - s - t)) / 4e-6 for s in steps] for t in steps]  # fmt: skip
    errors = np.sqrt(np.diag(np.linalg.inv(H)))
    system = optima.first_order([x], v, -a * v + F)
    trial = Trial(times, {v: samples}, {v: 1.0}, noise=deviation)
    options = {"method": "collocation", "process_noise": {F: intensity}}
    system.specifieds = {F: b}  # an expression, which the noise is added to
    found = system.fit([a, b], trial, **options)
    np.testing.assert_allclose(found.estimates, best, atol=0.1 * errors.min())
    np.testing.assert_allclose(found.standard_errors, errors, rtol=0.15)
    fine = system.fit([a, b], trial, mesh=320, **options)
    np.testing.assert_allclose(fine.estimates, best, atol=0.02 * errors.min())
    # The same with a number, which is a parameter, and as a part of an expression.
    system.specifieds = {F: 0.5}
    number = system.fit([a, F], trial, **options)
    np.testing.assert_allclose(number.estimates, found.estimates, rtol=1e-6)
    system.specifieds = {F: b + w}
    part = system.fit([a, b], trial, method="collocation", process_noise={"w": intensity})
    np.testing.assert_allclose(part.estimates, found.estimates, rtol=1e-6)


def inverted(seed):
    """Return an unstable pendulum that noisy torques of a controller held up, as measured."""
    q, u, torque, w = me.dynamicsymbols("q u torque w")
    k, c = sm.symbols("k c")
    system = optima.first_order([q], u, k * sm.sin(q) - c * u + torque)
    rng = np.random.default_rng(seed)
    times = np.linspace(0.0, 12.0, num=601)
    grid = np.linspace(0.0, 12.0, num=1201)
    disturbance = SampledInput(grid, rng.normal(0.0, 2.0, len(grid)), "previous")
    held = -20 * q - 4 * u + 3 * sm.sin(2 * T)
    system.specifieds = {torque: held + w, w: disturbance}
    system.constants, system.initial_conditions = {k: 9.0, c: 0.5}, {q: 0.1}
    system.times, system.ode_solver = times, "dop853"
    ride = system.simulate(rtol=1e-8, atol=1e-8)
    # What was asked of the motor is known, what it did besides is not.
    asked = -20 * ride[q] - 4 * ride[u] + 3 * np.sin(2 * times)
    system.specifieds = {torque: SampledInput(times, asked)}
    system.constants = {k: 6.0, c: 1.0}
    trial = Trial(times, {q: ride[q] + rng.normal(0.0, 0.01, len(times))}, noise=0.01)
    return system, trial, (k, c), torque


def test_an_unstable_pendulum_whose_simulations_run_away():
    system, trial, constants, torque = inverted(0)
    try:
        with pytest.warns(PyDyUserWarning):
            shot = system.fit(constants, trial).estimates
    except (IntegrationError, pytest.fail.Exception):
        shot = np.zeros(2)
    assert np.abs(shot - [9.0, 0.5]).max() > 0.5
    intensity = 2.0 * np.sqrt(0.01)
    found = system.fit(constants, trial, method="collocation", process_noise={torque: intensity})
    assert (np.abs(found.estimates - [9.0, 0.5]) < 3.0 * found.standard_errors).all()
    assert (found.standard_errors < [1.0, 0.2]).all()


def test_motions_that_begin_later_and_inputs_of_time():
    x, v, F, push = me.dynamicsymbols("x v F push")
    k = sm.Symbol("k")
    system = optima.first_order([x], v, -k * x + F + push)
    system.specifieds = {push: sm.sin(T), F: SampledInput([0.0, 4.0, 9.0], [0.0, 2.0, 1.0])}
    system.constants, system.initial_conditions = {k: 3.0}, {x: 0.4}
    system.times, system.ode_solver = np.linspace(2.0, 8.0, num=61), "dop853"
    ride = system.simulate(rtol=1e-11, atol=1e-11)
    trial = Trial(ride.times[5:], {x: ride[x][5:]}, start=2.0)
    system.constants = {k: 2.5}
    for mesh in (None, 60, np.linspace(0.0, 1.0, num=61) ** 1.1):
        found = system.fit(k, trial, method="collocation", mesh=mesh)
        assert found[k] == pytest.approx(3.0, rel=1e-5)


def test_a_guess_far_away_and_the_covariance_of_shooting():
    system, trial, gains, _ = standing(1, 4.0)
    system.constants = dict(zip(gains, GAINS.ravel(), strict=True))
    shot = system.fit(gains, trial)
    system.constants = dict.fromkeys(gains, 10.0)
    found = system.fit(gains, trial, method="collocation")
    np.testing.assert_allclose(
        found.estimates, shot.estimates, atol=0.02 * min(shot.standard_errors)
    )
    np.testing.assert_allclose(found.covariance, shot.covariance, rtol=1e-3, atol=1e-3)


def test_poor_guesses_take_few_iterations():
    system, trial, gains, _ = standing(0, 6.0)
    for share in (0.0, 1.0, 10.0, -1.0):
        system.constants = dict(zip(gains, share * GAINS.ravel(), strict=True))
        found = system.fit(gains, trial, method="collocation")
        assert np.abs((found.estimates - GAINS.ravel()) / found.standard_errors).max() < 3.5
        assert found.evaluations <= 8


@pytest.mark.parametrize("guess", [2.0, 90.0])
def test_a_long_record_of_a_pendulum_from_poor_guesses(guess):
    # opty's `plot_vyasarayani.py`, by Vyasarayani et al. 2011: 50 s of noisy angles, 80 turns of
    # which any wrong frequency is a local optimum of fits by shooting; the start is unknown.
    angle, rate = me.dynamicsymbols("angle rate")
    p = sm.Symbol("p")
    system = optima.first_order([angle], rate, -p * sm.sin(angle))
    system.constants, system.initial_conditions = {p: 10.0}, {angle: np.pi / 6}
    system.times, system.ode_solver = np.linspace(0.0, 50.0, num=5000), "dop853"
    swing = system.simulate(rtol=1e-10, atol=1e-10)[angle]
    samples = swing + np.random.default_rng(1).normal(0.0, 0.05, 5000)
    start = {angle: samples[0], rate: 0.0}
    trial = Trial(system.times, {angle: samples}, start, unknown=(angle, rate), noise=0.05)
    system.constants = {p: guess}
    found = system.fit(p, trial, method="collocation")
    assert found[p] == pytest.approx(10.0, abs=3.0 * found.standard_errors[0])
    assert found.standard_errors[0] < 2e-3
    # The objective is at most that of the truth.
    assert (found.residuals[0]["angle"] ** 2).sum() <= ((samples - swing) ** 2).sum()


@pytest.mark.parametrize("guess", [0.2, -5.0])
def test_a_parameter_of_a_motion_that_grows_by_60_a_second(guess):
    # opty's `plot_betts2003.py`, by Betts and Huffman 2003: y = sin(p t) is one of the motions of
    # y'' = 3600 y − (3600 + p²) sin(p t), the others run away; p = π from 100 noisy samples.
    y, v = me.dynamicsymbols("y v")
    p = sm.Symbol("p")
    system = optima.first_order([y], v, 3600 * y - (3600 + p**2) * sm.sin(p * T))
    system.constants, system.initial_conditions = {p: guess}, {v: np.pi}
    times = np.linspace(0.0, 1.0, num=100)
    samples = np.sin(np.pi * times) + np.random.default_rng(0).normal(0.0, 0.05, 100)
    found = system.fit(p, Trial(times, {y: samples}, noise=0.05), method="collocation")
    assert found[p] == pytest.approx(np.pi, rel=1e-8)


def test_four_records_of_a_mass_on_a_spring_are_fitted_at_once():
    # opty's `plot_non_contiguous_parameter_identification.py`: positions with a noise of 2 m, from
    # starts that are unknown, of a mass with c = 0.25 N s/m and k = 1 N/m, from 0.1 and 3.
    x, v = me.dynamicsymbols("x v")
    c, k = sm.symbols("c k")
    system = optima.first_order([x], v, -c * v - k * (x - 1))
    system.constants = {c: 0.25, k: 1.0}
    system.times, system.ode_solver = np.linspace(0.0, 20.0, num=500), "dop853"
    rng, trials, true = np.random.default_rng(123), [], 0.0
    for _ in range(4):
        system.initial_conditions = dict(zip((x, v), 4 * rng.normal(size=2), strict=True))
        error = 2 * rng.normal(size=500)
        samples = system.simulate(rtol=1e-10, atol=1e-10)[x] + error
        start = {x: samples[0], v: 0.0}
        trials.append(Trial(system.times, {x: samples}, start, unknown=(x, v), noise=2.0))
        true += (error**2).sum()
    system.constants = {c: 0.1, k: 3.0}
    found = system.fit([c, k], trials, method="collocation")
    away = (found.estimates[:2] - [0.25, 1.0]) / found.standard_errors[:2]
    assert np.abs(away).max() < 3.0
    assert sum((r["x"] ** 2).sum() for r in found.residuals) <= true


def test_a_fit_costs_few_integrations_and_no_factorisation_but_the_equations(monkeypatch):
    """The mesh's errors are known to be small enough; states follow from the equations alone."""
    system, trial, gains, _ = standing(0, 4.0)
    counts = {"integrations": 0, "general": 0}

    def counted(name, owner, key):
        original = getattr(owner, name)

        def call(*arguments, **named):
            counts[key] += 1
            return original(*arguments, **named)

        monkeypatch.setattr(owner, name, call)

    counted("_integrated", refine, "integrations")
    counted("_system", identification, "general")
    found = system.fit(gains, trial, method="collocation")
    assert counts == {"integrations": 2, "general": 0}
    monkeypatch.setattr(identification._CombinedExperiments, "_states_follow", False)
    general = system.fit(gains, trial, method="collocation")
    assert counts["general"] == 1
    np.testing.assert_allclose(general.covariance, found.covariance, rtol=1e-6)


@pytest.mark.parametrize("solver", ["ipopt", *SOLVERS])
def test_fits_by_each_solver(solver):
    system, trial, gains, torques = standing(0, 2.0)
    options = {"method": "collocation", "mesh": 30, "process_noise": {torques[0]: 0.5}}
    system.constants = dict(zip(gains, 0.7 * GAINS.ravel(), strict=True))
    expected = system.fit(gains, trial, **options)
    found = system.fit(gains, trial, solver=solver, mu_strategy="adaptive", **options)
    assert found.success
    assert np.abs(found.estimates / expected.estimates - 1.0).max() < 1e-5


def test_solvers_of_fits_that_are_refused():
    system, trial, gains, _ = standing(0, 1.0)
    with pytest.raises(ValueError, match="`solver` needs method='collocation'"):
        system.fit(gains, trial, solver="ipopt")
    with pytest.raises(ValueError, match="`solver` must be one of 'ipopt', 'cyipopt', 'pounce'"):
        system.fit(gains, trial, method="collocation", solver="")
    with pytest.raises(ValueError, match="`options` has 'nonsense': 1"):
        system.fit(gains, trial, method="collocation", nonsense=1)


def test_ctrl_c_hands_over_the_estimates(monkeypatch):
    system, trial, gains, _ = standing(0, 2.0)
    calls = []

    def check(self):
        calls.append(1)
        if len(calls) == 3:
            raise KeyboardInterrupt

    monkeypatch.setattr(Interrupts, "check", check)
    with pytest.raises(FitInterrupted) as caught:
        system.fit(gains, trial, method="collocation")
    assert set(caught.value.values) == {str(g) for g in gains}


def test_process_noise_needs_the_noise_of_samples_and_is_positive():
    system, (x, v, F) = optima.double_integrator()
    m = sm.Symbol("m")
    system = optima.first_order([x], v, F, m)
    times = np.linspace(0.0, 1.0, num=5)
    trial = Trial(times, {x: times})
    with pytest.raises(ValueError, match="`process_noise` needs the `noise` of each Trial"):
        system.fit(m, trial, method="collocation", process_noise={F: 1.0})
    trial = Trial(times, {x: times}, noise=1.0)
    with pytest.raises(ValueError, match=r"`process_noise\[F\(t\)\]` must be positive, got -1.0"):
        system.fit(m, trial, method="collocation", process_noise={F: -1.0})
    system.specifieds = {F: lambda x, t: 1.0}
    with pytest.raises(ValueError, match="Python function"):
        system.fit(m, trial, method="collocation")


@pytest.mark.parametrize("begin", [0.0, 1.7e9])
@pytest.mark.parametrize("kind", ["previous", "linear"])
def test_inputs_that_jump_or_bend_get_nodes_there(kind, begin):
    """x' = b r − k x, exactly from sample to sample of r; 26 jumps were 12 meshes and a warning."""
    y, x, r = me.dynamicsymbols("y x r")
    k, b = sm.symbols("k b")
    system = optima.first_order([y], x, b * r - k * x)
    grid, values = np.linspace(0.0, 5.0, num=26), np.random.default_rng(3).normal(size=26)
    states = [1.0]
    for first, last in pairwise(values):
        slope = (last - first) / 0.2 if kind == "linear" else 0.0
        steady = 2.0 * (first / 0.8 - slope / 0.8**2)  # to which the motion is drawn
        states.append((states[-1] - steady) * np.exp(-0.8 * 0.2) + steady + 2.0 * slope / 0.8 * 0.2)
    times = begin + grid
    system.constants, system.initial_conditions = {k: 0.5, b: 1.0}, {x: 1.0}
    system.specifieds = {r: SampledInput(times, values, kind)}
    trial = Trial(times, {x: states}, noise=1e-3)
    found = system.fit([k, b], trial, method="collocation")
    # Times around 1.7e9 are rounded to 2.4e-7.
    np.testing.assert_allclose(found.estimates, [0.8, 2.0], rtol=1e-5 if begin else 1e-7)


@pytest.mark.parametrize("unit", [1.0, 1e-9, 1e9])
def test_parameters_at_active_bounds_are_set_to_them(unit):
    # With bounds 0 and 1 and the barrier β, each distance d has the multiplier β/d: a bound is
    # active if that is the larger one. In other units nothing changes.
    barrier, cost = 1e-9, 3e4
    distances = np.array([1e-7, 1e-3, 1e-7, 1.0 - 1e-7, 1.0 - 1e-3])
    below, above = (barrier / d * cost / unit for d in (distances, 1.0 - distances))
    sizes = unit * np.ones(5)
    nlp = SimpleNamespace(lower=0.0 * sizes, upper=sizes, sizes=sizes, cost_size=cost)
    solution = SimpleNamespace(z=unit * distances, below=below, above=above)
    combined = SimpleNamespace(size=5, parameters=np.array([4, 3, 0, 1]))  # 2 is that of a state
    z = identification._CombinedExperiments.at_bounds(combined, nlp, solution)
    np.testing.assert_array_equal(z, unit * np.array([0.0, 1e-3, 1e-7, 1.0, 1.0 - 1e-3]))
    np.testing.assert_array_equal(solution.z, unit * distances)  # a copy
