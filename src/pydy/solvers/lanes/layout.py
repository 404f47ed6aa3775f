"""What the stepper of lanes works on: eight trajectories side by side.

Everything that belongs to one of them has its own place in a block. Vectors are laid out
``[item][lane]``, item by item a block, as kernels of eight lanes take them, and stages one vector
after the other; so `pydy.solvers.run.layout.Memory` serves with a length of eight times the number
of states, and `Memory.step` holds a step size for each lane.
"""

from __future__ import annotations

from typing import NamedTuple

from pydy.solvers.run.layout import Memory, Method, NumberRows, Numbers, WordRows, Words

__all__ = ["EVALUATION", "STEPPING", "Evaluation", "LaneProblem", "Lanes", "Queue"]

# LaneProblem.words begins with those of `Problem`, which code for both reads: here every state is a
# block.
PREPARE, SPECIFIEDS, CONSTANTS = range(5, 8)
# Queue.state
HEAD, BUDGET, LIMIT, PLACE, DISTANCE = range(5)
# Queue.numbers
LARGEST, FIRST = range(2)
# Queue.counts, for each sample
STEPS, REJECTED, EVALUATIONS, STATUS = range(4)  # the last is a code of `outcome`
# Evaluation.places: the address of the first state, and the distances from state to state, from
# sample to sample and from time to time
ORIGIN, PER_STATE, PER_SAMPLE, PER_TIME = range(4)

# What `step_lanes` returns.
PAUSED, EMPTY = range(2)
# Lanes.samples, where there is no sample: free to take one, or repeating a neighbour's.
VACANT, RESTING = -1, -2


class LaneProblem(NamedTuple):
    """The right-hand side, each lane with its own time, specifieds and constants."""

    words: Words
    clock: Numbers
    r: Numbers
    p: Numbers
    c: Numbers
    tables: WordRows  # (k, 3): place in r, first knot, number of knots; for all lanes
    intervals: WordRows  # (k, lanes): where each lane found itself last
    knots: Numbers
    cubics: NumberRows


class Lanes(NamedTuple):
    """Where each trajectory stands: blocks of floats, counts too, but for the last two."""

    time: Numbers
    size: Numbers
    last_error: Numbers
    growth: Numbers
    next: Numbers  # the number of the next output
    due: Numbers  # its time
    steps: Numbers
    rejected: Numbers
    evaluations: Numbers
    reason: Numbers  # the code of what the last rejected step met
    samples: Words
    place: Words  # the address of the next output


class Queue(NamedTuple):
    """The samples, and what became of them.

    Output k of state i of sample j goes to the address
    ``state[PLACE] + 8 (i state[DISTANCE] + j number + k)``, where `number` is that of times.
    """

    state: Words
    numbers: Numbers
    times: Numbers  # and infinity
    x: NumberRows  # (m, states)
    r: NumberRows  # (m, specifieds)
    p: NumberRows  # (m, constants)
    counts: WordRows  # (m, 4)
    reached: Numbers  # (m,): the time up to which the sample was integrated


class Evaluation(NamedTuple):
    """States at which a kernel is evaluated, and where its results go."""

    places: Words
    x: Numbers
    buffer: Numbers  # of all outputs
    r: NumberRows  # (m, specifieds)
    p: NumberRows  # (m, constants)
    times: Numbers
    out: Numbers  # (outputs, m, times)


# The parts of the tables of `step_lanes` and `evaluate_lanes`.
STEPPING = (Method, LaneProblem, Memory, Lanes, Queue)
EVALUATION = (LaneProblem, Evaluation)
