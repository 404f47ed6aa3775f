"""Back through recorded steps from Python's side: arrays for the compiled loop, step by step."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from pydy._array_layout import address
from pydy._interrupts import Interrupts
from pydy._kernel import Inputs, KernelCall
from pydy.solvers.run import layout as at
from pydy.solvers.run.layout import Backward, rows_of, table_of
from pydy.solvers.run.problem import (
    Callback,
    blocks,
    callback_problem,
    kernel_problem,
    lined_up,
)
from pydy.solvers.run.recording import Recording
from pydy.solvers.run.shipped import function_of
from pydy.solvers.tableaus import tableau_of
from pydy.solvers.tuning import BLOCK

_AT_ONCE = 2**20  # numbers of stages that are gone through between two looks at whether to go on


@dataclass(frozen=True, eq=False)
class Sweep:
    """What a stretch of steps makes of an adjoint."""

    adjoint: np.ndarray  # (n,): of the state at its beginning
    totals: np.ndarray  # (k,): the derivatives by what else is wanted
    times: np.ndarray  # (m,): of the RK stages
    kept: np.ndarray  # (m, j): the last j of the totals, stage by stage


@dataclass(frozen=True, eq=False)
class _Ways:
    """A tableau as the compiled loop reads it."""

    nodes: np.ndarray  # (stages,)
    table: np.ndarray  # (stages, stages): coefficients a
    # The terms of each row of a, then of each column with b below it.
    rows: np.ndarray
    offsets: np.ndarray
    coefficients: np.ndarray


@lru_cache(maxsize=32)
def _ways(method: str, length: int) -> _Ways:
    tableau = tableau_of(method)
    stages = len(tableau.stages)
    table = np.zeros((stages, stages))
    for k, row in enumerate(tableau.stages):
        table[k, list(row)] = list(row.values())
    ahead = np.vstack([table, np.zeros(stages)])
    ahead[-1, list(tableau.weights)] = list(tableau.weights.values())
    rows = [*table, *ahead.T]
    places = [np.flatnonzero(row) for row in rows]
    return _Ways(
        np.array(tableau.nodes[:stages]),
        table,
        np.cumsum([0, *map(len, places)]),
        np.concatenate(places) * length,
        np.concatenate([row[place] for row, place in zip(rows, places, strict=True)]),
    )


class WayBack:
    """The way back through the steps of an explicit method.

    The calls are of the derivatives of the n states, and of the same inputs with n weights after
    r: the derivatives of Σ weight · rate by the states and by `further` other inputs, of which the
    last `kept` are wanted stage by stage.
    """

    def __init__(
        self,
        method: str,
        rates: KernelCall,
        turned: KernelCall,
        further: int,
        kept: int,
    ) -> None:
        self.rates = rates
        self.n = n = rates.kernel.program.num_states
        self.length = BLOCK * blocks(n)
        self.further, self.kept = further, kept
        ways = _ways(method, self.length)
        self.stages, self.nodes, self.table = len(ways.nodes), ways.nodes, ways.table
        self._rows, self._offsets, self._coefficients = ways.rows, ways.offsets, ways.coefficients
        self._python = turned.kernel.addresses is None
        self._problem = self._bound(turned)

    def _bound(self, call: KernelCall) -> Any:
        """Return the derivatives as the compiled loop reads them."""
        n = self.n
        if not self._python:
            return kernel_problem(call, n)
        s = len(call.r) - n
        problem: list[np.ndarray] = []

        def called(x: np.ndarray, t: float) -> np.ndarray:
            r = call.inputs_at(x, t)
            r[s:] = problem[0][s : s + n]
            found: np.ndarray = call.kernel.evaluate(np.array([t]), x[None], r[None], call.p)[0][0]
            return found

        outputs = n + self.further
        self._callback = Callback(called, n, outputs, "The derivatives", Interrupts())
        made = callback_problem(self._callback, n, call)
        problem.append(made.r)
        return made

    def through(
        self,
        recording: Recording,
        first: int,
        last: int,
        adjoint: np.ndarray,
        told: Callable[[int], None],
    ) -> Sweep:
        """Go back from the end of step `last` − 1 to the beginning of step `first`.

        The adjoint is of the state at the end; the number of steps is `told` now and then.
        """
        totals = np.zeros(self.further)
        times: list[np.ndarray] = []
        kept: list[np.ndarray] = []
        most = max(1, _AT_ONCE // (self.stages * self.length))
        while last > first:
            start = max(first, last - most)
            part = self._part(recording, slice(start, last), adjoint)
            adjoint, totals = part.adjoint, totals + part.totals
            times.append(part.times)
            kept.append(part.kept)
            told(last - start)
            last = start
        none = np.zeros((0, self.kept))
        return Sweep(adjoint, totals, np.concatenate([[], *times]), np.concatenate([none, *kept]))

    def _part(self, recording: Recording, steps: slice, adjoint: np.ndarray) -> Sweep:
        times = np.array(recording.starts[steps])
        sizes = np.array(recording.ends[steps]) - times
        states = np.array(recording.before[steps])
        stages = self._all_stages(recording.stages[steps], times, sizes, states)
        number, length, count = len(times), self.length, self.stages
        adjoints = lined_up((count + 1) * length)
        adjoints[count * length : count * length + self.n] = adjoint
        back = Backward(
            words=np.array([count, len(self.rates.r), self.further, self.kept, -1]),
            rows=self._rows,
            offsets=self._offsets,
            coefficients=self._coefficients,
            nodes=self.nodes,
            times=times,
            sizes=sizes,
            states=states,
            stages=stages,
            adjoints=adjoints,
            step=lined_up(BLOCK),
            zero=lined_up(length),
            state=lined_up(length),
            weighted=lined_up(length),
            out=np.zeros(self.n + self.further),
            totals=np.zeros(self.further),
            kept=np.zeros((number * count, self.kept)),
        )
        table = table_of(rows_of(self._problem), rows_of(back))
        function_of("step_back", self._python)(address(table))
        after = adjoints[count * length : count * length + self.n].copy()
        if back.words[at.BACK_WRONG] >= 0:
            after[:] = np.nan
        instants = (times[:, None] + np.outer(sizes, self.nodes)).ravel()
        return Sweep(after, back.totals, instants, back.kept)

    def _all_stages(
        self,
        known: Sequence[np.ndarray | None],
        times: np.ndarray,
        sizes: np.ndarray,
        states: np.ndarray,
    ) -> np.ndarray:
        """Return the stages of some steps; those that were not kept are computed again."""
        count, length, n = self.stages, self.length, self.n
        left = [k for k, one in enumerate(known) if one is None]
        if not left:
            return np.array(known)
        h, x = sizes[left, None], states[left][:, :n]
        again = np.zeros((len(left), count, length))
        for stage in range(count):
            moved = np.tensordot(self.table[stage, :stage], again[:, :stage, :n], (0, 1))
            instants = times[left] + self.nodes[stage] * sizes[left]
            again[:, stage, :n] = self._evaluate(instants, x + h * moved)
        result = np.zeros((len(known), count * length))
        result[left] = again.reshape(len(left), -1)
        for k, one in enumerate(known):
            if one is not None:
                result[k] = one
        return result

    def _evaluate(self, t: np.ndarray, x: np.ndarray) -> np.ndarray:
        call = self.rates
        rows = Inputs(call.r, call.sampled).rows(np.empty((len(t), 0)), t)
        out, _ = call.kernel.evaluate(t, np.ascontiguousarray(x), rows, call.p)
        return out
