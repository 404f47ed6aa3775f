"""Motions that stay at a jump of the loads, as dry friction `sign(v)` holds a block at rest.

Where both sides of a jump drive a motion back to it, no step is short enough: a solver goes on in
ever shorter steps. That is looked for where one gives up, or takes very many steps.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pydy._judges.discontinuities import Discontinuities
from pydy._names import few
from pydy._problem import StateSamples
from pydy._rank import DIGITS

_BEYOND = 100.0  # how far beyond a jump the other side is looked at, in units of how far it is


def stuck_at(at: StateSamples, span: float) -> str | None:
    """Describe the jump at which a motion stays at one state, or return None.

    It comes to that jump within six digits of the whole `span` of time, which is negative where the
    motion runs backward.
    """
    equations, states = at.definition.equations, at.definition.states
    n = len(states)
    found = at.interpret(Discontinuities(len(equations.coordinates)))
    values = found["switches"][0]
    if not values.size or not np.isfinite(at.x).all():
        return None
    slopes = found["slopes"][0].reshape(values.size, -1)[:, :n]
    steps = np.abs(found["steps"][0].reshape(values.size, -1))
    rates = at.model.compiled("rates")
    best: tuple[float, int, np.ndarray] | None = None
    for k, (value, row) in enumerate(zip(values, slopes, strict=True)):
        square = float(row @ row)
        if not steps[k].any() or not (np.isfinite(row).all() and square > 0.0):
            continue
        # The nearest states on both sides.
        sizes = np.abs(row) @ np.abs(at.x[0])
        beside = _BEYOND * max(abs(value), np.finfo(float).eps * sizes, np.finfo(float).tiny)
        x = at.x[0] + np.outer(np.array([beside, -beside]) - value, row) / square
        both = replace(at, t=np.repeat(at.t, 2), x=x, r=np.repeat(at.r[:1], 2, axis=0))
        own = rates.evaluate(both.t, both.x, both.r, both.p)[0] @ row
        above, below = (own * np.sign(span)).tolist()
        if above < 0.0 < below:
            time = abs(value) / min(-above, below)
            if time <= DIGITS * abs(span) and (best is None or time < best[0]):
                best = time, k, np.array([above, below])
    if best is None:
        return None
    _, k, (above, below) = best
    moved = [str(s) for s, slope in zip(states, slopes[k], strict=True) if slope]
    place = (
        f"`{moved[0]}` passes zero"
        if len(moved) == 1
        else f"a condition on {few(moved, 4, ', ')} turns"
    )
    row = int(steps[k].argmax())
    own = [s for j, s in enumerate(states) if j == row]
    what = f"the {'load on' if own and own[0] in equations.speeds else 'rate of'} {own[0]}"
    what = what if own else "a load"
    return (
        f"There {what} jumps where {place}, and both sides drive the motion back to the jump (at "
        f"{above:.3g} and {below:.3g} a second): it stays there, as a body held by dry friction "
        "does, and no step is short enough. Smooth the jump, as the laws of friction of "
        "`pydy.contact` do, or let `pydy.contact.Contacts` hold what sticks."
    )
