"""Results of an ensemble as an `xarray.Dataset`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pydy._dataset import SENSITIVITY
from pydy._optional import require
from pydy.ensemble.samples import Coordinate

__all__ = ["PARAMETER", "QUANTITY", "SENSITIVITY", "Form", "Variable", "check_forms", "to_dataset"]

PARAMETER, QUANTITY = "parameter", "quantity"  # the dimensions of sensitivities


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


@dataclass(frozen=True)
class Form:
    """The form that the results of all samples share.

    Attributes
    ----------
    sizes : dict of str to int
        Of the axes after those of the samples, in order.
    dtype : numpy.dtype
    """

    sizes: dict[str, int]
    dtype: np.dtype[Any]

    @classmethod
    def of(cls, dims: Sequence[Any], shape: Sequence[int], dtype: Any, first: int) -> Form:
        """Return the form of an array whose axes before `first` are those of samples."""
        return cls(dict(zip(map(str, dims[first:]), shape[first:], strict=True)), np.dtype(dtype))

    def __str__(self) -> str:
        return f"{self.dtype} along {self.sizes}" if self.sizes else f"{self.dtype}"


def check_forms(
    found: Mapping[str, Variable], expected: Mapping[str, Form], samples: Sequence[Any]
) -> None:
    """Raise if results do not match those of other samples: assigning would broadcast them.

    Parameters
    ----------
    found : mapping
    expected : mapping
        The forms of all variables.
    samples : sequence of str
        The sample dimensions.
    """
    rule = "`reduce` must return the same variables for all blocks of samples"
    for name in dict.fromkeys((*expected, *found)):
        if name not in found or name not in expected:
            raise ValueError(f"{rule}: `{name}` exists for some samples only.")
        v, form = found[name], expected[name]
        own = Form.of(v.dims, v.values.shape, v.values.dtype, len(samples))
        if list(own.sizes.items()) != list(form.sizes.items()) or not np.can_cast(
            own.dtype, form.dtype
        ):
            raise ValueError(f"{rule}: `{name}` is {form} for some, {own} for others.")


def to_dataset(
    variables: Mapping[str, Variable],
    coordinates: Mapping[str, Coordinate],
    times: np.ndarray,
    attrs: Mapping[str, Any] | None = None,
    labels: Mapping[str, Sequence[str]] | None = None,
) -> Any:
    """Return the Dataset of some variables; it has times only where a variable does.

    The same goes for the labels of other dimensions.
    """
    xarray = require("xarray", "ensemble", "System.integrate_ensemble")
    coords: dict[str, Any] = {
        name: (c.dims, c.values, dict(c.attrs)) for name, c in coordinates.items()
    }
    if any("time" in v.dims for v in variables.values()):
        coords["time"] = ("time", times)
    along = {d for v in variables.values() for d in v.dims}
    for dim, names in (labels or {}).items():
        if dim in along:
            coords[dim] = (dim, list(names))
    data = {name: (v.dims, v.values, dict(v.attrs)) for name, v in variables.items()}
    return xarray.Dataset(data, coords, dict(attrs or {}))
