"""Rigid wheels that roll without slip: closed forms of the rolling disc, and conservation."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from oracles.rolling_disc import disc_motion
from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles import LinearTire, WheelContact
from zoo.wheels import free_wheel, planar_wheel

M, R, G = 10.0, 0.3, 9.81
TIGHT = {"rtol": 1e-12, "atol": 1e-12}


def rolling(crown=0.0, axial=M * R**2 / 2, diametral=M * R**2 / 4, method="definition", **options):
    """A free wheel with yaw, lean and spin, on the plane, and the outputs of its contact."""
    w = free_wheel(M, axial, diametral)
    contact = WheelContact(w.body, w.B.y, R, w.O, w.N.z, w.N, crown_radius=crown)
    x, y, z, yaw, lean, spin = w.names
    loads = [(w.G, -M * G * w.N.z), *contact.loads()]
    if method == "kane":
        kane = me.KanesMethod(
            w.N,
            [x, y, yaw, lean, spin],
            w.rates[3:],
            kd_eqs=w.kinematics,
            q_dependent=[z],
            u_dependent=w.rates[:3],
            configuration_constraints=contact.holonomic_constraints,
            velocity_constraints=[contact.rate, *contact.nonholonomic_constraints],
        )
        kane.kanes_equations([w.body], loads)
        return System(kane, **options), contact
    definition = Definition(
        w.N,
        w.names,
        w.rates,
        bodies=[w.body],
        loads=loads,
        kinematic_equations=w.kinematics,
        holonomic_constraints=contact.holonomic_constraints,
        nonholonomic_constraints=contact.nonholonomic_constraints,
    )
    return System(definition, ode_solver="dop853", **options), contact


def steady_turn(lean, rate):
    """Return the rate about the axle of a thin disc that leans and turns, and its motion.

    The moment of momentum about the lowest point turns with the disc:
    (C + m r²) Ω p cos γ = A Ω² sin γ cos γ − m g r sin γ.
    """
    s, c = np.sin(lean), np.cos(lean)
    p = (M * R**2 / 4 * rate**2 * s * c - M * G * R * s) / (1.5 * M * R**2 * rate * c)
    speed = p * R
    return p, {
        "z": R * c, "lean": lean, "vx": speed, "vy": 0.0, "vz": 0.0,
        "w1": 0.0, "w2": p, "w3": rate * c,
    }  # fmt: skip


@pytest.mark.parametrize("method", ["definition", "kane"])
@pytest.mark.parametrize(("lean", "rate"), [(-0.2, 1.5), (0.6, -2.0), (1.1, 7.0)])
def test_a_disc_in_a_steady_turn_stays_in_it(lean, rate, method):
    p, start = steady_turn(lean, rate)
    system, _ = rolling(method=method)
    system.initial_conditions = {me.dynamicsymbols(k): v for k, v in start.items()}
    speed = p * R
    derivatives = dict(zip(system.states, system.evaluate_ode(), strict=True))
    expected = dict.fromkeys(me.dynamicsymbols("lean z w1 w2 w3 vx vz"), 0.0)
    expected[me.dynamicsymbols("yaw")] = rate
    expected[me.dynamicsymbols("vy")] = speed * rate  # the centripetal acceleration
    found = {key: derivatives[key] for key in expected}
    assert found == pytest.approx(expected, abs=1e-9)


def test_the_forces_of_a_steady_turn_are_weight_and_centripetal_force():
    p, start = steady_turn(0.6, -2.0)
    times = np.linspace(0.0, 2.0, 21)
    system, _ = rolling(initial_conditions=start, times=times)
    forces = system.constraint_forces
    system.outputs = dict(zip(("up", "forward", "left"), forces.values(), strict=True))
    motion = system.simulate(**TIGHT, constraints="project")
    radius, phase = p * R / -2.0, -2.0 * times
    np.testing.assert_allclose(motion["x"], radius * np.sin(phase), atol=1e-9)
    np.testing.assert_allclose(motion["y"], radius * (1 - np.cos(phase)), atol=1e-9)
    np.testing.assert_allclose(motion["up"], M * G, rtol=1e-9)
    np.testing.assert_allclose(motion["left"], M * p * R * -2.0, rtol=1e-9)
    np.testing.assert_allclose(motion["forward"], 0.0, atol=1e-7)


@pytest.mark.parametrize("spin", [3.0, 20.0])
def test_an_upright_disc_wobbles_at_the_frequency_of_its_linear_equations(spin):
    # A (A + m r²) λ² = m g r A − C (C + m r²) p², with the axial moment C and the other one A.
    A, C, mr2 = M * R**2 / 4, M * R**2 / 2, M * R**2
    square = (M * G * R * A - C * (C + mr2) * spin**2) / (A * (A + mr2))
    system, _ = rolling(initial_conditions={"z": R, "vx": spin * R, "w2": spin})
    eigenvalues = np.linalg.eigvals(system.linearize().A)
    pair = np.sqrt(complex(square))
    for expected in (pair, -pair):
        assert np.abs(eigenvalues - expected).min() < 1e-7 * abs(pair)


@pytest.mark.parametrize("method", ["definition", "kane"])
@pytest.mark.parametrize(
    ("lean", "rates"), [(0.3, (1.0, 8.0, 0.5)), (-0.6, (0.0, -12.0, 3.0)), (0.9, (0.4, 2.0, 9.0))]
)
def test_a_disc_moves_as_the_equations_of_textbooks_say(lean, rates, method):
    times = np.linspace(0.0, 1.0, 11)
    expected = disc_motion(times, lean, rates, M, R, G)
    system, _ = rolling(method=method, times=times)
    system.ode_solver = "dop853"
    start = dict(zip(("w1", "w2", "w3"), rates, strict=True))
    x, y, z = expected[0, :3]
    # The velocity of the centre is that of rolling, r (ω₂ e₁ − ω₁ e₂).
    rolled = {"vx": R * rates[1], "vy": -R * rates[0] * np.cos(lean)}
    rolled["vz"] = -R * rates[0] * np.sin(lean)
    start |= {"x": x, "y": y, "z": z, "lean": lean, **rolled}
    system.initial_conditions = {me.dynamicsymbols(name): v for name, v in start.items()}
    motion = system.simulate(rtol=1e-13, atol=1e-13, constraints="project")
    names = ("x", "y", "z", "yaw", "lean", "w1", "w2", "w3")
    found = np.stack([motion[name] for name in names], axis=1)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-9)
    assert np.ptp(expected[:, 4]) > 0.2  # it wobbles


@pytest.mark.parametrize("crown", [0.0, 0.06])
def test_a_wheel_that_rolls_keeps_its_energy_and_stays_on_the_plane(crown):
    start = {"lean": 0.3, "w1": 1.0, "w2": 8.0, "w3": 0.5}
    system, contact = rolling(crown, initial_conditions=start, times=np.linspace(0.0, 3.0, 31))
    system.set_dependent_initial_conditions()
    system.outputs = {"gap": contact.gap, "gamma": contact.gamma}
    motion = system.simulate(**TIGHT, constraints="project")
    assert np.ptp(motion["gamma"]) > 0.1
    assert np.abs(motion["gap"]).max() < 1e-12
    energy = motion.energy[:, 2]
    np.testing.assert_allclose(energy, energy[0], rtol=1e-9)


def test_a_torus_that_is_a_ball_rolls_straight_on():
    size = 0.4 * M * R**2
    start = {"z": R, "lean": 0.2, "w1": 1.0, "w2": 8.0, "w3": 0.5}
    ball = R - 1e-14
    system, _ = rolling(ball, size, size, initial_conditions=start, times=[0.0, 0.5, 1.0])
    system.set_dependent_initial_conditions()
    motion = system.simulate(**TIGHT, constraints="project")
    for name in ("vx", "vy"):
        np.testing.assert_allclose(motion[name], motion[name][0], atol=1e-9)
    assert abs(motion["vx"][0]) > 1.0


def test_a_sprung_wheel_may_roll_without_slip():
    wheel = planar_wheel(M, M * R**2 / 2)
    (x, z, q), (vx, vz, w) = wheel.q, wheel.u
    N, O, C, body = wheel.N, wheel.O, wheel.C, wheel.body
    contact = WheelContact(body, N.y, R, O, N.z, N, lambda gap, rate: -1e5 * gap)
    assert contact.holonomic_constraints == []
    weight = (C, M * G * (sm.sin(0.3) * N.x - sm.cos(0.3) * N.z))
    system = System(
        Definition(
            N, [x, z, q], [vx, vz, w], bodies=[body], loads=[weight, *contact.loads()],
            nonholonomic_constraints=contact.nonholonomic_constraints[:1],
        ),
        initial_conditions={z: R - M * G * np.cos(0.3) / 1e5},
    )  # fmt: skip
    arm = float(system.initial_conditions[z])
    found = dict(zip(system.states, system.evaluate_ode(), strict=True))
    # It rolls on the loaded radius.
    assert found[vx] == pytest.approx(G * np.sin(0.3) / (1 + R**2 / 2 / arm**2), rel=1e-9)
    assert found[vz] == pytest.approx(0.0, abs=1e-9)


def test_a_rigid_wheel_takes_no_tire():
    contact = rolling()[1]
    assert (contact.normal_force, contact.loads(), contact.events) == (None, [], [])
    with pytest.raises(ValueError, match="`tire` needs a normal force, and this wheel is rigid"):
        contact.loads(LinearTire(4000, 1e5))
    with pytest.raises(ValueError, match="`pressure` is that of a tire, and `tire` is None"):
        contact.loads(pressure=2e5)
