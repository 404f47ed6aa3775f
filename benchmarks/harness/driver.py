"""The driver's side: workers in environments of their own, asked in turn."""

from __future__ import annotations

import contextlib
import json
import os
import select
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Any

BENCHMARKS = Path(__file__).resolve().parent.parent
ROOT = BENCHMARKS.parent
BUILD = ROOT / "build" / "benchmarks"


class WorkerError(RuntimeError):
    """A worker reported an error, died or took too long."""


class Worker:
    """A script of ``benchmarks/workers`` that runs in some environment and answers requests.

    Parameters
    ----------
    name : str
        For tables and the log file.
    python : path
        The environment's interpreter.
    script, *arguments : str
    timeout : float
        Seconds after which an answer is given up and the process ended.
    core : int or None
        The processor the worker is bound to.
    """

    def __init__(
        self,
        name: str,
        python: str | Path,
        script: str,
        *arguments: str,
        timeout: float = 900.0,
        core: int | None = None,
    ) -> None:
        self.name = name
        self.timeout = timeout
        BUILD.mkdir(parents=True, exist_ok=True)
        self._log = (BUILD / f"{name}.log").open("a")
        one = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
        self._process = subprocess.Popen(
            [python, BENCHMARKS / "workers" / script, *arguments],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._log,
            env={**os.environ, **one, "PYTHONPATH": str(BENCHMARKS), "PYTHONHASHSEED": "0"},
            start_new_session=True,  # compilers that a worker has started end with it
        )
        if core is not None:
            os.sched_setaffinity(self._process.pid, {core})

    def __enter__(self) -> Worker:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """End the process."""
        self._end()
        self._log.close()

    @property
    def alive(self) -> bool:
        """Whether it can still answer."""
        return self._process.poll() is None

    def _end(self) -> None:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()

    def ask(self, do: str, **arguments: Any) -> Any:
        """Return the worker's answer to a request.

        Raises
        ------
        WorkerError
        """
        process = self._process
        assert process.stdin is not None
        assert process.stdout is not None
        if not self.alive:
            raise WorkerError(f"{self.name} has ended; see {self._log.name}")
        process.stdin.write(json.dumps({"do": do, **arguments}).encode() + b"\n")
        process.stdin.flush()
        # Answers are one line to one request, so nothing else can be in the buffer.
        if not select.select([process.stdout], [], [], self.timeout)[0]:
            self._end()
            raise WorkerError(f"no answer to `{do}` within {self.timeout:g} s")
        line = process.stdout.readline()
        if not line:
            raise WorkerError(f"{self.name} died in `{do}`; see {self._log.name}")
        answer = json.loads(line)
        if "error" in answer:
            raise WorkerError(answer["error"])
        return answer["ok"]


def in_turn(
    measures: dict[str, Callable[[], Any]],
    *,
    least: int = 3,
    most: int = 15,
    budget: float = 30.0,
) -> list[dict[str, Any]]:
    """Take all measures in turn, A B A B, until the budget of seconds is used up."""
    rounds: list[dict[str, Any]] = []
    start = time.perf_counter()
    while len(rounds) < least or (len(rounds) < most and time.perf_counter() - start < budget):
        rounds.append({name: measure() for name, measure in measures.items()})
    return rounds
