"""The integration of many samples side by side: arrays for the stepper of lanes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import TYPE_CHECKING, ClassVar, TypeAlias

import numpy as np

from pydy._array_layout import address
from pydy._kernel import Kernel
from pydy.inputs import jumps_of, merged_jumps
from pydy.solvers import layout as at
from pydy.solvers.constraints import CompiledConstraints
from pydy.solvers.layout import (
    Alone,
    Evaluation,
    LaneProblem,
    Lanes,
    LaneWatch,
    Queue,
    rows_of,
    table_of,
)
from pydy.solvers.options import Options
from pydy.solvers.outcome import Outcome
from pydy.solvers.run.departure import on_surface
from pydy.solvers.run.integration import SLICE
from pydy.solvers.run.problem import NO_JUMPS, aligned_zeros, sampled_input_tables
from pydy.solvers.run.shipped import function_of
from pydy.solvers.run.workspace import (
    NO_CONSTRAINTS,
    Workspace,
    constraints_for,
    memory_for,
    newton_for,
    projection_record_size,
)
from pydy.solvers.tableaus import method_arrays
from pydy.solvers.tuning import LANES, LARGEST_IN_LANES, LEAST_TOLERANCE, ROUNDING, STARTING_MOVE

if TYPE_CHECKING:
    from pydy._program import Program
    from pydy.inputs import SampledInput

SampledInputs: TypeAlias = "Sequence[tuple[np.ndarray, SampledInput]]"
"""Sampled inputs, each with its columns in r."""

_NO_RUNS = Alone(np.zeros(0, dtype=np.int64), np.zeros((0, 1), dtype=np.int64))
_NO_EVENTS = LaneWatch(*[np.zeros(0)] * len(LaneWatch._fields))._replace(
    words=np.zeros(at.LANES_LOGGED + 1, dtype=np.int64)
)


class LaneTasks:
    """Constraints and events of m samples that are integrated in lanes: here neither, or both.

    Each sample has a row of `seen`, the record of its projections.
    """

    alone, watch, constraints = _NO_RUNS, _NO_EVENTS, NO_CONSTRAINTS
    _compiled: CompiledConstraints | None = None

    def __init__(self, m: int) -> None:
        self.projection_record, self.prepared = np.zeros((m, 0)), list[tuple[int, int]]()

    @staticmethod
    def with_events(
        workspace: Workspace,
        samples: tuple[np.ndarray, np.ndarray, SampledInputs],
        times: np.ndarray,
        kernel: Callable[[Program], Kernel],
        logs: bool,
    ) -> LaneTasks:
        """Return tasks that detect events, and record them where `logs` is True.

        The `workspace` is that of one sample alone. The `samples` are the inputs r and p, with a
        row for each, and sampled data with their columns in r. `kernel` compiles Programs for
        lanes.
        """
        return _EventTasks(workspace, samples, times, kernel, logs)

    def add_constraints(self, compiled: CompiledConstraints, kernel: Kernel) -> None:
        """Project motions onto constraints; the `kernel` is the one compiled for lanes."""
        n, (address_slot, c, prepared) = kernel.program.signature.num_states, _bound(kernel)
        self.constraints, self._scratch = constraints_for(
            compiled, "project_lanes", (address_slot, c), n, LANES
        )
        self.projection_record, self._compiled = (
            np.zeros((len(self.projection_record), projection_record_size(compiled, n))),
            compiled,
        )
        self.prepared += prepared

    def begin(self, x: np.ndarray, span: float, table: int) -> None:
        """Project initial states (m, n) onto their constraints, with the table at an address.

        They become NaN if a motion cannot begin: the solver of single trajectories reports why.
        """
        if self._compiled is not None:
            before = x.copy()
            function_of("begin_lanes")(table)
            x[(self._compiled.relative_change(before, x, span) > STARTING_MOVE).any(axis=1)] = (
                np.nan
            )

    def nearness(self) -> np.ndarray:
        """Return how near the constraints of each sample came to losing rank."""
        if self._compiled is None:
            return np.ones(len(self.projection_record))
        return np.where(
            self.projection_record[:, at.RANK] != 0.0, self.projection_record[:, at.NEARNESS], 1.0
        )

    def empty_log(self) -> None:
        """Copy the events that compiled code has recorded."""

    def ended(self, status: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return which samples need nothing more, from the states (n, m, 1) at the last time."""
        return np.asarray(status == Outcome.FINISHED)

    def event_warnings(self, samples: np.ndarray) -> list[str]:
        """Return warnings of expressions that stayed at zero in some samples."""
        return []

    def records(self) -> tuple[np.ndarray, ...]:
        """Return the recorded events as columns, the events of a sample adjacent and in order.

        The columns are samples, times, numbers of events, and the states before and after. There
        are none if nothing is recorded.
        """
        return ()


_NO_TASKS = LaneTasks(0)


class _EventTasks(LaneTasks):
    """Lanes that detect events, and act on them one lane at a time, as single trajectories do.

    Each lane has a copy of the arrays of the workspace of one trajectory, with its own inputs and
    its own record of events.
    """

    def __init__(
        self,
        workspace: Workspace,
        samples: tuple[np.ndarray, np.ndarray, SampledInputs],
        times: np.ndarray,
        kernel: Callable[[Program], Kernel],
        logs: bool,
    ) -> None:
        events = workspace.options.events
        assert events is not None
        super().__init__(len(samples[0]))
        self._copies, runs, prepared = workspace.lane_copies(LANES)
        self.alone = Alone(runs, prepared)
        self._workspace = workspace  # its memory is used by compiled code
        self._events, self._times, self._samples, self._logs = events, times, samples, logs
        self._kernels = kernel(events.values.program), kernel(events.rates.program)
        self._input_rates: Kernel | None = None
        if events.input_rates is not None and samples[2]:
            self._input_rates = kernel(events.input_rates.program)
        self._log: list[tuple[np.ndarray, ...]] = []
        self._reach = None
        if workspace.watch.words[at.REACHER] != 0 and events.reach is not None:
            self._reach = kernel(events.reach.program)
        self.watch = self._watch(workspace)

    def _watch(self, workspace: Workspace) -> LaneWatch:
        single, m, n = workspace.watch, len(self.projection_record), workspace.n
        number, words = len(self._events.traits), np.append(single.words, 0)
        words[at.WATCHER], c, self.prepared = _bound(self._kernels[0])
        reach_c = np.zeros(0)
        if self._reach is not None:
            words[at.REACHER], reach_c, prepared = _bound(self._reach)
            self.prepared += prepared
        program = self._kernels[0].program if self._reach is None else self._reach.program
        nodes = zip(program.ops, program.args, strict=True)
        inputs = {
            args[1] - single.words[at.MOVES]
            for op, args in nodes
            if (op, *args[:1]) == ("input", "r")
        }
        moving = sorted(inputs & {*range(single.words[at.MOVING])})
        rows = 4 * LANES * (1 + len(single.log_times)) if self._logs else 0
        return LaneWatch(
            words=words,
            c=c,
            reach=aligned_zeros(LANES * len(single.reach)),
            reach_c=reach_c,
            moving=np.array(moving, dtype=np.int64),
            ends=aligned_zeros(LANES * (at.PARTS + 1) * number),
            further=aligned_zeros(LANES * 2 * number),
            sides=aligned_zeros(LANES * number),
            known=aligned_zeros(LANES),
            began=np.zeros((m, number), dtype=np.int64),
            first=np.zeros((m, number)),
            rests=np.full((m, 2 * number), np.nan),
            log_samples=np.zeros(rows, dtype=np.int64),
            log_times=np.zeros(rows),
            log_events=np.zeros(rows, dtype=np.int64),
            log_states=np.zeros((rows, n)),
            log_after=np.zeros((rows, n)),
        )

    def begin(self, x: np.ndarray, span: float, table: int) -> None:
        """Also find the signs of events."""
        super().begin(x, span, table)
        values, rates, bounds = self._values_at(x.T[:, :, None], float(self._times[0]))
        on = on_surface(values, bounds)
        signed = np.where(on, rates, values)
        self.watch.began[:] = sides = np.sign(np.where(np.isfinite(signed), signed, 0.0))
        directions = np.array([event.direction for event in self._events.traits])
        self._zero = on & ((directions == 0) | (directions == sides))
        # Where an event acts, or the rate is zero, the solver of single trajectories is needed.
        acts = self._zero & (np.array(self._workspace.watch.acting) == 1)
        x[(acts | on & (rates == 0.0)).any(axis=1)] = np.nan
        self._x = x
        self.watch.first[:] = np.where(self._zero, self._times[0], -np.inf)

    def _values_at(self, states: np.ndarray, t: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the events' expressions, rates and bounds on roundings, each (m, events).

        The states (n, m, 1) are those at a time.
        """
        r, p, sampled = self._samples
        r = r.copy()
        for columns, data in sampled:
            r[:, columns] = data.at(t)
        states, times = np.ascontiguousarray(states), np.array([t])
        values, rates = (
            LaneSolver.evaluate(k, r, p, (), times, states)[..., 0].T for k in self._kernels
        )
        number = values.shape[1]
        rates, bounds = rates[:, :number], rates[:, number : 2 * number]
        if (kernel := self._input_rates) is not None:  # as `CompiledEvents.rates_at`
            slopes = np.zeros_like(r)
            for columns, data in sampled:
                slopes[:, columns] = data.slopes_at(t)
            s = kernel.program.signature.num_specifieds // 2
            both = np.concatenate([r[:, :s], slopes[:, :s]], axis=1)
            rates = rates + LaneSolver.evaluate(kernel, both, p, (), times, states)[..., 0].T
        return values, rates, bounds

    def empty_log(self) -> None:
        """Copy the events that compiled code has recorded."""
        watch = self.watch
        if number := int(watch.words[at.LANES_LOGGED]):
            columns = watch[LaneWatch._fields.index("log_samples") :]
            self._log.append(tuple(column[:number].copy() for column in columns))
            watch.words[at.LANES_LOGGED] = 0

    def ended(self, status: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the same, without samples with an event at the last time, which needs Python."""
        values, rates, _ = self._values_at(states, t := float(self._times[-1]))
        sides = self.watch.began
        with np.errstate(invalid="ignore"):  # infinite values without a side
            signed_values, signed_rates = values * sides, rates * sides
        near = 2.0 * ROUNDING * abs(t) * np.abs(rates)
        reaches = ((values == 0.0) & ~(signed_rates > 0.0)) | (
            (signed_rates < 0.0) & (signed_values >= 0.0) & (signed_values <= near)
        )
        directions = np.array([event.direction for event in self._events.traits])
        fired = reaches & (sides != 0) & (sides != directions)
        done = super().ended(status, states) & ~fired.any(axis=1)
        return np.asarray(
            done | (status == Outcome.TERMINATED) | (status == Outcome.EVENTS_ACCUMULATE)
        )

    def event_warnings(self, samples: np.ndarray) -> list[str]:
        """Return warnings of expressions that stayed at zero in some samples."""
        span, intervals = float(self._times[-1] - self._times[0]), self.watch.rests[samples]
        rows = intervals[~np.isnan(intervals).all(axis=1)]
        return [w for row in rows for w in self._events.zero_interval_warnings(row, span)]

    def records(self) -> tuple[np.ndarray, ...]:
        """Return the recorded events as columns, as arrays: Python objects would cost a fifth."""
        if not self._logs:
            return ()
        samples, events = np.argwhere(self._zero).T
        x = self._x[samples]
        at_start = samples, np.full(len(samples), float(self._times[0])), events, x, x
        columns = [np.concatenate(parts) for parts in zip(at_start, *self._log, strict=True)]
        order = np.argsort(columns[0], kind="stable")  # a sample records its events in order
        return tuple(column[order] for column in columns)


@dataclass(frozen=True, eq=False)
class LaneSolver:
    """Integrates many samples of one model, `LANES` at a time.

    The Kernels are compiled for lanes.
    """

    LANES: ClassVar[int] = LANES
    MOST_IMPLICIT_STATES: ClassVar[int] = LARGEST_IN_LANES

    kernel: Kernel  # the states' derivatives
    method: str
    options: Options
    sampled: SampledInputs = ()  # sampled data with their columns in r, the same for all samples
    jacobian: Kernel | None = None  # of an implicit method
    # The rows say when the Kernel switches by time alone, in all samples alike.
    switched: np.ndarray | None = None

    def integrate(
        self,
        samples: tuple[np.ndarray, np.ndarray, np.ndarray],
        times: np.ndarray,
        states: np.ndarray,
        stopped: Callable[[], bool] = lambda: False,
        bounds: tuple[np.ndarray, np.ndarray] | None = None,
        tasks: LaneTasks | None = None,
    ) -> tuple[np.ndarray, np.ndarray]:
        """Integrate m samples, the inputs x, r and p with a row for each.

        The states are written to (n, m, times), NaN from where a sample failed: those of one
        sample are adjacent in memory, and the next sample's follow. The error is controlled of all
        components but the last ones, whose error `bounds` the step: these have relative tolerances
        (b,) and absolute ones (m, b). The `tasks` are constraints and events; samples that cannot
        begin with them are left out as not computed. If `stopped`, which is called now and then,
        returns True, KeyboardInterrupt is raised.

        Returned are `Queue.counts` and the times up to which each sample was integrated.
        """
        entry = "step_lanes" if self.jacobian is None else "step_lanes_implicit"
        (x, r, p), options, step_lanes = samples, self.options, function_of(entry)
        m, n = x.shape
        length = LANES * n
        relative, absolute = bounds or (np.zeros(0), np.zeros((m, 0)))
        controlled = n - len(relative)
        arrays = method_arrays(self.method, length)
        memory, memory_rows = memory_for(arrays, length)
        memory.rtol[:controlled], memory.rtol[controlled:n] = options.rtol, relative
        memory.atol[:controlled] = np.maximum(options.atol, LEAST_TOLERANCE)
        lanes = Lanes(*aligned_zeros(len(Lanes._fields), LANES))._replace(
            samples=np.full(LANES, at.LANES_VACANT), place=np.zeros(LANES, dtype=np.int64)
        )
        done = _NO_TASKS if tasks is None else tasks
        queue = Queue(
            state=np.array([0, 0, options.max_steps, address(states), states.strides[0] // 8]),
            numbers=np.array([options.max_step, options.first_step or options.step or 0.0]),
            times=np.append(times, np.inf),
            x=np.array(x, order="C"),
            r=np.ascontiguousarray(r),
            p=np.ascontiguousarray(p),
            bounds=np.maximum(absolute, LEAST_TOLERANCE),
            counts=np.zeros((m, 4), dtype=np.int64),
            reached=np.full(m, times[0]),
            seen=done.projection_record,
        )
        newton, prepared = ((), []) if self.jacobian is None else _newton(n, self.jacobian)
        problem = _problem(
            self.kernel, self.sampled, len(relative), [*done.prepared, *prepared], self.switched
        )
        parts = (rows_of(arrays), rows_of(problem), memory_rows, rows_of(lanes), rows_of(queue))
        task_rows = rows_of(done.alone), rows_of(done.watch), rows_of(done.constraints)
        table = table_of(*parts, *task_rows, rows_of(newton))
        if tasks is not None:
            tasks.begin(queue.x, float(times[-1] - times[0]), address(table))
            excluded = np.isnan(queue.x).any(axis=1)
            queue.counts[excluded, at.LANES_STATUS] = Outcome.NOT_COMPUTED
            states[:, excluded] = np.nan
        budget = 1000
        while True:
            queue.state[at.LANES_BUDGET] = budget
            start = perf_counter()
            code = step_lanes(address(table))
            if tasks is not None:
                tasks.empty_log()
            if code == at.LANES_EMPTY:
                return queue.counts, queue.reached
            if stopped():
                raise KeyboardInterrupt
            elapsed = max(perf_counter() - start, np.finfo(float).tiny)
            steps = budget - queue.state[at.LANES_BUDGET]
            budget = int(min(max(1.0, steps * SLICE / elapsed), 4.0 * budget))

    @staticmethod
    def evaluate(
        kernel: Kernel,
        r: np.ndarray,
        p: np.ndarray,
        sampled: SampledInputs,
        times: np.ndarray,
        states: np.ndarray,
    ) -> np.ndarray:
        """Evaluate a Kernel for lanes along trajectories (n, m, times): (outputs, m, times)."""
        n, m, number = states.shape
        out = np.empty((kernel.program.signature.num_outputs, m, number))
        if out.size:
            evaluation = Evaluation(
                places=np.array([address(states), *(step // 8 for step in states.strides)]),
                x=aligned_zeros(max(1, n) * LANES),
                buffer=aligned_zeros(len(out) * LANES),
                r=np.ascontiguousarray(r),
                p=np.ascontiguousarray(p),
                times=np.ascontiguousarray(times),
                out=out.ravel(),
            )
            problem = _problem(kernel, sampled)
            table = table_of(rows_of(problem), rows_of(evaluation))
            function_of("evaluate_lanes")(address(table))
        return out


def _newton(n: int, jacobian: Kernel) -> tuple[Sequence[np.ndarray], list[tuple[int, int]]]:
    """Return the arrays of an implicit step of n states, and the preparation of its constants."""
    address_slot, c, prepared = _bound(jacobian)
    newton = newton_for(n, n, LANES)._replace(c=c)
    newton.words[at.GRADIENT] = address_slot
    return newton, prepared


def _bound(kernel: Kernel) -> tuple[int, np.ndarray, list[tuple[int, int]]]:
    """Return the address of a Kernel for lanes, its constants, and their preparation."""
    addresses = kernel.addresses
    assert addresses is not None
    assert kernel.lanes == LANES
    c = aligned_zeros(LANES * max(1, len(kernel.program.carried)))
    address_slot = address(addresses)
    return address_slot, c, [(address_slot + 8, address(c))]


def _problem(
    kernel: Kernel,
    sampled: SampledInputs,
    bounded: int = 0,
    further_prepared: Sequence[tuple[int, int]] = (),
    switched: np.ndarray | None = None,
) -> LaneProblem:
    program, (address_slot, c, prepared) = kernel.program, _bound(kernel)
    signature = program.signature
    n, s, k = signature.num_states, signature.num_specifieds, signature.num_constants
    tables, knots, cubics = sampled_input_tables(sampled)
    until = aligned_zeros(LANES)
    until[:] = np.inf
    jumps = jumps_of(sampled) if sampled else NO_JUMPS
    if switched is not None:
        jumps = merged_jumps([jumps, switched])
    switches = 0 if switched is None else len(switched)
    return LaneProblem(
        words=np.array([address_slot, n, n, n - bounded, n, switches, n if bounded else 0, s, k]),
        clock=aligned_zeros(LANES),
        r=aligned_zeros(LANES * max(1, s)),
        p=aligned_zeros(LANES * max(1, k)),
        c=c,
        prepared=np.array([*prepared, *further_prepared]),
        tables=np.ascontiguousarray(tables[:, :3]),
        intervals=np.zeros((len(tables), LANES), dtype=np.int64),
        knots=knots,
        cubics=cubics,
        jumps=jumps,
        until=until,
    )
