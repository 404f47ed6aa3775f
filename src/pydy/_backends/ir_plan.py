"""What is decided before the instructions of a Program are written.

Which products go into sums, which values wait in memory, and what they are called meanwhile.
"""

from __future__ import annotations

from collections import Counter

from pydy._backends.ir import Function
from pydy._graph.node import COMPARISONS
from pydy._graph.program import Program, operands

__all__ = ["BLOCK", "TRUTHS", "Names", "Place", "fusion", "needed_later"]

TRUTHS = frozenset({*COMPARISONS, "and", "or", "not"})

# Operations in one basic block. LLVM's time grows faster than a block's length; values that are
# needed in a later block wait in memory, so that no register has to be kept for them meanwhile.
BLOCK = 200

Place = str | tuple[str, int]


class Names:
    """What values are called in the block that is being written, and where in memory they wait."""

    def __init__(self, f: Function, v: str) -> None:
        self._f = f
        self._v = v
        self._known: dict[int, tuple[str, int]] = {}  # name, and the block it was made in
        self._homes: dict[int, tuple[str, int]] = {}
        self._needed_later: set[int] = set()
        self._block = 0

    def keep(self, nodes: set[int]) -> None:
        """Say which values are needed in a later block than the one they are made in."""
        self._needed_later = nodes

    def new_block(self) -> None:
        """Forget the names of all values that wait in memory."""
        self._block += 1

    def at(self, node: int, place: Place) -> None:
        """Name a value, or say where in memory it lies."""
        if isinstance(place, tuple):
            self._homes[node] = place
        else:
            self[node] = place

    def __contains__(self, node: int) -> bool:
        return node in self._known or node in self._homes

    def __setitem__(self, node: int, name: str) -> None:
        self._known[node] = (name, self._block)
        if node in self._needed_later and node not in self._homes:
            slot = self._f.slot(self._v)
            self._f.store(self._v, name, slot)
            self._homes[node] = (slot, 0)

    def __getitem__(self, node: int) -> str:
        name, block = self._known.get(node, ("", -1))
        home = self._homes.get(node)
        if home is not None and block != self._block:
            name = self._f.load(self._v, home[0], str(home[1]))
            self._known[node] = (name, self._block)
        return name


def needed_later(program: Program, swallowed: set[int], setup: bool) -> set[int]:
    """Return the numbers of a stage that are used in a later block than their own.

    A fallback is a block of its own; so is, between its lines, each of its operations.
    """
    put_off = {k for nodes in program.fallback.values() for k in nodes}
    block = {}
    count = 0
    later: set[int] = set()
    for k, op in enumerate(program.ops):
        if program.setup[k] != setup or op in ("const", "bool", "input") or k in swallowed:
            continue
        if k in put_off:
            later.update(operands(op, program.args[k]))
            continue
        block[k] = count // BLOCK
        count += 1
        stack = list(operands(op, program.args[k]))
        while stack:
            other = stack.pop()
            if other in swallowed and other not in put_off:
                stack.extend(program.args[other])
            elif other in block and block[other] != block[k]:
                later.add(other)
    if not setup:
        later.update(k for k in program.outputs if k in block and block[k] != count // BLOCK)
    kinds = TRUTHS | {"factor", "solve", "guard"}
    return {k for k in later if k in block and k not in swallowed and program.ops[k] not in kinds}


def fusion(program: Program) -> tuple[set[int], set[int]]:
    """Return the sums that take a product along, and the products that vanish in them.

    Decided here and not by LLVM, so that the last bit is the same for any number of lanes and at
    any level of its effort.
    """
    uses = Counter(
        k for op, a in zip(program.ops, program.args, strict=True) for k in operands(op, a)
    )
    uses.update(program.outputs)
    uses.update(program.carried)
    fused: set[int] = set()
    swallowed: set[int] = set()
    for node, (op, args) in enumerate(zip(program.ops, program.args, strict=True)):
        if op in ("add", "sub"):
            for k in reversed(args):
                same_stage = program.setup[k] == program.setup[node]
                if program.ops[k] == "mul" and uses[k] == 1 and same_stage:
                    fused.add(node)
                    swallowed.add(k)
                    break
    return fused, swallowed
