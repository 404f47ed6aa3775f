"""Motions: the result of an integration, with the data that checks, analyses and pictures need."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import numpy as np

from pydy._forks import cached_property
from pydy._interpolation import Continuation
from pydy._problem import Problem, TrajectoryModel
from pydy.trajectory import EventRecord, Trajectory


class EvaluationRecorder:
    """A right-hand side that records the times and states at which a solver evaluated it.

    Its `jumps` in time have the rows of `pydy._program.switch_times.SwitchTimes`.
    """

    def __init__(self, f: Callable[..., np.ndarray], jumps: np.ndarray) -> None:
        self._f, self.jumps = f, jumps
        self.times: list[float] = []
        self.states: list[np.ndarray] = []

    def __call__(self, x: np.ndarray, t: float, *args: object) -> np.ndarray:
        self.times.append(float(t))
        self.states.append(np.array(x, dtype=float))
        return self._f(x, t, *args)


@dataclass(frozen=True, eq=False)
class Integrator:
    """The solver that integrated a motion, and what a judge needs to know of its work."""

    solver: Callable[..., Any]
    constraints_enforced: bool = False  # by projection or stabilisation
    errors_known: bool = True  # whether the motion's `options` have the solver's tolerances
    evaluated: EvaluationRecorder | None = None  # the evaluations of a solver of SciPy


@dataclass(frozen=True, eq=False)
class Segment:
    """A part of a motion in one combination of modes."""

    start: float
    end: float
    modes: tuple[str, ...]  # of each contact; empty without contacts
    problem: Problem  # with the equations of these modes
    # The outputs of the problem that are outputs of the full motion.
    columns: np.ndarray | Sequence[int] = ()
    # The dense output: it returns the states at any time of the segment, followed by columns of
    # sensitivities, if any; `dense.starts` are the times at which steps begin. None if it was not
    # requested, or if there were more steps than are stored.
    dense: Any = None
    augmented: Any = None  # the AugmentedSystem of these modes, with sensitivities
    # The outputs of the problem at all times of the motion, if it is the only part of it and they
    # were computed before.
    outputs: np.ndarray | None = None

    def rates(self, t: float, x: np.ndarray) -> np.ndarray:
        """Return the derivatives of the states at a time of the segment, or after its end."""
        rates: np.ndarray = self.problem.at(np.array([t]), x[None]).rates()[0]
        return rates


@dataclass(frozen=True, eq=False)
class Motion:
    """The result of an integration.

    An analysis integrates a Problem to Motions. A judge checks a Motion and warns or raises. A
    picture or a table shows its `trajectory`.

    `times`, `states` and `sensitivities` are those of the requested times, up to a terminal event.
    `first` and `last` are the Problems where the motion begins and ends: integrate the last to
    continue. The outputs are ``motion.problem.at(motion.times, motion.states).outputs()``.
    """

    problem: Problem  # with the requested initial state
    integrator: Integrator
    options: Mapping[str, Any]  # of the solver, as compiled, with its tolerances
    times: np.ndarray  # (m,)
    states: np.ndarray  # (m, n)
    segments: tuple[Segment, ...]  # one, unless contacts change their modes
    events: Sequence[EventRecord] = ()
    # of the solver: steps, evaluations, smallest measure of rank, outcome code, `method`
    statistics: Mapping[str, Any] = field(default_factory=dict)
    sensitivities: np.ndarray | None = None  # (m, n, k)
    label: Callable[[Motion], Trajectory] | None = None  # builds `trajectory`; default `labelled`

    @cached_property
    def trajectory(self) -> Trajectory:
        """The motion for users, with names, outputs, specifieds and energies."""
        return labelled(self) if self.label is None else self.label(self)

    @property
    def first(self) -> Problem:
        """The Problem where the motion begins: on the constraints, if these are enforced."""
        return self.problem.replace(
            t=float(self.times[0]), x=self.states[0].copy(), modes=self.segments[0].modes
        )

    @property
    def last(self) -> Problem:
        """The Problem where the motion ends, in the modes of its end and after an event there.

        Raises
        ------
        RuntimeError
            If no state is recorded there: the integration stopped between two of the times, or a
            terminal event of a solver of SciPy came before the first one.
        """
        segment = self.segments[-1]
        if self.events and self.events[-1].time == segment.end:
            state = self.events[-1].after
        elif len(self.times) and self.times[-1] == segment.end:
            state = self.states[-1]
        else:
            raise RuntimeError(
                "No state is recorded where the motion ends: the integration stopped at "
                f"t = {segment.end!r}, between two of the times; `times` and `states` hold it up "
                "to there."
                if len(self.times)
                else "No state is recorded where the motion ends: it ended before the first of the "
                "times."
            )
        return self.problem.replace(t=segment.end, x=state.copy(), modes=segment.modes)

    @property
    def last_sensitivities(self) -> np.ndarray:
        """The sensitivities (n, k) of the state of `last`."""
        if self.events and self.events[-1].time == self.segments[-1].end:
            after = self.events[-1].sensitivity_after
            if after is not None:
                return after
        assert self.sensitivities is not None
        last: np.ndarray = self.sensitivities[-1]
        return last


def labelled(
    motion: Motion,
    proceed: Callable[[Motion, np.ndarray], Trajectory] | None = None,
    refusal: str = "",
) -> Trajectory:
    """Return the Trajectory of a Motion in one segment.

    `proceed` continues the motion from its end at further times, which begin there. A `refusal`
    says why it cannot be continued.
    """
    (segment,) = motion.segments
    sensitivities, augmented = None, segment.augmented
    if augmented is not None:
        counts = {parameter.symbol: parameter.count for parameter in augmented.parameters}
        sensitivities = counts, motion.sensitivities
    statistics = {k: v for k, v in motion.statistics.items() if k not in ("clear", "sides")}
    trajectory = TrajectoryModel(motion.problem).label(
        motion.times,
        motion.states,
        events=motion.events,
        statistics=statistics or None,
        dense=segment.dense,
        sensitivities=sensitivities,
        sensitivity_model=augmented,
    )
    if len(motion.times) and (proceed or refusal):
        further = None if proceed is None else partial(proceed, motion)
        trajectory._continuation = Continuation(segment.end, refusal, further)
    return trajectory
