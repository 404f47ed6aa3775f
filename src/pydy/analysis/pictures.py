"""Pictures of what analyses find, with matplotlib."""

from __future__ import annotations

from typing import Any

import numpy as np

from pydy._checks import shown
from pydy._optional import require

__all__ = [
    "axes_of",
    "plot_bode",
    "plot_branch",
    "plot_eigenvalues",
    "plot_poles",
    "plot_residuals",
    "plot_root_locus",
]


def axes_of(ax: Any) -> Any:
    """Return the Axes that were given, or those of a new figure."""
    if ax is None:
        return require("matplotlib.pyplot", "plot", "a plot").subplots(layout="constrained")[1]
    if not hasattr(ax, "set_xlabel"):
        raise TypeError(f"`ax` must be Matplotlib Axes, got {shown(ax)}.")
    return ax


def _titled(name: str, unit: str) -> str:
    return f"{name} ({unit})" if unit else name


def plot_eigenvalues(
    values: np.ndarray, eigenvalues: np.ndarray, parameter: str, ax: Any, unit: str
) -> Any:
    """Draw real parts and, dashed, positive imaginary parts over a parameter."""
    ax = axes_of(ax)
    ax.axhline(0.0, color="0.7", linewidth=0.8)
    for branch, column in enumerate(eigenvalues.T):
        colour = f"C{branch % 10}"
        ax.plot(values, column.real, color=colour)
        if column.imag.max() > 0.0:
            imag = np.where(column.imag > 0.0, column.imag, np.nan)
            ax.plot(values, imag, color=colour, linestyle="--")
    ax.set_xlabel(_titled(parameter, unit))
    ax.set_ylabel("real and imaginary (dashed) parts (1/s)")
    return ax


def plot_root_locus(
    values: np.ndarray, eigenvalues: np.ndarray, parameter: str, ax: Any, unit: str
) -> Any:
    """Draw eigenvalues in the complex plane, coloured by a parameter."""
    ax = axes_of(ax)
    ax.axvline(0.0, color="0.7", linewidth=0.8)
    colours = np.broadcast_to(values[:, None], eigenvalues.shape)
    points = ax.scatter(eigenvalues.real, eigenvalues.imag, c=colours, s=6)
    ax.scatter(eigenvalues[0].real, eigenvalues[0].imag, marker="x", color="k", linewidths=0.8)
    ax.set_xlabel("real part (1/s)")
    ax.set_ylabel("imaginary part (1/s)")
    ax.figure.colorbar(points, ax=ax, label=_titled(parameter, unit))
    return ax


def plot_poles(eigenvalues: np.ndarray, ax: Any) -> Any:
    """Draw the eigenvalues of one linear model, or of several in turn, in the complex plane."""
    ax = axes_of(ax)
    ax.axvline(0.0, color="0.7", linewidth=0.8)
    ax.axhline(0.0, color="0.7", linewidth=0.8)
    colours: dict[str, Any] = {"color": "C0"}
    if eigenvalues.ndim == 2:
        turn = np.arange(len(eigenvalues))[:, None]
        colours = {"c": np.broadcast_to(turn, eigenvalues.shape)}
    ax.scatter(eigenvalues.real, eigenvalues.imag, marker="x", **colours)
    ax.set_xlabel("real part (1/s)")
    ax.set_ylabel("imaginary part (1/s)")
    return ax


def plot_branch(
    values: np.ndarray,
    solution: np.ndarray,
    stable: np.ndarray,
    parameter: str,
    name: str,
    special: list[tuple[float, float, str]],
    ax: Any,
) -> Any:
    """Draw an unknown over a parameter, dashed where unstable, with its special points."""
    ax = axes_of(ax)
    start = 0
    for k in range(1, len(values) + 1):
        if k == len(values) or stable[k] != stable[start]:
            run = slice(start, min(k + 1, len(values)))
            style = "-" if stable[start] else "--"
            ax.plot(values[run], solution[run], color="C0", linestyle=style)
            start = k
    for x, y, kind in special:
        ax.plot(x, y, "o", color="C3", markersize=4)
        ax.annotate(kind, (x, y), textcoords="offset points", xytext=(4, 4), fontsize="small")
    ax.set_xlabel(parameter)
    ax.set_ylabel(name)
    return ax


def plot_residuals(
    times: list[np.ndarray], residuals: list[dict[str, np.ndarray]], axes: Any
) -> Any:
    """Draw residuals over time, an Axes for each trial."""
    if axes is None:
        plt = require("matplotlib.pyplot", "plot", "a plot")
        _, axes = plt.subplots(len(times), squeeze=False, layout="constrained")
        axes = axes[:, 0]
    for ax, instants, columns in zip(np.atleast_1d(axes), times, residuals, strict=True):
        axes_of(ax).axhline(0.0, color="0.7", linewidth=0.8)
        for name, column in columns.items():
            ax.plot(instants, column, ".", markersize=3, label=name)
        ax.set_xlabel("time")
        ax.set_ylabel("measured minus model")
        ax.legend()
    return axes


def plot_bode(frequencies: np.ndarray, response: np.ndarray, title: str, axes: Any) -> Any:
    """Draw magnitude and phase of a frequency response; return the two Axes."""
    if axes is None:
        plt = require("matplotlib.pyplot", "plot", "a plot")
        _, axes = plt.subplots(2, sharex=True, layout="constrained")
    magnitude, phase = (axes_of(ax) for ax in axes)
    with np.errstate(divide="ignore"):
        magnitude.semilogx(frequencies, 20.0 * np.log10(np.abs(response)), label=title)
    phase.semilogx(frequencies, np.degrees(np.unwrap(np.angle(response))), label=title)
    magnitude.set_ylabel("magnitude (dB)")
    phase.set_ylabel("phase (°)")
    phase.set_xlabel("frequency (rad/s)")
    magnitude.legend()
    return axes
