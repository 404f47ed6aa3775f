"""The kinds of arguments a generated function takes."""

import pytest

import zoo
from pydy.codegen.ode_function_generators import generate_ode_function
from zoo.cases import WAYS_OF_R, check_arguments, given

GENERATORS = ["llvm", "lambdify"]


@pytest.mark.parametrize("time_first", [False, True])
@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("p", ["array", "list", "dictionary"])
@pytest.mark.parametrize("r", WAYS_OF_R)
def test_every_kind_of_argument_is_taken(r, p, generator, time_first):
    rhs = generate_ode_function(
        generator=generator, time_first=time_first, **given(zoo.pendulum(), "[3]")
    )
    check_arguments(rhs, r, p, time_first)


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("p", ["array", "dictionary"])
@pytest.mark.parametrize("r", ["array", "dictionary", "function"])
def test_a_fixed_kind_of_argument_is_taken(r, p, generator):
    rhs = generate_ode_function(
        generator=generator,
        constants_arg_type=p,
        specifieds_arg_type=r,
        **given(zoo.pendulum(), "[3]"),
    )
    check_arguments(rhs, r, p, False)


def test_constants_cannot_be_a_function():
    with pytest.raises(ValueError, match="constants_arg_type"):
        generate_ode_function(constants_arg_type="function", **given(zoo.pendulum(), "[3]"))


def test_one_function_takes_different_kinds_in_turn():
    rhs = generate_ode_function(**given(zoo.pendulum(), "[3]"))
    for r in WAYS_OF_R:
        for p in ("array", "dictionary"):
            check_arguments(rhs, r, p, False)
