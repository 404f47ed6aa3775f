"""The car of the gallery that a reader steers: sliders of inputs, and where the car goes."""

import numpy as np
import pytest

from gallery import definitions
from pydy.viz import Live
from waiting import until


@pytest.fixture(scope="module")
def car():
    return definitions("car_to_steer", "with tempfile")


@pytest.fixture(scope="module")
def path(car, tmp_path_factory):
    scene = car.scene.animate(car.tour, fps=None)
    folder = tmp_path_factory.mktemp("car")
    return scene.to_html(folder / "car.html", live=Live(car.sliders, events=car.stands))


def states(page):
    return np.array(page.evaluate("pydy.live.states()"))


def pull(page, **values):
    for label, value in values.items():
        page.evaluate(
            "([one, value]) => pydy.live.set(one, value)", [label.replace("_", " "), value]
        )


CASES = {
    "as it is": {},
    "to the right": {"steering": -0.1},
    "brakes on ice": {"brakes": 3000.0, "friction": 0.2, "drive": 0.0},
    "a spin": {"drive": 3000.0, "friction": 0.5, "steering": 0.15},
}
INPUTS = {"steering": "delta", "drive": "T_drive", "brakes": "T_brake"}


@pytest.mark.parametrize("name", list(CASES))
def test_the_car_drives_as_in_python(car, path, open_page, name):
    page = open_page(path, 320, 260)
    pull(page, **CASES[name])
    inputs = {"delta": 0.06, "T_drive": 300.0}
    inputs |= {INPUTS[label]: v for label, v in CASES[name].items() if label in INPUTS}
    car.system.constants["mu"] = CASES[name].get("friction", 0.9)
    expected = car.drive(8.0, **inputs)
    found = states(page)[: len(expected.times)]
    ends = len(expected.times) < 401  # then the last row of the page is the last that it shows
    assert page.evaluate("pydy.live.status") == ("stopped" if ends else "finished")
    # Where a locked wheel starts to slide, a step has the accuracy of the kink there.
    assert found[:-1] == pytest.approx(expected.states[:-1], rel=1e-5, abs=1e-5)
    assert ends == (name in ("brakes on ice", "a spin"))  # it stands, or it looks back


def test_the_speed_at_the_start_is_that_of_body_and_wheels(path, open_page):
    page = open_page(path, 320, 260)
    pull(page, start_speed=30.0)
    start = states(page)[0]
    assert start[5] == 30.0
    assert start[8:] == pytest.approx([30.0 / 0.344] * 4, rel=1e-15)


def test_dragging_the_steering_turns_the_wheels_and_the_car(path, open_page, screenshot):
    page = open_page(path, 1000, 700)
    page.evaluate("pydy.pause(), pydy.seek(4)")
    wheel = page.evaluate("pydy.names.indexOf('front wheels')")

    def heading(k):
        return np.reshape(page.evaluate("pydy.matrices()")[k], (4, 4))[:, :3][0]  # the x axis

    slider = page.locator("#live li").filter(has_text="steering").locator("input[type=range]")
    box = slider.bounding_box()
    middle = box["y"] + box["height"] / 2
    turned = []
    for share in (0.45, 0.7):
        page.mouse.click(box["x"] + box["width"] * share, middle)
        until(page, "!pydy.live.busy")
        body, front = heading(0), heading(wheel)
        turned.append(np.cross(body, front)[2])
        angle = page.evaluate("pydy.live.values[0]")
        assert np.cross(body, front)[2] == pytest.approx(np.sin(angle), abs=1e-6)
    assert turned[0] < 0.0 < turned[1]
    assert np.ptp(screenshot(page, "car-to-steer")) > 60
