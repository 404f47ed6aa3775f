"""Tables of options: the check that each option's value has to pass."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from pydy._checks import choice

# Called with a value and its name for messages; returns the converted value.
Check = Callable[[Any, str], Any]


def checked(table: Mapping[str, Check], options: Mapping[str, Any]) -> dict[str, Any]:
    """Apply each option's check; options without a check are returned unchanged."""
    return {
        name: table[name](value, f"`{name}`") if name in table else value
        for name, value in options.items()
    }


def one_of(*options: Any) -> Check:
    """Return a check for `choice` among these options."""
    return lambda value, label: choice(value, options, label)


def optional(check: Check) -> Check:
    """Return a check that lets None pass."""
    return lambda value, label: None if value is None else check(value, label)
