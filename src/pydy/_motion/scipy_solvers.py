"""SciPy's solvers: `odeint`, and `solve_ivp` with its methods, called like it."""

from __future__ import annotations

import sys
import threading
import warnings
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from functools import partial, wraps
from inspect import Parameter, signature, unwrap
from typing import Any

import numpy as np
import scipy

from pydy._checks import descends, listed, monotonic, shown
from pydy._errors import IntegrationError
from pydy._motion.scipy_options import check_scipy_options
from pydy._names import nearest, numbers_of, unique_names
from pydy.solvers import SOLVERS, Outcome, Solver, check_option_names
from pydy.trajectory import EventRecord

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
MORE_STEPS = (
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
    came, way = np.isfinite(states).all(axis=1), -1.0 if descends(times) else 1.0
    if not good:
        came[1:] &= way * info["tcur"] >= way * times[1:]
    # What is illegal after steps that were not is infinite derivatives.
    gone = (way * info["tcur"]).max() > way * times[0]
    if good or (info["message"].startswith(_ILLEGAL) and gone):
        outcome, what = Outcome.NOT_FINITE, "met derivatives or errors that are not finite"
    else:
        what = info["message"].split(".")[0]
        excess = what.startswith("Excess work")
        outcome = Outcome.TOO_MANY_STEPS if excess else Outcome.STEP_UNDERFLOW
        what = f"gave up ({what})"
    reached = max(1, int(np.argmin(came)))
    t, x = float(times[reached - 1]), states[reached - 1].copy()
    left = float(info["tcur"][reached - 1])
    if (
        not good
        and way * t <= way * left <= way * times[reached]
        and np.isfinite(states[reached]).all()
    ):
        t, x = left, states[reached].copy()  # the row of the time at which it gave up
    rows = {k: v[:reached] if isinstance(v, np.ndarray) else v for k, v in info.items()}
    raise IntegrationError(
        f"`odeint` {what} at t = {t!r} in the state {numbers_of(names, x)}. "
        f"{MORE_STEPS if outcome == Outcome.TOO_MANY_STEPS else outcome.remedy}",
        times[:reached].copy(),
        states[:reached].copy(),
        t,
        x,
        {**rows, "method": "odeint", "code": int(outcome), "status": what, "reached": reached},
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


def _own_events(events: Any, args: tuple[Any, ...]) -> tuple[Any, list[str]]:
    """Return a user's functions of events as SciPy calls them, and their names.

    One that needs more than time and state, or takes any number, gets the `args` too, as SciPy
    hands them on.
    """
    if events is None:
        return None, []
    functions = [events] if callable(events) else listed("events", events, "functions f(t, x)")
    made: list[Any] = []
    for function in functions:
        if not callable(function) or isinstance(function, type):
            raise TypeError(
                "`events` of solve_ivp must be functions f(t, x) that cross zero, got "
                f"{shown(function)}."
            )
        event = partial(_called_with, function, args if _takes_more(function) else ())
        for name, default in (("terminal", False), ("direction", 0)):
            setattr(event, name, getattr(function, name, default))
        made.append(event)
    names = [getattr(f, "__name__", f"event {k}") for k, f in enumerate(functions)]
    return made, [*unique_names(names)]


_BY_PLACE = (Parameter.POSITIONAL_ONLY, Parameter.POSITIONAL_OR_KEYWORD)


def _takes_more(function: Callable[..., Any]) -> bool:
    """Return whether a function of events takes more than time and state, or refuse it."""
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


def of_states(events: Any, n: int) -> Any:
    """Return functions of events of n states, which other numbers follow."""

    def cut(function: Callable[..., Any]) -> Callable[..., Any]:
        @wraps(function)
        def event(t: float, x: np.ndarray, *args: Any) -> Any:
            return function(t, x[:n], *args)

        return event

    if callable(events):
        return cut(events)
    several = isinstance(events, (list, tuple)) and all(map(callable, events))
    return [*map(cut, events)] if several else events


def _called_with(function: Callable[..., Any], args: tuple[Any, ...], t: float, x: Any) -> Any:
    return function(t, x, *args)


def _records(names: Sequence[str], found: Any) -> list[EventRecord]:
    """Return the events that `solve_ivp` found, in the order in which they happened."""
    records = [
        EventRecord(float(t), names[k], k, x.copy(), x.copy())
        for k, (times, states) in enumerate(zip(found.t_events, found.y_events, strict=True))
        for t, x in zip(times, states, strict=True)
    ]
    way = -1.0 if descends(found.t) else 1.0
    return sorted(records, key=lambda record: way * record.time)


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
        taken = {"fun", "t_span", "y0", "t0", "t_bound", "args", "vectorized"}
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
        """Return the states at the times, shape (m, n); with `full_output`, also a dictionary.

        Its events are functions, as SciPy's. Where one is terminal, there are fewer rows; the times
        of the rows are ``'times'`` in the dictionary.
        """
        method = self._read(options)
        events, names = _own_events(options.pop("events", None), args)
        span = (t[0], t[-1])
        if (chosen := options.pop("t_eval", None)) is not None:
            t = monotonic(chosen, "`t_eval`")
            if not len(t) or not (min(span) <= min(t[0], t[-1]) <= max(t[0], t[-1]) <= max(span)):
                raise ValueError(
                    f"`t_eval` must hold times within those of the System, {span[0]} to {span[1]}, "
                    f"got {shown(chosen)}."
                )
        info: dict[str, Any] = {}
        times, rows = np.unique(t, return_inverse=True)  # neighbours may be equal
        if span[1] < span[0]:
            times, rows = times[::-1], len(times) - 1 - rows
        if span[0] == span[1]:
            states = np.tile(np.asarray(x0, dtype=float), (len(t), 1))
            return (states, info) if full_output else states
        if options.get("first_step") is None:
            _check_scales(options, x0)
        rates = _Rates(lambda t, x: f(x, t, *args))
        try:
            found = scipy.integrate.solve_ivp(
                rates, span, x0, method=method, t_eval=times, events=events,
                **check_scipy_options(options),
            )  # fmt: skip
        except (FloatingPointError, ValueError, IndexError) as error:
            if rates.undefined is None or rates.called:  # what the user's function raises arrives
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
        if not len(found.t) and found.status < 0:  # it failed at once, and left out the start
            found.t, found.y = times[:1], np.array(x0, dtype=float)[:, None]
        states = np.reshape(found.y, (len(x0), -1)).T  # no row is an empty list
        if (
            len(states) and not np.isfinite(states[0]).all()
        ):  # LSODA's interpolant of a step that is NaN
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
        rows = rows[rows < len(found.t)]  # an event may have ended it
        if len(rows) < len(t) or chosen is not None:
            info["times"] = np.array(t[: len(rows)], dtype=float)
        if events is not None:
            info["t_events"], info["y_events"] = found.t_events, found.y_events
            info["events"] = _records(names, found)
        states = states[rows]
        return (states, info) if full_output else states

    def _refuse(self, found: Any, states: Any, finite: Any, info: dict[str, Any]) -> None:
        reached = int(np.argmin(finite)) if not finite.all() else len(states)
        outcome = Outcome.STEP_UNDERFLOW if reached == len(states) else Outcome.NOT_FINITE
        times, states = found.t[:reached].copy(), states[:reached].copy()
        last = float(times[-1]) if reached else np.nan
        raise IntegrationError(
            f"`solve_ivp` could not go on after t = {last!r}: {found.message} {outcome.remedy}",
            times,
            states,
            last,
            states[-1].copy() if reached else np.empty(0),
            {**info, "code": int(outcome), "reached": reached},
        )
