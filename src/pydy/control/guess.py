"""Where a search begins, as users give it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from pydy._checks import Places, check_mapping, number, real_array, shown
from pydy._errors import OptimizationError
from pydy._rank import DIGITS, least_step
from pydy.control.nlp import Nlp
from pydy.control.transcription import Transcription
from pydy.control.tuning import LEAST_MESH_TOL, MOST_CLOSING_STEPS
from pydy.inputs import SampledInput
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
        value = self._values[symbol]
        what = f"`guess[{symbol}]`"
        if isinstance(value, SampledInput):
            if value.size != 1:
                raise ValueError(f"{what} must be samples of one value, got {value.size} a time.")
            samples: np.ndarray = value.rows(fractions * duration)[:, 0]
            return samples
        samples = np.atleast_1d(real_array(value, what))
        if samples.ndim != 1 or not len(samples) or not np.isfinite(samples).all():
            raise ValueError(
                f"{what} must be a finite number, or a row of them, got {shown(value)}."
            )
        even = np.linspace(0.0, 1.0, num=len(samples))
        between: np.ndarray = np.interp(fractions, even, samples)
        return between

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
    rows, entries = np.empty((piece.rows, 1)), np.empty((len(f.jacobian_at), 1))
    J = np.zeros((piece.rows, f.sizes[0]))
    for k in range(len(slots)):
        at, data = piece.at[:, [k]], np.ascontiguousarray(piece.data[:, [k]])
        X = z[at]
        X[states, 0] += shift
        for _ in range(MOST_CLOSING_STEPS):
            f("rows", X, data, piece.constants, rows)
            f("jacobian", X, data, piece.constants, entries)
            J[tuple(f.jacobian_at.T)] = entries[:, 0]
            left, by = rows[:count, 0], J[:count]
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


def check_freedom(nlp: Nlp) -> None:
    """Refuse more equations than unknowns."""
    low, high = nlp.row_bounds
    equal, unknown = int((low == high).sum()), int((nlp.lower < nlp.upper).sum())
    if equal > unknown:
        raise ValueError(
            f"The problem has {equal} equations for {unknown} unknowns on this mesh: there is "
            "nothing left to choose. Free some of the `start` or `end`, or leave a specified "
            "without a value, which makes it a control."
        )


def mesh_tolerance(value: Any) -> float | None:
    """Return a checked `mesh_tol`."""
    if value is None:
        return None
    result = positive_time(value, "`mesh_tol`")
    if result < LEAST_MESH_TOL:
        raise ValueError(
            f"`mesh_tol` must be at least {LEAST_MESH_TOL:.2g}, what rounding leaves on any mesh, "
            f"got {result:g}."
        )
    return result


def shown_pair(limits: tuple[float, float]) -> str:
    """Return bounds for a message, as users give them."""
    low, high = (None if np.isinf(value) else value for value in limits)
    return repr(low) if low == high else f"({low!r}, {high!r})"


def checked_sweep(values: Any) -> tuple[list[Any], list[np.ndarray]]:
    """Return what is swept, and as many values for each."""
    given = check_mapping("values", values)
    rows = [np.atleast_1d(real_array(v, f"`values[{k}]`")) for k, v in given.items()]
    for key, row in zip(given, rows, strict=True):
        if row.ndim != 1 or row.shape != rows[0].shape or not np.isfinite(row).all():
            raise ValueError(
                f"`values[{key}]` must be finite numbers, as many as for the others, got the "
                f"shape {row.shape} after {rows[0].shape}."
            )
    if not rows:
        raise ValueError("`values` must map at least one constant to numbers.")
    return [*given], rows


def swept(rows: Sequence[Any], made: Any, search: Any, guess: Any) -> list[Any]:
    """Search for one set of values after the other, from the last motion, else from the guess."""
    found: list[Any] = []
    for numbers in zip(*rows, strict=True):
        last = found[-1] if found else None
        try:
            found.append(search(made(numbers, last), guess if last is None else last))
        except OptimizationError:
            if last is None:
                raise
            found.append(search(made(numbers, None), guess))
    return found
