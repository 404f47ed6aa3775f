"""Derivatives of roots where they vanish.

A root has an infinite slope at zero, but what a model makes of it mostly has none there: drag
``−c |v| v`` is at rest when its body is. Two rules say so, exactly and whatever form it has.

A product of a root with its radicand, such as ``y √y``, is differentiated by the radicand.

What a root is multiplied by may vanish with it. If that has a finite slope, so that it is of first
order, the product is of higher order however steep the root is: the root has no part in the slope.
The same holds of powers, and of inverse functions at the ends of their domain, as acos at 1.

Else let a radicand y vanish where it is stationary, as sums of squares do, and let F depend on
the root n. Then y is of second order, n = √y of first, and so is what F makes of it: where ∂F/∂n is
zero n has no part in the slope of F. Where it is not, F has a kink, as a distance has at zero, and
its derivative is NaN. The same holds of a power y^p: with p > 1/4 where ∂F/∂n is zero, since what F
makes of n is then of order 4p, and with p > 1/2 everywhere.
"""

from __future__ import annotations

from collections.abc import Sequence

from pydy._graph.node import Graph
from pydy._program import OPERATIONS

_STEEP = ("sqrt", "pow", "asin", "acos", "acosh")
_SMOOTH = ("sin", "cos", "sinh", "cosh", "exp")  # stationary, or one, where these sums vanish
_STEPS = {"sign", "floor", "ceil", "atan2"}


def is_steep(g: Graph, node: int) -> bool:
    """Return whether a function may have a finite value and an infinite slope."""
    if g.ops[node] not in _STEEP:
        return False
    if g.ops[node] in ("asin", "acos", "acosh"):
        return True
    _, core = g.scaled(g.args[node][0])
    return not g.constant[core] and not _is_positive(g, core)


def is_carried(g: Graph, node: int) -> bool:
    """Return whether a steep function waits in forward mode until all made of it is known.

    That takes as much as another variable: other roots, which are many, are known by the products
    and the sums in products that they are in.
    """
    if not is_steep(g, node):
        return False
    if g.ops[node] not in ("sqrt", "pow"):
        return True
    _, core = g.scaled(g.args[node][0])
    return g.ops[core] in ("sqrt", "pow") or at_rest(g, node) is not None


def slope(g: Graph, root: int, weight: int) -> int:
    """Return `weight` times the derivative of a steep function by its argument."""
    scale, core = g.scaled(weight)
    if g.ops[core] == "select" and g.zero in g.args[core][1:]:
        # Beyond the switch the slope may be infinite, but has no part in anything.
        condition, *branches = g.args[core]
        ends = [n if n == g.zero else slope(g, root, g.sum([(n, scale)])) for n in branches]
        return g.call("select", condition, *ends)
    op, args = g.ops[root], g.args[root]
    y, p = args[0], g.one
    if op == "sqrt":
        p, steep = g.const(0.5), g.product([(weight, 1), (root, -1)], 0.5)
    elif op == "pow":
        p = args[1]
        steep = g.mul(weight, p, g.call("pow", y, g.sum([(p, 1.0)], -1.0)))
    else:
        partials = OPERATIONS[op].partials
        assert partials is not None
        steep = g.mul(weight, partials(g, root, y)[0])
    nothing = g.call("eq", weight, g.zero)
    if nothing == g.boolean(False):
        no_part = nothing
    elif _has_finite_slope(g, weight):
        return g.call("select", nothing, g.zero, steep)
    else:
        no_part = g.call("and", nothing, g.call("lt", g.const(0.25), p))
    root_at_rest = at_rest(g, root)
    if root_at_rest is None:
        return steep
    no_part = g.call("or", no_part, g.call("lt", g.const(0.5), p))
    return g.call("select", g.call("and", root_at_rest, no_part), g.zero, steep)


def _has_finite_slope(g: Graph, node: int) -> bool:
    """Return whether a node has finite slopes wherever it has a finite value, by structure."""
    return not any(g.ops[n] in _STEPS or is_steep(g, n) for n in g.reachable([node]))


def _is_positive(g: Graph, node: int) -> bool:
    """Return whether a node never vanishes, by structure: c² + x² does not."""
    if g.ops[node] != "sum":
        return False
    c0, terms = g.args[node]
    fixed = c0 > 0.0 or any(g.constant[n] for n, _ in terms)
    return fixed and _is_even(g, node)


def at_rest(g: Graph, root: int) -> int | None:
    """Return whether a root is zero and its radicand stationary, None if that cannot be."""
    if g.ops[root] not in ("sqrt", "pow"):
        return None
    _, core = g.scaled(g.args[root][0])
    if g.ops[core] not in ("sum", "prod"):
        return None
    if g.ops[core] == "sum":
        c0, terms = g.args[core]
        waves = any(g.ops[n] in _SMOOTH for n, _ in terms)  # as in √(1 − cos x)
        if (c0 != 0.0 and not waves) or any(g.constant[n] for n, _ in terms):
            return None  # as √(c² + x²), which need not vanish
    conditions = [g.call("eq", root, g.zero)]
    if not _is_even(g, core):
        slopes: dict[int, list[tuple[int, float]]] = {}
        _polynomial(g, core, g.one, slopes)
        derivatives = [g.sum(parts) for parts in slopes.values()]
        if any(g.constant[n] and n != g.zero for n in derivatives):
            return None
        conditions += [g.call("eq", n, g.zero) for n in derivatives]
    return g.call("and", *conditions)


def _is_even(g: Graph, node: int) -> bool:
    """Return whether a smooth node is never negative, by structure: its zeros are stationary."""
    if g.ops[node] == "sum":
        c0, terms = g.args[node]
        return c0 >= 0.0 and all(c > 0.0 and _is_even(g, n) for n, c in terms)
    if g.ops[node] == "prod":
        return all(e % 2 == 0 or (e > 0 and _is_even(g, m)) for m, e in g.args[node])
    return False


def _polynomial(
    g: Graph, node: int, weight: int, slopes: dict[int, list[tuple[int, float]]]
) -> None:
    """Add the slopes of a node times `weight`, as a polynomial of its bases."""
    if g.ops[node] == "sum":
        for n, c in g.args[node][1]:
            if not g.constant[n]:
                _polynomial(g, n, g.sum([(weight, c)]), slopes)
    elif g.ops[node] == "prod":
        factors = g.args[node]
        for k, (m, e) in enumerate(factors):
            if g.constant[m]:
                continue
            cofactors = [(o, f) for j, (o, f) in enumerate(factors) if j != k]
            partial = g.product([(weight, 1), *cofactors, (m, e - 1)], float(e))
            if e == 1 and g.ops[m] == "sum":
                _polynomial(g, m, partial, slopes)
            else:
                _inner(g, m, partial, slopes)
    else:
        _inner(g, node, weight, slopes)


def _inner(g: Graph, node: int, weight: int, slopes: dict[int, list[tuple[int, float]]]) -> None:
    """Add the slopes of a node that is no polynomial; of a wave, by its argument."""
    if g.ops[node] in _SMOOTH:
        partials = OPERATIONS[g.ops[node]].partials
        assert partials is not None
        (argument,) = g.args[node]
        _polynomial(g, argument, g.mul(weight, partials(g, node, argument)[0]), slopes)
    else:
        slopes.setdefault(node, []).append((weight, 1.0))


def of_half_power(g: Graph, args: Sequence[tuple[int, int]], k: int) -> int | None:
    """Return a product's derivative by the radicand y of its factor √y, if it has the factor y.

    Of y √y that is √y/2. By the root first it would be y/(2 √y), NaN where y is zero. Constants
    that y has as factors need not be in the product.
    """
    n, e = args[k]
    if e != 1 or g.ops[n] != "sqrt":
        return None
    radicand, powers = g.args[n][0], dict(args)
    _, core = g.scaled(radicand)
    factors = g.args[core] if g.ops[core] == "prod" else ((core, 1),)
    if any(powers.get(m, 0) < f for m, f in factors if not g.constant[m]):
        return None
    return g.product([*args, (radicand, -1)], 0.5)
