"""Which expressions depend on a distance, or on another length, and on constants alone."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import sympy as sm

from pydy._errors import UnsupportedFunctionError
from pydy._graph import Graph, jacobian, rounding_bounds
from pydy._mechanics.components import numbers_of
from pydy._mechanics.reader import InputReader
from pydy._mechanics.symbols import find_symbols
from pydy._rank import ROUNDED


def may_depend_on(expression: Any, square: Any, moving: Sequence[Any]) -> bool:
    """Return whether an expression may depend on the square of a distance and constants alone.

    Then its gradient by all that is `moving` is along that of the square, up to rounding. Along
    one axis all forces are along the lines to all points: numbers tell most of them apart at once,
    where SymPy would write each anew.
    """
    graph = Graph()
    read = InputReader(graph, {}, ())
    try:
        by = read.all(moving)
        slopes = jacobian(graph, read.all([expression, square]), by).flat()
        bounds = rounding_bounds(graph, slopes, constants=True)
        found = numbers_of(graph, [*slopes, *bounds]).reshape(-1, 2, 2, len(by))
    except UnsupportedFunctionError:  # SymPy may still write it
        return True
    (own, way), (own_error, way_error) = found[:, 0].swapaxes(0, 1), found[:, 1].swapaxes(0, 1)
    largest = np.abs(way).argmax(axis=1)[:, None]
    own_0, way_0, own_error_0, way_error_0 = (
        np.take_along_axis(table, largest, axis=1) for table in (own, way, own_error, way_error)
    )
    apart = np.abs(own * way_0 - own_0 * way)
    rounded = own_error * np.abs(way_0) + np.abs(own) * way_error_0
    rounded += own_error_0 * np.abs(way) + np.abs(own_0) * way_error
    return not bool((apart > ROUNDED * rounded).any())


def beside_constants(total: Any, square: Any, coordinates: Sequence[Any]) -> Any:
    """Return a and b of ``total = a · square + b`` with constants a and b, or None."""
    if not find_symbols([total]).keys() >= {*coordinates}:
        return None
    graph = Graph()
    read = InputReader(graph, {}, ())
    by = read.all(coordinates)
    try:
        slopes = jacobian(graph, read.all([total, square]), by).flat()
        values = numbers_of(graph, slopes).reshape(-1, 2, len(by))
    except UnsupportedFunctionError:  # of what is no function of the distance
        return None
    with np.errstate(divide="ignore", invalid="ignore"):
        shares = values[:, 0] / values[:, 1]
    if not (np.abs(shares - shares[:, :1]) <= ROUNDED * np.abs(shares)).all():
        return None
    q = coordinates[0]
    share = sm.cancel(total.diff(q) / square.diff(q))
    if share.has(*coordinates):
        return None
    rest = sm.expand(total - share * square)
    return None if rest.has(*coordinates) else (share, rest)
