"""The Cython generator: each build takes seconds, so few, and all that matters in each."""

import sys

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from cases import WAYS_OF_R, arrays, check_arguments, close, given
from oracle import oracle
from pydy.codegen.ode_function_generators import generate_ode_function

T = zoo.T
GENERATORS = ["llvm", "lambdify"]
X, V = me.dynamicsymbols("x v")
M, K = sm.symbols("m k")

# cython: each build takes seconds, so few, and all that matters in each

cython = {}
COPIED = {"force_c_contiguous": True}


def built(form, name, **options):
    """A function from the Cython generator, built once for all tests."""
    key = form, name, *options.items()
    if key not in cython:
        model = zoo.MODELS[name]()
        cython[key] = generate_ode_function(generator="cython", **options, **given(model, form))
    return cython[key]


@pytest.mark.in_parts
@pytest.mark.parametrize(("form", "name"), [("[1]", "gyro"), ("[2]", "timed"), ("[3]", "disc")])
def test_every_form_with_cython_agrees_with_sympy(form, name):
    model = zoo.MODELS[name]()
    rhs = built(form, name, **(COPIED if form == "[2]" else {}))
    for seed in range(2):
        x, t = model.sample(seed)
        close(rhs(x, t, *arrays(model)), oracle(model).xdot(x, t))


@pytest.mark.in_parts
@pytest.mark.parametrize("p", ["array", "list", "dictionary"])
@pytest.mark.parametrize("r", WAYS_OF_R)
def test_every_kind_of_argument_is_taken_with_cython(r, p):
    check_arguments(built("[3]", "pendulum", time_first=True), r, p, True)


def test_cython_writes_its_sources_where_and_as_it_is_told(tmp_path):
    options = {"tmp_dir": str(tmp_path), "prefix": "swing", "cse": False, "verbose": False}
    rhs = generate_ode_function(generator="cython", **options, **given(zoo.bare(), "[1]"))
    names = [p.name for p in tmp_path.rglob("*") if p.is_file()]
    assert any("swing" in n and n.endswith((".c", ".pyx")) for n in names)
    close(rhs([0.1, 0.2], 0.0, []), oracle(zoo.bare()).xdot([0.1, 0.2]))


def test_cython_refuses_strided_arrays_only_when_told_not_to_copy():
    model = zoo.timed()
    x, t = model.sample()
    strided = np.repeat(x, 2)[::2]
    close(
        built("[2]", "timed", **COPIED)(strided, t, *arrays(model)),
        oracle(model).xdot(x, t),
    )
    rhs = built("[2]", "timed", force_c_contiguous=False)
    close(rhs(x, t, *arrays(model)), oracle(model).xdot(x, t))
    with pytest.raises(ValueError, match="contiguous"):
        rhs(strided, t, *arrays(model))


def test_without_cython_the_error_says_what_to_install_or_use(monkeypatch):
    for name in [n for n in sys.modules if n.split(".")[0] == "Cython"] + ["Cython"]:
        monkeypatch.setitem(sys.modules, name, None)
    q = sm.Symbol("never_built_before")
    with pytest.raises((ImportError, RuntimeError), match=r"(?is)cython.*(llvm|lambdify)"):
        generate_ode_function(sm.Matrix([V, -q * X]), [X], [V], [q], generator="cython")


def test_a_failing_compiler_shows_its_message_and_the_source(monkeypatch, tmp_path):
    compiler = tmp_path / "cc"
    compiler.write_text("#!/bin/sh\necho 'the flux capacitor is missing' >&2\nexit 1\n")
    compiler.chmod(0o755)
    for variable in ("CC", "CXX", "LDSHARED"):
        monkeypatch.setenv(variable, str(compiler))
    q = sm.Symbol("never_built_either")
    folder = tmp_path / "sources"
    folder.mkdir()
    arguments = (sm.Matrix([V, -q * X]), [X], [V], [q])
    with pytest.raises((OSError, RuntimeError), match="flux capacitor") as info:
        generate_ode_function(*arguments, generator="cython", tmp_dir=str(folder))
    assert str(folder) in str(info.value)
