"""Equations of motion formed from bodies, loads and kinematics, as nodes of one graph.

If gravity acts on all masses alike it becomes an acceleration of the inertial frame: one vector
that is propagated outwards instead of a force at each body. Velocities that the user set are used
even if they are not the derivatives of positions. Noncontributing forces that cancel are removed:
with dependent speeds a contact force may appear as r R − r R.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef

from pydy._collector import collector_paused
from pydy._graph import (
    Graph,
    LinearSystem,
    SymPyReader,
    hessian,
    jacobian,
    rounding_bounds,
    signatures,
    substitute,
)
from pydy._mechanics.alignment import align, choose_joint_points, in_a_plane
from pydy._mechanics.components import numbers_of
from pydy._mechanics.elimination import composite, eliminated
from pydy._mechanics.equation_graph import DynamicEquations, EquationGraph
from pydy._mechanics.implicit import check_forces
from pydy._mechanics.inertia import Inertia, composite_contributions, loads_and_inertias, points_of
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.multibody import Multibody, independent_first
from pydy._mechanics.reduction import reduced
from pydy._mechanics.symbols import find_symbols, replace_symbols
from pydy._mechanics.tuning import SAME_DIRECTION
from pydy._rank import ROUNDED

if TYPE_CHECKING:
    from sympy.physics.mechanics import Point

    from pydy._sympy_types import TimeFunction

# Meromorphic functions are equal everywhere if they are equal at random states; min, max and roots
# are not meromorphic and count as inputs.
_MEROMORPHIC = frozenset(("sum", "prod", "sin", "cos", "tan", "exp", "sinh", "cosh", "tanh"))


@dataclass(frozen=True, eq=False)
class Formulations:
    """The equations of motion in each form, with vectors in the same axes."""

    equations: tuple[EquationGraph, ...]  # composite bodies first, then articulated ones
    # Points with a velocity of the user that is not the derivative of their position.
    honoured: tuple[Point, ...]
    # Whether no vector had to be expressed in another frame: the axes make no difference.
    in_one_frame: bool


def forms(
    body: Multibody, *, in_bodies: bool, honoured: Collection[Point] | None = None
) -> Formulations:
    """Return the equations of motion, composite bodies first, then articulated ones.

    In the first form u' is left to a solve; in the second, the speeds are eliminated one by one,
    from the outer bodies to the inner ones. With dependent speeds, or with loads that depend on
    accelerations, there is only the first.
    """
    # With dependent speeds the constraints contain `start` as well: a rider's bicycle would take
    # 4,359 operations instead of 4,211.
    free = not body.constraints.velocity
    kinematics = moving(
        body, in_bodies, gravity_as_acceleration=in_bodies, fixed_honoured=honoured, referred=free
    )
    g = kinematics.graph
    inertias, loads, body_inertias = composite_contributions(kinematics)
    kinetic = _kinetic(kinematics, body_inertias)
    if body.constraints.implicit is not None:
        check_forces(body, g, kinetic)
    matrix, residual = composite(kinematics, inertias, loads)
    start, moved = kinematics.start(), _depends_on_accelerations(kinematics, residual)
    if not moved:
        _check_masses(body, g, matrix, kinematics.read.specifieds)
    composed = replace(
        _composed(kinematics, matrix, residual, start),
        kinetic=kinetic,
        measures=tuple(_measures(kinematics, body_inertias)) if in_bodies else (),
    )
    kinds = [composed]
    if not body.constraints.velocity and not moved:
        fast, sound = eliminated(kinematics, inertias, loads, body_inertias)
        correction = LinearSystem(g, matrix).guarded(residual, sound, fast)
        accelerations = kinematics.plus(start, correction)
        dynamics = replace(composed.dynamics, accelerations=accelerations)
        kinds.append(replace(composed, dynamics=dynamics))
    if body.auxiliary:
        kinds = [_without_cancelling_forces(formed) for formed in kinds]
    points = tuple(sorted(kinematics.honoured, key=str))
    return Formulations(tuple(kinds), points, kinematics.in_one_frame)


def _composed(
    kinematics: Kinematics, matrix: list[Vec], residual: Vec, start: Vec
) -> EquationGraph:
    """Return the equations M (u' − start) = residual, reduced to independent speeds."""
    g, read, accelerations = kinematics.graph, kinematics.read, None
    if kinematics.body.constraints.velocity:
        moved = _depends_on_accelerations(kinematics, residual)
        matrix, residual, accelerations = reduced(kinematics, matrix, residual, moved)
    forcing = kinematics.plus(residual, kinematics.product(matrix, start))
    dynamics = DynamicEquations(matrix, forcing, start, residual, accelerations)
    return EquationGraph(
        g, read.constants, read.specifieds, kinematics.rates, dynamics, kinetic=g.zero
    )


def _depends_on_accelerations(kinematics: Kinematics, nodes: Vec) -> bool:
    return not {*kinematics.accelerations}.isdisjoint(kinematics.graph.reachable(nodes))


def _without_cancelling_forces(formed: EquationGraph) -> EquationGraph:
    """Remove specifieds that do no work: noncontributing forces."""
    g, dynamics = formed.graph, formed.dynamics
    inputs = [g.input("r", k) for k in range(len(formed.specifieds))]
    nothing = dict.fromkeys(cancelling_inputs(g, dynamics.residual_forcing, inputs), g.zero)
    solved = dynamics.accelerations
    effective = replace(
        dynamics,
        forcing=substitute(g, dynamics.forcing, nothing),
        residual_forcing=substitute(g, dynamics.residual_forcing, nothing),
        accelerations=solved and substitute(g, solved, nothing),
    )
    return replace(formed, dynamics=effective)


def in_order_of_states(formed: EquationGraph, body: Multibody) -> EquationGraph:
    """Return a copy in the order of the body's states; dependent speeds are last before."""
    first = independent_first(body)
    return formed.ordered(
        [first.coordinates.index(q) for q in body.coordinates],
        [first.speeds.index(u) for u in body.speeds],
    )


def useful_axes(body: Multibody) -> list[bool]:
    """Return which axes to try for velocities of points: those of bodies, or the inertial ones.

    In a plane either may cost less. In space the axes of bodies cost less, unless no point is fixed
    in a rotating body, that is, all velocities are given in the inertial frame.
    """
    k = Kinematics(body, in_bodies=False)
    k.connect(points_of(k))
    if in_a_plane(k):
        return [True, False]
    vectors = [k.tree.velocity(p) for p in k.placed() if k.base(p) is None]
    frames = {f for vector in vectors if vector is not None for _, f in vector.args}
    frames |= {f for point in k.placed() for _, f in k.parts(point)}
    return [not frames <= {k.inertial}]


def _check_masses(
    body: Multibody, graph: Graph, matrix: list[list[int]], specifieds: Collection[TimeFunction]
) -> None:
    """Refuse an independent speed that moves no mass: no equation determines its derivative."""
    n = len(body.speeds)
    free = n - len(body.constraints.velocity)
    bound = any(matrix[k][k] != graph.zero for k in range(free, n))
    for k, speed in enumerate(body.speeds[:free]):
        if matrix[k][k] == graph.zero and not bound:
            alike = any(str(symbol) == str(speed) for symbol in specifieds)
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
    nodes = [
        n
        for body in kinematics.body.bodies
        for n in kinematics.motion(body.masscenter)[1]
        if rows(n)
    ]
    for part in inertias:
        moved = [bool(rows(n)) for n in part.velocity]
        for line, first in zip(part.matrix, moved, strict=True):
            nodes += [n for n, second in zip(line, moved, strict=True) if first and second]
    return nodes


def moving(
    body: Multibody,
    in_bodies: bool,
    *,
    gravity_as_acceleration: bool = False,
    fixed_honoured: Collection[Point] | None = None,
    further_points: Iterable[Point] = (),
    **how: bool,
) -> Kinematics:
    """Return the kinematics with all points connected, and those of `further_points`.

    `how` is `auxiliary`, `referred` or `driven`, as for Kinematics. `gravity_as_acceleration`
    replaces gravity by an acceleration if possible, and moves joint points along their axes. Which
    velocities of the user must be honoured is determined, unless it is fixed.
    """
    honoured: set[Point] = set(fixed_honoured or ())
    checked: dict[Point, Point | None] = {}
    while True:
        kinematics = Kinematics(body, in_bodies=in_bodies, honoured=honoured, **how)
        if gravity_as_acceleration:
            take_gravity_off(kinematics)
        points = [*points_of(kinematics), *further_points]
        kinematics.connect(points)
        if gravity_as_acceleration:
            align(kinematics)
            choose_joint_points(kinematics)
        for point in points:
            kinematics.motion(point)
        if fixed_honoured is None and checked != (paths := _paths(kinematics, points)):
            checked = paths
            if wrong := disagreeing(kinematics):
                honoured.update(wrong)
                continue
        return kinematics


def _paths(kinematics: Kinematics, points: Iterable[Point]) -> dict[Point, Point | None]:
    return {p: kinematics.path(p)[0] for p in points}


@collector_paused()
def form_lagrangian(body: Multibody) -> EquationGraph:
    """Return the equations of motion of a Lagrangian.

    With constraints, q'' follows from multipliers, in every configuration and for any choice of
    dependent speeds. M and F are reduced as in Kane's equations.
    """
    kinematics = moving(independent_first(body), in_bodies=True)
    matrix, forcing = lagranges_equations(kinematics)
    nothing = [kinematics.graph.zero] * len(forcing)
    return in_order_of_states(_composed(kinematics, matrix, forcing, nothing), body)


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
    order = {rate: k for k, rate in enumerate(body.kinematics.coordinate_rates)}
    coordinates = [g.input("x", order[u]) for u in body.speeds]
    (by_coordinate,) = jacobian(g, [node], coordinates)
    forcing = [
        g.sum([(by_coordinate.get(k, g.zero), 1.0), (rate, -1.0), (forces[k], 1.0)])
        for k, rate in enumerate(kinematics.dt(momenta))
    ]
    return matrix, forcing


# -- velocities that the user set ------------------------------------------------------------------


def disagreeing(kinematics: Kinematics) -> list[Point]:
    """Return the points whose given velocity contradicts their position.

    The points that they are located from are assumed to move as given, with the user's velocity if
    they are among the points returned.
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
    kinematics: Kinematics, points: Sequence[Point], unequal: Mapping[Point, Sequence[int]]
) -> list[Point]:
    """Return the points whose velocities are given, from the inner ones to the outer ones.

    The velocity of a point that is located from one with a given velocity differs from the rate of
    its position by the same amount. Numeric directions are rounded: equal products of them differ
    modulo a prime, but agree at random states.
    """
    k = kinematics
    chains = {p: k.frames.path_to_inertial(k.motion(p)[0])[:-1] for p in unequal}
    frames = list(dict.fromkeys(f for chain in chains.values() for f in chain))
    steps = [n for f in frames for row in k.frames.step(f) for n in row]
    values = numbers_of(k.graph, [*steps, *(n for six in unequal.values() for n in six)])
    states = len(values)
    rotations = values[:, : len(steps)].reshape(states, -1, 3, 3)
    step = {f: rotations[:, i] for i, f in enumerate(frames)}
    differences: dict[Point, np.ndarray] = {}
    sizes: dict[Point, np.ndarray] = {}
    pairs = values[:, len(steps) :].reshape(states, -1, 2, 3)
    for i, p in enumerate(unequal):
        difference = pairs[:, i, 1] - pairs[:, i, 0]
        for f in chains[p]:  # into the inertial frame
            difference = np.einsum("sij,si->sj", step[f], difference)
        differences[p], sizes[p] = difference, np.linalg.norm(pairs[:, i], axis=-1).sum(axis=-1)
    honoured: dict[Point, None] = {}
    nothing = np.zeros((states, 3))
    for p in sorted(points, key=lambda p: len(_inner(k, p))):
        inner = next((q for q in _inner(k, p) if q in honoured), None)
        residual = differences.get(p, nothing) - differences.get(inner, nothing)
        size = sizes.get(p, 0.0) + sizes.get(inner, 0.0)
        # A singular solve gives NaN, which compares unequal.
        if not (np.linalg.norm(residual, axis=-1) <= SAME_DIRECTION * size).all():
            honoured[p] = None
    return list(honoured)


def _inner(kinematics: Kinematics, point: Point) -> list[Point]:
    """Return the points that a point is located from, the nearest one first."""
    inner = []
    while (point := kinematics.base(point)) is not None:
        inner.append(point)
    return inner


# -- gravity ---------------------------------------------------------------------------------------


def take_gravity_off(kinematics: Kinematics) -> None:
    """Replace weights by an acceleration of the inertial frame if every mass has one.

    No motion may have been computed yet.
    """
    weights: list[dict[int, Vec]] = []
    for body in kinematics.body.bodies:
        mass = kinematics.read(body.mass)
        if mass != kinematics.graph.zero:
            weights.append(_pulls(kinematics, body.masscenter, mass))
    for pull in weights[0].values() if weights else ():
        used = [_load_with_pull(kinematics.graph, pull, body_pulls) for body_pulls in weights]
        if None not in used and len(set(used)) == len(used):
            kinematics.loads = tuple(x for k, x in enumerate(kinematics.loads) if k not in used)
            kinematics.pull = pull
            return


def _pulls(kinematics: Kinematics, point: Point, mass: int) -> dict[int, Vec]:
    """Return force over mass of the loads at a point that are given in the inertial frame."""
    pulls = {}
    for k, (location, vector) in enumerate(kinematics.loads):
        if location is point and all(frame is kinematics.inertial for _, frame in vector.args):
            parts = kinematics.vector(vector, kinematics.inertial)
            pulls[k] = [kinematics.graph.div(n, mass) for n in parts]
    return pulls


def _load_with_pull(graph: Graph, pull: Vec, pulls: dict[int, Vec]) -> int | None:
    """Return the load of a body that causes the acceleration `pull`, or None."""
    return next((k for k, candidate in pulls.items() if alike(graph, pull, candidate)), None)


def alike(graph: Graph, a: Vec, b: Vec) -> bool:
    """Return whether vectors are equal up to the rounding of numbers."""
    for x, y in zip(a, b, strict=True):
        first, second = _split(graph, x), _split(graph, y)
        if first[1] != second[1] or abs(first[0] - second[0]) > ROUNDED * abs(first[0]):
            return False
    return True


def _split(graph: Graph, node: int) -> tuple[float, int]:
    """Split a node into a numeric factor and the remaining product."""
    value = graph.value(node)
    return graph.scaled(node) if value is None else (value, graph.one)


# -- noncontributing forces ------------------------------------------------------------------------


def without_cancelling_forces(
    forcing: Sequence[sm.Expr],
    auxiliary_equations: Iterable[sm.Expr],
    states: Collection[TimeFunction],
) -> tuple[sm.Expr, ...]:
    """Return the forcing without the forces of the auxiliary equations that cancel in it."""
    present = find_symbols(forcing)
    forces = [
        s
        for s in find_symbols(auxiliary_equations)
        if isinstance(s, AppliedUndef) and s in present and s not in states
    ]
    if not forces:
        return tuple(forcing)
    graph = Graph()
    read = SymPyReader.of_inputs(graph, "the equations of motion", x=present)
    nodes = read.all(forcing)
    cancelling = set(cancelling_inputs(graph, nodes, [read.atoms[s] for s in forces]))
    zeros = {s: sm.S.Zero for s in forces if read.atoms[s] in cancelling}
    return tuple(replace_symbols(e, zeros) for e in forcing) if zeros else tuple(forcing)


def cancelling_inputs(graph: Graph, forcing: Sequence[int], inputs: Sequence[int]) -> list[int]:
    """Return the inputs on which the forcing does not depend although it contains them."""
    slopes: dict[int, list[int]] = {n: [] for n in inputs}
    for row in jacobian(graph, forcing, inputs):
        for k, node in row.items():
            slopes[inputs[k]].append(node)
    return [n for n, derivatives in slopes.items() if _vanish(graph, derivatives)]


def _vanish(graph: Graph, nodes: Sequence[int]) -> bool:
    """Return whether nodes are zero as functions."""
    if not any(signatures(graph, nodes)):
        return True
    # Trigonometric identities do not hold modulo a prime.
    leaves = _leaves(graph, nodes)
    inputs = [graph.input("x", k) for k in range(len(leaves))]
    relabelled = substitute(graph, nodes, dict(zip(leaves, inputs, strict=True)))
    values = numbers_of(graph, [*relabelled, *rounding_bounds(graph, relabelled)])
    magnitudes, bounds = np.hsplit(np.abs(values), 2)
    return bool(((magnitudes <= ROUNDED * bounds) & (bounds > 0.0)).all())


def _leaves(graph: Graph, nodes: Sequence[int]) -> list[int]:
    """Return the inputs, and the nodes that count as inputs."""
    leaves: dict[int, None] = {}
    visited, stack = set(nodes), list(nodes)
    while stack:
        n = stack.pop()
        if graph.ops[n] in _MEROMORPHIC:
            new = [m for m in graph.operands(n) if m not in visited]
            visited.update(new)
            stack += new
        elif graph.ops[n] != "const":
            leaves[n] = None
    return list(leaves)
