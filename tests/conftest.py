"""Settings for all tests: compiled code goes to a folder of its own, and no windows open."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

import pytest

_FOLDER = tempfile.TemporaryDirectory(prefix="pydy-tests-", ignore_cleanup_errors=True)
os.environ["PYDY_CACHE_DIR"] = _FOLDER.name
os.environ.setdefault("MPLBACKEND", "Agg")  # pictures are drawn, not shown

ROOT = Path(__file__).parents[1]


@pytest.fixture(scope="session", autouse=True)
def _nothing_is_left_behind():
    """Have files that tests write lie in temporary folders, not in the project's own."""
    before = set(os.listdir(ROOT))
    yield
    new = {name for name in set(os.listdir(ROOT)) - before if not name.startswith((".", "build"))}
    assert not new, f"tests have written {sorted(new)} in {ROOT}"
