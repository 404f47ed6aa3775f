"""Prepare integrations: compile the code that a solver's options need, once for all numbers."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._assembly import CompiledModel, stabilised
from pydy._checks import choice, positive
from pydy._motion.events_and_constraints import (
    check_events,
    compile_constraints,
    compile_events,
    with_residuals_projected,
)
from pydy._motion.lsoda import is_odeint, odeint_options
from pydy._motion.scipy_options import named_for_odeint
from pydy._motion.scipy_solvers import SolveIvp
from pydy._option_checks import check_option_names
from pydy._problem import AssumptionChecks, Model, Problem, read_times
from pydy.codegen import SpecifiedsPlan
from pydy.solvers import (
    CompiledEvents,
    Event,
    Options,
    Prepared,
    Solver,
)

if TYPE_CHECKING:
    pass

# Options of other types, such as arrays, may be edited between two calls.
_IMMUTABLE = frozenset((float, int, bool, str, type(None)))


_STEPPING = frozenset(
    ("rtol", "atol", "first_step", "max_step", "max_steps", "step", "hmax", "h0", "hmin", "mxstep")
)


class PreparedIntegration:
    """A prepared integration, which can be repeated with other numbers."""

    def __init__(
        self,
        model: Model,
        plan: SpecifiedsPlan,
        solver: object,
        options: dict[str, object],
    ) -> None:
        self._plan, self._solver, self._user_options = plan, solver, dict(options)
        self._events = CompiledEvents.key(options.get("events"))
        self.constrained = model.definition.equations.constraints.are_present
        # whether the constraints are enforced, by projection or stabilisation
        self.enforced = options.get("constraints") is not None
        self.never_jumps = False  # whether inputs and loads certainly have no jumps in time
        self.span = 0.0  # of the times of the latest call
        self.start_judged = False  # whether the inputs were checked for impulses
        self.code, self.options = self._prepared(model)
        self.read: Options | None = None  # as the solver has read them
        self.problem: Problem | None = None  # of the latest call
        # The memory of the latest call, with its options, unless another call is using it.
        self.free: list[tuple[Prepared, dict[str, object]]] = []

    def _prepared(self, model: Model) -> tuple[CompiledModel, dict[str, Any]]:
        """Return the code, with options that change the equations compiled in, and the others."""
        definition = model.definition
        options, equations = dict(self._user_options), definition.equations
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
            stable = model.code.variant(
                ("baumgarte", gain), lambda assembly: stabilised(assembly, gain)
            )
            model = replace(model, code=stable)
        projected = constraints == "project"
        if events is not None and self._looks_itself(events):
            options["events"], events = events, None
        checked = check_events(events, definition.places["states"])
        if not isinstance(self._solver, Solver) and (projected or events is not None):
            feature = "constraints='project'" if projected else "events"
            raise ValueError(
                f"`{feature}` needs a native solver: set `system.ode_solver = 'dop853'`, or "
                "another one of pydy.solvers."
            )
        code = model.with_compiled_inputs(self._plan)
        if projected:
            options["constraints"] = compile_constraints(code, definition)
        if checked:
            options["events"] = compile_events(code, definition, checked)
        return code, options

    def _looks_itself(self, events: object) -> bool:
        """Return whether the solver detects events itself: a user's solver, or solve_ivp."""
        if isinstance(self._solver, Solver) or is_odeint(self._solver):
            return False
        if not isinstance(self._solver, SolveIvp):
            return True
        several = events if isinstance(events, (list, tuple)) else [events]
        # An expression is a mistake whatever the solver, which `check_events` explains.
        return not any(isinstance(e, Event) or hasattr(e, "free_symbols") for e in several)

    def is_compatible(
        self, plan: SpecifiedsPlan, solver: object, options: dict[str, object]
    ) -> bool:
        """Return whether a call differs only in numbers, as far as can be determined."""
        if solver is not self._solver or [*options] != [*self._user_options]:
            return False
        for name, value in options.items():  # runs at each call: `_alike` inlined
            stored = self._user_options[name]
            unchanged = (
                type(value) in _IMMUTABLE and type(value) is type(stored) and value == stored
            )
            # The `continuation` is set at the start of each run.
            if unchanged or name == "continuation":
                continue
            if name != "events" or not self._alike(name, value):
                return False
        return plan is self._plan or self._has_same_inputs(plan)

    def _alike(self, name: str, value: object) -> bool:
        stored = self._user_options[name]
        if name == "events":
            return self._events is not None and self._events == CompiledEvents.key(value)
        return type(value) in _IMMUTABLE and type(value) is type(stored) and bool(value == stored)

    def retuned(
        self, plan: SpecifiedsPlan, solver: object, options: dict[str, object]
    ) -> PreparedIntegration | None:
        """Return a copy with other tolerances or step sizes, or None if more than these differ."""
        native = isinstance(solver, Solver)
        if solver is not self._solver or not (native or [*options] == [*self._user_options]):
            return None  # for other solvers, the names were checked
        other_names = [name for name in options if name not in _STEPPING]
        if other_names != [name for name in self._user_options if name not in _STEPPING]:
            return None
        if not (
            all(self._alike(name, options[name]) for name in other_names)
            and self._has_same_inputs(plan)
        ):
            return None
        step_options = {name: v for name, v in options.items() if name in _STEPPING}
        result = object.__new__(PreparedIntegration)
        result.__dict__.update(self.__dict__)
        result._user_options = dict(options)
        retained = {
            name: v for name, v in self.options.items() if not native or name not in _STEPPING
        }
        result.options = {
            **retained,
            **(named_for_odeint(step_options) if is_odeint(solver) else step_options),
        }
        return result

    def _has_same_inputs(self, plan: SpecifiedsPlan) -> bool:
        stored = self._plan
        return plan is stored or (
            plan.expressions is stored.expressions
            and plan.inputs.sampled is stored.inputs.sampled
            and plan.inputs.functions is stored.inputs.functions
        )


def prepare(
    problem: Problem,
    times: np.ndarray,
    solver: object,
    options: dict[str, object],
    alone: bool = True,
) -> tuple[PreparedIntegration, np.ndarray]:
    """Return the prepared integration of a Problem, the latest one if compatible, and the times.

    `alone` means without sensitivities. If assumptions of symbols are checked, a solver stores its
    steps, unless the user set `dense_output`.
    """
    latest = problem.model.code.latest
    if len(times) < 2:
        raise ValueError(
            "`times` must have at least two values before integrate() can be called, got "
            f"{len(times)}. Set `system.times`."
        )
    if problem.definition.equations.constraints.residuals.implicit is not None:
        options = with_residuals_projected(problem.definition, solver, options)
    stores = isinstance(solver, Solver) or (isinstance(solver, SolveIvp) and alone)
    if AssumptionChecks(problem).judged() and stores and "dense_output" not in options:
        options = {**options, "dense_output": True}
    times, plan = read_times(problem, times), problem.plan
    if plan.inputs.sampled:
        plan.check_times(times, "times")
    ready: PreparedIntegration | None = latest.get("simulation")
    if ready is not None and not ready.is_compatible(plan, solver, options):
        ready = latest["simulation"] = ready.retuned(plan, solver, options)
    if ready is None:
        ready = PreparedIntegration(problem.model, plan, solver, options)
        if is_odeint(solver):
            check_option_names("odeint", odeint_options(), ready.options)
        latest["simulation"] = ready
    ready.span = float(times[-1] - times[0])
    return ready, times
