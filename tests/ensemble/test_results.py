"""What `System.integrate_ensemble` takes and returns."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from optional import optional
from pydy.ensemble.model import EnsembleModel
from pydy.errors import PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper
from pydy.solvers import Event
from pydy.solvers.run.lanes import LaneSolver
from pydy.system import System
from zoo import inertial_frame
from zoo.ensemble_cases import constant, pendulum, random_values, same_bits

xr = optional("xarray")


@pytest.fixture
def oscillator():
    """x'' = −k x / m, with the exact solution x0 cos(√(k/m) t)."""
    system = multi_mass_spring_damper()
    system.constants = {constant(system, "c0"): 0.0}
    system.times = np.linspace(0.0, 2.0, num=9)
    return system


def exact(dataset, x0, k):
    return x0 * np.cos(np.sqrt(k) * dataset.time)


def test_a_sample_dimension_and_time_label_the_results(oscillator):
    x, v = oscillator.states
    k = constant(oscillator, "k0")
    oscillator.outputs = {sm.Symbol("energy"): v**2 / 2 + k * x**2 / 2}
    starts, stiffness = np.array([1.0, 2.0, 3.0]), np.array([1.0, 4.0, 9.0])
    results = oscillator.integrate_ensemble(
        initial_conditions={x: starts}, constants={k: stiffness}, rtol=1e-10, units={x: ("m", 1)}
    )
    assert dict(results.sizes) == {"sample": 3, "time": 9}
    assert results.x0.dims == ("sample", "time")
    assert results.x0.attrs == {"role": "coordinate", "latex": "x_{0}", "units": "m"}
    assert results.energy.attrs["role"] == "output"
    np.testing.assert_array_equal(results.initial_x0, starts)
    np.testing.assert_array_equal(results.k0, stiffness)
    assert results.c0.item() == 0.0
    np.testing.assert_allclose(
        results.x0, exact(results, results.initial_x0, results.k0), atol=1e-7
    )
    energy = stiffness * starts**2 / 2.0
    np.testing.assert_allclose(results.energy, np.outer(energy, np.ones(9)), rtol=1e-7)
    assert results.attrs["ode_solver"] == "dop853"
    assert results.attrs["lanes"] == 8


def test_a_product_gives_each_symbol_a_dimension(oscillator):
    x, _ = oscillator.states
    k = constant(oscillator, "k0")
    results = oscillator.integrate_ensemble(
        initial_conditions={x: [1.0, -1.0]}, constants={k: [1.0, 4.0, 9.0]}, product=True
    )
    assert results.x0.dims == ("initial_x0", "k0", "time")
    one = results.x0.sel(initial_x0=-1.0, k0=4.0)
    np.testing.assert_allclose(one, -np.cos(2.0 * results.time), atol=1e-6)


def test_arrays_with_named_dimensions_are_broadcast_by_name(oscillator):
    x, v = oscillator.states
    k = constant(oscillator, "k0")
    starts = xr.DataArray([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]], dims=("row", "col"))
    stiffness = xr.DataArray([1.0, 4.0, 9.0], dims="col", coords={"col": [10, 20, 30]})
    results = oscillator.integrate_ensemble(
        initial_conditions={x: starts, v: 0.0}, constants={k: stiffness}
    )
    assert results.x0.dims == ("row", "col", "time")
    assert results.col.values.tolist() == [10, 20, 30]
    np.testing.assert_allclose(results.x0, exact(results, starts, stiffness), atol=1e-6)
    turned = oscillator.integrate_ensemble(
        initial_conditions={x: starts.transpose("col", "row")}, constants={k: stiffness}
    )
    assert turned.x0.dims == ("col", "row", "time")
    assert same_bits(turned.x0.transpose("row", "col", "time"), results.x0)


def test_numbers_alone_make_one_sample_without_dimensions(oscillator):
    x, _ = oscillator.states
    results = oscillator.integrate_ensemble(initial_conditions={x: 1.0})
    assert results.x0.dims == ("time",)
    np.testing.assert_allclose(results.x0, np.cos(results.time), atol=1e-6)


def test_specifieds_vary_and_the_systems_own_values_fill_the_rest():
    system = multi_mass_spring_damper(apply_external_forces=True)
    (force,) = system.specifieds_symbols
    system.specifieds = {force: lambda x, t: 1 / 0}  # replaced for this call
    results = system.integrate_ensemble(
        specifieds={force: [0.0, 1.0, 2.0]}, times=np.linspace(0.0, 40.0, num=3)
    )
    np.testing.assert_allclose(results.x0[:, -1], [0.0, 1.0, 2.0], atol=1e-6)
    assert results[force.name].dims == ("sample",)


def test_an_expression_is_compiled_into_the_lanes():
    system = multi_mass_spring_damper(apply_external_forces=True)
    (force,) = system.specifieds_symbols
    x, v = system.states
    m = constant(system, "m0")
    times = np.linspace(0.0, 3.0, num=4)
    results = system.integrate_ensemble(
        specifieds={force: x + v}, constants={m: [1.0, 2.0]}, initial_conditions={v: 1.0},
        times=times,
    )  # fmt: skip
    np.testing.assert_allclose(results.x0, np.outer([1.0, 1.0], times), atol=1e-6)


def test_a_python_function_is_called_for_each_sample():
    system = multi_mass_spring_damper(apply_external_forces=True)
    (force,) = system.specifieds_symbols
    x, _ = system.states
    system.outputs = {sm.Symbol("push"): 2 * force}
    times = np.linspace(0.0, 1.0, num=5)
    slow = system.integrate_ensemble(
        specifieds={force: lambda x, t: np.sin(t)}, initial_conditions={x: [0.0, 1.0]}, times=times
    )
    t = sm.Symbol("t")
    fast = system.integrate_ensemble(
        specifieds={force: sm.sin(system.eom_method.q[0].args[0])},
        initial_conditions={x: [0.0, 1.0]},
        times=times,
    )
    assert t.name == "t"
    np.testing.assert_allclose(slow.x0, fast.x0, atol=1e-6)
    np.testing.assert_allclose(slow.push, fast.push, atol=1e-12)
    assert slow.attrs["lanes"] == 1


def test_radau_serves_in_lanes_and_one_by_one_where_states_are_many(oscillator, monkeypatch):
    (x, _), found = oscillator.states, []
    for most in (2, 1):
        monkeypatch.setattr(LaneSolver, "MOST_IMPLICIT_STATES", most)
        values = {"initial_conditions": {x: [1.0, 2.0]}, "ode_solver": "radau"}
        found.append(oscillator.integrate_ensemble(**values))
        assert found[-1].attrs["lanes"] == (8 if most == 2 else 1)
    np.testing.assert_allclose(found[0].x0[1], 2.0 * np.cos(found[0].time), atol=1e-5)
    assert found[0].x0.identical(found[1].x0)


@pytest.mark.parametrize(
    ("solver", "options"), [("dop853", {}), ("radau", {}), ("radau", {"events": True})]
)
def test_samples_share_a_sampled_input_beside_specifieds_that_vary(solver, options):
    """1 kg under F = t, sampled, and G, of each sample, is at G t²/2 + t³/6; one by one, too."""
    x, F, G = me.dynamicsymbols("x F G")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x)
    model = Definition(
        frame, [x], bodies=[me.Particle("mass", point, 1)], loads=[(point, (F + G) * frame.x)]
    )
    push = SampledInput([0.0, 2.0], [0.0, 2.0])
    system = System(model, specifieds={F: push}, outputs={sm.Symbol("load"): F + 2 * G})
    if options:
        options = {"events": [Event(x - 100.0)]}
    varied = np.array([-3.0, 0.0, 5.0])
    results = system.integrate_ensemble(
        specifieds={G: varied}, times=np.linspace(0.0, 2.0, num=5), ode_solver=solver, rtol=1e-9,
        atol=1e-9, **options,
    )  # fmt: skip
    t, each = results.time.to_numpy(), varied[:, None]
    np.testing.assert_allclose(results.x, each * t**2 / 2 + t**3 / 6, atol=1e-7)
    np.testing.assert_allclose(results["load"], t + 2 * each, atol=1e-12)
    several = [push, SampledInput([0.0, 2.0], [1.0, 1.0])]
    with pytest.raises(ValueError, match=r"one SampledInput, which all samples share, got \["):
        system.integrate_ensemble(specifieds={F: several})


# -- reductions -----------------------------------------------------------------------------------


def test_steps_of_a_fixed_size_divide_the_intervals_whatever_is_reduced(oscillator):
    # At 9 times, 0.25 apart, with steps of at most 0.2: 16 steps, where 10 would do without them.
    x, _ = oscillator.states
    given = {"initial_conditions": {x: [1.0, 2.0]}, "ode_solver": "rk4", "step": 0.2}
    final = oscillator.integrate_ensemble(**given, reduce="final")
    whole = oscillator.integrate_ensemble(**given)
    assert final.steps.values.tolist() == [16, 16]
    for state in ("x0", "v0"):
        assert same_bits(final[state], whole[state].isel(time=-1))


def test_the_final_state_is_that_of_the_whole_trajectory_to_the_last_bit():
    system = pendulum()
    values = random_values(system, 50)
    whole = system.integrate_ensemble(**values)
    final = system.integrate_ensemble(**values, reduce="final")
    assert "time" not in final.sizes
    for s in system.states:
        assert same_bits(final[s.name], whole[s.name].isel(time=-1))


@pytest.mark.parametrize("in_lanes", [True, False])
@pytest.mark.parametrize("reduce", ["final", ["final", ("events", 1), ("max", "x0")]])
def test_the_final_state_is_the_one_after_a_terminal_event(
    oscillator, monkeypatch, in_lanes, reduce
):
    x, v = oscillator.states
    k, t = constant(oscillator, "k0"), sm.Symbol("t")
    oscillator.outputs = {sm.Symbol("power"): k * x * v, sm.Symbol("late"): t + x + v}
    if not in_lanes:
        monkeypatch.setattr(EnsembleModel, "in_lanes", False)
    stop = Event(x, direction=-1, terminal=True, reset={v: -v / 2}, name="stop")
    ends = oscillator.integrate_ensemble(
        initial_conditions={x: 1.0}, constants={k: [1.0, 4.0, 0.25]},
        events=stop, reduce=reduce, rtol=1e-11, atol=1e-11,
    )  # fmt: skip
    assert ends.status.values.tolist() == [5, 5, 0]
    # x = cos √k t has its first zero at t = π/(2 √k), where v = −√k; the third does not come there.
    when = np.array([np.pi / 2, np.pi / 4, 2.0])
    at, speed = np.array([0.0, 0.0, np.cos(1.0)]), np.array([0.5, 1.0, -0.5 * np.sin(1.0)])
    np.testing.assert_allclose(ends.end_time, when, atol=1e-9)
    np.testing.assert_allclose(ends.x0, at, atol=1e-9)
    np.testing.assert_allclose(ends.v0, speed, atol=1e-9)
    np.testing.assert_allclose(ends.power, [1.0, 4.0, 0.25] * at * speed, atol=1e-9)
    np.testing.assert_allclose(ends.late, when + at + speed, atol=1e-9)


def test_an_output_that_is_undefined_after_a_terminal_event_is_warned_of(oscillator):
    x, v = oscillator.states
    oscillator.outputs = {sm.Symbol("inverse"): 1 / (v + 0.5)}
    stop = Event(x, direction=-1, terminal=True, reset={v: -sm.S.Half})
    with pytest.warns(PyDyUserWarning, match=r"inverse"):
        ends = oscillator.integrate_ensemble(
            initial_conditions={x: [1.0, 2.0]}, events=stop, reduce="final"
        )
    assert np.isinf(ends.inverse).all()


def test_extremes_are_those_at_the_times():
    system = pendulum()
    q = system.coordinates[1]
    system.outputs = {sm.Symbol("height"): sm.cos(q)}
    values = random_values(system, 20)
    whole = system.integrate_ensemble(**values)
    reduced = system.integrate_ensemble(**values, reduce=[("max", "height"), ("min", q), "final"])
    assert same_bits(reduced.height_max, whole.height.max("time"))
    assert same_bits(reduced.q1_min, whole.q1.min("time"))
    assert same_bits(reduced.height, whole.height.isel(time=-1))


@pytest.mark.parametrize(
    ("reduce", "t"), [(None, r"0\.0"), ("final", r"2\.0"), (("max", "inverse"), r"0\.0")]
)
def test_outputs_that_are_not_finite_are_told_once(oscillator, reduce, t):
    x = oscillator.coordinates[0]
    oscillator.outputs = {sm.Symbol("inverse"): 1 / x}
    told = rf"not finite: inverse at t = {t} in the state x0 = 0, v0 = 0; the same at \d+ other"
    with pytest.warns(PyDyUserWarning, match=told) as caught:
        oscillator.integrate_ensemble(initial_conditions={x: [1.0] + 99 * [0.0]}, reduce=reduce)
    assert len(caught) == 1
    with pytest.warns(PyDyUserWarning, match="not finite: inverse"):
        oscillator.simulate()


def test_a_function_reduces_the_dataset_of_a_block():
    system = pendulum()
    values = random_values(system, 30)
    whole = system.integrate_ensemble(**values)

    def spread(dataset):
        return (dataset.q1.max("time") - dataset.q1.min("time")).rename("spread")

    for chunks in (None, 7):
        reduced = system.integrate_ensemble(**values, reduce=spread, chunks=chunks).compute()
        assert same_bits(reduced.spread, whole.q1.max("time") - whole.q1.min("time"))
        assert same_bits(reduced.steps, whole.steps)


def test_a_function_that_drops_samples_is_refused():
    system = pendulum()
    with pytest.raises(ValueError, match="must keep the sample dimensions sample"):
        system.integrate_ensemble(
            **random_values(system, 3), reduce=lambda dataset: dataset.mean("sample")
        )


def halves(dataset):
    """Whether these are the first of the samples 0 to 199."""
    return float(dataset.initial_x0.max()) < 100.0


DIFFERENT = [
    (lambda d: d[["x0", "v0"] if halves(d) else ["x0"]], "`v0` exists for some samples only"),
    (lambda d: d[["x0"] if halves(d) else ["x0", "v0"]], "`v0` exists for some samples only"),
    (
        lambda d: d.x0[:, : 2 if halves(d) else 1].rename(time="k").to_dataset(),
        r"`x0` is float64 along \{'k': 2\} for some, float64 along \{'k': 1\} for others",
    ),
    (
        lambda d: (d.steps if halves(d) else d.steps + 0.5).to_dataset(name="work"),
        "`work` is int64 for some, float64 for others",
    ),
]


@pytest.mark.parametrize("way", ["memory", "chunks", "store"])
@pytest.mark.parametrize(("reduce", "message"), DIFFERENT)
def test_results_that_differ_from_block_to_block_are_refused(
    oscillator, tmp_path, way, reduce, message
):
    x, _ = oscillator.states
    options = {"initial_conditions": {x: np.arange(200.0)}, "reduce": reduce, "workers": 1}
    if way != "memory":
        options["chunks"] = 100
    if way == "store":
        options["store"] = tmp_path / "s.zarr"
    with pytest.raises(ValueError, match=message):
        oscillator.integrate_ensemble(**options).compute()


@pytest.mark.parametrize(
    ("reduce", "name"),
    [
        (lambda d: d[["x0"]].sortby("initial_x0", ascending=False), "initial_x0"),
        (lambda d: d[["x0"]].isel(time=slice(None, None, -1)), "time"),
        (lambda d: d[["x0"]].isel(time=[0, 2]), "time"),
        (lambda d: d[["x0"]].isel(time=[0, 2]).drop_vars("time"), "time"),
    ],
)
def test_a_function_that_moves_samples_or_times_is_refused(oscillator, reduce, name):
    x, _ = oscillator.states
    with pytest.raises(ValueError, match=f"leave samples and times in their places: `{name}`"):
        oscillator.integrate_ensemble(initial_conditions={x: np.arange(20.0)}, reduce=reduce)


def test_event_times_are_kept_for_each_sample(oscillator):
    x, _ = oscillator.states
    k = constant(oscillator, "k0")
    stiffness = np.array([1.0, 4.0, 9.0])
    options = {"initial_conditions": {x: 1.0}, "constants": {k: stiffness}, "rtol": 1e-10}
    results = oscillator.integrate_ensemble(
        **options,
        times=[0.0, 7.0],
        events=[Event(x, direction=-1, name="down")],
        reduce=("events", 2),
    )
    down = (np.pi / 2.0 + 2.0 * np.pi * np.arange(4)) / np.sqrt(stiffness)[:, None]
    np.testing.assert_allclose(
        results.down_times, np.where(down < 7.0, down, np.nan)[:, :2], rtol=1e-8
    )
    assert results.down_count.values.tolist() == (down < 7.0).sum(axis=1).tolist()


def test_a_terminal_event_leaves_nan_and_says_so(oscillator):
    x, _ = oscillator.states
    results = oscillator.integrate_ensemble(
        initial_conditions={x: [1.0, 2.0]}, events=[Event(x - 1.5, direction=-1, terminal=True)]
    )
    assert results.status.values.tolist() == [0, 5]
    assert np.isfinite(results.x0[0]).all()
    late = results.time > np.arccos(0.75)
    np.testing.assert_array_equal(np.isnan(results.x0[1]), late)


# -- errors, before anything runs -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "error", "match"),
    [
        ({"initial_conditions": {"x": [1.0, 2.0], "v": [1.0]}}, ValueError, "1 values along"),
        ({"initial_conditions": {"x": np.ones((2, 2))}}, ValueError, "xarray.DataArray"),
        ({"initial_conditions": {"x": [1.0, np.nan]}}, ValueError, r"must be finite, got nan at"),
        ({"initial_conditions": {"x": []}}, ValueError, "must not be empty"),
        ({"initial_conditions": {"q": [1.0]}}, ValueError, "not one of the states"),
        ({"constants": {"q": [1.0]}}, ValueError, "not one of the constants"),
        ({"specifieds": {"q": [1.0]}}, ValueError, "not one of the specifieds"),
        ({"times": [1.0]}, ValueError, "at least two values"),
        ({"times": [1.0, 0.0]}, ValueError, "`times` descend, from 1.0 to 0.0, but ensembles"),
        ({"ode_solver": "odeint"}, ValueError, "must be a native solver"),
        ({"rtoll": 1e-3}, TypeError, "`dop853` has no option `rtoll`"),
        ({"rtol": 1e-17, "atol": 0.0}, ValueError, "ten times the rounding unit"),
        ({"rtol": [1e-3]}, ValueError, r"have the shape \(2,\)"),
        ({"reduce": "mean"}, ValueError, "`reduce` must be 'final'"),
        ({"reduce": ("max", "speed")}, ValueError, "neither a state nor an output: x0, v0"),
        ({"reduce": "events"}, ValueError, "needs `events`"),
        ({"workers": 0}, ValueError, "`workers` must be a whole number from 1 on"),
        ({"chunks": 0}, ValueError, "positive whole number"),
        ({"chunks": {"row": 3}}, ValueError, "not one of the sample dimensions"),
        ({"units": {"weight": "kg"}}, ValueError, "neither a state nor an output"),
        ({"units": {"x0": "m", "x0(t)": "cm"}}, ValueError, "`units` gives `x0` more than once"),
        ({"units": {"x0": "deg"}}, ValueError, r"is 'deg', .* not converted.* pass `\('deg', 1\)`"),
        ({"units": {"x0": ("mm", 1e3)}}, ValueError, r"`units\[x0\]` is \('mm', 1000.0\), but a"),
        ({"resume": True}, ValueError, "needs `store`"),
        ({"constraints": "project"}, ValueError, "the system has none"),
    ],
)  # fmt: skip
def test_errors_name_the_argument(oscillator, arguments, error, match):
    x, v = oscillator.states
    names = {"x": x, "v": v, "q": sm.Symbol("q")}
    arguments = {
        key: {names.get(k, k): a for k, a in value.items()}
        if key in ("initial_conditions", "constants", "specifieds")
        else value
        for key, value in arguments.items()
    }
    with pytest.raises(error, match=match):
        oscillator.integrate_ensemble(**arguments)


def test_a_dimension_must_not_be_called_like_a_result(oscillator):
    x, _ = oscillator.states
    with pytest.raises(ValueError, match="the name of a variable of the result"):
        oscillator.integrate_ensemble(initial_conditions={x: xr.DataArray([1.0, 2.0], dims="x0")})


@pytest.mark.parametrize("labels", [{}, {"coords": {"c0": [5.0, 6.0]}}])
def test_a_dimension_called_like_what_does_not_vary_along_it_is_refused(oscillator, labels):
    # Labels 5 and 6 would stand for values of c0, which is 1 in all samples.
    stiff = xr.DataArray([1.0, 2.0], dims="c0", **labels)
    with pytest.raises(ValueError, match="the dimension `c0`, but that is the name of `c0`"):
        oscillator.integrate_ensemble(constants={"k0": stiff})
    varied = {"k0": stiff, "c0": xr.DataArray([5.0, 6.0], dims="c0")}
    assert oscillator.integrate_ensemble(constants=varied)["c0"].values.tolist() == [5.0, 6.0]


def test_labels_of_one_dimension_must_agree(oscillator):
    x, v = oscillator.states
    a = xr.DataArray([1.0, 2.0], dims="run", coords={"run": [0, 1]})
    b = xr.DataArray([1.0, 2.0], dims="run", coords={"run": [1, 0]})
    with pytest.raises(ValueError, match="labels must agree"):
        oscillator.integrate_ensemble(initial_conditions={x: a, v: b})


@pytest.mark.parametrize("name", ["status", "steps", "end_time", "time", "occurrence"])
def test_an_output_with_a_name_of_the_result_is_refused(oscillator, name):
    oscillator.outputs = {name: 2 * oscillator.states[0]}
    with pytest.raises(ValueError, match=f"has a variable or dimension `{name}` of its own"):
        oscillator.integrate_ensemble(constants={"k0": [1.0, 4.0]})


def test_an_output_named_like_a_start_is_kept_apart(oscillator):
    x, _ = oscillator.states
    oscillator.outputs = {"initial_x0": 2 * x}
    results = oscillator.integrate_ensemble(initial_conditions={x: [1.0, 3.0]})
    np.testing.assert_array_equal(results["initial_x0 (state)"], [1.0, 3.0])
    np.testing.assert_array_equal(results["initial_x0"], 2 * results.x0)


def test_reductions_that_would_overwrite_each_other_are_refused(oscillator):
    x, v = oscillator.states
    oscillator.outputs = {"x0_max": 2 * x, "stop_times": v}
    with pytest.raises(ValueError, match="`reduce` gives two results the name `x0_max`"):
        oscillator.integrate_ensemble(constants={"k0": [1.0]}, reduce=["final", ("max", x)])
    with pytest.raises(ValueError, match="`reduce` gives two results the name `stop_times`"):
        oscillator.integrate_ensemble(
            constants={"k0": [1.0]}, reduce=["events", "final"], events=[Event(v, name="stop")]
        )
    with pytest.raises(ValueError, match="`reduce` asks for `x0` twice"):
        oscillator.integrate_ensemble(constants={"k0": [1.0]}, reduce=["final", "final"])


def test_series_of_another_order_are_refused_as_arrays_are():
    pandas = pytest.importorskip("pandas")
    system = multi_mass_spring_damper()
    system.times = [0.0, 1.0]
    one = pandas.Series([1.0, 2.0, 3.0], index=[0, 1, 2])
    other = pandas.Series([3.0, 2.0, 1.0], index=[2, 1, 0])
    with pytest.raises(ValueError, match=r"k0.* another index than .*m0.* `.to_numpy\(\)`"):
        system.integrate_ensemble(constants={"m0": one, "k0": other}, reduce="final")
    system.integrate_ensemble(constants={"m0": one, "k0": other.sort_index()}, reduce="final")
    system.integrate_ensemble(constants={"m0": one, "k0": other.to_numpy()}, reduce="final")
    grid = {"m0": one, "k0": other}
    system.integrate_ensemble(constants=grid, reduce="final", product=True)
