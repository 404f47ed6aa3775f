"""How fast pages that simulate are, in Chromium: ``make bench-pages``.

Seconds of motion for each second of computing, how long after a drag of a slider the new motion is
on the screen, and how long the script of a frame takes; the best of several, since a browser
compiles what it has run a few times.
"""

from __future__ import annotations

import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from harness.report import save, table

from pydy.examples import bicycle_ride
from pydy.models import n_link_pendulum_on_cart

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from playwright.sync_api import sync_playwright

import chromium
from waiting import until

REPEATS = 12
# Sets the slider as a reader does, and waits for another picture.
DRAG = """([name, value]) => new Promise((done) => {
    const row = [...document.querySelectorAll("#live li")].find((l) => l.innerText.includes(name));
    const slider = row.querySelector("input[type=range]");
    const before = pydy.positions()[0].join(), begin = performance.now();
    slider.value = value;
    slider.dispatchEvent(new Event("input"));
    const look = () => {
        if (pydy.positions()[0].join() !== before) done(performance.now() - begin);
        else requestAnimationFrame(look);
    };
    look();
})"""


def links(path: Path) -> None:
    """Write the page of five links on a cart."""
    system = n_link_pendulum_on_cart(5)
    system.constants = {"g": 9.81}
    system.initial_conditions = dict.fromkeys(system.coordinates[1:], 0.5)
    system.times = np.linspace(0.0, 10.0, num=301)
    system.ode_solver = "dop853"
    system.scene().animate(system.simulate(), fps=None).to_html(path, live={"l0": (0.5, 2)})


def bicycle(path: Path) -> None:
    """Write the page of the demo's bicycle."""
    bicycle_ride.simulate(bicycle_ride.ride(), path)


def measure(browser: Any, name: str, path: Path, slider: str, start: float) -> list[str]:
    """Return a row of the table."""
    page = browser.new_page(viewport={"width": 640, "height": 480})
    page.goto(path.resolve().as_uri())
    until(page, "window.pydy && window.pydy.ready")
    page.evaluate("pydy.pause(), pydy.seek(1.0)")
    values = [start + k / 50 for k in range(1, REPEATS + 1)]
    fast = [page.evaluate(f"pydy.live.set('{slider}', {v}), pydy.live.speed") for v in values]
    page.evaluate("pydy.seek(1.0)")
    shown = [page.evaluate(DRAG, [slider, v - 0.01]) for v in values]
    return [name, f"{max(fast):.0f}", f"{min(shown):.0f}", f"{frame(page):.1f}"]


def frame(page: Any) -> float:
    """Return the milliseconds of script that a frame takes in a small view.

    Without a graphics card the same processor draws it, at the same time.
    """
    page.set_viewport_size({"width": 320, "height": 260})
    page.evaluate("pydy.play()")
    costs = []
    for _ in range(5):  # whatever else the processor has to do only adds to it
        page.evaluate("pydy.forgetCosts()")
        until(page, "pydy.costs().frames >= 30")
        costs.append(page.evaluate("pydy.costs().all"))
    return float(min(costs))


def main() -> None:
    """Print the table."""
    program = chromium.program()
    if program is None:
        sys.exit("no Chromium was found: install it, or name the program in PYDY_CHROMIUM")
    rows = []
    with TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=chromium.ARGUMENTS)
        for name, write, slider, start in (
            ("five links on a cart", links, "l0", 1.0), ("bicycle", bicycle, "speed", 5.0)
        ):  # fmt: skip
            path = Path(folder) / "page.html"
            write(path)
            rows.append(measure(browser, name, path, slider, start))
        browser.close()
    save("live_pages", rows)
    table(
        "Pages that simulate", ["page", "times real time", "drag to picture, ms", "frame, ms"], rows
    )


if __name__ == "__main__":
    main()
