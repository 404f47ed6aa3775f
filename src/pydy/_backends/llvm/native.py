"""Wrap native kernels: a sweep over many states, and a gate, the entry point from Python.

Both are C in ``core``, shipped as IR, and call a kernel by its address, so that a model compiles
only its own equations. The *gate* is a C function of Python's C interface: for arguments that are
float64 arrays of the right length it costs about 0.1 µs, a tenth of a call by ctypes. It reads
NumPy's array object at the offsets of `_array_layout`; if these do not hold, ctypes is used.
"""

from __future__ import annotations

import ctypes
import sysconfig
from collections.abc import Callable
from functools import partial
from typing import Any, cast

import numpy as np

from pydy import _array_layout
from pydy._backends.base import call_of
from pydy._backends.llvm import jit
from pydy._backends.llvm.compiling import CORE
from pydy._backends.llvm.functions import LinkedFunctions
from pydy._backends.llvm.ir import WIDTHS
from pydy._backends.llvm.jit import Code
from pydy._backends.llvm.many_states import LANES, ManyStates
from pydy._backends.llvm.sources import (
    cached_wide_code,
    gains_by_lanes,
    leaves_out_fallbacks,
    wide_code,
)
from pydy._backends.llvm.text import size_with_constants
from pydy._backends.registry import compile_program
from pydy._backends.tuning import NEARBY, SWEPT, TILE
from pydy._forks import once
from pydy._kernel import Kernel, Sweep
from pydy._program import Program, Tangent

# -- Functions of Python ---------------------------------------------------------------------------

_make = ctypes.pythonapi.PyCFunction_NewEx
_make.restype = ctypes.py_object
_make.argtypes = [ctypes.c_void_p, ctypes.py_object, ctypes.py_object]


class Gate:
    """Machine code as functions that Python calls by a `name`.

    The code, kept as long as the gate or a function of it, has the `entry` ``PyObject
    *entry(PyObject *self, PyObject *const *args, Py_ssize_t count)``.
    """

    def __init__(self, name: bytes, code: Code, entry: str) -> None:
        pointer = ctypes.cast(ctypes.c_char_p(name), ctypes.c_void_p).value
        # struct PyMethodDef: name, function, METH_FASTCALL, no doc
        self._method = (ctypes.c_void_p * 4)(pointer, code.addresses[entry], 0x0080, None)
        self._needed = name, code
        self._address = ctypes.addressof(self._method)

    def function(self, owner: Any) -> Callable[..., Any]:
        """Return the function whose `self` is `owner`."""
        # What Python takes for the function's module is an object that it keeps.
        function: Callable[..., Any] = _make(self._address, owner, self)
        return function


# Numbers of words in the C structs `Words` and `Bound` before the words of one call.
_SWEEP_WORDS, _WORDS_OF_CALL, _CALL_WORDS = 11, 7, 8
_GATES = ("sweep_1", "sweep_gate", "kernel_gate", "step_gate", "call_python")
NLP = ("nlp_cost", "nlp_rows", "nlp_gradient", "nlp_jacobian", "nlp_hessian")


def _sweep_words(
    program: Program | Tangent, lanes: int, functions: list[int]
) -> tuple[np.ndarray, int]:
    """Return `Words` of ``core/kernel.h``, and how many numbers of scratch memory a sweep needs.

    The words of one call follow, zero: the gate copies all of them before it writes its own.
    """
    n, s, k, setup_values, outputs = sizes = _sizes(program, lanes)
    numbers = n + s + outputs
    blocks = min(max(TILE // lanes, 1), max(NEARBY // (lanes * max(numbers, 1)), 1))
    in_place = NEARBY // max(numbers, 1)
    words = np.array([*functions, *sizes, blocks, in_place, *[0] * _WORDS_OF_CALL], np.int64)
    # Room for its alignment.
    scratch = (numbers * blocks + 1 + k + setup_values) * lanes + 8
    return words, setup_values if lanes == 1 else scratch


def native_kernel(
    program: Program | Tangent,
    functions: LinkedFunctions,
    lanes: int,
    rebuild: Callable[..., Kernel],
    recipe: tuple[Any, ...],
    strided: int = 0,
    wide: Callable[[bool], Sweep | None] | None = None,
) -> Kernel:
    """Wrap native functions of the package's signature as a Kernel.

    `strided` is the address of the function for strided arrays, or zero. `wide` is for
    `ManyStates`.
    """
    sweep = make_sweep(program, functions, lanes, strided)
    if wide is not None:
        sweep = ManyStates(sweep, wide)
    signature, size_of_c = cast("Program", program), _size_of_c(program, lanes)
    call = _make_call(program, functions, lanes, sweep)
    return Kernel(signature, sweep, call, rebuild, recipe, lanes, functions, size_of_c)


class _Gates:
    """The gates from Python."""

    def __init__(self) -> None:
        self.code = code = jit.load(CORE.source("gates", _GATES))
        self.call = Gate(b"native_call", code, "kernel_gate")
        self.step = Gate(b"native_step", code, "step_gate")
        self._sweep = Gate(b"native_sweep", code, "sweep_gate")
        gate: Callable[..., int] = self._sweep.function(None)
        self.sweep = gate if _array_layout.FITS else _careful_sweep


_SWEEP = ctypes.CFUNCTYPE(ctypes.c_int64, *[ctypes.c_void_p] * 8)


def _careful_sweep(words: np.ndarray, *arrays: np.ndarray) -> int:
    """Call the sweep with ctypes, without reading NumPy's objects directly."""
    t, x, r, _, out = arrays[:5]
    distances = np.array([x.strides, r.strides if len(r) > 1 else (0, r.strides[1]), out.strides])
    words = np.array([*words[:_SWEEP_WORDS], len(t), *(distances // 8).flat], np.int64)
    return int(_SWEEP(int(words[3]))(*(array.ctypes.data for array in (words, *arrays))))


@once
def gates() -> _Gates:
    """Return the gates of this process."""
    return _Gates()


def _sizes(program: Program | Tangent, lanes: int) -> tuple[int, int, int, int, int]:
    """Return the numbers of states, specifieds, constants, carried values, and outputs."""
    signature = program.signature
    return *signature.sizes, _size_of_c(program, lanes), signature.num_outputs


def _size_of_c(program: Program | Tangent, lanes: int) -> int:
    """Return the size of the array c for each lane."""
    if lanes == 1 and leaves_out_fallbacks(program):
        return size_with_constants(program)
    return len(program.carried)


def make_sweep(
    program: Program | Tangent, functions: LinkedFunctions, lanes: int, strided: int
) -> Sweep:
    """Return the sweep of native functions; see `Kernel.sweep`."""
    native = gates().code.addresses["sweep_1"] if lanes == 1 else wide_sweep(lanes)
    words, scratch = _sweep_words(program, lanes, [0, 0, strided, native])
    run, outputs = gates().sweep, program.signature.num_outputs
    most = max(1, SWEPT // (lanes * (program.num_operations + 1))) * lanes
    functions.bind(words)

    def sweep(
        t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray, out: np.ndarray | None = None
    ) -> tuple[np.ndarray, np.ndarray, bool]:
        if not functions.addresses[0]:
            functions.link()
        m = len(t)
        x = x if x.flags.c_contiguous else _readable(x, lanes)
        r = r if r.flags.c_contiguous else _readable(r, lanes)
        values = np.empty((m, outputs)) if out is None else out
        failed, memory = np.zeros(m, dtype=np.bool_), np.empty(scratch)
        if m <= most:
            finite = run(words, t, x, r, p, values, failed, memory)
            return values, failed, bool(finite or np.isfinite(values).all())
        finite = 1
        # Python heeds a Ctrl-C between the parts.
        for first in range(0, m, most):
            part = slice(first, first + most)
            r_part = r if len(r) == 1 else r[part]
            finite &= run(words, t[part], x[part], r_part, p, values[part], failed[part], memory)
        return values, failed, bool(finite or np.isfinite(values).all())

    return sweep


def _readable(array: np.ndarray, lanes: int) -> np.ndarray:
    """Return an array as sweeps read it: rows are contiguous, or columns if there are lanes."""
    samples, items = array.strides
    if (items == 8 or (samples == 8 and lanes > 1)) and not (samples | items) & 7:
        return array
    return np.ascontiguousarray(array)


@once
def _wide(lanes: int) -> jit.Code:
    return jit.load(CORE.source(f"sweep_{lanes}"))


def wide_sweep(lanes: int) -> int:
    return _wide(lanes).addresses[f"sweep_{lanes}"]


@once
def nlp_functions() -> jit.Code:
    """Return the functions of nonlinear programs, ``core/nlp.c``."""
    return jit.load(CORE.source("nlp", NLP))


def sweep_by_columns(program: Program, lanes: int) -> tuple[np.ndarray, int, Any]:
    """Return the arguments of a sweep over arrays (items, samples), except the number of samples.

    That is `Words` of ``core/kernel.h``, the last seven of one call, how many numbers of scratch
    memory it needs, and what keeps the code alive.
    """
    code = wide_code(program, lanes)
    entries = [code.addresses[name] for name in ("kernel", "prepare", "strided")]
    words, scratch = _sweep_words(program, lanes, [*entries, wide_sweep(lanes)])
    return words, scratch, code


def _make_call(
    program: Program | Tangent,
    functions: LinkedFunctions,
    lanes: int,
    sweep: Sweep,
) -> Callable[..., int]:
    if lanes == 1 and _array_layout.FITS and not sysconfig.get_config_var("Py_GIL_DISABLED"):
        words = np.zeros(
            _CALL_WORDS + program.signature.num_constants + _size_of_c(program, 1), dtype=np.int64
        )
        words[2:7] = _sizes(program, 1)
        functions.bind(words)
        gate: Callable[..., int] = gates().call.function(words)
        return gate

    # Without the interpreter's lock the gate's shared binding of constants would be a race.
    return call_of(cast("Program", program), sweep)


# -- The back end ----------------------------------------------------------------------------------


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

    tangents = True  # see `base`

    def __init__(self, cse: bool = True, lanes: int = 1, width: int | None = None) -> None:
        if lanes not in WIDTHS:
            raise ValueError(f"`lanes` is {lanes!r}, but it must be 1, 2, 4 or 8.")
        if width is not None and (width not in WIDTHS[1:] or width > lanes):
            raise ValueError(f"`width` is {width!r}, but it must be 2, 4 or 8 and at most `lanes`.")
        self.options: dict[str, Any] = {"cse": cse, "lanes": lanes}
        if width is not None:
            self.options["width"] = width

    def compile(self, program: Program | Tangent) -> Kernel:
        """Return the Kernel of a Program or Tangent.

        Code for one state is compiled when the Kernel is first called, wide code at once.
        """
        lanes: int = self.options["lanes"]
        recipe = ("llvm", self.options)
        if lanes == 1:
            functions = LinkedFunctions(program)
            wide = None
            if isinstance(program, Program) and gains_by_lanes(program):
                wide = partial(_wide_sweep_of, program)
            return native_kernel(program, functions, 1, compile_program, recipe, wide=wide)
        code = wide_code(program, lanes, self.options.get("width"))
        functions, strided = _functions_of(code)
        return native_kernel(program, functions, lanes, compile_program, recipe, strided)


def _functions_of(code: jit.Code) -> tuple[LinkedFunctions, int]:
    """Return the functions of wide code, and the address of the one for strided arrays."""
    functions = LinkedFunctions()
    functions.use(code)
    return functions, code.addresses.get("strided", 0)


def _wide_sweep_of(program: Program, compiles: bool) -> Sweep | None:
    """Return a Program's sweep in lanes, or None where it is in no cache and not to be compiled."""
    code = wide_code(program, LANES) if compiles else cached_wide_code(program, LANES)
    if code is None:
        return None
    functions, strided = _functions_of(code)
    return make_sweep(program, functions, LANES, strided)
