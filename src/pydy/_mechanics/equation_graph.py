"""Equations of motion as nodes of one graph."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from pydy._graph import Graph, LinearSystem, NodeExpression, inputs_of

if TYPE_CHECKING:
    import sympy as sm

    from pydy._sympy_types import AnySymbol, TimeFunction


@dataclass(frozen=True, eq=False)
class DynamicEquations:
    """The dynamic equations ``M u' = F``, and u' itself where it is known."""

    # M; the rows of dependent speeds are those of the acceleration constraints.
    matrix: list[list[int]]
    forcing: list[int]
    # A part of u' that is known beforehand: it cancels angular accelerations at u' = 0.
    start: list[int]
    residual_forcing: list[int]  # F − M · start, so that u' = start + M⁻¹ · this
    accelerations: list[int] | None = None  # u', if formed without the mass matrix of all speeds

    def solution(self, graph: Graph, kind: str) -> list[int]:
        """Return u', solved for if it is not known; for the kind of M see `LinearSystem`."""
        if self.accelerations is not None:
            return self.accelerations
        system = LinearSystem(graph, self.matrix, kind)
        correction = system.solve_by_differences(self.residual_forcing)
        return [graph.add(*parts) for parts in zip(self.start, correction, strict=True)]

    def ordered(self, speeds: Sequence[int]) -> DynamicEquations:
        """Return a copy with the speeds in another order, given by present positions."""
        solved = self.accelerations
        return DynamicEquations(
            [[self.matrix[i][j] for j in speeds] for i in speeds],
            [self.forcing[k] for k in speeds],
            [self.start[k] for k in speeds],
            [self.residual_forcing[k] for k in speeds],
            None if solved is None else [solved[k] for k in speeds],
        )


@dataclass(frozen=True, eq=False)
class EquationGraph:
    """Equations of motion ``M u' = F`` and kinematics ``q' = G`` as nodes."""

    # Its inputs are 'x' (coordinates, then speeds), 't', 'a' (derivatives of the speeds, in
    # loads that depend on them), 'p' and 'r' in the order of `constants` and `specifieds`.
    graph: Graph
    constants: list[sm.Symbol]
    specifieds: list[TimeFunction]
    rates: list[int]  # q'
    dynamics: DynamicEquations
    kinetic: int  # the kinetic energy
    # Inertias and velocities that depend on speeds: their constants count as constants of the
    # equations, even if this formulation does not contain them.
    measures: tuple[int, ...] = ()
    # The simplified q' and u', in a graph of their own, if formulations were compared by count.
    simplified: tuple[Graph, list[int]] | None = None

    def inputs(self) -> set[tuple[str, int]]:
        """Return the inputs of q', M, F and u', and the constants of moving bodies."""
        graph, dynamics = self.graph, self.dynamics
        roots = [*self.rates, *(n for row in dynamics.matrix for n in row), *dynamics.forcing]
        roots += dynamics.accelerations or []
        measured = inputs_of(graph, self.measures).items()
        constants = {at for node, at in measured if graph.constant[node]}
        return constants | {*inputs_of(graph, roots).values()}

    def symbols(self, speed_rates: Sequence[sm.Derivative]) -> list[AnySymbol]:
        """Return the constants, specifieds and derivatives of speeds that occur."""
        groups = {"p": self.constants, "r": self.specifieds, "a": speed_rates}
        return [groups[g][k] for g, k in sorted(self.inputs()) if g in groups]

    def input_symbols(
        self, time: sm.Symbol, states: Sequence[TimeFunction]
    ) -> dict[int, AnySymbol]:
        """Return the symbol of each input node, except derivatives of speeds."""
        groups = {"t": [time], "x": states, "p": self.constants, "r": self.specifieds}
        node = self.graph.input
        return {node(g, k): s for g, symbols in groups.items() for k, s in enumerate(symbols)}

    def energy(
        self, time: sm.Symbol, coordinates: Sequence[TimeFunction], speeds: Sequence[TimeFunction]
    ) -> sm.Expr:
        """Return the kinetic energy as an expression."""
        symbols = self.input_symbols(time, (*coordinates, *speeds))
        return NodeExpression.of(self.graph, self.kinetic, symbols)

    def renumbered(
        self, constants: Sequence[sm.Symbol], specifieds: Sequence[AnySymbol]
    ) -> EquationGraph:
        """Return a copy whose inputs are numbered as in the arrays p and r."""
        needed = self.inputs()
        names: dict[tuple[str, int], tuple[str, int]] = {}
        for group, present, order in (
            ("p", self.constants, constants),
            ("r", self.specifieds, specifieds),
        ):
            positions = {symbol: k for k, symbol in enumerate(order)}
            for k, symbol in enumerate(present):
                if symbol in positions:
                    names[group, k] = group, positions[symbol]
                elif (group, k) in needed:
                    raise ValueError(
                        f"`{symbol}` occurs in the bodies, loads or kinematics, but no argument "
                        "provides it: it is not one of the coordinates, speeds, constants or "
                        "specifieds. Add it to one of them."
                    )
                else:
                    names[group, k] = f"idle {group}", k
        simplified = self.simplified
        if simplified is not None:
            simplified = simplified[0].copy(names), simplified[1]
        return replace(self, graph=self.graph.copy(names), simplified=simplified)

    def ordered(self, coordinates: Sequence[int], speeds: Sequence[int]) -> EquationGraph:
        """Return a copy with coordinates and speeds in another order, given by present positions.

        The rows of M move with the speeds.
        """
        n, m = len(coordinates), len(speeds)
        if [*coordinates, *speeds] == [*range(n), *range(m)]:
            return self
        states = [*coordinates, *(n + k for k in speeds)]
        names = {("x", old): ("x", new) for new, old in enumerate(states)}
        names |= {("a", old): ("a", new) for new, old in enumerate(speeds)}
        simplified = self.simplified
        if simplified is not None:
            simplified = simplified[0].copy(names), [simplified[1][k] for k in states]
        return replace(
            self,
            graph=self.graph.copy(names),
            rates=[self.rates[k] for k in coordinates],
            dynamics=self.dynamics.ordered(speeds),
            simplified=simplified,
        )
