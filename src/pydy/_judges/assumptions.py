"""Check a computed motion against the assumptions of its symbols, such as `positive=True`.

Also whether a motion starts where the matrices that orient frames are rotations, as those of
quaternions are at unit length.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sm

from pydy._assembly import Assembly
from pydy._errors import warn_user
from pydy._judges.tuning import TYPED
from pydy._mechanics import (
    Equations,
    FrameTree,
    find_symbols,
    orthogonality_residuals,
)
from pydy._motion import EvaluationRecorder, Motion, is_odeint
from pydy._names import name_of, numbers_of
from pydy._problem import AssumptionChecks, StateSamples
from pydy.solvers import Options


def check_assumptions(motion: Motion) -> None:
    """Warn once of states and specifieds along a motion that contradict their assumptions.

    Between the requested times a motion is known by the steps of a solver, or by where odeint
    evaluated: its predictions are near the solution, which RK stages are not.
    """
    times, states = motion.times, motion.states
    n = states.shape[1]
    starts, between = getattr(motion.dense, "starts", None), (times[:0], states[:0])
    if motion.dense is not None and starts is not None:
        between = starts, motion.dense(starts)[:, :n]
    elif motion.evaluated is not None and is_odeint(motion.solver) and motion.evaluated.times:
        between = _accepted(motion.evaluated, times, n)
    every = np.concatenate([times, between[0]])
    order = np.argsort(every, kind="stable")
    rows = np.concatenate([states, between[1]])[order]
    AssumptionChecks(motion.problem).motion(every[order], rows, *_tolerances(motion))


def _tolerances(motion: Motion) -> tuple[Any, Any]:
    """Return the tolerances; without error control an error of the size of the states."""
    options = motion.options
    if not motion.errors_known or "step" in options:
        return 1.0, 0.0
    given = (options.get("rtol"), options.get("atol"))
    rtol, atol = (
        d if g is None else g for g, d in zip(given, (Options.rtol, Options.atol), strict=True)
    )
    return rtol, atol


def _accepted(
    evaluated: EvaluationRecorder, times: np.ndarray, n: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the times and states at which a solver evaluated, without steps that it rejected.

    After a rejected step it goes on from an earlier time.
    """
    t = np.array(evaluated.times)
    forward = times[-1] >= times[0]
    ahead = t if forward else -t
    later = np.minimum.accumulate(ahead[::-1])[::-1]
    within = (t <= times.max()) & (t >= times.min())
    rows = np.flatnonzero((ahead <= later) & within)
    return t[rows], np.array([evaluated.states[k][:n] for k in rows]).reshape(len(rows), n)


# -- Orientations at the start ---------------------------------------------------------------------

_UNITS = [[sm.Rational(n, 10) for n in numbers] for numbers in ((5, 5, 5, 5), (1, 7, 1, 7))]


def orientations(equations: Equations) -> tuple[Any, ...]:
    """Return the matrices of orientations by four coordinates, at unit length rotations."""
    made_from = equations.mechanism or equations.multibody
    matrices = () if made_from is None else FrameTree(made_from.frame).rotation_matrices()
    return tuple(m for m in matrices if _is_of_quaternion(m, equations.coordinates))


def _is_of_quaternion(matrix: Any, coordinates: Sequence[Any]) -> bool:
    """Return whether a matrix is one; those of small angles are rotations nowhere else."""
    if matrix.has(sm.sin, sm.cos):  # most are, and this is quick
        return False
    held = find_symbols(matrix)
    if len(held) != 4 or not held.keys() <= {*coordinates}:
        return False
    for numbers in _UNITS:
        turned = matrix.xreplace(dict(zip(held, numbers, strict=True)))
        if turned * turned.T != sm.eye(3):
            return False
    return True


@dataclass(frozen=True)
class _Orientations:
    """The rows that vanish where each of some matrices is a rotation."""

    matrices: tuple[Any, ...]

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        read = assembly.reader("the orientations", self.matrices)
        return {str(k): orthogonality_residuals([m], read) for k, m in enumerate(self.matrices)}


def check_orientations(at: StateSamples, matrices: tuple[Any, ...]) -> None:
    """Warn of a state where an orientation is no rotation: a quaternion of another length."""
    rows = at.interpret(_Orientations(matrices))
    for k, matrix in enumerate(matrices):
        apart = float(np.abs(rows[str(k)]).max(initial=0.0))
        if not apart > TYPED:
            continue
        held = find_symbols(matrix)
        places = [i for i, q in enumerate(at.definition.equations.coordinates) if q in held]
        names, values = [at.definition.states[i] for i in places], at.x[0, places]
        remedy, scalar = "Scale them to unit length.", _scalar_part(matrix, names)
        if not values.any() and scalar is not None:
            remedy = f"Set {name_of(scalar)} = 1 for a frame that is not turned."
        warn_user(
            f"The initial conditions {numbers_of(map(name_of, names), values)} orient no frame: "
            f"their direction cosine matrix is no rotation, by {apart:.2g}. A quaternion must be "
            f"of unit length. {remedy}"
        )
        return  # one is enough


def _scalar_part(matrix: Any, names: Sequence[Any]) -> Any:
    """Return the coordinate that is one in the unit quaternion of no rotation, or None."""
    for one in names:
        numbers = {name: sm.Integer(name == one) for name in names}
        if matrix.xreplace(numbers) == sm.eye(3).as_immutable():
            return one
    return None
