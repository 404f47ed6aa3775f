"""What compiled solvers work on: arrays under names, and names for places in the mixed ones.

All arrays of a run reach compiled code as one table of addresses, which is a struct in C: `table`
and `pydy.solvers.core.declarations` take its rows from the fields and annotations below.
"""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np

__all__ = [
    "ALONG",
    "EXTENSION",
    "PROJECTION",
    "RUN",
    "Beginning",
    "Constraints",
    "Memory",
    "Method",
    "Newton",
    "Problem",
    "Progress",
    "Projection",
    "Steps",
    "Tangents",
    "Wanted",
    "Watch",
]

# Contiguous vectors and matrices.
Words = Annotated[np.ndarray, np.int64, 1]
Numbers = Annotated[np.ndarray, np.float64, 1]
Pairs = Annotated[np.ndarray, np.complex128, 1]
WordRows = Annotated[np.ndarray, np.int64, 2]
NumberRows = Annotated[np.ndarray, np.float64, 2]
PairRows = Annotated[np.ndarray, np.complex128, 2]

# Method.shape
STAGES, ESTIMATES, DENSE_STAGES, DEPTH, END_IN_ESTIMATE = range(5)
# Method.control
EXPONENT, ALPHA, BETA, SAFETY, SHRINK, GROW = range(6)
# Problem.words; of the last two, how many states, which come first, the error is controlled of
KERNEL, STATES, BLOCKS, CONTROLLED, CONTROLLED_BLOCKS = range(5)
# Progress.state
TIME, SIZE, LARGEST, LAST_ERROR, LAST_SIZE, GROWTH, FOUND = range(7)
# Progress.counts
STARTED, STEPS, REJECTED, EVALUATIONS, JACOBIANS, FACTORISATIONS = range(6)
NEXT, BUDGET, LIMIT, FAILURE, LOGGED, PROJECTIONS = range(6, 12)
# Constraints.words
ACTIVE, PROJECTOR, HOLONOMIC, VELOCITY, COORDINATES, SPEEDS, WEIGHTED, PROJECT = range(8)
SCRATCH = 8  # the address of the table of `Projection`
TANGENTS = 9  # the address of the table of `Tangents`
# Constraints.values, from where the kernel's end: the rank of ∂v/∂u so far, and the step at which
# it was nearest to losing it.
RANK, NEARNESS, WHEN, WHERE = range(4)
# Tangents.words: the addresses of the projection of the state and of the kernel, and the number of
# columns.
OF_STATE, DIRECTIONS, COUNT = range(3)
# Watch.words
WATCHER, EVENTS, SCAN = range(3)
# Steps.words: the number of steps that are kept, and for how many rows there is room, 0 for none
KEPT, ROOM = range(2)
# Newton.words: the address of the Jacobian's kernel, or 0 for differences; whether a new Jacobian
# is wanted, the one there is that of the present state, the factors there are its own, and no step
# has been accepted since the last rejected one; and the number of columns of sensitivities.
GRADIENT, WANTED, FRESH, FACTORISED, FIRST, COUNTED = range(6)
# Newton.sizes: the step sizes of the factors and of the polynomial that predicts the next stages.
FACTORED, PREDICTING = range(2)

# What `advance` returns while it has not ended; a code of `outcome` when it has.
PAUSED, EVENT, LOG_FULL, CALLBACK, STEPS_FULL = -1, -2, -3, -4, -5
# Progress.counts[FAILURE] is the code of what the last rejected step met.


class Method(NamedTuple):
    """A tableau as arrays.

    Rows are stages of the step, weights, estimates of the error, stages of the interpolant, and
    the interpolant, in this order; `offsets` are places in ``Memory.stages``.
    """

    shape: Words
    rows: Words  # where each row begins in the two arrays that follow
    offsets: Words
    weights: Numbers
    nodes: Numbers
    control: Numbers


class Problem(NamedTuple):
    """The right-hand side ``x' = f(t, x; r(t), c)``."""

    words: Words
    clock: Numbers  # (1,): the kernel's t
    r: Numbers
    c: Numbers
    tables: WordRows  # (k, 4): place in r, first knot, number of knots, last interval
    knots: Numbers
    cubics: NumberRows  # (·, 4): from each knot on, lowest power first


class Memory(NamedTuple):
    """One trajectory's numbers; vectors are padded with zeros to whole blocks."""

    x: Numbers
    new: Numbers
    trial: Numbers
    step: Numbers  # the step size, once for each place of a block
    theta: Numbers  # a part of the step, the same way
    zero: Numbers
    errors: Numbers  # two vectors, one after the other
    stages: Numbers  # vectors
    interpolant: Numbers  # vectors
    rtol: Numbers
    atol: Numbers


class Progress(NamedTuple):
    """Where the integration stands."""

    state: Numbers
    counts: Words
    times: Numbers


class Constraints(NamedTuple):
    """What the projection works with; nothing when ``words[ACTIVE]`` is 0."""

    words: Words
    c: Numbers
    # residuals (h), (v); ∂h/∂q (h, q); N (q, u); ∂v/∂u (v, u); M (u, u); rounding bounds (h);
    # then what the projection notes: `RANK` and so on, a state, the longest that rows were (v)
    values: Numbers


class Projection(NamedTuple):
    """What the projection computes in between, of h positions and v velocities."""

    factor: NumberRows  # (u, u)
    kinematics: NumberRows  # (q, u)
    gradient: NumberRows  # (h, q)
    holonomic: NumberRows  # (h, u)
    velocity: NumberRows  # (v, u)
    step: Numbers  # (u,) or (q,), whichever is more
    # h or v, whichever is more
    right: Numbers
    scale: Numbers
    left: Words
    lengths: Numbers
    kept: Numbers


class Tangents(NamedTuple):
    """What the projection of sensitivities works with."""

    words: Words
    c: Numbers
    # The derivatives of the holonomic, then of the velocity residuals, row after row.
    values: Numbers


class Watch(NamedTuple):
    """The events and what they have seen."""

    words: Words
    c: Numbers
    directions: Words  # −1, 1, or 0 for both
    acting: Words  # whether the integration stops there
    sides: Words  # the sign last seen, 0 before there was one
    fired: Words
    values: Numbers  # (2, events)
    trial: Numbers  # a state
    log_times: Numbers
    log_events: Words
    log_states: NumberRows  # (·, states)


class Beginning(NamedTuple):
    """What `Progress` holds when a run begins."""

    state: Numbers
    counts: Words


class Steps(NamedTuple):
    """The accepted steps, a row each: time, size and state.

    The implicit method adds its interpolant. The row after the last step's is that of its end, with
    size 0.
    """

    words: Words
    rows: NumberRows


class Wanted(NamedTuple):
    """Times at which the continuous extension is wanted."""

    rows: NumberRows  # those of `Steps`
    times: Numbers
    places: Words  # the row of each time
    out: Numbers  # states, one after the other, and a block more


class Newton(NamedTuple):
    """What an implicit step works with."""

    words: Words
    sizes: Numbers
    c: Numbers
    jacobian: Numbers  # (n, n), row after row, of the states without their sensitivities
    real: NumberRows  # (n, n)
    pair: PairRows  # (n, n)
    real_order: Words
    pair_order: Words
    stages: NumberRows  # (3, n), here and below with sensitivities: z, the stages less the state
    waves: NumberRows  # (3, n): w, the same transformed
    slopes: NumberRows  # (3, n)
    last: NumberRows  # (4, n): state and interpolant of the step before
    real_change: Numbers  # (n,): the right-hand side and the solution of a system
    pair_change: Pairs  # (n,)
    guess: Numbers  # (n,)


# The tables' parts, in their order; `Newton` is there for the implicit method only.
RUN = (Method, Problem, Memory, Progress, Constraints, Watch, Beginning, Steps, Newton)
EXTENSION = (Wanted,)
PROJECTION = (Projection,)
ALONG = (Tangents,)
