"""Sensitivities of ensembles: those of single simulations, wherever they are computed."""

import pickle
import subprocess
import sys

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.ensemble.engine import Ensemble
from pydy.errors import PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.solvers import Event
from pydy.solvers.outcome import Outcome
from pydy.system import System
from zoo import inertial_frame
from zoo.ball import bouncing_ball
from zoo.cases import system_of
from zoo.ensemble_cases import constant, identical, pendulum, runaway, same_bits

FINE = {"rtol": 1e-9, "atol": 1e-9}
NAMES = ["m1", "q1", "l0"]


def swinging(**options):
    system = pendulum(2, **options)
    system.initial_conditions = {"q1": 0.4, "u2": -0.3}
    system.ode_solver = "dop853"
    return system


def singly(system, symbol, values, wanted, kind="constants", **options):
    """The trajectories of `simulate`, one for each value."""
    found = []
    for value in values:
        setattr(system, kind, {**getattr(system, kind), symbol: value})
        found.append(system.simulate(sensitivities=wanted, **options))
    return found


@pytest.mark.parametrize(
    ("method", "options"),
    [
        ("dop853", FINE),
        ("dop853", {**FINE, "control_sensitivities": True}),
        ("tsit5", FINE),
        ("rk4", {"step": 0.01}),
        ("radau", {"rtol": 1e-7, "atol": 1e-7}),
    ],
)
def test_each_trajectory_has_the_sensitivities_of_a_single_simulation(method, options):
    system, masses = swinging(), [0.5, 1.0, 1.7]
    system.outputs = {sm.Symbol("height"): sm.cos(system.coordinates[1])}
    many = system.integrate_ensemble(
        constants={"m1": masses}, sensitivities=NAMES, ode_solver=method, **options
    )
    system.ode_solver = method
    assert many.sensitivity.dims == ("sample", "time", "quantity", "parameter")
    assert many.parameter.values.tolist() == NAMES
    for k, one in enumerate(singly(system, "m1", masses, NAMES, **options)):
        sample = many.isel(sample=k)
        assert sample.quantity.values.tolist() == list(one.sensitivity.quantities)
        table = one.sensitivity.table()
        assert np.abs(sample.sensitivity - table).max() < 1e-12 * np.abs(table).max()
        assert np.abs(sample.q1 - one["q1"]).max() < 1e-12
        assert int(sample.steps) == one.statistics["steps"]
        if many.attrs["lanes"] > 1:
            assert same_bits(sample.sensitivity[:, :6], one.sensitivity.values)
    in_lanes = method != "radau" and "control_sensitivities" not in options
    assert many.attrs["lanes"] == (8 if in_lanes else 1)


@pytest.mark.parametrize("wanted", [["m1"], ["m0", "q1", "u1"], "constants", ["q2"]])
def test_lanes_have_the_bits_of_single_simulations(wanted):
    system = swinging()
    lengths = np.linspace(0.7, 1.3, 11)
    many = system.integrate_ensemble(constants={"l1": lengths}, sensitivities=wanted, **FINE)
    assert many.attrs["lanes"] == 8
    for k, one in enumerate(singly(system, "l1", lengths, wanted, **FINE)):
        assert same_bits(many.sensitivity[k], one.sensitivity.values)
        assert same_bits(many.u2[k], one["u2"])


def test_fewer_initial_conditions_after_more_are_as_many_columns():
    """By initial conditions alone the columns have no direction in the inputs, however many."""
    system = swinging()
    run = {"constants": {"l1": np.linspace(0.7, 1.3, 9)}, **FINE}
    every = system.integrate_ensemble(sensitivities="states", **run)
    two = system.integrate_ensemble(sensitivities=["q1", "u2"], **run)
    assert same_bits(two.sensitivity, every.sensitivity.sel(parameter=["q1", "u2"]))


def test_an_infinite_derivative_of_an_output_spoils_no_other():
    system = multi_mass_spring_damper(1)
    system.times, system.ode_solver = np.linspace(0.0, 1.0, 5), "dop853"
    (damping,) = (c for c in system.constants_symbols if c.name.startswith("c"))
    system.constants, system.initial_conditions = {damping: 0.0}, {"x0": 1.0}
    system.outputs = {sm.Symbol("o"): sm.sqrt(damping) * system.states[0]}
    wanted = ["m0", "k0", damping]
    one = system.simulate(sensitivities=wanted).sensitivity.table()[1, -1]
    many = system.integrate_ensemble(constants={"k0": [1.0, 2.0]}, sensitivities=wanted)
    for found in (one, many.sensitivity.sel(quantity="o").values[0, 1]):
        assert np.isfinite(found).tolist() == [True, True, False]
        assert (found[:2] == 0.0).all()


def test_parameters_that_vary_are_differentiated_by_where_they_are():
    system = swinging()
    sizes = np.linspace(0.8, 1.2, 81)
    many = system.integrate_ensemble(constants={"l0": sizes}, sensitivities="l0", **FINE)
    ends = many.isel(time=-1)
    slopes = np.gradient(ends.q2.values, sizes, edge_order=2)[1:-1]
    found = ends.sensitivity.sel(quantity="q2", parameter="l0").values[1:-1]
    assert np.abs(found - slopes).max() < 2e-3 * np.abs(slopes).max()


def test_dimensions_of_a_product_come_first():
    system = swinging()
    grid = system.integrate_ensemble(
        constants={"m1": [0.5, 1.0]},
        initial_conditions={"q1": [0.1, 0.2, 0.3]},
        sensitivities=["q1"],
        product=True,
    )
    assert grid.sensitivity.dims == ("initial_q1", "m1", "time", "quantity", "parameter")
    assert (grid.sensitivity.sel(quantity="q1", parameter="q1").isel(time=0) == 1.0).all()


def test_samples_of_an_input_are_parameters():
    system = multi_mass_spring_damper(1, apply_external_forces=True)
    system.times, system.ode_solver = np.linspace(0.0, 4.0, 9), "dop853"
    system.specifieds = {"f0": SampledInput([0.0, 1.0, 2.5, 4.0], [0.0, 0.0, 0.0, 0.0])}
    stiffness, wanted = [1.0, 2.0], ["f0", "k0"]
    many = system.integrate_ensemble(constants={"k0": stiffness}, sensitivities=wanted, **FINE)
    assert many.parameter.values.tolist() == ["f0[0]", "f0[1]", "f0[2]", "f0[3]", "k0"]
    for k, one in enumerate(singly(system, "k0", stiffness, wanted, **FINE)):
        assert np.abs(many.sensitivity[k].values - one.sensitivity.values).max() < 1e-12


@pytest.mark.parametrize(("rise", "end"), [(1 + zoo.T, None), (zoo.T**2, 1.2)])
def test_constraints_of_each_sample_have_its_own_specified_beside_samples(rise, end):
    """1 kg at y = a h f(t), with h of each sample, pushed by F = t, sampled: x = t³/6, dy/da = h f.

    What an event ends early is examined sample by sample. With another sample's h it would leave
    f = t², which begins at rest.
    """
    x, y, F, h = me.dynamicsymbols("x y F h")
    a = sm.Symbol("a")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x + y * frame.y)
    model = Definition(
        frame,
        [x, y],
        bodies=[me.Particle("mass", point, 1)],
        loads=[(point, F * frame.x)],
        holonomic_constraints=[y - a * h * rise],
    )
    push = SampledInput([0.0, 2.0], [0.0, 2.0])
    system = System(model, {a: 2.0}, specifieds={F: push}, times=np.linspace(0.0, 2.0, 5))
    system.ode_solver = "dop853"
    given = np.array([1.0, 2.0, -3.0])
    height, speed = (2.0 * given * float(f.subs(zoo.T, 0)) for f in (rise, rise.diff(zoo.T)))
    events = [] if end is None else [Event(x - end**3 / 6.0, terminal=True)]
    results = system.integrate_ensemble(
        specifieds={h: given}, initial_conditions={y: height, system.states[3]: speed},
        sensitivities=[a], events=events, **FINE,
    )  # fmt: skip
    expected = Outcome.FINISHED if end is None else Outcome.TERMINATED
    assert results.status.values.tolist() == [expected] * 3
    reached = results.time.to_numpy() <= (2.0 if end is None else end)
    t = results.time.to_numpy()[reached]
    each = given[:, None] * sm.lambdify(zoo.T, rise)(t)
    np.testing.assert_allclose(results.x[:, reached], [t**3 / 6.0] * 3, atol=1e-8)
    np.testing.assert_allclose(results.y[:, reached], 2.0 * each, atol=1e-8)
    slopes = results.sensitivity.sel(quantity="y", parameter="a").values[:, reached]
    np.testing.assert_allclose(slopes, each, atol=1e-8)


def test_a_specified_that_varies_is_a_parameter():
    system = multi_mass_spring_damper(1, apply_external_forces=True)
    system.times, system.ode_solver = np.linspace(0.0, 4.0, 9), "dop853"
    forces = [0.0, 3.0]
    many = system.integrate_ensemble(
        specifieds={"f0": forces}, sensitivities=["f0"], control_sensitivities=True, **FINE
    )
    options = {**FINE, "control_sensitivities": True, "kind": "specifieds"}
    for k, one in enumerate(singly(system, "f0", forces, ["f0"], **options)):
        assert np.abs(many.sensitivity[k].values - one.sensitivity.values).max() < 1e-12


# -- events and constraints -----------------------------------------------------------------------


def test_events_move_sensitivities_and_have_them():
    system, bounce = bouncing_ball(d=0.0)
    wanted, heights = ["e", "g", "q"], [0.5, 1.0]
    run = {"initial_conditions": {"q": heights}, "sensitivities": wanted, "events": [bounce]}
    many = system.integrate_ensemble(**run, **FINE)
    timed = system.integrate_ensemble(**run, reduce=["final", ("events", 3)], **FINE)
    moments = timed.bounce_times_sensitivity
    assert moments.dims == ("sample", "occurrence", "parameter")
    options = {"kind": "initial_conditions", "events": [bounce], **FINE}
    for k, one in enumerate(singly(system, "q", heights, wanted, **options)):
        assert np.abs(many.sensitivity[k].values - one.sensitivity.table()).max() < 1e-11
        assert same_bits(timed.sensitivity[k], many.sensitivity[k, -1])
        own = np.full((3, 3), np.nan)
        for j, event in enumerate(one.events[:3]):
            own[j] = event.time_sensitivity
        np.testing.assert_allclose(moments[k].values, own, rtol=1e-11)


def test_a_motion_that_grazes_fails_alone():
    system, _ = bouncing_ball(d=0.0)
    q = system.coordinates[0]
    system.initial_conditions = {"q": 0.1}
    apex = 0.1 + 1.0 / (2.0 * 9.81)
    touch = Event(q - apex + 1e-6, terminal=True, name="touch")
    loose = {"rtol": 1e-4, "atol": 1e-4, "max_step": 1e-3}
    many = system.integrate_ensemble(
        initial_conditions={"u": [0.5, 1.0]},
        times=[0.0, 0.02, 0.15],
        sensitivities="g",
        events=touch,
        **loose,
    )
    assert many.status.values.tolist() == [0, 15]
    assert np.isfinite(many.sensitivity[1, :2]).all()
    assert np.isnan(many.sensitivity[1, 2]).all()


@pytest.mark.parametrize(
    "held", [{}, {"constraints": "project"}, {"constraints": "baumgarte", "gain": 5.0}]
)
def test_dependent_initial_conditions_follow_in_each_sample(held):
    model = zoo.fourbar()
    system = system_of(model, times=np.linspace(0.0, 1.0, 3), ode_solver="dop853")
    system.set_dependent_initial_conditions(use_jac=True, tol=1e-15)
    wanted, masses, mass = ["la", "m1", "q1", "u1"], [0.7, 1.4], constant(system, "m1")
    many = system.integrate_ensemble(constants={mass: masses}, sensitivities=wanted, **held, **FINE)
    for k, one in enumerate(singly(system, mass, masses, wanted, **held, **FINE)):
        table = one.sensitivity.table()
        assert np.abs(many.sensitivity[k].values - table).max() < 1e-11 * np.abs(table).max()


@pytest.fixture
def linkage():
    """A four-bar linkage, and the name of the bar whose length decides what follows."""
    system = system_of(zoo.fourbar(), times=np.linspace(0.0, 1.0, 3), ode_solver="dop853")
    system.set_dependent_initial_conditions(use_jac=True, tol=1e-15)
    return system, constant(system, "lb")


def with_one_lost(linkage, length, held, **options):
    """Nine samples, and nine of which the third does not say how its dependent states follow."""
    system, bar = linkage
    run = {"sensitivities": ["la", "q1"], **held, **FINE, **options}
    lengths = np.full(9, system.constants[bar])
    expected = system.integrate_ensemble(constants={bar: lengths}, **run)
    lengths[2] = length
    run["constants"] = {bar: lengths}
    return expected, run


HELD = [{}, {"constraints": "project"}, {"constraints": "baumgarte", "gain": 5.0}]
LOST = "In one sample or more, `sensitivities` needs"


@pytest.mark.filterwarnings("ignore:The initial conditions of sample 2")
@pytest.mark.parametrize("held", HELD)
@pytest.mark.parametrize("length", [0.0, 1e308])
def test_a_sample_whose_dependent_conditions_are_not_determined_fails_alone(linkage, held, length):
    """A bar of length zero has no direction; the numbers of one of 1e308 m overflow."""
    expected, run = with_one_lost(linkage, length, held)
    with pytest.warns(PyDyUserWarning, match=LOST):
        many = linkage[0].integrate_ensemble(**run)
    others = np.arange(9) != 2
    for name in expected.data_vars:
        assert same_bits(many[name][others], expected[name][others]), name
    assert int(many.status[2]) == Outcome.DEPENDENTS_NOT_GIVEN
    assert [int(many[name][2]) for name in ("steps", "rejected", "evaluations")] == [0, 0, 0]
    assert float(many.end_time[2]) == 0.0
    assert np.isnan(many.sensitivity[2]).all()
    assert float(many.q1[2, 0]) == linkage[0].initial_conditions[linkage[0].coordinates[0]]
    assert np.isnan(many.q1[2, 1:]).all()


@pytest.mark.filterwarnings("ignore:The initial conditions of sample")
def test_samples_that_are_all_lost_are_an_ensemble(linkage):
    system, bar = linkage
    touch = Event(system.coordinates[0] - 2, name="touch")
    for events in (None, touch):
        with pytest.warns(PyDyUserWarning, match=LOST):
            many = system.integrate_ensemble(
                constants={bar: [0.0, 0.0]},
                sensitivities="la",
                events=events,
                reduce=["final"] if events is None else ["final", "events"],
            )
        assert many.status.values.tolist() == [Outcome.DEPENDENTS_NOT_GIVEN] * 2
        assert np.isnan(many.sensitivity).all()
    assert many.touch_count.values.tolist() == [0, 0]


@pytest.mark.filterwarnings("ignore:The initial conditions of sample 2")
@pytest.mark.filterwarnings(f"ignore:{LOST}")
@pytest.mark.parametrize("held", HELD[:2])
def test_lost_samples_are_the_same_in_blocks_stores_and_reductions(linkage, held, tmp_path):
    pytest.importorskip("dask")
    pytest.importorskip("zarr")
    system, _ = linkage
    _, run = with_one_lost(linkage, 0.0, held)
    whole = system.integrate_ensemble(**run)
    identical(system.integrate_ensemble(**run, chunks=2).compute(), whole)
    written = {**run, "chunks": 2, "store": tmp_path / "s.zarr"}
    identical(system.integrate_ensemble(**written).load(), whole)
    for block in (0, 1):
        (tmp_path / f"s.zarr/status/c/{block}").unlink()
    identical(system.integrate_ensemble(**written, resume=True).load(), whole)
    ends = system.integrate_ensemble(**run, reduce=["final", ("max", "q1")])
    last = whole.isel(time=-1)
    assert same_bits(ends.sensitivity[:, :-1], last.sensitivity)
    assert np.isnan(ends.sensitivity[2]).all()
    assert same_bits(ends.status, whole.status)


# -- what is kept, and where ----------------------------------------------------------------------


def test_reductions_have_the_sensitivities_of_what_they_keep():
    system, run = swinging(), {"constants": {"m1": [0.5, 1.0, 1.7]}, "sensitivities": NAMES}
    whole = system.integrate_ensemble(**run, **FINE)
    extremes = [("min", "u2"), ("max", "u2"), ("min", "q1"), ("max", "q1")]
    some = system.integrate_ensemble(**run, reduce=["final", *extremes], **FINE)
    labels = [f"{name}_{kind}" for kind, name in extremes]
    assert some.quantity.values.tolist() == [*whole.quantity.values.tolist(), *labels]
    assert same_bits(some.sensitivity[:, :6], whole.sensitivity.isel(time=-1))
    # The lowest value of some is farther from zero than their highest.
    assert any((-whole[q].min("time") > whole[q].max("time")).any() for q in ("u2", "q1"))
    for label, (kind, name) in zip(labels, extremes, strict=True):
        curve = whole[name]
        place = curve.argmin("time") if kind == "min" else curve.argmax("time")
        expected = whole.sensitivity.sel(quantity=name).isel(time=place)
        assert same_bits(some.sensitivity.sel(quantity=label), expected)


def test_a_function_gets_them_with_their_labels():
    system = swinging()

    def by_mass(dataset):
        return dataset.sensitivity.sel(parameter="m1").max("time")

    run = {"constants": {"m1": [0.5, 1.0]}, "sensitivities": NAMES}
    found = system.integrate_ensemble(**run, reduce=by_mass)
    assert found.sensitivity.dims == ("sample", "quantity")
    whole = system.integrate_ensemble(**run)
    assert same_bits(found.sensitivity.sel(quantity="q2"), by_mass(whole).sel(quantity="q2"))
    with pytest.raises(ValueError, match="`quantity` differs in what it returns"):
        system.integrate_ensemble(
            **run, reduce=lambda dataset: dataset.sensitivity.isel(quantity=[0, 1])
        )


def test_a_sample_that_fails_leaves_the_others_alone():
    system, x, v, mass = runaway()
    speeds = [0.1, 1.0, 0.2]
    wanted = [mass, v, x]
    many = system.integrate_ensemble(initial_conditions={v: speeds}, sensitivities=wanted)
    assert many.status.values.tolist() == [0, 2, 0]
    before = many.time < 1.0
    assert np.isfinite(many.sensitivity[1][before]).all()
    assert np.isnan(many.sensitivity[1][many.time > 1.0]).all()
    # x' = v0 / (1 − v0 t / m): its derivative by v0 is 1 / (1 − v0 t / m)².
    exact = 1.0 / (1.0 - np.outer([0.1, 0.2], many.time)) ** 2
    found = many.sensitivity.sel(quantity=v.name, parameter=v.name).isel(sample=[0, 2])
    np.testing.assert_allclose(found, exact, rtol=1e-5)


@pytest.fixture(scope="module")
def reference():
    system = swinging()
    run = {"constants": {"m1": np.linspace(0.5, 1.5, 10)}, "sensitivities": NAMES}
    return system, run, system.integrate_ensemble(**run)


def test_blocks_threads_and_tasks_change_no_bit(reference):
    pytest.importorskip("dask")
    system, run, whole = reference
    identical(system.integrate_ensemble(**run, chunks=3).compute(), whole)
    identical(system.integrate_ensemble(**run, workers=1), whole)


def test_stores_resume_and_know_which_sensitivities_they_hold(reference, tmp_path):
    pytest.importorskip("zarr")
    system, run, whole = reference
    run = {**run, "chunks": 3, "store": tmp_path / "s.zarr"}
    written = system.integrate_ensemble(**run).load()
    identical(written, whole)
    (tmp_path / "s.zarr/status/c/1").unlink()
    identical(system.integrate_ensemble(**run, resume=True).load(), whole)
    for other in (["m1", "q1"], ["m1", "l0", "q1"], None):
        with pytest.raises(ValueError, match="was written by another ensemble"):
            system.integrate_ensemble(**{**run, "sensitivities": other}, resume=True)
    with pytest.raises(ValueError, match="was written by another ensemble"):
        system.integrate_ensemble(**run, control_sensitivities=True, resume=True)


def test_work_with_sensitivities_travels_without_sympy(reference, monkeypatch, tmp_path):
    system, _ = bouncing_ball(d=0.0)
    bounce = Event(system.coordinates[0], direction=-1, terminal=True)
    taken = []
    monkeypatch.setattr(Ensemble, "run", lambda self: taken.append(self))
    run = {"initial_conditions": {"q": [0.5, 1.0]}, "sensitivities": ["g", "e"]}
    system.integrate_ensemble(**run, events=bounce)
    monkeypatch.undo()
    given, found = tmp_path / "work.pickle", tmp_path / "found"
    given.write_bytes(pickle.dumps((taken[0].work, taken[0].samples)))
    code = (
        "import pickle, sys; from pathlib import Path\n"
        "work, samples = pickle.loads(Path(sys.argv[1]).read_bytes())\n"
        "table = work(samples)['sensitivity'].values\n"
        "assert 'sympy' not in sys.modules\n"
        "Path(sys.argv[2]).write_bytes(table.tobytes())\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, given, found], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    here = system.integrate_ensemble(**run, events=bounce).sensitivity.values
    assert found.read_bytes() == here.tobytes()


# -- what is refused ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("force", "wanted"),
    [
        (0.0, ["mass"]),
        (0.0, ["m0", "m0"]),
        (0.0, []),
        (lambda x, t: 0.0, "m0"),
        (sm.sin(me.dynamicsymbols._t), "f0"),
    ],
)
def test_what_is_refused_is_refused_in_the_words_of_simulate(force, wanted):
    system = multi_mass_spring_damper(1, apply_external_forces=True)
    system.times, system.ode_solver = [0.0, 1.0], "dop853"
    system.specifieds = {"f0": force}
    with pytest.raises(ValueError, match="`sensitivities`") as single:
        system.simulate(sensitivities=wanted)
    with pytest.raises(ValueError, match="`sensitivities`") as many:
        system.integrate_ensemble(sensitivities=wanted)
    assert str(many.value) == str(single.value)


def test_dependent_initial_conditions_are_refused_in_the_words_of_simulate():
    system = system_of(zoo.fourbar(), times=np.linspace(0.0, 1.0, 3), ode_solver="dop853")
    system.set_dependent_initial_conditions(use_jac=True, tol=1e-15)
    with pytest.raises(ValueError, match="follows from the others") as single:
        system.simulate(sensitivities=["q2"])
    with pytest.raises(ValueError, match="follows from the others") as many:
        system.integrate_ensemble(sensitivities=["q2"])
    assert str(many.value) == str(single.value)


def test_a_quantity_with_the_name_of_a_dimension_is_refused():
    system = n_link_pendulum_on_cart(1)
    system.outputs = {sm.Symbol("quantity"): system.coordinates[0]}
    with pytest.raises(ValueError, match="variable or dimension `quantity` of its own"):
        system.integrate_ensemble(times=[0.0, 1.0], sensitivities=["m1"])


@pytest.mark.parametrize("reduce", [("max", "some"), ("min", "some"), "final", None])
def test_an_output_that_is_nan_has_no_sensitivity(reduce):
    system = swinging()
    angle = system.coordinates[0]
    # One sample has a value at all times, one has none; 0/0 in neither.
    gate = sm.Piecewise((angle, sm.Symbol("gate") > 0))
    system.outputs = {sm.Symbol("some"): gate}
    with pytest.warns(PyDyUserWarning, match="not finite: some"):
        many = system.integrate_ensemble(
            constants={"gate": [1.0, -1.0]}, sensitivities=["m1", "q1"], reduce=reduce, **FINE
        )
    name = f"some_{reduce[0]}" if isinstance(reduce, tuple) else "some"
    found = many.sensitivity.sel(quantity=name).values
    assert np.isfinite(found[0]).all()
    assert np.isnan(found[1]).all()
    if reduce == "final":
        assert np.isfinite(many.sensitivity.sel(quantity="q1").values).all()
