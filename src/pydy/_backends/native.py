"""What every native kernel needs around it: a sweep over many states, and a gate from Python.

Both are written once in LLVM IR and take a kernel by its address, so a model compiles nothing but
its own equations. The *gate* is a C function of Python's own interface: for arguments that are
already float64 arrays of the right length it costs about a tenth of a microsecond, where ctypes
alone would cost ten times as much. It reads three fields of NumPy's array object, whose layout is
part of NumPy's published binary interface (PyArrayObject in ndarrayobject.h)::

    16 data    24 ndim    32 shape    56 descr    64 flags

What a kernel is, and the binding of its constants, lies in an array of 64-bit words::

    0 kernel   1 prepare   2 n   3 s   4 k   5 carried   6 outputs   7 bound   8… p   8+k… c
"""

from __future__ import annotations

import ctypes
import sysconfig
from collections.abc import Callable
from functools import cache, partial
from typing import Any

import numpy as np

from pydy._backends import jit
from pydy._backends.background import Task, submit
from pydy._backends.base import strict
from pydy._backends.ir import Function
from pydy._graph.program import Program
from pydy._kernel import Kernel

__all__ = ["Entry", "native_kernel"]

_HEADER = 8


class Entry:
    """The native functions of a Program, which better ones may replace at any time.

    Parameters
    ----------
    addresses : (int, int)
        Of `kernel` and `prepare`.
    owner : object
        Keeps their code alive.
    """

    def __init__(self, addresses: tuple[int, int], owner: Any) -> None:
        self.addresses = addresses
        self.better: Task | None = None
        self._owners = [owner]  # a call may be under way in the old code: it stays
        self._words: np.ndarray | None = None

    def replace(self, addresses: tuple[int, int], owner: Any) -> None:
        """Use other functions from the next call on."""
        self._owners.append(owner)
        self.addresses = addresses
        if self._words is not None:
            self._words[:2] = addresses

    def bind(self, words: np.ndarray) -> None:
        """Keep the first two words of a gate's array up to date."""
        self._words = words
        words[:2] = self.addresses

    def settled(self) -> tuple[int, int]:
        """Return the addresses of the best code, compiling it now if need be."""
        if self.better is not None:
            self.better.run()
        return self.addresses


def native_kernel(
    program: Program,
    entry: Entry,
    lanes: int,
    rebuild: Callable[..., Kernel],
    recipe: tuple[Any, ...],
) -> Kernel:
    """Wrap native functions of the package's signature as a Kernel."""
    runtime = _runtime()
    sweep = _make_sweep(program, entry, lanes, runtime)
    call = _make_call(program, entry, lanes, sweep, runtime)
    return Kernel(program, sweep, call, rebuild, recipe, entry.settled, lanes, (entry, runtime))


def _text() -> str:
    return _sweep_text() + _gate_text()


def _compile_for_later(source: jit.Source) -> None:
    jit.load(source)


class _Runtime:
    def __init__(self) -> None:
        source = jit.Source("runtime", _text, ("sweep", "gate"), loops=True)
        code = jit.find(source)
        if code is None:
            # For the next process; this one goes on with what is there at once.
            submit(Task(partial(_compile_for_later, source)))
            code = jit.load_quickly(source)
        self.code = code
        prototype = ctypes.CFUNCTYPE(ctypes.c_int64, *[ctypes.c_void_p] * 2, ctypes.c_int64)
        self.sweep = prototype(self.code.addresses["sweep"])
        self.gate_name = b"native_call"
        # struct PyMethodDef: name, function, flags (METH_FASTCALL), doc
        self.definition = (ctypes.c_void_p * 4)(
            ctypes.cast(ctypes.c_char_p(self.gate_name), ctypes.c_void_p).value,
            self.code.addresses["gate"],
            0x0080,
            None,
        )


@cache
def _runtime() -> _Runtime:
    return _Runtime()


_PREPARE = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p)


def _make_sweep(
    program: Program, entry: Entry, lanes: int, runtime: _Runtime
) -> Callable[..., tuple[np.ndarray, np.ndarray]]:
    n, s = program.num_states, program.num_specifieds
    carried, outputs = len(program.carried), len(program.outputs)

    def sweep(
        t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        m = len(t)
        kernel, prepare = entry.addresses
        constants = np.repeat(p, lanes)
        c = np.empty(carried * lanes)
        _PREPARE(prepare)(constants.ctypes.data, c.ctypes.data)
        out = np.empty((m, outputs))
        failed = np.zeros(m, dtype=np.bool_)
        scratch = np.empty((n + s + 1 + outputs) * lanes)
        arrays = (t, x, r, c, out, failed, scratch)
        words = [kernel, lanes, n, s, outputs, 0 if len(r) == 1 else s]
        words += [a.ctypes.data for a in arrays]
        table = np.array(words, dtype=np.uint64)
        runtime.sweep(table.ctypes.data, None, m)
        return out, failed

    return sweep


def _sweep_text() -> str:
    """IR of sweep(table, unused, m): gather `lanes` states, call the kernel, scatter."""
    f = Function("sweep", "i64", "ptr %w, ptr %unused, i64 %m", "|nounwind")
    words = [f.load("i64", "%w", str(k)) for k in range(6)]
    kernel = f.let(f"inttoptr i64 {words[0]} to ptr")
    lanes, n, s, outputs, r_step = words[1:]
    t, x, r, c, out, failed, scratch = (f.load("ptr", "%w", str(k)) for k in range(6, 13))
    last = f.let("sub i64 %m, 1")
    xs = scratch
    rs = f.at(xs, f.let(f"mul i64 {n}, {lanes}"))
    ts = f.at(rs, f.let(f"mul i64 {s}, {lanes}"))
    outs = f.at(ts, lanes)
    with f.loop("0", "%m", lanes) as start:
        with f.loop("0", lanes) as lane:
            # The last block is filled up with copies of the last sample.
            place = f.let(f"add i64 {start}, {lane}")
            beyond = f.let(f"icmp sgt i64 {place}, {last}")
            i = f.let(f"select i1 {beyond}, i64 {last}, i64 {place}")
            f.store("double", f.load("double", t, i), ts, lane)
            row = f.at(x, f.let(f"mul i64 {i}, {n}"))
            with f.loop("0", n) as j:
                cell = f.let(f"add i64 {f.let(f'mul i64 {j}, {lanes}')}, {lane}")
                f.store("double", f.load("double", row, j), xs, cell)
            row = f.at(r, f.let(f"mul i64 {i}, {r_step}"))
            with f.loop("0", s) as j:
                cell = f.let(f"add i64 {f.let(f'mul i64 {j}, {lanes}')}, {lane}")
                f.store("double", f.load("double", row, j), rs, cell)
        status = f.let(f"call i32 {kernel}(ptr {ts}, ptr {xs}, ptr {rs}, ptr {c}, ptr {outs})")
        with f.loop("0", lanes) as lane:
            i = f.let(f"add i64 {start}, {lane}")
            with f.when(f.let(f"icmp sle i64 {i}, {last}")):
                row = f.at(out, f.let(f"mul i64 {i}, {outputs}"))
                with f.loop("0", outputs) as j:
                    cell = f.let(f"add i64 {f.let(f'mul i64 {j}, {lanes}')}, {lane}")
                    f.store("double", f.load("double", outs, cell), row, j)
                shift = f.let(f"trunc i64 {lane} to i32")
                bit = f.let(f"and i32 {f.let(f'lshr i32 {status}, {shift}')}, 1")
                f.store("i8", f.let(f"trunc i32 {bit} to i8"), failed, i)
    f.do("ret i64 0")
    return f.text()


def _make_call(
    program: Program,
    entry: Entry,
    lanes: int,
    sweep: Callable[..., tuple[np.ndarray, np.ndarray]],
    runtime: _Runtime,
) -> Callable[..., int]:
    if lanes == 1 and not sysconfig.get_config_var("Py_GIL_DISABLED"):
        words = np.zeros(_HEADER + program.num_constants + len(program.carried), dtype=np.int64)
        words[2:7] = [
            program.num_states,
            program.num_specifieds,
            program.num_constants,
            len(program.carried),
            len(program.outputs),
        ]
        entry.bind(words)
        make = ctypes.pythonapi.PyCFunction_NewEx
        make.restype = ctypes.py_object
        make.argtypes = [ctypes.c_void_p, ctypes.py_object, ctypes.c_void_p]
        gate: Callable[..., int] = make(ctypes.addressof(runtime.definition), words, None)
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
        need(f.let(f"icmp eq ptr {field(value, 8, 'ptr')}, {kind}"))
        need(f.let(f"icmp eq ptr {field(value, 56, 'ptr')}, {descr}"))
        need(f.let(f"icmp eq i32 {field(value, 24, 'i32')}, 1"))
        flags = f.let(f"and i32 {field(value, 64, 'i32')}, {0x0101}")  # contiguous, aligned
        need(f.let(f"icmp eq i32 {flags}, {0x0101}"))
        need(f.let(f"icmp eq i64 {f.load('i64', field(value, 32, 'ptr'))}, {size}"))
        return field(value, 16, "ptr")

    need(f.let("icmp eq i64 %count, 5"))
    words = field("%self", 16, "ptr")
    kernel, prepare = f.load("ptr", words), f.load("ptr", words, "1")
    n, s, k = (f.load("i64", words, str(j)) for j in (2, 3, 4))
    x, t, r, p, out = (f.load("ptr", "%args", str(j)) for j in range(5))
    kind, descr = field(out, 8, "ptr"), field(out, 56, "ptr")  # our own np.empty: the pattern
    x_data = array(x, kind, descr, n)
    need(f.let(f"icmp eq ptr {field(t, 8, 'ptr')}, @PyFloat_Type"))
    t_slot = f.variable("double", field(t, 16, "double"))
    r_data = array(r, kind, descr, s)
    p_data = array(p, kind, descr, k)
    out_data = field(out, 16, "ptr")
    p_bound = f.at(words, str(_HEADER), "i64")
    c = f.at(p_bound, k, "i64")
    size = f.let(f"mul i64 {k}, 8")
    same = f.let(
        f"icmp eq i32 {f.let(f'call i32 @memcmp(ptr {p_bound}, ptr {p_data}, i64 {size})')}, 0"
    )
    bound = f.let(f"icmp ne i64 {f.load('i64', words, '7')}, 0")
    current = f.let(f"and i1 {same}, {bound}")
    with f.when(f.let(f"xor i1 {current}, true")):
        f.let(f"call ptr @memcpy(ptr {p_bound}, ptr {p_data}, i64 {size})")
        f.do(f"call void {prepare}(ptr {p_bound}, ptr {c})")
        f.store("i64", "1", words, "7")
    status = f.let(
        f"call i32 {kernel}(ptr {t_slot}, ptr {x_data}, ptr {r_data}, ptr {c}, ptr {out_data})"
    )
    wide = f.let(f"zext i32 {status} to i64")
    f.do(f"ret ptr {f.let(f'call ptr @PyLong_FromLong(i64 {wide})')}")
    f.label(slow)
    f.do(f"ret ptr {f.let('call ptr @PyLong_FromLong(i64 -1)')}")
    declarations = [
        "@PyFloat_Type = external global i8",
        "declare ptr @PyLong_FromLong(i64)",
        "declare i32 @memcmp(ptr, ptr, i64)",
        "declare ptr @memcpy(ptr, ptr, i64)",
        "",
    ]
    return "\n".join(declarations) + f.text()
