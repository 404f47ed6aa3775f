"""Ctrl-C in what must not be left halfway: noted when it comes, raised where nothing is lost."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable
from types import FrameType
from typing import Any


class Interrupts:
    """A context in which the first Ctrl-C waits until `check` is called, or for the end.

    A `KeyboardInterrupt` that Python raises on its way from compiled code into a callback would be
    lost: ctypes prints it and goes on with what lay in the result. A second Ctrl-C is raised at
    once, for a function of the user that hangs. Handlers other than Python's own are left alone,
    and so are threads other than the main one, which get no signals: there, `stopped` tells, which
    every `check` asks; True is as good as a Ctrl-C.
    """

    def __init__(self, stopped: Callable[[], bool] = lambda: False) -> None:
        self._stopped = stopped
        self._pending = False
        self._before: Any = None

    def __enter__(self) -> Interrupts:
        self._pending = False
        here = threading.current_thread() is threading.main_thread()
        if here and signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            self._before = signal.signal(signal.SIGINT, self._note)
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        if self._before is not None:
            signal.signal(signal.SIGINT, self._before)
            self._before = None
        if self._pending and (kind is None or not issubclass(kind, KeyboardInterrupt)):
            raise KeyboardInterrupt

    def _note(self, _signal: int, _frame: FrameType | None) -> None:
        if self._pending:
            raise KeyboardInterrupt
        self._pending = True

    def check(self) -> None:
        """Raise the `KeyboardInterrupt` that waits, if one does."""
        if self._pending or self._stopped():
            raise KeyboardInterrupt
