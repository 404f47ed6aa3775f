"""Whether the linear model of a motion changes along it.

In a steady motion all states are constant except the advancing ones (`pydy._states.advancing`),
such as the position of a vehicle on the road and its heading. Rows and columns of advancing states
count neither as a departure from equilibrium nor as a change.

The other derivatives of the rates are compared with those at states of the Taylor polynomial of
second order, ahead by parts of the time in which the fastest eigenvalue or an angle makes a radian;
if both are at rest, in which those of the model ahead do.
No result depends on a unit. A change that begins in a higher order of time is not seen, nor is one
that inputs make as functions of time.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pydy._problem import Problem, with_unknowns
from pydy._rank import DIGITS, or_one
from pydy._states import EvaluationPoints, advancing_states
from pydy.analysis.equilibria import largest_departure
from pydy.analysis.equilibrium_residual import EquilibriumResidual

# Parts of the time in which an eigenvalue or an angle makes a radian.
_STEPS = (1.0, 0.5, 0.125)
# Times that any motion may take, whatever its unit is.
_TIMES = 4.0 ** np.arange(-50, 51)


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
        # The change comes first: the sizes of the terms of the rates, by which a departure is
        # judged, take a hundred times as long.
        advancing = advancing_states(point)
        if not _changes(problem, point, advancing):
            return None
        departure = _departure(problem, ())
        return _departure(problem, advancing) if departure and advancing else departure


def _departure(problem: Problem, advancing: Sequence[int]) -> tuple[str, float] | None:
    """Return the rate that is farthest from zero, except those of advancing states."""
    coordinates = problem.definition.equations.coordinates
    steady = [coordinates[k] for k in advancing if k < len(coordinates)]
    residual = EquilibriumResidual(problem, None, None, steady)
    residual.rows = [k for k in residual.rows if k not in advancing]
    return largest_departure(residual.problem(), residual.start)


def _changes(problem: Problem, point: EvaluationPoints, advancing: Sequence[int]) -> bool:
    """Return whether the derivatives of the rates change along the motion.

    Rows and columns of advancing and of auxiliary states are left out.
    """
    equations = problem.definition.equations
    q, moving = len(equations.coordinates), len(equations.coordinates) + len(equations.speeds)
    remaining = np.setdiff1d(np.arange(moving), advancing)
    if not remaining.size:
        return False
    rates, slopes = point.tried(point.model.compiled("rates"))[0], _slopes(point, point)
    second_rates = slopes @ rates
    block = np.ix_(remaining, remaining)
    if not all(np.isfinite(part).all() for part in (slopes[block], rates, second_rates)):
        return False
    natural = point.natural["states"][0, remaining]
    per_angle = np.where(natural > 0.0, 1.0 / or_one(natural), 0.0)
    fastest = max(
        np.abs(np.linalg.eigvals(slopes[block])).max(initial=0.0),
        (np.abs(rates[remaining]) * per_angle).max(initial=0.0),
        np.sqrt((np.abs(second_rates[remaining]) * per_angle).max(initial=0.0)),
    )
    time = (
        1.0 / fastest if fastest > 0.0 else _time_of_change(point, rates, second_rates, remaining)
    )
    for share in _STEPS if time > 0.0 else ():
        h = share * time
        advance = h * rates + 0.5 * h**2 * second_rates
        ahead = _advanced(point, advance)
        if ahead is None:
            continue
        units = point.motions[0].copy()
        units[:q] *= time
        magnitudes = np.maximum(np.abs(point.x[0]), np.abs(advance))[remaining]
        slopes_ahead = _slopes(ahead, point)[block]
        if _differ(slopes[block], slopes_ahead, units[remaining], magnitudes):
            return True
    return False


def _time_of_change(
    point: EvaluationPoints, rates: np.ndarray, second_rates: np.ndarray, remaining: np.ndarray
) -> float:
    """Return the first power of four in which the model there makes a radian, or 0.0 if none does.

    The model at the state has no time: all its eigenvalues are zero. A body that falls from rest in
    air has one as soon as it moves.
    """
    for h in _TIMES:
        ahead = _advanced(point, h * rates + 0.5 * h**2 * second_rates)
        slopes = None if ahead is None else _slopes(ahead, point)[np.ix_(remaining, remaining)]
        if slopes is None or not np.isfinite(slopes).all():
            continue
        if h * np.abs(np.linalg.eigvals(slopes)).max() >= 1.0:
            return float(h)
    return 0.0


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


def _differ(
    before: np.ndarray, after: np.ndarray, units: np.ndarray, magnitudes: np.ndarray
) -> bool:
    """Return whether slopes (n, n) differ in more than five digits.

    Coordinates and speeds are measured in `units` (n,), motions of unit energy in the time of the
    step, other states (0 in `units`) by their `magnitudes` (n,). No entry of one kind is compared
    with those of the other. States of magnitude zero are left out, and entries that are not finite.
    """
    mechanical = units > 0.0
    kinds = mechanical, ~mechanical & (magnitudes > 0.0)
    units = or_one(np.where(mechanical, units, magnitudes))
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
