"""The examples of a Markdown page."""

from __future__ import annotations

import doctest
from pathlib import Path

ROOT = Path(__file__).parents[1]
TUTORIAL = ROOT / "docs/tutorial.md"


def examples(path: Path) -> doctest.DocTest:
    """The fenced blocks of a page as one doctest, with the page's line numbers."""
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


def script(path: Path) -> str:
    """The code of a page, in order, without prompts and results."""
    return "".join(example.source for example in examples(path).examples)
