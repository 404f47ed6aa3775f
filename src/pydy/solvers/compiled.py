"""numba, with a cache that knows when it is stale.

numba's own cache looks at the file of the outermost function only, and lies beside the sources.
This one is keyed by the text of the whole package of solvers and lies with the machine code of
kernels, in `_cache_folder`.
"""

from __future__ import annotations

import hashlib
import logging
import pickle
import sys
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

import llvmlite.binding as llvm
import numba
from numba.core import serialize, sigutils
from numba.core.caching import NullCache
from numba.core.ccallback import CFunc
from numba.core.compiler import CompileResult
from numba.core.runtime.nrt import rtsys

from pydy import _cache_folder, _forks

__all__ = ["compiled", "inlined", "part"]

_LOG = logging.getLogger("pydy")
_FOLDER = "solvers"  # within the cache: tests share it among runs

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


class _Cache(NullCache):  # numba calls it at each compilation
    """numba's cache, in the package's folder: reading an entry runs what it says (see pickle).

    numba's own class believes whatever files it finds.
    """

    def __init__(self, function: Callable[..., Any]) -> None:
        code = function.__code__
        self._name = f"{function.__module__}.{code.co_qualname} {code.co_firstlineno}"

    def _key(self, signature: Any, codegen: Any) -> str:
        parts = (self._name, _digest(), sys.version, numba.__version__)
        what = "\n".join(map(str, (*parts, signature, *codegen.magic_tuple())))
        return hashlib.sha256(what.encode()).hexdigest()

    def load_overload(self, signature: Any, target_context: Any) -> Any:
        # Without `target_context.refresh()`, which makes numba ready to compile and takes ten
        # times as long as to load. Arrays need its runtime.
        rtsys.initialize(target_context)
        found = None
        data = _cache_folder.read(self._key(signature, target_context.codegen()), _FOLDER)
        if data is not None:
            with suppress(Exception):  # whatever a broken entry raises, it is a miss
                found = CompileResult._rebuild(target_context, *pickle.loads(data))
        if found is None:
            _LOG.warning("Compiling a solver, once on this machine: this takes some seconds.")
        return found

    def save_overload(self, signature: Any, result: Any) -> None:
        assert not result.library.has_dynamic_globals  # addresses of this process
        key = self._key(signature, result.codegen)
        _cache_folder.write(key, serialize.dumps(_reduced(result)), _FOLDER)


def _reduced(result: Any) -> Any:
    """Leave out the code that other functions could inline: reading it is most of a load.

    numba reads from it which functions there are: those stay, without bodies.
    """
    # The last are functions' modules, for what Python does in them: nothing here.
    state, *rest, _ = result._reduce()
    name, kind, (machine_code, bitcode) = state
    functions = llvm.parse_bitcode(bitcode).functions
    stubs = [
        f'define void @"{function.name}"() {{ ret void }}'
        for function in functions
        if not function.is_declaration
    ]
    bitcode = llvm.parse_assembly("\n".join(stubs)).as_bitcode()
    return ((name, kind, (machine_code, bitcode)), *rest, ())


def compiled(function: Callable[..., Any]) -> Any:
    """Compile a function that Python calls; it releases the interpreter's lock."""
    dispatcher: Any = numba.njit(**_OPTIONS)(function)
    if _cache_folder.folder(_FOLDER) is not None:
        dispatcher._cache = _Cache(function)
    return dispatcher


class _Part:
    """A function that compiled code calls by its address."""

    def __init__(self, function: Callable[..., Any], last: str) -> None:
        self.__doc__ = function.__doc__
        self._function = function
        self._signature = f"int64(int64, float64, {last})"
        self._native: Any = None
        self._lock = _forks.Lock()

    @property
    def address(self) -> int:
        """Where it lies: it is compiled, or loaded, when this is first asked for."""
        with self._lock:
            if self._native is None:
                options = {**_OPTIONS, "_nrt": True}
                arguments = sigutils.normalize_signature(self._signature)
                native: Any = CFunc(self._function, arguments, locals={}, options=options)
                if _cache_folder.folder(_FOLDER) is not None:
                    native._cache = _Cache(self._function)
                native.compile()
                self._native = native  # keeps the code
            return int(self._native.address)


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
