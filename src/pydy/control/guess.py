"""Initial guesses and bounds as users give them: numbers, samples or motions, evaluated on a mesh.

`OptimalControl._guess` makes a search's initial point from a `Guess`: states and controls where the
mesh has them (`Guess.values`), then dependent coordinates that satisfy the constraints
(`follow_constraints`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._checks import SymbolIndex, check_mapping, number, positive, real_array, shown
from pydy._rank import DIGITS, least_step
from pydy.control.transcription import Transcription
from pydy.control.tuning import INPUT_SAMPLES
from pydy.inputs import SampledInput
from pydy.trajectory import Trajectory

if TYPE_CHECKING:
    import sympy as sm
    from numpy.typing import ArrayLike

    from pydy._sympy_types import AnySymbol


@dataclass(frozen=True, eq=False)
class Limit:
    """A bound, or a guess, as a function of fractions of the duration."""

    # A number, or values at equal distances over the motion, or at times.
    values: Any
    duration: float | None = None  # of the motion, for samples at times

    def __call__(self, fractions: np.ndarray) -> np.ndarray:
        """Return the values at fractions of the duration."""
        if isinstance(self.values, SampledInput):
            assert self.duration is not None
            sampled: np.ndarray = self.values.rows(fractions * self.duration)[:, 0]
            return sampled
        if np.ndim(self.values) == 0:
            return np.full(len(fractions), float(self.values))
        even = np.linspace(0.0, 1.0, num=len(self.values))
        interpolated: np.ndarray = np.interp(fractions, even, self.values)
        return interpolated

    @property
    def extremes(self) -> tuple[float, float]:
        """The least and the largest value."""
        values = self.values
        if isinstance(values, SampledInput):
            assert self.duration is not None
            inside = np.clip(values.breaks, 0.0, self.duration) / self.duration
            values = self(np.append(np.linspace(0.0, 1.0, num=INPUT_SAMPLES), inside))
        return float(np.min(values)), float(np.max(values))


def limit(value: object, argument: str, duration: float | None, *, finite: bool = False) -> Limit:
    """Return one side of bounds, or a guess, as a function of fractions of the duration.

    The numbers of a guess must be `finite`.
    """
    if isinstance(value, SampledInput):
        if duration is None:
            raise ValueError(
                f"{argument} has samples at times, and the duration is free. Give an array, whose "
                "values lie at equal distances over the motion; or a condition in `path`, on a "
                "specified that has these samples and occurs in one of the outputs."
            )
        if value.size != 1:
            raise ValueError(f"{argument} must be samples of one value, got {value.size} a time.")
        if not finite and not value.covers(np.array([0.0, duration])):
            raise ValueError(
                f"{argument} must have samples for the whole motion, from 0 to {duration:g}, got "
                f"those from {value.breaks[0]:g} to {value.breaks[-1]:g}. Add samples."
            )
        return Limit(value, duration)
    samples = real_array(value, argument)
    if samples.ndim == 0:
        return Limit(number(value, argument, finite=finite))
    if samples.ndim != 1 or not len(samples) or not np.isfinite(samples).all():
        raise ValueError(
            f"{argument} must be a finite number, or rows of finite numbers, got {shown(value)}."
        )
    return Limit(samples)


class Guess:
    """The user's initial guess."""

    def __init__(
        self,
        guess: object,
        unknown: SymbolIndex,
        duration: float | None,
        symbol: sm.Symbol | None,
    ) -> None:
        self._duration, self._symbol = duration, symbol
        self._motion: Trajectory | None = None
        self._values: dict[AnySymbol, object] = {}
        if isinstance(guess, Trajectory):
            self._motion = guess
        else:
            values = check_mapping("guess", guess)
            self._values = unknown.by_symbol(values, "guess")

    def duration(self, bounds: tuple[float, float]) -> float:
        """Return the initial duration."""
        symbol = self._symbol
        if self._duration is not None:
            return self._duration
        if self._motion is not None:
            return float(self._motion.times[-1] - self._motion.times[0])
        if symbol in self._values:
            return positive(self._values[symbol], f"`guess[{symbol}]`", finite=True)
        if not np.isfinite(bounds).all():
            raise ValueError(
                f"The duration `{symbol}` is free: give `bounds` for it, {{{symbol}: (low, high)}},"
                f" or where the search begins, guess={{{symbol}: ...}}."
            )
        return float(np.mean(np.maximum(bounds, 0.0)))

    def values(
        self, symbol: AnySymbol, fractions: np.ndarray, duration: float
    ) -> np.ndarray | None:
        """Return the guess of a state or control at fractions of the duration, or None."""
        if self._motion is not None:
            if symbol not in self._motion:
                return None
            first, last = self._motion.times[[0, -1]]
            order = np.argsort(fractions, kind="stable")
            times = np.clip(first + fractions[order] * (last - first), first, last)
            samples = np.empty(len(fractions))
            samples[order] = self._motion.at(times)[symbol]
            return samples
        if symbol not in self._values:
            return None
        function = limit(self._values[symbol], f"`guess[{symbol}]`", duration, finite=True)
        return function(fractions)

    def number(self, symbol: AnySymbol, default: float) -> float:
        """Return the guess of a free constant."""
        if self._motion is not None:
            return float(self._motion.constants.get(symbol, default))
        return number(self._values.get(symbol, default), f"`guess[{symbol}]`", finite=True)

    def check_bounds(
        self,
        symbol: AnySymbol | None,
        values: np.ndarray,
        bounds: tuple[ArrayLike, ArrayLike],
    ) -> None:
        """Refuse values that the user gave and that violate bounds, which are numbers or arrays."""
        low, high = np.broadcast_arrays(*bounds, values)[:2]
        outside = (values < low) | (values > high)
        if symbol in self._values and outside.any():
            at = int(np.flatnonzero(outside)[0])
            raise ValueError(
                f"`guess[{symbol}]` must lie within its `bounds`, "
                f"{shown_pair((float(low[at]), float(high[at])))}, got {float(values[at])!r}."
            )


def follow_constraints(
    transcription: Transcription, z: np.ndarray, moving: Sequence[int], count: int
) -> None:
    """Solve the first `count` constraints for the coordinates `moving`, in place, slot by slot.

    Each slot starts from its guess plus the correction of the slot before, so that a mechanism
    stays on its branch. A slot at which the constraints cannot be solved retains its guess.
    """
    times, slopes = transcription.state_slots
    value_slots = np.flatnonzero(~slopes)
    slots = value_slots[np.argsort(times[value_slots], kind="stable")]
    group, states = transcription.constraints_at(slots), list(moving)
    f, shift = group.functions, np.zeros(len(states))
    J, every = np.zeros((group.rows, f.sizes[0])), group.data_at(z)
    for k in range(len(slots)):
        at, data = group.at[:, [k]], np.ascontiguousarray(every[:, [k]])
        X = z[at]
        X[states, 0] += shift
        for _ in range(8):  # Newton's method converges quadratically, or the guess is retained
            J[tuple(f.jacobian_at.T)] = f("jacobian", X, data, group.constants)[:, 0]
            residuals, jacobian = f("rows", X, data, group.constants)[:count, 0], J[:count]
            if not (np.isfinite(residuals).all() and np.isfinite(jacobian).all()):
                break
            if (np.abs(residuals) <= DIGITS * (np.abs(jacobian) @ np.abs(X[:, 0]))).all():
                shift = X[states, 0] - z[at[states, 0]]
                z[at[states, 0]] = X[states, 0]
                break
            X[states, 0] -= least_step(jacobian[:, states], residuals)


def shown_pair(limits: tuple[float, float]) -> str:
    """Format bounds for a message, as users write them."""
    low, high = (None if np.isinf(value) else value for value in limits)
    return repr(low) if low == high else f"({low!r}, {high!r})"
