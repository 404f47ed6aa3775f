"""Converts a user's dictionaries of varied numbers into `Samples`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._checks import SymbolIndex, check_mapping, merged, number, real_array, shown
from pydy._names import latex_of
from pydy._problem import Problem
from pydy.codegen import SpecifiedsPlan, symbolic_entries
from pydy.ensemble.names import ResultNames
from pydy.ensemble.samples import LabelledArray, Samples
from pydy.inputs import SampledInput

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from pydy._sympy_types import SymbolOrName

Column = tuple[tuple[str, ...], np.ndarray]
"""The names of the axes and the values of one symbol; a number has no axes."""


def split_specifieds(
    specifieds: Mapping[SymbolOrName | tuple[SymbolOrName, ...], object] | None,
) -> tuple[
    dict[SymbolOrName | tuple[SymbolOrName, ...], object],
    dict[SymbolOrName | tuple[SymbolOrName, ...], object],
]:
    """Return the specifieds that vary from sample to sample, and those that all samples share."""
    varied: dict[SymbolOrName | tuple[SymbolOrName, ...], object] = {}
    common: dict[SymbolOrName | tuple[SymbolOrName, ...], object] = {}
    specifieds = check_mapping("specifieds", specifieds)
    for key, value in (merged(specifieds) if len(specifieds) > 1 else specifieds).items():
        together = isinstance(key, (tuple, list)) or key in ("symbols", "values")
        is_value = not together and not callable(value)
        symbolic = isinstance(value, SampledInput) or symbolic_entries(value) is not None
        several = is_value and not symbolic and not hasattr(value, "dims")
        entries = value if several and isinstance(value, Sequence) else ()
        if any(isinstance(entry, SampledInput) for entry in entries):
            raise ValueError(
                f"`specifieds[{key}]` must be numbers, one for each sample, or one SampledInput, "
                f"which all samples share, got {shown(value)}. For inputs that differ give an "
                "expression of the time and of constants, and vary these in `constants`; or call "
                "`simulate` for each sample."
            )
        if several:
            several = real_array(value, f"`specifieds[{key}]`").ndim > 0
        (varied if several or (is_value and hasattr(value, "dims")) else common)[key] = value
    return varied, common


def read_samples(
    problem: Problem,
    plan: SpecifiedsPlan,
    names: ResultNames,
    product: bool,
    initial_conditions: Mapping[SymbolOrName, ArrayLike] | None,
    constants: Mapping[SymbolOrName, ArrayLike] | None,
    varied: Mapping[SymbolOrName | tuple[SymbolOrName, ...], object],
) -> Samples:
    """Return the Samples; symbols that are not varied have the values of the Problem.

    Specifieds that are not `varied` have the values of the `plan`.
    """
    initial = check_mapping("initial_conditions", initial_conditions)
    constants = check_mapping("constants", constants)
    if len(initial) > 1 or len(constants) > 1:
        initial, constants = dict(merged(initial)), dict(merged(constants))
    axes, index_by_kind = _SampleAxes(product, names), problem.definition.places
    x = _columns("initial_conditions", initial, index_by_kind["states"], problem.x, axes, "initial")
    p = _columns("constants", constants, index_by_kind["constants"], problem.p, axes, "constant")
    r = _columns(
        "specifieds", varied, index_by_kind["specifieds"], plan.inputs.values, axes, "specified"
    )
    if problem.definition.assumptions:
        _check_assumptions(problem, x, "states", initial, "initial_conditions")
        _check_assumptions(problem, p, "constants", constants, "constants")
        _check_assumptions(problem, r, "specifieds", varied, "specifieds")
    axes.check_names()
    for (label, attrs), (dims, value) in zip(names.constants, p, strict=True):
        if not dims:
            axes.coordinates.setdefault(label, LabelledArray((), value, dict(attrs)))
    x_rows, r_rows, p_rows = (_aligned(columns, axes.dims) for columns in (x, r, p))
    return Samples(axes.dims, x_rows, r_rows, p_rows, axes.coordinates)


class _SampleAxes:
    """Collects dimensions and coordinates; if `product`, each array gets its own dimension."""

    def __init__(self, product: bool, names: ResultNames) -> None:
        self.product, self.names = product, names
        self.dims: dict[str, int] = {}
        self.coordinates: dict[str, LabelledArray] = {}
        self._source: dict[str, str] = {}  # the argument that first defined each dimension
        self._index: dict[str, tuple[str, np.ndarray]] = {}

    def add(self, subject: str, value: Any, name: str, attrs: Mapping[str, object]) -> Column:
        """Return one value with the names of its axes; messages call it `subject`."""
        dims: tuple[str, ...]
        if hasattr(value, "dims") and hasattr(value, "coords"):
            dims = tuple(map(str, value.dims))
            array = real_array(value, subject)
            for d in dims:
                if d in value.coords and value.coords[d].ndim == 1:
                    labels = value.coords[d]
                    self._label(
                        subject, d, LabelledArray((d,), np.array(labels), dict(labels.attrs))
                    )
        else:
            array = real_array(value, subject)
            if array.ndim > 1:
                raise ValueError(
                    f"{subject} must be a number, a one-dimensional array, or an xarray.DataArray "
                    f"that names its dimensions, got the shape {array.shape}."
                )
            dims = (name if self.product else "sample",) * array.ndim
            index = getattr(value, "index", None)  # of a pandas.Series; a list has a method
            if array.ndim and index is not None and not callable(index):
                self._match(subject, dims[0], np.asarray(index))
        if not np.isfinite(array).all():
            index_tuple = tuple(int(k) for k in np.argwhere(~np.isfinite(array))[0])
            raise ValueError(
                f"{subject} must be finite, got {array[index_tuple]} at index {index_tuple}."
            )
        for d, size in zip(dims, array.shape, strict=True):
            self._dimension(subject, d, size)
        if dims:
            self._label(subject, name, LabelledArray(dims, np.array(array), attrs))
        return dims, array

    def _dimension(self, subject: str, dim: str, size: int) -> None:
        if dim in self.names.used_names:
            raise ValueError(
                f"{subject} has the dimension `{dim}`, which is the name of a variable of the "
                "result. Choose another name."
            )
        if size == 0:
            raise ValueError(f"{subject} must not be empty along `{dim}`.")
        if self.dims.setdefault(dim, size) != size:
            raise ValueError(
                f"{subject} has {size} values along `{dim}`, but {self._source[dim]} has "
                f"{self.dims[dim]}. Make them equally long, give them different dimensions as "
                "xarray.DataArray, or pass product=True for all combinations."
            )
        self._source.setdefault(dim, subject)

    def _label(self, subject: str, name: str, coordinate: LabelledArray) -> None:
        former = self.coordinates.get(name)
        if former is not None and not np.array_equal(former.values, coordinate.values):
            raise ValueError(
                f"{subject} has other coordinates along `{name}` than "
                f"{self._source.get(name, name)}: values are matched by position, so labels must "
                "agree."
            )
        if former is None or "role" in coordinate.attrs:
            self.coordinates[name] = coordinate

    def _match(self, subject: str, dim: str, index: np.ndarray) -> None:
        former_subject, former = self._index.setdefault(dim, (subject, index))
        if len(former) == len(index) and not np.array_equal(former, index):
            raise ValueError(
                f"{subject} has another index than {former_subject}: values are matched by "
                "position, so indices must agree. Align the Series, or pass their `.to_numpy()`."
            )

    def check_names(self) -> None:
        """Raise an error if a dimension has the name of a quantity that does not vary along it."""
        for symbol, name in self.names.labels.items():
            label = self.coordinates.get(name)
            is_coordinate = label is not None and label.dims == (name,) and "role" in label.attrs
            if name in self.dims and not is_coordinate:
                raise ValueError(
                    f"{self._source[name]} has the dimension `{name}`, but that is the name of "
                    f"`{symbol}`, which is not given along it. Choose another name: "
                    "xarray.DataArray(values, dims='run')."
                )


def _columns(
    argument: str,
    values: Mapping[SymbolOrName | tuple[SymbolOrName, ...], object],
    symbol_index: SymbolIndex,
    base: np.ndarray,
    axes: _SampleAxes,
    role: str,
) -> list[Column]:
    """Return the values of each symbol; the default is its entry in `base`."""
    columns: list[Column] = [((), np.asarray(value)) for value in base]
    if not values:
        return columns
    chosen = symbol_index.columns(values, argument).tolist()
    for column, value in zip(chosen, values.values(), strict=True):
        symbol = symbol_index.symbols[column]
        subject = f"`{argument}[{symbol}]`"
        if not hasattr(value, "dims") and real_array(value, subject).ndim == 0:
            columns[column] = ((), np.asarray(number(value, subject, finite=True)))
        else:
            attrs = {"role": role, "latex": latex_of(symbol)}
            columns[column] = axes.add(subject, value, axes.names.labels[symbol], attrs)
    return columns


def _check_assumptions(
    problem: Problem,
    columns: list[Column],
    kind: str,
    values: Mapping[SymbolOrName | tuple[SymbolOrName, ...], object],
    argument: str,
) -> None:
    """Warn once of samples that contradict assumptions."""
    assumed, warned = problem.definition.assumptions.get(kind), problem.settings.contradicted
    if not values or assumed is None or warned is None:
        return
    for column in {
        problem.definition.places[kind].find(key, argument) for key in values
    } & assumed.columns:
        samples = np.ravel(columns[column][1])
        rows = np.full((len(samples), len(columns)), np.nan)
        rows[:, column] = samples
        assumed.tell(rows, warned, f"`{argument}` for ", where=lambda row: " in one sample or more")


def _aligned(columns: Sequence[Column], dims: Mapping[str, int]) -> tuple[np.ndarray, ...]:
    """Return copies of the arrays with an axis for each of `dims`, in their order."""
    result = []
    for names, values in columns:
        order = [names.index(d) for d in dims if d in names]
        shape = [dims[d] if d in names else 1 for d in dims]
        result.append(np.array(np.transpose(values, order).reshape(shape)))
    return tuple(result)
