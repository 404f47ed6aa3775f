"""Warn once of numbers that contradict the assumptions of their symbols.

The names of those already reported are the settings' `contradicted`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from pydy._assembly import errors_of
from pydy._problem.entries import check_specifieds
from pydy._problem.problem import Problem, evaluate_specifieds
from pydy._problem.state_samples import StateSamples
from pydy._rank import ROUNDED
from pydy.codegen import SpecifiedsPlan


class AssumptionChecks:
    """Compare numbers with the assumptions that a Problem's symbols were made with."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem

    def judged(self) -> bool:
        """Return whether motions are compared with assumptions, such as `positive=True`."""
        return (
            self.problem.definition.assumes_motions
            and self.problem.settings.contradicted is not None
        )

    def columns(self, kind: str, values: np.ndarray, source: str, **options: Any) -> None:
        """Warn of values (m, k) of all states, specifieds or constants."""
        contradicted = self.problem.settings.contradicted
        assumptions = self.problem.definition.assumptions
        if contradicted is not None and kind in assumptions:
            assumptions[kind].tell(values, contradicted, source, **options)

    def samples(self, samples: StateSamples, plan: SpecifiedsPlan | None, from_user: bool) -> None:
        """Warn of states, if they are `from_user`, and of specifieds that are computed there.

        The `plan` says how r is computed; None where the user gave an array.
        """
        assumptions = self.problem.definition.assumptions
        if from_user and "states" in assumptions:
            # Several may be those of a computed motion.
            allowed = errors_of(samples.x, ROUNDED) if len(samples.x) > 1 else 0.0
            self.columns("states", samples.x, "`x` for ", allowed=allowed)
        if "specifieds" not in assumptions or self.problem.settings.contradicted is None:
            return
        columns, source = assumptions["specifieds"].columns, "The specified "
        expressions: set[int] = set()
        if plan is not None:
            expressions = {k for k, s in enumerate(plan.symbols) if s in plan.expressions}
            columns = (columns & plan.changing) - expressions
        self.columns("specifieds", samples.r, source, columns=columns)
        if expressions and plan is self.problem.plan:
            rows = evaluate_specifieds(self.problem, samples.t, samples.x)
            self.columns("specifieds", rows, source, columns=expressions)

    def inputs(self, plan: SpecifiedsPlan, argument: str = "specifieds") -> None:
        """Warn of numbers and samples for specifieds."""
        contradicted = self.problem.settings.contradicted
        check_specifieds(self.problem.definition, plan, contradicted, argument)

    def motion(
        self, times: np.ndarray, states: np.ndarray, rtol: Any = 1.0, atol: Any = 0.0
    ) -> None:
        """Warn of states and specifieds along a motion.

        A solver's tolerances say which contradictions may be errors; without error control only
        those that are large beside the other values are reported.
        """
        contradicted = self.problem.settings.contradicted
        assumptions = self.problem.definition.assumptions
        if contradicted is None or not len(times):
            return

        def where(row: int) -> str:
            return f" at t = {times[row]:g} of a motion"

        if (assumed := assumptions.get("states")) is not None:
            allowed = errors_of(states, rtol, atol)
            assumed.tell(states, contradicted, "", where=where, allowed=allowed, in_time=True)
        if (assumed := assumptions.get("specifieds")) is None:
            return
        plan = self.problem.plan  # whose numbers and samples were judged when they were given
        if columns := assumed.columns & plan.changing:
            finite = np.isfinite(states).all(axis=1)
            rows = np.full((len(times), len(plan.symbols)), np.nan)
            rows[finite] = evaluate_specifieds(self.problem, times[finite], states[finite])
            allowed = errors_of(rows, rtol)
            assumed.tell(
                rows, contradicted, "", where=where, allowed=allowed, in_time=True, columns=columns
            )


def warn_of_contradictions(
    problem: Problem, kind: str, values: Mapping[Any, Any], source: str
) -> None:
    """Warn of numbers for some states, specifieds or constants that contradict assumptions."""
    definition = problem.definition
    if values and kind in definition.assumptions:
        row = np.full((1, len(definition.places[kind])), np.nan)
        for symbol, value in values.items():
            row[0, definition.places[kind].find(symbol, kind)] = value
        AssumptionChecks(problem).columns(kind, row, source)
