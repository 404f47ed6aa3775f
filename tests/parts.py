"""What takes long is tried in parts: `.ci/run` draws one for each commit, so that all are soon.

`PYDY_PART` is a number, of which the remainder counts, or "all".
"""

from __future__ import annotations

import os

_PART = os.environ.get("PYDY_PART", "0")
WHOLE = _PART == "all"
PART = 0 if WHOLE else int(_PART)


def drawn(place: int, parts: int) -> bool:
    """Whether what stands at a place is in this run's part."""
    return WHOLE or place % parts == PART % parts
