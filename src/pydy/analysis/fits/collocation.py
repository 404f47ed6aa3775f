"""Fits by collocation: the states of all trials are unknown, and the equations hold in the end."""

from __future__ import annotations

from typing import Any

import numpy as np

from pydy._checks import check_mapping, positive
from pydy._errors import (
    FitInterrupted,
    IntegrationError,
    SingularMatrixError,
    note_finished,
    warn_user,
)
from pydy._integration import simulate
from pydy._motion import native_solver
from pydy._optional import progress_of
from pydy._problem import FIT, Problem
from pydy.analysis.fits.problem import FitProblem
from pydy.analysis.fits.result import Minimum
from pydy.analysis.tuning import ON_GIVEN_MESH
from pydy.control import Experiment, Identification, fitting_solver_of


def collocated(
    problem: FitProblem,
    z: np.ndarray,
    mesh: Any,
    process_noise: Any,
    solver: tuple[str, dict[str, Any]],  # its name and options
    progress: bool,
) -> Minimum:
    """Return the least squares from z on, by a nonlinear program."""
    disturbances = _disturbances(problem, process_noise)
    search = fitting_solver_of(*solver)
    experiments = [_experiment(problem, z, k) for k in range(len(problem.trials))]
    places = problem.now.definition.places
    shared = [(kind, places[kind].symbols.index(s)) for kind, s in problem.shared]
    fit = Identification(experiments, shared, disturbances, problem.limits, problem.priors)

    def watch(iteration: Any) -> None:
        bar(1, objective=f"{iteration.objective:.4g}", gap=f"{iteration.violation:.2g}")

    with progress_of(progress, " iterations") as bar:
        result = fit.solve(z, mesh, search, watch)
    ended = result.solution
    if ended.interrupted:
        latest = dict(zip(problem.names, result.z.tolist(), strict=True))
        if isinstance(stop := ended.interrupted, MemoryError):
            note_finished(stop, "The latest estimates are", values=latest)
            raise stop
        raise FitInterrupted(
            "The fit was interrupted. Its latest estimates are in `values`.", latest
        )
    if not ended.solved:
        warn_user(
            f"The fit did not converge in {ended.iterations} iterations: {ended.message}. "
            "The estimates are the last ones. Start closer to the solution, set `bounds` or raise "
            "`most`."
        )
    residuals = []
    for d, missed in zip(problem.trials, result.residuals, strict=True):
        table = np.where(np.isfinite(d.values), -missed * d.noise, np.nan)
        residuals.append(dict(zip(d.names, table.T, strict=True)))
    values, J = problem.with_priors(result.values, result.jacobian, result.z)
    return Minimum(
        result.z, values, J, residuals, result.largest, ON_GIVEN_MESH if mesh is not None else FIT,
        ended.solved, ended.message, ended.iterations, len(result.followed), not disturbances,
    )  # fmt: skip


def _disturbances(problem: FitProblem, process_noise: Any) -> dict[int, float]:
    """Return the intensities of white noise by places in r."""
    places = problem.now.definition.places["specifieds"]
    process_noise = check_mapping("process_noise", process_noise)
    columns = places.columns(process_noise, "process_noise").tolist()
    intensities = {
        place: positive(value, f"`process_noise[{key}]`", finite=True)
        for place, (key, value) in zip(columns, process_noise.items(), strict=True)
    }
    if intensities and problem.noise_is_estimated:
        raise ValueError(
            "`process_noise` needs the `noise` of each Trial: what is noise of the samples and "
            "what of the motion follows from their sizes."
        )
    return intensities


def _experiment(problem: FitProblem, z: np.ndarray, k: int) -> Experiment:
    """Return a trial as an experiment, whose search begins with its samples."""
    d, order = problem.trials[k], problem.states
    times = np.unique(np.append(d.start, d.times))
    if len(times) < 2:
        raise ValueError(
            f"`times` of {d.label} must hold a time after the start, got {float(times[0])!r} "
            "alone: collocation needs a motion."
        )
    now, _, _ = problem.motion(z, k, times)
    states = _guess(problem, k, now)
    if now.inputs.functions:
        raise ValueError(
            f"`specifieds` gives a Python function for {now.inputs.functions[0][1].label}, which "
            "has no derivatives. Give an expression of time and states, or samples."
        )
    weights = np.where(np.isfinite(d.values), 1.0 / d.noise, 0.0)
    unknown, dependents = ([order.index(s) for s in p] for p in (d.unknown, problem.dependents))
    return Experiment(
        now, d.start, d.times, tuple(d.keys), d.values, weights, tuple(unknown), tuple(dependents),
        states, times,
    )  # fmt: skip


def _guess(problem: FitProblem, k: int, now: Problem) -> np.ndarray:
    """Return the states of a trial where the search begins, at the times of its Problem.

    States that are measured are their samples, and speeds that are rates of such coordinates the
    slopes; the others are simulated if they can be, or stay where they are.
    """
    d, order, times = problem.trials[k], problem.states, now.settings.times
    states = np.tile(now.x, (len(times), 1))
    known = {}
    for key, column in zip(d.keys, d.values.T, strict=True):
        there = np.isfinite(column)
        if key in order and there.any():
            known[key] = np.interp(times, d.times[there], column[there])
    equations = now.definition.equations
    derivatives = equations.kinematics.coordinate_derivatives
    rates = dict(zip(derivatives, equations.coordinates, strict=True))
    for speed, coordinate in rates.items():
        if coordinate in known and speed in order and speed not in known:
            known[speed] = np.gradient(known[coordinate], times)
    if len(known) < len(order):
        options: dict[str, Any] = {"rtol": FIT, "atol": FIT}
        if problem.dependents:
            options["constraints"] = "project"
        try:
            solver = native_solver(problem.model.solver)
            motion = simulate(now, now.settings.times, solver=solver, **options)
            if np.isfinite(motion.states).all():
                states = motion.states.copy()
        except (IntegrationError, SingularMatrixError):
            pass  # the search may begin with states that stand still
    for symbol, column in known.items():
        states[:, order.index(symbol)] = column
    return states
