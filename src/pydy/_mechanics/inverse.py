"""Inverse dynamics on the graph, its terms, and partial velocities.

With the accelerations u' given, those of the bodies follow from the inner ones outwards, and the
generalised forces

    τ = M u' − F,        F: loads, gravity and velocity-dependent inertia forces,

from the outer ones inwards: the recursive Newton–Euler algorithm (Featherstone, Rigid Body Dynamics
Algorithms, 2008, ch. 5). All speeds count as free. If forces act at some of the speeds only, τ_S,
they and the constraint forces Jᵀ λ follow from the rows of the other speeds:

    τ = τ_S + Jᵀ λ,        J: derivatives of the velocity constraints with respect to the speeds.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

from sympy.physics.mechanics import Point

from pydy._collector import collector_paused
from pydy._graph import (
    Graph,
    LinearSystem,
    NodeExpression,
    SymPyReader,
    inputs_of,
    jacobian,
    operation_count,
    signatures,
    substitute,
)
from pydy._mechanics.elimination import composite, partials
from pydy._mechanics.formulations import (
    alike,
    cancelling_inputs,
    lagranges_equations,
    moving,
    useful_axes,
)
from pydy._mechanics.frame_tree import FrameTree, distances, steps_to
from pydy._mechanics.inertia import Load, composite_contributions, weights_of
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.reader import is_rigid

if TYPE_CHECKING:
    import sympy as sm
    from sympy.physics.mechanics import ReferenceFrame, Vector

    from pydy._sympy_types import AnySymbol


class SymbolicNodes(NamedTuple):
    """Nodes, and the symbols of their graph's inputs: q, u, u', constants and specifieds."""

    graph: Graph
    nodes: Vec
    symbols: dict[int, AnySymbol]

    def expressions(self) -> list[sm.Expr]:
        """Return SymPy expressions."""
        return [NodeExpression.of(self.graph, n, self.symbols, "…") for n in self.nodes]

    def read(self, reader: SymPyReader) -> list[int]:
        """Return nodes of a reader's graph: what they share is read once."""
        g = self.graph
        inputs = [n for n in g.reachable(self.nodes) if g.ops[n] == "input"]
        names = {n: reader(self.symbols[n]) for n in inputs}
        return substitute(g, self.nodes, names, into=reader.graph)


class BodyDynamics:
    """Quantities of a Multibody as nodes, in the given `symbols`; None allows all symbols.

    Other symbols do not affect the motion. They are eliminated where they cancel, or replaced by
    one of the `values`, as the position of a base. Those that remain are refused by the reader of
    the nodes. The `zeros` are noncontributing forces, which are set to zero.
    """

    def __init__(
        self,
        symbols: Collection[AnySymbol] | None,
        zeros: Iterable[AnySymbol],
        values: Mapping[AnySymbol, float],
    ) -> None:
        self.symbols, self.zeros, self.values = symbols, frozenset(zeros), values

    def in_symbols(self, kinematics: Kinematics, nodes: Sequence[int]) -> SymbolicNodes:
        """Return nodes in terms of the allowed symbols, as far as possible."""
        g, symbols = kinematics.graph, kinematics.symbols()
        allowed = self.symbols
        unknown = [n for n, s in symbols.items() if allowed is not None and s not in allowed]
        zeros = [n for n, s in symbols.items() if s in self.zeros]
        nodes = substitute(g, nodes, dict.fromkeys(zeros, g.zero))
        reachable = set(g.reachable(nodes))
        foreign = [n for n in unknown if n in reachable]
        if foreign:
            fixed = {n: self.values[s] for n in foreign if (s := symbols[n]) in self.values}
            replacements = {n: g.const(value) for n, value in fixed.items()}
            replacements.update(dict.fromkeys(cancelling_inputs(g, nodes, foreign), g.zero))
            nodes = substitute(g, nodes, replacements)
        return SymbolicNodes(g, [*nodes], symbols)

    @collector_paused()
    def inverse_dynamics(
        self, body: Multibody, at: Sequence[int] | None = None, *, bound: Sequence[int] = ()
    ) -> SymbolicNodes:
        """Return the generalised forces that produce given accelerations, in q, u and u'.

        They act at all speeds, or at the speeds numbered `at`, as many as there are degrees of
        freedom. The u' of the speeds numbered `bound` follow from those of the others.
        """
        kinematics, forces = _required(body)
        g, n, rates = kinematics.graph, len(kinematics.speeds), kinematics.accelerations
        rows = kinematics.read.all(body.constraints.velocity) if bound or at is not None else []
        slopes = jacobian(g, rows, kinematics.speeds).dense()
        if at is not None:
            other_speeds = [k for k in range(n) if k not in at]
            matrix = [[row[k] for row in slopes] for k in other_speeds]
            multipliers = (
                LinearSystem(g, matrix).solve([forces[k] for k in other_speeds])
                if other_speeds
                else []
            )
            chosen_forces = []
            for k in at:
                terms = [
                    (g.mul(row[k], s), -1.0) for row, s in zip(slopes, multipliers, strict=True)
                ]
                chosen_forces.append(g.sum([(forces[k], 1.0), *terms]))
            forces = chosen_forces
        if bound:
            unknown = [rates[k] for k in bound]
            residuals = kinematics.read.all(body.constraints.acceleration) or kinematics.dt(rows)
            matrix = jacobian(g, residuals, unknown).dense()
            drift = substitute(g, residuals, dict.fromkeys(unknown, g.zero))
            solved = LinearSystem(g, matrix).solve([g.neg(node) for node in drift])
            forces = substitute(g, forces, dict(zip(unknown, solved, strict=True)))
        return self.in_symbols(kinematics, forces)

    @collector_paused()
    def mass_matrix(self, body: Multibody) -> SymbolicNodes:
        """Return M of all speeds without constraints, row by row."""
        if body.lagrangian is not None:
            kinematics = moving(body, in_bodies=True)
            matrix, forcing = lagranges_equations(kinematics)
        else:
            kinematics = moving(body, in_bodies=True, gravity_as_acceleration=True)
            inertias, loads, _ = composite_contributions(kinematics)
            matrix, forcing = composite(kinematics, inertias, loads)
        g = kinematics.graph
        moved = jacobian(g, forcing, kinematics.accelerations).dense()
        pairs = zip(matrix, moved, strict=True)
        cells = [g.sub(m, f) for row, part in pairs for m, f in zip(row, part, strict=True)]
        return self.in_symbols(kinematics, cells)

    @collector_paused()
    def holding_forces(
        self, body: Multibody, acceleration: Vector | None = None
    ) -> SymbolicNodes | None:
        """Return the generalised forces that hold the bodies against gravity, at all speeds.

        Its `acceleration` is by default the one common to the loads at all mass centres; None if
        that cannot be identified.
        """
        user_kinematics = Kinematics(body, in_bodies=True)
        gravity = (
            None
            if acceleration is None
            else user_kinematics.vector(acceleration, user_kinematics.inertial)
        )
        if gravity is None and body.lagrangian is None:
            gravity = _common_gravity(user_kinematics)
        if gravity is None:
            return None
        kinematics = moving(body, in_bodies=True, gravity_as_acceleration=True)
        symbols, g = user_kinematics.symbols(), kinematics.graph
        gravity_nodes = kinematics.read.all(
            [NodeExpression.of(user_kinematics.graph, node, symbols) for node in gravity]
        )
        forces = _generalized_forces(kinematics, weights_of(kinematics, gravity_nodes))
        return self.in_symbols(kinematics, [g.neg(node) for node in forces])

    @collector_paused()
    def regressor(
        self, body: Multibody, acceleration: Vector | None = None
    ) -> SymbolicNodes | None:
        """Return Y of τ = Y π + …, row by row, with the inertial parameters π of `parameters`.

        With the acceleration a of the mass centre, less gravity, and the angular velocity and
        acceleration in the body's axes, a mass m with the first moment h and the inertia I about
        that point takes the force m a + α × h + ω × (ω × h) and the torque h × a + I α + ω × I ω:
        linear in the ten (Khalil, Dombre, Modeling, Identification and Control of Robots, 2002,
        ch. 9). Gravity is found as in `holding_forces`.
        """
        kinematics = moving(body, in_bodies=True, driven=True)
        gravity = (
            None if acceleration is None else kinematics.vector(acceleration, kinematics.inertial)
        )
        if gravity is None and body.lagrangian is None:
            gravity = _common_gravity(kinematics)
        if gravity is None:
            return None
        _refuse_varying_masses(kinematics)
        g, columns = kinematics.graph, []
        units = [[g.one if j == i else g.zero for j in range(3)] for i in range(3)]
        for item in body.bodies:
            home, v, _ = kinematics.motion(item.masscenter)
            gravity_here = kinematics.expressed(gravity, kinematics.inertial, home)
            a = [
                g.sub(x, y)
                for x, y in zip(kinematics.acceleration(item.masscenter), gravity_here, strict=True)
            ]
            axes = item.frame if is_rigid(item) else home
            a, v = (kinematics.expressed(part, home, axes) for part in (a, v))
            pairs: list[tuple[Vec, Vec | None]] = [(a, None)]
            partial_velocities = partials(kinematics, v)
            partial_spins: list[Vec] = []
            if is_rigid(item):
                w, _ = kinematics.spin(axes)
                alpha, turning = (
                    kinematics.angular_acceleration(axes, axes),
                    kinematics.turning(axes),
                )
                partial_spins = partials(kinematics, w)
                pairs += [
                    ([row[i] for row in turning], kinematics.cross(unit, a))
                    for i, unit in enumerate(units)
                ]
                for i, j in _ENTRIES:
                    part = [[g.zero] * 3 for _ in range(3)]
                    part[i][j] = part[j][i] = g.one
                    momentum = kinematics.product(part, w)
                    couple = kinematics.plus(
                        kinematics.product(part, alpha), kinematics.cross(w, momentum)
                    )
                    pairs.append(([g.zero] * 3, couple))
            for force, torque in pairs:
                terms = list(zip(partial_velocities, force, strict=True))
                terms += list(zip(partial_spins, torque, strict=True)) if torque is not None else []
                columns.append(
                    [
                        g.sum([(g.mul(row[k], size), 1.0) for row, size in terms])
                        for k in range(len(kinematics.speeds))
                    ]
                )
        return self.in_symbols(kinematics, [n for row in zip(*columns, strict=True) for n in row])

    @collector_paused()
    def inertial_parameters(self, body: Multibody) -> SymbolicNodes:
        """Return the inertial parameters of all bodies: m, m c, the inertia about the mass centre.

        The first moments about the modelled mass centre c are zero. A particle has its mass only.
        """
        kinematics, parameters = moving(body, in_bodies=True), []
        _refuse_varying_masses(kinematics)
        for item in body.bodies:
            parameters.append(kinematics.read(item.mass))
            if is_rigid(item):
                tensor = kinematics.tensor(tuple(item.central_inertia.args), item.frame)
                parameters += [*[kinematics.graph.zero] * 3, *(tensor[i][j] for i, j in _ENTRIES)]
        return self.in_symbols(kinematics, parameters)

    @collector_paused()
    def position(self, body: Multibody, point: Point, origin: Point) -> SymbolicNodes:
        """Return the vector from `origin` to a point, in the axes of the inertial frame."""
        kinematics = moving(body, in_bodies=True)
        total = [kinematics.graph.zero] * 3
        for step in steps_to(point, distances(origin, FrameTree.positions)):
            total = kinematics.plus(total, kinematics.vector(step, body.frame))
        return self.in_symbols(kinematics, total)

    @collector_paused()
    def rotation(self, body: Multibody, frame: ReferenceFrame) -> SymbolicNodes:
        """Return the matrix whose columns are a frame's axes in the inertial frame."""
        kinematics = moving(body, in_bodies=True)
        columns = [kinematics.vector(axis, body.frame) for axis in (frame.x, frame.y, frame.z)]
        return self.in_symbols(kinematics, [column[i] for i in range(3) for column in columns])

    @collector_paused()
    def partial_velocities(
        self, body: Multibody, point: Point | None, frame: ReferenceFrame | None
    ) -> SymbolicNodes:
        """Return a point's partial velocities and a frame's partial angular velocities.

        Either may be None. Components are in the inertial frame; rows come one after the other.
        """
        kinematics = moving(body, in_bodies=True, further_points=() if point is None else (point,))
        cells: Vec = []
        for item in (point, frame):
            if item is not None:
                home, velocity = kinematics.velocity_of(item)
                rows = partials(kinematics, kinematics.expressed(velocity, home, body.frame))
                cells += [n for row in rows for n in row]
        return self.in_symbols(kinematics, cells)


def _required(body: Multibody) -> tuple[Kinematics, Vec]:
    """Return the forces at all speeds, in the axes that need the fewest operations."""
    if body.lagrangian is not None:
        kinematics = moving(body, in_bodies=True, driven=True)
        forcing = lagranges_equations(kinematics)[1]
        return kinematics, [kinematics.graph.neg(node) for node in forcing]
    candidates = []
    for in_bodies in useful_axes(body):
        kinematics = moving(body, in_bodies, gravity_as_acceleration=in_bodies, driven=True)
        loads = composite_contributions(kinematics)[1]
        forces = [kinematics.graph.neg(node) for node in _generalized_forces(kinematics, loads)]
        candidates.append((operation_count(kinematics.graph, forces), kinematics, forces))
    return min(candidates, key=lambda item: item[0])[1:]


_ENTRIES = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))


def _refuse_varying_masses(kinematics: Kinematics) -> None:
    """Raise an error if a mass is not constant: forces contain m' v, which is not linear in m."""
    g = kinematics.graph
    for body in kinematics.body.bodies:
        if any(not g.constant[n] for n in inputs_of(g, [kinematics.read(body.mass)])):
            raise ValueError(
                f"The mass of {body.name}, {body.mass}, may change with time: forces are not "
                "linear in it then. Regressors and inertial parameters need masses that are "
                "numbers or constants; `inverse_dynamics` has no such limit."
            )


def _common_gravity(kinematics: Kinematics) -> Vec | None:
    """Return the acceleration that the loads give to all mass centres, None if it is ambiguous.

    Loads proportional to a symbolic mass are together its weight. At a numeric mass each load may
    be the weight: it is the one that all bodies have in common.
    """
    g, loads = kinematics.graph, dict(enumerate(kinematics.body.loads))
    nothing = [g.zero] * 3
    pulls: list[list[Vec]] = []
    masses: list[tuple[int, list[int]]] = []
    elsewhere = {k for k, (location, _) in loads.items() if isinstance(location, Point)}
    centres = [body.masscenter for body in kinematics.body.bodies]
    position_keys = _position_keys(
        kinematics, [*centres, *(loads[k][0] for k in sorted(elsewhere))]
    )
    for body in kinematics.body.bodies:
        mass = kinematics.read(body.mass)
        if mass == g.zero:
            continue
        inputs = inputs_of(g, [mass])
        mass_symbols = [n for n in inputs if g.constant[n]] or [*inputs]
        masses.append((mass, mass_symbols))
        loads_here = [
            k
            for k, (location, _) in loads.items()
            if position_keys.get(location) == position_keys[body.masscenter]
        ]
        elsewhere.difference_update(loads_here)
        body_pulls = _pulls(kinematics, [loads[k][1] for k in loads_here], mass, mass_symbols)
        if body_pulls is None:
            return None
        if mass_symbols:
            total = [g.sum([(n, 1.0) for n in parts]) for parts in zip(*body_pulls, strict=True)]
            body_pulls = [total] if body_pulls and total != nothing else []
        pulls.append(body_pulls)
    if not any(pulls):  # a weight may act at another point, such as the common mass centre
        unassigned = [loads[k][1] for k in sorted(elsewhere)]
        heavy = any(_pulls(kinematics, unassigned, *mass) for mass in masses if mass[1])
        return None if heavy else nothing
    if len(pulls) == 1 and len(pulls[0]) > 1:
        return None
    common = nothing
    for fall in pulls[0]:
        matching = [
            [k for k, candidate in enumerate(body_pulls) if alike(g, fall, candidate)]
            for body_pulls in pulls[1:]
        ]
        if all(matching):
            common = kinematics.plus(common, fall)
            for body_pulls, matches in zip(pulls[1:], matching, strict=True):
                body_pulls.pop(matches[0])
    return None if common == nothing else common


def _position_keys(
    kinematics: Kinematics, points: Sequence[Point]
) -> dict[Point, tuple[Point | int, ...]]:
    """Return keys that are equal for points at equal positions: signatures of the coordinates.

    Positions are measured from the first of the points that are connected.
    """
    keys: dict[Point, tuple[Point | int, ...]] = {}
    for first in points:
        if first in keys:
            continue
        positions = {first: [kinematics.graph.zero] * 3}
        for point, before in FrameTree.points_from([first]).items():
            if before is not None:
                step = kinematics.vector(FrameTree.positions(point)[before], kinematics.inertial)
                positions[point] = kinematics.plus(positions[before], step)
        reached = [point for point in dict.fromkeys(points) if point in positions]
        numbers = iter(
            signatures(kinematics.graph, [n for point in reached for n in positions[point]])
        )
        keys |= {point: (first, *(next(numbers) for _ in range(3))) for point in reached}
    return keys


def _pulls(
    kinematics: Kinematics, loads: Iterable[Vector], mass: int, mass_symbols: Sequence[int]
) -> list[Vec] | None:
    """Return the constant accelerations of loads that are proportional to a mass.

    `mass_symbols` are the symbols in the mass. None if a load may be the sum of a weight and
    others.
    """
    g, zero = kinematics.graph, kinematics.graph.zero
    forces = [_steady(kinematics, kinematics.vector(v, kinematics.inertial)) for v in loads]
    slopes = [
        row.get(k, zero)
        for row in jacobian(g, [mass], mass_symbols)
        for k in range(len(mass_symbols))
    ]
    constant: list[Vec] = []
    remaining: list[Vec] = []
    unclear = False
    for last in (False, True):  # each part of a mass may have its own load: add up the rest
        if last:
            forces = [[g.sum([(n, 1.0) for n in x]) for x in zip(*remaining, strict=True)]] * bool(
                remaining
            )
        for force in forces:
            if mass_symbols:
                rows = jacobian(g, force, mass_symbols).dense()
                falls = [
                    [g.div(row[k], slope) for row in rows]
                    for k, slope in enumerate(slopes)
                    if slope != zero
                ]
            else:
                falls = [[g.div(node, mass) for node in force]]
            falls = falls or [[zero] * 3]
            nonzero = [any(n != zero for n in fall) for fall in falls]
            if not any(nonzero):
                continue
            if all(g.constant[n] for fall in falls for n in fall) and all(
                alike(g, falls[0], fall) for fall in falls
            ):
                constant.append(falls[0])
            elif mass_symbols and not last:
                remaining.append(force)
            elif any(_partly_constant(g, n) for fall in falls for n in fall):
                if mass_symbols and all(nonzero):
                    return None
                unclear = True  # a number may be a weight, or the rest length of a spring
            elif mass_symbols:
                unclear = True
    return None if unclear and not constant else constant


def _steady(kinematics: Kinematics, force: Vec) -> Vec:
    """Return a force with its part at rest replaced by a constant, if that part is constant.

    A weight that is written along rotating axes contains their angles although it is constant.
    """
    g = kinematics.graph
    force_at_rest = substitute(g, force, dict.fromkeys(kinematics.speeds, g.zero))
    moved = inputs_of(g, force_at_rest).moving
    at_origin = substitute(g, force_at_rest, dict.fromkeys(moved, g.zero))
    if not moved or not kinematics.equal(at_origin, force_at_rest):
        return force
    return kinematics.plus(
        at_origin, [g.sub(a, b) for a, b in zip(force, force_at_rest, strict=True)]
    )


def _partly_constant(g: Graph, node: int) -> bool:
    """Return whether a node is a constant other than zero, or a sum of sums with such a term."""
    if g.ops[node] != "sum":
        return g.constant[node] and node != g.zero
    constant, terms = g.args[node]
    return constant != 0.0 or any(_partly_constant(g, n) for n, _ in terms)


def _generalized_forces(kinematics: Kinematics, loads: list[Load]) -> Vec:
    """Return the generalised forces of the loads."""
    return composite(kinematics, [], loads)[1]
