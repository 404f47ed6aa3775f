"""Fits by collocation: the states of all trials are unknowns, the equations are constraints."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

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
from pydy._names import counted
from pydy._problem import FIT, Problem
from pydy.analysis.fits.problem import FitProblem
from pydy.analysis.fits.result import Minimum
from pydy.analysis.tuning import FIXED_MESH_TOLERANCE
from pydy.control import Experiment, Identification, fitting_solver_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from pydy._sympy_types import AnySymbol, SymbolOrName


def collocated(
    problem: FitProblem,
    z: np.ndarray,
    mesh: int | ArrayLike | None,
    process_noise: Mapping[SymbolOrName, float] | None,
    solver: tuple[str, dict[str, object]],  # its name and options
    report: Callable[..., None],  # to a progress bar
) -> Minimum:
    """Return the least-squares minimum, searched for from z by a nonlinear program."""
    disturbances = _disturbances(problem, process_noise)
    search = fitting_solver_of(*solver)
    experiments = [_experiment(problem, z, k) for k in range(len(problem.trials))]
    fit = Identification(experiments, problem.shared, disturbances, problem.limits, problem.priors)

    def watch(iteration: Any) -> None:
        report(1, objective=f"{iteration.objective:.4g}", gap=f"{iteration.violation:.2g}")

    report(0, part="machine code")
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
            f"The fit did not converge in {counted(ended.iterations, 'iteration')}: "
            f"{ended.message}. The estimates are the last ones. Start closer to the solution, set "
            "`bounds` or raise `most`."
        )
    residuals = []
    for d, missed in zip(problem.trials, result.residuals, strict=True):
        table = np.where(np.isfinite(d.values), -missed * d.noise, np.nan)
        residuals.append(dict(zip(d.names, table.T, strict=True)))
    values, J = problem.with_priors(result.values, result.jacobian, result.z)
    return Minimum(
        result.z, values, J, residuals, result.largest,
        FIT if mesh is None else FIXED_MESH_TOLERANCE,
        ended.solved, ended.message, ended.iterations, len(result.followed), not disturbances,
    )  # fmt: skip


def _disturbances(
    problem: FitProblem, process_noise: Mapping[SymbolOrName, float] | None
) -> dict[AnySymbol, float]:
    """Return the intensities of white noise, by the symbol of the specified."""
    specifieds = problem.base.definition.places["specifieds"]
    process_noise = check_mapping("process_noise", process_noise)
    columns = specifieds.columns(process_noise, "process_noise").tolist()
    intensities = {
        specifieds.symbols[index]: positive(value, f"`process_noise[{key}]`", finite=True)
        for index, (key, value) in zip(columns, process_noise.items(), strict=True)
    }
    if intensities and problem.noise_is_estimated:
        raise ValueError(
            "`process_noise` needs the `noise` of each Trial: what is noise of the samples and "
            "what of the motion follows from their sizes."
        )
    return intensities


def _experiment(problem: FitProblem, z: np.ndarray, k: int) -> Experiment:
    """Return a trial as an experiment whose initial guess follows from its samples."""
    d, order = problem.trials[k], problem.states
    times = np.unique(np.append(d.start, d.times))
    if len(times) < 2:
        raise ValueError(
            f"`times` of {d.label} must hold a time after the start, got {float(times[0])!r} "
            "alone: collocation needs a motion."
        )
    motion_problem, _, _ = problem.motion(z, k, times)
    states = _guess(problem, k, motion_problem)
    if motion_problem.inputs.functions:
        raise ValueError(
            "`specifieds` gives a Python function for "
            f"{motion_problem.inputs.functions[0][1].label}, which has no derivatives. Give an "
            "expression of time and states, or samples."
        )
    weights = np.where(np.isfinite(d.values), 1.0 / d.noise, 0.0)
    unknown, dependents = ([order.index(s) for s in p] for p in (d.unknown, problem.dependents))
    return Experiment(
        motion_problem, d.start, d.times, tuple(d.keys), d.values, weights, tuple(unknown),
        tuple(dependents), states, times,
    )  # fmt: skip


def _guess(problem: FitProblem, k: int, motion_problem: Problem) -> np.ndarray:
    """Return the initial guess of a trial's states at the times of its Problem.

    Measured states are interpolated samples. Speeds that are rates of measured coordinates are the
    slopes of these. The others are simulated, or constant if the simulation fails.
    """
    d, order, times = problem.trials[k], problem.states, motion_problem.settings.times
    states = np.tile(motion_problem.x, (len(times), 1))
    columns_by_state = {}
    for key, column in zip(d.keys, d.values.T, strict=True):
        finite = np.isfinite(column)
        if key in order and finite.any():
            columns_by_state[key] = np.interp(times, d.times[finite], column[finite])
    equations = motion_problem.definition.equations
    derivatives = equations.kinematics.coordinate_derivatives
    rates = dict(zip(derivatives, equations.coordinates, strict=True))
    for speed, coordinate in rates.items():
        if coordinate in columns_by_state and speed in order and speed not in columns_by_state:
            columns_by_state[speed] = np.gradient(columns_by_state[coordinate], times)
    if len(columns_by_state) < len(order):
        options: dict[str, Any] = {"rtol": FIT, "atol": FIT}
        if problem.dependents:
            options["constraints"] = "project"
        try:
            solver = native_solver(problem.model.solver)
            motion = simulate(
                motion_problem, motion_problem.settings.times, solver=solver, **options
            )
            if np.isfinite(motion.states).all():
                states = motion.states.copy()
        except (IntegrationError, SingularMatrixError):
            pass  # constant states are a possible guess, too
    for symbol, column in columns_by_state.items():
        states[:, order.index(symbol)] = column
    return states
