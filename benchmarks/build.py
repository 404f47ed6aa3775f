"""From bodies to the first number, stage by stage, with an empty cache.

Set-up is SymPy's: frames, points and vectors. Forming, simplifying and lowering are those of the
right-hand side alone, compiling is the quick tier that a first call waits for. Times are of the
processor, medians of several builds in one process.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from itertools import pairwise
from statistics import median
from typing import Any

os.environ["PYDY_CACHE_DIR"] = "off"

import numpy as np
from harness.report import save
from trees import HUMANOID, definition, rods, tree

from pydy._backends.registry import compile_program
from pydy._collector import collector_paused
from pydy._graph.lowering import lower
from pydy.examples import whipple_bicycle
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System

STAGES = ("set up", "form", "simplify", "lower", "compile")


def models() -> dict[str, Any]:
    """Return what sets up each model."""
    rng = np.random.default_rng(3)
    humanoid = tree(HUMANOID, rng, aligned=True)
    arm = tree(list(range(-1, 6)), rng, aligned=True)
    return {
        "pendulum, 20 links": lambda: _definition(n_link_pendulum_on_cart, 20),
        "pendulum, 50 links": lambda: _definition(n_link_pendulum_on_cart, 50),
        "pendulum, 100 links": lambda: _definition(n_link_pendulum_on_cart, 100),
        "5 rods in space": lambda: rods(5),
        "10 rods in space": lambda: rods(10),
        "20 rods in space": lambda: rods(20),
        "100 springs": lambda: _definition(multi_mass_spring_damper, 100),
        "200 springs": lambda: _definition(multi_mass_spring_damper, 200),
        "arm of 7 joints, in space": lambda: definition(arm),
        "tree of 29 joints": lambda: definition(humanoid),
        "bicycle": lambda: whipple_bicycle.derive().definition,
    }


def _definition(make: Any, n: int) -> Any:
    """Return the definition of a sample system, without forming its equations."""
    taken: list[Any] = []

    def take(definition: Any) -> None:
        taken.append(definition)

    module = sys.modules[make.__module__]
    original, module._system = module._system, take  # type: ignore[attr-defined]
    try:
        make(n)
    finally:
        module._system = original  # type: ignore[attr-defined]
    return taken[0]


def timed(set_up: Any) -> tuple[dict[str, float], int]:
    """Return the seconds of each stage, and the operations of the right-hand side."""
    clock, marks = time.process_time, []
    marks.append(clock())
    source = set_up()
    marks.append(clock())
    system = System(source)
    assembly = system.model.assembly
    marks.append(clock())
    graph, nodes = assembly.simplified("rates")
    marks.append(clock())
    with collector_paused():
        blocks = [("rates", (len(nodes),), nodes)]
        program = lower(graph, assembly.sizes, blocks)
    marks.append(clock())
    compile_program(program, "llvm", {})
    marks.append(clock())
    spent = [b - a for a, b in pairwise(marks)]
    return dict(zip(STAGES, spent, strict=True)), sum(program.operation_count["run"].values())


def main() -> None:
    """Print a table, and write it beside the other results."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--models", nargs="+", default=list(models()), choices=list(models()))
    options = parser.parse_args()
    print(f"{'':26}" + "".join(f"{stage:>10}" for stage in (*STAGES, "all", "operations")))
    found = {}
    every = models()
    for name in options.models:
        set_up = every[name]
        runs = [timed(set_up) for _ in range(options.repeats)]
        times = {stage: median(run[0][stage] for run in runs) for stage in STAGES}
        found[name] = {**times, "operations": runs[0][1]}
        cells = [*times.values(), sum(times.values())]
        print(f"{name:26}" + "".join(f"{c:9.2f}s" for c in cells) + f"{runs[0][1]:10}", flush=True)
    save("build", found)


if __name__ == "__main__":
    main()
