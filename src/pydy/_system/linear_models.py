"""Linear models of a System; the work is in `pydy.analysis.linear`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from pydy._system.setup import Setup
from pydy.analysis.linear import LinearModel, linearize


class LinearModels(Setup):
    """Linear models of small motions."""

    @np.errstate(under="ignore")  # shares of sizes may be zero
    def linearize(
        self,
        at: Any = None,
        t: Any = None,
        *,
        inputs: Iterable[Any] | None = None,
        outputs: Iterable[Any] | None = None,
    ) -> LinearModel:
        """Return the linear model of small motions that satisfy the constraints.

        Parameters
        ----------
        at : array_like, shape (n,) or (m, n), dict or Equilibrium, optional
            States; the initial conditions by default. For several states, such as along a
            trajectory, each matrix has an additional first axis. A dictionary replaces some of the
            initial conditions, by symbol or name. An Equilibrium also provides the constants and
            specifieds that were found or given.
        t : float or array_like, shape (m,), optional
            As in `evaluate_ode`.
        inputs : iterable of specifieds or names, optional
            All by default. If a specified is given as an expression or a function, the input is an
            addition to its value, and its feedback is part of A. Functions are differentiated
            numerically.
        outputs : iterable of states, outputs or names, optional
            All states by default.

        Returns
        -------
        LinearModel

        Raises
        ------
        ValueError
            The system has no such name, the configuration is singular, or the equations are not
            finite there.

        Warns
        -----
        PyDyUserWarning
            A state does not satisfy the constraints; or a load or rate has a kink or a jump there,
            of which the model knows one side.

        Examples
        --------
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart()
        >>> model = system.linearize(outputs=['q1'])
        >>> model.A[3].round(6)
        array([0., 2., 0., 0.])
        >>> float(model.eigenvalues.real.max().round(6))
        1.414214
        """
        return linearize(self._now(), at, t, inputs=inputs, outputs=outputs)
