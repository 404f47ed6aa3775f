"""What every native kernel needs around it: a sweep over many states, and a gate from Python.

Both are written once in LLVM IR and take a kernel by its address, so a model compiles nothing but
its own equations. Sweeps are in `sweep`. The *gate* is a C function of Python's own interface:
for arguments that are already float64 arrays of the right length it costs about a tenth of a
microsecond, where ctypes alone would cost ten times as much. It reads NumPy's array object at the
offsets of `_array_layout`; where those do not hold, ctypes does it after all.

What a kernel is, and the binding of its constants, lies in an array of 64-bit words::

    0 kernel   1 prepare   2 n   3 s   4 k   5 carried   6 outputs   7 bound   8… p   8+k… c

`bound` is the `prepare` that gave c of p, or 0.
"""

from __future__ import annotations

import ctypes
import sysconfig
from collections.abc import Callable
from enum import Enum
from functools import cache, partial
from typing import Any, Literal, Protocol
from weakref import ref

import numpy as np

from pydy import _array_layout, _cache_folder, _forks
from pydy._array_layout import DATA, DESCR, FLAGS, FLOAT, KIND, NDIM, SHAPE
from pydy._backends.base import strict
from pydy._backends.llvm import background, jit
from pydy._backends.llvm.background import Compile, Task
from pydy._backends.llvm.compiling import object_code
from pydy._backends.llvm.gate import Gate
from pydy._backends.llvm.ir import Function
from pydy._backends.llvm.sweep import (
    ARRAYS,
    KERNEL_WORDS,
    SWEEP_GATE,
    row_sweep_function,
    scratch_size,
    sweep_gate_function,
    sweep_module,
    sweep_name,
)
from pydy._backends.tuning import SWEPT
from pydy._graph.program import Program
from pydy._kernel import Kernel

__all__ = ["Entry", "Quality", "Tiers", "native_kernel"]

_HEADER = 8


class Quality(Enum):
    """What native functions are like.

    Short ones give the status -1 where a guard is not sound: they have no fallbacks.
    """

    SHORT, COMPLETE, BEST = range(3)


class Tiers(Protocol):
    """How the native functions of a Program are compiled: quickly, and at LLVM's best."""

    def at_hand(self) -> tuple[jit.Code, Quality]:
        """Return what is ready soonest."""

    def complete(self) -> jit.Code:
        """Return code with all fallbacks, compiled quickly."""

    def best(self, compile_source: Compile) -> jit.Code:
        """Return the best code, compiled by the given function unless there is some."""


class Entry:
    """The native functions of a Program, `kernel` and `prepare`.

    They are made when they are first wanted; better ones may replace them at any time. Who wants
    the best from the beginning waits for that alone.

    Parameters
    ----------
    tiers : Tiers or None
        None where the functions are given by `replace` at once.
    """

    def __init__(self, tiers: Tiers | None = None) -> None:
        self._tiers = tiers
        self._lock = _forks.Lock()
        self.addresses = 0, 0
        self.short = False
        self.better: Task | None = None
        self._owners: list[Any] = []  # a call may be under way in the old code: it stays
        self._words: list[np.ndarray] = []

    def begin(self) -> None:
        """Have some code, and better code compiled on the side."""
        if self.addresses[0]:
            return
        with self._lock:
            if self.addresses[0] or self._tiers is None:
                return
            code, quality = self._tiers.at_hand()
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

    def improve(self, code: jit.Code) -> None:
        """Use the best code from now on."""
        with self._lock:
            self._use(code)
            self.short = False

    def settled(self) -> tuple[int, int]:
        """Return the addresses of the best code, compiling it now if need be."""
        if not self.addresses[0]:
            with self._lock:
                if not self.addresses[0] and self._tiers is not None:
                    self._use(self._tiers.best(object_code))
        if self.better is not None:
            self.better.run()
        return self.addresses

    def _use(self, code: jit.Code) -> None:
        self.replace((code.addresses["kernel"], code.addresses["prepare"]), code)

    def replace(self, addresses: tuple[int, int], owner: Any) -> None:
        """Use other functions from the next call on; `owner` keeps their code alive."""
        if addresses == self.addresses:
            return
        self._owners.append(owner)
        self.addresses = addresses
        for words in self._words:
            words[:2] = addresses

    def bind(self, words: np.ndarray) -> None:
        """Keep the first two words of an array up to date."""
        self._words.append(words)
        words[:2] = self.addresses


def _improve(known: ref[Entry], tiers: Tiers, compile_source: Compile) -> None:
    """Compile at LLVM's best and put the result in the entry's place, if it is still there."""
    code = tiers.best(compile_source)
    entry = known()
    if entry is not None:
        entry.improve(code)


def native_kernel(
    program: Program,
    entry: Entry,
    lanes: int,
    rebuild: Callable[..., Kernel],
    recipe: tuple[Any, ...],
    strided: int = 0,
) -> Kernel:
    """Wrap native functions of the package's signature as a Kernel.

    `strided` is the address of the form that takes items at any distance; see `sweep`.
    """
    runtime = _runtime()
    sweep = _make_sweep(program, entry, lanes, strided, runtime)
    call = _make_call(program, entry, lanes, sweep, runtime)
    owner, settled = (entry, runtime), entry.settled
    return Kernel(program, sweep, call, rebuild, recipe, settled, lanes, owner, entry.begin)


def _text(brief: bool) -> str:
    return row_sweep_function() + sweep_gate_function() + _gate_text()


def _keep(source: jit.Source, compile_source: Compile) -> None:
    """Compile for the next process; this one goes on with what is there at once."""
    _cache_folder.write(source.key, compile_source(source))


class _Runtime:
    def __init__(self) -> None:
        names = (sweep_name(1), SWEEP_GATE, "gate")
        source = jit.Source("runtime", _text, names, loops=True)
        self.better: Task | None = None
        code = jit.find(source)
        if code is None:
            if _cache_folder.folder() is not None:
                self.better = Task(partial(_keep, source))
                background.submit(self.better)
            code = jit.load_quickly(source)
        self.code = code
        self.gate = Gate(b"native_call", code, "gate")
        self._sweep = Gate(b"native_sweep", code, SWEEP_GATE)
        gate: Callable[..., None] = self._sweep.function(None)
        self.sweep = gate if _array_layout.FITS else _careful_sweep


_SWEEP = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * (1 + len(ARRAYS)))


def _careful_sweep(words: np.ndarray, *arrays: np.ndarray) -> None:
    """Do what the sweep's gate does, without a look into NumPy's objects."""
    t, x, r = arrays[:3]
    r_step = r.shape[1] if len(r) > 1 else 0
    by_columns = x.flags.f_contiguous and not x.flags.c_contiguous
    words = np.array([*words, len(t), r_step, by_columns], np.int64)
    _SWEEP(int(words[3]))(*(array.ctypes.data for array in (words, *arrays)))


@cache
def _runtime() -> _Runtime:
    return _Runtime()


def _make_sweep(
    program: Program, entry: Entry, lanes: int, strided: int, runtime: _Runtime
) -> Callable[..., tuple[np.ndarray, np.ndarray]]:
    n, s, outputs = program.num_states, program.num_specifieds, len(program.outputs)
    sizes = (n, s, program.num_constants, len(program.carried), outputs)
    native = runtime.code.addresses[sweep_name(1)] if lanes == 1 else _wide_sweep(lanes)
    room = scratch_size(lanes, *sizes)
    run, columns = runtime.sweep, lanes > 1
    most = max(1, SWEPT // (lanes * (program.num_operations + 1))) * lanes
    words = np.array([0, 0, strided, native, *sizes], np.int64)
    assert len(words) == len(KERNEL_WORDS)
    entry.bind(words)

    def part(
        t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray, out: np.ndarray | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        m = len(t)
        order: Literal["C", "F"] = "C"
        if columns and m > 1 and n > 1 and x.flags.f_contiguous:
            order, r = "F", np.asfortranarray(r)
        else:
            x, r = np.ascontiguousarray(x), np.ascontiguousarray(r)
        values = np.empty((m, outputs), order=order) if out is None else out
        failed = np.zeros(m, dtype=np.bool_)
        short = entry.short
        run(words, t, x, r, p, values, failed, np.empty(room))
        if short and failed.any():
            entry.complete()
            failed[:] = False
            run(words, t, x, r, p, values, failed, np.empty(room))
        return values, failed

    def sweep(
        t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray, out: np.ndarray | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        entry.begin()
        m = len(t)
        if m <= most:
            return part(t, x, r, p, out)
        # Python heeds a Ctrl-C between the parts.
        by_columns = columns and n > 1 and x.flags.f_contiguous and out is None
        values = np.empty((m, outputs), order="F" if by_columns else "C") if out is None else out
        failed = np.empty(m, dtype=np.bool_)
        for first in range(0, m, most):
            rows = slice(first, first + most)
            x_part = np.asfortranarray(x[rows]) if by_columns else x[rows]
            values[rows], failed[rows] = part(t[rows], x_part, r if len(r) == 1 else r[rows], p)
        return values, failed

    return sweep


def _sweep_text(lanes: int, brief: bool) -> str:
    return sweep_module(lanes)


_WIDE: dict[int, jit.Code] = {}


def _wide_sweep(lanes: int) -> int:
    if lanes not in _WIDE:
        name = sweep_name(lanes)
        source = jit.Source(f"sweep {lanes}", partial(_sweep_text, lanes), (name,), True)
        _WIDE[lanes] = jit.load(source)
    return _WIDE[lanes].addresses[sweep_name(lanes)]


def _make_call(
    program: Program,
    entry: Entry,
    lanes: int,
    sweep: Callable[..., tuple[np.ndarray, np.ndarray]],
    runtime: _Runtime,
) -> Callable[..., int]:
    if lanes == 1 and _array_layout.FITS and not sysconfig.get_config_var("Py_GIL_DISABLED"):
        words = np.zeros(_HEADER + program.num_constants + len(program.carried), dtype=np.int64)
        words[2:7] = [
            program.num_states,
            program.num_specifieds,
            program.num_constants,
            len(program.carried),
            len(program.outputs),
        ]
        entry.bind(words)
        gate: Callable[..., int] = runtime.gate.function(words)
        return gate

    # Without the interpreter's lock the gate's shared binding of constants would be a race.
    def call(x: Any, t: Any, r: Any, p: Any, out: np.ndarray) -> int:
        if type(t) is not float or not strict(program, x, r, p):
            return -1
        values, failed = sweep(np.array([t], float), x[None, :], r[None, :], p)
        out[:] = values[0]
        return int(failed[0])

    return call


def _gate_text() -> str:
    """IR of gate(self, args, count): native_call(x, t, r, p, out) -> int."""
    f = Function("gate", "ptr", "ptr %self, ptr %args, i64 %count", "|nounwind")
    slow = "%slow"

    def need(condition: str) -> None:
        ok = f.name("ok")
        f.do(f"br i1 {condition}, label {ok}, label {slow}")
        f.label(ok)

    def field(pointer: str, offset: int, kind: str) -> str:
        return f.load(kind, f.at(pointer, str(offset), "i8"))

    def array(value: str, kind: str, descr: str, size: str) -> str:
        """Return the data of a float64 vector of that size, or leave by the slow exit."""
        need(f.let(f"icmp eq ptr {field(value, KIND, 'ptr')}, {kind}"))
        need(f.let(f"icmp eq ptr {field(value, DESCR, 'ptr')}, {descr}"))
        need(f.let(f"icmp eq i32 {field(value, NDIM, 'i32')}, 1"))
        flags = f.let(f"and i32 {field(value, FLAGS, 'i32')}, {0x0101}")  # contiguous, aligned
        need(f.let(f"icmp eq i32 {flags}, {0x0101}"))
        need(f.let(f"icmp eq i64 {f.load('i64', field(value, SHAPE, 'ptr'))}, {size}"))
        return field(value, DATA, "ptr")

    need(f.let("icmp eq i64 %count, 5"))
    words = field("%self", DATA, "ptr")
    kernel, prepare = f.load("ptr", words), f.load("ptr", words, "1")
    need(f.let(f"icmp ne ptr {kernel}, null"))  # nothing is compiled yet
    n, s, k = (f.load("i64", words, str(j)) for j in (2, 3, 4))
    x, t, r, p, out = (f.load("ptr", "%args", str(j)) for j in range(5))
    kind, descr = field(out, KIND, "ptr"), field(out, DESCR, "ptr")  # our own np.empty: the pattern
    x_data = array(x, kind, descr, n)
    need(f.let(f"icmp eq ptr {field(t, KIND, 'ptr')}, @PyFloat_Type"))
    t_slot = f.variable("double", field(t, FLOAT, "double"))
    r_data = array(r, kind, descr, s)
    p_data = array(p, kind, descr, k)
    out_data = field(out, DATA, "ptr")
    p_bound = f.at(words, str(_HEADER), "i64")
    c = f.at(p_bound, k, "i64")
    size = f.let(f"mul i64 {k}, 8")
    same = f.let(
        f"icmp eq i32 {f.let(f'call i32 @memcmp(ptr {p_bound}, ptr {p_data}, i64 {size})')}, 0"
    )
    bound = f.let(f"icmp eq ptr {f.load('ptr', words, '7')}, {prepare}")
    current = f.let(f"and i1 {same}, {bound}")
    with f.when(f.let(f"xor i1 {current}, true")):
        f.let(f"call ptr @memcpy(ptr {p_bound}, ptr {p_data}, i64 {size})")
        f.do(f"call void {prepare}(ptr {p_bound}, ptr {c})")
        f.store("ptr", prepare, words, "7")
    status = f.let(
        f"call i32 {kernel}(ptr {t_slot}, ptr {x_data}, ptr {r_data}, ptr {c}, ptr {out_data})"
    )
    wide = f.let(f"sext i32 {status} to i64")
    f.do(f"ret ptr {f.let(f'call ptr @PyLong_FromLongLong(i64 {wide})')}")
    f.label(slow)
    f.do(f"ret ptr {f.let('call ptr @PyLong_FromLongLong(i64 -1)')}")
    declarations = [
        "@PyFloat_Type = external global i8",
        "declare ptr @PyLong_FromLongLong(i64)",
        "declare i32 @memcmp(ptr, ptr, i64)",
        "declare ptr @memcpy(ptr, ptr, i64)",
        "",
    ]
    return "\n".join(declarations) + f.text()
