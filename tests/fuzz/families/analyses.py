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
    key,
    mapping,
    number,
    one_of,
    target,
)
from fuzz.world import TIMES, driven, world
from pydy.system import System


def _no_entries(value: Any) -> bool:
    return isinstance(value, (list, tuple, set)) and not value


@cache
def _damped() -> System:
    """The oscillator with a load that grows with its stiffness, at rest at x = 1/16."""
    return driven(world().o)


_RANGE = [2.0, 3.0]
_symbols = nothing("symbols", "texts", "arrays", allowed=one_of(None))
_moving = nothing("symbols", "texts", "arrays", allowed=_no_entries)
_given = mapping
_METHODS: dict[str, dict[str, Any]] = {
    "find_equilibrium": {"unknowns": _symbols, "given": _given, "moving": _moving},
    "follow_equilibria": {
        "over": nothing("symbols", "texts", "arrays"),
        "unknowns": _symbols,
        "given": _given,
        "moving": _moving,
        "step": real(above=0.0, most=1.0),
        "most": integer(1),
        "progress": flags,
    },
    "eigenvalues": {
        "over": nothing("symbols", "texts", "arrays"),
        "at": STATES.or_(a_dictionary).or_none(),
        "unknowns": _symbols,
        "given": _given,
        "moving": _moving,
        "progress": flags,
    },
}


def _analysed(method: str, **changes: Any) -> Any:
    usual = {} if method == "find_equilibrium" else {"over": {world().o.k: _RANGE}}
    found = getattr(_damped(), method)(**{**usual, **changes})
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


@target("find_equilibrium.bounds[value]", array((2,), check=lambda a: a[0] < a[1]), "`bounds")
def _(v):
    return _analysed("find_equilibrium", bounds={world().o.v: v})


# -- orbits ---------------------------------------------------------------------------------------


@cache
def _driven_periodically() -> System:
    o = world().o
    return driven(o, specifieds={o.f: sm.sin(dynamicsymbols._t), o.g: 0.0}, ode_solver="dop853")


for _name, _kind in {
    "period": real(above=0.0, most=1e3),
    "moving": _moving,
    "until": nothing("symbols", "texts", allowed=one_of(None)),
    "progress": flags,
}.items():
    # Beyond the largest period the search needs more steps than it may take.
    @target(f"find_periodic_orbit.{_name}", _kind, f"`{_name}", "`max_steps`")
    def _(v, name=_name):
        options = {"period": 1.0, "rtol": 1e-6, "atol": 1e-6, "max_steps": 1000, name: v}
        return _driven_periodically().find_periodic_orbit(**options).period


# -- linear models --------------------------------------------------------------------------------

_names = nothing("symbols", "texts", "arrays", allowed=lambda v: v is None or _no_entries(v))
for _name, _kind in {
    "at": STATES.or_(a_dictionary).or_none(),
    "t": real().or_none(),
    "inputs": _names,
    "outputs": _names,
}.items():

    @target(f"linearize.{_name}", _kind)
    def _(v, name=_name):
        found = world().o.system.linearize(**{"at": [1.0, 2.0], name: v})
        return found.A, found.B, found.C, found.D


# -- gradients ------------------------------------------------------------------------------------

for _name, _kind in {
    "wrt": nothing("symbols", "texts", "arrays"),
    "final": nothing("symbols", "texts", "arrays"),
    "integral": nothing("symbols", "texts", "arrays", allowed=one_of(None)),
}.items():

    @target(f"adjoint_gradient.{_name}", _kind)
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
