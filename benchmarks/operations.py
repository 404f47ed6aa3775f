"""Operations in M and F, set-up and at every call, against SymPy's `cse`.

Needs neither peers nor a quiet machine: the counts are deterministic.
"""

from __future__ import annotations

import argparse
import time
from typing import Any

from harness import frozen
from harness.model import Model
from harness.program import assembly_of
from harness.report import save, seconds, table

from pydy._assembly.programs import block_program
from pydy._graph.passes import names, rewriting


def main() -> None:
    """Count, print a table and write the results."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--models", nargs="+", default=frozen.names())
    parser.add_argument("--kinds", action="store_true", help="print the run stage by kind")
    parser.add_argument("--no-passes", action="store_true", help="skip the effect of each pass")
    options = parser.parse_args()

    results = [_count(frozen.read(name), not options.no_passes) for name in options.models]
    rows = []
    for line in results:
        run, cse = sum(line["run"].values()), line["cse"]
        ratio = f"{run / cse:.3f}" if cse else "–"
        rates = sum(line["rates"]["run"].values())
        setup = sum(line["setup"].values())
        rows.append((line["model"], cse or "–", setup, run, ratio, rates, seconds(line["seconds"])))
    header = ("model", "cse", "set-up", "run", "run / cse", "run with solve", "time")
    table("Operations in M and F", header, rows)
    if not options.no_passes:
        names = list(results[0]["without"])
        rows = [
            (line["model"], sum(line["rates"]["run"].values()), *line["without"].values())
            for line in results
        ]
        header = ("model", "all", *(f"no {name}" for name in names))
        table("With the solve, at every call, one pass left out", header, rows)
    if options.kinds:
        for line in results:
            kinds = ", ".join(f"{v} {k}" for k, v in sorted(line["run"].items()))
            print(f"  {line['model']}: {kinds}")
    save("operations", results)


def _count(model: Model, passes: bool) -> dict[str, Any]:
    start = time.perf_counter()
    assembly = assembly_of(model)
    program = block_program(assembly, "mass_matrix", "forcing")
    count = program.operation_count
    elapsed = time.perf_counter() - start
    whole = block_program(assembly, "rates")
    return {
        "model": model.name,
        "cse": model.about.get("cse_operations"),
        "sympy": model.about["sympy"],
        "setup": dict(count["setup"]),
        "run": dict(count["run"]),
        "rates": {stage: dict(c) for stage, c in whole.operation_count.items()},
        "digest": program.digest,
        "seconds": elapsed,
        "without": _without_each(model) if passes else {},
    }


def _without_each(model: Model) -> dict[str, int]:
    """Return the operations at every call with one pass or strategy left out, or all passes."""
    chosen = {name: frozenset({name}) for name in names()} | {"passes": rewriting()}
    counts = {}
    for name, switched in chosen.items():
        count = block_program(assembly_of(model, off=switched), "rates").operation_count
        counts[name] = sum(count["run"].values())
    return counts


if __name__ == "__main__":
    main()
