"""Which states a motion advances along: nothing else depends on them, in exact arithmetic."""

import importlib

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy._names import unique_names
from pydy._states import advancing_states
from pydy._states.states import point_at
from pydy.examples import whipple_bicycle
from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles import CARS, single_track
from zoo import inertial_frame
from zoo.cases import system_of

X, V, F = me.dynamicsymbols("x v F")


def advancing(system):
    """The names of the advancing states at the initial conditions."""
    problem = system._now()
    point = point_at(problem, np.array([problem.t]), problem.x[None])
    names = unique_names(problem.definition.states)
    return [names[k] for k in advancing_states(point)]


def on_a_line(force):
    """A mass of 1 at x."""
    frame, origin = inertial_frame()
    place = origin.locatenew("P", X * frame.x)
    mass = me.Particle("P", place, 1)
    return System(Definition(frame, [X], [V], bodies=[mass], loads=[(place, force * frame.x)]))


def test_a_car_advances_by_its_position_and_then_by_its_heading():
    """The velocity over the road depends on the heading: the rates of two advancing states."""
    assert advancing(single_track(CARS["bmw_320i"])) == ["x", "y", "psi"]


def test_dependent_speeds_that_only_their_constraint_needs_are_advancing():
    """The velocity of the contact of a disc: two speeds, which turn with the yaw."""
    disc = system_of(zoo.disc())
    assert [str(s) for s in disc.states[8:]] == ["u4(t)", "u5(t)"]
    assert advancing(disc) == ["q1", "q3", "q4", "q5", "u4", "u5"]


def test_the_pitch_of_a_bicycle_is_not_advancing_though_a_constraint_gives_it():
    made = whipple_bicycle.derive()
    bicycle = System(made.definition, constants=whipple_bicycle.benchmark_parameters(made))
    names = advancing(bicycle)
    assert {"x", "y", "psi", "theta_R", "theta_F"} <= {*names}
    assert not {"phi", "delta", "theta", "u_phi", "u_delta", "omega_R"} & {*names}


@pytest.mark.parametrize(
    ("force", "expected"),
    [
        ((X + 1) ** 2 - X**2 - 2 * X, ["x"]),  # 1
        (sm.sin(X + 1) * sm.cos(X) - sm.cos(X + 1) * sm.sin(X), ["x"]),  # sin 1
        (-(X**3), []),  # its slope is zero at x = 0
        (-sm.Rational(1, 10**30) * X, []),
    ],
)
def test_neither_terms_that_cancel_nor_a_zero_at_one_state_are_misleading(force, expected):
    assert advancing(on_a_line(force)) == expected


def test_a_specified_that_follows_a_state_needs_it():
    system = on_a_line(F)
    system.specifieds = {F: 2.0}
    assert advancing(system) == ["x"]
    system.specifieds = {F: lambda x, t: -x[1]}
    assert advancing(system) == ["x"]
    system.specifieds = {F: lambda x, t: -x[0]}
    assert advancing(system) == []


def test_they_are_derived_once_for_all_numbers(monkeypatch):
    module, derived = importlib.import_module("pydy._states.advancing"), []
    jacobian = module.jacobian
    monkeypatch.setattr(module, "jacobian", lambda *a: derived.append(a) or jacobian(*a))
    car = single_track(CARS["bmw_320i"])
    for angle in (0.0, 0.05, 0.1):
        car.specifieds = {"delta": angle}
        car.initial_conditions = {"psi": angle}
        assert advancing(car) == ["x", "y", "psi"]
    assert len(derived) == 1
