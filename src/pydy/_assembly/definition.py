"""What a model consists of, symbolically: equations, outputs, and symbols that need numbers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import sympy as sm

from pydy._assembly.assumptions import Assumptions
from pydy._assembly.system import Group
from pydy._checks import SymbolIndex
from pydy._forks import cached_property
from pydy._mechanics import Equations

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, TimeFunction


@dataclass(frozen=True)
class Layout:
    """The orders of the arrays x, r and p, and of the outputs."""

    states: tuple[AnySymbol, ...]
    specifieds: tuple[AnySymbol, ...]
    constants: tuple[AnySymbol, ...]
    outputs: tuple[AnySymbol, ...] = ()


@dataclass(frozen=True)
class Outputs:
    """All outputs: the user's, the constraint residuals, the noncontributing forces."""

    groups: tuple[Group, ...]
    residuals: tuple[AnySymbol, ...] = ()
    forces: tuple[AnySymbol, ...] = ()
    # Labels of outputs that are called like something else, with the names that the user gave.
    labels: tuple[tuple[AnySymbol, AnySymbol], ...] = ()

    @cached_property
    def symbols(self) -> tuple[AnySymbol, ...]:
        """The symbols of all outputs, in order."""
        return tuple(name for group in self.groups for name in group.names)

    @cached_property
    def defined_by_user(self) -> tuple[AnySymbol, ...]:
        """The symbols of the user's outputs."""
        generated = {*self.residuals, *self.forces}
        return tuple(s for s in self.symbols if s not in generated)

    def as_named_by_user(self, symbols: Iterable[AnySymbol]) -> tuple[AnySymbol, ...]:
        """Return the user's names of some outputs in place of their labels."""
        names = dict(self.labels)
        return tuple(names.get(symbol, symbol) for symbol in symbols)


@dataclass(frozen=True)
class Definition:
    """The symbolic side of a System. Equal ones need the same code."""

    equations: Equations
    outputs: Outputs
    # The states that integrate outputs which depend on the derivatives of the speeds.
    auxiliaries: tuple[AnySymbol, ...]
    constants: tuple[AnySymbol, ...]  # sorted
    specifieds: tuple[AnySymbol, ...]  # sorted, or as the user ordered them

    @cached_property
    def states(self) -> tuple[AnySymbol, ...]:
        """Coordinates, speeds, auxiliaries."""
        return (*self.equations.coordinates, *self.equations.speeds, *self.auxiliaries)

    @cached_property
    def rates_of_specifieds(self) -> tuple[int | None, ...]:
        """The place of each specified's derivative by time among them, None where it is none."""
        places = {symbol: k for k, symbol in enumerate(self.specifieds)}
        return tuple(places.get(symbol.diff(self.equations.time)) for symbol in self.specifieds)

    @cached_property
    def symbols_by_kind(self) -> dict[str, tuple[AnySymbol, ...]]:
        """All symbols but the constants, by kind, as a Trajectory takes them."""
        equations, outputs = self.equations, self.outputs
        return {
            "coordinate": equations.coordinates,
            "speed": equations.speeds,
            "auxiliary": self.auxiliaries,
            "output": outputs.defined_by_user,
            "constraint": outputs.residuals,
            "force": outputs.forces,
            "specified": self.specifieds,
        }

    @cached_property
    def layout(self) -> Layout:
        """The orders of the arrays x, r and p, and of the outputs."""
        return Layout(self.states, self.specifieds, self.constants, self.outputs.symbols)

    @cached_property
    def lower_derivatives(self) -> dict[sm.Derivative, tuple[TimeFunction, ...]]:
        """The lower derivatives of each specified that is a derivative, lowest first."""
        return {s: lower_derivatives(s) for s in self.specifieds if isinstance(s, sm.Derivative)}

    @cached_property
    def assumptions(self) -> dict[str, Assumptions]:
        """What is assumed of the values of states, specifieds and constants, where anything is."""
        names = ("states", "specifieds", "constants")
        found = {name: Assumptions.of(getattr(self.layout, name)) for name in names}
        return {name: own for name, own in found.items() if own is not None}

    @cached_property
    def assumes_motions(self) -> bool:
        """Whether anything is assumed of the values of states or specifieds."""
        return not self.assumptions.keys() <= {"constants"}

    @cached_property
    def places(self) -> dict[str, SymbolIndex]:
        """Where states, specifieds and constants lie in x, r and p; and outputs among all."""
        return {
            what: SymbolIndex(s, f"{what} of the system") for what, s in vars(self.layout).items()
        }

    @cached_property
    def variables(self) -> SymbolIndex:
        """Where states and outputs lie in rows of both, the states first."""
        symbols = (*self.states, *self.outputs.symbols)
        return SymbolIndex(symbols, "states and outputs of the system")

    def row_names(self, block: str) -> list[str]:
        """Return the names of a block's values for messages."""
        equations = self.equations
        if block == "rates":
            return [f"the derivative of {s}" for s in self.states]
        if block == "outputs":
            return [getattr(s, "name", str(s)) for s in self.outputs.symbols]
        if block == "energy":
            return ["the kinetic energy", "the potential energy", "the total energy"]
        kinds = ("holonomic", "nonholonomic") if block == "constraints" else (block,)
        return [
            f"the residual of {kind} constraint {k}"
            for kind in kinds
            for k, _ in enumerate(getattr(equations.constraints, kind))
        ]


def lower_derivatives(derivative: sm.Derivative) -> tuple[TimeFunction, ...]:
    """Return a function of time and its derivatives below a given one."""
    function, variable = derivative.expr, derivative.variables[0]
    return tuple(function.diff(variable, k) for k in range(derivative.derivative_count))
