"""Input and output of an ensemble: arrays along named dimensions, in blocks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._checks import shown
from pydy._optional import require
from pydy.solvers import Outcome

if TYPE_CHECKING:
    from numpy.typing import DTypeLike
    from xarray import Dataset

# -- Output, an `xarray.Dataset` ------------------------------------------------------------------


PARAMETER, QUANTITY = "parameter", "quantity"  # the dimensions of sensitivities


@dataclass(frozen=True, eq=False)
class LabelledArray:
    """An array with names for its axes."""

    dims: tuple[Any, ...]
    values: Any  # of NumPy or Dask
    attrs: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class ArrayForm:
    """The dimensions, sizes and type that the results of all samples share."""

    sizes: dict[str, int]  # of the axes after those of the samples, in order
    dtype: np.dtype[np.generic]

    @classmethod
    def from_array(
        cls, dims: Sequence[object], shape: Sequence[int], dtype: DTypeLike, first: int
    ) -> ArrayForm:
        """Return the form of an array whose axes before `first` are those of samples."""
        return cls(dict(zip(map(str, dims[first:]), shape[first:], strict=True)), np.dtype(dtype))

    def __str__(self) -> str:
        return f"{self.dtype} along {self.sizes}" if self.sizes else f"{self.dtype}"


def check_forms(
    results: Mapping[str, LabelledArray],
    expected: Mapping[str, ArrayForm],
    samples: Sequence[object],
) -> None:
    """Raise an error if results do not match the forms of other blocks.

    An assignment would broadcast them. The dimensions of the `samples` come first.
    """
    rule = "`reduce` must return the same variables for all blocks of samples"
    for name in dict.fromkeys((*expected, *results)):
        if name not in results or name not in expected:
            raise ValueError(f"{rule}: `{name}` exists for some samples only.")
        v, form = results[name], expected[name]
        actual = ArrayForm.from_array(v.dims, v.values.shape, v.values.dtype, len(samples))
        if list(actual.sizes.items()) != list(form.sizes.items()) or not np.can_cast(
            actual.dtype, form.dtype
        ):
            raise ValueError(f"{rule}: `{name}` is {form} for some, {actual} for others.")


def to_dataset(
    variables: Mapping[str, LabelledArray],
    coordinates: Mapping[str, LabelledArray],
    times: np.ndarray,
    attrs: Mapping[str, object] | None = None,
    labels: Mapping[str, Sequence[str]] | None = None,
) -> Dataset:
    """Return the Dataset of some variables.

    Times, and labels of other dimensions, are included only if a variable has the dimension.
    """
    xarray = require("xarray", "ensemble", "System.integrate_ensemble")
    coords: dict[str, object] = {
        name: (c.dims, c.values, dict(c.attrs)) for name, c in coordinates.items()
    }
    if any("time" in v.dims for v in variables.values()):
        coords["time"] = ("time", times)
    used_dims = {d for v in variables.values() for d in v.dims}
    for dim, names in (labels or {}).items():
        if dim in used_dims:
            coords[dim] = (dim, list(names))
    data = {name: (v.dims, v.values, dict(v.attrs)) for name, v in variables.items()}
    dataset: Dataset = xarray.Dataset(data, coords, dict(attrs or {}))
    return dataset


def after_end(results: Dataset, times: np.ndarray) -> np.ndarray:
    """Return which of m times are after the event that ended each sample's motion, (…, m)."""
    ended = np.isin(results["status"].values, (Outcome.TERMINATED, Outcome.EVENTS_ACCUMULATE))
    late: np.ndarray = ended[..., None] & (times > results["end_time"].values[..., None])
    return late


# -- Input -----------------------------------------------------------------------------------------


Block = tuple[slice, ...]


@dataclass(frozen=True, eq=False)
class Samples:
    """Initial states, specifieds and constants of all samples."""

    dims: dict[str, int]  # names and sizes of the sample dimensions, in order
    # x, r, p: one array for each state, specified or constant, with one axis for each dimension,
    # which has the dimension's size, or 1 if the value does not vary along it
    x: tuple[np.ndarray, ...]
    r: tuple[np.ndarray, ...]
    p: tuple[np.ndarray, ...]
    # Values that distinguish samples, for the labels of results.
    coordinates: dict[str, LabelledArray] = field(default_factory=dict)

    @property
    def shape(self) -> tuple[int, ...]:
        """Sizes of the dimensions."""
        return tuple(self.dims.values())

    @property
    def size(self) -> int:
        """The number of samples."""
        return prod(self.shape)

    def in_block(self, block: Block) -> Samples:
        """Return the samples of a block."""
        dims = {d: s.stop - s.start for d, s in zip(self.dims, block, strict=True)}
        part = dict(zip(self.dims, block, strict=True))

        def cut(values: Sequence[np.ndarray]) -> tuple[np.ndarray, ...]:
            return tuple(
                v[tuple(s if k > 1 else slice(None) for s, k in zip(block, v.shape, strict=True))]
                for v in values
            )

        coordinates = {
            name: LabelledArray(c.dims, c.values[tuple(part[d] for d in c.dims)], c.attrs)
            for name, c in self.coordinates.items()
        }
        return Samples(dims, cut(self.x), cut(self.r), cut(self.p), coordinates)

    def rows(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return x (m, n), r (m, s) and p (m, k), the last dimension fastest."""
        shape, size = self.shape, self.size

        def table(values: Sequence[np.ndarray]) -> np.ndarray:
            rows = np.empty((size, len(values)))
            for k, v in enumerate(values):
                rows[:, k] = np.broadcast_to(v, shape).reshape(-1)
            return rows

        return table(self.x), table(self.r), table(self.p)

    def blocks(self, sizes: Sequence[int]) -> Iterator[tuple[tuple[int, ...], Block]]:
        """Return the positions and slices of all blocks, for block sizes along each dimension."""
        axes = [
            [slice(start, min(start + size, length)) for start in range(0, length, size)]
            for length, size in zip(self.shape, sizes, strict=True)
        ]
        for position in product(*(range(len(axis)) for axis in axes)):
            yield position, tuple(axis[k] for axis, k in zip(axes, position, strict=True))


def block_sizes(
    dims: Mapping[str, int], chunks: int | str | Mapping[str, int] | None, default: int
) -> tuple[int, ...]:
    """Return the size of blocks along each dimension.

    A number is the largest number of samples in a block of complete rows of the last dimensions.
    None and 'auto' mean the `default`. A mapping contains sizes by dimension; a dimension that it
    does not name is not divided.
    """
    if isinstance(chunks, Mapping):
        unknown = [d for d in chunks if d not in dims]
        if unknown:
            raise ValueError(
                f"`chunks` has a size for `{unknown[0]}`, which is not one of the sample "
                f"dimensions: {', '.join(dims) or 'there are none'}."
            )
        sizes = {d: chunks.get(d, size) for d, size in dims.items()}
        for d, size in sizes.items():
            _check_size(size, f"`chunks[{d!r}]`")
        return tuple(max(1, min(sizes[d], length)) for d, length in dims.items())
    if chunks is None or (isinstance(chunks, str) and chunks == "auto"):
        chunks = default
    _check_size(chunks, "`chunks`")
    remaining, result = int(chunks), []
    for length in reversed(list(dims.values())):
        size = max(1, min(length, remaining))
        result.append(size)
        remaining //= max(1, length)
    return tuple(reversed(result))


def _check_size(size: Any, subject: str) -> None:
    is_integer = isinstance(size, int | np.integer) and not isinstance(size, bool | np.timedelta64)
    if not is_integer or not 1 <= size < 2**62:
        raise ValueError(
            f"{subject} must be a positive whole number of samples, got {shown(size)}. Or pass "
            "chunks='auto', or sizes by dimension such as {'sample': 1000}."
        )
