"""Impulses of an impact: hypotheses of restitution, with Coulomb's law.

With velocities v of rows before it, those after impulses Λ are v + A Λ.

Newton: the normal velocity of a contact that closes is −e times the one before; Coulomb's law holds
for Λ and the sliding velocity after the impact.

Poisson: an impact has two phases. Compression ends with normal velocities that are not negative,
v_C = v + A Λ_C. In the second phase a contact gives back at least e Λ_C, and more only if it would
be pressed together by what others give back: Λ_E = e Λ_C + P in the normal direction, P ≥ 0, v_E ≥
0, P v_E = 0. Coulomb's law holds in each phase, for its impulses and the sliding velocity at its
end.

References
----------
F. Pfeiffer, C. Glocker, Multibody Dynamics with Unilateral Contacts, Wiley, 1996, chapter 8.
T. R. Kane, D. A. Levinson, Dynamics: Theory and Applications, McGraw-Hill, 1985, section 5.9: with
friction Newton's hypothesis may raise the energy.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from pydy._rank import ROUNDING
from pydy.contact.complementarity import (
    BACKWARD,
    CLOSED,
    FORWARD,
    OPEN,
    STARTING,
    STICKS,
    ComplementarityProblem,
    select_modes,
    solved,
)
from pydy.contact.missed_transitions import ContactSimulation, diagnose_flat_gap
from pydy.contact.tuning import ROUNDING_MARGIN, SLACK

if TYPE_CHECKING:
    from pydy._motion import Segment
    from pydy.contact.rows import RowValues

OPTIONS = (  # the modes of an impulse, by the number of tangential directions
    [CLOSED, OPEN],
    [STICKS, FORWARD, BACKWARD, OPEN],
    [STICKS, STARTING, OPEN],
)


RISES = {
    "newton": "An impact would raise the energy: Newton's hypothesis, with this restitution and "
    "friction, contradicts it. Use a smaller `restitution`, or the same for all contacts, or "
    "`Contacts(..., hypothesis='poisson')`.",
    "poisson": "An impact would raise the energy: Poisson's hypothesis, with these coefficients of "
    "restitution, contradicts it. Use a smaller `restitution`, or the same for all contacts.",
}

_NONE = {
    "newton": "No impulses satisfy Coulomb's law and Newton's hypothesis: friction would hold the "
    "contact where its `restitution` lets it move on. Use a smaller `restitution`, or "
    "`Contacts(..., hypothesis='poisson')`.",
    "poisson": "Jamming: no impulses satisfy Coulomb's law.",
}


def contradiction(hypothesis: str, e: np.ndarray) -> str:
    """Return a message: why an impact with coefficients of restitution e has no solution."""
    return _NONE[hypothesis if e.any() else "poisson"]  # without restitution both are the same


@dataclass(frozen=True)
class Phase:
    """The result of a phase of an impact."""

    # (rows,), impulses without `restitution_impulses`, and the velocities at the end.
    forces: np.ndarray
    rates: np.ndarray
    modes: tuple[str, ...]
    restitution_impulses: np.ndarray  # (contacts,), e Λ_C
    leaves: Collection[int] = ()  # contacts with P = 0, which may move apart


@dataclass(frozen=True)
class ImpactResult:
    """The result of an impact."""

    forces: np.ndarray  # (rows,), all impulses
    rates: np.ndarray  # the velocities after them
    phases: tuple[Phase, ...]

    @property
    def modes(self) -> tuple[str, ...]:
        """The modes at its end."""
        return self.phases[-1].modes

    def work(self, speed: np.ndarray) -> tuple[float, bool]:
        """Return the work of the impulses, and whether it would raise the energy."""
        work = 0.5 * float(self.forces @ (speed + self.rates))
        size = 0.5 * float(np.abs(self.forces) @ (np.abs(speed) + np.abs(self.rates)))
        return work, work > SLACK * size


def newton(
    problem: ComplementarityProblem, speed: np.ndarray, e: np.ndarray, closing: Collection[int],
    closed_before: Collection[int],
) -> ImpactResult | None:  # fmt: skip
    """Return the impact of the closed contacts; None if no impulses satisfy the laws.

    The velocities before it are `speed` (rows,), and `e` (contacts,) is the restitution. Contacts
    are `closing`, or `closed_before`.
    """
    start = speed.copy()
    for i in problem.closed:
        normal = problem.normal[i]
        if normal is not None and speed[normal] < 0.0 and i in closing:
            start[normal] = speed[normal] * (1.0 + e[i])
        elif normal is not None and i in closed_before:
            start[normal] = 0.0
    solution = select_modes(replace(problem, free=start, sizes=None), _options(problem))
    if solution is None:
        return None
    rates = speed + problem.delassus @ solution.forces
    return ImpactResult(
        solution.forces, rates, (Phase(solution.forces, rates, solution.modes, np.zeros(len(e))),)
    )


def poisson(
    problem: ComplementarityProblem, speed: np.ndarray, e: np.ndarray
) -> ImpactResult | None:
    """Return the impact of the closed contacts; None if no impulses satisfy the laws.

    The velocities before it are `speed` (rows,), and `e` (contacts,) is the restitution.
    """
    pressing = select_modes(replace(problem, free=speed, sizes=None), _options(problem))
    if pressing is None:
        return None
    restitution_impulses, returned = np.zeros(len(e)), np.zeros(len(speed))
    for i in problem.closed:
        normal = problem.normal[i]
        if normal is not None and pressing.modes[i] != OPEN:
            restitution_impulses[i] = returned[normal] = e[i] * max(
                float(pressing.forces[normal]), 0.0
            )
    first = Phase(pressing.forces, pressing.rates, pressing.modes, np.zeros(len(e)))
    if not restitution_impulses.any():
        return ImpactResult(pressing.forces, pressing.rates, (first,))
    free = pressing.rates + problem.delassus @ returned
    pushed = [int(i) for i in np.flatnonzero(restitution_impulses)]
    options_by_contact = _options(problem)
    for number in range(len(pushed) + 1):
        for pushing in itertools.combinations(pushed, number):  # contacts with P > 0
            leaves = [i for i in pushed if i not in pushing]
            # Where P = 0, the normal impulse is known, e Λ_C, and friction is bounded by it.
            second = replace(
                problem,
                free=free,
                sizes=None,
                pressed=restitution_impulses,
                normal=[None if i in leaves else n for i, n in enumerate(problem.normal)],
            )
            options = [
                [mode for mode in modes if mode != OPEN] if i in pushed else modes
                for i, modes in enumerate(options_by_contact)
            ]
            solution = select_modes(second, options)
            if solution is None:
                continue
            sizes = second.terms(solution.forces)
            separating_rows = [n for i in leaves if (n := problem.normal[i]) is not None]
            if (solution.rates[separating_rows] < -SLACK * sizes[separating_rows]).any():
                continue
            last = Phase(
                solution.forces, solution.rates, solution.modes, restitution_impulses, leaves
            )
            return ImpactResult(
                pressing.forces + returned + solution.forces, solution.rates, (first, last)
            )
    return None


def _options(problem: ComplementarityProblem) -> list[Sequence[str]]:
    return [
        OPTIONS[len(tangent)] if i in problem.closed else [OPEN]
        for i, tangent in enumerate(problem.tangent)
    ]


# -- effect of an impact on a motion ---------------------------------------------------------------


class ContactState(Protocol):
    """The current state of a motion, and of its contacts."""

    t: float
    x: np.ndarray
    closed: set[int]
    separating: set[int]  # open contacts whose gap is zero to rounding and increases
    at_rest: set[int]  # closed contacts whose sliding speed is zero


class ImpactedRun(ContactSimulation, Protocol):
    """A simulation with impacts, such as a `ContactRun`."""

    impacts: list[tuple[float, dict[str, tuple[float, ...]], float]]
    impacted: set[int]  # contacts that have closed
    first_height: dict[int, float]
    segments: list[Segment]
    transitions: Any  # Transitions, or None

    def complementarity(self, p: RowValues, state: Any) -> ComplementarityProblem:
        """Return the complementarity problem of accelerations and forces."""

    def note(self, state: Any, i: int, kind: str, before: np.ndarray) -> None:
        """Record a transition of a contact."""

    def note_rest(
        self,
        state: Any,
        i: int,
        p: RowValues,
        rebound: Any,
        slopes: dict[str, np.ndarray] | None,
    ) -> None:
        """Record the limit time of accumulating impacts of a contact."""

    def check_instant(
        self, state: Any, p: RowValues, slopes: np.ndarray, closing: Collection[int]
    ) -> None:
        """Refuse derivatives if contacts close together for these parameter values alone."""

    def is_low(self, i: int, speed: float, rate: Any, p: RowValues, x: np.ndarray) -> bool:
        """Whether the rebounds at a speed and acceleration are lower than the tolerance."""


def apply_impacts(run: ImpactedRun, state: ContactState, closing: set[int]) -> None:
    """Apply an impact to a `ContactRun`: contacts in `closing`, and all closed ones, take part."""
    p, rows = run.numbers(state.t, state.x), run.rows
    hit = {
        i
        for i, normal in enumerate(rows.normal)
        if normal is not None
        and (i in closing | state.closed or (i in state.separating and p.is_closed(i)))
    }
    _check_coefficients(run, state, p, closing if run.compiled.hypothesis == "newton" else hit, hit)
    rows.check_directions(hit - run.impacted, run.values(state.t, state.x))
    run.impacted |= hit
    problem = run.complementarity(p, state)
    rates = solved(problem, run.modes).rates
    for i in sorted(closing):  # impacts that rounding of the gap or the time could reverse
        speed, rate = abs(p.speed[rows.normal[i]]), abs(rates[rows.normal[i]])
        least = ROUNDING * p.gap_rounding[i] + speed * run.resolution(state.t)
        if speed**2 <= 16.0 * rate * least and (
            why := diagnose_flat_gap(run, state.t, state.x, [i])
        ):
            raise run.fail(state.t, state.x, why)
    impact, suppressed = _find_impact(run, state, p, problem, rates, hit, closing)
    work, rises = impact.work(p.speed)
    if rises:
        raise run.fail(state.t, state.x, RISES[run.compiled.hypothesis])
    before, e = state.x, np.zeros(len(rows.normal))  # the ratio of each rebound
    if run.compiled.hypothesis == "newton":
        back = [i for i in closing - suppressed.keys() if p.speed[rows.normal[i]] < 0.0]
        e[back] = p.restitution[back]
    slopes: dict[str, np.ndarray] | None = None
    if run.transitions is not None:
        slopes = _apply_derivatives(run, state, p, impact, e, hit & closing)
    state.x = before.copy()
    state.x[run.first : run.first + len(p.response)] += p.response @ impact.forces
    q = p.after(impact.forces)
    impulses: dict[str, tuple[float, ...]] = {}
    for i in sorted(hit):
        normal, name = rows.normal[i], run.contacts[i].name
        if impact.modes[i] != OPEN:
            impulses[name] = tuple(float(impact.forces[k]) for k in (normal, *rows.tangent[i]))
        _update_contact(run, state, i, p, q, impact, e[i])
        if i in closing:
            run.note(state, i, "closes", before)
        if i in suppressed and i in closing:
            run.first_height.pop(i, None)
            by_phases = run.compiled.hypothesis == "poisson"
            ratio = suppressed[i] / abs(p.speed[normal]) if by_phases else p.restitution[i]
            run.note_rest(state, i, p, (suppressed[i], abs(rates[normal]), ratio), slopes)
        elif i in state.closed:
            run.first_height.pop(i, None)
    for i in state.closed:
        # Friction with a known normal force has no impulse, but its speed has changed.
        if rows.normal[i] is None:
            state.at_rest.discard(i)
            if q.is_still(rows.tangent[i], impact.rates[rows.tangent[i]]):
                state.at_rest.add(i)
    run.impacts.append((state.t, impulses, work))


def _check_coefficients(
    run: ImpactedRun, state: ContactState, p: RowValues, restituted: set[int], hit: set[int]
) -> None:
    """Refuse an impact with coefficients that are expressions and have left their ranges."""
    ranges = (
        ("restitution", restituted, p.restitution, 1.0, "be from 0 to 1"),
        ("mu", hit, p.mu, np.inf, "not be negative"),
    )
    for argument, contacts, values, most, range_ in ranges:
        for i in sorted(contacts):
            if not -SLACK <= values[i] <= most + SLACK:
                raise run.fail(
                    state.t, state.x,
                    f"The `{argument}` of {run.contacts[i].name!r} became {values[i]:.3g} at an "
                    f"impact, but must {range_}. Give an expression that keeps within that.",
                )  # fmt: skip


def _find_impact(
    run: ImpactedRun,
    state: ContactState,
    p: RowValues,
    problem: ComplementarityProblem,
    rates: np.ndarray,
    hit: set[int],
    closing: set[int],
) -> tuple[ImpactResult, dict[int, float]]:
    """Return an impact, and the speeds of rebounds that are suppressed as too low."""
    hypothesis, e, speed = run.compiled.hypothesis, p.restitution, p.moving()
    every, flying = frozenset(hit), problem
    # No contact is pressed by other than the impulses that are sought.
    problem = replace(problem, hold=p.mu, pressed=np.zeros(len(e)), at_rest=every, closed=every)
    by_phases = hypothesis == "poisson"
    suppressed: dict[int, float] = {}
    effective = e.copy()
    while True:
        if by_phases:
            impact = poisson(problem, speed, effective)
        else:
            impact = newton(problem, speed, effective, closing, state.closed)
        low: dict[int, float] = {}
        for i in sorted((hit if by_phases else closing) - suppressed.keys()):
            normal = run.rows.normal[i]
            leaves = e[i] * abs(p.speed[normal])
            if by_phases:  # friction and other contacts change the rebound
                hits = impact is not None and impact.modes[i] != OPEN
                leaves = max(float(impact.rates[normal]), 0.0) if impact and hits else np.inf
            if e[i] > 0.0 and run.is_low(i, leaves, rates[normal], p, state.x):
                low[i] = leaves
        if not low:
            break
        suppressed |= low
        effective[list(suppressed)] = 0.0
        # Contacts that stay closed change the accelerations of others, whose rebounds may be low.
        rates = solved(
            flying, [CLOSED if i in suppressed else m for i, m in enumerate(run.modes)]
        ).rates
    if impact is None:
        raise run.fail(state.t, state.x, contradiction(hypothesis, effective))
    return impact, suppressed


def _apply_derivatives(
    run: ImpactedRun,
    state: ContactState,
    p: RowValues,
    impact: ImpactResult,
    e: np.ndarray,
    closing: set[int],
) -> dict[str, np.ndarray]:
    """Apply the derivatives of an impact; return the derivatives of the rows before it."""
    normals = run.rows.normal
    newtons = run.compiled.hypothesis == "newton"
    ratios = {i: float(e[i]) for i in closing if newtons and p.speed[normals[i]] < 0.0}
    closed_before = frozenset(state.closed if newtons else ())
    values = run.values(state.t, state.x)
    slopes: dict[str, np.ndarray] = run.transitions.impact(values, p, impact, ratios, closed_before)
    if run.segments:
        run.check_instant(state, p, slopes["gap"], closing)
    return slopes


def _update_contact(
    run: ImpactedRun,
    state: ContactState,
    i: int,
    p: RowValues,
    q: RowValues,
    impact: ImpactResult,
    ratio: float,
) -> None:
    """Update whether a contact of the impact separates, stays closed or comes to rest.

    The row values are `p` before and `q` after; by Newton's hypothesis it rebounds with `ratio`
    times its speed.
    """
    normal, rows, mode = run.rows.normal[i], run.rows.tangent[i], impact.modes[i]
    by_phases = run.compiled.hypothesis == "poisson"
    leaves = impact.rates[normal] if by_phases or mode == OPEN else -ratio * p.speed[normal]
    slow = max(
        SLACK * abs(p.speed[normal]),
        ROUNDING_MARGIN * np.finfo(float).eps * q.speed_rounding[normal],
    )
    state.at_rest.discard(i)
    if leaves > slow and leaves > 0.0:
        state.closed.discard(i)
        state.separating.add(i)
        return
    state.closed.add(i)
    state.separating.discard(i)
    if rows and (mode == STICKS or q.is_still(rows, impact.rates[rows])):
        state.at_rest.add(i)
