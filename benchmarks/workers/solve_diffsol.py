"""diffsol through its Python package, with equations in its own language compiled by LLVM."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pydiffsol as ds
from harness.diffsl import code_of
from harness.solving import SolverPeer, serve_solver

# Its other implicit methods, of orders 2 and 4, are far behind on smooth problems.
METHODS = {"tsit45": ds.tsit45, "bdf": ds.bdf}


class DiffsolSolver(SolverPeer):
    def warm_up(self) -> None:
        ds.Ode("u { x = 1.0 }\nF { -x }", matrix_type=ds.nalgebra_dense)

    def build(self) -> None:
        code = code_of(self.model, self.scenario.start, self.scenario.inputs)
        self.ode = ds.Ode(code, matrix_type=ds.nalgebra_dense)

    def methods(self) -> list[str]:
        return list(METHODS)

    def solver(self, method: str, tolerance: float) -> Callable[[], np.ndarray]:
        ode, end = self.ode, self.scenario.horizon
        parameters = np.concatenate([self.scenario.inputs, self.values])

        def solve() -> np.ndarray:
            ode.ode_solver = METHODS[method]
            ode.rtol = ode.atol = tolerance
            return ode.solve(parameters, end).ys[:, -1]

        return solve


if __name__ == "__main__":
    serve_solver(DiffsolSolver())
