"""diffrax: derivatives of the state at the end by constants, forward, and a gradient in reverse.

One compilation of each serves all tolerances, which are arguments. It is made when it is first
asked for: it can take minutes, and either may be given up.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import diffrax
import jax
import jax.numpy as jnp
import numpy as np
from harness.sensitive import joined, parameters
from harness.solving import SolverPeer, serve_solver
from jax_ import rates_of

METHODS = ("forward", "reverse")


class Diffrax(SolverPeer):
    def build(self) -> None:
        start, horizon = jnp.asarray(self.scenario.start), self.scenario.horizon
        inputs, by = jnp.asarray(self.scenario.inputs), np.array(parameters(self.model))
        values, rates = jnp.asarray(self.values), jax.jit(rates_of(self.model))

        def end(moved: Any, tolerance: Any, adjoint: Any) -> Any:
            solution = diffrax.diffeqsolve(
                diffrax.ODETerm(lambda t, x, p: rates(x, inputs, p)),
                diffrax.Tsit5(),
                0.0,
                horizon,
                None,
                start,
                args=values.at[by].set(moved),
                stepsize_controller=diffrax.PIDController(rtol=tolerance, atol=tolerance),
                adjoint=adjoint,
                saveat=diffrax.SaveAt(t1=True),
                max_steps=4096,
            )
            return solution.ys[0]

        def forward(moved: Any, tolerance: Any) -> Any:
            def both(moved: Any) -> Any:
                state = end(moved, tolerance, diffrax.ForwardMode())
                return state, state

            columns, state = jax.jacfwd(both, has_aux=True)(moved)
            return state, columns

        def reverse(moved: Any, tolerance: Any) -> Any:
            def total(moved: Any) -> Any:
                return jnp.sum(end(moved, tolerance, diffrax.RecursiveCheckpointAdjoint()))

            return jax.value_and_grad(total)(moved)

        self.moved = values[by]
        self.functions = {"forward": forward, "reverse": reverse}
        self.compiled: dict[str, Any] = {}

    def methods(self) -> list[str]:
        return list(METHODS)

    def solver(self, method: str, tolerance: float) -> Callable[[], np.ndarray]:
        allowed = jnp.asarray(tolerance)
        if method not in self.compiled:
            traced = jax.jit(self.functions[method]).lower(self.moved, allowed)
            self.compiled[method] = traced.compile()
        run = self.compiled[method]

        def solve() -> np.ndarray:
            first, second = jax.block_until_ready(run(self.moved, allowed))
            return joined(np.asarray(first), np.asarray(second))

        return solve


if __name__ == "__main__":
    serve_solver(Diffrax())
