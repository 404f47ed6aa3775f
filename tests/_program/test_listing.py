"""A Program prints itself."""

import re

import pytest
import sympy as sm

from graphs import P, T, X, program_of, solve_program
from pydy._program.program import listing

x, y, *_ = X
a, b, _ = P


@pytest.fixture
def program():
    return program_of([a * b * sm.sin(x) + T, sm.Piecewise((y, x < y), (2, True))])


def test_a_listing_begins_with_sizes_and_counts(program):
    first, setup, run, *_ = str(program).splitlines()
    assert first.startswith("Program: 4 states, 3 constants and time -> ")
    assert setup == "  set-up stage, once for each set of constants: 1 operations (1 mul)"
    assert "1 sin" in run


def test_a_listing_has_a_line_for_each_operation_in_an_order_that_can_be_computed(program):
    lines = str(program).splitlines()
    known = set()
    count = 0
    for line in lines[lines.index("set-up stage:") : lines.index("outputs:")]:
        found = re.match(r"  ([cv]\d+) = (.*)", line)
        if found:
            assert set(re.findall(r"\b[cv]\d+\b", found[2])) <= known
            known.add(found[1])
            count += 1
    assert count == sum(sum(c.values()) for c in program.operation_count.values())
    assert set(re.findall(r"\b[cv]\d+\b", lines[-1])) <= known


def test_inputs_have_the_names_that_are_given(program):
    names = {"x": ["angle", "rate"], "p": ["m", "l"]}
    text = listing(program, names)
    assert "sin(angle)" in text
    assert re.search(r"= (m \* l|l \* m)$", text, re.MULTILINE)


def test_a_long_listing_says_how_much_it_leaves_out():
    long = program_of([sum(sm.sin(k * x) for k in range(1, 150))])
    assert re.search(r"\.\.\. \d+ more: listing\(program, most_lines=None\)", str(long))
    assert "more:" not in listing(long, most_lines=None)


@pytest.mark.parametrize(
    ("n", "kind", "text"),
    [
        (2, "ldl", "where v"),
        (2, "lu", "where v"),
        (30, "ldl", "factors of a 30 x 30 matrix, LDL^T"),
        (30, "lu", "factors of a 30 x 30 matrix, LU with partial pivoting"),
    ],
)
def test_linear_solves_are_named(n, kind, text):
    found = str(solve_program(n, kind))
    assert text in found
    assert re.search(r"solution (with|of)", found)
