"""The sweep of a Kernel for one state at a time, in lanes once it has evaluated many states.

Both have the same bits. In lanes a state takes a fourth or fifth of the time, and compiling takes
as long as is saved over half a million states, whatever the model. So that is how many the code for
one state evaluates before: the time is at most twice that of the better choice. Code that a cache
has is used earlier.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from pydy._backends.tuning import COMPILED_FROM, READ_FROM
from pydy._kernel import Sweep

LANES = 8  # as those of ensembles, whose code the cache may have


class ManyStates:
    """A sweep that chooses.

    ``wide(compiles)`` returns the sweep in lanes, or None where it is in no cache and `compiles` is
    False.
    """

    def __init__(self, one: Sweep, wide: Callable[[bool], Sweep | None]) -> None:
        self._one, self._make = one, wide
        self._wide: Sweep | None = None
        self._evaluated, self._next = 0, READ_FROM

    def __call__(
        self,
        t: np.ndarray,
        x: np.ndarray,
        r: np.ndarray,
        p: np.ndarray,
        out: np.ndarray | None = None,
    ) -> tuple[np.ndarray, np.ndarray, bool]:
        """Evaluate m samples; see `Kernel.sweep`."""
        if len(t) < LANES:
            return self._one(t, x, r, p, out)
        if self._wide is None:
            self._evaluated += len(t)
            if self._evaluated >= self._next:
                self._wide = self._make(self._evaluated >= COMPILED_FROM)
                self._next = COMPILED_FROM
        return (self._wide or self._one)(t, x, r, p, out)
