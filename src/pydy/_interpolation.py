"""States and sensitivities between the times of a trajectory."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

import numpy as np

from pydy._checks import ascending, real_array


class Model(Protocol):
    """The interface of a trajectory's model, evaluated at times (m,) and states (m, n)."""

    def derivatives(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return x', shape (m, n)."""

    def outputs(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the outputs, shape (m, o)."""

    def specifieds(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the specifieds, shape (m, s)."""

    def energy(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return kinetic, potential and total energy, shape (m, 3)."""

    def scene(self, *visuals: Any, **options: Any) -> Any:
        """Return a scene that shows the model."""


class SensitivityModel(Protocol):
    """The interface of the model of a trajectory's sensitivities.

    At times (m,), states (m, n) and sensitivities of the states (m, n, k).
    """

    def rates(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the derivatives of the sensitivities by time, shape (m, n, k)."""

    def outputs(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the sensitivities of the outputs, shape (m, o, k)."""


def checked_times(times: Any, own: np.ndarray) -> np.ndarray:
    """Check that times ascend and lie within those of a trajectory."""
    checked = ascending(np.atleast_1d(real_array(times, "`times`")), "`times`")
    outside = checked[~((checked >= own[0]) & (checked <= own[-1]))]
    if outside.size:
        raise ValueError(
            f"`times` must be within the simulated time, {own[0]} to {own[-1]}, got {outside[0]}."
        )
    return checked


def filled(trajectory: Any, step_of: Callable[[float], float]) -> Any:
    """Refine a trajectory where its times are two or more steps apart.

    `step_of` returns the step for a span of time. Without the solver's continuous extension, it is
    the trajectory itself: what is known at its times alone would be made up between them.
    """
    if getattr(trajectory, "_dense", None) is None or len(trajectory.times) < 2:
        return trajectory
    own = trajectory.times
    gaps = np.diff(own)
    parts = np.maximum(np.floor(gaps / step_of(float(own[-1] - own[0]))), 1.0).astype(int)
    if not (parts > 1).any():
        return trajectory
    k = np.repeat(np.arange(len(gaps)), parts)
    part = np.arange(len(k)) - (np.cumsum(parts) - parts)[k]
    return trajectory.at(np.append(own[k] + gaps[k] * (part / parts[k]), own[-1]))


def between(
    known: Any, times: np.ndarray, values: np.ndarray | None
) -> tuple[np.ndarray, np.ndarray | None]:
    """Interpolate the states of a Trajectory, and its sensitivities if there are `values`."""
    m, n = known.states.shape
    whole = known._dense(times) if known._dense else _hermite(known, times, values)
    if values is None:
        return whole, None
    if whole.shape[1] == n:  # no derivatives by time: straight lines
        columns = [np.interp(times, known.times, v) for v in values.reshape(m, -1).T]
        whole = np.column_stack([whole, *columns])
    return whole[:, :n].copy(), whole[:, n:].reshape(len(times), n, values.shape[2])


def _hermite(known: Any, times: np.ndarray, values: np.ndarray | None) -> np.ndarray:
    """Interpolate states, followed by sensitivities if their derivatives are known."""
    nodes = known.times
    x, rates = _beside(known, nodes, known.states, known.derivatives, values)
    if known.events and known._model is not None:
        nodes, x, rates = _with_events(known, x, rates, values is not None)
    # The last of equal times, so that an interval has a length wherever there is one.
    k = np.clip(np.searchsorted(nodes, times, side="right") - 1, 0, len(nodes) - 1)
    after = np.minimum(k + 1, len(nodes) - 1)
    h = (nodes[after] - nodes[k])[:, None]
    s = np.divide((times - nodes[k])[:, None], h, out=np.zeros_like(h), where=h > 0.0)
    value = x[k] + (3.0 - 2.0 * s) * s**2 * (x[after] - x[k])
    slope = h * s * (1.0 - s) * ((1.0 - s) * rates[k] - s * rates[after])
    result: np.ndarray = value + slope
    return result


def _beside(
    known: Any, times: np.ndarray, states: np.ndarray, rates: np.ndarray, values: Any
) -> tuple[np.ndarray, np.ndarray]:
    """Append sensitivities and their derivatives by time to states and theirs."""
    model, m = known._sensitivity_model, len(times)
    if model is None or values is None:
        return states, rates
    slopes = model.rates(times, states, values)
    return (
        np.concatenate([states, values.reshape(m, -1)], axis=1),
        np.concatenate([rates, slopes.reshape(m, -1)], axis=1),
    )


def _with_events(
    known: Any, x: np.ndarray, rates: np.ndarray, sensitive: bool
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Insert both sides of each event into the nodes, values and derivatives."""
    moments = np.repeat([e.time for e in known.events], 2)
    sides = np.array([side for e in known.events for side in (e.before, e.after)])
    values = None
    if sensitive:
        pairs = ((e.sensitivity_before, e.sensitivity_after) for e in known.events)
        values = np.array([value for pair in pairs for value in pair])
    slopes = known._model.derivatives(moments, sides)
    own = _beside(known, moments, sides, slopes, values)
    # A node at the time of an event may be of either side: the event's own replace it.
    other = ~np.isin(known.times, moments)
    nodes = np.concatenate([moments, known.times[other]])
    order = np.argsort(nodes, kind="stable")
    tables = zip(own, (x, rates), strict=True)
    x, rates = (np.concatenate([mine, table[other]])[order] for mine, table in tables)
    return nodes[order], x, rates
