"""The equations of motion of one combination of contact modes, compiled once."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm

from pydy import _forks
from pydy._forks import cached_property
from pydy._graph import Graph, LinearSystem, NodeExpression, jacobian
from pydy._mechanics import Equations, dot, extract
from pydy._names import name_of
from pydy._problem import Model, Problem
from pydy.contact.complementarity import (
    BACKWARD,
    CLOSED,
    FORWARD,
    OPEN,
    SLIDES,
    SLIDING,
    STARTING,
    STICKS,
)
from pydy.contact.conditions import Contact
from pydy.contact.rows import ContactRows
from pydy.contact.tuning import TURN_LIMIT
from pydy.solvers import Event, Turn
from pydy.trajectory import Columns

if TYPE_CHECKING:
    from pydy._assembly import Definition
    from pydy._sympy_types import AnySymbol

_WATCHED = {
    "closes": "gap",
    "nears": "speed of the gap",
    "opens": "normal force",
    "slips": "margin of friction",
    "stops": "sliding speed",
}


@extract.register(Equations)
def _(equations: Equations, source: str | None = None, implicit: object = None) -> Equations:
    return equations


def output_symbols(contacts: Sequence[Contact]) -> dict[tuple[int, str], sm.Symbol]:
    """Return the symbols of each contact's outputs, by its position and their kind."""
    symbols = {}
    for i, c in enumerate(contacts):
        number = 0 if c.stick is None else 2 if c.stick.plane else 1
        parts = ["gap"] if c.unilateral is not None else []
        parts += ["normal", *_names("friction", number), *_names("sliding", number)]
        parts += ["power"] if number else []
        symbols.update({(i, quantity): sm.Symbol(f"{c.name}_{quantity}") for quantity in parts})
    return symbols


def check_names(
    rows: ContactRows, outputs: Iterable[AnySymbol], other_symbols: Iterable[AnySymbol]
) -> None:
    """Refuse quantities of the System that have the name of an output of the contacts.

    The `outputs` are the user's; `other_symbols` are states, constants and specifieds.
    """
    contact_symbols = [*output_symbols(rows.contacts).values(), *map(margin_symbol, rows.contacts)]
    for symbols, names in (
        (outputs, {*map(str, contact_symbols)}),
        (other_symbols, {*map(str, rows.hidden)}),
    ):
        for symbol in symbols:
            if name_of(symbol) in names:
                raise ValueError(
                    f"The System has the name `{name_of(symbol)}`, which `contacts` need for a "
                    "quantity of their own. Rename it, or pass another `name` to the contact."
                )


def modes_of(contact: Contact) -> list[str]:
    """Return a contact's possible modes, except the beginning of a slide; 'open' comes first."""
    modes = [] if contact.unilateral is None else [OPEN]
    if contact.stick is None:
        return [*modes, CLOSED]
    return [*modes, STICKS, *([SLIDING] if contact.stick.plane else [FORWARD, BACKWARD])]


def margin_symbol(contact: Contact) -> sm.Symbol:
    """Return the symbol of a sticking contact's margin: (μ_s N)² − F²."""
    return sm.Symbol(f"{contact.name}_margin")


class Mode:
    """Equations, outputs and events of one combination of modes.

    Of the `active` rows an independent set is `enforced`. Their gaps are appended to the holonomic
    constraints of the mechanism.
    """

    def __init__(
        self,
        rows: ContactRows,
        modes: tuple[str, ...],
        enforced: Sequence[int],
        active: Sequence[int],
    ) -> None:
        self.rows, self.modes = rows, modes
        self.output_index: dict[
            AnySymbol, int
        ] = {}  # columns of the outputs of its Model, by symbol
        self.columns = np.zeros(0, dtype=int)  # of the outputs of the trajectory
        base, formed = rows.equations, rows.formed
        g = self.graph = formed.graph.copy()
        self._solve(g, enforced, active)
        accelerations = rows.rates(g, self.forces)
        forcing = [dot(g, line, accelerations) for line in formed.dynamics.matrix]
        gaps = [
            c.unilateral.gap
            for c, n in zip(rows.contacts, rows.normal, strict=True)
            if c.unilateral is not None and n in enforced
        ]
        dynamics = replace(
            formed.dynamics,
            accelerations=accelerations,
            forcing=forcing,
            residual_forcing=forcing,
            start=[g.zero] * len(forcing),
        )
        mode_graph = replace(formed, graph=g, dynamics=dynamics)
        constraints = base.constraints
        constraints = replace(
            constraints,
            holonomic=(*constraints.holonomic, *gaps),
            velocity=(
                *constraints.velocity,
                *(rows.speed_expressions[k] for k in enforced),
            ),
        )
        self.equations = replace(base, formed=mode_graph, constraints=constraints)
        self.outputs = self._outputs()

    def _solve(self, g: Graph, enforced: Sequence[int], active: Sequence[int]) -> None:
        """Solve J u' + b = 0 of the enforced rows for the forces of all rows.

        If rows are redundant, the forces with the least distance from the biases are selected.
        """
        rows = self.rows
        unknown: list[dict[int, int]] = []  # for each unknown, its factor in the force of each row
        sliding: dict[
            int, tuple[int, int]
        ] = {}  # normal rows of sliding contacts, and their unknowns
        forces: list[list[tuple[int, float]]] = [[] for _ in rows.speeds]
        for i, mode in enumerate(self.modes):
            normal, tangent = rows.normal[i], rows.tangent[i]
            if mode == OPEN:
                continue
            direction = self._direction(i, mode) if mode in SLIDES else []
            if normal is not None:
                if mode in SLIDES:
                    sliding[i] = normal, len(unknown)
                unknown.append({normal: g.one})
                for row, unit in zip(tangent, direction, strict=bool(direction)):
                    unknown[-1][row] = g.sum([(g.mul(rows.mu[i], unit), -1.0)])
            else:
                for row, unit in zip(tangent, direction, strict=bool(direction)):
                    forces[row].append((g.mul(rows.mu[i], rows.pressed[i], unit), -1.0))
            if mode == STICKS:
                unknown += [{row: g.one} for row in tangent]
        known_forces = [g.sum(part) for part in forces]
        base = rows.rates(g, known_forces)
        columns = [
            [dot(g, [rows.response[r][k] for r in p], [*p.values()]) for k in range(len(base))]
            for p in unknown
        ]
        right = [g.neg(rows.acceleration(g, k, base)) for k in enforced]
        matrix = [[dot(g, rows.jacobian[k], column) for column in columns] for k in enforced]
        self.pivots = {  # acceleration per unit of a sliding contact's normal force
            i: dot(g, rows.jacobian[normal], columns[index])
            for i, (normal, index) in sliding.items()
        }
        if not enforced:
            solution = []
        elif len(enforced) == len(active):
            solution = LinearSystem(g, matrix).solve(right)
        else:
            nodes = {symbol: node for node, symbol in rows.symbols.items()}
            solution = self._nearest(g, matrix, right, [nodes[rows.biases[row]] for row in active])
        for part, y in zip(unknown, solution, strict=True):
            for row, share in part.items():
                forces[row].append((g.mul(share, y), 1.0))
        self.forces = [g.sum(part) for part in forces]

    def _nearest(
        self, g: Graph, matrix: list[list[int]], right: list[int], bias: list[int]
    ) -> list[int]:
        """Return the solution of an underdetermined system that is closest to the biases."""
        residuals = [
            g.sub(value, dot(g, line, bias)) for value, line in zip(right, matrix, strict=True)
        ]
        square = [[dot(g, a, b) for b in matrix] for a in matrix]
        shares = LinearSystem(g, square).solve(residuals)
        lines = zip(*matrix, strict=True)
        return [dot(g, column, shares, (b, 1.0)) for column, b in zip(lines, bias, strict=True)]

    def _direction(self, i: int, mode: str) -> list[int]:
        """Return the direction in which a contact slides.

        In a plane it is w/|w|, with w = v + ε d: the least speed ε gives it the reference direction
        d where v vanishes. During sliding it is multiplied by the sign of w·d, so it does not jump
        where v passes through zero, and that event can be located.
        """
        g, rows = self.graph, self.rows
        if mode not in (SLIDING, STARTING):
            return [g.const(SLIDES[mode])]
        *reference, least, _, _ = self._reference(i)
        speeds = [
            g.add(rows.speeds[k], g.mul(least, component))
            for k, component in zip(rows.tangent[i], reference, strict=True)
        ]
        ahead = g.call("lt", g.zero, dot(g, speeds, reference))
        sign = g.one if mode == STARTING else g.call("select", ahead, g.one, g.const(-1.0))
        size = g.call("sqrt", dot(g, speeds, speeds))
        return [g.div(g.mul(sign, speed), size) for speed in speeds]

    def _reference(self, i: int) -> list[int]:
        nodes = {symbol: node for node, symbol in self.rows.symbols.items()}
        return [nodes[s] for s in self.rows.references[i]]

    def _expression(self, node: int, name: str) -> sm.Expr:
        value = self.graph.value(node)
        if value is not None:
            return sm.Float(value) if value else sm.S.Zero
        return NodeExpression.of(self.graph, node, self.rows.symbols, name)

    def _outputs(self) -> dict[sm.Symbol, sm.Expr]:
        rows, g = self.rows, self.graph
        symbols = output_symbols(rows.contacts)
        outputs: dict[sm.Symbol, sm.Expr] = {}
        for i in range(len(rows.contacts)):
            normal, tangent = rows.normal[i], rows.tangent[i]
            forces, speeds = ([part[k] for k in tangent] for part in (self.forces, rows.speeds))
            nodes = {
                "gap": rows.gaps[i],
                "normal": rows.pressed[i] if normal is None else self.forces[normal],
                "power": dot(g, forces, speeds),
            }
            for quantity, parts in (("friction", forces), ("sliding", speeds)):
                nodes |= dict(zip(_names(quantity, len(tangent)), parts, strict=True))
            for (k, quantity), symbol in symbols.items():
                if k == i:
                    outputs[symbol] = self._expression(nodes[quantity], str(symbol))
            if self.modes[i] == STICKS:
                most = g.powi(g.mul(rows.static[i], nodes["normal"]), 2)
                margin = g.sub(most, dot(g, forces, forces))
                outputs[margin_symbol(rows.contacts[i])] = self._expression(margin, "margin")
        return outputs

    def _is_linear(self, node: int) -> bool:
        """Return whether a quantity is linear in the states and time."""
        g = self.graph
        moving = [n for n in g.reachable([node]) if g.ops[n] == "input" and not g.constant[n]]
        (slopes,) = jacobian(g, [node], moving)
        return all(g.constant[n] for n in slopes.values())

    @cached_property
    def events(self) -> tuple[list[Event], list[tuple[str, int]]]:
        """The events that end the mode, with the kind and contact of each.

        While a gap separates from zero its speed is monitored, because the gap itself may be zero
        by rounding. Later, the minima of gaps that are not linear in the states are located, too,
        because a gap may be closed there between two steps.
        """
        rows, g = self.rows, self.graph
        nodes_of = {symbol: node for node, symbol in rows.symbols.items()}
        nodes: list[int] = []
        kinds: list[tuple[str, int]] = []

        def watch(node: int, kind: str, contact: int) -> None:
            if any(g.ops[n] == "input" and not g.constant[n] for n in g.reachable([node])):
                nodes.append(node)
                kinds.append((kind, contact))

        for i, mode in enumerate(self.modes):
            normal, tangent = rows.normal[i], rows.tangent[i]
            if mode == OPEN and normal is not None:
                is_separating = g.call("lt", g.zero, nodes_of[rows.speed_bounds[i]])
                # The speed may begin as a rounding of either sign.
                speed, bound = rows.speeds[normal], nodes_of[rows.speed_bounds[i]]
                watch(
                    g.call("select", is_separating, g.add(speed, bound), rows.gaps[i]), "closes", i
                )
                if not self._is_linear(rows.gaps[i]):
                    watch(g.neg(speed), "nears", i)
                continue
            press = rows.pressed[i] if normal is None else self.forces[normal]
            if normal is not None:
                watch(press, "opens", i)
            forces, speeds = ([part[k] for k in tangent] for part in (self.forces, rows.speeds))
            most = g.mul(rows.static[i], press)
            if mode == STICKS and len(tangent) == 2:
                watch(g.sub(g.powi(most, 2), dot(g, forces, forces)), "slips", i)
            elif mode == STICKS:
                watch(g.sub(most, forces[0]), "slips", i)
                watch(g.add(most, forces[0]), "slips", i)
            if mode in (SLIDING, STARTING):
                *reference, _, clear, rest = self._reference(i)
                ahead, square = (dot(g, speeds, vector) for vector in (reference, speeds))
                watch(g.sub(ahead, rest), "stops", i)  # see `Transitions.rest_speed`
                if mode == STARTING:
                    watch(g.sub(g.powi(clear, 2), square), "clears", i)
                else:
                    slow, ahead_squared = g.powi(clear, 2), g.powi(ahead, 2)
                    watch(
                        g.sum([(slow, 1.0), (ahead_squared, 1.0), (square, -(TURN_LIMIT**2))]),
                        "bends",
                        i,
                    )
            elif mode in SLIDES:
                bound = nodes_of[rows.speed_bounds[i]]
                watch(g.sum([(speeds[0], SLIDES[mode]), (bound, 1.0)]), "stops", i)
            if mode in SLIDES and i in self.pivots:
                watch(self.pivots[i], "jams", i)
        events = [
            (Turn if kind == "nears" else Event)(
                self._expression(node, kind),
                direction=-1,
                terminal=kind != "nears",
                name=f"{k}: {_WATCHED.get(kind, kind)} of {rows.contacts[i].name}",
            )
            for k, (node, (kind, i)) in enumerate(zip(nodes, kinds, strict=True))
        ]
        return events, kinds

    @property
    def turns(self) -> bool:
        """Whether friction can turn a velocity in a plane, where sensitivities change fast."""
        return not {STARTING, SLIDING}.isdisjoint(self.modes)

    @property
    def untimed(self) -> frozenset[int]:
        """Events of sliding in a plane, whose time derivatives are not used if no slide continues.

        Before a stop the velocity turns at an unbounded rate, so the expressions have no slope.
        """
        kinds, plane_kinds = self.events[1], ("stops", "bends", "clears")
        return frozenset(
            k
            for k, (kind, i) in enumerate(kinds)
            if kind in plane_kinds and i in self.rows.references
        )


def _names(quantity: str, number: int) -> list[str]:
    """Return the names of the parts of a tangential quantity."""
    return [quantity] if number == 1 else [f"{quantity}_{k + 1}" for k in range(number)]


# -- Modes as they occur ---------------------------------------------------------------------------

_GAP, _FRICTION = ("closes", "opens", "rests"), ("slips", "stops")


class CompiledModes:
    """The contact rows of a definition, and its modes, compiled as they occur."""

    def __init__(
        self,
        problem: Problem,
        contacts: tuple[Contact, ...],
        hypothesis: str,
    ) -> None:
        self.hypothesis = hypothesis  # of restitution
        self.definition, self.contacts = problem.definition, contacts
        self.rows = ContactRows(
            problem.definition.equations,
            contacts,
            problem.definition.constants,
            problem.definition.specifieds,
        )
        kinds = problem.definition.symbols_by_kind
        other_symbols = (s for kind, symbols in kinds.items() if kind != "output" for s in symbols)
        check_names(self.rows, kinds["output"], (*other_symbols, *problem.definition.constants))
        self.symbols = output_symbols(contacts)
        self.contact_outputs = list(self.symbols.values())
        self.trajectory_columns = Columns(
            {**kinds, "output": (*kinds["output"], *self.contact_outputs)}
        )
        self.constants = (*self.definition.constants, *self.rows.hidden)
        self.modes: dict[tuple[tuple[str, ...], tuple[int, ...]], tuple[Mode, Model]] = {}
        self._specifieds = problem.settings.specifieds
        self._lock = _forks.Lock()

    def __reduce__(
        self,
    ) -> tuple[object, ...]:  # not sent to other processes, which compile their own
        return type(None), ()

    @property
    def outputs(self) -> tuple[AnySymbol, ...]:
        """The symbols of a trajectory's outputs."""
        outputs = self.definition.outputs
        return (*outputs.defined_by_user, *self.contact_outputs, *outputs.residuals)

    @property
    def transitions(self) -> tuple[str, ...]:
        """The names of the events of contacts."""
        names: list[str] = []
        for c in self.contacts:
            names += [f"{c.name} {kind}" for kind in _GAP] if c.unilateral is not None else []
            names += [f"{c.name} {kind}" for kind in _FRICTION] if c.stick is not None else []
        return tuple(names)

    def mode(
        self, modes: tuple[str, ...], enforced: tuple[int, ...], active: Sequence[int]
    ) -> tuple[Mode, Model]:
        """Return a Mode and its Model, which all runs share."""
        key = modes, enforced
        entry = self.modes.get(key)
        if entry is None:
            compiled = Mode(self.rows, modes, enforced, active)
            model = Model.of(compiled.equations, **self.settings(compiled))
            compiled.columns = self._columns(compiled, model.definition)
            with self._lock:
                entry = self.modes.setdefault(key, (compiled, model))
        return entry

    def settings(self, mode: Mode) -> dict[str, Any]:
        """Return the arguments of a Model or a System of a Mode, besides the equations."""
        outputs = self.definition.outputs
        users: dict[AnySymbol | tuple[AnySymbol, ...], object] = {}
        for group in outputs.groups:
            if {*group.names} <= {*outputs.defined_by_user}:
                names = outputs.as_named_by_user(group.names)
                several = len(names) > 1
                users[names if several else names[0]] = (
                    group.expressions if several else group.expressions[0]
                )
        return {
            "outputs": {**users, **mode.outputs},
            "specifieds": dict(self._specifieds),
            "constants_symbols": self.constants,
            "specifieds_symbols": self.definition.specifieds,
        }

    def _columns(self, mode: Mode, definition: Definition) -> np.ndarray:
        """Return the columns of the trajectory's outputs in a mode; store all indices."""
        mode.output_index = {symbol: k for k, symbol in enumerate(definition.outputs.symbols)}
        base = self.definition
        constraints = base.equations.constraints
        h, n = len(constraints.holonomic), len(constraints.nonholonomic)
        residuals = list(definition.outputs.residuals)
        residual_outputs = (
            [*residuals[:h], *residuals[len(residuals) - n :]] if n else residuals[:h]
        )
        users = base.outputs.defined_by_user
        symbols = *users, *self.contact_outputs, *residual_outputs
        return np.array([mode.output_index[symbol] for symbol in symbols], dtype=int)
