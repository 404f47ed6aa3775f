"""What a System consists of, symbolically: equations, outputs, and symbols that need numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sm

from pydy._eom.equations import Equations
from pydy._eom.symbols import sort_symbols
from pydy._errors import UnsupportedFunctionError
from pydy._programs import Assembly, Group, assemble_system, auxiliary_groups
from pydy._system.inputs import check_forces, output_groups, sort_out
from pydy.codegen.right_hand_side import Layout

__all__ = ["Definition", "define"]


@dataclass(frozen=True)
class Definition:
    """The symbolic side of a System. Equal ones need the same code.

    Attributes
    ----------
    equations : Equations
    groups : tuple of Group
        All outputs: the user's, the constraint residuals, the noncontributing forces.
    auxiliaries : tuple of Symbol
        The states that integrate outputs which depend on the derivatives of the speeds.
    constants, specifieds : tuple of symbols
        Sorted.
    """

    equations: Equations
    groups: tuple[Group, ...]
    auxiliaries: tuple[Any, ...]
    constants: tuple[Any, ...]
    specifieds: tuple[Any, ...]

    @property
    def states(self) -> tuple[Any, ...]:
        """Coordinates, speeds, auxiliaries."""
        return (*self.equations.coordinates, *self.equations.speeds, *self.auxiliaries)

    @property
    def outputs_symbols(self) -> tuple[Any, ...]:
        """The names of all outputs, in order."""
        return tuple(name for group in self.groups for name in group.names)

    @property
    def layout(self) -> Layout:
        """The orders of the arrays x, r and p."""
        return Layout(self.states, self.specifieds, self.constants)

    def assemble(self, equations: Equations, *, external: bool, simplified: bool) -> Assembly:
        """Return the graph of everything; `equations` may be these, solved beforehand."""
        return assemble_system(
            equations,
            self.groups,
            self.auxiliaries,
            self.specifieds,
            self.constants,
            external=external,
            simplified=simplified,
        )


def define(
    equations: Equations,
    outputs: Mapping[Any, Any],
    forces: Any,
    base: tuple[Sequence[Any], Sequence[Any]],
    expressions: Mapping[Any, Any],
) -> Definition:
    """Check the outputs and forces of a System and sort out its symbols.

    Parameters
    ----------
    equations : Equations
    outputs : mapping
        All outputs but the noncontributing forces.
    forces : iterable of symbols or None
    base : (constants, specifieds)
        Those of the equations of motion, as found or as the user gave them.
    expressions : mapping
        The specifieds that are given as expressions; symbols that occur only there are added.
    """
    constants, specifieds = base
    groups = output_groups(outputs)
    names = check_forces(equations, forces)
    if names:
        groups.append(Group(tuple(names), equations.auxiliary_equations))
    results = [n for group in groups for n in group.names]
    taken = {*equations.coordinates, *equations.speeds, *constants, *specifieds, equations.time}
    for k, name in enumerate(results):
        if name in taken:
            raise ValueError(
                f"`outputs` has the name `{name}`, which is a state, constant or specified of the "
                "system already. Choose another name."
            )
        if name in results[:k]:
            raise ValueError(f"`outputs` gives `{name}` more than once.")
    more_constants, more_specifieds = sort_out(
        equations, [e for group in groups for e in group.expressions], results
    )
    integrated = auxiliary_groups(equations, groups)
    auxiliaries = tuple(
        sm.Symbol(f"∫ {name} dt")
        for group, flag in zip(groups, integrated, strict=True)
        if flag
        for name in group.names
    )
    aux = set(auxiliaries)
    for symbol, expression in expressions.items():
        found = _symbols_of(symbol, expression, equations, set(results), auxiliaries)
        more_constants += found[0]
        more_specifieds += found[1]
    return Definition(
        equations,
        tuple(groups),
        auxiliaries,
        tuple(sort_symbols({*constants, *more_constants} - aux)),
        tuple(sort_symbols({*specifieds, *more_specifieds})),
    )


def _symbols_of(
    symbol: Any,
    expression: Any,
    equations: Equations,
    outputs: set[Any],
    auxiliaries: Sequence[Any],
) -> tuple[list[Any], list[Any]]:
    """Return the constants and specifieds in the expression for a specified."""
    try:
        constants, specifieds = sort_out(equations, [expression], auxiliaries)
    except (ValueError, UnsupportedFunctionError) as error:
        raise type(error)(f"`specifieds` for {symbol}: {error}") from None
    for name in (*constants, *specifieds):
        if name in outputs:
            raise ValueError(
                f"`specifieds` for {symbol} holds `{name}`, the name of an output. Outputs follow "
                "from the specifieds: write the output's expression instead."
            )
    return constants, specifieds
