"""The solution between the times is the solver's own, with the bits of a run that asks for it."""

import copy
import pickle
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.inputs import SampledInput
from pydy.solvers import Event, dop853, rk4
from pydy.solvers.run import workspace
from pydy.system import System
from registry import ADAPTIVE_NAMES, step_options
from zoo.cases import system_of

ADAPTIVE = ADAPTIVE_NAMES
FEW, MANY = np.linspace(0.0, 2.0, num=5), np.linspace(0.0, 2.0, num=401)


def oscillator(solver, times, force=None):
    """A particle on a spring: x = cos t, unless a force acts."""
    q, v, f, k = (
        me.dynamicsymbols("q"),
        me.dynamicsymbols("v"),
        me.dynamicsymbols("f"),
        sm.Symbol("k"),
    )
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, v * frame.x)
    method = me.KanesMethod(frame, [q], [v], [q.diff() - v])
    load = (point, (f - k * q) * frame.x)
    method.kanes_equations([me.Particle("P", point, sm.Integer(1))], [load])
    system = System(method, constants={k: 1.0}, initial_conditions={q: 1.0}, times=times)
    system.specifieds, system.ode_solver = {f: 0.0 if force is None else force}, solver
    return system


def tight(solver):
    return {"step": 0.01} if solver in ("rk4", rk4) else {"rtol": 1e-12, "atol": 1e-12}


def agree(make, **options):
    """Ask for few times and then for many, and for many at once."""
    few = make(FEW).simulate(**options)
    many = make(MANY).simulate(**options)
    between = few.at(MANY)
    np.testing.assert_array_equal(between.states, many.states)
    np.testing.assert_array_equal(between.outputs, many.outputs)
    return few, many


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_the_solution_between_the_times_is_as_good_as_at_the_times(solver):
    few, _ = agree(lambda times: oscillator(solver, times), **tight(solver))
    exact = np.stack([np.cos(MANY), -np.sin(MANY)], axis=1)
    assert abs(few.states - exact[::100]).max() < 1e-10
    # The interpolants' orders are at most two below the methods'; radau's is 3 for 5.
    worst = 1e-7 if solver == "radau" else 1e-10
    assert abs(few.at(MANY).states - exact).max() < worst
    np.testing.assert_array_equal(few.at(FEW).states, few.states)


def test_cubics_between_fixed_steps_are_of_order_four():
    errors = []
    for step in (0.1, 0.05):
        between = oscillator("rk4", FEW).simulate(step=step).at(MANY)
        errors.append(abs(between["q"] - np.cos(MANY)).max())
    assert 12.0 < errors[0] / errors[1] < 20.0


@pytest.mark.parametrize("solver", ["dop853", "radau"])
@pytest.mark.parametrize(
    "force",
    [lambda x, t: np.sin(3 * t), SampledInput([0.0, 0.7, 2.0], [0.0, 1.0, -1.0])],
    ids=["function", "samples"],
)
def test_inputs_act_between_the_times_as_well(solver, force):
    agree(lambda times: oscillator(solver, times, force), rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_an_event_has_a_left_and_a_right_value(solver):
    q, v = me.dynamicsymbols("q v")
    bounce = Event(q - sm.Rational(1, 2), reset={v: -v / 2})
    few, many = agree(lambda times: oscillator(solver, times), events=[bounce], **tight(solver))
    (event,) = [e for e in few.events if e.time < 1.5]
    assert abs(event.time - np.pi / 3) < 1e-9
    np.testing.assert_array_equal(few.at([event.time]).states[0], event.after)
    left = few.at([np.nextafter(event.time, 0.0)]).states[0]
    np.testing.assert_allclose(left, event.before, rtol=0.0, atol=1e-14)
    assert many.events[0].time == event.time


def test_a_terminal_event_ends_the_dense_output():
    q, v = me.dynamicsymbols("q v")
    stop = Event(q, terminal=True, reset={v: 0})
    trajectory = oscillator("dop853", FEW).simulate(events=[stop], **tight("dop853"))
    between = trajectory.at(np.linspace(0.0, trajectory.times[-1], num=50))
    assert abs(between["q"] - np.cos(between.times)).max() < 1e-10


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_a_projected_motion_satisfies_its_constraints_between_the_times(solver):
    def make(times):
        return system_of(zoo.fourbar(), times=0.25 * times, ode_solver=solver)

    few = make(FEW).simulate(constraints="project", rtol=1e-8, atol=1e-8)
    many = make(MANY).simulate(constraints="project", rtol=1e-8, atol=1e-8)
    np.testing.assert_array_equal(few.at(0.25 * MANY).states, many.states)
    assert abs(few.at(0.25 * MANY).constraints).max() < 1e-13


@pytest.mark.parametrize("solver", ["dop853", "radau"])
def test_sensitivities_are_extended_with_the_states(solver):
    few, many = agree(
        lambda times: oscillator(solver, times), sensitivities=["k", "q"], rtol=1e-9, atol=1e-9
    )
    np.testing.assert_array_equal(few.at(MANY).sensitivity.values, many.sensitivity.values)
    np.testing.assert_allclose(few.at(MANY).sensitivity["q", "q"], np.cos(MANY), atol=1e-6)


def test_later_changes_of_the_system_do_not_reach_the_dense_output():
    system = oscillator("dop853", FEW)
    trajectory = system.simulate(**tight("dop853"))
    before = trajectory.at(MANY).states
    system.constants["k"] = 4.0
    system.simulate(**tight("dop853"))
    np.testing.assert_array_equal(trajectory.at(MANY).states, before)


@pytest.mark.parametrize("solver", ["rk4", "tsit5", "radau"])
def test_long_runs_are_kept_in_pieces(solver, monkeypatch):
    monkeypatch.setattr(workspace, "_STEPS", 1)
    options = step_options(solver, 1e-8, 0.004)
    piecewise = oscillator(solver, FEW).simulate(**options)
    monkeypatch.undo()
    whole = oscillator(solver, FEW).simulate(**options)
    np.testing.assert_array_equal(piecewise.states, whole.states)
    np.testing.assert_array_equal(piecewise.at(MANY).states, whole.at(MANY).states)


def test_without_dense_output_cubics_lie_between_the_times(monkeypatch):
    cubic = oscillator("vern9", FEW).simulate(dense_output=False, **tight("vern9"))
    assert 1e-6 < abs(cubic.at(MANY)["q"] - np.cos(MANY)).max() < 1e-3
    kept = oscillator("vern9", FEW).simulate(**tight("vern9"))
    for other in (pickle.loads(pickle.dumps(kept)), copy.deepcopy(cubic)):
        np.testing.assert_array_equal(other.at(MANY).states, cubic.at(MANY).states)
    np.testing.assert_array_equal(copy.deepcopy(kept).at(MANY).states, kept.at(MANY).states)
    monkeypatch.setattr(workspace, "STEPS_MEMORY", 100)
    monkeypatch.setattr(workspace, "_STEPS", 1)
    large = oscillator("vern9", FEW).simulate(**tight("vern9"))
    np.testing.assert_array_equal(large.at(MANY).states, cubic.at(MANY).states)


def test_a_solver_called_by_itself_gives_its_dense_output():
    times = [0.0, 2.0]
    options = {"full_output": True, "dense_output": True, "rtol": 1e-12, "atol": 1e-12}
    _, info = dop853(lambda x, t: [x[1], -x[0]], [1.0, 0.0], times, **options)
    np.testing.assert_allclose(info["dense_output"](MANY)[:, 0], np.cos(MANY), atol=1e-10)


def test_threads_share_a_dense_output():
    trajectory = oscillator("vern9", FEW).simulate(**tight("vern9"))
    expected = trajectory.at(MANY).states
    with ThreadPoolExecutor(4) as pool:
        for found in pool.map(lambda _: trajectory.at(MANY).states, range(100)):
            np.testing.assert_array_equal(found, expected)


def test_asking_between_the_steps_leaves_the_end_of_the_run_as_it_was():
    prepared = dop853.prepare(
        lambda x, t: [x[1], -x[0]], [1.0, 0.0], [0.0, 2.0], dense_output=True, **tight("dop853")
    )
    states = prepared([1.0, 0.0])
    prepared.info["dense_output"](MANY[:100])
    np.testing.assert_array_equal(prepared.info["dense_output"](MANY[-1:]), states[-1:])


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_a_long_motion_that_an_event_ends_is_known_to_its_end(solver):
    """Beyond the steps for which there is room at a time, a row behind the last one was read."""
    system = oscillator(solver, np.linspace(0.0, 2.0, num=2001))
    q = system.states[0]
    motion = system.simulate(events=[Event(q + 0.3, terminal=True)], max_step=2.0 / 2600)
    end = float(np.arccos(-0.3))
    assert motion.events[-1].time == pytest.approx(end, abs=1e-9)
    times = np.linspace(0.0, motion.times[-1], num=4001)
    np.testing.assert_allclose(motion.at(times)[q], np.cos(times), rtol=0.0, atol=1e-7)


def test_states_at_the_ends_of_steps_take_no_step_again():
    system = oscillator(dop853, MANY)
    dense = system.simulate()._dense
    states = dense(dense.starts)
    assert not dense._workspaces._free  # nothing was reserved for that
    np.testing.assert_allclose(states[:, 0], np.cos(dense.starts), atol=1e-6)
    between = dense(np.append(dense.starts, 2.0) - 1e-9 * np.append(dense.starts > 0.0, True))
    np.testing.assert_allclose(between[1:-1], states[1:], atol=1e-8)


def test_repeated_runs_share_what_is_reserved_and_keep_their_own_numbers(monkeypatch):
    made, reserve = [], workspace.Workspace.__init__

    def noted(self, *args, **options):
        made.append(type(self))
        reserve(self, *args, **options)

    monkeypatch.setattr(workspace.Workspace, "__init__", noted)
    system, stiffness = oscillator("dop853", FEW), (1.0, 2.0, 3.0)

    def run(k):
        system.constants["k"] = k
        return system.simulate(rtol=1e-10, atol=1e-10)

    few = [run(k) for k in stiffness]
    alone = [one.at(MANY).states for one in few]
    assert made.count(workspace.Workspace) == 1
    for k, states in zip(stiffness, alone, strict=True):
        np.testing.assert_allclose(states[:, 0], np.cos(k**0.5 * MANY), atol=1e-8)
    with ThreadPoolExecutor(3) as pool:  # whichever has it
        for _ in range(10):
            for one, states in zip(pool.map(lambda few: few.at(MANY), few), alone, strict=True):
                np.testing.assert_array_equal(one.states, states)
