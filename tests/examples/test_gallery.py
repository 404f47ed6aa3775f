"""Every script in `examples/` runs, at small size, holds its own checks, and shows what it does."""

import ast

import numpy as np
import pytest

from gallery import EXAMPLES, SMALLER, cells, smaller
from optional import optional
from pydy.viz import Scene

plt = optional("matplotlib.pyplot")


@pytest.fixture
def no_window(monkeypatch):
    """Figures are drawn in memory; none is there before, and none is left over."""
    plt.close("all")
    plt.switch_backend("agg")
    monkeypatch.setattr("matplotlib.pyplot.show", lambda: None)
    yield
    plt.close("all")


@pytest.fixture
def animated(monkeypatch):
    """The scenes that are set in motion."""
    scenes, animate = [], Scene.animate

    def remembered(self, *arguments, **options):
        scenes.append(animate(self, *arguments, **options))
        return self

    monkeypatch.setattr(Scene, "animate", remembered)
    return scenes


def test_there_are_at_least_24_examples():
    assert len(EXAMPLES) >= 24


def test_the_numbers_of_short_runs_stand_in_the_examples():
    assert set(SMALLER) <= {path.stem for path in EXAMPLES}
    for path in EXAMPLES:
        assert (smaller(path) != path.read_text(encoding="utf-8")) == (path.stem in SMALLER)


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_has_nothing_that_serves_its_tests_alone(path):
    text = path.read_text(encoding="utf-8")
    assert "sys.argv" not in text
    assert "for the tests" not in text


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_goes_in_steps_of_prose_code_and_picture(path):
    first, *rest = cells(path)
    assert len(ast.get_docstring(ast.parse(first)).splitlines()) > 5
    assert len(rest) >= 5
    explained = [cell for cell in rest if cell.startswith("# ")]
    assert len(explained) >= 4
    assert max(len(cell.splitlines()) for cell in rest) <= 130
    pictures = [cell for cell in rest if "plt.subplots(" in cell or "plt.figure(" in cell]
    assert pictures
    assert any(".animate(" in cell for cell in rest)


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_checks_itself_draws_and_moves(path, no_window, animated, capsys, tmp_path):
    code = compile(smaller(path), str(path), "exec")
    exec(code, {"__name__": "__main__", "__file__": str(path)})  # it asserts what it prints
    assert capsys.readouterr().out
    assert plt.get_fignums()
    for number in plt.get_fignums():
        picture = tmp_path / "figure.png"
        plt.figure(number).savefig(picture)
        pixels = plt.imread(picture)
        assert np.ptp(pixels[..., :3]) > 0.5
    assert animated
    for scene in animated:
        assert np.isfinite(scene.poses).all()
        assert np.ptp(scene.poses, axis=0).max() > 1e-3  # something moves
