"""Recorded steps: what a native solver stores of a run, so that a backward pass can repeat it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy.solvers.outcome import Outcome
from pydy.trajectory import EventRecord

if TYPE_CHECKING:
    from pydy.solvers.run.integration import Integration


@dataclass(frozen=True, eq=False)
class RecordedSteps:
    """The m accepted steps of a run, which a backward pass repeats one by one.

    An event may have ended a step early. States are those of the equations, such as the states of a
    system and integrals along its motion, without sensitivities that only control the step size.
    """

    starts: np.ndarray  # (m,): the times at which steps begin
    ends: np.ndarray  # (m,): the times at which they end
    states: np.ndarray  # (m, n): the states at their starts
    end: float  # the time at which the run ended
    end_state: np.ndarray  # (n,)
    events: Sequence[EventRecord]
    stopped: bool  # whether a terminal event ended the run
    switched: np.ndarray | None  # the rows of the switches by time; see `KernelCall`

    @staticmethod
    def of_run(
        integration: Integration, info: Mapping[str, Any], states: np.ndarray
    ) -> RecordedSteps:
        """Return the steps of the latest run, given its statistics, and its states at the times."""
        width = states.shape[1]
        rows: Any = integration.step_rows()
        end, stopped = info["time"], info["code"] == Outcome.TERMINATED
        final_state = integration.memory.x[:width].copy()
        accepted = rows[:, 1] > 0.0
        starts = rows[accepted, 0]
        ends = np.append(starts, end)[1:]  # includes steps that an event ended early
        nonempty = ends > starts
        return RecordedSteps(
            starts[nonempty],
            ends[nonempty],
            rows[accepted, 2 : 2 + width][nonempty],
            end,
            final_state if stopped or not len(states) else states[-1],
            info["events"],
            stopped,
            None if integration.call is None else integration.call.switched,
        )
