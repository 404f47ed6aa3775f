"""Runge–Kutta methods as data, each with its source."""

from __future__ import annotations

from importlib import import_module

from pydy.solvers.tableaus.tableau import Tableau

__all__ = ["add_tableau", "tableau_of"]

_KNOWN: dict[str, Tableau] = {}


def tableau_of(name: str) -> Tableau:
    """Return the tableau of a method: one that was added, or that of the module of its name."""
    if name not in _KNOWN:
        _KNOWN[name] = getattr(import_module(f"pydy.solvers.tableaus.{name}"), name.upper())
    return _KNOWN[name]


def add_tableau(tableau: Tableau) -> None:
    """Make a tableau known by its name.

    Raises
    ------
    ValueError
        It is not consistent, or another one has this name.
    """
    tableau.check()
    if _KNOWN.setdefault(tableau.name, tableau) != tableau:
        raise ValueError(
            f"`tableau` has the name {tableau.name!r}, which another one has already; give it "
            "another name."
        )
