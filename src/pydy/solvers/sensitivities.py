"""Sensitivities that a solver integrates beside the state, as it sees them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

__all__ = ["CompiledSensitivities"]


@dataclass(frozen=True, eq=False)
class CompiledSensitivities:
    """What a solver needs to know of a state with columns of sensitivities after it.

    Attributes
    ----------
    states : int
        Number of states, n; they come first.
    columns : int
        Number of columns, k; S follows the state row after row.
    scales : ndarray, shape (k,), or None
        The sizes of the parameters, where the step control looks at the sensitivities too: the
        error allowed in ∂x/∂θ is then that of x over the size of θ. Otherwise it looks at the
        states alone, and the steps are those of an integration without sensitivities.
    """

    states: int
    columns: int
    scales: np.ndarray | None = None

    def tolerances(self, rtol: np.ndarray, atol: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the tolerances (n (1 + k),) of states and sensitivities from those of states.

        The error norm is a root mean square over all of them. What it is not to see has an infinite
        tolerance, and the others make up for their number.
        """
        n, k = self.states, self.columns
        if self.scales is not None:
            every = (atol[:, None] / self.scales).ravel()
            return np.concatenate([rtol, np.repeat(rtol, k)]), np.concatenate([atol, every])
        share = (1.0 + k) ** -0.5
        return (
            np.concatenate([share * rtol, np.ones(n * k)]),
            np.concatenate([share * atol, np.full(n * k, np.inf)]),
        )
