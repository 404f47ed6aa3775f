"""SUNDIALS' IDA through scikit-sundae: residuals q' − G and M u' − F by SymPy's `lambdify`."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import sympy as sm
from harness.solving import SolverPeer, serve_solver
from sksundae.ida import IDA


class SundaeSolver(SolverPeer):
    def build(self) -> None:
        m = self.model
        rates = [sm.Dummy() for _ in (*m.coordinates, *m.speeds)]
        n = len(m.speeds)
        residuals = [
            *(a - b for a, b in zip(rates, m.coordinate_derivatives, strict=False)),
            *(sm.Matrix(n, n, m.mass_matrix) * sm.Matrix(rates[-n:]) - sm.Matrix(m.forcing)),
        ]
        names = [[*m.coordinates, *m.speeds], rates, m.specifieds, m.constants]
        self.residuals = sm.lambdify(names, residuals, modules="math", cse=True)

    def methods(self) -> list[str]:
        return ["ida"]

    def solver(self, method: str, tolerance: float) -> Callable[[], np.ndarray]:
        inputs, constants = list(self.scenario.inputs), self.values.tolist()
        start, times = np.array(self.scenario.start), np.array([0.0, self.scenario.horizon])
        residuals = self.residuals

        def given(t: float, y: np.ndarray, yp: np.ndarray, res: np.ndarray) -> None:
            res[:] = residuals(y.tolist(), yp.tolist(), inputs, constants)

        # They are linear in the rates.
        zero = np.zeros(len(start))
        left = np.array(residuals(start, zero, inputs, constants), dtype=float)
        columns = [
            np.array(residuals(start, row, inputs, constants), dtype=float) - left
            for row in np.eye(len(start))
        ]
        begun = np.linalg.solve(np.transpose(columns), -left)
        solver = IDA(given, rtol=tolerance, atol=tolerance, max_num_steps=10**6)

        def solve() -> np.ndarray:
            found = solver.solve(times, start, begun)
            if not found.success:
                raise RuntimeError(found.message)
            return found.y[-1]

        return solve


if __name__ == "__main__":
    serve_solver(SundaeSolver())
