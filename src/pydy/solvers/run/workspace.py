"""The arrays of an integration, which compiled code works on, and the table of their addresses."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import cache, partial
from typing import Any

import numpy as np

from pydy._array_layout import address
from pydy._interrupts import Interrupts
from pydy._kernel import Kernel, KernelCall
from pydy.solvers import layout as at
from pydy.solvers.constraints import CompiledConstraints
from pydy.solvers.events import CompiledEvents
from pydy.solvers.layout import (
    Beginning,
    Constraints,
    Memory,
    Method,
    Newton,
    Problem,
    Progress,
    Projection,
    Steps,
    Tangents,
    Watch,
    rows_of,
    table_of,
)
from pydy.solvers.options import Options
from pydy.solvers.outcome import Outcome
from pydy.solvers.run import shipped
from pydy.solvers.run.problem import (
    Bound,
    Callback,
    blocks,
    jumps_in,
    lined_up,
    problem_of,
    switching,
)
from pydy.solvers.sensitivities import CompiledSensitivities
from pydy.solvers.tableaus import IMPLICIT, method_arrays
from pydy.solvers.tuning import BLOCK, CROWD, LEAST_TOLERANCE, STEPS_MEMORY

_STEPS = 2**13  # numbers of kept steps between two visits in Python

# Compiled code neither reads nor writes these any further.
NO_CONSTRAINTS = Constraints(np.zeros(12, dtype=np.int64), np.zeros(1), np.zeros(1))
_NO_EVENTS = Watch(*[np.zeros(4)] * len(Watch._fields))
_NO_STEPS = Steps(np.zeros(2, dtype=np.int64), np.zeros((1, 1)))
_NO_CONSTRAINTS_ROWS, _NO_EVENTS_ROWS = rows_of(NO_CONSTRAINTS), rows_of(_NO_EVENTS)
_NO_STEPS_ROWS = rows_of(_NO_STEPS)


@cache
def _method(name: str, length: int) -> tuple[Method, list[int]]:
    """Return a method's arrays and their rows, together.

    Of two threads that come first at the same time one may get arrays that no cache keeps: it keeps
    them itself, and must not have rows that name others.
    """
    arrays = method_arrays(name, length)
    return arrays, rows_of(arrays)


def memory_for(method: Method, length: int) -> tuple[Memory, list[int]]:
    """Reserve a method's vectors of some length in one block of memory; return their rows too."""
    stages, depth = max(1, len(method.nodes)), method.depth
    counts = (1, 1, 1, 1, 1, 1, 2, stages, depth, 1, 1)
    flat = lined_up(sum(counts) * length)
    start, first = address(flat), 0
    vectors: list[np.ndarray] = []
    rows: list[int] = []
    for name, count in zip(Memory._fields, counts, strict=True):
        size = BLOCK if name in ("step", "theta") else count * length
        vectors.append(flat[first : first + size])
        rows += (start + 8 * first, size, 1)
        first += count * length
    return Memory(*vectors), rows


def seen_of(wanted: CompiledConstraints, n: int) -> int:
    """Return how many numbers the projection of n states notes."""
    return at.WHERE + n + wanted.velocity


def constraints_for(
    wanted: CompiledConstraints, entry: str, bound: tuple[int, np.ndarray], n: int, lanes: int = 1
) -> tuple[Constraints, tuple[Any, ...]]:
    """Return the arrays of the projection of n states, and others that the caller keeps.

    It is that of an `entry`, whose Kernel is `bound` to an address and constants.
    """
    h, v, q, u = wanted.holonomic, wanted.velocity, wanted.coordinates, wanted.speeds
    some, most = max(h, v) * lanes, max(q, u) * lanes
    scratch = Projection(
        factor=np.zeros((u, u * lanes)),
        kinematics=np.zeros((q, u * lanes)),
        gradient=np.zeros((h, q * lanes)),
        holonomic=np.zeros((h, u * lanes)),
        velocity=np.zeros((v, u * lanes)),
        step=np.zeros(most),
        right=np.zeros(some),
        scale=np.zeros(some),
        lengths=np.zeros(some),
        kept=np.zeros(some),
        mended=np.zeros(some),
        best=np.zeros(most),
    )
    table, words = table_of(rows_of(scratch)), np.zeros(13, dtype=np.int64)
    words[at.ACTIVE], words[at.PROJECT] = 1, shipped.address_of(entry)
    words[at.PROJECTOR], c = bound
    words[at.HOLONOMIC], words[at.VELOCITY], words[at.COORDINATES], words[at.SPEEDS] = h, v, q, u
    words[at.WEIGHTED], words[at.JUDGED] = wanted.weighted, wanted.judged
    words[at.POSITIONS], words[at.MOTIONS] = h - wanted.left_out[0], v - wanted.left_out[1]
    words[at.SCRATCH] = address(table)
    size = sum(b.stop - b.start for b in wanted.kernel.program.blocks)
    values = lined_up((size + seen_of(wanted, n)) * lanes)
    return Constraints(words, c, values), (scratch, table)


def newton_for(n: int, own: int, lanes: int = 1) -> Newton:
    """Reserve the arrays of an implicit step of n numbers, of which so many are states."""
    square, padded = own * own, BLOCK * blocks(n)  # estimates of errors are read in whole blocks
    matrices, stages = (square, square, square, 2 * square), [3 * n] * 3
    counts = (4, 1, *matrices, own, own, *stages, 4 * n, padded, 2 * n, n)
    return Newton(np.zeros(6, dtype=np.int64), *(lined_up(count * lanes) for count in counts))


class Workspace:
    """The arrays of one integration, reserved once for all its runs.

    Its parameters are those of `pydy.solvers.run.integration.Integration`, and the interrupts that
    callbacks look at. The `call` is None when `f` is a Python function alone; `seen` is the part of
    ``constraints.values`` that the projection notes something in, `beginning` is made of what
    `progress` is at the beginning of each run, and `place` is the address of the table.
    """

    def __init__(
        self,
        method: str,
        f: Callable[..., Any],
        n: int,
        times: np.ndarray,
        args: tuple[Any, ...],
        options: Options,
        interrupts: Interrupts | None = None,
    ) -> None:
        self.name, self.n, self.options = method, n, options
        self.interrupts = interrupts or Interrupts()
        self._f, self._args = f, args
        self.callbacks: list[Callback] = []
        self._bound: list[Bound] = []
        native = getattr(f, "native", None)
        self.call: KernelCall | None = None if native is None else native(args)
        if self.call is not None and self.call.switched is None:
            self.call = switching(self.call, times, options)
        self.problem = self._bind(f, args)
        beside = options.sensitivities
        if beside is not None and not beside.controlled:
            words = self.problem.words
            words[at.CONTROLLED], words[at.BOUNDED] = beside.states, n
        self.method, self.memory = self._reserve()
        self.seen = np.zeros(0)
        self.constraints = self._hold()
        self.watch = self._look_out()
        state, count = np.zeros(7), np.zeros(12, dtype=np.int64)
        state[at.TIME], state[at.LARGEST] = times[0], options.max_step
        state[at.SIZE] = options.first_step or options.step or 0.0
        count[at.LIMIT], count[at.FAILURE] = options.max_steps, Outcome.STEP_UNDERFLOW
        self.beginning = Beginning(state, count)
        self.progress = Progress(state.copy(), count.copy(), np.array(times, order="C"))
        self.steps = _NO_STEPS
        self.keeps = options.dense_output or options.recorded is not None
        if self.keeps:
            width = 2 + n * (1 + (3 if method == IMPLICIT else 0))
            room = 4 + _STEPS // width
            self.steps = Steps(np.array([0, room]), np.zeros((room, width)))
        self._aside: list[np.ndarray] = []
        self.twins: list[Workspace] = []  # what `Twin` has reserved, while no other has it
        self._further = self._reserve_newton() if method == IMPLICIT else []
        self._table = table_of(
            self._method_rows,
            rows_of(self.problem),
            self._memory_rows,
            rows_of(self.progress),
            _NO_CONSTRAINTS_ROWS if options.constraints is None else rows_of(self.constraints),
            _NO_EVENTS_ROWS if options.events is None else rows_of(self.watch),
            rows_of(self.beginning),
            rows_of(self.steps) if self.keeps else _NO_STEPS_ROWS,
            self._further,
        )
        self.place = address(self._table)

    def alone(self, lanes: int) -> tuple[list[np.ndarray], np.ndarray, np.ndarray]:
        """Return what `layout.Alone` needs of so many trajectories that share all but some arrays.

        Before that come the arrays that each has by itself, which the caller keeps.
        """
        tables, lane = np.tile(self._table, (lanes, 1)), np.arange(lanes)
        columns = {place: 3 * k for k, place in enumerate(self._table[::3].tolist())}
        own, places = [tables], {}
        watch = self.watch
        noted = (watch.sides, watch.fired, watch.values, watch.rests, watch.latest)
        log = (watch.log_times, watch.log_events, watch.log_states, watch.log_after)
        constants = (watch.c, watch.rates_c, watch.resets_c)
        for array in (self.problem.r, self.progress.counts, *noted, *log, *constants):
            if (place := columns.get(address(array))) is not None:
                own.append(array[None].repeat(lanes, axis=0))
                places[id(array)] = tables[:, place] = address(own[-1]) + array.nbytes * lane
        prepared = [[b.place + 8, *places[id(b.c)]] for b in self._bound if id(b.c) in places]
        runs = address(tables) + tables.strides[0] * lane
        return own, runs, np.array(prepared, dtype=np.int64).reshape(-1, 1 + lanes)

    def rebind(self, call: KernelCall | None, times: np.ndarray) -> bool:
        """Take other times and another call of the same Kernel, or return False.

        Compiled code reads the arrays anew at the beginning of each run.
        """
        before = self.call
        if (
            before is None
            or call is None
            or call.kernel is not before.kernel
            or ((call.sampled or before.sampled) and call.sampled is not before.sampled)
            or call.inputs is not None
            or len(times) != len(self.progress.times)
            or times.item(-1) < times.item(0)  # an integration backward is another one
            or self.callbacks
        ):
            return False
        if before.switched is not None:
            if call.switched is None:
                call = switching(call, times, self.options)
            jumps, words = jumps_in(call), self.problem.words
            if jumps.shape != self.problem.jumps.shape:
                return False
            self.problem.jumps[:] = jumps
            words[at.SWITCHED] = 0 if call.switched is None else len(call.switched)
        for bound in self._bound:
            bound.take(call.p)
        self.problem.r[: len(call.r)] = call.r
        self.progress.times[:] = times
        self.beginning.state[at.TIME] = times[0]
        self.call = call
        return True

    def retune(self, options: Options) -> bool:
        """Take other tolerances, step sizes and numbers of steps, or return False."""
        before = self.options
        kept = ("events", "constraints", "sensitivities", "recorded", "progress", "dense_output")
        if options.sensitivities is not None or any(
            getattr(options, name) is not getattr(before, name) for name in kept
        ):
            return False
        self.options = options
        self._set_tolerances(self.memory)
        state, count = self.beginning
        state[at.LARGEST], state[at.SIZE] = (
            options.max_step,
            options.first_step or options.step or 0.0,
        )
        count[at.LIMIT] = options.max_steps
        return True

    def forget_steps(self) -> None:
        """Begin with no kept steps, and room for them."""
        words, rows = self.steps
        self._aside, words[at.KEPT], words[at.ROOM] = [], 0, len(rows)

    def put_steps_aside(self) -> None:
        """Make room for further steps, or keep none where they need too much memory."""
        words, rows = self.steps
        self._aside.append(rows[: words[at.KEPT]].copy())
        words[at.KEPT] = 0
        if self.options.recorded is None and len(self._aside) * rows.nbytes > STEPS_MEMORY:
            self._aside, words[at.ROOM] = [], 0

    def kept_steps(self) -> np.ndarray | None:
        """Return the rows of all steps, and the state at the end, after an event there."""
        words, rows = self.steps
        if words[at.ROOM] == 0:
            return None
        last = np.zeros((1, rows.shape[1]))
        last[0, 0], last[0, 2 : 2 + self.n] = self.progress.state[at.TIME], self.memory.x[: self.n]
        # A step that an event has cut short ends in a row that is counted; what follows is old.
        number = int(words[at.KEPT])
        latest = rows[: number + 1 if number and rows[number - 1, 1] > 0.0 else number]
        return np.concatenate([*self._aside, latest, last])

    def _callback(self, function: Callable[..., Any], outputs: int, what: str) -> Callback:
        callback = Callback(function, self.n, outputs, what, self.interrupts)
        self.callbacks.append(callback)
        return callback

    def _bind(self, f: Callable[..., Any], args: tuple[Any, ...]) -> Problem:
        call, n = self.call, self.n
        if call is not None and call.inputs is None and call.kernel.addresses is not None:
            if call.kernel.program.num_states != n:
                raise ValueError(
                    f"`x0` must have {call.kernel.program.num_states} values, one for each state, "
                    f"got {n}."
                )
            return problem_of(self._bind_native(call.kernel, call.p), n, call)
        what = "What `f(x, t)` returns, one derivative for each state of `x0`,"

        def called(x: np.ndarray, t: float) -> Any:
            try:
                return f(x, t, *args)
            except TypeError as error:
                error.add_note("This came from `f`, called as f(x, t, *args).")
                raise

        callback = self._callback(called, n, what)
        return problem_of(callback, n, call)

    def _bind_kernel(self, kernel: Kernel) -> tuple[int, np.ndarray]:
        """Return the place of the address and the constants of a further Kernel of the system."""
        call = self.call
        assert call is not None
        if call.inputs is None and kernel.addresses is not None:
            bound = self._bind_native(kernel, call.p)
            return bound.place, bound.c
        outputs = sum(b.stop - b.start for b in kernel.program.blocks)
        what = f"What the blocks {', '.join(b.name for b in kernel.program.blocks)} give"
        callback = self._callback(lambda x, t: call.evaluate(kernel, x, t), outputs, what)
        return callback.place, callback.c

    def _bind_native(self, kernel: Kernel, p: np.ndarray) -> Bound:
        self._bound.append(Bound(kernel, p))
        return self._bound[-1]

    def _reserve(self) -> tuple[Method, Memory]:
        n = self.n
        method, self._method_rows = _method(self.name, BLOCK * blocks(n))
        memory, self._memory_rows = memory_for(method, BLOCK * blocks(n))
        self._set_tolerances(memory)
        return method, memory

    def _set_tolerances(self, memory: Memory) -> None:
        memory.rtol[: self.n], memory.atol[: self.n] = self._tolerances()
        np.maximum(memory.atol, LEAST_TOLERANCE, out=memory.atol)
        memory.atol[self.n :] = 1.0  # of what fills the last block

    def _tolerances(self) -> tuple[np.ndarray, np.ndarray]:
        options, beside = self.options, self.options.sensitivities
        n = self.n if beside is None else beside.states
        rtol, atol = np.empty(n), np.empty(n)
        try:
            rtol[:], atol[:] = options.rtol, options.atol
        except ValueError:
            raise ValueError(
                f"`rtol` and `atol` must be numbers or have the shape ({n},), got the shapes "
                f"{np.shape(options.rtol)} and {np.shape(options.atol)}."
            ) from None
        if beside is None:
            return rtol, atol
        return beside.tolerances(rtol, atol)

    def _hold(self) -> Constraints:
        wanted = self.options.constraints
        if wanted is None:
            return NO_CONSTRAINTS
        held, self._projection = constraints_for(
            wanted, "project", self._bind_kernel(wanted.kernel), self.n
        )
        self.seen = held.values[-seen_of(wanted, self.n) :]
        if self.options.sensitivities is not None:
            self._hold_columns(held.words, self.options.sensitivities)
        return held

    def _hold_columns(self, words: np.ndarray, beside: CompiledSensitivities) -> None:
        """Let the projection correct the sensitivities with the state."""
        residuals, k = words[at.HOLONOMIC] + words[at.VELOCITY], beside.columns
        place, c = self._bind_kernel(beside.constraints())
        self._tangents = Tangents(
            np.array([words[at.PROJECT], place, k]), c, np.zeros(residuals * k)
        )
        self._tangents_table = table_of(rows_of(self._tangents))
        words[at.PROJECT] = shipped.address_of("project_columns")
        words[at.TANGENTS] = address(self._tangents_table)

    def _look_out(self) -> Watch:
        wanted = self.options.events
        if wanted is None:
            return _NO_EVENTS
        number = len(wanted.names)
        place, c = self._bind_kernel(wanted.values)
        stops = zip(wanted.terminal, wanted.resetting, strict=True)
        acting = [end or resets for end, resets in stops]
        rows = 256 + number if number else 0  # between two visits in Python
        # Steps of fixed size are as the user set them.
        fixed = self.options.step is not None
        kinds = [
            at.LINEAR * (linear or fixed)
            + at.TURNS * turns
            + at.RESETS * (resets and not ends)
            + at.STOPS * (ends and not resets)
            + at.REDIRECTS * redirects
            for linear, turns, resets, ends, redirects in zip(
                wanted.linear,
                wanted.turns,
                wanted.resetting,
                wanted.terminal,
                wanted.redirects,
                strict=True,
            )
        ]
        reacher, reach, reach_c = [0, 0, 0], np.zeros(1), np.zeros(1)
        if (far := wanted.reach) is not None and far.addresses is not None and not self.callbacks:
            assert self.call is not None
            bound = self._bind_native(far, self.call.p)
            size, moving = far.program.num_specifieds, far.program.num_states
            reacher, reach_c = [bound.place, size - moving - 1, moving], bound.c
            reach = np.zeros(size + BLOCK)
        act, rates_c, resets_c = self._acting(wanted)
        return Watch(
            words=np.array([place, number, shipped.address_of("scan_events"), *reacher, *act]),
            c=c,
            directions=np.array(wanted.directions, dtype=np.int64),
            acting=np.array(acting, dtype=np.int64),
            kinds=np.array(kinds, dtype=np.int64),
            reach=reach,
            reach_c=reach_c,
            sides=np.zeros(number, dtype=np.int64),
            fired=np.zeros(number, dtype=np.int64),
            values=np.zeros(at.PROBES * number + 1),
            rests=np.full(2 * number, np.nan),
            trial=np.zeros(BLOCK * blocks(self.n)),
            log_times=np.zeros(rows),
            log_events=np.zeros(rows, dtype=np.int64),
            log_states=np.zeros((rows, self.n)),
            log_after=np.zeros((rows, self.n)),
            rates_c=rates_c,
            resets_c=resets_c,
            told=np.zeros(2 * number),
            after=np.zeros((number, self.n)),
            latest=np.full((number, CROWD), -np.inf),
        )

    def _acting(self, wanted: CompiledEvents) -> tuple[list[int], np.ndarray, np.ndarray]:
        """Return the arrays with which compiled code resets states; Python reads its log later.

        A jump of samples, or a switch, may be what makes an event happen: then Python does it, as
        it does with what stands beside the states.
        """
        call, resets, options = self.call, wanted.resets, self.options
        bounding = options.sensitivities if options.recorded is not None else None
        width = self.n
        if bounding is not None and not bounding.controlled:  # it goes on through events as it is
            width = bounding.states
        beside = options.constraints is not None or options.sensitivities is not bounding
        beside = beside or options.recorded not in (None, width)  # such as an integral
        if beside or self.callbacks or call is None or call.sampled or resets is None:
            return [0, 0, 0], np.zeros(1), np.zeros(1)
        if call.switched is not None:
            return [0, 0, 0], np.zeros(1), np.zeros(1)
        if resets.addresses is None or wanted.rates.addresses is None:
            return [0, 0, 0], np.zeros(1), np.zeros(1)
        (rater, rates_c), (resetter, resets_c) = map(self._bind_kernel, (wanted.rates, resets))
        return [shipped.address_of("act_on_event"), rater, resetter], rates_c, resets_c

    def _reserve_newton(self) -> list[int]:
        n, call, beside = self.n, self.call, self.options.sensitivities
        self._newton = newton_for(n, n if beside is None else beside.states)
        if beside is not None:
            self._newton.words[at.COUNTED] = beside.columns
        if call is not None and call.jacobian is not None:
            place, c = self._bind_kernel(call.jacobian())
            self._newton.words[at.GRADIENT], self._newton = place, self._newton._replace(c=c)
        return rows_of(self._newton)


class Twin:
    """A copy of a Workspace with its own memory, independent of later changes.

    Twins of one Workspace share what they have reserved, as long as they take other numbers.
    """

    def __init__(self, own: Workspace) -> None:
        options = replace(own.options, dense_output=False, events=None)
        self._call, self._times = own.call, own.progress.times[:1].copy()
        f = own._f
        if own.call is not None:
            f = self._call = replace(own.call, p=own.call.p.copy(), r=own.call.r.copy())
        self._make = partial(Workspace, own.name, f, own.n, self._times, own._args, options)
        self._free = own.twins if not own.callbacks else []

    def taken(self) -> Workspace:
        """Return a Workspace that no other thread has."""
        with suppress(IndexError):
            work = self._free.pop()
            if work.call is self._call or work.rebind(self._call, self._times):
                return work
        return self._make()

    def left(self, work: Workspace) -> None:
        """Take a Workspace back, for the next call."""
        self._free[:] = [work]
