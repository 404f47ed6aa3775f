"""heyoka's batch integrator over an ensemble of pendulums."""

from __future__ import annotations

import os
import time
from typing import Any

import heyoka as hy
import numpy as np
from harness.convert import translate
from harness.elimination import solve_definite
from harness.frozen import read
from harness.pendulums import TIMES, samples
from harness.serve import module_at, serve

Heyoka = module_at(__file__.replace("ensembles_heyoka", "heyoka_")).Heyoka


class Batch:
    def load(self, links: int, count: int) -> dict[str, Any]:
        """Return the sizes of batches worth trying: one register's, two's and four's."""
        self.model = read(f"pendulum-{links}")
        self.x, self.p = samples(links, count)
        self.made: dict[tuple[float, int], Any] = {}
        narrow = 4 if os.environ.get("PYDY_CPU") == "x86-64-v3" else hy.recommended_simd_size()
        return {"sizes": [narrow, 2 * narrow]}

    def _integrator(self, tol: float, size: int) -> Any:
        """Return the integrator of a tolerance, compiled once."""
        if (tol, size) not in self.made:
            n, k = self.x.shape[1], self.p.shape[1]
            states = hy.make_vars(*(f"x{j}" for j in range(n)))
            still = [hy.expression(0.0)] * len(self.model.specifieds)
            matrix, forcing, rates = translate(
                self.model, Heyoka(), states, still, [hy.par[j] for j in range(k)]
            )
            equations = list(zip(states, [*rates, *solve_definite(matrix, forcing)], strict=True))
            self.made[tol, size] = hy.taylor_adaptive_batch(
                equations,
                np.zeros((n, size)),
                tol=tol,
                pars=np.zeros((k, size)),
                force_avx512=size == 8 and os.environ.get("PYDY_CPU") != "x86-64-v3",
            )
        return self.made[tol, size]

    def lanes(self, tol: float, size: int, count: int) -> dict[str, Any]:
        """Time the first samples, batch after batch."""
        integrator = self._integrator(tol, size)
        grid = np.repeat(TIMES[:, None], size, axis=1)
        self.states = np.empty((count, len(TIMES), self.x.shape[1]))
        start = time.perf_counter()
        for i in range(0, count, size):
            integrator.set_time(0.0)
            integrator.state[:] = self.x[i : i + size].T
            integrator.pars[:] = self.p[i : i + size].T
            self.states[i : i + size] = np.moveaxis(integrator.propagate_grid(grid)[1], 2, 0)
        return {"seconds": time.perf_counter() - start}

    def save(self, path: str, count: int) -> None:
        """Write the first trajectories, for errors."""
        np.save(path, self.states[:count])


if __name__ == "__main__":
    batch = Batch()
    serve({n: getattr(batch, n) for n in ("load", "lanes", "save")})
