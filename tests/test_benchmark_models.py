"""Models of the benchmarks that are written down are those that SymPy derives."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))

from harness import frozen
from harness.program import assembly_of
from harness.samples import samples
from harness.written_down import pendulum_written_down, rods_written_down

from pydy._graph.interpret import run


@pytest.mark.parametrize("n", [5, 10])
def test_the_pendulum_written_down_gives_the_very_program_of_the_derived_one(n):
    derived, written = frozen.read(f"pendulum-{n}"), pendulum_written_down(n)
    blocks = ("rates", "mass_matrix", "forcing")
    programs = [assembly_of(model).program(*blocks) for model in (derived, written)]
    assert programs[0].digest == programs[1].digest


def test_the_rods_written_down_move_as_the_derived_ones_do():
    derived, written = frozen.read("rods-3"), rods_written_down(3)
    assert derived.constants == written.constants
    x, r, p = samples(derived, 20)
    found, expected = (
        run(assembly_of(m).program("rates", "mass_matrix"), np.zeros(20), x, r, p * 1.1)[0]
        for m in (written, derived)
    )
    np.testing.assert_allclose(found, expected, rtol=1e-11, atol=1e-11 * abs(expected).max())
