"""Handling of the linear single-track car, by closed forms."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, sqrt
from typing import TYPE_CHECKING

import numpy as np

from pydy._axes import axes_of, rows_of_axes
from pydy._checks import instance, real_array, shown
from pydy.vehicles.cars import SingleTrackCar

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True, eq=False)
class LinearHandling:
    """How a linear single-track car answers to its steering, over speed.

    Attributes
    ----------
    understeer_gradient : float
        K (rad s²/m): the steering angle of a steady turn of radius R is L/R + K a_y. Positive for
        understeer, negative for oversteer.
    characteristic_speed : float
        (m/s) at which an understeering car needs twice the angle L/R, and its yaw-rate gain is
        largest; infinite if there is none.
    critical_speed : float
        (m/s) beyond which an oversteering car is unstable; infinite if there is none.
    speeds : ndarray, shape (n,)
        Forward speeds u (m/s).
    yaw_rate_gain, acceleration_gain, sideslip_gain : ndarray, shape (n,)
        Of r (1/s), a_y (m/s² a rad) and v/u to the steering angle in steady turns; beyond the
        critical speed these turns are unstable.
    eigenvalues : ndarray, shape (n, 2)
        Of the states v and r (1/s).
    natural_frequency : ndarray, shape (n,)
        Undamped angular frequency (rad/s); NaN beyond the critical speed.
    damping_ratio : ndarray, shape (n,)
        Above one, v and r do not oscillate; NaN beyond the critical speed.
    """

    understeer_gradient: float
    characteristic_speed: float
    critical_speed: float
    speeds: np.ndarray
    yaw_rate_gain: np.ndarray
    acceleration_gain: np.ndarray
    sideslip_gain: np.ndarray
    eigenvalues: np.ndarray
    natural_frequency: np.ndarray
    damping_ratio: np.ndarray

    def plot(self, axes: np.ndarray | Sequence[Axes] | None = None) -> np.ndarray:
        """Plot the yaw-rate gain, the natural frequency and the damping ratio over speed.

        Parameters
        ----------
        axes : sequence of 3 matplotlib Axes, optional
            A new figure's by default.

        Returns
        -------
        ndarray of matplotlib Axes, shape (3,)
        """
        curves = {
            "yaw-rate gain (1/s)": self.yaw_rate_gain,
            "natural frequency (rad/s)": self.natural_frequency,
            "damping ratio": self.damping_ratio,
        }
        _, rows = rows_of_axes(axes, 3, "of these quantities", "pydy.vehicles", figsize=(6.4, 7.0))
        for ax, (label, values) in zip(rows, curves.items(), strict=True):
            ax.plot(self.speeds, values)
            ax.set_ylabel(label)
            ax.grid(alpha=0.3)
        rows[-1].set_xlabel("speed (m/s)")
        return np.array(rows)

    def plot_eigenvalues(self, ax: Axes | None = None) -> Axes:
        """Plot how the eigenvalues of v and r move in the complex plane with the speed.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Where to draw; a new figure by default.

        Returns
        -------
        matplotlib Axes
        """
        ax = axes_of(ax, "pydy.vehicles")
        values = self.eigenvalues.ravel()
        points = ax.scatter(values.real, values.imag, c=np.repeat(self.speeds, 2), s=12)
        ax.figure.colorbar(points, ax=ax, label="speed (m/s)")
        ax.axvline(0.0, color="0.7", linewidth=0.8)
        ax.set_xlabel("real part (1/s)")
        ax.set_ylabel("imaginary part (1/s)")
        ax.grid(alpha=0.3)
        return ax


def linear_handling(car: SingleTrackCar, speeds: Sequence[float] | float) -> LinearHandling:
    """Return the closed forms of the linear single-track car at constant speeds.

    With L = a + b they are ::

        K = m/L (b/C_f − a/C_r)                      u_ch² = L/K       u_cr² = −L/K
        r/δ = u/(L + K u²)                           v/(u δ) = (b − m a u²/(L C_r))/(L + K u²)
        ω² = C_f C_r L (L + K u²)/(m I u²)           2 ζ ω = (C_f + C_r)/(m u)
                                                             + (a² C_f + b² C_r)/(I u)

    Parameters
    ----------
    car : SingleTrackCar
        Such as one of `CARS`.
    speeds : float or sequence of float
        Forward speeds u (m/s), positive.

    Returns
    -------
    LinearHandling

    References
    ----------
    M. Mitschke and H. Wallentowitz, Dynamik der Kraftfahrzeuge, 5th ed., Springer, 2014.

    Examples
    --------
    >>> from pydy.vehicles import SingleTrackCar, linear_handling
    >>> car = SingleTrackCar(1500, 2500, 1.2, 1.5, 90e3, 110e3)
    >>> handling = linear_handling(car, [10.0, 30.0])
    >>> round(handling.understeer_gradient, 6), round(handling.characteristic_speed, 2)
    (0.003199, 29.05)
    >>> handling.damping_ratio.round(3)
    array([0.968, 0.713])
    """
    instance(car, SingleTrackCar, "`car`", "a SingleTrackCar, such as one of CARS")
    u = np.atleast_1d(real_array(speeds, "`speeds`"))
    if u.ndim != 1 or not u.size or not (np.isfinite(u) & (u > 0.0)).all():
        raise ValueError(f"`speeds` must be positive finite numbers, got {shown(speeds)}.")
    m, inertia, a, b = car.mass, car.yaw_inertia, car.front, car.rear
    C_f, C_r, L = car.front_stiffness, car.rear_stiffness, car.wheelbase
    stabilising, destabilising = b * C_r, a * C_f
    difference = stabilising - destabilising
    if abs(difference) <= 4.0 * np.finfo(float).eps * stabilising:
        difference = 0.0  # a neutral car, rounded
    K = m * difference / (L * C_f * C_r)
    steering = L + K * u**2
    with np.errstate(divide="ignore"):  # at the critical speed
        gain = u / steering
        sideslip = (b - m * a * u**2 / (L * C_r)) / steering
    square = C_f * C_r * L * steering / (m * inertia * u**2)
    decay = ((C_f + C_r) / m + (a**2 * C_f + b**2 * C_r) / inertia) / (2.0 * u)
    # For real eigenvalues, the one of larger size first: their difference loses no digits.
    root = np.sqrt(_discriminant(car, u).astype(complex))
    first = -decay - root
    second = np.where(root.imag != 0.0, -decay + root, square / first)
    with np.errstate(invalid="ignore"):
        frequency = np.sqrt(np.where(square >= 0.0, square, np.nan))
        damping = decay / np.where(frequency > 0.0, frequency, np.nan)
    return LinearHandling(
        K,
        sqrt(L / K) if K > 0.0 else inf,
        sqrt(-L / K) if K < 0.0 else inf,
        u,
        gain,
        u * gain,
        sideslip,
        np.stack([first, second], axis=1),
        frequency,
        damping,
    )


def _discriminant(car: SingleTrackCar, u: np.ndarray) -> np.ndarray:
    """Return (A_11 − A_22)²/4 + A_12 A_21 of the state matrix, without cancellation in sums."""
    m, inertia, a, b = car.mass, car.yaw_inertia, car.front, car.rear
    C_f, C_r = car.front_stiffness, car.rear_stiffness
    lever = b * C_r - a * C_f
    difference = ((a**2 * C_f + b**2 * C_r) / inertia - (C_f + C_r) / m) / (2.0 * u)
    result: np.ndarray = difference**2 + (lever / (m * u) - u) * lever / (inertia * u)
    return result
