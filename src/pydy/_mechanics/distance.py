"""Expressions that depend on a distance, or on another length, and on constants only."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import sympy as sm

from pydy._errors import UnsupportedFunctionError
from pydy._graph import Graph, jacobian, rounding_bounds
from pydy._mechanics.components import numbers_of
from pydy._mechanics.reader import InputReader
from pydy._mechanics.symbols import find_symbols
from pydy._rank import ROUNDED

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, TimeFunction


def may_depend_on(expression: sm.Expr, square: sm.Expr, moving: Sequence[AnySymbol]) -> bool:
    """Return whether an expression may depend on the square of a distance and constants only.

    Then its gradient is parallel to that of the square, up to rounding. If all points are on one
    axis, every force is along the lines to all points: this numeric test excludes most candidates
    before SymPy rewrites them.
    """
    graph = Graph()
    read = InputReader(graph, {}, ())
    try:
        variables = read.all(moving)
        slopes = jacobian(graph, read.all([expression, square]), variables).flat()
        bounds = rounding_bounds(graph, slopes, constants=True)
        values = numbers_of(graph, [*slopes, *bounds]).reshape(-1, 2, 2, len(variables))
    except UnsupportedFunctionError:  # SymPy may still rewrite it
        return True
    (slope, direction), (own_error, way_error) = (
        values[:, 0].swapaxes(0, 1),
        values[:, 1].swapaxes(0, 1),
    )
    largest = np.abs(direction).argmax(axis=1)[:, None]
    own_0, way_0, own_error_0, way_error_0 = (
        np.take_along_axis(table, largest, axis=1)
        for table in (slope, direction, own_error, way_error)
    )
    difference = np.abs(slope * way_0 - own_0 * direction)
    rounded = own_error * np.abs(way_0) + np.abs(slope) * way_error_0
    rounded += own_error_0 * np.abs(direction) + np.abs(own_0) * way_error
    return not bool((difference > ROUNDED * rounded).any())


def beside_constants(
    total: sm.Expr, square: sm.Expr, coordinates: Sequence[TimeFunction]
) -> tuple[sm.Expr, sm.Expr] | None:
    """Return a and b of ``total = a · square + b`` with constants a and b, or None."""
    if not find_symbols([total]).keys() >= {*coordinates}:
        return None
    graph = Graph()
    read = InputReader(graph, {}, ())
    variables = read.all(coordinates)
    try:
        slopes = jacobian(graph, read.all([total, square]), variables).flat()
        values = numbers_of(graph, slopes).reshape(-1, 2, len(variables))
    except UnsupportedFunctionError:  # not a function of the distance
        return None
    with np.errstate(divide="ignore", invalid="ignore"):
        shares = values[:, 0] / values[:, 1]
    if not (np.abs(shares - shares[:, :1]) <= ROUNDED * np.abs(shares)).all():
        return None
    q = coordinates[0]
    share = sm.cancel(total.diff(q) / square.diff(q))
    if share.has(*coordinates):
        return None
    constant = sm.expand(total - share * square)
    return None if constant.has(*coordinates) else (share, constant)
