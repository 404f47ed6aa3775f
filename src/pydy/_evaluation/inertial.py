"""Inertial parameters, in which forces are linear, and those that a motion identifies."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from sympy.physics.mechanics import RigidBody

from pydy._evaluation.dynamics import Quantity, bodies_of, components_of
from pydy._mechanics import BodyDynamics, Equations, Multibody, checked_vector
from pydy._names import unique_names
from pydy._rank import ROUNDED, equilibrated, independent_columns

if TYPE_CHECKING:
    from sympy.physics.mechanics import Vector

    from pydy._mechanics import SymbolicNodes

_COMPONENTS = ("m", "mx", "my", "mz", "Ixx", "Iyy", "Izz", "Ixy", "Iyz", "Ixz")
_POWERS = np.array([0, 1, 1, 1, 2, 2, 2, 2, 2, 2])  # of length, in their units


def _parameter_names(body: Multibody) -> list[str]:
    return [
        f"{component} of {name}"
        for name, item in zip(unique_names(body.bodies), body.bodies, strict=True)
        for component in (_COMPONENTS if isinstance(item, RigidBody) else _COMPONENTS[:1])
    ]


def _per_length(columns: np.ndarray, powers: np.ndarray) -> float:
    """Return the median ratio of entries whose units differ by one power of length."""
    sizes = [np.abs(columns[:, powers == k]).max(axis=1, initial=0.0) for k in range(3)]
    samples = []
    for i, j in ((0, 1), (1, 2), (0, 2)):
        nonzero = (sizes[i] > 0.0) & (sizes[j] > 0.0)
        samples.append((sizes[j][nonzero] / sizes[i][nonzero]) ** (1.0 / (j - i)))
    ratios = np.concatenate(samples)
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


def inertial_parameters(equations: Equations) -> Quantity:
    """Return mass, first moments and inertia of each body."""
    body = bodies_of(equations)
    names = _parameter_names(body)
    return Quantity(
        "inertial parameters",
        (),
        (len(names),),
        lambda dynamics: dynamics.inertial_parameters(body),
        names,
    )


def regressor(equations: Equations, acceleration: Vector | None) -> Quantity:
    """Return the matrix that is multiplied by the inertial parameters in the forces of a motion.

    Gravity is the loads' acceleration, or the given one.
    """
    if acceleration is not None:
        checked_vector(acceleration, "`acceleration`")
    body = bodies_of(equations)
    n, count = len(equations.speeds), len(_parameter_names(body))

    def expressions(dynamics: BodyDynamics) -> SymbolicNodes:
        matrix = dynamics.regressor(body, acceleration)
        if matrix is None:
            raise ValueError(
                "The loads at the mass centres do not tell which way gravity pulls, which the "
                "forces are linear in the masses with: no acceleration times the mass is among "
                f"them for all bodies. Give it: `acceleration=-g*{body.frame}.z`."
            )
        return matrix

    return Quantity("regressor", components_of(acceleration), (n, count), expressions, (), range(n))


def base_parameters(equations: Equations, columns: np.ndarray) -> BaseParameters:
    """Return the parameters that values of the regressor, (…, n, k), identify."""
    columns = columns.reshape(-1, columns.shape[-1])
    if not (finite := np.isfinite(columns).all(axis=1)).all():
        sample = int(np.argmin(finite)) // len(equations.speeds)
        raise ValueError(
            "The regressor must be finite for all samples; it is not for "
            f"{len(finite) - int(finite.sum())} of its rows, the first of them of sample "
            f"{sample}. Leave out samples whose `q`, `v` or `a` is NaN or infinite."
        )
    powers = np.concatenate([_POWERS[: 10 if isinstance(item, RigidBody) else 1]
                             for item in bodies_of(equations).bodies])  # fmt: skip
    lengths = _per_length(columns, powers) ** powers
    scaled, _, units = equilibrated(columns / lengths, exact=True)
    units = units / lengths
    independent = sorted(independent_columns(scaled))
    matrix = np.linalg.lstsq(scaled[:, independent], scaled, rcond=None)[0]
    matrix[np.abs(matrix) <= ROUNDED] = 0.0
    return BaseParameters(independent, matrix * units[0, independent, None] / units)
