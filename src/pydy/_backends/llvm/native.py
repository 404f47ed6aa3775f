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
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache, partial
from typing import Any, Literal, cast

import numpy as np

from pydy import _array_layout, _cache_folder
from pydy._array_layout import DATA, DESCR, FLAGS, FLOAT, KIND, NDIM, SHAPE
from pydy._backends.base import strict
from pydy._backends.llvm import background, jit
from pydy._backends.llvm.background import Compile, Task
from pydy._backends.llvm.compiling import Source
from pydy._backends.llvm.gate import Gate
from pydy._backends.llvm.ir import Function, vector_type
from pydy._backends.llvm.tiers import Entry
from pydy._backends.tuning import SWEPT
from pydy._graph.program import Program
from pydy._graph.tangent import Tangent
from pydy._kernel import Kernel

# -- Sweeps over many states in LLVM IR: how samples reach a kernel's lanes and results come back --
# A kernel takes a state as ``[item][lane]``. With one lane that is a row of an ordinary (m, n)
# array, which is passed as it lies. With more lanes, an array whose columns are contiguous is
# passed as it lies too, to the kernel's strided form; one whose rows are contiguous is turned
# four columns at a time in registers::
#
# row 0 | a0 a1 a2 a3 a0 b0 c0 d0 … column 0 row 1 | b0 b1 b2 b3 → a1 b1 c1 d1 … column 1 row 2 |
# c0 c1 c2 c3 a2 b2 c2 d2 … column 2 … …


SWEEP_GATE = "pydy_sweep_gate"
# What a sweep reads in an array of integers: the kernel it is for, then the arrays of this call.
# `r_step` is 0 where one row of specifieds serves all samples; `by_columns` says how x, r and out
# lie.
KERNEL_WORDS = (
    *("kernel", "prepare", "strided", "sweep"),
    *("n", "s", "k", "carried", "outputs"),
)
_WORDS = (*KERNEL_WORDS, "m", "r_step", "by_columns")
_POINTERS = KERNEL_WORDS[:4]
# The arrays that follow it.
ARRAYS = ("t", "x", "r", "p", "out", "failed", "scratch")
_PARAMETERS = ", ".join(f"ptr %{name}" for name in ("words", *ARRAYS))


def sweep_name(lanes: int) -> str:
    """Return the function that sweeps with that many lanes."""
    return f"pydy_sweep_{lanes}"


def scratch_size(lanes: int, n: int, s: int, k: int, carried: int, outputs: int) -> int:
    """Return how many numbers of scratch memory a sweep needs."""
    if lanes == 1:
        return carried
    # Columns move in blocks of up to four, whole ones; the memory's beginning is rounded up.
    return (n + s + 1 + k + carried + outputs + 12) * lanes + 8


def _word(f: Function, name: str) -> str:
    kind = "ptr" if name in _POINTERS else "i64"
    return f.load(kind, "%words", str(_WORDS.index(name)))


def _opened(f: Function) -> dict[str, str]:
    """Name what a sweep works with."""
    arrays = {name: f"%{name}" for name in ARRAYS}
    return arrays | {k: _word(f, k) for k in _WORDS}


def sweep_gate_function() -> str:
    """Return a C function of Python's interface: the sweep that a kernel's words name.

    Its arguments are NumPy arrays of the right kinds, which its caller has made; it takes their
    data, how many samples there are and how they lie, and gives up the interpreter's lock for the
    work.
    """
    f = Function(SWEEP_GATE, "ptr", "ptr %self, ptr %args, i64 %count", "|nounwind")
    names = ("words", *ARRAYS)
    arrays = {name: f.load("ptr", "%args", str(k)) for k, name in enumerate(names)}

    def field(name: str, offset: int, kind: str) -> str:
        return f.load(kind, f.at(arrays[name], str(offset), "i8"))

    data = {name: field(name, DATA, "ptr") for name in names}
    words = f.slot("i64", len(_WORDS))
    for k in range(len(KERNEL_WORDS)):
        f.store("i64", f.load("i64", data["words"], str(k)), words, str(k))
    samples, rows = (f.load("i64", field(name, SHAPE, "ptr")) for name in "tr")
    s = f.load("i64", words, str(_WORDS.index("s")))
    r_step = f.let(f"select i1 {f.let(f'icmp sgt i64 {rows}, 1')}, i64 {s}, i64 0")
    # Contiguous columns, and not contiguous rows as well.
    order = f.let(f"and i32 {field('x', FLAGS, 'i32')}, {0x0003}")
    by_columns = f.let(f"zext i1 {f.let(f'icmp eq i32 {order}, {0x0002}')} to i64")
    for name, value in (("m", samples), ("r_step", r_step), ("by_columns", by_columns)):
        f.store("i64", value, words, str(_WORDS.index(name)))
    state = f.let("call ptr @PyEval_SaveThread()")
    sweep = f.load("ptr", words, str(_WORDS.index("sweep")))
    arguments = [words, *(data[name] for name in ARRAYS)]
    f.do(f"call void {sweep}({', '.join(f'ptr {a}' for a in arguments)})")
    f.do(f"call void @PyEval_RestoreThread(ptr {state})")
    f.do(f"ret ptr {f.let('call ptr @PyLong_FromLongLong(i64 0)')}")
    return "declare ptr @PyEval_SaveThread()\ndeclare void @PyEval_RestoreThread(ptr)\n" + f.text()


def row_sweep_function() -> str:
    """Return the sweep for one lane."""
    f = Function(sweep_name(1), "void", _PARAMETERS, "|nounwind")
    w = _opened(f)
    c = w["scratch"]
    f.do(f"call void {w['prepare']}(ptr {w['p']}, ptr {c})")
    with f.loop("0", w["m"]) as i:
        t = f.at(w["t"], i)
        x = f.at(w["x"], f.let(f"mul i64 {i}, {w['n']}"))
        r = f.at(w["r"], f.let(f"mul i64 {i}, {w['r_step']}"))
        out = f.at(w["out"], f.let(f"mul i64 {i}, {w['outputs']}"))
        arguments = f"ptr {t}, ptr {x}, ptr {r}, ptr {c}, ptr {out}"
        status = f.let(f"call i32 {w['kernel']}({arguments})")
        f.store("i8", f.let(f"trunc i32 {status} to i8"), w["failed"], i)
    f.do("ret void")
    return f.text()


def sweep_module(lanes: int) -> str:
    """Return the IR module of the sweep for 2, 4 or 8 lanes."""
    c, v = _block(lanes), vector_type("double", lanes)
    rows, flags = vector_type("double", c), vector_type("i1", c)
    declarations = [
        f"declare {rows} @llvm.masked.load.v{c}f64.p0(ptr, i32, {flags}, {rows})",
        f"declare void @llvm.masked.store.v{c}f64.p0({rows}, ptr, i32, {flags})",
        "declare i64 @llvm.smin.i64(i64, i64)",
        "declare i64 @llvm.smax.i64(i64, i64)",
        "",
    ]
    f = Function(sweep_name(lanes), "void", _PARAMETERS, "|nounwind")
    w = _opened(f)
    m = w["m"]
    by_columns = f.let(f"icmp ne i64 {w['by_columns']}, 0")
    alone = f.let(f"icmp eq i64 {w['r_step']}, 0")
    # Vectors that are written and read again must not lie across two lines of the cache.
    begin = f.let(f"ptrtoint ptr {w['scratch']} to i64")
    even = f.let(f"and i64 {f.let(f'add i64 {begin}, 63')}, -64")
    free = f.let(f"inttoptr i64 {even} to ptr")
    parts = {}
    for name in ("p", "c", "t", "x", "r", "out"):
        parts[name] = free
        count = {"p": w["k"], "c": w["carried"], "t": "1", "x": w["n"], "r": w["s"]}.get(name)
        if count is not None:
            # Blocks of columns are stored whole: up to `c` - 1 items beyond the last one.
            beyond = c if name in ("x", "r") else 0
            items = f.let(f"add i64 {count}, {beyond}")
            free = f.at(free, f.let(f"mul i64 {items}, {lanes}"))
    ts, xs, rs, outs = (parts[name] for name in ("t", "x", "r", "out"))
    _splat(f, lanes, w["p"], w["k"], parts["p"])
    f.do(f"call void {w['prepare']}(ptr {parts['p']}, ptr {parts['c']})")
    with f.when(alone):
        _splat(f, lanes, w["r"], w["s"], rs)
    several = f.let(f"xor i1 {alone}, true")
    steps = f.slot("i64", 5)
    f.store("i64", m, steps)
    f.store("i64", f.let(f"select i1 {alone}, i64 {lanes}, i64 {m}"), steps, "1")
    f.store("i64", m, steps, "2")
    f.store("i64", f.let(f"select i1 {alone}, i64 0, i64 {lanes}"), steps, "4")

    def call() -> str:
        arguments = f"ptr {ts}, ptr {xs}, ptr {rs}, ptr {parts['c']}, ptr {outs}"
        return f.let(f"call i32 {w['kernel']}({arguments})")

    def report(status: str, start: str, count: str) -> None:
        with f.when(f.let(f"icmp ne i32 {status}, 0")), f.loop("0", count) as lane:
            shift = f.let(f"trunc i64 {lane} to i32")
            bit = f.let(f"and i32 {f.let(f'lshr i32 {status}, {shift}')}, 1")
            sample = f.let(f"add i64 {start}, {lane}")
            f.store("i8", f.let(f"trunc i32 {bit} to i8"), w["failed"], sample)

    whole = f.let(f"icmp sge i64 {m}, {lanes}")
    last = f.let(f"sub i64 {m}, {lanes}")

    @contextmanager
    def blocks(first: str) -> Iterator[str]:
        """Write a loop over the samples at which a block begins: 0, first, first + lanes, ... last.

        Blocks overlap, so that all are whole and most begin where they should.
        """
        rest = f.let(f"sub i64 {last}, {first}")
        rest = f.let(f"call i64 @llvm.smax.i64(i64 {rest}, i64 0)")
        more = f.let(f"sdiv i64 {f.let(f'add i64 {rest}, {2 * lanes - 1}')}, {lanes}")
        alone = f.let(f"icmp eq i64 {last}, 0")
        with f.loop(
            "0", f.let(f"select i1 {alone}, i64 1, i64 {f.let(f'add i64 {more}, 1')}")
        ) as k:
            step = f.let(f"mul i64 {f.let(f'sub i64 {k}, 1')}, {lanes}")
            place = f.let(f"add i64 {first}, {step}")
            place = f.let(f"call i64 @llvm.smin.i64(i64 {place}, i64 {last})")
            yield f.let(f"select i1 {f.let(f'icmp eq i64 {k}, 0')}, i64 0, i64 {place}")

    def sweep_columns() -> None:
        # Columns that NumPy made begin alike: the states' second block, and with it most vectors,
        # begins where a line of the cache does.
        address = f.let(f"ptrtoint ptr {w['x']} to i64")
        gone = f.let(f"and i64 {f.let(f'lshr i64 {address}, 3')}, {lanes - 1}")
        begin = f.variable("i64", "0")

        def run(start: str, count: str) -> None:
            """Evaluate up to that many blocks; the first one that fails is the last."""
            f.store("i64", count, steps, "3")
            t, x, out = (f.at(w[name], start) for name in ("t", "x", "out"))
            r = f.let(f"select i1 {alone}, ptr {rs}, ptr {f.at(w['r'], start)}")
            arguments = f"ptr {t}, ptr {x}, ptr {r}, ptr {parts['c']}, ptr {out}, ptr {steps}"
            both = f.let(f"call i64 {w['strided']}({arguments})")
            done = f.let(f"mul i64 {f.let(f'lshr i64 {both}, 32')}, {lanes}")
            end = f.let(f"add i64 {start}, {done}")
            f.set("i64", begin, end)
            latest = f.let(f"sub i64 {end}, {lanes}")
            report(f.let(f"trunc i64 {both} to i32"), latest, str(lanes))

        run("0", "1")
        with f.when(f.let(f"icmp sgt i64 {last}, 0")):
            f.set("i64", begin, f.let(f"sub i64 {lanes}, {gone}"))
        with f.repeat(lambda: f.let(f"icmp slt i64 {f.get('i64', begin)}, {m}")):
            # What is left of the last block overlaps the one before.
            start = f.let(f"call i64 @llvm.smin.i64(i64 {f.get('i64', begin)}, i64 {last})")
            run(start, f.let(f"sdiv i64 {f.let(f'sub i64 {m}, {start}')}, {lanes}"))

    def sweep_rows() -> None:
        with blocks(str(lanes)) as start:
            f.store(v, f.load(v, f.at(w["t"], start)), ts)
            _rows(f, lanes, w["x"], start, w["n"], xs, inward=True)
            with f.when(several):
                _rows(f, lanes, w["r"], start, w["s"], rs, inward=True)
            report(call(), start, str(lanes))
            _rows(f, lanes, w["out"], start, w["outputs"], outs, inward=False)

    def sweep_few() -> None:
        # Filled up with copies of the last sample, which every lane can evaluate.
        end = f.let(f"sub i64 {m}, 1")
        with f.loop("0", str(lanes)) as lane:
            i = f.let(f"call i64 @llvm.smin.i64(i64 {lane}, i64 {end})")
            f.store("double", f.load("double", w["t"], i), ts, lane)
            _one(f, lanes, m, by_columns, w["x"], i, w["n"], xs, lane, inward=True)
            with f.when(several):
                _one(f, lanes, m, by_columns, w["r"], i, w["s"], rs, lane, inward=True)
        report(call(), "0", m)
        with f.loop("0", m) as i:
            _one(f, lanes, m, by_columns, w["out"], i, w["outputs"], outs, i, inward=False)

    with f.when(f.let(f"icmp sgt i64 {m}, 0")):
        _either(f, whole, lambda: _either(f, by_columns, sweep_columns, sweep_rows), sweep_few)
    f.do("ret void")
    return "\n".join(declarations) + f.text()


def _splat(f: Function, lanes: int, numbers: str, count: str, buffer: str) -> None:
    """Write each number into all lanes."""
    v = vector_type("double", lanes)
    with f.loop("0", count) as j:
        first = f.let(f"insertelement {v} poison, double {f.load('double', numbers, j)}, i32 0")
        everywhere = f"shufflevector {v} {first}, {v} poison, <{lanes} x i32> zeroinitializer"
        f.store(v, f.let(everywhere), buffer, j)


def _block(lanes: int) -> int:
    """Return how many columns are turned at a time."""
    return min(lanes, 4)


def _either(f: Function, condition: str, yes: Callable[[], None], no: Callable[[], None]) -> None:
    """Write ``if condition: yes() else: no()``."""
    with f.when(condition):
        yes()
    with f.when(f.let(f"xor i1 {condition}, true")):
        no()


def _rows(
    f: Function, lanes: int, data: str, start: str, items: str, buffer: str, *, inward: bool
) -> None:
    """Turn rows of `items` numbers into ``[item][lane]``, or back."""
    c, v = _block(lanes), vector_type("double", lanes)
    part, flags, indices = (vector_type(kind, c) for kind in ("double", "i1", "i64"))
    load, store = (f"@llvm.masked.{kind}.v{c}f64.p0" for kind in ("load", "store"))
    first = f.at(data, f.let(f"mul i64 {start}, {items}"))
    half = f"<{c} x i32> <{', '.join(f'i32 {k}' for k in range(c))}>"
    other = f"<{c} x i32> <{', '.join(f'i32 {c + k}' for k in range(c))}>"
    both = f"<{lanes} x i32> <{', '.join(f'i32 {k}' for k in range(lanes))}>"
    with f.loop("0", items, str(c)) as j:
        left = f.let(f"sub i64 {items}, {j}")
        one = f.let(f"insertelement {indices} poison, i64 {left}, i32 0")
        spread = f"{indices} poison, <{c} x i32> zeroinitializer"
        splat = f.let(f"shufflevector {indices} {one}, {spread}")
        steps = f"<{', '.join(f'i64 {k}' for k in range(c))}>"
        mask = f.let(f"icmp slt {indices} {steps}, {splat}")
        places = []
        row = f.at(first, j)
        for lane in range(lanes):
            places.append(row)
            if lane + 1 < lanes:
                row = f.at(row, items)
        if inward:
            parts = [
                f.let(f"call {part} {load}(ptr {p}, i32 8, {flags} {mask}, {part} zeroinitializer)")
                for p in places
            ]
            wide = [
                parts[k]
                if lanes == c
                else f.let(f"shufflevector {part} {parts[k]}, {part} {parts[k + c]}, {both}")
                for k in range(c)
            ]
            for k, column in enumerate(_turned(f, lanes, wide)):
                f.store(v, column, buffer, f.let(f"add i64 {j}, {k}"))
        else:
            wide = [f.load(v, buffer, f.let(f"add i64 {j}, {k}")) for k in range(c)]
            wide = _turned(f, lanes, wide)
            parts = wide
            if lanes > c:
                parts = [
                    f.let(f"shufflevector {v} {x}, {v} poison, {which}")
                    for which in (half, other)
                    for x in wide
                ]
            for p, value in zip(places, parts, strict=True):
                f.do(f"call void {store}({part} {value}, ptr {p}, i32 8, {flags} {mask})")


def _turned(f: Function, lanes: int, rows: list[str]) -> list[str]:
    """Transpose the blocks of as many columns as there are rows, in every half alike."""
    c, v = len(rows), vector_type("double", lanes)

    def mixed(a: str, b: str, group: int, upper: bool) -> str:
        """Take groups of places in turn from a and b: the lower or the upper ones."""
        picks: list[int] = []
        for base in range(0, lanes, 2 * group):
            begin = base + group * upper
            picks += range(begin, begin + group)
            picks += range(lanes + begin, lanes + begin + group)
        text = ", ".join(f"i32 {k}" for k in picks)
        return f.let(f"shufflevector {v} {a}, {v} {b}, <{lanes} x i32> <{text}>")

    if c == 2:
        return [mixed(rows[0], rows[1], 1, upper) for upper in (False, True)]
    low = [mixed(rows[k], rows[k + 1], 1, upper) for k in (0, 2) for upper in (False, True)]
    return [mixed(low[k], low[k + 2], 2, upper) for upper in (False, True) for k in (0, 1)]


def _one(
    f: Function,
    lanes: int,
    m: str,
    by_columns: str,
    data: str,
    i: str,
    items: str,
    buffer: str,
    lane: str,
    *,
    inward: bool,
) -> None:
    """Copy one sample between an array and its lane."""
    row = f.let(f"mul i64 {i}, {items}")
    begin = f.let(f"select i1 {by_columns}, i64 {i}, i64 {row}")
    step = f.let(f"select i1 {by_columns}, i64 {m}, i64 1")
    with f.loop("0", items) as j:
        place = f.let(f"add i64 {begin}, {f.let(f'mul i64 {j}, {step}')}")
        cell = f.let(f"add i64 {f.let(f'mul i64 {j}, {lanes}')}, {lane}")
        if inward:
            f.store("double", f.load("double", data, place), buffer, cell)
        else:
            f.store("double", f.load("double", buffer, cell), data, place)


# -- The kernel ------------------------------------------------------------------------------------


_HEADER = 8


def native_kernel(
    program: Program | Tangent,
    entry: Entry,
    lanes: int,
    rebuild: Callable[..., Kernel],
    recipe: tuple[Any, ...],
    strided: int = 0,
) -> Kernel:
    """Wrap native functions of the package's signature as a Kernel.

    `strided` is the address of the form that takes items at any distance, if there is one.
    """
    runtime = _runtime()
    sweep = _make_sweep(program, entry, lanes, strided, runtime)
    call = _make_call(program, entry, lanes, sweep, runtime)
    owner, settled = (entry, runtime), entry.settled
    own = cast("Program", program)
    return Kernel(own, sweep, call, rebuild, recipe, settled, lanes, owner, entry.begin)


def _text(brief: bool) -> str:
    return row_sweep_function() + sweep_gate_function() + _gate_text()


def _keep(source: Source, compile_source: Compile) -> None:
    """Compile for the next process; this one goes on with what is there at once."""
    _cache_folder.write(source.key, compile_source(source))


class _Runtime:
    def __init__(self) -> None:
        names = (sweep_name(1), SWEEP_GATE, "gate")
        source = Source("runtime", _text, names, loops=True)
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
    program: Program | Tangent, entry: Entry, lanes: int, strided: int, runtime: _Runtime
) -> Callable[..., tuple[np.ndarray, np.ndarray]]:
    n, s, outputs = program.num_states, program.num_specifieds, len(program.outputs)
    sizes = (n, s, program.num_constants, len(program.carried), outputs)
    native = runtime.code.addresses[sweep_name(1)] if lanes == 1 else _wide_sweep(lanes)
    room = scratch_size(lanes, *sizes)
    run, columns = runtime.sweep, strided != 0
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
        if not entry.addresses[0]:
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
        source = Source(f"sweep {lanes}", partial(_sweep_text, lanes), (name,), True)
        _WIDE[lanes] = jit.load(source)
    return _WIDE[lanes].addresses[sweep_name(lanes)]


def _make_call(
    program: Program | Tangent,
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
        if type(t) is not float or not strict(cast("Program", program), x, r, p):
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
