"""Motions that start on the surface of an event: the table of `departures`, by every solver."""

import warnings

import numpy as np
import pytest

from oracles.departures import CASES, Case, check, events, h, numbers, started, v
from pydy.errors import PyDyUserWarning
from pydy.solvers import Event
from pydy.solvers.outcome import Outcome
from pydy.solvers.solver import SOLVERS
from pydy.system import System

by_case = pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)


def simulated(system: System, wanted: list[Event] | None = None, **options):
    """Simulate without the warning that events accumulate."""
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "`.*` stopped at t = .*: the events", PyDyUserWarning)
        return system.simulate(events=wanted or events(), **options)


def judge(case: Case, trajectory, offset: float = 0.0) -> None:
    """Check a trajectory, and what its event did at the start."""
    first = [record for record in trajectory.events if record.time == 0.0]
    moments = [record.time for record in trajectory.events]
    check(case, moments, (trajectory.states[:, 0] - offset).tolist(), len(trajectory.times) < 3)
    if case.acts:
        ended = trajectory.statistics["code"] in (Outcome.TERMINATED, Outcome.EVENTS_ACCUMULATE)
        assert ended or (first[0].after != first[0].before).any()
    elif case.recorded:
        np.testing.assert_array_equal(first[0].after, first[0].before)


@by_case
@pytest.mark.parametrize(
    ("scale", "offset"), [(1.0, 0.0), (1e-9, 0.0), (1e9, 0.0), (1.0, 0.1), (1e-9, 3e-9)]
)
def test_a_motion_that_starts_on_a_surface_follows_the_table(case, scale, offset):
    trajectory = simulated(started(case, scale, offset), rtol=1e-10, atol=1e-12 * scale)
    judge(case, trajectory, offset)


@by_case
@pytest.mark.parametrize("solver", [s for s in SOLVERS if s != "dop853"])
def test_every_solver_follows_the_table(case, solver):
    system = started(case)
    system.ode_solver = solver
    options = {"step": 1e-3} if solver == "rk4" else {"rtol": 1e-8, "atol": 1e-10}
    judge(case, simulated(system, **options))


def test_an_ensemble_follows_the_table():
    system = started(CASES[0])
    rows = [numbers(case) for case in CASES]
    # Eight lanes work side by side: the other samples are simulated one by one.
    runs = system.integrate_ensemble(
        initial_conditions={h: [0.0] * len(CASES), v: [case.v0 for case in CASES]},
        constants={symbol: [row[symbol] for row in rows] for symbol in rows[0]},
        events=events(), reduce=["final", ("events", 8)], rtol=1e-10, atol=1e-12, workers=1,
    )  # fmt: skip
    for k, case in enumerate(CASES):
        moments = np.concatenate([runs[f"{e.name}_times"].values[k] for e in events()])
        heights = [float(runs["h"].values[k])]
        ended = bool(runs["end_time"].values[k] < 0.1)
        check(case, sorted(moments[~np.isnan(moments)].tolist()), heights, ended)
