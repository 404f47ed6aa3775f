"""The arrays of compiled solvers, and names of the elements of arrays with mixed content.

All arrays of a run are passed to compiled code as one table of addresses, its only argument. A
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
# Kernels are given by address slots: addresses of arrays that begin with the address of the Kernel.
# Problem.words. The error of the first CONTROLLED components is controlled, that of the others up
# to BOUNDED only bounds the step (0: of none); it is estimated in ESTIMATED_BLOCKS blocks.
# SWITCHED: whether the kernel switches by time alone at one of the jumps
KERNEL, STATES, BLOCKS, CONTROLLED, ESTIMATED_BLOCKS, SWITCHED, BOUNDED = range(7)
# Progress.state
TIME, SIZE, LARGEST, LAST_ERROR, LAST_SIZE, GROWTH, FOUND = range(7)
# Progress.counts
STARTED, STEPS, REJECTED, EVALUATIONS, JACOBIANS, FACTORISATIONS = range(6)
NEXT, BUDGET, LIMIT, FAILURE, LOGGED, PROJECTIONS = range(6, 12)
# Constraints.words. SCRATCH, TANGENTS: addresses of the tables of these; POSITIONS, MOTIONS: ranks
# of ∂h/∂q and ∂v/∂u, which may have more rows; JUDGED: whether a step may be rejected because of
# the residuals at its end.
ACTIVE, PROJECTOR, HOLONOMIC, VELOCITY, COORDINATES, SPEEDS, WEIGHTED, PROJECT = range(8)
SCRATCH, TANGENTS, POSITIONS, MOTIONS, JUDGED = range(8, 13)
# Constraints.values, after those of the kernel: the largest rank of ∂v/∂u so far, the smallest
# nearness to its loss, with its time and state; LATEST is the nearness at the latest projection.
RANK, NEARNESS, LATEST, WHEN, WHERE = range(5)
# Tangents.words: the address of the projection of the state, the kernel, and the number of columns.
OF_STATE, DIRECTIONS, COUNT = range(3)
# Watch.words
# REACHER: the kernel of bounds on the events in a step, or 0; then the index in Watch.reach of the
# bound on the first state, and the number of such bounds. ACT: the address of the function that
# acts on events, or 0; then the kernels of their rates and resets.
WATCHER, EVENTS, SCAN, REACHER, MOVES, MOVING, ACT, RATER, RESETTER = range(9)
# Watch.kinds
# The sum of these; RESETS or STOPS if the event does only this.
LINEAR, TURNS, RESETS, STOPS, REDIRECTS, DRIVEN = 1, 2, 4, 8, 16, 32
# Events are evaluated at these fractions of a step. Their ratios are irrational, so that no
# oscillation looks slow at all of them.
SCAN_POINTS = (0.0, 0.2360679774997897, 0.4494897427831781, 0.7320508075688772, 1.0)
# The number of parts between them, and of rows of `Watch.values`: the ends and middles of these
# parts, and two more.
PARTS = len(SCAN_POINTS) - 1
PROBES = 2 * PARTS + 3
# Steps.words: the number of recorded steps, and of allocated rows (0: no recording).
KEPT, ROOM = range(2)
# Newton.words: the Jacobian's kernel, or 0 for differences; then words with a bit for each lane: a
# new Jacobian is needed, the Jacobian is that of the present state, the factors are those of the
# Jacobian, no step has been accepted since the last rejected one; and the number of columns of
# sensitivities.
GRADIENT, WANTED, FRESH, FACTORISED, FIRST, COUNTED = range(6)
# Newton.sizes: the step sizes of the factors, of the polynomial that predicts the next stages, and
# of the last accepted step, and its error.
FACTORED, PREDICTING, SIZE_BEFORE, ERROR_BEFORE = range(4)

# What `advance` returns before the end; at the end it returns an `Outcome`.
PAUSED, EVENT, LOG_FULL, CALLBACK, STEPS_FULL, UNRESOLVED = range(-1, -7, -1)
# What it returns at a start or end where events may happen, which Python then looks at.
START_EVENTS, END_EVENTS = -7, -8
# What `act_on_event` returns, besides EVENTS_ACCUMULATE: nothing was done, or everything.
LEFT, ACTED = range(2)
# The number of items before the constants of a Kernel that is reflected in time. The first two are
# its address slot, and the number of outputs that change their sign.
REFLECTED = 8
# Progress.counts[FAILURE] is the `Outcome` of the last rejected step.


class Method(NamedTuple):
    """A tableau as arrays.

    Rows are stages of the step, weights, estimates of the error, stages of the interpolant, and
    the interpolant, in this order; `offsets` are indices in ``Memory.stages``.
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


class Problem(NamedTuple):
    """The right-hand side ``x' = f(t, x; r(t), c)``."""

    words: Words
    clock: Numbers  # (1,): the kernel's t
    r: Numbers
    c: Numbers
    tables: WordRows  # (k, 4): index in r, first knot, number of knots, last interval
    knots: Numbers
    cubics: NumberRows  # (·, 4): from each knot on, lowest power first
    # (k, 3): the time of a jump of inputs or a switch of the kernel, the last time before it at
    # which the kernel has certainly not switched, and the first time from it at which it has
    jumps: NumberRows
    until: Numbers  # (1,): inputs are evaluated at this time at the latest


class Memory(NamedTuple):
    """The vectors of one trajectory, padded with zeros to whole blocks."""

    x: Numbers
    new: Numbers
    trial: Numbers
    step: Numbers  # the step size, repeated over a block
    theta: Numbers  # a fraction of the step, repeated too
    zero: Numbers
    errors: Numbers  # two vectors, one after the other
    stages: Numbers  # vectors
    interpolant: Numbers  # vectors
    rtol: Numbers
    # In lanes, components whose error bounds the step have a block each, like states.
    atol: Numbers


class Progress(NamedTuple):
    """The progress of the integration."""

    state: Numbers
    counts: Words
    times: Numbers


class Constraints(NamedTuple):
    """The constraints for the projection, which is off if ``words[ACTIVE]`` is 0."""

    words: Words
    c: Numbers
    # residuals (h), (v); ∂h/∂q (h, q); N (q, u); ∂v/∂u (v, u); M (u, u); rounding bounds (h);
    # then the record of the projection: `RANK` and so on, a state, the largest lengths of rows (v)
    values: Numbers


class Projection(NamedTuple):
    """Scratch memory of the projection of h holonomic and v velocity constraints."""

    factor: NumberRows  # (u, u)
    kinematics: NumberRows  # (q, u)
    gradient: NumberRows  # (h, q)
    holonomic: NumberRows  # (h, u)
    velocity: NumberRows  # (v, u)
    step: Numbers  # (max(q, u),)
    # of length max(h, v)
    right: Numbers
    scale: Numbers
    lengths: Numbers
    kept: Numbers
    mended: Numbers  # the largest residuals that the first correction can remove
    best: Numbers  # the next pivot row, of the length of `step`


class Tangents(NamedTuple):
    """The arrays for the projection of sensitivities."""

    words: Words
    c: Numbers
    # The derivatives of the holonomic, then of the velocity residuals, row by row.
    values: Numbers


class Watch(NamedTuple):
    """The events: their values, signs and records."""

    words: Words
    c: Numbers
    directions: Words  # −1, 1, or 0 for both
    acting: Words  # whether the integration stops there
    # LINEAR in states and time; TURNS: at a minimum of the previous event; RESETS without stopping;
    # REDIRECTS: a reset changes the event's own rate; DRIVEN: inputs that vary may move its surface
    kinds: Words
    # The inputs r of REACHER: specifieds, which it does not read, a bound on each state, and the
    # time; then a further block.
    reach: Numbers
    reach_c: Numbers
    sides: Words  # the latest sign, 0 before the first one
    fired: Words  # 1: happens; −1: moves to its side, where it has not been since it happened
    values: Numbers  # (PROBES, events), then the time for which the end of the step is known
    rests: Numbers  # (events, 2): the interval in which each was zero; NaN at first
    trial: Numbers  # a state
    log_times: Numbers
    log_events: Words
    log_states: NumberRows  # (·, states)
    log_after: NumberRows
    # Constants and outputs of the kernels of rates and resets, and the times of events that act
    # without Python.
    rates_c: Numbers
    resets_c: Numbers
    told: Numbers
    after: NumberRows  # (events, states)
    latest: NumberRows  # (events, CROWD): the latest first; -infinity before the first one


class Beginning(NamedTuple):
    """The initial content of `Progress`."""

    state: Numbers
    counts: Words


class Steps(NamedTuple):
    """The accepted steps, a row each: time, size and state.

    The implicit method adds its interpolant. The last row is that of the end, with size 0.
    """

    words: Words
    rows: NumberRows


class Wanted(NamedTuple):
    """Times at which the dense output is requested."""

    rows: NumberRows  # those of `Steps`
    times: Numbers
    places: Words  # the row of each time
    out: Numbers  # the states, and a further block


class Newton(NamedTuple):
    """The arrays of an implicit step; complex numbers are pairs of items."""

    words: Words
    sizes: Numbers
    c: Numbers
    jacobian: Numbers  # (n, n), by rows, of the states without their sensitivities
    latest: Numbers  # (n, n): of all lanes, before some of them use it
    real: Numbers  # (n, n)
    pair: Numbers  # (n, n)
    real_order: Numbers
    pair_order: Numbers
    stages: Numbers  # (3, n), here and below with sensitivities: z, the stages less the state
    waves: Numbers  # (3, n): w, the same transformed
    slopes: Numbers  # (3, n)
    last: Numbers  # (4, n): state and interpolant of the previous step
    real_change: Numbers  # (n,): the right-hand side and the solution of a system
    pair_change: Numbers  # (n,)
    guess: Numbers  # (n,)


# The parts of the tables, in their order; `Newton` belongs to the implicit method only.
RUN = (Method, Problem, Memory, Progress, Constraints, Watch, Beginning, Steps, Newton)
EXTENSION = (Wanted,)
PROJECTION = (Projection,)
ALONG = (Tangents,)


# -- Many trajectories at a time -------------------------------------------------------------------
# Each of eight trajectories has one element of a block. Vectors are stored as ``[item][lane]``, a
# block for each item, as kernels of eight lanes read them, and stages one vector after the other:
# `Memory` is used with a length of eight times the number of states, and `Memory.step` has a step
# size for each lane.

# LaneProblem.words begins with those of `Problem`, for code that both use: here every state is a
# block.
LANES_SPECIFIEDS, LANES_CONSTANTS = range(7, 9)
# Queue.state
LANES_HEAD, LANES_BUDGET, LANES_LIMIT, LANES_PLACE, LANES_DISTANCE = range(5)
# Queue.numbers
LANES_LARGEST, LANES_FIRST = range(2)
# Queue.counts, for each sample; the last is an `Outcome`
LANES_STEPS, LANES_REJECTED, LANES_EVALUATIONS, LANES_STATUS = range(4)
# LaneWatch.words begins with those of `Watch`; then follows the number of lines in the log
LANES_LOGGED = RESETTER + 1
# Evaluation.places: the address of the first state, and the distances from state to state, from
# sample to sample and from time to time
LANES_ORIGIN, LANES_PER_STATE, LANES_PER_SAMPLE, LANES_PER_TIME = range(4)

# What `step_lanes` returns.
LANES_PAUSED, LANES_EMPTY = range(2)
# Lanes.samples without a sample: the lane is free, or repeats the sample of another lane.
LANES_VACANT, LANES_RESTING = -1, -2


class LaneProblem(NamedTuple):
    """The right-hand side, each lane with its own time, specifieds and constants."""

    words: Words
    clock: Numbers
    r: Numbers
    p: Numbers
    c: Numbers
    # (kernels, 2): addresses of the functions that prepare the shared constants, and of these
    prepared: WordRows
    tables: WordRows  # (k, 3): index in r, first knot, number of knots; for all lanes
    intervals: WordRows  # (k, lanes): the latest interval of each lane
    knots: Numbers
    cubics: NumberRows
    jumps: NumberRows
    until: Numbers


class Lanes(NamedTuple):
    """The state of each lane's trajectory: blocks of floats, even counts, except the last two."""

    time: Numbers
    size: Numbers
    last_error: Numbers
    growth: Numbers
    next: Numbers  # the number of the next output
    due: Numbers  # its time
    steps: Numbers
    rejected: Numbers
    evaluations: Numbers
    reason: Numbers  # the `Outcome` of the last rejected step
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
    seen: NumberRows  # (m, ·): the record of the projection, see `Constraints.values`


class Alone(NamedTuple):
    """Tables of single trajectories, for tasks that lanes do one at a time; empty if none."""

    runs: Words  # (lanes,): addresses of tables of one trajectory, each with its inputs
    # (kernels, 1 + lanes): addresses of the function that prepares constants, and of each lane's
    prepared: WordRows


class LaneWatch(NamedTuple):
    """The events of all lanes; in vectors each event has its own block."""

    words: Words
    c: Numbers
    reach: Numbers
    reach_c: Numbers
    moving: Words  # the states whose bounds in `reach` the kernel reads
    ends: Numbers  # (PARTS + 1, events)
    further: Numbers  # (2, events)
    sides: Numbers
    known: Numbers  # one block: the time at which the first row of `ends` was evaluated
    began: WordRows  # (m, events): the sides of each sample at the beginning, later at the end
    first: NumberRows  # (m, events): initial values of `Watch.latest`
    rests: NumberRows  # (m, 2 events), at the end
    log_samples: Words
    log_times: Numbers
    log_events: Words
    log_states: NumberRows
    log_after: NumberRows


class Evaluation(NamedTuple):
    """States at which a kernel is evaluated, and its results."""

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


# -- The adjoint of explicit steps -----------------------------------------------------------------

# Backward.words: the index of the weights in r, the number of outputs of the kernel after those by
# the states, how many of these, the last ones, are stored for each stage, and the step whose
# equations could not be evaluated.
BACK_WEIGHTS, BACK_FURTHER, BACK_KEPT, BACK_WRONG = range(4)


class Backward(NamedTuple):
    """Explicit steps, and the arrays of their adjoint, from the last step to the first.

    The kernel evaluates the derivatives of Σ weight · rate by the states and by further inputs.
    Rows are those of the stages' weights, with indices in `adjoints`, whose vectors are padded to
    whole blocks.
    """

    words: Words
    rows: Words  # where each row begins in the two arrays that follow
    offsets: Words
    coefficients: Numbers
    times: Numbers  # (steps,): initial times
    sizes: Numbers  # (steps,)
    states: NumberRows  # (steps, n): initial states
    adjoints: Numbers  # of each stage's state; that of the state at the end of the step comes last
    out: Numbers
    totals: Numbers  # (further,): sums over all stages
    kept: NumberRows  # (steps · stages, kept)


# The parts of the second table of `step_back`; the first is that of a run of the steps.
BACK = (Problem, Backward)


# -- The table -------------------------------------------------------------------------------------


def rows_of(arrays: Iterable[np.ndarray]) -> list[int]:
    """Return the rows of contiguous arrays: address, length and columns (of a vector, one)."""
    rows: list[int] = []
    for array in arrays:
        rows += (address(array), len(array), array.shape[1] if array.ndim == 2 else 1)
    return rows


def table_of(*parts: Sequence[int]) -> np.ndarray:
    """Return the table of all rows. The caller keeps the arrays alive."""
    return np.array([*chain.from_iterable(parts)], dtype=np.int64)
