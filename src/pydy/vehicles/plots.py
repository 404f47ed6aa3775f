"""Plots of tires: characteristics over slip, and carpets of combined slip."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._axes import axes_of, legend_beside
from pydy._checks import choice, number, positive, real_array, shown
from pydy.vehicles.algebra import is_symbolic
from pydy.vehicles.forces import Tire, TireForces

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_POINTS = 201
_UNITS = {"Fx": "N", "Fy": "N", "Mx": "N m", "My": "N m", "Mz": "N m"}
_LABELS = {"kappa": r"$\kappa$", "alpha": r"$\alpha$ (°)", "gamma": r"$\gamma$ (°)"}
_ENDS = {"kappa": 0.3, "alpha": float(np.radians(15.0)), "gamma": float(np.radians(10.0))}


def plot_tire(
    tire: Tire,
    force: str = "Fy",
    loads: Sequence[float] | None = None,
    *,
    over: str | None = None,
    largest: float | None = None,
    kappa: float = 0.0,
    alpha: float = 0.0,
    gamma: float = 0.0,
    speed: float | None = None,
    pressure: float | None = None,
    ax: Axes | None = None,
) -> Axes:
    """Plot a force or moment of a tire over slip or camber, one curve for each load.

    Parameters
    ----------
    tire : tire
        Such as a `MagicFormula`; its parameters must be numbers.
    force : {'Fx', 'Fy', 'Mx', 'My', 'Mz'}
        What to plot.
    loads : sequence of float, optional
        Normal forces (N); by default 0.5, 1, 1.5 and 2 times the nominal load.
    over : {'kappa', 'alpha', 'gamma'}, optional
        The horizontal axis: by default κ for F_x and M_y, otherwise α.
    largest : float, optional
        Half the width of the horizontal axis: a slip, or an angle (rad).
    kappa, alpha, gamma : float, optional
        Values of the others (rad).
    speed, pressure : float, optional
        As for `MagicFormula.forces`.
    ax : matplotlib Axes, optional
        Where to draw; a new figure by default.

    Returns
    -------
    matplotlib Axes

    Examples
    --------
    >>> from pydy.vehicles import BrushTire, plot_tire
    >>> tire = BrushTire(4000, stiffness=80e3, friction=0.9, half_length=0.06)
    >>> ax = plot_tire(tire, 'Mz', [2000, 4000])
    >>> ax.get_ylabel(), [line.get_label() for line in ax.lines]
    ('Mz (N m)', ['2000 N', '4000 N'])
    """
    force = choice(force, TireForces._fields, "`force`")
    if over is None:
        over = "kappa" if force in ("Fx", "My") else "alpha"
    over = choice(over, _LABELS, "`over`")
    end = _ENDS[over] if largest is None else positive(largest, "`largest`", finite=True)
    if loads is None:
        loads = [k * _nominal_load(tire, "loads") for k in (0.5, 1.0, 1.5, 2.0)]
    values = _listed(loads, "loads")
    inputs: dict[str, Any] = {"kappa": kappa, "alpha": alpha, "gamma": gamma}
    inputs = _checked(**inputs, speed=speed, pressure=pressure)
    inputs[over] = np.linspace(-end, end, _POINTS)
    curves = [getattr(_numeric_forces(tire, load, **inputs), force) for load in values]
    ax = axes_of(ax, "pydy.vehicles")
    horizontal = inputs[over] if over == "kappa" else np.degrees(inputs[over])
    for load, curve in zip(values, curves, strict=True):
        ax.plot(horizontal, curve, label=f"{load:g} N")
    ax.set_xlabel(_LABELS[over])
    ax.set_ylabel(f"{force} ({_UNITS[force]})")
    ax.grid(alpha=0.3)
    legend_beside(ax)
    return ax


def plot_tire_carpet(
    tire: Tire,
    load: float | None = None,
    *,
    kappas: Sequence[float] | None = None,
    alphas: Sequence[float] | None = None,
    gamma: float = 0.0,
    speed: float | None = None,
    pressure: float | None = None,
    ax: Axes | None = None,
) -> Axes:
    """Plot F_y over F_x of combined slip as a carpet: lines of constant κ and of constant α.

    Parameters
    ----------
    tire : tire
        Such as a `MagicFormula`; its parameters must be numbers.
    load : float, optional
        Normal force (N); by default the nominal load.
    kappas : sequence of float, optional
        Longitudinal slips of the dashed lines; by default from −0.3 to 0.3.
    alphas : sequence of float, optional
        Slip angles (rad) of the solid lines; by default from −12° to 12°.
    gamma, speed, pressure : float, optional
        As for `MagicFormula.forces`.
    ax : matplotlib Axes, optional
        Where to draw; a new figure by default.

    Returns
    -------
    matplotlib Axes

    Examples
    --------
    >>> from pydy.vehicles import BrushTire, plot_tire_carpet
    >>> tire = BrushTire(4000, stiffness=80e3, friction=0.9)
    >>> plot_tire_carpet(tire).get_xlabel()
    'Fx (N)'
    """
    if load is None:
        load = _nominal_load(tire, "load")
    load = positive(load, "`load`", finite=True)
    if kappas is None:
        kappas = [-0.3, -0.1, -0.05, -0.02, 0.0, 0.02, 0.05, 0.1, 0.3]
    if alphas is None:
        alphas = np.radians([-12, -8, -4, -2, -1, 0, 1, 2, 4, 8, 12]).tolist()
    slips, angles = _listed(kappas, "kappas"), _listed(alphas, "alphas")
    options = _checked(gamma=gamma, speed=speed, pressure=pressure)

    def line(values: np.ndarray) -> np.ndarray:
        return np.linspace(values.min(), values.max(), _POINTS)

    along_kappa = [_numeric_forces(tire, load, line(slips), angle, **options) for angle in angles]
    along_alpha = [_numeric_forces(tire, load, slip, line(angles), **options) for slip in slips]
    ax = axes_of(ax, "pydy.vehicles")
    for angle, forces in zip(angles, along_kappa, strict=True):
        label = rf"$\alpha$ = {np.degrees(angle):.3g}°"
        ax.plot(forces.Fx, forces.Fy, color="C0", linewidth=1.0, label=label)
    for slip, forces in zip(slips, along_alpha, strict=True):
        label = rf"$\kappa$ = {slip:.3g}"
        ax.plot(forces.Fx, forces.Fy, color="C1", linestyle="dashed", linewidth=1.0, label=label)
        ax.annotate(f"{slip:.3g}", _end(forces, 0), color="C1", fontsize="small")
    for angle, forces in zip(angles, along_kappa, strict=True):
        ax.annotate(f"{np.degrees(angle):.3g}°", _end(forces, -1), color="C0", fontsize="small")
    ax.set_xlabel("Fx (N)")
    ax.set_ylabel("Fy (N)")
    ax.set_title(rf"{load:g} N; solid: $\alpha$, dashed: $\kappa$", fontsize="medium")
    ax.set_aspect("equal", adjustable="datalim")
    ax.grid(alpha=0.3)
    return ax


def _checked(**inputs: Any) -> dict[str, Any]:
    """Return finite numbers; the speed and the pressure may be None."""
    return {
        name: None
        if value is None and name in ("speed", "pressure")
        else number(value, f"`{name}`", finite=True)
        for name, value in inputs.items()
    }


def _end(forces: TireForces, k: int) -> tuple[float, float]:
    return float(np.asarray(forces.Fx)[k]), float(np.asarray(forces.Fy)[k])


def _numeric_forces(tire: Tire, *inputs: Any, **options: Any) -> TireForces:
    symbols = [name for name, value in tire.parameters.items() if is_symbolic(value)]
    if symbols:
        raise ValueError(
            f"The parameter {symbols[0]} of the tire is an expression. Give it a number for plots: "
            f"`tire.replace({symbols[0]}=...)`."
        )
    return tire.forces(*inputs, **options)


def _nominal_load(tire: Tire, argument: str) -> float:
    if not hasattr(tire, "parameters") or isinstance(tire, type):
        raise TypeError(f"`tire` must be a tire, such as MagicFormula, got {shown(tire)}.")
    for name in ("FNOMIN", "nominal_load"):
        value = tire.parameters.get(name)
        if value is not None and not is_symbolic(value):
            return float(value)
    raise ValueError(f"`{argument}` must be given: the tire has no nominal load.")


def _listed(values: Any, argument: str) -> np.ndarray:
    array = np.atleast_1d(real_array(values, f"`{argument}`"))
    if array.ndim != 1 or not array.size or not np.isfinite(array).all():
        raise ValueError(f"`{argument}` must be finite numbers, got {shown(values)}.")
    return array
