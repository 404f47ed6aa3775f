"""The least objective between two nodes of a motion, on a finer mesh of that interval alone.

The errors of an objective (`accuracy`) use it where an interval does not resolve a boundary layer.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from pydy._errors import MissingDependencyError, OptimizationError
from pydy.control import ipopt
from pydy.control.nlp import Nlp
from pydy.control.transcription import Bound, TranscribedProblem, Transcription
from pydy.control.tuning import HALVINGS

if TYPE_CHECKING:
    import sympy as sm

    from pydy._sympy_types import AnySymbol


def least_between(transcription: Transcription, nlp: Nlp, z: np.ndarray, k: int) -> float:
    """Return the least objective of motions that join the states at the nodes of interval k.

    NaN if the search fails, or if the interval cannot be solved alone: for systems with constraints
    and for integrands that contain the duration of the full motion.
    """
    p, T = transcription.problem, transcription.split(z)[3]
    symbols = {s for e in (p.running, *(c.expression for c in p.path)) for s in _symbols(e)}
    if p.equations.constraints or p.duration_symbol in symbols:
        return np.nan
    first, last = transcription.mesh[k : k + 2]
    part = _restricted_problem(p, first, last - first, T)
    local = Transcription(part, transcription.scheme, _mesh_fine_at_both_ends())
    states, controls = _initial_guess(transcription, local, z, k)
    constants, duration = transcription.split(z)[2], (last - first) * T
    lower, upper = (
        local.unknowns_of(*limits, constants, duration) for limits in _limits(local, states)
    )
    guess = np.clip(local.unknowns_of(states, controls, constants, duration), lower, upper)
    sizes = _sizes_of_unknowns(transcription, local, nlp, duration)
    try:
        solution = ipopt.solve(local.nlp(lower, upper, sizes).scaled_at(guess), guess)
    except (OptimizationError, MissingDependencyError):  # no solver in this process
        return np.nan
    if solution.interrupted is not None:
        raise solution.interrupted
    return solution.objective if solution.solved else np.nan


def _restricted_problem(
    problem: TranscribedProblem, first: float, length: float, T: float
) -> TranscribedProblem:
    """Return the problem on a part of its duration T, which begins at the fraction `first`.

    It has the integral of the objective and the path conditions, but no conditions at the ends: the
    limits of the unknowns hold the states there.
    """
    restricted = _restriction(first, length)
    return replace(
        problem,
        begin=problem.begin + first * T,
        duration=None if problem.duration is None else length * T,
        control_bounds=tuple(
            (restricted(low), restricted(high)) for low, high in problem.control_bounds
        ),
        state_bounds=tuple(
            (restricted(low), restricted(high)) for low, high in problem.state_bounds
        ),
        terminal=0,
        boundary=(),
        instants=(),
        constraints=(),
    )


def _mesh_fine_at_both_ends() -> np.ndarray:
    """Return nodes from 0 to 1 whose intervals are halved again and again towards both ends."""
    first_half = 0.5 * 2.0 ** np.arange(-HALVINGS, 1)
    return np.concatenate([[0.0], first_half, 1.0 - first_half[-2::-1], [1.0]])


def _initial_guess(
    transcription: Transcription, local: Transcription, z: np.ndarray, k: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return states and controls of interval k in the slots of its own mesh: those of z."""
    nodal_states, controls, _, T = transcription.split(z)
    first, last = transcription.mesh[k : k + 2]
    length = last - first
    slot_times, is_slope = local.state_slots
    times = (first + slot_times * length) * T
    states = transcription.states_at(z, np.clip(times, first * T, last * T)).T
    states[:, [0, local.intervals]] = nodal_states[:, [k, k + 1]]
    if is_slope.any():
        node_times = local.mesh * length * T
        for row in states:
            row[is_slope] = np.gradient(row[~is_slope], node_times)
    fractions = local.control_times
    interval = np.full(len(fractions), k)
    scheme = transcription.scheme.controls
    values = transcription._interpolated(controls, scheme, interval, fractions, T)
    return states, values.T


def _limits(
    local: Transcription, states: np.ndarray
) -> tuple[tuple[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]:
    """Return lower and upper limits of states and controls; the end `states` are held."""
    part, (slot_times, is_slope), fractions = local.problem, local.state_slots, local.control_times
    # Slack velocities, multipliers and kinks have no bounds.
    unbounded = np.full((part.algebraic - len(part.controls), len(fractions)), np.inf)
    end_slots = [0, local.intervals]
    limits = []
    for side, sign in ((0, -1.0), (1, 1.0)):
        of_states = np.array([bounds[side](slot_times) for bounds in part.state_bounds])
        of_states[:, is_slope] = sign * np.inf
        of_states[:, end_slots] = states[:, end_slots]
        of_controls = np.array([bounds[side](fractions) for bounds in part.control_bounds])
        of_controls = of_controls.reshape(-1, len(fractions))
        limits.append((of_states, np.concatenate([of_controls, sign * unbounded])))
    lower, upper = limits
    return lower, upper


def _sizes_of_unknowns(
    transcription: Transcription, local: Transcription, nlp: Nlp, duration: float
) -> np.ndarray:
    """Return the sizes of the unknowns of one interval: the largest in the full motion."""
    states, controls, constants, _ = transcription.split(nlp.sizes)
    slot_times, is_slope = local.state_slots
    largest = states.max(axis=1, where=~transcription.state_slots[1], initial=0.0)
    of_states = np.repeat(largest[:, None], len(slot_times), axis=1)
    of_states[:, is_slope] /= duration
    of_controls = np.repeat(controls.max(axis=1)[:, None], len(local.control_times), axis=1)
    return local.unknowns_of(of_states, of_controls, constants, duration)


def _restriction(first: float, length: float) -> Callable[[Bound], Bound]:
    """Return a function that restricts a limit of the full motion to a part of it."""
    return lambda limit: lambda fractions: limit(first + length * fractions)


def _symbols(expression: sm.Expr | int) -> Iterable[AnySymbol]:
    return getattr(expression, "free_symbols", ())
