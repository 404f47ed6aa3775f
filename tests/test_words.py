"""Words in what users and contributors read."""

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


def test_the_words_of_the_glossary_for_contributors_occur_where_it_says():
    page = (ROOT / "docs/contributing/glossary.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| ([a-z -]+) \| (.+) \| (`.+`) \|$", page, re.MULTILINE)
    assert len(rows) > 40
    assert len(rows) == page.count("\n| ") - page.count("\n| word |")
    missing = []
    for word, _, files in rows:
        # A word, or a part of a name: of a variable, a class or a constant.
        lower, title = (re.sub("[ -]", "[-_ ]?", w) for w in (word, word.title()))
        spelled = re.compile(
            rf"(?<![A-Za-z])({lower}|{lower.upper()})(s|d|ed|ing)?(?![a-z])|{title}s?(?![a-z])"
        )
        for file in re.findall(r"`(.+?)`", files):
            path = ROOT / "src/pydy" / file
            if not path.is_file() or not spelled.search(path.read_text(encoding="utf-8")):
                missing.append(f"{word}: {file}")
    assert not missing


def test_the_glossary_for_contributors_is_in_order():
    page = (ROOT / "docs/contributing/glossary.md").read_text(encoding="utf-8")
    for section in page.split("\n## ")[1:]:
        words = re.findall(r"^\| ([a-z -]+) \| ", section, re.MULTILINE)[1:]
        assert words == sorted(set(words)), section.splitlines()[0]
