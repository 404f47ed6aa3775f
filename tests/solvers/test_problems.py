"""Published problems with exact answers, over every solver."""

import numpy as np
import pytest

from oracles import solver_problems as problems
from pydy.solvers import radau, rk4, tsit5
from pydy.solvers.tableaus import tableau_of
from registry import ADAPTIVE, EXPLICIT, step_options

NAMES = ["rigid_body", "pleiades", "arenstorf"]
# How much larger than the tolerance the error is at the end: the orbits have close encounters, and
# methods of low order take many steps.
CONDITION = {"rigid_body": 50.0, "pleiades": 2e3, "arenstorf": 2e4}
LOW_ORDER = 5.0  # times as much below order 5


@pytest.mark.parametrize("tolerance", [1e-8, 1e-11])
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("solver", ADAPTIVE)
def test_published_solutions_are_met(solver, name, tolerance):
    problem = getattr(problems, name)()
    x = solver(
        problem.f, problem.x0, [0.0, problem.end], problem.args, rtol=tolerance, atol=tolerance
    )
    low = solver in EXPLICIT and tableau_of(solver.name).order < 5
    allowed = CONDITION[name] * (LOW_ORDER if low else 1.0)
    assert np.abs(x[-1] - problem.final).max() < allowed * tolerance


@pytest.mark.parametrize(
    ("name", "steps", "expected"),
    [("rigid_body", 1000, 1e-7), ("pleiades", 100_000, 1e-6), ("arenstorf", 200_000, 1e-4)],
)
def test_published_solutions_are_met_in_fixed_steps(name, steps, expected):
    problem = getattr(problems, name)()
    x = rk4(problem.f, problem.x0, [0.0, problem.end], problem.args, step=problem.end / steps)
    assert np.abs(x[-1] - problem.final).max() < expected


@pytest.mark.parametrize(("tolerance", "expected"), [(1e-5, 1e-6), (1e-8, 1e-9), (1e-11, 1e-12)])
@pytest.mark.parametrize("name", ["van_der_pol", "hires"])
def test_stiff_published_solutions_are_met(name, tolerance, expected):
    problem = getattr(problems, name)()
    x = radau(
        problem.f,
        problem.x0,
        [0.0, problem.end],
        problem.args,
        rtol=tolerance,
        atol=1e-3 * tolerance,
    )
    np.testing.assert_allclose(x[-1], problem.final, rtol=expected)


@pytest.mark.parametrize("solver", [*ADAPTIVE, rk4])
def test_a_clock_far_from_zero_does_not_drift(solver):
    """In seconds since 1970 times are 2.4e-7 s apart: a step lasts from one of them to another."""

    def oscillator(x, t, *_):
        return np.array([x[1], -4.0 * x[0]])

    options = step_options(solver, 1e-11, 1e-3)
    x = solver(oscillator, np.array([1.0, 0.0]), 1.7e9 + np.array([0.0, 10.0]), **options)
    assert x[-1] == pytest.approx([np.cos(20.0), -2.0 * np.sin(20.0)], abs=1e-9)


def test_the_implicit_method_does_not_mind_how_stiff_a_problem_is():
    def evaluations(solver):
        problem = problems.van_der_pol()
        # Up to t = 0.5 the solution is smooth; only stability limits the steps.
        options = {"rtol": 1e-5, "atol": 1e-8, "full_output": True}
        return solver(problem.f, problem.x0, [0.0, 0.5], problem.args, **options)[1]["evaluations"]

    assert evaluations(radau) < 1000
    assert evaluations(tsit5) > 1_000_000
