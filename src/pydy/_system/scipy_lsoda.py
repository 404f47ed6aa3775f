"""SciPy's LSODA, behind `odeint` and `solve_ivp`, has one memory: runs cannot be nested."""

from __future__ import annotations

import sys
from inspect import unwrap

import scipy

__all__ = ["refuse_nested"]


def refuse_nested(name: str) -> None:
    """Raise if a function that LSODA calls is about to start it again.

    Parameters
    ----------
    name : str
        Of the solver that is about to start, for the message.
    """
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
