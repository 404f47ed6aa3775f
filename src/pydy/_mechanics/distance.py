"""Expressions that depend on a distance and constants only, and integrals of forces."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

import numpy as np
import sympy as sm

from pydy._errors import UnsupportedFunctionError
from pydy._graph import Graph, jacobian, rounding_bounds
from pydy._mechanics.components import numbers_across, numbers_of
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.reader import InputReader
from pydy._mechanics.symbols import find_symbols, replace_symbols
from pydy._rank import ROUNDED

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, TimeFunction

SWITCHED = sm.Max, sm.Min, sm.Abs, sm.sign, sm.Heaviside, sm.Piecewise


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


def integral_over(law: sm.Expr, distance: sm.Symbol) -> sm.Expr | None:
    """Integrate a law over the distance; None if SymPy finds no elementary function."""
    if (powers := _integral_of_powers(law, distance)) is not None:
        return powers
    integral = sm.S.NaN
    if not law.has(*SWITCHED):
        with suppress(NotImplementedError, ValueError, TypeError, AttributeError, RecursionError):
            integral = sm.integrate(law, distance, risch=True)
    if integral.has(sm.Integral, sm.S.NaN):
        # Many laws are functions of the square, which SymPy integrates more easily.
        square = sm.Dummy("S", positive=True)
        by_square = replace_symbols(law / distance, {distance: sm.sqrt(square)}) / 2
        odd = any(p.base == square and not p.exp.is_Integer for p in by_square.atoms(sm.Pow))
        integral = primitive(*((law, distance) if odd else (by_square, square)))
        integral = None if integral is None else replace_symbols(integral, {square: distance**2})
    if integral is None:
        return None
    integral = _of_either_sign(integral)
    try:
        random_values([integral], ())
    except UnsupportedFunctionError:  # an exponential integral, say
        return None
    return integral


def _integral_of_powers(law: sm.Expr, distance: sm.Symbol) -> sm.Expr | None:
    """Integrate a sum of powers of the distance; None for anything else."""
    parts = []
    for term in sm.Add.make_args(sm.expand(law)):
        size, power = term.as_independent(distance, as_Add=False)
        _, exponent = power.as_base_exp() if power != 1 else (distance, sm.S.Zero)
        if power not in (1, distance**exponent) or not exponent.is_number:
            return None
        if exponent == -1:
            parts.append(size * sm.log(distance))
        else:
            parts.append(size * distance ** (exponent + 1) / (exponent + 1))
    return sm.Add(*parts)


def primitive(force: sm.Expr, x: sm.Symbol) -> sm.Expr | None:
    """Return a continuous integral over x, or None if SymPy finds none."""
    if force.has(*SWITCHED):
        force = sm.piecewise_fold(force.rewrite(sm.Piecewise))
    # Sines and cosines that cancel, of a point beside an axis: SymPy would divide by their sum.
    if not force.is_polynomial(x) and (expanded := sm.expand(force)).is_polynomial(x):
        force = expanded
    try:
        integral = sm.integrate(force, x, manual=True)
    except (NotImplementedError, ValueError, TypeError, AttributeError, RecursionError):
        return None  # SymPy cannot order the intervals
    if integral.has(sm.Integral, sm.I, sm.nan, sm.zoo, sm.oo, sm.S.NegativeInfinity):
        return None
    return _of_either_sign(integral)


def _of_either_sign(energy: sm.Expr) -> sm.Expr:
    """Return an integral whose logarithms allow arguments of either sign."""
    return energy.replace(sm.log, lambda e: sm.log(e if e.is_positive else sm.Abs(e)))


def random_values(expressions: Sequence[sm.Expr], turns: Iterable[sm.Matrix]) -> np.ndarray:
    """Return the values of expressions at random states and constants, one row for each sample.

    Quaternions have unit length there, so that the matrices `turns` are rotations. Samples on the
    other side of each switch of the expressions follow.
    """
    graph = Graph()
    read = InputReader(graph, {}, ())
    nodes = read.all(expressions)
    return numbers_across(graph, nodes, nodes, orthogonality_residuals(turns, read))
