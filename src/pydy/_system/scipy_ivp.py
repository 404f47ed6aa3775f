"""SciPy's `solve_ivp` and its methods, called like `odeint`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from inspect import signature
from typing import Any

import numpy as np
import scipy

from pydy._checks import shown
from pydy._errors import IntegrationError
from pydy._names import nearest
from pydy._system.scipy_lsoda import refuse_nested
from pydy.solvers.options import check_option_names, check_scipy_options
from pydy.solvers.outcome import NOT_FINITE, OUTCOMES, STEP_UNDERFLOW
from pydy.solvers.solver import SOLVERS, Solver

__all__ = ["METHODS", "SolveIvp", "resolve_ode_solver"]

METHODS = ("RK45", "RK23", "DOP853", "Radau", "BDF", "LSODA")


def resolve_ode_solver(solver: Any) -> Any:
    """Return the function that an `ode_solver` stands for, called as odeint is; None for odeint.

    SciPy's integrators take as long to load as SymPy: they are loaded when they are first used.

    Parameters
    ----------
    solver : callable, str, type or None
        A name is ``'odeint'`` or ``'lsoda'``, that of a native solver, or of a method of
        `scipy.integrate.solve_ivp`. A class is such a method.
    """
    if solver is None:
        return None
    if not isinstance(solver, str):
        return _called(solver)
    if solver in ("odeint", "lsoda"):
        return None
    if solver in SOLVERS:
        return SOLVERS[solver]
    if solver == "solve_ivp":
        return SolveIvp(scipy.integrate.RK45)
    if solver in METHODS:
        return SolveIvp(getattr(scipy.integrate, solver))
    names = ("odeint", *SOLVERS, "solve_ivp", *METHODS)
    raise ValueError(
        f"`ode_solver` must be one of {', '.join(map(repr, names))}, or a function, got "
        f"{solver!r}. {nearest(solver, names, or_all=False)}".rstrip()
    )


def _called(solver: Any) -> Any:
    if isinstance(solver, Solver):
        return solver
    if not callable(solver):
        raise ValueError(
            "`ode_solver` must be a function with the signature of scipy.integrate.odeint, or "
            f"the name of a solver, got {shown(solver)}."
        )
    if solver is scipy.integrate.odeint:
        return None
    if solver is scipy.integrate.solve_ivp:
        return SolveIvp(scipy.integrate.RK45)
    if isinstance(solver, type) and issubclass(solver, scipy.integrate.OdeSolver):
        return SolveIvp(solver)
    return solver


@dataclass(frozen=True)
class SolveIvp:
    """A method of `scipy.integrate.solve_ivp` with the signature of `odeint`.

    Attributes
    ----------
    method : type
        By default; an option of a call may name another.
    """

    method: type

    @property
    def name(self) -> str:
        """What messages call it."""
        return f"solve_ivp, method {self.method.__name__}"

    def __repr__(self) -> str:
        return f"scipy.integrate.solve_ivp with method={self.method.__name__!r}"

    def __call__(
        self,
        f: Callable[..., Any],
        x0: Any,
        t: Any,
        args: tuple[Any, ...] = (),
        *,
        full_output: bool = False,
        **options: Any,
    ) -> Any:
        """Return the states at the times, shape (m, n); with `full_output`, also a dictionary.

        Raises
        ------
        TypeError
            `solve_ivp` and the method do not have an option.
        IntegrationError
            It could not go on.
        """
        method = options.pop("method", self.method)
        if isinstance(method, str) and method in METHODS:
            method = getattr(scipy.integrate, method)
        if isinstance(method, type) and issubclass(method, scipy.integrate.LSODA):
            refuse_nested("LSODA")
        solve_ivp = scipy.integrate.solve_ivp
        own = {*signature(solve_ivp).parameters, *signature(method).parameters}
        taken = {"fun", "t_span", "y0", "t0", "t_bound", "t_eval", "args", "events", "vectorized"}
        extra = {"support_complex", "extraneous", "options"}
        check_option_names("solve_ivp", {*(own - taken - extra), "full_output"}, options)
        info: dict[str, Any] = {}
        times, rows = np.unique(t, return_inverse=True)  # neighbours may be equal
        if len(times) == 1:
            states = np.tile(np.asarray(x0, dtype=float), (len(t), 1))
            return (states, info) if full_output else states
        span = (times[0], times[-1])
        found = solve_ivp(
            lambda t, x: f(x, t, *args),
            span,
            x0,
            method=method,
            t_eval=times,
            **check_scipy_options(options),
        )
        states = found.y.T
        info = {"nfev": found.nfev, "njev": found.njev, "nlu": found.nlu}
        info = {**info, "message": found.message, "method": method.__name__}
        finite = np.isfinite(states).all(axis=1)
        if found.status < 0 or not finite.all():
            self._refuse(found, states, finite, {**info, "status": found.message})
        if found.sol is not None:
            info["dense_output"] = lambda times: found.sol(times).T
        states = states[rows]
        return (states, info) if full_output else states

    def _refuse(self, found: Any, states: Any, finite: Any, info: dict[str, Any]) -> None:
        reached = int(np.argmin(finite)) if not finite.all() else len(states)
        code = STEP_UNDERFLOW if reached == len(states) else NOT_FINITE
        times, states = found.t[:reached].copy(), states[:reached].copy()
        last = float(times[-1]) if reached else np.nan
        raise IntegrationError(
            f"`solve_ivp` could not go on after t = {last!r}: {found.message} "
            f"{OUTCOMES[code].remedy}",
            times,
            states,
            last,
            states[-1].copy() if reached else np.empty(0),
            {**info, "code": code, "reached": reached},
        )
