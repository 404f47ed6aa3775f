"""Optimal control and fits: problems, searches, phases and measured motions."""

from __future__ import annotations

from functools import cache
from inspect import signature
from typing import Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from fuzz.kinds import Kind, RefusedError, array, choice, integer, nothing, real, text
from fuzz.table import TARGETS, flags, hashable, is_number, key, mapping, one_of, plotted, target
from fuzz.values import HUGE
from fuzz.world import driven, world
from pydy.analysis import Trial
from pydy.control import OptimalControl
from pydy.inputs import SampledInput
from pydy.system import System


def _no_relations(value: Any) -> bool:
    empty = isinstance(value, (list, tuple, set)) and not value
    return empty or (isinstance(value, np.ndarray) and not value.size)


def _scalar(value: Any) -> bool:
    return is_number(value) and not isinstance(value, list) and np.ndim(value) == 0


def _no_values(value: Any) -> bool:
    return value is None or (isinstance(value, dict) and not value)


def _bound(value: Any) -> float:
    number = real(finite=False, most=1.79e308).read(value)
    if np.isnan(number):
        raise RefusedError
    return number


def _points(value: Any) -> int:
    number: int = integer(1).read(value)
    if number > 50:
        raise RefusedError
    return number


def _nodes(mesh: np.ndarray) -> bool:
    return len(mesh) > 1 and bool(np.isfinite(mesh).all() and (np.diff(mesh) > 0).all())


def _no_link(value: Any) -> bool:
    return value is None or (isinstance(value, dict) and not value)


def _no_links(value: Any) -> bool:
    return value is None or (isinstance(value, list) and len(value) == 1 and _no_link(value[0]))


def _refused_unless(holds: bool) -> int:
    if not holds:
        raise RefusedError
    return 1


_few = Kind(_points, integer(1).groups)
_low = Kind(_bound, ("common", "numbers")).or_none()
_samples = real().or_(array((None,), check=lambda a: len(a) > 0 and np.isfinite(a).all()))


def _optimal(guess: Any = None, **changes: Any) -> Any:
    """Return the bounds and the first iterate of a problem that is checked, not solved."""
    o = world().o
    given = {
        "objective": sm.Integral(o.f**2, me.dynamicsymbols._t),
        "duration": 1.0,
        "end": {o.x: 0.5},
        "mesh": 2,
        **changes,
    }
    system = driven(o, specifieds={o.g: given.pop("known", 0.125)})
    problem = OptimalControl(system, given.pop("objective"), given.pop("duration"), **given)
    program, z, _ = problem._combined_program([problem._mesh], [guess])
    return z, program.lower, program.upper


@target("OptimalControl.duration", real(above=0.0), "duration")
def _(v):
    return _optimal(duration=v)


@target("OptimalControl.objective", nothing("texts", "arrays", allowed=_scalar))
def _(v):
    return _optimal(objective=v)


# Bounds may change over the motion.
_low_over_time = array((None,), check=lambda a: len(a) > 1 and not np.isnan(a).any())

for _name in ("start", "end", "bounds"):

    @target(f"OptimalControl.{_name}", nothing("symbols", "arrays", allowed=_no_values), own=HUGE)
    def _(v, name=_name):
        return _optimal(**{name: v})

    @target(f"OptimalControl.{_name}[key]", key, f"`{_name}")
    def _(v, name=_name):
        return _optimal(**{name: {hashable(v): (None, 2.0)}})

    @target(
        f"OptimalControl.{_name}[value][0]",
        _low.or_(_low_over_time) if _name == "bounds" else _low,
        f"`{_name}",
        own=HUGE,
    )
    def _(v, name=_name):
        o = world().o
        return _optimal(**{name: {o.f if name == "bounds" else o.x: (v, None)}})


# Samples have to cover the longest duration.
@target("OptimalControl.bounds[duration][1]", real(least=0.5, most=1.0), "`bounds")
def _(v):
    tf = sm.Symbol("tf")
    samples = SampledInput([0.0, 1.0], [0.125, 0.25])
    return _optimal(guess={tf: 0.5}, duration=tf, bounds={tf: (0.5, v)}, known=samples)


@target(
    "OptimalControl.boundary",
    nothing("symbols", "texts", "arrays", allowed=_no_relations),
    own=HUGE,
)
def _(v):
    return _optimal(boundary=v)


@target(
    "OptimalControl.path",
    nothing("symbols", "texts", "arrays", allowed=lambda v: v is None or _no_relations(v)),
)
def _(v):
    return _optimal(path=v)


@target(
    "OptimalControl.free", nothing("symbols", "texts", "arrays", allowed=_no_relations), own=HUGE
)
def _(v):
    return _optimal(free=v)


@target("OptimalControl.mesh", array((None,), check=_nodes), own=HUGE)
def _(v):
    return _optimal(mesh=v)


@target("OptimalControl.method", choice("radau", "hermite-simpson", "midpoint", "backward-euler"))
def _(v):
    return _optimal(method=v)


@target("OptimalControl.order", _few)
def _(v):
    return _optimal(order=v)


@target("OptimalControl.guess", nothing("symbols", "arrays", allowed=_no_values), own=HUGE)
def _(v):
    return _optimal(guess=v)


@target("OptimalControl.guess[value]", _samples, "`guess", own=HUGE)
def _(v):
    return _optimal(guess={world().o.f: v})


@target("OptimalControl.hessian", choice("exact", "gauss-newton", "lbfgs"))
def _(v):
    return _optimal(hessian=v)


@target("OptimalControl.free[key]", key, "`free")
def _(v):
    return _optimal(free=[v])


# -- searches --------------------------------------------------------------------------------------


@cache
def _problem() -> Any:
    o = world().o
    effort = sm.Integral(o.f**2, me.dynamicsymbols._t)
    return OptimalControl(driven(o, specifieds={o.g: 0.125}), effort, 1.0, end={o.x: 0.5}, mesh=2)


@cache
def _found() -> Any:
    return _problem().solve()


@cache
def _phases() -> Any:
    return OptimalControl.phases([_problem()] * 2)


_PASSED = frozenset(signature(System.optimize_trajectory).parameters)
_ENDS = ("The search", "The optimizer")  # as a right value may, in 20 steps


def _solved(**options: Any) -> Any:
    found = _problem().solve(**options)
    return found.states, found.objective


_solver = choice("ipopt", "pounce")


def _count(value: Any) -> int:
    """Return what IPOPT takes for a count: whole numbers alone, not fractions like 2.0."""
    whole = isinstance(value, (int, np.integer)) and not isinstance(value, (bool, np.timedelta64))
    if not whole or not 0 <= value < 2**31:
        raise RefusedError
    return int(value)


_searches: dict[str, Kind] = {
    "mesh_tol": real(least=1.5e-14).or_none(),
    "progress": flags,
    "solver": _solver,
    "options": mapping,
    "guess": nothing("symbols", "arrays", allowed=_no_values),
}

for _name, _kind in _searches.items():

    @target(f"OptimalControl.solve.{_name}", _kind)
    def _(v, name=_name):
        return _solved(**{name: v})

    @target(f"OptimalControl.sweep.{_name}", _kind)
    def _(v, name=_name):
        return [one.objective for one in _problem().sweep({world().o.k: [2.0]}, **{name: v})]

    @target(f"Phases.solve.{_name}", _kind)
    def _(v, name=_name):
        return _phases().solve(**{name: v}).objective

    @target(f"Phases.sweep.{_name}", _kind)
    def _(v, name=_name):
        return [one.objective for one in _phases().sweep({world().o.k: [2.0]}, **{name: v})]


for _of, _make in {"OptimalControl": lambda: _problem(), "Phases": lambda: _phases()}.items():

    @target(f"{_of}.check.guess", nothing("symbols", "arrays", allowed=_no_values))
    def _(v, make=_make):
        return make().check(v)


@target("OptimalControl.system", nothing("symbols", "texts"))
def _(v):
    o = world().o
    return OptimalControl(v, sm.Integral(o.f**2, me.dynamicsymbols._t), 1.0)


for _name in ("plot_controls", "plot_states"):

    @target(f"OptimalTrajectory.{_name}.axes", nothing("texts", "arrays", allowed=one_of(None)))
    def _(v, name=_name):
        return plotted(getattr(_found(), name), v)

    @target(f"OptimalTrajectory.{_name}.units", mapping)
    def _(v, name=_name):
        plotted(getattr(_found(), name), units=v)

    @target(f"OptimalTrajectory.{_name}.time_unit", text())
    def _(v, name=_name):
        plotted(getattr(_found(), name), time_unit=v)


@target("OptimalControl.solve.options[key]", key, "`options")
def _(v):
    return _solved(options={hashable(v): 1})


@target("OptimalControl.solve.options[value]", Kind(_count, integer(0).groups), "`options")
def _(v):
    return _solved(options={"limited_memory_max_history": v})


@target("OptimalControl.sweep.values", mapping)
def _(v):
    return [found.objective for found in _problem().sweep(v)]


@target("OptimalControl.sweep.values[key]", key, "`values")
def _(v):
    return [found.objective for found in _problem().sweep({hashable(v): [1.0]})]


# -- phases ----------------------------------------------------------------------------------------


@target("OptimalControl.phases.problems", nothing("symbols", "texts", "arrays"))
def _(v):
    return OptimalControl.phases(v)


@target("OptimalControl.phases.problems[0]", nothing("symbols", "texts", "arrays"), "`problems")
def _(v):
    return OptimalControl.phases([v, _problem()])


@target("Phases.sweep.values", mapping)
def _(v):
    return [found.objective for found in OptimalControl.phases([_problem()] * 2).sweep(v)]


@target("Phases.sweep.values[key]", key, "`values")
def _(v):
    phases = OptimalControl.phases([_problem()] * 2)
    return [found.objective for found in phases.sweep({hashable(v): [1.0]})]


@target(
    "OptimalControl.phases.links",
    nothing("symbols", "texts", "arrays", allowed=_no_links),
)
def _(v):
    return OptimalControl.phases([_problem()] * 2, v)


@target(
    "OptimalControl.phases.links[0]",
    nothing("symbols", "texts", "arrays", allowed=_no_link),
    "`links",
)
def _(v):
    return OptimalControl.phases([_problem()] * 2, [v])


@target("OptimalControl.phases.links[0][key]", key, "`links")
def _(v):
    return OptimalControl.phases([_problem()] * 2, [{hashable(v): 0.0}])


@target(
    "OptimalControl.phases.links[0][value]",
    nothing("texts", "arrays", allowed=lambda v: v is None or _scalar(v)),
    "`links",
)
def _(v):
    return OptimalControl.phases([_problem()] * 2, [{world().o.v: v}])


# -- both in one call ------------------------------------------------------------------------------

# What becomes of the values is compared above: here they are handed on, and searched with.
for _one in [one for one in TARGETS if one.call.__module__ == __name__]:
    _owner, _, _name = _one.name.rpartition(".")
    if _owner in ("OptimalControl", "OptimalControl.solve") and _name in _PASSED:
        _kind = Kind(_one.kind.read, _one.kind.groups, compare=False)

        @target(f"optimize_trajectory.{_name}", _kind, *_one.mentions, *_ENDS)
        def _(v, name=_name):
            o = world().o
            given = {
                "objective": sm.Integral(o.f**2, me.dynamicsymbols._t),
                "duration": 1.0,
                "end": {o.x: 0.5},
                "mesh": 2,
                "options": {"max_iter": 20},
                name: v,
            }
            driven(o, specifieds={o.g: 0.125}).optimize_trajectory(**given)


# -- fits ------------------------------------------------------------------------------------------


@cache
def _measured() -> Any:
    o = world().o
    system = driven(o, specifieds={o.f: 0.5, o.g: 0.125}, ode_solver="dop853")
    system.constants = {o.k: 3.0, o.m: 1.0}
    system.times = np.linspace(0.0, 1.0, num=9)
    return system, system.times, system.simulate()[o.x]


def _fitted(trial: Any = None, **options: Any) -> Any:
    """Return the estimates of a fit, by collocation unless another method is asked for."""
    o = world().o
    system, times, values = _measured()
    given = {"times": times, "measured": {o.x: values}, "noise": 0.125, **(trial or {})}
    one = Trial(given.pop("times"), given.pop("measured"), **given)
    options = {"method": "collocation", **options}
    return system.fit(o.k, one, **options).estimates


@cache
def fit_result() -> Any:
    """Return the result of a fit."""
    system, times, values = _measured()
    return system.fit(world().o.k, Trial(times, {world().o.x: values}))


_share = real(above=0.0, below=1.0)


@target("FitResult.summary.level", _share, "`level")
def _(v):
    return fit_result().summary(v)


@target("FitResult.to_dataframe.level", _share, "`level")
def _(v):
    return fit_result().to_dataframe(v)["low"].to_numpy()


@target("fit.parameters", nothing("symbols", "texts", "arrays"), "`parameters")
def _(v):
    system, times, values = _measured()
    return system.fit(v, Trial(times, {world().o.x: values}))


@target("fit.trials", nothing("symbols", "texts", "arrays"), "`trials")
def _(v):
    return _measured()[0].fit([world().o.k], v)


for _name, _kind in {
    "method": choice("shooting", "collocation"),
    "solver": _solver.or_none(),
    "mesh": array((None,), check=_nodes).or_none(),
    "segments": Kind(lambda v: _refused_unless(integer(1).read(v) == 1), integer(1).groups),
    "most": integer(1),
    "progress": flags,
    "bounds": mapping,
    "priors": mapping,
    "process_noise": mapping,
}.items():

    @target(f"fit.{_name}", _kind)
    def _(v, name=_name):
        return _fitted(**{name: v})


_pairs = {
    "bounds": array((2,), check=lambda a: a[0] < a[1]),
    "priors": array((2,), check=lambda a: np.isfinite(a).all() and a[1] > 0.0),
}

for _name, _pair in {"bounds": (0.0, 9.0), "priors": (2.0, 1.0)}.items():

    @target(f"fit.{_name}[key]", key, f"`{_name}")
    def _(v, name=_name, pair=_pair):
        return _fitted(**{name: {hashable(v): pair}})

    @target(f"fit.{_name}[value]", _pairs[_name], f"`{_name}")
    def _(v, name=_name):
        return _fitted(**{name: {world().o.k: v}})


@target("fit.priors[value][1]", real(above=0.0), "`priors")
def _(v):
    return _fitted(priors={world().o.k: (2.0, v)})


@target("fit.process_noise[key]", key, "`process_noise")
def _(v):
    return _fitted(process_noise={hashable(v): 1.0})


@target("fit.process_noise[value]", real(above=0.0), "`process_noise", own=HUGE)
def _(v):
    return _fitted(process_noise={world().o.f: v})


@target("Trial.times", array((None,)), "`times", own=HUGE)
def _(v):
    return _fitted(trial={"times": v})


@target("Trial.measured", nothing("symbols", "texts", "arrays"), "`measured", own=HUGE)
def _(v):
    return _fitted(trial={"measured": v})


@target("Trial.start", real(most=0.0).or_none(), "`start", own=HUGE)
def _(v):
    return _fitted(trial={"start": v})


for _name, _kind in {
    "initial_conditions": mapping,
    "constants": mapping,
    "specifieds": mapping,
    "unknown": nothing("symbols", "texts", "arrays", allowed=_no_relations),
    "name": text(),
}.items():

    @target(f"Trial.{_name}", _kind, own=HUGE)
    def _(v, name=_name):
        return _fitted(trial={name: v})


@target("Trial.noise", real(above=0.0).or_none(), "`noise", "noise", own=HUGE)
def _(v):
    return _fitted(trial={"noise": v})
