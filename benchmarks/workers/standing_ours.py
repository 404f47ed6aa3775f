"""Gains of a standing person by this project's fits; the argument is the folder for its code."""

from __future__ import annotations

import os
import sys
import time
from typing import Any

os.environ["PYDY_CACHE_DIR"] = sys.argv[1]

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from harness import standing
from harness.serve import serve

from pydy import System
from pydy.analysis import Trial
from pydy.control.ipopt import library

library()  # IPOPT is loaded once


class Ours:
    def load(self) -> None:
        platform = standing.accelerations(me.dynamicsymbols._t, sm.sin)
        self.system = System(standing.equations())
        self.system.specifieds = {standing.ACCELERATION: platform}

    def trial(self, seed: int, path: str) -> None:
        """Simulate, add noise to the states, and write the samples for others."""
        rng = np.random.default_rng(seed)
        times = np.linspace(0.0, standing.SECONDS, num=int(50 * standing.SECONDS) + 1)
        truth = dict(zip(standing.gains, standing.GAINS.ravel(), strict=True))
        self.system.constants = truth
        self.system.times, self.system.ode_solver = times, "dop853"
        ride = self.system.simulate(rtol=1e-8, atol=1e-8)
        measured = [ride[s] + rng.normal(0.0, standing.NOISE, len(times)) for s in standing.STATES]
        samples = dict(zip(standing.STATES, measured, strict=True))
        self.measured = Trial(times, samples, noise=standing.NOISE)
        if path:
            np.save(path, np.array([times, *measured]))

    def fit(self, method: str, share: float) -> Any:
        """Fit from a share of the true gains; return the processor time and the estimates."""
        start = share * standing.GAINS.ravel()
        self.system.constants = dict(zip(standing.gains, start, strict=True))
        began = time.process_time()
        found = self.system.fit(standing.gains, self.measured, method=method)
        seconds = time.process_time() - began
        return {"seconds": seconds, "gains": np.asarray(found.estimates).tolist(),
                "errors": np.asarray(found.standard_errors).tolist()}  # fmt: skip


if __name__ == "__main__":
    ours = Ours()
    serve({n: getattr(ours, n) for n in ("load", "trial", "fit")})
