"""The table of motions that start on an event's surface, for every implementation of the rule.

A ball with h'' = a + b t starts at a level of the height h: the surface of an event with a
direction and one of these actions: 'bounce' v ← −v/2, 'stop' v ← 0, 'count' n ← n + 1, 'end'
terminal, 'none'.
One model has all events; the levels of those that a case does not want are far away.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.solvers import Event
from pydy.system import System

h, v, n = me.dynamicsymbols("h v n")
a, b = sm.symbols("a b")
TIMES = [0.0, 0.05, 0.1]

ACTIONS = {
    "bounce": {"reset": {v: -v / 2}},
    "stop": {"reset": {v: 0}},
    "count": {"reset": {n: n + 1}},
    "end": {"terminal": True},
    "none": {},
}


class Case(NamedTuple):
    """A start, and what follows at the first time and afterwards."""

    name: str
    v0: float
    a: float
    b: float
    direction: int
    action: str
    recorded: bool  # whether the event happens at the start
    acts: bool
    goes_on: bool  # whether the motion reaches the last time
    side: int = 0  # the sign of h there


CASES = [
    Case("falls through a floor", -1.0, -9.81, 0, -1, "bounce", True, True, True, 1),
    Case("leaves a floor", 1.0, -9.81, 0, -1, "bounce", False, False, True, 1),
    Case("rises through a ceiling", 1.0, 0, 0, 1, "bounce", True, True, True, -1),
    Case("rests on a floor", 0.0, -9.81, 0, -1, "bounce", True, True, False),
    Case("rests on a floor that stops it", 0.0, -9.81, 0, -1, "stop", True, True, False),
    Case("rests under a ceiling", 0.0, 9.81, 0, 1, "bounce", True, True, False),
    Case("is lifted from a floor", 0.0, 9.81, 0, -1, "bounce", False, False, True, 1),
    Case("is pressed ever harder", 0.0, 0, -1.0, -1, "bounce", True, True, False),
    Case("is lifted ever harder", 0.0, 0, 1.0, -1, "bounce", False, False, True, 1),
    Case("rests without a load", 0.0, 0, 0, -1, "bounce", False, False, True, 0),
    Case("falls past a counter", 0.0, -9.81, 0, -1, "count", True, True, True, -1),
    Case("moves past a counter", -1.0, -9.81, 0, -1, "count", True, True, True, -1),
    Case("ends where it begins", -1.0, 0, 0, -1, "end", True, True, False),
    Case("ends where it rests", 0.0, -9.81, 0, -1, "end", True, True, False),
    Case("does not end", 1.0, 0, 0, -1, "end", False, False, True, 1),
    Case("is only noted", -1.0, 0, 0, -1, "none", True, False, True, -1),
    Case("is only noted at rest", 0.0, -9.81, 0, -1, "none", True, False, True, -1),
    Case("rests without a direction", 0.0, -9.81, 0, 0, "bounce", True, True, False),
    Case("leaves without direction and returns", 0.3, -9.81, 0, 0, "bounce", True, False, True, 1),
    Case("goes the other way", 1.0, 0, 0, -1, "count", False, False, True, 1),
]  # fmt: skip


KINDS = [*dict.fromkeys((case.direction, case.action) for case in CASES)]
LEVELS = sm.symbols(f"level:{len(KINDS)}")
FAR = 1e3


@cache
def definition() -> Definition:
    """Return the ball of unit mass, and the counter n."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    P = O.locatenew("P", h * N.y)
    force = (a + b * me.dynamicsymbols._t) * N.y
    return Definition(
        N, [h, n], [v], bodies=[me.Particle("ball", P, 1)], loads=[(P, force)],
        kinematic_equations=[h.diff() - v, n.diff()],
    )  # fmt: skip


@cache
def events() -> list[Event]:
    """Return an event of each kind, which is called by its level."""
    return [
        Event(h - level, direction, name=level.name, **ACTIONS[action])
        for level, (direction, action) in zip(LEVELS, KINDS, strict=True)
    ]


def numbers(case: Case, scale: float = 1.0, offset: float = 0.0) -> dict[sm.Symbol, float]:
    """Return the constants of a case, with lengths in other units."""
    levels = dict.fromkeys(LEVELS, FAR * scale)
    levels[LEVELS[KINDS.index((case.direction, case.action))]] = offset
    return {a: case.a * scale, b: case.b * scale, **levels}


def started(case: Case, scale: float = 1.0, offset: float = 0.0) -> System:
    """Return the system of a case."""
    return System(
        definition(), numbers(case, scale, offset), constants_symbols=[a, b, *LEVELS],
        ode_solver="dop853", initial_conditions={h: offset, v: case.v0 * scale}, times=TIMES,
    )  # fmt: skip


def check(case: Case, times: list[float], heights: list[float], ended: bool) -> None:
    """Check when the events were, the heights above the level at `TIMES`, and whether it ended."""
    assert times.count(0.0) == case.recorded
    assert ended is not case.goes_on
    if case.goes_on:
        height = heights[-1]
        assert (height > 0.0) - (height < 0.0) == case.side
