"""Equations of motion formed from bodies, loads and kinematics, as nodes of one graph."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from pydy._graph.from_sympy import NodeExpression
from pydy._graph.node import Graph
from pydy._graph.rewrite import substitute
from pydy._graph.symbols import input_symbols
from pydy._mechanics.alignment import align
from pydy._mechanics.axes import in_a_plane, move_along_axes
from pydy._mechanics.dynamics import Inertia, Load, loads_and_inertias, points_of
from pydy._mechanics.elimination import composite, eliminated
from pydy._mechanics.given import disagreeing
from pydy._mechanics.gravity import take_gravity_off
from pydy._mechanics.idle import idle_inputs
from pydy._mechanics.kinematics import Kinematics
from pydy._mechanics.lumps import lumped
from pydy._mechanics.reader import Multibody
from pydy._mechanics.reduction import reduced, slopes

__all__ = [
    "Formed",
    "auxiliary_equations",
    "form",
    "forms",
    "moving",
    "useful_axes",
]


@dataclass(eq=False)
class Formed:
    """Equations of motion ``M u' = F`` and kinematics ``q' = G`` as nodes.

    Attributes
    ----------
    graph : Graph
        Its inputs are 'x' (coordinates, then speeds), 't', 'a' (derivatives of the speeds, in loads
        that depend on them), 'p' and 'r' in the order of `constants` and `specifieds`.
    constants, specifieds : list of symbols
    rates : list of nodes
        q'.
    matrix : list of list of nodes
        M; with dependent speeds the last rows are those of the acceleration constraints.
    forcing : list of nodes
    accelerations : list of nodes or None
        u', where it is formed without the mass matrix of all speeds.
    start : list of nodes
        A part of u' that is known beforehand: with it the angular accelerations at u' = 0 vanish.
    rest : list of nodes
        F − M · start: u' is `start` and what this accelerates beyond.
    kinetic : node
        The kinetic energy.
    honoured : tuple of points
        Those with a velocity of the user's that is not the rate of their place.
    in_one_frame : bool
        Whether no vector had to be expressed in another frame: the choice of axes is none.
    measures : tuple of nodes
        What speeds move, and where: its constants are some of the equations', whether the form
        needs them or not.
    simplified : (graph, nodes) or None
        q' and u' as simplification leaves them, in a graph of their own, where forms were counted.
    """

    graph: Graph
    constants: list[Any]
    specifieds: list[Any]
    rates: list[int]
    matrix: list[list[int]]
    forcing: list[int]
    accelerations: list[int] | None
    start: list[int]
    rest: list[int]
    kinetic: int
    honoured: tuple[Any, ...] = ()
    in_one_frame: bool = False
    measures: tuple[int, ...] = ()
    simplified: tuple[Graph, list[int]] | None = None

    def inputs(self) -> set[tuple[str, int]]:
        """Return the inputs that q', M, F and u' depend on, and the constants of what moves."""
        graph = self.graph
        roots = [*self.rates, *(n for row in self.matrix for n in row), *self.forcing]
        roots += self.accelerations or []
        found = {graph.args[n] for n in graph.reachable(roots) if graph.ops[n] == "input"}
        measured = [n for n in graph.reachable(self.measures) if graph.ops[n] == "input"]
        return found | {graph.args[n] for n in measured if graph.constant[n]}

    def symbols(self, speed_rates: Sequence[Any]) -> list[Any]:
        """Return the constants, specifieds and derivatives of speeds that occur."""
        groups = {"p": self.constants, "r": self.specifieds, "a": speed_rates}
        return [groups[g][k] for g, k in sorted(self.inputs()) if g in groups]

    def input_symbols(self, time: Any, states: Sequence[Any]) -> dict[int, Any]:
        """Return what each input node stands for, derivatives of speeds left out."""
        return input_symbols(self.graph, t=[time], x=states, p=self.constants, r=self.specifieds)

    def energy(self, time: Any, coordinates: Sequence[Any], speeds: Sequence[Any]) -> Any:
        """Return the kinetic energy as an expression."""
        symbols = self.input_symbols(time, (*coordinates, *speeds))
        return NodeExpression.of(self.graph, self.kinetic, symbols)

    def placed(self, constants: Sequence[Any], specifieds: Sequence[Any]) -> Formed:
        """Return the same with the inputs in the order of arrays p and r.

        Raises
        ------
        ValueError
            A symbol of the equations is in neither.
        """
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


def form(body: Multibody, *, in_bodies: bool, articulated: bool) -> Formed:
    """Return the equations of motion in one form; see `forms`."""
    found = forms(body, in_bodies=in_bodies)
    return found[-1] if articulated else found[0]


def forms(
    body: Multibody, *, in_bodies: bool, honoured: Collection[Any] | None = None
) -> list[Formed]:
    """Return the equations of motion, composite bodies first, then articulated ones.

    In the first form u' is left to a solve; in the second, the speeds are eliminated one by one,
    from the outer bodies to the inner ones. With dependent speeds, or with loads that depend on
    accelerations, there is only the first.

    Parameters
    ----------
    body : Multibody
    in_bodies : bool
        Whether velocities of points are written in the frames of the bodies; else in the inertial
        frame.
    honoured : collection of points, optional
        What `Formed.honoured` of the body's equations in other axes is: found out by default.
    """
    # With dependent speeds the constraints hold what is known of u' too: a rider's bicycle would
    # take 4,359 operations in place of 4,211.
    free = not body.velocity
    kinematics = moving(body, in_bodies, falling=in_bodies, known=honoured, referred=free)
    g, speeds, read = kinematics.graph, kinematics.speeds, kinematics.read
    inertias, loads, plain = lumped(kinematics) if in_bodies else _as_they_are(kinematics)
    parts = (g, kinematics.rows, kinematics.groups, speeds, inertias, loads)
    matrix, rest = composite(*parts)
    start = kinematics.start()
    moved = bool(set(kinematics.accelerations) & set(g.reachable(rest)))
    if not moved:
        _check_masses(body, g, matrix, read.specifieds)
    accelerations = None
    if body.velocity:
        matrix, rest, accelerations = reduced(kinematics, matrix, rest, moved)
    # F of M u' = F.
    forcing = kinematics.plus(rest, kinematics.turned(matrix, start))
    found = [
        Formed(
            g,
            read.constants,
            read.specifieds,
            kinematics.rates,
            matrix,
            forcing,
            accelerations,
            start,
            rest,
            _kinetic(kinematics, plain),
            tuple(sorted(kinematics.honoured, key=str)),
            kinematics.in_one_frame,
            tuple(_measures(kinematics, plain)) if in_bodies else (),
        )
    ]
    if not body.velocity and not moved:
        solution = eliminated(*parts, plain, kinematics.detours)
        beyond = g.guard(matrix, rest, solution.sound, solution.accelerations)
        found.append(replace(found[0], accelerations=kinematics.plus(start, beyond)))
    return [_without_idle(formed) for formed in found] if body.auxiliary else found


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


def auxiliary_equations(body: Multibody) -> list[NodeExpression]:
    """Return what is zero for each auxiliary speed: its active less its inertia force."""
    kinematics = moving(body, in_bodies=True, auxiliary=True)
    inertias, loads = loads_and_inertias(kinematics)
    g, n = kinematics.graph, len(kinematics.speeds)
    every = [*kinematics.speeds, *kinematics.auxiliary]
    matrix, forcing = composite(g, kinematics.rows, kinematics.groups, every, inertias, loads)
    rest = [
        g.sum(
            [(forcing[i], 1.0)]
            + [(g.mul(matrix[i][j], kinematics.accelerations[j]), -1.0) for j in range(n)]
        )
        for i in range(len(every))
    ]
    found = rest[n:]
    if d := len(body.velocity):
        nodes = kinematics.read.all(body.velocity)
        held = [row[n - d :] for row in slopes(g, nodes, kinematics.speeds)]
        moved = slopes(g, nodes, kinematics.auxiliary)
        columns = [[g.neg(row[k]) for row in moved] for k in range(len(found))]
        shares = g.solve(held, columns, "lu")
        for k, share in enumerate(shares):
            terms = [(g.mul(a, f), 1.0) for a, f in zip(share, rest[n - d : n], strict=True)]
            found[k] = g.sum([(found[k], 1.0), *terms])
    found = substitute(g, found, dict.fromkeys(kinematics.auxiliary, g.zero))
    return [NodeExpression.of(g, node, kinematics.symbols()) for node in found]


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


def _as_they_are(kinematics: Kinematics) -> tuple[list[Inertia], list[Load], list[Inertia]]:
    inertias, loads = loads_and_inertias(kinematics)
    return inertias, loads, inertias


def moving(
    body: Multibody,
    in_bodies: bool,
    *,
    auxiliary: bool = False,
    falling: bool = False,
    referred: bool = False,
    known: Collection[Any] | None = None,
) -> Kinematics:
    """Return the kinematics with all points placed and velocities of the user's honoured.

    `falling` takes gravity for an acceleration where it can, and refers bodies on hinges to other
    points of their axes. Which velocities are to be honoured is found out, if it is not known.
    """
    honoured: set[Any] = set(known or ())
    checked: dict[Any, Any] = {}
    while True:
        kinematics = Kinematics(
            body,
            in_bodies=in_bodies,
            auxiliary=auxiliary,
            referred=referred,
            honoured=honoured,
        )
        if falling:
            take_gravity_off(kinematics)
        points = points_of(kinematics)
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
