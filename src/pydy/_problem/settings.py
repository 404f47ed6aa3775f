"""What the user of a System has set, and how its numbers are read."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pydy._assembly import Definition
from pydy._names import name_of
from pydy._problem.entries import warn_of_entries

_DEFAULTS = {"constants": ("constants", 1.0), "initial_conditions": ("states", 0.0)}


@dataclass(frozen=True, eq=False)
class Settings:
    """The dictionaries as the user gave them, and what goes with them.

    Each is checked when it is first needed.
    """

    constants: dict[Any, Any]
    specifieds: dict[Any, Any]
    initial_conditions: dict[Any, Any]
    times: np.ndarray  # the System's, which are the default of evaluations
    outputs: dict[Any, Any] = field(default_factory=dict)
    forces: Sequence[Any] = ()  # the names of noncontributing forces
    # Names of symbols whose values contradict their assumptions, of which the user was warned; None
    # where numbers are only tried.
    contradicted: set[str] | None = None
    # Derivatives of specifieds that the user has been warned of.
    already_warned: set[Any] = field(default_factory=set)
    # The states that initial conditions were solved for last; None for the method's own.
    solved_for: tuple[Any, ...] | None = None


def read_numbers(
    definition: Definition,
    argument: str,
    values: dict[Any, Any],
    contradicted: set[str] | None,
) -> np.ndarray:
    """Return 'constants' in order, 1.0 without a value, or 'initial_conditions', then 0.0.

    Values that contradict an assumption are reported once, unless `contradicted` is None.
    """
    kind, default = _DEFAULTS[argument]
    symbols = definition.places[kind]
    try:
        numbers = symbols.read(argument, values, default)
    except ValueError as error:
        mechanism, time = definition.equations.mechanism, definition.equations.time
        unknown = [key for key in values if symbols.get(key, argument) is None]
        if time in unknown:
            raise ValueError(
                f"{error} `{time}` is the time, `dynamicsymbols._t`, wherever it occurs. Give the "
                "quantity another symbol."
            ) from None
        cancelled = [str(key) for key in unknown if mechanism and key in mechanism.symbols]
        if cancelled:
            raise ValueError(
                f"{error} The bodies or loads hold `{cancelled[0]}`, but it cancels: the motion "
                "does not depend on it. Leave it out; or name it in `constants_symbols`, if a "
                "reaction or energy needs it; or check the velocities and angular velocities given."
            ) from None
        name = name_of(unknown[0]) if unknown else ""
        if kind == "constants" and name.isidentifier() and not symbols.suggestion(unknown[0]):
            raise ValueError(
                f"{error} Remove it if it belonged to an expression that you replaced. If it "
                f"occurs in events only, assign it in place, `system.constants[{name!r}] = ...`, "
                "right before the first call with them; if in contacts only, pass it to "
                f"`Contacts(system, contacts, {{{name!r}: ...}})`."
            ) from None
        raise
    if definition.assumptions and contradicted is not None and kind in definition.assumptions:
        assumed = definition.assumptions[kind]
        warn_of_entries(assumed, symbols, argument, numbers[None], values, contradicted)
    return numbers
