"""What a reader of the tutorial ends up with: a page with a pendulum that swings."""

import numpy as np
import pytest

from pages import TUTORIAL, script
from waiting import until

LENGTH = 0.5


@pytest.fixture(scope="module")
def tutorial(tmp_path_factory):
    """The names that the tutorial's code defines, run where it may write its files."""
    names = {"__name__": "tutorial"}
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("MPLBACKEND", "agg")
        patch.chdir(tmp_path_factory.mktemp("tutorial"))
        exec(script(TUTORIAL), names)
        names["page"] = names["page"].resolve()
    return names


def test_the_tutorials_pendulum_is_where_its_angle_says(tutorial, open_page, screenshot):
    page = open_page(tutorial["page"])
    bob = page.evaluate("pydy.names").index("bob")
    trajectory = tutorial["trajectory"]
    for t in page.evaluate("pydy.times")[::40]:
        page.evaluate(f"pydy.seek({t})")
        q = np.interp(t, trajectory.times, trajectory["q"])
        place = [LENGTH * np.sin(q), -LENGTH * np.cos(q), 0.0]
        assert page.evaluate("pydy.positions()")[bob] == pytest.approx(place, abs=1e-3), t
    page.evaluate("pydy.seek(0.4)")
    assert np.ptp(screenshot(page, "tutorial")) > 60


def test_the_tutorials_pendulum_plays(tutorial, open_page):
    page = open_page(tutorial["page"])
    until(page, "pydy.time > 0.3")
