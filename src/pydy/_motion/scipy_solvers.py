"""SciPy's solvers by name or class: `solve_ivp` with its methods, called like `odeint`."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial, wraps
from inspect import Parameter, signature
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy

from pydy._checks import listed, monotonic, shown
from pydy._errors import IntegrationError
from pydy._motion.lsoda import check_scales, is_odeint, refuse_nested
from pydy._motion.scipy_options import check_scipy_options
from pydy._names import nearest, unique_names
from pydy._option_checks import check_option_names
from pydy.solvers import SOLVERS, Outcome, Solver
from pydy.trajectory import EventRecord

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


def is_implicit(solver: object) -> bool:
    """Return whether a solver is one of SciPy's implicit methods, for stiff equations."""
    return isinstance(solver, SolveIvp) and solver.method.__name__ in ("Radau", "BDF")


# The nearest solver here to one of MATLAB, or of SciPy's older interface.
_ELSEWHERE = {
    "ode45": "tsit5", "ode23": "RK23", "ode78": "dop853", "ode89": "vern9", "ode113": "odeint",
    "ode15s": "BDF", "ode15i": "radau", "ode23s": "radau", "ode23t": "radau", "ode23tb": "radau",
    "dopri5": "RK45", "vode": "BDF", "cvode": "BDF", "cvodes": "BDF", "ida": "radau",
}  # fmt: skip
METHODS = ("RK45", "RK23", "DOP853", "Radau", "BDF", "LSODA")


def resolve_ode_solver(solver: object) -> Callable[..., Any] | None:
    """Return an `ode_solver` from a function or a name; None for odeint."""
    if solver is None:
        return None
    if not isinstance(solver, str):
        return _as_solver(solver)
    if solver in ("odeint", "lsoda"):
        return None
    if solver in SOLVERS:
        return SOLVERS[solver]
    if solver == "solve_ivp":
        return SolveIvp(scipy.integrate.RK45)
    if solver in METHODS:
        return SolveIvp(getattr(scipy.integrate, solver))
    names = ("odeint", *SOLVERS, "solve_ivp", *METHODS)
    known = _ELSEWHERE.get(solver.lower())
    hint = f"Use {known!r}." if known else nearest(solver, names, or_all=False)
    raise ValueError(
        f"`ode_solver` must be one of {', '.join(map(repr, names))}, or a function, got "
        f"{shown(solver)}. {hint}".rstrip()
    )


def _as_solver(solver: object) -> Callable[..., Any] | None:
    if isinstance(solver, Solver):
        return solver
    if not callable(solver):
        raise ValueError(
            "`ode_solver` must be a function with the signature of scipy.integrate.odeint, or "
            f"the name of a solver, got {shown(solver)}."
        )
    if is_odeint(solver):
        return None
    if "scipy.integrate" not in sys.modules:  # it has no solver of that package
        return solver
    if solver is scipy.integrate.solve_ivp:
        return SolveIvp(scipy.integrate.RK45)
    if isinstance(solver, type) and issubclass(solver, scipy.integrate.OdeSolver):
        return SolveIvp(solver)
    return solver


class _StepCounter:
    """An event function that never happens: SciPy evaluates it at the start and after each step."""

    terminal, direction = False, 0

    def __init__(self) -> None:
        self.steps = -1

    def __call__(self, t: float, x: np.ndarray) -> float:
        self.steps += 1
        return 1.0


class _Rates:
    """The derivatives for SciPy. It stores the first time and state where they are not finite."""

    def __init__(self, f: Callable[[float, np.ndarray], ArrayLike]) -> None:
        self._f, self._first = f, True
        self.raised = False  # whether the latest call raised
        self.undefined: tuple[float, np.ndarray] | None = None

    def __call__(self, t: float, x: np.ndarray) -> ArrayLike:
        self.raised = True
        derivatives = self._f(t, x)
        self.raised = False
        if self.undefined is None and not np.isfinite(derivatives).all():
            self.undefined = float(t), np.array(x, dtype=float)
            if self._first:
                # SciPy's explicit methods would not terminate with such a start.
                raise FloatingPointError("the derivatives are not finite where it begins")
        self._first = False
        return derivatives


def _scipy_events(
    events: object, args: tuple[object, ...]
) -> tuple[list[partial[object]] | None, list[str]]:
    """Return a user's event functions in SciPy's form, and their names.

    Functions of more arguments than time and state also get the `args`, as in SciPy.
    """
    if events is None:
        return None, []
    functions = [events] if callable(events) else listed("events", events, "functions f(t, x)")
    events_for_scipy: list[partial[object]] = []
    for function in functions:
        if not callable(function) or isinstance(function, type):
            raise TypeError(
                "`events` of solve_ivp must be functions f(t, x) that cross zero, got "
                f"{shown(function)}."
            )
        event = partial(_called_with, function, args if _takes_more(function) else ())
        for name, default in (("terminal", False), ("direction", 0)):
            setattr(event, name, getattr(function, name, default))
        events_for_scipy.append(event)
    names = [getattr(f, "__name__", f"event {k}") for k, f in enumerate(functions)]
    return events_for_scipy, [*unique_names(names)]


_BY_PLACE = (Parameter.POSITIONAL_ONLY, Parameter.POSITIONAL_OR_KEYWORD)


def _takes_more(function: Callable[..., object]) -> bool:
    """Return whether an event function takes more than time and state; raise if it takes less."""
    try:
        parameters = signature(function).parameters.values()
    except (TypeError, ValueError):  # of some built-in functions
        return False
    by_place = [p for p in parameters if p.kind in _BY_PLACE]
    several = any(p.kind is Parameter.VAR_POSITIONAL for p in parameters)
    if len(by_place) < 2 and not several:
        raise TypeError(
            f"`events` of solve_ivp must be functions f(t, x), got {shown(function)}, which takes "
            f"{len(by_place)} arguments."
        )
    return several or sum(p.default is Parameter.empty for p in by_place) > 2


def of_states(events: Any, n: int) -> object:
    """Restrict event functions to the first n numbers of an augmented state."""

    def cut(function: Callable[..., object]) -> Callable[..., object]:
        @wraps(function)
        def event(t: float, x: np.ndarray, *args: object) -> object:
            return function(t, x[:n], *args)

        return event

    if callable(events):
        return cut(events)
    several = isinstance(events, (list, tuple)) and all(map(callable, events))
    return [*map(cut, events)] if several else events


def _called_with(
    function: Callable[..., object], args: tuple[object, ...], t: float, x: np.ndarray
) -> object:
    return function(t, x, *args)


def _records(
    names: Sequence[str], result: scipy.optimize.OptimizeResult, sign: float
) -> list[EventRecord]:
    """Return the events that `solve_ivp` detected, in their order along the motion.

    The `sign` is that of the time span.
    """
    records = [
        EventRecord(float(t), names[k], k, x.copy(), x.copy())
        for k, (times, states) in enumerate(zip(result.t_events, result.y_events, strict=False))
        if k < len(names)
        for t, x in zip(times, states, strict=True)
    ]
    return sorted(records, key=lambda record: sign * record.time)


@dataclass(frozen=True, eq=False)
class _Dense:
    """The dense output of a run of `solve_ivp`."""

    solution: scipy.integrate.OdeSolution

    @property
    def starts(self) -> np.ndarray:
        """The times at which steps begin or end."""
        return np.array(self.solution.ts)

    def __call__(self, times: np.ndarray) -> np.ndarray:
        """Return the states at some times, shape (m, n)."""
        states: np.ndarray = self.solution(times).T
        return states


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

    def _chosen(self, options: dict[str, object]) -> Any:
        method = options.get("method", self.method)
        return getattr(scipy.integrate, method) if method in METHODS else method

    def _read(self, options: dict[str, object]) -> type[scipy.integrate.OdeSolver]:
        """Check the names of options; remove the method from them and return it."""
        method: type[scipy.integrate.OdeSolver] = self._chosen(options)
        options.pop("method", None)
        if isinstance(method, type) and issubclass(method, scipy.integrate.LSODA):
            refuse_nested("LSODA")
        parameters = {
            *signature(scipy.integrate.solve_ivp).parameters,
            *signature(method).parameters,
        }
        reserved = {"fun", "t_span", "y0", "t0", "t_bound", "args", "vectorized"}
        extra = {"support_complex", "extraneous", "options"}
        check_option_names("solve_ivp", {*(parameters - reserved - extra), "full_output"}, options)
        return method

    def tolerances(self, options: dict[str, object]) -> dict[str, float]:
        """Return the method's default tolerances, or {} for a method without error control."""
        parameters = signature(self._chosen(options)).parameters
        return {name: parameters[name].default for name in ("rtol", "atol") if name in parameters}

    def __call__(
        self,
        f: Callable[..., ArrayLike],
        x0: np.ndarray,
        t: np.ndarray,
        args: tuple[object, ...] = (),
        *,
        full_output: bool = False,
        **options: object,
    ) -> np.ndarray | tuple[np.ndarray, dict[str, object]]:
        """Return the states at the times, shape (m, n); with `full_output`, also a dictionary.

        Events are functions, as in SciPy. After a terminal event there are fewer rows; their times
        are ``'times'`` in the dictionary.
        """
        method = self._read(options)
        events, names = _scipy_events(options.pop("events", None), args)
        span = (t[0], t[-1])
        if (chosen := options.pop("t_eval", None)) is not None:
            t = monotonic(chosen, "`t_eval`")
            if not len(t) or not (min(span) <= min(t[0], t[-1]) <= max(t[0], t[-1]) <= max(span)):
                raise ValueError(
                    f"`t_eval` must hold times within those of the System, {span[0]} to {span[1]}, "
                    f"got {shown(chosen)}."
                )
        info: dict[str, object] = {}
        times, rows = np.unique(t, return_inverse=True)  # neighbours may be equal
        if span[1] < span[0]:
            times, rows = times[::-1], len(times) - 1 - rows
        if span[0] == span[1]:
            states = np.tile(np.asarray(x0, dtype=float), (len(t), 1))
            if chosen is not None:
                info["times"] = np.array(t, dtype=float)
            return (states, info) if full_output else states
        if options.get("first_step") is None:
            check_scales(options, x0)
        rates, counter = _Rates(lambda t, x: f(x, t, *args)), _StepCounter()
        try:
            result = scipy.integrate.solve_ivp(
                rates, span, x0, method=method, t_eval=times, events=[*(events or ()), counter],
                **check_scipy_options(options),
            )  # fmt: skip
        except (FloatingPointError, ValueError, IndexError) as error:
            if rates.undefined is None or rates.raised:  # the user's own exception is passed on
                raise
            at, x = rates.undefined
            raise IntegrationError(
                f"`solve_ivp` met derivatives that are not finite at t = {at!r}. "
                f"{Outcome.NOT_FINITE.remedy}",
                times[:1].copy(),
                np.array(x0, dtype=float)[None],
                at,
                x,
                {"method": method.__name__, "code": int(Outcome.NOT_FINITE), "reached": 1},
            ) from error
        if not len(result.t) and result.status < 0:  # a failure in the first step, without a row
            result.t, result.y = times[:1], np.array(x0, dtype=float)[:, None]
        states = np.reshape(result.y, (len(x0), -1)).T  # no row is an empty list
        if (
            len(states) and not np.isfinite(states[0]).all()
        ):  # LSODA's interpolant of a step that is NaN
            states[0] = x0
        info = {"nfev": result.nfev, "njev": result.njev, "nlu": result.nlu}
        info["steps"] = counter.steps
        info = {**info, "message": result.message, "method": method.__name__}
        finite = np.isfinite(states).all(axis=1)
        if result.status < 0 or not finite.all():
            self._refuse(result, states, finite, {**info, "status": result.message})
        if result.sol is not None:
            info["dense_output"] = _Dense(result.sol)
        reached = rows < len(result.t)  # an event may have ended it
        if not reached.all() or chosen is not None:
            info["times"] = np.array(t[reached], dtype=float)
        if events is not None:
            info["t_events"], info["y_events"] = result.t_events[:-1], result.y_events[:-1]
            info["events"] = _records(names, result, np.sign(span[1] - span[0]))
        states = states[rows[reached]]
        return (states, info) if full_output else states

    def _refuse(
        self,
        result: scipy.optimize.OptimizeResult,
        states: np.ndarray,
        finite: np.ndarray,
        info: dict[str, object],
    ) -> None:
        reached = int(np.argmin(finite)) if not finite.all() else len(states)
        outcome = Outcome.STEP_UNDERFLOW if reached == len(states) else Outcome.NOT_FINITE
        times, states = result.t[:reached].copy(), states[:reached].copy()
        last = float(times[-1]) if reached else np.nan
        raise IntegrationError(
            f"`solve_ivp` could not go on after t = {last!r}: {result.message} {outcome.remedy}",
            times,
            states,
            last,
            states[-1].copy() if reached else np.empty(0),
            {**info, "code": int(outcome), "reached": reached},
        )
