"""What a file says of a robot, whichever format it has: links, joints and what ties them."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial
from typing import Any

import numpy as np
import scipy

from pydy._errors import RobotFileError, warn_user

# A file's rotation is normalised before it becomes a matrix of cosines, each of which is then off
# by a few units in the last place: an entry so close to 0 or ±1 was meant to be that.
_COSINE = 8 * np.finfo(float).eps


@dataclass
class Joint:
    """How a link may move against its parent; MuJoCo allows several in a row.

    A hinge or slide has an axis; a ball joint a quaternion; a free one that and a place.
    """

    name: str
    kind: str  # 'hinge', 'slide', 'ball', 'free'
    axis: np.ndarray = field(default_factory=lambda: np.array([0.0, 0.0, 1.0]))
    anchor: np.ndarray = field(default_factory=lambda: np.zeros(3))  # in the link
    reference: float = 0.0  # the coordinate in the pose that the file shows
    limits: tuple[float, float] | None = None
    effort: float | None = None
    damping: float = 0.0
    stiffness: float = 0.0
    relaxed: float = 0.0  # the coordinate at which the spring is relaxed
    armature: float = 0.0
    friction: float = 0.0
    mimics: tuple[str, float, float] | None = None  # a joint, a factor, a constant
    where: str = ""


@dataclass
class Look:
    """A visible shape of a link."""

    shape: Any  # or what reads it from its file, which may take longer than all else
    place: np.ndarray
    turn: np.ndarray

    def read(self) -> Any:
        """Return the shape, which is read from its file once."""
        if isinstance(self.shape, partial):
            self.shape = self.shape()
        return self.shape


@dataclass
class Link:
    """A rigid body, or a frame without mass."""

    name: str
    parent: int  # index of the link that it hangs on; −1 is the world
    # Its origin and axes (columns) in the parent's, in the pose that the file shows.
    place: np.ndarray
    turn: np.ndarray
    joints: list[Joint] = field(default_factory=list)
    mass: float = 0.0
    centre: np.ndarray = field(default_factory=lambda: np.zeros(3))
    # (3, 3), about the mass centre, in the link's axes.
    inertia: np.ndarray = field(default_factory=lambda: np.zeros((3, 3)))
    lightened: float = 0.0  # the part of its weight that is taken away
    looks: list[Look] = field(default_factory=list)
    where: str = ""


@dataclass
class Tendon:
    """A sum of coordinates, each times a coefficient, as its length: MJCF's fixed tendon."""

    name: str
    shares: list[tuple[str, float]]  # joints and coefficients
    limits: tuple[float, float] | None = None
    damping: float = 0.0
    stiffness: float = 0.0
    relaxed: tuple[float, float] = (0.0, 0.0)  # between these lengths the spring has no force
    armature: float = 0.0
    friction: float = 0.0
    where: str = ""


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
class Tie:
    """An equality between two links, two joints or two tendons."""

    # ``'connect'`` (two points coincide), ``'weld'`` (two frames coincide), ``'joint'`` (a
    # coordinate is a polynomial of another), ``'tendon'`` (a length is a polynomial of another).
    kind: str
    # Links by index, or joints or tendons by name; `other` may be None for these.
    one: Any
    other: Any
    # The points, each in its link.
    places: tuple[np.ndarray, np.ndarray] = (np.zeros(3), np.zeros(3))
    # Axes of the other link in those of the one.
    turn: np.ndarray = field(default_factory=lambda: np.eye(3))
    # From the change of the other coordinate or length to that of the one, since the file's pose.
    polynomial: tuple[float, ...] = ()


@dataclass
class Tree:
    """All that is read from one file."""

    name: str
    links: list[Link]  # each after its parent
    motors: list[Motor] = field(default_factory=list)
    tendons: list[Tendon] = field(default_factory=list)
    ties: list[Tie] = field(default_factory=list)
    gravity: np.ndarray = field(default_factory=lambda: np.array([0.0, 0.0, -9.81]))
    # Values of coordinates that are not zero in the pose that the file shows, by joint.
    start: dict[str, np.ndarray] = field(default_factory=dict)
    # What the file has and this has not, a line each.
    left_out: list[str] = field(default_factory=list)
    looks: list[Look] = field(default_factory=list)  # of the world

    def check(self) -> None:
        """Refuse trees that cannot move: negative masses, and joints without mass beyond them."""
        negative: list[str] = []
        heavy = [link.mass > 0.0 or bool(link.inertia.any()) for link in self.links]
        for k in range(len(self.links) - 1, -1, -1):
            link = self.links[k]
            if not link.mass >= 0.0 or not np.isfinite(link.mass):
                raise RobotFileError(
                    f"{link.where}: the mass of the link '{link.name}' must be a finite number, "
                    f"not negative, got {link.mass}."
                )
            _drop_rounding(link)
            if not np.isfinite(link.inertia).all() or (np.diagonal(link.inertia) < 0.0).any():
                raise RobotFileError(
                    f"{link.where}: the moments of inertia of the link '{link.name}' must be "
                    f"finite numbers, not negative, got {np.diagonal(link.inertia).tolist()}."
                )
            least = float(np.linalg.eigvalsh(link.inertia)[0])
            if least < -_COSINE * np.abs(link.inertia).max():  # as in files that are in use
                negative.append(
                    f"the inertia of the link '{link.name}' has a negative principal moment, "
                    f"{least:.3g}: no body has it; it is taken as it is ({link.where})"
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
            more = f" So are {len(negative) - 1} others." if negative[1:] else ""
            warn_user(f"{negative[0][0].upper()}{negative[0][1:]}.{more} Correct the file.")

    def _check_joints_move_mass(self, heavy: list[bool]) -> None:
        """Refuse joints without inertia, their own or that of joints which mimic them.

        `heavy` says which links have mass, themselves or farther out.
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
                        f"{joint.where}: nothing that the joint '{joint.name}' moves has mass: "
                        "its acceleration is undetermined. Give the link "
                        f"'{link.name}', one that hangs on it, or one whose joint mimics it a "
                        "mass, or make the joint fixed."
                    )


def _check_resistance(kind: str, element: Joint | Tendon) -> None:
    for what in ("damping", "armature", "friction"):
        value = getattr(element, what)
        if not value >= 0.0 or not np.isfinite(value):
            raise RobotFileError(
                f"{element.where}: the {what} of the {kind} '{element.name}' must be a finite "
                f"number, not negative, got {value}. If the {kind} is to be driven, give it an "
                "actuator."
            )


def _drop_rounding(link: Link) -> None:
    """Set negative moments of inertia to zero that are the rounding of the parallel-axis theorem.

    Programs that write such files subtract the moment of the mass, m c², from that about the origin
    of the link: what is left is off by a few units in the last place of m c².
    """
    least = -_COSINE * link.mass * float(link.centre @ link.centre)
    for k in range(3):
        if least <= link.inertia[k, k] < 0.0:
            link.inertia[k, k] = 0.0


def cosines(turn: np.ndarray) -> np.ndarray:
    """Return a rotation with entries set to 0, 1 or −1 where they are so up to rounding."""
    near = np.rint(turn)
    return np.where(np.abs(turn - near) <= _COSINE, near, turn)


def of_quaternion(quaternion: np.ndarray) -> np.ndarray:
    """Return the rotation of a quaternion, scalar part first, of any length but zero."""
    return cosines(scipy.spatial.transform.Rotation.from_quat(np.roll(quaternion, -1)).as_matrix())


def to_quaternion(turn: np.ndarray) -> np.ndarray:
    """Return the quaternion of a rotation, scalar part first."""
    found: np.ndarray = np.roll(scipy.spatial.transform.Rotation.from_matrix(turn).as_quat(), 1)
    return found


def of_roll_pitch_yaw(angles: np.ndarray) -> np.ndarray:
    """Return the rotation about the fixed x, then y, then z."""
    return cosines(scipy.spatial.transform.Rotation.from_euler("xyz", angles).as_matrix())


def turned(inertia: np.ndarray, turn: np.ndarray) -> np.ndarray:
    """Return an inertia in other axes; products that rounding alone left are zero."""
    found = turn @ inertia @ turn.T
    found = (found + found.T) / 2
    size = np.abs(inertia).max()
    return np.where(np.abs(found) <= _COSINE * size, 0.0, found)
