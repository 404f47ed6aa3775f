"""The request for the sensitivities of a motion: an argument of `integrate` and `simulate`."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._assembly import CompiledModel, singular_mass_matrix
from pydy._integration.initial_sensitivities import InitialSensitivities
from pydy._integration.sensitivities import AugmentedSystem
from pydy._integration.step_control import (
    are_controlled,
    compiled_sensitivities,
    with_step_limit,
)
from pydy._judges import explain_columns
from pydy._motion import SolveIvp, of_states
from pydy._problem import Problem
from pydy.solvers import Solver

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from pydy._sympy_types import SymbolOrName


@dataclass
class SensitivityRequest:
    """The requested sensitivities of a simulation: an argument of `integrate` and `simulate`.

    `parameters` are symbols, names or groups such as ``'states'``, as in `System.simulate`. If
    derivatives are the main result, as in orbits, they are `controlled`.
    """

    parameters: SymbolOrName | Iterable[SymbolOrName]
    # whether the step control of a native solver includes the sensitivities
    controlled: bool = False
    initial: np.ndarray | None = None  # initial values, shape (n, k); by default they are computed
    untimed: frozenset[int] = frozenset()  # see `CompiledSensitivities`
    augmented: AugmentedSystem = field(init=False)  # from the call of `augment` on

    def augment(
        self,
        problem: Problem,
        model: CompiledModel,
        times: np.ndarray,
        solver: object,
        options: dict[str, Any],
    ) -> tuple[Callable[..., np.ndarray], np.ndarray, dict[str, Any]]:
        """Return the right-hand side, the initial values and the options of the solver.

        The `model` is that of the states alone.
        """
        self.augmented = augmented = AugmentedSystem.for_parameters(
            problem, model, problem.plan, self.parameters
        )
        values = (
            InitialSensitivities(augmented, problem.dependent).values(problem.x, float(times[0]))
            if self.initial is None
            else self.initial
        )
        columns = augmented.columns
        if isinstance(solver, Solver):
            controlled = are_controlled(augmented.parameters, self.controlled)
            options = with_step_limit(augmented, solver, options, problem.x, times, controlled)
            sources = () if (events := options.get("events")) is None else events.sources
            compiled = compiled_sensitivities(
                augmented, problem.x, options, self.controlled, sources
            )
            compiled = replace(compiled, untimed=self.untimed)
            options = {**options, "sensitivities": compiled}
        else:
            if isinstance(solver, SolveIvp) and "events" in options:
                options = {**options, "events": of_states(options["events"], columns.states)}
            for name in options.keys() & {"rtol", "atol"}:
                if np.size(options[name]) == columns.states > 1:  # others as of their states
                    every = np.repeat(np.asarray(options[name]), columns.count)
                    options = {**options, name: np.concatenate([options[name], every])}
        return augmented_rates_function(augmented), columns.together(problem.x, values), options

    def cut(self, error: Any) -> None:
        """Remove the sensitivities from the states in an error."""
        n = self.augmented.columns.states
        if getattr(error, "states", None) is not None:
            error.states = error.states[:, :n]
        explain_columns(error, error.state[n:])
        error.state = error.state[:n]


def augmented_rates_function(augmented: AugmentedSystem) -> Callable[..., np.ndarray]:
    """Return ``f(x, t, …)`` for solvers, of states with their sensitivities."""
    call, n = augmented.call(), augmented.columns.states
    kernel, model, p = call.kernel, augmented.model, call.p

    def f(x: ArrayLike, t: float, *args: object) -> np.ndarray:
        out = np.empty(augmented.columns.size)
        state = np.ascontiguousarray(x, dtype=float)
        r = call.inputs(state, float(t))
        if kernel.at(state, float(t), r, p, out):
            raise singular_mass_matrix(model.layout, float(t), state[:n])
        return out

    f.native = lambda args: call  # type: ignore[attr-defined]
    return f
