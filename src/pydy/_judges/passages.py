"""Find where a motion crosses a discontinuity of its rates."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pydy._rank import HALF, or_one

_IN_STEP = 4  # places in a solver's step that are looked at, beside outputs

# Times between two that a jump is between, and how often they are taken: to 2⁻⁴⁸ of the way.
_FINER, _REFINED = 65, 8

_BY_SWITCH = {"steps", "slopes"}  # blocks that have a row for each switch
Values = dict[str, np.ndarray]
Evaluate = Callable[[np.ndarray], Values]  # of blocks of nodes, at times (m,), each (m, values)


@dataclass(frozen=True)
class Watched:
    """Quantities that may jump: blocks 'nodes', 'switches', 'steps', and the switches' 'slopes'.

    The steps are those of each node at each switch, the slopes the derivatives of the switches by
    states, specifieds and constants.
    """

    nodes: Any  # a Program of them, or what makes one
    names: tuple[str, ...]  # of the nodes
    states: int
    given: tuple[int, ...] = ()  # the places among the slopes of parameters but initial conditions


@dataclass(frozen=True, eq=False)
class Passed:
    """A motion that was integrated."""

    times: np.ndarray  # of its outputs
    starts: Sequence[float]  # of the solver's steps
    resets: Sequence[float]  # times of events that changed the state
    columns: Callable[[np.ndarray], np.ndarray | None]  # sensitivities (m, n, k), if it has any

    @staticmethod
    def of(
        times: np.ndarray,
        dense: Any,
        events: Iterable[Any],
        columns: Callable[[np.ndarray], np.ndarray | None],
    ) -> Passed:
        """Return a motion with the solver's own continuous extension, if there is one."""
        resets = [e.time for e in events if not np.array_equal(e.after, e.before)]
        return Passed(times, getattr(dense, "starts", ()), resets, columns)

    @property
    def looked_at(self) -> np.ndarray:
        """Its times, and places in the solver's steps."""
        times, ends = self.times, np.append(self.starts, self.times[-1])
        within = ends[:-1] + np.arange(_IN_STEP)[:, None] / _IN_STEP * np.diff(ends)
        every = np.unique(np.concatenate([times, within.ravel()]))
        found: np.ndarray = every[(every >= times[0]) & (every <= times[-1])]
        return found


def passages(
    evaluate: Evaluate, times: np.ndarray, resets: Sequence[float] = ()
) -> Iterator[tuple[int, np.ndarray, Values, np.ndarray]]:
    """Yield the switches that a motion passes, with times on both sides, values and sizes."""
    along = _shaped(evaluate(times))
    sizes = np.abs(along["nodes"]).max(axis=0, initial=0.0)
    before = np.searchsorted(resets, times, side="right")
    for k, value in enumerate(along["switches"].T):
        size = np.abs(value).max()
        places = np.flatnonzero(value)
        turns = np.flatnonzero(np.diff(np.sign(value[places])))
        pairs = np.stack([places[turns], places[turns + 1]], axis=1)
        pairs = pairs[before[pairs[:, 0]] == before[pairs[:, 1]]]
        largest = along["steps"][:, k][pairs].min(axis=1).max(axis=1, initial=0.0)
        # Those with the largest steps are looked at closer.
        for beside in times[pairs[np.argsort(-largest, kind="stable")[:16]]]:
            for _ in range(_REFINED):
                finer = np.linspace(beside[0], beside[1], num=_FINER)
                if not (np.diff(finer) > 0.0).all():
                    break
                value = evaluate(finer)["switches"][:, k]
                turn = int(np.argmax(np.sign(value) != np.sign(value[0])))
                beside = finer[turn - 1 : turn + 1]
            found = _shaped(evaluate(beside))
            # What jumps through zero passes a switch of its own there.
            if (np.abs(found["switches"][:, k]) < HALF * size).any():
                yield k, beside, found, sizes


def _shaped(found: Values) -> Values:
    m, k = found["switches"].shape
    found["steps"] = np.abs(found["steps"])
    return found | {name: found[name].reshape(m, k, -1) for name in found.keys() & _BY_SWITCH}


def jump_message(motion: Passed, watched: Watched, evaluate: Evaluate) -> str:
    """Say where a motion passes a jump that moves its derivatives, or nothing."""
    n, known = watched.states, motion.columns(motion.times)
    for k, beside, found, sizes in passages(evaluate, motion.looked_at, motion.resets):
        step, slopes = found["steps"][:, k].min(axis=0), found["slopes"][0, k]
        moved = slopes[:n]
        if known is not None:  # an adjoint has none
            own: Any = motion.columns(beside)
            moved, large = moved @ own[0], np.abs(moved) @ np.abs(known).max(axis=0)
            moved[np.abs(moved) <= HALF * large] = 0.0  # it passes there at any parameters
        if (step > HALF * sizes).any() and (moved.any() or slopes[[*watched.given]].any()):
            row = int(np.argmax(step / or_one(sizes)))
            return (
                f"At t = {beside[0]:.6g} {watched.names[row]} jumps by {step[row]:.3g}, and the "
                "derivatives of the motion miss what this changes. Give a smooth one, such as "
                "with tanh(u/v) for sign(u), or an event with a reset there."
            )
    return ""
