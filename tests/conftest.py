"""Settings for all tests: compiled code goes to a folder of its own, and no windows open."""

from __future__ import annotations

import os
import tempfile

_FOLDER = tempfile.TemporaryDirectory(prefix="pydy-tests-", ignore_cleanup_errors=True)
os.environ["PYDY_CACHE_DIR"] = _FOLDER.name
os.environ.setdefault("MPLBACKEND", "Agg")  # pictures are drawn, not shown
