"""Eight trajectories at once: the same results as one by one, whatever the neighbours."""

import warnings
from functools import cache

import numpy as np
import pytest
import scipy.linalg
import scipy.special
import sympy as sm
import sympy.physics.mechanics as me

from pydy._errors import IntegrationError, PyDyUserWarning
from pydy._program.interpret import run as interpret
from pydy.ensemble.model import Batch, EnsembleModel
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper
from pydy.solvers import Event
from pydy.solvers.constraint_drift import DriftCheck
from pydy.solvers.outcome import Outcome
from pydy.system import System
from registry import ADAPTIVE_NAMES
from zoo import inertial_frame, loops
from zoo.ensemble_cases import identical, pendulum, random_values, runaway, same_bits


def one_by_one(system, method, values, m, **options):
    """The trajectories of the solver for one, shape (m, times, n), and their statistics."""
    system.ode_solver = method
    states, infos = [], []
    for k in range(m):
        system.initial_conditions = {s: v[k] for s, v in values["initial_conditions"].items()}
        system.constants = {s: v[k] for s, v in values["constants"].items()}
        x, info = system.integrate(full_output=True, **options)
        states.append(x)
        infos.append(info)
    return np.array(states), infos


def stacked(system, dataset):
    return np.stack([dataset[s.name].values for s in system.states], axis=-1)


@pytest.mark.parametrize(
    ("method", "options"),
    [
        ("dop853", {"rtol": 1e-9, "atol": 1e-9}),
        ("tsit5", {"rtol": 1e-7, "atol": 1e-8}),
        ("vern9", {"rtol": 1e-8, "atol": 1e-8}),
        ("rk4", {"step": 0.01}),
        ("dop853", {"rtol": 1e-6, "max_step": 0.1, "first_step": 0.01}),
        ("radau", {"rtol": 1e-8, "atol": 1e-8}),
        ("radau", {"rtol": 1e-3, "atol": 1e-3, "max_step": 0.5, "first_step": 0.4}),
    ],
)
@pytest.mark.parametrize("links", [1, 5])  # vectors of one block, and of several
def test_lanes_give_the_bits_of_the_solver_for_one(method, options, links):
    system, m = pendulum(links), 13
    values = random_values(system, m)
    many = system.integrate_ensemble(**values, ode_solver=method, **options)
    states, infos = one_by_one(system, method, values, m, **options)
    np.testing.assert_array_equal(stacked(system, many), states)
    for name in ("steps", "rejected", "evaluations"):
        assert many[name].values.tolist() == [info[name] for info in infos]
    assert (many.status == 0).all()
    assert (many.end_time == 2.0).all()


@pytest.mark.parametrize(
    ("own", "expected"), [("tsit5", "tsit5"), ("odeint", "dop853"), ("RK45", "dop853")]
)
def test_the_solver_is_the_systems_if_it_is_native(own, expected):
    system = pendulum(1)
    system.ode_solver = None if own == "odeint" else own
    values = random_values(system, 3)
    given = system.integrate_ensemble(**values, ode_solver=expected)
    identical(given, system.integrate_ensemble(**values))
    assert given.attrs["ode_solver"] == expected


def test_a_sample_has_the_same_bits_in_any_lane_beside_any_neighbours():
    system, m = pendulum(2), 37
    values = random_values(system, m)
    whole = system.integrate_ensemble(**values, rtol=1e-9, atol=1e-9)
    rng = np.random.default_rng(1)
    for number in (1, 5, m):
        chosen = rng.permutation(m)[:number]
        part = {k: {s: v[chosen] for s, v in d.items()} for k, d in values.items()}
        some = system.integrate_ensemble(**part, rtol=1e-9, atol=1e-9)
        for name in some.data_vars:
            assert same_bits(some[name], whole[name].isel(sample=chosen)), name


@pytest.mark.parametrize("workers", [1, 2, 3])
def test_the_number_of_threads_changes_no_bit(workers):
    system = pendulum()
    values = random_values(system, 300)
    one = system.integrate_ensemble(**values, workers=1)
    assert one.identical(system.integrate_ensemble(**values, workers=workers))


def test_an_angle_that_needs_the_c_library_leaves_the_others_untouched():
    system = pendulum()
    values = random_values(system, 16)
    q = system.coordinates[1]
    before = system.integrate_ensemble(**values)
    values["initial_conditions"][q][5] += 1e9  # far beyond what the own sine reduces
    after = system.integrate_ensemble(**values)
    others = np.arange(16) != 5
    for name in before.data_vars:
        assert same_bits(before[name][others], after[name][others]), name
    assert not same_bits(before[q.name][5], after[q.name][5])


def test_a_sample_that_diverges_is_nan_from_there_on_and_alone():
    system, _x, v, _mass = runaway()
    speeds = np.array([0.1, 1.0, 0.2, 0.3, 0.1, 0.25, 0.05, 0.4, 0.15, 0.35])
    results = system.integrate_ensemble(initial_conditions={v: speeds})
    assert results.status.values.tolist() == [0, 2] + [0] * 8
    assert "step_underflow" in results.status.attrs["flag_meanings"].split()
    assert results.end_time.values[1] == pytest.approx(1.0, abs=1e-6)  # m / v
    reached = results.time.values < 1.0
    bad = results[v.name].values[1]
    np.testing.assert_allclose(bad[reached], 1.0 / (1.0 - results.time.values[reached]), rtol=1e-5)
    assert np.isnan(bad[results.time.values > 1.0]).all()
    without = np.arange(10) != 1
    alone = system.integrate_ensemble(initial_conditions={v: speeds[without]})
    for name in alone.data_vars:
        assert same_bits(alone[name], results[name][without]), name


def test_a_singular_sample_says_so_and_is_alone():
    system, x, v, mass = runaway()
    masses = np.array([1.0, 2.0, 0.0, 3.0])
    results = system.integrate_ensemble(initial_conditions={v: 0.1}, constants={mass: masses})
    assert results.status.values.tolist() == [0, 0, 3, 0]
    assert results.status.attrs["flag_meanings"].split()[4] == "singular"
    assert np.isnan(results[x.name].values[2]).all()
    exact = 0.1 / (1.0 - 0.1 * 2.0 / masses[[0, 1, 3]])
    np.testing.assert_allclose(results[v.name].values[[0, 1, 3], -1], exact, rtol=1e-6)


def test_too_many_steps_end_a_sample():
    system = pendulum()
    results = system.integrate_ensemble(
        initial_conditions={system.coordinates[1]: [0.0, 0.0, 1.0]}, max_steps=10
    )
    assert results.status.values.tolist() == [0, 0, 1]
    assert (results.steps + results.rejected).values[2] == 10


def test_a_fixed_step_that_overflows_is_a_failure():
    system, _x, v, _ = runaway()
    results = system.integrate_ensemble(
        initial_conditions={v: [0.1, 4.0, 0.2]}, ode_solver="rk4", step=0.05
    )
    assert results.status.values.tolist() == [0, 4, 0]
    assert results.status.attrs["flag_meanings"].split()[5] == "not_finite"
    assert np.isnan(results.v0[1, -1])
    assert np.isfinite(results.v0[[0, 2]]).all()


def test_sampled_inputs_are_taken_at_each_lanes_own_time():
    system = multi_mass_spring_damper(apply_external_forces=True)
    (force,) = system.specifieds_symbols
    x, _v = system.states
    system.times = np.linspace(0.0, 3.0, num=7)
    t = np.linspace(0.0, 3.0, num=9)
    push = SampledInput(t, np.cos(3.0 * t), interpolation="pchip")
    starts = np.linspace(-1.0, 1.0, num=11)
    options = {"rtol": 1e-10, "atol": 1e-10}
    many = system.integrate_ensemble(
        initial_conditions={x: starts}, specifieds={force: push}, **options
    )
    system.specifieds, system.ode_solver = {force: push}, "dop853"
    for k, start in enumerate(starts):
        system.initial_conditions = {x: start}
        one = system.integrate(**options)
        np.testing.assert_allclose(many[x.name][k], one[:, 0], rtol=0, atol=1e-7)


def test_equal_times_and_a_start_before_the_first_output_are_written():
    system = pendulum()
    times = [0.0, 0.0, 0.5, 0.5, 1.0]
    results = system.integrate_ensemble(
        initial_conditions={system.coordinates[1]: [0.1, 0.2]}, times=times
    )
    q = results[system.coordinates[1].name].values
    assert np.isfinite(q).all()
    assert same_bits(q[:, 0], q[:, 1])
    assert same_bits(q[:, 2], q[:, 3])
    assert same_bits(q[:, 0], [0.1, 0.2])


# -- implicit steps --------------------------------------------------------------------------------


def spring(force=lambda x, v: 0):
    """A mass on a spring with a damper, under a force of x and v; the constants are 1."""
    system = multi_mass_spring_damper(apply_external_forces=True)
    (push,), (x, v) = system.specifieds_symbols, system.states
    system.specifieds = {push: force(x, v)}
    system.times = np.linspace(0.0, 2.0, num=9)
    system.constants = dict.fromkeys(["k0", "c0", "m0"], 1.0)
    return system, x, v


def test_stiff_springs_in_lanes_follow_the_matrix_exponential():
    """Pivots differ from lane to lane: stiffness against three over the step size."""
    system, x, v = spring()
    k, c = np.geomspace(1.0, 1e10, num=21), np.geomspace(1.0, 1e6, num=21)[::-1]
    values = {"initial_conditions": {x: 1.0, v: 0.0}, "constants": {"k0": k, "c0": c}}
    options = {"ode_solver": "radau", "rtol": 1e-6, "atol": 1e-8, "reduce": None}
    many = told(lambda: system.integrate_ensemble(**values, **options))
    assert (many.status == 0).all()
    fast = k > 1e6  # of oscillations that are damped in the steps themselves
    for j, (stiffness, damping) in enumerate(zip(k, c, strict=True)):
        matrix = np.array([[0.0, 1.0], [-stiffness, -damping]])
        exact = [scipy.linalg.expm(matrix * t)[0, 0] for t in system.times]
        if damping > 2.0 * np.sqrt(stiffness) or not fast[j]:
            np.testing.assert_allclose(many[x.name][j], exact, rtol=0.0, atol=2e-4)
    assert float(many.steps.max()) > 5.0 * float(many.steps.min())


def test_van_der_pols_oscillators_jump_when_they_should():
    """The period of relaxation oscillations: A. A. Dorodnitsyn's expansion up to 1 / mu."""
    mu = sm.Symbol("mu")
    system, x, v = spring(lambda x, v: mu * (1 - x**2) * v)
    system.constants = {"k0": 1.0, "c0": 0.0, "m0": 1.0}
    rates = np.linspace(60.0, 240.0, num=11)
    system.times = np.linspace(0.0, 1000.0, num=2)
    up = Event(x, direction=1, name="up")
    values = {"initial_conditions": {x: 2.0, v: 0.0}, "constants": {mu: rates}}
    options = {"ode_solver": "radau", "rtol": 1e-8, "atol": 1e-8}
    many = watched(system, [up], values, reduce=["final", ("events", 12)], **options)
    times = many["up_times"].values
    zero = scipy.special.ai_zeros(1)[0][0]
    period = (3.0 - 2.0 * np.log(2.0)) * rates - 3.0 * zero / np.cbrt(rates)
    period -= 2.0 / 3.0 * np.log(rates) / rates
    assert (np.abs(times[:, 1] - times[:, 0] - period) < 2.0 / rates).all()
    assert (times[:, 1] > 95.0).all()


def test_samples_that_fail_with_radau_are_told_of_and_alone():
    system, _x, v, mass = runaway()
    masses = np.array([1.0, 1.0, 0.0, 2.0, 1e-310, 1.0, 3.0, 1.0, 1.0, 1.0])
    speeds = np.array([0.1, 1.0, 0.2, 0.3, 0.1, 1e200, 0.05, 0.4, 0.15, 0.35])
    values = {"initial_conditions": {v: speeds}, "constants": {mass: masses}}
    for more in ({}, {"max_steps": 20}, {"rtol": 1e-3, "first_step": 1.5}):
        options = {"ode_solver": "radau", **more}
        many = told(lambda options=options: system.integrate_ensemble(**values, **options))
        assert (many.status.values[[1, 2, 4, 5]] > 0).all()
    sound = (many.status == 0).values
    assert sound.sum() == 6
    few = {kind: {s: a[sound] for s, a in given.items()} for kind, given in values.items()}
    alone = system.integrate_ensemble(**few, **options)
    for name in alone.data_vars:
        assert same_bits(alone[name], many[name][sound]), name


def test_infinite_slopes_are_forgotten_in_their_lanes_alone():
    system, _x, v = spring(lambda _, v: 10 - sm.sqrt(v))
    system.constants = {"k0": 0.0, "c0": 0.0, "m0": 1.0}
    starts = {
        "initial_conditions": {v: np.array([0.0, 1.0, 1e-300, 4.0, 0.0, -0.1, 9.0, 1e-9, 0.0])}
    }
    options = {"ode_solver": "radau", "rtol": 1e-10, "atol": 1e-10}
    many = told(lambda: system.integrate_ensemble(**starts, **options))
    assert many.status.values[[0, 2, 4, 8]].tolist() == [0] * 4
    np.testing.assert_allclose(many[v.name][[0, 2, 4, 8], -1], 14.682934, rtol=1e-7)
    assert many.status.values[5] > 0  # the root of a negative number


@pytest.mark.parametrize("kind", ["previous", "linear", "pchip"])
def test_radaus_lanes_see_sampled_inputs_at_their_own_times(kind):
    t = np.linspace(0.0, 3.0, num=9)
    push = SampledInput(t, 4.0 * np.cos(3.0 * t), interpolation=kind)
    system, x, _v = spring(lambda *_: push)
    values = {"initial_conditions": {x: np.linspace(-1.0, 1.0, num=11)}}
    values["constants"] = {"c0": np.geomspace(0.1, 1e4, num=11)}
    options = {"rtol": 1e-8, "atol": 1e-8}
    many = told(lambda: system.integrate_ensemble(**values, ode_solver="radau", **options))
    other = system.integrate_ensemble(**values, ode_solver="dop853", **options)
    np.testing.assert_allclose(many[x.name], other[x.name], rtol=0.0, atol=2e-5)


@pytest.mark.parametrize("solver", ADAPTIVE_NAMES)
def test_lanes_end_steps_at_the_knots_that_one_trajectory_ends_them_at(solver):
    t = np.linspace(0.0, 3.0, num=301)
    push = SampledInput(t, np.random.default_rng(7).normal(0.0, 4.0, 301))
    system, x, _v = spring(lambda *_: push)
    values = {"initial_conditions": {x: np.linspace(-1.0, 1.0, num=11)}}
    values["constants"] = {"c0": np.geomspace(0.1, 1e2, num=11)}
    options = {"ode_solver": solver, "rtol": 1e-7, "atol": 1e-7}
    many = told(lambda: system.integrate_ensemble(**values, **options))
    for k in range(11):
        system.initial_conditions = {x: float(values["initial_conditions"][x][k])}
        system.constants["c0"] = float(values["constants"]["c0"][k])
        system.ode_solver = solver
        one = system.simulate(rtol=1e-7, atol=1e-7)
        assert one.statistics["rejected"] > 50  # the knots matter
        np.testing.assert_array_equal(many[x.name][k], one.states[:, 0])


# -- on constraints --------------------------------------------------------------------------------


def bead():
    """A particle in x and y on a circle, pushed along x."""
    x, y, u, v = me.dynamicsymbols("x y u v")
    m, g, length = sm.symbols("m g length")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    place.set_vel(frame, u * frame.x + v * frame.y)
    push = me.dynamicsymbols("push") * frame.x
    made = Definition(
        frame,
        [x, y],
        [u, v],
        bodies=[me.Particle("P", place, m)],
        loads=[(place, push - m * g * frame.y)],
        holonomic_constraints=[x**2 + y**2 - length**2],
    )
    return System(
        made,
        initial_conditions={x: 0.6, y: -0.8},
        constants={"m": 2.0, "g": 9.81, "length": 1.0},
        times=np.linspace(0.0, 3.0, num=61),
    )


@cache
def made_and_start(make, **given):
    """A mechanism, derived once for all methods."""
    return make(**given)


def linkage(make, **given):
    made, start = made_and_start(make, **given)
    times = np.linspace(0.0, 2.0, num=41)
    system = System(made, constants={"g": 9.81}, initial_conditions=start, times=times)
    system.set_dependent_initial_conditions()
    return system


# Of redundant rows, some of them in space, and past positions where the rank falls.
LINKAGES = ("bricard", "parallelogram", "spatial_four_bar", "even_slider_crank", "sarrus")


HELD = [
    ("dop853", {"rtol": 1e-8, "atol": 1e-8}),
    ("tsit5", {"rtol": 1e-6, "atol": 1e-6}),
    ("vern9", {"rtol": 1.0, "atol": 1.0, "first_step": 0.7}),  # far off, or not at all
    ("tsit5", {"rtol": 100.0, "atol": 100.0, "first_step": 0.7, "max_steps": 200}),
    ("rk4", {"step": 0.05}),
    ("radau", {"rtol": 1e-6, "atol": 1e-6}),
    ("radau", {"rtol": 100.0, "atol": 100.0, "first_step": 0.7, "max_steps": 200}),
]


@pytest.mark.parametrize(("method", "options"), HELD)
@pytest.mark.filterwarnings("ignore")
def test_lanes_on_constraints_have_the_bits_of_the_solver_for_one(method, options):
    gravities = np.geomspace(1.0, 400.0, num=12)
    options = options | {"constraints": "project"}
    made = [linkage(getattr(loops, name)) for name in LINKAGES]
    for system in (*made, bead()):
        if system.specifieds_symbols:
            t = np.linspace(0.0, 3.0, num=9)
            push = SampledInput(t, 9.0 * np.cos(3.0 * t), interpolation="pchip")
            system.specifieds = {"push": push}
        system.ode_solver = method
        many = system.integrate_ensemble(constants={"g": gravities}, **options)
        assert many.attrs["lanes"] == 8
        found = stacked(system, many)
        for k, gravity in enumerate(gravities):
            system.constants["g"] = gravity
            try:
                states, info = system.integrate(full_output=True, **options)
            except IntegrationError as error:
                states, info = error.states, error.info
            assert many["status"].values[k] == info["code"]
            sound = np.isfinite(found[k]).all(axis=1).sum()  # ensembles lose what was judged
            assert sound == len(states) or info["code"] in (
                Outcome.LEFT_CONSTRAINTS,
                Outcome.ENERGY_CHANGED,
            )
            np.testing.assert_array_equal(found[k, :sound], states[:sound])
            assert np.isnan(found[k, sound:]).all()
            for name in ("steps", "rejected", "evaluations"):
                assert many[name].values[k] == info[name]


@pytest.mark.filterwarnings("ignore:The initial conditions of sample 1")
def test_samples_beside_their_constraints_are_told_and_alone():
    system = bead()
    heights = np.array([-0.8, -0.7, -0.8, -0.8 - 1e-9])
    with pytest.warns(PyDyUserWarning, match="1 of 4 samples, and maybe others"):
        many = system.integrate_ensemble(
            initial_conditions={"y": heights}, ode_solver="dop853", constraints="project"
        )
    assert many.attrs["lanes"] == 8
    assert many.status.values.tolist() == [0, Outcome.START_OFF_CONSTRAINTS, 0, 0]
    assert np.isnan(many["x"].values[1]).all()
    assert same_bits(many["x"][0], many["x"][2])


def test_samples_are_judged_together_as_alone(monkeypatch):
    asked = []

    def counted(*given):
        asked.append(len(given[1]))
        return interpret(*given)

    monkeypatch.setattr("pydy.ensemble.work.interpret", counted)
    system = linkage(loops.parallelogram)
    options = {"ode_solver": "dop853", "constraints": "project", "rtol": 1e-8, "atol": 1e-8}
    system.times = np.linspace(0.0, 5.0, num=51)
    gravities = np.linspace(5.0, 15.0, num=30)
    many = system.integrate_ensemble(constants={"g": gravities}, **options)
    assert 0 < len(asked) < 20  # not once for each sample
    assert len(set(many.status.values)) > 1
    for k in range(0, 30, 3):
        alone = system.integrate_ensemble(constants={"g": gravities[k : k + 1]}, **options)
        for name in alone.data_vars:
            assert same_bits(alone[name][0], many[name][k]), name


def test_a_sample_whose_residuals_overflow_is_told_of_in_words():
    system = bead()
    with pytest.warns(PyDyUserWarning, match="1 of 3 samples, and maybe others"):
        many = system.integrate_ensemble(
            initial_conditions={"y": [-0.8, 1e200, -0.8]},
            ode_solver="dop853",
            constraints="project",
        )
    assert many.status.values.tolist() == [0, Outcome.START_OFF_CONSTRAINTS, 0]


@pytest.mark.filterwarnings("ignore")
def test_samples_that_are_sound_at_a_glance_need_no_judgement(monkeypatch):
    judged = []

    report = DriftCheck.report

    def counted(check, quantities):
        judged.append(check)
        return report(check, quantities)

    monkeypatch.setattr(DriftCheck, "report", counted)
    options = {"ode_solver": "dop853", "constraints": "project", "rtol": 1e-8, "atol": 1e-8}
    values = {"constants": {"g": np.linspace(5.0, 15.0, num=30)}}
    system = linkage(loops.parallelogram)
    for last, all_sound in ((0.1, True), (5.0, False)):
        system.times = np.linspace(0.0, last, num=51)
        many = system.integrate_ensemble(**values, **options)
        assert (many.status == 0).all() == all_sound
        assert bool(judged) != all_sound
        with monkeypatch.context() as patch:
            patch.setattr(
                "pydy.ensemble.work._needing_reports", lambda *given: np.full(len(given[2]), True)
            )
            identical(many, system.integrate_ensemble(**values, **options))
        assert len(judged) >= 30
        judged.clear()


# -- events ----------------------------------------------------------------------------------------


def told(ask):
    """An ensemble in lanes and one by one, and what was warned of."""
    found = []
    for lanes in (True, False):
        with pytest.MonkeyPatch.context() as patch, warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            if not lanes:
                patch.setattr(EnsembleModel, "in_lanes", False)
            found.append((ask(), {str(warning.message) for warning in caught}))
        assert found[-1][0].attrs["lanes"] == (8 if lanes else 1)
    identical(found[0][0], found[1][0])
    assert len(found[0][1]) == len(found[1][1])  # each names one of its samples, by chance
    return found[0][0]


def watched(system, events, values, **options):
    options = {"reduce": ["final", ("events", 400)], **options}
    return told(lambda: system.integrate_ensemble(events=events, **values, **options))


METHODS = [
    ("dop853", {"rtol": 1e-8, "atol": 1e-8}),
    ("tsit5", {"rtol": 1e-6, "atol": 1e-6, "first_step": 0.01}),
    ("vern9", {"rtol": 1e-8, "max_step": 0.1}),
    ("rk4", {"step": 0.02}),
    ("radau", {"rtol": 1e-6, "atol": 1e-6}),
]


@pytest.mark.parametrize(("method", "options"), METHODS)
@pytest.mark.parametrize("seed", range(2))
def test_events_in_lanes_have_the_bits_of_the_solver_for_one(method, options, seed):
    system, rng = pendulum(1 + seed % 2), np.random.default_rng(seed)
    values, states = random_values(system, 19, seed), list(system.states)
    a, b, c = rng.permutation(len(states))[:3]
    x, y, z = states[a], states[b], states[c]
    time = me.dynamicsymbols._t
    events = [
        Event(x - 0.1, direction=int(rng.integers(-1, 2)), reset={y: -0.9 * y}, name="line"),
        Event(sm.sin(3 * x) + y * z, direction=int(rng.integers(-1, 2)), name="curve"),
        Event(time - 0.5 - 0.1 * z, reset={z: z + 0.01}, name="time"),
        Event(x + y - 1.2, terminal=bool(seed % 2), name="last"),
    ]
    found = watched(system, events, values, ode_solver=method, **options)
    assert found["time_count"].values.sum() >= 10
    outputs = watched(system, events, values, ode_solver=method, reduce=None, **options)
    assert set(outputs.status.values) <= {0, Outcome.TERMINATED}
    few = watched(system, events[:1], values, ode_solver=method, reduce="final", **options)
    assert (few.status == 0).all()


def test_logs_of_lanes_are_emptied_where_that_of_one_is():
    system, time = pendulum(1), me.dynamicsymbols._t
    values, q = random_values(system, 9), system.coordinates[0]
    events = [Event(sm.sin(900 * time + q), name="often"), Event(q - 0.1, reset={q: q + 0.1})]
    found = watched(system, events, values, ode_solver="dop853")
    assert (found["often_count"] > 500).all()


def test_what_lanes_leave_to_python_is_as_one_by_one():
    system, time = pendulum(1), me.dynamicsymbols._t
    values, q, u = random_values(system, 9), system.coordinates[1], system.speeds[0]
    values["initial_conditions"][q][:3] = 0.0, 0.3, -0.2  # zero at first
    both = [Event(q - 0.2, reset={u: 0.9 * u}), Event(2 * q - 0.4, reset={u: u + 0.1}, name="b")]
    assert (watched(system, both, values)["b_count"] > 0).any()
    ends = [Event(q, terminal=True, reset={u: 0.5 * u}), Event(time - 2.0, name="end")]
    found = watched(system, ends, values)
    assert set(found.status.values) == {0, Outcome.TERMINATED}
    assert (found["end_count"] == (found.status == 0)).all()
    undefined = [Event(sm.sqrt(q) - 0.1, name="root")]
    assert Outcome.EVENT_UNDEFINED in watched(system, undefined, values).status.values
    rests = [Event(sm.Max(0, q), name="rest")]
    assert (watched(system, rests, values).status == 0).all()
    over = watched(system, [Event(q)], values, max_steps=12)
    assert set(over.status.values) == {0, Outcome.TOO_MANY_STEPS}


def test_samples_that_fail_after_events_are_alone():
    system, x, v, _ = runaway()
    speeds = {"initial_conditions": {v: np.array([0.1, 1.0, 0.2, 0.0, 0.4])}}
    kicks = [Event(x - 0.1, direction=1, reset={v: 1.5 * v}, name="kick"), Event(v - 1e9)]
    found = watched(system, kicks, speeds)
    assert set(found.status.values) == {0, Outcome.STEP_UNDERFLOW}
    assert found["kick_count"].values.tolist() == [1, 1, 1, 0, 1]


@pytest.mark.parametrize("method", ["dop853", "radau"])
@pytest.mark.parametrize("events", [False, True])
def test_tolerances_that_are_too_small_for_a_sample_are_told_of_it(events, method):
    system = pendulum(2)
    values = random_values(system, 11)
    q = system.coordinates[0]
    options = {"events": [Event(q - 0.3)], "reduce": "events"} if events else {}
    options |= {"ode_solver": method, "rtol": 0.0, "atol": 1e-12}
    plain = told(lambda: system.integrate_ensemble(**values, **options))
    assert (plain.status == 0).all()
    values["initial_conditions"][q][4] = 1e5  # a rounding of which is larger than `atol`
    many = told(lambda: system.integrate_ensemble(**values, **options))
    assert many.status.values.tolist() == [0] * 4 + [Outcome.TOLERANCE_TOO_SMALL] + [0] * 6


@pytest.mark.parametrize("kind", ["pchip", "previous"])
def test_events_beside_sampled_inputs_are_noted_in_lanes(kind):
    system = multi_mass_spring_damper(apply_external_forces=True)
    (force,), (x, v) = system.specifieds_symbols, system.states
    t = np.linspace(0.0, 3.0, num=9)
    push = {force: SampledInput(t, 4.0 * np.cos(3.0 * t), interpolation=kind)}
    starts = {"initial_conditions": {x: np.linspace(-1.0, 1.0, num=11)}, "specifieds": push}
    events = [Event(x + force / 9.0, name="pushed"), Event(v - 0.9, terminal=True)]
    found = watched(system, events, starts, times=np.linspace(0.0, 3.0, num=7))
    assert set(found.status.values) <= {0, Outcome.TERMINATED}


def test_balls_come_to_rest_in_lanes():
    system = multi_mass_spring_damper(apply_external_forces=True)
    (force,), (x, v) = system.specifieds_symbols, system.states
    system.specifieds, system.times = {force: -9.81}, np.linspace(0.0, 2.0, num=5)
    system.constants = {"k0": 0.0, "c0": 0.0, "m0": 1.0}
    floor = Event(x, direction=-1, reset={v: -0.3 * v}, name="floor")
    heights = {"initial_conditions": {x: np.array([0.0, 0.5, 1.0, 30.0])}}
    found = watched(system, [floor], heights)
    assert found.status.values.tolist()[1:] == [Outcome.EVENTS_ACCUMULATE] * 2 + [0]


@pytest.mark.parametrize(("method", "options"), HELD)
@pytest.mark.parametrize("name", [*LINKAGES, "bead"])
def test_events_on_constraints_have_the_bits_of_the_solver_for_one(name, method, options):
    system = bead() if name == "bead" else linkage(getattr(loops, name))
    if system.specifieds_symbols:
        t = np.linspace(0.0, 3.0, num=9)
        system.specifieds = {"push": SampledInput(t, 9.0 * np.cos(3.0 * t), interpolation="pchip")}
    q, u = system.coordinates[0], system.speeds[0]
    start = float(system.initial_conditions.get(u, 0.0))
    events = [
        Event(q - float(system.initial_conditions[q]), name="there"),  # zero at the beginning
        Event(u - 0.9 * start + 0.1, name="slower", direction=-1),
        Event(sm.sin(9 * q) * u, name="often"),
        Event(u + 3.0 * abs(start) + 4.0, name="slow", terminal=True),
    ]
    values = {"constants": {"g": np.geomspace(1.0, 400.0, num=12)}}
    many = watched(system, events, values, ode_solver=method, constraints="project", **options)
    assert int(many["often_count"].sum()) > 12


def test_events_on_constraints_are_seen_to_in_lanes(monkeypatch):
    """A bead on a circle is a pendulum, whose period is an elliptic integral."""
    alone = []
    monkeypatch.setattr(Batch, "_one_by_one", lambda self, *_: alone.append(len(self.x)))
    system = bead()
    system.specifieds = {"push": 0.0}
    x = next(q for q in system.coordinates if q.name == "x")
    bottom = Event(x, name="bottom", direction=-1)
    gravities = np.linspace(5.0, 15.0, num=21)
    many = system.integrate_ensemble(
        constants={"g": gravities}, constraints="project", ode_solver="dop853",
        rtol=1e-10, atol=1e-10, events=[bottom], reduce=["final", ("events", 9)],
    )  # fmt: skip
    assert not alone
    assert many.attrs["lanes"] == 8
    size = np.arctan2(0.6, 0.8)
    period = 4.0 * np.sqrt(1.0 / gravities) * scipy.special.ellipk(np.sin(size / 2) ** 2)
    times = many["bottom_times"].values
    expected = period[:, None] * (0.25 + np.arange(9))
    expected[expected > 3.0] = np.nan
    np.testing.assert_allclose(times, expected, rtol=1e-8)
