"""Work that is done on the side, by a process of its own, while the program goes on.

llvmlite lets one thread at a time into LLVM, and the interpreter one at a time into Python. A
thread that compiles a large model would hold up for seconds whatever the program compiles
meanwhile. So a thread of this process only asks another process for the machine code, waits, and
links it, which takes two milliseconds.

It waits for a quiet moment, so that short scripts start no process, takes the newest task first,
and knows tasks as long as somebody else does: what nobody can call any more is not compiled. Who
needs the result of a task does it at once, even if it is under way on the side: the other process
has a low priority. A forked child begins without work on the side.
"""

from __future__ import annotations

import atexit
import threading
import time
from collections.abc import Callable
from weakref import WeakKeyDictionary

from pydy import _forks
from pydy._backends.llvm.compiling import Helper, HelperError, Source, object_code
from pydy._backends.tuning import IDLE_SECONDS, QUIET_SECONDS

Compile = Callable[[Source], bytes]


class Task:
    """Something to do once: on the side, or by the first thread that needs it.

    The function takes what compiles a `Source`, here or elsewhere, and returns nothing.
    """

    def __init__(self, function: Callable[[Compile], None]) -> None:
        self._function: Callable[[Compile], None] | None = function
        self._lock = _forks.Lock()

    def run(self) -> None:
        """Do it here, or wait until another thread that needs it has done it."""
        with self._lock:
            self.run_with(object_code)

    def run_with(self, compile_source: Compile) -> None:
        """Do it, unless it is done, with machine code from elsewhere."""
        function = self._function
        if function is not None:
            function(compile_source)
            # Not before: a child that is forked meanwhile does it again.
            self._function = None


_START = _forks.Lock()
_last_wanted = 0.0


_TASKS: WeakKeyDictionary[Task, None] = WeakKeyDictionary()
_SUBMITTED, _ENDING = threading.Event(), threading.Event()
_helper = Helper()
_thread: threading.Thread | None = None


@_forks.in_child
def _begin_anew() -> None:
    global _TASKS, _SUBMITTED, _ENDING, _thread
    _TASKS = WeakKeyDictionary()
    _SUBMITTED, _ENDING = threading.Event(), threading.Event()
    _helper.close(ours=False)
    _thread = None


def in_use() -> None:
    """Say that the program itself is compiling just now."""
    global _last_wanted
    _last_wanted = time.monotonic()


def submit(task: Task) -> None:
    """Queue a task for the background; unfinished tasks are dropped when the interpreter ends."""
    global _thread
    in_use()
    with _START:
        if _thread is None:
            _thread = threading.Thread(target=_work, name="pydy-background", daemon=True)
            try:
                _thread.start()
            except RuntimeError:  # no threads are left, or the interpreter ends
                _thread = None
                return  # who needs the task does it
            atexit.register(_end)
        _TASKS[task] = None
    _SUBMITTED.set()


def _work() -> None:
    while not _ENDING.is_set():
        if not _SUBMITTED.wait(IDLE_SECONDS):
            _helper.close()
            _SUBMITTED.wait()
        _SUBMITTED.clear()
        while _TASKS and not _ENDING.is_set():
            left = _last_wanted + QUIET_SECONDS - time.monotonic()
            if left > 0.0:
                _ENDING.wait(left)
            elif not _do_newest():
                return


def _do_newest() -> bool:
    """Do a task; return whether there is any use in going on."""
    try:
        task, _ = _TASKS.popitem()
    except KeyError:  # nobody else knew it any more
        return True
    try:
        task.run_with(_helper.compile)
    except HelperError:  # who needs the task does it
        return False
    return True


def _end() -> None:
    """Let the thread finish: it must not be inside LLVM when the process ends."""
    _ENDING.set()
    _SUBMITTED.set()
    while _thread is not None and _thread.is_alive():
        _helper.close()  # it may have started only now
        _thread.join(0.1)
    _helper.close()
