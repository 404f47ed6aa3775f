"""Exact derivatives by reverse accumulation: a sum of outputs by all inputs in one sweep.

From the outputs inwards each node gets its adjoint, the derivative of ``Σ weight · output`` by it.
A linear solve ``A x = b`` has the adjoint rule ``Aᵀ λ = x̄``, ``b̄ = λ`` and ``Ā = −λ xᵀ``: one more
right-hand side for the factors of a symmetric matrix (Griewank & Walther, Evaluating Derivatives,
2nd ed., §3.2; Giles, Collected matrix derivative results, 2008, §2.2).

What a guarded solution hands on is guarded by the same condition: two sweeps, through what was
found in the other way and through the system, go on to the variables and to other guards, and a
guard takes the sums of one of them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import reduce
from operator import or_

from pydy._graph.derivative import (
    condition_on_side,
    definite,
    on_side,
    partials_on_side,
    times,
    undefined,
)
from pydy._graph.linear_system import LinearSystem, solve_factored
from pydy._graph.node import Graph
from pydy._graph.roots import is_steep, of_half_power, slope
from pydy._program import OPERATIONS, symmetric

Terms = list[tuple[int, float]]


def adjoints(
    graph: Graph, outputs: Sequence[int], weights: Sequence[int], variables: Sequence[int]
) -> list[int]:
    """Return the derivatives of ``Σ weight · output`` with respect to `variables`.

    Switches are treated as `pydy._graph.derivative.jacobian` treats them.
    """
    active = {node: 1 << k for k, node in enumerate(variables)}
    for node in graph.reachable(outputs):
        bits = reduce(or_, (active.get(n, 0) for n in graph.operands(node)), 0)
        if bits and node not in active:
            active[node] = bits
    seeds = list(zip(outputs, weights, strict=True))
    sweep = _Sweep(graph, active, seeds, set(variables))
    return [sweep.adjoint_of(variable) for variable in variables]


class _Sweep:
    """The adjoints of `active` nodes, from seeds (node, adjoint).

    A node is active if it depends on variables; the bits of a number say on which. Adjoints of the
    `ends` are computed, but not propagated.
    """

    def __init__(
        self,
        graph: Graph,
        active: Mapping[int, int],
        seeds: Sequence[tuple[int, int]],
        ends: set[int],
    ) -> None:
        self.graph, self.active, self.ends = graph, active, ends
        self.terms: dict[int, Terms] = {}
        self.vectors: dict[int, dict[int, int]] = {}  # adjoints of the components of a solution
        for node, bar in seeds:
            self.add(node, bar)
        self.order = graph.reachable(self.terms, fallbacks=False)
        for node in reversed(self.order):
            if node in active and node not in ends:
                self.propagate(node)

    def add(self, node: int, term: int, coefficient: float = 1.0) -> None:
        if node in self.active:
            self.terms.setdefault(node, []).append((term, coefficient))

    def adjoint_of(self, node: int) -> int:
        """Return the adjoint of a node, with one switch for all contributions from a branch."""
        g, terms = self.graph, self.terms.get(node, ())
        by_branch: dict[tuple[int, bool], Terms] = {}
        contributions: Terms = []
        for term, coefficient in terms:
            c, core = g.scaled(term)
            if g.ops[core] == "select" and g.zero in g.args[core][1:]:
                condition, yes, no = g.args[core]
                if_true = no == g.zero
                branch = by_branch.setdefault((condition, if_true), [])
                branch.append((yes if if_true else no, c * coefficient))
            else:
                contributions.append((term, coefficient))
        for (condition, if_true), parts in by_branch.items():
            total = g.sum(parts)
            ends = (total, g.zero) if if_true else (g.zero, total)
            contributions.append((g.call("select", condition, *ends), 1.0))
        return g.sum(contributions)

    def propagate(self, node: int) -> None:
        """Add the contributions of a node's adjoint to those of its operands."""
        g = self.graph
        op, args = g.ops[node], g.args[node]
        if op in ("solve", "guard"):
            self._solve(node) if op == "solve" else self._guard(node)
            return
        bar = self.adjoint_of(node)
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
                        self.add(g.args[n][0], times(g, bar, on_side(g, by_radicand)))
                        continue
                    factors = [(m, f - (j == k)) for j, (m, f) in enumerate(args)]
                    partial = g.product([(on_side(g, m), f) for m, f in factors], float(e))
                    self.add(n, times(g, bar, partial))
        elif op == "select":
            condition, yes, no = condition_on_side(g, node), *args[1:]
            # The side that is not taken gets zero, or NaN.
            self.add(yes, g.call("select", condition, bar, self._zero_or_undefined(no, yes, bar)))
            self.add(no, g.call("select", condition, self._zero_or_undefined(yes, no, bar), bar))
        elif op == "item":
            self.vectors.setdefault(args[0], {})[args[1]] = bar
        elif op in OPERATIONS and OPERATIONS[op].partials is not None:
            # Others are piecewise constant.
            slopes = [times(g, bar, d) for d in partials_on_side(g, node)]
            if is_steep(g, node):
                slopes[0] = slope(g, node, bar)
            for n, d in zip(args, slopes, strict=True):
                self.add(n, d)

    def _zero_or_undefined(self, selected: int, untaken: int, bar: int) -> int:
        """Return the adjoint of the side of a switch that is not taken: zero, or NaN.

        Where the side that is taken is a Piecewise without a branch, all derivatives are NaN: those
        by variables of its own get it there, those by variables of the other side alone here.
        """
        g = self.graph
        if not self.active.get(untaken, 0) & ~self.active.get(selected, 0):
            return g.zero
        nan = undefined(g, selected)
        # An adjoint of zero is that of an output without weight, or of what is not taken itself.
        return nan if nan == g.zero else g.call("select", g.call("eq", bar, g.zero), g.zero, nan)

    def _solve(self, node: int) -> None:
        g, bars = self.graph, self.vectors.get(node)
        if not bars:
            return
        factor, column = g.args[node]
        kind, n, entries = g.args[factor]
        transposed = entries if kind == "ldl" else _transpose(n, entries)
        right = [bars.get(k, g.zero) for k in range(n)]
        multipliers = solve_factored(g, g.make("factor", (kind, n, transposed)), right)
        for part, term, sign in self._system(node, g.args[factor], column, multipliers):
            self.add(part, term, sign)

    def _guard(self, node: int) -> None:
        """Propagate a guard's adjoint to the fast solution where sound, else to the system."""
        g, bars = self.graph, self.vectors.get(node)
        if not bars:
            return
        n, entries, column, sound, fast = g.args[node]
        judged = definite(g, node)
        if judged is not None:
            for k, bar in bars.items():
                self.add(fast[k], g.add(bar, judged))
            return
        # By another guard, always of the system.
        right = tuple(bars.get(k, g.zero) for k in range(len(column)))
        never = g.boolean(False)
        transposed = (n, _transpose(n, entries), right, never, (g.zero,) * len(column))
        solution = g.make("guard", transposed)
        multipliers = [g.make("item", (solution, k)) for k in range(len(column))]
        slow = self._system(node, ("lu", n, entries), column, multipliers)
        if sound == never:
            for part, term, sign in slow:
                self.add(part, term, sign)
            return
        items = (k for k in self.order if k < node and k in self.active and g.ops[k] == "item")
        ends = {*self.ends, *(k for k in items if g.ops[g.args[k][0]] == "guard")}
        seeds = [(part, g.sum([(term, sign)])) for part, term, sign in slow]
        seeds_of_fast = [(fast[k], bar) for k, bar in bars.items()]
        sweeps = [_Sweep(g, self.active, part, ends) for part in (seeds, seeds_of_fast)]
        reached = sorted(ends & {*sweeps[0].terms, *sweeps[1].terms})
        parts = [[sweep.adjoint_of(end) for end in reached] for sweep in sweeps]
        adjoints_of_ends = LinearSystem(g, [[g.one]]).guarded(parts[0], sound, parts[1])
        for end, bar in zip(reached, adjoints_of_ends, strict=True):
            self.add(end, bar)

    def _system(
        self,
        node: int,
        system: tuple[str, int, Sequence[int]],
        column: Sequence[int],
        multipliers: Sequence[int],
    ) -> list[tuple[int, int, float]]:
        """Return the adjoints of a linear system's parts: b̄ = λ and Ā = −λ xᵀ, with signs."""
        g = self.graph
        kind, n, entries = system
        entries = symmetric(n, entries) if kind == "ldl" else entries
        result = [(b, m, 1.0) for b, m in zip(column, multipliers, strict=True)]
        for k, multiplier in enumerate(multipliers):
            first, i = k - k % n, k % n
            for j in range(n):
                if (entry := entries[i * n + j]) in self.active:
                    solution = g.make("item", (node, first + j))
                    result.append((entry, g.mul(multiplier, solution), -1.0))
        return [part for part in result if part[0] in self.active]


def _transpose(n: int, entries: Sequence[int]) -> tuple[int, ...]:
    """Return the transpose of a matrix."""
    return tuple(entries[j * n + i] for i in range(n) for j in range(n))
