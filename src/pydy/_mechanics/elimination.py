"""Inertia and forces pushed from the outer velocities to the speeds.

A mechanism's motion is a sum of quadratic forms in anchors (`pydy._mechanics.kinematics`), and
forces on them. From the outermost anchors inwards, each group k = R c of anchors hands both over to
the anchors c that it is made of: the form becomes Rᵀ K R, the force Rᵀ g. What arrives at the
speeds is Kane's mass matrix and forcing, M u' = F: each joint carries the *composite body* beyond
it.

If a speed is eliminated as soon as no anchor that is left depends on it, the form that is handed on
is the *articulated-body* inertia, and the work is linear in the number of bodies of any tree
(Featherstone, Rigid Body Dynamics Algorithms, 2008, chs. 6 and 7). The pivots are those of LDLᵀ in
the order in which the speeds go.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from heapq import heapify, heappop, heappush

from pydy._graph import Graph, signatures, substitute
from pydy._mechanics.components import dot, transposed
from pydy._mechanics.inertia import Inertia, Load
from pydy._mechanics.kinematics import Kinematics
from pydy._mechanics.planes import Detours, joined_turns, split, turn_of
from pydy._rank import ROUNDING


@dataclass(frozen=True)
class _Passed:
    """An eliminated group of anchors: their rows, and the rows of the whole step."""

    rows: dict[int, dict[int, int]]
    whole: dict[int, dict[int, int]]


@dataclass(frozen=True)
class _Gone:
    """A speed that was eliminated: u' = (force − Σ share · other') · inverse."""

    speed: int
    force: int
    inverse: int
    shares: dict[int, int]


def composite(
    kinematics: Kinematics, inertias: Sequence[Inertia], loads: Sequence[Load]
) -> tuple[list[list[int]], list[int]]:
    """Return Kane's mass matrix and forcing for all speeds: dependent and auxiliary ones too."""
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
    plain: Sequence[Inertia],
) -> tuple[list[int], int]:
    """Return the accelerations by articulated-body elimination, and whether all pivots are sound.

    `plain` are the inertias of whole bodies, where `inertias` are divided up in another way.
    """
    detours = kinematics.detours
    push = _Push(kinematics, detours.arranged(kinematics.groups), inertias, loads, plain, detours)
    graph, speeds = push.graph, push.speeds
    left = dict.fromkeys(speeds)
    done: list[_Passed | _Gone] = []
    pivots: list[tuple[int, int]] = []
    for group in push.order:
        cut = push.pass_on(group)
        done.append(cut)
        columns = dict.fromkeys(c for row in cut.rows.values() for c in row)
        ready = [c for c in columns if c in left and not push.waiting[c]]
        for speed in sorted(ready, key=lambda c: (len(push.near[c]), -c)):
            del left[speed]
            pivots.append((speed, push.entry(speed, speed)))
            done.append(push.eliminate(speed))
    for speed in left:
        pivots.append((speed, push.entry(speed, speed)))
        done.append(push.eliminate(speed))
    found: dict[int, int] = {}
    for step in reversed(done):
        if isinstance(step, _Gone):
            terms = [(graph.mul(step.force, step.inverse), 1.0)]
            terms += [(graph.mul(share, found[s]), -1.0) for s, share in step.shares.items()]
            found[step.speed] = graph.sum(terms)
        else:
            for node, row in step.whole.items():
                found[node] = graph.sum([(graph.mul(d, found[c]), 1.0) for c, d in row.items()])
    floors = {s: graph.sum([part[:2] for part in push.floors[s]]) for s in speeds}
    fixed = dict(zip(floors, _without_state(graph, list(floors.values())), strict=True))
    limits = _sizes(push)
    sound = graph.boolean(True)
    for speed, pivot in pivots:
        limit = graph.sum([(limits[speed], len(speeds) * ROUNDING)])
        floor = fixed.get(speed, graph.zero)
        # What the bodies at the joint itself weigh is part of the pivot: checked once per binding.
        if floor != graph.zero and graph.constant[floor] and graph.constant[limit]:
            pivot = floor
        sound = graph.call("and", sound, graph.call("lt", limit, pivot))
    return [found[s] for s in speeds], sound


def partials(kinematics: Kinematics, velocity: Sequence[int]) -> list[list[int]]:
    """Return the derivatives of components of a velocity by the speeds, from anchor to anchor."""
    graph, rows, groups = kinematics.graph, kinematics.rows, kinematics.groups
    whole = {k: rows.through(k) for group in groups for k in group}
    order = _sorted_groups([list(group) for group in groups], whole)[::-1]
    found = []
    for node in velocity:
        row = {a: [(d, 1.0)] for a, d in rows(node).items()}
        for group in order:
            passed = [(whole[k], graph.sum(row.pop(k))) for k in group if k in row]
            for c in sorted({c for own, _ in passed for c in own}):
                terms = [(graph.mul(own[c], n), 1.0) for own, n in passed if c in own]
                row.setdefault(c, []).append((graph.sum(terms), 1.0))
        found.append([graph.sum(row.get(speed, ())) for speed in kinematics.speeds])
    return found


class _Push:
    """Quadratic forms and forces on their way from anchors to speeds."""

    def __init__(
        self,
        kinematics: Kinematics,
        groups: Sequence[Sequence[int]],
        inertias: Sequence[Inertia],
        loads: Sequence[Load],
        plain: Sequence[Inertia] = (),
        detours: Detours | None = None,
    ) -> None:
        graph, rows = kinematics.graph, kinematics.rows
        self.graph, self.speeds = graph, [*kinematics.speeds, *kinematics.auxiliary]
        # Rows of the anchors in one step, and as the form takes it.
        self.whole = {k: rows.through(k) for group in groups for k in group}
        self.own = dict(self.whole)
        self.cells: dict[tuple[int, int], list[tuple[int, float]]] = defaultdict(list)
        self.near: dict[int, set[int]] = defaultdict(set)
        self.forces: dict[int, list[tuple[int, float]]] = defaultdict(list)
        # What each velocity itself weighs, by the anchors of its components.
        self.weights: list[tuple[list[int], int]] = []
        # What of a speed's diagonal entry comes from there, and a bit for each speed in it.
        self.floors: dict[int, list[tuple[int, float, int]]] = {s: [] for s in self.speeds}
        self.first: dict[tuple[int, int], list[tuple[int, float]]] = defaultdict(list)
        for inertia in inertias:
            for a, b, node, size in self._products(inertia, [rows(n) for n in inertia.velocity]):
                self.add(a, b, node, size)
        for inertia in plain:
            own = [rows(n) for n in inertia.velocity]
            for a, b, node, size in self._products(inertia, own):
                self.first[_key(a, b)].append((node, size))
            self._weigh(inertia, own)
        for load in loads:
            for n, force in zip(load.velocity, load.force, strict=True):
                for a, d in rows(n).items():
                    self.forces[a].append((graph.mul(d, force), 1.0))
        wanted = {a for key in (*self.cells, *self.first) for a in key} | set(self.forces)
        order = _sorted_groups([list(group) for group in groups], self.whole)[::-1]
        self._moves(order)
        self.groups = _needed(order, self.whole, set(wanted))
        self.order = self.groups
        if detours is not None and (turning := detours.paying(graph, order, self.whole)):
            self.own.update((k, detours.rows[k]) for k in turning)
            groups = split(groups, self.own, turning)
            order = _sorted_groups(groups, self.own)[::-1]
            self.order = _needed(order, self.own, wanted)
        self.waiting = Counter(c for group in self.order for k in group for c in self.own[k])
        self.order = joined_turns(graph, self.order, self.own)

    def _products(
        self, inertia: Inertia, rows: list[dict[int, int]]
    ) -> Iterator[tuple[int, int, int, float]]:
        """Give the entries that an inertia has at the anchors."""
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
        """Record the inertia of a velocity vector as a weight of its anchors."""
        for start in range(0, len(rows), 3):
            own = range(start, start + 3)
            trace = [(inertia.matrix[i][i], 1.0) for i in own if rows[i]]
            anchors = list(dict.fromkeys(a for i in own for a in rows[i]))
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

    def pass_on(self, group: list[int]) -> _Passed:
        """Transfer a group's quadratic form and forces to the anchors it depends on."""
        graph = self.graph
        rows = {k: self.own[k] for k in group}
        within = [[self.entry(a, b) for b in group] for a in group]
        others = sorted({s for k in group for s in self.near[k]} - set(group))
        across = transposed([[self.entry(k, s) for s in others] for k in group])
        columns = sorted({c for row in rows.values() for c in row})
        forces = [graph.sum(self.forces[k]) for k in group]
        turned = self._turn(group, within)
        for c in columns:
            slope = [rows[k].get(c, graph.zero) for k in group]
            if not turned:
                self._reduce(c, columns, [rows[k] for k in group], within)
            for s, column in zip(others, across, strict=True):
                self.add(c, s, dot(self.graph, slope, column), 2.0 if c == s else 1.0)
            if c in self.floors:
                self._found(c, dict(zip(group, slope, strict=True)))
        whole = {k: self.whole[k] for k in group}
        for c in sorted({c for row in whole.values() for c in row}):
            slope = [row.get(c, graph.zero) for row in whole.values()]
            self.forces[c].append((dot(self.graph, slope, forces), 1.0))
        for k in group:
            self._forget(k)
            for c in rows[k]:
                self.waiting[c] -= 1
        return _Passed(rows, whole)

    def _reduce(
        self, c: int, columns: list[int], rows: list[dict[int, int]], within: list[list[int]]
    ) -> None:
        """Add the column c, up to the diagonal, of Rᵀ K R."""
        zero = self.graph.zero
        slope = [row.get(c, zero) for row in rows]
        image = [dot(self.graph, line, slope) for line in within]
        for d in columns:
            if d <= c:
                self.add(c, d, dot(self.graph, [row.get(d, zero) for row in rows], image))

    def _turn(self, group: list[int], within: list[list[int]]) -> bool:
        """Add Rᵀ K R where all anchors turn by one angle; say whether they do."""
        pairs = [group[k : k + 2] for k in range(0, len(group), 2)]
        turns = [turn_of(self.graph, self.own, pair) for pair in pairs]
        used = {c for turn in turns if turn for c in turn.columns}
        same = {turn and (turn.cosine, turn.sine) for turn in turns}
        if None in same or len(same) > 1 or len(used) < len(group):
            return False
        for i, one in enumerate(turns):
            for j, two in enumerate(turns[: i + 1]):
                if one is None or two is None:
                    continue
                block = [line[2 * j : 2 * j + 2] for line in within[2 * i : 2 * i + 2]]
                image = one.of(self.graph, block, two)
                for r, a in enumerate(one.columns):
                    for c, b in enumerate(two.columns):
                        if i != j or c <= r:
                            self.add(a, b, image[r][c])
        return True

    def _moves(self, order: list[list[int]]) -> None:
        """Find which speeds move each anchor and the anchors coupled to it."""
        bits = {s: 1 << k for k, s in enumerate(self.speeds)}
        for group in reversed(order):
            for k in group:
                bits[k] = 0
                for c in self.own[k]:
                    bits[k] |= bits[c]
        self.bits = dict(bits)
        for a, b in self.first:
            self.bits[a] |= bits[b]
            self.bits[b] |= bits[a]
        for s in self.speeds:
            self._found(s, {s: self.graph.one})

    def _found(self, speed: int, slopes: dict[int, int]) -> None:
        """Record a lower bound of a speed's pivot: the inertia of the velocities that it moves.

        A pivot is not below that, once speeds are eliminated that do not move these velocities: it
        is the least that the bodies weigh, whatever those do.
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

    def eliminate(self, x: int) -> _Gone:
        """Take a speed out by its own equation."""
        graph = self.graph
        inverse = graph.powi(self.entry(x, x), -1)
        force = graph.sum(self.forces[x])
        others = sorted(self.near[x] - {x})
        column = {s: self.entry(s, x) for s in others}
        shares = {s: graph.mul(column[s], inverse) for s in others}
        for s in self.floors.keys() & others:
            self.floors[s] = [part for part in self.floors[s] if not part[2] & self.bits[x]]
        for s in others:
            for r in others:
                if r <= s:
                    self.add(s, r, graph.mul(shares[s], column[r]), -1.0)
            self.forces[s].append((graph.mul(shares[s], force), -1.0))
        self._forget(x)
        return _Gone(x, force, inverse, shares)

    def _forget(self, node: int) -> None:
        for s in self.near.pop(node, ()):
            if s != node:
                self.near[s].discard(node)


def _key(a: int, b: int) -> tuple[int, int]:
    return (a, b) if a >= b else (b, a)


def _needed(
    order: Sequence[list[int]], rows: Mapping[int, dict[int, int]], wanted: set[int]
) -> list[list[int]]:
    """Return the wanted anchors of each group and the ones they depend on, outer groups first."""
    found = []
    for group in order:
        if needed := [k for k in group if k in wanted]:
            found.append(needed)
            wanted.update(c for k in needed for c in rows[k])
    return found


def _sorted_groups(groups: list[list[int]], rows: dict[int, dict[int, int]]) -> list[list[int]]:
    """Sort groups after those they depend on; split groups that depend on each other.

    In the order in which they were made they are not always sorted: a node can be made of another
    that became an anchor later. That order is kept as far as it goes, a body at a time.
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
    """Return how large each diagonal entry of the mass matrix is, to judge a pivot by.

    The composite bodies' own entries would cost as much as a composite form. What is handed on here
    is one number for each group of anchors, a mean square: a rotation leaves it as it is, so that
    in most mechanisms it depends on constants alone.
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
    """Return for each group that of its rows by the groups it is made of."""
    graph = push.graph
    found: list[dict[int, int]] = []
    for group in push.groups:
        squares: dict[int, list[tuple[int, float]]] = defaultdict(list)
        members: dict[int, set[int]] = defaultdict(set)
        for k in group:
            for c, d in push.whole[k].items():
                key = home.get(c, -c)
                squares[key].append((graph.powi(d, 2), 1.0))
                members[key].add(c)
        found.append(
            {
                key: graph.sum([(graph.sum(terms), 1.0 / min(len(group), len(members[key])))])
                for key, terms in squares.items()
            }
        )
    nodes = list(dict.fromkeys(n for slope in found for n in slope.values()))
    fixed = dict(zip(nodes, _without_state(graph, nodes), strict=True))
    return [{key: fixed[n] for key, n in slope.items()} for slope in found]


def _without_state(graph: Graph, nodes: list[int]) -> list[int]:
    """Rewrite nodes that are equal in every state without the state."""
    moving = graph.inputs(nodes, moving=True)
    if not moving:
        return nodes
    fixed = substitute(graph, nodes, dict.fromkeys(moving, graph.zero))
    values = signatures(graph, [*nodes, *fixed])
    pairs = zip(nodes, fixed, values[: len(nodes)], values[len(nodes) :], strict=True)
    return [other if one == two else node for node, other, one, two in pairs]
