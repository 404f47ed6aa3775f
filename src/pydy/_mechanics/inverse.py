"""Inverse dynamics on the graph, the parts it is made of, and how places move with the speeds.

With the accelerations u' given, those of the bodies follow from the inner ones outwards, and the
generalised forces

    τ = M u' − F,        F: loads, gravity and what the speeds bring,

from the outer ones inwards: the recursive Newton–Euler algorithm (Featherstone, Rigid Body Dynamics
Algorithms, 2008, ch. 5). No constraint holds a speed. What forces at some of the speeds alone, τ_S,
do together with those of the constraints, Jᵀ λ, follows from the rows of the other speeds:

    τ = τ_S + Jᵀ λ,        J: the velocity constraints' derivatives by the speeds.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from sympy.physics.mechanics import Point

from pydy._collector import collector_paused
from pydy._graph import (
    Graph,
    NodeExpression,
    SymPyReader,
    jacobian,
    operation_count,
    signatures,
    substitute,
)
from pydy._mechanics.elimination import composite, partials
from pydy._mechanics.form import (
    alike,
    idle_inputs,
    lagranges_equations,
    moving,
    useful_axes,
)
from pydy._mechanics.frame_tree import FrameTree, distances, steps_to
from pydy._mechanics.inertia import Load, lumped, weights_of
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.reader import is_rigid


class Found(NamedTuple):
    """Nodes, in what the inputs of their graph stand for: q, u, u', constants and specifieds."""

    graph: Graph
    nodes: Vec
    symbols: dict[int, Any]

    def expressions(self) -> list[Any]:
        """Return SymPy expressions."""
        return [NodeExpression.of(self.graph, n, self.symbols, "…") for n in self.nodes]

    def read(self, reader: SymPyReader) -> list[int]:
        """Return nodes of a reader's graph: what they share is read once."""
        g = self.graph
        inputs = [n for n in g.reachable(self.nodes) if g.ops[n] == "input"]
        names = {n: reader(self.symbols[n]) for n in inputs}
        return substitute(g, self.nodes, names, into=reader.graph)


class BodyDynamics:
    """Quantities of a Multibody as nodes, in some known `symbols`; None allows all symbols.

    Symbols that are not known affect no motion. Where they cancel they are left out; the place of a
    base does not: it has one of the `values`. Others stay, and who reads them names them. The
    `zeros` are noncontributing forces, which stand for what others compute.
    """

    def __init__(
        self, symbols: Collection[Any] | None, zeros: Iterable[Any], values: Mapping[Any, float]
    ) -> None:
        self.symbols, self.zeros, self.values = symbols, frozenset(zeros), values

    def in_symbols(self, kinematics: Kinematics, nodes: Sequence[int]) -> Found:
        """Return nodes in what is known."""
        g, symbols = kinematics.graph, kinematics.symbols()
        known = self.symbols
        unknown = [n for n, s in symbols.items() if known is not None and s not in known]
        zeros = [n for n, s in symbols.items() if s in self.zeros]
        nodes = substitute(g, nodes, dict.fromkeys(zeros, g.zero))
        held = set(g.reachable(nodes))
        strange = [n for n in unknown if n in held]
        if strange:
            own = {n: self.values[s] for n in strange if (s := symbols[n]) in self.values}
            given = {n: g.const(value) for n, value in own.items()}
            given.update(dict.fromkeys(idle_inputs(g, nodes, strange), g.zero))
            nodes = substitute(g, nodes, given)
        return Found(g, [*nodes], symbols)

    @collector_paused()
    def inverse_dynamics(
        self, body: Multibody, at: Sequence[int] | None = None, *, bound: Sequence[int] = ()
    ) -> Found:
        """Return the generalised forces that given accelerations take, in q, u and u'.

        They act at all speeds, or at the places `at`, as many as the constraints leave free. The u'
        of the speeds at the places `bound` follow from those of the others.
        """
        kinematics, forces = _required(body)
        g, n, rates = kinematics.graph, len(kinematics.speeds), kinematics.accelerations
        rows = kinematics.read.all(body.velocity) if bound or at is not None else []
        slopes = jacobian(g, rows, kinematics.speeds).dense()
        if at is not None:
            others = [k for k in range(n) if k not in at]
            held = [[row[k] for row in slopes] for k in others]
            shares = g.solve(held, [[forces[k] for k in others]], "lu")[0] if others else []
            found = []
            for k in at:
                terms = [(g.mul(row[k], s), -1.0) for row, s in zip(slopes, shares, strict=True)]
                found.append(g.sum([(forces[k], 1.0), *terms]))
            forces = found
        if bound:
            unknown = [rates[k] for k in bound]
            residuals = kinematics.read.all(body.acceleration) or kinematics.dt(rows)
            held = jacobian(g, residuals, unknown).dense()
            drift = substitute(g, residuals, dict.fromkeys(unknown, g.zero))
            solved = g.solve(held, [[g.neg(node) for node in drift]], "lu")[0]
            forces = substitute(g, forces, dict(zip(unknown, solved, strict=True)))
        return self.in_symbols(kinematics, forces)

    @collector_paused()
    def mass_matrix(self, body: Multibody) -> Found:
        """Return M of all speeds, which no constraint holds, row by row."""
        if body.lagrangian is not None:
            kinematics = moving(body, in_bodies=True)
            matrix, forcing = lagranges_equations(kinematics)
        else:
            kinematics = moving(body, in_bodies=True, falling=True)
            inertias, loads, _ = lumped(kinematics)
            matrix, forcing = composite(kinematics, inertias, loads)
        g = kinematics.graph
        moved = jacobian(g, forcing, kinematics.accelerations).dense()
        pairs = zip(matrix, moved, strict=True)
        cells = [g.sub(m, f) for row, part in pairs for m, f in zip(row, part, strict=True)]
        return self.in_symbols(kinematics, cells)

    @collector_paused()
    def weights(self, body: Multibody, pull: Any = None) -> Found | None:
        """Return the forces that hold all masses against gravity; None where no load tells it.

        It pulls as `pull`, by default as what is common to the loads at all mass centres.
        """
        plain = Kinematics(body, in_bodies=True)
        fall = None if pull is None else plain.vector(pull, plain.inertial)
        if fall is None and body.lagrangian is None:
            fall = _common_pull(plain)
        if fall is None:
            return None
        kinematics = moving(body, in_bodies=True, falling=True)
        symbols, g = plain.symbols(), kinematics.graph
        down = kinematics.read.all([NodeExpression.of(plain.graph, node, symbols) for node in fall])
        forces = _pushed(kinematics, weights_of(kinematics, down))
        return self.in_symbols(kinematics, [g.neg(node) for node in forces])

    @collector_paused()
    def regressor(self, body: Multibody) -> Found | None:
        """Return Y of τ = Y π + …, row by row, with the inertial parameters π of `parameters`.

        With the acceleration a of the mass centre, less gravity, and the angular velocity and
        acceleration in the body's axes, a mass m with the first moment h and the inertia I about
        that point takes the force m a + α × h + ω × (ω × h) and the torque h × a + I α + ω × I ω:
        linear in the ten (Khalil, Dombre, Modeling, Identification and Control of Robots, 2002,
        ch. 9). None where no load tells what gravity is.
        """
        kinematics = moving(body, in_bodies=True, driven=True)
        fall = None if body.lagrangian is not None else _common_pull(kinematics)
        if fall is None:
            return None
        _refuse_varying_masses(kinematics)
        g, columns = kinematics.graph, []
        units = [[g.one if j == i else g.zero for j in range(3)] for i in range(3)]
        for item in body.bodies:
            home, v, _ = kinematics.motion(item.masscenter)
            down = kinematics.expressed(fall, kinematics.inertial, home)
            a = [
                g.sub(x, y)
                for x, y in zip(kinematics.acceleration(item.masscenter), down, strict=True)
            ]
            axes = item.frame if is_rigid(item) else home
            a, v = (kinematics.expressed(part, home, axes) for part in (a, v))
            pairs: list[tuple[Vec, Vec | None]] = [(a, None)]
            moved = partials(kinematics, v)
            turned: list[Vec] = []
            if is_rigid(item):
                w, _ = kinematics.spin(axes)
                alpha, turning = (
                    kinematics.angular_acceleration(axes, axes),
                    kinematics.turning(axes),
                )
                turned = partials(kinematics, w)
                pairs += [
                    ([row[i] for row in turning], kinematics.cross(unit, a))
                    for i, unit in enumerate(units)
                ]
                for i, j in _ENTRIES:
                    part = [[g.zero] * 3 for _ in range(3)]
                    part[i][j] = part[j][i] = g.one
                    momentum = kinematics.turned(part, w)
                    couple = kinematics.plus(
                        kinematics.turned(part, alpha), kinematics.cross(w, momentum)
                    )
                    pairs.append(([g.zero] * 3, couple))
            for force, torque in pairs:
                terms = list(zip(moved, force, strict=True))
                terms += list(zip(turned, torque, strict=True)) if torque is not None else []
                columns.append(
                    [
                        g.sum([(g.mul(row[k], size), 1.0) for row, size in terms])
                        for k in range(len(kinematics.speeds))
                    ]
                )
        return self.in_symbols(kinematics, [n for row in zip(*columns, strict=True) for n in row])

    @collector_paused()
    def inertial_parameters(self, body: Multibody) -> Found:
        """Return the inertial parameters of all bodies: m, m c, the inertia about the mass centre.

        The mass centre c is where the model has it, so that its first moments are zero. A particle
        has its mass alone.
        """
        kinematics, found = moving(body, in_bodies=True), []
        _refuse_varying_masses(kinematics)
        for item in body.bodies:
            found.append(kinematics.read(item.mass))
            if is_rigid(item):
                tensor = kinematics.tensor(tuple(item.central_inertia.args), item.frame)
                found += [*[kinematics.graph.zero] * 3, *(tensor[i][j] for i, j in _ENTRIES)]
        return self.in_symbols(kinematics, found)

    @collector_paused()
    def position(self, body: Multibody, point: Any, origin: Any) -> Found:
        """Return the way from a point to another, in the axes of the inertial frame."""
        kinematics = moving(body, in_bodies=True)
        total = [kinematics.graph.zero] * 3
        for step in steps_to(point, distances(origin, FrameTree.positions)):
            total = kinematics.plus(total, kinematics.vector(step, body.frame))
        return self.in_symbols(kinematics, total)

    @collector_paused()
    def rotation(self, body: Multibody, frame: Any) -> Found:
        """Return the matrix whose columns are a frame's axes in the inertial frame."""
        kinematics = moving(body, in_bodies=True)
        columns = [kinematics.vector(axis, body.frame) for axis in (frame.x, frame.y, frame.z)]
        return self.in_symbols(kinematics, [column[i] for i in range(3) for column in columns])

    @collector_paused()
    def partial_velocities(self, body: Multibody, point: Any, frame: Any) -> Found:
        """Return a point's partial velocities and a frame's partial angular velocities.

        Either may be None. Components are in the inertial frame; rows come one after the other.
        """
        kinematics = moving(body, in_bodies=True, more=() if point is None else (point,))
        found: Vec = []
        for where in (point, frame):
            if where is not None:
                home, own = kinematics.at(where)
                rows = partials(kinematics, kinematics.expressed(own, home, body.frame))
                found += [n for row in rows for n in row]
        return self.in_symbols(kinematics, found)


def _required(body: Multibody) -> tuple[Kinematics, Vec]:
    """Return the forces at all speeds, in the axes that take fewest operations."""
    if body.lagrangian is not None:
        kinematics = moving(body, in_bodies=True, driven=True)
        forcing = lagranges_equations(kinematics)[1]
        return kinematics, [kinematics.graph.neg(node) for node in forcing]
    found = []
    for in_bodies in useful_axes(body):
        kinematics = moving(body, in_bodies, falling=in_bodies, driven=True)
        loads = lumped(kinematics)[1]
        forces = [kinematics.graph.neg(node) for node in _pushed(kinematics, loads)]
        found.append((operation_count(kinematics.graph, forces), kinematics, forces))
    return min(found, key=lambda item: item[0])[1:]


_ENTRIES = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))


def _refuse_varying_masses(kinematics: Kinematics) -> None:
    """Raise an error if a mass is no constant: forces have a part m' v, which is none of m."""
    g = kinematics.graph
    for body in kinematics.body.bodies:
        if any(not g.constant[n] for n in g.inputs([kinematics.read(body.mass)])):
            raise ValueError(
                f"The mass of {body.name}, {body.mass}, may change with time: forces are not "
                "linear in it then. Regressors and inertial parameters need masses that are "
                "numbers or constants; `inverse_dynamics` has no such limit."
            )


def _common_pull(kinematics: Kinematics) -> Vec | None:
    """Return the acceleration that the loads give all mass centres alike, None if that is unclear.

    Loads proportional to a mass of symbols are its weight together. Of those at masses that are
    numbers each may be a weight, which is what all bodies have in common.
    """
    g, loads = kinematics.graph, dict(enumerate(kinematics.body.loads))
    nothing = [g.zero] * 3
    found: list[list[Vec]] = []
    masses: list[tuple[int, list[int]]] = []
    elsewhere = {k for k, (where, _) in loads.items() if isinstance(where, Point)}
    centres = [body.masscenter for body in kinematics.body.bodies]
    at = _places_of(kinematics, [*centres, *(loads[k][0] for k in sorted(elsewhere))])
    for body in kinematics.body.bodies:
        mass = kinematics.read(body.mass)
        if mass == g.zero:
            continue
        inputs = g.inputs([mass])
        by = [n for n in inputs if g.constant[n]] or inputs
        masses.append((mass, by))
        here = [k for k, (where, _) in loads.items() if at.get(where) == at[body.masscenter]]
        elsewhere.difference_update(here)
        own = _pulls(kinematics, [loads[k][1] for k in here], mass, by)
        if own is None:
            return None
        if by:
            total = [g.sum([(n, 1.0) for n in parts]) for parts in zip(*own, strict=True)]
            own = [total] if own and total != nothing else []
        found.append(own)
    if not any(found):  # a weight may be at another point, such as the centre of all masses
        rest = [loads[k][1] for k in sorted(elsewhere)]
        heavy = any(_pulls(kinematics, rest, *mass) for mass in masses if mass[1])
        return None if heavy else nothing
    if len(found) == 1 and len(found[0]) > 1:
        return None
    common = nothing
    for fall in found[0]:
        like = [[k for k, other in enumerate(own) if alike(g, fall, other)] for own in found[1:]]
        if all(like):
            common = kinematics.plus(common, fall)
            for own, places_ in zip(found[1:], like, strict=True):
                own.pop(places_[0])
    return None if common == nothing else common


def _places_of(kinematics: Kinematics, points: Sequence[Any]) -> dict[Any, Any]:
    """Return what is the same for points in the same place: numbers that stand for where they are.

    Each place is reached once, from the first point that is connected with it.
    """
    found: dict[Any, Any] = {}
    for first in points:
        if first in found:
            continue
        way = {first: [kinematics.graph.zero] * 3}
        for point, before in FrameTree.points_from([first]).items():
            if before is not None:
                step = kinematics.vector(FrameTree.positions(point)[before], kinematics.inertial)
                way[point] = kinematics.plus(way[before], step)
        here = [point for point in dict.fromkeys(points) if point in way]
        numbers = iter(signatures(kinematics.graph, [n for point in here for n in way[point]]))
        found |= {point: (first, *(next(numbers) for _ in range(3))) for point in here}
    return found


def _pulls(
    kinematics: Kinematics, loads: Iterable[Any], mass: int, by: Sequence[int]
) -> list[Vec] | None:
    """Return constant accelerations that loads are proportional to a mass with.

    `by` are the symbols in the mass. None where a load may hold a weight beside others.
    """
    g, zero = kinematics.graph, kinematics.graph.zero
    forces = [_steady(kinematics, kinematics.vector(v, kinematics.inertial)) for v in loads]
    slopes = [row.get(k, zero) for row in jacobian(g, [mass], by) for k in range(len(by))]
    own: list[Vec] = []
    left: list[Vec] = []
    unclear = False
    for last in (False, True):  # parts of a mass may have a load each: what is left is added up
        if last:
            forces = [[g.sum([(n, 1.0) for n in x]) for x in zip(*left, strict=True)]] * bool(left)
        for force in forces:
            if by:
                rows = jacobian(g, force, by).dense()
                falls = [
                    [g.div(row[k], slope) for row in rows]
                    for k, slope in enumerate(slopes)
                    if slope != zero
                ]
            else:
                falls = [[g.div(node, mass) for node in force]]
            falls = falls or [[zero] * 3]
            held = [any(n != zero for n in fall) for fall in falls]
            if not any(held):
                continue
            if all(g.constant[n] for fall in falls for n in fall) and all(
                alike(g, falls[0], fall) for fall in falls
            ):
                own.append(falls[0])
            elif by and not last:
                left.append(force)
            elif any(_partly_constant(g, n) for fall in falls for n in fall):
                if by and all(held):
                    return None
                unclear = True  # a number may be a weight, or the rest length of a spring
            elif by:
                unclear = True
    return None if unclear and not own else own


def _steady(kinematics: Kinematics, force: Vec) -> Vec:
    """Return a force whose part at rest is a constant, if that is the same everywhere.

    Written along turning axes, a weight holds their angles all the same.
    """
    g = kinematics.graph
    rest = substitute(g, force, dict.fromkeys(kinematics.speeds, g.zero))
    moved = g.inputs(rest, moving=True)
    still = substitute(g, rest, dict.fromkeys(moved, g.zero))
    if not moved or not kinematics.equal(still, rest):
        return force
    return kinematics.plus(still, [g.sub(a, b) for a, b in zip(force, rest, strict=True)])


def _partly_constant(g: Graph, node: int) -> bool:
    """Return whether a node is a constant other than zero, or a sum of sums with such a term."""
    if g.ops[node] != "sum":
        return g.constant[node] and node != g.zero
    constant, terms = g.args[node]
    return constant != 0.0 or any(_partly_constant(g, n) for n, _ in terms)


def _pushed(kinematics: Kinematics, loads: list[Load]) -> Vec:
    """Return the generalised forces of the loads."""
    return composite(kinematics, [], loads)[1]
