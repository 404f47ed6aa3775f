"""Plan the instructions of a Program: fused multiply-adds, register allocation and spill slots."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import NamedTuple

from pydy._backends.llvm.ir import IrFunction
from pydy._program import OPERATIONS, Program

ValueLocation = str | tuple[str, int]


class ArrayLayout(NamedTuple):
    """The memory layout of arrays that are not contiguous vectors."""

    steps: Mapping[str, int]  # the distances between the items of an array
    broadcast: Sequence[str] = ()  # arrays with one number for all lanes


class RegisterAllocator:
    """The names of values in registers, and the addresses of values in memory.

    LLVM spills more values of straight-line code than necessary, and spilling wide vectors limits
    kernels of many lanes. Here the value whose next use is farthest away is spilled first, which
    needs the fewest spills (Belady, IBM Systems Journal 5, 1966, 78-101), and a value that is in
    memory already is not stored again. Values are usually reloaded in a later basic block, where
    LLVM cannot undo the spill.

    Numbers have the type `v`; at most `capacity` of them are in registers. `uses` are the
    operations that read a value, in the order in which they are written.
    """

    def __init__(self, f: IrFunction, v: str, capacity: int, uses: dict[int, list[int]]) -> None:
        self._f = f
        self._v = v
        self._capacity = capacity
        self._uses = {
            node: operations[::-1] for node, operations in uses.items()
        }  # the next one last
        self._fixed: dict[int, str] = {}
        self._names: dict[int, str] = {}
        self._homes: dict[int, tuple[str, int]] = {}
        self._slots: dict[int, str] = {}  # spill slots
        self._free: list[str] = []
        self.steps: dict[str, str] = {}  # see `ArrayLayout`; literals or names
        self._broadcast: Sequence[str] = ()

    def set_layout(self, layout: ArrayLayout | None) -> None:
        """Set the layout of the arrays."""
        if layout is not None:
            self.steps.update({name: str(step) for name, step in layout.steps.items()})
            self._broadcast = layout.broadcast

    def fix(self, node: int, name: str) -> None:
        """Name a value that takes no register of this kind: a literal, a truth value."""
        self._fixed[node] = name

    def home(self, node: int, pointer: str, index: int) -> None:
        """Set the address of a value in memory."""
        self._homes.setdefault(node, (pointer, index))

    def is_stored_at(self, node: int, pointer: str, index: int) -> bool:
        """Return whether a value is stored at this address."""
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
            kind = "double" if pointer in self._broadcast else self._v
            name = self._f.load(kind, self.address(pointer, index))
            if kind != self._v:
                vector = self._f.let(f"insertelement {self._v} poison, double {name}, i32 0")
                zeros = self._v.replace("double", "i32")
                vectors = f"{self._v} {vector}, {self._v} poison, {zeros} zeroinitializer"
                name = self._f.let(f"shufflevector {vectors}")
            self._names[node] = name
        return name

    def address(self, pointer: str, index: int) -> str:
        """Return the address of an item."""
        if index == 0:
            return pointer
        if pointer in self.steps:
            distance = self._f.let(f"mul i64 {self.steps[pointer]}, {index}")
            return self._f.at(pointer, distance)
        return self._f.at(pointer, str(index), self._v)

    def release(self, position: int, free_registers: int = 0) -> None:
        """Release values after the operation at `position`; spill until some registers are free."""
        names = self._names
        for node in list(names):
            uses = self._uses.get(node)
            while uses and uses[-1] <= position:
                uses.pop()
            if not uses:
                del names[node]
                if node in self._slots:
                    self._free.append(self._slots.pop(node))
        while len(names) > self._capacity - free_registers:
            node = max(names, key=lambda k: self._uses[k][-1])
            if node not in self._homes:
                slot = self._free.pop() if self._free else self._f.slot(self._v)
                self._f.store(self._v, names[node], slot)
                self._homes[node] = (slot, 0)
                self._slots[node] = slot
            del names[node]

    @contextmanager
    def restored_after(self) -> Iterator[None]:
        """Restore the allocation after the body: its loads are on a branch that may be skipped."""
        names, homes, fixed = dict(self._names), dict(self._homes), dict(self._fixed)
        slots, free = dict(self._slots), list(self._free)
        yield
        self._names, self._homes, self._fixed = names, homes, fixed
        self._slots, self._free = slots, free


def readers(
    program: Program, absorbed: set[int], setup: bool, selected: frozenset[int] | None = None
) -> dict[int, list[int]]:
    """Return the operations of a stage that read each value, in order.

    With `selected` only those operations are written, and no fallbacks.

    Values that only a guard's fallback needs are read by the guard. The factors of a product that
    is fused into a sum are read by the sum. A matrix that is stored for a fallback is not read.
    """
    guards = {k: guard for guard, nodes in program.fallback.items() for k in nodes}
    uses: dict[int, list[int]] = {}

    def read(node: int, reader: int) -> None:
        op, args = program.ops[node], program.args[node]
        needs = OPERATIONS.operands(op, args)
        if op == "guard":
            needs = (*args[2], args[3], *args[4]) if selected is None else (args[3], *args[4])
        for operand in needs:
            if operand in absorbed:
                read(operand, reader)
            else:
                # A value that is deferred less far must be available at the guard.
                position, own_guard = reader, guards.get(operand)
                while (guard := guards.get(position)) is not None and guard != own_guard:
                    position = guard
                uses.setdefault(operand, []).append(position)

    for k in range(len(program.ops)) if selected is None else sorted(selected):
        if program.setup[k] == setup and k not in absorbed:
            read(k, k)
    return {node: sorted(operations) for node, operations in uses.items()}


def fusion(program: Program) -> tuple[set[int], set[int]]:
    """Return the sums that are fused with a product, and the products that they absorb.

    This is decided here and not by LLVM, so that the last bit is the same for any number of lanes
    and any optimisation level.
    """
    uses = Counter(
        k
        for op, a in zip(program.ops, program.args, strict=True)
        for k in OPERATIONS.operands(op, a)
    )
    uses.update(program.outputs)
    uses.update(program.carried)
    fused: set[int] = set()
    absorbed: set[int] = set()
    for node, (op, args) in enumerate(zip(program.ops, program.args, strict=True)):
        if op in ("add", "sub"):
            for k in reversed(args):
                same_stage = program.setup[k] == program.setup[node]
                if program.ops[k] == "mul" and uses[k] == 1 and same_stage:
                    fused.add(node)
                    absorbed.add(k)
                    break
    return fused, absorbed
