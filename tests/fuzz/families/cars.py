"""Single-track cars and their manoeuvres."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import mkdtemp
from typing import Any

import numpy as np
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from fuzz.families.tires import _amount as amount, _inputs as inputs
from fuzz.kinds import Kind, RefusedError, array, choice, nothing, real
from fuzz.table import empty_or_none, flags, one_of, plotted, target
from pydy.system import System
from pydy.vehicles import (
    CARS,
    DoubleTrackCar,
    LinearHandling,
    SingleTrackCar,
    SteadyTurn,
    StepResponse,
    car_trailer,
    commonroad_car,
    double_track,
    lane_change,
    linear_handling,
    single_track,
    steady_turn,
    step_steer,
)
from pydy.vehicles.machines import aerodynamic_loads, differential_torques, motor_torque
from pydy.vehicles.tracks import Lap, Track, TrackSystem, along, read_track

_FIELDS = {
    "mass": 1500.0, "yaw_inertia": 2500.0, "front": 1.2, "rear": 1.5,
    "front_stiffness": 9e4, "rear_stiffness": 1.1e5,
}  # fmt: skip
_DOUBLE = {
    **_FIELDS,
    "height": 0.6, "front_track": 1.4, "rear_track": 1.4, "wheel_radius": 0.3,
    "wheel_inertia": 1.5, "front_roll_share": 0.5, "front_drive_share": 0.0,
    "front_brake_share": 0.7,
}  # fmt: skip
_car = CARS["bmw_320i"]
_things = nothing("texts", "symbols")
_names = nothing("texts")
_ax = nothing("texts", allowed=one_of(None))
_positive = Kind(real(above=0.0).read, ("common", "numbers"), compare=False)


@cache
def _system() -> System:
    return single_track(_car)


for _name in _FIELDS:

    @target(f"SingleTrackCar.{_name}", _positive)
    def _(v, name=_name):
        return repr(SingleTrackCar(**{**_FIELDS, name: v}))


_share = Kind(real(least=0.0, most=1.0).read, ("common", "numbers"), compare=False)

for _name in _DOUBLE:

    @target(f"DoubleTrackCar.{_name}", _share if _name.endswith("share") else _positive)
    def _(v, name=_name):
        return repr(DoubleTrackCar(**{**_DOUBLE, name: v}))


@target("commonroad_car.vehicle", choice(*CARS))
def _(v):
    return str(commonroad_car(v))


@target("commonroad_car.model", choice("ST", "STD"))
def _(v):
    return str(commonroad_car("bmw_320i", v))


@target("commonroad_car.speed", _positive)
def _(v):
    return str(commonroad_car("bmw_320i", speed=v).initial_conditions)


@target("single_track.car", _things)
def _(v):
    return str(single_track(v))


@target("single_track.tires", nothing("texts", "symbols", allowed=one_of(None)))
def _(v):
    return str(single_track(_car, v))


@target("single_track.speed", _positive)
def _(v):
    return str(single_track(_car, speed=v).constants)


@target("single_track.free_speed", flags)
def _(v):
    return str(single_track(_car, free_speed=v).states)


@target("linear_handling.car", _things)
def _(v):
    return linear_handling(v, 10.0).speeds


def _some(value: Any) -> Any:
    if not isinstance(value, (list, tuple, np.ndarray)) or np.ndim(value) == 0:
        return real(above=0.0).read(value)
    return array((None,), check=lambda a: len(a) and (np.isfinite(a) & (a > 0)).all()).read(value)


@target("linear_handling.speeds", Kind(_some, ("common",), compare=False))
def _(v):
    return linear_handling(_car, v).speeds


def _step(**arguments: Any) -> Any:
    usual = {"system": _system(), "angle": 0.01, "duration": 3.0}
    return step_steer(**{**usual, **arguments})


@target("step_steer.system", _things)
def _(v):
    return _step(system=v).values


def _steering(value: Any) -> Any:
    angle = real(above=-np.pi / 2, below=np.pi / 2).read(value)
    if angle == 0.0:
        raise RefusedError
    return angle


_common = ("common", "texts")


@target("step_steer.angle", Kind(_steering, _common, compare=False))
def _(v):
    return _step(angle=v).values


@target("step_steer.duration", Kind(real(above=0.0).read, _common, compare=False))
def _(v):
    return _step(duration=v).values


@target("step_steer.quantity", _names)
def _(v):
    return _step(quantity=v).values


@target("step_steer.steering", _names)
def _(v):
    return _step(steering=v).values


def _turn(**arguments: Any) -> Any:
    usual = {"system": _system(), "radius": 100.0, "accelerations": [1.0, 2.0, 3.0]}
    return steady_turn(**{**usual, **arguments})


@target("steady_turn.radius", Kind(real(above=0.0).read, _common, compare=False))
def _(v):
    return _turn(radius=v).angles


for _name in ("system", "accelerations"):

    @target(f"steady_turn.{_name}", nothing("texts", "symbols"))
    def _(v, name=_name):
        return _turn(**{name: v}).angles


@target("steady_turn.position", nothing("texts", "symbols"))
def _(v):
    return _turn(position=v).angles


@target("steady_turn.inputs", nothing("texts", "symbols", allowed=one_of(None)))
def _(v):
    return _turn(inputs=v).angles


for _name in ("steering", "speed", "yaw_rate"):

    @target(f"steady_turn.{_name}", _names)
    def _(v, name=_name):
        return _turn(**{name: v}).angles


@target("double_track.car", _things)
def _(v):
    return str(double_track(v))


@target("double_track.tires", nothing("texts", "symbols", allowed=one_of(None)))
def _(v):
    return str(double_track(_car, v))


@target("double_track.differential", choice("open", "locked"))
def _(v):
    return str(double_track(_car, differential=v))


@target("double_track.speed", _positive)
def _(v):
    return str(double_track(_car, speed=v).initial_conditions)


@target("double_track.lag", _positive)
def _(v):
    return str(double_track(_car, lag=v).constants)


_not_negative = Kind(real(least=0.0).read, ("common", "numbers"), compare=False)


@target("double_track.drag_area", _not_negative)
def _(v):
    return str(double_track(_car, drag_area=v).constants)


def _two(value: Any) -> Any:
    if not isinstance(value, (tuple, list)) or len(value) != 2:
        raise RefusedError
    return [_not_negative.read(x) for x in value]


@target("double_track.downforce_areas", Kind(_two, _common, compare=False))
def _(v):
    return str(double_track(_car, downforce_areas=v).constants)


_TRAILER = {
    "mass": 1200.0, "yaw_inertia": 2500.0, "length": 4.0, "stiffness": 7e4, "speed": 20.0,
    "hitch": 2.5, "centre": 4.2,
}  # fmt: skip
_finite = Kind(real().read, ("common", "numbers"), compare=False)

for _name in _TRAILER:

    @target(f"car_trailer.{_name}", _finite if _name in ("hitch", "centre") else _positive)
    def _(v, name=_name):
        return str(car_trailer(_car, **{**_TRAILER, name: v}).constants)


@target("car_trailer.car", _things)
def _(v):
    return str(car_trailer(v, **_TRAILER))


for _name in ("torque", "left", "right"):

    @target(f"differential_torques.{_name}", inputs)
    def _(v, name=_name):
        return str(differential_torques(**{"torque": 1.0, "left": 2.0, "right": 3.0, name: v}))


for _name, _kind in {
    **dict.fromkeys(("preload", "viscosity"), amount(least=0.0)),
    "bias": amount(least=0.0, most=1.0),
    "transition": amount(above=0.0),
}.items():

    @target(f"differential_torques.{_name}", _kind)
    def _(v, name=_name):
        return str(differential_torques(1.0, 2.0, 3.0, **{name: v}))


@target("motor_torque.speed", inputs)
def _(v):
    return str(motor_torque(v, [0.0, 1.0], [2.0, 3.0]))


@target("motor_torque.ratio", _positive)
def _(v):
    return str(motor_torque(0.5, [0.0, 1.0], [2.0, 3.0], ratio=v))


_ascending = array((2,), check=lambda a: np.isfinite(a).all() and a[0] < a[1])
_numbers = array((2,), check=lambda a: np.isfinite(a).all())

for _name, _kind in (("speeds", _ascending), ("torques", _numbers)):

    @target(f"motor_torque.{_name}", _kind)
    def _(v, name=_name):
        return motor_torque(0.5, **{"speeds": [0.0, 1.0], "torques": [2.0, 3.0], name: v})


@cache
def _moving() -> Any:
    N, P = ReferenceFrame("N"), Point("P")
    P.set_vel(N, dynamicsymbols("u") * N.x)
    return {"point": P, "forward": N.x, "up": N.z, "frame": N, "drag_area": 0.6}


for _name, _kind in {
    **dict.fromkeys(("point", "forward", "up", "frame"), _things),
    "drag_area": amount(least=0.0),
    "lift_area": amount(),
    "density": amount(above=0.0),
}.items():

    @target(f"aerodynamic_loads.{_name}", _kind)
    def _(v, name=_name):
        return str(aerodynamic_loads(**{**_moving(), name: v}))


def _change(**arguments: Any) -> Any:
    return lane_change(**{"system": _system(), "width": 1.6, **arguments}).clearances


for _name in ("width", "length", "preview"):

    @target(f"lane_change.{_name}", Kind(real(above=0.0, below=1e6).read, _common, compare=False))
    def _(v, name=_name):
        return _change(**{name: v})


@target("lane_change.gain", Kind(real().read, _common, compare=False).or_none())
def _(v):
    return _change(gain=v)


@target("lane_change.track", choice("ISO 3888-1", "ISO 3888-2"))
def _(v):
    return _change(track=v)


for _name in ("system", "position"):

    @target(f"lane_change.{_name}", nothing("texts", "symbols"))
    def _(v, name=_name):
        return _change(**{name: v})


for _name in ("steering", "speed", "yaw_rate"):

    @target(f"lane_change.{_name}", _names)
    def _(v, name=_name):
        return _change(**{name: v})


@cache
def _handling() -> LinearHandling:
    return linear_handling(_car, [10.0, 20.0])


@cache
def _response() -> StepResponse:
    return _step()


@cache
def _turns() -> SteadyTurn:
    return _turn()


@target("LinearHandling.plot.axes", _ax)
def _(v):
    return str(plotted(_handling().plot, v))


@target("LinearHandling.plot_eigenvalues.ax", _ax)
def _(v):
    return str(plotted(_handling().plot_eigenvalues, v))


@target("LaneChange.plot.ax", _ax)
def _(v):
    return str(plotted(lane_change(_system(), 1.6).plot, v))


@target("StepResponse.plot.ax", _ax)
def _(v):
    return str(plotted(_response().plot, v))


@target("SteadyTurn.plot.ax", _ax)
def _(v):
    return str(plotted(_turns().plot, v))


# ---- Tracks ----

_BEND = 2 * np.pi * np.arange(12) / 12
_POINTS = 50.0 * np.stack([np.cos(_BEND), np.sin(_BEND)], axis=1)


@cache
def _ring() -> Track:
    return Track.circle(50.0, 10.0)


@cache
def _on_track() -> TrackSystem:
    return along(_ring(), single_track(_car, free_speed=True), width=1.6)


@cache
def _lap() -> Lap:
    return _on_track().lap(_on_track().system.simulate())


def _through(**arguments: Any) -> Any:
    usual = {"points": _POINTS, "right": 4.0, "left": 4.0}
    return Track.through(**{**usual, **arguments}).length


def _segments(**arguments: Any) -> Any:
    usual = {"segments": [(10.0, 0.0)], "right": 4.0, "left": 4.0, "closed": False}
    return Track.segments(**{**usual, **arguments}).widths([1.0])


_plain = nothing("texts", "symbols")


@target("Track.through.points", _plain)
def _(v):
    return _through(points=v)


@target("Track.segments.segments", _plain)
def _(v):
    return _segments(segments=v)


def _not_below_zero(a: np.ndarray) -> Any:
    return (np.isfinite(a) & (a >= 0.0)).all()


for _name in ("right", "left"):

    @target(f"Track.through.{_name}", array((), (12,), check=_not_below_zero))
    def _(v, name=_name):
        return _through(**{name: v})

    @target(f"Track.segments.{_name}", array((), (2,), check=_not_below_zero))
    def _(v, name=_name):
        return _segments(**{name: v})


@target("Track.through.closed", flags)
def _(v):
    return _through(closed=v)


@target("Track.segments.closed", flags)
def _(v):
    segments = [(100 * np.pi, 0.02)]
    return _segments(segments=segments, closed=v)


@target("Track.through.smoothing", Kind(real(least=0.0).read, _common, compare=False))
def _(v):
    return _through(smoothing=v)


for _name in ("radius", "width"):

    @target(f"Track.circle.{_name}", _positive)
    def _(v, name=_name):
        return str(Track.circle(**{"radius": 50.0, "width": 10.0, name: v}))


for _name in ("straight", "radius", "width"):

    @target(f"Track.oval.{_name}", _positive)
    def _(v, name=_name):
        return str(Track.oval(**{"straight": 100.0, "radius": 50.0, "width": 10.0, name: v}))


_lengths = array((), (None,), check=lambda a: np.isfinite(a).all())

for _name in ("curvature", "heading", "position", "widths"):

    @target(f"Track.{_name}.s", Kind(_lengths.read, ("common", "arrays"), compare=False))
    def _(v, name=_name):
        return getattr(_ring(), name)(v)


@target("Track.position.n", Kind(array((), (None,)).read, ("common", "arrays"), compare=False))
def _(v):
    return _ring().position(1.0, v)


_pairs = array((None, 2), check=lambda a: np.isfinite(a).all())


@target("Track.locate.points", Kind(_pairs.read, ("common", "arrays"), compare=False))
def _(v):
    return _ring().locate(v)


@target("Track.plot.ax", _ax)
def _(v):
    return str(plotted(_ring().plot, v))


@target("read_track.path", nothing("symbols"))
def _(v):
    return read_track(v)


def _read(**arguments: Any) -> Any:
    file = Path(mkdtemp()) / "ring.csv"
    file.write_text("\n".join(f"{x},{y},4,4" for x, y in _POINTS.tolist()), encoding="utf-8")
    return read_track(file, **arguments).length


@target("read_track.closed", flags)
def _(v):
    return _read(closed=v)


@target("read_track.smoothing", Kind(real(least=0.0).read, _common, compare=False))
def _(v):
    return _read(smoothing=v)


def _along(**arguments: Any) -> Any:
    usual = {"track": _ring(), "system": single_track(_car, free_speed=True)}
    return str(along(**{**usual, **arguments}).bounds)


for _name in ("track", "system", "position"):

    @target(f"along.{_name}", _plain)
    def _(v, name=_name):
        return _along(**{name: v})


@target("along.width", Kind(real(least=0.0, below=10.0).read, _common, compare=False))
def _(v):
    return _along(width=v)


@target("along.inputs", nothing("texts", "symbols", allowed=empty_or_none))
def _(v):
    return _along(inputs=v)


@target("along.periodic", Kind(lambda v: v if v is None else flags.read(v), flags.groups))
def _(v):
    return _along(periodic=v)


@target("TrackSystem.lap.motion", _plain)
def _(v):
    return _on_track().lap(v).time


@target("Lap.plot.ax", _ax)
def _(v):
    return str(plotted(_lap().plot, v))


@target("Lap.plot.quantity", _names)
def _(v):
    return str(plotted(_lap().plot, quantity=v))
