"""Exact derivatives by reverse accumulation: a sum of outputs by all inputs in one sweep.

From the outputs inwards each node gets its adjoint, the derivative of ``Σ weight · output`` by it.
A linear solve ``A x = b`` has the adjoint rule ``Aᵀ λ = x̄``, ``b̄ = λ`` and ``Ā = −λ xᵀ``: one more
right-hand side for the factors of a symmetric matrix (Griewank & Walther, Evaluating Derivatives,
2nd ed., §3.2; Giles, Collected matrix derivative results, 2008, §2.2).
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from pydy._graph.derivative import times
from pydy._graph.node import Graph
from pydy._graph.operations import OPERATIONS, is_symmetric
from pydy._graph.roots import at_rest, of_half_power, slope

__all__ = ["adjoints"]

Terms = list[tuple[int, float]]


def adjoints(
    graph: Graph,
    outputs: Sequence[int],
    weights: Sequence[int],
    variables: Sequence[int],
    *,
    through_guards: bool = False,
    by_systems: bool = False,
) -> list[int]:
    """Return the derivatives of ``Σ weight · output`` with respect to `variables`.

    Parameters
    ----------
    graph : Graph
        Gets the new nodes.
    outputs, weights : sequences of nodes
        What is differentiated, and what each is multiplied with.
    variables : sequence of input nodes
    through_guards : bool
        Whether a guarded solution is differentiated as it was found, in O(n) where that is so; the
        derivatives are NaN where a guard falls back. By default they are those of the linear system
        that it solves, if that is symmetric.
    by_systems : bool
        Whether they are so too if it is not symmetric: they then hold everywhere.

    Returns
    -------
    list of nodes
        One for each variable.

    Notes
    -----
    Switches are treated as `pydy._graph.derivative.jacobian` treats them.
    """
    order = graph.reachable(outputs, fallbacks=not through_guards)
    active = set(variables)
    for node in order:
        fast = through_guards and graph.ops[node] == "guard"
        if not active.isdisjoint(graph.args[node][4] if fast else graph.operands(node)):
            active.add(node)
    sweep = _Sweep(graph, active, through_guards, by_systems)
    for output, weight in zip(outputs, weights, strict=True):
        sweep.add(output, weight)
    for node in reversed(order):
        if node in active:
            sweep.through(node)
    return [sweep.of(variable) for variable in variables]


class _Sweep:
    def __init__(
        self, graph: Graph, active: set[int], through_guards: bool, by_systems: bool
    ) -> None:
        self.graph = graph
        self.active = active
        self.through_guards = through_guards
        self.by_systems = by_systems
        self.terms: dict[int, Terms] = {}
        self.vectors: dict[int, dict[int, int]] = {}  # adjoints of the components of a solution

    def add(self, node: int, term: int, coefficient: float = 1.0) -> None:
        if node in self.active:
            self.terms.setdefault(node, []).append((term, coefficient))

    def of(self, node: int) -> int:
        """Return the adjoint of a node; what comes by one way of a switch stays under it."""
        g, terms = self.graph, self.terms.get(node, ())
        ways: dict[tuple[int, bool], Terms] = {}
        rest: Terms = []
        for term, coefficient in terms:
            c, core = g.scaled(term)
            if g.ops[core] == "select" and g.zero in g.args[core][1:]:
                which, yes, no = g.args[core]
                taken = no == g.zero
                way = ways.setdefault((which, taken), [])
                way.append((yes if taken else no, c * coefficient))
            else:
                rest.append((term, coefficient))
        for (which, taken), parts in ways.items():
            total = g.sum(parts)
            ends = (total, g.zero) if taken else (g.zero, total)
            rest.append((g.call("select", which, *ends), 1.0))
        return g.sum(rest)

    def through(self, node: int) -> None:
        """Hand the adjoint of a node to its operands."""
        g = self.graph
        op, args = g.ops[node], g.args[node]
        if op == "guard" and self._as_found(*args[:2]):
            *_, sound, fast = args
            for k, bar in self.vectors.get(node, {}).items():
                self.add(fast[k], g.call("select", sound, bar, g.const(math.nan)))
            return
        if op in ("solve", "guard"):
            self._solve(node)
            return
        bar = self.of(node)
        if bar == g.zero:
            return
        if op == "sum":
            for n, c in args[1]:
                self.add(n, bar, c)
        elif op == "prod":
            for k, (n, e) in enumerate(args):
                if n in self.active:
                    by_radicand = of_half_power(g, args, k)
                    if by_radicand is not None:
                        self.add(g.args[n][0], times(g, bar, by_radicand))
                        continue
                    others = [(m, f) for j, (m, f) in enumerate(args) if j != k]
                    self.add(n, times(g, bar, g.product([*others, (n, e - 1)], float(e))))
        elif op == "select":
            self.add(args[1], g.call("select", args[0], bar, g.zero))
            self.add(args[2], g.call("select", args[0], g.zero, bar))
        elif op == "item":
            self.vectors.setdefault(args[0], {})[args[1]] = bar
        elif op in OPERATIONS:
            partials = OPERATIONS[op].partials
            if partials is not None:  # else it is piecewise constant
                slopes = [times(g, bar, d) for d in partials(g, node, *args)]
                if at_rest(g, node) is not None:
                    slopes[0] = slope(g, node, bar)
                for n, d in zip(args, slopes, strict=True):
                    self.add(n, d)

    def _as_found(self, n: int, entries: Sequence[int]) -> bool:
        """Return whether a guard is differentiated as its solution was found."""
        return self.through_guards or not (self.by_systems or is_symmetric(n, entries))

    def _solve(self, node: int) -> None:
        g = self.graph
        bars = self.vectors.get(node)
        if not bars:
            return
        args, guarded = g.args[node], g.ops[node] == "guard"
        if guarded:
            # By the system that it solves: how the solution was found does not matter.
            n, entries, column = args[:3]
            kind = "ldl" if is_symmetric(n, entries) else "lu"
            if kind == "lu":  # the way that was found need not have all unknowns
                node = self._solved(n, entries, column)
        else:
            (kind, n, entries), column = g.args[args[0]], args[1]
        right = [bars.get(k, g.zero) for k in range(n)]
        turned = entries
        if kind != "ldl":
            turned = tuple(entries[j * n + i] for i in range(n) for j in range(n))
        if kind == "ldl" or not guarded:
            multipliers = g.solve_factored(g.make("factor", (kind, n, turned)), right)
        else:
            solution = self._solved(n, turned, right)
            multipliers = [g.make("item", (solution, k)) for k in range(n)]
        for entry, multiplier in zip(column, multipliers, strict=True):
            self.add(entry, multiplier)
        for i, multiplier in enumerate(multipliers):
            for j in range(n):
                # An SPD factor reads the lower triangle only.
                low = max(i, j) * n + min(i, j) if kind == "ldl" else i * n + j
                if entries[low] in self.active:
                    solution = g.make("item", (node, j))
                    self.add(entries[low], g.mul(multiplier, solution), -1.0)

    def _solved(self, n: int, entries: Sequence[int], column: Sequence[int]) -> int:
        """Return the solution of a guard's system, by what it falls back to."""
        g = self.graph
        never = g.boolean(False)
        return g.make("guard", (n, tuple(entries), tuple(column), never, (g.zero,) * n))
