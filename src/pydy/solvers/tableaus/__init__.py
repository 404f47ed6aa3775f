"""Runge–Kutta methods as data, each with its source."""

from __future__ import annotations

from functools import cache
from importlib import import_module

from pydy.solvers.tableaus.tableau import Tableau

__all__ = ["add_tableau", "tableau_of"]

_ADDED: dict[str, Tableau] = {}


@cache
def tableau_of(name: str) -> Tableau:
    """Return the tableau of a method: one that was added, or that of the module of its name."""
    if name in _ADDED:
        return _ADDED[name]
    tableau: Tableau = getattr(import_module(f"pydy.solvers.tableaus.{name}"), name.upper())
    return tableau


def add_tableau(tableau: Tableau) -> None:
    """Make a tableau known by its name.

    Raises
    ------
    ValueError
        It is not consistent, or another one has this name.
    """
    tableau.check()
    if _ADDED.setdefault(tableau.name, tableau) != tableau:
        raise ValueError(
            f"`tableau` has the name {tableau.name!r}, which another one has already; give it "
            "another name."
        )
