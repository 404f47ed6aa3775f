"""The times at which a Program switches by time alone (`pydy._graph.time_switches`)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, eq=False)
class SwitchTimes:
    """The times at which a Program switches, within an interval of time."""

    # (k, 3): each time, the last one before it at which rounding does not decide which side the
    # switch is on, and the first one after it
    rows: np.ndarray
    unresolved: int = 0  # changes of sign that are too many, or near, to be resolved
