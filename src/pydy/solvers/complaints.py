"""Why compiled code gave up, in words."""

from __future__ import annotations

from math import isfinite

from pydy.solvers import layout as at

__all__ = ["complaint"]

_RUNS_AWAY = (
    "needs ever smaller steps",
    "The motion is not smooth there or runs away. Look for a jump in the loads, which an Event can "
    "carry the state over, loosen `rtol` and `atol`, or try 'radau' if the system is stiff.",
)
_FAILURES = {
    at.SINGULAR: (
        "met a singular mass matrix",
        "Check that no mass or inertia is zero, that no constraint is redundant there, and that "
        "the configuration is not a singular one.",
    ),
    at.NOT_FINITE: (
        "met derivatives that are not finite",
        "Check the loads, specifieds and constants there for a division by zero or a function "
        "outside its domain.",
    ),
    at.NO_CONVERGENCE: (
        "could not solve for its stages",
        "Check that loads are continuous there; an Event can carry the state over a jump.",
    ),
}


def complaint(code: int, failure: int, size: float, max_steps: int) -> tuple[str, str]:
    """Return what happened and what to do about it.

    Parameters
    ----------
    code : int
        What the stepper returned.
    failure : int
        What the last rejected step met.
    size : float
        Of that step.
    max_steps : int
    """
    if code == at.TOO_MANY:
        return (
            f"took {max_steps} steps, `max_steps`",
            "Raise `max_steps`, loosen `rtol` and `atol`, or try 'radau' if the system is stiff.",
        )
    if code == at.UNPROJECTED:
        return (
            f"could not bring the state back onto the constraints after a step of {size:.3g}",
            "Check that the constraints can be met together there, or limit `max_step`.",
        )
    what, remedy = _FAILURES.get(failure, _RUNS_AWAY)
    with_size = f" with a step size of {size:.3g}" if isfinite(size) and size else ""
    return what + with_size, remedy
