"""Pages that simulate: numbers as Python's, at once, and a bicycle that falls."""

import numpy as np
import pytest
import sympy as sm
from sympy.physics.mechanics import Point, ReferenceFrame

import zoo
from pydy.examples import bicycle_ride
from pydy.models import n_link_pendulum_on_cart
from pydy.viz import Arrow, Box, Line, Live, Slider, Sphere, Visual
from waiting import until
from zoo import pictured
from zoo.cases import system_of
from zoo.exported_models import ball, hostile, pendulum

TIMES = np.linspace(0.0, 10.0, num=301)


def opened(open_page, folder, system, live, **options):
    scene = system.scene(**options).animate(system.simulate(), fps=None)
    return open_page(scene.to_html(folder / "live.html", live=live))


def states(page):
    return np.array(page.evaluate("pydy.live.states()"))


def calm():
    """A pendulum on a cart that swings about its lowest place, which is not chaotic."""
    system = n_link_pendulum_on_cart(1)
    system.constants = {"g": 9.81, "m1": 0.5}
    system.initial_conditions = {"q1": 3.0}
    system.times = TIMES
    system.ode_solver = "dop853"
    return system


def test_numbers_are_those_of_python(tmp_path, open_page):
    system = calm()
    page = opened(open_page, tmp_path, system, Live({"l0": (0.5, 2), "F": (-1, 1), "q1": (2, 4)}))
    assert states(page) == pytest.approx(system.integrate(rtol=1e-8, atol=1e-8), abs=1e-9)
    page.evaluate("pydy.live.set('l0', 1.3), pydy.live.set('F', 0.2), pydy.live.set('q1', 2.7)")
    system.constants = {**system.constants, "l0": 1.3}
    system.specifieds = {"F": 0.2}
    system.initial_conditions = {"q1": 2.7}
    assert states(page) == pytest.approx(system.integrate(rtol=1e-8, atol=1e-8), abs=1e-9)


def test_outputs_and_expressions_are_plotted_anew(tmp_path, open_page):
    system = pendulum()
    q1 = system.coordinates[1]
    page = opened(open_page, tmp_path, system, {"l0": (0.5, 2)}, series=[q1, "T", sm.sin(q1)])
    page.evaluate("pydy.live.set('l0', 1.4)")
    system.constants = {**system.constants, "l0": 1.4}
    expected = system.simulate(rtol=1e-8, atol=1e-8)
    found = page.evaluate("pydy.live.series()")
    assert found[0] == pytest.approx(expected["q1"], abs=1e-6)
    assert found[1] == pytest.approx(expected["T"], abs=1e-5)
    assert found[2] == pytest.approx(np.sin(expected["q1"]), abs=1e-6)


def test_bodies_are_where_the_new_motion_has_them(tmp_path, open_page):
    system = pendulum()
    page = opened(open_page, tmp_path, system, {"l0": (0.5, 2)})
    page.evaluate("pydy.live.set('l0', 1.6)")
    system.constants = {**system.constants, "l0": 1.6}
    scene = system.scene().animate(system.simulate(rtol=1e-8, atol=1e-8), fps=None)
    for k in (0, 17, 40):
        page.evaluate(f"pydy.seek({scene.times[k]})")
        places = np.array(page.evaluate("pydy.positions()"))
        assert places == pytest.approx(scene.poses[k, :, :3, 3], abs=2e-6)


def test_events_act_as_in_python(tmp_path, open_page):
    system, bounce = ball()
    page = opened(open_page, tmp_path, system, Live({"y": (0.2, 2)}, events=bounce))
    page.evaluate("pydy.live.set('y', 1.5)")
    system.initial_conditions = {"y": 1.5}
    expected = system.simulate(rtol=1e-8, atol=1e-8, events=bounce)
    assert states(page) == pytest.approx(expected.states, abs=1e-9)
    assert page.locator("#events button").count() == len(expected.events) >= 2


def test_constraints_are_held_and_met_from_the_start(tmp_path, open_page):
    system = system_of(zoo.fourbar(), times=TIMES, ode_solver="dop853")
    frame, origin = ReferenceFrame("N"), Point("O")
    scene = system.scene(Visual(Sphere(0.1), origin), reference_frame=frame, origin=origin)
    scene.animate(system.simulate(constraints="project"), fps=None)
    page = open_page(scene.to_html(tmp_path / "live.html", live={"m1": (0.5, 5.0)}))
    expected = system.integrate(rtol=1e-8, atol=1e-8, constraints="project")
    assert states(page) == pytest.approx(expected, abs=1e-9)
    page.evaluate("pydy.live.set('m1', 4.0)")
    system.constants = {**system.constants, sm.Symbol("m1"): 4.0}
    expected = system.integrate(rtol=1e-8, atol=1e-8, constraints="project")
    assert states(page) == pytest.approx(expected, abs=1e-9)


def test_sliders_of_dependent_states_are_kept_and_others_are_solved_for(tmp_path, open_page):
    # A four-bar has one degree of freedom: any of its angles may be the one that is given.
    system = system_of(zoo.fourbar(), times=TIMES, ode_solver="dop853")
    frame, origin = ReferenceFrame("N"), Point("O")
    scene = system.scene(Visual(Sphere(0.1), origin), reference_frame=frame, origin=origin)
    scene.animate(system.simulate(constraints="project"), fps=None)
    angle = float(system.initial_conditions[system.coordinates[2]])
    live = {"q3": (angle - 1.0, angle + 1.0), "u3": (-9.0, 9.0)}
    page = open_page(scene.to_html(tmp_path / "live.html", live=live))
    page.evaluate(f"pydy.live.set('q3', {angle + 0.05}), pydy.live.set('u3', 0.7)")
    start = states(page)[0]
    assert page.evaluate("pydy.live.status") == "finished"
    assert start[[2, 5]] == pytest.approx([angle + 0.05, 0.7], abs=1e-15)
    assert abs(system.evaluate_holonomic_constraints(start, 0.0)).max() < 1e-13
    assert abs(system.evaluate_velocity_constraints(start, 0.0)).max() < 1e-13


def test_hostile_names_stand_on_the_page_as_text(tmp_path, open_page):
    system = hostile()
    sliders = {s: Slider(1, 5, unit="<b>kg</b>") for s in system.constants_symbols}
    page = opened(open_page, tmp_path, system, sliders, title="<i>mass</i>")
    labels = [row.inner_text() for row in page.locator("#live label").all()]
    assert [" ".join(t.split()) for t in labels] == [
        " ".join(s.name.split()) for s in system.constants_symbols
    ]
    assert page.locator("#live b").count() == 0
    name = next(iter(system.constants_symbols)).name
    page.evaluate("(name) => pydy.live.set(name, 4.0)", name)
    assert page.evaluate("pydy.live.status") == "finished"


# -- the demo's bicycle ----------------------------------------------------------------------------


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    path = tmp_path_factory.mktemp("demo") / "bicycle-live.html"
    bicycle_ride.simulate(bicycle_ride.ride(), path)
    return path


def speed_slider(page):
    return page.locator("#live li").filter(has_text="speed").locator("input[type=range]")


def drag(page, value):
    """Drag the speed to a value as a reader does."""
    speed_slider(page).evaluate(
        "(one, value) => { one.value = value; one.dispatchEvent(new Event('input')); }", value
    )


def slow_down(page, times):
    """Let the page's code run so many times slower than the machine can."""
    page.context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": times})


def test_the_bicycle_falls_when_its_speed_is_dragged_down(path, open_page, screenshot):
    page = open_page(path, 1000, 700)
    page.evaluate("pydy.pause()")
    assert page.evaluate("pydy.live.status") == "finished"
    assert abs(page.evaluate("pydy.live.series()[0].at(-1)")) < 2.0  # degrees of roll
    box = speed_slider(page).bounding_box()
    middle = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + box["width"] * 4 / 7, middle)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] * 0.25, middle, steps=6)
    page.mouse.up()
    until(page, "!pydy.live.busy")
    assert 2.0 < page.evaluate("pydy.live.values[0]") < 4.29
    assert page.evaluate("pydy.live.status") == "stopped"
    assert max(map(abs, page.evaluate("pydy.live.series()[0]"))) > 30.0
    page.evaluate("pydy.seek(10)")
    assert np.ptp(screenshot(page, "bicycle-live")) > 60


def test_a_drag_shows_the_new_motion_at_the_moment_that_is_shown(path, open_page):
    page = open_page(path, 320, 260)
    page.evaluate("pydy.pause(), pydy.seek(1.0)")
    places = page.evaluate("pydy.positions()[0]")
    drag(page, 4.5)
    until(page, "!pydy.live.busy")
    assert page.evaluate("pydy.time") == 1.0
    assert page.evaluate("pydy.positions()[0]") != places


@pytest.mark.parametrize("goes_to", [None, 0.01])
def test_a_slow_machine_comes_back_to_the_moment_that_was_shown_or_asked_for(
    path, open_page, goes_to
):
    page = open_page(path, 320, 260)
    page.evaluate("pydy.pause(), pydy.seek(4.0)")
    slow_down(page, 30)
    drag(page, 4.5)
    until(page, f"pydy.live.busy && {goes_to or 0.0} < pydy.time && pydy.time < 4.0")
    if goes_to is not None:
        page.evaluate(f"pydy.seek({goes_to})")
    slow_down(page, 1)
    until(page, "!pydy.live.busy")
    assert page.evaluate("pydy.time") == (4.0 if goes_to is None else goes_to)


def test_boxes_take_numbers_and_resets_bring_them_back(path, open_page):
    page = open_page(path)
    row = page.locator("#live li").filter(has_text="speed")
    row.locator("input[type=number]").fill("9.5")
    until(page, "pydy.live.values[0] === 9.5 && !pydy.live.busy")
    row.get_by_label("Reset speed").click()
    until(page, "pydy.live.values[0] === 5")


def test_a_live_page_fits_a_phone_in_the_dark(path, open_page, screenshot):
    page = open_page(path, 390, 844, color_scheme="dark", has_touch=True, device_scale_factor=2)
    page.locator("#live .toggle").click()
    assert page.locator("#live ul").is_visible()
    screenshot(page, "bicycle-live-phone")


def test_on_a_phone_the_parameters_are_below_the_picture(open_page, tmp_path):
    states = pictured.system_of("Planar double pendulum").states
    scene = pictured.animated("Planar double pendulum")
    path = scene.to_html(tmp_path / "phone.html", live={states[1]: (-3.0, 3.0)})
    page = open_page(path, width=390, height=760)
    page.click("#live .toggle")
    panel, canvas = page.locator("#live").bounding_box(), page.locator("#stage").bounding_box()
    assert page.locator("#live li").first.is_visible()
    assert panel["y"] >= canvas["y"] + canvas["height"] - 1
    assert canvas["height"] > 150
    page.set_viewport_size({"width": 1000, "height": 700})
    until(page, "document.getElementById('view').contains(document.getElementById('live'))")


# -- the picture is what the panel leaves free -----------------------------------------------------


@pytest.fixture(scope="module")
def wide_box(tmp_path_factory):
    """A page with a red box at rest, wider than high, in the middle of what is seen."""
    system, _ = ball()
    frame, origin = ReferenceFrame("N"), Point("O")
    box = Visual(Box(4.0, 1.0, 0.5, colour="#ff0000"), frame, origin)
    scene = system.scene(box, reference_frame=frame, origin=origin, up="y", ground=False)
    scene.animate(system.simulate())
    path = tmp_path_factory.mktemp("panel") / "box.html"
    return scene.to_html(path, live={"y": (0.2, 2.0)}, theme="light")


def red_part(page, screenshot):
    """The first and past the last of the columns, and of the rows, that show the box."""
    page.wait_for_timeout(200)  # for the observer of sizes, and the next frame
    red, green, blue = np.moveaxis(screenshot(page, "live-box"), 2, 0)
    rows, columns = np.nonzero((red > 1.5 * green) & (red > 1.5 * blue) & (red > 100.0))
    # The legend's key and the tip of an axis are red too: they are small.
    wide = np.bincount(columns, minlength=red.shape[1]) > 30
    high = np.bincount(rows, minlength=red.shape[0]) > 60
    return [(int(np.flatnonzero(hit)[0]), int(np.flatnonzero(hit)[-1]) + 1) for hit in (wide, high)]


def assert_fills(page, screenshot, left):
    """The box's face is in the middle of what is right of `left`, and takes most of its width."""
    canvas = page.locator("#stage").bounding_box()
    (first, last), (top, bottom) = red_part(page, screenshot)
    free = canvas["width"] - left
    assert (first + last) / 2 == pytest.approx(left + free / 2, abs=2.0)
    assert (top + bottom) / 2 == pytest.approx(canvas["height"] / 2, abs=2.0)
    assert last - first == pytest.approx(0.86 * free, abs=3.0)  # FILL in stage.js


def test_a_long_heading_does_not_reach_the_parameters(open_page, tmp_path):
    system = pendulum()
    scene = system.scene(title="A pendulum whose length is changed. " * 4)
    page = scene.animate(system.simulate(), fps=None).to_html(
        tmp_path / "live.html", live={"l0": (0.5, 2)}
    )
    page = open_page(page, width=700, height=600)
    heading, panel = (page.locator(s).bounding_box() for s in ("#heading", "#live"))
    assert heading["y"] + heading["height"] <= panel["y"]


def test_the_scene_is_fitted_beside_the_panel_and_into_all_without_it(
    wide_box, open_page, screenshot
):
    page = open_page(wide_box, 1100, 700)
    page.evaluate("pydy.pause()")
    page.keyboard.press("a")  # no axes
    page.keyboard.press("z")
    panel = page.locator("#live").bounding_box()
    edge = panel["x"] + panel["width"]
    assert edge == 280.0
    assert_fills(page, screenshot, edge)
    page.locator("#live .toggle").click()
    assert_fills(page, screenshot, 0.0)
    page.locator("#live .toggle").click()
    assert_fills(page, screenshot, edge)
    page.set_viewport_size({"width": 800, "height": 700})
    assert_fills(page, screenshot, edge)
    page.set_viewport_size({"width": 1000, "height": 760})
    assert_fills(page, screenshot, edge)
    page.keyboard.press("r")
    page.keyboard.press("z")
    assert_fills(page, screenshot, edge)


def test_a_saved_picture_is_the_part_that_the_panel_leaves_free(wide_box, open_page, tmp_path):
    page = open_page(wide_box, 1100, 700)
    page.evaluate("pydy.pause()")
    page.keyboard.press("z")
    with page.expect_download() as waiting:
        page.keyboard.press("s")
    waiting.value.save_as(tmp_path / "box.png")
    from PIL import Image

    with Image.open(tmp_path / "box.png") as picture:
        pixels = np.asarray(picture.convert("RGB"), dtype=float)
    assert pixels.shape[1] == 1100 - 280
    columns = np.flatnonzero((pixels[..., 0] > 1.5 * pixels[..., 1]).sum(axis=0) > 30)
    assert (columns[0] + columns[-1] + 1) / 2 == pytest.approx(pixels.shape[1] / 2, abs=2.0)


def test_a_reader_keeps_the_view_when_the_panel_is_closed_and_opened(wide_box, open_page):
    page = open_page(wide_box, 1100, 700)
    page.evaluate("pydy.pause()")
    page.mouse.move(700, 300)
    page.mouse.down()
    page.mouse.move(800, 350, steps=4)
    page.mouse.up()
    page.mouse.wheel(0, -300)
    seen = []

    def at_rest():
        page.evaluate(
            "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
        )
        seen.append(page.evaluate("pydy.camera()"))
        return seen[-1] in seen[-2:-1]

    until(page, at_rest)  # the swing ends
    before = np.array(page.evaluate("pydy.camera()"))
    page.locator("#live .toggle").click()
    closed = np.array(page.evaluate("pydy.camera()"))
    page.locator("#live .toggle").click()
    after = np.array(page.evaluate("pydy.camera()"))
    directions = [(eye - at) / np.linalg.norm(eye - at) for eye, at in (before, closed, after)]
    assert directions[1] == pytest.approx(directions[0], abs=1e-12)
    assert after == pytest.approx(before, rel=1e-12, abs=1e-12)


# -- the ground is below the motion ----------------------------------------------------------------


def longer(system, length):
    """The heights of the bobs when the links of the pendulum have a length, (instants, 3)."""
    system.constants = {**system.constants, "l0": length}
    trajectory = system.simulate(rtol=1e-8, atol=1e-8)
    return system.scene().animate(trajectory, fps=None).poses[:, :3, 1, 3]


def bobs(*more, **options):
    """The pendulum, of which the balls of its bobs and what is given are seen, and its scene."""
    system = pendulum()
    plain = system.scene()
    points = [visual.point for visual in plain.visuals[:3]]
    balls = [Visual(Sphere(0.1), point) for point in points]
    scene = system.scene(*balls, *(make(plain.reference_frame, points) for make in more), **options)
    return system, scene.animate(system.simulate(), fps=None)


def test_the_ground_is_lowered_with_the_motion_and_raised_again(open_page, tmp_path):
    system, scene = bobs()
    page = open_page(scene.to_html(tmp_path / "live.html", live={"l0": (0.1, 3.0)}), 320, 260)
    first = page.evaluate("pydy.ground")
    assert first == pytest.approx(longer(system, 0.7).min() - 0.1, abs=2e-6)
    for length in (3.0, 2.0):
        page.evaluate(f"pydy.live.set('l0', {length})")
        lowest = longer(system, length).min() - 0.1
        assert lowest < first - 0.3
        assert page.evaluate("pydy.ground") == pytest.approx(lowest, abs=4e-6)
    page.evaluate("pydy.live.set('l0', 0.1)")  # never above the first
    assert page.evaluate("pydy.ground") == pytest.approx(first, abs=2e-6)
    page.evaluate("pydy.live.set('l0', 0.7)")
    assert page.evaluate("pydy.ground") == first


@pytest.mark.parametrize("ground", [-0.25, 1.0])
def test_a_ground_of_the_users_height_stays(open_page, tmp_path, ground):
    _, scene = bobs(ground=ground)
    page = open_page(scene.to_html(tmp_path / "live.html", live={"l0": (0.1, 3.0)}), 320, 260)
    page.evaluate("pydy.live.set('l0', 3.0)")
    assert page.evaluate("pydy.ground") == ground


def test_the_ground_is_below_solids_that_turn_and_below_lines_and_arrows(open_page, tmp_path):
    def bar(frame, points):
        q1 = pendulum().coordinates[1]
        turning = frame.orientnew("A", "Axis", (q1, frame.z))
        return Visual(Box(0.2, 3.0, 0.1), turning, points[2])

    system, scene = bobs(bar)
    page = open_page(scene.to_html(tmp_path / "bar.html", live={"l0": (0.1, 3.0)}), 320, 260)
    page.evaluate("pydy.live.set('l0', 2.0)")
    boxes = page.evaluate(
        "pydy.times.flatMap((t) => { pydy.seek(t); return pydy.boxes().map((box) => box[0][1]); })"
    )
    lowest = min(boxes)
    assert lowest < longer(system, 2.0).min() - 0.2
    assert page.evaluate("pydy.ground") == pytest.approx(lowest, abs=4e-6)

    length = sm.Symbol("l0")
    for make in (
        lambda frame, points: Visual(Arrow(-length * frame.y, scale=1.0), points[2]),
        lambda frame, points: Visual(
            Line([points[2], points[2].locatenew("Q", -length * frame.y)]), points[2]
        ),
    ):
        system, scene = bobs(make)
        page = open_page(scene.to_html(tmp_path / "more.html", live={"l0": (0.1, 3.0)}), 320, 260)
        page.evaluate("pydy.live.set('l0', 3.0)")
        lowest = longer(system, 3.0).min() - 3.0
        assert page.evaluate("pydy.ground") == pytest.approx(lowest, abs=4e-6)


def test_a_reset_of_the_view_shows_the_motion_and_the_first_one(open_page, tmp_path):
    system, scene = bobs()
    page = open_page(scene.to_html(tmp_path / "live.html", live={"l0": (0.1, 3.0)}), 320, 260)
    eye, target = np.array(page.evaluate("pydy.camera()"))
    page.evaluate("pydy.live.set('l0', 3.0)")
    assert np.array(page.evaluate("pydy.camera()")) == pytest.approx(np.array([eye, target]))
    page.keyboard.press("r")
    seen, middle = np.array(page.evaluate("pydy.camera()"))
    heights = [longer(system, length) for length in (0.7, 3.0)]
    low, high = min(h.min() for h in heights) - 0.1, max(h.max() for h in heights) + 0.1
    assert middle[1] == pytest.approx((low + high) / 2, abs=4e-6)
    assert np.linalg.norm(seen - middle) > 1.5 * np.linalg.norm(eye - target)
    page.evaluate("pydy.live.set('l0', 0.7)")
    page.keyboard.press("r")
    assert np.array(page.evaluate("pydy.camera()")) == pytest.approx(
        np.array([eye, target]), abs=1e-5
    )


def test_a_link_to_a_view_is_followed_by_a_live_page(open_page, tmp_path):
    _, scene = bobs()
    page = open_page(scene.to_html(tmp_path / "live.html", live={"l0": (0.1, 3.0)}), 320, 260)
    page.evaluate("history.replaceState(null, '', '#t=0.5&from=3,4,5&to=0.1,0.2,0.3')")
    page.reload()
    until(page, "window.pydy && window.pydy.live")
    assert page.evaluate("pydy.time") == 0.5
    assert np.array(page.evaluate("pydy.camera()")) == pytest.approx(
        np.array([[3.0, 4.0, 5.0], [0.1, 0.2, 0.3]])
    )
