"""numba, as the compiled loops are written for it.

numba is needed where the sources change and nowhere else: `tools/solvers_ir.py` has it write the
entries as LLVM IR, which the package ships in `ir/` and compiles for the processor at hand (see
`shipped`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numba

__all__ = ["APART", "OPTIONS", "Entry", "entry", "inlined"]

# Arrays belong to the caller, who outlives the call: no array is made in compiled code, and none
# is counted.
OPTIONS: dict[str, Any] = {"error_model": "numpy", "_nrt": False}


APART: set[str] = set()
"""Names of functions that do not become parts of their callers."""


@dataclass(frozen=True)
class Entry:
    """A function that is called from outside: from Python, or by compiled code by its address.

    Attributes
    ----------
    function : callable
    signature : str
        In numba's words; integers and floats only.
    """

    function: Callable[..., Any]
    signature: str


def entry(signature: str) -> Callable[[Callable[..., Any]], Entry]:
    """Mark a function as an entry."""
    return lambda function: Entry(function, signature)


def inlined(
    function: Callable[..., Any] | None = None,
    *,
    always: bool = False,
    pasted: bool = False,
    apart: bool = False,
) -> Any:
    """Compile a function that other compiled functions call.

    No function's sums may be taken in another order, or its products fused with its sums, but by
    name (`intrinsics`): that would depend on the processor.

    Parameters
    ----------
    function : callable
    always : bool
        It becomes a part of each caller. A call that hands over the tuples of `layout` passes a
        hundred numbers, which takes longer than many a function; LLVM leaves it at that where a
        function is long or has several callers.
    pasted : bool
        Its code becomes a part of each caller before it is compiled: for long functions that have
        one caller, which would be compiled twice.
    apart : bool
        It stays a function: what is rarely called need not be compiled for each caller.
    """
    options = dict(OPTIONS)
    if pasted:
        options["inline"] = "always"
    compile_function: Any = numba.njit(**options, forceinline=always)

    def decorate(function: Callable[..., Any]) -> Any:
        if apart:
            APART.add(function.__name__)
        return compile_function(function)

    return decorate if function is None else decorate(function)
