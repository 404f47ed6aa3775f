"""Whether the linear model of a motion changes along it.

In a steady motion all states are constant except coordinates that nothing depends on, such as the
position of a vehicle on the road and its heading. A state is *advancing* if neither a holonomic
constraint nor a rate has a derivative by it, where rates of other advancing states do not count:
the velocity over the road depends on the heading. Besides coordinates, dependent speeds may be
advancing: that velocity may be such a speed, and then the constraint that gives it does not count.
This is a property of the equations, which is decided in exact arithmetic: neither a zero at one
state nor terms that cancel mislead it. Rows and columns of advancing states count neither as a
departure from equilibrium nor as a change.

The other slopes are compared with those at states of the Taylor polynomial of second order, ahead
by parts of the time in which the fastest eigenvalue or an angle makes a radian. No result depends
on a unit. A change that begins in a higher order of time is not seen, nor is one that inputs make
as functions of time.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pydy._assembly import Assembly
from pydy._graph import jacobian, signatures
from pydy._problem import Problem, with_unknowns
from pydy._rank import DIGITS, or_one
from pydy._states import EvaluationPoints
from pydy.analysis.equilibria import largest_departure
from pydy.analysis.equilibrium_residual import EquilibriumResidual

# Parts of the time in which an eigenvalue or an angle makes a radian.
_AHEAD = (1.0, 0.5, 0.125)


def departure_that_changes_the_model(
    problem: Problem, point: EvaluationPoints
) -> tuple[str, float] | None:
    """Return the largest rate at the initial state, if the linear model changes along the motion.

    None if that state is an equilibrium, or its motion steady; if the linear model is the same all
    along; or if it cannot be evaluated ahead. The `point` is that state.
    """
    if not point.tried(point.model.compiled("rates")).any():
        return None
    with np.errstate(all="ignore"):
        if _departure(problem, ()) is None:
            return None
        advancing = advancing_states(point)
        departure = _departure(problem, advancing)
        return departure if departure and _changes(problem, point, advancing) else None


def _departure(problem: Problem, advancing: Sequence[int]) -> tuple[str, float] | None:
    """Return the rate that is farthest from zero, except those of advancing states."""
    coordinates = problem.definition.equations.coordinates
    if len(advancing) == _moving_count(problem):
        return None
    steady = [coordinates[k] for k in advancing if k < len(coordinates)]
    residual = EquilibriumResidual(problem, None, None, steady)
    residual.rows = [k for k in residual.rows if k not in advancing]
    return largest_departure(residual.problem(), residual.start)


def _moving_count(problem: Problem) -> int:
    equations = problem.definition.equations
    return len(equations.coordinates) + len(equations.speeds)


def advancing_states(point: EvaluationPoints) -> list[int]:
    """Return the coordinates and dependent speeds on which only rates of such states depend.

    A velocity constraint that gives such a speed does not count either.
    """
    own, definition = point.model.assembly.fork(), point.definition
    equations, q = definition.equations, len(definition.equations.coordinates)
    moving = q + len(equations.speeds)
    rates = own.blocks.rates[:moving]
    by_state = _dependence(own, rates, "x", moving)
    by_input = _dependence(own, rates, "r", own.sizes[1])
    by_state[by_input @ (point.input_feedback[0, :, :moving] != 0.0)] = True
    held = _dependence(own, own.blocks.holonomic, "x", moving)
    constrained = _dependence(own, own.blocks.velocity, "x", moving)
    dependent = [definition.states.index(speed) for speed in equations.dependents.speeds]
    given, candidates = constrained[:, dependent], [*range(q), *dependent]
    is_advancing = np.zeros(moving, dtype=bool)
    for _ in candidates:
        rows = np.concatenate([by_state[~is_advancing], held])
        needed: np.ndarray = np.logical_or.reduce(rows, axis=0)
        # A constraint gives one of its dependent speeds. It does not count if none of them does;
        # else all that is in it counts.
        for _ in constrained:
            counts = (given & needed[dependent]).any(axis=1) | ~given.any(axis=1)
            needed |= constrained[counts].any(axis=0)
        is_advancing[candidates] = ~needed[candidates]
    advancing: list[int] = np.flatnonzero(is_advancing).tolist()
    return advancing


def _dependence(assembly: Assembly, rows: Sequence[int], group: str, width: int) -> np.ndarray:
    """Return which rows have a derivative by which inputs, shape (rows, width)."""
    graph, result = assembly.graph, np.zeros((len(rows), width), dtype=bool)
    slopes = jacobian(graph, rows, [graph.input(group, k) for k in range(width)])
    entries = [(i, k, node) for i, row in enumerate(slopes) for k, node in row.items()]
    values = signatures(graph, [node for _, _, node in entries])
    for (i, k, _), value in zip(entries, values, strict=True):
        result[i, k] = value != 0
    return result


def _changes(problem: Problem, point: EvaluationPoints, advancing: Sequence[int]) -> bool:
    """Return whether the derivatives of the rates change along the motion.

    Rows and columns of advancing and of auxiliary states are left out.
    """
    f, slopes = point.tried(point.model.compiled("rates"))[0], _slopes(point, point)
    bend = slopes @ f
    remaining = np.setdiff1d(np.arange(_moving_count(problem)), advancing)
    block = np.ix_(remaining, remaining)
    if not (np.isfinite(slopes[block]).all() and np.isfinite(f).all() and np.isfinite(bend).all()):
        return False
    natural = point.natural["states"][0, remaining]
    per_angle = np.where(natural > 0.0, 1.0 / or_one(natural), 0.0)
    fastest = max(
        np.abs(np.linalg.eigvals(slopes[block])).max(initial=0.0),
        (np.abs(f[remaining]) * per_angle).max(initial=0.0),
        np.sqrt((np.abs(bend[remaining]) * per_angle).max(initial=0.0)),
    )
    time = 1.0 / fastest if fastest > 0.0 else float(np.ptp([*problem.settings.times, problem.t]))
    for share in _AHEAD if time > 0.0 else ():
        h = share * time
        advance = h * f + 0.5 * h**2 * bend
        ahead = _advanced(point, advance)
        if ahead is None:
            continue
        units = point.motions[0].copy()
        units[: len(problem.definition.equations.coordinates)] *= time
        sizes = np.maximum(np.abs(point.x[0]), np.abs(advance))[remaining]
        if _differ(slopes[block], _slopes(ahead, point)[block], units[remaining], sizes):
            return True
    return False


def _advanced(point: EvaluationPoints, advance: np.ndarray) -> EvaluationPoints | None:
    """Return the point with other states, or None if an `Implicit` has no solution there.

    Python functions among the specifieds follow their slopes: they are not called ahead, where they
    may not be defined.
    """
    r = point.r[:1] + (point.input_feedback[:1] @ advance[:, None])[:, :, 0]
    ahead = replace(point, x=point.x + advance, r=r)
    try:
        return with_unknowns(ahead, None, lambda x, t: r)
    except ValueError:
        return None


def _slopes(at: EvaluationPoints, origin: EvaluationPoints) -> np.ndarray:
    """Return the derivatives of the rates at a point, with the feedback of another; NaN where none.

    Inputs have the shape (1, s).
    """
    n, s = at.x.shape[1], at.r.shape[1]
    slopes: np.ndarray = at.tried(at.model.compiled_jacobian("rates", "x")).reshape(n, n)
    feedback = origin.input_feedback[0]
    if feedback.any():
        by_input = at.tried(at.model.compiled_jacobian("rates", "r")).reshape(n, s)
        slopes = slopes + by_input @ feedback
    return slopes


def _differ(before: np.ndarray, after: np.ndarray, units: np.ndarray, sizes: np.ndarray) -> bool:
    """Return whether slopes (n, n) differ in more than five digits.

    Coordinates and speeds are measured in `units` (n,), motions of unit energy in the time of the
    step, other states (0 in `units`) by their `sizes` (n,). No entry of one kind is compared with
    those of the other. States without a size are left out, and entries that are not finite.
    """
    mechanical = units > 0.0
    kinds = mechanical, ~mechanical & (sizes > 0.0)
    units = or_one(np.where(mechanical, units, sizes))
    for rows in kinds:
        for columns in kinds:
            part = np.ix_(rows, columns)
            scale = units[columns] / units[rows][:, None]
            a, b = before[part] * scale, after[part] * scale
            finite = np.isfinite(a) & np.isfinite(b)
            a, b = a[finite], b[finite]
            largest = max(np.abs(a).max(initial=0.0), np.abs(b).max(initial=0.0))
            if (np.abs(b - a) > DIGITS * largest).any():
                return True
    return False
