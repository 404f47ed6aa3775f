"""The model that an ensemble integrates, in a form that can be sent to other processes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Protocol

import numpy as np

from pydy import _forks
from pydy._backends.registry import compile_program
from pydy._graph.program import Program
from pydy._graph.tangent import Tangent
from pydy._kernel import Inputs, Kernel, KernelCall
from pydy.analysis.dependence import follow
from pydy.solvers.options import Options
from pydy.solvers.outcome import DEPENDENTS_NOT_GIVEN, FINISHED
from pydy.solvers.sensitivities import CompiledSensitivities, Sized, scales_of
from pydy.solvers.tuning import LANES

# -- Sensitivities of an ensemble: Programs and numbers, which travel to wherever it is integrated -


@dataclass(frozen=True, eq=False)
class EnsembleSensitivities:
    """Derivatives of all trajectories by the same parameters."""

    names: tuple[str, ...]  # of the k columns
    rates: Tangent  # the derivatives of states and columns by time
    outputs: Program | None  # the derivatives of the outputs, shape (o, k)
    start: np.ndarray  # (n, k): those of the initial states; zero for the dependent ones
    dependent: tuple[int, ...]  # the places of the initial conditions that follow from the others
    gradients: tuple[Program, ...]  # the derivatives of each block of constraints by the states
    unknowns: tuple[range, ...]  # the places of the states that each block is solved for
    residuals: Tangent | None  # the derivatives of the constraints, shape (c, k)
    unsolved: str  # what to say where the dependent ones do not follow
    # (places, SampledInput): the derivatives of sampled inputs by their samples, at the end
    # of r
    sampled: tuple[tuple[np.ndarray, Any], ...]
    # the parameters, where the step control looks at the sensitivities
    sized: tuple[Sized, ...] | None
    sources: np.ndarray  # (k, 2): see `solvers.sensitivities`
    jumps: tuple[tuple[Program, tuple[int, ...]], ...]  # what each event does, and to which states

    @property
    def programs(self) -> list[Any]:
        """All Programs."""
        return [
            self.rates,
            self.outputs,
            self.residuals,
            *self.gradients,
            *(program for program, _ in self.jumps),
        ]

    @property
    def identity(self) -> Any:
        """What tells it from others, besides the Programs."""
        samples = [(c, s.breaks, s.values, s.interpolation) for c, s in self.sampled]
        return self.names, self.start, self.dependent, samples, self.sized

    @property
    def further(self) -> int:
        """How many inputs r has at its end."""
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

        Before them comes a code of `outcome`: whether there are any.
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
                return DEPENDENTS_NOT_GIVEN, values
        return FINISHED, values

    def compiled(
        self,
        x: np.ndarray,
        r: np.ndarray,
        p: np.ndarray,
        kernel: Callable[[Program | Tangent], Kernel],
    ) -> CompiledSensitivities:
        """Return what the solver needs to know of one sample."""
        n, columns = self.start.shape
        scales = None if self.sized is None else scales_of(self.sized, x, r, p, columns)

        def event(k: int) -> tuple[Kernel, tuple[int, ...]]:
            program, changed = self.jumps[k]
            return kernel(program), changed

        def constraints() -> Kernel:
            assert self.residuals is not None
            return kernel(self.residuals)

        return CompiledSensitivities(n, self.sources, scales, event, constraints)


class Programs(Protocol):
    """The Programs of `kept.Part` by name; None for what is not known."""

    def __getitem__(self, name: str) -> Program | None: ...


@dataclass(frozen=True, eq=False)
class Kept:
    """What tells whether motions kept their constraints and energy."""

    programs: Programs  # also 'screen', which is both rows and products
    redundant: bool  # whether constraints were left out
    mended: bool  # whether motions are brought back onto the constraints


# -- The model -------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Model:
    """A model with the options of its integration."""

    rates: Program  # the derivatives of the states
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
    jacobian: Program | None = None  # ∂f/∂x, for an implicit method
    sensitivities: EnsembleSensitivities | None = None
    kept: Kept | None = None  # what motions with constraints are judged by

    @property
    def in_lanes(self) -> bool:
        """Whether trajectories are integrated several at a time."""
        asks = self.options.events is not None or self.options.constraints is not None
        beside = self.sensitivities
        asks = asks or (beside is not None and beside.sized is not None)
        return self.method != "radau" and not self.functions and not asks


@dataclass(eq=False)
class Results:
    """The results of m samples."""

    states: np.ndarray  # (n, m, times)
    steps: np.ndarray  # steps, rejected, evaluations, status: int64, (m,)
    rejected: np.ndarray
    evaluations: np.ndarray
    status: np.ndarray
    end_time: np.ndarray  # (m,): the time up to which each was integrated
    # for each sample, pairs of the number of an event and its time; empty without events
    events: list[list[tuple[int, float]]] = field(default_factory=list)
    columns: np.ndarray | None = None  # (n, k, m, times): sensitivities of the states
    # for each sample, the derivatives (k,) of the times of its events
    moments: list[list[np.ndarray]] = field(default_factory=list)
    # for each sample, the times and states of events that changed its state
    resets: list[list[tuple[float, np.ndarray]]] = field(default_factory=list)
    # (m,): how near constraints that projection holds came to losing rank
    nearness: np.ndarray | None = None


_KERNELS: dict[tuple[str, int], Kernel] = {}
_KEPT = 64  # of several models with all that events need, for blocks that come one by one
_LOCK = _forks.Lock()


def _kernel(program: Program | Tangent, lanes: int) -> Kernel:
    """Return the Kernel of a Program, compiled or loaded once in a process."""
    key = (program.digest, lanes)
    known = _KERNELS.get(key)
    if known is not None:
        return known
    with _LOCK:
        if key not in _KERNELS:
            while len(_KERNELS) >= _KEPT:
                del _KERNELS[next(iter(_KERNELS))]
            _KERNELS[key] = compile_program(program, "llvm", {"lanes": lanes})
        return _KERNELS[key]


def _single(program: Program | Tangent) -> Kernel:
    """Return the Kernel of one state at a time."""
    return _kernel(program, 1)


def run(
    model: Model,
    x: np.ndarray,
    r: np.ndarray,
    p: np.ndarray,
    times: np.ndarray,
    stopped: Callable[[], bool],
    states: np.ndarray | None = None,
) -> Results:
    """Integrate m samples: x (m, n), r (m, s), p (m, k); into `states` (n, m, times) if given."""
    if model.sensitivities is not None:
        return _run_with_columns(model, model.sensitivities, x, r, p, times, stopped, states)
    if states is None:
        states = np.empty((x.shape[1], len(x), len(times)))
    if not model.in_lanes:
        return _run_one_by_one(model, x, r, p, times, stopped, states)
    kernel = _kernel(model.rates, LANES)
    return _run_in_lanes(model, kernel, (x, r, p), model.sampled, times, stopped, states)


def _run_in_lanes(
    model: Model,
    kernel: Kernel,
    inputs: tuple[np.ndarray, np.ndarray, np.ndarray],
    sampled: Sequence[tuple[np.ndarray, Any]],
    times: np.ndarray,
    stopped: Callable[[], bool],
    states: np.ndarray,
    controlled: int | None = None,
) -> Results:
    """Integrate several samples at a time: x, r and p with one row for each."""
    from pydy.solvers.run.lanes import integrate_samples

    x, r, p = inputs
    found = integrate_samples(
        kernel, model.method, x, r, p, sampled, times, model.options, states, stopped, controlled
    )
    steps, rejected, evaluations, status = (np.array(c) for c in found.counts.T)
    return Results(states, steps, rejected, evaluations, status, found.reached)


def evaluate(
    model: Model,
    program: Program | None,
    r: np.ndarray,
    p: np.ndarray,
    times: np.ndarray,
    states: np.ndarray,
    stopped: Callable[[], bool],
) -> np.ndarray:
    """Return a Program's outputs along trajectories (n, m, times), shape (outputs, m, times)."""
    if program is None:
        return np.empty((0, *states.shape[1:]))
    if not model.functions:
        from pydy.solvers.run.lanes import evaluate_samples

        return evaluate_samples(_kernel(program, LANES), r, p, model.sampled, times, states)
    kernel = _kernel(program, 1)
    out = np.empty((len(program.outputs), *states.shape[1:]))
    for k in range(states.shape[1]):
        inputs = _inputs(model, r[k], stopped)
        x = np.ascontiguousarray(states[:, k].T)
        reached = np.isfinite(x).all(axis=1)
        rows = np.array(
            [
                inputs(s, float(t)) if ok else r[k]
                for s, t, ok in zip(x, times, reached, strict=True)
            ]
        )
        values, failed = kernel.evaluate(times, x, rows, np.ascontiguousarray(p[k]))
        values[failed | ~reached] = np.nan
        out[:, k] = values.T
    return out


def evaluate_output_columns(
    model: Model,
    r: np.ndarray,
    p: np.ndarray,
    times: np.ndarray,
    states: np.ndarray,
    columns: np.ndarray,
) -> np.ndarray:
    """Return the sensitivities of the outputs, shape (o, k, m, times), from those of the states."""
    beside = model.sensitivities
    assert beside is not None
    n, k, m, number = columns.shape
    whole = np.concatenate([states, columns.reshape(n * k, m, number)])
    r = np.concatenate([r, np.zeros((m, beside.further))], axis=1)
    further = replace(model, sampled=(*model.sampled, *beside.sampled))
    found = evaluate(further, beside.outputs, r, p, times, whole, lambda: False)
    return found.reshape(len(found) // k, k, m, number)


# -- one by one -----------------------------------------------------------------------------------


def _inputs(
    model: Model, r: np.ndarray, stopped: Callable[[], bool]
) -> Callable[[np.ndarray, float], np.ndarray]:
    """Return the function that gives all specifieds of one sample."""
    every = Inputs(r, model.sampled, model.functions)

    def inputs(x: np.ndarray, t: float) -> np.ndarray:
        if stopped():
            raise KeyboardInterrupt
        return every(x, t)

    return inputs


def _run_with_columns(
    model: Model,
    beside: EnsembleSensitivities,
    x: np.ndarray,
    r: np.ndarray,
    p: np.ndarray,
    times: np.ndarray,
    stopped: Callable[[], bool],
    states: np.ndarray | None,
) -> Results:
    """Integrate states with their sensitivities, where these are determined at the beginning."""
    from pydy._errors import warn_user

    (m, n), columns = x.shape, len(beside.names)
    r = np.concatenate([r, np.zeros((m, beside.further))], axis=1)
    t, sampled = float(times[0]), (*model.sampled, *beside.sampled)
    whole = np.empty((n * (1 + columns), m, len(times)))
    start, codes = np.empty((m, len(whole))), np.zeros(m, dtype=np.int64)
    for k in range(m):
        codes[k], values = beside.beginning(x[k], t, Inputs(r[k], sampled), p[k], _single)
        start[k, :n], start[k, n:] = x[k], values.ravel()

    def integrate(start: np.ndarray, r: np.ndarray, p: np.ndarray, into: np.ndarray) -> Results:
        if not model.in_lanes:
            return _run_one_by_one(model, start, r, p, times, stopped, into)
        kernel = _kernel(beside.rates, LANES)
        return _run_in_lanes(model, kernel, (start, r, p), sampled, times, stopped, into, n)

    started = codes == FINISHED
    if started.all():
        results = integrate(start, r, p, whole)
    else:
        warn_user(f"In one sample or more, {beside.unsolved}")
        part = np.empty((len(whole), int(started.sum()), len(times)))
        found = integrate(start[started], r[started], p[started], part)
        whole[:], whole[:n, :, 0], whole[:, started] = np.nan, x.T, part
        results = _among(found, started, codes, t)
    results.states = whole[:n]
    results.columns = whole[n:].reshape(n, columns, m, len(times))
    if states is not None:
        states[:] = results.states
        results.states = states
    return results


def _among(found: Results, started: np.ndarray, codes: np.ndarray, t: float) -> Results:
    """Return results among those of samples that did not start, which ended with these codes."""

    def placed(values: np.ndarray, others: Any) -> np.ndarray:
        every = np.full(len(codes), others, dtype=values.dtype)
        every[started] = values
        return every

    events, moments, resets = iter(found.events), iter(found.moments), iter(found.resets)
    return Results(
        found.states,
        placed(found.steps, 0),
        placed(found.rejected, 0),
        placed(found.evaluations, 0),
        placed(found.status, 0) + codes,
        placed(found.end_time, t),
        events=[next(events, []) if one else [] for one in started],
        moments=[next(moments, []) if one else [] for one in started],
        resets=[next(resets, []) if one else [] for one in started],
        nearness=None if found.nearness is None else placed(found.nearness, 1.0),
    )


def _run_one_by_one(
    model: Model,
    x: np.ndarray,
    r: np.ndarray,
    p: np.ndarray,
    times: np.ndarray,
    stopped: Callable[[], bool],
    states: np.ndarray,
) -> Results:
    """Integrate with the solver of single trajectories."""
    from pydy._errors import IntegrationError
    from pydy.solvers.run.integration import Integration

    (m, n), beside = x.shape, model.sensitivities
    kernel = _kernel(model.rates if beside is None else beside.rates, 1)
    sampled, options = model.sampled, model.options
    if beside is not None:
        sampled = (*sampled, *beside.sampled)
    counts = [np.zeros(m, dtype=np.int64) for _ in range(4)]
    states[:] = np.nan
    results = Results(states, counts[0], counts[1], counts[2], counts[3], np.full(m, times[0]))
    results.nearness = np.ones(m)
    jacobian, one = model.jacobian, None
    for k in range(m):
        if stopped():
            raise KeyboardInterrupt
        call = KernelCall(
            kernel,
            np.ascontiguousarray(p[k]),
            np.ascontiguousarray(r[k]),
            sampled,
            _inputs(model, r[k], stopped) if model.functions else None,
            lambda: model.states,
            None if jacobian is None else lambda: _kernel(jacobian, 1),
        )
        if beside is not None:
            options = replace(
                model.options, sensitivities=beside.compiled(x[k], r[k], p[k], _single)
            )
        same = one is not None and one.reusable and beside is None
        if one is None or not (same and one.rebind(call, times)):
            one = Integration(model.method, call, n, times, (), options, stopped)
        try:
            found = one.run(x[k])
            info = one.info()
        except IntegrationError as error:
            found, info = one.reached(), error.info
        results.states[:, k, : len(found)] = found.T
        _take(results, k, info)
    return results


def _take(results: Results, k: int, info: Mapping[str, Any]) -> None:
    results.steps[k], results.rejected[k] = info["steps"], info["rejected"]
    results.evaluations[k], results.status[k] = info["evaluations"], info["code"]
    results.end_time[k] = info["time"]
    records = info["events"]
    results.events.append([(record.index, record.time) for record in records])
    results.moments.append([record.time_sensitivity for record in records])
    results.resets.append([(e.time, e.after) for e in records if (e.after != e.before).any()])
    if results.nearness is not None:
        results.nearness[k] = info["nearness"]
