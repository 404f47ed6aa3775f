"""From SymPy to a peer's own expressions: one memoised walk, each distinct object once."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from functools import reduce
from operator import add, mul
from typing import Any

import sympy as sm
from sympy.core.function import AppliedUndef

from harness.model import Model


class Algebra:
    """How a peer writes sums, products and functions; this one computes with floats.

    Parameters
    ----------
    functions : mapping of str to callable, optional
        By SymPy's names.
    """

    def __init__(self, functions: Mapping[str, Callable[..., Any]] | None = None) -> None:
        self.functions = functions or {k: getattr(math, k) for k in ("sin", "cos", "tan", "sqrt")}

    def number(self, value: float) -> Any:
        """Return a number."""
        return value

    def sum(self, terms: list[Any]) -> Any:
        """Return a sum of at least two terms."""
        return reduce(add, terms)

    def product(self, factors: list[Any]) -> Any:
        """Return a product of at least two factors."""
        return reduce(mul, factors)

    def integer_power(self, base: Any, exponent: int) -> Any:
        """Return ``base ** exponent`` for an exponent of 2 or more."""
        return base**exponent

    def power(self, base: Any, exponent: float) -> Any:
        """Return ``base ** exponent``."""
        return base**exponent

    def any_power(self, base: Any, exponent: sm.Expr) -> Any:
        """Return a power with a number for its exponent, by the cheapest means."""
        if exponent.is_negative:
            return self.number(1.0) / self.any_power(base, -exponent)
        if exponent == 1:
            return base
        if exponent == sm.S.Half:
            return self.functions["sqrt"](base)
        if exponent.is_Integer:
            return self.integer_power(base, int(exponent))
        return self.power(base, float(exponent))

    def all_of(self, expressions: Iterable[Any], leaves: Mapping[Any, Any]) -> list[Any]:
        """Translate expressions; shared objects stay shared."""
        done: dict[int, Any] = {}
        return [self._translate(e, leaves, done) for e in expressions]

    def _translate(self, root: Any, leaves: Mapping[Any, Any], done: dict[int, Any]) -> Any:
        stack = [root]
        while stack:
            expr = stack[-1]
            if id(expr) in done:
                stack.pop()
            elif expr.is_Number or expr is sm.pi:
                done[id(expr)] = self.number(float(expr))
            elif isinstance(expr, (sm.Symbol, AppliedUndef, sm.Derivative)):
                done[id(expr)] = leaves[expr]
            elif missing := [a for a in expr.args if id(a) not in done]:
                stack.extend(missing)
            else:
                done[id(expr)] = self._make(expr, [done[id(a)] for a in expr.args])
        return done[id(root)]

    def _make(self, expr: Any, args: list[Any]) -> Any:
        if expr.is_Add:
            return self.sum(args)
        if expr.is_Mul:
            return self.product(args)
        if expr.is_Pow:
            return self.any_power(args[0], expr.exp)
        return self.functions[type(expr).__name__](*args)


def leaves_of(model: Model, x: Any, r: Any, p: Any) -> dict[Any, Any]:
    """Return what each symbol stands for, given the peer's three vectors of inputs."""
    states = [*model.coordinates, *model.speeds]
    symbols = [*states, *model.specifieds, *model.constants]
    values = [*(x[k] for k in range(len(states)))]
    values += [r[k] for k in range(len(model.specifieds))]
    values += [p[k] for k in range(len(model.constants))]
    return dict(zip(symbols, values, strict=True))


def translate(model: Model, algebra: Algebra, x: Any, r: Any, p: Any) -> tuple[list[Any], ...]:
    """Return the mass matrix's entries by rows, None for a zero; the forcing; and q'."""
    n = len(model.speeds)
    expressions = [*model.mass_matrix, *model.forcing, *model.coordinate_derivatives]
    nodes = algebra.all_of(expressions, leaves_of(model, x, r, p))
    matrix = [
        None if e.is_zero else node for e, node in zip(model.mass_matrix, nodes, strict=False)
    ]
    return matrix, nodes[n * n : n * n + n], nodes[n * n + n :]
