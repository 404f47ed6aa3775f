"""This project's kernels: one lane for scalar code, eight for batches.

An argument is the width of batched code, in place of what suits the processor.
"""

from __future__ import annotations

import os
import sys
from typing import Any

import numpy as np
import sympy as sm
from harness.model import Model
from harness.peer import Peer, serve_peer
from harness.program import assembly_of, equations_of
from harness.serve import time_of
from sympy.physics.mechanics import dynamicsymbols

from pydy._assembly.programs import block_program
from pydy._backends.llvm.jit import memory
from pydy._backends.llvm.native import LLVMBackend, make_sweep

WIDTH = int(sys.argv[1]) if len(sys.argv) > 1 else None


class Ours(Peer):
    def warm_up(self) -> None:
        for definite in (True, False):
            program = block_program(assembly_of(_small(definite)), "rates")
            for lanes in (1, 8):
                LLVMBackend(lanes=lanes).compile(program)

    def load(self, name: str, count: int = Peer.count) -> Any:
        sizes = super().load(name, count)
        self.equations = equations_of(self.model)
        return sizes

    def build(self, lanes: int = 1) -> Any:
        program = block_program(assembly_of(self.model, self.equations), "rates")
        kernel = LLVMBackend(lanes=lanes, width=WIDTH if lanes > 1 else None).compile(program)
        kernel.link()
        return kernel

    def build_time(self) -> float:
        # What was compiled before must not count, neither in memory nor on disk.
        memory.clear()
        os.environ["PYDY_CACHE_DIR"] = "off"
        return time_of(self.build)

    def _sweep(self, sweep: Any, order: str) -> Any:
        t = np.zeros(self.count)
        x, r = np.asarray(self.x, order=order), np.asarray(self.r, order=order)
        self._out = np.empty(x.shape, order=order)  # kept, as heyoka's is

        def evaluate() -> None:
            _, self._failed, _ = sweep(t, x, r, self.p, self._out)

        return evaluate

    def scalar(self) -> Any:
        # The Kernel's own sweep would go over to lanes after half a million states.
        kernel = self.build()
        return self._sweep(make_sweep(kernel.program, kernel.functions, 1, 0), "C")

    def batched(self) -> Any:
        # A column for each variable, as heyoka has it.
        return self._sweep(self.build(lanes=8).sweep, "F")

    def values(self) -> np.ndarray:
        assert not self._failed.any()
        return self._out


def _small(definite: bool) -> Model:
    """Return a model of two speeds that uses the routines every model shares."""
    q, u = (list(dynamicsymbols(f"{name}0:2")) for name in "qu")
    m = sm.Symbol("m")
    matrix = [m, sm.cos(q[0]), sm.cos(q[0]), 2 * m]
    return Model("small", q, u, [], [m], matrix, [sm.sin(q[1]), u[0]], u, definite, [2.0], {})


if __name__ == "__main__":
    serve_peer(Ours())
