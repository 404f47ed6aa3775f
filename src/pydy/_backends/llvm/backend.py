"""The default back end: straight-line LLVM IR for a Program, compiled in the process.

No compiler is needed on the user's machine. There are no fast-math flags: NaN, infinity and the
order of operations are kept, and fused multiply-adds are those that the IR spells out.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from pydy import _forks
from pydy._backends.llvm import jit
from pydy._backends.llvm.background import Compile
from pydy._backends.llvm.compiling import object_code
from pydy._backends.llvm.emit import BRANCH_WEIGHTS, SOLVES, Emitter, called
from pydy._backends.llvm.ir import HEAP_DECLARATIONS, MALLOC, WIDTHS, Function, vector_type
from pydy._backends.llvm.native import Entry, native_kernel
from pydy._backends.llvm.sincos import sincos_declarations, sincos_functions, sincos_names
from pydy._backends.llvm.solve import solver_declarations, solver_functions, solver_names
from pydy._backends.llvm.targets import target
from pydy._backends.registry import compile_program
from pydy._backends.tuning import LARGE, LOOP, MOST_RESULTS, SHORT, TEMPORARY
from pydy._graph.collector import collector_paused
from pydy._graph.operations import ANGLES
from pydy._graph.program import Program
from pydy._kernel import Kernel

__all__ = [
    "KERNEL_PARAMETERS",
    "LLVMBackend",
    "Tiers",
    "calls_routines",
    "kernel_text",
    "module_text",
    "prepare_text",
    "shared_routines",
    "stage_text",
    "wide_code",
]


class LLVMBackend:
    """Compiles Programs with LLVM.

    Parameters
    ----------
    cse : bool, optional
        Accepted for scripts that pass it; common sub-expressions are always shared.
    lanes : {1, 2, 4, 8}, optional
        How many states the native code takes at once. Right-hand sides for Python need 1.
    width : {2, 4, 8}, optional
        How many of several lanes the equations' code takes at once; the rest follow in further
        turns. By default what suits the processor's registers. It does not change the bits.
    """

    def __init__(self, cse: bool = True, lanes: int = 1, width: int | None = None) -> None:
        if lanes not in WIDTHS:
            raise ValueError(f"`lanes` is {lanes!r}, but it must be 1, 2, 4 or 8.")
        if width is not None and (width not in WIDTHS[1:] or width > lanes):
            raise ValueError(f"`width` is {width!r}, but it must be 2, 4 or 8 and at most `lanes`.")
        self.options: dict[str, Any] = {"cse": cse, "lanes": lanes}
        if width is not None:
            self.options["width"] = width

    def compile(self, program: Program) -> Kernel:
        """Return the Kernel of a Program.

        Nothing is compiled before the Kernel is called or asked for its best code. At a call, code
        that is not in the cache is compiled quickly first, so that a simulation can begin, and at
        LLVM's best on the side, which takes its place when it is ready. Both compute the same bits.
        Wide kernels are for long work and get the best at once.
        """
        lanes: int = self.options["lanes"]
        recipe = ("llvm", self.options)
        if lanes == 1:
            source, calls = _source(program, 1, 1, loops=_repeats(program)), calls_routines(program)
            return native_kernel(
                program, Entry(Tiers(source, (1,) if calls else ())), 1, compile_program, recipe
            )
        code = wide_code(program, lanes, self.options.get("width"))
        entry = Entry()
        entry.replace((code.addresses["kernel"], code.addresses["prepare"]), code)
        strided = code.addresses["strided"]
        return native_kernel(program, entry, lanes, compile_program, recipe, strided)


@dataclass(frozen=True)
class Tiers:
    """Code for one state; `calls` are the lanes of the shared routines that it needs."""

    source: jit.Source
    calls: tuple[int, ...]

    def at_hand(self) -> tuple[jit.Code, bool]:
        routines = jit.Joined([shared_routines(lanes, at_best=False) for lanes in self.calls])
        code = jit.find(self.source, routines)
        best = code is not None
        return code or jit.load_quickly(self.source, routines), best

    def best(self, compile_source: Compile) -> jit.Code:
        routines = [shared_routines(lanes, True, compile_source) for lanes in self.calls]
        return jit.load(self.source, jit.Joined(routines), compile_source)


@dataclass(frozen=True)
class _Text:
    """The IR of a Program; pickled as bytes that the interpreter writes in a sixth of the time."""

    program: Program
    lanes: int
    width: int

    @collector_paused()
    def __call__(self, brief: bool) -> str:
        return kernel_text(self.program, self.lanes, self.width, brief)

    def __reduce__(self) -> tuple[Any, ...]:
        return _read_text, (self.program.to_bytes(), self.lanes, self.width)


def wide_code(program: Program, lanes: int, width: int | None = None) -> jit.Code:
    """Return the best code of a Program for several states at once, compiled if need be."""
    width = width or width_of(program, lanes)
    routines = shared_routines(width, at_best=True) if calls_routines(program) else None
    return jit.load(_source(program, lanes, width), routines)


def _source(program: Program, lanes: int, width: int, loops: bool = False) -> jit.Source:
    name, text = f"kernel {program.digest} {lanes} {width}", _Text(program, lanes, width)
    return jit.Source(name, text, ("kernel", "prepare", "strided")[: 2 + (lanes > 1)], loops=loops)


def calls_routines(program: Program) -> bool:
    """Return whether the shared routines are called."""
    return bool({*SOLVES, *ANGLES} & set(program.ops))


def _read_text(program: bytes, lanes: int, width: int) -> _Text:
    return _Text(Program.from_bytes(program), lanes, width)


def width_of(program: Program, lanes: int) -> int:
    """Return how many lanes a Program's code takes at once.

    All of a small one, which is a loop; and all, if there are registers for it, where little is
    done for each result, so that memory limits it: turns would read and write each line of the
    cache several times.
    """
    host = target()
    fits = host.vectors(lanes) > TEMPORARY
    if _is_small(program) or (fits and _does_little(program)):
        return lanes
    return min(lanes, host.registers.widest)


def _repeats(program: Program) -> bool:
    """Return whether LLVM should look for operations that can be done side by side in one state.

    It then writes vectors for a chain's masses: half the code, and half the time for 300 of them;
    compiling takes 3 to 5 times as long.
    """
    large = program.operation_count["run"].total() > LARGE
    return large and len(program.outputs) <= MOST_RESULTS and _does_little(program)


def _does_little(program: Program) -> bool:
    return program.operation_count["run"].total() < SHORT * len(program.outputs)


_ROUTINES: dict[tuple[int, bool], jit.Code] = {}
_ROUTINES_LOCK = _forks.Lock()


def shared_routines(lanes: int, at_best: bool, compile_source: Compile = object_code) -> jit.Code:
    """Return the routines kernels call; unless they are cached, quickly compiled will do."""
    best = _ROUTINES.get((lanes, True))
    if best is not None:
        return best
    names = solver_names(lanes) + sincos_names(lanes)
    source = jit.Source(f"routines {lanes}", partial(_routines_text, lanes), names, loops=True)
    code: jit.Code | None
    if not at_best:
        code = jit.find(source)
    elif compile_source is object_code:
        with _ROUTINES_LOCK:  # whoever comes second finds what the first one compiled
            code = jit.load(source)
    else:
        code = jit.load(source, None, compile_source)
    if code is not None:
        return _ROUTINES.setdefault((lanes, True), code)
    quick = _ROUTINES.get((lanes, False))
    if quick is None:
        quick = _ROUTINES[lanes, False] = jit.load_quickly(source)
    return quick


def _routines_text(lanes: int, brief: bool) -> str:
    """Return the module of what many kernels share: linear solves, sine and cosine."""
    widths = WIDTHS if lanes == 1 else (1, lanes)
    parts = [_arithmetic_declarations(widths), *_LIBM_ANGLES, *BRANCH_WEIGHTS]
    parts += [sincos_functions(w) for w in widths if w == lanes or lanes == 1]
    return "\n".join([*parts, solver_functions(lanes)])


def kernel_text(
    program: Program, lanes: int, width: int = 0, brief: bool = False, columns: int = 0
) -> str:
    """Return the module of a Program, with the functions `kernel` and `prepare`.

    A `brief` one calls a routine for sines and cosines instead of writing them in line. With
    `columns` a lane is one of so many columns, which lie side by side in each row of x and of the
    output, and the inputs r are numbers that all have in common.
    """
    width = width or lanes
    if width < lanes:
        body = _in_turns(program, lanes, width, brief)
    elif columns:
        steps = {"%x": columns, "%out": columns}
        parts = [stage_text(program, lanes, brief, steps=steps), *BRANCH_WEIGHTS, ""]
        body = prepare_text(program, lanes, brief) + "\n".join(parts)
    else:
        body = prepare_text(program, lanes, brief) + _kernel(program, lanes, brief)
    return module_text(body, [(program, width)])


def module_text(body: str, parts: Sequence[tuple[Program, int]]) -> str:
    """Return functions with the declarations that they need.

    Parameters
    ----------
    body : str
    parts : sequence of (Program, lanes)
        What the functions are made of.
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


def prepare_text(program: Program, lanes: int, brief: bool, prefix: str = "") -> str:
    """Return the function of the setup stage."""
    linkage = "internal" if prefix else ""
    f = Function(f"{prefix}prepare", "void", _PREPARES, f"{linkage}|nounwind")
    Emitter(f, program, lanes, target().vectors(lanes), True, brief).stage()
    f.do("ret void")
    f.label("%bail")
    f.do("ret void")
    return f.text()


_PREPARES = "ptr noalias readonly %p, ptr noalias %c"
_ARRAYS = ("t", "x", "r", "c", "out")


def _parameters(suffix: str = "") -> str:
    inputs = ", ".join(f"ptr noalias readonly %{name}{suffix}" for name in _ARRAYS[:-1])
    return f"{inputs}, ptr noalias %out{suffix}"


KERNEL_PARAMETERS = _parameters()


def _kernel(program: Program, lanes: int, brief: bool) -> str:
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
    small = _is_small(program)
    if lanes == 1 or small:
        parts.insert(0, stage_text(program, lanes, brief))
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
    steps: Mapping[str, int] | None = None,
    linkage: str = "",
) -> str:
    """Return the function of the run stage.

    Parameters
    ----------
    program : Program
    lanes : int
    brief : bool
        See `kernel_text`.
    name : str
    steps : mapping of str to int, optional
        Distances between the items of %x and %out: lanes are then columns, which lie side by side
        in each row, and the inputs r are numbers that all have in common.
    linkage : str
    """
    f = Function(name, "i32", KERNEL_PARAMETERS, f"{linkage}|nounwind")
    e = Emitter(f, program, lanes, target().vectors(lanes), False, brief)
    e.solves.status = f.variable("i32", "0")
    if steps:
        e.names.steps.update({group: str(step) for group, step in steps.items()})
        e.names.spread.add("%r")
    e.stage()
    f.do(f"ret i32 {f.get('i32', e.solves.status)}")
    f.label("%bail")
    f.do("ret i32 0")
    return f.text()


def _is_small(program: Program) -> bool:
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
    f = Function("kernel", "i32", KERNEL_PARAMETERS, "|nounwind")
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
    prepare = Function("prepare", "void", _PREPARES, "|nounwind")
    p = prepare.slot(v, max(program.num_constants, 1))
    for first in turns:
        with prepare.loop("0", str(program.num_constants)) as i:
            place = prepare.at("%p", prepare.let(f"mul i64 {i}, {lanes}"))
            value = prepare.load(v, prepare.at(place, str(first)))
            prepare.store(v, value, p, i)
        c = prepare.at("%c", str(first * carried))
        prepare.do(f"call void @turn.prepare(ptr {p}, ptr {c})")
    prepare.do("ret void")
    f = Function("strided", "i64", f"{KERNEL_PARAMETERS}, ptr noalias readonly %steps", "|nounwind")
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
