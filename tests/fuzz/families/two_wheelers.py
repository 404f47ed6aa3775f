"""Bicycles and motorcycles."""

from __future__ import annotations

from typing import Any

import numpy as np

from fuzz.kinds import Kind, RefusedError, nothing, real
from fuzz.table import one_of, target
from pydy.vehicles import LinearTire
from pydy.vehicles.two_wheelers import (
    BICYCLES,
    MOTORCYCLES,
    FrameBody,
    Motorcycle,
    Rider,
    TwoWheeler,
    WheelBody,
    bicycle,
    motorcycle,
)

_bicycle, _machine = BICYCLES["benchmark"], MOTORCYCLES["sharp_1971"]
_things = nothing("texts", "symbols")
_none = nothing("texts", "symbols", allowed=one_of(None))
_kinds = ("common", "numbers")
_positive = Kind(real(above=0.0).read, _kinds, compare=False)
_not_negative = Kind(real(least=0.0).read, _kinds, compare=False)
_finite = Kind(real().read, _kinds, compare=False)
_product = Kind(real(above=-1.0, below=1.0).read, _kinds, compare=False)
_crown = Kind(real(least=0.0, below=0.3).read, _kinds, compare=False)
_tilt = Kind(real(above=-np.pi / 2, below=np.pi / 2).read, _kinds, compare=False)

_FRAME = {"mass": 4.0, "x": 0.5, "height": 0.6, "Ixx": 1.0, "Iyy": 1.0, "Izz": 1.0, "Ixz": 0.0}
_of_frames = {
    **dict.fromkeys(("mass", "Iyy"), _positive),
    **dict.fromkeys(("Ixx", "Izz"), _positive),
    **dict.fromkeys(("x", "height"), _finite),
    "Ixz": _product,
}
_of_riders = {
    **_of_frames,
    "hinge_height": _finite,
    **dict.fromkeys(("stiffness", "damping"), _not_negative),
}
_RIDER = {**_FRAME, "hinge_height": 0.5, "stiffness": 100.0, "damping": 5.0}
_WHEEL = {
    "radius": 0.3, "mass": 2.0, "axial_inertia": 0.1, "diametral_inertia": 0.06,
    "crown_radius": 0.0,
}  # fmt: skip
_of_wheels = {
    **dict.fromkeys(("radius", "axial_inertia"), _positive),
    **dict.fromkeys(("mass", "diametral_inertia"), _not_negative),
    "crown_radius": _crown,
}
_of_bicycles = {
    "wheelbase": _positive,
    "trail": _finite,
    "steer_axis_tilt": _tilt,
    **dict.fromkeys(("rear_frame", "front_frame", "rear_wheel", "front_wheel"), _things),
}
_of_motorcycles = {
    **_of_bicycles,
    **dict.fromkeys(
        ("front_stiffness", "rear_stiffness", "front_relaxation", "rear_relaxation"), _not_negative
    ),
    "steering_damping": _not_negative,
    **dict.fromkeys(("front_camber_stiffness", "rear_camber_stiffness"), _finite),
}

for _made, _usual, _fields in (
    (FrameBody, _FRAME, _of_frames),
    (Rider, _RIDER, _of_riders),
    (WheelBody, _WHEEL, _of_wheels),
    (TwoWheeler, vars(_bicycle), _of_bicycles),
    (Motorcycle, vars(_machine), _of_motorcycles),
):
    for _name, _kind in _fields.items():

        @target(f"{_made.__name__}.{_name}", _kind)
        def _(v, made=_made, usual=_usual, name=_name):
            return repr(made(**{**usual, name: v}))


def _one_or_two(read: Any) -> Any:
    def reading(value: Any) -> Any:
        if not isinstance(value, (tuple, list)):
            return read(value)
        if len(value) != 2:
            raise RefusedError
        return [read(x) for x in value]

    return reading


def _two_or_none(value: Any) -> Any:
    if value is None:
        return None
    if not isinstance(value, (tuple, list)) or len(value) != 2:
        raise RefusedError
    return [_not_negative.read(x) for x in value]


_tires = LinearTire(300.0, 6000.0, 6000.0)

for _make, _data in ((bicycle, _bicycle), (motorcycle, _machine)):
    _label = _make.__name__
    for _name, _kind in {
        "vehicle": _things,
        "tires": _none,
        "rider": _none,
        "speed": _not_negative,
        "vertical_stiffness": Kind(_one_or_two(_positive.read), ("common",), compare=False),
        "vertical_damping": Kind(_one_or_two(_not_negative.read), ("common",), compare=False),
    }.items():

        @target(f"{_label}.{_name}", _kind)
        def _(v, make=_make, data=_data, name=_name):
            return str(make(**{"vehicle": data, "tires": _tires, name: v}).constants)


@target("bicycle.relaxation_lengths", Kind(_two_or_none, ("common",), compare=False))
def _(v):
    return str(bicycle(_bicycle, _tires, relaxation_lengths=v).constants)
