"""Events as they are compiled: what is known of each, and the machine code of all."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from pydy._kernel import Kernel, KernelCall
from pydy.solvers.events import Event, Turn
from pydy.solvers.tuning import CLOSE, HALF, ROUNDING, ROUNDINGS


@dataclass(frozen=True)
class EventTraits:
    """What is known of an event without evaluating it."""

    name: str
    direction: int
    terminal: bool
    resets: bool  # whether the states change at it
    turns: bool  # whether it is a Turn
    constant: bool  # whether it depends on neither state nor time nor specifieds
    linear: bool  # whether it is linear in states and time, and holds no specifieds
    redirects: bool  # whether the rate depends on a state that the reset changes
    may_rest: bool  # whether the expression may be zero all along a stretch, as Max(0, x) is

    @property
    def acts(self) -> bool:
        """Whether the integration stops at it: it ends there, or the states change."""
        return self.terminal or self.resets


@dataclass(frozen=True, eq=False)
class CompiledEvents:
    """Events as Kernels, each of all events."""

    traits: tuple[EventTraits, ...]
    values: Kernel  # the expressions
    rates: Kernel  # their time derivatives along the motion, and bounds on their roundings
    # Expressions, and how far they may come from these in a step (`Watch.reach`); of a Turn, those
    # of the event before it. None where that is not known of all.
    reach: Kernel | None
    resets: Kernel | None  # the states after each event, one below the other; None: no event resets
    sources: tuple[Event, ...] = ()  # what they were compiled from
    # What changing specifieds add to the rates; their time derivatives follow them in r. None: no
    # expression holds specifieds.
    input_rates: Kernel | None = None

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the events."""
        return tuple(event.name for event in self.traits)

    def rates_at(self, call: KernelCall, x: np.ndarray, t: float, span: float = 0.0) -> np.ndarray:
        """Return the time derivatives of the expressions just after t, then their bounds.

        Specifieds that are samples or Python functions change too. Differences of functions need
        the `span` of the motion.
        """
        rates = call.evaluate(self.rates, x, t)
        if self.input_rates is None or call.inputs.constant:
            return rates
        n, both, _ = self.input_rates.program.signature.sizes
        s, slopes = both // 2, call.input_slopes(x, t, _difference_step(t, span))
        r = np.concatenate([call.inputs(x, t)[:s], slopes[:s]])
        added = self.input_rates.evaluate(np.array([t]), x[None, :n], r[None], call.p)[0][0]
        rates[: len(added)] += added
        return rates

    def rate_rounding(self, call: KernelCall, bound: float, t: float, span: float) -> float:
        """Return the rounding of a rate by differences, from the bound on that of its value."""
        if self.input_rates is None or not call.inputs.functions:
            return 0.0
        return ROUNDINGS * ROUNDING * bound / _difference_step(t, span)

    @staticmethod
    def key(events: Any) -> list[tuple[Event, dict[Any, Any]]] | None:
        """Return a key that identifies a user's events, even if a reset is edited in place.

        None if they come from an iterator, which reading would exhaust.
        """
        several = [events] if isinstance(events, Event) else events
        if type(several) not in (list, tuple) or {*map(type, several)} - {Event, Turn}:
            return None
        return [(event, dict(event.reset)) for event in several]

    def zero_interval_warnings(self, intervals: np.ndarray, span: float) -> list[str]:
        """Return warnings of expressions that stayed at zero, from ``Watch.rests`` and a span."""
        warnings = []
        for k, event in enumerate(self.traits):
            if not event.may_rest:
                continue
            first, last = intervals[2 * k : 2 * k + 2].tolist()
            # A shorter interval may be rounding.
            if first < last and last - first <= CLOSE**2 * max(abs(last), span):
                continue
            if first <= last:  # neither is NaN
                when = f"from t = {first:.6g} to {last:.6g}, at least"
                when = f"at and beside t = {first:.6g}" if first == last else when
                warnings.append(
                    f"The expression of the event `{event.name}` is exactly zero {when}: there "
                    "no sign tells when the event happens, and its times are arbitrary. Pass an "
                    "expression that passes through zero, such as `x` in place of `Max(0, x)`."
                )
        return warnings

    def forcing_time(self, call: KernelCall, event: int, x: np.ndarray, t: float) -> float | None:
        """Return the time of the sample or switch whose jump makes an event happen, or None.

        The expression then does not pass through zero: its sign differs before and after the jump,
        and the event's time depends on no state. The state x is that before the event, which was
        located at t.
        """
        jumps: dict[float, list[Any]] = {}
        for columns, samples in call.inputs.sampled:
            time = float(samples.breaks[np.abs(samples.breaks - t).argmin()])
            near = abs(time - t) <= ROUNDINGS * ROUNDING * abs(t)
            if samples.interpolation == "previous" and near:
                jumps[time] = [*jumps.get(time, ()), (columns, samples)]
        n, inputs, _ = self.values.program.signature.sizes
        state, r = x[:n], call.inputs(x, t)
        state_twice = np.stack([state, state])
        for time, jumping in jumps.items():
            rows = np.stack([r, r])
            for columns, samples in jumping:
                rows[:, columns] = samples.rows(np.array([np.nextafter(time, -np.inf), time]))
            rows, times = rows[:, :inputs], np.full(2, time)
            values = self.values.evaluate(times, state_twice, rows, call.p)[0][:, event]
            if values[0] * values[1] < 0.0:
                return time
        reach = ROUNDINGS * ROUNDING * abs(t)
        switched = () if call.switched is None else call.switched
        for _, earlier, later in (row for row in switched if abs(row[0] - t) <= reach):
            times = np.array([earlier, later])
            rows = np.stack([call.inputs(x, time)[:inputs] for time in times])
            values = self.values.evaluate(times, state_twice, rows, call.p)[0][:, event]
            if values[0] * values[1] < 0.0:
                return float(later)
        return None

    def value_after_jump(
        self, call: KernelCall, event: int, x: np.ndarray, t: float, error: float
    ) -> float | None:
        """Return the value of an event's expression where it happens, or None if that is zero.

        Zero means: within the resolution of time and expression, and the `error` that the
        tolerances of the states allow; else the expression has jumped.
        """
        # Without the span of the motion: sensitivities, which ask for this, refuse functions.
        rates_and_bounds = self.rates_at(call, x, t)
        value = float(call.evaluate(self.values, x, t)[event])
        rate, bound = map(float, rates_and_bounds[[event, len(self.traits) + event]])
        time = ROUNDINGS * ROUNDING * abs(t) * abs(rate)
        rounding = ROUNDINGS * ROUNDING * bound
        return value if CLOSE * abs(value) > time + rounding + error else None


def _difference_step(t: float, span: float) -> float:
    """Return the step of differences of functions: half of the digits of the motion's span.

    At least a rounding of the time. Over half of the digits, roundings and curvature weigh alike.
    """
    return HALF * max(span, HALF * abs(t))
