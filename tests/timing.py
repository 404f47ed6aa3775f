"""Processor times of test functions: `make times` writes the table of the slow ones, others watch.

Every run measures. A function that takes a hundred times the limit of `parts.py` and is not in the
table fails the run by name: the table is wrong then. Functions that take less are found by the next
`make times`. The first test that compiles, imports or derives something pays for it, and which one
that is depends on the part that is drawn: hence the factor.
"""

from __future__ import annotations

import os
import time
from collections import defaultdict
from typing import Any

import pytest

import parts

FACTOR = 100


def processor_time() -> float:
    """Return the seconds used by this process and by its children that have ended."""
    times = os.times()  # in hundredths of a second
    return time.process_time() + times.children_user + times.children_system


def loop_time() -> float:
    """Return the seconds that ten million turns of a loop take: how fast this machine is."""
    start, turns = time.process_time(), 1_000_000
    while turns:
        turns -= 1
    return 10 * (time.process_time() - start)


class Times:
    """A plugin of pytest, in the process that reports and in each worker of xdist."""

    def __init__(self) -> None:
        self.seconds: defaultdict[str, float] = defaultdict(float)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Any:
        """Measure a case with its fixtures."""
        start = processor_time()
        outcome = yield
        self.seconds[parts.function_of(item.nodeid)] += processor_time() - start
        return outcome

    @pytest.hookimpl(optionalhook=True)
    def pytest_testnodedown(self, node: Any, error: object) -> None:
        """Add what a worker has measured."""
        for name, seconds in getattr(node, "workeroutput", {}).get("times", {}).items():
            self.seconds[name] += seconds

    @pytest.hookimpl(trylast=True)
    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        """Send, record or judge the times."""
        if (output := getattr(session.config, "workeroutput", None)) is not None:
            output["times"] = dict(self.seconds)
        elif parts.RECORDING:
            parts.write_table(self.seconds, loop_time())
        elif self.unlisted():
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    def pytest_terminal_summary(self, terminalreporter: Any) -> None:
        """Name the functions that are missing in the table."""
        if parts.RECORDING or not (unlisted := self.unlisted()):
            return
        terminalreporter.section("slow tests that tests/slow.txt does not list", red=True)
        for name, seconds in unlisted.items():
            terminalreporter.line(f"{seconds:5.1f} s {name}")
        terminalreporter.line("Make them faster, or run `make times` and commit the table.")

    def unlisted(self) -> dict[str, float]:
        """Return slow functions that are not in the table, on a machine like that of the table."""
        limit = FACTOR * parts.LIMIT
        slow = {name: s for name, s in self.seconds.items() if s > limit}
        for name in (*parts.read_table(), *parts.DRAWING):
            slow.pop(name, None)
        # Tests in a browser run all together, where they are asked for: no table deals them out.
        slow = {name: s for name, s in slow.items() if not name.startswith(parts.ASKED_FOR)}
        if slow:
            limit *= max(1.0, loop_time() / parts.loop_time_of_table())
        return {name: s for name, s in slow.items() if s > limit}
