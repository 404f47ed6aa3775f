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
from typing import Any

import numpy as np

from pydy._rank import ROUNDING
from pydy.contact.decide import (
    BACKWARD,
    CLOSED,
    FORWARD,
    OPEN,
    STARTING,
    STICKS,
    ComplementarityProblem,
    chosen,
    solved,
)
from pydy.contact.missed import flat
from pydy.contact.tuning import SLACK, WITHIN

OPTIONS = (  # what an impulse may do, by the number of tangential directions
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
    """Say why an impact with some coefficients of restitution has no solution."""
    return _NONE[hypothesis if e.any() else "poisson"]  # without rebounds both are the same


@dataclass(frozen=True)
class Phase:
    """The result of a phase of an impact."""

    # (rows,), impulses beside those that are given, and the velocities after them.
    forces: np.ndarray
    rates: np.ndarray
    modes: tuple[str, ...]
    given: np.ndarray  # (contacts,), e Λ_C
    leaves: Collection[int] = ()  # contacts with P = 0, which may move apart


@dataclass(frozen=True)
class Blow:
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
    still: Collection[int],
) -> Blow | None:  # fmt: skip
    """Return the impact of the contacts that touch; None if no impulses satisfy the laws.

    The problem's free velocities are not used, but `speed` (rows,), and `e` (contacts,). Contacts
    are `closing`, or `still` closed from before.
    """
    start = speed.copy()
    for i in problem.touching:
        normal = problem.normal[i]
        if normal is not None and speed[normal] < 0.0 and i in closing:
            start[normal] = speed[normal] * (1.0 + e[i])
        elif normal is not None and i in still:
            start[normal] = 0.0
    found = chosen(replace(problem, free=start, sizes=None), _options(problem))
    if found is None:
        return None
    rates = speed + problem.square @ found.forces
    return Blow(found.forces, rates, (Phase(found.forces, rates, found.modes, np.zeros(len(e))),))


def poisson(problem: ComplementarityProblem, speed: np.ndarray, e: np.ndarray) -> Blow | None:
    """Return the impact of the contacts that touch; None if no impulses satisfy the laws."""
    pressing = chosen(replace(problem, free=speed, sizes=None), _options(problem))
    if pressing is None:
        return None
    given, known = np.zeros(len(e)), np.zeros(len(speed))
    for i in problem.touching:
        normal = problem.normal[i]
        if normal is not None and pressing.modes[i] != OPEN:
            given[i] = known[normal] = e[i] * max(float(pressing.forces[normal]), 0.0)
    first = Phase(pressing.forces, pressing.rates, pressing.modes, np.zeros(len(e)))
    if not given.any():
        return Blow(pressing.forces, pressing.rates, (first,))
    free = pressing.rates + problem.square @ known
    pushed = [int(i) for i in np.flatnonzero(given)]
    every = _options(problem)
    for number in range(len(pushed) + 1):
        for more in itertools.combinations(pushed, number):  # contacts with P > 0
            leaves = [i for i in pushed if i not in more]
            second = replace(
                problem,
                free=free,
                sizes=None,
                pressed=given,
                normal=[None if i in leaves else n for i, n in enumerate(problem.normal)],
            )
            options = [
                [mode for mode in own if mode != OPEN] if i in pushed else own
                for i, own in enumerate(every)
            ]
            found = chosen(second, options)
            if found is None:
                continue
            sizes = second.terms(found.forces)
            apart = [n for i in leaves if (n := problem.normal[i]) is not None]
            if (found.rates[apart] < -SLACK * sizes[apart]).any():
                continue
            last = Phase(found.forces, found.rates, found.modes, given, leaves)
            return Blow(pressing.forces + known + found.forces, found.rates, (first, last))
    return None


def _options(problem: ComplementarityProblem) -> list[Sequence[str]]:
    return [
        OPTIONS[len(tangent)] if i in problem.touching else [OPEN]
        for i, tangent in enumerate(problem.tangent)
    ]


# -- what an impact does to a motion ---------------------------------------------------------------


def strike(run: Any, state: Any, closing: set[int]) -> None:
    """Apply the impulses of contacts that close to a `Run`; all that are closed take part."""
    p, rows = run.numbers(state.t, state.x), run.rows
    hit = {
        i
        for i, normal in enumerate(rows.normal)
        if normal is not None
        and (i in closing | state.touching or (i in state.rising and p.is_closed(i)))
    }
    rows.check_directions(hit - run.struck, run.values(state.t, state.x))
    run.struck |= hit
    problem = run.problem(p, state)
    rates = solved(problem, run.modes).rates
    for i in sorted(closing):  # those that could be turned by roundings of the gap or the time
        speed, rate = abs(p.speed[rows.normal[i]]), abs(rates[rows.normal[i]])
        least = ROUNDING * p.near[i] + speed * run.resolution(state.t)
        if speed**2 <= 16.0 * rate * least and (why := flat(run, state.t, state.x, [i])):
            raise run.fail(state.t, state.x, why)
    blow, rests = _blow(run, state, p, problem, rates, hit, closing)
    work, rises = blow.work(p.speed)
    if rises:
        raise run.fail(state.t, state.x, RISES[run.kept.hypothesis])
    before, e = state.x, np.zeros(len(rows.normal))  # what is given back of each speed
    if run.kept.hypothesis == "newton":
        back = [i for i in closing - rests.keys() if p.speed[rows.normal[i]] < 0.0]
        e[back] = p.restitution[back]
    slopes: Any = None
    if run.carried is not None:
        slopes = _carried(run, state, p, blow, e, hit & closing)
    state.x = before.copy()
    state.x[run.first : run.first + len(p.moves)] += p.moves @ blow.forces
    q = p.after(blow.forces)
    impulses: dict[str, tuple[float, ...]] = {}
    for i in sorted(hit):
        normal, name = rows.normal[i], run.contacts[i].name
        if blow.modes[i] != OPEN:
            impulses[name] = tuple(float(blow.forces[k]) for k in (normal, *rows.tangent[i]))
        _parted(run, state, i, p, q, blow, e[i])
        if i in closing:
            run.note(state, i, "closes", before)
        if i in rests and i in closing:
            run.first_height.pop(i, None)
            by_phases = run.kept.hypothesis == "poisson"
            ratio = rests[i] / abs(p.speed[normal]) if by_phases else p.restitution[i]
            run.note_rest(state, i, p, (rests[i], abs(rates[normal]), ratio), slopes)
        elif i in state.touching:
            run.first_height.pop(i, None)
    for i in state.touching:
        # Friction with a known normal force has no impulse, but may slide now.
        if rows.normal[i] is None:
            state.resting.discard(i)
            if q.is_still(rows.tangent[i], blow.rates[rows.tangent[i]]):
                state.resting.add(i)
    run.impacts.append((state.t, impulses, work))


def _blow(
    run: Any,
    state: Any,
    p: Any,
    problem: ComplementarityProblem,
    rates: np.ndarray,
    hit: set[int],
    closing: set[int],
) -> tuple[Blow, dict[int, float]]:
    """Return an impact, and the speeds of rebounds that are left out of it, as they are low."""
    hypothesis, e, speed = run.kept.hypothesis, p.restitution, p.moving()
    every, free = frozenset(hit), np.zeros(len(e))
    flying = problem
    problem = replace(problem, hold=p.mu, pressed=free, resting=every, touching=every)
    by_phases = hypothesis == "poisson"
    rests: dict[int, float] = {}
    left = e.copy()
    while True:
        if by_phases:
            blow = poisson(problem, speed, left)
        else:
            blow = newton(problem, speed, left, closing, state.touching)
        low: dict[int, float] = {}
        for i in sorted((hit if by_phases else closing) - rests.keys()):
            normal = run.rows.normal[i]
            leaves = e[i] * abs(p.speed[normal])
            if by_phases:  # friction, and other contacts, change it
                hits = blow is not None and blow.modes[i] != OPEN
                leaves = max(float(blow.rates[normal]), 0.0) if blow and hits else np.inf
            if e[i] > 0.0 and run.is_low(i, leaves, rates[normal], p, state.x):
                low[i] = leaves
        if not low:
            break
        rests |= low
        left[list(rests)] = 0.0
        # What stays closed changes the accelerations of others, whose rebounds may be low too.
        rates = solved(flying, [CLOSED if i in rests else m for i, m in enumerate(run.modes)]).rates
    if blow is None:
        raise run.fail(state.t, state.x, contradiction(hypothesis, left))
    return blow, rests


def _carried(
    run: Any, state: Any, p: Any, blow: Blow, e: np.ndarray, closing: set[int]
) -> dict[str, np.ndarray]:
    """Apply the derivatives of an impact; return those of the rows before it."""
    normals = run.rows.normal
    newtons = run.kept.hypothesis == "newton"
    kept = {i: float(e[i]) for i in closing if newtons and p.speed[normals[i]] < 0.0}
    still = frozenset(state.touching if newtons else ())
    values = run.values(state.t, state.x)
    slopes: dict[str, np.ndarray] = run.carried.impact(values, p, blow, kept, still)
    if run.segments:
        run.check_instant(state, p, slopes["gap"], closing)
    return slopes


def _parted(run: Any, state: Any, i: int, p: Any, q: Any, blow: Blow, kept: float) -> None:
    """Note whether a contact that was hit leaves, stays closed or rests, by its rows.

    The numbers are `p` before and `q` after; by Newton's hypothesis it gives back the part `kept`
    of its speed.
    """
    normal, rows, mode = run.rows.normal[i], run.rows.tangent[i], blow.modes[i]
    by_phases = run.kept.hypothesis == "poisson"
    leaves = blow.rates[normal] if by_phases or mode == OPEN else -kept * p.speed[normal]
    slow = max(SLACK * abs(p.speed[normal]), WITHIN * np.finfo(float).eps * q.slow[normal])
    state.resting.discard(i)
    if leaves > slow and leaves > 0.0:
        state.touching.discard(i)
        state.rising.add(i)
        return
    state.touching.add(i)
    state.rising.discard(i)
    if rows and (mode == STICKS or q.is_still(rows, blow.rates[rows])):
        state.resting.add(i)
