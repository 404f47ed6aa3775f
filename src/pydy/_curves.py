"""Curves from trajectories, ensembles, or several of them: what `pydy.plot` draws."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pydy._checks import check_mapping, listed, text
from pydy._dataset import STATES
from pydy._names import name_of
from pydy._optional import require

__all__ = [
    "Curve",
    "Units",
    "curves_of",
    "is_trajectory",
    "names_in",
    "nothing_to_plot",
    "rate_of",
    "runs_of",
    "samples_over_time",
    "typeset",
    "with_unit",
]

Units = Mapping[Any, str] | None


@dataclass(frozen=True)
class Curve:
    """One quantity over time: shape (m,), or (samples, m)."""

    name: str
    latex: str
    times: np.ndarray
    values: np.ndarray
    unit: str = ""
    run: str = ""  # the label of its result, where several are compared
    number: int = 0  # of that result

    @property
    def label(self) -> str:
        return with_unit(typeset(self.name, self.latex), self.unit)


def with_unit(label: str, unit: str) -> str:
    return f"{label} ({unit})" if unit else label


def typeset(name: str, latex: str) -> str:
    """Return a label that matplotlib's own mathematics can set, or the plain name."""
    if not latex:
        return name.replace("$", r"\$")
    parser = require("matplotlib.mathtext", "plot", "pydy.plot").MathTextParser("path")
    try:
        parser.parse(f"${latex}$")
    except ValueError:
        return name.replace("$", r"\$")
    return f"${latex}$"


def curves_of(
    result: Any,
    kinds: tuple[str, ...],
    what: str,
    names: Sequence[Any] | None,
    units: Units,
) -> list[Curve]:
    """Return the curves of some kinds, or those that are named."""
    known = units_of(units)
    if names is not None:
        names = listed("names", [names] if isinstance(names, str) else names, "symbols or names")
        if not names:
            raise ValueError("`names` is empty: there is nothing to plot. None means all.")
    curves = []
    for k, (label, run) in enumerate(runs_of(result)):
        chosen = names_in(run, kinds) if names is None else [name_in(run, name) for name in names]
        if not chosen:
            raise nothing_to_plot(what, run)
        for name in chosen:
            if is_trajectory(run):
                times, latex, values = run.times, run.latex(name), run[name]
            else:
                times, values = np.asarray(run["time"]), samples_over_time(run[name])
                latex = run[name].attrs.get("latex", "")
            curves.append(Curve(name, latex, times, values, known.get(name, ""), label, k))
    return curves


def runs_of(result: Any) -> list[tuple[str, Any]]:
    """Return what is to be drawn together, with labels; a single result has none."""
    if isinstance(result, (list, tuple)) and result:
        result = {f"run {k}": run for k, run in enumerate(result, 1)}
    if not isinstance(result, Mapping) or hasattr(result, "data_vars") or not result:
        check_result(result)
        return [("", result)]
    for run in result.values():
        check_result(run)
    return [(text(label, "a label in `result`"), run) for label, run in result.items()]


def is_trajectory(result: Any) -> bool:
    """Return whether a result is a Trajectory, which imports this module, and no Dataset."""
    return hasattr(result, "names_of")


def units_of(units: Units) -> dict[str, str]:
    given = check_mapping("units", units)
    return {
        spelled(key): text(unit, f"`units[{key}]`")
        for key, unit in given.items()
        for spelled in (str, name_of)
    }


def check_result(result: Any) -> None:
    if is_trajectory(result):
        return
    if not hasattr(result, "data_vars") or "time" not in result.dims:
        raise TypeError(
            "`result` must be a Trajectory, such as `system.simulate()` returns, an "
            "xarray.Dataset with the dimension 'time', or a list or dictionary of these, got "
            f"{type(result).__name__}."
        )


def names_in(result: Any, kinds: tuple[str, ...]) -> list[str]:
    check_result(result)
    if is_trajectory(result):
        return list(result.names_of(*kinds))
    return [n for n, v in result.data_vars.items() if v.attrs.get("role") in kinds]


def name_in(result: Any, key: Any) -> str:
    """Return the name under which the result holds a quantity."""
    if is_trajectory(result):
        return str(result.name(key))
    for name in (key if isinstance(key, str) else str(key), name_of(key)):
        if name in result.data_vars:
            return name
    raise KeyError(f"`{key}` is not one of the dataset's variables: {', '.join(result.data_vars)}.")


def samples_over_time(variable: Any) -> np.ndarray:
    """Return the values with all sample dimensions in one, before time."""
    table = np.asarray(variable.transpose(..., "time"))
    return table if table.ndim == 1 else table.reshape(-1, table.shape[-1])


def rate_of(result: Any, curve: Curve, units: Units) -> Curve:
    if is_trajectory(result):
        states = result.names_of(*STATES)
        if curve.name in states:
            values = result.derivatives[:, states.index(curve.name)]
            name = f"{curve.name}'"
            latex, unit = result.latex_of_rate(curve.name), units_of(units).get(name, "")
            return Curve(name, latex, curve.times, values, unit)
    elif f"{curve.name}'" in result.data_vars:
        return curves_of(result, (), "", [f"{curve.name}'"], units)[0]
    raise ValueError(
        f"`y` must be given, because the derivative of `{curve.name}` is not known: it is no state "
        "of a trajectory."
    )


def nothing_to_plot(what: str, result: Any) -> ValueError:
    if is_trajectory(result):
        return ValueError(f"`result` has no {what} to plot: {result!r}.")
    return ValueError(
        f"`result` has no variables whose attribute 'role' says that they are {what}; name what "
        f"to plot with `names`, of {', '.join(result.data_vars)}."
    )
