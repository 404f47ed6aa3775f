"""The identity of a user's function, in this process or the next.

A function is identified by its code, its defaults, its closure and the globals that it uses,
including other functions. All of these are read, never called. An identity is either complete or
refused: it never depends on a name alone, an address or the order of a set.
"""

from __future__ import annotations

import copyreg
import dis
import hashlib
import io
import pickle
import sys
import sysconfig
from collections.abc import Collection, Iterator
from functools import cache, lru_cache
from importlib.util import find_spec
from pathlib import Path
from types import (
    BuiltinFunctionType,
    CodeType,
    FunctionType,
    MappingProxyType,
    MemberDescriptorType,
    ModuleType,
)
from typing import Any

import numpy as np

_STANDARD = Path(sysconfig.get_paths()["stdlib"])
_INSTALLED = {"site-packages", "dist-packages"}
_GLOBALS = {"LOAD_GLOBAL", "LOAD_NAME", "LOAD_FROM_DICT_OR_GLOBALS"}
_ATTRIBUTES = {"LOAD_ATTR", "LOAD_METHOD", "IMPORT_FROM"}
# Through these a function reaches what its code does not name.
_OPEN_ENDED = {"__import__", "compile", "eval", "exec", "globals", "open"}
# Attributes through which it reaches them too: of `sys`, `os` and `importlib`; and what reads files
# for NumPy, pandas and xarray.
_OUTSIDE = {"argv", "environ", "getenv", "import_module", "modules"}
_OUTSIDE |= {"fromfile", "genfromtxt", "loadtxt", "memmap", "open_dataset", "open_zarr"}
_OUTSIDE |= {"read_bytes", "read_csv", "read_text", "urlopen"}
# What Python adds to classes.
_ADDED = {"__dict__", "__doc__", "__firstlineno__", "__module__", "__static_attributes__"}
_ADDED |= {"__annotate__", "__annotate_func__", "__annotations__", "__annotations_cache__"}
_ADDED |= {"__weakref__", "_abc_impl"}
_CACHED = type(lru_cache(len))


class UnidentifiedError(ValueError):
    """A value cannot be identified across processes."""


def fingerprint(thing: Any) -> str:
    """Return a digest of a value, including the functions in it.

    UnidentifiedError tells what cannot be read: an open file, a module that is not installed, or an
    object that other processes would find by its name alone.
    """
    return _Reader().digest(thing)


class _Reader:
    """Reads values; functions and classes that come again are named by their number."""

    def __init__(self) -> None:
        self._seen: dict[int, int] = {}
        self._alive: list[Any] = []  # an address is a name only as long as its owner lives

    def digest(self, thing: Any) -> str:
        """Return a digest of anything."""
        buffer = io.BytesIO()
        try:
            _Pickler(buffer, self).dump(thing)
        except UnidentifiedError:
            raise
        except Exception as error:
            kind = type(thing).__name__
            raise UnidentifiedError(f"an object of the type {kind} cannot be read") from error
        return hashlib.sha256(buffer.getvalue()).hexdigest()

    def replaced(self, thing: Any) -> Any:
        """Return a replacement for a value that pickle would store by name or order, or None."""
        if type(thing) in (set, frozenset):
            return "set", sorted(map(self.digest, thing))
        if type(thing) is np.ndarray and thing.dtype != object:
            content = hashlib.sha256(np.ascontiguousarray(thing).data).hexdigest()
            return "array", thing.dtype.str, thing.shape, content
        if type(thing) is MappingProxyType:
            return "mapping", self.digest(dict(thing))
        if isinstance(thing, ModuleType):
            return _installed(thing.__name__)
        if isinstance(thing, np.ufunc):
            for module in ("numpy", "scipy.special"):
                if _attribute(module, thing.__name__) is thing:
                    return *_installed(module), thing.__name__
            raise UnidentifiedError(f"{thing!r} does not show what it was made from")
        if _is_symbolic(thing):
            return "sympy", sys.modules["sympy"].srepr(thing)
        if isinstance(thing, _CACHED):
            return "cached", self.digest(thing.__wrapped__)
        if isinstance(thing, BuiltinFunctionType):
            return "built in", thing.__name__, self.digest(thing.__self__)
        if isinstance(thing, CodeType):
            return self._code(thing)
        if isinstance(thing, FunctionType | type):
            return self._once(thing)
        if (type(thing).__module__ or "").startswith("numba.") and hasattr(thing, "py_func"):
            return "numba", self.digest(thing.py_func)
        return None

    def _once(self, thing: Any) -> Any:
        module, name = getattr(thing, "__module__", None) or "", thing.__qualname__
        if _is_installed(module) and _attribute(module, name) is thing:
            return *_installed(module), name
        if id(thing) in self._seen:
            return "again", self._seen[id(thing)]
        self._seen[id(thing)] = len(self._seen)
        self._alive.append(thing)
        parts = self._function(thing) if isinstance(thing, FunctionType) else self._class(thing)
        return type(thing).__name__, [self._named(thing, name, part) for name, part in parts]

    def _named(self, owner: Any, name: str, part: Any) -> tuple[str, str]:
        try:
            return name, self.digest(part)
        except UnidentifiedError as error:
            raise UnidentifiedError(f"{error}, in {name} of `{owner.__qualname__}`") from error

    def _function(self, function: FunctionType) -> Iterator[tuple[str, Any]]:
        code, around = function.__code__, function.__globals__
        outside = sorted(_OUTSIDE & _names(code, _ATTRIBUTES))
        if outside:
            raise UnidentifiedError(
                f"`{function.__qualname__}` uses `{outside[0]}`, which may differ at the next call"
            )
        yield "the code", (sys.version_info[:2], code)
        yield "the defaults", (function.__defaults__, function.__kwdefaults__)
        yield "the attributes", function.__dict__
        for name, cell in zip(code.co_freevars, function.__closure__ or (), strict=True):
            try:
                yield f"the variable `{name}`", cell.cell_contents
            except ValueError:
                yield f"the empty variable `{name}`", None
        for name in sorted(_names(code, _GLOBALS)):
            if name in around:
                yield f"the global `{name}`", around[name]
            elif name in _OPEN_ENDED:
                raise UnidentifiedError(
                    f"`{function.__qualname__}` calls `{name}`, through which it can reach anything"
                )

    def _code(self, code: CodeType) -> Any:
        for instruction in dis.get_instructions(code):
            if instruction.opname == "IMPORT_NAME":
                _installed(instruction.argval)
        return (
            "code",
            code.co_code,
            code.co_exceptiontable,
            code.co_flags,
            (code.co_argcount, code.co_posonlyargcount, code.co_kwonlyargcount),
            (code.co_names, code.co_varnames, code.co_freevars, code.co_cellvars),
            [self.digest(constant) for constant in code.co_consts],
        )

    def _class(self, made: type) -> Iterator[tuple[str, Any]]:
        yield "the bases", (made.__name__, type(made), made.__bases__)
        for name, value in sorted(vars(made).items()):
            part = value
            if name in _ADDED or isinstance(value, MemberDescriptorType):
                continue
            if isinstance(value, classmethod | staticmethod):
                part = type(value), value.__func__
            elif isinstance(value, property):
                part = value.fget, value.fset, value.fdel
            yield f"the attribute `{name}`", part


class _Pickler(pickle.Pickler):
    """Pickles a value by content: references by name or address are replaced."""

    def __init__(self, buffer: io.BytesIO, reader: _Reader) -> None:
        super().__init__(buffer, protocol=4)
        # Otherwise it would tell equal strings that are one object from equal ones that are two.
        self.fast = True
        self._reader = reader

    def persistent_id(self, thing: Any) -> Any:
        """Return the replacement of a value, or None for pickle's own way."""
        return self._reader.replaced(thing)

    def reducer_override(self, thing: Any) -> Any:
        """Refuse objects stored by name, except of installed packages: their version counts."""
        own = copyreg.dispatch_table.get(type(thing))
        reduced = thing.__reduce_ex__(4) if own is None else own(thing)
        if isinstance(reduced, str):
            module = getattr(thing, "__module__", None) or type(thing).__module__
            if not _is_installed(module):
                raise UnidentifiedError(f"`{reduced}` is known by its name only")
            return _installed, (*_installed(module), reduced)
        return NotImplemented


def _is_symbolic(thing: Any) -> bool:
    """Return whether it is an expression or matrix of SymPy's own parts, which shows it all."""
    sympy = sys.modules.get("sympy")
    if sympy is None or not isinstance(thing, sympy.Basic | sympy.MatrixBase):
        return False
    parts = sympy.preorder_traversal(thing)
    return all((type(p).__module__ or "sympy").partition(".")[0] == "sympy" for p in parts)


def _names(code: CodeType, operations: Collection[str]) -> set[str]:
    """Return the names that some operations of a code, and of the code within it, read."""
    names = {i.argval for i in dis.get_instructions(code) if i.opname in operations}
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            names |= _names(constant, operations)
    return names


def _attribute(module: Any, name: str) -> Any:
    found: Any = sys.modules.get(module) if isinstance(module, str) else None
    for part in name.split("."):
        found = getattr(found, part, None)
    return found


def _installed(name: str) -> tuple[str, str, str]:
    """Return an identity for a module, which must belong to Python or an installed package."""
    if not _is_installed(name):
        raise UnidentifiedError(f"the module `{name}` does not belong to an installed package")
    whole = sys.modules.get(name.partition(".")[0])
    return "module", name, str(getattr(whole, "__version__", ""))


def _is_installed(name: Any) -> bool:
    if not isinstance(name, str) or not name:
        return False
    return _is_package(name.partition(".")[0])


@cache
def _is_package(top: str) -> bool:
    if top == "pydy" or top in sys.builtin_module_names:
        return True
    try:
        spec = find_spec(top)
    except (ImportError, ValueError):  # `__main__` has none
        return False
    if spec is None:
        return False
    places = [spec.origin, *(spec.submodule_search_locations or ())]
    if spec.origin in ("built-in", "frozen"):
        return True
    paths = [Path(place) for place in places if place]
    return any(_STANDARD in p.parents or _INSTALLED & {*p.parts} for p in paths)
