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
    """Return a bar of tqdm, disabled where there is no output, as under pythonw."""
    try:
        made = import_module("tqdm.auto").tqdm
    except ImportError:
        raise MissingDependencyError(
            "`progress=True` needs tqdm: pip install tqdm, or pass progress=False."
        ) from None
    return made(*rows, **options, **({"disable": True} if sys.stderr is None else {}))


@contextmanager
def progress_of(
    wanted: bool, unit: str, total: int | None = None, **options: Any
) -> Iterator[Callable[..., None]]:
    """Show a bar of tqdm, if wanted, until the block ends.

    Yields ``told(number, **shown)``, which moves the bar on and shows what is named beside it. With
    the number 0 it is shown at once: what begins now may take long. Options are those of tqdm.
    """
    if not wanted:
        yield lambda number, **shown: None
        return
    with bar_of(total=total, unit=unit, **options) as bar:

        def told(number: int, **shown: str) -> None:
            if shown:
                bar.set_postfix(shown, refresh=number == 0)
            bar.update(number)

        yield told
