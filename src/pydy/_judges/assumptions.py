"""Check a computed motion against the assumptions of its symbols, such as `positive=True`.

Also check that the matrices that orient frames are rotations at the start. Those of quaternions are
rotations only at unit length.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from math import prod
from typing import TYPE_CHECKING

import numpy as np
import sympy as sm

from pydy._assembly import Assembly
from pydy._checks import describe
from pydy._errors import warn_user
from pydy._interpolation import evenly
from pydy._judges.tuning import TYPED
from pydy._mechanics import (
    Equations,
    find_symbols,
    orthogonality_residuals,
)
from pydy._motion import EvaluationRecorder, Motion, is_odeint
from pydy._names import name_of, numbers_of
from pydy._problem import AssumptionChecks, StateSamples
from pydy._program import Program
from pydy.solvers import DriftCheck, Options

if TYPE_CHECKING:
    from pydy._program import Tangent
    from pydy._sympy_types import AnySymbol


def check_assumptions(motion: Motion) -> None:
    """Warn once of states and specifieds along a motion that contradict their assumptions.

    Between the requested times, the steps of the solver are checked, or the states at which odeint
    evaluated: its predictions are near the solution, unlike RK stages.
    """
    times, states = motion.times, motion.states
    n = states.shape[1]
    dense, step_samples = motion.segments[0].dense, (times[:0], states[:0])
    starts, evaluated = getattr(dense, "starts", None), motion.integrator.evaluated
    if dense is not None and starts is not None:
        step_samples = starts, dense(starts)[:, :n]
    elif evaluated is not None and is_odeint(motion.integrator.solver) and evaluated.times:
        step_samples = _accepted(evaluated, times, n)
    every = np.concatenate([times, step_samples[0]])
    order = np.argsort(every, kind="stable")
    rows = np.concatenate([states, step_samples[1]])[order]
    AssumptionChecks(motion.problem).motion(every[order], rows, *_tolerances(motion))


def _tolerances(motion: Motion) -> tuple[float | np.ndarray, float | np.ndarray]:
    """Return rtol and atol; without error control, the states may be wrong by their own size."""
    options = motion.options
    if not motion.integrator.errors_known or "step" in options:
        return 1.0, 0.0
    requested = (options.get("rtol"), options.get("atol"))
    rtol, atol = (
        d if g is None else g for g, d in zip(requested, (Options.rtol, Options.atol), strict=True)
    )
    return rtol, atol


def _accepted(
    evaluated: EvaluationRecorder, times: np.ndarray, n: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the times and states at which a solver evaluated, without rejected steps.

    After a rejected step the solver continues from an earlier time.
    """
    t = np.array(evaluated.times)
    forward = times[-1] >= times[0]
    ahead = t if forward else -t
    later = np.minimum.accumulate(ahead[::-1])[::-1]
    in_range = (t <= times.max()) & (t >= times.min())
    rows = np.flatnonzero((ahead <= later) & in_range)
    return t[rows], np.array([evaluated.states[k][:n] for k in rows]).reshape(len(rows), n)


# -- Orientations at the start ---------------------------------------------------------------------


def free_quaternions(equations: Equations) -> tuple[tuple[int, ...], ...]:
    """Return the indices of the coordinates of quaternions whose length no constraint holds."""
    coordinates, constraints = equations.coordinates, equations.constraints
    held = [set(find_symbols([row])) & {*coordinates} for row in constraints.holonomic]
    every = equations.unit_quaternions
    return tuple(columns for columns in every if {coordinates[k] for k in columns} not in held)


@dataclass(frozen=True)
class _Orientations:
    """The residuals that vanish if the matrices are rotations."""

    matrices: tuple[sm.MatrixBase, ...]

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        read = assembly.reader("the orientations", self.matrices)
        return {str(k): orthogonality_residuals([m], read) for k, m in enumerate(self.matrices)}


def check_orientations(
    at: StateSamples,
    whose: Callable[[int], str] | None = None,
    quaternions: Iterable[tuple[int, ...]] | None = None,
) -> bool:
    """Warn of the state where a quaternion is farthest from unit length; return whether one is.

    `whose` names a state by its index; by default it is that of the initial conditions. All
    `quaternions` are checked, or those with these columns.
    """
    every = at.definition.equations.unit_quaternions
    chosen = [(c, m) for c in (every if quaternions is None else quaternions) for m in every[c]]
    if not chosen:
        return False
    rows = at.interpret(_Orientations(tuple(matrix for _, matrix in chosen)))
    for k, (columns, matrix) in enumerate(chosen):
        deviations = np.abs(rows[str(k)]).max(axis=1, initial=0.0)
        worst = int(np.argmax(np.where(np.isnan(deviations), 0.0, deviations)))
        if not deviations[worst] > TYPED:
            continue
        names, values = [at.definition.states[i] for i in columns], at.x[worst, columns]
        remedy, scalar = "Scale them to unit length.", _scalar_part(matrix, names)
        length = float(np.linalg.norm(values))
        if not values.any() and scalar is not None:
            remedy = f"Set {name_of(scalar)} = 1 for a frame that is not turned."
        subject = "The initial conditions" if whose is None else whose(worst)
        warn_user(
            f"{subject} {numbers_of(map(name_of, names), values)} orient no frame: "
            f"their direction cosine matrix is no rotation, by {deviations[worst]:.2g}. A "
            f"quaternion must be of unit length, and theirs is {length:.6g}. {remedy}"
        )
        return True  # one is enough
    return False


def check_evaluated_orientations(
    at: StateSamples, program: Program | Tangent, known: set[str], *, held: bool = True
) -> None:
    """Warn once of a quaternion not of unit length where a Program that reads it is evaluated.

    The `known` names are those that the user has been warned of. Without `held`, quaternions whose
    length a constraint holds are left to the residuals, which are what is evaluated.
    """
    equations = at.definition.equations
    for columns in equations.unit_quaternions if held else free_quaternions(equations):
        squares = np.einsum("mk,mk->m", at.x[:, columns], at.x[:, columns])
        # The matrix's own deviation is computed only then: no product of its rows is off by more
        # than four times what the square of the length is.
        (rows,) = np.nonzero(np.abs(squares - 1.0) > TYPED / 4)
        name = describe([at.definition.states[k] for k in columns])
        if not len(rows) or name in known or not _reads(program, columns):
            continue

        def whose(k: int, rows: np.ndarray = rows) -> str:
            return f"In state {rows[k]} of those to evaluate," if len(at.x) > 1 else "In the state,"

        if check_orientations(at.subset(rows), whose, [columns]):
            known.add(name)


def _reads(program: Program | Tangent, columns: Sequence[int]) -> bool:
    """Return whether a Program has one of the states among its inputs."""
    if isinstance(program, Program):
        return any(
            op == "input" and args[0] == "x" and args[1] in columns
            for op, args in zip(program.ops, program.args, strict=True)
        )
    parts = (program.shared, *(part.program for part in program.parts))
    return any(_reads(part, columns) for part in parts)


def check_sample_orientations(
    at: Callable[[np.ndarray, np.ndarray], StateSamples],
    t: float,
    columns: Sequence[np.ndarray],
    shape: tuple[int, ...],
) -> None:
    """Warn of a sample of an ensemble, among up to 64, with a quaternion not of unit length.

    The `columns` have the samples' initial values of each state, which broadcast to the `shape`.
    """
    numbers = evenly(prod(shape), DriftCheck.MOST_STATES)
    x = np.stack([np.broadcast_to(a, shape).flat[numbers] for a in columns], axis=1)

    def whose(k: int) -> str:
        indices = np.unravel_index(numbers[k], shape)
        sample = f" of sample {', '.join(map(str, indices))}" if shape else ""
        return f"The initial conditions{sample},"

    check_orientations(at(np.full(len(numbers), t), x), whose)


def _scalar_part(matrix: sm.MatrixBase, names: Sequence[AnySymbol]) -> AnySymbol | None:
    """Return the scalar part of a quaternion, the coordinate that is 1 at zero angle, or None."""
    for candidate in names:
        numbers = {name: sm.Integer(name == candidate) for name in names}
        if matrix.xreplace(numbers) == sm.eye(3).as_immutable():
            return candidate
    return None
