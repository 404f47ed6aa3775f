"""A user's constants and initial conditions in order."""

from __future__ import annotations

from typing import Any

import numpy as np

from pydy._assembly.definition import Definition

__all__ = ["read_constants", "read_states"]


def read_constants(definition: Definition, values: dict[Any, Any]) -> np.ndarray:
    """Return the constants in order; they are 1.0 without a value."""
    return _read(definition, "constants", "constants", values, 1.0)


def read_states(definition: Definition, values: dict[Any, Any]) -> np.ndarray:
    """Return the initial conditions in order; they are 0.0 without a value."""
    return _read(definition, "initial_conditions", "states", values, 0.0)


def _read(
    definition: Definition, argument: str, what: str, values: dict[Any, Any], default: float
) -> np.ndarray:
    places = definition.places[what]
    try:
        return places.read(argument, values, default)
    except ValueError as error:
        mechanism = definition.equations.mechanism
        gone = [
            str(key)
            for key in values
            if places.get(key, argument) is None and mechanism and key in mechanism.symbols
        ]
        if not gone:
            raise
        raise ValueError(
            f"{error} The bodies or loads hold `{gone[0]}`, but it cancels: the motion does "
            "not depend on it. Leave it out, or check the velocities and angular velocities "
            "that were given."
        ) from None
