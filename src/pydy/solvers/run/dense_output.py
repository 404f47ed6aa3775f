"""Dense output: states between the steps of a run, by the method's own continuous extension."""

from __future__ import annotations

import numpy as np

from pydy._array_layout import address
from pydy._checks import descends
from pydy.solvers.layout import Wanted, rows_of, table_of
from pydy.solvers.reflection import reversed_times
from pydy.solvers.run.shipped import function_of
from pydy.solvers.run.workspace import WorkspaceCopy
from pydy.solvers.tuning import BLOCK


class DenseOutput:
    """The dense output of a run: the interpolant of the method.

    Only the states at the ends of steps are stored, in `rows` of `layout.Steps`. For a time within
    a step, the step is repeated bit by bit in a copy of the run's Workspace, and the state is
    projected like an output. At the time of an event it is the state after it. If the run went
    `backward`, the rows are in reversed time.
    """

    def __init__(
        self, workspaces: WorkspaceCopy, rows: np.ndarray, n: int, backward: bool = False
    ) -> None:
        self._workspaces, self._rows, self._n, self._backward = workspaces, rows, n, backward
        # Rows of size 0 before the last are the ends of steps that an event cut short; the last row
        # is the end of the run, after its event.
        self._step_rows = np.flatnonzero(np.append(rows[:-1, 1] > 0.0, True))
        self._starts = rows[self._step_rows, 0]

    @property
    def starts(self) -> np.ndarray:
        """The ascending times between the steps, and at both ends."""
        starts: np.ndarray = reversed_times(self._starts[::-1]) if self._backward else self._starts
        return starts

    def __call__(self, times: np.ndarray) -> np.ndarray:
        """Return states and sensitivities at monotonic times of the run, shape (m, n)."""
        if descends(times):
            return self(times[::-1])[::-1]
        if self._backward:
            return self._evaluate(reversed_times(times[::-1]))[::-1]
        return self._evaluate(times)

    def _evaluate(self, times: np.ndarray) -> np.ndarray:
        n, m = self._n, len(times)
        # The step that begins at or before each time: at an event, that after it.
        steps = np.maximum(np.searchsorted(self._starts, times, side="right") - 1, 0)
        if np.array_equal(self._starts[steps], times):
            return self._rows[self._step_rows[steps], 2 : 2 + n]
        work, out = self._workspaces.acquire(), np.full(m * n + BLOCK, np.nan)
        requests = Wanted(self._rows, np.array(times, dtype=float), self._step_rows[steps], out)
        table = table_of(rows_of(requests))
        function_of("extend", bool(work.callbacks))(work.table_address, address(table))
        self._workspaces.release(work)
        return out[: m * n].reshape(m, n)

    def __deepcopy__(self, memo: dict[int, object]) -> DenseOutput:
        return self

    def __reduce__(self) -> tuple[type[None], tuple[()]]:
        """Pickle as None: machine code cannot leave the process."""
        return type(None), ()
