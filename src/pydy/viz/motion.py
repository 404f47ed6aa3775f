"""What moves a scene: a trajectory, or arrays of times and states, as ordered numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pydy._checks import check_mapping, listed, number, real_array
from pydy._names import name_of
from pydy.viz.poses import Names
from pydy.viz.tuning import ON_TIME

__all__ = [
    "Model",
    "Motion",
    "checked_samples",
    "motion_of_arrays",
    "motion_of_trajectory",
    "sampled",
]


@dataclass(frozen=True)
class Motion:
    """Numbers at m instants, in the order of their names.

    Attributes
    ----------
    names : Names
    times : ndarray, shape (m,)
    states : ndarray, shape (m, n)
    specifieds : ndarray, shape (m, s)
    constants : ndarray, shape (k,)
    """

    names: Names
    times: np.ndarray
    states: np.ndarray
    specifieds: np.ndarray
    constants: np.ndarray

    @property
    def values(self) -> dict[Any, float]:
        """The constants' values by symbol."""
        return dict(zip(self.names.constants, self.constants.tolist(), strict=True))

    def taken(self, rows: np.ndarray) -> Motion:
        """Return the Motion at some of the instants."""
        return Motion(
            self.names, self.times[rows], self.states[rows], self.specifieds[rows], self.constants
        )


@dataclass(frozen=True)
class Model:
    """What a System tells a Scene.

    Attributes
    ----------
    states : tuple of symbols
    definitions : mapping of symbols to expressions
        Derivatives of the coordinates, auxiliary speeds.
    times : callable
        ``times() -> ndarray``, when the System's states are wanted.
    trajectory : callable
        ``trajectory(times, states)`` returns a Trajectory, of checked arrays.
    live : callable
        Returns what a live page needs, a `pydy.viz.live.LiveSystem`, for events and constraints.
    """

    states: tuple[Any, ...]
    definitions: Mapping[Any, Any] = field(default_factory=dict)
    times: Callable[[], np.ndarray] | None = None
    trajectory: Callable[[Any, Any], Any] | None = None
    live: Callable[..., Any] | None = None


def checked_samples(times: Any, states: Any, width: int) -> tuple[np.ndarray, np.ndarray]:
    """Return times (m,) and states (m, width) as arrays, or say what is wrong with them."""
    t, x = real_array(times, "`times`"), real_array(states, "`states`")
    if t.ndim != 1 or not len(t):
        raise ValueError(
            f"`times` must be a sequence of one time or more, got the shape {t.shape}."
        )
    if x.shape != (len(t), width):
        raise ValueError(
            f"`states` must have the shape ({len(t)}, {width}), a row for each of the times and a "
            f"column for each state, got {x.shape}."
        )
    down = np.flatnonzero(~(np.diff(t) >= 0))
    if down.size or not np.isfinite(t).all():
        k = int(down[0]) if down.size else len(t) - 2
        raise ValueError(
            f"`times` must be finite and ascending, got {t[k + 1]} after {t[k]} at index {k + 1}."
        )
    return np.ascontiguousarray(t), np.ascontiguousarray(x)


def _finite(names: Names, times: np.ndarray, table: np.ndarray, symbols: Sequence[Any]) -> None:
    bad = np.argwhere(~np.isfinite(table))
    if len(bad):
        k, j = map(int, bad[0])
        raise ValueError(
            f"`{symbols[j]}` is {table[k, j]} at t = {times[k]:g}, index {k}: there is nothing to "
            "draw. Did the integration fail there? Pass the part before."
        )


def motion_of_trajectory(
    trajectory: Any, model: Model | None, constants: Any = None, wanted: Iterable[Any] = ()
) -> Motion:
    """Return the Motion of a Trajectory.

    Parameters
    ----------
    trajectory : Trajectory
        Anything with its attributes `times`, `states`, `state_symbols`, `constants`, `specifieds`
        and `specifieds_symbols`.
    model : Model or None
        Of the System that the scene belongs to.
    constants : mapping of symbols to numbers, optional
        More of them, or others.
    wanted : iterable of symbols
        Those of them that are outputs are taken from the trajectory.

    Raises
    ------
    TypeError
        It is no trajectory.
    ValueError
        It is one of another system, or has values that are not finite.
    """
    missing = [a for a in ("times", "states", "state_symbols") if not hasattr(trajectory, a)]
    if missing:
        raise TypeError(
            "`animate` takes a Trajectory, or times and states, got the "
            f"{type(trajectory).__name__} {trajectory!r}."
        )
    symbols = tuple(trajectory.state_symbols)
    # A trajectory from a file has names in the place of symbols.
    if model is not None and set(map(name_of, model.states)) != set(map(name_of, symbols)):
        raise ValueError(
            f"The trajectory is one of another system: it has the states {_listed(symbols)}, the "
            f"scene's system has {_listed(model.states)}. Animate a trajectory of this system, or "
            "make the scene from that one."
        )
    values = {**dict(getattr(trajectory, "constants", None) or {}), **_constants(constants)}
    specified = tuple(getattr(trajectory, "specifieds_symbols", None) or ())
    definitions = model.definitions if model is not None else {}
    outputs = tuple(getattr(trajectory, "outputs_symbols", ()))
    more = {symbol: trajectory[symbol] for symbol in wanted if symbol in outputs}
    names = Names(symbols, (*specified, *more), tuple(values), definitions)
    times, states = checked_samples(trajectory.times, trajectory.states, len(symbols))
    rows = np.asarray(trajectory.specifieds, dtype=float) if specified else np.zeros((1, 0))
    rows = np.broadcast_to(rows, (len(times), len(specified)))
    rows = np.ascontiguousarray(np.column_stack([rows, *more.values()]))
    _finite(names, times, states, symbols)
    _finite(names, times, rows, names.specifieds)
    return Motion(names, times, states, rows, np.array([float(v) for v in values.values()]))


def motion_of_arrays(
    times: Any,
    states: Any,
    symbols: Sequence[Any] | None,
    constants: Mapping[Any, Any] | None,
    specifieds: Mapping[Any, Any] | None,
) -> Motion:
    """Return the Motion of plain arrays.

    Parameters
    ----------
    times : array_like, shape (m,)
    states : array_like, shape (m, n)
    symbols : sequence of functions of time
        What the columns of `states` are.
    constants : mapping of symbols to numbers, optional
    specifieds : mapping of functions of time to numbers or arrays of shape (m,), optional
    """
    if symbols is None:
        raise TypeError(
            "`symbols` must say what the columns of `states` are, such as symbols=[q1, q2, u1, "
            "u2]; only a scene made by `system.scene()` knows."
        )
    symbols = tuple(listed("symbols", symbols, "functions of time", hashable=True))
    symbols = tuple(s.removesuffix("(t)") if isinstance(s, str) else s for s in symbols)
    t, x = checked_samples(times, states, len(symbols))
    columns = []
    given = check_mapping("specifieds", specifieds)
    for symbol, value in given.items():
        column = real_array(value, f"`specifieds[{symbol}]`")
        if column.shape not in ((), (len(t),)):
            raise ValueError(
                f"`specifieds[{symbol}]` must be a number or have the shape ({len(t)},), got "
                f"{column.shape}."
            )
        columns.append(np.broadcast_to(column, t.shape))
    rows = np.stack(columns, 1) if columns else np.zeros((len(t), 0))
    values = _constants(constants)
    names = Names(symbols, tuple(given), tuple(values))
    _finite(names, t, x, symbols)
    _finite(names, t, rows, names.specifieds)
    return Motion(names, t, x, rows, np.array([float(v) for v in values.values()]))


def _constants(constants: Any) -> dict[Any, float]:
    given = check_mapping("constants", constants)
    return {symbol: number(value, f"`constants[{symbol}]`") for symbol, value in given.items()}


def _listed(symbols: Sequence[Any]) -> str:
    shown = [str(s) for s in symbols[:6]]
    return ", ".join(shown) + (f" and {len(symbols) - 6} more" if len(symbols) > 6 else "")


def sampled(times: np.ndarray, step: float) -> np.ndarray:
    """Return the indices of the samples to keep: no two closer than `step` but the last.

    Only samples that were computed are kept, so the poses at them are exact.

    Examples
    --------
    >>> import numpy as np
    >>> from pydy.viz.motion import sampled
    >>> sampled(np.linspace(0, 1, 101), 1 / 30)[:4]
    array([ 0,  4,  8, 12])
    """
    keep = [0]
    last = len(times) - 1
    close = step * (1 - ON_TIME)  # a rounding error is not a frame less
    while True:
        k = max(int(np.searchsorted(times, times[keep[-1]] + close)), keep[-1] + 1)
        if k > last:
            break
        keep.append(k)
    if keep[-1] != last and times[last] > times[keep[-1]]:
        if len(keep) > 1 and times[last] - times[keep[-2]] < 1.5 * step:
            keep.pop()
        keep.append(last)
    return np.array(keep)
