"""The 'lambdify' generator: a Program evaluated by NumPy, without any compiler."""

from __future__ import annotations

from functools import partial

from pydy._backends.base import kernel_of
from pydy._kernel import Kernel
from pydy._program import Program, ScipyOperation, run


class NumPyStandIn:
    """NumPy in place of LLVM, with LLVM's options: those that concern machine code do nothing."""

    def __init__(self, cse: bool = True, lanes: int = 1, width: int | None = None) -> None:
        self._backend = NumPyBackend(cse)

    def compile(self, program: Program) -> Kernel:
        """Return a Kernel of NumPy's back end."""
        return self._backend.compile(program)


class NumPyBackend:
    """Evaluates Programs with NumPy.

    Parameters
    ----------
    cse : bool, optional
        Accepted for scripts that pass it; common sub-expressions are always shared.
    """

    scipy = True  # it evaluates functions that only SciPy computes

    def __init__(self, cse: bool = True) -> None:
        self.options = {"cse": cse}

    def compile(self, program: Program) -> Kernel:
        """Return a Kernel whose sweep is one NumPy call per operation."""
        ScipyOperation.restore(program.ops)
        return kernel_of(program, partial(run, program), "lambdify", self.options)
