"""Which contacts open, stick and slide: complementarity, solved by trying all combinations.

For accelerations of rows a = c + A λ, of impulses p likewise with velocities in place of a. A
contact is open, with λ_n = 0 and a_n ≥ 0; or closed, with a_n = 0 and λ_n ≥ 0, and then it sticks,
with a_t = 0 and |λ_t| ≤ μ λ_n, or slides in the direction s with λ_t = −μ s λ_n and s a_t ≥ 0. In
a plane in space s is a unit vector, and a_t points along it where sliding begins.
Where rows depend on each other, the forces are the least in the Euclidean norm if they are within
the cones, and the innermost ones otherwise.

References
----------
F. Pfeiffer, C. Glocker, Multibody Dynamics with Unilateral Contacts, Wiley, 1996, chapters 6–8.
M. Jean, The non-smooth contact dynamics method, Computer Methods in Applied Mechanics and
Engineering 177 (1999), 235–257: Gauss and Seidel's iteration over contacts.
J. E. Kelley, The cutting-plane method for solving convex programs, Journal of the Society for
Industrial and Applied Mathematics 8 (1960), 703–712.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from scipy.optimize import linprog

from pydy._rank import DEPENDENT, HALF, ROUNDED, ROUNDING
from pydy.contact.tuning import BEGUN, CUTS, FEASIBLE, SLACK, TILT, TURNED, WITHIN

# -- Forces within friction: least margins of cones, and an iteration over contacts ----------------

_TOLERANCES = ("primal_feasibility_tolerance", "dual_feasibility_tolerance")


@dataclass(frozen=True)
class Cone:
    """y_n ≥ 0 and, with tangential unknowns, |y_t| ≤ μ (y_n + k) of some unknowns y."""

    normal: int | None  # its unknown; None if the normal force is known
    tangent: tuple[int, ...]
    hold: float  # μ, or the largest friction if the normal force is known
    known: float = 0.0  # k, a normal force beside the unknown one

    def margin(self, y: np.ndarray) -> float:
        """Return by how much the inequalities hold."""
        press = 1.0 if self.normal is None else float(y[self.normal])
        least = np.inf if self.normal is None else press
        if not self.tangent:
            return least
        most = self.hold * (press + self.known)
        return min(least, most - float(np.linalg.norm(y[list(self.tangent)])))


def innermost(y: np.ndarray, null: np.ndarray, cones: Sequence[Cone], size: float) -> np.ndarray:
    """Return y + Z w with a least margin of all cones of half the largest possible, or `size`.

    The linear program has planes that touch the cones, so that its margin is a bound; where its
    solution is outside a cone, the plane there is added. Of equal solutions, one with small normal
    forces is taken.
    """
    number = null.shape[1]
    unit = size or 1.0
    rows: list[np.ndarray] = []
    bounds: list[float] = []
    pressing = [c.normal for c in cones if c.normal is not None]
    cost = np.append(TILT / max(1, len(pressing)) * null[pressing].sum(axis=0), -1.0)

    def cut(cone: Cone, normal: float, along: Any = ()) -> None:
        """Add τ ≤ normal y_n − along · y_t."""
        row, bound = np.zeros(number + 1), 0.0
        row[-1] = 1.0
        if cone.normal is None:
            bound += normal
        else:
            row[:-1] -= normal * null[cone.normal]
            bound += normal * (y[cone.normal] + (cone.known if len(along) else 0.0))
        for k, share in zip(cone.tangent, along, strict=False):
            row[:-1] += share * null[k]
            bound -= share * y[k]
        rows.append(row)
        bounds.append(bound / unit)

    for cone in cones:
        if cone.normal is not None:
            cut(cone, 1.0)
        for axis in np.eye(len(cone.tangent)):
            cut(cone, cone.hold, axis)
            cut(cone, cone.hold, -axis)
    best, most = y, min((c.margin(y) for c in cones), default=0.0)
    for _ in range(CUTS):
        found = linprog(
            cost, A_ub=np.array(rows), b_ub=np.array(bounds),
            bounds=[(None, None)] * number + [(None, 1.0)], method="highs-ds",
            options=dict.fromkeys(_TOLERANCES, FEASIBLE),
        )  # fmt: skip
        if found.x is None:
            break
        tried = y + unit * (null @ found.x[:-1])
        margin = min(c.margin(tried) for c in cones)
        if margin > most:
            best, most = tried, margin
        bound = unit * found.x[-1]
        if bound < 0.0 or most >= bound / 2.0 or bound - most <= unit * ROUNDED:
            break
        for cone in cones:
            if len(cone.tangent) == 2 and cone.margin(tried) < bound:
                along = tried[list(cone.tangent)]
                if own := float(np.linalg.norm(along)):  # else the first planes bound it
                    cut(cone, cone.hold, along / own)
    return best


@dataclass
class Relaxed:
    """The forces of all rows, and the modes of the contacts with them."""

    forces: np.ndarray
    # The unit vectors of contacts whose friction is as large as it may be.
    sliding: dict[int, np.ndarray]
    open: set[int]  # contacts without a normal force


def relaxed(
    free: np.ndarray,
    square: np.ndarray,
    contacts: Sequence[tuple[int, int | None, Sequence[int], float, float, float]],
    tied: dict[int, np.ndarray],
) -> Iterator[Relaxed]:
    """Iterate over contacts, each with the forces of the others; yield after 1, 2, 4 … sweeps.

    `free` and `square` are of a = c + A λ. Contacts are (contact, normal row, tangential rows, μ,
    μ_static, known normal force: all of it, or beside that of the row), and `tied` has the unit
    vectors of those that slide in a known direction.
    """
    found = Relaxed(np.zeros(len(free)), {}, set())
    forces = found.forces
    # Errors fall as exp(−sweeps/κ) with the condition number κ of J M⁻¹ Jᵀ. Half the digits take
    # 18 κ: this is enough for κ = 200. Beyond that all combinations are tried.
    for sweep in range(1, 4097):
        for i, normal, tangent, mu, hold, pressed in contacts:
            own, press = list(tangent), pressed
            if normal is not None:
                column = square[normal, normal]
                if i in tied:
                    column = column - mu * square[normal, own] @ tied[i]
                rate = free[normal] + square[normal] @ forces
                own_press = forces[normal] = max(0.0, forces[normal] - rate / column)
                (found.open.discard if own_press > 0.0 else found.open.add)(i)
                press = pressed + own_press
            if i in tied:
                forces[own] = -mu * press * tied[i]
            elif own:
                stiff = np.linalg.eigvalsh(square[np.ix_(own, own)])[-1]
                wanted = forces[own] - (free[own] + square[own] @ forces) / stiff
                size = float(np.linalg.norm(wanted))
                found.sliding.pop(i, None)
                if size > hold * press:
                    found.sliding[i] = -wanted / size
                    wanted = wanted * (mu * press / size)
                forces[own] = wanted
        if sweep & (sweep - 1) == 0:
            yield found


# -- Combinations ----------------------------------------------------------------------------------

OPEN, CLOSED, STICKS, FORWARD, BACKWARD = "open", "closed", "sticks", "slides +", "slides -"
SLIDING, STARTING = "slides", "begins to slide"  # in a plane, in some direction
SLIDES = {FORWARD: 1.0, BACKWARD: -1.0, SLIDING: 1.0, STARTING: 1.0}


@dataclass(frozen=True)
class ComplementarityProblem:
    """The problem that combinations of modes are tried on."""

    free: np.ndarray  # (rows,), c
    square: np.ndarray  # (rows, rows), A
    normal: Sequence[int | None]  # the normal row of each contact
    tangent: Sequence[Sequence[int]]  # the tangential rows of each contact: none, one or two
    # (contacts,), coefficients of kinetic friction, and of the largest friction that holds.
    mu: np.ndarray
    hold: np.ndarray
    # (contacts,), normal forces that are known: all of them without a normal row, otherwise beside
    # its own.
    pressed: np.ndarray
    resting: frozenset[int]  # contacts whose direction of sliding is free, and must agree with a_t
    # Contacts with a gap of zero: where they open, a_n must not be negative.
    touching: frozenset[int]
    # (2,), the directions in which contacts slide in a plane, if they do.
    directions: Mapping[int, np.ndarray] = field(default_factory=dict)
    # (rows,), forces from which those that are not determined differ least; zero by default.
    bias: np.ndarray | None = None
    # (rows,), those of the terms that c is the sum of; by default that of c.
    sizes: np.ndarray | None = None

    def terms(self, forces: np.ndarray) -> np.ndarray:
        """Return the sizes of the terms of a, with some forces λ."""
        own = np.abs(self.free) if self.sizes is None else self.sizes
        return np.asarray(own + np.abs(self.square) @ np.abs(forces))

    def rounding(self, forces: np.ndarray) -> np.ndarray:
        """Return bounds on the rounding errors of velocities a with impulses λ; zero for forces.

        Entries of A that should be zero are rounded as √(A_ii A_jj), their bound, is. Forces are
        compared where an event has found them at their limits: there rounding tells.
        """
        if self.sizes is not None:
            return np.zeros(len(self.free))
        root = np.sqrt(np.abs(np.diag(self.square)))
        terms = np.abs(self.free) + root * (root @ np.abs(forces))
        return np.asarray(WITHIN * ROUNDING * terms)


@dataclass(frozen=True)
class Solution:
    """The result of a combination."""

    modes: tuple[str, ...]
    # (rows,), λ and a.
    forces: np.ndarray
    rates: np.ndarray
    # (contacts,), by how much the inequalities of each contact hold, as a share of what is
    # compared.
    margins: np.ndarray
    consistent: bool  # whether the equations have a solution
    # (contacts,), the largest of the forces of each contact, and of those that would change its
    # accelerations as much as all that act. Those of others may be of another kind, or hold other
    # bodies.
    sizes: np.ndarray
    directions: Mapping[int, np.ndarray]  # those of the problem, and those that were found
    bias: np.ndarray | None  # the one that was used
    # (held rows, …), forces of the held rows, as columns, that change no acceleration of a held
    # row.
    null: np.ndarray


def opened(contacts: int, rows: int) -> Solution:
    """Return the solution where all contacts are open, of which accelerations are not asked."""
    nothing, sizes, margins = np.zeros(rows), np.zeros(contacts), np.full(contacts, np.inf)
    modes = (OPEN,) * contacts
    return Solution(modes, nothing, nothing, margins, True, sizes, {}, None, np.zeros((0, 0)))


def held_rows(problem: ComplementarityProblem, modes: Sequence[str]) -> list[int]:
    """Return the rows that a combination holds."""
    found = []
    for i, mode in enumerate(modes):
        normal, tangent = problem.normal[i], problem.tangent[i]
        if normal is not None and mode != OPEN:
            found.append(normal)
        if mode == STICKS:
            found += tangent
    return found


def independent(square: np.ndarray, rows: Sequence[int]) -> list[int]:
    """Return the rows that are independent of earlier ones.

    By Cholesky's factorisation of J M⁻¹ Jᵀ, row by row; pivots are squares of what is left.
    """
    found: list[int] = []
    for row in rows:
        left = square[row, row]
        if found:
            part = square[np.ix_(found, found)]
            left = left - square[row, found] @ np.linalg.solve(part, square[found, row])
        if left > DEPENDENT * square[row, row]:
            found.append(row)
    return found


def linked(problem: ComplementarityProblem, some: Collection[int]) -> set[int]:
    """Return the contacts whose forces may depend on those of some, through bodies in between."""
    size = np.sqrt(np.abs(problem.square.diagonal()))
    rows = {
        i: [*(() if (n := problem.normal[i]) is None else (n,)), *problem.tangent[i]]
        for i in problem.touching
    }
    found = set(some)
    latest = found & rows.keys()
    while latest:
        own = [row for i in latest for row in rows[i]]
        latest = {
            i
            for i in rows.keys() - found
            if (
                np.abs(problem.square[np.ix_(rows[i], own)])
                > ROUNDED * np.outer(size[rows[i]], size[own])
            ).any()
        }
        found |= latest
    return found


def direction(problem: ComplementarityProblem, i: int, mode: str) -> np.ndarray:
    """Return the unit vector in which a contact slides."""
    if mode in (SLIDING, STARTING):
        return problem.directions[i]
    return np.array([SLIDES[mode]])


def directions(
    problem: ComplementarityProblem, modes: Sequence[str]
) -> tuple[np.ndarray, np.ndarray]:
    """Return the forces of all rows as B y + k of unknowns y, and k."""
    rows = len(problem.free)
    columns, known = [], np.zeros(rows)
    for i, mode in enumerate(modes):
        normal, tangent = problem.normal[i], list(problem.tangent[i])
        if mode == OPEN:
            continue
        if normal is not None:
            column = np.zeros(rows)
            column[normal] = 1.0
            if mode in SLIDES:
                column[tangent] = -problem.mu[i] * direction(problem, i, mode)
            columns.append(column)
        if mode in SLIDES:
            known[tangent] = -problem.mu[i] * direction(problem, i, mode) * problem.pressed[i]
        for row in tangent if mode == STICKS else ():
            column = np.zeros(rows)
            column[row] = 1.0
            columns.append(column)
    return np.array(columns).reshape(len(columns), rows).T, known


def press(problem: ComplementarityProblem, forces: np.ndarray, i: int) -> float:
    """Return the normal force of a contact: the known part plus that of its row."""
    normal = problem.normal[i]
    return float(problem.pressed[i] + (0.0 if normal is None else forces[normal]))


def _held(
    problem: ComplementarityProblem, modes: Sequence[str]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the forces of a combination that hold its rows, or come next to it.

    Also by how much each row is missed beyond `SLACK` of its terms, and what forces may differ by
    that changes nothing.
    """
    held = held_rows(problem, modes)
    unknown, forces = directions(problem, modes)
    free, square = problem.free, problem.square
    null = np.zeros((len(held), 0))
    if not held:
        return forces, np.zeros(0), null
    start = np.zeros(len(held)) if problem.bias is None else problem.bias[held]
    right = -(free[held] + square[held] @ forces)
    matrix = square[held] @ unknown
    size = np.sqrt(np.abs(np.diag(square))[held])
    size[size == 0.0] = 1.0
    scaled = matrix / size[:, None]
    right_of = (right - matrix @ start) / size
    found, _, rank, _ = np.linalg.lstsq(scaled, right_of, rcond=DEPENDENT)
    width = np.ones(len(held))
    if rank < len(held):
        # Forces of different kinds, or on bodies of other masses, have sizes of their own.
        own = np.linalg.norm(scaled, axis=0)
        own[own == 0.0] = 1.0
        again = np.linalg.lstsq(scaled / own, right_of, rcond=DEPENDENT)
        if again[2] > rank:
            width, rank, found = own, again[2], again[0] / own
    found = start + found
    if rank < len(held):
        null = (np.linalg.svd(scaled / width)[2][rank:] / width).T
    forces = forces + unknown @ found
    most = np.abs(right) + np.abs(matrix) @ np.abs(found)
    for i in (i for i, mode in enumerate(modes) if mode == STICKS):
        # Beside what its friction could do, the rest of a motion through v² is nothing.
        most_of_it = problem.hold[i] * abs(press(problem, forces, i))
        most += most_of_it * np.abs(square[np.ix_(held, problem.tangent[i])]).sum(axis=1)
    return forces, np.abs(matrix @ found - right) - SLACK * most, null


def solved(problem: ComplementarityProblem, modes: Sequence[str]) -> Solution:
    """Return the forces of a combination, and how well its inequalities hold."""
    forces, missed, null = _held(problem, modes)
    free, square, held = problem.free, problem.square, held_rows(problem, modes)
    rates = free + square @ forces
    terms, rounding = problem.terms(forces), problem.rounding(forces)
    consistent = bool((missed <= rounding[held]).all()) if held else True
    diagonal = np.abs(np.diag(square))
    natural, nothing = (
        np.divide(part, diagonal, out=np.zeros_like(part), where=diagonal > 0.0)
        for part in (terms, rounding)
    )
    sizes = np.zeros(len(modes))
    for i, (normal, tangent) in enumerate(zip(problem.normal, problem.tangent, strict=True)):
        own_rows = [*tangent, *(() if normal is None else (normal,))]
        sizes[i] = np.maximum(np.abs(forces), natural)[own_rows].max(initial=0.0)
        sizes[i] = max(sizes[i], problem.hold[i] * abs(problem.pressed[i]))

    def share(value: float, of: float, rounding: float) -> float:
        return value / of if of > 0.0 and abs(value) > rounding else 0.0

    margins = np.full(len(modes), np.inf)
    for i, mode in enumerate(modes):
        normal, tangent = problem.normal[i], list(problem.tangent[i])
        own = []
        if mode == OPEN:
            if normal is not None and i in problem.touching:
                own.append(share(*(float(part[normal]) for part in (rates, terms, rounding))))
        elif normal is not None:
            own.append(share(float(forces[normal]), sizes[i], float(nothing[normal])))
        if mode == STICKS:
            friction = float(np.linalg.norm(forces[tangent]))
            most_of_it = problem.hold[i] * press(problem, forces, i)
            own.append(share(most_of_it - friction, sizes[i], float(nothing[tangent].max())))
        if mode in SLIDES and i in problem.resting:
            along = direction(problem, i, mode) @ rates[tangent]
            norms = [float(np.linalg.norm(part[tangent])) for part in (terms, rounding)]
            own.append(share(float(along), *norms))
        margins[i] = min(own, default=np.inf)
    return Solution(
        tuple(modes), forces, rates, margins, consistent, sizes, problem.directions,
        problem.bias, null,
    )  # fmt: skip


def turned(
    problem: ComplementarityProblem,
    modes: Sequence[str],
    guess: Mapping[int, np.ndarray] | None = None,
) -> Solution | None:
    """Return the solution where contacts that begin to slide do so in the directions of a_t.

    Without a guess of the directions, the first one is against the friction that would hold them;
    it is exact for bodies that move alike in all directions. The second is what they would do
    without friction. None: Newton's method does not end.
    """
    free = [i for i, mode in enumerate(modes) if mode == STARTING and i in problem.resting]
    if not free:
        return solved(problem, modes)
    if guess is not None:
        return _turned(problem, modes, free, np.array([guess[i] for i in free]))
    held = solved(problem, [STICKS if i in free else mode for i, mode in enumerate(modes)])
    found = None
    for vectors in (-held.forces, problem.free):
        found = _turned(problem, modes, free, vectors[[problem.tangent[i] for i in free]])
        if found is not None and found.margins.min(initial=np.inf) >= -SLACK:
            break
    return found


def _turned(
    problem: ComplementarityProblem, modes: Sequence[str], free: Sequence[int], vectors: np.ndarray
) -> Solution | None:
    """Turn the directions of some contacts by Newton's method until a_t has no part across."""
    angles = np.arctan2(vectors[:, 1], vectors[:, 0])

    def tried(angles: np.ndarray) -> tuple[Solution, np.ndarray, np.ndarray]:
        units = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        directions = {**problem.directions, **dict(zip(free, units, strict=True))}
        found = solved(replace(problem, directions=directions), modes)
        across, ahead = np.zeros(len(free)), np.zeros(len(free))
        for k, i in enumerate(free):
            own = list(problem.tangent[i])
            rate, unit = found.rates[own], units[k]
            whole = np.linalg.norm(problem.terms(found.forces)[own])
            if whole > 0.0:
                across[k] = (unit[0] * rate[1] - unit[1] * rate[0]) / whole
                ahead[k] = unit @ rate / whole
        return found, across, ahead

    reversed_once = False
    for _ in range(40):
        found, across, ahead = tried(angles)
        if np.abs(across).max() <= ROUNDED:
            back = ahead < -SLACK  # a direction is found as well as its opposite
            if reversed_once or not back.any():
                return found
            reversed_once = True
            angles = angles + np.pi * back
            continue
        columns = [(tried(angles + HALF * unit)[1] - across) / HALF for unit in np.eye(len(free))]
        step = np.linalg.lstsq(np.array(columns).T, -across, rcond=DEPENDENT)[0]
        angles = angles + np.clip(step, -TURNED, TURNED)
    return None


def within(problem: ComplementarityProblem, found: Solution) -> Solution:
    """Return a solution with the innermost forces, if the least ones are outside of their cones.

    Those that differ by what changes no acceleration are tried.
    """
    if not found.null.shape[1]:
        return found
    held = held_rows(problem, found.modes)
    places = {row: k for k, row in enumerate(held)}
    cones = []
    for i, mode in enumerate(found.modes):
        normal = problem.normal[i]
        if mode == OPEN or (normal is None and mode != STICKS):
            continue
        tangent = tuple(places[row] for row in problem.tangent[i]) if mode == STICKS else ()
        hold, pressed = float(problem.hold[i]), float(problem.pressed[i])
        if normal is None:
            cones.append(Cone(None, tangent, hold * pressed))
        else:
            cones.append(Cone(places[normal], tangent, hold, pressed))
    bias = np.zeros(len(problem.free))
    bias[held] = innermost(found.forces[held], found.null, cones, found.sizes.max())
    better = solved(replace(problem, directions=found.directions, bias=bias), found.modes)
    return better if better.margins.min() > found.margins.min() else found


def leaps(solution: Solution, free: np.ndarray, tangents: Sequence[Sequence[int]]) -> bool:
    """Whether all contacts that begin to slide in a plane do so at once with an acceleration."""
    starting = [list(tangents[i]) for i, mode in enumerate(solution.modes) if mode == STARTING]
    sizes = [[np.linalg.norm(part[r]) for part in (solution.rates, free)] for r in starting]
    return bool(sizes) and all(rate > BEGUN * alone for rate, alone in sizes)


def _good(problem: ComplementarityProblem, found: Solution | None) -> Solution | None:
    """Return a solution within its cones, if there is one; None if its equations have none."""
    if found is None or not found.consistent or not np.isfinite(found.forces).all():
        return None
    return found if found.margins.min(initial=np.inf) > SLACK else within(problem, found)


def _relaxed(
    problem: ComplementarityProblem,
    options: Sequence[Sequence[str]],
    excluded: Collection[Sequence[str]],
) -> Solution | None:
    """Return the combination that forces tell, found by iteration; None if they tell none."""
    contacts, tied = [], {}
    for i, own in enumerate(options):
        if list(own) == [OPEN]:
            continue
        normal, tangent = problem.normal[i], problem.tangent[i]
        sure = {mode for mode in own if mode != OPEN}
        if tangent and len(sure) == 1 and sure <= set(SLIDES) and i not in problem.resting:
            tied[i] = direction(problem, i, *sure)
        numbers = [float(part[i]) for part in (problem.mu, problem.hold, problem.pressed)]
        contacts.append((i, normal, tangent, *numbers))
    before: list[str] = []
    for told in relaxed(problem.free, problem.square, contacts, tied):  # type: ignore[arg-type]
        if not np.isfinite(told.forces).all():
            return None
        modes = []
        for i, own in enumerate(options):
            mode = CLOSED if not problem.tangent[i] else STICKS
            if i in told.open or list(own) == [OPEN]:
                mode = OPEN
            elif i in tied:
                mode = next(mode for mode in own if mode != OPEN)
            elif i in told.sliding:
                along = told.sliding[i]
                mode = STARTING if len(along) == 2 else FORWARD if along[0] > 0.0 else BACKWARD
            modes.append(mode)
        possible = all(mode in own for mode, own in zip(modes, options, strict=True))
        if modes == before and possible and tuple(modes) not in excluded:
            for bias in (None, told.forces.copy()):
                near = replace(problem, bias=bias)
                tried = _good(near, turned(near, modes, told.sliding))
                if tried is not None and tried.margins.min(initial=np.inf) >= -SLACK:
                    return tried
        before = modes
    return None


def chosen(
    problem: ComplementarityProblem,
    options: Sequence[Sequence[str]],
    excluded: Collection[Sequence[str]] = (),
) -> Solution | None:
    """Return the first combination whose inequalities hold, or nearly hold; None if none does.

    Where several contacts may begin to slide in a plane, the combination that an iteration over the
    contacts leads to is tried after the first one.
    """
    near: Solution | None = None
    several = sum(STARTING in own for own in options) > 1
    for number, modes in enumerate(itertools.product(*options)):
        if modes not in excluded:
            tried = _good(problem, turned(problem, modes))
            if tried is not None:
                worst = tried.margins.min(initial=np.inf)
                if worst >= 0.0:
                    return tried
                if worst >= -SLACK and near is None:
                    near = tried
        if several and number == 0:
            tried = near or _relaxed(problem, options, excluded)
            if tried is not None:
                return tried
    return near
