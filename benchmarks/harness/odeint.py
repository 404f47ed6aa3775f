"""odeint as a contestant, for the two packages that have it for their default."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.integrate import odeint

from harness.solving import SolverPeer


def odeint_solver(
    function: Callable[..., Any], peer: SolverPeer, args: tuple[Any, ...], tolerance: float
) -> Callable[[], np.ndarray]:
    """Return what `SolverPeer.solver` does, by odeint.

    Raises
    ------
    RuntimeError
        odeint only warns when it gives up, as it does where tolerances are too tight.
    """
    start, times = peer.scenario.start, [0.0, peer.scenario.horizon]
    limits = {"args": args, "rtol": tolerance, "atol": tolerance, "mxstep": 10**6}
    message = odeint(function, start, times, **limits, full_output=True)[1]["message"]
    if message != "Integration successful.":
        raise RuntimeError(message)
    return lambda: odeint(function, start, times, **limits)[-1]
