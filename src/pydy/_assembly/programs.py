"""The Programs of an Assembly."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar, cast

from pydy._assembly.assembly import Assembly
from pydy._assembly.program_cache import stored_program
from pydy._program import Program, Tangent

_T = TypeVar("_T", bound="Program | Tangent")


class Programs:
    """The Programs of an Assembly, each lowered when first asked for, or read from the cache."""

    def __init__(self, assembly: Assembly) -> None:
        self._assembly = assembly
        self._programs: dict[str, Program | Tangent] = {}

    def of(self, *blocks: str) -> Program:
        """Return the Program of some blocks of the assembly."""
        # What is made from the bodies has no fingerprint.
        storable = "kinetic_hessian" not in blocks
        return self._program(", ".join(blocks), lambda: self._assembly.program(*blocks), storable)

    def given_accelerations(self, *blocks: str) -> Program:
        """Return the Program of blocks that takes accelerations; see `Assembly.open_program`."""
        what = f"{', '.join(blocks)} given accelerations"
        return self._program(what, lambda: self._assembly.open_program(*blocks))

    def bounded(self, block: str) -> Program:
        """Return the Program of a block and its rounding bounds; see `Assembly.lowered`."""
        what = f"{block}, bounded"
        return self._program(what, lambda: self._assembly.program(block, bounded=block))

    def jacobian(self, block: str, by: str | tuple[tuple[str, int], ...]) -> Program:
        """Return the Program of a Jacobian; see `Assembly.jacobian_program`."""
        return self._program(f"{block} by {by}", lambda: self._assembly.jacobian_program(block, by))

    def jacobian_in_parts(
        self, block: str, by: str | tuple[tuple[str, int], ...]
    ) -> Program | Tangent:
        """Return a Jacobian; see `Assembly.jacobian_in_parts`."""
        what = f"{block} by {by}, in parts"
        return self._program(what, lambda: self._assembly.jacobian_in_parts(block, by))

    def _program(self, what: str, make: Callable[[], _T], storable: bool = True) -> _T:
        """Return the result of `make`, called at most once, or the cache's if it is `storable`."""
        known = self._programs.get(what)
        if known is None:
            known = stored_program(self._assembly, what, make) if storable else make()
            self._programs[what] = known
        return cast("_T", known)
