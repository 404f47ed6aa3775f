"""The demo's page: the bicycle where NumPy says it is, at a cost that leaves time for more."""

import numpy as np
import pytest

from pydy.examples import bicycle_ride
from pydy.examples.whipple_bicycle import BENCHMARK
from waiting import until


@pytest.fixture(scope="module")
def ride():
    return bicycle_ride.ride()


@pytest.fixture(scope="module")
def path(ride, tmp_path_factory):
    path = tmp_path_factory.mktemp("demo") / "bicycle.html"
    bicycle_ride.animate(ride, path)
    return path


def rotation(axis, angle):
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([[c, -s], [s, c]])
    k = "xyz".index(axis)
    full = np.eye(3)
    places = [(k + 1) % 3, (k + 2) % 3]
    full[np.ix_(places, places)] = turn
    return full


def hubs(x, y, psi, phi, delta, theta):
    """Return the centres of both wheels, from the drawing in `whipple_bicycle` alone."""
    w, c, lam, r_R, r_F = (BENCHMARK[k] for k in ("w", "c", "lam", "r_R", "r_F"))
    E = rotation("z", psi) @ rotation("x", phi)
    rear = np.array([x, y, 0]) - r_R * E[:, 2]
    S = E @ rotation("y", theta + lam)
    K = S @ rotation("z", delta)
    # Upright, in (x, z): the steer axis meets the ground at (w + c, 0).
    along = np.array([np.sin(lam), np.cos(lam)])
    across = np.array([np.cos(lam), -np.sin(lam)])
    foot = np.array([w + c, 0])
    to_axis, to_front = foot - [0, -r_R], np.array([w, -r_F]) - foot
    front = rear + (to_axis @ across) * S[:, 0] + (to_axis + to_front) @ along * S[:, 2]
    return rear, front + (to_front @ across) * K[:, 0]


def test_the_wheels_are_where_numpy_says(ride, path, open_page, screenshot):
    page = open_page(path, 1280, 800)
    names = page.evaluate("pydy.names")
    places = [names.index("rear wheel"), names.index("front wheel")]
    times = page.evaluate("pydy.times")
    assert set(times) <= set(ride.times.tolist())
    trajectory = ride.trajectory
    for t in times[:: len(times) // 6]:
        page.evaluate(f"pydy.seek({t})")
        k = int(np.argmin(np.abs(ride.times - t)))
        state = [trajectory[name][k] for name in ("x", "y", "psi", "phi", "delta", "theta")]
        found = np.array(page.evaluate("pydy.positions()"))[places]
        assert found == pytest.approx(np.array(hubs(*state)), abs=2e-5), t
    page.evaluate("pydy.seek(1.7)")
    assert (np.ptp(screenshot(page, "bicycle"), axis=2) > 60).mean() > 0.01


def test_scrubbing_and_playing_agree(path, open_page):
    page = open_page(path)
    until(page, "pydy.time > 0.3")
    page.evaluate("pydy.pause()")
    played = page.evaluate("[pydy.time, pydy.positions()]")
    page.evaluate(f"pydy.seek(0); pydy.seek({played[0]})")
    assert np.array(page.evaluate("pydy.positions()")) == pytest.approx(np.array(played[1]))


def test_a_frame_takes_few_commands_of_the_graphics_card(path, open_page):
    # What they take is a matter of the machine, and `make bench-pages` says it.
    page = open_page(path)
    until(page, "pydy.costs().frames >= 3")
    assert 0 < page.evaluate("pydy.costs().calls") <= 100
    page.evaluate("pydy.pause()")
    # Counted in the browser's own frames, since a slow machine draws the last one late.
    page.evaluate("""() => {
        let last = pydy.costs().frames;
        window.unchanged = 0;
        const look = () => {
            const now = pydy.costs().frames;
            window.unchanged = now === last ? window.unchanged + 1 : 0;
            last = now;
            requestAnimationFrame(look);
        };
        look();
    }""")
    until(page, "window.unchanged > 10")  # nothing is drawn where nothing moves


def test_the_bicycle_in_the_dark_on_a_phone(path, open_page, screenshot):
    page = open_page(path, 390, 844, color_scheme="dark", has_touch=True, device_scale_factor=2)
    page.evaluate("pydy.seek(1.7)")
    assert (np.ptp(screenshot(page, "bicycle-phone"), axis=2) > 60).mean() > 0.01
