"""Inertial parameters: what forces are linear in, and what a motion tells of them."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from sympy.physics.mechanics import RigidBody

from pydy._mechanics.inverse import Known, parameters, regressor
from pydy._mechanics.reader import Multibody
from pydy._names import unique_names
from pydy._rank import ROUNDED, equilibrated, independent_columns
from pydy._system.dynamics import Dynamics, Quantity, all_accelerations, bodies_of

_COMPONENTS = ("m", "mx", "my", "mz", "Ixx", "Iyy", "Izz", "Ixy", "Iyz", "Ixz")
_POWERS = np.array([0, 1, 1, 1, 2, 2, 2, 2, 2, 2])  # of length, in their units


def _parameter_names(body: Multibody) -> list[str]:
    return [
        f"{component} of {name}"
        for name, item in zip(unique_names(body.bodies), body.bodies, strict=True)
        for component in (_COMPONENTS if isinstance(item, RigidBody) else _COMPONENTS[:1])
    ]


def _per_length(columns: np.ndarray, powers: np.ndarray) -> float:
    """Return how much larger entries are of parameters with one more power of length."""
    sizes = [np.abs(columns[:, powers == k]).max(axis=1, initial=0.0) for k in range(3)]
    found = []
    for i, j in ((0, 1), (1, 2), (0, 2)):
        both = (sizes[i] > 0.0) & (sizes[j] > 0.0)
        found.append((sizes[j][both] / sizes[i][both]) ** (1.0 / (j - i)))
    ratios = np.concatenate(found)
    return float(np.median(ratios)) if len(ratios) else 1.0


class BaseParameters(NamedTuple):
    """Combinations of inertial parameters that forces depend on; no other can be identified.

    Attributes
    ----------
    places : list of int
        Columns of the regressor that are independent.
    matrix : ndarray, shape (b, k)
        The base parameters are ``matrix @ parameters``, and the forces
        ``regressor[..., places] @ (matrix @ parameters)``.
    """

    places: list[int]
    matrix: np.ndarray


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
        body = bodies_of(self._equations)
        names = _parameter_names(body)
        made = Quantity(
            "inertial parameters", (), (len(names),), lambda known: parameters(body, known), names
        )
        values = self._evaluated(made, (None, None, np.zeros(0), None), None, p, None)
        return dict(zip(names, values.tolist(), strict=True))

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
        equations, body = self._equations, bodies_of(self._equations)
        n, names = len(equations.speeds), _parameter_names(body)
        rates = all_accelerations(a, equations)

        def expressions(known: Known) -> Any:
            found = regressor(body, known)
            if found is None:
                raise ValueError(
                    "The loads at the mass centres do not tell which way gravity pulls, which the "
                    "forces are linear in the masses with: write it as `-m*g*N.z` at each."
                )
            return found

        made = Quantity("regressor", (), (n, len(names)), expressions, (), range(n))
        return self._evaluated(made, (q, v, rates, t), r, p, None)

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
        columns = self.regressor(q, v, a, t, r=r, p=p)
        columns = columns.reshape(-1, columns.shape[-1])
        if not (finite := np.isfinite(columns).all(axis=1)).all():
            sample = int(np.argmin(finite)) // len(self._equations.speeds)
            raise ValueError(
                "The regressor must be finite for all samples; it is not for "
                f"{len(finite) - int(finite.sum())} of its rows, the first of them of sample "
                f"{sample}. Leave out samples whose `q`, `v` or `a` is NaN or infinite."
            )
        powers = np.concatenate([_POWERS[: 10 if isinstance(item, RigidBody) else 1]
                                 for item in bodies_of(self._equations).bodies])  # fmt: skip
        lengths = _per_length(columns, powers) ** powers
        scaled, _, units = equilibrated(columns / lengths, exact=True)
        units = units / lengths
        places = sorted(independent_columns(scaled))
        matrix = np.linalg.lstsq(scaled[:, places], scaled, rcond=None)[0]
        matrix[np.abs(matrix) <= ROUNDED] = 0.0
        return BaseParameters(places, matrix * units[0, places, None] / units)
