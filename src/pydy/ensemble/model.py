"""The compiled model of an ensemble, and the integration of some of its samples.

An `EnsembleModel` has Programs and numbers but no SymPy: it is sent to worker processes. There a
`Batch` joins it with the numbers of some samples, and `Batch.run` returns their `Results`: in lanes
if the solver can (`_integrated`), else one by one (`_one_by_one`), with columns of sensitivities
(`_with_columns`) or by `SampleMotions`, as with contacts.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

import numpy as np

from pydy import _forks
from pydy._backends import compile_program
from pydy._forks import cached_property
from pydy._graph import TimeSwitches
from pydy._judges import MotionPath, WatchedQuantities
from pydy._kernel import Inputs, Kernel, KernelCall
from pydy._program import Program, Tangent
from pydy._rank import ROUNDING
from pydy._states import follow
from pydy.solvers import (
    CompiledSensitivities,
    Options,
    Outcome,
    ParameterSize,
)
from pydy.trajectory import EventRecord

if TYPE_CHECKING:
    from pydy.inputs import SampledInput
    from pydy.solvers import Integration, LaneTasks

# -- Sensitivities of an ensemble: Programs and numbers that are sent to the workers ---------------


@dataclass(frozen=True, eq=False)
class EnsembleSensitivities:
    """Derivatives of all trajectories with respect to the same parameters."""

    columns: tuple[str, ...]  # the names of the k columns
    rates: Tangent  # the time derivatives of states and columns
    outputs: Program | None  # the derivatives of the outputs, shape (o, k)
    start: np.ndarray  # (n, k): those of the initial states; zero for the dependent ones
    dependent: tuple[int, ...]  # indices of the dependent initial conditions
    gradients: tuple[Program, ...]  # the derivatives of each block of constraints by the states
    unknowns: tuple[range, ...]  # indices of the states that each block is solved for
    residuals: Tangent | None  # the derivatives of the constraints, shape (c, k)
    projected_residuals: Any  # the same for all constraints that projection satisfies
    unsolved: str  # the message if the dependent initial conditions cannot be solved for
    # (indices, SampledInput): the derivatives of sampled inputs by their samples, at the end of r
    sampled: tuple[tuple[np.ndarray, SampledInput], ...]
    sized: tuple[ParameterSize, ...]  # the parameters
    controlled: bool  # whether the sensitivities take part in step-size control
    sources: np.ndarray  # (k, 2): see `solvers.sensitivities`
    jumps: tuple[tuple[Program, tuple[int, ...]], ...]  # each event's Program and changed states
    watched: WatchedQuantities | None = (
        None  # discontinuities that the derivatives miss, if there are any
    )

    @property
    def programs(self) -> list[Program | Tangent | None]:
        """All Programs."""
        return [
            self.rates,
            self.outputs,
            self.residuals,
            self.projected_residuals,
            *self.gradients,
            *(program for program, _ in self.jumps),
        ]

    @property
    def identity(self) -> object:
        """The data that identify the sensitivities, in addition to the Programs."""
        samples = [(c, s.breaks, s.values, s.interpolation) for c, s in self.sampled]
        return self.columns, self.start, self.dependent, samples, self.sized, self.controlled

    @property
    def further(self) -> int:
        """The number of additional inputs at the end of r."""
        return sum(len(columns) for columns, _ in self.sampled)

    def at_start(
        self,
        x: np.ndarray,
        t: float,
        inputs: Inputs,
        p: np.ndarray,
        kernel: Callable[[Program | Tangent], Kernel],
    ) -> tuple[int, np.ndarray]:
        """Return an `Outcome` and the initial sensitivities of one sample, shape (n, k).

        The `Outcome` is FINISHED if the dependent initial conditions could be solved for.
        """
        values = self.start.copy()
        if self.gradients:
            assert self.residuals is not None
            r, at, p = inputs(x, t)[None], np.array([t]), np.ascontiguousarray(p)
            s = self.gradients[0].signature.num_specifieds
            rows = [kernel(g).evaluate(at, x[None], r[:, :s], p)[0][0] for g in self.gradients]
            gradients = [row.reshape(-1, len(x)) for row in rows]
            full_state = np.concatenate([x, values.ravel()])
            residual_slopes = kernel(self.residuals).evaluate(at, full_state[None], r, p)[0][0]
            if not follow(values, gradients, residual_slopes, self.unknowns, self.dependent):
                return Outcome.DEPENDENTS_NOT_GIVEN, values
        return Outcome.FINISHED, values

    def compiled(
        self,
        x: np.ndarray,
        r: np.ndarray,
        p: np.ndarray,
        kernel: Callable[[Program | Tangent], Kernel],
    ) -> CompiledSensitivities:
        """Return the sensitivities of one sample in the solver's form."""
        n, columns = self.start.shape
        return CompiledSensitivities(
            n,
            self.sources,
            ParameterSize.scales(self.sized, x[:n], r, p, columns),
            x[:n],
            self.controlled,
            lambda k: (kernel(self.jumps[k][0]), self.jumps[k][1]),
            lambda: kernel(self.projected_residuals),
        )


class ProgramsByName(Protocol):
    """Programs that are looked up by name, in a dictionary or compiled when first needed."""

    def __getitem__(self, name: str, /) -> Program | None:
        """Return the Program of a name, or None if there is none."""


@dataclass(frozen=True, eq=False)
class ConstraintChecks:
    """The checks of the drift from constraints and of the energy."""

    # `DriftQuantities` by name, None if unknown; 'screen' computes both rows and products
    programs: ProgramsByName
    redundant: bool  # whether there are redundant constraints
    every: bool  # whether there are rows that projection does not satisfy: see `check_drift`
    corrected: bool  # whether the integration corrects the drift from the constraints
    names: Sequence[str]  # of the rows


class SampleMotions(Protocol):
    """A function that simulates samples with mode transitions, such as contacts."""

    events: tuple[str, ...]  # names; records contain indices of these
    columns: tuple[str, ...]  # the parameters of the sensitivities

    @property
    def identity(self) -> object:
        """The data that identify the motions, in addition to Programs, numbers and options."""

    def __call__(
        self,
        x: np.ndarray,
        r: np.ndarray,
        p: np.ndarray,
        times: np.ndarray,
        stopped: Callable[[], bool],
    ) -> tuple[np.ndarray, np.ndarray, dict[str, Any]]:
        """Return the states and outputs up to a motion's end, and the info for `Results.note`.

        With sensitivities, the info contains their ``'columns'``, (times, n + o, k); of a motion
        that a terminal event ended, ``'end_outputs'``, (o,), after the event.
        """
        ...


# -- The model -------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class EnsembleModel:
    """The compiled equations with the options of their integration: all that workers need.

    It contains Programs and numbers only, so that it can be pickled and needs no SymPy.
    """

    rates: Program | Tangent  # the derivatives of the states
    outputs: Program | None
    states: tuple[str, ...]
    output_names: tuple[str, ...]
    method: str  # the name of a native solver
    options: Options
    times: np.ndarray
    # (columns, SampledInput): the entries of r that are samples in time, the same for all
    # members of the ensemble
    sampled: tuple[tuple[np.ndarray, SampledInput], ...] = ()
    # (columns, function): the entries of r that Python functions ``g(x, t)`` compute at each
    # evaluation
    functions: tuple[tuple[np.ndarray, Callable[..., object]], ...] = ()
    jacobian: Program | Tangent | None = None  # ∂f/∂x, for an implicit method
    sensitivities: EnsembleSensitivities | None = None
    constraint_checks: ConstraintChecks | None = None  # for motions with constraints
    motions: SampleMotions | None = None  # replaces `rates` and `outputs`
    columns: tuple[str, ...] = ()  # the parameters of the sensitivities

    @property
    def in_lanes(self) -> bool:
        """Whether the solver integrates several trajectories at a time."""
        from pydy.solvers import LaneSolver

        sensitivities, has_constraints = self.sensitivities, self.options.constraints is not None
        has_events = self.options.events is not None
        needs_scalar_solver = self.motions is not None or (
            has_events and not self._watched_in_lanes
        )
        needs_scalar_solver = needs_scalar_solver or (
            sensitivities is not None and (has_constraints or sensitivities.controlled)
        )
        large = sensitivities is not None or len(self.states) > LaneSolver.MOST_IMPLICIT_STATES
        needs_scalar_solver = needs_scalar_solver or (self.jacobian is not None and large)
        return not self.functions and not needs_scalar_solver

    @cached_property
    def switches(self) -> TimeSwitches | None:
        """The branches of the rates that switch at times that do not depend on the states."""
        varying = frozenset(k for columns, *_ in self.sampled for k in columns.tolist())
        rates: Any = self.rates
        return TimeSwitches.of(getattr(rates, "shared", rates), varying)

    @property
    def _watched_in_lanes(self) -> bool:
        """Whether events can be located in lanes; Python handles exceptional cases only."""
        options, events = self.options, self.options.events
        assert events is not None
        kernels = (events.values, events.rates, events.resets)
        native = all(k is None or k.functions is not None for k in kernels)
        # Python then handles resets.
        python = self.sampled or self.switches is not None or options.constraints is not None
        acts = not any((e.resets and python) or e.turns or e.constant for e in events.traits)
        return native and acts and not self.sensitivities

    @property
    def event_names(self) -> tuple[str, ...]:
        """The names of the events."""
        if self.motions is not None:
            return self.motions.events
        return () if self.options.events is None else self.options.events.names


class EventColumns(NamedTuple):
    """The events of many samples as columns, those of a sample adjacent and in order."""

    samples: np.ndarray
    times: np.ndarray
    events: np.ndarray  # numbers
    before: np.ndarray  # (rows, n): the states
    after: np.ndarray


@dataclass(eq=False)
class Results:
    """The results of m samples."""

    states: np.ndarray  # (n, m, times)
    # (m,) arrays: 'steps', 'rejected', 'evaluations', 'status', 'end_time' of the integration, and
    # 'nearness': the smallest distance of the projected constraints from a loss of rank
    statistics: dict[str, np.ndarray]
    records: dict[int, list[EventRecord]] = field(default_factory=dict)  # by sample
    # The events of samples without an entry in `records`. Objects are built only for samples that
    # need them: of a million samples, arrays are enough for most.
    columns_of_events: EventColumns | None = None
    event_names: tuple[str, ...] = ()
    # (n, k, m, times): sensitivities of the states, then of the outputs of `SampleMotions`
    columns: np.ndarray | None = None
    outputs: np.ndarray | None = None  # (o, m, times), of `SampleMotions`
    # (o,) by sample: the outputs of `SampleMotions` after a terminal event
    end_outputs: dict[int, np.ndarray] = field(default_factory=dict)
    event_warnings: list[str] = field(default_factory=list)

    def take(self, indices: np.ndarray, source: Results) -> None:
        """Copy the results of some samples from `source`, which contains these alone."""
        self.states[:, indices] = source.states
        for name in self.statistics.keys() & source.statistics.keys():
            self.statistics[name][indices] = source.statistics[name]
        self.records |= {int(indices[k]): source.events_of(k) for k in source.recorded()}
        self.event_warnings += source.event_warnings

    def note(self, k: int, info: Mapping[str, Any]) -> None:
        """Record the outcome and statistics of sample k."""
        self.records[k] = info["events"]
        for name, values in self.statistics.items():
            key = {"status": "code", "end_time": "time"}.get(name, name)
            values[k] = info.get(key, values[k])

    def resets(self, k: int) -> list[EventRecord]:
        """Return the events that changed the state of sample k."""
        return [e for e in self.events_of(k) if (e.after != e.before).any()]

    def recorded(self) -> list[int]:
        """Return the samples that have records."""
        columns = self.columns_of_events
        return sorted({*self.records, *(() if columns is None else columns.samples.tolist())})

    def events_of(self, k: int) -> list[EventRecord]:
        """Return the events of sample k."""
        columns = self.columns_of_events
        if k in self.records or columns is None:
            return self.records.get(k, [])
        first, last = np.searchsorted(columns.samples, [k, k + 1])
        rows = zip(*(column[first:last] for column in columns[1:]), strict=True)
        return [
            EventRecord(float(t), self.event_names[event], int(event), before, after)
            for t, event, before, after in rows
        ]

    def last_events(self, chosen: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the times (m,) of the last events of m samples, and the states (n, m) after them.

        A sample without an event has NaN.
        """
        times, states = (
            np.full(len(chosen), np.nan),
            np.full((len(self.states), len(chosen)), np.nan),
        )
        if (columns := self.columns_of_events) is not None and len(columns.samples):
            rows = np.searchsorted(columns.samples, chosen, side="right") - 1
            mine = (rows >= 0) & (columns.samples[rows] == chosen)
            times[mine], states[:, mine] = columns.times[rows[mine]], columns.after[rows[mine]].T
        for j in np.flatnonzero(np.isin(chosen, [*self.records])).tolist():
            if records := self.records[int(chosen[j])]:
                times[j], states[:, j] = records[-1].time, records[-1].after
        return times, states

    def occurrences(self, event: int, number: int) -> tuple[np.ndarray, np.ndarray]:
        """Return how often an event happened, (m,), and its first times, (m, number) or NaN."""
        m = len(self.statistics["status"])
        count, first = np.zeros(m, dtype=np.int64), np.full((m, number), np.nan)
        if (columns := self.columns_of_events) is not None:
            replaced = np.zeros(m, dtype=bool)
            replaced[list(self.records)] = True
            chosen = (columns.events == event) & ~replaced[columns.samples]
            samples, times = columns.samples[chosen], columns.times[chosen]
            count[:] = np.bincount(samples, minlength=m)
            order = np.arange(len(samples)) - (np.cumsum(count) - count)[samples]
            early = order < number
            first[samples[early], order[early]] = times[early]
        for k, records in self.records.items():
            times_of_k = [record.time for record in records if record.index == event]
            count[k] = len(times_of_k)
            first[k, : min(number, len(times_of_k))] = times_of_k[:number]
        return count, first


COUNTED = ("steps", "rejected", "evaluations", "status")
_KERNELS: dict[tuple[str, int], Kernel] = {}
_LOCK = _forks.Lock()


def _kernel(program: Program | Tangent, lanes: int) -> Kernel:
    """Return the Kernel of a Program; a process compiles or loads it once."""
    key = (program.digest, lanes)
    kernel = _KERNELS.get(key)
    if kernel is not None:
        return kernel
    with _LOCK:
        if key not in _KERNELS:
            # Enough for several models with all their events.
            while len(_KERNELS) >= 64:
                del _KERNELS[next(iter(_KERNELS))]
            _KERNELS[key] = compile_program(program, "llvm", {"lanes": lanes})
        return _KERNELS[key]


def _single(program: Program | Tangent) -> Kernel:
    """Return the Kernel for one state at a time."""
    return _kernel(program, 1)


@dataclass(frozen=True, eq=False)
class Batch:
    """Some samples: a model with their initial states, specifieds and constants."""

    model: EnsembleModel
    x: np.ndarray  # (m, n)
    r: np.ndarray  # (m, s)
    p: np.ndarray  # (m, k)
    stopped: Callable[[], bool]  # True if the computation is cancelled
    logs: bool = True  # whether to record events

    def select(self, indices: np.ndarray) -> Batch:
        """Return the batch of some of the samples."""
        return replace(self, x=self.x[indices], r=self.r[indices], p=self.p[indices])

    def augmented(self) -> Batch:
        """Return the batch with the equations and inputs of the sensitivities."""
        sensitivities = self.model.sensitivities
        assert sensitivities is not None
        sampled = (*self.model.sampled, *sensitivities.sampled)
        model = replace(self.model, rates=sensitivities.rates, sampled=sampled)
        r = np.concatenate([self.r, np.zeros((len(self.r), sensitivities.further))], axis=1)
        return replace(self, model=model, r=r)

    def inputs(self, k: int) -> Inputs:
        """Return the specifieds of sample k; functions raise KeyboardInterrupt if cancelled."""
        return Inputs(np.ascontiguousarray(self.r[k]), self.model.sampled, self._functions)

    @cached_property
    def _functions(self) -> tuple[tuple[np.ndarray, Callable[..., object]], ...]:
        """The specifieds that are functions, of which the first checks for a cancellation."""
        if not self.model.functions:
            return ()
        (columns, function), *others = self.model.functions

        def checked(x: np.ndarray, t: float) -> object:
            if self.stopped():
                raise KeyboardInterrupt
            return function(x, t)

        return ((columns, checked), *others)

    def run(self, times: np.ndarray, states: np.ndarray | None = None) -> Results:
        """Integrate, and write the states into the array `states` (n, m, times) unless None."""
        if self.model.motions is not None:
            return self._run_motions(self.model.motions, times, states)
        if self.model.sensitivities is not None:
            return self._with_columns(self.model.sensitivities, times, states)
        if states is None:
            states = np.empty((self.x.shape[1], len(self.x), len(times)))
        return self._integrated(times, states)

    def _empty_results(self, times: np.ndarray, states: np.ndarray | None, width: int) -> Results:
        """Return results that are NaN and zero."""
        m = len(self.x)
        states = np.empty((width, m, len(times))) if states is None else states
        states[:] = np.nan
        statistics: dict[str, np.ndarray] = {name: np.zeros(m, dtype=np.int64) for name in COUNTED}
        return Results(
            states, {**statistics, "end_time": np.full(m, times[0]), "nearness": np.ones(m)}
        )

    def _run_motions(
        self, motions: SampleMotions, times: np.ndarray, states: np.ndarray | None
    ) -> Results:
        """Simulate the samples one after another by `SampleMotions`."""
        m, n = self.x.shape
        results = self._empty_results(times, states, n)
        results.outputs = np.full((len(self.model.output_names), m, len(times)), np.nan)
        if motions.columns:
            shape = n + len(results.outputs), len(motions.columns), m, len(times)
            results.columns = np.full(shape, np.nan)
        for k in range(m):
            if self.stopped():
                raise KeyboardInterrupt
            numbers = self.x[k], self.r[k], self.p[k]
            computed, outputs, info = motions(*numbers, times, self.stopped)
            results.states[:, k, : len(computed)] = computed.T
            results.outputs[:, k, : len(outputs)] = outputs.T
            if results.columns is not None and len(computed):
                results.columns[:, :, k, : len(computed)] = np.moveaxis(info["columns"], 0, -1)
            if "end_outputs" in info:
                results.end_outputs[k] = info["end_outputs"]
            results.note(k, info)
        return results

    def _bounds(self) -> tuple[np.ndarray, np.ndarray] | None:
        """Return the tolerances of sensitivities; see `LaneSolver.integrate`."""
        if (sensitivities := self.model.sensitivities) is None:
            return None
        (n, columns), options = sensitivities.start.shape, self.model.options
        x = self.x[:, :n]
        scales = ParameterSize.scales(sensitivities.sized, x, self.r, self.p, columns)
        rtol, atol = (np.broadcast_to(a, n) for a in (options.rtol, options.atol))
        return CompiledSensitivities.bounding_tolerances(rtol, atol, x, scales)

    def _integrated(self, times: np.ndarray, states: np.ndarray) -> Results:
        """Integrate, several samples at a time if possible."""
        from pydy.solvers import LaneSolver

        model, exact = self.model, np.min(self.model.options.rtol) < 10.0 * ROUNDING
        if not model.in_lanes or (exact and self._too_exact()):
            return self._one_by_one(times, states)
        switched = None
        if (switches := self.model.switches) is not None:
            numbers = switches.numbers(self.p, self.r)
            if (numbers != numbers[0]).any():  # samples switch at different times
                return self._one_by_one(times, states)
            span = float(times[0]), float(times[-1])
            switch_times = switches.times(self.p[0], self.r[0], *span)
            if switch_times.unresolved:  # the solver of single trajectories warns of these
                return self._one_by_one(times, states)
            switched = switch_times.rows
        tasks: LaneTasks | None = None
        if model.options.constraints is not None or model.options.events is not None:
            tasks = self._lane_tasks(times)
        lanes = LaneSolver.LANES
        solver = LaneSolver(
            _kernel(model.rates, lanes),
            model.method,
            model.options,
            model.sampled,
            None if model.jacobian is None else _kernel(model.jacobian, lanes),
            switched,
        )
        counted, reached = solver.integrate(
            (self.x, self.r, self.p), times, states, self.stopped, self._bounds(), tasks
        )
        counts = dict(zip(COUNTED, np.array(counted.T), strict=True))
        results = Results(states, {**counts, "end_time": reached})
        if tasks is not None:
            results.statistics["nearness"] = tasks.nearness()
            ended = tasks.ended(counts["status"], states[:, :, -1:])
            results.event_warnings = tasks.event_warnings(ended)
            if columns := tasks.records():
                results.columns_of_events = EventColumns(*columns)
                results.event_names = model.event_names
            failed = np.flatnonzero(~ended)
            if failed.size:  # the solver of single trajectories determines the reason
                results.take(failed, self.select(failed)._one_by_one(times))
        return results

    def _too_exact(self) -> bool:
        """Return whether the tolerances are too small for some of the initial states.

        The solver of single trajectories reports which.
        """
        options, k = self.model.options, int(np.argmin(self.model.options.rtol))
        least = 10.0 * ROUNDING * np.abs(self.x[:, k])
        atol = np.ravel(options.atol)[k if np.size(options.atol) > 1 else 0]
        return options.step is None and bool((atol < least).any())

    def _lane_tasks(self, times: np.ndarray) -> LaneTasks:
        """Return the constraints and events of the samples, for lanes."""
        from pydy._errors import IntegrationError
        from pydy.solvers import LaneSolver, LaneTasks

        constraints, events = self.model.options.constraints, self.model.options.events
        first, tasks = self._single(0, times, None), LaneTasks(len(self.x))
        lanes = LaneSolver.LANES
        if events is not None:
            samples, kernel = (self.r, self.p, self.model.sampled), partial(_kernel, lanes=lanes)
            tasks = LaneTasks.with_events(first, samples, times, kernel, self.logs)
        if constraints is not None:
            with suppress(IntegrationError):  # `begin` warns of redundant constraints
                first.begin(np.ascontiguousarray(self.x[0]))
            tasks.add_constraints(constraints, _kernel(constraints.kernel.program, lanes))
        return tasks

    def _single(self, k: int, times: np.ndarray, before: Integration | None) -> Integration:
        """Return the integration of sample k; it may reuse that of the sample before."""
        from pydy.solvers import Integration

        model, sensitivities, n = self.model, self.model.sensitivities, self.x.shape[1]
        options, jacobian = model.options, model.jacobian
        x, p = (np.ascontiguousarray(part[k]) for part in (self.x, self.p))
        inputs = self.inputs(k)
        call = KernelCall(
            _kernel(model.rates, 1),
            p,
            inputs,
            lambda: model.states,
            None if jacobian is None else lambda: _kernel(jacobian, 1),
        )
        if sensitivities is not None:
            compiled = sensitivities.compiled(x, inputs.values, p, _single)
            options = replace(options, sensitivities=compiled)
        elif before is not None and before.reusable and before.rebind(call, times):
            return before
        return Integration(model.method, call, n, times, (), options, self.stopped)

    def _with_columns(
        self, sensitivities: EnsembleSensitivities, times: np.ndarray, states: np.ndarray | None
    ) -> Results:
        """Integrate states and sensitivities; samples without initial sensitivities are NaN."""
        from pydy._errors import warn_user

        (m, n), columns = self.x.shape, len(sensitivities.columns)
        full_states = np.empty((n * (1 + columns), m, len(times)))
        batch, codes = self._augmented_start(sensitivities, float(times[0]))
        started = codes == Outcome.FINISHED
        if started.all():
            results = batch._integrated(times, full_states)
        else:
            warn_user(f"In one sample or more, {sensitivities.unsolved}")
            results = batch._empty_results(times, full_states, len(full_states))
            full_states[:n, :, 0], results.statistics["status"] = self.x.T, codes
            part = np.empty((len(full_states), int(started.sum()), len(times)))
            started_results = batch.select(started)._integrated(times, part)
            results.take(np.flatnonzero(started), started_results)
        results.states = full_states[:n]
        results.columns = full_states[n:].reshape(n, columns, m, len(times))
        if states is not None:
            states[:] = results.states
            results.states = states
        return results

    def _augmented_start(
        self, sensitivities: EnsembleSensitivities, t: float
    ) -> tuple[Batch, np.ndarray]:
        """Return the batch with initial sensitivities, and an `Outcome` for each sample."""
        (m, n), batch = self.x.shape, self.augmented()
        start, codes = np.empty((m, n + sensitivities.start.size)), np.zeros(m, dtype=np.int64)
        for k in range(m):
            inputs = Inputs(batch.r[k], batch.model.sampled)
            codes[k], values = sensitivities.at_start(self.x[k], t, inputs, self.p[k], _single)
            start[k, :n], start[k, n:] = self.x[k], values.ravel()
        return replace(batch, x=start), codes

    def motion_path(
        self, k: int, times: np.ndarray
    ) -> tuple[MotionPath, Callable[[np.ndarray], np.ndarray]] | None:
        """Integrate sample k; return its motion and its interpolated states, or None."""
        from pydy._errors import IntegrationError

        sensitivities, n = self.model.sensitivities, self.x.shape[1]
        assert sensitivities is not None
        batch, codes = self.select(np.array([k]))._augmented_start(sensitivities, float(times[0]))
        options = replace(batch.model.options, dense_output=True, progress=False)
        integration = replace(batch, model=replace(batch.model, options=options))._single(
            0, times, None
        )
        if codes[0] != Outcome.FINISHED:
            return None
        try:
            reached = len(integration.run(batch.x[0]))
        except IntegrationError:
            return None
        info = integration.info()
        dense, sample_times = info["dense_output"], times[: min(reached, info["reached"])]

        def columns(t: np.ndarray) -> np.ndarray:
            values: np.ndarray = dense(t)[:, n:].reshape(len(t), n, -1)
            return values

        if dense is None or not len(sample_times):
            return None
        return MotionPath.from_solution(
            sample_times, dense, info["events"], columns
        ), lambda t: dense(t)[:, :n]

    def _one_by_one(self, times: np.ndarray, states: np.ndarray | None = None) -> Results:
        """Integrate with the solver of single trajectories."""
        from pydy._errors import IntegrationError

        integration = None
        results = self._empty_results(times, states, self.x.shape[1])
        for k, x in enumerate(self.x):
            if self.stopped():
                raise KeyboardInterrupt
            integration = self._single(k, times, integration)
            try:
                computed = integration.run(np.ascontiguousarray(x))
                info = integration.info()
                results.event_warnings += integration.event_warnings()
            except IntegrationError as error:
                computed, info = integration.reached(), error.info
            results.states[:, k, : len(computed)] = computed.T
            results.note(k, info)
        return results

    def evaluate(
        self, program: Program | None, times: np.ndarray, states: np.ndarray
    ) -> np.ndarray:
        """Return a Program's outputs (o, m, times) along trajectories (n, m, times)."""
        if program is None:
            return np.empty((0, *states.shape[1:]))
        if not self.model.functions:
            from pydy.solvers import LaneSolver

            kernel = _kernel(program, LaneSolver.LANES)
            return LaneSolver.evaluate(kernel, self.r, self.p, self.model.sampled, times, states)
        kernel = _kernel(program, 1)
        out = np.empty((program.signature.num_outputs, *states.shape[1:]))
        for k, r in enumerate(self.r):
            inputs, x = self.inputs(k), np.ascontiguousarray(states[:, k].T)
            reached = np.isfinite(x).all(axis=1)
            parts = zip(x, times, reached, strict=True)
            rows = np.array([inputs(s, float(t)) if ok else r for s, t, ok in parts])
            values, failed = kernel.evaluate(times, x, rows, np.ascontiguousarray(self.p[k]))
            values[failed | ~reached] = np.nan
            out[:, k] = values.T
        return out

    def output_columns(
        self, times: np.ndarray, states: np.ndarray, columns: np.ndarray
    ) -> np.ndarray:
        """Return the sensitivities of the outputs, (o, k, m, times), from those of the states."""
        sensitivities = self.model.sensitivities
        if sensitivities is None:  # `SampleMotions` computes them itself
            return columns[:0]
        n, k, m, number = columns.shape
        full_states = np.concatenate([states, columns.reshape(n * k, m, number)])
        values = self.augmented().evaluate(sensitivities.outputs, times, full_states)
        return values.reshape(len(values) // k, k, m, number)
