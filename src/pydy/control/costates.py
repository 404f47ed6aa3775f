"""The derivatives of the objective by the states at the ends of intervals.

Those of the program: what the equations and the objective of an interval change with the state at
one of its ends. A condition on the state at a node, such as a bound, makes the two sides differ.
"""

from __future__ import annotations

import numpy as np

from pydy.control.ipopt import Solution
from pydy.control.nlp import Nlp
from pydy.control.transcription import Transcription


def costates_of(made: Transcription, nlp: Nlp, solution: Solution) -> tuple[np.ndarray, np.ndarray]:
    """Return the derivatives of the objective, from there on, by the states, (n, M) each.

    They are those after the first nodes of the intervals, and before the last ones.
    """
    if made.scheme.name == "hermite-simpson":
        return _of_simpson(made, nlp, solution)
    slots, M, z = len(made.state_slots[0]), made.intervals, solution.z
    first, last = np.zeros((2, made.problem.states, M))
    for group, weights in nlp.by_group(solution.multipliers)[: len(made.points)]:
        own = np.tile(np.arange(M), group.points // M)  # the points' intervals
        f = group.functions
        slopes = [*zip(f.gradient_at, group.evaluate("gradient", z), strict=True)]
        for (i, j), row in zip(f.jacobian_at, group.evaluate("jacobian", z), strict=True):
            slopes.append((j, weights[i] * row))
        for variable, values in slopes:
            state, slot = np.divmod(group.at[variable], slots)
            for found, node, sign in ((first, own, 1.0), (last, own + 1, -1.0)):
                there = (group.at[variable] < made.sizes[0]) & (slot == node)
                np.add.at(found, (state[there], own[there]), sign * values[there])
    return first, last


def _of_simpson(made: Transcription, nlp: Nlp, solution: Solution) -> tuple[np.ndarray, np.ndarray]:
    """Return the same for Hermite–Simpson.

    The equations of a node serve the intervals on both sides, which have a share each in their
    multipliers: the Lagrangian of either side alone is stationary in the slope at the node.
    """
    n, M = made.problem.states, made.intervals
    found = []
    # At nodes, and in the middle of intervals.
    for group, multipliers in nlp.by_group(solution.multipliers)[:2]:
        f = group.functions
        slopes = np.zeros((group.rows + 1, len(group.at), group.points))
        # Rows with their derivatives by the variables, the last one that of the objective.
        slopes[tuple(f.jacobian_at.T)] = group.evaluate("jacobian", solution.z)
        slopes[group.rows, f.gradient_at] = group.evaluate("gradient", solution.z)
        found.append((np.vstack([multipliers, np.ones(group.points)]), slopes))
    (own, rows), (middle, inner) = found
    inside = np.einsum("rm,rvm->vm", middle, inner)[: 4 * n].reshape(2, 2, n, M)
    nodes = np.einsum("rm,rvm->vm", own[n:], rows[n:])[: 2 * n].reshape(2, n, M + 1)
    h, sides = np.diff(made.mesh), []
    around = np.append(h, 0.0) + np.append(0.0, h)
    for side, (at, sign) in enumerate(((slice(M), 1.0), (slice(1, None), -1.0))):
        x, v = inside[:, side] + nodes[:, :, at] * (h / around[at])
        by_slope = rows[:n, n : 2 * n, at].transpose(2, 1, 0)
        after = -np.linalg.solve(by_slope, v.T[..., None])[..., 0].T
        sides.append(sign * (x + np.einsum("rm,rvm->vm", after, rows[:n, :n, at])))
    return sides[0], sides[1]
