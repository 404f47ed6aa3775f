"""README.md and docs/ promise numbers; run their examples and compare them."""

import doctest
import os
import subprocess
import sys

import pytest

from optional import optional
from pages import ROOT, TUTORIAL, examples, script

plt = optional("matplotlib.pyplot")

# What the gallery's pages show runs in tests/examples.
PAGES = [page for page in sorted(ROOT.glob("docs/**/*.md")) if "gallery" not in page.parts]
DOCUMENTS = [page for page in (ROOT / "README.md", *PAGES) if examples(page).examples]

LIBRARIES = {"layers.md": "jax"}


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_the_examples_of_a_page_print_what_they_show(path, tmp_path, monkeypatch):
    if path.name in LIBRARIES:
        pytest.importorskip(LIBRARIES[path.name], reason="the page needs it")
    monkeypatch.chdir(tmp_path)  # some write files
    plt.switch_backend("agg")
    flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
    report: list[str] = []
    results = doctest.DocTestRunner(optionflags=flags).run(examples(path), out=report.append)
    plt.close("all")
    assert results.failed == 0, "".join(report)


def test_the_tutorial_works_from_a_fresh_start(tmp_path):
    command = [sys.executable, "-W", "error", "-c", script(TUTORIAL)]
    environment = {**os.environ, "MPLBACKEND": "agg"}
    done = subprocess.run(
        command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "pendulum.png").stat().st_size > 10_000
    assert (tmp_path / "pendulum.html").stat().st_size > 100_000


@pytest.mark.parametrize(
    ("name", "least"),
    [
        ("README.md", 20),
        ("docs/system.md", 80),
        ("docs/results.md", 50),
        ("docs/solvers.md", 30),
        ("docs/animation.md", 30),
        ("docs/tutorial.md", 30),
        ("docs/ensembles.md", 10),
    ],
)
def test_the_main_pages_have_examples(name, least):
    assert len(examples(ROOT / name).examples) >= least
