"""An integration from Python's side: it hands arrays to compiled code and sees to what happens.

Compiled code comes back after some steps, so that the interpreter can take an interrupt and a bar
can move; at events that change the state; and when it cannot go on.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from time import perf_counter
from typing import Any
from warnings import warn
from weakref import WeakSet

import numpy as np

from pydy._errors import (
    IntegrationError,
    IntegrationInterrupted,
    MissingDependencyError,
    PyDyUserWarning,
)
from pydy._kernel import Kernel, KernelCall
from pydy.solvers import layout as at
from pydy.solvers.complaints import complaint
from pydy.solvers.constraints import CompiledConstraints
from pydy.solvers.events import CompiledEvents, EventRecord
from pydy.solvers.interrupts import Interrupts
from pydy.solvers.layout import Constraints, Memory, Problem, Run, Watch
from pydy.solvers.methods import IMPLICIT, method_arrays, tableau_of
from pydy.solvers.options import Options
from pydy.solvers.problem import (
    BLOCK,
    Callback,
    bind_constants,
    blocks,
    callback_problem,
    kernel_problem,
    watch_arrays,
)

__all__ = ["integrate"]

_TOLD: WeakSet[Kernel] = WeakSet()  # whose dependent constraints have been told of

_SLICE = 0.02  # seconds in compiled code, about
_LOG = 256  # events between two visits in Python
_CROWD, _CROWDED = 100, 1e-9  # so many events within so much of the whole time are accumulating
_EPS = np.finfo(float).eps


# Compiled code neither reads nor writes these any further.
_NO_CONSTRAINTS = Constraints(np.zeros(7, dtype=np.int64), np.zeros(1), np.zeros(1))
_NO_EVENTS = watch_arrays(0, np.zeros(1), (), (), 1, 0)


def _first_budget(method: str, calls_python: bool) -> int:
    """Return how many steps take a few milliseconds at most; further ones are measured."""
    if calls_python:
        return 1
    return 4 if method == IMPLICIT else 100


def integrate(
    method: str,
    f: Callable[..., Any],
    x0: np.ndarray,
    times: np.ndarray,
    args: tuple[Any, ...],
    options: Options,
) -> tuple[np.ndarray, dict[str, Any]]:
    """Integrate; see `pydy.solvers.Solver`."""
    integration = _Integration(method, f, x0, times, args, options)
    states = integration.run()
    return states, integration.info() if options.full_output else {}


class _Integration:
    def __init__(
        self,
        method: str,
        f: Callable[..., Any],
        x0: np.ndarray,
        times: np.ndarray,
        args: tuple[Any, ...],
        options: Options,
    ) -> None:
        self.name = method
        self.options = options
        self.interrupts = Interrupts()
        self.callbacks: list[Callback] = []
        self.records: list[EventRecord] = []
        self.status = "finished"
        native = getattr(f, "native", None)
        self.call: KernelCall | None = None if native is None else native(args)
        n = len(x0)
        self.n = n
        self.problem = self._bind(f, args)
        self.memory = self._reserve(x0)
        self.constraints = self._hold()
        self.watch = self._look_out()
        state, count = np.zeros(6), np.zeros(12, dtype=np.int64)
        state[at.TIME], state[at.LARGEST] = times[0], options.max_step
        state[at.SIZE] = options.first_step or options.step or 0.0
        count[at.LIMIT] = options.max_steps
        flat = np.empty(len(times) * n + BLOCK)
        self.progress = Run(state, count, np.ascontiguousarray(times), flat)
        self.span = float(times[-1] - times[0])

    # -- arrays for compiled code -----------------------------------------------------------------

    def _callback(self, function: Callable[..., Any], outputs: int) -> Callback:
        callback = Callback(function, self.n, outputs, self.interrupts)
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
            return kernel_problem(call, n)
        callback = self._callback(lambda x, t: f(x, t, *args), n)
        return callback_problem(callback, n, call)

    def _bind_kernel(self, kernel: Kernel) -> tuple[int, np.ndarray]:
        """Return the address and constants of a further Kernel of the system."""
        call = self.call
        assert call is not None
        if call.inputs is None and kernel.addresses is not None:
            return bind_constants(kernel, call.p)
        outputs = sum(b.stop - b.start for b in kernel.program.blocks)
        callback = self._callback(lambda x, t: call.evaluate(kernel, x, t), outputs)
        return callback.address, np.zeros(1)

    def _reserve(self, x0: np.ndarray) -> Memory:
        n = self.n
        length = BLOCK * blocks(n)
        self.method = method_arrays(self.name, length)
        stages, depth = max(1, len(self.method.nodes)), int(self.method.shape[at.DEPTH])
        try:
            tolerances = np.empty((2, n))
            tolerances[0], tolerances[1] = self.options.rtol, self.options.atol
        except ValueError:
            raise ValueError(
                f"`rtol` and `atol` must be numbers or have the shape ({n},), got the shapes "
                f"{np.shape(self.options.rtol)} and {np.shape(self.options.atol)}."
            ) from None
        np.maximum(tolerances[1], 1e-300, out=tolerances[1])  # 0 / 0 would be no error
        vectors = np.zeros((6 + stages + depth, length))  # one block of memory for all of them
        vectors[0, :n] = x0
        return Memory(
            x=vectors[0],
            new=vectors[1],
            trial=vectors[2],
            step=np.zeros(BLOCK),
            theta=np.zeros(BLOCK),
            zero=vectors[3],
            errors=vectors[4:6].ravel(),
            stages=vectors[6 : 6 + stages].ravel(),
            interpolant=vectors[6 + stages :].ravel(),
            rtol=tolerances[0],
            atol=tolerances[1],
        )

    def _hold(self) -> Constraints:
        wanted = self.options.constraints
        if wanted is None:
            return _NO_CONSTRAINTS
        words = np.zeros(7, dtype=np.int64)
        words[at.ACTIVE] = 1
        words[at.PROJECTOR], c = self._bind_kernel(wanted.kernel)
        words[at.HOLONOMIC], words[at.VELOCITY] = wanted.holonomic, wanted.velocity
        words[at.COORDINATES], words[at.SPEEDS] = wanted.coordinates, wanted.speeds
        words[at.WEIGHTED] = wanted.weighted
        size = sum(b.stop - b.start for b in wanted.kernel.program.blocks)
        return Constraints(words, c, np.zeros(size))

    def _look_out(self) -> Watch:
        wanted = self.options.events
        if wanted is None:
            return _NO_EVENTS
        number = len(wanted.names)
        address, c = self._bind_kernel(wanted.values)
        stops = zip(wanted.terminal, wanted.resets, strict=True)
        acting = [end or reset is not None for end, reset in stops]
        return watch_arrays(address, c, wanted.directions, acting, self.n, _LOG if number else 0)

    # -- running ----------------------------------------------------------------------------------

    def run(self) -> np.ndarray:
        """Run to the end and return the states."""
        self._check_tolerances()
        bar = self._bar()
        try:
            with self.interrupts:
                self._start()
                self._run(bar)
        except KeyboardInterrupt:
            self._empty_log()
            self._stop(
                "was interrupted",
                "What was computed is in the attributes of this error.",
                IntegrationInterrupted,
            )
        finally:
            if bar is not None:
                bar.close()
        self._empty_log()
        states = self._states()
        states[self.progress.counts[at.NEXT] :] = np.nan
        return states

    def _run(self, bar: Any) -> None:
        advance = self._stepper()
        state, count = self.progress.state, self.progress.counts
        budget = _first_budget(self.name, bool(self.callbacks))
        while True:
            self.interrupts.check()
            count[at.BUDGET] = budget
            start, taken = perf_counter(), count[at.STEPS] + count[at.REJECTED]
            code = advance()
            self._raise_callback()
            elapsed = perf_counter() - start
            if bar is not None:
                bar.update(state[at.TIME] - bar.n - bar.start)
            if code == at.FINISHED:
                return
            if code == at.EVENT:
                if self._act():
                    return
                state[at.SIZE] = self.options.step or 0.0
            elif code == at.LOG_FULL:
                self._empty_log()
                state[at.SIZE] = self.options.step or 0.0
            elif code != at.PAUSED:
                self._fail(code)
            taken = count[at.STEPS] + count[at.REJECTED] - taken
            if code == at.PAUSED and elapsed > 0.0:
                budget = int(min(max(1.0, taken * _SLICE / elapsed), 4.0 * budget))

    def _stepper(self) -> Callable[[], int]:
        parts: tuple[Any, ...] = (
            self.method,
            self.problem,
            self.memory,
            self.progress,
            self.constraints,
            self.watch,
        )
        if self.name != IMPLICIT:
            from pydy.solvers.explicit import advance

            return partial(advance, *parts)
        from pydy.solvers.implicit import advance_implicit
        from pydy.solvers.newton import Newton

        n, call = self.n, self.call
        words, c = np.zeros(5, dtype=np.int64), np.zeros(1)
        if call is not None and call.jacobian is not None:
            words[0], c = self._bind_kernel(call.jacobian())
        newton = Newton(
            words=words,
            sizes=np.zeros(2),
            c=c,
            jacobian=np.zeros(n * n),
            real=np.zeros((n, n)),
            pair=np.zeros((n, n), dtype=complex),
            real_order=np.zeros(n, dtype=np.int64),
            pair_order=np.zeros(n, dtype=np.int64),
            stages=np.zeros((3, n)),
            waves=np.zeros((3, n)),
            slopes=np.zeros((3, n)),
            last=np.zeros((4, n)),
        )
        return partial(advance_implicit, *parts, newton)

    def _bar(self) -> Any:
        if not self.options.progress:
            return None
        try:
            from tqdm.auto import tqdm
        except ImportError:
            raise MissingDependencyError(
                "`progress=True` needs tqdm: pip install tqdm, or pass progress=False."
            ) from None
        layout = "{l_bar}{bar}| {n:.3g}/{total:.3g} s [{elapsed}<{remaining}]"
        bar = tqdm(total=self.span, desc=self.name, bar_format=layout)
        bar.start = float(self.progress.state[at.TIME])
        return bar

    def _check_tolerances(self) -> None:
        rtol, atol, x = self.memory.rtol, self.memory.atol, self.memory.x[: self.n]
        if self.name != IMPLICIT and tableau_of(self.name).error_order is None:
            return
        k = int(np.argmin(rtol))
        if rtol[k] < 10.0 * _EPS and atol[k] < 10.0 * _EPS * max(abs(x[k]), 1.0):
            self._stop(
                f"cannot start with rtol = {rtol[k]:.3g} and atol = {atol[k]:.3g}",
                f"Double precision carries about {_EPS:.1e}: ask for rtol of {10.0 * _EPS:.1e} or "
                "more.",
            )

    def _start(self) -> None:
        """See to the initial state."""
        if self.options.constraints is not None:
            self._tell_dependent(self.options.constraints)
            self._project_start()
        if self.options.events is not None:
            self._check_events(self.options.events)
            self._take_sides(())

    def _tell_dependent(self, wanted: CompiledConstraints) -> None:
        """Warn, once for each system, of constraints that others imply."""
        call = self.call
        assert call is not None
        if wanted.kernel in _TOLD:
            return
        _TOLD.add(wanted.kernel)
        t = float(self.progress.state[at.TIME])
        names = wanted.dependent(call.evaluate(wanted.kernel, self.memory.x[: self.n].copy(), t))
        if names:
            warn(
                f"These constraints follow from others at t = {t!r}, and are held without being "
                f"counted: {'; '.join(names)}. Leave them out if that is so in every state.",
                PyDyUserWarning,
                stacklevel=6,
            )

    def _project_start(self) -> None:
        """Move the initial state onto the constraints, unless it is far from them."""
        from pydy.solvers.explicit import project_state

        x = self.memory.x
        before = x.copy()
        t = float(self.progress.state[at.TIME])
        code = project_state(self.problem, self.progress, self.constraints, t, x)
        self._raise_callback()
        moved = np.abs(x - before)
        if code != 0 or (moved > 1e-3 * (1.0 + np.abs(before))).any():
            k = int(np.argmax(moved / (1.0 + np.abs(before))))
            after = float(x[k])
            self.memory.x[:] = before
            mended = f"moved {self._state_name(k)} from {before[k]:.6g} to {after:.6g}"
            self._stop(
                "found initial conditions that do not satisfy the constraints (the projection "
                f"{'did not converge' if code else mended})",
                "Call `system.set_dependent_initial_conditions()` first.",
            )

    def _check_events(self, events: CompiledEvents) -> None:
        for name, constant in zip(events.names, events.constant, strict=True):
            if constant:
                self._stop(
                    f"cannot look for the event `{name}`, whose expression is constant,",
                    "It must depend on the states, on specifieds or on time.",
                )

    # -- events -----------------------------------------------------------------------------------

    def _take_sides(self, fired: tuple[int, ...]) -> None:
        """Set the sign each event has just after now; where one is zero, its rate tells."""
        wanted, call = self.options.events, self.call
        assert wanted is not None
        assert call is not None
        x, t = self.memory.x[: self.n].copy(), float(self.progress.state[at.TIME])
        values, rates = call.evaluate(wanted.values, x, t), call.evaluate(wanted.rates, x, t)
        for k, (value, rate) in enumerate(zip(values, rates, strict=True)):
            if k in fired or value == 0.0:
                value = rate
            self.watch.sides[k] = int(np.sign(value)) if np.isfinite(value) else 0

    def _act(self) -> bool:
        """See to the events at which compiled code stopped; tell whether the integration ends."""
        wanted, call = self.options.events, self.call
        assert wanted is not None
        assert call is not None
        self._empty_log()
        t = float(self.progress.state[at.TIME])
        fired = tuple(int(k) for k in np.flatnonzero(self.watch.fired))
        before = self.memory.x[: self.n].copy()
        for k in fired:
            reset = wanted.resets[k]
            after = before if reset is None else call.evaluate(reset, before, t)
            self.records.append(EventRecord(t, wanted.names[k], k, before, after))
            before = after
        if not np.isfinite(before).all():
            self._stop(
                f"met the event `{wanted.names[fired[-1]]}`, whose reset gave {before}",
                "Check its expressions.",
            )
        self.memory.x[: self.n] = before
        if any(wanted.terminal[k] for k in fired):
            last = next(wanted.names[k] for k in fired if wanted.terminal[k])
            self.status = f"terminated by `{last}`"
            return True
        self._take_sides(fired)
        crowded = next((wanted.names[k] for k in fired if self._accumulates(k, t)), None)
        if crowded is None:
            return False
        self.status = f"events `{crowded}` accumulate"
        warn(
            f"`{self.name}` stopped at t = {t!r}: the events `{crowded}` follow each other ever "
            "faster and accumulate there. Make the reset end the motion it ends in reality, or the "
            "event terminal.",
            PyDyUserWarning,
            stacklevel=6,
        )
        return True

    def _accumulates(self, event: int, t: float) -> bool:
        number = len(self.watch.fired)
        same = [r.time for r in self.records[-_CROWD * number :] if r.index == event][-_CROWD:]
        if len(same) >= 2 and t - same[-2] <= 16.0 * _EPS * max(abs(t), self.span):
            return True
        return len(same) == _CROWD and t - same[0] < _CROWDED * self.span

    def _empty_log(self) -> None:
        wanted, count = self.options.events, self.progress.counts
        if wanted is None:
            return
        for k in range(count[at.LOGGED]):
            event = int(self.watch.log_events[k])
            x = self.watch.log_states[k].copy()
            t = float(self.watch.log_times[k])
            self.records.append(EventRecord(t, wanted.names[event], event, x, x))
        count[at.LOGGED] = 0

    # -- results ----------------------------------------------------------------------------------

    def _states(self) -> np.ndarray:
        times, flat = self.progress.times, self.progress.flat
        return flat[: len(times) * self.n].reshape(len(times), self.n)

    def info(self) -> dict[str, Any]:
        """Return the statistics."""
        state, count = self.progress.state, self.progress.counts
        return {
            "method": self.name,
            "status": self.status,
            "time": float(state[at.TIME]),
            "steps": int(count[at.STEPS]),
            "rejected": int(count[at.REJECTED]),
            "evaluations": int(count[at.EVALUATIONS]),
            "jacobians": int(count[at.JACOBIANS]),
            "factorisations": int(count[at.FACTORISATIONS]),
            "projections": int(count[at.PROJECTIONS]),
            "last_step": float(state[at.LAST_SIZE]),
            "reached": int(count[at.NEXT]),
            "events": list(self.records),
        }

    def _state_name(self, k: int) -> str:
        names = () if self.call is None else self.call.names()
        return names[k] if k < len(names) else f"x[{k}]"

    def _raise_callback(self) -> None:
        for callback in self.callbacks:
            if callback.error is not None:
                raise callback.error

    def _fail(self, code: int) -> None:
        """Raise the error of a code with which compiled code gave up."""
        failure = int(self.progress.counts[at.FAILURE])
        size = float(self.progress.state[at.SIZE])
        self._stop(*complaint(code, failure, size, self.options.max_steps))

    def _stop(
        self,
        what: str,
        remedy: str,
        kind: type[IntegrationError] | type[IntegrationInterrupted] = IntegrationError,
    ) -> None:
        t, reached = float(self.progress.state[at.TIME]), int(self.progress.counts[at.NEXT])
        x = self.memory.x[: self.n].copy()
        shown = ", ".join(f"{self._state_name(k)} = {v:.6g}" for k, v in enumerate(x[:12]))
        more = f", and {self.n - 12} more" if self.n > 12 else ""
        self.status = what
        raise kind(
            f"`{self.name}` {what} at t = {t!r} in the state {shown}{more}. {remedy}",
            self.progress.times[:reached].copy(),
            self._states()[:reached].copy(),
            t,
            x,
            self.info(),
        )
