"""SUNDIALS' CVODES with forward sensitivities, on the C code that CasADi generates.

The equations of the columns stand beside those of the state, as CasADi's own derivative of an
`integrator` has them; compiled once, by `gcc -O2`. That derivative would be compiled anew for every
tolerance, for minutes.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

import casadi as ca
import numpy as np
from casadi_ import function_of, library_of
from harness.sensitive import joined, parameters
from harness.solving import SolverPeer, serve_solver
from solve_casadi import cvodes


class CasADiSensitivities(SolverPeer):
    def build(self) -> None:
        function = function_of(self.model)
        n, s, k = (function.size1_in(j) for j in range(3))
        by = parameters(self.model)
        m = len(by)
        x, r, p = (ca.SX.sym(name, size) for name, size in (("x", n), ("r", s), ("p", k)))
        columns, seeds = ca.SX.sym("columns", n, m), ca.SX.zeros(k, m)
        for j, place in enumerate(by):
            seeds[place, j] = 1.0
        rates = function(x, r, p)
        moved = function.forward(m)(x, r, p, rates, columns, ca.SX.zeros(s, m), seeds)
        whole = ca.vertcat(x, ca.vec(columns))
        out = ca.vertcat(rates, ca.vec(moved))
        generator = ca.CodeGenerator("f.c")
        generator.add(ca.Function("f", [whole, ca.vertcat(r, p)], [out]))
        self._folder = tempfile.TemporaryDirectory()
        library = library_of(generator, Path(self._folder.name), "-O2")
        # Functional iteration takes no Jacobian, but CasADi asks for one.
        options = {"enable_fd": True, "fd_method": "forward"}
        external = ca.external("f", str(library), options)
        x, p = ca.MX.sym("x", n * (1 + m)), ca.MX.sym("p", s + k)
        self.problem = {"x": x, "p": p, "ode": external(x, p)}
        self.sizes = n, m

    def methods(self) -> list[str]:
        return ["adams, functional"]

    def solver(self, method: str, tolerance: float) -> Callable[[], np.ndarray]:
        n, m = self.sizes
        start = np.concatenate([self.scenario.start, np.zeros(n * m)])
        run = cvodes(self, self.problem, start, method, tolerance)

        def solve() -> np.ndarray:
            end = run()
            return joined(end[:n], end[n:].reshape(m, n).T)

        return solve


if __name__ == "__main__":
    serve_solver(CasADiSensitivities())
