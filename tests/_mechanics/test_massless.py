"""Constraints carry what moves no mass by itself: M is singular, the whole system is not."""

import mpmath as mp
import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from zoo import inertial_frame

T = me.dynamicsymbols._t
Q = me.dynamicsymbols("q1:4")
U = me.dynamicsymbols("u1:4")
M1, M2 = sm.symbols("m1 m2")
PUSH = (1.0, -0.3)


def model(method, places, row, count):
    """Masses at places (x, y) that are pushed alike, with one constraint."""
    q, u = Q[:count], U[:count]
    if method == "lagrange":
        u = [a.diff(T) for a in q]
    frame, origin = inertial_frame()
    bodies, loads = [], []
    for k, (place, mass) in enumerate(zip(places, (M1, M2), strict=False)):
        point = origin.locatenew(f"P{k}", place[0] * frame.x + place[1] * frame.y)
        rates = [sum(sm.diff(e, a) * b for a, b in zip(q, u, strict=True)) for e in place]
        point.set_vel(frame, rates[0] * frame.x + rates[1] * frame.y)
        bodies.append(me.Particle(f"p{k}", point, mass))
        loads.append((point, PUSH[0] * frame.x + PUSH[1] * frame.y))
    if method == "lagrange":
        lagrangian = me.Lagrangian(frame, *bodies)
        found = me.LagrangesMethod(
            lagrangian, q, hol_coneqs=[row], forcelist=loads, frame=frame, bodies=bodies
        )
        found.form_lagranges_equations()
        return found
    return Definition(
        frame, q, u, bodies=bodies, loads=loads, holonomic_constraints=[row],
        kinematic_equations=[a.diff(T) - b for a, b in zip(q, u, strict=True)],
    )  # fmt: skip


def exact(places, row, count, masses, x, u):
    """Accelerations by the whole system, in 40 digits."""
    q = Q[:count]
    at = {a: sm.Float(v, 40) for a, v in zip(q, x, strict=True)}
    with mp.workdps(40):

        def numbers(matrix):
            return mp.matrix(matrix.subs(at).evalf(40).tolist())

        speeds = mp.matrix(u)
        system, right = mp.zeros(count + 1), mp.zeros(count + 1, 1)
        for place, mass in zip(places, masses, strict=False):
            for e, force in zip(map(sm.sympify, place), PUSH, strict=True):
                slope = numbers(sm.Matrix([e]).jacobian(q))
                bend = (speeds.T * numbers(sm.hessian(e, q)) * speeds)[0]
                system[:count, :count] += mass * slope.T * slope
                right[:count, 0] += slope.T * (force - mass * bend)
        slope = numbers(sm.Matrix([row]).jacobian(q))
        system[:count, count], system[count, :count] = slope.T, slope
        right[count] = -(speeds.T * numbers(sm.hessian(row, q)) * speeds)[0]
        return np.array([float(a) for a in mp.lu_solve(system, right)[:count]])


A, B, C = Q
CASES = {  # places, row, coordinates, speeds
    "one mass": ([(A + B, 0)], A - 2 * B, (0.4, 0.2), (0.6, 0.3)),
    "decimals": (
        [(0.13 * A + 0.31 * B - 0.7 * C, 0), (0.41 * A + 0.21 * B + 0.9 * C, 0)],
        0.71 * A - 0.23 * B + 0.11 * A * C, (0.0, 0.0, 0.3), (0.23, 0.71 + 0.033, 0.5),
    ),
    "a pole": ([(A * sm.cos(B), A * sm.sin(B))], B - 2 * A, (0.0, 0.0), (1.0, 2.0)),
    "a mass for each": ([(A, 0), (0, B)], A - 2 * B, (0.4, 0.2), (0.6, 0.3)),
}  # fmt: skip


PAIRS = [(2.0, 3.0), (2.0, 0.0), (0.0, 3.0), (2.0, 1e-12), (1e-30, 3.0)]
MASSES = [
    *(("a mass for each", pair) for pair in PAIRS),
    *((name, PAIRS[0]) for name in CASES if name != "a mass for each"),
]  # fmt: skip


@pytest.mark.parametrize("method", ["definition", "lagrange"])
@pytest.mark.parametrize(("name", "masses"), MASSES)
def test_constraints_carry_what_is_massless(name, method, masses):
    places, row, x, u = CASES[name]
    count = len(x)
    constants = dict(zip((M1, M2)[: len(places)], masses, strict=False))
    system = System(model(method, places, row, count), constants)
    speeds = U[:count] if method == "definition" else [a.diff(T) for a in Q[:count]]
    order = [system.states.index(s) for s in (*Q[:count], *speeds)]
    state = np.zeros(2 * count)
    state[order] = [*x, *u]
    expected = exact(places, row, count, masses, x, u)
    for generator in ("llvm", "lambdify"):
        system.generate_ode_function(generator=generator)
        found = system.evaluate_ode(state)[order[count:]]
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-8 * np.abs(expected).max())
        assert np.isfinite(system.evaluate_jacobian(state)).all()


@pytest.mark.parametrize("masses", PAIRS)
def test_constraints_carry_what_is_massless_beside_many_masses(masses):
    q, u = me.dynamicsymbols("q1:16"), me.dynamicsymbols("u1:16")
    frame, origin = inertial_frame()
    names, bodies, loads = sm.symbols("m1:16"), [], []
    for k, (a, b) in enumerate(zip(q, u, strict=True)):
        along = frame.y if k == 1 else frame.x
        point = origin.locatenew(f"P{k}", a * along)
        point.set_vel(frame, b * along)
        bodies.append(me.Particle(f"p{k}", point, names[k]))
        loads.append((point, PUSH[0] * frame.x + PUSH[1] * frame.y))
    definition = Definition(
        frame, q, u, bodies=bodies, loads=loads, holonomic_constraints=[q[0] - 2 * q[1]],
        kinematic_equations=[a.diff(T) - b for a, b in zip(q, u, strict=True)],
    )  # fmt: skip
    system = System(definition, dict(zip(names, [*masses, *[1.0] * 13], strict=True)))
    state = np.zeros(30)
    state[[system.states.index(s) for s in (*q[:2], *u[:2])]] = 0.4, 0.2, 0.6, 0.3
    own = (2.0 * PUSH[0] + PUSH[1]) / (4.0 * masses[0] + masses[1])
    found = system.evaluate_ode(state)[[system.states.index(s) for s in u[:3]]]
    np.testing.assert_allclose(found, [2.0 * own, own, PUSH[0]], rtol=1e-8)
    assert np.isfinite(system.evaluate_jacobian(state)).all()


def test_an_oscillator_through_a_massless_coordinate_moves_as_in_closed_form():
    spring, push = sm.symbols("k F")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", (0.1 * A + 0.3 * B) * frame.x)
    point.set_vel(frame, (0.1 * U[0] + 0.3 * U[1]) * frame.x)
    force = push - spring * (0.1 * A + 0.3 * B)
    definition = Definition(
        frame, Q[:2], U[:2], bodies=[me.Particle("p", point, M1)], loads=[(point, force * frame.x)],
        kinematic_equations=[A.diff(T) - U[0], B.diff(T) - U[1]],
        holonomic_constraints=[A - 0.7 * B],
    )  # fmt: skip
    system = System(
        definition, {M1: 2.0, spring: 3.0, push: 1.0}, initial_conditions={A: 1.4, B: 2.0},
        times=np.linspace(0.0, 3.0, 7),
    )  # fmt: skip
    turn, rest = np.sqrt(1.5), 1.0 / 3.0
    expected = rest + (0.74 - rest) * np.cos(turn * system.times)
    for solver in ("dop853", "radau"):
        system.ode_solver = solver
        states = system.integrate(rtol=1e-10, atol=1e-10)
        place = states[:, [system.states.index(A), system.states.index(B)]] @ [0.1, 0.3]
        np.testing.assert_allclose(place, expected, atol=1e-8)
    found = system.linearize().eigenvalues
    np.testing.assert_allclose(sorted(found.imag), [-turn, turn], rtol=1e-12)


@pytest.mark.parametrize("order", [(0, 1, 2), (1, 2, 0), (1, 0, 2)])
@pytest.mark.parametrize("options", [{}, {"constraints": "project"}])
def test_a_row_of_a_massless_speed_alone_counts_beside_redundant_ones(order, options):
    """A bead on a rod that turns at ω: x = cosh(ωt) cos(ωt). The rod's angle has no inertia."""
    (x, y, angle), (vx, vy, turn) = Q, U
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x + y * frame.y)
    point.set_vel(frame, vx * frame.x + vy * frame.y)
    on_rod = y * sm.cos(angle) - x * sm.sin(angle)
    rate = 1.5
    rows = [angle - rate * T, on_rod, 2 * on_rod]
    system = System(
        Definition(
            frame, Q, U, bodies=[me.Particle("bead", point, M1)],
            holonomic_constraints=[rows[k] for k in order],
            kinematic_equations=[a.diff(T) - b for a, b in zip(Q, U, strict=True)],
        ),
        initial_conditions={x: 1.0, vy: rate, turn: rate},
        times=np.linspace(0.0, 2.0, 5), ode_solver="dop853",
    )  # fmt: skip
    motion = system.simulate(rtol=1e-10, atol=1e-10, **options)
    turned = rate * motion.times
    np.testing.assert_allclose(motion[x], np.cosh(turned) * np.cos(turned), rtol=0, atol=1e-8)
    np.testing.assert_allclose(motion[y], np.cosh(turned) * np.sin(turned), rtol=0, atol=1e-8)
