"""Run compilers as processes; they end, with all that they started, when the wait for them ends."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
from collections.abc import Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from pydy._interrupts import Interrupts

LOOK = 0.1
"""Seconds between two polls for a signal: one that arrives just before a wait does not end it."""


@contextlib.contextmanager
def started(
    command: list[str], cwd: Path, env: Mapping[str, str] | None = None, **options: Any
) -> Iterator[subprocess.Popen[str]]:
    """Run a command in a folder; its `stdout` is text and includes its errors.

    It has a process group of its own: killing a compiler's driver alone would not end the compiler.
    Temporary files are written into the folder, so that they are deleted with it.
    """
    temporary = dict.fromkeys(("TMPDIR", "TMP", "TEMP"), str(cwd))
    with contextlib.ExitStack() as stack:
        with Interrupts():  # a Ctrl-C within Popen would leave a process behind
            process = stack.enter_context(
                subprocess.Popen(
                    command,
                    stdin=subprocess.DEVNULL,
                    stdout=subprocess.PIPE,
                    stderr=subprocess.STDOUT,  # compilers differ in where they write their errors
                    errors="replace",
                    start_new_session=True,
                    cwd=cwd,
                    env={**(os.environ if env is None else env), **temporary},
                    **options,
                )
            )
            stack.push(partial(_killed, process))
        yield process


def _killed(process: subprocess.Popen[str], kind: type[BaseException] | None, *_: object) -> None:
    """Kill a process and its children if the block raised an exception."""
    if kind is not None:
        if hasattr(os, "killpg"):
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
        process.kill()
        process.wait()


def output_of(process: subprocess.Popen[str]) -> str:
    """Return the whole output of a process."""
    while True:
        with contextlib.suppress(subprocess.TimeoutExpired):
            return process.communicate(timeout=LOOK)[0]
