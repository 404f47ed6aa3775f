"""heyoka's `taylor_adaptive`, which is compiled for each tolerance."""

from __future__ import annotations

from collections.abc import Callable

import heyoka as hy
import numpy as np
from harness.solving import SolverPeer, serve_solver
from heyoka_ import equations_of, warm_up

# With more elementary operations than this, unrolled code takes minutes to compile.
COMPACT_FROM = 1500


class HeyokaSolver(SolverPeer):
    costly = True

    def warm_up(self) -> None:
        warm_up()

    def build(self) -> None:
        states, rates = equations_of(self.model)
        self.equations = list(zip(states, rates, strict=True))
        quick = hy.taylor_adaptive(
            self.equations, self.scenario.start, tol=0.1, compact_mode=True, opt_level=0
        )
        self.compact = len(quick.decomposition) > COMPACT_FROM

    def methods(self) -> list[str]:
        return ["taylor, compact" if self.compact else "taylor"]

    def solver(self, method: str, tolerance: float) -> Callable[[], np.ndarray]:
        start, end = self.scenario.start, self.scenario.horizon
        integrator = hy.taylor_adaptive(
            self.equations,
            start,
            pars=np.concatenate([self.scenario.inputs, self.values]),
            tol=tolerance,
            compact_mode=self.compact,
        )
        state = integrator.state

        def solve() -> np.ndarray:
            integrator.time = 0.0
            state[:] = start
            outcome = integrator.propagate_until(end)[0]
            assert outcome == hy.taylor_outcome.time_limit, outcome
            return state

        return solve


if __name__ == "__main__":
    serve_solver(HeyokaSolver())
