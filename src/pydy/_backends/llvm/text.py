"""The IR of a Program: the functions `prepare` and `kernel`, and `strided` for several states.

There are no fast-math flags: NaN, infinity and the order of operations are kept, and fused
multiply-adds are those that the IR spells out.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from pydy._backends.llvm.emit import (
    BRANCH_WEIGHTS,
    SOLVES,
    Emitter,
    called,
    solver_declarations,
)
from pydy._backends.llvm.ir import HEAP_DECLARATIONS, MALLOC, WIDTHS, Function, vector_type
from pydy._backends.llvm.plan import Layout
from pydy._backends.llvm.sincos import sincos_declarations, sincos_functions
from pydy._backends.llvm.targets import target
from pydy._backends.tuning import LOOP
from pydy._graph.operations import ANGLES
from pydy._graph.program import Program


def kernel_text(
    program: Program, lanes: int, width: int = 0, brief: bool = False, fallbacks: bool = True
) -> str:
    """Return the module of a Program, with the functions `kernel` and `prepare`.

    A `brief` one calls a routine for sines and cosines instead of writing them in line. Without
    `fallbacks` code of one lane gives the status -1 where a guard is not sound.
    """
    width = width or lanes
    if width < lanes:
        body = _in_turns(program, lanes, width, brief)
    else:
        body = prepare_text(program, lanes, brief, fallbacks=fallbacks)
        body += _kernel(program, lanes, brief, fallbacks)
    return module_text(body, [(program, width)])


def module_text(body: str, parts: Sequence[tuple[Program, int]]) -> str:
    """Return functions with the declarations that they need.

    The parts are Programs that the functions are made of, with their lanes.
    """
    declared = "\n".join(_declarations(*part) for part in parts).splitlines()
    head = [*dict.fromkeys(declared)]
    if f"{MALLOC}(" in body:
        head.append(HEAP_DECLARATIONS)
    # Sines and cosines are taken several at a time, in as many widths as they come.
    head += [
        sincos_declarations(width, kind)
        for kind in ("", "far_")
        for width in WIDTHS
        if f"@pydy_sincos_{kind}{width}(" in body
    ]
    for lanes in sorted({lanes for _, lanes in parts} - {1}):
        calls: dict[str, int] = {}
        for program, own in parts:
            calls.update(called(program, "libm") if own == lanes else {})
        head += [_lane_by_lane(*call, lanes) for call in calls.items()]
    return "\n".join([*head, "", body])


_LIBM_ANGLES = tuple(f"declare double @{name}(double) nounwind" for name in ANGLES)


def _arithmetic_declarations(widths: Iterable[int]) -> str:
    lines = []
    for width in widths:
        v, end = vector_type("double", width), "f64" if width == 1 else f"v{width}f64"
        lines.append(f"declare {v} @llvm.fma.{end}({v}, {v}, {v})")
        lines.append(f"declare {v} @llvm.fabs.{end}({v})")
    return "\n".join(lines)


def _declarations(program: Program, lanes: int) -> str:
    v = vector_type("double", lanes)
    suffix = "f64" if lanes == 1 else f"v{lanes}f64"
    lines = [
        f"declare double @{name}({', '.join(['double'] * arity)}) nounwind willreturn memory(none)"
        for name, arity in called(program, "libm").items()
    ]
    if SOLVES.keys() & set(program.ops):
        lines.append(solver_declarations(lanes))
    packs = WIDTHS if lanes == 1 and set(ANGLES) & set(program.ops) else (lanes,)
    lines.append(_arithmetic_declarations(packs))
    for name, arity in called(program, "intrinsic").items():
        if name != "fabs":
            lines.append(f"declare {v} @llvm.{name}.{suffix}({', '.join([v] * arity)})")
    return "\n".join(lines) + "\n"


def _lane_by_lane(name: str, arity: int, lanes: int) -> str:
    """Return a vector function that calls libm for each lane."""
    v = vector_type("double", lanes)
    vectors = [f"{v} %a{k}" for k in range(arity)]
    f = Function(f"{name}.lanes", v, ", ".join(vectors), "internal|nounwind memory(none)")
    result = "poison"
    for lane in range(lanes):
        args = [f.let(f"extractelement {vector}, i32 {lane}") for vector in vectors]
        value = f.let(f"call double @{name}({', '.join('double ' + a for a in args)})")
        result = f.let(f"insertelement {v} {result}, double {value}, i32 {lane}")
    f.do(f"ret {v} {result}")
    return f.text()


def prepare_text(
    program: Program,
    lanes: int,
    brief: bool,
    prefix: str = "",
    fallbacks: bool = True,
    layout: Layout | None = None,
) -> str:
    """Return the function of the setup stage."""
    linkage = "internal" if prefix else ""
    f = Function(f"{prefix}prepare", "void", PREPARE, f"{linkage}|nounwind")
    e = Emitter(f, program, lanes, target().vectors(lanes), True, brief, fallbacks=fallbacks)
    e.names.lie(layout)
    e.stage()
    f.do("ret void")
    f.label("%bail")
    f.do("ret void")
    return f.text()


PREPARE = "ptr noalias readonly %p, ptr noalias %c"
_ARRAYS = ("t", "x", "r", "c", "out")


def _parameters(suffix: str = "") -> str:
    inputs = ", ".join(f"ptr noalias readonly %{name}{suffix}" for name in _ARRAYS[:-1])
    return f"{inputs}, ptr noalias %out{suffix}"


KERNEL = _parameters()


def _kernel(program: Program, lanes: int, brief: bool, fallbacks: bool) -> str:
    """Return the functions of the second stage; wide code has a `strided` form beside `kernel`.

    It reads from memory, after the arrays, the distances between two items of x, r and out; how
    many blocks of states there are; and the distance between two blocks of r. It does as many as it
    likes, stops at the first that fails, and returns the status of the last one and, above 32
    bits, how many it did.

    For small models it is a loop: what leads in and out of a function would take as long as their
    equations. Larger ones do one block: the numbers that LLVM takes out of a loop's body would have
    to wait in memory.
    """
    parts = [*BRANCH_WEIGHTS, ""]
    small = is_small(program)
    if lanes == 1 or small:
        parts.insert(0, stage_text(program, lanes, brief, fallbacks=fallbacks))
    else:
        parts.append(_packed_kernel(lanes))
    if lanes > 1:
        parts.insert(0, _strided(program, lanes, brief, small))
    return "\n".join(parts)


def stage_text(
    program: Program,
    lanes: int,
    brief: bool,
    name: str = "kernel",
    layout: Layout | None = None,
    fallbacks: bool = True,
) -> str:
    """Return the function of the run stage; see `kernel_text`.

    A function that others of the module call is told the layout of its arrays.
    """
    f = Function(name, "i32", KERNEL, f"{'internal' if layout else ''}|nounwind")
    vectors = target().vectors(lanes)
    e = Emitter(f, program, lanes, vectors, False, brief, fallbacks=fallbacks)
    e.solves.status = f.variable("i32", "0")
    e.names.lie(layout)
    e.stage()
    f.do(f"ret i32 {f.get('i32', e.solves.status)}")
    f.label("%bail")
    f.do("ret i32 0")
    return f.text()


def is_small(program: Program) -> bool:
    return sum(not setup for setup in program.setup) <= LOOP


def _is_one_block(program: Program, lanes: int) -> bool:
    registers = target().registers
    size = program.operation_count["run"].total() + len(program.outputs)
    return lanes == registers.widest and size <= registers.whole


def _strided(program: Program, lanes: int, brief: bool, loop: bool, prefix: str = "") -> str:
    parameters = f"{_parameters('.first' if loop else '')}, ptr noalias readonly %steps"
    linkage = "internal" if prefix else ""
    f = Function(f"{prefix}strided", "i64", parameters, f"{linkage}|nounwind")
    whole = not loop and _is_one_block(program, lanes)
    e = Emitter(f, program, lanes, target().vectors(lanes), False, brief, whole)
    e.solves.status = f.variable("i32", "0")
    for place, group in enumerate(("%x", "%r", "%out")):
        e.names.steps[group] = f.load("i64", "%steps", str(place))
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
        rest = f.let(f"icmp slt i64 %done, {count}")
        f.do(f"br i1 {f.let(f'and i1 {good}, {rest}')}, label %more, label %finish")
        f.label("%more")
        f.do("br label %block")
        f.label("%finish")
    high, low = f.let("shl i64 %done, 32"), f.let(f"zext i32 {status} to i64")
    f.do(f"ret i64 {f.let(f'or i64 {high}, {low}')}")
    f.label("%bail")
    f.do("ret i64 0")
    return f.text()


def _packed_kernel(lanes: int) -> str:
    """Return the `kernel` that hands ``[item][lane]`` to its strided form."""
    f = Function("kernel", "i32", KERNEL, "|nounwind")
    arguments = ", ".join(f"ptr %{name}" for name in _ARRAYS)
    both = f.let(f"tail call i64 @strided({arguments}, ptr @packed)")
    f.do(f"ret i32 {f.let(f'trunc i64 {both} to i32')}")
    steps = ", ".join(f"i64 {n}" for n in (lanes, lanes, lanes, 1, lanes))
    return f"@packed = private constant [5 x i64] [{steps}]\n" + f.text()


def _in_turns(program: Program, lanes: int, width: int, brief: bool) -> str:
    """Return functions of all lanes that call code for some of them, turn by turn.

    Where all lanes of a value do not fit in a register, it takes several, and half as many values
    or fewer fit at a time. What `prepare` leaves in c lies turn by turn too.
    """
    turns = range(0, lanes, width)
    v, carried = vector_type("double", width), len(program.carried)
    prepare = Function("prepare", "void", PREPARE, "|nounwind")
    p = prepare.slot(v, max(program.num_constants, 1))
    for first in turns:
        with prepare.loop("0", str(program.num_constants)) as i:
            place = prepare.at("%p", prepare.let(f"mul i64 {i}, {lanes}"))
            value = prepare.load(v, prepare.at(place, str(first)))
            prepare.store(v, value, p, i)
        c = prepare.at("%c", str(first * carried))
        prepare.do(f"call void @turn.prepare(ptr {p}, ptr {c})")
    prepare.do("ret void")
    f = Function("strided", "i64", f"{KERNEL}, ptr noalias readonly %steps", "|nounwind")
    status = "0"
    for first in turns:
        places = {name: f.at(f"%{name}", str(first)) for name in _ARRAYS}
        places["c"] = f.at("%c", str(first * carried))
        arguments = ", ".join(f"ptr {place}" for place in places.values())
        both = f.let(f"call i64 @turn.strided({arguments}, ptr %steps)")
        bits = f.let(f"shl i64 {f.let(f'and i64 {both}, {2**32 - 1}')}, {first}")
        status = f.let(f"or i64 {status}, {bits}")
    f.do(f"ret i64 {f.let(f'or i64 {status}, {2**32}')}")
    own = prepare_text(program, width, brief, "turn.") + _strided(
        program, width, brief, False, "turn."
    )
    outer = [prepare.text(), f.text(), _packed_kernel(lanes)]
    return "\n".join([own, *outer, *BRANCH_WEIGHTS, ""])


def angles_text(lanes: int, brief: bool) -> str:
    """Return the module of the sines and cosines that kernels share."""
    widths = WIDTHS if lanes == 1 else (lanes,)
    parts = [_arithmetic_declarations(widths), *_LIBM_ANGLES, *BRANCH_WEIGHTS]
    return "\n".join([*parts, *map(sincos_functions, widths)])
