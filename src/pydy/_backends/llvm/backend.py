"""The default back end: straight-line LLVM IR for a Program, compiled in the process.

No compiler is needed on the user's machine.
"""

from __future__ import annotations

from typing import Any

from pydy._backends.llvm.ir import WIDTHS
from pydy._backends.llvm.native import native_kernel
from pydy._backends.llvm.tiers import Entry, tiers_of, wide_code
from pydy._backends.registry import compile_program
from pydy._graph.program import Program
from pydy._graph.tangent import Tangent
from pydy._kernel import Kernel


class LLVMBackend:
    """Compiles Programs with LLVM.

    Parameters
    ----------
    cse : bool, optional
        Accepted for scripts that pass it; common sub-expressions are always shared.
    lanes : {1, 2, 4, 8}, optional
        How many states the native code takes at once. Right-hand sides for Python need 1.
    width : {2, 4, 8}, optional
        How many of several lanes the equations' code takes at once; the rest follow in further
        turns. By default what suits the processor's registers. It does not change the bits.
    """

    tangents = True  # see `base`

    def __init__(self, cse: bool = True, lanes: int = 1, width: int | None = None) -> None:
        if lanes not in WIDTHS:
            raise ValueError(f"`lanes` is {lanes!r}, but it must be 1, 2, 4 or 8.")
        if width is not None and (width not in WIDTHS[1:] or width > lanes):
            raise ValueError(f"`width` is {width!r}, but it must be 2, 4 or 8 and at most `lanes`.")
        self.options: dict[str, Any] = {"cse": cse, "lanes": lanes}
        if width is not None:
            self.options["width"] = width

    def compile(self, program: Program | Tangent) -> Kernel:
        """Return the Kernel of a Program or Tangent.

        Nothing is compiled before the Kernel is called or asked for its best code; see `tiers`.
        Wide kernels get the best at once.
        """
        lanes: int = self.options["lanes"]
        recipe = ("llvm", self.options)
        if lanes == 1:
            return native_kernel(program, Entry(tiers_of(program)), 1, compile_program, recipe)
        code = wide_code(program, lanes, self.options.get("width"))
        entry = Entry()
        entry.replace((code.addresses["kernel"], code.addresses["prepare"]), code)
        strided = code.addresses.get("strided", 0)
        return native_kernel(program, entry, lanes, compile_program, recipe, strided)
