"""Turn a right-hand side into what compiled solvers call: an address, and arrays to go with it."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from pydy._array_layout import address
from pydy._backends import gates
from pydy._checks import vector
from pydy._errors import warn_user
from pydy._forks import once
from pydy._interrupts import Interrupts
from pydy._kernel import Kernel, KernelCall
from pydy.inputs import jumps_of, merged_jumps
from pydy.solvers.layout import REFLECTED, Problem
from pydy.solvers.options import Options
from pydy.solvers.run import shipped
from pydy.solvers.tuning import BLOCK

_NO_TABLES = np.zeros((0, 4), dtype=np.int64), np.zeros(0), np.zeros((0, 4))

NO_JUMPS = np.zeros((0, 3))

_PREPARE = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p)


def blocks(n: int) -> int:
    """Return how many blocks hold n numbers."""
    return -(-n // BLOCK)


class Bound:
    """A native Kernel, with an array c of what it computes of constants alone.

    It is known by the `place` of its address; that of what prepares the constants is the next one.
    """

    def __init__(self, kernel: Kernel, p: np.ndarray) -> None:
        addresses = kernel.addresses
        assert addresses is not None
        self._kernel, self._addresses = kernel, addresses  # the code lives as long as they do
        self.place, first = address(addresses), 0
        size = max(1, kernel.size_of_c)
        if kernel.negated is not None:
            self.place, first = address(_reflecting_addresses()), REFLECTED
        self.c = np.zeros(first + size)
        if kernel.negated is not None:
            self.c[:2] = np.array([address(addresses), kernel.negated]).view(float)
        self._p = np.empty(np.shape(p))
        self._places = address(self._p), address(self.c) + 8 * first
        self.take(p)

    def take(self, p: np.ndarray) -> None:
        """Take other constants: compute the array c from them."""
        self._p[:] = p
        _prepare(int(self._addresses[1]))(*self._places)


def lined_up(*shape: int) -> np.ndarray:
    """Return zeros aligned to a cache line, so that no block lies across two lines."""
    size = math.prod(shape)
    room = np.zeros(size + BLOCK)
    first = -address(room) % 64 // 8
    return room[first : first + size].reshape(shape)


@once
def _python_addresses() -> np.ndarray:
    """Return the address of what calls Python functions, as Kernels have theirs."""
    return np.array([gates().code.addresses["call_python"]], dtype=np.int64)


@once
def _reflecting_addresses() -> np.ndarray:
    """Return the address of what calls a Kernel at the reversed time."""
    return np.array([shipped.address_of("reflect"), 0], dtype=np.int64)


@lru_cache(maxsize=256)
def _prepare(place: int) -> Callable[[int, int], None]:
    return _PREPARE(place)


def tables_of(
    sampled: Sequence[tuple[np.ndarray, Any]],
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Lay sampled inputs out one after the other, one table for each place in r."""
    tables, knots, cubics = [], [], []
    first = 0
    for columns, samples in sampled:
        number = len(samples.breaks)
        for j, column in enumerate(columns):
            tables.append((column, first, number, 0))
            knots.append(samples.breaks)
            cubics.append(samples.coefficients[:, ::-1, j])
            cubics.append([[samples.last[j], 0.0, 0.0, 0.0]])
            first += number
    if not tables:
        return _NO_TABLES
    return np.array(tables, dtype=np.int64), np.concatenate(knots), np.concatenate(cubics)


# -- Python functions ------------------------------------------------------------------------------


class Callback:
    """A Python function as a native one.

    Compiled code copies the time and the state into a buffer, calls the object, and copies the
    values back. Whatever the call raises, also before its first instruction (a signal handler's
    exception, a full stack), stays set in the thread, and the entry that was called raises it.
    A callback of ctypes would print it and go on.

    The `function` of a state and time returns so many `outputs`, called `what` in messages;
    interrupts are looked at before each call. The `place` has the address of the native function,
    whose constants are c. Where a step ends at a jump of sampled inputs, the function gets the last
    number before, `until`.
    """

    def __init__(
        self,
        function: Callable[..., Any],
        n: int,
        outputs: int,
        what: str,
        interrupts: Interrupts,
    ) -> None:
        self._function = function
        self._outputs = outputs
        self._shape = (outputs,)
        self._what = what
        self._interrupts = interrupts
        self._buffer = np.zeros(1 + n + outputs)  # time, state, values
        self.until = np.array([np.inf])
        self._x, self._out = self._buffer[1 : 1 + n], self._buffer[1 + n :]
        self.place = address(_python_addresses())
        self.c = np.array([id(self), address(self._buffer), n, outputs]).view(float)

    def __call__(self) -> None:
        """Compute the values in the buffer from the time and the state there."""
        self._interrupts.check()
        found = self._function(self._x.copy(), min(float(self._buffer[0]), float(self.until[0])))
        # Assigning would broadcast what is too short, read text, and drop imaginary parts.
        if type(found) is not np.ndarray or found.dtype != float or found.shape != self._shape:
            found = vector(found, self._outputs, self._what)
        self._out[:] = found


def switching(call: KernelCall, times: np.ndarray, options: Options) -> KernelCall:
    """Return a call that knows when its Kernel switches by time alone, at times of a run.

    A warning says if these times are too many, unless the steps are shorter than their distances.
    """
    found = call.switch_times(float(times[0]), float(times[-1]))
    if found is None:
        return call
    longest = options.max_step if options.step is None else options.step
    if found.unresolved * longest > abs(times[-1] - times[0]):
        sign = 1.0 if call.kernel.negated is None else -1.0
        warn_user(
            f"A load or rate switches by time alone {found.unresolved} times or more from t = "
            f"{sign * times[0]:.6g} to {sign * times[-1]:.6g}: too often for steps to end at each, "
            "so that a step may pass over a pulse. Pass a `max_step` that is shorter than the "
            "shortest pulse."
        )
    return replace(call, switched=found.rows)


def jumps_in(call: KernelCall) -> np.ndarray:
    """Return when the sampled inputs of a call jump, and when its Kernel switches, if known."""
    jumps = jumps_of(call.sampled) if call.sampled else NO_JUMPS
    return jumps if call.switched is None else merged_jumps([jumps, call.switched])


def problem_of(called: Bound | Callback, n: int, call: KernelCall | None) -> Problem:
    """Return the `Problem` of a native function, with the numeric inputs of its `call`."""
    sampled: Sequence[tuple[np.ndarray, Any]] = ()
    r, jumps, switched = np.zeros(1), NO_JUMPS, 0
    if call is not None and call.inputs is None:
        r, sampled = np.array(call.r if len(call.r) else r, dtype=float), call.sampled
    if call is not None:
        jumps, switched = jumps_in(call), 0 if call.switched is None else len(call.switched)
    words = np.array([called.place, n, blocks(n), n, blocks(n), switched, 0])
    until = np.array([np.inf])
    if isinstance(called, Callback):
        called.until = until
    return Problem(words, np.zeros(1), r, called.c, *tables_of(sampled), jumps, until)
