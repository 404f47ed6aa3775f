"""NumPy's array object by offsets: compared with what NumPy says, and not used where it differs."""

from __future__ import annotations

import os
import subprocess
import sys

import numpy as np
import pytest

from graphs import P, T, X, program_of
from pydy import _array_layout
from pydy._backends.llvm import native
from pydy._backends.llvm.native import LLVMBackend

MODEL = program_of([X[0] * P[0] + T, X[1] - X[3], X[0] / X[1], P[1] * X[2]])


def test_the_usual_layout_is_recognised():
    assert _array_layout.fits()


@pytest.mark.parametrize(
    "name", [*("KIND", "DATA", "NDIM", "SHAPE", "STRIDES", "DESCR", "FLAGS", "FLOAT")]
)
def test_each_offset_is_compared(name, monkeypatch):
    # Seven other words of the same objects: a float ends after its value.
    other = {"FLOAT": 8, "SHAPE": 40, "STRIDES": 32}.get(name, 0)
    monkeypatch.setattr(_array_layout, name, other)
    assert not _array_layout.fits()


def test_an_interpreter_that_lays_objects_out_otherwise_is_not_looked_into(monkeypatch):
    monkeypatch.setattr(sys.implementation, "name", "another")
    assert not _array_layout.fits()


@pytest.fixture
def other_layout(monkeypatch):
    monkeypatch.setattr(_array_layout, "FITS", False)
    native.gates.cache_clear()
    yield
    monkeypatch.undo()
    native.gates.cache_clear()


@pytest.mark.parametrize("order", ["C", "F"])
@pytest.mark.parametrize("lanes", [1, 8])
@pytest.mark.parametrize("rows", [1, 21])
def test_sweeps_give_the_same_bits_by_the_safe_path(other_layout, lanes, order, rows):
    rng = np.random.default_rng(lanes)
    t, p = np.arange(21.0), np.array([2.0, 3.0, 5.0])
    x, r = np.asarray(rng.uniform(0.5, 2.0, (21, 4)), order=order), np.zeros((rows, 0))
    careful = LLVMBackend(lanes=lanes).compile(MODEL)
    found = careful.evaluate(t, x, r, p)
    _array_layout.FITS = True
    native.gates.cache_clear()
    quick = LLVMBackend(lanes=lanes).compile(MODEL)
    for one, other in zip(found, quick.evaluate(t, x, r, p), strict=True):
        np.testing.assert_array_equal(one, other)
    assert careful.sweep is not quick.sweep


def test_calls_give_the_same_bits_by_the_safe_path(other_layout):
    x, r, p = np.array([1.0, 2.0, 3.0, 4.0]), np.zeros(0), np.array([2.0, 3.0, 5.0])
    one, other = np.empty(4), np.empty(4)
    careful = LLVMBackend().compile(MODEL)
    assert type(careful.call) is not type(len)
    assert careful.call(x, 0.5, r, p, one) == 0
    assert careful.call(list(x), 0.5, r, p, one) == -1
    _array_layout.FITS = True
    native.gates.cache_clear()
    quick = LLVMBackend().compile(MODEL)
    assert type(quick.call) is type(len)
    assert quick.call(x, 0.5, r, p, other) == 0
    np.testing.assert_array_equal(one, other)


def test_addresses_are_numpys_own_by_the_safe_path(other_layout):
    array = np.arange(5.0)
    assert _array_layout.address(array[2:]) == array.ctypes.data + 16


def test_solvers_integrate_by_the_safe_path():
    code = """
import numpy as np
from pydy import _array_layout
_array_layout.FITS = False
from pydy.models import multi_mass_spring_damper
system = multi_mass_spring_damper(1)
system.times = np.linspace(0.0, 1.0, 3)
system.initial_conditions = dict(zip(system.states, (1.0, 0.0)))
system.constants = dict.fromkeys(system.constants_symbols, 1.0)
system.ode_solver = "dop853"
print(system.integrate()[-1, 0])
"""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, env=os.environ
    )
    w = np.sqrt(0.75)  # x'' = −x − x', from 1 at rest
    expected = np.exp(-0.5) * (np.cos(w) + 0.5 / w * np.sin(w))
    assert float(done.stdout) == pytest.approx(expected, rel=1e-6)
