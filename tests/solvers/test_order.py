"""How errors fall with the step size and the tolerance."""

import numpy as np
import pytest

from oracles import solver_problems as problems
from pydy.solvers import dop853, radau, tsit5, vern9
from pydy.solvers.tableaus import tableau_of
from registry import ADAPTIVE, EXPLICIT, SOLVER_FACTS

FACTS = {solver: SOLVER_FACTS[solver.name] for solver in EXPLICIT}
DENSE = [solver for solver, facts in FACTS.items() if facts.interpolant_steps]


def error(solver, problem, h, times, **options):
    """The largest error with steps of constant size: the tolerances never ask for another."""
    if solver.adaptive:
        options = {"rtol": 1e3, "atol": 1e3, "first_step": h, "max_step": h, **options}
    else:
        options = {"step": h}
    x, info = solver(problem.f, problem.x0, times, problem.args, full_output=True, **options)
    assert info["rejected"] == 0
    assert abs(info["steps"] - problem.end / h) <= 1
    return np.abs(x - problem.f.exact(times)).max()


def slope(coarse, fine, h, smaller):
    return np.log(coarse / fine) / np.log(h / smaller)


@pytest.mark.parametrize("solver", EXPLICIT)
def test_the_error_falls_with_the_order_of_the_method(solver):
    problem, (h, smaller) = problems.rigid_body(), FACTS[solver].steps
    order = tableau_of(solver.name).order
    ends = np.array([0.0, problem.end])
    coarse, fine = (error(solver, problem, step, ends) for step in (h, smaller))
    assert order - 0.6 < slope(coarse, fine, h, smaller) < order + 1.5


@pytest.mark.parametrize("solver", DENSE)
def test_the_error_between_steps_falls_with_the_order_of_the_interpolant(solver):
    problem, (h, smaller) = problems.rigid_body(), FACTS[solver].interpolant_steps
    # The error of one step, which the error at its ends hides if that is larger.
    order = min(FACTS[solver].interpolant + 1, tableau_of(solver.name).order)
    times = np.linspace(0.0, problem.end, num=1234)
    coarse, fine = (error(solver, problem, step, times) for step in (h, smaller))
    assert order - 0.6 < slope(coarse, fine, h, smaller) < order + 1.5


# Newton's iteration, whose tolerance follows the other one, is exact for a linear problem.


def test_radau_is_of_order_five():
    problem, ends = problems.oscillator(), np.array([0.0, problems.oscillator().end])
    coarse, fine = (error(radau, problem, step, ends) for step in (0.1, 0.025))
    assert 4.6 < slope(coarse, fine, 0.1, 0.025) < 5.5


def test_radaus_interpolant_is_of_order_three():
    problem = problems.oscillator()
    times = np.linspace(0.0, problem.end, num=1234)
    coarse, fine = (error(radau, problem, step, times) for step in (0.1, 0.025))
    assert 3.6 < slope(coarse, fine, 0.1, 0.025) < 4.6


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_the_error_follows_the_tolerance(solver):
    problem = problems.rigid_body()
    for tolerance in (1e-5, 1e-8, 1e-11):
        x = solver(
            problem.f, problem.x0, [0.0, problem.end], problem.args, rtol=tolerance, atol=tolerance
        )
        found = np.abs(x[-1] - problem.final).max()
        assert 1e-3 * tolerance < found < 100 * tolerance


@pytest.mark.parametrize(("solver", "order"), [(dop853, 8), (tsit5, 5), (vern9, 9)])
def test_the_number_of_steps_rises_as_slowly_as_the_order_lets_it(solver, order):
    problem = problems.rigid_body()

    def steps(tolerance):
        options = {"rtol": tolerance, "atol": tolerance, "full_output": True}
        _, info = solver(problem.f, problem.x0, [0.0, problem.end], problem.args, **options)
        return info["steps"]

    rise = np.log(steps(1e-11) / steps(1e-6)) / np.log(1e5)
    assert rise < 1.25 / order


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_output_between_steps_costs_no_further_steps(solver):
    problem = problems.rigid_body()

    def info(count):
        times = np.linspace(0.0, problem.end, num=count)
        options = {"rtol": 1e-8, "atol": 1e-8, "full_output": True}
        return solver(problem.f, problem.x0, times, problem.args, **options)[1]

    few, many = info(2), info(5001)
    assert many["steps"] == few["steps"]
    assert many["evaluations"] <= 1.5 * few["evaluations"]
