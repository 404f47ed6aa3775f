"""Check a computed motion against the assumptions of its symbols, such as `positive=True`."""

from __future__ import annotations

from typing import Any

import numpy as np

from pydy._simulation.motion import EvaluationRecorder, Motion
from pydy._simulation.scipy_solvers import is_odeint
from pydy.solvers.options import Options


def check_assumptions(motion: Motion) -> None:
    """Warn once of states and specifieds along a motion that contradict their assumptions.

    Between the requested times a motion is known by the steps of a solver, or by where odeint
    evaluated: its predictions are near the solution, which RK stages are not.
    """
    times, states = motion.times, motion.states
    n = states.shape[1]
    starts, between = getattr(motion.dense, "starts", None), (times[:0], states[:0])
    if motion.dense is not None and starts is not None:
        between = starts, motion.dense(starts)[:, :n]
    elif motion.evaluated is not None and is_odeint(motion.solver) and motion.evaluated.times:
        between = _accepted(motion.evaluated, times, n)
    every = np.concatenate([times, between[0]])
    order = np.argsort(every, kind="stable")
    rows = np.concatenate([states, between[1]])[order]
    motion.problem.check_motion(every[order], rows, *_tolerances(motion))


def _tolerances(motion: Motion) -> tuple[Any, Any]:
    """Return the tolerances; without error control an error of the size of the states."""
    options = motion.options
    if not motion.errors_known or "step" in options:
        return 1.0, 0.0
    given = (options.get("rtol"), options.get("atol"))
    rtol, atol = (
        d if g is None else g for g, d in zip(given, (Options.rtol, Options.atol), strict=True)
    )
    return rtol, atol


def _accepted(
    evaluated: EvaluationRecorder, times: np.ndarray, n: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the times and states at which a solver evaluated, without steps that it rejected.

    After a rejected step it goes on from an earlier time.
    """
    t = np.array(evaluated.times)
    forward = times[-1] >= times[0]
    ahead = t if forward else -t
    later = np.minimum.accumulate(ahead[::-1])[::-1]
    within = (t <= times.max()) & (t >= times.min())
    rows = np.flatnonzero((ahead <= later) & within)
    return t[rows], np.array([evaluated.states[k][:n] for k in rows]).reshape(len(rows), n)
