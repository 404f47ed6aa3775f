"""One simulation with contacts: from transition to transition."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from copy import deepcopy
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np

from pydy._errors import ContactError, IntegrationError, IntegrationInterrupted, note_finished
from pydy._forks import cached_property
from pydy._integration import simulate
from pydy._motion import Motion, Segment
from pydy._names import numbers_of, some
from pydy._problem import Problem, Settings, evaluate_specifieds, with_settings
from pydy._rank import ROUNDED, ROUNDING
from pydy.contact.conditions import check_values
from pydy.contact.decide import (
    BACKWARD,
    CLOSED,
    FORWARD,
    OPEN,
    SLIDES,
    SLIDING,
    STARTING,
    STICKS,
    ComplementarityProblem,
    Solution,
    chosen,
    held_rows,
    independent,
    leaps,
    linked,
    opened,
    solved,
    within,
)
from pydy.contact.impacts import strike
from pydy.contact.missed import flat, missed
from pydy.contact.modes import Compiled, Mode
from pydy.contact.rows import Numbers, StartError
from pydy.contact.sensitivities import HybridSensitivities
from pydy.contact.trajectory import contact_trajectory
from pydy.contact.tuning import BEGUN, ERRORS, RESOLUTION, RESOLVED, SLACK, WITHIN
from pydy.solvers import SOLVERS, EventContinuation, Options, Outcome, Solver, read_options
from pydy.trajectory import EventRecord

_NOTED = frozenset({"bends", "clears", "turns"})  # events that change no mode


@dataclass
class State:
    """Where the motion is."""

    t: float
    x: np.ndarray
    touching: set[int]
    rising: set[int]  # open, and on the way up
    resting: set[int]  # contacts whose sliding speed is zero
    directions: dict[int, np.ndarray] = field(default_factory=dict)  # of those in a plane


class Run:
    """One simulation."""

    def __init__(
        self,
        kept: Compiled,
        solver: Solver,
        now: Problem,
        times: np.ndarray,
        events: Sequence[Any],
        options: dict[str, Any],
        carried: Any = None,  # Transitions
    ) -> None:
        self.carried = carried
        self.begun: tuple[str, ...] | None = None  # the modes at the start, if they are given
        self.state: State | None = None  # where the motion is, at last where it ends
        self.resumed = False  # whether it goes on from the end of another run
        self.counted: set[str] = set()  # events of the user's that happened at that end
        self.kept, self.solver, self.now, self.times = kept, solver, now, times
        self.user_events, self.options = events, options
        self.stopped: Callable[[], bool] | None = None  # is asked between transitions
        self.rows, self.contacts = kept.rows, kept.contacts
        self.span = float(times[-1] - times[0])
        self.n = len(now.definition.states)
        self.first = len(now.definition.equations.coordinates)
        self.states = np.full((len(times), self.n), np.nan)
        self.segments: list[Segment] = []
        self.records: list[EventRecord] = []
        self.impacts: list[tuple[float, dict[str, tuple[float, ...]], float]] = []
        self.first_height: dict[int, float] = {}
        self.modes: tuple[str, ...] = tuple(OPEN for _ in self.contacts)
        self.sizes = np.zeros(len(self.contacts))  # of forces where a part of the motion begins
        self.sure: set[int] = set()  # contacts with events of their own at the last transition
        self.bias: np.ndarray | None = None
        self.redundant = False
        self.quickest: dict[int, float] = {}  # sliding speeds since they began
        self.reached = np.ones(len(times), dtype=bool)
        self.totals = {"steps": 0, "rejected": 0, "evaluations": 0}
        self._latest: tuple[Any, Numbers] | None = None  # a state, and the rows there
        self.struck: set[int] = set()  # contacts that have closed
        self.untold: dict[int, str] = {}  # transitions that an event of another contact has shown
        self.widest = np.zeros(len(self.contacts))  # bounds on roundings of the gaps until now
        values = zip(now.definition.constants, now.p.tolist(), strict=True)
        self._numbers_of: dict[Any, float] = dict(values)

    # -- numbers ----------------------------------------------------------------------------------

    @cached_property
    def _tolerances(self) -> Options:
        given = {k: v for k, v in self.options.items() if k in ("rtol", "atol")}
        return read_options("dop853", True, given)

    # Of another shape than the states have, it is refused where they are integrated.
    atol = property(lambda self: np.asarray(self._tolerances.atol))
    rtol: Any = property(lambda self: float(np.min(self._tolerances.rtol, initial=1.0)))

    def numbers(self, t: float, x: np.ndarray) -> Numbers:
        """Return the rows of the contacts at a state."""
        key = t, x.tobytes()
        if self._latest is None or self._latest[0] != key:
            r = np.zeros(0)
            if self.now.definition.specifieds:
                r = evaluate_specifieds(self.now, np.array([t]), x[None])[0]
            self._latest = key, self.rows.numbers(t, x, r, self.now.p)
        return self._latest[1]

    def values(self, t: float, x: np.ndarray) -> dict[Any, float]:
        """Return a number for each symbol."""
        definition = self.now.definition
        values = {**self._numbers_of, definition.equations.time: t}
        values.update(zip(definition.states, x.tolist(), strict=True))
        if definition.specifieds:
            r = evaluate_specifieds(self.now, np.array([t]), x[None])[0]
            values.update(zip(definition.specifieds, r.tolist(), strict=True))
        return values

    def problem(self, p: Numbers, state: State) -> ComplementarityProblem:
        """Return the problem of accelerations that combinations of modes are tried on."""
        self.note_directions(p, state)
        return ComplementarityProblem(
            p.free, p.square, self.rows.normal, self.rows.tangent, p.mu, p.mu_static, p.normal,
            frozenset(state.resting), frozenset(state.touching), dict(state.directions), self.bias,
            p.terms,
        )  # fmt: skip

    def note_directions(self, p: Numbers, state: State) -> None:
        """Record the directions of sliding in a plane; contacts that begin to slide keep theirs."""
        for i, rows in enumerate(self.rows.tangent):
            if len(rows) == 2 and i in state.touching and i not in state.resting:
                speed = p.speed[rows]
                if not p.is_still(rows, speed):
                    state.directions[i] = speed / np.linalg.norm(speed)
                elif i not in state.directions:  # an impact has left it nothing but rounding
                    state.resting.add(i)

    def resolution(self, t: float) -> float:
        """Return the time within which events happen at the same instant."""
        return RESOLUTION * max(abs(t), self.span)

    def fail(self, t: float, x: np.ndarray, why: str) -> ContactError:
        """Return an error with the state, the modes and the results so far."""
        state = numbers_of(self.now.definition.states, x)
        results = self.so_far(t, x)
        where = f"At t = {t!r} in the state {state}; the modes before were {results[-1]['modes']}."
        return ContactError(f"{why} {where}", *results)

    def so_far(self, t: float, x: np.ndarray) -> tuple[Any, ...]:
        """Return the results up to a time and a state, as errors have them."""
        done = int((self.times < t).sum())
        modes = dict(zip([c.name for c in self.contacts], self.modes, strict=True))
        info = {"modes": modes, "events": list(self.records)}
        return self.times[:done].copy(), self.states[:done].copy(), t, x.copy(), info

    # -- the start --------------------------------------------------------------------------------

    def begin(self) -> State:
        """Return the state at the first time, after the impacts that happen there."""
        t, x = float(self.times[0]), self.now.x.copy()
        p = self.numbers(t, x)
        self.widest = p.near
        if self.begun is None and self.rows.are_open(p, self.now.p):
            return State(t, x, set(), set(), set())
        check_values(self.contacts, p)
        for expression in self.rows.switched:
            expression.check(self.values(t, x))
        self.rows.checked = self.now.p.tobytes()
        closed = {i for i, n in enumerate(self.rows.normal) if n is not None and p.is_closed(i)}
        self.rows.check_directions(closed, self.values(t, x))
        state = State(t, x, set(), set(), set())
        closing, moving = set[int](), p.moving()
        for i, c in enumerate(self.contacts):
            normal = self.rows.normal[i]
            if normal is None or (self.begun is not None and self.begun[i] != OPEN):
                state.touching.add(i)
                continue
            nothing = WITHIN * np.finfo(float).eps * p.near[i]
            # Open, it may be widest.
            if not (p.gap[i] > nothing or p.square[normal, normal] > 0.0):
                raise self.fail(t, x, flat(self, t, x, [i]))
            if -p.gap[i] > max(nothing, self.unresolved_gap(i, p, x)):
                why = (
                    f"The gap of {c.name!r} must not be negative at the first time, got "
                    f"{p.gap[i]:.6g}. Change the initial conditions, or the sign of the gap."
                )
                raise StartError(why) if self.begun is None else self.fail(t, x, why)
            if p.gap[i] <= nothing:
                speed = moving[normal]
                (state.rising if speed > 0 else closing if speed < 0 else state.touching).add(i)
        for i, rows in enumerate(self.rows.tangent):
            if rows and i in state.touching:
                # What is left of gaps and speeds that given modes hold is projected away.
                begun = self.begun
                if p.is_still(rows, p.speed[rows]) if begun is None else begun[i] == STICKS:
                    state.resting.add(i)
        self.modes = tuple(
            OPEN if i not in state.touching else self.options_of(state, p, i)[0]
            for i in range(len(self.contacts))
        )
        if closing:
            strike(self, state, closing)
        return state

    # -- what happens -----------------------------------------------------------------------------

    def options_of(self, state: State, p: Numbers, i: int) -> list[str]:
        """Return the possible modes of a contact, likely ones first."""
        if i not in state.touching:
            return [OPEN]
        rows, found = self.rows.tangent[i], [CLOSED]
        if len(rows) == 2:
            found = [STICKS, STARTING] if i in state.resting else [SLIDING]
        elif rows:
            sliding = [FORWARD if p.speed[rows[0]] > 0.0 else BACKWARD]
            found = [STICKS, FORWARD, BACKWARD] if i in state.resting else sliding
        return found if self.rows.normal[i] is None else [*found, OPEN]

    def decide(
        self, state: State, fixed: dict[int, str], excluded: Collection[tuple[str, ...]] = ()
    ) -> Solution:
        """Return the modes from here on, by the complementarity of the accelerations."""
        self.bias = None
        if not state.touching:
            return opened(len(self.contacts), len(self.rows.speeds))
        p = self.numbers(state.t, state.x)
        still = [row for i in sorted(state.resting) for row in self.rows.tangent[i]]
        if len(held := independent(p.square, still)) < len(still):
            # What is left of speeds that are zero together contradicts that in its accelerations.
            self.settle(state, tuple(held))
            p = self.numbers(state.t, state.x)
        problem = self.problem(p, state)
        for i in state.touching - state.resting:
            normal, rows = self.rows.normal[i], self.rows.tangent[i]
            if normal is not None and rows and fixed.get(i) != OPEN:
                along = state.directions[i] if len(rows) == 2 else np.sign(p.speed[rows])
                push = p.mu[i] * p.square[normal, rows] @ along
                if p.square[normal, normal] - push <= SLACK * p.square[normal, normal]:
                    raise self.fail(
                        state.t, state.x,
                        f"Painlevé's paradox: a normal force at {self.contacts[i].name!r}, which "
                        "slides, would not push the bodies apart, because its friction pulls them "
                        "together by more.",
                    )  # fmt: skip
        every = [self.options_of(state, p, i) for i in range(len(self.contacts))]
        wanted = [[fixed[i]] if i in fixed else own for i, own in enumerate(every)]
        found = chosen(problem, wanted, excluded)
        if found is None and fixed.keys() - self.sure:
            # What was told by values that are nearly zero may be wrong; events are not.
            tied = self.sure & fixed.keys()
            wanted = [[fixed[i]] if i in tied else own for i, own in enumerate(every)]
            found = chosen(problem, wanted)
        found = found or (chosen(problem, every) if fixed or excluded else None)
        if found is None:
            raise self.fail(
                state.t, state.x,
                "Jamming: no combination of contacts that open, stick and slide satisfies the "
                "equations of motion.",
            )  # fmt: skip
        for i, mode in enumerate(found.modes):
            if mode == OPEN and i in state.touching:
                state.touching.discard(i)
                state.resting.discard(i)
                state.rising.add(i)
        return found

    def note_rest(
        self, state: State, i: int, p: Numbers, rebound: tuple[float, float, float], slopes: Any
    ) -> None:
        """Note when impacts of a contact that accumulate end.

        That is by the speed of the first `rebound`, its acceleration, and the ratio by which speeds
        fall; the `slopes` are those of the rows before the impact.
        """
        v, a, ratio = rebound
        later = 1.0 / (a * (1.0 - ratio)) if ratio < 1.0 else 0.0
        limit, name = float(state.t + 2.0 * v * later), f"{self.contacts[i].name} rests"
        record = EventRecord(limit, name, i, state.x.copy(), state.x.copy())
        if isinstance(self.carried, HybridSensitivities):  # with the forces of other contacts held
            normal, by_e = self.rows.normal[i], slopes["restitution"][i]
            slower = v * later * a * by_e + v / a * slopes["free"][normal]
            faster = -p.restitution[i] * slopes["speed"][normal] - p.speed[normal] * by_e
            moved = self.carried.time + 2.0 * later * (faster + slower)
            if self.kept.hypothesis == "poisson":  # others change the ratio between rebounds
                moved = np.full(len(moved), np.nan)
            record = replace(record, time_sensitivity=moved)
        if limit <= self.times[-1]:
            self.records.append(record)

    def check_instant(
        self, state: State, p: Numbers, slopes: np.ndarray, closing: Collection[int]
    ) -> None:
        """Refuse derivatives where contacts close together only at this very state."""
        for i in sorted(closing):
            apart = self.carried.apart(i, slopes[i], p, SLACK + ERRORS * self.rtol)
            if apart:
                raise self.fail(
                    state.t, state.x,
                    f"{self.contacts[i].name!r} closes at the instant of another transition, but "
                    f"with another {some(apart)} it would close before or after that: there is no "
                    "derivative. Leave that out of the parameters, or begin a little elsewhere.",
                )  # fmt: skip

    def unresolved(self, i: int) -> float:
        """Return the sliding speed that is not told from zero by the tolerances of the solver."""
        atol = float(np.min(self.atol))
        return float(ERRORS * (atol + self.rtol * self.quickest.get(i, 0.0)))

    def is_low(self, i: int, speed: float, acceleration: float, p: Numbers, x: np.ndarray) -> bool:
        """Whether the rebounds that follow are all lower than the tolerance of the solver.

        Heights are compared with that of the first impact of the sequence, and with what the
        solver tells of the gap: twice that, so that no impact which follows grazes.
        """
        if not acceleration < 0.0:
            return False
        height = speed**2 / (2.0 * -acceleration)
        first = self.first_height.setdefault(i, height)
        return bool(height <= max(self.rtol * first, 2.0 * self.unresolved_gap(i, p, x)))

    def unresolved_gap(self, i: int, p: Numbers, x: np.ndarray) -> float:
        """Return the gap that is not told from zero by the tolerances of the solver."""
        atol = np.broadcast_to(self.atol, self.n)[: self.first]
        return float(np.abs(p.gradient[i]) @ (atol + self.rtol * np.abs(x[: self.first])))

    # -- from transition to transition ------------------------------------------------------------

    def motion(self) -> Motion:
        """Integrate over all times."""
        state = self.state if self.resumed and self.state is not None else self.begin()
        self.state = state
        try:
            self._go_through(state)
        except (ContactError, IntegrationInterrupted) as error:
            error.motion = self.partial()
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
            if hasattr(error, "times"):  # of the last part
                vars(error).update(parts)
            else:
                note_finished(error, "What was computed until then is", **parts)
            raise
        return self.result()

    def _go_through(self, state: State) -> None:
        """Go from mode to mode, until the end."""
        fixed: dict[int, str] = {}
        instants, transitions = 0, 0
        excluded: set[tuple[str, ...]] = set()  # what is not possible at this instant
        while True:
            if self.stopped is not None and self.stopped():
                raise KeyboardInterrupt
            before, touching, resting = state.t, set(state.touching), set(state.resting)
            found = self.decide(state, fixed, excluded)
            if self.redundant and excluded:
                self.note_changes(state, found)
            for i, kind in self.untold.items():
                if found.modes[i] == fixed.get(i):
                    self.note(state, i, kind, state.x)
            self.untold = {}
            self.modes = found.modes
            ended, fired = self.run(state, found)
            if ended:
                return
            here = state.t - before <= self.resolution(state.t)
            excluded = excluded if here else set()
            impacts = len(self.impacts)
            shared = self.redundant and {what for what, _ in fired} <= {"slips", "opens"}
            fixed = {} if shared else self.after(state, fired)
            # What ended as it began is no mode at this instant, unless velocities have changed.
            still = here and len(self.impacts) == impacts
            again = not self.goes_on(state) if shared else still
            excluded = {*excluded, self.modes} if again else set()
            if again and still:  # nor has anything opened
                state.touching |= touching
                state.resting |= resting
                state.rising -= touching
            transitions += 1
            instants = instants + 1 if here else 0
            # Several contacts may take several transitions each at one instant.
            if instants > 64 or transitions > 100_000:
                raise self.fail(
                    state.t, state.x,
                    "Chattering: the contacts change their modes again and again without an end.",
                )  # fmt: skip

    def run(self, state: State, solution: Solution) -> tuple[bool, list[tuple[str, int]]]:
        """Integrate in one mode; return whether the end was reached, and else the event."""
        state.directions.update(solution.directions)
        self.bias = solution.bias
        p = self.numbers(state.t, state.x)
        # An impact elsewhere may have turned round what was on its way up.
        normals = self.rows.normal
        state.rising = {i for i in state.rising if p.speed[normals[i]] > 0.0 or p.is_closed(i)}
        held, every = self.hold(p, state, solution)
        if held:
            self.settle(state, held)
            if self.carried is not None:
                settled = self.numbers(state.t, state.x)
                self.carried.project(self.values(state.t, state.x), settled, held)
        mode, model = self.kept.mode(solution.modes, held, every)
        events, kinds = mode.events
        events = [*events, *self.user_events]
        kinds = [("turns", i) if what == "closes" and i in state.rising else (what, i)
                 for what, i in kinds]  # fmt: skip
        later = self.times > state.t
        self.states[self.times == state.t] = state.x
        if self.carried is None and not later.any():
            return True, []
        now = Problem(
            model.definition,
            replace(model, already_warned=self.now.model.already_warned),
            # Assumptions are judged along the whole motion.
            Settings(
                {**self._numbers_of, **self.references(p, state, solution)},
                self.now.settings.specifieds,
                dict(zip(self.now.definition.states, state.x.tolist(), strict=True)),
                np.concatenate([[state.t], self.times[later]]),
            ),
        )
        options = {**self.options, "events": events}
        # Only events of the user's happen where the motion starts.
        later_part = self.segments or self.resumed
        options["continuation"] = EventContinuation(
            None if later_part else frozenset(range(len(kinds)))
        )
        # Each part would begin with the drift so far.
        if held or now.definition.equations.constraints.velocity:
            options["constraints"] = "project"
        solver = self.shorten(p, state, solution, options)
        if self.carried is not None:
            slides = any(solution.modes[i] in SLIDES for i in state.resting)
            rates = now.at(np.array([state.t]), state.x[None]).rates()[0]
            given = self.carried.starts(rates, slides)
            if not later.any():
                self.carried.begun(state.t, given, self.records)
                return True, []
        try:
            if self.carried is not None:
                motion = self.carried.simulate(mode, given, now, solver, options)
            else:
                motion = simulate(now, now.settings.times, solver=solver, **options)
        except (IntegrationError, IntegrationInterrupted, MemoryError) as error:
            states = getattr(error, "states", np.empty((0, self.n)))[1:, : self.n]
            self.states[np.flatnonzero(later)[: len(states)]] = states
            if isinstance(error, MemoryError):
                raise
            last = error.state[: self.n]
            if isinstance(error, IntegrationInterrupted):
                raise IntegrationInterrupted(str(error), *self.so_far(error.time, last)) from None
            closed = self.rows.owners_of(held).values()
            why = flat(self, error.time, last, closed) if np.isfinite(last).all() else ""
            why = why or f"The integration stopped in the modes {', '.join(self.modes)}: {error}"
            raise self.fail(error.time, last, why) from error
        return self.take(state, mode, motion, kinds)

    def hold(
        self, p: Numbers, state: State, solution: Solution
    ) -> tuple[tuple[int, ...], list[int]]:
        """Return the rows that are held, independent ones and all; note forces and speeds."""
        every, held, self.sizes = list[int](), tuple[int, ...](), solution.sizes
        if state.touching:
            problem = self.problem(p, state)
            every = held_rows(problem, solution.modes)
            held = tuple(independent(p.square, every))
            self.sizes = solved(problem, solution.modes).sizes
        self.redundant = len(held) < len(every)
        for i, mode in enumerate(solution.modes):
            if mode in SLIDES:
                speed = float(np.linalg.norm(p.speed[self.rows.tangent[i]]))
                self.quickest[i] = max(self.quickest.get(i, 0.0), speed)
            else:
                self.quickest.pop(i, None)
        return held, every

    def shorten(
        self, p: Numbers, state: State, solution: Solution, options: dict[str, Any]
    ) -> Solver:
        """Return the solver, and begin with short steps, where sliding in a plane begins.

        Friction turns a velocity in a plane ever faster the slower it is: steps are in proportion
        to the speed, slopes at rest hide the error of a long first step, and the direction of the
        least speed has to be resolved. Implicit methods take longer steps, in which they see no
        turns. Where sliding begins without an acceleration, as with μ = μ_static, slopes hide more:
        explicit methods have to do it; but several contacts that turn each other are stiff then.
        """
        if STARTING not in solution.modes:
            return self.solver
        at_once = leaps(solution, p.free, self.rows.tangent)
        several = solution.modes.count(STARTING) > 1
        if (at_once or several) and "step" not in options:
            # From there a dozen steps that grow as they may lead to any other size.
            options["first_step"] = 16.0 * self.resolution(state.t)
            if at_once or self.carried is not None:
                options["atol"] = RESOLVED**2 * self.atol
                return SOLVERS["dop853"]
            return SOLVERS["radau"]
        if self.carried is not None:
            raise NotImplementedError(
                "`sensitivities` where a body begins to slide in a plane without an acceleration, "
                "as under a pull that grows until `mu` = `mu_static` is reached, or in steps of a "
                "fixed size, are not known. Pass a larger `mu_static` and an adaptive solver, or "
                "simulate without `sensitivities`."
            )
        return self.solver

    def references(self, p: Numbers, state: State, solution: Solution) -> dict[Any, float]:
        """Return the biases, the opening gaps, and the directions of sliding in a plane.

        The least speed is rounding, or, where they begin to slide, a part of what the solver
        resolves: below it the direction is that of the acceleration. They have begun at a part of
        the speed that they would gain without contacts.
        """
        bias = np.zeros(len(self.rows.speeds)) if self.bias is None else self.bias
        found: dict[Any, float] = dict(zip(self.rows.biases, bias.tolist(), strict=True))
        eps, tiny = float(np.finfo(float).eps), float(np.finfo(float).tiny)
        found.update(dict.fromkeys(self.rows.rising, 0.0))
        for i in state.rising:  # roundings of their speeds
            found[self.rows.rising[i]] = max(eps * float(p.slow[self.rows.normal[i]]), tiny)
        for i in state.resting:
            # Friction has just reached its limit: the acceleration grows from zero, of which √ε of
            # its terms may be missing. Until it has made up for that, speeds are ε of theirs.
            if solution.modes[i] in (FORWARD, BACKWARD) and solution.margins[i] <= SLACK:
                (row,) = self.rows.tangent[i]
                terms = max(float(p.slow[row]), float(p.terms[row]) * self.span)
                found[self.rows.rising[i]] = WITHIN * eps * terms
        for i, symbols in self.rows.references.items():
            if solution.modes[i] not in (STARTING, SLIDING):
                continue
            rows = self.rows.tangent[i]
            gained = float(np.linalg.norm(p.free[rows])) * self.span
            # In the shortest step that can be taken, of 16 roundings of the time.
            least = 16.0 * eps * max(float(np.linalg.norm(p.slow[rows])), gained)
            # Derivatives turn ever faster before a stop: there, a turn within errors is the stop.
            clear = 0.0 if self.carried is not None else self.unresolved(i)
            if solution.modes[i] == STARTING:
                least, clear = max(least, RESOLVED * float(np.min(self.atol))), BEGUN * gained
            along = map(float, solution.directions.get(i, np.array([1.0, 0.0])))
            found.update(zip(symbols, [*along, least or 1.0, clear], strict=True))
        return found

    def settle(self, state: State, held: tuple[int, ...]) -> None:
        """Remove rounding errors of closed gaps and sticking speeds by Newton's method."""
        owners = self.rows.owners_of(held)
        normals, given = list(owners), np.abs(state.x)
        for _ in range(3):  # the second changes the last digits, if any
            p = self.numbers(state.t, state.x)
            rest = p.gap[list(owners.values())]
            if not rest.any() and not p.speed[list(held)].any():
                return
            x = state.x.copy()
            if normals:
                shares = np.linalg.solve(p.square[np.ix_(normals, normals)], -rest)
                x[: self.first] += p.kinematics @ (p.moves[:, normals] @ shares)
                p = self.numbers(state.t, x)
            rows = list(held)
            shares = np.linalg.solve(p.square[np.ix_(rows, rows)], -p.speed[rows])
            x[self.first : self.first + len(p.moves)] += p.moves[:, rows] @ shares
            # What is left of a number that vanishes is rounding of that number.
            state.x = np.where(np.abs(x) <= ROUNDING * given, 0.0, x)

    def take(
        self, state: State, mode: Mode, motion: Motion, kinds: list[tuple[str, int]]
    ) -> tuple[bool, list[tuple[str, int]]]:
        """Keep the states up to the event that ended the mode."""
        for name in self.totals:
            self.totals[name] += motion.statistics[name]
        own = len(kinds)
        stopped = motion.statistics["code"] == Outcome.TERMINATED
        end = motion.events[-1].time if stopped else float(self.times[-1])
        at_end = [r for r in motion.events if stopped and r.time == end]
        acting = [r for r in at_end if r.index < own and kinds[r.index][0] != "nears"]
        told_of = {kinds[r.index] for r in acting}
        last = at_end[-1].before if stopped else None
        if broken := missed(self, motion, mode.places, state.resting, end, last, told_of):
            return False, broken
        if self.carried is not None:
            self.carried.took(motion, end, self.records)
        for record in motion.events:
            again = record.name in self.counted and record.time - self.times[0] <= self.resolution(
                state.t
            )
            first = not (self.segments or self.resumed)
            if record.index >= own and not again and (record.time > state.t or first):
                self.records.append(replace(record, index=record.index + len(self.contacts) - own))
        rows = (self.times > state.t) & (self.times <= end)
        self.states[rows] = motion.states[1 : 1 + int(rows.sum())]
        self.segments.append(
            Segment(
                state.t, end, mode.modes, motion.problem, mode.columns, motion.dense,
                motion.augmented,
            )
        )  # fmt: skip
        if not stopped:
            state.t, state.x = end, motion.states[-1, : self.n].copy()
            return True, []
        if self.carried is not None and acting:
            one = next((r for r in acting if kinds[r.index][0] not in _NOTED), acting[-1])
            before = np.ascontiguousarray(one.before[: self.n])
            rates = motion.problem.at(np.array([end]), before[None]).rates()[0]
            self.carried.ended(one, rates)
            what, i = kinds[one.index]
            if what in ("stops", "bends") and len(self.rows.tangent[i]) == 2:
                values = self.values(end, one.before[: self.n])
                self.carried.doubt(values, self.rows.tangent[i])
        after = at_end[-1].after[: self.n].copy()
        p, lasted = self.numbers(end, after), end - state.t
        for i in [i for i in state.resting if mode.modes[i] in SLIDES]:
            tangent = self.rows.tangent[i]  # what rounding of forces alone has moved still rests
            rate = SLACK * self.sizes[i] * np.linalg.norm(p.square.diagonal()[tangent])
            if np.linalg.norm(p.speed[tangent]) > rate * lasted:
                state.resting.discard(i)
        state.t, state.x = end, after
        if any(r.index >= own and self.user_events[r.index - own].terminal for r in at_end):
            self.reached = self.times <= end
            return True, []
        return False, [kinds[r.index] for r in acting]

    def goes_on(self, state: State) -> bool:
        """Whether other forces of the same modes are within the cones, with a margin."""
        problem = self.problem(self.numbers(state.t, state.x), state)
        better = within(problem, solved(problem, self.modes))
        return bool(better.margins.min() > ROUNDED)

    def note_changes(self, state: State, found: Solution) -> None:
        """Note which contacts open and slip where forces were not determined before."""
        for i, (old, new) in enumerate(zip(self.modes, found.modes, strict=True)):
            kind = "opens" if new == OPEN != old else "slips" if old == STICKS != new else ""
            if kind:
                self.note(state, i, kind, state.x)

    def note(self, state: State, i: int, kind: str, before: np.ndarray) -> None:
        """Record a transition of a contact."""
        name = f"{self.contacts[i].name} {kind}"
        self.records.append(EventRecord(state.t, name, i, before.copy(), state.x.copy()))

    def after(self, state: State, fired: list[tuple[str, int]]) -> dict[int, str]:
        """Record a transition; return the modes after it.

        What happens to several contacts at the same instant is told by values that are nearly zero.
        """
        p, eps = self.numbers(state.t, state.x), np.finfo(float).eps
        problem = self.problem(p, state)
        solution = solved(problem, self.modes)
        resolved = self.resolution(state.t)
        # What closes together has roundings of all heights from which it has fallen.
        self.widest = np.maximum(self.widest, p.near)
        closing: set[int] = set()
        fixed: dict[int, str] = {}
        self.untold = {}
        # Others have events of their own.
        near_by = linked(problem, {i for _, i in fired})
        turning = any(kind in ("stops", "bends") for kind, _ in fired)
        self.sure = {i for kind, i in fired if kind == "opens" or (kind == "slips" and not turning)}
        for i, mode in enumerate(self.modes):
            normal, rows = self.rows.normal[i], self.rows.tangent[i]
            what = {kind for kind, k in fired if k == i}
            if turning:  # friction that turns where a body stops leaves the cones of others
                what.discard("slips")
            if mode == OPEN:
                assert normal is not None
                near, speed = WITHIN * eps * self.widest[i], p.speed[normal]
                if i in state.rising:
                    if what:
                        state.rising.discard(i)
                    if what and p.is_closed(i):
                        state.touching.add(i)
                        if rows and np.linalg.norm(p.speed[rows]) <= self.unresolved(i):
                            state.resting.add(i)  # not even its direction is known
                elif what or (speed < 0.0 and p.gap[i] <= near - speed * resolved):
                    closing.add(i)
                continue
            press = p.normal[i] if normal is None else solution.forces[normal]
            if "jams" in what:
                raise self.fail(
                    state.t, state.x,
                    f"Painlevé's paradox: the normal force at {self.contacts[i].name!r}, which "
                    "slides, has no bound, because its friction presses the bodies together.",
                )  # fmt: skip
            little = (SLACK if i in near_by else ROUNDED) * solution.sizes[i]
            if normal is not None and ("opens" in what or press < little):
                fixed[i] = OPEN
                self.untold[i] = "opens"
            elif mode == STICKS:
                force = solution.forces[rows]
                if "slips" in what or p.mu_static[i] * press - np.linalg.norm(force) < little:
                    one = FORWARD if force[0] < 0.0 else BACKWARD
                    fixed[i] = STARTING if len(rows) == 2 else one
                    self.untold[i] = "slips"
            elif rows:
                speed = np.linalg.norm(p.speed[rows])
                if turning and i in near_by and speed <= self.unresolved(i):
                    what.add("stops")  # a body on several feet comes to rest on all of them at once
                if mode == STARTING and speed > self.unresolved(i):
                    what.discard("stops")  # it has turned by a right angle
                slow = np.linalg.norm(solution.rates[rows]) * resolved
                if "stops" in what or p.is_still(rows, p.speed[rows]) or speed <= slow:
                    state.resting.add(i)
            for kind in what & {"opens", "slips", "stops"}:
                self.note(state, i, kind, state.x)
                self.untold.pop(i, None)
        if closing:
            strike(self, state, closing)
            return {}
        return fixed

    # -- the result -------------------------------------------------------------------------------

    def _go_on(self, motion: Motion, times: np.ndarray) -> Any:
        """Return the trajectory from the end of the motion on, at some times."""
        assert self.state is not None
        start = dict(zip(self.now.definition.states, self.state.x.tolist(), strict=True))
        now = with_settings(self.now, times=times, initial_conditions=start)
        run = Run(self.kept, self.solver, now, times, self.user_events, dict(self.options))
        run.state, run.resumed = deepcopy(self.state), True
        run.counted = {record.name for record in self.records if record.time == self.state.t}
        run.modes, run.bias, run.sizes = self.modes, self.bias, self.sizes
        run.first_height, run.quickest = dict(self.first_height), dict(self.quickest)
        run.struck, run.widest = set(self.struck), self.widest.copy()
        return run.motion().trajectory

    def partial(self) -> Motion | None:
        """Return the motion up to where it could not go on; None if it did not begin."""
        if not self.segments:
            return None
        self.reached = self.times <= self.segments[-1].end
        return replace(self.result(), refusal="The simulation failed where this motion ends.")

    def result(self) -> Motion:
        """Return the segments as one motion."""
        times, states = self.times[self.reached], self.states[self.reached]
        last, carried = self.segments[-1].end, self.carried
        names = [c.name for c in self.contacts]
        refusal = (
            "`sensitivities` of a motion that is continued are not known. Simulate over the "
            "whole time at once, or without `sensitivities`."
        )
        return Motion(
            problem=self.now,
            solver=self.solver,
            options=self.options,
            times=times,
            states=states,
            segments=tuple(self.segments),
            events=sorted((r for r in self.records if r.time <= last), key=lambda r: r.time),
            statistics={"transitions": len(self.segments) - 1, **self.totals},
            sensitivities=None if carried is None else carried.results(self.reached),
            projected=True,
            refusal="" if carried is None else refusal,
            proceed=self._go_on,
            label=partial(contact_trajectory, self.kept.named, names, self.impacts, carried),
        )
