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
        gc.enable()


@_forks.in_child
def _go_on() -> None:
    """Turn collection on where the thread that had turned it off is not there any more."""
    global _pausing
    if _pausing not in (None, threading.get_ident()):
        _pausing = None
        gc.enable()
