"""Whether initial conditions satisfy the constraints."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from pydy._errors import warn_user
from pydy._system.definition import Definition
from pydy._system.solving import constraint_names
from pydy.codegen.right_hand_side import RightHandSide

__all__ = ["check_start"]

_DIGITS = 1e-5  # six digits of each state, rounded


def check_start(
    definition: Definition,
    implementation: RightHandSide,
    exact: Callable[[], RightHandSide],
    t: float,
    x: np.ndarray,
    r: np.ndarray,
    p: np.ndarray,
) -> None:
    """Warn where a state is farther from the constraints than states of six digits are.

    A residual is compared with the sum of the products of its derivatives by the states and the
    rounding of these, a part of 1e-5 of each state, or of the largest coordinate or speed where
    that is larger.

    Parameters
    ----------
    definition : Definition
    implementation : RightHandSide
    exact : callable
        Gives one whose Jacobians can be compiled.
    t, x, r, p
    """
    equations = definition.equations
    counts = {"holonomic": len(equations.holonomic), "velocity": len(equations.velocity)}
    at = (np.array([t]), x[None], r[None], p)
    found = {
        name: implementation.compiled(name).evaluate(*at)[0][0] if count else np.empty(0)
        for name, count in counts.items()
    }
    residuals = np.concatenate(list(found.values()))
    if np.abs(residuals).max(initial=0.0) < 1e-12:  # NaN is not
        return
    n = len(equations.coordinates)
    size = np.abs(x)
    for part in (slice(n), slice(n, None)):
        size[part] = np.maximum(size[part], size[part].max(initial=0.0) or 1.0)
    slopes = np.concatenate(
        [
            exact().compiled_jacobian(name, "x").evaluate(*at)[0].reshape(count, len(x))
            for name, count in counts.items()
            if count
        ]
    )
    allowed = _DIGITS * (np.abs(slopes) @ size)
    far = np.flatnonzero(~(np.abs(residuals) <= allowed))
    if not far.size:
        return
    names = constraint_names(equations)
    worst = far[np.argsort(-np.abs(residuals[far]))][:3]
    told = "; ".join(f"{residuals[k]:.3g} in the {names[k]}" for k in worst)
    more = f"; and {far.size - 3} more" if far.size > 3 else ""
    warn_user(
        f"The initial conditions do not satisfy the constraints, and nothing will bring the motion "
        f"back onto them. The residuals at t = {t!r} are {told}{more}. Call "
        "`system.set_dependent_initial_conditions()` first."
    )
