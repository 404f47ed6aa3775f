"""How costs grow: a chain of masses, 20 to 50 links, and a second process that finds code on disk.

Needs no peers. Times are of this project alone, medians of a few runs.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from harness import frozen
from harness.model import Model
from harness.models import spring_chain
from harness.program import assembly_of, equations_of
from harness.report import save, seconds, table
from harness.samples import samples
from harness.serve import in_child, time_of

from pydy._assembly.programs import block_program
from pydy._backends.llvm.native import LLVMBackend

MASSES = (10, 30, 100, 300)
LARGE = ("pendulum-20", "pendulum-50", "rods-10")
STORED = ("pendulum-5", "pendulum-10", "pendulum-20", "pendulum-50", "bicycle", "rider-bicycle")


def main() -> None:
    """Measure, print tables and write the results."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--child", metavar="MODEL", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.child:
        _warm_up()
        print(json.dumps(_build_with_cache(options.child)))
        return
    _warm_up()
    springs = [_spring(n, absolute, options.rounds) for absolute in (True, False) for n in MASSES]
    header = ("model", "operations", "a mass", "scalar", "a mass", "batched", "a mass", "build")
    rows = [
        (
            s["model"],
            *(s["operations"], f"{s['operations'] / s['masses']:.1f}"),
            *(seconds(s["scalar"]), seconds(s["scalar"] / s["masses"])),
            *(seconds(s["batched"]), seconds(s["batched"] / s["masses"])),
            seconds(s["build"]),
        )
        for s in springs
    ]
    table("Chains of masses, the whole right-hand side", header, rows)
    large = {name: _build_times(name, options.rounds) for name in LARGE}
    first = median(large[LARGE[0]])
    rows = [(name, seconds(median(t)), f"{median(t) / first:.1f}") for name, t in large.items()]
    table("Build plus compile, nothing cached", ("model", "time", f"/ {LARGE[0]}"), rows)
    stored = {name: _two_processes(name, options.rounds) for name in STORED}
    rows = [
        (name, seconds(median(a)), seconds(median(b)), f"{median(b) / median(a):.2f}")
        for name, (a, b) in stored.items()
    ]
    header = ("model", "first process", "second", "ratio")
    table("From equations to the best machine code, by way of the cache on disk", header, rows)
    save("scaling", {"springs": springs, "large": large, "stored": stored})


def _warm_up() -> None:
    """Load LLVM and the routines that all models share."""
    program = block_program(assembly_of(frozen.read("pendulum-1")), "rates")
    LLVMBackend().compile(program).link()


def _spring(n: int, absolute: bool, rounds: int) -> dict[str, Any]:
    model = spring_chain(n, absolute=absolute)
    program = block_program(assembly_of(model), "rates")
    result = {
        "model": model.name,
        "masses": n,
        "operations": sum(program.operation_count["run"].values()),
        "build": median(_times_of_builds(model, rounds)),
    }
    count = 16384 // n // 8 * 8  # states that stay in the cache of the processor
    x, r, p = samples(model, count)
    t = np.zeros(count)
    for kind, lanes, order in (("scalar", 1, "C"), ("batched", 8, "F")):
        kernel = LLVMBackend(lanes=lanes).compile(program)
        kernel.link()
        states, inputs = np.asarray(x, order=order), np.asarray(r, order=order)
        kernel.evaluate(t, states, inputs, p)
        taken = []
        for _ in range(20 * rounds):
            start = time.perf_counter()
            kernel.evaluate(t, states, inputs, p)
            taken.append(time.perf_counter() - start)
        result[kind] = median(taken) / count
    return result


def _build_times(name: str, rounds: int) -> list[float]:
    return _times_of_builds(frozen.read(name), rounds)


def _times_of_builds(model: Model, rounds: int) -> list[float]:
    """Return the seconds from SymPy expressions to machine code, each in a fork of the process."""
    equations = equations_of(model)

    def build() -> None:
        kernel = LLVMBackend().compile(block_program(assembly_of(model, equations), "rates"))
        kernel.link()

    return [in_child(lambda: time_of(build)) for _ in range(rounds)]


def _two_processes(name: str, rounds: int) -> tuple[list[float], list[float]]:
    """Return the times of processes with an empty cache, and of those that come after."""
    times: tuple[list[float], list[float]] = ([], [])
    for _ in range(rounds):
        with tempfile.TemporaryDirectory() as folder:
            environment = {**os.environ, "PYDY_CACHE_DIR": folder}
            for taken in times:
                command = [sys.executable, Path(__file__), "--child", name]
                out = subprocess.run(command, env=environment, check=True, capture_output=True)
                taken.append(json.loads(out.stdout))
    return times


def _build_with_cache(name: str) -> float:
    """Return the seconds from SymPy expressions to machine code, as generated functions do it."""
    from pydy._assembly.program_cache import stored_program

    model = frozen.read(name)
    equations = equations_of(model)

    def build() -> None:
        assembly = assembly_of(model, equations)
        program = stored_program(assembly, "rates", lambda: block_program(assembly, "rates"))
        LLVMBackend().compile(program).link()

    return time_of(build)


if __name__ == "__main__":
    main()
