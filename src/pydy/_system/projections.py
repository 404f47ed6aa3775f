"""Back through projections onto the constraints: what they do to the adjoint of a state."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pydy._assembly.model import CompiledModel
from pydy._graph.products import derivative_program
from pydy._graph.program import Program
from pydy._graph.simplify import simplify
from pydy._kernel import Inputs, Kernel, KernelCall
from pydy.analysis.tuning import FREE
from pydy.solvers.run.constraints import CompiledConstraints

__all__ = ["Projections"]


class Projections:
    """The projections at the ends of some steps.

    A projection moves sensitivities S by −K (c_x S + c_θ), with the residuals c and the least
    correction K in the norm of the projection, of positions and then of velocities. So an adjoint λ
    becomes λ − c_xᵀ Kᵀ λ before it, and the derivatives by θ gain −(Kᵀ λ) · c_θ.

    Parameters
    ----------
    model : CompiledModel
    constraints : CompiledConstraints
    wanted : tuple of (group, index)
        Inputs that are differentiated by.
    call : callable
        Returns the call of a Kernel with so many inputs after r.
    times : ndarray, shape (m,)
    states : ndarray, shape (m, n)
        As they were projected.

    Attributes
    ----------
    times : ndarray, shape (m,)
    """

    def __init__(
        self,
        model: CompiledModel,
        constraints: CompiledConstraints,
        wanted: tuple[tuple[str, int], ...],
        call: Callable[[Kernel, int], KernelCall],
        times: np.ndarray,
        states: np.ndarray,
    ) -> None:
        self.times, self._x, self._wanted, self._model = times, states, wanted, model
        self._constraints = constraints
        plain = call(constraints.kernel, 0)
        self._r = Inputs(plain.r, plain.sampled).rows(states, times)
        self._p = plain.p
        out = model.evaluate(constraints.kernel, times, states, self._r, self._p)
        self._parts = constraints.kernel.program.by_block(out)
        h, v, n = constraints.holonomic, constraints.velocity, states.shape[1]
        self._slopes = np.zeros((len(times), v, n))
        if v:
            by_state = model.compiled_jacobian("velocity", "x")
            found = model.evaluate(by_state, times, states, self._r, self._p)
            self._slopes = found.reshape(len(times), v, n)
        self._multipliers = np.zeros((len(times), h + v))

    def back(self, k: int, adjoint: np.ndarray) -> np.ndarray:
        """Return the adjoint of the state before projection k, from that after it."""
        wanted = self._constraints
        h, v, q, u = wanted.holonomic, wanted.velocity, wanted.coordinates, wanted.speeds
        part = {name: values[k] for name, values in self._parts.items()}
        inverse = np.eye(u)
        if wanted.weighted:
            inverse = _inverse_factor(part["kinetic_hessian"].reshape(u, u))
        adjoint = adjoint.copy()
        multipliers = self._multipliers[k]
        if v:
            rows = part["velocity_gradient"].reshape(v, u) @ inverse
            multipliers[h:] = (inverse @ _least(rows)).T @ adjoint[q : q + u]
            adjoint -= multipliers[h:] @ self._slopes[k]
        if h:
            gradient = part["gradient"].reshape(h, q)
            reach = part["kinematics"].reshape(q, u) @ inverse
            correction = reach @ _least(gradient @ reach)
            # Rows that no speed reaches.
            correction = correction + _least(gradient) @ (np.eye(h) - gradient @ correction)
            multipliers[:h] = correction.T @ adjoint[:q]
            adjoint[:q] -= multipliers[:h] @ gradient
        return adjoint

    def totals(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the derivatives by what is wanted: their sum (w,), and those of each (m, w)."""
        model, wanted = self._model, self._wanted
        if not wanted:
            return np.zeros(0), np.zeros((len(self.times), 0))
        assembly = model.assembly

        def make() -> Program:
            own = assembly.fork()
            nodes = simplify(own.graph, [*own.holonomic, *own.velocity], own.passes)
            return derivative_program(
                own.graph, nodes, wanted, "vector-jacobian", own.sizes, own.passes
            )

        kernel = model.compiled_by(("adjoint of the constraints", wanted), make)
        rows = np.broadcast_to(self._r, (len(self.times), self._r.shape[1]))
        r = np.concatenate([rows, -self._multipliers], axis=1)
        found = model.evaluate(kernel, self.times, self._x, r, self._p)
        total: Any = found.sum(axis=0)
        return total, found


def _inverse_factor(matrix: np.ndarray) -> np.ndarray:
    """Return L⁻ᵀ of a Cholesky factor; the identity where there is none, as the projection does."""
    try:
        factor = np.linalg.cholesky(matrix)
    except np.linalg.LinAlgError:
        return np.eye(len(matrix))
    rounding = 4.0 * len(matrix) * np.finfo(float).eps
    if not (np.diag(factor) ** 2 > rounding * np.diag(matrix)).all():
        return np.eye(len(matrix))
    inverse: np.ndarray = np.linalg.inv(factor).T
    return inverse


def _least(rows: np.ndarray) -> np.ndarray:
    """Return what solves equations with the least change; dependent rows do not count."""
    lengths = np.linalg.norm(rows, axis=1)
    lengths = np.where(lengths > 0.0, lengths, 1.0)
    found: np.ndarray = np.linalg.pinv(rows / lengths[:, None], rcond=FREE) / lengths
    return found
