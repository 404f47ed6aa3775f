"""Gains of a standing person by opty: midpoint, a node for each sample, least squares."""

from __future__ import annotations

import resource
import time
from typing import Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from harness import standing
from harness.serve import serve
from opty import Problem


def processor_time() -> float:
    """Return what this process and its compilers took."""
    kinds = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    used = [resource.getrusage(kind) for kind in kinds]
    return sum(u.ru_utime + u.ru_stime for u in used)


class Opty:
    def load(self, path: str, folder: str | None = None) -> Any:
        """Build for samples; what is compiled already is taken from a folder, if given."""
        times, *measured = np.load(path)
        self.measured = np.array(measured)
        N, n, h = len(times), 4, times[1]
        t = me.dynamicsymbols._t
        kane = standing.equations()
        rates = kane.kindiffdict()
        moves = kane.mass_matrix * kane.u.diff(t) - kane.forcing
        rows = [q.diff(t) - rates[q.diff(t)] for q in kane.q]
        equations = sm.Matrix([*rows, *moves.xreplace(rates)])

        def objective(free: np.ndarray) -> float:
            away = free[: n * N] - self.measured.ravel()
            return float(h * (away @ away))

        def gradient(free: np.ndarray) -> np.ndarray:
            slopes = np.zeros(len(free))
            slopes[: n * N] = 2 * h * (free[: n * N] - self.measured.ravel())
            return slopes

        begin = processor_time()
        platform = standing.accelerations(times, np.sin)
        self.problem = Problem(
            objective,
            gradient,
            equations,
            standing.STATES,
            N,
            h,
            known_trajectory_map={standing.ACCELERATION: platform},
            time_symbol=t,
            integration_method="midpoint",
            tmp_dir=folder,
        )
        self.names = [str(s) for s in self.problem.collocator.unknown_parameters]
        return {"seconds": processor_time() - begin}

    def fit(self, share: float) -> Any:
        """Fit from the samples and a share of the true gains."""
        true = dict(zip(map(str, standing.gains), standing.GAINS.ravel(), strict=True))
        start = [share * true[name] for name in self.names]
        self.problem.add_option("print_level", 0)
        self.problem.add_option("sb", "yes")
        self.problem.add_option("max_iter", 3000)
        began = time.process_time()
        found, info = self.problem.solve(np.concatenate([self.measured.ravel(), start]))
        seconds = time.process_time() - began
        own = dict(zip(self.names, found[-len(self.names) :], strict=True))
        return {"seconds": seconds, "gains": [float(own[str(s)]) for s in standing.gains],
                "status": info["status_msg"].decode()[:60]}  # fmt: skip


if __name__ == "__main__":
    opty = Opty()
    serve({n: getattr(opty, n) for n in ("load", "fit")})
