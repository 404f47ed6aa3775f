"""Other runs beside the one that is shown: fainter copies of what moves."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from copy import copy
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pydy._checks import shown, text
from pydy.viz.animation import Animation, Item
from pydy.viz.shapes import Arrow, Plane, Trace

__all__ = ["at_times", "compared", "runs_of"]

_FAINT = 0.3
_MEMBERS = 12  # of an ensemble


@dataclass(frozen=True, eq=False)
class _Frame:
    """A frame in another run: it turns otherwise than that of the run shown."""

    frame: Any


@dataclass(frozen=True, eq=False)
class _Member:
    """What is shown of one sample of an ensemble: a Trajectory of names and numbers."""

    times: np.ndarray
    states: np.ndarray
    state_symbols: tuple[str, ...]
    constants: dict[str, float]

    def at(self, times: np.ndarray) -> _Member:
        """Return the same at other times, by straight lines."""
        columns = [np.interp(times, self.times, column) for column in self.states.T]
        return replace(self, times=times, states=np.stack(columns, 1))


def runs_of(compare: Any) -> list[tuple[str, Any]]:
    """Return labels and trajectories of an argument `compare`.

    Parameters
    ----------
    compare : Trajectory, xarray.Dataset, or a list or dictionary of these
        Of a Dataset with sample dimensions some members are taken, evenly.
    """
    if compare is None:
        return []
    dataset = hasattr(compare, "data_vars")
    if isinstance(compare, Mapping) and not dataset:
        named = [(text(label, "a label in `compare`"), run) for label, run in compare.items()]
    elif isinstance(compare, (list, tuple)):
        named = [(f"run {k}", run) for k, run in enumerate(compare, 2)]
    else:
        named = [("compared", compare)]
    return [part for label, run in named for part in _members(label, run)]


def _members(label: str, run: Any) -> Iterator[tuple[str, Any]]:
    if not hasattr(run, "data_vars"):
        if not (hasattr(run, "state_symbols") and hasattr(run, "at")):
            raise TypeError(
                "`compare` must be a Trajectory, an xarray.Dataset with the dimension 'time', or a "
                f"list or dictionary of these, got {shown(run)}."
            )
        yield label, run
        return
    states = [
        name
        for name, v in run.data_vars.items()
        if v.attrs.get("role") in ("coordinate", "speed", "auxiliary") and "time" in v.dims
    ]
    if not states:
        raise ValueError(
            "`compare` is a Dataset without states over `time`: keep them, with `reduce=None`."
        )
    samples = [d for d in run[states[0]].dims if d != "time"]
    flat = run.stack(member=samples) if samples else run.expand_dims("member")
    count = flat.sizes["member"]
    for k in np.unique(np.linspace(0, count - 1, min(count, _MEMBERS)).round().astype(int)):
        one = flat.isel(member=int(k))
        table = np.stack([np.asarray(one[name], dtype=float) for name in states], 1)
        if np.isfinite(table).all():  # a sample that failed has nothing to show
            roles = one.coords.items()
            constants = {n: float(v) for n, v in roles if v.attrs.get("role") == "constant"}
            times = np.asarray(one["time"], dtype=float)
            yield label, _Member(times, table, tuple(states), constants)


def at_times(run: Any, times: np.ndarray) -> Any:
    """Return a run at the times of another; before and after its own it rests."""
    return run.at(np.clip(times, run.times[0], run.times[-1]))


def compared(animation: Animation, compare: Any, animated: Callable[[Any], Animation]) -> Animation:
    """Return an animation with what moves in other runs, fainter.

    Parameters
    ----------
    animation : Animation
    compare
        See `runs_of`.
    animated : callable
        Returns the Animation of a run.
    """
    others = [(label, animated(at_times(run, animation.times))) for label, run in runs_of(compare)]
    if not others:
        return animation
    items, bounds = list(animation.items), [animation.bounds]
    for label, other in others:
        frames: dict[Any, _Frame | None] = {None: None}
        bounds.append(other.bounds)
        for item, own in zip(other.items, animation.items, strict=True):
            if not isinstance(item.shape, (Plane, Trace)) and _moves(item):
                items.append(_ghost(item, own, label, frames))
    low = np.min([b[:, 0] for b in bounds], axis=0)
    high = np.max([b[:, 1] for b in bounds], axis=0)
    return replace(animation, items=tuple(items), bounds=np.stack([low, high], 1))


def _moves(item: Item) -> bool:
    arrays = (item.positions, item.rotations, item.vectors, item.points)
    return any(a is not None and np.ptp(a, axis=0).any() for a in arrays)


def _ghost(item: Item, own: Item, label: str, frames: dict[Any, _Frame | None]) -> Item:
    visual = copy(item.visual)
    frame = frames.setdefault(visual.frame, _Frame(visual.frame))
    for attribute, value in (("frame", frame), ("name", label), ("trail", False)):
        object.__setattr__(visual, attribute, value)  # a copy of our own
    shape = replace(item.shape, colour=own.shape.colour, opacity=_FAINT * item.shape.opacity)
    if item.vectors is not None and isinstance(shape, Arrow) and isinstance(own.shape, Arrow):
        # One scale for all runs: lengths are there to be compared.
        scale, other = own.shape.scale, shape.scale
        assert scale is not None
        assert other is not None
        item = replace(item, vectors=item.vectors * (scale / other))
        shape = replace(shape, scale=scale)
    return replace(item, visual=visual, shape=shape)
