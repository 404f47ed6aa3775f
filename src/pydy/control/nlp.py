"""A sparse nonlinear program whose functions are sums over points.

    minimise  Σ cost(X, R, P)   such that   lower ≤ z ≤ upper,   low ≤ rows(X, R, P) ≤ high

The variables X of a point are some of the unknowns z; the constants P are those of its group.
Solvers see a scaled program: with z = sizes · y, and rows and objective divided by their sizes, no
tolerance depends on the units in which a model is written. Solvers call the functions of
``_backends/core/nlp.c``, which have the signatures of IPOPT's C interface and run no Python. Their
structs are filled in here.
"""

from __future__ import annotations

import ctypes
import math
from collections.abc import Sequence
from copy import copy
from ctypes import c_bool, c_double, c_int, c_void_p
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._backends import nlp_functions
from pydy._forks import cached_property
from pydy._rank import or_one
from pydy.control.kernel import PointFunctions
from pydy.control.tuning import UNEVEN
from pydy.solvers import sampled_input_tables

if TYPE_CHECKING:
    from pydy.inputs import SampledInput

SIGNATURES: dict[str, tuple[type, ...]] = {
    "cost": (c_int, c_void_p, c_bool, c_void_p, c_void_p),
    "rows": (c_int, c_void_p, c_bool, c_int, c_void_p, c_void_p),
    "gradient": (c_int, c_void_p, c_bool, c_void_p, c_void_p),
    "jacobian": (c_int, c_void_p, c_bool, c_int, c_int, *[c_void_p] * 4),
    "hessian": (
        *(c_int, c_void_p, c_bool, c_double, c_int, c_void_p, c_bool, c_int),
        *[c_void_p] * 4,
    ),
}


@dataclass(frozen=True, eq=False)
class PointGroup:
    """Points that share compiled functions, with their unknowns, data and bounds."""

    functions: PointFunctions
    at: np.ndarray  # (variables, points), the indices in z of the points' variables
    data: np.ndarray  # (data, points)
    constants: np.ndarray  # the numbers P
    labels: tuple[str, ...]  # the names of the rows, for messages
    # (points,), the times of the points, as fractions of the duration; NaN where they have none.
    fractions: np.ndarray
    low: Any = 0.0  # (rows,), bounds, by default those of equations
    high: Any = 0.0
    collocated: bool = False  # whether these are collocation points
    # Indices in r, and SampledInputs. Their `cubics_at` the points' times are the last rows of the
    # data; the times depend on the duration, which is the last variable.
    signals: Sequence[tuple[np.ndarray, SampledInput]] = ()

    def __post_init__(self) -> None:
        for side in ("low", "high"):
            object.__setattr__(self, side, np.broadcast_to(getattr(self, side), self.rows))

    @property
    def rows(self) -> int:
        """Number of rows at each point."""
        return len(self.labels)

    @property
    def points(self) -> int:
        """Number of points."""
        return len(self.fractions)

    def evaluate(self, name: str, z: np.ndarray) -> np.ndarray:
        """Return the values of one of the functions at unknowns, (entries, points)."""
        return self.functions(name, z[self.at], self.data_at(z), self.constants)

    def data_at(self, z: np.ndarray) -> np.ndarray:
        """Return the data at unknowns."""
        if not self.signals:
            return self.data
        rows = cubics_at(self.signals, self.constants[-1] + z[self.at[-1]] * self.data[0])
        return np.concatenate([self.data[: -len(rows)], rows])

    @property
    def shortest(self) -> np.ndarray:
        """The shortest interval of the mesh, relative to the interval of each collocation point."""
        return self.data[1].min() / self.data[1] if self.collocated else np.ones(1)


def cubics_at(
    signals: Sequence[tuple[np.ndarray, SampledInput]], times: np.ndarray
) -> list[np.ndarray]:
    """Return five rows for each signal: the knot before each time, and the cubic from there on."""
    rows = []
    for _, samples in signals:
        knots, cubics = samples.breaks, samples.coefficients
        k = np.clip(np.searchsorted(knots, times, "right") - 1, 0, len(cubics) - 1)
        for cubic in np.moveaxis(cubics[k], 2, 0):
            rows += [knots[k], *cubic[:, ::-1].T]
    return rows


@dataclass(frozen=True, eq=False)
class Nlp:
    """A nonlinear program; rows are ordered by groups, then rows, then points."""

    groups: Sequence[PointGroup]
    # (n,), bounds of the unknowns z.
    lower: np.ndarray
    upper: np.ndarray
    sizes: np.ndarray  # (n,), the units of the unknowns
    row_sizes: np.ndarray = field(default_factory=lambda: np.empty(0))  # (m,), one by default
    cost_size: float = 1.0
    estimated: bool = False  # whether the solver estimates the Hessian, as no group has it
    # Rows and columns of the entries. The Hessian has its lower triangle only; entries with the
    # same indices are added.
    jacobian_at: tuple[np.ndarray, np.ndarray] = field(init=False)
    hessian_at: tuple[np.ndarray, np.ndarray] = field(init=False)

    def __post_init__(self) -> None:
        rows, columns, lower, upper = [], [], [], []
        start = 0
        for group in self.groups:
            k, f = np.arange(group.points), group.functions
            i, j = f.jacobian_at.T
            rows.append((start + i[:, None] * group.points + k).ravel())
            columns.append(group.at[j].ravel())
            i, j = f.hessian_at.T
            first, second = group.at[i], group.at[j]
            lower.append(np.maximum(first, second).ravel())
            upper.append(np.minimum(first, second).ravel())
            start += group.rows * group.points
        self._set("jacobian_at", (_indices(rows), _indices(columns)))
        self._set("hessian_at", (_indices(lower), _indices(upper)))
        if not len(self.row_sizes):
            self._set("row_sizes", np.ones(start))

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
    def derivative_units(self) -> tuple[np.ndarray, np.ndarray]:
        """Factors that scale the entries of the Jacobian and of the Hessian."""
        twice = [np.empty(0, dtype=bool)]
        for group in self.groups:
            i, j = group.functions.hessian_at.T
            # Two variables that are the same unknown contribute twice to its diagonal entry.
            twice.append(((i != j)[:, None] & (group.at[i] == group.at[j])).ravel())
        (row, column), (i, j) = self.jacobian_at, self.hessian_at
        curvatures = self.sizes[i] * self.sizes[j] * np.where(np.concatenate(twice), 2.0, 1.0)
        return self.sizes[column] / self.row_sizes[row], curvatures

    @property
    def row_bounds(self) -> tuple[np.ndarray, np.ndarray]:
        """Bounds of the rows, not divided by their sizes."""
        bounds = [
            [np.repeat(bound, group.points) for bound in (group.low, group.high)]
            for group in self.groups
        ]
        low, high = (np.concatenate([b[k] for b in bounds]) for k in (0, 1))
        return low, high

    def by_group(self, values: np.ndarray) -> list[tuple[PointGroup, np.ndarray]]:
        """Split values of all rows by group, as views (rows, points)."""
        ends = np.cumsum([group.rows * group.points for group in self.groups])
        parts = np.split(values, ends[:-1])
        return [
            (group, part.reshape(group.rows, group.points))
            for group, part in zip(self.groups, parts, strict=True)
        ]

    # -- scaled functions of y --------------------------------------------------------------------

    @cached_property
    def native(self) -> Native:
        """The compiled functions. They write to arrays of this object: one thread at a time."""
        return Native(self)

    def __getstate__(self) -> dict[str, object]:
        return {key: value for key, value in self.__dict__.items() if key != "native"}

    # -- units ------------------------------------------------------------------------------------

    def scaled_at(self, z: np.ndarray) -> Nlp:
        """Return the program with rows and objective scaled by how much they vary.

        A row varies by its largest derivative times the size of that unknown. The scale is the same
        at all points, unless their intervals have very different lengths. The objective's scale
        includes its curvature as well as its slope: a sum of squares may be flat at the guess.
        """
        y = z / self.sizes
        J = self.native("jacobian", y)[0]
        sizes = np.zeros(self.rows)
        np.maximum.at(sizes, self.jacobian_at[0], np.abs(np.nan_to_num(J)))
        for group, row_sizes in self.by_group(sizes):
            largest = row_sizes.max(axis=1, keepdims=True, initial=0.0)
            uneven = group.shortest < UNEVEN
            row_sizes[:] = np.where(
                uneven, np.maximum(row_sizes, group.shortest * largest), largest
            )
        slope = self.native("gradient", y)[0]
        curved = np.zeros(self.size)
        i, j = self.hessian_at
        if not self.estimated:
            H = self.native("hessian", y, 1.0, np.zeros(self.rows))[0]
            np.add.at(curved, i, np.abs(H) / 2)
            np.add.at(curved, j[i != j], np.abs(H[i != j]) / 2)
        else:
            curved = self.native("gradient", y + 1.0)[0]  # all unknowns moved by their sizes
            curved = np.abs(curved - slope) / 2
        size = float(np.max(np.nan_to_num(np.abs(slope) + curved), initial=0.0))
        scaled = self.of_cost_size(size if size > 0.0 else 1.0)
        scaled._set("row_sizes", or_one(sizes))
        scaled._set("native", Native(scaled, self.native))
        return scaled

    def of_cost_size(self, size: float) -> Nlp:
        """Return the program with the objective divided by another size."""
        scaled = copy(self)
        scaled._set("cost_size", size)
        return scaled


class Native:
    """The compiled functions of an Nlp: `addresses` by the keys of `SIGNATURES`.

    They take the `handle` as their last argument; it is valid as long as this object lives. With
    `like`, the functions of the same program with other scales, both share their arrays.
    """

    def __init__(self, nlp: Nlp, like: Native | None = None) -> None:
        code = nlp_functions()
        self.addresses = {name: code.addresses[f"nlp_{name}"] for name in SIGNATURES}
        self._call = {
            name: ctypes.CFUNCTYPE(c_bool, *kinds)(self.addresses[name])
            for name, kinds in SIGNATURES.items()
        }
        self._sizes = nlp.size, nlp.rows, len(nlp.jacobian_at[0]), len(nlp.hessian_at[0])
        self._references: list[object] = [code, like]
        self._tables: list[np.ndarray] = like._tables if like is not None else [
            np.array([self._part(nlp, k, name) for k, group in enumerate(nlp.groups)
                      if name in group.functions.programs], np.int64)
            for name in SIGNATURES
        ]  # fmt: skip
        units = [nlp.row_sizes, nlp.sizes / nlp.cost_size, *nlp.derivative_units]
        words = np.zeros(24, np.int64)
        words[:17] = [
            *(nlp.size, nlp.rows),
            *map(len, self._tables),
            *map(self._address_of, self._tables),
            *(self._address_of(np.ascontiguousarray(unit)) for unit in units),
            self._address_of(np.empty(nlp.size)),
        ]
        words[17:18].view(float)[0] = nlp.cost_size
        words[18:22] = [self._address_of(a) for a in (*nlp.jacobian_at, *nlp.hessian_at)]
        words[22:] = self._sizes[2:]
        self.handle = self._address_of(words)

    def _address_of(self, array: np.ndarray) -> int:
        """Store a reference to an array, and return the address of its data."""
        self._references.append(array)
        return int(array.ctypes.data)

    def _part(self, nlp: Nlp, k: int, name: str) -> list[int]:
        """Return one function of a group as the integers of its C struct."""
        group = nlp.groups[k]
        functions, points = group.functions, group.points
        words, scratch, code = functions.sweep(name)
        self._references.append(code)
        rows, costs = functions.outputs if name == "hessian" else (0, 0)
        data = np.concatenate([group.data, np.zeros((rows + costs, points))])
        words[11:] = points, *(1, points) * 3
        results = functions.programs[name].signature.num_outputs * points
        gradient_slots = group.at[functions.gradient_at] if name == "gradient" else np.empty(0)
        arrays = (
            np.ascontiguousarray(group.at, np.int64),
            np.ascontiguousarray(nlp.sizes[group.at]),
            data,
            np.ascontiguousarray(group.constants, float),
            np.empty(group.at.size),
            np.empty(results if name in ("cost", "gradient") else 0),
            np.empty(scratch),
            np.empty(points, np.uint8),
            np.ascontiguousarray(gradient_slots, np.int64),
        )
        tables, (length, runs) = sampled_input_tables(group.signals), runs_of(group.at)
        return [
            *(*words.tolist(), *(self._address_of(a) for a in arrays), rows, costs),
            *(len(tables[0]), len(group.data) - 5 * len(tables[0]), *map(self._address_of, tables)),
            *(length, self._address_of(runs)),
        ]

    def __call__(
        self, name: str, y: np.ndarray, weight: float = 1.0, multipliers: np.ndarray | None = None
    ) -> tuple[np.ndarray, bool]:
        """Evaluate a function at y; return its values and whether all are finite."""
        n, m, slopes, curvatures = self._sizes
        y = np.ascontiguousarray(y, float)
        weights = np.ascontiguousarray(np.empty(0) if multipliers is None else multipliers, float)
        count, extra = {
            "cost": (1, ()),
            "rows": (m, (m,)),
            "gradient": (n, ()),
            "jacobian": (slopes, (m, slopes, None, None)),
            "hessian": (curvatures, (weight, m, _at(weights), True, curvatures, None, None)),
        }[name]
        out = np.empty(count)
        fine = self._call[name](n, _at(y), True, *extra, _at(out), self.handle)
        return out, bool(fine)


def runs_of(at: np.ndarray) -> tuple[int, np.ndarray]:
    """Return the length of runs of consecutive indices, and the first index of each run.

    All runs have one length. The first index is −1 for a run that is not consecutive, as of an
    unknown that all points share.
    """
    follows = np.diff(at, axis=1) == 1
    ends = np.flatnonzero(~follows[follows.any(axis=1)].all(axis=0)) + 1
    length = math.gcd(at.shape[1], *ends.tolist())
    runs = at.reshape(-1, length)
    return length, np.where((np.diff(runs, axis=1) == 1).all(axis=1), runs[:, 0], -1)


def _at(array: np.ndarray) -> int:
    assert array.dtype == float and array.flags.c_contiguous  # noqa: PT018
    return int(array.ctypes.data)


def _indices(parts: list[np.ndarray]) -> np.ndarray:
    return np.concatenate([np.empty(0, dtype=int), *parts]).astype(np.int32)
