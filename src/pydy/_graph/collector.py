"""Keep Python's cycle collector out of the way while graphs are built.

Building makes hundreds of thousands of small tuples and no cycles; the collector would walk all of
SymPy's objects several times meanwhile, which can take longer than the building itself.
"""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

__all__ = ["collector_paused"]


@contextmanager
def collector_paused() -> Iterator[None]:
    """Turn automatic collection off for the body, unless it is off already."""
    if not gc.isenabled():
        yield
        return
    gc.disable()
    try:
        yield
    finally:
        gc.enable()
