"""The hand-written parts of what is exported."""

from __future__ import annotations

from functools import cache
from importlib.resources import files

__all__ = ["resource"]


@cache
def resource(name: str) -> str:
    """Return the text of a file in `templates`."""
    return (files("pydy.export") / "templates" / name).read_text(encoding="utf-8")
