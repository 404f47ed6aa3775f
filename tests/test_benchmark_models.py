"""Models of the benchmarks that are written down are those that SymPy derives."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))

import trees
from harness import frozen
from harness.bicycles import Costs
from harness.program import assembly_of
from harness.samples import samples
from harness.written_down import arm_written_down, pendulum_written_down, rods_written_down

from pydy._assembly.programs import block_program
from pydy._program.interpret import run
from pydy.system import System


@pytest.mark.parametrize("n", [5, 10])
def test_the_pendulum_written_down_gives_the_very_program_of_the_derived_one(n):
    derived, written = frozen.read(f"pendulum-{n}"), pendulum_written_down(n)
    blocks = ("rates", "mass_matrix", "forcing")
    programs = [block_program(assembly_of(model), *blocks) for model in (derived, written)]
    assert programs[0].digest == programs[1].digest


@pytest.mark.parametrize("universal", [False, True])
def test_the_rods_written_down_move_as_the_derived_ones_do(universal):
    derived = frozen.read("rods-universal-3" if universal else "rods-3")
    written = rods_written_down(3, universal=universal)
    assert derived.constants == written.constants
    x, r, p = samples(derived, 20)
    found, expected = (
        run(block_program(assembly_of(m), "rates", "mass_matrix"), np.zeros(20), x, r, p * 1.1)[0]
        for m in (written, derived)
    )
    np.testing.assert_allclose(found, expected, rtol=1e-11, atol=1e-11 * abs(expected).max())


def test_the_arm_written_down_moves_as_the_one_made_of_bodies_does(monkeypatch):
    model = arm_written_down(4)
    values = dict(zip((s.name for s in model.constants), model.values, strict=True))
    x, r, p = samples(model, 1)
    links = [
        {
            "parent": k - 1,
            "axis": [float(k % 3 == i) for i in range(3)],
            "turn": [0.0] * 3,
            "place": [0.0, 0.0, values[f"l{k - 1}"] if k else 0.0],
            "mass": values[f"m{k}"],
            "centre": [values[f"c{k}_{axis}"] for axis in "xyz"],
            "inertia": [values[f"I{k}_{axes}"] for axes in ("xx", "yy", "zz", "xy", "yz", "zx")],
        }
        for k in range(4)
    ]
    monkeypatch.setattr(trees, "GRAVITY", (0.0, 0.0, -values["g"]))
    made = {"links": links, "q": x[0, :4], "v": x[0, 4:], "torques": r[0].tolist()}
    expected = System(trees.definition(made)).evaluate_ode(x[0])
    found = run(block_program(assembly_of(model), "rates"), np.zeros(1), x, r, p)[0]
    np.testing.assert_allclose(found.ravel(), expected, rtol=1e-10)


def test_the_time_on_a_cluster_counts_rounds_of_blocks_and_the_clients_work():
    costs = Costs(trajectory=0.5, serial=0.25, block=2.0, task=0.0, start=3.0)
    # Ten blocks of eight on four cores: three rounds of 4 s, 20 s for all values, 20 s for blocks.
    assert costs.seconds(80, 8, 4) == 3.0 + 20.0 + 20.0 + 3 * 4.0
    assert costs.efficiency(80, 8, 4) == 40.0 / (4 * 55.0)
    alone = Costs(trajectory=0.5, serial=0.0, block=0.0, task=0.0, start=0.0)
    assert alone.efficiency(80, 8, 10) == 1.0
    assert alone.efficiency(80, 8, 20) == 0.5
