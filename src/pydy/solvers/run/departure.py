"""The side of zero to which the expression of an event departs from a state where it is zero.

The rule is: by its first derivative that is not zero. ``core/departure.h`` is the same in C, which
exported units share, and ``export/templates/integrator.js`` in JavaScript. The table of cases that
all of them satisfy is ``tests/oracles/departures.py``.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from pydy._kernel import KernelCall
from pydy.solvers.compiled_events import CompiledEvents
from pydy.solvers.tuning import HALVINGS, LOW, ROUNDING, ROUNDINGS


def on_surface(values: Any, bounds: Any) -> Any:
    """Return which expressions, numbers or arrays, are zero within `bounds` on their roundings."""
    return (abs(values) <= ROUNDINGS * ROUNDING * bounds) | (values == 0.0)


def is_stationary(
    call: KernelCall, events: CompiledEvents, event: int, x: np.ndarray, t: float, span: float
) -> bool:
    """Return whether the rate of an event's expression is zero within the roundings of the states.

    The changes of the rate due to a rounding of each state are added up.
    """
    rates = events.rates_at(call, x, t, span)
    rate, bound = map(float, rates[[event, len(events.traits) + event]])
    if rate == 0.0:
        return True
    total = events.rate_rounding(call, bound, t, span)
    for i in np.flatnonzero(x[: events.rates.program.signature.num_states]).tolist():
        shifted = x.copy()
        shifted[i] += ROUNDINGS * ROUNDING * x[i]
        total += abs(float(events.rates_at(call, shifted, t, span)[event]) - rate)
    return abs(rate) <= total


def departure(
    call: KernelCall, events: CompiledEvents, event: int, x: np.ndarray, t: float, span: float
) -> int:
    """Return the sign of an event's expression just after t: −1, 1, or 0 if it stays zero.

    It is that of the rate, or where that is zero the `resolved_side`.
    """
    if not is_stationary(call, events, event, x, t, span):
        rate = float(events.rates_at(call, x, t, span)[event])
        return int(np.sign(rate)) if np.isfinite(rate) else 0
    return resolved_side(call, events, event, x, t, span)


def resolved_side(
    call: KernelCall, events: CompiledEvents, event: int, x: np.ndarray, t: float, span: float
) -> int:
    """Return the sign that an event's expression has where it first exceeds its roundings, or 0.

    One step of the classical Runge–Kutta method decides, the shortest of 52 sizes, each double the
    previous one. Its error is of fifth order, so that derivatives up to the fourth count.
    """
    k, size = len(events.traits), span * 0.5**HALVINGS
    with np.errstate(all="ignore"):
        for _ in range(HALVINGS):
            a = call(x, t)
            b = call(x + 0.5 * size * a, t + 0.5 * size)
            c = call(x + 0.5 * size * b, t + 0.5 * size)
            d = call(x + size * c, t + size)
            after = x + size / 6.0 * (a + 2.0 * b + 2.0 * c + d)
            value = float(call.evaluate(events.values, after, t + size)[event])
            bound = float(call.evaluate(events.rates, after, t + size)[k + event])
            if abs(value) > ROUNDINGS * ROUNDING * bound:
                return 1 if value > 0.0 else -1
            size *= 2.0
    return 0


def is_unresolved(
    call: KernelCall,
    events: CompiledEvents,
    event: int,
    x: np.ndarray,
    t: float,
    span: float,
    side: int,
    flight: float,
) -> bool:
    """Return whether the rate after a reset does not decide to which side the motion departs.

    The rate is zero, or the expression returns from the `side` that the rate has chosen before it
    exceeds its rounding errors. Such a crossing is a rounding error itself, and the reset may lead
    to the other side of the surface. `flight` is the time since the previous event.
    """
    if is_stationary(call, events, event, x, t, span):
        return True
    rates = events.rates_at(call, x, t, span)
    rate, bound = map(float, rates[[event, len(events.traits) + event]])
    if not abs(rate) * flight <= LOW * ROUNDINGS * ROUNDING * bound:
        return False
    return resolved_side(call, events, event, x, t, span) == -side != 0


def follows_itself(side: int, origin: int, direction: int) -> bool:
    """Return whether an event that has acted at rest on its surface happens again at once.

    It does if the motion departs to the `side` of its direction. An event without a direction does
    only at the start of a motion, where the `origin` is 0: a motion that came from a side passes
    through, like a ball that is caught in the air and released.
    """
    return side != 0 and (direction == side or direction == origin == 0)


def happens_at_start(side: int, direction: int) -> bool:
    """Return whether an event on whose surface a motion starts happens there."""
    return side != 0 and direction in (0, side)


def acts_at_start(side: int, direction: int, stationary: bool) -> bool:
    """Return whether such an event also acts there.

    Without a direction the start counts as the state after the event, unless the motion is at rest.
    """
    return happens_at_start(side, direction) and (direction != 0 or stationary)
