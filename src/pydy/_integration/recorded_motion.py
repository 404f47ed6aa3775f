"""Motions with recorded steps, which the adjoint of a gradient is integrated back through."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple, NoReturn

import numpy as np

from pydy._errors import (
    IntegrationError,
    IntegrationInterrupted,
    SingularMatrixError,
    warn_user,
)
from pydy._forks import cached_property
from pydy._integration.event_derivatives import compiled_event
from pydy._integration.gradient_equations import GradientEquations
from pydy._integration.gradient_steps import with_controlled_columns, with_generic_direction
from pydy._integration.integration import explain_failure, motion_so_far
from pydy._integration.projection_adjoint import ProjectionAdjoint
from pydy._integration.step_control import with_step_limit
from pydy._judges import judge_motion
from pydy._kernel import KernelCall
from pydy._motion import Integrator, Motion, PreparedIntegration, Segment, with_all
from pydy._problem import Problem, TrajectoryModel
from pydy.solvers import (
    CompiledSensitivities,
    Options,
    Outcome,
    RecordedSteps,
    Solver,
    read_options,
)
from pydy.trajectory import EventRecord, Trajectory

if TYPE_CHECKING:
    from pydy.solvers import DiscreteAdjoint


class EventDerivatives(NamedTuple):
    """The derivatives of an event by the state before it, then by the inputs of a gradient."""

    blocks: dict[str, np.ndarray]  # see `program_of_event`
    changed: tuple[int, ...]  # the states that the event changes
    time: np.ndarray  # (n + w,): the derivatives of the event's time; NaN if they are unknown


@dataclass(frozen=True, eq=False)
class RecordedMotion:
    """A motion in one mode with the steps of its solver, which a backward pass repeats.

    The states of the steps are those of the system, n, followed by the integral of the objective
    and by the sample marker, if there are any.
    """

    motion: Motion
    steps: RecordedSteps
    equations: GradientEquations
    options: Options  # as the solver has read them
    discrete_adjoint: DiscreteAdjoint
    unlimited: str = ""  # why no derivatives limit the step size, if they do not

    @cached_property
    def _rates(self) -> KernelCall:
        equations = self.equations
        return equations.call_full(equations.full_model.compiled("rates"))

    def rates(self, x: np.ndarray, t: float) -> np.ndarray:
        """Return the rates of all states of the steps, at the first n of them."""
        n, width = self.motion.states.shape[1], len(self.steps.end_state)
        full_state = np.append(x[:n], np.zeros(width - n))
        return self._rates.evaluate(self._rates.kernel, full_state, t)

    def projections(self, times: np.ndarray, states: np.ndarray) -> ProjectionAdjoint:
        """Return the adjoint of projections that gave these states."""
        equations, constraints = self.equations, self.options.constraints
        assert constraints is not None
        return ProjectionAdjoint(
            with_all(equations.augmented.model, equations.augmented.definition),
            constraints,
            equations.wrt,
            equations.call,
            times,
            states,
        )

    def at_times(self) -> Trajectory:
        """Return the motion as a Trajectory at the requested times, without dense output."""
        motion = self.motion
        times, states = motion.times.copy(), motion.states.copy()
        return TrajectoryModel(motion.problem).label(
            times, states, events=motion.events, statistics=motion.statistics
        )

    def at_steps(self) -> Trajectory:
        """Return the motion as a Trajectory at the solver's steps."""
        steps, n = self.steps, self.motion.states.shape[1]
        states = np.vstack([steps.states, steps.end_state])[:, :n]
        return TrajectoryModel(self.motion.problem).label(
            np.append(steps.starts, steps.end), states, events=steps.events
        )

    def interrupted(self, times: np.ndarray, states: np.ndarray) -> IntegrationInterrupted:
        """Return the error for an interrupted backward pass; it contains the complete motion."""
        steps, n = self.steps, self.motion.states.shape[1]
        return IntegrationInterrupted(
            "The gradient was interrupted on the way back through the motion, which is whole: it "
            "is in the attributes `times` and `states` of this error.",
            times.copy(), states.copy(), steps.end, steps.end_state[:n].copy(),
            dict(self.motion.statistics),
        )  # fmt: skip

    def event_derivatives(self, record: EventRecord, untimed: bool = False) -> EventDerivatives:
        """Return the derivatives of an event.

        At a grazing event those of its time do not exist: an error, or NaN if `untimed`.
        """
        n, t, x = self.motion.states.shape[1], record.time, record.before
        events = self.options.events
        assert events is not None
        source, equations = events.sources[record.index], self.equations
        kernel, changed = compiled_event(equations.augmented.model, source, equations.wrt)
        call = equations.call(kernel)
        r = np.concatenate([call.inputs(x, t), call.inputs.slopes(t)])
        out = kernel.evaluate(np.array([t]), x[None, :n], r[None], call.p)[0][0]
        blocks = kernel.program.signature.by_block(out)
        time = np.zeros(len(blocks["crossing"]))
        # An event that a jump of an input causes has the jump's time, which is fixed.
        if events.forcing_time(call, record.index, x, t) is None:
            rate, curvature = float(blocks["rate"][0]), float(blocks["curvature"][0])
            tolerances = self.options.atol, self.options.rtol
            atol, rtol = (
                np.broadcast_to(tolerance, len(self.steps.end_state))[:n]
                for tolerance in tolerances
            )
            depth = rate * rate / (2.0 * abs(curvature)) if curvature else abs(rate) * np.inf
            error, lower = CompiledSensitivities.event_resolution(
                depth, blocks["crossing"][:n], x, rtol, atol
            )
            value = events.value_after_jump(call, record.index, x, t, error)
            if value is None and depth > error:
                time = -blocks["crossing"] / rate
            elif untimed:
                time[:] = np.nan
            elif value is not None:
                self._refuse(Outcome.EVENT_JUMPS, record, value=value)
            else:  # a grazing event: its time has no derivative
                earlier = [one for one in self.motion.events if one.time < t]
                accumulates = self.motion.statistics.get("code") == Outcome.EVENTS_ACCUMULATE
                end = np.inf if accumulates else self.steps.end
                lower = CompiledSensitivities.grazing_remedy(lower, [*earlier, record], end)
                self._refuse(
                    Outcome.EVENT_GRAZES, record, depth=depth, explained=error, lower=lower
                )
        return EventDerivatives(blocks, changed, time)

    def _refuse(self, outcome: Outcome, record: EventRecord, **details: object) -> NoReturn:
        text, remedy = (
            part.format(event=record.name, **details) for part in (outcome.text, outcome.remedy)
        )
        motion = self.motion
        k = int(np.searchsorted(motion.times, record.time))
        raise IntegrationError(
            f"The motion {text} at t = {record.time!r}. {remedy}",
            motion.times[:k], motion.states[:k], record.time, record.before,
            dict(motion.statistics),
        )  # fmt: skip


def integrate_recorded(
    problem: Problem,
    solver: Solver,
    ready: PreparedIntegration,
    times: np.ndarray,
    equations: GradientEquations,
    controlled: np.ndarray | None = None,
) -> RecordedMotion:
    """Integrate and judge a motion with recorded steps; errors have a diagnosis.

    With the sensitivities `controlled` at the start, the step size is controlled by them (see
    `with_controlled_columns`). Otherwise those along one direction limit it if they can be
    integrated (see `with_generic_direction`).
    """
    n = len(problem.definition.states)
    run = partial(_run, problem, solver, ready, times, equations, controlled)
    failed: IntegrationError | SingularMatrixError | None = None
    try:
        try:
            recorded = run()
        except (IntegrationError, SingularMatrixError) as error:
            if controlled is not None or not solver.adaptive:
                raise
            failed = error
        if failed is not None:  # the sensitivities may be singular where the motion is not
            recorded = run(limited=False)
            if isinstance(failed, SingularMatrixError):
                recorded = replace(recorded, unlimited="the mass matrix became singular")
            # A derivative that is not finite fails the backward pass if the scalar depends on it.
            elif failed.info["code"] != Outcome.NOT_FINITE:
                reason = f"`{solver.name}` {failed.info['status']} at t = {failed.time:.6g}"
                recorded = replace(recorded, unlimited=reason)
    except (IntegrationError, IntegrationInterrupted, SingularMatrixError) as error:
        if not isinstance(error, SingularMatrixError):
            error.states, error.state = error.states[:, :n], error.state[:n]
            error.motion = motion_so_far(problem, ready, solver, ready.options, error)
        if not isinstance(error, IntegrationInterrupted):
            explain_failure(error, problem, ready, not ready.enforced)
        raise
    judge_motion(recorded.motion)
    return recorded


def _run(
    problem: Problem,
    solver: Solver,
    ready: PreparedIntegration,
    times: np.ndarray,
    equations: GradientEquations,
    controlled: np.ndarray | None,
    limited: bool = True,
) -> RecordedMotion:
    """Integrate once; if `limited`, derivatives along one direction limit the step size."""
    from pydy.solvers import DiscreteAdjoint, Integration

    x0, n, options = problem.x, len(problem.x), ready.options
    rates = equations.call_full(equations.full_model.compiled("rates"))
    width = rates.kernel.program.signature.num_states
    for name in options.keys() & {"rtol", "atol"}:
        if np.size(options[name]) == n > 1 and width > n:  # the integral: the strictest of them
            tolerances = np.asarray(options[name], dtype=float)
            strictest = np.full(width - n, tolerances.min())
            options = {**options, name: np.append(tolerances, strictest)}
    options = with_step_limit(equations.augmented, solver, options, x0, times, False)
    state, call = np.append(x0, np.zeros(width - n)), rates
    if controlled is not None:
        call, state, sensitivities = with_controlled_columns(equations, state, controlled, options)
        options = {**options, "sensitivities": sensitivities}
    elif limited and solver.adaptive:
        call, state, sensitivities = with_generic_direction(equations, state, options)
        options = {**options, "sensitivities": sensitivities}
    read = replace(read_options(solver.name, solver.adaptive, options), recorded=n)
    integration = Integration(solver.name, call, len(state), times, (), read)
    states = integration.run(state)[:, :width]
    for message in integration.event_warnings():
        warn_user(message)
    info = integration.info()
    steps = RecordedSteps.of_run(integration, info, states)
    replayed = replace(rates, switched=steps.switched)
    discrete_adjoint = DiscreteAdjoint(
        solver.name, replayed, equations.rates_vjp(), len(equations.wrt), len(equations.sampled)
    )
    motion = _motion(problem, solver, ready, times, states[:, :n], info, steps)
    return RecordedMotion(motion, steps, equations, read, discrete_adjoint)


def _motion(
    problem: Problem,
    solver: Solver,
    ready: PreparedIntegration,
    times: np.ndarray,
    states: np.ndarray,
    info: dict[str, Any],
    steps: RecordedSteps,
) -> Motion:
    """Return the Motion of an integration with recorded steps."""
    reached, dense = info["reached"], info.get("dense_output")
    return Motion(
        problem=problem,
        integrator=Integrator(solver, ready.enforced),
        options=ready.options,
        times=times[:reached],
        states=states[:reached],
        segments=(Segment(float(times[0]), steps.end, (), problem, dense=dense),),
        events=steps.events,
        statistics=info,
    )
