"""Compile and link sources once per process, using the caches in memory and on disk."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol
from weakref import WeakValueDictionary

from llvmlite import binding

from pydy import _cache_folder, _forks
from pydy._backends.llvm.compiling import Source, object_code, target_machine

# Linking uses LLVM's global state; compiling does not.
_LOCK = _forks.Lock()


class Addresses(Protocol):
    """Functions that code calls; the code holds a reference to this object."""

    addresses: dict[str, int]


class Code:
    """Machine code in memory and its `addresses`. It keeps itself and the code it calls alive."""

    def __init__(self, engine: Any, names: Sequence[str], calls: Sequence[Addresses]) -> None:
        self._engine = engine
        self._calls = calls
        self.addresses: dict[str, int] = {n: engine.get_function_address(n) for n in names}


memory: WeakValueDictionary[str, Code] = WeakValueDictionary()
"""The code that this process uses, by the keys of its sources."""


def _linked(code: bytes, names: Sequence[str], calls: Sequence[Addresses]) -> Code:
    with _LOCK:
        for part in calls:
            for name, address in part.addresses.items():
                binding.add_symbol(name, address)
        engine = binding.create_mcjit_compiler(binding.parse_assembly(""), target_machine())
        engine.add_object_file(binding.ObjectFileRef.from_data(code))
        engine.finalize_object()
        return Code(engine, names, calls)


def _shared(source: Source, code: bytes, calls: Sequence[Addresses]) -> Code:
    """Return the unique code of a source; another thread may have linked it meanwhile.

    Addresses are passed on without their code, so that there must be only one.
    """
    with _LOCK:
        code_in_use = memory.get(source.key)
        if code_in_use is None:
            code_in_use = memory[source.key] = _linked(code, source.names, calls)
    return code_in_use


def find(source: Source, calls: Sequence[Addresses] = ()) -> Code | None:
    """Return compiled code from memory or disk, or None."""
    key = source.key
    compiled = memory.get(key)
    if compiled is None:
        stored = _cache_folder.read(key)
        if stored is not None:
            try:
                compiled = _shared(source, stored, calls)
            except RuntimeError:  # an intact file, but no object code for this machine
                return None
    return compiled


def load(source: Source, calls: Sequence[Addresses] = ()) -> Code:
    """Return compiled code from memory, from disk, or from LLVM."""
    compiled = find(source, calls)
    if compiled is None:
        stored = object_code(source)
        _cache_folder.write(source.key, stored)
        compiled = _shared(source, stored, calls)
    return compiled
