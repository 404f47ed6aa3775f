"""A car with a trailer against the linear equations of both bodies, written down."""

import numpy as np
import pytest
from scipy.optimize import brentq

from pydy.vehicles import SingleTrackCar, car_trailer, single_track

CAR = SingleTrackCar(1500, 2500, 1.2, 1.5, 90e3, 110e3)
CARAVAN = {
    "mass": 1200.0, "yaw_inertia": 2500.0, "hitch": 2.5, "length": 4.0, "centre": 4.2,
    "stiffness": 70e3,
}  # fmt: skip
SEMI = {**CARAVAN, "hitch": -0.3, "mass": 2500.0, "centre": 2.0}


def state_matrix(trailer, u):
    """Return the matrix of v, r, φ' and φ, from Newton's and Euler's equations of both bodies.

    Unknowns are v', r', φ'' and the hitch's force Y on the car.
    """
    m, I, a, b = CAR.mass, CAR.yaw_inertia, CAR.front, CAR.rear
    m_t, I_t, c, l, e, C_t = trailer.values()
    # Side forces as rows over v, r, φ', φ.
    front = -CAR.front_stiffness / u * np.array([1, a, 0, 0])
    rear = -CAR.rear_stiffness / u * np.array([1, -b, 0, 0])
    behind = -C_t / u * np.array([1, -c - l, -l, -u])
    left = np.array(
        [
            [m, 0, 0, -1],
            [0, I, 0, c],
            [m_t, -m_t * (c + e), -m_t * e, 1],
            [0, I_t, I_t, e],
        ]
    )
    turning = np.array([0, u, 0, 0])
    right = np.array(
        [front + rear - m * turning, a * front - b * rear, behind - m_t * turning, (e - l) * behind]
    )
    rates = np.linalg.solve(left, right)[:3]
    return np.vstack([rates, [0, 0, 1, 0]])


@pytest.mark.parametrize("trailer", [CARAVAN, SEMI])
@pytest.mark.parametrize("speed", [5.0, 20.0, 35.0])
def test_the_linearised_system_has_the_matrix_of_the_linear_equations(trailer, speed):
    linear = car_trailer(CAR, **trailer, speed=speed).linearize()
    rows = [linear.states.index(name) for name in ("v", "r", "omega", "phi")]
    found = linear.A[np.ix_(rows, rows)]
    assert found == pytest.approx(state_matrix(trailer, speed), rel=1e-9, abs=1e-9)


def test_beyond_the_critical_speed_the_trailer_sways():
    def largest(u):
        return np.linalg.eigvals(state_matrix(CARAVAN, u)).real.max()

    critical = brentq(largest, 10.0, 40.0)
    decays, grows = (
        car_trailer(CAR, **CARAVAN, speed=factor * critical) for factor in (0.98, 1.02)
    )
    ends = []
    for system in (decays, grows):
        system.initial_conditions["phi"] = 1e-4
        system.times = np.linspace(0.0, 30.0, 3001)
        phi = np.abs(system.simulate(rtol=1e-10, atol=1e-14)["phi"])
        ends.append(phi[2000:].max() / phi[500:1500].max())
    assert ends[0] < 1.0 < ends[1]
    assert np.linalg.eigvals(state_matrix(CARAVAN, critical)).imag.max() > 1.0  # it oscillates


def test_a_trailer_without_mass_and_stiffness_does_not_change_the_car():
    light = {**CARAVAN, "mass": 1e-9, "yaw_inertia": 1e-9, "stiffness": 1e-9}
    with_it, alone = car_trailer(CAR, **light), single_track(CAR)
    for system in (with_it, alone):
        system.specifieds = {"delta": 0.03}
        system.times = np.linspace(0.0, 2.0, 21)
    motion, expected = (s.simulate(rtol=1e-10, atol=1e-12) for s in (with_it, alone))
    assert motion["r"] == pytest.approx(np.asarray(expected["r"]), rel=1e-8)


def test_a_slow_trailer_follows_in_the_circle_of_its_hitch():
    # Without slip: tan of the angles of hitch and axle to the centre of the turn.
    car = SingleTrackCar(1500, 2500, 1.2, 1.5, 90e6, 110e6)
    system = car_trailer(car, **{**CARAVAN, "stiffness": 70e6}, speed=0.5)
    system.ode_solver = "radau"
    system.specifieds = {"delta": 0.2}
    system.times = np.linspace(0.0, 60.0, 11)
    radius = car.wheelbase / np.tan(0.2)  # of the rear axle
    behind = CARAVAN["hitch"] - car.rear
    hitch = np.hypot(radius, behind)
    expected = np.arctan(behind / radius) + np.arcsin(CARAVAN["length"] / hitch)
    assert system.simulate()["phi"][-1] == pytest.approx(-expected, rel=1e-3)
