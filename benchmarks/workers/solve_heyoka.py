"""heyoka's `taylor_adaptive`, which is compiled for each tolerance."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import heyoka as hy
import numpy as np
from harness.solving import SolverPeer, serve_solver
from heyoka_ import equations_of, warm_up

# With more elementary operations than this, unrolled code takes minutes to compile.
COMPACT_FROM = 1500


def integrator_of(peer: SolverPeer, equations: Any, tolerance: float, *, compact: bool) -> Any:
    """Return the integrator of equations from the start of a peer's scenario on."""
    return hy.taylor_adaptive(
        equations,
        peer.scenario.start,
        pars=np.concatenate([peer.scenario.inputs, peer.values]),
        tol=tolerance,
        compact_mode=compact,
    )


def run_of(integrator: Any, end: float) -> Callable[[], np.ndarray]:
    """Return a function that integrates from the start to a time; it returns heyoka's own array."""
    state = integrator.state
    first = np.array(state)

    def solve() -> np.ndarray:
        integrator.time = 0.0
        state[:] = first
        outcome = integrator.propagate_until(end)[0]
        assert outcome == hy.taylor_outcome.time_limit, outcome
        return state

    return solve


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
        integrator = integrator_of(self, self.equations, tolerance, compact=self.compact)
        return run_of(integrator, self.scenario.horizon)


if __name__ == "__main__":
    serve_solver(HeyokaSolver())
