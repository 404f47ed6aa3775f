"""Where a search begins, as users give it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from pydy._checks import Places, check_mapping, number
from pydy._rank import DIGITS, least_step
from pydy.control.limits import limit
from pydy.control.transcription import Transcription
from pydy.control.tuning import MOST_CLOSING_STEPS
from pydy.trajectory import Trajectory


class Guess:
    """Where a search begins, as the user gives it."""

    def __init__(self, given: Any, unknown: Places, duration: float | None, symbol: Any) -> None:
        self._duration, self._symbol = duration, symbol
        self._motion: Trajectory | None = None
        self._values: dict[Any, Any] = {}
        if isinstance(given, Trajectory):
            self._motion = given
        else:
            values = check_mapping("guess", given)
            self._values = unknown.by_symbol(values, "guess")

    def duration(self, bounds: tuple[float, float]) -> float:
        """Return the duration to begin with."""
        symbol = self._symbol
        if self._duration is not None:
            return self._duration
        if self._motion is not None:
            return float(self._motion.times[-1] - self._motion.times[0])
        if symbol in self._values:
            return positive_time(self._values[symbol], f"`guess[{symbol}]`")
        if not np.isfinite(bounds).all():
            raise ValueError(
                f"The duration `{symbol}` is free: give `bounds` for it, {{{symbol}: (low, high)}},"
                f" or where the search begins, guess={{{symbol}: ...}}."
            )
        return float(np.mean(np.maximum(bounds, 0.0)))

    def values(self, symbol: Any, fractions: np.ndarray, duration: float) -> np.ndarray | None:
        """Return a state or control at some times, or None."""
        if self._motion is not None:
            if symbol not in self._motion:
                return None
            first, last = self._motion.times[[0, -1]]
            order = np.argsort(fractions, kind="stable")
            times = np.clip(first + fractions[order] * (last - first), first, last)
            found = np.empty(len(fractions))
            found[order] = self._motion.at(times)[symbol]
            return found
        if symbol not in self._values:
            return None
        given = limit(self._values[symbol], f"`guess[{symbol}]`", duration, finite=True)
        return given(fractions)

    def number(self, symbol: Any, known: float) -> float:
        """Return a free constant to begin with."""
        if self._motion is not None:
            return float(self._motion.constants.get(symbol, known))
        return number(self._values.get(symbol, known), f"`guess[{symbol}]`", finite=True)

    def check_bounds(self, symbol: Any, values: np.ndarray, bounds: Any) -> None:
        """Refuse values that the user gave and that lie outside of bounds, numbers or arrays."""
        low, high = np.broadcast_arrays(*bounds, values)[:2]
        outside = (values < low) | (values > high)
        if symbol in self._values and outside.any():
            at = int(np.flatnonzero(outside)[0])
            raise ValueError(
                f"`guess[{symbol}]` must lie within its `bounds`, "
                f"{shown_pair((float(low[at]), float(high[at])))}, got {float(values[at])!r}."
            )


def follow_constraints(
    made: Transcription, z: np.ndarray, moving: Sequence[int], count: int
) -> None:
    """Let some coordinates follow from the first `count` constraints, in place, from the start on.

    Each place begins as far beside its guess as the one before ended, so that a mechanism does not
    change its branch. Where no configuration is found the guess stays.
    """
    places, slopes = made.places
    own = np.flatnonzero(~slopes)
    slots = own[np.argsort(places[own], kind="stable")]
    piece, states = made.held_at(slots), list(moving)
    f, shift = piece.functions, np.zeros(len(states))
    J = np.zeros((piece.rows, f.sizes[0]))
    for k in range(len(slots)):
        at, data = piece.at[:, [k]], np.ascontiguousarray(piece.data[:, [k]])
        X = z[at]
        X[states, 0] += shift
        for _ in range(MOST_CLOSING_STEPS):
            J[tuple(f.jacobian_at.T)] = f("jacobian", X, data, piece.constants)[:, 0]
            left, by = f("rows", X, data, piece.constants)[:count, 0], J[:count]
            if not (np.isfinite(left).all() and np.isfinite(by).all()):
                break
            if (np.abs(left) <= DIGITS * (np.abs(by) @ np.abs(X[:, 0]))).all():
                shift = X[states, 0] - z[at[states, 0]]
                z[at[states, 0]] = X[states, 0]
                break
            X[states, 0] -= least_step(by[:, states], left)


def positive_time(value: Any, what: str = "`duration`") -> float:
    """Return a positive number, or say what it was instead."""
    result = number(value, what, finite=True)
    if not result > 0.0:
        hint = ", or a Symbol for one that is found" if what == "`duration`" else ""
        raise ValueError(f"{what} must be positive{hint}, got {result!r}.")
    return result


def shown_pair(limits: tuple[float, float]) -> str:
    """Return bounds for a message, as users give them."""
    low, high = (None if np.isinf(value) else value for value in limits)
    return repr(low) if low == high else f"({low!r}, {high!r})"
