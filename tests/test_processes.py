"""Processes that compile: none is left behind, whenever a Ctrl-C comes."""

import signal
import subprocess
import sys
from pathlib import Path

import pytest

from pydy._processes import output_of, started


@pytest.fixture(autouse=True)
def pythons_own_handler():
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize("when", ["as it starts", "while it works"])
def test_a_ctrl_c_ends_the_process(monkeypatch, tmp_path, when):
    known = []

    class Popen(subprocess.Popen):
        def __init__(self, *arguments, **options):
            super().__init__(*arguments, **options)
            known.append(self)
            if when == "as it starts":
                signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(subprocess, "Popen", Popen)

    def work():
        with started([sys.executable, "-c", "import time; time.sleep(600)"], tmp_path):
            signal.raise_signal(signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        work()
    assert known[0].returncode
    assert known[0].stdout.closed


def test_the_output_of_a_process_that_takes_its_time_is_whole(tmp_path):
    code = "import sys, time; print(1); sys.stdout.flush(); time.sleep(0.3); print(2)"
    with started([sys.executable, "-c", code], tmp_path) as process:
        assert output_of(process).split() == ["1", "2"]
    assert process.returncode == 0


def test_temporary_files_of_a_command_are_in_its_folder(tmp_path):
    """A compiler that is killed leaves its own behind, which go with the folder."""
    command = [sys.executable, "-c", "import tempfile; print(tempfile.gettempdir())"]
    with started(command, tmp_path) as process:
        assert Path(output_of(process).strip()) == tmp_path
