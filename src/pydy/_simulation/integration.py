"""Prepare an integration, call the solver, and check the computed motion."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from copy import copy
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from pydy._assembly.baumgarte import stabilised
from pydy._assembly.definition import Definition
from pydy._assembly.model import CompiledModel
from pydy._assembly.specifieds import driven
from pydy._checks import choice, positive, real_array
from pydy._errors import (
    IntegrationError,
    IntegrationInterrupted,
    SingularMatrixError,
    warn_user,
)
from pydy._simulation.assumptions import AssumptionMonitor
from pydy._simulation.constraint_drift import DriftCheck, check_drift, check_resets, check_start
from pydy._simulation.diagnostics import explain
from pydy._simulation.discontinuities import EvaluationRecorder, warn_of_impulses, warn_of_pulses
from pydy._simulation.events_and_constraints import (
    check_events,
    compile_constraints,
    compile_events,
    with_residuals_held,
)
from pydy._simulation.problem import Problem
from pydy._simulation.scipy_solvers import (
    MORE_STEPS,
    SolveIvp,
    call_odeint,
    came_to_the_end,
    is_odeint,
    odeint_options,
)
from pydy._simulation.sensitivities import SensitivityRequest
from pydy._simulation.sliding import stuck_at
from pydy.codegen.arguments import SpecifiedsPlan
from pydy.codegen.right_hand_side import rates_function
from pydy.solvers.events import Event, identified
from pydy.solvers.options import Begun, Options, check_option_names, named_for_odeint
from pydy.solvers.outcome import (
    EVENTS_ACCUMULATE,
    FINISHED,
    NO_CONVERGENCE,
    OUTCOMES,
    STEP_UNDERFLOW,
    TERMINATED,
    TOO_MANY_STEPS,
)
from pydy.solvers.solver import Prepared, Solver
from pydy.solvers.tuning import MANY_STEPS
from pydy.trajectory import Trajectory

SolverFunction = Callable[..., Any]


_PLAIN = frozenset((float, int, bool, str, type(None)))  # an array may be edited between two calls


_STEPPING = frozenset(
    ("rtol", "atol", "first_step", "max_step", "max_steps", "step", "hmax", "h0", "hmin", "mxstep")
)


class PreparedIntegration:
    """A prepared integration, which can be repeated with other numbers."""

    def __init__(
        self,
        definition: Definition,
        model: CompiledModel,
        plan: SpecifiedsPlan,
        solver: Any,
        given: dict[str, Any],
    ) -> None:
        self._plan, self._solver, self._given = plan, solver, dict(given)
        self._events = identified(given.get("events"))
        self.constrained = definition.equations.constrained
        self.model, self.options = self._prepared(definition, model)
        self.read: Options | None = None  # as the solver has read them
        self.now: Problem | None = None  # of the latest call
        # What the latest call has reserved, with its options, if no other call has it.
        self.free: list[tuple[Prepared, dict[str, Any]]] = []

    def _prepared(
        self, definition: Definition, model: CompiledModel
    ) -> tuple[CompiledModel, dict[str, Any]]:
        """Return the model with options that change the equations compiled in, and the others."""
        options, equations = dict(self._given), definition.equations
        if is_odeint(self._solver):
            options = named_for_odeint(options)
        constraints, events, gain = (
            options.pop(name, None) for name in ("constraints", "events", "gain")
        )
        constraints = choice(constraints, (None, "project", "baumgarte"), "`constraints`")
        if constraints == "project" and not (equations.holonomic or equations.velocity):
            raise ValueError("`constraints='project'` holds constraints, but the system has none.")
        if constraints == "baumgarte" and not equations.velocity:
            raise ValueError(
                "`constraints='baumgarte'` works on velocity constraints, but the system has none. "
                "Give KanesMethod `velocity_constraints`, or use constraints='project'."
            )
        if (gain is None) == (constraints == "baumgarte"):
            raise ValueError(
                "`gain` and `constraints='baumgarte'` belong together: the gain g > 0, in 1/s, "
                "lets residuals die out about as exp(−g t). Pass both or neither."
            )
        if constraints == "baumgarte":
            gain = positive(gain, "`gain`", finite=True)
            model = model.changed(("baumgarte", gain), lambda own: stabilised(own, gain))
        projected = constraints == "project"
        if events is not None and self._looks_itself(events):
            options["events"], events = events, None
        if not isinstance(self._solver, Solver) and (projected or events is not None):
            what = "constraints='project'" if projected else "events"
            raise ValueError(
                f"`{what}` needs a native solver: set `system.ode_solver = 'dop853'`, or another "
                "one of pydy.solvers."
            )
        model = driven(model, definition, self._plan)
        if projected:
            options["constraints"] = compile_constraints(model, definition)
        if checked := check_events(events, definition.places["states"]):
            options["events"] = compile_events(model, definition, checked)
        return model, options

    def _looks_itself(self, events: Any) -> bool:
        """Return whether the solver has events of its own: a user's, and solve_ivp's functions."""
        if isinstance(self._solver, Solver) or is_odeint(self._solver):
            return False
        if not isinstance(self._solver, SolveIvp):
            return True
        several = events if isinstance(events, (list, tuple)) else [events]
        return not any(isinstance(event, Event) for event in several)

    def is_compatible(self, plan: SpecifiedsPlan, solver: Any, given: dict[str, Any]) -> bool:
        """Return whether a call differs in numbers alone, as far as that can be seen."""
        if solver is not self._solver or [*given] != [*self._given]:
            return False
        for name, value in given.items():  # at each call: what is said below, in line
            known = self._given[name]
            plain = type(value) in _PLAIN and type(value) is type(known) and value == known
            # What a run begins with, `begun`, it is told itself.
            if not (plain or name == "begun" or (name == "events" and self._alike(name, value))):
                return False
        return plan is self._plan or self._as_planned(plan)

    def _alike(self, name: str, value: Any) -> bool:
        known = self._given[name]
        if name == "events":
            return self._events is not None and self._events == identified(value)
        return type(value) in _PLAIN and type(value) is type(known) and bool(value == known)

    def retuned(
        self, plan: SpecifiedsPlan, solver: Any, given: dict[str, Any]
    ) -> PreparedIntegration | None:
        """Return the same with other tolerances or step sizes, where no more differs, or None."""
        native = isinstance(solver, Solver)
        if solver is not self._solver or not (native or [*given] == [*self._given]):
            return None  # of other solvers, names were checked
        rest = [name for name in given if name not in _STEPPING]
        if rest != [name for name in self._given if name not in _STEPPING]:
            return None
        if not (all(self._alike(name, given[name]) for name in rest) and self._as_planned(plan)):
            return None
        other, own = copy(self), {name: v for name, v in given.items() if name in _STEPPING}
        other._given = dict(given)
        kept = {name: v for name, v in self.options.items() if not native or name not in _STEPPING}
        other.options = {**kept, **(named_for_odeint(own) if is_odeint(solver) else own)}
        return other

    def _as_planned(self, plan: SpecifiedsPlan) -> bool:
        known = self._plan
        return plan is known or (
            plan.expressions is known.expressions
            and plan.sampled is known.sampled
            and plan._functions is known._functions
        )


def begin(
    now: Problem, solver: SolverFunction, given: dict[str, Any]
) -> tuple[PreparedIntegration, np.ndarray]:
    """Check the state at the start; return the prepared integration and the times."""
    latest = now.model.latest
    if len(now.times) < 2:
        raise ValueError(
            "`times` must have at least two values before integrate() can be called, got "
            f"{len(now.times)}. Set `system.times`."
        )
    times, plan = now.checked_times(), now.plan
    if plan.sampled:
        plan.check_times(times, "times")
    ready: PreparedIntegration | None = latest.get("simulation")
    if ready is not None and not ready.is_compatible(plan, solver, given):
        ready = latest["simulation"] = ready.retuned(plan, solver, given)
    if now.definition.equations.constrained if ready is None else ready.constrained:
        mended = given.get("constraints") is not None
        check_start(now.at(times[:1], now.x[None]), mended=mended)
    if ready is None:
        ready = PreparedIntegration(now.definition, now.model, plan, solver, given)
        if is_odeint(solver):
            check_option_names("odeint", odeint_options(), ready.options)
        latest["simulation"] = ready
        if plan.expressions or ready.constrained:
            warn_of_impulses(now, times)
    return ready, times


def _run(
    ready: PreparedIntegration, solver: Solver, now: Problem, times: np.ndarray, own: dict[str, Any]
) -> tuple[np.ndarray, Prepared]:
    """Integrate by a native solver, with the latest call's memory if it is free."""
    plan = now.plan
    prepared: Prepared | None = None
    with suppress(IndexError):
        prepared, options = ready.free.pop()  # no other thread has it then
        if options is not ready.options and not prepared.retune(solver, ready.options):
            prepared = None
    if prepared is None or not prepared.renumber(now.p, plan.values, times):
        f, r = rates_function(ready.model, plan), plan.values if plan.constant else plan
        prepared = solver.prepare(f, now.x, times, (r, now.p), **own)
        prepared.on_many_steps = partial(_warn_of_many_steps, ready)
    ready.now = now
    prepared.begun = own.get("begun")
    states = prepared(now.x)
    if prepared.reusable:
        ready.free = [(prepared, ready.options)]
    return states, prepared


def run_solver(
    now: Problem,
    solver: SolverFunction,
    given: dict[str, Any],
    *,
    checked: bool,
    wanted: SensitivityRequest | None = None,
) -> Any:
    """Call the solver; `checked` tells whether odeint's giving up is an error."""
    if now.definition.equations.implicit is not None:
        given = with_residuals_held(now.definition, solver, given)
    free, full = given.get("constraints") is None, given.get("full_output", False)
    watch = None
    if now.definition.assumes_motions and now.contradicted is not None:
        watch = AssumptionMonitor.of(now, solver, given, wanted is None)
        given = watch.options
    ready, times = begin(now, solver, given)
    own = {**ready.options, "begun": given["begun"]} if "begun" in given else ready.options
    native = isinstance(solver, Solver)
    watched = ready.constrained and isinstance(solver, (Solver, SolveIvp))
    pair = True  # whether states come with information, even if that is not asked for
    try:
        if wanted is None and isinstance(solver, Solver):
            states, prepared = _run(ready, solver, now, times, own)
            needed = full or watched or watch is not None
            info, options = prepared.info if needed else {}, own
            result: Any = states, info
        else:
            f, x0, options = rates_function(ready.model, now.plan), now.x, own
            if wanted is not None:
                f, x0, options = wanted.problem(now, ready.model, float(times[0]), solver, options)
            args = now.plan.values.copy() if now.plan.constant else now.plan, now.p
            asked = None
            of_scipy = isinstance(solver, SolveIvp) or is_odeint(solver)
            if of_scipy and now.plan.sampled and now.jumps().size:
                f = asked = EvaluationRecorder(f)
            if watch is not None:
                f = watch.watching(f)
            if checked and is_odeint(solver):
                result = call_odeint(f, x0, times, args, now.definition.states, options)
            elif watched or (watch is not None and isinstance(solver, SolveIvp)):
                whole = {**options, "full_output": True}
                result = solver(f, x0, times, args=args, **whole)
            else:
                if "args" in options:
                    raise TypeError(
                        "`args` are the specifieds and constants, which a System hands to its "
                        "`ode_solver`: set `specifieds` and `constants`."
                    )
                result, pair = solver(f, x0, times, args=args, **options), False
            if asked is not None and (motion := _motion(now, solver, times, result, options, True)):
                tolerances = motion.ran.rtol, motion.ran.atol
                warn_of_pulses(now, asked.times, motion.times, motion.states, tolerances)
        if watch is not None:
            result = watch.judged(times, result)
        if ready.constrained:
            if native:
                states, info = result
                judge_motion(now, times, states, info, options, free)
            elif motion := _motion(now, solver, times, result, options, not free):
                check_drift(motion)
    except TypeError as error:
        if not isinstance(solver, (Solver, SolveIvp)):
            error.add_note(
                "This came from the `ode_solver`, called as ode_solver(f, x0, t, args=(r, p), "
                "**options)."
            )
        raise
    except (IntegrationInterrupted, IntegrationError, SingularMatrixError) as error:
        if wanted is not None:
            wanted.cut(error)
        if isinstance(error, IntegrationInterrupted):
            raise
        explain_failure(error, now, ready, native and free)
        raise
    return result[0] if pair and not full else result


def simulated(
    now: Problem,
    solver: SolverFunction,
    given: dict[str, Any],
    wanted: SensitivityRequest | None = None,
) -> dict[str, Any]:
    """Integrate, and return what `Problem.trajectory` takes."""
    native, n = isinstance(solver, Solver), len(now.definition.states)
    options = {"dense_output": True, **given} if native else given
    if native or isinstance(solver, SolveIvp) or is_odeint(solver):
        options = {"full_output": True, **options}
    result = run_solver(now, solver, options, checked=True, wanted=wanted)
    pair = isinstance(result, tuple) and len(result) == 2
    states, info = result if pair else (result, None)
    statistics = dict(info) if isinstance(info, dict) else {}
    times = statistics.pop("times", now.times)
    reached = statistics.pop("reached", None)  # an event may have ended it
    if reached is not None:
        times, states = times[:reached], states[:reached]
    events = statistics.pop("events", ())
    dense = statistics.pop("dense_output", None)
    if wanted is not None and not native:
        dense = None
        events = [replace(e, before=e.before[:n], after=e.after[:n]) for e in events]
    times = np.array(times, dtype=float)
    own = "What the `ode_solver` returns, states or (states, info),"
    states = np.array(real_array(states, own))
    width = n if wanted is None else wanted.sensitive.columns.size
    if states.shape != (len(times), width):
        raise ValueError(
            f"The `ode_solver` must return the shape {(len(times), n)}, one row "
            f"for each of the `times`, got {states.shape}. One that ends early tells the times of "
            "its rows: return (states, {'times': times})."
        )
    if len(times):  # what is NaN to the end comes after a terminal event
        reached = len(times) - np.isnan(states).all(axis=1)[::-1].argmin()
        times, states = times[:reached], states[:reached]
    states, found = (states, {}) if wanted is None else wanted.results(states)
    told = {"events": events, "statistics": statistics or None, "dense": dense}
    return {"times": times, "states": states, **told, **found}


@dataclass(frozen=True, eq=False)
class Leg:
    """A motion that can be continued where it ended."""

    now: Problem
    solver: SolverFunction
    options: dict[str, Any]
    end: float = np.nan
    state: np.ndarray | None = None
    sides: tuple[int, ...] | None = None  # of the events, just after the end
    refusal: str = ""

    def simulated(
        self, begun: Begun | None = None, wanted: SensitivityRequest | None = None
    ) -> Trajectory:
        """Simulate, and return a Trajectory that can be continued."""
        options = self.options if begun is None else {**self.options, "begun": begun}
        found = simulated(self.now, self.solver, options, wanted)
        statistics = found["statistics"] or {}
        sides, code = statistics.pop("sides", None), statistics.get("code", FINISHED)
        trajectory = self.now.trajectory(**found)
        if not len(trajectory.times):
            return trajectory
        end, state = float(trajectory.times[-1]), trajectory.states[-1]
        if code == TERMINATED:
            end = float(statistics["time"])
        if self.options.get("events") and trajectory.events and trajectory.events[-1].time == end:
            state = trajectory.events[-1].after
        refusal = ""
        if wanted is not None:
            refusal = (
                "`sensitivities` of a motion that is continued are not known. Simulate over the "
                "whole time at once, or without `sensitivities`."
            )
        elif code == EVENTS_ACCUMULATE:
            refusal = (
                f"The motion ended at t = {statistics['time']!r}, where events accumulate: nothing "
                f"says how it goes on. {OUTCOMES[EVENTS_ACCUMULATE].remedy}"
            )
        more = {"end": end, "state": state, "sides": sides, "refusal": refusal}
        trajectory._leg = replace(self, **more)
        return trajectory

    def go_on(self, times: np.ndarray) -> Trajectory:
        """Return the motion from the end on, at some times."""
        assert self.state is not None
        start = dict(zip(self.now.definition.states, self.state.tolist(), strict=True))
        user = {**self.now.user, "initial_conditions": start}
        leg = replace(self, now=replace(self.now, user=user, times=times))
        watched = isinstance(self.solver, Solver) and self.options.get("events")
        return leg.simulated(Begun(None, self.sides) if watched else None)


def judge_motion(
    now: Problem,
    times: np.ndarray,
    states: np.ndarray,
    info: Mapping[str, Any],
    options: dict[str, Any],
    free: bool,
) -> None:
    """Warn of resets that leave the constraints, and refuse a native solver's motion that did."""
    if free:
        check_resets(info["events"], now.at)
    n = len(now.definition.states)
    check_drift(DriftCheck(now, times, states[:, :n], options, info, not free))


def explain_failure(error: Any, now: Problem, ready: PreparedIntegration, free: bool) -> None:
    """Say why a motion failed, and warn of resets that left the constraints before."""
    if isinstance(error, IntegrationError) and error.info.get("code") in _GIVEN_UP:
        stuck = _stuck_at(now, ready, error.time, error.state)
        if stuck is not None:
            text = str(error)
            for remedy in (MORE_STEPS, *(OUTCOMES[code].remedy for code in _GIVEN_UP)):
                text = text.removesuffix(remedy)
            error.args = (f"{text.rstrip()} {stuck}",)
            return
    explain(error, lambda t, x: replace(now.at(t, x), model=ready.model))
    if ready.constrained and free and isinstance(error, IntegrationError):
        told: Any = error.info
        check_resets(told["events"], now.at)


_GIVEN_UP = (TOO_MANY_STEPS, STEP_UNDERFLOW, NO_CONVERGENCE)


def _stuck_at(now: Problem, ready: PreparedIntegration, t: float, x: np.ndarray) -> str | None:
    """Describe the jump at which a motion stays, if it does; see `stuck_at`."""
    at = replace(now.at(np.array([t]), np.array([x])), model=ready.model)
    return stuck_at(at, float(now.times[-1] - now.times[0]))


def _warn_of_many_steps(ready: PreparedIntegration, t: float, x: np.ndarray) -> None:
    now = ready.now
    stuck = None if now is None else _stuck_at(now, ready, t, x)
    if stuck is not None:
        warn_user(f"The solver has taken more than {MANY_STEPS} steps by t = {t:.4g}. {stuck}")


def _motion(
    now: Problem,
    solver: Any,
    times: np.ndarray,
    result: Any,
    options: dict[str, Any],
    mended: bool,
) -> DriftCheck | None:
    """Return the result of SciPy's or a user's solver, if it reached the end and is readable."""
    states, info = result if isinstance(result, tuple) and len(result) == 2 else (result, {})
    if isinstance(solver, SolveIvp):
        if not (defaults := solver.tolerances(options)):
            info = {"method": solver.name}  # a method of the user's, whose errors are not known
        options = {**defaults, **options}
    elif is_odeint(solver):
        if not came_to_the_end(states, info):
            return None
    else:  # the user's
        info = {"method": getattr(solver, "__name__", "ode_solver")}
        try:
            states = np.asarray(states, dtype=float)
        except (TypeError, ValueError):
            return None
        if states.ndim != 2 or len(states) != len(times):
            return None
    n = len(now.definition.states)
    times = info.get("times", times) if isinstance(info, dict) else times
    if states.shape[1] < n or not len(states):
        return None
    return DriftCheck(now, times, states[:, :n], options, info, mended)
