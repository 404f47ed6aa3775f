"""The arrays of an integration, which compiled code works on, and the table of their addresses."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import cache, partial
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._array_layout import address
from pydy._interrupts import Interrupts
from pydy._kernel import Kernel, KernelCall
from pydy.solvers import layout as at
from pydy.solvers.compiled_events import CompiledEvents
from pydy.solvers.constraints import CompiledConstraints
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
    Callback,
    KernelBinding,
    aligned_zeros,
    block_count,
    jumps_of_call,
    problem_arrays,
    with_switch_times,
)
from pydy.solvers.sensitivities import CompiledSensitivities
from pydy.solvers.tableaus import IMPLICIT, method_arrays
from pydy.solvers.tuning import BLOCK, CROWD, LEAST_TOLERANCE, STEPS_MEMORY

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

_STEPS = 2**13  # numbers of recorded steps between two returns to Python

# What compiled code does not use; these arrays are never written.
NO_CONSTRAINTS = Constraints(np.zeros(12, dtype=np.int64), np.zeros(1), np.zeros(1))
_NO_EVENTS = Watch(*[np.zeros(4)] * len(Watch._fields))
_NO_STEPS = Steps(np.zeros(2, dtype=np.int64), np.zeros((1, 1)))
_NO_CONSTRAINTS_ROWS, _NO_EVENTS_ROWS = rows_of(NO_CONSTRAINTS), rows_of(_NO_EVENTS)
_NO_STEPS_ROWS = rows_of(_NO_STEPS)


@cache
def _method(name: str, length: int) -> tuple[Method, list[int]]:
    """Return a method's arrays and their rows of addresses, which belong together.

    If two threads call `method_arrays` first at the same time, one of them gets arrays that are in
    no cache: its rows must have the addresses of these.
    """
    arrays = method_arrays(name, length)
    return arrays, rows_of(arrays)


def memory_for(method: Method, length: int) -> tuple[Memory, list[int]]:
    """Allocate a method's vectors in one block of memory; return them and their rows."""
    stages, depth = max(1, len(method.nodes)), method.depth
    counts = (1, 1, 1, 1, 1, 1, 2, stages, depth, 1, 1)
    flat = aligned_zeros(sum(counts) * length)
    start, first = address(flat), 0
    vectors: list[np.ndarray] = []
    rows: list[int] = []
    for name, count in zip(Memory._fields, counts, strict=True):
        size = BLOCK if name in ("step", "theta") else count * length
        vectors.append(flat[first : first + size])
        rows += (start + 8 * first, size, 1)
        first += count * length
    return Memory(*vectors), rows


def projection_record_size(constraints: CompiledConstraints, n: int) -> int:
    """Return how many numbers the projection of n states records."""
    return at.WHERE + n + constraints.sizes.velocity


def constraints_for(
    constraints: CompiledConstraints,
    entry: str,
    binding: tuple[int, np.ndarray],
    n: int,
    lanes: int = 1,
) -> tuple[Constraints, tuple[object, ...]]:
    """Return the arrays of the projection of n states, and others that must stay alive.

    The projection is an `entry` of the loops. The `binding` of its Kernel is an address slot and
    constants.
    """
    h, v, q, u = constraints.sizes
    rows_size, columns_size = max(h, v) * lanes, max(q, u) * lanes
    scratch = Projection(
        factor=np.zeros((u, u * lanes)),
        kinematics=np.zeros((q, u * lanes)),
        gradient=np.zeros((h, q * lanes)),
        holonomic=np.zeros((h, u * lanes)),
        velocity=np.zeros((v, u * lanes)),
        step=np.zeros(columns_size),
        right=np.zeros(rows_size),
        scale=np.zeros(rows_size),
        lengths=np.zeros(rows_size),
        kept=np.zeros(rows_size),
        mended=np.zeros(rows_size),
        best=np.zeros(columns_size),
    )
    table, words = table_of(rows_of(scratch)), np.zeros(13, dtype=np.int64)
    words[at.ACTIVE], words[at.PROJECT] = 1, shipped.address_of(entry)
    words[at.PROJECTOR], c = binding
    words[at.HOLONOMIC], words[at.VELOCITY], words[at.COORDINATES], words[at.SPEEDS] = h, v, q, u
    words[at.WEIGHTED], words[at.JUDGED] = constraints.weighted, constraints.judged
    words[at.POSITIONS], words[at.MOTIONS] = (
        h - constraints.left_out[0],
        v - constraints.left_out[1],
    )
    words[at.SCRATCH] = address(table)
    size = constraints.kernel.program.signature.num_outputs
    values = aligned_zeros((size + projection_record_size(constraints, n)) * lanes)
    return Constraints(words, c, values), (scratch, table)


def newton_for(n: int, states: int, lanes: int = 1) -> Newton:
    """Allocate the arrays of an implicit step of n numbers, of which so many are states."""
    square, padded = (
        states * states,
        BLOCK * block_count(n),
    )  # error estimates are read in whole blocks
    matrices, stages = (square, square, square, 2 * square), [3 * n] * 3
    counts = (4, 1, *matrices, states, states, *stages, 4 * n, padded, 2 * n, n)
    return Newton(np.zeros(6, dtype=np.int64), *(aligned_zeros(count * lanes) for count in counts))


class Workspace:
    """The arrays of one integration, allocated once for all its runs.

    Its parameters are those of `pydy.solvers.run.integration.Integration`, and the interrupts that
    callbacks check. The `call` is None if `f` is only a Python function; `projection_record` is the
    part of ``constraints.values`` that the projection writes; `beginning` has the values of
    `progress` at the beginning of each run.
    """

    def __init__(
        self,
        method: str,
        f: Callable[..., ArrayLike],
        n: int,
        times: np.ndarray,
        args: tuple[object, ...],
        options: Options,
        interrupts: Interrupts | None = None,
    ) -> None:
        self.name, self.n, self.options = method, n, options
        self.interrupts = interrupts or Interrupts()
        self._f, self._args = f, args
        self.rebound = False  # whether it has other times or numbers than at first
        self.callbacks: list[Callback] = []
        self._bound: list[KernelBinding] = []
        native = getattr(f, "native", None)
        self.call: KernelCall | None = None if native is None else native(args)
        if self.call is not None and self.call.switched is None:
            self.call = with_switch_times(self.call, times, options)
        self.problem = self._bind(f, args)
        sensitivities = options.sensitivities
        if sensitivities is not None and not sensitivities.controlled:
            words = self.problem.words
            words[at.CONTROLLED], words[at.BOUNDED] = sensitivities.states, n
        self.method, self.memory = self._reserve()
        self.projection_record = np.zeros(0)
        self.constraints = self._bind_constraints()
        self.watch = self._bind_events()
        state, count = np.zeros(7), np.zeros(12, dtype=np.int64)
        state[at.TIME], state[at.LARGEST] = times[0], options.max_step
        state[at.SIZE] = options.first_step or options.step or 0.0
        count[at.LIMIT], count[at.FAILURE] = options.max_steps, Outcome.STEP_UNDERFLOW
        self.beginning = Beginning(state, count)
        self.progress = Progress(state.copy(), count.copy(), np.array(times, order="C"))
        self.steps = _NO_STEPS
        self.records_steps = options.dense_output or options.recorded is not None
        if self.records_steps:
            width = 2 + n * (1 + (3 if method == IMPLICIT else 0))
            room = 4 + _STEPS // width
            self.steps = Steps(np.array([0, room]), np.zeros((room, width)))
        self._stored_steps: list[np.ndarray] = []
        # Allocated by `WorkspaceCopy`, while they are not in use.
        self.copies: list[Workspace] = []
        self._newton_rows = self._reserve_newton() if method == IMPLICIT else []
        parts = self._method_rows, rows_of(self.problem), self._memory_rows, rows_of(self.progress)
        self._after_times = sum(map(len, parts))  # index in the table
        self._table = table_of(
            *parts,
            _NO_CONSTRAINTS_ROWS if options.constraints is None else rows_of(self.constraints),
            _NO_EVENTS_ROWS if options.events is None else rows_of(self.watch),
            rows_of(self.beginning),
            rows_of(self.steps) if self.records_steps else _NO_STEPS_ROWS,
            self._newton_rows,
        )
        self.table_address = address(self._table)

    def lane_copies(self, lanes: int) -> tuple[list[np.ndarray], np.ndarray, np.ndarray]:
        """Return copies of the arrays that lanes do not share, and the fields of `layout.Alone`.

        The copies must stay alive.
        """
        tables, lane = np.tile(self._table, (lanes, 1)), np.arange(lanes)
        columns = {column: 3 * k for k, column in enumerate(self._table[::3].tolist())}
        copies, addresses = [tables], {}
        watch = self.watch
        records = (watch.sides, watch.fired, watch.values, watch.rests, watch.latest)
        log = (watch.log_times, watch.log_events, watch.log_states, watch.log_after)
        constants = (watch.c, watch.rates_c, watch.resets_c)
        for array in (self.problem.r, self.progress.counts, *records, *log, *constants):
            if (column := columns.get(address(array))) is not None:
                copies.append(array[None].repeat(lanes, axis=0))
                addresses[id(array)] = tables[:, column] = address(copies[-1]) + array.nbytes * lane
        prepared = [
            [b.address_slot + 8, *addresses[id(b.c)]] for b in self._bound if id(b.c) in addresses
        ]
        runs = address(tables) + tables.strides[0] * lane
        return copies, runs, np.array(prepared, dtype=np.int64).reshape(-1, 1 + lanes)

    def rebind(self, call: KernelCall | None, times: np.ndarray) -> bool:
        """Use other times and another call of the same Kernel, or return False.

        Compiled code reads the arrays at the beginning of each run.
        """
        before = self.call
        if before is None or call is None or call.kernel is not before.kernel:
            return False
        inputs, samples_before = call.inputs, before.inputs.sampled
        if (
            ((inputs.sampled or samples_before) and inputs.sampled is not samples_before)
            or inputs.functions
            or times.item(-1) < times.item(0)  # an integration backward is another one
            or self.callbacks
        ):
            return False
        if before.switched is not None:
            if call.switched is None:
                call = with_switch_times(call, times, self.options)
            jumps, words = jumps_of_call(call), self.problem.words
            if jumps.shape != self.problem.jumps.shape:
                return False
            self.problem.jumps[:] = jumps
            words[at.SWITCHED] = 0 if call.switched is None else len(call.switched)
        for bound in self._bound:
            bound.set_constants(call.p)
        self.problem.r[: len(inputs.values)] = inputs.values
        if len(times) == len(self.progress.times):
            self.progress.times[:] = times
        else:
            other = np.array(times, order="C")
            self.progress = self.progress._replace(times=other)
            self._table[self._after_times - 3 : self._after_times] = rows_of((other,))
        self.beginning.state[at.TIME] = times[0]
        self.call, self.rebound = call, True
        return True

    def retune(self, options: Options) -> bool:
        """Change tolerances, step sizes and step limits; return False if that is impossible."""
        before = self.options
        fixed = ("events", "constraints", "sensitivities", "recorded", "progress", "dense_output")
        if options.sensitivities is not None or any(
            getattr(options, name) is not getattr(before, name) for name in fixed
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

    def clear_steps(self) -> None:
        """Remove all recorded steps."""
        words, rows = self.steps
        self._stored_steps, words[at.KEPT], words[at.ROOM] = [], 0, len(rows)

    def store_steps(self) -> None:
        """Empty the array of steps; give up recording if they need too much memory."""
        words, rows = self.steps
        self._stored_steps.append(rows[: words[at.KEPT]].copy())
        words[at.KEPT] = 0
        if self.options.recorded is None and len(self._stored_steps) * rows.nbytes > STEPS_MEMORY:
            self._stored_steps, words[at.ROOM] = [], 0

    def step_rows(self) -> np.ndarray | None:
        """Return the rows of all steps, and the state at the end, after an event there."""
        words, rows = self.steps
        if words[at.ROOM] == 0:
            return None
        last = np.zeros((1, rows.shape[1]))
        last[0, 0], last[0, 2 : 2 + self.n] = self.progress.state[at.TIME], self.memory.x[: self.n]
        # A step that an event has cut short ends in a row that is counted; what follows is old.
        number = int(words[at.KEPT])
        latest = rows[: number + 1 if number and rows[number - 1, 1] > 0.0 else number]
        return np.concatenate([*self._stored_steps, latest, last])

    def _callback(self, function: Callable[..., Any], outputs: int, label: str) -> Callback:
        callback = Callback(function, self.n, outputs, label, self.interrupts)
        self.callbacks.append(callback)
        return callback

    def _bind(self, f: Callable[..., ArrayLike], args: tuple[object, ...]) -> Problem:
        call, n = self.call, self.n
        if call is not None and not call.inputs.functions and call.kernel.addresses is not None:
            states = call.kernel.program.signature.num_states
            if states != n:
                raise ValueError(f"`x0` must have {states} values, one for each state, got {n}.")
            return problem_arrays(self._bind_native(call.kernel, call.p), n, call)
        label = "What `f(x, t)` returns, one derivative for each state of `x0`,"

        def rates(x: np.ndarray, t: float) -> ArrayLike:
            try:
                return f(x, t, *args)
            except TypeError as error:
                error.add_note("This came from `f`, called as f(x, t, *args).")
                raise

        callback = self._callback(rates, n, label)
        return problem_arrays(callback, n, call)

    def _bind_kernel(self, kernel: Kernel) -> tuple[int, np.ndarray]:
        """Bind another Kernel of the system; return its address slot and constants."""
        call = self.call
        assert call is not None
        if not call.inputs.functions and kernel.addresses is not None:
            bound = self._bind_native(kernel, call.p)
            return bound.address_slot, bound.c
        signature = kernel.program.signature
        label = f"What the blocks {', '.join(b.name for b in signature.blocks)} give"
        outputs = signature.num_outputs
        callback = self._callback(lambda x, t: call.evaluate(kernel, x, t), outputs, label)
        return callback.address_slot, callback.c

    def _bind_native(self, kernel: Kernel, p: np.ndarray) -> KernelBinding:
        self._bound.append(KernelBinding(kernel, p))
        return self._bound[-1]

    def _reserve(self) -> tuple[Method, Memory]:
        n = self.n
        method, self._method_rows = _method(self.name, BLOCK * block_count(n))
        memory, self._memory_rows = memory_for(method, BLOCK * block_count(n))
        self._set_tolerances(memory)
        return method, memory

    def _set_tolerances(self, memory: Memory) -> None:
        memory.rtol[: self.n], memory.atol[: self.n] = self._tolerances()
        np.maximum(memory.atol, LEAST_TOLERANCE, out=memory.atol)
        memory.atol[self.n :] = 1.0  # the padding of the last block

    def _tolerances(self) -> tuple[np.ndarray, np.ndarray]:
        options, sensitivities = self.options, self.options.sensitivities
        n = self.n if sensitivities is None else sensitivities.states
        rtol, atol = np.empty(n), np.empty(n)
        try:
            rtol[:], atol[:] = options.rtol, options.atol
        except ValueError:
            raise ValueError(
                f"`rtol` and `atol` must be numbers or have the shape ({n},), got the shapes "
                f"{np.shape(options.rtol)} and {np.shape(options.atol)}."
            ) from None
        if sensitivities is None:
            return rtol, atol
        return sensitivities.tolerances(rtol, atol)

    def _bind_constraints(self) -> Constraints:
        compiled = self.options.constraints
        if compiled is None:
            return NO_CONSTRAINTS
        constraints, self._projection = constraints_for(
            compiled, "project", self._bind_kernel(compiled.kernel), self.n
        )
        self.projection_record = constraints.values[-projection_record_size(compiled, self.n) :]
        if self.options.sensitivities is not None:
            self._bind_constraint_columns(constraints.words, self.options.sensitivities)
        return constraints

    def _bind_constraint_columns(
        self, words: np.ndarray, sensitivities: CompiledSensitivities
    ) -> None:
        """Let the projection correct the sensitivities together with the state."""
        residuals, k = words[at.HOLONOMIC] + words[at.VELOCITY], sensitivities.columns
        address_slot, c = self._bind_kernel(sensitivities.constraints())
        self._tangents = Tangents(
            np.array([words[at.PROJECT], address_slot, k]), c, np.zeros(residuals * k)
        )
        self._tangents_table = table_of(rows_of(self._tangents))
        words[at.PROJECT] = shipped.address_of("project_columns")
        words[at.TANGENTS] = address(self._tangents_table)

    def _bind_events(self) -> Watch:
        events = self.options.events
        if events is None:
            return _NO_EVENTS
        number = len(events.traits)
        address_slot, c = self._bind_kernel(events.values)
        rows = 256 + number if number else 0  # between two returns to Python
        # Events do not shorten steps of fixed size.
        fixed = self.options.step is not None
        driven = events.input_rates is not None and not (
            self.call is None or self.call.inputs.constant
        )
        kinds = [
            at.LINEAR * (event.linear or fixed)
            + at.TURNS * event.turns
            + at.RESETS * (event.resets and not event.terminal)
            + at.STOPS * (event.terminal and not event.resets)
            + at.REDIRECTS * event.redirects
            + at.DRIVEN * driven
            for event in events.traits
        ]
        reacher, reach, reach_c = [0, 0, 0], np.zeros(1), np.zeros(1)
        if (
            (bounds := events.reach) is not None
            and bounds.addresses is not None
            and not self.callbacks
        ):
            assert self.call is not None
            bound = self._bind_native(bounds, self.call.p)
            moving, size, _ = bounds.program.signature.sizes
            reacher, reach_c = [bound.address_slot, size - moving - 1, moving], bound.c
            reach = np.zeros(size + BLOCK)
        act, rates_c, resets_c = self._bind_event_actions(events)
        return Watch(
            words=np.array(
                [address_slot, number, shipped.address_of("scan_events"), *reacher, *act]
            ),
            c=c,
            directions=np.array([event.direction for event in events.traits], dtype=np.int64),
            acting=np.array([event.acts for event in events.traits], dtype=np.int64),
            kinds=np.array(kinds, dtype=np.int64),
            reach=reach,
            reach_c=reach_c,
            sides=np.zeros(number, dtype=np.int64),
            fired=np.zeros(number, dtype=np.int64),
            values=np.zeros(at.PROBES * number + 1),
            rests=np.full(2 * number, np.nan),
            trial=np.zeros(BLOCK * block_count(self.n)),
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

    def _bind_event_actions(
        self, events: CompiledEvents
    ) -> tuple[list[int], np.ndarray, np.ndarray]:
        """Return the arrays with which compiled code resets states; Python reads its log later.

        Python resets the states itself if sensitivities, integrals or constraints belong to them,
        and if a jump of samples or a switch may cause an event.
        """
        call, resets, options = self.call, events.resets, self.options
        rater, rates_c = self._bind_kernel(events.rates)
        bounding = options.sensitivities if options.recorded is not None else None
        width = self.n
        if bounding is not None and not bounding.controlled:  # events do not change it
            width = bounding.states
        augmented = options.constraints is not None or options.sensitivities is not bounding
        augmented = augmented or options.recorded not in (None, width)  # such as an integral
        if augmented or self.callbacks or call is None or call.inputs.sampled or resets is None:
            return [0, rater, 0], rates_c, np.zeros(1)
        if call.switched is not None:
            return [0, rater, 0], rates_c, np.zeros(1)
        if resets.addresses is None or events.rates.addresses is None:
            return [0, rater, 0], rates_c, np.zeros(1)
        resetter, resets_c = self._bind_kernel(resets)
        return [shipped.address_of("act_on_event"), rater, resetter], rates_c, resets_c

    def _reserve_newton(self) -> list[int]:
        n, call, sensitivities = self.n, self.call, self.options.sensitivities
        self._newton = newton_for(n, n if sensitivities is None else sensitivities.states)
        if sensitivities is not None:
            self._newton.words[at.COUNTED] = sensitivities.columns
        if call is not None and call.jacobian is not None:
            address_slot, c = self._bind_kernel(call.jacobian())
            self._newton.words[at.GRADIENT], self._newton = address_slot, self._newton._replace(c=c)
        return rows_of(self._newton)


class WorkspaceCopy:
    """A copy of a Workspace with its own memory, independent of later changes.

    Copies of one Workspace share an allocated one, if it can take their numbers.
    """

    def __init__(self, original: Workspace) -> None:
        options = replace(original.options, dense_output=False, events=None)
        self._call, self._times = original.call, original.progress.times[:1].copy()
        f = original._f
        if original.call is not None:
            call = original.call
            inputs = replace(call.inputs, values=call.inputs.values.copy())
            f = self._call = replace(call, p=call.p.copy(), inputs=inputs)
        self._make = partial(
            Workspace, original.name, f, original.n, self._times, original._args, options
        )
        self._free = original.copies if not original.callbacks else []

    def acquire(self) -> Workspace:
        """Return a Workspace that no other thread uses."""
        with suppress(IndexError):
            work = self._free.pop()
            if work.call is self._call or work.rebind(self._call, self._times):
                return work
        return self._make()

    def release(self, work: Workspace) -> None:
        """Make a Workspace available to the next call."""
        self._free[:] = [work]
