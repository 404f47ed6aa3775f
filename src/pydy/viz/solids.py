"""Shapes that are drawn as triangles made here: polyhedra, discs, knots and tubes."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np

from pydy._checks import real_array, shown
from pydy.viz.shape import Shape
from pydy.viz.tuning import FLAT

__all__ = [
    "Circle",
    "Cube",
    "Icosahedron",
    "Octahedron",
    "Tetrahedron",
    "TorusKnot",
    "Tube",
    "along",
    "hull",
    "knot",
    "polyhedron",
]

_AROUND = 12  # corners of a tube's section
_GOLDEN = (1 + 5**0.5) / 2


@dataclass(unsafe_hash=True)
class Cube(Shape):
    """A cube about the point, with edges along x, y and z."""

    length: Any
    lengths = ("length",)


@dataclass(unsafe_hash=True)
class Circle(Shape):
    """A disc about the point in the plane of x and y."""

    radius: Any = 10.0
    lengths = ("radius",)


@dataclass(unsafe_hash=True)
class Tetrahedron(Shape):
    """A tetrahedron whose corners are at a distance of `radius` from the point."""

    radius: Any = 10.0
    lengths = ("radius",)


@dataclass(unsafe_hash=True)
class Octahedron(Shape):
    """An octahedron with corners on x, y and z at a distance of `radius` from the point."""

    radius: Any = 10.0
    lengths = ("radius",)


@dataclass(unsafe_hash=True)
class Icosahedron(Shape):
    """An icosahedron whose corners are at a distance of `radius` from the point."""

    radius: Any = 10.0
    lengths = ("radius",)


@dataclass(unsafe_hash=True)
class TorusKnot(Shape):
    """A trefoil knot about the z axis: a tube of `tube` around a curve of about `radius`."""

    radius: Any
    tube: Any
    lengths = ("radius", "tube")
    spellings = Shape.spellings | {"tube_radius": "tube"}


@dataclass(unsafe_hash=True)
class Tube(Shape):
    """A tube through points that are fixed in the frame.

    Attributes
    ----------
    radius : length
    points : array_like, shape (n, 3)
        In the frame's axes, from the shape's point.
    """

    radius: Any
    points: Any
    lengths = ("radius",)

    def __post_init__(self) -> None:
        super().__post_init__()
        points = real_array(self.points, "`points` of Tube")
        if points.ndim != 2 or points.shape[1] != 3 or len(points) < 2:
            raise ValueError(
                "`points` of Tube must have the shape (n, 3) with two points or more, got "
                f"{shown(self.points)}."
            )
        self._set("points", tuple(map(tuple, points.tolist())))

    def scaled(self, factor: float) -> Self:
        """Return this tube with its points moved as well."""
        return replace(super().scaled(factor), points=factor * np.array(self.points))


def polyhedron(shape: Shape) -> np.ndarray:
    """Return the corners of a regular polyhedron of radius one."""
    corners: list[tuple[float, float, float]]
    if isinstance(shape, Tetrahedron):
        corners = [(1, 1, 1), (-1, -1, 1), (-1, 1, -1), (1, -1, -1)]
    elif isinstance(shape, Octahedron):
        corners = [(s * (k == 0), s * (k == 1), s * (k == 2)) for k in range(3) for s in (1, -1)]
    else:
        pairs = [(a, b * _GOLDEN) for a in (1, -1) for b in (1, -1)]
        corners = [c for a, b in pairs for c in ((0, a, b), (a, b, 0), (b, 0, a))]
    table = np.array(corners, dtype=float)
    unit: np.ndarray = table / np.linalg.norm(table[0])
    return unit


def hull(points: Any) -> tuple[np.ndarray, np.ndarray] | None:
    """Return the triangles of the convex hull of points, or None for what is no list of points.

    They are counter-clockwise from outside.
    """
    from scipy.spatial import ConvexHull

    try:
        table = real_array(points, "")
    except (TypeError, ValueError):
        return None
    if table.ndim != 2 or table.shape[1] != 3 or len(table) < 3 or not np.isfinite(table).all():
        return None
    flat = np.linalg.matrix_rank(table - table.mean(0), tol=FLAT * np.ptp(table)) < 3
    found = ConvexHull(table, qhull_options="QJ" if flat else "Qt").simplices
    a, b, c = (table[found[:, k]] for k in range(3))
    inwards = np.einsum("ij,ij->i", np.cross(b - a, c - a), a - table.mean(0)) < 0
    found[inwards] = found[inwards][:, ::-1]
    return table, found


def knot(radius: float, count: int = 96) -> np.ndarray:
    """Return the points of a closed trefoil: twice around the z axis, three times through."""
    angle = np.linspace(0.0, 4 * np.pi, count, endpoint=False)
    away = radius * (2 + np.cos(1.5 * angle)) / 2
    height = radius * np.sin(1.5 * angle) / 2
    return np.stack([away * np.cos(angle), away * np.sin(angle), height], 1)


def along(points: np.ndarray, radius: float, closed: bool) -> tuple[np.ndarray, np.ndarray]:
    """Return the triangles of a tube along points."""
    if closed:
        ahead = np.roll(points, -1, 0) - np.roll(points, 1, 0)
    else:
        ahead = np.gradient(points, axis=0)
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    side = np.cross(ahead[0], np.eye(3)[int(np.abs(ahead[0]).argmin())])
    turn = np.arange(_AROUND) * (2 * np.pi / _AROUND)
    rings = []
    for point, direction in zip(points, ahead, strict=True):
        side = side - (side @ direction) * direction  # carried along without a twist
        side /= np.linalg.norm(side)
        other = np.cross(direction, side)
        section = np.outer(np.cos(turn), side) + np.outer(np.sin(turn), other)
        rings.append(point + radius * section)
    rows = len(points) if closed else len(points) - 1
    i, j = np.divmod(np.arange(rows * _AROUND), _AROUND)
    a, b = i * _AROUND + j, i * _AROUND + (j + 1) % _AROUND
    n = len(points) * _AROUND
    c, d = (a + _AROUND) % n, (b + _AROUND) % n
    faces = [np.stack([a, b, c], 1), np.stack([b, d, c], 1)]
    if not closed:  # caps
        k = np.arange(1, _AROUND - 1)
        faces += [np.stack([0 * k, k + 1, k], 1), n - _AROUND + np.stack([0 * k, k, k + 1], 1)]
    return np.concatenate(rings), np.concatenate(faces)
