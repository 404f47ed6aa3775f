"""What a model is to every contestant."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

__all__ = ["Model"]


@dataclass
class Model:
    """A mechanical system: everything that a peer needs to evaluate u' and q'.

    Attributes
    ----------
    name : str
    coordinates, speeds, specifieds, constants : list of SymPy symbols or functions of time
    mass_matrix, forcing, coordinate_derivatives : list of expressions
        The mass matrix by rows.
    positive_definite : bool
        Whether the mass matrix is symmetric positive definite by construction.
    values : list of float
        Of the constants.
    about : dict
        SymPy's version, its `cse` count of M and F, where the model comes from.
    """

    name: str
    coordinates: list[Any]
    speeds: list[Any]
    specifieds: list[Any]
    constants: list[Any]
    mass_matrix: list[Any]
    forcing: list[Any]
    coordinate_derivatives: list[Any]
    positive_definite: bool
    values: list[float]
    about: dict[str, Any]
