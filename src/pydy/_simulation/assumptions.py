"""Check a computed motion against the assumptions of its symbols, such as `positive=True`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pydy._simulation.problem import Problem
from pydy._simulation.scipy_solvers import SolveIvp, is_odeint
from pydy.solvers.options import Options
from pydy.solvers.solver import Solver


@dataclass(frozen=True, eq=False)
class AssumptionMonitor:
    """One integration of a model whose symbols carry assumptions.

    Between the requested times a motion is known by the steps of a solver, or by where odeint
    evaluated: its predictions are near the solution, which RK stages are not.
    """

    now: Problem
    solver: Any
    options: dict[str, Any]  # for the solver
    asked: bool  # whether the user asked for dense output
    evaluated: list[tuple[float, np.ndarray]] = field(default_factory=list)

    @classmethod
    def of(cls, now: Problem, solver: Any, given: dict[str, Any], alone: bool) -> AssumptionMonitor:
        """Return what watches an integration by a solver with these options."""
        keeps = isinstance(solver, Solver) or (isinstance(solver, SolveIvp) and alone)
        asked = "dense_output" in given or not keeps
        options = given if asked else {**given, "dense_output": True}
        return cls(now, solver, options, asked)

    def watching(self, f: Callable[..., Any]) -> Callable[..., Any]:
        """Return a right-hand side that records the states at which odeint evaluated it."""
        if not is_odeint(self.solver):
            return f

        def watched(x: Any, t: Any, *args: Any) -> Any:
            self.evaluated.append((float(t), np.array(x, dtype=float)))
            return f(x, t, *args)

        return watched

    def judged(self, times: np.ndarray, result: Any) -> Any:
        """Warn of a solver's result, and return it as the user asked for it."""
        pair = isinstance(result, tuple) and len(result) == 2
        states, info = result if pair else (result, {})
        try:
            table = np.asarray(states, dtype=float)
        except (TypeError, ValueError):
            return result  # of a user's own solver
        n = len(self.now.definition.states)
        if table.ndim == 2 and len(table) <= len(times) and table.shape[1] >= n:
            self._judge(times[: len(table)], table[:, :n], info)
        if not self.asked and isinstance(info, dict):
            result = states, {k: v for k, v in info.items() if k != "dense_output"}
        return result

    def _judge(self, times: np.ndarray, states: np.ndarray, info: Any) -> None:
        n = states.shape[1]
        dense = info.get("dense_output") if isinstance(info, dict) else None
        starts = getattr(dense, "starts", None)
        between = times[:0], states[:0]
        if dense is not None and starts is not None:
            between = starts, dense(starts)[:, :n]
        elif self.evaluated:
            between = _accepted(self.evaluated, times, n)
        every = np.concatenate([times, between[0]])
        order = np.argsort(every, kind="stable")
        rows = np.concatenate([states, between[1]])[order]
        self.now.check_motion(every[order], rows, *self._tolerances())

    def _tolerances(self) -> tuple[Any, Any]:
        """Return the tolerances; without error control an error of the size of the states."""
        solver, options = self.solver, self.options
        if isinstance(solver, SolveIvp):
            defaults = solver.tolerances(options)
        elif (isinstance(solver, Solver) and "step" not in options) or is_odeint(solver):
            defaults = {"rtol": Options.rtol, "atol": Options.atol}
        else:
            defaults = {}
        if not defaults:
            return 1.0, 0.0
        given = {name: options.get(name) for name in defaults}
        found = {k: defaults[k] if v is None else v for k, v in given.items()}
        return found.get("rtol", 1.0), found.get("atol", 0.0)


def _accepted(
    evaluated: list[tuple[float, np.ndarray]], times: np.ndarray, n: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the times and states at which a solver evaluated, without steps that it rejected.

    After a rejected step it goes on from an earlier time.
    """
    t = np.array([time for time, _ in evaluated])
    forward = times[-1] >= times[0]
    ahead = t if forward else -t
    later = np.minimum.accumulate(ahead[::-1])[::-1]
    within = (t <= times.max()) & (t >= times.min())
    rows = np.flatnonzero((ahead <= later) & within)
    return t[rows], np.array([evaluated[k][1][:n] for k in rows]).reshape(len(rows), n)
