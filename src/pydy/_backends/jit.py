"""LLVM, once per process: IR text in, addresses out, by way of the caches."""

from __future__ import annotations

import hashlib
import threading
from collections.abc import Callable, Sequence
from functools import cache as once
from pathlib import Path
from typing import Any

from llvmlite import __version__ as llvmlite_version
from llvmlite import binding

from pydy._backends import cache

__all__ = ["Code", "define_symbol", "load"]

# MCJIT and LLVM's global state are not safe to use from two threads at once.
_LOCK = threading.RLock()


class Code:
    """Machine code in memory; it lives as long as this object.

    Attributes
    ----------
    addresses : dict of str to int
    """

    def __init__(self, engine: Any, names: Sequence[str]) -> None:
        self._engine = engine
        self.addresses: dict[str, int] = {n: engine.get_function_address(n) for n in names}


@once
def _host() -> tuple[Any, str, str]:
    """Return the target, the processor and its features, and set LLVM up."""
    binding.initialize_native_target()
    binding.initialize_native_asmprinter()
    features = binding.get_host_cpu_features().flatten()
    return binding.Target.from_default_triple(), binding.get_host_cpu_name(), features


@once
def _circumstances() -> bytes:
    """Everything but the Program that decides what the machine code is."""
    _, processor, features = _host()
    sha = hashlib.sha256()
    parts = (processor, features, llvmlite_version, *map(str, binding.llvm_version_info))
    sha.update("\n".join((binding.get_default_triple(), *parts)).encode())
    # The code that writes the IR: a new version of it must not meet the old one's output.
    for source in sorted(Path(__file__).parent.glob("*.py")):
        sha.update(source.read_bytes())
    return sha.digest()


def _target_machine() -> Any:
    target, processor, features = _host()
    return target.create_target_machine(
        cpu=processor, features=features, opt=2, codemodel="jitdefault", jit=True
    )


def _object_code(text: str, loops: bool) -> bytes:
    """Compile a module of IR text.

    LLVM's optimisation passes run only for code with loops: on straight-line code that comes from
    a graph without redundancy they cost a third of the time and change nothing (measured on
    pendulums of 10 and 20 links).
    """
    machine = _target_machine()
    module = binding.parse_assembly(text)
    if loops:
        tuning = binding.create_pipeline_tuning_options(speed_level=2)
        passes = binding.create_pass_builder(machine, tuning)
        passes.getModulePassManager().run(module, passes)
    code: bytes = machine.emit_object(module)
    return code


def _linked(code: bytes, names: Sequence[str]) -> Code:
    engine = binding.create_mcjit_compiler(binding.parse_assembly(""), _target_machine())
    engine.add_object_file(binding.ObjectFileRef.from_data(code))
    engine.finalize_object()
    return Code(engine, names)


def load(what: str, text: Callable[[], str], names: Sequence[str], loops: bool = False) -> Code:
    """Return compiled IR, from memory, from disk, or from LLVM.

    Parameters
    ----------
    what : str
        Identifies the IR: a Program's digest with the options.
    text : callable
        Returns the IR, a module; functions of libm and of Python's C interface, and those of
        `define_symbol`, are known by their names.
    names : sequence of str
        Functions whose addresses are wanted.
    loops : bool
        Whether the code has loops, for which LLVM's optimisation passes pay.
    """
    with _LOCK:
        key = hashlib.sha256(_circumstances() + what.encode()).hexdigest()
        known: Code | None = cache.memory.get(key)
        if known is not None:
            return known
        stored = cache.read(key)
        code = None
        if stored is not None:
            try:
                code = _linked(stored, names)
            except RuntimeError:  # a sound file that is no object code for this machine
                stored = None
        if code is None:
            stored = _object_code(text(), loops)
            cache.write(key, stored)
            code = _linked(stored, names)
        cache.memory.put(key, code)
        return code


def define_symbol(name: str, address: int) -> None:
    """Make a function known by name to all code that is loaded from now on."""
    binding.add_symbol(name, address)
