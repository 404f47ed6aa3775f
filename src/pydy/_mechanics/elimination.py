"""Inertia and forces, transferred from the outer velocities to the speeds.

The kinetic energy is a sum of quadratic forms in anchors (`pydy._mechanics.kinematics`), on which
forces act. From the outermost anchors inwards, each group k = R c of anchors transfers both to the
anchors c that it depends on: the form becomes Rᵀ K R, the force Rᵀ g. The result at the speeds is
Kane's mass matrix and forcing, M u' = F: each joint carries the *composite body* beyond it.

If a speed is eliminated as soon as no remaining anchor depends on it, the transferred form is the
*articulated-body* inertia, and the work is linear in the number of bodies of any tree
(Featherstone, Rigid Body Dynamics Algorithms, 2008, chs. 6 and 7). The pivots are those of LDLᵀ in
the order of elimination.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from heapq import heapify, heappop, heappush

from pydy._graph import Graph, inputs_of, signatures, substitute
from pydy._mechanics.components import dot, transposed
from pydy._mechanics.inertia import Inertia, Load
from pydy._mechanics.kinematics import Kinematics
from pydy._mechanics.planes import (
    IntermediateFrames,
    merged_rotations,
    plane_rotation_of,
    split,
)
from pydy._rank import ROUNDING


@dataclass(frozen=True)
class _PassedGroup:
    """An eliminated group of anchors: the rows of the form, and those of the whole step."""

    rows: dict[int, dict[int, int]]
    whole_rows: dict[int, dict[int, int]]


@dataclass(frozen=True)
class _EliminatedSpeed:
    """A speed that was eliminated: u' = (force − Σ share · other') · inverse."""

    speed: int
    force: int
    inverse: int
    shares: dict[int, int]


def composite(
    kinematics: Kinematics, inertias: Sequence[Inertia], loads: Sequence[Load]
) -> tuple[list[list[int]], list[int]]:
    """Return Kane's mass matrix and forcing for all speeds, dependent and auxiliary included."""
    push = _Push(kinematics, kinematics.groups, inertias, loads)
    graph, speeds = push.graph, push.speeds
    for group in push.order:
        push.pass_on(group)
    lower = [[push.entry(a, b) for b in speeds[: i + 1]] for i, a in enumerate(speeds)]
    n = range(len(speeds))
    m = [[lower[max(i, j)][min(i, j)] for j in n] for i in n]
    return m, [graph.sum(push.forces[s]) for s in speeds]


def eliminated(
    kinematics: Kinematics,
    inertias: Sequence[Inertia],
    loads: Sequence[Load],
    body_inertias: Sequence[Inertia],
) -> tuple[list[int], int]:
    """Return the accelerations by articulated-body elimination, and whether all pivots are sound.

    `body_inertias` are those of whole bodies; `inertias` may be divided up in another way.
    """
    intermediate_frames = kinematics.intermediate_frames
    push = _Push(
        kinematics,
        intermediate_frames.arranged(kinematics.groups),
        inertias,
        loads,
        body_inertias,
        intermediate_frames,
    )
    graph, speeds = push.graph, push.speeds
    remaining = dict.fromkeys(speeds)
    done: list[_PassedGroup | _EliminatedSpeed] = []
    pivots: list[tuple[int, int]] = []
    for group in push.order:
        cut = push.pass_on(group)
        done.append(cut)
        columns = dict.fromkeys(c for row in cut.rows.values() for c in row)
        ready = [c for c in columns if c in remaining and not push.waiting[c]]
        for speed in sorted(ready, key=lambda c: (len(push.near[c]), -c)):
            del remaining[speed]
            pivots.append((speed, push.entry(speed, speed)))
            done.append(push.eliminate(speed))
    for speed in remaining:
        pivots.append((speed, push.entry(speed, speed)))
        done.append(push.eliminate(speed))
    accelerations: dict[int, int] = {}
    for step in reversed(done):
        if isinstance(step, _EliminatedSpeed):
            terms = [(graph.mul(step.force, step.inverse), 1.0)]
            terms += [
                (graph.mul(share, accelerations[s]), -1.0) for s, share in step.shares.items()
            ]
            accelerations[step.speed] = graph.sum(terms)
        else:
            for node, row in step.whole_rows.items():
                accelerations[node] = graph.sum(
                    [(graph.mul(d, accelerations[c]), 1.0) for c, d in row.items()]
                )
    floors = {s: graph.sum([part[:2] for part in push.floors[s]]) for s in speeds}
    fixed = dict(zip(floors, _without_state(graph, list(floors.values())), strict=True))
    limits = _sizes(push)
    sound = graph.boolean(True)
    for speed, pivot in pivots:
        limit = graph.sum([(limits[speed], len(speeds) * ROUNDING)])
        floor = fixed.get(speed, graph.zero)
        # The inertia at the joint itself is part of the pivot: check it once per set of constants.
        if floor != graph.zero and graph.constant[floor] and graph.constant[limit]:
            pivot = floor
        sound = graph.call("and", sound, graph.call("lt", limit, pivot))
    return [accelerations[s] for s in speeds], sound


def partials(kinematics: Kinematics, velocity: Sequence[int]) -> list[list[int]]:
    """Return the partial velocities of a velocity, computed from anchor to anchor."""
    graph, rows, groups = kinematics.graph, kinematics.rows, kinematics.groups
    rows_through = {k: rows.from_operands(k) for group in groups for k in group}
    order = _sorted_groups([list(group) for group in groups], rows_through)[::-1]
    derivatives = []
    for node in velocity:
        row = {a: [(d, 1.0)] for a, d in rows(node).items()}
        for group in order:
            passed = [(rows_through[k], graph.sum(row.pop(k))) for k in group if k in row]
            for c in sorted({c for columns, _ in passed for c in columns}):
                terms = [(graph.mul(columns[c], n), 1.0) for columns, n in passed if c in columns]
                row.setdefault(c, []).append((graph.sum(terms), 1.0))
        derivatives.append([graph.sum(row.get(speed, ())) for speed in kinematics.speeds])
    return derivatives


class _Push:
    """Quadratic forms and forces that are transferred from anchors to speeds."""

    def __init__(
        self,
        kinematics: Kinematics,
        groups: Sequence[Sequence[int]],
        inertias: Sequence[Inertia],
        loads: Sequence[Load],
        body_inertias: Sequence[Inertia] = (),
        intermediate_frames: IntermediateFrames | None = None,
    ) -> None:
        graph, rows = kinematics.graph, kinematics.rows
        self.graph, self.speeds = graph, [*kinematics.speeds, *kinematics.auxiliary]
        # DerivativeRows of the anchors in one step, and in the plane rotations of the form.
        self.whole_rows = {k: rows.from_operands(k) for group in groups for k in group}
        self.step_rows = dict(self.whole_rows)
        self.cells: dict[tuple[int, int], list[tuple[int, float]]] = defaultdict(list)
        self.near: dict[int, set[int]] = defaultdict(set)
        self.forces: dict[int, list[tuple[int, float]]] = defaultdict(list)
        # The inertia of each velocity, by the anchors of its components.
        self.weights: list[tuple[list[int], int]] = []
        # Contributions to a lower bound of a speed's pivot, with a bit for each speed in them.
        self.floors: dict[int, list[tuple[int, float, int]]] = {s: [] for s in self.speeds}
        self.first: dict[tuple[int, int], list[tuple[int, float]]] = defaultdict(list)
        for inertia in inertias:
            for a, b, node, size in self._products(inertia, [rows(n) for n in inertia.velocity]):
                self.add(a, b, node, size)
        for inertia in body_inertias:
            inertia_rows = [rows(n) for n in inertia.velocity]
            for a, b, node, size in self._products(inertia, inertia_rows):
                self.first[_key(a, b)].append((node, size))
            self._weigh(inertia, inertia_rows)
        for load in loads:
            for n, force in zip(load.velocity, load.force, strict=True):
                for a, d in rows(n).items():
                    self.forces[a].append((graph.mul(d, force), 1.0))
        needed = {a for key in (*self.cells, *self.first) for a in key} | set(self.forces)
        order = _sorted_groups([list(group) for group in groups], self.whole_rows)[::-1]
        self._find_moving_speeds(order)
        self.groups = _needed(order, self.whole_rows, set(needed))
        self.order = self.groups
        if intermediate_frames is not None and (
            turning := intermediate_frames.paying(graph, order, self.whole_rows)
        ):
            self.step_rows.update((k, intermediate_frames.rows[k]) for k in turning)
            groups = split(groups, self.step_rows, turning)
            order = _sorted_groups(groups, self.step_rows)[::-1]
            self.order = _needed(order, self.step_rows, needed)
        self.waiting = Counter(c for group in self.order for k in group for c in self.step_rows[k])
        self.order = merged_rotations(graph, self.order, self.step_rows)

    def _products(
        self, inertia: Inertia, rows: list[dict[int, int]]
    ) -> Iterator[tuple[int, int, int, float]]:
        """Yield the entries of an inertia at the anchors."""
        graph, matrix = self.graph, inertia.matrix
        for i in range(len(rows)):
            for j in range(i + 1):
                if matrix[i][j] == graph.zero:
                    continue
                for a, x in rows[i].items():
                    for b, y in rows[j].items():
                        if i != j:
                            twice = 2.0 if a == b else 1.0
                            yield a, b, graph.mul(x, y, matrix[i][j]), twice
                        elif a >= b:
                            yield a, b, graph.mul(x, y, matrix[i][j]), 1.0

    def _weigh(self, inertia: Inertia, rows: list[dict[int, int]]) -> None:
        """Record the inertia of each velocity vector with its anchors."""
        for start in range(0, len(rows), 3):
            components = range(start, start + 3)
            trace = [(inertia.matrix[i][i], 1.0) for i in components if rows[i]]
            anchors = list(dict.fromkeys(a for i in components for a in rows[i]))
            if anchors:
                self.weights.append((anchors, self.graph.sum(trace)))

    def add(self, a: int, b: int, node: int, size: float = 1.0) -> None:
        """Add to an entry of the form; the entries (a, b) and (b, a) are one."""
        if node != self.graph.zero:
            self.cells[_key(a, b)].append((node, size))
            self.near[a].add(b)
            self.near[b].add(a)

    def entry(self, a: int, b: int) -> int:
        """Return an entry of the form."""
        key = _key(a, b)
        if key not in self.cells:
            return self.graph.zero
        cells = self.cells[key]
        if len(cells) == 1 and cells[0][1] == 1.0:
            return cells[0][0]
        node = self.graph.sum(cells)
        self.cells[key] = [(node, 1.0)]
        return node

    def pass_on(self, group: list[int]) -> _PassedGroup:
        """Transfer a group's quadratic form and forces to the anchors it depends on."""
        graph = self.graph
        rows = {k: self.step_rows[k] for k in group}
        block = [[self.entry(a, b) for b in group] for a in group]
        coupled = sorted({s for k in group for s in self.near[k]} - set(group))
        coupling = transposed([[self.entry(k, s) for s in coupled] for k in group])
        columns = sorted({c for row in rows.values() for c in row})
        forces = [graph.sum(self.forces[k]) for k in group]
        is_rotated = self._turn(group, block)
        for c in columns:
            slope = [rows[k].get(c, graph.zero) for k in group]
            if not is_rotated:
                self._reduce(c, columns, [rows[k] for k in group], block)
            for s, column in zip(coupled, coupling, strict=True):
                self.add(c, s, dot(self.graph, slope, column), 2.0 if c == s else 1.0)
            if c in self.floors:
                self._record_floor(c, dict(zip(group, slope, strict=True)))
        whole_rows = {k: self.whole_rows[k] for k in group}
        for c in sorted({c for row in whole_rows.values() for c in row}):
            slope = [row.get(c, graph.zero) for row in whole_rows.values()]
            self.forces[c].append((dot(self.graph, slope, forces), 1.0))
        for k in group:
            self._forget(k)
            for c in rows[k]:
                self.waiting[c] -= 1
        return _PassedGroup(rows, whole_rows)

    def _reduce(
        self, c: int, columns: list[int], rows: list[dict[int, int]], block: list[list[int]]
    ) -> None:
        """Add the column c, up to the diagonal, of Rᵀ K R."""
        zero = self.graph.zero
        slope = [row.get(c, zero) for row in rows]
        image = [dot(self.graph, line, slope) for line in block]
        for d in columns:
            if d <= c:
                self.add(c, d, dot(self.graph, [row.get(d, zero) for row in rows], image))

    def _turn(self, group: list[int], matrix: list[list[int]]) -> bool:
        """Add Rᵀ K R if all anchors rotate by one angle; return whether they do."""
        pairs = [group[k : k + 2] for k in range(0, len(group), 2)]
        turns = [plane_rotation_of(self.graph, self.step_rows, pair) for pair in pairs]
        used = {c for turn in turns if turn for c in turn.columns}
        same = {turn and (turn.cosine, turn.sine) for turn in turns}
        if None in same or len(same) > 1 or len(used) < len(group):
            return False
        for i, first in enumerate(turns):
            for j, second in enumerate(turns[: i + 1]):
                if first is None or second is None:
                    continue
                block = [line[2 * j : 2 * j + 2] for line in matrix[2 * i : 2 * i + 2]]
                image = first.transform(self.graph, block, second)
                for r, a in enumerate(first.columns):
                    for c, b in enumerate(second.columns):
                        if i != j or c <= r:
                            self.add(a, b, image[r][c])
        return True

    def _find_moving_speeds(self, order: list[list[int]]) -> None:
        """Determine the speeds that move each anchor and the anchors coupled to it."""
        bits = {s: 1 << k for k, s in enumerate(self.speeds)}
        for group in reversed(order):
            for k in group:
                bits[k] = 0
                for c in self.step_rows[k]:
                    bits[k] |= bits[c]
        self.bits = dict(bits)
        for a, b in self.first:
            self.bits[a] |= bits[b]
            self.bits[b] |= bits[a]
        for s in self.speeds:
            self._record_floor(s, {s: self.graph.one})

    def _record_floor(self, speed: int, slopes: dict[int, int]) -> None:
        """Record a lower bound of a speed's pivot: the inertia of the velocities that it moves.

        Eliminating speeds that do not move these velocities cannot reduce the pivot below it.
        """
        mask = 0
        for k in slopes:
            mask |= self.bits[k]
        for i, x in slopes.items():
            for j, y in slopes.items():
                if j <= i:
                    for node, size in self.first.get((i, j), ()):
                        weight = self.graph.mul(x, y, node), size * (1.0 if i == j else 2.0)
                        self.floors[speed].append((*weight, mask))

    def eliminate(self, x: int) -> _EliminatedSpeed:
        """Eliminate a speed by its own equation."""
        graph = self.graph
        inverse = graph.powi(self.entry(x, x), -1)
        force = graph.sum(self.forces[x])
        coupled = sorted(self.near[x] - {x})
        column = {s: self.entry(s, x) for s in coupled}
        shares = {s: graph.mul(column[s], inverse) for s in coupled}
        for s in self.floors.keys() & coupled:
            self.floors[s] = [part for part in self.floors[s] if not part[2] & self.bits[x]]
        for s in coupled:
            for r in coupled:
                if r <= s:
                    self.add(s, r, graph.mul(shares[s], column[r]), -1.0)
            self.forces[s].append((graph.mul(shares[s], force), -1.0))
        self._forget(x)
        return _EliminatedSpeed(x, force, inverse, shares)

    def _forget(self, node: int) -> None:
        for s in self.near.pop(node, ()):
            if s != node:
                self.near[s].discard(node)


def _key(a: int, b: int) -> tuple[int, int]:
    return (a, b) if a >= b else (b, a)


def _needed(
    order: Sequence[list[int]], rows: Mapping[int, dict[int, int]], wanted_anchors: set[int]
) -> list[list[int]]:
    """Return the wanted anchors of each group and the ones they depend on, outer groups first."""
    selected = []
    for group in order:
        if needed := [k for k in group if k in wanted_anchors]:
            selected.append(needed)
            wanted_anchors.update(c for k in needed for c in rows[k])
    return selected


def _sorted_groups(groups: list[list[int]], rows: dict[int, dict[int, int]]) -> list[list[int]]:
    """Sort groups after those they depend on; split groups that depend on each other.

    The order of creation is not always sorted: a node can depend on another that became an anchor
    later. It is retained as far as possible, a body at a time.
    """
    home = {k: i for i, group in enumerate(groups) for k in group}
    needs = [{home[c] for k in group for c in rows[k] if c in home} for group in groups]
    users = [0] * len(groups)
    for need in needs:
        for i in need:
            users[i] += 1
    free = [-i for i, count in enumerate(users) if not count]
    order: list[list[int]] = []
    heapify(free)
    while free:
        i = -heappop(free)
        order.append(groups[i])
        for j in needs[i]:
            users[j] -= 1
            if not users[j]:
                heappush(free, -j)
    if len(order) < len(groups):
        return _sorted_groups([[k] for group in groups for k in group], rows)
    return order[::-1]


def _sizes(push: _Push) -> dict[int, int]:
    """Estimate the diagonal of the mass matrix, as the scale of the pivots.

    The exact diagonal would cost as much as the composite form. Here one mean square is transferred
    for each group of anchors: it is invariant under rotations, and in most mechanisms depends on
    constants only.
    """
    graph = push.graph
    home = {k: i for i, group in enumerate(push.groups) for k in group}
    slopes = _mean_squares(push, home)
    totals: dict[int, list[tuple[int, float]]] = defaultdict(list)
    for anchors, weight in push.weights:
        for key in dict.fromkeys(home.get(a, -a) for a in anchors):
            totals[key].append((weight, 1.0))
    for i, slope in enumerate(slopes):
        size = graph.sum(totals[i])
        for key, n in slope.items():
            totals[key].append((graph.mul(n, size), 1.0))
    return {s: graph.sum(totals[-s]) for s in push.speeds}


def _mean_squares(push: _Push, home: dict[int, int]) -> list[dict[int, int]]:
    """Return the mean squares of each group's rows, by the groups that it depends on."""
    graph = push.graph
    ratios: list[dict[int, int]] = []
    for group in push.groups:
        squares: dict[int, list[tuple[int, float]]] = defaultdict(list)
        members: dict[int, set[int]] = defaultdict(set)
        for k in group:
            for c, d in push.whole_rows[k].items():
                key = home.get(c, -c)
                squares[key].append((graph.powi(d, 2), 1.0))
                members[key].add(c)
        ratios.append(
            {
                key: graph.sum([(graph.sum(terms), 1.0 / min(len(group), len(members[key])))])
                for key, terms in squares.items()
            }
        )
    nodes = list(dict.fromkeys(n for slope in ratios for n in slope.values()))
    fixed = dict(zip(nodes, _without_state(graph, nodes), strict=True))
    return [{key: fixed[n] for key, n in slope.items()} for slope in ratios]


def _without_state(graph: Graph, nodes: list[int]) -> list[int]:
    """Replace nodes that do not depend on the state by constants."""
    moving = inputs_of(graph, nodes).moving
    if not moving:
        return nodes
    fixed = substitute(graph, nodes, dict.fromkeys(moving, graph.zero))
    values = signatures(graph, [*nodes, *fixed])
    pairs = zip(nodes, fixed, values[: len(nodes)], values[len(nodes) :], strict=True)
    return [
        constant if value == constant_value else node
        for node, constant, value, constant_value in pairs
    ]
