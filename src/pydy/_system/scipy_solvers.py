"""SciPy's solvers: `odeint`, and `solve_ivp` with its methods, called like it."""

from __future__ import annotations

import sys
import threading
import warnings
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from inspect import signature, unwrap
from typing import Any

import numpy as np
import scipy

from pydy._checks import shown
from pydy._errors import IntegrationError
from pydy._names import nearest, numbers_of
from pydy.solvers.options import check_option_names, check_scipy_options
from pydy.solvers.outcome import NOT_FINITE, OUTCOMES, STEP_UNDERFLOW, TOO_MANY_STEPS
from pydy.solvers.solver import SOLVERS, Solver

# -- LSODA, behind both, has one memory: runs cannot be nested ------------------------------------


def refuse_nested(name: str) -> None:
    """Raise if a function that LSODA calls is about to start it again, as a solver of some name."""
    # The stack cannot be out of date, as a mark that an interrupt leaves behind would be.
    running = {
        unwrap(scipy.integrate.odeint).__code__: "odeint",
        unwrap(scipy.integrate.LSODA._step_impl).__code__: "LSODA",
    }
    frame = sys._getframe()
    while frame := frame.f_back:  # type: ignore[assignment]
        if frame.f_code in running:
            raise RuntimeError(
                f"`{name}` cannot be started by a function that `{running[frame.f_code]}` calls: "
                "SciPy's LSODA, which is behind both, works on one integration at a time. Give one "
                "of the two systems another solver, such as `system.ode_solver = 'dop853'`."
            )


# -- odeint ---------------------------------------------------------------------------------------

_ILLEGAL = "Illegal input"
_GOOD = ("Integration successful", "Nothing was done")
_MORE_STEPS = (
    "Raise `mxstep`, how many steps it may take between two times (500 by default), ask for more "
    "`times`, or set `system.ode_solver = 'dop853'`."
)


def odeint_options() -> frozenset[str]:
    """Return the options that odeint takes from users."""
    given = {"func", "y0", "t", "args", "tfirst"}
    return frozenset(signature(scipy.integrate.odeint).parameters) - given


def is_odeint(solver: Any) -> bool:
    """Whether a solver is `odeint`; to tell this of another one loads none of SciPy's packages."""
    return not isinstance(solver, (Solver, SolveIvp)) and solver is scipy.integrate.odeint


def came_to_the_end(states: np.ndarray, info: dict[str, Any]) -> bool:
    """Return whether `odeint` reached the last time."""
    return bool(info["message"].startswith(_GOOD) and np.isfinite(states).all())


def call_odeint(
    f: Callable[..., Any],
    x0: np.ndarray,
    times: np.ndarray,
    args: tuple[Any, ...],
    names: Sequence[Any],
    options: dict[str, Any],
) -> tuple[np.ndarray, dict[str, Any]]:
    """Return the states and information of `odeint`; an IntegrationError where it gives up."""
    refuse_nested("odeint")
    options = check_scipy_options(options)
    _check_scales(options, x0)
    # The error says more than the warning. Filters are the whole process's: other threads keep it.
    alone = threading.current_thread() is threading.main_thread()
    with warnings.catch_warnings() if alone else nullcontext():
        if alone and not options.get("printmessg"):
            warnings.simplefilter("ignore", scipy.integrate.ODEintWarning)
        states, info = scipy.integrate.odeint(
            f, x0, times, args=args, **{**options, "full_output": True}
        )
    if came_to_the_end(states, info):
        return states, info
    good = info["message"].startswith(_GOOD)
    # Rows that it did not come to hold whatever lay in memory, times too.
    came = np.isfinite(states).all(axis=1)
    if not good:
        came[1:] &= info["tcur"] >= times[1:]
    # What is illegal after steps that were not is infinite derivatives.
    if good or (info["message"].startswith(_ILLEGAL) and info["tcur"].max() > times[0]):
        code, what = NOT_FINITE, "met derivatives or errors that are not finite"
    else:
        what = info["message"].split(".")[0]
        code = TOO_MANY_STEPS if what.startswith("Excess work") else STEP_UNDERFLOW
        what = f"gave up ({what})"
    reached = max(1, int(np.argmin(came)))
    t, x = float(times[reached - 1]), states[reached - 1].copy()
    left = float(info["tcur"][reached - 1])
    if not good and t <= left <= times[reached] and np.isfinite(states[reached]).all():
        t, x = left, states[reached].copy()  # the row of the time at which it gave up
    rows = {k: v[:reached] if isinstance(v, np.ndarray) else v for k, v in info.items()}
    raise IntegrationError(
        f"`odeint` {what} at t = {t!r} in the state {numbers_of(names, x)}. "
        f"{_MORE_STEPS if code == TOO_MANY_STEPS else OUTCOMES[code].remedy}",
        times[:reached].copy(),
        states[:reached].copy(),
        t,
        x,
        {**rows, "method": "odeint", "code": code, "status": what, "reached": reached},
    )


# -- solve_ivp ------------------------------------------------------------------------------------

METHODS = ("RK45", "RK23", "DOP853", "Radau", "BDF", "LSODA")


def resolve_ode_solver(solver: Any) -> Any:
    """Return an `ode_solver`, or the one of a name, called like odeint; None for odeint itself."""
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
        f"{shown(solver)}. {nearest(solver, names, or_all=False)}".rstrip()
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


class _Rates:
    """Derivatives for SciPy, and where they first were not finite."""

    def __init__(self, f: Callable[[float, np.ndarray], Any]) -> None:
        self._f, self._first = f, True
        self.called = False  # whether a call did not come back
        self.undefined: tuple[float, np.ndarray] | None = None

    def __call__(self, t: float, x: np.ndarray) -> Any:
        self.called = True
        found = self._f(t, x)
        self.called = False
        if self.undefined is None and not np.isfinite(found).all():
            self.undefined = float(t), np.array(x, dtype=float)
            if self._first:
                # SciPy's explicit methods never end where they begin like this.
                raise FloatingPointError("the derivatives are not finite where it begins")
        self._first = False
        return found


def _check_scales(options: dict[str, Any], x0: Any) -> None:
    """Refuse a zero `atol` for a state that is zero: SciPy's first step would be NaN, for ever."""
    atol = np.asarray(options.get("atol", 1.0))
    x0 = np.asarray(x0)
    if atol.ndim and atol.shape != x0.shape:
        return  # which SciPy refuses
    places = np.flatnonzero((atol == 0.0) & (x0 == 0.0))
    if places.size:
        raise ValueError(
            f"`atol` must be above 0 for states that are 0 at the start, got 0 for x[{places[0]}]: "
            "SciPy divides errors by `atol` + `rtol`·|x|."
        )


@dataclass(frozen=True, eq=False)
class _Dense:
    """The continuous extension of a run of `solve_ivp`."""

    solution: Any  # an OdeSolution

    @property
    def starts(self) -> np.ndarray:
        """The times at which steps begin or end."""
        return np.array(self.solution.ts)

    def __call__(self, times: np.ndarray) -> np.ndarray:
        """Return the states at some times, shape (m, n)."""
        found: np.ndarray = self.solution(times).T
        return found


@dataclass(frozen=True)
class SolveIvp:
    """A method of `scipy.integrate.solve_ivp` with the signature of `odeint`."""

    method: type  # by default; an option of a call may name another

    @property
    def name(self) -> str:
        """Its name in messages."""
        return f"solve_ivp, method {self.method.__name__}"

    def __repr__(self) -> str:
        return f"scipy.integrate.solve_ivp with method={self.method.__name__!r}"

    def _chosen(self, options: dict[str, Any]) -> Any:
        method = options.get("method", self.method)
        return getattr(scipy.integrate, method) if method in METHODS else method

    def _read(self, options: dict[str, Any]) -> Any:
        """Check the names of options, and take the method out of them."""
        method = self._chosen(options)
        options.pop("method", None)
        if isinstance(method, type) and issubclass(method, scipy.integrate.LSODA):
            refuse_nested("LSODA")
        own = {*signature(scipy.integrate.solve_ivp).parameters, *signature(method).parameters}
        taken = {"fun", "t_span", "y0", "t0", "t_bound", "t_eval", "args", "events", "vectorized"}
        extra = {"support_complex", "extraneous", "options"}
        check_option_names("solve_ivp", {*(own - taken - extra), "full_output"}, options)
        return method

    def tolerances(self, options: dict[str, Any]) -> dict[str, float]:
        """Return the method's default tolerances; none where its errors are not known."""
        own = signature(self._chosen(options)).parameters
        return {name: own[name].default for name in ("rtol", "atol") if name in own}

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
        """Return the states at the times, shape (m, n); with `full_output`, also a dictionary."""
        method = self._read(options)
        info: dict[str, Any] = {}
        times, rows = np.unique(t, return_inverse=True)  # neighbours may be equal
        if len(times) == 1:
            states = np.tile(np.asarray(x0, dtype=float), (len(t), 1))
            return (states, info) if full_output else states
        if options.get("first_step") is None:
            _check_scales(options, x0)
        span = (times[0], times[-1])
        rates = _Rates(lambda t, x: f(x, t, *args))
        try:
            found = scipy.integrate.solve_ivp(
                rates, span, x0, method=method, t_eval=times, **check_scipy_options(options)
            )
        except (FloatingPointError, ValueError, IndexError) as error:
            if rates.undefined is None or rates.called:  # what the user's function raises arrives
                raise
            at, x = rates.undefined
            raise IntegrationError(
                f"`solve_ivp` met derivatives that are not finite at t = {at!r}. "
                f"{OUTCOMES[NOT_FINITE].remedy}",
                times[:1].copy(),
                np.array(x0, dtype=float)[None],
                at,
                x,
                {"method": method.__name__, "code": NOT_FINITE, "reached": 1},
            ) from error
        if not len(found.t):  # it failed at once, and left out the start
            found.t, found.y = times[:1], np.array(x0, dtype=float)[:, None]
        states = found.y.T
        if not np.isfinite(states[0]).all():  # LSODA's interpolant of a step that is NaN
            states[0] = x0
        # A step, or one that was rejected, takes a whole number of evaluations.
        steps = found.nfev // getattr(method, "n_stages", 1)
        info = {"nfev": found.nfev, "njev": found.njev, "nlu": found.nlu, "steps": steps}
        info = {**info, "message": found.message, "method": method.__name__}
        finite = np.isfinite(states).all(axis=1)
        if found.status < 0 or not finite.all():
            self._refuse(found, states, finite, {**info, "status": found.message})
        if found.sol is not None:
            info["dense_output"] = _Dense(found.sol)
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
