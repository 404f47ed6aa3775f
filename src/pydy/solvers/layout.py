"""What compiled solvers work on: arrays under names, and names for places in the mixed ones."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

__all__ = ["Constraints", "Memory", "Method", "Problem", "Run", "Watch"]

# Method.shape
STAGES, ESTIMATES, DENSE_STAGES, DEPTH, END_IN_ESTIMATE = range(5)
# Method.control
EXPONENT, ALPHA, BETA, SAFETY, SHRINK, GROW = range(6)
# Problem.words
KERNEL, STATES, BLOCKS = range(3)
# Run.state
TIME, SIZE, LARGEST, LAST_ERROR, LAST_SIZE, GROWTH, FOUND = range(7)
# Run.counts
STARTED, STEPS, REJECTED, EVALUATIONS, JACOBIANS, FACTORISATIONS = range(6)
NEXT, BUDGET, LIMIT, FAILURE, LOGGED, PROJECTIONS = range(6, 12)
# Constraints.words
ACTIVE, PROJECTOR, HOLONOMIC, VELOCITY, COORDINATES, SPEEDS, WEIGHTED, PROJECT = range(8)
# Constraints.values, from where the kernel's end: the rank of ∂v/∂u so far, and the step at which
# it was nearest to losing it.
RANK, NEARNESS, WHEN, WHERE = range(4)
# Watch.words
WATCHER, EVENTS, SCAN = range(3)

# What `advance` returns while it has not ended; a code of `outcome` when it has.
PAUSED, EVENT, LOG_FULL, CALLBACK = -1, -2, -3, -4
# Run.counts[FAILURE] is the code of what the last rejected step met.

# The first step, in units of the time: far enough above rounding to be shortened if need be.
SHORTEST = 2.0**-44


class Method(NamedTuple):
    """A tableau as arrays.

    Rows are stages of the step, weights, estimates of the error, stages of the interpolant, and
    the interpolant, in this order; `offsets` are places in ``Memory.stages``.
    """

    shape: np.ndarray  # int64
    rows: np.ndarray  # int64: where each row begins in the two arrays that follow
    offsets: np.ndarray  # int64
    weights: np.ndarray
    nodes: np.ndarray
    control: np.ndarray


class Problem(NamedTuple):
    """The right-hand side ``x' = f(t, x; r(t), c)``."""

    words: np.ndarray  # int64
    clock: np.ndarray  # (1,): the kernel's t
    r: np.ndarray
    c: np.ndarray
    tables: np.ndarray  # int64 (k, 4): place in r, first knot, number of knots, last interval
    knots: np.ndarray
    cubics: np.ndarray  # (·, 4): from each knot on, lowest power first


class Memory(NamedTuple):
    """One trajectory's numbers; vectors are padded with zeros to whole blocks."""

    x: np.ndarray
    new: np.ndarray
    trial: np.ndarray
    step: np.ndarray  # the step size, once for each place of a block
    theta: np.ndarray  # a part of the step, the same way
    zero: np.ndarray
    errors: np.ndarray  # two vectors, one after the other
    stages: np.ndarray  # vectors
    interpolant: np.ndarray  # vectors
    rtol: np.ndarray
    atol: np.ndarray


class Run(NamedTuple):
    """Where the integration stands, and what it has written."""

    state: np.ndarray
    counts: np.ndarray  # int64
    times: np.ndarray
    flat: np.ndarray  # row after row and a block more: rows are written in whole blocks


class Constraints(NamedTuple):
    """What the projection works with; nothing when ``words[ACTIVE]`` is 0."""

    words: np.ndarray  # int64
    c: np.ndarray
    # residuals (h), (v); ∂h/∂q (h, q); N (q, u); ∂v/∂u (v, u); M (u, u); rounding bounds (h);
    # then what the projection notes: `RANK` and so on, a state, the longest that rows were (v)
    values: np.ndarray


class Watch(NamedTuple):
    """The events and what they have seen."""

    words: np.ndarray  # int64
    c: np.ndarray
    directions: np.ndarray  # int64: −1, 1, or 0 for both
    acting: np.ndarray  # int64: whether the integration stops there
    sides: np.ndarray  # int64: the sign last seen, 0 before there was one
    fired: np.ndarray  # int64
    values: np.ndarray  # (2, events)
    trial: np.ndarray  # a state
    log_times: np.ndarray
    log_events: np.ndarray  # int64
    log_states: np.ndarray  # (·, states)
