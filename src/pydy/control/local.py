"""The least objective between two nodes of a motion, on a finer mesh of that interval alone."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from pydy._errors import MissingDependencyError, OptimizationError
from pydy.control import ipopt
from pydy.control.nlp import Nlp
from pydy.control.transcription import Bound, Transcription
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
    length = last - first
    restricted = _restriction(first, length)
    part = replace(
        p,
        begin=p.begin + first * T,
        duration=None if p.duration is None else length * T,
        control_bounds=tuple((restricted(low), restricted(high)) for low, high in p.control_bounds),
        state_bounds=tuple((restricted(low), restricted(high)) for low, high in p.state_bounds),
        terminal=0,
        boundary=(),
        instants=(),
        constraints=(),
    )
    halves = 0.5 * 2.0 ** np.arange(-HALVINGS, 1)
    mesh = np.concatenate([[0.0], halves, 1.0 - halves[-2::-1], [1.0]])
    local = Transcription(part, transcription.scheme, mesh)
    states, controls, numbers, _ = transcription.split(z)
    slot_times, slopes = local.state_slots
    times = (first + slot_times * length) * T
    x = transcription.states_at(z, np.clip(times, first * T, last * T)).T
    ends = states[:, [k, k + 1]]
    at = local.control_times
    u = transcription._interpolated(
        controls, transcription.scheme.controls, np.full(len(at), k), at, T
    ).T
    intervals = len(mesh) - 1
    x[:, [0, intervals]] = ends
    sizes = transcription.split(nlp.sizes)
    largest = sizes[0].max(axis=1, where=~transcription.state_slots[1], initial=0.0)
    of_states = np.repeat(largest[:, None], len(slot_times), axis=1)
    for row in x if slopes.any() else ():
        row[slopes] = np.gradient(row[~slopes], mesh * length * T)
    of_states[:, slopes] /= length * T
    low, high = (np.array([b[side](slot_times) for b in part.state_bounds]) for side in (0, 1))
    low[:, slopes], high[:, slopes] = -np.inf, np.inf
    for side in (low, high):
        side[:, [0, intervals]] = ends
    open_ = np.full((p.algebraic - len(p.controls), len(at)), np.inf)
    limits = [np.array([b[side](at) for b in part.control_bounds]) for side in (0, 1)]
    limits = [np.concatenate([limit.reshape(-1, len(at)), sign * open_])
              for limit, sign in zip(limits, (-1.0, 1.0), strict=True)]  # fmt: skip
    duration = length * T
    begin = local.unknowns_of(x, u, numbers, duration)
    lower, upper = (
        local.unknowns_of(state_limits, control_limits, numbers, duration)
        for state_limits, control_limits in ((low, limits[0]), (high, limits[1]))
    )
    widths = np.repeat(sizes[1].max(axis=1)[:, None], len(at), axis=1)
    units = local.unknowns_of(of_states, widths, sizes[2], duration)
    begin = np.clip(begin, lower, upper)
    try:
        solution = ipopt.solve(local.nlp(lower, upper, units).scaled_at(begin), begin)
    except (OptimizationError, MissingDependencyError):  # no solver in this process
        return np.nan
    if solution.interrupted is not None:
        raise solution.interrupted
    return solution.objective if solution.solved else np.nan


def _restriction(first: float, length: float) -> Callable[[Bound], Bound]:
    """Return a function that restricts a limit of the full motion to a part of it."""
    return lambda limit: lambda fractions: limit(first + length * fractions)


def _symbols(expression: sm.Expr | int) -> Iterable[AnySymbol]:
    return getattr(expression, "free_symbols", ())
