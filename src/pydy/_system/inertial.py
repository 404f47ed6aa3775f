"""Inertial parameters of a System: what forces are linear in, and what a motion tells of them."""

from __future__ import annotations

from typing import Any

import numpy as np

from pydy._simulation.dynamics import all_accelerations, evaluate
from pydy._simulation.inertial import (
    BaseParameters,
    base_parameters,
    inertial_parameters,
    regressor,
)
from pydy._system.dynamics import Dynamics


class InertialParameters(Dynamics):
    """Regressors, and the identifiable combinations of masses and inertias."""

    def inertial_parameters(self, *, p: Any = None) -> dict[str, float]:
        """Return mass, first moments and inertia of each body, as `regressor` takes them.

        Parameters
        ----------
        p
            As in `evaluate_ode`.

        Returns
        -------
        dict
            ``'m of arm'`` (kg); ``'mx of arm'`` and so on, the mass times the way to the mass
            centre from where the model has it (kg m), which are zero; ``'Ixx of arm'`` and so on,
            the inertia about that point in the axes of the body (kg m²). A Particle has its mass
            alone.
        """
        made = inertial_parameters(self._equations)
        values = self._evaluated(made, None, None, None, p, None)
        return dict(zip(made.rows, values.tolist(), strict=True))

    def regressor(
        self,
        q: Any = None,
        v: Any = None,
        a: Any = None,
        t: Any = None,
        *,
        r: Any = None,
        p: Any = None,
    ) -> np.ndarray:
        """Return the matrix Y that is multiplied by the inertial parameters in `inverse_dynamics`.

        The forces of a motion are Y π, and those that balance loads other than gravity. They are
        linear in the parameters π of `inertial_parameters`, whatever constants the model has.

        Parameters
        ----------
        q, v, a, t, r, p
            As in `inverse_dynamics`; here a has all speeds.

        Returns
        -------
        ndarray, shape (n, k) or (m, n, k)
            One column for each parameter.

        Raises
        ------
        ValueError
            Gravity cannot be found from the loads; see `gravity`. Or a mass may change with time.

        Examples
        --------
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1)
        >>> system.regressor([0.0, 0.0], [0.0, 0.0], [1.0, 0.0])
        array([[ 1.,  1.],
               [ 0., -1.]])
        >>> system.inertial_parameters()
        {'m of Pa0': 1.0, 'm of Pa1': 1.0}
        """
        made, at = regressor(self._equations), (q, v, all_accelerations(a, self._equations), t)
        return evaluate(self._now(constants=p), made, at, r, p, None, self._values)

    def base_parameters(
        self, q: Any, v: Any, a: Any, t: Any = None, *, r: Any = None, p: Any = None
    ) -> BaseParameters:
        """Return the combinations of inertial parameters that some motions determine.

        Parameters
        ----------
        q, v, a, t, r, p
            As in `regressor`: many states, measured ones or random ones.

        Returns
        -------
        BaseParameters
            ``places``, the independent columns of the regressor, and ``matrix``.

        Examples
        --------
        >>> import numpy as np
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1)
        >>> q, v, a = np.random.default_rng(0).normal(size=(3, 9, 2))
        >>> system.base_parameters(q, v, a).places
        [0, 1]
        """
        return base_parameters(self._equations, self.regressor(q, v, a, t, r=r, p=p))
