"""How far rounding may take the value of a node: a running error bound as further nodes.

Every operation adds its own rounding to what its operands' roundings make of its value. The error
of a sum is proportional to the sizes of its terms, not to its value: where terms cancel, the bound
says by how much (N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., §3.3).
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from pydy._graph.derivative import DerivativeRows, jacobian
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
        return [_size_of_terms(graph, n) for n in nodes]
    rounded = ("x", "p") if constants else ("x",)
    bounds: dict[int, int] = {}
    errors_of_inputs = errors or {}
    for node in graph.reachable(nodes):
        bound = _bound(graph, node, bounds, rounded)
        bounds[node] = (
            graph.sum([(bound, 1.0), (errors_of_inputs[node], 1.0)])
            if node in errors_of_inputs
            else bound
        )
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
            factors = [(sizes[n] if e > 0 else graph.call("abs", n), e) for n, e in args]
            sizes[node] = graph.product(factors)
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
    slopes = [graph.zero] * len(states)
    for row in jacobian(graph, arguments, states):
        for k, slope in row.items():
            if graph.constant[slope]:
                slopes[k] = graph.call("max", slopes[k], graph.call("abs", slope))
    return slopes


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
    last_rounding = _size_of_terms(g, node)
    if op in ("factor", "solve", "item"):
        return last_rounding  # linear solves are not looked into
    operands = g.operands(node)
    seeds = [*operands, *(m for n in operands for m in _nodes_in_factor(g, n))]
    partials = DerivativeRows(g, {n: {n: g.one} for n in seeds}).from_operands(node)
    inherited = [
        (g.mul(g.call("abs", d), bounds[n]), 1.0)
        for n, d in partials.items()
        if bounds[n] != g.zero
    ]
    of_root_sums = _roundings(g, args, partials.keys()) if op == "prod" else []
    return g.sum([*inherited, *of_root_sums, (last_rounding, 1.0)])


def _nodes_in_factor(g: Graph, factor: int) -> list[int]:
    """Return the nodes by which a product may be differentiated in place of a factor.

    y √y is differentiated by y, and a sum of roots times something term by term.
    """
    if g.ops[factor] == "sqrt":
        return [g.args[factor][0]]
    terms = [n for n, _ in g.args[factor][1]] if g.ops[factor] == "sum" else []
    roots = [[m for m, _ in _factors(g, n)] for n in terms]
    roots = [inner for inner in roots if any(g.ops[m] == "sqrt" for m in inner)]
    of_roots = terms if roots else []
    return [*of_roots, *(n for inner in roots for m in inner for n in (m, *_nodes_in_factor(g, m)))]


def _roundings(
    g: Graph, factors: Sequence[tuple[int, int]], seen_variables: Collection[int]
) -> list[tuple[int, float]]:
    """Return the roundings of factors that a product was not differentiated by: sums of roots.

    Those of the sum and those of each of its terms are as large as the terms together.
    """
    terms = []
    for k, (n, _) in enumerate(factors):
        if g.ops[n] == "sum" and n not in seen_variables and not g.constant[n]:
            cofactors = [*factors[:k], *factors[k + 1 :]]
            terms.append((g.mul(g.call("abs", g.product(cofactors)), _size_of_terms(g, n)), 2.0))
            for m, _ in g.args[n][1]:
                terms += _roundings(g, [*_factors(g, m), *cofactors], seen_variables)
    return terms


def _factors(g: Graph, node: int) -> Sequence[tuple[int, int]]:
    return g.args[node] if g.ops[node] == "prod" else ((node, 1),)


def _size_of_terms(g: Graph, node: int) -> int:
    if g.ops[node] != "sum":
        return g.call("abs", node)
    c0, terms = g.args[node]
    return g.sum([(g.call("abs", n), abs(c)) for n, c in terms], abs(c0))
