"""Axes of plots, the units at them, and names as labels."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from pydy._checks import check_mapping, listed, refuse_twice, shown, unit_and_factor
from pydy._names import label_parts, latex_of, name_of
from pydy._optional import require

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from pydy._sympy_types import BySymbol

Units: TypeAlias = "BySymbol[str | tuple[str, float]] | None"


def axes_of(ax: Axes | None, feature: str = "pydy.plot") -> Axes:
    """Return the given Axes, or those of a new figure."""
    if ax is None:
        pyplot = require("matplotlib.pyplot", "plot", feature)
        created: Axes = pyplot.subplots(layout="constrained")[1]
        return created
    if not hasattr(ax, "set_xlabel"):
        raise TypeError(f"`ax` must be Matplotlib Axes, got {shown(ax)}.")
    return ax


def rows_of_axes(
    axes: Any, count: int, description: str, feature: str = "a plot", **figure: object
) -> tuple[Any, list[Axes]]:
    """Return the given Axes, or those of a new figure in one column, and a list of them."""
    if axes is None:
        options = {"sharex": True, "squeeze": False, "layout": "constrained", **figure}
        axes = require("matplotlib.pyplot", "plot", feature).subplots(count, **options)[1][:, 0]
    flat = axes.ravel() if isinstance(axes, np.ndarray) else axes
    rows = [axes] if hasattr(axes, "set_xlabel") else [*listed("axes", flat, "Matplotlib Axes")]
    if len(rows) != count:
        raise ValueError(
            f"`axes` must be {count}, one for each {description}, got {len(rows)}. Pass "
            f"plt.subplots({count})[1], or leave it out."
        )
    for ax in rows:
        if not hasattr(ax, "set_xlabel"):
            raise TypeError(f"`axes` must be Matplotlib Axes, got {shown(ax)} among them.")
    return axes, rows


def legend_beside(ax: Axes, **options: Any) -> None:
    """Add a legend at the right of the curves if the figure's layout makes room, else over them."""
    if ax.figure.get_layout_engine() is not None:
        beside = {"loc": "upper left", "bbox_to_anchor": (1.0, 1.0), "frameon": False}
        options = {**beside, **options}
    ax.legend(**options)


def units_by_name(
    units: Units, states: Sequence[str], name_of_key: Callable[[Any], str] = name_of
) -> dict[str, tuple[str, float]]:
    """Return units and factors by name; those of `states` in degrees need their factor."""
    by_name, names = {}, []
    remedy = "Give each quantity its unit: `units={'q': 'm', 'u': 'm/s'}`."
    for key, unit in check_mapping("units", units, remedy, always=True).items():
        name = name_of_key(key)
        names.append(name)
        state = name if name.removesuffix("'") in states else ""
        by_name[name] = unit_and_factor(unit, f"units[{key}]", state)
    refuse_twice(names, "units")
    return by_name


def with_unit(label: str, unit: str) -> str:
    return f"{label} ({unit})" if unit else label


def typeset(name: str, latex: str) -> str:
    """Return a LaTeX label if matplotlib's mathtext can set it, otherwise the plain name."""
    if not latex and (len(name) == 1 or label_parts(name) != [name, ""]):
        latex = latex_of(name)
    if not latex:
        return name.replace("$", r"\$")
    parser = require("matplotlib.mathtext", "plot", "pydy.plot").MathTextParser("path")
    try:
        parser.parse(f"${latex}$")
    except ValueError:
        return name.replace("$", r"\$")
    return f"${latex}$"
