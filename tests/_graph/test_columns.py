"""Columns of sensitivities beside a state, one column apart from what all share."""

import numpy as np
import pytest

import zoo
from pydy._assembly.programs import block_program, jacobian_program
from pydy._graph.columns import SensitivityColumns
from pydy._program.interpret import run
from pydy.models import n_link_pendulum_on_cart
from zoo.cases import system_of

DIRECTIONS = (None, ("p", 0), ("p", 2), None, ("p", 0))


def made_of(assembly, directions):
    """Columns, and the derivatives of states and columns by time."""
    columns = SensitivityColumns(assembly.sizes[0], directions)
    return columns, columns.tangent(*assembly.simplified("rates"), assembly.sizes, "rates")


def assembly_of(system):
    system.generate_ode_function()
    return system.model.assembly


def by_jacobians(assembly, columns, t, x, r, p):
    """The same from whole Jacobians: f, then S' = (∂f/∂x) S + (∂f/∂p) dp."""
    states, values = columns.split(x)
    n = columns.states
    blocks = [
        block_program(assembly, "rates"),
        *(jacobian_program(assembly, "rates", k) for k in "xp"),
    ]
    f, by_state, by_constant = (run(block, t, states, r, p)[0] for block in blocks)
    dp = np.array([[float(d == ("p", k)) for d in columns.directions] for k in range(len(p))])
    moved = by_state.reshape(-1, n, n) @ values + by_constant.reshape(-1, n, len(p)) @ dp
    return columns.together(f, moved)


@pytest.mark.parametrize("name", ["fourbar", "disc", "gyro", "sleigh"])
def test_columns_are_those_of_whole_jacobians(name):
    assembly = assembly_of(system_of(getattr(zoo, name)()))
    columns, made = made_of(assembly, DIRECTIONS)
    n, s, c = assembly.sizes
    rng = np.random.default_rng(3)
    x, r, p = (
        rng.uniform(0.3, 1.2, (1, columns.size)),
        rng.uniform(size=(1, s)),
        rng.uniform(0.5, 1.5, c),
    )
    t = np.array([0.3])
    expected = by_jacobians(assembly, columns, t, x, r, p)
    assert np.allclose(run(made.written_out(), t, x, r, p)[0], expected, rtol=1e-10, atol=1e-10)
    states, values = columns.split(x)
    first = run(made.shared, t, states, r, p)[0]
    assert np.allclose(first[0, :n], expected[0, :n], rtol=1e-12, atol=1e-12)
    (part,) = made.parts
    for k, direction in enumerate(made.directions.T):
        one = run(part.program, t, values[:, :, k], first[:, n:], direction)[0][0]
        exact = expected[0, n:].reshape(n, -1)[:, k]
        assert np.allclose(one, exact, rtol=1e-10, atol=1e-10)


@pytest.mark.parametrize("direction", [None, ("p", 0)])
def test_the_number_of_columns_is_part_of_the_digest(direction):
    assembly = assembly_of(n_link_pendulum_on_cart(1))
    digests = {made_of(assembly, (direction,) * count)[1].digest for count in (1, 2, 3)}
    assert len(digests) == 3


def test_a_column_takes_little_more_than_the_states():
    assembly = assembly_of(n_link_pendulum_on_cart(5))
    _, made = made_of(assembly, (("p", 0), ("p", 1), *[None] * 6))
    plain = block_program(assembly, "rates").operation_count["run"].total()
    code = [made.shared, *(part.program for part in made.parts)]
    both = sum(program.operation_count["run"].total() for program in code)
    assert plain == 229
    assert both <= 813
    assert made.written_out().operation_count["run"].total() > 3.7 * both


def test_both_parts_are_printed():
    _, made = made_of(assembly_of(n_link_pendulum_on_cart(1)), (("p", 0), None))
    text = str(made)
    assert "For each of the columns 0 to 1:" in text
    assert "column" in text


def test_states_and_columns_are_put_together_and_taken_apart():
    columns = SensitivityColumns(3, (None, ("p", 0), None, None))
    states, values = np.arange(6.0).reshape(2, 3), np.arange(24.0).reshape(2, 3, 4)
    whole = columns.together(states, values)
    assert whole.shape == (2, 15)
    states_again, table = columns.split(whole)
    assert np.array_equal(states_again, states)
    assert np.array_equal(table, values)
