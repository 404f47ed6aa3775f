"""Compilers that run as processes end, with all that they have started, when nobody waits."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
from collections.abc import Iterator
from typing import Any

__all__ = ["started"]


@contextlib.contextmanager
def started(command: list[str], **options: Any) -> Iterator[subprocess.Popen[str]]:
    """Run a command; what it writes, errors included, is the text of its `stdout`.

    It has a group of its own: a compiler's driver that is killed leaves the compiler at work.
    """
    with subprocess.Popen(
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,  # compilers differ in where they write their errors
        errors="replace",
        start_new_session=True,
        **options,
    ) as process:
        try:
            yield process
        except BaseException:
            if hasattr(os, "killpg"):
                with contextlib.suppress(ProcessLookupError):
                    os.killpg(process.pid, signal.SIGKILL)
            process.kill()
            raise
