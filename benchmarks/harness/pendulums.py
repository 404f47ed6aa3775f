"""The ensemble of pendulums on a cart: random states and constants, 5 s at 51 points."""

from __future__ import annotations

import numpy as np

TIMES = np.linspace(0.0, 5.0, num=51)


def samples(links: int, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return states (count, 2 (n + 1)) and constants (count, 2 n + 2)."""
    rng = np.random.default_rng(links)
    x = rng.uniform(-1.0, 1.0, (count, 2 * (links + 1)))
    return x, rng.uniform(0.5, 1.5, (count, 2 * links + 2))
