"""Constraints that are redundant in one way of assembling a mechanism, but not in the one meant."""

import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy import optimize

from pydy._assembly.model import CompiledModel
from pydy._mechanics import dependents
from pydy.errors import PyDyUserWarning
from pydy.mechanics import Definition
from pydy.system import System
from zoo import inertial_frame, loops

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
    assert len(body.constraints.velocity) == len(body.constraints.holonomic) == 2 * stages
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
    monkeypatch.setattr(dependents, "AROUND", 1)
    system = lift(3)
    assert len(system.eom_method.multibody.constraints.velocity) == 4
    with pytest.raises(ValueError, match=r"constraints is 6, .* it was 4\..*`pydy.mechanics.Def"):
        system.integrate(constraints="project")
    with pytest.raises(ValueError, match="constraints is 6"):
        system.simulate()
    with pytest.raises(ValueError, match="constraints is 6"):
        system.integrate_ensemble(constants={loops.GRAVITY: [9.81, 1.62]})
    lift(3, configuration=True).simulate()


def test_redundant_constraints_that_contradict_each_other_in_a_length_are_named():
    frame, origin = inertial_frame()
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


LENGTHS = sm.symbols("a b c")


def pair(rows, constants=(), **options):
    """Two particles on a line."""
    frame, origin = inertial_frame()
    q, p, u, v = me.dynamicsymbols("q p u v")
    bodies = [
        me.Particle(name, origin.locatenew(name, s * frame.x), 1)
        for name, s in (("A", q), ("B", p))
    ]
    options = {kind: [e(q, p, u, v) for e in rows] for kind, rows in rows.items()}
    definition = Definition(frame, [q, p], [u, v], bodies=bodies, **options)
    start = {q: 4e4, p: 6e4}
    return System(definition, dict(constants), initial_conditions=start, times=TIMES)


def far(q, p, u, v):
    return q + p - 1e5


def together(q, p, u, v):
    return u + v


def rest(value):
    return lambda *states: value


@pytest.mark.parametrize(
    ("others", "left"),
    [
        ({"holonomic_constraints": [far]}, 7.3e-12),  # of 1e5 - 1e5
        ({"holonomic_constraints": []}, -1.1e-16),  # of a cosine between directions
        ({"nonholonomic_constraints": [together]}, 1.1e-16),
    ],
)
def test_what_rounding_leaves_of_numbers_contradicts_nothing(others, left):
    system = pair({kind: [*rows, rest(left)] for kind, rows in others.items()})
    system.integrate()
    system.linearize()


@pytest.mark.parametrize("others", [[far], []])
def test_a_number_that_is_no_rounding_contradicts(others):
    system = pair({"holonomic_constraints": [*others, rest(2e-8)]})
    with pytest.raises(ValueError, match=r"constraint: 2.0*e-8, .* alone: it is 2e-08\."):
        system.integrate()


@pytest.mark.parametrize("others", [[far], []])
def test_lengths_that_must_agree_are_constants_and_judged_as_they_were_typed(others):
    a, b, c = LENGTHS
    rows = {"holonomic_constraints": [*others, rest(a + b - c)]}
    for third in (0.1 + 0.2, 0.300001):
        system = pair(rows, {a: 0.1, b: 0.2, c: third})
        system.integrate()
        if others:
            system.ode_solver = "dop853"
            system.integrate(constraints="project")
    with pytest.raises(ValueError, match=r"constraint: a \+ b - c, .* alone: it is -0\.1\."):
        pair(rows, {a: 0.1, b: 0.2, c: 0.4}).integrate()
    with pytest.raises(ValueError, match=r"constraint: a \+ b - c, .* alone: it is -0\.1\."):
        pair(rows, {a: 0.1, b: 0.2, c: 0.4}).integrate_ensemble()


def test_a_condition_of_speeds_that_holds_none_is_one_of_the_constants():
    a, b, c = LENGTHS
    rows = {"nonholonomic_constraints": [together, rest(a * b - c)]}
    pair(rows, {a: 0.1, b: 3.0, c: 0.3}).integrate()
    with pytest.raises(ValueError, match=r"velocity constraint: a\*b - c, .* alone: it is -0\.1"):
        pair(rows, {a: 0.1, b: 3.0, c: 0.4}).integrate()


def test_long_rows_hold_up_to_their_rounding():
    # A nanometre of a million kilometres.
    def row(q, p, u, v):
        return q - p - 1e18

    system = pair({"holonomic_constraints": [row]})
    assert len(system.eom_method.multibody.constraints.holonomic) == 1


@pytest.mark.parametrize(
    ("configuration", "message"),
    [
        ([0.6], "`configuration` must be a dictionary, got list"),
        ({"nothing": 1.0}, "nothing"),
        (
            {sm.Symbol("other"): 1.0},
            "key `other`, which is not one of the coordinates, and constants",
        ),
        ({"x": "far"}, r"`configuration\[x\(t\)\]` must be"),
        ({"x": np.inf}, r"`configuration\[x\(t\)\]`"),
    ],
)
def test_a_configuration_is_of_numbers_for_what_is_known(configuration, message):
    frame, origin = inertial_frame()
    x = me.dynamicsymbols("x")
    body = me.Particle("P", origin.locatenew("P", x * frame.x), 1)
    with pytest.raises((TypeError, ValueError), match=message):
        Definition(frame, [x], bodies=[body], configuration=configuration)


def test_residuals_of_kept_rows_do_not_hide_those_that_were_left_out():
    definition, start = loops.spatial_four_bar()
    system = System(definition, initial_conditions=start)
    system.set_dependent_initial_conditions()
    regular = np.array([system.initial_conditions[s] for s in system.states])
    assert np.abs(system.evaluate_constraints(regular)).max() < 1e-9

    def rows(q):
        return system.evaluate_holonomic_constraints(np.append(q, np.zeros(3)))

    apart = regular + 0.0
    apart[:3] += (1.0, -0.5, 0.3)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", PyDyUserWarning)
        apart[:3] = optimize.least_squares(rows, apart[:3], xtol=1e-15, ftol=1e-15).x
    slopes = system.evaluate_jacobian(apart, wrt=list(system.speeds), of="velocity")
    apart[3:] = np.linalg.svd(slopes)[2][-1]
    states, times = [regular, apart], [0.0, 1.0]
    what = "left out as redundant does not hold at t = 1.0 .* in the redundant "
    for evaluate, kind in (
        (system.evaluate_constraints, "holonomic"),
        (system.evaluate_holonomic_constraints, "holonomic"),
        (system.evaluate_velocity_constraints, "velocity"),
    ):
        with pytest.warns(PyDyUserWarning, match=what + kind):
            found = evaluate(states, times)
        assert np.abs(found).max() < 1e-7


def test_samples_are_looked_at_together_and_one_that_contradicts_is_refused(monkeypatch):
    pytest.importorskip("xarray")
    (a, b, c), asked = LENGTHS, []
    interpreted = CompiledModel.interpreted

    def counted(model, parts, at):
        asked.append(len(at[0]))
        return interpreted(model, parts, at)

    monkeypatch.setattr(CompiledModel, "interpreted", counted)
    system = pair({"holonomic_constraints": [far, rest(a + b - c)]}, {a: 0.1, b: 0.2, c: 0.3})
    system.ode_solver = "dop853"
    third = np.full(40, 0.3)
    system.integrate_ensemble(constants={c: third}, constraints="project")
    assert asked
    assert set(asked) == {40}
    third[27] = 0.4
    with pytest.raises(ValueError, match=r"constraint: a \+ b - c, .* alone: it is -0\.1\."):
        system.integrate_ensemble(constants={c: third}, constraints="project")
