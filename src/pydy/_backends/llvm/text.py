"""The IR of a Program or Tangent: `prepare` and `kernel`, and `strided` for several states.

There are no fast-math flags: NaN, infinity and the order of operations are preserved. Only the
fused multiply-adds that are written in the IR are used.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import Enum

import numpy as np

from pydy._backends.llvm.emit import (
    ARCTANGENT,
    BRANCH_WEIGHTS,
    Emitter,
    called_functions,
    solver_declarations,
)
from pydy._backends.llvm.ir import (
    HEAP_DECLARATIONS,
    MALLOC,
    WIDTHS,
    IrFunction,
    literal,
    suffix,
    vector_type,
)
from pydy._backends.llvm.plan import ArrayLayout
from pydy._backends.llvm.sincos import sincos_declarations, sincos_functions
from pydy._backends.llvm.targets import target
from pydy._program import OPERATIONS, Part, Program, Tangent


class Fallbacks(Enum):
    """Whether code for one state contains the fallbacks of guards.

    If fallbacks are most of the code, it is compiled without them first. If a guard is not sound,
    this code calls `COMPLETE`, the code with fallbacks, with the same arguments. The array c then
    ends in a copy of the constants p and a flag, which is zero until the complete code has computed
    the constants for fallbacks, at its first call.
    """

    ALWAYS, LEFT_OUT, ADDED = range(3)


def kernel_text(
    program: Program, lanes: int, width: int = 0, fallbacks: Fallbacks = Fallbacks.ALWAYS
) -> str:
    """Return the module of a Program, with the functions `kernel` and `prepare`."""
    width = width or lanes
    if width < lanes:
        body = _in_lane_groups(program, lanes, width)
    else:
        body = prepare_text(program, lanes, fallbacks=fallbacks)
        body += _kernel(program, lanes, fallbacks)
    return module_text(body, [(program, width)])


def module_text(body: str, parts: Sequence[tuple[Program, int]]) -> str:
    """Return functions with the declarations that they need.

    The parts are the Programs in these functions, with their numbers of lanes.
    """
    declared = "\n".join(_declarations(*part) for part in parts).splitlines()
    head = [*dict.fromkeys(declared)]
    if f"{MALLOC}(" in body:
        head.append(HEAP_DECLARATIONS)
    if f"@{COMPLETE}(" in body:
        head.append(f"declare i32 @{COMPLETE}(ptr, ptr, ptr, ptr, ptr)")
    # Sines and cosines are computed in groups of different widths.
    head += [
        sincos_declarations(width, kind)
        for kind in ("", "far_")
        for width in WIDTHS
        if f"@pydy_sincos_{kind}{width}(" in body
    ]
    if f"@{ARCTANGENT}" in body:
        from pydy._backends.llvm import arctangent  # most models have none

        for lanes in WIDTHS:
            if f"@{ARCTANGENT}{lanes}(" in body:
                head += [arctangent.declarations(lanes), arctangent.function(lanes)]
    for lanes in sorted({lanes for _, lanes in parts} - {1}):
        calls: dict[str, int] = {}
        for program, program_lanes in parts:
            calls.update(called_functions(program, "libm") if program_lanes == lanes else {})
        head += [_lane_by_lane(*call, lanes) for call in calls.items()]
    return "\n".join([*head, "", body])


_LIBM_ANGLES = tuple(f"declare double @{name}(double) nounwind" for name in OPERATIONS.angles)


def _arithmetic_declarations(widths: Iterable[int]) -> str:
    lines = []
    for width in widths:
        v, end = vector_type("double", width), suffix(width)
        lines.append(f"declare {v} @llvm.fma.{end}({v}, {v}, {v})")
        lines.append(f"declare {v} @llvm.fabs.{end}({v})")
    return "\n".join(lines)


def _declarations(program: Program, lanes: int) -> str:
    v = vector_type("double", lanes)
    lines = [
        f"declare double @{name}({', '.join(['double'] * arity)}) nounwind willreturn memory(none)"
        for name, arity in called_functions(program, "libm").items()
    ]
    if OPERATIONS.solves & set(program.ops):
        lines.append(solver_declarations(lanes))
    packs = WIDTHS if lanes == 1 and set(OPERATIONS.together) & set(program.ops) else (lanes,)
    lines.append(_arithmetic_declarations(packs))
    for name, arity in called_functions(program, "intrinsic").items():
        if name != "fabs":
            lines.append(f"declare {v} @llvm.{name}.{suffix(lanes)}({', '.join([v] * arity)})")
    return "\n".join(lines) + "\n"


def _lane_by_lane(name: str, arity: int, lanes: int) -> str:
    """Return a vector function that calls libm for each lane."""
    v = vector_type("double", lanes)
    vectors = [f"{v} %a{k}" for k in range(arity)]
    f = IrFunction(f"{name}.lanes", v, ", ".join(vectors), "internal|nounwind memory(none)")
    f.do(f"ret {v} {f.lane_by_lane(name, vectors, lanes)}")
    return f.text()


def prepare_text(
    program: Program,
    lanes: int,
    prefix: str = "",
    layout: ArrayLayout | None = None,
    fallbacks: Fallbacks = Fallbacks.ALWAYS,
) -> str:
    """Return the function of the setup stage."""
    linkage = "internal" if prefix else ""
    f = IrFunction(f"{prefix}prepare", "void", PREPARE, f"{linkage}|nounwind")
    e = Emitter(f, program, lanes, True, fallbacks=fallbacks is not Fallbacks.LEFT_OUT)
    e.names.set_layout(layout)
    e.stage()
    if not prefix:
        _end_of_c(f, program, fallbacks)
    f.do("ret void")
    f.label("%bail")
    f.do("ret void")
    return f.text()


def _end_of_c(f: IrFunction, program: Program | Tangent, fallbacks: Fallbacks) -> None:
    """Write the last entries of the array c, see `Fallbacks`."""
    if fallbacks is Fallbacks.ALWAYS:
        return
    complete = fallbacks is Fallbacks.ADDED
    if not complete:
        with f.loop("0", str(program.signature.num_constants)) as k:
            position = f.let(f"add i64 {k}, {len(program.carried)}")
            f.store("double", f.load("double", "%p", k), "%c", position)
    f.store("double", literal(float(complete), 1), "%c", str(size_with_constants(program) - 1))


def size_with_constants(program: Program | Tangent) -> int:
    """Return the size of the array c of code whose fallbacks may be added."""
    return len(program.carried) + program.signature.num_constants + 1


PREPARE = "ptr noalias readonly %p, ptr noalias %c"
_ARRAYS = ("t", "x", "r", "c", "out")


def _parameters(suffix: str = "") -> str:
    inputs = ", ".join(f"ptr noalias readonly %{name}{suffix}" for name in _ARRAYS[:-1])
    return f"{inputs}, ptr noalias %out{suffix}"


KERNEL = _parameters()


def _kernel(program: Program, lanes: int, fallbacks: Fallbacks) -> str:
    """Return the functions of the run stage: `kernel`, and `strided` for wide code.

    The last argument of `strided` is an array: the strides of x, r and out, the number of blocks of
    states, and the stride of r between two blocks. The function processes one or more blocks, stops
    at the first that fails, and returns the status of the last block in the low 32 bits and the
    number of blocks in the high ones.

    For small models it is a loop, because a call takes as long as their equations. For larger ones
    it processes one block: values that LLVM hoists out of a loop would be spilled.
    """
    parts = [*BRANCH_WEIGHTS, ""]
    small = is_small(program)
    if lanes == 1 or small:
        parts.insert(0, stage_text(program, lanes, fallbacks=fallbacks))
    else:
        parts.append(_packed_kernel(lanes))
    if lanes > 1:
        parts.insert(0, _strided(program, lanes, small))
    return "\n".join(parts)


def stage_text(
    program: Program,
    lanes: int,
    name: str = "kernel",
    layout: ArrayLayout | None = None,
    fallbacks: Fallbacks = Fallbacks.ALWAYS,
) -> str:
    """Return the function of the run stage; see `kernel_text`.

    A function that is called within the module has the `layout` of its arrays. Without fallbacks it
    returns -1 if a guard is not sound.
    """
    complete = fallbacks is not Fallbacks.LEFT_OUT
    if layout is None:
        f = _kernel_function(program, fallbacks)
    else:
        f = IrFunction(name, "i32", KERNEL, "internal|nounwind")
    e = Emitter(f, program, lanes, False, fallbacks=complete)
    e.solves.status = f.variable("i32", "0")
    e.names.set_layout(layout)
    e.stage()
    status = f.get("i32", e.solves.status)
    if layout is None and not complete:
        _check(f, status)
    f.do(f"ret i32 {status}")
    if layout is None and not complete:
        _call_complete(f)
    f.label("%bail")
    f.do("ret i32 0")
    return f.text()


def _kernel_function(program: Program | Tangent, fallbacks: Fallbacks) -> IrFunction:
    """Return the beginning of `kernel`: constants for fallbacks are computed if c lacks them."""
    if fallbacks is Fallbacks.ALWAYS:
        return IrFunction("kernel", "i32", KERNEL, "|nounwind")
    f = IrFunction("kernel", "i32", KERNEL.replace("readonly %c", "%c"), "|nounwind")
    if fallbacks is Fallbacks.ADDED:
        flag = f.load("double", "%c", str(size_with_constants(program) - 1))
        missing = f.let(f"fcmp oeq double {flag}, 0.0")
        f.do(f"br i1 {missing}, label %missing, label %there, !prof !0")
        f.label("%missing")
        p = f.at("%c", str(len(program.carried)))
        f.do(f"call void @prepare(ptr {p}, ptr %c)")
        f.do("br label %there")
        f.label("%there")
    return f


def _check(f: IrFunction, status: str) -> None:
    """Write a branch to `_call_complete` that is taken if a guard is not sound."""
    sound = f.name("sound")
    f.do(f"br i1 {f.let(f'icmp slt i32 {status}, 0')}, label %unsound, label {sound}, !prof !0")
    f.label(sound)


def _call_complete(f: IrFunction) -> None:
    """Write the call of the code that has all fallbacks, with the same arguments."""
    f.label("%unsound")
    arguments = ", ".join(f"ptr %{name}" for name in _ARRAYS)
    f.do(f"ret i32 {f.let(f'tail call i32 @{COMPLETE}({arguments})')}")


# The kernel with all fallbacks; the code without them is linked with its address.
COMPLETE = "pydy_complete"


def is_small(program: Program) -> bool:
    # A function call takes as long as the equations of one link.
    return sum(not setup for setup in program.setup) <= 100


def _is_one_block(program: Program, lanes: int) -> bool:
    registers = target().registers
    size = program.operation_count["run"].total() + program.signature.num_outputs
    return lanes == registers.widest and size <= registers.one_block_limit


def _strided(program: Program, lanes: int, loop: bool, prefix: str = "") -> str:
    parameters = f"{_parameters('.first' if loop else '')}, ptr noalias readonly %steps"
    linkage = "internal" if prefix else ""
    f = IrFunction(f"{prefix}strided", "i64", parameters, f"{linkage}|nounwind")
    one_block = not loop and _is_one_block(program, lanes)
    e = Emitter(f, program, lanes, False, one_block)
    e.solves.status = f.variable("i32", "0")
    for index, group in enumerate(("%x", "%r", "%out")):
        e.names.steps[group] = f.load("i64", "%steps", str(index))
    count, r_block = (f.load("i64", "%steps", str(k)) for k in (3, 4)) if loop else ("", "")
    if loop:
        f.do("br label %block")
        f.label("%block")
        f.do("%k = phi i64 [ 0, %entry ], [ %done, %more ]")
        offset = f.let(f"mul i64 %k, {lanes}")
        r_offset = f.let(f"mul i64 %k, {r_block}")
        for name, start in zip(_ARRAYS, (offset, offset, r_offset, "0", offset), strict=True):
            f.do(f"%{name} = getelementptr double, ptr %{name}.first, i64 {start}")
    e.stage()
    status = f.get("i32", e.solves.status)
    f.do(f"%done = add i64 {'%k' if loop else '0'}, 1")
    if loop:
        good = f.let(f"icmp eq i32 {status}, 0")
        remaining = f.let(f"icmp slt i64 %done, {count}")
        f.do(f"br i1 {f.let(f'and i1 {good}, {remaining}')}, label %more, label %finish")
        f.label("%more")
        f.do("br label %block")
        f.label("%finish")
    high, low = f.let("shl i64 %done, 32"), f.let(f"zext i32 {status} to i64")
    f.do(f"ret i64 {f.let(f'or i64 {high}, {low}')}")
    f.label("%bail")
    f.do("ret i64 0")
    return f.text()


def _packed_kernel(lanes: int) -> str:
    """Return the `kernel` that passes arrays ``[item][lane]`` to `strided`."""
    f = IrFunction("kernel", "i32", KERNEL, "|nounwind")
    arguments = ", ".join(f"ptr %{name}" for name in _ARRAYS)
    result = f.let(f"tail call i64 @strided({arguments}, ptr @packed)")
    f.do(f"ret i32 {f.let(f'trunc i64 {result} to i32')}")
    steps = ", ".join(f"i64 {n}" for n in (lanes, lanes, lanes, 1, lanes))
    return f"@packed = private constant [5 x i64] [{steps}]\n" + f.text()


_ONE_BLOCK = 1 << 32
"""What ``strided`` returns for each block that it has computed, above the bits of failed lanes."""


def _in_lane_groups(program: Program, lanes: int, width: int) -> str:
    """Return functions for all lanes that call the code for one group of lanes after the other.

    If the lanes of a value need several registers, fewer values fit in the registers. The array c
    has the same order: all values of a group, then those of the next. Like that of `_strided`, the
    function ``strided`` computes one block, and returns it with the bits of failed lanes.
    """
    turns = range(0, lanes, width)
    v, setup_size = vector_type("double", width), len(program.carried)
    prepare = IrFunction("prepare", "void", PREPARE, "|nounwind")
    p = prepare.slot(v, max(program.signature.num_constants, 1))
    for first in turns:
        with prepare.loop("0", str(program.signature.num_constants)) as i:
            source = prepare.at("%p", prepare.let(f"mul i64 {i}, {lanes}"))
            value = prepare.load(v, prepare.at(source, str(first)))
            prepare.store(v, value, p, i)
        c = prepare.at("%c", str(first * setup_size))
        prepare.do(f"call void @turn.prepare(ptr {p}, ptr {c})")
    prepare.do("ret void")
    f = IrFunction("strided", "i64", f"{KERNEL}, ptr noalias readonly %steps", "|nounwind")
    status = "0"
    for first in turns:
        pointers = {name: f.at(f"%{name}", str(first)) for name in _ARRAYS}
        pointers["c"] = f.at("%c", str(first * setup_size))
        arguments = ", ".join(f"ptr {source}" for source in pointers.values())
        result = f.let(f"call i64 @turn.strided({arguments}, ptr %steps)")
        bits = f.let(f"shl i64 {f.let(f'and i64 {result}, {_ONE_BLOCK - 1}')}, {first}")
        status = f.let(f"or i64 {status}, {bits}")
    f.do(f"ret i64 {f.let(f'or i64 {status}, {_ONE_BLOCK}')}")
    inner = prepare_text(program, width, "turn.") + _strided(program, width, False, "turn.")
    outer = [prepare.text(), f.text(), _packed_kernel(lanes)]
    return "\n".join([inner, *outer, *BRANCH_WEIGHTS, ""])


def angles_text(lanes: int) -> str:
    """Return the module of the sines and cosines that kernels share."""
    widths = WIDTHS if lanes == 1 else (lanes,)
    parts = [_arithmetic_declarations(widths), *_LIBM_ANGLES, *BRANCH_WEIGHTS]
    return "\n".join([*parts, *map(sincos_functions, widths)])


# -- Tangents --------------------------------------------------------------------------------------


def program_parts(program: Program | Tangent, lanes: int) -> list[tuple[Program, int]]:
    """Return the Programs in the code, each with its number of lanes or columns.

    Those of a Tangent are the shared part, then the parts of the columns.
    """
    if isinstance(program, Program):
        return [(program, lanes)]
    widest = target().registers.widest
    part_width = min(lanes, widest)
    counts = [part_width if lanes > 1 else min(part.count, widest) for part in program.parts]
    widths = [next(width for width in WIDTHS if width >= count) for count in counts]
    programs = [program.shared, *(part.program for part in program.parts)]
    return [*zip(programs, (part_width, *widths), strict=True)]


def tangent_text(tangent: Tangent, lanes: int, fallbacks: Fallbacks = Fallbacks.ALWAYS) -> str:
    """Return the module of a Tangent, with the functions `kernel` and `prepare`."""
    return _TangentIr(tangent, lanes, fallbacks).module()


class _TangentIr:
    """The functions of the shared part and of each column part, and the function that calls them.

    With one lane, a part processes as many columns at once as a register holds numbers: it reads a
    row of seeds as a vector and broadcasts each shared value to the columns. If the last columns do
    not fill a vector, they are computed with some columns before them, which are computed twice; a
    part with fewer columns than a vector is padded. With several lanes, the lanes are states, and a
    part processes one column after the other.

    The array c contains the constants of the shared part, then those of each vector of columns.
    """

    def __init__(self, tangent: Tangent, lanes: int, fallbacks: Fallbacks) -> None:
        self.tangent, self.lanes, self.fallbacks = tangent, lanes, fallbacks
        self.parts = program_parts(tangent, lanes)
        self.kernel = _kernel_function(tangent, fallbacks)
        self.prepare = IrFunction("prepare", "void", PREPARE, "|nounwind")
        self.status = "0"
        self.functions: list[str] = []
        self.tables: dict[str, str] = {}
        self.values = ""
        self.next_constant = lanes * len(tangent.shared.carried)  # index in c

    def module(self) -> str:
        """Return the module."""
        tangent, lanes, f = self.tangent, self.lanes, self.kernel
        self._shared()
        f.do(self._memory("cpy.p0.p0", "%out", f"ptr {self.values}", tangent.values * lanes))
        rows, columns = tangent.shape
        if sum(part.count for part in tangent.parts) < columns:
            out = f.at("%out", str(tangent.values * lanes))
            f.do(self._memory("set.p0", out, "i8 0", rows * columns * lanes))
        for part, (_, width) in zip(tangent.parts, self.parts[1:], strict=True):
            self._part(part, width)
        f.do(f"ret i32 {self.status}")
        if self.fallbacks is Fallbacks.LEFT_OUT:
            _call_complete(f)
        _end_of_c(self.prepare, tangent, self.fallbacks)
        self.prepare.do("ret void")
        texts = [f.text(), self.prepare.text(), *BRANCH_WEIGHTS, ""]
        declared = [
            "declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)",
            "declare void @llvm.memset.p0.i64(ptr, i8, i64, i1)",
        ]
        body = "\n".join([*declared, *self.tables.values(), *self.functions, *texts])
        return module_text(body, self.parts)

    def _memory(self, operation: str, destination: str, source: str, count: int) -> str:
        arguments = f"ptr {destination}, {source}, i64 {8 * count}, i1 false"
        return f"call void @llvm.mem{operation}.i64({arguments})"

    def _table(self, name: str, numbers: Sequence[float]) -> str:
        """Return the name of an array of numbers."""
        items = ", ".join(f"double {number!r}" for number in numbers)
        kind = f"[{len(numbers)} x double]"
        self.tables[name] = f"@{name} = private constant {kind} [{items}]"
        return f"@{name}"

    def _call(self, name: str, lane: int, *pointers: str) -> None:
        """Call a function whose first lane is `lane` of the kernel."""
        f = self.kernel
        arguments = ", ".join(f"ptr {pointer}" for pointer in pointers)
        bad = f.let(f"call i32 @{name}({arguments})")
        if self.fallbacks is Fallbacks.LEFT_OUT:
            _check(f, bad)
        if self.lanes == 1:  # its lanes are columns
            bad = f.let(f"zext i1 {f.let(f'icmp ne i32 {bad}, 0')} to i32")
        self.status = f.let(f"or i32 {self.status}, {f.let(f'shl i32 {bad}, {lane}')}")

    def _shared(self) -> None:
        (program, width), lanes, f = self.parts[0], self.lanes, self.kernel
        layout = ArrayLayout(dict.fromkeys(("%x", "%r", "%p", "%out"), lanes))
        self.functions += [
            prepare_text(program, width, "shared.", layout, self.fallbacks),
            stage_text(program, width, "shared", layout, self.fallbacks),
        ]
        self.values = f.slot(f"<{lanes} x double>", max(program.signature.num_outputs, 1))
        for lane in range(0, lanes, width):
            first, c = str(lane), str(lane * len(program.carried))
            inputs = [f.at(f"%{name}", first) for name in "txr"]
            self._call("shared", lane, *inputs, f.at("%c", c), f.at(self.values, first))
            p, constants = self.prepare.at("%p", first), self.prepare.at("%c", c)
            self.prepare.do(f"call void @shared.prepare(ptr {p}, ptr {constants})")

    def _part(self, part: Part, width: int) -> None:
        tangent, lanes, f, name = self.tangent, self.lanes, self.kernel, f"part.{part.first}"
        (rows, columns), has_directions = tangent.shape, tangent.directions is not None
        single, padded = lanes == 1, lanes == 1 and part.count < width
        row = width if padded else columns * lanes
        # A row of the unit matrix is the one above, shifted by one.
        steps = {"%x": row if has_directions else -1, "%out": row, "%r": lanes}
        broadcast = ["%r"] if single else ["%p", *([] if has_directions else ["%x"])]
        layout = ArrayLayout(steps if single else {**steps, "%p": 1}, broadcast)
        self.functions += [
            prepare_text(part.program, width, f"{name}.", layout, self.fallbacks),
            stage_text(part.program, width, name, layout, self.fallbacks),
        ]
        after, begin = tangent.values * lanes, tangent.shared.signature.num_states * lanes
        starts = [*range(0, part.count, width if single else 1)]
        if single and not padded:
            starts[-1] = part.count - width
        for start in starts:
            column, c = part.first + start, self.next_constant
            self.next_constant += width * len(part.program.carried)
            if part.program.carried:
                self._direction(part, column, width, c)
            for lane in range(0, lanes, 1 if single else width):
                offset = column * lanes + lane
                x, out = f.at("%x", str(begin + offset)), f.at("%out", str(after + offset))
                if not has_directions:
                    row_of_units = [0.0] * (2 * part.count + width)
                    row_of_units[part.count] = 1.0
                    units = self._table(f"units.{part.count}.{width}", row_of_units)
                    x = f.at(units, str(part.count + start))
                values, constants = f.at(self.values, str(after + lane)), f.at("%c", str(c))
                end = f.slot(f"<{width} x double>", rows) if padded else out
                if padded and has_directions:
                    x = self._filled(x, part, width)
                self._call(name, lane, f.at("%t", str(lane)), x, values, constants, end)
                if padded:
                    self._copy(end, width, out, columns, (rows, part.count))

    def _filled(self, x: str, part: Part, width: int) -> str:
        """Return seeds padded to a vector in each row."""
        rows, columns = part.program.signature.num_states, self.tangent.shape[1]
        filled = self.kernel.slot(f"<{width} x double>", rows)
        self.kernel.do(self._memory("set.p0", filled, "i8 0", width * rows))
        self._copy(x, columns, filled, width, (rows, part.count))
        return filled

    def _direction(self, part: Part, column: int, width: int, c: int) -> None:
        """Bind the directions of a vector of columns."""
        directions, g = self.tangent.directions, self.prepare
        assert directions is not None
        columns = directions[:, column : column + (width if self.lanes == 1 else 1)]
        numbers = columns
        if self.lanes == 1:
            numbers = np.pad(columns, [(0, 0), (0, width - columns.shape[1])])
        table = self._table(f"direction.{column}", numbers.ravel().tolist())
        constants = g.at("%c", str(c))
        g.do(f"call void @part.{part.first}.prepare(ptr {table}, ptr {constants})")

    def _copy(
        self,
        source: str,
        step: int,
        destination: str,
        destination_step: int,
        shape: tuple[int, int],
    ) -> None:
        """Copy a table between arrays with different distances of rows."""
        f = self.kernel
        with f.loop("0", str(shape[0])) as i, f.loop("0", str(shape[1])) as j:
            source_index, destination_index = (
                f.let(f"add i64 {f.let(f'mul i64 {i}, {distance}')}, {j}")
                for distance in (step, destination_step)
            )
            f.store(
                "double", f.load("double", source, source_index), destination, destination_index
            )
