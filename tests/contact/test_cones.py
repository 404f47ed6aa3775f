"""Forces of bodies on several feet: within the cones wherever they can be."""

import math
from dataclasses import replace

import numpy as np
import pytest
import sympy.physics.mechanics as me

from pydy.contact import Contacts
from pydy.contact.complementarity import (
    OPEN,
    STARTING,
    STICKS,
    ComplementarityProblem,
    FrictionCone,
    innermost,
    relaxed,
    select_modes,
)
from zoo.touching import J, falling_body, mu, slope, y

t = me.dynamicsymbols._t


def test_the_innermost_of_forces_that_are_not_determined():
    # Two feet hold 1 together with friction of any shares; the loads are 3 and 1, and μ is 0.3.
    y0 = np.array([3.0, 0.5, 1.0, 0.5])
    null = np.array([[0.0, 1.0, 0.0, -1.0]]).T / math.sqrt(2)
    cones = [FrictionCone(0, (1,), 0.3), FrictionCone(2, (3,), 0.3)]
    found = innermost(y0, null, cones, 3.0)
    # Both margins may be (0.3 · 4 − 1) / 2.
    assert 0.05 <= min(c.margin(found) for c in cones) <= 0.1 + 1e-9
    # In a plane the same, where both pull in a direction that is none of the first planes.
    turn = np.array([0.6, 0.8])
    y0 = np.concatenate([[3.0], 0.5 * turn, [1.0], 0.5 * turn])
    null = np.zeros((6, 2))
    null[1:3], null[4:] = np.eye(2), -np.eye(2)
    cones = [FrictionCone(0, (1, 2), 0.3), FrictionCone(3, (4, 5), 0.3)]
    found = innermost(y0, null, cones, 3.0)
    assert 0.05 <= min(c.margin(found) for c in cones) <= 0.1 + 1e-9


def test_a_known_impulse_beside_a_row_allows_its_friction():
    # As in the second phase of Poisson's hypothesis: of 2 that are given back and 1 more.
    for known, most in ((2.0, 1.5), (0.0, 0.5)):
        cone = FrictionCone(0, (1, 2), 0.5, known)
        assert cone.margin(np.array([1.0, 0.9, 1.2])) == pytest.approx(min(1.0, most - 1.5))
        contact = [(0, 0, [1, 2], 0.5, 0.5, known)]
        *_, found = relaxed(np.array([-1.0, 0.72, 0.96]), np.eye(3), contact, {})
        assert found.forces[0] == 1.0
        assert np.linalg.norm(found.forces[1:]) == pytest.approx(min(1.2, most))
        assert bool(found.sliding) is (most < 1.2)


def test_the_innermost_forces_count_a_known_impulse():
    # The friction of two feet is shared: what one is given beside its row, it may hold.
    y0, null = np.array([1.0, 0.9, 1.0, 0.9]), np.array([[0.0, 1.0, 0.0, -1.0]]).T / math.sqrt(2)
    cones = [FrictionCone(0, (1,), 0.5, 3.0), FrictionCone(2, (3,), 0.5)]
    found = innermost(y0, null, cones, 1.0)
    assert found[1] + found[3] == pytest.approx(1.8)
    assert min(c.margin(found) for c in cones) >= 0.175 - 1e-9  # of (0.5 · 5 − 1.8) / 2 = 0.35


def impact(random, feet=3):
    """A rigid body that falls on its feet, as rows of velocities; with J M⁻¹ Jᵀ."""
    angles = np.sort(random.uniform(0, 2 * math.pi, feet))
    places = np.stack([np.cos(angles), np.sin(angles), np.full(feet, -random.uniform(0.1, 1))], 1)
    rows = []
    for place in places:
        axes = np.eye(3)[[2, 0, 1]]
        rows += [np.concatenate([axis, np.cross(place, axis)]) for axis in axes]
    rows = np.array(rows)
    inverse = np.diag(1 / np.concatenate([np.ones(3), random.uniform(0.1, 1.0, 3)]))
    speeds = random.normal(size=6)
    speeds[2] -= 2.0
    start = rows @ speeds
    friction = np.full(feet, random.choice([0.1, 0.4, 1.0]))
    every = frozenset(range(feet))
    return ComplementarityProblem(
        start, rows @ inverse @ rows.T, [3 * k for k in range(feet)],
        [[3 * k + 1, 3 * k + 2] for k in range(feet)], friction, friction, np.zeros(feet),
        every, every,
    )  # fmt: skip


def test_impacts_with_known_impulses_satisfy_coulombs_law():
    random, solved = np.random.default_rng(7), 0
    for _ in range(8):
        problem = replace(impact(random), pressed=np.array([0.6, 0.0, 0.3]))
        found = select_modes(
            problem, [[STICKS, STARTING], [STICKS, STARTING, OPEN], [STICKS, STARTING]]
        )
        if found is None:  # those that must not open may have to
            continue
        solved += 1
        p = found.forces.reshape(3, 3)
        limit = problem.mu * (problem.pressed + p[:, 0]) - np.linalg.norm(p[:, 1:], axis=1)
        assert p[:, 0].min() > -1e-9
        assert limit.min() > -1e-7 * (abs(p).max() + 1.0)
    assert solved >= 4


def _margin(forces, given, mu):
    """The least distance of impulses (4 · 3) to their cones, with normal ones given before."""
    p = forces.reshape(-1, 3)
    return min(p[:, 0].min(), (mu * (given + p[:, 0]) - np.hypot(*p[:, 1:].T)).min())


def test_cones_of_redundant_feet_include_the_impulse_of_the_first_phase():
    random, moved = np.random.default_rng(11), 0
    for _ in range(20):
        problem, mu = impact(random, 4), 0.5
        given = random.uniform(0.5, 1.5, 4)
        normal, angle = random.uniform(0.0, 0.5, 4), random.uniform(0.0, 2 * math.pi, 4)
        # Within the cones of the whole impulse, of which this phase's is the smaller part.
        size = 0.8 * mu * (given + normal)
        known = np.stack([normal, size * np.cos(angle), size * np.sin(angle)], axis=1).ravel()
        friction = np.full(4, mu)
        problem = replace(
            problem, free=-problem.delassus @ known, mu=friction, hold=friction, pressed=given
        )

        least = np.linalg.lstsq(problem.delassus, -problem.free, rcond=1e-9)[0]
        moved += _margin(least, given, mu) < 0.0  # then forces of the null space have to be added
        found = select_modes(problem, [[STICKS]] * 4)
        assert found is not None
        assert _margin(found.forces, given, mu) > -1e-9
        np.testing.assert_allclose(problem.delassus @ found.forces, -problem.free, atol=1e-9)
    assert moved >= 3


@pytest.mark.parametrize("feet", [3, 4])
def test_impacts_of_bodies_on_several_feet_satisfy_coulombs_law(feet):
    random = np.random.default_rng(feet)
    for _ in range(12):
        problem = impact(random, feet)
        found = select_modes(problem, [[STICKS, STARTING, OPEN]] * feet)
        assert found is not None
        p = found.forces.reshape(feet, 3)
        after = (problem.free + problem.delassus @ found.forces).reshape(feet, 3)
        size = abs(p).max() + 1.0
        assert p[:, 0].min() > -1e-9 * size
        assert after[:, 0].min() > -1e-9
        assert abs(p[:, 0] * after[:, 0]).max() < 1e-9 * size
        limit = problem.mu * p[:, 0] - np.linalg.norm(p[:, 1:], axis=1)
        assert limit.min() > -1e-7 * size
        slip = np.linalg.norm(after[:, 1:], axis=1)
        assert abs(limit * slip).max() < 1e-7 * size
        assert abs((p[:, 1:] * after[:, 1:]).sum(1) + problem.mu * p[:, 0] * slip).max() < 1e-7


@pytest.mark.parametrize("part", [0.9999, 1.0001])
def test_a_body_on_two_feet_holds_on_a_slope_up_to_the_angle_of_friction(part):
    # The foot that is further up presses less: friction in equal parts would slip too early.
    system, feet = falling_body([(-1, -0.5), (1, -0.5)], tilt=slope, mu=mu)
    angle = part * math.atan(0.4)
    system.constants.update({J: 0.3, slope: angle})
    system.initial_conditions, system.times = {y: 0.5}, np.linspace(0.0, 2.0, 5)
    motion = Contacts(system, feet, {mu: 0.4}).simulate(rtol=1e-11, atol=1e-12)
    rate = min(0.0, -9.81 * (math.sin(angle) - 0.4 * math.cos(angle)))
    assert motion["x"] == pytest.approx(rate * motion.times**2 / 2, abs=1e-10)
    for name in ("foot0", "foot1"):
        assert (abs(motion[f"{name}_friction"]) <= 0.4 * motion[f"{name}_normal"] + 1e-9).all()


def test_a_body_on_two_feet_slips_when_the_slope_is_steep_enough():
    system, feet = falling_body([(-1, -0.5), (1, -0.5)], tilt=slope * t, mu=mu)
    system.constants.update({J: 0.3, slope: 0.1})
    system.initial_conditions, system.times = {y: 0.5}, np.linspace(0.0, 5.0, 6)
    motion = Contacts(system, feet, {mu: 0.4}).simulate(rtol=1e-11, atol=1e-12)
    assert {"foot0 slips", "foot1 slips"} <= {event.name for event in motion.events}
    times = np.array([event.time for event in motion.events])
    assert times == pytest.approx(10 * math.atan(0.4), rel=1e-7)
    assert motion["x"][-1] < -1e-3
    assert set(motion.modes[-1][2].values()) == {"slides -"}
