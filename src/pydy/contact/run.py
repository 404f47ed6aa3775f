"""One simulation with contacts: an integration from transition to transition."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from copy import deepcopy
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._errors import ContactError, IntegrationError, IntegrationInterrupted, note_finished
from pydy._forks import cached_property
from pydy._integration import simulate
from pydy._motion import Integrator, Motion, Segment
from pydy._names import numbers_of, some
from pydy._problem import Problem, Settings, evaluate_specifieds, with_settings
from pydy._rank import ROUNDED, ROUNDING
from pydy.contact.complementarity import (
    BACKWARD,
    CLOSED,
    FORWARD,
    OPEN,
    SLIDES,
    SLIDING,
    STARTING,
    STICKS,
    ComplementarityProblem,
    ModeSolution,
    all_open,
    has_sudden_onset,
    independent,
    innermost_solution,
    linked,
    rows_of_modes,
    select_modes,
    solved,
)
from pydy.contact.conditions import check_values
from pydy.contact.impacts import apply_impacts
from pydy.contact.missed_transitions import diagnose_flat_gap, missed_transitions
from pydy.contact.modes import CompiledModes, Mode
from pydy.contact.rows import RowValues, StartError
from pydy.contact.sensitivities import HybridSensitivities
from pydy.contact.trajectory import contact_trajectory
from pydy.contact.tuning import BEGUN, ERRORS, RESOLUTION, RESOLVED, ROUNDING_MARGIN, SLACK
from pydy.solvers import SOLVERS, Event, EventContinuation, Options, Outcome, Solver, read_options
from pydy.trajectory import EventRecord

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol

_MODE_PRESERVING = frozenset({"bends", "clears", "turns"})  # events that change no mode


@dataclass
class State:
    """The current state of the motion, and of its contacts."""

    t: float
    x: np.ndarray
    closed: set[int]
    separating: set[int]  # open contacts whose gap is zero to rounding and increases
    at_rest: set[int]  # closed contacts whose sliding speed is zero
    directions: dict[int, np.ndarray] = field(default_factory=dict)  # unit vectors, in a plane


class ContactRun:
    """One simulation of a system with contacts, from transition to transition."""

    def __init__(
        self,
        compiled: CompiledModes,
        solver: Solver,
        problem: Problem,
        times: np.ndarray,
        events: Sequence[Event],
        options: dict[str, Any],
        transitions: Any = None,  # Transitions
    ) -> None:
        self.transitions = transitions
        self.start_modes: tuple[str, ...] | None = None  # prescribed modes at the first time
        self.state: State | None = None  # the current state; after the run, the final one
        self.resumed = False  # whether it continues another run from its end
        self.counted: set[str] = set()  # user events that the other run recorded at its end
        self.compiled, self.solver, self.problem, self.times = compiled, solver, problem, times
        self.user_events, self.options = events, options
        self.stopped: Callable[[], bool] | None = None  # called between transitions
        self.rows, self.contacts = compiled.rows, compiled.contacts
        self.span = float(times[-1] - times[0])
        self.n = len(problem.definition.states)
        self.first = len(problem.definition.equations.coordinates)
        self.states = np.full((len(times), self.n), np.nan)
        self.segments: list[Segment] = []
        self.records: list[EventRecord] = []
        self.impacts: list[tuple[float, dict[str, tuple[float, ...]], float]] = []
        self.first_height: dict[int, float] = {}
        self.modes: tuple[str, ...] = tuple(OPEN for _ in self.contacts)
        self.sizes = np.zeros(len(self.contacts))  # of forces where a segment begins
        self.located: set[int] = set()  # contacts whose own event ended the last segment
        self.bias: np.ndarray | None = None
        self.redundant = False
        self.peak_speed: dict[int, float] = {}  # largest sliding speed since the slide began
        self.reached = len(times)  # number of times up to the end of the motion
        self.totals = {"steps": 0, "rejected": 0, "evaluations": 0}
        self._latest: tuple[tuple[float, bytes], RowValues] | None = None  # at the last state
        self.impacted: set[int] = set()  # contacts that have closed
        # Transitions found at the event of another contact; recorded if the new modes agree.
        self.pending_events: dict[int, str] = {}
        self.gap_rounding = np.zeros(len(self.contacts))  # largest rounding bounds so far

    # -- numbers ----------------------------------------------------------------------------------

    @cached_property
    def _tolerances(self) -> Options:
        tolerances = {k: v for k, v in self.options.items() if k in ("rtol", "atol")}
        return read_options("dop853", True, tolerances)

    # A wrong shape is refused by the integration.
    atol = property(lambda self: np.asarray(self._tolerances.atol))
    rtol: Any = property(lambda self: float(np.min(self._tolerances.rtol, initial=1.0)))

    def numbers(self, t: float, x: np.ndarray) -> RowValues:
        """Return the rows of the contacts at a state."""
        key = t, x.tobytes()
        if self._latest is None or self._latest[0] != key:
            r = np.zeros(0)
            if self.problem.definition.specifieds:
                r = evaluate_specifieds(self.problem, np.array([t]), x[None])[0]
            self._latest = key, self.rows.numbers(t, x, r, self.problem.p)
        return self._latest[1]

    def values(self, t: float, x: np.ndarray) -> dict[AnySymbol, float]:
        """Return the values of states, constants, specifieds and time, by symbol."""
        definition = self.problem.definition
        values = {**self.problem.constants, definition.equations.time: t}
        values.update(zip(definition.states, x.tolist(), strict=True))
        if definition.specifieds:
            r = evaluate_specifieds(self.problem, np.array([t]), x[None])[0]
            values.update(zip(definition.specifieds, r.tolist(), strict=True))
        return values

    def complementarity(self, p: RowValues, state: State) -> ComplementarityProblem:
        """Return the complementarity problem of the accelerations at a state."""
        self.note_directions(p, state)
        return ComplementarityProblem(
            p.free, p.delassus, self.rows.normal, self.rows.tangent, p.mu, p.mu_static, p.normal,
            frozenset(state.at_rest), frozenset(state.closed), dict(state.directions), self.bias,
            p.terms,
        )  # fmt: skip

    def note_directions(self, p: RowValues, state: State) -> None:
        """Record directions of sliding in a plane; they are unchanged where a slide begins."""
        for i, rows in enumerate(self.rows.tangent):
            if len(rows) == 2 and i in state.closed and i not in state.at_rest:
                speed = p.speed[rows]
                if not p.is_still(rows, speed):
                    state.directions[i] = speed / np.linalg.norm(speed)
                elif i not in state.directions:  # after an impact the speed is only rounding
                    state.at_rest.add(i)

    def resolution(self, t: float) -> float:
        """Return the time difference below which two events count as simultaneous."""
        return RESOLUTION * max(abs(t), self.span)

    def fail(self, t: float, x: np.ndarray, why: str) -> ContactError:
        """Return an error with the state, the modes and the results so far."""
        state = numbers_of(self.problem.definition.states, x)
        results = self.so_far(t, x)
        modes = results[-1]["modes"]
        context = f"At t = {t!r} in the state {state}; the modes before were {modes}."
        return ContactError(f"{why} {context}", *results)

    def so_far(self, t: float, x: np.ndarray) -> tuple[Any, ...]:
        """Return the arguments of an error: the results up to a time and a state."""
        done = int((self.times < t).sum())
        modes = dict(zip([c.name for c in self.contacts], self.modes, strict=True))
        info = {"modes": modes, "events": list(self.records)}
        return self.times[:done].copy(), self.states[:done].copy(), t, x.copy(), info

    # -- the start --------------------------------------------------------------------------------

    def begin(self) -> State:
        """Return the state at the first time, after the impacts that happen there."""
        t, x = float(self.times[0]), self.problem.x.copy()
        p = self.numbers(t, x)
        self.gap_rounding = p.gap_rounding
        if self.start_modes is None and self.rows.are_open(p, self.problem.p):
            return State(t, x, set(), set(), set())
        check_values(self.contacts, p)
        for expression in self.rows.switched:
            expression.check(self.values(t, x))
        self.rows.checked = self.problem.p.tobytes()
        closed = {i for i, n in enumerate(self.rows.normal) if n is not None and p.is_closed(i)}
        self.rows.check_directions(closed, self.values(t, x))
        state = State(t, x, set(), set(), set())
        closing, moving = set[int](), p.moving()
        for i, c in enumerate(self.contacts):
            normal = self.rows.normal[i]
            if normal is None or (self.start_modes is not None and self.start_modes[i] != OPEN):
                state.closed.add(i)
                continue
            nothing = ROUNDING_MARGIN * np.finfo(float).eps * p.gap_rounding[i]
            # A gap with zero slope may be at its maximum if it is open.
            if not (p.gap[i] > nothing or p.delassus[normal, normal] > 0.0):
                raise self.fail(t, x, diagnose_flat_gap(self, t, x, [i]))
            if -p.gap[i] > max(nothing, self.unresolved_gap(i, p, x)):
                why = (
                    f"The gap of {c.name!r} must not be negative at the first time, got "
                    f"{p.gap[i]:.6g}. Change the initial conditions, or the sign of the gap."
                )
                raise StartError(why) if self.start_modes is None else self.fail(t, x, why)
            if p.gap[i] <= nothing:
                speed = moving[normal]
                (state.separating if speed > 0 else closing if speed < 0 else state.closed).add(i)
        for i, rows in enumerate(self.rows.tangent):
            if rows and i in state.closed:
                # Prescribed modes: remaining gaps and speeds are projected to zero later.
                begun = self.start_modes
                if p.is_still(rows, p.speed[rows]) if begun is None else begun[i] == STICKS:
                    state.at_rest.add(i)
        self.modes = tuple(
            OPEN if i not in state.closed else self.options_of(state, p, i)[0]
            for i in range(len(self.contacts))
        )
        if closing:
            apply_impacts(self, state, closing)
        return state

    # -- what happens -----------------------------------------------------------------------------

    def options_of(self, state: State, p: RowValues, i: int) -> list[str]:
        """Return the possible modes of a contact, the most likely ones first."""
        if i not in state.closed:
            return [OPEN]
        rows, modes = self.rows.tangent[i], [CLOSED]
        if len(rows) == 2:
            modes = [STICKS, STARTING] if i in state.at_rest else [SLIDING]
        elif rows:
            sliding = [FORWARD if p.speed[rows[0]] > 0.0 else BACKWARD]
            modes = [STICKS, FORWARD, BACKWARD] if i in state.at_rest else sliding
        return modes if self.rows.normal[i] is None else [*modes, OPEN]

    def select_modes(
        self, state: State, fixed: dict[int, str], excluded: Collection[tuple[str, ...]] = ()
    ) -> ModeSolution:
        """Select the modes that follow, by complementarity of the accelerations."""
        self.bias = None
        if not state.closed:
            return all_open(len(self.contacts), len(self.rows.speeds))
        p = self.numbers(state.t, state.x)
        rest_rows = [row for i in sorted(state.at_rest) for row in self.rows.tangent[i]]
        if len(enforced := independent(p.delassus, rest_rows)) < len(rest_rows):
            # Redundant rows at rest: residual speeds would make their accelerations inconsistent.
            self.settle(state, tuple(enforced))
            p = self.numbers(state.t, state.x)
        problem = self.complementarity(p, state)
        for i in state.closed - state.at_rest:
            normal, rows = self.rows.normal[i], self.rows.tangent[i]
            if normal is not None and rows and fixed.get(i) != OPEN:
                unit = state.directions[i] if len(rows) == 2 else np.sign(p.speed[rows])
                push = p.mu[i] * p.delassus[normal, rows] @ unit
                if p.delassus[normal, normal] - push <= SLACK * p.delassus[normal, normal]:
                    raise self.fail(
                        state.t, state.x,
                        f"Painlevé's paradox: a normal force at {self.contacts[i].name!r}, which "
                        "slides, would not push the bodies apart, because its friction pulls them "
                        "together by more.",
                    )  # fmt: skip
        possible = [self.options_of(state, p, i) for i in range(len(self.contacts))]
        candidates = [[fixed[i]] if i in fixed else modes for i, modes in enumerate(possible)]
        solution = select_modes(problem, candidates, excluded)
        if solution is None and fixed.keys() - self.located:
            # Transitions inferred from nearly zero values may be wrong; located events are not.
            tied = self.located & fixed.keys()
            candidates = [[fixed[i]] if i in tied else modes for i, modes in enumerate(possible)]
            solution = select_modes(problem, candidates)
        solution = solution or (select_modes(problem, possible) if fixed or excluded else None)
        if solution is None:
            raise self.fail(
                state.t, state.x,
                "Jamming: no combination of contacts that open, stick and slide satisfies the "
                "equations of motion.",
            )  # fmt: skip
        for i, mode in enumerate(solution.modes):
            if mode == OPEN and i in state.closed:
                state.closed.discard(i)
                state.at_rest.discard(i)
                state.separating.add(i)
        return solution

    def note_rest(
        self, state: State, i: int, p: RowValues, rebound: tuple[float, float, float], slopes: Any
    ) -> None:
        """Record the limit time of accumulating impacts of a contact (Zeno behaviour).

        `rebound` has the speed of the first rebound, its acceleration, and the ratio of successive
        speeds. `slopes` are the derivatives of the rows before the impact.
        """
        v, a, ratio = rebound
        later = 1.0 / (a * (1.0 - ratio)) if ratio < 1.0 else 0.0
        limit, name = float(state.t + 2.0 * v * later), f"{self.contacts[i].name} rests"
        record = EventRecord(limit, name, i, state.x.copy(), state.x.copy())
        if isinstance(self.transitions, HybridSensitivities):
            known = self.compiled.hypothesis == "newton"  # otherwise contacts change the ratio
            by_wrt = self.transitions.limit_of_rebounds(i, p, rebound, later, slopes, known)
            record = replace(record, time_sensitivity=by_wrt)
        if limit <= self.times[-1]:
            self.records.append(record)

    def check_instant(
        self, state: State, p: RowValues, slopes: np.ndarray, closing: Collection[int]
    ) -> None:
        """Refuse derivatives if contacts close together for these parameter values alone."""
        share = SLACK + ERRORS * self.rtol
        for i in sorted(closing):
            parameters = self.transitions.separating_parameters(i, slopes[i], p, share)
            if parameters:
                raise self.fail(
                    state.t, state.x,
                    f"{self.contacts[i].name!r} closes at the instant of another transition, but "
                    f"with another {some(parameters)} it would close before or after that: there "
                    "is no derivative. Leave that out of the parameters, or begin a little "
                    "elsewhere.",
                )  # fmt: skip

    def unresolved(self, i: int) -> float:
        """Return the largest sliding speed that solver tolerances do not distinguish from zero."""
        atol = float(np.min(self.atol))
        return float(ERRORS * (atol + self.rtol * self.peak_speed.get(i, 0.0)))

    def is_low(self, i: int, speed: float, rate: float, p: RowValues, x: np.ndarray) -> bool:
        """Whether the rebounds at a speed and acceleration are lower than the solver's tolerance.

        The height is compared with that of the first rebound of the sequence, and with twice the
        unresolved gap, so that no later impact grazes.
        """
        if not rate < 0.0:
            return False
        height = speed**2 / (2.0 * -rate)
        first = self.first_height.setdefault(i, height)
        return bool(height <= max(self.rtol * first, 2.0 * self.unresolved_gap(i, p, x)))

    def unresolved_gap(self, i: int, p: RowValues, x: np.ndarray) -> float:
        """Return the largest gap that solver tolerances do not distinguish from zero."""
        atol = np.broadcast_to(self.atol, self.n)[: self.first]
        return float(np.abs(p.gradient[i]) @ (atol + self.rtol * np.abs(x[: self.first])))

    # -- from transition to transition ------------------------------------------------------------

    def motion(self) -> Motion:
        """Integrate over all times."""
        state = self.state if self.resumed and self.state is not None else self.begin()
        self.state = state
        try:
            self._integrate_modes(state)
        except (ContactError, IntegrationInterrupted) as error:
            error.motion = self.motion_so_far()
            raise
        except KeyboardInterrupt:
            raise IntegrationInterrupted(
                f"Contacts.simulate was interrupted at t = {state.t:.6g}. The results so far are "
                "in the attributes of this error.",
                *self.so_far(state.t, state.x),
            ) from None
        except MemoryError as error:
            done = int(np.isfinite(self.states).all(axis=1).sum())
            parts = {"times": self.times[:done].copy(), "states": self.states[:done].copy()}
            if hasattr(error, "times"):  # of the last segment
                vars(error).update(parts)
            else:
                note_finished(error, "What was computed until then is", **parts)
            raise
        return self.result()

    def _integrate_modes(self, state: State) -> None:
        """Integrate mode after mode, until the end."""
        fixed, fired = dict[int, str](), list[tuple[str, int]]()
        instants, transitions = 0, 0
        excluded: set[tuple[str, ...]] = set()  # combinations already tried at this instant
        while True:
            if self.stopped is not None and self.stopped():
                raise KeyboardInterrupt
            before, closed, at_rest = state.t, set(state.closed), set(state.at_rest)
            solution = self.select_modes(state, fixed, excluded)
            unchanged = fired and solution.modes == self.modes
            if unchanged and {kind for kind, _ in fired} & {"opens", "slips"}:
                # A load that jumps in time still has its value before the jump at this instant.
                state.t = float(np.nextafter(state.t, np.inf))
                solution = self.select_modes(state, fixed, excluded)
            if self.redundant and excluded:
                self.note_changes(state, solution)
            for i, kind in self.pending_events.items():
                if solution.modes[i] == fixed.get(i):
                    self.note(state, i, kind, state.x)
            self.pending_events = {}
            self.modes = solution.modes
            finished, fired = self.run(state, solution)
            if finished:
                return
            same_instant = state.t - before <= self.resolution(state.t)
            excluded = excluded if same_instant else set()
            impacts = len(self.impacts)
            shared = self.redundant and {kind for kind, _ in fired} <= {"slips", "opens"}
            fixed = {} if shared else self.after(state, fired)
            # A mode that ended at once is excluded at this instant, unless velocities changed.
            unchanged = same_instant and len(self.impacts) == impacts
            repeated = not self.has_interior_forces(state) if shared else unchanged
            excluded = {*excluded, self.modes} if repeated else set()
            if repeated and unchanged:  # then nothing has opened, either
                state.closed |= closed
                state.at_rest |= at_rest
                state.separating -= closed
            transitions += 1
            instants = instants + 1 if same_instant else 0
            # Several contacts may take several transitions each at one instant.
            if instants > 64 or transitions > 100_000:
                raise self.fail(
                    state.t, state.x,
                    "Chattering: the contacts change their modes again and again without an end.",
                )  # fmt: skip

    def run(self, state: State, solution: ModeSolution) -> tuple[bool, list[tuple[str, int]]]:
        """Integrate in one mode; return whether the end was reached, and the events otherwise."""
        state.directions.update(solution.directions)
        self.bias = solution.bias
        p = self.numbers(state.t, state.x)
        # An impact elsewhere may have reversed a separating contact.
        speed = {i: p.speed[self.rows.normal[i]] for i in state.separating}
        state.separating = {i for i in state.separating if speed[i] > 0.0 or p.is_closed(i)}
        enforced, active = self.update_active_rows(p, state, solution)
        if enforced:
            self.settle(state, enforced)
            if self.transitions is not None:
                projected = self.numbers(state.t, state.x)
                self.transitions.project(self.values(state.t, state.x), projected, enforced)
        mode, model = self.compiled.mode(solution.modes, enforced, active)
        events, kinds = mode.events
        events = [*events, *self.user_events]
        kinds = [("turns", i) if kind == "closes" and i in state.separating else (kind, i)
                 for kind, i in kinds]  # fmt: skip
        now, later = self.times.searchsorted(state.t), self.times.searchsorted(state.t, "right")
        self.states[now:later] = state.x
        if self.transitions is None and later == len(self.times):
            return True, []
        problem = Problem(
            model.definition,
            model,
            # Assumptions are checked along the complete motion.
            Settings(
                {**self.problem.constants, **self.references(p, state, solution)},
                self.problem.settings.specifieds,
                dict(zip(self.problem.definition.states, state.x.tolist(), strict=True)),
                self.times[later - 1 :] if later > now else np.append(state.t, self.times[later:]),
                already_warned=self.problem.settings.already_warned,
            ),
        )
        options = {**self.options, "events": events}
        # At the first time of the motion only user events may occur.
        later_part = self.segments or self.resumed
        options["continuation"] = EventContinuation(
            None if later_part else frozenset(range(len(kinds)))
        )
        # Without projection each segment would begin with the drift so far.
        if enforced or problem.definition.equations.constraints.velocity:
            options["constraints"] = "project"
        solver = self.shorten(p, state, solution, options)
        if self.transitions is not None:
            slides = any(solution.modes[i] in SLIDES for i in state.at_rest)
            rates = problem.at(np.array([state.t]), state.x[None]).rates()[0]
            start = self.transitions.begin_mode(rates, slides)
            if later == len(self.times):
                self.transitions.store_instant(state.t, start, self.records)
                return True, []
        try:
            if self.transitions is not None:
                motion = self.transitions.simulate(mode, start, problem, solver, options)
            else:
                motion = simulate(problem, problem.settings.times, solver=solver, **options)
        except (IntegrationError, IntegrationInterrupted, MemoryError) as error:
            states = getattr(error, "states", np.empty((0, self.n)))[1:, : self.n]
            self.states[later : later + len(states)] = states
            if isinstance(error, MemoryError):
                raise
            last = error.state[: self.n]
            if isinstance(error, IntegrationInterrupted):
                raise IntegrationInterrupted(str(error), *self.so_far(error.time, last)) from None
            closed, why = self.rows.owners_of(enforced).values(), ""
            if np.isfinite(last).all():
                why = diagnose_flat_gap(self, error.time, last, closed)
            why = why or f"The integration stopped in the modes {', '.join(self.modes)}: {error}"
            raise self.fail(error.time, last, why) from error
        return self.take(state, mode, motion, kinds)

    def update_active_rows(
        self, p: RowValues, state: State, solution: ModeSolution
    ) -> tuple[tuple[int, ...], list[int]]:
        """Return the independent active rows, and all active rows; store force sizes and speeds."""
        active, enforced, self.sizes = list[int](), tuple[int, ...](), solution.sizes
        if state.closed:
            problem = self.complementarity(p, state)
            active = rows_of_modes(problem, solution.modes)
            enforced = tuple(independent(p.delassus, active))
            self.sizes = solved(problem, solution.modes).sizes
        self.redundant = len(enforced) < len(active)
        for i, mode in enumerate(solution.modes):
            if mode in SLIDES:
                speed = float(np.linalg.norm(p.speed[self.rows.tangent[i]]))
                self.peak_speed[i] = max(self.peak_speed.get(i, 0.0), speed)
            else:
                self.peak_speed.pop(i, None)
        return enforced, active

    def shorten(
        self, p: RowValues, state: State, solution: ModeSolution, options: dict[str, Any]
    ) -> Solver:
        """Return the solver for the segment, and set a short first step at a sliding onset.

        In a plane friction turns the velocity at a rate that grows as the speed falls, so steps
        must be proportional to the speed. From rest, a long first step has an error that the error
        estimate does not show. Implicit methods take longer steps, which miss such turns. Explicit
        ones are needed at an onset without acceleration, as with μ = μ_static; but where several
        contacts turn each other, that onset is stiff.
        """
        if STARTING not in solution.modes:
            return self.solver
        at_once = has_sudden_onset(solution, p.free, self.rows.tangent)
        several = solution.modes.count(STARTING) > 1
        if (at_once or several) and "step" not in options:
            # From this step a dozen growing steps lead to any other size.
            options["first_step"] = 16.0 * self.resolution(state.t)
            if at_once or self.transitions is not None:
                options["atol"] = RESOLVED**2 * self.atol
                return SOLVERS["dop853"]
            return SOLVERS["radau"]
        if self.transitions is not None:
            raise NotImplementedError(
                "`sensitivities` where a body begins to slide in a plane without an acceleration, "
                "as under a pull that grows until `mu` = `mu_static` is reached, or in steps of a "
                "fixed size, are not known. Pass a larger `mu_static` and an adaptive solver, or "
                "simulate without `sensitivities`."
            )
        return self.solver

    def references(
        self, p: RowValues, state: State, solution: ModeSolution
    ) -> dict[AnySymbol, float]:
        """Return the values of the hidden constants: biases, speed bounds, reference directions.

        Below the least speed the direction of sliding is that of the acceleration. It is the
        rounding of the speed, or, at a sliding onset, a fraction of what the solver resolves. The
        onset ends at a fraction of the speed that the contact would gain without friction.
        """
        bias = [0.0] * len(self.rows.speeds) if self.bias is None else self.bias.tolist()
        values: dict[AnySymbol, float] = dict(zip(self.rows.biases, bias, strict=True))
        values.update(dict.fromkeys(self.rows.speed_bounds, 0.0))
        if not (state.closed or state.separating or self.rows.references):
            return values
        eps, tiny = float(np.finfo(float).eps), float(np.finfo(float).tiny)
        for i in state.separating:  # bounds on rounding of their speeds
            rounding = eps * float(p.speed_rounding[self.rows.normal[i]])
            values[self.rows.speed_bounds[i]] = max(rounding, tiny)
        for i in state.at_rest:
            # Friction has just reached its limit: the acceleration grows from zero, with an error
            # of √ε of its terms. Until it exceeds that error, speeds are ε of their terms.
            if solution.modes[i] in (FORWARD, BACKWARD) and solution.margins[i] <= SLACK:
                (row,) = self.rows.tangent[i]
                terms = max(float(p.speed_rounding[row]), float(p.terms[row]) * self.span)
                values[self.rows.speed_bounds[i]] = ROUNDING_MARGIN * eps * terms
        for i, symbols in self.rows.references.items():
            if solution.modes[i] not in (STARTING, SLIDING):
                continue
            rows = self.rows.tangent[i]
            gained = float(np.linalg.norm(p.free[rows])) * self.span
            # The speed gained in the shortest possible step, 16 roundings of the time.
            least = 16.0 * eps * max(float(np.linalg.norm(p.speed_rounding[rows])), gained)
            clear, rest = self.unresolved(i), 0.0
            if self.transitions is not None:
                bounds = clear / ERRORS, ROUNDING_MARGIN * least
                clear, rest = 0.0, self.transitions.rest_speed(i, p.speed[rows], *bounds)
            if solution.modes[i] == STARTING:
                least, clear = max(least, RESOLVED * float(np.min(self.atol))), BEGUN * gained
            unit = map(float, solution.directions.get(i, np.array([1.0, 0.0])))
            values.update(zip(symbols, [*unit, least or 1.0, clear, rest], strict=True))
        return values

    def settle(self, state: State, active: tuple[int, ...]) -> None:
        """Project rounding errors out of closed gaps and sticking speeds by Newton's method."""
        owners = self.rows.owners_of(active)
        normals, magnitudes = list(owners), np.abs(state.x)
        for _ in range(3):  # the second iteration changes the last digits at most
            p = self.numbers(state.t, state.x)
            residuals = p.gap[list(owners.values())]
            if not residuals.any() and not p.speed[list(active)].any():
                return
            x = state.x.copy()
            if normals:
                shares = np.linalg.solve(p.delassus[np.ix_(normals, normals)], -residuals)
                x[: self.first] += p.kinematics @ (p.response[:, normals] @ shares)
                p = self.numbers(state.t, x)
            rows = list(active)
            shares = np.linalg.solve(p.delassus[np.ix_(rows, rows)], -p.speed[rows])
            x[self.first : self.first + len(p.response)] += p.response[:, rows] @ shares
            # The remainder of a state that vanishes is rounding of its former value.
            state.x = np.where(np.abs(x) <= ROUNDING * magnitudes, 0.0, x)

    def take(
        self, state: State, mode: Mode, motion: Motion, kinds: list[tuple[str, int]]
    ) -> tuple[bool, list[tuple[str, int]]]:
        """Store the states up to the event that ended the mode."""
        for name in self.totals:
            self.totals[name] += motion.statistics[name]
        count = len(kinds)
        stopped = motion.statistics["code"] == Outcome.TERMINATED
        end = motion.events[-1].time if stopped else float(self.times[-1])
        at_end = [r for r in motion.events if stopped and r.time == end]
        acting = [r for r in at_end if r.index < count and kinds[r.index][0] != "nears"]
        reported = {kinds[r.index] for r in acting}
        last = at_end[-1].before if stopped else None
        broken, outputs = missed_transitions(self, motion, mode, state.at_rest, end, last, reported)
        if broken:
            return False, broken
        if self.transitions is not None:
            self.transitions.store_segment(motion, end, self.records)
        for record in motion.events:
            repeated = record.name in self.counted and record.time - self.times[
                0
            ] <= self.resolution(state.t)
            first = not (self.segments or self.resumed)
            if record.index >= count and not repeated and (record.time > state.t or first):
                user_index = record.index + len(self.contacts) - count
                self.records.append(replace(record, index=user_index))
        begin, following = (self.times.searchsorted(t, "right") for t in (state.t, end))
        self.states[begin:following] = motion.states[1 : 1 + following - begin]
        (s,) = motion.segments
        of_mode = mode.modes, s.problem, mode.columns
        self.segments.append(Segment(state.t, end, *of_mode, s.dense, s.augmented, outputs))
        if not stopped:
            state.t, state.x = end, motion.states[-1, : self.n].copy()
            return True, []
        if self.transitions is not None and acting:
            ending = (r for r in acting if kinds[r.index][0] not in _MODE_PRESERVING)
            event = next(ending, acting[-1])
            before = np.ascontiguousarray(event.before[: self.n])
            rates = motion.problem.at(np.array([end]), before[None]).rates()[0]
            self.transitions.locate_end(event, rates)
            kind, i = kinds[event.index]
            if kind in ("stops", "bends") and len(self.rows.tangent[i]) == 2:
                values = self.values(end, event.before[: self.n])
                self.transitions.doubt(values, i)
        after = at_end[-1].after[: self.n].copy()
        p, lasted = self.numbers(end, after), end - state.t
        for i in [i for i in state.at_rest if mode.modes[i] in SLIDES]:
            tangent = self.rows.tangent[i]  # speeds due to rounding of forces count as rest
            rate = SLACK * self.sizes[i] * np.linalg.norm(p.delassus.diagonal()[tangent])
            if np.linalg.norm(p.speed[tangent]) > rate * lasted:
                state.at_rest.discard(i)
        state.t, state.x = end, after
        if any(r.index >= count and self.user_events[r.index - count].terminal for r in at_end):
            self.reached = int(following)
            return True, []
        return False, [kinds[r.index] for r in acting]

    def has_interior_forces(self, state: State) -> bool:
        """Whether the same modes have other forces that are inside the friction cones."""
        problem = self.complementarity(self.numbers(state.t, state.x), state)
        better = innermost_solution(problem, solved(problem, self.modes))
        return bool(better.margins.min() > ROUNDED)

    def note_changes(self, state: State, solution: ModeSolution) -> None:
        """Record which contacts open and slip, where redundant forces were undetermined before."""
        for i, (old, new) in enumerate(zip(self.modes, solution.modes, strict=True)):
            kind = "opens" if new == OPEN != old else "slips" if old == STICKS != new else ""
            if kind:
                self.note(state, i, kind, state.x)

    def note(self, state: State, i: int, kind: str, before: np.ndarray) -> None:
        """Record a transition of a contact."""
        name = f"{self.contacts[i].name} {kind}"
        self.records.append(EventRecord(state.t, name, i, before.copy(), state.x.copy()))

    def after(self, state: State, fired: list[tuple[str, int]]) -> dict[int, str]:
        """Update the contacts after events; return the modes that these determine.

        Simultaneous transitions of other contacts are inferred from values that are nearly zero.
        """
        p, eps = self.numbers(state.t, state.x), np.finfo(float).eps
        problem = self.complementarity(p, state)
        solution = solved(problem, self.modes)
        resolved = self.resolution(state.t)
        # The rounding of a closing gap is that of the largest height since the start.
        self.gap_rounding = np.maximum(self.gap_rounding, p.gap_rounding)
        closing: set[int] = set()
        fixed: dict[int, str] = {}
        self.pending_events = {}
        # Only contacts coupled to these are checked; the others have events of their own.
        near_by = linked(problem, {i for _, i in fired})
        turning = any(kind in ("stops", "bends") for kind, _ in fired)
        sure = {"opens"} if turning else {"opens", "slips"}
        self.located = {i for kind, i in fired if kind in sure}
        for i, mode in enumerate(self.modes):
            normal, rows = self.rows.normal[i], self.rows.tangent[i]
            kinds = {kind for kind, k in fired if k == i}
            if turning:  # friction reverses at the stop, so slip events of others are spurious
                kinds.discard("slips")
            if mode == OPEN:
                assert normal is not None
                near, speed = ROUNDING_MARGIN * eps * self.gap_rounding[i], p.speed[normal]
                if i in state.separating:
                    if kinds:
                        state.separating.discard(i)
                    if kinds and p.is_closed(i):
                        state.closed.add(i)
                        if rows and np.linalg.norm(p.speed[rows]) <= self.unresolved(i):
                            state.at_rest.add(i)  # the direction is not resolved, either
                elif kinds or (speed < 0.0 and p.gap[i] <= near - speed * resolved):
                    closing.add(i)
                continue
            press = p.normal[i] if normal is None else solution.forces[normal]
            if "jams" in kinds:
                raise self.fail(
                    state.t, state.x,
                    f"Painlevé's paradox: the normal force at {self.contacts[i].name!r}, which "
                    "slides, has no bound, because its friction presses the bodies together.",
                )  # fmt: skip
            little = (SLACK if i in near_by else ROUNDED) * solution.sizes[i]
            if normal is not None and ("opens" in kinds or press < little):
                fixed[i] = OPEN
                self.pending_events[i] = "opens"
            elif mode == STICKS:
                force = solution.forces[rows]
                if "slips" in kinds or p.mu_static[i] * press - np.linalg.norm(force) < little:
                    slides = FORWARD if force[0] < 0.0 else BACKWARD
                    fixed[i] = STARTING if len(rows) == 2 else slides
                    self.pending_events[i] = "slips"
            elif rows:
                speed = np.linalg.norm(p.speed[rows])
                if turning and i in near_by and speed <= self.unresolved(i):
                    kinds.add("stops")  # a body on several feet stops on all of them at once
                if mode == STARTING and speed > self.unresolved(i):
                    kinds.discard("stops")  # the velocity has turned by a right angle
                slow = np.linalg.norm(solution.rates[rows]) * resolved
                if "stops" in kinds or p.is_still(rows, p.speed[rows]) or speed <= slow:
                    state.at_rest.add(i)
            for kind in kinds & {"opens", "slips", "stops"}:
                self.note(state, i, kind, state.x)
                self.pending_events.pop(i, None)
        if closing:
            apply_impacts(self, state, closing)
            return {}
        return fixed

    # -- the result -------------------------------------------------------------------------------

    def _go_on(self, times: np.ndarray) -> Any:
        """Return the trajectory that continues the motion from its end, at some times."""
        assert self.state is not None
        start = dict(zip(self.problem.definition.states, self.state.x.tolist(), strict=True))
        problem = with_settings(self.problem, times=times, initial_conditions=start)
        options = dict(self.options)
        run = ContactRun(self.compiled, self.solver, problem, times, self.user_events, options)
        run.state, run.resumed = deepcopy(self.state), True
        run.counted = {record.name for record in self.records if record.time == self.state.t}
        run.modes, run.bias, run.sizes = self.modes, self.bias, self.sizes
        run.first_height, run.peak_speed = dict(self.first_height), dict(self.peak_speed)
        run.impacted, run.gap_rounding = set(self.impacted), self.gap_rounding.copy()
        return run.motion().trajectory

    def motion_so_far(self) -> Motion | None:
        """Return the motion up to its failure; None if it did not begin."""
        if not self.segments:
            return None
        self.reached = int(self.times.searchsorted(self.segments[-1].end, "right"))
        return self.result(refusal="The simulation failed where this motion ends.")

    def result(self, refusal: str = "") -> Motion:
        """Return the segments as one motion; a `refusal` says why it cannot be continued."""
        times, states = self.times[: self.reached].copy(), self.states[: self.reached]
        last, transitions = self.segments[-1].end, self.transitions
        contacts, columns, go_on = self.contacts, self.compiled.trajectory_columns, self._go_on
        if transitions is not None and not refusal:
            refusal = (
                "`sensitivities` of a motion that is continued are not known. Simulate over the "
                "whole time at once, or without `sensitivities`."
            )
        return Motion(
            problem=self.problem,
            integrator=Integrator(self.solver, constraints_enforced=True),
            options=self.options,
            times=times,
            states=states,
            segments=tuple(self.segments),
            events=sorted((r for r in self.records if r.time <= last), key=lambda r: r.time),
            statistics={"transitions": len(self.segments) - 1, **self.totals},
            sensitivities=None if transitions is None else transitions.results(self.reached),
            label=partial(
                contact_trajectory, columns, contacts, self.impacts, transitions, go_on, refusal
            ),
        )
