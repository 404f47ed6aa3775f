"""The equations of motion of one combination of contact modes, compiled once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import sympy as sm

from pydy._graph.from_sympy import NodeExpression
from pydy._graph.node import Graph
from pydy._mechanics.equations import Equations
from pydy._mechanics.extract import extract
from pydy.contact.decide import OPEN, SLIDES, STICKS
from pydy.contact.rows import ContactRows
from pydy.solvers.events import Event

QUANTITIES = ("gap", "normal", "friction", "sliding", "power")


@dataclass(frozen=True, eq=False)
class ModeEquations:
    """Equations that a System takes as they are."""

    equations: Equations


@extract.register(ModeEquations)
def _(mode: ModeEquations, source: str | None = None) -> Equations:
    return mode.equations


def output_symbols(names: Sequence[str]) -> dict[tuple[int, str], Any]:
    """Return the names of the outputs of each contact."""
    return {
        (i, what): sm.Symbol(f"{name}_{what}")
        for i, name in enumerate(names)
        for what in QUANTITIES
    }


class Mode:
    """Equations, outputs and events of one combination.

    Parameters
    ----------
    rows : ContactRows
    modes : tuple of str
        Of each contact.
    held : sequence of int
        The rows that are held and independent.
    every : sequence of int
        All rows that are held.

    Attributes
    ----------
    equations : ModeEquations
    outputs : dict
    held_gaps : int
        So many holonomic constraints are added behind those of the mechanism.
    """

    def __init__(
        self, rows: ContactRows, modes: tuple[str, ...], held: Sequence[int], every: Sequence[int]
    ) -> None:
        self.rows, self.modes = rows, modes
        base, formed = rows.equations, rows.formed
        g = self.graph = formed.graph.copy()
        self._solve(g, held, every)
        accelerations = [
            g.sum([(a, 1.0), *(
                (g.mul(moved[k], force), 1.0)
                for moved, force in zip(rows.moves, self.forces, strict=True)
            )])
            for k, a in enumerate(rows.free)
        ]  # fmt: skip
        forcing = [rows.dot(g, line, accelerations) for line in formed.matrix]
        gaps = [
            c.unilateral.gap
            for c, n in zip(rows.contacts, rows.normal, strict=True)
            if c.unilateral is not None and n in held
        ]
        self.held_gaps = len(gaps)
        self.equations = ModeEquations(
            replace(
                base,
                formed=replace(
                    formed,
                    graph=g,
                    accelerations=accelerations,
                    forcing=forcing,
                    rest=forcing,
                    start=[g.zero] * len(forcing),
                ),
                holonomic=(*base.holonomic, *gaps),
                velocity=(*base.velocity, *(rows.speed_expressions[k] for k in held)),
            )
        )
        self.outputs = self._outputs()

    def _solve(self, g: Graph, held: Sequence[int], every: Sequence[int]) -> None:
        """Find the forces of all rows: y with J u' + b = 0, the least if there are more of them."""
        rows = self.rows
        unknown: list[dict[int, int]] = []  # the share of each row in each unknown
        forces: list[list[tuple[int, float]]] = [[] for _ in rows.speeds]
        for i, mode in enumerate(self.modes):
            normal, tangent = rows.normal[i], rows.tangent[i]
            if mode == OPEN:
                continue
            if normal is not None:
                unknown.append({normal: g.one})
                if tangent is not None and mode in SLIDES:
                    unknown[-1][tangent] = g.sum([(rows.mu[i], -SLIDES[mode])])
            elif tangent is not None and mode in SLIDES:
                forces[tangent].append((g.mul(rows.mu[i], rows.pressed[i]), -SLIDES[mode]))
            if tangent is not None and mode == STICKS:
                unknown.append({tangent: g.one})
        known = [g.sum(part) for part in forces]
        base = [
            g.sum([(a, 1.0), *(
                (g.mul(moved[k], f), 1.0) for moved, f in zip(rows.moves, known, strict=True)
            )])
            for k, a in enumerate(rows.free)
        ]  # fmt: skip
        columns = [
            [
                g.sum([(g.mul(rows.moves[r][k], share), 1.0) for r, share in part.items()])
                for k in range(len(base))
            ]
            for part in unknown
        ]
        right = [g.neg(rows.acceleration(g, k, base)) for k in held]
        matrix = [[rows.dot(g, rows.jacobian[k], column) for column in columns] for k in held]
        self.pivots = {  # J M⁻¹ of the force that a sliding contact's normal force brings with it
            i: rows.dot(g, rows.jacobian[normal], columns[place])
            for place, (i, normal) in enumerate(self._unknown_normals())
            if normal is not None and self.modes[i] in SLIDES
        }
        if not held:
            found = []
        elif len(held) == len(every):
            found = g.solve(matrix, [right], "lu")[0]
        else:
            square = [[rows.dot(g, a, b) for b in matrix] for a in matrix]
            shares = g.solve(square, [right], "lu")[0]
            found = [
                g.sum([(g.mul(line[k], s), 1.0) for line, s in zip(matrix, shares, strict=True)])
                for k in range(len(unknown))
            ]
        for part, y in zip(unknown, found, strict=True):
            for row, share in part.items():
                forces[row].append((g.mul(share, y), 1.0))
        self.forces = [g.sum(part) for part in forces]

    def _unknown_normals(self) -> list[tuple[int, int | None]]:
        """Return the contact of each unknown, and its normal row, or None for a tangential one."""
        found: list[tuple[int, int | None]] = []
        for i, mode in enumerate(self.modes):
            if mode == OPEN:
                continue
            if self.rows.normal[i] is not None:
                found.append((i, self.rows.normal[i]))
            if self.rows.tangent[i] is not None and mode == STICKS:
                found.append((i, None))
        return found

    def _expression(self, node: int, name: str) -> Any:
        value = self.graph.value(node)
        if value is not None:
            return sm.Float(value) if value else sm.S.Zero
        return NodeExpression.of(self.graph, node, self.rows.symbols, name)

    def _outputs(self) -> dict[Any, Any]:
        rows, g = self.rows, self.graph
        symbols = output_symbols([c.name for c in rows.contacts])
        found: dict[Any, Any] = {}
        for i, c in enumerate(rows.contacts):
            normal, tangent = rows.normal[i], rows.tangent[i]
            force = g.zero if tangent is None else self.forces[tangent]
            press = rows.pressed[i] if normal is None else self.forces[normal]
            speed = g.zero if tangent is None else rows.speeds[tangent]
            nodes = (rows.gaps[i], press, force, speed, g.mul(force, speed))
            for what, node in zip(QUANTITIES, nodes, strict=True):
                symbol = symbols[i, what]
                if _stated(c.kind, what):
                    found[symbol] = self._expression(node, str(symbol))
        return found

    def events(self, rising: frozenset[int]) -> tuple[list[Event], list[tuple[str, int]]]:
        """Return what ends the mode, and what each event is: what happens, to which contact."""
        rows, g = self.rows, self.graph
        nodes: list[int] = []
        kinds: list[tuple[str, int]] = []

        def watch(node: int, what: str, contact: int) -> None:
            if any(g.ops[n] == "input" and not g.constant[n] for n in g.reachable([node])):
                nodes.append(node)
                kinds.append((what, contact))

        for i, mode in enumerate(self.modes):
            normal, tangent = rows.normal[i], rows.tangent[i]
            if mode == OPEN and normal is not None:
                if i in rising:
                    watch(rows.speeds[normal], "turns", i)
                else:
                    watch(rows.gaps[i], "closes", i)
                continue
            press = rows.pressed[i] if normal is None else self.forces[normal]
            if normal is not None:
                watch(press, "opens", i)
            if tangent is not None and mode == STICKS:
                most, force = g.mul(rows.static[i], press), self.forces[tangent]
                watch(g.sub(most, force), "slips", i)
                watch(g.add(most, force), "slips", i)
            if tangent is not None and mode in SLIDES:
                watch(g.sum([(rows.speeds[tangent], SLIDES[mode])]), "stops", i)
                if i in self.pivots:
                    watch(self.pivots[i], "jams", i)
        found = [
            Event(self._expression(node, what), direction=-1, terminal=True, name=f"{k}: {what}")
            for k, (node, (what, _)) in enumerate(zip(nodes, kinds, strict=True))
        ]
        return found, kinds


def _stated(kind: str, what: str) -> bool:
    """Return whether a contact of some kind has a quantity."""
    if what == "gap":
        return kind != "friction"
    return what == "normal" or kind != "gap"


def stated_symbols(names: Sequence[str], kinds: Sequence[str]) -> list[Any]:
    """Return the outputs of all contacts, in order."""
    symbols = output_symbols(names)
    return [s for (i, what), s in symbols.items() if _stated(kinds[i], what)]


def rows_of(table: np.ndarray, columns: Sequence[int]) -> np.ndarray:
    """Return some columns of a table."""
    return np.ascontiguousarray(table[:, list(columns)])
