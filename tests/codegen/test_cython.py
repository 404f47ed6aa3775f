"""The Cython generator: each build takes seconds, so few, and all that matters in each."""

import sys

import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from oracles.oracle import oracle
from pydy.codegen.ode_function_generators import generate_ode_function
from zoo.cases import WAYS_OF_R, arrays, check_arguments, close, given

X, V = me.dynamicsymbols("x v")

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


@pytest.mark.parametrize(("form", "name"), [("[1]", "gyro"), ("[2]", "timed"), ("[3]", "disc")])
def test_every_form_with_cython_agrees_with_sympy(form, name):
    model = zoo.MODELS[name]()
    rhs = built(form, name, **(COPIED if form == "[2]" else {}))
    for seed in range(2):
        x, t = model.sample(seed)
        close(rhs(x, t, *arrays(model)), oracle(model).xdot(x, t))


@pytest.mark.parametrize("p", ["array", "list", "dictionary"])
@pytest.mark.parametrize("r", WAYS_OF_R)
def test_every_kind_of_argument_is_taken_with_cython(r, p):
    check_arguments(built("[3]", "pendulum", time_first=True), r, p, True)


def test_without_cython_the_error_says_what_to_install_or_use(monkeypatch):
    for name in [n for n in sys.modules if n.split(".")[0] == "Cython"] + ["Cython"]:
        monkeypatch.setitem(sys.modules, name, None)
    q = sm.Symbol("never_built_before")
    with pytest.raises((ImportError, RuntimeError), match=r"(?is)cython.*(llvm|lambdify)"):
        generate_ode_function(sm.Matrix([V, -q * X]), [X], [V], [q], generator="cython")
