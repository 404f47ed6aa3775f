"""The table of states that are projected onto constraints, for every implementation.

What each case expects is the closed form of the least correction in the norm of the mass matrix:
positions first, then velocities at the corrected positions.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System

t = me.dynamicsymbols._t
m1, m2, length, rate = sm.symbols("m1 m2 length rate")
x1, y1, x2, y2 = me.dynamicsymbols("x1 y1 x2 y2")
x, y, z = me.dynamicsymbols("x y z")


def speeds(coordinates: list[sm.Expr]) -> dict:
    """Name the rates of coordinates, for results with names."""
    names = me.dynamicsymbols([f"v_{q.name}" for q in coordinates])
    rates = [q.diff() - u for q, u in zip(coordinates, names, strict=True)]
    return {"coordinates": coordinates, "speeds": names, "kinematic_equations": rates}


class Case(NamedTuple):
    """A model, its constants, the state at t = 0 and the one that it is moved to."""

    name: str
    model: Callable[[], Definition]
    constants: dict[str, float]
    start: list[float]
    expected: list[float]


@cache
def rod(*factors: float) -> Definition:
    """Join two particles by a rod, whose length changes at a rate; a row for each factor."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    A = O.locatenew("A", x1 * N.x + y1 * N.y)
    B = O.locatenew("B", x2 * N.x + y2 * N.y)
    O.set_vel(N, 0)
    row = (x2 - x1) ** 2 + (y2 - y1) ** 2 - (length + rate * t) ** 2
    return Definition(
        N, **speeds([x1, y1, x2, y2]), bodies=[me.Particle("a", A, m1), me.Particle("b", B, m2)],
        holonomic_constraints=[factor * row for factor in factors],
    )  # fmt: skip


@cache
def line() -> Definition:
    """Keep a particle on the z axis, by three rows of which two are independent."""
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    P = O.locatenew("P", x * N.x + y * N.y + z * N.z)
    return Definition(
        N, **speeds([x, y, z]), bodies=[me.Particle("p", P, 1)],
        holonomic_constraints=[x, y, x + y],
    )  # fmt: skip


def moved_rod(name: str, *factors: float, masses=(1.0, 3.0), unit=1.0, growth=0.0) -> Case:
    """Correct a rod that is 0.02 % too long and whose ends move apart."""
    a, d = np.array([0.3, -0.2]) * unit, np.array([0.6, 0.8])
    off, apart = 2e-4 * unit, 3e-4 * unit
    across = 0.1 * unit * np.array([-0.8, 0.6])
    b = a + (unit + off) * d
    va = np.array([0.5, 0.2]) * unit
    vb = va + (apart + growth * unit) * d + across
    share_a, share_b = masses[1] / sum(masses), masses[0] / sum(masses)
    new_a, new_b = a + share_a * off * d, b - share_b * off * d
    # The rod keeps its direction, so that the direction of what is wrong is the same.
    new_va, new_vb = va + share_a * apart * d, vb - share_b * apart * d
    return Case(
        name, lambda: rod(*factors),
        {"m1": masses[0], "m2": masses[1], "length": unit, "rate": growth * unit},
        [*a, *b, *va, *vb], [*new_a, *new_b, *new_va, *new_vb],
    )  # fmt: skip


CASES = [
    moved_rod("a rod with a heavy end", 1.0),
    moved_rod("a rod with equal ends", 1.0, masses=(2.0, 2.0)),
    moved_rod("a rod with a very heavy end", 1.0, masses=(1e6, 1.0)),
    moved_rod("a rod that grows", 1.0, growth=0.7),
    moved_rod("a rod of a nanometre", 1.0, unit=1e-9),
    moved_rod("a rod between planets", 1.0, unit=1e11),
    moved_rod("a row in another unit", 1e-12),
    moved_rod("one row twice", 1.0, 1.0),
    moved_rod("one row in three units", 1.0, 1e8, 1e-8),
    Case("two independent rows of three", line, {}, [3e-4, -2e-4, 1.0, 1e-4, 2e-4, 0.5],
         [0.0, 0.0, 1.0, 0.0, 0.0, 0.5]),
    Case("a state on the constraints", line, {}, [0.0, 0.0, 1.0, 0.0, 0.0, 0.5],
         [0.0, 0.0, 1.0, 0.0, 0.0, 0.5]),
]  # fmt: skip


def started(case: Case) -> System:
    """Return the system of a case."""
    system = System(case.model(), ode_solver="dop853", times=[0.0, 1e-9])
    system.constants = case.constants
    system.initial_conditions = dict(zip(system.states, case.start, strict=True))
    return system


def check(case: Case, first: list[float]) -> None:
    """Check the state after the projection, to roundings of the largest of its kind."""
    half = len(case.start) // 2
    for part in (slice(None, half), slice(half, None)):
        size = np.abs(case.start[part]).max()
        expected = np.array(case.expected[part])
        np.testing.assert_allclose(first[part], expected, rtol=0, atol=1e-14 * size)
