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

from pydy._forks import cached_property
from pydy._rank import or_one
from pydy.control.kernel import Functions
from pydy.control.native import Native
from pydy.control.tuning import UNEVEN


@dataclass(frozen=True, eq=False)
class Piece:
    """Functions of points, with their unknowns, data and bounds."""

    functions: Functions
    at: np.ndarray  # (variables, points), which unknowns the points' variables are
    data: np.ndarray  # (data, points)
    constants: np.ndarray  # the numbers P
    low: np.ndarray  # (rows,)
    high: np.ndarray  # (rows,)
    labels: tuple[str, ...]  # what each row is, for messages
    # (points,), the times of the points, as fractions of the duration; NaN where they have none.
    fractions: np.ndarray
    collocated: bool  # whether these are collocation points

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
    """A nonlinear program; rows are ordered by pieces, then rows, then points."""

    pieces: Sequence[Piece]
    # (n,), bounds of the unknowns z.
    lower: np.ndarray
    upper: np.ndarray
    sizes: np.ndarray  # (n,), the units of the unknowns
    row_sizes: np.ndarray = field(default_factory=lambda: np.empty(0))  # (m,), one by default
    cost_size: float = 1.0
    estimated: bool = False  # whether the solver estimates the Hessian, as no piece has it
    # Rows and columns of the entries; those of the Hessian are of its lower triangle, and entries
    # of the same place are to be added.
    jacobian_at: tuple[np.ndarray, np.ndarray] = field(init=False)
    hessian_at: tuple[np.ndarray, np.ndarray] = field(init=False)
    # What the Jacobian's entries are divided by, and the Hessian's multiplied with.
    derivative_units: tuple[np.ndarray, np.ndarray] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        rows, columns, lower, upper, twice = [], [], [], [], []
        start = 0
        for piece in self.pieces:
            k, f = np.arange(piece.points), piece.functions
            i, j = f.jacobian_at.T
            rows.append((start + i[:, None] * piece.points + k).ravel())
            columns.append(piece.at[j].ravel())
            i, j = f.hessian_at.T
            first, second = piece.at[i], piece.at[j]
            lower.append(np.maximum(first, second).ravel())
            upper.append(np.minimum(first, second).ravel())
            # Two variables of a point that are one unknown meet twice on the diagonal.
            twice.append(((i != j)[:, None] & (first == second)).ravel())
            start += piece.rows * piece.points
        self._set("jacobian_at", (_indices(rows), _indices(columns)))
        self._set("hessian_at", (_indices(lower), _indices(upper)))
        if not len(self.row_sizes):
            self._set("row_sizes", np.ones(start))
        i, j = self.jacobian_at
        divisor = self.row_sizes[i] / self.sizes[j]
        i, j = self.hessian_at
        factor = self.sizes[i] * self.sizes[j] * np.where(np.concatenate([[], *twice]), 2.0, 1.0)
        self._set("derivative_units", (divisor, factor))

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

    @cached_property
    def native(self) -> Native:
        """The compiled functions, which write to arrays of this object: one thread at a time."""
        return Native(self)

    def __getstate__(self) -> dict[str, object]:
        return {key: value for key, value in self.__dict__.items() if key != "native"}

    def cost(self, y: np.ndarray) -> float:
        """Return the objective, NaN where it cannot be computed."""
        out = np.empty(1)
        self.native.cost(np.ascontiguousarray(y, float), out)
        return float(out[0])

    def gradient(self, y: np.ndarray, out: np.ndarray) -> bool:
        """Write the gradient of the objective; return whether it could be computed."""
        return self.native.gradient(np.ascontiguousarray(y, float), out)

    def values(self, y: np.ndarray, out: np.ndarray) -> bool:
        """Write the rows; return whether they are finite."""
        return self.native.rows(np.ascontiguousarray(y, float), out)

    def jacobian(self, y: np.ndarray, out: np.ndarray) -> bool:
        """Write the entries of the rows' Jacobian; return whether they could be computed."""
        return self.native.jacobian(np.ascontiguousarray(y, float), out)

    def hessian(
        self, y: np.ndarray, weight: float, multipliers: np.ndarray, out: np.ndarray
    ) -> bool:
        """Write the entries of the Hessian of ``weight · cost + multipliers · rows``."""
        multipliers = np.ascontiguousarray(multipliers, float)
        return self.native.hessian(np.ascontiguousarray(y, float), weight, multipliers, out)

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
