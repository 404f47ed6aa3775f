"""Chromium, driven by Playwright: which one, how, and what to do where there is none."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import chromium
from waiting import until

BUILD = Path(__file__).parents[2] / "build"


def missing(what: str) -> None:
    """Skip, or fail where PYDY_BROWSER=required says that a browser must be there."""
    if os.environ.get("PYDY_BROWSER") == "required":
        pytest.fail(what)
    pytest.skip(what)


@pytest.fixture(scope="session")
def browser():
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        missing("Playwright is not installed: python -m pip install 'pydy[browser]'")
    program = chromium.program()
    if program is None:
        missing(
            "no Chromium was found: install it (Debian: apt install chromium), or name the program "
            "in PYDY_CHROMIUM"
        )
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=chromium.ARGUMENTS)
        yield browser
        browser.close()


@pytest.fixture
def open_page(browser):
    """Open a file and return its page; complain about errors, warnings and requests at the end."""
    contexts, complaints = [], []

    def open_page(path, width=900, height=640, **options):
        context = browser.new_context(viewport={"width": width, "height": height}, **options)
        contexts.append(context)
        page = context.new_page()
        page.on("console", lambda m: complaints.append(f"console {m.type}: {m.text}"))
        page.on("pageerror", lambda error: complaints.append(f"error: {error}"))
        url = Path(path).resolve().as_uri()
        page.on("request", lambda r: r.url == url or complaints.append(f"request: {r.url}"))
        page.goto(url)
        until(page, "window.pydy && window.pydy.ready")
        return page

    yield open_page
    for context in contexts:
        context.close()
    # A driver that reads pixels back slowly is no fault of the page.
    assert [c for c in complaints if "GPU stall due to ReadPixels" not in c] == []


@pytest.fixture(scope="session")
def screenshot():
    """Save what a page shows into build/, and return it as an array of pixels."""
    BUILD.mkdir(exist_ok=True)

    def screenshot(page, name, selector=None):
        import numpy as np
        from PIL import Image

        path = BUILD / f"browser-{name}.png"
        (page.locator(selector) if selector else page).screenshot(path=path)
        return np.asarray(Image.open(path).convert("RGB"), dtype=float)

    return screenshot
