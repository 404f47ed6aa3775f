"""The work on one block of an ensemble: integrate, check, reduce, and name the results."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._assembly import Assumptions, errors_of
from pydy._checks import shown
from pydy._dataset import SENSITIVITY
from pydy._errors import warn_not_finite, warn_user
from pydy._interpolation import evenly
from pydy._judges import WatchedQuantities, jump_message
from pydy._kernel import Inputs
from pydy._names import numbers_of, some
from pydy._program import Program, run as interpret
from pydy._rank import DIGITS
from pydy.ensemble.model import COUNTED, Batch, ConstraintChecks, EnsembleModel, Results
from pydy.ensemble.samples import PARAMETER, QUANTITY, LabelledArray, Samples, to_dataset
from pydy.solvers import (
    ConstraintResiduals,
    DriftCheck,
    Outcome,
)

if TYPE_CHECKING:
    from xarray import Dataset, Variable

    from pydy._sympy_types import SymbolOrName
    from pydy.ensemble.model import ProgramsByName

SMALLEST_BLOCK = 64
"""Fewest samples in a block: in smaller ones, lanes are idle too long at the end."""

_OCCURRENCES = 8
_INTERPRETED = 8_000_000  # largest number of values that are interpreted at a time

COUNTS = (*COUNTED, "end_time")
"""Variables of the result for each sample, besides states and outputs."""


@dataclass(frozen=True)
class Extreme:
    """The largest or smallest value of a state or output."""

    kind: str
    name: str


@dataclass(frozen=True)
class _Final:
    """States and outputs at the last time, or after the terminal event that ended the motion."""


@dataclass(frozen=True)
class _EventTimes:
    """The times of the first occurrences of each event."""

    occurrences: int


Reduction = Extreme | _Final | _EventTimes | Callable[["Dataset"], object]
_Outputs = Callable[[np.ndarray, np.ndarray], np.ndarray]  # of times and states
_Slopes = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]  # and of their sensitivities


def _refusal(entry: object) -> str:
    return (
        "`reduce` must be 'final', ('max', name), ('min', name), 'events', ('events', number), a "
        f"function of a Dataset, or a list of these, got {shown(entry)}."
    )


def read_reductions(
    reduce: Any, model: EnsembleModel, name: Callable[[SymbolOrName], str]
) -> tuple[Reduction, ...]:
    """Check the argument `reduce`; `name` turns a symbol into its name."""
    if reduce is None:
        return ()
    entries = reduce if isinstance(reduce, list) else [reduce]
    names = (*model.states, *model.output_names)
    result: list[Reduction] = []
    for entry in entries:
        kind, *arguments = entry if isinstance(entry, tuple) and entry else (entry,)
        if callable(kind) and not arguments:
            result.append(kind)
        elif not isinstance(kind, str):
            raise ValueError(_refusal(entry))
        elif kind == "final" and not arguments:
            result.append(_Final())
        elif kind in ("max", "min") and len(arguments) == 1:
            if name(arguments[0]) not in names:
                raise ValueError(
                    f"`reduce` asks for the {kind} of `{arguments[0]}`, which is neither a state "
                    f"nor an output: {some(names)}."
                )
            result.append(Extreme(kind, name(arguments[0])))
        elif kind == "events" and len(arguments) < 2:
            number = arguments[0] if arguments else _OCCURRENCES
            if not model.event_names:
                raise ValueError("`reduce='events'` needs `events`, a list of pydy.solvers.Event.")
            if isinstance(number, bool) or not isinstance(number, int) or number < 1:
                raise ValueError(f"`reduce` must have how many events to keep, got {number!r}.")
            result.append(_EventTimes(number))
        else:
            raise ValueError(_refusal(entry))
    _refuse_twice([(name, entry) for entry in result for name in _produced(entry, model)])
    functions = [entry for entry in result if callable(entry)]
    if functions and len(result) > 1:
        raise ValueError(
            "`reduce` must be one function alone, or a list of the other reductions; a function "
            "can do what they do."
        )
    return tuple(result)


def _produced(entry: Reduction, model: EnsembleModel) -> Sequence[str]:
    """Return the names of a reduction's results; those of a function are unknown beforehand."""
    if isinstance(entry, Extreme):
        return [f"{entry.name}_{entry.kind}"]
    if isinstance(entry, _Final):
        return (*model.states, *model.output_names)
    names = model.event_names if isinstance(entry, _EventTimes) else ()
    return [f"{name}_{part}" for name in names for part in ("count", "times")]


def _refuse_twice(produced: Sequence[tuple[str, Reduction]]) -> None:
    """Raise an error if two reductions have results of the same name."""
    by_name: dict[str, Reduction] = {}
    for name, entry in produced:
        if by_name.setdefault(name, entry) is entry and name not in COUNTS:
            continue
        if by_name[name] == entry and name not in COUNTS:
            raise ValueError(f"`reduce` asks for `{name}` twice. Leave one of the two entries out.")
        raise ValueError(
            f"`reduce` gives two results the name `{name}`. Rename the output or the event that it "
            "comes from."
        )


@dataclass(frozen=True, eq=False)
class Work:
    """The work on each block; this object is sent to the workers."""

    model: EnsembleModel
    reductions: tuple[Reduction, ...]  # empty: the result contains all times
    attrs: Mapping[str, Mapping[str, object]]  # attributes of variables, by name
    warned: dict[str, object] = field(default_factory=dict)  # the kinds of warnings so far
    assumed: Assumptions | None = None  # SymPy's assumptions of the states
    contradicted: set[str] | None = None  # symbols already warned of; None: assumptions not checked

    @property
    def function(self) -> Callable[[Dataset], Any] | None:
        """The user's own reduction."""
        return next((f for f in self.reductions if callable(f)), None)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of states and outputs."""
        return (*self.model.states, *self.model.output_names)

    def __call__(
        self,
        samples: Samples,
        stopped: Callable[[], bool] = lambda: False,
        states: np.ndarray | None = None,
    ) -> dict[str, LabelledArray]:
        """Return the results for some samples, with the dimensions of samples first.

        The states at all times are written into the array `states` (n, m, times) unless None.
        """
        model, times = self.model, self.model.times
        of_ends = self.reductions and all(
            isinstance(r, _Final | _EventTimes) for r in self.reductions
        )
        if of_ends and model.options.step is None:
            # Steps do not depend on the times, except those of a fixed size, which divide the
            # intervals between them. A few times suffice to check what is checked along the
            # motion; a sample that an event ended early has no state at the last time.
            checked = self.assumed is not None or model.constraint_checks is not None
            times = times[evenly(len(times), DriftCheck.MOST_STATES if checked else 2)]
        events = model.options.events
        ends_early = events is not None and any(trait.terminal for trait in events.traits)
        kinds = {*map(type, self.reductions)}
        logs = model.constraint_checks is not None or _EventTimes in kinds
        logs = logs or (_Final in kinds and ends_early)
        batch = Batch(model, *samples.rows(), stopped, logs)
        results = batch.run(times, states)
        if model.constraint_checks is not None:
            if not (model.constraint_checks.corrected or model.options.constraints is not None):
                self._warn_of_resets(batch, results, model.constraint_checks)
            invalidate_drifted(batch, results, times)
        if number := int((results.statistics["status"] == Outcome.START_OFF_CONSTRAINTS).sum()):
            self._warn_of_failed_starts(number, batch)
        if model.sensitivities is not None and (watched := model.sensitivities.watched) is not None:
            self._warn_of_jumps(batch, times, watched)
        if results.event_warnings and self._first("stretches"):
            warn_user(results.event_warnings[0])
        if self.assumed is not None and self.contradicted is not None:
            self._warn_of_assumptions(self.assumed, self.contradicted, results.states, times)
        outputs: _Outputs = partial(batch.evaluate, model.outputs)
        if (values := results.outputs) is not None:
            outputs = lambda at, _: values[:, :, np.searchsorted(times, at)]  # noqa: E731
        reduced = self._reduced(results, times, outputs, batch.output_columns)
        if _Final in kinds:
            self._add_early_ends(reduced, batch, results)
        for name in COUNTS:
            reduced[name] = LabelledArray((), results.statistics[name])
        shape, dims = samples.shape, tuple(samples.dims)
        variables = {
            name: LabelledArray(
                (*dims, *v.dims), v.values.reshape((*shape, *v.values.shape[1:])), v.attrs
            )
            for name, v in reduced.items()
        }
        variables = self._described(variables)
        return self._by_function(variables, samples) if self.function else variables

    def _first(self, kind: str) -> bool:
        """Return whether this is the first warning of its kind in all blocks."""
        mine = object()
        return self.warned.setdefault(kind, mine) is mine

    def _warn_of_failed_starts(self, number: int, batch: Batch) -> None:
        """Warn of samples that did not start."""
        if self._first("start"):
            warn_user(
                f"{number} of {len(batch.x)} samples, and maybe others, do not begin on the "
                "constraints, nor so near that they are projected onto them, or with a contact's "
                "gap that is negative: they are NaN, of the "
                f"`status` {Outcome.START_OFF_CONSTRAINTS}. Dependent initial conditions are "
                "those of the System unless they are passed, also where constants or other initial "
                "conditions vary: pass those of each sample in `initial_conditions`."
            )

    def _warn_of_assumptions(
        self, assumed: Assumptions, warned: set[str], states: np.ndarray, times: np.ndarray
    ) -> None:
        """Warn once of the states (n, m, times) that contradict their assumptions."""
        options = self.model.options
        for k in assumed.suspects(states):
            if {assumed.names[column] for column in assumed.columns} <= warned:
                return
            rows = states[:, k].T
            allowed = errors_of(rows, options.rtol, options.atol)
            if options.step is not None:
                allowed = errors_of(rows, 1.0)  # a method without error control

            def position(row: int) -> str:
                return f" at t = {times[row]:g} in one sample or more"

            assumed.tell(rows, warned, "", where=position, allowed=allowed, in_time=True)

    def _warn_of_resets(self, batch: Batch, results: Results, checks: ConstraintChecks) -> None:
        """Warn of the first reset of each event that violates the constraints."""
        records = [(k, e) for k in results.recorded() for e in results.resets(k)]
        if not records:
            return
        samples, t = [k for k, _ in records], np.array([[e.time] for _, e in records])
        before, after = (
            _values(batch, checks.programs, "bounds", samples, t, np.array(states)[:, None])
            for states in zip(*((e.before, e.after) for _, e in records), strict=True)
        )
        for k, (_, record) in enumerate(records):
            quantities = {name: values[k] for name, values in after.items()}
            rounding = ConstraintResiduals.rounding(
                quantities, quantities["sizes"], record.after[None]
            )
            residuals = ConstraintResiduals(
                quantities["rows"][0], (DIGITS * quantities["sizes"] + rounding)[0]
            )
            off = residuals.after_reset(before["rows"][k][0]).describe(record.time, checks.names)
            if off and self._first(f"reset of {record.name}"):
                subject = "In one sample or more, the"
                ConstraintResiduals.warn_of_reset(record.name, off, subject)

    def _warn_of_jumps(self, batch: Batch, times: np.ndarray, watched: WatchedQuantities) -> None:
        """Warn of the first of some samples with a discontinuity that its derivatives miss."""
        for k in evenly(len(batch.x), DriftCheck.MOST_STATES).tolist():
            if "jumps" in self.warned or batch.stopped():
                return
            motion = batch.motion_path(k, times)
            if motion is None:
                continue
            passed, states = motion

            def evaluate(
                t: np.ndarray, k: int = k, states: Callable[[np.ndarray], np.ndarray] = states
            ) -> dict[str, np.ndarray]:
                blocks = _values(batch, {"nodes": watched.nodes}, "nodes", [k], t, states(t)[None])
                return {name: values[0] for name, values in blocks.items()}

            if (message := jump_message(passed, watched, evaluate)) and self._first("jumps"):
                warn_user(f"In one sample or more: {message[0].lower()}{message[1:]}")

    def _warn_of_outputs(self, outputs: np.ndarray, times: np.ndarray, states: np.ndarray) -> None:
        """Warn of outputs (o, m, times) that are not finite where states (n, m, times) are."""
        wrong = ~np.isfinite(outputs) & np.isfinite(states).all(axis=0)
        if not wrong.any() or not self._first("outputs"):
            return

        def position(k: int) -> tuple[str, None]:
            sample, time = divmod(k, len(times))
            state = numbers_of(self.model.states, states[:, sample, time])
            return f"t = {float(times[time])!r} in the state {state}", None

        warn_not_finite(wrong.reshape(len(outputs), -1).T, self.model.output_names, position)

    def _described(self, variables: dict[str, LabelledArray]) -> dict[str, LabelledArray]:
        attributes = {**self.attrs, **_STATISTICS}
        return {
            name: LabelledArray(v.dims, v.values, {**v.attrs, **attributes.get(name, {})})
            for name, v in variables.items()
        }

    def _values(
        self, names: Sequence[str], states: np.ndarray, times: np.ndarray, outputs: _Outputs
    ) -> dict[str, np.ndarray]:
        """Return states and outputs by name, each of the shape (m, times)."""
        values = dict(zip(self.model.states, states, strict=True))
        if not set(names) <= set(values):
            computed = outputs(times, states)
            if not np.isfinite(computed).all():
                self._warn_of_outputs(computed, times, states)
            values |= dict(zip(self.model.output_names, computed, strict=True))
        return values

    def _reduced(
        self, results: Results, times: np.ndarray, outputs: _Outputs, output_columns: _Slopes
    ) -> dict[str, LabelledArray]:
        """Return the reductions of states and outputs, and their sensitivities.

        The derivative of an extreme value is the derivative at its time, which is one of the times.
        """
        states, columns = results.states, results.columns
        reduced: dict[str, LabelledArray] = {}
        slopes: list[np.ndarray] = []  # of each result by the parameters, (k, m)

        def derivatives(part: slice) -> np.ndarray:
            """Return the sensitivities of all states and outputs, shape (q, k, m, times)."""
            assert columns is not None
            selected = columns[..., part]
            return np.concatenate(
                [selected, output_columns(times[part], states[..., part], selected)]
            )

        def as_variable(dims: tuple[str, ...], table: np.ndarray) -> LabelledArray:
            contiguous = np.ascontiguousarray(table)
            return LabelledArray((*dims, QUANTITY, PARAMETER), contiguous, {"role": SENSITIVITY})

        if not self.reductions or self.function:
            values = self._values(self.names, states, times, outputs)
            reduced = {name: LabelledArray(("time",), values[name]) for name in self.names}
            if columns is not None:
                every = derivatives(slice(None))
                for name, slope in zip(self.names, every, strict=True):
                    _drop_where_unknown(slope, values[name])
                reduced[SENSITIVITY] = as_variable(("time",), every.transpose(2, 3, 0, 1))
            return reduced
        extremes = [e for e in self.reductions if isinstance(e, Extreme)]
        values_by_name = self._values([e.name for e in extremes], states, times, outputs)
        all_derivatives = derivatives(slice(None)) if extremes and columns is not None else None
        for entry in self.reductions:
            if isinstance(entry, Extreme):
                values_along = values_by_name[entry.name]
                take = np.fmax if entry.kind == "max" else np.fmin  # NaN if all are NaN
                attrs = dict(self.attrs.get(entry.name, {}))
                extreme = LabelledArray((), take.reduce(values_along, axis=1), attrs)
                reduced[f"{entry.name}_{entry.kind}"] = extreme
                if all_derivatives is not None:
                    upward = values_along if entry.kind == "max" else -values_along
                    when = np.where(np.isnan(upward), -np.inf, upward).argmax(axis=1)
                    slope = all_derivatives[self.names.index(entry.name)][
                        :, np.arange(len(when)), when
                    ]
                    _drop_where_unknown(slope, extreme.values)
                    slopes.append(slope)
            elif isinstance(entry, _Final):
                last = self._values(self.names, states[:, :, -1:], times[-1:], outputs)
                reduced |= {name: LabelledArray((), last[name][:, 0].copy()) for name in self.names}
                if columns is not None:
                    ends = derivatives(slice(-1, None))[..., 0]
                    for name, slope in zip(self.names, ends, strict=True):
                        _drop_where_unknown(slope, last[name][:, 0])
                    slopes += list(ends)
            elif isinstance(entry, _EventTimes):
                reduced |= self._events(results, entry.occurrences)
        if slopes:
            reduced[SENSITIVITY] = as_variable((), np.array(slopes).transpose(2, 0, 1))
        return reduced

    def _add_early_ends(
        self, reduced: dict[str, LabelledArray], batch: Batch, results: Results
    ) -> None:
        """Write the states and outputs of samples that a terminal event ended, after the event.

        They have no values at the last time. Their derivatives stay NaN.
        """
        ended = np.flatnonzero(results.statistics["status"] == Outcome.TERMINATED)
        if not len(ended):
            return
        times, states = results.last_events(ended)
        for name, row in zip(self.model.states, states, strict=True):
            reduced[name].values[ended] = row
        if not self.model.output_names:
            return
        if self.model.motions is None:
            program, x = self.model.outputs, states.T[:, None]
            assert program is not None
            outputs = _evaluated(batch, program, ended.tolist(), times[:, None], x)[:, 0]
        else:
            outputs = np.array([results.end_outputs[k] for k in ended.tolist()])
        for name, column in zip(self.model.output_names, outputs.T, strict=True):
            reduced[name].values[ended] = column
        wrong = np.flatnonzero(~np.isfinite(outputs).all(axis=1))
        for j in wrong[:1]:
            self._warn_of_outputs(outputs[j, :, None, None], times[[j]], states[:, [j], None])

    @property
    def labels(self) -> dict[str, list[str]]:
        """The labels along the dimensions of sensitivities."""
        if not self.model.columns:
            return {}
        quantities = [*self.names]
        if self.reductions and not self.function:
            reductions = [e for e in self.reductions if not isinstance(e, _EventTimes)]
            quantities = [name for entry in reductions for name in _produced(entry, self.model)]
        return {QUANTITY: quantities, PARAMETER: list(self.model.columns)}

    def _events(self, results: Results, occurrences: int) -> dict[str, LabelledArray]:
        """Return the number of occurrences of each event, the first times, their derivatives."""
        m, columns = len(results.statistics["status"]), len(self.model.columns)
        variables = {}
        for index, name in enumerate(self.model.event_names):
            count, when = results.occurrences(index, occurrences)
            slopes = np.full((m, occurrences, columns), np.nan)
            for k, records in results.records.items() if columns else ():
                mine = [record for record in records if record.index == index]
                for occurrence, record in enumerate(mine[:occurrences]):
                    if record.time_sensitivity is not None:
                        slopes[k, occurrence] = record.time_sensitivity
            variables[f"{name}_count"] = LabelledArray((), count, {"role": "event"})
            variables[f"{name}_times"] = LabelledArray(("occurrence",), when, {"role": "event"})
            if columns:
                variables[f"{name}_times_{SENSITIVITY}"] = LabelledArray(
                    ("occurrence", PARAMETER), slopes, {"role": SENSITIVITY}
                )
        return variables

    def _by_function(
        self, variables: dict[str, LabelledArray], samples: Samples
    ) -> dict[str, LabelledArray]:
        """Call the user's function and check its result."""
        assert self.function is not None
        dataset = to_dataset(variables, samples.coordinates, self.model.times, labels=self.labels)
        labels = {name: dataset.variables[name] for name in dataset.coords}
        try:
            result = self.function(dataset)
        except Exception as error:
            error.add_note("This came from the function given as `reduce`, called with a Dataset.")
            raise
        if hasattr(result, "to_dataset") and not hasattr(result, "data_vars"):
            result = result.to_dataset(name=result.name or "result")
        if not hasattr(result, "data_vars"):
            raise TypeError(
                f"`reduce` must return an xarray.Dataset or DataArray, got {type(result).__name__}."
            )
        if moved := [name for name, expected in labels.items() if _differs(result, name, expected)]:
            raise ValueError(
                f"`reduce` must leave samples and times in their places: `{moved[0]}` differs in "
                "what it returns. Rename a dimension along which it selects or sorts."
            )
        dims = tuple(samples.dims)
        reduced = {}
        for name, array in result.data_vars.items():
            missing = [d for d in dims if array.sizes.get(d) != samples.dims[d]]
            if missing:
                raise ValueError(
                    f"`reduce` must keep the sample dimensions {', '.join(dims)} in what it "
                    f"returns: `{name}` has {dict(array.sizes)}."
                )
            array = array.transpose(*dims, ...)
            reduced[str(name)] = LabelledArray(array.dims, np.asarray(array), dict(array.attrs))
        return {**{name: variables[name] for name in COUNTS}, **reduced}


def _drop_where_unknown(slopes: np.ndarray, values: np.ndarray) -> None:
    """Set the derivatives (k, ...) of values (...) that are NaN to NaN, in place.

    A Piecewise without a matching branch is a constant NaN, with the derivative 0.
    """
    unknown = np.isnan(values)
    if unknown.any():
        slopes[:, unknown] = np.nan


def _differs(result: Any, name: Hashable, expected: Variable) -> bool:
    """Return whether a Dataset's labels, or their sizes, differ from the expected ones."""
    if name in result.coords:
        actual = result.variables[name]
        return set(actual.dims) == set(expected.dims) and not actual.transpose(
            *expected.dims
        ).equals(expected)
    return any(result.sizes.get(d, size) != size for d, size in expected.sizes.items())


_STATISTICS: dict[str, dict[str, object]] = {
    "status": {
        "long_name": "how the integration ended",
        "flag_values": [int(outcome) for outcome in Outcome],
        "flag_meanings": " ".join(outcome.flag for outcome in Outcome),
    },
    "steps": {"long_name": "accepted steps"},
    "rejected": {"long_name": "rejected steps"},
    "evaluations": {"long_name": "evaluations of the equations"},
    "end_time": {"long_name": "time up to which the sample was integrated"},
}


# -- Checks of constraints and energy, sample by sample --------------------------------------------


def invalidate_drifted(batch: Batch, results: Results, times: np.ndarray) -> None:
    """Set samples that fail the drift checks to NaN after the last valid time.

    The model has constraints. Checked are all samples with a valid motion, also those that an event
    ended early.
    """
    model, checks = batch.model, batch.model.constraint_checks
    assert checks is not None
    projected = model.options.constraints is not None
    statistics = results.statistics
    valid = np.isin(statistics["status"], [outcome for outcome in Outcome if outcome.is_valid])
    if projected:
        valid &= checks.every | (statistics["nearness"] < DriftCheck.NEAR_SINGULAR)
    suspects = np.flatnonzero(valid)
    if not projected:
        suspects = _suspects(batch, checks.programs, suspects, results.states, times)
    for samples in _groups_by_end(results.states, suspects):
        time_indices = DriftCheck.selected(results.states[:, samples[0]].T, projected)
        at, examined = times[time_indices], samples
        if projected and len(time_indices):
            examined = examined[_needing_reports(batch, results, examined, time_indices, at)]
        for start in range(0, len(examined), SMALLEST_BLOCK):
            chunk = examined[start : start + SMALLEST_BLOCK]
            states = _states_at(results, chunk, time_indices)
            part_of = _batched_quantities(batch.select(chunk), checks.programs, at, states)
            for j, k in enumerate(chunk.tolist()):
                check = DriftCheck(
                    at,
                    states[j],
                    float(statistics["steps"][k]) if model.options.step is None else None,
                    model.options.rtol,
                    model.options.atol,
                    float(statistics["nearness"][k]) if projected else None,
                    projected or checks.corrected,
                    [(e.time, e.after) for e in results.resets(k)],
                    checks.redundant,
                )
                report = check.report(partial(part_of, j))
                if report is not None:
                    reached = time_indices[max(0, report.state_index - 1)] + 1
                    _invalidate(results, k, times, reached, report.outcome)


def _groups_by_end(states: np.ndarray, samples: np.ndarray) -> list[np.ndarray]:
    """Return groups of samples with finite states at the same times."""
    finite = np.isfinite(states).all(axis=0)[samples]
    group = np.unique(finite, axis=0, return_inverse=True)[1].reshape(-1)
    return [samples[group == k] for k in range(group.max(initial=-1) + 1)]


def _states_at(results: Results, samples: np.ndarray, time_indices: np.ndarray) -> np.ndarray:
    """Return the states (m, f, n) of some samples at some times."""
    return results.states[:, samples][:, :, time_indices].transpose(1, 2, 0).copy()


def _needing_reports(
    batch: Batch, results: Results, samples: np.ndarray, time_indices: np.ndarray, times: np.ndarray
) -> np.ndarray:
    """Return which projected samples `DriftCheck.report` must examine.

    The others satisfy all constraints to six digits, far from a loss of rank.
    """
    checks = batch.model.constraint_checks
    assert checks is not None
    needed: np.ndarray = results.statistics["nearness"][samples] < DriftCheck.NEAR_SINGULAR
    if checks.programs["contradictions"] is not None:
        return np.ones(len(samples), dtype=bool)
    if (program := checks.programs["rows"]) is not None and checks.redundant:
        number = max(SMALLEST_BLOCK, _INTERPRETED // (len(times) * len(program.ops)))
        for start in range(0, len(samples), number):
            chunk = samples[start : start + number]
            states = _states_at(results, chunk, time_indices)
            blocks = _values(batch, checks.programs, "rows", chunk.tolist(), times, states)
            needed[start : start + number] |= DriftCheck.exceeds_six_digits(
                blocks["rows"], blocks["sizes"]
            )
    return needed


def _batched_quantities(
    batch: Batch, programs: ProgramsByName, times: np.ndarray, states: np.ndarray
) -> Callable[..., dict[str, np.ndarray]]:
    """Return a function that evaluates `DriftQuantities` of one of m samples, states (m, f, n).

    Quantities at these times are evaluated for all samples at once.
    """
    cache: dict[str, dict[str, np.ndarray]] = {}

    def part(j: int, name: str, t: np.ndarray, x: np.ndarray) -> dict[str, np.ndarray]:
        if t is not times:
            blocks, row = _values(batch, programs, name, [j], t, x[None]), 0
        else:
            if name not in cache:
                cache[name] = _values(batch, programs, name, range(len(states)), t, states)
            blocks, row = cache[name], j
        return {name: values[row] for name, values in blocks.items()}

    return part


def _values(
    batch: Batch,
    programs: ProgramsByName,
    name: str,
    samples: Sequence[int],
    t: np.ndarray,
    x: np.ndarray,
) -> dict[str, np.ndarray]:
    """Return the values (m, f, ·) of a Program along m of the samples; times are (f,) or (m, f)."""
    program = programs[name]
    if program is None:
        return {}
    blocks: dict[str, np.ndarray] = program.signature.by_block(
        _evaluated(batch, program, samples, t, x)
    )
    return blocks


def _evaluated(
    batch: Batch, program: Program, samples: Sequence[int], t: np.ndarray, x: np.ndarray
) -> np.ndarray:
    """Return the values (m, f, o) of a Program along m of the samples, by interpretation."""
    (m, f, n), t, sample_indices = x.shape, np.broadcast_to(t, x.shape[:2]), list(samples)
    r, p = (np.repeat(rows[sample_indices], f, axis=0) for rows in (batch.r, batch.p))
    if batch.model.sampled or batch.model.functions:
        for k, (j, states, times) in enumerate(zip(sample_indices, x, t, strict=True)):
            inputs = Inputs(batch.r[j], batch.model.sampled, batch.model.functions)
            r[k * f : (k + 1) * f] = inputs.rows(states, times)
    flat, _ = interpret(program, t.ravel(), x.reshape(m * f, n), r, p)
    return flat.reshape(m, f, -1)


def _suspects(
    batch: Batch, programs: ProgramsByName, valid: np.ndarray, states: np.ndarray, times: np.ndarray
) -> np.ndarray:
    """Return which of the valid samples need a full check, from a vectorised check of all.

    These have constraint residuals beyond six digits, or come near a loss of rank. Samples that an
    event ended early, whose last states are NaN, are not screened and need it, too.
    """
    complete = valid[np.isfinite(states[:, valid, -1]).all(axis=0)]
    if not len(complete):
        return valid
    program = programs["screen"]
    assert program is not None
    time_indices = DriftCheck.selected(states[:, complete[0]].T, projected=False)
    # A million residuals and derivatives are evaluated at a time.
    number = max(1, 1_000_000 // (len(time_indices) * max(1, program.signature.num_outputs)))
    suspects = [np.setdiff1d(valid, complete)]
    for start in range(0, len(complete), number):
        chunk = complete[start : start + number]
        x = np.ascontiguousarray(states[:, chunk][:, :, time_indices])
        out = batch.select(chunk).evaluate(program, times[time_indices], x)
        blocks = program.signature.by_block(np.moveaxis(out, 0, -1))  # (m, times, values)
        suspect = DriftCheck.exceeds_six_digits(blocks["rows"], blocks["sizes"])
        if batch.model.options.step is None:
            suspect |= DriftCheck.nearly_loses_rank(blocks["products"])
        suspects.append(chunk[suspect])
    return np.unique(np.concatenate(suspects))


def _invalidate(results: Results, k: int, times: np.ndarray, reached: int, code: int) -> None:
    """Set a sample to NaN from a time on, and its status to an error code."""
    results.states[:, k, reached:] = np.nan
    if results.columns is not None:
        results.columns[:, :, k, reached:] = np.nan
    end = results.statistics["end_time"][k] = times[reached - 1]
    results.statistics["status"][k] = code
    results.records[k] = [record for record in results.events_of(k) if record.time <= end]
