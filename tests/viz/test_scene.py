"""Scene: its arguments, its motion, and what it refuses."""

import os
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sm
from sympy.physics.mechanics import Particle, Point, ReferenceFrame, dynamicsymbols

from pydy.trajectory import Trajectory
from pydy.viz import Arrow, Line, Plane, Scene, Sphere, Trace, Visual
from pydy.viz.animation import ViewSettings, frame
from pydy.viz.arguments import watchable_speed
from pydy.viz.motion import sampled

q, u = dynamicsymbols("q, u")
l = sm.Symbol("l")
N, O = ReferenceFrame("N"), Point("O")
P = O.locatenew("P", l * sm.sin(q) * N.x - l * sm.cos(q) * N.y)
TIMES = np.linspace(0, 2, 201)
STATES = np.stack([np.sin(TIMES), np.cos(TIMES)], 1)


def swing(*more, **options):
    return Scene(N, O, Visual(Sphere(0.1), P), *more, **options)


@pytest.fixture
def trajectory():
    return Trajectory(
        TIMES,
        STATES,
        {"coordinate": [q], "speed": [u], "output": [sm.Symbol("power")]},
        outputs=TIMES[:, None] ** 2,
        constants={l: 0.5},
    )


def test_a_scene_needs_a_visual():
    with pytest.raises(ValueError, match="needs at least one visual"):
        Scene(N, O).animate(TIMES, STATES, symbols=[q, u])


@pytest.mark.parametrize("path", ["film.gif", Path("page.html")])
def test_a_path_among_the_visuals_is_answered_with_what_writes_files(path):
    with pytest.raises(TypeError, match=r"takes Visuals.*To write a file, call `to_html\(path\)`"):
        Scene(N, O, path)


@pytest.mark.parametrize(("up", "expected"), [("-z", [0, 0, -1]), (2 * N.x, [1, 0, 0])])
def test_up_is_an_axis_or_a_vector(up, expected):
    assert swing(up=up)._settings.up_axis.tolist() == expected


# -- motion ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", ["png", "MP4"])
def test_a_page_is_not_written_under_the_suffix_of_a_picture(tmp_path, suffix):
    with pytest.raises(ValueError, match=r"the name of an HTML file, .*`scene.save\(path\)`"):
        swing().to_html(tmp_path / f"never.{suffix}")
    assert not list(tmp_path.iterdir())


def test_a_scene_at_rest_says_what_to_call():
    scene = swing()
    with pytest.raises(ValueError, match=r"call `scene.animate\(trajectory\)`"):
        scene.to_html("never.html")
    assert scene._repr_html_() is None
    assert "visuals)" in repr(scene)


def test_trajectories_and_arrays_move_it_alike(trajectory):
    first = swing().animate(trajectory)
    second = swing().animate(TIMES, STATES, symbols=[q, u], constants={l: 0.5})
    assert first.times == pytest.approx(second.times)
    assert first.poses == pytest.approx(second.poses)
    x, y = 0.5 * np.sin(np.sin(first.times)), -0.5 * np.cos(np.sin(first.times))
    assert first.poses[:, 0, :2, 3] == pytest.approx(np.stack([x, y], 1), abs=1e-15)


def test_a_trajectory_from_a_file_has_names_for_symbols(trajectory):
    loaded = SimpleNamespace(
        times=TIMES, states=STATES, state_symbols=("q", "u"), constants={"l": 0.5}
    )
    scene = Scene(N, O, Visual(Sphere(l / 5), P))
    assert scene.animate(loaded).poses == pytest.approx(scene.animate(trajectory).poses)


def test_constants_may_be_added(trajectory):
    k = sm.Symbol("k")
    scene = Scene(N, O, Visual(Sphere(k), P)).animate(trajectory, constants={k: 0.3, l: 1.0})
    assert scene._animation.items[0].shape.radius == 0.3
    assert scene.poses[0, 0, 1, 3] == -1.0


def test_constants_are_those_of_the_trajectory_by_symbol_or_name(trajectory):
    drawn = sm.Symbol("w")
    scene = swing(Visual(Sphere(drawn), P))
    half = scene.animate(trajectory, constants={l: 0.25, drawn: 1.0}).poses
    np.testing.assert_array_equal(
        scene.animate(trajectory, constants={"l": 0.25, "w": 1.0}).poses, half
    )
    other = sm.Symbol("l", positive=True)
    for given, message in (
        ({"length": 1.0}, "`constants` has the key `length`, which is not one of the constants of"),
        ({other: 1.0}, "Symbols of one name are different symbols"),
    ):
        with pytest.raises(ValueError, match=message):
            scene.animate(trajectory, constants={drawn: 1.0, **given})
    with pytest.raises(ValueError, match="`specifieds` are those of plain arrays"):
        swing().animate(trajectory, specifieds={"F": 1.0})


def test_plain_arrays_give_nothing_twice():
    call = {"symbols": [q, u], "constants": {l: 1.0}}
    for more in ({"symbols": [q, "q"]},):
        with pytest.raises(ValueError, match="more than once, by the symbol or by its name"):
            swing().animate(TIMES, STATES, **call | more)
    with pytest.raises(ValueError, match="`units` gives `q` more than once"):
        swing(series=[q], units={q: "rad", "q": "deg"})


def test_samples_are_dropped_down_to_sixty_a_second_and_never_made_up():
    scene = swing().animate(TIMES, STATES, symbols=[q, u], constants={l: 1})
    assert np.diff(scene.times).min() >= 1 / 60
    assert set(scene.times) <= set(TIMES)
    assert scene.times[[0, -1]].tolist() == [0, 2]
    assert (
        len(swing().animate(TIMES, STATES, symbols=[q, u], constants={l: 1}, fps=None).times) == 201
    )


def test_sixty_samples_a_second_are_all_kept():
    times = np.arange(3601) / 60
    assert len(sampled(times, 1 / 60)) == 3601


def test_the_last_step_of_an_animation_is_a_half_to_one_and_a_half():
    times = np.arange(108) / 100  # pictures at each tenth, and at the end
    assert sampled(times, 0.1)[-3:].tolist() == [90, 100, 107]
    assert sampled(times[:104], 0.1)[-3:].tolist() == [80, 90, 103]


def test_repeated_times_are_taken_once():
    assert sampled(np.array([0.0, 0.0, 1.0, 1.0]), 0.1).tolist() == [0, 2]
    assert sampled(np.array([3.0]), 0.1).tolist() == [0]


@pytest.mark.parametrize(
    ("duration", "speed"),
    [(5, 1), (60, 1), (0, 1), (0.01, 0.001), (0.5, 0.05), (86400, 1000), (600, 10)],
)
def test_very_short_and_very_long_motions_play_at_a_speed_to_watch(duration, speed):
    assert watchable_speed(duration) == pytest.approx(speed)


def test_a_state_that_is_not_finite_is_named_with_its_time():
    states = STATES.copy()
    states[70:, 1] = np.nan
    with pytest.raises(ValueError, match=r"`u\(t\)` is nan at t = 0.7, index 70"):
        swing().animate(TIMES, states, symbols=[q, u], constants={l: 1})


def test_series_come_from_the_trajectory_or_are_evaluated_or_are_given(trajectory):
    scene = swing(series=[q, "power", 2 * u]).animate(trajectory, series={"extra": -TIMES})
    series = scene._animation.series
    assert list(series) == ["q", "power", "2*u", "extra"]
    for label, expected in (("power", TIMES**2), ("2*u", 2 * np.cos(TIMES)), ("extra", -TIMES)):
        times, values = series[label]
        np.testing.assert_array_equal(times, TIMES)
        assert values == pytest.approx(expected)
    with pytest.raises(
        ValueError, match="`series` has 'heat', which is not one of the trajectory's"
    ):
        swing(series=["heat"]).animate(trajectory)


# -- what the camera sees -------------------------------------------------------------------------


def framed(scene):
    return frame(scene._animation, scene._settings)


def test_the_ground_lies_below_everything_or_where_it_was_put(trajectory):
    assert framed(swing().animate(trajectory)).ground == pytest.approx(-0.6, abs=1e-3)
    assert framed(swing(ground=-2).animate(trajectory)).ground == -2
    assert framed(swing(ground=False).animate(trajectory)).ground is None


def test_plane_motion_is_seen_from_its_side(trajectory):
    seen = framed(swing().animate(trajectory))
    assert seen.right.tolist() == [1, 0, 0]
    assert seen.direction @ [0, 0, 1] > 0.9
    assert framed(swing(view=(1, 0, 0)).animate(trajectory)).direction.tolist() == [1, 0, 0]


def test_a_level_motion_without_a_ground_is_seen_from_above(trajectory):
    """As a mechanism without gravity, whose plane nothing calls a floor."""
    seen = framed(swing(up="z", ground=False).animate(trajectory))
    assert seen.direction @ [0, 0, 1] > 0.9
    assert seen.right.tolist() == [1, 0, 0]
    assert framed(swing(up="z").animate(trajectory)).direction @ [0, 0, 1] < 0.5


def test_the_camera_follows_what_travels_far_unless_told_otherwise():
    times = np.linspace(0, 10, 101)
    states = 5 * times[:, None]
    cart = Visual(Sphere(0.3), O.locatenew("C", q * N.x + sm.sin(q) * N.y))
    for follow, expected in ((None, True), (False, False), (True, True)):
        scene = Scene(N, O, cart, Visual(Plane(100, 100, "y"), O), follow=follow)
        seen = framed(scene.animate(times, states, symbols=[q]))
        assert (seen.path is not None) == expected
    assert seen.path[:, 0] == pytest.approx(states[:, 0])
    assert not seen.path[:, 1].any()  # it keeps its height
    assert framed(Scene(N, O, cart).animate(times, states / 100, symbols=[q])).path is None


@pytest.mark.parametrize("far", [0.0, 40.0, 4000.0])
def test_a_camera_that_follows_frames_what_travels_and_not_what_rests(far):
    times = np.linspace(0, 10, 101)
    cart = Visual(Sphere(0.3), O.locatenew("C", q * N.x))
    post = Visual(Sphere(0.3), O.locatenew("P", far * N.x))
    scene = Scene(N, O, cart, post, follow=True).animate(times, 5 * times[:, None], symbols=[q])
    assert framed(scene).extent == pytest.approx([0.6, 0.6, 0.6])


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
@pytest.mark.parametrize("forward", [0.0, 0.5, 50.0])
def test_a_ball_that_bounces_stays_in_view_and_so_does_the_ground(forward, unit):
    times = np.linspace(0, 5, 301)
    x, y = dynamicsymbols("x, y")
    ball = Visual(Sphere(0.2 * unit), O.locatenew("C", x * N.x + y * N.y))
    states = unit * np.stack([forward * times, 10 * np.abs(np.cos(times))], 1)
    seen = framed(Scene(N, O, ball, up="y").animate(times, states, symbols=[x, y]))
    assert seen.ground == pytest.approx(states[:, 1].min() - 0.2 * unit)
    path = np.zeros((301, 3)) if seen.path is None else seen.path
    assert (seen.path is not None) == (forward == 50)
    away = np.pad(states, ((0, 0), (0, 1))) - path - seen.target
    assert (np.abs(away) <= seen.extent / 2 + 1e-9 * unit).all()
    assert seen.ground >= (seen.target - seen.extent / 2)[1] - 1e-9 * unit


@pytest.mark.parametrize("up", ["x", "-x", "y", "-y", "z", "-z", (1, 2, 3)])
def test_the_camera_stands_upright_whatever_is_up(trajectory, up):
    scene = swing(up=up).animate(trajectory)
    seen = framed(scene)
    assert seen.right @ seen.up_axis == pytest.approx(0, abs=1e-15)
    assert np.linalg.norm(seen.right) == pytest.approx(1)
    assert np.linalg.norm(seen.direction) == pytest.approx(1)
    assert seen.direction @ seen.up_axis > 0


def test_a_scene_without_extent_has_a_size():
    still = Scene(N, O, Visual(Trace(), O)).animate([0.0], np.zeros((1, 0)), symbols=[])
    assert frame(still._animation, ViewSettings(np.array([0.0, 1.0, 0.0]))).radius > 0


@pytest.mark.parametrize("unit", [1e-12, 1.0, 1e12])
def test_the_longer_level_edge_lies_across_the_view_in_every_unit(unit):
    ends = O, O.locatenew("P", unit * (N.x + 2 * N.y + 3 * N.z))
    scene = Scene(N, O, *(Visual(Trace(), end) for end in ends), up="z")
    scene.animate([0.0], np.zeros((1, 0)), symbols=[])
    assert np.abs(framed(scene).right).tolist() == [0, 1, 0]


def test_between_instants_poses_are_interpolated(trajectory):
    B = N.orientnew("B", "Axis", (q, N.z))
    scene = Scene(N, O, Visual(Sphere(1), B, O)).animate([0, 1], [[0.0], [1.0]], symbols=[q])
    turn = scene._animation.at(0.25).items[0].rotations[0]
    assert np.arctan2(turn[1, 0], turn[0, 0]) == pytest.approx(0.25)
    assert scene._animation.at(9).items[0].rotations[0, 1, 0] == pytest.approx(np.sin(1))


def test_visuals_of_one_name_share_a_colour(trajectory):
    bob = Particle("bob", P, 1)
    scene = Scene(
        N, O, Visual(Sphere(0.1), bob), Visual(Line([O, P]), name="bob"), Visual(Trace(), O)
    )
    colours = [item.shape.colour for item in scene.animate(trajectory)._animation.items]
    assert colours[0] == colours[1] != colours[2]


def test_bodies_alone_get_a_default_shape(trajectory):
    scene = Scene(N, O, Particle("bob", P, 1), Visual(Arrow(u * N.x), P)).animate(trajectory)
    assert [type(i.shape).__name__ for i in scene._animation.items] == ["Sphere", "Arrow"]
    assert scene._animation.items[1].vectors[:, 0] == pytest.approx(np.cos(scene.times))


# -- showing --------------------------------------------------------------------------------------


def test_show_opens_a_file_in_the_browser(trajectory, monkeypatch):
    opened = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    path = swing().animate(trajectory).show()
    assert opened == [path.as_uri()]
    assert path.read_text(encoding="utf-8").startswith("<!DOCTYPE html>")


def test_show_deletes_pages_that_have_long_been_read_and_nothing_else(
    trajectory, monkeypatch, tmp_path
):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.setattr("webbrowser.open", lambda address: None)
    scene = swing().animate(trajectory)
    read, recent = scene.show(), scene.show()
    os.utime(read, (0, 0))
    own, linked = tmp_path / "pydy-scene-thesis", tmp_path / "mine"
    for folder in (own, linked):
        folder.mkdir()
        (folder / "scene.html").write_text("mine")
        os.utime(folder / "scene.html", (0, 0))
    (tmp_path / "pydy-scene-abcdefgh").symlink_to(linked)
    shown = scene.show()
    pages = {path for path in tmp_path.rglob("scene.html") if path.parent.name != "mine"}
    assert pages == {recent, shown, own / "scene.html"}
    assert (linked / "scene.html").read_text() == "mine"
    assert not read.parent.exists()


def test_show_displays_inline_in_a_notebook(trajectory, monkeypatch):
    shown = []
    display = SimpleNamespace(HTML=lambda text: text, display=shown.append)
    shell = SimpleNamespace(kernel=object())
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: shell))
    monkeypatch.setitem(sys.modules, "IPython.display", display)
    scene = swing().animate(trajectory)
    scene.show()
    assert shown == [scene]


def test_states_and_constants_go_by_name():
    scene = swing().animate(TIMES, STATES, symbols=["q(t)", "u"], constants={"l": 0.5})
    known = swing().animate(TIMES, STATES, symbols=[q, u], constants={l: 0.5})
    np.testing.assert_array_equal(scene.poses, known.poses)
