"""Sizes of the blocks that an ensemble is computed in, each with its reason."""

from __future__ import annotations

BLOCK_BYTES = 8e6
"""Results in a block of an ensemble, about: it fits the cache that processors share."""

SMALLEST_BLOCK = 64
"""Samples in a block: with fewer, lanes idle at its end for too long a part of the time."""

LARGEST_BLOCK = 8192
"""Samples in a block: with more, an interrupt waits, and threads end at different times."""

ONE_BY_ONE = 8
"""Samples in a block that takes long: an interrupt keeps the finished ones."""
