"""The same programs by each solver that is installed, and what is told of those that are not."""

import numpy as np
import pytest
import sympy as sm

from oracles import optima
from oracles.optima import SOLVERS, TF, T
from pydy.control.nlp import Native
from pydy.errors import AnalysisInterrupted, MissingDependencyError, OptimizationError


@pytest.fixture(scope="module")
def cart():
    problem, F = optima.kelly(mesh=15)
    return problem, F, problem.solve()


@pytest.mark.parametrize("solver", SOLVERS)
def test_solvers_agree(cart, solver):
    problem, F, expected = cart
    solution = problem.solve(solver=solver)
    assert solution.message == "solved"
    assert solution.objective == pytest.approx(expected.objective, rel=1e-6)
    assert [i.number for i in solution.history] == list(range(len(solution.history)))
    for name, values in expected.multipliers.items():
        scale = np.abs(values).max()
        np.testing.assert_allclose(solution.multipliers[name], values, atol=1e-6 * scale + 1e-12)
    np.testing.assert_allclose(solution[F], expected[F], atol=1e-5 * np.abs(expected[F]).max())


@pytest.mark.parametrize("solver", SOLVERS)
def test_warm_starts_and_estimated_derivatives(cart, solver):
    problem, _, expected = cart
    assert len(problem.solve(expected, solver=solver).history) < len(expected.history) / 2
    system, (x, v, F) = optima.double_integrator()
    solution = system.optimize_trajectory(
        sm.Integral(F**2, T), 1.0, end={x: 1.0, v: 0.0}, hessian="lbfgs", solver=solver
    )
    assert solution.objective == pytest.approx(12.0, rel=1e-6)


@pytest.mark.parametrize("solver", SOLVERS)
def test_a_least_time_with_bounds(solver):
    system, (x, v, F) = optima.double_integrator()
    solution = system.optimize_trajectory(
        TF, TF, end={x: 1.0, v: 0.0}, bounds={F: (-1.0, 1.0), TF: (0.1, 10.0)}, solver=solver
    )
    assert solution.objective == pytest.approx(2.0, rel=1e-6)
    assert np.abs(solution[F]).max() <= 1.0


@pytest.mark.parametrize("solver", SOLVERS)
def test_a_search_that_fails_is_told(cart, solver):
    with pytest.raises(OptimizationError, match="`max_iter` iterations were not enough"):
        cart[0].solve(options={"max_iter": 2}, solver=solver)


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("options", [{"nonsense": 1}, {"tol": "small"}])
def test_options_that_a_solver_does_not_know_are_told(cart, solver, options):
    with pytest.raises(ValueError, match="`options` has"):
        cart[0].solve(options=options, solver=solver)


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("error", [ZeroDivisionError, KeyboardInterrupt])
def test_an_error_on_the_way_ends_the_search(cart, solver, error, monkeypatch):
    calls, original = [], Native.__call__

    def broken(self, name, *given):
        calls.append(name)
        if calls.count("jacobian") == 9:  # the first few are for the units
            raise error
        return original(self, name, *given)

    monkeypatch.setattr(Native, "__call__", broken)
    expected = AnalysisInterrupted if error is KeyboardInterrupt else error
    with pytest.raises(expected):
        cart[0].solve(solver=solver)


def test_a_solver_that_is_not_there_is_named(cart, monkeypatch):
    with pytest.raises(ValueError, match="`solver` must be one of 'ipopt', 'cyipopt', 'pounce'"):
        cart[0].solve(solver="snopt")
    for package, extra in (("cyipopt", "cyipopt"), ("pounce", "pounce")):
        monkeypatch.setitem(__import__("sys").modules, package, None)
        with pytest.raises(MissingDependencyError, match=rf"pip install 'pydy\[{extra}\]'"):
            cart[0].solve(solver=extra)
