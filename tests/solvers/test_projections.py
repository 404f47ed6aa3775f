"""States that are projected onto constraints: the table of `projections`, in numbers and lanes."""

import pytest

from oracles.projections import CASES, check, started

by_case = pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)


@by_case
def test_a_projection_follows_the_table(case):
    states = started(case).integrate(constraints="project")
    check(case, states[0].tolist())


@by_case
def test_lanes_follow_the_table(case):
    system = started(case)
    state = system.states[0]
    runs = system.integrate_ensemble(
        initial_conditions={state: [case.start[0]] * 8},
        constraints="project", workers=1,
    )  # fmt: skip
    assert runs.attrs["lanes"] == 8
    for sample in range(8):
        check(case, [float(runs[s.name].values[sample][0]) for s in system.states])
