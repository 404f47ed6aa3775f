"""What generate_ode_function and its functions refuse, and how."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.codegen.ode_function_generators import generate_ode_function

GENERATORS = ["llvm", "lambdify"]
X, V = me.dynamicsymbols("x v")
M, K = sm.symbols("m k")

# refusals


@pytest.mark.parametrize("generator", [*GENERATORS, "cython"])
@pytest.mark.parametrize("function", [sm.stieltjes, sm.Function("mystery")])
def test_a_function_that_cannot_be_translated_is_named(function, generator):
    with pytest.raises((ValueError, NotImplementedError), match=str(function)):
        generate_ode_function(sm.Matrix([V, function(X + 1)]), [X], [V], generator=generator)


@pytest.mark.parametrize("generator", [*GENERATORS, "cython"])
def test_a_symbol_that_no_argument_provides_is_named(generator):
    with pytest.raises(ValueError, match="nope"):
        generate_ode_function(
            sm.Matrix([V, -K * X / sm.Symbol("nope")]), [X], [V], [K], generator=generator
        )


def test_a_symbol_in_the_outputs_that_no_argument_provides_is_named():
    with pytest.raises(ValueError, match="nope"):
        generate_ode_function(sm.Matrix([V, X]), [X], [V], outputs=[sm.Symbol("nope")])


@pytest.mark.parametrize(
    ("side", "options"),
    [
        (sm.Matrix([V]), {}),
        (sm.Matrix([V, X, X]), {}),
        (sm.Matrix([V, X]), {"mass_matrix": sm.Matrix([[M]])}),
        (sm.Matrix([V, X]), {"mass_matrix": sm.Matrix([[M, K]])}),
        (sm.Matrix([V, X, X]), {"mass_matrix": sm.eye(3)}),
        (
            sm.Matrix([V, X]),
            {"mass_matrix": sm.Matrix([[M]]), "coordinate_derivatives": sm.Matrix([V])},
        ),
        (
            sm.Matrix([X]),
            {"mass_matrix": sm.eye(2), "coordinate_derivatives": sm.Matrix([V])},
        ),
        (
            sm.Matrix([X]),
            {"mass_matrix": sm.Matrix([[M]]), "coordinate_derivatives": sm.Matrix([V, V])},
        ),
        (sm.Matrix([X]), {"coordinate_derivatives": sm.Matrix([V])}),
    ],
)
def test_shapes_that_do_not_fit_the_form_are_refused(side, options):
    with pytest.raises(ValueError, match=r"right_hand_side|mass_matrix|coordinate_derivatives"):
        generate_ode_function(side, [X], [V], [M, K], **options)


@pytest.mark.parametrize(
    "constants", [[K, K], [K, X]], ids=["a constant twice", "a coordinate as a constant"]
)
def test_a_symbol_in_two_places_is_refused(constants):
    with pytest.raises(
        ValueError, match=str(constants[-1]).replace("(", r"\(").replace(")", r"\)")
    ):
        generate_ode_function(sm.Matrix([V, -K * X]), [X], [V], constants)


@pytest.fixture
def simple():
    force = me.dynamicsymbols("f")
    return generate_ode_function(
        sm.Matrix([V, force - K * X / M]), [X], [V], [M, K], specifieds=[force]
    ), force


def test_the_error_of_a_specified_function_shows(simple):
    def fails(x, t):
        raise ZeroDivisionError("my own trouble")

    for r in (fails, {simple[1]: fails}):
        with pytest.raises(ZeroDivisionError, match="my own trouble"):
            simple[0](np.zeros(2), 0.0, r, [1.0, 2.0])


@pytest.mark.parametrize("function", [lambda t: 0.0, lambda: 0.0, lambda x, t, p: 0.0])
@pytest.mark.parametrize("whole", [True, False])
def test_a_specified_function_of_the_wrong_arity_hears_what_it_must_take(simple, function, whole):
    r = function if whole else {simple[1]: function}
    with pytest.raises(TypeError, match=r"f\(t\) must take .* g\(x, t\), got a function of \("):
        simple[0](np.zeros(2), 0.0, r, [1.0, 2.0])


def test_a_type_error_inside_a_specified_function_stays_its_own(simple):
    with pytest.raises(TypeError, match="unsupported operand"):
        simple[0](np.zeros(2), 0.0, lambda x, t: t + "a", [1.0, 2.0])


def test_a_function_of_time_first_hears_of_that_order():
    force = me.dynamicsymbols("f")
    rhs = generate_ode_function([V, force], [X], [V], specifieds=[force], time_first=True)
    with pytest.raises(TypeError, match=r"g\(t, x\)"):
        rhs(0.0, np.zeros(2), lambda t: 0.0, [])


@pytest.mark.parametrize("count", [0, 1, 2, 3, 5])
def test_a_wrong_number_of_arguments_is_a_type_error(simple, count):
    arguments = (np.zeros(2), 0.0, [1.0], [1.0, 2.0], 1.0)[:count]
    with pytest.raises(TypeError, match=r"rhs|argument"):
        simple[0](*arguments)


def test_a_generator_class_that_raises_a_type_error_shows_it():
    class Mine:
        def __init__(self, *args, **kwargs):
            raise TypeError("my own type error")

    with pytest.raises(TypeError, match="my own type error"):
        generate_ode_function(sm.Matrix([V, X]), [X], [V], generator=Mine)


def test_a_class_that_cannot_compile_is_no_generator():
    with pytest.raises(NotImplementedError, match=r"`generator` is <class 'dict'>.*compile"):
        generate_ode_function(sm.Matrix([V, X]), [X], [V], generator=dict)


@pytest.mark.parametrize(
    ("generator", "option", "meant"),
    [
        ("llvm", "wrong_word", "There are cse"),
        ("lambdify", "csee", "Did you mean `cse`"),
        ("cython", "tmpdir", "Did you mean `tmp_dir`"),
        ("cython", "force_contiguous", "Did you mean `force_c_contiguous`"),
    ],
)
def test_an_unknown_option_is_refused(generator, option, meant):
    with pytest.raises(
        TypeError, match=f"no option `{option}` for the generator '{generator}'.*{meant}"
    ):
        generate_ode_function(sm.Matrix([V, X]), [X], [V], generator=generator, **{option: 1})


def test_the_docstring_follows_time_first_and_the_specifieds():
    plain = generate_ode_function(sm.Matrix([V, X]), [X], [V])
    assert "x' = f(x, t, p)" in plain.__doc__
    swapped = generate_ode_function(sm.Matrix([V, X]), [X], [V], time_first=True)
    assert "x' = f(t, x, p)" in swapped.__doc__


def test_the_generated_function_is_named_rhs():
    rhs = generate_ode_function(sm.Matrix([V, X]), [X], [V])
    assert rhs.__name__ == "rhs"
    assert rhs.__module__ == "pydy.codegen.ode_function_generators"


def test_a_generator_of_an_old_version_is_refused_with_the_argument():
    with pytest.raises(ImportError, match=r"no `Lambdify.*`: use .* generator='lambdify'\)"):
        from pydy.codegen.ode_function_generators import (  # noqa: F401
            LambdifyODEFunctionGenerator,
        )
