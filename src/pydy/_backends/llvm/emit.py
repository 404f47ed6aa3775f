"""The operations of a Program as LLVM instructions, one stage at a time.

Instructions carry no fast-math flags. Products and sums are fused into multiply-adds here, not in
LLVM, so that the last bit depends neither on LLVM's optimisation level nor on the number of lanes.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import chain

from pydy._backends.llvm.ir import WIDTHS, IrFunction, literal, suffix, vector_type
from pydy._backends.llvm.plan import RegisterAllocator, ValueLocation, fusion, readers
from pydy._backends.llvm.sincos import sincos, sincos_together
from pydy._backends.llvm.targets import target
from pydy._backends.tuning import PACKED, SPARSE, TEMPORARY
from pydy._program import OPERATIONS, Program, is_constrained, symmetric

# -- Linear solves as part of a stage: matrices for fallbacks, the guards, and their solutions -----

_ROUTINES = {
    "lu": "i32 (ptr, ptr, ptr, ptr, i64, i32)",
    "ldl_factor": "i32 (ptr, ptr, i64)",
    "ldl_solve": "void (ptr, ptr, ptr, i64)",
    "guard": "i32 (ptr, ptr, i64, ptr, i64, i32)",
    "constrained": "i32 (ptr, ptr, ptr, ptr, i64, i64, i32)",
}

ARCTANGENT = "atan.lanes"
"""The name of the function of `pydy._backends.llvm.arctangent`, before the number of lanes."""


def solver_names(lanes: int) -> tuple[str, ...]:
    """Return the routines of ``core/solve.h`` that a kernel of `lanes` lanes may call."""
    return tuple(f"pydy_{name}_{lanes}" for name in _ROUTINES)


def solver_declarations(lanes: int) -> str:
    """Return their IR declarations."""
    heads = (kind.partition(" ") for kind in _ROUTINES.values())
    pairs = zip(solver_names(lanes), heads, strict=True)
    return "".join(
        f"declare {result} @{name}{parameters}\n" for name, (result, _, parameters) in pairs
    )


def mask(f: IrFunction, flags: str, lanes: int) -> str:
    """Return a vector of truth values as the bits of an i32."""
    if lanes == 1:
        return f.let(f"zext i1 {flags} to i32")
    bits = f.let(f"bitcast <{lanes} x i1> {flags} to i{lanes}")
    return bits if lanes == 32 else f.let(f"zext i{lanes} {bits} to i32")


def _stored(n: int, entries: tuple[int, ...]) -> list[int]:
    """List the entries that a guard's fallback needs: the lower triangle if symmetric."""
    lower = list(chain.from_iterable(entries[i * n : i * n + i + 1] for i in range(n)))
    return lower if n > 1 and (symmetric(n, entries) == list(entries)) else list(entries)


class Solves:
    """Writes factorisations, solves and guards; `vectors` has the addresses of the solutions."""

    def __init__(self, writer: Emitter) -> None:
        self.e = writer
        self.f, self.v, self.b = writer.f, writer.v, writer.b
        self.lanes, self.program, self.names = writer.lanes, writer.program, writer.names
        self.vectors: dict[int, list[tuple[str, int]]] = {}
        self.status = ""
        self._weak = ""  # the lanes of the fallback that is written, if any
        self._factors: dict[int, dict[str, str]] = {}
        self._matrices: dict[int, str] = {}
        self._routines = solver_names(writer.lanes)

    def reserve(self) -> None:
        """Reserve memory for guards.

        A matrix for the fallback is stored as soon as its entries are computed: if they stayed in
        registers until the guard, they would displace the values of the elimination. Numbers and
        values of the setup stage are stored by the fallback.

        A solution is stored at its final address, where the fallback overwrites it.
        """
        program = self.program
        guards = {}
        for k, (op, args) in enumerate(zip(program.ops, program.args, strict=True)):
            if op != "guard" or program.setup[k] != self.e.setup:
                continue
            if self.e.fallbacks:
                self._store_matrix(k, _stored(*args[:2]))
            guards[k] = args[4]
            self.vectors[k] = [("", 0)] * len(args[2])
        if not guards:
            return
        if not self.e.setup:
            output_index = {k: index for index, k in reversed(list(enumerate(program.outputs)))}
            for k, op in enumerate(program.ops):
                if op == "item" and k in output_index and program.args[k][0] in guards:
                    guard, index = program.args[k]
                    self.vectors[guard][index] = ("%out", output_index[k])
        for guard, fast in guards.items():
            vector = self.vectors[guard]
            unplaced = [index for index, location in enumerate(vector) if not location[0]]
            slot = self.f.slot(self.v, len(unplaced)) if unplaced else ""
            for index, k in enumerate(unplaced):
                vector[k] = (slot, index)
            for node, (pointer, index) in zip(fast, vector, strict=bool(fast)):
                if self.e.computed(node):
                    self.e.store_when_computed(node, pointer, index, guard)

    def _store_matrix(self, guard: int, stored: list[int]) -> None:
        moving = self._moving(stored)
        sparse = len(stored) > SPARSE * len(moving)
        self._matrices[guard] = self.f.slot(self.v, max(len(moving if sparse else stored), 1))
        for index, node in enumerate(moving if sparse else stored):
            if self.e.computed(node):
                self.e.store_when_computed(node, self._matrices[guard], index, guard)

    def _moving(self, stored: list[int]) -> list[int]:
        """Return the state-dependent entries of a matrix, which are computed at every call."""
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
        """Factorise the masked lanes in place; return pivots, scales and the singular lanes."""
        f = self.f
        pivots = f.slot(vector_type("i64", self.lanes), n)
        scales = f.slot("double", 2 * n)
        bad = f.let(
            f"call i32 @{self._routines[0]}(ptr {a}, ptr {pivots}, ptr {scales}, ptr null, "
            f"i64 {n}, i32 {lanes})"
        )
        return pivots, scales, bad

    def factor(self, node: int, kind: str, n: int, entries: tuple[int, ...]) -> None:
        f, a = self.f, self._buffer(entries)
        lanes, fast = str((1 << self.lanes) - 1), dict[str, str]()
        if kind == "ldl":
            fast = {"spd": self._buffer(entries), "inverse": f.slot(self.v, n)}
            arguments = f"ptr {fast['spd']}, ptr {fast['inverse']}, i64 {n}"
            lanes = f.let(
                f"call i32 @{self._routines[1]}({arguments})"
            )  # with none, LU returns at once
        pivots, scales, bad = self._lu(a, n, lanes)
        self._report(bad)
        self._factors[node] = {"a": a, "pivots": pivots, "scales": scales, "mask": lanes, **fast}

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
        """Write ``if weak:`` around the body, which is rarely executed."""
        f = self.f
        slow, join = f.name("weak"), f.name("solved")
        f.do(f"br i1 {weak}, label {slow}, label {join}, !prof !0")
        f.label(slow)
        with self.names.restored_after():
            yield
        f.do(f"br label {join}")
        f.label(join)

    def _choose(self, lanes: str, slow: str, fast: list[str]) -> list[str]:
        """Select the masked lanes from memory and the others from `fast`."""
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
        locations = self.vectors[node]
        for value, (pointer, index) in zip(fast, locations, strict=bool(fast)):
            if not self.e.computed(value):
                f.store(v, names[value], names.address(pointer, index))
        need = f.let(f"xor i32 {mask(f, names[sound], self.lanes)}, {(1 << self.lanes) - 1}")
        outer_mask = self._weak
        if outer_mask:
            need = f.let(f"and i32 {need}, {outer_mask}")
        with self._fallback(f.let(f"icmp ne i32 {need}, 0")):
            if not self.e.fallbacks:
                self._report("-1")
                return
            self._weak = need
            self.e.write_fallback(node)
            self._weak = outer_mask
            stored = _stored(n, entries)
            symmetric = len(stored) < n * n
            matrix, scratch, room = self._filled(node, n, stored, symmetric)
            b = self._buffer(column)
            if symmetric:
                right = f"ptr {b}, i64 {len(column) // n}"
                bad = f.let(
                    f"call i32 @{self._routines[3]}(ptr {matrix}, {right}, ptr {scratch}, "
                    f"i64 {n}, i32 {need})"
                )
            elif is_constrained(self.program, entries):
                pivots = f.slot(vector_type("i64", self.lanes), n)
                bad = f.let(
                    f"call i32 @{self._routines[4]}(ptr {matrix}, ptr {pivots}, "
                    f"ptr {f.slot('double', 2 * n)}, ptr {b}, i64 {len(column)}, i64 {n}, "
                    f"i32 {need})"
                )
            else:
                pivots, scales, bad = self._lu(matrix, n, need)
                with f.loop("0", str(len(column)), str(n)) as k:
                    f.let(
                        f"call i32 @{self._routines[0]}(ptr {matrix}, ptr {pivots}, ptr {scales}, "
                        f"ptr {f.at(b, k, v)}, i64 {n}, i32 {need})"
                    )
            self._report(bad)
            if room:
                f.do(f"call void @free(ptr {room})")
            if self.lanes > 1 and fast:
                chosen = self._choose(need, b, [names[k] for k in fast])
            else:
                chosen = [f.load(v, b, str(k)) for k in range(len(column))]
            for solved, (pointer, index) in zip(chosen, locations, strict=True):
                f.store(v, solved, names.address(pointer, index))

    def _filled(
        self, guard: int, n: int, stored: list[int], symmetric: bool
    ) -> tuple[str, str, str]:
        """Complete a matrix; return it, scratch memory, and heap memory to be freed.

        A sparse matrix is expanded only here. Large matrices are allocated on the heap. The scratch
        memory, n² entries and 3 n pivots and scales, is '' where LU works in place; the heap memory
        is '' where the matrix is on the stack.
        """
        f, v = self.f, self.v
        state_dependent = {node: k for k, node in enumerate(self._moving(stored))}
        matrix, heap_memory = self._matrices[guard], ""
        work = n * n + 3 * n
        sparse = len(stored) > SPARSE * len(state_dependent)
        if not sparse:
            scratch = f.slot(v, work) if symmetric else ""
        else:
            count = len(stored) + work
            size = 8 * self.lanes * count
            heap = size > 2**16  # threads have small stacks
            matrix = f.let(f"call ptr @malloc(i64 {size})") if heap else f.slot(v, count)
            heap_memory = matrix if heap else ""
            scratch = f.at(matrix, str(len(stored)), v)
            with f.loop("0", str(len(stored))) as item:
                f.store(v, literal(0.0, self.lanes), matrix, item)
            for index, node in enumerate(stored):
                if node in state_dependent:
                    self.e.split_long_block()
                    value = f.load(v, self._matrices[guard], str(state_dependent[node]))
                    f.store(v, value, matrix, str(index))
        done = (
            {*state_dependent, *(k for k in {*stored} if self._is_zero(k))}
            if sparse
            else state_dependent
        )
        for index, node in enumerate(stored):
            if node not in done:
                self.e.split_long_block()
                self.e.load_carried(node)
                f.store(v, self.names[node], matrix, str(index))
        return matrix, scratch, heap_memory

    def _is_zero(self, node: int) -> bool:
        return self.program.ops[node] == "const" and self.program.args[node][0] == 0.0


# -- Operations ------------------------------------------------------------------------------------


# Hints for the two kinds of branches: to a fallback when true, and when false.
BRANCH_WEIGHTS = (
    '!0 = !{!"branch_weights", i32 1, i32 2000}',
    '!1 = !{!"branch_weights", i32 2000, i32 1}',
)


class Emitter:
    """Writes the operations of one stage.

    With `one_block` they are one basic block, in which LLVM allocates the registers. Without
    `fallbacks` a guard that is not sound reports status -1 instead of solving its system.
    """

    def __init__(
        self,
        f: IrFunction,
        program: Program,
        lanes: int,
        setup: bool,
        one_block: bool = False,
        fallbacks: bool = True,
    ) -> None:
        self.f = f
        self.program = program
        self.lanes = lanes
        self.setup = setup
        self.v = vector_type("double", lanes)
        self.b = vector_type("i1", lanes)
        self.suffix = suffix(lanes)
        self.fused, self.absorbed = fusion(program)
        self.fallbacks = fallbacks
        selected = None if fallbacks else program.without_fallbacks
        uses = readers(program, self.absorbed, setup, selected)
        self.one_block = one_block
        self.capacity = (
            len(program.ops) if one_block else max(target().vectors(lanes) - TEMPORARY, 4)
        )
        self.names = RegisterAllocator(f, self.v, self.capacity, uses)
        self.written = 0  # operations of this block
        self.block_start = len(f.lines)
        # A parameter that is never null.
        self.pointer = "%p" if setup else "%t"
        self.destinations: dict[int, list[tuple[str, int, int]]] = {}
        self.solves = Solves(self)
        self.angles: dict[int, tuple[ValueLocation, ValueLocation]] = {}
        self.arctangents: dict[int, ValueLocation] = {}
        # Operations that are not written in the order of the Program.
        self.deferred = (
            {k for nodes in program.fallback.values() for k in nodes}
            if selected is None
            else set(range(len(program.ops))) - selected
        )
        self.together = [
            k
            for k, op in enumerate(program.ops)
            if op in OPERATIONS.together and program.setup[k] == setup
        ]
        self.carried_index: dict[int, int] = {}
        if not setup:
            self.carried_index = {node: index for index, node in enumerate(program.carried)}
        self._constants()

    def _constants(self) -> None:
        """Name the numbers, which need no instruction."""
        for k, (op, args) in enumerate(zip(self.program.ops, self.program.args, strict=True)):
            if op == "const":
                self.names.fix(k, literal(args[0], self.lanes))
            elif op == "bool":
                text = "true" if args[0] else "false"
                self.names.fix(k, text if self.lanes == 1 else f"splat (i1 {text})")

    def stage(self) -> None:
        """Write all operations, and store each result as soon as it is computed."""
        program = self.program
        self.solves.reserve()
        if self.setup:
            for index, k in enumerate(program.carried):
                self.store_when_computed(k, "%c", index)
        else:
            for index, k in enumerate(program.outputs):
                self.store_when_computed(k, "%out", index)
        for k, op in enumerate(program.ops):
            if program.setup[k] != self.setup or op in ("const", "bool"):
                continue
            self.split_long_block()
            if op == "input":
                group, index = program.args[k]
                self.names.home(k, f"%{group}", index)
                self._store(k)
            else:
                self.node(k)
        if not self.setup:
            for index, k in enumerate(program.outputs):
                if program.setup[k]:
                    self.split_long_block()
                    self.load_carried(k)
                    value = self._as_number(k, self.names[k])
                    self.f.store(self.v, value, self.names.address("%out", index))

    def computed(self, node: int) -> bool:
        """Return whether an operation of this stage computes the value."""
        op = self.program.ops[node]
        return self.program.setup[node] == self.setup and op not in ("const", "bool", "input")

    def store_when_computed(self, node: int, pointer: str, index: int, until: int = -1) -> None:
        """Register an address where a value is stored as soon as it is computed.

        It can be read there up to the operation `until`, or always if this is -1.
        """
        self.destinations.setdefault(node, []).append((pointer, index, until))

    def load_carried(self, node: int) -> None:
        """Load a node if it is a value of the setup stage that has no name yet."""
        if node not in self.carried_index or node in self.names:
            return
        if self.program.ops[node] in OPERATIONS.truths:
            number = self.f.load(self.v, "%c", str(self.carried_index[node]))
            zero = literal(0.0, self.lanes)
            self.names.fix(node, self.f.let(f"fcmp une {self.v} {number}, {zero}"))
        else:
            self.names.home(node, "%c", self.carried_index[node])

    def _store(self, node: int) -> None:
        """Store a value at its registered addresses, from which it can be reloaded."""
        for pointer, index, until in self.destinations.get(node, ()):
            if self.names.is_stored_at(node, pointer, index):
                continue
            value = self.names[node]
            if self.program.ops[node] in OPERATIONS.truths:
                value = self._as_number(node, value)
            elif until == -1 or until >= self.names.last_use(node):
                self.names.home(node, pointer, index)
            self.f.store(self.v, value, self.names.address(pointer, index))

    def _as_number(self, node: int, value: str) -> str:
        """Return a value as a double; a truth value becomes 0 or 1."""
        if self.program.ops[node] not in OPERATIONS.truths:
            return value
        return self.f.let(f"uitofp {self.b} {value} to {self.v}")

    def node(self, node: int) -> None:
        """Write one operation, unless it belongs to a fallback or a fused sum."""
        if node in self.deferred or node in self.absorbed:
            return
        self._count()
        self._write_and_store(node)

    def _count(self) -> None:
        # LLVM's time grows faster than linearly with a block's length. Blocks of 30 or 120
        # operations are no faster.
        if self.written and self.written % 60 == 0 and not self.one_block:
            self._next_block()
        self.written += 1

    def split_long_block(self) -> None:
        """Begin another basic block if loads and stores have made this one long."""
        # A block may consist mostly of loads and stores, such as a matrix for a fallback.
        if len(self.f.lines) - self.block_start > 240 and not self.one_block:
            self._next_block()

    def _write_and_store(self, node: int) -> None:
        self._load_operands_carried(node)
        self._write(node)
        self._store(node)
        self.names.release(node)

    def _load_operands_carried(self, node: int) -> None:
        for operand in OPERATIONS.operands(self.program.ops[node], self.program.args[node]):
            if operand in self.absorbed:
                self._load_operands_carried(operand)
            elif operand not in self.deferred:
                self.load_carried(operand)

    def write_fallback(self, guard: int) -> None:
        """Write the operations that only a guard's fallback needs."""
        for node in self.program.fallback[guard]:
            if node not in self.absorbed:
                self._count()
                self._write_and_store(node)

    def _next_block(self) -> None:
        """Begin another basic block behind a branch that LLVM cannot fold."""
        self.written = 0
        f = self.f
        block = f.name("block")
        f.do(f"br i1 {f.let(f'icmp ne ptr {self.pointer}, null')}, label {block}, label %bail")
        f.label(block)
        self.block_start = len(f.lines)

    def _write(self, node: int) -> None:
        op, args = self.program.ops[node], self.program.args[node]
        if node in self.fused:
            self.names[node] = self._fused(op, *args)
        elif op in OPERATIONS:
            kind, _, word = OPERATIONS[op].llvm.partition(" ")
            getattr(self, f"_{kind}")(node, word, *args)
        elif op == "item":
            self._name(node, self.solves.vectors[args[0]][args[1]])
        else:
            getattr(self.solves, op)(node, *args)

    # One method for each kind in the table of operations. It writes an operation, given the word
    # that follows the kind in the table, and the operands.

    def _arithmetic(self, node: int, word: str, a: int, b: int) -> None:
        names = self.names
        names[node] = self.f.let(f"{word} {self.v} {names[a]}, {names[b]}")

    def _negation(self, node: int, word: str, a: int) -> None:
        self.names[node] = self.f.let(f"fneg {self.v} {self.names[a]}")

    def _intrinsic(self, node: int, word: str, *args: int) -> None:
        self._call(node, f"llvm.{word}.{self.suffix}", args)

    def _libm(self, node: int, word: str, *args: int) -> None:
        self._call(node, word if self.lanes == 1 else f"{word}.lanes", args)

    def _call(self, node: int, name: str, args: tuple[int, ...]) -> None:
        text = ", ".join(f"{self.v} {self.names[k]}" for k in args)
        self.names[node] = self.f.let(f"call {self.v} @{name}({text})")

    def _arctangent(self, node: int, word: str, a: int) -> None:
        if self.lanes > 1 or node in self.deferred:
            self._call(node, f"{ARCTANGENT}{self.lanes}", (a,))
            return
        if a not in self.arctangents:
            self._take_arctangents(node)
        self._name(node, self.arctangents[a])

    def _sincos(self, node: int, word: str, angle: int) -> None:
        if angle not in self.angles:
            self._take_angles(node)
        self._name(node, self.angles[angle][int(word)])

    def _comparison(self, node: int, word: str, a: int, b: int) -> None:
        names = self.names
        names.fix(node, self.f.let(f"fcmp {word} {self.v} {names[a]}, {names[b]}"))

    def _logic(self, node: int, word: str, a: int, b: int) -> None:
        names = self.names
        names.fix(node, self.f.let(f"{word} {self.b} {names[a]}, {names[b]}"))

    def _inversion(self, node: int, word: str, a: int) -> None:
        true = "true" if self.lanes == 1 else "splat (i1 true)"
        self.names.fix(node, self.f.let(f"xor {self.b} {self.names[a]}, {true}"))

    def _selection(self, node: int, word: str, *args: int) -> None:
        c, yes, no = (self.names[k] for k in args)
        self.names[node] = self.f.let(f"select {self.b} {c}, {self.v} {yes}, {self.v} {no}")

    def _sign(self, node: int, word: str, a: int) -> None:
        f, v, n, x = self.f, self.v, self.lanes, self.names[a]
        above = f.let(f"fcmp ogt {v} {x}, {literal(0.0, n)}")
        below = f.let(f"fcmp olt {v} {x}, {literal(0.0, n)}")
        inner = f.let(f"select {self.b} {below}, {v} {literal(-1.0, n)}, {v} {x}")
        self.names[node] = f.let(f"select {self.b} {above}, {v} {literal(1.0, n)}, {v} {inner}")

    def _name(self, node: int, location: ValueLocation) -> None:
        """Set the name of a value, or its address in memory."""
        if isinstance(location, tuple):
            self.names.home(node, *location)
        else:
            self.names[node] = location

    def _fused(self, op: str, a: int, b: int) -> str:
        """Write a sum with a product as one fused multiply-add."""
        f, v, names = self.f, self.v, self.names
        product, addend = (b, a) if b in self.absorbed else (a, b)
        x, y = (names[k] for k in self.program.args[product])
        z = names[addend]
        if op == "sub":
            if product == b:
                x = f.let(f"fneg {v} {x}")
            else:
                z = f.let(f"fneg {v} {z}")
        return f.let(f"call {v} @llvm.fma.{self.suffix}({v} {x}, {v} {y}, {v} {z})")

    def _take_angles(self, node: int) -> None:
        """Write sine and cosine of an angle together with all other angles computed so far."""
        f = self.f
        ready = [k for k in self._ready(node, OPERATIONS.angles) if k not in self.angles]
        if self.lanes > 1:
            for start in range(0, len(ready), 8):  # 84 stores instead of 140 for five links
                group = ready[start : start + 8]
                self.names.release(node - 1, min(12, self.capacity - 1))  # they use 12 registers
                pairs = sincos_together(f, [self.names[k] for k in group], self.lanes)
                self.angles.update(zip(group, pairs, strict=True))
            return
        for group, packed, width in self._packed(ready):
            sine, cosine = sincos(f, packed, width)
            if width == 1:
                self.angles[group[0]] = sine, cosine
                continue
            v = vector_type("double", width)
            slot = f.slot(v, 2)
            f.store(v, sine, slot)
            f.store(v, cosine, slot, "1")
            for lane, angle in enumerate(group):
                self.angles[angle] = ((slot, lane), (slot, width + lane))

    def _take_arctangents(self, node: int) -> None:
        """Write an arctangent together with all others whose arguments are computed."""
        f = self.f
        ready = [k for k in self._ready(node, ("atan",)) if k not in self.arctangents]
        for group, packed, width in self._packed(ready):
            v = vector_type("double", width)
            result = f.let(f"call {v} @{ARCTANGENT}{width}({v} {packed})")
            if width == 1:
                self.arctangents[group[0]] = result
                continue
            slot = f.slot(v)
            f.store(v, result, slot)
            for lane, argument in enumerate(group):
                self.arctangents[argument] = (slot, lane)

    def _ready(self, node: int, functions: tuple[str, ...]) -> list[int]:
        """Return the arguments of functions, from one on, that are computed."""
        program = self.program
        waiting = dict.fromkeys(
            program.args[k][0]
            for k in self.together[bisect_left(self.together, node) :]
            if program.ops[k] in functions and k not in self.deferred
        )
        return [k for k in waiting if k in self.names]

    def _packed(self, arguments: list[int]) -> Iterator[tuple[list[int], str, int]]:
        """Yield groups of arguments, each with its vector and the width of that."""
        f = self.f
        while arguments:
            width = next(w for w in WIDTHS if w >= min(len(arguments), PACKED))
            group, arguments = arguments[:width], arguments[width:]
            if width == 1:
                yield group, self.names[group[0]], width
                continue
            v = vector_type("double", width)
            packed = "poison"
            for lane in range(width):
                value = self.names[group[min(lane, len(group) - 1)]]
                packed = f.let(f"insertelement {v} {packed}, double {value}, i32 {lane}")
            yield group, packed, width


def called_functions(program: Program, kind: str) -> dict[str, int]:
    """Return the functions that a Program's operations call, with their numbers of arguments."""
    rows = [OPERATIONS[op] for op in sorted(set(program.ops)) if op in OPERATIONS]
    words = [(row.llvm.partition(" "), row.arity) for row in rows]
    return {word: arity for (name, _, word), arity in words if name == kind}
