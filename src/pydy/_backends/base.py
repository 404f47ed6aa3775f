"""The contract of a back end.

A back end is a class with one method::

    class MyBackend:
        def __init__(self, **options): ...
        def compile(self, program: Program) -> Kernel: ...

With an attribute ``tangents = True`` it receives derivatives as a `pydy._program.tangent.Tangent`,
whose columns it may compute side by side. Without it all columns are written out in one Program.

The optional attribute ``force_c_contiguous`` says whether a generated function copies states that
are not contiguous (True, the default) or refuses them (False). None leaves it to the caller.

Its options are the keyword arguments that `generate_ode_function` does not know. Register it with
`pydy._backends.registry.register`, or pass the class itself as ``generator=``.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pydy._backends.registry import compile_program
from pydy._kernel import Call, Kernel, Sweep
from pydy._program import Program


def arguments_fit(program: Program, x: Any, r: Any, p: Any) -> bool:
    """Return whether arguments are float64 vectors with the lengths of a Program's inputs."""
    sizes = program.signature.sizes
    return all(
        type(a) is np.ndarray
        and a.dtype == np.float64
        and a.shape == (size,)
        and a.flags.c_contiguous
        for a, size in zip((x, r, p), sizes, strict=True)
    )


def call_of(program: Program, sweep: Sweep) -> Call:
    """Return the `Kernel.gate` of a Program that a sweep evaluates."""

    def call(x: Any, t: Any, r: Any, p: Any, out: np.ndarray) -> int:
        if type(t) is not float or not arguments_fit(program, x, r, p):
            return -1
        values, failed, _ = sweep(np.array([t]), x[None, :], r[None, :], p)
        out[:] = values[0]
        return int(failed[0])

    return call


def kernel_of(
    program: Program,
    evaluate: Callable[..., tuple[np.ndarray, np.ndarray]],
    generator: Any,
    options: dict[str, Any],
) -> Kernel:
    """Return the Kernel of a back end that is written in Python.

    ``evaluate(t, x, r, p)`` takes m samples, t (m,), x (m, n), r (m, s) and p (k,), and returns
    their outputs (m, o) and a mask of the samples whose linear solve was singular. `generator`, the
    name or class of the back end, compiles the Program again, with its `options`, when a Kernel is
    unpickled.
    """

    def sweep(
        t: np.ndarray, x: np.ndarray, r: np.ndarray, p: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, bool]:
        out, failed = evaluate(t, x, np.broadcast_to(r, (len(t), r.shape[1])), p)
        return out, failed, bool(np.isfinite(out).all())

    return Kernel(program, sweep, call_of(program, sweep), compile_program, (generator, options))
