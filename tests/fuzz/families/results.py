"""Sampled inputs, trajectories, sample models and linear models."""

from __future__ import annotations

import numpy as np

from fuzz.kinds import Kind, RefusedError, array, choice, integer, nothing
from fuzz.table import empty_or_none, flags, is_number, mapping, monotonic, one_of, target
from fuzz.values import HUGE
from fuzz.world import world
from pydy import linearize, models
from pydy.errors import IntegrationError
from pydy.inputs import SampledInput
from pydy.trajectory import Trajectory


def _ascend(t: np.ndarray) -> bool:
    return bool(np.isfinite(t).all() and (np.diff(t) > 0).all())


@target("SampledInput.times", array((2,), check=_ascend), "`times", "`values")
def _(v):
    return SampledInput(v, [1.0, 2.0])(0.75)


@target("SampledInput.values", array((2,), (2, None), check=lambda a: np.isfinite(a).all()))
def _(v):
    return SampledInput([0.0, 1.0], v)(0.75)


@target("SampledInput.interpolation", choice("linear", "previous", "pchip"))
def _(v):
    return SampledInput([0.0, 1.0], [1.0, 2.0], v)(0.75)


@target("SampledInput.t", array((), (None,)))
def _(v):
    return SampledInput([0.0, 1.0], [1.0, 2.0])(v)


# -- trajectories ---------------------------------------------------------------------------------


def named_f(value: object) -> bool:
    """Whether a value has the name of one of the trajectory's quantities."""
    return getattr(value, "name", getattr(value, "__name__", None)) == "f"


def named_f_or_no_names(value):
    return named_f(value) or (isinstance(value, list) and not value)


@target(
    "Trajectory.key",
    nothing("symbols", "texts", allowed=named_f_or_no_names),
    "is not one of the trajectory's",
    own=HUGE,
)
def _(v):
    return world().o.trajectory[v]


def _inside(t: np.ndarray) -> bool:
    return bool(monotonic(t) and ((t >= 0) & (t <= 1)).all())


def _after(t: np.ndarray) -> bool:
    whole = np.isfinite(t).all() and t.size > 0
    return bool(whole and (np.diff(t.ravel()) >= 0).all() and t.min() >= 1.0 and t.max() > 1.0)


@target(
    "Trajectory.continue_to.t",
    array((None,), check=_after).or_(array((), check=_after)),
    "`t`",
)
def _(v):
    try:
        return world().o.native.simulate(max_steps=200).continue_to(v).times
    except IntegrationError:  # years of it
        return None


@target(
    "at.times",
    array((None,), check=_inside).or_(array((), check=lambda t: bool(0 <= t <= 1))),
    "`times`",
)
def _(v):
    result = world().o.trajectory.at(v)
    return result.states, result.times


_FILES = ("abc", "damaged.nc", "empty.nc")


def _a_file(value: object) -> bool:
    return value == b"abc" if isinstance(value, bytes) else str(value) in _FILES


@target("Trajectory.save.path", nothing("paths", allowed=_a_file), "`path")
def _(v):
    return world().o.trajectory.save(v)


@target("load.path", nothing("paths"), "`path")
def _(v):
    return Trajectory.load(v)


for _name in ("derivatives", "energy"):

    @target(f"to_xarray.{_name}", flags)
    def _(v, name=_name):
        return list(world().o.trajectory.to_xarray(**{name: v}))


_one = {"coordinate": ["x"]}


@target(
    "Trajectory.times",
    array((2,), check=monotonic),
    "`times",
    "`states",
)
def _(v):
    return Trajectory(v, np.ones((2, 1)), _one).times


@target("Trajectory.states", array((2, 1)))
def _(v):
    return Trajectory([0.0, 1.0], v, _one).states


@target("Trajectory.specifieds", array((2, 1)))
def _(v):
    found = Trajectory([0.0, 1.0], np.ones((2, 1)), {**_one, "specified": ["f"]}, specifieds=v)
    return found.specifieds


_CALLABLE = nothing("texts", "symbols", allowed=lambda v: v is None or callable(v))
for _name, _kind in {
    "statistics": nothing("texts", "symbols", allowed=lambda v: isinstance(v, (dict, type(None)))),
    "model": nothing("texts", "symbols", "functions", allowed=one_of(None)),
    "dense": _CALLABLE,
    "sensitivities": nothing("texts", "symbols", "arrays", allowed=one_of(None)),
    "sensitivity_model": nothing("texts", "symbols", "functions", allowed=one_of(None)),
}.items():

    @target(f"Trajectory.{_name}", _kind)
    def _(v, name=_name):
        return len(Trajectory([0.0, 1.0], np.ones((2, 1)), _one, **{name: v}).times)


@target("Trajectory.outputs", array((2, 1)))
def _(v):
    return Trajectory([0.0, 1.0], np.ones((2, 1)), {**_one, "output": ["y"]}, outputs=v).outputs


@target("Trajectory.symbols", nothing("symbols", "texts", "arrays"), "`symbols", "`states")
def _(v):
    return Trajectory([0.0, 1.0], np.ones((2, 1)), v).names


def _numbers(value: object) -> object:
    """Return a dictionary of symbols or names, and numbers."""
    if empty_or_none(value):
        return {}
    if isinstance(value, dict) and all(map(is_number, value.values())):
        return {k: float(v) for k, v in value.items()}
    raise RefusedError


@target("Trajectory.constants", Kind(_numbers, mapping.groups))
def _(v):
    return Trajectory([0.0, 1.0], np.ones((2, 1)), _one, constants=v).constants


@target("Trajectory.events", nothing("symbols", "texts", allowed=empty_or_none))
def _(v):
    return Trajectory([0.0, 1.0], np.ones((2, 1)), _one, events=v).events


@target(
    "Trajectory.kinds",
    choice("coordinate", "speed", "auxiliary", "output", "constraint", "force", "specified"),
)
def _(v):
    return world().o.trajectory.names_of(v)


# -- models, linear algebra -----------------------------------------------------------------------


def _size(value: object) -> int:
    if type(value) is not int or not 1 <= value < 10**6:
        raise RefusedError
    return value


@target("multi_mass_spring_damper.n", Kind(_size, integer(1).groups), own={"2": lambda: 2})
def _(v):
    return models.multi_mass_spring_damper(v).num_states


for _name in ("apply_gravity", "apply_external_forces", "external_force_as_sin_of_t"):

    @target(f"multi_mass_spring_damper.{_name}", flags)
    def _(v, name=_name):
        system = models.multi_mass_spring_damper(1, **{name: v})
        return system.num_specifieds, system.num_constants


@target("n_link_pendulum_on_cart.n", Kind(_size, integer(1).groups), own={"2": lambda: 2})
def _(v):
    return models.n_link_pendulum_on_cart(v).num_states


for _name in ("cart_force", "joint_torques"):

    @target(f"n_link_pendulum_on_cart.{_name}", flags)
    def _(v, name=_name):
        return models.n_link_pendulum_on_cart(1, **{name: v}).num_specifieds


for _function in (linearize.reduce_state_matrix, linearize.constrained_eigenvalues):

    @target(
        f"{_function.__name__}.state_matrix",
        array((2, 2), check=lambda a: np.isfinite(a).all()),
    )
    def _(v, function=_function):
        return function(v, np.zeros((0, 2)))

    @target(
        f"{_function.__name__}.constraint_jacobian",
        array((None, 2), check=lambda a: np.isfinite(a).all()),
    )
    def _(v, function=_function):
        return function(np.eye(2), v)
