"""What compiled solvers work on: arrays under names, and names for places in the mixed ones.

All arrays of a run reach compiled code as one table of addresses, which is all that it is given. A
table has a row for each field of its parts, the named tuples below, in their order. In C it is a
struct (`pydy.solvers.core.declarations`).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain
from typing import Annotated, NamedTuple

import numpy as np

from pydy._array_layout import address

# Contiguous vectors and matrices.
Words = Annotated[np.ndarray, np.int64, 1]
Numbers = Annotated[np.ndarray, np.float64, 1]
WordRows = Annotated[np.ndarray, np.int64, 2]
NumberRows = Annotated[np.ndarray, np.float64, 2]

# Method.shape
STAGES, ESTIMATES, DENSE_STAGES, DEPTH, END_IN_ESTIMATE = range(5)
# Method.control
EXPONENT, ALPHA, BETA, SAFETY, SHRINK, GROW = range(6)
# Kernels are known by the place of their address, in all words of them.
# Problem.words; the error is controlled of the CONTROLLED components, which come first, and bounded
# of the others up to BOUNDED (0: of none); it is estimated in so many blocks. SWITCHED: whether the
# kernel switches by time alone at one of the jumps
KERNEL, STATES, BLOCKS, CONTROLLED, ESTIMATED_BLOCKS, SWITCHED, BOUNDED = range(7)
# Progress.state
TIME, SIZE, LARGEST, LAST_ERROR, LAST_SIZE, GROWTH, FOUND = range(7)
# Progress.counts
STARTED, STEPS, REJECTED, EVALUATIONS, JACOBIANS, FACTORISATIONS = range(6)
NEXT, BUDGET, LIMIT, FAILURE, LOGGED, PROJECTIONS = range(6, 12)
# Constraints.words; SCRATCH, TANGENTS: addresses of the tables of these; POSITIONS, MOTIONS: ranks
# of ∂h/∂q and ∂v/∂u, where rows may be more; JUDGED: whether a step may be rejected where it ends.
ACTIVE, PROJECTOR, HOLONOMIC, VELOCITY, COORDINATES, SPEEDS, WEIGHTED, PROJECT = range(8)
SCRATCH, TANGENTS, POSITIONS, MOTIONS, JUDGED = range(8, 13)
# Constraints.values, from where the kernel's end: the rank of ∂v/∂u so far, and the step at which
# it was nearest to losing it; LATEST is how near it was at the latest projection.
RANK, NEARNESS, LATEST, WHEN, WHERE = range(5)
# Tangents.words: the address of the projection of the state, the kernel, and the number of columns.
OF_STATE, DIRECTIONS, COUNT = range(3)
# Watch.words
# REACHER tells how far events may come in a step, or is 0; then follow the place in Watch.reach of
# how far the first state does, and the number of these. ACT is the address of what acts on events,
# or 0, with the kernels of their rates and resets.
WATCHER, EVENTS, SCAN, REACHER, MOVES, MOVING, ACT, RATER, RESETTER = range(9)
# Watch.kinds
# added up: RESETS and STOPS where nothing else is to be done
LINEAR, TURNS, RESETS, STOPS, REDIRECTS = 1, 2, 4, 8, 16
# The parts in which a step is looked at, and the rows of `Watch.values`: their ends and middles,
# and two more
PARTS = 4
PROBES = 2 * PARTS + 3
# Steps.words: the number of steps that are kept, and for how many rows there is room, 0 for none
KEPT, ROOM = range(2)
# Newton.words: the Jacobian's kernel, or 0 for differences; a bit for each lane, whether a new
# Jacobian is wanted, the one there is that of the present state, the factors there are its own,
# and no step has been accepted since the last rejected one; and the number of columns of
# sensitivities.
GRADIENT, WANTED, FRESH, FACTORISED, FIRST, COUNTED = range(6)
# Newton.sizes: the step sizes of the factors, of the polynomial that predicts the next stages, and
# of the last accepted step, and its error.
FACTORED, PREDICTING, SIZE_BEFORE, ERROR_BEFORE = range(4)

# What `advance` returns while it has not ended; an `Outcome` when it has.
PAUSED, EVENT, LOG_FULL, CALLBACK, STEPS_FULL, UNRESOLVED = range(-1, -7, -1)
# What `act_on_event` returns, besides EVENTS_ACCUMULATE: nothing is done, or all.
LEFT, ACTED = range(2)
# How many numbers stand before the constants of a Kernel that is reflected in time: the place of
# its address, and how many outputs change their sign.
REFLECTED = 8
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

    @property
    def depth(self) -> int:
        """The number of coefficient vectors of the interpolant."""
        return int(self.shape[DEPTH])

    @property
    def exponent(self) -> float:
        """The exponent of the error in step-size control without memory."""
        return float(self.control[EXPONENT])

    @property
    def alpha(self) -> float:
        """The exponent of the latest error in the PI controller."""
        return float(self.control[ALPHA])

    @property
    def beta(self) -> float:
        """The exponent of the previous error in the PI controller."""
        return float(self.control[BETA])


class Problem(NamedTuple):
    """The right-hand side ``x' = f(t, x; r(t), c)``."""

    words: Words
    clock: Numbers  # (1,): the kernel's t
    r: Numbers
    c: Numbers
    tables: WordRows  # (k, 4): place in r, first knot, number of knots, last interval
    knots: Numbers
    cubics: NumberRows  # (·, 4): from each knot on, lowest power first
    # (k, 3): when inputs jump or the kernel switches, the last time before that at which it is
    # certain not to have switched, and the first one from then on at which it has
    jumps: NumberRows
    until: Numbers  # (1,): the inputs are those of this time at the latest


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
    # of several trajectories those of components whose error is bounded are blocks, as states are
    atol: Numbers


class Progress(NamedTuple):
    """Where the integration stands."""

    state: Numbers
    counts: Words
    times: Numbers


class Constraints(NamedTuple):
    """The constraints for the projection, which is off if ``words[ACTIVE]`` is 0."""

    words: Words
    c: Numbers
    # residuals (h), (v); ∂h/∂q (h, q); N (q, u); ∂v/∂u (v, u); M (u, u); rounding bounds (h);
    # then what the projection notes: `RANK` and so on, a state, the longest that rows were (v)
    values: Numbers


class Projection(NamedTuple):
    """Scratch memory of the projection of h holonomic and v velocity constraints."""

    factor: NumberRows  # (u, u)
    kinematics: NumberRows  # (q, u)
    gradient: NumberRows  # (h, q)
    holonomic: NumberRows  # (h, u)
    velocity: NumberRows  # (v, u)
    step: Numbers  # (u,) or (q,), whichever is more
    # h or v, whichever is more
    right: Numbers
    scale: Numbers
    lengths: Numbers
    kept: Numbers
    mended: Numbers  # the largest residuals that the first correction of positions can mend
    best: Numbers  # the row that is taken next: as `step`


class Tangents(NamedTuple):
    """The arrays for the projection of sensitivities."""

    words: Words
    c: Numbers
    # The derivatives of the holonomic, then of the velocity residuals, row after row.
    values: Numbers


class Watch(NamedTuple):
    """The events: their values, signs and records."""

    words: Words
    c: Numbers
    directions: Words  # −1, 1, or 0 for both
    acting: Words  # whether the integration stops there
    # LINEAR in states and time; TURNS: where the one before it is lowest; RESETS, and goes on;
    # REDIRECTS: a reset changes the event's own rate
    kinds: Words
    # What the kernel that tells how far events may come takes as r: specifieds, which it does not
    # read, how far each state may come, and the time; and a block more.
    reach: Numbers
    reach_c: Numbers
    sides: Words  # the sign last seen, 0 before there was one
    fired: Words
    values: Numbers  # (PROBES, events), then the time that the last step's end is known at
    rests: Numbers  # (events, 2): from when to when each was seen to be zero; NaN at first
    trial: Numbers  # a state
    log_times: Numbers
    log_events: Words
    log_states: NumberRows  # (·, states)
    log_after: NumberRows
    # Of events that act without Python: constants of the kernels, what they give, and when each
    # has happened.
    rates_c: Numbers
    resets_c: Numbers
    told: Numbers
    after: NumberRows  # (events, states)
    latest: NumberRows  # (events, CROWD): the latest first, those that never were -infinity


class Beginning(NamedTuple):
    """The initial content of `Progress`."""

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
    """The arrays of an implicit step; complex numbers are pairs of items."""

    words: Words
    sizes: Numbers
    c: Numbers
    jacobian: Numbers  # (n, n), row after row, of the states without their sensitivities
    latest: Numbers  # (n, n): of all lanes, where some take it
    real: Numbers  # (n, n)
    pair: Numbers  # (n, n)
    real_order: Numbers
    pair_order: Numbers
    stages: Numbers  # (3, n), here and below with sensitivities: z, the stages less the state
    waves: Numbers  # (3, n): w, the same transformed
    slopes: Numbers  # (3, n)
    last: Numbers  # (4, n): state and interpolant of the step before
    real_change: Numbers  # (n,): the right-hand side and the solution of a system
    pair_change: Numbers  # (n,)
    guess: Numbers  # (n,)


# The tables' parts, in their order; `Newton` is there for the implicit method only.
RUN = (Method, Problem, Memory, Progress, Constraints, Watch, Beginning, Steps, Newton)
EXTENSION = (Wanted,)
PROJECTION = (Projection,)
ALONG = (Tangents,)


# -- Many trajectories at a time -------------------------------------------------------------------
# Everything that belongs to one of eight trajectories has its own place in a block. Vectors are
# laid out ``[item][lane]``, item by item a block, as kernels of eight lanes take them, and stages
# one vector after the other; so `Memory` serves with a length of eight times the number of states,
# and `Memory.step` holds a step size for each lane.

# LaneProblem.words begins with those of `Problem`, which code for both reads: here every state is a
# block.
LANES_SPECIFIEDS, LANES_CONSTANTS = range(7, 9)
# Queue.state
LANES_HEAD, LANES_BUDGET, LANES_LIMIT, LANES_PLACE, LANES_DISTANCE = range(5)
# Queue.numbers
LANES_LARGEST, LANES_FIRST = range(2)
# Queue.counts, for each sample; the last is an `Outcome`
LANES_STEPS, LANES_REJECTED, LANES_EVALUATIONS, LANES_STATUS = range(4)
# LaneWatch.words begins with those of `Watch`; then how many lines the log has
LANES_LOGGED = RESETTER + 1
# Evaluation.places: the address of the first state, and the distances from state to state, from
# sample to sample and from time to time
LANES_ORIGIN, LANES_PER_STATE, LANES_PER_SAMPLE, LANES_PER_TIME = range(4)

# What `step_lanes` returns.
LANES_PAUSED, LANES_EMPTY = range(2)
# Lanes.samples, where there is no sample: free to take one, or repeating a neighbour's.
LANES_VACANT, LANES_RESTING = -1, -2


class LaneProblem(NamedTuple):
    """The right-hand side, each lane with its own time, specifieds and constants."""

    words: Words
    clock: Numbers
    r: Numbers
    p: Numbers
    c: Numbers
    # (kernels, 2): what prepares the constants of all kernels that lanes share, and where these lie
    prepared: WordRows
    tables: WordRows  # (k, 3): place in r, first knot, number of knots; for all lanes
    intervals: WordRows  # (k, lanes): where each lane found itself last
    knots: Numbers
    cubics: NumberRows
    jumps: NumberRows
    until: Numbers


class Lanes(NamedTuple):
    """The state of each lane's trajectory: blocks of floats, counts too, except the last two."""

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
    """The samples and their outcomes.

    Output k of state i of sample j goes to the address
    ``state[LANES_PLACE] + 8 (i state[LANES_DISTANCE] + j number + k)``, where `number` is that of
    times.
    """

    state: Words
    numbers: Numbers
    times: Numbers  # and infinity
    x: NumberRows  # (m, states)
    r: NumberRows  # (m, specifieds)
    p: NumberRows  # (m, constants)
    bounds: NumberRows  # (m, ·): the absolute tolerances of components whose error is bounded
    counts: WordRows  # (m, 4)
    reached: Numbers  # (m,): the time up to which the sample was integrated
    seen: NumberRows  # (m, ·): what ends `Constraints.values`, first at the beginning


class Alone(NamedTuple):
    """What lanes do one after another; nothing without `runs`."""

    runs: Words  # (lanes,): addresses of tables of one trajectory, with inputs of their own
    # (kernels, 1 + lanes): addresses of what prepares constants, and of those of each lane
    prepared: WordRows


class LaneWatch(NamedTuple):
    """The events of all lanes; in vectors each has a block of its own."""

    words: Words
    c: Numbers
    reach: Numbers
    reach_c: Numbers
    moving: Words  # the states that the kernel reads of `reach`
    ends: Numbers  # (PARTS + 1, events)
    further: Numbers  # (2, events)
    sides: Numbers
    known: Numbers  # one block: when the first row of `ends` was evaluated
    began: WordRows  # (m, events): of each sample the sides at the beginning, and then at the end
    first: NumberRows  # (m, events): what `Watch.latest` begins with
    rests: NumberRows  # (m, 2 events), at the end
    log_samples: Words
    log_times: Numbers
    log_events: Words
    log_states: NumberRows
    log_after: NumberRows


class Evaluation(NamedTuple):
    """States at which a kernel is evaluated, and where its results go."""

    places: Words
    x: Numbers
    buffer: Numbers  # of all outputs
    r: NumberRows  # (m, specifieds)
    p: NumberRows  # (m, constants)
    times: Numbers
    out: Numbers  # (outputs, m, times)


# The parts of the tables of `step_lanes` and `evaluate_lanes`; `Newton` as above.
STEPPING = (Method, LaneProblem, Memory, Lanes, Queue, Alone, LaneWatch, Constraints, Newton)
EVALUATION = (LaneProblem, Evaluation)


# -- Back through explicit steps -------------------------------------------------------------------

# Backward.words: the place in r of the weights, how many outputs of the kernel follow those by the
# states, how many of these, the last, are kept stage by stage, and the step whose equations could
# not be evaluated.
BACK_WEIGHTS, BACK_FURTHER, BACK_KEPT, BACK_WRONG = range(4)


class Backward(NamedTuple):
    """Explicit steps, and the arrays for going through them from the last to the first.

    The kernel gives the derivatives of Σ weight · rate by the states and by what else is wanted.
    Rows are those of the stages' weights, with places in `adjoints`, whose vectors are padded to
    whole blocks.
    """

    words: Words
    rows: Words  # where each row begins in the two arrays that follow
    offsets: Words
    coefficients: Numbers
    times: Numbers  # (steps,): where each begins
    sizes: Numbers  # (steps,)
    states: NumberRows  # (steps, n): at the beginning of each
    adjoints: Numbers  # of each stage's state; that of the state at the end of the step comes last
    out: Numbers
    totals: Numbers  # (further,): sums over all stages
    kept: NumberRows  # (steps · stages, kept)


# The parts of the second table of `step_back`; the first is that of a run of the steps.
BACK = (Problem, Backward)


# -- The table -------------------------------------------------------------------------------------


def rows_of(arrays: Iterable[np.ndarray]) -> list[int]:
    """Return the rows of contiguous arrays: address, length, and columns, of a vector one."""
    rows: list[int] = []
    for array in arrays:
        rows += (address(array), len(array), array.shape[1] if array.ndim == 2 else 1)
    return rows


def table_of(*parts: Sequence[int]) -> np.ndarray:
    """Return the table of all rows. Who makes it keeps the arrays alive."""
    return np.array([*chain.from_iterable(parts)], dtype=np.int64)
