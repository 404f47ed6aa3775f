"""Processes that compile: none is left behind, whenever a Ctrl-C comes."""

import signal
import subprocess
import sys

import pytest

from pydy._processes import output_of, started


@pytest.fixture(autouse=True)
def pythons_own_handler():
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize("when", ["as it starts", "while it works"])
def test_a_ctrl_c_ends_the_process(monkeypatch, when):
    known = []

    class Popen(subprocess.Popen):
        def __init__(self, *arguments, **options):
            super().__init__(*arguments, **options)
            known.append(self)
            if when == "as it starts":
                signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(subprocess, "Popen", Popen)

    def work():
        with started([sys.executable, "-c", "import time; time.sleep(600)"]):
            signal.raise_signal(signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        work()
    assert known[0].returncode
    assert known[0].stdout.closed


def test_the_output_of_a_process_that_takes_its_time_is_whole():
    code = "import sys, time; print(1); sys.stdout.flush(); time.sleep(0.3); print(2)"
    with started([sys.executable, "-c", code]) as process:
        assert output_of(process).split() == ["1", "2"]
    assert process.returncode == 0
