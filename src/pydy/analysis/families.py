"""Families of equilibria and of linear models along a parameter of a Problem."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._assembly import Definition
from pydy._checks import check_mapping, flag, integer, positive, real_array, shown
from pydy._errors import EquilibriumError, finished_before, warn_user
from pydy._judges import warn_of_kinks, warn_of_missing_derivatives, warn_of_protected_states
from pydy._names import unique_names
from pydy._optional import progress_of
from pydy._problem import (
    CallArguments,
    Problem,
    warn_of_contradictions,
    with_unknowns,
)
from pydy._rank import ROUNDED, equilibrated, least_step
from pydy._states import located
from pydy.analysis.continuation import EquilibriumBranch, Functions, trace
from pydy.analysis.equilibria import solve_many
from pydy.analysis.equilibrium_residual import EquilibriumResidual
from pydy.analysis.sweeps import EigenvalueSweep, Models, spectra_of, with_rounding
from pydy.analysis.tuning import VALUES_PER_PART

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from pydy._sympy_types import AnySymbol, SymbolOrName


def parameter_of(definition: Definition, mapping: object) -> tuple[AnySymbol, np.ndarray]:
    """Return the parameter and the values of a mapping with one entry."""
    remedy = "Give one name and its values together: `over={'speed': [0.0, 1.0, 2.0]}`."
    mapping = check_mapping("over", mapping, remedy, always=True)
    if len(mapping) != 1:
        raise ValueError(
            f"`over` must give the values of one state, constant or specified, got {len(mapping)}."
        )
    ((key, entry),) = mapping.items()
    kind, index = located(definition, key, "over")
    values = real_array(entry, f"`over[{key}]`")
    if values.ndim != 1 or len(values) < 2 or not np.isfinite(values).all():
        raise ValueError(
            f"`over[{key}]` must be at least two finite values, got {shown(entry)}."
            if values.ndim != 1 or len(values) < 2
            else f"`over[{key}]` must be finite, got {values[~np.isfinite(values)][0]!r}."
        )
    steps = np.diff(values)
    if not ((steps > 0.0).all() or (steps < 0.0).all()):
        raise ValueError(f"`over[{key}]` must ascend or descend.")
    return definition.places[kind].symbols[index], values


def check_swept(problem: Problem, parameter: AnySymbol, values: np.ndarray) -> None:
    """Warn of values of a parameter that contradict its assumptions."""
    kind, _ = located(problem.definition, parameter, "over")
    for value in (values.min(), values.max()):
        warn_of_contradictions(problem, kind, {parameter: float(value)}, "`over` for ")


class Family:
    """Equilibria and state matrices of a System as functions of a parameter."""

    def __init__(
        self,
        problem: Problem,
        parameter: AnySymbol,
        unknowns: Iterable[SymbolOrName] | None,
        fixed_values: Mapping[SymbolOrName, float] | None,
        moving: Iterable[SymbolOrName],
    ) -> None:
        self.residual = EquilibriumResidual(problem, unknowns, fixed_values, moving, [parameter])
        self.names = self.residual.unknowns.names

    def equilibria(
        self, values: np.ndarray, start: np.ndarray | None = None
    ) -> tuple[np.ndarray, BaseException | None]:
        """Return the equilibria for all values: the unknowns, and the parameter as last column.

        The search starts from the System's numbers, or from the equilibrium `start` with the same
        columns. If Ctrl-C or a lack of memory stops it, the exception is returned with the
        equilibria so far.
        """
        residual = self.residual
        z = self.solve_from(np.append((residual.start if start is None else start)[:-1], values[0]))
        guess = np.repeat(z[None], len(values), axis=0)
        guess[:, -1] = values
        if guess.shape[1] == 1:
            return guess, None
        solutions, sound = solve_many(residual.residuals, residual.slopes, guess, residual.sizes)
        # Solutions that failed from the first value, or lie on another branch, are solved again,
        # starting from their neighbours.
        k = 1
        try:
            for k in range(1, len(values)):
                if not (sound[k] and self._near(solutions[k - 1], solutions[k])):
                    solutions[k] = self.solve_from(np.append(solutions[k - 1, :-1], values[k]))
        except (KeyboardInterrupt, MemoryError) as stop:
            return solutions[:k], stop
        return solutions, None

    def _near(self, z: np.ndarray, neighbour: np.ndarray) -> bool:
        """Return whether a neighbour of the equilibrium z lies on the same branch.

        It does if the unknowns change by less than 2 %, or as the slopes at z predict, up to half
        of the change. Another branch is only solved for again, so that both limits are generous.
        """
        step = neighbour - z
        size = np.maximum(np.abs(z), np.abs(neighbour))
        if (np.abs(step) <= 0.02 * size)[:-1].all():
            return True
        slopes = self.residual.slopes(z[None])
        sizes = self.residual.sizes(slopes[:, :, :-1], z[None])[0]
        units, rounding = sizes.units, ROUNDED * sizes.unknowns  # of unknowns that stay zero
        if (np.abs(step[:-1]) <= 0.02 * size[:-1] + rounding).all():
            return True
        columns = equilibrated(slopes[0, :, :-1], units=units)[2][0]
        change = step[:-1] / columns
        residual_change = slopes[0, :, -1] * step[-1]
        expected = -least_step(slopes[0, :, :-1], residual_change, units) / columns
        return float(np.linalg.norm(change - expected)) <= 0.5 * float(np.linalg.norm(change))

    def solve_from(self, z: np.ndarray) -> np.ndarray:
        """Return the equilibrium at the parameter value in `z`, solved for from `z`."""
        residual, value = self.residual, z[-1]
        if len(z) == 1:
            return z
        infinite = np.full(len(z) - 1, np.inf)
        try:
            solution = residual.solve(z[:-1], (-infinite, infinite), value)[0]
        except EquilibriumError as error:
            error.add_note(f"This was at {self.names[-1]} = {value:.10g}.")
            raise
        return np.append(solution, value)

    def functions(self, start: np.ndarray) -> Functions:
        """Return the functions for `trace`; the spectrum is that of states active at the start."""
        residual, A = self.residual, self.matrices(start[None])[0]
        self.warn_of_kinks(start[None], A)
        active = spectra_of(A)[1]
        return (
            lambda z: residual.residuals(z[None])[0],
            lambda z: residual.slopes(z[None])[0],
            lambda z: with_rounding(self.matrices(z[None])[0][0][np.ix_(active, active)]),
            lambda slopes, z: residual.sizes(slopes[None], z[None])[0],
        )

    def matrices(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the state matrices, all states, and the indices of the independent ones."""
        residual = self.residual
        point = residual.point_at(z)
        T, free = point.tangents()
        A = point.directional("rates", T)[:, free]
        sound = np.isfinite(A.reshape(len(A), -1)).all(axis=1)
        if not sound.all():
            raise ValueError(
                "The equations or their derivatives are not finite at "
                f"{self.names[-1]} = {z[int(sound.argmin()), -1]:.10g}: there is no linear model."
            )
        return A, point.x, free

    def warn_of_kinks(self, z: np.ndarray, A: np.ndarray) -> None:
        """Warn if the state matrices A at some unknowns are at kinks, or are those of a branch."""
        point = self.residual.point_at(z)
        T, free = point.tangents()
        warn_of_kinks(point, T, free, ())
        warn_of_protected_states(point, T, free, A)

    def models(self, values: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the state matrices at the equilibria near some states."""
        z = self.unknowns_at(values, states)
        return self.matrices(np.array([self.solve_from(row) for row in z]))[0]

    def matrices_at(self, values: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the state matrices at the states themselves, with the parameter replaced."""
        return self.matrices(self.unknowns_at(values, states))[0]

    def unknowns_at(self, values: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the unknowns z for some states and parameter values."""
        z = np.repeat(self.residual.start[None], len(values), axis=0)
        by_state, indices = self.residual.unknowns.of_kind("states")
        z[:, by_state] = states[:, indices]
        z[:, -1] = values
        return z


class _SweepBuilder:
    """Equilibria and state matrices along a parameter; results so far survive an interruption."""

    def __init__(
        self, family: Family, values: np.ndarray, fixed_unknowns: np.ndarray | None, models: Models
    ) -> None:
        self.parameter = family.names[-1]
        self._family, self._values, self._fixed_unknowns, self._models = (
            family,
            values,
            fixed_unknowns,
            models,
        )
        self._z = self._A = self._x = np.empty(0)
        self.done = 0

    def __iter__(self) -> Iterator[int]:
        """Compute part after part; yield each part's number of values."""
        family, m = self._family, len(self._values)
        while self.done < m:
            part = slice(self.done, min(self.done + VALUES_PER_PART, m))
            stop: BaseException | None = None
            if self._fixed_unknowns is not None:
                z = self._fixed_unknowns[part]
            else:
                start = self._z[part.start - 1] if self.done else None
                z, stop = family.equilibria(self._values[part], start)
            first = self._z[:1] if self.done else z[:1]
            # The first value determines which states are independent at all values.
            A, x, self._free = family.matrices(np.vstack([first, z]))
            if not self.done:  # allocate the memory for all values first
                self._z, self._A, self._x = (np.empty((m, *array.shape[1:])) for array in (z, A, x))
            part = slice(part.start, part.start + len(z))
            self._z[part], self._A[part], self._x[part] = z, A[1:], x[1:]
            self.done = part.stop
            yield len(z)
            if stop is not None:
                raise stop

    def sweep(self) -> EigenvalueSweep:
        """Return a sweep of the values so far; its eigenvalues are computed on demand."""
        names = unique_names(self._family.residual.definition.states)
        return EigenvalueSweep(
            parameter=self.parameter,
            values=self._values[: self.done],
            A=self._A[: self.done],
            states=tuple(names[k] for k in self._free),
            equilibria=self._x[: self.done],
            _models=self._models,
        )


def eigenvalues(
    problem: Problem,
    over: Mapping[SymbolOrName, ArrayLike],
    *,
    at: Any = None,
    unknowns: Iterable[SymbolOrName] | None = None,
    given: Mapping[SymbolOrName, float] | None = None,
    moving: Iterable[SymbolOrName] = (),
    progress: bool = False,
) -> EigenvalueSweep:
    """Return eigenvalues along a parameter of a Problem; see `System.eigenvalues`."""
    warn_of_missing_derivatives(problem)
    definition = problem.definition
    parameter, values = parameter_of(definition, over)
    given_at, arguments = at, CallArguments(problem)
    if at is not None:
        at = real_array(arguments.states(at, "at"), "`at`")
        t = np.zeros(len(at)) if at.ndim == 2 else None  # an equilibrium depends on no time
        at, _, single = arguments.samples(at, t, "at")
        at = at[0] if single else at
    check_swept(problem, parameter, values)
    if at is not None:
        unknowns = definition.states if unknowns is None else unknowns
        unknowns = [s for s in unknowns if s != parameter]
        if at.ndim == 2 and len(at) != len(values):
            raise ValueError(
                f"`at` must have one state, or one for each of the {len(values)} values of "
                f"`over`, got {len(at)}."
            )
        family = Family(problem, parameter, unknowns, given, moving)
        at = np.broadcast_to(at, (len(values), at.shape[-1]))
        point = family.residual.point_at(family.unknowns_at(values, at))
        at = with_unknowns(point, given_at, lambda x, t: point.r).x
        given_z = family.unknowns_at(values, at)
        models = family.matrices_at
    else:
        family = Family(problem, parameter, unknowns, given, moving)
        given_z = None
        models = family.models
    builder = _SweepBuilder(family, values, given_z, models)
    try:
        with progress_of(flag(progress, "`progress`"), " values", len(values)) as report:
            for count in builder:
                report(count)
        sweep = builder.sweep()
        _ = sweep.eigenvalues  # computed here: an interruption is handled below
        family.warn_of_kinks(family.unknowns_at(sweep.values, sweep.equilibria), sweep.A)
    except (KeyboardInterrupt, MemoryError) as stop:
        if not builder.done:
            raise
        extent = f"{builder.done} of {len(values)} values of {builder.parameter}"
        raise finished_before(
            stop,
            f"The first {extent} are",
            f"The sweep was interrupted after {extent}. They are in the attribute `results` of "
            "this error.",
            builder.sweep(),
        ) from None
    return sweep


_ENDS = {
    "steps": "it has `most` = {most} points. Raise `most`, or `step` if the branch is smooth.",
    "lost": "no equilibrium was found near the last one. Where equations jump or contradict each "
    "other there is none; from a branch point, start beside it.",
}


def follow_equilibria(
    problem: Problem,
    over: Mapping[SymbolOrName, ArrayLike],
    *,
    unknowns: Iterable[SymbolOrName] | None = None,
    given: Mapping[SymbolOrName, float] | None = None,
    moving: Iterable[SymbolOrName] = (),
    step: float = 0.02,
    most: int = 500,
    progress: bool = False,
) -> EquilibriumBranch:
    """Follow equilibria of a Problem along a parameter; see `System.follow_equilibria`."""
    warn_of_missing_derivatives(problem)
    definition = problem.definition
    parameter, values = parameter_of(definition, over)
    check_swept(problem, parameter, values)
    longest = positive(step, "`step`", finite=True)
    family = Family(problem, parameter, unknowns, given, moving)
    residual = family.residual
    if len(family.names) < 2:
        raise ValueError("`unknowns` must name at least one state, constant or specified.")
    start = family.solve_from(np.append(residual.start[:-1], values[0]))
    most = integer(most, "`most`", 2)
    with progress_of(flag(progress, "`progress`"), " points") as report:
        z, stable, special, ended, stop = trace(
            family.functions(start),
            family.names,
            start,
            (float(values[0]), float(values[-1])),
            longest,
            most,
            lambda value: report(1, **{family.names[-1]: f"{value:.6g}"}),
        )
    branch = EquilibriumBranch(
        parameter=family.names[-1],
        values=z[:, -1].copy(),
        unknowns=family.names[:-1],
        solutions=z[:, :-1].copy(),
        states=residual.point_at(z).x,
        stable=stable,
        special=tuple(special),
        ended=ended,
    )
    if ended in _ENDS:
        warn_user(
            f"The branch of equilibria ends at {branch.parameter} = {z[-1, -1]:.6g}, within its "
            f"range: {_ENDS[ended].format(most=most)}"
        )
    if stop is not None:
        raise finished_before(
            stop,
            f"The branch's first {len(z)} equilibria are",
            f"The branch was interrupted at {branch.parameter} = {z[-1, -1]:.10g}. Its "
            f"{len(z)} equilibria so far are in the attribute `results` of this error.",
            branch,
        ) from None
    return branch
