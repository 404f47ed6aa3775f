"""Linear solves as part of a stage: matrices for fallbacks, the guards, and their solutions."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import chain
from typing import Protocol

from pydy._backends.llvm.ir import Function, literal, vector_type
from pydy._backends.llvm.plan import Registers
from pydy._backends.llvm.solve import mask, solver_names
from pydy._backends.tuning import FALLBACK_STACK, SPARSE
from pydy._graph.operations import is_constrained, is_symmetric
from pydy._graph.program import Program

__all__ = ["Solves", "Writer"]


def _stored(n: int, entries: tuple[int, ...]) -> list[int]:
    """Return what a guard's fallback needs of a matrix: of a symmetric one the lower triangle."""
    lower = list(chain.from_iterable(entries[i * n : i * n + i + 1] for i in range(n)))
    return lower if n > 1 and is_symmetric(n, entries) else list(entries)


class Writer(Protocol):
    """What writes the stage's other operations."""

    f: Function
    program: Program
    lanes: int
    v: str
    b: str
    setup: bool
    names: Registers

    fallbacks: bool

    def computed(self, node: int) -> bool:
        """Return whether an operation of the stage gives the value."""

    def place(self, node: int, pointer: str, index: int, until: int = -1) -> None:
        """Have a value written to memory as soon as it is computed."""

    def load_carried(self, node: int) -> None:
        """Read a value of the setup stage."""

    def write_fallback(self, guard: int) -> None:
        """Write what only the fallback of a guard needs."""

    def divide(self) -> None:
        """Begin another basic block if this one has become long."""


class Solves:
    """Writes factorisations, solves and guards, and says where solutions lie in memory."""

    def __init__(self, writer: Writer) -> None:
        self.e = writer
        self.f, self.v, self.b = writer.f, writer.v, writer.b
        self.lanes, self.program, self.names = writer.lanes, writer.program, writer.names
        self.vectors: dict[int, list[tuple[str, int]]] = {}
        self.status = ""
        self._weak = ""  # the lanes of the fallback that is written, if any
        self._factors: dict[int, dict[str, str]] = {}
        self._kept: dict[int, str] = {}
        self._routines = solver_names(writer.lanes)

    def reserve(self) -> None:
        """Make room for what guards need.

        A matrix for the fallback is written as soon as its entries are computed: kept alive in
        registers until the guard, they would crowd out what the elimination works with. Numbers
        and values of the setup stage are left to the fallback.

        A solution is written where it is wanted, and the fallback overwrites it there.
        """
        program = self.program
        guards = {}
        for k, (op, args) in enumerate(zip(program.ops, program.args, strict=True)):
            if op != "guard" or program.setup[k] != self.e.setup:
                continue
            if self.e.fallbacks:
                self._keep_matrix(k, _stored(*args[:2]))
            fast = args[4]
            guards[k] = fast
            self.vectors[k] = [("", 0)] * len(fast)
        if not guards:
            return
        if not self.e.setup:
            wanted = {k: index for index, k in reversed(list(enumerate(program.outputs)))}
            for k, op in enumerate(program.ops):
                if op == "item" and k in wanted and program.args[k][0] in guards:
                    guard, index = program.args[k]
                    self.vectors[guard][index] = ("%out", wanted[k])
        for guard, fast in guards.items():
            vector = self.vectors[guard]
            rest = [index for index, place in enumerate(vector) if not place[0]]
            room = self.f.slot(self.v, len(rest)) if rest else ""
            for index, k in enumerate(rest):
                vector[k] = (room, index)
            for node, (pointer, index) in zip(fast, vector, strict=True):
                if self.e.computed(node):
                    self.e.place(node, pointer, index, guard)

    def _keep_matrix(self, guard: int, stored: list[int]) -> None:
        moving = self._moving(stored)
        sparse = len(stored) > SPARSE * len(moving)
        self._kept[guard] = self.f.slot(self.v, max(len(moving if sparse else stored), 1))
        for place, node in enumerate(moving if sparse else stored):
            if self.e.computed(node):
                self.e.place(node, self._kept[guard], place, guard)

    def _moving(self, stored: list[int]) -> list[int]:
        """Return the entries of a matrix that are computed at every call."""
        return list(dict.fromkeys(k for k in stored if self.e.computed(k)))

    def _buffer(self, nodes: tuple[int, ...]) -> str:
        pointer = self.f.slot(self.v, len(nodes))
        for k, node in enumerate(nodes):
            self.f.store(self.v, self.names[node], pointer, str(k))
        return pointer

    def _report(self, bad: str) -> None:
        f = self.f
        f.set("i32", self.status, f.let(f"or i32 {f.get('i32', self.status)}, {bad}"))

    def _lu(self, a: str, n: int, lanes: str) -> tuple[str, str, str]:
        """Factorise the lanes named by the mask in place; gives buffers and who is singular."""
        f = self.f
        pivots = f.slot(vector_type("i64", self.lanes), n)
        scales = f.slot("double", 2 * n)
        bad = f.let(
            f"call i32 @{self._routines[0]}(ptr {a}, ptr {pivots}, ptr {scales}, ptr null, "
            f"i64 {n}, i32 {lanes})"
        )
        return pivots, scales, bad

    def factor(self, node: int, kind: str, n: int, entries: tuple[int, ...]) -> None:
        f = self.f
        a = self._buffer(entries)
        every = str((1 << self.lanes) - 1)
        if kind == "lu":
            pivots, scales, bad = self._lu(a, n, every)
            self._report(bad)
            self._factors[node] = {
                "a": a,
                "pivots": pivots,
                "scales": scales,
                "mask": every,
            }
            return
        spd = self._buffer(entries)
        inverse = f.slot(self.v, n)
        need = f.let(f"call i32 @{self._routines[1]}(ptr {spd}, ptr {inverse}, i64 {n})")
        # With an empty mask this call returns at once.
        pivots, scales, bad = self._lu(a, n, need)
        self._report(bad)
        self._factors[node] = {
            "a": a, "pivots": pivots, "scales": scales, "mask": need,
            "spd": spd, "inverse": inverse,
        }  # fmt: skip

    def solve(self, node: int, factor: int, column: tuple[int, ...]) -> None:
        f = self.f
        data = self._factors[factor]
        n = len(column)
        b = self._buffer(column)
        call = (
            f"call i32 @{self._routines[0]}(ptr {data['a']}, ptr {data['pivots']}, "
            f"ptr {data['scales']}, ptr {b}, i64 {n}, i32 {data['mask']})"
        )
        if "spd" not in data:
            f.let(call)
            self.vectors[node] = [(b, k) for k in range(n)]
            return
        x = self._buffer(column)
        f.do(
            f"call void @{self._routines[2]}(ptr {data['spd']}, ptr {data['inverse']}, ptr {x}, "
            f"i64 {n})"
        )
        self.vectors[node] = [(x, k) for k in range(n)]
        with self._fallback(f.let(f"icmp ne i32 {data['mask']}, 0")):
            f.let(call)
            fast = [f.load(self.v, x, str(k)) for k in range(n)]
            for k, value in enumerate(self._choose(data["mask"], b, fast)):
                f.store(self.v, value, x, str(k))

    @contextmanager
    def _fallback(self, weak: str) -> Iterator[None]:
        """Write ``if weak:`` around the body, which is hardly ever executed."""
        f = self.f
        slow, join = f.name("weak"), f.name("solved")
        f.do(f"br i1 {weak}, label {slow}, label {join}, !prof !0")
        f.label(slow)
        with self.names.aside():
            yield
        f.do(f"br label {join}")
        f.label(join)

    def _choose(self, lanes: str, slow: str, fast: list[str]) -> list[str]:
        """Take the lanes named by the mask from memory, the others as they are."""
        f = self.f
        if self.lanes == 1:
            return [f.load(self.v, slow, str(k)) for k in range(len(fast))]
        bits = f.let(f"trunc i32 {lanes} to i{self.lanes}")
        flags = f.let(f"bitcast i{self.lanes} {bits} to {self.b}")
        return [
            f.let(f"select {self.b} {flags}, {self.v} {f.load(self.v, slow, str(k))}, {self.v} {x}")
            for k, x in enumerate(fast)
        ]

    def guard(
        self,
        node: int,
        n: int,
        entries: tuple[int, ...],
        column: tuple[int, ...],
        sound: int,
        fast: tuple[int, ...],
    ) -> None:
        f, v, names = self.f, self.v, self.names
        places = self.vectors[node]
        for value, (pointer, index) in zip(fast, places, strict=True):
            if not self.e.computed(value):
                f.store(v, names[value], names.place(pointer, index))
        need = f.let(f"xor i32 {mask(f, names[sound], self.lanes)}, {(1 << self.lanes) - 1}")
        around = self._weak
        if around:
            need = f.let(f"and i32 {need}, {around}")
        with self._fallback(f.let(f"icmp ne i32 {need}, 0")):
            if not self.e.fallbacks:
                self._report("-1")
                return
            self._weak = need
            self.e.write_fallback(node)
            self._weak = around
            stored = _stored(n, entries)
            symmetric = len(stored) < n * n
            matrix, scratch, room = self._filled(node, n, stored, symmetric)
            b = self._buffer(column)
            if symmetric:
                bad = f.let(
                    f"call i32 @{self._routines[3]}(ptr {matrix}, ptr {b}, ptr {scratch}, "
                    f"i64 {n}, i32 {need})"
                )
            elif is_constrained(self.program, entries):
                pivots = f.slot(vector_type("i64", self.lanes), n)
                bad = f.let(
                    f"call i32 @{self._routines[4]}(ptr {matrix}, ptr {pivots}, "
                    f"ptr {f.slot('double', 2 * n)}, ptr {b}, i64 {n}, i32 {need})"
                )
            else:
                pivots, scales, bad = self._lu(matrix, n, need)
                f.let(
                    f"call i32 @{self._routines[0]}(ptr {matrix}, ptr {pivots}, ptr {scales}, "
                    f"ptr {b}, i64 {n}, i32 {need})"
                )
            self._report(bad)
            if room:
                f.do(f"call void @free(ptr {room})")
            quick = [names[k] for k in fast] if self.lanes > 1 else [""] * n
            chosen = self._choose(need, b, quick)
            for solved, (pointer, index) in zip(chosen, places, strict=True):
                f.store(v, solved, names.place(pointer, index))

    def _filled(
        self, guard: int, n: int, stored: list[int], symmetric: bool
    ) -> tuple[str, str, str]:
        """Complete a matrix; gives it, scratch memory, and what is to be freed.

        A sparse one is written out only here. More than a little memory is taken from the heap.
        """
        f, v = self.f, self.v
        moving = {node: k for k, node in enumerate(self._moving(stored))}
        matrix, room = self._kept[guard], ""
        work = n * n + 3 * n
        sparse = len(stored) > SPARSE * len(moving)
        if not sparse:
            scratch = f.slot(v, work) if symmetric else ""
        else:
            count = len(stored) + work
            size = 8 * self.lanes * count
            heap = size > FALLBACK_STACK
            matrix = f.let(f"call ptr @malloc(i64 {size})") if heap else f.slot(v, count)
            room = matrix if heap else ""
            scratch = f.at(matrix, str(len(stored)), v)
            with f.loop("0", str(len(stored))) as item:
                f.store(v, literal(0.0, self.lanes), matrix, item)
            for place, node in enumerate(stored):
                if node in moving:
                    self.e.divide()
                    value = f.load(v, self._kept[guard], str(moving[node]))
                    f.store(v, value, matrix, str(place))
        done = {*moving, *(k for k in {*stored} if self._is_zero(k))} if sparse else moving
        for place, node in enumerate(stored):
            if node not in done:
                self.e.divide()
                self.e.load_carried(node)
                f.store(v, self.names[node], matrix, str(place))
        return matrix, scratch, room

    def _is_zero(self, node: int) -> bool:
        return self.program.ops[node] == "const" and self.program.args[node][0] == 0.0
