"""A trajectory as a labelled table, and from a file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from os import PathLike
from typing import Any

import numpy as np

from pydy._checks import flag, real_array
from pydy._dataset import ENERGIES, KINDS, OUTPUTS, STATES, read_netcdf, to_dataset
from pydy._names import latex_of, unique_names
from pydy._optional import require
from pydy._sensitivity import Sensitivity

__all__ = ["Loaded", "checked_table", "dataframe_of", "dataset_of", "loaded_from"]


def checked_table(argument: str, values: Any, m: int, width: int) -> np.ndarray:
    """Return an own copy with one row for each time and one column for each symbol."""
    table = np.empty((m, 0)) if values is None else np.array(real_array(values, f"`{argument}`"))
    if table.shape != (m, width):
        raise ValueError(
            f"`{argument}` must have the shape ({m}, {width}), one row for each time and one "
            f"column for each symbol, got {table.shape}."
        )
    return table


def dataset_of(
    trajectory: Any, sensitivity: Sensitivity | None, derivatives: bool, energy: bool
) -> Any:
    """Return the Dataset of `Trajectory.to_xarray`."""
    derivatives, energy = flag(derivatives, "`derivatives`"), flag(energy, "`energy`")
    columns = [
        (name, kind, trajectory.latex(name), trajectory[name])
        for kind in KINDS
        for name in trajectory.names_of(kind)
    ]
    if derivatives:
        for k, name in enumerate(trajectory.names_of(*STATES)):
            latex = trajectory.latex_of_rate(name)
            columns.append((f"{name}'", "derivative", latex, trajectory.derivatives[:, k]))
    if energy:
        for k, name in enumerate(ENERGIES):
            latex = rf"\text{{{name.replace('_', ' ')}}}"
            columns.append((name, "energy", latex, trajectory.energy[:, k]))
    names = unique_names(list(trajectory.constants))
    constants = {
        name: (latex_of(s), float(v))
        for name, (s, v) in zip(names, trajectory.constants.items(), strict=True)
    }
    xarray = require("xarray", "labels", "Trajectory.to_xarray")
    return to_dataset(xarray, trajectory.times, columns, constants, sensitivity)


def dataframe_of(trajectory: Any) -> Any:
    """Return the DataFrame of `Trajectory.to_dataframe`."""
    pandas = require("pandas", "labels", "Trajectory.to_dataframe")
    index = pandas.Index(trajectory.times, name="time")
    return pandas.DataFrame({name: trajectory[name] for name in trajectory.names}, index=index)


@dataclass(frozen=True, eq=False)
class Loaded:
    """What a file holds.

    Attributes
    ----------
    arguments : dict
        Of `Trajectory`.
    latex : dict of str to str
    sensitivity : (names, ndarray of shape (m, q, k)) or None
    derivatives, energy : ndarray or None
    """

    arguments: dict[str, Any]
    latex: dict[str, str]
    sensitivity: tuple[list[str], np.ndarray] | None
    derivatives: np.ndarray | None
    energy: np.ndarray | None


def loaded_from(path: str | PathLike[str], record: Callable[..., Any]) -> Loaded:
    """Return what a file of `Trajectory.save` holds; `record` makes an event of its attributes."""
    xarray = require("xarray", "labels", "Trajectory.load")
    parts, statistics, events = read_netcdf(xarray, path, record)
    m = len(parts.times)
    table = {
        kind: np.array(list(columns.values())).reshape(len(columns), m).T
        for kind, columns in parts.columns.items()
    }
    empty = np.empty((m, 0))

    def together(*kinds: str) -> np.ndarray:
        return np.concatenate([table.get(kind, empty) for kind in kinds], axis=1)

    arguments = {
        "times": parts.times,
        "states": together(*STATES),
        "symbols": {kind: tuple(parts.columns.get(kind, ())) for kind in KINDS},
        "outputs": together(*OUTPUTS),
        "specifieds": together("specified"),
        "constants": parts.constants,
        "events": events,
        "statistics": statistics,
    }
    return Loaded(
        arguments, parts.latex, parts.sensitivity, table.get("derivative"), table.get("energy")
    )
