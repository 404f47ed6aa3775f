"""Multiply short sums out where factors then meet.

In ``Σ k[j]·(a·c[j] − b·s[j])`` nothing is common to two terms. Multiplied out it is
``a·Σ k[j]·c[j] − b·Σ k[j]·s[j]``: the same number of operations, but the inner sums hold neither a
nor b, and other rows have parts of them too.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING

from pydy._graph.node import Graph
from pydy._graph.passes.factor import Term, factored, terms_of
from pydy._graph.rewrite import make_canonical, rebuild
from pydy._graph.tuning import LONGEST_MULTIPLIED_OUT

if TYPE_CHECKING:
    from pydy._program import Args


def expand_sums(graph: Graph, roots: Sequence[int]) -> list[int]:
    """Multiply short sums out inside sums, and take common factors out again.

    Left alone are sums of constants, and sums of two exact values or more, such as x − y of two
    inputs: ``k·(x − y)`` loses nothing where x and y nearly agree, ``k·x − k·y`` does.
    """
    return _Expansion(graph, roots).run(roots)


def is_exact(graph: Graph, node: int) -> bool:
    """Return whether a node is a sum of two exact values or more, which may cancel."""
    if graph.ops[node] != "sum":
        return False
    c0, terms = graph.args[node]
    exact = [n for n, c in terms if abs(c) == 1.0 and graph.ops[n] == "input"]
    return len(exact) + bool(c0) > 1


class _Expansion:
    def __init__(self, graph: Graph, roots: Sequence[int]) -> None:
        self.graph = graph
        self.short: dict[int, set[int] | None] = {}
        self.uses: Counter[int] = Counter(roots)
        for node in graph.reachable(roots):
            self.uses.update(graph.operands(node))

    def run(self, roots: Sequence[int]) -> list[int]:
        return rebuild(self.graph, roots, self._rule)

    def _rule(self, node: int, op: str, args: Args) -> int:
        graph = self.graph
        same = args == graph.args[node]
        if op == "sum" and len(args[1]) > 1:
            new = self._expanded(node, args, same)
        elif op == "prod" and (cancelled := self._cancelled(dict(args))) is not None:
            new = cancelled
        else:
            new = node if same else make_canonical(graph, op, args)
        if new != node:
            self.uses[new] = max(self.uses[new], self.uses[node])
        return new

    def _cancelled(self, factors: dict[int, int]) -> int | None:
        """Return ``b·(x + y/b)`` as ``b·x + y``, which is defined where b is zero."""
        graph = self.graph
        for inner, exponent in factors.items():
            if exponent != 1 or self._factors_in(inner) is None:
                continue
            c0, pairs = graph.args[inner]
            terms = terms_of(graph, pairs)
            below = {n for inside, _, _ in terms for n, e in inside.items() if e < 0}
            if met := [(n, e) for n, e in factors.items() if n in below and e > 0]:
                cofactors = [
                    (n, e) for n, e in factors.items() if n != inner and n not in dict(met)
                ]
                new = [(graph.product([*met, *f.items()]), c) for f, c, _ in terms]
                sum_ = graph.sum([*new, (graph.product(met), c0)] if c0 else new)
                return graph.product([*cofactors, (sum_, 1)])
        return None

    def _expanded(self, node: int, args: Args, same: bool) -> int:
        """Return a sum multiplied out and factored again, if there is anything to do."""
        graph = self.graph
        c0, pairs = args
        terms = terms_of(graph, pairs)
        popular = self._popular(terms)
        powers = [power for factors, _, _ in terms for power in factors.items()]
        if not any(self._is_to_expand(*power, popular) for power in powers):
            return node if same else factored(graph, terms, c0)
        waiting = terms[::-1]
        done: list[Term] = []
        limit = 4 * len(terms) + 16
        while waiting:
            term = waiting.pop()
            factors, coefficient, _ = term
            inner = next((n for n, e in factors.items() if self._is_to_expand(n, e, popular)), None)
            if inner is None or len(waiting) + len(done) > limit:
                done.append(term)
                continue
            cofactors = [(n, e) for n, e in factors.items() if n != inner]
            inner_c0, inner_terms = graph.args[inner]
            products = [(graph.product([*cofactors, (n, 1)]), c) for n, c in inner_terms]
            if inner_c0:
                products.append((graph.product(cofactors), inner_c0))
            for product, c in products:
                value = graph.value(product)
                if value is None:
                    waiting += terms_of(graph, [(product, coefficient * c)])
                else:
                    c0 += coefficient * c * value
        return factored(graph, done, c0)

    def _popular(self, terms: list[Term]) -> set[int]:
        """Return the factors that many terms have, or would have with sums multiplied out."""
        counts: Counter[int] = Counter()
        for factors, _, _ in terms:
            factors_after = {n for n in factors if not self.graph.constant[n]}
            for node, exponent in factors.items():
                if exponent == 1:
                    factors_after |= self._factors_in(node) or set()
            counts.update(factors_after)
        return {n for n, count in counts.items() if count >= 3}

    def _is_to_expand(self, node: int, exponent: int, popular: set[int]) -> bool:
        """Tell whether a factor is to be multiplied out."""
        inside = self._factors_in(node) if exponent == 1 else None
        if inside is None:
            return False
        return self.uses[node] == 1 or not popular.isdisjoint(inside)

    def _factors_in(self, node: int) -> set[int] | None:
        """Return the factors of the terms of a short sum, None for any other node."""
        if node not in self.short:
            self.short[node] = self._find_factors(node)
        return self.short[node]

    def _find_factors(self, node: int) -> set[int] | None:
        graph = self.graph
        if graph.ops[node] != "sum" or graph.constant[node]:
            return None
        c0, terms = graph.args[node]
        if len(terms) + bool(c0) > LONGEST_MULTIPLIED_OUT.get(self.uses[node], 0):
            return None
        if is_exact(graph, node):
            return None
        nodes: set[int] = set()
        for n, _ in terms:
            nodes.update([m for m, _ in graph.args[n]] if graph.ops[n] == "prod" else [n])
        return nodes
