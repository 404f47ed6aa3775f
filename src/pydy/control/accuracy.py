"""Estimates of the error of an objective, by the Lagrangian between the collocation points.

With the multipliers Λ(t) of the equations r = 0 and ν(t) of the states' bounds b, interpolated,

    least objective − objective  ≈  Σ over intervals of
                                    ∫ (min over u of L + Λ · r) + ν · (x − b) dt − quadrature of L,

where r and L are evaluated along the polynomials of states and controls. The estimate is of second
order in the errors of motion and multipliers. The minimum is that of Pontryagin's principle, so
that better controls between the points count, such as one that jumps inside an interval, even where
the polynomials satisfy the equations exactly. With an exact motion and exact multipliers it is
zero.

The multipliers are not exact: where a control jumps inside an interval, their error is as large as
their change over the interval. Between the points, the control's polynomial may leave the bounds
and the equations may be violated, which makes the objective too small; elsewhere in the interval a
better control would lower it, and inaccurate multipliers let the two effects cancel. So only the
larger of the two is used, with the sign of their sum. The constant controls of the midpoint rule
cause both effects in every interval; there the sum is used if each control is either free or at a
bound along the interval.

The multipliers at the points of the midpoint rule and of Hermite–Simpson have errors of order h²,
as RK stages of an adjoint method; so have the controls, and these are the error of the objective.
The costates at the nodes have the full order of the method, so Λ is computed from cubics through
them, with slopes from the adjoint equation.

In an interval that does not resolve the motion, such as a boundary layer, the estimate is invalid.
The minimum between its nodes is then computed on a finer mesh.

References
----------
R. Becker and R. Rannacher, An optimal control approach to a posteriori error estimation in finite
element methods, Acta Numerica 10 (2001) 1–102, §2 (residuals weighted by the adjoint).
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Protocol

import numpy as np

from pydy._errors import warn_user
from pydy._rank import or_one
from pydy.control.costates import costates_of
from pydy.control.ipopt import NlpSolution
from pydy.control.local import least_between
from pydy.control.nlp import Nlp
from pydy.control.schemes import Slots, derivatives, lagrange, radau_points
from pydy.control.transcription import Transcription
from pydy.control.tuning import JUMPS, LAYERS, ONE_DIGIT, RESOLVED, SECANTS, STEP, TOLERANCE

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol


class SolvedMotion(Protocol):
    """A solution on a mesh, such as an `OptimalTrajectory`."""

    objective: float
    duration: float
    controls: tuple[AnySymbol, ...]
    mesh: np.ndarray
    error: np.ndarray
    solution: NlpSolution
    _nlp: Nlp
    _transcription: Transcription

    @property
    def objective_error(self) -> np.ndarray:
        """Each interval's share of the minimum minus this objective, shape (M,)."""


def objective_errors(transcription: Transcription, nlp: Nlp, solution: NlpSolution) -> np.ndarray:
    """Return each interval's share of the minimum minus the solution's objective, shape (M,).

    It is the larger of the positive and the negative contribution; see the module. It is NaN where
    constraints are enforced at other points than the equations of motion.
    """
    if len({points.rows for points in transcription.points}) > 1:
        return np.full(transcription.intervals, np.nan)
    z, M, scheme = solution.z, transcription.intervals, transcription.scheme
    s, w = np.polynomial.legendre.leggauss(scheme.order + 3)
    s, w, k = np.repeat((1.0 + s) / 2, M), w / 2, np.tile(np.arange(M), len(s))
    h = np.diff(transcription.mesh)
    point = _InterpolatedPoints(transcription, nlp, solution, k, s)
    if scheme.name != "radau":
        with suppress(np.linalg.LinAlgError):  # a singular mass matrix
            point.multipliers[: transcription.problem.states] = _by_costates(
                transcription, nlp, solution, point, s
            )
    lagrangian = point.lagrangian_of_polynomials()

    def integral(density: np.ndarray) -> np.ndarray:
        values: np.ndarray = h * (w @ density.reshape(len(w), M))
        return values

    bound_terms = _bound_terms(transcription, solution, k, s)
    missed = integral(lagrangian + bound_terms) - _quadrature(transcription, nlp, z)
    change = point.least() - lagrangian
    raised = np.maximum(missed, 0.0) + integral(np.maximum(change, 0.0))
    lowered = np.minimum(missed, 0.0) + integral(np.minimum(change, 0.0))
    total = raised + lowered
    larger: np.ndarray = np.where(total > 0.0, raised, lowered)
    if scheme.name != "midpoint":
        coarse = point.free & (_decrease(transcription, nlp, z) > RESOLVED)
        return _resolved(transcription, nlp, solution, larger, coarse)
    slack = integral(np.abs(bound_terms) + point.slack())
    return np.where(point.steady & (slack <= ONE_DIGIT * np.abs(total)), total, larger)


def _decrease(transcription: Transcription, nlp: Nlp, z: np.ndarray) -> np.ndarray:
    """Return the ratio of the motion's two highest Legendre moments in each interval, shape (M,).

    For exp(−z s) it is a ratio of two modified spherical Bessel functions: z/14 between degrees 2
    and 3 for small z, and near 1 if the interval is many times longer than the boundary layer.
    """
    # For Hermite–Simpson, use the degree of controls and multipliers.
    degree = transcription.scheme.order if transcription.scheme.name == "radau" else 2
    s, w = np.polynomial.legendre.leggauss(degree + 3)
    basis, powers = transcription.scheme.states.basis((1.0 + s) / 2)
    states, _, _, duration = transcription.split(z)
    lengths = np.diff(transcription.mesh) * duration
    values = states / transcription.split(nlp.sizes)[0].max(axis=1, keepdims=True)
    slots = values[:, transcription.scheme.states.of_intervals(transcription.intervals)]
    weights = basis[:, :, None] * lengths ** powers[:, None, None]
    x = np.einsum("nym,ysm->nms", slots, weights)
    moments = [
        np.linalg.norm(x @ (w * np.polynomial.legendre.Legendre.basis(k)(s)), axis=0)
        for k in (degree, degree - 1)
    ]
    with np.errstate(all="ignore"):
        ratios: np.ndarray = np.nan_to_num(moments[0] / moments[1])
    return ratios


def _resolved(
    transcription: Transcription,
    nlp: Nlp,
    solution: NlpSolution,
    parts: np.ndarray,
    coarse: np.ndarray,
) -> np.ndarray:
    """Return the errors of the intervals, those of `coarse` ones by an optimum on a finer mesh.

    In an interval that does not resolve the motion, such as a boundary layer, the multipliers are
    as inaccurate as the motion, and the estimate may even have the wrong sign. On the finer mesh
    the states at both nodes are fixed; the larger of the two estimates is used.
    """
    integrals, refined_parts = _quadrature(transcription, nlp, solution.z), parts.copy()
    size = np.abs(_quadrature(transcription, nlp, solution.z, True)).sum()
    matters = coarse & (np.abs(parts) > ONE_DIGIT**3 * size)
    for k in np.flatnonzero(matters)[np.argsort(-np.abs(parts[matters]), kind="stable")][:LAYERS]:
        least = least_between(transcription, nlp, solution.z, int(k))
        if abs(least - integrals[k]) > abs(parts[k]):  # False for NaN
            refined_parts[k] = least - integrals[k]
    return refined_parts


def relative_errors(
    phases: Sequence[SolvedMotion], tolerance: float, objective: float
) -> list[np.ndarray]:
    """Return the larger of each interval's errors of the states and of the objective, by phase.

    Errors of the objective are relative to its size and multiplied by the number of intervals. They
    are ignored if their sum is within the tolerance plus that of the search. `objective` is the sum
    over all phases, and so are these sums: errors of the phases add up.
    """
    parts, size, search_error = _objective(phases, objective)
    total, count = sum(part.sum() for part in parts), sum(map(len, parts))
    if total <= tolerance * size + search_error:
        return [phase.error for phase in phases]
    return [
        np.maximum(phase.error, part * count / size if size else np.inf)
        for phase, part in zip(phases, parts, strict=True)
    ]


def _objective(
    phases: Sequence[SolvedMotion], objective: float
) -> tuple[list[np.ndarray], float, float]:
    """Return the objective's errors by phase and interval, its size, and the error of the search.

    Phases without an estimate have no errors.
    """
    errors, size, search_error = [], 0.0, 0.0
    for phase in phases:
        transcription, nlp, solution = phase._transcription, phase._nlp, phase.solution
        no_estimate = transcription.scheme.convergence == 1
        if no_estimate or not np.isfinite(phase.objective_error).all():
            errors.append(np.zeros(transcription.intervals))
            size += abs(phase.objective)
            continue
        errors.append(np.abs(phase.objective_error))
        z = solution.z
        # The barrier method's remainder: each multiplier times the distance from its bound.
        sides = [(solution.below, z - nlp.lower), (solution.above, nlp.upper - z)]
        rows = nlp.native("rows", z / nlp.sizes)[0] * nlp.row_sizes
        (low, high), weights = nlp.row_bounds, solution.multipliers
        sides += [(np.minimum(weights, 0.0), rows - low), (np.maximum(weights, 0.0), high - rows)]
        search_error += TOLERANCE * nlp.cost_size + sum(
            float(np.abs(a[ok := np.isfinite(d)]) @ np.abs(d[ok])) for a, d in sides
        )
        integral = float(_quadrature(transcription, nlp, z, True).sum())
        size += max(abs(phase.objective), integral)
    return errors, max(abs(objective), size), search_error


def warn_where_coarse(phases: Sequence[SolvedMotion], objective: float) -> None:
    """Warn if a solution violates the equations, or if no digit of its objective is certain.

    In a simulation the errors of the intervals add up, if the motion is neither stable nor
    unstable.
    """
    worst = max(float(phase.error.max()) for phase in phases)
    total = float(sum(phase.error.sum() for phase in phases))
    parts, size, search_error = _objective(phases, objective)
    off = float(sum(part.sum() for part in parts))
    if not worst < 1.0:
        defect = (
            f"a motion that begins at a node with these controls misses the next one by {worst:.2g}"
            " times the size of a state. The solution is none of the equations' motions"
        )
    elif not total < 1.0:
        defect = (
            f"the errors of its intervals add up to {total:.2g} times the size of a state, which "
            "is how far a simulation with these controls may end from the solution"
        )
    elif off > ONE_DIGIT * size + search_error:
        j = int(np.argmax([part.max() for part in parts]))
        k, ends = int(parts[j].argmax()), phases[j].mesh
        of_phase = f" of phase {j}" if len(phases) > 1 else ""
        defect = (
            f"the objective of {objective:.3g} may be wrong by {off:.1g}, {parts[j][k]:.1g} of it "
            "by what happens between the collocation points "
            f"from t = {ends[k]:.4g} to {ends[k + 1]:.4g}{of_phase}"
        )
    else:
        return
    warn_user(f"The mesh is too coarse: {defect}. Use more intervals, or pass `mesh_tol`.")


def _quadrature(
    transcription: Transcription, nlp: Nlp, z: np.ndarray, absolute: bool = False
) -> np.ndarray:
    """Return each interval's share of the objective's integral, or of its absolute value."""
    M, integrals = transcription.intervals, np.zeros(transcription.intervals)
    h = np.diff(transcription.mesh)
    for group, points in zip(nlp.groups, transcription.points, strict=False):
        if not group.functions.outputs[1]:
            continue
        cost = group.evaluate("cost", z)[0]
        cost = np.abs(cost) if absolute else cost
        if len(cost) == M + 1:  # a node's weight is shared by the intervals on both sides
            cost = cost / points.weights
            integrals += h / 6 * (cost[:-1] + cost[1:])
        else:
            integrals += cost.reshape(-1, M).sum(axis=0)
    return integrals


class _InterpolatedPoints:
    """Equations and objective at fractions s of intervals k, where no collocation point is."""

    def __init__(
        self,
        transcription: Transcription,
        nlp: Nlp,
        solution: NlpSolution,
        k: np.ndarray,
        s: np.ndarray,
    ) -> None:
        z, p, scheme = solution.z, transcription.problem, transcription.scheme
        states, controls, _, T = transcription.split(z)
        M, length = transcription.intervals, np.diff(transcription.mesh)[k]
        self.fractions, self.h = transcription.mesh[k] + s * length, length * T
        h = self.h
        basis, powers = scheme.states.basis(s)
        # The derivatives of the basis, from its values at the nodes of polynomials of that degree.
        nodes = np.append(0.0, radau_points(max(scheme.order, 3)))
        rates = scheme.states.basis(nodes)[0] @ derivatives(nodes).T @ lagrange(nodes, s)
        y = states[:, scheme.states.of_intervals(M)[:, k]] * h ** powers[:, None]
        x, dx = (y * basis).sum(axis=1), (y * rates).sum(axis=1)
        zeros, unit, K = np.zeros(len(s)), np.ones(len(s)), scheme.order
        if scheme.name == "radau":
            slots, coefficients = [x, dx, *[0.0 * x] * (K - 1)], [zeros, unit, *[zeros] * (K - 1)]
        elif scheme.name == "midpoint":
            slots, coefficients = [x - dx / 2, x + dx / 2], []
        else:
            slots, coefficients = [x, dx / h], []
        u = controls[:, scheme.controls.of_intervals(M)[:, k]] * scheme.controls.basis(s)[0]
        u = u.sum(axis=1)
        self.transcription, self.group = transcription, nlp.groups[0]
        self.first = sum(map(len, slots))
        self.X = np.ascontiguousarray(
            [*np.concatenate(slots), *u, *z[transcription._numbers_at(len(s))]]
        )
        signals = p.signals_at(p.begin + self.fractions * T)
        self.R = np.ascontiguousarray([self.fractions, length, unit, *coefficients, *signals])
        self.multipliers = self._multipliers(nlp, solution, k, s)
        self.sizes = or_one(np.abs(controls).max(axis=1, initial=0.0))
        # By interval: whether each control is either free or at a bound along all of it; and
        # whether all controls are free.
        self.steady, self.free = np.ones((2, M), dtype=bool)
        self.bounded_controls = transcription.controls_in(z, k, s).T

    def _multipliers(
        self, nlp: Nlp, solution: NlpSolution, k: np.ndarray, s: np.ndarray
    ) -> np.ndarray:
        """Interpolate the multipliers of the rows, shape (rows, points)."""
        transcription = self.transcription
        parts = zip(nlp.by_group(solution.multipliers), transcription.points, strict=False)
        values = [rows / points.weights for (_, rows), points in parts]
        first, M, K = values[0], transcription.intervals, transcription.scheme.order
        if transcription.scheme.name == "hermite-simpson":
            nodes, at = np.array([0.0, 0.5, 1.0]), [first[:, k], values[1][:, k], first[:, k + 1]]
        elif K > 1:
            nodes, at = radau_points(K), [first[:, j * M + k] for j in range(K)]
        elif M > 1:  # one point in each interval: interpolate linearly between points
            times = transcription.points[0].fractions
            j = np.clip(np.searchsorted(times, self.fractions) - 1, 0, M - 2)
            s = (self.fractions - times[j]) / (times[j + 1] - times[j])
            nodes, at = np.array([0.0, 1.0]), [first[:, j], first[:, j + 1]]
        else:
            nodes, at = np.zeros(1), [first[:, k]]
        multipliers: np.ndarray = np.einsum("jm,jrm->rm", lagrange(nodes, s), np.array(at))
        # Multipliers of inequalities have a sign, which interpolation may violate.
        no_high, no_low = self.group.high == np.inf, self.group.low == -np.inf
        multipliers[no_high] = np.minimum(multipliers[no_high], 0.0)
        multipliers[no_low] = np.maximum(multipliers[no_low], 0.0)
        return multipliers

    def lagrangian_of_polynomials(self) -> np.ndarray:
        """Return L + Λ · r along the polynomials; then clip the controls to their bounds."""
        of_polynomials = self.lagrangian()
        self.X[self.first : self.first + len(self.bounded_controls)] = self.bounded_controls
        finite = np.isfinite(of_polynomials)
        lagrangian: np.ndarray = np.where(finite, of_polynomials, self.lagrangian())
        return lagrangian

    def by_states(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the derivatives of rows, then of the objective, by states and by their rates."""
        f, n, P = self.group.functions, self.transcription.problem.states, self.group.constants
        slopes = np.zeros((self.group.rows + 1, len(self.X), self.X.shape[1]))
        slopes[tuple(f.jacobian_at.T)] = f("jacobian", self.X, self.R, P)
        slopes[-1, f.gradient_at] = f("gradient", self.X, self.R, P)
        first, second = slopes[:, :n], slopes[:, n : 2 * n]
        if self.transcription.scheme.name == "midpoint":  # whose slots are the nodes
            return first + second, (second - first) * self.h / 2
        return first, second

    def slack(self) -> np.ndarray:
        """Return the sum of |multiplier · value| over the path inequalities."""
        rows = self.group.functions("rows", self.X, self.R, self.group.constants)
        open_ = self.group.low < self.group.high
        total: np.ndarray = np.abs(self.multipliers * rows)[open_].sum(axis=0)
        return total

    def lagrangian(self) -> np.ndarray:
        """Return L + Λ · r."""
        rows, cost = (
            self.group.functions(name, self.X, self.R, self.group.constants)
            for name in ("rows", "cost")
        )
        total: np.ndarray = (self.multipliers * rows).sum(axis=0) + cost.sum(axis=0)
        return total

    def slope(self, i: int, values: np.ndarray) -> np.ndarray:
        """Return the derivative of L + Λ · r by control i, at `values` of that control."""
        f, P, variable = self.group.functions, self.group.constants, self.first + i
        self.X[variable] = values
        derivative = np.zeros(len(values))
        for name, positions in (("jacobian", f.jacobian_at), ("gradient", f.gradient_at)):
            variables = positions[:, 1] if name == "jacobian" else positions
            if not (variables == variable).any():
                continue
            entries = f(name, self.X, self.R, P)
            for e in np.flatnonzero(variables == variable):
                derivative += entries[e] * (
                    self.multipliers[positions[e, 0]] if positions.ndim == 2 else 1.0
                )
        return derivative

    def least(self) -> np.ndarray:
        """Return the minimum of L + Λ · r over controls within their bounds."""
        p, before = self.transcription.problem, self.lagrangian()
        count = len(p.controls)
        for i in list(range(count)) * min(count, 2):  # one control at a time, in two rounds
            low, high = (side(self.fractions) for side in p.control_bounds[i])
            a = self.X[self.first + i].copy()
            slope = self.slope(i, a)
            far = np.where(slope > 0.0, low, high)
            bounded, size = np.isfinite(far), self.sizes[i]
            # Twice the distance to the minimum of a parabola, so that the step brackets it.
            bend = (self.slope(i, a + STEP * size) - slope) / (STEP * size)
            with np.errstate(all="ignore"):
                step = np.where(bend > 0.0, np.clip(2.0 * slope / bend, -size, size), 0.0)
            b = np.where(bounded, far, a - step)
            far_slope = self.slope(i, b)
            # It falls up to the bound, or the slope changes sign in between.
            falls = slope * far_slope > 0.0
            end = np.where(bounded, b, a)
            for _ in range(SECANTS):
                with np.errstate(all="ignore"):
                    m = a - slope * (b - a) / (far_slope - slope)
                m = np.where(np.isfinite(m), m, a)
                mid_slope = self.slope(i, m)
                before_root = mid_slope * slope > 0.0
                a, slope = np.where(before_root, m, a), np.where(before_root, mid_slope, slope)
                b = np.where(before_root, b, m)
                far_slope = np.where(before_root, far_slope, mid_slope)
            flat = np.where(np.abs(slope) < np.abs(far_slope), a, b)
            self.X[self.first + i] = np.where(falls, end, flat)
            at_bound = falls & (np.abs(end - self.bounded_controls[i]) <= STEP * size)
            kinds = at_bound, ~falls & (bend > 0.0)
            always = [kind.reshape(-1, self.transcription.intervals).all(axis=0) for kind in kinds]
            self.steady &= np.any(always, axis=0)
            free = (bend > 0.0) & ~(falls & bounded)
            self.free &= free.reshape(-1, self.transcription.intervals).all(axis=0)
        minimum: np.ndarray = np.fmin(before, self.lagrangian())
        return minimum


def _by_costates(
    transcription: Transcription,
    nlp: Nlp,
    solution: NlpSolution,
    point: _InterpolatedPoints,
    s: np.ndarray,
) -> np.ndarray:
    """Return the multipliers of the equations by cubics through the costates at the nodes.

    With q = (∂r/∂x')ᵀ Λ / T, the negative costate, dq/dτ = ∂L/∂x + Λ · ∂r/∂x + ν. The multiplier of
    a bound at a node is shared by the intervals on both sides, in proportion to their lengths.
    """
    M, n = transcription.intervals, transcription.problem.states
    T = transcription.split(solution.z)[3]
    h, k = np.diff(transcription.mesh), np.arange(transcription.intervals)
    jump = _of_bounds(transcription, solution)[:, :, : M + 1]
    share = (jump[1] - jump[0]) / (np.append(h, 0.0) + np.append(0.0, h))
    first, last = costates_of(transcription, nlp, solution)
    q = np.concatenate([-first - h * share[:, :M], h * share[:, 1:] - last], axis=1)
    ends = _InterpolatedPoints(
        transcription, nlp, solution, np.tile(k, 2), np.repeat([0.0, 1.0], M)
    )
    x, rates = ends.by_states()
    ends.multipliers[:n] = _solved(rates[:n], T * q)
    slopes = x[-1] + np.einsum("rp,rvp->vp", ends.multipliers, x[:-1])
    slopes += np.concatenate([share[:, :M], share[:, 1:]], axis=1)
    basis, at = Slots(2).basis(s)[0], np.tile(k, len(s) // M)
    end_values = (q[:, at], q[:, M + at], h[at] * slopes[:, at], h[at] * slopes[:, M + at])
    interpolated = sum(b * values for b, values in zip(basis, end_values, strict=True))
    return _solved(point.by_states()[1][:n], T * interpolated)


def _solved(rates: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Return Λ of (∂r/∂x')ᵀ Λ = q at each point."""
    multipliers: np.ndarray = np.linalg.solve(rates.transpose(2, 1, 0), q.T[..., None])[..., 0].T
    return multipliers


def _of_bounds(transcription: Transcription, solution: NlpSolution) -> np.ndarray:
    """Return the multipliers of low and high bounds of the states' slots, shape (2, n, slots)."""
    multipliers = np.array(
        [transcription.split(side)[0] for side in (solution.below, solution.above)]
    )
    ends = [0, transcription.intervals]
    multipliers[:, :, ends] = 0.0  # `start` and `end` are no bounds of the motion
    return multipliers


def _bound_terms(
    transcription: Transcription, solution: NlpSolution, k: np.ndarray, s: np.ndarray
) -> np.ndarray:
    """Return ν · (x − b), with the states x between the points and their bounds b."""
    scheme, M, h = transcription.scheme, transcription.intervals, np.diff(transcription.mesh)
    x = transcription.states_at(
        solution.z, (transcription.mesh[k] + s * h[k]) * transcription.split(solution.z)[3]
    ).T
    if scheme.name == "radau" and scheme.order > 1:
        nodes, slots = radau_points(scheme.order), scheme.states.of_intervals(M)[1:]
        weights = transcription.points[0].weights.reshape(scheme.order, M)
    else:
        nodes, slots = np.array([0.0, 1.0]), scheme.states.of_intervals(M)[:2]
        around = np.append(h, 0.0) + np.append(0.0, h)
        weights = np.array([around[:-1], around[1:]]) / 2
    basis = lagrange(nodes, s)
    fractions, total = transcription.mesh[k] + s * h[k], np.zeros(len(k))
    for side, (sign, values) in enumerate(
        zip((-1.0, 1.0), _of_bounds(transcription, solution), strict=True)
    ):
        for row, multipliers, bounds in zip(
            x, values, transcription.problem.state_bounds, strict=True
        ):
            if np.isfinite(bound := bounds[side](fractions)).all():
                nu = ((multipliers[slots] / weights)[:, k] * basis).sum(axis=0)
                excess = sign * (row - bound)
                if scheme.name == "radau":  # its inner points satisfy the bounds
                    excess = np.maximum(excess, 0.0)
                total += np.maximum(nu, 0.0) * excess
    return total


def warn_of_chatter(motion: SolvedMotion) -> None:
    """Warn where controls that enter linearly oscillate from point to point.

    Inside its bounds such a control makes its switching function zero. If that holds along an arc,
    the arc is singular, and the equations at the points do not determine the control fully. A
    reversal is weighted by the smaller of the two changes next to it. The weights are large if
    they add up to the control's size, and the reversals are many if the effective number of
    intervals, (Σ w)² / Σ w², exceeds what jumps at the ends of an arc explain. Intervals narrower
    than the mean are weighted by their width, as refinement puts many of them where a control
    jumps.
    """
    transcription, nlp, solution = motion._transcription, motion._nlp, motion.solution
    slots, arcs = len(transcription.control_times), []
    order = np.argsort(transcription.control_times, kind="stable")
    times = transcription.control_times[order]
    widths = np.diff(transcription.mesh, prepend=0.0) * transcription.intervals
    for i in _linear_controls(transcription):
        at = transcription.sizes[0] + i * slots + order
        u, size = solution.z[at], nlp.sizes[at]
        free = np.ones(len(at), dtype=bool)
        for bound, side in ((nlp.lower, solution.below), (nlp.upper, solution.above)):
            # Strict complementarity: either the multiplier or the distance is the larger one.
            free &= np.abs(u - bound[at]) / size > side[at] * size / nlp.cost_size
        free = (
            np.convolve(free, np.ones(3))[1:-1] > 0.0
        )  # a single point at a bound does not end an arc
        edges = np.flatnonzero(np.diff(np.concatenate([[0], free, [0]])))
        largest = np.abs(u).max(initial=0.0)
        for first, last in zip(edges[::2], edges[1::2] - 1, strict=True):
            d = np.diff(u[first : last + 1])
            back = np.where(d[1:] * d[:-1] < 0.0, np.minimum(abs(d[1:]), abs(d[:-1])), 0.0)
            k = np.searchsorted(transcription.mesh, times[first + 1 : last], "left")
            shares = np.bincount(k, back)
            total = float(back.sum())
            reach = total * min(total, float(shares @ widths[: len(shares)]))
            if total >= largest and reach > JUMPS * float(shares @ shares):
                turns = f"{int((back > 0.0).sum())} of {len(back)}"
                arcs.append((total / largest, i, times[[first, last]] * motion.duration, turns))
    if arcs:
        worst, i, (begin, end), turns = max(arcs, key=lambda arc: arc[0])
        other_count = len({arc[1] for arc in arcs}) - 1
        change = "" if transcription.scheme.name == "radau" else ", or use the method 'radau'"
        warn_user(
            f"The control `{motion.controls[i]}`"
            f"{f' (as {other_count} more)' if other_count else ''} enters "
            f"linearly and chatters from t = {begin:.4g} to {end:.4g}: it turns at {turns} points, "
            f"back and forth by {worst:.2g} times its size. There the objective hardly depends on "
            "it: the arc is singular, or another control decides alone. The objective may be right "
            "even so; for a smooth control, add a small multiple of the integral of its square to "
            f"the objective{change}."
        )


def warn_of_boundless_controls(motion: SolvedMotion) -> bool:
    """Warn where the duration is at its lower bound because nothing limits a control.

    A control that enters linearly, without bounds and path conditions, moves a body as fast as one
    likes. Return whether that is so.
    """
    transcription, nlp, solution = motion._transcription, motion._nlp, motion.solution
    p = transcription.problem
    if p.duration is not None or p.path or not np.isfinite(nlp.lower[-1]):
        return False
    # Strict complementarity, as in `warn_of_chatter`.
    size = nlp.sizes[-1]
    if (solution.z[-1] - nlp.lower[-1]) / size > solution.below[-1] * size / nlp.cost_size:
        return False
    slots = len(transcription.control_times)
    for i in _linear_controls(transcription):
        at = transcription.sizes[0] + i * slots + np.arange(slots)
        if not (np.isfinite(nlp.lower[at]) | np.isfinite(nlp.upper[at])).any():
            warn_user(
                f"The duration is at its lower bound, {nlp.lower[-1]:.4g} s: nothing limits the "
                f"control `{motion.controls[i]}`, so that any motion is as fast as this bound "
                f"allows. Give `bounds={{'{motion.controls[i]}': (low, high)}}`, or an objective "
                "that grows with its square."
            )
            return True
    return False


def _linear_controls(transcription: Transcription) -> list[int]:
    """Return the controls that enter linearly: no second derivative by controls involves them."""
    p = transcription.problem
    if p.hessian != "exact":
        return []
    curved: set[int] = set()
    for functions, points in zip(
        (x.functions for x in transcription.groups), transcription.points, strict=False
    ):
        first = len(points.slots) * p.states
        pairs = functions.hessian_at - first
        inside = ((pairs >= 0) & (pairs < len(p.controls))).all(axis=1)
        curved |= set(pairs[inside].ravel().tolist())
    return [i for i in range(len(p.controls)) if i not in curved]
