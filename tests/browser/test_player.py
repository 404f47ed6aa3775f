"""The player: buttons, slider, keys, strip, legend; and what a pendulum does meanwhile."""

import numpy as np
import pytest
import sympy as sm
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from pydy.viz import Line, Scene, Sphere, Visual
from waiting import until

TIMES = np.linspace(0, 3, 181)
ANGLES = np.stack([np.sin(2 * TIMES), 0.5 * np.cos(3 * TIMES)], 1)


def closed_form(t):
    """Where the two bobs of the pendulum are: NumPy alone, no frames."""
    a, b = np.sin(2 * t), 0.5 * np.cos(3 * t)
    first = np.array([np.sin(a), -np.cos(a), 0])
    return [first, first + 0.5 * np.array([np.sin(a + b), -np.cos(a + b), 0])]


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    a, b, l = *dynamicsymbols("a, b"), sm.Symbol("l")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (a, N.z))
    B = A.orientnew("B", "Axis", (b, A.z))
    P = O.locatenew("P", -l * A.y)
    Q = P.locatenew("Q", -l / 2 * B.y)
    scene = Scene(
        N, O,
        Visual(Sphere(l / 10), A, P, name="first"),
        Visual(Sphere(l / 10), B, Q, name="second", trail=True),
        Visual(Line([O, P, Q], radius=l / 50), name="rods"),
        title="Double pendulum",
        series=[a, b],
    )  # fmt: skip
    scene.animate(TIMES, ANGLES, symbols=[a, b], constants={l: 1.0})
    return scene.to_html(tmp_path_factory.mktemp("player") / "pendulum.html")


def at(page):
    return page.evaluate("pydy.time")


def test_positions_are_the_closed_form(path, open_page):
    page = open_page(path)
    for t in TIMES[[0, 31, 90, 180]]:
        page.evaluate(f"pydy.seek({t})")
        assert page.evaluate("pydy.positions()")[:2] == pytest.approx(
            np.array(closed_form(t)), abs=1e-6
        )
    # Between two samples, an arc is cut short by at most a·h²/8.
    page.evaluate("pydy.seek(1.2345)")
    assert page.evaluate("pydy.positions()")[:2] == pytest.approx(
        np.array(closed_form(1.2345)), abs=1e-3
    )


def test_it_plays_by_itself_pauses_and_plays(path, open_page):
    page = open_page(path)
    until(page, "pydy.time > 0.1")
    page.click("#play")
    t = at(page)
    page.wait_for_timeout(200)
    assert at(page) == t
    assert page.get_attribute("#play", "aria-label") == "Play"
    page.click("#play")
    until(page, f"pydy.time !== {t}")


def test_who_wants_less_motion_starts_it_by_hand(path, open_page):
    page = open_page(path, reduced_motion="reduce")
    page.wait_for_timeout(200)
    assert at(page) == 0


def test_the_slider_scrubs(path, open_page):
    page = open_page(path)
    page.evaluate("pydy.pause()")
    box = page.locator("#time").bounding_box()
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    assert at(page) == pytest.approx(1.5, abs=0.05)
    until(page, "document.getElementById('clock').innerText.startsWith('1.')")


def test_the_strip_scrubs_and_shows_values(path, open_page):
    page = open_page(path)
    box = page.locator("#strip-cursor").bounding_box()
    left, width = box["x"] + 46, box["width"] - 54
    page.mouse.move(left, box["y"] + 40)
    page.mouse.down()
    page.mouse.move(left + width / 3, box["y"] + 40)
    page.mouse.up()
    assert at(page) == pytest.approx(1.0, abs=0.02)
    page.evaluate("pydy.seek(1)")
    values = [float(b) for b in page.locator("#strip-labels b").all_inner_texts()]
    assert values == pytest.approx([np.sin(2), 0.5 * np.cos(3)], abs=1e-3)


def test_keys_do_what_the_help_says(path, open_page):
    page = open_page(path)
    page.keyboard.press("Space")
    assert not page.evaluate("pydy.playing")
    for key, expected in [
        ("Home", 0), ("ArrowRight", 1 / 60), ("ArrowRight", 2 / 60), ("ArrowLeft", 1 / 60),
        ("Shift+ArrowRight", 1 + 1 / 60), ("End", 3), ("Shift+ArrowLeft", 2),
    ]:  # fmt: skip
        page.keyboard.press(key)
        assert at(page) == pytest.approx(expected, abs=1e-9), key
    page.keyboard.press("+")
    assert page.input_value("#speed") == "2"
    page.keyboard.press("-")
    page.keyboard.press("-")
    assert page.input_value("#speed") == "0.5"
    for key, name in (
        ("g", "Ground"),
        ("a", "Axes"),
        ("l", "Loop"),
        ("t", "Trails"),
        ("p", "Plot"),
    ):
        button = page.locator(f"#switches button[title^='{name}']")
        before = button.get_attribute("aria-pressed")
        page.keyboard.press(key)
        assert button.get_attribute("aria-pressed") != before, name
    assert page.locator("#strip").is_hidden()
    page.keyboard.press("?")
    assert page.locator("#help").is_visible()
    assert "play or pause" in page.locator("#help").inner_text()
    page.keyboard.press("Escape")
    assert page.locator("#help").is_hidden()


def test_a_space_on_a_focused_button_presses_that_button_only(path, open_page):
    page = open_page(path)
    page.evaluate("pydy.pause()")
    page.focus("#legend-toggle")
    page.keyboard.press("Space")
    assert page.locator("#legend-rows").is_hidden()
    assert not page.evaluate("pydy.playing")


def test_the_end_is_the_beginning_or_the_end(path, open_page):
    page = open_page(path)
    page.evaluate("pydy.seek(2.9); pydy.play()")
    until(page, "pydy.time < 2.9")
    page.keyboard.press("l")
    page.evaluate("pydy.seek(2.9); pydy.play()")
    until(page, "pydy.time === 3 && !pydy.playing")


def test_the_legend_hides_and_shows(path, open_page, screenshot):
    page = open_page(path)
    page.evaluate("pydy.seek(1)")
    shown = screenshot(page, "legend", "#stage")
    row = page.locator("#legend-rows .shown").first
    row.click()
    assert row.get_attribute("aria-pressed") == "false"
    until(page, lambda: np.abs(screenshot(page, "legend", "#stage") - shown).max() > 60)
    row.click()
    until(page, lambda: np.abs(screenshot(page, "legend", "#stage") - shown).mean() < 1)


def test_dragging_turns_the_view_and_r_turns_it_back(path, open_page):
    page = open_page(path)
    page.evaluate("pydy.seek(1)")
    before = page.evaluate("pydy.camera()")
    page.mouse.move(400, 300)
    page.mouse.down()
    page.mouse.move(480, 340, steps=4)
    page.mouse.up()
    until(page, f"Math.abs(pydy.camera()[0][0] - {before[0][0]}) > 0.3")
    page.keyboard.press("r")
    until(page, lambda: np.allclose(page.evaluate("pydy.camera()"), before, rtol=1e-6))


def test_the_wheel_zooms(path, open_page):
    page = open_page(path)
    page.evaluate("pydy.seek(1)")
    z = page.evaluate("pydy.camera()[0][2]")
    page.mouse.move(400, 250)
    page.mouse.wheel(0, 400)
    until(page, f"pydy.camera()[0][2] > 1.1 * {z}")


def test_every_control_has_a_name(path, open_page):
    page = open_page(path)
    nameless = page.evaluate(
        """[...document.querySelectorAll('button, input, select')].filter((e) =>
            !e.getAttribute('aria-label') && !e.innerText.trim() && !e.labels?.length).length"""
    )
    assert nameless == 0


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize(
    ("device", "size"), [("phone", (390, 844)), ("desktop", (1280, 800)), ("sideways", (740, 360))]
)
def test_it_fits_every_screen_in_both_themes(path, open_page, screenshot, scheme, device, size):
    page = open_page(path, *size, color_scheme=scheme, has_touch=device != "desktop")
    page.evaluate("pydy.seek(1)")
    pixels = screenshot(page, f"{device}-{scheme}")
    assert (pixels.mean() > 128) == (scheme == "light")
    assert (np.ptp(pixels, axis=2) > 60).mean() > 0.003
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    assert page.evaluate("document.documentElement.scrollHeight <= innerHeight")
    inside = """[...document.querySelectorAll('#bar button, #bar input, select')].every((e) => {
        const r = e.getBoundingClientRect();
        return r.left >= 0 && r.right <= innerWidth && r.top >= 0 && r.bottom <= innerHeight; })"""
    assert page.evaluate(inside)


def test_a_change_of_theme_is_followed(path, open_page, screenshot):
    page = open_page(path, color_scheme="light")
    page.evaluate("pydy.seek(1)")
    page.emulate_media(color_scheme="dark")
    until(page, lambda: screenshot(page, "theme").mean() < 100)
