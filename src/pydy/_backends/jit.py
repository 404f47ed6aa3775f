"""LLVM, once per process: IR text in, addresses out."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from functools import cache
from typing import Any

from llvmlite import binding

__all__ = ["Code", "load"]

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


@cache
def _initialised() -> None:
    binding.initialize_native_target()
    binding.initialize_native_asmprinter()


def _target_machine(level: int) -> Any:
    _initialised()
    target = binding.Target.from_default_triple()
    return target.create_target_machine(
        cpu=binding.get_host_cpu_name(),
        features=binding.get_host_cpu_features().flatten(),
        opt=level,
        codemodel="jitdefault",
        jit=True,
    )


def _object_code(text: str, level: int) -> bytes:
    """Optimise and compile a module of IR text."""
    machine = _target_machine(level)
    module = binding.parse_assembly(text)
    tuning = binding.create_pipeline_tuning_options(speed_level=level)
    tuning.slp_vectorization = False  # measured: no faster on expression code, twice as slow to run
    passes = binding.create_pass_builder(machine, tuning)
    passes.getModulePassManager().run(module, passes)
    code: bytes = machine.emit_object(module)
    return code


def load(text: str, names: Sequence[str], level: int = 2) -> Code:
    """Compile IR text and return the addresses of the functions `names`.

    Parameters
    ----------
    text : str
        A module; functions of libm and of Python's C interface are known by their names.
    names : sequence of str
    level : {0, 1, 2, 3}
        LLVM's effort.
    """
    with _LOCK:
        code = _object_code(text, level)
        engine = binding.create_mcjit_compiler(binding.parse_assembly(""), _target_machine(level))
        engine.add_object_file(binding.ObjectFileRef.from_data(code))
        engine.finalize_object()
        return Code(engine, names)
