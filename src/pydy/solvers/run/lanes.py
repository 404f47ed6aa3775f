"""Integrations of many samples from Python's side: arrays for the stepper of lanes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from time import perf_counter
from typing import Any

import numpy as np

from pydy._array_layout import address
from pydy._kernel import Kernel
from pydy.solvers.options import Options
from pydy.solvers.outcome import NOT_COMPUTED
from pydy.solvers.run import layout as at
from pydy.solvers.run.integration import SLICE
from pydy.solvers.run.layout import (
    Evaluation,
    Holding,
    LaneProblem,
    Lanes,
    Queue,
    rows_of,
    table_of,
)
from pydy.solvers.run.problem import lined_up, tables_of
from pydy.solvers.run.shipped import function_of
from pydy.solvers.run.workspace import Workspace, memory_for
from pydy.solvers.tableaus import method_arrays
from pydy.solvers.tuning import LANES, LEAST_TOLERANCE

_NOT_HELD = Holding(
    np.zeros(2, dtype=np.int64), np.zeros(0, dtype=np.int64), np.zeros(0), np.zeros((0, 0))
)


class HeldLanes:
    """Lanes that are held on their constraints, one after another.

    Each has the arrays of the `workspace` of one trajectory, but for inputs and what is noted of
    the constraints, which are its own. The rows of `seen` are what was noted of each sample at its
    beginning, and then at its end.
    """

    def __init__(self, workspace: Workspace, seen: np.ndarray) -> None:
        problem, constraints = workspace.problem, workspace.constraints
        wanted = workspace.options.constraints
        assert wanted is not None
        assert wanted.kernel.addresses is not None
        self._arrays = [
            (
                problem._replace(r=problem.r.copy()),
                constraints._replace(c=constraints.c.copy(), values=constraints.values.copy()),
            )
            for _ in range(LANES)
        ]
        self._tables = [workspace.table_with(*pair) for pair in self._arrays]
        place = len(constraints.values) - len(workspace.seen)
        self.holding = Holding(
            words=np.array([wanted.kernel.addresses[1], place]),
            runs=np.array([address(table) for table in self._tables]),
            state=np.zeros(workspace.memory.x.shape),
            seen=seen,
        )
        self._workspace = workspace  # which compiled code goes on using

    def nearness(self) -> np.ndarray:
        """Return how near the constraints of each sample came to losing rank."""
        seen = self.holding.seen
        return np.where(seen[:, at.RANK] != 0.0, seen[:, at.NEARNESS], 1.0)


def integrate_samples(
    kernel: Kernel,
    method: str,
    x: np.ndarray,
    r: np.ndarray,
    p: np.ndarray,
    sampled: Sequence[tuple[np.ndarray, Any]],
    times: np.ndarray,
    options: Options,
    states: np.ndarray,
    stopped: Callable[[], bool] = lambda: False,
    controlled: int | None = None,
    held: HeldLanes | None = None,
) -> tuple[np.ndarray, np.ndarray]:
    """Integrate m samples, `LANES` at a time, by an explicit method.

    The inputs x, r and p have a row for each, and `sampled` is data in time with its places in r,
    the same for all. The states go to (n, m, times), NaN from where a sample failed: those of one
    sample lie side by side, and the next sample's follow. The error is controlled of all
    components, or of so many that come first. Motions may be `held` on constraints, which their
    beginnings satisfy; those that begin with NaN are left out, as not computed. Asked now and then
    whether the work is `stopped`, True ends it with KeyboardInterrupt.

    Returned are `Queue.counts` and the times up to which each sample was integrated.
    """
    step_lanes = function_of("step_lanes")
    m, n = x.shape
    length = LANES * n
    controlled = controlled or n
    arrays = method_arrays(method, length)
    memory, memory_rows = memory_for(arrays, length)
    memory.rtol[:n], memory.rtol[:controlled] = 1.0, options.rtol
    memory.atol[:n], memory.atol[:controlled] = 1.0, np.maximum(options.atol, LEAST_TOLERANCE)
    lanes = Lanes(*lined_up(len(Lanes._fields), LANES))._replace(
        samples=np.full(LANES, at.LANES_VACANT), place=np.zeros(LANES, dtype=np.int64)
    )
    queue = Queue(
        state=np.array([0, 0, options.max_steps, address(states), states.strides[0] // 8]),
        numbers=np.array([options.max_step, options.first_step or options.step or 0.0]),
        times=np.append(times, np.inf),
        x=np.ascontiguousarray(x),
        r=np.ascontiguousarray(r),
        p=np.ascontiguousarray(p),
        counts=np.zeros((m, 4), dtype=np.int64),
        reached=np.full(m, times[0]),
    )
    if held is not None:
        out = np.isnan(x).any(axis=1)
        queue.counts[out, at.LANES_STATUS], states[:, out] = NOT_COMPUTED, np.nan
    problem = _problem(kernel, sampled, controlled)
    holding = _NOT_HELD if held is None else held.holding
    parts = (rows_of(arrays), rows_of(problem), memory_rows, rows_of(lanes), rows_of(queue))
    table = table_of(*parts, rows_of(holding))
    budget = 1000
    while True:
        queue.state[at.LANES_BUDGET] = budget
        start = perf_counter()
        code = step_lanes(address(table))
        if code == at.LANES_EMPTY:
            return queue.counts, queue.reached
        if stopped():
            raise KeyboardInterrupt
        elapsed = max(perf_counter() - start, np.finfo(float).tiny)
        budget = int(min(max(1.0, budget * SLICE / elapsed), 4.0 * budget))


def evaluate_samples(
    kernel: Kernel,
    r: np.ndarray,
    p: np.ndarray,
    sampled: Sequence[tuple[np.ndarray, Any]],
    times: np.ndarray,
    states: np.ndarray,
) -> np.ndarray:
    """Evaluate a Kernel of `LANES` lanes along trajectories, shape (outputs, m, times).

    The parameters are those of `integrate_samples`.
    """
    n, m, number = states.shape
    out = np.empty((len(kernel.program.outputs), m, number))
    if out.size:
        evaluation = Evaluation(
            places=np.array([address(states), *(step // 8 for step in states.strides)]),
            x=lined_up(max(1, n) * LANES),
            buffer=lined_up(len(out) * LANES),
            r=np.ascontiguousarray(r),
            p=np.ascontiguousarray(p),
            times=np.ascontiguousarray(times),
            out=out.ravel(),
        )
        problem = _problem(kernel, sampled)
        table = table_of(rows_of(problem), rows_of(evaluation))
        function_of("evaluate_lanes")(address(table))
    return out


def _problem(
    kernel: Kernel, sampled: Sequence[tuple[np.ndarray, Any]], controlled: int = 0
) -> LaneProblem:
    program, addresses = kernel.program, kernel.addresses
    assert addresses is not None
    assert kernel.lanes == LANES
    n, inputs = program.num_states, (program.num_specifieds, program.num_constants)
    tables, knots, cubics = tables_of(sampled)

    return LaneProblem(
        words=np.array([addresses[0], n, n, controlled, controlled, addresses[1], *inputs]),
        clock=lined_up(LANES),
        r=lined_up(LANES * max(1, program.num_specifieds)),
        p=lined_up(LANES * max(1, program.num_constants)),
        c=lined_up(LANES * max(1, len(program.carried))),
        tables=np.ascontiguousarray(tables[:, :3]),
        intervals=np.zeros((len(tables), LANES), dtype=np.int64),
        knots=knots,
        cubics=cubics,
    )
