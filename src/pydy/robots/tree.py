"""The content of a robot file, in any format: links, joints, actuators and constraints."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._errors import RobotFileError, warn_user
from pydy._names import counted

if TYPE_CHECKING:
    from pydy.viz import Mesh, Shape

# A file's rotation is normalised and converted to direction cosines, which have errors of a few
# units in the last place: an entry this close to 0 or ±1 is set to that.
_COSINE = 8 * np.finfo(float).eps


@dataclass
class RobotJoint:
    """A joint between a link and its parent; MuJoCo allows several in a row.

    A hinge or slide has an axis, a ball joint a quaternion, a free joint also a position.
    """

    name: str
    kind: str  # 'hinge', 'slide', 'ball', 'free'
    axis: np.ndarray = field(default_factory=lambda: np.array([0.0, 0.0, 1.0]))
    anchor: np.ndarray = field(default_factory=lambda: np.zeros(3))  # in the link
    reference: float = 0.0  # the coordinate in the file's pose
    limits: tuple[float, float] | None = None
    effort: float | None = None
    damping: float = 0.0
    stiffness: float = 0.0
    relaxed: float = 0.0  # the coordinate at which the spring is relaxed
    armature: float = 0.0
    friction: float = 0.0
    # A joint, a factor and a constant: the coordinate is factor q + constant.
    mimics: tuple[str, float, float] | None = None
    location: str = ""


@dataclass
class VisualShape:
    """A visible shape of a link."""

    shape: Shape | partial[Mesh]  # or a partial that reads it from its file, which may be slow
    origin: np.ndarray
    rotation: np.ndarray

    def read(self) -> Shape:
        """Return the shape; its file is read at the first call."""
        if isinstance(self.shape, partial):
            self.shape = self.shape()
        return self.shape


@dataclass
class Link:
    """A rigid body, or a frame without mass."""

    name: str
    parent: int  # index of the parent link; −1 is the world
    # Origin and axes (columns) in the parent's frame, in the file's pose.
    origin: np.ndarray
    rotation: np.ndarray
    joints: list[RobotJoint] = field(default_factory=list)
    mass: float = 0.0
    centre: np.ndarray = field(default_factory=lambda: np.zeros(3))
    # (3, 3), about the mass centre, in the link's axes.
    inertia: np.ndarray = field(default_factory=lambda: np.zeros((3, 3)))
    gravity_compensation: float = 0.0  # the fraction of its weight that is compensated
    visuals: list[VisualShape] = field(default_factory=list)
    location: str = ""


@dataclass
class Tendon:
    """MJCF's fixed tendon: its length is a linear combination of coordinates."""

    name: str
    shares: list[tuple[str, float]]  # joints and coefficients
    limits: tuple[float, float] | None = None
    damping: float = 0.0
    stiffness: float = 0.0
    relaxed: tuple[float, float] = (0.0, 0.0)  # the range of lengths without a spring force
    armature: float = 0.0
    friction: float = 0.0
    location: str = ""


@dataclass
class Motor:
    """A force along a joint or tendon.

    It is gain × input − stiffness × coordinate or length − damping × its rate + constant.
    """

    name: str
    joint: str | None  # None for a tendon
    gain: float = 1.0
    constant: float = 0.0
    stiffness: float = 0.0
    damping: float = 0.0
    input_range: tuple[float, float] | None = None
    tendon: str | None = None


@dataclass
class EqualityConstraint:
    """An equality between two links, two joints or two tendons."""

    # ``'connect'`` (two points coincide), ``'weld'`` (two frames coincide), ``'joint'`` (a
    # coordinate is a polynomial of another), ``'tendon'`` (a length is a polynomial of another).
    kind: str
    # Links by index, or joints or tendons by name; `second` may be None for these.
    first: Any
    second: Any
    # The points, each in its link.
    points: tuple[np.ndarray, np.ndarray] = (np.zeros(3), np.zeros(3))
    # Axes of the second link in those of the first.
    rotation: np.ndarray = field(default_factory=lambda: np.eye(3))
    # Displacement of the first coordinate or length as a polynomial of that of the second.
    polynomial: tuple[float, ...] = ()


@dataclass
class Tree:
    """The content of one file."""

    name: str
    links: list[Link]  # each after its parent
    motors: list[Motor] = field(default_factory=list)
    tendons: list[Tendon] = field(default_factory=list)
    equalities: list[EqualityConstraint] = field(default_factory=list)
    gravity: np.ndarray = field(default_factory=lambda: np.array([0.0, 0.0, -9.81]))
    # Coordinates that are not zero in the file's pose, by joint.
    start: dict[str, np.ndarray] = field(default_factory=dict)
    # Properties of the file without a counterpart here, a line each.
    left_out: list[str] = field(default_factory=list)
    visuals: list[VisualShape] = field(default_factory=list)  # of the world

    def check(self) -> None:
        """Raise an error for negative masses, and for joints that move no mass."""
        negative: list[str] = []
        heavy = [link.mass > 0.0 or bool(link.inertia.any()) for link in self.links]
        for k in range(len(self.links) - 1, -1, -1):
            link = self.links[k]
            if not link.mass >= 0.0 or not np.isfinite(link.mass):
                raise RobotFileError(
                    f"{link.location}: the mass of the link '{link.name}' must be a finite number, "
                    f"not negative, got {link.mass}."
                )
            _drop_rounding(link)
            if not np.isfinite(link.inertia).all() or (np.diagonal(link.inertia) < 0.0).any():
                raise RobotFileError(
                    f"{link.location}: the moments of inertia of the link '{link.name}' must be "
                    f"finite numbers, not negative, got {np.diagonal(link.inertia).tolist()}."
                )
            least = float(np.linalg.eigvalsh(link.inertia)[0])
            if least < -_COSINE * np.abs(link.inertia).max():  # occurs in published files
                negative.append(
                    f"the inertia of the link '{link.name}' has a negative principal moment, "
                    f"{least:.3g}: no body has it; it is taken as it is ({link.location})"
                )
            for joint in link.joints:
                _check_resistance("joint", joint)
            if link.parent >= 0:
                heavy[link.parent] |= heavy[k]
        for tendon in self.tendons:
            _check_resistance("tendon", tendon)
        self._check_joints_move_mass(heavy)
        self.left_out += negative
        if negative:
            further = (
                f" The same in {counted(len(negative) - 1, 'other link')}." if negative[1:] else ""
            )
            warn_user(f"{negative[0][0].upper()}{negative[0][1:]}.{further} Correct the file.")

    def _check_joints_move_mass(self, heavy: list[bool]) -> None:
        """Raise an error for joints that move no inertia, directly or by joints that mimic them.

        `heavy` is True for links that have mass, or that carry links with mass.
        """
        joints = {joint.name: joint for link in self.links for joint in link.joints}
        inert = {
            joint.name
            for link, has_mass in zip(self.links, heavy, strict=True)
            for joint in link.joints
            if has_mass or joint.armature > 0.0
        }
        for name in tuple(inert):
            mimics = joints[name].mimics
            while mimics is not None and mimics[1] and mimics[0] not in inert:
                inert.add(mimics[0])
                mimics = joints[mimics[0]].mimics
        for link in reversed(self.links):
            for joint in link.joints:
                if joint.mimics is None and joint.name not in inert:
                    raise RobotFileError(
                        f"{joint.location}: nothing that the joint '{joint.name}' moves has mass: "
                        "its acceleration is undetermined. Give the link "
                        f"'{link.name}', one that hangs on it, or one whose joint mimics it a "
                        "mass, or make the joint fixed."
                    )


def _check_resistance(kind: str, element: RobotJoint | Tendon) -> None:
    for quantity in ("damping", "armature", "friction"):
        value = getattr(element, quantity)
        if not value >= 0.0 or not np.isfinite(value):
            raise RobotFileError(
                f"{element.location}: the {quantity} of the {kind} '{element.name}' must be a "
                f"finite number, not negative, got {value}. If the {kind} is to be driven, give it "
                "an actuator."
            )


def _drop_rounding(link: Link) -> None:
    """Set negative moments of inertia to zero if they are rounding errors.

    Programs that write such files use the parallel-axis theorem: they subtract m c² from the moment
    about the origin of the link, with errors of a few units in the last place of m c².
    """
    least = -_COSINE * link.mass * float(link.centre @ link.centre)
    for k in range(3):
        if least <= link.inertia[k, k] < 0.0:
            link.inertia[k, k] = 0.0


def cosines(rotation: np.ndarray) -> np.ndarray:
    """Return a rotation with entries set to 0, 1 or −1 if they differ by rounding errors only."""
    near = np.rint(rotation)
    return np.where(np.abs(rotation - near) <= _COSINE, near, rotation)


def of_quaternion(quaternion: np.ndarray) -> np.ndarray:
    """Return the rotation of a nonzero quaternion, scalar part first; it is normalised."""
    w, *v = quaternion / np.linalg.norm(quaternion)
    x, y, z = v
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return cosines((w * w - np.dot(v, v)) * np.eye(3) + 2.0 * (np.outer(v, v) + w * cross))


def of_roll_pitch_yaw(angles: np.ndarray) -> np.ndarray:
    """Return the rotation by angles about the fixed axes x, y and z, in this order."""
    rotation = np.eye(3)
    for axis, angle in enumerate(angles):
        turn, (j, k) = np.eye(3), ((axis + 1) % 3, (axis + 2) % 3)
        turn[j, j] = turn[k, k] = np.cos(angle)
        turn[k, j] = np.sin(angle)
        turn[j, k] = -turn[k, j]
        rotation = turn @ rotation
    return cosines(rotation)


def rotated_inertia(inertia: np.ndarray, rotation: np.ndarray) -> np.ndarray:
    """Return an inertia in other axes; products that are rounding errors are zero."""
    rotated = rotation @ inertia @ rotation.T
    rotated = (rotated + rotated.T) / 2
    size = np.abs(inertia).max()
    return np.where(np.abs(rotated) <= _COSINE * size, 0.0, rotated)
