"""The unknowns z of a fit, and the Problem of each trial as a function of z.

z contains the parameters that all trials share, then the unknown initial conditions of each trial.
Shooting appends the states at the starts of segments.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._checks import (
    SymbolIndex,
    check_mapping,
    describe,
    merged,
    one_or_more,
    real_array,
    refuse_twice,
    shown,
)
from pydy._names import unique_names
from pydy._problem import (
    Problem,
    redefined,
    warn_of_contradictions,
    with_settings,
    with_unknowns,
)
from pydy._rank import DIGITS
from pydy._states import consistent, located, with_dependents
from pydy.analysis.bounds import limits
from pydy.analysis.fits.samples import TrialSamples, checked_trial
from pydy.analysis.fits.trial import Trial
from pydy.codegen import one_format, without

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, SymbolOrName

Numbers = dict[Any, Any]


@dataclass(frozen=True, eq=False)
class FittedSystem:
    """What a fit needs of a System."""

    problem: Problem
    solver: Callable[..., Any]  # its `ode_solver`


class FitProblem:
    """The parameters, samples, bounds and priors of a fit."""

    def __init__(
        self,
        model: FittedSystem,
        parameters: SymbolOrName | Iterable[SymbolOrName],
        trials: Sequence[object],
        events: object,
    ) -> None:
        self.model, self._events = model, events
        keys = one_or_more("parameters", parameters, hashable=True)
        constants: Numbers = dict.fromkeys(keys)
        for trial in trials:
            constants |= check_mapping("constants", getattr(trial, "constants", None))
        base = redefined(model.problem, events=events, constants=constants)
        if further := _constants_of_trials(base, trials):
            base = redefined(model.problem, events=events, constants=constants, further=further)
        self.base = self._latest = base
        definition = self.base.definition
        self._outputs: Numbers = {}  # names of measured expressions, and these
        self.trials = [
            checked_trial(k, trial, self.base, self._outputs) for k, trial in enumerate(trials)
        ]
        if len({d.trial.noise is None for d in self.trials}) > 1:
            raise ValueError("Give the `noise` of all trials, or of none.")
        self.noise_is_estimated = self.trials[0].trial.noise is None
        self.samples = sum(int(np.isfinite(d.values).sum()) for d in self.trials)
        self.dependents = tuple(definition.states[k] for k in self.base.dependent)
        self.states = definition.states
        equations = definition.equations
        movable = (*equations.coordinates, *equations.speeds)
        self.independent = [s for s in movable if s not in self.dependents]
        slots = [located(definition, key, "parameters") for key in keys]
        self.shared = [(kind, definition.places[kind].symbols[index]) for kind, index in slots]
        start = [self._starting_value(kind, index) for kind, index in slots]
        refuse_twice([symbol for _, symbol in self.shared], "parameters")
        self.names = list(unique_names([s for _, s in self.shared]))
        self.columns: list[int] = []  # of the first unknown initial condition of each trial
        self._initial = [self._initial_conditions(d) for d in self.trials]
        self._constants = [self._values("constants", d) for d in self.trials]
        self._specifieds = [self._values("specifieds", d) for d in self.trials]
        for d, initial in zip(self.trials, self._initial, strict=True):
            self.columns.append(len(self.names))
            self.names += [f"{unique_names([symbol])[0]} of {d.label}" for symbol in d.unknown]
            start += [initial[symbol] for symbol in d.unknown]
        self.count = len(self.names)  # of parameters, without the states of segments
        if not self.count:
            raise ValueError("`parameters` must name at least one constant or state.")
        self.start = np.array(start)
        self._problems: dict[int, Problem] = {}
        self.limits = np.empty(0), np.empty(0)
        self.priors: list[tuple[int, float, float]] = []

    def _starting_value(self, kind: str, index: int) -> float:
        """Return the number of a state, constant or specified at the initial time."""
        base = self.base
        if kind == "specifieds":
            return float(base.inputs.rows(base.x[None], np.array([base.t]))[0][index])
        return float((base.x if kind == "states" else base.p)[index])

    def _values(self, argument: str, d: TrialSamples) -> Numbers:
        """Return the values of a trial that are not parameters, by their symbols."""
        symbol_index, label = self.base.definition.places[argument], f"{argument} of {d.label}"
        parameters = {symbol for _, symbol in self.shared}
        for symbol in parameters.intersection(d.unknown):
            raise ValueError(
                f"`{symbol}` is unknown in {d.label}, and a parameter of all trials too."
            )
        values = _by_symbol(symbol_index, getattr(self.base.settings, argument), argument)
        trial = check_mapping(label, getattr(d.trial, argument))
        trial_values = _by_symbol(symbol_index, trial, label)
        given = {*_symbols_in(trial_values)}
        numbers = {s: v for s, v in trial_values.items() if isinstance(v, (int, float))}
        warn_of_contradictions(self.base, argument, numbers, f"`{label}` for ")
        if len(self.trials) > 1 and (conflicts := parameters & given):
            raise ValueError(
                f"`{label}` gives {describe([*conflicts])} a value of its own, but `parameters` "
                "names it, for all trials. Leave one of them out."
            )
        return without({**without(values, given), **trial_values}, parameters)

    def _initial_conditions(self, d: TrialSamples) -> dict[AnySymbol, float]:
        base, argument = self.base, f"initial_conditions of {d.label}"
        states = base.definition.places["states"]
        conditions = merged(check_mapping(argument, d.trial.initial_conditions))
        x = states.read(argument, conditions, base.x)
        chosen = states.chosen(conditions, argument)
        numbers = {s: x[k] for k, s in enumerate(states.symbols) if s in chosen}
        warn_of_contradictions(base, "states", numbers, f"`{argument}` for ")
        self._check_independent(d, x, numbers, argument)
        start = with_unknowns(base.at(np.array([d.start]), x[None]), {}, base.inputs.rows)
        return dict(zip(states.symbols, start.x[0].tolist(), strict=True))

    def _check_independent(
        self, d: TrialSamples, x: np.ndarray, numbers: Mapping[AnySymbol, float], argument: str
    ) -> None:
        """Refuse coordinates, or speeds, that the constraints replace by those of the System."""
        base, count = self.base, len(self.base.definition.equations.coordinates)
        states = base.definition.states
        unknown = {*d.unknown, *(symbol for kind, symbol in self.shared if kind == "states")}
        chosen = {*numbers, *unknown}
        for part in (range(count), range(count, len(states))):
            named = [k for k in part if states[k] in chosen]
            new = [k for k in named if k in base.dependent and numbers.get(states[k]) != base.x[k]]
            if not all(k in base.dependent for k in named):
                # Those that are named may be of another loop. Unknown ones are not solved for yet.
                new = [] if unknown else _replaced(base, x, new)
            if new:
                raise ValueError(
                    f"`{argument}` has {describe([states[k] for k in new])}, but the constraints "
                    f"are solved for {describe(self.dependents)}. Give independent ones, or call "
                    "set_dependent_initial_conditions(dep_vars=…) with other variables first."
                )

    # -- motions ----------------------------------------------------------------------------------

    def motion(
        self, z: np.ndarray, k: int, times: np.ndarray, column: int | None = None
    ) -> tuple[Problem, list[AnySymbol], list[int]]:
        """Return the Problem of a trial, the parameters that it depends on, and their columns.

        The motion starts from the initial conditions of the trial, or from the independent states
        z[column:] if a `column` is given.
        """
        constants, specifieds = dict(self._constants[k]), dict(self._specifieds[k])
        initial = dict(self._initial[k])
        symbols: list[AnySymbol] = []
        columns: list[int] = []
        for j, (kind, symbol) in enumerate(self.shared):
            if kind == "constants":
                constants[symbol] = float(z[j])
            elif kind == "specifieds":
                specifieds[symbol] = float(z[j])
            elif column is None:
                initial[symbol] = float(z[j])
            else:
                continue
            symbols.append(symbol)
            columns.append(j)
        states = self.trials[k].unknown if column is None else self.independent
        first = self.columns[k] if column is None else column
        for j, symbol in enumerate(states):
            initial[symbol] = float(z[first + j])
            symbols.append(symbol)
            columns.append(first + j)
        if k not in self._problems:
            self._problems[k] = self._trial_problem(constants, specifieds)
        trial_problem = with_settings(
            self._problems[k],
            constants=constants,
            specifieds=specifieds,
            initial_conditions=initial,
            times=times,
        )
        if self.dependents:
            trial_problem = with_dependents(trial_problem, self.dependents)
        return trial_problem, symbols, columns

    def _trial_problem(self, constants: Numbers, specifieds: Numbers) -> Problem:
        """Return a Problem with measured expressions as outputs, exempt from assumptions.

        Its specifieds may differ from the System's, its constants may not: expressions among the
        specifieds of a trial may contain functions of time that no other trial contains.
        """
        self._latest = redefined(
            self._latest,
            events=self._events,
            apart=self._latest is self.base,
            further=self.base.definition.constants,
            constants=constants,
            specifieds=specifieds,
            outputs={**self.base.settings.outputs, **self._outputs},
            contradicted=None,
            already_warned=set(),
        )
        return self._latest

    # -- bounds and priors of the parameters ------------------------------------------------------

    def read_known(self, z: np.ndarray, bounds: object, priors: object) -> np.ndarray:
        """Read bounds and priors; return z, clipped to the bounds.

        z may contain further unknowns after the parameters.
        """
        low, high = np.full(len(z), -np.inf), np.full(len(z), np.inf)
        for columns, pair in self._pairs(bounds, "bounds", limits):
            low[columns], high[columns] = pair
        self.limits = low, high
        pairs = self._pairs(priors, "priors", _mean_and_deviation)
        self.priors = [(column, *pair) for columns, pair in pairs for column in columns]
        if self.priors and self.noise_is_estimated:
            # Without it, the weight of a residual would depend on its unit, metre or millimetre.
            raise ValueError(
                "`priors` need the `noise` of each Trial: how much the samples count beside the "
                "priors follows from it. If it is not known, fit without `priors` first: "
                "`result.noise` of that fit estimates it."
            )
        inside: np.ndarray = np.clip(z, low, high)
        return inside

    def with_priors(
        self, values: np.ndarray, J: np.ndarray, z: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Append the priors' residuals and Jacobian rows to those of the measurements."""
        pulls = [(z[k] - mean) / s for k, mean, s in self.priors]
        rows = np.zeros((len(pulls), len(z)))
        rows[np.arange(len(pulls)), [k for k, _, _ in self.priors]] = [
            1.0 / s for _, _, s in self.priors
        ]
        return np.append(values, pulls), np.vstack([J, rows])

    def _pairs(
        self, pairs: object, argument: str, read: Callable[[object, str], tuple[float, float]]
    ) -> list[tuple[list[int], tuple[float, float]]]:
        """Return pairs of numbers with the columns of their parameters, none of them twice."""
        pairs = check_mapping(argument, pairs)
        columns = [self._columns_of(key, argument) for key in pairs]
        refuse_twice([self.names[k] for several in columns for k in several], argument)
        return [
            (several, read(pair, f"`{argument}[{key}]`"))
            for several, (key, pair) in zip(columns, pairs.items(), strict=True)
        ]

    def _columns_of(self, key: SymbolOrName, argument: str) -> list[int]:
        """Return the columns of the parameters that a key names; a state is that of each trial."""
        shared = SymbolIndex([s for _, s in self.shared], "parameters of the fit")
        index = shared.get(key, argument)
        if index is not None:
            return [index]
        matches = []
        for d, column in zip(self.trials, self.columns, strict=True):
            index = SymbolIndex(d.unknown, "unknown initial conditions").get(key, argument)
            if index is not None:
                matches.append(column + index)
        if not matches:
            unknown = {s: 0 for d in self.trials for s in d.unknown}
            SymbolIndex([*shared.symbols, *unknown], "parameters of the fit").find(key, argument)
        return matches

    def sizes(self, states: np.ndarray) -> np.ndarray:
        """Return sizes of parameters: start values, and state sizes for initial conditions."""
        result: np.ndarray = np.abs(self.start)
        shared = [s if kind == "states" else None for kind, s in self.shared]
        for k, symbol in enumerate([*shared, *(s for d in self.trials for s in d.unknown)]):
            if symbol is not None:
                result[k] = states[self.states.index(symbol)]
        return result


def _constants_of_trials(base: Problem, trials: Sequence[object]) -> set[AnySymbol]:
    """Return the constants that only expressions for specifieds of trials contain.

    They are constants of all trials, so that these have the same constants in the same order.
    """
    definition, settings = base.definition, base.settings
    symbol_index, builder = definition.places["specifieds"], copy(base.model.builder)
    further: set[AnySymbol] = set()
    for k, trial in enumerate(trials):
        label = f"specifieds of trial {k}"
        if not isinstance(trial, Trial) or not trial.specifieds:
            continue
        values = _by_symbol(symbol_index, settings.specifieds, "specifieds")
        given = _by_symbol(symbol_index, check_mapping(label, trial.specifieds), label)
        values = {**without(values, {*_symbols_in(given)}), **given}
        of_trial = builder.definition(settings.outputs, settings.forces, values, {})
        further.update(of_trial.constants)
    return further.difference(definition.constants)


def _by_symbol(symbol_index: SymbolIndex, values: Mapping[Any, Any], label: str) -> Numbers:
    """Return constants, or specifieds in either format, by symbols and tuples of symbols."""
    first_format, _ = one_format(values, label)
    return symbol_index.by_symbol(merged(first_format), label, allow_others=True)


def _symbols_in(values: Iterable[Any]) -> Iterator[Any]:
    """Yield the keys of a dictionary, and those in its tuples."""
    for key in values:
        yield from key if isinstance(key, tuple) else (key,)


def _mean_and_deviation(value: object, subject: str) -> tuple[float, float]:
    numbers = real_array(value, subject)
    if numbers.shape != (2,) or not np.isfinite(numbers).all() or not numbers[1] > 0.0:
        raise ValueError(
            f"{subject} must be a pair of the mean and the positive standard deviation, got "
            f"{shown(value)}."
        )
    return float(numbers[0]), float(numbers[1])


def _replaced(base: Problem, x: np.ndarray, states: Sequence[int]) -> list[int]:
    """Return those states that the constraints solve for as they do at the System's own start.

    The state `x` has other numbers in their places.
    """
    if not states:
        return []
    before, after = consistent(base).x[states], consistent(base.replace(x=x)).x[states]
    requested = x[states]
    unchanged = np.abs(after - before) <= DIGITS * np.maximum(np.abs(after), np.abs(before))
    different = np.abs(after - requested) > DIGITS * np.maximum(np.abs(after), np.abs(requested))
    return [k for k, is_replaced in zip(states, unchanged & different, strict=True) if is_replaced]
