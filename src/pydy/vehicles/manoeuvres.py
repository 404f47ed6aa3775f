"""Manoeuvres of a car: the step of the steering, and steady turns of one radius."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._axes import axes_of, with_unit
from pydy._checks import (
    instance,
    number,
    one_or_more,
    positive,
    real_array,
    shown,
    unit_and_factor,
)
from pydy._errors import EquilibriumError, warn_user
from pydy._names import some
from pydy._rank import HALF
from pydy.system import System

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from pydy.analysis import Equilibrium
    from pydy.trajectory import Trajectory

_SAMPLES = 2001  # of a step response
_SETTLED = 0.02  # largest change in the last tenth of a response, relative to its end
_ANGLES = (0.0, 0.05, 0.2)  # of the steering (rad), with which rates are compared
# Of the states and outputs of this package's cars, by their names before the wheel's, as in Fz_fl.
_UNITS = {
    **dict.fromkeys(("x", "y", "z"), "m"),
    **dict.fromkeys(("psi", "theta", "phi", "beta", "alpha", "delta"), "rad"),
    **dict.fromkeys(("u", "v", "w", "speed"), "m/s"),
    **dict.fromkeys(("p", "q", "r", "omega"), "rad/s"),
    **dict.fromkeys(("F", "Fx", "Fy", "Fz"), "N"),
    **dict.fromkeys(("a_x", "a_y"), "m/s²"),
}


@dataclass(frozen=True, eq=False)
class StepResponse:
    """How a car answers to a step of its steering angle.

    Attributes
    ----------
    times, values : ndarray, shape (n,)
        Of the quantity that was asked for.
    quantity : str
    steady : float
        Its value at the end.
    response_time : float
        Until it first has 90 % of the steady value (s).
    rise_time : float
        From 10 % to 90 % of the steady value (s).
    peak, peak_time : float
        Its largest value in the direction of the steady one, and when (s).
    overshoot : float
        By how much the peak exceeds the steady value, relative to it.
    trajectory : Trajectory
        The whole motion.
    """

    times: np.ndarray
    values: np.ndarray
    quantity: str
    steady: float
    response_time: float
    rise_time: float
    peak: float
    peak_time: float
    overshoot: float
    trajectory: Trajectory

    def __repr__(self) -> str:
        return (
            f"<StepResponse of {self.quantity}: steady {self.steady:.4g}, 90 % after "
            f"{self.response_time:.3g} s, overshoot {self.overshoot:.1%}>"
        )

    def plot(self, ax: Axes | None = None, *, unit: str | tuple[str, float] = "") -> Axes:
        """Plot the response over time, with its steady value.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Where to draw; a new figure by default.
        unit : str or (str, float), optional
            The unit of the quantity, shown with its name; with a factor, as in ``('°/s',
            180/np.pi)``, the values are multiplied by it. By default that of the cars of this
            package, and none where the car has no heading ``psi`` or gives the quantity another
            name.

        Returns
        -------
        matplotlib Axes
        """
        states = names_of(self.trajectory.state_symbols)
        state = self.quantity if self.quantity in states else ""
        label, factor = unit_and_factor(unit, "unit", state)
        if unit == "" and "psi" in states:
            name = self.quantity
            label = _UNITS.get(name) or _UNITS.get(name.partition("_")[0], "")
        ax = axes_of(ax, "pydy.vehicles")
        ax.axhline(factor * self.steady, color="0.7", linewidth=0.8)
        ax.plot(self.times, factor * self.values)
        ax.set_xlabel("time (s)")
        ax.set_ylabel(with_unit(self.quantity, label))
        ax.margins(x=0)
        ax.grid(alpha=0.3)
        return ax


def step_steer(
    system: System,
    angle: float,
    *,
    quantity: str = "r",
    duration: float = 5.0,
    steering: str = "delta",
) -> StepResponse:
    """Steer a car by a step at the initial time, and measure its response (ISO 7401).

    The car starts from the System's initial conditions; all other values are those of the System,
    which is not changed.

    Parameters
    ----------
    system : System
        A car, such as `single_track` returns.
    angle : float
        The steering angle (rad), not zero; positive to the left.
    quantity : str, optional
        The state or output to measure.
    duration : float, optional
        (s), long enough for a steady turn.
    steering : str, optional
        The specified that is the steering angle.

    Returns
    -------
    StepResponse

    Warns
    -----
    PyDyUserWarning
        The response is not steady at the end.

    Examples
    --------
    >>> from pydy.vehicles import CARS, single_track, step_steer
    >>> response = step_steer(single_track(CARS['bmw_320i'], speed=25.0), 0.01)
    >>> round(response.steady, 4), round(response.response_time, 2), round(response.overshoot, 3)
    (0.0969, 0.27, 0.0)
    """
    instance(system, System, "`system`", "a System, such as single_track returns")
    angle = number(angle, "`angle`", finite=True)
    if angle == 0.0 or abs(angle) >= np.pi / 2:
        raise ValueError(
            "`angle` must be an angle of a steered wheel (rad), neither zero nor a right angle or "
            f"more, got {angle!r}."
        )
    duration = positive(duration, "`duration`", finite=True)
    check_name(quantity, "quantity", [*names_of(system.states), *map(str, system.outputs)])
    check_steering(system, steering)
    car = copy(system)
    car.specifieds = {**car.specifieds, steering: angle}
    car.times = np.linspace(0.0, duration, _SAMPLES)
    trajectory = car.simulate()
    times, values = trajectory.times, np.asarray(trajectory[quantity])
    steady = float(values[-1])
    if steady == 0.0 or np.ptp(values[-_SAMPLES // 10 :]) > _SETTLED * abs(steady):
        warn_user(
            f"{quantity} is not steady after {duration:g} s, so that times and overshoot, which "
            "are relative to its last value, say little. Pass a longer `duration`, or drive "
            "below the critical speed."
        )
    share = values / steady if steady else np.full_like(values, np.nan)
    k = int(np.argmax(share))
    response_time = _first_time(times, share, 0.9)
    return StepResponse(
        times,
        values,
        quantity,
        steady,
        response_time,
        response_time - _first_time(times, share, 0.1),
        float(values[k]),
        float(times[k]),
        float(share[k]) - 1.0,
        trajectory,
    )


def _first_time(times: np.ndarray, share: np.ndarray, level: float) -> float:
    """Return when a response reaches a level first, between samples by a straight line."""
    reached = np.flatnonzero(share >= level)
    if not reached.size:
        return float("nan")
    k = int(reached[0])
    if k == 0:
        return float(times[0])
    return float(np.interp(level, share[k - 1 : k + 1], times[k - 1 : k + 1]))


@dataclass(frozen=True, eq=False)
class SteadyTurn:
    """Steady turns of one radius at several lateral accelerations.

    Attributes
    ----------
    radius : float
        R (m).
    accelerations, speeds : ndarray, shape (n,)
        u²/R (m/s²) and u (m/s).
    angles : ndarray, shape (n,)
        Steering angles (rad).
    understeer_gradient : ndarray, shape (n,)
        The slope of the angles over the accelerations (rad s²/m), by differences of second order.
    states : ndarray, shape (n, k)
        The states of the car in each turn.
    """

    radius: float
    accelerations: np.ndarray
    speeds: np.ndarray
    angles: np.ndarray
    understeer_gradient: np.ndarray
    states: np.ndarray

    def __repr__(self) -> str:
        gradient = np.degrees(self.understeer_gradient[0])
        return (
            f"<SteadyTurn of {self.radius:g} m up to {self.accelerations[-1]:.4g} m/s²: understeer "
            f"gradient {gradient:.3g}° s²/m at the start>"
        )

    def plot(self, ax: Axes | None = None) -> Axes:
        """Plot the steering angle over the lateral acceleration.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Where to draw; a new figure by default.

        Returns
        -------
        matplotlib Axes
        """
        ax = axes_of(ax, "pydy.vehicles")
        ax.plot(self.accelerations, np.degrees(self.angles), marker=".")
        ax.set_xlabel("lateral acceleration (m/s²)")
        ax.set_ylabel("steering angle (°)")
        ax.grid(alpha=0.3)
        return ax


def steady_turn(
    system: System,
    radius: float,
    accelerations: Sequence[float],
    *,
    steering: str = "delta",
    speed: str = "u",
    yaw_rate: str = "r",
    position: Sequence[str] = ("x", "y", "psi"),
    inputs: Sequence[str] | None = None,
) -> SteadyTurn:
    """Drive a car around a circle of constant radius at several speeds (ISO 4138).

    For each lateral acceleration, speed and yaw rate are given, and `System.find_equilibrium`
    solves for the other states and the specifieds: the steering angle, and the driving force if
    the speed is free.

    Parameters
    ----------
    system : System
        A car, such as `single_track` returns; it is not changed.
    radius : float
        R (m), positive: the car turns to the left. The forward speed is u = R r.
    accelerations : sequence of float
        At least three lateral accelerations u²/R (m/s²), positive and ascending.
    steering, speed, yaw_rate : str, optional
        The specified that is the steering angle; the state or constant that is the forward speed;
        the state that is the yaw rate.
    position : three of str, optional
        The coordinates that keep changing: those of a point and the yaw angle.
    inputs : sequence of str, optional
        The specifieds that are solved for, all by default; others keep their values. There are as
        many as speeds that would change without them: for `double_track` ``('delta', 'T_drive')``.

    Returns
    -------
    SteadyTurn
        Up to the last acceleration that the tires can bear.

    Raises
    ------
    EquilibriumError
        There is no steady turn at the third acceleration or before.

    Warns
    -----
    PyDyUserWarning
        There is no steady turn at a later one; the result ends before it.

    Examples
    --------
    >>> import numpy as np
    >>> from pydy.vehicles import SingleTrackCar, single_track, steady_turn
    >>> car = SingleTrackCar(1500, 2500, 1.2, 1.5, 90e3, 110e3)
    >>> turn = steady_turn(single_track(car), 100.0, np.linspace(0.5, 4.0, 8))
    >>> np.degrees(turn.angles[[0, -1]]).round(2)
    array([1.64, 2.28])
    """
    instance(system, System, "`system`", "a System, such as single_track returns")
    radius = positive(radius, "`radius`", finite=True)
    targets = real_array(accelerations, "`accelerations`")
    if (
        targets.ndim != 1
        or len(targets) < 3
        or not (np.isfinite(targets).all() and targets[0] > 0.0 and (np.diff(targets) > 0.0).all())
    ):
        raise ValueError(
            "`accelerations` must be at least three positive ascending numbers, got "
            f"{shown(accelerations)}."
        )
    specifieds = names_of(system.specifieds_symbols)
    states = names_of(system.speeds)
    check_name(steering, "steering", specifieds)
    solved = sorted(specifieds) if inputs is None else one_or_more("inputs", inputs)
    for name in solved:
        check_name(name, "inputs", specifieds)
    if steering not in solved:
        raise ValueError(f"`inputs` must have {steering!r}, the steering angle, got {inputs!r}.")
    coordinates = names_of(system.coordinates)
    for k, name in enumerate(three_names(position)):
        check_name(name, f"position[{k}]", coordinates)
    internal = [name for name in coordinates if name not in position]
    check_name(yaw_rate, "yaw_rate", states)
    check_name(speed, "speed", [*states, *names_of(system.constants_symbols)])
    unknowns = [n for n in states if n not in (speed, yaw_rate)] + internal + list(solved)
    speeds = np.sqrt(targets * radius)
    start = _rolling(system, speed, speeds[0]) if speed in states else {}
    solutions: list[Equilibrium] = []
    before = speeds[0]
    for target, u in zip(targets, speeds, strict=True):
        # Wheels roll: their speeds begin in proportion to that of the car.
        rolling = {name: start[name] * u / before for name in states if name in start}
        values = {**start, **rolling, speed: float(u), yaw_rate: float(u) / radius}
        before = u
        try:
            turn = system.find_equilibrium(unknowns, values, moving=list(position))
        except EquilibriumError:
            if len(solutions) < 3:
                raise
            warn_user(
                f"No steady turn of {radius:g} m was found at {target:.4g} m/s²: the turns end at "
                f"{targets[len(solutions) - 1]:.4g} m/s²."
            )
            break
        start = {name: turn[name] for name in unknowns}
        solutions.append(turn)
    n = len(solutions)
    angles = np.array([turn[steering] for turn in solutions])
    return SteadyTurn(
        radius,
        targets[:n],
        speeds[:n],
        angles,
        np.gradient(angles, targets[:n], edge_order=2),
        np.array([turn.state for turn in solutions]),
    )


def _rolling(system: System, speed: str, u: float) -> dict[Any, float]:
    """Return the initial speeds of a car in proportion to another forward speed."""
    initial = {name: system.initial_conditions.get(name, 0.0) for name in names_of(system.speeds)}
    forward = initial.pop(speed)
    return {name: value * u / forward for name, value in initial.items()} if forward > 0.0 else {}


def three_names(position: Any) -> list[Any]:
    """Return the names of two coordinates and the yaw angle, or raise an error."""
    if not isinstance(position, (list, tuple)) or len(position) != 3:
        raise TypeError(
            "`position` must be the names of two coordinates and the yaw angle, got "
            f"{shown(position)}."
        )
    return list(position)


def names_of(symbols: Any) -> list[str]:
    """Return the names of symbols, without (t)."""
    return [str(symbol).removesuffix("(t)") for symbol in symbols]


def check_name(name: Any, argument: str, known: Sequence[str]) -> None:
    """Refuse what is none of the known names."""
    if not isinstance(name, str) or name not in known:
        raise ValueError(f"`{argument}` must be one of {some(known)}, got {shown(name)}.")


def check_steering(system: System, steering: Any) -> None:
    """Refuse what is no specified, and a steering rate: manoeuvres give an angle."""
    check_name(steering, "steering", names_of(system.specifieds_symbols))
    car, rates = copy(system), []
    for angle in _ANGLES:
        car.specifieds = {**car.specifieds, steering: angle}
        rates.append(car.evaluate_ode())
    changes = np.diff(rates, axis=0)
    is_rate = (np.abs(changes - np.diff(_ANGLES)[:, None]) <= HALF).all(axis=0)
    for k in np.flatnonzero(is_rate):
        raise ValueError(
            f"`steering` must be the specified that is the steering angle, got {steering!r}, which "
            f"is the rate of the state {names_of(system.states)[k]}. Use a car whose input is the "
            "angle, such as `single_track` or `double_track` of the same `CARS`."
        )


def coordinate_of(system: System, name: Any, k: int) -> Any:
    """Return a coordinate by its name, which is the k-th of `position`."""
    names = names_of(system.coordinates)
    check_name(name, f"position[{k}]", names)
    return system.coordinates[names.index(name)]
