"""Wait for a page in a browser: every wait ends, and says what it waited for."""

from __future__ import annotations

import time
from collections.abc import Callable


def until(page, holds: str | Callable[[], bool], seconds: float = 30.0) -> None:
    """Wait until an expression is true in the page, or a function here returns true.

    Playwright's own ``wait_for_function`` evaluates strings inside the page, which its content
    security policy forbids; its ``evaluate`` waits for a promise without a limit.
    """
    look = holds if callable(holds) else lambda: page.evaluate(f"!!({holds})")
    end = time.monotonic() + seconds
    while not look():
        assert time.monotonic() < end, f"after {seconds} s still not true: {holds}"
        page.wait_for_timeout(20)
