"""Solve the constraints for the dependent coordinates and speeds.

Their derivatives with respect to parameters are computed in `dependence`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
import scipy

from pydy._assembly import Definition
from pydy._checks import SymbolIndex, describe, listed
from pydy._errors import SingularMatrixError, warn_user
from pydy._names import few
from pydy._problem import Problem, solved_residuals, with_settings
from pydy._rank import (
    DIGITS,
    HALF,
    ROUNDED,
    ROUNDING,
    ROUNDINGS,
    equilibrated,
    independent_columns,
    least_step,
    or_one,
    rank,
    unrounded,
    within_rounding,
)
from pydy._states.states import point_at

if TYPE_CHECKING:
    from pydy._kernel import Kernel
    from pydy._sympy_types import AnySymbol, SymbolOrName


def check_dependents(
    definition: Definition, dep_vars: Iterable[SymbolOrName]
) -> tuple[list[int], list[int]]:
    """Return the columns in x of the dependent coordinates and speeds."""
    equations = definition.equations
    holonomic, velocity = len(equations.constraints.holonomic), len(equations.constraints.velocity)
    if not holonomic and not velocity:
        raise ValueError(
            "The system has no constraints, so no initial condition depends on the others."
        )
    chosen = listed("dep_vars", dep_vars, "coordinates and speeds")
    allowed = (*equations.coordinates, *equations.speeds)
    index = SymbolIndex(allowed, "coordinates and speeds of the system")
    chosen = index.chosen(chosen, "dep_vars")
    q = [allowed.index(s) for s in chosen if s in equations.coordinates]
    u = [allowed.index(s) for s in chosen if s in equations.speeds]
    if len(q) != holonomic or len(u) != velocity:
        raise ValueError(
            f"`dep_vars` must have {holonomic + velocity} variables, {holonomic} coordinates for "
            f"the holonomic and {velocity} speeds for the velocity constraints, got {len(chosen)}, "
            f"{len(q)} and {len(u)}: {describe(chosen)}."
        )
    return q, u


def given_values(
    problem: Problem, keys: Iterable[AnySymbol], latest: Mapping[AnySymbol, float]
) -> dict[AnySymbol, float]:
    """Return the user's initial conditions to retain: neither zero nor `latest` solved for."""
    states = problem.definition.states
    values = {s: float(problem.x[states.index(s)]) for s in keys}
    candidates = {s: v for s, v in values.items() if latest.get(s) != v}
    return {s: v for s, v in candidates.items() if v != 0.0 and len(candidates) < len(states)}


def default_dependents(problem: Problem, retained_keys: Iterable[AnySymbol]) -> list[AnySymbol]:
    """Return the states to solve for: the dependent ones, or others if these are to be retained."""
    definition = problem.definition
    equations = definition.equations
    dependents: list[AnySymbol] = []
    for block, symbols, chosen in (
        ("holonomic", equations.coordinates, equations.dependents.coordinates),
        ("velocity", equations.speeds, equations.dependents.speeds),
    ):
        retained = set(retained_keys) - (set() if block == "velocity" else _guessed(definition))
        if not retained.isdisjoint(chosen):
            gradient = _at(problem, problem.code.compiled_jacobian(block, "x"), problem.x)
            symbol_columns = [definition.states.index(s) for s in symbols]
            matrix = gradient.reshape(len(chosen), -1)[:, symbol_columns]
            free = [k for k, symbol in enumerate(symbols) if symbol not in retained]
            units = _motions(problem, problem.x)[symbol_columns]
            columns = _determined(matrix, free, units)
            for k in sorted({symbols.index(s) for s in chosen} - set(columns)):  # cannot be kept
                extended = _determined(matrix, [*columns, k], units)
                columns = extended if len(extended) > len(columns) else columns
            if len(columns) == len(chosen):
                chosen = tuple(symbols[k] for k in columns)
        dependents += chosen
    return dependents


def _determined(matrix: np.ndarray, columns: Sequence[int], units: np.ndarray) -> list[int]:
    """Return columns that can be solved for; the result does not depend on units."""
    scaled = equilibrated(matrix[:, columns], True, units[columns])[0]
    return sorted(columns[k] for k in independent_columns(scaled))


def _motions(problem: Problem, x: np.ndarray) -> np.ndarray:
    """Return the rates of the states at one energy, as units in which they are comparable."""
    rates: np.ndarray = point_at(problem, np.array([problem.t]), x[None]).motions[0]
    return rates


def _guessed(definition: Definition) -> set[AnySymbol]:
    """Return the dependent coordinates that the user chose."""
    dependents = definition.equations.dependents
    return {*dependents.coordinates} - {*dependents.chosen}


def _warn_of_changes(
    definition: Definition, requested: Mapping[AnySymbol, float], x: np.ndarray
) -> None:
    """Warn of user-given values that the constraints changed."""
    guessed, changes = _guessed(definition), []
    for symbol, before in requested.items():
        after = float(x[definition.states.index(symbol)])
        size = max(abs(before), abs(after))
        if symbol not in guessed and not abs(after - before) <= DIGITS * size:
            changes.append(f"`{symbol}` is {after:.6g} in place of {before:.6g}")
    if changes:
        warn_user(
            f"The constraints do not allow all initial conditions that were given: {few(changes)}. "
            "Leave these out, or others that they follow from, or say with `dep_vars` what is to "
            "change."
        )


def _at(problem: Problem, kernel: Kernel, state: np.ndarray) -> np.ndarray:
    """Evaluate a block at the first time."""
    return np.asarray(problem.at(np.array([problem.t]), state[None]).evaluate(kernel)[0])


def _refined(
    bounded: Callable[[np.ndarray], np.ndarray],
    slopes: Callable[[np.ndarray], np.ndarray],
    z: np.ndarray,
) -> np.ndarray:
    """Refine by Newton's method while residuals decrease, in units of their rounding bounds."""
    residual, rounding = np.split(bounded(z), 2)
    for _ in range(20):
        gradient = slopes(z)
        if within_rounding(residual, rounding) or not np.isfinite(gradient).all():
            break
        after = z - least_step(gradient, residual)
        # A constraint on one unknown alone, such as q - ω t = 0 of a driven crank, is solved by
        # itself: the roundings of the others are no error of q, also where all terms vanish.
        for k in np.flatnonzero(np.count_nonzero(gradient, axis=1) == 1):
            j = int(np.flatnonzero(gradient[k])[0])
            after[j] = z[j] - residual[k] / gradient[k, j]
        values, bounds = np.split(bounded(after), 2)
        if not np.abs(values / or_one(bounds)).max() < np.abs(residual / or_one(rounding)).max():
            break
        z, residual, rounding = after, values, bounds
    return z


def _unwound(
    bounded: Callable[[np.ndarray], np.ndarray],
    slopes: Callable[[np.ndarray], np.ndarray],
    z: np.ndarray,
    guess: np.ndarray,
) -> np.ndarray:
    """Take whole revolutions from a solution, as many as bring it nearer to the guess.

    Steps of a search are long where bodies are in line. A coordinate counts as an angle if the
    residuals remain as they are, to rounding: others, such as gears, are not changed.
    """
    far = np.flatnonzero(np.abs(z - guess) > np.pi)
    if not far.size:
        return z
    residual, rounding = np.split(bounded(z), 2)
    allowed = np.abs(residual) + ROUNDINGS * ROUNDING * (rounding + np.abs(slopes(z)) @ np.abs(z))
    for k in far:
        nearer = z.copy()
        nearer[k] -= 2.0 * np.pi * np.round((z[k] - guess[k]) / (2.0 * np.pi))
        values, bounds = np.split(bounded(nearer), 2)
        if (np.abs(values) <= allowed + ROUNDINGS * ROUNDING * bounds).all():
            z = _refined(bounded, slopes, nearer)
    return z


def _solve_coordinates(
    problem: Problem,
    coordinates: list[int],
    x: np.ndarray,
    use_jac: bool,
    root_kwargs: dict[str, object],
) -> bool:
    """Solve the holonomic constraints for `coordinates` in place; return whether they are met."""
    model, definition, value = problem.code, problem.definition, partial(_at, problem)
    size, programs = len(coordinates), model.programs
    bounded = model.compiled_by(("holonomic", "bounded"), lambda: programs.bounded("holonomic"))

    def placed(z: np.ndarray) -> np.ndarray:
        state = x.copy()
        state[coordinates] = z
        return state

    def bounded_at(z: np.ndarray) -> np.ndarray:
        return value(bounded, placed(z))

    def slopes_at(z: np.ndarray) -> np.ndarray:
        gradient = value(model.compiled_jacobian("holonomic", "x"), placed(z))
        return gradient.reshape(size, len(x))[:, coordinates]

    # Rows are scaled by their terms, so that an area and a length in nanometres weigh the same.
    first = value(bounded, x)[size:]
    terms = np.where(np.isfinite(first), or_one(first), 1.0)
    # SciPy's differences step by 1e-8 from zero: unknowns are scaled to change rows by as much.
    units = np.ones(size)
    if use_jac or not x[coordinates].all():
        steep = np.abs(np.nan_to_num(slopes_at(x[coordinates]))) / terms[:, None]
        units = 1.0 / or_one(unrounded(steep).max(axis=0, initial=0.0))
    if use_jac:
        root_kwargs = {"jac": slopes_at, **root_kwargs}
    if callable(given_jac := root_kwargs.get("jac")):
        root_kwargs["jac"] = lambda w: np.asarray(given_jac(w * units)) * units / terms[:, None]
    solution = scipy.optimize.root(
        lambda w: bounded_at(w * units)[:size] / terms,
        x[coordinates] / units,
        **root_kwargs,
    )
    z = solution.x * units
    residual, rounding = np.split(bounded_at(z), 2)
    met = within_rounding(residual, rounding)
    if solution.success and not met:
        z = _refined(bounded_at, slopes_at, z)
        residual, rounding = np.split(bounded_at(z), 2)
        # The bounds do not include errors of Python functions.
        met = bool((np.abs(residual) <= HALF * rounding).all())
    if met:
        z = _unwound(bounded_at, slopes_at, z, x[coordinates])
    x[coordinates] = z
    if not met:
        names = [definition.states[k] for k in coordinates]
        warn_user(
            f"The holonomic constraints did not converge for {describe(names)}: the largest "
            f"residual is {np.abs(residual).max():.3g} ({' '.join(str(solution.message).split())}) "
            "Give initial conditions nearer to a solution, or another `method`."
        )
    return met


def _solve_speeds(problem: Problem, speeds: list[int], x: np.ndarray) -> None:
    """Solve the velocity constraints for `speeds` in place."""
    model, definition, value = problem.code, problem.definition, partial(_at, problem)
    kernel = model.compiled_jacobian("velocity", "x")
    slopes = value(kernel, x).reshape(len(speeds), len(x))
    matrix = slopes[:, speeds]
    residual = model.compiled("velocity")
    start = x.copy()
    start[speeds] = 0.0
    right = -value(residual, start)
    sound = bool(np.isfinite(matrix).all())
    units = None
    if sound and rank(matrix) < len(speeds):
        units = _motions(problem, x)[speeds]
    if sound and rank(matrix, units=units) == len(speeds):
        # Rows are scaled before pivots are compared: constraints may have any units.
        rows = np.abs(matrix).max(axis=1)
        x[speeds] = np.linalg.solve(matrix / rows[:, None], right / rows)
    elif sound:  # directions that the constraints do not determine remain unchanged
        change = right - matrix @ x[speeds]
        x[speeds] += least_step(matrix, change, units)
        size = np.abs(matrix) @ np.abs(x[speeds]) + np.abs(right)
        sound = bool((np.abs(right - matrix @ x[speeds]) <= HALF * size).all())
    if not sound:
        names = [definition.states[k] for k in speeds]
        raise SingularMatrixError(
            f"The velocity constraints cannot be solved for {describe(names)} at t = "
            f"{problem.t!r}: their matrix is singular in this configuration. Choose other "
            "`dep_vars`.",
            problem.t,
            x,
        )
    residual_sizes = np.abs(value(residual, x))
    # Coefficients that cancel leave rounding errors, in units of the row and of each speed.
    first = len(definition.equations.coordinates)
    moving = slice(first, first + len(definition.equations.speeds))
    size = np.abs(matrix) @ np.abs(x[speeds]) + np.abs(right)
    _, units, columns = equilibrated(slopes[:, moving])
    rounding = ROUNDED * units[:, 0] * np.abs(x[moving] / columns[0]).max()
    if (residual_sizes > HALF * size + rounding).any():
        names = [definition.states[k] for k in speeds]
        warn_user(
            f"The velocity constraints do not hold for {describe(names)}: the largest residual "
            f"is {residual_sizes.max():.3g}. They are solved as linear equations, but a specified "
            "in them depends on these speeds nonlinearly. Give their initial conditions yourself."
        )


def solve_dependents(
    problem: Problem,
    columns: tuple[list[int], list[int]],
    requested: Mapping[AnySymbol, float],
    use_jac: bool,
    root_kwargs: dict[str, object],
) -> np.ndarray:
    """Return the initial state, solved for `columns`; warn if that changes `requested` values."""
    x = problem.x.copy()
    problem.plan.check_times(np.array([problem.t]), "times")
    coordinates, speeds = columns
    met = True

    if coordinates:
        met = _solve_coordinates(problem, coordinates, x, use_jac, root_kwargs)
    if speeds:
        _solve_speeds(problem, speeds, x)
    if met:
        _warn_of_changes(problem.definition, requested, x)
    return x


def with_dependents(problem: Problem, symbols: Sequence[AnySymbol]) -> Problem:
    """Return a Problem in which the initial conditions of some symbols are solved for.

    The keys of its dictionary of initial conditions are symbols.
    """
    states = problem.definition.states
    columns = check_dependents(problem.definition, symbols)
    x = solve_dependents(problem, columns, {}, False, {})
    solved = {states[k]: float(x[k]) for part in columns for k in part}
    initial = {**problem.settings.initial_conditions, **solved}
    return with_settings(problem, initial_conditions=initial)


def consistent(problem: Problem) -> Problem:
    """Return a Problem with its dependent states, and those of an Implicit, solved for."""
    x = problem.x
    if problem.dependent:
        names = [problem.definition.states[k] for k in problem.dependent]
        columns = check_dependents(problem.definition, names)
        x = solve_dependents(problem, columns, {}, False, {})
    if problem.definition.equations.constraints.residuals.implicit is not None:
        x = solved_residuals(problem.at(np.array([problem.t]), x[None]))
    return problem if x is problem.x else problem.replace(x=x)
