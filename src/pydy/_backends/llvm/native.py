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
from typing import Any, Literal, cast

import numpy as np

from pydy import _array_layout
from pydy._backends.base import call_of
from pydy._backends.llvm import jit
from pydy._backends.llvm.compiling import CORE
from pydy._backends.llvm.functions import LinkedFunctions
from pydy._backends.llvm.ir import WIDTHS
from pydy._backends.llvm.jit import Code
from pydy._backends.llvm.sources import leaves_out_fallbacks, wide_code
from pydy._backends.llvm.text import size_with_constants
from pydy._backends.registry import compile_program
from pydy._backends.tuning import SWEPT
from pydy._forks import once
from pydy._kernel import Kernel
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
_SWEEP_WORDS, _CALL_WORDS = 9, 8
_GATES = ("sweep_1", "sweep_gate", "kernel_gate", "step_gate", "call_python")
NLP = ("nlp_cost", "nlp_rows", "nlp_gradient", "nlp_jacobian", "nlp_hessian")


def scratch_size(lanes: int, n: int, s: int, k: int, setup_values: int, outputs: int) -> int:
    """Return the size of a sweep's scratch memory in doubles, with room for its alignment."""
    return setup_values if lanes == 1 else (n + s + 1 + k + setup_values + outputs) * lanes + 8


def native_kernel(
    program: Program | Tangent,
    functions: LinkedFunctions,
    lanes: int,
    rebuild: Callable[..., Kernel],
    recipe: tuple[Any, ...],
    strided: int = 0,
) -> Kernel:
    """Wrap native functions of the package's signature as a Kernel.

    `strided` is the address of the function for strided arrays, or zero.
    """
    sweep = _make_sweep(program, functions, lanes, strided)
    call = _make_call(program, functions, lanes, sweep)
    signature = cast("Program", program)
    return Kernel(
        signature, sweep, call, rebuild, recipe, lanes, functions, _size_of_c(program, lanes)
    )


class _Gates:
    """The gates from Python."""

    def __init__(self) -> None:
        self.code = code = jit.load(CORE.source("gates", _GATES))
        self.call = Gate(b"native_call", code, "kernel_gate")
        self.step = Gate(b"native_step", code, "step_gate")
        self._sweep = Gate(b"native_sweep", code, "sweep_gate")
        gate: Callable[..., None] = self._sweep.function(None)
        self.sweep = gate if _array_layout.FITS else _careful_sweep


_SWEEP = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 8)


def _careful_sweep(words: np.ndarray, *arrays: np.ndarray) -> None:
    """Call the sweep with ctypes, without reading NumPy's objects directly."""
    t, x, r = arrays[:3]
    r_step = r.shape[1] if len(r) > 1 else 0
    by_columns = x.flags.f_contiguous and not x.flags.c_contiguous
    words = np.array([*words[:_SWEEP_WORDS], len(t), r_step, by_columns], np.int64)
    _SWEEP(int(words[3]))(*(array.ctypes.data for array in (words, *arrays)))


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


def _make_sweep(
    program: Program | Tangent, functions: LinkedFunctions, lanes: int, strided: int
) -> Callable[..., tuple[np.ndarray, np.ndarray]]:
    sizes = _sizes(program, lanes)
    n, outputs = sizes[0], sizes[-1]
    native = gates().code.addresses["sweep_1"] if lanes == 1 else wide_sweep(lanes)
    room = scratch_size(lanes, *sizes)
    run, columns = gates().sweep, strided != 0
    most = max(1, SWEPT // (lanes * (program.num_operations + 1))) * lanes
    words = np.array([0, 0, strided, native, *sizes, 0, 0, 0], np.int64)
    functions.bind(words)

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
        run(words, t, x, r, p, values, failed, np.empty(room))
        return values, failed

    def sweep(
        t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray, out: np.ndarray | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        if not functions.addresses[0]:
            functions.link()
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

    That is `Words` of ``core/kernel.h``, the last three of one call, how many numbers of scratch
    memory it needs, and what keeps the code alive.
    """
    code = wide_code(program, lanes)
    sizes = _sizes(program, lanes)
    entries = [code.addresses[name] for name in ("kernel", "prepare", "strided")]
    words = np.array([*entries, wide_sweep(lanes), *sizes, 0, 0, 1], np.int64)
    return words, scratch_size(lanes, *sizes), code


def _make_call(
    program: Program | Tangent,
    functions: LinkedFunctions,
    lanes: int,
    sweep: Callable[..., tuple[np.ndarray, np.ndarray]],
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
            return native_kernel(program, LinkedFunctions(program), 1, compile_program, recipe)
        code = wide_code(program, lanes, self.options.get("width"))
        functions = LinkedFunctions()
        functions.use(code)
        strided = code.addresses.get("strided", 0)
        return native_kernel(program, functions, lanes, compile_program, recipe, strided)
