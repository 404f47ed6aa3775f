"""Plots of trajectories and ensembles with matplotlib: one line each, labelled from the symbols.

Each function takes a `Trajectory`, or an `xarray.Dataset` with the dimension ``time`` and any
number of sample dimensions, for which it draws a line for each of a dozen samples, or of fewer, and
else the median and the band from the 5 % to the 95 % quantile. To compare several of these in one
plot, pass a list, or a dictionary that maps labels to results. A function draws into the given
Axes, or into a new figure, and returns the Axes. Curves whose `units` differ have an axis for each
unit: the first is that of the returned Axes, the others are at the right. To install matplotlib:
``pip install 'pydy[plot]'``.
"""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias

import numpy as np

from pydy._axes import (
    Units,
    axes_of,
    legend_beside,
    rows_of_axes,
    typeset,
    units_by_name,
    with_unit,
)
from pydy._checks import (
    listed,
    one_or_more,
    shown,
    text,
    unit_and_factor,
)
from pydy._dataset import ENERGIES, STATES
from pydy._interpolation import detailed
from pydy._names import name_of, some, text_of
from pydy._optional import require

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from xarray import DataArray, Dataset

    from pydy._sympy_types import SymbolOrName

__all__ = [
    "plot_constraints", "plot_coordinates", "plot_energy", "plot_fit", "plot_outputs",
    "plot_phase", "plot_quantities", "plot_sensitivities", "plot_speeds", "plot_states",
]  # fmt: skip
__dir__ = __all__.copy

# -- Curves from trajectories, ensembles, or several of them: what `pydy.plot` draws ---------------

SMOOTH = 400  # segments of a curve that looks smooth
NAMES = 3  # names that fit beside an axis of the usual height; with more, only the legend has them
# What is drawn: a trajectory (its module imports this one), a dataset, or several of these.
Run: TypeAlias = "NamedMotion | Dataset"
Results: TypeAlias = "Run | Sequence[Run] | Mapping[str, Run]"


class NamedMotion(Protocol):
    """The interface of a trajectory by which it is recognised."""

    @property
    def times(self) -> np.ndarray:
        """The times, shape (m,)."""

    def names_of(self, *kinds: str) -> tuple[str, ...]:
        """Return the names of the quantities of some kinds."""

    def __getitem__(self, key: SymbolOrName) -> np.ndarray:
        """Return the values of a quantity, shape (m,)."""


@dataclass(frozen=True)
class PlotCurve:
    """One quantity over time: shape (m,), or (samples, m)."""

    name: str
    latex: str
    times: np.ndarray
    values: np.ndarray
    unit: str = ""
    run: str = ""  # the label of its result, where several are compared
    number: int = 0  # index of that result

    @property
    def label(self) -> str:
        return with_unit(typeset(self.name, self.latex), self.unit)


def curves_of(
    result: object,
    kinds: tuple[str, ...],
    description: str,
    names: Sequence[SymbolOrName] | None,
    units: Units,
) -> list[PlotCurve]:
    """Return the curves of some kinds or names."""
    if names is not None:
        names = listed("names", [names] if isinstance(names, str) else names, "symbols or names")
        if not names:
            raise ValueError("`names` is empty: there is nothing to plot. None means all.")
    curves = []
    for k, (label, run) in enumerate(runs_of(result)):
        chosen = names_in(run, kinds) if names is None else [name_in(run, name) for name in names]
        if not chosen:
            raise nothing_to_plot(description, run)
        units_by_name = units_of(run, units)
        for name in chosen:
            if is_trajectory(run):
                times, latex, values = run.times, run.latex(name), run[name]
            else:
                times, values = np.asarray(run["time"]), samples_over_time(run[name])
                latex = run[name].attrs.get("latex", "")
            unit, factor = units_by_name.get(name, ("", 1.0))
            curves.append(PlotCurve(name, latex, times, values * factor, unit, label, k))
    return curves


def runs_of(result: object) -> list[tuple[str, Any]]:
    """List the results to draw together, with labels; a single one has none.

    Trajectories with dense output get enough times for smooth curves, and both sides of events.
    """
    if isinstance(result, (list, tuple)) and result:
        result = {f"run {k}": run for k, run in enumerate(result, 1)}
    if not isinstance(result, Mapping) or hasattr(result, "data_vars") or not result:
        check_result(result)
        return [("", _smooth(result))]
    for run in result.values():
        check_result(run)
    return [(text(label, "a label in `result`"), _smooth(run)) for label, run in result.items()]


def _smooth(run: Any) -> object:
    return detailed(run, lambda span: span / SMOOTH)


def is_trajectory(result: object) -> bool:
    """Return whether a result is a Trajectory; its module imports this one, so no isinstance."""
    return hasattr(result, "names_of")


def units_of(result: object, units: Units) -> dict[str, tuple[str, float]]:
    """Return units and factors by the names in a result; other keys, such as rates, stay."""

    def name_of_key(key: SymbolOrName) -> str:
        try:
            return name_in(result, key)
        except KeyError:
            return name_of(key)

    return units_by_name(units, names_in(result, STATES), name_of_key)


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


def name_in(result: Any, key: SymbolOrName) -> str:
    """Return the name under which the result holds a quantity."""
    if is_trajectory(result):
        return str(result.name(key))
    for name in (key if isinstance(key, str) else str(key), name_of(key)):
        if name in result.data_vars:
            return name
    raise KeyError(
        f"`{text_of(key)}` is not one of the dataset's variables: {some(result.data_vars)}."
    )


def samples_over_time(variable: DataArray) -> np.ndarray:
    """Return the values with all sample dimensions in one, before time."""
    table = np.asarray(variable.transpose(..., "time"))
    return table if table.ndim == 1 else table.reshape(-1, table.shape[-1])


def rate_of(result: Any, curve: PlotCurve, units: Units) -> PlotCurve:
    if is_trajectory(result):
        states = result.names_of(*STATES)
        if curve.name in states:
            values = result.derivatives[:, states.index(curve.name)]
            name = f"{curve.name}'"
            unit, factor = units_of(result, units).get(name, ("", 1.0))
            latex = result.latex_of_rate(curve.name)
            return PlotCurve(name, latex, curve.times, values * factor, unit)
    elif f"{curve.name}'" in result.data_vars:
        return curves_of(result, (), "", [f"{curve.name}'"], units)[0]
    raise ValueError(
        f"`y` must be given, because the derivative of `{curve.name}` is not known: it is no state "
        "of a trajectory."
    )


def nothing_to_plot(description: str, result: Any) -> ValueError:
    if is_trajectory(result):
        return ValueError(f"`result` has no {description} to plot: {result!r}.")
    return ValueError(
        f"`result` has no variables whose attribute 'role' says that they are {description}; name "
        f"what to plot with `names`, of {some(result.data_vars)}."
    )


# -- Plots -----------------------------------------------------------------------------------------

BAND = (0.05, 0.5, 0.95)
LINES_OF_SAMPLES = 12  # of more samples a band is drawn
LINES = ("solid", "dashed", "dotted", "dashdot")
AXIS_SPACING = 8.0  # distance between the axes of further units, in points


# -- public ---------------------------------------------------------------------------------------


def plot_coordinates(
    result: Results,
    names: Sequence[SymbolOrName] | None = None,
    *,
    ax: Axes | None = None,
    units: Units = None,
    time_unit: str = "",
) -> Axes:
    """Plot the generalized coordinates over time.

    Parameters
    ----------
    result : Trajectory, xarray.Dataset, or a list or dictionary of these
        Several are drawn together; a dictionary gives each its label.
    names : sequence of symbols or str, optional
        Which ones; all by default.
    ax : matplotlib Axes, optional
        Where to draw; a new figure by default.
    units : mapping of symbols or str to str or (str, float), optional
        Units to show with the labels; symbols that are not plotted are ignored. Where they differ,
        each unit has an axis of its own. Values are not converted unless the unit comes with the
        factor to multiply them by: ``('mm', 1000)``, ``('deg', 180/np.pi)``.
    time_unit : str, optional
        Unit to show with the time.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ImportError
        matplotlib is not installed.
    KeyError, ValueError
        The result has no quantity of that name, or there is nothing to plot.

    Examples
    --------
    >>> import numpy as np
    >>> from pydy.models import multi_mass_spring_damper
    >>> from pydy.plot import plot_coordinates
    >>> system = multi_mass_spring_damper(2)
    >>> x0, x1 = system.coordinates
    >>> system.initial_conditions = {x0: 1.0}
    >>> system.times = np.linspace(0.0, 10.0, num=201)
    >>> ax = plot_coordinates(system.simulate(), units={x0: 'm', x1: 'm'}, time_unit='s')
    >>> ax.get_xlabel(), ax.get_ylabel()
    ('time (s)', 'coordinates (m)')

    Two units have two axes:

    >>> ax = plot_coordinates(system.simulate(), units={x0: 'm', x1: 'mm'})
    >>> [one.get_ylabel() for one in ax.figure.axes]
    ['coordinates (m)', 'coordinates (mm)']

    Two runs in one plot:

    >>> soft = system.simulate()
    >>> system.constants = {'k0': 4.0}
    >>> ax = plot_coordinates({'soft': soft, 'stiff': system.simulate()}, ['x0'])
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['soft', 'stiff']
    """
    return _plot(result, ("coordinate",), "coordinates", names, ax, units, time_unit)


def plot_speeds(
    result: Results,
    names: Sequence[SymbolOrName] | None = None,
    *,
    ax: Axes | None = None,
    units: Units = None,
    time_unit: str = "",
) -> Axes:
    """Plot the generalized speeds over time; the parameters are those of `plot_coordinates`."""
    return _plot(result, ("speed",), "speeds", names, ax, units, time_unit)


def plot_outputs(
    result: Results,
    names: Sequence[SymbolOrName] | None = None,
    *,
    ax: Axes | None = None,
    units: Units = None,
    time_unit: str = "",
) -> Axes:
    """Plot outputs and noncontributing forces over time.

    The parameters are those of `plot_coordinates`. The residuals of constraints, which are also
    outputs, have a separate plot.
    """
    return _plot(result, ("output", "force"), "outputs", names, ax, units, time_unit)


def plot_quantities(
    result: Results,
    names: Sequence[SymbolOrName],
    *,
    ax: Axes | None = None,
    units: Units = None,
    time_unit: str = "",
) -> Axes:
    """Plot quantities of any kind over time: states, outputs, specifieds.

    The parameters are those of `plot_coordinates`.
    """
    return _draw(ax, curves_of(result, (), "values", names, units), "", time_unit)


def plot_sensitivities(
    result: NamedMotion,
    quantity: SymbolOrName,
    parameters: SymbolOrName | Sequence[SymbolOrName] | None = None,
    *,
    ax: Axes | None = None,
    units: Units = None,
    time_unit: str = "",
) -> Axes:
    """Plot the derivatives of a state or output with respect to parameters over time.

    Parameters
    ----------
    result : Trajectory
        Simulated with sensitivities.
    quantity : symbol or str
    parameters : sequence of symbols or str, optional
        Which ones; all by default.
    ax, time_unit
        As for `plot_coordinates`.
    units : mapping of symbols or str to str, optional
        Units of the quantity and of the parameters. Derivatives are shown with their quotient, and
        have an axis for each; by default all are drawn on one, each in a unit of its own.

    Returns
    -------
    matplotlib Axes

    Examples
    --------
    >>> from pydy.models import multi_mass_spring_damper
    >>> from pydy.plot import plot_sensitivities
    >>> system = multi_mass_spring_damper()
    >>> system.times, system.initial_conditions = [0.0, 0.5, 1.0], {'x0': 1.0}
    >>> plot_sensitivities(system.simulate(sensitivities=['m0', 'k0']), 'x0').get_ylabel()
    'derivatives of x0'
    """
    ((_, trajectory),) = runs_of(result)
    sensitivity, name = trajectory.sensitivity, trajectory.name(quantity)
    names = sensitivity.names
    if parameters is not None:
        names = [name_of(parameter) for parameter in one_or_more("parameters", parameters)]
        if not names:
            raise ValueError("`parameters` is empty: there is nothing to plot. None means all.")
    units_by_name = units_of(trajectory, units)
    curves = []
    for parameter in names:
        unit, factor = _quotient(units_by_name, name, parameter)
        values = sensitivity[quantity, parameter] * factor
        curves.append(PlotCurve(parameter, "", trajectory.times, values, unit))
    title = f"derivatives of {name} with respect to"
    return _draw(ax, curves, f"derivatives of {name}", time_unit, title)


def _quotient(units: dict[str, tuple[str, float]], name: str, parameter: str) -> tuple[str, float]:
    """Return unit and factor of a derivative; of several columns, they are ``F[0]``, ``F[1]``."""
    none = ("", 1.0)
    above, by = units.get(name, none)
    below, through = units.get(parameter, units.get(parameter.partition("[")[0], none))
    if not (above and below):
        return none
    return f"{above}/{below}" if below.isalnum() else f"{above}/({below})", by / through


def plot_states(
    result: Results,
    *,
    axes: np.ndarray | Sequence[Axes] | None = None,
    units: Units = None,
    time_unit: str = "",
) -> np.ndarray:
    """Plot all states over a shared time axis: coordinates, speeds, and auxiliary states if any.

    Parameters
    ----------
    result : Trajectory, xarray.Dataset, or a list or dictionary of these
    axes : sequence of matplotlib Axes, optional
        One for each of these kinds; a new figure's by default.
    units, time_unit
        As for `plot_coordinates`.

    Returns
    -------
    ndarray of matplotlib Axes, shape (k,)
    """
    titles = dict(zip(STATES, ("coordinates", "speeds", "auxiliary states"), strict=True))
    result = dict(runs_of(result))
    runs = [*result.values()]
    kinds = [kind for kind in STATES if all(names_in(run, (kind,)) for run in runs)]
    if not kinds:
        raise nothing_to_plot("states", runs[0])
    size = (6.4, 1.0 + 2.2 * len(kinds))
    description = f"of {', '.join(kinds)}"
    _, rows = rows_of_axes(axes, len(kinds), description, "pydy.plot", figsize=size)
    for ax, kind in zip(rows, kinds, strict=True):
        _plot(result, (kind,), titles[kind], None, ax, units, time_unit)
    for ax in rows[:-1]:
        ax.set_xlabel("")
    return np.array(rows)


def plot_constraints(
    result: Results,
    names: Sequence[SymbolOrName] | None = None,
    *,
    ax: Axes | None = None,
    time_unit: str = "",
) -> Axes:
    """Plot the magnitudes of the constraint residuals on a logarithmic scale.

    The parameters are those of `plot_coordinates`. Residuals that are zero are not drawn.
    """
    sizes = [
        replace(curve, values=np.where(curve.values == 0.0, np.nan, np.abs(curve.values)))
        for curve in curves_of(result, ("constraint",), "constraints", names, None)
    ]
    ax = _draw(ax, sizes, "absolute residuals", time_unit)
    ax.set_yscale("log")
    return ax


def plot_energy(
    result: Results,
    *,
    ax: Axes | None = None,
    unit: str | tuple[str, float] = "",
    time_unit: str = "",
) -> Axes:
    """Plot the kinetic, the potential and the total energy over time.

    Parameters
    ----------
    result : Trajectory, xarray.Dataset, or a list or dictionary of these
        A Dataset must have the variables 'kinetic_energy', 'potential_energy' and 'total_energy',
        as ``trajectory.to_xarray(energy=True)`` gives them.
    ax : matplotlib Axes, optional
    unit : str or (str, float), optional
        Unit to show, or the unit and the factor that the energies are multiplied by:
        ``('kJ', 1e-3)``.
    time_unit : str, optional

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ValueError
        The energies are not known; see `System.evaluate_energy`.
    """
    label_of_unit, factor = unit_and_factor(unit, "unit")
    curves = []
    for k, (label, run) in enumerate(runs_of(result)):
        times, table = _energies(run)
        curves += [
            PlotCurve(
                name.removesuffix("_energy"), "", times, factor * values, label_of_unit, label, k
            )
            for name, values in table.items()
        ]
    return _draw(ax, curves, "energy", time_unit)


def _energies(result: Any) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    if is_trajectory(result):
        return result.times, dict(zip(ENERGIES, result.energy.T, strict=True))
    missing = [name for name in ENERGIES if name not in result.variables]
    if missing:
        raise ValueError(
            f"`result` must have the variables {', '.join(ENERGIES)}; {missing[0]} is missing. "
            "Name outputs like that, or use `trajectory.to_xarray(energy=True)`."
        )
    return np.asarray(result["time"]), {name: samples_over_time(result[name]) for name in ENERGIES}


def plot_phase(
    result: Results,
    x: SymbolOrName,
    y: SymbolOrName | None = None,
    *,
    ax: Axes | None = None,
    units: Units = None,
) -> Axes:
    """Plot one quantity over another, such as a coordinate's rate over the coordinate.

    Dots mark the initial states. For an ensemble, at most a hundred evenly spaced motions are
    drawn.

    Parameters
    ----------
    result : Trajectory, xarray.Dataset, or a list or dictionary of these
    x : symbol or str
    y : symbol or str, optional
        By default the derivative of `x`, which must then be a state.
    ax : matplotlib Axes, optional
    units : mapping of symbols or str to str, optional
        The name of the derivative of ``q1`` is ``"q1'"``.

    Returns
    -------
    matplotlib Axes
    """
    runs = runs_of(result)
    orbits = []
    for _, run in runs:
        (horizontal,) = curves_of(run, (), "quantities", [x], units)
        orbits.append(
            (
                horizontal,
                rate_of(run, horizontal, units)
                if y is None
                else curves_of(run, (), "", [y], units)[0],
            )
        )
    ax = axes_of(ax)
    for (label, _), (horizontal, vertical) in zip(runs, orbits, strict=True):
        a, b = np.broadcast_arrays(np.atleast_2d(horizontal.values), np.atleast_2d(vertical.values))
        step = -(-len(a) // 100)
        a, b = a[::step], b[::step]
        faint: dict[str, Any] = {"alpha": 0.4, "linewidth": 0.8} if len(a) > 1 else {}
        first, *_ = ax.plot(a.T, b.T, color=_next_colour(ax), **faint)
        first.set_label(label)
        ax.plot(
            a[:, 0], b[:, 0], color=first.get_color(), linestyle="none", marker="o", markersize=4
        )
    ax.set_xlabel(horizontal.label)
    ax.set_ylabel(vertical.label)
    ax.grid(alpha=0.3)
    if len(runs) > 1:
        ax.legend()
    return ax


# -- drawing --------------------------------------------------------------------------------------


def _plot(
    result: object,
    kinds: tuple[str, ...],
    description: str,
    names: Sequence[SymbolOrName] | None,
    ax: Axes | None,
    units: Units,
    time_unit: str,
) -> Axes:
    return _draw(ax, curves_of(result, kinds, description, names, units), description, time_unit)


def _draw(
    ax: Axes | None, curves: Sequence[PlotCurve], description: str, time_unit: str, title: str = ""
) -> Axes:
    """Draw curves over time; the label of an axis is the description, or names its curves."""
    ax = axes_of(ax)
    time_label = with_unit("time", text(time_unit, "`time_unit`"))
    shared = list(dict.fromkeys(c.unit for c in curves))
    axes = _axes_of_units(ax, curves, description)
    quantities = list(dict.fromkeys(c.name for c in curves))
    colours: dict[str, object] = {}
    lines: list[Artist] = []
    for curve in curves:
        # A common unit is shown once, at the axis.
        label = typeset(curve.name, curve.latex) if len(shared) == 1 else curve.label
        style: dict[str, Any] = {"label": label}
        if curve.run and len(quantities) == 1:
            style["label"] = curve.run
        elif curve.run:  # one colour for each quantity, one kind of line for each run
            style["label"] = f"{label}, {curve.run}"
            style["linestyle"] = LINES[curve.number % len(LINES)]
            if curve.name in colours:
                style["color"] = colours[curve.name]
        # All axes of a plot take their colours from one cycle.
        style.setdefault("color", _next_colour(ax))
        colours.setdefault(curve.name, style["color"])
        target_axes = axes[curve.unit]
        if curve.values.ndim == 1:
            lines += target_axes.plot(curve.times, curve.values, **style)
            continue
        if len(curve.values) <= LINES_OF_SAMPLES:
            first, *others = curve.values
            style |= {"linewidth": 1.0, "alpha": 0.7}
            lines += target_axes.plot(curve.times, first, **style)
            style["label"] = "_"  # in no legend
            for values in others:
                target_axes.plot(curve.times, values, **style)
            continue
        with warnings.catch_warnings():
            # Times at which all samples have failed are not drawn.
            warnings.filterwarnings("ignore", "All-NaN slice encountered", RuntimeWarning)
            low, middle, high = np.nanquantile(curve.values, BAND, axis=0)
        lines += target_axes.plot(curve.times, middle, **style)
        target_axes.fill_between(
            curve.times, low, high, color=style["color"], alpha=0.2, linewidth=0
        )
    ax.set_xlabel(time_label)
    for unit_axes in dict.fromkeys(axes.values()):
        unit_axes.margins(x=0)
    _place_beside_each_other(ax, [*axes.values()])
    ax.grid(alpha=0.3)
    if count := max((len(c.values) for c in curves if c.values.ndim > 1), default=0):
        title = f"{count} samples" if count <= LINES_OF_SAMPLES else "median, 5 to 95 %"
    options: dict[str, Any] = {"title": title or None}
    if len({*axes.values()}) == 1:
        # Curves that the Axes had before, such as another run, are in the legend, too.
        lines = ax.get_legend_handles_labels()[0]
    elif ax.figure.get_layout_engine() is not None:  # above: the other axes are at the right
        options |= {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "ncols": 4}
    legend_beside(ax, handles=lines, **options)
    return ax


def _next_colour(ax: Any) -> str:
    """Return the next colour of the cycle of Axes, which have no public method for it."""
    colour: str = ax._get_lines.get_next_color()
    return colour


def _axes_of_units(ax: Axes, curves: Sequence[PlotCurve], description: str) -> dict[str, Axes]:
    """Return the Axes of each unit; further ones share the time and have a scale at the right.

    Quantities without a unit are drawn on the axis of a single one: their labels show none.
    """
    units = list(dict.fromkeys(c.unit for c in curves))
    if len({*units} - {""}) < 2:
        label = description or _names_at_an_axis(curves)
        ax.set_ylabel(with_unit(label, units[0] if len(units) == 1 else ""))
        return dict.fromkeys(units, ax)
    axes = {}
    for k, unit in enumerate(units):
        axes[unit] = ax.twinx() if k else ax
        label = description or _names_at_an_axis([c for c in curves if c.unit == unit])
        axes[unit].set_ylabel(with_unit(label, unit))
    return axes


def _names_at_an_axis(curves: Sequence[PlotCurve]) -> str:
    """Return the names of the quantities at an axis, or 'values' if they do not fit beside it."""
    names = list(dict.fromkeys(typeset(c.name, c.latex) for c in curves))
    return ", ".join(names) if len(names) <= NAMES else "values"


def _place_beside_each_other(ax: Axes, axes: Sequence[Axes]) -> None:
    """Shift the further axes to the right so that their tick labels do not overlap."""
    for before, after in pairwise(axes[1:]):
        box = before.yaxis.get_tightbbox()
        assert box is not None
        reach = box.x1 - ax.bbox.x1  # in pixels
        after.spines["right"].set_position(("outward", 72 * reach / ax.figure.dpi + AXIS_SPACING))


def plot_fit(
    result: Any, axes: np.ndarray | None = None, *, units: Units = None, time_unit: str = ""
) -> np.ndarray:
    """Plot measured and fitted quantities, with the residuals below.

    Parameters
    ----------
    result : pydy.analysis.FitResult
        What `System.fit` returns.
    axes : ndarray of Axes, shape (2 q, trials), optional
        For each of the q measured quantities a row of samples and motions, and below it one of
        residuals; a new figure's by default.
    units, time_unit
        As for `plot_coordinates`.

    Returns
    -------
    ndarray of Axes, shape (2 q, trials)

    Examples
    --------
    >>> import numpy as np
    >>> from pydy.analysis import Trial
    >>> from pydy.models import multi_mass_spring_damper
    >>> from pydy.plot import plot_fit
    >>> system = multi_mass_spring_damper()
    >>> times = np.linspace(0.0, 10.0, num=101)
    >>> swing = np.exp(-0.1 * times) * np.cos(np.sqrt(3.99) * times)
    >>> result = system.fit(['k0', 'c0'], Trial(times, {'x0': swing}, {'x0': 1.0, 'v0': -0.1}))
    >>> plot_fit(result).shape
    (2, 1)
    """
    if not hasattr(result, "fitted") or not hasattr(result, "residuals"):
        raise TypeError(
            "`result` must be a pydy.analysis.FitResult, which `system.fit` returns, got "
            f"{shown(result)}."
        )
    names = list(dict.fromkeys(name for table in result.measured for name in table))
    shape = 2 * len(names), len(result.times)
    if axes is None:
        size = {"figsize": (2.0 + 3.5 * shape[1], 1.0 + 2.5 * len(names)), "squeeze": False}
        ratios = {"height_ratios": [3, 1] * len(names), "sharex": "col"}
        pyplot = require("matplotlib.pyplot", "plot", "pydy.plot")
        axes = pyplot.subplots(*shape, layout="constrained", **size, **ratios)[1]
    flat, _ = rows_of_axes(axes, shape[0] * shape[1], "quantity, its residuals and trial")
    grid = np.array([*flat.ravel()] if isinstance(flat, np.ndarray) else [*flat], dtype=object)
    grid = grid.reshape(shape)
    by_name = units_by_name(units, result.measured_states)
    time_label = with_unit("time", text(time_unit, "`time_unit`"))
    for column, (times, measured, fitted, residuals, label) in enumerate(
        zip(result.times, result.measured, result.fitted, result.residuals, result.labels,
            strict=True)
    ):  # fmt: skip
        for row, name in enumerate(names):
            upper, lower = grid[2 * row : 2 * row + 2, column]
            if name not in measured:
                upper.set_visible(False)
                lower.set_visible(False)
                continue
            unit, factor = by_name.get(name, ("", 1.0))
            samples, motion = factor * measured[name], factor * fitted[name]
            upper.plot(times, samples, ".", markersize=4, color="0.6", label="measured")
            finite = np.isfinite(motion)
            upper.plot(times[finite], motion[finite], linewidth=1.2, label="fitted")
            upper.set_ylabel(with_unit(typeset(name, ""), unit))
            lower.axhline(0.0, color="0.7", linewidth=0.8)
            lower.plot(times, factor * residuals[name], ".", markersize=3)
            lower.set_ylabel(with_unit("residual", unit))
            if name == next(iter(measured)):
                upper.set_title(label)
                if column + 1 == len(result.times):
                    legend_beside(upper)
            if name == [*measured][-1]:
                lower.set_xlabel(time_label)
                lower.tick_params(labelbottom=True)
    return grid
