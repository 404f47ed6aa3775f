"""Prepare integrations: compile what the options of a solver need, once for all numbers."""

from __future__ import annotations

from copy import copy
from dataclasses import replace
from typing import Any

import numpy as np

from pydy._assembly import CompiledModel, stabilised
from pydy._checks import choice, positive
from pydy._motion.events_and_constraints import (
    check_events,
    compile_constraints,
    compile_events,
    with_residuals_held,
)
from pydy._motion.scipy_options import named_for_odeint
from pydy._motion.scipy_solvers import SolveIvp, is_odeint, odeint_options
from pydy._problem import AssumptionChecks, CallArguments, Model, Problem
from pydy.codegen import SpecifiedsPlan
from pydy.solvers import (
    CompiledEvents,
    Event,
    Options,
    Prepared,
    Solver,
    check_option_names,
)

_PLAIN = frozenset((float, int, bool, str, type(None)))  # an array may be edited between two calls


_STEPPING = frozenset(
    ("rtol", "atol", "first_step", "max_step", "max_steps", "step", "hmax", "h0", "hmin", "mxstep")
)


class PreparedIntegration:
    """A prepared integration, which can be repeated with other numbers."""

    def __init__(
        self,
        model: Model,
        plan: SpecifiedsPlan,
        solver: Any,
        given: dict[str, Any],
    ) -> None:
        self._plan, self._solver, self._given = plan, solver, dict(given)
        self._events = CompiledEvents.key(given.get("events"))
        self.constrained = model.definition.equations.constraints.are_present
        # whether the motion is brought back onto the constraints
        self.enforced = given.get("constraints") is not None
        self.never_jumps = False  # whether inputs and loads are known not to jump by time alone
        self.span = 0.0  # of the times of the latest call
        self.start_judged = False  # whether impulses of the inputs were looked for
        self.oriented: tuple[Any, ...] | None = None  # see `assumptions.orientations`
        self.code, self.options = self._prepared(model)
        self.read: Options | None = None  # as the solver has read them
        self.problem: Problem | None = None  # of the latest call
        # What the latest call has reserved, with its options, if no other call has it.
        self.free: list[tuple[Prepared, dict[str, Any]]] = []

    def _prepared(self, model: Model) -> tuple[CompiledModel, dict[str, Any]]:
        """Return the code with options that change the equations compiled in, and the others."""
        definition = model.definition
        options, equations = dict(self._given), definition.equations
        if is_odeint(self._solver):
            options = named_for_odeint(options)
        constraints, events, gain = (
            options.pop(name, None) for name in ("constraints", "events", "gain")
        )
        constraints = choice(constraints, (None, "project", "baumgarte"), "`constraints`")
        rows = equations.constraints
        if constraints == "project" and not (rows.holonomic or rows.velocity):
            raise ValueError("`constraints='project'` holds constraints, but the system has none.")
        if constraints == "baumgarte" and not rows.velocity:
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
            stable = model.code.changed(("baumgarte", gain), lambda own: stabilised(own, gain))
            model = replace(model, code=stable)
        projected = constraints == "project"
        if events is not None and self._looks_itself(events):
            options["events"], events = events, None
        if not isinstance(self._solver, Solver) and (projected or events is not None):
            what = "constraints='project'" if projected else "events"
            raise ValueError(
                f"`{what}` needs a native solver: set `system.ode_solver = 'dop853'`, or another "
                "one of pydy.solvers."
            )
        code = model.with_compiled_inputs(self._plan)
        if projected:
            options["constraints"] = compile_constraints(code, definition)
        if checked := check_events(events, definition.places["states"]):
            options["events"] = compile_events(code, definition, checked)
        return code, options

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
            # What a run begins with, `continuation`, is set in it.
            if plain or name == "continuation":
                continue
            if name != "events" or not self._alike(name, value):
                return False
        return plan is self._plan or self._as_planned(plan)

    def _alike(self, name: str, value: Any) -> bool:
        known = self._given[name]
        if name == "events":
            return self._events is not None and self._events == CompiledEvents.key(value)
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
            and plan.inputs.sampled is known.inputs.sampled
            and plan.inputs.functions is known.inputs.functions
        )


def prepare(
    problem: Problem,
    times: np.ndarray,
    solver: Any,
    given: dict[str, Any],
    alone: bool = True,
) -> tuple[PreparedIntegration, np.ndarray]:
    """Return the prepared integration of a Problem, the latest one if it fits, and the times.

    It is `alone` without sensitivities. Where assumptions of symbols are judged, a solver stores
    its steps, unless the user chose.
    """
    latest = problem.model.code.latest
    if len(times) < 2:
        raise ValueError(
            "`times` must have at least two values before integrate() can be called, got "
            f"{len(times)}. Set `system.times`."
        )
    if problem.definition.equations.constraints.residuals.implicit is not None:
        given = with_residuals_held(problem.definition, solver, given)
    stores = isinstance(solver, Solver) or (isinstance(solver, SolveIvp) and alone)
    if AssumptionChecks(problem).judged() and stores and "dense_output" not in given:
        given = {**given, "dense_output": True}
    times, plan = CallArguments(problem).times(times), problem.plan
    if plan.inputs.sampled:
        plan.check_times(times, "times")
    ready: PreparedIntegration | None = latest.get("simulation")
    if ready is not None and not ready.is_compatible(plan, solver, given):
        ready = latest["simulation"] = ready.retuned(plan, solver, given)
    if ready is None:
        ready = PreparedIntegration(problem.model, plan, solver, given)
        if is_odeint(solver):
            check_option_names("odeint", odeint_options(), ready.options)
        latest["simulation"] = ready
    ready.span = float(times[-1] - times[0])
    return ready, times
