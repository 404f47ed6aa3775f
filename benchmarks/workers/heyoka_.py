"""heyoka's `cfunc`, with the constants and specifieds as its run-time parameters."""

from __future__ import annotations

import os
from typing import Any

import heyoka as hy
import numpy as np
from harness.convert import Algebra
from harness.elimination import derivatives
from harness.model import Model
from harness.peer import Peer, serve_peer
from harness.serve import time_of


class Heyoka(Algebra):
    def __init__(self) -> None:
        super().__init__({name: getattr(hy, name) for name in ("sin", "cos", "tan", "sqrt")})

    def number(self, value: float) -> Any:
        return hy.expression(value)

    def sum(self, terms: list[Any]) -> Any:
        return hy.sum(terms)

    def product(self, factors: list[Any]) -> Any:
        return hy.prod(factors)


def warm_up() -> None:
    """Turn caches off and initialise LLVM."""
    hy.llvm_state.set_diskcache_enabled(False)
    hy.llvm_state.set_memcache_limit(0)
    x = hy.make_vars("x")
    hy.cfunc([hy.sin(x)], [x])


def equations_of(model: Model) -> tuple[list[Any], list[Any]]:
    """Return the states and their derivatives; r and p are parameters, in this order."""
    states = hy.make_vars(*(f"x{k}" for k in range(len(model.coordinates) + len(model.speeds))))
    r = [hy.par[k] for k in range(len(model.specifieds))]
    p = [hy.par[len(r) + k] for k in range(len(model.constants))]
    return states, derivatives(model, Heyoka(), states, r, p)


class HeyokaPeer(Peer):
    def warm_up(self) -> None:
        warm_up()

    def build(self, **options: Any) -> Any:
        """One state at a time by default; `batch_size` and `force_avx512` are heyoka's own."""
        states, rates = equations_of(self.model)
        return hy.cfunc(rates, states, **({"batch_size": 1} | options))

    def _over_all(self, function: Any) -> Any:
        inputs = np.ascontiguousarray(self.x.T)
        constants = np.repeat(self.p[:, None], self.count, axis=1)
        pars = np.ascontiguousarray(np.vstack([self.r.T, constants]))
        out = np.empty((len(inputs), self.count))

        def evaluate() -> None:
            function(inputs, pars=pars, outputs=out, batch_parallel=False)
            self._out = out

        return evaluate

    def scalar(self) -> Any:
        return self._over_all(self.build())

    def batched(self) -> Any:
        # heyoka avoids 512-bit vectors unless told otherwise; take what is faster here.
        wide = hy.recommended_simd_size()
        flags = (False, True)
        if os.environ.get("PYDY_CPU") == "x86-64-v3":
            wide, flags = 4, (False,)
        choices = [{"batch_size": wide, "force_avx512": flag} for flag in flags]
        functions = [self._over_all(self.build(**choice)) for choice in choices]
        best = min(functions, key=lambda f: min(time_of(f) for _ in range(5)))
        best()
        return best

    def values(self) -> np.ndarray:
        return self._out.T


if __name__ == "__main__":
    serve_peer(HeyokaPeer())
