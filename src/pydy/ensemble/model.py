"""The model that an ensemble integrates, in a form that can be sent to other processes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from pydy import _forks
from pydy._backends import compile_program
from pydy._forks import cached_property
from pydy._graph import TimeSwitches
from pydy._judges import Passed, Watched
from pydy._kernel import Inputs, Kernel, KernelCall
from pydy._program import Program, Tangent
from pydy._states import follow
from pydy.solvers import (
    ROUNDING,
    CompiledSensitivities,
    Options,
    Outcome,
    ParameterSize,
)
from pydy.trajectory import EventRecord

if TYPE_CHECKING:
    from pydy.solvers import Integration, LaneTasks

# -- Sensitivities of an ensemble: Programs and numbers, which travel to wherever it is integrated -


@dataclass(frozen=True, eq=False)
class EnsembleSensitivities:
    """Derivatives of all trajectories by the same parameters."""

    columns: tuple[str, ...]  # the names of the k columns
    rates: Tangent  # the derivatives of states and columns by time
    outputs: Program | None  # the derivatives of the outputs, shape (o, k)
    start: np.ndarray  # (n, k): those of the initial states; zero for the dependent ones
    dependent: tuple[int, ...]  # the places of the initial conditions that follow from the others
    gradients: tuple[Program, ...]  # the derivatives of each block of constraints by the states
    unknowns: tuple[range, ...]  # the places of the states that each block is solved for
    residuals: Tangent | None  # the derivatives of the constraints, shape (c, k)
    held: Any  # those of all constraints, as they are projected on
    unsolved: str  # what to say where the dependent ones do not follow
    # (places, SampledInput): the derivatives of sampled inputs by their samples, at the end
    # of r
    sampled: tuple[tuple[np.ndarray, Any], ...]
    sized: tuple[ParameterSize, ...]  # the parameters
    controlled: bool  # whether the step control looks at the sensitivities
    sources: np.ndarray  # (k, 2): see `solvers.sensitivities`
    jumps: tuple[tuple[Program, tuple[int, ...]], ...]  # what each event does, and to which states
    watched: Watched | None = None  # what derivatives do not know, if the rates switch at all

    @property
    def programs(self) -> list[Any]:
        """All Programs."""
        return [
            self.rates,
            self.outputs,
            self.residuals,
            self.held,
            *self.gradients,
            *(program for program, _ in self.jumps),
        ]

    @property
    def identity(self) -> Any:
        """The data that identify it, in addition to the Programs."""
        samples = [(c, s.breaks, s.values, s.interpolation) for c, s in self.sampled]
        return self.columns, self.start, self.dependent, samples, self.sized, self.controlled

    @property
    def further(self) -> int:
        """The number of further inputs at the end of r."""
        return sum(len(places) for places, _ in self.sampled)

    def beginning(
        self,
        x: np.ndarray,
        t: float,
        inputs: Inputs,
        p: np.ndarray,
        kernel: Callable[[Program | Tangent], Kernel],
    ) -> tuple[int, np.ndarray]:
        """Return the sensitivities of one sample at the beginning, shape (n, k).

        Before them comes an `Outcome`: whether there are any.
        """
        values = self.start.copy()
        if self.gradients:
            assert self.residuals is not None
            r, at, p = inputs(x, t)[None], np.array([t]), np.ascontiguousarray(p)
            s = self.gradients[0].num_specifieds
            rows = [kernel(g).evaluate(at, x[None], r[:, :s], p)[0][0] for g in self.gradients]
            gradients = [row.reshape(-1, len(x)) for row in rows]
            whole = np.concatenate([x, values.ravel()])
            moved = kernel(self.residuals).evaluate(at, whole[None], r, p)[0][0]
            if not follow(values, gradients, moved, self.unknowns, self.dependent):
                return Outcome.DEPENDENTS_NOT_GIVEN, values
        return Outcome.FINISHED, values

    def compiled(
        self,
        x: np.ndarray,
        r: np.ndarray,
        p: np.ndarray,
        kernel: Callable[[Program | Tangent], Kernel],
    ) -> CompiledSensitivities:
        """Return the sensitivities of one sample, for the solver."""
        n, columns = self.start.shape
        return CompiledSensitivities(
            n,
            self.sources,
            ParameterSize.scales(self.sized, x[:n], r, p, columns),
            x[:n],
            self.controlled,
            lambda k: (kernel(self.jumps[k][0]), self.jumps[k][1]),
            lambda: kernel(self.held),
        )


@dataclass(frozen=True, eq=False)
class Kept:
    """The checks of whether motions kept their constraints and energy."""

    # `DriftQuantities` by name, None where unknown; 'screen' is both rows and products.
    programs: Any
    redundant: bool  # whether constraints were left out
    every: bool  # whether rows that projection does not hold are looked at: see `check_drift`
    mended: bool  # whether motions are brought back onto the constraints
    names: Sequence[str]  # of the rows


class Motions(Protocol):
    """The motions of samples that have transitions of their own, as with contacts."""

    events: tuple[str, ...]  # their names; records hold the places
    columns: tuple[str, ...]  # what sensitivities are by

    @property
    def identity(self) -> Any:
        """The data that identify them, in addition to the Programs, numbers and options."""

    def __call__(
        self,
        x: np.ndarray,
        r: np.ndarray,
        p: np.ndarray,
        times: np.ndarray,
        stopped: Callable[[], bool],
    ) -> tuple[np.ndarray, np.ndarray, dict[str, Any]]:
        """Return states and outputs up to where a motion came, and what `Results.note` needs.

        With sensitivities that has their ``'columns'``, (times, n + o, k).
        """
        ...


# -- The model -------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Model:
    """A model with the options of its integration."""

    rates: Program | Tangent  # the derivatives of the states
    outputs: Program | None
    states: tuple[str, ...]
    output_names: tuple[str, ...]
    method: str  # the name of a native solver
    options: Options
    times: np.ndarray
    # (columns, SampledInput): the entries of r that are samples in time, the same for all
    # members of the ensemble
    sampled: tuple[tuple[np.ndarray, Any], ...] = ()
    # (columns, function): the entries of r given by Python functions ``g(x, t)``, which are
    # called at each evaluation
    functions: tuple[tuple[np.ndarray, Callable[..., Any]], ...] = ()
    jacobian: Program | Tangent | None = None  # ∂f/∂x, for an implicit method
    sensitivities: EnsembleSensitivities | None = None
    kept: Kept | None = None  # what motions with constraints are judged by
    motions: Motions | None = None  # in place of `rates` and `outputs`
    columns: tuple[str, ...] = ()  # what sensitivities are by

    @property
    def in_lanes(self) -> bool:
        """Whether trajectories are integrated several at a time."""
        from pydy.solvers import LaneSolver

        beside, held = self.sensitivities, self.options.constraints is not None
        watched = self.options.events is not None
        asks = self.motions is not None or (watched and not self._watched_in_lanes)
        asks = asks or (beside is not None and (held or beside.controlled))
        large = beside is not None or len(self.states) > LaneSolver.MOST_IMPLICIT_STATES
        asks = asks or (self.jacobian is not None and large)
        return not self.functions and not asks

    @cached_property
    def switches(self) -> TimeSwitches | None:
        """What switches by time alone in the rates, if anything does."""
        varying = frozenset(k for columns, *_ in self.sampled for k in columns.tolist())
        rates: Any = self.rates
        return TimeSwitches.of(getattr(rates, "shared", rates), varying)

    @property
    def _watched_in_lanes(self) -> bool:
        """Whether events need Python for exceptions alone."""
        options, events = self.options, self.options.events
        assert events is not None
        kernels = (events.values, events.rates, events.resets)
        native = all(k is None or k.functions is not None for k in kernels)
        # acts on resets then
        python = self.sampled or self.switches is not None or options.constraints is not None
        acts = not (any(events.resetting) and python) and not any(events.turns)
        return native and acts and not (self.sensitivities or any(events.constant))

    @property
    def event_names(self) -> tuple[str, ...]:
        """The names of the events."""
        if self.motions is not None:
            return self.motions.events
        return () if self.options.events is None else self.options.events.names


@dataclass(eq=False)
class Results:
    """The results of m samples."""

    states: np.ndarray  # (n, m, times)
    # (m,): 'steps', 'rejected', 'evaluations' and 'status', 'end_time' up to which each was
    # integrated, and 'nearness', how near constraints that projection holds came to losing rank
    told: dict[str, np.ndarray]
    records: dict[int, list[EventRecord]] = field(default_factory=dict)  # by sample
    # (n, k, m, times): sensitivities of the states, and of the outputs of `Motions` after them.
    columns: np.ndarray | None = None
    outputs: np.ndarray | None = None  # (o, m, times), of `Motions`
    stretches: list[str] = field(default_factory=list)  # what is to be told of events at zero

    def take(self, places: np.ndarray, others: Results) -> None:
        """Take the results of some samples from others."""
        self.states[:, places] = others.states
        for name in self.told.keys() & others.told.keys():
            self.told[name][places] = others.told[name]
        self.records |= {int(places[k]): records for k, records in others.records.items()}
        self.stretches += others.stretches

    def note(self, k: int, info: Mapping[str, Any]) -> None:
        """Record the outcome and statistics of sample k."""
        self.records[k] = info["events"]
        for name, values in self.told.items():
            key = {"status": "code", "end_time": "time"}.get(name, name)
            values[k] = info.get(key, values[k])

    def resets(self, k: int) -> list[EventRecord]:
        """Return the events that changed the state of sample k."""
        return [e for e in self.records.get(k, ()) if (e.after != e.before).any()]


COUNTED = ("steps", "rejected", "evaluations", "status")
_KERNELS: dict[tuple[str, int], Kernel] = {}
_LOCK = _forks.Lock()


def _kernel(program: Program | Tangent, lanes: int) -> Kernel:
    """Return the Kernel of a Program, compiled or loaded once in a process."""
    key = (program.digest, lanes)
    known = _KERNELS.get(key)
    if known is not None:
        return known
    with _LOCK:
        if key not in _KERNELS:
            # Those of several models with all their events, for blocks that come one by one.
            while len(_KERNELS) >= 64:
                del _KERNELS[next(iter(_KERNELS))]
            _KERNELS[key] = compile_program(program, "llvm", {"lanes": lanes})
        return _KERNELS[key]


def _single(program: Program | Tangent) -> Kernel:
    """Return the Kernel of one state at a time."""
    return _kernel(program, 1)


@dataclass(frozen=True, eq=False)
class Batch:
    """Some samples of a model, with their numbers."""

    model: Model
    x: np.ndarray  # (m, n)
    r: np.ndarray  # (m, s)
    p: np.ndarray  # (m, k)
    stopped: Callable[[], bool]  # tells whether to give up
    logs: bool = True  # whether to note events

    def some(self, places: np.ndarray) -> Batch:
        """Return some of the samples."""
        return replace(self, x=self.x[places], r=self.r[places], p=self.p[places])

    def beside(self) -> Batch:
        """Return the batch with the equations and inputs of the sensitivities."""
        beside = self.model.sensitivities
        assert beside is not None
        sampled = (*self.model.sampled, *beside.sampled)
        model = replace(self.model, rates=beside.rates, sampled=sampled)
        r = np.concatenate([self.r, np.zeros((len(self.r), beside.further))], axis=1)
        return replace(self, model=model, r=r)

    def inputs(self, k: int) -> Callable[[np.ndarray, float], np.ndarray]:
        """Return the function that gives all specifieds of sample k."""
        every = Inputs(self.r[k], self.model.sampled, self.model.functions)

        def inputs(x: np.ndarray, t: float) -> np.ndarray:
            if self.stopped():
                raise KeyboardInterrupt
            return every(x, t)

        return inputs

    def run(self, times: np.ndarray, states: np.ndarray | None = None) -> Results:
        """Integrate; into `states` (n, m, times) if given."""
        if self.model.motions is not None:
            return self._moved(self.model.motions, times, states)
        if self.model.sensitivities is not None:
            return self._with_columns(self.model.sensitivities, times, states)
        if states is None:
            states = np.empty((self.x.shape[1], len(self.x), len(times)))
        return self._integrated(times, states)

    def _begun(self, times: np.ndarray, states: np.ndarray | None, width: int) -> Results:
        """Return results of samples that have not been computed."""
        m = len(self.x)
        states = np.empty((width, m, len(times))) if states is None else states
        states[:] = np.nan
        told: dict[str, np.ndarray] = {name: np.zeros(m, dtype=np.int64) for name in COUNTED}
        return Results(states, {**told, "end_time": np.full(m, times[0]), "nearness": np.ones(m)})

    def _moved(self, motions: Motions, times: np.ndarray, states: np.ndarray | None) -> Results:
        """Compute the motions of samples one after another."""
        m, n = self.x.shape
        results = self._begun(times, states, n)
        results.outputs = np.full((len(self.model.output_names), m, len(times)), np.nan)
        if motions.columns:
            shape = n + len(results.outputs), len(motions.columns), m, len(times)
            results.columns = np.full(shape, np.nan)
        for k in range(m):
            if self.stopped():
                raise KeyboardInterrupt
            own = self.x[k], self.r[k], self.p[k]
            found, outputs, info = motions(*own, times, self.stopped)
            results.states[:, k, : len(found)] = found.T
            results.outputs[:, k, : len(outputs)] = outputs.T
            if results.columns is not None and len(found):
                results.columns[:, :, k, : len(found)] = np.moveaxis(info["columns"], 0, -1)
            results.note(k, info)
        return results

    def _bounds(self) -> tuple[np.ndarray, np.ndarray] | None:
        """Return the tolerances of sensitivities; see `LaneSolver.integrate`."""
        if (beside := self.model.sensitivities) is None:
            return None
        (n, columns), options = beside.start.shape, self.model.options
        x = self.x[:, :n]
        scales = ParameterSize.scales(beside.sized, x, self.r, self.p, columns)
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
            if (numbers != numbers[0]).any():  # each sample switches at times of its own
                return self._one_by_one(times, states)
            span = float(times[0]), float(times[-1])
            found = switches.times(self.p[0], self.r[0], *span)
            if found.unresolved:  # which a single trajectory warns of
                return self._one_by_one(times, states)
            switched = found.rows
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
            results.told["nearness"] = tasks.nearness()
            ended = tasks.ended(counts["status"], states[:, :, -1:])
            results.stretches, results.records = tasks.event_warnings(ended), tasks.records()
            lost = np.flatnonzero(~ended)
            if lost.size:  # why, the solver of single trajectories tells
                results.take(lost, self.some(lost)._one_by_one(times))
        return results

    def _too_exact(self) -> bool:
        """Return whether the tolerances are too small for some of the beginnings.

        Which, the solver of single trajectories tells.
        """
        options, k = self.model.options, int(np.argmin(self.model.options.rtol))
        least = 10.0 * ROUNDING * np.fmax(np.abs(self.x[:, k]), 1.0)
        atol = np.ravel(options.atol)[k if np.size(options.atol) > 1 else 0]
        return options.step is None and bool((atol < least).any())

    def _lane_tasks(self, times: np.ndarray) -> LaneTasks:
        """Return the constraints and events of the samples, for lanes."""
        from pydy._errors import IntegrationError
        from pydy.solvers import LaneSolver, LaneTasks

        held, watched = self.model.options.constraints, self.model.options.events
        one, tasks = self._single(0, times, None), LaneTasks(len(self.x))
        lanes = LaneSolver.LANES
        if watched is not None:
            samples, kernel = (self.r, self.p, self.model.sampled), partial(_kernel, lanes=lanes)
            tasks = LaneTasks.with_events(one, samples, times, kernel, self.logs)
        if held is not None:
            with suppress(IntegrationError):  # redundant constraints are told of
                one.begin(np.ascontiguousarray(self.x[0]))
            tasks.add_constraints(held, _kernel(held.kernel.program, lanes))
        return tasks

    def _single(self, k: int, times: np.ndarray, before: Integration | None) -> Integration:
        """Return the integration of sample k, which may be that of the sample before."""
        from pydy.solvers import Integration

        model, beside, n = self.model, self.model.sensitivities, self.x.shape[1]
        options, jacobian = model.options, model.jacobian
        x, r, p = (np.ascontiguousarray(part[k]) for part in (self.x, self.r, self.p))
        call = KernelCall(
            _kernel(model.rates, 1),
            p,
            r,
            model.sampled,
            self.inputs(k) if model.functions else None,
            lambda: model.states,
            None if jacobian is None else lambda: _kernel(jacobian, 1),
        )
        if beside is not None:
            options = replace(options, sensitivities=beside.compiled(x, r, p, _single))
        elif before is not None and before.reusable and before.rebind(call, times):
            return before
        return Integration(model.method, call, n, times, (), options, self.stopped)

    def _with_columns(
        self, beside: EnsembleSensitivities, times: np.ndarray, states: np.ndarray | None
    ) -> Results:
        """Integrate states with their sensitivities, where these are determined at the start."""
        from pydy._errors import warn_user

        (m, n), columns = self.x.shape, len(beside.columns)
        whole = np.empty((n * (1 + columns), m, len(times)))
        batch, codes = self._begun_with_columns(beside, float(times[0]))
        started = codes == Outcome.FINISHED
        if started.all():
            results = batch._integrated(times, whole)
        else:
            warn_user(f"In one sample or more, {beside.unsolved}")
            results = batch._begun(times, whole, len(whole))
            whole[:n, :, 0], results.told["status"] = self.x.T, codes
            part = np.empty((len(whole), int(started.sum()), len(times)))
            others = batch.some(started)._integrated(times, part)
            results.take(np.flatnonzero(started), others)
        results.states = whole[:n]
        results.columns = whole[n:].reshape(n, columns, m, len(times))
        if states is not None:
            states[:] = results.states
            results.states = states
        return results

    def _begun_with_columns(
        self, beside: EnsembleSensitivities, t: float
    ) -> tuple[Batch, np.ndarray]:
        """Return samples that begin with their sensitivities, and whether there are any."""
        (m, n), batch = self.x.shape, self.beside()
        start, codes = np.empty((m, n + beside.start.size)), np.zeros(m, dtype=np.int64)
        for k in range(m):
            inputs = Inputs(batch.r[k], batch.model.sampled)
            codes[k], values = beside.beginning(self.x[k], t, inputs, self.p[k], _single)
            start[k, :n], start[k, n:] = self.x[k], values.ravel()
        return replace(batch, x=start), codes

    def passed(self, k: int, times: np.ndarray) -> tuple[Passed, Any] | None:
        """Integrate sample k; return its motion and the function of its states, or None."""
        from pydy._errors import IntegrationError

        beside, n = self.model.sensitivities, self.x.shape[1]
        assert beside is not None
        batch, codes = self.some(np.array([k]))._begun_with_columns(beside, float(times[0]))
        options = replace(batch.model.options, dense_output=True, progress=False)
        one = replace(batch, model=replace(batch.model, options=options))._single(0, times, None)
        if codes[0] != Outcome.FINISHED:
            return None
        try:
            reached = len(one.run(batch.x[0]))
        except IntegrationError:
            return None
        info = one.info()
        dense, own = info["dense_output"], times[: min(reached, info["reached"])]

        def columns(t: np.ndarray) -> np.ndarray:
            found: np.ndarray = dense(t)[:, n:].reshape(len(t), n, -1)
            return found

        if dense is None or not len(own):
            return None
        return Passed.of(own, dense, info["events"], columns), lambda t: dense(t)[:, :n]

    def _one_by_one(self, times: np.ndarray, states: np.ndarray | None = None) -> Results:
        """Integrate with the solver of single trajectories."""
        from pydy._errors import IntegrationError

        one = None
        results = self._begun(times, states, self.x.shape[1])
        for k, x in enumerate(self.x):
            if self.stopped():
                raise KeyboardInterrupt
            one = self._single(k, times, one)
            try:
                found = one.run(np.ascontiguousarray(x))
                info = one.info()
                results.stretches += one.event_warnings()
            except IntegrationError as error:
                found, info = one.reached(), error.info
            results.states[:, k, : len(found)] = found.T
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
        out = np.empty((len(program.outputs), *states.shape[1:]))
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
        beside = self.model.sensitivities
        if beside is None:  # those of `Motions` have them
            return columns[:0]
        n, k, m, number = columns.shape
        whole = np.concatenate([states, columns.reshape(n * k, m, number)])
        found = self.beside().evaluate(beside.outputs, times, whole)
        return found.reshape(len(found) // k, k, m, number)
