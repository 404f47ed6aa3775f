"""The double-track car against the linear single-track car, and its balances."""

from dataclasses import replace

import numpy as np
import pytest

from pydy.vehicles import (
    CARS,
    BrushTire,
    DoubleTrackCar,
    LinearTire,
    double_track,
    lane_change,
    linear_handling,
    single_track,
    steady_turn,
    step_steer,
)

CAR = DoubleTrackCar(
    mass=1500, yaw_inertia=2500, front=1.2, rear=1.5, front_stiffness=90e3, rear_stiffness=110e3,
    height=0.5, front_track=1.5, rear_track=1.45, wheel_radius=0.3, wheel_inertia=1.2,
    front_roll_share=0.6, front_drive_share=0.0, front_brake_share=0.7,
)  # fmt: skip
WEIGHT = CAR.mass * 9.81
BRUSH = BrushTire(WEIGHT / 4, 80e3, 0.9)


def driven(system, **inputs):
    system.specifieds = {"delta": 0.0, "T_drive": 0.0, "T_brake": 0.0, **inputs}
    return system


def state_at(motion, names, k=-1):
    return np.array([motion[name][k] for name in names])


@pytest.mark.parametrize("speed", [10.0, 30.0])
def test_with_light_wheels_its_eigenvalues_are_those_of_the_single_track_car(speed):
    light = replace(CAR, wheel_inertia=1e-4)
    found = double_track(light, speed=speed).linearize().eigenvalues
    for expected in linear_handling(CAR, speed).eigenvalues[0]:
        assert np.abs(found - expected).min() == pytest.approx(0.0, abs=1e-4 * abs(expected))


def test_steered_a_little_it_turns_as_the_single_track_car():
    motion = driven(double_track(replace(CAR, wheel_inertia=0.01)), delta=0.002).simulate()
    other = single_track(CAR)
    other.specifieds = {"delta": 0.002}
    other.times = motion.times
    assert motion["r"] == pytest.approx(np.asarray(other.simulate()["r"]), rel=2e-3, abs=1e-6)


@pytest.mark.parametrize("tires", [None, BRUSH])
def test_the_normal_forces_balance_weight_and_accelerations(tires):
    system = driven(double_track(CAR, tires), delta=0.04, T_drive=-300.0, T_brake=200.0)
    motion = system.simulate()
    fl, fr, rl, rr = state_at(motion, [f"Fz_{wheel}" for wheel in ("fl", "fr", "rl", "rr")])
    a_x, a_y = state_at(motion, ["a_x_load", "a_y_load"])
    assert a_x < -0.3
    assert a_y > 2.0
    assert fl + fr + rl + rr == pytest.approx(WEIGHT)
    pitch = CAR.rear * (rl + rr) - CAR.front * (fl + fr)
    assert pitch == pytest.approx(CAR.mass * a_x * CAR.height)
    front = (fr - fl) * CAR.front_track / 2
    rear = (rr - rl) * CAR.rear_track / 2
    assert front + rear == pytest.approx(CAR.mass * a_y * CAR.height)
    assert front / (front + rear) == pytest.approx(CAR.front_roll_share)


def test_the_accelerations_are_those_of_the_mass_centre():
    system = driven(double_track(CAR, BRUSH), delta=0.05, T_drive=400.0)
    motion = system.simulate()
    names = [str(s).removesuffix("(t)") for s in system.states]
    rates = dict(zip(names, system.evaluate_ode(motion.states[-1]), strict=True))
    u, v, r, a_x, a_y = state_at(motion, ["u", "v", "r", "a_x", "a_y"])
    assert rates["u"] - v * r == pytest.approx(a_x, rel=1e-9)
    assert rates["v"] + u * r == pytest.approx(a_y, rel=1e-9)
    # The loads follow with a lag of 0.05 s.
    followers = state_at(motion, ["a_x_load", "a_y_load"])
    lagging = [rates["a_x_load"], rates["a_y_load"]]
    assert lagging == pytest.approx((np.array([a_x, a_y]) - followers) / 0.05, rel=1e-6)
    # The forces of the wheels, turned into the axes of the body.
    steered = {"fl": 0.05, "fr": 0.05, "rl": 0.0, "rr": 0.0}
    forces = {w: state_at(motion, [f"Fx_{w}", f"Fy_{w}"]) for w in steered}
    push = sum(
        f[0] * np.cos(d) - f[1] * np.sin(d)
        for d, f in zip(steered.values(), forces.values(), strict=True)
    )
    assert push == pytest.approx(CAR.mass * a_x, rel=1e-9)


def test_straight_ahead_the_wheels_add_their_inertia():
    stiff = LinearTire(WEIGHT / 4, 80e3, 1e6)  # slips of less than 0.001
    system = driven(double_track(CAR, stiff), T_drive=600.0)
    system.ode_solver = "radau"
    motion = system.simulate()
    expected = 600.0 / CAR.wheel_radius / (CAR.mass + 4 * CAR.wheel_inertia / CAR.wheel_radius**2)
    assert motion["a_x"][-1] == pytest.approx(expected, rel=2e-3)
    assert motion["u"][-1] - 20.0 == pytest.approx(2.0 * expected, rel=1e-3)


def test_a_locked_differential_holds_the_speeds_of_the_driven_wheels_together():
    free, locked = (
        driven(double_track(CAR, BRUSH, differential=kind), delta=0.05, T_drive=300.0).simulate()
        for kind in ("open", "locked")
    )
    assert locked["omega_rl"] == pytest.approx(np.asarray(locked["omega_rr"]), rel=1e-12)
    assert free["omega_rr"][-1] > 1.01 * free["omega_rl"][-1]
    assert locked["omega_fr"][-1] > 1.01 * locked["omega_fl"][-1]
    assert locked["r"][-1] < free["r"][-1]  # it resists turning


def test_air_brakes_and_presses():
    system = double_track(CAR, speed=50.0, drag_area=0.8, downforce_areas=(1.0, 1.5))
    motion = driven(system).simulate()
    pressure = 1.2041 / 2 * motion["u"] ** 2
    loads = sum(motion[f"Fz_{wheel}"] for wheel in ("fl", "fr", "rl", "rr"))
    assert loads == pytest.approx(WEIGHT + 2.5 * pressure)
    inertia = CAR.mass + 4 * CAR.wheel_inertia / CAR.wheel_radius**2
    assert np.gradient(motion["u"], motion.times)[100] == pytest.approx(
        -0.8 * pressure[100] / inertia, rel=2e-3
    )


def test_brakes_that_are_too_strong_lock_the_wheels():
    system = driven(double_track(CAR, BRUSH), T_brake=9000.0)
    system.times = np.linspace(0.0, 1.0, 11)
    motion = system.simulate()
    assert motion["kappa_fl"][-1] < -0.98
    assert motion["a_x"][-1] == pytest.approx(-0.9 * 9.81, rel=0.01)  # all wheels slide


def test_mirrored_steering_gives_the_mirrored_motion():
    left, right = (
        driven(double_track(CARS["vw_vanagon"], BRUSH), delta=angle).simulate()
        for angle in (0.05, -0.05)
    )
    for one, other in (("r", "r"), ("v", "v"), ("a_y", "a_y")):
        assert left[one] == pytest.approx(-np.asarray(right[other]), rel=1e-6, abs=1e-8)
    assert left["Fz_fl"] == pytest.approx(np.asarray(right["Fz_fr"]), rel=1e-6)


@pytest.mark.parametrize("differential", ["open", "locked"])
def test_it_is_driven_by_the_manoeuvres(differential):
    system = double_track(CAR, BRUSH, speed=15.0, differential=differential)
    assert lane_change(system, 1.7).passed
    response = step_steer(system, 0.02, duration=2.0)
    assert response.steady == pytest.approx(response.trajectory["r"][-1])
    accelerations = np.linspace(0.5, 4.0, 5)
    turn = steady_turn(system, 60.0, accelerations, inputs=("delta", "T_drive"))
    a_x, a_y, v = (turn.states[:, k] for k in (3, 4, 6))
    # The path of the mass centre curves by its course, which differs from its heading by β.
    beta = v / turn.speeds
    assert a_y == pytest.approx(accelerations, rel=1e-6)
    assert a_x == pytest.approx(-accelerations * beta, rel=1e-6)


def test_its_understeer_gradient_is_that_of_the_linear_car():
    # Loads and slips of the turn change it by their squares: small turns.
    system = double_track(replace(CAR, height=1e-6), speed=15.0)
    turn = steady_turn(system, 500.0, [0.1, 0.2, 0.3], inputs=("delta", "T_drive"))
    expected = linear_handling(CAR, 10.0).understeer_gradient
    assert turn.understeer_gradient[1] == pytest.approx(expected, rel=0.02)


def test_other_cars_are_refused():
    with pytest.raises(TypeError, match="`car` must be a DoubleTrackCar, such as one of CARS"):
        double_track(single_track(CAR))
    with pytest.raises(ValueError, match="`front_roll_share` must be a number from 0 to 1"):
        replace(CAR, front_roll_share=1.5)
    with pytest.raises(TypeError, match="`downforce_areas` must be a pair"):
        double_track(CAR, downforce_areas=1.0)
