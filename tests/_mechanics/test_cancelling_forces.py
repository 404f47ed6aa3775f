"""Noncontributing forces that cancel in equations of motion without being simplified away."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from oracles.oracle import Oracle
from pydy._mechanics.formulations import without_cancelling_forces
from pydy.mechanics import Definition
from pydy.system import System
from zoo import Model, T, _numbers, inertial_frame
from zoo.cases import close
from zoo.rolling import ball_on_a_turntable


def test_what_cancels_is_left_out_and_what_contributes_is_not():
    r, k = sm.symbols("r k")
    u, first, second = (sm.Function(name)(T) for name in ("u", "F", "G"))
    forcing = [r * (first - k * u) - r * first, second * u]
    kept = without_cancelling_forces(forcing, [first + second - u], {u})
    assert sm.simplify(sm.Matrix(kept) - sm.Matrix([-r * k * u, second * u])) == sm.zeros(2, 1)
    assert first not in kept[0].atoms(sm.Function)


HEIGHT, FORCE = (sm.Function(name)(T) for name in ("h", "R"))


@pytest.mark.parametrize(
    "share",
    [
        sm.Max(HEIGHT - 9, 0),
        sm.Max(HEIGHT, 9) - 9,
        sm.Heaviside(HEIGHT - 9),
        sm.Piecewise((1, HEIGHT > 9), (0, True)),
        sm.sqrt(HEIGHT**2) - HEIGHT,
        sm.Abs(HEIGHT) - HEIGHT,
        sm.exp(-2000 * HEIGHT),
    ],
)
def test_a_force_that_acts_in_some_states_only_is_kept(share):
    forcing = [-FORCE * share - HEIGHT]
    assert without_cancelling_forces(forcing, [FORCE], {HEIGHT}) == tuple(forcing)


def test_an_identity_of_angles_is_seen_beside_what_is_known_in_parts():
    identity = sm.sin(HEIGHT) ** 2 + sm.cos(HEIGHT) ** 2 - 1
    forcing = [FORCE * identity * sm.Max(HEIGHT - 9, 0) - HEIGHT]
    assert without_cancelling_forces(forcing, [FORCE], {HEIGHT}) == (-HEIGHT,)


@pytest.mark.parametrize("equations", [None, "graph", "method"])
def test_the_forces_in_a_rolling_contact_are_outputs_whatever_the_source(equations):
    model = ball_on_a_turntable()
    system = System(
        model.kane, dict(model.constants), noncontributing_forces=model.forces, equations=equations
    )
    assert not set(model.forces) & set(system.specifieds_symbols)
    system.specifieds = {s: model.specifieds[s] for s in system.specifieds_symbols}
    x = np.random.default_rng(4).uniform(0.2, 0.9, len(model.states))
    oracle = Oracle(model)
    wide = np.append(x, np.zeros(3))  # forces that depend on accelerations have integrals
    close(system.evaluate_ode(wide, 0.7)[: len(x)], oracle.xdot(x, 0.7), 1e-12)
    close(system.evaluate_outputs(wide, 0.7)[-3:], oracle.forces(x, 0.7), 1e-12)


def hinge_between_rods():
    """Two rods; the hinge's velocity is written in the axes of either, so that angles add up."""
    frame, origin = inertial_frame()
    q, u = list(me.dynamicsymbols("q1:3")), list(me.dynamicsymbols("u1:3"))
    slip, force = me.dynamicsymbols("s F")
    m, n, l, g = sm.symbols("m n l g")
    inner, outer = me.ReferenceFrame("A"), me.ReferenceFrame("B")
    inner.orient_axis(frame, frame.z, q[0])
    outer.orient_axis(frame, frame.z, q[0] + q[1])
    inner.set_ang_vel(frame, u[0] * frame.z)
    outer.set_ang_vel(frame, (u[0] + u[1]) * frame.z)
    tip, hinge = origin.locatenew("P", l * inner.x), origin.locatenew("H", l * inner.x)
    tip.set_vel(frame, l * u[0] * (sm.cos(q[0]) * frame.y - sm.sin(q[0]) * frame.x))
    across = sm.sin(q[1]) * outer.x + sm.cos(q[1]) * outer.y
    hinge.set_vel(frame, l * u[0] * across + slip * inner.y)
    end = hinge.locatenew("C", l * outer.x)
    end.v2pt_theory(hinge, frame, outer)
    loads = [
        (tip, -m * g * frame.y - force * inner.y),
        (hinge, force * inner.y),
        (end, -n * g * frame.y),
    ]
    kane = me.KanesMethod(
        frame, q, u, kd_eqs=[a.diff(T) - b for a, b in zip(q, u, strict=True)], u_auxiliary=[slip]
    )
    kane.kanes_equations([me.Particle("p", tip, m), me.Particle("c", end, n)], loads)
    return Model(kane, _numbers(m, n, l, g), {force: 0.37}, forces=(force,))


@pytest.mark.parametrize("equations", [None, "graph", "method"])
def test_a_force_that_cancels_by_an_identity_of_angles_is_noncontributing(equations):
    model = hinge_between_rods()
    system = System(
        model.kane, dict(model.constants), noncontributing_forces=model.forces, equations=equations
    )
    assert not system.specifieds_symbols
    x, oracle = np.array([0.4, 0.7, -0.5, 0.9]), Oracle(model)
    wide = np.append(x, 0.0)
    close(system.evaluate_ode(wide, 0.0)[:4], oracle.xdot(x), 1e-12)
    close(system.evaluate_outputs(wide, 0.0)[-1:], oracle.forces(x), 1e-12)


def along_a_direction(kind, load=None):
    """A particle that moves along a direction at a given angle, pushed along it."""
    x, v, angle, F = me.dynamicsymbols("x v angle F")
    frame, origin = inertial_frame()
    direction = sm.cos(angle) * frame.x + sm.sin(angle) * frame.y
    point = origin.locatenew("P", x * direction)
    point.set_vel(frame, v * direction)
    bodies = [me.Particle("P", point, 2)]
    loads = [(point, F * direction if load is None else load(frame, angle))]
    if kind == "kane":
        kane = me.KanesMethod(frame, [x], [v], [v - x.diff()])
        kane.kanes_equations(bodies, loads)
        return System(kane), F, angle
    return System(Definition(frame, [x], [v], bodies=bodies, loads=loads)), F, angle


@pytest.mark.parametrize("kind", ["definition", "kane"])
def test_a_direction_and_its_rate_that_cancel_are_no_specifieds(kind):
    system, F, angle = along_a_direction(kind)
    # Expressions of a method's own say what they hold.
    assert system.specifieds_symbols == ({F} if kind == "definition" else {F, angle})
    system.specifieds, system.initial_conditions = {F: 3.0}, {"v": 2.0}
    system.times = np.array([0.0, 1.0])
    np.testing.assert_allclose(system.integrate()[-1], [2.75, 3.5])
    energy = system.evaluate_energy(system.simulate())
    np.testing.assert_allclose(energy.kinetic[-1], 3.5**2)
    system.specifieds = {F: 3.0, angle: sm.sin(T)}  # taken, as for pictures
    np.testing.assert_allclose(system.integrate()[-1], [2.75, 3.5])


def test_a_direction_that_a_load_leaves_stays_and_its_rate_does_not():
    system, _, angle = along_a_direction("definition", lambda frame, _: 5 * frame.x)
    assert system.specifieds_symbols == {angle}
    system.specifieds, system.times = {angle: 0.3}, np.array([0.0, 1.0])
    np.testing.assert_allclose(system.integrate()[-1, 1], 2.5 * np.cos(0.3))
