"""The arrays of a run as one table of addresses, which is all that compiled code is given.

A table has a row for each field of its parts (named tuples of `layout` here and in `lanes`), in
their order. In C it is a struct (`pydy.solvers.core.declarations`).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain

import numpy as np

from pydy._array_layout import address

__all__ = ["rows_of", "table_of"]


def rows_of(arrays: Iterable[np.ndarray]) -> list[int]:
    """Return the rows of contiguous arrays: address, length, and columns, of a vector one."""
    rows: list[int] = []
    for array in arrays:
        rows += (address(array), len(array), array.shape[1] if array.ndim == 2 else 1)
    return rows


def table_of(*parts: Sequence[int]) -> np.ndarray:
    """Return the table of all rows. Who makes it keeps the arrays alive."""
    return np.array([*chain.from_iterable(parts)], dtype=np.int64)
