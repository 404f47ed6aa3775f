"""Times of tests are measured, and slow tests that the table lacks fail the run by name."""

import subprocess
import sys
from pathlib import Path

import pytest

import parts

CONFTEST = Path(__file__).with_name("conftest.py")


@pytest.fixture
def project(tmp_path):
    """A folder with a test that computes for a tenth of a second, and one that sleeps."""
    (tmp_path / "test_it.py").write_text(
        "import time\n"
        "def test_busy():\n"
        "    end = time.process_time() + 0.1\n"
        "    while time.process_time() < end:\n"
        "        pass\n"
        "def test_asleep():\n"
        "    time.sleep(0.2)\n"
    )
    (tmp_path / "conftest.py").write_text(
        "from pathlib import Path\n"
        "import parts, timing\n"
        "parts.TABLE, parts.LIMIT = Path(__file__).with_name('slow.txt'), 0.009\n"
        "timing.FACTOR = 10\n"
        "def pytest_configure(config):\n"
        "    config.pluginmanager.register(timing.Times())\n"
    )
    (tmp_path / "slow.txt").write_text("# seconds; ten million turns of a Python loop took 100 s\n")
    return tmp_path


def run(project, monkeypatch, *arguments, record=False):
    monkeypatch.setenv("PYTHONPATH", str(CONFTEST.parent))
    if not record:
        monkeypatch.delenv(parts.RECORD, raising=False)
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *arguments]
    return subprocess.run(command, cwd=project, capture_output=True, text=True, check=False)


@pytest.mark.parametrize("workers", [[], ["-n", "1"]], ids=["one process", "a worker"])
def test_a_slow_test_that_the_table_lacks_fails_the_run_by_name(project, monkeypatch, workers):
    done = run(project, monkeypatch, *workers)
    assert done.returncode == 1
    assert "2 passed" in done.stdout
    assert "test_it.py::test_busy" in done.stdout
    assert "test_asleep" not in done.stdout
    assert "run `make times`" in done.stdout


def test_what_runs_in_a_browser_needs_no_row(project, monkeypatch):
    (project / parts.ASKED_FOR).mkdir(parents=True)
    (project / "test_it.py").rename(project / parts.ASKED_FOR / "test_it.py")
    done = run(project, monkeypatch, parts.ASKED_FOR)
    assert done.returncode == 0, done.stdout
    assert "2 passed" in done.stdout


def test_recorded_times_are_a_table_with_which_the_run_passes(project, monkeypatch):
    monkeypatch.setenv(parts.RECORD, "1")
    assert run(project, monkeypatch, record=True).returncode == 0
    monkeypatch.setattr(parts, "TABLE", project / "slow.txt")
    assert list(parts.read_table()) == ["test_it.py::test_busy"]
    assert 0.09 < parts.read_table()["test_it.py::test_busy"] < 1.0
    assert run(project, monkeypatch).returncode == 0
