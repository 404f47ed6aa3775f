"""The doors of the rooms: which module a name comes from that another room imports.

A room is a package directly in `pydy`. Its door is its `__init__.py`, which loads nothing; the stub
beside it, `__init__.pyi`, lists the names that other rooms may take, by module.
"""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[1] / "src" / "pydy"


@cache
def door_of(package: str) -> dict[str, str]:
    """Return the names of a room's door, ``pydy._graph`` say, and the modules that define them."""
    stub = SOURCE.parent.joinpath(*package.split("."), "__init__.pyi")
    if not stub.exists():
        return {}
    return {
        alias.name: f"{package}.{node.module}" if node.module else f"{package}.{alias.name}"
        for node in ast.parse(stub.read_text(encoding="utf-8")).body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }


def rooms() -> list[str]:
    """Return the packages that have a door."""
    return sorted(f"pydy.{stub.parent.name}" for stub in SOURCE.glob("*/__init__.pyi"))
