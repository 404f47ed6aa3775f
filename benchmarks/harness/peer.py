"""What a peer's worker must provide, and how it is asked."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

import numpy as np

from harness import frozen
from harness.samples import samples
from harness.serve import Repeated, serve, time_of


class Peer(ABC):
    """One way to evaluate x' for a frozen model.

    `build` compiles `self.model`; the functions that `scalar` and `batched` return evaluate all
    rows of `self.x` and `self.r`, one state at a time and as many at once as the peer can.
    """

    count = 4096

    def load(self, name: str, count: int = count) -> dict[str, int]:
        """Read a model, of which `count` states are evaluated."""
        self.count = count
        self.model = frozen.read(name)
        self.x, self.r, self.p = samples(self.model, self.count)
        self.runs: dict[str, Repeated] = {}
        self.warm_up()
        return frozen.sizes(self.model)

    def warm_up(self) -> None:  # noqa: B027 most need none
        """Initialise what is not particular to the model."""

    @abstractmethod
    def build(self) -> Any:
        """Translate and compile for one state at a time."""

    @abstractmethod
    def scalar(self) -> Any:
        """Return a function that evaluates all samples one by one, in a native loop."""

    @abstractmethod
    def batched(self) -> Any:
        """Return a function that evaluates all samples, vectorised, in one thread."""

    @abstractmethod
    def values(self) -> np.ndarray:
        """Return x' of all samples, as the latest function called left them, shape (m, n)."""

    # -- requests -------------------------------------------------------------------------------

    def build_time(self) -> float:
        """Time translation and compilation, from SymPy expressions, nothing cached."""
        return time_of(self.build)

    def start(self, kind: str) -> list[list[float]]:
        """Get "scalar" or "batched" ready; returns x' of some samples to be compared."""
        function = getattr(self, kind)()
        function()
        self.runs[kind] = Repeated(function, least=1e-4)
        return np.asarray(self.values())[:: self.count // 16].tolist()

    def run(self, kind: str) -> float:
        """Return the seconds for one state: the least of short runs.

        What shares a core with other programs has it alone for some of them.
        """
        return min(self.runs[kind]() for _ in range(200)) / self.count


def serve_peer(peer: Peer) -> None:
    """Answer requests until the driver is done."""
    serve({name: getattr(peer, name) for name in ("load", "build_time", "start", "run")})
