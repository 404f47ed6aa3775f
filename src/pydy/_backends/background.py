"""Work that is done on the side, in one thread, while the program goes on.

It waits for a quiet moment: llvmlite lets one thread at a time into LLVM, so a long compilation on
the side would hold up a short one that the program waits for. A fork of the process waits for the
task in hand: the child would else wait for ever for a lock that a thread held which it has not got.
"""

from __future__ import annotations

import atexit
import os
import queue
import threading
import time
from collections.abc import Callable

__all__ = ["Task", "in_use", "submit"]


class Task:
    """Something to do once, by whoever comes first: the side thread or the one that needs it.

    Parameters
    ----------
    function : callable
        Takes nothing and returns nothing.
    """

    def __init__(self, function: Callable[[], None]) -> None:
        self._function: Callable[[], None] | None = function
        self._lock = threading.Lock()

    def run(self) -> None:
        """Do it, or wait until the thread that is at it has done it."""
        with self._lock:
            function, self._function = self._function, None
            if function is not None:
                function()


_TASKS: queue.SimpleQueue[Task | None] = queue.SimpleQueue()
_START = threading.Lock()
_WORKING = threading.Lock()
_ENDING = threading.Event()
_QUIET_SECONDS = 0.25
_thread: threading.Thread | None = None
_last_wanted = 0.0


def in_use() -> None:
    """Say that the program itself is compiling just now."""
    global _last_wanted
    _last_wanted = time.monotonic()


def submit(task: Task) -> None:
    """Have a task done on the side; what is left when the interpreter ends is dropped."""
    global _thread
    with _START:
        if _thread is None or not _thread.is_alive():  # a forked child has no thread yet
            _thread = threading.Thread(target=_work, name="pydy-background", daemon=True)
            _thread.start()
            atexit.register(_end)
    in_use()
    _TASKS.put(task)


def _work() -> None:
    while True:
        task = _TASKS.get()
        while task is not None and not _ENDING.is_set():
            left = _last_wanted + _QUIET_SECONDS - time.monotonic()
            if left <= 0.0:
                break
            _ENDING.wait(left)
        if task is None or _ENDING.is_set():
            return
        with _WORKING:
            task.run()


def _end() -> None:
    """Let the task in hand finish: a thread must not be inside LLVM when the process ends."""
    _ENDING.set()
    _TASKS.put(None)
    if _thread is not None:
        _thread.join()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(
        before=_WORKING.acquire,
        after_in_parent=_WORKING.release,
        after_in_child=_WORKING.release,
    )
