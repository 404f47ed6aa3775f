"""Impacts by the hypotheses of restitution of Newton and of Poisson."""

import math

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import Contacts, Stick, Unilateral
from pydy.contact.complementarity import ComplementarityProblem
from pydy.contact.impacts import newton, poisson
from pydy.errors import ContactError
from pydy.mechanics import Definition
from zoo.touching import TIGHT, J, N, O, a, ball, e, falling_body, g, m, mu, vx, vy, x, y

LEAN = 0.6
C, S = math.cos(LEAN), math.sin(LEAN)


def hit(hypothesis, *, size=1.0, **values):
    """The speeds v_x, v_y, w of a rod after its lower end has hit the floor, and the work done.

    The rod has the mass 1 and the length 2; sizes are in units of `size`.
    """
    system, foot = falling_body([(-size, 0.0)], mu=mu, restitution=e)
    system.constants.update({J: size**2 / 3, g: 9.81 * size})
    system.times = [0.0, 1e-3]
    system.initial_conditions = {
        a: LEAN, x: C * size, y: S * size, vx: values["vx"] * size, vy: -size
    }  # fmt: skip
    contacts = Contacts(system, foot, {mu: values["mu"], e: values["e"]}, hypothesis=hypothesis)
    motion = contacts.simulate(atol=1e-6 * np.tile([size, size, 1.0], 2))
    return motion.events[0].after[3:] / [size, size, 1.0], motion.contact_work[-1] / size**2


def after(start, normal, tangent):
    """The speeds of the rod after an impulse at its lower end."""
    return np.array([start + tangent, -1.0 + normal, 3.0 * (S * tangent - C * normal)])


@pytest.mark.parametrize("size", [1.0, 1e-9, 1.5e11])
def test_the_end_of_a_rod_slides_through_an_impact(size):
    # Routh: while it slides, dv_n = (A_nn − μ A_nt) dΛ_n.
    friction, ratio = 0.3, 0.5
    normal = (1 + ratio) / (1 + 3 * C**2 + friction * 3 * C * S)
    speeds, _ = hit("poisson", vx=2.0, mu=friction, e=ratio, size=size)
    assert speeds == pytest.approx(after(2.0, normal, -friction * normal), abs=1e-12)
    # It slides throughout: the ratios of Newton and of Poisson are the same.
    other, _ = hit("newton", vx=2.0, mu=friction, e=ratio, size=size)
    assert speeds == pytest.approx(other, abs=1e-12)


def test_the_end_of_a_rod_sticks_in_an_impact():
    # Routh: compression ends where both speeds of the end are zero; then dv_t = 0 holds on.
    ratio, friction = 0.5, 2.0
    square = np.array([[1 + 3 * C**2, -3 * C * S], [-3 * C * S, 1 + 3 * S**2]])
    normal = (1 + ratio) * np.linalg.solve(square, [1.0, -0.2])[0]
    tangent = -(0.2 + square[1, 0] * normal) / square[1, 1]
    assert abs(tangent) < friction * normal
    speeds, _ = hit("poisson", vx=0.2, mu=friction, e=ratio)
    assert speeds == pytest.approx(after(0.2, normal, tangent), abs=1e-12)
    assert hit("newton", vx=0.2, mu=friction, e=ratio)[0] != pytest.approx(speeds, abs=1e-2)


def test_energy_that_newtons_hypothesis_would_raise_falls_by_poissons():
    # Kane's paradox.
    given = {"vx": 0.5, "mu": 0.3, "e": 0.9}
    with pytest.raises(ContactError, match=r"Newton's hypothesis.*hypothesis='poisson'"):
        hit("newton", **given)
    assert -0.1 < hit("poisson", **given)[1] < -0.05


def test_an_arm_that_wedges_stays_by_poissons_hypothesis():
    """An arm swings down to a floor at the angle φ from the vertical, where tan φ < μ.

    With Newton's hypothesis it would move on, but the moment of friction is larger than that of the
    normal impulse; by Poisson's, friction holds it in both phases.
    """
    angle, rate = me.dynamicsymbols("phi, omega")
    end = O.locatenew("end", sm.sin(angle) * N.x - sm.cos(angle) * N.y)
    end.set_vel(N, rate * (sm.cos(angle) * N.x + sm.sin(angle) * N.y))
    arm = Definition(
        N, [angle], [rate],
        bodies=[me.Particle("end", end, m)], loads=[(end, -m * g * N.y)],
    )  # fmt: skip
    system = System(
        arm, {g: 9.81, m: 2.0}, ode_solver="dop853", times=np.linspace(0.0, 1.0, 11),
        initial_conditions={angle: 0.5, rate: -1.0},
    )  # fmt: skip
    floor = Unilateral(math.cos(0.2) - sm.cos(angle), restitution=e, name="floor")
    rough = Stick(end, on=floor, mu=mu, along=N.x)
    with pytest.raises(ContactError, match=r"friction would hold.*hypothesis='poisson'"):
        Contacts(system, [rough], {mu: 0.3, e: 0.5}).simulate()
    for hypothesis, ratio in (("newton", 0.0), ("poisson", 0.5)):
        contacts = Contacts(system, [rough], {mu: 0.3, e: ratio}, hypothesis=hypothesis)
        motion = contacts.simulate(**TIGHT)
        assert motion.states[-1] == pytest.approx([0.2, 0.0], abs=1e-12)
        assert motion.modes[-1][2] == {"floor": "sticks"}
        speed = math.sqrt(1.0 + 2 * 9.81 * (math.cos(0.2) - math.cos(0.5)))
        assert motion.contact_work[-1] == pytest.approx(-(speed**2), abs=1e-10)
    # A smoother floor lets it rebound.
    motion = Contacts(system, [rough], {mu: 0.1, e: 0.5}).simulate(**TIGHT)
    assert motion.events[0].after[1] == pytest.approx(0.5 * speed, abs=1e-10)


def test_a_central_impact_is_the_same_by_both():
    for hypothesis in ("newton", "poisson"):
        system, floor = ball(restitution=0.8)
        system.initial_conditions, system.times = {y: 1.0}, np.linspace(0.0, 5.0, 6)
        motion = Contacts(system, [floor], hypothesis=hypothesis).simulate(rtol=1e-11, atol=1e-13)
        *bounces, rests = motion.events
        assert rests.name == "floor rests"
        assert rests.time == pytest.approx(math.sqrt(2 / 9.81) * 9.0, abs=1e-10)
        assert bounces[0].after[1] == pytest.approx(0.8 * math.sqrt(2 * 9.81), abs=1e-10)
        assert motion.modes[-1][2] == {"floor": "closed"}


def test_a_blow_passes_through_bodies_that_touch():
    # Three equal masses in a row: the rows of their gaps are (1, −1, 0) and (0, 1, −1).
    rows = np.array([[-1.0, 1.0, 0.0], [0.0, -1.0, 1.0]])
    both = frozenset({0, 1})
    problem = ComplementarityProblem(
        np.zeros(2), rows @ rows.T, [0, 1], [[], []], *np.zeros((3, 2)), both, both
    )  # fmt: skip
    speed = rows @ [1.0, 0.0, 0.0]
    for blow in (newton(problem, speed, np.ones(2), {0}, {1}), poisson(problem, speed, np.ones(2))):
        speeds = [1.0, 0.0, 0.0] + rows.T @ blow.forces
        assert speeds == pytest.approx([-1 / 3, 2 / 3, 2 / 3])
    # Without restitution of the first contact it goes on as the others push it.
    mixed = poisson(problem, speed, np.array([0.0, 1.0]))
    assert mixed.rates.min() >= -1e-12
    assert [1.0, 0.0, 0.0] + rows.T @ mixed.forces == pytest.approx([1 / 6, 1 / 6, 2 / 3])


@pytest.mark.parametrize("hypothesis", [newton, poisson])
def test_a_blow_does_not_jam_contacts_that_it_moves_by_rounding(hypothesis):
    # The third row is that of another body: entries of 1e-18 should be zero.
    square = np.array([[0.3, -0.02, -7.6e-18], [-0.02, 0.3, -1.8e-18], [8.3e-18, -6.9e-18, 0.25]])
    every = frozenset({0, 1, 2})
    problem = ComplementarityProblem(
        np.zeros(3), square, [0, 1, 2], [[], [], []], *np.zeros((3, 3)), every, every
    )  # fmt: skip
    speed, none = np.array([0.0, 0.0, -1.4]), np.zeros(3)
    given = (problem, speed, none, {2}, {0, 1}) if hypothesis is newton else (problem, speed, none)
    assert hypothesis(*given).forces == pytest.approx([0.0, 0.0, 5.6], abs=1e-12)


def test_random_impacts_with_friction_never_raise_the_energy():
    random = np.random.default_rng(0)
    for _ in range(60):
        c = int(random.integers(1, 4))
        every = frozenset(range(c))
        rows = random.normal(size=(2 * c, random.integers(2, 6)))
        speed = rows @ random.normal(size=rows.shape[1])
        speed[::2] = np.where(speed[::2] > 0.0, 0.0, speed[::2]) if c == 1 else speed[::2]
        if (speed[::2] > 0.0).any():
            continue
        friction = random.choice([0.0, 0.3, 0.8, 2.0], size=c)
        tangent = [[2 * i + 1] for i in range(c)]
        problem = ComplementarityProblem(
            speed, rows @ rows.T, [2 * i for i in range(c)], tangent, friction, friction,
            np.zeros(c), every, every,
        )  # fmt: skip
        blow = poisson(problem, speed, np.full(c, random.uniform()))
        assert not blow.work(speed)[1]
        size = np.abs(rows).sum()
        assert blow.rates[::2].min() >= -1e-8 * size
        assert (np.abs(blow.forces[1::2]) <= friction * blow.forces[::2] + 1e-8 * size).all()


def test_feet_that_chatter_while_they_slide_come_to_rest():
    system, feet = falling_body([(-1, -0.2), (1, -0.2)], restitution=0.5, mu=mu)
    system.initial_conditions, system.times = {y: 1.0, vx: 0.5}, np.linspace(0.0, 3.0, 31)
    system.constants[J] = 0.4
    motion = Contacts(system, feet, {mu: 0.3}, hypothesis="poisson").simulate(**TIGHT)
    first = motion.events[0]
    assert first.after[4] == pytest.approx(0.5 * math.sqrt(2 * 9.81 * 0.8), abs=1e-10)
    assert motion.modes[-1][2] == {"foot0": "sticks", "foot1": "sticks"}
    total = motion.energy[:, 2]
    assert abs(total - total[0] - motion.contact_work).max() < 1e-9 * abs(total).max()


@pytest.mark.parametrize("hypothesis", ["newton", "poisson"])
@pytest.mark.parametrize(
    ("rate", "message"), [(0.2, "became -1.48 at an impact"), (-0.2, "became 2.48 at an impact")]
)
def test_a_restitution_that_leaves_its_range_on_the_way_is_named(rate, message, hypothesis):
    """It depends on the speed of the impact, √(2 g h) = 9.90 m/s from 5 m."""
    point = O.locatenew("P", x * N.x + y * N.y)
    definition = Definition(
        N, [x, y], [vx, vy], bodies=[me.Particle("ball", point, 1)],
        loads=[(point, -9.81 * N.y)], kinematic_equations=[x.diff() - vx, y.diff() - vy],
    )  # fmt: skip
    system = System(definition, ode_solver="dop853", initial_conditions={y: 5.0}, times=[0.0, 1.5])
    floor = Unilateral(y, restitution=0.5 + rate * vy, name="floor")
    with pytest.raises(ContactError, match=f"`restitution` of 'floor' {message}"):
        Contacts(system, [floor], hypothesis=hypothesis).simulate()
    kept = Unilateral(y, restitution=sm.Max(0, sm.Min(1, 0.5 + 0.02 * vy)), name="floor")
    speed = Contacts(system, [kept], hypothesis=hypothesis).simulate().events[0].after[3]
    landing = np.sqrt(2 * 9.81 * 5.0)
    assert speed == pytest.approx((0.5 - 0.02 * landing) * landing, rel=1e-6)
