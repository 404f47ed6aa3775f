"""Motions in several phases, with what happens between them: impacts, releases, other equations."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from copy import copy
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import sympy as sm

from pydy._checks import check_mapping, flag, listed, refuse_twice, shown
from pydy._errors import OptimizationError, finished_before
from pydy._optional import progress_of
from pydy.codegen.arguments import checked_expression
from pydy.control.accuracy import relative_errors, warn_of_chatter
from pydy.control.guess import check_freedom, checked_sweep, mesh_tolerance, swept
from pydy.control.ipopt import SOLVED, Iteration, Solution
from pydy.control.kernel import Point
from pydy.control.nlp import Nlp, Piece
from pydy.control.refine import refined, warn_of_refinements, warn_where_coarse
from pydy.control.result import OptimalTrajectory, why_in_vain, worst_rows
from pydy.control.sizes import sizes_of
from pydy.control.solvers import solver_of
from pydy.control.transcription import Transcription
from pydy.control.tuning import MOST_REFINEMENTS

_OPEN = (-np.inf, np.inf)


class PhasedTrajectory(Sequence[OptimalTrajectory]):
    """The phases of an optimal motion, in order.

    Attributes
    ----------
    objective, duration : float
        Sums of those of the phases.
    status : int
        As IPOPT returns it; 0 is solved.
    message : str
    history : tuple of Iteration
    """

    def __init__(self, phases: Sequence[OptimalTrajectory], solution: Solution) -> None:
        self._phases = tuple(phases)
        self.objective = solution.objective
        self.duration = sum(phase.duration for phase in phases)
        self.status = solution.status
        self.message = why_in_vain(solution, ())
        self.history: tuple[Iteration, ...] = solution.history

    def __len__(self) -> int:
        return len(self._phases)

    def __getitem__(self, key: Any) -> Any:
        return self._phases[key]

    def __iter__(self) -> Iterator[OptimalTrajectory]:
        return iter(self._phases)

    def __repr__(self) -> str:
        return (
            f"PhasedTrajectory: {len(self)} phases, {self.duration:.6g} s, objective "
            f"{self.objective:.9g}: {self.message}"
        )


class Phases:
    """Optimal control problems one after the other, solved as one; see `OptimalControl.phases`."""

    def __init__(self, problems: Sequence[Any], links: Any) -> None:
        given = listed("links", links, "a dictionary for each junction")
        if len(given) != len(problems) - 1:
            raise ValueError(
                f"`links` must have a dictionary for each of the {len(problems) - 1} junctions "
                f"between {len(problems)} phases, got {len(given)}. An empty one links all states "
                "that both phases have."
            )
        self._links = [
            _checked(f"links[{k}]", link, before, after)
            for k, (link, (before, after)) in enumerate(zip(given, pairwise(problems), strict=True))
        ]
        self._problems = [problems[0]]
        for k, problem in enumerate(problems[1:]):
            other, link = copy(problem), self._links[k]
            # The end of a phase satisfies the constraints, which need not hold after a link.
            follow = _followers(self._problems[-1], problem, link)
            equations, solved = problem._now.definition.equations, set[Any]()
            if follow < len(equations.places_held):  # residuals give other unknowns then
                solved = {equations.coordinates[z] for z in equations.following[1]}
            other._start = {
                s: _OPEN if s in {*link, *solved} and s not in problem._begins else limits
                for s, limits in problem._start.items()
            }
            self._links[k] = {s: e for s, e in link.items() if s not in solved or e != s}
            other._problem = replace(problem._problem, constraints=problem._held[follow:])
            self._problems.append(other)

    def check(self, guess: Any = None) -> None:
        """Raise what is wrong with the phases before they are solved.

        Parameters
        ----------
        guess : sequence, optional
            As for `solve`.

        Raises
        ------
        ValueError
            What `OptimalControl.check` raises, of one phase or of all together.
        """
        self._joined([problem._mesh for problem in self._problems], self._guesses(guess))

    def _guesses(self, guess: Any) -> Sequence[Any]:
        """Return a guess for each phase."""
        if guess is None:
            return [None] * len(self._problems)
        guesses: Sequence[Any] = listed("guess", guess, "a guess for each phase")
        if len(guesses) != len(self._problems):
            raise ValueError(
                f"`guess` must have an entry for each of the {len(self._problems)} phases, got "
                f"{len(guesses)}."
            )
        return guesses

    def solve(
        self,
        guess: Any = None,
        *,
        mesh_tol: float | None = None,
        options: Mapping[str, Any] | None = None,
        progress: bool = False,
        solver: str = "ipopt",
    ) -> PhasedTrajectory:
        """Find the motion.

        Parameters
        ----------
        guess : sequence, optional
            For each phase what `OptimalControl.solve` takes, or a `PhasedTrajectory`.
        mesh_tol, options, progress, solver
            As for `OptimalControl.solve`.

        Returns
        -------
        PhasedTrajectory

        Raises
        ------
        OptimizationError, AnalysisInterrupted
            As `OptimalControl.solve` raises them; they hold the `PhasedTrajectory`.
        """
        search = solver_of(solver, options)
        tolerance = mesh_tolerance(mesh_tol)
        guesses = self._guesses(guess)
        meshes = [problem._mesh for problem in self._problems]
        with progress_of(flag(progress, "`progress`"), " iterations") as told:

            def watch(iteration: Iteration) -> None:
                told(1, objective=f"{iteration.objective:.6g}", gap=f"{iteration.violation:.2g}")

            for _ in range(MOST_REFINEMENTS):
                found = self._solved(meshes, guesses, search, watch)
                if tolerance is None:
                    warn_where_coarse([phase.error for phase in found])
                    break
                errors = [relative_errors(phase, tolerance, found.objective) for phase in found]
                worst = max(float(error.max()) for error in errors)
                if worst <= tolerance:
                    break
                guesses = list(found)
                meshes = [
                    refined(mesh, error, tolerance, problem._scheme.convergence)
                    for mesh, error, problem in zip(meshes, errors, self._problems, strict=True)
                ]
            else:
                intervals = sum(len(phase.mesh) - 1 for phase in found)
                warn_of_refinements(MOST_REFINEMENTS, intervals, worst, tolerance)
        for phase in found:
            warn_of_chatter(phase)
        return found

    def sweep(
        self,
        values: Mapping[Any, Any],
        guess: Any = None,
        *,
        mesh_tol: float | None = None,
        options: Mapping[str, Any] | None = None,
        progress: bool = False,
        solver: str = "ipopt",
    ) -> list[PhasedTrajectory]:
        """Find the motions for several values of constants; each search begins at the last motion.

        Parameters
        ----------
        values : dict
            From constants, in all phases that have them, to arrays of the same length.
        guess, mesh_tol, options, progress, solver
            As for `solve`; the guess is that of the first motion.

        Returns
        -------
        list of PhasedTrajectory

        Raises
        ------
        OptimizationError
            A search did not converge, neither from the last motion nor from the guess.
        """
        keys, rows = checked_sweep(values)
        owners: list[dict[int, int]] = []  # of each phase, from places in p to those of `keys`
        for problem in self._problems:
            places = problem._now.definition.places["constants"]
            known = [(at, k) for k, key in enumerate(keys)
                     if (at := places.get(key, "values")) is not None]  # fmt: skip
            refuse_twice([places.symbols[at] for at, _ in known], "values")
            found = dict(known)
            problem._refuse_free([keys[k] for k in found.values()], found)
            owners.append(found)
        for k, key in enumerate(keys):
            if not any(k in found.values() for found in owners):
                self._problems[0]._now.definition.places["constants"].find(key, "values")

        def made(numbers: Any, last: Any) -> Phases:
            other = copy(self)
            other._problems = [
                problem._with([*own], [numbers[k] for k in own.values()])
                for problem, own in zip(self._problems, owners, strict=True)
            ]
            for problem, phase in zip(other._problems, () if last is None else last, strict=False):
                problem._mesh = phase.fractions
            return other

        def search(phases: Phases, start: Any) -> PhasedTrajectory:
            return phases.solve(
                start, mesh_tol=mesh_tol, options=options, progress=progress, solver=solver
            )

        return swept(rows, made, search, guess)

    def _joined(
        self, meshes: Sequence[np.ndarray], guesses: Sequence[Any]
    ) -> tuple[Nlp, np.ndarray, list[tuple[Transcription, Nlp, np.ndarray, np.ndarray]]]:
        """Return the program, where to start, and those of the phases with their unknowns' places.

        Each phase has its transcription, program, places in the whole program, and start.
        """
        made, programs, starts, own = [], [], [], []
        known: dict[Any, int] = {}
        size = 0
        for problem, mesh, guess in zip(self._problems, meshes, guesses, strict=True):
            one = Transcription(problem._problem, problem._scheme, mesh)
            lower, upper = problem._bounds_of(one)
            z = problem._guess(one, guess, lower, upper)
            made.append(one)
            starts.append(z)
            programs.append(one.nlp(lower, upper, sizes_of(one, z, lower, upper)))
            last = () if problem._symbol is None else (problem._symbol,)
            shared = [*problem._free, *last]
            at = np.arange(size, size + len(z))
            for k, symbol in enumerate(shared, start=len(z) - len(shared)):
                # Constants and durations of the same symbol are one unknown.
                at[k] = known.setdefault(symbol, at[k])
            own.append(at)
            size += len(z)
        # Unknowns of which others took the place are left out.
        used = np.unique(np.concatenate(own))
        own = [np.searchsorted(used, at) for at in own]
        lower, upper = np.full(len(used), -np.inf), np.full(len(used), np.inf)
        start, sizes = np.empty(len(used)), np.zeros(len(used))
        pieces: list[Piece] = []
        for k, (program, at, z) in enumerate(zip(programs, own, starts, strict=True)):
            np.maximum.at(lower, at, program.lower)
            np.minimum.at(upper, at, program.upper)
            np.maximum.at(sizes, at, program.sizes)
            start[at] = z
            pieces += [
                replace(p, at=at[p.at], labels=tuple(f"phase {k}: {name}" for name in p.labels))
                for p in program.pieces
            ]
        for symbol, place in known.items():
            low, high = (float(side[np.searchsorted(used, place)]) for side in (lower, upper))
            if low > high:
                raise ValueError(
                    f"The `bounds` of `{symbol}`, which phases share, exclude each other: it is at "
                    f"least {low:g} in one phase and at most {high:g} in another."
                )
        for k in range(len(own) - 1):
            pieces.append(self._link(k, made[k : k + 2], own[k : k + 2]))
        nlp = Nlp(pieces, lower, upper, sizes, estimated=all(p.estimated for p in programs))
        # Those of the later phases begin where links say.
        self._problems[0]._check_start(made[0], starts[0])
        check_freedom(nlp)
        begin = np.clip(start, lower, upper)
        return nlp.in_own_units(begin), begin, [*zip(made, programs, own, starts, strict=True)]

    def _solved(
        self, meshes: Sequence[np.ndarray], guesses: Sequence[Any], search: Any, watch: Any
    ) -> PhasedTrajectory:
        nlp, start, parts = self._joined(meshes, guesses)
        solution: Solution = search(nlp, start, watch=watch)
        phases, first = [], 0
        for problem, (one, program, at, begin) in zip(self._problems, parts, strict=True):
            z, rows = solution.z[at], slice(first, first + program.rows)
            first += program.rows
            part = replace(
                solution, z=z, multipliers=solution.multipliers[rows], below=solution.below[at],
                above=solution.above[at], objective=program.cost(z / program.sizes),
            )  # fmt: skip
            program = replace(program, cost_size=nlp.cost_size)
            phases.append(problem._trajectory(one, program, begin, part))
        found = PhasedTrajectory(phases, solution)
        if solution.interrupted is not None:
            raise finished_before(
                solution.interrupted,
                "The latest iteration of the search for an optimal trajectory is",
                "The search for an optimal trajectory was interrupted. Its latest iteration is in "
                "the attribute `results` of this error.",
                found,
            ) from None
        if solution.status not in SOLVED:
            begun = [
                (one, own, z, problem._controls)
                for problem, (one, own, _, z) in zip(self._problems, parts, strict=True)
            ]
            raise OptimizationError(
                f"The search for an optimal trajectory in {len(found)} phases ended after "
                f"{len(solution.history) - 1} iterations: "
                f"{why_in_vain(solution, begun)}. "
                f"{worst_rows(nlp, solution, np.nan)}"
                + next((one._bends for one in self._problems if one._bends), ""),
                found,
            )
        return found

    def _link(self, k: int, made: Sequence[Transcription], own: Sequence[np.ndarray]) -> Piece:
        """Return what holds between two phases."""
        before, after = (one.problem for one in made)
        definition, link = self._problems[k]._now.definition, self._links[k]
        next_states = self._problems[k + 1]._now.definition.states
        key = ("link", k, *map(str, link.items()))

        def compiled() -> Any:
            point = Point(before.equations, len(before.numbers))
            x, y = point.variables(before.states), point.variables(after.states)
            numbers, _ = before.unknown_numbers(point)
            atoms = dict(zip(definition.states, x, strict=True))
            atoms |= {s: numbers[j] for j, s in enumerate(definition.constants)}
            nodes = point.read_with(list(link.values()), f"`links[{k}]`", atoms)
            at = dict(zip(next_states, y, strict=True))
            g = point.graph
            rows = [g.sub(at[s], node) for s, node in zip(link, nodes, strict=True)]
            return point.functions(rows, None, hessian=before.hessian)

        ends = np.arange(before.states) * len(made[0].places[0]) + made[0].intervals
        begins = np.arange(after.states) * len(made[1].places[0])
        numbers = np.arange(sum(made[0].sizes[:2]), sum(made[0].sizes))
        at = np.concatenate([own[0][ends], own[1][begins], own[0][numbers]])
        zeros = np.zeros(len(link))
        return Piece(
            before.once(key, compiled), at[:, None], np.empty((0, 1)), before.numbers, zeros, zeros,
            tuple(f"link {k} of {s}" for s in link), np.full(1, np.nan), False,
        )  # fmt: skip


def _followers(before: Any, after: Any, link: Mapping[Any, Any]) -> int:
    """Return how many of the constraints, the first ones, hold after a link as they did before."""
    definition, equations = after._now.definition, after._problem.equations
    signals = [k for k, _ in after._problem.signals]
    if not (
        before._now.definition is definition
        and np.array_equal(before._now.p, after._now.p)
        and np.array_equal(before._problem.specifieds, after._problem.specifieds, equal_nan=True)
        and not equations.are_of(equations.constraints, signals, time=True)
    ):
        return 0
    q, u = definition.equations.coordinates, definition.equations.speeds
    if any(link.get(s) != s for s in q):
        return 0
    places = len(definition.equations.enforced)
    return places if any(link.get(s) != s for s in u) else len(equations.constraints)


def _checked(what: str, link: Any, before: Any, after: Any) -> dict[Any, Any]:
    """Return an expression for each state that is linked."""
    states = after._now.definition.states
    definition = before._now.definition
    known = {*definition.states, *definition.constants}
    found: dict[Any, Any] = {s: s for s in states if s in definition.states}
    given = check_mapping(what, link)
    symbols = after._now.definition.places["states"].chosen(given, what)
    for s, (key, value) in zip(symbols, given.items(), strict=True):
        if value is None:
            found.pop(s, None)
            continue
        expression = checked_expression(value, f"`{what}[{key}]`")
        strange = [
            a for a in (*expression.atoms(sm.Function, sm.Derivative), *expression.free_symbols)
            if a not in known and (a.is_Symbol or a.is_Derivative or isinstance(
                a, sm.core.function.AppliedUndef)) and a != definition.equations.time
        ]  # fmt: skip
        if strange or expression.has(sm.Derivative) or not isinstance(expression, sm.Expr):
            raise ValueError(
                f"`{what}[{key}]` is {shown(value)}, but a link is an expression of the states of "
                "the phase before, at its end, and of constants."
            )
        found[s] = expression
    return {s: found[s] for s in states if s in found}
