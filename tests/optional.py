"""Packages that tests use and need not be there, imported when a test first reads from them.

Collecting all tests took a quarter of its time for importing these.
"""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from typing import Any

import pytest


class _Module:
    """A module that is imported when something is first read from it."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, attribute: str) -> Any:
        if attribute.startswith("_"):  # pytest asks each object of a test file for marks of its own
            raise AttributeError(attribute)
        return getattr(import_module(self._name), attribute)


def optional(name: str, reason: str | None = None) -> Any:
    """Return a module by its name; the test, or all tests of a file, are skipped without it."""
    package = name.partition(".")[0]
    if find_spec(package) is None:
        pytest.skip(reason or f"{package} is not installed", allow_module_level=True)
    return _Module(name)
