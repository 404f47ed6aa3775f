"""Inertia and loads of bodies at the components of their velocities.

What a body contributes to Kane's equations is a quadratic form in the components of a velocity,
m v·v or ω·I·ω, and a force on them: the load, less what the body needs for its acceleration at
u' = 0, m a or I α + ω × I ω.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from sympy.physics.mechanics import Point

from pydy._graph.identities import signatures
from pydy._mechanics.kinematics import Kinematics, Vec
from pydy._mechanics.reader import is_rigid

__all__ = [
    "Inertia",
    "Load",
    "contributions",
    "inertia_seen",
    "loads_and_inertias",
    "points_of",
    "without_rest",
]


@dataclass(frozen=True)
class Inertia:
    """The form v·I·v: components of a velocity, or of two, and a symmetric matrix of nodes."""

    velocity: Vec
    matrix: list[Vec]


@dataclass(frozen=True)
class Load:
    """A force on the components of a velocity."""

    velocity: Vec
    force: Vec


def points_of(kinematics: Kinematics) -> list[Any]:
    """Return the points whose motion the equations need, in the order in which SymPy asks."""
    body = kinematics.body
    return [where for where, _ in body.loads if isinstance(where, Point)] + [
        b.masscenter for b in body.bodies
    ]


def loads_and_inertias(kinematics: Kinematics) -> tuple[list[Inertia], list[Load]]:
    """Return what bodies and loads contribute."""
    return without_rest(kinematics, *contributions(kinematics, kinematics.body.bodies))


def contributions(
    kinematics: Kinematics, bodies: Iterable[Any]
) -> tuple[list[Inertia], list[Load]]:
    """Return what these bodies contribute, and all loads."""
    inertias: list[Inertia] = []
    loads: list[Load] = []
    for body in bodies:
        _translation(kinematics, body, inertias, loads)
        if is_rigid(body):
            _rotation(kinematics, body, inertias, loads)
    for where, vector in kinematics.loads:
        home, v = kinematics.at(where)
        loads.append(Load(v, kinematics.vector(vector, home)))
    return inertias, loads


def without_rest(
    kinematics: Kinematics, inertias: list[Inertia], loads: list[Load]
) -> tuple[list[Inertia], list[Load]]:
    """Write 0 for velocities that vanish: what acts there, at a contact say, does no work."""
    nodes = [n for a in inertias for n in a.velocity] + [n for b in loads for n in b.velocity]
    values = signatures(kinematics.graph, nodes)
    rest = {n for n, value in zip(nodes, values, strict=True) if not value}

    def kept(v: Vec) -> Vec:
        return [kinematics.graph.zero if n in rest else n for n in v]

    return (
        [Inertia(kept(part.velocity), part.matrix) for part in inertias],
        [Load(kept(part.velocity), part.force) for part in loads],
    )


def _translation(
    kinematics: Kinematics, body: Any, inertias: list[Inertia], loads: list[Load]
) -> None:
    g = kinematics.graph
    mass = kinematics.read(body.mass)
    if mass == g.zero:
        return
    _, v, _ = kinematics.motion(body.masscenter)
    a = kinematics.acceleration(body.masscenter)
    (change,) = kinematics.dt([mass])
    needed = [g.add(g.mul(mass, x), g.mul(change, y)) for x, y in zip(a, v, strict=True)]
    inertias.append(Inertia(v, [[mass if i == j else g.zero for j in range(3)] for i in range(3)]))
    loads.append(Load(v, [g.neg(x) for x in needed]))


def _rotation(
    kinematics: Kinematics, body: Any, inertias: list[Inertia], loads: list[Load]
) -> None:
    g = kinematics.graph
    terms = tuple(body.central_inertia.args)
    if not terms:
        return
    home, tensor, change = inertia_seen(kinematics, body.frame, terms)
    w, _ = kinematics.spin(body.frame, home)
    alpha = kinematics.angular_acceleration(body.frame, home)
    momentum = kinematics.turned(tensor, w)
    needed = kinematics.plus(
        kinematics.turned(tensor, alpha),
        kinematics.cross(w, momentum),
        kinematics.turned(change, w),
    )
    inertias.append(Inertia(w, tensor))
    loads.append(Load(w, [g.neg(x) for x in needed]))


def inertia_seen(
    kinematics: Kinematics, frame: Any, terms: tuple[Any, ...]
) -> tuple[Any, list[Vec], list[Vec]]:
    """Return the axes to write a body's rotation in, its inertia there, and the rate of that.

    Those are the innermost axes in which the inertia is constant. A wheel's does not change as it
    spins: in the axes of the fork its spin angle does not occur at all.
    """
    zero = kinematics.graph.zero
    still = [[zero] * 3 for _ in range(3)]
    written = {f for _, a, b in terms for vector in (a, b) for _, f in vector.args}
    frame = kinematics.frames.axes(frame)
    home = kinematics.frames.axes(written.pop()) if len(written) == 1 else frame
    tensor = kinematics.tensor(terms, home)
    change = [kinematics.dt(row) for row in tensor]
    if home is not frame:
        # With the axes turning by w beside the body the inertia changes by w × I - I × w.
        w, own = kinematics.spin(home)[0], kinematics.spin(frame, home)[0]
        relative = [kinematics.graph.sub(a, b) for a, b in zip(w, own, strict=True)]
        turned = list(zip(*(kinematics.cross(relative, row) for row in tensor), strict=True))
        both = [
            kinematics.plus(a, b) for a, b in zip(turned, zip(*turned, strict=True), strict=True)
        ]
        change = [kinematics.plus(a, b) for a, b in zip(change, both, strict=True)]
    if not kinematics.vanishes(_flat(change)):
        return home, tensor, change
    while home in kinematics.tree.oriented:
        if (parent := kinematics.frames.parent(home)) is None:
            break
        # In the parent's axes: R' I R, with the axes here as the rows of R.
        rotation = list(zip(*kinematics.frames.step(home), strict=True))
        half = [kinematics.turned(rotation, column) for column in zip(*tensor, strict=True)]
        outer = [kinematics.turned(rotation, row) for row in zip(*half, strict=True)]
        if not kinematics.equal(_flat(tensor), _flat(outer)):
            break
        home = parent
    return home, tensor, still


def _flat(matrix: list[Vec]) -> Vec:
    return [n for row in matrix for n in row]
