"""The C of a Program by itself: strict C99 that any compiler takes, without Python."""

import ctypes
import os
import subprocess

import numpy as np
import pytest

from graphs import everything, solves
from pydy._backends.c.source import c_source
from pydy._program.interpret import run

STRICT = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-O1", "-shared", "-fPIC"]


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """Two Programs in one library, under names of their own."""
    folder = tmp_path_factory.mktemp("sources")
    programs = {"all_": everything(), "solve_": solves()}
    for prefix, program in programs.items():
        source = c_source(program, prefix=prefix)
        (folder / f"{prefix}.c").write_text(source, encoding="ascii")
    files = [str(folder / f"{prefix}.c") for prefix in programs]
    target = folder / "equations.so"
    command = [os.environ.get("CC", "cc"), *STRICT, *files, "-o", str(target), "-lm"]
    result = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert result.returncode == 0, result.stderr
    return ctypes.CDLL(str(target))


def evaluate(library, prefix, program, t, x, r, p):
    """Outputs and status of the compiled functions at one state."""

    def pointer(values):
        return np.asarray(values, dtype=float).ctypes.data_as(ctypes.c_void_p)

    carried = np.empty(len(program.carried))
    out = np.empty(program.signature.num_outputs)
    getattr(library, f"{prefix}prepare")(pointer(p), pointer(carried))
    kernel = getattr(library, f"{prefix}kernel")
    kernel.restype = ctypes.c_int32
    arrays = [np.array([t]), x, r, carried, out]
    return out, kernel(*map(pointer, arrays))


def test_every_operation_stands_alone(library):
    program = everything()
    rng = np.random.default_rng(8)
    x, r, p = (rng.uniform(0.1, 0.9, (6, 2)) for _ in range(3))
    for k in range(len(x)):
        expected, _ = run(program, np.array([0.3]), x[k : k + 1], r[k : k + 1], p[k])
        out, status = evaluate(library, "all_", program, 0.3, x[k], r[k], p[k])
        assert status == 0
        np.testing.assert_allclose(out, expected[0], rtol=1e-14)


@pytest.mark.parametrize("singular", [False, True])
def test_linear_solves_stand_alone_and_report_singular_matrices(library, singular):
    program = solves()
    matrix = [1, 2, 3, 2, 4, 6, 3, 6, 10] if singular else [0, 2, 1, 2, 0, 3, 1, 3, -1]
    x = np.array([*matrix, 0.3, -0.7, 1.1, 2.0, 0.1, -0.4], dtype=float)
    nothing = np.empty((1, 0))
    expected, failed = run(program, np.zeros(1), x[None], nothing, nothing[0])
    out, status = evaluate(library, "solve_", program, 0.0, x, nothing[0], nothing[0])
    assert status == failed[0] == singular
    np.testing.assert_allclose(out, expected[0], rtol=1e-13)


def test_the_source_is_the_same_every_time():
    assert c_source(everything()) == c_source(everything())


def test_static_functions_are_seen_in_their_file_alone():
    source = c_source(solves(), static=True)
    assert "static void prepare(" in source
    assert "static int32_t kernel(" in source
