"""Run a selection of the tests on the oldest dependencies, or on the newest Python.

    python tools/other_versions.py lowest   Python and packages at pyproject.toml's lower bounds
    python tools/other_versions.py newest   the newest Python here for which there are wheels

Each has an environment of its own, .venv-lowest and .venv-newest, which is made when it is missing
or older than pyproject.toml. Pythons are looked for on PATH and among pyenv's and uv's; where the
wanted one is not to be had, that is said and the run is skipped.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
LOWEST = tuple(map(int, PROJECT["requires-python"].removeprefix(">=").split(".")))
# What meets other packages: arrays, SciPy's solvers, SymPy's classes, pages, labels and plots.
SELECTION = [
    "tests/test_document.py",
    "tests/test_trajectory.py",
    "tests/test_plot.py",
    "tests/codegen/test_cython.py",
    "tests/codegen/test_ode_function_generators.py",
    "tests/ensemble/test_results.py",
    "tests/solvers/test_protocol.py",
    "tests/system/test_evaluate.py",
    "tests/system/test_integrate.py",
    "tests/system/test_projection.py",
    "tests/viz/test_page.py",
    "tests/viz/test_figure.py",
]


def requirements(extras: list[str]) -> Iterator[str]:
    """Yield the requirements of the package and of some extras, those within them included."""
    wanted = [*PROJECT["dependencies"]]
    for extra in extras:
        wanted += PROJECT["optional-dependencies"][extra]
    for requirement in wanted:
        inner = re.fullmatch(r"pydy\[(.*)\]", requirement)
        if inner:
            yield from requirements(inner[1].split(","))
        else:
            yield requirement


def lowest_pins(extras: list[str]) -> list[str]:
    """Return a pin at its lower bound for each requirement that has one."""
    return sorted({r.replace(">=", "==") for r in requirements(extras) if ">=" in r})


def pythons() -> dict[tuple[int, ...], str]:
    """Return the interpreters here by version, newest first; the first of equals is taken."""
    folders = [Path(p) for p in os.environ.get("PATH", "").split(os.pathsep) if p]
    home = Path.home()
    for installed in (home / ".pyenv/versions", home / ".local/share/uv/python"):
        folders += sorted(installed.glob("*/bin"))
    found: dict[tuple[int, ...], str] = {}
    for folder in folders:
        for program in sorted(folder.glob("python3.[0-9]*")):
            if not re.fullmatch(r"python3\.\d+", program.name):
                continue
            # A shim may stand for nothing, and Debian's may lack what makes environments.
            question = "import ensurepip, sys, venv; print(*sys.version_info[:2])"
            asked = subprocess.run([program, "-c", question], capture_output=True, text=True)
            if asked.returncode == 0:
                version = tuple(map(int, asked.stdout.split()))
                found.setdefault(version, str(program))
    return dict(sorted(found.items(), reverse=True))


def install(python: str, folder: Path, options: list[str]) -> bool:
    """Make an environment; return whether all packages could be had."""
    stamp = folder / ".installed"
    if stamp.exists() and stamp.stat().st_mtime > (ROOT / "pyproject.toml").stat().st_mtime:
        return True
    subprocess.run([python, "-m", "venv", "--clear", folder], check=True)
    pip = [folder / "bin/python", "-m", "pip", "--disable-pip-version-check", "install", "--quiet"]
    # No wheel for this Python: that is the answer, not an hour of compiling.
    packages = ["--prefer-binary", "--only-binary", "llvmlite,numpy,scipy,pandas,matplotlib"]
    done = subprocess.run([*pip, *packages, *options, "--editable", ".[test]"], cwd=ROOT)
    if done.returncode == 0:
        stamp.touch()
    return done.returncode == 0


def prepared(which: str) -> str | None:
    """Return the Python of an environment that is ready, or None with the reason printed."""
    folder, here = ROOT / f".venv-{which}", pythons()
    listed = ", ".join(".".join(map(str, v)) for v in here) or "none"
    if which == "lowest":
        python = here.get(LOWEST)
        if python is None:
            print(f"test-lowest: skipped: no Python {'.'.join(map(str, LOWEST))} here: {listed}")
            return None
        pins = folder.with_suffix(".txt")
        pins.write_text("\n".join(lowest_pins(["test"])) + "\n")
        if not install(python, folder, ["--constraint", str(pins)]):
            sys.exit("test-lowest: the lower bounds of pyproject.toml cannot be installed together")
        return str(folder / "bin/python")
    for version, python in here.items():
        if version <= LOWEST:
            break
        if install(python, folder, []):
            return str(folder / "bin/python")
        print(f"test-newest: not all packages are to be had for {'.'.join(map(str, version))}")
    print(f"test-newest: skipped: no usable Python newer than the oldest supported here: {listed}")
    return None


def main(which: str, jobs: str) -> int:
    """Run the selection; return pytest's exit code."""
    python = prepared(which)
    if python is None:
        return 0
    command = [python, "-m", "pytest", "-q", "-n", jobs, "--dist", "worksteal", *SELECTION]
    # What old packages say of their own dependencies, and new ones of what is to come, is no
    # failure of ours; results are.
    command += ["-p", "no:cacheprovider", "-o", "filterwarnings=default", "--disable-warnings"]
    version = subprocess.run([python, "--version"], capture_output=True, text=True).stdout.strip()
    print(f"test-{which}: {version}, {', '.join(SELECTION)}", flush=True)
    return subprocess.run(command, cwd=ROOT).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
