"""What a motion with contacts is looked at for again: no number that is wrong is returned."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Any

import numpy as np

from pydy._checks import shown
from pydy._interpolation import evenly
from pydy._judges import diagnosis_of
from pydy._motion import Motion
from pydy._rank import ROUNDING
from pydy.contact.decide import OPEN, SLIDES, STICKS
from pydy.contact.modes import margin_symbol
from pydy.contact.tuning import CHECKED, SLACK


def missed(
    run: Any,
    motion: Motion,
    places: Mapping[Any, int],
    resting: Collection[int],
    end: float,
    last: np.ndarray | None,
    told: Collection[tuple[str, int]],
) -> list[tuple[str, int]]:
    """Refuse a motion in one mode in which a transition was missed.

    The `places` are those of the mode's outputs. Return what is violated from the start on: forces
    at their limits fit several modes there, and so do directions of what is `resting`, and only the
    motion tells which of them hold. What is `told` by the events at the end, where a load may jump,
    is not missed there.
    """
    symbols = run.kept.symbols
    known, few = motion.times < end, motion.times[:0]
    last = motion.states[-1] if last is None else last[: run.n]  # not what follows from the event
    rows = [motion.states[known], last[None]]
    if motion.dense is not None:  # not more steps than are kept
        starts, few = motion.dense.starts, np.linspace(motion.times[0], end, CHECKED)
        if len(starts) > CHECKED:  # states between steps take these again
            few = starts[evenly(len(starts), CHECKED)]
        few = few[few < end]
        rows.insert(1, motion.dense(few)[:, : run.n])
    few, states = np.concatenate([motion.times[known], few, [end]]), np.concatenate(rows)
    table = motion.problem.at(few, states).outputs()
    least = table.min(axis=0)
    broken = []
    for i, c in enumerate(run.contacts):
        if run.modes[i] == OPEN and i in run.rows.cuts:
            _check_cuts(run, i, few, states)
        if run.modes[i] == OPEN and least[places[symbols[i, "gap"]]] >= 0.0:
            continue
        for symbol, slack, kind, words in _limits(run, i, i in resting):
            place = places[symbol]
            values = table[:, place] * (-1.0 if words[:5] == "power" else 1.0)
            allowed = SLACK * np.abs(values).max(initial=0.0) + slack
            below = values < -allowed
            below[-1:] &= (kind, i) not in told
            if below.any() and symbol is symbols.get((i, "gap")):
                # What the drift of a gap that was held has left is no motion of this motion.
                below &= values < values[0] - allowed
                # In large units the relative tolerance tells less of a gap than the other.
                worst = int(values.argmin())
                p = run.numbers(float(few[worst]), states[worst])
                late = run.resolution(float(few[worst])) * abs(p.speed[run.rows.normal[i]])
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


def _check_cuts(run: Any, i: int, times: np.ndarray, states: np.ndarray) -> None:
    """Refuse a gap that jumps on the way, as an angle does where atan2 goes from π to −π."""
    order = np.argsort(times, kind="stable")
    times, states = times[order], states[order]
    values = dict(run.values(float(times[0]), states[0]))
    values |= zip(run.now.definition.states, states.T, strict=True)
    values[run.now.definition.equations.time] = times
    inputs = {node: values.get(symbol, 0.0) for node, symbol in run.rows.symbols.items()}
    for f, evaluate in run.rows.cuts[i]:
        y, x, gap, more, less = evaluate(inputs, len(times)).T
        through = (np.signbit(y[1:]) != np.signbit(y[:-1])) & (np.maximum(x[1:], x[:-1]) < 0.0)
        on = np.where(np.signbit(y[:-1]), less[1:], more[1:])  # as it would go on
        size = np.maximum(np.abs(gap[1:]), np.abs(on))
        for k in np.flatnonzero(through & (np.abs(on - gap[1:]) > SLACK * size)):
            raise run.fail(
                float(times[k + 1]), states[k + 1],
                f"The gap of {run.contacts[i].name!r} jumped to {gap[k + 1]:.6g}, and would have "
                f"gone on to {on[k]:.6g}: `{shown(f)}` jumps by 2π where the angle is π. Turn the "
                "angle so that the motion does not come there, as atan2(-y, -x) + pi is of "
                "atan2(y, x), or use a coordinate that counts turns.",
            )  # fmt: skip


def flat(run: Any, t: float, x: np.ndarray, some: Collection[int]) -> str:
    """Say which of some closed gaps has no slope there, such as q² at q = 0, or no mass; or ''.

    Its slope changes as much as it is within the roundings of the gap and of the time of closing.
    """
    p = run.numbers(t, x)
    for i in some:
        normal = run.rows.normal[i]
        own = p.square[normal, normal]
        if not np.isfinite(own):
            cause = diagnosis_of(run.now.at(np.array([t]), x[None]))
            return (
                f"The force that closes the gap of {run.contacts[i].name!r} cannot be computed. "
                f"{cause or 'Check that no mass or inertia of the bodies there is zero.'}"
            )
        step = np.zeros(run.first)
        if own > 0.0:
            least = ROUNDING * p.near[i] + abs(p.speed[normal]) * run.resolution(t)
            step = p.kinematics @ p.moves[:, normal] * (least / own)
        for way in (step, -step):
            beside = x.copy()
            beside[: run.first] += way
            other = run.numbers(t, beside).square[normal, normal]
            if not own / 4.0 < other < 4.0 * own:
                return (
                    f"The gap of {run.contacts[i].name!r} has no slope where it closes: no speed "
                    "changes it there, so that it has no normal force and no impact. Write a gap "
                    "that changes as a distance does, such as q in place of q**2 or q**3, and a "
                    "stop at a dead centre as a limit of the crank's angle."
                )
    return ""


def _limits(run: Any, i: int, resting: bool) -> Iterator[tuple[Any, float, str, str]]:
    """Yield symbols that must not be negative in a contact's mode, by which slack, and as what."""
    c, own, symbols, size = run.contacts[i], run.modes[i], run.kept.symbols, run.sizes[i]
    if c.unilateral is None:
        yield symbols[i, "normal"], SLACK * size, "", "`normal`"
    if own in SLIDES:
        kind = "turns" if resting else ""
        yield symbols[i, "power"], run.unresolved(i) * size, kind, "power of friction"
    if own == STICKS:
        yield margin_symbol(c), 2.0 * SLACK * size**2, "slips", "margin of friction, squared,"
    if c.unilateral is not None and own == OPEN:
        yield symbols[i, "gap"], float(np.max(run.atol)), "", "gap"
    elif c.unilateral is not None:
        yield symbols[i, "normal"], SLACK * size, "opens", "normal force"
