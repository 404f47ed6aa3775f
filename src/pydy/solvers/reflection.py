"""Backward integration: the motion in reversed time s = −t, which native solvers run forward.

If x' = f(x, t), the reflected motion satisfies dx/ds = −f(x, −s). Times that descend in t ascend in
s, so that the compiled loops integrate forward only. All functions of time are reflected together
with the right-hand side:

- A Kernel is called at −s. Outputs that are derivatives by time change their sign: the rates, their
  Jacobian and the rates of events.
- A sampled input is reflected with its samples, so that it jumps from the other side.
- Functions of the user are called at −s.

Results, records and messages are in the user's own time (`pydy.solvers.run.integration`). The
direction of an event is that along the motion as it is integrated, as in
`scipy.integrate.solve_ivp`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._checks import vector
from pydy._kernel import Inputs, Kernel, KernelCall
from pydy.inputs import SampledInput
from pydy.solvers.compiled_events import CompiledEvents
from pydy.solvers.options import Options
from pydy.solvers.sensitivities import CompiledSensitivities

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from pydy._program import Program


def reversed_times(times: Any) -> Any:
    """Return −t, without a negative zero."""
    return 0.0 - times


def reflected(
    f: Callable[..., ArrayLike], n: int, args: tuple[object, ...], options: Options
) -> tuple[Callable[..., ArrayLike], Options]:
    """Return the right-hand side of n states, and options, of the motion in reversed time.

    Raises
    ------
    ValueError
        An event has a reset, which cannot be undone.
    """
    return _right_hand_side(f, n, args), replace(
        options,
        events=None if options.events is None else _events(options.events),
        constraints=None
        if options.constraints is None
        else replace(options.constraints, kernel=_kernel(options.constraints.kernel, 0)),
        sensitivities=None
        if options.sensitivities is None
        else _sensitivities(options.sensitivities),
    )


# -- the right-hand side ---------------------------------------------------------------------------


def _right_hand_side(
    f: Callable[..., ArrayLike], n: int, args: tuple[object, ...]
) -> Callable[..., ArrayLike]:
    native = getattr(f, "native", None)
    call: KernelCall | None = None if native is None else native(args)
    if call is not None:
        return _call(call)

    def negative(x: np.ndarray, s: float, *args: object) -> np.ndarray:
        rates = f(x, reversed_times(s), *args)
        return -vector(rates, n, "What `f(x, t)` returns, one derivative for each state of `x0`,")

    return negative


def _call(call: KernelCall) -> KernelCall:
    """Return a call of the reflected derivatives, with reflected inputs."""
    jacobian, inputs = call.jacobian, call.inputs
    sampled = tuple((columns, reflected_samples(samples)) for columns, samples in inputs.sampled)
    functions = tuple((columns, _at_reversed(f)) for columns, f in inputs.functions)
    return replace(
        call,
        kernel=_kernel(call.kernel),
        inputs=Inputs(inputs.values, sampled, functions),
        jacobian=None if jacobian is None else lambda: _kernel(jacobian()),
    )


def _at_reversed(function: Callable[..., ArrayLike]) -> Callable[..., ArrayLike]:
    return lambda x, s: function(x, reversed_times(s))


def reflected_samples(samples: SampledInput) -> SampledInput:
    """Return a sampled input as a function of −t; of 'previous' samples, the one before is held."""
    times, values = reversed_times(samples.times[::-1]), samples.values[::-1]
    if samples.interpolation == "previous":
        values = np.concatenate([values[1:], values[-1:]])
    return SampledInput(times, values, samples.interpolation)


# -- Kernels ---------------------------------------------------------------------------------------


def _kernel(kernel: Kernel, negated: int | None = None) -> Kernel:
    """Return a Kernel at −s, of which the first outputs, or all, change their sign.

    A Kernel stores its reflections: caches that use their identity serve the next run too.
    """
    count = kernel.program.signature.blocks[-1].stop if negated is None else negated
    reflections: dict[int, Kernel] = kernel.__dict__.setdefault("_reflections", {})
    if count not in reflections:
        reflections[count] = _rebuilt(kernel.program, kernel, count)
    return reflections[count]


def _rebuilt(program: Program, kernel: Kernel, count: int) -> Kernel:
    def sweep(
        s: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray, *out: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, bool]:
        values, failed, finite = kernel.sweep(reversed_times(s), x, r, p, *out)
        values[:, :count] *= -1.0
        return values, failed, finite

    return Kernel(
        program,
        sweep,
        _no_gate,
        _rebuilt,
        (kernel, count),
        lanes=kernel.lanes,
        functions=kernel.functions,
        size_of_c=kernel.size_of_c,
        negated=count,
    )


def _no_gate(*args: object) -> int:
    return -1  # the caller then evaluates by `sweep`


# -- events and sensitivities ----------------------------------------------------------------------


def _events(events: CompiledEvents) -> CompiledEvents:
    for event in events.traits:
        if event.resets:
            raise ValueError(
                f"`times` descend, but the event `{event.name}` has a reset, which cannot be "
                "undone: the state before it does not follow from that after it. Leave the "
                "`reset` out, or let `times` ascend."
            )
    (rates, *_) = events.rates.program.signature.blocks
    return replace(
        events,
        values=_kernel(events.values, 0),
        rates=_kernel(events.rates, rates.stop),
        # The slopes of the samples are already those in reversed time.
        input_rates=None if events.input_rates is None else _kernel(events.input_rates, 0),
        reach=None if events.reach is None else _kernel(events.reach, 0),
    )


def _sensitivities(sensitivities: CompiledSensitivities) -> CompiledSensitivities:
    def events(event: int) -> tuple[Kernel, Sequence[int]]:
        kernel, changed = sensitivities.events(event)
        return _event(kernel), changed

    return replace(
        sensitivities, events=events, constraints=lambda: _kernel(sensitivities.constraints(), 0)
    )


def _event(kernel: Kernel) -> Kernel:
    """Return the Kernel of an event's effect on derivatives: inputs' slopes change their sign too.

    It is called from Python alone.
    """
    program = kernel.program
    first = program.signature.num_specifieds // 2
    blocks = [b for b in program.signature.blocks if b.name in ("rate", "after_rates")]
    odd = [k for b in blocks for k in range(b.start, b.stop)]

    def sweep(
        s: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, bool]:
        inputs = np.array(r)
        inputs[:, first:] *= -1.0
        values, failed, finite = kernel.sweep(reversed_times(s), x, inputs, p)
        values[:, odd] *= -1.0
        return values, failed, finite

    return replace(kernel, sweep=sweep, gate=_no_gate, functions=None)
