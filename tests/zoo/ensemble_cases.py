"""Systems and helpers for the tests of ensembles."""

from functools import cache

import numpy as np
import sympy as sm

from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System

__all__ = ["constant", "identical", "pendulum", "random_values", "runaway", "same_bits"]


def pendulum(n=1, **options):
    """n links on a cart; the equations are derived once."""
    return System(_pendulum(n).eom_method, times=np.linspace(0.0, 2.0, num=11), **options)


@cache
def _pendulum(n):
    return n_link_pendulum_on_cart(n)


def random_values(system, m, seed=0):
    """Random initial conditions and constants for m samples."""
    rng = np.random.default_rng(seed)
    return {
        "initial_conditions": {s: rng.uniform(-1.0, 1.0, m) for s in system.states},
        "constants": {s: rng.uniform(0.5, 1.5, m) for s in system.constants_symbols},
    }


def runaway():
    """A mass m with x'' = v² / m, which reaches infinity at the time m / v(0)."""
    system = multi_mass_spring_damper(apply_external_forces=True)
    x, v = system.states
    (force,) = system.specifieds_symbols
    system.specifieds = {force: v**2}
    names = {s.name: s for s in system.constants_symbols}
    system.constants = {names["k0"]: 0.0, names["c0"]: 0.0, names["m0"]: 1.0}
    system.times = np.linspace(0.0, 2.0, num=21)
    return system, x, v, names["m0"]


def same_bits(a, b):
    """Whether two arrays are the same, NaN included."""
    a, b = np.asarray(a), np.asarray(b)
    return np.array_equal(a, b, equal_nan=a.dtype.kind in "fc")


def constant(system, name):
    """The constant of some name."""
    return next(s for s in system.constants_symbols if s == sm.Symbol(name, **s.assumptions0))


def identical(a, b):
    """Assert that two datasets have the same variables with the same bits."""
    assert set(a.data_vars) == set(b.data_vars)
    for name in a.variables:
        assert same_bits(a[name], b[name]), name
