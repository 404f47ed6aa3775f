"""Tables of options: the check that each option's value has to pass."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from pydy._checks import choice

# Called with a value and what messages call it; returns the value as it is used.
Check = Callable[[Any, str], Any]


def checked(table: Mapping[str, Check], given: Mapping[str, Any]) -> dict[str, Any]:
    """Apply each option's check; leave options without a check as they are."""
    return {
        name: table[name](value, f"`{name}`") if name in table else value
        for name, value in given.items()
    }


def one_of(*options: Any) -> Check:
    """Return a check for `choice` among these options."""
    return lambda value, what: choice(value, options, what)


def optional(check: Check) -> Check:
    """Return a check that lets None pass."""
    return lambda value, what: None if value is None else check(value, what)
