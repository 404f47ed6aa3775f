"""Which independent speeds move a mechanism in nearly the same way at many states.

Where dependent speeds hardly follow from the constraints, the motion that they are most of is that
of several independent speeds, and their part of the mass matrix is nearly singular. Forms are
chosen by how often that is so at random states; what is chosen holds everywhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np

from pydy._graph.interpret import evaluator
from pydy._graph.node import Graph
from pydy._mechanics.tuning import (
    GUARDED_UP_TO,
    LARGE_PART,
    LESS_OFTEN,
    NEARLY_DEPENDENT,
    OFTEN,
    SOUND_PIVOT,
    SOUND_SHARE,
)

__all__ = ["Spread", "definite", "nearly_parallel"]

_STATES = 512
# Of states, time, specifieds and constants: those differ from state to state too.
_RANGES = {"x": (-1.0, 1.0), "t": (0.0, 1.0), "r": (0.5, 1.5), "p": (0.5, 1.5)}


class Spread(NamedTuple):
    """What is done about motions that are nearly parallel.

    Attributes
    ----------
    apart : list of int
        The independent speeds to take apart from one another.
    loose : set of int
        The dependent speeds, of d, that these motions mostly consist of.
    """

    apart: list[int]
    loose: set[int]


def nearly_parallel(
    graph: Graph, matrix: Sequence[Sequence[int]], rows: Sequence[Sequence[int]]
) -> Spread:
    """Return which independent speeds are to be taken apart from one another.

    Parameters
    ----------
    graph : Graph
    matrix : n lists of n nodes
        M.
    rows : d lists of n nodes
        The constraints K u' + b = 0, which give the last d speeds.
    """
    n, d = len(matrix), len(rows)
    p = n - d
    none = Spread([], set())
    if not 1 < p <= GUARDED_UP_TO:
        return none
    values = _at_states(graph, [*(e for row in matrix for e in row), *(e for r in rows for e in r)])
    if values is None:
        return none
    masses = values[:, : n * n].reshape(-1, n, n)
    held = values[:, n * n :].reshape(-1, d, n)
    with np.errstate(all="ignore"):
        try:
            given = np.linalg.solve(held[:, :, p:], -held[:, :, :p])
        except np.linalg.LinAlgError:
            return none
        unit = np.broadcast_to(np.eye(p), (len(values), p, p))
        moves = np.concatenate([unit, given], axis=1)
        square = np.swapaxes(moves, 1, 2) @ masses @ moves
        found: list[int] = []
        share = _weak(square, found)
        while share > OFTEN and len(found) < p:
            # Two at first: one by itself changes nothing.
            tried = [
                [*found, *more]
                for more in combinations([k for k in range(p) if k not in found], 1 if found else 2)
            ]
            shares = [_weak(square, some) for some in tried]
            if min(shares) > LESS_OFTEN * share:
                break
            share, found = min(zip(shares, tried, strict=True))
        weights = np.diagonal(masses, axis1=1, axis2=2)
        sizes = np.diagonal(square, axis1=1, axis2=2)[:, found]
        part = weights[:, p:, None] * given[:, :, found] ** 2 / sizes[:, None, :]
        large = (part > LARGE_PART) & (weights[:, None, found] < SOUND_PIVOT * sizes[:, None, :])
        loose = np.flatnonzero(large.any(axis=2).any(axis=0))
    return Spread(sorted(found), {int(k) for k in loose})


def definite(graph: Graph, matrix: Sequence[Sequence[int]]) -> bool:
    """Return whether every motion moves a mass at most states, as far as floats tell.

    Coefficients that are no binary fractions leave rounding errors of a singular matrix.
    """
    n = len(matrix)
    values = _at_states(graph, [e for row in matrix for e in row])
    if values is None or not len(values):
        return False
    masses = values.reshape(-1, n, n)
    own = np.sqrt(np.abs(np.diagonal(masses, axis1=1, axis2=2)))
    own[own == 0.0] = 1.0
    shares = masses / (own[:, :, None] * own[:, None, :])
    least = np.linalg.svd(shares, compute_uv=False)[:, -1]
    return bool(np.median(least) > NEARLY_DEPENDENT[0])


def _weak(square: np.ndarray, apart: Sequence[int]) -> float:
    """Return at which share of states a pivot is small if some directions are made orthogonal."""
    work = square.copy()
    for place, i in enumerate(apart):
        for j in apart[place + 1 :]:
            ratio = (work[:, i, j] / work[:, i, i])[:, None]
            work[:, j] -= ratio * work[:, i]
            work[:, :, j] -= ratio * work[:, :, i]
            work[:, i, j] = work[:, j, i] = 0.0
    sizes = np.diagonal(work, axis1=1, axis2=2).copy()
    least = np.ones(len(work))
    for k in range(work.shape[1]):
        least = np.fmin(least, work[:, k, k] / sizes[:, k])
        work[:, k + 1 :] -= (
            work[:, k + 1 :, k : k + 1] * work[:, k : k + 1] / work[:, k : k + 1, k : k + 1]
        )
    return float(np.mean(least < SOUND_PIVOT * SOUND_SHARE)) if len(work) else 0.0


def _at_states(graph: Graph, nodes: Sequence[int]) -> np.ndarray | None:
    """Return the values of nodes at random states; None where they depend on other things."""
    inputs = [n for n in graph.reachable(nodes) if graph.ops[n] == "input"]
    if not {graph.args[n][0] for n in inputs} <= _RANGES.keys():
        return None
    rng = np.random.default_rng(0)
    at = {n: rng.uniform(*_RANGES[graph.args[n][0]], _STATES) for n in inputs}
    values = evaluator(graph, nodes)(at, _STATES)
    finite: np.ndarray = values[np.isfinite(values).all(axis=1)]
    return finite
