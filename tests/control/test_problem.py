"""What `OptimalControl` takes, refuses and returns."""

import os
import pickle
import signal
import subprocess
import sys

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from optional import optional
from oracles import optima
from oracles.optima import TF, T
from pydy import System
from pydy.control import OptimalControl, ipopt
from pydy.control.guess import Guess
from pydy.control.ipopt import Iteration
from pydy.control.transcription import Transcription
from pydy.errors import (
    AnalysisInterrupted,
    MissingDependencyError,
    OptimizationError,
    PyDyUserWarning,
)
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.solvers import dop853
from zoo import inertial_frame

plt = optional("matplotlib.pyplot")


@pytest.fixture
def mass():
    return optima.double_integrator()


def energy(F):
    return sm.Integral(F**2, T)


# -- what is asked ---------------------------------------------------------------------------------


def test_names_stand_for_symbols(mass):
    system, (_x, _v, F) = mass
    solution = system.optimize_trajectory(
        energy(F), 1.0, start={"x": 0.0}, end={"x": 1.0, "v": 0.0}, bounds={"F": (None, 100)}
    )
    assert solution.objective == pytest.approx(12.0, rel=1e-8)


def test_a_start_that_is_not_given_is_the_initial_conditions(mass):
    system, (x, v, F) = mass
    system.initial_conditions = {x: 0.5}
    solution = system.optimize_trajectory(energy(F), 1.0, end={x: 1.0, v: 0.0})
    assert solution.objective == pytest.approx(3.0, rel=1e-8)
    freed = system.optimize_trajectory(energy(F), 1.0, start={x: None}, end={x: 1.0, v: 0.0})
    assert freed.objective == pytest.approx(0.0, abs=1e-9)
    between = system.optimize_trajectory(
        energy(F), 1.0, start={x: (-1.0, 0.25)}, end={x: 1.0, v: 0.0}
    )
    assert between.objective == pytest.approx(12.0 * 0.75**2, rel=1e-6)


def test_values_at_instants_of_objective_and_boundary(mass):
    system, (x, _v, F) = mass
    # From rest, ∫ F² with x(1) = 1 and v(1) free is 3; half way it is to be at 0.25 at most.
    miss = 1e4 * (x.subs(T, 1.0) - 1) ** 2
    near = system.optimize_trajectory(energy(F) + miss, 1.0)
    assert near.objective == pytest.approx(3.0, rel=1e-3)
    halfway = system.optimize_trajectory(
        energy(F), 1, end={x: 1.0}, boundary=[x.subs(T, sm.Rational(1, 2)) <= 0.25], mesh=7
    )
    assert halfway.at(0.5)["x"][0] == pytest.approx(0.25, abs=1e-7)
    assert halfway.objective > 3.1
    assert list(halfway.multipliers)[-1] == "x(1/2) <= 0.25"


def test_a_periodic_motion_by_boundary_conditions():
    # ∫ F² of x'' = F + sin t over a period is least with the mean of F zero.
    x, v, F = me.dynamicsymbols("x v F")
    system = optima.first_order([x], v, F + sm.sin(T))
    end = 2 * sm.pi
    solution = system.optimize_trajectory(
        energy(F),
        2 * np.pi,
        start={x: 0.0, v: None},
        boundary=[sm.Eq(v.subs(T, end.n()), v.subs(T, 0)), sm.Eq(x.subs(T, end.n()), 0)],
    )
    assert solution.objective == pytest.approx(0.0, abs=1e-9)
    assert solution["v"][[0, -1]] == pytest.approx([-1.0, -1.0], abs=1e-6)


def test_path_conditions_hold_at_every_collocation_point(mass):
    system, (x, v, F) = mass
    solution = system.optimize_trajectory(
        energy(F), 1.0, end={x: 1.0, v: 0.0}, path=[v + x / 2 <= 1.6]
    )
    assert (solution["v"] + solution["x"] / 2).max() <= 1.6 + 1e-7
    assert solution.objective > 12.01


def test_accelerations_and_outputs_in_objective_and_path(mass):
    system, (x, v, F) = mass
    power = me.dynamicsymbols("power")
    system.outputs = {power: F * v}
    by_rate = system.optimize_trajectory(sm.Integral(v.diff() ** 2, T), 1.0, end={x: 1.0, v: 0.0})
    assert by_rate.objective == pytest.approx(12.0, rel=1e-8)
    limited = system.optimize_trajectory(energy(F), 1.0, end={x: 1.0, v: 0.0}, path=[power <= 4.0])
    assert limited["power"].max() <= 4.0 + 1e-6
    assert limited.objective > 12.0


def test_free_constants():
    # A spring brings the mass to the other side, without a force, if its stiffness is π².
    x, v, F = me.dynamicsymbols("x v F")
    k = sm.Symbol("k")
    system = optima.first_order([x], v, F - k * x, 1, None, {k: 5.0})
    solution = system.optimize_trajectory(
        energy(F), 1.0, start={x: 1.0}, end={x: -1.0, v: 0.0}, free=[k], bounds={k: (1.0, 20.0)}
    )
    assert solution.constants[k] == pytest.approx(np.pi**2, rel=1e-5)
    assert solution.objective == pytest.approx(0.0, abs=1e-9)
    assert system.constants[k] == 5.0


def test_a_free_constant_of_the_objective_and_the_conditions_alone(mass):
    # The farthest mean speed over the least time for a metre at |F| ≤ 1 is 1/2.
    system, (x, v, F) = mass
    c = sm.Symbol("c")
    mean = [sm.Eq(x.subs(T, TF), c * TF), sm.Eq(x.subs(T, TF), 1.0)]
    for key in (c, "c"):
        solution = system.optimize_trajectory(
            -c, TF, end={v: 0.0}, boundary=mean, free=[key],
            bounds={F: (-1, 1), TF: (0.5, 5), key: (0.01, 0.6)},
        )  # fmt: skip
        assert (solution.duration, solution.constants[c]) == pytest.approx((2.0, 0.5), rel=1e-6)
    # The least force that goes a metre in a second: 4 N, by a condition of the path.
    given = {"end": {x: 1.0, v: 0.0}, "path": [abs(F) <= c], "mesh": 4}
    solution = system.optimize_trajectory(c, 1.0, free=[c], **given)
    assert solution.constants == pytest.approx({c: 4.0}, rel=1e-6)
    assert not system.constants_symbols
    with pytest.raises(ValueError, match="`free` has the key `d`, which is not one of the const"):
        system.optimize_trajectory(c, 1.0, free=[c, "d"], **given)
    with pytest.raises(ValueError, match="`objective` has `c`, which is neither a constant"):
        system.optimize_trajectory(c, 1.0, **given)


def test_a_result_as_a_table(mass):
    system, (x, v, F) = mass
    c = sm.Symbol("c")
    given = {"end": {x: 1.0, v: 0.0}, "mesh": 4}
    solution = system.optimize_trajectory(
        energy(F) - c, 1.0, boundary=[x.subs(T, 0.5) >= c], free=[c], **given
    )
    lines = solution.summary().splitlines()
    assert lines[0].startswith("Optimal trajectory: solved after ")
    assert lines[0].endswith(" iterations, radau on 4 intervals")
    assert lines[2].startswith(f"objective  {solution.objective:.9g} ± ")
    assert lines[3] == "duration   1 s"
    assert lines[6].split() == ["c", f"{solution.constants[c]:.8g}"]
    rows = {line.split()[0]: line.split()[1:] for line in lines[9:12]}
    assert rows["x"] == ["0", "1", "0", "1"]
    force = [float(value) for value in rows["F"]]
    assert force == pytest.approx([6.0, -6.0, -6.0, 6.0], rel=0.1)
    assert lines[-1].startswith("errors of intervals, relative to the states: ")
    phases = OptimalControl.phases([OptimalControl(system, energy(F), 1.0, **given)] * 2, [{v: v}])
    both = phases.solve()
    text = both.summary()
    assert text.startswith("PhasedTrajectory: 2 phases")
    assert both[1].summary() in text
    table = both.to_dataframe()
    assert table.index.names == ["phase", "time"]
    np.testing.assert_array_equal(table.loc[1]["x"], both[1]["x"])


def test_known_signals_as_expressions_and_samples():
    x, v, F, wind = me.dynamicsymbols("x v F wind")
    system = optima.first_order([x], v, F + wind)
    times = np.linspace(0.0, 1.0, 101)
    objectives = []
    for value in (sm.cos(3 * T), SampledInput(times, np.cos(3 * times), "pchip")):
        system.specifieds = {wind: value}
        solution = system.optimize_trajectory(energy(F), 1.0, end={x: 1.0, v: 0.0})
        assert solution.controls == (F,)
        objectives.append(solution.objective)
    assert objectives[1] == pytest.approx(objectives[0], rel=1e-5)


@pytest.mark.parametrize("method", ["radau", "hermite-simpson"])
def test_known_samples_under_a_free_duration(method):
    x, v, F, wind = me.dynamicsymbols("x v F wind")
    system = optima.first_order([x], v, F + wind)
    times = np.linspace(0.0, 4.0, 161)
    samples = SampledInput(times, np.sin(3 * times), "pchip")
    search = {"end": {x: 1.0, v: 0.0}, "bounds": {F: (-1.0, 1.0), TF: (0.1, 4.0)},
              "method": method, "mesh_tol": 1e-6}  # fmt: skip
    found = {}
    for name, value in (("formula", sm.sin(3 * T)), ("samples", samples)):
        system.specifieds = {wind: value}
        found[name] = system.optimize_trajectory(TF, TF, **search)
    assert found["samples"].duration == pytest.approx(found["formula"].duration, rel=1e-5)
    np.testing.assert_allclose(
        found["samples"][wind], samples(found["samples"].times), rtol=0, atol=1e-15
    )
    last = found["samples"]
    system.specifieds = {**system.specifieds, **last.inputs()}
    system.times, system.ode_solver = last.mesh, dop853
    end = system.simulate(rtol=1e-10, atol=1e-10).states[-1]
    np.testing.assert_allclose(end, last.states[-1], atol=1e-5)  # ten times mesh_tol


def test_phases_share_a_duration_that_samples_depend_on():
    # The force w(t) = t of each phase's own clock: x' = t²/2 gains v by tf²/2 in each.
    x, v, F, wind = me.dynamicsymbols("x v F wind")
    system = optima.first_order([x], v, F + wind)
    system.specifieds = {wind: SampledInput([0.0, 1.0, 4.0], [0.0, 1.0, 4.0])}
    bounds = {F: (-1e-9, 1e-9), TF: (0.1, 4.0)}
    ends = [{}, {v: 4.0}]
    both = [OptimalControl(system, TF, TF, end=end, bounds=bounds, mesh=3) for end in ends]
    solution = OptimalControl.phases(both).solve()
    assert solution.duration == pytest.approx(4.0, rel=1e-7)
    assert solution[1].duration == pytest.approx(2.0, rel=1e-7)


def test_constraints_move_with_samples_under_a_free_duration():
    # A bead whose speed along x the samples give, by a force of constraint.
    x, y, v, w, F, given = me.dynamicsymbols("x y v w F given")
    ground, rest = inertial_frame()
    bead = rest.locatenew("P", x * ground.x + y * ground.y)
    bead.set_vel(ground, v * ground.x + w * ground.y)
    definition = Definition(
        ground, [x, y], [v, w], bodies=[me.Particle("bead", bead, 1)],
        loads=[(bead, F * ground.y)], velocity_constraints=[v - given],
    )  # fmt: skip
    system = System(definition, initial_conditions={v: 1.0})
    times = np.linspace(0.0, 3.0, 61)
    rows = np.array([np.exp(-times), -np.exp(-times)]).T
    system.specifieds = {(given, given.diff()): SampledInput(times, rows, "pchip")}
    solution = system.optimize_trajectory(
        sm.Integral(F**2, T) + TF, TF, end={x: 0.75, y: 0.1}, bounds={TF: (0.1, 3.0)}
    )
    np.testing.assert_allclose(solution[v], solution[given], atol=1e-8)
    assert solution.duration == pytest.approx(np.log(4.0), rel=1e-5)  # 1 − exp(−t) = 3/4


def test_a_search_that_ends_where_samples_bend_is_told():
    x, v, F, wind = me.dynamicsymbols("x v F wind")
    system = optima.first_order([x], v, F + wind)
    system.specifieds = {wind: SampledInput([0.0, 1.0, 4.0], [0.0, 1.0, -4.0])}
    with pytest.raises(OptimizationError, match=r"samples for wind\(t\) bend.*'pchip'"):
        system.optimize_trajectory(
            TF, TF, end={x: 1.0, v: 0.0}, bounds={F: (-1, 1), TF: (0.1, 4.0)},
            options={"max_iter": 2},
        )  # fmt: skip


def test_no_control_is_a_boundary_value_problem():
    x, v = me.dynamicsymbols("x v")
    system = optima.first_order([x], v, -x)
    solution = system.optimize_trajectory(
        sm.S(0), 1.0, start={x: 0.0, v: None}, end={x: 1.0}, order=6
    )
    assert solution["v"][0] == pytest.approx(1.0 / np.sin(1.0), rel=1e-10)
    assert solution.inputs() == {}


def test_units_do_not_change_the_search():
    histories = []
    for unit in (1.0, 1e-9, 1e9):
        x, v, F = me.dynamicsymbols("x v F")
        system = optima.first_order([x], v, F, 2.0 * unit)
        solution = system.optimize_trajectory(
            TF, TF, end={x: unit, v: 0.0}, bounds={F: (-50 * unit**2, 50 * unit**2), TF: (0.1, 5.0)}
        )
        assert solution.objective == pytest.approx(0.4, rel=1e-6)
        histories.append(len(solution.history))
    assert len(set(histories)) == 1


# -- what comes back -------------------------------------------------------------------------------


@pytest.mark.parametrize(("far", "rel"), [(1e3, 1e-8), (1e6, 1e-4), (-1e9, 1e-4)])
@pytest.mark.parametrize("method", ["radau", "hermite-simpson"])
def test_a_short_way_far_from_the_origin_is_gone(mass, far, rel, method):
    # 1e-8 of the distance from the origin, which is the tolerance, is the whole way and more.
    system, (x, v, F) = mass
    way = {1e3: 0.5, 1e6: 1e-3, -1e9: 1.0}[far]
    solution = system.optimize_trajectory(
        sm.Integral(F**2, T), 1.0, start={x: far}, end={x: far + way, v: 0.0}, method=method, mesh=6
    )
    assert solution.objective == pytest.approx(12.0 * (far + way - far) ** 2, rel=rel)


@pytest.mark.parametrize("bound", [1e9, 1e20])
def test_wide_bounds_do_not_change_the_search(mass, bound):
    system, (x, v, F) = mass
    limits = dict.fromkeys((x, v, F), (None, bound))
    found, same = (
        system.optimize_trajectory(energy(F), 1.0, end={x: 1.0, v: 0.0}, bounds=bounds, order=2)
        for bounds in (limits, {})
    )
    assert found.objective == pytest.approx(same.objective, rel=1e-8)
    assert found[F] == pytest.approx(same[F], abs=1e-5)
    assert found.error == pytest.approx(same.error, rel=1e-3)


@pytest.mark.parametrize("method", ["radau", "hermite-simpson"])
def test_a_short_interval_does_not_loosen_the_equations_of_others(mass, method):
    system, (x, v, F) = mass
    mesh = np.sort(np.append(np.linspace(0.0, 1.0, num=6), 0.4 + 1e-12))
    solution = system.optimize_trajectory(
        energy(F), 1.0, end={x: 1.0, v: 0.0}, mesh=mesh, method=method
    )
    assert solution.objective == pytest.approx(12.0, rel=1e-8)
    assert solution.error.max() < 1e-9


def test_a_mesh_that_is_much_too_coarse_warns():
    system = n_link_pendulum_on_cart(1, cart_force=True)
    (force,), angle = system.specifieds_symbols, system.states[1]
    problem = OptimalControl(
        system, energy(force), 400.0, start={angle: 1.0}, end={angle: 0.0}, mesh=2, order=2
    )
    with pytest.warns(PyDyUserWarning, match="The mesh is too coarse: .* Use more intervals"):
        problem.solve()


def test_errors_of_intervals_that_add_up_are_warned_of(monkeypatch):
    # In the middle of intervals the angle may be a turn off, which the equations do not see: the
    # objective is right, and the control between the points brings the bead elsewhere.
    monkeypatch.setattr("pydy.control.search._without_turns", lambda nlp, z, parts: z)
    system, (x, y, v, angle) = optima.brachistochrone()
    asked = {"end": {x: 2.0, y: 2.0}, "bounds": {TF: (0.1, 5.0)}, "method": "hermite-simpson"}
    guess = {v: [0.0, 6.0], angle: [0.0, 1.5]}
    with pytest.warns(PyDyUserWarning, match="errors of its intervals add up to 1.*`mesh_tol`"):
        solution = system.optimize_trajectory(TF, TF, guess=guess, **asked)
    assert solution.error.max() < 0.1
    system.specifieds, system.times, system.ode_solver = solution.inputs(), solution.mesh, dop853
    missed = np.abs(system.simulate(rtol=1e-9, atol=1e-9).states[-1] - solution.states[-1])
    assert missed.max() > 1.0


@pytest.mark.parametrize("method", ["radau", "hermite-simpson", "midpoint"])
def test_an_angle_as_a_control_has_no_turns_that_nothing_depends_on(method):
    system, (x, y, v, angle) = optima.brachistochrone()
    asked = {"end": {x: 2.0, y: 2.0}, "bounds": {TF: (0.1, 5.0)}, "method": method}
    solution = system.optimize_trajectory(
        TF, TF, guess={v: [0.0, 6.0], angle: [0.0, 1.5]}, mesh=40, **asked
    )
    assert np.abs(np.diff(solution[angle])).max() < 0.1
    assert -0.1 < solution[angle].min() < solution[angle].max() < 1.5
    assert solution.error.max() < 1e-3
    # A number that is no angle stays where its square says.
    system, (x, v, F) = optima.double_integrator()
    solution = system.optimize_trajectory(
        sm.Integral((F - 100 * T) ** 2, T), 1.0, mesh=2, order=2, end={v: 50.0}
    )
    np.testing.assert_allclose(solution[F], 100 * solution.times, atol=1e-6)


def test_a_duration_of_zero_is_told():
    system, (x, v, F) = optima.double_integrator()
    with pytest.raises(OptimizationError, match=r"a duration of zero .*`bounds\[tf\]` a positive"):
        system.optimize_trajectory(
            sm.Integral(F**2, T) + TF, TF, end={x: 0.0, v: 0.0}, bounds={TF: (0.0, 5.0)},
            guess={TF: 1.0},
        )  # fmt: skip


def test_a_simulation_with_the_inputs_agrees(mass):
    system, (q1, q2, u1, u2, F) = optima.cart_pole()
    rest = {q1: 0.3, q2: 0.0, u1: 0.0, u2: 0.0}
    solution = system.optimize_trajectory(energy(F), 1.0, end=rest, mesh_tol=1e-7)
    assert solution.error.max() <= 1e-7
    system.specifieds = solution.inputs()
    system.ode_solver = dop853
    system.times = solution.mesh
    run = system.simulate(rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(run.states, solution.at(solution.mesh).states, atol=1e-5)


@pytest.mark.parametrize("method", ["radau", "hermite-simpson"])
def test_simulations_from_each_node_end_within_the_errors_of_an_unstable_motion(method):
    system, (q1, q2, u1, u2, F) = optima.cart_pole()
    upright = {q1: 1.0, q2: np.pi, u1: 0.0, u2: 0.0}
    bounds = {F: (-20.0, 20.0), q1: (-2.0, 2.0)}
    asked = {"end": upright, "bounds": bounds, "method": method, "mesh_tol": 1e-6}
    solution = system.optimize_trajectory(energy(F), 2.0, mesh=40, **asked)
    assert solution.error.max() < 1e-6
    nodes = solution.at(solution.mesh).states
    sizes = np.abs(nodes).max(axis=0)
    system.specifieds, system.ode_solver = solution.inputs(), dop853

    def missed(first, last):
        system.initial_conditions = dict(zip(system.states, nodes[first], strict=True))
        system.times = solution.mesh[[first, last]]
        end = system.integrate(rtol=1e-11, atol=1e-12)[-1]
        return np.abs((end - nodes[last]) / sizes).max()

    errors = [missed(k, k + 1) for k in range(len(solution.error))]
    np.testing.assert_allclose(errors, solution.error, rtol=0.1, atol=1e-9)
    # From the start on they grow, by some ten times their sum.
    assert solution.error.sum() < missed(0, -1) < 30 * solution.error.sum()


@pytest.mark.parametrize(("method", "tolerance"), [("radau", 1e-8), ("hermite-simpson", 1e-6)])
def test_a_simulation_from_the_start_ends_within_ten_tolerances(method, tolerance):
    solution = optima.kelly(mesh=40, method=method)[0].solve(mesh_tol=tolerance)
    system, _ = optima.cart_pole()
    system.specifieds, system.times, system.ode_solver = solution.inputs(), solution.mesh, dop853
    nodes = solution.at(solution.mesh).states
    off = np.abs(system.integrate(rtol=1e-12, atol=1e-13) - nodes) / np.abs(nodes).max(axis=0)
    assert off.max() < 10 * tolerance
    # The errors of intervals alone would have let it be 20 and 11 tolerances beside.
    assert solution.error.max() < 0.2 * tolerance


def test_a_finer_mesh_that_is_in_vain_leaves_what_was_within_the_tolerance(monkeypatch):
    problem, _ = optima.kelly(mesh=40)
    solved, errors = problem._solved, []

    def once_more(*given):
        if errors and errors[-1] < 1e-8:
            raise OptimizationError("no step", None)
        found, phases = solved(*given)
        errors.append(found.error.max())
        return found, phases

    monkeypatch.setattr(problem, "_solved", once_more)
    assert problem.solve(mesh_tol=1e-8).error.max() == errors[-1]
    assert len(errors) == 2


def test_a_motion_that_is_unstable_for_long_has_the_mesh_of_its_intervals():
    # x'' = 25 x - 5 x³ + F: in 20 s what is beside it by a rounding is anywhere.
    x, v, F = me.dynamicsymbols("x v F")
    system = optima.first_order([x], v, F + 25 * x - 5 * x**3)
    ends = {"start": {x: 1.0, v: 0.0}, "end": {x: 0.3, v: 0.0}, "mesh_tol": 1e-4}
    meshes = [
        system.optimize_trajectory(sm.Integral(F**2 + x**2, T), duration, **ends).mesh
        for duration in (2.0, 20.0)
    ]
    assert len(meshes[1]) < 60
    assert len(meshes[0]) > 21  # in 2 s errors grow by 2e4, and 20 intervals are not enough


@pytest.mark.parametrize("method", ["radau", "hermite-simpson", "midpoint", "backward-euler"])
def test_errors_of_intervals_fall_with_the_order_of_the_method(method):
    system, (q1, q2, u1, u2, F) = optima.cart_pole()
    end = {q1: 0.3, q2: 0.2, u1: 0.0, u2: 0.0}
    errors = []
    for mesh in (20, 40):
        problem = OptimalControl(system, energy(F), 1.0, end=end, method=method, order=2, mesh=mesh)
        errors.append(problem.solve().error.max())
    order = {"radau": 3, "hermite-simpson": 4, "midpoint": 2, "backward-euler": 1}[method]
    # One order more within a single interval.
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order + 1, abs=0.8)


def test_a_mesh_is_refined_where_it_must_be():
    system, (x, u) = optima.hypersensitive()
    solution = system.optimize_trajectory(
        sm.Integral(x**2 + u**2, T), 1e3, start={x: 1.0}, end={x: 1.5}, mesh=10, mesh_tol=1e-3
    )
    assert solution.error.max() <= 1e-3
    assert solution.objective == pytest.approx(6.7241, rel=1e-2)
    lengths = np.diff(solution.mesh)
    assert lengths.max() > 20 * lengths.min()


def test_a_mesh_is_refined_where_a_control_jumps(mass):
    system, (x, v, F) = mass
    solution = system.optimize_trajectory(
        TF,
        TF,
        end={x: 1.0, v: 0.0},
        bounds={F: (-1, 1), TF: (0.1, 9)},
        mesh=[0.0, 0.3, 0.63, 1.0],
        mesh_tol=1e-4,
    )
    assert solution.duration == pytest.approx(2.0, rel=1e-4)
    assert np.abs(solution.mesh - 1.0).min() < 1e-4
    assert len(solution.error) < 10
    assert np.abs(solution["F"]).max() <= 1.0


def test_a_trajectory_with_labels_multipliers_and_history(mass):
    system, (x, v, F) = mass
    solution = system.optimize_trajectory(energy(F), 1.0, end={x: 1.0, v: 0.0}, mesh=5)
    assert solution.names == ("x", "v", "F")
    assert solution.status == 0
    assert solution.message == "solved"
    assert repr(solution).startswith("OptimalTrajectory of x, v, F at 16 times from 0.0 to 1.0, ")
    assert solution.history[-1].violation < 1e-9
    assert list(solution.multipliers) == ["kinematics of x", "motion of v"]
    assert solution.collocation_times.shape == solution.multipliers["motion of v"].shape == (15,)
    assert (np.diff(solution.collocation_times) > 0).all()
    between = solution.at(np.linspace(0, 1, 33))
    np.testing.assert_allclose(between["x"], 3 * between.times**2 - 2 * between.times**3, atol=1e-9)
    np.testing.assert_allclose(between["F"], 6 - 12 * between.times, atol=1e-7)
    np.testing.assert_allclose(solution.derivatives[:, 1], solution["F"], atol=1e-9)
    dataset = solution.to_dataframe()
    assert list(dataset.columns) == ["x", "v", "F"]


def test_multipliers_are_derivatives_of_the_objective(mass):
    # 12 d² for a distance d: 24 d of a change of d, which the boundary condition sets.
    system, (x, v, F) = mass
    solution = system.optimize_trajectory(
        energy(F), 1.0, end={v: 0.0}, boundary=[sm.Eq(x.subs(T, 1.0), 1.0)]
    )
    assert solution.multipliers["Eq(x(1.0), 1.0)"][0] == pytest.approx(24.0, rel=1e-6)


def test_a_solution_starts_the_next_search(mass):
    system, (q1, q2, u1, u2, F) = optima.cart_pole()
    end = {q1: 1.0, q2: np.pi, u1: 0.0, u2: 0.0}
    problem = OptimalControl(system, energy(F), 2.0, end=end)
    first = problem.solve()
    again = problem.solve(first)
    assert len(again.history) < len(first.history) / 2
    assert again.objective == pytest.approx(first.objective, rel=1e-8)


def test_a_simulation_is_a_guess(mass):
    system, (x, v, F) = mass
    system.times = np.linspace(0.0, 3.0, 31)
    system.specifieds = {F: 0.1}
    guess = system.simulate()
    system.specifieds = {}
    solution = system.optimize_trajectory(
        TF, TF, end={x: 1.0, v: 0.0}, bounds={F: (-1, 1)}, guess=guess
    )
    assert solution.objective == pytest.approx(2.0, rel=1e-6)


# -- what goes wrong -------------------------------------------------------------------------------


@pytest.mark.parametrize("method", ["radau", "hermite-simpson", "midpoint"])
def test_bounds_are_kept_to_the_last_digit(method):
    system, (x, v, F) = optima.double_integrator()
    limits = {F: (-1.0, 1.0), v: (None, 0.6), TF: (2.0, 10.0)}
    end = {x: 1.0, v: 0.0}
    solution = system.optimize_trajectory(TF, TF, end=end, bounds=limits, method=method, mesh=7)
    values, controls, _, _ = solution._transcription.split(solution.solution.z)
    assert np.abs(controls).max() == 1.0
    assert values[1, :8].max() == 0.6


@pytest.mark.parametrize("method", ["radau", "midpoint"])
def test_equations_without_accelerations_are_not_solved(method):
    m = sm.Symbol("m")
    system, (x, v, F) = optima.double_integrator(m)
    system.constants = {m: 0.0}
    with pytest.raises(OptimizationError, match=r"no accelerations .*; zero are: m\."):
        system.optimize_trajectory(energy(F), 1.0, end={x: 1.0, v: 0.0}, method=method)


@pytest.mark.parametrize("force", [lambda u: u**2, lambda u: 1 - sm.cos(u)])
def test_a_control_that_changes_nothing_at_the_guess_is_the_reason(force):
    x, v, u = me.dynamicsymbols("x v u")
    system = optima.first_order([x], v, force(u))
    with pytest.raises(OptimizationError, match=r"by `u\(t\)` are zero.*Give a `guess`") as e:
        system.optimize_trajectory(energy(u), 1.0, end={x: 0.5})
    assert "contradict" not in str(e.value)
    system.optimize_trajectory(energy(u), 1.0, end={x: 0.5}, guess={u: 0.5}, mesh=40)


def test_a_search_that_fails_holds_the_iterate_and_names_equations(mass):
    system, (x, v, F) = mass
    with pytest.raises(
        OptimizationError, match=r"contradict each other.*Violated most.*(x|v)"
    ) as e:
        system.optimize_trajectory(
            energy(F), 1.0, end={x: 1.0, v: 0.0}, bounds={F: (-1.0, 1.0)}, mesh=5
        )
    assert e.value.trajectory["x"].shape == (16,)
    assert e.value.trajectory.status == 2
    with pytest.raises(OptimizationError, match="`max_iter` iterations were not enough"):
        system.optimize_trajectory(
            TF, TF, end={x: 1.0, v: 0.0}, bounds={F: (-1, 1), TF: (1, 5)}, options={"max_iter": 2}
        )


def test_ctrl_c_ends_a_search_within_an_iteration(mass, monkeypatch):
    system, (x, v, F) = mass
    problem = OptimalControl(system, TF, TF, end={x: 1.0, v: 0.0}, bounds={F: (-1, 1), TF: (1, 5)})
    ipopt.library()  # which is tried with a search of its own
    calls = []

    def pressed(*iteration):
        calls.append(iteration)
        if len(calls) == 3:
            os.kill(os.getpid(), signal.SIGINT)
        return Iteration(*iteration)

    monkeypatch.setattr(ipopt, "Iteration", pressed)
    # A shell has what runs in its background ignore Ctrl-C.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(AnalysisInterrupted, match="interrupted") as error:
            problem.solve()
    finally:
        signal.signal(signal.SIGINT, before)
    assert 3 <= len(error.value.results.history) <= 4
    assert error.value.results.message == "stopped"


def test_an_error_in_a_callback_is_raised(mass, monkeypatch):
    system, (x, v, F) = mass
    problem = OptimalControl(system, TF, TF, end={x: 1.0, v: 0.0}, bounds={F: (-1, 1), TF: (1, 5)})
    ipopt.library()  # which is tried with a search of its own
    calls = []

    def broken(*iteration):
        calls.append(iteration)
        if len(calls) == 3:
            raise MemoryError("no more")
        return Iteration(*iteration)

    monkeypatch.setattr(ipopt, "Iteration", broken)
    with pytest.raises(MemoryError, match="no more") as caught:
        problem.solve()
    assert caught.value.__notes__[0].startswith("The latest iteration of the search")
    assert len(caught.value.results.history) == 2


def test_what_is_raised_on_the_way_into_a_callback_arrives(mass, uncollected, capfd):
    system, (x, v, F) = mass
    problem = OptimalControl(system, TF, TF, end={x: 1.0, v: 0.0}, bounds={F: (-1, 1), TF: (1, 5)})
    problem.solve()

    class AlarmError(Exception):
        pass

    for late in range(5):
        calls = []

        def ring(frame, what, _, calls=calls, late=late):
            if what == "call" and frame.f_code.co_name == "guarded":
                calls.append(frame)
                if len(calls) == late + 1:
                    raise AlarmError  # as the handler of a signal does, before the first line

        sys.setprofile(ring)
        try:
            with pytest.raises(AlarmError):
                problem.solve()
        finally:
            sys.setprofile(None)
    assert "ignored" not in capfd.readouterr().err


def test_without_casadi_the_extra_is_named(mass, monkeypatch):
    system, (x, _v, F) = mass
    monkeypatch.setattr(ipopt, "find_spec", lambda name: None)
    ipopt.library.cache_clear()
    try:
        with pytest.raises(MissingDependencyError, match=r"pip install 'pydy\[optimal\]'"):
            system.optimize_trajectory(energy(F), 1.0, end={x: 1.0})
    finally:
        ipopt.library.cache_clear()


def test_solving_does_not_load_casadi():
    code = """
import sys
import sympy as sm, sympy.physics.mechanics as me
from pydy.mechanics import Definition
from pydy.system import System
(x, F), N, O = me.dynamicsymbols("x F"), me.ReferenceFrame("N"), me.Point("O")
O.set_vel(N, 0)
P = O.locatenew("P", x * N.x)
body, v = me.Particle("b", P, 1), me.dynamicsymbols("v,")
made = Definition(N, [x], v, bodies=[body], loads=[(P, F * N.x)])
t = me.dynamicsymbols._t
System(made).optimize_trajectory(sm.Integral(F**2, t), 1.0, start={x: 0.0}, end={x: 1.0})
sys.exit("casadi" in sys.modules)
"""
    # In a process of its own: other tests load it.
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def refused(message, system, *arguments, error=ValueError, **options):
    with pytest.raises(error, match=message):
        OptimalControl(system, *arguments, **options).check()


def test_bad_arguments_are_told(mass):
    system, (x, _v, F) = mass
    J = energy(F)
    refused("`system` must be a pydy.system.System", 3, J, 1.0, error=TypeError)
    refused("`objective` must be SymPy expressions", system, "F", 1.0)
    refused("`objective` has `x\\(t\\)`", system, x**2, 1.0)
    refused("`objective` must be a sum of integrals", system, J**2, 1.0)
    refused("integrals are over the whole", system, sm.Integral(F**2, (T, 0, 0.5)), 1.0)
    refused("with a value at an instant", system, sm.Integral(F * x.subs(T, 1.0), T), 1.0)
    refused("instants lie between 0 and 1.0", system, J + x.subs(T, 2.0), 1.0)
    refused("part of it, such as tf/2", system, x.subs(T, 2.0), TF, bounds={TF: (1, 2)})
    refused("`duration` must be positive, or a Symbol", system, J, 0.0)
    refused("`duration` must be a real number", system, J, None)
    slack = me.dynamicsymbols("slack")
    refused(r"`path` has `slack\(t\)`.*an output", system, J, 1.0, path=[F + slack >= 1])
    refused(r"`objective` has `slack\(t\)`", system, sm.Integral(slack**2, T), 1.0)
    refused("`start` has the key `y`", system, J, 1.0, start={"y": 0.0})
    refused(r"`end\[x\]` must be a real number", system, J, 1.0, end={"x": "fast"})
    refused(r"`end\[x\]` must be a pair with low <= high", system, J, 1.0, end={"x": (1, 0)})
    refused(r"`bounds\[F\]` must be a pair", system, J, 1.0, bounds={"F": 3.0})
    refused("`free` has the key `k`", system, J, 1.0, free=["k"])
    refused("`mesh` must be a whole number", system, J, 1.0, mesh=0)
    refused("`mesh` must be strictly ascending, got 1.0 after 2.0", system, J, 1.0, mesh=[0, 2, 1])
    refused("`method` must be one of", system, J, 1.0, method="euler")
    refused("`order` must be a whole number", system, J, 1.0, order=0)
    refused("`order` must be at most 50, got 51", system, J, 1.0, order=51)
    refused("`mesh` must hold real numbers", system, J, 1.0, mesh=[[1.0], 2.0])
    refused("`boundary` must hold equations and", system, J, 1.0, boundary=[x.subs(T, 0)])
    refused("`path` must hold equations and inequ", system, J, 1.0, path=[sm.Ne(x, 0)])
    refused("`boundary` must be a sequence", system, J, 1.0, boundary=3, error=TypeError)
    for objective in (sm.nan, sm.zoo):
        refused("`objective` must be .*, got (nan|zoo)", system, objective, 1.0)
    for name, always in (("path", x <= sm.oo), ("boundary", x.subs(T, 1) >= -sm.oo)):
        refused(f"`{name}` has .*oo`, which is not finite", system, J, 1.0, **{name: [always]})
    jerk = sm.Eq(x.diff().subs(T, 0), 0)
    refused(r"`boundary` has `Subs\(Derivative\(x", system, J, 1.0, boundary=[jerk])


def test_numbers_of_options_may_be_integers_and_the_reverse(mass, capfd):
    """IPOPT would describe an option of another type on the terminal."""
    system, (x, v, F) = mass
    options = {"tol": 1, "max_cpu_time": np.int64(60), "max_iter": 50.0, "mumps_pivot_order": 6.0}
    system.optimize_trajectory(energy(F), 1.0, end={x: 1.0, v: 0.0}, mesh=3, options=options)
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("options", "error", "said"),
    [
        ({"bounds": {TF: (-3, 0)}}, ValueError, r"`bounds\[tf\]` must allow a positive duration"),
        ({"mesh_tol": 1e-15}, ValueError, "`mesh_tol` must be at least 1.5e-14"),
        ({"options": {1: 2}}, TypeError, "`options` must hold numbers, strings, .* got 1: 2"),
        ({"options": {"tol": None}}, TypeError, "`options` must hold .* 'tol': None"),
        ({"options": {"tol": np.nan}}, TypeError, "`options` must hold .* 'tol': nan"),
        ({"options": {"\ud800": 1}}, ValueError, "which IPOPT does not know"),
        ({"options": {"max_iter": 2**40}}, ValueError, "'max_iter': 1099511627776, which IPOPT"),
        ({"options": {"tol": 10**400}}, ValueError, "`options` has 'tol'"),
        ({"options": {"tol": np.timedelta64(1)}}, TypeError, "`options` must hold .* 'tol'"),
        ({"options": {"linear_solver": "ma57"}}, OptimizationError, "does not take its `options`"),
    ],
)
def test_faults_of_options_and_of_the_duration_are_told(mass, options, error, said):
    system, (x, v, F) = mass
    options = {"bounds": {TF: (0.5, 2.0)}, "mesh": 3, **options}
    with pytest.raises(error, match=said):
        system.optimize_trajectory(energy(F), TF, end={x: 1.0, v: 0.0}, **options)


def test_the_bounds_of_a_duration_may_reach_below_zero(mass):
    system, (x, v, F) = mass
    solution = system.optimize_trajectory(
        TF, TF, end={x: 1.0, v: 0.0}, bounds={F: (-1, 1), TF: (-9, 3)}
    )
    assert solution.duration == pytest.approx(2.0, abs=1e-3)


def test_an_objective_that_is_not_finite_is_named(mass):
    system, (x, v, F) = mass
    said = "after 0 iterations: .* The objective or its derivatives are not finite there"
    with pytest.raises(OptimizationError, match=said):
        system.optimize_trajectory(sm.Integral(sm.log(F), T), 1.0, end={x: 1.0, v: 0.0}, mesh=3)


def test_why_the_library_of_ipopt_is_not_loaded_is_told(monkeypatch):
    def broken(path):
        raise OSError("failed to map segment")

    monkeypatch.setattr(ipopt.ctypes, "CDLL", broken)
    with pytest.raises(MissingDependencyError, match=r"with it \(failed to map segment\)"):
        ipopt.library.__wrapped__()


def test_contradictions_are_told_before_the_search(mass):
    system, (x, v, F) = mass
    J = energy(F)
    refused(r"`end\[x\(t\)\]` is 1.0, which the `bounds` \(None, 0.5\) exclude", system, J, 1.0,
            end={x: 1.0}, bounds={x: (None, 0.5)})  # fmt: skip
    refused("give `bounds` for it, {tf:", system, TF, TF, end={x: 1.0})
    every = [sm.Eq(F, 0)]
    refused("equations for .* unknowns", system, J, 1.0, end={x: 1.0, v: 0.0}, path=every)
    problem = OptimalControl(system, J, 1.0, bounds={F: (-1.0, 1.0)})
    with pytest.raises(ValueError, match=r"`guess\[F\(t\)\]` must lie within its `bounds`"):
        problem.check({F: 3.0})
    with pytest.raises(ValueError, match="`guess` has the key `z`"):
        problem.check({"z": 3.0})
    with pytest.raises(ValueError, match=r"`guess\[F\(t\)\]` must be a finite number"):
        problem.check({F: [0.0, np.nan]})
    with pytest.raises(ValueError, match="`options` has 'maxiter'"):
        problem.solve(options={"maxiter": 3})


def test_what_cannot_be_done_yet_is_told():
    x, v, F, wind = me.dynamicsymbols("x v F wind")
    system = optima.first_order([x], v, F + wind)
    system.specifieds = {wind: lambda x, t: 1.0}
    refused("gives a Python function for wind", system, energy(F), 1.0)
    system.specifieds = {wind: SampledInput([0.0, 1.0], [0.0, 1.0], "previous")}
    refused("'previous' for wind.*would jump", system, TF, TF, bounds={TF: (0.5, 1)})
    system.specifieds = {wind: SampledInput([0.0, 1.0], [0.0, 1.0])}
    for bounds, got in (({TF: (1, 2)}, "0.0 to 2.0"), ({}, "0.0 to inf")):
        refused(rf"`bounds\[tf\]` must .* wind\(t\), 0.0 to 1.0, got {got}", system, TF, TF,
                bounds=bounds)  # fmt: skip
    refused("`duration` must lie within the times of the SampledInput", system, energy(F), 2.0)


def test_a_jump_that_no_mesh_meets_is_warned_of(monkeypatch, mass):
    from pydy.control import search

    monkeypatch.setattr(search, "MOST_REFINEMENTS", 1)
    system, (q1, _q2, _u1, _u2, F) = optima.cart_pole()
    with pytest.warns(PyDyUserWarning, match="After 0 refinements the mesh of 4 intervals"):
        system.optimize_trajectory(energy(F), 1.0, end={q1: 0.3}, mesh=4, mesh_tol=1e-12)


def test_a_refined_mesh_has_nodes_where_controls_jump():
    # A metre in 4 s with the least fuel: F = 1 until t (4 − t) = 1, and −1 as long at the end.
    x, v, F, G = me.dynamicsymbols("x v F G")
    system = optima.first_order([x], v, F - G)
    problem = OptimalControl(
        system, sm.Integral(F + G, T), 4.0, end={x: 1.0, v: 0.0},
        bounds={F: (0.0, 1.0), G: (0.0, 1.0)},
    )  # fmt: skip
    solution = problem.solve(mesh_tol=1e-6)
    once = 2.0 - np.sqrt(3.0)
    assert solution.objective == pytest.approx(2.0 * once, rel=1e-6)
    assert len(solution.mesh) < 45
    for jump in (once, 4.0 - once):
        assert np.abs(solution.mesh - jump).min() < 1e-5


def test_refinement_ends_where_it_is_in_vain():
    # Cheap control: an impulse at the start, which no mesh resolves, makes the objective zero.
    system, (x, v, F) = optima.double_integrator()
    off = sm.Integral((x - sm.sin(3 * T)) ** 2, T)
    problem = OptimalControl(system, off, 3.0, start={x: 1.0, v: 3.0})
    with pytest.warns(PyDyUserWarning, match=r"After 2 .* 320 intervals has an objective of .* ± "):
        solution = problem.solve(mesh_tol=1e-6)
    assert len(solution.error) == 320
    # Nor where the motion has an error that never falls.
    system, (_, angle, _, _, F) = optima.cart_pole()
    off = sm.Integral((angle - sm.sin(3 * T)) ** 2, T)
    problem = OptimalControl(system, off, 3.0, start={angle: 1.0})
    with pytest.warns(
        PyDyUserWarning, match=r"of 320 intervals has an error of .* above `mesh_tol`"
    ):
        problem.solve(mesh_tol=1e-5)
    # Jumps take more meshes, and few intervals.
    system, (x, v, F) = optima.double_integrator()
    problem = OptimalControl(
        system, TF, TF, end={x: 1.0, v: 0.0}, bounds={F: (-1.0, 1.0), TF: (0.1, 9.0)}, mesh=3
    )
    assert problem.solve(mesh_tol=1e-6).error.max() <= 1e-6


def test_a_trajectory_is_pickled(mass):
    system, (x, v, F) = mass
    solution = system.optimize_trajectory(energy(F), 1.0, end={x: 1.0, v: 0.0}, mesh=4)
    again = pickle.loads(pickle.dumps(solution))
    assert again.objective == solution.objective
    np.testing.assert_array_equal(again.specifieds, solution.specifieds)
    np.testing.assert_array_equal(
        again.multipliers["motion of v"], solution.multipliers["motion of v"]
    )


def test_a_saved_optimum_is_loaded_as_a_trajectory(mass, tmp_path):
    system, (x, v, F) = mass
    solution = system.optimize_trajectory(energy(F), 1.0, end={x: 1.0, v: 0.0}, mesh=4)
    solution.save(tmp_path / "found.nc")
    loaded = type(solution).load(tmp_path / "found.nc")
    np.testing.assert_array_equal(loaded.states, solution.states)


def test_derivatives_that_are_speeds_have_values_at_instants():
    q, F = me.dynamicsymbols("q F")
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, q.diff() * frame.x)
    body = me.Particle("b", point, 1)
    method = me.LagrangesMethod(
        me.Lagrangian(frame, body),
        [q],
        forcelist=[(point, F * frame.x)],
        frame=frame,
        bodies=[body],
    )
    system = System(method)
    solution = system.optimize_trajectory(
        energy(F), 1.0, end={q: 1.0}, boundary=[sm.Eq(q.diff().subs(T, 1), 0)]
    )
    assert solution.objective == pytest.approx(12.0, rel=1e-8)
    last = system.optimize_trajectory(
        energy(F) + 1e4 * q.diff().subs(T, TF) ** 2, TF, end={q: 1.0}, bounds={TF: (0.5, 1.0)}
    )
    assert last.objective == pytest.approx(12.0, rel=1e-2)
    assert abs(last.at(last.duration)[q.diff()][0]) < 0.01


def test_a_control_is_not_the_derivative_of_another():
    x, v, place = me.dynamicsymbols("x v place")
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, (v + place.diff()) * frame.x)
    made = Definition(
        frame, [x], [v], bodies=[me.Particle("p", point, 1)], loads=[(point, place * frame.x)]
    )
    refused("it would not be the derivative", System(made),
            sm.S(0), 1.0, error=NotImplementedError)  # fmt: skip


def test_an_error_is_pickled(mass):
    error = OptimizationError("no", None)
    assert pickle.loads(pickle.dumps(error)).args == ("no",)


def test_a_model_of_the_package():
    system = n_link_pendulum_on_cart(1)
    (F,) = system.specifieds_symbols
    still = dict.fromkeys(system.states, 0.0)
    solution = system.optimize_trajectory(
        energy(F), 2.0, end={**still, system.coordinates[0]: 0.5}, mesh_tol=1e-5
    )
    assert solution.error.max() <= 1e-5
    scene = system.scene().animate(solution)
    assert scene is not None


def test_other_hessians_find_the_same_and_a_solution_is_a_warm_start():
    system, (q1, q2, u1, u2, F) = optima.cart_pole()
    ends = {"end": {q1: 0.5, q2: 0.5, u1: 0.0, u2: 0.0}, "bounds": {F: (-9.0, 9.0)}, "mesh": 10}
    objective = sm.Integral(F**2, T)
    solution = OptimalControl(system, objective, 1.0, **ends).solve()
    for hessian in ("gauss-newton", "lbfgs"):
        other = OptimalControl(system, objective, 1.0, hessian=hessian, **ends)
        assert other.solve().objective == pytest.approx(solution.objective, rel=1e-7)
    again = OptimalControl(system, objective, 1.0, **ends).solve(solution)
    assert len(again.history) < 0.5 * len(solution.history)
    assert again.objective == pytest.approx(solution.objective, rel=1e-9)
    finer = OptimalControl(system, objective, 1.0, **{**ends, "mesh": 14}).solve(solution)
    assert finer.objective == pytest.approx(solution.objective, rel=1e-3)


def test_a_sweep_goes_on_from_the_neighbour():
    system, (q1, q2, u1, u2, F) = optima.cart_pole()
    problem = OptimalControl(
        system, sm.Integral(F**2, T), 1.0, end={q1: 0.5, q2: 0.5, u1: 0.0, u2: 0.0}, mesh=8
    )
    masses = [0.3, 0.35, 0.4]
    found = problem.sweep({"m2": masses})
    for motion, mass in zip(found, masses, strict=True):
        assert motion.constants[sm.Symbol("m2")] == mass
        system.constants = {**system.constants, sm.Symbol("m2"): mass}
        alone = system.optimize_trajectory(
            sm.Integral(F**2, T), 1.0, end={q1: 0.5, q2: 0.5, u1: 0.0, u2: 0.0}, mesh=8
        )
        assert motion.objective == pytest.approx(alone.objective, rel=1e-8)
        assert motion.error.max() < 1e-2  # with the constants of its own
    assert len(found[1].history) < len(found[0].history)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({}, "`values` must map at least one constant"),
        ({"m9": [1.0]}, "`values` has the key `m9`"),
        ({"m2": [1.0], "l": [1.0, 2.0]}, r"as many as for the others, got the shape \(2,\)"),
        ({"m2": [np.nan]}, "must be finite numbers"),
        ({"m1": [1.0]}, "`values` has `m1`, which is `free`"),
    ],
)
def test_bad_values_of_a_sweep_are_named(values, message):
    system, (*_, F) = optima.cart_pole()
    problem = OptimalControl(system, sm.Integral(F**2, T), 1.0, free=["m1"])
    with pytest.raises((ValueError, TypeError), match=message):
        problem.sweep(values)


def test_what_the_hessian_of_gauss_and_newton_needs_is_told():
    system, (x, _v, F) = optima.double_integrator()
    for objective, message in [
        (sm.Integral(F**2 + x, T), "it has the term x"),
        (sm.Integral(-(F**2), T), "it has the term -F"),
        (TF, "`objective` has no squares"),
    ]:
        with pytest.raises(ValueError, match=message):
            OptimalControl(system, objective, TF, bounds={TF: (1, 2)}, hessian="gauss-newton")
    with pytest.raises(ValueError, match="`hessian` must be"):
        OptimalControl(system, TF, TF, hessian="newton")


def test_bounds_change_over_the_motion():
    # From rest at full force: the speed is the integral of the bound, ∫ (2 − t) dt = 1.5 in 1 s.
    system, (x, v, F) = optima.double_integrator()
    t = np.linspace(0.0, 1.0, num=11)
    for high in ([2.0, 1.0], SampledInput(t, 2.0 - t)):
        problem = OptimalControl(system, -v.subs(T, 1.0), 1.0, bounds={F: (None, high)}, mesh=4)
        solution = problem.solve({F: 0.5})
        assert solution[v][-1] == pytest.approx(1.5, rel=1e-6)
        np.testing.assert_allclose(solution[F], 2.0 - solution.times, atol=1e-5)
    # A state that has to rise: v <= 1 − t allows x = 1/2 in the end.
    problem = OptimalControl(
        system, -x.subs(T, 1.0), 1.0, start={v: 1.0}, bounds={"v": (None, [1.0, 0.0])}, mesh=4
    )
    solution = problem.solve()
    assert solution[x][-1] == pytest.approx(0.5, rel=1e-6)
    assert np.abs(solution.objective_error).sum() < 1e-6  # the last bound is that of the end


@pytest.mark.parametrize(
    ("bounds", "duration", "message"),
    [
        ({"F": ([1.0, 0.0], 0.5)}, 1.0, r"`bounds\[F\(t\)\]` must have low <= high everywhere"),
        ({"F": (np.array([np.nan, 0.0]), 0.5)}, 1.0, "rows of finite numbers"),
        ({"F": (SampledInput([0, 1], [1, 2]), 5)}, TF, "and the duration is free"),
        ({"F": (SampledInput([0, 1], [1, 2]), 5)}, 1.5, "whole motion, from 0 to 1.5, got .* to 1"),
        ({TF: ([0.0, 1.0], 5)}, TF, r"`bounds\[tf\]` must be a pair of numbers"),
        ({"v": ([-1.0, -2.0], [1.0, -1.0])}, 1.0, r"is 0.0.*\(-2.0, -1.0\) exclude"),
    ],
)  # fmt: skip
def test_bad_bounds_over_the_motion_are_named(bounds, duration, message):
    system, (x, v, F) = optima.double_integrator()
    with pytest.raises(ValueError, match=message):
        OptimalControl(
            system, sm.Integral(F**2, T), duration, end={x: 1.0, v: 0.0}, bounds=bounds
        ).check({TF: 1.0} if duration is TF else None)


def test_controls_errors_and_sparsity_are_plotted():
    system, (x, v, F) = optima.double_integrator()
    solution = system.optimize_trajectory(
        TF, TF, end={x: 1.0, v: 0.0}, bounds={F: (-1.0, [1.0, 1.2]), TF: (0.1, 10.0)}, mesh=4
    )
    (ax,) = solution.plot_controls()
    assert (ax.get_ylabel(), len(ax.lines)) == ("$F$", 4)  # itself, its bounds, the nodes
    assert ax.get_xlabel() == solution.plot_error().get_xlabel() == "time"  # in the model's unit
    assert solution.plot_controls(ax) is ax
    with pytest.raises(ValueError, match="`axes` must be 1, one for each of F, got 2"):
        solution.plot_controls([ax, ax])
    ax = solution.plot_error()
    assert ax.patches[0].get_data().values.tolist() == solution.error.tolist()
    ax = solution.plot_sparsity()
    places = set(zip(*ax.lines[0].get_data(), strict=True))
    assert {row for _, row in places} == set(range(2 * 3 * 4))
    plt.close("all")


def test_states_are_plotted_with_their_bounds(mass):
    system, (x, v, F) = mass
    solution = system.optimize_trajectory(
        sm.Integral(F**2, T), 1.0, end={x: 1.0, v: 0.0}, bounds={v: (None, 1.2)}, mesh=4
    )
    first, second = solution.plot_states()
    assert (first.get_ylabel(), len(first.lines)) == ("$x$", 2)  # itself and the nodes
    assert (second.get_ylabel(), len(second.lines)) == ("$v$", 3)
    times, values = second.lines[0].get_data()
    assert np.array_equal(values, solution.at(times)[v])
    assert set(second.lines[1].get_ydata()) == {1.2}
    _, second = solution.plot_states(units={v: ("km/h", 3.6), x: "m"}, time_unit="s")
    assert (second.get_ylabel(), second.get_xlabel()) == ("$v$ (km/h)", "time (s)")
    assert np.array_equal(second.lines[0].get_ydata(), 3.6 * values)
    assert set(second.lines[1].get_ydata()) == {3.6 * 1.2}
    (ax,) = solution.plot_controls(units={"F": "N"})
    assert ax.get_ylabel() == "$F$ (N)"
    plt.close("all")


def test_controls_are_evaluated_at_all_times_at_once(mass, monkeypatch):
    system, (x, v, F) = mass
    calls, original = [], Transcription.controls_at

    def counted(self, z, times):
        calls.append(len(times))
        return original(self, z, times)

    monkeypatch.setattr(Transcription, "controls_at", counted)
    solution = system.optimize_trajectory(energy(F), 1.0, end={x: 1.0, v: 0.0}, mesh=30)
    assert len(calls) < 10
    assert max(calls) == len(solution.times)
    np.testing.assert_allclose(solution[F], 6.0 - 12.0 * solution.times, atol=1e-6)


@pytest.mark.parametrize("method", ["midpoint", "radau"])
def test_a_guess_that_is_level_in_its_middle_gives_no_speed_a_size_of_rounding(method):
    # There the torque of the weight does not change with the angle, but for 1e-16 of itself.
    system, (q1, q2, u1, u2, F) = optima.cart_pole()
    problem = OptimalControl(
        system,
        energy(F),
        2.0,
        end={q1: 1.0, q2: np.pi, u1: 0.0, u2: 0.0},
        bounds={F: (-20.0, 20.0)},
        mesh=20,
        method=method,
    )
    solution = problem.solve()
    sizes = solution._transcription.split(solution._nlp.sizes)[0][:, 0]
    assert sizes.min() > 0.1
    assert len(solution.history) < 20


def test_a_direction_whose_rate_cancels_asks_for_no_control():
    """Opty's users push a mass along a direction that turns; neither it nor its rate acts."""
    x, v, angle, F = me.dynamicsymbols("x v angle F")
    ground, rest = inertial_frame()
    direction = sm.cos(angle) * ground.x + sm.sin(angle) * ground.y
    point = rest.locatenew("P", x * direction)
    point.set_vel(ground, v * direction)
    bodies, loads = [me.Particle("mass", point, 1)], [(point, F * direction)]
    system = System(Definition(ground, [x], [v], bodies=bodies, loads=loads))
    solution = system.optimize_trajectory(sm.Integral(F**2, T), 1.0, end={x: 1.0, v: 0.0}, mesh=2)
    assert solution.controls == (F,)
    assert solution.objective == pytest.approx(12.0, rel=1e-6)


def test_more_intervals_than_rounding_allows_are_refused(mass):
    system, (_x, _v, F) = mass
    with pytest.raises(ValueError, match=r"`mesh` must be at most 4,503,599 intervals, got 1,000"):
        OptimalControl(system, duration=1.0, objective=energy(F), mesh=10**9)


def test_what_bends_in_the_objective_is_named_where_a_search_fails(mass):
    system, (x, v, F) = mass
    problem = OptimalControl(
        system, duration=4.0, objective=sm.Integral(sm.sqrt(sm.Abs(F)), T), end={x: 1.0, v: 0.0},
        bounds={F: (-1.0, 1.0)},
    )  # fmt: skip
    with pytest.raises(OptimizationError, match=r"`objective` has `Abs\(F\(t\)\)`, which bends"):
        problem.solve(options={"max_iter": 100})


@pytest.mark.parametrize("unit", [1.0, 1e-9, 1e9])
def test_a_mass_that_the_objective_drives_to_nothing_is_named(unit):
    x, v, F = me.dynamicsymbols("x v F")
    m = sm.Symbol("m")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x)
    body = me.Particle("P", point, m)
    definition = Definition(frame, [x], [v], bodies=[body], loads=[(point, F * frame.x)])
    system = System(definition, {m: unit})
    problem = {"duration": 4.0, "objective": energy(F / unit), "end": {x: 1.0, v: 0.0}, "free": [m]}
    with pytest.raises(OptimizationError, match="brought `m` to its bound of 0, at which"):
        OptimalControl(system, bounds={m: (0.0, 10.0 * unit)}, **problem).solve()
    solution = OptimalControl(system, bounds={m: (0.5 * unit, 10.0 * unit)}, **problem).solve()
    assert solution.constants[m] == pytest.approx(0.5 * unit, rel=1e-5)
    assert solution.objective == pytest.approx(0.1875 / 4, rel=1e-5)


def test_an_end_that_exceeds_its_own_float_is_the_end():
    system, (_x, v, F) = optima.double_integrator()
    for end in (2 * sm.pi, 2 * np.pi):
        at_end = [sm.Eq(v.subs(T, end), 1)]
        solution = OptimalControl(system, energy(F), 2 * np.pi, boundary=at_end, mesh=3).solve()
        assert solution[v][-1] == pytest.approx(1.0)


def test_a_motion_that_begins_later_is_a_guess_over_all_of_its_time():
    """A mass on a spring, let go at t = 5: x = cos(t − 5)."""
    system = multi_mass_spring_damper()
    system.constants = {"m0": 1.0, "k0": 1.0, "c0": 0.0}
    system.initial_conditions, system.times = {"x0": 1.0}, np.linspace(5.0, 7.0, 11)
    system.ode_solver = "dop853"
    guess = Guess(system.simulate(rtol=1e-10, atol=1e-10), None, None, None)
    assert guess.duration((0.0, np.inf)) == 2.0
    fractions = np.array([0.0, 1.0, 0.25, 0.5])
    values = guess.values(system.coordinates[0], fractions, 3.0)
    np.testing.assert_allclose(values, np.cos(2.0 * fractions), atol=1e-8)
