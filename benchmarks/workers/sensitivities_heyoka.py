"""heyoka's variational integrator: `taylor_adaptive` on the equations that `var_ode_sys` makes."""

from __future__ import annotations

from collections.abc import Callable

import heyoka as hy
import numpy as np
from harness.sensitive import joined, parameters
from harness.solving import SolverPeer, serve_solver
from heyoka_ import equations_of, warm_up
from solve_heyoka import integrator_of, run_of


class HeyokaSensitivities(SolverPeer):
    costly = True

    def warm_up(self) -> None:
        warm_up()

    def build(self) -> None:
        states, rates = equations_of(self.model)
        first = len(self.model.specifieds)
        self.by = parameters(self.model)
        arguments = [hy.par[first + k] for k in self.by]
        equations = list(zip(states, rates, strict=True))
        self.equations = hy.var_ode_sys(equations, arguments, order=1)

    def methods(self) -> list[str]:
        return ["taylor, compact"]  # without, its code takes minutes to compile

    def solver(self, method: str, tolerance: float) -> Callable[[], np.ndarray]:
        integrator = integrator_of(self, self.equations, tolerance, compact=True)
        run = run_of(integrator, self.scenario.horizon)
        n, k = len(self.scenario.start), len(self.by)
        places = {tuple(integrator.get_mindex(i)): i for i in range(len(integrator.state))}
        unit = np.eye(k, dtype=int).tolist()
        table = [[places[i, *unit[j]] for j in range(k)] for i in range(n)]

        def solve() -> np.ndarray:
            state = run()
            return joined(state[:n], state[table])

        return solve


if __name__ == "__main__":
    serve_solver(HeyokaSensitivities())
