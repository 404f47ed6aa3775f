"""Functions of points are derived once: for a model, and from the cache in later processes."""

import pickle

import numpy as np
import pytest
import sympy as sm

from oracles import optima
from oracles.optima import T
from pydy.control import OptimalControl, kernel
from pydy.control.transcription import Transcription


@pytest.fixture
def derived(monkeypatch, tmp_path):
    """The numbers of rows of what has been derived, with an empty cache."""
    monkeypatch.setenv("PYDY_CACHE_DIR", str(tmp_path))
    found, original = [], kernel.PointBuilder._derived

    def noted(self, roots, outputs, hessian):
        found.append(outputs[0])
        return original(self, roots, outputs, hessian)

    monkeypatch.setattr(kernel.PointBuilder, "_derived", noted)
    return found


def functions_of(system, F, power=2, mesh=4, **options):
    problem = OptimalControl(system, sm.Integral(F**power, T), 1.0, mesh=mesh, **options)
    transcription = Transcription(problem._problem, problem._scheme, problem._mesh)
    return transcription.groups[0].functions


def test_problems_of_a_system_share_what_they_have_in_common(derived):
    system, (x, v, F) = optima.double_integrator()
    first = functions_of(system, F, end={x: 1.0})
    assert functions_of(system, F, mesh=9, bounds={F: (-1.0, 1.0)}, end={v: 0.0}) is first
    assert derived == [2]
    others = [
        functions_of(system, F, power=4),
        functions_of(system, F, hessian="gauss-newton"),
        functions_of(system, F, hessian="lbfgs"),
        functions_of(system, F, method="midpoint"),
        functions_of(system, F, path=[v <= 1]),
    ]
    assert len({id(f) for f in others} | {id(first)}) == 6
    assert derived == [2] * 5 + [3]


def test_a_later_process_reads_them_from_the_cache(derived):
    made = []
    for _ in range(2):
        system, (_, _, _, _, F) = optima.cart_pole()
        made.append(functions_of(system, F))
    assert derived == [4]
    first, second = made
    for name in ("gradient_at", "jacobian_at", "hessian_at"):
        np.testing.assert_array_equal(getattr(first, name), getattr(second, name))
    assert first.sizes == second.sizes
    assert first.outputs == second.outputs
    digests = [{n: p.digest for n, p in f.programs.items()} for f in made]
    assert digests[0] == digests[1]


def test_a_model_keeps_the_latest_alone(derived, monkeypatch):
    monkeypatch.setattr(kernel, "STORED_FUNCTIONS", 2)
    system, (_, _, F) = optima.double_integrator()
    first = functions_of(system, F)
    for power in (4, 6):
        functions_of(system, F, power)
    assert functions_of(system, F) is not first
    assert derived == [2] * 3  # it was read from the cache
    problem = OptimalControl(system, sm.Integral(F**2, T), 1.0)
    assert len(problem._problem.equations.compiled) == 2
    assert not pickle.loads(pickle.dumps(problem._problem.equations)).compiled
