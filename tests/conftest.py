"""Settings for all tests: compiled code goes to a folder of its own, and no windows open."""

from __future__ import annotations

import os
import tempfile
from contextlib import suppress
from pathlib import Path

from pydy._cache_folder import folder, make

_OWN = folder()
_FOLDER = tempfile.TemporaryDirectory(prefix="pydy-tests-", ignore_cleanup_errors=True)
os.environ["PYDY_CACHE_DIR"] = _FOLDER.name
os.environ.setdefault("MPLBACKEND", "Agg")  # pictures are drawn, not shown

# The solvers take most of a minute to compile, know when they are stale, and are the same for all
# models: they are the user's. (Windows may not permit the link: then they are compiled again.)
if _OWN is not None:
    with suppress(OSError):
        make(_OWN / "solvers")
        (Path(_FOLDER.name) / "solvers").symlink_to(_OWN / "solvers", target_is_directory=True)
