"""README.md and docs/ promise numbers; run their examples and compare them."""

import doctest
import os
import subprocess
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import pytest

ROOT = Path(__file__).parents[1]
# What the gallery's pages show runs in tests/examples.
PAGES = [page for page in sorted(ROOT.glob("docs/**/*.md")) if "gallery" not in page.parts]


def examples(path):
    """The fenced blocks of a Markdown page as one doctest, with the page's line numbers."""
    lines = path.read_text(encoding="utf-8").splitlines()
    fenced = False
    for k, line in enumerate(lines):
        if line.startswith("```"):
            fenced = not fenced
            lines[k] = ""
        elif not fenced:
            lines[k] = ""  # or a line of prose below a closing fence would count as output
        elif not line and not lines[k + 1].startswith((">>>", "```")):
            lines[k] = "<BLANKLINE>"  # doctest would end the output here
    return doctest.DocTestParser().get_doctest("\n".join(lines), {}, path.name, str(path), 0)


DOCUMENTS = [page for page in (ROOT / "README.md", *PAGES) if examples(page).examples]


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_the_examples_of_a_page_print_what_they_show(path, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    plt.switch_backend("agg")
    flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
    report: list[str] = []
    results = doctest.DocTestRunner(optionflags=flags).run(examples(path), out=report.append)
    plt.close("all")
    assert results.failed == 0, "".join(report)


def test_the_tutorial_works_from_a_fresh_start(tmp_path):
    code = "".join(example.source for example in examples(ROOT / "docs/tutorial.md").examples)
    environment = {**os.environ, "MPLBACKEND": "agg"}
    command = [sys.executable, "-W", "error", "-c", code]
    done = subprocess.run(
        command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "pendulum.png").stat().st_size > 10_000


@pytest.mark.parametrize(
    ("name", "least"),
    [
        ("README.md", 20),
        ("docs/system.md", 80),
        ("docs/results.md", 50),
        ("docs/tutorial.md", 30),
    ],
)
def test_the_main_pages_have_examples(name, least):
    assert len(examples(ROOT / name).examples) >= least
