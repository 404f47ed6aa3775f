"""Rooms above the core can leave for packages of their own: they use doors alone.

The files of a room and of its tests are copied, with another prefix in their imports and nothing
else changed, and these tests run on the copy.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
# The copy imports nothing of the original.
CONFTEST = """
import sys

def pytest_sessionfinish():
    loaded = sorted(name for name in sys.modules if (name + ".").startswith("pydy.{room}."))
    assert not loaded, f"the copy loads modules of the original: {{loaded}}"
"""


@pytest.mark.parametrize(
    ("room", "files"),
    [
        ("robots", ["test_tendons.py"]),
        ("contact", ["test_laws.py", "test_modes.py"]),
        ("vehicles", ["test_magic_formula.py"]),
    ],
)
def test_a_room_works_as_a_package_of_its_own(room, files, tmp_path):
    package = f"apart_{room}"

    def copy(source, target):
        text = re.sub(rf"\bpydy\.{room}\b", package, source.read_text())
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)

    folder = ROOT / "src" / "pydy" / room
    for source in folder.rglob("*.py*"):
        if source.suffix in (".py", ".pyi"):
            copy(source, tmp_path / "src" / package / source.relative_to(folder))
    tests = tmp_path / "tests"
    for name in files:
        copy(ROOT / "tests" / room / name, tests / room / name)
    # Helpers of tests that take from the room, such as models with contacts.
    for helper in (ROOT / "tests").glob("*.py"):
        if f"pydy.{room}" in helper.read_text() and not helper.name.startswith("test_"):
            copy(helper, tests / helper.name)
    for helper in (ROOT / "tests" / "zoo").glob("*.py"):  # all: a package is found in one place
        copy(helper, tests / "zoo" / helper.name)
    for helper in (ROOT / "tests" / room).glob("*.py"):
        if not helper.name.startswith("test_"):
            copy(helper, tests / room / helper.name)
    (tests / "conftest.py").write_text(CONFTEST.format(room=room))
    paths = [tests, tmp_path / "src", ROOT / "src", ROOT / "tests", ROOT / "examples"]
    command = [sys.executable, "-m", "pytest", "-q", "-x", f"--rootdir={tmp_path}", str(tests)]
    command += ["--import-mode=importlib", "-p", "no:cacheprovider", "-p", "no:xdist"]
    command += ["-p", "no:zarr"]
    done = subprocess.run(
        command,
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(map(str, paths))},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert re.search(r"\b[1-9]\d* passed", done.stdout), done.stdout
