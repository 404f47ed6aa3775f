"""Results of several processors and targets side by side: ``python benchmarks/beside.py``.

Reads what benchmarks have written to ``build/benchmarks``, and copies from other machines that lie
there under names of their own: ``peers-laptop.json`` beside ``peers.json``. A column is one file.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from harness.driver import BUILD
from harness.report import label, pairwise, read_beside, table

Ratios = Iterator[tuple[str, float]]


def _peers(lines: list[dict[str, Any]]) -> Ratios:
    """Give our time over the fastest peer's; build times over heyoka's."""
    for line in lines:
        times = line["seconds"]
        ratios = {
            name: pairwise(times["ours"], taken)
            for name, taken in times.items()
            if "ours" in times and not name.startswith("ours")
        }
        if line["kind"] == "build":
            ratios = {name: ratio for name, ratio in ratios.items() if name == "heyoka"}
        if ratios:
            yield f"{line['kind']}, {line['model']}", max(ratios.values())


def _solvers(results: dict[str, Any]) -> Ratios:
    """Give our time at equal error over the fastest peer's."""
    for line in results.get("precision", ()):
        if line.get("ratio") is not None:
            yield f"{line['model']} at {line['target']:g}", line["ratio"]


def _ensembles(results: dict[str, Any]) -> Ratios:
    """Give our trajectories a second at equal error over heyoka's."""
    for name, part in results.items():
        for line in part.get("targets", ()):
            yield f"{name} at {line['target']:g}", line["ratio"]


RATIOS: dict[str, Callable[[Any], Ratios]] = {
    "peers": _peers,
    "solvers": _solvers,
    "ensembles": _ensembles,
}


def main() -> None:
    """Print a table for each benchmark that has results."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--folder", type=Path, default=BUILD)
    options = parser.parse_args()
    for name, ratios in RATIOS.items():
        found = read_beside(name, options.folder)
        if not found:
            continue
        columns = [dict(ratios(results)) for _, results in found]
        names = dict.fromkeys(row for column in columns for row in column)
        rows = [[row, *(f"{c[row]:.2f}" if row in c else "–" for c in columns)] for row in names]
        table(str(ratios.__doc__).rstrip("."), ("", *(label(about) for about, _ in found)), rows)


if __name__ == "__main__":
    main()
