"""What an evaluation costs a native solver beyond the right-hand side itself."""

from __future__ import annotations

from typing import Any

import numpy as np
from harness import frozen
from harness.program import solver_function
from harness.scenarios import scenario
from harness.serve import Repeated, serve
from numba import njit

from pydy.solvers.loop.intrinsics import address_of, call_kernel, combine
from pydy.solvers.run.layout import ESTIMATES, KERNEL, STAGES, STATES
from pydy.solvers.run.methods import method_arrays
from pydy.solvers.run.problem import BLOCK, blocks, kernel_problem
from pydy.solvers.solver import SOLVERS

HORIZON, SHORT, TOLERANCE = 10.0, 1e-3, 1e-9
CHAIN, STEPS = 2000, 200


@njit
def _chain(problem, x, start, out, count):  # type: ignore[no-untyped-def]
    """Evaluate again and again, each time at a state that depends on all of the last result."""
    for _ in range(count):
        call_kernel(
            problem.words[KERNEL],
            address_of(problem.clock, 0),
            address_of(x, 0),
            address_of(problem.r, 0),
            address_of(problem.c, 0),
            address_of(out, 0),
        )
        for i in range(problem.words[STATES]):
            x[i] = start[i] + 1e-12 * out[i]


@njit
def _combinations(method, step, stages, x, y, rows, size, count):  # type: ignore[no-untyped-def]
    """Compute all linear combinations of `count` steps."""
    for _ in range(count):
        for row in range(1, rows):
            first = method.rows[row]
            combine(
                address_of(y, 0),
                address_of(x, 0),
                address_of(step, 0),
                address_of(stages, 0),
                address_of(method.offsets, first),
                address_of(method.weights, first),
                method.rows[row + 1] - first - 1,
                1,
                size,
            )


class Overhead:
    """A model, and what is timed on it."""

    def load(self, name: str, method: str) -> dict[str, Any]:
        """Compile; returns what one integration counted."""
        model = frozen.read(name)
        own = scenario(model)
        function, args = solver_function(model, own.inputs)
        solver = SOLVERS[method]

        def run(horizon: float, **options: Any) -> Any:
            return solver(
                function,
                own.start,
                [0.0, horizon],
                args=args,
                rtol=TOLERANCE,
                atol=TOLERANCE,
                **options,
            )

        info = run(HORIZON, full_output=True)[1]
        self.least = run(SHORT, full_output=True)[1]["evaluations"]
        n = len(own.start)
        length = BLOCK * blocks(n)
        x, out = np.zeros(length), np.zeros(length)
        x[:n] = own.start
        problem = kernel_problem(function.native(args), n)
        arrays = method_arrays(method, length)
        stages = int(arrays.shape[STAGES])
        rows = stages + 1 + int(arrays.shape[ESTIMATES])
        values = np.random.default_rng(1).normal(size=(stages + 1) * length)
        step, y, size = np.full(BLOCK, 1e-3), np.zeros(length), blocks(n)
        self.start = x.copy()
        self.measures = {
            "run": Repeated(lambda: run(HORIZON)),
            "short": Repeated(lambda: run(SHORT)),
            "kernel": Repeated(lambda: _chain(problem, x, self.start, out, CHAIN)),
            "bare": Repeated(
                lambda: _combinations(arrays, step, values, self.start, y, rows, size, STEPS)
            ),
        }
        self.evaluations = info["evaluations"]
        self.attempts = info["steps"] + info["rejected"]
        return {key: info[key] for key in ("steps", "rejected", "evaluations")}

    def time(self) -> dict[str, float]:
        """Return the seconds for one evaluation: of a run, the kernel, the combinations.

        `further` is one more evaluation of a run, without what a call costs once; `short` is the
        shortest call.
        """
        keys = ("run", "short", "kernel", "bare")
        run, short, kernel, bare = (self.measures[key]() for key in keys)
        return {
            "run": run / self.evaluations,
            "short": short,
            "further": (run - short) / (self.evaluations - self.least),
            "kernel": kernel / CHAIN,
            "bare": bare / STEPS * self.attempts / self.evaluations,
        }


if __name__ == "__main__":
    overhead = Overhead()
    serve({name: getattr(overhead, name) for name in ("load", "time")})
