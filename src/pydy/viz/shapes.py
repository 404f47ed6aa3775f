"""Shapes of visuals: data that is validated on creation and at every change.

Lengths are numbers, or SymPy expressions of constants whose values come from the trajectory. The
axes of a shape are those of the frame it is attached to, and its origin is the point. Shapes with
an axis of symmetry have an argument `axis`.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Self

import numpy as np
from sympy.physics.vector import Point, Vector

from pydy._checks import real_array, shown
from pydy.viz.meshes import read_mesh
from pydy.viz.shape import Shape, check_axis, real_number
from pydy.viz.solids import (
    Circle,
    Cube,
    Icosahedron,
    Octahedron,
    Tetrahedron,
    TorusKnot,
    Tube,
    hull,
)

__all__ = [
    "Arrow",
    "Box",
    "Capsule",
    "Circle",
    "Cone",
    "Cube",
    "Cylinder",
    "Icosahedron",
    "Line",
    "Mesh",
    "Octahedron",
    "Plane",
    "Shape",
    "Sphere",
    "Tetrahedron",
    "Torus",
    "TorusKnot",
    "Trace",
    "Tube",
]


@dataclass(unsafe_hash=True)
class Sphere(Shape):
    """A ball centred at the point.

    Examples
    --------
    >>> from pydy.viz import Sphere
    >>> Sphere(0.1, colour="crimson").colour
    '#dc143c'
    """

    radius: Any = 10.0
    lengths = ("radius",)


@dataclass(unsafe_hash=True)
class Box(Shape):
    """A box centred at the point, with edges along x, y and z."""

    x: Any
    y: Any
    z: Any
    lengths = ("x", "y", "z")
    spellings = Shape.spellings | {"width": "x", "height": "y", "depth": "z"}


@dataclass(unsafe_hash=True)
class Cylinder(Shape):
    """A cylinder centred at the point, along an axis.

    Examples
    --------
    A wheel that turns about its y axis:

    >>> from pydy.viz import Cylinder
    >>> Cylinder(length=0.05, radius=0.3, axis="y")
    Cylinder(colour=None, opacity=1.0, name=None, length=0.05, radius=0.3, axis='y')
    """

    length: Any
    radius: Any
    axis: str = "y"
    lengths = ("length", "radius")

    def __post_init__(self) -> None:
        super().__post_init__()
        check_axis(self.axis, type(self).__name__)


@dataclass(unsafe_hash=True)
class Cone(Shape):
    """A cone centred at the point, with its tip in the direction of an axis."""

    length: Any
    radius: Any
    axis: str = "y"
    lengths = ("length", "radius")

    def __post_init__(self) -> None:
        super().__post_init__()
        check_axis(self.axis, type(self).__name__)


@dataclass(unsafe_hash=True)
class Capsule(Shape):
    """A cylinder with hemispherical ends; `length` is that of the cylinder alone."""

    length: Any
    radius: Any
    axis: str = "y"
    lengths = ("length", "radius")

    def __post_init__(self) -> None:
        super().__post_init__()
        check_axis(self.axis, type(self).__name__)


@dataclass(unsafe_hash=True)
class Torus(Shape):
    """A torus around an axis; `radius` is that of its centre line, `tube` that of its tube."""

    radius: Any
    tube: Any
    axis: str = "z"
    lengths = ("radius", "tube")
    spellings = Shape.spellings | {"tube_radius": "tube"}

    def __post_init__(self) -> None:
        super().__post_init__()
        check_axis(self.axis, type(self).__name__)


@dataclass(unsafe_hash=True)
class Plane(Shape):
    """A rectangle centred at the point, normal to an axis.

    Its edges are along the two other axes in the order x, y, z: those of a plane normal to y have
    the `length` along x and the `width` along z.
    """

    length: Any = 10.0
    width: Any = 5.0
    axis: str = "z"
    lengths = ("length", "width")

    def __post_init__(self) -> None:
        super().__post_init__()
        check_axis(self.axis, type(self).__name__)


@dataclass(unsafe_hash=True)
class Arrow(Shape):
    """An arrow from the point along a SymPy vector, such as a force or a velocity.

    Attributes
    ----------
    vector : sympy.physics.vector.Vector
    scale : float or None
        Length of the arrow for a vector of magnitude one. If None, all arrows with the same name
        share a scale such that the longest is a third of the size of the scene, or as long as the
        scene if it is a short peak.
    radius : length, optional
        Radius of the shaft; by default it depends on the size of the scene.

    Examples
    --------
    >>> from sympy.physics.mechanics import ReferenceFrame, dynamicsymbols
    >>> from pydy.viz import Arrow
    >>> N, F = ReferenceFrame("N"), dynamicsymbols("F")
    >>> Arrow(F*N.x, scale=0.01).vector
    F(t)*N.x
    """

    vector: Any
    scale: float | None = 1.0
    radius: Any = None
    lengths = ("radius",)

    def __post_init__(self) -> None:
        super().__post_init__()
        if not isinstance(self.vector, Vector):
            raise TypeError(
                "`vector` of Arrow must be a vector of sympy.physics.mechanics, such as F*N.x, got "
                f"{self.vector!r}."
            )
        if self.scale is None:
            return
        scale = real_number(self.scale)
        if scale is None or not np.isfinite(scale):
            raise ValueError(f"`scale` of Arrow must be a number or None, got {shown(self.scale)}.")
        self._set("scale", scale)


@dataclass(unsafe_hash=True)
class Line(Shape):
    """A line through moving points: a rope, the axis of a spring, a rod between two joints.

    Attributes
    ----------
    points : sequence of sympy.physics.vector.Point
        Two or more.
    radius : length, optional
        If given, a round rod with this radius instead of a thin line.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point
    >>> from pydy.viz import Line
    >>> Line([Point("A"), Point("B")], radius=0.01).points
    (A, B)
    """

    points: Any
    radius: Any = None
    lengths = ("radius",)

    def __post_init__(self) -> None:
        super().__post_init__()
        points = tuple(self.points) if isinstance(self.points, (tuple, list)) else ()
        if len(points) < 2 or not all(isinstance(p, Point) for p in points):
            raise ValueError(
                "`points` of Line must be a sequence of two or more points of "
                f"sympy.physics.mechanics, got {self.points!r}."
            )
        self._set("points", points)


@dataclass(unsafe_hash=True)
class Trace(Shape):
    """The path of the point.

    Attributes
    ----------
    duration : float, optional
        Duration of the visible part in seconds; by default all of it.
    """

    duration: Any = None
    lengths = ("duration",)

    def scaled(self, factor: float) -> Self:
        """Return the trace itself: its duration is a time."""
        return self


@dataclass(eq=False)
class Mesh(Shape):
    """A surface of triangles, from an STL or OBJ file or from arrays.

    Attributes
    ----------
    source : path, or (vertices, faces)
        A file with the suffix ``.stl`` (text or binary) or ``.obj``; or a pair of vertex
        coordinates, shape (n, 3), and vertex indices of the triangles, shape (k, 3). If only
        coordinates are given, their convex hull is shown.
    scale : length
        Length in the scene of one unit in the file: 0.001 for a file in millimetres and a scene in
        metres.

    Examples
    --------
    >>> from pydy.viz import Mesh
    >>> corner = Mesh(([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), scale=0.5)
    >>> corner.vertices[1]
    array([1., 0., 0.])
    """

    source: Any
    scale: Any = 1.0
    vertices: np.ndarray = field(init=False, repr=False)
    faces: np.ndarray = field(init=False, repr=False)
    lengths = ("scale",)
    spellings = Shape.spellings | {"points": "source"}

    def __post_init__(self) -> None:
        super().__post_init__()
        if isinstance(self.source, (str, Path)):
            vertices, faces = read_mesh(Path(self.source))
            self._set("source", (vertices, faces))  # the file is read once
        else:
            vertices, faces = _triangles(self.source)
        self._set("vertices", vertices)
        self._set("faces", faces)


def _triangles(source: Any) -> tuple[np.ndarray, np.ndarray]:
    points = hull(source)
    if points is not None:
        return points
    try:
        given, corners = source
        vertices = real_array(given, "")
    except (TypeError, ValueError):
        vertices, corners = np.empty(0), ()
    if vertices.ndim != 2 or vertices.shape[1] != 3 or not np.isfinite(vertices).all():
        raise ValueError(
            "`source` of Mesh must be the path of an STL or OBJ file, or (vertices, faces) with "
            f"finite vertices of shape (n, 3), got {source!r}."
        )
    try:
        faces = np.asarray(corners)
    except (TypeError, ValueError):  # ragged
        faces = np.empty(0)
    good = faces.ndim == 2 and faces.shape[1] == 3 and faces.dtype.kind in "iu" and len(faces)
    if not good or faces.min() < 0 or faces.max() >= len(vertices):
        raise ValueError(
            "`faces` of Mesh must be integers of shape (k, 3), each the index of one of the "
            f"{len(vertices)} vertices, got {corners!r}."
        )
    return vertices, faces
