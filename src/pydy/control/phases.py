"""Motions in several phases, linked by impacts, releases or changes of the equations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING, overload

import numpy as np
import sympy as sm

from pydy._checks import check_mapping, listed, shown
from pydy._mechanics import find_symbols
from pydy._optional import require
from pydy.codegen import checked_expression
from pydy.control.ipopt import Iteration, NlpSolution
from pydy.control.kernel import PointBuilder, PointFunctions
from pydy.control.nlp import PointGroup
from pydy.control.result import OptimalTrajectory, why_in_vain
from pydy.control.search import SearchableProblem, TrajectorySearch
from pydy.control.transcription import Transcription

if TYPE_CHECKING:
    from pandas import DataFrame

    from pydy._sympy_types import AnySymbol

_OPEN = (-np.inf, np.inf)


class PhasedTrajectory(Sequence[OptimalTrajectory]):
    """The phases of an optimal motion, in order.

    Attributes
    ----------
    objective, duration : float
        Sums of those of the phases.
    status : int
        As IPOPT returns it; 0 is solved.
    message : str
    history : tuple of Iteration
    """

    def __init__(self, phases: Sequence[OptimalTrajectory], solution: NlpSolution) -> None:
        self._phases = tuple(phases)
        self.objective = solution.objective
        self.duration = sum(phase.duration for phase in phases)
        self.status = solution.status
        self.message = why_in_vain(solution, ())
        self.history: tuple[Iteration, ...] = solution.history

    def __len__(self) -> int:
        return len(self._phases)

    @overload
    def __getitem__(self, key: int) -> OptimalTrajectory: ...
    @overload
    def __getitem__(self, key: slice) -> tuple[OptimalTrajectory, ...]: ...
    def __getitem__(self, key: int | slice) -> OptimalTrajectory | tuple[OptimalTrajectory, ...]:
        return self._phases[key]

    def summary(self) -> str:
        """Return the result as tables of text, one for each phase."""
        parts = [f"phase {k}\n\n{phase.summary()}" for k, phase in enumerate(self)]
        return "\n\n".join([repr(self), *parts])

    def to_dataframe(self) -> DataFrame:
        """Return a `pandas.DataFrame` of all phases, indexed by ``phase`` and ``time``.

        Raises
        ------
        ImportError
            pandas is not installed.
        """
        pandas = require("pandas", "labels", "PhasedTrajectory.to_dataframe")
        tables = {k: phase.to_dataframe() for k, phase in enumerate(self)}
        return pandas.concat(tables, names=["phase", "time"])

    def __repr__(self) -> str:
        error = float(sum(np.abs(phase.objective_error).sum() for phase in self))
        near = f" ± {error:.1g}" if np.isfinite(error) else ""
        return (
            f"PhasedTrajectory: {len(self)} phases, {self.duration:.6g} s, objective "
            f"{self.objective:.9g}{near}: {self.message}"
        )


class Phases(TrajectorySearch[PhasedTrajectory]):
    """Consecutive optimal control problems, solved as one; see `OptimalControl.phases`."""

    def __init__(self, problems: Sequence[SearchableProblem], links: object) -> None:
        junctions = listed("links", links, "a dictionary for each junction")
        if len(junctions) != len(problems) - 1:
            raise ValueError(
                f"`links` must have a dictionary for each junction between phases, "
                f"{len(problems) - 1}, got {len(junctions)}. An empty one links all "
                "states that both phases have."
            )
        self._links = [
            _checked_link(f"links[{k}]", link, before, after)
            for k, (link, (before, after)) in enumerate(
                zip(junctions, pairwise(problems), strict=True)
            )
        ]
        self._problems = [problems[0]]
        for k, problem in enumerate(problems[1:]):
            phase, link = copy(problem), self._links[k]
            # The end of a phase satisfies the constraints; the link may violate some of them.
            follow = _followers(self._problems[-1], problem, link)
            equations = problem._snapshot.definition.equations
            solved: set[AnySymbol] = set()
            constraints = equations.constraints
            # After such a link residuals determine other unknowns.
            if follow < len(constraints.enforced_holonomic):
                solved = {equations.coordinates[z] for z in constraints.residuals.columns}
            phase._start = {
                s: _OPEN if s in {*link, *solved} and s not in problem._begins else limits
                for s, limits in problem._start.items()
            }
            self._links[k] = {s: e for s, e in link.items() if s not in solved or e != s}
            phase._problem = replace(
                problem._problem, constraints=problem._start_constraints[follow:]
            )
            self._problems.append(phase)

    def _guesses(self, guess: object) -> Sequence[object]:
        if guess is None:
            return [None] * len(self._problems)
        guesses: Sequence[object] = listed("guess", guess, "a guess for each phase")
        if len(guesses) != len(self._problems):
            raise ValueError(
                f"`guess` must have an entry for each of the {len(self._problems)} phases, got "
                f"{len(guesses)}."
            )
        return guesses

    def _with_problems(self, problems: Sequence[SearchableProblem]) -> Phases:
        combined = copy(self)
        combined._problems = list(problems)
        return combined

    def _phases(self, motion: PhasedTrajectory) -> Sequence[OptimalTrajectory]:
        return list(motion)

    def _combined_result(
        self, phases: Sequence[OptimalTrajectory], solution: NlpSolution
    ) -> PhasedTrajectory:
        return PhasedTrajectory(phases, solution)

    def _link(
        self, k: int, transcriptions: Sequence[Transcription], positions: Sequence[np.ndarray]
    ) -> PointGroup:
        before, after = (transcription.problem for transcription in transcriptions)
        definition, link = self._problems[k]._snapshot.definition, self._links[k]
        next_states = self._problems[k + 1]._snapshot.definition.states
        # The problem before shares this with other Phases, whose next states may be others.
        key = ("link", *link.items(), *next_states)

        def compiled() -> PointFunctions:
            point = PointBuilder(before.equations, len(before.numbers))
            x, y = point.variables(before.states), point.variables(after.states)
            numbers, _ = before.unknown_numbers(point)
            atoms = dict(zip(definition.states, x, strict=True))
            atoms |= {s: numbers[j] for j, s in enumerate(definition.constants)}
            nodes = point.read_with(list(link.values()), f"`links[{k}]`", atoms)
            at = dict(zip(next_states, y, strict=True))
            g = point.graph
            rows = [g.sub(at[s], node) for s, node in zip(link, nodes, strict=True)]
            return point.functions(rows, None, hessian=before.hessian)

        first, second = transcriptions
        ends = np.arange(before.states) * len(first.state_slots[0]) + first.intervals
        begins = np.arange(after.states) * len(second.state_slots[0])
        numbers = np.arange(sum(first.sizes[:2]), sum(first.sizes))
        at = np.concatenate([positions[0][ends], positions[1][begins], positions[0][numbers]])
        labels = tuple(f"link {k} of {s}" for s in link)
        functions, none = before.once(key, compiled), np.empty((0, 1))
        return PointGroup(functions, at[:, None], none, before.numbers, labels, np.full(1, np.nan))


def _followers(
    before: SearchableProblem, after: SearchableProblem, link: Mapping[AnySymbol, sm.Expr]
) -> int:
    """Return how many of the constraints, from the first one on, a link preserves."""
    definition, equations = after._snapshot.definition, after._problem.equations
    signals = [k for columns, _ in after._problem.signals for k in columns.tolist()]
    if not (
        before._snapshot.definition is definition
        and np.array_equal(before._snapshot.p, after._snapshot.p)
        and np.array_equal(before._problem.specifieds, after._problem.specifieds, equal_nan=True)
        and not equations.depend_on(equations.constraints, signals, time=True)
    ):
        return 0
    q, u = definition.equations.coordinates, definition.equations.speeds
    if any(link.get(s) != s for s in q):
        return 0
    position_count = len(definition.equations.constraints.implied_holonomic)
    return position_count if any(link.get(s) != s for s in u) else len(equations.constraints)


def _checked_link(
    argument: str, link: object, before: SearchableProblem, after: SearchableProblem
) -> dict[AnySymbol, sm.Expr]:
    """Return an expression for each state that is linked."""
    states = after._snapshot.definition.states
    definition = before._snapshot.definition
    allowed = {*definition.states, *definition.constants}
    expressions: dict[AnySymbol, sm.Expr] = {s: s for s in states if s in definition.states}
    entries = check_mapping(argument, link)
    symbols = after._snapshot.definition.places["states"].chosen(entries, argument)
    for s, (key, value) in zip(symbols, entries.items(), strict=True):
        if value is None:
            expressions.pop(s, None)
            continue
        expression = checked_expression(value, f"`{argument}[{key}]`")
        strange = any(symbol not in allowed for symbol in find_symbols([expression]))
        if strange or not isinstance(expression, sm.Expr):
            raise ValueError(
                f"`{argument}[{key}]` is {shown(value)}, but a link is an expression of the states "
                "of the phase before, at its end, and of constants."
            )
        expressions[s] = expression
    return {s: expressions[s] for s in states if s in expressions}
