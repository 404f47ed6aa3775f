"""The table of slow tests, and the parts that it is dealt out to."""

import pkgutil
import re

import pytest

import parts

COLLECTED = [f"tests/test_a.py::test_many[{k}]" for k in range(parts.PARTS + 4)]
COLLECTED += [f"tests/test_a.py::test_{name}" for name in ("one", "two", "quick")]
SECONDS = {"tests/test_a.py::test_many": 40.0, "tests/test_a.py::test_one": 2.0}
SECONDS["tests/test_a.py::test_two"] = 2.0
COLLECTED += [f"tests/test_a.py::test_cheap[{k}]" for k in range(12)]
CHEAP = "tests/test_a.py::test_cheap"
SECONDS[CHEAP] = 0.3  # 0.025 s a case


@pytest.fixture
def table(monkeypatch, tmp_path):
    monkeypatch.setattr(parts, "TABLE", tmp_path / "slow.txt")
    parts.write_table(SECONDS | {"tests/test_a.py::test_quick": 0.01}, 0.5)


def choose(monkeypatch, part, further=0, whole_files=None):
    monkeypatch.setattr(parts, "WHOLE", part == "all")
    monkeypatch.setattr(parts, "PART", 0 if part == "all" else part)
    monkeypatch.setattr(parts, "FURTHER_PARTS", further)
    monkeypatch.setattr(parts, "WHOLE_FILES", whole_files)
    return parts.tried(COLLECTED)


def test_every_function_of_the_table_exists(request):
    collected = request.config.stash[parts.COLLECTED]
    functions = {parts.function_of(case) for case in collected}
    files = {case.partition("::")[0] for case in collected}
    stale = [
        name
        for name in parts.read_table()
        if name.partition("::")[0] in files and name not in functions
    ]
    assert not stale, f"tests/slow.txt lists tests that do not exist; run `make times`: {stale}"


def test_the_table_lists_files_that_exist():
    root = parts.TABLE.parents[1]
    missing = {name for name in parts.read_table() if not (root / name.partition("::")[0]).exists()}
    assert not missing, f"tests/slow.txt lists files that do not exist; run `make times`: {missing}"


def test_slow_tests_replace_functions_that_exist():
    """A test that is drawn once in 48 runs would tell of a renamed one months later."""
    root = parts.TABLE.parent
    for path in root.rglob("test_*.py"):
        for name in re.findall(r"\.setattr\(\s*\"(pydy[\w.]+)\"", path.read_text("utf-8")):
            assert hasattr(*holder_of(name)), f"{path.relative_to(root)} replaces {name}"


def holder_of(name):
    """Return the object that holds the last part of a dotted name, and that part."""
    holder, _, attribute = name.rpartition(".")
    return pkgutil.resolve_name(holder), attribute


def test_a_table_is_read_as_it_was_written(table):
    assert parts.read_table() == SECONDS
    assert parts.loop_time_of_table() == 0.5


def test_all_parts_together_try_every_case_and_each_slow_case_once(table, monkeypatch):
    runs = [choose(monkeypatch, part) for part in range(parts.PARTS)]
    assert set().union(*runs) == set(COLLECTED)
    slow = [case for run in runs for case in run if "quick" not in case and "cheap" not in case]
    assert len(slow) == len(set(slow))
    assert all("tests/test_a.py::test_quick" in run for run in runs)


def test_every_run_tries_a_sample_of_the_functions_whose_cases_are_cheap(table, monkeypatch):
    runs = [{c for c in choose(monkeypatch, part) if CHEAP in c} for part in range(parts.PARTS)]
    assert {len(run) for run in runs} <= {4}  # as many as take 0.1 s
    assert len(set().union(*runs)) == 12
    assert len({frozenset(run) for run in runs}) >= 3


def test_every_part_has_cases_of_a_function_with_many(table, monkeypatch):
    for part in range(parts.PARTS):
        assert any("test_many" in case for case in choose(monkeypatch, part))


def test_parts_take_about_the_same_time():
    dealt = parts.dealt(COLLECTED, SECONDS)
    loads = [0.0] * parts.PARTS
    for case, part in dealt.items():
        loads[part] += 1.0 if "many" in case else 0.025 if "cheap" in case else 2.0
    assert max(loads) - min(loads) <= 2.0


def test_further_parts_hold_no_quick_case_and_follow_the_drawn_one(table, monkeypatch):
    further = choose(monkeypatch, 14, further=3)
    slow = [choose(monkeypatch, part) - {"tests/test_a.py::test_quick"} for part in (15, 16, 17)]
    assert {c for c in further if CHEAP not in c} == {
        c for run in slow for c in run if CHEAP not in c
    }
    dealt = parts.dealt(COLLECTED, SECONDS)
    assert {c for c in further if CHEAP in c} == {
        c for c, part in dealt.items() if CHEAP in c and part in (15, 16, 17)
    }


def test_all_cases_of_files_that_are_named_are_tried(table, monkeypatch):
    assert choose(monkeypatch, 3, whole_files=("tests/test_a.py",)) == set(COLLECTED)
    assert choose(monkeypatch, 3, whole_files=()) == choose(monkeypatch, 3)


def test_the_whole_is_every_case(table, monkeypatch):
    assert choose(monkeypatch, "all") == set(COLLECTED)
