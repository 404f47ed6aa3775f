"""The continuous extension of a run: states between its steps, of the method's own order."""

from __future__ import annotations

from typing import Any

import numpy as np

from pydy._array_layout import address
from pydy._checks import descends
from pydy.solvers.layout import Wanted, rows_of, table_of
from pydy.solvers.reflection import reversed_times
from pydy.solvers.run.shipped import function_of
from pydy.solvers.run.workspace import Twin
from pydy.solvers.tuning import BLOCK


class Extension:
    """The continuous extension of a run: the interpolant of the method itself.

    The steps are kept with their states alone, in `rows` of `layout.Steps`. Where a time is wanted,
    the step over it is taken again, with the same bits, and projected as an output is: in a
    `twin` of the run's Workspace. At the time of an event it is the state after it. Where the run
    went `backward`, the rows are in reversed time.
    """

    def __init__(self, twin: Twin, rows: np.ndarray, n: int, backward: bool = False) -> None:
        self._twin, self._rows, self._n, self._backward = twin, rows, n, backward
        # Not the ends of steps that an event cut short.
        self._steps = np.flatnonzero(np.append(rows[:-1, 1] > 0.0, True))
        self._starts = rows[self._steps, 0]

    @property
    def starts(self) -> np.ndarray:
        """The ascending times between the steps, and at both ends."""
        found: np.ndarray = reversed_times(self._starts[::-1]) if self._backward else self._starts
        return found

    def __call__(self, times: np.ndarray) -> np.ndarray:
        """Return states and sensitivities at monotonic times of the run, shape (m, n)."""
        if descends(times):
            return self(times[::-1])[::-1]
        if self._backward:
            return self._along(reversed_times(times[::-1]))[::-1]
        return self._along(times)

    def _along(self, times: np.ndarray) -> np.ndarray:
        n, m = self._n, len(times)
        places = np.maximum(np.searchsorted(self._starts, times, side="right") - 1, 0)
        if np.array_equal(self._starts[places], times):
            return self._rows[self._steps[places], 2 : 2 + n]
        work, out = self._twin.taken(), np.full(m * n + BLOCK, np.nan)
        wanted = Wanted(self._rows, np.array(times, dtype=float), self._steps[places], out)
        table = table_of(rows_of(wanted))
        function_of("extend", bool(work.callbacks))(work.place, address(table))
        self._twin.left(work)
        return out[: m * n].reshape(m, n)

    def __deepcopy__(self, memo: Any) -> Extension:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle as None: machine code and its arrays do not leave the process."""
        return type(None), ()
