"""Back through recorded steps from Python's side: arrays for the compiled loop, step by step."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np

from pydy._array_layout import address
from pydy._interrupts import Interrupts
from pydy._kernel import KernelCall
from pydy.solvers import layout as at
from pydy.solvers.layout import Backward, rows_of, table_of
from pydy.solvers.options import Options
from pydy.solvers.run.problem import (
    Bound,
    Callback,
    blocks,
    lined_up,
    problem_of,
)
from pydy.solvers.run.shipped import function_of
from pydy.solvers.run.workspace import Workspace
from pydy.solvers.tableaus import tableau_of
from pydy.solvers.tuning import BLOCK


@dataclass(frozen=True, eq=False)
class Sweep:
    """The adjoint before some steps, and the contributions of the steps to gradients."""

    adjoint: np.ndarray  # (n,): of the state at its beginning
    totals: np.ndarray  # (k,): the derivatives by what else is wanted
    times: np.ndarray  # (m,): of the RK stages
    kept: np.ndarray  # (m, j): the last j of the totals, stage by stage


@lru_cache(maxsize=32)
def _turned(method: str, length: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the columns of a tableau as `Backward` needs them: the terms, then the weight."""
    tableau = tableau_of(method)
    stages = len(tableau.stages)
    table = np.zeros((stages + 1, stages))
    for k, row in enumerate((*tableau.stages, tableau.weights)):
        table[k, list(row)] = list(row.values())
    places = [np.flatnonzero(column) for column in table.T]
    return (
        np.cumsum([0, *map(len, places)]),
        np.concatenate(places) * length,
        np.concatenate([column[place] for column, place in zip(table.T, places, strict=True)]),
    )


class DiscreteAdjoint:
    """The adjoint of an explicit method: repeats its steps and goes back through their stages.

    The calls are of the derivatives of the n states, and of the same inputs with n weights after
    r: the derivatives of Σ weight · rate by the states and by `further` other inputs, of which the
    last `kept` are wanted stage by stage. The first call knows when the Kernel switches by time
    alone, as in the steps that were taken.
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
        self._turned = _turned(method, self.length)
        self._work = Workspace(method, rates, n, np.zeros(1), (), Options())
        self.nodes = np.array(tableau_of(method).nodes)[: len(tableau_of(method).stages)]
        self._python = turned.kernel.addresses is None
        self._problem = self._bound(replace(turned, switched=rates.switched))

    def _bound(self, call: KernelCall) -> Any:
        """Return the derivatives as the compiled loop reads them."""
        n = self.n
        if not self._python:
            return problem_of(Bound(call.kernel, call.p), n, call)
        s = len(call.r) - n
        problem: list[np.ndarray] = []

        def called(x: np.ndarray, t: float) -> np.ndarray:
            r = call.inputs_at(x, t)
            r[s:] = problem[0][s : s + n]
            found: np.ndarray = call.kernel.evaluate(np.array([t]), x[None], r[None], call.p)[0][0]
            return found

        outputs = n + self.further
        self._callback = Callback(called, n, outputs, "The derivatives", Interrupts())
        made = problem_of(self._callback, n, call)
        problem.append(made.r)
        return made

    def through(
        self,
        times: np.ndarray,
        ends: np.ndarray,
        states: np.ndarray,
        adjoint: np.ndarray,
        told: Callable[[int], None],
    ) -> Sweep:
        """Go back through some steps, which begin and end at these times, the first in `states`.

        The adjoint is of the state at the end; the number of steps is `told` now and then.
        """
        totals = np.zeros(self.further)
        instants: list[np.ndarray] = []
        kept: list[np.ndarray] = []
        # A million numbers of stages between two looks at whether to go on.
        most, last = max(1, 2**20 // (len(self.nodes) * self.length)), len(times)
        while last:
            some = slice(max(0, last - most), last)
            part = self._part(times[some], ends[some] - times[some], states[some], adjoint)
            adjoint, totals = part.adjoint, totals + part.totals
            instants.append(part.times)
            kept.append(part.kept)
            told(last - some.start)
            last = some.start
        none = np.zeros((0, self.kept))
        return Sweep(
            adjoint, totals, np.concatenate([[], *instants]), np.concatenate([none, *kept])
        )

    def _part(
        self, times: np.ndarray, sizes: np.ndarray, states: np.ndarray, adjoint: np.ndarray
    ) -> Sweep:
        n, length, count = self.n, self.length, len(self.nodes)
        adjoints = lined_up((count + 1) * length)
        adjoints[count * length : count * length + n] = adjoint
        back = Backward(
            np.array([len(self.rates.r), self.further, self.kept, -1]),
            *self._turned,
            np.ascontiguousarray(times),
            sizes,
            np.ascontiguousarray(states),
            adjoints,
            np.zeros(n + self.further),
            np.zeros(self.further),
            np.zeros((len(times) * count, self.kept)),
        )
        table = table_of(rows_of(self._problem), rows_of(back))
        python = self._python or bool(self._work.callbacks)
        function_of("step_back", python)(self._work.place, address(table))
        after = adjoints[count * length : count * length + n].copy()
        if back.words[at.BACK_WRONG] >= 0:
            after[:] = np.nan
        instants = times[:, None] + np.outer(sizes, self.nodes)
        # Steps end where inputs jump, with what these were before.
        jumps, before, _ = self._work.problem.jumps.T
        until = np.append(before, np.inf)[np.searchsorted(jumps, times, side="right")]
        instants = np.minimum(instants, until[:, None]).ravel()
        return Sweep(after, back.totals, instants, back.kept)
