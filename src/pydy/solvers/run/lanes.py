"""Integrations of many samples from Python's side: arrays for the stepper of lanes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from time import perf_counter
from typing import Any

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
from pydy.solvers.run.problem import NO_JUMPS, lined_up, tables_of
from pydy.solvers.run.shipped import function_of
from pydy.solvers.run.workspace import (
    NO_CONSTRAINTS,
    Workspace,
    constraints_for,
    memory_for,
    newton_for,
    seen_of,
)
from pydy.solvers.tableaus import method_arrays
from pydy.solvers.tuning import LANES, LEAST_TOLERANCE, ROUNDING, STARTING_MOVE
from pydy.trajectory import EventRecord

_NO_ONE = Alone(np.zeros(0, dtype=np.int64), np.zeros((0, 1), dtype=np.int64))
_NO_EVENTS = LaneWatch(*[np.zeros(0)] * len(LaneWatch._fields))._replace(
    words=np.zeros(at.LANES_LOGGED + 1, dtype=np.int64)
)


class LanesBeside:
    """What m lanes have to do beside the motions of their samples: here nothing, or to hold them.

    Each sample has a row of `seen`, what was noted of its projections.
    """

    alone, watch, held = _NO_ONE, _NO_EVENTS, NO_CONSTRAINTS
    _wanted: CompiledConstraints | None = None

    def __init__(self, m: int) -> None:
        self.seen, self.prepared = np.zeros((m, 0)), list[tuple[int, int]]()

    def hold(self, wanted: CompiledConstraints, kernel: Kernel) -> None:
        """Hold motions on constraints, of which the `kernel` is that for lanes."""
        n, (place, c, prepared) = kernel.program.num_states, _bound(kernel)
        self.held, self._scratch = constraints_for(wanted, "project_lanes", (place, c), n, LANES)
        self.seen, self._wanted = np.zeros((len(self.seen), seen_of(wanted, n))), wanted
        self.prepared += prepared

    def begin(self, x: np.ndarray, span: float, place: int) -> None:
        """Move states (m, n) onto their constraints, with a table at some place.

        NaN where a motion cannot begin: the solver of single trajectories tells why.
        """
        if self._wanted is not None:
            before = x.copy()
            function_of("begin_lanes")(place)
            x[(self._wanted.moved(before, x, span) > STARTING_MOVE).any(axis=1)] = np.nan

    def nearness(self) -> np.ndarray:
        """Return how near the constraints of each sample came to losing rank."""
        if self._wanted is None:
            return np.ones(len(self.seen))
        return np.where(self.seen[:, at.RANK] != 0.0, self.seen[:, at.NEARNESS], 1.0)

    def look(self) -> None:
        """Do what compiled code leaves to Python now and then."""

    def ended(self, status: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return which samples have ended well, with states (n, m, 1) at the last time."""
        return np.asarray(status == Outcome.FINISHED)

    def stretches(self, samples: np.ndarray) -> list[str]:
        """Return what to say of expressions that stayed at zero in some samples."""
        return []

    def records(self) -> dict[int, list[EventRecord]]:
        """Return the events of each sample."""
        return {}


_NOTHING = LanesBeside(0)


class LanesWatched(LanesBeside):
    """Lanes that look for events, and do some of that one after another, as single trajectories do.

    Each has the arrays of the `workspace` of one trajectory, but for inputs and what is noted of
    events, which are its own. `logs` tells whether events are noted.

    The `samples` are the inputs r and p, with a row for each, and data in time with their places in
    r. `kernel` compiles Programs for lanes.
    """

    def __init__(
        self,
        workspace: Workspace,
        samples: tuple[np.ndarray, np.ndarray, Sequence[tuple[np.ndarray, Any]]],
        times: np.ndarray,
        kernel: Callable[[Any], Kernel],
        logs: bool,
    ) -> None:
        events = workspace.options.events
        assert events is not None
        super().__init__(len(samples[0]))
        self._own, runs, prepared = workspace.alone(LANES)
        self.alone = Alone(runs, prepared)
        self._workspace = workspace  # which compiled code goes on using
        self._events, self._times, self._samples, self._logs = events, times, samples, logs
        self._kernels = kernel(events.values.program), kernel(events.rates.program)
        self._taken: list[tuple[np.ndarray, ...]] = []
        self._far = None
        if workspace.watch.words[at.REACHER] != 0 and events.reach is not None:
            self._far = kernel(events.reach.program)
        self.watch = self._watch(workspace)

    def _watch(self, workspace: Workspace) -> LaneWatch:
        own, m, n, number = workspace.watch, len(self.seen), workspace.n, len(self._events.names)
        words = np.append(own.words, 0)
        words[at.WATCHER], c, self.prepared = _bound(self._kernels[0])
        reach_c = np.zeros(0)
        if self._far is not None:
            words[at.REACHER], reach_c, further = _bound(self._far)
            self.prepared += further
        program = self._kernels[0].program if self._far is None else self._far.program
        nodes = zip(program.ops, program.args, strict=True)
        inputs = {
            args[1] - own.words[at.MOVES] for op, args in nodes if (op, *args[:1]) == ("input", "r")
        }
        moving = sorted(inputs & {*range(own.words[at.MOVING])})
        rows = 4 * LANES * (1 + len(own.log_times)) if self._logs else 0
        return LaneWatch(
            words=words,
            c=c,
            reach=lined_up(LANES * len(own.reach)),
            reach_c=reach_c,
            moving=np.array(moving, dtype=np.int64),
            ends=lined_up(LANES * (at.PARTS + 1) * number),
            further=lined_up(LANES * 2 * number),
            sides=lined_up(LANES * number),
            known=lined_up(LANES),
            began=np.zeros((m, number), dtype=np.int64),
            first=np.zeros((m, number)),
            rests=np.full((m, 2 * number), np.nan),
            log_samples=np.zeros(rows, dtype=np.int64),
            log_times=np.zeros(rows),
            log_events=np.zeros(rows, dtype=np.int64),
            log_states=np.zeros((rows, n)),
            log_after=np.zeros((rows, n)),
        )

    def begin(self, x: np.ndarray, span: float, place: int) -> None:
        """Also find the signs of events."""
        super().begin(x, span, place)
        values, rates, bounds = self._at(x.T[:, :, None], float(self._times[0]))
        on = on_surface(values, bounds)
        told = np.where(on, rates, values)
        self.watch.began[:] = sides = np.sign(np.where(np.isfinite(told), told, 0.0))
        wanted = np.array(self._events.directions)
        self._zero = on & ((wanted == 0) | (wanted == sides))
        # The solver of single trajectories acts, and finds the side where the rate is zero.
        alone = self._zero & (np.array(self._workspace.watch.acting) == 1) | on & (rates == 0.0)
        x[alone.any(axis=1)] = np.nan
        self._x = x
        self.watch.first[:] = np.where(self._zero, self._times[0], -np.inf)

    def _at(self, states: np.ndarray, t: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the events' expressions, their rates and bounds on their roundings, each (m, ·).

        The states (n, m, 1) are those at a time.
        """
        r, p, sampled = self._samples
        r = r.copy()
        for columns, data in sampled:
            r[:, columns] = data.at(t)
        states, times = np.ascontiguousarray(states), np.array([t])
        found = [evaluate_samples(k, r, p, (), times, states)[..., 0].T for k in self._kernels]
        number = found[0].shape[1]
        return found[0], found[1][:, :number], found[1][:, number : 2 * number]

    def look(self) -> None:
        """Empty the log."""
        watch = self.watch
        if number := int(watch.words[at.LANES_LOGGED]):
            log = watch[LaneWatch._fields.index("log_samples") :]
            self._taken.append(tuple(part[:number].copy() for part in log))
            watch.words[at.LANES_LOGGED] = 0

    def ended(self, status: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the same, but for samples with an event at the last time, which needs Python."""
        values, rates, _ = self._at(states, t := float(self._times[-1]))
        sides = self.watch.began
        with np.errstate(invalid="ignore"):  # infinite values without a side
            ahead, away = values * sides, rates * sides
        near = 2.0 * ROUNDING * abs(t) * np.abs(rates)
        reaches = ((values == 0.0) & ~(away > 0.0)) | (
            (away < 0.0) & (ahead >= 0.0) & (ahead <= near)
        )
        fired = reaches & (sides != 0) & (sides != np.array(self._events.directions))
        done = super().ended(status, states) & ~fired.any(axis=1)
        return np.asarray(
            done | (status == Outcome.TERMINATED) | (status == Outcome.EVENTS_ACCUMULATE)
        )

    def stretches(self, samples: np.ndarray) -> list[str]:
        """Return what to say of expressions that stayed at zero in some samples."""
        span, rests = float(self._times[-1] - self._times[0]), self.watch.rests[samples]
        rows = rests[~np.isnan(rests).all(axis=1)]
        return [w for row in rows for w in self._events.zero_interval_warnings(row, span)]

    def records(self) -> dict[int, list[EventRecord]]:
        """Return the events of each sample, if they were noted."""
        found: dict[int, list[EventRecord]] = {k: [] for k in range(len(self._zero))}
        t, names = float(self._times[0]), self._events.names
        if not self._logs:
            return {}
        for k, event in np.argwhere(self._zero).tolist():
            x = self._x[k]
            found[k].append(EventRecord(t, names[event], event, x.copy(), x.copy()))
        for part in self._taken:
            samples, times, events = (column.tolist() for column in part[:3])
            for k, t, event, x, after in zip(samples, times, events, *part[3:], strict=True):
                found[k].append(EventRecord(t, names[event], event, x, after))
        return found


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
    bounds: tuple[np.ndarray, np.ndarray] | None = None,
    beside: LanesBeside | None = None,
    jacobian: Kernel | None = None,
    switched: np.ndarray | None = None,
) -> tuple[np.ndarray, np.ndarray]:
    """Integrate m samples, `LANES` at a time; an implicit method needs the `jacobian`.

    The inputs x, r and p have a row for each, and `sampled` is data in time with its places in r,
    the same for all. The states go to (n, m, times), NaN from where a sample failed: those of one
    sample lie side by side, and the next sample's follow. The error is controlled of all
    components but the last, whose error `bounds` the step: they have relative tolerances (b,) and
    absolute ones (m, b). Motions may be held on constraints and watched for events, by what is
    `beside`; those that cannot begin are left out then, as not computed. Asked now and then whether
    the work is `stopped`, True ends it with KeyboardInterrupt. The rows of `switched` say when the
    Kernel switches by time alone, in all samples alike.

    Returned are `Queue.counts` and the times up to which each sample was integrated.
    """
    step_lanes = function_of("step_lanes" if jacobian is None else "step_lanes_implicit")
    m, n = x.shape
    length = LANES * n
    relative, absolute = bounds or (np.zeros(0), np.zeros((m, 0)))
    controlled = n - len(relative)
    arrays = method_arrays(method, length)
    memory, memory_rows = memory_for(arrays, length)
    memory.rtol[:controlled], memory.rtol[controlled:n] = options.rtol, relative
    memory.atol[:controlled] = np.maximum(options.atol, LEAST_TOLERANCE)
    lanes = Lanes(*lined_up(len(Lanes._fields), LANES))._replace(
        samples=np.full(LANES, at.LANES_VACANT), place=np.zeros(LANES, dtype=np.int64)
    )
    own = beside or _NOTHING
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
        seen=own.seen,
    )
    newton, further = ((), []) if jacobian is None else _newton(n, jacobian)
    problem = _problem(kernel, sampled, len(relative), [*own.prepared, *further], switched)
    parts = (rows_of(arrays), rows_of(problem), memory_rows, rows_of(lanes), rows_of(queue))
    beside_rows = rows_of(own.alone), rows_of(own.watch), rows_of(own.held)
    table = table_of(*parts, *beside_rows, rows_of(newton))
    if beside is not None:
        beside.begin(queue.x, float(times[-1] - times[0]), address(table))
        out = np.isnan(queue.x).any(axis=1)
        queue.counts[out, at.LANES_STATUS], states[:, out] = Outcome.NOT_COMPUTED, np.nan
    budget = 1000
    while True:
        queue.state[at.LANES_BUDGET] = budget
        start = perf_counter()
        code = step_lanes(address(table))
        if beside is not None:
            beside.look()
        if code == at.LANES_EMPTY:
            return queue.counts, queue.reached
        if stopped():
            raise KeyboardInterrupt
        elapsed = max(perf_counter() - start, np.finfo(float).tiny)
        taken = budget - queue.state[at.LANES_BUDGET]
        budget = int(min(max(1.0, taken * SLICE / elapsed), 4.0 * budget))


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


def _newton(n: int, jacobian: Kernel) -> tuple[Sequence[np.ndarray], list[tuple[int, int]]]:
    """Return the arrays of an implicit step of n states, and what prepares its constants."""
    place, c, prepared = _bound(jacobian)
    newton = newton_for(n, n, LANES)._replace(c=c)
    newton.words[at.GRADIENT] = place
    return newton, prepared


def _bound(kernel: Kernel) -> tuple[int, np.ndarray, list[tuple[int, int]]]:
    """Return the place of a Kernel of `LANES` lanes, its constants, and what prepares these."""
    addresses = kernel.addresses
    assert addresses is not None
    assert kernel.lanes == LANES
    c = lined_up(LANES * max(1, len(kernel.program.carried)))
    place = address(addresses)
    return place, c, [(place + 8, address(c))]


def _problem(
    kernel: Kernel,
    sampled: Sequence[tuple[np.ndarray, Any]],
    bounded: int = 0,
    further: Sequence[tuple[int, int]] = (),
    switched: np.ndarray | None = None,
) -> LaneProblem:
    program, (place, c, prepared) = kernel.program, _bound(kernel)
    n, inputs = program.num_states, (program.num_specifieds, program.num_constants)
    tables, knots, cubics = tables_of(sampled)
    until = lined_up(LANES)
    until[:] = np.inf
    jumps = jumps_of(sampled) if sampled else NO_JUMPS
    if switched is not None:
        jumps = merged_jumps([jumps, switched])
    switches = 0 if switched is None else len(switched)
    return LaneProblem(
        words=np.array([place, n, n, n - bounded, n, switches, n if bounded else 0, *inputs]),
        clock=lined_up(LANES),
        r=lined_up(LANES * max(1, program.num_specifieds)),
        p=lined_up(LANES * max(1, program.num_constants)),
        c=c,
        prepared=np.array([*prepared, *further]),
        tables=np.ascontiguousarray(tables[:, :3]),
        intervals=np.zeros((len(tables), LANES), dtype=np.int64),
        knots=knots,
        cubics=cubics,
        jumps=jumps,
        until=until,
    )
