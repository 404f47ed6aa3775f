"""Results of an ensemble as an `xarray.Dataset`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pydy._optional import require
from pydy.ensemble.samples import Coordinate

__all__ = ["Variable", "to_dataset"]


@dataclass(frozen=True, eq=False)
class Variable:
    """An array with names for its axes.

    Attributes
    ----------
    dims : tuple of str
    values : array
        Of NumPy or Dask.
    attrs : dict
    """

    dims: tuple[Any, ...]
    values: Any
    attrs: dict[str, Any] = field(default_factory=dict)


def to_dataset(
    variables: Mapping[str, Variable],
    coordinates: Mapping[str, Coordinate],
    times: np.ndarray,
    attrs: Mapping[str, Any] | None = None,
) -> Any:
    """Return the Dataset of some variables; it has times only where a variable does."""
    xarray = require("xarray", "ensemble", "System.integrate_ensemble")
    coords: dict[str, Any] = {
        name: (c.dims, c.values, dict(c.attrs)) for name, c in coordinates.items()
    }
    if any("time" in v.dims for v in variables.values()):
        coords["time"] = ("time", times)
    data = {name: (v.dims, v.values, dict(v.attrs)) for name, v in variables.items()}
    return xarray.Dataset(data, coords, dict(attrs or {}))
