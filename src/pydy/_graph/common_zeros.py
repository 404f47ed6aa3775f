"""Which nodes are zero together, and whether they change their signs alike there.

``exp(−x) − 1`` is zero where x is, and its slope there is −1 times that of x; ``(y − 1) x`` is zero
there, too, and the ratio of the slopes depends on the state. Nodes are evaluated along random lines
through the space of states and specifieds, with random constants. Where one of them changes its
sign, its zero is found to the last digit. Others that are zero at the same number are zero together
with it. Nodes that share isolated points alone, as x and x + y, are not. x² − |x| is zero with x,
too, and does not change its sign.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np

from pydy._graph.inputs import inputs_of
from pydy._graph.node import Graph
from pydy._graph.tuning import (
    BESIDE,
    COMPARED,
    FARTHEST,
    HALVINGS,
    INTERVALS,
    LINES,
    PLACES,
    SAME_ZERO,
    ZEROS,
)
from pydy._rank import DIGITS, ROUNDED

Pairs: TypeAlias = dict[tuple[int, int], float]
Touching: TypeAlias = dict[int, float]
# Returns the values of nodes, shape (samples, nodes), from the lines and the places on these.
_Evaluator: TypeAlias = Callable[[np.ndarray, np.ndarray], np.ndarray]


def common_zeros(graph: Graph, nodes: Sequence[int]) -> tuple[Pairs, Touching]:
    """Return which nodes are zero together.

    Returns
    -------
    pairs : dict
        From nodes i < j that change their signs together to 1.0 if alike, −1.0 if in opposite ways,
        and 0.0 if that may depend on the state or on constants: the ratio of their slopes differs
        from zero to zero.
    touching : dict
        From nodes that do not change their signs where another one does to their sign beside these
        zeros, or 0.0 if it is not the same everywhere.
    """
    random_lines = _RandomLines(graph, nodes)
    far = 2.0 ** np.arange(2, FARTHEST)
    places = np.concatenate([-far[::-1], np.linspace(-2.0, 2.0, PLACES), far])
    lines, at = np.repeat(np.arange(LINES), len(places)), np.tile(places, LINES)
    sampled = random_lines.evaluator(nodes)(lines, at).reshape(LINES, len(places), -1)
    sampled[~np.isfinite(sampled)] = 0.0
    pairs, distinct = _multiples(sampled[:, np.abs(places) <= 2.0].reshape(-1, len(nodes)))
    touching: Touching = {}
    if len(distinct) > 1:
        evaluate = random_lines.evaluator([nodes[k] for k in distinct])
        others, touches = _zeros_of_several(evaluate, sampled[..., distinct], places)
        pairs |= {(distinct[i], distinct[j]): sign for (i, j), sign in others.items()}
        touching = {distinct[i]: sign for i, sign in touches.items()}
    return pairs, touching


class _RandomLines:
    """Lines through the space of states and specifieds, each with other constants and times."""

    def __init__(self, graph: Graph, nodes: Sequence[int]) -> None:
        self._graph, self._inputs = graph, inputs_of(graph, nodes)
        groups = [group for group, _ in self._inputs.values()]
        is_constant = np.array([[group in "pt"] for group in groups], dtype=bool)
        random, shape = np.random.default_rng(0), (len(groups), LINES)
        signs = random.choice([-1.0, 1.0], shape)
        signs[:, ::2] = np.where(is_constant, 1.0, signs[:, ::2])  # as constants usually are
        self._origin = signs * random.uniform(0.5, 1.5, shape)
        self._direction = np.where(is_constant, 0.0, random.uniform(-1.0, 1.0, shape))

    def evaluator(self, nodes: Sequence[int]) -> _Evaluator:
        """Return a function that evaluates nodes at places on lines."""
        evaluate = self._graph.evaluator(nodes)

        def values_at(lines: np.ndarray, places: np.ndarray) -> np.ndarray:
            inputs = self._origin[:, lines] + self._direction[:, lines] * places
            with np.errstate(all="ignore"):
                return evaluate(dict(zip(self._inputs, inputs, strict=True)), len(places))

        return values_at


def _multiples(sampled: np.ndarray) -> tuple[Pairs, list[int]]:
    """Return pairs of nodes that are multiples of one another, and one node of each such group."""
    pairs: Pairs = {}
    distinct: list[int] = []
    few = sampled[:: max(1, len(sampled) // COMPARED)]
    for k in np.flatnonzero(few.any(axis=0)):
        column, others = few[:, [k]], few[:, distinct]
        # Equal up to a factor where x yₙ = xₙ y at all samples n.
        n = np.abs(column).argmax()
        products = np.abs(column * others[n]), np.abs(others * column[n])
        same = np.abs(column * others[n] - others * column[n]) <= ROUNDED * np.maximum(*products)
        multiples = np.flatnonzero(same.all(axis=0))
        if multiples.size:
            first = int(multiples[0])
            pairs[distinct[first], int(k)] = float(np.sign(column[n, 0] * others[n, first]))
        else:
            distinct.append(int(k))
    return pairs, distinct


def _zeros_of_several(
    evaluate: _Evaluator, sampled: np.ndarray, places: np.ndarray
) -> tuple[Pairs, Touching]:
    """Return what `common_zeros` does, of nodes of which none is a multiple of another."""
    line, k, node = _intervals(sampled, places)
    if not line.size:
        return {}, {}
    low, high, was_positive = places[k], places[k + 1], sampled[line, k, node] > 0.0
    beside = BESIDE * np.maximum(np.abs(low), np.abs(high))
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        stays = (evaluate(line, middle)[np.arange(len(line)), node] > 0.0) == was_positive
        low, high = np.where(stays, middle, low), np.where(stays, high, middle)
    before, zero, after = (evaluate(line, low + h) for h in (-beside, 0.0 * beside, beside))
    with np.errstate(all="ignore"):
        size = np.abs(before) + np.abs(after)
        vanishes = np.isfinite(size) & (np.abs(zero) <= SAME_ZERO * size)
        signs = np.sign(before) * np.sign(after)
        slopes = after - before
    ratios: dict[tuple[int, int], list[float]] = {}
    touches: dict[int, set[float]] = {}
    for n, i in enumerate(map(int, node)):
        if not (vanishes[n, i] and signs[n, i] == -1.0):
            continue
        for j in map(int, np.flatnonzero(vanishes[n])):
            if signs[n, j] == 1.0:
                touches.setdefault(j, set()).add(float(np.sign(after[n, j])))
            elif signs[n, j] == -1.0 and j != i:
                a, b = min(i, j), max(i, j)
                ratios.setdefault((a, b), []).append(slopes[n, b] / slopes[n, a])
    pairs: Pairs = {}
    for pair, values in ratios.items():
        is_constant = len(values) > 1 and np.ptp(values) <= DIGITS * np.abs(values[0])
        pairs[pair] = float(np.sign(values[0])) if is_constant else 0.0
    crossing = {k for pair in pairs for k in pair}
    return pairs, {
        j: min(found) if len(found) == 1 and j not in crossing else 0.0
        for j, found in touches.items()
    }


def _intervals(sampled: np.ndarray, places: np.ndarray) -> tuple[np.ndarray, ...]:
    """Return lines, places and nodes of changes of sign, the first of each node on each line."""
    signs = np.sign(sampled)
    changes = signs[:, :-1] * signs[:, 1:] < 0.0
    changes[max(2, INTERVALS // sampled.shape[2]) :] = False  # a few lines for many nodes
    outward = np.abs(places[:-1] + places[1:]).argsort(kind="stable")
    ordered = changes[:, outward]
    line, k, node = np.nonzero(ordered & (ordered.cumsum(axis=1) <= ZEROS))
    return line, outward[k], node
