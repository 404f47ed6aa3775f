"""SUNDIALS' CVODES as CasADi's `integrator` has it, on the C code that CasADi generates."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
from casadi_ import function_of, library_of
from harness.solving import SolverPeer, serve_solver

# With more instructions than this, gcc takes minutes over the Jacobian's code; CasADi then takes
# differences of the function.
COMPILED = 10_000
METHODS = ("adams, functional", "adams, newton", "bdf, newton")  # formula, iteration


def cvodes(
    peer: SolverPeer, problem: dict[str, Any], start: np.ndarray, method: str, tolerance: float
) -> Callable[[], np.ndarray]:
    """Return a function that integrates a problem over a peer's scenario.

    It returns the same array at each call.
    """
    formula, iteration = method.split(", ")
    options = {
        "reltol": tolerance,
        "abstol": tolerance,
        "linear_multistep_method": formula,
        "nonlinear_solver_iteration": iteration,
        "max_num_steps": 10**6,
    }
    integrator = ca.integrator("solve", "cvodes", problem, 0.0, peer.scenario.horizon, options)
    # Buffers spare the conversion of arguments at every call.
    buffer, run = integrator.buffer()
    given = np.concatenate([peer.scenario.inputs, peer.values])
    end = np.empty_like(start)
    buffer.set_arg(integrator.index_in("x0"), memoryview(start))
    buffer.set_arg(integrator.index_in("p"), memoryview(given))
    buffer.set_res(integrator.index_out("xf"), memoryview(end))

    def solve() -> np.ndarray:
        _kept = buffer, start, given  # they live as long as this function
        end[0] = np.nan
        run()
        return end

    return solve


class CasADiSolver(SolverPeer):
    def build(self) -> None:
        function = function_of(self.model)
        jacobian = function.jacobian()
        exact = jacobian.n_instructions() <= COMPILED
        self._folder = tempfile.TemporaryDirectory()
        generator = ca.CodeGenerator("f.c")
        generator.add(function)
        if exact:
            generator.add(jacobian)
        library = library_of(generator, Path(self._folder.name), "-O3")
        options = {} if exact else {"enable_fd": True, "fd_method": "forward"}
        external = ca.external("f", str(library), options)
        n, s, k = (function.size1_in(j) for j in range(3))
        x, p = ca.MX.sym("x", n), ca.MX.sym("p", s + k)
        self.problem = {"x": x, "p": p, "ode": external(x, p[:s], p[s:])}

    def methods(self) -> list[str]:
        return list(METHODS)

    def solver(self, method: str, tolerance: float) -> Callable[[], np.ndarray]:
        return cvodes(self, self.problem, np.array(self.scenario.start), method, tolerance)


if __name__ == "__main__":
    serve_solver(CasADiSolver())
