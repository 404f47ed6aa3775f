"""Constraints that are redundant in one way of assembling a mechanism, but not in the one meant."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import loops
from pydy._mechanics import dependents
from pydy.mechanics import Definition
from pydy.system import System

TIMES = np.linspace(0.0, 0.4, num=21)


def lift(stages, **options):
    definition, start = loops.scissor_lift(stages, **options)
    system = System(definition, {loops.GRAVITY: 9.81}, initial_conditions=start, times=TIMES)
    system.ode_solver = "dop853"
    return system


@pytest.mark.parametrize(("stages", "configuration"), [(1, False), (3, False), (5, True)])
def test_a_lift_of_crossed_bars_has_one_degree_of_freedom(stages, configuration):
    system = lift(stages, configuration=configuration)
    body = system.eom_method.multibody
    assert len(body.velocity) == len(body.holonomic) == 2 * stages
    x = system.integrate(constraints="project", rtol=1e-10, atol=1e-10)
    places = [system.states.index(q) for q in system.eom_method.coordinates]
    rows = sm.lambdify([system.eom_method.coordinates], system.eom_method.holonomic_constraints)
    left = [rows(state[places]) for state in x]
    assert np.abs(left).max() < 1e-12  # also those that were left out
    energy = system.evaluate_energy(x, TIMES)
    assert np.ptp(energy.total) < 1e-8 * np.ptp(energy.kinetic)
    # From rest to its fall: all stages are alike.
    assert np.abs(x[-1, places[1]] - x[-1, places[1::2]]).max() < 1e-9
    assert x[-1, places[1]] < 0.5


def test_a_lift_that_was_taken_for_bars_on_each_other_is_refused_with_the_remedy(monkeypatch):
    monkeypatch.setattr(dependents, "_AROUND", 1)
    system = lift(3)
    assert len(system.eom_method.multibody.velocity) == 4
    with pytest.raises(ValueError, match=r"there are 6 .* only 4 were kept.*`pydy.mechanics.Def"):
        system.integrate(constraints="project")
    with pytest.raises(ValueError, match="6 independent"):
        system.simulate()
    with pytest.raises(ValueError, match="6 independent"):
        system.integrate_ensemble(constants={loops.GRAVITY: [9.81, 1.62]})
    lift(3, configuration=True).simulate()


def test_redundant_constraints_that_contradict_each_other_in_a_length_are_named():
    frame, origin = loops._ground()
    q, p, u, v = me.dynamicsymbols("q p u v")
    l = sm.Symbol("l")
    bodies = [
        me.Particle(name, origin.locatenew(name, s * frame.x), 1)
        for name, s in (("A", q), ("B", p))
    ]
    rows = [q + p - l, q + p - 2 * l]
    definition = Definition(frame, [q, p], [u, v], bodies=bodies, holonomic_constraints=rows)
    system = System(definition, {l: 1.0}, initial_conditions={q: 0.25, p: 0.75}, times=TIMES)
    system.ode_solver = "dop853"
    with pytest.raises(ValueError, match=r"`-2\*l \+ p\(t\) \+ q\(t\)` was left out .* it is -1 "):
        system.integrate()


@pytest.mark.parametrize(
    ("configuration", "message"),
    [
        ([0.6], "`configuration` must be a dictionary, got list"),
        ({"nothing": 1.0}, "nothing"),
        ({sm.Symbol("other"): 1.0}, "coordinates, and constants of the constraints, got other"),
        ({"x": "far"}, r"`configuration\[x\(t\)\]` must be"),
        ({"x": np.inf}, r"`configuration\[x\(t\)\]`"),
    ],
)
def test_a_configuration_is_of_numbers_for_what_is_known(configuration, message):
    frame, origin = loops._ground()
    x = me.dynamicsymbols("x")
    body = me.Particle("P", origin.locatenew("P", x * frame.x), 1)
    with pytest.raises((TypeError, ValueError), match=message):
        Definition(frame, [x], bodies=[body], configuration=configuration)
