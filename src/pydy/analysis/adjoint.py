"""The gradient of a scalar of a motion with respect to many parameters.

`System.adjoint_gradient` returns an `AdjointGradient`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._forks import cached_property
from pydy._integration import GradientEquations, integrate_recorded
from pydy._judges import judge_start, warn_of_jumps
from pydy._motion import native_solver, prepare
from pydy._names import column_names, name_of, some, text_of, unique_names
from pydy._problem import Problem, read_term, read_times
from pydy.analysis.adjoint_segment import AdjointSegment
from pydy.solvers import Solver

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, Expression, ExpressionOrName, SymbolOrName
    from pydy.trajectory import Trajectory


@dataclass(frozen=True, eq=False)
class AdjointGradient:
    """A scalar of a motion and its derivatives.

    ``gradient['m1']``, or with the symbol, is the derivative with respect to one parameter; for the
    samples of a specified it is an array with one entry for each.

    Attributes
    ----------
    value : float
        The sum of the final term and the integral.
    values : ndarray, shape (k,)
        Its derivatives with respect to all parameters, with one entry for each sample.
    counts : dict
        The parameters, with their numbers of columns.
    by_state : ndarray, shape (n,)
        Its derivatives with respect to the initial states, each varied independently: the adjoint
        at the start. NaN if several contacts close at one instant: such variations separate them.
    time : float
        Where the motion ended: the last of the times, or a terminal event.
    statistics : dict
        Statistics of the integration; ``'steps'`` is the number of steps in the gradient.
    """

    value: float
    values: np.ndarray
    counts: Mapping[AnySymbol, int]
    by_state: np.ndarray
    time: float
    statistics: dict[str, Any]
    _motion: Callable[[], Trajectory]

    @property
    def names(self) -> tuple[str, ...]:
        """The parameters' names: ``F[0]``, ``F[1]``, … for samples."""
        return column_names(self.counts)

    @cached_property
    def trajectory(self) -> Trajectory:
        """The motion at the System's times, as `System.simulate` returns it."""
        return self._motion()

    def __getitem__(self, parameter: SymbolOrName) -> float | np.ndarray:
        """Return the derivative with respect to a parameter, given by symbol or name."""
        start, named = 0, unique_names(list(self.counts))
        for (symbol, count), name in zip(self.counts.items(), named, strict=True):
            if parameter == symbol or name_of(parameter) == name:
                part = self.values[start : start + count]
                return part.copy() if count > 1 else float(part[0])
            start += count
        if parameter in self.names:  # one sample
            return float(self.values[self.names.index(parameter)])
        raise KeyError(f"`{text_of(parameter)}` is not one of the parameters: {some(self.names)}.")

    def __getstate__(self) -> dict[str, object]:
        return {**vars(self), "trajectory": self.trajectory, "_motion": None}

    def __str__(self) -> str:
        terms = some(f"{n} {v:.6g}" for n, v in zip(self.names, self.values, strict=True))
        return f"Gradient of {self.value:.10g} by {terms}"

    __repr__ = __str__


def adjoint_gradient(
    problem: Problem,
    times: np.ndarray,
    wrt: SymbolOrName | Iterable[SymbolOrName],
    *,
    final: ExpressionOrName | None = None,
    integral: ExpressionOrName | None = None,
    solver: Solver,
    **options: object,
) -> AdjointGradient:
    """Return a scalar of a Problem's motion and its derivatives: see `System.adjoint_gradient`."""
    final, integral = (
        None if term is None else read_term(problem.definition, term, name)
        for term, name in ((final, "final"), (integral, "integral"))
    )
    segment, values, by_state = motion_and_gradient(
        problem, times, wrt, final=final, integral=integral, solver=solver, options=options
    )
    recorded = segment.recorded
    counts = {p.symbol: p.count for p in recorded.equations.augmented.parameters}
    info = recorded.motion.statistics
    return AdjointGradient(
        value=segment.value,
        values=values,
        counts=counts,
        by_state=by_state,
        time=recorded.steps.end,
        statistics={k: v for k, v in info.items() if k not in ("events", "reached")},
        _motion=recorded.at_times,
    )


def motion_and_gradient(
    problem: Problem,
    times: np.ndarray,
    wrt: SymbolOrName | Iterable[SymbolOrName],
    *,
    final: int | Expression | None,
    integral: int | Expression | None,
    solver: Solver,
    options: dict[str, object],
    weights: np.ndarray | None = None,
) -> tuple[AdjointSegment, np.ndarray, np.ndarray]:
    """Return a motion and the objective's derivatives by the parameters and by the first state.

    With `weights`, the objective is Σ weight · last state.
    """
    times = read_times(problem, times, "`adjoint_gradient` integrates forward, then back")
    ready, times = prepare(problem, times, solver, options)
    judge_start(problem, times, ready)
    equations = GradientEquations.for_parameters(problem, ready.code, wrt, final, integral)
    initial = equations.initial(problem, float(times[0]))
    recorded = integrate_recorded(problem, solver, ready, times, equations)
    segment = AdjointSegment(recorded)
    segment.finish(weights)
    warn_of_jumps(problem, recorded.at_steps, equations.augmented, integral)
    try:
        values, by_state = segment.gradient(initial)
    except KeyboardInterrupt as stop:
        raise recorded.interrupted(recorded.motion.times, recorded.motion.states) from stop
    return segment, values, by_state


def explicit_solver(solver: object) -> Solver:
    """Return the solver for the adjoint: the System's if it is native, otherwise 'dop853'."""
    if isinstance(solver, Solver) and solver.name == "radau":
        raise ValueError(
            "`adjoint_gradient` goes back through the steps of an explicit method, but "
            "`ode_solver` is 'radau'. Choose another solver of pydy.solvers, or call "
            "system.simulate(sensitivities=…), which goes forward."
        )
    return native_solver(solver)
