"""Columns of sensitivities in vector registers."""

import numpy as np
import pytest

import zoo
from cases import system_of
from pydy._backends.llvm.backend import LLVMBackend
from pydy._backends.llvm.columns import compile_columns, lanes_for
from pydy._graph.columns import Columns
from pydy._graph.split import SplitProgram


@pytest.mark.parametrize(("columns", "lanes"), [(1, 2), (2, 2), (3, 4), (4, 4), (5, 8), (40, 8)])
def test_as_many_columns_are_taken_as_there_are(columns, lanes):
    assert lanes_for(columns) == lanes


@pytest.mark.parametrize("count", [2, 4, 8, 24])
@pytest.mark.parametrize("name", ["fourbar", "disc", "lifted"])
def test_columns_side_by_side_are_those_of_one_program(name, count):
    system = system_of(getattr(zoo, name)())
    system.generate_ode_function()
    assembly = system.model.assembly
    n, s, c = assembly.sizes
    columns = Columns(n, tuple(("p", k % c) if k % 2 else None for k in range(count)))
    parts = assembly.sizes, assembly.passes
    whole = columns.rates_program(*assembly.simplified("rates"), *parts)
    split = columns.split_programs(*assembly.simplified("rates"), *parts)
    fast = compile_columns(SplitProgram(*split, columns.table()))
    rng = np.random.default_rng(1)
    m = 3
    x, r = rng.uniform(0.3, 1.2, (m, columns.size)), rng.uniform(size=(m, s))
    t, p = np.linspace(0.1, 0.3, m), rng.uniform(0.5, 1.5, c)
    expected, _ = LLVMBackend().compile(whole).evaluate(t, x, r, p)
    found, failed = fast.evaluate(t, x, r, p)
    assert not failed.any()
    assert np.allclose(found, expected, rtol=1e-10, atol=1e-9)
    assert len(fast.program.outputs) == fast.program.num_states == columns.size
