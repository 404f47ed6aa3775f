"""Plots of results."""

from __future__ import annotations

from typing import Any

from fuzz.families.optimal import fit_result
from fuzz.families.results import named_f
from fuzz.kinds import nothing, text
from fuzz.table import mapping, one_of, target
from fuzz.world import world
from pydy import plot


def _plotted(function: Any, *arguments: Any, **options: Any) -> Any:
    from matplotlib import pyplot

    try:
        return function(*arguments, **options)
    finally:
        pyplot.close("all")


for _name in ("coordinates", "speeds", "outputs", "states", "constraints", "energy"):

    @target(f"plot_{_name}.result", nothing("arrays"))
    def _(v, name=_name):
        return _plotted(getattr(plot, f"plot_{name}"), v)


@target("plot_fit.result", nothing("arrays"), "`result")
def _(v):
    return _plotted(plot.plot_fit, v)


@target("plot_fit.axes", nothing("texts", "arrays", allowed=one_of(None)), "`ax")
def _(v):
    return _plotted(plot.plot_fit, fit_result(), v)


_missing = "is not one of the trajectory's"


@target("plot.names", nothing("symbols", "texts", allowed=one_of(None)), "`names", _missing)
def _(v):
    return _plotted(plot.plot_coordinates, world().o.trajectory, v)


@target("plot.ax", nothing("texts", allowed=one_of(None)))
def _(v):
    return _plotted(plot.plot_coordinates, world().o.trajectory, ax=v)


@target("plot.axes", nothing("texts", "arrays", allowed=one_of(None)), "`ax")
def _(v):
    return _plotted(plot.plot_states, world().o.trajectory, axes=v)


@target("plot.units", mapping)
def _(v):
    return _plotted(plot.plot_coordinates, world().o.trajectory, units=v).get_ylabel()


@target("plot.units[value]", text())
def _(v):
    return _plotted(
        plot.plot_coordinates, world().o.trajectory, units={world().o.x: v}
    ).get_ylabel()


@target("plot.time_unit", text())
def _(v):
    return _plotted(plot.plot_coordinates, world().o.trajectory, time_unit=v).get_xlabel()


@target("plot.unit", text())
def _(v):
    return _plotted(plot.plot_energy, world().o.trajectory, unit=v).get_ylabel()


@target("plot.x", nothing("symbols", "texts", allowed=named_f), _missing, "`x`", "`y` must")
def _(v):
    return _plotted(plot.plot_phase, world().o.trajectory, v)


def _default_or_f(value: Any) -> bool:
    return value is None or named_f(value)


@target("plot.y", nothing("symbols", "texts", allowed=_default_or_f), _missing, "`y`")
def _(v):
    return _plotted(plot.plot_phase, world().o.trajectory, "x", v)
