"""Which Chromium is here, and how it is started."""

from __future__ import annotations

import os
import shutil

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
# Drawing by the processor: no graphics card is needed. There is nothing here to be sandboxed from.
ARGUMENTS = [
    "--no-sandbox",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
]


def program() -> str | None:
    """Return the browser's program, or nothing where there is none."""
    return os.environ.get("PYDY_CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), None)
