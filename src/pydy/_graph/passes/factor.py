"""Extract common factors from sums of products."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from pydy._graph.node import Graph
from pydy._graph.rewrite import make_canonical, rebuild

if TYPE_CHECKING:
    from pydy._program import Args

# The powers of a product, its coefficient, and its node, -1 where there may be none yet.
Term = tuple[dict[int, int], float, int]


def factor_sums(graph: Graph, roots: Sequence[int]) -> list[int]:
    """Extract common factors from sums of products, most frequent first.

    Factors that depend on the state go first: what is left inside the brackets is then more often
    a matter of constants alone, which is computed once for each set of them.
    """

    def rule(node: int, op: str, args: Args) -> int:
        if op != "sum" or len(args[1]) < 2:
            return node if args == graph.args[node] else make_canonical(graph, op, args)
        return factored(graph, terms_of(graph, args[1]), args[0])

    return rebuild(graph, roots, rule)


def terms_of(graph: Graph, pairs: Sequence[tuple[int, float]]) -> list[Term]:
    """Return the terms of a sum as products of powers."""
    terms: list[Term] = []
    for node, coefficient in pairs:
        scale, core = graph.scaled(node)
        op = graph.ops[core]
        powers = dict(graph.args[core]) if op == "prod" else {core: 1}
        # A sum as a factor may have another sign.
        terms.append((powers, coefficient * scale, -1 if op == "sum" else core))
    return terms


def factored(graph: Graph, terms: list[Term], c0: float) -> int:
    """Return Σ terms + c0, like terms collected and common factors taken out."""
    return _extract(graph, _collect(graph, terms), c0)


def _collect(graph: Graph, terms: list[Term]) -> list[Term]:
    """Join the terms whose state-dependent part is the same: their constants add up."""
    groups: dict[tuple[tuple[int, int], ...], list[Term]] = {}
    constant = graph.constant
    for term in terms:
        key = tuple([power for power in term[0].items() if not constant[power[0]]])
        groups.setdefault(key, []).append(term)
    collected: list[Term] = []
    for key, members in groups.items():
        if len(members) == 1 or not key:
            collected.extend(members)
            continue
        constant_parts = [
            ({n: e for n, e in f.items() if constant[n]}, c, -1) for f, c, _ in members
        ]
        inner = _extract(graph, constant_parts, 0.0, constant=True)
        scale, core = graph.scaled(inner)
        if graph.value(core) is not None:
            value = graph.value(core) or 0.0
            if value:
                collected.append((dict(key), scale * value, -1))
            continue
        factors = dict(key)
        if graph.ops[core] == "prod":
            for n, e in graph.args[core]:
                factors[n] = factors.get(n, 0) + e
        else:
            factors[core] = factors.get(core, 0) + 1
        collected.append((factors, scale, -1))
    return collected


def _extract(graph: Graph, terms: list[Term], c0: float, *, constant: bool = False) -> int:
    """Return Σ terms + c0 with the most frequent factor taken out, again and again.

    Takes the terms apart. `constant` says that they depend on constants alone.
    """
    done: list[tuple[int, float]] = []
    brackets = []  # those around the present one: the terms outside, what is done, the factors
    while True:
        step = _next_factors(graph, terms, constant) if len(terms) > 1 else None
        if step is not None:
            common, inside, outside = step
            for factors, _, _ in inside:
                for node, exponent in common.items():
                    factors[node] -= exponent
                    if not factors[node]:
                        del factors[node]
            brackets.append((outside, done, c0, common))
            terms, done, c0 = [(f, c, -1) for f, c, _ in inside], [], 0.0
            continue
        done += [(graph.product(f.items()) if n < 0 else n, c) for f, c, n in terms]
        value = graph.sum(done, c0)
        while brackets:
            terms, done, c0, common = brackets.pop()
            value = graph.product([*common.items(), (value, 1)])
            if terms or done or c0 != 0.0:
                done.append((value, 1.0))
                break
        else:
            return value


def _next_factors(
    graph: Graph, terms: list[Term], constant: bool
) -> tuple[dict[int, int], list[Term], list[Term]] | None:
    """Return the powers to take out, the terms that have them, and the others."""
    # What all terms but numbers have goes first without counting, unless it is constant and they
    # are not.
    products = [term for term in terms if term[0]]
    common = _common(products) if len(products) > 1 else {}
    if common and (constant or not all(graph.constant[n] for n in common)):
        return common, products, [term for term in terms if not term[0]]
    best = _most_frequent(graph, terms)
    if best is None:
        return None
    factor, sign = best
    inside: list[Term] = []
    outside: list[Term] = []
    for term in terms:
        (inside if term[0].get(factor, 0) * sign > 0 else outside).append(term)
    return _common(inside), inside, outside


def _common(terms: list[Term]) -> dict[int, int]:
    """Return all powers that every term has, so that one step takes them out together."""
    common = dict(terms[0][0])
    for factors, _, _ in terms[1:]:
        for n, e in list(common.items()):
            exponent = factors.get(n, 0)
            if e * exponent <= 0:
                del common[n]
            elif abs(exponent) < abs(e):
                common[n] = exponent
        if not common:
            break
    return common


def _most_frequent(graph: Graph, terms: list[Term]) -> tuple[int, int] | None:
    counts: dict[int, int] = {}  # of denominators by the node's complement
    for factors, _, _ in terms:
        for node, exponent in factors.items():
            key = node if exponent > 0 else ~node
            counts[key] = counts.get(key, 0) + 1
    ranks = []
    for key, count in counts.items():
        if count > 1:
            node, sign = (key, 1) if key >= 0 else (~key, -1)
            ranks.append((not graph.constant[node], count, sign, -node))
    if not ranks:
        return None
    _, _, sign, negated = max(ranks)
    return -negated, sign
