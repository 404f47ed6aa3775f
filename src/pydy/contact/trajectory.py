"""The motion of a System with contacts: a Trajectory that knows its modes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

import numpy as np

from pydy._forks import cached_property
from pydy._interpolation import between
from pydy._simulation.problem import Problem
from pydy.trajectory import EventRecord, Trajectory

_POINTS, _WEIGHTS = np.polynomial.legendre.leggauss(8)


@dataclass(frozen=True, eq=False)
class Piece:
    """A part of the motion in one mode."""

    start: float
    end: float
    modes: tuple[str, ...]
    model: Any  # evaluates derivatives and outputs; see `pydy.trajectory.Model`
    columns: list[int]  # the outputs of the model that are those of the whole trajectory
    # Times to states, and to sensitivities after them if there are any; None if it had more steps
    # than are kept.
    dense: Callable[[np.ndarray], np.ndarray] | None
    sensitive: Any = None


@dataclass(frozen=True, eq=False)
class Part:
    """What was integrated in one mode, up to the event that ended it; see `simulated`."""

    mode: Any  # Mode
    now: Problem
    times: np.ndarray
    states: np.ndarray
    events: Sequence[EventRecord]
    statistics: dict[str, Any]
    dense: Any
    sensitivities: Any = None
    sensitivity_model: Any = None


class _Several:
    """A quantity that is evaluated piece by piece."""

    def __init__(self, pieces: Sequence[Piece]) -> None:
        self.pieces = list(pieces)
        self._starts = np.array([piece.start for piece in pieces])

    def _each(self, times: np.ndarray, value: Callable[[Piece, Any], np.ndarray]) -> np.ndarray:
        """Evaluate each time by its piece; at a transition, by the later one."""
        if len(self.pieces) == 1:
            return value(self.pieces[0], slice(None))
        places = np.searchsorted(self._starts[1:], times, side="right")
        masks = [(k, places == k) for k in (np.unique(places) if len(places) else (0,))]
        values = [(own, value(self.pieces[k], own)) for k, own in masks]
        table = np.empty((len(times), *values[0][1].shape[1:]))
        for own, part in values:
            table[own] = part
        return table


class Pieces(_Several):
    """The model of a motion in several modes; see `pydy.trajectory.Model`."""

    def __init__(self, pieces: Sequence[Piece], base: Any) -> None:
        super().__init__(pieces)
        self.specifieds, self.energy, self.scene = base.specifieds, base.energy, base.scene
        self.jumps = base.jumps

    def derivatives(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the derivatives of the states, shape (m, n)."""
        return self._each(times, lambda p, own: p.model.derivatives(times[own], states[own]))

    def outputs(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the outputs, shape (m, o)."""
        return self._each(
            times, lambda p, own: p.model.outputs(times[own], states[own])[:, p.columns]
        )


class _Dense(_Several):
    """The continuous extension of all pieces; like theirs, it becomes None elsewhere."""

    @property
    def starts(self) -> np.ndarray:
        """The times at which the solver's steps begin."""
        return np.concatenate([piece.dense.starts for piece in self.pieces])  # type: ignore

    def __call__(self, times: np.ndarray) -> np.ndarray:
        """Return the states, and the sensitivities after them."""
        times = np.asarray(times, dtype=float)
        return self._each(times, lambda piece, own: piece.dense(times[own]))  # type: ignore[misc]

    def __deepcopy__(self, memo: Any) -> _Dense:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return type(None), ()


class PieceSensitivities(_Several):
    """The sensitivities of a motion in several modes; see `pydy.trajectory.SensitivityModel`."""

    def rates(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the derivatives of the sensitivities by time, shape (m, n, k)."""
        return self._each(
            times, lambda p, own: p.sensitive.rates(times[own], states[own], values[own])
        )

    def outputs(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the sensitivities of the outputs, shape (m, o, k)."""
        return self._each(
            times,
            lambda p, own: p.sensitive.outputs(times[own], states[own], values[own])[:, p.columns],
        )


class ContactTrajectory(Trajectory):
    """A Trajectory of a System with contacts.

    Its outputs include, for a contact of the name ``floor``, ``floor_gap``, ``floor_normal`` (the
    normal force), ``floor_friction``, ``floor_sliding`` (the sliding speed) and ``floor_power``
    (that of the friction, which is not positive). In a plane in space ``floor_friction_1`` and
    ``floor_friction_2`` are along the two vectors, and so are the sliding speeds. Its `events` are
    the transitions: ``'floor closes'``, ``'floor opens'``, ``'floor slips'`` (it stuck until then),
    ``'floor stops'`` (its sliding speed vanishes), and ``'floor rests'``, the limit of impacts that
    accumulate.

    Attributes
    ----------
    modes : list of (float, float, dict)
        When each part of the motion begins and ends, and the mode of each contact in it: 'open',
        'closed' (without friction), 'sticks', 'slides +' or 'slides -'; in a plane in space 'begins
        to slide' or 'slides'.
    impacts : list of (float, dict)
        The time of each impact, and the impulses of each contact: normal, then tangential.
    """

    def __init__(
        self,
        *args: Any,
        pieces: Pieces,
        names: Sequence[str],
        impacts: Sequence[tuple[float, dict[str, tuple[float, ...]], float]],
        **options: Any,
    ) -> None:
        kept = all(piece.dense is not None for piece in pieces.pieces)
        super().__init__(
            *args, model=pieces, dense=_Dense(pieces.pieces) if kept else None, **options
        )
        self._pieces, self._names = pieces, tuple(names)
        # Impacts and changes of what guides the steps divide the motion, too.
        self.modes = [
            (parts[0].start, parts[-1].end, dict(zip(names, modes, strict=True)))
            for modes, group in groupby(pieces.pieces, key=lambda piece: piece.modes)
            for parts in [list(group)]
        ]
        self.impacts = [(time, impulses) for time, impulses, _ in impacts]
        self._lost = [(time, work) for time, _, work in impacts]

    def __getstate__(self) -> dict[str, Any]:
        whole = super().__getstate__()
        return {**whole, "contact_work": self.contact_work}  # it needs continuous extensions

    def end(self, last: int = -1) -> tuple[tuple[str, ...], Any]:
        """Return the modes of a part of the motion, and the function of its derivatives."""
        piece = self._pieces.pieces[last]
        return piece.modes, piece.model.derivatives

    def at(self, times: Any) -> Trajectory:
        """Return the trajectory at other times, as `Trajectory.at` does; it keeps the modes."""
        found = super().at(times)
        vars(found).update(modes=self.modes, impacts=self.impacts)
        return found

    @cached_property
    def contact_work(self) -> np.ndarray:
        """Work that friction and impacts have done since the first time, shape (m,).

        It is what the total energy has changed by where nothing else does work. That of friction is
        the integral of its power over the solver's steps, by Gauss's rule with 8 points. Without
        the steps, which are kept up to 128 MB, the states are interpolated between `times`.
        """
        own = {f"{name}_power" for name in self._names}
        powers = [k for k, symbol in enumerate(self.outputs_symbols) if str(symbol) in own]
        knots = [self.times]
        for piece in self._pieces.pieces:
            inside = np.asarray(getattr(piece.dense, "starts", ()), dtype=float)
            knots += [inside, np.array([piece.start, piece.end])]
        nodes = np.unique(np.concatenate(knots))
        nodes = nodes[(nodes >= self.times[0]) & (nodes <= self.times[-1])]
        work = np.zeros(len(nodes))
        if powers and len(nodes) > 1:
            half, middle = np.diff(nodes) / 2, (nodes[1:] + nodes[:-1]) / 2
            times = (middle[:, None] + half[:, None] * _POINTS).ravel()
            outputs = self._pieces.outputs(times, between(self, times)[0])
            power = outputs[:, powers].sum(axis=1).reshape(len(half), -1)
            work[1:] = np.cumsum(half * (power @ _WEIGHTS))
        for time, lost in self._lost:
            work[nodes >= time] += lost
        return work[np.searchsorted(nodes, self.times)]
