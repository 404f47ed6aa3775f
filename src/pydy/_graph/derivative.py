"""Exact derivatives by differentiating the graph forward.

Each node gets a sparse row ``{variable: node}`` of its partial derivatives, so the cost follows
the structure that is there. Linear solves are differentiated by the implicit rule: from ``A x = b``
follows ``A x' = b' − A' x``, one more right-hand side for the factors that exist already, instead
of a derivative of the elimination (Griewank & Walther, Evaluating Derivatives, 2nd ed., §15.1).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from pydy._graph.node import Graph

__all__ = ["jacobian"]

Row = dict[int, int]


def _sin(g: Graph, n: int, x: int) -> int:
    return g.call("cos", x)


# d f(x)/dx, given the graph, the node f(x) itself and x.
_UNARY: dict[str, Callable[[Graph, int, int], int]] = {
    "sqrt": lambda g, n, x: g.product([(n, -1)], 0.5),
    "exp": lambda g, n, x: n,
    "log": lambda g, n, x: g.powi(x, -1),
    "sin": _sin,
    "cos": lambda g, n, x: g.neg(g.call("sin", x)),
    "tan": lambda g, n, x: g.sum([(g.powi(n, 2), 1.0)], 1.0),
    "asin": lambda g, n, x: g.powi(g.call("sqrt", g.sum([(g.powi(x, 2), -1.0)], 1.0)), -1),
    "acos": lambda g, n, x: g.product(
        [(g.call("sqrt", g.sum([(g.powi(x, 2), -1.0)], 1.0)), -1)], -1.0
    ),
    "atan": lambda g, n, x: g.powi(g.sum([(g.powi(x, 2), 1.0)], 1.0), -1),
    "sinh": lambda g, n, x: g.call("cosh", x),
    "cosh": lambda g, n, x: g.call("sinh", x),
    "tanh": lambda g, n, x: g.sum([(g.powi(n, 2), -1.0)], 1.0),
    "asinh": lambda g, n, x: g.powi(g.call("sqrt", g.sum([(g.powi(x, 2), 1.0)], 1.0)), -1),
    "acosh": lambda g, n, x: g.powi(g.call("sqrt", g.sum([(g.powi(x, 2), 1.0)], -1.0)), -1),
    "atanh": lambda g, n, x: g.powi(g.sum([(g.powi(x, 2), -1.0)], 1.0), -1),
    "abs": lambda g, n, x: g.call("sign", x),
    "sign": lambda g, n, x: g.zero,
    "floor": lambda g, n, x: g.zero,
    "ceil": lambda g, n, x: g.zero,
}


def _binary(g: Graph, op: str, n: int, a: int, b: int) -> tuple[int, int]:
    """Return the two partial derivatives of a function of two arguments."""
    if op == "pow":
        by_base = g.mul(b, g.call("pow", a, g.sum([(b, 1.0)], -1.0)))
        # log(0) · 0 at a zero base would be NaN where the derivative is 0.
        by_exponent = g.call("select", g.call("eq", a, g.zero), g.zero, g.mul(n, g.call("log", a)))
        return by_base, by_exponent
    if op == "atan2":
        square = g.add(g.powi(a, 2), g.powi(b, 2))
        return g.div(b, square), g.neg(g.div(a, square))
    first = g.call("le", a, b) if op == "min" else g.call("le", b, a)
    return (
        g.call("select", first, g.one, g.zero),
        g.call("select", first, g.zero, g.one),
    )


def jacobian(
    graph: Graph, outputs: Sequence[int], variables: Sequence[int]
) -> list[dict[int, int]]:
    """Return the partial derivatives of `outputs` with respect to `variables`.

    Parameters
    ----------
    graph : Graph
        Gets the new nodes.
    outputs : sequence of nodes
    variables : sequence of input nodes

    Returns
    -------
    list of dict
        For each output a dict from the variable's place to the derivative's node; what is missing
        is zero by structure.

    Notes
    -----
    At a switch (``abs``, ``sign``, ``min``, ``max``, ``floor``, Piecewise) the derivative is that
    of the branch that is taken; steps have derivative zero.
    """
    rows: dict[int, Row] = {node: {k: graph.one} for k, node in enumerate(variables)}
    vectors: dict[int, list[Row]] = {}
    for node in graph.reachable(outputs):
        if node not in rows:
            rows[node] = _row(graph, node, rows, vectors)
    zero = graph.zero
    return [{k: d for k, d in sorted(rows[n].items()) if d != zero} for n in outputs]


def _row(g: Graph, node: int, rows: dict[int, Row], vectors: dict[int, list[Row]]) -> Row:
    op, args = g.ops[node], g.args[node]
    if op == "sum":
        return _combine(g, [(rows[n], None, c) for n, c in args[1]])
    if op == "prod":
        parts = []
        for k, (n, e) in enumerate(args):
            if rows[n]:
                others = [(m, f) for j, (m, f) in enumerate(args) if j != k]
                parts.append((rows[n], g.product([*others, (n, e - 1)], float(e)), 1.0))
        return _combine(g, parts)
    if op in _UNARY:
        inner = rows[args[0]]
        return _combine(g, [(inner, _UNARY[op](g, node, args[0]), 1.0)]) if inner else {}
    if op in ("pow", "atan2", "min", "max"):
        a, b = args
        if not rows[a] and not rows[b]:
            return {}
        by_a, by_b = _binary(g, op, node, a, b)
        return _combine(g, [(rows[a], by_a, 1.0), (rows[b], by_b, 1.0)])
    if op == "select":
        condition, yes, no = args
        keys = sorted({*rows[yes], *rows[no]})
        zero = g.zero
        return {
            k: g.call("select", condition, rows[yes].get(k, zero), rows[no].get(k, zero))
            for k in keys
        }
    if op == "solve":
        vectors[node] = _solve_rows(g, node, rows)
        return {}
    if op == "item":
        row: Row = vectors[args[0]][args[1]]
        return row
    return {}  # constants, other inputs, conditions, factors


def _combine(g: Graph, parts: Sequence[tuple[Row, int | None, float]]) -> Row:
    """Return Σ coefficient · factor · row."""
    terms: dict[int, list[tuple[int, float]]] = {}
    for row, factor, coefficient in parts:
        for key, d in row.items():
            product = d if factor is None else g.mul(d, factor)
            terms.setdefault(key, []).append((product, coefficient))
    return {k: g.sum(t) for k, t in terms.items()}


def _solve_rows(g: Graph, node: int, rows: dict[int, Row]) -> list[Row]:
    factor, column = g.args[node]
    kind, n, entries = g.args[factor]
    x = [g.make("item", (node, k)) for k in range(n)]
    keys: set[int] = set()
    for e in (*entries, *column):
        keys.update(rows[e])
    result: list[Row] = [{} for _ in range(n)]
    for key in sorted(keys):
        right = []
        for i in range(n):
            terms = []
            if key in rows[column[i]]:
                terms.append((rows[column[i]][key], 1.0))
            for j in range(n):
                # An SPD factor reads the lower triangle only; so must its derivative.
                low = max(i, j) * n + min(i, j) if kind == "ldl" else i * n + j
                d = rows[entries[low]].get(key)
                if d is not None:
                    terms.append((g.mul(d, x[j]), -1.0))
            right.append(g.sum(terms))
        for i, d in enumerate(g.solve_factored(factor, right)):
            if d != g.zero:
                result[i][key] = d
    return result
