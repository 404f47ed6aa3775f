"""The quantities of a trajectory: their symbols by kind, found by symbol or by name."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from typing import Any

from pydy._checks import check_mapping, choice, listed
from pydy._dataset import KINDS
from pydy._names import latex_of, latex_of_rate, name_of, nearest, unique_names, written_out

__all__ = ["Columns"]


class Columns:
    """Symbols of columns, in the order of their kinds.

    Parameters
    ----------
    symbols : mapping of str to sequence of symbols
        By kind; as for `pydy.trajectory.Trajectory`.

    Attributes
    ----------
    kinds : dict of str to tuple of symbols
    symbols : list
        All of them.
    names : tuple of str
        Of all of them.
    latex_by_name : dict of str to str
        What is known of it already.
    """

    def __init__(self, symbols: Mapping[str, Sequence[Any]]) -> None:
        given = check_mapping("symbols", symbols)
        self.kinds = {
            kind: tuple(listed(f"symbols[{kind!r}]", given.get(kind, ()), hashable=True))
            for kind in KINDS
        }
        self.symbols = list(self.of(*KINDS))
        self.names = unique_names(self.symbols)
        self.latex_by_name: dict[str, str] = {}
        self._place = {s: k for k, s in reversed(list(enumerate(self.symbols)))}
        self._place_of_name = {n: k for k, n in enumerate(self.names)}

    def of(self, *kinds: str) -> tuple[Any, ...]:
        """Return the symbols of some kinds, in the order in which the kinds are given."""
        return tuple(s for kind in kinds for s in self.kinds[kind])

    def names_of(self, *kinds: str) -> tuple[str, ...]:
        """Return the names of the quantities of some kinds, in the order of the columns."""
        for kind in kinds:
            choice(kind, KINDS, "`kinds`")
        all_kinds = [kind for kind in KINDS for _ in self.kinds[kind]]
        return tuple(n for n, k in zip(self.names, all_kinds, strict=True) if k in kinds)

    def latex(self, key: Any) -> str:
        """Return the LaTeX of a quantity's symbol."""
        k = self.find(key)
        if self.names[k] not in self.latex_by_name:
            self.latex_by_name[self.names[k]] = latex_of(self.symbols[k])
        return self.latex_by_name[self.names[k]]

    def latex_of_rate(self, key: Any) -> str:
        """Return the LaTeX of a quantity's derivative by time."""
        k = self.find(key)
        name = f"{self.names[k]}'"
        if name not in self.latex_by_name:
            self.latex_by_name[name] = latex_of_rate(self.symbols[k])
        return self.latex_by_name[name]

    def find(self, key: Any) -> int:
        """Return the position of a quantity, given its symbol or its name."""
        k = self._place.get(key) if isinstance(key, Hashable) else None
        if k is None:
            k = self._place_of_name.get(name_of(key))
            if k is None and isinstance(key, str):  # as a symbol is printed: 'q1(t)'
                alike = [j for j, s in enumerate(self.symbols) if str(s) == key]
                k = alike[0] if len(alike) == 1 else None
            own = None if k is None else self.symbols[k]
            symbols = own is not None and str not in (type(own), type(key))
            if symbols and own != key and str(own) == str(key):
                raise KeyError(
                    f"`{written_out(key)}` is not one of the trajectory's quantities: "
                    f"`{written_out(own)}` is another symbol, because its assumptions differ. "
                    "Use that one, or its name."
                )
        if k is None:
            raise KeyError(
                f"`{key}` is not one of the trajectory's quantities: {', '.join(self.names)}. "
                f"{nearest(str(key), self.names, or_all=False)}".rstrip()
            )
        return k

    def __contains__(self, key: Any) -> bool:
        return key in self._place or name_of(key) in self._place_of_name
