"""Plots of results."""

from __future__ import annotations

from functools import cache
from inspect import signature
from itertools import product
from typing import Any

import numpy as np

from fuzz.families.optimal import fit_result
from fuzz.families.results import named_f
from fuzz.kinds import Kind, array, choice, nothing, text
from fuzz.table import mapping, one_of, plotted, target
from fuzz.world import world
from pydy import plot


@cache
def _sensitive() -> Any:
    return world().o.native.simulate(sensitivities=["k"])


@cache
def _linear() -> Any:
    return world().o.system.linearize()


def _default_or_f(value: Any) -> bool:
    return value is None or named_f(value)


@target("plot_fit.result", nothing("arrays"), "`result")
def _(v):
    return plotted(plot.plot_fit, v)


@target("plot_fit.axes", nothing("texts", "arrays", allowed=one_of(None)), "`ax")
def _(v):
    return plotted(plot.plot_fit, fit_result(), v)


@target("plot_fit.units", mapping)
def _(v):
    plotted(plot.plot_fit, fit_result(), units=v)


@target("plot_fit.time_unit", text())
def _(v):
    plotted(plot.plot_fit, fit_result(), time_unit=v)


@cache
def _branch() -> Any:
    return world().o.system.follow_equilibria({"k": [1.0, 1.5]})


@target("EquilibriumBranch.plot.name", nothing("symbols", "texts"), "unknown")
def _(v):
    plotted(_branch().plot, v)


@target("EquilibriumBranch.plot.ax", nothing("texts", "arrays", allowed=one_of(None)), "`ax")
def _(v):
    plotted(_branch().plot, "x", v)


@target("EquilibriumBranch.plot.units", mapping)
def _(v):
    plotted(_branch().plot, "x", units=v)


_missing = "is not one of the trajectory's"
_axes = nothing("texts", "arrays", allowed=one_of(None))
_ARGUMENTS: dict[str, tuple[Kind, tuple[str, ...]]] = {
    "result": (nothing("arrays"), ()),
    "names": (nothing("symbols", "texts", allowed=one_of(None)), ("`names", _missing)),
    "ax": (nothing("texts", allowed=one_of(None)), ()),
    "axes": (_axes, ("`ax",)),
    "units": (mapping, ()),
    "unit": (text(), ()),
    "time_unit": (text(), ()),
    "x": (nothing("symbols", "texts", allowed=named_f), (_missing, "`x`", "`y` must")),
    "y": (nothing("symbols", "texts", allowed=_default_or_f), (_missing, "`y`")),
    "quantity": (nothing("symbols", "texts"), ("`quantity", _missing, "of the sensitivities")),
    "parameters": (
        nothing("symbols", "texts", allowed=one_of(None)),
        ("`parameters", "is not one of the parameters"),
    ),
}
_FUNCTIONS: dict[str, dict[str, Any]] = {
    "plot_coordinates": {},
    "plot_speeds": {},
    "plot_outputs": {},
    "plot_states": {},
    "plot_constraints": {},
    "plot_energy": {},
    "plot_phase": {"x": "x"},
    "plot_sensitivities": {"quantity": "x"},
}

for _function, _name in product(_FUNCTIONS, _ARGUMENTS):
    # The oscillator has neither outputs nor constraints.
    _known = ("result",) if _function in ("plot_outputs", "plot_constraints") else _ARGUMENTS
    if _name in signature(getattr(plot, _function)).parameters and _name in _known:
        _kind, _mentions = _ARGUMENTS[_name]

        @target(f"{_function}.{_name}", _kind, *_mentions)
        def _(v, function=_function, name=_name):
            usual = {"result": _sensitive(), **_FUNCTIONS[function], name: v}
            ax = plotted(getattr(plot, function), **usual)
            return [(one.get_xlabel(), one.get_ylabel()) for one in np.ravel(ax)]


@target("plot.units[value]", text())
def _(v):
    return plotted(plot.plot_coordinates, world().o.trajectory, units={world().o.x: v}).get_ylabel()


@target("plot.names", nothing("symbols", "texts", allowed=one_of(None)), "`names", _missing)
def _(v):
    return plotted(world().o.trajectory.plot, v)


# -- linear models --------------------------------------------------------------------------------

_frequencies = array((None,), check=lambda w: np.isfinite(w).all())


@target("LinearModel.frequency_response.frequencies", _frequencies)
def _(v):
    return _linear().frequency_response(v)


for _name, _kind in {
    "input": choice("f", "g"),
    "output": choice("x", "v"),
    "frequencies": array((None,), check=lambda w: (w >= 0).all() and (w < np.inf).all()).or_none(),
    "axes": _axes,
    "unit": choice("rad/s", "Hz"),
}.items():

    @target(f"LinearModel.plot_bode.{_name}", _kind)
    def _(v, name=_name):
        plotted(_linear().plot_bode, **{"input": "f", "output": "x", name: v})


@target("LinearModel.plot_poles.axes", nothing("texts", "arrays", allowed=one_of(None)), "`ax")
def _(v):
    return plotted(_linear().plot_poles, v)
