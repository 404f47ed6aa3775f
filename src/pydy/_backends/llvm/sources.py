"""The code of a Program or Tangent, and the routines that it calls, as modules to compile.

If fallbacks are most of the code, as in a long chain, code for one state is compiled without them.
If a guard is not sound, it calls the complete code, which is compiled at that moment (`functions`).
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
    program_parts,
    tangent_text,
)
from pydy._backends.tuning import LARGE, MOST_WITHOUT_FALLBACKS, SHORT, TEMPORARY
from pydy._collector import collector_paused
from pydy._program import OPERATIONS, Program, Tangent


@dataclass(frozen=True)
class _KernelIr:
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
    return Source(name, _KernelIr(program, 1, 1, Fallbacks.LEFT_OUT), ("kernel", "prepare"))


def leaves_out_fallbacks(program: Program | Tangent) -> bool:
    """Return whether code for one state is compiled without its fallbacks at first."""
    programs = [part for part, _ in program_parts(program, 1)]
    needed = sum(len(part.without_fallbacks) for part in programs)
    return needed < MOST_WITHOUT_FALLBACKS * sum(len(part.ops) for part in programs)


def wide_code(program: Program | Tangent, lanes: int, width: int | None = None) -> jit.Code:
    """Return code for several states at once, compiled if need be."""
    if isinstance(program, Program):
        width = width or width_of(program, lanes)
    routines = routines_of(program, width or lanes)
    return jit.load(_source(program, lanes, width or lanes), routines)


def cached_wide_code(program: Program, lanes: int) -> jit.Code | None:
    """Return the same code if this process uses it, or a cache has it."""
    width = width_of(program, lanes)
    return jit.find(_source(program, lanes, width), routines_of(program, width))


def gains_by_lanes(program: Program) -> bool:
    """Return whether code for several states takes clearly less time for each of them.

    Memory limits code that does little.
    """
    return not _does_little(program)


def _source(
    program: Program | Tangent,
    lanes: int,
    width: int,
    fallbacks: Fallbacks = Fallbacks.ALWAYS,
    loops: bool = False,
) -> Source:
    name = f"kernel {program.digest} {lanes} {width}"
    text = _KernelIr(program, lanes, width, fallbacks)
    strided = lanes > 1 and isinstance(program, Program)
    names = ("kernel", "prepare", "strided")[: 2 + strided]
    return Source(name, text, names, loops=loops)


def routines_of(program: Program | Tangent, lanes: int, fallbacks: bool = True) -> list[jit.Code]:
    """Return the shared routines that a Program's code calls."""
    kinds = ("angles", {*OPERATIONS.angles}), ("solve", OPERATIONS.solves)
    parts = [
        (_operations_in_code(part, fallbacks), width)
        for part, width in program_parts(program, lanes)
    ]
    routines = {
        (kind, width) for kind, ops in kinds for ops_in_part, width in parts if ops & ops_in_part
    }
    return [_shared_routines(*call) for call in sorted(routines)]


def _operations_in_code(program: Program, fallbacks: bool) -> set[str]:
    """Return the operations in a Program's code; without fallbacks guards solve nothing."""
    if fallbacks:
        return set(program.ops)
    needed = program.without_fallbacks
    in_setup = {op for op, setup in zip(program.ops, program.setup, strict=True) if setup}
    return in_setup | {op for k in needed if (op := program.ops[k]) != "guard"}


def width_of(program: Program, lanes: int) -> int:
    """Return the number of lanes that a Program's code processes at once.

    This is `lanes` for a small Program, which is a loop. It is also `lanes` if there are enough
    registers and few operations for each result: memory limits such code, and groups of lanes
    would access each cache line several times.
    """
    host = target()
    fits = host.vectors(lanes) > TEMPORARY
    if is_small(program) or (fits and _does_little(program)):
        return lanes
    return min(lanes, host.registers.widest)


def _repeats(program: Program) -> bool:
    """Return whether LLVM should vectorise equal operations within one state (SLP).

    For a chain of 300 masses this halves the code and the run time; compiling takes 3 to 5 times
    as long.
    """
    large = program.operation_count["run"].total() > LARGE
    # The time for this grows with the square of the number of results: 40 s instead of 4 s for the
    # 100 by 100 Jacobian of 50 masses.
    return large and program.signature.num_outputs <= 2000 and _does_little(program)


def _does_little(program: Program) -> bool:
    return program.operation_count["run"].total() < SHORT * program.signature.num_outputs


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
