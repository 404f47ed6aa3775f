"""Lane changes: the tracks of ISO 3888, the driver, and which cones are touched."""

import numpy as np
import pytest

from pydy.vehicles import (
    CARS,
    LinearTire,
    SingleTrackCar,
    double_track,
    lane_change,
    linear_handling,
    single_track,
)

CAR = SingleTrackCar(1500, 2500, 1.2, 1.5, 90e3, 110e3)
WIDTH = 1.8


def lanes_of(change):
    """Return start, end, right and left edge of each lane."""
    rows = change.cones.reshape(3, 2, -1, 2)  # lanes, left and right
    return [
        (left[0, 0], left[-1, 0], right[0, 1], left[0, 1])
        for left, right in rows
        if (left[:, 0] == right[:, 0]).all()
    ]


def test_the_double_lane_change_has_the_dimensions_of_the_standard():
    # ISO 3888-1, table 1: lengths 15, 30, 25, 25, 15 and 15 m, widths by that of the car.
    lanes = np.array(lanes_of(lane_change(single_track(CAR, speed=15.0), WIDTH)))
    assert lanes[:, :2] == pytest.approx(np.array([[0, 15], [45, 70], [95, 125]]))
    assert lanes[:, 3] - lanes[:, 2] == pytest.approx([2.23, 2.41, 2.59])
    assert lanes[:, 2] - lanes[0, 2] == pytest.approx([0.0, 3.5, 0.0])


def test_the_obstacle_avoidance_has_the_dimensions_of_the_standard():
    # ISO 3888-2, table 1: lengths 12, 13.5, 11, 12.5 and 12 m; the last lane is 3 m wide at least.
    change = lane_change(single_track(CAR, speed=10.0), WIDTH, track="ISO 3888-2")
    lanes = np.array(lanes_of(change))
    assert lanes[:, :2] == pytest.approx(np.array([[0, 12], [25.5, 36.5], [49, 61]]))
    assert lanes[:, 3] - lanes[:, 2] == pytest.approx([2.23, 2.8, 3.0])
    assert lanes[1, 2] - lanes[0, 3] == pytest.approx(1.0)
    assert lanes[2, 3] == pytest.approx(lanes[0, 3])
    wide = lanes_of(lane_change(single_track(CAR, speed=10.0), 2.4, track="ISO 3888-2"))
    assert wide[2][3] - wide[2][2] == pytest.approx(1.3 * 2.4 + 0.25)


@pytest.mark.parametrize("speed", [8.0, 25.0])
def test_the_gain_is_the_angle_of_a_steady_turn_for_its_curvature(speed):
    gain = CAR.wheelbase + linear_handling(CAR, speed).understeer_gradient * speed**2
    system = single_track(CAR, speed=speed)
    usual, explicit = (lane_change(system, WIDTH, gain=g) for g in (None, gain))
    assert usual.angles == pytest.approx(explicit.angles, abs=1e-7)
    assert np.abs(usual.angles).max() > 0.01


def test_the_driver_steers_by_the_error_at_the_preview_point():
    speed, preview, gain = 12.0, 0.7, 3.0
    change = lane_change(single_track(CAR, speed=speed), WIDTH, preview=preview, gain=gain)
    x, y, psi = (np.asarray(change.trajectory[name]) for name in ("x", "y", "psi"))
    ahead = speed * preview
    # On the middles of the first and the last lane, and before.
    straight = (x + ahead < 15.0) | (x > 95.0)
    middle = np.where(x < 50.0, 0.0, (-2.23 / 2 - 2.23 / 2 + 2.59) / 2)
    error = (middle - y - ahead * np.sin(psi)) * np.cos(psi)
    assert change.angles[straight] == pytest.approx((2 * gain * error / ahead**2)[straight])


def test_a_car_with_a_short_preview_begins_before_the_first_cones_too():
    change = lane_change(single_track(CAR, speed=8.0), WIDTH, length=5.0, preview=0.3)
    first = change.cones[:, 0] == 0.0
    assert float(change.trajectory["x"][0]) < -2.5
    assert change.clearances[first] == pytest.approx((1.1 * WIDTH + 0.25 - WIDTH) / 2)


@pytest.mark.parametrize(("speed", "track"), [(20.0, "ISO 3888-1"), (14.0, "ISO 3888-2")])
def test_a_cone_is_touched_where_it_is_inside_the_outline(speed, track):
    change = lane_change(single_track(CAR, speed=speed), WIDTH + 0.3, track=track)
    x, y, psi = (np.asarray(change.trajectory[name]) for name in ("x", "y", "psi"))
    inside = []
    for cone in change.cones:
        # The corners of the outline turn to the left around a point inside.
        local = np.array([[2.25, -1.05], [2.25, 1.05], [-2.25, 1.05], [-2.25, -1.05]])
        cos, sin = np.cos(psi)[:, None], np.sin(psi)[:, None]
        corners = np.stack(
            [
                x[:, None] + cos * local[:, 0] - sin * local[:, 1],
                y[:, None] + sin * local[:, 0] + cos * local[:, 1],
            ]
        )
        edges = np.roll(corners, -1, axis=2) - corners
        away = cone[:, None, None] - corners
        inside.append((edges[0] * away[1] - edges[1] * away[0] > 0.0).all(axis=1).any())
    touched = change.clearances < 0.0
    assert not np.isnan(change.clearances).any()
    # A cone that the whole car passes on its wrong side is touched, but not inside.
    assert (touched | ~np.array(inside)).all()
    assert change.passed == (not touched.any())


def test_a_slow_car_passes_and_a_fast_one_does_not():
    slow, fast = (lane_change(single_track(CAR, speed=speed), WIDTH) for speed in (15.0, 40.0))
    assert slow.passed
    assert "passed" in repr(slow)
    assert not fast.passed
    assert "touched" in repr(fast)


def test_a_car_with_a_free_speed_and_tires_is_driven_too():
    tire = LinearTire(1500 * 9.81 / 4, 50e3)
    change = lane_change(single_track(CAR, tire, speed=15.0, free_speed=True), WIDTH)
    assert change.passed
    assert change.trajectory["u"][-1] < 15.0  # the front axle brakes in turns


def test_a_plot_marks_the_cones():
    change = lane_change(single_track(CAR, speed=40.0), WIDTH)
    _, _, clear, touched = change.plot().lines
    assert len(clear.get_xdata()) + len(touched.get_xdata()) == len(change.cones)
    assert len(touched.get_xdata()) == (~(change.clearances >= 0.0)).sum()


def test_a_car_that_slows_down_by_its_tires_is_driven_without_a_warning():
    # Rolling resistance and the file's shifts brake it: it starts in no equilibrium.
    car = CARS["bmw_320i"]
    tire = LinearTire(3000, 60e3, 60e3, rolling_resistance=0.004)
    change = lane_change(double_track(car, tire, speed=15.0), 1.61)
    assert change.passed
    assert change.trajectory["u"][-1] < 15.0


def test_a_car_without_a_steering_angle_is_refused():
    with pytest.raises(ValueError, match="`steering` must be one of delta, got 'wheel'"):
        lane_change(single_track(CAR), WIDTH, steering="wheel")
    with pytest.raises(TypeError, match="`position` must be the names of two coordinates"):
        lane_change(single_track(CAR), WIDTH, position=("x", "y"))
