"""Accelerations from a linear solver of the user's choice instead of the built-in one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import sympy as sm

from pydy._backends.base import strict
from pydy._checks import real_array, shown
from pydy._graph.program import Program
from pydy._kernel import Kernel

__all__ = ["LinearSolver", "resolve_solver", "solve_symbolically", "with_external_solver"]

LinearSolver = Callable[[np.ndarray, np.ndarray], np.ndarray]


def resolve_solver(solver: Any) -> LinearSolver | str | None:
    """Return what `linear_sys_solver` means: None (built in), a function, or 'sympy[:METHOD]'.

    Raises
    ------
    ValueError
        It is not one of them.
    """
    if solver is None or (isinstance(solver, str) and solver == "builtin"):
        return None
    if callable(solver):
        function: LinearSolver = solver
        return function
    if not isinstance(solver, str):
        raise _refused(solver)
    if solver == "numpy":
        return np.linalg.solve
    if solver == "scipy":
        import scipy.linalg

        return scipy.linalg.solve  # type: ignore[no-any-return]
    if solver.partition(":")[0] == "sympy":
        return str(solver)
    raise _refused(solver)


def _refused(solver: Any) -> ValueError:
    return ValueError(
        f"`linear_sys_solver` is {shown(solver)}, but it must be 'builtin', 'numpy', 'scipy', "
        "'sympy', 'sympy:METHOD' or a function solve(A, b)."
    )


def solve_symbolically(matrix: Any, column: Sequence[Any], solver: str) -> list[Any]:
    """Return the symbolic solution for 'sympy' or 'sympy:METHOD'."""
    method = solver.partition(":")[2] or "LU"
    try:
        return list(matrix.solve(sm.Matrix(column), method=method))
    except ValueError as error:
        raise ValueError(
            f"`linear_sys_solver` is {solver!r}, of which SymPy says: {error}"
        ) from error


def with_external_solver(
    program: Program, system: Kernel, solver: LinearSolver, rest: Kernel
) -> Kernel:
    """Chain the matrices, a solver and what follows from its solution into one Kernel.

    Parameters
    ----------
    program : Program
        That of `rest`.
    system : Kernel
        Computes the blocks 'mass_matrix' and 'forcing'.
    solver : callable
        ``solve(A, b) -> x``.
    rest : Kernel
        Takes the solution at the end of r.
    """
    n = system.program.block("forcing").stop - system.program.block("forcing").start

    def call(x: Any, t: Any, r: Any, p: Any, out: np.ndarray) -> int:
        if type(t) is not float or not strict(system.program, x, r, p):
            return -1
        matrices = np.empty(n * n + n)
        if system.at(x, t, r, p, matrices):
            return 1
        try:
            solution = solver(matrices[: n * n].reshape(n, n), matrices[n * n :])
        except np.linalg.LinAlgError:
            return 1
        except Exception as error:
            error.add_note("This came from the `linear_sys_solver`, called as solve(A, b).")
            raise
        solution = real_array(solution, "What `linear_sys_solver` returns")
        if solution.shape not in ((n,), (n, 1)):
            raise ValueError(
                f"`linear_sys_solver` must return the shape ({n},) or ({n}, 1), got "
                f"{solution.shape}."
            )
        return rest.at(x, t, np.concatenate([r, solution.ravel()]), p, out)

    def sweep(
        t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        out = np.full((len(t), len(program.outputs)), np.nan)
        failed = np.zeros(len(t), dtype=bool)
        for k, row in enumerate(np.broadcast_to(r, (len(t), r.shape[1]))):
            state, inputs = np.array(x[k], dtype=float), np.array(row, dtype=float)
            failed[k] = call(state, float(t[k]), inputs, p, out[k])
        return out, failed

    return Kernel(program, sweep, call, with_external_solver, (system, solver, rest))
