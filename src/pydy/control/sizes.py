"""How large each unknown becomes: the units in which a program is solved."""

from __future__ import annotations

import numpy as np

from pydy._rank import or_one
from pydy.control.transcription import Transcription
from pydy.control.tuning import NARROW, TOLERANCE, WIDE


def sizes_of(
    made: Transcription, z: np.ndarray, lower: np.ndarray, upper: np.ndarray
) -> np.ndarray:
    """Return how large each unknown becomes, by what is known of it.

    That is its guess, its ends and bounds. What is zero everywhere gets the size at which it
    decides one of the equations, whose terms are then of known size: the speed that covers a
    known distance in the duration, the force that brings it about. Bounds that are far wider than
    all else tells are no sizes. A state that moves little, far from zero, is as large as it moves:
    tolerances relative to its distance from zero would let it stay.
    """
    states, first, finite = made.split(z)[0], np.zeros_like(z), np.isfinite
    nodes = states[:, ~made.places[1]]
    low, high, far = nodes.min(axis=1), nodes.max(axis=1), np.abs(nodes).max(axis=1)
    narrow = (low < high) & (high - low < NARROW * far)
    shift = np.where(narrow, 0.5 * (low + high), 0.0)
    made.split(first)[0][:, ~made.places[1]] = shift[:, None]
    known = [np.where(finite(v), np.abs(v - first), 0.0) for v in (z, lower, upper)]
    parts = [made.split(value) for value in known]
    # The rounding of what is that far from zero must be below the tolerance.
    least = np.where(narrow, 8 * np.finfo(float).eps / TOLERANCE * far, 0.0)
    x = np.array([p[0].max(axis=1, where=~made.places[1], initial=0.0) for p in parts])
    u = np.array([p[1].max(axis=1, initial=0.0) for p in parts])
    c = np.array([p[2] for p in parts])
    x[0] = np.maximum(x[0], least)
    duration = made.split(z)[3]
    xu, n = np.concatenate([x, u], axis=1), x.shape[1]
    if (xu[1:] > WIDE * xu[0]).any() or not xu.any(axis=0).all():
        table = _slopes(made, z, xu.shape[1])
        _leave_out_wide(xu, _spread(table, xu[0]))
        sizes = _spread(table, xu.max(axis=0))
    else:
        sizes = xu.max(axis=0)
    _leave_out_wide(c, c[0])
    x, u, c = or_one(sizes[:n]), or_one(sizes[n:]), c.max(axis=0)
    slopes = np.where(made.places[1], 1.0 / duration, 1.0)
    return made.joined(
        x[:, None] * slopes, np.repeat(u[:, None], len(made.control_places), 1), or_one(c),
        duration,
    )  # fmt: skip


def _leave_out_wide(sizes: np.ndarray, told: np.ndarray) -> None:
    """Let bounds, the second and third row, be none where they are far wider than what is told."""
    sizes[1:][(sizes[1:] > WIDE * told) & (told > 0.0)] = 0.0


def _slopes(made: Transcription, z: np.ndarray, width: int) -> np.ndarray:
    """Return how much each equation changes with each state and control, shape (rows, width)."""
    # The equations of a single interval: its derivatives are changes in the whole duration.
    whole = Transcription(made.problem, made.scheme, np.array([0.0, 1.0]))
    times = [whole.places[0], whole.control_places]
    _, _, constants, duration = made.split(z)
    # Along the motion, and as if it stayed where it begins or ends: in its middle alone an arm may
    # be level, where its weight has a torque that no turn changes, but for rounding.
    count = sum(whole.sizes)
    nlp = whole.nlp(np.full(count, -np.inf), np.full(count, np.inf), np.ones(count))
    values = np.zeros(len(nlp.jacobian_at[0]))
    for along in (times, *([0 * t + end for t in times] for end in (0.0, 1.0))):
        states = np.where(whole.places[1], 0.0, made.states_at(z, along[0] * duration).T)
        controls = np.zeros((made.problem.algebraic, len(times[1])))
        controls[: len(made.problem.controls)] = made.controls_at(z, along[1] * duration).T
        at = whole.joined(states, controls, constants, duration)
        found = nlp.native("jacobian", at)[0]
        np.maximum(values, np.abs(np.nan_to_num(found)), out=values)
    n = made.problem.states
    owner = np.concatenate([np.repeat(np.arange(n), len(times[0])),
                            n + np.repeat(np.arange(width - n), len(times[1]))])  # fmt: skip
    owner = np.append(owner, np.full(count - len(owner), width))
    slope = np.tile(whole.places[1], n)
    table = np.zeros((nlp.rows, width + 1))
    rows, columns = nlp.jacobian_at
    weights = np.ones(count)
    weights[: len(slope)][slope] = 1.0 / duration
    entries = values * weights[columns]
    np.maximum.at(table, (rows, owner[columns]), entries)
    return table[:, :width]


def _spread(table: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Return sizes of states and controls where zeros are found from the equations, or stay."""
    for _ in range(len(sizes)):
        reach = (table * sizes).max(axis=1, initial=0.0)
        need = np.where((table > 0.0) & (reach[:, None] > 0.0),
                        reach[:, None] / np.where(table > 0.0, table, 1.0), np.inf)  # fmt: skip
        found = need.min(axis=0, initial=np.inf)
        new = (sizes == 0.0) & np.isfinite(found)
        if not new.any():
            break
        sizes = np.where(new, found, sizes)
    return sizes
