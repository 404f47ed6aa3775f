"""The compiled form of a Program: what solvers, sweeps and right-hand sides call."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from pydy._graph import TimeSwitches
from pydy._program import Program, SwitchTimes

if TYPE_CHECKING:
    from pydy.inputs import SampledInput

Sweep = Callable[..., tuple[np.ndarray, np.ndarray, bool]]
# ``(x, t, r, p, out)``, arrays but for t.
Call = Callable[[np.ndarray, float, np.ndarray, np.ndarray, np.ndarray], int]


class NativeFunctions(Protocol):
    """Native functions that are compiled when they are first wanted."""

    # (2,): the addresses of ``kernel`` and ``prepare``, zero before `link`. Who calls them reads
    # them here, each time: others may take their place.
    addresses: np.ndarray

    def link(self) -> None:
        """Compile the functions unless they are there."""


@dataclass(frozen=True, eq=False)
class Kernel:
    """A compiled Program: machine code, or functions of NumPy."""

    program: Program
    # ``sweep(t, x, r, p) -> (out, failed, finite)`` over m samples; t (m,), x (m, n), r (m, s) or
    # (1, s) for all samples alike, p (k,), all of them float64, t and p contiguous. `failed` marks
    # the samples whose linear solve was singular; `finite` tells whether all results are: native
    # sweeps look at them while they are in the cache. Native ones also take the array to write to
    # as a fifth argument, with contiguous rows, or columns if they have several lanes.
    sweep: Sweep
    # ``gate(x, t, r, p, out) -> int`` for one state. There is no checking beyond what keeps it
    # safe: −1 asks the caller to convert its arguments and use `at`, otherwise it is the bit mask
    # of failed lanes. Before `functions.link` it answers −1.
    gate: Call
    rebuild: Callable[..., Kernel]  # ``rebuild(program, *recipe)`` gives it where it is unpickled
    recipe: tuple[object, ...] = ()
    lanes: int = 1  # how many states one native call takes
    # They own the machine code; None for a back end without native code.
    functions: NativeFunctions | None = field(default=None, repr=False)
    size_of_c: int = 0  # how many numbers native code computes of constants alone, for each lane
    # Of the reflection of a Kernel in time (`pydy.solvers.reflection`), which is called at s = −t:
    # how many outputs, the first ones, change their sign. The functions are those of the Kernel.
    negated: int | None = None

    def __reduce__(self) -> tuple[Callable[..., Kernel], tuple[object, ...]]:
        return (self.rebuild, (self.program, *self.recipe))

    def __copy__(self) -> Kernel:
        return self

    def __deepcopy__(self, memo: dict[int, object]) -> Kernel:
        return self  # a Kernel never changes

    @property
    def call(self) -> Call:
        """The call gate, bound to code that is compiled now if necessary."""
        self.link()
        return self.gate

    def link(self) -> None:
        """Compile the native functions unless they are there."""
        if self.functions is not None:
            self.functions.link()

    def at(self, x: np.ndarray, t: float, r: np.ndarray, p: np.ndarray, out: np.ndarray) -> int:
        """Evaluate one state; return 1 where a linear solve is singular, else 0."""
        status = self.gate(x, t, r, p, out)
        if status < 0:  # or not compiled yet
            values, failed = self.evaluate(np.array([t]), x[None], r[None], p)
            out[:], status = values[0], int(failed[0])
        return status

    def time_switches(self, varying: frozenset[int]) -> TimeSwitches | None:
        """Return what switches by time alone, if anything does, where these inputs r vary."""
        stored: dict[frozenset[int], TimeSwitches | None] = self.__dict__.setdefault(
            "_time_switches", {}
        )
        if varying not in stored:
            # Of a Tangent: the rates, which come with what all their derivatives need.
            program = getattr(self.program, "shared", self.program)
            values = program.outputs[: getattr(self.program, "values", None)]
            stored[varying] = TimeSwitches.of(program, varying, values)
        return stored[varying]

    @property
    def addresses(self) -> np.ndarray | None:
        """The addresses of the native functions ``kernel`` and ``prepare``, shape (2,), or None."""
        functions = self.functions
        if functions is not None and not functions.addresses[0]:
            functions.link()
        return None if functions is None else functions.addresses

    def evaluate(
        self,
        t: np.ndarray,
        x: np.ndarray,
        r: np.ndarray,
        p: np.ndarray,
        out: np.ndarray | None = None,
    ) -> tuple[np.ndarray, np.ndarray]:
        """Evaluate m samples, into `out` where the Kernel is native; see `sweep`."""
        results = self.sweep(t, x, r, p) if out is None else self.sweep(t, x, r, p, out)
        return results[:2]


@dataclass(frozen=True, eq=False)
class Inputs:
    """The specifieds as numbers, samples and functions, which give the array r."""

    values: np.ndarray  # (s,): those that are numbers; anything elsewhere
    # Sampled data, with their places in r.
    sampled: tuple[tuple[np.ndarray, SampledInput], ...] = ()
    functions: tuple[tuple[np.ndarray, Any], ...] = ()  # of ``function(x, t)``, with a `label`

    @property
    def constant(self) -> bool:
        """Whether r is the same at every state and time."""
        return not self.sampled and not self.functions

    @property
    def changing(self) -> set[int]:
        """The places in r of samples and functions."""
        return {k for c, _ in (*self.sampled, *self.functions) for k in c.tolist()}

    def __call__(self, x: np.ndarray, t: float) -> np.ndarray:
        """Return a fresh array of all specifieds at a state and time, shape (s,)."""
        r = self.values.copy()
        for columns, samples in self.sampled:
            r[columns] = samples.at(t)
        for columns, function in self.functions:
            r[columns] = function(x, t)
        return r

    def rows(self, x: np.ndarray, t: np.ndarray) -> np.ndarray:
        """Return r for m states and times: shape (1, s) when it is the same for all, or (m, s)."""
        if self.constant:
            return self.values[None].copy()
        r = np.tile(self.values, (len(t), 1))
        for columns, samples in self.sampled:
            r[:, columns] = samples.rows(t)
        for columns, function in self.functions:
            values_at = getattr(function, "values_at", None)
            if values_at is not None:
                r[:, columns] = values_at(t)
                continue
            for k, instant in enumerate(t):
                r[k, columns] = function(x[k], float(instant))
        return r

    def slopes(self, t: float) -> np.ndarray:
        """Return the derivatives of the specifieds by time: of samples, and zero of numbers."""
        slopes = np.zeros(len(self.values))
        for columns, samples in self.sampled:
            slopes[columns] = samples.slopes_at(t)
        return slopes


@dataclass(frozen=True, eq=False)
class KernelCall:
    """A right-hand side: a Kernel with its constants and inputs.

    Functions that stand for one have an attribute ``native``, which takes the solver's ``args``
    and returns this, or None where the function itself has to be called. A call stands for itself.
    """

    kernel: Kernel
    p: np.ndarray  # (k,)
    inputs: Inputs  # native loops compute numbers and samples themselves, and call functions
    names: Callable[[], tuple[str, ...]] = tuple  # returns the names of the states
    jacobian: Callable[[], Kernel] | None = None  # returns the Kernel of ∂f/∂x
    # (k, 3): when the Kernel switches by time alone, as `SwitchTimes.rows`; None: not known yet
    switched: np.ndarray | None = None

    def native(self, args: tuple[object, ...]) -> KernelCall:
        """Return itself, whatever the solver's `args`."""
        return self

    def __call__(self, x: np.ndarray, t: float, *args: object) -> np.ndarray:
        """Return the derivatives; NaN where a linear solve is singular."""
        return self.evaluate(self.kernel, np.asarray(x), t)

    def input_slopes(self, x: np.ndarray, t: float, step: float) -> np.ndarray:
        """Return the derivatives of the inputs along the motion, of functions over a `step`."""
        inputs = self.inputs
        slopes = inputs.slopes(t)
        if inputs.functions:
            later = t + step
            after = x + (later - t) * self(x, t)
            for columns, function in inputs.functions:
                change = np.asarray(function(after, later)) - function(x, t)
                slopes[columns] = change / (later - t)
        return slopes

    def switch_times(self, start: float, end: float) -> SwitchTimes | None:
        """Return when the Kernel switches by time alone within an interval; None: never."""
        switches = self.kernel.time_switches(frozenset(self.inputs.changing))
        if switches is None:
            return None
        if self.kernel.negated is None:
            return switches.times(self.p, self.inputs.values, start, end)
        # As the motion in reversed time.
        found = switches.times(self.p, self.inputs.values, -end, -start)
        return SwitchTimes(0.0 - found.rows[::-1][:, [0, 2, 1]], found.unresolved)

    def evaluate(self, kernel: Kernel, x: np.ndarray, t: float) -> np.ndarray:
        """Evaluate another Kernel of the same system at a state and time.

        It may have fewer states and specifieds than this one: those that come first.
        """
        signature = kernel.program.signature
        x, r = x[: signature.num_states], self.inputs(x, t)[: signature.num_specifieds]
        out = np.empty(signature.num_outputs)
        kernel.at(x, t, r, self.p, out)
        return out
