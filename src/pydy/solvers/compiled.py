"""numba, with a cache that knows when it is stale.

numba's own cache looks at the file of the outermost function only, and lies beside the sources.
This one is keyed by the text of the whole package of solvers and lies with the machine code of
kernels, where PYDY_CACHE_DIR says.
"""

from __future__ import annotations

import hashlib
import logging
from collections.abc import Callable
from contextlib import suppress
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import llvmlite.binding as llvm
import numba
from numba.core import sigutils
from numba.core.caching import CompileResultCacheImpl, FunctionCache, _CacheLocator
from numba.core.ccallback import CFunc
from numba.core.runtime.nrt import rtsys

from pydy._cache_folder import folder

__all__ = ["compiled", "inlined", "part"]

_LOG = logging.getLogger("pydy")

# Arrays belong to the caller, who outlives the call: counting references to them, atomically, took
# half of the time. Functions that make arrays have to say so.
_OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy", "_nrt": False}


@cache
def _digest() -> str:
    """Return what the compiled code depends on, processor and numba's version aside."""
    digest = hashlib.sha256()
    for path in sorted(Path(__file__).parent.rglob("*.py")):
        digest.update(path.read_bytes())
    return digest.hexdigest()


class _Locator(_CacheLocator):
    def __init__(self, function: Callable[..., Any]) -> None:
        self._name = function.__module__

    def get_cache_path(self) -> str:
        place = folder()
        assert place is not None  # `compiled` asks first
        return str(place / "solvers")

    def get_source_stamp(self) -> str:
        return _digest()

    def get_disambiguator(self) -> str:
        return str(self._name.rpartition(".")[2])

    @classmethod
    def from_function(cls, function: Callable[..., Any], _file: str) -> _Locator:
        return cls(function)


class _Implementation(CompileResultCacheImpl):
    _locator_classes: Any = (_Locator,)

    def reduce(self, data: Any) -> Any:
        """Leave out the code that other functions could inline: reading it is most of a load.

        numba reads from it which functions there are: those stay, without bodies.
        """
        # The last are functions' modules, for what Python does in them: nothing here.
        state, *rest, _ = super().reduce(data)  # type: ignore[no-untyped-call]
        name, kind, (machine_code, bitcode) = state
        functions = llvm.parse_bitcode(bitcode).functions
        stubs = [
            f'define void @"{function.name}"() {{ ret void }}'
            for function in functions
            if not function.is_declaration
        ]
        bitcode = llvm.parse_assembly("\n".join(stubs)).as_bitcode()
        return ((name, kind, (machine_code, bitcode)), *rest, ())


class _Cache(FunctionCache):
    _impl_class = _Implementation

    def load_overload(self, signature: Any, target_context: Any) -> Any:
        try:
            # Not `super().load_overload`: that makes numba ready to compile first, which takes ten
            # times as long as to load. Arrays need its runtime.
            rtsys.initialize(target_context)
            found = self._load_overload(signature, target_context)  # type: ignore[no-untyped-call]
        except Exception:  # noqa: BLE001 - whatever a broken entry raises, it is a miss
            found = None
            with suppress(OSError):
                self.flush()  # type: ignore[no-untyped-call]
        if found is None:
            _LOG.warning("Compiling a solver, once on this machine: this takes some seconds.")
        return found

    def save_overload(self, signature: Any, data: Any) -> None:
        try:
            super().save_overload(signature, data)  # type: ignore[no-untyped-call]
        except OSError:
            _LOG.info("The compiled solver could not be kept on disk.", exc_info=True)


def compiled(function: Callable[..., Any]) -> Any:
    """Compile a function that Python calls; it releases the interpreter's lock."""
    dispatcher: Any = numba.njit(**_OPTIONS)(function)
    if folder() is not None:
        dispatcher._cache = _Cache(function)  # type: ignore[no-untyped-call]
    return dispatcher


class _Part:
    """A function that compiled code calls by its address."""

    def __init__(self, function: Callable[..., Any], last: str) -> None:
        self.__doc__ = function.__doc__
        self._function = function
        self._signature = f"int64(int64, float64, {last})"

    @cached_property
    def address(self) -> int:
        """Where it lies: it is compiled, or loaded, when this is first asked for."""
        options = {**_OPTIONS, "_nrt": True}
        arguments = sigutils.normalize_signature(self._signature)
        native: Any = CFunc(self._function, arguments, locals={}, options=options)
        if folder() is not None:
            native._cache = _Cache(self._function)  # type: ignore[no-untyped-call]
        native.compile()
        self._native = native  # keeps the code
        return int(native.address)


def part(last: str) -> Callable[[Callable[..., Any]], _Part]:
    """Compile a function on its own, of what few integrations need, with the first that does.

    Parameters
    ----------
    last : str
        The type of its last argument, after the address of a table of arrays and a time. It returns
        an integer, and may make arrays.
    """
    return lambda function: _Part(function, last)


def inlined(
    function: Callable[..., Any] | None = None,
    *,
    reassociate: bool = False,
    always: bool = False,
    pasted: bool = False,
    allocates: bool = False,
) -> Any:
    """Compile a function that other compiled functions call.

    Parameters
    ----------
    function : callable
    reassociate : bool
        Its sums may be taken in any order, which lets them use vector registers.
    always : bool
        It becomes a part of each caller. A call that hands over the tuples of `layout` passes a
        hundred numbers, which takes longer than many a function; LLVM leaves it at that where a
        function is long or has several callers.
    pasted : bool
        Its code becomes a part of each caller before it is compiled: for long functions that have
        one caller, which would be compiled twice.
    allocates : bool
        It makes arrays.
    """
    flags = {"contract", "reassoc", "nsz"} if reassociate else False
    options = {**_OPTIONS, "_nrt": allocates}
    if pasted:
        options["inline"] = "always"
    decorate: Any = numba.njit(**options, fastmath=flags, forceinline=always)
    return decorate if function is None else decorate(function)
