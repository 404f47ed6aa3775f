"""Double lane changes between cones (ISO 3888), by a driver who looks ahead."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm

from pydy._axes import axes_of
from pydy._checks import choice, instance, number, positive
from pydy.system import System
from pydy.vehicles.manoeuvres import (
    check_name,
    check_steering,
    coordinate_of,
    names_of,
    three_names,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from pydy.trajectory import Trajectory

_SAMPLES = 4001
_CONES = 5  # at each side of a lane, with those at its ends


@dataclass(frozen=True)
class _Lane:
    """A lane between two rows of cones: where it begins and ends, and its edges (m)."""

    start: float
    end: float
    right: float
    left: float

    @property
    def middle(self) -> float:
        return (self.left + self.right) / 2.0


def _double_lane_change(width: float) -> list[_Lane]:
    """Return the lanes of ISO 3888-1: 3.5 m lie between their right edges.

    Sections 1 to 6 are 15, 30, 25, 25, 15 and 15 m long, 125 m in all; sections 2 and 4 have no
    cones, 5 and 6 are one lane.
    """
    first, second, third = (factor * width + 0.25 for factor in (1.1, 1.2, 1.3))
    right = -first / 2.0
    return [
        _Lane(0.0, 15.0, right, right + first),
        _Lane(45.0, 70.0, right + 3.5, right + 3.5 + second),
        _Lane(95.0, 125.0, right, right + third),
    ]


def _obstacle_avoidance(width: float) -> list[_Lane]:
    """Return the lanes of ISO 3888-2: 1 m lies between the left edges and the lane beside them.

    Sections 1 to 5 are 12, 13.5, 11, 12.5 and 12 m long, 61 m in all.
    """
    first, second, third = 1.1 * width + 0.25, width + 1.0, max(1.3 * width + 0.25, 3.0)
    left = first / 2.0
    return [
        _Lane(0.0, 12.0, left - first, left),
        _Lane(25.5, 36.5, left + 1.0, left + 1.0 + second),
        _Lane(49.0, 61.0, left - third, left),
    ]


_TRACKS: dict[str, Callable[[float], list[_Lane]]] = {
    "ISO 3888-1": _double_lane_change,
    "ISO 3888-2": _obstacle_avoidance,
}


@dataclass(frozen=True, eq=False)
class LaneChange:
    """How a car passes the cones of a lane change.

    Attributes
    ----------
    track : str
    passed : bool
        Whether the car passes all cones and touches none.
    cones : ndarray, shape (n, 2)
        Where the cones stand (m); the track begins at x = 0, in the middle of the first lane.
    clearances : ndarray, shape (n,)
        The smallest distance (m) of each cone from the side of the car, negative if it is touched;
        NaN if the car does not pass it.
    angles : ndarray, shape (k,)
        The steering angle (rad) at the times of the trajectory.
    target : ndarray, shape (k, 2)
        The line that the driver aims at (m).
    trajectory : Trajectory
        The whole motion.
    """

    track: str
    passed: bool
    cones: np.ndarray
    clearances: np.ndarray
    angles: np.ndarray
    target: np.ndarray
    trajectory: Trajectory
    _position: tuple[str, str]

    def __repr__(self) -> str:
        if self.passed:
            result = f"passed, {np.nanmin(self.clearances):.2g} m beside the nearest cone"
        else:
            touched = int((self.clearances < 0.0).sum())
            missed = int(np.isnan(self.clearances).sum())
            cones = "cone" if touched == 1 else "cones"
            result = f"{touched} {cones} touched" + f", {missed} not passed" * bool(missed)
        return f"<LaneChange {self.track}: {result}>"

    def plot(self, ax: Axes | None = None) -> Axes:
        """Plot the path of the mass centre between the cones; those that are touched are red.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Where to draw; a new figure by default.

        Returns
        -------
        matplotlib Axes
        """
        ax = axes_of(ax, "pydy.vehicles")
        ax.plot(*self.target.T, color="0.7", linewidth=0.8)
        ax.plot(*(self.trajectory[name] for name in self._position))
        clear = self.clearances >= 0.0
        ax.plot(*self.cones[clear].T, ".", color="0.4")
        ax.plot(*self.cones[~clear].T, "x", color="tab:red")
        ax.set_xlabel("x (m)")
        ax.set_ylabel("y (m)")
        ax.grid(alpha=0.3)
        return ax


def lane_change(
    system: System,
    width: float,
    *,
    track: str = "ISO 3888-1",
    length: float = 4.5,
    preview: float = 0.5,
    gain: float | None = None,
    steering: str = "delta",
    speed: str = "u",
    yaw_rate: str = "r",
    position: Sequence[str] = ("x", "y", "psi"),
) -> LaneChange:
    """Drive a car through the double lane change of ISO 3888 and report which cones it touches.

    The driver looks at the point where the car would be after the preview time T if it went on
    straight, and steers towards the middle of the track there, at the distance d = u T, on an arc
    of curvature 2 e/d²: ::

        δ = G · 2 e/d²      e = [y_target(x + d cos ψ) − y − d sin ψ] cos ψ

    G (m) is the steering angle of a steady turn for each curvature, L + K u² of a linear car. The
    target changes from lane to lane along a polynomial of the fifth degree.

    Parameters
    ----------
    system : System
        A car, such as `single_track` returns. Its initial speed is that of the test, and specifieds
        other than the steering angle keep their values. It is not changed. Cones that a trailer
        would touch are not counted.
    width : float
        Width of the car (m) without mirrors, which decides how wide the lanes are.
    track : {'ISO 3888-1', 'ISO 3888-2'}, optional
        The double lane change, 125 m long, or the obstacle avoidance, 61 m long. For the width b,
        the lanes are 1.1 b + 0.25 m, 1.2 b + 0.25 m and 1.3 b + 0.25 m wide, or 1.1 b + 0.25 m,
        b + 1 m and 1.3 b + 0.25 m, at least 3 m.
    length : float, optional
        Length of the car (m). Its mass centre is assumed to be in the middle.
    preview : float, optional
        Preview time T (s).
    gain : float, optional
        G (m), that of the linearised car by default.
    steering, speed, yaw_rate : str, optional
        The specified that is the steering angle; the state or constant that is the forward speed;
        the state that is the yaw rate.
    position : three of str, optional
        The coordinates of the mass centre, and the yaw angle.

    Returns
    -------
    LaneChange

    References
    ----------
    ISO 3888-1:2018 and ISO 3888-2:2011, Passenger cars – Test track for a severe lane-change
    manoeuvre; C. C. MacAdam, Application of an optimal preview control for simulation of
    closed-loop automobile driving, IEEE Transactions on Systems, Man, and Cybernetics 11(6), 1981,
    of which this driver is the simplest: one point, no delay.

    Examples
    --------
    >>> from pydy.vehicles import CARS, lane_change, single_track
    >>> change = lane_change(single_track(CARS['bmw_320i'], speed=20.0), 1.61)
    >>> change.passed
    True
    """
    instance(system, System, "`system`", "a System, such as single_track returns")
    width = positive(width, "`width`", finite=True)
    length = positive(length, "`length`", finite=True)
    preview = positive(preview, "`preview`", finite=True)
    lanes = _TRACKS[choice(track, tuple(_TRACKS), "`track`")](width)
    check_steering(system, steering)
    states = names_of(system.speeds)
    constants = names_of(system.constants_symbols)
    check_name(yaw_rate, "yaw_rate", states)
    check_name(speed, "speed", [*states, *constants])
    x, y, psi = (coordinate_of(system, name, k) for k, name in enumerate(three_names(position)))
    internal = [name for name in names_of(system.coordinates) if name not in position]
    values = system.initial_conditions if speed in states else system.constants
    u = positive(values.get(speed, 0.0), f"The initial value of {speed}")
    gain = (
        _steering_gain(system, steering, speed, yaw_rate, internal, u)
        if gain is None
        else number(gain, "`gain`", finite=True)
    )
    ahead = u * preview
    target = _target(lanes)
    at = x + ahead * sm.cos(psi)
    error = (target(at, _between) - y - ahead * sm.sin(psi)) * sm.cos(psi)
    angle = gain * 2.0 * error / ahead**2

    car = copy(system)
    car.specifieds = {**car.specifieds, steering: angle}
    before = ahead + length
    car.initial_conditions = {**car.initial_conditions, x: -before, y: 0.0, psi: 0.0}
    way = before + lanes[-1].end + length
    car.times = np.linspace(0.0, 1.1 * way / u, _SAMPLES)
    trajectory = car.simulate()
    path = [np.asarray(trajectory[name]) for name in position]
    cones, sides = _cones(lanes)
    clearances = _clearances(path, cones, sides, width, length)
    return LaneChange(
        track,
        bool((clearances > 0.0).all()),
        cones,
        clearances,
        np.asarray(trajectory[steering]),
        np.stack([path[0], target(path[0], np.clip)], axis=1),
        trajectory,
        (position[0], position[1]),
    )


def _between(value: Any, least: float, most: float) -> sm.Expr:
    return sm.Max(least, sm.Min(value, most, evaluate=False), evaluate=False)


def _target(lanes: list[_Lane]) -> Callable[[Any, Callable[..., Any]], Any]:
    """Return the line through the middles of the lanes as a function of x, with `clip`."""

    def line(x: Any, clip: Callable[..., Any]) -> Any:
        result = lanes[0].middle
        for lane, following in pairwise(lanes):
            share = clip((x - lane.end) / (following.start - lane.end), 0.0, 1.0)
            rise = share**3 * (10.0 - 15.0 * share + 6.0 * share**2)
            result = result + (following.middle - lane.middle) * rise
        return result

    return line


def _steering_gain(
    system: System, steering: str, speed: str, yaw_rate: str, internal: list[str], u: float
) -> float:
    """Return the steering angle for each curvature of the linearised car in steady turns."""
    # At its initial state a car may slow down, by rolling resistance: no equilibrium is asked for.
    linear = system.linearize(at={}, inputs=[steering])
    # Of the other states, the path follows; what loads and tires follow is steady, too.
    driving = [*names_of(system.speeds), *internal]
    free = [name for name in driving if name != speed and name in linear.states]
    rows = [linear.states.index(name) for name in free]
    response = -np.linalg.solve(linear.A[np.ix_(rows, rows)], linear.B[rows, 0])
    return float(u / response[free.index(yaw_rate)])


def _cones(lanes: list[_Lane]) -> tuple[np.ndarray, np.ndarray]:
    """Return where the cones stand, and 1 for those at the left, −1 for those at the right."""
    cones, sides = [], []
    for lane in lanes:
        for side, edge in ((1.0, lane.left), (-1.0, lane.right)):
            cones += [(x, edge) for x in np.linspace(lane.start, lane.end, _CONES)]
            sides += [side] * _CONES
    return np.array(cones), np.array(sides)


def _clearances(
    path: list[np.ndarray], cones: np.ndarray, sides: np.ndarray, width: float, length: float
) -> np.ndarray:
    """Return the distances of the cones from the sides of the car while it is beside them."""
    x, y, psi = path
    dx, dy = cones[:, :1] - x, cones[:, 1:] - y
    forward = np.cos(psi) * dx + np.sin(psi) * dy
    left = np.cos(psi) * dy - np.sin(psi) * dx
    beside = np.abs(forward) <= length / 2.0
    gaps = np.where(beside, sides[:, None] * left - width / 2.0, np.inf)
    least = gaps.min(axis=1)
    passed = beside.any(axis=1) & (forward[:, -1] < 0.0)
    return np.where(passed, least, np.nan)
