"""Families of equilibria and of linear models along a parameter of a Problem."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np

from pydy._assembly import Definition
from pydy._checks import check_mapping, flag, positive, real_array, shown, whole
from pydy._errors import EquilibriumError, finished_before
from pydy._judges import warn_of_missing_derivatives
from pydy._names import unique_names
from pydy._optional import progress_of
from pydy._problem import AssumptionChecks, CallArguments, Problem, read_samples, with_unknowns
from pydy._rank import ROUNDED, equilibrated, least_step
from pydy._states import located
from pydy.analysis.continuation import EquilibriumBranch, Functions, trace
from pydy.analysis.equilibria import solve_many
from pydy.analysis.equilibrium_residual import EquilibriumResidual
from pydy.analysis.sweeps import EigenvalueSweep, Models, spectra_of, with_rounding
from pydy.analysis.tuning import AT_ONCE


def parameter_of(definition: Definition, over: Any) -> tuple[Any, np.ndarray]:
    """Return the only parameter of a mapping, and its values."""
    over = check_mapping("over", over)
    if len(over) != 1:
        raise ValueError(
            f"`over` must give the values of one state, constant or specified, got {len(over)}."
        )
    ((key, given),) = over.items()
    kind, place = located(definition, key, "over")
    values = real_array(given, f"`over[{key}]`")
    if values.ndim != 1 or len(values) < 2 or not np.isfinite(values).all():
        raise ValueError(
            f"`over[{key}]` must be at least two finite values, got {shown(given)}."
            if values.ndim != 1 or len(values) < 2
            else f"`over[{key}]` must be finite, got {values[~np.isfinite(values)][0]!r}."
        )
    steps = np.diff(values)
    if not ((steps > 0.0).all() or (steps < 0.0).all()):
        raise ValueError(f"`over[{key}]` must ascend or descend.")
    return definition.places[kind].symbols[place], values


def check_swept(problem: Problem, parameter: Any, values: np.ndarray) -> None:
    """Warn of values of a parameter that contradict its assumptions."""
    kind, _ = located(problem.definition, parameter, "over")
    for value in (values.min(), values.max()):
        AssumptionChecks(problem).values(kind, {parameter: float(value)}, "`over` for ")


class Family:
    """Equilibria and state matrices of a System as functions of a parameter."""

    def __init__(
        self,
        problem: Problem,
        parameter: Any,
        unknowns: Iterable[Any] | None,
        given: Mapping[Any, Any] | None,
        moving: Iterable[Any],
    ) -> None:
        self.residual = EquilibriumResidual(problem, unknowns, given, moving, [parameter])
        self.names = self.residual.wanted.names

    def equilibria(
        self, values: np.ndarray, start: np.ndarray | None = None
    ) -> tuple[np.ndarray, BaseException | None]:
        """Return the unknowns and the parameter in the last column, for each value.

        The search starts from the System's numbers, or from an equilibrium of the same columns.
        What stops it on the way from value to value is returned with the first ones.
        """
        balance = self.residual
        z = self.alone(np.append((balance.start if start is None else start)[:-1], values[0]))
        guess = np.repeat(z[None], len(values), axis=0)
        guess[:, -1] = values
        if guess.shape[1] == 1:
            return guess, None
        found, sound = solve_many(balance.residuals, balance.slopes, guess, balance.sizes)
        # What is not found from the first value, or lies on another branch, is found from its
        # neighbour.
        k = 1
        try:
            for k in range(1, len(values)):
                if not (sound[k] and self._near(found[k - 1], found[k])):
                    found[k] = self.alone(np.append(found[k - 1, :-1], values[k]))
        except (KeyboardInterrupt, MemoryError) as stop:
            return found[:k], stop
        return found, None

    def _near(self, z: np.ndarray, other: np.ndarray) -> bool:
        step = other - z
        size = np.maximum(np.abs(z), np.abs(other))
        if (np.abs(step) <= 0.02 * size + ROUNDED)[:-1].all():
            return True
        slopes = self.residual.slopes(z[None])
        units = self.residual.sizes(slopes[:, :, :-1], z[None])[0].units
        columns = equilibrated(slopes[0, :, :-1], units=units)[2][0]
        moved = step[:-1] / columns
        left = slopes[0, :, -1] * step[-1]
        expected = -least_step(slopes[0, :, :-1], left, units) / columns
        return float(np.linalg.norm(moved - expected)) <= 0.5 * float(np.linalg.norm(moved))

    def alone(self, z: np.ndarray) -> np.ndarray:
        """Return the equilibrium at the parameter's value in `z`, found from there."""
        balance, value = self.residual, z[-1]
        if len(z) == 1:
            return z
        infinite = np.full(len(z) - 1, np.inf)
        try:
            found = balance.solved(z[:-1], (-infinite, infinite), value)[0]
        except EquilibriumError as error:
            error.add_note(f"This was at {self.names[-1]} = {value:.10g}.")
            raise
        return np.append(found, value)

    def functions(self, start: np.ndarray) -> Functions:
        """Return what a branch is followed by, with the spectrum of states active at the start."""
        balance, active = self.residual, spectra_of(self.matrices(start[None])[0])[1]
        return (
            lambda z: balance.residuals(z[None])[0],
            lambda z: balance.slopes(z[None])[0],
            lambda z: with_rounding(self.matrices(z[None])[0][0][np.ix_(active, active)]),
            lambda slopes, z: balance.sizes(slopes[None], z[None])[0],
        )

    def matrices(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the state matrices, all states, and the places of the independent ones."""
        balance = self.residual
        point = balance.at(z)
        T, free = point.tangents()
        A = point.along("rates", T)[:, free]
        sound = np.isfinite(A.reshape(len(A), -1)).all(axis=1)
        if not sound.all():
            raise ValueError(
                "The equations or their derivatives are not finite at "
                f"{self.names[-1]} = {z[int(sound.argmin()), -1]:.10g}: there is no linear model."
            )
        return A, point.x, free

    def models(self, values: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the state matrices at the equilibria near some states."""
        z = self.unknowns_at(values, states)
        return self.matrices(np.array([self.alone(row) for row in z]))[0]

    def at(self, values: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the state matrices at states as they are, except the parameter."""
        return self.matrices(self.unknowns_at(values, states))[0]

    def unknowns_at(self, values: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the unknowns of which some are states."""
        z = np.repeat(self.residual.start[None], len(values), axis=0)
        by_state, places = self.residual.wanted.of("states")
        z[:, by_state] = states[:, places]
        z[:, -1] = values
        return z


class _Found:
    """Equilibria and state matrices along a parameter; interrupted work keeps its results."""

    def __init__(
        self, family: Family, values: np.ndarray, given: np.ndarray | None, models: Models
    ) -> None:
        self.parameter = family.names[-1]
        self._family, self._values, self._given, self._models = family, values, given, models
        self._z = self._A = self._x = np.empty(0)
        self.done = 0

    def __iter__(self) -> Iterator[int]:
        """Go on from part to part; yield how many values each has."""
        family, m = self._family, len(self._values)
        while self.done < m:
            part = slice(self.done, min(self.done + AT_ONCE, m))
            stop: BaseException | None = None
            if self._given is not None:
                z = self._given[part]
            else:
                start = self._z[part.start - 1] if self.done else None
                z, stop = family.equilibria(self._values[part], start)
            first = self._z[:1] if self.done else z[:1]
            # The first decides for all which states are independent.
            A, x, self._free = family.matrices(np.vstack([first, z]))
            if not self.done:  # memory for all: where that ends, nothing is lost
                self._z, self._A, self._x = (np.empty((m, *of.shape[1:])) for of in (z, A, x))
            part = slice(part.start, part.start + len(z))
            self._z[part], self._A[part], self._x[part] = z, A[1:], x[1:]
            self.done = part.stop
            yield len(z)
            if stop is not None:
                raise stop

    def sweep(self) -> EigenvalueSweep:
        """Return the values that are done; their eigenvalues are computed when asked for."""
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
    over: Mapping[Any, Any],
    *,
    at: Any = None,
    unknowns: Iterable[Any] | None = None,
    given: Mapping[Any, Any] | None = None,
    moving: Iterable[Any] = (),
    progress: bool = False,
) -> EigenvalueSweep:
    """Return eigenvalues along a parameter of a Problem; see `System.eigenvalues`."""
    warn_of_missing_derivatives(problem)
    definition = problem.definition
    given_at, at = at, CallArguments(problem).states(at, "at")
    if at is not None:
        at = real_array(at, "`at`")
        t = np.zeros(len(at)) if at.ndim == 2 else None
        at, _, single = read_samples(
            at, t, lambda: problem.x, problem.settings.times, len(definition.states), "at"
        )
        at = at[0] if single else at
    parameter, values = parameter_of(definition, over)
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
        point = family.residual.at(family.unknowns_at(values, at))
        at = with_unknowns(point, given_at, lambda x, t: point.r).x
        given_z = family.unknowns_at(values, at)
        models = family.at
    else:
        family = Family(problem, parameter, unknowns, given, moving)
        given_z = None
        models = family.models
    found = _Found(family, values, given_z, models)
    try:
        with progress_of(flag(progress, "`progress`"), " values", len(values)) as told:
            for count in found:
                told(count)
        sweep = found.sweep()
        _ = sweep.eigenvalues  # computed here, where their interruption loses nothing
    except (KeyboardInterrupt, MemoryError) as stop:
        if not found.done:
            raise
        of = f"{found.done} of {len(values)} values of {found.parameter}"
        raise finished_before(
            stop,
            f"The first {of} are",
            f"The sweep was interrupted after {of}. They are in the attribute `results` of "
            "this error.",
            found.sweep(),
        ) from None
    return sweep


def follow_equilibria(
    problem: Problem,
    over: Mapping[Any, Any],
    *,
    unknowns: Iterable[Any] | None = None,
    given: Mapping[Any, Any] | None = None,
    moving: Iterable[Any] = (),
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
    start = family.alone(np.append(residual.start[:-1], values[0]))
    most = whole(most, "`most`", 2)
    with progress_of(flag(progress, "`progress`"), " points") as told:
        z, stable, special, ended, stop = trace(
            family.functions(start),
            family.names,
            start,
            (float(values[0]), float(values[-1])),
            longest,
            most,
            lambda value: told(1, **{family.names[-1]: f"{value:.6g}"}),
        )
    branch = EquilibriumBranch(
        parameter=family.names[-1],
        values=z[:, -1].copy(),
        unknowns=family.names[:-1],
        solutions=z[:, :-1].copy(),
        states=residual.at(z).x,
        stable=stable,
        special=tuple(special),
        ended=ended,
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
