"""An integration from Python's side: it hands arrays to compiled code and sees to what happens.

Compiled code comes back after some steps, so that the interpreter can take an interrupt and a bar
can move; at events that change the state; and when it cannot go on.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from contextlib import nullcontext
from dataclasses import replace
from math import isfinite
from time import perf_counter
from types import MappingProxyType
from typing import Any
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
from pydy._kernel import Kernel, KernelCall
from pydy._names import few, numbers_of
from pydy._optional import bar_of
from pydy.solvers import layout as at
from pydy.solvers.constraints import CompiledConstraints
from pydy.solvers.events import CompiledEvents
from pydy.solvers.options import Options
from pydy.solvers.outcome import Outcome
from pydy.solvers.reflection import reflected, reversed_times
from pydy.solvers.run.departure import (
    acts_at_start,
    departure,
    follows_itself,
    happens_at_start,
    is_stationary,
    on_surface,
)
from pydy.solvers.run.extension import Extension
from pydy.solvers.run.shipped import function_of, stepper
from pydy.solvers.run.workspace import Twin, Workspace
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

SLICE = 0.02
"""Seconds in compiled code, about, until an interrupt is noticed and the bar moves."""


def first_budget(method: str, call: KernelCall | None, calls_python: bool) -> int:
    """Return a number of steps that takes a few milliseconds at most; later slices are measured."""
    if calls_python or call is None:
        return 1
    # Of a nanosecond for each operation, and 100 besides.
    evaluation = 100 + len(call.kernel.program.ops)
    if method == IMPLICIT:
        # Ten iterations, derivatives, a real and a complex matrix to factorise.
        n = call.kernel.program.num_states
        return max(1, 2_000_000 // ((30 + n) * evaluation + 4 * n**3))
    return max(4, 100_000 // evaluation)  # twenty evaluations


def progress_bar(name: str, span: float, start: float) -> Any:
    """Return a bar of tqdm over the simulated time, from `start` on."""
    layout = "{l_bar}{bar}| {n:.3g}/{total:.3g} s [{elapsed}<{remaining}]"
    bar = bar_of(total=span, desc=name, bar_format=layout)
    bar.start = start
    return bar


_NO_ROWS = np.zeros((0, 0))
_TOLD: WeakSet[Kernel] = WeakSet()  # whose redundant constraints have been warned of


class Integration(Workspace):
    """An integration that can be run again and again, from other states.

    Where it is `reusable`, `rebind` may make it another call's. `stopped` is asked now and then;
    True is as good as a Ctrl-C.

    Where times descend it runs the motion that is reflected in time (`pydy.solvers.reflection`),
    and reports in the user's time: `progress`, `watch` and the other arrays are in reversed time.
    """

    def __init__(
        self,
        method: str,
        f: Callable[..., Any],
        n: int,
        times: np.ndarray,
        args: tuple[Any, ...],
        options: Options,
        stopped: Callable[[], bool] = lambda: False,
    ) -> None:
        self.backward = descends(times)
        if self.backward:
            f, options = reflected(f, n, args, options)
            times = reversed_times(times)
        super().__init__(method, f, n, times, args, options, Interrupts(stopped))
        beside = options.sensitivities
        self.states = n if beside is None else beside.states  # without what is beside them
        if options.recorded is not None:
            self.states = options.recorded
        self._end(Outcome.NOT_COMPUTED)
        self.records: list[EventRecord] = []
        self.set_off: dict[tuple[int, int], str] = {}  # of event and event, what to say
        self.begun = options.begun
        self.idle: list[int] = []  # events at the start that did not act
        self.on_many_steps: Callable[[float, np.ndarray], None] | None = None
        self.reusable = not (self.callbacks or self.call is None or self.backward)
        self._budget = first_budget(method, self.call, bool(self.callbacks))
        self._attend()
        # Rows are written in whole blocks.
        self._number = len(times)
        self._room = (self._number + -(-BLOCK // max(1, n)), n)
        self._rows = _NO_ROWS  # of the run that is under way, or failed
        entry = "advance_implicit" if method == IMPLICIT else "advance"
        self._advance = stepper(entry, self.place, bool(self.callbacks))

    @property
    def times(self) -> np.ndarray:
        """The times at which the states are given, shape (m,)."""
        times: np.ndarray = self._reported(self.progress.times)
        return times

    def _reported(self, t: Any) -> Any:
        """Return times of the run as the user's."""
        return reversed_times(t) if self.backward else t

    @property
    def span(self) -> float:
        """The interval of time that it covers."""
        return float(self.progress.times[-1] - self.progress.times[0])

    def _attend(self) -> None:
        """Find out whether Python has more to do than to wait for the end."""
        self._tight = self._nearly_exact()
        wanted = self.options.constraints is not None or self.options.progress
        self._attended = wanted or bool(self.callbacks) or self._tight
        self.beginning.counts[at.BUDGET] = 0 if self._attended else self._budget

    def retune(self, options: Options) -> bool:
        """Take other tolerances, step sizes and numbers of steps, or return False."""
        if not (self.reusable and super().retune(options)):
            return False
        self._attend()
        return True

    def renumber(self, p: np.ndarray, r: np.ndarray, times: np.ndarray) -> bool:
        """Take other times and other numbers for the same call, or return False."""
        call = self.call
        return call is not None and self.rebind(replace(call, p=p, r=r, switched=None), times)

    def begin(self, x0: np.ndarray) -> np.ndarray:
        """Project and check an initial state without integrating, and return it."""
        self._set_out(x0)
        with self.interrupts:
            if self._attended:
                self._start()
        return self.memory.x[: self.n].copy()

    def _set_out(self, x0: np.ndarray) -> int:
        """Begin a run and return the code with which its first slice stopped."""
        self._rows = np.empty(self._room)
        self._rows[0] = self._x0 = x0
        self.code = int(Outcome.NOT_COMPUTED)
        self.records, self.set_off = [], {}
        if self.keeps:
            self.forget_steps()
        if self.options.events is not None:
            self.watch.rests[:], self.watch.latest[:] = np.nan, -np.inf
            self.idle = []
            if not self._attended:
                self._begin_here(x0)
                if self._start():
                    ended = self.code != Outcome.NOT_COMPUTED
                    return at.PAUSED if ended else self._advance(self._rows, False)
        return self._advance(self._rows, True)

    def _begin_here(self, x0: np.ndarray) -> None:
        """Begin at a state, as compiled code does before its first step."""
        self.memory.x[: self.n] = x0
        self.progress.state[:] = self.beginning.state
        self.progress.counts[:] = self.beginning.counts
        self.watch.values[at.PROBES * len(self.watch.sides)] = np.nan

    def run(self, x0: np.ndarray) -> np.ndarray:
        """Run to the end from a finite state, and return the states."""
        try:
            code = self._set_out(x0)
            rows = self._rows
            # Most runs end in their first slice.
            if code == Outcome.FINISHED and self.options.events is None:
                self.code, self._rows = code, _NO_ROWS
                return rows[: self._number]
            with self.interrupts if code != Outcome.FINISHED else nullcontext():
                if self._attended and code == at.PAUSED:
                    self._start()
                if self.code == Outcome.NOT_COMPUTED:  # else an event ends it where it begins
                    self._run(code)
                self._look_at_end()
        except KeyboardInterrupt:
            self._stop(Outcome.INTERRUPTED, IntegrationInterrupted)
        except MemoryError as error:
            if len(self._rows):  # there was room for the states
                times, states = self._finished()
                note_finished(error, "What was computed until then is", times=times, states=states)
            raise
        self._empty_log()
        reached = self.progress.counts[at.NEXT]
        if reached < self._number:
            rows[reached : self._number] = np.nan
        self._rows = _NO_ROWS
        return rows[: self._number]

    # -- running ----------------------------------------------------------------------------------

    def _slice(self, budget: int) -> int:
        """Take some steps and return the code with which they stopped."""
        self.progress.counts[at.BUDGET] = budget
        return self._advance(self._rows, False)

    def _run(self, code: int) -> None:
        """Go on to the end, from what the first slice came back with."""
        state, count = self.progress.state, self.progress.counts
        budget, taken, elapsed = self._budget, 0, 0.0
        bar, ask = None, self.on_many_steps
        if self.options.progress:
            bar = progress_bar(self.name, self.span, float(state[at.TIME]))
        try:
            while True:
                if code == Outcome.FINISHED:
                    return self._end(Outcome.FINISHED)
                if code == at.EVENT:
                    if self._act():
                        return self._undo_at_end()
                    state[at.SIZE] = self.options.step or 0.0
                elif (
                    code == Outcome.EVENTS_ACCUMULATE
                    and (wanted := self.options.events) is not None
                ):
                    self._end(code, event=wanted.names[self.watch.fired.argmax()])
                    return self._undo_at_end()
                elif code == at.LOG_FULL:
                    self._empty_log()
                    state[at.SIZE] = self.options.step or 0.0
                elif code == at.STEPS_FULL:
                    self.put_steps_aside()
                elif code != at.PAUSED:
                    self._fail(code)
                if ask is not None and count[at.STEPS] + count[at.REJECTED] >= MANY_STEPS:
                    t, x = self._reported(float(state[at.TIME])), self.memory.x[: self.states]
                    ask(t, x.copy())
                    ask = None
                if code == at.PAUSED and elapsed > 0.0:
                    taken = count[at.STEPS] + count[at.REJECTED] - taken
                    budget = int(min(max(1.0, taken * SLICE / elapsed), 4.0 * budget))
                self.interrupts.check()
                start, taken = perf_counter(), count[at.STEPS] + count[at.REJECTED]
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
        if rtol[k] < least and atol[k] < least * max(abs(x[k]), 1.0):
            self._stop(
                Outcome.TOLERANCE_TOO_SMALL,
                rtol=rtol[k],
                atol=atol[k],
                advice=f"The precision of floats is about {ROUNDING:.1e}: use an rtol of at least "
                f"{least:.1e}.",
            )

    def _start(self) -> bool:
        """Check and project the initial state, find the signs of events there, and act on them.

        Returns whether an event has acted.
        """
        if self._tight:
            self._check_tolerances()
        if self.options.constraints is not None:
            self.seen[:] = 0.0
            self._tell_dependent(self.options.constraints)
            self._project(self.memory.x, self.options.constraints, Outcome.START_OFF_CONSTRAINTS)
        if self.options.events is not None:
            for name, constant in zip(
                self.options.events.names, self.options.events.constant, strict=True
            ):
                if constant:
                    self._stop(Outcome.EVENT_CONSTANT, event=name)
            return self._look_at_start(self.options.events)
        return False

    def _tell_dependent(self, wanted: CompiledConstraints) -> None:
        """Warn, once for each system, of redundant constraints."""
        call = self.call
        assert call is not None
        if wanted.kernel in _TOLD:
            return
        _TOLD.add(wanted.kernel)
        t = float(self.progress.state[at.TIME])
        when = self._reported(t)
        names = wanted.dependent(call.evaluate(wanted.kernel, self.memory.x[: self.n].copy(), t))
        if names:
            warn_user(
                f"Redundant constraints at t = {when!r}: {few(names)}. They are enforced but do "
                "not raise the rank. Leave them out if that is so in every state."
            )

    def _combined(self, x: np.ndarray, t: float) -> tuple[float, str, float]:
        """Return how near the constraints are to losing rank in a state, and the ones involved.

        The last number says how near they are to not giving the dependent speeds.
        """
        wanted, call, seen = self.options.constraints, self.call, self.seen
        if wanted is None or call is None or not seen[at.RANK] or not np.isfinite(x).all():
            return 1.0, "", 1.0
        values, longest = call.evaluate(wanted.kernel, x, t), seen[at.WHERE + self.n :]
        nearness, names = wanted.combination(values, longest, int(seen[at.RANK]))
        return nearness, few(names), wanted.determinacy(values)

    def _project(
        self, x: np.ndarray, wanted: CompiledConstraints, off: int, **details: Any
    ) -> None:
        """Project an initial state onto the constraints, unless it is far from them."""
        before, t = x.copy(), float(self.progress.state[at.TIME])
        entry = "project" if self.options.sensitivities is None else "project_columns"
        code = function_of(entry, bool(self.callbacks))(self.place, t, address(x), 0)
        moved = wanted.moved(before[: self.states], x[: self.states], self.span)
        if code != 0 or (moved > STARTING_MOVE).any():
            k = int(np.argmax(moved))
            mended = f"moved {self._state_name(k)} from {before[k]:.6g} to {x[k]:.6g}"
            x[:] = before
            self._stop(off, change="did not converge" if code else mended, **details)

    # -- events -----------------------------------------------------------------------------------

    def _take_sides(
        self, zero: Collection[int], forced: Mapping[int, float] = MappingProxyType({})
    ) -> np.ndarray:
        """Set the sign that each event has just after now: by its rate where it is `zero`.

        Returns the values now. Those in `forced` changed their sign by a jump at a time.
        """
        wanted, call = self.options.events, self.call
        assert wanted is not None
        assert call is not None
        x, t = self.memory.x[: self.n].copy(), float(self.progress.state[at.TIME])
        values, rates = call.evaluate(wanted.values, x, t), None
        for k, value in enumerate(values.tolist()):
            if k in forced:
                value = call.evaluate(wanted.values, x, forced[k])[k]
            if (k in zero and k not in forced) or value == 0.0:
                rates = call.evaluate(wanted.rates, x, t) if rates is None else rates
                value = rates[k]
            self.watch.sides[k] = bool(value > 0.0) - bool(value < 0.0) if isfinite(value) else 0
        return values

    def _look_at_start(self, wanted: CompiledEvents) -> bool:
        """Record events on whose surfaces the motion starts, and let them act.

        They happen where the motion departs to the side that their direction points to. Returns
        whether any has acted.
        """
        call, sides, begun = self.call, self.watch.sides, self.begun
        assert call is not None
        values = self._take_sides(())
        if begun is not None and begun.sides is not None:
            sides[:] = begun.sides
        x, t = self.memory.x[: self.n].copy(), float(self.progress.state[at.TIME])
        bounds = call.evaluate(wanted.rates, x, t)[len(values) : 2 * len(values)]
        self.watch.fired[:] = 0
        for k in np.flatnonzero(on_surface(values, bounds)).tolist():
            if begun is not None and (begun.handled is None or k in begun.handled):
                continue
            side, direction = departure(call, wanted, k, x, t, self.span), wanted.directions[k]
            sides[k] = side
            if not happens_at_start(side, direction):
                continue
            stationary = is_stationary(call, wanted, k, x, t)
            if self.watch.acting[k] and acts_at_start(side, direction, stationary):
                self.watch.fired[k] = 1
                continue
            if self.watch.acting[k]:
                self.idle.append(k)
            self._happened((k,), t)
            self.records.append(self._record(t, k, x, x))
        if not self.watch.fired.any():
            return False
        # Outputs at the time of an event are those before it.
        reached = int(np.searchsorted(self.progress.times, t, side="right"))
        self._rows[:reached] = x
        self.progress.counts[at.NEXT] = reached
        sides[self.watch.fired != 0] = 0  # where the motion came from is not known
        self._act()
        return True

    def _happened(self, events: tuple[int, ...], t: float) -> None:
        """Note when some events have happened."""
        for k in events:
            row = self.watch.latest[k]
            row[1:], row[0] = row[:-1].copy(), t

    def _look_at_end(self) -> None:
        """Record events that are zero at the last time, or would be a rounding error later."""
        wanted, call = self.options.events, self.call
        if wanted is None or call is None or self.code != Outcome.FINISHED:
            return
        self._empty_log()
        x, t = self.memory.x[: self.n].copy(), float(self.progress.state[at.TIME])
        values = call.evaluate(wanted.values, x, t)
        rates = call.evaluate(wanted.rates, x, t)[: len(values)]
        sides, near = self.watch.sides, 2.0 * ROUNDING * abs(t)
        ahead = values * sides
        reaches = (ahead >= 0.0) & (ahead <= near * abs(rates)) & (rates * sides < 0.0)
        reaches |= (values == 0.0) & ~(rates * sides > 0.0)  # else it has just left
        if not reaches.any():
            return
        told = {r.index for r in self.records if r.time == self._reported(t)}
        for k, side in enumerate(sides.tolist()):
            wrong = wanted.directions[k] == side
            self.watch.fired[k] = side != 0 and reaches[k] and not wrong and k not in told
        if self.watch.fired.any():
            self._act()

    def _act(self) -> bool:
        """Act on the events at which compiled code stopped; return whether the integration ends."""
        wanted, call, beside = self.options.events, self.call, self.options.sensitivities
        assert wanted is not None
        assert call is not None
        self._empty_log()
        t = float(self.progress.state[at.TIME])
        fired = tuple(int(k) for k in np.flatnonzero(self.watch.fired))
        self._happened(fired, t)
        before = self.memory.x[: self.n].copy()
        moments = {k: wanted.forcing_time(call, k, before, t) for k in fired}
        zero = set(fired)
        for k in fired:
            after, n = before, self.states
            if wanted.resetting[k] and wanted.resets is not None:
                after = call.evaluate(wanted.resets, before, t)[k * n : (k + 1) * n]
            if not np.isfinite(after).all():
                self._stop(Outcome.RESET_NOT_FINITE, event=wanted.names[k], state=after[:n])
            following = np.concatenate([after[:n], before[n:]])
            if wanted.resetting[k] and (held := self.options.constraints) is not None:
                self._project(following, held, Outcome.RESET_OFF_CONSTRAINTS, event=wanted.names[k])
            if wanted.resetting[k]:
                zero -= self._left(before, after[:n], following)
                self._note_set_off(k, fired, before, following, t)
            self.records.append(self._record(t, k, before, following, acting=True))
            before = following
            if (moved := self.records[-1].sensitivity_after) is not None and beside is not None:
                beside.table(before)[:] = moved
        self.memory.x[: self.n] = before
        forced = {k: m for k, m in moments.items() if m is not None}
        if any(wanted.terminal[k] for k in fired):
            self._take_sides(zero, forced)  # for who continues the motion
            last = next(wanted.names[k] for k in fired if wanted.terminal[k])
            self._end(Outcome.TERMINATED, event=last)
            return True
        origins = self.watch.sides.copy()
        known = origins != 0
        known[list(fired)] = False
        values = self._take_sides(zero, forced)
        for lost in np.flatnonzero(known & np.isnan(values)):
            self._stop(Outcome.EVENT_UNDEFINED, event=wanted.names[lost])
        latest, least = self.watch.latest, NO_LATER * ROUNDING * max(abs(t), self.span)
        for k in fired:
            if k in zero and wanted.redirects[k] and is_stationary(call, wanted, k, before, t):
                side = departure(call, wanted, k, before, t, self.span)
                if follows_itself(side, int(origins[k]), wanted.directions[k]):
                    self._end(Outcome.EVENTS_ACCUMULATE, event=wanted.names[k])
                    return True
                self.watch.sides[k] = side
            if t - latest[k, 1] <= least or t - latest[k, -1] < CROWDED * self.span:
                self._end(Outcome.EVENTS_ACCUMULATE, event=wanted.names[k])
                return True
        return False

    def _undo_at_end(self) -> None:
        """Finish where an event has followed itself only because the last time is so near.

        A step of few roundings of the time may end where the expression still has the sign that
        it had before the event.
        """
        t, last = float(self.progress.state[at.TIME]), float(self.progress.times[-1])
        rest = NO_LATER * ROUNDING * max(abs(t), self.span)
        if (
            self.code != Outcome.EVENTS_ACCUMULATE
            or last - t > rest
            or (self.options.sensitivities is not None and self.options.recorded is None)
        ):
            return
        self._empty_log()
        event = self.records[-1].index
        same = [r for r in self.records if r.index == event and r.time >= t - rest]
        if len(same) != 2 or len(self.records) < 2 or self.records[-2] is not same[0]:
            return
        self.memory.x[: self.states] = self.records.pop().before
        self.progress.state[at.TIME] = last
        self._take_sides({event})
        self._rows[self.progress.counts[at.NEXT] : self._number] = self.memory.x[: self.n]
        self.progress.counts[at.NEXT] = self._number
        self._end(Outcome.FINISHED)

    def _left(self, before: np.ndarray, after: np.ndarray, projected: np.ndarray) -> set[int]:
        """Return the events whose expressions a reset moves away from zero.

        They are looked at before the projection, which may move them by what is left of
        constraints; but what a residual gives has jumped where that has.
        """
        wanted, held, call = self.options.events, self.options.constraints, self.call
        assert wanted is not None
        assert call is not None
        t = float(self.progress.state[at.TIME])
        if held is not None and held.following:
            was, now = (call.evaluate(held.kernel, x, t)[: held.holonomic] for x in (before, after))
            if (was != now).any():
                places = list(held.following)
                after = after.copy()
                after[places] = projected[places]
        was, values = (call.evaluate(wanted.values, x, t) for x in (before, after))
        bounds = call.evaluate(wanted.rates, after, t)[len(values) : 2 * len(values)]
        off = (values != was) & (np.abs(values) > 8.0 * ROUNDING * bounds)
        return {*np.flatnonzero(off).tolist()}

    def _note_set_off(
        self, event: int, fired: tuple[int, ...], before: np.ndarray, after: np.ndarray, t: float
    ) -> None:
        """Note an event at zero that a reset sets going: as it had no sign, it crosses nothing."""
        wanted, call = self.options.events, self.call
        assert wanted is not None
        assert call is not None
        was, values = (call.evaluate(wanted.values, x, t) for x in (before, after))
        (sides_before, _), (sides, bounds) = (
            np.split(call.evaluate(wanted.rates, x, t)[: 2 * len(values)], 2)
            for x in (before, after)
        )
        still = (values == was) & (np.abs(values) <= 8.0 * ROUNDING * bounds)
        turned = (sides != 0.0) & (np.sign(sides_before) != np.sign(sides))
        asked = np.sign(sides) * np.array(wanted.directions) >= 0.0
        for k in np.flatnonzero(still & turned & asked & (self.watch.acting == 1)).tolist():
            if k not in fired:
                way = "above" if sides[k] > 0.0 else "below"
                self.set_off.setdefault(
                    (event, k),
                    f"At t = {t:.6g} the expression of the event `{wanted.names[k]}` was zero when "
                    f"the reset of `{wanted.names[event]}` sent it {way}: that is no change of "
                    "sign, so this event did nothing there. If bodies touch, let them start with "
                    "a small gap, do both in one reset, or use `pydy.contact.Contacts`.",
                )

    def event_warnings(self) -> list[str]:
        """Return what to say of events that were zero, without a change of sign."""
        wanted = self.options.events
        if wanted is None:
            return []
        rests = self.watch.rests
        start = self._reported(float(self.progress.times[0]))
        if self.backward:
            rests = reversed_times(rests.reshape(-1, 2)[:, ::-1].ravel())
        again = {r.index for r in self.records if r.time != start}
        unused = [
            f"The motion starts exactly on the surface of the event `{wanted.names[k]}` and does "
            "not come back to it: as the event has `direction=0`, the start counts as the state "
            "after it, and nothing was done. Pass the `direction` in which it happens, 1 or −1."
            for k in self.idle
            if k not in again
        ]
        return [*self.set_off.values(), *unused, *wanted.zero_interval_warnings(rests, self.span)]

    def _empty_log(self) -> None:
        wanted, count = self.options.events, self.progress.counts
        if wanted is None:
            return
        for k in range(count[at.LOGGED]):
            event = int(self.watch.log_events[k])
            x, after = self.watch.log_states[k], self.watch.log_after[k]
            self.records.append(self._record(float(self.watch.log_times[k]), event, x, after))
        count[at.LOGGED] = 0

    def _record(
        self, t: float, event: int, before: np.ndarray, after: np.ndarray, acting: bool = False
    ) -> EventRecord:
        """Return the record of an event, from the states with their sensitivities."""
        wanted, beside, n = self.options.events, self.options.sensitivities, self.states
        assert wanted is not None
        states, name = (before[:n].copy(), after[:n].copy()), wanted.names[event]
        record = EventRecord(self._reported(t), name, event, *states)
        if beside is None or self.options.recorded is not None:  # where they but guide the steps
            return record
        assert self.call is not None
        rtol, atol = (np.broadcast_to(a, n) for a in (self.options.rtol, self.options.atol))
        forced = wanted.forcing_time(self.call, event, before, t) is not None
        jump = beside.jump(self.call, event, t, before, after[:n], (rtol, atol), forced)
        value = None if forced else wanted.value_after_jump(self.call, event, before, t, jump.error)
        if value is not None or not jump.depth > jump.error:
            acting = acting and event not in beside.untimed
            if acting and value is not None:
                self._stop(Outcome.EVENT_JUMPS, event=wanted.names[event], value=value)
            if acting:
                self._stop(
                    Outcome.EVENT_GRAZES, event=name, depth=jump.depth, explained=jump.error,
                    lower=jump.lower,
                )  # fmt: skip
            jump = jump._replace(time=np.full(beside.columns, np.nan))
        table = beside.table(before).copy()
        moved = jump.after if acting else table
        if acting and wanted.resetting[event] and (held := self.options.constraints) is not None:
            # What a reset leaves out follows from the constraints, and so do its derivatives.
            whole = np.concatenate([after[:n], moved.ravel()])
            self._project(whole, held, Outcome.RESET_OFF_CONSTRAINTS, event=wanted.names[event])
            moved = beside.table(whole)
        return replace(
            record,
            time_sensitivity=self._reported(jump.time),
            sensitivity_before=table,
            sensitivity_after=moved,
        )

    # -- results ----------------------------------------------------------------------------------

    def reached(self) -> np.ndarray:
        """Return the rows, with sensitivities, of the times that a failed run reached."""
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
            **({"dense_output": self._extension()} if self.options.dense_output else {}),
        }

    def _nearness(self) -> float:
        """Return how near the projected constraints came to losing rank."""
        seen = self.seen
        return float(seen[at.NEARNESS]) if seen.size and seen[at.RANK] else 1.0

    def _extension(self) -> Extension | None:
        rows = self.kept_steps()
        if self.code not in (Outcome.FINISHED, Outcome.TERMINATED, Outcome.EVENTS_ACCUMULATE):
            return None
        if rows is None or not len(rows):
            return None
        return Extension(Twin(self), rows, self.n, self.backward)

    def _state_name(self, k: int) -> str:
        names = () if self.call is None else self.call.names()
        return names[k] if k < len(names) else f"x[{k}]"

    def _check_scales(self) -> None:
        """Refuse states that are zero where `atol` is zero too: their errors have no scale."""
        memory, n = self.memory, self.n
        x, atol, slopes = memory.x[:n], memory.atol[:n], memory.stages[:n]
        places = np.flatnonzero((x == 0.0) & (atol <= LEAST_TOLERANCE) & (slopes != 0.0))
        if places.size and np.isfinite(slopes).all():
            names = ", ".join(self._state_name(k) for k in places[: self.states][:4])
            self._stop(
                Outcome.TOLERANCE_TOO_SMALL,
                rtol=memory.rtol[places[0]],
                atol=0.0,
                advice=f"Errors of states that are 0, of {names}, are compared with `atol` alone: "
                "pass one above 0.",
            )

    def _fail(self, code: int) -> None:
        """Raise the error for a code with which compiled code gave up."""
        if not np.isfinite(self._x0).all():
            raise ValueError(f"`x0` must be finite, got {self._x0}.")
        if code == Outcome.EVENT_UNDEFINED and (wanted := self.options.events) is not None:
            self._stop(code, event=wanted.names[self.watch.fired.argmax()])
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
        nearness, rows, determinacy = self._combined(self.memory.x[: self.n].copy(), t)
        what = Outcome(code).text.format(**details)
        if nearness < NEARLY_SINGULAR:
            self._stop(Outcome.SINGULAR_CONFIGURATION, rows=rows, what=what)
        if determinacy < NEARLY_SINGULAR:
            self._stop(Outcome.SPEEDS_NOT_GIVEN, what=what)
        self._stop(code, **details)

    @property
    def status(self) -> str:
        """How the latest run ended, in words."""
        return Outcome(self.code).text.format(**self.details)

    def _end(self, code: int, **details: Any) -> None:
        """Note how the run ended."""
        self.code, self.details = int(code), details

    def _stop(
        self,
        code: int,
        kind: type[IntegrationError] | type[IntegrationInterrupted] = IntegrationError,
        **details: Any,
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
        """Return the times that were reached, and the states there."""
        reached = int(self.progress.counts[at.NEXT])
        times = self._reported(self.progress.times[:reached].copy())
        return times, self._rows[:reached, : self.states].copy()
