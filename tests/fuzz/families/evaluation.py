"""The evaluations of a System at states and times."""

from __future__ import annotations

from typing import Any

import numpy as np

from fuzz.kinds import Kind, RefusedError, array, choice, nothing, real
from fuzz.table import STATES, empty_or_none, flags, hashable, key, number, one_of, target
from fuzz.world import driven, world
from pydy.system import System


def _nothing_given(value: Any) -> Any:
    if isinstance(value, dict) and empty_or_none(value):
        return value
    raise RefusedError


_none = Kind(_nothing_given, ())


for _method in ("evaluate_ode", "evaluate_outputs", "evaluate_jacobian", "evaluate_energy"):

    @target(f"{_method}.x", STATES.or_(_none).or_none())
    def _(v, method=_method):
        # Without times there are zeros for any number of states.
        system = driven(world().o, times=None)
        result = getattr(system, method)(v)
        return tuple(result) if isinstance(result, tuple) else result


@target("evaluate_ode.t", real(finite=False).or_none())
def _(v):
    return world().o.system.evaluate_ode([1.0, 2.0], v)


@target("evaluate_ode.times", array((3,)).or_none(), "`t`")
def _(v):
    return world().o.system.evaluate_ode(np.ones((3, 2)), v)


_both = array((2,), (1, 2)).or_(_none).or_none()


@target("evaluate_ode.r", _both, "`r", "specified")
def _(v):
    return world().o.system.evaluate_ode([1.0, 2.0], 0.0, r=v)


@target("evaluate_ode.r[value]", real(finite=False), "`r", "specified")
def _(v):
    return world().o.system.evaluate_ode([1.0, 2.0], 0.0, r={world().o.f: v})


@target("evaluate_ode.r[key]", key, "`r")
def _(v):
    return world().o.system.evaluate_ode([1.0, 2.0], 0.0, r={hashable(v): 1.0})


@target("evaluate_ode.p", _both)
def _(v):
    return world().o.system.evaluate_ode([1.0, 2.0], 0.0, p=v)


@target("evaluate_ode.p[value]", number)
def _(v):
    return world().o.system.evaluate_ode([1.0, 2.0], 0.0, p={world().o.k: v})


@target("evaluate_ode.p[key]", key, "`p")
def _(v):
    return world().o.system.evaluate_ode([1.0, 2.0], 0.0, p={hashable(v): 1.0})


@target("evaluate_jacobian.wrt", choice("states", "specifieds", "constants"))
def _(v):
    return world().o.system.evaluate_jacobian(wrt=v)


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


for _method in ("constraints", "holonomic_constraints", "velocity_constraints"):

    @target(f"evaluate_{_method}.x", array((4,), (3, 4)).or_(_none).or_none())
    def _(v, method=_method):
        return getattr(world().c.system, f"evaluate_{method}")(v)


def _off_the_circle() -> System:
    c = world().c
    return System(c.kane, initial_conditions={c.x: 0.6, c.y: -0.7})


@target("set_dependent.dep_vars", nothing("symbols", "texts", allowed=one_of(None)))
def _(v):
    system = _off_the_circle()
    system.set_dependent_initial_conditions(v)
    return system.initial_conditions


@target("set_dependent.use_jac", flags)
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


@target("inverse_dynamics.q", array((1,), (None, 1)).or_(_none).or_none())
def _(v):
    return world().o.system.inverse_dynamics(v)


@target("inverse_dynamics.v", array((1,), (None, 1)).or_(_none).or_none())
def _(v):
    return world().o.system.inverse_dynamics(v=v)


@target("inverse_dynamics.a", array((1,), (None, 1)).or_(_none).or_none())
def _(v):
    return world().o.system.inverse_dynamics(a=v)


@target("bias.t", array((None,)).or_(real(finite=False)).or_none())
def _(v):
    return world().o.system.bias([1.0], [2.0], v)


@target("inverse_dynamics.at", nothing("symbols", "texts", allowed=one_of("independent", None)))
def _(v):
    return world().c.system.inverse_dynamics(at=v)


@target("mass_matrix.wrt", nothing("symbols", "texts", allowed=one_of(None)))
def _(v):
    return world().o.system.mass_matrix(wrt=v)


@target("gravity.acceleration", nothing(allowed=one_of(None)))
def _(v):
    return world().o.system.gravity(acceleration=v)


for _method in ("frame_position", "frame_rotation", "frame_jacobian"):

    @target(f"{_method}.where", nothing("texts"))
    def _(v, method=_method):
        return getattr(world().o.system, method)(v)


@target("equations_of_motion.short", flags)
def _(v):
    return str(world().o.system.equations_of_motion(v))


@target("regressor.a", array((1,), (None, 1)).or_(_none).or_none())
def _(v):
    return world().o.system.regressor(a=v)


@target("base_parameters.q", array((1,), (None, 1)).or_(_none).or_none())
def _(v):
    return world().o.system.base_parameters(v, [1.0], [2.0]).places
