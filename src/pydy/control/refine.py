"""Errors of a mesh by integration, and refinement of intervals whose errors are too large.

The motion of each interval is integrated from its first state with its control, all intervals side
by side, by the Runge–Kutta method of Dormand and Prince of order 8. The difference from the
interval's last state is the error of the interval's collocation polynomial.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pydy._checks import ascending, integer, real_array, shown
from pydy._errors import OptimizationError, warn_user
from pydy._kernel import Inputs, Kernel
from pydy._names import counted
from pydy._rank import ROUNDING, or_one
from pydy.control.transcription import Transcription, inside
from pydy.control.tuning import (
    LARGEST_ORDER,
    MOST_PARTS,
    MOST_STEPS,
    NODE_DEVIATION,
    ONE_DIGIT,
    STEP,
    TOLERANCE,
    UNEVEN,
)
from pydy.solvers import tableau_of

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol
    from pydy.control.accuracy import SolvedMotion


@dataclass(frozen=True, eq=False)
class RateFunction:
    """The function of the states' derivatives."""

    kernel: Kernel  # x' of t, x, r and p
    inputs: Inputs  # they determine r, except for controls and specifieds that are unknowns


def interval_errors(
    rate_function: RateFunction,
    transcription: Transcription,
    z: np.ndarray,
    sizes: np.ndarray,
    enough: float = 0.0,
) -> np.ndarray:
    """Return the error of each interval, shape (M,).

    `sizes` (n,) are lower limits of the states' sizes; errors below `enough` need not be resolved.
    """
    return _largest(_missed(rate_function, transcription, z, sizes, enough)[0])


def _missed(
    rate_function: RateFunction,
    transcription: Transcription,
    z: np.ndarray,
    sizes: np.ndarray,
    enough: float = 0.0,
) -> tuple[np.ndarray, np.ndarray, int]:
    """Return the scaled misses of the next nodes (M, n), the states' sizes, and the steps used."""
    states, _, _, duration = transcription.split(z)
    M = transcription.intervals
    first, last = states[:, :M].T, states[:, 1 : M + 1].T
    scale = or_one(np.maximum(np.abs(states[:, : M + 1]).max(axis=1), sizes))
    missed, before, steps = np.zeros((M, len(states))), None, 1
    while True:
        ends = _integrated(rate_function, transcription, z, first, duration, steps)
        missed = (ends - last) / scale
        if before is not None:
            error, change = _largest(missed), _largest((ends - before) / scale)
            if ((change <= ONE_DIGIT * error) | (error + change <= enough)).all():
                break
        if 2 * steps > MOST_STEPS:
            break
        before, steps = ends, 2 * steps
    return missed, scale, steps


def propagated_errors(
    rate_function: RateFunction,
    transcription: Transcription,
    z: np.ndarray,
    sizes: np.ndarray,
    tolerance: float,
) -> np.ndarray:
    """Return each interval's share in the largest deviation of a simulation from the nodes, (M,).

    The flow of the motion carries the errors of intervals on to later nodes; its derivatives are
    estimated by finite differences. A simulation from the start may miss a node by `NODE_DEVIATION`
    tolerances; the shares are scaled such that a share above the tolerance asks for a finer
    interval. They are zero where no deviation is too large, and where the intervals' errors would
    have to be smaller than the residuals that the search leaves, as along a motion that is unstable
    for long.
    """
    states, _, _, duration = transcription.split(z)
    M, n = transcription.intervals, transcription.problem.states
    missed, scale, steps = _missed(rate_function, transcription, z, sizes, tolerance / M)
    ends = states[:, 1 : M + 1].T / scale + missed
    flow, far = np.empty((M, n, n)), np.zeros((M + 1, n))
    for i, change in enumerate(np.diag(STEP * scale)):
        perturbed = _integrated(
            rate_function, transcription, z, states[:, :M].T + change, duration, steps
        )
        flow[:, :, i] = (perturbed / scale - ends) / STEP
    with np.errstate(all="ignore"):
        for k in range(M):
            far[k + 1] = flow[k] @ far[k] + missed[k]
        k, i = divmod(int(np.abs(far[1:]).argmax()), n)
        share = NODE_DEVIATION * tolerance / np.abs(far[k + 1, i])
        if not TOLERANCE / tolerance < share < 1.0:  # or not a number
            return np.zeros(M)
    errors, row = np.zeros(M), np.eye(n)[i]
    for j in range(k, -1, -1):
        errors[j], row = abs(row @ missed[j]), row @ flow[j]
    order = np.argsort(-errors)  # correcting only the largest ones may suffice
    enough = errors.sum() - np.cumsum(errors[order]) <= NODE_DEVIATION * tolerance
    errors[order[enough.argmax() + 1 :]] = 0.0
    return errors * M / NODE_DEVIATION


def _largest(difference: np.ndarray) -> np.ndarray:
    largest: np.ndarray = np.abs(difference).max(axis=1, initial=0.0)
    return np.where(np.isfinite(largest), largest, np.inf)


def _integrated(
    rate_function: RateFunction,
    transcription: Transcription,
    z: np.ndarray,
    x: np.ndarray,
    duration: float,
    steps: int,
) -> np.ndarray:
    """Return the states at the ends of the intervals, by `steps` equal steps in each."""
    tableau = tableau_of("dop853")
    problem, M = transcription.problem, transcription.intervals
    p, specifieds = transcription.numbers(z)
    starts = problem.begin + transcription.mesh[:-1] * duration
    lengths = np.diff(transcription.mesh) * duration
    # Inputs and controls do not depend on states: evaluate them for all RK stages at once.
    nodes = np.array(tableau.nodes[: len(tableau.stages)])
    s = ((np.arange(steps)[:, None] + nodes) / steps).ravel()
    times = starts + s[:, None] * lengths
    sampled = rate_function.inputs.rows(np.empty((times.size, x.shape[1])), times.ravel())
    r = np.array(np.broadcast_to(sampled, (times.size, sampled.shape[1])))
    middles = np.broadcast_to(starts + lengths / 2, times.shape).ravel()
    for columns, samples in problem.signals:
        if samples.interpolation == "previous":  # which may jump at nodes
            r[:, columns] = samples.rows(inside(times.ravel(), middles))
    numbers = [k - len(p) for k in problem.free if k >= len(p)]
    r[:, numbers] = specifieds[numbers]
    controls = list(problem.controls)
    control_values = transcription.controls_in(z, np.tile(np.arange(M), len(s)), np.repeat(s, M))
    r[:, controls] = control_values + (r[:, controls] if problem.noise else 0.0)
    instants, inputs = iter(times), iter(r.reshape(len(s), M, -1))
    x, h, stages = x.copy(), (lengths / steps)[:, None], np.empty((len(tableau.stages), x.size))

    def moved_by(row: Mapping[int, float]) -> np.ndarray:
        slope = np.array([*row.values()]) @ stages[[*row]]
        states: np.ndarray = x + h * slope.reshape(x.shape)
        return states

    with np.errstate(all="ignore"):  # a diverging motion has an infinite error
        for _ in range(steps):
            for stage, row in zip(stages, tableau.stages, strict=True):
                at = moved_by(row) if row else x
                stage[:] = rate_function.kernel.evaluate(next(instants), at, next(inputs), p)[
                    0
                ].ravel()
            x = moved_by(tableau.weights)
    return x


def refined(
    mesh: np.ndarray,
    error: np.ndarray,
    tolerance: float,
    order: int,
    extra_nodes: Iterable[float] = (),
) -> np.ndarray:
    """Return a mesh on which the errors should be within the tolerance.

    An interval is divided into enough equal parts for its error to fall below the tolerance, if
    the error is proportional to the length to the power `order` + 1. That holds for smooth
    controls only, so the number of parts is limited. `extra_nodes` are added, except those that
    nearly coincide with a node.
    """
    with np.errstate(divide="ignore"):
        parts = np.ceil((error / tolerance) ** (1.0 / (order + 1)))
    counts = np.clip(parts, 1, MOST_PARTS).astype(int)
    counts[error > tolerance] = np.maximum(counts[error > tolerance], 2)
    subdivided: Sequence[np.ndarray] = [
        np.linspace(a, b, num=k, endpoint=False)
        for a, b, k in zip(mesh[:-1], mesh[1:], counts, strict=True)
    ]
    nodes = np.concatenate([*subdivided, mesh[-1:]])
    for node in extra_nodes:
        k = int(np.searchsorted(nodes, node))
        before, after = node - nodes[k - 1], nodes[k] - node
        if min(before, after) > UNEVEN * (before + after):
            nodes = np.insert(nodes, k, node)
    return nodes


def jumps(
    transcription: Transcription, z: np.ndarray, error: np.ndarray, tolerance: float
) -> np.ndarray:
    """Return estimated jumps of controls and known jumps of inputs, as fractions of the motion.

    In consecutive intervals with too large an error, a control is assumed to jump from its value
    before them to its value after them; its integral determines where.
    """
    M, t, slots = transcription.intervals, transcription.mesh, transcription.scheme.controls
    s, w = np.polynomial.legendre.leggauss(LARGEST_ORDER // 2)
    values = transcription.split(z)[1][: len(transcription.problem.controls), slots.of_intervals(M)]
    basis = slots.basis(np.concatenate([[0.0, 1.0], (1.0 + s) / 2]))[0]
    first, last, *inner = np.einsum("cym,ys->scm", values, basis)
    integrals = np.tensordot(w / 2, inner, 1) * np.diff(t)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], error > tolerance, [0]])))
    nodes = [knots(transcription, error, tolerance)]
    for a, b in zip(edges[::2], edges[1::2], strict=True):
        if a > 0 and b < M:
            before, after, length = last[:, a - 1], first[:, b], t[b] - t[a]
            with np.errstate(all="ignore"):
                part = (integrals[:, a:b].sum(axis=1) - after * length) / (before - after)
            nodes.append(t[a] + part[(part > 0.0) & (part < length)])
    return np.concatenate(nodes)


def knots(transcription: Transcription, error: np.ndarray, tolerance: float) -> np.ndarray:
    """Return the knots of known inputs, at which these jump or bend, as fractions of the motion.

    Only knots in intervals with too large an error and few knots are returned; intervals with many
    knots are subdivided first. With an unknown duration there are none, as knots would move.
    """
    p, M = transcription.problem, transcription.intervals
    times = np.concatenate([np.empty(0), *(samples.breaks for _, samples in p.signals)])
    if p.duration is None or not len(times):
        return np.empty(0)
    fractions = np.unique((times - p.begin) / p.duration)
    fractions = fractions[(fractions > 0.0) & (fractions < 1.0)]
    k = np.searchsorted(transcription.mesh, fractions) - 1
    divisible = np.bincount(k, minlength=M) <= MOST_PARTS
    selected: np.ndarray = fractions[(divisible & (error > tolerance))[k]]
    return selected


def most_intervals(mesh: np.ndarray, order: int, tolerance: float) -> float:
    """Return a limit for the number of intervals, given a mesh with most errors below one.

    Where a control jumps, errors fall more slowly than with the order of the method, but few
    intervals are divided. A control that is rough everywhere, as one that has no effect, would have
    all intervals divided in every refinement.
    """
    enough: float = (len(mesh) - 1) * (1.0 / tolerance) ** (1.0 / max(order, 2))
    return MOST_PARTS * enough


def refuse_singular(
    rate_function: RateFunction,
    transcription: Transcription,
    x: np.ndarray,
    z: np.ndarray,
    sizes: np.ndarray,
    limits: Mapping[AnySymbol, tuple[float, float]],
) -> None:
    """Refuse constants at bounds where the equations have no solution, such as a mass of zero."""
    problem, first = transcription.problem, sum(transcription.sizes[:2])
    for k, (symbol, ends) in enumerate(limits.items()):
        for bound in ends:
            # The barrier keeps the constant at a distance of about tolerance^(1/3) from its bound.
            if abs(z[first + k] - bound) < TOLERANCE ** (1 / 3) * sizes[first + k]:
                p, r = problem.constants.copy(), np.ones((1, len(problem.specifieds)))
                p[problem.free[k]] = bound
                rates, failed = rate_function.kernel.evaluate(np.zeros(1), x[None], r, p)
                if failed.any() or not np.isfinite(rates).all():
                    raise OptimizationError(
                        f"The search brought `{symbol}` to its bound of {bound:g}, at which the "
                        "equations of motion have no solution: the objective has no minimum. Give "
                        f"`bounds[{symbol}]` a limit that they allow.",
                        None,
                    )


def refuse_unsolvable(
    rate_function: RateFunction,
    transcription: Transcription,
    z: np.ndarray,
    names: Sequence[AnySymbol],
) -> None:
    """Refuse constants with which the accelerations are undefined at every node."""
    states, _, _, duration = transcription.split(z)
    problem, (p, _) = transcription.problem, transcription.numbers(z)
    x = np.ascontiguousarray(states[:, : transcription.intervals + 1].T)
    times, r = problem.begin + transcription.mesh * duration, np.ones((1, len(problem.specifieds)))
    rates, failed = rate_function.kernel.evaluate(times, x, r, p)
    if (failed | ~np.isfinite(rates).all(axis=1)).all():
        zeros = [str(name) for name, value in zip(names, p, strict=True) if value == 0.0]
        raise OptimizationError(
            "The equations of motion give no accelerations at any node, though what was found "
            "satisfies them: the mass matrix is singular, and it is no motion. Give everything "
            f"that moves a mass{'; zero are: ' + ', '.join(zeros) if zeros else ''}.",
            None,
        )


def checked_mesh(mesh: object) -> np.ndarray:
    """Return the nodes as fractions."""
    nodes = real_array(mesh, "`mesh`")
    if nodes.ndim == 0:
        count, most = integer(mesh, "`mesh`"), int(TOLERANCE / ROUNDING)
        if count > most:
            raise ValueError(
                f"`mesh` must be at most {most:,} intervals, got {count:,}: on shorter ones, "
                "rounding of the states alone changes their rates by more than the search allows."
            )
        return np.linspace(0.0, 1.0, num=count + 1)
    if nodes.ndim != 1 or len(nodes) < 2 or not np.isfinite(nodes).all():
        raise ValueError(
            "`mesh` must be a number of intervals, or at least two finite nodes, got "
            f"{shown(mesh)}."
        )
    ascending(nodes, "`mesh`", strict=True)
    fractions: np.ndarray = (nodes - nodes[0]) / (nodes[-1] - nodes[0])
    return fractions


def warn_of_refinements(
    count: int, phases: Sequence[SolvedMotion], tolerance: float, failed: int = 0
) -> None:
    """Warn that refinement did not reach the tolerance.

    `failed` is the number of intervals of a next mesh on which the search failed, or zero.
    """
    errors = np.concatenate([phase.error for phase in phases])
    total = sum(phase.objective for phase in phases)
    if (errors > tolerance).any():
        status = (
            f"an error of {errors.max():.2g}, and {int((errors > tolerance).sum())} above "
            f"`mesh_tol` = {tolerance:g}"
        )
    else:
        off = sum(float(np.abs(phase.objective_error).sum()) for phase in phases)
        status = (
            f"an objective of {total:.3g} ± {off:.1g}, which is not as accurate as "
            f"`mesh_tol` = {tolerance:g} of it"
        )
    if failed:
        status += f". On the next one, of {failed}, the search found no solution"
    advice = (
        "Where controls jump, nodes of `mesh` near the jumps help; where they decide nothing, as "
        "on singular arcs, a small multiple of the integral of their squares in the objective; so "
        "does a larger `mesh_tol`"
    )
    search_error = sum(_error_of_search(phase) for phase in phases)
    if search_error > tolerance * abs(total):
        advice = (
            f"What the search leaves of the equations changes the objective by {search_error:.1g}: "
            "its slope by the ends is so large, as at the edge of what can be reached, that finer "
            "meshes are in vain. Move `start` or `end`, or pass a larger `mesh_tol`"
        )
    warn_user(
        f"After {counted(count, 'refinement')} the mesh of {counted(len(errors), 'interval')} has "
        f"{status}. {advice}."
    )


def _error_of_search(phase: SolvedMotion) -> float:
    """Return how much the residuals that the search leaves change the objective."""
    nlp, solution = phase._nlp, phase.solution
    values = nlp.native("rows", solution.z / nlp.sizes)[0]
    low, high = (side / nlp.row_sizes for side in nlp.row_bounds)
    violated = np.maximum(np.maximum(low - values, values - high), 0.0) * nlp.row_sizes
    return float(np.abs(solution.multipliers) @ violated)
