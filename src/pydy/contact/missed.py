"""What a motion with contacts is looked at for again: no number that is wrong is returned."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np

from pydy.contact.decide import OPEN, SLIDES, STICKS
from pydy.contact.modes import margin_symbol
from pydy.contact.tuning import CHECKED, SLACK


def missed(
    run: Any,
    part: Any,
    resting: Collection[int],
    end: float,
    last: np.ndarray | None,
    told: Collection[tuple[str, int]],
) -> list[tuple[str, int]]:
    """Refuse a part of a motion in which a transition was missed.

    Return what is violated from the start on: forces at their limits fit several modes there, and
    so do directions of what is `resting`, and only the motion tells which of them hold. What is
    `told` by the events at the end, where a load may jump, is not missed there.
    """
    symbols, places = run.kept.symbols, part.mode.places
    known, few = part.times < end, part.times[:0]
    last = part.states[-1] if last is None else last[: run.n]  # not what follows from the event
    rows = [part.states[known], last[None]]
    if part.dense is not None:  # not more steps than are kept
        starts, few = part.dense.starts, np.linspace(part.times[0], end, CHECKED)
        if len(starts) > CHECKED:  # states between steps take these again
            few = starts[np.linspace(0, len(starts) - 1, CHECKED).astype(int)]
        few = few[few < end]
        rows.insert(1, part.dense(few)[:, : run.n])
    few, states = np.concatenate([part.times[known], few, [end]]), np.concatenate(rows)
    table = part.now.outputs(few, states)
    least = table.min(axis=0)
    broken = []
    for i, c in enumerate(run.contacts):
        looked: list[tuple[Any, float, str, str]] = []  # symbol, slack, kind, in words
        own = run.modes[i]
        if own == OPEN and least[places[symbols[i, "gap"]]] >= 0.0:
            continue
        if c.unilateral is None:
            looked.append((symbols[i, "normal"], SLACK * run.sizes[i], "", "`normal`"))
        if own in SLIDES:
            slack = run.unresolved(i) * run.sizes[i]
            kind = "turns" if i in resting else ""
            looked.append((symbols[i, "power"], slack, kind, "power of friction"))
        if own == STICKS:
            slack = 2.0 * SLACK * run.sizes[i] ** 2
            looked.append((margin_symbol(c), slack, "slips", "margin of friction, squared,"))
        if c.unilateral is not None and own == OPEN:
            looked.append((symbols[i, "gap"], float(np.max(run.atol)), "", "gap"))
        elif c.unilateral is not None:
            slack = SLACK * run.sizes[i]
            looked.append((symbols[i, "normal"], slack, "opens", "normal force"))
        for symbol, slack, kind, words in looked:
            place = places[symbol]
            values = table[:, place] * (-1.0 if words[:5] == "power" else 1.0)
            allowed = SLACK * np.abs(values).max(initial=0.0) + slack
            below = values < -allowed
            below[-1:] &= (kind, i) not in told
            if below.any() and symbol is symbols.get((i, "gap")):
                # What the drift of a gap that was held has left is no motion of this part.
                below &= values < values[0] - allowed
                # In large units the relative tolerance tells less of a gap than the other.
                worst = int(values.argmin())
                p = run.numbers(float(few[worst]), states[worst])
                late = np.spacing(few[worst]) * abs(p.speed[run.rows.normal[i]])
                below &= values < -run.unresolved_gap(i, p, states[worst]) - late
            if not below.any():
                continue
            earlier = few < few[below].min()
            if kind and values[earlier].max(initial=-np.inf) <= allowed:
                broken.append((kind, i))
                continue
            worst = int(values.argmin())
            remedy = (
                "between two transitions: the solver stepped over one. Limit the step with "
                "`max_step`."
                if words != "`normal`"  # which is given: it has no transitions
                else "during the motion, but must not be negative. Give an expression that is "
                "never negative, such as Max(0, ...), or a Unilateral as `on`, which opens."
            )
            raise run.fail(
                float(few[worst]), states[worst],
                f"The {words} of {c.name!r} became {table[worst, place]:.3g} "
                + remedy,
            )  # fmt: skip
    return broken
