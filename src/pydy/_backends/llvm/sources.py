"""The code of a Program or Tangent, and the routines that it calls, as modules to compile.

Code for one state has no fallbacks where those are most of the code, as in a long chain: where a
guard is not sound, it calls the complete code, which is compiled then (`functions`).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

from pydy import _forks
from pydy._backends.llvm import jit
from pydy._backends.llvm.compiling import CORE, Source
from pydy._backends.llvm.emit import solver_names
from pydy._backends.llvm.sincos import sincos_names
from pydy._backends.llvm.targets import target
from pydy._backends.llvm.text import (
    Fallbacks,
    angles_text,
    is_small,
    kernel_text,
    pieces,
    tangent_text,
)
from pydy._backends.tuning import LARGE, MOST_WITHOUT_FALLBACKS, SHORT, TEMPORARY
from pydy._collector import collector_paused
from pydy._program import OPERATIONS, Program, Tangent


@dataclass(frozen=True)
class _Text:
    """The IR of a Program or Tangent."""

    program: Program | Tangent
    lanes: int
    width: int
    fallbacks: Fallbacks = Fallbacks.ALWAYS

    @collector_paused()
    def __call__(self) -> str:
        if isinstance(self.program, Tangent):
            return tangent_text(self.program, self.lanes, self.fallbacks)
        return kernel_text(self.program, self.lanes, self.width, self.fallbacks)


def source_for_one_state(program: Program | Tangent) -> Source:
    """Return the code for one state, with all fallbacks."""
    fallbacks = Fallbacks.ADDED if leaves_out_fallbacks(program) else Fallbacks.ALWAYS
    loops = isinstance(program, Program) and _repeats(program)
    return _source(program, 1, 1, fallbacks, loops)


def source_without_fallbacks(program: Program | Tangent) -> Source:
    """Return the code for one state that leaves its fallbacks out."""
    name = f"kernel {program.digest} without fallbacks"
    return Source(name, _Text(program, 1, 1, Fallbacks.LEFT_OUT), ("kernel", "prepare"))


def leaves_out_fallbacks(program: Program | Tangent) -> bool:
    """Whether code for one state is compiled without fallbacks at first: they are much of it."""
    programs = [part for part, _ in pieces(program, 1)]
    needed = sum(len(part.without_fallbacks) for part in programs)
    return needed < MOST_WITHOUT_FALLBACKS * sum(len(part.ops) for part in programs)


def wide_code(program: Program | Tangent, lanes: int, width: int | None = None) -> jit.Code:
    """Return code for several states at once, compiled if need be."""
    if isinstance(program, Program):
        width = width or width_of(program, lanes)
    routines = routines_of(program, width or lanes)
    return jit.load(_source(program, lanes, width or lanes), routines)


def _source(
    program: Program | Tangent,
    lanes: int,
    width: int,
    fallbacks: Fallbacks = Fallbacks.ALWAYS,
    loops: bool = False,
) -> Source:
    name = f"kernel {program.digest} {lanes} {width}"
    text = _Text(program, lanes, width, fallbacks)
    strided = lanes > 1 and isinstance(program, Program)
    names = ("kernel", "prepare", "strided")[: 2 + strided]
    return Source(name, text, names, loops=loops)


def routines_of(program: Program | Tangent, lanes: int, fallbacks: bool = True) -> list[jit.Code]:
    """Return the shared routines that a Program's code calls."""
    kinds = ("angles", {*OPERATIONS.angles}), ("solve", OPERATIONS.solves)
    parts = [(_called(one, fallbacks), own) for one, own in pieces(program, lanes)]
    called = {(kind, own) for kind, ops in kinds for found, own in parts if ops & found}
    return [_shared_routines(*call) for call in sorted(called)]


def _called(program: Program, fallbacks: bool) -> set[str]:
    """Return the operations in a Program's code; without fallbacks guards solve nothing."""
    if fallbacks:
        return set(program.ops)
    needed = program.without_fallbacks
    in_setup = {op for op, setup in zip(program.ops, program.setup, strict=True) if setup}
    return in_setup | {op for k in needed if (op := program.ops[k]) != "guard"}


def width_of(program: Program, lanes: int) -> int:
    """Return how many lanes a Program's code takes at once.

    All of a small one, which is a loop; and all, if there are registers for it, where little is
    done for each result, so that memory limits it: turns would read and write each line of the
    cache several times.
    """
    host = target()
    fits = host.vectors(lanes) > TEMPORARY
    if is_small(program) or (fits and _does_little(program)):
        return lanes
    return min(lanes, host.registers.widest)


def _repeats(program: Program) -> bool:
    """Return whether LLVM should look for operations that can be done side by side in one state.

    It then writes vectors for a chain's masses: half the code, and half the time for 300 of them;
    compiling takes 3 to 5 times as long.
    """
    large = program.operation_count["run"].total() > LARGE
    # To look for them takes LLVM the square of the number of results: 40 s in place of 4 for the
    # Jacobian of 50 masses, 100 by 100.
    return large and len(program.outputs) <= 2000 and _does_little(program)


def _does_little(program: Program) -> bool:
    return program.operation_count["run"].total() < SHORT * len(program.outputs)


_ROUTINES: dict[tuple[str, int], jit.Code] = {}
_ROUTINES_LOCK = _forks.Lock()


def _shared_routines(kind: str, lanes: int) -> jit.Code:
    """Return routines that kernels call, the same for all models."""
    with _ROUTINES_LOCK:
        code = _ROUTINES.get((kind, lanes))
        if code is None:
            if kind == "solve":
                source = CORE.source(f"solve_{lanes}", solver_names(lanes))
            else:
                text = partial(angles_text, lanes)
                source = Source(f"angles {lanes}", text, sincos_names(lanes), loops=True)
            code = _ROUTINES[kind, lanes] = jit.load(source)
    return code
