"""States, constants, specifieds and times that a user gives for one call."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from pydy._checks import descends, vector
from pydy._problem.assumption_checks import AssumptionChecks
from pydy._problem.definition import check_times
from pydy._problem.problem import Problem
from pydy._problem.specifieds import checked_plan, warn_of_activations, warn_of_derivatives
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
