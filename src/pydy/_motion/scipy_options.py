"""Options of SciPy's solvers: their names and their values."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np

from pydy._checks import flag, integer, positive, real_array, shown, tolerance
from pydy._option_checks import Check, checked, optional

_FOR_ODEINT = {"max_step": "hmax", "first_step": "h0", "min_step": "hmin"}


def named_for_odeint(options: Mapping[str, object]) -> dict[str, object]:
    """Return options with odeint's names in place of those of the other solvers.

    None and infinity, which mean no limit, become 0.
    """
    named: dict[str, object] = {}
    for name, value in options.items():
        renamed = _FOR_ODEINT.get(name, name)
        if renamed != name and renamed in options:
            raise TypeError(
                f"`{name}` and `{renamed}` are the same option of `odeint`: give one of them."
            )
        unlimited = value is None or (isinstance(value, float) and value == np.inf)
        if renamed != name and unlimited:
            value = 0.0
        named[renamed] = value
    return named


def _jacobian(value: Any, argument: str) -> object:
    """Check the Jacobian of `solve_ivp`: a function, or a matrix, which may be sparse."""
    shape = () if isinstance(value, str) else getattr(value, "shape", np.shape(value))
    if value is None or callable(value) or len(shape) == 2:
        return value
    raise TypeError(
        f"{argument} must be a function {argument[1:-1]}(t, x), a matrix of shape (n, n), or None "
        f"to find it by differences, got {shown(value)}."
    )


def _gradient(value: object, argument: str) -> object:
    """Check the Jacobian of `odeint`."""
    if value is None or callable(value):
        return value
    raise TypeError(
        f"{argument} must be a function {argument[1:-1]}(x, t), or None to find the Jacobian by "
        f"differences, got {shown(value)}."
    )


_SCIPY: dict[str, Check] = {
    **dict.fromkeys(("rtol", "atol"), optional(tolerance)),
    "tcrit": optional(real_array),
    "max_step": positive,
    "first_step": optional(positive),
    # Zero lets the solver choose.
    "hmax": partial(positive, zero=True),
    **dict.fromkeys(("h0", "hmin", "min_step"), partial(positive, zero=True, finite=True)),
    **dict.fromkeys(("mxstep", "mxhnil", "mxordn", "mxords"), partial(integer, least=0)),
    **dict.fromkeys(("ml", "mu", "lband", "uband"), optional(partial(integer, least=0))),
    **dict.fromkeys(("col_deriv", "printmessg", "dense_output", "ixpr"), flag),
    "jac": _jacobian,
    "Dfun": _gradient,
}


def check_scipy_options(options: Mapping[str, object]) -> dict[str, object]:
    """Check options of SciPy's solvers, whose own errors do not name the wrong one."""
    return checked(_SCIPY, options)
