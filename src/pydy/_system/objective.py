"""The scalar that `System.adjoint_gradient` differentiates: its terms as they are given."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy as sm

from pydy._assembly.assembly import Assembly
from pydy._assembly.definition import Definition
from pydy._checks import Places, shown

__all__ = ["extended", "node_of", "read_term"]


def read_term(definition: Definition, term: Any, argument: str) -> Any:
    """Return the place of an output, or an expression."""
    outputs = Places(definition.outputs_symbols, "outputs of the system")
    place = outputs.get(term, argument)
    if place is not None:
        return place
    if isinstance(term, str):
        k = definition.places["states"].get(term, argument)
        term = term if k is None else definition.states[k]
    if isinstance(term, (int, float)) and not isinstance(term, bool):
        term = sm.Float(term)
    scalar = isinstance(term, sm.Expr) and term.is_commutative and not term.is_Matrix
    if not scalar:
        raise ValueError(
            f"`{argument}` must be an output of the system, by symbol or name, or an expression of "
            f"its states, specifieds, constants and time, got {shown(term)}."
        )
    return term


def node_of(assembly: Assembly, term: Any, argument: str) -> int:
    """Return an output's node or an expression's, in a graph that may grow."""
    return assembly.outputs[term] if isinstance(term, int) else assembly.read([term], argument)[0]


def extended(term: Any, marked: bool, assembly: Assembly) -> Assembly:
    """Return the equations with the integral and the marker of samples as their last states."""
    n, s, c = assembly.sizes
    more = [] if term is None else [node_of(assembly, term, "`integral`")]
    if marked:
        more.append(assembly.graph.input("r", s))
    return replace(assembly, sizes=(n + len(more), s + marked, c), rates=[*assembly.rates, *more])
