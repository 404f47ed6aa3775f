"""Jumps of objectives and conditions: refused where they are, or told with the place."""

import numpy as np
import pytest
import sympy as sm

from oracles import optima
from oracles.optima import TF, T
from pydy.control import OptimalControl
from pydy.errors import OptimizationError, PyDyUserWarning

SYSTEM, (X, V, F) = optima.double_integrator()
HALF = sm.Rational(1, 2)
STEP, SIGN, MOD = sm.Heaviside, sm.sign, sm.Mod


def over(expression):
    return sm.Integral(expression, T)


def problem(objective, duration=2.0, **given):
    return OptimalControl(SYSTEM, objective, duration, end={X: 1.0}, **given)


REFUSED = {
    "control": (over(STEP(F) + F**2 / 1000), r"`Heaviside\(F\(t\)\)`.* at F\(t\) = 0"),
    "piecewise": (over(sm.Piecewise((1, F > 0), (0, True))), r"jumps by 1 at F\(t\) = 0"),
    "sign": (over(SIGN(V - HALF)), r"`sign\(v\(t\) - 1/2\)`, which jumps by 2 at v\(t\) = 0.5"),
    "floor": (over(-sm.floor(X)), r"`floor\(x\(t\)\)`, which jumps by 1 at x\(t\) = -?\d"),
    "remainder": (over(MOD(X, 2)), r"`Mod\(x\(t\), 2\)`, which jumps by 2 at x\(t\) = -?\d"),
    "nanometres": (over(STEP(X - sm.Float("5e-10"))), r"at x\(t\) = 5e-10"),
    "gigametres": (over(STEP(X - sm.Float("5e8"))), r"at x\(t\) = 5e\+08"),
    "rate": (over(STEP(V.diff() - 1)), r"at Derivative\(v\(t\), t\) = 1"),
    "two unknowns": (over(SIGN(X * V)), r"`sign\(v\(t\)\*x\(t\)\)`, which jumps by 2 at x\(t\) = "),
    "end": (-sm.floor(V.subs(T, 2.0)), r"`floor\(v\(2.*\)\)`, which jumps by 1 at v\(2\) = "),
    "nested": (
        over(sm.Piecewise((sm.Piecewise((1, X > 0), (0, True)), V > 5), (0, True))),
        r"jumps by 1 at (x\(t\) = 0|v\(t\) = 5)",
    ),
    "narrow": (
        over(sm.Piecewise((STEP(X), (V > 0.9) & (V < 0.901)), (X / 2 + HALF, True))), "jumps",
    ),
    "meets at no point": (over(sm.Piecewise((X**2, X < 1), (2 * X, True))), "by 1 at x.* = 1"),
}  # fmt: skip


@pytest.mark.parametrize("kind", REFUSED)
def test_a_jump_of_the_objective_is_refused_with_its_place(kind):
    objective, message = REFUSED[kind]
    with pytest.raises(ValueError, match=message):
        problem(objective)


def test_a_jump_at_the_bound_of_a_control_is_refused():
    with pytest.raises(ValueError, match=r"jumps by 1 at F\(t\) = 0"):
        problem(over(sm.Piecewise((1, F > 0), (0, True))), bounds={F: (0.0, 10.0)})
    problem(over(sm.Piecewise((1, F >= 0), (0, True))), bounds={F: (0.0, 10.0)})


@pytest.mark.parametrize("switch", [F > 0, F >= 0, F < 0, F <= 0])
def test_a_jump_between_two_bounds_is_refused_whichever_side_it_belongs_to(switch):
    """At F = 0 the integrand has the value of one side; the other one is a jump away."""
    with pytest.raises(ValueError, match=r"jumps by 1 at F\(t\) = 0"):
        problem(over(sm.Piecewise((1, switch), (0, True))), bounds={F: (-2.0, 10.0)})


def test_a_jump_in_time_is_refused_where_the_duration_is_found():
    problem(over(STEP(T - 1) * F**2))
    with pytest.raises(ValueError, match=r"`Heaviside\(t - 1\)`, which jumps by .* at tf = "):
        problem(over(STEP(T - 1) * F**2), TF, bounds={TF: (0.5, 3.0)})
    problem(over(STEP(T - TF / 2) * F**2), TF, bounds={TF: (0.5, 3.0)})
    with pytest.raises(ValueError, match=r"`Heaviside\(tf - 1\)`, which jumps by 1 at tf = 1"):
        problem(STEP(TF - 1), TF, bounds={TF: (0.5, 3.0)})


def test_a_jump_within_an_output_is_refused():
    system, (x, _v, force) = optima.double_integrator()
    on = sm.Symbol("on")
    system.outputs = {on: STEP(force)}
    with pytest.raises(ValueError, match=r"`Heaviside\(F\(t\)\)`, which jumps by .* at F\(t\) = 0"):
        OptimalControl(system, over(on), 2.0, end={x: 1.0})


def test_a_jump_that_appears_in_a_sweep_is_refused():
    x, v, force, c = X, V, F, sm.Symbol("c")
    system = optima.first_order([x], v, force - c * v, 1, None, {c: 0.0})
    problem = OptimalControl(system, over(force**2 + c * STEP(force)), 1.0, end={x: 1.0}, mesh=4)
    with pytest.raises(ValueError, match=r"`Heaviside\(F\(t\)\)`, which jumps"):
        problem.sweep({c: [0.0, 1.0]})


CONTINUOUS = {
    "branches that meet": sm.Piecewise((X**2, X < 1), (2 * X - 1, True)),
    "decimals": sm.Piecewise((X**2, sm.Float("0.3") > X), (0.6 * X - sm.Float("0.09"), True)),
    "three branches": sm.Piecewise((-F - 1, F < -1), (0, F < 1), (F - 1, True)),
    "a switch times zero": SIGN(F) * F + STEP(X - 1) * (X - 1) ** 2,
    "whole numbers": sm.floor(X) * sm.sin(sm.pi * X),
    "Huber's loss": sm.Piecewise((F**2 / 2, abs(F) < 1), (abs(F) - HALF, True)),
    "kinks": abs(F) + sm.Max(F, X, V) + sm.Min(X, 2),
    "nowhere": STEP(sm.exp(X)) + STEP(X**2 + 1),
    "an angle": sm.atan2(X, V),
}


@pytest.mark.parametrize("kind", CONTINUOUS)
def test_what_is_continuous_is_no_jump(kind):
    problem(over(CONTINUOUS[kind] + F**2))


def test_bounds_may_exclude_a_jump():
    problem(over(STEP(F)), bounds={F: (1.0, 10.0)})
    problem(STEP(X.subs(T, 2.0) - 2) + over(F**2))  # it ends at 1


def test_a_jump_of_a_condition_that_does_not_bind_stops_no_search():
    solution = SYSTEM.optimize_trajectory(
        over(F**2), 1.0, end={X: 1.0, V: 0.0}, mesh=8,
        path=[SIGN(V - 2) <= HALF, STEP(X - HALF) <= 6],
        boundary=[STEP(V.subs(T, 1.0) - 1) <= HALF],
    )  # fmt: skip
    assert solution.objective == pytest.approx(12.0, rel=1e-7)


@pytest.mark.parametrize(
    ("given", "place"),
    [
        ({"path": [SIGN(V - sm.Float("1.2")) <= HALF]}, r"jumps by 2 at v\(t\) = 1.2"),
        (
            {"boundary": [STEP(V.subs(T, 1.0) - 1) <= HALF], "end": {X: 1.0}},
            r"jumps by 1 at v\(1\) = 1",
        ),
    ],
)
def test_a_jump_of_a_condition_that_stops_the_search_is_named(given, place):
    given = {"end": {X: 1.0, V: 0.0}, "mesh": 8, **given}
    with pytest.raises(OptimizationError, match=f"The condition `.*which {place}"):
        SYSTEM.optimize_trajectory(over(F**2), 1.0, **given)


def test_a_solution_that_crosses_the_jump_of_an_active_condition_is_told():
    given = {"end": {X: 1.0, V: 0.0}, "mesh": 20}
    below = 1 + 100 * STEP(sm.Rational(3, 10) - X)
    with pytest.warns(
        PyDyUserWarning, match=r"crosses a jump: a condition of `path`.*jumps by 100"
    ):
        solution = SYSTEM.optimize_trajectory(over(F**2), 1.0, path=[below >= F], **given)
    late = solution["x"] > 0.3
    assert solution["F"][late].max() <= 1.0 + 1e-6
    # Where neither side's condition decides, nothing is said.
    solution = SYSTEM.optimize_trajectory(over(F**2), 1.0, path=[3 + below >= F], **given)
    assert solution.objective == pytest.approx(12.0, rel=1e-7)


@pytest.mark.parametrize("duration", [0.5, 4.0])
def test_a_condition_is_active_at_the_times_at_which_it_decides(duration):
    """Without it F falls on a line from 6/T² at t = 0; the limit of 4/T² decides at first."""
    limit = 4.0 / duration**2
    solution = SYSTEM.optimize_trajectory(
        over(F**2), duration, end={X: 1.0, V: 0.0}, mesh=40, path=[limit >= F]
    )
    (condition,) = solution._transcription.problem.path
    active = solution.active(condition.label)
    deciding = solution["F"] > (1.0 - 1e-6) * limit
    assert 0.1 < deciding.mean() < 0.9
    # Of a step that leaves the limit, points between its nodes decide.
    (last,) = np.flatnonzero(np.diff(deciding.astype(int)))
    assert active[1:last].all()
    assert not active[last + 2 :].any()


def test_a_solution_that_crosses_the_cut_of_an_angle_is_told():
    # atan2 jumps by 2π where x passes 1/2 while its second argument is negative.
    angle = sm.atan2(X - HALF, -V - 1) - 1
    given = {"end": {X: 1.0, V: 0.0}, "mesh": 8}
    with pytest.warns(PyDyUserWarning, match=r"crosses a jump: `objective`.* t = 0\.\d+ and 0\.5"):
        SYSTEM.optimize_trajectory(over(F**2 + angle**2 / 100), 1.0, **given)
    ahead = sm.atan2(X - HALF, V + 1) - 1
    solution = SYSTEM.optimize_trajectory(over(F**2 + ahead**2 / 100), 1.0, **given)
    assert np.isfinite(solution.objective)
