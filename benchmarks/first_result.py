"""From the start of a process to its first result, part by part, with an empty and a full cache.

Processor seconds. `libraries` are the imports of SymPy and NumPy. With ``--before SRC``, the
``src`` folder of another version of the package runs in turn with this one.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median

from harness.driver import BENCHMARKS, ROOT, in_turn
from harness.report import pairwise, save, table

WAYS = (
    ("pendulum", "odeint"),
    ("pendulum", "dop853"),
    ("bicycle", "odeint"),
    ("20 links", "odeint"),
    ("arm from URDF", "odeint"),
    ("closed loop", "odeint"),
)
PARTS = ("sympy", "numpy", "pydy", "model", "integrate", "all")
LIBRARIES = ("sympy", "numpy")


def run(src: Path, model: str, solver: str, cache: str) -> dict[str, float]:
    """Return the seconds of each part in a new process."""
    script = BENCHMARKS / "workers" / "first_result.py"
    done = subprocess.run(
        [sys.executable, script, model, solver],
        env={**os.environ, "PYTHONPATH": str(src), "PYDY_CACHE_DIR": cache},
        capture_output=True,
        text=True,
        check=True,
    )
    parts: dict[str, float] = json.loads(done.stdout.splitlines()[-1])
    return {**parts, "ours": parts["all"] - sum(parts[name] for name in LIBRARIES)}


def main() -> None:
    """Print a table for each kind of cache, and write the results beside the others."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--before", type=Path, help="the `src` folder of another version")
    parser.add_argument("--quick", action="store_true", help="a single round")
    options = parser.parse_args()
    rounds = 1 if options.quick else options.rounds
    versions = {"now": ROOT / "src"} | ({"before": options.before} if options.before else {})
    results = []
    for cache in ("empty", "full"):
        rows = []
        for model, solver in WAYS:
            with tempfile.TemporaryDirectory() as folder:

                def measure(name: str, folder: str = folder) -> dict[str, float]:
                    if cache == "full":  # noqa: B023
                        return run(versions[name], model, solver, f"{folder}/{name}")  # noqa: B023
                    with tempfile.TemporaryDirectory() as empty:
                        return run(versions[name], model, solver, empty)  # noqa: B023

                measures = {name: lambda name=name: measure(name) for name in versions}
                in_turn(measures, least=1, most=1)  # files are in memory, and a cache is filled
                taken = in_turn(measures, least=rounds, most=rounds)
            seconds = {
                name: {part: [one[name][part] for one in taken] for part in taken[0][name]}
                for name in versions
            }
            results.append({"model": model, "solver": solver, "cache": cache, "seconds": seconds})
            now = seconds["now"]
            ours = pairwise(
                now["ours"], [a - b for a, b in zip(now["all"], now["ours"], strict=True)]
            )
            row = [
                f"{model}, {solver}",
                *(f"{median(now[part]):.2f}" for part in PARTS),
                f"{ours:.2f}",
            ]
            if before := seconds.get("before"):
                row += [f"{pairwise(now[part], before[part]):.2f}" for part in ("ours", "all")]
            rows.append(row)
        header = ["", *PARTS, "ours / libraries"]
        header += ["ours / before", "all / before"] if options.before else []
        table(f"First result, {cache} cache, processor seconds", header, rows)
    save("first_result", results)


if __name__ == "__main__":
    main()
