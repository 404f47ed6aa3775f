"""Eigenvalues along a parameter: branches, and where they cross the imaginary axis."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from itertools import islice
from typing import Any

import numpy as np
import scipy

from pydy._optional import require
from pydy._rank import ROUNDED
from pydy.analysis.linear import complex_plane
from pydy.analysis.tuning import ASTRAY, AT_ONCE, CROSSED, LEFT_AXIS, LOOKED_AT
from pydy.plot import axes_of, typeset, with_unit

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
        comes first. What is zero at all values comes last.
        """
        return self._spectra[0]

    @property
    def _active(self) -> np.ndarray:
        return self._spectra[1]

    @property
    def _branches(self) -> int:
        """How many branches are not zero at all values."""
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
        return np.asarray((self.eigenvalues.real <= self._nothing).all(axis=1))

    @property
    def neutral(self) -> tuple[str, ...]:
        """States on which no other state depends: each has an eigenvalue of zero."""
        return tuple(name for k, name in enumerate(self.states) if k not in self._active)

    @cached_property
    def _nothing(self) -> np.ndarray:
        """Real parts that are zero, for each eigenvalue."""
        found = self.eigenvalues
        most = CROSSED * float(np.abs(found).max(initial=0.0))
        limits = np.full(found.shape, most)
        doubtful = ((found.real != 0.0) & (np.abs(found.real) <= most)).any(axis=1)
        for k in np.flatnonzero(doubtful):
            spectrum, rounding = self._spectrum(self.A[k])
            nearest = np.abs(found[k, : len(spectrum), None] - spectrum).argmin(axis=1)
            limits[k, : len(spectrum)] = np.minimum(most, ASTRAY * rounding[nearest])
        return limits

    def crossings(self) -> tuple[Crossing, ...]:
        """Return where branches cross the imaginary axis, ascending in the parameter.

        Each crossing is accurate to rounding, computed from linear models at values in between.
        Only one of a conjugate pair is listed. Without damping, branches lie on the axis until they
        meet and one becomes unstable: these points are listed too.
        """
        found = []
        for branch in range(self._branches):
            real, limit = self.eigenvalues[:, branch].real, self._nothing[:, branch]
            seen = np.flatnonzero(np.abs(real) > limit)
            signs = np.sign(real[seen])
            for k in np.flatnonzero(signs[1:] != signs[:-1]):
                first, last = int(seen[k]), int(seen[k + 1])
                middle = self.eigenvalues[first : last + 1, branch].imag
                lower = middle.mean() <= -max(limit[first], limit[last])
                if not lower and not self._rests(branch, first, last):
                    found.append(self._refined(branch, first, last))
            for inside, out in self._departures(branch):
                if self.eigenvalues[out, branch].imag > -limit[out]:
                    found.append(self._departed(branch, inside, out))
        real_ones = (crossing for crossing in found if crossing is not None)
        return tuple(sorted(real_ones, key=lambda crossing: crossing.value))

    def _departures(self, branch: int) -> list[tuple[int, int]]:
        """Return the position on the axis next to an unstable part of a branch."""
        real = self.eigenvalues[:, branch].real
        seen = np.flatnonzero(np.abs(real) > self._nothing[:, branch])
        found = []
        for k, place in enumerate(seen):
            if real[place] < 0.0:
                continue
            for way, beyond in ((-1, seen[:k][::-1]), (1, seen[k + 1 :])):
                last = int(beyond[0]) if len(beyond) else (-1 if way < 0 else len(real))
                stable = len(beyond) and real[last] < 0.0
                ends = sorted((int(place), last))
                if abs(last - place) > 1 and not (stable and not self._rests(branch, *ends)):
                    steps = range(int(place) + way, last, way)
                    on_axis = (k for k in steps if self._is_on_axis(branch, k))
                    found += [(k, k - way) for k in islice(on_axis, 1)]
        return found

    def _rests(self, branch: int, first: int, last: int) -> bool:
        """Whether a branch lies on the axis for a while between two values at which it does not.

        It passes the axis at one value otherwise, which may be one of those between.
        """
        on_axis = [k for k in range(first + 1, last) if self._is_on_axis(branch, k)]
        if len(on_axis) != 1:
            return bool(on_axis)
        beside = (self._nearest(branch, on_axis[0], end, 0.5) for end in (first, last))
        return any(abs(found.real) <= rounding for found, rounding in beside)

    def _is_on_axis(self, branch: int, k: int) -> bool:
        """Whether nothing but rounding is left of a real part."""
        spectrum, rounding = self._spectrum(self.A[k])
        nearest = np.abs(spectrum - self.eigenvalues[k, branch]).argmin()
        return bool(abs(spectrum[nearest].real) <= rounding[nearest])

    def _nearest(self, branch: int, a: int, b: int, share: float) -> tuple[complex, float]:
        """Return the eigenvalue of a branch at a share of the way between values, its rounding."""
        first, last = self.eigenvalues[[a, b], branch]
        spectrum, rounding = self._between(a, b, share)
        k = np.abs(spectrum - (first + share * (last - first))).argmin()
        return complex(spectrum[k]), float(rounding[k])

    def _spectrum(self, A: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return with_rounding(A[np.ix_(self._active, self._active)])

    def _between(self, a: int, b: int, share: float) -> tuple[np.ndarray, np.ndarray]:
        """Return the eigenvalues between two values, without those that are always zero."""
        value, start = (of[a] + share * (of[b] - of[a]) for of in (self.values, self.equilibria))
        spectrum, rounding = self._spectrum(self._models(np.array([value]), start[None])[0])
        order = np.argsort(-np.abs(spectrum))[: self._branches]
        return spectrum[order], rounding[order]

    def _departed(self, branch: int, inside: int, out: int) -> Crossing | None:
        """Return the point between two values at which a branch leaves the axis."""

        def left(share: float) -> bool:
            found, rounding = self._nearest(branch, inside, out, share)
            return found.real > rounding

        return self._found(branch, (inside, out), _bisected(left), LEFT_AXIS, inside > out)

    def _refined(self, branch: int, first: int, last: int) -> Crossing | None:
        """Return the point between two values at which a branch passes the axis."""
        share = scipy.optimize.brentq(
            lambda share: self._nearest(branch, first, last, share)[0].real,
            0.0,
            1.0,
            xtol=ROUNDED,
            rtol=4 * np.finfo(float).eps,
        )
        stabilizing = bool(self.eigenvalues[last, branch].real < 0.0)
        return self._found(branch, (first, last), share, CROSSED, stabilizing)

    def _found(
        self, branch: int, ends: tuple[int, int], share: float, near: float, stabilizing: bool
    ) -> Crossing | None:
        """Return a crossing, if the branch is on the axis there: another may be taken for it."""
        found, rounding = self._nearest(branch, *ends, share)
        size = float(np.abs(self.eigenvalues[list(ends), branch]).max())
        if abs(found.real) > max(near * size, ASTRAY * rounding):
            return self._counted(branch, *ends, stabilizing)
        return self._crossing(branch, ends, share, found.imag, stabilizing)

    def _counted(self, branch: int, a: int, b: int, stabilizing: bool) -> Crossing | None:
        """Return where the number of unstable eigenvalues changes between two values, if it does.

        This needs no branches, but takes several crossings between the values for one.
        """

        def unstable(share: float) -> int:
            spectrum, rounding = self._between(a, b, share)
            return int((spectrum.real > rounding).sum())

        before = unstable(0.0)
        if unstable(1.0) == before:
            return None
        share = _bisected(lambda share: unstable(share) != before)
        spectrum = self._between(a, b, share)[0]
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
            oscillatory=abs(frequency) > float(self._nothing[[a, b], branch].max()),
            stabilizing=stabilizing,
        )

    def to_xarray(self) -> Any:
        """Return an `xarray.Dataset`: ``real`` and ``imag`` by parameter and branch, the states."""
        xarray = require("xarray", "ensemble", "to_xarray()")
        axes = (self.parameter, "branch")
        return xarray.Dataset(
            {
                "real": (axes, self.eigenvalues.real, {"units": "1/s"}),
                "imag": (axes, self.eigenvalues.imag, {"units": "1/s"}),
                "equilibrium": ((self.parameter, "place"), self.equilibria),
            },
            {self.parameter: self.values, "branch": np.arange(self.eigenvalues.shape[1])},
        )

    def plot(self, ax: Any = None, unit: str = "") -> Any:
        """Plot real parts, and imaginary parts dashed, over the parameter; return the Axes."""
        ax = axes_of(ax, "a plot")
        ax.axhline(0.0, color="0.7", linewidth=0.8)
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
        ax, found = complex_plane(ax), self.eigenvalues
        colours = np.broadcast_to(self.values[:, None], found.shape)
        points = ax.scatter(found.real, found.imag, c=colours, s=6)
        ax.scatter(found[0].real, found[0].imag, marker="x", color="k", linewidths=0.8)
        ax.figure.colorbar(points, ax=ax, label=with_unit(typeset(self.parameter, ""), unit))
        return ax


def _bisected(beyond: Callable[[float], bool]) -> float:
    """Return the first share of the way, up to rounding, from which a condition holds at 1."""
    low, high = 0.0, 1.0
    while high - low > ROUNDED:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if beyond(middle) else (middle, high)
    return high


def spectra_of(A: np.ndarray) -> tuple[np.ndarray, np.ndarray, int]:
    """Return the eigenvalues of state matrices in branches, and the states that matter to others.

    A column of zeros, such as that of a vehicle's position, is an eigenvalue of zero. Left in, it
    would join others to one multiple eigenvalue, of which only half the digits can be had. What is
    conserved otherwise is an eigenvalue of zero too, which a branch that passes zero must not be
    taken for: how many of the states that matter have one is returned last. Their columns are
    behind the branches.
    """
    m, k = A.shape[:2]
    # Parts of some milliseconds, between which a Ctrl-C is heard; no copy of all.
    count = max(1, min(AT_ONCE, AT_ONCE * 1000 // max(k, 1) ** 3))
    parts = [A[first : first + count] for first in range(0, m, count)]
    largest = np.zeros((k, k))
    for part in parts:
        np.maximum(largest, np.abs(part).max(axis=0), out=largest)
    # In units of their own, coordinates and speeds of 1e10 rad/s are alike.
    units = np.diag(scipy.linalg.matrix_balance(largest, permute=False)[1])
    scale = units / units[:, None]
    least = CROSSED * (largest * scale).max(initial=0.0)
    matters = np.zeros((k, k), dtype=bool)  # rows by columns
    for part in parts:
        entries = np.abs(part) * scale
        sizes = np.maximum(entries.max(axis=2, keepdims=True, initial=0.0), least)
        matters |= (entries > ROUNDED * sizes).any(axis=0)
    active = np.arange(k)
    while True:
        left = active[matters[np.ix_(active, active)].any(axis=0)]
        if len(left) == len(active):
            break
        active = left
    found = np.zeros((m, k), dtype=complex)
    zeros = 0
    if active.size:
        computed = [np.linalg.eigvals(part[:, active[:, None], active]) for part in parts]
        spectra = np.concatenate(computed).astype(complex)
        zeros = _always_zero(A, active, spectra)
        order = np.argsort(-np.abs(spectra), axis=1, kind="stable")
        spectra = np.take_along_axis(spectra, order, axis=1)
        count = len(active) - zeros
        found[:, :count] = _followed(spectra[:, :count])
        found[:, count : len(active)] = spectra[:, count:]
    return found, active, zeros


def _always_zero(A: np.ndarray, active: np.ndarray, spectra: np.ndarray) -> int:
    """Return how many eigenvalues are zero, up to rounding, in each of some matrices."""
    most = CROSSED * float(np.abs(spectra).max(initial=0.0))
    count = int((np.abs(spectra) <= most).sum(axis=1).min())
    for k in np.unique(np.linspace(0, len(A) - 1, LOOKED_AT, dtype=int)):
        if count == 0:
            break
        found, rounding = with_rounding(A[k][np.ix_(active, active)])
        count = min(count, int((np.abs(found) <= np.minimum(most, ASTRAY * rounding)).sum()))
    return count


def with_rounding(A: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the eigenvalues of a matrix, with bounds on their rounding errors.

    They are the condition numbers of the eigenvalues times the rounding of the balanced matrix
    (Golub & Van Loan, Matrix Computations, §7.2.2).
    """
    if not A.size:
        return np.empty(0, dtype=complex), np.empty(0)
    balanced = scipy.linalg.matrix_balance(A)[0]
    found, left, right = scipy.linalg.eig(balanced, left=True, right=True)
    cosines = np.abs((left.conj() * right).sum(axis=0))
    unit = 8.0 * len(A) * np.finfo(float).eps * np.linalg.norm(balanced)
    return found, unit / np.maximum(cosines, np.finfo(float).eps)


def _followed(spectra: np.ndarray) -> np.ndarray:
    """Return eigenvalues (m, k) in columns that are branches, each row in another order.

    Each row is matched with what the two rows before lead to expect, so that branches that cross
    are not mixed up.
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
