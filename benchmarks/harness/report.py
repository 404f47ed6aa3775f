"""Tables on the terminal, results as JSON in ``build/benchmarks``."""

from __future__ import annotations

import json
import os
import platform
import sys
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from statistics import median
from typing import Any

from harness.driver import BUILD


def pairwise(top: Sequence[float], bottom: Sequence[float]) -> float:
    """Return the median of the ratios taken pair by pair."""
    return median(a / b for a, b in zip(top, bottom, strict=True))


def seconds(value: float | None) -> str:
    """Return a duration with three digits and a unit."""
    if value is None:
        return "–"
    for factor, unit in ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs")):
        if value >= factor:
            return f"{value / factor:.3g} {unit}"
    return f"{value * 1e9:.3g} ns"


def table(title: str, header: Sequence[str], rows: Sequence[Sequence[Any]]) -> None:
    """Print a table, the first column left-aligned, the others right-aligned."""
    cells = [[str(c) for c in row] for row in (header, *rows)]
    widths = [max(len(row[k]) for row in cells) for k in range(len(header))]
    print(f"\n{title}")
    for index, row in enumerate(cells):
        parts = [c.ljust(w) if k == 0 else c.rjust(w) for k, (c, w) in enumerate(zip(row, widths))]  # noqa: B905
        print("  " + "   ".join(parts).rstrip())
        if index == 0:
            print("  " + "   ".join("-" * w for w in widths))


def save(name: str, results: Any) -> Path:
    """Write results, with where and when they were taken."""
    BUILD.mkdir(parents=True, exist_ok=True)
    path = BUILD / f"{name}.json"
    about = {
        "taken": datetime.now(UTC).isoformat(timespec="seconds"),
        "machine": platform.machine(),
        "processor": _processor(),
        "cores": os.cpu_count(),
        "load_average": os.getloadavg(),
        "python": platform.python_version(),
    }
    path.write_text(json.dumps({"about": about, "results": results}, indent=1) + "\n")
    print(f"written to {path}", file=sys.stderr)
    return path


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    if info.exists():
        for line in info.read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor()
