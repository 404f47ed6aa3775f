"""Equilibria, orbits, sweeps, linear models and gradients of a System."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import sympy as sm
from sympy.physics.mechanics import dynamicsymbols

from fuzz.kinds import array, integer, nothing, real
from fuzz.table import (
    STATES,
    a_dictionary,
    empty_or_none,
    flags,
    hashable,
    is_number,
    key,
    mapping,
    number,
    one_of,
    target,
)
from fuzz.world import TIMES, driven, world
from pydy.system import System


def _no_entries(value: Any) -> bool:
    empty = isinstance(value, (list, tuple, set)) and not value
    return empty or (isinstance(value, np.ndarray) and not value.size)


@cache
def _oscillator() -> System:
    """The oscillator, which rests at x = 1/16."""
    return driven(world().o)


_RANGE = [2.0, 3.0]
_symbols = nothing("symbols", "texts", "arrays", allowed=one_of(None))
_moving = nothing("symbols", "texts", "arrays", allowed=_no_entries)
_names = nothing("symbols", "texts", "arrays", allowed=lambda v: v is None or _no_entries(v))
_given = mapping
_METHODS: dict[str, dict[str, Any]] = {
    "find_equilibrium": {"unknowns": _symbols, "given": _given, "moving": _moving},
    "follow_equilibria": {
        "over": nothing("symbols", "texts", "arrays"),
        "unknowns": _symbols,
        "given": _given,
        "moving": _moving,
        "step": real(above=0.0),
        "most": integer(1),
        "progress": flags,
    },
    "eigenvalues": {
        "over": nothing("symbols", "texts", "arrays"),
        "at": STATES.or_(a_dictionary).or_none(),
        "unknowns": _names,
        "given": _given,
        "moving": _moving,
        "progress": flags,
    },
}


def _analysed(method: str, **changes: Any) -> Any:
    usual = {} if method == "find_equilibrium" else {"over": {world().o.k: _RANGE}}
    found = getattr(_oscillator(), method)(**{**usual, **changes})
    return found.state if method == "find_equilibrium" else found.values


for _method, _arguments in _METHODS.items():
    for _name, _kind in _arguments.items():

        @target(f"{_method}.{_name}", _kind)
        def _(v, method=_method, name=_name):
            return _analysed(method, **{name: v})

    @target(f"{_method}.given[key]", key, "`given")
    def _(v, method=_method):
        return _analysed(method, given={hashable(v): 1.0})

    @target(f"{_method}.given[value]", number, "`given")
    def _(v, method=_method):
        return _analysed(method, given={world().o.f: v})


for _method in ("follow_equilibria", "eigenvalues"):

    @target(f"{_method}.over[key]", key, "`over")
    def _(v, method=_method):
        return _analysed(method, over={hashable(v): _RANGE})


def _one_way(values: np.ndarray) -> bool:
    steps = np.diff(values)
    return len(values) > 1 and bool(
        np.isfinite(values).all() and ((steps > 0).all() or (steps < 0).all())
    )


@target("eigenvalues.over[value]", array((None,), check=_one_way), "`over")
def _(v):
    return _analysed("eigenvalues", over={world().o.f: v})


@target("find_equilibrium.bounds", mapping)
def _(v):
    return _analysed("find_equilibrium", bounds=v)


@target("find_equilibrium.bounds[key]", key, "`bounds")
def _(v):
    return _analysed("find_equilibrium", bounds={hashable(v): (None, 1.0)})


_sides = array((2,), check=lambda a: a[0] < a[1])


# The equilibrium has no speed, and may lie outside.
@target("find_equilibrium.bounds[value]", _sides, "`bounds", "At a bound: v")
def _(v):
    return _analysed("find_equilibrium", bounds={world().o.v: v})


# -- orbits ---------------------------------------------------------------------------------------


@cache
def _driven_periodically() -> System:
    o = world().o
    force = sm.sin(dynamicsymbols._t) - o.v
    return driven(o, specifieds={o.f: force, o.g: 0.0}, ode_solver="dop853")


for _name, _kind in {
    "period": nothing("numbers", "texts"),  # but for multiples of 2 π
    "moving": _moving,
    "until": nothing("symbols", "texts", allowed=one_of(None)),
    "progress": flags,
}.items():

    @target(f"find_periodic_orbit.{_name}", _kind, f"`{_name}", "`max_steps`")
    def _(v, name=_name):
        options = {"period": 2 * np.pi, "rtol": 1e-6, "atol": 1e-6, "max_steps": 1000, name: v}
        return _driven_periodically().find_periodic_orbit(**options).period


# -- linear models --------------------------------------------------------------------------------

for _name, _kind in {
    "at": array((2,), (None, 2), check=lambda a: np.isfinite(a).all()).or_(a_dictionary).or_none(),
    "t": real(finite=False).or_none(),
    "inputs": _names,
    "outputs": _names,
}.items():

    @target(f"linearize.{_name}", _kind, f"`{_name}", "not finite at the state")
    def _(v, name=_name):
        found = world().o.system.linearize(**{"at": [1.0, 2.0], name: v})
        return found.A, found.B, found.C, found.D


# -- gradients ------------------------------------------------------------------------------------


def _known(value: Any) -> bool:
    """Whether a value is an expression without states: its gradient is zero."""
    return is_number(value) and not isinstance(value, list) and np.ndim(value) == 0


def _of_time(value: Any) -> bool:
    return value is None or _known(value) or any(value is one for one in (dynamicsymbols._t, sm.oo))


for _name, _kind in {
    "wrt": nothing("symbols", "texts", "arrays"),
    "final": nothing("symbols", "texts", "arrays", allowed=_of_time),
    "integral": nothing("symbols", "texts", "arrays", allowed=_of_time),
}.items():
    # An infinite integrand is met on the way.
    @target(f"adjoint_gradient.{_name}", _kind, f"`{_name}", "that are not finite")
    def _(v, name=_name):
        given = {"wrt": "states", "final": world().o.x, name: v}
        return world().o.native.adjoint_gradient(**given).values


def _ensemble(**changes: Any) -> Any:
    o = world().o
    given = {"initial_conditions": {o.x: [1.0, 2.0]}, "times": TIMES, **changes}
    return list(o.native.integrate_ensemble(**given))


@target("integrate_ensemble.sensitivities", nothing("symbols", "texts", allowed=empty_or_none))
def _(v):
    return _ensemble(sensitivities=v)


@target("integrate_ensemble.control_sensitivities", flags)
def _(v):
    return _ensemble(sensitivities=["k"], control_sensitivities=v)
