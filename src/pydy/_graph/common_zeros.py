"""Which nodes are zero together, and whether they change their signs alike there.

``exp(−x) − 1`` is zero where x is, and its slope there is −1 times that of x; ``(y − 1) x`` is zero
there, too, and the ratio of the slopes depends on the state. Nodes are evaluated along random lines
through the space of states and specifieds, with random constants. Where one of them changes its
sign, its zero is found to more than half of the digits. Another node is as small there only if both
are zero together. Nodes that share isolated points alone, as x and x + y, are not zero together.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np

from pydy._graph.inputs import inputs_of
from pydy._graph.node import Graph
from pydy._graph.tuning import BESIDE, HALVINGS, LINES, NEAR, PLACES, SECANTS, ZEROS
from pydy._rank import DIGITS, HALF

Pairs: TypeAlias = dict[tuple[int, int], float]
# Returns the values of nodes, shape (samples, nodes), from the lines and the places on these.
_Evaluator: TypeAlias = Callable[[np.ndarray, np.ndarray], np.ndarray]


def common_zeros(graph: Graph, nodes: Sequence[int]) -> Pairs:
    """Return pairs (i, j), i < j, of nodes that are zero together.

    The values are 1.0 if they change their signs alike, −1.0 if in opposite ways, and 0.0 if that
    may depend on the state or on constants: the ratio of their slopes differs from zero to zero.
    """
    random_lines = _RandomLines(graph, nodes)
    lines, places = np.divmod(np.arange(LINES * PLACES), PLACES)
    at = places * (4.0 / (PLACES - 1)) - 2.0
    sampled = random_lines.evaluator(nodes)(lines, at)
    sampled[~np.isfinite(sampled)] = 0.0
    pairs, distinct = _multiples(sampled)
    if len(distinct) > 1:
        evaluate = random_lines.evaluator([nodes[k] for k in distinct])
        sampled = sampled[:, distinct].reshape(LINES, PLACES, -1)
        others = _zeros_of_several(evaluate, sampled, at.reshape(LINES, PLACES)[0])
        pairs |= {(distinct[i], distinct[j]): products for (i, j), products in others.items()}
    return pairs


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
    lengths = np.linalg.norm(sampled, axis=0)
    distinct = [int(k) for k in np.flatnonzero(lengths)]
    cosines = sampled.T @ sampled / np.outer(lengths, lengths).clip(np.finfo(float).tiny)
    # The sine of half the angle between two of them is zero in half of the digits.
    for i in distinct.copy():
        for j in map(int, np.flatnonzero(np.abs(cosines[i, :i]) >= 1.0 - HALF)):
            if j in distinct:
                pairs[j, i] = float(np.sign(cosines[i, j]))
                distinct.remove(i)
                break
    return pairs, distinct


def _zeros_of_several(evaluate: _Evaluator, sampled: np.ndarray, places: np.ndarray) -> Pairs:
    """Return the pairs of nodes, of which none is a multiple of another."""
    sizes = np.median(np.abs(sampled), axis=(0, 1))
    changes = sampled[:, :-1] * sampled[:, 1:] < 0.0
    line, k, node = np.nonzero(changes & (changes.cumsum(axis=1) <= ZEROS))
    low, high, was_positive = places[k], places[k + 1], sampled[line, k, node] > 0.0
    for _ in range(HALVINGS if line.size else 0):
        middle = 0.5 * (low + high)
        stays = (evaluate(line, middle)[np.arange(len(line)), node] > 0.0) == was_positive
        low, high = np.where(stays, middle, low), np.where(stays, high, middle)
    if line.size:  # most zeros are of one node alone
        near = (np.abs(evaluate(line, low)) <= NEAR * sizes).sum(axis=1) > 1
        line, node, low, high = line[near], node[near], low[near], high[near]
    for _ in range(SECANTS if line.size else 0):
        at_low, at_high = (evaluate(line, s)[np.arange(len(line)), node] for s in (low, high))
        with np.errstate(all="ignore"):
            step = at_low * (high - low) / (at_high - at_low)
        low, high = low - np.where(np.isfinite(step), step, 0.0), low
    pairs: Pairs = {}
    if not line.size:
        return pairs
    before, zero, after = (evaluate(line, low + h) for h in (-BESIDE, 0.0, BESIDE))
    crosses = (np.abs(zero) <= HALF * sizes) & (np.sign(before) * np.sign(after) == -1.0)
    ratios: dict[tuple[int, int], list[float]] = {}
    for n, (i, at) in enumerate(zip(node, crosses, strict=True)):
        for j in np.flatnonzero(at) if at[i] else ():
            if i != j:
                a, b = min(int(i), int(j)), max(int(i), int(j))
                slopes = after[n] - before[n]
                ratios.setdefault((a, b), []).append(slopes[b] / slopes[a])
    for pair, values in ratios.items():
        is_constant = len(values) > 1 and np.ptp(values) <= DIGITS * np.abs(values[0])
        pairs[pair] = float(np.sign(values[0])) if is_constant else 0.0
    return pairs
