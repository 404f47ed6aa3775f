"""LLVM, once per process: sources in, addresses out, by way of the caches."""

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
    """Functions that code calls; it keeps this object."""

    addresses: dict[str, int]


class Code:
    """Machine code in memory, by `addresses`: this object keeps it and the code it calls."""

    def __init__(self, engine: Any, names: Sequence[str], calls: Sequence[Addresses]) -> None:
        self._engine = engine
        self._calls = calls
        self.addresses: dict[str, int] = {n: engine.get_function_address(n) for n in names}


memory: WeakValueDictionary[str, Code] = WeakValueDictionary()
"""The code of this process that is in use, by the keys of its sources."""


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
    """Return the one code of a source, which may have come into use meanwhile.

    Addresses are handed on without their code, which then has to be the one that is kept.
    """
    with _LOCK:
        known = memory.get(source.key)
        if known is None:
            known = memory[source.key] = _linked(code, source.names, calls)
    return known


def find(source: Source, calls: Sequence[Addresses] = ()) -> Code | None:
    """Return compiled code from memory or disk, or None."""
    key = source.key
    known = memory.get(key)
    if known is None:
        stored = _cache_folder.read(key)
        if stored is not None:
            try:
                known = _shared(source, stored, calls)
            except RuntimeError:  # a sound file that is no object code for this machine
                return None
    return known


def load(source: Source, calls: Sequence[Addresses] = ()) -> Code:
    """Return compiled code from memory, from disk, or from LLVM."""
    known = find(source, calls)
    if known is None:
        stored = object_code(source)
        _cache_folder.write(source.key, stored)
        known = _shared(source, stored, calls)
    return known
