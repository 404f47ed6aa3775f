"""Evaluate compiled blocks at one state or along a trajectory."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from pydy import _errors
from pydy._assembly.definition import Definition
from pydy._checks import real_array
from pydy._names import numbers_of, unique_names
from pydy._system.causes import cause_of
from pydy._system.snapshot import At, Snapshot
from pydy.trajectory import Trajectory


def samples(
    x: Any, t: Any, default: Callable[[], np.ndarray], times: np.ndarray, n: int
) -> tuple[np.ndarray, np.ndarray, bool]:
    """Return states (m, n), times (m,), and whether there is only one sample."""
    if x is None:
        states = default()
    else:
        states = real_array(x, "`x`")
        if states.ndim not in (1, 2) or states.shape[-1] != n:
            raise ValueError(
                f"`x` must have the shape ({n},) or (m, {n}), one column for each state, got "
                f"{states.shape}."
            )
    single = states.ndim == 1
    if t is None:
        if single:
            instants = times[:1] if len(times) else np.zeros(1)
        else:
            instants = times if len(times) else np.zeros(len(states))
        source = "the System's `times`"
    else:
        instants = real_array(t, "`t`")
        source = "`t`"
        if single:
            if instants.ndim != 0:
                raise ValueError(
                    f"`t` must be a scalar for `x` of the shape {states.shape}, got the shape "
                    f"{np.shape(t)}."
                )
            instants = instants.reshape(1)
        elif instants.ndim != 1:
            raise ValueError(
                f"`t` must have the shape ({len(states)},) for `x` of the shape {states.shape}, "
                f"got the shape {np.shape(t)}."
            )
    if not single and len(instants) != len(states):
        raise ValueError(
            f"`x` and `t` must have as many rows as times: `x` has the shape {states.shape}, "
            f"{source} the shape {instants.shape}."
        )
    return (states[None] if single else states), np.ascontiguousarray(instants), single


def specified_rows(r: Any, t: np.ndarray, size: int) -> np.ndarray:
    """Return an array of all specifieds for m samples: shape (1, s) for all alike, or (m, s)."""
    array = real_array(r, "`r`")
    if array.shape == (size,) or array.shape == (len(t), size):
        return np.atleast_2d(array)
    raise ValueError(f"`r` must have the shape ({size},) or ({len(t)}, {size}), got {array.shape}.")


def row_names(definition: Definition, block: str) -> list[str]:
    """Return what to call the values of a block in messages."""
    equations = definition.equations
    if block == "rates":
        return [f"the derivative of {s}" for s in definition.states]
    if block == "outputs":
        return [getattr(s, "name", str(s)) for s in definition.outputs_symbols]
    if block == "energy":
        return ["the kinetic energy", "the potential energy", "the total energy"]
    if block.startswith("kinetic"):
        return ["the kinetic energy"] if block == "kinetic_energy" else []
    kinds = ("holonomic", "nonholonomic") if block == "constraints" else (block,)
    return [
        f"the residual of {kind} constraint {k}"
        for kind in kinds
        for k, _ in enumerate(getattr(equations, kind))
    ]


def warn_not_finite(out: np.ndarray, at: At, names: Sequence[str]) -> None:
    """Warn of values (m, o, …) of o names that are not finite where what they follow from is."""
    sound = np.isfinite(at.t) & np.isfinite(at.x).all(axis=1) & np.isfinite(at.r).all(axis=1)
    wrong = ~np.isfinite(out.reshape(*out.shape[:2], -1)).all(axis=2)
    wrong &= (sound & np.isfinite(at.p).all())[:, None]

    def place(k: int) -> tuple[str, str | None]:
        state = numbers_of(at.definition.states, at.x[k])
        return f"t = {float(at.t[k])!r} in the state {state}", cause_of(at.some([k]))

    _errors.warn_not_finite(wrong, names, place)


def warn_of_outputs(trajectory: Trajectory, now: Snapshot) -> None:
    """Warn of outputs along a motion that are not finite where its states are."""
    at = now.at(trajectory.times, trajectory.states)
    warn_not_finite(trajectory.outputs, at, unique_names(trajectory.outputs_symbols))
