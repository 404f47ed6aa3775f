"""Words in what users read."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
PAGES = [page for page in PAGES if "gallery" not in page.parts]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_a_system_is_called_system(page):
    text = page.read_text(encoding="utf-8")
    found = re.findall(r"^.*\bsys(?:\.| = ).*$", text.replace("import sys", ""), re.MULTILINE)
    assert found == []


def test_sentences_are_english():
    files = [*PAGES, *(ROOT / "examples").rglob("*.py"), *(ROOT / "src").rglob("*.py")]
    for file in files:
        text = " ".join(file.read_text(encoding="utf-8").split())
        for odd in ("falls on the ground", "rad off top", "It is not where the"):
            assert odd not in text, file


def test_the_first_version_has_mended_nothing():
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    first = text.split("## [1.0.0]")[1].split("\n## [")[0]
    headings = re.findall(r"^### (.*)$", first, re.MULTILINE)
    assert headings
    assert not {"Changed", "Deprecated", "Fixed", "Removed", "Security"} & set(headings)
