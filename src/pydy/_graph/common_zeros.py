"""Which nodes are zero together, and whether they change their signs alike there.

``exp(−x) − 1`` is zero where x is, and its slope there is −1 times that of x; ``(y − 1) x`` is zero
there, too, and the ratio of the slopes depends on the state. x³ + x |x| has no slope there, and
nevertheless the sign of x. Nodes are evaluated along random lines through the space of states and
specifieds, with random constants. Where one of them changes its sign, its zero is found to the last
digit. Others that are zero at the same number are zero together with it. Nodes that share isolated
points alone, as x and x + y, are not. x² − |x| is zero with x, too, and does not change its sign.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple, TypeAlias

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
    SAME_ORDER,
    SAME_ZERO,
    SAME_ZERO_BY_ROUNDING,
    WIDE,
    ZEROS,
)
from pydy._rank import DIGITS, ROUNDED

_Pairs: TypeAlias = dict[tuple[int, int], float]
# Returns the values of nodes, shape (samples, nodes), from the lines and the places on these.
_Evaluator: TypeAlias = Callable[[np.ndarray, np.ndarray], np.ndarray]


class CommonZeros(NamedTuple):
    """Which nodes are zero together."""

    # From nodes i < j that change their signs together to 1.0 if alike, −1.0 if in opposite ways,
    # and 0.0 if that may depend on the state or on constants: the ratio of their slopes differs
    # from zero to zero.
    pairs: _Pairs
    # From nodes that do not change their signs where another one does to their sign beside these
    # zeros, or 0.0 if it is not the same everywhere.
    touching: dict[int, float]
    # From nodes that change their signs without a slope, as x³ does, to nodes with a slope that are
    # zero together with them, and 1.0 or −1.0 as in pairs.
    with_slopes: dict[int, tuple[float, int]]


def common_zeros(graph: Graph, nodes: Sequence[int]) -> CommonZeros:
    """Return which nodes are zero together."""
    random_lines = _RandomLines(graph, nodes)
    far = 2.0 ** np.arange(2, FARTHEST)
    places = np.concatenate([-far[::-1], np.linspace(-2.0, 2.0, PLACES), far])
    lines, at = np.repeat(np.arange(LINES), len(places)), np.tile(places, LINES)
    sampled = random_lines.evaluator(nodes)(lines, at).reshape(LINES, len(places), -1)
    sampled[~np.isfinite(sampled)] = 0.0
    pairs, distinct = _multiples(sampled[:, np.abs(places) <= 2.0].reshape(-1, len(nodes)))
    if len(distinct) < 2:
        return CommonZeros(pairs, {}, {})
    evaluate = random_lines.evaluator([nodes[k] for k in distinct])
    others = _zeros_of_several(evaluate, sampled[..., distinct], places)
    pairs |= {(distinct[i], distinct[j]): sign for (i, j), sign in others.pairs.items()}
    touching = {distinct[i]: sign for i, sign in others.touching.items()}
    with_slopes = {distinct[i]: (sign, distinct[j]) for i, (sign, j) in others.with_slopes.items()}
    return CommonZeros(pairs, touching, with_slopes)


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


def _multiples(sampled: np.ndarray) -> tuple[_Pairs, list[int]]:
    """Return pairs of nodes that are multiples of one another, and one node of each such group."""
    pairs: _Pairs = {}
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


class _Beside(NamedTuple):
    """How nodes behave beside a zero, each (zeros, nodes)."""

    vanishes: np.ndarray  # whether they are zero there
    before: np.ndarray  # their values
    after: np.ndarray
    order: np.ndarray  # the power of the distance that they grow with, on both sides

    @property
    def signs(self) -> np.ndarray:
        """Return −1 where they change their signs, and 1 where they do not."""
        signs: np.ndarray = np.sign(self.before) * np.sign(self.after)
        return signs


def _beside(evaluate: _Evaluator, line: np.ndarray, zero: np.ndarray, size: np.ndarray) -> _Beside:
    """Return how nodes behave beside zeros at places of lines, of the given size."""
    here = np.abs(evaluate(line, zero))
    found = list[_Beside]()
    for distance, same in ((BESIDE, SAME_ZERO), (WIDE, SAME_ZERO_BY_ROUNDING)):
        before, after = (evaluate(line, zero + step * size) for step in (-distance, distance))
        with np.errstate(all="ignore"):
            orders = [
                np.log2(np.abs(evaluate(line, zero + 2.0 * step * size) / value))
                for step, value in ((-distance, before), (distance, after))
            ]
            order = np.where(np.abs(orders[1] - orders[0]) <= SAME_ORDER, orders[1], np.nan)
            total = np.abs(before) + np.abs(after)
            vanishes = np.isfinite(total) & (here <= same * total)
        found.append(_Beside(vanishes, before, after, order))
    near, wide = found
    # Where rounding errors are all that is there, as of sinh(x) − x.
    by_rounding = wide.vanishes & np.isnan(near.order) & (wide.order > 1.0 + SAME_ORDER)
    return _Beside(
        np.where(by_rounding, wide.vanishes, near.vanishes),
        np.where(by_rounding, wide.before, near.before),
        np.where(by_rounding, wide.after, near.after),
        np.where(by_rounding, wide.order, near.order),
    )


def _zeros_of_several(evaluate: _Evaluator, sampled: np.ndarray, places: np.ndarray) -> CommonZeros:
    """Return what `common_zeros` does, of nodes of which none is a multiple of another."""
    line, k, node = _intervals(sampled, places)
    if not line.size:
        return CommonZeros({}, {}, {})
    low, high, was_positive = places[k], places[k + 1], sampled[line, k, node] > 0.0
    size = np.maximum(np.abs(low), np.abs(high))
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        stays = (evaluate(line, middle)[np.arange(len(line)), node] > 0.0) == was_positive
        low, high = np.where(stays, middle, low), np.where(stays, high, middle)
    beside = _beside(evaluate, line, low, size)
    vanishes, signs, order = beside.vanishes, beside.signs, beside.order
    with np.errstate(invalid="ignore"):  # of nodes that are infinite there
        slopes = beside.after - beside.before
    ratios: dict[tuple[int, int], list[float]] = {}
    same_order: set[tuple[int, int]] = set()
    sloping, flat = set[int](), set[int]()
    touches: dict[int, set[float]] = {}
    for n, i in enumerate(map(int, node)):
        if not (vanishes[n, i] and signs[n, i] == -1.0):
            continue
        for j in map(int, np.flatnonzero(vanishes[n])):
            if signs[n, j] == 1.0:
                touches.setdefault(j, set()).add(float(np.sign(beside.after[n, j])))
            elif signs[n, j] == -1.0:
                (flat if order[n, j] > 1.0 + SAME_ORDER else sloping).add(j)
                if j != i:
                    a, b = min(i, j), max(i, j)
                    ratios.setdefault((a, b), []).append(slopes[n, b] / slopes[n, a])
                    if not np.abs(order[n, b] - order[n, a]) > SAME_ORDER:
                        same_order.add((a, b))
    pairs: _Pairs = {}
    for pair, values in ratios.items():
        # The ratio of x³ and x tends to zero, whatever they are multiplied by: its sign counts.
        compared = np.array(values) if pair in same_order else np.sign(values)
        is_constant = len(values) > 1 and np.ptp(compared) <= DIGITS * np.abs(compared[0])
        pairs[pair] = float(np.sign(values[0])) if is_constant else 0.0
    crossing = {k for pair in pairs for k in pair}
    touching = {
        j: min(found) if len(found) == 1 and j not in crossing else 0.0
        for j, found in touches.items()
    }
    with_slopes: dict[int, tuple[float, int]] = {}
    for pair, sign in pairs.items():
        for i, j in (pair, pair[::-1]):
            if sign and i in flat - sloping and j in sloping - flat:
                with_slopes.setdefault(i, (sign, j))
    return CommonZeros(pairs, touching, with_slopes)


def _intervals(sampled: np.ndarray, places: np.ndarray) -> tuple[np.ndarray, ...]:
    """Return lines, places and nodes of changes of sign, the first of each node on each line."""
    signs = np.sign(sampled)
    changes = signs[:, :-1] * signs[:, 1:] < 0.0
    changes[max(2, INTERVALS // sampled.shape[2]) :] = False  # a few lines for many nodes
    outward = np.abs(places[:-1] + places[1:]).argsort(kind="stable")
    ordered = changes[:, outward]
    line, k, node = np.nonzero(ordered & (ordered.cumsum(axis=1) <= ZEROS))
    return line, outward[k], node
