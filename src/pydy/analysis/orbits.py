"""Periodic motions by shooting, and their stability by Floquet multipliers.

A motion is periodic if its state after a period is its initial state. Newton's method solves for
the state, and for the period if the equations do not depend on time, with the monodromy matrix
∂x(T)/∂x(0) from the sensitivities. The eigenvalues of that matrix, the Floquet multipliers,
describe how small deviations grow from one period to the next.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pydy._errors import PeriodicOrbitError
from pydy._names import numbers_of
from pydy._rank import ROUNDED, or_one
from pydy.analysis.tuning import DAMPED, LEAST_SIZE, MARGIN, ORBIT_CLOSED

_ITERATIONS = 40
_STUCK = 1e8
# Steps from where rounding is all that is left of the gap.
_LAST = 3
# The least period, and the least rates of the states at its end, as shares of those at first.
_SHORTEST = 0.1


@dataclass(frozen=True, eq=False)
class PeriodicOrbit:
    """A periodic motion.

    Attributes
    ----------
    period : float
        In s.
    initial_conditions : dict
        All states at its start; they can be assigned to the System's attribute.
    states : tuple of str
        The independent states, except for those that advance steadily.
    monodromy : ndarray, shape (k, k)
        The derivatives of these states after a period with respect to those at its start; if an
        event ends the period, those of the state after the event.
    residual : float
        The largest change of a state over a period.
    autonomous : bool
        Whether the equations do not determine the start of the period: one multiplier is then 1.
    equilibrium : bool
        Whether nothing moves: the search converged to a fixed point, which is periodic with any
        period. The multipliers are those of small motions around it.
    trajectory : Trajectory
        Over one period.
    """

    period: float
    initial_conditions: dict[Any, float]
    states: tuple[str, ...]
    monodromy: np.ndarray
    residual: float
    autonomous: bool
    equilibrium: bool
    trajectory: Any

    @property
    def multipliers(self) -> np.ndarray:
        """Floquet multipliers, the largest first, shape (k,)."""
        values = np.linalg.eigvals(self.monodromy).astype(complex)
        order = np.lexsort((-values.imag, -values.real, -np.abs(values).round(12)))
        result: np.ndarray = values[order]
        return result

    @property
    def stable(self) -> bool:
        """Whether no multiplier exceeds 1, except the trivial one of an autonomous system."""
        values = self.multipliers
        if self.autonomous and values.size:
            values = np.delete(values, np.abs(values - 1.0).argmin())
        return bool((np.abs(values) <= 1.0 + MARGIN).all())

    def __str__(self) -> str:
        largest = np.abs(self.multipliers).max(initial=0.0)
        what = "Equilibrium over" if self.equilibrium else "Periodic orbit of"
        return (
            f"{what} {self.period:.10g} s, {'' if self.stable else 'un'}stable: "
            f"largest multiplier {largest:.6g}; residual {self.residual:.2g}"
        )

    __repr__ = __str__


@dataclass(frozen=True, eq=False)
class Flight:
    """A motion over one period, in k unknown states."""

    end: np.ndarray  # the states after it
    by_start: np.ndarray  # their derivatives (k, k)
    rates: np.ndarray  # their time derivatives at the end
    period: float
    sizes: np.ndarray  # how large they are on the way; see `Measure`
    projected: np.ndarray | None = None  # the states at its start, if they are not as wanted

    def scaled(self, sizes: np.ndarray, period: float) -> Flight:
        """Return the same in units of the states' sizes and of a period."""
        return replace(
            self,
            end=self.end / sizes,
            by_start=self.by_start * sizes / sizes[:, None],
            rates=self.rates * period / sizes,
            period=self.period / period,
            projected=None if self.projected is None else self.projected / sizes,
        )

    def begun(self, wanted: np.ndarray) -> np.ndarray:
        """Return the states at its start."""
        return wanted if self.projected is None else self.projected


@dataclass(frozen=True, eq=False)
class Measure:
    """How large n states are on the way: the units to search and to integrate in.

    A state that stays where it is has no size of its own but that of rounding. It gets a share of
    what others reach: of those with a like unit, of the motion with as much energy, and of a
    radian. The least of them is taken, since one too large would hide a gap.
    """

    # the states that are searched for; others, such as the way of a vehicle, measure nothing
    free: Sequence[int]
    # which of the states are speeds; they count as the amplitudes of an oscillation
    speeds: np.ndarray
    # how large coordinates are by themselves, and the integrals of speeds: of angles 1; 0 where
    # nothing tells
    natural: np.ndarray
    # the speeds, and the rates of the coordinates, in motions of one energy; 0 where these are not
    # known
    moved: np.ndarray

    def sizes(self, most: np.ndarray, rates: np.ndarray, period: float) -> np.ndarray:
        """Return the sizes of all states, 1 where nothing moves, if they become as large as `most`.

        Where a state is zero at the ends of an oscillation through zero, its rate there tells its
        size.
        """
        time = period / (2.0 * np.pi)
        unit = np.where(self.speeds, 1.0 / time, 1.0)
        sizes = np.maximum(np.abs(most), np.abs(rates) * time) / unit
        largest = float(sizes[self.free].max(initial=0.0))
        if not (np.isfinite(largest) and largest > 0.0):
            return np.ones(len(most))
        one = self.moved * time
        searched = np.isin(np.arange(len(most)), self.free)
        energetic = float((sizes / or_one(one))[searched & (one > 0.0)].max(initial=0.0))
        by_energy = LEAST_SIZE * energetic * one
        plain = self.natural == 0.0
        # What does not move by itself is no measure of others.
        alike = LEAST_SIZE * float(sizes[searched & plain & (sizes > by_energy)].max(initial=0.0))
        least = np.where(plain, alike if alike > 0.0 else np.inf, self.natural)
        least = np.minimum(least, np.where(by_energy > 0.0, by_energy, np.inf))
        least[np.isinf(least)] = LEAST_SIZE * largest
        found: np.ndarray = np.maximum(sizes, least) * unit
        return found


def shoot(
    fly: Callable[[np.ndarray, float], Flight],
    first: Flight,
    sizes: np.ndarray,
    start: np.ndarray,
    period: float,
    slope: np.ndarray | None,
    names: Sequence[str],
    tolerance: float,
) -> tuple[np.ndarray, Flight, float]:
    """Solve for k states that come back, in units of their sizes.

    ``fly(states, period)`` gives a Flight, of which the `first` leaves from the `start`. The
    `slope` has the states' rates there: the search keeps to the plane normal to them, and the
    period is an unknown unless it is None. The `tolerance` is that of the integration.
    """
    guess, k = period, len(start)
    flight = first.scaled(sizes, guess)
    begun = z = flight.begun(start / sizes)
    if slope is not None:
        slope = slope / sizes / np.linalg.norm(slope / sizes)
    gap, speed, period = flight.end - z, float(np.linalg.norm(flight.rates)), 1.0
    found, weight = first, 1.0
    for _ in range(_ITERATIONS):
        size = float(np.abs(gap).max(initial=0.0))
        whole, right = _equations(flight, gap, slope, z - begun)
        new = None
        while weight < _STUCK:
            # After Levenberg and Marquardt, with a weight that vanishes with the gap: orbits of
            # conservative systems come in families, of which the nearest is wanted.
            held = np.sqrt(weight * min(size, 1.0)) * np.eye(whole.shape[1])
            both = np.append(right, np.zeros(whole.shape[1]))
            step = np.linalg.lstsq(np.vstack([whole, held]), both, rcond=ROUNDED)[0]
            after = z + step[:k]
            new_period = period + float(step[k]) if slope is not None else period
            try:
                # Every motion comes back after no time at all, and an equilibrium after any.
                if new_period > _SHORTEST:
                    real = fly(after * sizes, new_period * guess)
                    new = real.scaled(sizes, guess)
                    if slope is not None and np.linalg.norm(new.rates) < _SHORTEST * speed:
                        new = None
            except RuntimeError:  # no event, or a failure of the integration
                new = None
            if new is not None:
                after = new.begun(after)
                if float(np.abs(new.end - after).max()) < size:
                    break
            new = None
            if size <= ORBIT_CLOSED * _scale(z):
                break
            weight = max(10.0 * weight, DAMPED)
        if new is None:
            break
        z, period, flight, found, gap = after, new_period, new, real, new.end - after
        weight *= 0.1
    size = float(np.abs(gap).max(initial=0.0))
    for left in range(_LAST, -1, -1):
        size = float(np.abs(gap).max(initial=0.0))
        if size <= ORBIT_CLOSED * _scale(z):
            break
        # Unstable motion makes a larger gap of what rounding and the integration leave: then the
        # start is as good as steps to a better one are small.
        whole, right = _equations(flight, gap, slope, z - begun)
        step = np.linalg.lstsq(whole, right, rcond=tolerance)[0]
        open_by = np.abs([*step, *(right - whole @ step)]).max()
        known = size <= tolerance * float(np.linalg.norm(flight.by_start, 2))
        if known and open_by <= ORBIT_CLOSED * _scale(z):
            break
        if not (known and left):
            raise _lost(names, z * sizes, gap * sizes, period * guess)
        z, period = z + step[:k], period + (float(step[k]) if slope is not None else 0.0)
        found = fly(z * sizes, period * guess)
        flight = found.scaled(sizes, guess)
        z = flight.begun(z)
        gap = flight.end - z
    return z * sizes, found, float(np.abs(gap * sizes).max(initial=0.0))


def _equations(
    flight: Flight, gap: np.ndarray, slope: np.ndarray | None, moved: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the linear equations of a step that closes the gap, in the plane of the search."""
    whole = flight.by_start - np.eye(len(gap))
    if slope is None:
        return whole, -gap
    whole = np.block([[whole, flight.rates[:, None]], [slope[None], np.zeros((1, 1))]])
    return whole, np.append(-gap, -slope @ moved)


def _scale(z: np.ndarray) -> float:
    return max(1.0, float(np.abs(z).max(initial=0.0)))


def _lost(
    names: Sequence[str], z: np.ndarray, gap: np.ndarray, period: float
) -> PeriodicOrbitError:
    order = np.argsort(-np.abs(gap))[:3]
    left = ", ".join(f"{names[k]} by {gap[k]:.3g}" for k in order)
    return PeriodicOrbitError(
        f"No periodic orbit was found. Nearest, at {numbers_of(names, z)} with the "
        f"period {period:.6g} s, these change over it: {left}. Start closer to an "
        "orbit, or list coordinates that advance steadily in `moving`.",
        z,
        gap,
    )
