"""Accelerations and multipliers close to singular positions, to rounding times the condition."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from registry import has_fixed_step
from zoo import inertial_frame, loops

T = me.dynamicsymbols._t
M, L, B, F = sm.symbols("m l b f")
SAGS = [3e-2, 1e-2, 5e-3, 1e-3, 1e-4, 1e-6, 1e-8]


def truss(sag, front, metre=1.0, kilogram=1.0):
    """Two bars of half-span 1 hold a particle at a sag; another particle is free."""
    x, y, a, b, vx, vy, va, vb = me.dynamicsymbols("x y a b vx vy va vb")
    q, u = [x, y, a, b], [vx, vy, va, vb]
    frame, origin = inertial_frame()
    held = origin.locatenew("P", x * frame.x + y * frame.y)
    free = origin.locatenew("R", a * frame.x + b * frame.y)
    rows = [sm.sqrt((x + side * L) ** 2 + y**2) - B for side in (1, -1)]
    bodies = [me.Particle("p", held, M), me.Particle("r", free, M)]
    speeds = u if front == "definition" else [s.diff(T) for s in q]
    for point, (one, two) in ((held, speeds[:2]), (free, speeds[2:])):
        point.set_vel(frame, one * frame.x + two * frame.y)
    loads = [(held, -F * frame.y)]
    if front == "definition":
        method = Definition(
            frame, q, u, bodies=bodies, loads=loads, holonomic_constraints=rows,
            kinematic_equations=[c.diff(T) - s for c, s in zip(q, u, strict=True)],
        )  # fmt: skip
    else:
        energy = me.Lagrangian(frame, *bodies)
        method = me.LagrangesMethod(energy, q, hol_coneqs=rows, forcelist=loads, frame=frame)
    system = System(method)
    return system, sagging(system, sag, metre, kilogram)


def sagging(system, sag, metre=1.0, kilogram=1.0):
    """Set a truss's numbers; return the force."""
    force = 10.0 * kilogram * metre
    system.constants = {M: kilogram, L: metre, B: metre * np.sqrt(1.0 + sag * sag), F: force}
    system.initial_conditions = {me.dynamicsymbols("y"): -metre * sag}
    return force


def tensions(system):
    return dict(zip(sm.symbols("t0 t1"), system.constraint_forces.values(), strict=False))


@pytest.mark.parametrize("front", ["definition", "lagrange"])
@pytest.mark.parametrize(
    ("metre", "kilogram"), [(1.0, 1.0), (1e-9, 1e9), (1e9, 1e-9), (1e9, 1.0), (1e-9, 1e-9)]
)
def test_a_truss_holds_at_any_sag_in_any_units(front, metre, kilogram):
    system, _ = truss(SAGS[0], front)
    system.outputs = tensions(system)
    rates = len(system.states)
    for sag in SAGS:
        force = sagging(system, sag, metre, kilogram)
        assert np.abs(system.evaluate_ode()[:rates]).max() < 1e-14 * metre / sag
        tension = force / 2.0 * np.sqrt(1.0 + sag * sag) / sag
        np.testing.assert_allclose(-system.evaluate_outputs()[:2], tension, rtol=1e-15 / sag)


@pytest.mark.parametrize("front", ["definition", "lagrange"])
@pytest.mark.parametrize("metre", [1e-9, 1.0, 1e9])
def test_a_flat_truss_has_the_least_multipliers(front, metre):
    system, force = truss(0.0, front, metre)
    rates = system.evaluate_ode()
    (down,) = rates[rates != 0.0]
    np.testing.assert_allclose(down, -force, rtol=1e-15)
    system.outputs = tensions(system)
    np.testing.assert_allclose(system.evaluate_outputs()[:2], 0.0, atol=1e-15 * force)


@pytest.mark.parametrize("generator", ["llvm", "lambdify", "cython"])
def test_all_back_ends_hold_the_truss(generator):
    system, _ = truss(1e-3, "definition")
    system.generate_ode_function(generator=generator)
    assert np.abs(system.evaluate_ode()).max() < 1e-11


@pytest.mark.parametrize("constraints", [None, "project"])
@pytest.mark.parametrize("solver", ["dop853", "rk4"])
def test_a_truss_at_rest_stays_at_rest(solver, constraints):
    system, _ = truss(1e-3, "definition")
    system.ode_solver, system.times = solver, np.linspace(0.0, 1.0, 3)
    options = {"step": 1e-2} if has_fixed_step(solver) else {}
    x = system.integrate(constraints=constraints, **options)
    np.testing.assert_allclose(x, x[:1] * np.ones((3, 1)), rtol=0, atol=1e-12)


def test_derivatives_hold_in_a_truss():
    system, _ = truss(1e-3, "definition")
    # Whatever moves P breaks a bar: only its own row says so, d(x'')/dx is that of J u' + b = 0.
    np.testing.assert_allclose(system.evaluate_jacobian()[4:], 0.0, atol=1e-9)
    gradient = system.evaluate_jacobian(wrt=[F])
    np.testing.assert_allclose(gradient[4:], 0.0, atol=1e-12)


@pytest.mark.parametrize("rate", [0.0, 6.0])
@pytest.mark.parametrize("angle", [3e-2, 3e-3, 1e-4, 1e-6])
def test_three_cranks_nearly_in_line_turn_as_one_body(rate, angle):
    definition, _ = loops.three_cranks()
    system = System(definition, {loops.GRAVITY: 9.81})
    cranks, speeds = definition.coordinates[:3], definition.speeds[:3]
    system.initial_conditions = dict.fromkeys(cranks, angle) | dict.fromkeys(speeds, rate)
    found = dict(zip(system.states, system.evaluate_ode(), strict=True))
    expected = -9.81 * (1.5 + 2.0) / 3.0 * np.cos(angle)
    # The rounding of the state moves them by as much along the other branch, or all is lost that
    # the constraint of this branch adds.
    bound = 1e-14 * (10.0 + rate**2) / angle + min(
        1e-14 * rate**2 / angle**3, 2.0 * rate**2 * angle
    )
    assert max(abs(found[u] - expected) for u in speeds) < bound


@pytest.mark.parametrize("metre", [1e-9, 1.0, 1e9])
def test_one_of_two_motions_may_move_no_mass_of_its_own(metre):
    x, y, u, w = me.dynamicsymbols("x y u w")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", (x + y) * frame.x)
    point.set_vel(frame, (u + w) * frame.x)
    definition = Definition(
        frame, [x, y], [u, w], bodies=[me.Particle("p", point, M)], loads=[(point, x * frame.x)],
        kinematic_equations=[x.diff(T) - u, y.diff(T) - w], holonomic_constraints=[x - 2 * y],
    )  # fmt: skip
    system = System(definition, {M: 1.0}, initial_conditions={x: 2.0 * metre, y: metre})
    found = dict(zip(system.states, system.evaluate_ode(), strict=True))
    # (x + y)" = x with x" = 2 y".
    np.testing.assert_allclose([found[u], found[w]], [4 / 3 * metre, 2 / 3 * metre], rtol=1e-15)


@pytest.mark.parametrize("scale", [-1.0, -2.0, 3.0])
def test_a_factor_of_a_constraint_changes_nothing(scale):
    """What marks constraints for the solve is no entry of a user's rows."""
    x, y, u, v = me.dynamicsymbols("x y u v")
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, u * frame.x + v * frame.y)
    kane = me.KanesMethod(
        frame, [x, y], [u], kd_eqs=[x.diff() - u, y.diff() - v], u_dependent=[v],
        velocity_constraints=[scale * (v - sm.sin(x) * u)],
        bodies=[me.Particle("P", point, 2)], forcelist=[(point, 3 * frame.x - 5 * frame.y)],
    )  # fmt: skip
    system = System(kane)
    state = np.array([0.4, 0.1, 0.7, 0.7 * np.sin(0.4)])
    slope, bend = np.sin(0.4), np.cos(0.4) * 0.7**2  # v' = slope u' + bend
    along = (3.0 - 5.0 * slope - 2.0 * slope * bend) / (2.0 * (1.0 + slope**2))
    for call in ({}, {"generator": "lambdify"}):
        system.generate_ode_function(**call)
        found = system.evaluate_ode(state)[2:]
        np.testing.assert_allclose(found, [along, slope * along + bend], rtol=1e-14)
    system.times, system.ode_solver = np.linspace(0.0, 1.0, 3), "dop853"
    system.initial_conditions = dict(zip(system.states, state, strict=True))
    x = system.integrate(constraints="baumgarte", gain=2.0, rtol=1e-10, atol=1e-10)
    assert abs(x[:, 3] - np.sin(x[:, 0]) * x[:, 2]).max() < 1e-9
