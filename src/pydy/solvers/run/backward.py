"""The discrete adjoint of recorded steps: arrays for the compiled loop."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from pydy._array_layout import address
from pydy._interrupts import Interrupts
from pydy._kernel import KernelCall
from pydy.solvers import layout as at
from pydy.solvers.layout import Backward, rows_of, table_of
from pydy.solvers.options import Options
from pydy.solvers.run.problem import (
    Callback,
    KernelBinding,
    aligned_zeros,
    block_count,
    problem_arrays,
)
from pydy.solvers.run.recorded_steps import RecordedSteps
from pydy.solvers.run.shipped import function_of
from pydy.solvers.run.workspace import Workspace
from pydy.solvers.tableaus import tableau_of
from pydy.solvers.tuning import BLOCK

if TYPE_CHECKING:
    from pydy.solvers.layout import Problem


@dataclass(frozen=True, eq=False)
class AdjointSweep:
    """The adjoint before some steps, and the contributions of the steps to a gradient."""

    adjoint: np.ndarray  # (n,): of the state at its beginning
    totals: np.ndarray  # (k,): the derivatives by the further inputs
    times: np.ndarray  # (m,): of the RK stages
    stagewise: np.ndarray  # (m, j): the last j of the totals, for each stage


@lru_cache(maxsize=32)
def _tableau_columns(method: str, length: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the columns of a tableau for `Backward`: the coefficients, then the weight."""
    tableau = tableau_of(method)
    stages = len(tableau.stages)
    table = np.zeros((stages + 1, stages))
    for k, row in enumerate((*tableau.stages, tableau.weights)):
        table[k, list(row)] = list(row.values())
    indices = [np.flatnonzero(column) for column in table.T]
    return (
        np.cumsum([0, *map(len, indices)]),
        np.concatenate(indices) * length,
        np.concatenate([column[index] for column, index in zip(table.T, indices, strict=True)]),
    )


class DiscreteAdjoint:
    """The discrete adjoint of an explicit method: repeats its steps and reverses their stages.

    The first call evaluates the `rates` of the n states, with the switches by time of the original
    integration. The second one has n weights after the inputs r: it evaluates the `derivatives` of
    Σ weight · rate by the states and by `further` other inputs, of which the last `stagewise` ones
    are returned for each stage.
    """

    def __init__(
        self,
        method: str,
        rates: KernelCall,
        derivatives: KernelCall,
        further: int,
        stagewise: int,
    ) -> None:
        self.rates = rates
        self.n = n = rates.kernel.program.signature.num_states
        self.length = BLOCK * block_count(n)
        self.further, self.stagewise = further, stagewise
        self._tableau_columns = _tableau_columns(method, self.length)
        self._work = Workspace(method, rates, n, np.zeros(1), (), Options())
        self.nodes = np.array(tableau_of(method).nodes)[: len(tableau_of(method).stages)]
        self._python = derivatives.kernel.addresses is None
        self._problem = self._bind(replace(derivatives, switched=rates.switched))

    def _bind(self, call: KernelCall) -> Problem:
        """Return the derivatives as arguments of the compiled loop."""
        n = self.n
        if not self._python:
            return problem_arrays(KernelBinding(call.kernel, call.p), n, call)
        s = len(call.inputs.values) - n
        problem: list[np.ndarray] = []

        def derivatives(x: np.ndarray, t: float) -> np.ndarray:
            r = call.inputs(x, t)
            r[s:] = problem[0][s : s + n]
            values: np.ndarray = call.kernel.evaluate(np.array([t]), x[None], r[None], call.p)[0][0]
            return values

        outputs = n + self.further
        self._callback = Callback(derivatives, n, outputs, "The derivatives", Interrupts())
        bound_problem = problem_arrays(self._callback, n, call)
        problem.append(bound_problem.r)
        return bound_problem

    def sweep_back(
        self,
        steps: RecordedSteps,
        span: slice,
        adjoint: np.ndarray,
        on_steps: Callable[[int], None],
    ) -> AdjointSweep:
        """Reverse the steps in a span of their indices.

        The adjoint is that of the state at the end. The number of finished steps is passed to
        `on_steps` now and then.
        """
        times, ends, states = steps.starts[span], steps.ends[span], steps.states[span]
        totals = np.zeros(self.further)
        instants: list[np.ndarray] = []
        stagewise: list[np.ndarray] = []
        # Between two calls of `on_steps`: a million numbers of stages.
        most, last = max(1, 2**20 // (len(self.nodes) * self.length)), len(times)
        while last:
            rows = slice(max(0, last - most), last)
            part = self._sweep_steps(times[rows], ends[rows] - times[rows], states[rows], adjoint)
            adjoint, totals = part.adjoint, totals + part.totals
            instants.append(part.times)
            stagewise.append(part.stagewise)
            on_steps(last - rows.start)
            last = rows.start
        none = np.zeros((0, self.stagewise))
        return AdjointSweep(
            adjoint, totals, np.concatenate([[], *instants]), np.concatenate([none, *stagewise])
        )

    def _sweep_steps(
        self, times: np.ndarray, sizes: np.ndarray, states: np.ndarray, adjoint: np.ndarray
    ) -> AdjointSweep:
        """Reverse these steps, given the adjoint of the state at their end.

        Derivatives by the last inputs are returned for each stage, to be spread over samples, with
        the times of the stages: not after an input jumps.
        """
        n, length, count = self.n, self.length, len(self.nodes)
        adjoints = aligned_zeros((count + 1) * length)
        adjoints[count * length : count * length + n] = adjoint
        back = Backward(
            np.array([len(self.rates.inputs.values), self.further, self.stagewise, -1]),
            *self._tableau_columns,
            np.ascontiguousarray(times),
            sizes,
            np.ascontiguousarray(states),
            adjoints,
            np.zeros(n + self.further),
            np.zeros(self.further),
            np.zeros((len(times) * count, self.stagewise)),
        )
        table = table_of(rows_of(self._problem), rows_of(back))
        python = self._python or bool(self._work.callbacks)
        function_of("step_back", python)(self._work.table_address, address(table))
        adjoint_before = adjoints[count * length : count * length + n].copy()
        if back.words[at.BACK_WRONG] >= 0:
            adjoint_before[:] = np.nan
        instants = times[:, None] + np.outer(sizes, self.nodes)
        # Steps end where inputs jump, with what these were before.
        jumps, before, _ = self._work.problem.jumps.T
        until = np.append(before, np.inf)[np.searchsorted(jumps, times, side="right")]
        instants = np.minimum(instants, until[:, None]).ravel()
        return AdjointSweep(adjoint_before, back.totals, instants, back.kept)
