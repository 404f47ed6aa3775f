"""Integrate a Problem: call a solver with its prepared equations, and return a Motion.

`integrate` does not check the result. `simulate` also warns of doubtful results, for users.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._checks import flag, real_array
from pydy._errors import (
    IntegrationError,
    IntegrationInterrupted,
    SingularMatrixError,
    warn_user,
)
from pydy._integration.sensitivity_request import SensitivityRequest
from pydy._judges import check_resets, explain, judge_motion, judge_start, jumps_by_time, stuck_at
from pydy._motion import (
    MORE_STEPS,
    EvaluationRecorder,
    Integrator,
    Motion,
    PreparedIntegration,
    Segment,
    SolveIvp,
    call_odeint,
    came_to_the_end,
    is_odeint,
    labelled,
    prepare,
)
from pydy._problem import AssumptionChecks, Problem
from pydy.codegen import rates_function
from pydy.solvers import EventContinuation, Outcome, Prepared, Solver
from pydy.trajectory import Trajectory

if TYPE_CHECKING:
    from pydy._sympy_types import SymbolOrName

SolverFunction = Callable[..., Any]


def integrate(
    problem: Problem,
    times: np.ndarray,
    *,
    solver: SolverFunction,
    sensitivities: SensitivityRequest | None = None,
    **options: object,
) -> Motion:
    """Integrate a Problem from its state, and return the Motion.

    Parameters
    ----------
    problem : Problem
        The motion begins at its state, at the first of the `times`.
    times : ndarray, shape (m,)
        At least two, ascending or descending.
    solver : callable
        A native solver, one of SciPy's, or a function with the signature of odeint.
    sensitivities : SensitivityRequest, optional
        The parameters by which the states are differentiated.
    **options
        Those of `System.simulate`: tolerances, `events`, `constraints`.

    Returns
    -------
    Motion

    Raises
    ------
    ValueError, SingularMatrixError, IntegrationError
        As in `System.simulate`, but the result is not checked: a motion may have left its
        constraints, or its sensitivities may ignore a jump. See `pydy._judges.judges`. An
        IntegrationError has the Motion so far as its attribute `motion`.
    """
    if problem.hybrid is not None:
        return _hybrid_motion(problem, times, solver, sensitivities, options)
    user_options = _with_full_output(solver, options)
    ready, times = prepare(problem, times, solver, user_options, alone=sensitivities is None)
    result = call_solver(problem, ready, times, solver, user_options, sensitivities)
    return motion_of(problem, ready, times, solver, result, user_options, sensitivities)


def simulate(
    problem: Problem,
    times: np.ndarray,
    *,
    solver: SolverFunction,
    sensitivities: SensitivityRequest | SymbolOrName | Iterable[SymbolOrName] | None = None,
    control_sensitivities: bool = False,
    **options: object,
) -> Motion:
    """Integrate like `integrate`, and check the start and the Motion: see `judges`.

    `sensitivities` may also be the parameters alone, which `control_sensitivities` belongs to: both
    are arguments of `System.simulate`. The Motion's segments have the augmented equations.
    """
    request = requested_sensitivities(sensitivities, control_sensitivities)
    if problem.hybrid is not None:  # its segments are checked in `integrate`
        return _hybrid_motion(problem, times, solver, request, options)
    user_options = _with_full_output(solver, options)
    ready, times = prepare(problem, times, solver, user_options, alone=request is None)
    judge_start(problem, times, ready)
    result = call_solver(problem, ready, times, solver, user_options, request)
    motion = motion_of(problem, ready, times, solver, result, user_options, request)
    judge_motion(motion)
    return motion


def requested_sensitivities(
    sensitivities: SensitivityRequest | SymbolOrName | Iterable[SymbolOrName] | None,
    control_sensitivities: object,
) -> SensitivityRequest | None:
    """Return the request of two arguments of `System.simulate`; a request stays as it is."""
    controlled = flag(control_sensitivities, "`control_sensitivities`")
    if sensitivities is None or isinstance(sensitivities, SensitivityRequest):
        return sensitivities
    return SensitivityRequest(sensitivities, controlled)


def _hybrid_motion(
    problem: Problem,
    times: np.ndarray,
    solver: SolverFunction,
    sensitivities: SensitivityRequest | None,
    options: dict[str, object],
) -> Motion:
    assert problem.hybrid is not None
    motion: Motion = problem.hybrid.integrate(
        problem, times, solver=solver, sensitivities=sensitivities, **options
    )
    return motion


def _with_full_output(solver: SolverFunction, options: dict[str, object]) -> dict[str, object]:
    """Return options with which a solver returns all data of a Motion."""
    if isinstance(solver, Solver):
        return {"dense_output": True, "full_output": True, **options}
    if isinstance(solver, SolveIvp) or is_odeint(solver):
        return {"full_output": True, **options}
    return options


def integrate_states(
    problem: Problem, times: np.ndarray, *, solver: SolverFunction, checked: bool, **options: object
) -> Any:
    """Return a solver's result for `System.integrate`, checked as by `simulate`.

    If `checked`, raise if odeint gives up; otherwise its result is returned unchanged.
    """
    ready, times = prepare(problem, times, solver, options)
    judge_start(problem, times, ready)
    result = call_solver(problem, ready, times, solver, options, checked=checked)
    if ready.constrained or AssumptionChecks(problem).judged() or result.evaluated is not None:
        motion = readable_motion(problem, ready, times, solver, result)
        if motion is not None:
            judge_motion(motion)
    if "dense_output" not in options and "dense_output" in ready.options:
        result.info.pop("dense_output", None)  # needed for the checks, not by the user
    return result.returned


# -- Solvers ---------------------------------------------------------------------------------------


@dataclass(slots=True)
class SolverResult:
    """The result of a solver."""

    returned: object  # the value that `System.integrate` returns
    states: Any
    info: dict[str, Any]  # empty if it is not needed
    options: dict[str, object]  # those passed to the solver
    evaluated: EvaluationRecorder | None = None


def call_solver(
    problem: Problem,
    ready: PreparedIntegration,
    times: np.ndarray,
    solver: SolverFunction,
    user_options: dict[str, object],
    sensitivities: SensitivityRequest | None = None,
    checked: bool = True,
) -> SolverResult:
    """Call a solver with a prepared integration.

    If `checked`, raise if odeint gives up; otherwise its result is returned unchanged.
    """
    options = (
        {**ready.options, "continuation": user_options["continuation"]}
        if "continuation" in user_options
        else ready.options
    )
    try:
        if isinstance(solver, Solver):
            return _call_native(problem, ready, times, solver, user_options, options, sensitivities)
        if "args" in options:
            raise TypeError(
                "`args` are the specifieds and constants, which a System hands to its "
                "`ode_solver`: set `specifieds` and `constants`."
            )
        f, x0 = rates_function(ready.code, problem.inputs), problem.x
        if sensitivities is not None:
            f, x0, options = sensitivities.augment(problem, ready.code, times, solver, options)
        args = (
            problem.inputs.values.copy() if problem.inputs.constant else problem.inputs,
            problem.p,
        )
        if isinstance(solver, SolveIvp) or is_odeint(solver):
            return _call_scipy(
                problem, ready, times, solver, user_options, options, (f, x0, args), checked
            )
        return _call_users(times, solver, options, (f, x0, args))
    except TypeError as error:
        if not isinstance(solver, (Solver, SolveIvp)):
            error.add_note(
                "This came from the `ode_solver`, called as ode_solver(f, x0, t, args=(r, p), "
                "**options)."
            )
        raise
    except (IntegrationInterrupted, IntegrationError, SingularMatrixError) as error:
        if sensitivities is not None:
            sensitivities.cut(error)
        if not isinstance(error, SingularMatrixError):
            error.motion = motion_so_far(problem, ready, solver, options, error)
        if isinstance(error, IntegrationInterrupted):
            raise
        explain_failure(error, problem, ready, isinstance(solver, Solver) and not ready.enforced)
        raise


def _call_native(
    problem: Problem,
    ready: PreparedIntegration,
    times: np.ndarray,
    solver: Solver,
    user_options: dict[str, object],
    options: dict[str, Any],
    sensitivities: SensitivityRequest | None,
) -> SolverResult:
    """Call a native solver, with the latest call's memory if it is free."""
    full, inputs = user_options.get("full_output", False), problem.plan.inputs
    if sensitivities is not None:
        f, x0, options = sensitivities.augment(problem, ready.code, times, solver, options)
        args = inputs.values.copy() if inputs.constant else inputs, problem.p
        states, info = solver(f, x0, times, args=args, **{**options, "full_output": True})
        return SolverResult((states, info) if full else states, states, info, options)
    prepared: Prepared | None = None
    with suppress(IndexError):
        prepared, stored_options = ready.free.pop()  # no other thread has it then
        if stored_options is not ready.options and not prepared.retune(solver, ready.options):
            prepared = None
    if prepared is None or not prepared.renumber(problem.p, inputs.values, times):
        f, r = rates_function(ready.code, inputs), inputs.values if inputs.constant else inputs
        prepared = solver.prepare(f, problem.x, times, (r, problem.p), **options)
        prepared.on_many_steps = partial(_warn_of_many_steps, ready)
    ready.problem = problem
    prepared.continuation = options.get("continuation")
    states = prepared(problem.x)
    if prepared.reusable:
        ready.free = [(prepared, ready.options)]
    info = prepared.info if full or ready.constrained or AssumptionChecks(problem).judged() else {}
    return SolverResult((states, info) if full else states, states, info, options)


def _call_scipy(
    problem: Problem,
    ready: PreparedIntegration,
    times: np.ndarray,
    solver: SolverFunction,
    user_options: dict[str, object],
    options: dict[str, object],
    call: tuple[Callable[..., np.ndarray], np.ndarray, tuple[object, np.ndarray]],
    checked: bool,
) -> SolverResult:
    """Call odeint or solve_ivp; record their evaluations if the checks need these."""
    (f, x0, args), evaluated, odeint = call, None, is_odeint(solver)
    jumps = None if ready.never_jumps else jumps_by_time(f, args, times)
    ready.never_jumps = jumps is None
    jumps = np.zeros((0, 3)) if jumps is None else jumps
    if len(jumps) or (odeint and AssumptionChecks(problem).judged()):
        f = evaluated = EvaluationRecorder(f, jumps)
    if odeint and checked:
        states, info = call_odeint(f, x0, times, args, problem.definition.states, options)
    else:
        options = {**options, "full_output": True}
        states, info = solver(f, x0, times, args=args, **options)
    returned = (states, info) if user_options.get("full_output", False) else states
    return SolverResult(returned, states, info, options, evaluated)


def _call_users(
    times: np.ndarray,
    solver: SolverFunction,
    options: dict[str, object],
    call: tuple[Callable[..., np.ndarray], np.ndarray, tuple[object, np.ndarray]],
) -> SolverResult:
    """Call a user-defined solver."""
    f, x0, args = call
    returned = solver(f, x0, times, args=args, **options)
    pair = isinstance(returned, tuple) and len(returned) == 2
    states, info = returned if pair else (returned, None)
    return SolverResult(returned, states, info if isinstance(info, dict) else {}, options)


# -- Motions ---------------------------------------------------------------------------------------


def motion_of(
    problem: Problem,
    ready: PreparedIntegration,
    times: np.ndarray,
    solver: SolverFunction,
    result: SolverResult,
    user_options: dict[str, object],
    sensitivities: SensitivityRequest | None = None,
) -> Motion:
    """Return the Motion of a solver's result."""
    n, statistics = len(problem.definition.states), dict(result.info)
    times = statistics.pop("times", times)
    reached = statistics.pop("reached", None)  # an event may have ended it
    states = result.states
    if reached is not None:
        times, states = times[:reached], states[:reached]
    events = statistics.pop("events", ())
    dense = statistics.pop("dense_output", None)
    native = isinstance(solver, Solver)
    if sensitivities is not None and not native:
        dense = None
        events = [replace(e, before=e.before[:n], after=e.after[:n]) for e in events]
    times = np.array(times, dtype=float)
    states = np.array(
        real_array(states, "What the `ode_solver` returns, states or (states, info),")
    )
    width = n if sensitivities is None else sensitivities.augmented.columns.size
    if states.shape != (len(times), width):
        raise ValueError(
            f"The `ode_solver` must return the shape {(len(times), n)}, one row "
            f"for each of the `times`, got {states.shape}. One that ends early tells the times of "
            "its rows: return (states, {'times': times})."
        )
    if len(times):  # rows of NaN at the end follow a terminal event
        rows = len(times) - np.isnan(states).all(axis=1)[::-1].argmin()
        times, states = times[:rows], states[:rows]
    values, augmented, refusal = None, None, ""
    if sensitivities is not None:
        augmented = sensitivities.augmented
        states, values = map(np.ascontiguousarray, augmented.columns.split(states))
        refusal = (
            "`sensitivities` of a motion that is continued are not known. Simulate over the "
            "whole time at once, or without `sensitivities`."
        )
    elif statistics.get("code") == Outcome.EVENTS_ACCUMULATE:
        refusal = (
            f"The motion ended at t = {statistics['time']!r}, where events accumulate: nothing "
            f"says how it goes on. {Outcome.EVENTS_ACCUMULATE.remedy}"
        )
    options, errors_known = result.options, True
    if isinstance(solver, SolveIvp):
        defaults = solver.tolerances(options)
        errors_known = bool(defaults)  # False for a user-defined method
        options = {**defaults, **{k: v for k, v in options.items() if v is not None}}
    elif not (native or is_odeint(solver)):
        errors_known = False
    start, end = (float(times[0]), float(times[-1])) if len(times) else (problem.t, problem.t)
    if statistics.get("code") == Outcome.TERMINATED:
        end = float(statistics["time"])
    return Motion(
        problem=problem,
        integrator=Integrator(solver, ready.enforced, errors_known, result.evaluated),
        options=options,
        times=times,
        states=states,
        segments=(Segment(start, end, (), problem, dense=dense, augmented=augmented),),
        events=events,
        statistics=statistics,
        sensitivities=values,
        label=partial(labelled, proceed=partial(_continued, user_options), refusal=refusal),
    )


def readable_motion(
    problem: Problem,
    ready: PreparedIntegration,
    times: np.ndarray,
    solver: SolverFunction,
    result: SolverResult,
) -> Motion | None:
    """Return a Motion to check, or None if a solver gave up or its result is not a motion."""
    if is_odeint(solver) and not came_to_the_end(result.states, result.info):
        return None
    with suppress(TypeError, ValueError):
        motion = motion_of(problem, ready, times, solver, result, {})
        return motion if len(motion.times) else None
    return None


def motion_so_far(
    problem: Problem,
    ready: PreparedIntegration,
    solver: SolverFunction,
    options: dict[str, object],
    error: IntegrationError | IntegrationInterrupted,
) -> Motion:
    """Return the Motion up to the failure of an integration."""
    start = float(error.times[0]) if len(error.times) else error.time
    return Motion(
        problem=problem,
        integrator=Integrator(solver, ready.enforced),
        options=options,
        times=error.times,
        states=error.states,
        segments=(Segment(start, error.time, (), problem),),
        events=error.info.get("events", ()),
        statistics=error.info,
        label=partial(labelled, refusal="The integration failed where this motion ends."),
    )


def _continued(user_options: dict[str, object], motion: Motion, times: np.ndarray) -> Trajectory:
    """Return the continuation of a motion at `times`, which begin at its end."""
    options: dict[str, Any] = dict(user_options)
    solver, sides = motion.integrator.solver, motion.statistics.get("sides")
    if isinstance(solver, Solver) and user_options.get("events"):
        options["continuation"] = EventContinuation(None, sides)
    return simulate(motion.last, times, solver=solver, **options).trajectory


# -- Failures --------------------------------------------------------------------------------------

_GIVEN_UP = (Outcome.TOO_MANY_STEPS, Outcome.STEP_UNDERFLOW, Outcome.NO_CONVERGENCE)


def explain_failure(
    error: IntegrationError | SingularMatrixError,
    problem: Problem,
    ready: PreparedIntegration,
    free: bool,
) -> None:
    """Add the cause to a failed motion's error, and warn of earlier resets off the constraints."""
    if isinstance(error, IntegrationError) and error.info.get("code") in _GIVEN_UP:
        stuck = _stuck_at(problem, ready, error.time, error.state)
        if stuck is not None:
            text = str(error)
            for remedy in (MORE_STEPS, *(outcome.remedy for outcome in _GIVEN_UP)):
                text = text.removesuffix(remedy)
            error.args = (f"{text.rstrip()} {stuck}",)
            return
    explain(error, lambda t, x: replace(problem.at(t, x), model=ready.code))
    if ready.constrained and free and isinstance(error, IntegrationError):
        info = error.info
        check_resets(info["events"], problem.at)


def _stuck_at(problem: Problem, ready: PreparedIntegration, t: float, x: np.ndarray) -> str | None:
    """Describe what keeps a motion from going on, or return None.

    It is an input that differs from call to call, or a jump at which the motion stays (`stuck_at`).
    """
    states = np.array([t]), np.array([x])
    at = replace(problem.at(*states), model=ready.code)
    again = problem.at(*states).r[0]
    for symbol, first, second in zip(at.definition.specifieds, at.r[0], again, strict=False):
        if first != second and not (np.isnan(first) and np.isnan(second)):
            return (
                f"The function for `{symbol}` has several values at one time and state, such as "
                f"{first:.6g} and {second:.6g}, so that errors do not shrink with the steps. Draw "
                f"random numbers before: `SampledInput(times, values)`."
            )
    return stuck_at(at, ready.span)


def _warn_of_many_steps(ready: PreparedIntegration, steps: int, t: float, x: np.ndarray) -> None:
    problem = ready.problem
    stuck = None if problem is None else _stuck_at(problem, ready, t, x)
    if stuck is not None:
        warn_user(f"The solver has taken more than {steps} steps by t = {t:.4g}. {stuck}")
