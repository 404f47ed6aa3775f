"""Wheels with a flat tread: deflection, contact point and moments, against sums over the width."""

from functools import cache

import numpy as np
import pytest

from pydy.contact import kelvin_voigt
from pydy.vehicles import LinearTire, WheelContact
from zoo.wheels import derivative, free_wheel, values

R, WIDTH, K = 0.3, 0.2, 1e5
STATE = {
    "x": 0.1, "y": -0.2, "z": 0.28, "yaw": 0.4, "lean": 0.05, "spin": 1.2,
    "vx": 8.0, "vy": 1.0, "vz": -0.3, "w1": 0.5, "w2": 20.0, "w3": -0.4,
}  # fmt: skip
LEANS = [0.05, -0.05, 0.3, -0.3, 1e-3]


def contact_of(w, **options):
    def law(gap, rate):
        return kelvin_voigt(gap, rate, K, 0)

    return WheelContact(w.body, w.B.y, R, w.O, w.N.z, w.N, law, width=WIDTH, **options)


@cache
def wheel_and_contact():
    w = free_wheel()
    return w, contact_of(w)


@pytest.mark.parametrize("lean", LEANS)
def test_gap_and_contact_point_are_mean_and_centroid_of_the_deflection(lean):
    w, contact = wheel_and_contact()
    state = {**STATE, "lean": lean}
    y = (np.arange(200_000) + 0.5) / 200_000 * WIDTH - WIDTH / 2
    depth = np.maximum(R * np.cos(lean) - y * np.sin(lean) - state["z"], 0.0)
    assert values(w, contact.gap, state) == pytest.approx(-depth.mean(), rel=1e-8)
    offset, axle = values(w, contact.contact, state), values(w, w.B.y, state)
    across = (depth * y).sum() / depth.sum()
    # C is on the ground, below this point of the axle in the wheel plane.
    assert offset[2] == pytest.approx(-state["z"], abs=1e-15)
    assert offset @ axle == pytest.approx(across, rel=1e-7)
    assert offset @ values(w, contact.forward, state) == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize("lean", [0.05, -0.05, 0.3, -0.3])
def test_the_contact_point_is_that_of_rills_equations(lean):
    # Rill, Road Vehicle Dynamics, 2012, section 3.3: the deflections of both edges; where both
    # touch, the centroid of a trapezoid, where one is lifted, that of a triangle.
    w, contact = wheel_and_contact()
    state = {**STATE, "lean": lean}
    middle = R * np.cos(lean) - state["z"]
    left, right = (middle - side * WIDTH / 2 * np.sin(lean) for side in (1, -1))
    if min(left, right) > 0.0:
        mean = (left + right) / 2
        across = -(WIDTH**2) / 12 * np.tan(lean) / (mean / np.cos(lean))
    else:
        touched = max(left, right) / np.sin(abs(lean))  # of the width
        mean = max(left, right) * touched / WIDTH / 2
        across = -np.sign(lean) * (WIDTH / 2 - touched / 3)
    assert values(w, contact.gap, state) == pytest.approx(-mean, rel=1e-12)
    offset, axle = values(w, contact.contact, state), values(w, w.B.y, state)
    assert offset @ axle == pytest.approx(across, rel=1e-12)


@pytest.mark.parametrize("lean", LEANS)
@pytest.mark.parametrize("height", [0.28, 0.3, 0.4])
def test_the_rate_is_the_derivative_of_the_gap(lean, height):
    w, contact = wheel_and_contact()
    state = {**STATE, "lean": lean, "z": height}
    found = values(w, contact.rate, state)
    assert found == pytest.approx(derivative(w, contact.gap, state), rel=1e-6)


def test_a_lifted_wheel_is_as_high_as_its_lower_edge():
    w, contact = wheel_and_contact()
    for lean in (0.2, -0.2):
        found = values(w, contact.gap, {**STATE, "z": 0.5, "lean": lean})
        assert found == pytest.approx(0.5 - R * np.cos(0.2) - WIDTH / 2 * np.sin(0.2))


def test_a_wide_wheel_that_leans_is_righted_by_its_springs():
    w, contact = wheel_and_contact()
    (_, force), (_, torque) = contact.loads()
    depth, lean = R - STATE["z"], 1e-4
    for sign in (-1, 0, 1):
        state = {**STATE, "yaw": 0.0, "lean": sign * lean}
        assert values(w, force, state)[2] == pytest.approx(K * depth, rel=1e-6)
        # Springs of K/b per width, of the second moment b³/12; and the lean of the centre.
        moment = values(w, torque.dot(contact.forward), state)
        expected = -K * WIDTH**2 / 12 * sign * lean + K * depth * STATE["z"] * np.tan(sign * lean)
        assert moment == pytest.approx(expected, rel=1e-6, abs=1e-12)


def test_an_upright_wheel_that_begins_to_touch_has_finite_loads():
    w, contact = wheel_and_contact()
    tire = LinearTire(4000, 1e5, 1e5)
    for height in (R, R + 1e-12, R - 1e-12):
        state = {**STATE, "z": height, "lean": 0.0}
        for _, vector in contact.loads(tire):
            assert np.abs(values(w, vector, state)).max() < 1e-6
        assert np.isfinite(values(w, contact.alpha, state))


def test_arguments_are_checked():
    w = free_wheel()
    with pytest.raises(ValueError, match="`width` must be positive"):
        WheelContact(w.body, w.B.y, R, w.O, w.N.z, w.N, lambda gap, rate: -gap, width=0.0)
    with pytest.raises(ValueError, match=r"`width` is that of a flat tread, .* give a `force`"):
        WheelContact(w.body, w.B.y, R, w.O, w.N.z, w.N, width=0.2)
    with pytest.raises(ValueError, match="`width` is that of a flat tread"):
        contact_of(w, crown_radius=0.05)
