"""Kinks of objectives and conditions: solved with the right values where an optimum lies on one."""

import numpy as np
import pytest
import sympy as sm

from oracles import optima
from oracles.optima import T
from pydy.control import OptimalControl
from pydy.control.kinks import epigraph

SYSTEM, (X, V, F) = optima.double_integrator()


def over(expression):
    return sm.Integral(expression, T)


def least_effort(unit=1.0, **given):
    """Solve min ∫ |F| dt of x'' = F, |F| ≤ 1, from rest to rest over 1 in 4 s.

    The force is 1 for a = 2 − √3, then 0, then −1 for a: a (4 − a) = 1; the least is 2 a.
    """
    return SYSTEM.optimize_trajectory(
        over(abs(F)), 4.0, end={X: unit, V: 0.0}, bounds={F: (-unit, unit)}, **given
    )


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
def test_an_optimum_on_a_kink_is_found_in_any_unit(unit):
    # Nodes where the force jumps.
    a = (2 - np.sqrt(3)) / 4
    found = least_effort(unit, mesh=[0.0, a, 0.5, 1.0 - a, 1.0])
    assert found.objective == pytest.approx(2 * (2 - np.sqrt(3)) * unit, rel=1e-6)


@pytest.mark.parametrize("method", ["radau", "hermite-simpson", "midpoint"])
def test_every_method_stays_on_a_kink(method):
    found = least_effort(mesh=40, method=method)
    off = abs(found.objective - 2 * (2 - np.sqrt(3)))
    assert off < 2e-3
    assert off < np.abs(found.objective_error).sum()
    assert found.at(2.0)["F"][0] == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize(
    "kink",
    [
        sm.Max(F - 1, 0),
        -sm.Min(1 - F, 0),
        sm.Piecewise((F - 1, F > 1), (0, True)),
        sm.Max(sm.Max(F - 1, 0), -1),
    ],
)
def test_a_force_that_costs_above_a_limit_alone_stays_below(kink):
    # F = 1 on [0, 2] leads from rest to x = 2; with less somewhere it takes more elsewhere.
    solution = SYSTEM.optimize_trajectory(over(kink), 2.0, end={X: 2.0}, mesh=8)
    assert solution.objective == pytest.approx(0.0, abs=1e-8)
    assert solution["F"].max() <= 1.0 + 1e-6


def test_the_distance_from_a_force_is_least_where_the_kink_is():
    # With x(2) = 1 from rest, ∫ |F − 1| dt is least with all of the change at the start, where it
    # counts most: F = 1 − M there; in the limit of a pulse, its area is 1/2.
    solution = SYSTEM.optimize_trajectory(over(abs(F - 1)), 2.0, end={X: 1.0}, mesh=20)
    assert solution.objective == pytest.approx(0.5, rel=0.02)
    assert solution["F"][10:] == pytest.approx(1.0, abs=1e-6)


def test_a_kink_of_a_value_at_an_instant():
    # ∫ F² of x(1) = a from rest is 3 a²: with k |x(1) − 1| it is least at a = min(1, k/6).
    for k, a in ((10.0, 1.0), (3.0, 0.5)):
        miss = k * abs(X.subs(T, 1.0) - 1)
        solution = SYSTEM.optimize_trajectory(over(F**2) + miss, 1.0, mesh=4)
        assert solution["x"][-1] == pytest.approx(a, abs=1e-6)
        assert solution.objective == pytest.approx(3 * a**2 + k * (1 - a), rel=1e-6)


def test_a_kink_within_an_output():
    system, (x, v, force) = optima.double_integrator()
    effort = sm.Symbol("effort")
    system.outputs = {effort: abs(force)}
    solution = system.optimize_trajectory(
        over(effort), 4.0, end={x: 1.0, v: 0.0}, bounds={force: (-1, 1)}, mesh=40
    )
    assert solution.objective == pytest.approx(2 * (2 - np.sqrt(3)), rel=1e-3)
    assert solution["effort"] == pytest.approx(np.abs(solution["F"]))


def test_phases_and_sweeps_keep_kinks():
    there = OptimalControl(
        SYSTEM, abs(X.subs(T, 1.0) - 1) * 10 + over(F**2), 1.0, mesh=4, start={X: 0.0, V: 0.0}
    )
    both = OptimalControl.phases([there, there], [{X: 0, V: 0}]).solve()
    assert [phase.objective for phase in both] == pytest.approx([3.0, 3.0], rel=1e-6)
    c = sm.Symbol("c")
    system = optima.first_order([X], V, F - 0 * c, 1, None)
    system.outputs = {sm.Symbol("o"): c * X}
    system.constants = {c: 10.0}
    problem = OptimalControl(system, c * abs(X.subs(T, 1.0) - 1) + over(F**2), 1.0, mesh=4)
    found = problem.sweep({c: [10.0, 3.0]})
    assert [one.objective for one in found] == pytest.approx([3.0, 2.25], rel=1e-6)


def test_conditions_with_kinks_hold():
    # min ∫ F² with |F| ≤ 5: F = a (1 − 2 t), cut off at ±5; see the moments below.
    solution = SYSTEM.optimize_trajectory(
        over(F**2), 1.0, end={X: 1.0, V: 0.0}, mesh_tol=1e-7, path=[abs(F) <= 5]
    )
    # With ±5 for s at the ends, x(1) = ∫ (1 − t) F dt = 5/4 − 5 (1 − 2 s)²/12 = 1.
    s = (1 - np.sqrt(0.6)) / 2
    assert solution.objective == pytest.approx(50 * s + 25 * (1 - 2 * s) / 3, rel=1e-6)
    assert solution.multipliers["Abs(F(t)) <= 5"].min() < 0.0 < 1e-6 + solution["F"].max()


def test_what_a_kink_may_not_be_replaced_in_stays():
    moves, c = (lambda e: True), sm.Symbol("c")
    for expression in (-abs(F), abs(F) ** 2, abs(F) * abs(V), c * abs(F), sm.exp(abs(F))):
        assert epigraph(expression, moves, {}).expression == expression
    assert epigraph(c * abs(F), moves, {c: 2.0}).unknown
    assert epigraph(X**2 * abs(F), moves, {}).unknown
    assert not epigraph(c * abs(F), moves, {c: -2.0}).unknown
    assert not epigraph(sm.Piecewise((F**2, F > 0), (F, True)), moves, {}).unknown
    assert not epigraph(abs(T - 1), lambda e: e.has(F), {}).unknown
