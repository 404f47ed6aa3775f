"""Wait for a page in a browser."""

from __future__ import annotations

import time


def until(page, expression: str, seconds: float = 30.0) -> None:
    """Wait until an expression is true in the page.

    Playwright's own ``wait_for_function`` evaluates strings inside the page, which its content
    security policy forbids.
    """
    end = time.monotonic() + seconds
    while not page.evaluate(f"!!({expression})"):
        assert time.monotonic() < end, f"after {seconds} s still not true: {expression}"
        page.wait_for_timeout(20)
