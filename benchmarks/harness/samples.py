"""The same inputs for every peer."""

from __future__ import annotations

import numpy as np

from harness.model import Model


def samples(model: Model, count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return x (count, n), r (count, s) and p (k,): moderate states, the model's own constants."""
    rng = np.random.default_rng(20240607)
    n = len(model.coordinates) + len(model.speeds)
    x = rng.uniform(-0.6, 0.6, (count, n))
    r = rng.uniform(-1.0, 1.0, (count, len(model.specifieds)))
    return x, r, np.array(model.values)
