"""Calls that differ in one thing from the one before, over the same call; ``make bench-calls``.

A second `integrate` with other tolerances, times or constants prepares what depends on them; an
event that never happens and a contact that stays open cost something beside the integration, and
so do eight columns of sensitivities.
Each line is a difference in microseconds, or a ratio, of calls that are taken in turn. With
``--before SRC``, the ``src`` folder of another version of the package is measured in turn with
this one.
"""

from __future__ import annotations

import argparse
import itertools
import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
import sympy as sm
from harness.driver import BENCHMARKS, ROOT
from harness.options import add_measuring
from harness.report import save, table

from pydy import System
from pydy.contact import Contacts, Unilateral
from pydy.models import n_link_pendulum_on_cart
from pydy.solvers import Event

LINKS = (1, 5)
MOTIONS = {"1 s, 101 times": (1.0, 101), "10 s, 1,001 times": (10.0, 1001)}
GOALS = {"µs": 50.0, "ratio": 1.05, "columns": 2.5}
LEAST = 0.01  # s of a measurement


def pendulum(links: int, motion: str) -> System:
    """Return a pendulum on a cart that swings freely."""
    end, number = MOTIONS[motion]
    system = n_link_pendulum_on_cart(links, cart_force=False)
    system.constants = {c: 9.81 if c.name == "g" else 1.0 / links for c in system.constants_symbols}
    system.initial_conditions = dict.fromkeys(system.coordinates[1:], 0.3)
    system.times = np.linspace(0.0, end, num=number)
    system.ode_solver = "dop853"
    return system


def repeated(links: int, motion: str) -> dict[str, tuple[Callable[[], Any], Callable[[], Any]]]:
    """Return pairs of calls: one that changes something each time, and the same call unchanged."""
    system = pendulum(links, motion)
    mass = next(c for c in system.constants_symbols if c.name == "m0")
    end, number = MOTIONS[motion]
    # The motions of a pair take equally many steps: only what is prepared differs.
    tolerances = itertools.cycle((1e-8, 1e-8 * (1.0 + 1e-9)))
    masses = itertools.cycle((1.0 / links, (1.0 + 1e-12) / links))
    times = itertools.cycle((system.times, np.linspace(0.0, end, num=number - 1)))

    def other_constant() -> None:
        system.constants[mass] = next(masses)
        system.integrate(rtol=1e-8, atol=1e-8)

    def other_times() -> None:
        system.times = next(times)
        system.integrate(rtol=1e-8, atol=1e-8)

    def same() -> None:
        system.integrate(rtol=1e-8, atol=1e-8)

    return {
        "other tolerances": (
            lambda: system.integrate(rtol=next(tolerances), atol=1e-8),
            same,
        ),
        "another constant": (other_constant, same),
        "times of another length": (other_times, same),
    }


def inactive(links: int, motion: str) -> dict[str, tuple[Callable[[], Any], Callable[[], Any]]]:
    """Return pairs of calls: with something that never happens, and without it."""
    system = pendulum(links, motion)
    gap = sm.cos(system.coordinates[1]) + 3
    never = Event(gap, terminal=True, name="never")
    contacts = Contacts(pendulum(links, motion), [Unilateral(gap)])
    return {
        "an event": (partial(system.simulate, events=[never]), system.simulate),
        "a contact": (contacts.simulate, system.simulate),
    }


def columns(links: int, motion: str) -> dict[str, tuple[Callable[[], Any], Callable[[], Any]]]:
    """Return a pair of calls: with the derivatives by eight parameters, and without them."""
    system = pendulum(links, motion)
    parameters = [*sorted(system.constants_symbols, key=str), *system.states][:8]
    derivatives = partial(system.simulate, sensitivities=parameters)
    return {"eight columns": (derivatives, system.simulate)}


def measure(pairs: int) -> list[dict[str, Any]]:
    """Return the times of both calls of each pair, in seconds of this thread."""
    lines = []
    for kind, make in (("µs", repeated), ("ratio", inactive), ("columns", columns)):
        # Long motions vary by more than what is prepared takes.
        motions = [next(iter(MOTIONS))] if kind == "µs" else [*MOTIONS]
        for links, motion in itertools.product(LINKS, motions):
            for name, calls in make(links, motion).items():
                for call in calls:
                    for _ in range(70):  # until all is compiled that is compiled late
                        call()
                number = max(2, round(LEAST / _each(calls[1], 2)))
                taken = [[_each(call, number) for call in calls] for _ in range(pairs)]
                more, plain = map(list, zip(*taken, strict=True))
                lines.append(
                    {"kind": kind, "links": links, "motion": motion, "name": name}
                    | {"with": more, "without": plain}
                )
    return lines


def _each(call: Callable[[], Any], number: int) -> float:
    start = time.process_time()
    for _ in range(number):
        call()
    return (time.process_time() - start) / number


def _of_version(src: Path, options: argparse.Namespace) -> list[dict[str, Any]]:
    """Return the lines of a version of the package, measured in a process of its own."""
    done = subprocess.run(
        [sys.executable, __file__, "--worker", "--pairs", str(options.pairs)],
        env={**os.environ, "PYTHONPATH": f"{src}{os.pathsep}{BENCHMARKS}"},
        capture_output=True,
        text=True,
        check=True,
        preexec_fn=lambda: os.sched_setaffinity(0, {options.core}),
    )
    lines: list[dict[str, Any]] = json.loads(done.stdout.splitlines()[-1])
    return lines


def _value(line: dict[str, Any]) -> float:
    pairs = zip(line["with"], line["without"], strict=True)
    if line["kind"] == "µs":
        return median(1e6 * (a - b) for a, b in pairs)
    return median(a / b for a, b in pairs)


def main() -> None:
    """Measure and print the differences and ratios."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--before", type=Path, help="the `src` folder of another version")
    parser.add_argument("--pairs", type=int, default=15)
    parser.add_argument("--worker", action="store_true", help="measure this version alone")
    add_measuring(parser, budget=60.0)
    options = parser.parse_args()
    options.pairs = 1 if options.quick else options.pairs
    if options.worker:
        print(json.dumps(measure(options.pairs)))
        return
    versions = {"now": ROOT / "src"} | ({"before": options.before} if options.before else {})
    results = {name: _of_version(src, options) for name, src in versions.items()}
    for kind, title in (
        ("µs", "Microseconds more than the same call again"),
        ("ratio", "What never happens: the call over `simulate` without it"),
        ("columns", "Sensitivities: the call over `simulate` without them"),
    ):
        rows = []
        for lines in zip(*results.values(), strict=True):
            if lines[0]["kind"] == kind:
                name, links, motion = (lines[0][key] for key in ("name", "links", "motion"))
                plain = f"{1e6 * median(lines[0]['without']):.0f} µs"
                extra = f"{1e6 * (median(lines[0]['with']) - median(lines[0]['without'])):.0f} µs"
                digits = 0 if kind == "µs" else 2
                values = [f"{_value(line):.{digits}f}" for line in lines]
                rows.append((f"{name}, {links} links, {motion}", plain, extra, *values))
        header = ("", "plain call", "more", *(f"{v} (≤ {GOALS[kind]:g})" for v in versions))
        table(title, header, rows)
    save("repeated_calls", results)


if __name__ == "__main__":
    main()
