"""Which contacts open, stick and slide: complementarity, solved by trying all combinations.

The accelerations of the rows are a = c + A λ with forces λ. For impacts the same equations hold
with velocities a and impulses λ. A contact is open, with λ_n = 0 and a_n ≥ 0, or closed, with
a_n = 0 and λ_n ≥ 0. A closed contact sticks, with a_t = 0 and |λ_t| ≤ μ λ_n, or slides in the
direction s, with λ_t = −μ s λ_n and s a_t ≥ 0. In a plane in space s is a unit vector; where
sliding begins, a_t points along s.
Where rows are linearly dependent, the forces are not unique. Those of least Euclidean norm are
used if they are inside the friction cones, the innermost ones otherwise.

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

import numpy as np
from scipy.optimize import linprog

from pydy._rank import DEPENDENT, HALF, ROUNDED, ROUNDING
from pydy.contact.tuning import BEGUN, CUTS, FEASIBLE, ROUNDING_MARGIN, SLACK, TILT, TURN_LIMIT

# -- Forces within friction: least margins of cones, and an iteration over contacts ----------------

_TOLERANCES = ("primal_feasibility_tolerance", "dual_feasibility_tolerance")


@dataclass(frozen=True)
class FrictionCone:
    """Conditions on unknowns y: y_n ≥ 0 and, with tangential ones, |y_t| ≤ μ (y_n + k)."""

    normal: int | None  # index of y_n; None if the normal force is known
    tangent: tuple[int, ...]  # indices of y_t
    hold: float  # μ, or the largest friction if the normal force is known
    known_force: float = 0.0  # k, a known normal force in addition to y_n

    def margin(self, y: np.ndarray) -> float:
        """Return the smallest slack of the inequalities."""
        press = 1.0 if self.normal is None else float(y[self.normal])
        least = np.inf if self.normal is None else press
        if not self.tangent:
            return least
        most = self.hold * (press + self.known_force)
        return min(least, most - float(np.linalg.norm(y[list(self.tangent)])))


def innermost(
    y: np.ndarray, null: np.ndarray, cones: Sequence[FrictionCone], size: float
) -> np.ndarray:
    """Return y + Z w with a cone margin of half the largest possible, which `size` limits.

    By a cutting-plane method: a linear program in which tangent planes replace the cones, so its
    margin is an upper bound. Where its solution is outside a cone, the tangent plane there is
    added. Of equal solutions, one with small normal forces is selected.
    """
    number = null.shape[1]
    unit = size or 1.0
    rows: list[np.ndarray] = []
    bounds: list[float] = []
    pressing = [c.normal for c in cones if c.normal is not None]
    cost = np.append(TILT / max(1, len(pressing)) * null[pressing].sum(axis=0), -1.0)

    def cut(cone: FrictionCone, normal: float, weights: Sequence[float] | np.ndarray = ()) -> None:
        """Add the inequality τ ≤ normal y_n − weights · y_t."""
        row, bound = np.zeros(number + 1), 0.0
        row[-1] = 1.0
        if cone.normal is None:
            bound += normal
        else:
            row[:-1] -= normal * null[cone.normal]
            bound += normal * (y[cone.normal] + (cone.known_force if len(weights) else 0.0))
        for k, share in zip(cone.tangent, weights, strict=False):
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
        optimum = linprog(
            cost, A_ub=np.array(rows), b_ub=np.array(bounds),
            bounds=[(None, None)] * number + [(None, 1.0)], method="highs-ds",
            options=dict.fromkeys(_TOLERANCES, FEASIBLE),
        )  # fmt: skip
        if optimum.x is None:
            break
        tried = y + unit * (null @ optimum.x[:-1])
        margin = min(c.margin(tried) for c in cones)
        if margin > most:
            best, most = tried, margin
        bound = unit * optimum.x[-1]
        if bound < 0.0 or most >= bound / 2.0 or bound - most <= unit * ROUNDED:
            break
        for cone in cones:
            if len(cone.tangent) == 2 and cone.margin(tried) < bound:
                friction = tried[list(cone.tangent)]
                if length := float(np.linalg.norm(friction)):  # otherwise the first planes bound it
                    cut(cone, cone.hold, friction / length)
    return best


@dataclass
class Relaxed:
    """An iterate: the forces of all rows, and the modes that they imply."""

    forces: np.ndarray
    # The unit vectors of contacts whose friction is at its limit.
    sliding: dict[int, np.ndarray]
    open: set[int]  # contacts without a normal force


def relaxed(
    free: np.ndarray,
    square: np.ndarray,
    contacts: Sequence[tuple[int, int | None, Sequence[int], float, float, float]],
    tied: dict[int, np.ndarray],
) -> Iterator[Relaxed]:
    """Solve for the forces by Gauss-Seidel iteration; yield after 1, 2, 4 … sweeps.

    `free` and `square` are c and A of a = c + A λ. Contacts are (contact, normal row, tangential
    rows, μ, μ_static, known normal force). The known force is the total if there is no normal row,
    and is added to that of the row otherwise. `tied` has the unit vectors of contacts that slide
    in a known direction.
    """
    estimate = Relaxed(np.zeros(len(free)), {}, set())
    forces = estimate.forces
    # Errors fall as exp(−sweeps/κ) with the condition number κ of J M⁻¹ Jᵀ. Half the digits take
    # 18 κ sweeps: this limit suffices for κ = 200. Otherwise all combinations are tried.
    for sweep in range(1, 4097):
        for i, normal, tangent, mu, hold, pressed in contacts:
            rows, press = list(tangent), pressed
            if normal is not None:
                column = square[normal, normal]
                if i in tied:
                    column = column - mu * square[normal, rows] @ tied[i]
                rate = free[normal] + square[normal] @ forces
                normal_force = forces[normal] = max(0.0, forces[normal] - rate / column)
                (estimate.open.discard if normal_force > 0.0 else estimate.open.add)(i)
                press = pressed + normal_force
            if i in tied:
                forces[rows] = -mu * press * tied[i]
            elif rows:
                stiff = np.linalg.eigvalsh(square[np.ix_(rows, rows)])[-1]
                trial = forces[rows] - (free[rows] + square[rows] @ forces) / stiff
                size = float(np.linalg.norm(trial))
                estimate.sliding.pop(i, None)
                if size > hold * press:
                    estimate.sliding[i] = -trial / size
                    trial = trial * (mu * press / size)
                forces[rows] = trial
        if sweep & (sweep - 1) == 0:
            yield estimate


# -- Combinations ----------------------------------------------------------------------------------

OPEN, CLOSED, STICKS, FORWARD, BACKWARD = "open", "closed", "sticks", "slides +", "slides -"
SLIDING, STARTING = "slides", "begins to slide"  # in a plane, in some direction
SLIDES = {FORWARD: 1.0, BACKWARD: -1.0, SLIDING: 1.0, STARTING: 1.0}


@dataclass(frozen=True)
class ComplementarityProblem:
    """The complementarity problem of accelerations, or of velocities in an impact."""

    free: np.ndarray  # (rows,), c
    delassus: np.ndarray  # (rows, rows), A = J M⁻¹ Jᵀ
    normal: Sequence[int | None]  # the normal row of each contact
    tangent: Sequence[Sequence[int]]  # the tangential rows of each contact: none, one or two
    # (contacts,), coefficients of kinetic and of static friction.
    mu: np.ndarray
    hold: np.ndarray
    # (contacts,), known normal forces: the total without a normal row, otherwise in addition to
    # that of the row.
    pressed: np.ndarray
    at_rest: frozenset[int]  # contacts at zero sliding speed: the direction must agree with a_t
    # Contacts with a gap of zero: where they open, a_n must not be negative.
    closed: frozenset[int]
    # (2,), unit vectors in which contacts slide in a plane.
    directions: Mapping[int, np.ndarray] = field(default_factory=dict)
    # (rows,), redundant forces are those with the least distance from these; zero by default.
    bias: np.ndarray | None = None
    # (rows,), the sum of the absolute terms of c; by default |c|.
    sizes: np.ndarray | None = None

    def terms(self, forces: np.ndarray) -> np.ndarray:
        """Return the sums of the absolute terms of a, with forces λ."""
        sizes = np.abs(self.free) if self.sizes is None else self.sizes
        return np.asarray(sizes + np.abs(self.delassus) @ np.abs(forces))

    def rounding(self, forces: np.ndarray) -> np.ndarray:
        """Return bounds on the rounding errors of velocities a with impulses λ; zero for forces.

        Entries of A that should be zero have rounding errors of the size of √(A_ii A_jj). Forces
        are compared at events, which locate them at their limits to rounding.
        """
        if self.sizes is not None:
            return np.zeros(len(self.free))
        root = np.sqrt(np.abs(np.diag(self.delassus)))
        terms = np.abs(self.free) + root * (root @ np.abs(forces))
        return np.asarray(ROUNDING_MARGIN * ROUNDING * terms)


@dataclass(frozen=True)
class ModeSolution:
    """The forces and accelerations of one combination of modes."""

    modes: tuple[str, ...]
    # (rows,), λ and a.
    forces: np.ndarray
    rates: np.ndarray
    # (contacts,), the smallest relative slack of the inequalities of each contact.
    margins: np.ndarray
    consistent: bool  # whether the equations have a solution
    # (contacts,), the force scale of each contact: its largest force, or the force that changes
    # its accelerations as much as all terms. Forces of other contacts may have another unit.
    sizes: np.ndarray
    directions: Mapping[int, np.ndarray]  # of the problem, with those of sliding onsets
    bias: np.ndarray | None  # the bias that was used
    # (active rows, …), null space: forces, as columns, that change no acceleration of these rows.
    null: np.ndarray


def all_open(contacts: int, rows: int) -> ModeSolution:
    """Return the solution with all contacts open; its accelerations are not computed."""
    nothing, sizes, margins = np.zeros(rows), np.zeros(contacts), np.full(contacts, np.inf)
    modes = (OPEN,) * contacts
    return ModeSolution(modes, nothing, nothing, margins, True, sizes, {}, None, np.zeros((0, 0)))


def rows_of_modes(problem: ComplementarityProblem, modes: Sequence[str]) -> list[int]:
    """Return the active rows of a combination: those whose accelerations vanish."""
    rows = []
    for i, mode in enumerate(modes):
        normal, tangent = problem.normal[i], problem.tangent[i]
        if normal is not None and mode != OPEN:
            rows.append(normal)
        if mode == STICKS:
            rows += tangent
    return rows


def independent(square: np.ndarray, rows: Sequence[int]) -> list[int]:
    """Return the rows that are linearly independent of earlier ones.

    By Cholesky factorisation of J M⁻¹ Jᵀ, row by row: a pivot is the squared norm of what remains
    of the row.
    """
    selected: list[int] = []
    for row in rows:
        pivot = square[row, row]
        if selected:
            part = square[np.ix_(selected, selected)]
            pivot = pivot - square[row, selected] @ np.linalg.solve(part, square[selected, row])
        if pivot > DEPENDENT * square[row, row]:
            selected.append(row)
    return selected


def linked(problem: ComplementarityProblem, contacts: Collection[int]) -> set[int]:
    """Return these contacts, and all others whose forces are coupled with theirs."""
    size = np.sqrt(np.abs(problem.delassus.diagonal()))
    rows = {
        i: [*(() if (n := problem.normal[i]) is None else (n,)), *problem.tangent[i]]
        for i in problem.closed
    }
    connected = set(contacts)
    latest = connected & rows.keys()
    while latest:
        latest_rows = [row for i in latest for row in rows[i]]
        latest = {
            i
            for i in rows.keys() - connected
            if (
                np.abs(problem.delassus[np.ix_(rows[i], latest_rows)])
                > ROUNDED * np.outer(size[rows[i]], size[latest_rows])
            ).any()
        }
        connected |= latest
    return connected


def direction(problem: ComplementarityProblem, i: int, mode: str) -> np.ndarray:
    """Return the unit vector in which a contact slides."""
    if mode in (SLIDING, STARTING):
        return problem.directions[i]
    return np.array([SLIDES[mode]])


def directions(
    problem: ComplementarityProblem, modes: Sequence[str]
) -> tuple[np.ndarray, np.ndarray]:
    """Return B and k, with the forces of all rows written as B y + k in unknowns y."""
    rows = len(problem.free)
    columns, known_forces = [], np.zeros(rows)
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
            known_forces[tangent] = (
                -problem.mu[i] * direction(problem, i, mode) * problem.pressed[i]
            )
        for row in tangent if mode == STICKS else ():
            column = np.zeros(rows)
            column[row] = 1.0
            columns.append(column)
    return np.array(columns).reshape(len(columns), rows).T, known_forces


def press(problem: ComplementarityProblem, forces: np.ndarray, i: int) -> float:
    """Return the normal force of a contact: the known part and that of its row."""
    normal = problem.normal[i]
    return float(problem.pressed[i] + (0.0 if normal is None else forces[normal]))


def _solve_rows(
    problem: ComplementarityProblem, modes: Sequence[str]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Solve for the forces that satisfy the active rows, by least squares.

    Also return the residual of each active row beyond `SLACK` of its terms, and the null space of
    forces that change no active row.
    """
    active = rows_of_modes(problem, modes)
    unknown, forces = directions(problem, modes)
    free, square = problem.free, problem.delassus
    null = np.zeros((len(active), 0))
    if not active:
        return forces, np.zeros(0), null
    start = np.zeros(len(active)) if problem.bias is None else problem.bias[active]
    right = -(free[active] + square[active] @ forces)
    matrix = square[active] @ unknown
    size = np.sqrt(np.abs(np.diag(square))[active])
    size[size == 0.0] = 1.0
    scaled = matrix / size[:, None]
    right_of = (right - matrix @ start) / size
    unknowns, _, rank, _ = np.linalg.lstsq(scaled, right_of, rcond=DEPENDENT)
    width = np.ones(len(active))
    if rank < len(active):
        # Forces of different units, or on bodies of different masses, differ in scale.
        column_norms = np.linalg.norm(scaled, axis=0)
        column_norms[column_norms == 0.0] = 1.0
        rescaled = np.linalg.lstsq(scaled / column_norms, right_of, rcond=DEPENDENT)
        if rescaled[2] > rank:
            width, rank, unknowns = column_norms, rescaled[2], rescaled[0] / column_norms
    unknowns = start + unknowns
    if rank < len(active):
        null = (np.linalg.svd(scaled / width)[2][rank:] / width).T
    forces = forces + unknown @ unknowns
    most = np.abs(right) + np.abs(matrix) @ np.abs(unknowns)
    for i in (i for i, mode in enumerate(modes) if mode == STICKS):
        # Residuals are compared with the effect of the largest friction, too.
        capacity = problem.hold[i] * abs(press(problem, forces, i))
        most += capacity * np.abs(square[np.ix_(active, problem.tangent[i])]).sum(axis=1)
    return forces, np.abs(matrix @ unknowns - right) - SLACK * most, null


def solved(problem: ComplementarityProblem, modes: Sequence[str]) -> ModeSolution:
    """Return the forces of a combination, with the margins of its inequalities."""
    forces, violation, null = _solve_rows(problem, modes)
    free, square, active = problem.free, problem.delassus, rows_of_modes(problem, modes)
    rates = free + square @ forces
    terms, rounding = problem.terms(forces), problem.rounding(forces)
    consistent = bool((violation <= rounding[active]).all()) if active else True
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

    def share(value: float, reference: float, rounding: float) -> float:
        return value / reference if reference > 0.0 and abs(value) > rounding else 0.0

    margins = np.full(len(modes), np.inf)
    for i, mode in enumerate(modes):
        normal, tangent = problem.normal[i], list(problem.tangent[i])
        values = []
        if mode == OPEN:
            if normal is not None and i in problem.closed:
                values.append(share(*(float(part[normal]) for part in (rates, terms, rounding))))
        elif normal is not None:
            values.append(share(float(forces[normal]), sizes[i], float(nothing[normal])))
        if mode == STICKS:
            friction = float(np.linalg.norm(forces[tangent]))
            capacity = problem.hold[i] * press(problem, forces, i)
            values.append(share(capacity - friction, sizes[i], float(nothing[tangent].max())))
        if mode in SLIDES and i in problem.at_rest:
            slip_rate = direction(problem, i, mode) @ rates[tangent]
            norms = [float(np.linalg.norm(part[tangent])) for part in (terms, rounding)]
            values.append(share(float(slip_rate), *norms))
        margins[i] = min(values, default=np.inf)
    return ModeSolution(
        tuple(modes), forces, rates, margins, consistent, sizes, problem.directions,
        problem.bias, null,
    )  # fmt: skip


def solved_with_onset(
    problem: ComplementarityProblem,
    modes: Sequence[str],
    guess: Mapping[int, np.ndarray] | None = None,
) -> ModeSolution | None:
    """Return the solution in which contacts at a sliding onset slide in the directions of a_t.

    Without a guess, the first trial direction is opposite to the friction that sticking would
    need; it is exact for bodies with isotropic inertia. The second is that of the acceleration
    without friction. Return None if Newton's method does not converge.
    """
    free = [i for i, mode in enumerate(modes) if mode == STARTING and i in problem.at_rest]
    if not free:
        return solved(problem, modes)
    if guess is not None:
        return _solve_directions(problem, modes, free, np.array([guess[i] for i in free]))
    sticking = solved(problem, [STICKS if i in free else mode for i, mode in enumerate(modes)])
    solution = None
    for vectors in (-sticking.forces, problem.free):
        solution = _solve_directions(
            problem, modes, free, vectors[[problem.tangent[i] for i in free]]
        )
        if solution is not None and solution.margins.min(initial=np.inf) >= -SLACK:
            break
    return solution


def _solve_directions(
    problem: ComplementarityProblem, modes: Sequence[str], free: Sequence[int], vectors: np.ndarray
) -> ModeSolution | None:
    """Solve for directions in which a_t has no transverse component, by Newton's method."""
    angles = np.arctan2(vectors[:, 1], vectors[:, 0])

    def evaluate(angles: np.ndarray) -> tuple[ModeSolution, np.ndarray, np.ndarray]:
        units = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        directions = {**problem.directions, **dict(zip(free, units, strict=True))}
        solution = solved(replace(problem, directions=directions), modes)
        across, ahead = np.zeros(len(free)), np.zeros(len(free))
        for k, i in enumerate(free):
            rows = list(problem.tangent[i])
            rate, unit = solution.rates[rows], units[k]
            magnitude = np.linalg.norm(problem.terms(solution.forces)[rows])
            if magnitude > 0.0:
                across[k] = (unit[0] * rate[1] - unit[1] * rate[0]) / magnitude
                ahead[k] = unit @ rate / magnitude
        return solution, across, ahead

    reversed_once = False
    for _ in range(40):
        solution, across, ahead = evaluate(angles)
        if np.abs(across).max() <= ROUNDED:
            back = ahead < -SLACK  # the opposite direction solves the equations, too
            if reversed_once or not back.any():
                return solution
            reversed_once = True
            angles = angles + np.pi * back
            continue
        columns = [
            (evaluate(angles + HALF * unit)[1] - across) / HALF for unit in np.eye(len(free))
        ]
        step = np.linalg.lstsq(np.array(columns).T, -across, rcond=DEPENDENT)[0]
        angles = angles + np.clip(step, -TURN_LIMIT, TURN_LIMIT)
    return None


def innermost_solution(problem: ComplementarityProblem, solution: ModeSolution) -> ModeSolution:
    """Return a solution with forces inside the friction cones, if the null space allows it."""
    if not solution.null.shape[1]:
        return solution
    active = rows_of_modes(problem, solution.modes)
    index_of_row = {row: k for k, row in enumerate(active)}
    cones = []
    for i, mode in enumerate(solution.modes):
        normal = problem.normal[i]
        if mode == OPEN or (normal is None and mode != STICKS):
            continue
        tangent = tuple(index_of_row[row] for row in problem.tangent[i]) if mode == STICKS else ()
        hold, pressed = float(problem.hold[i]), float(problem.pressed[i])
        if normal is None:
            cones.append(FrictionCone(None, tangent, hold * pressed))
        else:
            cones.append(FrictionCone(index_of_row[normal], tangent, hold, pressed))
    bias = np.zeros(len(problem.free))
    bias[active] = innermost(solution.forces[active], solution.null, cones, solution.sizes.max())
    better = solved(replace(problem, directions=solution.directions, bias=bias), solution.modes)
    return better if better.margins.min() > solution.margins.min() else solution


def has_sudden_onset(
    solution: ModeSolution, free: np.ndarray, tangents: Sequence[Sequence[int]]
) -> bool:
    """Whether all contacts at a sliding onset in a plane have a finite acceleration at once."""
    starting = [list(tangents[i]) for i, mode in enumerate(solution.modes) if mode == STARTING]
    sizes = [[np.linalg.norm(part[r]) for part in (solution.rates, free)] for r in starting]
    return bool(sizes) and all(rate > BEGUN * alone for rate, alone in sizes)


def _good(problem: ComplementarityProblem, solution: ModeSolution | None) -> ModeSolution | None:
    """Return the solution with its innermost forces; None if the equations are inconsistent."""
    if solution is None or not solution.consistent or not np.isfinite(solution.forces).all():
        return None
    return (
        solution
        if solution.margins.min(initial=np.inf) > SLACK
        else innermost_solution(problem, solution)
    )


def _relaxed(
    problem: ComplementarityProblem,
    options: Sequence[Sequence[str]],
    excluded: Collection[Sequence[str]],
) -> ModeSolution | None:
    """Return the combination that an iteration over the contacts leads to, or None."""
    contacts, tied = [], {}
    for i, allowed in enumerate(options):
        if list(allowed) == [OPEN]:
            continue
        normal, tangent = problem.normal[i], problem.tangent[i]
        sure = {mode for mode in allowed if mode != OPEN}
        if tangent and len(sure) == 1 and sure <= set(SLIDES) and i not in problem.at_rest:
            tied[i] = direction(problem, i, *sure)
        numbers = [float(part[i]) for part in (problem.mu, problem.hold, problem.pressed)]
        contacts.append((i, normal, tangent, *numbers))
    before: list[str] = []
    for estimate in relaxed(problem.free, problem.delassus, contacts, tied):  # type: ignore[arg-type]
        if not np.isfinite(estimate.forces).all():
            return None
        modes = []
        for i, allowed in enumerate(options):
            mode = CLOSED if not problem.tangent[i] else STICKS
            if i in estimate.open or list(allowed) == [OPEN]:
                mode = OPEN
            elif i in tied:
                mode = next(mode for mode in allowed if mode != OPEN)
            elif i in estimate.sliding:
                unit = estimate.sliding[i]
                mode = STARTING if len(unit) == 2 else FORWARD if unit[0] > 0.0 else BACKWARD
            modes.append(mode)
        possible = all(mode in allowed for mode, allowed in zip(modes, options, strict=True))
        if modes == before and possible and tuple(modes) not in excluded:
            for bias in (None, estimate.forces.copy()):
                near = replace(problem, bias=bias)
                tried = _good(near, solved_with_onset(near, modes, estimate.sliding))
                if tried is not None and tried.margins.min(initial=np.inf) >= -SLACK:
                    return tried
        before = modes
    return None


def select_modes(
    problem: ComplementarityProblem,
    options: Sequence[Sequence[str]],
    excluded: Collection[Sequence[str]] = (),
) -> ModeSolution | None:
    """Return the first combination that satisfies its inequalities, or nearly does, or None.

    Where several contacts may begin to slide in a plane, the result of an iteration over the
    contacts is tried after the first combination.
    """
    near: ModeSolution | None = None
    several = sum(STARTING in allowed for allowed in options) > 1
    for number, modes in enumerate(itertools.product(*options)):
        if modes not in excluded:
            tried = _good(problem, solved_with_onset(problem, modes))
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
