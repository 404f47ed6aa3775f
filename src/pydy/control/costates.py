"""Costates: the derivatives of the objective by the states at the ends of intervals.

They are computed from the nonlinear program: the derivatives of an interval's equations and
integral by the state at one of its ends. A condition on the state at a node, such as a bound, makes
the costate jump there.
"""

from __future__ import annotations

import numpy as np

from pydy.control.ipopt import NlpSolution
from pydy.control.nlp import Nlp
from pydy.control.transcription import Transcription


def costates_of(
    transcription: Transcription, nlp: Nlp, solution: NlpSolution
) -> tuple[np.ndarray, np.ndarray]:
    """Return the costates just after the first node and just before the last node of each interval.

    Both have the shape (n, M). They are derivatives of the part of the objective that follows.
    """
    if transcription.scheme.name == "hermite-simpson":
        return _of_simpson(transcription, nlp, solution)
    slots, M, z = len(transcription.state_slots[0]), transcription.intervals, solution.z
    first, last = np.zeros((2, transcription.problem.states, M))
    for group, weights in nlp.by_group(solution.multipliers)[: len(transcription.points)]:
        intervals = np.tile(np.arange(M), group.points // M)  # the points' intervals
        f = group.functions
        slopes = [*zip(f.gradient_at, group.evaluate("gradient", z), strict=True)]
        for (i, j), row in zip(f.jacobian_at, group.evaluate("jacobian", z), strict=True):
            slopes.append((j, weights[i] * row))
        for variable, values in slopes:
            state, slot = np.divmod(group.at[variable], slots)
            for derivatives, node, sign in ((first, intervals, 1.0), (last, intervals + 1, -1.0)):
                at_node = (group.at[variable] < transcription.sizes[0]) & (slot == node)
                np.add.at(derivatives, (state[at_node], intervals[at_node]), sign * values[at_node])
    return first, last


def _of_simpson(
    transcription: Transcription, nlp: Nlp, solution: NlpSolution
) -> tuple[np.ndarray, np.ndarray]:
    """Return the costates for Hermite–Simpson.

    The intervals on both sides of a node share its equations, and so their multipliers. The shares
    follow from the condition that the Lagrangian of either side alone is stationary in the slope at
    the node.
    """
    n, M = transcription.problem.states, transcription.intervals
    parts = []
    # At nodes, and in the middle of intervals.
    for group, multipliers in nlp.by_group(solution.multipliers)[:2]:
        f = group.functions
        slopes = np.zeros((group.rows + 1, len(group.at), group.points))
        # Rows with their derivatives by the variables, the last one that of the objective.
        slopes[tuple(f.jacobian_at.T)] = group.evaluate("jacobian", solution.z)
        slopes[group.rows, f.gradient_at] = group.evaluate("gradient", solution.z)
        parts.append((np.vstack([multipliers, np.ones(group.points)]), slopes))
    (node_multipliers, node_slopes), (middle_multipliers, middle_slopes) = parts
    # The Lagrangian without the equations at nodes: its derivatives by states and by slopes, of
    # the middle of each interval by those of its first and last node, and of each node by its own.
    middle = np.einsum("rm,rvm->vm", middle_multipliers, middle_slopes)[: 4 * n]
    middle = middle.reshape(2, 2, n, M)  # state or slope, first or last node
    node = np.einsum("rm,rvm->vm", node_multipliers[n:], node_slopes[n:])[: 2 * n]
    node = node.reshape(2, n, M + 1)
    lengths = np.diff(transcription.mesh)
    lengths_at_node = np.append(lengths, 0.0) + np.append(0.0, lengths)
    costates = []
    for side, (at, sign) in enumerate(((slice(M), 1.0), (slice(1, None), -1.0))):
        share = lengths / lengths_at_node[at]  # of this interval in the weight of the node
        by_state, by_slope = middle[:, side] + node[:, :, at] * share
        # This interval's multipliers μ of the node's equations F = 0: by_slope + μ ∂F/∂slope = 0.
        equations_by_slope = node_slopes[:n, n : 2 * n, at].transpose(2, 1, 0)
        multipliers = -np.linalg.solve(equations_by_slope, by_slope.T[..., None])[..., 0].T
        by_equations = np.einsum("rm,rvm->vm", multipliers, node_slopes[:n, :n, at])
        costates.append(sign * (by_state + by_equations))
    return costates[0], costates[1]
