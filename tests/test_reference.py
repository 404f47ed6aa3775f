"""The reference in docs/ has every public module; Sphinx takes the names from their `__all__`."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]


def shows_names(path):
    """Whether a file says what it shows."""
    return "\n__all__ = " in path.read_text(encoding="utf-8")


def public_modules():
    """Modules with an `__all__` and no underscore in their path; of a package that has one, it."""
    for path in sorted((ROOT / "src/pydy").rglob("*.py")):
        parts = path.relative_to(ROOT / "src").with_suffix("").parts
        name = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
        if name == "pydy" or "._" in name:
            continue
        above = [ROOT / "src" / Path(*parts[:k]) / "__init__.py" for k in range(2, len(parts))]
        inside = any(shows_names(package) for package in above if package != path)
        if shows_names(path) and not inside:
            yield name


@pytest.mark.parametrize("module", list(public_modules()))
def test_a_public_module_is_in_the_reference(module):
    pages = "\n".join(p.read_text(encoding="utf-8") for p in ROOT.glob("docs/reference/*.md"))
    assert module in re.findall(r"automodule:: (\S+)", pages)
