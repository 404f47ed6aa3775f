"""Holonomic constraints whose derivatives are missing among the velocity constraints.

The equations of motion are then those of a system without these constraints. An evaluation warns
once; an integration raises if the motion leaves the constraints.
"""

from __future__ import annotations

import numpy as np

from pydy._errors import warn_user
from pydy._judges.constraint_drift import rates
from pydy._problem import Problem
from pydy._rank import HALF


def warn_of_missing_derivatives(problem: Problem) -> None:
    """Warn of a holonomic constraint that neither velocity constraints nor kinematics imply."""
    equations = problem.definition.equations
    undifferentiated = equations.constraints.undifferentiated_holonomic
    if not undifferentiated:
        return
    unenforced = [k for k in undifferentiated if not _implied(problem, k)]
    if not unenforced:
        return
    k, holonomic = unenforced[0], equations.constraints.holonomic
    count = len(unenforced) - 1
    others_text = f" {count} other holonomic constraints neither." if count else ""
    warn_user(
        f"No velocity constraint keeps the holonomic constraint {k}, `{holonomic[k]}` = "
        f"0: its derivative is missing, and the equations of motion are those of a system without "
        f"this constraint.{others_text} Give KanesMethod the derivative in `velocity_constraints` "
        "and a speed in `u_dependent`, or use a pydy.mechanics.Definition, which differentiates it."
    )


def _implied(problem: Problem, index: int) -> bool:
    """Return whether velocity constraints imply a holonomic one with the numbers of the System.

    They may do so with these constants although they did not with random ones. At a singular
    position, where the constraint has no derivative, the answer is False.
    """
    equations, at = problem.definition.equations, problem.at(np.array([problem.t]), problem.x[None])
    values = at.interpret(rates)
    unenforced = equations.constraints.unenforced_holonomic
    slope = values["slopes"].reshape(len(unenforced), -1)[unenforced.index(index)]
    rows = values["rows"].reshape(-1, slope.size)
    size = np.linalg.norm(slope)
    if not (np.isfinite(slope).all() and np.isfinite(rows).all() and size > 0.0 and rows.size):
        return False
    shares = np.linalg.lstsq(rows.T, slope, rcond=HALF)[0]
    return bool(np.linalg.norm(slope - shares @ rows) <= HALF * size)
