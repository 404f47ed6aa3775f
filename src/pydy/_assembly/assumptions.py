"""Whether numbers agree with the assumptions that their symbols were made with.

SymPy simplifies by them: with a positive w, ``sqrt(w**2)`` is w. Where a number contradicts the
assumption, so does the equation. Zero is the limit of what is positive: gravity that is turned off,
a body at rest; it is not reported.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pydy._assembly.tuning import GLOBAL_ERRORS, OF_RANGE
from pydy._errors import warn_user
from pydy._names import some

Excess = Callable[[np.ndarray], np.ndarray]

# How far values are beyond an assumption, by the property of SymPy that says it; an assumption that
# implies others stands before them.
_RULES: dict[str, tuple[str, Excess]] = {
    "is_zero": ("is zero", np.abs),
    "is_imaginary": ("is imaginary", np.abs),
    "is_nonnegative": ("cannot be negative", lambda v: -v),
    "is_nonpositive": ("cannot be positive", lambda v: v),
    "is_even": ("is an even number", lambda v: np.abs(v - 2.0 * np.rint(v / 2.0))),
    "is_odd": ("is an odd number", lambda v: np.abs(v - 1.0 - 2.0 * np.rint((v - 1.0) / 2.0))),
    "is_nonzero": ("cannot be zero", lambda v: np.where(v == 0.0, np.inf, -np.inf)),
    "is_integer": ("is an integer", lambda v: np.abs(v - np.rint(v))),
}
_IMPLIED = {
    "is_zero": frozenset(_RULES),
    "is_nonnegative": frozenset({"is_nonzero"}),
    "is_nonpositive": frozenset({"is_nonzero"}),
    "is_even": frozenset({"is_integer"}),
    "is_odd": frozenset({"is_integer", "is_nonzero"}),
}


@dataclass(frozen=True)
class Contradiction:
    """A value that contradicts an assumption."""

    column: int
    name: str
    value: float
    row: int  # of the values
    words: str

    def warn(self, what: str, where: str, others: Iterable[Contradiction]) -> None:
        """Warn of it, and name the others."""
        more = [c.name for c in others]
        also = f" The same holds for {some(more)}." if more else ""
        warn_user(
            f"{what}`{self.name}` is {self.value:g}{where}, but its symbol was made as one that "
            f"{self.words}: equations that SymPy simplified under this assumption may be wrong. "
            f"Make the symbol without that assumption.{also}"
        )


@dataclass(frozen=True)
class Assumptions:
    """The assumptions on the values of some symbols, which are columns of arrays."""

    names: tuple[str, ...]
    rules: tuple[tuple[int, str], ...]  # columns, and keys of `_RULES`

    @classmethod
    def of(cls, symbols: Sequence[Any]) -> Assumptions | None:
        """Return the assumptions of some symbols, None where there are none."""
        rules: list[tuple[int, str]] = []
        for k, symbol in enumerate(symbols):
            implied: frozenset[str] = frozenset()
            for rule in _RULES:
                if rule not in implied and getattr(symbol, rule, None):
                    rules.append((k, rule))
                    implied |= _IMPLIED.get(rule, frozenset())
        return cls(tuple(map(str, symbols)), tuple(rules)) if rules else None

    @property
    def columns(self) -> frozenset[int]:
        """The columns of which something is assumed."""
        return frozenset(k for k, _ in self.rules)

    def contradictions(
        self,
        values: np.ndarray,
        allowed: np.ndarray | float = 0.0,
        *,
        in_time: bool = False,
        columns: Iterable[int] | None = None,
    ) -> list[Contradiction]:
        """Return the largest contradiction of each column of values, shape (m, k).

        What is `allowed`, for all columns or each, is put down to rounding or a solver's errors.
        Rows may be `in_time`: then a value that changes its sign was zero in between.
        """
        found: dict[int, Contradiction] = {}
        margins = np.broadcast_to(allowed, values.shape[1:])
        wanted = self.columns if columns is None else {*columns}
        for column, rule in self.rules:
            if column not in wanted or column in found:
                continue
            words, excess = _RULES[rule]
            own, margin = values[:, column], float(margins[column])
            finite = np.isfinite(own)
            beyond = np.where(finite, excess(np.where(finite, own, 0.0)), -np.inf)
            row = int(beyond.argmax()) if beyond.size else 0
            if rule == "is_nonzero" and in_time and beyond.size and beyond[row] < 0.0:
                row = _crossing(np.where(finite, own, 0.0), margin)
                if row < 0:
                    continue
            elif not (beyond.size and beyond[row] > margin):
                continue
            found[column] = Contradiction(column, self.names[column], float(own[row]), row, words)
        return [*found.values()]

    def suspects(self, values: np.ndarray) -> np.ndarray:
        """Return which of m motions, shape (k, m, times), may contradict an assumption at all."""
        found = np.zeros(values.shape[1], dtype=bool)
        for column, rule in self.rules:
            own = np.where(np.isfinite(values[column]), values[column], 0.0)
            found |= (_RULES[rule][1](own) > 0.0).any(axis=-1)
            if rule == "is_nonzero":
                found |= (own < 0.0).any(axis=-1) & (own > 0.0).any(axis=-1)
        return np.flatnonzero(found)

    def tell(
        self,
        values: np.ndarray,
        told: set[str],
        what: str,
        *,
        where: Callable[[int], str] = lambda row: "",
        **options: Any,
    ) -> None:
        """Warn once of the columns of values (m, k) that contradict; `told` has the known names."""
        new = [c for c in self.contradictions(values, **options) if c.name not in told]
        if new:
            told.update(c.name for c in new)
            new[0].warn(what, where(new[0].row), new[1:])


def _crossing(values: np.ndarray, margin: float) -> int:
    """Return where a value surely has the other sign than at first, or -1."""
    sure = np.flatnonzero(np.abs(values) > margin)
    other = sure[np.sign(values[sure]) != np.sign(values[sure[0]])] if sure.size else sure
    return int(other[0]) if other.size else -1


def errors_of(values: np.ndarray, rtol: Any = 0.0, atol: Any = 0.0) -> np.ndarray:
    """Return by how much values (m, k) along a computed motion may be in error.

    Many times the error allowed in a step, which adds up, but no larger share of a value's range
    than matters; never less than `atol`, below which a solver resolves nothing.
    """
    size = np.abs(np.where(np.isfinite(values), values, 0.0)).max(axis=0, initial=0.0)
    summed = GLOBAL_ERRORS * (np.asarray(atol) + np.asarray(rtol) * size)
    found: np.ndarray = np.minimum(summed, np.maximum(atol, OF_RANGE * size))
    return found
