"""Linear solvers of the user's, in place of the one that is compiled into Programs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import sympy as sm

from pydy._backends import arguments_fit
from pydy._checks import real_array, shown
from pydy._kernel import Kernel
from pydy._program import Program

LinearSolver = Callable[[np.ndarray, np.ndarray], np.ndarray]


def resolve_solver(solver: Any) -> LinearSolver | str | None:
    """Return `linear_sys_solver` as None (built in), a function, or 'sympy[:METHOD]'."""
    if solver is None or callable(solver):
        found: LinearSolver | None = solver
        return found
    name = solver if isinstance(solver, str) else ""
    if name == "scipy":
        import scipy.linalg

        return scipy.linalg.solve  # type: ignore[no-any-return]
    if name.partition(":")[0] == "sympy":
        return name
    if name not in ("builtin", "numpy"):
        raise ValueError(
            f"`linear_sys_solver` is {shown(solver)}, but it must be 'builtin', 'numpy', 'scipy', "
            "'sympy', 'sympy:METHOD' or a function solve(A, b)."
        )
    return None if name == "builtin" else np.linalg.solve


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
    """Chain the matrices, a solver and the values that depend on its solution into one Kernel."""
    (n,) = system.program.signature.block("forcing").shape

    def gate(x: Any, t: Any, r: Any, p: Any, out: np.ndarray) -> int:
        """Evaluate one state, as `Kernel.gate`: −1 asks for arguments that are converted."""
        if type(t) is not float or not arguments_fit(system.program, x, r, p):
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
    ) -> tuple[np.ndarray, np.ndarray, bool]:
        out = np.full((len(t), program.signature.num_outputs), np.nan)
        failed = np.zeros(len(t), dtype=bool)
        for k, row in enumerate(np.broadcast_to(r, (len(t), r.shape[1]))):
            state, inputs = np.array(x[k], dtype=float), np.array(row, dtype=float)
            failed[k] = gate(state, float(t[k]), inputs, p, out[k])
        return out, failed, bool(np.isfinite(out).all())

    return Kernel(program, sweep, gate, with_external_solver, (system, solver, rest))
