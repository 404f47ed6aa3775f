"""How large each unknown becomes: the units in which a program is solved."""

from __future__ import annotations

import numpy as np

from pydy._rank import or_one
from pydy.control.transcription import Transcription

__all__ = ["sizes_of"]


def sizes_of(
    made: Transcription, z: np.ndarray, lower: np.ndarray, upper: np.ndarray
) -> np.ndarray:
    """Return how large each unknown becomes, by what is known of it.

    That is its guess, its ends and bounds. What is zero everywhere gets the size at which it
    decides one of the equations, whose terms are then of known size: the speed that covers a
    known distance in the duration, the force that brings it about.
    """
    known = [np.where(np.isfinite(v), np.abs(v), 0.0) for v in (z, lower, upper)]
    parts = [made.split(value) for value in known]
    x = np.max([p[0].max(axis=1, where=~made.places[1], initial=0.0) for p in parts], axis=0)
    u = np.max([p[1].max(axis=1, initial=0.0) for p in parts], axis=0)
    c = np.max([p[2] for p in parts], axis=0)
    duration = made.split(z)[3]
    x, u = _inferred(made, z, x, u)
    slopes = np.where(made.places[1], 1.0 / duration, 1.0)
    return made.joined(
        x[:, None] * slopes, np.repeat(u[:, None], len(made.control_places), 1), or_one(c),
        duration,
    )  # fmt: skip


def _inferred(
    made: Transcription, z: np.ndarray, x: np.ndarray, u: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return sizes of states and controls where zeros are found from the equations."""
    sizes = np.concatenate([x, u])
    if (sizes > 0.0).all():
        return x, u
    # The equations of a single interval: its derivatives are changes in the whole duration.
    whole = Transcription(made.problem, made.scheme, np.array([0.0, 1.0]))
    times = [whole.places[0], whole.control_places]
    _, _, constants, duration = made.split(z)
    states = np.where(whole.places[1], 0.0, made.states_at(z, times[0] * duration).T)
    controls = np.zeros((made.problem.algebraic, len(times[1])))
    controls[: len(made.problem.controls)] = made.controls_at(z, times[1] * duration).T
    one = whole.joined(states, controls, constants, duration)
    everywhere = np.full(len(one), np.inf)
    nlp = whole.nlp(-everywhere, everywhere, np.ones(len(one)))
    values = np.empty(len(nlp.jacobian_at[0]))
    nlp.jacobian(one, values)
    n, width = made.problem.states, len(sizes)
    owner = np.concatenate([np.repeat(np.arange(n), len(times[0])),
                            n + np.repeat(np.arange(width - n), len(times[1]))])  # fmt: skip
    owner = np.append(owner, np.full(len(one) - len(owner), width))
    slope = np.tile(whole.places[1], n)
    table = np.zeros((nlp.rows, width + 1))
    rows, columns = nlp.jacobian_at
    weights = np.ones(len(one))
    weights[: len(slope)][slope] = 1.0 / duration
    entries = np.abs(np.nan_to_num(values)) * weights[columns]
    np.maximum.at(table, (rows, owner[columns]), entries)
    table = table[:, :width]
    for _ in range(width):
        reach = (table * sizes).max(axis=1, initial=0.0)
        need = np.where((table > 0.0) & (reach[:, None] > 0.0),
                        reach[:, None] / np.where(table > 0.0, table, 1.0), np.inf)  # fmt: skip
        found = need.min(axis=0, initial=np.inf)
        new = (sizes == 0.0) & np.isfinite(found)
        if not new.any():
            break
        sizes = np.where(new, found, sizes)
    sizes = or_one(sizes)
    return sizes[:n], sizes[n:]
