"""Warn once of curves of muscles whose coefficients have no value."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from pydy._assembly import Definition
from pydy._errors import warn_user

if TYPE_CHECKING:
    import sympy as sm


def warn_of_curves(
    definition: Definition,
    coefficients: Sequence[sm.Symbol],
    given: Iterable[Any],
    already_warned: set[Any],
) -> None:
    """Warn once of `coefficients` of characteristic curves that are constants but not `given`.

    A musculotendon of SymPy that is made without `with_defaults` has symbols for them. Like other
    constants these are 1, but no curve of a muscle has such coefficients.
    """
    if already_warned.issuperset(coefficients):
        return
    constants = definition.places["constants"]
    known = {constants.get(key, "constants") for key in given}
    columns = [(symbol, constants.get(symbol, "constants")) for symbol in coefficients]
    missing = [str(symbol) for symbol, k in columns if k is not None and k not in known]
    if missing:
        already_warned.update(coefficients)
        more = f" and {len(missing) - 3} more" if missing[3:] else ""
        warn_user(
            f"`constants` has no value for {', '.join(missing[:3])}{more}, coefficients of "
            "muscles' curves. They are therefore 1, as no muscle has them. Make the "
            "musculotendon by `with_defaults`, which has the published coefficients, or "
            "give them values."
        )
