"""This project's solvers, called from Python as System calls them; and odeint, its default.

By arguments, some of the methods only.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence

import numpy as np
from harness.odeint import odeint_solver
from harness.program import solver_function
from harness.solving import SolverPeer, serve_solver

from pydy.solvers import dop853, radau, tsit5, vern9

NATIVE = {"dop853": dop853, "tsit5": tsit5, "vern9": vern9, "radau": radau}
DEFAULT = ("dop853", "tsit5", "vern9", "odeint")


class OurSolvers(SolverPeer):
    def __init__(self, methods: Sequence[str]) -> None:
        self._methods = methods

    def warm_up(self) -> None:
        for name in {*self._methods} & {*NATIVE}:
            NATIVE[name](lambda x, t: -x, [1.0], [0.0, 1e-3])

    def build(self) -> None:
        self.function, self.args = solver_function(self.model, self.scenario.inputs)

    def methods(self) -> list[str]:
        return list(self._methods)

    def solver(self, method: str, tolerance: float) -> Callable[[], np.ndarray]:
        f, args = self.function, self.args
        if method == "odeint":
            return odeint_solver(f, self, args, tolerance)
        start, times = self.scenario.start, [0.0, self.scenario.horizon]
        run = NATIVE[method].prepare(f, start, times, args, rtol=tolerance, atol=tolerance)
        return lambda: run(start)[-1]


if __name__ == "__main__":
    serve_solver(OurSolvers(sys.argv[1:] or DEFAULT))
