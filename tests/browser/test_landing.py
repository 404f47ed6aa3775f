"""The animation of the documentation's landing page."""

import sys
from pathlib import Path

import numpy as np
import pytest

from waiting import until


@pytest.fixture(scope="module")
def landing(tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(Path(__file__).parents[2] / "docs"))
        import generated

        path = tmp_path_factory.mktemp("landing") / "landing.html"
        generated.write_landing(path)
        sys.modules.pop("generated")
    return path


def test_the_landing_pages_animation_plays(landing, open_page, screenshot):
    page = open_page(landing, width=800, height=460)
    until(page, "pydy.playing && pydy.time > 0.3")
    page.evaluate("pydy.seek(1.0)")
    assert np.ptp(screenshot(page, "landing")) > 60


def test_the_title_takes_two_lines_of_a_phone(landing, open_page):
    page = open_page(landing, width=358, height=460)
    heading, legend = (page.locator(s).bounding_box() for s in ("#heading", "#legend"))
    assert heading["height"] < 36
    assert heading["x"] + heading["width"] <= legend["x"]
