"""Every script in `examples/` runs, at small size, and holds its own checks."""

import runpy
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest

EXAMPLES = sorted(Path(__file__).parents[2].glob("examples/*.py"))


@pytest.fixture
def no_window(monkeypatch):
    """Figures are drawn in memory; none is there before, and none is left over."""
    plt.close("all")
    plt.switch_backend("agg")
    monkeypatch.setattr(plt, "show", lambda: None)
    yield
    plt.close("all")


def test_there_are_at_least_ten_examples():
    assert len(EXAMPLES) >= 10


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_checks_itself_and_draws(path, monkeypatch, no_window, capsys, tmp_path):
    monkeypatch.setattr(sys, "argv", [str(path), "--small"])
    runpy.run_path(str(path), run_name="__main__")  # it asserts what it prints
    assert capsys.readouterr().out
    (number,) = plt.get_fignums()
    picture = tmp_path / "figure.png"
    plt.figure(number).savefig(picture)
    pixels = plt.imread(picture)
    assert np.ptp(pixels[..., :3]) > 0.5
