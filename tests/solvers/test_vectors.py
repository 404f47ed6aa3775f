"""Blocks of eight numbers in compiled code."""

import numba
import numpy as np
import pytest

from pydy.solvers.loop.vectors import (
    absolute,
    bits,
    ceiling,
    item,
    load,
    mask_of,
    maximum,
    minimum,
    number,
    power,
    root,
    store,
    where,
)


def over(function):
    """The compiled function over all blocks of an array."""

    @numba.njit
    def sweep(x, out):
        for k in range(x.size // 8):
            store(out, k, function(load(x, k)))

    def apply(x):
        out = np.empty_like(x)
        sweep(x, out)
        return out

    return apply


X = np.array([0.5, 1.0, -2.0, 3.25, 1e-300, 0.0, np.inf, np.nan])


@numba.njit
def _arithmetic(x):
    return (1.0 - x) * x / (x + 2.0) + x * x


@numba.njit
def _choice(x):
    return where((x > 0.0) & ~(x >= 3.0) | (x == -2.0), absolute(x), -1.0)


@numba.njit
def _bounds(x):
    return minimum(maximum(ceiling(x), -1.0), 2.0)


@numba.njit
def _root(x):
    return root(absolute(x))


@pytest.mark.parametrize(
    ("function", "expected"),
    [
        (_arithmetic, lambda x: (1.0 - x) * x / (x + 2.0) + x * x),
        (_root, lambda x: np.sqrt(np.abs(x))),
        (_choice, lambda x: np.where((x > 0) & ~(x >= 3) | (x == -2), np.abs(x), -1.0)),
    ],
)
def test_operations_agree_with_numpy(function, expected):
    with np.errstate(all="ignore"):
        np.testing.assert_array_equal(over(function)(X), expected(X))


def test_a_bound_takes_the_place_of_nan():
    expected = [1.0, 1.0, -1.0, 2.0, 1.0, 0.0, 2.0, -1.0]
    np.testing.assert_array_equal(over(_bounds)(X), expected)


def test_functions_give_floats_the_same_bits():
    @numba.njit
    def of_floats(x, out):
        for k in range(x.size):
            e = item(x, k, 0.0)
            bounded = minimum(maximum(absolute(e), 1e-3), number(1e3, e))
            store(out, k, where(e > 0.0, power(bounded, -0.2), root(ceiling(bounded))))

    @numba.njit
    def of_blocks(x, out):
        for k in range(x.size // 8):
            e = item(x, k, load(x, 0))
            bounded = minimum(maximum(absolute(e), 1e-3), number(1e3, e))
            store(out, k, where(e > 0.0, power(bounded, -0.2), root(ceiling(bounded))))

    x = np.concatenate([X, np.random.default_rng(0).normal(scale=10.0, size=800)])
    floats, blocks = np.empty_like(x), np.empty_like(x)
    of_floats(x, floats)
    of_blocks(x, blocks)
    np.testing.assert_array_equal(floats, blocks)
    assert len(np.unique(floats)) > 400


def test_masks_are_integers_and_back():
    @numba.njit
    def positive(x, out):
        mask = load(x, 0) > 0.0
        store(out, 0, where(mask_of(bits(mask)), 1.0, 0.0))
        return bits(mask)

    out = np.empty(8)
    assert positive(X, out) == 0b01011011
    np.testing.assert_array_equal(out, X > 0.0)


@pytest.mark.parametrize("exponent", [-0.2, -0.125, 0.04, 1.0 / 9.0])
def test_powers_have_eight_digits(exponent):
    @numba.njit
    def raised(x):
        return power(x, exponent)

    x = np.logspace(-290, 290, num=4000)
    np.testing.assert_allclose(over(raised)(x), x**exponent, rtol=2e-8)
