"""Lap: a motion along a track, in the plane and over time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._axes import axes_of
from pydy._checks import text
from pydy._forks import cached_property
from pydy.inputs import SampledInput
from pydy.trajectory import Trajectory
from pydy.vehicles.manoeuvres import check_name, names_of
from pydy.vehicles.track import Track

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from pydy._sympy_types import AnySymbol
    from pydy.control import OptimalTrajectory
    from pydy.system import System

_POINTS, _WEIGHTS = np.polynomial.legendre.leggauss(6)


@dataclass(frozen=True, eq=False)
class Lap:
    """A motion along a track.

    Attributes
    ----------
    track : Track
    vehicle : System
        In the plane, over time.
    motion : OptimalTrajectory or Trajectory
        Over the arc length s (m): its `times` are arc lengths.
    """

    track: Track
    vehicle: System
    motion: OptimalTrajectory | Trajectory
    _position: tuple[str, str, str]

    def __repr__(self) -> str:
        return f"<Lap of {self.motion.times[-1]:.4g} m: {self.time:.6g} s>"

    @property
    def time(self) -> float:
        """The time at the end (s)."""
        return float(self.times[-1])

    @property
    def s(self) -> np.ndarray:
        """Arc lengths (m) of the motion, shape (m,)."""
        return self.motion.times

    @cached_property
    def times(self) -> np.ndarray:
        """Times (s) at which the vehicle is at the arc lengths, shape (m,)."""
        return np.append(0.0, np.cumsum(self._durations(self.s[:-1], self.s[1:])))

    def _durations(self, start: np.ndarray, end: np.ndarray) -> np.ndarray:
        """Return the integrals of the pace between arc lengths, shape (k,)."""
        half = (end - start) / 2
        s = ((start + end) / 2)[:, None] + half[:, None] * _POINTS
        pace = np.asarray(self.motion.at(s.ravel())["pace"]).reshape(s.shape)
        durations: np.ndarray = half * (pace @ _WEIGHTS)
        return durations

    @cached_property
    def path(self) -> np.ndarray:
        """The path in the plane (m), shape (m, 2)."""
        return self.track.position(self.s, self.motion["n"])

    @cached_property
    def trajectory(self) -> Trajectory:
        """The motion of the vehicle in the plane, over time, at the same instants."""
        return self._over_time()

    def inputs(self) -> dict[AnySymbol, SampledInput]:
        """Return the controls of an optimum over time, for a simulation of the vehicle.

        Returns
        -------
        dict
            From each control's symbol to its samples.
        """
        controls = self.motion.inputs()  # type: ignore[union-attr]
        inputs = {}
        for symbol, samples in controls.items():
            s = samples.breaks
            times = np.append(0.0, np.cumsum(self._durations(s[:-1], s[1:])))
            ascending = np.append(True, np.diff(times) > 0.0)  # but for rounding
            inputs[symbol] = SampledInput(
                times[ascending], samples.values[ascending], samples.interpolation
            )
        return inputs

    def _over_time(self) -> Trajectory:
        motion, vehicle = self.motion, self.vehicle
        x, y, psi = self._position
        planar = {
            x: self.path[:, 0],
            y: self.path[:, 1],
            psi: np.asarray(self.track.heading(self.s)) + motion["xi"],
        }

        def table(symbols: Any) -> np.ndarray:
            columns = [
                planar[name] if name in planar else motion[name] for name in names_of(symbols)
            ]
            return np.array(columns).reshape(len(columns), len(self.s)).T

        known = motion.names_of("specified")
        specifieds = [
            s for s in sorted(vehicle.specifieds_symbols, key=str) if str(s.func) in known
        ]
        states, inputs = table(vehicle.states), table(specifieds)
        times = self.times
        outputs = list(vehicle.outputs_symbols)
        rows = [
            vehicle.evaluate_outputs(state, t, r=dict(zip(specifieds, row, strict=True)))
            for state, t, row in zip(states, times, inputs.tolist(), strict=True)
        ]
        return Trajectory(
            times,
            states,
            {
                "coordinate": list(vehicle.coordinates),
                "speed": list(vehicle.speeds),
                "output": outputs,
                "specified": specifieds,
            },
            outputs=np.array(rows) if outputs else None,
            specifieds=inputs,
            constants=dict(vehicle.constants),
        )

    def plot(self, ax: Axes | None = None, *, quantity: str = "speed") -> Axes:
        """Plot the path on the track, coloured by a quantity.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Where to draw; a new figure by default.
        quantity : str, optional
            Of the motion: a state, an output or a control.

        Returns
        -------
        matplotlib Axes
        """
        quantity = text(quantity, "`quantity`", empty=False)
        names = self.motion.names_of("coordinate", "speed", "output", "specified")
        check_name(quantity, "quantity", names)
        ax = self.track.plot(axes_of(ax, "pydy.vehicles"))
        from matplotlib.collections import LineCollection

        values = np.asarray(self.motion[quantity])
        points = self.path
        lines = LineCollection(list(np.stack([points[:-1], points[1:]], axis=1)), linewidths=2.0)
        lines.set_array((values[:-1] + values[1:]) / 2)
        ax.add_collection(lines)
        unit = " (m/s)" if quantity == "speed" else ""
        ax.figure.colorbar(lines, ax=ax, label=quantity + unit)
        return ax
