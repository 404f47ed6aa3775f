"""Eigenvalues along a parameter: branches, and where they cross the imaginary axis."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from itertools import islice
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy

from pydy._axes import axes_of, typeset, with_unit
from pydy._optional import require
from pydy._rank import ROUNDED
from pydy.analysis.linear import complex_plane
from pydy.analysis.tuning import (
    DEPARTURE_REAL_PART,
    VALUES_PER_PART,
    ZERO_CHECKS,
    ZERO_EIGENVALUE_FACTOR,
    ZERO_REAL_PART,
)

if TYPE_CHECKING:
    from xarray import Dataset

Models = Callable[[np.ndarray, np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Crossing:
    """Where the real part of an eigenvalue is zero.

    Attributes
    ----------
    value : float
        Of the parameter.
    eigenvalue : complex
    branch : int
    oscillatory : bool
        Whether the motion there oscillates; otherwise it is monotonic.
    stabilizing : bool
        Whether the real part becomes negative as the parameter advances.
    """

    value: float
    eigenvalue: complex
    branch: int
    oscillatory: bool
    stabilizing: bool


@dataclass(frozen=True, eq=False)
class EigenvalueSweep:
    """Eigenvalues of the linear models at the equilibria along a parameter.

    Attributes
    ----------
    parameter : str
    values : ndarray, shape (m,)
    A : ndarray, shape (m, k, k)
        The state matrices.
    states : tuple of str
        The independent states.
    equilibria : ndarray, shape (m, n)
        All states.
    """

    parameter: str
    values: np.ndarray
    A: np.ndarray
    states: tuple[str, ...]
    equilibria: np.ndarray
    _models: Models = field(repr=False)

    @cached_property
    def _spectra(self) -> tuple[np.ndarray, np.ndarray, int]:
        return spectra_of(self.A)

    @property
    def eigenvalues(self) -> np.ndarray:
        """Eigenvalues in 1/s, shape (m, k), complex.

        A column is a branch, followed from value to value; at the first value the largest real part
        comes first. Eigenvalues that are zero at all values come last.
        """
        return self._spectra[0]

    @property
    def _active(self) -> np.ndarray:
        return self._spectra[1]

    @property
    def _branches(self) -> int:
        """Number of branches that are not zero at all values."""
        return len(self._active) - self._spectra[2]

    def __str__(self) -> str:
        return (
            f"{len(self.states)} eigenvalues at {len(self.values)} values of "
            f"{self.parameter}, {self.values[0]:g} to {self.values[-1]:g}"
        )

    __repr__ = __str__

    @property
    def stable(self) -> np.ndarray:
        """Whether no real part is positive, shape (m,); rounding errors of zero are ignored."""
        return np.asarray((self.eigenvalues.real <= self._zero_limits).all(axis=1))

    @property
    def neutral(self) -> tuple[str, ...]:
        """States on which no other state depends: each has an eigenvalue of zero."""
        return tuple(name for k, name in enumerate(self.states) if k not in self._active)

    @cached_property
    def _zero_limits(self) -> np.ndarray:
        """Largest real part that counts as zero, for each eigenvalue."""
        eigenvalues = self.eigenvalues
        most = ZERO_REAL_PART * float(np.abs(eigenvalues).max(initial=0.0))
        limits = np.full(eigenvalues.shape, most)
        doubtful = ((eigenvalues.real != 0.0) & (np.abs(eigenvalues.real) <= most)).any(axis=1)
        for k in np.flatnonzero(doubtful):
            spectrum, rounding = self._spectrum(self.A[k])
            nearest = np.abs(eigenvalues[k, : len(spectrum), None] - spectrum).argmin(axis=1)
            limits[k, : len(spectrum)] = np.minimum(
                most, ZERO_EIGENVALUE_FACTOR * rounding[nearest]
            )
        return limits

    def crossings(self) -> tuple[Crossing, ...]:
        """Return where branches cross the imaginary axis, ascending in the parameter.

        Each crossing is accurate to rounding, computed from linear models at values in between.
        Only one of a conjugate pair is listed. Without damping, branches lie on the axis until they
        meet and one becomes unstable, at zero (divergence) or elsewhere (flutter): these points are
        listed too.
        """
        crossings = []
        for branch in range(self._branches):
            real, limit = self.eigenvalues[:, branch].real, self._zero_limits[:, branch]
            nonzero = np.flatnonzero(np.abs(real) > limit)
            signs = np.sign(real[nonzero])
            for k in np.flatnonzero(signs[1:] != signs[:-1]):
                first, last = int(nonzero[k]), int(nonzero[k + 1])
                middle = self.eigenvalues[first : last + 1, branch].imag
                lower_one = middle.mean() <= -max(limit[first], limit[last])  # of a conjugate pair
                if not lower_one and not self._stays_on_axis(branch, first, last):
                    crossings.append(self._axis_crossing(branch, first, last))
            for on_axis, unstable in self._departures(branch):
                if self.eigenvalues[unstable, branch].imag > -limit[unstable]:  # real ones too
                    crossings.append(self._departure_crossing(branch, on_axis, unstable))
        existing = (crossing for crossing in crossings if crossing is not None)
        return tuple(sorted(existing, key=lambda crossing: crossing.value))

    def _departures(self, branch: int) -> list[tuple[int, int]]:
        """Return index pairs (on the axis, unstable) where a branch departs from the axis."""
        real = self.eigenvalues[:, branch].real
        nonzero = np.flatnonzero(np.abs(real) > self._zero_limits[:, branch])
        departures = []
        for k, index in enumerate(nonzero):
            if real[index] < 0.0:
                continue
            for direction, following in ((-1, nonzero[:k][::-1]), (1, nonzero[k + 1 :])):
                last = int(following[0]) if len(following) else (-1 if direction < 0 else len(real))
                stable = len(following) and real[last] < 0.0
                ends = sorted((int(index), last))
                if abs(last - index) > 1 and not (
                    stable and not self._stays_on_axis(branch, *ends)
                ):
                    steps = range(int(index) + direction, last, direction)
                    on_axis = (k for k in steps if self._is_on_axis(branch, k))
                    departures += [(k, k - direction) for k in islice(on_axis, 1)]
        return departures

    def _stays_on_axis(self, branch: int, first: int, last: int) -> bool:
        """True if a branch lies on the axis for an interval between two values off the axis.

        Otherwise it crosses the axis at a single value, which may be one of those between.
        """
        on_axis = [k for k in range(first + 1, last) if self._is_on_axis(branch, k)]
        if len(on_axis) != 1:
            return bool(on_axis)
        midpoints = (self._nearest(branch, on_axis[0], end, 0.5) for end in (first, last))
        return any(abs(eigenvalue.real) <= rounding for eigenvalue, rounding in midpoints)

    def _is_on_axis(self, branch: int, k: int) -> bool:
        """True if a real part is a rounding error."""
        spectrum, rounding = self._spectrum(self.A[k])
        nearest = np.abs(spectrum - self.eigenvalues[k, branch]).argmin()
        return bool(abs(spectrum[nearest].real) <= rounding[nearest])

    def _nearest(self, branch: int, a: int, b: int, share: float) -> tuple[complex, float]:
        """Return a branch's eigenvalue at value a + share · (b − a), and its rounding error."""
        first, last = self.eigenvalues[[a, b], branch]
        spectrum, rounding = self._eigenvalues_between(a, b, share)
        k = np.abs(spectrum - (first + share * (last - first))).argmin()
        return complex(spectrum[k]), float(rounding[k])

    def _spectrum(self, A: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return with_rounding(A[np.ix_(self._active, self._active)])

    def _eigenvalues_between(self, a: int, b: int, share: float) -> tuple[np.ndarray, np.ndarray]:
        """Return the eigenvalues at a + share · (b − a), without those that are always zero."""
        value, start = (
            array[a] + share * (array[b] - array[a]) for array in (self.values, self.equilibria)
        )
        spectrum, rounding = self._spectrum(self._models(np.array([value]), start[None])[0])
        order = np.argsort(-np.abs(spectrum))[: self._branches]
        return spectrum[order], rounding[order]

    def _departure_crossing(self, branch: int, inside: int, out: int) -> Crossing | None:
        """Return the point between two values at which a branch departs from the axis."""

        def has_left_axis(share: float) -> bool:
            eigenvalue, rounding = self._nearest(branch, inside, out, share)
            return eigenvalue.real > rounding

        return self._checked_crossing(
            branch, (inside, out), _bisected(has_left_axis), DEPARTURE_REAL_PART, inside > out
        )

    def _axis_crossing(self, branch: int, first: int, last: int) -> Crossing | None:
        """Return the point between two values at which a branch crosses the axis."""
        share = scipy.optimize.brentq(
            lambda share: self._nearest(branch, first, last, share)[0].real,
            0.0,
            1.0,
            xtol=ROUNDED,
            rtol=4 * np.finfo(float).eps,
        )
        stabilizing = bool(self.eigenvalues[last, branch].real < 0.0)
        return self._checked_crossing(branch, (first, last), share, ZERO_REAL_PART, stabilizing)

    def _checked_crossing(
        self, branch: int, ends: tuple[int, int], share: float, near: float, stabilizing: bool
    ) -> Crossing | None:
        """Return a crossing, after a check that the matched eigenvalue lies on the axis."""
        eigenvalue, rounding = self._nearest(branch, *ends, share)
        size = float(np.abs(self.eigenvalues[list(ends), branch]).max())
        if abs(eigenvalue.real) > max(near * size, ZERO_EIGENVALUE_FACTOR * rounding):
            return self._crossing_by_count(branch, *ends, stabilizing)
        return self._crossing(branch, ends, share, eigenvalue.imag, stabilizing)

    def _crossing_by_count(self, branch: int, a: int, b: int, stabilizing: bool) -> Crossing | None:
        """Return where the number of unstable eigenvalues changes between two values, if it does.

        This needs no branches, but reports several crossings between the values as one.
        """

        def unstable(share: float) -> int:
            spectrum, rounding = self._eigenvalues_between(a, b, share)
            return int((spectrum.real > rounding).sum())

        before = unstable(0.0)
        if unstable(1.0) == before:
            return None
        share = _bisected(lambda share: unstable(share) != before)
        spectrum = self._eigenvalues_between(a, b, share)[0]
        frequency = abs(complex(spectrum[np.abs(spectrum.real).argmin()]).imag)
        return self._crossing(branch, (a, b), share, frequency, stabilizing)

    def _crossing(
        self,
        branch: int,
        ends: tuple[int, int],
        share: float,
        frequency: float,
        stabilizing: bool,
    ) -> Crossing:
        a, b = ends
        return Crossing(
            value=float(self.values[a] + share * (self.values[b] - self.values[a])),
            eigenvalue=complex(0.0, frequency),
            branch=branch,
            oscillatory=abs(frequency) > float(self._zero_limits[[a, b], branch].max()),
            stabilizing=stabilizing,
        )

    def to_xarray(self) -> Dataset:
        """Return an `xarray.Dataset`: ``real`` and ``imag`` by parameter and branch, the states."""
        xarray = require("xarray", "ensemble", "to_xarray()")
        axes = (self.parameter, "branch")
        dataset: Dataset = xarray.Dataset(
            {
                "real": (axes, self.eigenvalues.real, {"units": "1/s"}),
                "imag": (axes, self.eigenvalues.imag, {"units": "1/s"}),
                "equilibrium": ((self.parameter, "place"), self.equilibria),
            },
            {self.parameter: self.values, "branch": np.arange(self.eigenvalues.shape[1])},
        )
        return dataset

    def plot(self, ax: Any = None, unit: str = "") -> Any:
        """Plot real parts, and imaginary parts dashed, over the parameter; return the Axes.

        Dotted lines are at the `crossings`, which real parts of another size would hide.
        """
        ax = axes_of(ax, "a plot")
        ax.axhline(0.0, color="0.7", linewidth=0.8)
        for crossing in self.crossings():
            ax.axvline(crossing.value, color="0.5", linewidth=0.8, linestyle=":")
        for branch, column in enumerate(self.eigenvalues.T):
            colour = f"C{branch % 10}"
            ax.plot(self.values, column.real, color=colour)
            if column.imag.max() > 0.0:
                imag = np.where(column.imag > 0.0, column.imag, np.nan)
                ax.plot(self.values, imag, color=colour, linestyle="--")
        ax.set_xlabel(with_unit(typeset(self.parameter, ""), unit))
        ax.set_ylabel("real and imaginary (dashed) parts (1/s)")
        return ax

    def plot_root_locus(self, ax: Any = None, unit: str = "") -> Any:
        """Plot the branches in the complex plane, with the parameter as colour; return the Axes."""
        ax, eigenvalues = complex_plane(ax), self.eigenvalues
        colours = np.broadcast_to(self.values[:, None], eigenvalues.shape)
        points = ax.scatter(eigenvalues.real, eigenvalues.imag, c=colours, s=6)
        ax.scatter(eigenvalues[0].real, eigenvalues[0].imag, marker="x", color="k", linewidths=0.8)
        ax.figure.colorbar(points, ax=ax, label=with_unit(typeset(self.parameter, ""), unit))
        return ax


def _bisected(condition: Callable[[float], bool]) -> float:
    """Bisect [0, 1] for the smallest share at which a condition, true at 1, becomes true."""
    low, high = 0.0, 1.0
    while high - low > ROUNDED:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if condition(middle) else (middle, high)
    return high


def spectra_of(A: np.ndarray) -> tuple[np.ndarray, np.ndarray, int]:
    """Return the eigenvalues of state matrices in branches, the active states, and a zero count.

    A column of zeros, such as that of a vehicle's position, has an eigenvalue of zero. It is
    removed: together with other zeros it would be a multiple eigenvalue, which is accurate to half
    the digits only. The states that remain are active. Conserved quantities have eigenvalues of
    zero, too, which must not be confused with a branch that crosses zero: their number is returned
    last, and their columns follow the branches.
    """
    m, k = A.shape[:2]
    # Parts that take some milliseconds, so that Ctrl-C works; the full array is not copied.
    count = max(1, min(VALUES_PER_PART, VALUES_PER_PART * 1000 // max(k, 1) ** 3))
    parts = [A[first : first + count] for first in range(0, m, count)]
    largest = np.zeros((k, k))
    for part in parts:
        np.maximum(largest, np.abs(part).max(axis=0), out=largest)
    # Balancing makes coordinates and speeds of 1e10 rad/s comparable.
    units = np.diag(scipy.linalg.matrix_balance(largest, permute=False)[1])
    scale = units / units[:, None]
    least = ZERO_REAL_PART * (largest * scale).max(initial=0.0)
    matters = np.zeros((k, k), dtype=bool)  # rows by columns
    for part in parts:
        entries = np.abs(part) * scale
        sizes = np.maximum(entries.max(axis=2, keepdims=True, initial=0.0), least)
        matters |= (entries > ROUNDED * sizes).any(axis=0)
    active = np.arange(k)
    while True:
        remaining = active[matters[np.ix_(active, active)].any(axis=0)]
        if len(remaining) == len(active):
            break
        active = remaining
    eigenvalues = np.zeros((m, k), dtype=complex)
    zeros = 0
    if active.size:
        computed = [np.linalg.eigvals(part[:, active[:, None], active]) for part in parts]
        spectra = np.concatenate(computed).astype(complex)
        zeros = _always_zero(A, active, spectra)
        order = np.argsort(-np.abs(spectra), axis=1, kind="stable")
        spectra = np.take_along_axis(spectra, order, axis=1)
        count = len(active) - zeros
        eigenvalues[:, :count] = _followed(spectra[:, :count])
        eigenvalues[:, count : len(active)] = spectra[:, count:]
    return eigenvalues, active, zeros


def _always_zero(A: np.ndarray, active: np.ndarray, spectra: np.ndarray) -> int:
    """Return the number of eigenvalues that are zero, up to rounding, in all matrices."""
    most = ZERO_REAL_PART * float(np.abs(spectra).max(initial=0.0))
    count = int((np.abs(spectra) <= most).sum(axis=1).min())
    for k in np.unique(np.linspace(0, len(A) - 1, ZERO_CHECKS, dtype=int)):
        if count == 0:
            break
        eigenvalues, rounding = with_rounding(A[k][np.ix_(active, active)])
        count = min(
            count,
            int((np.abs(eigenvalues) <= np.minimum(most, ZERO_EIGENVALUE_FACTOR * rounding)).sum()),
        )
    return count


def with_rounding(A: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the eigenvalues of a matrix, with bounds on their rounding errors.

    They are the condition numbers of the eigenvalues times the rounding of the balanced matrix
    (Golub & Van Loan, Matrix Computations, §7.2.2).
    """
    if not A.size:
        return np.empty(0, dtype=complex), np.empty(0)
    balanced = scipy.linalg.matrix_balance(A)[0]
    eigenvalues, left_vectors, right_vectors = scipy.linalg.eig(balanced, left=True, right=True)
    cosines = np.abs((left_vectors.conj() * right_vectors).sum(axis=0))
    unit = 8.0 * len(A) * np.finfo(float).eps * np.linalg.norm(balanced)
    return eigenvalues, unit / np.maximum(cosines, np.finfo(float).eps)


def _followed(spectra: np.ndarray) -> np.ndarray:
    """Return eigenvalues (m, k) with each row reordered so that the columns are branches.

    Each row is matched with the linear extrapolation of the two rows before, so that branches that
    cross are not exchanged.
    """
    order = np.lexsort((-spectra.imag, -spectra.real), axis=-1)
    followed = np.take_along_axis(spectra, order, axis=-1)
    for k in range(1, len(followed)):
        before = followed[k - 1]
        expected = before if k == 1 else 2.0 * before - followed[k - 2]
        distance = np.abs(expected[:, None] - followed[k])
        nearest = distance.argmin(axis=1)
        if len(set(nearest.tolist())) < len(nearest):
            nearest = scipy.optimize.linear_sum_assignment(distance)[1]
        followed[k] = followed[k, nearest]
    return followed
