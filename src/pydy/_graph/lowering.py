"""From the n-ary graph to a Program of elementary operations.

Operations on constants alone are grouped, so that the setup stage executes them. Denominators that
occur more than once become one reciprocal. Linear solves are unrolled or left to a loop.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

from pydy._graph.node import Graph
from pydy._graph.passes.share import is_pair, share_pairs
from pydy._graph.solve.choose import Factor, factorised
from pydy._program import OPERATIONS, Program, Tape


def lower(
    graph: Graph,
    sizes: tuple[int, int, int],
    blocks: Sequence[tuple[str, tuple[int, ...], Sequence[int]]],
    *,
    sizes_of_matrices: tuple[int, int, int] | None = None,
) -> Program:
    """Return the Program that computes `blocks` of names, shapes, and nodes, row-major.

    The graph's inputs are ``('x', i)``, ``('t', 0)``, ``('r', i)`` and ``('p', i)``, with the
    `sizes` of all but the second. The matrices of linear solves depend on the first of these
    alone, as many as `sizes_of_matrices` says (by default all): pivots are chosen at random states
    of these inputs, so that further ones do not change the choice.
    """
    lowering = _Lowering(graph, sizes, sizes_of_matrices or sizes)
    return Program.from_tape(*lowering.run(blocks))


class _Lowering:
    def __init__(
        self,
        graph: Graph,
        sizes: tuple[int, int, int],
        sizes_of_matrices: tuple[int, int, int],
    ) -> None:
        self.graph = graph
        self.sizes = sizes
        self.sizes_of_matrices = sizes_of_matrices
        self.tape = Tape()
        self.new: dict[int, int] = {}
        self.hot: set[int] = set()
        self.deferred: set[int] = set()  # what fallbacks so far need, but not every call
        self.factors: dict[int, Factor] = {}
        self.uses_as_denominator: Counter[int] = Counter()
        self.products: dict[tuple[int, float], list[Any]] = {}
        self.below: dict[int, list[tuple[int, int]]] = {}
        self.sums: dict[int, list[Any]] = {}
        self.partial_sums: dict[int, tuple[int, bool]] = {}
        self.pairs: dict[int, int] = {}  # by identity: `products` and `sums` hold the trees

    def run(
        self,
        blocks: Sequence[tuple[str, tuple[int, ...], Sequence[int]]],
    ) -> tuple[Tape, tuple[int, int, int], list[tuple[str, tuple[int, ...], list[int]]]]:
        roots = [n for _, _, nodes in blocks for n in nodes]
        graph = self.graph
        order = graph.reachable(roots)
        # Computed at every call. What only fallbacks need is not optimised.
        hot = set(graph.reachable(roots, fallbacks=False))
        for node in order:
            if graph.ops[node] == "prod":
                self.uses_as_denominator.update(n for n, e in graph.args[node] if e < 0)
        self._plan_products(order, hot)
        self._plan_sums(order, hot)
        fixed = [n for n in order if graph.constant[n] or graph.ops[n] in Tape.never_deferred]
        self.hot = hot.union(graph.reachable(fixed, fallbacks=False))
        for node in order:
            self.tape.in_every_call = node in self.hot
            self.new[node] = self._node(node)
        return (
            self.tape,
            self.sizes,
            [(n, s, [self._output(k) for k in nodes]) for n, s, nodes in blocks],
        )

    def _output(self, node: int) -> int:
        """Return the value of an output; a truth value is 1 or 0."""
        value = self.new[node]
        if self.graph.ops[node] in OPERATIONS.truths:
            value = self.tape.make("select", value, self.tape.const(1.0), self.tape.const(0.0))
        return value

    def _node(self, node: int) -> int:
        op, args = self.graph.ops[node], self.graph.args[node]
        tape, new = self.tape, self.new
        if op == "sum":
            return self._sum(node)
        if op == "prod":
            return self._product(node, 1.0)
        if op == "const":
            return tape.const(args[0])
        if op in ("bool", "input"):
            return tape.make(op, *args)
        if op == "factor":
            kind, n, entries = args
            cells = [new[e] for e in entries]
            self.factors[node] = factorised(
                tape, kind, n, cells, self.sizes_of_matrices, self.graph.off
            )
            return -1
        if op == "solve":
            return self.factors[args[0]].solve([new[b] for b in args[1]])
        if op == "kept":
            return new[args[0]]
        if op == "item":
            return tape.make("item", new[args[0]], args[1])
        if op == "guard":
            n, entries, column, sound, fast = args
            self._fallback(node)
            parts = [tuple(new[k] for k in part) for part in (entries, column, fast)]
            return tape.make("guard", n, *parts[:2], new[sound], parts[2])
        return tape.make(op, *(new[a] for a in args))

    def _fallback(self, guard: int) -> None:
        """Repeat the operations of a guard's fallback for that guard, except function calls."""
        tape, graph = self.tape, self.graph
        if not tape.in_every_call:
            return
        _, entries, column, *_ = graph.args[guard]
        operations = [n for n in graph.reachable((*entries, *column)) if n not in self.hot]
        if not self.deferred.isdisjoint(operations):
            tape.in_every_call, tape.guard_of_fallback = False, guard
            for node in operations:
                self.new[node] = self._node(node)
            tape.in_every_call, tape.guard_of_fallback = True, None
        self.deferred.update(operations)

    # -- sums -------------------------------------------------------------------------------------

    def _plan_sums(self, order: list[int], hot: set[int]) -> None:
        """Choose the order in which the terms of each sum are added."""
        graph, constant = self.graph, self.graph.constant
        sums = [node for node in order if graph.ops[node] == "sum"]
        sums.sort(key=lambda node: node not in hot)
        count = sum(node in hot for node in sums)
        users = Counter((n, abs(c)) for node in sums[:count] for n, c in graph.args[node][1])

        def rank(term: tuple[tuple[int, float], bool]) -> tuple[bool, int, int]:
            # Constants first: their partial sum is then a value of the setup stage. Then the terms
            # of most sums, so that a run of shared terms stands together.
            operand = term[0]
            return (not constant[operand[0]], -users[operand], operand[0])

        rows = []
        for node in sums:
            terms = [((n, abs(c)), c > 0.0) for n, c in graph.args[node][1]]
            rows.append(sorted(terms, key=rank))
        self.sums = dict(zip(sums, rows, strict=True))
        if "share sums" not in self.graph.off:
            self.sums.update(zip(sums[:count], share_pairs(rows[:count]), strict=True))

    def _sum(self, node: int) -> int:
        tape = self.tape
        c0 = self.graph.args[node][0]
        terms = [self._term(*term) for term in self.sums[node]]
        terms.sort(key=lambda item: not tape.constant[item[0]])
        if c0:
            terms.insert(0, (tape.const(abs(c0)), c0 > 0))
        value, positive = terms[0]
        for term, sign in terms[1:]:
            value, positive = self._added((value, positive), (term, sign))
        return value if positive else tape.neg(value)

    def _term(self, tree: Any, positive: bool) -> tuple[int, bool]:
        """Return a term as a value to add (True) or to subtract (False)."""
        if is_pair(tree):
            partial_sum = self.partial_sums.get(id(tree))
            if partial_sum is None:
                partial_sum = self._added(self._term(*tree[0]), self._term(*tree[1]))
                self.partial_sums[id(tree)] = partial_sum
        else:
            partial_sum = self._scaled(*tree)
        return partial_sum[0], partial_sum[1] is positive

    def _added(self, a: tuple[int, bool], b: tuple[int, bool]) -> tuple[int, bool]:
        tape = self.tape
        if a[1] == b[1]:
            return tape.add(a[0], b[0]), a[1]
        return (tape.sub(a[0], b[0]), True) if a[1] else (tape.sub(b[0], a[0]), True)

    def _scaled(self, node: int, size: float) -> tuple[int, bool]:
        """Return ``size · node`` as a value to add (True) or to subtract (False)."""
        tape = self.tape
        if size == 1.0:
            value = self.new[node]
        elif (node, size) in self.products:
            value = self._product(node, size)
        else:
            value = tape.mul(tape.const(size), self.new[node])
        if tape.ops[value] == "neg":
            return tape.args[value][0], False
        return value, True

    # -- products ---------------------------------------------------------------------------------

    def _plan_products(self, order: list[int], hot: set[int]) -> None:
        """Choose the order in which the factors of each product are multiplied.

        The factors that depend on constants alone are grouped, with the coefficient of the sum in
        which the product stands, into one factor that the setup stage computes.
        """
        graph = self.graph
        constant = graph.constant
        occurring: dict[tuple[int, float], None] = {}
        for node in order:
            if graph.ops[node] == "prod":
                occurring[node, 1.0] = None
            elif graph.ops[node] == "sum":
                for term, coefficient in graph.args[node][1]:
                    size = abs(coefficient)
                    product = size != 1.0 and graph.ops[term] == "prod"
                    if product and any(constant[n] for n, _ in graph.args[term]):
                        occurring[term, size] = None
        factors: list[list[Any]] = []
        products = sorted(occurring, key=lambda pair: pair[0] not in hot)
        count = sum(node in hot for node, _ in products)
        for node, size in products:
            fixed = tuple(pair for pair in graph.args[node] if constant[pair[0]])
            moving = [pair for pair in graph.args[node] if not constant[pair[0]]]
            above = [("power", *pair) for pair in moving if self._multiplies(*pair)]
            self.below[node] = [pair for pair in moving if not self._multiplies(*pair)]
            if fixed or size != 1.0:
                above.insert(0, ("fixed", fixed, size))
            factors.append(above)
        if "share products" not in self.graph.off:
            shared = share_pairs([[(factor, True) for factor in row] for row in factors[:count]])
            factors[:count] = [[tree for tree, _ in row] for row in shared]
        self.products = dict(zip(products, factors, strict=True))

    def _multiplies(self, node: int, exponent: int) -> bool:
        # A denominator that occurs more than once becomes a reciprocal.
        return exponent > 0 or self.uses_as_denominator[node] > 1

    def _product(self, node: int, size: float) -> int:
        tape = self.tape
        top = self._chain([self._factor(tree) for tree in self.products[node, size]])
        below = [tape.power(self.new[n], -e) for n, e in self.below[node]]
        bottom = self._chain(below)
        if bottom is None:
            return tape.const(1.0) if top is None else top
        return tape.div(tape.const(1.0) if top is None else top, bottom)

    def _factor(self, tree: Any) -> int:
        tape = self.tape
        if is_pair(tree):
            product = self.pairs.get(id(tree))
            if product is None:
                product = tape.mul(self._factor(tree[0][0]), self._factor(tree[1][0]))
                self.pairs[id(tree)] = product
            return product
        if tree[0] == "power":
            return self._power(tree[1], tree[2])
        _, fixed, size = tree
        values = [self._power(n, e) for n, e in fixed]
        if size != 1.0:
            values.append(tape.const(size))
        result = self._chain(values)
        assert result is not None
        return result

    def _power(self, node: int, exponent: int) -> int:
        tape, base = self.tape, self.new[node]
        if exponent < 0:
            base = tape.div(tape.const(1.0), base)
        return tape.power(base, abs(exponent))

    def _chain(self, factors: list[int]) -> int | None:
        tape = self.tape
        ordered = sorted(factors, key=lambda n: (not tape.constant[n], n))
        result: int | None = None
        for node in ordered:
            result = node if result is None else tape.mul(result, node)
        return result
