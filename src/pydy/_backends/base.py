"""The contract of a back end.

A back end is a class with one method::

    class MyBackend:
        def __init__(self, **options): ...
        def compile(self, program: Program) -> Kernel: ...

Its options are the keyword arguments that `generate_ode_function` does not know. Register it with
`pydy._backends.registry.register`, or pass the class itself as ``generator=``.
"""

from __future__ import annotations

from typing import Any, Protocol

from pydy._graph.program import Program
from pydy._kernel import Kernel

__all__ = ["Backend"]


class Backend(Protocol):
    """What `generator=` accepts."""

    def __init__(self, **options: Any) -> None: ...

    def compile(self, program: Program) -> Kernel:
        """Return the Kernel that computes `program`."""
        ...
