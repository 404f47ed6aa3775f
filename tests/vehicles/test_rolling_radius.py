"""Wheels that roll on the effective rolling radius of their tires."""

import numpy as np
import pytest
import sympy as sm

from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles import MagicFormula, WheelContact
from zoo.tires import TABLE_A31
from zoo.wheels import free_wheel, planar_wheel, values

R, M, I, G = 0.313, 400.0, 1.2, 9.81
REFF = {"VERTICAL_STIFFNESS": 2e5, "BREFF": 8.4, "DREFF": 0.27, "FREFF": 0.045}
STATE = {
    "x": 0.1, "y": -0.2, "z": 0.28, "yaw": 0.4, "lean": 0.05, "spin": 1.2,
    "vx": 8.0, "vy": 1.0, "vz": 0.0, "w1": 0.5, "w2": 20.0, "w3": -0.4,
}  # fmt: skip


def tire():
    # No rolling resistance, and no shift of the force.
    return MagicFormula({**TABLE_A31, **REFF, "QSY1": 0.0, "PHX1": 0.0, "PHX2": 0.0})


def test_a_wheel_that_coasts_turns_at_its_speed_by_the_rolling_radius():
    wheel = planar_wheel(M, I)
    (x, z, q), (vx, vz, w) = wheel.q, wheel.u
    N, O, C, body = wheel.N, wheel.O, wheel.C, wheel.body
    rolls = tire()
    contact = WheelContact(
        body, N.y, R, O, N.z, N,
        lambda gap, rate: rolls.normal_force(gap, rate) - 2e3 * rate,
        rolling_radius=rolls.rolling_radius,
    )  # fmt: skip
    height = R - M * G / 2e5
    system = System(
        Definition(
            N, [x, z, q], [vx, vz, w], bodies=[body],
            loads=[(C, -M * G * N.z), *contact.loads(rolls)],
        ),
        ode_solver="radau",
        initial_conditions={z: height, vx: 20.0, w: 60.0},
        times=np.linspace(0.0, 2.0, 5),
    )  # fmt: skip
    system.outputs = {"kappa": contact.kappa}
    motion = system.simulate(rtol=1e-10, atol=1e-10)
    expected = rolls.rolling_radius(M * G)
    assert expected == pytest.approx(0.3043, abs=1e-4)
    assert motion["vx"][-1] / motion["w"][-1] == pytest.approx(expected, rel=1e-8)
    assert abs(motion["kappa"][-1]) < 1e-8
    assert abs(motion["kappa"][0]) > 0.05


@pytest.mark.parametrize("options", [{}, {"crown_radius": 0.06}])
def test_the_slip_is_that_of_the_speed_of_revolution(options):
    w = free_wheel()
    arguments = (w.body, w.B.y, R, w.O, w.N.z, w.N, lambda gap, rate: -2e5 * gap)
    plain = WheelContact(*arguments, **options)
    loaded = values(w, plain.contact.cross(w.B.y).dot(plain.forward), STATE)
    # On the loaded radius the slips are the usual ones, and others differ by the spin.
    same = WheelContact(*arguments, rolling_radius=loaded, **options)
    larger = WheelContact(*arguments, rolling_radius=lambda load: loaded + 0.01, **options)
    for name in ("kappa", "alpha"):
        usual = values(w, getattr(plain, name), STATE)
        assert values(w, getattr(same, name), STATE) == pytest.approx(usual, rel=1e-12)
    kappa, speed = values(w, plain.kappa, STATE), values(w, plain.speed, STATE)
    spin = STATE["w2"]
    assert values(w, larger.kappa, STATE) == pytest.approx(kappa + 0.01 * spin / speed, rel=1e-12)
    assert larger.alpha == plain.alpha


@pytest.mark.parametrize("damping", [0.0, 2e3])
def test_a_wheel_with_a_damper_may_roll_without_slip_on_its_rolling_radius(damping):
    wheel = planar_wheel(M, I)
    (x, z, q), (vx, vz, w) = wheel.q, wheel.u
    N, O, C, body = wheel.N, wheel.O, wheel.C, wheel.body
    radius, stiffness, slope = tire().rolling_radius, 2e5, 0.1
    contact = WheelContact(
        body, N.y, R, O, N.z, N,
        lambda gap, rate: -stiffness * gap - damping * rate, rolling_radius=radius,
    )  # fmt: skip
    weight = M * G * (np.sin(slope) * N.x - np.cos(slope) * N.z)
    load = M * G * np.cos(slope)
    height = R - load / stiffness
    system = System(
        Definition(
            N, [x, z, q], [vx, vz, w], bodies=[body], loads=[(C, weight), *contact.loads()],
            nonholonomic_constraints=contact.nonholonomic_constraints[:1],
        ),
        ode_solver="radau",
        initial_conditions={z: height},
        times=np.linspace(0.0, 1.0, 21),
    )  # fmt: skip
    found = dict(zip(system.states, system.evaluate_ode(), strict=True))
    expected = G * np.sin(slope) / (1 + I / (M * radius(load) ** 2))
    assert found[vx] == pytest.approx(expected, rel=1e-12)
    assert found[vx] == pytest.approx(found[w] * radius(load), rel=1e-12)
    # A wheel that bounces turns by the radius of its static load.
    system.initial_conditions = {z: height - 0.005, vx: 5.0, w: 5.0 / radius(load + 1e3)}
    motion = system.simulate(rtol=1e-10, atol=1e-10)
    assert np.ptp(motion["z"]) > 0.005
    static = radius(stiffness * (R - motion["z"]))
    np.testing.assert_allclose(motion["vx"], static * motion["w"], rtol=1e-7)


def test_arguments_are_checked():
    w = free_wheel()
    arguments = (w.body, w.B.y, R, w.O, w.N.z, w.N)
    with pytest.raises(ValueError, match=r"`rolling_radius` belongs to a tire .* rigid: give"):
        WheelContact(*arguments, rolling_radius=0.3)
    for radius in (-0.1, 0.0):
        with pytest.raises(ValueError, match="`rolling_radius` must be positive"):
            WheelContact(*arguments, lambda gap, rate: -gap, rolling_radius=radius)
    with pytest.raises(ValueError, match=r"`rolling_radius\(normal_force\)` must"):
        WheelContact(*arguments, lambda gap, rate: -gap, rolling_radius=lambda load: sm.nan)
