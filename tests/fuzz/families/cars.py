"""Single-track cars and their manoeuvres."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import mkdtemp
from typing import Any

import numpy as np
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from fuzz.families.tires import _amount as amount, _inputs as inputs
from fuzz.kinds import Kind, RefusedError, array, choice, integer, nothing, real, text
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
from pydy.vehicles.gg import GGDiagram, gg_diagram
from pydy.vehicles.machines import (
    aerodynamic_loads,
    anti_roll_bar_loads,
    brake,
    bushing_loads,
    clutch,
    clutch_capacity,
    differential_torques,
    gear_ratio,
    gear_torque,
    motor_torque,
    power_limited_torque,
    torsion_bar_stiffness,
)
from pydy.vehicles.scenes import car_scene
from pydy.vehicles.suspensions import (
    SPRUNG_AXLES,
    SprungAxles,
    sprung_double_track,
)
from pydy.vehicles.tracks import Lap, Track, TrackSystem, along, read_track
from zoo import inertial_frame
from zoo.race_cars import point_mass
from zoo.suspended import SPATIAL

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


@target("commonroad_car.model", choice("ST", "STD", "MB"))
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


@target("car_trailer.tires", nothing("texts", "symbols", allowed=one_of(None)))
def _(v):
    return str(car_trailer(_car, v, **_TRAILER))


@target("car_trailer.trailer_tire", nothing("texts", "symbols"))
def _(v):
    return str(car_trailer(_car, **{**_TRAILER, "stiffness": None}, trailer_tire=v))


@target("car_trailer.free_speed", flags)
def _(v):
    return str(car_trailer(_car, **_TRAILER, free_speed=v).states)


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


@target("power_limited_torque.speed", inputs)
def _(v):
    return str(power_limited_torque(v, 2.0, 3.0))


for _name in ("torque", "power", "ratio"):

    @target(f"power_limited_torque.{_name}", amount(above=0.0))
    def _(v, name=_name):
        return str(power_limited_torque(1.0, **{"torque": 2.0, "power": 3.0, name: v}))


@target("gear_ratio.gear", inputs)
def _(v):
    return str(gear_ratio(v, [3.0, 2.0]))


@target(
    "gear_ratio.ratios",
    array((None,), check=lambda a: len(a) and (np.isfinite(a) & (a != 0.0)).all()),
)
def _(v):
    return gear_ratio(1, v)


@target("gear_ratio.final", _positive)
def _(v):
    return gear_ratio(1, [2.0], final=v)


for _name in ("torque", "speed", "ratio"):

    @target(f"gear_torque.{_name}", inputs)
    def _(v, name=_name):
        return str(gear_torque(**{"torque": 1.0, "speed": 2.0, "ratio": 3.0, name: v}))


for _name, _kind in {
    "efficiency": amount(above=0.0, most=1.0),
    "transition": amount(above=0.0),
}.items():

    @target(f"gear_torque.{_name}", _kind)
    def _(v, name=_name):
        return str(gear_torque(1.0, 2.0, 3.0, **{name: v}))


_friction = {"capacity": amount(least=0.0), "static_ratio": amount(least=1.0)}

for _name, _kind in {"driving": amount(), "driven": amount(), **_friction}.items():

    @target(f"clutch.{_name}", _kind)
    def _(v, name=_name):
        w = dynamicsymbols("w1 w2")
        return str(clutch(**{"driving": w[0], "driven": w[1], "capacity": 5.0, name: v}))


for _name, _kind in {"speed": amount(), **_friction}.items():

    @target(f"brake.{_name}", _kind)
    def _(v, name=_name):
        return str(brake(**{"speed": dynamicsymbols("w"), "capacity": 5.0, name: v}))


_label = Kind(lambda v: _nonempty(v), ("common", "texts"))


def _nonempty(value: Any) -> str:
    if not isinstance(value, str) or not value:
        raise RefusedError
    return str(value)


@target("clutch.name", _label)
def _(v):
    return clutch(*dynamicsymbols("w1 w2"), 5.0, name=v).name


@target("brake.name", _label)
def _(v):
    return brake(dynamicsymbols("w"), 5.0, name=v).name


_LINING = {"force": 1e3, "friction": 0.3, "inner": 0.1, "outer": 0.2}

for _name, _kind in {
    "force": amount(least=0.0),
    "friction": amount(least=0.0),
    "inner": amount(above=0.0, below=0.2),
    "outer": amount(above=0.1),
}.items():

    @target(f"clutch_capacity.{_name}", _kind)
    def _(v, name=_name):
        return str(clutch_capacity(**{**_LINING, name: v}))


@target("clutch_capacity.faces", integer(1))
def _(v):
    return clutch_capacity(**_LINING, faces=v)


@target("clutch_capacity.worn", flags)
def _(v):
    return clutch_capacity(**_LINING, worn=v)


_BAR = {"diameter": 0.02, "length": 1.0, "arm": 0.2}

for _name, _kind in {
    "diameter": amount(above=0.0),
    "length": amount(above=0.0),
    "arm": amount(above=0.0),
    "shear_modulus": amount(above=0.0),
    "inner_diameter": amount(least=0.0, below=0.02),
}.items():

    @target(f"torsion_bar_stiffness.{_name}", _kind)
    def _(v, name=_name):
        return str(torsion_bar_stiffness(**{**_BAR, name: v}))


@cache
def _ends() -> Any:
    N, O = ReferenceFrame("N"), Point("O")
    O.set_vel(N, 0)
    left = O.locatenew("L", dynamicsymbols("z") * N.z)
    return {"left": left, "right": O, "up": N.z, "body": N, "stiffness": 2.0}


for _name in ("left", "right", "up", "body"):

    @target(f"anti_roll_bar_loads.{_name}", _things)
    def _(v, name=_name):
        return str(anti_roll_bar_loads(**{**_ends(), name: v}))


@target("anti_roll_bar_loads.stiffness", amount(least=0.0))
def _(v):
    return str(anti_roll_bar_loads(**{**_ends(), "stiffness": v}))


def _bushing(**arguments: Any) -> Any:
    N, O = ReferenceFrame("N"), Point("O")
    O.set_vel(N, 0)
    pair = (N, O)
    return str(bushing_loads(**{"first": pair, "second": pair, "frame": N, **arguments}))


for _name in ("first", "second", "frame"):

    @target(f"bushing_loads.{_name}", _things)
    def _(v, name=_name):
        return _bushing(**{name: v})


def _three(value: Any) -> Any:
    if not isinstance(value, (tuple, list)) or len(value) != 3:
        raise RefusedError
    return [amount(least=0.0).read(entry) for entry in value]


for _name in ("stiffness", "damping", "torsional_stiffness", "torsional_damping"):

    @target(f"bushing_loads.{_name}", Kind(_three, _common, compare=False))
    def _(v, name=_name):
        return _bushing(**{name: v})


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


def _drawn(**arguments: Any) -> Any:
    return str(car_scene(**{"system": _system(), "car": _car, **arguments}))


for _name in ("width", "length"):

    @target(f"car_scene.{_name}", _positive)
    def _(v, name=_name):
        return _drawn(**{name: v})


for _name in ("system", "car", "position"):

    @target(f"car_scene.{_name}", _things)
    def _(v, name=_name):
        return _drawn(**{name: v})


@target("car_scene.change", nothing("texts", "symbols", allowed=one_of(None)))
def _(v):
    return _drawn(change=v)


@target("car_scene.steering", _names)
def _(v):
    return _drawn(steering=v)


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


@target("StepResponse.plot.unit", text())
def _(v):
    return plotted(_response().plot, unit=v).get_ylabel()


@target("SteadyTurn.plot.ax", _ax)
def _(v):
    return str(plotted(_turns().plot, v))


_AXLES = SPRUNG_AXLES["bmw_320i"]

for _name in SprungAxles.__dataclass_fields__:
    _may_vanish = _name.endswith(("damping", "bar"))

    @target(f"SprungAxles.{_name}", _not_negative if _may_vanish else _positive)
    def _(v, name=_name):
        return repr(replace(_AXLES, **{name: v}))


@target("sprung_double_track.car", _things)
def _(v):
    return str(sprung_double_track(v, _AXLES))


@target("sprung_double_track.axles", _things)
def _(v):
    return str(sprung_double_track(_car, v))


# Each model takes seconds to derive: what is accepted is read by `double_track` in the same way.
@target("sprung_double_track.tires", nothing("texts", "symbols", allowed=one_of(None)))
def _(v):
    return str(sprung_double_track(_car, _AXLES, v))


@target("sprung_double_track.differential", nothing("texts", "symbols"))
def _(v):
    return str(sprung_double_track(_car, _AXLES, differential=v))


for _name, _kind in (
    ("speed", _positive), ("drag_area", _not_negative), ("downforce_areas", nothing("texts")),
):  # fmt: skip

    @target(f"sprung_double_track.{_name}", _kind)
    def _(v, name=_name):
        return str(sprung_double_track(_car, _AXLES, **{name: v}))


_point = array((3,), check=lambda a: np.isfinite(a).all())
_angle = Kind(real(above=-np.pi / 2, below=np.pi / 2).read, ("common", "numbers"), compare=False)

for _suspension in SPATIAL.values():
    _class = type(_suspension).__name__
    for _name in type(_suspension).__dataclass_fields__:
        if _name != "spring_on":

            @target(f"{_class}.{_name}", _angle if _name in ("camber", "toe") else _point)
            def _(v, name=_name, suspension=_suspension):
                return repr(replace(suspension, **{name: v}))


@target("DoubleWishbone.spring_on", choice("lower_arm", "upright"))
def _(v):
    return replace(SPATIAL["wishbone"], spring_on=v).spring_on


_strut = SPATIAL["strut"]


def _travels(value: Any) -> Any:
    try:
        return [real(least=-0.05, most=0.05).read(value)]
    except RefusedError:
        return array((None,), check=lambda a: len(a) and (np.abs(a) <= 0.05).all()).read(value)


@target("McPherson.curves.travel", Kind(_travels, _common, compare=False))
def _(v):
    return _strut.curves(v, 0.3).camber


@target("McPherson.curves.radius", _positive)
def _(v):
    return _strut.curves(0.01, v).camber


@target("McPherson.curves.rack", Kind(real(least=-0.02, most=0.02).read, _common, compare=False))
def _(v):
    return _strut.curves(0.01, 0.3, rack=v).camber


@target("SuspensionCurves.plot.ax", _ax)
def _(v):
    return str(plotted(_strut.curves(0.01, 0.3).plot, v))


def _build(**arguments: Any) -> str:
    N, O = inertial_frame()
    usual = {
        "body": N, "origin": O, "frame": N, "name": "fl", "upright_mass": 1.0,
        "upright_inertia": (1, 1, 1), "wheel_mass": 1.0, "wheel_inertia": (1, 1),
    }  # fmt: skip
    return repr(_strut.build(**{**usual, **arguments}))


for _name in ("body", "origin", "frame", "force"):
    _none = one_of(None) if _name == "force" else None

    @target(f"McPherson.build.{_name}", nothing("texts", allowed=_none) if _none else _things)
    def _(v, name=_name):
        return _build(**{name: v})


@target("McPherson.build.name", _label)
def _(v):
    return _build(name=v)


for _name, _kind in {
    "upright_mass": amount(least=0.0),
    "wheel_mass": amount(least=0.0),
    "upright_inertia": Kind(_three, _common, compare=False),
    "wheel_inertia": Kind(lambda v: _pair(v), _common, compare=False),
    "arm_masses": nothing("texts"),
    "rack": amount(),
}.items():

    @target(f"McPherson.build.{_name}", _kind)
    def _(v, name=_name):
        return _build(**{name: v})


def _pair(value: Any) -> Any:
    if not isinstance(value, (tuple, list)) or len(value) != 2:
        raise RefusedError
    return [amount(least=0.0).read(entry) for entry in value]


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
    system = _on_track().system
    system.times = np.linspace(0.0, 5.0, num=11)  # straight on
    return _on_track().lap(system.simulate())


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


_FORCES = {"a_x": (-6.0, 3.0), "a_y": (-8.0, 8.0)}


def _gg(**arguments: Any) -> Any:
    usual = {"system": point_mass(), "speeds": 20.0, "bounds": _FORCES, "directions": [0.5]}
    return gg_diagram(**{**usual, **arguments}).acceleration


for _name in ("system", "position"):

    @target(f"gg_diagram.{_name}", _plain)
    def _(v, name=_name):
        return _gg(**{name: v})


@target("gg_diagram.bounds", nothing("texts", "symbols"))
def _(v):
    return _gg(bounds=v)


@target("gg_diagram.path", nothing("texts", "symbols", allowed=empty_or_none))
def _(v):
    return _gg(path=v)


@target("gg_diagram.inputs", nothing("texts", "symbols", allowed=one_of(None)))
def _(v):
    return _gg(inputs=v)


def _no_pairs(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and not value


@target("gg_diagram.exclusive", nothing("texts", "symbols", allowed=_no_pairs))
def _(v):
    return _gg(exclusive=v)


@target("gg_diagram.speeds", Kind(real(least=1.0, below=1e3).read, _common, compare=False))
def _(v):
    return _gg(speeds=v)


@target("gg_diagram.sideslip", Kind(real(above=0.0, below=np.pi / 2).read, _common, compare=False))
def _(v):
    return _gg(sideslip=v)


@target("gg_diagram.slip", Kind(real(above=0.0).read, _common, compare=False))
def _(v):
    return _gg(slip=v)


_angles = array((), (None,), check=lambda a: np.isfinite(a).all())
_directions = Kind(_angles.read, ("common", "arrays"), compare=False).or_none()


@target("gg_diagram.directions", _directions)
def _(v):
    return _gg(directions=v)


@target("GGDiagram.plot.ax", _ax)
def _(v):
    nothing_active = np.empty((1, 2), dtype=object)
    diagram = GGDiagram(
        np.ones(1), np.zeros(2), np.ones((1, 2)), np.ones((1, 2, 4)), {}, nothing_active
    )
    return str(plotted(diagram.plot, v))
