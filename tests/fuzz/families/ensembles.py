"""System.integrate_ensemble; its solver's options are in `integration`."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from fuzz.kinds import Kind, RefusedError, array, choice, integer, nothing, text
from fuzz.table import (
    ascending_instants,
    empty_or_none,
    flags,
    hashable,
    key,
    mapping,
    number,
    target,
)
from fuzz.world import TIMES, driven, world


def _ensemble(**changes: Any) -> Any:
    o = world().o
    given = {"initial_conditions": {o.x: [1.0, 2.0]}, "times": TIMES, **changes}
    result = driven(o).integrate_ensemble(**given)
    return result.x.values, result.v.values


# A stiffness of 2**70 oscillates 10**10 times a second, and is right.
SHORT = 1e-3 * TIMES

_samples = array((None,), check=lambda a: len(a) and np.isfinite(a).all()).or_(number)

for _name, _key in (("initial_conditions", "x"), ("constants", "k"), ("specifieds", "f")):

    @target(f"integrate_ensemble.{_name}", mapping)
    def _(v, name=_name):
        return driven(world().o).integrate_ensemble(**{name: v}).x.values

    @target(f"integrate_ensemble.{_name}[value]", _samples, f"`{_name}", "specified")
    def _(v, name=_name, key=_key):
        given = {name: {getattr(world().o, key): v}, "times": SHORT}
        return driven(world().o).integrate_ensemble(**given).x.values

    @target(f"integrate_ensemble.{_name}[key]", key, f"`{_name}")
    def _(v, name=_name):
        return _ensemble(**{name: {hashable(v): [1.0, 2.0]}})


@target("integrate_ensemble.times", ascending_instants.or_none())
def _(v):
    return _ensemble(times=v)


@target("integrate_ensemble.ode_solver", choice(None, "dop853", "tsit5"))
def _(v):
    return _ensemble(ode_solver=v)


for _name in ("product", "progress"):

    @target(f"integrate_ensemble.{_name}", flags)
    def _(v, name=_name):
        return _ensemble(**{name: v})


def _no_resume(value: Any) -> bool:
    return isinstance(value, (bool, int, str, np.bool_)) and not value


@target("integrate_ensemble.resume", nothing("flags", "texts", allowed=_no_resume))
def _(v):
    return _ensemble(resume=v)


def _name_or_none(value: Any) -> bool:
    return isinstance(value, str) or _no_resume(value)


@target("integrate_ensemble.resume[functions]", nothing("flags", "texts", allowed=_name_or_none))
def _(v):
    store = Path(tempfile.mkdtemp(dir="."), "s.zarr")
    return _ensemble(reduce=lambda dataset: dataset, store=store, resume=v)


@target(
    "integrate_ensemble.reduce",
    nothing("texts", "symbols", "functions", allowed=empty_or_none),
)
def _(v):
    result = driven(world().o).integrate_ensemble(
        initial_conditions={world().o.x: [1.0, 2.0]}, reduce=v
    )
    return list(result)


def _no_sizes(value: Any) -> Any:
    if isinstance(value, dict) and not value:
        return value
    raise RefusedError


@target(
    "integrate_ensemble.chunks", integer(1).or_none().or_(choice("auto")).or_(Kind(_no_sizes, ()))
)
def _(v):
    return _ensemble(chunks=v)


_FOLDERS = ("abc", str(Path("no", "such", "folder", "file.nc")))


def _new_folder(value: Any) -> bool:
    return value is None or (isinstance(value, (str, Path)) and str(value) in _FOLDERS)


@target("integrate_ensemble.store", nothing("paths", allowed=_new_folder))
def _(v):
    return _ensemble(store=v)


@target("integrate_ensemble.workers", integer(1).or_none())
def _(v):
    return _ensemble(workers=min(v, 4) if type(v) is int and v < 2**60 else v)


@target("integrate_ensemble.units", mapping)
def _(v):
    return _ensemble(units=v)


@target("integrate_ensemble.units[value]", text())
def _(v):
    o = world().o
    result = driven(o).integrate_ensemble(initial_conditions={o.x: [1.0, 2.0]}, units={o.x: v})
    return result.x.attrs["units"]
