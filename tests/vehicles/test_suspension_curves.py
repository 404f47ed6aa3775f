"""Kinematic curves of suspensions against the planar four-bar and its instantaneous centers."""

from dataclasses import replace

import numpy as np
import pytest

from zoo.suspended import (
    BALL,
    CENTER,
    LOWER,
    MOUNT,
    SPATIAL,
    SPRING,
    STRUT,
    STRUTTED,
    TOP,
    TOWER,
    UPPER,
    WISHBONE,
    point,
)

RADIUS = 0.31
ANGLES = np.array([-0.25, -0.1, 0.0, 0.07, 0.2])


def crossing(a, along_a, b, along_b):
    """Return the intersection of two lines of complex numbers."""
    matrix = np.array([[along_a.real, -along_b.real], [along_a.imag, -along_b.imag]])
    share = np.linalg.solve(matrix, [(b - a).real, (b - a).imag])[0]
    return a + share * along_a


def angle(z):
    return np.angle(z)


def four_bar(theta):
    """Return ball joint, rotation of the upright and instantaneous center of the wishbone."""
    ball = LOWER + (BALL - LOWER) * np.exp(1j * theta)
    to_hinge = UPPER - ball
    kingpin, arm, d = abs(TOP - BALL), abs(TOP - UPPER), abs(to_hinge)
    part = (kingpin**2 + d**2 - arm**2) / (2 * d)
    along = to_hinge / d
    aside = np.sqrt(kingpin**2 - part**2)
    tops = [ball + part * along + way * aside * 1j * along for way in (1, -1)]
    top = min(tops, key=lambda z: abs(z - TOP))
    turn = angle((top - ball) / (TOP - BALL))
    return ball, turn, crossing(LOWER, ball - LOWER, UPPER, top - UPPER)


def strut(theta):
    """The same of the strut, whose axis passes through the tower."""
    ball = LOWER + (BALL - LOWER) * np.exp(1j * theta)
    along = (TOWER - STRUT) / abs(TOWER - STRUT)
    offset = ((BALL - TOWER) / along).imag
    apart = ball - TOWER
    direction = angle(apart) - np.pi + np.arcsin(offset / abs(apart))
    turn = angle(np.exp(1j * direction) / along)
    center = crossing(LOWER, ball - LOWER, TOWER, 1j * np.exp(1j * direction))
    return ball, turn, center


def closed_form(pose, theta, spring_of):
    ball, turn, center = pose(theta)
    wheel = ball + (CENTER - BALL) * np.exp(1j * turn)
    contact = wheel - 1j * RADIUS * np.exp(1j * turn)
    line = crossing(contact, center - contact, 0j, 1j)
    # Rates for a unit rate of the upright's rotation.
    wheel_rate = 1j * (wheel - center)
    length, spring_rate = spring_of(ball, turn, center, theta)
    return {
        "travel": (wheel - CENTER).imag,
        "camber": -turn,
        "toe": 0.0,
        "track_change": (contact - CENTER + 1j * RADIUS).real,
        "wheelbase_change": 0.0,
        "roll_center_height": line.imag - contact.imag,
        "spring_length": length,
        "motion_ratio": -spring_rate / wheel_rate.imag,
    }


def wishbone_spring(ball, turn, center, theta):
    end = LOWER + (SPRING - LOWER) * np.exp(1j * theta)
    arm_rate = ((ball - center) / (ball - LOWER)).real
    apart = end - MOUNT
    return abs(apart), (1j * (end - LOWER) * arm_rate * apart.conjugate()).real / abs(apart)


def strut_spring(ball, turn, center, theta):
    apart = ball + (STRUT - BALL) * np.exp(1j * turn) - TOWER
    rate = 1j * (apart + TOWER - center)
    return abs(apart), (rate * apart.conjugate()).real / abs(apart)


@pytest.mark.parametrize(
    ("suspension", "pose", "spring"),
    [(WISHBONE, four_bar, wishbone_spring), (STRUTTED, strut, strut_spring)],
    ids=["wishbone", "strut"],
)
@pytest.mark.parametrize("side", [1, -1])
def test_in_a_plane_the_curves_are_those_of_the_closed_form(suspension, pose, spring, side):
    expected = [closed_form(pose, theta, spring) for theta in ANGLES]
    wheel = suspension if side == 1 else suspension.mirrored()
    curves = wheel.curves([row["travel"] for row in expected], RADIUS)
    for name in expected[0]:
        values = [row[name] for row in expected]
        np.testing.assert_allclose(getattr(curves, name), values, rtol=1e-11, atol=1e-12)
    assert np.ptp(curves.camber) > 0.01
    assert curves.roll_center_height[2] > 0.01


@pytest.mark.parametrize("kind", SPATIAL)
@pytest.mark.parametrize("rack", [0.0, 0.02])
def test_rates_in_space_are_derivatives_of_the_curves(kind, rack):
    h = 1e-5
    travel = np.linspace(-0.06, 0.06, 7)
    middle, ahead, behind = (
        SPATIAL[kind].curves(travel + step, RADIUS, rack=rack) for step in (0.0, h, -h)
    )
    rate = (behind.spring_length - ahead.spring_length) / (2 * h)
    assert middle.motion_ratio == pytest.approx(rate, rel=1e-7)
    # The contact point moves with the wheel's center, less what the wheel's inclination changes.
    outwards = (ahead.track_change - behind.track_change) / (2 * h)
    height = [z - RADIUS * np.cos(c.camber) for c, z in ((ahead, h), (behind, -h))]
    upwards = (height[0] - height[1]) / (2 * h)
    start = SPATIAL[kind].curves(0.0, RADIUS)
    arm = SPATIAL[kind].wheel_center[1] + RADIUS * np.sin(start.camber) * -1.0
    outside = arm + middle.track_change
    expected = outside * outwards / upwards
    assert middle.roll_center_height == pytest.approx(expected, rel=1e-6)


def test_the_rack_steers_both_wheels_to_one_side():
    left = SPATIAL["wishbone"]
    right = left.mirrored()
    straight = left.curves(0.0, RADIUS).toe
    # The tie rods are behind the axles: with the rack to the left the fronts turn to the right.
    assert left.curves(0.0, RADIUS, rack=0.02).toe > straight + 0.05
    assert right.curves(0.0, RADIUS, rack=0.02).toe < straight - 0.05
    inner = left.curves([-0.04, 0.05], RADIUS, rack=0.02)
    outer = right.curves([-0.04, 0.05], RADIUS, rack=-0.02)
    assert inner.toe == pytest.approx(outer.toe, rel=1e-12)


def test_static_angles_are_those_of_the_wheel_without_travel():
    curves = SPATIAL["strut"].curves(0.0, RADIUS)
    assert (curves.camber[0], curves.toe[0]) == pytest.approx((-0.01, 0.003), rel=1e-12)
    assert curves.caster[0] == pytest.approx(np.arctan(0.03 / 0.67), rel=1e-12)
    assert curves.kingpin_inclination[0] == pytest.approx(np.arctan(0.12 / 0.67), rel=1e-12)
    assert curves.track_change[0] == curves.wheelbase_change[0] == 0.0


def test_beyond_its_reach_a_travel_is_refused():
    with pytest.raises(
        ValueError, match=r"`travel` of 0\.5 m is out of reach: .* beyond about 0\."
    ):
        WISHBONE.curves([0.0, 0.5], RADIUS)
    with pytest.raises(ValueError, match=r"`rack` of 3 m is out of reach"):
        WISHBONE.curves([0.0], RADIUS, rack=3.0)


def test_hard_points_are_checked():
    with pytest.raises(ValueError, match="`lower_outer` must be three finite coordinates"):
        replace(WISHBONE, lower_outer=(0.0, 1.0))
    with pytest.raises(ValueError, match="`upper_front` and `upper_rear` must be different points"):
        replace(WISHBONE, upper_front=WISHBONE.upper_rear)
    with pytest.raises(ValueError, match="`lower_outer` must not lie on the line of `lower_front`"):
        replace(WISHBONE, lower_outer=point(LOWER))
    with pytest.raises(ValueError, match="`wheel_center` must lie at the left"):
        replace(WISHBONE, wheel_center=(0.0, 0.0, 0.3))
    with pytest.raises(ValueError, match="`camber` must be smaller than a right angle"):
        replace(WISHBONE, camber=2.0)
    with pytest.raises(ValueError, match="The hard points leave the wheel no vertical motion"):
        # Both arms stand upright.
        replace(
            WISHBONE, lower_outer=point(LOWER + 0.3j), upper_outer=point(UPPER + 0.3j),
            tie_rod_outer=point(LOWER + 0.3j, -0.12),
        ).curves([0.0], RADIUS)  # fmt: skip


def test_camber_and_toe_are_drawn_in_degrees_over_millimetres():
    curves = WISHBONE.curves([-0.02, 0.0, 0.03], RADIUS)
    camber, toe = curves.plot().lines
    np.testing.assert_allclose(np.radians(camber.get_xdata()), curves.camber)
    np.testing.assert_allclose(np.radians(toe.get_xdata()), curves.toe)
    np.testing.assert_allclose(camber.get_ydata(), [-20.0, 0.0, 30.0], atol=1e-9)
