"""Numbers side by side in the loops' C, for one trajectory and for several."""

import ctypes
from functools import cache, partial

import numpy as np
import pytest
import solvers_ir

from pydy._array_layout import address
from pydy._backends.llvm import jit
from pydy._backends.llvm.compiling import Source, _with_target
from pydy.solvers import tuning

pytest.importorskip("ziglang")

SOURCE = """
#define W {width}
#include "real.h"

int64_t sweep(const double *x, double *out, int64_t count)
{{
    int64_t found = 0;
    for (int64_t i = 0; i < count / W; i++) {{
        const Real e = item(x, i);
        {body}
    }}
    return found;
}}
"""


@cache
def compiled(body, width, folder):
    source = folder / f"sweep{abs(hash((body, width)))}.c"
    source.write_text(SOURCE.format(body=body, width=width), encoding="utf-8")
    text = solvers_ir.neutral(solvers_ir.compiled(source, folder))
    code = jit.load(Source(text, partial(_with_target, text), ("sweep",), loops=True))
    return code, ctypes.CFUNCTYPE(ctypes.c_int64, *[ctypes.c_int64] * 3)(code.addresses["sweep"])


@pytest.fixture
def over(tmp_path, monkeypatch):
    """A C statement over all items of an array: its results, and what it found."""

    def apply(x, body, width=8):
        if width > 1:
            monkeypatch.setattr(tuning, "BLOCK", width)
        out = np.zeros_like(x)
        found = compiled(body, width, tmp_path)[1](address(x), address(out), len(x))
        return out, found

    return apply


X = np.array([0.5, 1.0, -2.0, 3.25, 1e-300, 0.0, np.inf, np.nan])


@pytest.mark.parametrize("width", [1, 4, 8])
@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("(1.0 - e) * e / (e + 2.0) + e * e", lambda x: (1.0 - x) * x / (x + 2.0) + x * x),
        ("root(absolute(e))", lambda x: np.sqrt(np.abs(x))),
        (
            "where(((e > 0.0) & (e < 3.0)) | (e == -2.0), absolute(e), (Real)(-1.0))",
            lambda x: np.where((x > 0) & (x < 3) | (x == -2), np.abs(x), -1.0),
        ),
    ],
)
def test_operations_agree_with_numpy(over, width, body, expected):
    with np.errstate(all="ignore"):
        np.testing.assert_array_equal(over(X, f"put(out, i, {body});", width)[0], expected(X))


@pytest.mark.parametrize("width", [1, 4, 8])
def test_a_bound_takes_the_place_of_nan(over, width):
    bounded = "put(out, i, minimum(maximum(ceiling(e), (Real)(-1.0)), (Real)(2.0)));"
    expected = [1.0, 1.0, -1.0, 2.0, 1.0, 0.0, 2.0, -1.0]
    np.testing.assert_array_equal(over(X, bounded, width)[0], expected)


def test_one_number_gets_the_bits_of_several(over):
    body = """
        const Real bounded = minimum(maximum(absolute(e), (Real)(1e-3)), (Real)(1e3));
        const Real sum = fused(e, e, (Real)(0.1));
        put(out, i, where(e > 0.0, power(bounded, -0.2) + sum, root(ceiling(bounded))));
    """
    x = np.concatenate([X, np.random.default_rng(0).normal(scale=10.0, size=800)])
    one = over(x, body, 1)[0]
    for width in (4, 8):
        np.testing.assert_array_equal(over(x, body, width)[0], one)
    assert len(np.unique(one)) > 400


@pytest.mark.parametrize("width", [4, 8])
def test_conditions_are_integers_and_back(over, width):
    body = """
        const int64_t which = bits(e > 0.0);
        found |= which << W * i;
        put(out, i, where(flags(which), (Real)(1.0), (Real)(0.0)));
    """
    out, found = over(X, body, width)
    assert found == 0b01011011
    np.testing.assert_array_equal(out, X > 0.0)


@pytest.mark.parametrize("exponent", [-0.2, -0.125, 0.04, 1.0 / 9.0])
def test_powers_have_eight_digits(over, exponent):
    x = np.logspace(-290, 290, num=4000)
    powers, _ = over(x, f"put(out, i, power(e, {exponent!r}));")
    np.testing.assert_allclose(powers, x**exponent, rtol=2e-8)
