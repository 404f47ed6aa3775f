"""Exact derivatives by differentiating the graph forward.

Each node gets a sparse row ``{variable: node}`` of its partial derivatives, so the cost follows
the structure that is there. Linear solves are differentiated by the implicit rule: from ``A x = b``
follows ``A x' = b' − A' x``, one more right-hand side for the factors that exist already, instead
of a derivative of the elimination (Griewank & Walther, Evaluating Derivatives, 2nd ed., §15.1).

A root that may be at rest is a variable too, as −1 − root, until it is known what is made of it
(`pydy._graph.roots`).

A guarded solution of a system that is not symmetric is differentiated as it was found. Where the
guard falls back those derivatives may have no correct digits, and NaN stands for them: they are
then to be taken by the systems, which costs more operations and holds everywhere.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Literal

from pydy._graph.node import Graph
from pydy._graph.operations import OPERATIONS, is_symmetric
from pydy._graph.roots import at_rest, of_half_power, slope

__all__ = [
    "Guards",
    "Rows",
    "dense",
    "dense_jacobian",
    "dense_rows",
    "directional",
    "has_other_ways",
    "jacobian",
    "times",
]

Row = dict[int, int]
Guards = Literal["checked", "as found", "by systems"]
"""How guarded solutions of systems that are not symmetric are differentiated: as they were found,
with NaN where the guard falls back or without; or by the system, which holds everywhere."""


def has_other_ways(graph: Graph, outputs: Sequence[int]) -> bool:
    """Return whether it matters how guards are differentiated; see `Guards`."""
    return any(
        graph.ops[node] == "guard" and not is_symmetric(*graph.args[node][:2])
        for node in graph.reachable(outputs)
    )


def jacobian(
    graph: Graph, outputs: Sequence[int], variables: Sequence[int], *, guards: Guards = "checked"
) -> list[dict[int, int]]:
    """Return the partial derivatives of `outputs` with respect to `variables`.

    Parameters
    ----------
    graph : Graph
        Gets the new nodes.
    outputs : sequence of nodes
    variables : sequence of input nodes
    guards : Guards

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
    given = {node: {k: graph.one} for k, node in enumerate(variables)}
    return directional(graph, outputs, given, guards=guards)


def dense_jacobian(graph: Graph, outputs: Sequence[int], by: Sequence[int]) -> list[int]:
    """Return all derivatives of some nodes by others, row by row."""
    return dense(graph, jacobian(graph, outputs, by), len(by))


def dense(graph: Graph, rows: Sequence[Mapping[int, int]], width: int) -> list[int]:
    """Return derivatives with their zeros, row by row."""
    return [node for row in dense_rows(graph, rows, width) for node in row]


def dense_rows(graph: Graph, rows: Sequence[Mapping[int, int]], width: int) -> list[list[int]]:
    """Return derivatives with their zeros, as a list of rows."""
    return [[row.get(k, graph.zero) for k in range(width)] for row in rows]


def directional(
    graph: Graph, outputs: Sequence[int], given: Mapping[int, Row], *, guards: Guards = "checked"
) -> list[Row]:
    """Return the derivatives of `outputs` in several directions.

    Parameters
    ----------
    graph : Graph
        Gets the new nodes.
    outputs : sequence of nodes
    given : mapping of nodes to rows
        For each variable its part of the directions: a dict from the direction's place to the
        node of the component.
    guards : Guards

    Returns
    -------
    list of dict
        For each output a dict from the direction's place to the derivative's node; what is missing
        is zero by structure.
    """
    rows: dict[int, Row] = dict(given)
    vectors: dict[int, list[Row]] = {}
    for node in graph.reachable(outputs):
        if node not in rows:
            rows[node] = _row(graph, node, rows, vectors, guards)
    zero = graph.zero
    settled = [_settled(graph, n, rows) for n in outputs]
    return [{k: d for k, d in sorted(row.items()) if d != zero} for row in settled]


class Rows:
    """Sparse rows of derivatives, each made once. Differentiation stops where a row is given.

    Parameters
    ----------
    graph : Graph
        Gets the new nodes.
    given : dict of nodes to rows
        A row maps what is differentiated by, any integers, to the derivative's node.
    leaf : callable, optional
        Gives the row of an input that has none; no derivatives by default.
    guards : Guards
    """

    def __init__(
        self,
        graph: Graph,
        given: dict[int, Row],
        leaf: Callable[[int], Row] | None = None,
        *,
        guards: Guards = "checked",
    ) -> None:
        self.graph = graph
        self.known = given
        self._guards = guards
        self._leaf = leaf
        self._vectors: dict[int, list[Row]] = {}

    def __call__(self, node: int) -> Row:
        """Return the row of a node."""
        if node not in self.known:
            self._fill(node)
        return _settled(self.graph, node, self.known)

    def through(self, node: int) -> Row:
        """Return the row of a node from its operands' rows, whatever was given for it."""
        for operand in self.graph.operands(node):
            self(operand)
        row = _row(self.graph, node, self.known, self._vectors, self._guards)
        return _without_roots(self.graph, row, self.known)

    def _fill(self, root: int) -> None:
        graph, known = self.graph, self.known
        stack = [root]
        while stack:
            node = stack[-1]
            if node in known:
                stack.pop()
                continue
            missing = [n for n in graph.operands(node) if n not in known]
            if missing:
                stack += missing
                continue
            stack.pop()
            if graph.ops[node] == "input":
                known[node] = self._leaf(node) if self._leaf else {}
            else:
                known[node] = _row(graph, node, known, self._vectors, self._guards)


def _row(
    g: Graph,
    node: int,
    rows: dict[int, Row],
    vectors: dict[int, list[Row]],
    guards: Guards,
) -> Row:
    op, args = g.ops[node], g.args[node]
    if op == "sum":
        return _combine(g, [(rows[n], None, c) for n, c in args[1]])
    if op == "prod":
        parts = []
        for k, (n, e) in enumerate(args):
            if rows[n]:
                others = [(m, f) for j, (m, f) in enumerate(args) if j != k]
                by_radicand = of_half_power(g, args, k)
                if by_radicand is not None:
                    parts.append((rows[g.args[n][0]], by_radicand, 1.0))
                else:
                    parts.append((rows[n], g.product([*others, (n, e - 1)], float(e)), 1.0))
        return _combine(g, parts)
    if op == "select":
        condition, yes, no = args
        keys = sorted({*rows[yes], *rows[no]})
        zero = g.zero
        return {
            k: g.call("select", condition, rows[yes].get(k, zero), rows[no].get(k, zero))
            for k in keys
        }
    if op in ("factor", "solve", "guard"):
        for n in g.operands(node):
            _settled(g, n, rows)
    if op == "solve":
        vectors[node] = _solve_rows(g, node, args[0], args[1], rows)
        return {}
    if op == "guard":
        n, entries, column, sound, fast = args
        if is_symmetric(n, entries):
            # By the system that it solves: how the solution was found does not matter.
            factor = g.make("factor", ("ldl", n, entries))
            vectors[node] = _solve_rows(g, node, factor, column, rows)
        elif guards == "by systems":
            vectors[node] = _system_rows(g, ("lu", n, entries), column, rows)
        else:
            found = [rows[k] for k in fast]
            vectors[node] = found if guards == "as found" else _where_sound(g, sound, found)
        return {}
    if op == "item":
        row: Row = vectors[args[0]][args[1]]
        return row
    operation = OPERATIONS.get(op)
    if operation is None or operation.partials is None or not any(rows[n] for n in args):
        return {}  # constants, other inputs, steps, conditions, factors
    if rows[args[0]] and at_rest(g, node) is not None:
        by_root: Row = {-1 - node: g.one}
        if op == "sqrt":
            return by_root
        by_exponent = operation.partials(g, node, *args)[1]
        return _combine(g, [(by_root, None, 1.0), (rows[args[1]], by_exponent, 1.0)])
    partials = operation.partials(g, node, *args)
    if op == "sqrt" and g.ops[args[0]] in ("max", "min", "select"):
        # Where the radicand stays zero an infinite slope has no part in it.
        own = _settled(g, args[0], rows)
        slopes = _combine(g, [(own, partials[0], 1.0)])
        still = {k: g.call("eq", d, g.zero) for k, d in own.items()}
        return {k: g.call("select", still[k], g.zero, d) for k, d in slopes.items()}
    return _combine(g, [(rows[n], d, 1.0) for n, d in zip(args, partials, strict=True)])


def _settled(g: Graph, node: int, rows: dict[int, Row]) -> Row:
    """Return the row of a node by the variables alone, from now on."""
    if any(key < 0 for key in rows[node]):
        rows[node] = _without_roots(g, rows[node], rows)
    return rows[node]


def _without_roots(g: Graph, row: Row, rows: dict[int, Row]) -> Row:
    """Return a row by the variables alone, not by roots."""
    while (key := min(row, default=0)) < 0:
        others = {k: d for k, d in row.items() if k != key}
        by_radicand = slope(g, -1 - key, row[key])
        row = _combine(g, [(others, None, 1.0), (rows[g.args[-1 - key][0]], by_radicand, 1.0)])
    return row


def _where_sound(g: Graph, sound: int, rows: Sequence[Row]) -> list[Row]:
    """Return rows whose derivatives are NaN where a guard is not sound.

    They are guarded themselves, which takes no operation while it is sound. The matrix is not
    symmetric: their own derivatives are then those of what was found, too.
    """
    result: list[Row] = [{} for _ in rows]
    for key in sorted({key for row in rows for key in row}):
        places = [k for k, row in enumerate(rows) if key in row]
        known = [rows[k][key] for k in places]
        known += [g.zero] * (2 - len(known))
        n = len(known)
        cells = [[g.one if i == j else g.zero for j in range(n)] for i in range(n)]
        cells[0][1] = g.one
        found = g.guard(cells, [g.const(math.nan)] * n, sound, known)[: len(places)]
        for k, d in zip(places, found, strict=True):
            result[k][key] = d
    return result


def times(g: Graph, a: int, b: int) -> int:
    """Return a product of slopes; beyond a switch that leaves it out one may be infinite."""
    for switch, other in ((a, b), (b, a)):
        if g.ops[switch] == "select" and g.zero in g.args[switch][1:]:
            which, *ends = g.args[switch]
            return g.call("select", which, *(times(g, end, other) for end in ends))
    return g.mul(a, b)


def _combine(g: Graph, parts: Sequence[tuple[Row, int | None, float]]) -> Row:
    """Return Σ coefficient · factor · row."""
    terms: dict[int, list[tuple[int, float]]] = {}
    for row, factor, coefficient in parts:
        for key, d in row.items():
            product = d if factor is None else times(g, d, factor)
            terms.setdefault(key, []).append((product, coefficient))
    return {k: g.sum(t) for k, t in terms.items()}


def _solve_rows(
    g: Graph, node: int, factor: int, column: Sequence[int], rows: dict[int, Row]
) -> list[Row]:
    x = [g.make("item", (node, k)) for k in range(len(column))]
    return _implicit_rows(g, g.args[factor], x, column, rows, partial(g.solve_factored, factor))


def _system_rows(
    g: Graph, system: tuple[str, int, Sequence[int]], column: Sequence[int], rows: dict[int, Row]
) -> list[Row]:
    """Differentiate the solution of a guard's system; its `fast` need not have all unknowns."""
    _, n, entries = system

    def solve(right: Sequence[int]) -> list[int]:
        never = g.boolean(False)
        node = g.make("guard", (n, entries, tuple(right), never, (g.zero,) * n))
        return [g.make("item", (node, k)) for k in range(n)]

    return _implicit_rows(g, system, solve(column), column, rows, solve)


def _implicit_rows(
    g: Graph,
    system: tuple[str, int, Sequence[int]],
    x: Sequence[int],
    column: Sequence[int],
    rows: dict[int, Row],
    solve: Callable[[list[int]], list[int]],
) -> list[Row]:
    kind, n, entries = system
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
        for i, d in enumerate(solve(right)):
            if d != g.zero:
                result[i][key] = d
    return result
