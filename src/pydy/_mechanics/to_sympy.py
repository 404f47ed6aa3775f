"""Graph nodes as SymPy expressions, with names for common subexpressions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

import sympy as sm

from pydy._errors import UnsupportedFunctionError
from pydy._graph import Graph
from pydy._program import OPERATIONS

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol


def exact(value: float) -> sm.Expr:
    """Return a number as an integer or a simple fraction if it is one, else as a float."""
    # The fractions of moments of inertia.
    fraction = Fraction(value).limit_denominator(12) if abs(value) < 2**53 else None
    if fraction is not None and float(fraction) == value:
        return sm.Rational(fraction.numerator, fraction.denominator)
    return sm.Float(f"{value:.15g}")


_SPECIAL: dict[str, Callable[..., sm.Expr]] = {
    "select": lambda condition, yes, no: sm.Piecewise((yes, condition), (no, True)),
    "min": sm.Min,
    "max": sm.Max,
    "log": sm.log,
    "pow": sm.Pow,
    "sqrt": sm.sqrt,
    "neg": lambda x: -x,
    "kept": lambda x: x,
}


def applied(op: str, args: Sequence[sm.Expr]) -> sm.Expr:
    """Return an operation applied to SymPy expressions."""
    row = OPERATIONS.get(op)
    function = _SPECIAL.get(op) or (getattr(sm, row.sympy) if row and row.sympy else None)
    if function is None:
        raise UnsupportedFunctionError(
            f"The operation `{op}` cannot be written with SymPy: its row in OPERATIONS names no "
            "counterpart there (`sympy=`)."
        )
    return function(*args)


def written(
    graph: Graph,
    nodes: Sequence[int],
    symbols: Mapping[int, AnySymbol],
    name: Callable[[str, sm.Expr], sm.Symbol | None] | None = None,
) -> tuple[list[sm.Expr], dict[sm.Symbol, sm.Expr]]:
    """Return nodes as expressions, and the definitions of the names in them, in order.

    `symbols` are those of the inputs. ``name(op, expression)`` returns a symbol for what occurs
    more than once, None for none.
    """
    reached = graph.reachable(nodes)
    uses = Counter(nodes)
    for node in reached:
        uses.update(graph.operands(node))
    expressions: dict[int, sm.Expr] = {}
    names: dict[sm.Symbol, sm.Expr] = {}
    for node in reached:
        op, args = graph.ops[node], graph.args[node]
        if op == "input":
            expressions[node] = symbols[node]
            continue
        if op == "const":
            expressions[node] = exact(args[0])
            continue
        if op == "bool":
            expressions[node] = sm.true if args[0] else sm.false
            continue
        if op == "sum":
            terms = [exact(c) * expressions[n] for n, c in args[1]]
            expression = sm.Add(exact(args[0]), *terms)
        elif op == "prod":
            expression = sm.Mul(*(expressions[n] ** e for n, e in args))
        else:
            expression = applied(op, [expressions[n] for n in args])
        symbol = None
        if name is not None and (uses[node] > 1 or op in ("sin", "cos")):
            symbol = name(op, expression)
        if symbol is not None:
            names[symbol] = expression
        expressions[node] = expression if symbol is None else symbol
    return [expressions[node] for node in nodes], names
