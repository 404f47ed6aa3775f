"""Triangles of shapes, for Matplotlib and for the extent of shapes.

The page builds its own, finer surfaces from the same dimensions; a browser test compares the two.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, singledispatch

import numpy as np

from pydy.viz import shapes

Surface = tuple[np.ndarray, np.ndarray]
"""Vertices, shape (n, 3), and triangles, shape (k, 3), counter-clockwise from outside."""

_AROUND = 24  # corners of a circle
_HEAD_LENGTH, _HEAD_RADIUS = 6.0, 2.5  # of an arrow, relative to the radius of its shaft


@singledispatch
def surface(shape: shapes.Shape) -> Surface:
    """Return the triangles of a shape with numerical lengths, in its own axes."""
    raise NotImplementedError(f"{type(shape).__name__} has no surface of its own.")


def _grid(point: Callable[[np.ndarray, np.ndarray], np.ndarray], rows: int, around: int) -> Surface:
    """Return a surface over (0…rows) × a closed circle, from a function of row and angle."""
    row, angle = np.meshgrid(
        np.arange(rows + 1.0), np.arange(around) * (2 * np.pi / around), indexing="ij"
    )
    vertices = point(row.ravel(), angle.ravel())
    i, j = np.meshgrid(np.arange(rows), np.arange(around), indexing="ij")
    a, b = (i * around + j).ravel(), (i * around + (j + 1) % around).ravel()
    c, d = a + around, b + around
    faces = np.concatenate([np.stack([a, c, b], 1), np.stack([b, c, d], 1)])
    return vertices, faces


def _revolve(profile: list[tuple[float, float]], axis: str, around: int = _AROUND) -> Surface:
    """Return the surface of revolution of (radius, height) pairs, from the top down."""
    radius, height = np.array(profile).T

    def point(row: np.ndarray, angle: np.ndarray) -> np.ndarray:
        k = row.astype(int)
        return np.stack([radius[k] * np.sin(angle), height[k], radius[k] * np.cos(angle)], 1)

    vertices, faces = _grid(point, len(profile) - 1, around)
    # Where the radius is zero, one of two triangles is degenerate.
    ends = vertices[faces]
    flat = (ends == np.roll(ends, 1, axis=1)).all(axis=2).any(axis=1)
    return _align_axis(vertices, "y", axis), faces[~flat]


def _align_axis(vertices: np.ndarray, source_axis: str, axis: str) -> np.ndarray:
    """Rotate vertices so that `source_axis` becomes `axis`: x → y → z → x."""
    return np.roll(vertices, "xyz".index(axis) - "xyz".index(source_axis), axis=1)


def _arc(radius: float, middle: float, start: float, stop: float) -> list[tuple[float, float]]:
    angles = np.linspace(start, stop, 9)
    return [(radius * float(np.sin(a)), middle + radius * float(np.cos(a))) for a in angles]


@surface.register
def _(shape: shapes.Sphere) -> Surface:
    upper, lower = (_arc(shape.radius, 0, *ends) for ends in ((0, np.pi / 2), (np.pi / 2, np.pi)))
    return _revolve(upper + lower[1:], "y")


@surface.register
def _(shape: shapes.Capsule) -> Surface:
    h, r = shape.length / 2, shape.radius
    return _revolve(_arc(r, h, 0, np.pi / 2) + _arc(r, -h, np.pi / 2, np.pi), shape.axis)


@surface.register
def _(shape: shapes.Cylinder) -> Surface:
    h, r = shape.length / 2, shape.radius
    return _revolve([(0, h), (r, h), (r, -h), (0, -h)], shape.axis)


def spoke(shape: shapes.Shape, vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return a mask of triangles that mark the rotation of a disc: a radius.

    It is a sector of both ends of a Cylinder that is shorter than its radius; otherwise none.
    """
    none = np.zeros(len(faces), dtype=bool)
    if not isinstance(shape, shapes.Cylinder) or shape.length >= shape.radius:
        return none
    around = _align_axis(vertices, shape.axis, "y")  # as in `_revolve`
    middle = around[faces].mean(axis=1)
    ends = (
        np.abs(middle[:, 1]) > shape.length / 3
    )  # triangles of the side are within a sixth of the length
    angle = np.arctan2(middle[:, 0], middle[:, 2])
    marked: np.ndarray = ends & (angle > 0.0) & (angle < 2 * np.pi / _AROUND)
    return marked


@surface.register
def _(shape: shapes.Cone) -> Surface:
    h, r = shape.length / 2, shape.radius
    return _revolve([(0, h), (r, -h), (0, -h)], shape.axis)


@surface.register
def _(shape: shapes.Torus) -> Surface:
    rows = 12

    def point(row: np.ndarray, angle: np.ndarray) -> np.ndarray:
        turn = row * (2 * np.pi / rows)
        distance = shape.radius + shape.tube * np.cos(turn)
        return np.stack(
            [distance * np.cos(angle), distance * np.sin(angle), -shape.tube * np.sin(turn)], 1
        )

    vertices, faces = _grid(point, rows, 2 * _AROUND)
    return _align_axis(vertices, "z", shape.axis), faces


@surface.register
def _(shape: shapes.Box) -> Surface:
    corners = np.array([[i, j, k] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)])
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = [part for a, b, c, d in sides for part in ((a, b, c), (a, c, d))]
    return corners * (np.array([shape.x, shape.y, shape.z]) / 2), np.array(faces)


@surface.register
def _(shape: shapes.Cube) -> Surface:
    return surface(shapes.Box(shape.length, shape.length, shape.length))


@surface.register
def _(shape: shapes.Circle) -> Surface:
    angle = np.arange(2 * _AROUND) * (np.pi / _AROUND)
    rim = shape.radius * np.stack([np.cos(angle), np.sin(angle), 0 * angle], 1)
    k = np.arange(1, len(rim) - 1)
    return rim, np.stack([0 * k, k, k + 1], 1)


@surface.register(shapes.Tetrahedron)
@surface.register(shapes.Octahedron)
@surface.register(shapes.Icosahedron)
def _(shape: shapes.Tetrahedron | shapes.Octahedron | shapes.Icosahedron) -> Surface:
    triangles = shapes.hull(shape.radius * shapes.polyhedron(shape))
    assert triangles is not None
    return triangles


@surface.register
def _(shape: shapes.TorusKnot) -> Surface:
    return shapes.tube_along(shapes.knot(shape.radius), shape.tube, closed=True)


@surface.register
def _(shape: shapes.Tube) -> Surface:
    return shapes.tube_along(np.array(shape.points), shape.radius, closed=False)


@surface.register
def _(shape: shapes.Plane) -> Surface:
    k = "xyz".index(shape.axis)
    first, second = (i for i in range(3) if i != k)
    vertices = np.zeros((4, 3))
    vertices[:, first] = np.array([-1, 1, 1, -1]) * shape.length / 2
    vertices[:, second] = np.array([-1, -1, 1, 1]) * shape.width / 2
    return vertices, np.array([(0, 1, 2), (0, 2, 3)])


@surface.register
def _(shape: shapes.Mesh) -> Surface:
    return shape.vertices * shape.scale, shape.faces


def rods(points: np.ndarray, radius: float) -> Surface:
    """Return cylinders that connect consecutive points."""
    segments = np.diff(points, axis=0)
    lengths = np.linalg.norm(segments, axis=1)
    around = 8 if radius < lengths.min() / 30 else _AROUND  # a thin rod needs few corners
    vertices, faces = _unit_rod(around)
    sizes = np.stack([np.full_like(lengths, radius), lengths, np.full_like(lengths, radius)], 1)
    placed = vertices * sizes[:, None] @ _onto(segments).swapaxes(1, 2) + points[:-1, None]
    offsets = len(vertices) * np.arange(len(segments))
    return placed.reshape(-1, 3), (faces + offsets[:, None, None]).reshape(-1, 3)


WIRE = 0.18  # radius of a spring's wire, relative to that of its helix
TUBE = 1.8  # radius of a damper's tube, relative to that of its rod


def coil(points: np.ndarray, radius: float, turns: int) -> Surface:
    """Return a helical spring between two points."""
    axis = points[1] - points[0]
    vertices, faces = helix(radius, turns, float(np.linalg.norm(axis)))
    return vertices @ _onto(axis[None])[0].T + points[0], faces


def helix(radius: float, turns: int, length: float) -> Surface:
    """Return a helical spring with straight ends, from the origin along y."""
    s = np.linspace(0.0, 1.0, 12 * turns + 1)
    angle = 2 * np.pi * turns * s
    away = np.stack([np.cos(angle), 0.12 + 0.76 * s, np.sin(angle)], 1)
    line = np.concatenate([[[0, 0, 0], [0, 0.1, 0]], away, [[0, 0.9, 0], [0, 1, 0]]])
    tall = length or radius  # zero length would give a degenerate surface
    return shapes.tube_along(line * np.array([radius, tall, radius]), WIRE * radius, closed=False)


def piston(points: np.ndarray, radius: float, tube: float) -> Surface:
    """Return a rod between two points and the tube around its end."""
    axis = points[1] - points[0]
    length = float(np.linalg.norm(axis))
    rod, faces = rods(points, radius)
    if not length > 0.0:
        return rod, faces
    start = points[1] - axis * min(tube / length, 1.0)
    around, tube_faces = rods(np.stack([start, points[1]]), TUBE * radius)
    return np.concatenate([rod, around]), np.concatenate([faces, tube_faces + len(rod)])


@cache
def _unit_rod(around: int) -> Surface:
    return _revolve([(0, 1), (1, 1), (1, 0), (0, 0)], "y", around)


def arrow(start: np.ndarray, vector: np.ndarray, radius: float) -> Surface:
    """Return an arrow from a point along a vector; a short one is all head."""
    length = float(np.linalg.norm(vector))
    size = min(1.0, length / (_HEAD_LENGTH * radius)) if radius else 0.0
    neck, head, r = length - size * _HEAD_LENGTH * radius, size * _HEAD_RADIUS * radius, radius
    profile = [(0, length), (head, neck), (size * r, neck), (size * r, 0), (0, 0)]
    vertices, faces = _revolve([(float(a), float(b)) for a, b in profile], "y")
    return vertices @ _onto(vector[None])[0].T + start, faces


def _onto(vectors: np.ndarray) -> np.ndarray:
    """Return rotations that map the y axis to the directions of vectors, shape (n, 3)."""
    lengths = np.sqrt((vectors * vectors).sum(1))
    degenerate = lengths == 0
    y = vectors / np.where(degenerate, 1.0, lengths)[:, None]
    y[degenerate, 1] = 1.0
    rows, k = np.arange(len(y)), np.abs(y).argmin(1)  # x is normal to this axis and to y
    x = np.zeros_like(y)
    x[rows, k - 2], x[rows, k - 1] = y[rows, k - 1], -y[rows, k - 2]
    x /= np.sqrt((x * x).sum(1))[:, None]
    (x0, x1, x2), (y0, y1, y2) = x.T, y.T
    z = np.stack([x1 * y2 - x2 * y1, x2 * y0 - x0 * y2, x0 * y1 - x1 * y0], 1)
    return np.stack([x, y, z], 2)
