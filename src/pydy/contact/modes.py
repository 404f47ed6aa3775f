"""The equations of motion of one combination of contact modes, compiled once."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

import sympy as sm

from pydy import _forks
from pydy._forks import cached_property
from pydy._graph import Graph, NodeExpression, jacobian
from pydy._mechanics import Equations, dot, extract
from pydy._names import name_of
from pydy._problem import Model, Problem
from pydy.contact.conditions import Contact
from pydy.contact.decide import (
    BACKWARD,
    CLOSED,
    FORWARD,
    OPEN,
    SLIDES,
    SLIDING,
    STARTING,
    STICKS,
)
from pydy.contact.rows import ContactRows
from pydy.contact.tuning import TURNED
from pydy.solvers import Event, Turn
from pydy.trajectory import Columns

_WATCHED = {
    "closes": "gap",
    "nears": "speed of the gap",
    "opens": "normal force",
    "slips": "margin of friction",
    "stops": "sliding speed",
}


@extract.register(Equations)
def _(equations: Equations, source: str | None = None, implicit: Any = None) -> Equations:
    return equations


def output_symbols(contacts: Sequence[Contact]) -> dict[tuple[int, str], Any]:
    """Return the symbols of each contact's outputs, by its position and their kind."""
    found = {}
    for i, c in enumerate(contacts):
        number = 0 if c.stick is None else 2 if c.stick.plane else 1
        parts = ["gap"] if c.unilateral is not None else []
        parts += ["normal", *_names("friction", number), *_names("sliding", number)]
        parts += ["power"] if number else []
        found.update({(i, what): sm.Symbol(f"{c.name}_{what}") for what in parts})
    return found


def check_names(rows: ContactRows, outputs: Iterable[Any], others: Iterable[Any]) -> None:
    """Refuse quantities of the System with the names of outputs that the contacts add.

    The `outputs` are the user's; the `others` are states, constants and specifieds.
    """
    ours = [*output_symbols(rows.contacts).values(), *map(margin_symbol, rows.contacts)]
    for symbols, names in ((outputs, {*map(str, ours)}), (others, {*map(str, rows.hidden)})):
        for symbol in symbols:
            if name_of(symbol) in names:
                raise ValueError(
                    f"The System has the name `{name_of(symbol)}`, which `contacts` need for a "
                    "quantity of their own. Rename it, or pass another `name` to the contact."
                )


def modes_of(contact: Contact) -> list[str]:
    """Return a contact's possible modes, except the beginning of a slide; 'open' comes first."""
    found = [] if contact.unilateral is None else [OPEN]
    if contact.stick is None:
        return [*found, CLOSED]
    return [*found, STICKS, *([SLIDING] if contact.stick.plane else [FORWARD, BACKWARD])]


def margin_symbol(contact: Contact) -> Any:
    """Return the symbol of a sticking contact's margin: (μ_s N)² − F²."""
    return sm.Symbol(f"{contact.name}_margin")


class Mode:
    """Equations, outputs and events of one combination.

    Rows are `held` and independent, among `every` one that is held. Their gaps are added behind the
    holonomic constraints of the mechanism.
    """

    def __init__(
        self, rows: ContactRows, modes: tuple[str, ...], held: Sequence[int], every: Sequence[int]
    ) -> None:
        self.rows, self.modes = rows, modes
        self.places: dict[Any, int] = {}  # of the outputs of its Model
        self.columns: list[int] = []  # those of the trajectory among them
        base, formed = rows.equations, rows.formed
        g = self.graph = formed.graph.copy()
        self._solve(g, held, every)
        accelerations = rows.rates(g, self.forces)
        forcing = [dot(g, line, accelerations) for line in formed.matrix]
        gaps = [
            c.unilateral.gap
            for c, n in zip(rows.contacts, rows.normal, strict=True)
            if c.unilateral is not None and n in held
        ]
        own = replace(
            formed,
            graph=g,
            accelerations=accelerations,
            forcing=forcing,
            residual_forcing=forcing,
            start=[g.zero] * len(forcing),
        )
        constraints = base.constraints
        constraints = replace(
            constraints,
            holonomic=(*constraints.holonomic, *gaps),
            velocity=(*constraints.velocity, *(rows.speed_expressions[k] for k in held)),
        )
        self.equations = replace(base, formed=own, constraints=constraints)
        self.outputs = self._outputs()

    def _solve(self, g: Graph, held: Sequence[int], every: Sequence[int]) -> None:
        """Find the forces of all rows: y with J u' + b = 0.

        If there are more of them, those that are next to the biases.
        """
        rows = self.rows
        unknown: list[dict[int, int]] = []  # the share of each row in each unknown
        sliding: dict[int, tuple[int, int]] = {}  # normal rows of what slides, and their unknowns
        forces: list[list[tuple[int, float]]] = [[] for _ in rows.speeds]
        for i, mode in enumerate(self.modes):
            normal, tangent = rows.normal[i], rows.tangent[i]
            if mode == OPEN:
                continue
            along = self._direction(i, mode) if mode in SLIDES else []
            if normal is not None:
                if mode in SLIDES:
                    sliding[i] = normal, len(unknown)
                unknown.append({normal: g.one})
                for row, unit in zip(tangent, along, strict=bool(along)):
                    unknown[-1][row] = g.sum([(g.mul(rows.mu[i], unit), -1.0)])
            else:
                for row, unit in zip(tangent, along, strict=bool(along)):
                    forces[row].append((g.mul(rows.mu[i], rows.pressed[i], unit), -1.0))
            if mode == STICKS:
                unknown += [{row: g.one} for row in tangent]
        known = [g.sum(part) for part in forces]
        base = rows.rates(g, known)
        columns = [
            [dot(g, [rows.moves[r][k] for r in p], [*p.values()]) for k in range(len(base))]
            for p in unknown
        ]
        right = [g.neg(rows.acceleration(g, k, base)) for k in held]
        matrix = [[dot(g, rows.jacobian[k], column) for column in columns] for k in held]
        self.pivots = {  # J M⁻¹ of the force that a sliding contact's normal force brings with it
            i: dot(g, rows.jacobian[normal], columns[place])
            for i, (normal, place) in sliding.items()
        }
        if not held:
            found = []
        elif len(held) == len(every):
            found = g.solve(matrix, [right], "lu")[0]
        else:
            nodes = {symbol: node for node, symbol in rows.symbols.items()}
            found = self._nearest(g, matrix, right, [nodes[rows.biases[row]] for row in every])
        for part, y in zip(unknown, found, strict=True):
            for row, share in part.items():
                forces[row].append((g.mul(share, y), 1.0))
        self.forces = [g.sum(part) for part in forces]

    def _nearest(
        self, g: Graph, matrix: list[list[int]], right: list[int], bias: list[int]
    ) -> list[int]:
        """Return the solution of fewer equations than unknowns that is next to the biases."""
        left = [g.sub(one, dot(g, line, bias)) for one, line in zip(right, matrix, strict=True)]
        square = [[dot(g, a, b) for b in matrix] for a in matrix]
        shares = g.solve(square, [left], "lu")[0]
        lines = zip(*matrix, strict=True)
        return [dot(g, own, shares, (b, 1.0)) for own, b in zip(lines, bias, strict=True)]

    def _direction(self, i: int, mode: str) -> list[int]:
        """Return the direction in which a contact slides.

        In a plane it is w/|w|, with w = v + ε d, which is v but for the least speed ε, along the
        reference d where v vanishes. When a body slides its sign is that of w·d: the direction does
        not jump where v passes through zero, so that this is located.
        """
        g, rows = self.graph, self.rows
        if mode not in (SLIDING, STARTING):
            return [g.const(SLIDES[mode])]
        *reference, least, _ = self._reference(i)
        speeds = [
            g.add(rows.speeds[k], g.mul(least, own))
            for k, own in zip(rows.tangent[i], reference, strict=True)
        ]
        ahead = g.call("lt", g.zero, dot(g, speeds, reference))
        sign = g.one if mode == STARTING else g.call("select", ahead, g.one, g.const(-1.0))
        size = g.call("sqrt", dot(g, speeds, speeds))
        return [g.div(g.mul(sign, speed), size) for speed in speeds]

    def _reference(self, i: int) -> list[int]:
        nodes = {symbol: node for node, symbol in self.rows.symbols.items()}
        return [nodes[s] for s in self.rows.references[i]]

    def _expression(self, node: int, name: str) -> Any:
        value = self.graph.value(node)
        if value is not None:
            return sm.Float(value) if value else sm.S.Zero
        return NodeExpression.of(self.graph, node, self.rows.symbols, name)

    def _outputs(self) -> dict[Any, Any]:
        rows, g = self.rows, self.graph
        symbols = output_symbols(rows.contacts)
        found: dict[Any, Any] = {}
        for i in range(len(rows.contacts)):
            normal, tangent = rows.normal[i], rows.tangent[i]
            forces, speeds = ([part[k] for k in tangent] for part in (self.forces, rows.speeds))
            nodes = {
                "gap": rows.gaps[i],
                "normal": rows.pressed[i] if normal is None else self.forces[normal],
                "power": dot(g, forces, speeds),
            }
            for what, parts in (("friction", forces), ("sliding", speeds)):
                nodes |= dict(zip(_names(what, len(tangent)), parts, strict=True))
            for (k, what), symbol in symbols.items():
                if k == i:
                    found[symbol] = self._expression(nodes[what], str(symbol))
            if self.modes[i] == STICKS:
                most = g.powi(g.mul(rows.static[i], nodes["normal"]), 2)
                margin = g.sub(most, dot(g, forces, forces))
                found[margin_symbol(rows.contacts[i])] = self._expression(margin, "margin")
        return found

    def _is_linear(self, node: int) -> bool:
        """Return whether a quantity is linear in the states and time."""
        g = self.graph
        moving = [n for n in g.reachable([node]) if g.ops[n] == "input" and not g.constant[n]]
        (slopes,) = jacobian(g, [node], moving)
        return all(g.constant[n] for n in slopes.values())

    @cached_property
    def events(self) -> tuple[list[Event], list[tuple[str, int]]]:
        """The events that end the mode, with the kind and contact of each.

        A gap on the way up may be zero by rounding: until its speed turns, that is watched. On the
        way down, so is where its speed turns, unless it is as simple as the states: there it is
        lowest, and may have been closed.
        """
        rows, g = self.rows, self.graph
        nodes_of = {symbol: node for node, symbol in rows.symbols.items()}
        nodes: list[int] = []
        kinds: list[tuple[str, int]] = []

        def watch(node: int, what: str, contact: int) -> None:
            if any(g.ops[n] == "input" and not g.constant[n] for n in g.reachable([node])):
                nodes.append(node)
                kinds.append((what, contact))

        for i, mode in enumerate(self.modes):
            normal, tangent = rows.normal[i], rows.tangent[i]
            if mode == OPEN and normal is not None:
                up = g.call("lt", g.zero, nodes_of[rows.rising[i]])
                # The speed may begin as a rounding of either sign.
                speed, bound = rows.speeds[normal], nodes_of[rows.rising[i]]
                watch(g.call("select", up, g.add(speed, bound), rows.gaps[i]), "closes", i)
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
                *reference, _, clear = self._reference(i)
                ahead, square = (dot(g, speeds, other) for other in (reference, speeds))
                watch(ahead, "stops", i)
                if mode == STARTING:
                    watch(g.sub(g.powi(clear, 2), square), "clears", i)
                else:
                    slow, along = g.powi(clear, 2), g.powi(ahead, 2)
                    watch(g.sum([(slow, 1.0), (along, 1.0), (square, -(TURNED**2))]), "bends", i)
            elif mode in SLIDES:
                bound = nodes_of[rows.rising[i]]
                watch(g.sum([(speeds[0], SLIDES[mode]), (bound, 1.0)]), "stops", i)
            if mode in SLIDES and i in self.pivots:
                watch(self.pivots[i], "jams", i)
        found = [
            (Turn if what == "nears" else Event)(
                self._expression(node, what),
                direction=-1,
                terminal=what != "nears",
                name=f"{k}: {_WATCHED.get(what, what)} of {rows.contacts[i].name}",
            )
            for k, (node, (what, i)) in enumerate(zip(nodes, kinds, strict=True))
        ]
        return found, kinds

    @property
    def turns(self) -> bool:
        """Whether friction turns a velocity, and derivatives quickly where it stops it."""
        return not {STARTING, SLIDING}.isdisjoint(self.modes)

    @property
    def untimed(self) -> frozenset[int]:
        """Events of sliding in a plane, whose times do not matter where nothing slides on.

        Friction turns velocities ever faster before a stop: expressions have no slopes there.
        """
        kinds, own = self.events[1], ("stops", "bends", "clears")
        return frozenset(
            k for k, (what, i) in enumerate(kinds) if what in own and i in self.rows.references
        )


def _names(what: str, number: int) -> list[str]:
    """Return the names of the parts of a tangential quantity."""
    return [what] if number == 1 else [f"{what}_{k + 1}" for k in range(number)]


# -- Modes as they occur ---------------------------------------------------------------------------

_GAP, _FRICTION = ("closes", "opens", "rests"), ("slips", "stops")


class Compiled:
    """The compiled parts of a definition: rows of the contacts, and modes as they occur."""

    def __init__(
        self,
        now: Problem,
        contacts: tuple[Contact, ...],
        hypothesis: str,
    ) -> None:
        self.hypothesis = hypothesis  # of restitution
        self.definition, self.contacts = now.definition, contacts
        self.rows = ContactRows(
            now.definition.equations, contacts, now.definition.constants, now.definition.specifieds
        )
        kinds = now.definition.symbols_by_kind
        others = (s for kind, symbols in kinds.items() if kind != "output" for s in symbols)
        check_names(self.rows, kinds["output"], (*others, *now.definition.constants))
        self.symbols = output_symbols(contacts)
        self.stated = list(self.symbols.values())
        self.named = Columns({**kinds, "output": (*kinds["output"], *self.stated)})
        self.constants = (*self.definition.constants, *self.rows.hidden)
        self.modes: dict[tuple[tuple[str, ...], tuple[int, ...]], tuple[Mode, Model]] = {}
        self._specifieds = now.settings.specifieds
        self._lock = _forks.Lock()

    def __reduce__(self) -> tuple[Any, ...]:  # another process compiles its own
        return type(None), ()

    @property
    def outputs(self) -> tuple[Any, ...]:
        """The symbols of a trajectory's outputs."""
        definition = self.definition
        users = definition.symbols_by_kind["output"]
        return (*users, *self.stated, *definition.residuals)

    @property
    def transitions(self) -> tuple[str, ...]:
        """The names of the events of contacts."""
        found: list[str] = []
        for c in self.contacts:
            found += [f"{c.name} {what}" for what in _GAP] if c.unilateral is not None else []
            found += [f"{c.name} {what}" for what in _FRICTION] if c.stick is not None else []
        return tuple(found)

    def mode(self, modes: tuple[str, ...], held: tuple[int, ...], every: Any) -> tuple[Mode, Model]:
        """Return a Mode and its Model, which is everyone's."""
        key = modes, held
        known = self.modes.get(key)
        if known is None:
            made = Mode(self.rows, modes, held, every)
            model = Model.of(made.equations, **self.settings(made))
            made.columns = self._columns(made, model.definition)
            with self._lock:
                known = self.modes.setdefault(key, (made, model))
        return known

    def settings(self, made: Mode) -> dict[str, Any]:
        """Return what a Model or a System of a Mode's equations is made of, beside these."""
        definition = self.definition
        others, called = {*definition.residuals, *definition.forces}, dict(definition.labels)
        users: dict[Any, Any] = {}
        for group in definition.groups:
            if others.isdisjoint(group.names):
                names = tuple(called.get(name, name) for name in group.names)
                several = len(names) > 1
                users[names if several else names[0]] = (
                    group.expressions if several else group.expressions[0]
                )
        return {
            "outputs": {**users, **made.outputs},
            "specifieds": dict(self._specifieds),
            "constants_symbols": self.constants,
            "specifieds_symbols": self.definition.specifieds,
        }

    def _columns(self, made: Mode, definition: Any) -> list[int]:
        """Return which outputs of a mode are the trajectory's; note where all of them are."""
        made.places = {symbol: k for k, symbol in enumerate(definition.outputs_symbols)}
        base = self.definition
        constraints = base.equations.constraints
        h, n = len(constraints.holonomic), len(constraints.nonholonomic)
        residuals = list(definition.residuals)
        kept = [*residuals[:h], *residuals[len(residuals) - n :]] if n else residuals[:h]
        users = base.symbols_by_kind["output"]
        return [made.places[s] for s in (*users, *self.stated, *kept)]
