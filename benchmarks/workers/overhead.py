"""What an evaluation costs a native solver beyond the right-hand side itself."""

from __future__ import annotations

import ctypes
import sys
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from harness import frozen
from harness.program import solver_function
from harness.scenarios import scenario
from harness.serve import Repeated, serve

from pydy._array_layout import address
from pydy._backends.llvm import jit
from pydy._backends.llvm.compiling import Source, target_lines
from pydy.solvers.run.layout import STAGES, rows_of, table_of
from pydy.solvers.run.problem import BLOCK, blocks, kernel_problem
from pydy.solvers.solver import SOLVERS
from pydy.solvers.tableaus import method_arrays

sys.path.append(str(Path(__file__).resolve().parents[2] / "tools"))

import solvers_ir

HORIZON, SHORT, TOLERANCE = 10.0, 1e-3, 1e-9
CHAIN, STEPS = 2000, 200


def _text(text: str, brief: bool) -> str:
    return target_lines() + text


def _loops() -> Any:
    """Return the compiled loops of overhead.c."""
    with TemporaryDirectory() as folder:
        source = Path(__file__).with_suffix(".c")
        text = solvers_ir.neutral(solvers_ir.compiled(source, Path(folder)))
    return jit.load(Source(text, partial(_text, text), ("chain", "combinations"), loops=True))


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
        x, out, start = np.zeros(length), np.zeros(length), np.zeros(length)
        x[:n] = start[:n] = own.start
        problem = kernel_problem(function.native(args), n)
        arrays = method_arrays(method, length)
        stages = np.random.default_rng(1).normal(size=(int(arrays.shape[STAGES]) + 1) * length)
        step = np.full(BLOCK, 1e-3)
        parts = (problem, arrays, (x, start, out, step, stages))
        table = table_of(*map(rows_of, parts))
        self.alive = parts, table, _loops()
        kind = ctypes.CFUNCTYPE(*[ctypes.c_int64] * 3)
        chain, combinations = (kind(place) for place in self.alive[-1].addresses.values())
        self.measures = {
            "run": Repeated(lambda: run(HORIZON)),
            "short": Repeated(lambda: run(SHORT)),
            "kernel": Repeated(lambda: chain(address(table), CHAIN)),
            "bare": Repeated(lambda: combinations(address(table), STEPS)),
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
