"""generate_ode_function, and the functions that it makes."""

from __future__ import annotations

from typing import Any

import sympy as sm

from fuzz.kinds import choice, nothing, real
from fuzz.table import STATE, empty_or_none, flags, hashable, is_number, key, one_of, target
from fuzz.world import world
from pydy.codegen.ode_function_generators import generate_ode_function


def _generated(**changes: Any) -> Any:
    o = world().o
    names = ("right_hand_side", "coordinates", "speeds", "constants")
    given = dict(zip(names, world().form, strict=True))
    rhs = generate_ode_function(**{**given, "specifieds": [o.f, o.g], **changes})
    return rhs([1.0, 2.0], 0.0, [0.0, 0.0], [1.0, 2.0])


def _entries(value: Any) -> list[Any] | None:
    """Return the entries of a value that may be a column of expressions."""
    if isinstance(value, (str, bytes, dict, set)):
        return None
    try:
        return list(value)
    except Exception:
        return None


def _column(value: Any) -> bool:
    """Whether a value is a column of numbers, or of time."""
    if isinstance(value, sm.MatrixBase) and 1 not in value.shape:
        return False
    entries = _entries(value)
    return entries is not None and all(is_number(e) or _time(e) for e in entries)


def _time(value: Any) -> bool:
    return isinstance(value, sm.Symbol) and value == sm.Symbol("t")


def _square(value: Any) -> bool:
    """Whether a value is a square matrix of numbers."""
    if value is None:
        return True
    if isinstance(value, sm.MatrixBase):
        return value.shape == (2, 2)
    rows = [_entries(row) for row in _entries(value) or ()]
    return len(rows) == 2 and all(r is not None and len(r) == 2 for r in rows)


_outside = ("no argument", "more than once", "`right_hand_side` must have")
_allowed = {
    "right_hand_side": _column,
    "coordinate_derivatives": one_of(None),
    "mass_matrix": _square,
    "specifieds": one_of(),
    "coordinates": one_of(),
    "speeds": one_of(),
    "constants": one_of(),
}
for _name, _right in _allowed.items():

    @target(
        f"generate_ode_function.{_name}",
        nothing("symbols", "texts", "arrays", allowed=_right),
        f"`{_name}",
        *_outside,
    )
    def _(v, name=_name):
        return _generated(**{name: v})


@target(
    "generate_ode_function.outputs",
    nothing("symbols", "texts", "arrays", allowed=lambda v: empty_or_none(v) or _column(v)),
    "outputs",
)
def _(v):
    return _generated(outputs=v)


@target(
    "generate_ode_function.linear_sys_solver",
    nothing("texts", allowed=lambda v: v is None or callable(v)),
)
def _(v):
    return _generated(linear_sys_solver=v)


@target(
    "generate_ode_function.linear_sys_solver[function]",
    nothing("functions", allowed=one_of(None)),
)
def _(v):
    o = world().o
    rhs = generate_ode_function(
        [o.v, -o.k * o.x],
        [o.x],
        [o.v],
        [o.k, o.m],
        mass_matrix=[[1, 0], [0, o.m]],
        linear_sys_solver=v,
    )
    return rhs([1.0, 2.0], 0.0, [1.0, 2.0])


for _name, _options in (
    ("constants_arg_type", (None, "array")),
    ("specifieds_arg_type", (None, "array")),
    ("generator", ("llvm", "lambdify")),
):

    @target(f"generate_ode_function.{_name}", choice(*_options))
    def _(v, name=_name):
        return _generated(**{name: v})


@target("generate_ode_function.time_first", flags)
def _(v):
    o = world().o
    rhs = generate_ode_function(*world().form, specifieds=[o.f, o.g], time_first=v)
    first = (0.0, [1.0, 2.0]) if v else ([1.0, 2.0], 0.0)
    return rhs(*first, [0.0, 0.0], [1.0, 2.0])


@target("generate_ode_function.cse", flags)
def _(v):
    return _generated(cse=v)


@target("generate_ode_function.option", nothing("texts"), "nonsense")
def _(v):
    return _generated(nonsense=v)


# -- the generated function -----------------------------------------------------------------------

for _generator in ("llvm", "lambdify"):

    @target(f"rhs_{_generator}.x", STATE)
    def _(v, generator=_generator):
        return world().made[generator](v, 0.0, [0.0, 0.0], [1.0, 2.0])

    @target(f"rhs_{_generator}.t", real(finite=False))
    def _(v, generator=_generator):
        return world().made[generator]([1.0, 2.0], v, [0.0, 0.0], [1.0, 2.0])

    @target(f"rhs_{_generator}.r", STATE, "`r", "specified")
    def _(v, generator=_generator):
        return world().made[generator]([1.0, 2.0], 0.0, v, [1.0, 2.0])

    @target(f"rhs_{_generator}.p", STATE)
    def _(v, generator=_generator):
        return world().made[generator]([1.0, 2.0], 0.0, [0.0, 0.0], v)

    @target(f"rhs_{_generator}.p[value]", real(finite=False))
    def _(v, generator=_generator):
        o = world().o
        return world().made[generator]([1.0, 2.0], 0.0, [0.0, 0.0], {o.k: 1.0, o.m: v})

    @target(f"rhs_{_generator}.r[value]", real(finite=False), "`r", "specified")
    def _(v, generator=_generator):
        o = world().o
        return world().made[generator]([1.0, 2.0], 0.0, {o.f: 1.0, o.g: v}, [1.0, 2.0])


@target("rhs_llvm.p[key]", key, "`p")
def _(v):
    return world().made["llvm"]([1.0, 2.0], 0.0, [0.0, 0.0], {world().o.k: 1.0, hashable(v): 1.0})


@target("rhs_llvm.r[function]", nothing("functions"), "`r", "specified")
def _(v):
    return world().made["llvm"]([1.0, 2.0], 0.0, v, [1.0, 2.0])
