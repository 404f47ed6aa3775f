"""The command line that benchmarks share: environments, how long to measure, and on which core."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

from harness.driver import ROOT
from harness.report import save

_PYTHONS = {
    "--peer-python": (ROOT / ".venv-peers/bin/python", "the peers'"),
    "--reference": (ROOT / ".venv-reference/bin/python", "that of the released pydy"),
    "--python": (Path(sys.executable), "ours"),
}


def add_pythons(parser: argparse.ArgumentParser, *names: str) -> None:
    """Add options for the interpreters of environments: some of `_PYTHONS`."""
    for name in names:
        default, whose = _PYTHONS[name]
        parser.add_argument(name, type=Path, default=default, help=whose)


def add_measuring(
    parser: argparse.ArgumentParser, *, budget: float, timeout: float | None = None
) -> None:
    """Add options for how measures are taken; `timeout` is None where nothing is given up."""
    parser.add_argument("--budget", type=float, default=budget, help="seconds for each line")
    if timeout is not None:
        parser.add_argument("--timeout", type=float, default=timeout, help="for any one answer")
    parser.add_argument("--quick", action="store_true", help="one round each, to try the script")
    last = max(os.sched_getaffinity(0))
    parser.add_argument("--core", type=int, default=last, help="bind all to this one")


def rounds(options: argparse.Namespace, least: int = 3, most: int = 15) -> dict[str, Any]:
    """Return the limits for `in_turn`: one round where the script is only tried."""
    if options.quick:
        return {"least": 1, "most": 1}
    return {"least": least, "most": most, "budget": options.budget}


def take_parts(
    name: str,
    parts: Iterable[str],
    measures: Mapping[str, Callable[[argparse.Namespace], Iterable[Any]]],
    options: argparse.Namespace,
) -> None:
    """Take the measures of each part, and write the results so far whenever there are more.

    A run can then be broken off. A measure yields the lines that it adds to the results.
    """
    results: dict[str, list[Any]] = {}
    for part in parts:
        results[part] = []
        for lines in measures[part](options):
            results[part] += lines
            save(name, results)
