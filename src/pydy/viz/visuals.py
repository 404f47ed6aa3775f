"""A visual: a shape, the frame that it rotates with, and the point that it is attached to."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NoReturn

from sympy.physics.mechanics import Particle, RigidBody
from sympy.physics.vector import Point, ReferenceFrame

from pydy._checks import flag, text
from pydy.viz.shapes import Line, Shape

if TYPE_CHECKING:
    from pydy._sympy_types import Body, Location

# -- Names of PyDy's viz package that have no counterpart, with what to use instead ----------------


_POSES = "`scene.poses` holds the 4 x 4 matrices of all visuals at all times"
_SAVE = "call `scene.save(path)`, whose suffix selects the format"
_REMEDIES = {
    "to_png": _SAVE,
    "to_gif": _SAVE,
    "to_mp4": _SAVE,
    "to_video": _SAVE,
    "savefig": _SAVE,
    "create_static_html": "call `scene.to_html(path)`, which writes one file",
    "remove_static_html": "`scene.to_html(path)` writes one file, which you may delete",
    "generate_visualization_dict": _POSES,
    "generate_scene_dict": _POSES,
    "generate_simulation_dict": _POSES,
    "generate_transformation_matrix": _POSES,
    "generate_numeric_transform_function": _POSES,
    "evaluate_transformation_matrix": _POSES,
}


def no_attribute(owner: object, name: str) -> NoReturn:
    """Raise the AttributeError for a name, with a remedy if PyDy's viz package has it."""
    remedy = f": {_REMEDIES[name]}" if name in _REMEDIES else ""
    raise AttributeError(f"{type(owner).__name__} has no attribute `{name}`{remedy}.")


# -- Visuals ---------------------------------------------------------------------------------------


# Attributes that can be set after creation, with their types.
_KINDS = {
    "shape": Shape,
    "frame": ReferenceFrame,
    "point": Point,
    "name": str,
    "trail": bool,
}
_SPELLINGS = {"reference_frame": "frame", "origin": "point"}


@dataclass(eq=False, init=False)
class Visual:
    """A shape that moves with a frame and a point.

    Parameters
    ----------
    shape : Shape or None
        If None, a default shape of the body: a solid with the same inertia, or a ball for a
        particle.
    *where : ReferenceFrame and Point, Point, RigidBody, or Particle
        Without a frame the shape keeps the orientation of the scene. A `Line` needs no frame and
        no point, since it has its own points.
    name : str, optional
        Label in the legend; by default the name of the shape, the body or the point.
    trail : bool, optional
        Whether the page shows the path of the point.

    Examples
    --------
    >>> from sympy.physics.mechanics import Particle, Point, ReferenceFrame
    >>> from pydy.viz import Sphere, Visual
    >>> bob = Particle("bob", Point("P"), 1)
    >>> Visual(Sphere(0.1), bob)
    Visual(bob: Sphere at P)
    >>> Visual(Sphere(0.1), ReferenceFrame("B"), Point("Q"), name="knob")
    Visual(knob: Sphere at Q, turning with B)
    """

    shape: Shape | None
    frame: ReferenceFrame | None
    point: Point
    name: str
    body: Body | None
    trail: bool

    def __init__(
        self,
        shape: Shape | None,
        *where: Location | Body,
        name: str | None = None,
        trail: bool = False,
    ) -> None:
        frame, point, body = _attachment(shape, where)
        if shape is not None and shape.name is not None and name is None:
            name = shape.name
        if name is None:
            name = str(body or point).removesuffix("_masscenter")
        values = (shape, frame, point, text(name, "`name` of Visual"), body, flag(trail, "`trail`"))
        for attribute, value in zip(self.__dataclass_fields__, values, strict=True):
            self.__dict__[attribute] = value
        self.__dict__["_changes"] = 0

    @property
    def version(self) -> tuple[int, ...]:
        """A key that changes with the visual and its shape."""
        changes = 0 if self.shape is None else self.shape.changes
        return self.__dict__["_changes"], id(self.shape), changes

    if not TYPE_CHECKING:

        def __setattr__(self, name: str, value: object) -> None:
            field_name = _SPELLINGS.get(name, name)
            if field_name not in _KINDS:
                no_attribute(self, name)
            kind = _KINDS[field_name]
            if not isinstance(value, kind):
                raise TypeError(
                    f"`{name}` of a Visual must be a {kind.__name__}, got {_describe(value)}."
                )
            self.__dict__[field_name] = value
            self.__dict__["_changes"] += 1

        def __getattr__(self, name: str) -> object:
            if name in _SPELLINGS:
                return getattr(self, _SPELLINGS[name])
            no_attribute(self, name)

    def __repr__(self) -> str:
        kind = "default shape" if self.shape is None else type(self.shape).__name__
        turning = f", turning with {self.frame}" if self.frame is not None else ""
        return f"Visual({self.name}: {kind} at {self.point}{turning})"


def _attachment(
    shape: object, attachments: tuple[object, ...]
) -> tuple[ReferenceFrame | None, Point, Body | None]:
    """Return the frame (or None), the point, and the body (or None)."""
    if shape is not None and not isinstance(shape, Shape):
        raise TypeError(
            "`shape` of Visual must be a shape of pydy.viz, such as Sphere(0.1), got "
            f"{_describe(shape)}."
        )
    if isinstance(shape, Line) and not attachments:
        return None, shape.points[0], None
    if len(attachments) == 1:
        (item,) = attachments
        if isinstance(item, RigidBody):
            return item.frame, item.masscenter, item
        if isinstance(item, Particle):
            return None, item.point, item
        if isinstance(item, Point) and shape is not None:
            return None, item, None
    if len(attachments) == 2 and shape is not None:
        frames = [item for item in attachments if isinstance(item, ReferenceFrame)]
        points = [item for item in attachments if isinstance(item, Point)]
        if len(frames) == len(points) == 1:
            return frames[0], points[0], None
    described = ", ".join(map(_describe, attachments)) or "nothing"
    if shape is None:
        raise TypeError(
            "A Visual without a shape must be attached to a RigidBody or Particle, got "
            f"{described}."
        )
    raise TypeError(
        "A Visual must be attached to a ReferenceFrame and a Point, to a Point, or to a RigidBody "
        f"or Particle, got {described}."
    )


def _describe(value: object) -> str:
    return f"the {type(value).__name__} {value}"
