"""Columns of sensitivities beside a state: all in one Program, or one column apart."""

import numpy as np
import pytest

import zoo
from cases import system_of
from pydy._graph.columns import Columns
from pydy._graph.interpret import run
from pydy._graph.split import SplitProgram
from pydy.models import n_link_pendulum_on_cart

DIRECTIONS = (None, ("p", 0), ("p", 2), None, ("p", 0))


def programs(assembly, directions):
    """The Program of all columns, and those of the shared part and of one column."""
    columns = Columns(assembly.sizes[0], directions)
    parts = assembly.sizes, assembly.passes
    whole = columns.rates_program(*assembly.simplified("rates"), *parts)
    return columns, whole, columns.split_programs(*assembly.simplified("rates"), *parts)


def assembly_of(system):
    system.generate_ode_function()
    return system.model.assembly


@pytest.mark.parametrize("name", ["fourbar", "disc", "gyro", "sleigh"])
def test_the_derivatives_of_one_column_are_those_of_all(name):
    assembly = assembly_of(system_of(getattr(zoo, name)()))
    columns, whole, (shared, column) = programs(assembly, DIRECTIONS)
    n, s, c = assembly.sizes
    rng = np.random.default_rng(3)
    x, r, p = (
        rng.uniform(0.3, 1.2, (1, columns.size)),
        rng.uniform(size=(1, s)),
        rng.uniform(0.5, 1.5, c),
    )
    t = np.array([0.3])
    expected = run(whole, t, x, r, p)[0][0]
    states, values = columns.apart(x)
    first = run(shared, t, states, r, p)[0]
    assert np.allclose(first[0, :n], expected[:n], rtol=1e-12, atol=1e-12)
    for k, direction in enumerate(columns.table().T):
        one = run(column, t, values[:, :, k], first[:, n:], direction)[0][0]
        exact = expected[n:].reshape(n, -1)[:, k]
        assert np.allclose(one, exact, rtol=1e-10, atol=1e-10)


@pytest.mark.parametrize("direction", [None, ("p", 0)])
def test_the_number_of_columns_is_part_of_the_digest(direction):
    assembly = assembly_of(n_link_pendulum_on_cart(1))
    digests = set()
    for count in (1, 2, 3):
        columns, _, parts = programs(assembly, (direction,) * count)
        digests.add(SplitProgram(*parts, columns.table()).digest)
    assert len(digests) == 3


def test_a_column_takes_little_more_than_the_states():
    assembly = assembly_of(n_link_pendulum_on_cart(5))
    columns, whole, (shared, column) = programs(assembly, (("p", 0), ("p", 1), *[None] * 6))
    plain = assembly.program("rates").operation_count["run"].total()
    both = SplitProgram(shared, column, columns.table())
    assert plain == 229
    assert both.operation_count["run"].total() <= 813
    assert whole.operation_count["run"].total() > 3.7 * both.operation_count["run"].total()


def test_both_parts_are_printed():
    assembly = assembly_of(n_link_pendulum_on_cart(1))
    columns, _, parts = programs(assembly, (("p", 0), None))
    text = str(SplitProgram(*parts, columns.table()))
    assert "For each of 2 columns:" in text
    assert "column" in text


def test_states_and_columns_are_put_together_and_taken_apart():
    columns = Columns(3, (None, ("p", 0), None, None))
    states, values = np.arange(6.0).reshape(2, 3), np.arange(18.0).reshape(2, 3, 3)
    whole = columns.together(states, values)
    assert whole.shape == (2, 15)
    again, table = columns.apart(whole)
    assert np.array_equal(again, states)
    assert np.array_equal(table[..., :3], values)
    assert not table[..., 3].any()
