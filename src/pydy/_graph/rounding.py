"""How far rounding may take the value of a node: a running error bound as further nodes.

Every operation adds its own rounding to what its operands' roundings make of its value. The error
of a sum is proportional to the sizes of its terms, not to its value: where terms cancel, the bound
says by how much (N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., §3.3).
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from pydy._graph.derivative import Rows, jacobian
from pydy._graph.node import Graph
from pydy._program import OPERATIONS

# Functions of pure numbers: one is large beside nothing, in whatever units.
_OF_NUMBERS = frozenset(
    ("exp", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "atanh")
) | {"erf", "erfc"}


def rounding_bounds(
    graph: Graph,
    nodes: Sequence[int],
    inherited: bool = True,
    constants: bool = False,
    errors: Mapping[int, int] | None = None,
) -> list[int]:
    """Return bounds on the rounding errors of `nodes`, in units of 2⁻⁵², as new nodes.

    The states are taken as rounded too; time, specifieds and what depends on constants alone are
    exact, since every evaluation sees the same numbers, unless `constants` are to be taken as
    rounded. Inputs that are known less well have `errors` beside, nodes in the same unit. Without
    what is `inherited` from operands, the roundings of the last operations alone count: a part of
    the bounds that costs little.
    """
    if not inherited:
        return [_own(graph, n) for n in nodes]
    rounded = ("x", "p") if constants else ("x",)
    bounds: dict[int, int] = {}
    known = errors or {}
    for node in graph.reachable(nodes):
        own = _bound(graph, node, bounds, rounded)
        bounds[node] = graph.sum([(own, 1.0), (known[node], 1.0)]) if node in known else own
    return [bounds[n] for n in nodes]


def sizes_of_terms(graph: Graph, nodes: Sequence[int]) -> list[int]:
    """Return how large `nodes` would be if none of their terms cancelled, as new nodes.

    Linear solves are not looked into, nor are denominators, roots and functions.
    """
    sizes: dict[int, int] = {}
    for node in graph.reachable(nodes):
        op, args = graph.ops[node], graph.args[node]
        if op == "sum":
            sizes[node] = graph.sum([(sizes[n], abs(c)) for n, c in args[1]], abs(args[0]))
        elif op == "prod":
            whole = [(sizes[n] if e > 0 else graph.call("abs", n), e) for n, e in args]
            sizes[node] = graph.product(whole)
        elif op == "select":
            sizes[node] = graph.call("select", args[0], *(sizes[n] for n in args[1:]))
        elif op not in OPERATIONS.truths and op not in OPERATIONS.solves:  # which are no numbers
            sizes[node] = graph.call("abs", node)
    return [sizes[n] for n in nodes]


def per_unit(graph: Graph, nodes: Sequence[int], states: Sequence[int]) -> list[int]:
    """Return how much of a unit each state is per its own: of angles 1, of lengths mostly zero.

    States that are arguments of sines and exponentials, in the nodes, have units of their own; of
    others nothing but their values tells what is small.
    """
    arguments = [graph.args[n][0] for n in graph.reachable(nodes) if graph.ops[n] in _OF_NUMBERS]
    found = [graph.zero] * len(states)
    for row in jacobian(graph, arguments, states):
        for k, slope in row.items():
            if graph.constant[slope]:
                found[k] = graph.call("max", found[k], graph.call("abs", slope))
    return found


def _bound(g: Graph, node: int, bounds: dict[int, int], rounded: tuple[str, ...]) -> int:
    op, args = g.ops[node], g.args[node]
    if op == "input":
        return g.call("abs", node) if args[0] in rounded else g.zero
    if op == "select":
        return g.call("select", args[0], bounds[args[1]], bounds[args[2]])
    operation = OPERATIONS.get(op)
    exact = g.constant[node] and (op == "const" or "p" not in rounded)
    if exact or (operation is not None and operation.partials is None):
        return g.zero  # steps and conditions too
    own = _own(g, node)
    if op in ("factor", "solve", "item"):
        return own  # linear solves are not looked into
    operands = g.operands(node)
    given = [*operands, *(m for n in operands for m in _within(g, n))]
    partials = Rows(g, {n: {n: g.one} for n in given}).through(node)
    inherited = [
        (g.mul(g.call("abs", d), bounds[n]), 1.0)
        for n, d in partials.items()
        if bounds[n] != g.zero
    ]
    left = _roundings(g, args, partials.keys()) if op == "prod" else []
    return g.sum([*inherited, *left, (own, 1.0)])


def _within(g: Graph, factor: int) -> list[int]:
    """Return the nodes by which a product may be differentiated in place of a factor.

    y √y is differentiated by y, and a sum of roots times something term by term.
    """
    if g.ops[factor] == "sqrt":
        return [g.args[factor][0]]
    terms = [n for n, _ in g.args[factor][1]] if g.ops[factor] == "sum" else []
    roots = [[m for m, _ in _factors(g, n)] for n in terms]
    roots = [inner for inner in roots if any(g.ops[m] == "sqrt" for m in inner)]
    found = terms if roots else []
    return [*found, *(n for inner in roots for m in inner for n in (m, *_within(g, m)))]


def _roundings(
    g: Graph, factors: Sequence[tuple[int, int]], by: Collection[int]
) -> list[tuple[int, float]]:
    """Return the roundings of factors that a product was not differentiated by: sums of roots.

    Those of the sum and those of each of its terms are as large as the terms together.
    """
    found = []
    for k, (n, _) in enumerate(factors):
        if g.ops[n] == "sum" and n not in by and not g.constant[n]:
            others = [*factors[:k], *factors[k + 1 :]]
            found.append((g.mul(g.call("abs", g.product(others)), _own(g, n)), 2.0))
            for m, _ in g.args[n][1]:
                found += _roundings(g, [*_factors(g, m), *others], by)
    return found


def _factors(g: Graph, node: int) -> Sequence[tuple[int, int]]:
    return g.args[node] if g.ops[node] == "prod" else ((node, 1),)


def _own(g: Graph, node: int) -> int:
    if g.ops[node] != "sum":
        return g.call("abs", node)
    c0, terms = g.args[node]
    return g.sum([(g.call("abs", n), abs(c)) for n, c in terms], abs(c0))
