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
_put_aside = 0  # how many objects
_limit: int | None = None


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
        _let_age()  # but a Ctrl-C does not wait for it
    finally:
        _pausing = None
        gc.enable()


def _let_age() -> None:
    """Move all objects to the oldest generation, which only full collections visit.

    Otherwise the next allocation would visit everything that was just built. Moving also delays the
    next full collection, in a loop of builds for ever. Therefore one runs here when half of all
    objects may be newer than the last one, but not before the thresholds allow it.
    """
    global _put_aside, _limit
    if gc.get_freeze_count():  # frozen by others, who would not expect to see them thawed
        return
    often, seldom, rarely = gc.get_threshold()
    due = False
    if _limit is not None:  # the first time most is needed: what was imported, and a model
        young, middle, old = gc.get_count()  # the last two in collections of those before them
        _put_aside += young + often * (middle + seldom * old)
        due = _put_aside > max(_limit, often * seldom * rarely)
    gc.freeze()
    try:
        if _limit is None:
            _limit = gc.get_freeze_count() // 2
    finally:
        gc.unfreeze()
    if due and often:  # with a threshold of zero nothing is to be collected
        _put_aside, _limit = 0, None
        gc.collect()


@_forks.in_child
def _go_on() -> None:
    """Turn collection on where the thread that had turned it off is not there any more."""
    global _pausing
    if _pausing not in (None, threading.get_ident()):
        _pausing = None
        gc.enable()
