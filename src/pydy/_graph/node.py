"""A hash-consed expression graph in canonical n-ary form.

A node is an integer: its place in the graph's lists. Asking twice for the same operation on the
same nodes gives the same integer, so two equal expressions are one node and every walk costs the
number of *distinct* sub-expressions. Nodes only refer to earlier nodes: the lists are already in
topological order and no walk ever needs recursion.

The two arithmetic kinds carry as much structure as a simplifier needs and no more::

    sum   (c0, ((node, coefficient), ...))      c0 + Σ coefficient · node
    prod  ((node, exponent), ...)               Π node ** exponent,  integer exponents

A ``prod`` never holds a number: numbers go to the coefficients of sums, so that ``2·x·y``,
``−x·y`` and ``x·y`` share the product. A ``sum`` of one term and no constant is a scaled node.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from pydy._program import OPERATIONS, Nodes, Operation

if TYPE_CHECKING:
    from pydy._program import Args

# Factors of a product that are not just counted.
_SPECIAL_FACTORS = frozenset({"const", "prod", "sum", "sqrt"})
_STEPS = frozenset({"sign", "select"})


class _Copied(Protocol):
    """What a graph knows of its nodes."""

    def copy(self, graph: Graph) -> _Copied: ...


class Graph(Nodes):
    """The arena that holds every node, with its kind, operands and whether it is `constant`.

    Operands are other nodes, except for the kinds ``const`` (value,), ``bool`` (value,), ``input``
    (group, index), ``sum``, ``prod`` (see the module), ``factor`` (kind, n, entries), ``solve``
    (factor, right-hand sides), ``guard`` (see `LinearSystem`) and ``item`` (solve or guard, index).
    """

    def __init__(self, off: frozenset[str] = frozenset()) -> None:
        super().__init__()
        self.off = off  # what its nodes are not simplified by (`pydy._graph.passes.names`)
        self.has_steps = False  # whether any node may jump, other than guards
        self.sides: _Copied | None = None  # see `pydy._graph.one_sided`
        self._counted: list[bool] = []  # whether a product only counts how often it has the node
        # Of `solve` nodes, see `pydy._graph.residuals`: b − A x in two forms, where derivatives are
        # made of it, and what they were before they were simplified.
        self.residuals: dict[int, tuple[list[int], list[int]] | None] = {}
        self.systems: dict[int, int] = {}
        self.zero = self.const(0.0)
        self.one = self.const(1.0)

    def __len__(self) -> int:
        return len(self.ops)

    def copy(self, names: Mapping[tuple[str, int], tuple[str, int]] | None = None) -> Graph:
        """Return a graph with the same nodes, which grows on its own.

        The inputs in `names` get other groups and indices, all at once.
        """
        twin = Graph.__new__(Graph)
        twin.ops, twin.args = self.ops.copy(), self.args.copy()
        twin.constant, twin._node_of = self.constant.copy(), self._node_of.copy()
        twin._operands, twin._counted = self._operands.copy(), self._counted.copy()
        twin.zero, twin.one, twin.off = self.zero, self.one, self.off
        twin.has_steps = self.has_steps
        twin.sides = None if names or self.sides is None else self.sides.copy(twin)
        twin.residuals, twin.systems = self.residuals.copy(), self.systems.copy()
        nodes = {}
        for old, new in (names or {}).items():
            node = twin._node_of.pop(("input", old), None)
            if node is not None:
                nodes[node] = new
        for node, new in nodes.items():
            twin.args[node] = new
            twin._node_of["input", new] = node
        return twin

    make = Nodes.node

    # -- leaves ---------------------------------------------------------------------------------

    def const(self, value: float) -> int:
        """Return the node of a number; all NaNs are one node, and so are both zeros."""
        value = float(value)
        if value == 0.0:
            value = 0.0
        elif value != value:
            value = math.nan  # one object, so that the tuple key compares equal by identity
        return self.make("const", (value,))

    def boolean(self, value: bool) -> int:
        """Return the node of a truth value."""
        return self.make("bool", (bool(value),))

    def input(self, group: str, index: int) -> int:
        """Return the node of the input `index` of `group` ('x', 't', 'r', 'p' or a scratch one)."""
        return self.make("input", (group, index))

    def value(self, node: int) -> float | None:
        """Return the number a node stands for, or None when it is not a constant."""
        return self.args[node][0] if self.ops[node] == "const" else None

    # -- sums and products ----------------------------------------------------------------------

    def scaled(self, node: int) -> tuple[float, int]:
        """Split ``c · n`` into (c, n); anything else is (1, node)."""
        if self.ops[node] == "sum":
            c0, terms = self.args[node]
            if c0 == 0.0 and len(terms) == 1:
                return terms[0][1], terms[0][0]
        return 1.0, node

    def sum(self, terms: Iterable[tuple[int, float]], c0: float = 0.0) -> int:
        """Return ``c0 + Σ coefficient · node``, with like terms collected."""
        collected: dict[int, float] = {}
        for node, coefficient in terms:
            op = self.ops[node]
            if op == "const":
                c0 += coefficient * self.args[node][0]
                continue
            if op == "sum":
                inner, inner_terms = self.args[node]
                if inner == 0.0 and len(inner_terms) == 1:
                    node, factor = inner_terms[0]
                    coefficient *= factor
            collected[node] = collected.get(node, 0.0) + coefficient
        pairs = tuple([(n, collected[n]) for n in sorted(collected) if collected[n] != 0.0])
        if not pairs:
            return self.const(c0)
        if c0 == 0.0:
            if len(pairs) == 1:
                return pairs[0][0] if pairs[0][1] == 1.0 else self.make("sum", (0.0, pairs))
            size = abs(pairs[0][1])
            if size != 1.0 and all(abs(c) == size for _, c in pairs):
                # 2a - 2b is 2(a - b): one multiplication, and a - b is shared.
                core = self.make("sum", (0.0, tuple((n, c / size) for n, c in pairs)))
                return self.make("sum", (0.0, ((core, size),)))
        return self.make("sum", (c0, pairs))

    def product(self, factors: Iterable[tuple[int, int]], coefficient: float = 1.0) -> int:
        """Return ``coefficient · Π node ** exponent``; nested products are flattened."""
        powers: dict[int, int] = {}
        counted, special = self._counted, []
        if (num_classified := len(counted)) != len(self.ops):
            counted += map(_is_counted, self.ops[num_classified:], self.args[num_classified:])
        for node, exponent in factors:
            if counted[node]:
                powers[node] = powers.get(node, 0) + exponent
            elif exponent == 1 and self.ops[node] == "const":
                coefficient *= self.args[node][0]
            else:
                special.append((node, exponent))
        if special:
            coefficient = self._multiply_out(special[::-1], powers, coefficient)
        pairs = tuple([(n, powers[n]) for n in sorted(powers) if powers[n] != 0])
        if coefficient == 0.0 or not pairs:
            return self.const(coefficient)
        core = pairs[0][0] if pairs[0][1] == 1 and len(pairs) == 1 else self.make("prod", pairs)
        if coefficient == 1.0:
            return core
        return self.make("sum", (0.0, ((core, coefficient),)))

    def _multiply_out(
        self, stack: list[tuple[int, int]], powers: dict[int, int], coefficient: float
    ) -> float:
        """Put factors that are not just counted into `powers`; return the coefficient."""
        ops = self.ops
        while stack:
            node, exponent = stack.pop()
            op = ops[node]
            if op not in _SPECIAL_FACTORS:
                powers[node] = powers.get(node, 0) + exponent
            elif exponent == 0:
                continue
            elif op == "const":
                coefficient *= _powi(self.args[node][0], exponent)
            elif op == "prod":
                stack += [(n, e * exponent) for n, e in self.args[node][::-1]]
            elif op == "sum":
                c0, terms = self.args[node]
                if c0 == 0.0 and len(terms) == 1:
                    coefficient *= _powi(terms[0][1], exponent)
                    stack.append((terms[0][0], exponent))
                elif terms[0][1] < 0.0:
                    # (b - a) is -(a - b): a sum used as a factor leads with a positive term.
                    node = self.sum([(n, -c) for n, c in terms], -c0)
                    if exponent % 2:
                        coefficient = -coefficient
                    powers[node] = powers.get(node, 0) + exponent
                else:
                    powers[node] = powers.get(node, 0) + exponent
            elif op == "sqrt" and abs(powers.get(node, 0) + exponent) >= 2:
                total = powers.pop(node, 0) + exponent
                half, odd = divmod(abs(total), 2)
                sign = 1 if total > 0 else -1
                if odd:
                    powers[node] = sign
                stack.append((self.args[node][0], sign * half))
            else:
                powers[node] = powers.get(node, 0) + exponent
        return coefficient

    def add(self, *nodes: int) -> int:
        """Return the sum of `nodes`."""
        return self.sum([(n, 1.0) for n in nodes])

    def sub(self, a: int, b: int) -> int:
        """Return ``a - b``."""
        return self.sum([(a, 1.0), (b, -1.0)])

    def neg(self, a: int) -> int:
        """Return ``-a``, pushed into a sum so that no negation is left over."""
        if self.ops[a] == "sum":
            c0, terms = self.args[a]
            return self.sum([(n, -c) for n, c in terms], -c0)
        return self.sum([(a, -1.0)])

    def mul(self, *nodes: int) -> int:
        """Return the product of `nodes`."""
        if len(nodes) == 2:
            a, b = nodes
            # Most products of forms and slopes are by one.
            for unit, factor in ((a, b), (b, a)):
                if unit == self.one and _is_counted(self.ops[factor], self.args[factor]):
                    return factor
        return self.product([(n, 1) for n in nodes])

    def div(self, a: int, b: int) -> int:
        """Return ``a / b``."""
        return self.product([(a, 1), (b, -1)])

    def powi(self, a: int, exponent: int) -> int:
        """Return ``a ** exponent`` for an integer exponent."""
        return self.product([(a, exponent)])

    # -- functions ------------------------------------------------------------------------------

    def call(self, op: str, *nodes: int) -> int:
        """Return a function, comparison, Boolean operation or ``select`` applied to nodes."""
        row = OPERATIONS[op]
        if op in _STEPS:
            self.has_steps = True
        values = [self.args[n][0] if self.ops[n] in ("const", "bool") else None for n in nodes]
        if row.rewrite is not None:
            simpler = row.rewrite(self, nodes, values)
            if simpler is not None:
                return simpler
        if None not in values:
            return self._folded(row, values)
        if row.parity and self.ops[nodes[0]] == "sum":
            # Saves a negation, and lets sin(a - b) share with sin(b - a).
            c0, terms = self.args[nodes[0]]
            if terms[0][1] < 0.0:
                flipped = self.make(op, (self.sum([(n, -c) for n, c in terms], -c0),))
                return flipped if row.parity == 1 else self.neg(flipped)
        return self.make(op, nodes)

    def _folded(self, row: Operation, values: Sequence[Any]) -> int:
        if row.truth:
            return self.boolean(row.numpy(*values))
        return self.const(_folded(row.numpy, *values))


def _is_counted(op: str, args: Args) -> bool:
    """Return whether a factor stays a factor of its own in a product."""
    if op != "sum":
        return op not in _SPECIAL_FACTORS
    c0, terms = args
    return terms[0][1] > 0.0 and (len(terms) > 1 or c0 != 0.0)


def _powi(base: float, exponent: int) -> float:
    return base if exponent == 1 else _folded(np.power, base, float(exponent))


def _folded(function: Callable[..., Any], *values: float) -> float:
    with np.errstate(all="ignore"):
        return float(function(*map(np.float64, values)))
