"""The examples of the gallery: scripts in cells."""

import re
from pathlib import Path
from types import SimpleNamespace

EXAMPLES = sorted(Path(__file__).parents[1].glob("examples/*.py"))


def cells(path: Path) -> list[str]:
    """Return the parts of a script between its lines ``# %%``."""
    return re.split(r"^# %%.*\n", path.read_text(encoding="utf-8"), flags=re.MULTILINE)


def definitions(name: str, before: str) -> SimpleNamespace:
    """Return what an example defines before the cell that holds a text."""
    (path,) = (path for path in EXAMPLES if path.stem == name)
    first = []
    for cell in cells(path):
        if before in cell:
            break
        first.append(cell)
    names = {"__name__": name}
    exec("".join(first), names)
    return SimpleNamespace(**names)
