"""What tells functions apart, and what cannot."""

import dataclasses
import functools
import math
import re
import sys
import threading
import types

import numpy as np
import pytest
import scipy.special
import sympy as sm
import sympy.physics.mechanics as me
import xarray as xr
from scipy.interpolate import CubicSpline

from pydy.ensemble.identity import UnidentifiedError, fingerprint

SCALE = 1.0


def uses_global(x, t):
    return SCALE * x


def calls_another(x, t):
    return uses_global(x, t) + 1.0


def with_defaults(k, b):
    def function(x, t, k=k, *, b=b):
        return k * x + b

    return function


def closing_over(k):
    def inner(x):
        return k * x

    return lambda x, t: inner(x)


def nested_constant(k):
    """Functions whose code differs in a constant of a function within."""
    return eval(f"lambda x, t: (lambda y: y * {k})(x)")


class Gain:
    def __init__(self, k):
        self.k = k

    def __call__(self, x, t):
        return self.k * x

    def method(self, x, t):
        return self.k * x


class Slotted:
    __slots__ = ("k",)

    def __init__(self, k):
        self.k = k

    def __call__(self, x, t):
        return self.k * x


@dataclasses.dataclass(frozen=True)
class Record:
    k: float

    def __call__(self, x, t):
        return self.k * x


def subclass(k):
    class Other(Gain):
        factor = k

        @staticmethod
        def helper(x):
            return x * k

    return Other(1.0)


def spline(k):
    curve = CubicSpline([0.0, 1.0, 2.0], [0.0, k, 4.0])
    return lambda x, t: curve(t)


def cached(k):
    @functools.lru_cache
    def function(t):
        return k * t

    return lambda x, t: function(t)


SYMBOL = sm.Symbol("x")
MAKERS = {
    "a variable of the function around": closing_over,
    "the code of a function within": nested_constant,
    "a default": lambda k: with_defaults(k, 0.0),
    "a keyword's default": lambda k: with_defaults(0.0, k),
    "an object with a call": Gain,
    "a method": lambda k: Gain(k).method,
    "slots": Slotted,
    "a dataclass": Record,
    "a class made here": subclass,
    "a partial function": lambda k: functools.partial(with_defaults(1.0, 2.0), k=k),
    "a cached function": cached,
    "a vectorised function": lambda k: np.vectorize(closing_over(k)),
    "an array": lambda k: closing_over(np.array([k, 1.0])),
    "a set": lambda k: closing_over({k, "a", "b"}),
    "a dataset": lambda k: closing_over(xr.Dataset({"a": ("x", [k])})),
    "an interpolation": spline,
    "a function made by SymPy": lambda k: sm.lambdify(SYMBOL, sm.sin(k * SYMBOL)),
    "a symbolic expression": lambda k: closing_over(k * me.dynamicsymbols("q")),
    "a pattern": lambda k: closing_over(re.compile(f"a{k}")),
    "a random generator": lambda k: closing_over(np.random.default_rng(int(k))),
}


@pytest.mark.parametrize("what", MAKERS)
def test_the_same_again_is_the_same_and_another_number_is_another(what):
    make = MAKERS[what]
    assert fingerprint(make(2.0)) == fingerprint(make(2.0))
    assert fingerprint(make(2.0)) != fingerprint(make(3.0))


@pytest.mark.parametrize("function", [uses_global, calls_another])
def test_a_global_counts_with_its_value_through_other_functions_too(monkeypatch, function):
    before = fingerprint(function)
    assert fingerprint(function) == before
    monkeypatch.setattr(sys.modules[__name__], "SCALE", 2.0)
    assert fingerprint(function) != before


def test_an_attribute_named_like_a_global_is_no_global(monkeypatch):
    def function(dataset):
        return dataset.SCALE

    before = fingerprint(function)
    monkeypatch.setattr(sys.modules[__name__], "SCALE", threading.Lock())
    assert fingerprint(function) == before


@pytest.mark.parametrize("pair", [(1, 1.0), (0.0, -0.0), (1, True), ("1", 1), ([1], (1,))])
def test_numbers_of_different_kinds_are_told_apart(pair):
    assert fingerprint(pair[0]) != fingerprint(pair[1])


def test_recursion_ends():
    def factorial(n):
        return n * factorial(n - 1) if n else 1

    assert fingerprint(factorial) == fingerprint(factorial)


def test_equal_texts_are_the_same_whether_or_not_they_are_one_object():
    assert fingerprint(["ab", "ab"]) == fingerprint(["ab", "".join(["a", "b"])])


@pytest.mark.parametrize("function", [math.sin, np.sin, np.sum, scipy.special.erf, xr.where, len])
def test_functions_of_packages_count_by_name_and_version(monkeypatch, function):
    before = fingerprint(function)
    for module in (np, sys.modules["scipy"], xr):
        monkeypatch.setattr(module, "__version__", "0.0")
    changes = function not in (math.sin, len)
    assert (fingerprint(function) != before) is changes


def test_a_module_that_is_not_installed_is_refused(monkeypatch):
    tools = types.ModuleType("my_tools")
    monkeypatch.setattr(sys.modules[__name__], "SCALE", tools)
    with pytest.raises(
        UnidentifiedError,
        match=r"the module `my_tools` does not belong to an installed package, in the global "
        r"`SCALE` of `uses_global`",
    ):
        fingerprint(uses_global)


def imports_it(x, t):
    import my_tools

    return my_tools.f(x)


REFUSED = [
    (lambda x, t: eval("x"), "calls `eval`, through which it can reach anything"),
    (lambda x, t: exec("x"), "calls `exec`"),
    (imports_it, "the module `my_tools` does not belong to an installed package"),
    (closing_over(threading.Lock()), "an object of the type lock cannot be read, in the variable"),
    (closing_over(n for n in range(3)), "an object of the type generator cannot be read"),
    (np.frompyfunc(uses_global, 2, 1), "does not show what it was made from"),
]


@pytest.mark.parametrize(("thing", "message"), REFUSED)
def test_what_cannot_be_read_is_named(thing, message):
    with pytest.raises(UnidentifiedError, match=message):
        fingerprint(thing)


def test_values_that_hold_themselves_are_refused():
    values = []
    values.append(values)
    with pytest.raises(UnidentifiedError, match="list cannot be read"):
        fingerprint(values)


@pytest.mark.parametrize(
    ("function", "what"),
    [
        (lambda ds: ds * float(sys.argv[1]), "argv"),
        (lambda ds: ds * np.loadtxt("gain.txt"), "loadtxt"),
        (lambda ds: (lambda k: ds * k)(sys.modules["gains"].k), "modules"),
    ],
)
def test_a_function_that_reads_what_lies_outside_it_is_refused(function, what):
    with pytest.raises(UnidentifiedError, match=f"uses `{what}`, which may differ"):
        fingerprint(function)
