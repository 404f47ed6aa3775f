"""Pictures of cars: where wheels and cones stand, and which cones are red."""

import numpy as np
import pytest

from pydy.vehicles import (
    CARS,
    SingleTrackCar,
    car_trailer,
    double_track,
    lane_change,
    single_track,
)
from pydy.vehicles.scenes import car_scene

CAR = CARS["bmw_320i"]


def wheels(scene, k):
    """Return the places and the axles of the four wheels at an instant."""
    numbers = [n for n, v in enumerate(scene.visuals) if v.name.endswith("wheels")]
    return scene.poses[k, numbers, :3, 3], scene.poses[k, numbers, :3, 1]


@pytest.mark.parametrize("make", [single_track, double_track])
def test_wheels_stand_at_the_axles_and_those_in_front_are_steered(make):
    system = make(CAR, speed=15.0)
    system.specifieds = {**system.specifieds, "delta": 0.1}
    system.times = np.linspace(0.0, 1.0, 11)
    motion = system.simulate()
    scene = car_scene(system, CAR).animate(motion, fps=None)
    x, y, psi = (motion[name][-1] for name in ("x", "y", "psi"))
    assert abs(psi) > 0.2
    cos, sin = np.cos(psi), np.sin(psi)
    local = [
        (forward, side * track / 2)
        for forward, track in ((CAR.front, CAR.front_track), (-CAR.rear, CAR.rear_track))
        for side in (1, -1)
    ]
    expected = [(x + cos * f - sin * l, y + sin * f + cos * l, 0.344) for f, l in local]
    places, axles = wheels(scene, -1)
    assert places == pytest.approx(np.array(expected), abs=1e-12)
    angles = np.arctan2(-axles[:, 0], axles[:, 1])
    assert angles == pytest.approx([psi + 0.1, psi + 0.1, psi, psi], abs=1e-12)


def test_cones_stand_where_the_track_has_them_and_the_touched_ones_are_red():
    system = single_track(CAR, speed=30.0)
    change = lane_change(system, 1.61)
    scene = car_scene(system, CAR, change=change, width=1.61).animate(change.trajectory)
    cones = [(k, v) for k, v in enumerate(scene.visuals) if v.name.endswith("cones")]
    places = scene.poses[0, [k for k, _ in cones], :3, 3]
    assert places[:, :2] == pytest.approx(change.cones)
    assert places[:, 2] == pytest.approx(0.25)  # half of their height
    red = [visual.name == "touched cones" for _, visual in cones]
    assert red == (change.clearances < 0.0).tolist()
    assert 0 < sum(red) < len(red)


def test_a_car_without_track_widths_is_as_wide_as_it_should_be():
    car = SingleTrackCar(1500, 2500, 1.2, 1.5, 90e3, 110e3)
    system = single_track(car)
    places, _ = wheels(car_scene(system, car, width=2.0).animate(system.simulate()), 0)
    assert np.ptp(places[:, 1]) + 0.2 < 2.0  # with the width of a tire


def test_a_trailer_stands_behind_its_hitch():
    car = SingleTrackCar(1500, 2500, 1.2, 1.5, 90e3, 110e3)
    system = car_trailer(
        car, mass=1200, yaw_inertia=2500, hitch=2.5, length=4.0, centre=4.2, stiffness=70e3
    )
    system.specifieds = {"delta": 0.05}
    system.times = np.linspace(0.0, 2.0, 11)
    motion = system.simulate()
    scene = car_scene(system, car, width=1.7).animate(motion, fps=None)
    numbers = [n for n, v in enumerate(scene.visuals) if v.name == "trailer wheels"]
    x, y, psi, phi = (motion[name][-1] for name in ("x", "y", "psi", "phi"))
    assert abs(phi) > 0.005
    assert abs(psi) > 0.1
    axle = np.array([x, y]) - 2.5 * direction(psi) - 4.0 * direction(psi + phi)
    places = scene.poses[-1, numbers, :3, 3]
    assert places.mean(0) == pytest.approx([*axle, 0.33], abs=1e-12)
    aside = direction(psi + phi + np.pi / 2)
    assert (places[0] - places[1])[:2] == pytest.approx(0.88 * 1.7 * aside, abs=1e-12)
    assert any(v.name == "trailer" for v in scene.visuals)
    alone = car_scene(single_track(car), car)
    assert not any("trailer" in v.name for v in alone.visuals)


def direction(angle):
    """Return the horizontal unit vector at an angle from x."""
    return np.array([np.cos(angle), np.sin(angle)])


def test_what_is_no_car_is_refused():
    system = single_track(CAR)
    with pytest.raises(ValueError, match="`steering` must be one of delta, got 'wheel'"):
        car_scene(system, CAR, steering="wheel")
    with pytest.raises(TypeError, match="`change` must be what lane_change returns, or None"):
        car_scene(system, CAR, change=3)
