"""The contract of a back end.

A back end is a class with one method::

    class MyBackend:
        def __init__(self, **options): ...
        def compile(self, program: Program) -> Kernel: ...

An attribute ``force_c_contiguous``, if it has one, says whether a generated function copies states
that are not contiguous (True, as without it) or refuses them (False); None leaves it to the caller.

Its options are the keyword arguments that `generate_ode_function` does not know. Register it with
`pydy._backends.registry.register`, or pass the class itself as ``generator=``.
"""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np

from pydy._graph.program import Program
from pydy._kernel import Kernel

__all__ = ["Backend", "strict"]


class Backend(Protocol):
    """What `generator=` accepts."""

    def __init__(self, **options: Any) -> None: ...

    def compile(self, program: Program) -> Kernel:
        """Return the Kernel that computes `program`."""
        ...


def strict(program: Program, x: Any, r: Any, p: Any) -> bool:
    """Tell whether arguments are float64 vectors of a Program's own lengths."""
    sizes = (program.num_states, program.num_specifieds, program.num_constants)
    return all(
        type(a) is np.ndarray
        and a.dtype == np.float64
        and a.shape == (size,)
        and a.flags.c_contiguous
        for a, size in zip((x, r, p), sizes, strict=True)
    )
