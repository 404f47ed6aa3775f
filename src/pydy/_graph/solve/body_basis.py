"""Write equations of motion in the bodies' own speeds, where the given speeds are relative.

In a chain of bodies the last one often has speeds that are its angular velocity less what the other
speeds give it. In the mass matrix their block D is then diagonal and constant, their columns are
C = W D + a, where W says how fast each other speed turns the body, and everywhere else stand
products of W with the body's moments of inertia. With the body's whole angular velocity as
unknowns, in matrices

    M = | A   C |      T = | 1  −W |      T M Tᵀ = | A − W aᵀ − C Wᵀ   a |
        | Cᵀ  D |          | 0   1 |               | aᵀ                D |

these products are gone from the matrix and from the right-hand side T b: what is left of the body
there is a mass at its joint. (So are articulated-body inertias made; Featherstone, Rigid Body
Dynamics Algorithms, 2008, ch. 7.) The block of the body before it is then constant too, and so on
to the first one. The given unknowns are ``x = Tᵀ y``.

Any W gives the right solution. To see the products cancel, entries are written as polynomials in
the constants of D.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from itertools import product

from pydy._graph.counting import operations
from pydy._graph.derivative import jacobian
from pydy._graph.identities import signatures
from pydy._graph.node import Graph
from pydy._graph.passes.merge import merge_equal
from pydy._graph.rewrite import substitute
from pydy._graph.tuning import LONGEST_BODY_POLYNOMIAL, MOST_SPEEDS_OF_A_BODY

__all__ = ["BodyBasis", "body_basis"]

# Powers of constants, and for each product of them the node it is multiplied by.
_Powers = tuple[tuple[int, int], ...]
_Polynomial = dict[_Powers, int]
# The sign of a product, and its factors.
_Product = tuple[float, tuple[int, ...]]
_Places = dict[tuple[int, int], int]


def body_basis(
    graph: Graph, matrix: Sequence[Sequence[int]], column: Sequence[int]
) -> BodyBasis | None:
    """Return a symmetric system in other unknowns that takes fewer operations, or None.

    Parameters
    ----------
    graph : Graph
    matrix : sequence of sequences of nodes, n by n
        Its lower triangle is read.
    column : sequence of nodes
    """
    basis = BodyBasis(graph, matrix, column)
    given, end = basis.nodes(), len(matrix)
    with suppress(_TooLongError):  # the bodies that are done stay so
        while (own := basis.own(end)) and basis.change(own):
            end = own.start
    if 2 * end > len(matrix):  # it pays along a chain only, not for its last body
        return None
    # What is left of a long sum is often equal to something short; `simplify` finds it again.
    merged = merge_equal(graph, basis.nodes())
    return basis if operations(graph, merged) < operations(graph, given) else None


class BodyBasis:
    """A symmetric linear system, and how its unknowns give those of another one.

    Attributes
    ----------
    matrix : list of list of nodes
    column : list of nodes
    """

    def __init__(
        self, graph: Graph, matrix: Sequence[Sequence[int]], column: Sequence[int]
    ) -> None:
        n = len(matrix)
        self.graph = graph
        self.matrix = [[matrix[max(i, j)][min(i, j)] for j in range(n)] for i in range(n)]
        self.column = list(column)
        self._changes: list[_Places] = []  # each one a W

    def given_unknowns(self, y: Sequence[int]) -> list[int]:
        """Return the unknowns of the first system from those of this one."""
        graph, x = self.graph, list(y)
        for w in reversed(self._changes):
            terms = [[(node, 1.0)] for node in x]
            for (i, k), node in w.items():
                terms[k].append((graph.mul(node, x[i]), -1.0))
            x = [graph.sum(part) for part in terms]
        return x

    def nodes(self) -> list[int]:
        """Return all that a solution is made of: matrix, column, and the way back."""
        n = len(self.matrix)
        lower = [self.matrix[i][j] for i in range(n) for j in range(i + 1)]
        return [*lower, *self.column, *(node for w in self._changes for node in w.values())]

    def own(self, end: int) -> range:
        """Return the unknowns before `end` with a diagonal block of constants, written as such."""
        graph, m = self.graph, self.matrix
        start = end
        while start > max(end - MOST_SPEEDS_OF_A_BODY, 0):
            k = start - 1
            self._settle([(k, j) for j in range(k, end)])
            if not graph.constant[m[k][k]] or any(m[k][j] != graph.zero for j in range(start, end)):
                break
            start = k
        return range(start, end)

    def _settle(self, places: Sequence[tuple[int, int]]) -> None:
        """Write entries that are the same in every state without the state."""
        graph, m = self.graph, self.matrix
        places = [(i, j) for i, j in places if not graph.constant[m[i][j]]]
        if not places:
            return
        nodes = [m[i][j] for i, j in places]
        moving = [n for n in graph.reachable(nodes) if graph.ops[n] == "input"]
        moving = [n for n in moving if not graph.constant[n]]
        fixed = substitute(graph, nodes, dict.fromkeys(moving, graph.zero))
        values = signatures(graph, [*nodes, *fixed])
        both = zip(values[: len(nodes)], values[len(nodes) :], strict=True)
        for (i, j), node, (value, rest) in zip(places, fixed, both, strict=True):
            if value == rest:
                m[i][j] = m[j][i] = node

    def change(self, own: range) -> bool:
        """Take whole angular velocities for the unknowns `own`, if the ones before turn them."""
        graph, m = self.graph, self.matrix
        before, beyond = range(own.start), range(own.stop, len(m))
        w = _turning(graph, {k: m[k][k] for k in own}, {k: m[k][: own.start] for k in own})
        if not w:
            return False
        diagonal = [m[k][k] for k in own]
        constants = [n for n in graph.reachable(diagonal) if graph.ops[n] == "input"]
        polynomials = _Polynomials(graph, constants)
        a = {(i, k): m[i][k] for i in before for k in own}
        a |= polynomials.collected(
            {(i, k): [(1.0, (m[i][k],)), (-1.0, (node, m[k][k]))] for (i, k), node in w.items()}
        )
        sums: dict[tuple[int, int], list[_Product]] = {}
        for i in before:
            sums[i, -1] = [(1.0, (self.column[i],))]
            for j in (*range(i + 1), *beyond):
                sums[i, j] = [(1.0, (m[i][j],))]
        for (i, k), node in w.items():
            sums[i, -1].append((-1.0, (node, self.column[k])))
            for j in range(i + 1):
                sums[i, j].append((-1.0, (node, a[j, k])))
            for j in range(i, own.start):
                sums[j, i].append((-1.0, (node, m[j][k])))
            for j in beyond:
                sums[i, j].append((-1.0, (node, m[k][j])))
        for (i, j), node in (a | polynomials.collected(sums)).items():
            if j < 0:
                self.column[i] = node
            else:
                m[i][j] = m[j][i] = node
        self._changes.append(w)
        return True


def _turning(
    graph: Graph, diagonal: Mapping[int, int], columns: Mapping[int, Sequence[int]]
) -> _Places:
    """Return W, without its zeros: what multiplies a body's moments of inertia in its columns.

    A moment of inertia is a constant that one entry of the diagonal alone has, to the first power.
    """
    inputs = [k for k in graph.reachable(diagonal.values()) if graph.ops[k] == "input"]
    slopes = dict(zip(diagonal, jacobian(graph, list(diagonal.values()), inputs), strict=True))
    found: _Places = {}
    for k, slope in slopes.items():
        for place, node in slope.items():
            alone = all(place not in other for j, other in slopes.items() if j != k)
            size = graph.value(node)
            if alone and size:
                for i, share in enumerate(jacobian(graph, columns[k], [inputs[place]])):
                    found[i, k] = graph.sum([(share.get(0, graph.zero), 1.0 / size)])
                break
    return {place: node for place, node in found.items() if node != graph.zero}


class _TooLongError(Exception):
    """A polynomial has too many terms."""


class _Polynomials:
    """Nodes as polynomials in some inputs; None stands for a node that has none of them."""

    def __init__(self, graph: Graph, variables: Iterable[int]) -> None:
        self.graph = graph
        self._known: dict[int, _Polynomial | None] = {k: {((k, 1),): graph.one} for k in variables}
        self._joined: dict[tuple[_Powers, _Powers], _Powers] = {}

    def collected(self, sums: Mapping[tuple[int, int], Sequence[_Product]]) -> _Places:
        """Return sums of products with like powers collected, and without what vanishes."""
        graph, found = self.graph, {}
        for place, parts in sums.items():
            found[place] = self._sum([(sign, self._product(nodes)) for sign, nodes in parts])
        nodes = [node for terms in found.values() for node in terms.values()]
        zeros = {n for n, value in zip(nodes, signatures(graph, nodes), strict=True) if not value}
        written: _Places = {}
        for place, terms in found.items():
            kept = [(powers, n) for powers, n in terms.items() if n not in zeros]
            written[place] = graph.sum([(graph.product([(n, 1), *p]), 1.0) for p, n in kept])
        return written

    def _of(self, root: int) -> _Polynomial:
        known, stack = self._known, [root]
        while stack:
            node = stack[-1]
            missing = [n for n in self.graph.operands(node) if n not in known]
            if node not in known and missing:
                stack += missing
                continue
            stack.pop()
            if node not in known:
                known[node] = self._made(node)
        found = known[root]
        return {(): root} if found is None else found

    def _made(self, node: int) -> _Polynomial | None:
        graph, known = self.graph, self._known
        op, args = graph.ops[node], graph.args[node]
        moving = [n for n in graph.operands(node) if known[n] is not None]
        if not moving or op not in ("sum", "prod"):
            return None
        if op == "sum":
            parts = [(c, self._of(n)) for n, c in args[1]]
            return self._sum([*parts, (args[0], {(): graph.one})] if args[0] else parts)
        if any(e < 0 and n in moving for n, e in args):
            return None
        rest = graph.product([(n, e) for n, e in args if n not in moving])
        return self._product([rest, *(n for n, e in args if n in moving for _ in range(e))])

    def _sum(self, parts: Sequence[tuple[float, _Polynomial]]) -> _Polynomial:
        graph = self.graph
        terms: dict[_Powers, list[tuple[int, float]]] = {}
        for sign, part in parts:
            for powers, node in part.items():
                terms.setdefault(powers, []).append((node, sign))
        if len(terms) > LONGEST_BODY_POLYNOMIAL:
            raise _TooLongError
        sums = {powers: graph.sum(nodes) for powers, nodes in terms.items()}
        return {powers: node for powers, node in sums.items() if node != graph.zero}

    def _product(self, nodes: Sequence[int]) -> _Polynomial:
        result = self._of(nodes[0])
        for node in nodes[1:]:
            result = self._times(result, self._of(node))
        return result

    def _times(self, a: _Polynomial, b: _Polynomial) -> _Polynomial:
        joined, one, mul = self._joined, self.graph.one, self.graph.mul
        terms: list[tuple[_Powers, int]] = []
        for (first, x), (second, y) in product(a.items(), b.items()):
            if (first, second) not in joined:
                powers = Counter(dict(first))
                powers.update(dict(second))
                joined[first, second] = tuple(sorted(powers.items()))
            node = y if x == one else x if y == one else mul(x, y)
            terms.append((joined[first, second], node))
        if len(a) == 1 or len(b) == 1:  # no two powers meet
            return dict(terms)
        return self._sum([(1.0, {powers: node}) for powers, node in terms])
