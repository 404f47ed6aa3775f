"""The labelled result of a simulation."""

import copy
import pickle
import re
import subprocess
import sys

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import solve_ivp

import zoo
from pydy._dataset import write_netcdf
from pydy.inputs import SampledInput
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.plot import plot_energy, plot_phase, plot_sensitivities
from pydy.solvers import Event
from pydy.system import System
from pydy.trajectory import EventRecord, Trajectory
from zoo.cases import system_of

TIMES = np.linspace(0.0, 1.0, 11)
TIGHT = {"rtol": 1e-11, "atol": 1e-11}


def simulated(name="fourbar", **options):
    model = zoo.MODELS[name]()
    system = system_of(model, times=TIMES, **options)
    return system, system.simulate(**TIGHT)


@pytest.mark.parametrize("name", ["chain", "fourbar", "disc_contact", "timed", "shaken"])
def test_a_trajectory_holds_what_integrate_and_the_evaluations_return(name):
    system, trajectory = simulated(name)
    x = system.integrate(**TIGHT)
    np.testing.assert_array_equal(trajectory.times, TIMES)
    np.testing.assert_array_equal(trajectory.states, x)
    np.testing.assert_array_equal(trajectory.outputs, system.evaluate_outputs(x))
    np.testing.assert_array_equal(trajectory.derivatives, system.evaluate_ode(x))
    assert list(trajectory.state_symbols) == system.states
    assert list(trajectory.outputs_symbols) == system.outputs_symbols
    assert trajectory.constants == system.constants
    assert trajectory.events == ()
    for symbol, value in system.specifieds.items():
        np.testing.assert_array_equal(trajectory[symbol], np.full(11, value))


def test_residuals_of_constraints_are_apart():
    system, trajectory = simulated()
    np.testing.assert_array_equal(
        trajectory.constraints, system.evaluate_constraints(trajectory.states)
    )
    assert len(trajectory.constraints_symbols) == 2


def test_quantities_are_found_by_symbol_and_by_name():
    energy = sm.Symbol("E")
    system, trajectory = simulated("bare", outputs={energy: zoo.bare().energy})
    q = system.states[0]
    assert list(trajectory) == ["q", "u", "E"]
    np.testing.assert_array_equal(trajectory[q], trajectory.states[:, 0])
    np.testing.assert_array_equal(trajectory["u"], trajectory.states[:, 1])
    np.testing.assert_array_equal(trajectory[energy], trajectory.outputs[:, 0])
    assert q in trajectory
    assert "nothing" not in trajectory
    with pytest.raises(
        KeyError, match="`nothing` is not one of the trajectory's quantities: q, u, E"
    ):
        trajectory["nothing"]
    with pytest.raises(KeyError, match=r"q, u, E. Did you mean `q`"):
        trajectory["Q"]
    for index in (0, -1, slice(2), (slice(None), 0), np.int64(1)):
        with pytest.raises(
            KeyError, match=r"Index the arrays: `trajectory.states\[k\]`; .*at\(t\)`"
        ):
            trajectory[index]
    with pytest.raises(KeyError, match=r"use a list: `trajectory\[\['q', 'u'\]\]`."):
        trajectory["q", "u"]


def test_names_that_would_be_alike_are_written_out():
    x = me.dynamicsymbols("x")
    trajectory = Trajectory(
        [0.0, 1.0],
        [[1.0], [2.0]],
        {"coordinate": [x], "output": [sm.Symbol("x")]},
        outputs=[[3.0], [4.0]],
    )
    assert trajectory.names == ("x(t)", "x")
    np.testing.assert_array_equal(trajectory[x], [1.0, 2.0])
    np.testing.assert_array_equal(trajectory[sm.Symbol("x")], [3.0, 4.0])


def test_functions_as_specifieds_are_recorded():
    model = zoo.chain()
    f0 = me.dynamicsymbols("f0")
    system = system_of(model, times=TIMES, specifieds={f0: lambda x, t: x[0] + 2.0 * t})
    trajectory = system.simulate()
    np.testing.assert_allclose(trajectory[f0], trajectory.states[:, 0] + 2.0 * TIMES)
    np.testing.assert_array_equal(trajectory["f1"], np.zeros(11))


def test_later_changes_of_the_system_do_not_reach_it():
    system, trajectory = simulated("timed")
    expected = system.evaluate_ode(trajectory.states)
    system.constants = {}
    system.times = [5.0, 6.0]
    np.testing.assert_array_equal(trajectory.derivatives, expected)
    np.testing.assert_array_equal(trajectory.times, TIMES)


# -- other times ----------------------------------------------------------------------------------


def test_other_times_are_interpolated_with_fourth_order():
    model = zoo.free_pendulum()
    fine = np.linspace(0.0, 1.0, 161)
    exact = system_of(model, times=fine).integrate(**TIGHT)
    errors = []
    for m in (21, 41, 81):
        system = system_of(model, times=np.linspace(0.0, 1.0, m))
        errors.append(np.abs(system.simulate(**TIGHT).at(fine).states - exact).max())
    rates = np.log2(np.array(errors[:-1]) / errors[1:])
    assert (rates > 3.6).all()


def test_no_times_give_no_rows():
    system = system_of(zoo.free_pendulum(), times=TIMES)
    parameter = min(system.constants_symbols, key=str)
    none = system.simulate(sensitivities=[parameter]).at([])
    assert none.states.shape == (0, len(system.states))
    assert none.sensitivity.values.shape[::2] == (0, 1)


def test_outputs_and_specifieds_at_other_times_are_evaluated_anew():
    model = zoo.chain()
    f0 = me.dynamicsymbols("f0")
    system = system_of(
        model,
        times=TIMES,
        specifieds={f0: lambda x, t: t**2},
        outputs={sm.Symbol("S"): f0**2},
    )
    other = system.simulate().at([0.05, 0.33])
    np.testing.assert_allclose(other[f0], [0.05**2, 0.33**2], rtol=1e-14)
    np.testing.assert_allclose(other["S"], [0.05**4, 0.33**4], rtol=1e-14)


@pytest.mark.parametrize(
    ("times", "message"),
    [
        ([0.5, 1.1], "within the simulated time, 0.0 to 1.0, got 1.1"),
        ([-0.1, 0.2], "got -0.1"),
        ([np.nan], "must be finite"),
        ([0.2, 0.1, 0.3], "ascending"),
        ([[0.1, 0.2]], "one-dimensional"),
    ],
)
def test_times_outside_are_refused(times, message):
    with pytest.raises(ValueError, match=message):
        simulated("bare")[1].at(times)


def test_a_solvers_dense_output_is_used():
    """And what else it says becomes events and statistics."""
    event = EventRecord(0.4, "top", 0, np.zeros(2), np.zeros(2))

    def solver(f, x0, t, args=()):
        made = solve_ivp(
            lambda t, x: f(x, t, *args), t[[0, -1]], x0, t_eval=t, rtol=1e-9, dense_output=True
        )
        info = {"nfe": made.nfev, "dense_output": lambda t: made.sol(t).T, "events": [event]}
        return made.y.T, info

    system = system_of(zoo.bare(), times=[0.0, 1.0], ode_solver=solver)
    trajectory = system.simulate()
    exact = system_of(zoo.bare(), times=TIMES).integrate(**TIGHT)
    np.testing.assert_allclose(trajectory.at(TIMES).states, exact, atol=1e-5)
    assert trajectory.events == (event,)
    assert list(trajectory.statistics) == ["nfe"]


def test_a_solver_that_stops_early_gives_its_times():
    def solver(f, x0, t, args=()):
        return np.tile(x0, (3, 1)), {"times": t[:3]}

    trajectory = system_of(zoo.bare(), times=TIMES, ode_solver=solver).simulate()
    np.testing.assert_array_equal(trajectory.times, TIMES[:3])
    assert trajectory.statistics is None


def test_a_solver_that_stops_early_without_its_times_is_refused():
    system = system_of(zoo.bare(), times=TIMES, ode_solver=lambda f, x, t, args: [x, x])
    with pytest.raises(ValueError, match=r"`ode_solver` must return the shape \(11, 2\)"):
        system.simulate()


@pytest.mark.parametrize("returned", [lambda X: (X, {}, 0), lambda X: None])
def test_what_a_solver_may_return_is_named(returned):
    def solver(f, x0, t, args=()):
        return returned(np.tile(x0, (len(t), 1)))

    system = system_of(zoo.bare(), times=TIMES, ode_solver=solver)
    with pytest.raises(ValueError, match=r"`ode_solver` returns, states or \(states, info\), must"):
        system.simulate()


def test_a_reset_is_a_node_on_both_sides():
    """A ball that falls and bounces once, between the given times."""
    y, v = me.dynamicsymbols("y v")
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, v * frame.y)
    kane = me.KanesMethod(frame, [y], [v], kd_eqs=[y.diff() - v])
    kane.kanes_equations([me.Particle("P", point, 1)], [(point, -8 * frame.y)])

    # y = 1 - 4 t² until t = 0.5, v = -4 before, +2 after.
    def ball(t):
        t = np.asarray(t)[:, None]
        falls = np.concatenate([1 - 4 * t**2, -8 * t], axis=1)
        s = t - 0.5
        rises = np.concatenate([2 * s - 4 * s**2, 2 - 8 * s], axis=1)
        return np.where(t < 0.5, falls, rises)

    bounce = EventRecord(0.5, "bounce", 0, np.array([0.0, -4.0]), np.array([0.0, 2.0]))
    times = [0.0, 0.2, 0.4, 0.6]

    def solver(f, x0, t, args=()):
        return ball(t), {"events": [bounce]}

    system = System(kane, initial_conditions={y: 1.0}, times=times, ode_solver=solver)
    fine = np.linspace(0.0, 0.6, 61)
    np.testing.assert_allclose(system.simulate().at(fine).states, ball(fine), atol=1e-12)


# -- other forms ----------------------------------------------------------------------------------


def test_a_dataset_has_a_variable_for_each_quantity():
    pytest.importorskip("xarray")
    _, trajectory = simulated("disc_contact")
    dataset = trajectory.to_xarray()
    assert list(dataset.data_vars) == list(trajectory.names)
    assert dataset["q1"].dims == ("time",)
    np.testing.assert_array_equal(dataset["q1"], trajectory["q1"])
    assert dataset["q1"].attrs == {"role": "coordinate", "latex": "q_{1}"}
    assert [dataset[n].attrs["role"] for n in ("u1", "∫ Fx(t) dt", "c0", "Fx")] == [
        "speed", "auxiliary", "constraint", "force",
    ]  # fmt: skip
    assert float(dataset["r"]) == 0.6


def test_a_data_frame_has_a_column_for_each_quantity():
    pytest.importorskip("pandas")
    _, trajectory = simulated()
    frame = trajectory.to_dataframe()
    assert list(frame.columns) == list(trajectory.names)
    assert frame.index.name == "time"
    np.testing.assert_array_equal(frame["q2"], trajectory["q2"])


@pytest.mark.parametrize("name", ["chain", "fourbar", "disc_contact", "shaken"])
def test_a_file_gives_everything_back(name, tmp_path):
    pytest.importorskip("xarray")
    _, trajectory = simulated(name)
    trajectory.save(tmp_path / "run.nc")
    loaded = Trajectory.load(tmp_path / "run.nc")
    assert loaded.names == trajectory.names
    for symbol in (*trajectory.state_symbols, *trajectory.specifieds_symbols):
        np.testing.assert_array_equal(loaded[symbol], trajectory[symbol])
        assert loaded.latex(symbol) == trajectory.latex(symbol)
    for what in ("times", "states", "outputs", "constraints", "specifieds", "derivatives"):
        np.testing.assert_array_equal(getattr(loaded, what), getattr(trajectory, what))
    assert list(loaded.constants.values()) == list(trajectory.constants.values())
    assert loaded.statistics["nfe"] == trajectory.statistics["nfe"].tolist()
    between = [0.01, 0.52]
    np.testing.assert_array_equal(loaded.at(between).states, trajectory.at(between).states)


def test_a_file_keeps_events_and_odd_names(tmp_path):
    pytest.importorskip("xarray")
    trajectory = Trajectory(
        [0.0, 1.0],
        [[1.0, 5.0], [2.0, 6.0]],
        {"coordinate": ["a/b", "a b"], "output": ["ω → 0"]},
        outputs=[[3.0], [4.0]],
        constants={sm.Symbol("a b"): 7.0},
        events=[EventRecord(0.5, "hit", 0, np.array([1.5, 0.0]), np.array([-1.5, 0.0]))],
    )
    trajectory.save(tmp_path / "odd.nc")
    loaded = Trajectory.load(tmp_path / "odd.nc")
    assert loaded.names == ("a/b", "a b", "ω → 0")
    np.testing.assert_array_equal(loaded["a b"], [5.0, 6.0])
    assert loaded.constants == {"a b": 7.0}
    (event,) = loaded.events
    assert (event.name, event.time) == ("hit", 0.5)
    np.testing.assert_array_equal(event.after, [-1.5, 0.0])
    with pytest.raises(ValueError, match="contains no derivatives"):
        loaded.at([0.5])


def test_what_has_no_dense_output_keeps_where_inputs_jump(tmp_path):
    """A mass on a spring, pushed in steps: arcs of circles about each force; h⁴ / 384 remains."""
    pytest.importorskip("xarray")
    system = multi_mass_spring_damper(1, False, True)
    (force,) = system.specifieds_symbols
    system.constants = dict.fromkeys(system.constants_symbols, 1.0) | {sm.Symbol("c0"): 0.0}
    breaks, levels = np.array([0.0, 0.37, 1.1, 1.9, 3.0]), [1.0, -2.0, 0.5, 3.0, 3.0]
    system.specifieds = {force: SampledInput(breaks, levels, "previous")}
    system.times, system.ode_solver = np.linspace(0.0, 3.0, 31), "dop853"
    motion = system.simulate(rtol=1e-12, atol=1e-12, sensitivities=["k0"])
    motion.save(tmp_path / "run.nc")
    Trajectory.load(tmp_path / "run.nc").save(tmp_path / "again.nc")
    times = np.linspace(0.0, 3.0, 1001)
    exact, x, radii = np.zeros((len(times), 2)), np.zeros(2), []
    for begin, end, level in zip(breaks, [*breaks[1:-1], 4.0], levels, strict=False):
        c, s = np.cos(times - begin), np.sin(times - begin)
        arc = [level + (x[0] - level) * c + x[1] * s, x[1] * c - (x[0] - level) * s]
        own = (times >= begin) & (times <= end)
        exact[own] = np.stack(arc, axis=1)[own]
        c, s = np.cos(end - begin), np.sin(end - begin)
        radii.append(np.hypot(x[0] - level, x[1]))
        x = np.array([level + (x[0] - level) * c + x[1] * s, x[1] * c - (x[0] - level) * s])
    kept = [pickle.loads(pickle.dumps(motion))]
    kept += [Trajectory.load(tmp_path / name) for name in ("run.nc", "again.nc")]
    for one in (pickle.loads(pickle.dumps(kept[0])), *kept):
        found = one.at(times)
        assert np.abs(found.states - exact).max() < 1.001 * max(radii) * 0.1**4 / 384
        np.testing.assert_array_equal(found.specifieds, motion.at(times).specifieds)
        own = motion.at(times).sensitivity["x0", "k0"]
        np.testing.assert_allclose(found.sensitivity["x0", "k0"], own, atol=0.0025)  # files: lines
        assert one.events == ()


def test_a_file_keeps_what_jumps_at_events(tmp_path):
    """Between the times beside a bounce: as the same pickled, outputs and columns on each side."""
    pytest.importorskip("xarray")
    system = multi_mass_spring_damper()
    (x,), (v,) = system.coordinates, system.speeds
    system.initial_conditions, system.outputs = {x: 1.0}, {"momentum": 2 * v}
    system.times, system.ode_solver = np.linspace(0.0, 3.0, 31), "dop853"
    bounce = Event(x, direction=-1, reset={v: -0.5 * v}, name="bounce")
    motion = system.simulate(events=[bounce], rtol=1e-9, atol=1e-9, sensitivities=["k0"])
    motion.save(tmp_path / "run.nc")
    Trajectory.load(tmp_path / "run.nc").save(tmp_path / "again.nc")
    when = motion.events[0].time
    times = when + np.array([-0.02, -1e-9, 0.0, 1e-9, 0.02])
    ours, pickled = motion.at(times), pickle.loads(pickle.dumps(motion)).at(times)
    for name in ("run.nc", "again.nc"):
        found = Trajectory.load(tmp_path / name).at(times)
        np.testing.assert_array_equal(found.states, pickled.states)
        # Straight lines, from one side of the jump or to the other.
        np.testing.assert_allclose(found["momentum"], ours["momentum"], atol=0.01)
        for state in (x, v):
            columns = ours.sensitivity[state, "k0"]
            np.testing.assert_allclose(found.sensitivity[state, "k0"], columns, atol=0.01)
    assert abs(np.diff(ours["momentum"][1:3])) > 0.8


def test_a_file_of_a_motion_backward_in_time_gives_its_sensitivities_back(tmp_path):
    """A mass on a spring: x = cos(ω t), and ∂x/∂k = −t sin(ω t) / (2 ω)."""
    pytest.importorskip("xarray")
    system = multi_mass_spring_damper()
    system.constants = {"m0": 1.0, "k0": 4.0, "c0": 0.0}
    system.initial_conditions, system.ode_solver = {"x0": 1.0}, "dop853"
    system.times = np.linspace(0.0, -3.0, 301)
    motion = system.simulate(rtol=1e-10, atol=1e-10, sensitivities=["k0"])
    motion.save(tmp_path / "run.nc")
    loaded = Trajectory.load(tmp_path / "run.nc")
    times = np.array([-0.505, -2.205])
    for one in (motion, loaded, pickle.loads(pickle.dumps(motion))):
        found = one.at(times)
        np.testing.assert_allclose(found["x0"], np.cos(2 * times), atol=1e-7)
        slopes = -times * np.sin(2 * times) / 4
        np.testing.assert_allclose(found.sensitivity["x0", "k0"], slopes, atol=1e-4)


def test_a_file_that_does_not_know_the_sides_of_a_jump_is_not_interpolated():
    event = EventRecord(0.5, "hit", 0, np.array([1.0]), np.array([-1.0]))
    motion = Trajectory([0.0, 1.0], [[1.0], [-1.0]], {"speed": ["v"]}, events=[event])
    motion._derivatives = np.zeros((2, 1))  # as an older file has them
    with pytest.raises(ValueError, match="how these go on from there"):
        motion.at([0.4])


OURS = ["time", "quantity", "parameter", "sensitivity", "total_energy", "kinetic_energy", "q'"]


def trajectory_of(names, kind, constants=(), sensitive=True):
    """An oscillator's motion, with as many more quantities and constants as there are names."""
    t = np.array([0.0, 1.0])
    names = list(names)
    if kind == "coordinate":
        symbols, outputs = {"coordinate": ["q", *names], "speed": ["u"]}, np.empty((2, 0))
        states = np.arange(2.0 * (2 + len(names))).reshape(2, -1)
    else:
        symbols = {"coordinate": ["q"], "speed": ["u"], "output": names}
        states, outputs = np.array([[1.0, 2.0], [3.0, 4.0]]), 10.0 + np.arange(2.0 * len(names))
    outputs = outputs.reshape(2, -1)
    width = states.shape[1] + outputs.shape[1]
    trajectory = Trajectory(
        t,
        states,
        symbols,
        outputs=outputs,
        constants={sm.Symbol(n): 7.0 + k for k, n in enumerate(constants)},
    )
    trajectory._derivatives = -1.0 - np.arange(float(states.size)).reshape(states.shape)
    trajectory._energy = 100.0 + np.arange(6.0).reshape(2, 3)
    if sensitive:
        trajectory._take_sensitivity(["k"], 200.0 + np.arange(2.0 * width).reshape(2, width, 1))
    return trajectory


@pytest.mark.parametrize("sensitive", [False, True])
@pytest.mark.parametrize(
    ("names", "kind", "constants"),
    [
        (OURS, "output", ["q (constant)", "m (constant)", "m"]),
        (OURS, "coordinate", []),
        (["m", "m (constant)"], "output", [*OURS, "m", "q", "u"]),
    ],
)
def test_names_of_ours_are_kept_apart_from_the_users(names, kind, constants, sensitive, tmp_path):
    pytest.importorskip("xarray")
    trajectory = trajectory_of(names, kind, constants, sensitive)
    trajectory.save(tmp_path / "run.nc")
    loaded = Trajectory.load(tmp_path / "run.nc")
    assert loaded.names == trajectory.names
    for name in trajectory.names:
        np.testing.assert_array_equal(loaded[name], trajectory[name])
    assert loaded.constants == {s.name: value for s, value in trajectory.constants.items()}
    for what in ("times", "derivatives", "energy"):
        np.testing.assert_array_equal(getattr(loaded, what), getattr(trajectory, what))
    if sensitive:
        for name in trajectory.names:
            np.testing.assert_array_equal(
                loaded.sensitivity[name, "k"], trajectory.sensitivity[name, "k"]
            )


def test_files_without_labels_are_read_as_they_were_written(tmp_path):
    xarray = pytest.importorskip("xarray")
    role = {"role": "constant", "latex": "m"}
    dataset = xarray.Dataset(
        {"q": ("time", [1.0, 2.0], {"role": "coordinate", "latex": "q"})},
        {
            "time": [0.0, 1.0],
            "q (constant)": ((), 3.0, role),
            "parameter": ((), 4.0, role),
        },
    )
    write_netcdf(dataset, tmp_path / "old.nc", None, [], {})
    loaded = Trajectory.load(tmp_path / "old.nc")
    assert loaded.constants == {"q": 3.0, "parameter": 4.0}
    np.testing.assert_array_equal(loaded["q"], [1.0, 2.0])


def test_an_output_named_like_a_state_keeps_its_label_in_a_file(tmp_path):
    pytest.importorskip("xarray")
    system = multi_mass_spring_damper()
    x0, v0 = system.states
    m0 = sm.Symbol("m0")
    system.outputs = {x0: 2 * x0, "v0": v0 - 1, m0: m0 + 1, "x0_output": 7 * x0}
    assert system.outputs_symbols == [x0, v0, m0, sm.Symbol("x0_output")]
    assert system.outputs[x0] == 2 * x0
    system.initial_conditions, system.times = {x0: 1.0}, [0.0, 1.0]
    trajectory = system.simulate()
    trajectory.save(tmp_path / "a.nc")
    for found in (trajectory, Trajectory.load(tmp_path / "a.nc")):
        np.testing.assert_array_equal(found["x0_output_2"], 2 * found["x0"])
        np.testing.assert_array_equal(found["v0_output"], found["v0"] - 1)
        np.testing.assert_array_equal(found["m0_output"], [2.0, 2.0])
        np.testing.assert_array_equal(found["x0_output"], 7 * found["x0"])
    np.testing.assert_array_equal(trajectory[x0], trajectory.states[:, 0])


def test_a_file_of_something_else_is_refused(tmp_path):
    xarray = pytest.importorskip("xarray")
    xarray.Dataset({"a": ("time", [1.0])}).to_netcdf(tmp_path / "a.nc", engine="scipy")
    with pytest.raises(ValueError, match=r"must be a file that Trajectory\.save wrote"):
        Trajectory.load(tmp_path / "a.nc")


@pytest.mark.parametrize(
    ("suffix", "written_by"),
    [(".csv", "trajectory.to_dataframe().to_csv(path)"), (".ZARR", "to_zarr"), (".npz", "savez")],
)
def test_a_suffix_of_another_format_is_refused_with_what_writes_it(tmp_path, suffix, written_by):
    pytest.importorskip("xarray")
    path = tmp_path / f"run{suffix}"
    with pytest.raises(ValueError, match=rf"`path` must be .*NetCDF .*{re.escape(written_by)}"):
        simulated("bare")[1].save(path)
    assert not path.exists()


def test_a_file_cut_short_anywhere_is_a_named_error(tmp_path):
    pytest.importorskip("xarray")
    path = tmp_path / "run.nc"
    simulated("bare")[1].save(path)
    content = path.read_bytes()
    for size in range(0, len(content), 97):
        path.write_bytes(content[:size])
        with pytest.raises(ValueError, match=r"`path` must be a file that Trajectory\.save wrote"):
            Trajectory.load(path)


def test_a_flipped_bit_is_seen(tmp_path):
    pytest.importorskip("xarray")
    path = tmp_path / "run.nc"
    _, trajectory = simulated("bare")
    trajectory.save(path)
    content = path.read_bytes()
    for place in (content.index(trajectory.states[1, :1].astype(">f8").tobytes()), -5):
        wrong = bytearray(content)
        wrong[place + 3] ^= 4
        path.write_bytes(wrong)
        with pytest.raises(ValueError, match="its content is not what its checksum tells"):
            Trajectory.load(path)
    path.write_bytes(content)
    assert (Trajectory.load(path).states == trajectory.states).all()


@pytest.mark.parametrize("name", [b"pydy_events", b"role", b"latex", b"time", b"before", b'"nfe"'])
def test_a_file_with_a_damaged_name_is_a_named_error(name, tmp_path):
    pytest.importorskip("xarray")
    path = tmp_path / "run.nc"
    _, trajectory = simulated("bare")
    trajectory.events = (EventRecord(0.5, "hit", 0, np.zeros(2), np.zeros(2)),)
    trajectory.save(path)
    content = path.read_bytes()
    assert name in content
    path.write_bytes(content.replace(name, b"\x01" * len(name)))
    with pytest.raises(ValueError, match=r"must be a file that Trajectory\.save wrote"):
        Trajectory.load(path)


def test_a_file_without_times_is_a_named_error(tmp_path):
    """xarray would count the rows in their place."""
    xarray = pytest.importorskip("xarray")
    simulated("bare")[1].save(tmp_path / "run.nc")
    with xarray.open_dataset(tmp_path / "run.nc", engine="scipy") as dataset:
        less = dataset.load().drop_vars("time")
    less.to_netcdf(tmp_path / "less.nc", engine="scipy", format="NETCDF3_64BIT")
    with pytest.raises(ValueError, match=r"must be a file that .* it holds no 'time'"):
        Trajectory.load(tmp_path / "less.nc")


def test_a_file_that_does_not_exist_is_the_usual_error(tmp_path):
    pytest.importorskip("xarray")
    with pytest.raises(FileNotFoundError):
        Trajectory.load(tmp_path / "none.nc")


def test_loading_needs_no_sympy(tmp_path):
    pytest.importorskip("xarray")
    simulated("bare")[1].save(tmp_path / "run.nc")
    code = (
        "import sys; from pydy.trajectory import Trajectory; "
        f"t = Trajectory.load({str(tmp_path / 'run.nc')!r}); t['q'], t.at([0.55]), t.latex('q'); "
        "assert 'sympy' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_a_trajectory_can_be_pickled():
    _, trajectory = simulated("timed")
    twin = pickle.loads(pickle.dumps(trajectory))
    np.testing.assert_array_equal(twin.at(TIMES[1:3]).states, trajectory.states[1:3])
    np.testing.assert_allclose(twin.derivatives, trajectory.derivatives, rtol=1e-14)


def test_a_missing_package_is_named(monkeypatch):
    _, trajectory = simulated("bare")
    monkeypatch.setitem(sys.modules, "xarray", None)
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ImportError, match=r"needs xarray.*pip install 'pydy\[labels\]'"):
        trajectory.to_xarray()
    with pytest.raises(ImportError, match=r"needs pandas.*pip install 'pydy\[labels\]'"):
        trajectory.to_dataframe()


def test_tables_of_the_wrong_shape_are_refused():
    with pytest.raises(ValueError, match=r"`outputs` must have the shape \(2, 1\).*got \(1, 1\)"):
        Trajectory([0, 1], [[1], [2]], {"speed": ["u"], "output": ["y"]}, outputs=[[1]])


@pytest.mark.parametrize("name", ["model", "dense", "sensitivities", "events"])
def test_parts_of_another_kind_are_refused_at_once(name):
    with pytest.raises(TypeError, match=f"`{name}` must .*, got 5"):
        Trajectory([0, 1], [[1], [2]], {"speed": ["u"]}, **{name: 5})


def test_a_trajectory_in_place_of_its_times_is_named_once():
    system = multi_mass_spring_damper()
    system.times, system.ode_solver = [0.0, 1.0], "dop853"
    trajectory = system.simulate()
    told = (
        r"got the Trajectory of x0, v0 at 2 times from 0\.0 to 1\.0\. Pass its attribute `times`\."
    )
    with pytest.raises(TypeError, match=told):
        system.times = trajectory
    system.times = trajectory.times
    with pytest.raises(TypeError, match=r"pydy\.solvers\.Event, got the Trajectory of x0"):
        system.simulate(events=[trajectory])


def test_simulate_needs_times():
    with pytest.raises(ValueError, match="at least two values"):
        multi_mass_spring_damper().simulate()


# -- with what else a System can do ----------------------------------------------------------------


def test_specifieds_that_are_expressions_or_samples_are_recorded():
    from pydy.inputs import SampledInput

    model = zoo.chain()
    f0, f1, f2 = me.dynamicsymbols("f0 f1 f2")
    x0, t = model.states[0], me.dynamicsymbols._t
    specifieds = {f0: sm.sin(t) - 2 * x0, f1: SampledInput([0.0, 1.0], [1.0, 3.0]), f2: f0 + 1}
    system = system_of(model, times=TIMES, specifieds=specifieds)
    trajectory = system.simulate(**TIGHT)
    expected = np.sin(TIMES) - 2 * trajectory[x0]
    np.testing.assert_allclose(trajectory[f0], expected, atol=1e-14)
    np.testing.assert_allclose(trajectory[f1], 1.0 + 2.0 * TIMES)
    np.testing.assert_allclose(trajectory[f2], expected + 1.0, atol=1e-14)
    np.testing.assert_array_equal(trajectory.derivatives, system.evaluate_ode(trajectory.states))
    assert trajectory.at([0.55])[f1][0] == pytest.approx(2.1)


def test_a_native_solver_gives_its_statistics():
    from pydy import solvers

    system = system_of(zoo.bare(), times=TIMES, ode_solver=solvers.dop853)
    trajectory = system.simulate(rtol=1e-10, atol=1e-10)
    exact = system_of(zoo.bare(), times=TIMES).integrate(**TIGHT)
    np.testing.assert_allclose(trajectory.states, exact, atol=1e-8)
    assert trajectory.statistics["evaluations"] > 10
    assert trajectory.events == ()


def test_a_trajectory_ends_where_an_event_ended_it():
    states = np.array([[1.0, 2.0], [3.0, 4.0], [np.nan, np.nan]])

    def solver(f, x0, t, args=()):
        return states, {"events": []}

    trajectory = system_of(zoo.bare(), times=[0.0, 1.0, 2.0], ode_solver=solver).simulate()
    np.testing.assert_array_equal(trajectory.times, [0.0, 1.0])
    np.testing.assert_array_equal(trajectory.states, states[:2])


def test_a_printed_symbol_and_a_list_find_quantities():
    _, trajectory = simulated("bare")
    np.testing.assert_array_equal(trajectory["u(t)"], trajectory["u"])
    np.testing.assert_array_equal(trajectory[["u(t)", "q"]], trajectory.states[:, ::-1])
    assert trajectory[[]].shape == (11, 0)
    with pytest.raises(KeyError, match="`v` is not one of the trajectory's quantities: q, u"):
        trajectory[["q", "v"]]


def test_as_an_array_a_trajectory_is_its_states():
    _, trajectory = simulated("bare")
    assert np.asarray(trajectory) is trajectory.states
    assert np.asarray(trajectory, dtype=np.float32).dtype == np.float32
    copied = np.array(trajectory)
    np.testing.assert_array_equal(copied, trajectory.states)
    assert not np.shares_memory(copied, trajectory.states)
    with pytest.raises(ValueError, match="as float32 they must be copied"):
        trajectory.__array__(np.float32, copy=False)


def test_an_event_prints_in_short():
    event = EventRecord(0.5, "bounce", 0, np.zeros(200), np.ones(200))
    assert repr(event) == "EventRecord('bounce' at t = 0.5)"


def test_a_trajectory_plots_itself():
    plt = pytest.importorskip("matplotlib.pyplot")
    _, trajectory = simulated("bare")
    assert [ax.get_ylabel() for ax in trajectory.plot()] == ["coordinates", "speeds"]
    ax = trajectory.plot(["q", "u"], units={"q": "m"}, time_unit="s")
    assert [t.get_text() for t in ax.get_legend().get_texts()] == ["$q$ (m)", "$u$"]
    plt.close("all")


def spring():
    """An oscillator with x = cos t, known at three times and, by the solver, between them."""
    system = multi_mass_spring_damper()
    system.constants = {"c0": 0.0}
    system.initial_conditions = {"x0": 1.0}
    system.times, system.ode_solver = [0.0, 1.0, 6.0], "dop853"
    return system.simulate(rtol=1e-11, atol=1e-11, sensitivities=["k0"])


def test_plots_show_what_the_solver_knows_between_the_times():
    plt = pytest.importorskip("matplotlib.pyplot")
    trajectory = spring()
    pictures = [*trajectory.plot(), plot_energy(trajectory), plot_phase(trajectory, "x0")]
    x, v, kinetic, phase = (ax.lines[0].get_data() for ax in pictures)
    t = x[0]
    assert {0.0, 1.0, 6.0} <= set(t)
    assert np.diff(t).max() < 2 * 6.0 / 400
    np.testing.assert_allclose(x[1], np.cos(t), atol=1e-9)
    np.testing.assert_allclose(v[1], -np.sin(t), atol=1e-9)
    np.testing.assert_allclose(kinetic[1], np.sin(t) ** 2 / 2, atol=1e-9)
    np.testing.assert_allclose(np.hypot(*phase), 1.0, atol=1e-9)
    slopes = plot_sensitivities(trajectory, "x0").lines[0].get_data()
    np.testing.assert_allclose(slopes[1], -slopes[0] / 2 * np.sin(slopes[0]), atol=1e-8)
    kept = pickle.loads(pickle.dumps(trajectory)).plot(["x0"]).lines[0]
    np.testing.assert_array_equal(kept.get_xdata(), trajectory.times)
    plt.close("all")


def test_animations_show_what_the_solver_knows_between_the_times():
    trajectory = spring()
    given = {"ramp": trajectory.times}
    scene = trajectory.animate(series=["x0"]).animate(trajectory, series=given, fps=20.0)
    t, moving = scene.times, scene._animation
    np.testing.assert_allclose(t, np.linspace(0.0, 6.0, 121), atol=1e-12)
    np.testing.assert_allclose(scene.poses[:, 0, :3, 3].sum(1), np.cos(t), atol=1e-9)
    own, x = moving.series["x0"]
    assert {*trajectory.times, *t} <= {*own}
    np.testing.assert_allclose(x, np.cos(own), atol=1e-9)
    np.testing.assert_array_equal(moving.series["ramp"], [trajectory.times] * 2)
    assert len(trajectory.animate().animate(trajectory, fps=None).times) == 3
    slow = trajectory.animate().animate(trajectory, speed=1e-4)
    assert len(slow.times) <= 7201


def test_a_trajectory_animates_the_bodies_of_its_model():
    system = n_link_pendulum_on_cart(1)
    system.times = TIMES
    trajectory = system.simulate()
    scene = trajectory.animate(title="Cart")
    np.testing.assert_allclose(scene.poses, system.scene().animate(trajectory).poses)
    bare = Trajectory([0.0], [[1.0]], {"coordinate": ["q"]})
    with pytest.raises(
        ValueError,
        match=r"contains no bodies and no model.*`system.scene\(\).animate\(trajectory\)`",
    ):
        bare.animate()


def test_a_trajectory_in_place_of_times_is_refused_with_the_remedy():
    trajectory = system_of(zoo.free_pendulum(), times=TIMES).simulate()
    with pytest.raises(TypeError, match="got a Trajectory: pass its `times`"):
        trajectory.at(trajectory)


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("to_csv", r"Use `to_dataframe\(\).to_csv\(path\)`"),
        ("y", "Use `states`, with a row"),
        ("energies", "Did you mean `energy`"),
    ],
)
def test_a_name_of_another_library_is_refused_with_the_one_that_is_meant(name, meant):
    trajectory = simulated()[1]
    with pytest.raises(AttributeError, match=rf"has no `{name}`\. {meant}"):
        getattr(trajectory, name)
    with pytest.raises(AttributeError, match=r"no attribute 'qqqqqq'\Z"):
        _ = trajectory.qqqqqq
    assert copy.copy(trajectory).times is not None
    quantity = trajectory.names[0]
    with pytest.raises(AttributeError, match=rf"Use `trajectory\['{quantity}'\]`"):
        getattr(trajectory, quantity)


@pytest.mark.parametrize("end", [2.0, -2.0])
def test_a_motion_that_an_event_ends_is_known_up_to_the_event(end):
    system = multi_mass_spring_damper()
    position = system.coordinates[0]
    system.initial_conditions, system.ode_solver = {position: 1.0}, "dop853"
    system.times = [0.0, 0.25 * end, end]
    reference = system.simulate(rtol=1e-11, atol=1e-11)
    threshold = float(reference.at(0.75 * end)[position][0])
    event = Event(position - threshold, terminal=True)
    trajectory = system.simulate(events=[event], rtol=1e-11, atol=1e-11)
    last = trajectory.events[0].time
    assert abs(trajectory.times[-1]) < abs(last)
    times = [0.5 * last, 0.9 * last, last]
    expected = reference.at(times).states
    np.testing.assert_allclose(trajectory.at(times).states, expected, rtol=1e-8, atol=1e-9)
    restored = pickle.loads(pickle.dumps(trajectory)).at(times).states
    np.testing.assert_allclose(restored, expected, atol=0.05)  # by the states at its ends
    with pytest.raises(ValueError, match="within the simulated time"):
        trajectory.at(1.01 * last)
