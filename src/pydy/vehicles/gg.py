"""The g-g diagram: the largest accelerations of a vehicle in the directions of the plane."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm

from pydy._axes import axes_of, legend_beside
from pydy._checks import number, positive, real_array, shown
from pydy._errors import warn_user
from pydy._rank import HALF
from pydy.system import System
from pydy.vehicles.largest_acceleration import LargestAcceleration
from pydy.vehicles.quasi_steady import QuasiSteadyStates

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike

__all__ = ["GGDiagram", "gg_diagram"]
__dir__ = __all__.copy

_DIRECTIONS = 72
_SEARCHED = 24  # directions that are searched whatever is asked for: optima begin at those nearby
_PARTS = (1, 2, 4)  # of a turn from one direction to another, if larger ones fail
_POLISHED = 3  # samples of a sector from which optima are searched


@dataclass(frozen=True, eq=False)
class GGDiagram:
    """The largest accelerations of a vehicle, for k speeds and m directions.

    Attributes
    ----------
    speeds : ndarray, shape (k,)
        V of the point along its path (m/s).
    directions : ndarray, shape (m,)
        Angles θ of the acceleration (rad) from forward to the left.
    acceleration : ndarray, shape (k, m)
        The largest acceleration (m/s²) in each direction; NaN where none was found.
    states : ndarray, shape (k, m, n)
        States of the vehicle there, at the origin and at the yaw angle zero.
    inputs : dict
        From the name of each input to its values, shape (k, m).
    active : ndarray of tuple of str, shape (k, m)
        What limits the acceleration beside the tires: inputs and states at their bounds,
        'sideslip', and 'path[0]' for the first relation of `path`.
    """

    speeds: np.ndarray
    directions: np.ndarray
    acceleration: np.ndarray
    states: np.ndarray
    inputs: dict[str, np.ndarray]
    active: np.ndarray

    def __repr__(self) -> str:
        with np.errstate(all="ignore"):
            found = self.acceleration[np.isfinite(self.acceleration)]
        largest = f"up to {found.max():.4g} m/s²" if found.size else "none found"
        return (
            f"<GGDiagram: {len(self.speeds)} speeds, {len(self.directions)} directions, {largest}>"
        )

    @property
    def longitudinal(self) -> np.ndarray:
        """The components along the path (m/s²), shape (k, m)."""
        result: np.ndarray = self.acceleration * np.cos(self.directions)
        return result

    @property
    def lateral(self) -> np.ndarray:
        """The components to the left of the path (m/s²), shape (k, m)."""
        result: np.ndarray = self.acceleration * np.sin(self.directions)
        return result

    def plot(self, ax: Axes | None = None) -> Axes:
        """Plot longitudinal over lateral accelerations, a curve for each speed.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Where to draw; a new figure by default.

        Returns
        -------
        matplotlib Axes
        """
        ax = axes_of(ax, "pydy.vehicles")
        for speed, ahead, aside in zip(self.speeds, self.longitudinal, self.lateral, strict=True):
            ax.plot(aside, ahead, marker=".", label=f"{speed:g} m/s")
        ax.set_aspect("equal", adjustable="datalim")
        ax.set_xlabel("lateral acceleration (m/s²)")
        ax.set_ylabel("longitudinal acceleration (m/s²)")
        ax.grid(alpha=0.3)
        legend_beside(ax)
        return ax


def gg_diagram(
    system: System,
    speeds: float | Sequence[float] | np.ndarray,
    bounds: Mapping[Any, Any],
    *,
    directions: ArrayLike | None = None,
    exclusive: Sequence[Sequence[str]] = (),
    sideslip: float = 0.2,
    slip: float = 0.3,
    path: Iterable[sm.Basic] | None = None,
    inputs: Sequence[str] | None = None,
    position: Sequence[str] = ("x", "y", "psi"),
) -> GGDiagram:
    """Return the largest accelerations of a planar vehicle in each direction (the g-g diagram).

    The vehicle is in a quasi-steady state: its speed V changes with V' = a_t, and its path turns
    with the yaw rate, so that a_n = V ψ'. The sideslip angle, the yaw rate, spins of wheels and all
    other states are constant. In each direction θ, the largest a is sought with ::

        a_t = a cos θ,   a_n = a sin θ

    within the bounds. From straight running a grows until no state nearby has a larger one. From
    there, from the best of 192 states that are spread over inputs and sideslip angles, and from the
    optima of directions nearby, sequential quadratic programming (SLSQP) with exact derivatives
    finds local optima, of which the largest is returned. Each satisfies the equations to rounding
    and has multipliers of the right sign. An axle may slide far over the peak of its tires there,
    if that makes the acceleration larger.

    Parameters
    ----------
    system : System
        A vehicle with a free speed on a level road, such as `double_track` returns; it is not
        changed. Nothing may depend on its position, its yaw angle or time, and it must have no
        constraints.
    speeds : float or sequence of float, shape (k,)
        V (m/s), positive.
    bounds : dict
        The least and the largest value of each input, finite; of states, too, where one of the pair
        may be None.
    directions : array_like, shape (m,), optional
        θ (rad) from forward to the left; by default 73 angles from 0 to 2π.
    exclusive : list of pairs of str, optional
        Inputs of which one is zero, such as ``[('T_drive', 'T_brake')]``. Without it a driver may
        brake and drive at once, to change the distribution of the forces.
    sideslip : float, optional
        Largest angle (rad) between the velocity of the point and the vehicle's axis, less than π/2.
        States beyond are drifts, which can have larger accelerations.
    slip : float, optional
        By how much spins of wheels may differ from those straight ahead at V, relative to these:
        speeds that neither the velocity nor a coordinate depends on, and that are not zero in the
        initial state. ``inf`` for no such limit.
    path : sequence of relations, optional
        Inequalities between expressions of states, inputs, constants and outputs, such as a limit
        of the force that a tire bears.
    inputs : sequence of str, optional
        The specifieds that are found, by default all; others keep their values, which are numbers
        or expressions.
    position : three of str, optional
        The coordinates x and y of the point, and the yaw angle.

    Returns
    -------
    GGDiagram

    Warns
    -----
    PyDyUserWarning
        No optimum was found in some directions, where the acceleration is NaN, as at a speed that
        the vehicle cannot keep.

    References
    ----------
    W. F. Milliken and D. L. Milliken, Race Car Vehicle Dynamics, SAE, 1995, chapter 9; A. J.
    Tremlett, F. Assadian, D. J. Purdy, N. Vaughan, A. P. Moore and M. Halley, Quasi-steady-state
    linearisation of the racing vehicle acceleration envelope, Vehicle System Dynamics 52(11), 2014,
    pp. 1416-1442.

    Examples
    --------
    >>> import numpy as np
    >>> from pydy.vehicles import CARS, BrushTire, double_track
    >>> from pydy.vehicles.gg import gg_diagram
    >>> car = double_track(CARS['bmw_320i'], BrushTire(4000, stiffness=80e3, friction=0.9))
    >>> bounds = {'delta': (-0.5, 0.5), 'T_drive': (0.0, 4e3), 'T_brake': (0.0, 8e3)}
    >>> gg = gg_diagram(car, 20.0, bounds, directions=[0.0, np.pi/2, np.pi],
    ...                 exclusive=[('T_drive', 'T_brake')])
    >>> gg.acceleration.round(2)
    array([[4.95, 8.46, 7.32]])
    """
    sideslip = number(sideslip, "`sideslip`", finite=True)
    if not 0.0 < sideslip < np.pi / 2:
        raise ValueError(
            f"`sideslip` must be an angle (rad) between zero and a right angle, got {sideslip!r}."
        )
    slip = positive(slip, "`slip`")
    values = np.atleast_1d(real_array(speeds, "`speeds`"))
    if values.ndim != 1 or not values.size or not (np.isfinite(values) & (values > 0.0)).all():
        raise ValueError(f"`speeds` must be positive finite numbers, got {shown(speeds)}.")
    if directions is None:
        angles = 2 * np.pi * np.arange(_DIRECTIONS + 1) / _DIRECTIONS
    else:
        angles = np.atleast_1d(real_array(directions, "`directions`"))
        if angles.ndim != 1 or not angles.size or not np.isfinite(angles).all():
            raise ValueError(f"`directions` must be finite angles, got {shown(directions)}.")
    vehicle = QuasiSteadyStates(system, bounds, inputs, position, sideslip, slip, exclusive, path)
    k, m, n = len(values), len(angles), len(vehicle.states)
    acceleration = np.full((k, m), np.nan)
    points = np.full((k, m, len(vehicle.start)), np.nan)
    active = np.empty((k, m), dtype=object)
    for i, speed in enumerate(values.tolist()):
        problem = LargestAcceleration(vehicle, speed)
        for j, y in enumerate(_optima(problem, angles)):
            active[i, j] = ()
            if y is not None:
                z = y * problem.scale
                acceleration[i, j], points[i, j] = z[-1], vehicle.full(z[:-1])
                active[i, j] = problem.active(y)
    if (missing := np.isnan(acceleration)).any():
        i, j = np.argwhere(missing)[0]
        warn_user(
            f"No largest acceleration was found in {missing.sum()} of {missing.size} directions, "
            f"the first at {values[i]:g} m/s and {angles[j]:.4g} rad: the diagram has NaN there. "
            "The vehicle may not be able to keep the speed, or a law has a kink at the optimum; "
            "other `bounds`, `sideslip` or `slip` may help."
        )
    controls = {name: points[:, :, n + c] for c, name in enumerate(vehicle.controls)}
    return GGDiagram(values, angles, acceleration, points[:, :, :n], controls, active)


def _optima(problem: LargestAcceleration, angles: np.ndarray) -> list[np.ndarray | None]:
    """Return the optimum of each direction, or None.

    Some directions all around are the same whatever is asked for. They are searched from straight
    ahead, and from the best samples of their sectors. Then each optimum is tried as the start of
    both neighbours until none is improved.
    """
    base = 2 * np.pi * np.arange(_SEARCHED) / _SEARCHED
    turned, places = np.unique(np.append(np.mod(angles, 2 * np.pi), base), return_inverse=True)
    places = places.ravel()
    programs = [problem.direction(angle) for angle in turned.tolist()]
    count = len(programs)
    best: list[np.ndarray | None] = [None] * count
    for k in {*places[len(angles) :].tolist()}:
        best[k] = programs[k].improved(programs[k].trace())
    sampled, samples = problem.samples()
    for k in {*places[len(angles) :].tolist()}:
        away = np.abs(np.mod(sampled - turned[k] + np.pi, 2 * np.pi) - np.pi)
        near = np.flatnonzero(away <= np.pi / _SEARCHED)
        for i in near[np.argsort(-samples[near, -1], kind="stable")][:_POLISHED]:
            # A sample satisfies the equalities in its own direction: the search begins there.
            angle = float(sampled[i])
            start = problem.direction(angle).improved(samples[i])
            if start is not None:
                best[k] = _larger(best[k], _turned(problem, start, angle, turned[k]))
    changed = [k for k in range(count) if best[k] is not None]
    for _ in range(count):
        improved: set[int] = set()
        for k in changed:
            for other in ((k + 1) % count, (k - 1) % count):
                optimum, known = best[k], best[other]
                assert optimum is not None
                best[other] = _larger(known, _turned(problem, optimum, turned[k], turned[other]))
                if best[other] is not known:
                    improved.add(other)
        changed = sorted(improved)
        if not changed:
            break
    for k in range(count):
        if best[k] is None:
            best[k] = programs[k].improved(programs[k].trace())
    return [best[place] for place in places[: len(angles)]]


def _turned(
    problem: LargestAcceleration, optimum: np.ndarray, angle: float, other: float
) -> np.ndarray | None:
    """Return the optimum in another direction that one leads to, by smaller turns if need be."""
    turn = float(np.mod(other - angle + np.pi, 2 * np.pi) - np.pi)
    for parts in _PARTS:
        y: np.ndarray | None = optimum
        for part in range(1, parts + 1):
            if y is not None:
                y = problem.direction(angle + turn * part / parts).improved(y)
        if y is not None:
            return y
    return None


def _larger(known: np.ndarray | None, trial: np.ndarray | None) -> np.ndarray | None:
    """Return the known optimum unless another is larger by more than rounding."""
    if trial is None or known is None:
        return known if trial is None else trial
    return trial if trial[-1] > known[-1] + HALF * max(1.0, known[-1]) else known
