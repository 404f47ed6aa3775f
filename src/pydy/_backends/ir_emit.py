"""The operations of a Program as LLVM instructions, one stage at a time.

Instructions carry no fast-math flags. Products go into sums as fused
multiply-adds here, not in LLVM, so that the last bit depends neither on its level of effort nor on
how many states are taken at once.
"""

from __future__ import annotations

from pydy._backends.ir import Function, literal, vector_type
from pydy._backends.ir_math import sincos, sincos_call
from pydy._backends.ir_plan import BLOCK, TRUTHS, Names, Place, fusion, needed_later
from pydy._backends.ir_solve import mask, solver_names
from pydy._graph.program import Program, operands

__all__ = ["BRANCH_WEIGHTS", "INTRINSICS", "LIBM", "Emitter"]

INTRINSICS = {"sqrt": "sqrt", "abs": "fabs", "floor": "floor", "ceil": "ceil"}
INTRINSICS |= {"min": "minimum", "max": "maximum"}
LIBM = (
    *("exp", "log", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh"),
    *("asinh", "acosh", "atanh", "pow", "atan2"),
)
_ARITHMETIC = {"add": "fadd", "sub": "fsub", "mul": "fmul", "div": "fdiv"}
# Hints for the two kinds of branches: to a fallback when true, and when false.
BRANCH_WEIGHTS = (
    '!0 = !{!"branch_weights", i32 1, i32 2000}',
    '!1 = !{!"branch_weights", i32 2000, i32 1}',
)
_COMPARISONS = {"lt": "olt", "le": "ole", "eq": "oeq", "ne": "une"}


# A matrix with more entries for each one that is computed at every call is kept without the others.
_SPARSE = 4
_STACK_BYTES = 2**16


def _stored(n: int, entries: tuple[int, ...]) -> list[int]:
    """Return what a guard's fallback needs of a matrix: of a symmetric one the lower triangle."""
    lower = [entries[i * n + j] for i in range(n) for j in range(i + 1)]
    upper = [entries[j * n + i] for i in range(n) for j in range(i + 1)]
    return lower if n > 1 and lower == upper else list(entries)


class Emitter:
    """Writes the operations of one stage; `brief` code calls routines where it can."""

    def __init__(self, f: Function, program: Program, lanes: int, brief: bool = False) -> None:
        self.f = f
        self.program = program
        self.lanes = lanes
        self.sincos = sincos_call if brief else sincos
        self.v = vector_type("double", lanes)
        self.b = vector_type("i1", lanes)
        self.suffix = "f64" if lanes == 1 else f"v{lanes}f64"
        self.names = Names(f, self.v)
        self.written = 0
        self.pointer = "null"
        self.factors: dict[int, dict[str, str]] = {}
        self.vectors: dict[int, list[str]] = {}
        self.kept: dict[int, str] = {}
        self.places: dict[int, list[tuple[str, int]]] = {}
        self.status = ""
        self.routines = solver_names(lanes)
        self.angles: dict[int, tuple[Place, Place]] = {}
        self.fused, self.swallowed = fusion(program)
        self.put_off = {k for nodes in program.fallback.values() for k in nodes}
        self.carried: dict[int, int] = {}

    def constants(self) -> None:
        """Name the numbers, which need no instruction."""
        for k, (op, args) in enumerate(zip(self.program.ops, self.program.args, strict=True)):
            if op == "const":
                self.names[k] = literal(args[0], self.lanes)
            elif op == "bool":
                text = "true" if args[0] else "false"
                self.names[k] = text if self.lanes == 1 else f"splat (i1 {text})"

    def load(self, node: int, pointer: str, index: int) -> None:
        """Read an input or a carried value."""
        self.names.at(node, (pointer, index))
        self._keep(node)

    def reserve(self) -> None:
        """Make room for the matrices that a guard's fallback needs.

        They are written as soon as they are computed: kept alive in registers until the guard,
        they would crowd out what the elimination works with.
        """
        for k, (op, args) in enumerate(zip(self.program.ops, self.program.args, strict=True)):
            if op == "guard":
                stored = _stored(*args[:2])
                moving = self._moving(stored)
                if len(stored) > _SPARSE * len(moving):
                    self.kept[k] = self.f.slot(self.v, len(moving))
                    for place, node in enumerate(moving):
                        self.places.setdefault(node, []).append((self.kept[k], place))
                    continue
                self.kept[k] = self.f.slot(self.v, len(stored))
                for place, node in enumerate(stored):
                    if node in self.names:  # a number
                        self.f.store(self.v, self.names[node], self.kept[k], str(place))
                    else:
                        self.places.setdefault(node, []).append((self.kept[k], place))

    def _moving(self, stored: list[int]) -> list[int]:
        """Return the entries of a matrix that are neither numbers nor values of the setup stage."""
        return list(dict.fromkeys(k for k in stored if not self.program.setup[k]))

    def load_carried(self, node: int) -> None:
        """Read a value of the setup stage, unless it is known or none."""
        if node not in self.carried or node in self.names:
            return
        if self.program.ops[node] in TRUTHS:
            number = self.f.load(self.v, "%c", str(self.carried[node]))
            zero = literal(0.0, self.lanes)
            self.names[node] = self.f.let(f"fcmp une {self.v} {number}, {zero}")
        else:
            self.load(node, "%c", self.carried[node])

    def _keep(self, node: int) -> None:
        for pointer, place in self.places.get(node, ()):
            self.f.store(self.v, self.names[node], pointer, str(place))

    def node(self, node: int) -> None:
        """Write one operation; what only a fallback needs is written there."""
        if node in self.put_off:
            return
        if self.written and self.written % BLOCK == 0:
            self._next_block()
        self.written += node not in self.swallowed
        self._write_and_keep(node)

    def _write_and_keep(self, node: int) -> None:
        for other in operands(self.program.ops[node], self.program.args[node]):
            if other not in self.put_off:
                self.load_carried(other)
        self._write(node)
        self._keep(node)

    def _write_fallback(self, guard: int) -> None:
        """Write, in blocks, what only the fallback of a guard needs."""
        nodes = self.program.fallback[guard]
        if not nodes:
            return
        written = self.written
        self.names.new_block()
        for count, node in enumerate(nodes):
            if count and count % BLOCK == 0:
                self._next_block()
            self._write_and_keep(node)
        self.written = written

    def blocks(self, setup: bool, pointer: str) -> None:
        """Write in blocks of limited length; `pointer` is a parameter that is never null."""
        self.names.keep(needed_later(self.program, self.swallowed, setup))
        self.pointer = pointer

    def _next_block(self) -> None:
        """Begin another basic block, in a way that LLVM does not see through."""
        self.written = 0
        f = self.f
        block = f.name("block")
        f.do(f"br i1 {f.let(f'icmp ne ptr {self.pointer}, null')}, label {block}, label %bail")
        f.label(block)
        self.names.new_block()

    def _write(self, node: int) -> None:
        op, args = self.program.ops[node], self.program.args[node]
        f, v, names = self.f, self.v, self.names
        if node in self.fused:
            names[node] = self._fused(op, *args)
        elif op in _ARITHMETIC:
            if op == "mul" and node in self.swallowed:
                return
            a, b = (names[k] for k in args)
            names[node] = f.let(f"{_ARITHMETIC[op]} {v} {a}, {b}")
        elif op == "neg":
            names[node] = f.let(f"fneg {v} {names[args[0]]}")
        elif op in INTRINSICS:
            text = ", ".join(f"{v} {names[k]}" for k in args)
            names[node] = f.let(f"call {v} @llvm.{INTRINSICS[op]}.{self.suffix}({text})")
        elif op in ("sin", "cos"):
            angle = args[0]
            if angle not in self.angles:
                self._take_angles(node)
            names.at(node, self.angles[angle][op == "cos"])
        elif op in LIBM:
            text = ", ".join(f"{v} {names[k]}" for k in args)
            name = op if self.lanes == 1 else f"{op}.lanes"
            names[node] = f.let(f"call {v} @{name}({text})")
        elif op in _COMPARISONS:
            a, b = (names[k] for k in args)
            names[node] = f.let(f"fcmp {_COMPARISONS[op]} {v} {a}, {b}")
        elif op in ("and", "or"):
            a, b = (names[k] for k in args)
            names[node] = f.let(f"{op} {self.b} {a}, {b}")
        elif op == "not":
            true = "true" if self.lanes == 1 else "splat (i1 true)"
            names[node] = f.let(f"xor {self.b} {names[args[0]]}, {true}")
        elif op == "select":
            c, yes, no = (names[k] for k in args)
            names[node] = f.let(f"select {self.b} {c}, {v} {yes}, {v} {no}")
        elif op == "sign":
            names[node] = self._sign(names[args[0]])
        elif op == "factor":
            self._factor(node, *args)
        elif op == "solve":
            self._solve(node, *args)
        elif op == "guard":
            self._guard(node, *args)
        elif op == "item":
            names[node] = self.vectors[args[0]][args[1]]
        else:
            raise AssertionError(f"no IR for {op!r}")

    def _fused(self, op: str, a: int, b: int) -> str:
        """Write a sum with a product as one fused multiply-add."""
        f, v, names = self.f, self.v, self.names
        product, other = (b, a) if b in self.swallowed else (a, b)
        x, y = (names[k] for k in self.program.args[product])
        z = names[other]
        if op == "sub":
            if product == b:
                x = f.let(f"fneg {v} {x}")
            else:
                z = f.let(f"fneg {v} {z}")
        return f.let(f"call {v} @llvm.fma.{self.suffix}({v} {x}, {v} {y}, {v} {z})")

    def _take_angles(self, node: int) -> None:
        """Write sine and cosine of an angle and of all others known by now, side by side."""
        f, program = self.f, self.program
        if self.lanes > 1:
            angle = program.args[node][0]
            self.angles[angle] = self.sincos(f, self.names[angle], self.lanes)
            return
        waiting = dict.fromkeys(
            program.args[k][0]
            for k in range(node, len(program.ops))
            if program.ops[k] in ("sin", "cos") and program.setup[k] == program.setup[node]
        )
        ready = [k for k in waiting if k in self.names and k not in self.angles]
        while ready:
            width = next(w for w in (8, 4, 2, 1) if w <= len(ready) or w == 1)
            if len(ready) > width:
                width = min(8, 2 * width)
            group, ready = ready[:width], ready[width:]
            self._side_by_side(group, width)

    def _side_by_side(self, group: list[int], width: int) -> None:
        f = self.f
        if width == 1:
            self.angles[group[0]] = self.sincos(f, self.names[group[0]], 1)
            return
        v = vector_type("double", width)
        packed = "poison"
        for lane in range(width):
            value = self.names[group[min(lane, len(group) - 1)]]
            packed = f.let(f"insertelement {v} {packed}, double {value}, i32 {lane}")
        sine, cosine = self.sincos(f, packed, width)
        room = f.slot(v, 2)
        f.store(v, sine, room)
        f.store(v, cosine, room, "1")
        for lane, angle in enumerate(group):
            self.angles[angle] = ((room, lane), (room, width + lane))

    def _sign(self, x: str) -> str:
        f, v, n = self.f, self.v, self.lanes
        above = f.let(f"fcmp ogt {v} {x}, {literal(0.0, n)}")
        below = f.let(f"fcmp olt {v} {x}, {literal(0.0, n)}")
        inner = f.let(f"select {self.b} {below}, {v} {literal(-1.0, n)}, {v} {x}")
        return f.let(f"select {self.b} {above}, {v} {literal(1.0, n)}, {v} {inner}")

    # -- solves ---------------------------------------------------------------------------------

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
            f"call i32 @{self.routines[0]}(ptr {a}, ptr {pivots}, ptr {scales}, ptr null, "
            f"i64 {n}, i32 {lanes})"
        )
        return pivots, scales, bad

    def _factor(self, node: int, kind: str, n: int, entries: tuple[int, ...]) -> None:
        f = self.f
        a = self._buffer(entries)
        every = str((1 << self.lanes) - 1)
        if kind == "lu":
            pivots, scales, bad = self._lu(a, n, every)
            self._report(bad)
            self.factors[node] = {
                "a": a,
                "pivots": pivots,
                "scales": scales,
                "mask": every,
                "n": str(n),
            }
            return
        spd = self._buffer(entries)
        inverse = f.slot(self.v, n)
        need = f.let(f"call i32 @{self.routines[1]}(ptr {spd}, ptr {inverse}, i64 {n})")
        # With an empty mask this call returns at once.
        pivots, scales, bad = self._lu(a, n, need)
        self._report(bad)
        self.factors[node] = {
            "a": a, "pivots": pivots, "scales": scales, "mask": need, "n": str(n),
            "spd": spd, "inverse": inverse,
        }  # fmt: skip

    def _solve(self, node: int, factor: int, column: tuple[int, ...]) -> None:
        f = self.f
        data = self.factors[factor]
        n = len(column)
        b = self._buffer(column)
        call = (
            f"call i32 @{self.routines[0]}(ptr {data['a']}, ptr {data['pivots']}, "
            f"ptr {data['scales']}, ptr {b}, i64 {n}, i32 {data['mask']})"
        )
        if "spd" not in data:
            f.let(call)
            self.vectors[node] = [f.load(self.v, b, str(k)) for k in range(n)]
            return
        x = self._buffer(column)
        f.do(
            f"call void @{self.routines[2]}(ptr {data['spd']}, ptr {data['inverse']}, ptr {x}, "
            f"i64 {n})"
        )
        fast = [f.load(self.v, x, str(k)) for k in range(n)]
        weak = f.let(f"icmp ne i32 {data['mask']}, 0")
        slow = f.name("weak")
        join = f.name("solved")
        before = f.current
        f.do(f"br i1 {weak}, label {slow}, label {join}, !prof !0")
        f.label(slow)
        f.let(call)
        chosen = self._choose(data["mask"], b, fast)
        end = f.current
        f.do(f"br label {join}")
        f.label(join)
        self.vectors[node] = [
            f.let(f"phi {self.v} [ {a}, %{before} ], [ {c}, %{end} ]")
            for a, c in zip(fast, chosen, strict=True)
        ]

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

    def _guard(
        self,
        node: int,
        n: int,
        entries: tuple[int, ...],
        column: tuple[int, ...],
        sound: int,
        fast: tuple[int, ...],
    ) -> None:
        f, v, names = self.f, self.v, self.names
        quick = [names[k] for k in fast]
        every = (1 << self.lanes) - 1
        need = f.let(f"xor i32 {mask(f, names[sound], self.lanes)}, {every}")
        weak = f.let(f"icmp ne i32 {need}, 0")
        slow, join = f.name("weak"), f.name("solved")
        before = f.current
        f.do(f"br i1 {weak}, label {slow}, label {join}, !prof !0")
        f.label(slow)
        self._write_fallback(node)
        stored = _stored(n, entries)
        symmetric = len(stored) < n * n
        matrix, scratch, room = self.kept[node], "", ""
        if len(stored) > _SPARSE * len(self._moving(stored)):
            matrix, scratch, room = self._filled(node, n, stored)
        elif symmetric:
            scratch = f.slot(v, n * n + 3 * n)
        b = self._buffer(column)
        if symmetric:
            bad = f.let(
                f"call i32 @{self.routines[3]}(ptr {matrix}, ptr {b}, ptr {scratch}, "
                f"i64 {n}, i32 {need})"
            )
        else:
            pivots, scales, bad = self._lu(matrix, n, need)
            f.let(
                f"call i32 @{self.routines[0]}(ptr {matrix}, ptr {pivots}, ptr {scales}, "
                f"ptr {b}, i64 {n}, i32 {need})"
            )
        self._report(bad)
        if room:
            f.do(f"call void @free(ptr {room})")
        chosen = self._choose(need, b, quick)
        end = f.current
        f.do(f"br label {join}")
        f.label(join)
        names.new_block()  # what was loaded on the way to the fallback is not known here
        self.vectors[node] = [
            f.let(f"phi {v} [ {x}, %{before} ], [ {y}, %{end} ]")
            for x, y in zip(quick, chosen, strict=True)
        ]

    def _filled(self, guard: int, n: int, stored: list[int]) -> tuple[str, str, str]:
        """Write out a sparse matrix; gives it, scratch memory behind it, and what is to be freed.

        Only a fallback needs that much memory: more than a little is taken from the heap.
        """
        f, v = self.f, self.v
        count = len(stored) + n * n + 3 * n
        size = 8 * self.lanes * count
        heap = size > _STACK_BYTES
        matrix = f.let(f"call ptr @malloc(i64 {size})") if heap else f.slot(v, count)
        with f.loop("0", str(len(stored))) as item:
            f.store(v, literal(0.0, self.lanes), matrix, item)
        self.names.new_block()
        moving = {node: k for k, node in enumerate(self._moving(stored))}
        for place, node in enumerate(stored):
            if node in moving:
                f.store(v, f.load(v, self.kept[guard], str(moving[node])), matrix, str(place))
            elif self.program.ops[node] != "const" or self.program.args[node][0] != 0.0:
                self.load_carried(node)
                f.store(v, self.names[node], matrix, str(place))
        return matrix, f.at(matrix, str(len(stored)), v), matrix if heap else ""
