"""Linear models of a System."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from pydy._assembly.assumptions import errors_of
from pydy._assembly.specifieds import driven
from pydy._checks import Places, listed
from pydy._errors import warn_user
from pydy._names import unique_names
from pydy._rank import ROUNDED
from pydy._simulation.constraint_drift import first_violation
from pydy._simulation.discontinuities import warn_of_kinks
from pydy._simulation.missing_derivatives import warn_of_missing_derivatives
from pydy._simulation.problem import At, Problem, samples
from pydy._simulation.states import Point
from pydy._system.setup import Setup
from pydy.analysis.equilibria import Equilibrium
from pydy.analysis.linear import LinearModel


def _which(k: int, m: int) -> str:
    return f"state {k} of `at`" if m > 1 else "the state"


def _warn_of_violations(at: At) -> None:
    """Warn of the first given state that is off the constraints."""
    if found := first_violation(at):
        k, told = found
        warn_user(
            f"The linear model is one of motions that keep the constraints, but "
            f"{_which(k, len(at.x))} does not satisfy them. {told} Call "
            "`system.set_dependent_initial_conditions()` first, or take states of a motion "
            "that was integrated with `constraints='project'`."
        )


def _outputs(
    now: Problem,
    outputs: Iterable[Any] | None,
    point: Point,
    T: np.ndarray,
    columns: list[int],
    through: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, tuple[str, ...]]:
    """Return C, D and the outputs' names: of states and of the System's outputs."""
    definition = now.definition
    m, n, s = len(T), len(definition.states), len(definition.specifieds)
    symbols = definition.states if outputs is None else listed("outputs", outputs)
    known = Places([*definition.states, *definition.outputs_symbols], "states and outputs")
    places = known.columns(symbols, "outputs").tolist()
    by_state = np.broadcast_to(np.eye(n), (m, n, n))
    by_input = np.zeros((m, n, s))
    if any(place >= n for place in places):
        width = len(definition.outputs_symbols)
        by_state = np.concatenate([by_state, point.slopes("outputs")], axis=1)
        inputs = np.zeros((m, width, 0))
        if s:
            inputs = point.value(point.model.compiled_jacobian("outputs", "r"), s)
        by_input = np.concatenate([by_input, inputs], axis=1)
    with np.errstate(all="ignore"):  # what is not finite is told
        C = by_state[:, places] @ T
        D = by_input[:, places][:, :, columns]
        if through.size:
            D = D + by_state[:, places][:, :, definition.equations.following[1]] @ through
    titles = unique_names([*definition.states, *definition.outputs_symbols])
    return C, D, tuple(titles[place] for place in places)


def _through_residuals(point: Point, columns: list[int]) -> np.ndarray:
    """Return derivatives of an Implicit's unknowns by some specifieds, (m, unknowns, k)."""
    rows, places = map(list, point.definition.equations.following)
    if not (places and columns):
        return np.zeros((len(point.x), len(places), len(columns)))
    by_input = point.value(point.model.compiled_jacobian("holonomic", "r"), point.r.shape[1])
    gradient = point.slopes("holonomic")[:, rows][:, :, places]
    pairs = zip(gradient, by_input[:, rows][:, :, columns], strict=True)
    return np.array([-np.linalg.lstsq(own, moved)[0] for own, moved in pairs])


def _check_finite(parts: list[np.ndarray]) -> None:
    """Refuse matrices and rates, one for each state, of which there is no linear model."""
    m = len(parts[0])
    sound = [np.isfinite(part.reshape(m, -1)).all(axis=1) for part in parts]
    if not np.all(sound):
        raise ValueError(
            "The equations or their derivatives are not finite at "
            f"{_which(int(np.all(sound, axis=0).argmin()), m)}: there is no linear model. "
            "`evaluate_ode` and `evaluate_jacobian` say where they are not."
        )


class LinearModels(Setup):
    """Linear models of small motions."""

    @np.errstate(under="ignore")  # shares of sizes may be zero
    def linearize(
        self,
        at: Any = None,
        t: Any = None,
        *,
        inputs: Iterable[Any] | None = None,
        outputs: Iterable[Any] | None = None,
    ) -> LinearModel:
        """Return the linear model of small motions that satisfy the constraints.

        Parameters
        ----------
        at : array_like, shape (n,) or (m, n), dict or Equilibrium, optional
            States; the initial conditions by default. For several states, such as along a
            trajectory, each matrix has an additional first axis. A dictionary replaces some of the
            initial conditions, by symbol or name. An Equilibrium also provides the constants and
            specifieds that were found or given.
        t : float or array_like, shape (m,), optional
            As in `evaluate_ode`.
        inputs : iterable of specifieds or names, optional
            All by default. If a specified is given as an expression or a function, the input is an
            addition to its value, and its feedback is part of A. Functions are differentiated
            numerically.
        outputs : iterable of states, outputs or names, optional
            All states by default.

        Returns
        -------
        LinearModel

        Raises
        ------
        ValueError
            The system has no such name, the configuration is singular, or the equations are not
            finite there.

        Warns
        -----
        PyDyUserWarning
            A state does not satisfy the constraints; or a load or rate has a kink or a jump there,
            of which the model knows one side.

        Examples
        --------
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart()
        >>> model = system.linearize(outputs=['q1'])
        >>> model.A[3].round(6)
        array([0., 2., 0., 0.])
        >>> float(model.eigenvalues.real.max().round(6))
        1.414214
        """
        now = self._now()
        warn_of_missing_derivatives(now)
        definition = now.definition
        n, s = len(definition.states), len(definition.specifieds)
        plan, p = now.plan, now.p
        chosen = at is not None and not isinstance(at, Equilibrium)
        if isinstance(at, Equilibrium):
            found = {**at.given, **at.constants, **at.specifieds}
            kinds = ("specifieds", "constants")
            r, c = ({s: found[s] for s in getattr(definition, k) if s in found} for k in kinds)
            plan, p, at = now.plan_with(r or None), now.p_with(c), at.state
        x, t, single = samples(now.x_with(at, "at"), t, lambda: now.x, now.times, n, "at")
        made = driven(now.model, definition, plan, perturbed=True)
        if chosen:  # those of a search for an equilibrium may be roundings of zero
            now.check_columns("states", x, "`at` for ", allowed=errors_of(x, ROUNDED))
        point = Point(definition, made, t, x, plan.rows(x, t), p, plan)
        point = point.with_unknowns(at, plan.rows)
        value, slopes, blocks = point.value, point.slopes, point.blocks
        T, free = point.tangents()
        if definition.equations.constrained:
            _warn_of_violations(point)
        A = point.along("rates", T)[:, free]
        symbols = definition.specifieds if inputs is None else listed("inputs", inputs)
        columns = definition.places["specifieds"].columns(symbols, "inputs").tolist()
        kernel = made.compiled_jacobian("rates", "r") if columns else None
        by_input = np.zeros((len(x), n, s)) if kernel is None else value(kernel, s)
        through, unknowns = _through_residuals(point, columns), [*definition.equations.following[1]]

        def followed(block: str, by_input: np.ndarray) -> np.ndarray:
            """Return total derivatives by inputs, also those through an Implicit's unknowns."""
            return by_input + slopes(block)[:, :, unknowns] @ through if through.size else by_input

        for block in blocks if columns else ():
            by_block = value(made.compiled_jacobian(block, "r"), s)[:, :, columns]
            left = followed(block, by_block)
            if block == "holonomic":
                left[:, definition.equations.following[0]] = 0.0
            if left.any():
                raise ValueError(
                    f"The {block} constraints depend on an input of the linear model: the states "
                    "then do not follow from independent ones alone. Leave prescribed motions out "
                    "of `inputs`."
                )
        with np.errstate(all="ignore"):  # what is not finite is told
            B = followed("rates", by_input[:, :, columns])[:, free]
        C, D, titles = _outputs(now, outputs, point, T, columns, through)
        parts = [A, B, C, D, value(made.compiled("rates"))[:, free]]
        _check_finite(parts)
        warn_of_kinks(point, T, free, columns)
        A, B, C, D, rates = (part[0] if single else part for part in parts)
        return LinearModel(
            A, B, C, D,
            tuple(np.array(unique_names(definition.states))[free].tolist()),
            tuple(np.array(unique_names(definition.specifieds))[columns].tolist()),
            titles, rates,
        )  # fmt: skip
