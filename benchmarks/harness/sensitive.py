"""What is differentiated when sensitivities are compared."""

from __future__ import annotations

import numpy as np

from harness.model import Model

COLUMNS = 8  # by the first constants of a model


def parameters(model: Model) -> list[int]:
    """Return the places of the constants that a model's motion is differentiated by."""
    return list(range(min(COLUMNS, len(model.constants))))


def joined(state: np.ndarray, columns: np.ndarray) -> np.ndarray:
    """Return a state (n,) and its derivatives (n, k) as every worker answers them."""
    return np.concatenate([np.ravel(state), np.ravel(columns)])
