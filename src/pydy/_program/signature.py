"""What a Program takes and returns."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import prod
from typing import TYPE_CHECKING

from pydy._forks import cached_property

if TYPE_CHECKING:
    import numpy as np


@dataclass(frozen=True)
class Block:
    """A named part of a Program's output, which is flat and row-major."""

    name: str
    shape: tuple[int, ...]
    start: int
    stop: int


@dataclass(frozen=True)
class Signature:
    """The sizes of a Program's inputs x, r and p, and the blocks of its output, one after another.

    Time t is always one number.
    """

    num_states: int
    num_specifieds: int
    num_constants: int
    blocks: tuple[Block, ...]

    @classmethod
    def of(
        cls, sizes: tuple[int, int, int], shapes: Iterable[tuple[str, tuple[int, ...]]]
    ) -> Signature:
        """Return the signature with these sizes of inputs, and blocks of these names and shapes."""
        blocks: list[Block] = []
        start = 0
        for name, shape in shapes:
            blocks.append(Block(name, tuple(shape), start, start + prod(shape)))
            start = blocks[-1].stop
        return cls(*sizes, tuple(blocks))

    @property
    def sizes(self) -> tuple[int, int, int]:
        """Numbers of states, specifieds and constants."""
        return self.num_states, self.num_specifieds, self.num_constants

    @cached_property
    def num_outputs(self) -> int:
        """Number of values in the flat output."""
        return self.blocks[-1].stop if self.blocks else 0

    def block(self, name: str) -> Block:
        """Return the block of that name."""
        return next(b for b in self.blocks if b.name == name)

    def by_block(self, out: np.ndarray) -> dict[str, np.ndarray]:
        """Return views of an output, or of many along the first axes, by the names of blocks."""
        return {b.name: out[..., b.start : b.stop].reshape(*out.shape[:-1], *b.shape)
                for b in self.blocks}  # fmt: skip
