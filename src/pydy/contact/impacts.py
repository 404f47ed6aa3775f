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

import numpy as np

from pydy.contact.decide import (
    BACKWARD,
    CLOSED,
    FORWARD,
    OPEN,
    STARTING,
    STICKS,
    Problem,
    chosen,
)
from pydy.contact.tuning import SLACK

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
    """What a phase of an impact does."""

    # (rows,), impulses beside those that are given, and the velocities after them.
    forces: np.ndarray
    rates: np.ndarray
    modes: tuple[str, ...]
    given: np.ndarray  # (contacts,), e Λ_C
    leaves: Collection[int] = ()  # contacts with P = 0, which may move apart


@dataclass(frozen=True)
class Blow:
    """What an impact does."""

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
    problem: Problem, speed: np.ndarray, e: np.ndarray, closing: Collection[int],
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


def poisson(problem: Problem, speed: np.ndarray, e: np.ndarray) -> Blow | None:
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


def _options(problem: Problem) -> list[Sequence[str]]:
    return [
        OPTIONS[len(tangent)] if i in problem.touching else [OPEN]
        for i, tangent in enumerate(problem.tangent)
    ]
