"""The table of motions that cross the surfaces of events, for every implementation of the search.

A particle with h'' = a − k h: a free fall, which methods of high order pass in one step, or an
oscillation. One model has an event of each kind; the surfaces of those that a case does not name
are far away. What each case expects is the closed form of the motion.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from math import acos, pi, sqrt
from typing import NamedTuple

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.solvers import Event
from pydy.system import System

h, v = me.dynamicsymbols("h v")
a, k = sm.symbols("a k")
unit = sm.Symbol("unit")  # of length, in metres
GRAVITY, LIFT = 9.81, 0.01
FAR = 1e3

# What crosses the level of the kind, in which direction, and what happens.
KINDS: dict[str, tuple[sm.Expr, int, dict]] = {
    "passes": (h, 0, {}),
    "rises": (h, 1, {}),
    "falls": (h, -1, {}),
    "turns": (v, 0, {}),
    "keeps": (v, 0, {"reset": {v: v}}),
    "lifts": (h, 0, {"reset": {h: h + LIFT * unit, v: -unit}}),
    "bounces": (h, -1, {"reset": {v: -sm.Rational(4, 5) * v}}),
    "rebounds": (h, 0, {"reset": {v: -sm.Rational(4, 5) * v}}),
    "slows": (me.dynamicsymbols._t * unit, 1, {"reset": {v: v / 2}}),
    "kicks": (h, -1, {"reset": {v: unit / 2}}),
    "halts": (v, 1, {"terminal": True}),
    "pushes": (me.dynamicsymbols._t * unit, 1, {"reset": {v: 3 * unit}}),
    "ends": (h, 1, {"terminal": True}),
    "lands": (h, -1, {"terminal": True}),
}
LEVELS = {kind: sm.Symbol(f"level_{kind}") for kind in KINDS}


class Case(NamedTuple):
    """A motion from h, v to a last time, the levels of its events, and what must happen."""

    name: str
    h0: float
    v0: float
    a: float
    k: float
    end: float
    levels: dict[str, float]
    expected: list[tuple[str, float]]
    final: tuple[float, float]  # h and v at the last time, or where the motion ended
    within: float = 1e-9  # s; a crossing near a turning point is known less well

    @property
    def acts(self) -> bool:
        """Whether an event changes the state or ends the motion."""
        return any(KINDS[kind][2] for kind, _ in self.expected)

    @property
    def ends(self) -> bool:
        """Whether a terminal event ends the motion."""
        return any(KINDS[kind][2].get("terminal") for kind, _ in self.expected)


def fall(h0: float, v0: float, duration: float) -> tuple[float, float]:
    """Return h and v after some time of free fall."""
    return h0 + v0 * duration - GRAVITY * duration**2 / 2, v0 - GRAVITY * duration


def falls_for(height: float, speed: float = 0.0) -> float:
    """Return how long a free fall from a height takes, with a speed downwards at first."""
    return 2 * height / (speed + sqrt(speed**2 + 2 * GRAVITY * height))


def passed_apex(name: str, share: float, within: float, turns: str = "turns") -> Case:
    """Throw a ball upwards at 3 m/s: it passes a level at a share of its apex twice."""
    apex, top = 3.0**2 / (2 * GRAVITY), 3.0 / GRAVITY
    half = falls_for((1 - share) * apex)
    expected = [("passes", top - half), (turns, top), ("passes", top + half)]
    levels = {"passes": share * apex, turns: 0.0}
    return Case(name, 0.0, 3.0, -GRAVITY, 0.0, 0.55, levels, expected, fall(0, 3.0, 0.55), within)


def one_direction(kind: str, sign: int) -> Case:
    """Throw a ball through a level that counts in one direction."""
    level = 0.4
    time = (3.0 - sign * sqrt(9.0 - 2 * GRAVITY * level)) / GRAVITY
    return Case(
        f"only {kind}", 0.0, 3.0, -GRAVITY, 0.0, 0.6, {kind: level}, [(kind, time)],
        fall(0, 3.0, 0.6),
    )  # fmt: skip


def kicked_before_it_turns() -> Case:
    """Kick an oscillation just before its lowest point, for which it would stay 3 ms below."""
    level = -1.0 + 1e-6
    time, end = 1.5 * pi - acos(-level), 6.0
    c, s = np.cos(end - time), np.sin(end - time)
    # The speed is zero at π/2 too, but falls there.
    levels = {"kicks": level, "turns": 0.0, "halts": 0.0}
    return Case(
        "is kicked before it turns", 0.0, 1.0, 0.0, 1.0, end, levels,
        [("turns", pi / 2), ("kicks", time)],
        (level * c + 0.5 * s, -level * s + 0.5 * c), 1e-6,
    )  # fmt: skip


def ends_before_it_is_pushed(share: float) -> Case:
    """End an oscillation just before its highest point; a push around that point comes too late."""
    depth = 1e-4
    half = acos(1 - depth)
    time = pi / 2 - half
    levels = {"pushes": pi / 2 + share * half, "ends": 1 - depth}
    return Case(
        f"ends before a push at {share:+}", 0.0, 1.0, 0.0, 1.0, 3.0, levels, [("ends", time)],
        (1 - depth, np.cos(time)), 1e-5,
    )  # fmt: skip


def lifted() -> Case:
    """Lift a ball that reaches the ground, with a speed downwards of 1 m/s."""
    first, again, end = falls_for(1.0), falls_for(LIFT, 1.0), 0.5
    times = np.arange(first, end, again)
    return Case(
        "is lifted before its own surface", 1.0, 0.0, -GRAVITY, 0.0, end, {"lifts": 0.0},
        [("lifts", time) for time in times], fall(LIFT, -1.0, end - times[-1]),
    )  # fmt: skip


def bounced() -> Case:
    """Bounce a ball with a restitution of 4/5."""
    time, speed, end = falls_for(1.0), sqrt(2 * GRAVITY), 2.0
    expected = []
    while time < end:
        expected.append(("bounces", time))
        last, speed = time, 0.8 * speed
        time += 2 * speed / GRAVITY
    return Case("bounces", 1.0, 0.0, -GRAVITY, 0.0, end, {"bounces": 0.0}, expected,
                fall(0.0, speed, end - last))  # fmt: skip


def bounced_and_slowed(kind: str, height: float) -> Case:
    """Halve the speed of a ball at the instant at which it bounces, before or after."""
    time, speed = falls_for(height), 0.4 * sqrt(2 * GRAVITY * height)
    again = time + 2 * speed / GRAVITY
    end = again + 0.1
    return Case(
        f"{kind} from {height} m and is slowed at once", height, 0.0, -GRAVITY, 0.0, end,
        {kind: 0.0, "slows": time}, [(kind, time), ("slows", time), (kind, again)],
        fall(0.0, 0.8 * speed, 0.1),
    )  # fmt: skip


def bounced_at_a_whole_second() -> Case:
    """Bounce a ball after 1 s exactly, where steps of fixed size and outputs end."""
    return Case(
        "bounces at the end of a step", 5.0, 0.0, -10.0, 0.0, 2.5, {"bounces": 0.0},
        [("bounces", 1.0)], (8.0 * 1.5 - 5.0 * 1.5**2, 8.0 - 10.0 * 1.5),
    )  # fmt: skip


CASES = [
    passed_apex("passes a level twice", 0.8, 1e-9),
    passed_apex("passes a level just below its apex", 0.9999, 1e-8),
    passed_apex("passes a level a hair below its apex", 1 - 1e-8, 1e-6),
    passed_apex("passes a level just below an apex that a reset keeps", 0.9999, 1e-8, "keeps"),
    one_direction("rises", 1),
    one_direction("falls", -1),
    Case("meets two surfaces at once", 1.0, 0.0, -GRAVITY, 0.0, 0.4, {"passes": 0.5, "falls": 0.5},
         [("passes", falls_for(0.5)), ("falls", falls_for(0.5))], fall(1.0, 0.0, 0.4)),
    Case("meets one of two that act at once", 1.0, 0.0, -GRAVITY, 0.0, 0.4,
         {"bounces": 0.5, "passes": 0.5},
         [("passes", falls_for(0.5)), ("bounces", falls_for(0.5))],
         fall(0.5, 0.8 * sqrt(GRAVITY), 0.4 - falls_for(0.5))),
    Case("misses a level above its apex", 0.0, 3.0, -GRAVITY, 0.0, 0.6,
         {"passes": 1.0000001 * 9.0 / (2 * GRAVITY)}, [], fall(0.0, 3.0, 0.6)),
    Case("lands", 1.0, 0.0, -GRAVITY, 0.0, 2.0, {"lands": 0.0}, [("lands", falls_for(1.0))],
         (0.0, -sqrt(2 * GRAVITY))),
    Case("passes another before it lands", 1.0, 0.0, -GRAVITY, 0.0, 2.0,
         {"lands": 0.0, "passes": 1e-6},
         [("passes", falls_for(1 - 1e-6)), ("lands", falls_for(1.0))],
         (0.0, -sqrt(2 * GRAVITY))),
    kicked_before_it_turns(),
    *(ends_before_it_is_pushed(share) for share in (-0.9, 0.0, 0.9)),
    lifted(),
    bounced(),
    *(
        bounced_and_slowed(kind, height)
        for kind in ("bounces", "rebounds")
        for height in (0.5, 0.785, 1.2312)
    ),
    bounced_at_a_whole_second(),
]  # fmt: skip


@cache
def definition() -> Definition:
    """Return the particle of unit mass on its spring."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    P = O.locatenew("P", h * N.y)
    return Definition(
        N, [h], [v], bodies=[me.Particle("particle", P, 1)], loads=[(P, (a - k * h) * N.y)],
        kinematic_equations=[h.diff() - v],
    )  # fmt: skip


def events(kinds: Sequence[str] = tuple(KINDS)) -> list[Event]:
    """Return an event of each kind, called by the kind."""
    return [
        Event(KINDS[kind][0] - LEVELS[kind], KINDS[kind][1], name=kind, **KINDS[kind][2])
        for kind in kinds
    ]


def numbers(case: Case, scale: float = 1.0) -> dict[sm.Symbol, float]:
    """Return the constants of a case, with lengths in units of `scale` metres."""
    levels = {LEVELS[kind]: case.levels.get(kind, FAR) * scale for kind in KINDS}
    return {a: case.a * scale, k: case.k, unit: scale, **levels}


def started(case: Case, scale: float = 1.0) -> System:
    """Return the system of a case."""
    return System(
        definition(), numbers(case, scale), constants_symbols=[a, k, unit, *LEVELS.values()],
        ode_solver="dop853", initial_conditions={h: case.h0 * scale, v: case.v0 * scale},
        times=[0.0, case.end],
    )  # fmt: skip


def check(case: Case, happened: list[tuple[str, float]], scale: float = 1.0, last=None) -> None:
    """Check the events and their times, and the last state where it is given."""
    # Events of one instant come in the order in which they are given.
    assert sorted(name for name, _ in happened) == sorted(name for name, _ in case.expected)
    for kind in case.levels:
        moments = [time for name, time in happened if name == kind]
        expected = [time for name, time in case.expected if name == kind]
        np.testing.assert_allclose(moments, expected, rtol=0, atol=case.within)
    assert [time for _, time in happened] == sorted(time for _, time in happened)
    if last is not None:
        check_end(case, last, scale)


def check_end(case: Case, last: Sequence[float], scale: float = 1.0) -> None:
    """Check the state at the last time, or where the motion ended."""
    np.testing.assert_allclose(np.asarray(last) / scale, case.final, rtol=0, atol=20 * case.within)


def for_javascript(case: Case) -> dict:
    """Return what `simulate` of an exported module takes."""
    constants = {str(symbol): value for symbol, value in numbers(case).items()}
    initial = {"h": case.h0, "v": case.v0}
    return {"times": [0.0, case.end], "initial": initial, "constants": constants}


def check_javascript(case: Case, run: dict) -> None:
    """Check what `simulate` of an exported module returns, its rows as lists."""
    happened = [(event["name"], event["time"]) for event in run["events"]]
    stopped = run["status"] == "stopped"
    assert stopped is case.ends
    check(case, happened, last=None if stopped else run["states"][-1])
