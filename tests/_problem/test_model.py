"""Models of the same equations with other outputs, specifieds and constants."""

from copy import copy
from dataclasses import replace

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._problem import problem_of as problem_with
from pydy.errors import UnsupportedFunctionError
from pydy.models import multi_mass_spring_damper

t = me.dynamicsymbols._t
A, w = sm.symbols("A w")


def driven(**arguments):
    """A mass on a spring that a force pushes, with some attributes of its System."""
    system = multi_mass_spring_damper(apply_external_forces=True)
    for name, value in arguments.items():
        setattr(system, name, value)
    return system


force, position = me.dynamicsymbols("f0 x0")
EXPRESSION = A * sm.sin(w * t)


def problem_of(system, **settings):
    """The Problem of other settings than those of a System."""
    return problem_with(copy(system._models), replace(system._now().settings, **settings))


def compiled_problem_of(system, **settings):
    """The same, with all of its numbers read and its expressions compiled."""
    problem = problem_of(system, **settings)
    return problem, problem.p, problem.code


def test_other_settings_give_the_problem_of_a_system_to_which_they_are_assigned():
    settings = {
        "outputs": {sm.Symbol("power"): force * position.diff()},
        "specifieds": {force: EXPRESSION},
        "constants": {"A": 0.7, w: 1.3, "k0": 4.0},
    }
    system, assigned = driven(constants={"c0": 0.2}), driven(**settings)._now()
    before = system._now(), str(system)
    problem = problem_of(system, **settings)
    assert problem.definition.layout == assigned.definition.layout
    assert problem.constants == assigned.constants
    times, states = np.array([0.4]), np.array([[0.3, -0.2]])
    for one in (problem, assigned):
        rates = [-0.2, (0.7 * np.sin(1.3 * 0.4) - 4.0 * 0.3 + 0.2)]
        np.testing.assert_allclose(one.at(times, states).rates()[0], rates, rtol=1e-14)
    assert system._now().model is before[0].model
    assert str(system) == before[1]


@pytest.mark.parametrize(
    ("argument", "value"),
    [
        ("constants", {"nope": 1.0}),
        ("constants", {A: 1.0}),
        ("constants", {"k0": "stiff"}),
        ("specifieds", {"nope": 1.0}),
        ("specifieds", {force: "strong"}),
        ("specifieds", {force: force + 1}),
        ("specifieds", {force: sm.Function("g")(position)}),
        ("outputs", {1: position}),
        ("outputs", {t: position}),
        ("outputs", {sm.Symbol("a"): position.diff(t, 3)}),
    ],
)
def test_other_settings_are_refused_in_the_words_of_an_assignment(argument, value):
    with pytest.raises((ValueError, TypeError, UnsupportedFunctionError)) as assigned:
        driven(**{argument: value})
    with pytest.raises(type(assigned.value)) as refused:
        compiled_problem_of(driven(), **{argument: value})
    assert str(refused.value) == str(assigned.value)


def test_the_latest_two_models_are_stored():
    system = driven()
    models, empty = system._models, {}
    first, second, third = (
        models.definition(empty, (), {force: factor * EXPRESSION}, empty)
        for factor in (1, sm.Symbol("B"), sm.Symbol("C"))
    )
    stored = models.model(first), models.model(second)
    assert (models.model(first), models.model(second)) == stored
    models.model(third)
    assert models.model(second) is stored[1]
    models.model(third)
    renewed = models.model(first)
    assert renewed is not stored[0]
    assert renewed.definition == first


def test_options_of_the_code_give_other_models():
    system = driven()
    models, definition = system._models, system._definition
    model = models.model(definition)
    other = models.with_options({"generator": "lambdify"})
    assert not other.has_compiled
    assert type(other.model(definition).code.backend) is not type(model.code.backend)
    assert models.model(definition) is model


def test_a_potential_energy_leaves_the_code_as_it_is():
    system = driven()
    code = system.model
    system.potential_energy = 2 * position**2
    assert system.model is code
    assert system._now().model.energies.potential == 2 * position**2
    system.potential_energy = None
    assert system._now().model.energies.potential == sm.Symbol("k0") * position**2 / 2
