"""Operations on earlier ones, each stored once (hash-consing)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

import numpy as np

from pydy._program.interpret import SampleValues
from pydy._program.operations import OPERATIONS, Args

Evaluator = Callable[[Mapping[int, float | np.ndarray], int], np.ndarray]

# Solves report failures, which only calls can do.
_REPORTING = OPERATIONS.solves | {"item"}


class Nodes:
    """Hash-consed operations on earlier ones, in topological order."""

    def __init__(self) -> None:
        self.ops: list[str] = []  # the kind of each node
        self.args: list[Args] = []  # its operands, and what else it takes
        self.constant: list[bool] = []  # whether it depends on inputs 'p' and numbers alone
        self._operands: list[tuple[int, ...]] = []
        self._node_of: dict[tuple[object, ...], int] = {}

    def node(self, op: str, args: Args, guard: int | None = None) -> int:
        """Return the node for `op` on `args` as they are, without any rewriting.

        With a `guard`, the node is private to the fallback of that guard, unless it depends on
        constants alone.
        """
        key: tuple[object, ...] = (op, args)
        if guard is not None and not self._is_constant(op, args, OPERATIONS.operands(op, args)):
            key = (op, args, guard)
        node = self._node_of.get(key)
        if node is None:
            node = len(self.ops)
            self._node_of[key] = node
            self.ops.append(op)
            self.args.append(args)
            needs = OPERATIONS.operands(op, args)
            self._operands.append(needs)
            self.constant.append(self._is_constant(op, args, needs))
        return node

    def _is_constant(self, op: str, args: Args, needs: tuple[int, ...]) -> bool:
        if op == "input":
            return bool(args[0] == "p")
        return op not in _REPORTING and all(map(self.constant.__getitem__, needs))

    def operands(self, node: int) -> tuple[int, ...]:
        """Return the nodes that `node` refers to, in order."""
        return self._operands[node]

    def reachable(self, roots: Iterable[int], *, fallbacks: bool = True) -> list[int]:
        """Return every node the roots need, in topological (ascending) order.

        Without `fallbacks`, the systems that guards fall back to are left out, but not those that
        are always solved.
        """
        ops, needs = self.ops, self._operands
        never = self._node_of.get(("bool", (False,)))
        needed = bytearray(len(needs))
        for node in roots:
            needed[node] = 1
        order = []
        # Backwards: operands stand before the nodes that refer to them.
        node = needed.rfind(1)
        while node >= 0:
            order.append(node)
            operands = needs[node]
            if not fallbacks and ops[node] == "guard" and self.args[node][3] != never:
                sound, fast = self.args[node][3:]
                operands = (sound, *fast)
            for operand in operands:
                needed[operand] = 1
            node = needed.rfind(1, 0, node)
        order.reverse()
        return order

    def evaluator(self, nodes: Sequence[int]) -> Evaluator:
        """Return a function that evaluates nodes with NumPy at m samples.

        It takes a number or m numbers for each input node, and m. It returns an array of shape
        (m, number of nodes).
        """
        order = self.reachable(nodes)

        def values_at(inputs: Mapping[int, float | np.ndarray], m: int) -> np.ndarray:
            samples = SampleValues(self, inputs.__getitem__, m, {})
            samples.evaluate(order, np.ones(m, dtype=bool))
            return samples.columns(nodes)

        return values_at
