"""The Python side of an integration: it calls compiled code and handles its return codes.

Compiled code returns after some steps, so that the interpreter can handle an interrupt and update a
progress bar; at events that change the state; and when it cannot go on.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from math import isfinite
from time import perf_counter
from types import MappingProxyType
from typing import TYPE_CHECKING, Any
from weakref import WeakSet

import numpy as np

from pydy._array_layout import address
from pydy._checks import descends
from pydy._errors import (
    IntegrationError,
    IntegrationInterrupted,
    note_finished,
    warn_user,
)
from pydy._interrupts import Interrupts
from pydy._kernel import Inputs, Kernel, KernelCall
from pydy._names import few, numbers_of
from pydy._optional import bar_of
from pydy.solvers import layout as at
from pydy.solvers.compiled_events import CompiledEvents
from pydy.solvers.constraint_rank import ConstraintRank
from pydy.solvers.constraints import CompiledConstraints
from pydy.solvers.options import Options
from pydy.solvers.outcome import Outcome
from pydy.solvers.reflection import reflected, reversed_times
from pydy.solvers.run.dense_output import DenseOutput
from pydy.solvers.run.departure import (
    acts_at_start,
    departure,
    follows_itself,
    happens_at_start,
    is_stationary,
    is_unresolved,
    on_surface,
    resolved_side,
)
from pydy.solvers.run.shipped import function_of, stepper
from pydy.solvers.run.workspace import Workspace, WorkspaceCopy
from pydy.solvers.tableaus import IMPLICIT, tableau_of
from pydy.solvers.tuning import (
    BLOCK,
    CROWDED,
    FAR_ORIGIN,
    LEAST_TOLERANCE,
    MANY_STEPS,
    NEARLY_SINGULAR,
    NO_LATER,
    ROUNDING,
    STARTING_MOVE,
)
from pydy.trajectory import EventRecord

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

SLICE = 0.02
"""Approximate time in compiled code, in seconds, between checks for interrupts."""


def first_budget(method: str, call: KernelCall | None, calls_python: bool) -> int:
    """Return a number of steps that takes a few milliseconds at most; later ones are measured."""
    if calls_python or call is None:
        return 1
    # Nanoseconds: one for each operation, and 100 for the call.
    evaluation = 100 + len(call.kernel.program.ops)
    if method == IMPLICIT:
        # Ten Newton iterations, the Jacobian, and a real and a complex matrix to factorise.
        n = call.kernel.program.signature.num_states
        return max(1, 2_000_000 // ((30 + n) * evaluation + 4 * n**3))
    return max(4, 100_000 // evaluation)  # twenty evaluations


def progress_bar(name: str, span: float, start: float) -> Any:
    """Return a bar of tqdm over the simulated time, from `start` on."""
    layout = "{l_bar}{bar}| {n:.3g}/{total:.3g} s [{elapsed}<{remaining}]"
    bar = bar_of(total=span, desc=name, bar_format=layout)
    bar.start = start
    return bar


_NO_ROWS = np.zeros((0, 0))
_WARNED_OF: WeakSet[Kernel] = WeakSet()  # whose redundant constraints have been warned of


class Integration(Workspace):
    """An integration that can be run repeatedly, from different states.

    If it is `reusable`, `rebind` may assign it to another call. `stopped` is called now and then;
    True has the effect of Ctrl-C.

    If times descend, the motion is integrated as its reflection in time
    (`pydy.solvers.reflection`): `progress`, `watch` and the other arrays are in reversed time, and
    results are reported in the user's time.
    """

    def __init__(
        self,
        method: str,
        f: Callable[..., ArrayLike],
        n: int,
        times: np.ndarray,
        args: tuple[object, ...],
        options: Options,
        stopped: Callable[[], bool] = lambda: False,
    ) -> None:
        self.backward = descends(times)
        if self.backward:
            f, options = reflected(f, n, args, options)
            times = reversed_times(times)
        super().__init__(method, f, n, times, args, options, Interrupts(stopped))
        sensitivities = options.sensitivities
        # Without the sensitivities that are integrated with them.
        self.states = n if sensitivities is None else sensitivities.states
        if options.recorded is not None:
            self.states = options.recorded
        self._end(Outcome.NOT_COMPUTED)
        self.records: list[EventRecord] = []
        # Warnings by pairs: the event that was reset, and the one that started at zero.
        self.departures_from_zero: dict[tuple[int, int], str] = {}
        self.continuation = options.continuation
        self.inactive_at_start: list[int] = []  # events on whose surface it starts, without acting
        self.on_many_steps: Callable[[int, float, np.ndarray], None] | None = None
        self.reusable = not (self.callbacks or self.call is None or self.backward)
        self._budget = first_budget(method, self.call, bool(self.callbacks))
        self._choose_attention()
        self._time_count = len(times)
        self._rows = _NO_ROWS  # of the current or failed run
        entry = "advance_implicit" if method == IMPLICIT else "advance"
        self._advance = stepper(entry, self.table_address, bool(self.callbacks))

    @property
    def times(self) -> np.ndarray:
        """The times at which the states are given, shape (m,)."""
        times: np.ndarray = self._reported(self.progress.times)
        return times

    def _reported(self, t: Any) -> Any:
        """Convert times of the run to the user's."""
        return reversed_times(t) if self.backward else t

    @property
    def span(self) -> float:
        """The length of the time interval."""
        return float(self.progress.times[-1] - self.progress.times[0])

    def _choose_attention(self) -> None:
        """Decide whether Python has tasks during the run, and set the first budget."""
        self._nearly_exact_tolerances = self._nearly_exact()
        options, events = self.options, self.options.events
        refused = events is not None and any(event.constant for event in events.traits)
        observed = options.constraints is not None or options.progress or refused
        self._attended = observed or bool(self.callbacks) or self._nearly_exact_tolerances

    def retune(self, options: Options) -> bool:
        """Change tolerances, step sizes and step limits; return False if that is impossible."""
        if not (self.reusable and super().retune(options)):
            return False
        self._choose_attention()
        return True

    def renumber(self, p: np.ndarray, r: np.ndarray, times: np.ndarray) -> bool:
        """Change times and numbers of the same call; return False if that is impossible."""
        if (call := self.call) is None:
            return False
        inputs = Inputs(r, call.inputs.sampled, call.inputs.functions)
        return self.rebind(KernelCall(call.kernel, p, inputs, call.names, call.jacobian), times)

    def begin(self, x0: np.ndarray) -> np.ndarray:
        """Project and check an initial state without integrating, and return it."""
        self._begin_run(x0)
        with self.interrupts:
            if self._attended:
                self._start()
        return self.memory.x[: self.n].copy()

    def _begin_run(self, x0: np.ndarray) -> int:
        """Begin a run; return the code of its first slice."""
        self._time_count = len(self.progress.times)
        # Compiled code writes rows in whole blocks.
        self._rows = np.empty((self._time_count + -(-BLOCK // max(1, self.n)), self.n))
        self._rows[0] = self._x0 = x0
        self.code = int(Outcome.NOT_COMPUTED)
        self.records, self.departures_from_zero = [], {}
        if self.records_steps:
            self.clear_steps()
        if self.options.events is not None:
            self.watch.rests[:], self.watch.latest[:] = np.nan, -np.inf
            self.inactive_at_start = []
        continues = self.continuation is not None and self.continuation.sides is not None
        self.beginning.counts[at.BUDGET] = 0 if self._attended or continues else self._budget
        return self._advance(self._rows, True)

    def run(self, x0: np.ndarray) -> np.ndarray:
        """Run to the end from a finite state, and return the states."""
        try:
            code = self._begin_run(x0)
            rows = self._rows
            # Most runs end in their first slice, and no event happens at their ends.
            if code == Outcome.FINISHED:
                self.code, self._rows = code, _NO_ROWS
                if self.options.events is not None:
                    self._empty_log()
                return rows[: self._time_count]
            with self.interrupts:
                if code == at.START_EVENTS:
                    self._start()
                    code = at.PAUSED
                if self.code == Outcome.NOT_COMPUTED:  # else an event ended it at its start
                    self._run(code)
                self._handle_events_at_end()
        except KeyboardInterrupt:
            self._stop(Outcome.INTERRUPTED, IntegrationInterrupted)
        except MemoryError as error:
            if len(self._rows):  # the states were allocated
                times, states = self._finished()
                note_finished(error, "What was computed until then is", times=times, states=states)
            raise
        self._empty_log()
        reached = self.progress.counts[at.NEXT]
        if reached < self._time_count:
            rows[reached : self._time_count] = np.nan
        self._rows = _NO_ROWS
        return rows[: self._time_count]

    # -- running ----------------------------------------------------------------------------------

    def _slice(self, budget: int) -> int:
        """Take at most `budget` steps; return the code with which they stopped."""
        self.progress.counts[at.BUDGET] = budget
        return self._advance(self._rows, False)

    def _run(self, code: int) -> None:
        """Integrate to the end, given the code of the first slice."""
        state, count = self.progress.state, self.progress.counts
        budget, step_count, elapsed = self._budget, 0, 0.0
        bar, warn = None, self.on_many_steps
        if self.options.progress:
            bar = progress_bar(self.name, self.span, float(state[at.TIME]))
        try:
            while True:
                if code in (Outcome.FINISHED, at.END_EVENTS):
                    return self._end(Outcome.FINISHED)
                if code == at.EVENT:
                    if self._act():
                        return
                    state[at.SIZE] = self.options.step or 0.0
                elif (
                    code == Outcome.EVENTS_ACCUMULATE
                    and (events := self.options.events) is not None
                ):
                    return self._end(code, event=events.traits[self.watch.fired.argmax()].name)
                elif code == at.LOG_FULL:
                    self._empty_log()
                    state[at.SIZE] = self.options.step or 0.0
                elif code == at.STEPS_FULL:
                    self.store_steps()
                elif code != at.PAUSED:
                    self._fail(code)
                if warn is not None and count[at.STEPS] + count[at.REJECTED] >= MANY_STEPS:
                    t, x = self._reported(float(state[at.TIME])), self.memory.x[: self.states]
                    warn(MANY_STEPS, t, x.copy())
                    warn = None
                if code == at.PAUSED and elapsed > 0.0:
                    step_count = count[at.STEPS] + count[at.REJECTED] - step_count
                    budget = int(min(max(1.0, step_count * SLICE / elapsed), 4.0 * budget))
                self.interrupts.check()
                start, step_count = perf_counter(), count[at.STEPS] + count[at.REJECTED]
                code = self._slice(budget)
                elapsed = perf_counter() - start
                if bar is not None:
                    bar.update(state[at.TIME] - bar.n - bar.start)
        finally:
            if bar is not None:
                bar.close()

    def _nearly_exact(self) -> bool:
        """Return whether some tolerance may be too small for double precision."""
        if self.name != IMPLICIT and tableau_of(self.name).error_order is None:
            return False
        return bool(self.memory.rtol[: self.n].min(initial=1.0) < 10.0 * ROUNDING)

    def _check_tolerances(self) -> None:
        n = self.n
        rtol, atol, x = self.memory.rtol[:n], self.memory.atol[:n], self.memory.x[:n]
        k, least = int(np.argmin(rtol)), 10.0 * ROUNDING
        if rtol[k] < least and atol[k] < least * abs(x[k]):  # a state of zero shows no size
            self._stop(
                Outcome.TOLERANCE_TOO_SMALL,
                rtol=rtol[k],
                atol=atol[k],
                advice=f"The precision of floats is about {ROUNDING:.1e}: use an rtol of at least "
                f"{least:.1e}.",
            )

    def _start(self) -> None:
        """Check and project the initial state, find the signs of events there, and act on them."""
        if self._nearly_exact_tolerances:
            self._check_tolerances()
        if self.options.constraints is not None:
            self.projection_record[:] = 0.0
            self._warn_of_redundant(self.options.constraints)
            self._project(self.memory.x, self.options.constraints, Outcome.START_OFF_CONSTRAINTS)
        if (events := self.options.events) is not None:
            for event in events.traits:
                if event.constant:
                    self._stop(Outcome.EVENT_CONSTANT, event=event.name)
            self._handle_events_at_start(events)

    def _warn_of_redundant(self, constraints: CompiledConstraints) -> None:
        """Warn, once for each system, of redundant constraints."""
        call = self.call
        assert call is not None
        if constraints.kernel in _WARNED_OF:
            return
        _WARNED_OF.add(constraints.kernel)
        t = float(self.progress.state[at.TIME])
        time = self._reported(t)
        values = call.evaluate(constraints.kernel, self.memory.x[: self.n].copy(), t)
        if names := ConstraintRank(constraints, values).redundant():
            warn_user(
                f"Redundant constraints at t = {time!r}: {few(names)}. They are enforced but do "
                "not raise the rank. Leave them out if that is so in every state."
            )

    def _nearness_at(self, x: np.ndarray, t: float) -> tuple[float, str, float]:
        """Return how near the constraints are to losing rank in a state, and which are involved.

        The last number measures how well they determine the dependent speeds.
        """
        constraints, call, record = self.options.constraints, self.call, self.projection_record
        if constraints is None or call is None or not record[at.RANK] or not np.isfinite(x).all():
            return 1.0, "", 1.0
        values, longest = call.evaluate(constraints.kernel, x, t), record[at.WHERE + self.n :]
        rank = ConstraintRank(constraints, values)
        nearness, names = rank.nearness_to_rank_loss(longest, int(record[at.RANK]))
        return nearness, few(names), rank.determinacy()

    def _project(
        self, x: np.ndarray, constraints: CompiledConstraints, outcome: int, **details: Any
    ) -> None:
        """Project an initial state onto the constraints, unless it is far from them."""
        before, t = x.copy(), float(self.progress.state[at.TIME])
        entry = "project" if self.options.sensitivities is None else "project_columns"
        code = function_of(entry, bool(self.callbacks))(self.table_address, t, address(x), 0)
        change = constraints.relative_change(before[: self.states], x[: self.states], self.span)
        if code != 0 or (change > STARTING_MOVE).any():
            k = int(np.argmax(change))
            correction = f"moved {self._state_name(k)} from {before[k]:.6g} to {x[k]:.6g}"
            x[:] = before
            self._stop(outcome, change="did not converge" if code else correction, **details)

    # -- events -----------------------------------------------------------------------------------

    def _take_sides(
        self,
        zero: Collection[int],
        forced: Mapping[int, float] = MappingProxyType({}),
        rates: np.ndarray | None = None,
    ) -> np.ndarray:
        """Set the sign of each event just after the current time: that of its rate if it is `zero`.

        Returns the current values. Events in `forced` changed sign by a jump at the given times.
        `rates` are those of the current state if they are known.
        """
        events, call = self.options.events, self.call
        assert events is not None
        assert call is not None
        x, t = self.memory.x[: self.n].copy(), float(self.progress.state[at.TIME])
        values = call.evaluate(events.values, x, t)
        for k, value in enumerate(values.tolist()):
            if k in forced:
                value = call.evaluate(events.values, x, forced[k])[k]
            if (k in zero and k not in forced) or value == 0.0:
                rates = events.rates_at(call, x, t, self.span) if rates is None else rates
                value = rates[k]
            self.watch.sides[k] = bool(value > 0.0) - bool(value < 0.0) if isfinite(value) else 0
        return values

    def _handle_events_at_start(self, events: CompiledEvents) -> None:
        """Record events on whose surfaces the motion starts, and let them act.

        An event happens if the motion departs to the side of its direction.
        """
        call, sides, continuation = self.call, self.watch.sides, self.continuation
        assert call is not None
        x, t = self.memory.x[: self.n].copy(), float(self.progress.state[at.TIME])
        rates = events.rates_at(call, x, t, self.span)
        values = self._take_sides((), rates=rates)
        if continuation is not None and continuation.sides is not None:
            sides[:] = continuation.sides
        self.watch.fired[:] = 0
        pairs = zip(values.tolist(), rates[len(values) : 2 * len(values)].tolist(), strict=True)
        touched = False
        for k in [k for k, pair in enumerate(pairs) if on_surface(*pair)]:
            if continuation is not None and (
                continuation.handled is None or k in continuation.handled
            ):
                continue
            side = departure(call, events, k, x, t, self.span)
            direction = events.traits[k].direction
            sides[k] = side
            if not happens_at_start(side, direction):
                continue
            stationary = is_stationary(call, events, k, x, t, self.span)
            if self.watch.acting[k] and acts_at_start(side, direction, stationary):
                self.watch.fired[k] = touched = True
                continue
            if self.watch.acting[k]:
                self.inactive_at_start.append(k)
            self._note_times((k,), t)
            self.records.append(self._record(t, k, x, x))
        if not touched:
            return
        # Outputs at the time of an event are those before it.
        reached = int(np.searchsorted(self.progress.times, t, side="right"))
        self._rows[:reached] = x
        self.progress.counts[at.NEXT] = reached
        sides[self.watch.fired != 0] = 0  # the side before the start is unknown
        self._act()

    def _note_times(self, events: tuple[int, ...], t: float) -> None:
        """Store the times of events, the latest first."""
        for k in events:
            row = self.watch.latest[k]
            row[1:], row[0] = row[:-1].copy(), t

    def _handle_events_at_end(self) -> None:
        """Record events that are zero at the last time, or would be a rounding error later."""
        events, call = self.options.events, self.call
        if events is None or call is None or self.code != Outcome.FINISHED:
            return
        self._empty_log()
        x, t = self.memory.x[: self.n].copy(), float(self.progress.state[at.TIME])
        values = call.evaluate(events.values, x, t)
        rates = events.rates_at(call, x, t, self.span)[: len(values)]
        sides, near = self.watch.sides, 2.0 * ROUNDING * abs(t)
        triples = zip(values.tolist(), rates.tolist(), sides.tolist(), strict=True)
        reaches = [
            (0.0 <= value * side <= near * abs(rate) and rate * side < 0.0)
            or (value == 0.0 and not rate * side > 0.0)  # else it has just departed
            for value, rate, side in triples
        ]
        if not any(reaches):
            return
        distances = values * sides
        recorded = {r.index for r in self.records if r.time == self._reported(t)}
        for k, side in enumerate(sides.tolist()):
            wrong = events.traits[k].direction == side
            self.watch.fired[k] = side != 0 and reaches[k] and not wrong and k not in recorded
        if self.watch.fired.any():
            self.watch.fired[(distances < 0.0) & (rates * sides > 0.0)] = -1
            self._act()

    def _act(self) -> bool:
        """Act on the events at which compiled code stopped; return whether the integration ends."""
        events, call, sensitivities = self.options.events, self.call, self.options.sensitivities
        assert events is not None
        assert call is not None
        self._empty_log()
        t = float(self.progress.state[at.TIME])
        fired = tuple(int(k) for k in np.flatnonzero(self.watch.fired > 0))
        self._note_times(fired, t)
        before = self.memory.x[: self.n].copy()
        forcing_times = {k: events.forcing_time(call, k, before, t) for k in fired}
        zero = {*np.flatnonzero(self.watch.fired).tolist()}  # those that depart from it, too
        for k in fired:
            after, n, event = before, self.states, events.traits[k]
            if event.resets and events.resets is not None:
                after = call.evaluate(events.resets, before, t)[k * n : (k + 1) * n]
            if not np.isfinite(after).all():
                self._stop(Outcome.RESET_NOT_FINITE, event=event.name, state=after[:n])
            following = np.concatenate([after[:n], before[n:]])
            if event.resets and (constraints := self.options.constraints) is not None:
                outcome = Outcome.RESET_OFF_CONSTRAINTS
                self._project(following, constraints, outcome, event=event.name)
            if event.resets:
                zero -= self._moved_off_zero(before, after[:n], following)
                self._note_departures_from_zero(k, fired, before, following, t)
            self.records.append(self._record(t, k, before, following, acting=True))
            before = following
            columns = self.records[-1].sensitivity_after
            if columns is not None and sensitivities is not None:
                sensitivities.table(before)[:] = columns
        self.memory.x[: self.n] = before
        forced = {k: m for k, m in forcing_times.items() if m is not None}
        if terminal := [events.traits[k].name for k in fired if events.traits[k].terminal]:
            self._take_sides(zero, forced)  # a continued motion starts with them
            self._end(Outcome.TERMINATED, event=terminal[0])
            return True
        origins = self.watch.sides.copy()
        had_sign = origins != 0
        had_sign[list(fired)] = False
        values = self._take_sides(zero, forced)
        for undefined in np.flatnonzero(had_sign & np.isnan(values)):
            self._stop(Outcome.EVENT_UNDEFINED, event=events.traits[undefined].name)
        latest, least = self.watch.latest, NO_LATER * ROUNDING * max(abs(t), self.span)
        for k in fired:
            event = events.traits[k]
            place, led = (call, events, k, before, t, self.span), int(self.watch.sides[k])
            if k in zero and event.redirects and is_unresolved(*place, led, t - latest[k, 1]):
                side = resolved_side(*place)
                if follows_itself(side, int(origins[k]), event.direction):
                    self._end(Outcome.EVENTS_ACCUMULATE, event=event.name)
                    return True
                self.watch.sides[k] = side
            crowded = t - latest[k, 1] <= least or t - latest[k, -1] < CROWDED * self.span
            if crowded and self.watch.acting[k] == 1:
                self._end(Outcome.EVENTS_ACCUMULATE, event=event.name)
                return True
        return False

    def _moved_off_zero(
        self, before: np.ndarray, after: np.ndarray, projected: np.ndarray
    ) -> set[int]:
        """Return the events whose expressions a reset moves away from zero.

        They are evaluated before the projection, which may change them by residuals of the
        constraints. Coordinates that residuals determine are taken after it if these have jumped.
        """
        events, constraints, call = self.options.events, self.options.constraints, self.call
        assert events is not None
        assert call is not None
        t = float(self.progress.state[at.TIME])
        if constraints is not None and constraints.following:
            old, new = (
                call.evaluate(constraints.kernel, x, t)[: constraints.sizes.holonomic]
                for x in (before, after)
            )
            if (old != new).any():
                indices = list(constraints.following)
                after = after.copy()
                after[indices] = projected[indices]
        old, values = (call.evaluate(events.values, x, t) for x in (before, after))
        bounds = call.evaluate(events.rates, after, t)[len(values) : 2 * len(values)]
        off = (values != old) & (np.abs(values) > 8.0 * ROUNDING * bounds)
        return {*np.flatnonzero(off).tolist()}

    def _note_departures_from_zero(
        self, event: int, fired: tuple[int, ...], before: np.ndarray, after: np.ndarray, t: float
    ) -> None:
        """Record events that a reset moves from zero: without a sign before, they cross nothing."""
        events, call = self.options.events, self.call
        assert events is not None
        assert call is not None
        old, values = (call.evaluate(events.values, x, t) for x in (before, after))
        (old_rates, _), (rates, bounds) = (
            np.split(events.rates_at(call, x, t, self.span)[: 2 * len(values)], 2)
            for x in (before, after)
        )
        stayed = (values == old) & (np.abs(values) <= 8.0 * ROUNDING * bounds)
        changed = (rates != 0.0) & (np.sign(old_rates) != np.sign(rates))
        in_direction = np.sign(rates) * [event.direction for event in events.traits] >= 0.0
        departs = stayed & changed & in_direction & (self.watch.acting == 1)
        for k in np.flatnonzero(departs).tolist():
            if k not in fired:
                side = "above" if rates[k] > 0.0 else "below"
                other, name = events.traits[k].name, events.traits[event].name
                self.departures_from_zero.setdefault(
                    (event, k),
                    f"At t = {t:.6g} the expression of the event `{other}` was zero when the reset "
                    f"of `{name}` sent it {side}: that is no change of sign, so this event did "
                    "nothing there. If bodies touch, let them start with a small gap, do both in "
                    "one reset, or use `pydy.contact.Contacts`.",
                )

    def event_warnings(self) -> list[str]:
        """Return warnings of events that were zero without a change of sign."""
        events = self.options.events
        if events is None:
            return []
        intervals = self.watch.rests
        start = self._reported(float(self.progress.times[0]))
        if self.backward:
            intervals = reversed_times(intervals.reshape(-1, 2)[:, ::-1].ravel())
        recurring = {r.index for r in self.records if r.time != start}
        unused = [
            "The motion starts exactly on the surface of the event "
            f"`{events.traits[k].name}` and does not come back to it: as the event has "
            "`direction=0`, the start counts as the state after it, and nothing was done. Pass the "
            "`direction` in which it happens, 1 or −1."
            for k in self.inactive_at_start
            if k not in recurring
        ]
        zero = events.zero_interval_warnings(intervals, self.span)
        return [*self.departures_from_zero.values(), *unused, *zero]

    def _empty_log(self) -> None:
        events, count = self.options.events, self.progress.counts
        if events is None:
            return
        for k in range(count[at.LOGGED]):
            event = int(self.watch.log_events[k])
            x, after = self.watch.log_states[k], self.watch.log_after[k]
            self.records.append(self._record(float(self.watch.log_times[k]), event, x, after))
        count[at.LOGGED] = 0

    def _record(
        self, t: float, event: int, before: np.ndarray, after: np.ndarray, acting: bool = False
    ) -> EventRecord:
        """Return the record of an event, given the states with their sensitivities."""
        events, sensitivities, n = self.options.events, self.options.sensitivities, self.states
        assert events is not None
        states, name = (before[:n].copy(), after[:n].copy()), events.traits[event].name
        record = EventRecord(self._reported(t), name, event, *states)
        # Sensitivities that are not recorded only control the steps.
        if sensitivities is None or self.options.recorded is not None:
            return record
        assert self.call is not None
        rtol, atol = (np.broadcast_to(a, n) for a in (self.options.rtol, self.options.atol))
        forced = events.forcing_time(self.call, event, before, t) is not None
        jump = sensitivities.jump(self.call, event, t, before, after[:n], (rtol, atol), forced)
        value = None if forced else events.value_after_jump(self.call, event, before, t, jump.error)
        if value is not None or not jump.depth > jump.error:
            acting = acting and event not in sensitivities.untimed
            if acting and value is not None:
                self._stop(Outcome.EVENT_JUMPS, event=name, value=value)
            if acting:
                end = self._reported(float(self.progress.times[-1]))
                lower = sensitivities.grazing_remedy(jump.lower, [*self.records, record], end)
                self._stop(
                    Outcome.EVENT_GRAZES, event=name, depth=jump.depth, explained=jump.error,
                    lower=lower,
                )  # fmt: skip
            jump = jump._replace(time=np.full(sensitivities.columns, np.nan))
        table = sensitivities.table(before).copy()
        after_columns = jump.after if acting else table
        constraints = self.options.constraints
        if acting and events.traits[event].resets and constraints is not None:
            # States that the reset omits follow from the constraints; so do their derivatives.
            augmented = np.concatenate([after[:n], after_columns.ravel()])
            self._project(augmented, constraints, Outcome.RESET_OFF_CONSTRAINTS, event=name)
            after_columns = sensitivities.table(augmented)
        return replace(
            record,
            time_sensitivity=self._reported(jump.time),
            sensitivity_before=table,
            sensitivity_after=after_columns,
        )

    # -- results ----------------------------------------------------------------------------------

    def reached(self) -> np.ndarray:
        """Return the rows, with sensitivities, up to where a failed run stopped."""
        return self._rows[: self.progress.counts[at.NEXT]]

    def info(self) -> dict[str, Any]:
        """Return the statistics."""
        state, count = self.progress.state, self.progress.counts
        return {
            "method": self.name,
            "code": self.code,
            "status": self.status,
            "time": self._reported(float(state[at.TIME])),
            "steps": int(count[at.STEPS]),
            "rejected": int(count[at.REJECTED]),
            "evaluations": int(count[at.EVALUATIONS]),
            "jacobians": int(count[at.JACOBIANS]),
            "factorisations": int(count[at.FACTORISATIONS]),
            "projections": int(count[at.PROJECTIONS]),
            "last_step": float(state[at.LAST_SIZE]),
            "nearness": self._nearness(),
            "reached": int(count[at.NEXT]),
            "events": list(self.records),
            "sides": tuple(self.watch.sides.tolist()),
            "clear": self._stayed_clear(),
            **({"dense_output": self._dense_output()} if self.options.dense_output else {}),
        }

    def _stayed_clear(self) -> bool:
        """Return whether bounds on the events showed in each step that none happens in it."""
        # Compiled code notes the end of each step in which it looks for events.
        never_looked = self.options.events is not None and np.isnan(self.watch.values[-1])
        return bool(never_looked) and not self.records and self.code == Outcome.FINISHED

    def _nearness(self) -> float:
        """Return how near the projected constraints came to losing rank."""
        record = self.projection_record
        return float(record[at.NEARNESS]) if record.size and record[at.RANK] else 1.0

    def _dense_output(self) -> DenseOutput | None:
        rows = self.step_rows()
        if not Outcome(self.code).is_valid:
            return None
        if rows is None or not len(rows):
            return None
        return DenseOutput(WorkspaceCopy(self), rows, self.n, self.backward)

    def _state_name(self, k: int) -> str:
        names = () if self.call is None else self.call.names()
        return names[k] if k < len(names) else f"x[{k}]"

    def _check_scales(self) -> None:
        """Refuse states that are zero together with their `atol`: their errors have no scale."""
        memory, n = self.memory, self.n
        x, atol, slopes = memory.x[:n], memory.atol[:n], memory.stages[:n]
        indices = np.flatnonzero((x == 0.0) & (atol <= LEAST_TOLERANCE) & (slopes != 0.0))
        if indices.size and np.isfinite(slopes).all():
            names = ", ".join(self._state_name(k) for k in indices[: self.states][:4])
            self._stop(
                Outcome.TOLERANCE_TOO_SMALL,
                rtol=memory.rtol[indices[0]],
                atol=0.0,
                advice=f"Errors of states that are 0, of {names}, are compared with `atol` alone: "
                "pass one above 0.",
            )

    def _fail(self, code: int) -> None:
        """Raise the error for a code with which compiled code failed."""
        if not np.isfinite(self._x0).all():
            raise ValueError(f"`x0` must be finite, got {self._x0}.")
        if code == Outcome.EVENT_UNDEFINED and (events := self.options.events) is not None:
            self._stop(code, event=events.traits[self.watch.fired.argmax()].name)
        step = float(self.progress.state[at.SIZE])
        if code == Outcome.STEP_UNDERFLOW:
            code = int(self.progress.counts[at.FAILURE])
        if code == Outcome.NOT_FINITE:
            self._check_scales()
        t = float(self.progress.state[at.TIME])
        size = f" with a step size of {step:.3g}" if np.isfinite(step) and step else ""
        if code == Outcome.STEP_UNDERFLOW and abs(t) > FAR_ORIGIN * self.span:
            size += (
                f", where floats tell times apart by {np.spacing(t):.2g}: let `times` start nearer "
                "to zero, or loosen the tolerances,"
            )
        details: dict[str, Any] = {
            "max_steps": self.options.max_steps,
            "step": step,
            "size": size,
        }
        nearness, rows, determinacy = self._nearness_at(self.memory.x[: self.n].copy(), t)
        failure = Outcome(code).text.format(**details)
        if nearness < NEARLY_SINGULAR:
            self._stop(Outcome.SINGULAR_CONFIGURATION, rows=rows, failure=failure)
        if determinacy < NEARLY_SINGULAR:
            self._stop(Outcome.SPEEDS_NOT_GIVEN, failure=failure)
        self._stop(code, **details)

    @property
    def status(self) -> str:
        """How the latest run ended, in words."""
        return Outcome(self.code).text.format(**self.details)

    def _end(self, code: int, **details: object) -> None:
        """Store how the run ended."""
        self.code, self.details = int(code), details

    def _stop(
        self,
        code: int,
        kind: type[IntegrationError] | type[IntegrationInterrupted] = IntegrationError,
        **details: object,
    ) -> None:
        """Raise the error of an outcome."""
        self._empty_log()
        self._end(code, **details)
        t = self._reported(float(self.progress.state[at.TIME]))
        x = self.memory.x[: self.states].copy()
        state = numbers_of([self._state_name(k) for k in range(self.states)], x)
        remedy = Outcome(code).remedy.format(**details)
        raise kind(
            f"`{self.name}` {self.status} at t = {t!r} in the state {state}. {remedy}",
            *self._finished(),
            t,
            x,
            self.info(),
        )

    def _finished(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the times that were reached, and their states."""
        reached = int(self.progress.counts[at.NEXT])
        times = self._reported(self.progress.times[:reached].copy())
        return times, self._rows[:reached, : self.states].copy()
