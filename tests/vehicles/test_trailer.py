"""A car with a trailer against the linear equations of both bodies, written down."""

import numpy as np
import pytest
from scipy.integrate import simpson
from scipy.optimize import brentq

from pydy.vehicles import LinearTire, SingleTrackCar, car_trailer, single_track

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


BARE = {name: value for name, value in CARAVAN.items() if name != "stiffness"}


def test_linear_tires_on_all_axles_are_stiffnesses_per_load():
    # An axle with two tires of stiffness C at the load F_0 has C·F/F_0: the hitch moves load.
    g, m, a, b = 9.81, CAR.mass, CAR.front, CAR.rear
    m_t, c, l, e = (CARAVAN[name] for name in ("mass", "hitch", "length", "centre"))
    on_hitch = m_t * g * (l - e) / l
    front = (m * g * b - on_hitch * (c - b)) / (a + b)
    rear, behind = m * g + on_hitch - front, m_t * g * e / l
    tire = LinearTire(4000, 50e3)
    stiff = [50e3 / 4000 * load for load in (front, rear, behind)]
    same = SingleTrackCar(m, CAR.yaw_inertia, a, b, *stiff[:2])
    expected = car_trailer(same, **BARE, stiffness=stiff[2]).linearize().A
    linear = car_trailer(CAR, tire, **BARE, trailer_tire=tire).linearize()
    matrix = linear.A
    assert matrix == pytest.approx(expected, rel=1e-12, abs=1e-12)


def test_braking_in_a_turn_takes_as_much_energy_as_the_forces_take():
    system = car_trailer(CAR, **CARAVAN, speed=20.0, free_speed=True)
    system.specifieds = {"delta": 0.03, "F_x": -4000.0, "F_x_t": -2000.0}
    system.times = np.linspace(0.0, 3.0, 301)
    motion = system.simulate(rtol=1e-10, atol=1e-10)
    states = {name: np.asarray(motion[name]) for name in ("u", "v", "r", "omega", "phi")}
    u, v, r, w, phi = states.values()
    F = {name: np.asarray(motion[name]) for name in ("F_f", "F_r", "F_t")}
    c, e, l, delta = CARAVAN["hitch"], CARAVAN["centre"], CARAVAN["length"], 0.03
    cos, sin = np.cos(phi), np.sin(phi)
    ahead, aside = u * cos + (v - c * r) * sin, (v - c * r) * cos - u * sin
    energy = 0.5 * (
        CAR.mass * (u**2 + v**2) + CAR.yaw_inertia * r**2 + CARAVAN["yaw_inertia"] * (r + w) ** 2
        + CARAVAN["mass"] * (ahead**2 + (aside - e * (r + w)) ** 2)
    )  # fmt: skip
    power = (
        F["F_f"] * ((v + CAR.front * r) * np.cos(delta) - u * np.sin(delta))
        + F["F_r"] * (v - CAR.rear * r) - 4000.0 * u
        + F["F_t"] * (aside - l * (r + w)) - 2000.0 * ahead
    )  # fmt: skip
    work = simpson(power, x=system.times)
    assert energy[-1] - energy[0] == pytest.approx(work, rel=1e-6)
    assert u[-1] < 14.0


def test_an_axle_without_load_cannot_have_a_tire():
    with pytest.raises(
        ValueError, match=r"The axle of the trailer bears -.* N: a tire needs a pos"
    ):
        car_trailer(CAR, **{**BARE, "centre": -1.0}, trailer_tire=LinearTire(4000, 50e3))


@pytest.mark.parametrize("pair", [{}, {"stiffness": 7e4, "trailer_tire": LinearTire(4e3, 5e4)}])
def test_the_trailer_has_either_a_stiffness_or_a_tire(pair):
    with pytest.raises(ValueError, match="Pass either `stiffness` or `trailer_tire`, got"):
        car_trailer(CAR, **BARE, **pair)
