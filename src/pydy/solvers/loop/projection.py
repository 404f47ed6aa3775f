"""Constraints held: the state is moved back onto them, by the least motion.

Positions are corrected by Newton's method along the kinematics, δq = N δu, where δu is the least in
the norm of the unreduced mass matrix; velocities by one linear solve in the same norm. What no δu
can mend, such as the norm of a quaternion, is mended by the least δq.

E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd edition, section IV.4.
"""

from __future__ import annotations

import math

import numpy as np

from pydy.solvers.loop.compiled import entry, inlined
from pydy.solvers.loop.entrance import (
    opened_constraints,
    opened_problem,
    opened_progress,
    opened_projection,
    opened_tangents,
)
from pydy.solvers.loop.intrinsics import address_of, call_kernel, call_part, numbers_at
from pydy.solvers.loop.rates import set_inputs
from pydy.solvers.outcome import CONSTRAINTS_NOT_MET
from pydy.solvers.run.layout import (
    COORDINATES,
    COUNT,
    DIRECTIONS,
    HOLONOMIC,
    NEARNESS,
    OF_STATE,
    PROJECTIONS,
    PROJECTOR,
    RANK,
    SCRATCH,
    SPEEDS,
    STATES,
    TANGENTS,
    VELOCITY,
    WEIGHTED,
    WHEN,
    WHERE,
)
from pydy.solvers.tuning import DEPENDENT, NEARLY_SINGULAR, ROUNDING, ROUNDINGS

__all__ = ["project", "project_columns"]

_ITERATIONS = 10


@inlined
def _factor(matrix):
    """Replace a symmetric matrix by its Cholesky factor; by the identity where it has none."""
    n = matrix.shape[0]
    for j in range(n):
        pivot = matrix[j, j]
        for k in range(j):
            pivot -= matrix[j, k] * matrix[j, k]
        if not pivot > 4.0 * n * ROUNDING * matrix[j, j]:
            for i in range(n):
                for k in range(n):
                    matrix[i, k] = 1.0 if i == k else 0.0
            return
        matrix[j, j] = math.sqrt(pivot)
        for i in range(j + 1, n):
            value = matrix[i, j]
            for k in range(j):
                value -= matrix[i, k] * matrix[j, k]
            matrix[i, j] = value / matrix[j, j]


@inlined
def _divide_rows(rows, factor):
    """Replace each row a by a L⁻ᵀ."""
    n = factor.shape[0]
    for row in range(rows.shape[0]):
        for i in range(n):
            value = rows[row, i]
            for k in range(i):
                value -= factor[i, k] * rows[row, k]
            rows[row, i] = value / factor[i, i]


@inlined
def _divide_transposed(factor, y):
    """Replace y by L⁻ᵀ y."""
    n = factor.shape[0]
    for i in range(n - 1, -1, -1):
        value = y[i]
        for k in range(i + 1, n):
            value -= factor[k, i] * y[k]
        y[i] = value / factor[i, i]


@inlined
def _minimum_norm(rows, projection):
    """Compute ``step``, the least y with ``rows @ y = right``; ``right`` keeps what no y can reach.

    Rows are scaled to unit length and orthogonalised, the longest first, and overwritten.
    ``lengths`` are those of the rows as they came, and ``kept`` what orthogonalisation left of
    them: 0 for redundant ones.
    """
    m, n = rows.shape
    y, right, scale, left = projection.step, projection.right, projection.scale, projection.left
    lengths, kept = projection.lengths, projection.kept
    for k in range(n):
        y[k] = 0.0
    for i in range(m):
        scale[i], left[i], lengths[i], kept[i] = 1.0, 1, 0.0, 0.0
        norm = 0.0
        for k in range(n):
            norm += rows[i, k] * rows[i, k]
        if norm > 0.0:
            lengths[i] = math.sqrt(norm)
            scale[i] = 1.0 / lengths[i]
            right[i] *= scale[i]
            for k in range(n):
                rows[i, k] *= scale[i]
    for _ in range(m):
        pivot, longest = -1, DEPENDENT * DEPENDENT
        for i in range(m):
            if left[i] == 1:
                norm = 0.0
                for k in range(n):
                    norm += rows[i, k] * rows[i, k]
                if norm > longest:
                    pivot, longest = i, norm
        if pivot < 0:
            break
        left[pivot] = 0
        length = math.sqrt(longest)
        kept[pivot] = length * lengths[pivot]
        z = right[pivot] / length
        right[pivot] = 0.0
        for k in range(n):
            rows[pivot, k] /= length
            y[k] += z * rows[pivot, k]
        for i in range(m):
            if left[i] == 1:
                along = 0.0
                for k in range(n):
                    along += rows[i, k] * rows[pivot, k]
                right[i] -= along * z
                for k in range(n):
                    rows[i, k] -= along * rows[pivot, k]
    for i in range(m):
        right[i] /= scale[i]


@inlined
def _copy_table(values, start, table):
    for i in range(table.shape[0]):
        for k in range(table.shape[1]):
            table[i, k] = values[start + i * table.shape[1] + k]


@inlined
def _copy_negative(values, start, m, vector):
    for i in range(m):
        vector[i] = -values[start + i]


@inlined
def _set_rows(kinematics, gradient, rows):
    """Compute the rows of ∂h/∂q N."""
    q, u = kinematics.shape
    for i in range(rows.shape[0]):
        for k in range(u):
            rows[i, k] = size = 0.0
            for j in range(q):
                term = gradient[i, j] * kinematics[j, k]
                rows[i, k] += term
                size += abs(term)
            if abs(rows[i, k]) <= 4.0 * q * ROUNDING * size:
                rows[i, k] = 0.0  # nothing but rounding, as in the norm of a quaternion


@inlined(pasted=True)
def _watch(seen, t, x, lengths, kept, v):
    """Note where the rows were nearest to losing rank, or first came very near to it.

    Rows are measured by the longest they have been: one that vanishes has lost its part too.
    """
    longest = WHERE + x.size
    rank, nearness = 0, 1.0
    for i in range(v):
        seen[longest + i] = max(seen[longest + i], lengths[i])
        if kept[i] > 0.0:
            rank += 1
            nearness = min(nearness, kept[i] / seen[longest + i])
    if rank > seen[RANK]:
        seen[RANK], seen[NEARNESS] = rank, 1.0
    elif rank < seen[RANK]:
        nearness = 0.0
    if nearness < seen[NEARNESS] and seen[NEARNESS] > NEARLY_SINGULAR:
        seen[NEARNESS], seen[WHEN] = nearness, t
        for i in range(x.size):
            seen[WHERE + i] = x[i]


@entry("int64(int64, float64, int64)")
def project(table, t, place):
    """Move the state at an address onto the constraints; 0, or CONSTRAINTS_NOT_MET."""
    problem, constraints = opened_problem(table), opened_constraints(table)
    counts, x = opened_progress(table).counts, numbers_at(place, problem.words[STATES])
    words, values = constraints.words, constraints.values
    projection = opened_projection(words[SCRATCH])
    factor, kinematics, gradient = projection.factor, projection.kinematics, projection.gradient
    rows, velocity, step = projection.holonomic, projection.velocity, projection.step
    h, v, q, u = words[HOLONOMIC], words[VELOCITY], words[COORDINATES], words[SPEEDS]
    at_gradient = h + v
    at_kinematics = at_gradient + h * q
    at_velocity = at_kinematics + q * u
    at_mass = at_velocity + v * u
    at_rounding = at_mass + words[WEIGHTED] * u * u
    at_worst = at_rounding + h
    set_inputs(problem, t)
    counts[PROJECTIONS] += 1
    for i in range(u):
        for k in range(u):
            factor[i, k] = 1.0 if i == k else 0.0
    before = np.inf
    for iteration in range(_ITERATIONS):
        code = call_kernel(
            words[PROJECTOR],
            address_of(problem.clock, 0),
            address_of(x, 0),
            address_of(problem.r, 0),
            address_of(constraints.c, 0),
            address_of(values, 0),
        )
        if code < 0:
            return CONSTRAINTS_NOT_MET
        # In units of what rounding may make of them.
        worst = 0.0
        for i in range(h):
            if values[i] != 0.0:
                worst = max(worst, abs(values[i]) / (ROUNDING * values[at_rounding + i]))
            if not math.isfinite(values[i]):
                return CONSTRAINTS_NOT_MET
        if worst <= 1.0 or (worst >= 0.5 * before and worst <= ROUNDINGS):
            break
        if iteration == _ITERATIONS - 1:
            return CONSTRAINTS_NOT_MET
        before = worst
        if words[WEIGHTED] == 1:
            _copy_table(values, at_mass, factor)
            _factor(factor)
        _copy_table(values, at_kinematics, kinematics)
        _copy_table(values, at_gradient, gradient)
        _set_rows(kinematics, gradient, rows)
        _divide_rows(rows, factor)
        _copy_negative(values, 0, h, projection.right)
        _minimum_norm(rows, projection)
        _divide_transposed(factor, step)
        for j in range(q):
            for k in range(u):
                x[j] += kinematics[j, k] * step[k]
        rest = 0.0
        for i in range(h):
            rest = max(rest, abs(projection.right[i]))
        if rest > 0.0:  # rows that no speed reaches, and redundant ones
            _minimum_norm(gradient, projection)
            for j in range(q):
                x[j] += step[j]
    if v > 0:
        finite = 0.0
        for i in range(v):
            finite += 0.0 * values[h + i]
        for i in range(v * u):
            finite += 0.0 * values[at_velocity + i]
        if finite != 0.0:  # NaN
            return CONSTRAINTS_NOT_MET
        if words[WEIGHTED] == 1:
            _copy_table(values, at_mass, factor)
            _factor(factor)
        _copy_table(values, at_velocity, velocity)
        _divide_rows(velocity, factor)
        _copy_negative(values, h, v, projection.right)
        _minimum_norm(velocity, projection)
        _divide_transposed(factor, step)
        for k in range(u):
            x[q + k] += step[k]
        _watch(values[at_worst:], t, x, projection.lengths, projection.kept, v)
    return 0


@inlined(apart=True)
def _move(problem, tangents, place):
    """Evaluate the derivatives of the residuals along the columns."""
    return call_kernel(
        tangents.words[DIRECTIONS],
        address_of(problem.clock, 0),
        place,
        address_of(problem.r, 0),
        address_of(tangents.c, 0),
        address_of(tangents.values, 0),
    )


@inlined
def _copy_column(values, start, m, width, column, vector):
    for i in range(m):
        vector[i] = -values[start + i * width + column]


@entry("int64(int64, float64, int64)")
def project_columns(table, t, place):
    """Move a state onto the constraints, and its sensitivities onto the linear ones there.

    With c(x, θ) = 0 the sensitivities S of motions that keep the constraints satisfy c_x S + c_θ =
    0. They are corrected by the least change in the norm that corrects the state.
    """
    problem, constraints = opened_problem(table), opened_constraints(table)
    words, values = constraints.words, constraints.values
    tangents = opened_tangents(words[TANGENTS])
    code = call_part(tangents.words[OF_STATE], table, t, place)
    if code != 0:
        return code
    projection = opened_projection(words[SCRATCH])
    factor, kinematics, gradient = projection.factor, projection.kinematics, projection.gradient
    rows, velocity, step = projection.holonomic, projection.velocity, projection.step
    h, v, q, u = words[HOLONOMIC], words[VELOCITY], words[COORDINATES], words[SPEEDS]
    width, states = tangents.words[COUNT], problem.words[STATES]
    n = states // (1 + width)
    columns = numbers_at(place + 8 * n, n * width)
    # What the projection of the state left there is of its last iteration.
    at_gradient = h + v
    at_kinematics = at_gradient + h * q
    at_velocity = at_kinematics + q * u
    at_mass = at_velocity + v * u
    for i in range(u):
        for k in range(u):
            factor[i, k] = 1.0 if i == k else 0.0
    if words[WEIGHTED] == 1:
        _copy_table(values, at_mass, factor)
        _factor(factor)
    if h > 0:
        if _move(problem, tangents, place) < 0:
            return CONSTRAINTS_NOT_MET
        _copy_table(values, at_kinematics, kinematics)
        for column in range(width):
            _copy_table(values, at_gradient, gradient)
            _set_rows(kinematics, gradient, rows)
            _divide_rows(rows, factor)
            _copy_column(tangents.values, 0, h, width, column, projection.right)
            _minimum_norm(rows, projection)
            _divide_transposed(factor, step)
            for j in range(q):
                for k in range(u):
                    columns[j * width + column] += kinematics[j, k] * step[k]
            rest = 0.0
            for i in range(h):
                rest = max(rest, abs(projection.right[i]))
            if rest > 0.0:
                _minimum_norm(gradient, projection)
                for j in range(q):
                    columns[j * width + column] += step[j]
    if v > 0:
        if _move(problem, tangents, place) < 0:
            return CONSTRAINTS_NOT_MET
        for column in range(width):
            _copy_table(values, at_velocity, velocity)
            _divide_rows(velocity, factor)
            _copy_column(tangents.values, h * width, v, width, column, projection.right)
            _minimum_norm(velocity, projection)
            _divide_transposed(factor, step)
            for k in range(u):
                columns[(q + k) * width + column] += step[k]
    return 0
