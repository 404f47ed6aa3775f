"""What the stepper of lanes works on: eight trajectories side by side.

Everything that belongs to one of them has its own place in a block. Vectors are laid out
``[item][lane]``, item by item a block, as kernels of eight lanes take them, and stages one vector
after the other; so `pydy.solvers.layout.Memory` serves with a length of eight times the number of
states, and `Memory.step` holds a step size for each lane.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

__all__ = ["LaneProblem", "Lanes", "Queue"]

# LaneProblem.words
KERNEL, PREPARE, STATES, SPECIFIEDS, CONSTANTS = range(5)
# Queue.state
HEAD, BUDGET, LIMIT, PLACE, DISTANCE = range(5)
# Queue.numbers
LARGEST, FIRST = range(2)
# Queue.counts, for each sample
STEPS, REJECTED, EVALUATIONS, STATUS = range(4)  # the last is a code of `outcome`

# What `step_lanes` returns.
PAUSED, EMPTY = range(2)
# Lanes.samples, where there is no sample: free to take one, or repeating a neighbour's.
VACANT, RESTING = -1, -2


class LaneProblem(NamedTuple):
    """The right-hand side, each lane with its own time, specifieds and constants."""

    words: np.ndarray  # int64
    clock: np.ndarray
    r: np.ndarray
    p: np.ndarray
    c: np.ndarray
    tables: np.ndarray  # int64 (k, 3): place in r, first knot, number of knots; for all lanes
    intervals: np.ndarray  # int64 (k, lanes): where each lane found itself last
    knots: np.ndarray
    cubics: np.ndarray


class Lanes(NamedTuple):
    """Where each trajectory stands: blocks of floats, counts too, but for the last two."""

    time: np.ndarray
    size: np.ndarray
    last_error: np.ndarray
    growth: np.ndarray
    next: np.ndarray  # the number of the next output
    due: np.ndarray  # its time
    steps: np.ndarray
    rejected: np.ndarray
    evaluations: np.ndarray
    reason: np.ndarray  # the code of what the last rejected step met
    samples: np.ndarray  # int64
    place: np.ndarray  # int64: the address of the next output


class Queue(NamedTuple):
    """The samples, and what became of them.

    Output k of state i of sample j goes to the address
    ``state[PLACE] + 8 (i state[DISTANCE] + j number + k)``, where `number` is that of times.
    """

    state: np.ndarray  # int64
    numbers: np.ndarray
    times: np.ndarray  # and infinity
    x: np.ndarray  # (m, states)
    r: np.ndarray  # (m, specifieds)
    p: np.ndarray  # (m, constants)
    counts: np.ndarray  # int64 (m, 4)
    reached: np.ndarray  # (m,): the time up to which the sample was integrated
