"""SciPy's `odeint`, called so that giving up is an error."""

from __future__ import annotations

import threading
import warnings
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from inspect import signature
from typing import Any

import numpy as np
import scipy

from pydy._errors import IntegrationError
from pydy._system.scipy_lsoda import refuse_nested
from pydy.solvers.options import check_scipy_options
from pydy.solvers.outcome import NOT_FINITE, OUTCOMES, STEP_UNDERFLOW, TOO_MANY_STEPS

__all__ = ["call_odeint", "odeint_options"]

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


def call_odeint(
    f: Callable[..., Any],
    x0: np.ndarray,
    times: np.ndarray,
    args: tuple[Any, ...],
    names: Sequence[Any],
    options: dict[str, Any],
) -> tuple[np.ndarray, dict[str, Any]]:
    """Return the states and the information of ``odeint(f, x0, times, args, full_output=True)``.

    Parameters
    ----------
    f, x0, times, args
        As odeint takes them.
    names : sequence of symbols
        Of the states, for messages.
    options : dict
        Further ones of odeint.

    Raises
    ------
    IntegrationError
        It gave up, after which the rows hold whatever lay in memory, or went on with NaN.
    RuntimeError
        It is running already, and has called what calls it.
    """
    refuse_nested("odeint")
    options = check_scipy_options(options)
    # The error says more than the warning. Filters are the whole process's: other threads keep it.
    alone = threading.current_thread() is threading.main_thread()
    with warnings.catch_warnings() if alone else nullcontext():
        if alone and not options.get("printmessg"):
            warnings.simplefilter("ignore", scipy.integrate.ODEintWarning)
        states, info = scipy.integrate.odeint(
            f, x0, times, args=args, **{**options, "full_output": True}
        )
    good = info["message"].startswith(_GOOD)
    if good and np.isfinite(states).all():
        return states, info
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
    shown = ", ".join(f"{s} = {v:.6g}" for s, v in zip(names[:12], x, strict=False))
    more = f", and {len(names) - 12} more" if len(names) > 12 else ""
    raise IntegrationError(
        f"`odeint` {what} at t = {t!r} in the state {shown}{more}. "
        f"{_MORE_STEPS if code == TOO_MANY_STEPS else OUTCOMES[code].remedy}",
        times[:reached].copy(),
        states[:reached].copy(),
        t,
        x,
        {**rows, "method": "odeint", "code": code, "status": what, "reached": reached},
    )
