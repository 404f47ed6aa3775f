"""Right-hand sides as compiled solvers call them: an address, and the arrays that belong to it."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

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

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from pydy.inputs import SampledInput

_NO_TABLES = np.zeros((0, 4), dtype=np.int64), np.zeros(0), np.zeros((0, 4))

NO_JUMPS = np.zeros((0, 3))

_PREPARE = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p)


def block_count(n: int) -> int:
    """Return how many blocks hold n numbers."""
    return -(-n // BLOCK)


class KernelBinding:
    """A native Kernel with its array c, what it computes from the constants alone.

    Compiled code is given the `address_slot`, the address of an array of two addresses: of the
    Kernel, and of the function that computes c.
    """

    def __init__(self, kernel: Kernel, p: np.ndarray) -> None:
        addresses = kernel.addresses
        assert addresses is not None
        self._kernel, self._addresses = kernel, addresses  # they keep the code loaded
        self.address_slot, first = address(addresses), 0
        size = max(1, kernel.size_of_c)
        if kernel.negated is not None:
            self.address_slot, first = address(_reflecting_addresses()), REFLECTED
        self.c = np.zeros(first + size)
        if kernel.negated is not None:
            self.c[:2] = np.array([address(addresses), kernel.negated]).view(float)
        self._p = np.empty(np.shape(p))
        self._arguments = address(self._p), address(self.c) + 8 * first
        self.set_constants(p)

    def set_constants(self, p: np.ndarray) -> None:
        """Compute the array c from constants p."""
        self._p[:] = p
        _prepare(int(self._addresses[1]))(*self._arguments)


def aligned_zeros(*shape: int) -> np.ndarray:
    """Return zeros aligned to a cache line, so that no block lies across two lines."""
    size = math.prod(shape)
    padded = np.zeros(size + BLOCK)
    first = -address(padded) % 64 // 8
    return padded[first : first + size].reshape(shape)


@once
def _python_addresses() -> np.ndarray:
    """Return the address of the function that calls Python, in an array as Kernels have it."""
    return np.array([gates().code.addresses["call_python"]], dtype=np.int64)


@once
def _reflecting_addresses() -> np.ndarray:
    """Return the address of the function that calls a Kernel at the reversed time."""
    return np.array([shipped.address_of("reflect"), 0], dtype=np.int64)


@lru_cache(maxsize=256)
def _prepare(entry: int) -> Callable[[int, int], None]:
    return _PREPARE(entry)


def sampled_input_tables(
    sampled: Sequence[tuple[np.ndarray, SampledInput]],
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Concatenate sampled inputs, with one table for each column of r."""
    tables, knots, cubics = [], [], []
    first = 0
    for columns, samples in sampled:
        number = len(samples.breaks)
        for j, column in enumerate(columns):
            tables.append((column, first, number, 0))
            knots.append(samples.breaks)
            cubics.append(samples.coefficients[:, ::-1, j])
            cubics.append(np.array([[samples.last[j], 0.0, 0.0, 0.0]]))
            first += number
    if not tables:
        return _NO_TABLES
    return np.array(tables, dtype=np.int64), np.concatenate(knots), np.concatenate(cubics)


# -- Python functions ------------------------------------------------------------------------------


class Callback:
    """A Python function that compiled code can call.

    Compiled code copies the time and the state into a buffer, calls the object, and copies the
    values back. An exception of the call, even one before its first instruction (from a signal
    handler, or a full stack), stays set in the thread, and the entry that was called raises it.
    A callback of ctypes would print it and continue.

    The `function` of a state and time returns so many `outputs`, called `label` in messages;
    interrupts are checked before each call. The `address_slot` is that of the native function,
    whose constants are c. If a step ends at a jump of sampled inputs, the function gets the last
    time before it, `until`.
    """

    def __init__(
        self,
        function: Callable[..., ArrayLike],
        n: int,
        outputs: int,
        label: str,
        interrupts: Interrupts,
    ) -> None:
        self._function = function
        self._outputs = outputs
        self._shape = (outputs,)
        self._label = label
        self._interrupts = interrupts
        self._buffer = np.zeros(1 + n + outputs)  # time, state, values
        self.until = np.array([np.inf])
        self._x, self._out = self._buffer[1 : 1 + n], self._buffer[1 + n :]
        self.address_slot = address(_python_addresses())
        self.c = np.array([id(self), address(self._buffer), n, outputs]).view(float)

    def __call__(self) -> None:
        """Compute the values in the buffer from the time and the state there."""
        self._interrupts.check()
        values = self._function(self._x.copy(), min(float(self._buffer[0]), float(self.until[0])))
        # Assignment would broadcast short arrays, parse text, and drop imaginary parts.
        if type(values) is not np.ndarray or values.dtype != float or values.shape != self._shape:
            values = vector(values, self._outputs, self._label)
        self._out[:] = values


def with_switch_times(call: KernelCall, times: np.ndarray, options: Options) -> KernelCall:
    """Return a call with the times of a run at which its Kernel switches by time alone.

    Warns if they are too many, unless the steps are shorter than their distances.
    """
    switches = call.switch_times(float(times[0]), float(times[-1]))
    if switches is None:
        return call
    longest = options.max_step if options.step is None else options.step
    if switches.unresolved * longest > abs(times[-1] - times[0]):
        sign = 1.0 if call.kernel.negated is None else -1.0
        warn_user(
            f"A load or rate switches by time alone {switches.unresolved} times or more from t = "
            f"{sign * times[0]:.6g} to {sign * times[-1]:.6g}: too often for steps to end at each, "
            "so that a step may pass over a pulse. Pass a `max_step` that is shorter than the "
            "shortest pulse."
        )
    return replace(call, switched=switches.rows)


def jumps_of_call(call: KernelCall) -> np.ndarray:
    """Return the jumps of sampled inputs and the known switches of the Kernel."""
    sampled = call.inputs.sampled
    jumps = jumps_of(sampled) if sampled else NO_JUMPS
    return jumps if call.switched is None else merged_jumps([jumps, call.switched])


def problem_arrays(binding: KernelBinding | Callback, n: int, call: KernelCall | None) -> Problem:
    """Return the `Problem` of a native function, with the numeric inputs of its `call`."""
    sampled: Sequence[tuple[np.ndarray, SampledInput]] = ()
    r, jumps, switched = np.zeros(1), NO_JUMPS, 0
    if call is not None and not call.inputs.functions:
        values, sampled = call.inputs.values, call.inputs.sampled
        r = np.array(values if len(values) else r, dtype=float)
    if call is not None:
        jumps, switched = jumps_of_call(call), 0 if call.switched is None else len(call.switched)
    words = np.array([binding.address_slot, n, block_count(n), n, block_count(n), switched, 0])
    until = np.array([np.inf])
    if isinstance(binding, Callback):
        binding.until = until
    return Problem(words, np.zeros(1), r, binding.c, *sampled_input_tables(sampled), jumps, until)
