"""Adjoints of motions with contacts: back from stretch to stretch, through their transitions.

Each stretch is integrated in its mode with its steps noted, and gone back through by the adjoint of
these. A transition is passed by the transpose of what sensitivities are turned by: their equations,
with the unit vectors of all states as columns, beside those of the parameters.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from pydy._integration import AugmentedSystem
from pydy._judges import judge_start
from pydy._motion import Motion, Segment, prepare
from pydy._problem import Problem, read_term
from pydy.analysis import AdjointGradient, MotionSegment, Task, integrate_forward
from pydy.contact.decide import STARTING
from pydy.contact.modes import Mode
from pydy.contact.rows import ContactRows, Numbers
from pydy.contact.run import Run
from pydy.contact.sensitivities import HybridSensitivities, Transitions
from pydy.trajectory import EventRecord


class Noted(Transitions):
    """Stretches of a motion, each with the matrix of the transition that leads to it.

    It is (n, n + w), by the states before the transition and by what is wanted, and comes with the
    derivatives of its time. The `terms` are those of the objective, which is differentiated by the
    parameters `wrt`.
    """

    def __init__(self, wrt: Any, terms: Mapping[str, Any], rows: ContactRows, now: Problem) -> None:
        sensitive = AugmentedSystem.of(now, now.model.code, now.plan, wrt, "wrt")
        self.start = sensitive.start(now.x, float(now.settings.times[0]))
        self._parameters, self._terms = sensitive.parameters, terms
        self.together = False
        n, constants = len(now.definition.states), now.definition.constants
        wanted = Task(sensitive, None, None).wanted
        own = [constants[place] if group == "p" else None for group, place in wanted]
        self._unit = np.eye(n, n + len(wanted))
        super().__init__(rows, now, [*[None] * n, *own], self._unit)
        self.counts = {p.symbol: p.count for p in self._parameters}
        self.stretches: list[tuple[MotionSegment, np.ndarray, np.ndarray]] = []

    def simulate(
        self, mode: Mode, given: np.ndarray, now: Problem, solver: Any, options: dict[str, Any]
    ) -> Motion:
        """Simulate in one mode, with the matrix at the start `given`."""
        definition = now.definition
        options = {**options, "dense_output": True}
        terms = [
            None if term is None else read_term(definition, term, name)
            for name, term in self._terms.items()
        ]
        ready, times = prepare(now, now.settings.times, solver, options)
        judge_start(now, times, ready)
        places = definition.places  # where a mode has constants of its own among the others
        parameters = tuple(
            replace(p, place=places[p.kind].symbols.index(p.symbol)) for p in self._parameters
        )
        sensitive = AugmentedSystem(definition, ready.code, now.plan, parameters, now.p, "wrt")
        guide = given.copy() if mode.turns else None
        if guide is not None and STARTING in mode.modes:  # what begins to slide has no speed
            guide[:, self._first : len(guide)] = 0.0
        found = integrate_forward(now, solver, ready, times, Task(sensitive, *terms), guide)
        compiled: Any = found.options.events
        self._moments = {
            r.index: found.moment(r, r.index in mode.untimed)[2]
            for r in found.records
            if found.stopped and r.time == found.end and compiled.terminal[r.index]
        }
        self._latest = found, given, np.where(self.doubtful, np.nan, self.time)
        return found.motion(now, solver, ready)

    def took(self, motion: Motion, end: float, records: list[EventRecord]) -> None:
        """Keep the latest stretch."""
        self.stretches.append(self._latest)

    def ended(self, record: EventRecord, rates: np.ndarray) -> None:
        """Begin the matrix of a transition at the event that ends a mode."""
        self.ends(self._unit, self._moments[record.index], rates)

    def doubt(self, values: Mapping[Any, float], rows: Sequence[int]) -> None:
        """Treat the time of a stop in a plane as unknown: nearby motions do not stop there."""
        self.doubtful[:] = True

    def apart(self, i: int, slopes: np.ndarray, p: Numbers, share: float) -> list[str]:
        """Note whether the gap of a contact that closes opens by a state; see `gradient`."""
        self.together |= bool(self.opened(i, slopes, p, share).any())
        return []

    def results(self, reached: np.ndarray) -> None:
        """Return no sensitivities of the motion."""

    def labels(self, values: Any, segments: Sequence[Segment]) -> dict[str, Any]:
        """Return the trajectory's arguments for its sensitivities: none."""
        return {}


def gradient(run: Run) -> AdjointGradient:
    """Return the gradient of a simulation that has not begun, whose transitions are noted."""
    noted: Any = run.carried
    trajectory = run.motion().trajectory
    stretches, n = noted.stretches, run.n
    last = stretches[-1][0]
    if any(time == last.end for time, _, _ in run.impacts[-1:]) and len(last.starts):
        raise run.fail(
            last.end, last.last[:n],
            "The motion ends at an impact: what is there has no derivatives. Change the last of "
            "the `times`.",
        )  # fmt: skip
    terminal = {event.name for event in run.user_events if event.terminal}
    at_end = (r for r in last.records if last.stopped and r.time == last.end)
    last.finish(moves=any(record.name in terminal for record in at_end))
    by_state = np.zeros(n)
    try:
        for k, (stretch, matrix, time) in reversed([*enumerate(stretches)]):
            stretch.back()
            by_state = stretch.through(matrix, time, stretches[k - 1][0] if k else None)
    except KeyboardInterrupt as stop:
        raise last.interrupted(trajectory.times, trajectory.states) from stop
    values = stretches[0][0].by_parameters(by_state @ noted.start)
    if noted.together:  # sensitivities tell whether parameters part what happens at one instant
        columns = HybridSensitivities([*noted.counts], False, run.rows, run.now)
        Run(
            run.kept, run.solver, run.now, run.times, run.user_events, run.options, columns
        ).motion()
        by_state = np.full(n, np.nan)
    value = sum(stretch.value for stretch, _, _ in stretches)
    told = dict(trajectory.statistics or {})
    return AdjointGradient(
        value, values, noted.counts, by_state, last.end, told, lambda: trajectory
    )
