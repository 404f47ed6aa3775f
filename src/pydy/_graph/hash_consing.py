"""Operations that are kept once: what expression graphs and Programs are made of."""

from __future__ import annotations

from typing import Any

from pydy._graph.operations import operands

# Solves report failures, which only calls can do.
_REPORTING = frozenset({"factor", "solve", "guard", "item"})


class Nodes:
    """Hash-consed operations on earlier ones, in topological order."""

    def __init__(self) -> None:
        self.ops: list[str] = []  # the kind of each node
        self.args: list[tuple[Any, ...]] = []  # its operands, and what else it takes
        self.constant: list[bool] = []  # whether it depends on inputs 'p' and numbers alone
        self._operands: list[tuple[int, ...]] = []
        self._known: dict[tuple[Any, ...], int] = {}

    def node(self, op: str, args: tuple[Any, ...], apart: int | None = None) -> int:
        """Return the node for `op` on `args` as they are, without any rewriting.

        Given `apart`, it is another one than without, unless it depends on constants alone.
        """
        key: tuple[Any, ...] = (op, args)
        if apart is not None and not self._is_constant(op, args, operands(op, args)):
            key = (op, args, apart)
        node = self._known.get(key)
        if node is None:
            node = len(self.ops)
            self._known[key] = node
            self.ops.append(op)
            self.args.append(args)
            needs = operands(op, args)
            self._operands.append(needs)
            self.constant.append(self._is_constant(op, args, needs))
        return node

    def _is_constant(self, op: str, args: tuple[Any, ...], needs: tuple[int, ...]) -> bool:
        if op == "input":
            return bool(args[0] == "p")
        return op not in _REPORTING and all(map(self.constant.__getitem__, needs))
