"""Type checkers read `usage.py` in `make test` and `.ci/run`; what it says must run as well."""

from __future__ import annotations

import runpy
from pathlib import Path


def test_the_typed_script_of_a_user_runs():
    runpy.run_path(str(Path(__file__).with_name("usage.py")), run_name="__main__")
