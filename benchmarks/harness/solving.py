"""What a solver's worker must provide, and how it is asked."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any

import numpy as np

from harness import frozen
from harness.scenarios import scenario
from harness.serve import Repeated, serve, time_of


class SolverPeer(ABC):
    """One package's solvers on a frozen model.

    Attributes
    ----------
    costly : bool
        Whether every tolerance takes a compilation, so that few are tried.
    """

    costly = False

    def load(self, name: str) -> dict[str, Any]:
        """Read a model and compile it; returns the methods there are, and the seconds it took."""
        self.model = frozen.read(name)
        self.scenario = scenario(self.model)
        self.values = np.array(self.model.values)
        self._made: dict[tuple[str, float], Callable[[], np.ndarray]] = {}
        self._timed: dict[tuple[str, float], Repeated] = {}
        self.warm_up()
        seconds = time_of(self.build)
        return {"methods": self.methods(), "costly": self.costly, "seconds": seconds}

    def warm_up(self) -> None:  # noqa: B027 most need none
        """Initialise what is not particular to the model."""

    @abstractmethod
    def build(self) -> None:
        """Translate and compile what all tolerances share."""

    @abstractmethod
    def methods(self) -> list[str]:
        """Return the methods to be tried."""

    @abstractmethod
    def solver(self, method: str, tolerance: float) -> Callable[[], np.ndarray]:
        """Return a function of nothing that integrates, and gives the state at the end.

        `tolerance` is both relative and absolute.
        """

    # -- requests -------------------------------------------------------------------------------

    def reach(self, method: str, tolerance: float) -> dict[str, Any]:
        """Integrate once; returns the state at the end, and the seconds of the preparation."""

        def make() -> None:
            self._made[method, tolerance] = self.solver(method, tolerance)

        built = time_of(make)
        run = self._made[method, tolerance]
        state = np.array(run(), dtype=float)
        if not np.isfinite(state).all():
            raise RuntimeError("the state at the end is not finite")
        return {"state": state.tolist(), "built": built, "seconds": time_of(run)}

    def time(self, method: str, tolerance: float) -> float:
        """Return the seconds of one integration that was prepared before."""
        key = method, tolerance
        if key not in self._timed:
            self._timed[key] = Repeated(self._made[key])
        return self._timed[key]()


def serve_solver(peer: SolverPeer) -> None:
    """Answer requests until the driver is done."""
    serve({name: getattr(peer, name) for name in ("load", "reach", "time")})
