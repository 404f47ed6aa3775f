"""Motions that cross the surfaces of events: the table of `crossings`, by every solver."""

import numpy as np
import pytest

from oracles.crossings import CASES, KINDS, check, events, h, numbers, started, v
from registry import ADAPTIVE_NAMES

by_case = pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
TIGHT = {"rtol": 1e-11, "atol": 1e-13}


def judge(case, trajectory, scale=1.0):
    """Check a trajectory."""
    happened = [(record.name, record.time) for record in trajectory.events]
    ended = trajectory.times[-1] < case.end
    last = trajectory.events[-1].after if ended else trajectory.states[-1]
    check(case, happened, scale, last)


@by_case
@pytest.mark.parametrize("scale", [1.0, 1e-9, 1e9])
def test_crossings_follow_the_table_in_every_unit_of_length(case, scale):
    system = started(case, scale)
    judge(case, system.simulate(events=events(), rtol=1e-11, atol=1e-13 * scale), scale)


@by_case
@pytest.mark.parametrize("solver", [s for s in ADAPTIVE_NAMES if s != "dop853"])
def test_every_solver_follows_the_table(case, solver):
    system = started(case)
    system.ode_solver = solver
    judge(case, system.simulate(events=events(), **TIGHT))


@pytest.mark.parametrize("outputs", [2, 26, 41])
@pytest.mark.parametrize("step", [0.005, 0.01, 0.02, 0.03])
def test_an_event_where_a_step_of_fixed_size_ends_happens_once(step, outputs):
    case = next(case for case in CASES if case.name == "bounces at the end of a step")
    system = started(case)
    system.ode_solver, system.times = "rk4", np.linspace(0.0, case.end, outputs)
    judge(case, system.simulate(events=events(), step=step))


@by_case
def test_the_order_of_events_changes_nothing(case):
    judge(case, started(case).simulate(events=events(tuple(reversed(KINDS))), **TIGHT))


def test_an_ensemble_follows_the_table():
    rows = [numbers(case) for case in CASES]
    for end in sorted({case.end for case in CASES}):
        system = started(CASES[0])
        system.times = [0.0, end]
        runs = system.integrate_ensemble(
            initial_conditions={h: [c.h0 for c in CASES], v: [c.v0 for c in CASES]},
            constants={symbol: [row[symbol] for row in rows] for symbol in rows[0]},
            events=events(), reduce=["final", ("events", 16)], workers=1, **TIGHT,
        )  # fmt: skip
        for n, case in enumerate(CASES):
            if case.end != end:
                continue
            happened = []
            for kind in KINDS:
                moments = runs[f"{kind}_times"].values[n]
                happened += [(kind, time) for time in moments[~np.isnan(moments)]]
            happened.sort(key=lambda one: one[1])
            last = [runs[name].values[n] for name in ("h", "v")]
            check(case, happened, last=None if np.isnan(last).all() else last)
