"""How long compiled code runs between two looks from Python, and the bar that shows how far."""

from __future__ import annotations

from typing import Any

from pydy._errors import MissingDependencyError
from pydy._kernel import KernelCall
from pydy.solvers.run.methods import IMPLICIT

__all__ = ["SLICE", "first_budget", "progress_bar"]

SLICE = 0.02
"""Seconds in compiled code, about, until an interrupt is noticed and the bar moves."""


def first_budget(method: str, call: KernelCall | None, calls_python: bool) -> int:
    """Return how many steps take a few milliseconds at most; further ones are measured."""
    if calls_python or call is None:
        return 1
    if method == IMPLICIT:
        return 4
    # Twenty evaluations, of a nanosecond for each operation and 100 besides.
    return max(4, 100_000 // (100 + len(call.kernel.program.ops)))


def progress_bar(name: str, span: float, start: float) -> Any:
    """Return a bar of tqdm over the simulated time, from `start` on.

    Raises
    ------
    MissingDependencyError
        tqdm is not installed.
    """
    try:
        from tqdm.auto import tqdm
    except ImportError:
        raise MissingDependencyError(
            "`progress=True` needs tqdm: pip install tqdm, or pass progress=False."
        ) from None
    layout = "{l_bar}{bar}| {n:.3g}/{total:.3g} s [{elapsed}<{remaining}]"
    bar = tqdm(total=span, desc=name, bar_format=layout)
    bar.start = start
    return bar
