"""Integrals of forces over distances, angles and other coordinates."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress

import numpy as np
import sympy as sm

from pydy._errors import UnsupportedFunctionError
from pydy._graph import Graph
from pydy._mechanics.components import numbers_across
from pydy._mechanics.frames import orthogonality_residuals
from pydy._mechanics.reader import InputReader
from pydy._mechanics.symbols import replace_symbols

SWITCHED = sm.Max, sm.Min, sm.Abs, sm.sign, sm.Heaviside, sm.Piecewise


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
