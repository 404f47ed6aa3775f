"""What `System.integrate` and `System.simulate` do: a solver called, its result with names."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import scipy

from pydy._assembly.definition import Definition
from pydy._assembly.model import CompiledModel
from pydy._checks import flag, real_array
from pydy._errors import IntegrationError, IntegrationInterrupted, SingularMatrixError
from pydy._system.causes import explain
from pydy._system.dependents import latest_dependents
from pydy._system.inputs import check_times
from pydy._system.scipy_ivp import SolveIvp
from pydy._system.scipy_odeint import call_odeint, odeint_options
from pydy._system.sensitivities import Wanted
from pydy._system.snapshot import Snapshot
from pydy._system.solving import prepare
from pydy._system.start import check_resets, check_start
from pydy.codegen.right_hand_side import rates_function
from pydy.solvers.options import check_option_names
from pydy.solvers.solver import Solver
from pydy.trajectory import Trajectory

__all__ = ["Start", "begin", "integrate", "simulate"]

SolverFunction = Callable[..., Any]


def integrate(now: Snapshot, solver: SolverFunction, options: dict[str, Any]) -> Any:
    """Return what a solver returns.

    Parameters
    ----------
    now : Snapshot
    solver : callable
        With the signature of odeint.
    options : dict
        For the solver, and those that `prepare` understands.
    """
    full = options.get("full_output", False)
    if solver is scipy.integrate.odeint or isinstance(solver, (Solver, SolveIvp)):
        full = flag(full, "`full_output`")
    return _solve(now, solver, options, checked=not full)


def simulate(
    now: Snapshot,
    solver: SolverFunction,
    options: dict[str, Any],
    sensitivities: tuple[Any, Any, Any],
) -> Trajectory:
    """Return what a solver returns as a Trajectory.

    Parameters
    ----------
    now, solver, options
        As in `integrate`.
    sensitivities : (parameters, control, dependent)
        By what the states are differentiated, or None; whether the step control looks at that; and
        the initial conditions that follow from the others, None for those of the method.
    """
    if solver is scipy.integrate.odeint or isinstance(solver, (Solver, SolveIvp)):
        options = {"full_output": True, **options}
    if isinstance(solver, Solver):
        options = {"dense_output": True, **options}
    wanted, n = None, len(now.definition.states)
    parameters, control, dependent = sensitivities
    if parameters is not None:
        wanted = Wanted(parameters, flag(control, "`control_sensitivities`"))
    result = _differentiated(now, solver, options, wanted, dependent)
    states, info = result if isinstance(result, tuple) else (result, None)
    statistics = dict(info) if isinstance(info, dict) else {}
    times = statistics.pop("times", now.times)
    reached = statistics.pop("reached", None)  # an event may have ended it
    if reached is not None:
        times, states = times[:reached], states[:reached]
    events = statistics.pop("events", ())
    dense = statistics.pop("dense_output", None)
    if wanted is not None and dense is not None:
        dense = dense.selected(wanted.select) if isinstance(solver, Solver) else None
    times = np.array(times, dtype=float)
    states = np.array(real_array(states, "What the `ode_solver` returns"))
    width = n if wanted is None else wanted.sensitive.columns.size
    if states.shape != (len(times), width):
        raise ValueError(
            f"The `ode_solver` must return the shape {(len(times), n)}, one row "
            f"for each of the `times`, got {states.shape}."
        )
    if len(times):  # what is NaN to the end comes after a terminal event
        reached = len(times) - np.isnan(states).all(axis=1)[::-1].argmin()
        times, states = times[:reached], states[:reached]
    states, found = (states, {}) if wanted is None else wanted.results(states)
    return now.trajectory(
        times, states, events=events, statistics=statistics or None, dense=dense, **found
    )


def _differentiated(
    now: Snapshot, solver: Any, options: dict[str, Any], wanted: Wanted | None, dependent: Any
) -> Any:
    """Call the solver; where sensitivities have become NaN, again by what holds everywhere."""
    try:
        result = _solve(now, solver, options, checked=True, wanted=wanted, dependent=dependent)
    except (IntegrationError, SingularMatrixError):
        if wanted is None or not wanted.take_systems():
            raise
    else:
        states = result[0] if isinstance(result, tuple) else result
        if wanted is None or np.isfinite(states).all() or not wanted.take_systems():
            return result
    return _solve(now, solver, options, checked=True, wanted=wanted, dependent=dependent)


class Start(NamedTuple):
    """What is integrated.

    Attributes
    ----------
    times : ndarray
    model : CompiledModel
        With the expressions for specifieds compiled in.
    options : dict
        For the solver.
    """

    times: np.ndarray
    model: CompiledModel
    options: dict[str, Any]


def begin(now: Snapshot, solver: SolverFunction, options: dict[str, Any]) -> Start:
    """Check what a simulation begins with, and get the equations and options ready."""
    if len(now.times) < 2:
        raise ValueError(
            "`times` must have at least two values before integrate() can be called, got "
            f"{len(now.times)}. Set `system.times`."
        )
    times = check_times(now.times)  # the array may have been edited in place
    definition, plan = now.definition, now.plan
    plan.check_times(times, "times")
    if _is_constrained(definition):
        t = float(times[0])
        mended = options.get("constraints") is not None
        check_start(definition, now.driven, t, now.x, plan(now.x, t), now.p, mended=mended)
    model, options = prepare(solver, definition, now.model, plan, options)
    return Start(times, model, options)


def _is_constrained(definition: Definition) -> bool:
    return bool(definition.equations.velocity or definition.equations.holonomic)


def _solve(
    now: Snapshot,
    solver: SolverFunction,
    options: dict[str, Any],
    *,
    checked: bool,
    wanted: Wanted | None = None,
    dependent: Any = None,
) -> Any:
    """Call the solver; `checked` tells whether odeint's giving up is an error."""
    free, full = options.get("constraints") is None, options.get("full_output", False)
    ready = begin(now, solver, options)
    definition, plan, model, options = now.definition, now.plan, ready.model, ready.options
    times, x0, p = ready.times, now.x, now.p
    if solver is scipy.integrate.odeint:
        check_option_names("odeint", odeint_options(), options)
    if wanted is None:
        f = rates_function(model, plan)
    else:
        following = latest_dependents(definition, dependent)
        places = [definition.states.index(symbol) for symbol in following]
        start = (x0, float(times[0]))
        f, x0, options = wanted.problem(definition, model, plan, start, p, places, solver, options)
    args = (plan.values if plan.constant else plan, p)
    if watched := "events" in options and free and _is_constrained(definition):
        options = {**options, "full_output": True}
    try:
        if not checked or solver is not scipy.integrate.odeint:
            result = solver(f, x0, times, args=args, **options)
            if watched:
                check_resets(definition, now.driven, result[1]["events"], plan, p)
            return result[0] if watched and not full else result
        result = call_odeint(f, x0, times, args, definition.states, options)
    except TypeError as error:
        if not isinstance(solver, (Solver, SolveIvp)):
            error.add_note(
                "This came from the `ode_solver`, called as ode_solver(f, x0, t, args=(r, p), "
                "**options)."
            )
        raise
    except IntegrationInterrupted as stop:
        if wanted is not None:
            wanted.cut(stop)
        raise
    except (IntegrationError, SingularMatrixError) as error:
        if wanted is not None:
            wanted.cut(error)
        explain(error, definition, model, plan, p)
        if watched and isinstance(error, IntegrationError):
            info: Any = error.info
            check_resets(definition, now.driven, info["events"], plan, p)
        raise
    return result if options.get("full_output") else result[0]
