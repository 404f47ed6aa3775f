"""What a fit searches for: its unknown numbers z, and the Problem that they make of each trial.

z has the parameters that all trials share, then the unknown initial conditions of each trial.
Shooting appends the states at the beginnings of segments.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pydy._checks import (
    Places,
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
    AssumptionChecks,
    CallArguments,
    Problem,
    with_settings,
    with_unknowns,
)
from pydy._states import located, with_dependents
from pydy.analysis.bounds import limits
from pydy.analysis.fits.samples import Samples, checked_trial

Numbers = dict[Any, Any]


@dataclass(frozen=True, eq=False)
class FittedSystem:
    """A System as a fit takes it."""

    # The Problem of the System, with the constants that events and the keys of a dictionary bring.
    problem: Callable[[Any, Mapping[Any, Any]], Problem]
    # The Problem of events, further outputs, constants and specifieds; its numbers are only tried.
    tried: Callable[[Any, Numbers, Numbers, Numbers], Problem]
    solver: Any  # the System's `ode_solver`
    contacts: Any = None  # Contacts that simulate the Problems that are tried


class FitProblem:
    """The parameters, the samples, and what is known beside them."""

    def __init__(
        self, model: FittedSystem, parameters: Any, trials: Sequence[Any], events: Any
    ) -> None:
        self.model, self._events = model, events
        keys = one_or_more("parameters", parameters, hashable=True)
        constants: Numbers = dict.fromkeys(keys)
        for trial in trials:
            constants |= check_mapping("constants", getattr(trial, "constants", None))
        self.now = model.problem(events, constants)
        definition = self.now.definition
        self._outputs: Numbers = {}  # names of measured expressions, and these
        self.trials = [
            checked_trial(k, trial, definition, self._outputs) for k, trial in enumerate(trials)
        ]
        if len({d.trial.noise is None for d in self.trials}) > 1:
            raise ValueError("Give the `noise` of all trials, or of none.")
        self.noise_is_estimated = self.trials[0].trial.noise is None
        self.samples = sum(int(np.isfinite(d.values).sum()) for d in self.trials)
        self.dependents = tuple(definition.states[k] for k in self.now.dependent)
        self.states = definition.states
        equations = definition.equations
        movable = (*equations.coordinates, *equations.speeds)
        self.independent = [s for s in movable if s not in self.dependents]
        places = [located(definition, key, "parameters") for key in keys]
        self.shared = [(kind, definition.places[kind].symbols[place]) for kind, place in places]
        start = [self._starting_value(kind, place) for kind, place in places]
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

    def _starting_value(self, kind: str, column: int) -> float:
        """Return the number of a state, constant or specified at the initial time."""
        now = self.now
        if kind == "specifieds":
            return float(now.inputs.rows(now.x[None], np.array([now.t]))[0][column])
        return float((now.x if kind == "states" else now.p)[column])

    def _values(self, argument: str, d: Samples) -> Numbers:
        """Return the values of a trial that are no parameters, by their symbols."""
        places, label = self.now.definition.places[argument], f"{argument} of {d.label}"
        parameters = {symbol for _, symbol in self.shared}
        for symbol in parameters.intersection(d.unknown):
            raise ValueError(
                f"`{symbol}` is unknown in {d.label}, and a parameter of all trials too."
            )
        system = merged(getattr(self.now.settings, argument))
        values = places.by_symbol(system, argument, others=True)
        trial = merged(check_mapping(label, getattr(d.trial, argument)))
        alone = places.by_symbol(trial, label, others=True)
        numbers = {s: v for s, v in alone.items() if isinstance(v, (int, float))}
        AssumptionChecks(self.now).values(argument, numbers, f"`{label}` for ")
        if len(self.trials) > 1 and (both := parameters & alone.keys()):
            raise ValueError(
                f"`{label}` gives {describe([*both])} a value of its own, but `parameters` names "
                "it, for all trials. Leave one of them out."
            )
        values |= alone
        return {key: value for key, value in values.items() if key not in parameters}

    def _initial_conditions(self, d: Samples) -> dict[Any, float]:
        now, argument = self.now, f"initial_conditions of {d.label}"
        states = now.definition.places["states"]
        conditions = merged(check_mapping(argument, d.trial.initial_conditions))
        x, chosen = (
            CallArguments(now).states(conditions, argument),
            states.chosen(conditions, argument),
        )
        numbers = {s: x[k] for k, s in enumerate(states.symbols) if s in chosen}
        AssumptionChecks(now).values("states", numbers, f"`{argument}` for ")
        start = with_unknowns(now.at(np.array([d.start]), x[None]), {}, now.inputs.rows)
        return dict(zip(states.symbols, start.x[0].tolist(), strict=True))

    # -- motions ----------------------------------------------------------------------------------

    def motion(
        self, z: np.ndarray, k: int, times: np.ndarray, column: int | None = None
    ) -> tuple[Problem, list[Any], list[int]]:
        """Return the Problem of a trial, the parameters that it depends on, and their columns.

        The motion begins in the initial conditions of the trial, or in the independent states that
        stand in z from a `column` on.
        """
        constants, specifieds = dict(self._constants[k]), dict(self._specifieds[k])
        initial = dict(self._initial[k])
        symbols: list[Any] = []
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
            tried = self.model.tried(self._events, self._outputs, constants, specifieds)
            self._problems[k] = tried
        now = with_settings(
            self._problems[k],
            constants=constants,
            specifieds=specifieds,
            initial_conditions=initial,
            times=times,
        )
        if self.dependents:
            now = with_dependents(now, self.dependents)
        return now, symbols, columns

    # -- what is known of the parameters ----------------------------------------------------------

    def read_known(self, z: np.ndarray, bounds: Any, priors: Any) -> np.ndarray:
        """Read bounds and priors; return z, which may have more than the parameters, in bounds."""
        low, high = np.full(len(z), -np.inf), np.full(len(z), np.inf)
        for places, pair in self._pairs(bounds, "bounds", limits):
            low[places], high[places] = pair
        self.limits = low, high
        pairs = self._pairs(priors, "priors", _mean_and_deviation)
        self.priors = [(place, *pair) for places, pair in pairs for place in places]
        if self.priors and self.noise_is_estimated:
            # Without it a residual would count as one in its unit, metre or millimetre, does.
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
        """Append the priors' residuals and derivatives to those of the measurements."""
        pulls = [(z[k] - mean) / s for k, mean, s in self.priors]
        rows = np.zeros((len(pulls), len(z)))
        rows[np.arange(len(pulls)), [k for k, _, _ in self.priors]] = [
            1.0 / s for _, _, s in self.priors
        ]
        return np.append(values, pulls), np.vstack([J, rows])

    def _pairs(
        self, pairs: Any, argument: str, read: Callable[[Any, str], tuple[float, float]]
    ) -> list[tuple[list[int], tuple[float, float]]]:
        """Return pairs of numbers, and the parameters that each is for, none of them twice."""
        pairs = check_mapping(argument, pairs)
        places = [self._places(key, argument) for key in pairs]
        refuse_twice([self.names[k] for several in places for k in several], argument)
        return [
            (several, read(pair, f"`{argument}[{key}]`"))
            for several, (key, pair) in zip(places, pairs.items(), strict=True)
        ]

    def _places(self, key: Any, argument: str) -> list[int]:
        """Return the parameters that a key means; a state means that of each trial."""
        shared = Places([s for _, s in self.shared], "parameters of the fit")
        place = shared.get(key, argument)
        if place is not None:
            return [place]
        places = []
        for d, column in zip(self.trials, self.columns, strict=True):
            place = Places(d.unknown, "unknown initial conditions").get(key, argument)
            if place is not None:
                places.append(column + place)
        if not places:
            unknown = {s: 0 for d in self.trials for s in d.unknown}
            Places([*shared.symbols, *unknown], "parameters of the fit").find(key, argument)
        return places

    def sizes(self, states: np.ndarray) -> np.ndarray:
        """Return sizes of parameters: first values; those of the states for initial conditions."""
        result: np.ndarray = np.abs(self.start)
        shared = [s if kind == "states" else None for kind, s in self.shared]
        for k, symbol in enumerate([*shared, *(s for d in self.trials for s in d.unknown)]):
            if symbol is not None:
                result[k] = states[self.states.index(symbol)]
        return result


def _mean_and_deviation(value: Any, what: str) -> tuple[float, float]:
    numbers = real_array(value, what)
    if numbers.shape != (2,) or not np.isfinite(numbers).all() or not numbers[1] > 0.0:
        raise ValueError(
            f"{what} must be a pair of the mean and the positive standard deviation, got "
            f"{shown(value)}."
        )
    return float(numbers[0]), float(numbers[1])
