"""The loop around explicit Runge–Kutta steps of eight trajectories at once.

Each lane has its own time, step size and outputs. A lane that has come to its end takes the next
sample from the queue at once; when there are no more, it repeats a neighbour's state, step size
zero. All arithmetic goes place by place, in an order that depends on nothing but the method: a
sample gives the same bits in any lane, beside any neighbours.
"""

from __future__ import annotations

import numpy as np

from pydy.solvers.lanes.kernels import copy_in, rates_of_lanes
from pydy.solvers.lanes.layout import (
    BUDGET,
    CONSTANTS,
    DISTANCE,
    EMPTY,
    EVALUATIONS,
    FIRST,
    HEAD,
    LARGEST,
    LIMIT,
    PAUSED,
    PLACE,
    PREPARE,
    REJECTED,
    RESTING,
    SPECIFIEDS,
    STATUS,
    STEPPING,
    STEPS,
    VACANT,
    LaneProblem,
    Lanes,
    Queue,
)
from pydy.solvers.loop.compiled import entry, inlined
from pydy.solvers.loop.control import (
    first_size,
    first_trial,
    limited,
    moves,
    next_size,
    shorter_size,
    usable,
    whole_steps,
)
from pydy.solvers.loop.entrance import opening
from pydy.solvers.loop.intrinsics import address_of, call_prepare, lowest_bit, nested, put
from pydy.solvers.loop.runge_kutta import combine_row, error_of_step, set_interpolant
from pydy.solvers.loop.vectors import (
    absolute,
    bits,
    gather,
    load,
    mask_of,
    maximum,
    minimum,
    splat,
    store,
    where,
)
from pydy.solvers.outcome import FINISHED, NOT_FINITE, SINGULAR, STEP_UNDERFLOW, TOO_MANY_STEPS
from pydy.solvers.run.layout import (
    CONTROLLED,
    DENSE_STAGES,
    DEPTH,
    END_IN_ESTIMATE,
    ESTIMATES,
    GROW,
    STAGES,
    STATES,
    Memory,
    Method,
)
from pydy.solvers.tuning import FIRST_ERROR, LANES, SLIVER

__all__ = ["step_lanes"]


# -- samples come and go --------------------------------------------------------------------------


@inlined(always=True)
def _copy_over(buffer, items, source, target):
    """Copy one lane to another."""
    place = address_of(buffer, target)
    for i in range(items):
        put(place + 8 * LANES * i, buffer[i * LANES + source])


@inlined(always=True)
def _write(problem, lanes, queue, values, which):
    """Write a vector as the next output of the lanes named by `which`, and count it."""
    distance, n = 8 * queue.state[DISTANCE], problem.words[STATES]
    left = which
    while left != 0:
        lane = lowest_bit(left)
        left &= left - 1
        place = lanes.place[lane]
        lanes.place[lane] = place + 8
        for i in range(n):
            put(place, values[i * LANES + lane])
            place += distance
    following = load(lanes.next, 0) + where(mask_of(which), 1.0, 0.0)
    store(lanes.next, 0, following)
    store(lanes.due, 0, gather(queue.times, following))


@inlined(always=True)
def _retire(problem, lanes, queue, lane, status):
    """Write down how a lane's sample ended, and give the lane free."""
    sample, distance = lanes.samples[lane], 8 * queue.state[DISTANCE]
    for k in range(queue.times.size - 1 - np.int64(lanes.next[lane])):
        place = lanes.place[lane] + 8 * k
        for _ in range(problem.words[STATES]):
            put(place, np.nan)
            place += distance
    counts = queue.counts[sample]
    counts[STEPS], counts[REJECTED] = lanes.steps[lane], lanes.rejected[lane]
    counts[EVALUATIONS], counts[STATUS] = lanes.evaluations[lane], status
    queue.reached[sample] = lanes.time[lane]
    lanes.samples[lane] = VACANT


@inlined(always=True)
def _fill(problem, memory, lanes, queue):
    """Give vacant lanes the next samples; return the bits of these lanes and of all that work."""
    fresh = working = np.int64(0)
    example = -1
    for lane in range(LANES):
        if lanes.samples[lane] == VACANT and queue.state[HEAD] < len(queue.x):
            sample = queue.state[HEAD]
            queue.state[HEAD] += 1
            lanes.samples[lane] = sample
            copy_in(queue.x, sample, memory.x, lane)
            copy_in(queue.r, sample, problem.r, lane)
            copy_in(queue.p, sample, problem.p, lane)
            lanes.time[lane] = queue.times[0]
            fresh |= np.int64(1) << lane
        if lanes.samples[lane] >= 0:
            working |= np.int64(1) << lane
            example = lane
    if example >= 0:
        for lane in range(LANES):
            if lanes.samples[lane] == VACANT:
                _copy_over(memory.x, problem.words[STATES], example, lane)
                _copy_over(memory.stages, problem.words[STATES], example, lane)
                _copy_over(problem.r, problem.words[SPECIFIEDS], example, lane)
                _copy_over(problem.p, problem.words[CONSTANTS], example, lane)
                lanes.time[lane], lanes.size[lane] = lanes.time[example], 0.0
                lanes.due[lane], lanes.samples[lane] = np.inf, RESTING
        call_prepare(problem.words[PREPARE], address_of(problem.p, 0), address_of(problem.c, 0))
    return fresh, working


@inlined(always=True)
def _first_size(method, problem, memory, largest, t):
    """Guess the first step, with one further evaluation."""
    n, length = problem.words[STATES], memory.x.size
    controlled = problem.words[CONTROLLED]
    trial, slope = first_trial(memory, controlled, largest, t)
    for i in range(n):
        store(memory.trial, i, load(memory.x, i) + trial * load(memory.stages, i))
    out = address_of(memory.stages, length)
    failed = rates_of_lanes(problem, t + trial, address_of(memory.trial, 0), out)
    size = first_size(method, memory, controlled, t, largest, trial, slope)
    return where(mask_of(failed), SLIVER * trial, size)


@inlined(always=True)
def _start(method, problem, memory, lanes, queue, fresh):
    """Begin with the samples that lanes have just taken."""
    n, times = problem.words[STATES], queue.times
    new, t = mask_of(fresh), load(lanes.time, 0)
    failed = (
        rates_of_lanes(problem, t, address_of(memory.x, 0), address_of(memory.trial, 0)) & fresh
    )
    for i in range(n):
        store(memory.stages, i, where(new, load(memory.trial, i), load(memory.stages, i)))
    evaluations = 1.0
    size = splat(queue.numbers[FIRST])
    if queue.numbers[FIRST] == 0.0:
        evaluations = 2.0
        size = _first_size(method, problem, memory, queue.numbers[LARGEST], t)
    store(lanes.size, 0, where(new, size, load(lanes.size, 0)))
    store(lanes.last_error, 0, where(new, FIRST_ERROR, load(lanes.last_error, 0)))
    store(lanes.growth, 0, where(new, method.control[GROW], load(lanes.growth, 0)))
    store(lanes.steps, 0, where(new, 0.0, load(lanes.steps, 0)))
    store(lanes.rejected, 0, where(new, 0.0, load(lanes.rejected, 0)))
    store(lanes.evaluations, 0, where(new, evaluations, load(lanes.evaluations, 0)))
    reason = where(usable(size), float(STEP_UNDERFLOW), float(NOT_FINITE))
    store(lanes.reason, 0, where(new, reason, load(lanes.reason, 0)))
    for lane in range(LANES):
        if (fresh >> lane) & 1 == 1:
            lanes.next[lane], lanes.due[lane] = 0.0, times[0]
            first = lanes.samples[lane] * (times.size - 1)
            lanes.place[lane] = queue.state[PLACE] + 8 * first
    well = fresh & ~failed
    while well != 0:  # the first time may be asked for more than once
        _write(problem, lanes, queue, memory.x, well)
        well &= bits(load(lanes.due, 0) == times[0])
    for lane in range(LANES):
        if (failed >> lane) & 1 == 1:
            _retire(problem, lanes, queue, lane, SINGULAR)
        elif (fresh >> lane) & 1 == 1 and lanes.due[lane] == np.inf:
            _retire(problem, lanes, queue, lane, FINISHED)


@inlined(always=True)
def _retire_some(problem, lanes, queue, which, tired):
    for lane in range(LANES):
        if (which >> lane) & 1 == 1:
            stuck = (tired >> lane) & 1 == 0
            status = np.int64(lanes.reason[lane]) if stuck else TOO_MANY_STEPS
            _retire(problem, lanes, queue, lane, status)


# -- one step -------------------------------------------------------------------------------------


@inlined(always=True)
def _take_step(method, problem, memory, t, size):
    """Compute ``memory.new``; return the bits of the lanes whose solve failed."""
    length = memory.x.size
    x, trial = address_of(memory.x, 0), address_of(memory.trial, 0)
    store(memory.step, 0, size)
    failed = np.int64(0)
    for stage in range(1, method.shape[STAGES]):
        combine_row(method, problem, memory, stage, trial, x)
        out = address_of(memory.stages, stage * length)
        failed |= rates_of_lanes(problem, t + method.nodes[stage] * size, trial, out)
    combine_row(method, problem, memory, method.shape[STAGES], address_of(memory.new, 0), x)
    return failed


@inlined(always=True)
def _prepare_interpolant(method, problem, memory, t, size):
    """Compute ``memory.interpolant``; return the bits of the lanes whose solve failed."""
    length, stages = memory.x.size, method.shape[STAGES]
    x, trial = address_of(memory.x, 0), address_of(memory.trial, 0)
    failed = np.int64(0)
    for k in range(stages + 1, stages + 1 + method.shape[DENSE_STAGES]):
        combine_row(method, problem, memory, k + method.shape[ESTIMATES], trial, x)
        out = address_of(memory.stages, k * length)
        failed |= rates_of_lanes(problem, t + method.nodes[k] * size, trial, out)
    set_interpolant(method, problem, memory, size)
    return failed


@inlined(always=True)
def _write_outputs(method, problem, memory, lanes, queue, within, end):
    """Write the outputs due within the step of the lanes named by `within`, in turns."""
    t, size = load(lanes.time, 0), load(memory.step, 0)
    left = within
    while left != 0:
        store(memory.theta, 0, (load(lanes.due, 0) - t) / size)
        nested(
            address_of(memory.trial, 0),
            address_of(memory.x, 0),
            address_of(memory.interpolant, 0),
            memory.x.size,
            method.shape[DEPTH],
            address_of(memory.theta, 0),
            problem.words[STATES],
        )
        _write(problem, lanes, queue, memory.trial, left)
        left &= bits(load(lanes.due, 0) < end)


_opened_method, _opened_memory = opening(STEPPING, Method), opening(STEPPING, Memory)
_opened_problem, _opened_lanes = opening(STEPPING, LaneProblem), opening(STEPPING, Lanes)
_opened_queue = opening(STEPPING, Queue)


@entry("int64(int64)")
def step_lanes(table):
    """Step until the queue is empty, or ``BUDGET`` steps are taken."""
    method, problem, memory = _opened_method(table), _opened_problem(table), _opened_memory(table)
    lanes, queue = _opened_lanes(table), _opened_queue(table)
    n, shape = problem.words[STATES], method.shape
    length, state = memory.x.size, queue.state
    last, largest = queue.times[queue.times.size - 2], queue.numbers[LARGEST]
    end = address_of(memory.stages, shape[STAGES] * length)
    end_block, adaptive = shape[STAGES] * n, shape[ESTIMATES] > 0
    reuse_end = shape[END_IN_ESTIMATE] == 1
    per_step = float(shape[STAGES] - 1 + shape[END_IN_ESTIMATE])
    per_success = float(1 - shape[END_IN_ESTIMATE])
    limit = float(state[LIMIT])
    working = np.int64(0)
    for lane in range(LANES):
        if lanes.samples[lane] >= 0:
            working |= np.int64(1) << lane
    vacant = True
    while True:
        while vacant:
            fresh, working = _fill(problem, memory, lanes, queue)
            if working == 0:
                return EMPTY
            if fresh == 0:
                break
            _start(method, problem, memory, lanes, queue, fresh)
            vacant = False
            for lane in range(LANES):
                vacant = vacant or lanes.samples[lane] == VACANT
        if state[BUDGET] <= 0:
            return PAUSED
        state[BUDGET] -= 1

        t, h, goal, active = load(lanes.time, 0), load(lanes.size, 0), splat(last), mask_of(working)
        if adaptive:
            size = minimum(h, largest)
        else:  # whole steps between outputs
            goal = load(lanes.due, 0)
            size = whole_steps(t, h, goal)
        size, after = limited(t, size, goal)
        size = where(active, size, 0.0)
        going = moves(t, size, after, goal)
        tired = load(lanes.steps, 0) + load(lanes.rejected, 0) >= limit
        stopped = bits((tired | ~going) & active)
        if stopped != 0:
            _retire_some(problem, lanes, queue, stopped, bits(tired))
            vacant = True
            continue

        failed = _take_step(method, problem, memory, t, size)
        if reuse_end:
            failed |= rates_of_lanes(problem, after, address_of(memory.new, 0), end)
        error = splat(0.0)
        if adaptive:
            error = error_of_step(method, problem, memory, t)
        else:
            for i in range(n):
                error = error + 0.0 * load(memory.new, i)  # NaN where the state is not finite
        good = active & (error < 1.0) & ~mask_of(failed)
        tried = good
        if not reuse_end and bits(good) != 0:
            failed |= rates_of_lanes(problem, after, address_of(memory.new, 0), end)
            good = good & ~mask_of(failed)
        evaluations = load(lanes.evaluations, 0) + per_step + where(tried, per_success, 0.0)
        store(lanes.evaluations, 0, evaluations)

        due = load(lanes.due, 0)
        within = good & (due < after)
        if bits(within) != 0:
            broken = _prepare_interpolant(method, problem, memory, t, size) & bits(within)
            extra = where(within, float(shape[DENSE_STAGES]), 0.0)
            store(lanes.evaluations, 0, load(lanes.evaluations, 0) + extra)
            if broken != 0:
                for lane in range(LANES):
                    if (broken >> lane) & 1 == 1:
                        _retire(problem, lanes, queue, lane, SINGULAR)
                working &= ~broken
                vacant = True
                good = good & mask_of(working)
                within = within & good
            _write_outputs(method, problem, memory, lanes, queue, bits(within), after)
        at_end = bits(good & (load(lanes.due, 0) == after))
        while at_end != 0:
            _write(problem, lanes, queue, memory.new, at_end)
            at_end &= bits(load(lanes.due, 0) == after)

        bad = active & ~good
        store(lanes.steps, 0, load(lanes.steps, 0) + where(good, 1.0, 0.0))
        if adaptive:
            before = load(lanes.last_error, 0)
            h = next_size(method, size, error, before, load(lanes.growth, 0))
            store(lanes.last_error, 0, where(good, maximum(error, FIRST_ERROR), before))
            store(lanes.growth, 0, where(bad, 1.0, method.control[GROW]))
        if bits(bad) != 0:
            singular = mask_of(failed)
            measured = (absolute(error) < np.inf) & ~singular
            shorter = shorter_size(method, size, error, measured)
            if not adaptive:
                shorter = splat(0.0)  # a step that fails cannot be helped
            h = where(bad, shorter, h)
            reason = where(measured, float(STEP_UNDERFLOW), float(NOT_FINITE))
            reason = where(singular, float(SINGULAR), reason)
            store(lanes.reason, 0, where(bad, reason, load(lanes.reason, 0)))
            store(lanes.rejected, 0, load(lanes.rejected, 0) + where(bad, 1.0, 0.0))
        store(lanes.size, 0, h)
        store(lanes.time, 0, where(good, after, t))
        for i in range(n):
            store(memory.x, i, where(good, load(memory.new, i), load(memory.x, i)))
            start = where(good, load(memory.stages, end_block + i), load(memory.stages, i))
            store(memory.stages, i, start)
        finished = bits(good & (load(lanes.due, 0) == np.inf))
        if finished != 0:
            for lane in range(LANES):
                if (finished >> lane) & 1 == 1:
                    _retire(problem, lanes, queue, lane, FINISHED)
            vacant = True
