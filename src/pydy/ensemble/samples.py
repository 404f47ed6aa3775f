"""What goes into an ensemble and what comes out: arrays along named dimensions, in blocks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from math import prod
from typing import Any

import numpy as np

from pydy._checks import shown
from pydy._optional import require

# -- What comes out, as an `xarray.Dataset` -------------------------------------------------------


PARAMETER, QUANTITY = "parameter", "quantity"  # the dimensions of sensitivities


@dataclass(frozen=True, eq=False)
class Variable:
    """An array with names for its axes."""

    dims: tuple[Any, ...]
    values: Any  # of NumPy or Dask
    attrs: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Form:
    """The dimensions, sizes and type that the results of all samples share."""

    sizes: dict[str, int]  # of the axes after those of the samples, in order
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
    """Raise if results do not match the forms of others: assigning them would broadcast them.

    The dimensions of the `samples` come first.
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
    coordinates: Mapping[str, Variable],
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


# -- What goes in ----------------------------------------------------------------------------------


Block = tuple[slice, ...]


@dataclass(frozen=True, eq=False)
class Samples:
    """Initial states, specifieds and constants of all samples."""

    dims: dict[str, int]  # names and sizes of the sample dimensions, in order
    # x, r, p: one array for each state, specified or constant, with one axis for each
    # dimension, of its size, or of size 1 where the value does not depend on it
    x: tuple[np.ndarray, ...]
    r: tuple[np.ndarray, ...]
    p: tuple[np.ndarray, ...]
    # Values that distinguish samples, for the labels of results.
    coordinates: dict[str, Variable] = field(default_factory=dict)

    @property
    def shape(self) -> tuple[int, ...]:
        """Sizes of the dimensions."""
        return tuple(self.dims.values())

    @property
    def size(self) -> int:
        """The number of samples."""
        return prod(self.shape)

    def of(self, block: Block) -> Samples:
        """Return the samples of a block."""
        dims = {d: s.stop - s.start for d, s in zip(self.dims, block, strict=True)}
        part = dict(zip(self.dims, block, strict=True))

        def cut(values: Sequence[np.ndarray]) -> tuple[np.ndarray, ...]:
            return tuple(
                v[tuple(s if k > 1 else slice(None) for s, k in zip(block, v.shape, strict=True))]
                for v in values
            )

        coordinates = {
            name: Variable(c.dims, c.values[tuple(part[d] for d in c.dims)], c.attrs)
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
        """Return the places and slices of blocks of some sizes along each dimension."""
        axes = [
            [slice(start, min(start + size, whole)) for start in range(0, whole, size)]
            for whole, size in zip(self.shape, sizes, strict=True)
        ]
        for place in product(*(range(len(axis)) for axis in axes)):
            yield place, tuple(axis[k] for axis, k in zip(axes, place, strict=True))


def block_sizes(dims: Mapping[str, int], chunks: Any, default: int) -> tuple[int, ...]:
    """Return the size of blocks along each dimension.

    A number is that of samples in a block, as nearly as whole rows of the last dimensions allow;
    None and 'auto' stand for the `default`. A mapping gives sizes by dimension, all of it where one
    is not named.
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
        return tuple(max(1, min(sizes[d], whole)) for d, whole in dims.items())
    if chunks is None or (isinstance(chunks, str) and chunks == "auto"):
        chunks = default
    _check_size(chunks, "`chunks`")
    left, result = int(chunks), []
    for whole in reversed(list(dims.values())):
        size = max(1, min(whole, left))
        result.append(size)
        left //= max(1, whole)
    return tuple(reversed(result))


def _check_size(size: Any, what: str) -> None:
    whole = isinstance(size, int | np.integer) and not isinstance(size, bool | np.timedelta64)
    if not whole or not 1 <= size < 2**62:
        raise ValueError(
            f"{what} must be a positive whole number of samples, got {shown(size)}. Or pass "
            "chunks='auto', or sizes by dimension such as {'sample': 1000}."
        )
