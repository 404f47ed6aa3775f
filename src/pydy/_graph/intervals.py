"""Bounds on nodes of a graph where an input lies in an interval: interval arithmetic.

The result of an operation on intervals contains its values for all numbers in them (R. E. Moore,
R. B. Kearfott and M. J. Cloud, Introduction to Interval Analysis, SIAM, 2009, §2.3). Rounding, that
of other implementations of a function too, is allowed for: bounds move apart by `INTERVAL_SLACK`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np

from pydy._graph.node import Graph
from pydy._graph.tuning import INTERVAL_SLACK
from pydy._program import OPERATIONS

Bound: TypeAlias = "float | np.ndarray"
Interval: TypeAlias = tuple[Bound, Bound]  # lower and upper bounds: numbers, or arrays (m,)

_INCREASING = frozenset(
    ("exp", "log", "sqrt", "asin", "atan", "sinh", "tanh", "asinh", "acosh", "atanh", "erf")
)
_DECREASING = frozenset(("acos", "erfc"))
_EXACT = frozenset(("floor", "ceil", "sign", "kept"))  # they increase, too


def bounded(op: str) -> bool:
    """Return whether bounds on an operation are known."""
    return op in _RULES or op in ("sum", "prod", "const", "bool", "input")


def bounds(graph: Graph, nodes: Sequence[int], leaf: Callable[[int], Interval]) -> list[Interval]:
    """Return bounds on nodes; `leaf` gives those of an input.

    What is undefined in a part of an interval has no finite bounds there.
    """
    interval_of: dict[int, Interval] = {}
    with np.errstate(all="ignore"):
        for node in graph.reachable(nodes):
            op, args = graph.ops[node], graph.args[node]
            if op == "input":
                interval_of[node] = leaf(node)
            elif op in ("const", "bool"):
                interval_of[node] = args[0], args[0]
            elif op == "sum":
                interval_of[node] = _sum(args[0], [(interval_of[n], c) for n, c in args[1]])
            elif op == "prod":
                interval_of[node] = _product([_power(interval_of[n], e) for n, e in args])
            else:
                interval_of[node] = _RULES[op](*(interval_of[n] for n in args))
    return [interval_of[n] for n in nodes]


def _widened(low: Bound, high: Bound) -> Interval:
    """Move bounds apart by what rounding may have done; no bound is known of NaN."""
    low, high = low - INTERVAL_SLACK * np.abs(low), high + INTERVAL_SLACK * np.abs(high)
    return np.where(np.isnan(low), -np.inf, low), np.where(np.isnan(high), np.inf, high)


def _sum(constant: float, terms: Sequence[tuple[Interval, float]]) -> Interval:
    low: Bound
    high: Bound
    low = high = constant
    for (a, b), c in terms:
        first, second = _widened(a * c, b * c) if c > 0.0 else _widened(b * c, a * c)
        low, high = _widened(low + first, high + second)
    return low, high


def _product(factors: Sequence[Interval]) -> Interval:
    low, high = factors[0]
    for a, b in factors[1:]:
        # Bounds that are infinite stand for finite numbers without a bound: zero times them is 0.
        ends = [np.where(np.isnan(c), 0.0, c) for c in (low * a, low * b, high * a, high * b)]
        low, high = _widened(np.minimum.reduce(ends), np.maximum.reduce(ends))
    return low, high


def _power(base: Interval, exponent: int) -> Interval:
    if exponent == 1:
        return base
    if exponent < 0:
        return _reciprocal(_power(base, -exponent))
    low, high = _size(*base) if exponent % 2 == 0 else base
    return _widened(np.power(low, float(exponent)), np.power(high, float(exponent)))


def _reciprocal(divisor: Interval) -> Interval:
    low, high = divisor
    least = np.where(high > 0.0, np.where(low < 0.0, -np.inf, 1.0 / high), 1.0 / high)
    most = np.where(low < 0.0, np.where(high > 0.0, np.inf, 1.0 / low), 1.0 / low)
    least = np.where(high == 0.0, -np.inf, least)
    return _widened(least, np.where(low == 0.0, np.inf, most))


def _size(low: Bound, high: Bound) -> Interval:
    least = np.where((low <= 0.0) & (high >= 0.0), 0.0, np.minimum(np.abs(low), np.abs(high)))
    return least, np.maximum(np.abs(low), np.abs(high))


def _wave(function: Callable[[Bound], Bound], crest: float) -> Callable[[Interval], Interval]:
    """Return the rule of a sine, which is 1 at a `crest` and after each turn."""

    def holds(low: Bound, high: Bound, at: float) -> np.ndarray:
        first, last = (low - at) / math.tau, (high - at) / math.tau
        slack = INTERVAL_SLACK * np.maximum(np.abs(first), np.abs(last)) + INTERVAL_SLACK
        return ~(np.ceil(first - slack) > np.floor(last + slack))

    def rule(angle: Interval) -> Interval:
        low, high = angle
        a, b = function(low), function(high)
        least, most = _widened(np.minimum(a, b), np.maximum(a, b))
        least = np.where(holds(low, high, crest - math.pi), -1.0, np.maximum(least, -1.0))
        return least, np.where(holds(low, high, crest), 1.0, np.minimum(most, 1.0))

    return rule


def _tangent(angle: Interval) -> Interval:
    low, high = angle
    least, most = _widened(np.tan(low), np.tan(high))
    slack = INTERVAL_SLACK * np.maximum(np.abs(low), np.abs(high)) + INTERVAL_SLACK
    same_branch = np.floor(low / math.pi + 0.5 - slack) == np.floor(high / math.pi + 0.5 + slack)
    return np.where(same_branch, least, -np.inf), np.where(same_branch, most, np.inf)


def _monotone(name: str) -> Callable[[Interval], Interval]:
    function = OPERATIONS[name].numpy
    if name in _DECREASING:
        return lambda x: _widened(function(x[1]), function(x[0]))
    if name in _EXACT:
        return lambda x: (function(x[0]), function(x[1]))
    return lambda x: _widened(function(x[0]), function(x[1]))


def _general_power(base: Interval, exponent: Interval) -> Interval:
    low, high = _RULES["exp"](_product([exponent, _RULES["log"](base)]))
    positive = base[0] >= 0.0
    return np.where(positive, low, -np.inf), np.where(positive, high, np.inf)


def _direction(y: Interval, x: Interval) -> Interval:
    corners = [np.arctan2(a, b) for a in y for b in x]
    crosses_cut = (y[0] <= 0.0) & (y[1] >= 0.0) & (x[0] <= 0.0)
    low, high = _widened(np.minimum.reduce(corners), np.maximum.reduce(corners))
    return np.where(crosses_cut, -math.pi, low), np.where(crosses_cut, math.pi, high)


# Of truth values: whether it is certainly true, and whether it may be.


def _same(a: Interval, b: Interval) -> Interval:
    certain = (a[0] == a[1]) & (b[0] == b[1]) & (a[0] == b[0])
    return certain, (a[0] <= b[1]) & (b[0] <= a[1])


def _not(a: Interval) -> Interval:
    return np.logical_not(a[1]), np.logical_not(a[0])


def _select(condition: Interval, yes: Interval, no: Interval) -> Interval:
    certain, possible = condition
    low = np.where(certain, yes[0], np.where(possible, np.minimum(yes[0], no[0]), no[0]))
    return low, np.where(certain, yes[1], np.where(possible, np.maximum(yes[1], no[1]), no[1]))


_RULES: dict[str, Callable[..., Interval]] = {
    **{name: _monotone(name) for name in (*_INCREASING, *_DECREASING, *_EXACT)},
    "sin": _wave(np.sin, math.pi / 2.0),
    "cos": _wave(np.cos, 0.0),
    "tan": _tangent,
    "abs": lambda x: _size(*x),
    "cosh": lambda x: _widened(*map(np.cosh, _size(*x))),
    "pow": _general_power,
    "atan2": _direction,
    "min": lambda a, b: (np.minimum(a[0], b[0]), np.minimum(a[1], b[1])),
    "max": lambda a, b: (np.maximum(a[0], b[0]), np.maximum(a[1], b[1])),
    "lt": lambda a, b: (a[1] < b[0], a[0] < b[1]),
    "le": lambda a, b: (a[1] <= b[0], a[0] <= b[1]),
    "eq": _same,
    "ne": lambda a, b: _not(_same(a, b)),
    "and": lambda a, b: (np.logical_and(a[0], b[0]), np.logical_and(a[1], b[1])),
    "or": lambda a, b: (np.logical_or(a[0], b[0]), np.logical_or(a[1], b[1])),
    "not": _not,
    "select": _select,
}
