"""Work that is done on the side, in one thread, while the program goes on.

It waits for a quiet moment: llvmlite lets one thread at a time into LLVM, so a long compilation on
the side would hold up a short one that the program waits for. A forked child begins without work on
the side; what it needs of it, it does itself.
"""

from __future__ import annotations

import atexit
import queue
import threading
import time
from collections.abc import Callable

from pydy import _forks

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
        self._lock = _forks.Lock()

    def run(self) -> None:
        """Do it, or wait until the thread that is at it has done it."""
        with self._lock:
            try:
                if self._function is not None:
                    self._function()
            finally:
                self._function = None  # not before: a child that is forked meanwhile does it again


_TASKS: queue.SimpleQueue[Task | None] = queue.SimpleQueue()
_START = _forks.Lock()
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
        if _thread is None or not _thread.is_alive():
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
        task.run()


def _end() -> None:
    """Let the task in hand finish: a thread must not be inside LLVM when the process ends."""
    _ENDING.set()
    _TASKS.put(None)
    if _thread is not None:
        _thread.join()


@_forks.in_child
def _begin_anew() -> None:
    global _TASKS, _ENDING, _thread
    _TASKS, _ENDING, _thread = queue.SimpleQueue(), threading.Event(), None
