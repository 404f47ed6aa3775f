"""SUNDIALS' CVODES with forward sensitivities, on the C code that CasADi generates.

The equations of the columns stand beside those of the state, as CasADi's own derivative of an
`integrator` has them; compiled once, by `gcc -O2`. That derivative would be compiled anew for every
tolerance, for minutes.
"""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path

import casadi as ca
import numpy as np
from casadi_ import function_of
from harness.sensitive import joined, parameters
from harness.solving import SolverPeer, serve_solver


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
        folder = Path(self._folder.name)
        generator.generate(f"{folder}/")
        command = ["gcc", "-O2", "-march=native", "-shared", "-fPIC", "f.c", "-o", "f.so", "-lm"]
        subprocess.run(command, cwd=folder, check=True)
        # Functional iteration takes no Jacobian, but CasADi asks for one.
        options = {"enable_fd": True, "fd_method": "forward"}
        external = ca.external("f", str(folder / "f.so"), options)
        x, p = ca.MX.sym("x", n * (1 + m)), ca.MX.sym("p", s + k)
        self.problem = {"x": x, "p": p, "ode": external(x, p)}
        self.sizes = n, m

    def methods(self) -> list[str]:
        return ["adams, functional"]

    def solver(self, method: str, tolerance: float) -> Callable[[], np.ndarray]:
        formula, iteration = method.split(", ")
        options = {
            "reltol": tolerance,
            "abstol": tolerance,
            "linear_multistep_method": formula,
            "nonlinear_solver_iteration": iteration,
            "max_num_steps": 10**6,
        }
        horizon, (n, m) = self.scenario.horizon, self.sizes
        integrator = ca.integrator("solve", "cvodes", self.problem, 0.0, horizon, options)
        # Buffers spare the conversion of arguments at every call.
        buffer, run = integrator.buffer()
        start = np.concatenate([self.scenario.start, np.zeros(n * m)])
        given = np.concatenate([self.scenario.inputs, self.values])
        end = np.empty_like(start)
        buffer.set_arg(integrator.index_in("x0"), memoryview(start))
        buffer.set_arg(integrator.index_in("p"), memoryview(given))
        buffer.set_res(integrator.index_out("xf"), memoryview(end))

        def solve() -> np.ndarray:
            _kept = buffer, start, given  # they live as long as this function
            end[0] = np.nan
            run()
            return joined(end[:n], end[n:].reshape(m, n).T)

        return solve


if __name__ == "__main__":
    serve_solver(CasADiSensitivities())
