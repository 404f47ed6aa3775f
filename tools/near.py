"""Run the tests nearest to files of src, in under a minute for nine files of ten.

    python tools/near.py src/pydy/_graph/lowering.py      (or `make test-near FILE=…`)

Nearest are, in this order: the test file that mirrors a file, the tests that import it, those that
mirror the modules that use it, and the other tests of its room and of theirs. A module is used by
those that import it, a compiled loop (C) by those that name its function. Of the slow tests
(`tests/slow.txt`) those of the mirroring file are run whole, of the others a part. Tests are added
in that order as long as their recorded times allow; the contracts of the house always run.
"""

from __future__ import annotations

import argparse
import ast
import os
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SOURCE, TESTS = ROOT / "src" / "pydy", ROOT / "tests"
sys.path[:0] = [str(TESTS), str(Path(__file__).parent)]

from doors import door_of  # noqa: E402

import parts  # noqa: E402  # a helper of the tests

CONTRACTS = ("test_house.py", "test_parts.py", "test_reference.py", "test_registry.py")
CONTRACTS += ("test_words.py",)
# Processor time of the chosen tests. Starting pytest and collecting takes as long again.
BUDGET = 30.0
QUICK = 0.05  # what a test function takes that is not in the table, on average


def module_of(file: Path) -> str:
    """Return the dotted name of a file of src."""
    module = ".".join(file.relative_to(SOURCE.parent).with_suffix("").parts)
    return module.removesuffix(".__init__")


def mirrors(file: Path) -> Iterator[Path]:
    """Yield the test files that are named after a file, or its room: the nearest first.

    A file whose name no other file of src has may be tested in another room: `lanes` by the tests
    of ensembles.
    """
    *rooms, name = file.relative_to(SOURCE).with_suffix("").parts
    name = name.strip("_") or "init"
    for depth in range(len(rooms), -1, -1):
        yield from TESTS.joinpath(*rooms[:depth]).glob(f"test_{name}.py")
    for depth in range(len(rooms), 0, -1):
        yield from TESTS.joinpath(*rooms[:depth]).glob(f"test_{rooms[depth - 1].strip('_')}.py")
    if sum(source.stem.strip("_") == name for source in sources()) == 1:
        named = [test for test in test_files() if test.stem == f"test_{name}"]
        # Analyses are tested as users call them.
        yield from sorted(named, key=lambda test: test.parent.name != "system")


def room_of(file: Path) -> Path:
    """Return the folder of tests that mirrors the room of a file."""
    room = file.relative_to(SOURCE).parts[0].removesuffix(".py")
    return TESTS / room


@cache
def imports(file: Path) -> set[str]:
    """Return the modules that a file imports, and what it imports of them as if modules."""
    names = set()
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            names |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
            door = door_of(node.module)
            names |= {door[alias.name] for alias in node.names if alias.name in door}
    return names


@cache
def functions(test: Path) -> list[str]:
    """Return the names of the test functions of a file."""
    nodes = ast.walk(ast.parse(test.read_text(encoding="utf-8")))
    return [n.name for n in nodes if isinstance(n, ast.FunctionDef) and n.name.startswith("test")]


@cache
def slow_seconds(test: Path) -> float:
    """Return the recorded time of the slow tests of a file."""
    name = test.relative_to(ROOT).as_posix()
    return sum(t for function, t in parts.read_table().items() if function.startswith(f"{name}::"))


def seconds(test: Path, whole: bool) -> float:
    """Estimate the processor time of a file's tests: all of them, or those of a part."""
    slow = slow_seconds(test)
    return QUICK * len(functions(test)) + slow / (1 if whole else parts.PARTS)


@cache
def test_files() -> list[Path]:
    """Return the test files of the everyday run, but for the fuzz."""
    tests = sorted(TESTS.rglob("test_*.py"))
    return [test for test in tests if "browser" not in test.parts and "fuzz" not in test.parts]


@cache
def sources() -> list[Path]:
    """Return the files of src."""
    return sorted(SOURCE.rglob("*.py"))


def users_of(files: list[Path]) -> list[Path]:
    """Return the modules that import one of the files, or name a compiled loop that is one."""
    modules = {module_of(file) for file in files if file.suffix == ".py"}
    loops = [f'"{file.stem}"' for file in compiled(files)]
    return [
        source
        for source in sources()
        if imports(source) & modules
        or any(loop in source.read_text(encoding="utf-8") for loop in loops)
    ]


def compiled(files: list[Path]) -> list[Path]:
    """Return the C files among some files, and those that include a header among them."""
    found = [file for file in files if file.suffix in (".c", ".h")]
    for header in found:  # grows: a header may be included by another
        if header.suffix == ".h":
            found += [
                other
                for other in sorted(header.parent.glob("*.[ch]"))
                if f'"{header.name}"' in other.read_text(encoding="utf-8") and other not in found
            ]
    return [file for file in found if file.suffix == ".c"]


def near(files: list[Path]) -> tuple[list[Path], list[Path]]:
    """Return the test files to run, and those of which all cases are tried."""
    tests = test_files()
    mirroring = list(dict.fromkeys(test for file in files for test in mirrors(file)))
    modules = {module_of(file) for file in files}
    importing = [test for test in tests if imports(test) & modules]
    users = users_of(files)
    if not any(room_of(user).is_dir() for user in users):
        users += [file for file in sources() if imports(file) & {*map(module_of, users)}]
    mirroring_users = [test for user in users for test in mirrors(user)]
    rooms = [room_of(file) for file in (*files, *users)]
    beside = [test for room in dict.fromkeys(rooms) for test in tests if room in test.parents]
    chosen, whole, total = [], [], 0.0
    for test in dict.fromkeys([*mirroring, *importing, *mirroring_users, *beside]):
        takes_all = test in mirroring and total + seconds(test, True) <= BUDGET
        cost = seconds(test, takes_all)
        if total + cost > BUDGET and chosen:
            continue
        chosen.append(test)
        total += cost
        if takes_all:
            whole.append(test)
    contracts = [TESTS / name for name in CONTRACTS if (TESTS / name).exists()]
    return list(dict.fromkeys([*chosen, *contracts])), whole


def main() -> None:
    """Read the command line and run pytest."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("files", nargs="+", type=Path, help="files of src/pydy")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--list", action="store_true", help="print the test files; run nothing")
    options = parser.parse_args()
    files = [file.resolve() for file in options.files]
    for file in files:
        if SOURCE not in file.parents or not file.exists():
            parser.error(f"FILE must be a file of src/pydy, got {file}")
    sources = [file for file in files if file.suffix == ".py"]
    chosen, whole = near(files)
    names = [test.relative_to(ROOT).as_posix() for test in chosen]
    if options.list:
        print(*names, sep="\n")
        return
    variables = os.environ | {
        "PYDY_WHOLE_FILES": " ".join(test.relative_to(ROOT).as_posix() for test in whole)
    }
    command = [sys.executable, "-m", "pytest", "-n", str(options.jobs), "--dist", "worksteal"]
    command += [*names, *(str(file) for file in sources)]
    raise SystemExit(subprocess.run(command, cwd=ROOT, env=variables, check=False).returncode)


if __name__ == "__main__":
    main()
