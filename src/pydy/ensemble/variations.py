"""What varies from sample to sample: read from a user's dictionaries into `Samples`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from pydy._checks import Places, check_mapping, merged, number, real_array
from pydy._names import latex_of
from pydy._problem import Problem
from pydy.codegen import SpecifiedsPlan, symbolic_entries
from pydy.ensemble.names import ResultNames
from pydy.ensemble.samples import Samples, Variable
from pydy.inputs import SampledInput

Column = tuple[tuple[str, ...], np.ndarray]
"""The values of one symbol, and the names of their axes; a number has none."""


def split_specifieds(
    specifieds: Mapping[Any, Any] | None,
) -> tuple[dict[Any, Any], dict[Any, Any]]:
    """Return the specifieds that vary from sample to sample, and those of all samples."""
    varied: dict[Any, Any] = {}
    common: dict[Any, Any] = {}
    specifieds = check_mapping("specifieds", specifieds)
    for key, value in (merged(specifieds) if len(specifieds) > 1 else specifieds).items():
        together = isinstance(key, (tuple, list)) or key in ("symbols", "values")
        plain = not together and not callable(value)
        symbolic = isinstance(value, SampledInput) or symbolic_entries(value) is not None
        several = plain and not symbolic and not hasattr(value, "dims")
        if several:
            several = real_array(value, f"`specifieds[{key}]`").ndim > 0
        (varied if several or (plain and hasattr(value, "dims")) else common)[key] = value
    return varied, common


def read_samples(
    problem: Problem,
    plan: SpecifiedsPlan,
    names: ResultNames,
    product: bool,
    initial_conditions: Mapping[Any, Any] | None,
    constants: Mapping[Any, Any] | None,
    varied: Mapping[Any, Any],
) -> Samples:
    """Return the samples of what is varied; all else has the values of the Problem.

    Specifieds have those of the `plan`, but for the `varied` ones.
    """
    initial = check_mapping("initial_conditions", initial_conditions)
    constants = check_mapping("constants", constants)
    if len(initial) > 1 or len(constants) > 1:
        initial, constants = dict(merged(initial)), dict(merged(constants))
    axes, places = _Axes(product, names), problem.definition.places
    x = _columns("initial_conditions", initial, places["states"], problem.x, axes, "initial")
    p = _columns("constants", constants, places["constants"], problem.p, axes, "constant")
    r = _columns("specifieds", varied, places["specifieds"], plan.inputs.values, axes, "specified")
    if problem.definition.assumptions:
        _check_assumptions(problem, x, "states", initial, "initial_conditions")
        _check_assumptions(problem, p, "constants", constants, "constants")
        _check_assumptions(problem, r, "specifieds", varied, "specifieds")
    axes.check_names()
    for (label, attrs), (dims, value) in zip(names.constants, p, strict=True):
        if not dims:
            axes.coordinates.setdefault(label, Variable((), value, dict(attrs)))
    x_rows, r_rows, p_rows = (_aligned(columns, axes.dims) for columns in (x, r, p))
    return Samples(axes.dims, x_rows, r_rows, p_rows, axes.coordinates)


class _Axes:
    """Collects dimensions and coordinates; with `product`, each array has its own dimension."""

    def __init__(self, product: bool, names: ResultNames) -> None:
        self.product, self.names = product, names
        self.dims: dict[str, int] = {}
        self.coordinates: dict[str, Variable] = {}
        self._source: dict[str, str] = {}  # what gave a dimension its size
        self._index: dict[str, tuple[str, np.ndarray]] = {}

    def add(self, what: str, value: Any, name: str, attrs: dict[str, Any]) -> Column:
        """Return one value, called `what` in messages, with the names of its axes."""
        dims: tuple[str, ...]
        if hasattr(value, "dims") and hasattr(value, "coords"):
            dims = tuple(map(str, value.dims))
            array = real_array(value, what)
            for d in dims:
                if d in value.coords and value.coords[d].ndim == 1:
                    labels = value.coords[d]
                    self._label(what, d, Variable((d,), np.array(labels), dict(labels.attrs)))
        else:
            array = real_array(value, what)
            if array.ndim > 1:
                raise ValueError(
                    f"{what} must be a number, a one-dimensional array, or an xarray.DataArray "
                    f"that names its dimensions, got the shape {array.shape}."
                )
            dims = (name if self.product else "sample",) * array.ndim
            index = getattr(value, "index", None)  # of a pandas.Series; a list has a method
            if array.ndim and index is not None and not callable(index):
                self._match(what, dims[0], np.asarray(index))
        if not np.isfinite(array).all():
            where = tuple(int(k) for k in np.argwhere(~np.isfinite(array))[0])
            raise ValueError(f"{what} must be finite, got {array[where]} at index {where}.")
        for d, size in zip(dims, array.shape, strict=True):
            self._dimension(what, d, size)
        if dims:
            self._label(what, name, Variable(dims, np.array(array), attrs))
        return dims, array

    def _dimension(self, what: str, dim: str, size: int) -> None:
        if dim in self.names.taken:
            raise ValueError(
                f"{what} has the dimension `{dim}`, which is the name of a variable of the result. "
                "Choose another name."
            )
        if size == 0:
            raise ValueError(f"{what} must not be empty along `{dim}`.")
        if self.dims.setdefault(dim, size) != size:
            raise ValueError(
                f"{what} has {size} values along `{dim}`, but {self._source[dim]} has "
                f"{self.dims[dim]}. Make them equally long, give them different dimensions as "
                "xarray.DataArray, or pass product=True for all combinations."
            )
        self._source.setdefault(dim, what)

    def _label(self, what: str, name: str, coordinate: Variable) -> None:
        former = self.coordinates.get(name)
        if former is not None and not np.array_equal(former.values, coordinate.values):
            raise ValueError(
                f"{what} has other coordinates along `{name}` than "
                f"{self._source.get(name, name)}: values are matched by position, so labels must "
                "agree."
            )
        if former is None or "role" in coordinate.attrs:
            self.coordinates[name] = coordinate

    def _match(self, what: str, dim: str, index: np.ndarray) -> None:
        other, former = self._index.setdefault(dim, (what, index))
        if len(former) == len(index) and not np.array_equal(former, index):
            raise ValueError(
                f"{what} has another index than {other}: values are matched by position, so "
                "indices must agree. Align the Series, or pass their `.to_numpy()`."
            )

    def check_names(self) -> None:
        """Raise if a dimension is called like a quantity that is not given along it."""
        for symbol, name in self.names.labels.items():
            label = self.coordinates.get(name)
            along = label is not None and label.dims == (name,) and "role" in label.attrs
            if name in self.dims and not along:
                raise ValueError(
                    f"{self._source[name]} has the dimension `{name}`, but that is the name of "
                    f"`{symbol}`, which is not given along it. Choose another name: "
                    "xarray.DataArray(values, dims='run')."
                )


def _columns(
    argument: str,
    values: Mapping[Any, Any],
    places: Places,
    base: np.ndarray,
    axes: _Axes,
    role: str,
) -> list[Column]:
    """Return the values of each symbol; those that are not given are as in `base`."""
    columns: list[Column] = [((), np.asarray(value)) for value in base]
    if not values:
        return columns
    chosen = places.columns(values, argument).tolist()
    for place, value in zip(chosen, values.values(), strict=True):
        symbol = places.symbols[place]
        what = f"`{argument}[{symbol}]`"
        if not hasattr(value, "dims") and real_array(value, what).ndim == 0:
            columns[place] = ((), np.asarray(number(value, what, finite=True)))
        else:
            attrs = {"role": role, "latex": latex_of(symbol)}
            columns[place] = axes.add(what, value, axes.names.labels[symbol], attrs)
    return columns


def _check_assumptions(
    problem: Problem, columns: list[Column], kind: str, values: Mapping[Any, Any], argument: str
) -> None:
    """Warn once of samples that contradict assumptions."""
    assumed, warned = problem.definition.assumptions.get(kind), problem.settings.contradicted
    if not values or assumed is None or warned is None:
        return
    for place in {
        problem.definition.places[kind].find(key, argument) for key in values
    } & assumed.columns:
        samples = np.ravel(columns[place][1])
        rows = np.full((len(samples), len(columns)), np.nan)
        rows[:, place] = samples
        assumed.tell(rows, warned, f"`{argument}` for ", where=lambda row: " in one sample or more")


def _aligned(columns: Sequence[Column], dims: Mapping[str, int]) -> tuple[np.ndarray, ...]:
    """Return arrays that nobody else has, with one axis for each dimension."""
    result = []
    for names, values in columns:
        order = [names.index(d) for d in dims if d in names]
        shape = [dims[d] if d in names else 1 for d in dims]
        result.append(np.array(np.transpose(values, order).reshape(shape)))
    return tuple(result)
