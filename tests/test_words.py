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
