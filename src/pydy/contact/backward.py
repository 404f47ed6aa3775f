"""Adjoint gradients of motions with contacts: backward through segments and transitions.

Each segment is integrated forward in its mode with its steps recorded; the discrete adjoint of
these steps leads backward. At a transition the adjoint is multiplied by the transpose of the
transition matrix. That matrix follows from the equations of the sensitivities, with the unit
vectors of all states as columns before those of the parameters.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._integration import (
    AugmentedSystem,
    GradientEquations,
    columns_of,
    integrate_recorded,
)
from pydy._judges import judge_start
from pydy._motion import Motion, Segment, prepare
from pydy._problem import Problem, read_term
from pydy._rank import HALF, ROUNDING
from pydy.analysis import AdjointGradient, AdjointSegment
from pydy.contact.complementarity import STARTING
from pydy.contact.modes import Mode
from pydy.contact.rows import ContactRows, RowValues
from pydy.contact.run import ContactRun
from pydy.contact.sensitivities import HybridSensitivities, Transitions
from pydy.contact.tuning import ROUNDING_MARGIN
from pydy.trajectory import EventRecord

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, ExpressionOrName, SymbolOrName
    from pydy.solvers import Solver


class RecordedTransitions(Transitions):
    """Segments of a motion, each with the matrix of the transition that leads to it.

    The matrix is (n, n + w): derivatives by the n states before the transition and by the w
    parameters. It comes with the derivatives of the transition's time. `terms` are those of the
    objective, which is differentiated by the parameters `wrt`.
    """

    def __init__(
        self,
        wrt: SymbolOrName | Iterable[SymbolOrName],
        terms: Mapping[str, ExpressionOrName | None],
        rows: ContactRows,
        problem: Problem,
    ) -> None:
        equations = GradientEquations.for_parameters(problem, problem.model.code, wrt)
        self.start = equations.initial(problem, float(problem.settings.times[0]))
        self._parameters, self._terms = equations.augmented.parameters, terms
        self.together = False
        n, constants = len(problem.definition.states), problem.definition.constants
        constants_by_column = [
            constants[index] if group == "p" else None for group, index in equations.wrt
        ]
        self._unit = np.eye(n, n + len(equations.wrt))
        super().__init__(rows, problem, [*[None] * n, *constants_by_column], self._unit)
        self.counts = {p.symbol: p.count for p in self._parameters}
        self.adjoint_segments: list[tuple[AdjointSegment, np.ndarray, np.ndarray]] = []

    def rest_speed(self, i: int, speed: np.ndarray, tolerance: float, rounding: float) -> float:
        """Return the sliding speed at which a slide in a plane ends, 0 for where it vanishes.

        Rounding ε V of speeds of the size V turns the direction of the sliding velocity v by
        ε V/|v|, and derivatives by states, of the size V too, with it: in a step of |v|/(16 a), for
        the acceleration a of friction, by ε V²/(16 |v|). Where that exceeds the solver's tolerance,
        steps become ever smaller. What a slide leaves for the projection onto the rows of sticking
        costs derivatives |v|/V. At |v| = √ε V/16 both are √ε, with as many digits as half.
        """
        size = rounding / (ROUNDING_MARGIN * 16.0 * ROUNDING)
        tolerance = max(tolerance, HALF * size / 16.0)
        return super().rest_speed(i, speed, tolerance, rounding)

    def simulate(
        self,
        mode: Mode,
        start: np.ndarray,
        problem: Problem,
        solver: Solver,
        options: dict[str, Any],
    ) -> Motion:
        """Simulate in one mode, with the transition matrix at its start."""
        definition = problem.definition
        options = {**options, "dense_output": True}
        terms = [
            None if term is None else read_term(definition, term, name)
            for name, term in self._terms.items()
        ]
        ready, times = prepare(problem, problem.settings.times, solver, options)
        judge_start(problem, times, ready)
        symbol_tables = definition.places  # a mode has further constants, so indices differ
        parameters = tuple(
            replace(p, index=symbol_tables[p.kind].symbols.index(p.symbol))
            for p in self._parameters
        )
        columns = columns_of(parameters, definition)
        augmented = AugmentedSystem(
            definition, ready.code, problem.inputs, problem.p, parameters, columns
        )
        controlled = start.copy() if mode.turns else None
        if controlled is not None and STARTING in mode.modes:
            controlled[:, self._first : len(controlled)] = 0.0  # no sliding speed at the onset
        equations = GradientEquations(augmented, *terms)
        recorded = integrate_recorded(problem, solver, ready, times, equations, controlled)
        steps, events = recorded.steps, recorded.options.events
        self._event_times = {
            r.index: recorded.event_derivatives(r, r.index in mode.untimed).time
            for r in steps.events
            if steps.stopped and r.time == steps.end and events and events.traits[r.index].terminal
        }
        time = np.where(self.doubtful, np.nan, self.time)
        self._latest = AdjointSegment(recorded), start, time
        return recorded.motion

    def store_segment(self, motion: Motion, end: float, records: list[EventRecord]) -> None:
        """Store the latest segment."""
        self.adjoint_segments.append(self._latest)

    def locate_end(self, record: EventRecord, rates: np.ndarray) -> None:
        """Begin the matrix of a transition at the event that ends a mode."""
        self.end_mode(self._unit, self._event_times[record.index], rates)

    def doubt(self, values: Mapping[AnySymbol, float], i: int) -> None:
        """Treat the time of a stop in a plane as unknown: nearby motions do not stop there.

        They do where the slide ended at its `rest_speed`.
        """
        marked = self.turned if self.rest_speeds.get(i) else self.doubtful
        marked[:] = True

    def separating_parameters(
        self, i: int, slopes: np.ndarray, p: RowValues, share: float
    ) -> list[str]:
        """Record whether a state moves the gap of a closing contact; see `gradient`."""
        self.together |= bool(self.gap_opens(i, slopes, p, share).any())
        return []

    def results(self, count: int) -> None:
        """Return no sensitivities of the motion."""

    def labels(self, values: np.ndarray | None, segments: Sequence[Segment]) -> dict[str, object]:
        """Return the trajectory's arguments for its sensitivities: none."""
        return {}


def gradient(run: ContactRun) -> AdjointGradient:
    """Run a simulation with recorded transitions, and return the gradient."""
    recorded: Any = run.transitions
    trajectory = run.motion().trajectory
    segments, n = recorded.adjoint_segments, run.n
    last = segments[-1][0]
    steps = last.recorded.steps
    if any(time == steps.end for time, _, _ in run.impacts[-1:]) and len(steps.starts):
        raise run.fail(
            steps.end, steps.end_state[:n],
            "The motion ends at an impact: what is there has no derivatives. Change the last of "
            "the `times`.",
        )  # fmt: skip
    terminal = {event.name for event in run.user_events if event.terminal}
    at_end = (r for r in steps.events if steps.stopped and r.time == steps.end)
    last.finish(end_varies=any(record.name in terminal for record in at_end))
    by_state = np.zeros(n)
    try:
        for k, (segment, matrix, time) in reversed([*enumerate(segments)]):
            segment.back()
            by_state = segment.back_through_transition(
                matrix, time, segments[k - 1][0] if k else None
            )
    except KeyboardInterrupt as stop:
        raise last.recorded.interrupted(trajectory.times, trajectory.states) from stop
    values = segments[0][0].by_parameters(by_state @ recorded.start)
    if recorded.together:  # simultaneous transitions: check by forward sensitivities
        columns = HybridSensitivities([*recorded.counts], False, run.rows, run.problem)
        ContactRun(
            run.compiled, run.solver, run.problem, run.times, run.user_events, run.options, columns
        ).motion()
        by_state = np.full(n, np.nan)
    value = sum(segment.value for segment, _, _ in segments)
    statistics = dict(trajectory.statistics or {})
    return AdjointGradient(
        value, values, recorded.counts, by_state, steps.end, statistics, lambda: trajectory
    )
