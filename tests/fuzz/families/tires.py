"""Tires: their parameters, inputs, files, fits and plots."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import ReferenceFrame, RigidBody, dynamicsymbols, inertia

from fuzz.kinds import Kind, RefusedError, array, choice, integer, nothing, real
from fuzz.table import expression, mapping, one_of, plotted, target
from pydy.vehicles import (
    BrushTire,
    LinearTire,
    MagicFormula,
    RoadProfile,
    RoadSurface,
    TMeasy,
    WheelContact,
    fit_tire,
    iso_road,
    plot_tire,
    plot_tire_carpet,
    read_tir,
)
from zoo import inertial_frame
from zoo.tires import TABLE_A31


def _parameter(value: Any) -> Any:
    """Return a number or an expression that may stand for one."""
    found = expression(value)
    if isinstance(found, sm.Basic) and (found.is_Relational or not isinstance(found, sm.Expr)):
        raise RefusedError
    return found


def _amount(**limits: float) -> Kind:
    def read(value: Any) -> Any:
        found = _parameter(value)
        if isinstance(found, sm.Expr) and not found.is_number:
            return found
        return real(**limits).read(found)

    return Kind(read, ("common", "numbers", "symbols"), compare=False)


def _quantity(value: Any) -> Any:
    """Return a number, an array or an expression."""
    if isinstance(value, list) and not value:
        return value
    try:
        return _parameter(value)
    except RefusedError:
        return array((None,), (None, None), check=lambda a: np.isfinite(a).all()).read(value)


_inputs = Kind(_quantity, ("common", "numbers", "symbols"), compare=False)
_texts = nothing("texts", "symbols")


@cache
def _tire() -> MagicFormula:
    stiff = {"LONGITUDINAL_STIFFNESS": 3e5, "LATERAL_STIFFNESS": 1e5}
    return MagicFormula({**TABLE_A31, **stiff})


@target("read_tir.path", _texts, "`path`", "No such file", "Is a directory", "neither")
def _(v):
    return read_tir(v)


@target("MagicFormula.coefficients", nothing("texts", "symbols", "arrays"), "coefficient")
def _(v):
    return MagicFormula(v)


@target("MagicFormula.version", choice("5.2", "6.1", "6.2", "PAC2002").or_none())
def _(v):
    return MagicFormula(TABLE_A31, v).version


_OPTIONS: dict[str, Kind] = {
    "equations": choice("pacejka", "besselink").or_none(),
    "side": choice("left", "right").or_none(),
    "combined": choice("coefficients", "ellipse", "none").or_none(),
    "slip": choice("tangent", "angle").or_none(),
    "friction_saturation": real(above=0.0).or_none(),
}

for _name, _kind in _OPTIONS.items():

    @target(f"MagicFormula.{_name}", _kind)
    def _(v, name=_name):
        return MagicFormula(TABLE_A31, **{name: v}).forces(4000, 0.1, 0.1)


def _mode(value: Any) -> Any:
    found = real().read(value)
    if isinstance(value, bool) or found not in range(1000) or found % 10 > 4:
        raise RefusedError
    return found


def _one(value: Any) -> Any:
    found = real().read(value)
    if found not in (-1.0, 1.0):
        raise RefusedError
    return found


@target("MagicFormula.use_mode", Kind(_mode, ("common", "numbers"), compare=False).or_none())
def _(v):
    return MagicFormula(TABLE_A31, use_mode=v).forces(4000, 0.1, 0.1)


@target("MagicFormula.relaxation_sign", Kind(_one, ("common", "numbers")).or_none())
def _(v):
    return MagicFormula(TABLE_A31, relaxation_sign=v).forces(4000, 0.1, 0.1)


_USUAL = {"Fz": 4000.0, "kappa": 0.1, "alpha": 0.1, "gamma": 0.0}
for _method, _names in {
    "forces": (*_USUAL, "speed", "pressure"),
    "slip_stiffnesses": ("Fz", "gamma", "pressure"),
    "relaxation_lengths": ("Fz", "gamma", "pressure"),
}.items():
    for _name in _names:
        _kind = _inputs.or_none() if _name in ("speed", "pressure") else _inputs

        @target(f"MagicFormula.{_method}.{_name}", _kind)
        def _(v, method=_method, name=_name, names=_names):
            usual = {k: x for k, x in _USUAL.items() if k in names}
            return [str(x) for x in getattr(_tire(), method)(**{**usual, name: v})]


for _name in ("gap", "rate"):

    @target(f"MagicFormula.normal_force.{_name}", _inputs)
    def _(v, name=_name):
        tire = _tire().replace(VERTICAL_STIFFNESS=2e5)
        return str(tire.normal_force(**{"gap": -0.01, "rate": 0.0, name: v}))


@target("MagicFormula.rolling_radius.Fz", _inputs)
def _(v):
    tire = _tire().replace(VERTICAL_STIFFNESS=2e5, BREFF=8.4, DREFF=0.27, FREFF=0.045)
    return str(tire.rolling_radius(v))


for _name in _USUAL:

    @target(f"forces.{_name}", _inputs)
    def _(v, name=_name):
        return [str(x) for x in LinearTire(4000, 1e5).forces(**{**_USUAL, name: v})]


for _name in ("speed", "pressure"):

    @target(f"forces.{_name}", _inputs.or_none())
    def _(v, name=_name):
        return [str(x) for x in LinearTire(4000, 1e5).forces(**_USUAL, **{name: v})]


_positive, _not_negative, _any = _amount(above=0.0), _amount(least=0.0), _amount()
_LINEAR = {
    "nominal_load": _positive,
    **dict.fromkeys(("cornering_stiffness", "slip_stiffness", "rolling_resistance"), _not_negative),
    **dict.fromkeys(("camber_stiffness", "trail"), _any),
    "low_speed": _positive,
}
_BRUSH = {
    **dict.fromkeys(("nominal_load", "stiffness", "friction"), _positive),
    "half_length": _not_negative,
}

for _class, _usual, _table in (
    (LinearTire, {"nominal_load": 4000.0, "cornering_stiffness": 1e5}, _LINEAR),
    (BrushTire, {"nominal_load": 4000.0, "stiffness": 1e5, "friction": 1.0}, _BRUSH),
):
    for _name, _kind in _table.items():

        @target(f"{_class.__name__}.{_name}", _kind)
        def _(v, cls=_class, usual=_usual, name=_name):
            return repr(cls(**{**usual, name: v}))


_PAIRS = {
    **dict.fromkeys(("rise_x", "rise_y"), (1e5, 1.8e5)),
    **dict.fromkeys(("peak_x", "peak_y"), (4e3, 7e3)),
    **dict.fromkeys(("peak_slip_x", "peak_slip_y"), (0.1, 0.12)),
    **dict.fromkeys(("sliding_x", "sliding_y"), (3e3, 6e3)),
    **dict.fromkeys(("sliding_slip_x", "sliding_slip_y"), (0.5, 0.6)),
}


def _pair(least: float) -> Kind:
    def read(value: Any) -> Any:
        if not isinstance(value, (tuple, list)) or len(value) != 2:
            raise RefusedError
        return tuple(_amount(above=least).read(v) for v in value)

    return Kind(read, ("common", "texts", "arrays"), compare=False)


for _name in (*_PAIRS, "trail", "zero_slip", "end_slip"):
    # No value is below the usual ones of the slips that must be larger.
    _less = _name in ("peak_slip_x", "peak_slip_y", "zero_slip")
    _kind = _pair(-np.inf if _name == "trail" else 0.0)

    @target(f"TMeasy.{_name}", nothing("texts", "arrays") if _less else _kind, f"`{_name}")
    def _(v, name=_name):
        return repr(TMeasy(4000.0, **{**_PAIRS, name: v}))


@target("TMeasy.nominal_load", _positive)
def _(v):
    return repr(TMeasy(v, **_PAIRS))


def _fit(**given: Any) -> dict[str, float]:
    alpha = np.linspace(-0.1, 0.1, 5)
    tire = LinearTire(4000.0, 1e5)
    usual = {
        "measurements": {"Fz": 4000.0, "kappa": 0.0, "alpha": alpha, "Fy": -9e4 * alpha},
        "tire": tire,
        "free": ["cornering_stiffness"],
    }
    return fit_tire(**{**usual, **given}).estimates


@target("fit_tire.measurements", nothing("texts", "arrays"), "`measurements`")
def _(v):
    return _fit(measurements=v)


@target("fit_tire.tire", nothing("texts", "symbols"))
def _(v):
    return _fit(tire=v)


@target("fit_tire.free", nothing("texts", "symbols"))
def _(v):
    return _fit(free=v)


@target("fit_tire.bounds", mapping)
def _(v):
    return _fit(bounds=v)


@cache
def _wheel() -> Any:
    N, O = inertial_frame()
    x, z, q, vx, vz, w = dynamicsymbols("x z q vx vz w")
    W = ReferenceFrame("W")
    W.orient_axis(N, N.y, q)
    W.set_ang_vel(N, w * N.y)
    G = O.locatenew("G", x * N.x + z * N.z)
    G.set_vel(N, vx * N.x + vz * N.z)
    body = RigidBody("wheel", G, W, 10, (inertia(W, 0, 1, 0), G))
    return {
        "body": body, "axis": N.y, "radius": 0.3, "plane": O, "normal": N.z, "frame": N,
        "force": lambda gap, rate: -1e5 * gap,
    }  # fmt: skip


def _called(function: Any, *names: str) -> Any:
    try:
        result = function(*map(sm.Symbol, names))
    except Exception as error:
        raise RefusedError from error
    return _parameter(result)


def _law(value: Any) -> Any:
    return _called(value, "a", "b")


def _radius(value: Any) -> Any:
    return _called(value, "a") if callable(value) else _positive.read(value)


_WHEEL: dict[str, Kind] = {
    **dict.fromkeys(("body", "axis", "plane", "normal", "frame"), nothing("texts", "symbols")),
    "radius": _positive,
    "force": Kind(_law, ("common", "functions"), compare=False).or_none(),
    "crown_radius": _amount(least=0.0, below=0.3),
    "width": _amount(above=0.0).or_none(),
    "rolling_radius": Kind(_radius, ("common", "numbers", "symbols"), compare=False).or_none(),
    "low_speed": _positive,
    "name": nothing("texts", allowed=lambda v: isinstance(v, str)),
}

for _name, _kind in _WHEEL.items():

    @target(f"WheelContact.{_name}", _kind)
    def _(v, name=_name):
        return str(WheelContact(**{**_wheel(), name: v}).kappa)


@target("WheelContact.forces.tire", nothing("texts", "symbols"))
def _(v):
    return str(WheelContact(**_wheel()).forces(v))


@target("WheelContact.loads.tire", nothing("texts", "symbols", allowed=one_of(None)))
def _(v):
    return str(WheelContact(**_wheel()).loads(v))


for _method in ("forces", "loads"):

    @target(f"WheelContact.{_method}.pressure", _any.or_none())
    def _(v, method=_method):
        tire = LinearTire(4000, 1e5)
        return str(getattr(WheelContact(**_wheel()), method)(tire, v))


@target("WheelContact.brake.torque", _not_negative)
def _(v):
    return str(WheelContact(**_wheel()).brake(v).normal)


@target("WheelContact.brake.carrier", nothing("texts", "symbols", allowed=one_of(None)))
def _(v):
    return str(WheelContact(**_wheel()).brake(1.0, v).point)


@target("WheelContact.brake.name", nothing("texts", allowed=lambda v: isinstance(v, str)), "`name`")
def _(v):
    return repr(WheelContact(**_wheel()).brake(1.0, name=v))


def _lengths(value: Any) -> Any:
    if not isinstance(value, (tuple, list)) or len(value) != 2:
        raise RefusedError
    return tuple(_positive.read(x) for x in value)


_RELAXATION: dict[str, Kind] = {
    "lengths": Kind(_lengths, ("common", "texts", "arrays"), compare=False),
    "deflections": nothing("texts", "symbols"),
    "camber": nothing(
        "texts", "symbols", allowed=lambda v: v is None or isinstance(v, AppliedUndef)
    ),
    **dict.fromkeys(("low_speed", "sliding_slip"), _positive),
    "damping": _not_negative,
}

for _name, _kind in _RELAXATION.items():

    @target(f"WheelContact.with_relaxation.{_name}", _kind)
    def _(v, name=_name):
        usual = {"lengths": (0.3, 0.5), "deflections": dynamicsymbols("u v")}
        return str(WheelContact(**_wheel()).with_relaxation(**{**usual, name: v}).kappa)


def _surface(**given: Any) -> RoadSurface:
    N, O = inertial_frame()
    places = dynamicsymbols("X Y")
    usual = {"height": places[0] ** 2, "place": places, "origin": O, "frame": N}
    return RoadSurface(**{**usual, **given})


@target("RoadSurface.height", _any)
def _(v):
    return str(_surface(height=v).normal)


for _name in ("place", "origin", "frame"):

    @target(f"RoadSurface.{_name}", nothing("texts", "symbols"))
    def _(v, name=_name):
        return str(_surface(**{name: v}).normal)


@target("RoadSurface.residuals.wheel", nothing("texts", "symbols"))
def _(v):
    return str(_surface().residuals(v))


_three = array((3,), check=lambda a: np.isfinite(a).all())


_even = array((3,), check=lambda a: np.isfinite(a).all() and a[1] - a[0] == a[2] - a[1] > 0)


@target("RoadProfile.from_samples.x", _even, "`x`")
def _(v):
    return RoadProfile.from_samples(v, [0.0, 0.1, 0.0]).height(0.5)


@target("RoadProfile.from_samples.heights", _three)
def _(v):
    return RoadProfile.from_samples([0.0, 1.0, 2.0], v).height(0.5)


_WAVES = {"frequencies": [0.1, 0.2, 0.3], "amplitudes": [0.1, 0.1, 0.1], "phases": [0.0, 0.1, 0.2]}
for _name in _WAVES:

    @target(f"RoadProfile.{_name}", _three)
    def _(v, name=_name):
        return RoadProfile(**{**_WAVES, name: v}).height(0.5)


for _name in ("offset", "gradient"):

    @target(f"RoadProfile.{_name}", real())
    def _(v, name=_name):
        return RoadProfile(**_WAVES, **{name: v}).height(0.5)


for _method in ("height", "slope"):

    @target(f"RoadProfile.{_method}.x", _inputs)
    def _(v, method=_method):
        return str(getattr(RoadProfile(**_WAVES), method)(v))


_ROAD: dict[str, Kind] = {
    "road_class": choice(*"ABCDEFGH"),
    "length": real(above=0.5, most=2000.0),
    "longest": real(above=0.5, most=200.0).or_none(),
    "shortest": real(above=0.0, below=100.0),
    "seed": integer(0).or_none(),
}
for _name, _kind in _ROAD.items():

    @target(f"iso_road.{_name}", _kind)
    def _(v, name=_name):
        usual = {"road_class": "C", "length": 200.0, "seed": 1}
        return iso_road(**{**usual, name: v}).rms


_brush = BrushTire(4000.0, 1e5, 1.0, 0.05)
_finite = Kind(real().read, ("common", "numbers"), compare=False)
_extent = Kind(real(above=0.0, most=1.5).read, ("common",), compare=False).or_none()


def _some(value: Any) -> Any:
    if value is None:
        return None
    if not isinstance(value, (list, tuple, np.ndarray)) or np.ndim(value) == 0:
        return real().read(value)
    return array((None,), check=lambda a: len(a) and np.isfinite(a).all()).read(value)


_lists = Kind(_some, ("common", "numbers"), compare=False)
_PLOT: dict[str, Kind] = {
    "tire": nothing("texts", "symbols"),
    "force": choice("Fx", "Fy", "Mx", "My", "Mz"),
    "loads": _lists,
    "over": choice("kappa", "alpha", "gamma").or_none(),
    "largest": _extent,
    **dict.fromkeys(("kappa", "alpha", "gamma"), _finite),
    **dict.fromkeys(("speed", "pressure"), _finite.or_none()),
    "ax": nothing("texts", allowed=one_of(None)),
}
_CARPET: dict[str, Kind] = {
    "tire": _PLOT["tire"],
    "load": Kind(real(above=0.0).read, ("common", "numbers"), compare=False).or_none(),
    **dict.fromkeys(("kappas", "alphas"), _lists),
    "gamma": _finite,
    **dict.fromkeys(("speed", "pressure"), _finite.or_none()),
    "ax": _PLOT["ax"],
}

for _function, _table in ((plot_tire, _PLOT), (plot_tire_carpet, _CARPET)):
    for _name, _kind in _table.items():

        @target(f"{_function.__name__}.{_name}", _kind)
        def _(v, function=_function, name=_name):
            return str(plotted(function, **{"tire": _brush, name: v}))
