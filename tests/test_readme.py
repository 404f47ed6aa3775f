"""README.md and docs/ promise numbers; run their examples and compare them."""

import doctest
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
# The design page tells of decisions and has nothing to run.
DOCUMENTS = [ROOT / "README.md", *sorted({*ROOT.glob("docs/*.md")} - {ROOT / "docs/design.md"})]


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


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_the_examples_of_a_page_print_what_they_show(path, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # some write files
    flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
    report: list[str] = []
    results = doctest.DocTestRunner(optionflags=flags).run(examples(path), out=report.append)
    assert results.failed == 0, "".join(report)


@pytest.mark.parametrize(
    ("name", "least"),
    [
        ("README.md", 20),
        ("docs/system.md", 80),
        ("docs/results.md", 50),
        ("docs/solvers.md", 30),
        ("docs/animation.md", 30),
    ],
)
def test_the_main_pages_have_examples(name, least):
    assert len(examples(ROOT / name).examples) >= least
