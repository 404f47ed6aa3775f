"""The evaluations of a System at states and times."""

from __future__ import annotations

from functools import cache
from inspect import signature
from itertools import product
from typing import Any

import numpy as np

from fuzz.kinds import Kind, array, choice, nothing, real
from fuzz.table import (
    STATES,
    a_dictionary,
    empty_or_none,
    flags,
    hashable,
    key,
    number,
    one_of,
    target,
)
from fuzz.world import driven, world
from pydy.system import System


@target("evaluate_ode.times", array((3,)).or_none(), "`t`")
def _(v):
    return world().o.system.evaluate_ode(np.ones((3, 2)), v)


_both = array((2,), (1, 2)).or_(a_dictionary).or_none()


@target("evaluate_ode.r[value]", real(finite=False), "`r", "specified")
def _(v):
    return world().o.system.evaluate_ode([1.0, 2.0], 0.0, r={world().o.f: v})


@target("evaluate_ode.r[key]", key, "`r")
def _(v):
    return world().o.system.evaluate_ode([1.0, 2.0], 0.0, r={hashable(v): 1.0})


@target("evaluate_ode.p[value]", number)
def _(v):
    return world().o.system.evaluate_ode([1.0, 2.0], 0.0, p={world().o.k: v})


@target("evaluate_ode.p[key]", key, "`p")
def _(v):
    return world().o.system.evaluate_ode([1.0, 2.0], 0.0, p={hashable(v): 1.0})


@cache
def _without_times() -> System:
    return driven(world().o, times=None)


_CALLS: dict[str, dict[str, Any]] = {
    "evaluate_ode": {},
    "evaluate_outputs": {},
    "evaluate_jacobian": {},
    "evaluate_energy": {},
    "evaluate_gradient": {"of": "x"},
    "evaluate_hessian_vector": {"v": [1.0, 0.0], "of": "x"},
    "evaluate_jacobian_vector": {"v": [1.0, 0.0]},
    "evaluate_vector_jacobian": {"v": [1.0, 0.0]},
}
_wrt = Kind(choice("states", "specifieds", "constants").read, ("common", "texts", "symbols"))
_arguments: dict[str, tuple[Kind, tuple[str, ...]]] = {
    "x": (STATES.or_(a_dictionary).or_none(), ()),
    "t": (real(finite=False).or_none(), ()),
    "r": (_both, ("`r", "specified")),
    "p": (_both, ()),
    "wrt": (_wrt, ()),
}

for _method, _name in product(_CALLS, _arguments):
    if _name in signature(getattr(System, _method)).parameters:
        _kind, _mentions = _arguments[_name]

        @target(f"{_method}.{_name}", _kind, *_mentions)
        def _(v, method=_method, name=_name):
            # Without times there are zeros for any number of states.
            system = _without_times() if name == "x" else world().o.system
            return getattr(system, method)(**{"x": [1.0, 2.0], **_CALLS[method], name: v})


@target("evaluate_jacobian.of", choice("ode", "outputs", "holonomic", "velocity"))
def _(v):
    return world().c.system.evaluate_jacobian(of=v)


@target("evaluate_gradient.of", nothing("symbols", "texts"), "`of`")
def _(v):
    return world().o.system.evaluate_gradient(v)


@target("evaluate_gradient.value", flags)
def _(v):
    return world().o.system.evaluate_gradient("x", value=v)


@target("evaluate_hessian_vector.of", nothing("symbols", "texts"), "`of`")
def _(v):
    return world().o.system.evaluate_hessian_vector([1.0, 0.0], v)


for _method in ("jacobian_vector", "vector_jacobian"):

    @target(f"evaluate_{_method}.v", array((2,), (2, None)))
    def _(v, method=_method):
        return getattr(world().o.system, f"evaluate_{method}")(v)

    # As many rows as expressions: that says `v`.
    @target(f"evaluate_{_method}.of", nothing("symbols", "texts"), "`of`", "`v`")
    def _(v, method=_method):
        return getattr(world().o.system, f"evaluate_{method}")([1.0, 0.0], of=v)


@target("evaluate_hessian_vector.v", array((2,), (2, None)))
def _(v):
    return world().o.system.evaluate_hessian_vector(v, "x")


for _method in ("constraints", "holonomic_constraints", "velocity_constraints"):

    @target(f"evaluate_{_method}.x", array((4,), (3, 4)).or_(a_dictionary).or_none())
    def _(v, method=_method):
        return getattr(world().c.system, f"evaluate_{method}")(v)


def _off_the_circle() -> System:
    c = world().c
    return System(c.kane, initial_conditions={c.x: 0.6, c.y: -0.7})


@target(
    "set_dependent_initial_conditions.dep_vars", nothing("symbols", "texts", allowed=one_of(None))
)
def _(v):
    system = _off_the_circle()
    system.set_dependent_initial_conditions(v)
    return system.initial_conditions


@target("set_dependent_initial_conditions.use_jac", flags)
def _(v):
    system = _off_the_circle()
    system.set_dependent_initial_conditions(use_jac=v)
    return list(system.initial_conditions.values())


def _reaction(**changes: Any) -> Any:
    o = world().o
    given = {"bodies": o.body, "point": o.P, **changes}
    found = o.system.reaction(given.pop("bodies"), given.pop("point"), **given)
    return len(found.outputs("a"))


def _default(value: Any) -> bool:
    return value is None


@target("reaction.bodies", nothing("symbols", "texts", "arrays"), "`bodies")
def _(v):
    return _reaction(bodies=v)


@target("reaction.point", nothing("symbols", "texts"), "`point")
def _(v):
    return _reaction(point=v)


@target("reaction.frame", nothing("symbols", "texts", allowed=_default), "`frame")
def _(v):
    return _reaction(frame=v)


def _no_loads(value: Any) -> bool:
    return empty_or_none(value) or (isinstance(value, np.ndarray) and not value.size)


@target("reaction.loads", nothing("symbols", "texts", "arrays", allowed=_no_loads), "load")
def _(v):
    return _reaction(loads=v)


@target("equations_of_motion.short", flags)
def _(v):
    return str(world().o.system.equations_of_motion(v))
