"""Print the bits of right-hand sides and trajectories: ``python tools/bits.py``.

What is printed on two processors with fused multiply-add is the same, line by line; where it is
not, the first differing line names the model and what was computed. `tools/arm64.sh` compares this
processor with AArch64.
"""

from __future__ import annotations

import hashlib
import sys
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

import zoo
from registry import SOLVERS, has_fixed_step
from zoo.cases import system_of

# Where the default tolerances would not tell much.
OPTIONS = {"vern9": {"rtol": 1e-12, "atol": 1e-12}}


def digest(values: Any) -> str:
    """Return the digest of the bits of floating-point numbers."""
    array = np.ascontiguousarray(values, dtype=float) + 0.0  # one zero
    return hashlib.sha256(array.astype("<f8").tobytes()).hexdigest()[:16]


def say(model: str, what: str, values: Any) -> None:
    """Print one line: what was computed, its digest, and a number to judge a difference by."""
    print(f"{model:24} {what:16} {digest(values)} {float(np.ravel(values)[-1])!r}", flush=True)


def main() -> None:
    """Print the lines of all models in the tests' zoo."""
    for name in sorted(zoo.MODELS):
        model = zoo.MODELS[name]()
        system = system_of(model, times=[0.0, 0.1, 0.2])
        random = np.random.default_rng(1)
        x = random.uniform(0.2, 0.9, (19, len(system.states)))  # two blocks of eight and a rest
        t = np.sort(random.uniform(0.3, 2.0, 19))
        say(name, "rates", system.evaluate_ode(x, t))
        say(name, "a single state", system.evaluate_ode(x[0], t[0]))
        if model.start or not system.constraints:
            system.initial_conditions = dict(model.start or zip(system.states, x[0], strict=True))
            for solver in sorted(SOLVERS, key=lambda solver: solver.name):
                system.ode_solver = solver
                fixed = {"step": 0.01} if has_fixed_step(solver) else {}
                say(name, solver.name, system.integrate(**OPTIONS.get(solver.name, fixed)))


if __name__ == "__main__":
    main()
