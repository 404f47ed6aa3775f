"""Definitions of mechanisms, and functions of time that residuals give."""

from __future__ import annotations

from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import sympy as sm
from sympy.physics.mechanics import Particle, dynamicsymbols

from fuzz.kinds import Kind, RefusedError, choice, nothing, real
from fuzz.table import empty_or_none, hashable, is_number, key, mapping, target
from fuzz.world import driven, world
from pydy.mechanics import Definition, Implicit
from zoo import inertial_frame


@cache
def _pendulum() -> SimpleNamespace:
    """What defines a pendulum in Cartesian coordinates."""
    x, y, u, w, f = dynamicsymbols("x, y, u, w, f")
    m, r = sm.symbols("m, r")
    N, O = inertial_frame()
    P = O.locatenew("P", x * N.x + y * N.y)
    P.set_vel(N, u * N.x + w * N.y)
    given = {
        "frame": N,
        "coordinates": [x, y],
        "speeds": [u, w],
        "bodies": [Particle("bob", P, m)],
        "loads": [(P, -m * N.y)],
        "holonomic_constraints": [x**2 + y**2 - r**2],
    }
    return SimpleNamespace(**locals())


def _defined(**changes: Any) -> str:
    definition = Definition(**{**_pendulum().given, **changes})
    return repr((definition, definition.multibody.kinematics.coordinate_derivatives))


def _numbers_by_key(value: Any) -> bool:
    """Whether a value is a dictionary of numbers, of which those are taken that are needed."""
    return empty_or_none(value) or (
        isinstance(value, dict) and all(is_number(v) for v in value.values())
    )


def _no_entries(value: Any) -> bool:
    empty = isinstance(value, (list, tuple, set, frozenset)) and not value
    return empty or (isinstance(value, np.ndarray) and not value.size)


def _of_constants(value: Any) -> bool:
    """Whether a value lists symbols: conditions on constants, judged when these have numbers."""
    symbols = isinstance(value, list) and all(isinstance(v, sm.Symbol) for v in value)
    return symbols or _no_entries(value)


def _is_scalar(value: Any) -> bool:
    """Whether a value is None, a number or an expression; the power of the loads may differ."""
    scalar = isinstance(value, sm.Expr) and not value.is_number and not value.is_Matrix
    return value is None or is_number(value) or scalar


def _only_none(value: Any) -> bool:
    return value is None


_lists = ("symbols", "texts", "arrays")
_ARGUMENTS: dict[str, Kind] = {
    "frame": nothing("symbols", "texts"),
    "coordinates": nothing(*_lists),
    "speeds": nothing(*_lists, allowed=_only_none),
    "bodies": nothing(*_lists),
    "loads": nothing(*_lists, allowed=_no_entries),
    "kinematic_equations": nothing(*_lists, allowed=_only_none),
    "holonomic_constraints": nothing(*_lists, allowed=_of_constants),
    "nonholonomic_constraints": nothing(*_lists, allowed=_of_constants),
    "velocity_constraints": nothing(*_lists, allowed=lambda v: v is None or _of_constants(v)),
    "dependent_coordinates": nothing(*_lists, allowed=_only_none),
    "dependent_speeds": nothing(*_lists, allowed=_only_none),
    "auxiliary_speeds": nothing(*_lists, allowed=_no_entries),
    "configuration": mapping,
    "frames": mapping,
    "potential_energy": nothing(*_lists, allowed=_is_scalar),
    "values": nothing(*mapping.groups[1:], allowed=_numbers_by_key),
}
# What a message may say instead of the argument's name.
_OTHERWISE = {
    "coordinates": "0 coordinates",
    "speeds": "0 speeds",
    "loads": "The load ",
    **dict.fromkeys(
        ("holonomic_constraints", "nonholonomic_constraints", "velocity_constraints"),
        "The constraints ",
    ),
}

for _name, _kind in _ARGUMENTS.items():

    @target(f"Definition.{_name}", _kind, f"`{_name}", _OTHERWISE.get(_name, f"`{_name}"))
    def _(v, name=_name):
        return _defined(**{name: v})


for _name in ("configuration", "values"):

    @target(f"Definition.{_name}[value]", real())
    def _(v, name=_name):
        return _defined(**{name: {_pendulum().x: v}})


# -- functions of time that follow -----------------------------------------------------------------


def _joined(**changes: Any) -> str:
    z = _pendulum().f
    return repr(Implicit(**{"residuals": {z: z + 1}, **changes}).start)


def _residual(value: Any) -> Any:
    """Return an expression that holds the unknown; those tried here do not."""
    raise RefusedError


@target("Implicit.residuals", nothing("symbols", "texts", "arrays"))
def _(v):
    return _joined(residuals=v)


@target("Implicit.residuals[key]", key, "`residuals")
def _(v):
    return _joined(residuals={hashable(v): _pendulum().f})


@target("Implicit.residuals[value]", Kind(_residual, ("common", "symbols")), "`residuals")
def _(v):
    return _joined(residuals={_pendulum().f: v})


@target("Implicit.start", mapping)
def _(v):
    return _joined(start=v)


@target("Implicit.start[value]", real(), "`start")
def _(v):
    return _joined(start={_pendulum().f: v})


@target("System.implicit", nothing("symbols", "texts", allowed=_only_none))
def _(v):
    return driven(world().o, implicit=v).evaluate_ode()


@target("System.equations", choice(None, "graph", "method"))
def _(v):
    return driven(world().o, equations=v).evaluate_ode()
