"""Exact contacts against an independent time-stepping, and what holds in any motion."""

import itertools

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import Contacts, Stick, Unilateral
from pydy.mechanics import Definition
from zoo.touching import TIGHT, J, N, O, a, e, falling_body, g, m, mu, slope, vx, vy, w, x, y


def moreau(inertia, feet, friction, tilt, q, u, end, h):
    """Moreau's midpoint rule for a body of mass 1 that does not rebound.

    Each step solves for the impulses by Gauss and Seidel's iteration, projecting on the cone.
    """
    q, u, inverse = np.array(q), np.array(u), np.array([1.0, 1.0, 1.0 / inertia])
    pull = -9.81 * np.array([np.sin(tilt), np.cos(tilt), 0.0])
    for _ in range(round(end / h)):
        middle = q + h / 2 * u
        c, s = np.cos(middle[2]), np.sin(middle[2])
        arms = [(c * px - s * py, s * px + c * py) for px, py in feet]
        rows = [
            (np.array([0, 1, rx]), np.array([1, 0, -ry]))
            for rx, ry in arms
            if middle[1] + ry <= 0.0
        ]
        u = u + h * pull
        impulses = np.zeros((len(rows), 2))
        for _ in range(100):
            before = impulses.copy()
            for (normal, tangent), own in zip(rows, impulses, strict=True):
                new = max(0.0, own[0] - normal @ u / (normal @ (inverse * normal)))
                u = u + inverse * normal * (new - own[0])
                own[0] = new
                limit = friction * new
                new = own[1] - tangent @ u / (tangent @ (inverse * tangent))
                new = min(max(new, -limit), limit)
                u = u + inverse * tangent * (new - own[1])
                own[1] = new
            if not rows or abs(impulses - before).max() < 1e-12:
                break
        q = middle + h / 2 * u
    return q


@pytest.mark.parametrize(
    ("tilt", "angle", "speed", "friction"), [(0.0, 0.4, 1.0, 0.5), (0.3, 0.2, 0.0, 0.2)]
)
def test_modes_agree_with_moreaus_time_stepping(tilt, angle, speed, friction):
    feet = [(-1.0, -0.2), (1.0, -0.2)]
    system, contacts = falling_body(feet, tilt=slope, mu=mu)
    system.constants.update({J: 0.4, slope: tilt})
    system.initial_conditions = {y: 1.0, a: angle, vx: speed}
    system.times = [0.0, 1.2]
    exact = Contacts(system, contacts, {mu: friction}).simulate(rtol=1e-9, atol=1e-10)
    assert len(exact.modes) >= 3
    stepped = moreau(0.4, feet, friction, tilt, [0.0, 1.0, angle], [speed, 0.0, 0.0], 1.2, 2e-3)
    # An impact is seen up to a step late, at some metres per second.
    assert exact.states[-1, :3] == pytest.approx(stepped, abs=6e-3)


def test_complementarity_holds_and_energy_falls_in_random_motions():
    random = np.random.default_rng(3)
    height = sm.Symbol("height")
    system, contacts = falling_body([(-1, -height), (1, -height)], tilt=slope, mu=mu, restitution=e)
    contacts = Contacts(system, contacts)
    system.times = np.linspace(0.0, 1.5, 31)
    for _ in range(4):
        friction = random.choice([0.0, 0.3, 0.8])
        system.constants.update(
            {height: random.uniform(0.1, 0.5), J: random.uniform(0.1, 1.0), mu: friction,
             e: random.choice([0.0, 0.3]), slope: random.choice([0.0, 0.3])}
        )  # fmt: skip
        system.initial_conditions = {
            y: 1.5, a: random.uniform(-1, 1), w: random.uniform(-2, 2), vx: random.uniform(-2, 2)
        }  # fmt: skip
        motion = contacts.simulate(rtol=1e-10, atol=1e-11)
        gaps, normals, rubs = (
            motion[[f"foot0_{what}", f"foot1_{what}"]] for what in ("gap", "normal", "friction")
        )
        assert gaps.min() > -1e-10
        assert normals.min() >= -1e-10
        assert abs(gaps * normals).max() < 1e-10
        assert (abs(rubs) - friction * normals).max() < 1e-10
        total = motion.energy[:, 2]
        assert np.diff(total).max() < 1e-8
        assert abs(total - total[0] - motion.contact_work).max() < 1e-8


def test_each_combination_of_modes_and_each_state_is_made_once(monkeypatch):
    from pydy._motion import events_and_constraints as solving
    from pydy.contact.rows import ContactRows

    programs, rates, states = [], solving.event_rates_program, []
    numbers = ContactRows.numbers

    def counted(*args, **options):
        programs.append(args[1])
        return rates(*args, **options)

    def noted(self, t, *at):
        states.append((t, *(tuple(values) for values in at)))
        return numbers(self, t, *at)

    monkeypatch.setattr(solving, "event_rates_program", counted)
    monkeypatch.setattr(ContactRows, "numbers", noted)
    system, contacts = falling_body([(-1, -0.2), (1, -0.2)], mu=0.3, restitution=0.3)
    system.constants[J] = 0.4
    system.initial_conditions, system.times = {y: 1.0, a: 0.4, vx: 1.0}, [0.0, 1.2]
    contacts = Contacts(system, contacts)
    motion = contacts.simulate(rtol=1e-8, atol=1e-9)
    # A gap on the way up is told by a number: it needs no events of its own.
    # Impacts divide a motion in one combination of modes into several flights.
    assert len(programs) == len(contacts.compiled_modes) < len(motion.modes) + len(motion.impacts)
    assert all(one != other for one, other in itertools.pairwise(states))


def test_a_table_on_four_feet_has_the_least_forces_and_turns_on_its_edges():
    z, vz, roll, pitch, w1, w2 = me.dynamicsymbols("z v_z roll pitch w1 w2")
    B = me.ReferenceFrame("B")
    B.orient_body_fixed(N, (roll, pitch, 0), "XYZ")
    C = O.locatenew("C", x * N.x + z * N.z)
    C.set_vel(N, vx * N.x + vz * N.z)
    B.set_ang_vel(N, w1 * N.x + w2 * (sm.cos(roll) * N.y + sm.sin(roll) * N.z))
    table = me.RigidBody("table", C, B, m, (me.inertia(B, J, J, J), C))
    feet = [
        C.locatenew(f"F{j}", sx * B.x + sy * B.y - 0.5 * B.z)
        for j, (sx, sy) in enumerate([(1, 1), (1, -1), (-1, 1), (-1, -1)])
    ]
    contacts = []
    for foot in feet:
        foot.v2pt_theory(C, N, B)
        gap = Unilateral(foot.pos_from(O).dot(N.z), name=foot.name, restitution=e)
        contacts.append(Stick(foot, on=gap, mu=0.3, along=N.x))
    system = System(
        Definition(
            N, [x, z, roll, pitch], [vx, vz, w1, w2], bodies=[table], loads=[(C, -m * g * N.z)]
        ),
        {g: 9.81, J: 0.5}, {}, "dop853", {z: 1.0, vx: 1.0}, np.linspace(0.0, 1.0, 11),
    )  # fmt: skip
    contacts = Contacts(system, contacts, {e: 0.0})
    flat = contacts.simulate(rtol=1e-9, atol=1e-10)
    names = [f"{foot.name}_normal" for foot in feet]
    assert flat[names][-1] == pytest.approx(np.full(4, 9.81 / 4))
    assert {event.time for event in flat.events[:4]} == {flat.events[0].time}
    # An impact of one foot turns round another one that was on its way up.
    system.constants[e] = 0.3
    system.initial_conditions = {z: 1.2, vx: 1.0, roll: 0.1, pitch: 0.2}
    system.times = np.linspace(0.0, 0.5, 6)
    tilted = contacts.simulate(rtol=1e-9, atol=1e-10)
    assert tilted[[f"{foot.name}_gap" for foot in feet]].min() > -1e-10
    assert vy not in tilted


@pytest.mark.parametrize("later", [1e-13, 1e-9, 1e-5])
def test_blocks_that_slip_at_nearly_one_instant_have_times_of_their_own(later):
    t = me.dynamicsymbols._t
    xs, vs = me.dynamicsymbols("x:2"), me.dynamicsymbols("v:2")
    pulls = (4.0, 4.0 / (1.0 + later))
    bodies, loads, brakes = [], [], []
    for k in range(2):
        P = O.locatenew(f"P{k}", xs[k] * N.x)
        P.set_vel(N, vs[k] * N.x)
        bodies.append(me.Particle(f"block{k}", P, m))
        loads.append((P, pulls[k] * t * N.x))
        brakes.append(Stick(vs[k], mu=0.3, mu_static=0.5, normal=10.0, name=f"brake{k}"))
    system = System(
        Definition(N, xs, vs, bodies=bodies, loads=loads), ode_solver="dop853", times=[0.0, 2.0]
    )
    motion = Contacts(system, brakes).simulate(**TIGHT)
    for k, pull in enumerate(pulls):
        start = 0.5 * 10.0 / pull
        (slip,) = [event.time for event in motion.events if event.name == f"brake{k} slips"]
        assert slip == pytest.approx(start, rel=1e-12)
        speed = pull * (4.0 - start**2) / 2.0 - 0.3 * 10.0 * (2.0 - start)
        assert motion[f"v{k}"][-1] == pytest.approx(speed, rel=1e-12)
