"""Every public argument with bad values, and with good ones in unusual clothes.

What comes of each is an error of ours that names the argument, or the right result; nothing else.
The values are in `values`, what arguments must be in `kinds`, the arguments in `families`.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from fuzz.table import FAMILIES
from parts import FURTHER_PARTS, PART, RECORDING, WHOLE

# Of 33,000 inputs.
PARTS = 1 if WHOLE and not RECORDING else 32 if FURTHER_PARTS else 192

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="inputs are tried in forks")


def _absolute_paths():
    return map(os.path.abspath, filter(None, os.environ.get("PYTHONPATH", "").split(os.pathsep)))


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    """Return the process that forks: systems and functions are made there once."""
    folders = [str(Path(__file__).parents[1]), *_absolute_paths()]
    folder = tmp_path_factory.mktemp("fuzz")
    with (tmp_path_factory.mktemp("said") / "stderr").open("w+") as said:
        process = subprocess.Popen(
            [sys.executable, "-P", "-m", "fuzz.server"],
            cwd=folder,  # where files go that are named by a bad value
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=said,
            text=True,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(folders)},
        )
        with process:
            yield process, said


@pytest.mark.parametrize("family", FAMILIES)
def test_what_does_not_fit_is_named_and_what_fits_is_right(family, server):
    process, said = server
    process.stdin.write(f"{family} {PART % PARTS} {PARTS}\n")
    process.stdin.flush()
    answer = process.stdout.readline()
    assert answer, f"the server ended: {said.seek(0) or said.read()}"
    results = json.loads(answer)
    wrong = [r for r in results if r[2] not in ("named", "right")]
    assert not wrong, f"{len(wrong)} of {len(results)}:\n" + "\n".join(
        f"{target} with {value}: {what}: {details}" for target, value, what, details, _ in wrong
    )
    assert results or PARTS > 1  # of a small family a part may have none
