"""Equations of motion formed from bodies, loads and kinematics, as nodes of one graph.

Where gravity pulls all masses alike it is an acceleration of the inertial frame: one vector on its
way outwards in place of a force at each body. Velocities that the user set hold, also where they
are not the rates of places. Noncontributing forces that cancel are left out: with dependent speeds
a contact force may be left as r R − r R.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef

from pydy._collector import collector_paused
from pydy._graph import (
    Graph,
    NodeExpression,
    SymPyReader,
    hessian,
    jacobian,
    rounding_bounds,
    signatures,
    substitute,
)
from pydy._mechanics.alignment import align, in_a_plane, move_along_axes
from pydy._mechanics.components import numbers_of
from pydy._mechanics.elimination import composite, eliminated
from pydy._mechanics.implicit import check_forces
from pydy._mechanics.inertia import Inertia, loads_and_inertias, lumped, points_of
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.reduction import reduced
from pydy._mechanics.symbols import find_symbols, replace_symbols
from pydy._mechanics.tuning import SAME_DIRECTION
from pydy._rank import ROUNDED

# Functions that are the same everywhere if they are so at random states; min, max and roots are
# not, and stand for themselves.
_MEROMORPHIC = frozenset(("sum", "prod", "sin", "cos", "tan", "exp", "sinh", "cosh", "tanh"))


@dataclass(eq=False)
class Formed:
    """Equations of motion ``M u' = F`` and kinematics ``q' = G`` as nodes."""

    # Its inputs are 'x' (coordinates, then speeds), 't', 'a' (derivatives of the speeds, in
    # loads that depend on them), 'p' and 'r' in the order of `constants` and `specifieds`.
    graph: Graph
    constants: list[Any]
    specifieds: list[Any]
    rates: list[int]  # q'
    # M; the rows of dependent speeds are those of the acceleration constraints.
    matrix: list[list[int]]
    forcing: list[int]
    accelerations: list[int] | None  # u', where it is formed without the mass matrix of all speeds
    # A part of u' that is known beforehand: with it the angular accelerations at u' = 0
    # vanish.
    start: list[int]
    rest: list[int]  # F − M · start: u' is `start` and what this accelerates beyond
    kinetic: int  # the kinetic energy
    # Those with a velocity of the user's that is not the rate of their place.
    honoured: tuple[Any, ...] = ()
    # Whether no vector had to be expressed in another frame: the choice of axes is none.
    in_one_frame: bool = False
    # What speeds move, and where: its constants are some of the equations', whether the form
    # needs them or not.
    measures: tuple[int, ...] = ()
    # q' and u' as simplification leaves them, in a graph of their own, where forms were
    # counted.
    simplified: tuple[Graph, list[int]] | None = None

    def inputs(self) -> set[tuple[str, int]]:
        """Return the inputs of q', M, F and u', and the constants of moving bodies."""
        graph = self.graph
        roots = [*self.rates, *(n for row in self.matrix for n in row), *self.forcing]
        roots += self.accelerations or []
        measured = [n for n in graph.inputs(self.measures) if graph.constant[n]]
        return {graph.args[n] for n in (*graph.inputs(roots), *measured)}

    def symbols(self, speed_rates: Sequence[Any]) -> list[Any]:
        """Return the constants, specifieds and derivatives of speeds that occur."""
        groups = {"p": self.constants, "r": self.specifieds, "a": speed_rates}
        return [groups[g][k] for g, k in sorted(self.inputs()) if g in groups]

    def input_symbols(self, time: Any, states: Sequence[Any]) -> dict[int, Any]:
        """Return the symbol of each input node, except derivatives of speeds."""
        return self.graph.input_symbols(t=[time], x=states, p=self.constants, r=self.specifieds)

    def energy(self, time: Any, coordinates: Sequence[Any], speeds: Sequence[Any]) -> Any:
        """Return the kinetic energy as an expression."""
        symbols = self.input_symbols(time, (*coordinates, *speeds))
        return NodeExpression.of(self.graph, self.kinetic, symbols)

    def placed(self, constants: Sequence[Any], specifieds: Sequence[Any]) -> Formed:
        """Return the same with the inputs in the order of arrays p and r."""
        needed = self.inputs()
        names: dict[tuple[str, int], tuple[str, int]] = {}
        for group, own, order in (
            ("p", self.constants, constants),
            ("r", self.specifieds, specifieds),
        ):
            places = {symbol: k for k, symbol in enumerate(order)}
            for k, symbol in enumerate(own):
                if symbol in places:
                    names[group, k] = group, places[symbol]
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
            simplified = simplified[0].renamed(names), simplified[1]
        return replace(self, graph=self.graph.renamed(names), simplified=simplified)

    def ordered(self, coordinates: Sequence[int], speeds: Sequence[int]) -> Formed:
        """Return the same with coordinates and speeds in another order.

        It is given by the present positions. The rows of M move with the speeds.
        """
        n, m = len(coordinates), len(speeds)
        if [*coordinates, *speeds] == [*range(n), *range(m)]:
            return self
        states = [*coordinates, *(n + k for k in speeds)]
        names = {("x", old): ("x", new) for new, old in enumerate(states)}
        names |= {("a", old): ("a", new) for new, old in enumerate(speeds)}
        simplified = self.simplified
        if simplified is not None:
            simplified = simplified[0].renamed(names), [simplified[1][k] for k in states]
        solved = self.accelerations
        return replace(
            self,
            graph=self.graph.renamed(names),
            rates=[self.rates[k] for k in coordinates],
            matrix=[[self.matrix[i][j] for j in speeds] for i in speeds],
            forcing=[self.forcing[k] for k in speeds],
            accelerations=None if solved is None else [solved[k] for k in speeds],
            start=[self.start[k] for k in speeds],
            rest=[self.rest[k] for k in speeds],
            simplified=simplified,
        )

    def for_body(self, body: Multibody) -> Formed:
        """Return the same, formed with dependent speeds last, in the order of a body's states."""
        first = body.independent_first
        return self.ordered(
            [first.coordinates.index(q) for q in body.coordinates],
            [first.speeds.index(u) for u in body.speeds],
        )


def forms(
    body: Multibody, *, in_bodies: bool, honoured: Collection[Any] | None = None
) -> list[Formed]:
    """Return the equations of motion, composite bodies first, then articulated ones.

    In the first form u' is left to a solve; in the second, the speeds are eliminated one by one,
    from the outer bodies to the inner ones. With dependent speeds, or with loads that depend on
    accelerations, there is only the first.
    """
    # With dependent speeds the constraints hold what is known of u' too: a rider's bicycle would
    # take 4,359 operations in place of 4,211.
    free = not body.velocity
    kinematics = moving(body, in_bodies, falling=in_bodies, known=honoured, referred=free)
    g = kinematics.graph
    inertias, loads, plain = lumped(kinematics)
    kinetic = _kinetic(kinematics, plain)
    if body.implicit is not None:
        check_forces(body, g, kinetic)
    matrix, rest = composite(kinematics, inertias, loads)
    start, moved = kinematics.start(), _depends_on_accelerations(kinematics, rest)
    if not moved:
        _check_masses(body, g, matrix, kinematics.read.specifieds)
    found = [
        replace(
            _composed(kinematics, matrix, rest, start),
            kinetic=kinetic,
            honoured=tuple(sorted(kinematics.honoured, key=str)),
            in_one_frame=kinematics.in_one_frame,
            measures=tuple(_measures(kinematics, plain)) if in_bodies else (),
        )
    ]
    if not body.velocity and not moved:
        fast, sound = eliminated(kinematics, inertias, loads, plain)
        beyond = g.guard(matrix, rest, sound, fast)
        found.append(replace(found[0], accelerations=kinematics.plus(start, beyond)))
    return [_without_idle(formed) for formed in found] if body.auxiliary else found


def _composed(kinematics: Kinematics, matrix: list[Vec], rest: Vec, start: Vec) -> Formed:
    """Return the equations M (u' − start) = rest of all speeds, reduced to independent ones."""
    g, read, accelerations = kinematics.graph, kinematics.read, None
    if kinematics.body.velocity:
        moved = _depends_on_accelerations(kinematics, rest)
        matrix, rest, accelerations = reduced(kinematics, matrix, rest, moved)
    return Formed(
        g,
        read.constants,
        read.specifieds,
        kinematics.rates,
        matrix,
        kinematics.plus(rest, kinematics.turned(matrix, start)),
        accelerations,
        start,
        rest,
        kinetic=g.zero,
    )


def _depends_on_accelerations(kinematics: Kinematics, nodes: Vec) -> bool:
    return not {*kinematics.accelerations}.isdisjoint(kinematics.graph.reachable(nodes))


def _without_idle(formed: Formed) -> Formed:
    """Leave out specifieds that do no work: noncontributing forces."""
    g = formed.graph
    inputs = [g.input("r", k) for k in range(len(formed.specifieds))]
    nothing = dict.fromkeys(idle_inputs(g, formed.rest, inputs), g.zero)
    solved = formed.accelerations
    return replace(
        formed,
        forcing=substitute(g, formed.forcing, nothing),
        rest=substitute(g, formed.rest, nothing),
        accelerations=solved and substitute(g, solved, nothing),
    )


def useful_axes(body: Multibody) -> list[bool]:
    """Return whether velocities of points are worth writing in the axes of bodies, or need not be.

    In a plane either may cost less. In space the axes of bodies do, but where no point moves with
    a body that turns: all velocities are given in the inertial frame.
    """
    k = Kinematics(body, in_bodies=False)
    k.place(points_of(k))
    if in_a_plane(k):
        return [True, False]
    vectors = [k.tree.velocity(p) for p in k.placed() if k.base(p) is None]
    frames = {f for vector in vectors for _, f in vector.args}
    frames |= {f for point in k.placed() for _, f in k.parts(point)}
    return [not frames <= {k.inertial}]


def _check_masses(
    body: Multibody, graph: Graph, matrix: list[list[int]], others: Collection[Any]
) -> None:
    """Refuse an independent speed that moves nothing: no equation determines its derivative."""
    n = len(body.speeds)
    free = n - len(body.velocity)
    bound = any(matrix[k][k] != graph.zero for k in range(free, n))
    for k, speed in enumerate(body.speeds[:free]):
        if matrix[k][k] == graph.zero and not bound:
            alike = any(str(other) == str(speed) for other in others)
            raise ValueError(
                f"The speed `{speed}` moves no mass and no inertia, so that nothing determines its "
                "derivative. "
                + (
                    f"The bodies and loads hold another `{speed}`, with other assumptions: make it "
                    "once and use it everywhere."
                    if alike
                    else "Give one of the bodies that it moves a mass or an inertia, or make it a "
                    "dependent speed, with a velocity constraint."
                )
            )


def _kinetic(kinematics: Kinematics, inertias: Sequence[Inertia]) -> int:
    g = kinematics.graph
    terms = [
        (g.mul(part.matrix[i][j], part.velocity[i], part.velocity[j]), 0.5)
        for part in inertias
        for i in range(len(part.velocity))
        for j in range(len(part.velocity))
    ]
    return g.sum(terms)


def _measures(kinematics: Kinematics, inertias: Sequence[Inertia]) -> list[int]:
    """Return the inertias and the velocities of mass centres that depend on speeds."""
    rows = kinematics.rows
    found = [
        n
        for body in kinematics.body.bodies
        for n in kinematics.motion(body.masscenter)[1]
        if rows(n)
    ]
    for part in inertias:
        moved = [bool(rows(n)) for n in part.velocity]
        for line, one in zip(part.matrix, moved, strict=True):
            found += [n for n, two in zip(line, moved, strict=True) if one and two]
    return found


def moving(
    body: Multibody,
    in_bodies: bool,
    *,
    falling: bool = False,
    known: Collection[Any] | None = None,
    more: Iterable[Any] = (),
    **how: bool,
) -> Kinematics:
    """Return the kinematics with all points placed, more of them too; the user's velocities hold.

    `how` is `auxiliary`, `referred` or `driven`, as for Kinematics; `falling` takes gravity for an
    acceleration where it can, and refers bodies on hinges to other points of their axes. Which
    velocities are to be honoured is found out, if it is not known.
    """
    honoured: set[Any] = set(known or ())
    checked: dict[Any, Any] = {}
    while True:
        kinematics = Kinematics(body, in_bodies=in_bodies, honoured=honoured, **how)
        if falling:
            take_gravity_off(kinematics)
        points = [*points_of(kinematics), *more]
        kinematics.place(points)
        if falling:
            align(kinematics)
            move_along_axes(kinematics)
        for point in points:
            kinematics.motion(point)
        if known is None and checked != (ways := _ways(kinematics, points)):
            checked = ways
            if wrong := disagreeing(kinematics):
                honoured.update(wrong)
                continue
        return kinematics


def _ways(kinematics: Kinematics, points: Iterable[Any]) -> dict[Any, Any]:
    return {p: kinematics.way(p)[0] for p in points}


@collector_paused()
def form_lagrangian(body: Multibody) -> Formed:
    """Return the equations of motion of a Lagrangian.

    With constraints, q'' follows from multipliers: that holds in every configuration, whatever
    speeds are dependent. M and F are reduced as Kane's.
    """
    kinematics = moving(body.independent_first, in_bodies=True)
    matrix, forcing = lagranges_equations(kinematics)
    nothing = [kinematics.graph.zero] * len(forcing)
    return _composed(kinematics, matrix, forcing, nothing).for_body(body)


def lagranges_equations(kinematics: Kinematics) -> tuple[list[Vec], Vec]:
    """Return M and F for all speeds, dependent or not."""
    body = kinematics.body
    inertias, loads = loads_and_inertias(kinematics)
    g, speeds = kinematics.graph, kinematics.speeds
    _, forces = composite(kinematics, inertias, loads)
    node = kinematics.read(body.lagrangian)
    if _depends_on_accelerations(kinematics, [node]):
        raise ValueError(
            "The Lagrangian holds second derivatives of coordinates. Leave out what is a "
            "derivative by time: it does not change the equations."
        )
    momenta, matrix = hessian(g, node, speeds)
    # Coordinates in the order of the speeds, which are their derivatives.
    order = {rate: k for k, rate in enumerate(body.coordinate_rates)}
    coordinates = [g.input("x", order[u]) for u in body.speeds]
    (by_coordinate,) = jacobian(g, [node], coordinates)
    forcing = [
        g.sum([(by_coordinate.get(k, g.zero), 1.0), (rate, -1.0), (forces[k], 1.0)])
        for k, rate in enumerate(kinematics.dt(momenta))
    ]
    return matrix, forcing


# -- velocities that the user set ------------------------------------------------------------------


def disagreeing(kinematics: Kinematics) -> list[Any]:
    """Return the points whose given velocity contradicts their position.

    That is, if those that they are reached from move as they are said to, each with the given
    velocity if it is one of the points returned.
    """
    k = kinematics
    points = [p for p in k.moved() if k.base(p) is not None and k.tree.velocity(p) is not None]
    nodes: list[int] = []
    for point in points:
        home, v, _ = k.motion(point)
        nodes += [*v, *k.vector(k.tree.velocity(point), home)]
    values = signatures(k.graph, nodes) if nodes else []
    unequal = {
        point: nodes[i : i + 6]
        for i, point in zip(range(0, len(nodes), 6), points, strict=True)
        if values[i : i + 3] != values[i + 3 : i + 6]
    }
    return _honoured(k, points, unequal) if unequal else []


def _honoured(
    kinematics: Kinematics, points: Sequence[Any], unequal: Mapping[Any, Sequence[int]]
) -> list[Any]:
    """Return the points whose velocities are given, from the inner ones to the outer ones.

    A point that is reached from one whose velocity is given moves by the same difference from what
    follows from its place. Directions that are given by numbers are rounded: products of them that
    are equal are not so modulo a prime, but at random states.
    """
    k = kinematics
    ways = {p: k.frames.way_in(k.motion(p)[0])[:-1] for p in unequal}
    frames = list(dict.fromkeys(f for way in ways.values() for f in way))
    steps = [n for f in frames for row in k.frames.step(f) for n in row]
    values = numbers_of(k.graph, [*steps, *(n for six in unequal.values() for n in six)])
    states = len(values)
    turned = values[:, : len(steps)].reshape(states, -1, 3, 3)
    step = {f: turned[:, i] for i, f in enumerate(frames)}
    apart: dict[Any, np.ndarray] = {}
    sizes: dict[Any, np.ndarray] = {}
    pairs = values[:, len(steps) :].reshape(states, -1, 2, 3)
    for i, p in enumerate(unequal):
        difference = pairs[:, i, 1] - pairs[:, i, 0]
        for f in ways[p]:  # into the inertial frame
            difference = np.einsum("sij,si->sj", step[f], difference)
        apart[p], sizes[p] = difference, np.linalg.norm(pairs[:, i], axis=-1).sum(axis=-1)
    found: dict[Any, None] = {}
    nothing = np.zeros((states, 3))
    for p in sorted(points, key=lambda p: len(_inner(k, p))):
        inner = next((q for q in _inner(k, p) if q in found), None)
        left = apart.get(p, nothing) - apart.get(inner, nothing)
        size = sizes.get(p, 0.0) + sizes.get(inner, 0.0)
        # What a singular solve gives is not a number, and equal to nothing.
        if not (np.linalg.norm(left, axis=-1) <= SAME_DIRECTION * size).all():
            found[p] = None
    return list(found)


def _inner(kinematics: Kinematics, point: Any) -> list[Any]:
    """Return the points that a point is reached from, the nearest one first."""
    found = []
    while (point := kinematics.base(point)) is not None:
        found.append(point)
    return found


# -- gravity ---------------------------------------------------------------------------------------


def take_gravity_off(kinematics: Kinematics) -> None:
    """Turn weights into an acceleration, where every body with a mass has one.

    No point's motion may have been asked for.
    """
    weights: list[dict[int, Vec]] = []
    for body in kinematics.body.bodies:
        mass = kinematics.read(body.mass)
        if mass != kinematics.graph.zero:
            weights.append(_pulls(kinematics, body.masscenter, mass))
    for pull in weights[0].values() if weights else ():
        spent = [_place(kinematics.graph, pull, own) for own in weights]
        if None not in spent and len(set(spent)) == len(spent):
            kinematics.loads = tuple(x for k, x in enumerate(kinematics.loads) if k not in spent)
            kinematics.pull = pull
            return


def _pulls(kinematics: Kinematics, point: Any, mass: int) -> dict[int, Vec]:
    """Return force over mass of the loads at a point that are written in the inertial frame."""
    found = {}
    for k, (where, vector) in enumerate(kinematics.loads):
        if where is point and all(frame is kinematics.inertial for _, frame in vector.args):
            parts = kinematics.vector(vector, kinematics.inertial)
            found[k] = [kinematics.graph.div(n, mass) for n in parts]
    return found


def _place(graph: Graph, pull: Vec, own: dict[int, Vec]) -> int | None:
    """Return which of a body's loads pulls it like that."""
    return next((k for k, other in own.items() if alike(graph, pull, other)), None)


def alike(graph: Graph, a: Vec, b: Vec) -> bool:
    """Return whether vectors are equal up to the rounding of numbers."""
    for x, y in zip(a, b, strict=True):
        one, two = _split(graph, x), _split(graph, y)
        if one[1] != two[1] or abs(one[0] - two[0]) > ROUNDED * abs(one[0]):
            return False
    return True


def _split(graph: Graph, node: int) -> tuple[float, int]:
    """Split a node into a number and the rest of the product."""
    value = graph.value(node)
    return graph.scaled(node) if value is None else (value, graph.one)


# -- noncontributing forces ------------------------------------------------------------------------


def without_idle(
    forcing: Sequence[Any], auxiliary_equations: Iterable[Any], states: Collection[Any]
) -> tuple[Any, ...]:
    """Return the forcing without the forces of the auxiliary equations that cancel in it."""
    held = find_symbols(forcing)
    forces = [
        s
        for s in find_symbols(auxiliary_equations)
        if isinstance(s, AppliedUndef) and s in held and s not in states
    ]
    if not forces:
        return tuple(forcing)
    graph = Graph()
    atoms = graph.input_nodes(x=held)
    nodes = SymPyReader(graph, atoms, "the equations of motion").all(forcing)
    idle = set(idle_inputs(graph, nodes, [atoms[s] for s in forces]))
    nothing = {s: sm.S.Zero for s in forces if atoms[s] in idle}
    return tuple(replace_symbols(e, nothing) for e in forcing) if nothing else tuple(forcing)


def idle_inputs(graph: Graph, forcing: Sequence[int], inputs: Sequence[int]) -> list[int]:
    """Return the inputs that are in the forcing, which does not change with them."""
    slopes: dict[int, list[int]] = {n: [] for n in inputs}
    for row in jacobian(graph, forcing, inputs):
        for k, node in row.items():
            slopes[inputs[k]].append(node)
    return [n for n, own in slopes.items() if _vanish(graph, own)]


def _vanish(graph: Graph, nodes: Sequence[int]) -> bool:
    """Return whether nodes are zero as functions."""
    if not any(signatures(graph, nodes)):
        return True
    # Identities of angles are not seen modulo a prime.
    leaves = _leaves(graph, nodes)
    inputs = [graph.input("x", k) for k in range(len(leaves))]
    rest = substitute(graph, nodes, dict(zip(leaves, inputs, strict=True)))
    found = numbers_of(graph, [*rest, *rounding_bounds(graph, rest)])
    left, bounds = np.hsplit(np.abs(found), 2)
    return bool(((left <= ROUNDED * bounds) & (bounds > 0.0)).all())


def _leaves(graph: Graph, nodes: Sequence[int]) -> list[int]:
    """Return the inputs, and nodes that are treated like inputs."""
    found: dict[int, None] = {}
    seen, left = set(nodes), list(nodes)
    while left:
        n = left.pop()
        if graph.ops[n] in _MEROMORPHIC:
            new = [m for m in graph.operands(n) if m not in seen]
            seen.update(new)
            left += new
        elif graph.ops[n] != "const":
            found[n] = None
    return list(found)
