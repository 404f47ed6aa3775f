"""From IR text to object code."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from mmap import mmap
from pathlib import Path
from typing import Any

from llvmlite import __version__ as llvmlite_version, binding

from pydy._backends.llvm.targets import target
from pydy._forks import once


def _digest_of_writer() -> bytes:
    """Return a digest of the code that writes the IR."""
    sha = hashlib.sha256()
    backends = Path(__file__).parents[1]
    for source in (backends.with_name("_array_layout.py"), *sorted(backends.rglob("*.py"))):
        sha.update(source.read_bytes())
    return sha.digest()


# Computed at import, not on first use: the package may be replaced while this process runs, and IR
# that the old code still writes must not be cached under the digest of the new code.
_SOURCES = _digest_of_writer()


@once
def _toolchain_digest() -> bytes:
    """Return a digest of everything except the Program that determines the machine code."""
    host = target()
    sha = hashlib.sha256(_SOURCES)
    parts = (host.processor, host.features, llvmlite_version, *map(str, binding.llvm_version_info))
    sha.update("\n".join((host.triple, *parts)).encode())
    return sha.digest()


def target_machine() -> Any:
    """Return a machine to write object code for the target."""
    host = target()
    return binding.Target.from_triple(host.triple).create_target_machine(
        cpu=host.processor,
        features=host.features,
        opt=2,
        codemodel="jitdefault",
        jit=True,
    )


@dataclass(frozen=True)
class Source:
    """A module that can be compiled."""

    identity: str  # identifies the IR: a Program's digest with the options
    # Returns the IR of a module. It can call the functions of libm, of Python's C interface, and
    # those of the code that is passed as `calls`.
    text: Callable[[], str]
    names: tuple[str, ...]  # the functions whose addresses are needed
    # Whether the code has loops, or repeats the same operations side by side: LLVM's optimisation
    # passes then pay off.
    loops: bool = False

    @property
    def key(self) -> str:
        """The key in the caches."""
        return hashlib.sha256(_toolchain_digest() + self.identity.encode()).hexdigest()


@once
def _emitter() -> Any:
    """Return the target machine that writes object code. An engine owns a separate one."""
    return target_machine()


def _check_memory(size: int) -> None:
    """Raise if memory for LLVM cannot be allocated: LLVM would end the process."""
    try:
        mmap(-1, size).close()  # pages that nobody writes to cost nothing
    except OSError:
        raise MemoryError(
            f"Compiling may need {size / 1e6:.0f} MB of memory, and the process cannot have as "
            "much. Allow it more: `ulimit -v` or the job's settings limit it."
        ) from None


def object_code(source: Source) -> bytes:
    """Compile a module of IR text.

    LLVM's optimisation passes run only for code with loops, in the text or in the model: on
    straight-line code that comes from a graph without redundancy they cost a third of the time and
    change nothing (measured on pendulums of 10 and 20 links).
    """
    text = source.text()
    # LLVM's passes took 10 MB, and 27 bytes for each letter of 100 links.
    _check_memory(2**24 + 32 * len(text))
    # A context of its own lets two threads compile at the same time.
    context = binding.create_context()
    _CONTEXTS[id(context)] = context
    with binding.parse_assembly(text, context) as module:
        machine = _emitter()
        if source.loops:
            tuning = binding.create_pipeline_tuning_options(speed_level=2)
            tuning.slp_vectorization = True
            passes = binding.create_pass_builder(machine, tuning)
            passes.getModulePassManager().run(module, passes)
        code: bytes = machine.emit_object(module)
    del _CONTEXTS[id(context)]
    return code


# Contexts that may contain modules. An exception raised by a signal handler may leave a module in a
# reference cycle, which Python collects in any order: without its context it would be freed twice.
_CONTEXTS: dict[int, Any] = {}


class Shipped:
    """The LLVM IR in a folder, compiled here for the processor at hand.

    ``tools/solvers_ir.py`` generates it from C; only changes of the C code need that compiler. All
    files are read at once: the package may be replaced while this process runs.
    """

    def __init__(self, folder: Path) -> None:
        self._texts = {path.stem: path.read_text("utf-8") for path in folder.glob("*.ll")}

    def source(self, name: str, functions: Sequence[str] = ()) -> Source:
        """Return a file as a Source of `functions`, by default of the one with the file's name."""
        text = self._texts[name]
        identity = f"shipped {hashlib.sha256(text.encode()).hexdigest()}"
        return Source(
            identity, partial(_with_target, text), tuple(functions) or (name,), loops=True
        )


CORE = Shipped(Path(__file__).parents[1] / "core")


def _with_target(text: str) -> str:
    """Return the IR with its target triple and data layout, which LLVM's passes need."""
    layout = _emitter().target_data
    return f'target datalayout = "{layout}"\ntarget triple = "{target().triple}"\n{text}'
