"""Fits by shooting: residuals and their derivatives from simulations with sensitivities.

A trial may be divided into segments, each with its own initial state (multiple shooting). The gaps
between segments are additional residuals, whose weights grow from search to search.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._errors import IntegrationError, SingularMatrixError
from pydy._integration import simulate
from pydy._motion import call_odeint, is_implicit, is_odeint, native_solver
from pydy._problem import FIT, Problem
from pydy.analysis.fits.problem import FitProblem
from pydy.analysis.fits.result import Minimum
from pydy.analysis.fits.samples import TrialSamples
from pydy.analysis.fits.search import estimate
from pydy.analysis.trial_steps import limited_steps
from pydy.analysis.tuning import LEAST_SIZE, REPORT_INTERVAL
from pydy.solvers import SOLVERS
from pydy.trajectory import Trajectory

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol

# Weights of the gaps between segments, relative to the states' spread, from search to search.
_WEIGHTS = (1e1, 1e3, 1e5)


@dataclass(frozen=True)
class _TrialSegment:
    """A part of a trial that is simulated by itself: samples ``first <= k < last``."""

    first: int
    last: int
    begin: float  # its first time
    end: float
    column: int | None  # of its initial states in z; None for the trial's initial conditions


class ShootingFit:
    """The residuals of a fit as a function of z."""

    def __init__(
        self,
        problem: FitProblem,
        segments: int,
        options: dict[str, Any],
        report: Callable[..., None],
    ) -> None:
        self.problem = problem
        self.report = report  # to a progress bar, by its number of evaluations
        self.options = {"rtol": FIT, "atol": FIT, **options}
        self.chosen = "atol" not in options  # whether absolute tolerances follow the states' sizes
        if problem.dependents:
            self.options.setdefault("constraints", "project")
        self.names = list(problem.names)  # of all of z
        self.segments = [self._split_trial(d, segments) for d in problem.trials]
        self.motions = sum(map(len, self.segments))  # of one evaluation
        self.simulated = 0  # motions of the present evaluation
        self.steps, self.best_steps = 0, 0  # of its longest motion; of that of the best estimates
        self.misfit: dict[str, str] = {}  # that of the latest evaluation, as it is shown
        self.next_report = 0.0  # of motions, by `time.monotonic`
        self.state_indices = [problem.states.index(s) for s in problem.independent]
        self.state_spread = np.ones(len(problem.independent))
        n = len(problem.states)
        self.largest, self.sizes = np.zeros(n), np.ones(n)
        self.weight = 0.0  # of the gaps
        self.is_gap = np.empty(0, dtype=bool)
        self.solver = native_solver(problem.model.solver)
        if self._is_stiff():
            self.solver = SOLVERS["radau"]

    def _split_trial(self, d: TrialSamples, segments: int) -> list[_TrialSegment]:
        m = len(d.times)
        edges = np.unique(np.linspace(0, m - 1, segments + 1).round().astype(int))
        parts = []
        for j, (a, b) in enumerate(pairwise(edges)):
            column = None
            if j:
                column = len(self.names)
                self.names += [
                    f"{s} of {d.label} at {d.times[a]:g}" for s in self.problem.independent
                ]
            first = int(a) + 1 if j else 0
            begin = float(d.times[a]) if j else d.start
            parts.append(_TrialSegment(first, int(b) + 1, begin, float(d.times[b]), column))
        return parts or [_TrialSegment(0, m, d.start, float(d.times[-1]), None)]

    def _is_stiff(self) -> bool:
        """Return whether the equations are stiff, which the user's solver shows.

        It is an implicit method of SciPy, or odeint, which switches to an implicit method. An
        explicit method would need steps that are limited by stability, whatever its tolerance.
        """
        solver, segment = self.problem.model.solver, self.segments[0][0]
        times = self.problem.trials[0].times[segment.first : segment.last]
        times = np.unique(np.append(segment.begin, times))
        if is_implicit(solver):
            return True
        if not is_odeint(solver) or "events" in self.options or len(times) < 2:
            return False
        trial_problem, _, _ = self.problem.motion(self.problem.start, 0, times)

        def rates(x: np.ndarray, t: float) -> np.ndarray:
            row: np.ndarray = trial_problem.at(np.array([t]), x[None]).rates()[0]
            return row

        with suppress(RuntimeError, SingularMatrixError):  # the fit itself will report these
            _, info = call_odeint(rates, trial_problem.x, times, (), self.problem.states, {})
            return bool(np.mean(info["mused"] == 2) > 0.5)  # odeint's method for stiff equations
        return False

    # -- simulations ------------------------------------------------------------------------------

    def simulate(self, trial_problem: Problem, parameters: list[AnySymbol]) -> Trajectory:
        """Simulate with sensitivities."""
        motion = simulate(
            trial_problem,
            trial_problem.settings.times,
            solver=self.solver,
            sensitivities=parameters,
            **limited_steps(self.options, self.best_steps),
        )
        self.steps = max(self.steps, motion.statistics["steps"])
        return motion.trajectory

    def simulate_segment(
        self, z: np.ndarray, k: int, segment: _TrialSegment
    ) -> tuple[Trajectory, list[int], int]:
        """Simulate a segment; return its motion, the columns, and the first sample's index."""
        d = self.problem.trials[k]
        times = d.times[segment.first : segment.last]
        skip = int(not len(times) or times[0] > segment.begin)
        times = np.append(segment.begin, times) if skip else times
        if len(times) < 2:
            times = np.append(times, times)  # a single sample, at the start of the segment
        trial_problem, parameters, columns = self.problem.motion(z, k, times, segment.column)
        motion = self.simulate(trial_problem, parameters)
        self.largest = np.maximum(self.largest, np.abs(motion.states).max(axis=0))
        self._report_motion()
        if len(motion.times) < len(times):
            raise ValueError(
                f"An event ended {d.label} at t = {float(motion.times[-1])!r}, before the last of "
                "its samples. Pass events that are not terminal, or leave out later samples."
            )
        return motion, columns, skip

    def _report_motion(self) -> None:
        """Show how many motions of an evaluation are simulated, not more often than a bar moves."""
        self.simulated += 1
        if self.motions > 1 and (now := time.monotonic()) >= self.next_report:
            self.next_report = now + REPORT_INTERVAL
            self.report(0, motions=f"{self.simulated}/{self.motions}", **self.misfit)

    def evaluate(self, z: np.ndarray, *, first: bool = False) -> tuple[np.ndarray, np.ndarray]:
        """Return residuals and gaps of all trials, and their derivatives.

        At the `first` z of a search, all must be finite.
        """
        self.simulated, self.steps = 0, 0
        values, slopes, gaps = [], [], []
        for k, d in enumerate(self.problem.trials):
            for j, segment in enumerate(self.segments[k]):
                motion, columns, skip = self.simulate_segment(z, k, segment)
                run = slice(skip, skip + segment.last - segment.first)
                noise = d.noise[segment.first : segment.last]
                model = np.stack([motion[key][run] for key in d.keys], axis=1)
                measured = np.isfinite(d.values[segment.first : segment.last])
                J = np.zeros((*model.shape, len(z)))
                with np.errstate(all="ignore"):  # the search rejects values that are not finite
                    missed = (model - d.values[segment.first : segment.last]) / noise
                    for q, key in enumerate(d.keys):
                        J[:, q, columns] = motion.sensitivity[key][run] / noise[:, q, None]
                sound = np.isfinite(missed) & np.isfinite(J).all(axis=2)
                if first and (measured & ~sound).any():
                    at, q = np.argwhere(measured & ~sound)[0].tolist()
                    raise ValueError(
                        f"`measured[{d.names[q]}]` of {d.label} has no finite value or "
                        "derivatives in the motion that the search begins with: at t = "
                        f"{d.times[segment.first + at]:g} it is {model[at, q]:g}. Begin with other "
                        "constants or initial conditions, or measure another expression."
                    )
                values.append(missed[measured])
                slopes.append(J[measured])
                gaps.append(np.zeros(len(values[-1]), dtype=bool))
                if j + 1 < len(self.segments[k]):
                    ahead = self._start_columns(self.segments[k][j + 1])
                    scale = self.weight / self.state_spread
                    G = np.zeros((len(self.state_indices), len(z)))
                    with np.errstate(all="ignore"):
                        values.append((motion.states[-1][self.state_indices] - z[ahead]) * scale)
                        G[:, columns] = (
                            motion.sensitivity.values[-1][self.state_indices] * scale[:, None]
                        )
                    G[:, ahead] -= np.diag(scale)
                    slopes.append(G)
                    gaps.append(np.ones(len(G), dtype=bool))
        self.is_gap = np.concatenate(gaps)
        return np.concatenate(values), np.concatenate(slopes)

    def _start_columns(self, segment: _TrialSegment) -> slice:
        """Return the columns of the initial states of a segment, which is not the first one."""
        assert segment.column is not None
        return slice(segment.column, segment.column + len(self.state_indices))

    def update_sizes(self) -> bool:
        """Set the sizes of the states and tolerances; return whether these became much tighter.

        A state that is much smaller than the other coordinates, or the other speeds, may be a
        rounding error of these: sizes are at least a share of the largest.
        """
        first = len(self.problem.base.definition.equations.coordinates)
        for part in (slice(first), slice(first, None)):
            largest = self.largest[part]
            size = largest.max(initial=0.0)
            least = min(1.0, LEAST_SIZE * size)
            self.sizes[part] = np.maximum(largest, least) if size > 0.0 else 1.0
        if self.chosen:
            self.options["atol"] = FIT * np.minimum(self.sizes, 1.0)
        return self.chosen and bool(self.sizes.min() < 0.1)  # those of the first runs are 1

    # -- the search -------------------------------------------------------------------------------

    def guess(self) -> np.ndarray:
        """Return the initial guess: segments start from measured or simulated states."""
        problem = self.problem
        z = np.append(problem.start, np.zeros(len(self.names) - problem.count))
        starts = []
        for k, d in enumerate(problem.trials):
            for segment, following in pairwise(self.segments[k]):
                try:
                    end = self.simulate_segment(z, k, segment)[0].states[-1].copy()
                except (IntegrationError, SingularMatrixError):
                    end = np.zeros(len(problem.states))
                for q, key in enumerate(d.keys):
                    sample = d.values[segment.last - 1, q]
                    if key in problem.states and np.isfinite(sample):
                        end[problem.states.index(key)] = sample
                z[self._start_columns(following)] = end[self.state_indices]
                starts.append(end[self.state_indices])
        if starts:
            self.update_sizes()
            least = 1e-2 * self.sizes[self.state_indices]  # lower bound of the gaps' scales
            self.state_spread = np.maximum(np.std(starts, axis=0), least)
        return z

    def minimum(self, z: np.ndarray, most: int) -> Minimum:
        """Return the least-squares minimum, searched for from z by at most `most` evaluations."""
        problem, count, least = self.problem, 0, np.inf
        size = problem.samples + (len(z) - problem.count)
        # A search may try values that contacts reject: a negative gap, a restitution above one.
        contacts = problem.model.problem.hybrid
        refused = () if contacts is None else (contacts.infeasible,)

        def evaluate(z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
            nonlocal count, least
            count += 1
            try:
                values, slopes = self.evaluate(z, first=count == 1)
                if count == 1 and self.update_sizes():
                    values, slopes = self.evaluate(z)
            except (IntegrationError, SingularMatrixError, *refused):
                if count == 1:
                    raise
                values, slopes = np.full(size, np.nan), np.zeros((size, len(z)))
            with np.errstate(all="ignore"):
                missed, gaps = values[~self.is_gap], np.abs(values[self.is_gap])
                self.misfit = {"residual": f"{np.sqrt(np.mean(missed**2)):.4g}"}
                if len(gaps):
                    self.misfit["gap"] = f"{gaps.max() / self.weight:.2g}"
                self.report(1, **self.misfit)
                if (cost := float(values @ values)) < least:
                    least, self.best_steps = cost, self.steps
                return problem.with_priors(values, slopes, z)

        weights = _WEIGHTS if len(z) > problem.count else (0.0,)
        for self.weight in weights:
            least = np.inf  # gaps weigh more than before
            z, values, J, ended = estimate(
                evaluate, z, problem.limits, self.names, most, warns=self.weight == weights[-1]
            )
        values, J, residuals = self._without_gaps(values, J)
        return Minimum(
            z, values, J, residuals, self.sizes, float(np.max(self.options["rtol"])),
            bool(ended.success), str(ended.message), count,
        )  # fmt: skip

    def _without_gaps(
        self, values: np.ndarray, J: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, list[dict[str, np.ndarray]]]:
        """Return residuals without gaps, their derivatives, and the tables of residuals."""
        k = self.problem.count
        gap = np.append(self.is_gap, np.zeros(len(values) - len(self.is_gap), dtype=bool))
        by_parameters = J[~gap, :k]
        if gap.any():
            # The segments' initial states follow from the parameters if the gaps stay closed.
            follow = np.linalg.solve(J[gap, k:], -J[gap, :k])
            by_parameters = by_parameters + J[~gap, k:] @ follow
        residuals, start = [], 0
        for d, segments in zip(self.problem.trials, self.segments, strict=True):
            table = np.full(d.values.shape, np.nan)
            for j, segment in enumerate(segments):
                run = slice(segment.first, segment.last)
                measured = np.isfinite(d.values[run])
                block = np.full(measured.shape, np.nan)
                count = int(measured.sum())
                block[measured] = -values[start : start + count]
                table[run] = block * d.noise[run]
                start += count + (len(self.state_indices) if j + 1 < len(segments) else 0)
            residuals.append(dict(zip(d.names, table.T, strict=True)))
        return values[~gap], by_parameters, residuals
