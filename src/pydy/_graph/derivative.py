"""Exact derivatives by differentiating the graph forward.

Each node gets a sparse row ``{variable: node}`` of its partial derivatives, so the cost follows
the structure that is there. Linear solves are differentiated by the implicit rule: from ``A x = b``
follows ``A x' = b' − A' x``, one more right-hand side for the factors that exist already, instead
of a derivative of the elimination (Griewank & Walther, Evaluating Derivatives, 2nd ed., §15.1).

A root that may be at rest is a variable too, as −1 − root, until it is known what is made of it
(`pydy._graph.roots`).

The derivative of a guard is a guard, of the same matrix and condition: where it is sound, the
derivative of what was found in the other way, and else the solution of ``A x' = b' − A' x``. With a
positive definite matrix it is the first everywhere: elimination is stable in any order there
(Higham, Accuracy and Stability, 2nd ed., ch. 10), that of bodies has more digits than their matrix,
and A' would be several times the code of all else.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence

from pydy._graph.linear_system import solve_factored
from pydy._graph.node import Graph
from pydy._graph.roots import is_carried, is_steep, of_half_power, slope
from pydy._program import OPERATIONS, symmetric

Row = dict[int, int]


class SparseRows(list[Row]):
    """Derivatives of nodes: for each a dict from the number of a column to the derivative's node.

    Entries that are not there are zero by structure.
    """

    def __init__(self, rows: Iterable[Row], zero: int, width: int) -> None:
        super().__init__(rows)
        self._zero, self._width = zero, width

    def dense(self) -> list[list[int]]:
        """Return all entries, as a list of rows."""
        return [[row.get(k, self._zero) for k in range(self._width)] for row in self]

    def flat(self) -> list[int]:
        """Return all entries as one list, row by row."""
        return [row.get(k, self._zero) for row in self for k in range(self._width)]


def jacobian(graph: Graph, outputs: Sequence[int], variables: Sequence[int]) -> SparseRows:
    """Return the derivatives of outputs by variables, which are columns in their order.

    At a switch (``abs``, ``sign``, ``min``, ``max``, Piecewise) the derivative is the one on the
    same side for all that switch there, see `pydy._graph.one_sided`; steps have derivative zero.
    """
    seeds: dict[int, Row] = {}
    for k, node in enumerate(variables):  # of which one may be there several times
        seeds.setdefault(node, {})[k] = graph.one
    # An entry of a matrix depends on few variables, a residual on many.
    return _derivatives(graph, outputs, seeds, len(variables), by_residuals=False)


def hessian(graph: Graph, node: int, variables: Sequence[int]) -> tuple[list[int], list[list[int]]]:
    """Return the first and second derivatives of a node, these symmetric to the last bit."""
    first, n = jacobian(graph, [node], variables).flat(), range(len(variables))
    rows = jacobian(graph, first, variables).dense()
    return first, [[rows[max(i, j)][min(i, j)] for j in n] for i in n]


def directional(
    graph: Graph, outputs: Sequence[int], seeds: Mapping[int, Row], directions: int = 1
) -> SparseRows:
    """Return the derivatives of `outputs` along several directions, which are the columns.

    The `seeds` are the directions' components, for each variable a dict from the number of the
    direction to a node.
    """
    return _derivatives(graph, outputs, seeds, directions)


def _derivatives(
    graph: Graph,
    outputs: Sequence[int],
    seeds: Mapping[int, Row],
    directions: int,
    *,
    by_residuals: bool = True,
) -> SparseRows:
    rows: dict[int, Row] = dict(seeds)
    vectors: dict[int, list[Row]] = {}
    for node in graph.reachable(outputs):
        if node not in rows:
            rows[node] = _row(graph, node, rows, vectors, by_residuals=by_residuals)
    zero = graph.zero
    final = [_without_roots_stored(graph, n, rows) for n in outputs]
    nonzero = [{k: d for k, d in sorted(row.items()) if d != zero} for row in final]
    return SparseRows(nonzero, zero, directions)


def on_side(g: Graph, node: int) -> int:
    """Return a node at a switch on the side that derivatives belong to."""
    if not g.has_steps:
        return node
    from pydy._graph.one_sided import sides_of  # most models do not switch

    return sides_of(g, DerivativeRows).one_sided(node)


def partials_on_side(g: Graph, node: int) -> list[int]:
    """Return the partial derivatives of a function, on the side that derivatives belong to."""
    op, args = g.ops[node], g.args[node]
    partials = OPERATIONS[op].partials
    if partials is None:
        raise TypeError(f"{op} has no derivatives")
    return [on_side(g, n) for n in partials(g, node, *args)]


def condition_on_side(g: Graph, select: int) -> int:
    """Return the condition of a ``select`` on the side that its derivative belongs to."""
    if not g.has_steps:
        return int(g.args[select][0])
    from pydy._graph.one_sided import sides_of

    return sides_of(g, DerivativeRows).condition_on_side(select)


class DerivativeRows:
    """Sparse rows of derivatives, each made once. Differentiation stops at nodes with a seed.

    A row maps variables, any integers, to the node of the derivative. A `leaf` gives the row of an
    input without a seed; by default such an input has no derivatives.
    """

    def __init__(
        self,
        graph: Graph,
        seeds: dict[int, Row],
        leaf: Callable[[int], Row] | None = None,
    ) -> None:
        self.graph = graph
        self.stored = seeds
        self._leaf = leaf
        self._vectors: dict[int, list[Row]] = {}

    def __call__(self, node: int) -> Row:
        """Return the row of a node."""
        if node not in self.stored:
            self._fill(node)
        return _without_roots_stored(self.graph, node, self.stored)

    def from_operands(self, node: int) -> Row:
        """Return the row of a node from its operands' rows, even if it has a seed."""
        for operand in self.graph.operands(node):
            self(operand)
        row = _row(self.graph, node, self.stored, self._vectors)
        return _without_roots(self.graph, row, self.stored)

    def _fill(self, root: int) -> None:
        graph, stored = self.graph, self.stored
        stack = [root]
        while stack:
            node = stack[-1]
            if node in stored:
                stack.pop()
                continue
            missing = [n for n in graph.operands(node) if n not in stored]
            if missing:
                stack += missing
                continue
            stack.pop()
            if graph.ops[node] == "input":
                stored[node] = self._leaf(node) if self._leaf else {}
            else:
                stored[node] = _row(graph, node, stored, self._vectors)


def _row(
    g: Graph,
    node: int,
    rows: dict[int, Row],
    vectors: dict[int, list[Row]],
    *,
    by_residuals: bool = True,
) -> Row:
    op, args = g.ops[node], g.args[node]
    if op == "sum":
        return _combine(g, [(rows[n], None, c) for n, c in args[1]])
    if op == "prod":
        parts = []
        for k, (n, e) in enumerate(args):
            if rows[n]:
                cofactors = [(on_side(g, m), f) for j, (m, f) in enumerate(args) if j != k]
                by_radicand = of_half_power(g, args, k)
                if by_radicand is not None:
                    parts.append((rows[g.args[n][0]], on_side(g, by_radicand), 1.0))
                else:
                    parts += _product_parts(g, (n, e), cofactors, rows)
        return _combine(g, parts)
    if op == "select":
        condition, yes, no = condition_on_side(g, node), *args[1:]
        keys = {*rows[yes], *rows[no]}
        # What a branch does not depend on has derivative zero there, NaN where its value is.
        absent = [undefined(g, n) if keys - rows[n].keys() else g.zero for n in (yes, no)]
        return {
            k: g.call("select", condition, rows[yes].get(k, absent[0]), rows[no].get(k, absent[1]))
            for k in sorted(keys)
        }
    if op in OPERATIONS.solves:
        for n in g.operands(node):
            _without_roots_stored(g, n, rows)
    if op == "solve":
        vectors[node] = _solve_rows(g, node, rows, vectors, by_residuals)
        return {}
    if op == "guard":
        vectors[node] = _guard_rows(g, node, rows)
        return {}
    if op == "item":
        row: Row = vectors[args[0]][args[1]]
        return row
    operation = OPERATIONS.get(op)
    if operation is None or operation.partials is None or not any(rows[n] for n in args):
        return {}  # constants, other inputs, steps, conditions, factors
    switched = op == "sqrt" and g.ops[args[0]] in ("max", "min", "select")
    if rows[args[0]] and not switched and is_carried(g, node):
        by_root: Row = {-1 - node: g.one}
        if op != "pow":
            return by_root
        by_exponent = partials_on_side(g, node)[1]
        return _combine(g, [(by_root, None, 1.0), (rows[args[1]], by_exponent, 1.0)])
    partials = partials_on_side(g, node)
    if switched:
        # Where the radicand stays zero an infinite slope has no part in it.
        radicand_row = _without_roots_stored(g, args[0], rows)
        slopes = _combine(g, [(radicand_row, partials[0], 1.0)])
        stationary = {k: g.call("eq", d, g.zero) for k, d in radicand_row.items()}
        return {k: g.call("select", stationary[k], g.zero, d) for k, d in slopes.items()}
    return _combine(g, [(rows[n], d, 1.0) for n, d in zip(args, partials, strict=True)])


def _without_roots_stored(g: Graph, node: int, rows: dict[int, Row]) -> Row:
    """Return the row of a node by the variables alone, and store it."""
    if any(key < 0 for key in rows[node]):
        rows[node] = _without_roots(g, rows[node], rows)
    return rows[node]


def _without_roots(g: Graph, row: Row, rows: dict[int, Row]) -> Row:
    """Return a row by the variables alone, not by roots."""
    while (key := min(row, default=0)) < 0:
        remaining = {k: d for k, d in row.items() if k != key}
        by_radicand = slope(g, -1 - key, row[key])
        row = _combine(g, [(remaining, None, 1.0), (rows[g.args[-1 - key][0]], by_radicand, 1.0)])
    return row


def _product_parts(
    g: Graph, factor: tuple[int, int], cofactors: list[tuple[int, int]], rows: dict[int, Row]
) -> list[tuple[Row, int, float]]:
    """Return the parts of a product's derivative by one of its factors, with its power.

    A steep root in a sum is differentiated together with what the sum is multiplied by.
    """
    n, e = factor
    if e == 1 and cofactors:
        if _by_argument(g, n, cofactors):
            return [
                (
                    _without_roots_stored(g, g.args[n][0], rows),
                    slope(g, n, g.product(cofactors)),
                    1.0,
                )
            ]
        if g.ops[n] == "sum":
            terms = g.args[n][1]
            roots = [(m, c) for m, c in terms if _holds_root(g, m, cofactors)]
            if roots:
                without_roots = [(rows[m], None, c) for m, c in terms if (m, c) not in roots]
                parts = [(_combine(g, without_roots), g.product(cofactors), 1.0)]
                for m, c in roots:
                    inner = g.args[m] if g.ops[m] == "prod" else ((m, 1),)
                    for k, (root, power) in enumerate(inner):
                        others = [(on_side(g, o), f) for o, f in (*inner[:k], *inner[k + 1 :])]
                        inner_cofactors = [*others, *cofactors]
                        parts_of_root = _product_parts(g, (root, power), inner_cofactors, rows)
                        parts += [
                            (row, slope_of_row, c * weight)
                            for row, slope_of_row, weight in parts_of_root
                        ]
                return parts
    return [(rows[n], g.product([*cofactors, (on_side(g, n), e - 1)], float(e)), 1.0)]


def _holds_root(g: Graph, term: int, cofactors: Sequence[tuple[int, int]]) -> bool:
    factors = g.args[term] if g.ops[term] == "prod" else ((term, 1),)
    return any(e == 1 and _by_argument(g, m, cofactors) for m, e in factors)


def _by_argument(g: Graph, node: int, cofactors: Sequence[tuple[int, int]]) -> bool:
    """Return whether a root is differentiated by its argument together with its cofactors."""
    if g.ops[node] not in ("sqrt", "asin", "acos", "acosh") or not is_steep(g, node):
        return False
    if is_carried(g, node) or g.ops[g.args[node][0]] in ("max", "min", "select"):
        return False
    return any(not g.constant[m] for m, _ in cofactors)


def undefined(g: Graph, node: int) -> int:
    """Return a node that is NaN where a Piecewise has no branch that applies, else zero."""
    branches: list[tuple[int, int]] = []  # down the last branches, of which there may be many
    while g.ops[node] == "select":
        condition, yes, node = g.args[node]
        branches.append((condition, undefined(g, yes)))
    value = g.value(node)
    result = node if value is not None and math.isnan(value) else g.zero
    for condition, inner in reversed(branches):
        if inner != result:
            result = g.call("select", condition, inner, result)
    return result


def times(g: Graph, a: int, b: int) -> int:
    """Return a product of slopes; zero where a switch makes one zero, even if one is infinite."""
    for switch, factor in ((a, b), (b, a)):
        if g.ops[switch] == "select" and g.zero in g.args[switch][1:]:
            condition, *ends = g.args[switch]
            return g.call("select", condition, *(times(g, end, factor) for end in ends))
    return g.mul(a, b)


def _combine(g: Graph, parts: Sequence[tuple[Row, int | None, float]]) -> Row:
    """Return Σ coefficient · factor · row."""
    terms: dict[int, list[tuple[int, float]]] = {}
    for row, factor, coefficient in parts:
        for key, d in row.items():
            product = d if factor is None else times(g, d, factor)
            terms.setdefault(key, []).append((product, coefficient))
    return {k: g.sum(t) for k, t in terms.items()}


def residuals_of(g: Graph, solve: int, *, open_form: bool = False) -> list[int] | None:
    """Return the nodes b − A x of a solve node, or None; see `pydy._graph.residuals`."""
    from pydy._graph.residuals import residuals  # written-out Jacobians need none

    return residuals(g, solve, open_form=open_form)


def _solve_rows(
    g: Graph,
    node: int,
    rows: dict[int, Row],
    vectors: dict[int, list[Row]],
    by_residuals: bool,
) -> list[Row]:
    factor, column = g.args[node]
    x = [g.make("item", (node, k)) for k in range(len(column))]
    residual = residuals_of(g, node) if by_residuals else None
    if residual is None:
        rights = _system_slopes(g, g.args[factor], x, column, rows)
    else:
        rights = _residual_slopes(g, residual, node, x, rows, vectors)
    result: list[Row] = [{} for _ in column]
    for key, right in rights.items():
        for i, d in enumerate(solve_factored(g, factor, right)):
            if d != g.zero:
                result[i][key] = d
    return result


def _residual_slopes(
    g: Graph,
    residual: Sequence[int],
    solve: int,
    x: Sequence[int],
    rows: dict[int, Row],
    vectors: dict[int, list[Row]],
) -> dict[int, list[int]]:
    """Return r' of the residuals b − A x at a fixed solution x, for each key of their rows."""
    at_fixed: dict[int, Row] = {k: {} for k in x}
    free: dict[int, Row] = {}  # what was known of nodes that depend on the solution
    for node in g.reachable(residual):
        depends = node != solve and not at_fixed.keys().isdisjoint(g.operands(node))
        if node in at_fixed or depends:
            if node in rows:
                free[node] = rows[node]
            rows[node] = at_fixed[node] = _row(g, node, rows, vectors) if depends else {}
        elif node not in rows and node != solve:
            rows[node] = _row(g, node, rows, vectors)
    fixed = [dict(_without_roots_stored(g, n, rows)) for n in residual]
    for node in at_fixed:
        rows.pop(node, None)
    rows.update(free)
    keys = sorted({key for row in fixed for key in row})
    return {key: [row.get(key, g.zero) for row in fixed] for key in keys}


def definite(g: Graph, guard: int) -> int | None:
    """Return a zero that reports where a guard's matrix is singular; None if it may be any."""
    n, entries, _, sound, _ = g.args[guard]
    if n == 1 or g.ops[sound] == "bool" or symmetric(n, entries) != list(entries):
        return None
    zeros = (g.zero,) * n
    return g.make("item", (g.make("guard", (n, entries, zeros, sound, zeros)), 0))


def _guard_rows(g: Graph, node: int, rows: dict[int, Row]) -> list[Row]:
    n, entries, column, sound, fast = g.args[node]
    result: list[Row] = [{} for _ in column]
    if (judged := definite(g, node)) is not None:
        reported: set[int] = set()
        for row, k in zip(result, fast, strict=True):
            row.update(
                (key, d if key in reported else g.add(d, judged)) for key, d in rows[k].items()
            )
            reported.update(row)
        return result
    x = [g.make("item", (node, k)) for k in range(len(column))]
    slow: dict[int, list[int]] = {}
    for first in range(0, len(column), max(n, 1)):
        part = slice(first, first + n)
        for key, right in _system_slopes(
            g, ("lu", n, entries), x[part], column[part], rows
        ).items():
            slow.setdefault(key, [g.zero] * len(column))[part] = right
    never = g.ops[sound] == "bool" and not g.args[sound][0]
    keys_of_fast = sorted({key for k in fast for key in rows[k]})
    keys = sorted(slow) if never else keys_of_fast
    zeros = [g.zero] * len(column)
    rights = tuple(d for key in keys for d in slow.get(key, zeros))
    slopes = tuple(rows[k].get(key, g.zero) for key in keys for k in fast)
    derivative = g.make("guard", (n, entries, rights, sound, slopes))  # of no key, it is never used
    for position, key in enumerate(keys):
        for i, k in enumerate(fast):
            if never or key in rows[k]:
                result[i][key] = g.make("item", (derivative, position * len(column) + i))
    return result


def _system_slopes(
    g: Graph,
    system: tuple[str, int, Sequence[int]],
    x: Sequence[int],
    column: Sequence[int],
    rows: Mapping[int, Row],
) -> dict[int, list[int]]:
    """Return b' − A' x of a system A x = b, for each key of the rows of its entries and of b."""
    kind, n, entries = system
    entries = symmetric(n, entries) if kind == "ldl" else entries
    keys: set[int] = set()
    for e in (*entries, *column):
        keys.update(rows[e])
    result = {}
    for key in sorted(keys):
        right = []
        for i in range(n):
            terms = []
            if key in rows[column[i]]:
                terms.append((rows[column[i]][key], 1.0))
            for j in range(n):
                d = rows[entries[i * n + j]].get(key)
                if d is not None:
                    terms.append((g.mul(d, x[j]), -1.0))
            right.append(g.sum(terms))
        result[key] = right
    return result
