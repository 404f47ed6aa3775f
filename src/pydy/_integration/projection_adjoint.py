"""The adjoint of the constraint projections at the ends of steps."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from pydy._assembly import CompiledModel
from pydy._graph import derivative_program, simplify
from pydy._kernel import Kernel, KernelCall
from pydy._program import Program
from pydy._rank import DEPENDENT, is_zero, or_one
from pydy.solvers import CompiledConstraints


class ProjectionAdjoint:
    """The constraint projections at the ends of some steps, and their adjoints.

    A projection changes sensitivities S by −K (c_x S + c_θ), where c are the residuals and K is the
    minimum-norm correction, first for positions and then for velocities. Before the projection, an
    adjoint λ is therefore λ − c_xᵀ Kᵀ λ, and the derivatives with respect to θ gain −(Kᵀ λ) · c_θ.

    `wrt` lists the inputs to differentiate with respect to. `call` takes a Kernel and the number of
    inputs that follow r, and returns the Kernel's call. The m `states` are those after projection.
    """

    def __init__(
        self,
        model: CompiledModel,
        constraints: CompiledConstraints,
        wrt: tuple[tuple[str, int], ...],
        call: Callable[[Kernel, int], KernelCall],
        times: np.ndarray,
        states: np.ndarray,
    ) -> None:
        self.times, self._x, self._wrt, self._model = times, states, wrt, model
        self._constraints = constraints
        constraint_call = call(constraints.kernel, 0)
        self._r = constraint_call.inputs.rows(states, times)
        self._p = constraint_call.p
        out = model.evaluate(constraints.kernel, times, states, self._r, self._p)
        self._parts = constraints.kernel.program.signature.by_block(out)
        (h, v, q, _), n = constraints.sizes, states.shape[1]
        self._gradient = self._parts["gradient"].reshape(len(times), h, q)
        if constraints.following:  # their corrections are not along the gradient
            by_state = model.compiled_jacobian("holonomic", "x")
            jacobian = model.evaluate(by_state, times, states, self._r, self._p)
            self._gradient = jacobian.reshape(len(times), h, n)
        self._slopes = np.zeros((len(times), v, n))
        if v:
            by_state = model.compiled_jacobian("velocity", "x")
            jacobian = model.evaluate(by_state, times, states, self._r, self._p)
            self._slopes = jacobian.reshape(len(times), v, n)
        self._multipliers = np.zeros((len(times), h + v))

    def back(self, k: int, adjoint: np.ndarray) -> np.ndarray:
        """Return the adjoint of the state before projection k, from that after it."""
        constraints = self._constraints
        h, v, q, u = constraints.sizes
        part = {name: values[k] for name, values in self._parts.items()}
        inverse = np.eye(u)
        if constraints.weighted:
            inverse = _inverse_factor(part["kinetic_hessian"].reshape(u, u))
        adjoint = adjoint.copy()
        multipliers = self._multipliers[k]
        if v:
            rows = part["velocity_gradient"].reshape(v, u) @ inverse
            multipliers[h:] = (inverse @ _pseudoinverse(rows)).T @ adjoint[q : q + u]
            adjoint -= multipliers[h:] @ self._slopes[k]
        if h:
            gradient = part["gradient"].reshape(h, q)
            reach = part["kinematics"].reshape(q, u) @ inverse
            terms = np.linalg.norm(np.abs(gradient) @ np.abs(reach), axis=1)
            moving = gradient @ reach
            moving[is_zero(np.linalg.norm(moving, axis=1), terms)] = 0.0
            correction = reach @ _pseudoinverse(moving)
            # Constraints that no speed can correct.
            correction = correction + _pseudoinverse(gradient) @ (np.eye(h) - gradient @ correction)
            multipliers[:h] = correction.T @ adjoint[:q]
            slopes = self._gradient[k]
            adjoint[: slopes.shape[1]] -= multipliers[:h] @ slopes
        return adjoint

    def totals(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the sum (w,) of the derivatives by the inputs, the times, and those per time."""
        model, wrt = self._model, self._wrt
        if not wrt:
            return np.zeros(0), self.times, np.zeros((len(self.times), 0))
        assembly = model.assembly

        def make() -> Program:
            fork = assembly.fork()
            nodes = simplify(fork.graph, [*fork.blocks.holonomic, *fork.blocks.velocity])
            return derivative_program(fork.graph, nodes, wrt, "vector-jacobian", fork.sizes)

        kernel = model.compiled_by(("adjoint of the constraints", wrt), make)
        rows = np.broadcast_to(self._r, (len(self.times), self._r.shape[1]))
        r = np.concatenate([rows, -self._multipliers], axis=1)
        per_time = model.evaluate(kernel, self.times, self._x, r, self._p)
        total: np.ndarray = per_time.sum(axis=0)
        return total, self.times, per_time


def _inverse_factor(matrix: np.ndarray) -> np.ndarray:
    """Return L⁻ᵀ of the Cholesky factor L, or the identity if there is none, as projections do."""
    try:
        factor = np.linalg.cholesky(matrix)
    except np.linalg.LinAlgError:
        return np.eye(len(matrix))
    rounding = 4.0 * len(matrix) * np.finfo(float).eps
    if not (np.diag(factor) ** 2 > rounding * np.diag(matrix)).all():
        return np.eye(len(matrix))
    return np.linalg.inv(factor).T


def _pseudoinverse(rows: np.ndarray) -> np.ndarray:
    """Return the pseudoinverse of some rows, which ignores their linearly dependent directions."""
    lengths = or_one(np.linalg.norm(rows, axis=1))
    solution: np.ndarray = np.linalg.pinv(rows / lengths[:, None], rcond=DEPENDENT) / lengths
    return solution
