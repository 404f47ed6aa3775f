"""The same programs by each solver that is installed, and what is told of those that are not."""

import sys
import types

import numpy as np
import pytest
import sympy as sm

from oracles import optima
from oracles.optima import SOLVERS, TF, T
from pydy.control import OptimalControl
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


def test_packages_get_multipliers_that_satisfy_the_conditions_of_an_optimum(monkeypatch):
    """Where a solution starts a search, ∇f + Jᵀ λ − z_L + z_U = 0 in the units of the solver."""
    missed = []

    class Problem:
        def __init__(self, n, m, problem_obj, lb, ub, cl, cu):
            self.program, self.n, self.m = problem_obj, n, m
            assert lb.shape == ub.shape == (n,)
            assert cl.shape == cu.shape == (m,)

        def add_option(self, name, value):
            pass

        def solve(self, y, lagrange, zl, zu):
            slopes = np.zeros((self.m, self.n))
            np.add.at(slopes, self.program.jacobianstructure(), self.program.jacobian(y))
            gradient = self.program.gradient(y)
            missed.append((gradient + slopes.T @ lagrange - zl + zu, zl, zu))
            info = {"mult_g": lagrange, "mult_x_L": zl, "mult_x_U": zu, "status": 0}
            return y, {**info, "obj_val": self.program.objective(y)}

    package = types.ModuleType("cyipopt")
    package.Problem = Problem
    monkeypatch.setitem(sys.modules, "cyipopt", package)
    system, (x, v, F) = optima.double_integrator()
    problem = OptimalControl(
        system, TF, TF, end={x: 1.0, v: 0.0}, bounds={F: (-1.0, 1.0), TF: (0.1, 10.0)}, mesh=6
    )
    first = problem.solve()
    again = problem.solve(first, solver="cyipopt")
    assert again.objective == pytest.approx(first.objective, rel=1e-12)
    ((residual, below, above),) = missed
    assert min(below.max(), above.max()) > 1e-3  # of the force at both bounds
    assert np.abs(residual).max() < 1e-6 * max(below.max(), above.max())
