"""Back ends by name."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from pydy._checks import shown
from pydy._forks import whole
from pydy._graph.program import Program
from pydy._graph.tangent import Tangent
from pydy._kernel import Kernel
from pydy._names import nearest

# Names to classes, or to where a class lies: a back end's own imports wait until it is asked for.
_BACKENDS: dict[str, Any] = {
    "llvm": "pydy._backends.llvm.backend:LLVMBackend",
    "lambdify": "pydy._backends.numpy_:NumPyBackend",
    "cython": "pydy._backends.c.cython_:CythonBackend",
}


def names() -> list[str]:
    """Return the names of the registered back ends."""
    return list(_BACKENDS)


def register(name: str, backend: type) -> None:
    """Make `backend` available as ``generator=name``; see `pydy._backends.base`."""
    _BACKENDS[name] = backend


def resolve(generator: Any) -> type:
    """Return the back end class for a name or a class.

    Raises
    ------
    NotImplementedError
        The name is not registered.
    """
    if isinstance(generator, type):
        return generator
    entry = _BACKENDS.get(generator) if isinstance(generator, str) else None
    if entry is None:
        raise refusal(generator)
    if isinstance(entry, str):
        module, _, attribute = entry.partition(":")
        with whole:
            entry = getattr(import_module(module), attribute)
    backend: type = entry
    return backend


def refusal(generator: Any) -> NotImplementedError:
    """Return the error for what is no code generator."""
    meant = nearest(generator, names(), or_all=False) if isinstance(generator, str) else ""
    message = (
        f"`generator` is {shown(generator)}, which is not a code generator: it must be one of "
        f"{', '.join(map(repr, names()))}, or a class with a method `compile(program)`. {meant}"
    )
    return NotImplementedError(message.rstrip())


def compile_program(program: Program | Tangent, generator: Any, options: dict[str, Any]) -> Kernel:
    """Compile a Program; also what a pickled Kernel calls where it lands."""
    return compiled_by(resolve(generator)(**options), program)


def compiled_by(backend: Any, program: Program | Tangent) -> Kernel:
    """Return the Kernel of a Program or Tangent, all columns written out if need be."""
    if isinstance(program, Tangent) and not getattr(backend, "tangents", False):
        program = program.written_out()
    kernel: Kernel = backend.compile(program)
    return kernel
