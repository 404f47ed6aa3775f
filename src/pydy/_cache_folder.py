"""Where machine code is kept on disk.

The environment variable PYDY_CACHE_DIR names another folder; ``off`` turns the cache off.
"""

from __future__ import annotations

import os
from pathlib import Path

__all__ = ["folder"]


def folder() -> Path | None:
    """Return where entries lie, or None when the cache is turned off."""
    chosen = os.environ.get("PYDY_CACHE_DIR")
    if chosen:
        return None if chosen.lower() == "off" else Path(chosen)
    import platformdirs

    return Path(platformdirs.user_cache_dir("pydy", appauthor=False))
