"""Shapes of visuals: data that is validated on creation and at every change.

Lengths are numbers, or SymPy expressions of constants whose values come from the trajectory. The
axes of a shape are those of the frame it is attached to, and its origin is the point. Shapes with
an axis of symmetry have an argument `axis`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from inspect import signature
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Self, TypeAlias

import numpy as np
import sympy as sm
from sympy.physics.vector import Point

from pydy._checks import choice, integer, number, real_array, shown, text
from pydy._errors import warn_user
from pydy._mechanics import checked_vector
from pydy._names import nearest
from pydy._rank import rank_of
from pydy.viz.colours import hex_colour

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from sympy.physics.vector import Vector

    from pydy._sympy_types import SymbolOrName

# A number, or an expression of constants.
Length: TypeAlias = "sm.Expr | float"

# -- What all shapes have in common ----------------------------------------------------------------


class _Spelling(type):
    """Takes the other spellings of a shape's arguments that scripts written elsewhere use."""

    def ignore_material(cls) -> None:
        warn_user(
            f"`material` of {cls.__name__} is ignored: all shapes have one material. Choose a "
            "`color` and an `opacity`."
        )

    if not TYPE_CHECKING:

        def __call__(cls, *args: object, **options: object) -> object:
            for name, field_name in cls.spellings.items():
                if name in options:
                    if field_name in options:
                        raise TypeError(
                            f"{cls.__name__} got `{field_name}` and `{name}`, which mean the same. "
                            "Keep one of them."
                        )
                    options[field_name] = options.pop(name)
            if options.pop("material", None) is not None:
                cls.ignore_material()
            names = [f.name for f in fields(cls) if f.init]
            unknown = [name for name in options if name not in names]
            try:
                if not unknown:
                    signature(cls.__init__).bind(None, *args, **options)
            except TypeError as error:  # Python names the class that has the `__init__`
                raise TypeError(
                    f"{cls.__name__}: {error}. Its arguments are {', '.join(names)}."
                ) from None
            if unknown:
                raise TypeError(
                    f"{cls.__name__} has no argument `{unknown[0]}`; its arguments are "
                    f"{', '.join(names)}. {nearest(unknown[0], names, or_all=False)}".rstrip()
                )
            return super().__call__(*args, **options)


@dataclass(kw_only=True, unsafe_hash=True)
class Shape(metaclass=_Spelling):
    """Attributes common to all shapes.

    Attributes
    ----------
    colour or color : str or sequence of 3 numbers, optional
        A CSS name, ``"#rrggbb"``, or red, green and blue from 0 to 1; by default the next of a
        cycle of colours.
    opacity : float
        From 0 (invisible) to 1 (opaque).
    name : str, optional
        Label in the legend, where visuals with the same name share a row.
    """

    colour: Any = None
    opacity: float = 1.0
    name: str | None = None

    if TYPE_CHECKING:
        color: Any = None

    lengths: ClassVar[tuple[str, ...]] = ()
    spellings: ClassVar[dict[str, str]] = {"color": "colour"}
    changes: ClassVar[int] = 0

    def __post_init__(self) -> None:
        kind = type(self).__name__
        optional = {entry.name for entry in fields(self) if entry.default is None}
        for attribute in self.lengths:
            value = getattr(self, attribute)
            if value is not None or attribute not in optional:
                self._set(attribute, _length(value, f"`{attribute}` of {kind}"))
        if self.colour is not None:
            self._set("colour", hex_colour(self.colour, f"`colour` of {kind}"))
        opacity = real_number(self.opacity)
        if opacity is None or not 0 <= opacity <= 1:
            raise ValueError(f"`opacity` of {kind} must be from 0 to 1, got {shown(self.opacity)}.")
        self._set("opacity", opacity)
        if hasattr(self, "axis"):
            choice(self.axis, ("x", "y", "z"), f"`axis` of {kind}")
        if self.name is not None:
            text(self.name, f"`name` of {kind}")

    def _set(self, attribute: str, value: object) -> None:
        object.__setattr__(self, attribute, value)  # the shape is still in the making

    if not TYPE_CHECKING:

        def __setattr__(self, name: str, value: object) -> None:
            field_name = self.spellings.get(name, name)
            if field_name == "material":
                type(self).ignore_material()
            elif field_name not in (names := [f.name for f in fields(self) if f.init]):
                raise AttributeError(
                    f"{type(self).__name__} has no attribute `{name}`. {nearest(name, names)}"
                )
            elif field_name not in self.__dict__:
                self._set(field_name, value)  # in __init__, which checks it afterwards
            else:
                changed = vars(replace(self, **{field_name: value}))
                self.__dict__.update(changed, changes=self.changes + 1)

        def __getattr__(self, name: str) -> object:
            if name in self.spellings:
                return getattr(self, self.spellings[name])
            raise AttributeError(f"{type(self).__name__} has no attribute `{name}`.")

    def measured(self, values: Mapping[SymbolOrName, float]) -> Self:
        """Return this shape with numbers in place of symbols in its lengths."""
        numbers: dict[str, Any] = {}
        kind = type(self).__name__
        for attribute in self.lengths:
            expression = getattr(self, attribute)
            if not isinstance(expression, sm.Basic):
                continue
            # By name, too: a trajectory from a file has names instead of symbols.
            values_by_symbol = {
                s: values.get(s, values.get(s.name)) for s in expression.free_symbols
            }
            missing = sorted(s.name for s, value in values_by_symbol.items() if value is None)
            if missing:
                raise ValueError(
                    f"`{attribute}` of {kind} is `{expression}`, but `{missing[0]}` has no value: "
                    "shapes may depend on constants only. Give its value in `constants`."
                )
            value = real_number(
                expression.xreplace({s: sm.Float(v) for s, v in values_by_symbol.items()})
            )
            if value is None or not 0 < value < np.inf:
                raise ValueError(
                    f"`{attribute}` of {kind} is `{expression}`, which must be positive, but comes "
                    f"out as {value} with the constants' values."
                )
            numbers[attribute] = value
        return replace(self, **numbers) if numbers else self

    def dimensions(self) -> Iterator[tuple[str, Any]]:
        """Yield the shape's own fields: all except colour and name."""
        common = {f.name for f in fields(Shape)}
        for entry in fields(self):
            if entry.name not in common:
                yield entry.name, getattr(self, entry.name)


def real_number(value: object) -> float | None:
    """Return a value as a float, or None where it is no real number."""
    try:
        return number(value, "")
    except ValueError:
        return None


def _length(value: object, argument: str) -> Length:
    """Return a length as a float, or as an expression when it has symbols."""
    if isinstance(value, sm.Expr) and value.free_symbols:
        return value
    length = None if isinstance(value, bool) else real_number(value)
    if length is None or not 0 < length < np.inf:
        raise ValueError(
            f"{argument} must be a positive number or a SymPy expression of constants, got "
            f"{shown(value)}."
        )
    return length


# -- Polyhedra, discs, knots and tubes -------------------------------------------------------------


@dataclass(unsafe_hash=True)
class _Round(Shape):
    """A shape that its radius describes."""

    radius: Length = 10.0
    lengths = ("radius",)


@dataclass(unsafe_hash=True)
class _Straight(Shape):
    """A round shape along an axis."""

    length: Length
    radius: Length
    axis: str = "y"
    lengths = ("length", "radius")


@dataclass(unsafe_hash=True)
class Cube(Shape):
    """A cube about the point, with edges along x, y and z."""

    length: Length
    lengths = ("length",)


class Circle(_Round):
    """A disc about the point in the plane of x and y."""


class Tetrahedron(_Round):
    """A tetrahedron whose corners are at a distance of `radius` from the point."""


class Octahedron(_Round):
    """An octahedron with corners on x, y and z at a distance of `radius` from the point."""


class Icosahedron(_Round):
    """An icosahedron whose corners are at a distance of `radius` from the point."""


@dataclass(unsafe_hash=True)
class TorusKnot(Shape):
    """A trefoil knot about the z axis: a tube of `tube` around a curve of about `radius`."""

    radius: Length
    tube: Length
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

    radius: Length
    points: ArrayLike
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


def polyhedron(shape: Shape) -> np.ndarray:
    """Return the corners of a regular polyhedron of radius one."""
    corners: list[tuple[float, float, float]]
    if isinstance(shape, Tetrahedron):
        corners = [(1, 1, 1), (-1, -1, 1), (-1, 1, -1), (1, -1, -1)]
    elif isinstance(shape, Octahedron):
        corners = [(s * (k == 0), s * (k == 1), s * (k == 2)) for k in range(3) for s in (1, -1)]
    else:
        golden = (1 + 5**0.5) / 2
        pairs = [(a, b * golden) for a in (1, -1) for b in (1, -1)]
        corners = [c for a, b in pairs for c in ((0, a, b), (a, b, 0), (b, 0, a))]
    table = np.array(corners, dtype=float)
    unit: np.ndarray = table / np.linalg.norm(table[0])
    return unit


def hull(points: object) -> tuple[np.ndarray, np.ndarray] | None:
    """Return the triangles of the convex hull of points, or None for other values.

    They are counter-clockwise from outside.
    """
    from scipy.spatial import ConvexHull

    try:
        table = real_array(points, "")
    except (TypeError, ValueError):
        return None
    if table.ndim != 2 or table.shape[1] != 3 or len(table) < 3 or not np.isfinite(table).all():
        return None
    flat = rank_of(np.linalg.svd(table - table.mean(0), compute_uv=False)) < 3
    triangles = ConvexHull(table, qhull_options="QJ" if flat else "Qt").simplices
    a, b, c = (table[triangles[:, k]] for k in range(3))
    inwards = np.einsum("ij,ij->i", np.cross(b - a, c - a), a - table.mean(0)) < 0
    triangles[inwards] = triangles[inwards][:, ::-1]
    return table, triangles


def knot(radius: float) -> np.ndarray:
    """Return the points of a closed trefoil: twice around the z axis, three times through."""
    angle = np.linspace(0.0, 4 * np.pi, 96, endpoint=False)
    away = radius * (2 + np.cos(1.5 * angle)) / 2
    height = radius * np.sin(1.5 * angle) / 2
    return np.stack([away * np.cos(angle), away * np.sin(angle), height], 1)


def tube_along(points: np.ndarray, radius: float, closed: bool) -> tuple[np.ndarray, np.ndarray]:
    """Return the triangles of a tube along points."""
    if closed:
        ahead = np.roll(points, -1, 0) - np.roll(points, 1, 0)
    else:
        ahead = np.gradient(points, axis=0)
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    side = np.cross(ahead[0], np.eye(3)[int(np.abs(ahead[0]).argmin())])
    around = 12  # corners of its section
    turn = np.arange(around) * (2 * np.pi / around)
    rings = []
    for point, direction in zip(points, ahead, strict=True):
        side = side - (side @ direction) * direction  # carried along without a twist
        side /= np.linalg.norm(side)
        binormal = np.cross(direction, side)
        section = np.outer(np.cos(turn), side) + np.outer(np.sin(turn), binormal)
        rings.append(point + radius * section)
    rows = len(points) if closed else len(points) - 1
    i, j = np.divmod(np.arange(rows * around), around)
    a, b = i * around + j, i * around + (j + 1) % around
    n = len(points) * around
    c, d = (a + around) % n, (b + around) % n
    faces = [np.stack([a, b, c], 1), np.stack([b, d, c], 1)]
    if not closed:  # caps
        k = np.arange(1, around - 1)
        faces += [np.stack([0 * k, k + 1, k], 1), n - around + np.stack([0 * k, k, k + 1], 1)]
    return np.concatenate(rings), np.concatenate(faces)


# -- Meshes: the two formats that every CAD program writes, STL and OBJ ----------------------------


# Binary STL: 80 bytes of anything, a count, then for each triangle a normal, three corners and two
# spare bytes, all little-endian.
_STL_HEADER = 84
_STL_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("spare", "<u2")])


def read_mesh(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Return the vertices (n, 3) and the triangles (k, 3) of an STL or OBJ file."""
    readers = {".stl": _read_stl, ".obj": _read_obj}
    reader = readers.get(path.suffix.lower())
    if reader is None:
        raise ValueError(
            f"`source` of Mesh is '{path}', but only STL and OBJ files can be read: export the "
            "part in one of these formats."
        )
    try:
        vertices, faces = reader(path.read_bytes())
    except (ValueError, IndexError) as error:
        raise ValueError(
            f"`source` of Mesh is '{path}', which is not a valid {path.suffix[1:].upper()} file: "
            f"{error}."
        ) from None
    if not len(faces):
        raise ValueError(f"`source` of Mesh is '{path}', which holds no triangle.")
    if not np.isfinite(vertices).all():
        raise ValueError(f"`source` of Mesh is '{path}', which has a vertex that is not finite.")
    return vertices, faces


def _read_stl(data: bytes) -> tuple[np.ndarray, np.ndarray]:
    # Binary files may begin with "solid" too, so it is the length that tells.
    count = int.from_bytes(data[80:84], "little") if len(data) >= _STL_HEADER else -1
    if len(data) == _STL_HEADER + count * _STL_TRIANGLE.itemsize:
        corners = np.frombuffer(data, _STL_TRIANGLE, count, _STL_HEADER)["corners"]
    elif data.lstrip()[:5].lower() == b"solid":
        lines = (line.split() for line in data.decode("ascii", "replace").splitlines())
        rows = [line[1:] for line in lines if line and line[0].lower() == "vertex"]
        flat = np.array(rows, dtype=float).reshape(-1, 3)
        if len(flat) % 3:
            raise ValueError(f"it has {len(flat)} vertices, which is not a multiple of three")
        corners = flat.reshape(-1, 3, 3)
    else:
        raise ValueError(
            f"it is {len(data)} bytes long, which does not fit its {max(count, 0)} triangles"
        )
    # Shared corners once: half the size or less.
    vertices, indices = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    return vertices.astype(float), indices.reshape(-1, 3)


def _read_obj(data: bytes) -> tuple[np.ndarray, np.ndarray]:
    vertices: list[list[float]] = []
    faces: list[tuple[int, int, int]] = []
    text = data.decode("utf-8", "replace").replace("\\\n", " ")
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if not words:
            continue
        if words[0] == "v":
            x, y, z = map(float, words[1:4])
            vertices.append([x, y, z])
        elif words[0] == "f":
            # "f v/vt/vn ...", from one; negative counts back from the last vertex so far.
            numbers = [int(word.split("/")[0]) for word in words[1:]]
            indices = [n - 1 if n > 0 else len(vertices) + n for n in numbers]
            if len(indices) < 3 or not all(0 <= k < len(vertices) for k in indices):
                raise ValueError(f"the face `{line.strip()}` does not fit the vertices before it")
            faces += [(indices[0], b, c) for b, c in pairwise(indices[1:])]
    return np.array(vertices, dtype=float).reshape(-1, 3), np.array(faces, dtype=int).reshape(-1, 3)


# -- Bodies, planes, and what is drawn between points ----------------------------------------------


class Sphere(_Round):
    """A ball centred at the point.

    Examples
    --------
    >>> from pydy.viz import Sphere
    >>> Sphere(0.1, colour="crimson").colour
    '#dc143c'
    """


@dataclass(unsafe_hash=True)
class Box(Shape):
    """A box centred at the point, with edges along x, y and z."""

    x: Length
    y: Length
    z: Length
    lengths = ("x", "y", "z")
    spellings = Shape.spellings | {"width": "x", "height": "y", "depth": "z"}


class Cylinder(_Straight):
    """A cylinder centred at the point, along an axis.

    Examples
    --------
    A wheel that turns about its y axis:

    >>> from pydy.viz import Cylinder
    >>> Cylinder(length=0.05, radius=0.3, axis="y")
    Cylinder(colour=None, opacity=1.0, name=None, length=0.05, radius=0.3, axis='y')
    """


class Cone(_Straight):
    """A cone centred at the point, with its tip in the direction of an axis."""


class Capsule(_Straight):
    """A cylinder with hemispherical ends; `length` is that of the cylinder alone."""


@dataclass(unsafe_hash=True)
class Torus(Shape):
    """A torus around an axis; `radius` is that of its centre line, `tube` that of its tube."""

    radius: Length
    tube: Length
    axis: str = "z"
    lengths = ("radius", "tube")
    spellings = Shape.spellings | {"tube_radius": "tube"}


@dataclass(unsafe_hash=True)
class Plane(Shape):
    """A rectangle centred at the point, normal to an axis.

    Its edges are along the two other axes in the order x, y, z: those of a plane normal to y have
    the `length` along x and the `width` along z.
    """

    length: Length = 10.0
    width: Length = 5.0
    axis: str = "z"
    lengths = ("length", "width")


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

    vector: Vector
    scale: float | None = 1.0
    radius: Any = None
    lengths = ("radius",)

    def __post_init__(self) -> None:
        super().__post_init__()
        checked_vector(self.vector, "`vector` of Arrow")
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

    points: Sequence[Point]
    radius: Any = None
    lengths = ("radius",)

    def __post_init__(self) -> None:
        super().__post_init__()
        points = tuple(self.points) if isinstance(self.points, (tuple, list)) else ()
        if len(points) < 2 or not all(isinstance(p, Point) for p in points):
            raise ValueError(
                "`points` of Line must be a sequence of two or more points of "
                f"sympy.physics.mechanics, got {shown(self.points)}."
            )
        self._set("points", points)


@dataclass(unsafe_hash=True)
class Bar(Line):
    """A round bar through moving points; without a radius it has one that suits the scene.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point
    >>> from pydy.viz import Bar
    >>> Bar([Point("A"), Point("B")], colour="grey").points
    (A, B)
    """


# A screen shows no more along one line: each turn has a front, a back and gaps.
MOST_COILS = 1000


class _Stretched(Bar):
    """A shape between two points whose distance may vary."""

    def __post_init__(self) -> None:
        super().__post_init__()
        if len(self.points) != 2:
            raise ValueError(
                f"`points` of {type(self).__name__} must be two points, its ends, got "
                f"{len(self.points)}."
            )


@dataclass(unsafe_hash=True)
class Spring(_Stretched):
    """A helical spring between two points, which it follows.

    Attributes
    ----------
    points : sequence of sympy.physics.vector.Point
        Its two ends.
    radius : length, optional
        Of the helix; by default one that suits the scene.
    coils : int
        Number of its turns, at most 1,000.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point
    >>> from pydy.viz import Spring
    >>> Spring([Point("A"), Point("B")], radius=0.05).coils
    8
    """

    coils: int = 8

    def __post_init__(self) -> None:
        super().__post_init__()
        self._set("coils", integer(self.coils, "`coils` of Spring"))
        if self.coils > MOST_COILS:
            raise ValueError(
                f"`coils` of Spring must be at most {MOST_COILS}, got {shown(self.coils)}."
            )


class Damper(_Stretched):
    """A damper or a hydraulic cylinder between two points: a rod that slides in a tube.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point
    >>> from pydy.viz import Damper
    >>> Damper([Point("A"), Point("B")], radius=0.02).radius
    0.02
    """


@dataclass(unsafe_hash=True)
class Support(Shape):
    """A cube at a point at rest on which a mechanism hangs; its size suits the scene."""


@dataclass(unsafe_hash=True)
class Trace(Shape):
    """The path of the point.

    Attributes
    ----------
    duration : float, optional
        Duration of the visible part in seconds; by default all of it.
    """

    duration: Length | None = None
    lengths = ("duration",)


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

    source: str | Path | ArrayLike | tuple[ArrayLike, ArrayLike]
    scale: Length = 1.0
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
        points_argument, corners = source
        vertices = real_array(points_argument, "")
    except (TypeError, ValueError):
        vertices, corners = np.empty(0), ()
    if vertices.ndim != 2 or vertices.shape[1] != 3 or not np.isfinite(vertices).all():
        raise ValueError(
            "`source` of Mesh must be the path of an STL or OBJ file, or (vertices, faces) with "
            f"finite vertices of shape (n, 3), got {shown(source)}."
        )
    try:
        faces = np.asarray(corners)
    except (TypeError, ValueError):  # ragged
        faces = np.empty(0)
    good = faces.ndim == 2 and faces.shape[1] == 3 and faces.dtype.kind in "iu" and len(faces)
    if not good or faces.min() < 0 or faces.max() >= len(vertices):
        raise ValueError(
            "`faces` of Mesh must be integers of shape (k, 3), each the index of one of the "
            f"{len(vertices)} vertices, got {shown(corners)}."
        )
    return vertices, faces
