"""Parameters from measured motions by collocation.

    minimise ½ Σ ((model − sample) / noise)² + ½ Σ ((parameter − mean) / deviation)²
             + ½ ∫ Σ (disturbance / intensity)² dt

over the parameters, the states of all experiments and the disturbances, which are controls. The
states satisfy the equations at collocation points; nothing is integrated from the start, so that
unstable motions pose no difficulty. Each experiment is a transcription. Their unknowns are combined
in one vector, in which a shared parameter is a single unknown.

The covariance is the inverse of the Gauss–Newton Hessian reduced to the parameters. With the
equations A dw + B dp = 0 linearised at the optimum, a change dp determines the changes dw of states
and disturbances that minimise the residuals ``R dw + S dp``. J, the matrix of these residuals,
takes the place of the Jacobian of a fit. It is the solution of

    | −I  R  0 | | J |     | S |
    | Rᵀ  0  Aᵀ| | W | = − | 0 |
    | 0   A  0 | | Λ |     | B |

whose sparse factors grow in proportion to the length of the motions.

With disturbances, minimising the objective over parameters and disturbances together gives biased
parameters: it ignores how many disturbances explain the data nearly as well. Laplace's
approximation of the likelihood of the parameters alone adds ½ log det of the Hessian reduced to the
disturbances v,

    ½ log det H_v = ½ log |det K| − log |det A_x|,

with the matrix K above and the equations' derivatives A_x by the states. Its slope by the
parameters is computed by finite differences and added to the objective, until the estimates
converge.

References
----------
J. T. Betts, Practical Methods for Optimal Control and Estimation Using Nonlinear Programming,
2nd ed., ch. 5. H. G. Bock, Randwertproblemmethoden zur Parameteridentifizierung in Systemen
nichtlinearer Differentialgleichungen, Bonner Math. Schriften 183 (1987), for the covariance.
M. S. Varziri, K. B. McAuley and P. J. McLellan, Parameter and state estimation in nonlinear
stochastic continuous-time dynamic models with unknown disturbance intensity, Can. J. Chem. Eng. 86
(2008) 828–837, and A. Kristensen et al., TMB: automatic differentiation and Laplace approximation,
J. Stat. Softw. 70 (2016) 5, for the likelihood of the parameters alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import scipy.sparse

from pydy._errors import IntegrationError, warn_user
from pydy._judges import contradiction, rates
from pydy._rank import HALF, or_one
from pydy.control.guess import Limit
from pydy.control.ipopt import Iteration, NlpSolution
from pydy.control.kernel import ImplicitEquations
from pydy.control.nlp import Nlp, PointGroup
from pydy.control.problem import labels_of
from pydy.control.refine import RateFunction, checked_mesh, interval_errors, knots, refined
from pydy.control.schemes import Scheme, scheme_of
from pydy.control.transcription import TranscribedProblem, Transcription, metric_of, sizes_of
from pydy.control.tuning import (
    CONVERGED_SHARE,
    FIT_ORDER,
    LEAST_FIT_ERROR,
    MOST_CORRECTIONS,
    MOST_REFINEMENTS,
    PROXIMAL,
    PULLS,
    STEADY,
)
from pydy.solvers import DriftReport, Outcome

if TYPE_CHECKING:
    from scipy.sparse import csc_array, csr_array, dia_array

    from pydy._problem import Problem
    from pydy._sympy_types import AnySymbol
    from pydy.inputs import SampledInput


# The transcription of an experiment, and its unknowns.
_Motion: TypeAlias = tuple[Transcription, np.ndarray]


@dataclass(frozen=True, eq=False)
class Experiment:
    """A measured motion."""

    snapshot: Problem  # the System's snapshot as it was in this experiment
    begin: float  # the time of the initial conditions
    times: np.ndarray  # (m,)
    measured: tuple[AnySymbol, ...]  # states and outputs
    values: np.ndarray  # (m, q), the samples
    weights: np.ndarray  # (m, q), one over their noise; zero where there is no sample
    unknown: tuple[int, ...]  # states whose initial values are parameters of this experiment
    tied: tuple[int, ...]  # states whose initial values are determined by the constraints
    states: np.ndarray  # (m', n), the initial guess, at the times `at`
    at: np.ndarray  # (m',)


@dataclass(frozen=True, eq=False)
class Identified:
    """The result of an identification."""

    z: np.ndarray  # (k,), the parameters
    # For each experiment: model minus sample, divided by the noise, (m, q).
    residuals: list[np.ndarray]
    values: np.ndarray  # (r,), all residuals, those of disturbances included
    # Derivatives by the parameters, with states and disturbances as functions of these: (r, k) of
    # the residuals, (n, k) of all unknowns.
    jacobian: np.ndarray
    followed: np.ndarray
    largest: np.ndarray  # (n,), the largest absolute value of each state
    solution: NlpSolution  # of the last search


class Identification:
    """A fit as a nonlinear program."""

    def __init__(
        self,
        experiments: Sequence[Experiment],
        shared: Sequence[tuple[str, AnySymbol]],  # parameters of all, with their kinds
        noise: Mapping[AnySymbol, float],  # intensities of disturbances, by specifieds
        limits: tuple[np.ndarray, np.ndarray],  # of shared parameters, then of each experiment's
        priors: Sequence[tuple[int, float, float]],  # parameters with mean and deviation
    ) -> None:
        self.experiments, self.shared = experiments, shared
        self.noise, self.limits, self.priors = noise, limits, priors
        self.scheme: Scheme = scheme_of("radau", FIT_ORDER)
        self.problems: list[TranscribedProblem] = []
        for experiment in experiments:
            self.problems.append(self._problem(experiment))

    def shared_by(self, e: Experiment) -> list[tuple[str, int]]:
        """Return the kinds of shared parameters, and their indices in the arrays of an experiment.

        These differ: expressions for specifieds may contain specifieds of one experiment alone.
        """
        places = e.snapshot.definition.places
        return [(kind, places[kind].symbols.index(symbol)) for kind, symbol in self.shared]

    def _disturbed_by(self, e: Experiment) -> list[int]:
        """Return the indices of disturbances in the specifieds of an experiment."""
        symbols = e.snapshot.definition.places["specifieds"].symbols
        return [symbols.index(symbol) for symbol in self.noise]

    def _problem(self, e: Experiment) -> TranscribedProblem:
        snapshot, definition, plan = e.snapshot, e.snapshot.definition, e.snapshot.plan
        count, shared = len(definition.constants), self.shared_by(e)
        columns = [k + count * (kind == "specifieds") for kind, k in shared if kind != "states"]
        numbers: dict[str, Any] = {
            "constants": snapshot.p,
            "specifieds": plan.inputs.values,
            "signals": plan.inputs.sampled,
            "duration": float(e.times[-1]) - e.begin,
            "begin": e.begin,
            "metric": metric_of(np.abs(e.states).max(axis=0)),
        }
        labels, constraint_labels = labels_of(definition)
        start = (*e.unknown, *e.tied, *(k for kind, k in shared if kind == "states"))
        constraints = tuple(f"{label} at the start" for label in constraint_labels) if start else ()
        numbers["constraints"] = constraints
        for earlier, problem in zip(self.experiments, self.problems, strict=False):
            # Equal equations and kinds of inputs share their machine code.
            same = earlier.snapshot.code is snapshot.code and problem.measured == e.measured
            if same and [*map(_signal_columns, problem.signals)] == [
                *map(_signal_columns, plan.inputs.sampled)
            ]:
                return replace(problem, **numbers)
        return TranscribedProblem(
            equations=ImplicitEquations.from_snapshot(snapshot, disturbed=self._disturbed(e)),
            states=len(definition.states),
            labels=labels,
            controls=tuple(self._disturbed_by(e)),
            control_bounds=tuple((Limit(-np.inf), Limit(np.inf)) for _ in self.noise),
            free=tuple(columns),
            noise=tuple(self.noise.values()),
            measured=e.measured,
            **numbers,
        )

    def _disturbed(self, e: Experiment) -> bool:
        """Return whether a disturbance acts on a specified that is given as an expression."""
        return any(symbol in e.snapshot.plan.expressions for symbol in self.noise)

    def _rate_function(self, k: int) -> RateFunction:
        snapshot, disturbed = self.experiments[k].snapshot, self._disturbed(self.experiments[k])
        code = snapshot.model.with_compiled_inputs(snapshot.plan, perturbed=disturbed)
        return RateFunction(code.compiled("rates"), snapshot.inputs)

    def meshes(self, mesh: object) -> list[np.ndarray]:
        """Return the mesh of each experiment; by default it has one or two points a sample."""
        if mesh is not None:
            return [checked_mesh(mesh)] * len(self.experiments)
        points = 2 if self.noise else 1
        counts = [max(10, -(-points * len(e.times) // FIT_ORDER)) for e in self.experiments]
        return [np.linspace(0.0, 1.0, num=count + 1) for count in counts]

    def solve(
        self,
        z: np.ndarray,
        mesh: object,
        search: Callable[..., NlpSolution],
        watch: Callable[[Iteration], None],
    ) -> Identified:
        """Estimate the parameters, starting from z, with the solver that `solver_of` returns.

        Without a `mesh`, the default mesh is refined until its error is small compared with the
        residuals, or until the estimates move by little compared with their standard errors.
        """
        meshes = self.meshes(mesh)
        motions: list[_Motion | None] = [None] * len(self.experiments)
        slope, earlier = np.zeros(len(z)), np.full(len(z), np.inf)
        for count in range(1, MOST_REFINEMENTS + 1):
            combined = _CombinedExperiments(self, meshes)
            for _ in range(MOST_CORRECTIONS if self.noise else 1):
                nlp, residuals, start = combined.program(z, motions, slope)
                first = motions[0] is None and combined.collapses(nlp, start)
                for pull in (*PULLS, 0.0) if first else (0.0,):
                    program = combined.program(z, motions, slope, pull)[0] if pull else nlp
                    solution = search(program, start, watch=watch)
                    if solution.interrupted:
                        break
                    start = solution.z if solution.solved else start
                if solution.solved:
                    combined.check_constraints(solution)
                result = self._result(combined, nlp, residuals, solution)
                if not solution.solved or solution.interrupted:
                    return result
                z, parts = result.z, [solution.z[positions] for positions in combined.positions]
                motions = list(zip(combined.transcriptions, parts, strict=True))
                if not self.noise:
                    break
                before, slope = slope, combined.slope(nlp, residuals, result)
                # How far the estimates will move, in standard errors.
                change = np.linalg.lstsq(result.jacobian.T, slope - before)[0]
                if np.linalg.norm(change) <= CONVERGED_SHARE:
                    break
            shift = (
                np.linalg.norm(result.jacobian @ (z - earlier)) if earlier[0] < np.inf else np.inf
            )
            if mesh is not None or shift <= CONVERGED_SHARE * np.sqrt(np.mean(result.values**2)):
                return result
            earlier = z
            allowed, errors, limits = self._allowed(result), [], []
            for k, (transcription, part) in enumerate(
                zip(combined.transcriptions, parts, strict=True)
            ):
                sizes = transcription.split(nlp.sizes[combined.positions[k]])[0][:, 0]
                limits.append(max(allowed / transcription.intervals, LEAST_FIT_ERROR))
                errors.append(
                    interval_errors(self._rate_function(k), transcription, part, sizes, limits[-1])
                )
            if all(e.max() <= limit for e, limit in zip(errors, limits, strict=True)):
                return result
            if count == MOST_REFINEMENTS:
                break
            meshes = [
                refined(
                    transcription.mesh,
                    e,
                    limit,
                    self.scheme.convergence,
                    knots(transcription, e, limit),
                )
                for transcription, e, limit in zip(
                    combined.transcriptions, errors, limits, strict=True
                )
            ]
        worst = max(float(error.max()) for error in errors)
        warn_user(
            f"After {MOST_REFINEMENTS - 1} refinements the mesh of the fit has an error of "
            f"{worst:.2g} of the states' sizes. "
            "Where inputs jump, nodes of `mesh` at the jumps help."
        )
        return result

    def _allowed(self, result: Identified) -> float:
        """Return the relative error of the states that is negligible compared with the noise."""
        rows = [
            (r, e.values * e.weights)
            for r, e in zip(result.residuals, self.experiments, strict=True)
        ]
        noise = float(sum((r**2).sum() for r, _ in rows))
        size = float(sum((y**2).sum() for _, y in rows))
        # A hundredth of the noise adds its square to the sum of squared residuals.
        return 0.01 * np.sqrt(min(noise / size, 1.0)) if size > 0.0 else 0.01

    def _result(
        self, combined: _CombinedExperiments, nlp: Nlp, residuals: Nlp, solution: NlpSolution
    ) -> Identified:
        z = combined.at_bounds(nlp, solution)
        k = len(self.limits[0])
        values = residuals.native("rows", z / residuals.sizes)[0]
        parts, start = [], 0
        for e in self.experiments:
            size = e.values.size
            parts.append(values[start : start + size].reshape(-1, len(e.times)).T)
            start += size
        measured = np.concatenate([(e.weights > 0.0).T.ravel() for e in self.experiments])
        columns, factors = combined.disturbances()
        J, W = (
            (np.empty((0, k)), np.empty((0, k)))
            if solution.interrupted
            else combined.followed(nlp, residuals, z)
        )
        largest = np.max(
            [
                np.abs(transcription.split(z[positions])[0]).max(axis=1)
                for transcription, positions in zip(
                    combined.transcriptions, combined.positions, strict=True
                )
            ],
            axis=0,
        )
        return Identified(
            z[combined.parameters],
            parts,
            np.concatenate([values[measured], factors * z[columns]]),
            J,
            W,
            largest,
            solution,
        )


class _CombinedExperiments:
    """Experiments on meshes, with their unknowns in one vector, at the indices in `positions`."""

    def __init__(self, identification: Identification, meshes: Sequence[np.ndarray]) -> None:
        self.identification, self.experiments = identification, identification.experiments
        self.transcriptions = [
            Transcription(problem, identification.scheme, mesh)
            for problem, mesh in zip(identification.problems, meshes, strict=True)
        ]
        count = len(identification.shared)
        self.positions, start_parameters = [], []
        for e, transcription in zip(self.experiments, self.transcriptions, strict=True):
            slots, first = len(transcription.state_slots[0]), sum(transcription.sizes[:2])
            shared_slots, numbers = [], 0
            for kind, k in identification.shared_by(e):
                shared_slots.append(k * slots if kind == "states" else first + numbers)
                numbers += kind != "states"
            size = sum(transcription.sizes)
            alone = np.ones(size, dtype=bool)
            alone[shared_slots] = False
            positions = np.empty(size, dtype=int)
            positions[shared_slots] = np.arange(len(identification.shared))
            positions[alone] = count + np.arange(int(alone.sum()))
            count += int(alone.sum())
            self.positions.append(positions)
            start_parameters += [positions[k * slots] for k in e.unknown]
        self.size = count
        self.parameters = np.array(
            [*range(len(identification.shared)), *start_parameters], dtype=int
        )

    def program(
        self, z: np.ndarray, motions: Sequence[_Motion | None], slope: np.ndarray, pull: float = 0.0
    ) -> tuple[Nlp, Nlp, np.ndarray]:
        """Return the program, a second one whose rows are the residuals, and the initial guess.

        `slope` · parameters is added to the objective, and so is a `pull` towards z: a penalty on
        the parameters' relative changes.
        """
        identification = self.identification
        lower, upper = np.full(self.size, -np.inf), np.full(self.size, np.inf)
        start, sizes = np.empty(self.size), np.zeros(self.size)
        parts = []
        for e, transcription, positions, motion in zip(
            self.experiments, self.transcriptions, self.positions, motions, strict=True
        ):
            parts.append(part := _start(e, transcription, motion))
            nodes = np.arange(transcription.problem.states) * len(transcription.state_slots[0])
            fixed = nodes[[k for k in range(len(nodes)) if k not in (*e.unknown, *e.tied)]]
            lower[positions[fixed]] = upper[positions[fixed]] = e.snapshot.x[
                fixed // len(transcription.state_slots[0])
            ]
            start[positions] = part
        start[self.parameters] = z
        for side, limit in zip((lower, upper), identification.limits, strict=True):
            side[self.parameters] = limit
        groups: list[PointGroup] = []
        rows: list[PointGroup] = []
        for e, transcription, positions in zip(
            self.experiments, self.transcriptions, self.positions, strict=True
        ):
            open_ = np.full(len(positions), np.inf)
            np.maximum.at(
                sizes, positions, sizes_of(transcription, start[positions], -open_, open_)[0]
            )
            samples = transcription.samples(e.times, np.nan_to_num(e.values), e.weights)
            groups += [replace(p, at=positions[p.at]) for p in (*transcription.groups, samples[0])]
            rows.append(replace(samples[1], at=positions[samples[1].at]))
        groups.append(self._parameter_terms(slope, z, pull))
        nlp = Nlp(groups, lower, upper, sizes)
        return nlp.scaled_at(start), Nlp(rows, lower, upper, sizes), start

    def collapses(self, nlp: Nlp, start: np.ndarray) -> bool:
        """Return whether changing the parameters alone satisfies all equations that contain them.

        This happens if every term of an equation has an unknown mass, stiffness or similar factor:
        any motion satisfies the equation once all of these are zero, so that a search may converge
        to that solution.
        """
        y = start / nlp.sizes
        B = _matrix(nlp, y, nlp.rows, self.size)[:, self.parameters].toarray()
        rows = nlp.native("rows", y)[0]
        at = np.abs(B).max(axis=1, initial=0.0) > 0.0
        remaining = rows[at] - B[at] @ np.linalg.lstsq(B[at], rows[at])[0]
        return bool(at.any() and np.linalg.norm(remaining) <= HALF * np.linalg.norm(rows[at]))

    def _parameter_terms(self, slope: np.ndarray, z: np.ndarray, pull: float) -> PointGroup:
        """Return the objective's terms in the parameters: priors, slope and pull towards z."""
        problem = self.transcriptions[0].problem
        count = len(self.parameters)
        samples = [(np.nan_to_num(e.values) * e.weights).ravel() for e in self.experiments]
        size = float(np.linalg.norm(np.concatenate(samples)))
        data = np.array([z, pull * size / or_one(np.abs(z)), slope])
        for k, mean, deviation in self.identification.priors:
            data[:2, k] = mean, 1.0 / deviation
        at, none = self.parameters[None], np.empty(0)
        return PointGroup(problem.of_parameters(), at, data, none, (), np.full(count, np.nan))

    def check_constraints(self, solution: NlpSolution) -> None:
        """Refuse motions whose velocities violate the derivative of a holonomic constraint.

        A simulation of such a motion leaves the constraint, but collocation would return it as the
        optimum.
        """
        for e, transcription, positions in zip(
            self.experiments, self.transcriptions, self.positions, strict=True
        ):
            equations = e.snapshot.definition.equations
            if not equations.constraints.unenforced_holonomic:
                continue
            states, _, numbers, duration = transcription.split(solution.z[positions])
            times = np.minimum(e.begin + transcription.state_slots[0] * duration, e.times[-1])
            order = np.argsort(times, kind="stable")
            times, states = times[order], states.T[order]
            at = e.snapshot.at(times, states)
            p, r = at.p.copy(), at.r.copy()
            for k, value in zip(transcription.problem.free, numbers.tolist(), strict=True):
                if k < len(p):
                    p[k] = value
                else:
                    r[:, k - len(p)] = value
            values = replace(at, p=p, r=r).interpret(rates)
            # Rates at rest are rounding errors: compare them with the largest terms of the motion.
            values["sizes"] = np.broadcast_to(values["sizes"].max(axis=0), values["sizes"].shape)
            if not (report := DriftReport.contradiction(values)):
                continue
            k, t = report.state_index, float(times[report.state_index])
            status = f"cannot keep all constraints. {contradiction(equations, t, **report.details)}"
            info = {"code": int(Outcome.LEFT_CONSTRAINTS), "status": status}
            raise IntegrationError(f"`collocation` {status}", times, states, t, states[k], info)

    def disturbances(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the indices of the disturbances, and the factors that make them residuals."""
        unknowns, factors = [np.empty(0, dtype=int)], [np.empty(0)]
        for transcription, positions in zip(self.transcriptions, self.positions, strict=True):
            (points,) = transcription.scheme.points(transcription.mesh)
            for k, intensity in enumerate(transcription.problem.noise):
                first = transcription.sizes[0] + k * len(transcription.control_times)
                unknowns.append(positions[first + points.controls])
                assert transcription.problem.duration is not None
                factors.append(np.sqrt(transcription.problem.duration * points.weights) / intensity)
        return np.concatenate(unknowns), np.concatenate(factors)

    def at_bounds(self, nlp: Nlp, solution: NlpSolution) -> np.ndarray:
        """Return the unknowns, with parameters at active bounds set exactly to the bound.

        An interior-point method leaves a small product of a bound's distance and its multiplier;
        the bound is active if the multiplier is the larger one.
        """
        z = solution.z.copy()
        for side, multipliers in ((nlp.lower, solution.below), (nlp.upper, solution.above)):
            distance = np.abs(z - side) / nlp.sizes
            active = multipliers * nlp.sizes / nlp.cost_size > distance
            active &= np.isin(np.arange(self.size), self.parameters)
            z[active] = side[active]
        return z

    def followed(self, nlp: Nlp, residuals: Nlp, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the derivatives of residuals (r, k) and unknowns (n, k) by the parameters.

        States and disturbances depend on the parameters as described in the module.
        """
        R, A = self._linear(nlp, residuals, z)
        p, free = self.parameters, self._free(nlp)
        W = np.zeros((self.size, len(p)))
        W[p] = np.eye(len(p))
        if self._states_follow and A.shape[0] == free.sum():
            W[free] = scipy.sparse.linalg.splu(A[:, free].tocsc()).solve(-A[:, p].toarray())
            return R @ W / nlp.sizes[p], W * nlp.sizes[:, None] / nlp.sizes[p]
        # Divide the residuals by the largest derivative: the equations are scaled already.
        unit = float(np.abs(R.data).max(initial=0.0)) or 1.0
        R = R / unit
        right = -np.vstack(
            [R[:, p].toarray(), np.zeros((int(free.sum()), len(p))), A[:, p].toarray()]
        )
        K, shift = _system(R[:, free], A[:, free])
        factors = scipy.sparse.linalg.splu((K + shift).tocsc())
        solution = factors.solve(right)
        for _ in range(STEADY):
            solution = solution + factors.solve(right - K @ solution)
        count = R.shape[0]
        W[free] = solution[count : count + int(free.sum())]
        return solution[:count] * unit / nlp.sizes[p], W * nlp.sizes[:, None] / nlp.sizes[p]

    @property
    def _states_follow(self) -> bool:
        """Whether the equations determine all states: no controls, no redundant constraints."""
        return not any(p.controls or p.equations.constraints for p in self.identification.problems)

    def slope(self, nlp: Nlp, residuals: Nlp, result: Identified) -> np.ndarray:
        """Return the total derivatives of ½ log det H_v by the parameters."""
        z, sizes = result.solution.z, nlp.sizes[self.parameters]
        steps = np.linalg.norm(np.linalg.pinv(result.jacobian * sizes), axis=1) * sizes
        slopes = np.zeros(len(steps))
        for k, (direction, step) in enumerate(
            zip(result.followed.T, CONVERGED_SHARE * steps, strict=True)
        ):
            if step > 0.0:
                sides = [
                    self._half_log_determinant(nlp, residuals, z + s * step * direction)
                    for s in (1.0, -1.0)
                ]
                slopes[k] = (sides[0] - sides[1]) / (2.0 * step)
        return slopes

    def _half_log_determinant(self, nlp: Nlp, residuals: Nlp, z: np.ndarray) -> float:
        """Return ½ log det H_v up to a constant."""
        R, A = self._linear(nlp, residuals, z)
        free = self._free(nlp)
        states = free.copy()
        states[self.disturbances()[0]] = False
        none = scipy.sparse.csr_array((0, int(states.sum())))
        systems = [_system(R[:, free], A[:, free]), _system(none, A[:, states])]
        return 0.5 * (_log_determinant(*systems[0]) - _log_determinant(*systems[1]))

    def _free(self, nlp: Nlp) -> np.ndarray:
        """Return which unknowns are determined by the parameters."""
        free: np.ndarray = nlp.lower < nlp.upper
        free[self.parameters] = False
        return free

    def _linear(self, nlp: Nlp, residuals: Nlp, z: np.ndarray) -> tuple[csr_array, csr_array]:
        """Return the scaled Jacobians of residuals and equations."""
        y = z / nlp.sizes
        measured = np.concatenate([(e.weights > 0.0).T.ravel() for e in self.experiments])
        R = _matrix(residuals, y, residuals.rows, self.size)[measured]
        columns, factors = self.disturbances()
        entries = (factors * nlp.sizes[columns], (np.arange(len(columns)), columns))
        disturbance_rows = scipy.sparse.csr_array(entries, (len(columns), self.size))
        return scipy.sparse.vstack([R, disturbance_rows], "csr"), _matrix(
            nlp, y, nlp.rows, self.size
        )


def _start(e: Experiment, transcription: Transcription, motion: _Motion | None) -> np.ndarray:
    """Return the initial guess of an experiment's unknowns."""
    duration = transcription.problem.duration
    assert duration is not None
    controls = np.zeros((transcription.problem.algebraic, len(transcription.control_times)))
    if motion is None:
        times = e.begin + transcription.state_slots[0] * duration
        states = np.array([np.interp(times, e.at, column) for column in e.states.T])
    else:
        before, z = motion
        states = before.states_at(z, transcription.state_slots[0] * duration).T
        controls[: len(transcription.problem.controls)] = before.controls_at(
            z, transcription.control_times * duration
        ).T
    p = transcription.problem
    numbers = np.concatenate([p.constants, p.specifieds])[list(p.free)]
    return transcription.unknowns_of(states, controls, numbers, duration)


def _signal_columns(signal: tuple[np.ndarray, SampledInput]) -> list[int]:
    return signal[0].tolist()  # type: ignore[no-any-return]


def _matrix(nlp: Nlp, y: np.ndarray, rows: int, columns: int) -> csr_array:
    """Return the scaled Jacobian of a program's rows."""
    return scipy.sparse.csr_array((nlp.native("jacobian", y)[0], nlp.jacobian_at), (rows, columns))


def _system(R: csr_array, A: csr_array) -> tuple[csc_array, dia_array]:
    """Return K, and a diagonal that makes it regular despite redundant constraints."""
    K = scipy.sparse.block_array(
        [[-scipy.sparse.eye_array(R.shape[0]), R, None], [R.T, None, A.T], [None, A, None]],
        format="csc",
    )
    shift = np.repeat([0.0, PROXIMAL, -PROXIMAL], [R.shape[0], R.shape[1], A.shape[0]])
    return K, scipy.sparse.diags_array(shift)


def _log_determinant(K: csc_array, shift: dia_array) -> float:
    factors = scipy.sparse.linalg.splu((K + shift).tocsc())
    return float(np.log(np.abs(factors.U.diagonal())).sum())
