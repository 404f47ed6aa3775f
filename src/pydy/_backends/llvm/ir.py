"""Write LLVM IR as text, with loops as context managers.

Text, because parsing it in LLVM takes a tenth of the time that building the same instructions from
Python objects takes. Local variables live in ``alloca`` slots; LLVM's first pass turns them into
registers.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

WIDTHS = (1, 2, 4, 8)
"""How many lanes code may have."""

# Larger frames are allocated on the heap: threads have small stacks.
STACK_BYTES = 256 * 2**10
MALLOC = "@malloc"
_FRAME = "%frame"

HEAP_DECLARATIONS = f"declare ptr {MALLOC}(i64)\ndeclare void @free(ptr)\n"


def _align(kind: str) -> int:
    return 64 if kind.startswith("<") else 8


def _bytes(kind: str, count: int) -> int:
    """Return the room of `count` elements, rounded up to whole cache lines."""
    lanes = int(kind[1:].split()[0]) if kind.startswith("<") else 1
    return -(-8 * lanes * count // 64) * 64


def hex_double(value: float) -> str:
    """Return a double's exact bits in LLVM's notation."""
    return "0x" + struct.pack(">d", value).hex()


def vector_type(element: str, lanes: int) -> str:
    """Return the type of `lanes` elements side by side; one lane is the plain element."""
    return element if lanes == 1 else f"<{lanes} x {element}>"


def suffix(lanes: int) -> str:
    """Return how the names of intrinsics for `lanes` doubles end."""
    return "f64" if lanes == 1 else f"v{lanes}f64"


def literal(value: float, lanes: int) -> str:
    """Return a double constant in every lane."""
    text = hex_double(value)
    return text if lanes == 1 else f"splat (double {text})"


class IrFunction:
    """Builder of one IR function.

    Types and `parameters` are written as in IR: ``"ptr %a, i64 %n"``. `attributes` are the text
    before the type (linkage) and after the parameter list, separated by ``|``.
    """

    def __init__(self, name: str, returns: str, parameters: str, attributes: str = "|") -> None:
        before, _, after = attributes.partition("|")
        self._head = f"define {before} {returns} @{name}({parameters}) {after} {{"
        self._slots: list[str] = []
        self._frames: list[tuple[str, str, int]] = []  # name, type, count
        self.lines: list[str] = []
        self._count = 0
        self.current = "entry"  # label of the block being written, for phi nodes

    def text(self) -> str:
        """Return the text of the function."""
        frame, lines = self._frame(), self.lines
        if frame and MALLOC in frame[0]:
            lines = []
            for line in self.lines:
                if line.startswith("  ret "):
                    lines.append(f"  call void @free(ptr {_FRAME}.whole)")
                lines.append(line)
        return "\n".join([self._head, "entry:", *self._slots, *frame, *lines, "}", ""])

    def name(self, prefix: str = "v") -> str:
        """Return a fresh local name."""
        self._count += 1
        return f"%{prefix}.{self._count}"

    def let(self, code: str) -> str:
        """Write ``%new = code`` and return the new name."""
        result = self.name()
        self.lines.append(f"  {result} = {code}")
        return result

    def do(self, code: str) -> None:
        """Write an instruction without a result."""
        self.lines.append(f"  {code}")

    def label(self, label: str) -> None:
        """Begin a basic block."""
        self.lines.append(f"{label[1:]}:")
        self.current = label[1:]

    def slot(self, kind: str, count: int = 1) -> str:
        """Reserve stack memory in the entry block and return its pointer."""
        result = self.name("slot")
        self._frames.append((result, kind, count))
        return result

    def _frame(self) -> list[str]:
        """Return the lines that reserve the slots: on the stack, or on the heap if many."""
        sizes = [_bytes(kind, count) for _, kind, count in self._frames]
        if sum(sizes) <= STACK_BYTES:
            return [
                f"  {name} = alloca {kind}, i64 {count}, align {_align(kind)}"
                for name, kind, count in self._frames
            ]
        lines = [
            f"  {_FRAME}.whole = call ptr {MALLOC}(i64 {sum(sizes) + 64})",
            f"  {_FRAME}.start = ptrtoint ptr {_FRAME}.whole to i64",
            f"  {_FRAME}.past = add i64 {_FRAME}.start, 63",
            f"  {_FRAME}.even = and i64 {_FRAME}.past, -64",
            f"  {_FRAME} = inttoptr i64 {_FRAME}.even to ptr",
        ]
        offset = 0
        for (name, _, _), size in zip(self._frames, sizes, strict=True):
            lines.append(f"  {name} = getelementptr i8, ptr {_FRAME}, i64 {offset}")
            offset += size
        return lines

    def at(self, pointer: str, index: str, kind: str = "double") -> str:
        """Return the address of element `index`."""
        return self.let(f"getelementptr {kind}, ptr {pointer}, i64 {index}")

    def load(self, kind: str, pointer: str, index: str = "0") -> str:
        """Load value number `index` of type `kind`."""
        address = pointer if index == "0" else self.at(pointer, index, kind)
        return self.let(f"load {kind}, ptr {address}, align {1 if kind == 'i8' else 8}")

    def store(self, kind: str, value: str, pointer: str, index: str = "0") -> None:
        """Store a value; the counterpart of `load`."""
        address = pointer if index == "0" else self.at(pointer, index, kind)
        self.do(f"store {kind} {value}, ptr {address}, align {1 if kind == 'i8' else 8}")

    def lane_by_lane(self, name: str, vectors: Sequence[str], lanes: int) -> str:
        """Call a function of doubles for each lane of some vectors, each with its type."""
        if lanes == 1:
            return self.let(f"call double @{name}({', '.join(vectors)})")
        result = "poison"
        for lane in range(lanes):
            args = [self.let(f"extractelement {vector}, i32 {lane}") for vector in vectors]
            value = self.let(f"call double @{name}({', '.join('double ' + a for a in args)})")
            typed_vector = f"{vector_type('double', lanes)} {result}"
            result = self.let(f"insertelement {typed_vector}, double {value}, i32 {lane}")
        return result

    def variable(self, kind: str, value: str) -> str:
        """Return a slot that holds `value`; LLVM keeps it in a register if it can."""
        slot = self.name("slot")
        self._slots.append(f"  {slot} = alloca {kind}, align {_align(kind)}")
        self.do(f"store {kind} {value}, ptr {slot}")
        return slot

    def get(self, kind: str, slot: str) -> str:
        """Read a variable."""
        return self.let(f"load {kind}, ptr {slot}")

    def set(self, kind: str, slot: str, value: str) -> None:
        """Write a variable."""
        self.do(f"store {kind} {value}, ptr {slot}")

    @contextmanager
    def loop(self, start: str, stop: str, step: str = "1") -> Iterator[str]:
        """Write ``for i in range(start, stop, step)`` around the body; gives i. `step` > 0."""
        counter = self.variable("i64", start)
        head, body, end = self.name("head"), self.name("body"), self.name("end")
        self.do(f"br label {head}")
        self.label(head)
        continues = self.let(f"icmp slt i64 {self.get('i64', counter)}, {stop}")
        self.do(f"br i1 {continues}, label {body}, label {end}")
        self.label(body)
        i = self.get("i64", counter)
        yield i
        self.set("i64", counter, self.let(f"add nsw i64 {i}, {step}"))
        self.do(f"br label {head}")
        self.label(end)
