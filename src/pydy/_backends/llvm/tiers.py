"""Code of a Program and of the routines it calls: at hand at once, or the best.

Code that is not in the cache is compiled quickly first, so that a simulation can begin, and at
LLVM's best on the side, which takes its place when it is ready. Both compute the same bits. What
only fallbacks need, most of a long chain's code, is left out at first; where a guard is not sound,
it is compiled after all. Code for several states is for long work and gets the best at once.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

from pydy import _forks
from pydy._backends.llvm import jit
from pydy._backends.llvm.background import Compile
from pydy._backends.llvm.compiling import Source, object_code
from pydy._backends.llvm.emit import SOLVES
from pydy._backends.llvm.native import Quality
from pydy._backends.llvm.sincos import sincos_names
from pydy._backends.llvm.solve import solver_names
from pydy._backends.llvm.tangents import pieces, tangent_text
from pydy._backends.llvm.targets import target
from pydy._backends.llvm.text import is_small, kernel_text, routines_text
from pydy._backends.tuning import LARGE, MOST_RESULTS, MOST_WITHOUT_FALLBACKS, SHORT, TEMPORARY
from pydy._graph.collector import collector_paused
from pydy._graph.operations import ANGLES
from pydy._graph.program import Program
from pydy._graph.tangent import Tangent, program_from_bytes


@dataclass(frozen=True)
class Tiers:
    """Code for one state."""

    source: Source
    calls: tuple[int, ...]  # the lanes of the shared routines that it needs
    short: Source | None = None  # the same without fallbacks, where that is much less

    def at_hand(self) -> tuple[jit.Code, Quality]:
        code = jit.find(self.source, self._routines())
        if code is not None:
            return code, Quality.BEST
        if self.short is not None:
            return jit.load_quickly(self.short, self._routines()), Quality.SHORT
        return self.complete(), Quality.COMPLETE

    def complete(self) -> jit.Code:
        return jit.load_quickly(self.source, self._routines())

    def _routines(self) -> jit.Joined:
        return jit.Joined([shared_routines(lanes, at_best=False) for lanes in self.calls])

    def best(self, compile_source: Compile) -> jit.Code:
        routines = [shared_routines(lanes, True, compile_source) for lanes in self.calls]
        return jit.load(self.source, jit.Joined(routines), compile_source)


def tiers_of(program: Program | Tangent) -> Tiers:
    """Return the code of a Program or Tangent for one state."""
    if isinstance(program, Tangent):
        return Tiers(_source(program, 1, 1), _calls(program, 1))
    short = None
    if len(program.without_fallbacks()) < MOST_WITHOUT_FALLBACKS * len(program.ops):
        name = f"kernel {program.digest} without fallbacks"
        short = Source(name, partial(_short_text, program), ("kernel", "prepare"))
    return Tiers(_source(program, 1, 1, loops=_repeats(program)), _calls(program, 1), short)


@collector_paused()
def _short_text(program: Program, brief: bool) -> str:
    return kernel_text(program, 1, brief=brief, fallbacks=False)


@dataclass(frozen=True)
class _Text:
    """The IR of a Program or Tangent; pickled as bytes that are written in a sixth of the time."""

    program: Program | Tangent
    lanes: int
    width: int

    @collector_paused()
    def __call__(self, brief: bool) -> str:
        if isinstance(self.program, Tangent):
            return tangent_text(self.program, self.lanes, brief)
        return kernel_text(self.program, self.lanes, self.width, brief)

    def __reduce__(self) -> tuple[Any, ...]:
        return _read_text, (self.program.to_bytes(), self.lanes, self.width)


def wide_code(program: Program | Tangent, lanes: int, width: int | None = None) -> jit.Code:
    """Return the best code for several states at once, compiled if need be."""
    if isinstance(program, Program):
        width = width or width_of(program, lanes)
    routines = [shared_routines(own, at_best=True) for own in _calls(program, width or lanes)]
    return jit.load(_source(program, lanes, width or lanes), jit.Joined(routines))


def _source(program: Program | Tangent, lanes: int, width: int, loops: bool = False) -> Source:
    name, text = f"kernel {program.digest} {lanes} {width}", _Text(program, lanes, width)
    strided = lanes > 1 and isinstance(program, Program)
    return Source(name, text, ("kernel", "prepare", "strided")[: 2 + strided], loops=loops)


def _calls(program: Program | Tangent, lanes: int) -> tuple[int, ...]:
    """Return the lanes of the shared routines that are called."""
    called = {own for one, own in pieces(program, lanes) if {*SOLVES, *ANGLES} & set(one.ops)}
    return tuple(sorted(called))


def _read_text(program: bytes, lanes: int, width: int) -> _Text:
    return _Text(program_from_bytes(program), lanes, width)


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
    source = Source(f"routines {lanes}", partial(routines_text, lanes), names, loops=True)
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
