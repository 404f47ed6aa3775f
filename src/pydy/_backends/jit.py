"""LLVM, once per process: IR text in, addresses out, by way of the caches."""

from __future__ import annotations

import hashlib
import platform
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache as once
from pathlib import Path
from typing import Any

from llvmlite import __version__ as llvmlite_version
from llvmlite import binding

from pydy import _cache_folder, _forks
from pydy._backends import background, cache

__all__ = ["Code", "Source", "find", "load", "load_quickly", "registers"]

# Linking uses LLVM's global state; compiling does not.
_LOCK = _forks.Lock()


class Code:
    """Machine code in memory; it lives as long as this object, and so does what it calls.

    Attributes
    ----------
    addresses : dict of str to int
    """

    def __init__(self, engine: Any, names: Sequence[str], calls: Code | None) -> None:
        self._engine = engine
        self._calls = calls
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
    folder = Path(__file__).parent
    for source in (folder.with_name("_array_layout.py"), *sorted(folder.glob("*.py"))):
        sha.update(source.read_bytes())
    return sha.digest()


def registers(lanes: int) -> int:
    """Return how many vectors of that many doubles the processor's registers hold."""
    features = _host()[2].split(",")
    if "+avx512vl" in features:
        count, width = 32, 8
    elif platform.machine().lower() in ("arm64", "aarch64"):
        count, width = 32, 2
    else:
        count, width = 16, 4 if "+avx" in features else 2
    return count // max(lanes // width, 1)


def _target_machine(quick: bool = False) -> Any:
    target, processor, features = _host()
    return target.create_target_machine(
        cpu=processor,
        features=features,
        opt=0 if quick else 2,
        codemodel="jitdefault",
        jit=True,
    )


@once
def _emitter(quick: bool) -> Any:
    """Return the machine that writes object code; an engine needs one of its own, and keeps it."""
    return _target_machine(quick)


def _object_code(text: str, loops: bool, quick: bool) -> bytes:
    """Compile a module of IR text.

    LLVM's optimisation passes run only for code with loops, in the text or in the model: on
    straight-line code that comes from a graph without redundancy they cost a third of the time and
    change nothing (measured on pendulums of 10 and 20 links).
    """
    # A context of its own lets two threads compile at the same time.
    module = binding.parse_assembly(text, binding.create_context())
    machine = _emitter(quick)
    if loops and not quick:
        tuning = binding.create_pipeline_tuning_options(speed_level=2)
        tuning.slp_vectorization = True
        passes = binding.create_pass_builder(machine, tuning)
        passes.getModulePassManager().run(module, passes)
    code: bytes = machine.emit_object(module)
    return code


def _linked(code: bytes, names: Sequence[str], calls: Code | None) -> Code:
    with _LOCK:
        for name, address in calls.addresses.items() if calls else ():
            binding.add_symbol(name, address)
        engine = binding.create_mcjit_compiler(binding.parse_assembly(""), _target_machine())
        engine.add_object_file(binding.ObjectFileRef.from_data(code))
        engine.finalize_object()
        return Code(engine, names, calls)


@dataclass(frozen=True)
class Source:
    """What can be compiled.

    Attributes
    ----------
    what : str
        Identifies the IR: a Program's digest with the options.
    text : callable
        Returns the IR, a module; ``text(True)`` the same in brief, for code that must be ready
        quickly. It knows the functions of libm, of Python's C interface, and
        those of the code that is passed as `calls`.
    names : tuple of str
        The functions whose addresses are wanted.
    loops : bool
        Whether the code has loops, or does the same many times side by side: LLVM's optimisation
        passes then pay.
    """

    what: str
    text: Callable[[bool], str]
    names: tuple[str, ...]
    loops: bool = False

    @property
    def key(self) -> str:
        """The name under which the caches know it."""
        return hashlib.sha256(_circumstances() + self.what.encode()).hexdigest()


def find(source: Source, calls: Code | None = None) -> Code | None:
    """Return compiled code from memory or disk, or None."""
    key = source.key
    known: Code | None = cache.memory.get(key)
    if known is None:
        stored = _cache_folder.read(key)
        if stored is not None:
            try:
                known = _linked(stored, source.names, calls)
            except RuntimeError:  # a sound file that is no object code for this machine
                return None
            cache.memory.put(key, known)
    return known


def load(source: Source, calls: Code | None = None) -> Code:
    """Return compiled code from memory, from disk, or from LLVM at its best."""
    known = find(source, calls)
    if known is None:
        stored = _object_code(source.text(False), source.loops, quick=False)
        _cache_folder.write(source.key, stored)
        known = _linked(stored, source.names, calls)
        cache.memory.put(source.key, known)
    return known


def load_quickly(source: Source, calls: Code | None = None) -> Code:
    """Return code that LLVM compiles in a tenth of the time and that runs half as fast.

    It computes the same bits: what is fused and in which order is written in the IR.
    """
    background.in_use()
    stored = _object_code(source.text(True), source.loops, quick=True)
    return _linked(stored, source.names, calls)
