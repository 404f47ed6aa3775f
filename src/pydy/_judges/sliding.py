"""Detect motions that stay at a jump of the loads, as dry friction `sign(v)` holds a block at rest.

If both sides of a jump drive a motion back to it (a sliding mode), the solver's steps shrink
without end. This is tested when a solver gives up, or takes very many steps.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pydy._judges.discontinuities import Discontinuities
from pydy._names import few
from pydy._problem import StateSamples
from pydy._rank import DIGITS

_SIDE_DISTANCE = 100.0  # where both sides of a jump are evaluated, in distances from the state


def stuck_at(at: StateSamples, span: float) -> str | None:
    """Describe the jump at which a motion stays from a state on, or return None.

    The motion must reach that jump within 1e-6 of the time `span`, which is negative if the motion
    runs backward.
    """
    equations, states = at.definition.equations, at.definition.states
    n = len(states)
    blocks = at.interpret(Discontinuities(len(equations.coordinates)))
    switches = blocks["switches"][0]
    if not switches.size or not np.isfinite(at.x).all():
        return None
    slopes = blocks["slopes"][0].reshape(switches.size, -1)[:, :n]
    steps = np.abs(blocks["steps"][0].reshape(switches.size, -1))
    rates = at.model.compiled("rates")
    best: tuple[float, int, np.ndarray] | None = None
    for k, (value, row) in enumerate(zip(switches, slopes, strict=True)):
        square = float(row @ row)
        if not steps[k].any() or not (np.isfinite(row).all() and square > 0.0):
            continue
        # The nearest states on both sides.
        sizes = np.abs(row) @ np.abs(at.x[0])
        distance = _SIDE_DISTANCE * max(
            abs(value), np.finfo(float).eps * sizes, np.finfo(float).tiny
        )
        x = at.x[0] + np.outer(np.array([distance, -distance]) - value, row) / square
        both_sides = replace(at, t=np.repeat(at.t, 2), x=x, r=np.repeat(at.r[:1], 2, axis=0))
        switch_rates = (
            rates.evaluate(both_sides.t, both_sides.x, both_sides.r, both_sides.p)[0] @ row
        )
        above, below = (switch_rates * np.sign(span)).tolist()
        if above < 0.0 < below:
            time = abs(value) / min(-above, below)
            if time <= DIGITS * abs(span) and (best is None or time < best[0]):
                best = time, k, np.array([above, below])
    if best is None:
        return None
    _, k, (above, below) = best
    moved = [str(s) for s, slope in zip(states, slopes[k], strict=True) if slope]
    condition = (
        f"`{moved[0]}` passes zero"
        if len(moved) == 1
        else f"a condition on {few(moved, 4, ', ')} turns"
    )
    row = int(steps[k].argmax())
    subject = "a load"
    if row < n:
        kind = "load on" if states[row] in equations.speeds else "rate of"
        subject = f"the {kind} {states[row]}"
    return (
        f"There {subject} jumps where {condition}, and both sides drive the motion back to the "
        f"jump (at {above:.3g} and {below:.3g} a second): it stays there, as a body held by dry "
        "friction does, and no step is short enough. Smooth the jump, as the laws of friction of "
        "`pydy.contact` do, or let `pydy.contact.Contacts` compute when it sticks."
    )
