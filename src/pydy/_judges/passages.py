"""Locate the times at which a motion crosses a discontinuity of its rates."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._rank import HALF, or_one

if TYPE_CHECKING:
    from pydy.trajectory import EventRecord

_IN_STEP = 4  # samples in each step of the solver, in addition to the output times

# Samples of a bracket around a jump, and the number of refinements: to 2⁻⁴⁸ of the bracket.
_FINER, _REFINED = 65, 8

_BY_SWITCH = {"steps", "slopes"}  # blocks that have a row for each switch
Values = dict[str, np.ndarray]
Evaluate = Callable[[np.ndarray], Values]  # of blocks of nodes, at times (m,), each (m, values)


@dataclass(frozen=True)
class WatchedQuantities:
    """Quantities that may jump: blocks 'nodes', 'switches', 'steps', and the switches' 'slopes'.

    The steps are those of each node at each switch, the slopes the derivatives of the switches by
    states, specifieds and constants.
    """

    nodes: Any  # a Program of them, or a function that builds one
    names: tuple[str, ...]  # of the nodes
    states: int
    # Columns of the slopes that belong to sensitivity parameters, without initial conditions.
    parameter_columns: tuple[int, ...] = ()


@dataclass(frozen=True, eq=False)
class MotionPath:
    """An integrated motion that is searched for crossings."""

    times: np.ndarray  # of its outputs
    starts: Sequence[float]  # of the solver's steps
    resets: Sequence[float]  # times of events that changed the state
    columns: Callable[[np.ndarray], np.ndarray | None]  # sensitivities (m, n, k), or None

    @staticmethod
    def from_solution(
        times: np.ndarray,
        dense: object,
        events: Iterable[EventRecord],
        columns: Callable[[np.ndarray], np.ndarray | None],
    ) -> MotionPath:
        """Return a motion with the steps of the solver's dense output, if there is one."""
        resets = [e.time for e in events if not np.array_equal(e.after, e.before)]
        return MotionPath(times, getattr(dense, "starts", ()), resets, columns)

    @property
    def sample_times(self) -> np.ndarray:
        """The output times, and times within the solver's steps."""
        times, ends = self.times, np.append(self.starts, self.times[-1])
        in_steps = ends[:-1] + np.arange(_IN_STEP)[:, None] / _IN_STEP * np.diff(ends)
        every = np.unique(np.concatenate([times, in_steps.ravel()]))
        inside: np.ndarray = every[(every >= times[0]) & (every <= times[-1])]
        return inside


def passages(
    evaluate: Evaluate, times: np.ndarray, resets: Sequence[float] = ()
) -> Iterator[tuple[int, np.ndarray, Values, np.ndarray]]:
    """Yield crossings of switches that no reset accounts for, at most 16 of each, largest first.

    Each is the index of the switch, the bracketing times, the values there, and the magnitudes of
    the nodes along the motion.
    """
    values = _shaped(evaluate(times))
    node_sizes = np.abs(values["nodes"]).max(axis=0, initial=0.0)
    resets_so_far = np.searchsorted(resets, times, side="right")
    for k, value in enumerate(values["switches"].T):
        switch_size = np.abs(value).max()
        nonzero = np.flatnonzero(value)
        turns = np.flatnonzero(np.diff(np.sign(value[nonzero])))
        pairs = np.stack([nonzero[turns], nonzero[turns + 1]], axis=1)
        # A reset between two samples accounts for a change of sign.
        pairs = pairs[resets_so_far[pairs[:, 0]] == resets_so_far[pairs[:, 1]]]
        largest = values["steps"][:, k][pairs].min(axis=1).max(axis=1, initial=0.0)
        # Refine the crossings with the largest steps.
        for bracket in times[pairs[np.argsort(-largest, kind="stable")[:16]]]:
            for _ in range(_REFINED):
                finer = np.linspace(bracket[0], bracket[1], num=_FINER)
                if not (np.diff(finer) > 0.0).all():
                    break
                value = evaluate(finer)["switches"][:, k]
                turn = int(np.argmax(np.sign(value) != np.sign(value[0])))
                bracket = finer[turn - 1 : turn + 1]
            at_crossing = _shaped(evaluate(bracket))
            # A switch that is not near zero here jumps itself: what makes it jump is reported.
            if (np.abs(at_crossing["switches"][:, k]) < HALF * switch_size).any():
                yield k, bracket, at_crossing, node_sizes


def _shaped(values: Values) -> Values:
    m, k = values["switches"].shape
    values["steps"] = np.abs(values["steps"])
    return values | {name: values[name].reshape(m, k, -1) for name in values.keys() & _BY_SWITCH}


def jump_message(motion: MotionPath, watched: WatchedQuantities, evaluate: Evaluate) -> str:
    """Describe the first crossing of a jump that changes the motion's derivatives, or return ''."""
    n, sensitivity = watched.states, motion.columns(motion.times)
    for k, bracket, values, sizes in passages(evaluate, motion.sample_times, motion.resets):
        step, slopes = values["steps"][:, k].min(axis=0), values["slopes"][0, k]
        moved = slopes[:n]
        if sensitivity is not None:  # an adjoint has none
            columns: Any = motion.columns(bracket)
            moved, large = moved @ columns[0], np.abs(moved) @ np.abs(sensitivity).max(axis=0)
            moved[np.abs(moved) <= HALF * large] = 0.0  # the crossing does not depend on them
        by_parameters = slopes[[*watched.parameter_columns]]
        if (step > HALF * sizes).any() and (moved.any() or by_parameters.any()):
            row = int(np.argmax(step / or_one(sizes)))
            return (
                f"At t = {bracket[0]:.6g} {watched.names[row]} jumps by {step[row]:.3g}, and the "
                "derivatives of the motion miss what this changes. Give a smooth one, such as "
                "with tanh(u/v) for sign(u), or an event with a reset there."
            )
    return ""
