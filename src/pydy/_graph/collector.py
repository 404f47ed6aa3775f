"""Keep Python's cycle collector out of the way while graphs are built.

Building makes hundreds of thousands of small tuples and no cycles; the collector would walk all of
SymPy's objects several times meanwhile, which can take longer than the building itself.
"""

from __future__ import annotations

import gc
import threading
from collections.abc import Iterator
from contextlib import contextmanager

from pydy import _forks

__all__ = ["collector_paused"]


_pausing: int | None = None  # the thread


@contextmanager
def collector_paused() -> Iterator[None]:
    """Turn automatic collection off for the body, unless it is off already."""
    global _pausing
    if not gc.isenabled():
        yield
        return
    gc.disable()
    _pausing = threading.get_ident()
    try:
        yield
    finally:
        _pausing = None
        _let_age()
        gc.enable()


def _let_age() -> None:
    """Put all objects among the old ones, which the next full collection looks at.

    Else the next allocation would have all that was built walked through at once.
    """
    if not gc.get_freeze_count():  # nobody else's are to be thawed
        gc.freeze()
        gc.unfreeze()


@_forks.in_child
def _go_on() -> None:
    """Turn collection on where the thread that had turned it off is not there any more."""
    global _pausing
    if _pausing not in (None, threading.get_ident()):
        _pausing = None
        gc.enable()
