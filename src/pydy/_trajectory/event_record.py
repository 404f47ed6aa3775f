"""EventRecord: an event as a simulation met it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

__all__ = ["EventRecord"]


@dataclass(frozen=True, eq=False)
class EventRecord:
    """An event that happened at one instant of a simulation.

    Attributes
    ----------
    time : float
    name : str
    index : int
        Its place among the events that were watched.
    before, after : ndarray, shape (n,)
        The states on both sides; the same without a reset.
    time_sensitivity : ndarray, shape (k,), or None
        Derivatives of the event's time by the parameters, of a simulation with sensitivities.
    sensitivity_before, sensitivity_after : ndarray, shape (n, k), or None
        Derivatives of the states on both sides, at a fixed time.
    """

    time: float
    name: str
    index: int
    before: np.ndarray
    after: np.ndarray
    time_sensitivity: np.ndarray | None = None
    sensitivity_before: np.ndarray | None = None
    sensitivity_after: np.ndarray | None = None

    def __repr__(self) -> str:
        """Return what happened and when; the states are left out."""
        return f"EventRecord({self.name!r} at t = {self.time!r})"
