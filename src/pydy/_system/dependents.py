"""Solve the constraints for the dependent coordinates and speeds."""

from __future__ import annotations

import warnings
from collections.abc import Iterable
from functools import partial
from typing import Any

import numpy as np
import scipy

from pydy._assembly.definition import Definition
from pydy._checks import Places, listed
from pydy._errors import PyDyUserWarning, SingularMatrixError
from pydy._mechanics.dependents import Chosen
from pydy._system.snapshot import Snapshot
from pydy._system.tuning import CANCELLED, UNSOLVED
from pydy.codegen.arguments import describe
from pydy.solvers.run.constraints import satisfied

__all__ = ["check_dependents", "default_dependents", "latest_dependents", "solve_dependents"]


def latest_dependents(definition: Definition, solved: Iterable[Any] | None) -> tuple[Any, ...]:
    """Return what the System `solved` for last; else the dependent states."""
    equations = definition.equations
    own = (*equations.dependent_coordinates, *equations.dependent_speeds)
    return own if solved is None else tuple(solved)


def check_dependents(
    definition: Definition, dep_vars: Iterable[Any]
) -> tuple[list[int], list[int]]:
    """Return the places in x of the dependent coordinates and speeds.

    Raises
    ------
    ValueError
        The system has no constraints, or their number does not fit.
    """
    equations = definition.equations
    holonomic, velocity = len(equations.holonomic), len(equations.velocity)
    if not holonomic and not velocity:
        raise ValueError(
            "The system has no constraints, so no initial condition depends on the others."
        )
    chosen = listed("dep_vars", dep_vars, "coordinates and speeds")
    allowed = (*equations.coordinates, *equations.speeds)
    places = Places(allowed, "coordinates and speeds of the system")
    chosen = [allowed[places.find(symbol, "dep_vars")] for symbol in chosen]
    if len(set(chosen)) != len(chosen):
        raise ValueError(f"`dep_vars` repeat a variable: {describe(chosen)}.")
    q = [allowed.index(s) for s in chosen if s in equations.coordinates]
    u = [allowed.index(s) for s in chosen if s in equations.speeds]
    if len(q) != holonomic or len(u) != velocity:
        raise ValueError(
            f"`dep_vars` must have {holonomic + velocity} variables, {holonomic} coordinates for "
            f"the holonomic and {velocity} speeds for the velocity constraints, got {len(chosen)}, "
            f"{len(q)} and {len(u)}: {describe(chosen)}."
        )
    return q, u


def default_dependents(now: Snapshot, given: Iterable[Any]) -> list[Any]:
    """Return the coordinates and speeds to solve for where the user names none.

    The dependent states; but where those were not chosen by the user either, and one of them is
    `given` an initial condition, others that are not and that the constraints determine there.
    """
    definition, given = now.definition, set(given)
    equations = definition.equations
    ours = () if equations.multibody is None else equations.multibody.chosen
    found: list[Any] = []
    for block, symbols, own in (
        ("holonomic", equations.coordinates, equations.dependent_coordinates),
        ("velocity", equations.speeds, equations.dependent_speeds),
    ):
        if not given.isdisjoint(own) and set(own) <= set(ours):
            gradient = _at(now, now.driven.compiled_jacobian(block, "x"), now.x)
            places = [definition.states.index(s) for s in symbols]
            matrix = gradient.reshape(len(own), -1)[:, places]
            free = [k for k, symbol in enumerate(symbols) if symbol not in given]
            columns = Chosen([matrix], free).columns
            if len(columns) == len(own):
                own = tuple(symbols[k] for k in columns)
        found += own
    return found


def _at(now: Snapshot, kernel: Any, state: np.ndarray) -> np.ndarray:
    """Evaluate a block at the first time."""
    t = np.array([now.t])
    r = now.plan(state, now.t)[None]
    row: np.ndarray = now.driven.evaluate(kernel, t, state[None], r, now.p)[0]
    return row


def solve_dependents(
    now: Snapshot, places: tuple[list[int], list[int]], use_jac: bool, root_kwargs: dict[str, Any]
) -> np.ndarray:
    """Return the initial state with its dependent coordinates and speeds solved for.

    Parameters
    ----------
    now : Snapshot
        Holds the independent values and the guesses.
    places : (list of int, list of int)
        Of the dependent coordinates and speeds in x.
    use_jac : bool
        Whether the root finder gets the exact Jacobian.
    root_kwargs : dict
        For `scipy.optimize.root`.
    """
    model, definition, t = now.driven, now.definition, now.t
    x = now.x.copy()
    now.plan.check_times(np.array([t]), "times")
    coordinates, speeds = places
    value = partial(_at, now)

    if coordinates:
        bounded, size = model.compiled_bounded("holonomic"), len(coordinates)

        def placed(z: np.ndarray) -> np.ndarray:
            state = x.copy()
            state[coordinates] = z
            return state

        if use_jac:
            gradient = model.compiled_jacobian("holonomic", "x")
            shape = (len(coordinates), len(x))
            root_kwargs = {
                "jac": lambda z: value(gradient, placed(z)).reshape(shape)[:, coordinates],
                **root_kwargs,
            }
        solution = scipy.optimize.root(
            lambda z: value(bounded, placed(z))[:size], x[coordinates], **root_kwargs
        )
        x[coordinates] = solution.x
        left, rounding = np.split(value(bounded, x), 2)
        # hybr can stop short of its step criterion with nothing left to improve.
        if not satisfied(left, rounding) and not (solution.success and np.isfinite(left).all()):
            names = [definition.states[k] for k in coordinates]
            warnings.warn(
                f"The holonomic constraints did not converge for {describe(names)}: the largest "
                f"residual is {np.abs(left).max():.3g} ({' '.join(str(solution.message).split())}) "
                "Give initial conditions nearer to a solution, or another `method`.",
                PyDyUserWarning,
                stacklevel=3,
            )
    if speeds:
        kernel = model.compiled_jacobian("velocity", "x")
        matrix = value(kernel, x).reshape(len(speeds), len(x))[:, speeds]
        residual = model.compiled("velocity")
        start = x.copy()
        start[speeds] = 0.0
        right = -value(residual, start)
        # Pivots are compared between rows of the same size: constraints may be of any.
        largest = np.abs(matrix).max(axis=1)
        rows = np.where(largest > 0.0, largest, 1.0)
        try:
            x[speeds] = np.linalg.solve(matrix / rows[:, None], right / rows)
        except np.linalg.LinAlgError:
            names = [definition.states[k] for k in speeds]
            raise SingularMatrixError(
                f"The velocity constraints cannot be solved for {describe(names)} at t = {t!r}: "
                "their matrix is singular in this configuration. Choose other `dep_vars`.",
                t,
                x,
            ) from None
        left = np.abs(value(residual, x))
        # Coefficients that cancel leave their rounding, in proportion to the row and the speeds.
        first = len(definition.equations.coordinates)
        moving = slice(first, first + len(definition.equations.speeds))
        size = np.abs(matrix) @ np.abs(x[speeds]) + np.abs(right)
        rounding = CANCELLED * rows * np.abs(x[moving]).max()
        if (left > UNSOLVED * size + rounding).any():
            names = [definition.states[k] for k in speeds]
            warnings.warn(
                f"The velocity constraints do not hold for {describe(names)}: the largest residual "
                f"is {left.max():.3g}. They are solved as linear equations, but a specified in "
                "them depends on these speeds nonlinearly. Give their initial conditions yourself.",
                PyDyUserWarning,
                stacklevel=3,
            )
    return x
