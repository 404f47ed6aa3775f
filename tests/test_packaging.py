"""What pyproject.toml promises: extras hold what they are for."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def packages(extra):
    """Return the packages of an extra, those of the extras in it included."""
    found = set()
    for requirement in PROJECT["optional-dependencies"][extra]:
        name, extras = re.match(r"([\w-]+)(?:\[([\w,]+)\])?", requirement).groups()
        if name == "pydy":
            found.update(*map(packages, extras.split(",")))
        else:
            found.add(name.lower())
    return found


def test_all_is_what_users_need_and_no_tool_of_contributors():
    features = {"control", "cython", "ensemble", "labels", "optimal", "plot", "robots"}
    assert packages("all") == set().union(*map(packages, features))
    tools = {"ruff", "mypy", "pytest", "sphinx", "furo", "ziglang", "playwright"}
    assert not packages("all") & tools


@pytest.mark.parametrize("extra", ["plot", "labels", "ensemble"])
def test_the_docs_have_what_the_gallery_shows(extra):
    assert packages(extra) <= packages("docs")
