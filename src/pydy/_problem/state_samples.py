"""A model at many states."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np

from pydy._assembly import Assembly, CompiledModel, Definition
from pydy._kernel import Kernel


@dataclass(frozen=True, eq=False)
class StateSamples:
    """A model at m states, with all that its equations take there."""

    definition: Definition
    model: CompiledModel  # with the expressions for specifieds compiled in
    t: np.ndarray  # (m,)
    x: np.ndarray  # (m, n)
    r: np.ndarray  # (m, s), or (1, s) for all states alike
    p: np.ndarray  # (k,), or (m, k)

    def subset(self, rows: Any) -> Self:
        """Return the same at some of the states, by indices or a mask."""
        r = self.r[rows] if len(self.r) > 1 else self.r
        p = self.p[rows] if self.p.ndim > 1 else self.p
        return replace(self, t=self.t[rows], x=self.x[rows], r=r, p=p)

    def evaluate(self, kernel: Kernel, x: np.ndarray | None = None) -> np.ndarray:
        """Return the flat outputs of a Kernel, shape (m, o); x may have more than the states."""
        x = self.x if x is None else x
        return self.model.evaluate_checked(kernel, self.t, x, self.r, self.p)[0]

    def evaluate_checked(
        self, kernel: Kernel, x: np.ndarray | None = None
    ) -> tuple[np.ndarray, bool]:
        """Return the same, and whether all outputs are finite."""
        x = self.x if x is None else x
        return self.model.evaluate_checked(kernel, self.t, x, self.r, self.p)

    def interpret(self, nodes: Callable[[Assembly], dict[str, list[int]]]) -> dict[str, np.ndarray]:
        """Return the values of nodes, shape (m, o) for each name; few are worth compiling."""
        return self.model.interpreted(nodes, (self.t, self.x, self.r, self.p))

    def rates(self) -> np.ndarray:
        """Return the derivatives of the states, shape (m, n)."""
        return self.evaluate(self.model.compiled("rates"))

    def outputs(self) -> np.ndarray:
        """Return the outputs, shape (m, o)."""
        if not self.definition.outputs.symbols:
            return np.empty((len(self.t), 0))
        return self.evaluate(self.model.compiled("outputs"))
