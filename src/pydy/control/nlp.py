"""A sparse nonlinear program whose functions are sums over points.

    minimise  Σ cost(X, R, P)   such that   lower ≤ z ≤ upper,   low ≤ rows(X, R, P) ≤ high

The variables X of a point are some of the unknowns z; the constants P are those of its piece.
Solvers see it in units of its own: with z = sizes · y, each row and the objective divided by their
sizes, no tolerance depends on the units in which a model is written.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from pydy._rank import or_one
from pydy.control.kernel import Functions
from pydy.control.tuning import UNEVEN

__all__ = ["Nlp", "Piece"]


@dataclass(frozen=True, eq=False)
class Piece:
    """Functions of points, with their unknowns, data and bounds.

    Attributes
    ----------
    functions : Functions
    at : ndarray of int, shape (variables, points)
        Which unknowns the points' variables are.
    data : ndarray, shape (data, points)
    constants : ndarray
        The numbers P.
    low, high : ndarray, shape (rows,)
    labels : tuple of str
        What each row is, for messages.
    fractions : ndarray, shape (points,)
        The times of the points, as fractions of the duration; NaN where they have none.
    collocated : bool
        Whether these are collocation points.
    """

    functions: Functions
    at: np.ndarray
    data: np.ndarray
    constants: np.ndarray
    low: np.ndarray
    high: np.ndarray
    labels: tuple[str, ...]
    fractions: np.ndarray
    collocated: bool

    @property
    def rows(self) -> int:
        """Number of rows at each point."""
        return len(self.labels)

    @property
    def points(self) -> int:
        """Number of points."""
        return len(self.fractions)

    @property
    def shortest(self) -> np.ndarray:
        """The shortest interval of the mesh, as a share of each collocation point's."""
        return self.data[1].min() / self.data[1] if self.collocated else np.ones(1)


@dataclass(frozen=True, eq=False)
class Nlp:
    """A nonlinear program; rows are ordered by pieces, then rows, then points.

    Attributes
    ----------
    pieces : sequence of Piece
    lower, upper : ndarray, shape (n,)
        Bounds of the unknowns z.
    sizes : ndarray, shape (n,)
        The units of the unknowns.
    row_sizes : ndarray, shape (m,)
        One by default.
    cost_size : float
    estimated : bool
        Whether the solver estimates the Hessian, as no piece has it.
    jacobian_at, hessian_at : (ndarray of int32, ndarray of int32)
        Rows and columns of the entries; those of the Hessian are of its lower triangle, and
        entries of the same place are to be added.
    """

    pieces: Sequence[Piece]
    lower: np.ndarray
    upper: np.ndarray
    sizes: np.ndarray
    row_sizes: np.ndarray = field(default_factory=lambda: np.empty(0))
    cost_size: float = 1.0
    estimated: bool = False
    jacobian_at: tuple[np.ndarray, np.ndarray] = field(init=False)
    hessian_at: tuple[np.ndarray, np.ndarray] = field(init=False)
    _units: list[np.ndarray] = field(init=False, repr=False)
    _weights: list[np.ndarray] = field(init=False, repr=False)
    _jacobian_units: np.ndarray = field(init=False, repr=False)
    _hessian_units: np.ndarray = field(init=False, repr=False)

    def __post_init__(self) -> None:
        rows, columns, lower, upper, twice = [], [], [], [], []
        start = 0
        for piece in self.pieces:
            k, f = np.arange(piece.points), piece.functions
            for i, j in f.jacobian_at:
                rows.append(start + i * piece.points + k)
                columns.append(piece.at[j])
            for i, j in f.hessian_at:
                lower.append(np.maximum(piece.at[i], piece.at[j]))
                upper.append(np.minimum(piece.at[i], piece.at[j]))
                # Two variables of a point that are one unknown meet twice on the diagonal.
                twice.append((i != j) & (piece.at[i] == piece.at[j]))
            start += piece.rows * piece.points
        self._set("jacobian_at", (_indices(rows), _indices(columns)))
        self._set("hessian_at", (_indices(lower), _indices(upper)))
        self._set("_units", [self.sizes[piece.at] for piece in self.pieces])
        if not len(self.row_sizes):
            self._set("row_sizes", np.ones(start))
        i, j = self.jacobian_at
        self._set("_jacobian_units", self.row_sizes[i] / self.sizes[j])
        i, j = self.hessian_at
        units = self.sizes[i] * self.sizes[j]
        self._set("_hessian_units", units * np.where(np.concatenate([[], *twice]), 2.0, 1.0))
        weighted = []
        for piece in self.pieces:
            m, costs = piece.functions.outputs
            weighted.append(np.concatenate([piece.data, np.zeros((m + costs, piece.points))]))
        self._set("_weights", weighted)

    def _set(self, name: str, value: object) -> None:
        object.__setattr__(self, name, value)

    @property
    def size(self) -> int:
        """Number of unknowns."""
        return len(self.lower)

    @property
    def rows(self) -> int:
        """Number of rows."""
        return len(self.row_sizes)

    @property
    def row_bounds(self) -> tuple[np.ndarray, np.ndarray]:
        """Bounds of the rows, not divided by their sizes."""
        bounds = [
            [np.repeat(own, piece.points) for own in (piece.low, piece.high)]
            for piece in self.pieces
        ]
        low, high = (np.concatenate([b[k] for b in bounds]) for k in (0, 1))
        return low, high

    # -- functions of y, in units of their own ----------------------------------------------------

    def _points(self, k: int, y: np.ndarray) -> np.ndarray:
        """Return the variables of the points of a piece."""
        X: np.ndarray = y[self.pieces[k].at]
        X *= self._units[k]
        return X

    def cost(self, y: np.ndarray) -> float:
        """Return the objective, NaN where it cannot be computed."""
        total = 0.0
        for k, piece in enumerate(self.pieces):
            if "cost" in piece.functions.kernels:
                out = np.empty((1, piece.points))
                ok = piece.functions("cost", self._points(k, y), piece.data, piece.constants, out)
                total += float(out.sum()) if ok else np.nan
        return total / self.cost_size

    def gradient(self, y: np.ndarray, out: np.ndarray) -> bool:
        """Write the gradient of the objective; return whether it could be computed."""
        out[:] = 0.0
        fine = True
        for k, piece in enumerate(self.pieces):
            f = piece.functions
            if "gradient" in f.kernels:
                slopes = np.empty((len(f.gradient_at), piece.points))
                fine &= f("gradient", self._points(k, y), piece.data, piece.constants, slopes)
                places = piece.at[f.gradient_at].ravel()
                out += np.bincount(places, slopes.ravel(), minlength=len(out))
        out *= self.sizes / self.cost_size
        return fine

    def values(self, y: np.ndarray, out: np.ndarray) -> bool:
        """Write the rows; return whether they could be computed."""
        return self._written("rows", y, out, self.row_sizes)

    def jacobian(self, y: np.ndarray, out: np.ndarray) -> bool:
        """Write the entries of the rows' Jacobian; return whether they could be computed."""
        return self._written("jacobian", y, out, self._jacobian_units)

    def _written(self, name: str, y: np.ndarray, out: np.ndarray, divisor: np.ndarray) -> bool:
        start, fine = 0, True
        for k, piece in enumerate(self.pieces):
            f = piece.functions
            if name in f.kernels:
                count = len(f.kernels[name].program.outputs) * piece.points
                part = out[start : start + count].reshape(-1, piece.points)
                fine &= f(name, self._points(k, y), piece.data, piece.constants, part)
                start += count
        out /= divisor
        return fine

    def hessian(
        self, y: np.ndarray, weight: float, multipliers: np.ndarray, out: np.ndarray
    ) -> bool:
        """Write the entries of the Hessian of ``weight · cost + multipliers · rows``."""
        first, start, fine = 0, 0, True
        weights = multipliers / self.row_sizes
        for k, piece in enumerate(self.pieces):
            f, data = piece.functions, self._weights[k]
            m, costs = f.outputs
            taken = weights[first : first + m * piece.points]
            data[len(piece.data) : len(piece.data) + m] = taken.reshape(m, piece.points)
            if costs:
                data[-1] = weight / self.cost_size
            first += m * piece.points
            if "hessian" in f.kernels:
                count = len(f.hessian_at) * piece.points
                part = out[start : start + count].reshape(-1, piece.points)
                fine &= f("hessian", self._points(k, y), data, piece.constants, part)
                start += count
        out *= self._hessian_units
        return fine

    # -- units ------------------------------------------------------------------------------------

    def in_own_units(self, z: np.ndarray) -> Nlp:
        """Return the same with rows and objective divided by how much they vary.

        A row varies by its largest derivative times the size of that unknown, for all points
        alike, unless their intervals are very different. The objective does so by its slope and its
        curvature: one that is a sum of squares is flat where a search may begin.
        """
        y = z / self.sizes
        J = np.empty(len(self.jacobian_at[0]))
        self.jacobian(y, J)
        sizes = np.zeros(self.rows)
        np.maximum.at(sizes, self.jacobian_at[0], np.abs(np.nan_to_num(J)))
        start = 0
        for piece in self.pieces:
            stop = start + piece.rows * piece.points
            groups = sizes[start:stop].reshape(piece.rows, piece.points)
            largest = groups.max(axis=1, keepdims=True, initial=0.0)
            uneven = piece.shortest < UNEVEN
            groups[:] = np.where(uneven, np.maximum(groups, piece.shortest * largest), largest)
            start = stop
        slope = np.empty(self.size)
        self.gradient(y, slope)
        curved = np.zeros(self.size)
        i, j = self.hessian_at
        if not self.estimated:
            H = np.zeros(len(i))
            self.hessian(y, 1.0, np.zeros(self.rows), H)
            np.add.at(curved, i, np.abs(H) / 2)
            np.add.at(curved, j[i != j], np.abs(H[i != j]) / 2)
        else:
            self.gradient(y + 1.0, curved)  # by their sizes farther, all at once
            curved = np.abs(curved - slope) / 2
        size = float(np.max(np.nan_to_num(np.abs(slope) + curved), initial=0.0))
        return replace(self, row_sizes=or_one(sizes), cost_size=size if size > 0.0 else 1.0)


def _indices(parts: list[np.ndarray]) -> np.ndarray:
    return np.concatenate([np.empty(0, dtype=int), *parts]).astype(np.int32)
