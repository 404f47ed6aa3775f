"""Sensitivities in vector registers: the columns of a `SplitProgram` side by side.

The shared part is a kernel like any other. That of the columns takes eight of them, or fewer, at a
time: it reads a row of sensitivities as a vector, and each shared value as one number that it
spreads over the vector. A function that calls both has the signature of a kernel. It knows their
addresses as numbers, so that it is compiled anew in each process: it is a few lines.

Its array c holds the constants of the shared kernel, then those of each block of columns.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any, cast

import numpy as np

from pydy._array_layout import address
from pydy._backends.llvm import jit
from pydy._backends.llvm.compiling import Source
from pydy._backends.llvm.ir import WIDTHS, Function
from pydy._backends.llvm.text import kernel_text
from pydy._backends.llvm.tiers import calls_routines, shared_routines
from pydy._backends.registry import compile_program
from pydy._graph.program import Program
from pydy._graph.split import SplitProgram
from pydy._kernel import Kernel

_KERNEL = ctypes.CFUNCTYPE(ctypes.c_int32, *[ctypes.c_void_p] * 5)
_PREPARE = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 2)


def lanes_for(columns: int) -> int:
    """Return how many columns to take at a time; there must be whole blocks of so many."""
    return next(w for w in WIDTHS[1:] if w >= columns or w == WIDTHS[-1])


@dataclass(frozen=True)
class _Text:
    program: Program
    lanes: int
    columns: int

    def __call__(self, brief: bool) -> str:
        return kernel_text(self.program, self.lanes, brief=brief, columns=self.columns)


def compile_columns(split: SplitProgram) -> Kernel:
    """Return the Kernel of states and sensitivities, of whole blocks of columns."""
    shared = compile_program(split.shared, "llvm", {})
    lanes = lanes_for(split.columns)
    program = split.column
    source = Source(
        f"columns {program.digest} {lanes} {split.columns}",
        _Text(program, lanes, split.columns),
        ("kernel", "prepare"),
    )
    routines = shared_routines(lanes, at_best=True) if calls_routines(program) else None
    code = jit.load(source, routines)

    @cache
    def settled() -> tuple[int, int]:
        assert shared.addresses is not None
        own = Source(f"both {split.digest}", lambda brief: text, ("kernel", "prepare"))
        text = _both(split, lanes, shared.addresses, code)
        both = jit.load_quickly(own)
        keep.append(both)
        return both.addresses["kernel"], both.addresses["prepare"]

    keep: list[Any] = [shared, code]
    sweep = _sweep(split, settled)

    def call(x: Any, t: Any, r: Any, p: Any, out: np.ndarray) -> int:
        arrays = np.atleast_1d(np.asarray(t, dtype=float)), x[None], r[None], p
        values, failed = sweep(*arrays)
        out[:] = values[0]
        return int(failed[0])

    program_like = cast("Program", split)
    return Kernel(program_like, sweep, call, compile_columns, (), settled, 1, keep)


def _sweep(
    split: SplitProgram, settled: Callable[[], tuple[int, int]]
) -> Callable[..., tuple[np.ndarray, np.ndarray]]:
    bound: tuple[bytes, np.ndarray] = (b"", np.zeros(0))  # the latest constants, and c

    def sweep(
        t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray, out: np.ndarray | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        nonlocal bound
        kernel, prepare = settled()
        m, size = len(t), split.num_states
        t, x, r, p = (np.ascontiguousarray(a, dtype=float) for a in (t, x, r, p))
        known, c = bound
        if not c.size or known != p.tobytes():
            c = np.zeros(max(1, len(split.carried)))
            _PREPARE(prepare)(address(p), address(c))
            bound = p.tobytes(), c
        values = np.empty((m, size))
        failed = np.zeros(m, dtype=np.bool_)
        run, row = _KERNEL(kernel), 8 * r.shape[1] if len(r) > 1 else 0
        for k in range(m):
            failed[k] = run(
                address(t) + 8 * k,
                address(x) + 8 * size * k,
                address(r) + row * k,
                address(c),
                address(values) + 8 * size * k,
            )
        if out is None:
            return values, failed
        out[:] = values
        return out, failed

    return sweep


def _both(split: SplitProgram, lanes: int, shared: tuple[int, int], code: jit.Code) -> str:
    """Return the functions that call the kernels of the shared part and of the columns."""
    n, columns = split.shared.num_states, split.columns
    blocks, room = columns // lanes, len(split.shared.outputs)
    own, part = len(split.shared.carried), lanes * len(split.column.carried)
    column = code.addresses["kernel"], code.addresses["prepare"]

    def of(place: int) -> str:
        return f"inttoptr (i64 {place} to ptr)"

    names = ("t", "x", "r", "c", "out")
    f = Function("kernel", "i32", ", ".join(f"ptr %{name}" for name in names), "|nounwind")
    values = f.slot("<8 x double>", -(-room // 8))
    status = f.let(f"call i32 {of(shared[0])}(ptr %t, ptr %x, ptr %r, ptr %c, ptr {values})")
    f.do(f"call void @llvm.memcpy.p0.p0.i64(ptr %out, ptr {values}, i64 {8 * n}, i1 false)")
    after = f.at(values, str(n))
    for block in range(blocks):
        start = str(n + block * lanes)
        bad = f.let(
            f"call i32 {of(column[0])}(ptr %t, ptr {f.at('%x', start)}, ptr {after}, "
            f"ptr {f.at('%c', str(own + block * part))}, ptr {f.at('%out', start)})"
        )
        status = f.let(f"or i32 {status}, {bad}")
    f.do(f"ret i32 {status}")
    g = Function("prepare", "void", "ptr %p, ptr %c", "|nounwind")
    g.do(f"call void {of(shared[1])}(ptr %p, ptr %c)")
    lines = []
    for block in range(blocks):
        numbers = split.directions[:, block * lanes : (block + 1) * lanes].ravel().tolist()
        if not numbers:
            continue
        items = ", ".join(f"double {number!r}" for number in numbers)
        lines.append(f"@direction.{block} = private constant [{len(numbers)} x double] [{items}]")
        place = g.at("%c", str(own + block * part))
        g.do(f"call void {of(column[1])}(ptr @direction.{block}, ptr {place})")
    g.do("ret void")
    lines.append("declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)\n")
    return "\n".join([*lines, f.text(), g.text()])
