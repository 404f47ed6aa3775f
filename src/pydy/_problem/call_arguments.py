"""States, constants, specifieds and times that a user gives for one call."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from pydy._assembly import errors_of
from pydy._checks import descends, real_array, vector
from pydy._problem.assumption_checks import AssumptionChecks
from pydy._problem.definition import check_times
from pydy._problem.problem import Problem
from pydy._problem.specifieds import checked_plan, warn_of_activations, warn_of_derivatives
from pydy._rank import ROUNDED
from pydy.codegen import SpecifiedsPlan


class CallArguments:
    """Read what a user gives for one call; the rest are the numbers of a Problem."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem

    def states(self, x: Any, argument: str = "x") -> Any:
        """Return states; a dictionary gives some of the initial conditions instead."""
        if type(x) is np.ndarray:
            return x
        states = self.problem.definition.places["states"]
        if isinstance(x, Mapping):
            return states.read(argument, x, self.problem.x)
        states.check_order(x, argument)
        return x

    def samples(
        self, x: Any, t: Any, argument: str = "x", *, extra_columns: int = 0, columns: bool = False
    ) -> tuple[np.ndarray, np.ndarray, bool]:
        """Return states (m, n), times (m,), and whether there is only one sample.

        None selects the initial conditions, and the System's times. The states may be followed by
        `extra_columns`. Their rows are contiguous; with `columns`, their columns may be.
        """
        if x is None:
            states = self.problem.x
        else:
            n = len(self.problem.definition.states) + extra_columns
            states = real_array(self.states(x, argument), f"`{argument}`", columns=columns)
            if states.ndim not in (1, 2) or states.shape[-1] != n:
                raise ValueError(
                    f"`{argument}` must have the shape ({n},) or (m, {n}), one column for each "
                    f"state, got {states.shape}."
                )
        times, single = self._sample_times(t, states, argument), states.ndim == 1
        return (states[None] if single else states), np.ascontiguousarray(times), single

    def _sample_times(self, t: Any, states: np.ndarray, argument: str) -> np.ndarray:
        """Return the times of one state (n,) or of m states (m, n)."""
        single = states.ndim == 1
        if t is None:
            source, instants = "the System's `times`", self.problem.settings.times
            if not len(instants):
                return np.zeros(1 if single else len(states))
            if single:
                return instants[:1]
        else:
            source, instants = "`t`", real_array(t, "`t`")
            if single and instants.ndim != 0:
                raise ValueError(
                    f"`t` must be a scalar for `{argument}` of the shape {states.shape}, got the "
                    f"shape {np.shape(t)}."
                )
            if single:
                return instants.reshape(1)
            if instants.ndim != 1:
                raise ValueError(
                    f"`t` must have the shape ({len(states)},) for `{argument}` of the shape "
                    f"{states.shape}, got the shape {np.shape(t)}."
                )
        if len(instants) != len(states):
            raise ValueError(
                f"`{argument}` and `t` must have as many rows as times: `{argument}` has the shape "
                f"{states.shape}, {source} the shape {instants.shape}."
            )
        return instants

    def warn_of_states(self, states: np.ndarray, argument: str) -> None:
        """Warn of states (m, n) that contradict assumptions by more than rounding errors."""
        allowed = errors_of(states, ROUNDED)
        source = f"`{argument}` for "
        AssumptionChecks(self.problem).columns("states", states, source, allowed=allowed)

    def constants(self, p: Any) -> np.ndarray:
        """Return the constants in order."""
        if p is None:
            return self.problem.p
        constants = self.problem.definition.places["constants"]
        if isinstance(p, Mapping):
            numbers = constants.read("p", p, self.problem.p)
        else:
            constants.check_order(p, "p")
            numbers = vector(p, len(constants), "`p`")
        AssumptionChecks(self.problem).columns("constants", numbers[None], "`p` for ")
        return numbers

    def plan(self, r: Any) -> SpecifiedsPlan:
        """Return how r is computed, with a user's values."""
        if r is None:
            return self.problem.plan
        definition, settings = self.problem.definition, self.problem.settings
        symbols = definition.places["specifieds"]
        if callable(r):
            return SpecifiedsPlan({symbols.symbols: r}, symbols, argument="r")
        update = SpecifiedsPlan(r, symbols, argument="r")
        already_warned = settings.already_warned
        AssumptionChecks(self.problem).inputs(update, "r")
        body, plan = definition.equations.multibody, None
        if body and body.activations:  # what has no value may have one in this call
            plan = checked_plan(
                definition, settings.specifieds, already_warned, settings.contradicted
            )
        plan = (plan or self.problem.plan).updated(update)
        warn_of_activations(definition, plan, already_warned)
        return warn_of_derivatives(definition, plan, already_warned)


def read_times(problem: Problem, times: np.ndarray, forward: str = "") -> np.ndarray:
    """Return a copy of times, whose array may have been edited in place.

    Descending times are refused for what runs `forward` only; the text is the error's reason.
    """
    latest = problem.model.code.latest
    checked = latest.get("times")
    if checked is None or checked.shape != times.shape or checked.tobytes() != times.tobytes():
        latest["times"] = checked = check_times(times)
    if forward and descends(checked):
        raise ValueError(
            f"`times` descend, from {checked[0]} to {checked[-1]}, but {forward}. Let them "
            "ascend, or integrate backward with `integrate` or `simulate`."
        )
    return checked.copy()
