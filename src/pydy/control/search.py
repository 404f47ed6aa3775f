"""The search for optimal trajectories: of one problem, or of several that are solved as one.

`TrajectorySearch.solve` solves on one mesh after another (`_solved`), refined where errors exceed
the tolerance. On each mesh

1. `_combined_program` makes the nonlinear program, and its initial point from the guess, clipped to
   the bounds; of several problems that are solved together, `_together` joins the programs;
2. a solver of `pydy.control.solvers` searches from that point, or from a solution on the same mesh,
   then with its multipliers;
3. each problem makes a trajectory of its part of the solution.

The `start` of a problem is the state at which its motion starts, not where the search does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from copy import copy
from dataclasses import replace
from itertools import repeat
from typing import TYPE_CHECKING, Any, Generic, NamedTuple, Protocol, TypeVar

import numpy as np

from pydy._checks import check_mapping, flag, positive, real_array, refuse_twice
from pydy._errors import OptimizationError, finished_before
from pydy._names import counted
from pydy._optional import progress_of
from pydy.control.accuracy import (
    relative_errors,
    warn_of_boundless_controls,
    warn_of_chatter,
    warn_where_coarse,
)
from pydy.control.ipopt import Iteration, NlpSolution
from pydy.control.nlp import Nlp, PointGroup
from pydy.control.refine import (
    jumps,
    most_intervals,
    refined,
    warn_of_refinements,
)
from pydy.control.result import OptimalTrajectory, why_in_vain, worst_rows
from pydy.control.solvers import solver_of
from pydy.control.transcription import Transcription, metric_of, sizes_of
from pydy.control.tuning import LEAST_MESH_TOL, MOST_REFINEMENTS, TOLERANCE

if TYPE_CHECKING:
    import sympy as sm
    from numpy.typing import ArrayLike

    from pydy._problem import Problem
    from pydy._sympy_types import AnySymbol, SymbolOrName
    from pydy.control.schemes import Scheme
    from pydy.control.transcription import TranscribedProblem


Result = TypeVar("Result")


class PhaseProgram(NamedTuple):
    """A problem on its mesh."""

    transcription: Transcription
    program: Nlp
    positions: np.ndarray  # the indices of its unknowns in the full program
    state_sizes: np.ndarray  # the size of each state in the guess


class ModelledSystem(Protocol):
    """A System, which returns its model with its numbers."""

    def _now(self, *, further: Iterable[AnySymbol] = ()) -> Problem:
        """Return everything as it is now, with some further constants."""


class SearchableProblem(Protocol):
    """What a search needs of an `OptimalControl`."""

    _snapshot: Problem
    _problem: TranscribedProblem
    _scheme: Scheme
    _mesh: np.ndarray
    _controls: tuple[AnySymbol, ...]
    _free: tuple[AnySymbol, ...]
    _symbol: sm.Symbol | None  # of an unknown duration
    _start: dict[AnySymbol, tuple[float, float]]
    _begins: frozenset[AnySymbol]  # states with an entry in `start`
    _start_constraints: tuple[str, ...]

    @property
    def _hint(self) -> str:
        """A hint for the message of a search that failed."""

    def _on(self, mesh: np.ndarray) -> Transcription:
        """Return the transcription on a mesh."""

    def _bounds_of(self, transcription: Transcription) -> tuple[np.ndarray, np.ndarray]:
        """Return the bounds of the unknowns."""

    def _guess(
        self, transcription: Transcription, user_guess: object, lower: np.ndarray, upper: np.ndarray
    ) -> np.ndarray:
        """Return the user's guess, completed by linear interpolation between the ends."""

    def _check_start(self, transcription: Transcription, z: np.ndarray, sizes: np.ndarray) -> None:
        """Refuse a start that violates the constraints, or that they leave undetermined."""

    def _with(self, columns: Sequence[int], numbers: Sequence[float]) -> SearchableProblem:
        """Return the problem with other values of constants."""

    def _trajectory(
        self, transcription: Transcription, nlp: Nlp, state_sizes: np.ndarray, solution: NlpSolution
    ) -> OptimalTrajectory:
        """Return the trajectory of a solution."""

    def _propagated_errors(self, motion: OptimalTrajectory, tolerance: float) -> np.ndarray:
        """Return which intervals make a simulation miss the nodes."""

    def _warn_of_crossings(self, motion: OptimalTrajectory) -> None:
        """Warn if the objective or a path condition is discontinuous along a solution."""


class TrajectorySearch(Generic[Result]):
    """Optimal control problems that are solved together, with a result of type `Result`."""

    _problems: Sequence[SearchableProblem]

    def check(self, guess: object = None) -> None:
        """Check the problem before the search.

        Parameters
        ----------
        guess : dict or Trajectory, optional
            As for `solve`.

        Raises
        ------
        ValueError
            `start` or `end` contradicts `bounds`, the guess violates `bounds`, an unknown duration
            has neither bounds nor a guess, or there are fewer unknowns than equations.
        """
        self._combined_program([problem._mesh for problem in self._problems], self._guesses(guess))

    def solve(
        self,
        guess: object = None,
        *,
        mesh_tol: float | None = None,
        options: Mapping[str, object] | None = None,
        progress: bool = False,
        solver: str = "ipopt",
    ) -> Result:
        """Find the optimal motion.

        Parameters
        ----------
        guess : dict or Trajectory, optional
            The initial guess. A dictionary maps states, controls, free constants and the duration
            to numbers, arrays of samples at equal distances over the motion, or SampledInputs. A
            motion may be a simulation or the solution of a similar problem; if it is a solution on
            the same mesh, the search also starts with its multipliers. By default states are
            interpolated linearly between the ends, dependent coordinates are determined by the
            constraints, and controls are zero. Phases take a sequence of guesses, one for each
            phase, or a PhasedTrajectory.
        mesh_tol : float, optional
            The mesh is refined until the `error` of each interval and the relative error of the
            objective (except with 'backward-euler') are below this tolerance, and then until a
            simulation from the start deviates from the nodes by at most ten times the tolerance, if
            interval errors above 1e-9 suffice for that. By default the mesh is not refined. A
            warning is given if the tolerance is not reached on 12 meshes, or with four times as
            many intervals as controls without jumps need.
        options : dict, optional
            Options of the solver, such as ``{'max_iter': 500, 'tol': 1e-10}``.
        progress : bool, optional
            Whether to show the iterations; requires tqdm.
        solver : {'ipopt', 'cyipopt', 'pounce'}, optional
            IPOPT from CasADi's wheel, an installed cyipopt, or pounce-solver.

        Returns
        -------
        OptimalTrajectory, or PhasedTrajectory of phases

        Raises
        ------
        OptimizationError
            The search did not converge; the error contains the motion at which it ended. If that
            happens on a refined mesh, a warning is given and the solution on the mesh before is
            returned.
        AnalysisInterrupted
            The user interrupted the search, or memory was exhausted; the error contains the motion
            of the latest iteration.
        ValueError
            What `check` raises.
        MissingDependencyError
            The solver is not installed: ``pip install 'pydy[optimal]'``.
        """
        search = solver_of(solver, options)
        tolerance = _mesh_tolerance(mesh_tol)
        guesses = self._guesses(guess)
        meshes = [problem._mesh for problem in self._problems]
        with progress_of(flag(progress, "`progress`"), " iterations") as show_iteration:

            def watch(iteration: Iteration) -> None:
                show_iteration(
                    1, objective=f"{iteration.objective:.6g}", gap=f"{iteration.violation:.2g}"
                )

            most, met = np.inf, None  # the latest solution with errors within the tolerance
            for count in range(1, MOST_REFINEMENTS + 1):
                try:
                    motion, phases = self._solved(meshes, guesses, search, watch)
                except OptimizationError:
                    if count == 1 or tolerance is None:
                        raise
                    if met is None:
                        intervals = sum(len(mesh) - 1 for mesh in meshes)
                        warn_of_refinements(count - 2, phases, tolerance, intervals)
                    else:
                        motion, phases = met
                    break
                if tolerance is None:
                    warn_where_coarse(phases, motion.objective)
                    break
                errors = relative_errors(phases, tolerance, motion.objective)
                mesh_suffices = max(float(error.max()) for error in errors) <= tolerance
                if mesh_suffices:
                    met = motion, phases
                    pairs = zip(self._problems, phases, strict=True)
                    errors = [
                        problem._propagated_errors(phase, tolerance) for problem, phase in pairs
                    ]
                    if max(float(error.max()) for error in errors) <= tolerance:
                        break
                orders = [problem._scheme.convergence for problem in self._problems]
                if most == np.inf and all(np.median(phase.error) < 1.0 for phase in phases):
                    most = sum(map(most_intervals, meshes, orders, repeat(tolerance)))
                nodes: list[Iterable[float]] = [
                    ()
                    if mesh_suffices
                    else jumps(phase._transcription, phase.solution.z, error, tolerance)
                    for phase, error in zip(phases, errors, strict=True)
                ]
                finer = [*map(refined, meshes, errors, repeat(tolerance), orders, nodes)]
                if count == MOST_REFINEMENTS or sum(map(len, finer)) > most:
                    if met is None:
                        warn_of_refinements(count - 1, phases, tolerance)
                    else:
                        motion, phases = met
                    break
                guesses, meshes = phases, finer
        for problem, phase in zip(self._problems, phases, strict=True):
            if not warn_of_boundless_controls(phase):
                warn_of_chatter(phase)
            problem._warn_of_crossings(phase)
        result: Result = motion
        return result

    def sweep(
        self,
        values: Mapping[Any, ArrayLike],
        guess: object = None,
        *,
        mesh_tol: float | None = None,
        options: Mapping[str, object] | None = None,
        progress: bool = False,
        solver: str = "ipopt",
    ) -> list[Result]:
        """Find the motions for several values of constants; each search starts at the last motion.

        Parameters
        ----------
        values : dict
            From constants, in all phases that have them, to arrays of the same length.
        guess, mesh_tol, options, progress, solver
            As for `solve`; the guess is that of the first motion.

        Returns
        -------
        list of OptimalTrajectory, or of PhasedTrajectory

        Raises
        ------
        OptimizationError
            A search converged neither from the last motion nor from the guess.
        """
        keys, rows = _checked_sweep(values)
        owners: list[dict[int, int]] = []  # of each problem, from places in p to those of `keys`
        for problem in self._problems:
            constants = problem._snapshot.definition.places["constants"]
            swept = [(at, k) for k, key in enumerate(keys)
                     if (at := constants.get(key, "values")) is not None]  # fmt: skip
            refuse_twice([constants.symbols[at] for at, _ in swept], "values")
            for at, k in swept:
                if constants.symbols[at] in problem._free:
                    raise ValueError(f"`values` has `{keys[k]}`, which is `free`: it is found.")
            owners.append(dict(swept))
        for k, key in enumerate(keys):
            if not any(k in indices.values() for indices in owners):
                self._problems[0]._snapshot.definition.places["constants"].find(key, "values")
        motions: list[Result] = []
        search = {"mesh_tol": mesh_tol, "options": options, "progress": progress, "solver": solver}
        for numbers in zip(*rows, strict=True):
            problems = [
                problem._with([*indices], [numbers[k] for k in indices.values()])
                for problem, indices in zip(self._problems, owners, strict=True)
            ]
            if motions:
                warm_started = [copy(problem) for problem in problems]
                for problem, phase in zip(warm_started, self._phases(motions[-1]), strict=True):
                    problem._mesh = phase.fractions
                try:
                    motions.append(self._with_problems(warm_started).solve(motions[-1], **search))
                    continue
                except OptimizationError:  # then start from the guess
                    pass
            motions.append(self._with_problems(problems).solve(guess, **search))
        return motions

    # -- overridden by `Phases`, which has several problems ----------------------------------------

    _links: Sequence[Mapping[AnySymbol, sm.Expr]] = ()  # conditions between a problem and the next

    def _guesses(self, guess: object) -> Sequence[object]:
        """Return a guess for each problem."""
        return [guess]

    def _with_problems(self, problems: Sequence[SearchableProblem]) -> Any:
        """Return a search for other problems of the same kind."""
        return problems[0]

    def _phases(self, motion: Any) -> Sequence[OptimalTrajectory]:
        """Return the motions of the problems."""
        return [motion]

    def _combined_result(self, phases: Sequence[OptimalTrajectory], solution: NlpSolution) -> Any:
        """Return the result that the motions of the problems form."""
        return phases[0]

    def _link(
        self, k: int, transcriptions: Sequence[Transcription], positions: Sequence[np.ndarray]
    ) -> PointGroup:
        """Return the conditions that link two problems."""
        raise NotImplementedError

    # -- the nonlinear program of all problems -----------------------------------------------------

    def _combined_program(
        self, meshes: Sequence[np.ndarray], guesses: Sequence[object]
    ) -> tuple[Nlp, np.ndarray, list[PhaseProgram]]:
        """Return the program, the initial point, and the problems on their meshes."""
        transcriptions, programs, initial_points, state_sizes = [], [], [], []
        for problem, mesh, guess in zip(self._problems, meshes, guesses, strict=True):
            transcription = problem._on(mesh)
            lower, upper = problem._bounds_of(transcription)
            z = problem._guess(transcription, guess, lower, upper)
            sizes, states = sizes_of(transcription, z, lower, upper)
            if transcription.problem.equations.constraints:
                metric = _metric(guess, states)
                transcription = replace(
                    transcription, problem=replace(transcription.problem, metric=metric)
                )
                sizes = sizes_of(transcription, z, lower, upper)[0]
            transcriptions.append(transcription)
            initial_points.append(z)
            programs.append(transcription.nlp(lower, upper, sizes))
            state_sizes.append(states)
        # Links determine where later phases begin.
        self._problems[0]._check_start(transcriptions[0], initial_points[0], programs[0].sizes)
        nlp, positions = programs[0], [np.arange(len(initial_points[0]))]
        if len(transcriptions) > 1:
            nlp, positions = self._together(transcriptions, programs)
        _check_freedom(nlp)
        initial = np.empty(nlp.size)
        for z, at in zip(initial_points, positions, strict=True):
            initial[at] = z
        initial = np.clip(initial, nlp.lower, nlp.upper)
        return (
            nlp.scaled_at(initial),
            initial,
            [*map(PhaseProgram, transcriptions, programs, positions, state_sizes)],
        )

    def _together(
        self, transcriptions: Sequence[Transcription], programs: Sequence[Nlp]
    ) -> tuple[Nlp, list[np.ndarray]]:
        """Return the program of several problems, and the indices of each one's unknowns in it."""
        positions = []
        shared_positions: dict[AnySymbol, int] = {}
        size = 0
        for problem, program in zip(self._problems, programs, strict=True):
            last = () if problem._symbol is None else (problem._symbol,)
            # Kinks at instants are not shared, even if a problem occurs twice.
            shared = [*problem._free, *[None] * len(problem._problem.lifted_numbers), *last]
            at = np.arange(size, size + program.size)
            for k, symbol in enumerate(shared, start=program.size - len(shared)):
                # Constants and durations with the same symbol are one unknown.
                if symbol is not None:
                    at[k] = shared_positions.setdefault(symbol, at[k])
            positions.append(at)
            size += program.size
        # Drop the unknowns that shared ones replace.
        used = np.unique(np.concatenate(positions))
        positions = [np.searchsorted(used, at) for at in positions]
        lower, upper = np.full(len(used), -np.inf), np.full(len(used), np.inf)
        sizes = np.zeros(len(used))
        groups: list[PointGroup] = []
        for k, (program, at) in enumerate(zip(programs, positions, strict=True)):
            np.maximum.at(lower, at, program.lower)
            np.minimum.at(upper, at, program.upper)
            np.maximum.at(sizes, at, program.sizes)
            groups += [
                replace(p, at=at[p.at], labels=tuple(f"phase {k}: {name}" for name in p.labels))
                for p in program.groups
            ]
        for symbol, position in shared_positions.items():
            low, high = (float(side[np.searchsorted(used, position)]) for side in (lower, upper))
            if low > high:
                raise ValueError(
                    f"The `bounds` of `{symbol}`, which phases share, exclude each other: it is at "
                    f"least {low:g} in one phase and at most {high:g} in another."
                )
        for k in range(len(self._links)):
            groups.append(self._link(k, transcriptions[k : k + 2], positions[k : k + 2]))
        estimated = all(p.estimated for p in programs)
        return Nlp(groups, lower, upper, sizes, estimated=estimated), positions

    def _solved(
        self,
        meshes: Sequence[np.ndarray],
        guesses: Sequence[object],
        search: Callable[..., NlpSolution],
        watch: Callable[[Iteration], None],
    ) -> tuple[Any, Sequence[OptimalTrajectory]]:
        """Return the solution on meshes, and the motions of the problems."""
        nlp, initial, parts = self._combined_program(meshes, guesses)
        several, warm = len(parts) > 1, None
        last = None if several else guesses[0]
        if isinstance(last, OptimalTrajectory) and last.is_on(parts[0].transcription):
            warm, initial = last.solution, np.clip(last.solution.z, nlp.lower, nlp.upper)
        solution: NlpSolution = search(nlp, initial, watch=watch, warm=warm)
        if solution.solved:
            solution = replace(solution, z=_without_turns(nlp, solution.z, parts))
            solution = _at_kinks(nlp, solution, parts)
        phases, first = [], 0
        for problem, (transcription, program, at, state_sizes) in zip(
            self._problems, parts, strict=True
        ):
            part = solution
            if several:
                z, rows = solution.z[at], slice(first, first + program.rows)
                first += program.rows
                cost = float(program.native("cost", z / program.sizes)[0][0])
                part = replace(
                    solution, z=z, multipliers=solution.multipliers[rows], below=solution.below[at],
                    above=solution.above[at], objective=cost,
                )  # fmt: skip
            program = program.of_cost_size(nlp.cost_size)
            phases.append(problem._trajectory(transcription, program, state_sizes, part))
        motion = self._combined_result(phases, solution)
        if solution.interrupted is not None:
            raise finished_before(
                solution.interrupted,
                "The latest iteration of the search for an optimal trajectory is",
                "The search for an optimal trajectory was interrupted. Its latest iteration is in "
                "the attribute `results` of this error.",
                motion,
            ) from None
        if not solution.solved:
            begun = [
                (transcription, program, initial[at], problem._controls)
                for problem, (transcription, program, at, _) in zip(
                    self._problems, parts, strict=True
                )
            ]
            raise OptimizationError(
                "The search for an optimal trajectory"
                f"{f' in {len(parts)} phases' if several else ''} ended after "
                f"{counted(solution.iterations, 'iteration')}: {why_in_vain(solution, begun)}. "
                f"{worst_rows(nlp, solution, np.nan if several else motion.duration)}"
                + next((hint for problem in self._problems if (hint := problem._hint)), ""),
                motion,
            )
        return motion, phases


def _metric(guess: object, sizes: np.ndarray) -> np.ndarray | float:
    """Return the metric of slack velocities, which is the same on all meshes of a search."""
    last = guess._transcription.problem.metric if isinstance(guess, OptimalTrajectory) else 1.0
    return last if np.shape(last) == sizes.shape else metric_of(sizes)


def _at_kinks(nlp: Nlp, solution: NlpSolution, parts: Sequence[PhaseProgram]) -> NlpSolution:
    """Set the unknowns that replace kinks to the kinks' values, and update the objective."""
    z = solution.z.copy()
    for transcription, _, positions, _ in parts:
        if transcription.problem.lifted or transcription.problem.lifted_numbers:
            z[positions] = transcription.tightened(z[positions])
    if (z == solution.z).all():
        return solution
    cost = float(nlp.native("cost", z / nlp.sizes)[0][0]) * nlp.cost_size
    return replace(solution, z=z, objective=cost)


def _without_turns(nlp: Nlp, z: np.ndarray, parts: Sequence[PhaseProgram]) -> np.ndarray:
    """Remove jumps of controls by multiples of 2π, if nothing depends on them.

    The equations at a point are periodic in an angle, but its polynomial between points is not.
    """
    for transcription, _, positions, _ in parts:
        order = np.argsort(transcription.control_times, kind="stable")
        for i in range(len(transcription.problem.controls)):
            at = positions[transcription.sizes[0] + i * len(order) + order]
            turns = np.append(0.0, np.cumsum(np.round(np.diff(z[at]) / (2 * np.pi))))
            if not turns.any():
                continue
            unturned = z.copy()
            unturned[at] -= 2 * np.pi * (turns - np.median(turns).round())
            evaluations = [
                np.append(nlp.native("rows", y)[0], nlp.native("cost", y)[0])
                for y in (z / nlp.sizes, unturned / nlp.sizes)
            ]
            allowed = (nlp.lower <= unturned) & (unturned <= nlp.upper)
            if allowed.all() and (np.abs(evaluations[1] - evaluations[0]) <= TOLERANCE).all():
                z = unturned
    return z


def _check_freedom(nlp: Nlp) -> None:
    """Refuse more equations than unknowns."""
    low, high = nlp.row_bounds
    equal, unknown = int((low == high).sum()), int((nlp.lower < nlp.upper).sum())
    if equal > unknown:
        raise ValueError(
            f"The problem has {equal} equations for {unknown} unknowns on this mesh: there is "
            "nothing left to choose. Free some of the `start` or `end`, or leave a specified "
            "without a value, which makes it a control."
        )


def _mesh_tolerance(value: object) -> float | None:
    """Return a checked `mesh_tol`."""
    if value is None:
        return None
    result = positive(value, "`mesh_tol`", finite=True)
    if result < LEAST_MESH_TOL:
        raise ValueError(
            f"`mesh_tol` must be at least {LEAST_MESH_TOL:.2g}, what rounding leaves on any mesh, "
            f"got {result:g}."
        )
    return result


def _checked_sweep(values: object) -> tuple[list[SymbolOrName], list[np.ndarray]]:
    """Return the swept quantities, with equally many values for each."""
    entries = check_mapping("values", values)
    rows = [np.atleast_1d(real_array(v, f"`values[{k}]`")) for k, v in entries.items()]
    for key, row in zip(entries, rows, strict=True):
        if row.ndim != 1 or row.shape != rows[0].shape or not np.isfinite(row).all():
            raise ValueError(
                f"`values[{key}]` must be finite numbers, as many as for the others, got the "
                f"shape {row.shape} after {rows[0].shape}."
            )
    if not rows:
        raise ValueError("`values` must map at least one constant to numbers.")
    return [*entries], rows
