"""Tables on the terminal, results as JSON in ``build/benchmarks``."""

from __future__ import annotations

import json
import os
import platform
import re
import subprocess
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
    """Write results, with where and when they were taken.

    Those for another target than this machine's lie beside, as ``NAME-TARGET.json``; those that
    another machine took are kept as ``NAME-WHEN.json``.
    """
    BUILD.mkdir(parents=True, exist_ok=True)
    about = {
        "taken": datetime.now(UTC).isoformat(timespec="seconds"),
        "machine": platform.machine(),
        "processor": processor(),
        "target": os.environ.get("PYDY_CPU", "native"),
        "cores": os.cpu_count(),
        "load_average": os.getloadavg() if hasattr(os, "getloadavg") else None,
        "python": platform.python_version(),
    }
    target = "" if about["target"] == "native" else f"-{about['target']}"
    path = BUILD / f"{name}{target}.json"
    if path.exists():
        before = json.loads(path.read_text())["about"]
        if before["processor"] != about["processor"]:
            when = re.sub(r"\W", "", before["taken"])
            path.rename(path.with_stem(f"{path.stem}-{when}"))
    path.write_text(json.dumps({"about": about, "results": results}, indent=1) + "\n")
    print(f"written to {path}", file=sys.stderr)
    return path


def read_beside(name: str, folder: Path) -> list[tuple[dict[str, Any], Any]]:
    """Return all results of a benchmark in a folder, each with where it was taken."""
    files = sorted(folder.glob(f"{name}.json")) + sorted(folder.glob(f"{name}-*.json"))
    found = [json.loads(file.read_text()) for file in files]
    return [(each["about"], each["results"]) for each in found]


def label(about: dict[str, Any]) -> str:
    """Return a processor's name, and the vectors that code was written for."""
    name, features = about["processor"]["name"], about["processor"]["features"]
    if about["target"] == "generic":
        return f"{name}, generic"
    widest = {"avx512vl": "AVX-512", "avx2": "AVX2", "sve": "SVE", "asimd": "NEON"}
    if about["target"] == "x86-64-v3":
        widest.pop("avx512vl")
    return f"{name}, {next((w for f, w in widest.items() if f in features), 'no vectors')}"


def processor() -> dict[str, Any]:
    """Return the processor's name, its vector extensions, and the sizes of its caches."""
    if sys.platform == "darwin":
        return {"name": _sysctl("machdep.cpu.brand_string"), "features": [], "caches": _apples()}
    fields: dict[str, str] = {}
    info = Path("/proc/cpuinfo")
    for line in info.read_text().splitlines() if info.exists() else ():
        key, _, value = line.partition(":")
        fields.setdefault(key.strip(), value.strip())
    flags = (fields.get("flags") or fields.get("Features") or "").split()
    return {
        "name": fields.get("model name") or platform.processor() or platform.machine(),
        "features": sorted(flag for flag in flags if flag.startswith(_VECTORS)),
        "caches": _caches(Path("/sys/devices/system/cpu/cpu0/cache")),
    }


# What decides how wide and with which instructions code is written.
_VECTORS = ("avx", "fma", "sse4", "asimd", "sve", "neon")


def _caches(folder: Path) -> dict[str, str]:
    """Return sizes by level and kind, as Linux tells them: ``{'L1 Data': '32K'}``."""
    found = {}
    for place in sorted(folder.glob("index*")):
        level, kind, size = ((place / n).read_text().strip() for n in ("level", "type", "size"))
        found[f"L{level} {kind}"] = size
    return found


def _apples() -> dict[str, str]:
    names = {
        "L1 Instruction": "l1icachesize",
        "L1 Data": "l1dcachesize",
        "L2 Unified": "l2cachesize",
    }
    return {name: _sysctl(f"hw.{key}") for name, key in names.items()}


def _sysctl(name: str) -> str:
    command = ["/usr/sbin/sysctl", "-n", name]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()
