"""Integrations: options of solvers, what they are called with, and events."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import sympy as sm

from fuzz.kinds import Kind, RefusedError, array, choice, integer, nothing, real, text
from fuzz.table import (
    empty_or_none,
    expression,
    flags,
    hashable,
    key,
    monotonic,
    one_of,
    target,
)
from fuzz.values import HUGE
from fuzz.world import TIMES, driven, world
from pydy.solvers import Event, Solver, dop853, radau, rk4

_positive = real(finite=False, above=0.0)
_finite = array((2,), check=lambda a: np.isfinite(a).all())
_tolerance = real(least=0.0).or_(
    array((2,), check=lambda a: (a >= 0).all() and np.isfinite(a).all())
)
_options = {
    "rtol": _tolerance,
    "atol": _tolerance,
    "first_step": _positive.or_none(),
    "max_step": _positive.or_none(),
    "max_steps": integer(1, floor=True),
}


def _first(result: Any) -> Any:
    return result[0] if isinstance(result, tuple) else result


def _ensemble(**options: Any) -> Any:
    o = world().o
    result = driven(o).integrate_ensemble(
        initial_conditions={o.x: [1.0, 2.0]}, times=TIMES, **options
    )
    return result.x.values, result.v.values


for _name, _kind in _options.items():

    @target(f"integrate.{_name}", _kind)
    def _(v, name=_name):
        return world().o.native.integrate(**{name: v})

    @target(f"dop853.{_name}", _kind)
    def _(v, name=_name):
        return dop853(world().plain, [1.0, 0.0], TIMES, **{name: v})

    @target(f"radau.{_name}", _kind)
    def _(v, name=_name):
        return radau(world().plain, [1.0, 0.0], TIMES, **{name: v})

    @target(f"integrate_ensemble.{_name}", _kind)
    def _(v, name=_name):
        return _ensemble(**{name: v})


@target("Solver.from_tableau.tableau", nothing("symbols", "texts", "functions"))
def _(v):
    return Solver.from_tableau(v)


@target("rk4.step", _positive)
def _(v):
    return rk4(world().plain, [1.0, 0.0], TIMES, step=v)


for _name in ("full_output", "progress", "dense_output"):

    @target(f"integrate.{_name}", flags)
    def _(v, name=_name):
        return _first(world().o.native.integrate(**{name: v}))

    @target(f"simulate.{_name}", flags)
    def _(v, name=_name):
        return world().o.native.simulate(**{name: v}).states

    @target(f"dop853.{_name}", flags)
    def _(v, name=_name):
        return _first(dop853(world().plain, [1.0, 0.0], TIMES, **{name: v}))


@target("integrate.events", nothing("symbols", "texts", allowed=empty_or_none))
def _(v):
    return world().o.native.integrate(events=v)


@target(
    "integrate.events[solve_ivp]", nothing("symbols", "texts", allowed=empty_or_none), "`events`"
)
def _(v):
    return driven(world().o, ode_solver="RK45").integrate(events=v)


@target(
    "integrate.t_eval",
    array(
        (None,), check=lambda t: monotonic(t) and t.size and t.min() >= 0 and t.max() <= 1
    ).or_none(),
    "`t_eval`",
)
def _(v):
    return driven(world().o, ode_solver="RK45").integrate(t_eval=v)


@target("simulate.sensitivities", nothing("symbols", "texts", allowed=one_of(None)))
def _(v):
    return world().o.native.simulate(sensitivities=v).states


@target("simulate.control_sensitivities", flags)
def _(v):
    found = world().o.native.simulate(sensitivities=["k"], control_sensitivities=v)
    return found.sensitivity.values


@target("integrate.constraints", choice(None, "project"))
def _(v):
    return world().c.system.integrate(constraints=v)


@target("integrate.gain", real(above=0.0, below=1e3), "`gain", "`max_steps`", own=HUGE)
def _(v):
    return world().c.system.integrate(constraints="baumgarte", gain=v, max_steps=1000)


for _solver in (dop853, radau):

    @target(f"{_solver.name}.f", nothing("functions", "symbols"), "`f`", "`f(")
    def _(v, solver=_solver):
        return solver(v, [1.0, 0.0], TIMES)


@target("dop853.f returns", _finite, "`f(", "not finite")
def _(v):
    return dop853(lambda x, t: v, [1.0, 0.0], [0.0, 1e-3], max_steps=1000)


@target("dop853.x0", array((), (None,), check=lambda a: np.isfinite(a).all()))
def _(v):
    return dop853(lambda x, t: [0.0] * len(x), v, TIMES)


@target("dop853.prepared x0", _finite, "`x0")
def _(v):
    return dop853.prepare(world().plain, [1.0, 0.0], TIMES)(v)


@target(
    "dop853.t",
    array((None,), check=lambda t: bool(len(t)) and monotonic(t)),
    "`t`",
)
def _(v):
    return dop853(world().plain, [1.0, 0.0], v, max_steps=1000)


@target("dop853.args", nothing("symbols", "texts", allowed=lambda v: True), "`args", "`f`")
def _(v):
    return dop853(lambda x, t, *_: -x, [1.0], TIMES, args=v)


_handed = {"[Event]": lambda: [Event(world().o.x)], "'project'": lambda: "project"}


for _name in ("events", "constraints"):

    @target(f"dop853.{_name}", nothing("texts", allowed=lambda v: v is None), own=_handed)
    def _(v, name=_name):
        return dop853(world().plain, [1.0, 0.0], TIMES, **{name: v})


# -- events ---------------------------------------------------------------------------------------


def _event(**changes: Any) -> Any:
    o = world().o
    given = {"expression": o.x - 0.5, "direction": 0, "name": "half", **changes}
    result = o.native.simulate(events=[Event(**given)])
    return [(e.time, e.name) for e in result.events], result.states


def _known(value: Any, constants: bool = False) -> Any:
    """Return an expression of time alone, or a number; or of constants that are met there first."""
    value = expression(value)
    time = sm.Symbol("t")
    if isinstance(value, sm.Basic) and (
        value.is_Relational
        or any(s != time and (s.name == "t" or not constants) for s in value.free_symbols)
        or value.is_finite is False
    ):
        raise RefusedError
    return value


_expressions = Kind(_known, ("common", "numbers", "symbols"), compare=False)
_resets = Kind(partial(_known, constants=True), _expressions.groups, compare=False)


@target("Event.expression", _expressions, "expression", "event")
def _(v):
    return _event(expression=v)


@target("Event.direction", choice(-1, 0, 1, groups=("common", "numbers", "texts")))
def _(v):
    return _event(direction=v)


@target("Event.terminal", flags)
def _(v):
    return _event(terminal=v)


@target("Event.reset", nothing("symbols", "texts", "arrays", allowed=empty_or_none), own=HUGE)
def _(v):
    return _event(reset=v)


@target("Event.reset[value]", _resets, "reset", "expression", own=HUGE)
def _(v):
    return _event(reset={world().o.v: v})


@target("Event.reset[key]", key, "`reset")
def _(v):
    return _event(reset={hashable(v): 0.0})


@target("Event.name", text())
def _(v):
    return _event(name=v)
