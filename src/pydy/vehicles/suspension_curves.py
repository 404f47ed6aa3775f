"""Kinematics of a suspension over the travel of its wheel, by Newton's method."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pydy._axes import axes_of, legend_beside
from pydy._checks import number, positive, real_array, shown
from pydy._rank import HALF, ROUNDED
from pydy.vehicles.hard_points import HardPoints, Hinge
from pydy.vehicles.tuning import POSITIONS_PER_ARM

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_STEPS = 20  # of Newton's method, which needs three or four


@dataclass(frozen=True, eq=False)
class SuspensionCurves:
    """Kinematic curves of a wheel over its travel, the body being fixed.

    Attributes
    ----------
    travel : ndarray, shape (n,)
        Vertical displacement (m) of the wheel's center, positive in bump.
    camber, toe : ndarray, shape (n,)
        (rad): camber is positive if the top leans outwards, toe if the front points inwards.
    caster, kingpin_inclination : ndarray, shape (n,)
        (rad), of the steering axis: positive if its top is behind, or nearer to the middle.
    track_change, wheelbase_change : ndarray, shape (n,)
        Displacement (m) of the contact point, outwards and forward.
    roll_center_height : ndarray, shape (n,)
        (m) above the road, in the plane of the wheel's center: where the line from the contact
        point to the instantaneous center of the wheel's motion crosses the middle of the car.
    spring_length : ndarray, shape (n,)
        (m).
    motion_ratio : ndarray, shape (n,)
        Rate of the spring's compression by that of the travel. By virtual work the wheel has the
        force F MR of a spring with the force F, and the rate k MR² + F dMR/dz.
    """

    travel: np.ndarray
    camber: np.ndarray
    toe: np.ndarray
    caster: np.ndarray
    kingpin_inclination: np.ndarray
    track_change: np.ndarray
    wheelbase_change: np.ndarray
    roll_center_height: np.ndarray
    spring_length: np.ndarray
    motion_ratio: np.ndarray

    def __repr__(self) -> str:
        return (
            f"<SuspensionCurves from {self.travel[0]:.4g} to {self.travel[-1]:.4g} m: camber from "
            f"{np.degrees(self.camber[0]):.3g}° to {np.degrees(self.camber[-1]):.3g}°>"
        )

    def plot(self, ax: Axes | None = None) -> Axes:
        """Plot camber and toe over the travel.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Where to draw; a new figure by default.

        Returns
        -------
        matplotlib Axes
        """
        ax = axes_of(ax, "pydy.vehicles")
        for name in ("camber", "toe"):
            ax.plot(np.degrees(getattr(self, name)), 1e3 * self.travel, label=name)
        ax.set_xlabel("angle (°)")
        ax.set_ylabel("wheel travel (mm)")
        legend_beside(ax)
        ax.grid(alpha=0.3)
        return ax


@dataclass(frozen=True)
class _Pose:
    """Where a suspension is: the angle of the lower arm and the rotation of the upright."""

    angle: float
    rotation: np.ndarray


class _SuspensionMechanism:
    """A suspension with one degree of freedom, its rack being fixed."""

    def __init__(self, suspension: HardPoints, rack: float) -> None:
        self.points, self.rack = suspension, rack
        self.hinge = Hinge.of(suspension, "lower")

    def outer(self, pose: _Pose) -> np.ndarray:
        return self.hinge.outer(np.cos(pose.angle), np.sin(pose.angle))

    def position(self, name: str, pose: _Pose) -> np.ndarray:
        return self.points.moved(name, self.outer(pose), pose.rotation)

    def errors(self, pose: _Pose, height: float) -> np.ndarray:
        """Return the errors of the closure and of the height of the wheel's center."""
        closed = self.points.closure(self.outer(pose), pose.rotation, self.rack)
        return np.array([*closed, self.position("wheel_center", pose)[2] - height])

    def rates(self, pose: _Pose) -> tuple[np.ndarray, list[tuple[np.ndarray, np.ndarray]]]:
        """Return the derivatives of the errors, and the motions that they belong to.

        Motions are rates of the lower ball joint and of the rotation matrix: by the arm, and by
        three components of the angular velocity of the upright.
        """
        outer, rotation = self.outer(pose), pose.rotation
        lever = np.cross(self.hinge.axis, outer - self.hinge.foot)
        motions = [(lever, np.zeros((3, 3)))]
        motions += [(np.zeros(3), np.cross(axis, rotation, axisb=0, axisc=0)) for axis in np.eye(3)]
        columns = []
        for moved, turned in motions:
            # Of quadratic functions a central difference of any width is the derivative.
            ahead, behind = (
                np.array(
                    self.points.closure(outer + way * moved, rotation + way * turned, self.rack)
                )
                for way in (1.0, -1.0)
            )
            centre = moved + turned @ (
                np.asarray(self.points.wheel_center) - np.asarray(self.points.lower_outer)
            )
            columns.append([*((ahead - behind) / 2), centre[2]])
        return np.array(columns).T, motions

    def branch(self, pose: _Pose) -> float:
        """Return the sign of the determinant, which changes where the travel has an extremum."""
        jacobian, _motions = self.rates(pose)
        sizes = np.linalg.svd(jacobian, compute_uv=False)
        if sizes[-1] <= ROUNDED * sizes[0]:
            raise np.linalg.LinAlgError("The travel does not determine the pose.")
        return float(np.sign(np.linalg.det(jacobian)))

    def moved_to(self, height: float, pose: _Pose) -> _Pose:
        """Return the pose at a height of the wheel's center, near another one, or raise."""
        for _ in range(_STEPS):
            jacobian, _motions = self.rates(pose)
            step = -np.linalg.solve(jacobian, self.errors(pose, height))
            pose = _Pose(pose.angle + step[0], _turn(step[1:]) @ pose.rotation)
            largest = np.abs(step).max()
            if largest <= HALF:  # an error of the size of its square remains
                return pose
            if not largest < np.pi:
                break
        raise np.linalg.LinAlgError("Newton's method does not converge.")


def curves_of(
    suspension: HardPoints, travel: float | Sequence[float], radius: float, rack: float
) -> SuspensionCurves:
    """Return the curves over the travel: the poses are followed from that of the hard points."""
    targets = np.atleast_1d(real_array(travel, "`travel`"))
    if targets.ndim != 1 or not len(targets) or not np.isfinite(targets).all():
        raise ValueError(f"`travel` must be finite numbers, got {shown(travel)}.")
    radius = positive(radius, "`radius`", finite=True)
    rack = number(rack, "`rack`", finite=True)
    poses = _poses(suspension, targets, rack)
    mechanism = _SuspensionMechanism(suspension, rack)
    at_rest = _state(mechanism, _Pose(0.0, np.eye(3)), radius)["contact"]
    rows = [_state(mechanism, pose, radius) for pose in poses]
    columns = {name: np.array([row[name] for row in rows]) for name in rows[0]}
    moved = columns.pop("contact") - at_rest
    return SuspensionCurves(
        travel=targets,
        track_change=suspension.side * moved[:, 1],
        wheelbase_change=moved[:, 0],
        **columns,
    )


def _poses(suspension: HardPoints, targets: np.ndarray, rack: float) -> list[_Pose]:
    """Return the poses at travels, each from the nearest one on its way from no travel."""
    start = _Pose(0.0, np.eye(3))
    longest = float(np.linalg.norm(Hinge.of(suspension, "lower").radius)) / POSITIONS_PER_ARM
    rest = suspension.wheel_center[2]
    poses: dict[int, _Pose] = {}
    try:
        for share in np.linspace(0.0, 1.0, 1 + _parts(rack, longest))[1:]:
            start = _SuspensionMechanism(suspension, share * rack).moved_to(rest, start)
        mechanism = _SuspensionMechanism(suspension, rack)
        sign = mechanism.branch(start)
    except np.linalg.LinAlgError:
        raise ValueError(
            f"`rack` of {rack:.4g} m is out of reach: the tie rod cannot follow it."
            if rack
            else "The hard points leave the wheel no vertical motion: check that the arms and the "
            "tie rod lead from the body to the upright."
        ) from None
    for way in (1.0, -1.0):
        pose, z = start, 0.0
        for k in sorted(np.flatnonzero(way * targets >= 0.0), key=lambda j: abs(targets[j])):
            for height in np.linspace(z, targets[k], 1 + _parts(targets[k] - z, longest))[1:]:
                try:
                    pose = mechanism.moved_to(rest + height, pose)
                    reached = mechanism.branch(pose) == sign
                except np.linalg.LinAlgError:
                    reached = False
                if not reached:
                    raise ValueError(
                        f"`travel` of {targets[k]:.4g} m is out of reach: the suspension does not "
                        f"go beyond about {z:.4g} m on this side."
                    )
                z = height
            poses[int(k)] = pose
    return [poses[k] for k in range(len(targets))]


def _parts(distance: float, longest: float) -> int:
    return int(np.ceil(abs(distance) / longest))


def _state(mechanism: _SuspensionMechanism, pose: _Pose, radius: float) -> dict[str, np.ndarray]:
    """Return angles, the contact point, and rates for a unit rate of the travel."""
    points, side = mechanism.points, mechanism.points.side
    jacobian, motions = mechanism.rates(pose)
    weights = np.linalg.solve(jacobian, [0.0, 0.0, 0.0, 1.0])
    outer_rate = sum(w * m for w, (m, _) in zip(weights, motions, strict=True))
    turning = sum(w * r for w, (_, r) in zip(weights, motions, strict=True))

    def rate(name: str) -> np.ndarray:
        moved: np.ndarray = outer_rate + turning @ (getattr(points, name) - points.lower_outer)
        return moved

    axis, axis_rate = pose.rotation @ points.axis, turning @ points.axis
    # The contact point is below the center, along the projection of the vertical on the wheel.
    up = np.array([0.0, 0.0, 1.0])
    level = np.sqrt(1 - axis[2] ** 2)
    above = up - axis[2] * axis
    above_rate = -axis_rate[2] * axis - axis[2] * axis_rate
    contact = mechanism.position("wheel_center", pose) - radius * above / level
    contact_rate = rate("wheel_center") - radius * (
        above_rate / level + above * axis[2] * axis_rate[2] / level**3
    )
    top = points.steering_axis_top
    lower = mechanism.outer(pose)
    upper = getattr(points, top) if top == "strut_top" else mechanism.position(top, pose)
    kingpin = upper - lower
    carrier, moving, fixed = points.spring_ends
    if carrier == "upright":
        end, end_rate = mechanism.position(moving, pose), rate(moving)
    else:
        arm = _turn(mechanism.hinge.axis * pose.angle)
        hinge = mechanism.hinge.foot
        end = hinge + arm @ (getattr(points, moving) - hinge)
        end_rate = weights[0] * np.cross(mechanism.hinge.axis, end - hinge)
    spring = end - getattr(points, fixed)
    length = np.linalg.norm(spring)
    return {
        "camber": -side * np.arcsin(axis[2]),
        "toe": side * np.arctan2(axis[0], axis[1]),
        "caster": np.arctan2(-kingpin[0], kingpin[2]),
        "kingpin_inclination": np.arctan2(-side * kingpin[1], kingpin[2]),
        "contact": contact,
        # The instantaneous center is on the normal to the velocity of the contact point.
        "roll_center_height": contact[1] * contact_rate[1] / contact_rate[2],
        "spring_length": length,
        "motion_ratio": -spring.dot(end_rate) / length,
    }


def _turn(vector: np.ndarray) -> np.ndarray:
    """Return the matrix of a rotation about a vector, by its length (rad)."""
    angle = float(np.linalg.norm(vector))
    x, y, z = vector
    skew = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    half = np.sinc(angle / (2 * np.pi))  # sin(φ/2)/(φ/2), also where φ = 0
    matrix: np.ndarray = np.eye(3) + np.sinc(angle / np.pi) * skew + half**2 / 2 * skew @ skew
    return matrix
