"""The steps of an integration, noted as they are taken."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from pydy.solvers.outcome import FINISHED
from pydy.solvers.run.layout import BUDGET, PAUSED, STARTED, TIME, Memory, Progress

_ROOM = 2**26  # bytes of stages: those of later steps are computed again


class Recording:
    """The steps of an explicit method, from one state to the next.

    A step that an event cut short is noted as far as it counts, without its stages.

    Integrals may follow the states; `count` is the number of stages of the method, and
    ``rates(x, t)`` gives the first stage of the first step.
    """

    def __init__(
        self, states: int, count: int, rates: Callable[[np.ndarray, float], np.ndarray]
    ) -> None:
        self.states, self.count, self._rates = states, count, rates
        self.clear()

    def clear(self) -> None:
        """Forget all steps."""
        self.starts: list[float] = []
        self.ends: list[float] = []
        self.before: list[np.ndarray] = []  # states at the beginning of steps, in whole blocks
        # The stages of each step one after the other, in whole blocks; None where they have to be
        # computed again.
        self.stages: list[np.ndarray | None] = []
        self._room = _ROOM

    def steps(
        self, most: int, advance: Callable[[], int], progress: Progress, memory: Memory
    ) -> int:
        """Take some steps one by one and note them; return the code of why it stopped.

        Calling `advance` takes the steps that the budget allows.
        """
        state, counts, code = progress.state, progress.counts, PAUSED
        for _ in range(most):
            start, before = float(state[TIME]), memory.x.copy()
            # The first stage is there from the step before; this one writes that of the next.
            first = memory.stages[: len(before)].copy()
            if not counts[STARTED]:
                found = self._rates(before, start)
                first[: len(found)] = found
            counts[BUDGET] = 1
            code = advance()
            end = float(state[TIME])
            if end > start:
                whole = first if code in (PAUSED, FINISHED) else None
                self._add(start, end, before, whole, memory.stages)
            if code != PAUSED:
                break
        return code

    def _add(
        self, start: float, end: float, x: np.ndarray, first: np.ndarray | None, all_: np.ndarray
    ) -> None:
        self.starts.append(start)
        self.ends.append(end)
        self.before.append(x)
        stages = None
        if first is not None and self._room > 0:
            length = len(x)
            stages = np.concatenate([first, all_[length : self.count * length]])
            self._room -= stages.nbytes
        self.stages.append(stages)
