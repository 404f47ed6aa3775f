"""Texts of names and numbers in messages."""

import pytest

from pydy._names import counted


@pytest.mark.parametrize(("number", "text"), [(0, "0 links"), (1, "1 link"), (2, "2 links")])
def test_a_noun_agrees_with_its_number(number, text):
    assert counted(number, "link") == text
