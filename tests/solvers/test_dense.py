"""The linear systems of implicit steps, for one trajectory and for several side by side."""

import ctypes
from functools import cache, partial

import numpy as np
import pytest
import solvers_ir

from pydy._array_layout import address
from pydy._backends.llvm import jit
from pydy._backends.llvm.compiling import Source, _with_target

pytest.importorskip("ziglang")

SOURCE = """
#define W {width}
#include "newton.h"

int64_t solved(double *a, int64_t n, double *order, double *right, int64_t width)
{{
    const int64_t singular = {kind}_factorise(a, n, order);
    {kind}_solve(a, n, order, right);
    {kind}_solve_columns(a, n, order, right + {parts} * n * W, width);
    return singular;
}}
"""


@cache
def compiled(kind, width, folder):
    source, parts = folder / f"{kind}{width}.c", {"real": 1, "pair": 2}[kind]
    text = SOURCE.format(kind=kind, width=width, parts=parts)
    source.write_text(text, encoding="utf-8")
    text = solvers_ir.neutral(solvers_ir.compiled(source, folder))
    code = jit.load(Source(text, partial(_with_target, text), ("solved",), loops=True))
    return code, ctypes.CFUNCTYPE(ctypes.c_int64, *[ctypes.c_int64] * 5)(code.addresses["solved"])


def solve(folder, kind, matrices, rights):
    """Solutions (lanes, n, 1 + columns) and the bits of what is singular, from C."""
    lanes, n, width = rights.shape

    def laid_out(rows):  # [item][part][lane]
        parts = rows.reshape(lanes, -1).view(float).reshape(lanes, -1)
        return np.array(parts.T, order="C")

    right = np.concatenate(
        [laid_out(np.ascontiguousarray(part)) for part in (rights[..., 0], rights[..., 1:])]
    )
    a, order = laid_out(np.ascontiguousarray(matrices)), np.zeros((n, lanes))
    function = compiled(kind, lanes, folder)[1]
    singular = function(address(a), n, address(order), address(right), width - 1)
    found = np.ascontiguousarray(right.T).view(rights.dtype)
    first, others = found[:, :n, None], found[:, n:].reshape(lanes, n, width - 1)
    return np.concatenate([first, others], axis=-1), singular


def random(kind, rng, *shape):
    values = rng.normal(size=shape)
    return values if kind == "real" else values + 1j * rng.normal(size=shape)


@pytest.mark.parametrize("kind", ["real", "pair"])
@pytest.mark.parametrize("n", [1, 2, 7])
def test_lanes_pivot_by_themselves_and_solve_as_one(kind, n, tmp_path):
    rng = np.random.default_rng(n)
    matrices, rights = random(kind, rng, 8, n, n), random(kind, rng, 8, n, 4)
    matrices[rng.random(matrices.shape) < 0.3] = 0.0
    matrices += np.eye(n) * rng.choice([1e-9, 1.0, 1e9], size=(8, 1, 1))
    matrices[2] = np.eye(n)[::-1] * 3.0  # rows that all change places, where others do not
    matrices[5] = 1.0 if n > 1 else 0.0  # singular
    found, singular = solve(tmp_path, kind, matrices, rights)
    assert singular == 1 << 5
    for lane in range(8):
        one, alone = solve(tmp_path, kind, matrices[lane, None], rights[lane, None])
        assert alone == (lane == 5)
        np.testing.assert_array_equal(found[lane], one[0])
        if lane != 5:
            expected = np.linalg.solve(matrices[lane], rights[lane])
            np.testing.assert_allclose(found[lane], expected, rtol=1e-9, atol=1e-12)
