"""Which contacts open, stick and slide: complementarity, solved by trying all combinations.

For accelerations of rows a = c + A λ, of impulses p likewise with velocities in place of a. A
contact is open, with λ_n = 0 and a_n ≥ 0; or closed, with a_n = 0 and λ_n ≥ 0, and then it sticks,
with a_t = 0 and |λ_t| ≤ μ λ_n, or slides in the direction s with λ_t = −μ s λ_n and s a_t ≥ 0. In
a plane in space s is a unit vector, and a_t points along it where sliding begins.
Where rows depend on each other, the forces are the least in the Euclidean norm.

References
----------
F. Pfeiffer, C. Glocker, Multibody Dynamics with Unilateral Contacts, Wiley, 1996, chapters 6–8.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from pydy._rank import DEPENDENT, HALF, ROUNDED
from pydy.contact.tuning import SLACK, TURNED, TURNS

OPEN, CLOSED, STICKS, FORWARD, BACKWARD = "open", "closed", "sticks", "slides +", "slides -"
SLIDING, STARTING = "slides", "begins to slide"  # in a plane, in some direction
SLIDES = {FORWARD: 1.0, BACKWARD: -1.0, SLIDING: 1.0, STARTING: 1.0}


@dataclass(frozen=True)
class Problem:
    """What the combinations are tried on.

    Attributes
    ----------
    free : ndarray, shape (rows,)
        c.
    square : ndarray, shape (rows, rows)
        A.
    normal : sequence of int or None
        The normal row of each contact.
    tangent : sequence of sequences of int
        The tangential rows of each contact: none, one or two.
    mu, hold : ndarray, shape (contacts,)
        Coefficients of kinetic friction, and of the largest friction that holds.
    pressed : ndarray, shape (contacts,)
        Normal forces of contacts without a normal row.
    resting : collection of int
        Contacts whose direction of sliding is free, and must agree with a_t.
    touching : collection of int
        Contacts with a gap of zero: where they open, a_n must not be negative.
    directions : mapping of int to ndarray, shape (2,)
        The directions in which contacts slide in a plane, if they do.
    """

    free: np.ndarray
    square: np.ndarray
    normal: Sequence[int | None]
    tangent: Sequence[Sequence[int]]
    mu: np.ndarray
    hold: np.ndarray
    pressed: np.ndarray
    resting: frozenset[int]
    touching: frozenset[int]
    directions: Mapping[int, np.ndarray] = field(default_factory=dict)


@dataclass(frozen=True)
class Solution:
    """What a combination gives.

    Attributes
    ----------
    forces, rates : ndarray, shape (rows,)
        λ and a.
    margins : ndarray, shape (contacts,)
        By how much the inequalities of each contact hold, as a share of what is compared.
    consistent : bool
        Whether the equations have a solution.
    largest : float
        The largest of the forces, and of those that would change the accelerations as much.
    directions : mapping of int to ndarray
        Those of the problem, and those that were found.
    """

    modes: tuple[str, ...]
    forces: np.ndarray
    rates: np.ndarray
    margins: np.ndarray
    consistent: bool
    largest: float
    directions: Mapping[int, np.ndarray] = field(default_factory=dict)


def held_rows(problem: Problem, modes: Sequence[str]) -> list[int]:
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
    """Return those of some rows that do not follow from the ones before them.

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


def direction(problem: Problem, i: int, mode: str) -> np.ndarray:
    """Return the unit vector in which a contact slides."""
    if mode in (SLIDING, STARTING):
        return problem.directions[i]
    return np.array([SLIDES[mode]])


def directions(problem: Problem, modes: Sequence[str]) -> tuple[np.ndarray, np.ndarray]:
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
        elif mode in SLIDES:
            known[tangent] = -problem.mu[i] * direction(problem, i, mode) * problem.pressed[i]
        for row in tangent if mode == STICKS else ():
            column = np.zeros(rows)
            column[row] = 1.0
            columns.append(column)
    return np.array(columns).reshape(len(columns), rows).T, known


def solved(problem: Problem, modes: Sequence[str]) -> Solution:
    """Return the forces of a combination, and how well its inequalities hold."""
    held = held_rows(problem, modes)
    unknown, forces = directions(problem, modes)
    free, square = problem.free, problem.square
    consistent = True
    if held:
        right = -(free[held] + square[held] @ forces)
        matrix = square[held] @ unknown
        size = np.sqrt(np.abs(np.diag(square))[held])
        size[size == 0.0] = 1.0
        found = np.linalg.lstsq(matrix / size[:, None], right / size, rcond=DEPENDENT)[0]
        forces = forces + unknown @ found
        most = np.abs(right) + np.abs(matrix) @ np.abs(found)
        consistent = bool((np.abs(matrix @ found - right) <= SLACK * most).all())
    rates = free + square @ forces
    terms = np.abs(free) + np.abs(square) @ np.abs(forces)
    diagonal = np.abs(np.diag(square))
    natural = np.divide(terms, diagonal, out=np.zeros_like(terms), where=diagonal > 0.0)
    largest = max(np.abs(forces).max(initial=0.0), natural.max(initial=0.0))

    def share(value: float, of: float) -> float:
        return value / of if of > 0.0 else 0.0

    margins = np.full(len(modes), np.inf)
    for i, mode in enumerate(modes):
        normal, tangent = problem.normal[i], list(problem.tangent[i])
        own = []
        if mode == OPEN:
            if normal is not None and i in problem.touching:
                own.append(share(rates[normal], terms[normal]))
        elif normal is not None:
            own.append(share(forces[normal], largest))
        if mode == STICKS:
            press = problem.pressed[i] if normal is None else forces[normal]
            friction = float(np.linalg.norm(forces[tangent]))
            own.append(share(problem.hold[i] * press - friction, largest))
        if mode in SLIDES and i in problem.resting:
            along = direction(problem, i, mode) @ rates[tangent]
            own.append(share(float(along), float(np.linalg.norm(terms[tangent]))))
        margins[i] = min(own, default=np.inf)
    return Solution(tuple(modes), forces, rates, margins, consistent, largest, problem.directions)


def turned(problem: Problem, modes: Sequence[str]) -> Solution | None:
    """Return the solution where contacts that begin to slide do so in the directions of a_t.

    The first guess is against the friction that would hold them; it is exact for bodies that move
    alike in all directions. Newton's method turns them until a_t has no part across. None: there is
    no end.
    """
    free = [i for i, mode in enumerate(modes) if mode == STARTING and i in problem.resting]
    if not free:
        return solved(problem, modes)
    held = solved(problem, [STICKS if i in free else mode for i, mode in enumerate(modes)])
    angles = np.zeros(len(free))
    for k, i in enumerate(free):
        one, two = -held.forces[list(problem.tangent[i])]
        angles[k] = np.arctan2(two, one)

    def tried(angles: np.ndarray) -> tuple[Solution, np.ndarray]:
        units = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        directions = {**problem.directions, **dict(zip(free, units, strict=True))}
        found = solved(replace(problem, directions=directions), modes)
        across = np.zeros(len(free))
        for k, i in enumerate(free):
            own = list(problem.tangent[i])
            rate, unit = found.rates[own], units[k]
            size = np.abs(problem.free[own]) + np.abs(problem.square[own]) @ np.abs(found.forces)
            whole = np.linalg.norm(size)
            across[k] = (unit[0] * rate[1] - unit[1] * rate[0]) / whole if whole > 0.0 else 0.0
        return found, across

    for _ in range(TURNS):
        found, across = tried(angles)
        if np.abs(across).max() <= ROUNDED:
            return found
        columns = [(tried(angles + HALF * unit)[1] - across) / HALF for unit in np.eye(len(free))]
        step = np.linalg.lstsq(np.array(columns).T, -across, rcond=DEPENDENT)[0]
        angles = angles + np.clip(step, -TURNED, TURNED)
    return None


def chosen(problem: Problem, options: Sequence[Sequence[str]]) -> Solution | None:
    """Return the first combination whose inequalities hold, or nearly hold; None if none does."""
    near: Solution | None = None
    for modes in itertools.product(*options):
        tried = turned(problem, modes)
        if tried is None or not tried.consistent or not np.isfinite(tried.forces).all():
            continue
        worst = tried.margins.min(initial=np.inf)
        if worst >= 0.0:
            return tried
        if worst >= -SLACK and near is None:
            near = tried
    return near
