"""A run of all tests tries every quick case, a part of the slow ones, and a sample of each.

A test function is slow if its cases take 0.2 s of processor time together, or more. `slow.txt`,
beside this file, lists these functions with their times; `make times` measures and writes it. The
cases of a slow function are dealt out to the parts, so that all parts take about the same time.
Besides, each run tries as many cases of a function as take 0.1 s, at least one if it takes 0.15 s:
of nine changes of the source that only slow cases had noticed, these notice six.

Environment variables choose what is tried:

PYDY_PART : the number of the part (0 without it; larger numbers count modulo 48), or "all"
PYDY_FURTHER_PARTS : a number; try no quick cases, and this many parts after that one
PYDY_RECORD_TIMES : anything; write the table when the run has ended
PYDY_WHOLE_FILES : files, separated by spaces, of which all cases are tried (`make test-near`)
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

import pytest

COLLECTED = pytest.StashKey[list[str]]()
PARTS = 48
LIMIT = 0.2
# Seconds of the cases of a slow function that each run tries, and of one that it tries alone.
SAMPLE, SINGLE = 0.1, 0.15
# Functions that draw a part of their inputs themselves: every run tries each of their cases.
DRAWING = {"tests/fuzz/test_arguments.py::test_what_does_not_fit_is_named_and_what_fits_is_right"}
# A folder whose tests only run where it is named (`norecursedirs` in pyproject.toml).
ASKED_FOR = "tests/browser/"
TABLE = Path(__file__).with_name("slow.txt")

_PART = os.environ.get("PYDY_PART", "0")
WHOLE = _PART == "all"
PART = 0 if WHOLE else int(_PART)
RECORD = "PYDY_RECORD_TIMES"
RECORDING = RECORD in os.environ
FURTHER_PARTS = int(os.environ.get("PYDY_FURTHER_PARTS", "0"))
_FILES = os.environ.get("PYDY_WHOLE_FILES")
WHOLE_FILES = None if _FILES is None else tuple(_FILES.split())


def drawn(index: int, parts: int) -> bool:
    """Whether the item with this index is in the part that this run tries."""
    return WHOLE or index % parts == PART % parts


def function_of(nodeid: str) -> str:
    """Return the name of the test function that a case belongs to."""
    return nodeid.partition("[")[0]


def read_table() -> dict[str, float]:
    """Return the slow functions and the seconds that all their cases take."""
    lines = TABLE.read_text(encoding="utf-8").splitlines()
    rows = (line.split(maxsplit=1) for line in lines if not line.startswith("#"))
    return {name: float(seconds) for seconds, name in rows}


def loop_time_of_table() -> float:
    """Return what ten million turns of a Python loop took where the table was recorded."""
    return float(TABLE.read_text(encoding="utf-8").partition(" took ")[2].split()[0])


def write_table(seconds: dict[str, float], loop_time: float) -> None:
    """Write the slow functions, and how fast the machine is."""
    slow = sorted((f, time) for f, time in seconds.items() if time >= LIMIT and f not in DRAWING)
    rows = [f"{time:5.1f} {name}\n" for name, time in slow]
    header = f"# seconds; ten million turns of a Python loop took {loop_time:.2f} s\n"
    TABLE.write_text(header + "".join(rows), encoding="utf-8")


def dealt(cases: Iterable[str], seconds: dict[str, float]) -> dict[str, int]:
    """Return the part of each case of a slow function.

    Of a function with fewer cases than parts, a case is tried in as many parts as it has cases.
    The functions are dealt out in descending order of time, each to where the load is least.
    """
    grouped: dict[str, list[str]] = {}
    for case in cases:
        if (function := function_of(case)) in seconds:
            grouped.setdefault(function, []).append(case)
    loads = [0.0] * PARTS
    parts = {}
    for function in sorted(grouped, key=lambda name: (-seconds[name], name)):
        group = grouped[function]
        each = seconds[function] / len(group)
        first = min(range(PARTS), key=loads.__getitem__)
        for index, case in enumerate(group):
            part = (first + index) % PARTS
            parts[case] = part
            loads[part] += each
    return parts


def sampled(cases: Iterable[str], seconds: dict[str, float], mine: set[str]) -> set[str]:
    """Return cases of slow functions that each run tries besides `mine`, those of its part.

    Which ones depends on the part.
    """
    grouped: dict[str, list[str]] = {}
    for case in cases:
        if (function := function_of(case)) in seconds:
            grouped.setdefault(function, []).append(case)
    chosen = set()
    for function, group in grouped.items():
        each = seconds[function] / len(group)
        count = min(len(group), max(int(SAMPLE / each), each <= SINGLE))
        others = [case for case in group if case not in mine]
        count = max(0, count - (len(group) - len(others)))
        chosen |= {others[(PART * count + k) % len(others)] for k in range(count)}
    return chosen


def tried(cases: Iterable[str]) -> set[str]:
    """Return the cases that this run tries, as the environment variables say."""
    cases = list(cases)
    if WHOLE and not FURTHER_PARTS:
        return set(cases)
    seconds = read_table()
    parts = dealt(cases, seconds)
    if FURTHER_PARTS:
        wanted = {(PART + k) % PARTS for k in range(1, FURTHER_PARTS + 1)}
        further = {case for case, part in parts.items() if part in wanted}
        return further | {case for case in cases if function_of(case) in DRAWING}
    mine = {case for case in cases if parts.get(case, PART % PARTS) == PART % PARTS}
    mine |= sampled(cases, seconds, mine)
    return mine | {case for case in cases if case.partition("::")[0] in (WHOLE_FILES or ())}
