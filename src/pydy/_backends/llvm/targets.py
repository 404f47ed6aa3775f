"""The target processor of the machine code, and the limits that follow from its registers.

It is this machine's, unless the environment variable PYDY_CPU names another that this machine can
run: code for processors without AVX-512 is so tested and measured on one that has it. The target is
part of every key of the cache.
"""

from __future__ import annotations

import os
from collections.abc import Collection
from dataclasses import dataclass

from llvmlite import binding

from pydy._forks import once


@dataclass(frozen=True)
class VectorRegisters:
    """The vector registers of a kind of processor."""

    feature: str  # a feature, in LLVM's spelling, that only such processors have; empty for any
    count: int
    doubles: int  # doubles in a register
    # Most lanes of straight-line code that does not fit in the registers: wider kernels process
    # the lanes in groups. At this width the registers hold a dozen values.
    widest: int
    # Operations up to which code of that many lanes is one basic block, in which LLVM allocates
    # the registers.
    one_block_limit: int


# The first that fits. Instructions for each state of eight, and how many of them read or write the
# stack, in code of one part of eight lanes and of two parts of four, without AVX-512; and the time
# of one basic block of four lanes: see docs/decisions/21-processors.md.
TABLE = (
    VectorRegisters("avx512vl", 32, 8, 8, 0),
    VectorRegisters("avx", 16, 4, 4, 3000),
    VectorRegisters("neon", 32, 2, 4, 0),
    VectorRegisters("", 16, 2, 2, 0),
)

# What the levels of x86-64 add to any 64-bit processor (System V ABI, AMD64 supplement, 3.1.1), in
# LLVM's words, as far as compilers use it.
_V3 = frozenset(
    {
        *("avx", "avx2", "bmi", "bmi2", "cx16", "f16c", "fma", "lzcnt", "movbe", "popcnt"),
        *("sse3", "sse4.1", "sse4.2", "ssse3"),
    }
)
_V4 = _V3 | {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"}
_LEVELS = {"x86-64-v3": _V3, "x86-64-v4": _V4}
_NAMES = ("native", "generic", *_LEVELS)


@dataclass(frozen=True)
class CodeTarget:
    """The target of LLVM's code."""

    name: str  # the value of PYDY_CPU
    triple: str  # triple, processor, features: in LLVM's spelling
    processor: str
    features: str
    registers: VectorRegisters

    def vectors(self, lanes: int) -> int:
        """Return the number of vectors of `lanes` doubles that fit in the registers."""
        return self.registers.count // max(lanes // self.registers.doubles, 1)


def registers_for(features: Collection[str], machine: str) -> VectorRegisters:
    """Return the row of the table for some features of an architecture."""
    if machine in ("aarch64", "arm64"):
        features = {*features, "neon"}  # present in all of these, but not always listed
    return next(row for row in TABLE if not row.feature or row.feature in features)


def chosen(name: str, machine: str, processor: str, features: Collection[str]) -> CodeTarget:
    """Return the named target on a machine: triple, processor and its features.

    'native' is this machine's processor; 'generic' any of its architecture; 'x86-64-v3' and
    'x86-64-v4' any of a level of x86-64.
    """
    if name not in _NAMES:
        raise ValueError(
            f"The environment variable PYDY_CPU is {name!r}, but it must be one of "
            f"{', '.join(map(repr, _NAMES))}."
        )
    architecture = machine.partition("-")[0]
    if name == "native":
        flags = ",".join(f"+{feature}" for feature in sorted(features))
        return CodeTarget(name, machine, processor, flags, registers_for(features, architecture))
    if name == "generic":
        baseline = "x86-64" if architecture == "x86_64" else "generic"
        return CodeTarget(name, machine, baseline, "", registers_for((), architecture))
    missing = sorted(_LEVELS[name].difference(features))
    if architecture != "x86_64" or missing:
        foreign = architecture != "x86_64"
        lacks = "it is none of x86-64" if foreign else f"{processor} lacks {', '.join(missing)}"
        raise ValueError(
            f"The environment variable PYDY_CPU is {name!r}, but this machine cannot run code for "
            f"that: {lacks} ({machine}). Unset it, or use 'native' or 'generic'."
        )
    # Vectors as wide as the registers, which LLVM would not use for every processor of that level.
    flags = "-prefer-256-bit" if name == "x86-64-v4" else ""
    return CodeTarget(name, machine, name, flags, registers_for(_LEVELS[name], architecture))


@once
def target() -> CodeTarget:
    """Return the target of this process, and set LLVM up."""
    binding.initialize_native_target()
    binding.initialize_native_asmprinter()
    features = [name for name, available in binding.get_host_cpu_features().items() if available]
    name = os.environ.get("PYDY_CPU") or "native"
    return chosen(name, binding.get_default_triple(), binding.get_host_cpu_name(), features)
