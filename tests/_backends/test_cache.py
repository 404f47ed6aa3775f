"""Machine code on disk: whatever happens to it, results stay right and nobody sees an error."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time

import pytest

from pydy._backends import cache

SCRIPT = """
import sys
import numpy as np
from pydy._backends import background
from pydy.models import multi_mass_spring_damper
background._QUIET_SECONDS = 0.0
for n in (1, 2, 3):
    system = multi_mass_spring_damper(n)
    x = np.arange(1.0, 2 * n + 1)
    system.generate_ode_function()
    assert system._current().kernel.addresses
    rates = system.evaluate_ode(x)
    np.testing.assert_array_equal(rates[:n], x[n:])
print("right")
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("PYDY_CACHE_DIR", str(tmp_path / "cache"))
    return tmp_path / "cache"


def start():
    return subprocess.Popen(
        [sys.executable, "-c", SCRIPT], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )


def finishes_right(process):
    out, errors = process.communicate(timeout=120)
    assert out.strip() == "right", errors


def test_an_entry_comes_back_as_it_was(folder):
    cache.write("key", b"content")
    assert cache.read("key") == b"content"


def test_what_was_never_written_is_a_miss(folder):
    assert cache.read("key") is None


@pytest.mark.parametrize("length", [0, 5, 12, 30, 44, 50])
def test_a_truncated_entry_is_a_miss(folder, length):
    cache.write("key", b"content")
    path = folder / "key.code"
    path.write_bytes(path.read_bytes()[:length])
    assert cache.read("key") is None


def test_an_entry_with_one_wrong_bit_is_a_miss(folder):
    cache.write("key", b"content")
    path = folder / "key.code"
    data = bytearray(path.read_bytes())
    data[-1] ^= 1
    path.write_bytes(data)
    assert cache.read("key") is None


def test_the_least_recently_used_entry_goes_first(folder, monkeypatch):
    monkeypatch.setattr(cache, "LIMIT_BYTES", 300)  # three entries
    for age, key in enumerate(["old", "used", "new"]):
        cache.write(key, b"x" * 50)
        os.utime(folder / f"{key}.code", (age, age))
    cache.read("old")  # used again: now the most recent
    cache.write("newest", b"x" * 50)
    assert cache.read("used") is None
    assert cache.read("old") is not None
    assert cache.read("newest") is not None


def test_what_a_killed_process_left_behind_is_swept_up(folder):
    folder.mkdir()
    left = folder / "tmp-left"
    left.write_bytes(b"half")
    os.utime(left, (0, 0))
    cache.write("key", b"content")
    assert not left.exists()


def test_a_folder_that_is_a_file_costs_only_the_cache(tmp_path, monkeypatch):
    (tmp_path / "cache").write_text("not a folder")
    monkeypatch.setenv("PYDY_CACHE_DIR", str(tmp_path / "cache"))
    cache.write("key", b"content")
    assert cache.read("key") is None


def test_the_cache_can_be_turned_off(tmp_path, monkeypatch):
    monkeypatch.setenv("PYDY_CACHE_DIR", "off")
    monkeypatch.chdir(tmp_path)
    cache.write("key", b"content")
    assert cache.folder() is None
    assert cache.read("key") is None
    assert list(tmp_path.iterdir()) == []


def test_entries_under_each_others_names_are_compiled_anew(folder):
    finishes_right(start())
    paths = sorted(folder.glob("*.code"))
    contents = [path.read_bytes() for path in paths]
    for path, data in zip(paths, contents[1:] + contents[:1], strict=True):
        path.write_bytes(data)
    finishes_right(start())


def test_killed_processes_truncated_entries_and_eight_at_once_give_right_results(folder):
    rng = random.Random(0)
    for _ in range(3):
        process = start()
        time.sleep(rng.uniform(0.5, 2.5))
        process.send_signal(signal.SIGKILL)
        process.communicate()
    for path in folder.glob("*.code"):
        if rng.random() < 0.5:
            path.write_bytes(path.read_bytes()[: rng.randrange(200)])
    processes = [start() for _ in range(8)]
    for process in processes:
        finishes_right(process)
    assert list(folder.glob("*.code"))
