"""What leaves the page: pictures, videos, links; what the camera follows; events, scales, units."""

import numpy as np
import pytest
import sympy as sm
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from pydy.trajectory import EventRecord, Trajectory
from pydy.viz import Scene, Sphere, Visual
from waiting import until
from zoo.touching import billiard_ball

x, theta = dynamicsymbols("x, theta_1")
TIMES = np.linspace(0.0, 2.0, 121)
EVIL = "<img src=x onerror=alert(1)>"


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    N, O = ReferenceFrame("N"), Point("O")
    ball = O.locatenew("ball", x * N.x + sm.sin(theta) * N.y)
    rest = np.zeros(2)
    trajectory = Trajectory(
        TIMES,
        np.column_stack([TIMES, 50 * np.sin(4 * TIMES)]),
        {"coordinate": [x, theta]},
        events=[EventRecord(0.5, "bounce", 0, rest, rest), EventRecord(1.5, EVIL, 0, rest, rest)],
    )
    visuals = [Visual(Sphere(0.1), ball), Visual(Sphere(0.2), O, name="foot")]
    scene = Scene(N, O, *visuals, title="Roll & tell", series=[x, theta], units={theta: "rad"})
    scene.animate(trajectory)
    return scene.to_html(tmp_path_factory.mktemp("share") / "share.html")


def test_events_are_marked_on_the_time_axis(path, open_page):
    page = open_page(path)
    marks = page.locator("#events button")
    assert [m.get_attribute("title") for m in marks.all()] == [
        "bounce at 0.5 s",
        f"{EVIL} at 1.5 s",
    ]
    marks.nth(0).click(force=True)
    assert page.evaluate("pydy.time") == 0.5
    assert not page.evaluate("pydy.playing")


def test_modes_of_contacts_are_strips_on_the_time_axis(tmp_path, open_page, screenshot):
    contacts = billiard_ball()
    trajectory = contacts.simulate(rtol=1e-10, atol=1e-10)
    scene = contacts.system.scene(series=["x"]).animate(trajectory)
    page = open_page(scene.to_html(tmp_path / "ball.html"))
    parts = page.locator("#modes button")
    assert parts.all_inner_texts() == ["table slides +", "table sticks"]
    boxes = [part.bounding_box() for part in parts.all()]
    rolls = trajectory.modes[1][0]
    assert boxes[0]["width"] / (boxes[0]["width"] + boxes[1]["width"]) == pytest.approx(
        rolls / 0.5, abs=0.01
    )
    parts.nth(1).click()
    assert page.evaluate("pydy.time") == pytest.approx(rolls)
    screenshot(page, "modes")


def test_curves_of_different_size_have_scales_of_their_own(path, open_page, screenshot):
    page = open_page(path)
    labels = page.locator("#strip-labels li")
    assert labels.nth(0).inner_text().startswith("x")
    assert labels.nth(1).inner_text().startswith("θ1 (rad)")
    assert labels.nth(1).locator("sub").inner_text() == "1"
    assert page.locator("#strip-canvases").bounding_box()["height"] >= 150
    screenshot(page, "strips")


def test_a_link_leads_to_a_moment_and_view(path, open_page):
    page = open_page(path)
    page.evaluate("pydy.seek(0.75)")
    page.mouse.move(300, 200)
    page.mouse.down()
    page.mouse.move(380, 240, steps=3)
    page.mouse.up()
    # At once, while the view still swings on: the link's view is the one that stays.
    link, camera = page.evaluate("[pydy.moment, pydy.camera()]")
    page.keyboard.press("c")
    until(page, "location.hash.length > 10")
    page.evaluate("pydy.seek(0); history.replaceState(null, '', '#')")
    page.keyboard.press("r")
    page.evaluate(f"location.hash = {link!r}")
    until(page, "pydy.time === 0.75")
    assert np.array(page.evaluate("pydy.camera()")) == pytest.approx(np.array(camera), abs=1e-3)
    page.evaluate("location.hash = 't=nonsense&from=1,2&to=x'")
    page.wait_for_timeout(100)
    assert page.evaluate("pydy.time") == 0.75


def test_a_picture_is_saved(path, open_page, tmp_path):
    from PIL import Image

    page = open_page(path)
    with page.expect_download() as waiting:
        page.keyboard.press("s")
    assert waiting.value.suggested_filename == "roll-tell.png"
    waiting.value.save_as(tmp_path / "picture.png")
    pixels = np.asarray(Image.open(tmp_path / "picture.png").convert("RGB"), dtype=float)
    assert np.ptp(pixels) > 100


def test_a_video_is_recorded_from_the_beginning_to_the_end(path, open_page, tmp_path):
    page = open_page(path)
    page.evaluate("pydy.setSpeed(2)")
    with page.expect_download(timeout=60000) as waiting:
        page.keyboard.press("v")
        assert page.locator(".recording").count() == 1
    waiting.value.save_as(tmp_path / "video.webm")
    assert waiting.value.suggested_filename == "roll-tell.webm"
    assert (tmp_path / "video.webm").read_bytes()[:4] == b"\x1a\x45\xdf\xa3"  # EBML
    assert page.evaluate("pydy.time") == 2.0
    assert page.locator(".recording").count() == 0


def test_the_camera_follows_a_body(path, open_page):
    page = open_page(path)
    page.evaluate("pydy.seek(0)")
    page.get_by_label("Follow ball").click()
    for time in (0.0, 1.0, 2.0):
        page.evaluate(f"pydy.seek({time})")
        target = page.evaluate("pydy.camera()")[1]
        assert target == pytest.approx(page.evaluate("pydy.positions()")[0], abs=1e-5)
    page.get_by_label("Follow ball").click()
    page.evaluate("pydy.seek(0)")
    assert page.evaluate("pydy.camera()")[1] == pytest.approx(target)


@pytest.mark.parametrize("width", [320, 390, 640, 760])
def test_all_buttons_are_in_the_picture(path, open_page, screenshot, width):
    page = open_page(path, width=width, height=700, color_scheme="dark")
    for button in page.locator("#bar button, #bar select").all():
        box = button.bounding_box()
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= width
        assert box["y"] + box["height"] <= 700
    assert page.locator("#time").bounding_box()["width"] > 0.8 * width
    screenshot(page, f"dark-{width}")
