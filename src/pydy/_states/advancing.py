"""States that a motion advances along without changing: cyclic coordinates and the like.

A state is *advancing* if neither a holonomic constraint nor a rate has a derivative by it, where
rates of other advancing states do not count. The position of a vehicle on the road is advancing,
and so is its heading: only the velocity over the road depends on it. Dependent speeds may be
advancing too. If that velocity is such a speed, the velocity constraint that gives it does not
count either.

This is a property of the equations. It is decided in exact arithmetic: neither a zero at one state
nor terms that cancel are misleading.
"""

from __future__ import annotations

import numpy as np

from pydy._assembly import Assembly
from pydy._graph import jacobian, signatures
from pydy._states.states import EvaluationPoints


def advancing_states(point: EvaluationPoints) -> list[int]:
    """Return the columns in x of the advancing states, at the first state of a point."""
    equations = point.definition.equations
    moving = len(equations.coordinates) + len(equations.speeds)
    feedback = point.input_feedback[0, :, :moving] != 0.0
    # A property of the code, and of which specifieds are functions of which states.
    cache = point.model.latest.setdefault("advancing states", {})
    key = feedback.tobytes()
    if key not in cache:
        cache[key] = _advancing(point, feedback)
    advancing: list[int] = cache[key]
    return advancing


def _advancing(point: EvaluationPoints, feedback: np.ndarray) -> list[int]:
    """Return the advancing states; `feedback` (s, n) is True where a specified follows a state."""
    definition, blocks = point.definition, point.model.assembly.blocks
    equations = definition.equations
    q, moving = len(equations.coordinates), feedback.shape[1]
    dependent = [definition.states.index(speed) for speed in equations.dependents.speeds]
    candidates = np.array([*range(q), *dependent], dtype=int)
    rows = [*blocks.rates[:moving], *blocks.holonomic, *blocks.velocity]
    depends = _dependence(point.model.assembly, rows, candidates, feedback[:, candidates])
    rates, holonomic, velocity = np.split(depends, [moving, moving + len(blocks.holonomic)])
    is_advancing = np.zeros(moving, dtype=bool)
    for _ in candidates:
        rows_that_count = np.concatenate([rates[~is_advancing], holonomic])
        needed: np.ndarray = np.logical_or.reduce(rows_that_count, axis=0)
        is_advancing[candidates] = ~_with_constraints(needed, velocity, q)
    advancing: list[int] = np.flatnonzero(is_advancing).tolist()
    return advancing


def _with_constraints(needed: np.ndarray, velocity: np.ndarray, q: int) -> np.ndarray:
    """Return the candidates (k,) that are needed, with those in constraints of needed speeds.

    The candidates are q coordinates, then the dependent speeds. A row of `velocity` (c, k) gives
    one of the dependent speeds in it. It does not count if none of them is needed; else all that is
    in it is needed.
    """
    speeds = velocity[:, q:]
    for _ in velocity:
        counts = (speeds & needed[q:]).any(axis=1) | ~speeds.any(axis=1)
        needed = needed | velocity[counts].any(axis=0)
    return needed


def _dependence(
    assembly: Assembly, rows: list[int], columns: np.ndarray, feedback: np.ndarray
) -> np.ndarray:
    """Return which rows have a derivative by which columns of x, shape (rows, columns).

    Some depend on them through specifieds, by `feedback` (s, columns).
    """
    graph = assembly.fork().graph
    specifieds = np.flatnonzero(feedback.any(axis=1))
    inputs = [*(("x", k) for k in columns.tolist()), *(("r", k) for k in specifieds.tolist())]
    slopes = jacobian(graph, rows, [graph.input(group, k) for group, k in inputs])
    entries = [(i, k, node) for i, row in enumerate(slopes) for k, node in row.items()]
    depends = np.zeros((len(rows), len(inputs)), dtype=bool)
    values = signatures(graph, [node for _, _, node in entries])
    for (i, k, _), value in zip(entries, values, strict=True):
        depends[i, k] = value != 0
    direct, by_specified = np.split(depends, [len(columns)], axis=1)
    through: np.ndarray = direct | (by_specified @ feedback[specifieds])
    return through
