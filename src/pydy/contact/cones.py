"""Forces within Coulomb's cones: by relaxation, and the innermost where rows depend on each other.

References
----------
M. Jean, The non-smooth contact dynamics method, Computer Methods in Applied Mechanics and
Engineering 177 (1999), 235–257: Gauss and Seidel's iteration over contacts.
J. E. Kelley, The cutting-plane method for solving convex programs, Journal of the Society for
Industrial and Applied Mathematics 8 (1960), 703–712.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.optimize import linprog

from pydy._rank import ROUNDED
from pydy.contact.tuning import CUTS, FEASIBLE, SWEEPS, TILT

_TOLERANCES = ("primal_feasibility_tolerance", "dual_feasibility_tolerance")


@dataclass(frozen=True)
class Cone:
    """|y_t| ≤ μ y_n of some unknowns y; without tangential ones y_n ≥ 0."""

    normal: int | None  # its unknown; None if the normal force is known
    tangent: tuple[int, ...]
    hold: float  # μ, or the largest friction if the normal force is known

    def margin(self, y: np.ndarray) -> float:
        """Return by how much the inequalities hold."""
        press = 1.0 if self.normal is None else float(y[self.normal])
        least = np.inf if self.normal is None else press
        if not self.tangent:
            return least
        return min(least, self.hold * press - float(np.linalg.norm(y[list(self.tangent)])))


def innermost(y: np.ndarray, null: np.ndarray, cones: Sequence[Cone], size: float) -> np.ndarray:
    """Return y + Z w with a least margin of all cones of half the largest possible, or `size`.

    The linear program has planes that touch the cones, so that its margin is a bound; where its
    solution is outside a cone, the plane there is added. Of equal solutions, one with small normal
    forces is taken.
    """
    number = null.shape[1]
    unit = size or 1.0
    rows: list[np.ndarray] = []
    bounds: list[float] = []
    pressing = [c.normal for c in cones if c.normal is not None]
    cost = np.append(TILT / max(1, len(pressing)) * null[pressing].sum(axis=0), -1.0)

    def cut(cone: Cone, normal: float, along: Any = ()) -> None:
        """Add τ ≤ normal y_n − along · y_t."""
        row, bound = np.zeros(number + 1), 0.0
        row[-1] = 1.0
        if cone.normal is None:
            bound += normal
        else:
            row[:-1] -= normal * null[cone.normal]
            bound += normal * y[cone.normal]
        for k, share in zip(cone.tangent, along, strict=False):
            row[:-1] += share * null[k]
            bound -= share * y[k]
        rows.append(row)
        bounds.append(bound / unit)

    for cone in cones:
        if cone.normal is not None:
            cut(cone, 1.0)
        for axis in np.eye(len(cone.tangent)):
            cut(cone, cone.hold, axis)
            cut(cone, cone.hold, -axis)
    best, most = y, min((c.margin(y) for c in cones), default=0.0)
    for _ in range(CUTS):
        found = linprog(
            cost, A_ub=np.array(rows), b_ub=np.array(bounds),
            bounds=[(None, None)] * number + [(None, 1.0)], method="highs-ds",
            options=dict.fromkeys(_TOLERANCES, FEASIBLE),
        )  # fmt: skip
        if found.x is None:
            break
        tried = y + unit * (null @ found.x[:-1])
        margin = min(c.margin(tried) for c in cones)
        if margin > most:
            best, most = tried, margin
        bound = unit * found.x[-1]
        if bound < 0.0 or most >= bound / 2.0 or bound - most <= unit * ROUNDED:
            break
        for cone in cones:
            if len(cone.tangent) == 2 and cone.margin(tried) < bound:
                along = tried[list(cone.tangent)]
                if own := float(np.linalg.norm(along)):  # else the first planes bound it
                    cut(cone, cone.hold, along / own)
    return best


@dataclass
class Relaxed:
    """Forces of all rows, and what contacts do with them."""

    forces: np.ndarray
    # The unit vectors of contacts whose friction is as large as it may be.
    sliding: dict[int, np.ndarray]
    open: set[int]  # contacts without a normal force


def relaxed(
    free: np.ndarray,
    square: np.ndarray,
    contacts: Sequence[tuple[int, int | None, Sequence[int], float, float, float]],
    tied: dict[int, np.ndarray],
) -> Iterator[Relaxed]:
    """Iterate over contacts, each with the forces of the others; yield after 1, 2, 4 … sweeps.

    `free` and `square` are of a = c + A λ. Contacts are (contact, normal row, tangential rows, μ,
    μ_static, known normal force), and `tied` has the unit vectors of those that slide in a known
    direction.
    """
    found = Relaxed(np.zeros(len(free)), {}, set())
    forces = found.forces
    for sweep in range(1, SWEEPS + 1):
        for i, normal, tangent, mu, hold, pressed in contacts:
            own, press = list(tangent), pressed
            if normal is not None:
                column = square[normal, normal]
                if i in tied:
                    column = column - mu * square[normal, own] @ tied[i]
                rate = free[normal] + square[normal] @ forces
                press = forces[normal] = max(0.0, forces[normal] - rate / column)
                (found.open.discard if press > 0.0 else found.open.add)(i)
            if i in tied:
                forces[own] = -mu * press * tied[i]
            elif own:
                stiff = np.linalg.eigvalsh(square[np.ix_(own, own)])[-1]
                wanted = forces[own] - (free[own] + square[own] @ forces) / stiff
                size = float(np.linalg.norm(wanted))
                found.sliding.pop(i, None)
                if size > hold * press:
                    found.sliding[i] = -wanted / size
                    wanted = wanted * (mu * press / size)
                forces[own] = wanted
        if sweep & (sweep - 1) == 0:
            yield found
