"""Change the source at random places, one at a time, and see whether the tests notice.

    python tools/mutations.py record [tests/_graph …]     which tests run which blocks of src
    python tools/mutations.py try --count 30 --seed 1     30 mutants; prints killed and survived

A mutant is a sign, a constant, an index, a comparison or a condition of one line. Each is tried in
a copy of the tree, on the tests that were recorded to enter its block: the most specific first, up
to `--limit` seconds of their recorded processor time. A mutant that no test fails has survived: add
the test that is missing, or remove the code that nothing needs. Some survivors compute the same (a
tolerance, the order of a cache): read the difference before acting.

pytest loads this file as a plugin too: it counts the blocks of `src` that a test enters, or orders
the tests.
"""

from __future__ import annotations

import argparse
import ast
import builtins
import difflib
import importlib.abc
import importlib.machinery
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from queue import SimpleQueue
from typing import Any, NamedTuple

import pytest

ROOT = Path(__file__).resolve().parents[1]
RECORDS = ROOT / "build" / "mutations"
SOURCE = Path("src", "pydy")
PYTEST = (sys.executable, "-m", "pytest", "-q", "-p", "mutations")
# What tests read: the tree without what is built or installed.
COPIED = ("src", "tests", "examples", "docs", "tools", "benchmarks", "pyproject.toml", "README.md")
COPIED += ("CHANGELOG.md", "CITATION.cff", "CONTRIBUTING.md", "LICENSE", "Makefile")
COMPARISONS: dict[type[ast.cmpop], tuple[str, str]] = {
    ast.Lt: ("<", "<="),
    ast.LtE: ("<=", "<"),
    ast.Gt: (">", ">="),
    ast.GtE: (">=", ">"),
    ast.Eq: ("==", "!="),
    ast.NotEq: ("!=", "=="),
    ast.In: ("in", "not in"),
    ast.Is: ("is", "is not"),
    ast.IsNot: ("is not", "is"),
    ast.NotIn: ("not in", "in"),
}


class Mutant(NamedTuple):
    """One change of one file: what stands from `start` to `end` becomes `text`."""

    file: str
    line: int
    start: int
    end: int
    text: str
    kind: str


def blocks(tree: ast.Module) -> Iterator[tuple[list[ast.stmt], int]]:
    """Every block of a function, and the line of its first statement."""
    for function in ast.walk(tree):
        if not isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef):
            continue
        for node in ast.walk(function):
            for field in ("body", "orelse", "finalbody"):
                block = getattr(node, field, None)
                if isinstance(block, list) and block and not isinstance(node, ast.ClassDef):
                    yield block, block[0].lineno


# ---- Which tests enter which block: calls are added to the source as it is imported. ----


class _Counting(importlib.machinery.SourceFileLoader):
    """Compiles a module with a call at the start of each block."""

    def path_stats(self, path: str) -> Any:
        raise OSError  # no bytecode: neither that of the plain module is read nor ours written

    def source_to_code(self, data: Any, path: Any, **options: Any) -> Any:  # type: ignore[override]
        tree = ast.parse(data)
        file = Path(path).relative_to(ROOT / SOURCE).as_posix()
        seen = set()
        for block, line in list(blocks(tree)):
            if id(block) in seen:
                continue
            seen.add(id(block))
            first = block[0]
            call = ast.parse(f"__entered__({f'{file}:{line}'!r})").body[0]
            for node in ast.walk(call):
                ast.copy_location(node, first)
            # A docstring stays the first statement of its function.
            text = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
            block.insert(1 if text else 0, call)
        return compile(tree, path, "exec", dont_inherit=True)


class _Finder(importlib.abc.MetaPathFinder):
    def find_spec(self, name: str, path: Any, target: Any = None) -> Any:
        if name.partition(".")[0] != "pydy":
            return None
        spec = importlib.machinery.PathFinder.find_spec(name, path)
        if spec and isinstance(spec.loader, importlib.machinery.SourceFileLoader):
            spec.loader = _Counting(name, spec.loader.path)
        return spec


def _used() -> float:
    """Processor time of this process and of those that it has started and that have ended."""
    now = os.times()
    return now.user + now.system + now.children_user + now.children_system


class Recorder:
    """Writes a line for each test: its name, its processor time and the blocks it has entered."""

    def __init__(self, file: Path) -> None:
        self.file, self.entered = file, set[str]()
        builtins.__entered__ = self.entered.add  # type: ignore[attr-defined]
        sys.meta_path.insert(0, _Finder())

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Any:
        """Record what one test does, its fixtures among it."""
        self.entered.clear()
        before = _used()
        outcome = yield
        record = [item.nodeid, round(_used() - before, 3), sorted(self.entered)]
        with self.file.open("a", encoding="utf-8") as file:
            file.write(json.dumps(record) + "\n")
        return outcome


class Order:
    """Keeps the tests that a file lists, in its order."""

    def __init__(self, names: list[str]) -> None:
        self.names = {name: place for place, name in enumerate(names)}

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        """Choose and sort what was collected."""
        items[:] = [item for item in items if item.nodeid in self.names]
        items.sort(key=lambda item: self.names[item.nodeid])


def pytest_configure(config: pytest.Config) -> None:
    """Be one plugin or the other, as the process that started pytest says."""
    if folder := os.environ.get("MUTATIONS_RECORD"):
        worker = os.environ.get("PYTEST_XDIST_WORKER", f"main-{os.getpid()}")
        config.pluginmanager.register(Recorder(Path(folder, f"{worker}.jsonl")))
    if chosen := os.environ.get("MUTATIONS_ORDER"):
        config.pluginmanager.register(Order(json.loads(Path(chosen).read_text(encoding="utf-8"))))


# ---- Mutants ----


def mutants(file: str, source: str) -> Iterator[Mutant]:
    """Every mutant of a file: of its functions, without annotations and texts."""
    data = source.encode()
    lines = [0]
    for line in data.splitlines(keepends=True):
        lines.append(lines[-1] + len(line))

    def begin(node: Any) -> int:
        return lines[node.lineno - 1] + node.col_offset

    def end(node: Any) -> int:
        return lines[node.end_lineno - 1] + node.end_col_offset

    def between(left: Any, right: Any, old: str, new: str, kind: str) -> Iterator[Mutant]:
        text = data[end(left) : begin(right)].decode()
        if text.count(old) == 1 and "#" not in text:
            text = text.replace(old, new)
            yield Mutant(file, left.end_lineno, end(left), begin(right), text, kind)

    def whole(node: Any, text: str, kind: str) -> Mutant:
        return Mutant(file, node.lineno, begin(node), end(node), text, kind)

    def of(node: Any) -> str:
        return data[begin(node) : end(node)].decode()

    def visit(node: ast.AST, index: bool = False) -> Iterator[Mutant]:
        match node:
            case ast.BinOp(left, ast.Add(), right):
                yield from between(left, right, "+", "-", "sign")
            case ast.BinOp(left, ast.Sub(), right):
                yield from between(left, right, "-", "+", "sign")
            case ast.UnaryOp(ast.USub(), operand) if not index:
                yield whole(node, f"({of(operand)})", "sign")
            case ast.UnaryOp(ast.Not(), operand):
                yield whole(node, f"bool({of(operand)})", "not")
            case ast.Constant(bool(value)):
                yield whole(node, str(not value), "constant")
            case ast.Constant(int(value)):
                yield whole(node, str(value + 1), "index" if index else "constant")
            case ast.Constant(float(value)):
                yield whole(node, repr(value * 1.5 + (value == 0)), "constant")
            case ast.Compare(left, [op], [right]):
                yield from between(left, right, *COMPARISONS[type(op)], "comparison")
            case ast.BoolOp(op, [first, second, *_]):
                old, new = ("and", "or") if isinstance(op, ast.And) else ("or", "and")
                yield from between(first, second, old, new, "condition")
            case ast.If(test) | ast.IfExp(test) | ast.While(test) if not isinstance(
                test, ast.Compare | ast.UnaryOp | ast.BoolOp
            ):
                yield whole(test, f"(not ({of(test)}))", "condition")
        for field, child in ast.iter_fields(node):
            if field in ("annotation", "returns", "decorator_list", "type_params"):
                continue
            if isinstance(node, ast.JoinedStr):
                continue  # the words of a message
            if isinstance(node, ast.Raise | ast.Assert):
                continue
            inside = isinstance(node, ast.Subscript) and field == "slice"
            for part in child if isinstance(child, list) else [child]:
                if isinstance(part, ast.AST):
                    yield from visit(part, inside)

    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.FunctionDef):
            for statement in node.body:
                if not isinstance(statement, ast.FunctionDef):
                    yield from visit(statement)


def changed(mutant: Mutant, source: str) -> str:
    """Return the file's text with the mutant in it."""
    data = source.encode()
    return (data[: mutant.start] + mutant.text.encode() + data[mutant.end :]).decode()


def difference(mutant: Mutant) -> str:
    """Return what a mutant changes, as a patch without context."""
    source = (ROOT / SOURCE / mutant.file).read_text(encoding="utf-8")
    new = changed(mutant, source).splitlines()
    lines = difflib.unified_diff(source.splitlines(), new, lineterm="", n=0)
    return "\n".join(f"    {line}" for line in lines if line[:3] not in ("---", "+++"))


def choose(count: int, seed: int, under: list[str]) -> list[Mutant]:
    """Choose mutants: files by their number of places, places evenly."""
    every = []
    for path in sorted((ROOT / SOURCE).rglob("*.py")):
        file = path.relative_to(ROOT / SOURCE).as_posix()
        if not under or any(file.startswith(part) for part in under):
            # Of a function in a function, each place is met twice.
            every += sorted(set(mutants(file, path.read_text(encoding="utf-8"))))
    return random.Random(seed).sample(every, min(count, len(every)))


# ---- Trials ----


def records() -> list[tuple[str, float, set[str]]]:
    """Read what `record` has written."""
    found = []
    for file in sorted(RECORDS.glob("*.jsonl")):
        for line in file.read_text(encoding="utf-8").splitlines():
            name, seconds, entered = json.loads(line)
            found.append((name, seconds, set(entered)))
    if not found:
        raise SystemExit("no records: run `python tools/mutations.py record` first")
    return found


def innermost(mutant: Mutant) -> str:
    """Return the name of the innermost block that holds the mutant's line."""
    tree = ast.parse((ROOT / SOURCE / mutant.file).read_text(encoding="utf-8"))
    holding = [
        (line, block)
        for block, line in blocks(tree)
        if block[0].lineno <= mutant.line <= (block[-1].end_lineno or 0)
    ]
    return f"{mutant.file}:{max(holding, key=lambda pair: pair[0])[0]}"


def covering(mutant: Mutant, known: list[tuple[str, float, set[str]]], limit: float) -> list[str]:
    """List the tests that enter the mutant's block, those that do least else first."""
    block = innermost(mutant)
    tests = sorted((len(e), s, name) for name, s, e in known if block in e)
    chosen, total = [], 0.0
    for _, seconds, name in tests:
        if total <= limit:
            chosen.append(name)
            total += seconds
    return chosen


def run(tree: Path, tests: list[str], limit: float) -> str:
    """Run tests in a copy of the tree; `killed`, `survived` or `hung`, and by which test."""
    order = tree / "order.json"
    order.write_text(json.dumps(tests), encoding="utf-8")
    files = sorted({name.partition("::")[0] for name in tests})
    command = [*PYTEST, "-x", "--tb=line", "-p", "no:cacheprovider", *files]
    paths = f"{tree / 'src'}{os.pathsep}{tree / 'tools'}"
    variables = os.environ | {"PYTHONPATH": paths, "MUTATIONS_ORDER": str(order)}
    process = subprocess.Popen(
        command,
        cwd=tree,
        env=variables | {"PYTHONDONTWRITEBYTECODE": "1"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        start_new_session=True,
    )
    try:
        text, _ = process.communicate(timeout=limit)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        return "hung"
    if process.returncode in (0, 5):  # all passed; or none of them is there any more
        return "not run by any test" if process.returncode else "survived"
    failed = [line for line in text.splitlines() if line.startswith(("FAILED", "ERROR"))]
    by = failed[0].split(" - ")[0] if failed else f"pytest ended with {process.returncode}"
    return f"killed by {by.removeprefix('FAILED ').removeprefix('ERROR ')}"


def copy(folder: Path) -> Path:
    """Copy what the tests need into a folder."""
    built = shutil.ignore_patterns("__pycache__")
    for name in COPIED:
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, folder / name, ignore=built)
        elif (ROOT / name).exists():
            shutil.copy(ROOT / name, folder / name)
    return folder


def tried_by_make_test(names: Iterator[str]) -> set[str]:
    """Return the tests that `make test` tries, with the part that PYDY_PART says."""
    sys.path.insert(0, str(ROOT / "tests"))
    import parts

    return parts.tried(names)


def attempt(options: argparse.Namespace) -> None:
    """Try mutants and print what became of them."""
    known, free = records(), SimpleQueue[Path]()
    if options.everyday:
        tried = tried_by_make_test(name for name, _, _ in known)
        known = [row for row in known if row[0] in tried]
    chosen = choose(options.count, options.seed, options.under)
    totals: dict[str, int] = {}

    def trial(mutant: Mutant) -> tuple[str, int, float]:
        tests = covering(mutant, known, options.limit)
        if not tests:
            return "not run by any test", 0, 0.0
        tree, began = free.get(), time.perf_counter()
        path = tree / SOURCE / mutant.file
        before = path.read_text(encoding="utf-8")
        path.write_text(changed(mutant, before), encoding="utf-8")
        try:
            # A mutant in a loop may never end; the recorded time is a processor's own.
            result = run(tree, tests, 60 + options.patience * options.limit)
        finally:
            path.write_text(before, encoding="utf-8")
            free.put(tree)
        return result, len(tests), time.perf_counter() - began

    with tempfile.TemporaryDirectory(prefix="mutations-") as folder:
        for k in range(options.jobs):
            free.put(copy(Path(folder, str(k))))
        with ThreadPoolExecutor(options.jobs) as pool:
            for mutant, found in zip(chosen, pool.map(trial, chosen), strict=True):
                result, tests, seconds = found
                kind = result.split()[0]
                totals[kind] = totals.get(kind, 0) + 1
                where = f"{mutant.file}:{mutant.line}"
                print(
                    f"{where} ({mutant.kind}): {result}; {tests} tests, {seconds:.0f} s", flush=True
                )
                if kind != "killed":
                    print(difference(mutant), flush=True)
    print(", ".join(f"{n} {kind}" for kind, n in sorted(totals.items())))


def record(paths: list[str], jobs: int) -> None:
    """Run tests and record which blocks each enters."""
    RECORDS.mkdir(parents=True, exist_ok=True)
    for file in RECORDS.glob("*.jsonl"):
        file.unlink()
    variables = os.environ | {"MUTATIONS_RECORD": str(RECORDS), "PYTHONPATH": str(ROOT / "tools")}
    variables["PYDY_PART"] = "all"
    command = [*PYTEST, "-n", str(jobs), "--dist", "worksteal", *(paths or ["tests"])]
    subprocess.run(command, env=variables, cwd=ROOT, check=False)


def main() -> None:
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("command", choices=("record", "try"))
    parser.add_argument("paths", nargs="*", help="record: the tests; all by default")
    parser.add_argument("--count", type=int, default=30, help="mutants")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument(
        "--under", action="append", default=[], help="a part of src/pydy; repeatable"
    )
    parser.add_argument(
        "--limit", type=float, default=60.0, help="recorded seconds of tests a mutant"
    )
    parser.add_argument(
        "--patience", type=float, default=5.0, help="times the limit until it hangs"
    )
    parser.add_argument("--everyday", action="store_true", help="only tests that make test tries")
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    if options.command == "record":
        record(options.paths, options.jobs)
    else:
        attempt(options)


if __name__ == "__main__":
    main()
