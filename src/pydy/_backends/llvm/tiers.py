"""Code of a Program and of the routines it calls: at hand at once, or the best.

Code that is not in the cache is compiled quickly first, so that a simulation can begin, and at
LLVM's best on the side, which takes its place when it is ready. Both compute the same bits. What
only fallbacks need, most of a long chain's code, is left out at first; where a guard is not sound,
it is compiled after all. Code for several states is for long work and gets the best at once.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from functools import partial
from typing import Any
from weakref import ref

import numpy as np

from pydy import _forks
from pydy._backends.llvm import background, jit
from pydy._backends.llvm.background import Compile, Task
from pydy._backends.llvm.compiling import CORE, Source, object_code
from pydy._backends.llvm.emit import solver_names
from pydy._backends.llvm.sincos import sincos_names
from pydy._backends.llvm.targets import target
from pydy._backends.llvm.text import angles_text, is_small, kernel_text, pieces, tangent_text
from pydy._backends.tuning import LARGE, MOST_WITHOUT_FALLBACKS, SHORT, TEMPORARY
from pydy._graph.collector import collector_paused
from pydy._graph.operations import ANGLES, SOLVES
from pydy._graph.program import Program
from pydy._graph.tangent import Tangent, program_from_bytes


class Quality(Enum):
    """The quality of native functions.

    Short ones give the status -1 where a guard is not sound: they have no fallbacks.
    """

    SHORT, COMPLETE, BEST = range(3)


@dataclass(frozen=True)
class Tiers:
    """Code for one state."""

    source: Source
    calls: tuple[tuple[str, int], ...]  # the shared routines that it needs, with their lanes
    short: Source | None = None  # the same without fallbacks, where that is much less

    def at_hand(self, whole: bool) -> tuple[jit.Code, Quality]:
        """Take the code that is ready soonest, `whole` with its fallbacks."""
        code = jit.find(self.source, self._routines())
        if code is not None:
            return code, Quality.BEST
        if self.short is not None and not whole:
            return jit.load_quickly(self.short, self._routines()), Quality.SHORT
        return self.complete(), Quality.COMPLETE

    def complete(self) -> jit.Code:
        """Return code with all fallbacks, compiled quickly."""
        return jit.load_quickly(self.source, self._routines())

    def _routines(self) -> list[jit.Code]:
        return [shared_routines(*call, at_best=False) for call in self.calls]

    def best(self, compile_source: Compile) -> jit.Code:
        """Return the best code, compiled by the given function unless there is some."""
        routines = [shared_routines(*call, True, compile_source) for call in self.calls]
        return jit.load(self.source, routines, compile_source)


class Entry:
    """The native functions of a Program, `kernel` and `prepare`.

    They are made when they are first wanted, unless `replace` gives them at once; better ones may
    replace them at any time. `cell` has their addresses: who calls them reads these there, each
    time, as compiled loops do in the middle of a run.
    """

    def __init__(self, tiers: Tiers | None = None) -> None:
        self._tiers = tiers
        self._lock = _forks.Lock()
        self.cell = np.zeros(2, dtype=np.int64)
        self.short = False
        self.better: Task | None = None
        self._owners: list[Any] = []  # a call may be under way in the old code: it stays
        self._words = [self.cell]

    def begin(self, whole: bool = False) -> None:
        """Have some code, and better code compiled on the side."""
        if self.cell[0]:
            return
        with self._lock:
            if self.cell[0] or self._tiers is None:
                return
            code, quality = self._tiers.at_hand(whole)
            self.short = quality is Quality.SHORT
            if quality is not Quality.BEST:
                # Known before the code is: who wants the best after an interrupt finds it.
                self.better = Task(partial(_improve, ref(self), self._tiers))
            self._use(code)
            if self.better is not None:
                background.submit(self.better)

    def complete(self) -> None:
        """Have code with fallbacks."""
        with self._lock:
            if self.short and self._tiers is not None:
                self._use(self._tiers.complete())
                self.short = False

    def settle(self) -> None:
        """Have the best code, compiled now if need be."""
        if not self.cell[0]:
            with self._lock:
                if not self.cell[0] and self._tiers is not None:
                    self._use(self._tiers.best(object_code))
        if self.better is not None:
            self.better.run()

    def improve(self, code: jit.Code) -> None:
        """Use the best code from now on."""
        with self._lock:
            self._use(code)
            self.short = False

    def whole(self) -> np.ndarray:
        """Return the cell, with code that has fallbacks."""
        if not self.cell[0]:
            self.begin(whole=True)
        if self.short:
            self.complete()
        return self.cell

    def _use(self, code: jit.Code) -> None:
        self.replace((code.addresses["kernel"], code.addresses["prepare"]), code)

    def replace(self, addresses: tuple[int, int], owner: Any) -> None:
        """Use other functions from the next call on; `owner` keeps their code alive."""
        if addresses == (*self.cell,):
            return
        self._owners.append(owner)
        for words in self._words:
            words[:2] = addresses

    def bind(self, words: np.ndarray) -> None:
        """Keep the first two words of an array as the cell."""
        self._words.append(words)
        words[:2] = self.cell


def _improve(known: ref[Entry], tiers: Tiers, compile_source: Compile) -> None:
    """Compile at LLVM's best and put the result in the entry's place, if it is still there."""
    code = tiers.best(compile_source)
    entry = known()
    if entry is not None:
        entry.improve(code)


def tiers_of(program: Program | Tangent) -> Tiers:
    """Return the code of a Program or Tangent for one state."""
    if isinstance(program, Tangent):
        return Tiers(_source(program, 1, 1), _calls(program, 1))
    short = None
    if len(program.without_fallbacks()) < MOST_WITHOUT_FALLBACKS * len(program.ops):
        name = f"kernel {program.digest} without fallbacks"
        short = Source(name, _Text(program, 1, 1, fallbacks=False), ("kernel", "prepare"))
    return Tiers(_source(program, 1, 1, loops=_repeats(program)), _calls(program, 1), short)


@dataclass(frozen=True)
class _Text:
    """The IR of a Program or Tangent; pickled as bytes that are written in a sixth of the time."""

    program: Program | Tangent
    lanes: int
    width: int
    fallbacks: bool = True

    @collector_paused()
    def __call__(self, brief: bool) -> str:
        if isinstance(self.program, Tangent):
            return tangent_text(self.program, self.lanes, brief)
        return kernel_text(self.program, self.lanes, self.width, brief, self.fallbacks)

    def __reduce__(self) -> tuple[Any, ...]:
        return _read_text, (self.program.to_bytes(), self.lanes, self.width, self.fallbacks)


def wide_code(program: Program | Tangent, lanes: int, width: int | None = None) -> jit.Code:
    """Return the best code for several states at once, compiled if need be."""
    if isinstance(program, Program):
        width = width or width_of(program, lanes)
    calls = _calls(program, width or lanes)
    routines = [shared_routines(*call, at_best=True) for call in calls]
    return jit.load(_source(program, lanes, width or lanes), routines)


def _source(program: Program | Tangent, lanes: int, width: int, loops: bool = False) -> Source:
    name, text = f"kernel {program.digest} {lanes} {width}", _Text(program, lanes, width)
    strided = lanes > 1 and isinstance(program, Program)
    return Source(name, text, ("kernel", "prepare", "strided")[: 2 + strided], loops=loops)


def _calls(program: Program | Tangent, lanes: int) -> tuple[tuple[str, int], ...]:
    """Return the shared routines that are called, with their lanes."""
    kinds = ("angles", {*ANGLES}), ("solve", SOLVES)
    parts = [(set(one.ops), own) for one, own in pieces(program, lanes)]
    called = {(kind, own) for kind, ops in kinds for found, own in parts if ops & found}
    return tuple(sorted(called))


def _read_text(program: bytes, lanes: int, width: int, fallbacks: bool) -> _Text:
    return _Text(program_from_bytes(program), lanes, width, fallbacks)


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


_ROUTINES: dict[tuple[str, int, bool], jit.Code] = {}
_ROUTINES_LOCK = _forks.Lock()


def shared_routines(
    kind: str, lanes: int, at_best: bool, compile_source: Compile = object_code
) -> jit.Code:
    """Return routines that kernels call; unless they are cached, quickly compiled will do."""
    best = _ROUTINES.get((kind, lanes, True))
    if best is not None:
        return best
    if kind == "solve":
        source = CORE.source(f"solve_{lanes}", solver_names(lanes))
    else:
        text = partial(angles_text, lanes)
        source = Source(f"angles {lanes}", text, sincos_names(lanes), loops=True)
    code: jit.Code | None
    if not at_best:
        code = jit.find(source)
    elif compile_source is object_code:
        with _ROUTINES_LOCK:  # whoever comes second finds what the first one compiled
            code = jit.load(source)
    else:
        code = jit.load(source, (), compile_source)
    if code is not None:
        return _ROUTINES.setdefault((kind, lanes, True), code)
    quick = _ROUTINES.get((kind, lanes, False))
    if quick is None:
        quick = _ROUTINES[kind, lanes, False] = jit.load_quickly(source)
    return quick
