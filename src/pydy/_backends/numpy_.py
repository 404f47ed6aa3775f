"""The 'lambdify' generator: a Program evaluated by NumPy, without any compiler."""

from __future__ import annotations

from typing import Any

import numpy as np

from pydy._backends.base import strict
from pydy._backends.registry import compile_program
from pydy._graph.interpret import run
from pydy._graph.program import Program
from pydy._kernel import Kernel

__all__ = ["NumPyBackend"]


class NumPyBackend:
    """Evaluates Programs with NumPy.

    Parameters
    ----------
    cse : bool, optional
        Accepted for scripts that pass it; common sub-expressions are always shared.
    """

    def __init__(self, cse: bool = True) -> None:
        self.options = {"cse": cse}

    def compile(self, program: Program) -> Kernel:
        """Return a Kernel whose sweep is one NumPy call per operation."""

        def sweep(
            t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray
        ) -> tuple[np.ndarray, np.ndarray]:
            return run(program, t, x, np.broadcast_to(r, (len(t), r.shape[1])), p)

        def call(x: Any, t: Any, r: Any, p: Any, out: np.ndarray) -> int:
            if not strict(program, x, r, p):
                return -1
            values, failed = run(program, np.array([t], float), x[None, :], r[None, :], p)
            out[:] = values[0]
            return int(failed[0])

        return Kernel(program, sweep, call, compile_program, ("lambdify", self.options))
