"""Inverse dynamics, the terms of the equations of motion, frames and inertial parameters."""

from __future__ import annotations

from inspect import signature
from itertools import product
from typing import Any

from fuzz.kinds import Kind, array, nothing, real
from fuzz.table import a_dictionary, one_of, target
from fuzz.world import world
from pydy.system import System

_one = array((1,), (None, 1)).or_(a_dictionary).or_none()
_both = array((2,), (1, 2)).or_(a_dictionary).or_none()
_ARGUMENTS: dict[str, tuple[Kind, tuple[str, ...]]] = {
    "q": (_one, ()),
    "v": (_one, ()),
    "a": (_one, ()),
    "t": (array((None,)).or_(real(finite=False)).or_none(), ()),
    "r": (_both, ("`r", "specified")),
    "p": (_both, ()),
    "wrt": (nothing("symbols", "texts", allowed=one_of(None)), ()),
}
# What is called with all of these that it has; further arguments that it needs.
_METHODS: dict[str, dict[str, str]] = {
    "inverse_dynamics": {},
    "mass_matrix": {},
    "bias": {},
    "gravity": {},
    "frame_position": {"where": "P"},
    "frame_rotation": {"where": "N"},
    "frame_jacobian": {"where": "P"},
    "regressor": {},
    "inertial_parameters": {},
    "base_parameters": {},
}


def _called(method: str, **changes: Any) -> Any:
    o = world().o
    function = getattr(o.system, method)
    usual = {name: [1.0] for name in signature(function).parameters if name in ("q", "v", "a")}
    found = function(
        **{**usual, **{k: getattr(o, v) for k, v in _METHODS[method].items()}, **changes}
    )
    return found.places if method == "base_parameters" else found


for _method, _name in product(_METHODS, _ARGUMENTS):
    if _name in signature(getattr(System, _method)).parameters:
        _kind, _mentions = _ARGUMENTS[_name]

        @target(f"{_method}.{_name}", _kind, *_mentions)
        def _(v, method=_method, name=_name):
            return _called(method, **{name: v})


@target("inverse_dynamics.at", nothing("symbols", "texts", allowed=one_of("independent", None)))
def _(v):
    return world().c.system.inverse_dynamics(at=v)


@target("gravity.acceleration", nothing(allowed=one_of(None)))
def _(v):
    return world().o.system.gravity(acceleration=v)


@target("regressor.acceleration", nothing(allowed=one_of(None)))
def _(v):
    return world().o.system.regressor(acceleration=v)


@target("base_parameters.acceleration", nothing(allowed=one_of(None)))
def _(v):
    return world().o.system.base_parameters(None, None, None, acceleration=v)


for _method in ("frame_position", "frame_rotation", "frame_jacobian"):

    @target(f"{_method}.where", nothing("texts"))
    def _(v, method=_method):
        return getattr(world().o.system, method)(v)
