"""Rewriting passes that lower the number of operations.

Each pass takes the roots of a graph and returns new roots in the same graph. They reassociate
sums and products, which moves results by a few roundings.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from pydy._graph.node import Graph

__all__ = ["factor_sums", "rebuild", "simplify"]

Term = tuple[dict[int, int], float]


def rebuild(
    graph: Graph,
    roots: Sequence[int],
    rule: Callable[[int, str, tuple[Any, ...]], int],
) -> list[int]:
    """Return the roots with every node replaced by what `rule` makes of it.

    Parameters
    ----------
    graph : Graph
    roots : sequence of nodes
    rule : callable
        ``rule(node, op, args)`` with the operands in `args` already replaced returns a node.
    """
    new: dict[int, int] = {}
    for node in graph.reachable(roots):
        new[node] = rule(node, graph.ops[node], replaced(graph, node, new))
    return [new[r] for r in roots]


def replaced(graph: Graph, node: int, new: dict[int, int]) -> tuple[Any, ...]:
    """Return the arguments of `node` with its operands looked up in `new`."""
    op, args = graph.ops[node], graph.args[node]
    if op == "sum":
        return (args[0], tuple((new[n], c) for n, c in args[1]))
    if op == "prod":
        return tuple((new[n], e) for n, e in args)
    if op in ("const", "input", "bool"):
        return args
    if op == "factor":
        return (args[0], args[1], tuple(new[n] for n in args[2]))
    if op == "solve":
        return (new[args[0]], tuple(new[n] for n in args[1]))
    if op == "item":
        return (new[args[0]], args[1])
    return tuple(new[n] for n in args)


def again(graph: Graph, op: str, args: tuple[Any, ...]) -> int:
    """Make `op` on `args` with the graph's own rules (folding, collecting, ordering)."""
    if op == "sum":
        return graph.sum(args[1], args[0])
    if op == "prod":
        return graph.product(args)
    if op in ("const", "input", "bool", "factor", "solve", "item"):
        return graph.make(op, args)
    return graph.call(op, *args)


def simplify(graph: Graph, roots: Sequence[int]) -> list[int]:
    """Return roots that cost fewer operations."""
    return factor_sums(graph, roots)


def factor_sums(graph: Graph, roots: Sequence[int]) -> list[int]:
    """Extract common factors from sums of products, most frequent first.

    Factors that depend on the state go first: what is left inside the brackets is then more often
    a matter of constants alone, which is computed once per binding and not at every call.
    """
    flags = _Flags(graph)

    def rule(node: int, op: str, args: tuple[Any, ...]) -> int:
        if op != "sum" or len(args[1]) < 2:
            return node if args == graph.args[node] else again(graph, op, args)
        return _factored(graph, flags, args)

    return rebuild(graph, roots, rule)


class _Flags:
    """Tell which nodes depend on constants (inputs 'p') and numbers alone, in a growing graph."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        self.known: list[bool] = []

    def __getitem__(self, node: int) -> bool:
        graph, known = self.graph, self.known
        for k in range(len(known), node + 1):
            op = graph.ops[k]
            if op == "input":
                known.append(graph.args[k][0] == "p")
            elif op in ("factor", "solve", "item"):
                known.append(False)
            else:
                known.append(all(known[n] for n in graph.operands(k)))
        return known[node]


def _factored(graph: Graph, flags: _Flags, args: tuple[Any, ...]) -> int:
    c0, pairs = args
    terms: list[Term] = []
    for node, coefficient in pairs:
        scale, core = graph.scaled(node)
        if graph.ops[core] == "prod":
            terms.append((dict(graph.args[core]), coefficient * scale))
        else:
            terms.append(({core: 1}, coefficient * scale))
    return _extract(graph, flags, _collect(graph, flags, terms), c0)


def _collect(graph: Graph, flags: _Flags, terms: list[Term]) -> list[Term]:
    """Join the terms whose state-dependent part is the same: their constants add up."""
    groups: dict[tuple[Any, ...], list[Term]] = {}
    for factors, coefficient in terms:
        key = tuple(sorted((n, e) for n, e in factors.items() if not flags[n]))
        groups.setdefault(key, []).append((factors, coefficient))
    collected: list[Term] = []
    for key, members in groups.items():
        if len(members) == 1 or not key:
            collected.extend(members)
            continue
        rest = [({n: e for n, e in f.items() if flags[n]}, c) for f, c in members]
        inner = _extract(graph, flags, rest, 0.0)
        scale, core = graph.scaled(inner)
        if graph.value(core) is not None:
            value = graph.value(core) or 0.0
            if value:
                collected.append((dict(key), scale * value))
            continue
        factors = dict(key)
        if graph.ops[core] == "prod":
            for n, e in graph.args[core]:
                factors[n] = factors.get(n, 0) + e
        else:
            factors[core] = factors.get(core, 0) + 1
        collected.append((factors, scale))
    return collected


def _extract(graph: Graph, flags: _Flags, terms: list[Term], c0: float) -> int:
    """Return Σ terms + c0 with the most frequent factor taken out, again and again."""
    done: list[tuple[int, float]] = []
    while True:
        best = _most_frequent(flags, terms)
        if best is None:
            break
        factor, sign = best
        inside: list[Term] = []
        outside: list[Term] = []
        for factors, coefficient in terms:
            exponent = factors.get(factor, 0)
            (inside if exponent * sign > 0 else outside).append((factors, coefficient))
        common = _common(inside)
        reduced: list[Term] = []
        for factors, coefficient in inside:
            left = {n: e - common.get(n, 0) for n, e in factors.items()}
            reduced.append(({n: e for n, e in left.items() if e}, coefficient))
        bracket = _extract(graph, flags, reduced, 0.0)
        product = graph.product([*common.items(), (bracket, 1)])
        if not outside and not done and c0 == 0.0:
            return product
        done.append((product, 1.0))
        terms = outside
    done.extend((graph.product(list(f.items())), c) for f, c in terms)
    return graph.sum(done, c0)


def _common(terms: list[Term]) -> dict[int, int]:
    """Return all powers that every term has, so that one step takes them out together."""
    common = dict(terms[0][0])
    for factors, _ in terms[1:]:
        for n, e in list(common.items()):
            other = factors.get(n, 0)
            if e * other <= 0:
                del common[n]
            elif abs(other) < abs(e):
                common[n] = other
    return common


def _most_frequent(flags: _Flags, terms: list[Term]) -> tuple[int, int] | None:
    counts: dict[tuple[int, int], int] = {}
    for factors, _ in terms:
        for node, exponent in factors.items():
            key = (node, 1 if exponent > 0 else -1)
            counts[key] = counts.get(key, 0) + 1
    best = None
    best_rank: tuple[Any, ...] = ()
    for (node, sign), count in counts.items():
        if count < 2:
            continue
        rank = (not flags[node], count, sign, -node)
        if best is None or rank > best_rank:
            best, best_rank = (node, sign), rank
    return best
