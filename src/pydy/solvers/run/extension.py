"""The continuous extension of a run, from Python's side."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pydy import _forks
from pydy.solvers.run.layout import Wanted
from pydy.solvers.run.problem import address
from pydy.solvers.run.shipped import function_of
from pydy.solvers.run.table import rows_of, table_of
from pydy.solvers.run.workspace import Workspace
from pydy.solvers.tuning import BLOCK

__all__ = ["Extension"]


class Extension:
    """The solution between the steps of a run: the interpolant of the method itself.

    The steps are kept with their states alone. Where a time is wanted, the step over it is taken
    again, with the same bits, and projected as an output is. At the time of an event it is the
    state after it.

    Parameters
    ----------
    make : callable
        Returns a Workspace like that of the run, which may be used for another one meanwhile.
    rows : ndarray
        Those of `pydy.solvers.run.layout.Steps`.
    select : callable, optional
        What is made of the states; by default they are returned with all that is beside them.
    """

    def __init__(
        self,
        make: Callable[[], Workspace],
        rows: np.ndarray,
        select: Callable[[np.ndarray], np.ndarray] | None = None,
    ) -> None:
        self._select = select
        self._make, self._rows = make, rows
        self._in_use = _forks.Lock()  # by one of several threads
        # Not the ends of steps that an event cut short.
        self._steps = np.flatnonzero(np.append(rows[:-1, 1] > 0.0, True))
        self._starts = rows[self._steps, 0]

    @_forks.cached_property
    def _workspace(self) -> Workspace:
        return self._make()

    def __call__(self, times: np.ndarray) -> np.ndarray:
        """Return the states at ascending times of the run, shape (m, n)."""
        work, n, m = self._workspace, self._workspace.n, len(times)
        places = np.searchsorted(self._starts, times, side="right") - 1
        out = np.full(m * n + BLOCK, np.nan)
        wanted = Wanted(
            self._rows, np.array(times, dtype=float), self._steps[np.maximum(places, 0)], out
        )
        table = table_of(rows_of(wanted))
        with self._in_use:
            function_of("extend", bool(work.callbacks))(work.place, address(table))
        states = out[: m * n].reshape(m, n)
        return states if self._select is None else self._select(states)

    def selected(self, select: Callable[[np.ndarray], np.ndarray]) -> Extension:
        """Return the same of what `select` makes of the states."""
        return Extension(self._make, self._rows, select)

    def __deepcopy__(self, memo: Any) -> Extension:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        """Become None elsewhere: machine code and the arrays that it works on stay here."""
        return type(None), ()
