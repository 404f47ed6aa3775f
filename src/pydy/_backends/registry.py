"""Back ends by name."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from importlib import import_module
from typing import Any

import numpy as np

from pydy._checks import shown
from pydy._errors import warn_user
from pydy._forks import fork_lock
from pydy._kernel import Kernel
from pydy._names import nearest
from pydy._program import Program, Tangent, run

_AT_ONCE = 64  # samples that are interpreted together: all their intermediate values are stored

# Classes by name, or their import paths: a back end is imported when it is first used.
_BACKENDS: dict[str, Any] = {
    "llvm": "pydy._backends.llvm.native:LLVMBackend",
    "lambdify": "pydy._backends.numpy_:NumPyBackend",
    "cython": "pydy._backends.c.cython_:CythonBackend",
}
_STAND_IN = "pydy._backends.numpy_:NumPyStandIn"


def names() -> list[str]:
    """Return the names of the registered back ends."""
    return list(_BACKENDS)


def register(name: str, backend: type) -> None:
    """Make `backend` available as ``generator=name``; see `pydy._backends.base`."""
    _BACKENDS[name] = backend


def resolve(generator: Any) -> type:
    """Return the back end class for a name or a class; NumPy's for 'llvm' without llvmlite."""
    if isinstance(generator, type):
        return generator
    entry = _BACKENDS.get(generator) if isinstance(generator, str) else None
    if entry is None:
        raise refusal(generator)
    if not isinstance(entry, str):
        backend: type = entry
        return backend
    try:
        return _imported(entry)
    except ModuleNotFoundError as error:
        if generator != "llvm" or error.name != "llvmlite":
            raise
        _say_that_numpy_stands_in()
        return _imported(_STAND_IN)


def _imported(path: str) -> type:
    module, _, attribute = path.partition(":")
    with fork_lock:
        backend: type = getattr(import_module(module), attribute)
    return backend


@cache
def _say_that_numpy_stands_in() -> None:
    warn_user(
        "llvmlite is not installed: NumPy evaluates the equations, with the same results but much "
        "slower than compiled code. Native solvers and ensembles need it."
    )


def refusal(generator: Any) -> NotImplementedError:
    """Return the error for a value that is not a code generator."""
    suggestion = nearest(generator, names(), or_all=False) if isinstance(generator, str) else ""
    message = (
        f"`generator` is {shown(generator)}, which is not a code generator: it must be one of "
        f"{', '.join(map(repr, names()))}, or a class with a method `compile(program)`. "
        f"{suggestion}"
    )
    return NotImplementedError(message.rstrip())


def compile_program(program: Program | Tangent, generator: Any, options: dict[str, Any]) -> Kernel:
    """Compile a Program; an unpickled Kernel calls this too."""
    return compiled_by(resolve(generator)(**options), program)


def compiled_by(backend: Any, program: Program | Tangent) -> Kernel:
    """Return the Kernel of a Program or Tangent.

    If the back end has no tangents, all columns are written out in one Program.
    """
    if isinstance(program, Program):
        kernel: Kernel = backend.compile(program)
        return kernel
    if not getattr(backend, "tangents", False):
        return compiled_by(backend, program.written_out())
    return _with_finite_samples(backend.compile(program), program)


def _with_finite_samples(kernel: Kernel, tangent: Tangent) -> Kernel:
    """Return the Kernel of a Tangent in which samples with NaN are interpreted again.

    An infinite derivative makes the other columns of its part NaN, because zero times infinity is
    NaN. In the written-out Program, columns have no products with variables they do not depend on.
    """

    def sweep(
        t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray, *out: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, bool]:
        values, failed, all_finite = kernel.sweep(t, x, r, p, *out)
        if all_finite:
            return values, failed, True
        finite = np.isfinite(values).all(axis=1) | ~np.isfinite(x).all(axis=1) | failed
        rows = np.flatnonzero(~finite)
        for start in range(0, len(rows), _AT_ONCE):
            k, program = rows[start : start + _AT_ONCE], tangent.written_out()
            values[k], bad = run(program, t[k], x[k], r if len(r) == 1 else r[k], p)
            failed[k] |= bad
        return values, failed, bool(np.isfinite(values).all())

    return replace(kernel, sweep=sweep)
