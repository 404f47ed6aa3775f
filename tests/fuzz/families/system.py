"""System: the constructor's arguments, and the attributes of their names."""

from __future__ import annotations

from typing import Any

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef

from fuzz.kinds import Kind, RefusedError, array, choice, nothing, real
from fuzz.table import (
    empty_or_none,
    expression,
    hashable,
    instants,
    is_number,
    key,
    mapping,
    number,
    target,
    two_instants,
)
from fuzz.world import driven, world
from pydy.system import System


@target("System.eom_method", key)
def _(v):
    return System(v)


def _outputs(value: Any) -> bool:
    """Whether a value names outputs."""
    return empty_or_none(value) or (
        isinstance(value, dict) and all(isinstance(name, (sm.Symbol, str)) for name in value)
    )


for _option in ("constants", "specifieds", "initial_conditions", "outputs"):
    _kind = mapping if _option != "outputs" else nothing(*mapping.groups[1:], allowed=_outputs)

    @target(f"System.{_option}=", _kind, f"`{_option}")
    def _(v, option=_option):
        return driven(world().o, **{option: v}).evaluate_ode()

    @target(f"System.set_{_option}", _kind, f"`{_option}")
    def _(v, option=_option):
        system = driven(world().o)
        setattr(system, option, v)
        return system.evaluate_ode()


def _number_or_expression(value: Any) -> Any:
    """Return what a specified can be: a number, or an expression of symbols."""
    if isinstance(value, sm.Expr) and value.free_symbols:
        return value
    return real().read(value)


for _option, _key in (("constants", "k"), ("initial_conditions", "x"), ("specifieds", "f")):
    _kind = number if _option != "specifieds" else Kind(_number_or_expression, number.groups)

    @target(f"System.{_option}[value]", _kind, f"`{_option}", "specified")
    def _(v, option=_option, key=_key):
        system = driven(world().o)
        setattr(system, option, {getattr(world().o, key): v})
        return system.evaluate_ode()

    @target(f"System.{_option}[edited]", _kind, f"`{_option}", "specified")
    def _(v, option=_option, key=_key):
        system = driven(world().o)
        getattr(system, option)[getattr(world().o, key)] = v
        return system.evaluate_ode()

    @target(f"System.{_option}[key]", key)
    def _(v, option=_option):
        system = driven(world().o)
        setattr(system, option, {hashable(v): 2.0})
        return system.evaluate_ode()


def _always(value: Any) -> Any:
    """Return a plain function for one that always gives the same number."""
    try:
        plain = value([1.0, 0.0], 0.0)
    except Exception as error:
        raise RefusedError from error
    constant = real().read(plain)
    return lambda x, t: constant


@target("System.specifieds[function]", Kind(_always, ("functions",)), "specified")
def _(v):
    system = driven(world().o)
    system.specifieds = {world().o.f: v}
    return system.integrate(), system.evaluate_ode(), system.evaluate_ode(r=system.specifieds)


@target("System.specifieds[native function]", Kind(_always, ("functions",)), "specified")
def _(v):
    system = driven(world().o, ode_solver="dop853")
    system.specifieds = {world().o.f: v}
    return system.integrate()


def _pair(value: Any) -> Any:
    """Return two numbers, one for both, or two expressions."""
    if is_number(value):
        return [real().read(value)] * 2
    if isinstance(value, list) and len(value) == 2:
        return [_number_or_expression(v) for v in value]
    return array((2,), check=lambda a: np.isfinite(a).all()).read(value)


@target("System.specifieds[pair]", Kind(_pair, ("common", "arrays")), "specifieds")
def _(v):
    system = driven(world().o)
    system.specifieds = {(world().o.f, world().o.g): v}
    return system.evaluate_ode(), system.integrate()


@target("System.specifieds['symbols']", nothing("symbols", "texts", "arrays"), "specifieds")
def _(v):
    system = driven(world().o)
    system.specifieds = {"symbols": v, "values": [1.0, 2.0]}
    return system.evaluate_ode()


@target("System.specifieds['values']", Kind(_pair, ("common", "arrays")), "specifieds")
def _(v):
    o = world().o
    system = driven(o)
    system.specifieds = {"symbols": (o.f, o.g), "values": v}
    return system.evaluate_ode()


@target("System.times=", instants.or_none())
def _(v):
    return driven(world().o, times=v).times


@target("System.set_times", instants.or_none(), "`times")
def _(v):
    system = driven(world().o)
    system.times = v
    return system.times


@target("System.set_times[integrate]", two_instants, "`times")
def _(v):
    system = driven(world().o)
    system.times = v
    return system.integrate()


def _new_name(value: Any) -> bool:
    """Whether a value may name an output."""
    if isinstance(value, tuple):
        return len(value) == 1 and _new_name(value[0])
    if isinstance(value, str):
        return bool(value)
    if isinstance(value, sm.Symbol):
        return value != sm.Symbol("t")
    return isinstance(value, AppliedUndef) and value.args == (sm.Symbol("t"),)


@target("System.outputs[key]", nothing("symbols", "texts", allowed=_new_name))
def _(v):
    system = driven(world().o)
    system.outputs = {hashable(v): world().o.x}
    return system.evaluate_outputs()


def _single(value: Any) -> Any:
    """Return an expression, or the one in a sequence."""
    if isinstance(value, (list, tuple, sm.MatrixBase)) and len(value) == 1:
        return expression(value[0])
    return expression(value)


@target(
    "System.outputs[value]",
    Kind(_single, ("common", "numbers", "symbols"), compare=False),
    "outputs",
    "The expressions hold",
)
def _(v):
    system = driven(world().o)
    system.outputs = {sm.Symbol("y"): v}
    return system.evaluate_outputs()


@target("System.noncontributing_forces=", nothing("symbols", "texts", allowed=empty_or_none))
def _(v):
    return driven(world().o, noncontributing_forces=v).evaluate_ode()


for _option in ("constants_symbols", "specifieds_symbols"):

    @target(
        f"System.{_option}=",
        nothing("symbols", "texts", allowed=lambda v: v is None),
        f"`{_option}",
        "no argument",  # that provides the symbols of the equations
    )
    def _(v, option=_option):
        return System(world().o.kane, **{option: v}).evaluate_ode()


@target("System.ode_solver=", choice(None, "odeint", "dop853"))
def _(v):
    return driven(world().o, ode_solver=v).integrate()


@target("System.ode_solver[function]", nothing("functions", allowed=lambda v: v is None))
def _(v):
    return driven(world().o, ode_solver=v).simulate().states


def _potential(value: Any) -> bool:
    return (
        value is None
        or is_number(value)
        or (isinstance(value, sm.Symbol) and value == sm.Symbol("t"))
    )


@target(
    "System.potential_energy",
    nothing("symbols", "numbers", "texts", allowed=_potential),
    "potential_energy",
    "the energy",
)
def _(v):
    system = driven(world().o)
    system.potential_energy = v
    return system.evaluate_energy()


@target("System.misspelt", nothing("texts"), "has no attribute")
def _(v):
    driven(world().o).initial_condition = v


for _name, _options in (
    ("constants_arg_type", (None, "array")),
    ("specifieds_arg_type", (None, "array")),
    ("generator", ("llvm", "lambdify")),
):

    @target(f"System.generate_ode_function.{_name}", choice(*_options))
    def _(v, name=_name):
        return driven(world().o).generate_ode_function(**{name: v})(
            [1.0, 2.0], 0.0, [0.0, 0.0], [1.0, 2.0]
        )
