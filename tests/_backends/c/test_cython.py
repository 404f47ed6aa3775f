"""The Cython back end: the C it writes against the interpreter, and the building of it.

Each build takes two seconds, so every one serves as many tests as it can.
"""

import copy
import os
import pickle
import shutil
import stat
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from graphs import ELEMENTARY, everything, solves
from pydy._backends.c.cython_ import CythonBackend
from pydy._errors import GeneratorError, PyDyUserWarning
from pydy._program.interpret import run
from pydy._program.program import Program, Tape
from pydy.codegen.ode_function_generators import generate_ode_function

NAN, INF = np.nan, np.inf
X, V = me.dynamicsymbols("x v")
M, K = sm.symbols("m k")


def agree(kernel, x, r, p, t=None, rtol=1e-13):
    """The kernel, by sweep and by call, gives what the interpreter gives; returns who failed."""
    program = kernel.program
    t = np.linspace(0.3, 2.0, len(x)) if t is None else t
    expected, failed = run(program, t, x, r, p)
    out, status = kernel.evaluate(t, x, r, p)
    np.testing.assert_allclose(out, expected, rtol=rtol, atol=0)
    np.testing.assert_array_equal(status, failed)
    for k, row in enumerate(expected):
        one = np.empty(len(row))
        assert kernel.call(x[k], float(t[k]), r[k], p, one) == failed[k]
        np.testing.assert_allclose(one, row, rtol=rtol, atol=0)
    return failed


# every elementary operation


@pytest.fixture(scope="module")
def elementary():
    return CythonBackend().compile(everything())


def test_the_program_of_these_tests_holds_every_elementary_operation():
    assert set(everything().ops) >= ELEMENTARY


@pytest.mark.parametrize("p", [(0.3, 0.7), (2.5, -1.3), (NAN, 0.4), (INF, -INF), (0.0, 0.0)])
def test_every_operation_agrees_with_the_interpreter(elementary, p):
    rng = np.random.default_rng(3)
    special = [NAN, INF, -INF, 0.0, 1.0, -1.0, 1e-300, 1e300]
    x = np.array([(a, b) for a in special for b in special])
    x = np.vstack([x, rng.uniform(0, 1, (20, 2)), rng.uniform(-30, 30, (20, 2))])
    agree(elementary, x, rng.uniform(-1, 1, x.shape), np.array(p), rtol=1e-14)


def test_arguments_that_are_no_float_arrays_are_left_to_the_caller(elementary):
    out = np.empty(elementary.program.signature.num_outputs)
    assert elementary.call([0.1, 0.2], 0.0, np.zeros(2), np.zeros(2), out) == -1


# linear solves

SOUND = [[4, -1, 0.5], [-1, 3, 0.2], [0.5, 0.2, 2]]
INDEFINITE = [[0, 2, 1], [2, 0, 3], [1, 3, -1]]
SINGULAR = [[1, 2, 3], [2, 4, 6], [3, 6, 10]]
NEARLY = [[1, 1, 1], [1, 1, 1 + 2e-16], [1, 1 + 2e-16, 3]]
ZERO = np.zeros((3, 3))


@pytest.fixture(scope="module")
def solver():
    return CythonBackend().compile(solves())


def solved(kernel, matrix):
    """The solution for two right-hand sides, checked against the interpreter, and its failure."""
    columns = [0.3, -0.7, 1.1, 2.0, 0.1, -0.4]
    x = np.array([[*np.ravel(matrix), *columns]], dtype=float)
    failed = agree(kernel, x, np.empty((1, 0)), np.empty(0), rtol=1e-12)
    out, _ = kernel.evaluate(np.zeros(1), x, np.empty((1, 0)), np.empty(0))
    return out[0], failed[0]


@pytest.mark.parametrize("scale", [1.0, 1e-200, 1e200])
@pytest.mark.parametrize("matrix", [SOUND, INDEFINITE])
def test_solves_agree_whether_the_pivots_of_the_guard_are_sound_or_not(solver, matrix, scale):
    x, failed = solved(solver, scale * np.array(matrix))
    assert not failed
    one = np.linalg.solve(scale * np.array(matrix), [0.3, -0.7, 1.1])
    np.testing.assert_allclose(x[-3:], one, rtol=1e-12)


def test_badly_scaled_rows_and_columns_are_not_singular(solver):
    scale = np.diag([1e-150, 1.0, 1e150])
    assert not solved(solver, scale @ INDEFINITE @ scale)[1]


@pytest.mark.parametrize("matrix", [SINGULAR, NEARLY, ZERO])
def test_a_singular_matrix_sets_the_status_and_gives_nan(solver, matrix):
    x, failed = solved(solver, matrix)
    assert failed
    assert np.isnan(x).all()


def test_nan_in_a_matrix_is_no_failure_and_comes_out_as_nan(solver):
    x, failed = solved(solver, np.full((3, 3), NAN))
    assert not failed
    assert np.isnan(x).all()


def test_one_singular_sample_leaves_the_others_untouched(solver):
    columns = np.ones(6)
    x = np.array([[*np.ravel(m), *columns] for m in (SOUND, SINGULAR, INDEFINITE)], dtype=float)
    failed = agree(solver, x, np.empty((3, 0)), np.empty(0), rtol=1e-12)
    assert failed.tolist() == [False, True, False]


# through the public function

MATRIX = sm.Matrix([[M + sm.sin(X) ** 2, K * X], [K, sm.Abs(V) + M * K]])
OUTPUTS = [
    sm.Piecewise((X, X > V), (M * V, True)),
    sm.Max(X, V) ** sm.Rational(3, 2),
    me.dynamicsymbols._t * X,
]


@pytest.fixture(scope="module")
def rhs():
    forcing = sm.Matrix([V, -K * sm.cos(X)])
    return generate_ode_function(
        forcing, [X], [V], [M, K], mass_matrix=MATRIX, outputs=OUTPUTS, generator="cython"
    )


def test_a_generated_function_agrees_with_the_interpreter(rhs):
    kernel = rhs.__qualname__.implementation.kernel
    x = np.random.default_rng(5).uniform(0.2, 2.0, (10, 2))
    failed = agree(kernel, x, np.empty((10, 0)), np.array([1.3, 0.8]), rtol=1e-12)
    assert not failed.any()
    rates, outputs = rhs(x[0], 0.3, [1.3, 0.8])
    expected = kernel.evaluate(np.array([0.3]), x[:1], np.empty((1, 0)), np.array([1.3, 0.8]))[0]
    np.testing.assert_array_equal([*rates, *outputs], expected[0])


def test_a_generated_function_raises_where_its_mass_matrix_is_singular(rhs):
    with pytest.raises(np.linalg.LinAlgError, match="singular"):
        rhs([0.0, 0.4], 1.5, [0.0, 0.0])


# files and modules


def program(factor):
    """Of the smallest, as often as is needed."""
    tape = Tape()
    node = tape.make("mul", tape.const(factor), tape.make("input", "x", 0))
    return Program.from_tape(tape, (1, 0, 0), [("rates", (1,), [node])])


def value(kernel):
    out = np.empty(1)
    assert kernel.call(np.array([3.0]), 0.0, np.empty(0), np.empty(0), out) == 0
    return out[0]


@pytest.fixture(scope="module")
def twins(tmp_path_factory):
    """Two builds at the same time, of one Program, with one prefix, in one folder."""
    folder = tmp_path_factory.mktemp("a folder") / "not there yet" / "with spaces"
    backend = CythonBackend(prefix="swing", tmp_dir=folder)
    with ThreadPoolExecutor(2) as pool:
        kernels = list(pool.map(backend.compile, [program(2.0)] * 2))
    return folder, kernels


def test_two_builds_with_the_same_prefix_in_the_same_folder_both_work(twins):
    _, kernels = twins
    assert [value(k) for k in kernels] == [6.0, 6.0]
    assert (kernels[0].addresses != kernels[1].addresses).all()


def test_the_sources_stay_in_the_given_folder_under_the_prefix(twins):
    folder, _ = twins
    for pattern in ("*.pyx", "*_equations.c"):
        names = [p.name for p in folder.rglob(pattern)]
        assert len(names) == 2
        assert all(n.startswith("swing_") for n in names)


def test_a_later_build_leaves_the_files_of_an_earlier_one_alone(tmp_path, monkeypatch):
    monkeypatch.setattr("pydy._backends.c.cython_._NUMBERS", iter(range(9)))
    digest = program(2.0).digest[:12]
    (tmp_path / f"swing_{digest}_0").mkdir()  # as another process leaves it
    CythonBackend(prefix="swing", tmp_dir=tmp_path).compile(program(2.0))
    assert not list((tmp_path / f"swing_{digest}_0").iterdir())
    assert list((tmp_path / f"swing_{digest}_1").glob("*.pyx"))


def test_a_build_leaves_nothing_behind_and_is_silent_unless_verbose(tmp_path, monkeypatch, capfd):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    arguments = list(sys.argv)
    modules = set(sys.modules)
    CythonBackend().compile(program(5.0))
    assert capfd.readouterr() == ("", "")
    assert list(tmp_path.iterdir()) == []
    assert os.path.samefile(os.getcwd(), tmp_path)
    assert sys.argv == arguments
    new = {m.split(".")[0] for m in set(sys.modules) - modules}
    assert not new & {"Cython", "setuptools", "distutils"}
    assert not [m for m in new if m.startswith("pydy_codegen")]


def test_a_kernel_survives_pickling_and_copies_and_verbose_shows_the_build(capsys):
    # The module of the first Kernel need not exist where the second one lands.
    backend = CythonBackend(verbose=True)
    kernel = backend.compile(program(7.0))
    assert "pydy_codegen_" in capsys.readouterr().out
    assert copy.deepcopy(kernel) is kernel
    restored = pickle.loads(pickle.dumps(kernel))
    assert value(restored) == 21.0
    assert restored.recipe == kernel.recipe == ("cython", backend.options)


# refusals


@pytest.mark.parametrize("package", ["Cython", "setuptools"])
def test_a_missing_package_is_named_with_the_remedies(monkeypatch, package):
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(GeneratorError, match=rf"{package} is not.*pydy\[cython\].*llvm") as info:
        CythonBackend().compile(program(2.0))
    assert isinstance(info.value, ImportError)


@pytest.mark.parametrize("message", ["the flux capacitor is missing", None])
def test_a_failing_or_missing_compiler_shows_why_and_keeps_the_source(
    monkeypatch, tmp_path, message
):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    compiler = tmp_path / "bin" / "cc"
    compiler.parent.mkdir()
    if message is not None:
        compiler.write_text(f"#!/bin/sh\necho '{message}' >&2\nexit 1\n")
        compiler.chmod(0o755)
    monkeypatch.setenv("CC", str(compiler))
    with pytest.raises(GeneratorError, match=message or str(compiler)) as info:
        CythonBackend(prefix="broken").compile(program(2.0))
    assert "generator='llvm'" in str(info.value)
    (folder,) = tmp_path.glob("broken_*")
    assert str(folder) in str(info.value)
    assert list(folder.glob("*_equations.c"))
    assert (folder / "build.log").exists()


@pytest.mark.parametrize("below", [".", "deeper"])
def test_a_tmp_dir_that_is_a_file_is_refused(tmp_path, below):
    file = tmp_path / "file"
    file.touch()
    with pytest.raises(ValueError, match=r"`tmp_dir` must be a directory.*file"):
        CythonBackend(tmp_dir=file / below).compile(program(2.0))


@pytest.mark.parametrize("prefix", ["", "1st", "my model", "a-b", "../up", "ü", None])
def test_a_prefix_that_cannot_begin_a_module_name_is_refused(prefix):
    with pytest.raises(ValueError, match="`prefix` is"):
        CythonBackend(prefix=prefix)


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="files have no owners here")
def test_no_code_is_loaded_from_where_others_can_write(tmp_path):
    shared = tmp_path / "shared"
    shared.mkdir()
    shared.chmod(0o777)
    backend = CythonBackend(tmp_dir=shared)
    with pytest.warns(PyDyUserWarning, match="shared' can be written by others.*`tmp_dir`"):
        _, directory = backend._reserve("digest")
    assert shared not in directory.parents
    shutil.rmtree(directory)


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="files have no owners here")
def test_the_folder_of_a_build_is_the_users_alone(tmp_path):
    _, directory = CythonBackend(tmp_dir=tmp_path)._reserve("digest")
    assert stat.S_IMODE(directory.stat().st_mode) == 0o700


@pytest.mark.parametrize("own", [False, True])
def test_an_interrupted_build_leaves_no_folder(own, tmp_path, monkeypatch):
    def pressed(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setattr("pydy._backends.c.cython_._build", pressed)
    with pytest.raises(KeyboardInterrupt):
        CythonBackend(tmp_dir=tmp_path if own else None).compile(everything())
    assert list(tmp_path.iterdir()) == []
