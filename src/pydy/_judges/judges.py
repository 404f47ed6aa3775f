"""Check the start of a motion and the computed motion: warn of doubtful ones, refuse wrong ones."""

from __future__ import annotations

import numpy as np

from pydy._judges.assumptions import check_assumptions, check_orientations
from pydy._judges.constraint_drift import check_drift, check_resets, check_start
from pydy._judges.discontinuities import warn_of_impulses, warn_of_pulses
from pydy._motion import Motion, PreparedIntegration
from pydy._problem import AssumptionChecks, Problem
from pydy.solvers import Solver


def judge_start(problem: Problem, times: np.ndarray, ready: PreparedIntegration) -> None:
    """Warn of a start off the constraints, and once of inputs whose derivatives are impulses.

    If no constraint reports it, warn also if the matrix of a frame's orientation is no rotation.
    """
    at_start, off = (times[:1], problem.x[None]), False
    if ready.constrained:
        off = check_start(problem.at(*at_start), corrected=ready.enforced)
    if not off and problem.definition.equations.unit_quaternions:
        check_orientations(problem.at(*at_start))
    if not ready.start_judged and (problem.plan.expressions or ready.constrained):
        warn_of_impulses(problem, times)
    ready.start_judged = True


def judge_motion(motion: Motion) -> None:
    """Warn of a doubtful Motion, and raise if it left its constraints."""
    problem, integrator = motion.problem, motion.integrator
    if integrator.evaluated is not None and len(integrator.evaluated.jumps):
        warn_of_pulses(motion, integrator.evaluated)
    if AssumptionChecks(problem).judged() and len(motion.times):
        check_assumptions(motion)
    if problem.definition.equations.constraints.are_present and len(motion.times):
        if isinstance(integrator.solver, Solver) and not integrator.constraints_enforced:
            check_resets(motion.events, problem.at)
        check_drift(motion)
