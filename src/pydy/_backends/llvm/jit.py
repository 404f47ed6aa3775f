"""LLVM, once per process: sources in, addresses out, by way of the caches."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Any
from weakref import WeakValueDictionary

from llvmlite import binding

from pydy import _cache_folder, _forks
from pydy._backends.llvm import background
from pydy._backends.llvm.background import Compile
from pydy._backends.llvm.compiling import Source, object_code, target_machine

# Linking uses LLVM's global state; compiling does not.
_LOCK = _forks.Lock()


class Code:
    """Machine code in memory, by `addresses`: this object keeps it and the code it calls."""

    def __init__(self, engine: Any, names: Sequence[str], calls: Sequence[Code]) -> None:
        self._engine = engine
        self._calls = calls
        self.addresses: dict[str, int] = {n: engine.get_function_address(n) for n in names}


memory: WeakValueDictionary[str, Code] = WeakValueDictionary()
"""The code of this process that is in use, by the keys of its sources."""


def _linked(code: bytes, names: Sequence[str], calls: Sequence[Code]) -> Code:
    with _LOCK:
        for part in calls:
            for name, address in part.addresses.items():
                binding.add_symbol(name, address)
        engine = binding.create_mcjit_compiler(binding.parse_assembly(""), target_machine())
        engine.add_object_file(binding.ObjectFileRef.from_data(code))
        engine.finalize_object()
        return Code(engine, names, calls)


def _shared(source: Source, code: bytes, calls: Sequence[Code]) -> Code:
    """Return the one code of a source, which may have come into use meanwhile.

    Addresses are handed on without their code, which then has to be the one that is kept.
    """
    with _LOCK:
        known = memory.get(source.key)
        if known is None:
            known = memory[source.key] = _linked(code, source.names, calls)
    return known


def find(source: Source, calls: Sequence[Code] = ()) -> Code | None:
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


def load(source: Source, calls: Sequence[Code] = (), compile_source: Compile = object_code) -> Code:
    """Return compiled code from memory, from disk, or from LLVM, by default at its best."""
    known = find(source, calls)
    if known is None:
        stored = compile_source(source)
        _cache_folder.write(source.key, stored)
        known = _shared(source, stored, calls)
    return known


def load_quickly(source: Source, calls: Sequence[Code] = ()) -> Code:
    """Return code that LLVM compiles in a tenth of the time and that runs half as fast.

    It computes the same bits: what is fused and in which order is written in the IR.
    """
    background.in_use()
    hasty = replace(source, what=f"{source.what}, quickly")
    return load(hasty, calls, partial(object_code, quick=True))
