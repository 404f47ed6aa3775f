"""What is decided before the instructions of a Program are written.

Which products go into sums, which values wait in memory, and what they are called meanwhile.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import NamedTuple

from pydy._backends.llvm.ir import Function
from pydy._program import OPERATIONS, Program

Place = str | tuple[str, int]


class Layout(NamedTuple):
    """How arrays lie that are not one vector after the other."""

    steps: Mapping[str, int]  # the distances between the items of an array
    spread: Sequence[str] = ()  # arrays of numbers that all lanes have in common


class Registers:
    """The values in registers with their names, and the places in memory of the others.

    LLVM writes more values of straight-line code to memory than it must, and writing wide vectors
    to memory limits kernels of many lanes. Here the value whose next use is
    farthest away leaves first, which needs the fewest (Belady, IBM Systems Journal 5, 1966,
    78-101), and what lies in memory anyway is never written a second time. Values that come back
    do so, as a rule, in a later basic block, where LLVM cannot undo it.

    A number has the type `v`, and so many may be at hand as the capacity says; `uses` are the
    operations, in the order they are written, that read a value.
    """

    def __init__(self, f: Function, v: str, capacity: int, uses: dict[int, list[int]]) -> None:
        self._f = f
        self._v = v
        self._capacity = capacity
        self._uses = {node: places[::-1] for node, places in uses.items()}  # the next one last
        self._fixed: dict[int, str] = {}
        self._names: dict[int, str] = {}
        self._homes: dict[int, tuple[str, int]] = {}
        self._slots: dict[int, str] = {}  # of values that were moved to memory to make room
        self._free: list[str] = []
        self.steps: dict[str, str] = {}  # see `Layout`; numbers, or names of them
        self._spread: Sequence[str] = ()

    def lie(self, layout: Layout | None) -> None:
        """Say how arrays lie."""
        if layout is not None:
            self.steps.update({name: str(step) for name, step in layout.steps.items()})
            self._spread = layout.spread

    def fix(self, node: int, name: str) -> None:
        """Name a value that takes no register of this kind: a literal, a truth value."""
        self._fixed[node] = name

    def home(self, node: int, pointer: str, index: int) -> None:
        """Say where in memory a value lies."""
        self._homes.setdefault(node, (pointer, index))

    def lies_at(self, node: int, pointer: str, index: int) -> bool:
        """Return whether a value is in that place of memory."""
        return self._homes.get(node) == (pointer, index)

    def last_use(self, node: int) -> int:
        """Return the last operation that has yet to read a value, or -1."""
        uses = self._uses.get(node)
        return uses[0] if uses else -1

    def __contains__(self, node: int) -> bool:
        return node in self._names or node in self._homes or node in self._fixed

    def __setitem__(self, node: int, name: str) -> None:
        self._names[node] = name

    def __getitem__(self, node: int) -> str:
        name = self._fixed.get(node) or self._names.get(node)
        if name is None:
            pointer, index = self._homes[node]
            kind = "double" if pointer in self._spread else self._v
            name = self._f.load(kind, self.place(pointer, index))
            if kind != self._v:
                one = self._f.let(f"insertelement {self._v} poison, double {name}, i32 0")
                zeros = self._v.replace("double", "i32")
                vectors = f"{self._v} {one}, {self._v} poison, {zeros} zeroinitializer"
                name = self._f.let(f"shufflevector {vectors}")
            self._names[node] = name
        return name

    def place(self, pointer: str, index: int) -> str:
        """Return the address of an item."""
        if index == 0:
            return pointer
        if pointer in self.steps:
            distance = self._f.let(f"mul i64 {self.steps[pointer]}, {index}")
            return self._f.at(pointer, distance)
        return self._f.at(pointer, str(index), self._v)

    def leave(self, position: int, room: int = 0) -> None:
        """Let values go once the operation at `position` is written, until `room` more fit in."""
        known = self._names
        for node in list(known):
            uses = self._uses.get(node)
            while uses and uses[-1] <= position:
                uses.pop()
            if not uses:
                del known[node]
                if node in self._slots:
                    self._free.append(self._slots.pop(node))
        while len(known) > self._capacity - room:
            node = max(known, key=lambda k: self._uses[k][-1])
            if node not in self._homes:
                slot = self._free.pop() if self._free else self._f.slot(self._v)
                self._f.store(self._v, known[node], slot)
                self._homes[node] = (slot, 0)
                self._slots[node] = slot
            del known[node]

    @contextmanager
    def aside(self) -> Iterator[None]:
        """Forget, at the end of the block, values loaded on a branch that is not always taken."""
        names, homes, fixed = dict(self._names), dict(self._homes), dict(self._fixed)
        slots, free = dict(self._slots), list(self._free)
        yield
        self._names, self._homes, self._fixed = names, homes, fixed
        self._slots, self._free = slots, free


def readers(
    program: Program, swallowed: set[int], setup: bool, wanted: frozenset[int] | None = None
) -> dict[int, list[int]]:
    """Return which operations of a stage read each value, in order.

    With `wanted` only those operations are written, and no fallbacks.

    What only a guard's fallback needs is read by the guard, and a product that goes into a sum
    is read, with its factors, by the sum. A matrix that is kept for a fallback is not read.
    """
    guards = {k: guard for guard, nodes in program.fallback.items() for k in nodes}
    uses: dict[int, list[int]] = {}

    def read(node: int, reader: int) -> None:
        op, args = program.ops[node], program.args[node]
        needs = OPERATIONS.operands(op, args)
        if op == "guard":
            needs = (*args[2], args[3], *args[4]) if wanted is None else (args[3], *args[4])
        for other in needs:
            if other in swallowed:
                read(other, reader)
            else:
                # What is not put off as far must be at hand when the guard is reached.
                position, own = reader, guards.get(other)
                while (guard := guards.get(position)) is not None and guard != own:
                    position = guard
                uses.setdefault(other, []).append(position)

    for k in range(len(program.ops)) if wanted is None else sorted(wanted):
        if program.setup[k] == setup and k not in swallowed:
            read(k, k)
    return {node: sorted(places) for node, places in uses.items()}


def fusion(program: Program) -> tuple[set[int], set[int]]:
    """Return the sums that take a product along, and the products that vanish in them.

    Decided here and not by LLVM, so that the last bit is the same for any number of lanes and at
    any level of its effort.
    """
    uses = Counter(
        k
        for op, a in zip(program.ops, program.args, strict=True)
        for k in OPERATIONS.operands(op, a)
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
