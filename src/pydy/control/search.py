"""The search for motions: of one problem, or of several that are solved as one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy
from dataclasses import replace
from itertools import repeat
from typing import Any, Generic, NamedTuple, TypeVar

import numpy as np

from pydy._checks import check_mapping, flag, positive, real_array, refuse_twice
from pydy._errors import OptimizationError, finished_before
from pydy._optional import progress_of
from pydy.control.accuracy import relative_errors, warn_of_chatter, warn_where_coarse
from pydy.control.ipopt import Iteration, Solution
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

Found = TypeVar("Found")


class Part(NamedTuple):
    """A problem on its mesh."""

    made: Transcription
    program: Nlp
    own: np.ndarray  # where its unknowns are in the whole program
    told: np.ndarray  # how large each state is by the guess


class Search(Generic[Found]):
    """Optimal control problems that are solved together, with a result of type `Found`."""

    _problems: Sequence[Any]  # of OptimalControl

    def check(self, guess: Any = None) -> None:
        """Check the problem before the search.

        Parameters
        ----------
        guess : dict or Trajectory, optional
            As for `solve`.

        Raises
        ------
        ValueError
            Ends that contradict bounds, a guess outside of bounds, a free duration without bounds
            and guess, or fewer unknowns than equations.
        """
        self._joined([problem._mesh for problem in self._problems], self._guesses(guess))

    def solve(
        self,
        guess: Any = None,
        *,
        mesh_tol: float | None = None,
        options: Mapping[str, Any] | None = None,
        progress: bool = False,
        solver: str = "ipopt",
    ) -> Found:
        """Find the motion.

        Parameters
        ----------
        guess : dict or Trajectory, optional
            Where the search begins: from states, controls, free constants and the duration to
            numbers, to arrays of samples at equal distances over the motion, or to SampledInputs;
            or a motion, such as a simulation or the solution of a similar problem, whose
            multipliers are taken over too if it is on the same mesh. By default states lie on
            straight lines between the ends, dependent coordinates follow from the constraints,
            and controls are zero. For phases a sequence of these, one for each, or a
            PhasedTrajectory.
        mesh_tol : float, optional
            The mesh is refined until the `error` of each interval is below it, and that of the
            objective, as a share of it (but not for 'backward-euler'); then until a simulation from
            the start stays within ten times of it beside the nodes, if errors above 1e-9 do. By
            default the mesh stays as it is. A warning tells where that is in vain: after 12 meshes,
            or where errors stay on four times as many intervals as controls without jumps need.
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
            The search did not converge; the error holds the motion where it ended. On a refined
            mesh that is a warning, and the solution that of the mesh before.
        AnalysisInterrupted
            The user interrupted it; the error holds the motion of the latest iteration. So does a
            MemoryError.
        ValueError
            What `check` raises.
        MissingDependencyError
            The solver is not installed: ``pip install 'pydy[optimal]'``.
        """
        search = solver_of(solver, options)
        tolerance = _mesh_tolerance(mesh_tol)
        guesses = self._guesses(guess)
        meshes = [problem._mesh for problem in self._problems]
        with progress_of(flag(progress, "`progress`"), " iterations") as told:

            def watch(iteration: Iteration) -> None:
                told(1, objective=f"{iteration.objective:.6g}", gap=f"{iteration.violation:.2g}")

            most, met = np.inf, None  # the latest solution with errors within the tolerance
            for count in range(1, MOST_REFINEMENTS + 1):
                try:
                    found, phases = self._solved(meshes, guesses, search, watch)
                except OptimizationError:
                    if count == 1 or tolerance is None:
                        raise
                    if met is None:
                        intervals = sum(len(mesh) - 1 for mesh in meshes)
                        warn_of_refinements(count - 2, phases, tolerance, intervals)
                    else:
                        found, phases = met
                    break
                if tolerance is None:
                    warn_where_coarse(phases, found.objective)
                    break
                errors = [relative_errors(phase, tolerance, found.objective) for phase in phases]
                own = max(float(error.max()) for error in errors) <= tolerance
                if own:
                    met = found, phases
                    pairs = zip(self._problems, phases, strict=True)
                    errors = [problem._carried(phase, tolerance) for problem, phase in pairs]
                    if max(float(error.max()) for error in errors) <= tolerance:
                        break
                orders = [problem._scheme.convergence for problem in self._problems]
                if most == np.inf and all(np.median(phase.error) < 1.0 for phase in phases):
                    most = sum(map(most_intervals, meshes, orders, repeat(tolerance)))
                nodes = [
                    () if own else jumps(phase._transcription, phase.solution.z, error, tolerance)
                    for phase, error in zip(phases, errors, strict=True)
                ]
                finer = [*map(refined, meshes, errors, repeat(tolerance), orders, nodes)]
                if count == MOST_REFINEMENTS or sum(map(len, finer)) > most:
                    if met is None:
                        warn_of_refinements(count - 1, phases, tolerance)
                    else:
                        found, phases = met
                    break
                guesses, meshes = phases, finer
        for problem, phase in zip(self._problems, phases, strict=True):
            warn_of_chatter(phase)
            problem._warn_of_crossings(phase)
        result: Found = found
        return result

    def sweep(
        self,
        values: Mapping[Any, Any],
        guess: Any = None,
        *,
        mesh_tol: float | None = None,
        options: Mapping[str, Any] | None = None,
        progress: bool = False,
        solver: str = "ipopt",
    ) -> list[Found]:
        """Find the motions for several values of constants; each search begins at the last motion.

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
            A search did not converge, neither from the last motion nor from the guess.
        """
        keys, rows = _checked_sweep(values)
        owners: list[dict[int, int]] = []  # of each problem, from places in p to those of `keys`
        for problem in self._problems:
            constants = problem._now.definition.places["constants"]
            known = [(at, k) for k, key in enumerate(keys)
                     if (at := constants.get(key, "values")) is not None]  # fmt: skip
            refuse_twice([constants.symbols[at] for at, _ in known], "values")
            for at, k in known:
                if constants.symbols[at] in problem._free:
                    raise ValueError(f"`values` has `{keys[k]}`, which is `free`: it is found.")
            owners.append(dict(known))
        for k, key in enumerate(keys):
            if not any(k in own.values() for own in owners):
                self._problems[0]._now.definition.places["constants"].find(key, "values")
        found: list[Found] = []
        search = {"mesh_tol": mesh_tol, "options": options, "progress": progress, "solver": solver}
        for numbers in zip(*rows, strict=True):
            problems = [
                problem._with([*own], [numbers[k] for k in own.values()])
                for problem, own in zip(self._problems, owners, strict=True)
            ]
            if found:
                there = [copy(problem) for problem in problems]
                for problem, phase in zip(there, self._phases(found[-1]), strict=True):
                    problem._mesh = phase.fractions
                try:
                    found.append(self._of(there).solve(found[-1], **search))
                    continue
                except OptimizationError:  # then from the guess
                    pass
            found.append(self._of(problems).solve(guess, **search))
        return found

    # -- what differs where problems are several: see `Phases` -------------------------------------

    _links: Sequence[Any] = ()  # what holds between a problem and the next

    def _guesses(self, guess: Any) -> Sequence[Any]:
        """Return a guess for each problem."""
        return [guess]

    def _of(self, problems: Sequence[Any]) -> Any:
        """Return the same search with other problems."""
        return problems[0]

    def _phases(self, found: Any) -> Sequence[Any]:
        """Return the motions of the problems."""
        return [found]

    def _whole(self, phases: Sequence[Any], solution: Solution) -> Any:
        """Make the result from the motions of the problems."""
        return phases[0]

    def _link(self, k: int, made: Sequence[Transcription], own: Sequence[np.ndarray]) -> PointGroup:
        """Return the conditions that link two problems."""
        raise NotImplementedError

    # -- the program of all ------------------------------------------------------------------------

    def _joined(
        self, meshes: Sequence[np.ndarray], guesses: Sequence[Any]
    ) -> tuple[Nlp, np.ndarray, list[Part]]:
        """Return the program, where to start, and the problems on their meshes."""
        made, programs, starts, told = [], [], [], []
        for problem, mesh, guess in zip(self._problems, meshes, guesses, strict=True):
            one = problem._on(mesh)
            lower, upper = problem._bounds_of(one)
            z = problem._guess(one, guess, lower, upper)
            sizes, states = sizes_of(one, z, lower, upper)
            if one.problem.equations.constraints:
                metric = _metric(guess, states)
                one = replace(one, problem=replace(one.problem, metric=metric))
                sizes = sizes_of(one, z, lower, upper)[0]
            made.append(one)
            starts.append(z)
            programs.append(one.nlp(lower, upper, sizes))
            told.append(states)
        # Later phases begin where links say.
        self._problems[0]._check_start(made[0], starts[0], programs[0].sizes)
        nlp, own = programs[0], [np.arange(len(starts[0]))]
        if len(made) > 1:
            nlp, own = self._together(made, programs)
        _check_freedom(nlp)
        start = np.empty(nlp.size)
        for z, at in zip(starts, own, strict=True):
            start[at] = z
        begin = np.clip(start, nlp.lower, nlp.upper)
        return nlp.in_own_units(begin), begin, [*map(Part, made, programs, own, told)]

    def _together(
        self, made: Sequence[Transcription], programs: Sequence[Nlp]
    ) -> tuple[Nlp, list[np.ndarray]]:
        """Return the program of several, and where the unknowns of each are in it."""
        own = []
        known: dict[Any, int] = {}
        size = 0
        for problem, program in zip(self._problems, programs, strict=True):
            last = () if problem._symbol is None else (problem._symbol,)
            # Kinks at instants belong to their phase, even where a problem is there twice.
            shared = [*problem._free, *[None] * len(problem._problem.lifted_numbers), *last]
            at = np.arange(size, size + program.size)
            for k, symbol in enumerate(shared, start=program.size - len(shared)):
                # Constants and durations of the same symbol are one unknown.
                if symbol is not None:
                    at[k] = known.setdefault(symbol, at[k])
            own.append(at)
            size += program.size
        # Unknowns of which others took the place are left out.
        used = np.unique(np.concatenate(own))
        own = [np.searchsorted(used, at) for at in own]
        lower, upper = np.full(len(used), -np.inf), np.full(len(used), np.inf)
        sizes = np.zeros(len(used))
        groups: list[PointGroup] = []
        for k, (program, at) in enumerate(zip(programs, own, strict=True)):
            np.maximum.at(lower, at, program.lower)
            np.minimum.at(upper, at, program.upper)
            np.maximum.at(sizes, at, program.sizes)
            groups += [
                replace(p, at=at[p.at], labels=tuple(f"phase {k}: {name}" for name in p.labels))
                for p in program.groups
            ]
        for symbol, place in known.items():
            low, high = (float(side[np.searchsorted(used, place)]) for side in (lower, upper))
            if low > high:
                raise ValueError(
                    f"The `bounds` of `{symbol}`, which phases share, exclude each other: it is at "
                    f"least {low:g} in one phase and at most {high:g} in another."
                )
        for k in range(len(self._links)):
            groups.append(self._link(k, made[k : k + 2], own[k : k + 2]))
        estimated = all(p.estimated for p in programs)
        return Nlp(groups, lower, upper, sizes, estimated=estimated), own

    def _solved(
        self, meshes: Sequence[np.ndarray], guesses: Sequence[Any], search: Any, watch: Any
    ) -> tuple[Any, Sequence[Any]]:
        """Return the solution on meshes, and the motions of the problems."""
        nlp, start, parts = self._joined(meshes, guesses)
        several, warm = len(parts) > 1, None
        last = None if several else guesses[0]
        if isinstance(last, OptimalTrajectory) and last.is_on(parts[0].made):
            warm, start = last.solution, np.clip(last.solution.z, nlp.lower, nlp.upper)
        solution: Solution = search(nlp, start, watch=watch, warm=warm)
        if solution.solved:
            solution = replace(solution, z=_without_turns(nlp, solution.z, parts))
            solution = _at_kinks(nlp, solution, parts)
        phases, first = [], 0
        for problem, (one, program, at, told) in zip(self._problems, parts, strict=True):
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
            phases.append(problem._trajectory(one, program, told, part))
        found = self._whole(phases, solution)
        if solution.interrupted is not None:
            raise finished_before(
                solution.interrupted,
                "The latest iteration of the search for an optimal trajectory is",
                "The search for an optimal trajectory was interrupted. Its latest iteration is in "
                "the attribute `results` of this error.",
                found,
            ) from None
        if not solution.solved:
            begun = [
                (one, program, start[at], problem._controls)
                for problem, (one, program, at, _) in zip(self._problems, parts, strict=True)
            ]
            raise OptimizationError(
                "The search for an optimal trajectory"
                f"{f' in {len(parts)} phases' if several else ''} ended after "
                f"{solution.iterations} iterations: {why_in_vain(solution, begun)}. "
                f"{worst_rows(nlp, solution, np.nan if several else found.duration)}"
                + next((hint for one in self._problems if (hint := one._hint)), ""),
                found,
            )
        return found, phases


def _metric(guess: Any, sizes: np.ndarray) -> Any:
    """Return how slack velocities move states: on all meshes of a search in the same way."""
    last = guess._transcription.problem.metric if isinstance(guess, OptimalTrajectory) else 1.0
    return last if np.shape(last) == sizes.shape else metric_of(sizes)


def _at_kinks(nlp: Nlp, solution: Solution, parts: Sequence[Part]) -> Solution:
    """Return the solution with unknowns that stand for kinks as large as these, and its cost."""
    z = solution.z.copy()
    for made, _, own, _ in parts:
        if made.problem.lifted or made.problem.lifted_numbers:
            z[own] = made.tightened(z[own])
    if (z == solution.z).all():
        return solution
    cost = float(nlp.native("cost", z / nlp.sizes)[0][0]) * nlp.cost_size
    return replace(solution, z=z, objective=cost)


def _without_turns(nlp: Nlp, z: np.ndarray, parts: Sequence[Part]) -> np.ndarray:
    """Remove jumps of controls by whole turns, if nothing depends on them.

    The equations of a point see an angle but for turns; between the points its polynomial does not.
    """
    for made, _, own, _ in parts:
        order = np.argsort(made.control_times, kind="stable")
        for i in range(len(made.problem.controls)):
            at = own[made.sizes[0] + i * len(order) + order]
            turns = np.append(0.0, np.cumsum(np.round(np.diff(z[at]) / (2 * np.pi))))
            if not turns.any():
                continue
            other = z.copy()
            other[at] -= 2 * np.pi * (turns - np.median(turns).round())
            both = [
                np.append(nlp.native("rows", y)[0], nlp.native("cost", y)[0])
                for y in (z / nlp.sizes, other / nlp.sizes)
            ]
            allowed = (nlp.lower <= other) & (other <= nlp.upper)
            if allowed.all() and (np.abs(both[1] - both[0]) <= TOLERANCE).all():
                z = other
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


def _mesh_tolerance(value: Any) -> float | None:
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


def _checked_sweep(values: Any) -> tuple[list[Any], list[np.ndarray]]:
    """Return the swept quantities, with equally many values for each."""
    given = check_mapping("values", values)
    rows = [np.atleast_1d(real_array(v, f"`values[{k}]`")) for k, v in given.items()]
    for key, row in zip(given, rows, strict=True):
        if row.ndim != 1 or row.shape != rows[0].shape or not np.isfinite(row).all():
            raise ValueError(
                f"`values[{key}]` must be finite numbers, as many as for the others, got the "
                f"shape {row.shape} after {rows[0].shape}."
            )
    if not rows:
        raise ValueError("`values` must map at least one constant to numbers.")
    return [*given], rows
