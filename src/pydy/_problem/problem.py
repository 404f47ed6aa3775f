"""The numbers of a System at one moment, with the model that they belong to."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, replace
from typing import Any, Protocol

import numpy as np

from pydy._assembly import CompiledModel, Definition
from pydy._forks import cached_property
from pydy._kernel import Inputs
from pydy._problem.entries import check_specifieds
from pydy._problem.model import Model, ModelBuilder
from pydy._problem.residuals import solved_residuals
from pydy._problem.settings import Settings, read_numbers
from pydy._problem.specifieds import checked_plan, warn_of_activations
from pydy._problem.state_samples import StateSamples
from pydy.codegen import SpecifiedsPlan
from pydy.solvers import Event


class Hybrid(Protocol):
    """What makes a motion one of several modes, such as contacts."""

    symbols: Sequence[Event]  # of expressions whose constants need numbers
    infeasible: type[Exception]  # what a search meets where modes contradict its numbers

    def refuse_lost(self, constants: Mapping[Any, object]) -> None:
        """Refuse constants of a System that lack those of the modes."""

    @property
    def depends_on_time(self) -> bool:
        """Whether the modes depend on time explicitly."""

    def integrate(self, problem: Problem, times: np.ndarray, **options: Any) -> Any:
        """Return the Motion from a Problem's state on, in its modes if it has any."""

    def motions(
        self,
        problem: Problem,
        solver: Any,
        specifieds: Mapping[Any, Any],
        columns: Sequence[int],
        options: Mapping[str, Any],
    ) -> Any:
        """Return the motions of an ensemble's samples; see `pydy.ensemble.model.SampleMotions`.

        The `specifieds` are those of all samples, `columns` the places of those that vary.
        """


_NUMBERS = frozenset(("t", "x", "p", "modes"))
_SETTINGS = frozenset(("times", "contradicted"))


@dataclass(frozen=True, eq=False)
class Problem:
    """A model with its numbers at one state, which later changes of the System do not affect.

    It never changes itself: `replace` returns another one. What is expensive is read, checked or
    compiled when it is first needed.
    """

    definition: Definition  # the model's
    model: Model
    settings: Settings
    hybrid: Hybrid | None = None  # what makes a motion one of several modes
    modes: tuple[str, ...] | None = None  # of `hybrid`; None where they follow from the state

    def replace(self, **numbers: Any) -> Problem:
        """Return the same with another `t`, `x`, `p` or `modes`, or `times` or `contradicted` set.

        Nothing is compiled or checked again. States that follow from others stay as they are: see
        `consistent`.
        """
        if unknown := numbers.keys() - _NUMBERS - _SETTINGS:
            raise TypeError(f"a Problem has no {', '.join(sorted(unknown))} to replace")
        changes = {key: numbers.pop(key) for key in numbers.keys() & _SETTINGS}
        other = object.__new__(Problem)
        other.__dict__.update(self.__dict__)
        other.__dict__.update(numbers)
        if changes:
            other.__dict__["settings"] = replace(self.settings, **changes)
        return other

    @cached_property
    def x(self) -> np.ndarray:
        """The initial conditions in order; where residuals give some of them, these are solved."""
        conditions, argument = self.settings.initial_conditions, "initial_conditions"
        x = read_numbers(self.definition, argument, conditions, self.settings.contradicted)
        implicit = self.definition.equations.constraints.residuals.implicit
        states = self.definition.places["states"]
        if implicit is None:
            return x
        columns = {states.find(key, argument) for key in conditions}
        for symbol, value in implicit.start.items():
            if (k := states.symbols.index(symbol)) not in columns:
                x[k] = value
        return solved_residuals(self.at(np.array([self.t]), x[None]))

    @cached_property
    def p(self) -> np.ndarray:
        """The constants in order."""
        settings, constants = self.settings, self.settings.constants
        numbers = read_numbers(self.definition, "constants", constants, settings.contradicted)
        mechanism = self.definition.equations.mechanism
        if mechanism is not None and mechanism.curve_coefficients:
            from pydy._problem.curves import warn_of_curves

            coefficients = mechanism.curve_coefficients
            warn_of_curves(self.definition, coefficients, constants, settings.already_warned)
        return numbers

    @property
    def constants(self) -> dict[Any, float]:
        """The constants' values by symbol."""
        return dict(zip(self.definition.constants, self.p.tolist(), strict=True))

    @cached_property
    def t(self) -> float:
        """The time of the state: at first that of the first of the System's times, or zero."""
        times = self.settings.times
        return float(times[0]) if len(times) else 0.0

    @cached_property
    def dependent(self) -> tuple[int, ...]:
        """The columns of the states that follow from the others by the constraints."""
        equations, states = self.definition.equations, self.definition.states
        method = (*equations.dependents.coordinates, *equations.dependents.speeds)
        chosen = method if self.settings.solved_for is None else self.settings.solved_for
        return tuple(states.index(symbol) for symbol in chosen)

    @cached_property
    def plan(self) -> SpecifiedsPlan:
        """How r is computed: by the latest plan, where at most numbers differ from its own."""
        settings, latest = self.settings, self.model.code.latest
        already_warned = self.settings.already_warned
        warned, before = latest.get("plan", (None, None))
        plan: SpecifiedsPlan | None = None
        if warned is already_warned:
            plan = before.with_changed_floats(settings.specifieds)
        if plan is None:
            plan = checked_plan(
                self.definition, settings.specifieds, already_warned, settings.contradicted
            )
            warn_of_activations(self.definition, plan, already_warned)
        elif plan is not before and self.definition.assumes_motions:
            check_specifieds(self.definition, plan, settings.contradicted)
        latest["plan"] = already_warned, plan
        return plan

    @property
    def inputs(self) -> Inputs:
        """The specifieds that are numbers, samples and functions; expressions are in the `code`."""
        return self.plan.inputs

    @cached_property
    def code(self) -> CompiledModel:
        """The model's code with the expressions for specifieds compiled in."""
        plan, model = self.plan, self.model
        return model.with_compiled_inputs(plan) if plan.expressions else model.code

    def at(self, t: np.ndarray, x: np.ndarray) -> StateSamples:
        """Return the model with these numbers at m times and states."""
        x = np.ascontiguousarray(x)
        return StateSamples(self.definition, self.code, t, x, self.plan.inputs.rows(x, t), self.p)


def problem_of(
    models: ModelBuilder,
    settings: Settings,
    *,
    events: object = None,
    constants: Mapping[Any, object] | None = None,
    further: Iterable[Any] = (),
    hybrid: Hybrid | None = None,
) -> Problem:
    """Return the Problem of what the user has set, with the symbols that one call brings.

    Those of events are constants, and so are `further` symbols; keys of `constants` are, if
    events or energies hold them.
    """
    named = {**settings.constants, **constants} if constants else settings.constants
    if hybrid is not None:
        hybrid.refuse_lost(named)
        users = [events] if isinstance(events, Event) else events
        events = [*hybrid.symbols, *(users if isinstance(users, (list, tuple)) else ())]
    definition = models.definition(settings.outputs, settings.forces, settings.specifieds, named)
    if events is not None:
        definition = models.with_events(definition, events)
    if further:
        definition = models.widened(definition, further)
    model = models.model(definition)
    return Problem(model.definition, model, settings, hybrid)


def redefined(
    problem: Problem,
    *,
    events: object = None,
    constants: Mapping[Any, object] | None = None,
    further: Iterable[Any] = (),
    apart: bool = False,
    **changes: Any,
) -> Problem:
    """Return a Problem of the same equations with other settings, which may bring symbols.

    `events`, `constants` and `further` are those of `problem_of`. The Models that it needs are not
    stored with those of the Problem's System if it is `apart`.
    """
    models = copy(problem.model.builder) if apart else problem.model.builder
    settings = replace(problem.settings, **changes)
    return problem_of(
        models,
        settings,
        events=events,
        constants=constants,
        further=further,
        hybrid=problem.hybrid,
    )


def with_settings(problem: Problem, **changes: Any) -> Problem:
    """Return a Problem with other settings, which are read anew."""
    return replace(problem, settings=replace(problem.settings, **changes))


def evaluate_specifieds(problem: Problem, times: np.ndarray, states: np.ndarray) -> np.ndarray:
    """Return the specifieds at m times and states, shape (m, s), with those of expressions."""
    symbols = problem.definition.specifieds
    if not symbols:
        return np.empty((len(times), 0))
    if not problem.plan.expressions:
        rows = problem.inputs.rows(np.ascontiguousarray(states), times)
        return np.array(np.broadcast_to(rows, (len(times), len(symbols))))
    kernel = problem.code.compiled_expressions("the specifieds", (len(symbols),), symbols)
    return problem.at(times, states).evaluate(kernel)
