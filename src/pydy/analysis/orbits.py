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

_STUCK = 1e8
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
        return values[order]

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


@dataclass
class Shooting:
    """A search for k states that come back, in units of their sizes.

    The search keeps to the plane normal to the `slope`, and the period is an unknown unless that is
    None.
    """

    fly: Callable[[np.ndarray, float], Flight]  # from states, for a period
    first: Flight
    sizes: np.ndarray
    slope: np.ndarray | None  # the states' rates where the first flight begins
    names: Sequence[str]
    tolerance: float  # of the integration

    def found(self, start: np.ndarray) -> tuple[np.ndarray, Flight, float]:
        """Return the states, the flight from there, and the largest gap."""
        self.flown, self.period = self.first, self.first.period
        if self.slope is not None:
            slope = self.slope / self.sizes
            self.normal = slope / np.linalg.norm(slope)
        self.flight = self._scaled(self.first)
        self.z = self.begun = self.flight.begun(start / self.sizes)
        self._approach()
        self._settle()
        z, gap = self.z * self.sizes, self._gap() * self.sizes
        return z, self.flown, float(np.abs(gap).max(initial=0.0))

    def _scaled(self, flight: Flight) -> Flight:
        return flight.scaled(self.sizes, self.first.period)

    def _gap(self) -> np.ndarray:
        gap: np.ndarray = self.flight.end - self.z
        return gap

    def _moved(self, step: np.ndarray) -> tuple[np.ndarray, float]:
        """Return the states and the period after a step."""
        late = 0.0 if self.slope is None else float(step[-1]) * self.first.period
        return self.z + step[: len(self.z)], self.period + late

    def _approach(self) -> None:
        """Take steps after Levenberg and Marquardt, as long as the gap becomes smaller.

        Their weight vanishes with the gap: orbits of conservative systems come in families, of
        which the nearest is wanted.
        """
        weight = 1.0
        for _ in range(40):
            size = float(np.abs(self._gap()).max(initial=0.0))
            whole, right = self._equations()
            n = whole.shape[1]
            while weight < _STUCK:
                held = np.sqrt(weight * min(size, 1.0)) * np.eye(n)
                both = np.append(right, np.zeros(n))
                step = np.linalg.lstsq(np.vstack([whole, held]), both, rcond=ROUNDED)[0]
                if self._nearer(*self._moved(step), size):
                    weight *= 0.1
                    break
                if size <= ORBIT_CLOSED * _scale(self.z):
                    return
                weight = max(10.0 * weight, DAMPED)
            else:
                return

    def _nearer(self, z: np.ndarray, period: float, size: float) -> bool:
        """Go to a state if the flight from there leaves less than a gap of some size."""
        # Every motion comes back after no time at all, and an equilibrium after any.
        if period <= _SHORTEST * self.first.period:
            return False
        try:
            flown = self.fly(z * self.sizes, period)
        except RuntimeError:  # no event, or a failure of the integration
            return False
        flight = self._scaled(flown)
        speed = np.linalg.norm(self._scaled(self.first).rates)
        if self.slope is not None and np.linalg.norm(flight.rates) < _SHORTEST * speed:
            return False
        z = flight.begun(z)
        if not float(np.abs(flight.end - z).max()) < size:
            return False
        self.z, self.flown, self.flight, self.period = z, flown, flight, period
        return True

    def _settle(self) -> None:
        """Take the last steps, from where rounding is all that is left of the gap."""
        for left in range(3, -1, -1):
            gap = self._gap()
            if np.abs(gap).max(initial=0.0) <= ORBIT_CLOSED * _scale(self.z):
                return
            # Unstable motion makes a larger gap of what rounding and the integration leave: then
            # the start is as good as steps to a better one are small.
            whole, right = self._equations()
            step = np.linalg.lstsq(whole, right, rcond=self.tolerance)[0]
            open_by = np.abs([*step, *(right - whole @ step)]).max()
            grown = self.tolerance * float(np.linalg.norm(self.flight.by_start, 2))
            known = float(np.abs(gap).max(initial=0.0)) <= grown
            if known and open_by <= ORBIT_CLOSED * _scale(self.z):
                return
            if not (known and left):
                raise _lost(self.names, self.z * self.sizes, gap * self.sizes, self.period)
            z, self.period = self._moved(step)
            self.flown = self.fly(z * self.sizes, self.period)
            self.flight = self._scaled(self.flown)
            self.z = self.flight.begun(z)

    def _equations(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the linear equations of a step that closes the gap, in the plane of the search."""
        gap = self._gap()
        whole = self.flight.by_start - np.eye(len(gap))
        if self.slope is None:
            return whole, -gap
        border = np.append(self.normal, 0.0)
        whole = np.vstack([np.column_stack([whole, self.flight.rates]), border])
        return whole, np.append(-gap, -self.normal @ (self.z - self.begun))


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
