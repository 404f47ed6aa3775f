"""Motions: the result of an integration, with the data that checks, analyses and pictures need."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pydy._forks import cached_property
from pydy._motion.scipy_solvers import SolveIvp, is_odeint
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
class Segment:
    """A part of a motion in one combination of modes."""

    start: float
    end: float
    modes: tuple[str, ...]  # of each contact; empty without contacts
    problem: Problem  # with the equations of these modes
    columns: Sequence[int] = ()  # the outputs of the problem that are outputs of the full motion
    # Maps times to states, followed by sensitivities if there are any; None if there were more
    # steps than are stored.
    dense: Any = None
    augmented: Any = None  # the AugmentedSystem of these modes, with sensitivities


@dataclass(frozen=True, eq=False)
class Motion:
    """The result of an integration.

    An analysis integrates a Problem to Motions. A judge checks a Motion and warns or raises. A
    picture or a table shows its `trajectory`.

    `times`, `states` and `sensitivities` are those of the requested times, up to a terminal event;
    `end`, `end_state` and `end_sensitivities` are those of the end. The outputs are
    ``motion.problem.at(motion.times, motion.states).outputs()``. `dense` is the dense output: it
    returns the states at any time of the motion, followed by columns of sensitivities, if any;
    `dense.starts` are the times at which steps begin. `proceed` continues the motion with the same
    options.
    """

    problem: Problem  # with the requested initial state
    solver: Callable[..., Any]  # the function that integrated it
    options: Mapping[str, Any]  # of the solver, as compiled, with its tolerances
    times: np.ndarray  # (m,)
    states: np.ndarray  # (m, n)
    segments: tuple[Segment, ...]  # one, unless contacts change their modes
    events: Sequence[EventRecord] = ()
    # of the solver: steps, evaluations, smallest measure of rank, outcome code, `method`
    statistics: Mapping[str, Any] = field(default_factory=dict)
    dense: Any = None  # the dense output; None if it was not stored
    sensitivities: np.ndarray | None = None  # (m, n, k)
    augmented: Any = None  # the AugmentedSystem that has these columns
    projected: bool = False  # whether constraints are enforced, by projection or stabilisation
    errors_known: bool = True  # whether `options` have the tolerances of the solver
    evaluated: EvaluationRecorder | None = None  # the evaluations of a solver of SciPy
    refusal: str = ""  # why the motion cannot be continued, or ""
    # Continues the motion to further times; see `pydy.trajectory.Trajectory.continue_to`.
    proceed: Callable[[Motion, np.ndarray], Trajectory] | None = None
    label: Callable[[Motion], Trajectory] | None = None  # builds `trajectory`; default `labelled`

    @cached_property
    def trajectory(self) -> Trajectory:
        """The motion for users, with names, outputs, specifieds and energies."""
        return labelled(self) if self.label is None else self.label(self)

    @property
    def first(self) -> Problem:
        """The Problem where the motion begins: on the constraints, if it is projected."""
        return self.problem.replace(
            t=float(self.times[0]), x=self.states[0].copy(), modes=self.segments[0].modes
        )

    @property
    def last(self) -> Problem:
        """The Problem where the motion ends, in the modes of its end."""
        end = self.end
        return self.problem.replace(t=end, x=self.end_state.copy(), modes=self.segments[-1].modes)

    @property
    def end(self) -> float:
        """The time at which the motion ends, also at a terminal event."""
        return self.segments[-1].end

    @property
    def end_state(self) -> np.ndarray:
        """The state at the end, after an event that happens there."""
        if self.events and self.events[-1].time == self.end:
            return self.events[-1].after
        last: np.ndarray = self.states[-1]
        return last

    @property
    def end_sensitivities(self) -> np.ndarray:
        """The sensitivities (n, k) at the end, after an event that happens there."""
        if self.events and self.events[-1].time == self.end:
            after = self.events[-1].sensitivity_after
            if after is not None:
                return after
        assert self.sensitivities is not None
        last: np.ndarray = self.sensitivities[-1]
        return last

    @property
    def method(self) -> str:
        """The name of the solver, for messages."""
        if isinstance(self.solver, SolveIvp) and not self.errors_known:
            return self.solver.name
        default = "odeint" if is_odeint(self.solver) else "ode_solver"
        name = getattr(self.solver, "__name__", default)
        return str(self.statistics.get("method", name))

    def continued(self, times: np.ndarray) -> Trajectory:
        """Return the continuation of the motion at `times`, which begin at its end."""
        assert self.proceed is not None
        return self.proceed(self, times)

    def rates(self, t: float, x: np.ndarray, segment: int = -1) -> np.ndarray:
        """Return the derivatives of the states at a time of a segment, or after its end."""
        problem = self.segments[segment].problem
        rates: np.ndarray = problem.at(np.array([t]), x[None]).rates()[0]
        return rates

    def event(self, name: str) -> EventRecord | None:
        """Return the last event with this name, or None."""
        return next((record for record in reversed(self.events) if record.name == name), None)


def labelled(motion: Motion) -> Trajectory:
    """Return a Motion's Trajectory, which can be continued."""
    sensitivities, augmented = None, motion.augmented
    if augmented is not None:
        counts = {parameter.symbol: parameter.count for parameter in augmented.parameters}
        sensitivities = counts, motion.sensitivities
    statistics = {k: v for k, v in motion.statistics.items() if k != "sides"}
    trajectory = TrajectoryModel(motion.problem).label(
        motion.times,
        motion.states,
        events=motion.events,
        statistics=statistics or None,
        dense=motion.dense,
        sensitivities=sensitivities,
        sensitivity_model=augmented,
    )
    if len(motion.times):
        trajectory._leg = motion
    return trajectory
