"""Single-track cars against the closed forms of the linear one, and manoeuvres."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pydy.errors import EquilibriumError, PyDyUserWarning
from pydy.vehicles import (
    CARS,
    BrushTire,
    LinearTire,
    MagicFormula,
    SingleTrackCar,
    commonroad_car,
    lane_change,
    linear_handling,
    single_track,
    steady_turn,
    step_steer,
)
from zoo.tires import TABLE_A31

UNDERSTEER = SingleTrackCar(1500, 2500, 1.2, 1.5, 90e3, 110e3)
OVERSTEER = SingleTrackCar(1500, 2500, 1.6, 1.1, 110e3, 90e3)
NEUTRAL = CARS["bmw_320i"]
EACH = pytest.mark.parametrize("car", [UNDERSTEER, OVERSTEER, NEUTRAL])


def state_matrix(car, u):
    m, inertia, a, b = car.mass, car.yaw_inertia, car.front, car.rear
    C_f, C_r = car.front_stiffness, car.rear_stiffness
    return np.array(
        [
            [-(C_f + C_r) / (m * u), (b * C_r - a * C_f) / (m * u) - u],
            [(b * C_r - a * C_f) / (inertia * u), -(a**2 * C_f + b**2 * C_r) / (inertia * u)],
        ]
    )


def descending(values):
    return np.array(sorted(values, key=lambda z: (z.real, z.imag)))


@EACH
@pytest.mark.parametrize("speed", [3.0, 12.0, 25.0, 50.0])
def test_eigenvalues_are_those_of_the_linearised_system(car, speed):
    linear = single_track(car, speed=speed).linearize()
    moving = [linear.states.index(name) for name in ("v", "r")]
    A = linear.A[np.ix_(moving, moving)]
    expected = state_matrix(car, speed)
    assert pytest.approx(expected, rel=1e-12, abs=1e-12) == A
    closed = descending(linear_handling(car, speed).eigenvalues[0])
    assert closed == pytest.approx(descending(np.linalg.eigvals(A)), rel=1e-10)


@EACH
def test_natural_frequency_and_damping_are_those_of_the_eigenvalues(car):
    handling = linear_handling(car, np.linspace(2.0, 20.0, 10))
    product, total = handling.eigenvalues.prod(axis=1), handling.eigenvalues.sum(axis=1)
    assert handling.natural_frequency**2 == pytest.approx(product.real)
    assert 2 * handling.damping_ratio * handling.natural_frequency == pytest.approx(-total.real)


@EACH
def test_gains_are_those_of_the_linearised_system(car):
    linear = single_track(car, speed=15.0).linearize(inputs=["delta"], outputs=["v", "r", "a_y"])
    handling = linear_handling(car, 15.0)
    moving = [linear.states.index(name) for name in ("v", "r")]
    A, B = linear.A[np.ix_(moving, moving)], linear.B[moving]
    gains = linear.D - linear.C[:, moving] @ np.linalg.solve(A, B)
    closed = [handling.sideslip_gain * 15.0, handling.yaw_rate_gain, handling.acceleration_gain]
    assert gains == pytest.approx(np.array(closed), rel=1e-10)


def test_an_oversteering_car_is_unstable_beyond_its_critical_speed():
    critical = linear_handling(OVERSTEER, 1.0).critical_speed
    largest = [
        single_track(OVERSTEER, speed=critical + step).linearize().A[3:, 3:]
        for step in (-1e-3, 1e-3)
    ]
    below, beyond = (np.linalg.eigvals(A).real.max() for A in largest)
    assert below < 0.0 < beyond
    handling = linear_handling(OVERSTEER, critical * np.array([0.9, 1.1]))
    assert np.isfinite(handling.natural_frequency).tolist() == [True, False]
    assert np.isfinite(handling.damping_ratio).tolist() == [True, False]
    assert handling.characteristic_speed == np.inf


def test_the_yaw_rate_gain_is_largest_at_the_characteristic_speed():
    speed = linear_handling(UNDERSTEER, 1.0).characteristic_speed
    gains = linear_handling(UNDERSTEER, speed * np.array([0.99, 1.0, 1.01])).yaw_rate_gain
    assert gains.argmax() == 1
    assert gains[1] == pytest.approx(speed / UNDERSTEER.wheelbase / 2)


@pytest.mark.parametrize("car", CARS.values())
def test_the_published_cars_are_neutral(car):
    handling = linear_handling(car, [5.0, 80.0])
    assert handling.understeer_gradient == 0.0
    assert handling.critical_speed == handling.characteristic_speed == np.inf
    assert handling.yaw_rate_gain == pytest.approx(handling.speeds / car.wheelbase)


def test_the_free_car_keeps_its_speed_on_a_straight_road_and_loses_it_in_a_turn():
    system = single_track(UNDERSTEER, speed=20.0, free_speed=True)
    assert system.evaluate_ode([0, 0, 0, 20, 0, 0]) == pytest.approx([20, 0, 0, 0, 0, 0])
    system.specifieds = {"delta": 0.02, "F_x": 0.0}
    motion = system.simulate()
    assert 19.0 < motion["u"][-1] < 20.0
    system.specifieds = {"delta": 0.0, "F_x": 3000.0}
    assert system.simulate()["u"][-1] == pytest.approx(30.0)


def test_linear_tires_give_the_linear_car():
    g, L = 9.81, UNDERSTEER.wheelbase
    loads = [UNDERSTEER.mass * g * arm / L / 2 for arm in (UNDERSTEER.rear, UNDERSTEER.front)]
    stiffnesses = UNDERSTEER.front_stiffness / 2, UNDERSTEER.rear_stiffness / 2
    tires = [LinearTire(F, C) for F, C in zip(loads, stiffnesses, strict=True)]
    state = [0.0, 0.0, 0.1, 0.3, 0.2]
    reference = single_track(UNDERSTEER).evaluate_ode(state)
    assert single_track(UNDERSTEER, tires).evaluate_ode(state) == pytest.approx(reference)


def test_the_trail_turns_the_car_out_of_the_curve():
    tires = [LinearTire(3500, 5e4, trail=trail) for trail in (0.0, 0.03)]
    without, trailing = (
        steady_turn(single_track(UNDERSTEER, tire), 100.0, [1.0, 2.0, 3.0]) for tire in tires
    )
    assert (trailing.angles > without.angles).all()


def test_a_car_drives_straight_on_tires_with_ply_steer():
    system = single_track(UNDERSTEER, MagicFormula(TABLE_A31), speed=30.0)
    assert system.evaluate_ode(np.zeros(5)) == pytest.approx([30, 0, 0, 0, 0], abs=1e-12)


@EACH
@pytest.mark.parametrize("free_speed", [False, True])
def test_the_understeer_gradient_of_steady_turns_is_the_linear_one_at_small_slips(car, free_speed):
    system = single_track(car, free_speed=free_speed)
    turn = steady_turn(system, 1e4, [0.01, 0.02, 0.03, 0.04])
    gradient = linear_handling(car, 1.0).understeer_gradient
    scale = car.wheelbase / 1e4
    assert turn.understeer_gradient == pytest.approx(np.full(4, gradient), rel=1e-6, abs=1e-9)
    linear = scale + gradient * turn.accelerations
    assert turn.angles == pytest.approx(linear, rel=1e-6)


def test_turns_end_where_the_tires_slide():
    system = single_track(UNDERSTEER, BrushTire(4000, stiffness=60e3, friction=0.8))
    with pytest.warns(PyDyUserWarning, match="the turns end at 7"):
        turn = steady_turn(system, 80.0, np.arange(1.0, 12.0))
    assert len(turn.angles) == 7
    assert turn.states[:, 4] == pytest.approx(np.sqrt(turn.accelerations / 80.0))
    with pytest.raises(EquilibriumError):
        steady_turn(system, 80.0, [9.0, 10.0, 11.0])


def test_the_step_response_is_that_of_the_linear_car():
    angle, u = 1e-4, 30.0
    response = step_steer(single_track(UNDERSTEER, speed=u), angle)
    a, C_f = UNDERSTEER.front, UNDERSTEER.front_stiffness
    push = np.array([C_f / UNDERSTEER.mass, a * C_f / UNDERSTEER.yaw_inertia]) * angle
    A = state_matrix(UNDERSTEER, u)
    times = response.times
    exact = solve_ivp(
        lambda t, x: A @ x + push, (0, 5), [0, 0], t_eval=times, rtol=1e-11, atol=1e-16
    )
    r = exact.y[1]
    assert response.values == pytest.approx(r, rel=1e-5, abs=1e-9)
    gain = linear_handling(UNDERSTEER, u).yaw_rate_gain[0]
    assert response.steady == pytest.approx(gain * angle, rel=1e-5)
    assert response.peak == pytest.approx(r.max(), rel=1e-5)
    assert response.peak_time == pytest.approx(times[r.argmax()], abs=0.01)
    assert response.overshoot == pytest.approx(r.max() / r[-1] - 1.0, abs=1e-5)
    crossings = [np.interp(share * r[-1], r[:100], times[:100]) for share in (0.1, 0.9)]
    assert response.response_time == pytest.approx(crossings[1], abs=1e-4)
    assert response.rise_time == pytest.approx(crossings[1] - crossings[0], abs=1e-4)


def test_a_step_to_the_right_mirrors_one_to_the_left_and_leaves_the_system_as_it_was():
    system = single_track(UNDERSTEER, speed=30.0)
    left, right = (step_steer(system, angle, quantity="a_y") for angle in (0.02, -0.02))
    assert right.values == pytest.approx(-left.values, abs=1e-8)
    assert (right.overshoot, right.rise_time) == pytest.approx((left.overshoot, left.rise_time))
    assert len(system.times) == 501
    assert [*system.specifieds.values()] == [0.0]


def test_a_response_that_is_not_steady_is_warned_of():
    with pytest.warns(PyDyUserWarning, match="r is not steady"):
        step_steer(single_track(UNDERSTEER, speed=30.0), 0.01, duration=0.3)


def test_results_are_drawn():
    handling = linear_handling(UNDERSTEER, np.linspace(5.0, 50.0, 10))
    assert [ax.get_ylabel() for ax in handling.plot()] == [
        "yaw-rate gain (1/s)", "natural frequency (rad/s)", "damping ratio"
    ]  # fmt: skip
    system = single_track(UNDERSTEER)
    response, turn = step_steer(system, 0.01), steady_turn(system, 100.0, [1.0, 2.0, 3.0])
    assert response.plot().get_ylabel() == "r (rad/s)"
    turned = response.plot(unit=("°/s", 180 / np.pi))
    assert turned.get_ylabel() == "r (°/s)"
    np.testing.assert_allclose(np.radians(turned.lines[1].get_ydata()), response.values)
    acceleration = step_steer(system, 0.01, quantity="a_y")
    assert acceleration.plot().get_ylabel() == "a_y (m/s²)"
    assert acceleration.plot(unit="g").get_ylabel() == "a_y (g)"
    drawn = turn.plot()
    assert drawn.get_xlabel() == "lateral acceleration (m/s²)"
    assert drawn.get_ylabel() == "steering angle (°)"
    np.testing.assert_array_equal(drawn.lines[0].get_xdata(), [1.0, 2.0, 3.0])
    np.testing.assert_allclose(np.radians(drawn.lines[0].get_ydata()), turn.angles)
    assert repr(response).startswith("<StepResponse of r: steady 0.05")
    assert repr(turn).startswith("<SteadyTurn of 100 m up to 3 m/s²: understeer gradient 0.18")


def test_what_is_no_car_is_refused():
    with pytest.raises(ValueError, match=r"`rear` must be positive, got -1.5"):
        replace(UNDERSTEER, rear=-1.5)
    with pytest.raises(TypeError, match="`car` must be a SingleTrackCar"):
        single_track("bmw_320i")
    with pytest.raises(TypeError, match="`tires` must be a tire"):
        single_track(UNDERSTEER, [LinearTire(4000, 5e4)])
    with pytest.raises(ValueError, match="`steering` must be one of delta, got 'deltas'"):
        step_steer(single_track(UNDERSTEER), 0.01, steering="deltas")
    with pytest.raises(ValueError, match="got 'v_delta', which is the rate of the state delta"):
        step_steer(commonroad_car("bmw_320i"), 0.01, steering="v_delta")
    with pytest.raises(ValueError, match="got 'v_delta', which is the rate of the state delta"):
        lane_change(commonroad_car("bmw_320i"), 1.6, speed="v", steering="v_delta")
    with pytest.raises(ValueError, match="`quantity` must be one of x, y, psi, v, r, a_y, beta"):
        step_steer(single_track(UNDERSTEER), 0.01, quantity="yaw")
    with pytest.raises(ValueError, match=r"neither zero nor a right angle or more, got 2.0"):
        step_steer(single_track(UNDERSTEER), 2.0)
    with pytest.raises(ValueError, match="at least three positive ascending numbers"):
        steady_turn(single_track(UNDERSTEER), 100.0, [2.0, 1.0, 3.0])


def test_what_a_steady_turn_solves_for_is_checked():
    system = single_track(UNDERSTEER, free_speed=True)
    accelerations = [1.0, 2.0, 3.0]
    with pytest.raises(ValueError, match="`inputs` must have 'delta', the steering angle"):
        steady_turn(system, 100.0, accelerations, inputs="F_x")
    with pytest.raises(ValueError, match=r"`inputs` must be one of .*, got 'brake'"):
        steady_turn(system, 100.0, accelerations, inputs=("delta", "brake"))
    with pytest.raises(TypeError, match="`position` must be the names of two coordinates"):
        steady_turn(system, 100.0, accelerations, position="xy")
