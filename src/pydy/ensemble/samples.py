"""The numbers of an ensemble, along named dimensions, and their division into blocks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from math import prod
from typing import Any

import numpy as np

from pydy._checks import shown

__all__ = ["Block", "Coordinate", "Samples", "block_sizes"]

Block = tuple[slice, ...]


@dataclass(frozen=True, eq=False)
class Coordinate:
    """Values that distinguish samples, for the labels of results.

    Attributes
    ----------
    dims : tuple of str
    values : ndarray
    attrs : dict
    """

    dims: tuple[str, ...]
    values: np.ndarray
    attrs: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Samples:
    """Initial states, specifieds and constants of all samples.

    Attributes
    ----------
    dims : dict of str to int
        Names and sizes of the sample dimensions, in order.
    x, r, p : tuple of ndarray
        One array for each state, specified or constant, with one axis for each dimension, of its
        size, or of size 1 where the value does not depend on it.
    coordinates : dict of str to Coordinate
    """

    dims: dict[str, int]
    x: tuple[np.ndarray, ...]
    r: tuple[np.ndarray, ...]
    p: tuple[np.ndarray, ...]
    coordinates: dict[str, Coordinate] = field(default_factory=dict)

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
            name: Coordinate(c.dims, c.values[tuple(part[d] for d in c.dims)], c.attrs)
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

    Parameters
    ----------
    dims : mapping of str to int
    chunks : None, 'auto', int, or mapping of str to int
        A number is that of samples in a block, as nearly as whole rows of the last dimensions
        allow; a mapping gives sizes by dimension, all of it where one is not named.
    default : int
        The number that None and 'auto' stand for.
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
