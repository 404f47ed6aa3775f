"""Packages that only some features need, imported when the feature is used."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module
from typing import Any

from pydy._errors import MissingDependencyError


def require(module: str, extra: str, purpose: str) -> Any:
    """Import a module, or raise an error that names the `extra` that installs it."""
    try:
        return import_module(module)
    except ImportError as error:
        package = module.partition(".")[0]
        raise ImportError(
            f"{purpose} needs {package}, which is not installed: pip install 'pydy[{extra}]'."
        ) from error


def bar_of(*rows: Any, **options: Any) -> Any:
    """Return a progress bar of tqdm, disabled if there is no stderr, as with pythonw."""
    try:
        bar_class = import_module("tqdm.auto").tqdm
    except ImportError:
        raise MissingDependencyError(
            "`progress=True` needs tqdm: pip install tqdm, or pass progress=False."
        ) from None
    return bar_class(*rows, **options, **({"disable": True} if sys.stderr is None else {}))


@contextmanager
def progress_of(
    visible: bool, unit: str, total: int | None = None, **options: Any
) -> Iterator[Callable[..., None]]:
    """Show a progress bar of tqdm until the block ends, if `visible`.

    Yields ``report(number, **postfix)``, which advances the bar and shows the postfix next to it.
    With the number 0 the postfix is shown at once, for steps that take long. The options are those
    of tqdm.
    """
    if not visible:
        yield lambda number, **postfix: None
        return
    with bar_of(total=total, unit=unit, **options) as bar:

        def report(number: int, **postfix: str) -> None:
            if postfix:
                bar.set_postfix(postfix, refresh=number == 0)
            bar.update(number)

        yield report
