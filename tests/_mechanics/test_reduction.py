"""Independent speeds that move dependent ones alike, against sixty digits."""

from dataclasses import replace
from functools import cache

import mpmath as mp
import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._program.interpret import run
from pydy.system import System
from zoo import inertial_frame

T = me.dynamicsymbols._t
M, G, L, R = sm.symbols("m g l r")


def on_a_turntable(chosen):
    """A turntable that slides, and an arm of two hinged rods from the ground to its rim.

    The arm's three angles follow from where the table is, except where the arm is stretched or its
    hand lies on the axis of its shoulder.
    """
    x, ph, a, b, c = q = me.dynamicsymbols("x ph a b c")
    v, w, ua, ub, uc = u = me.dynamicsymbols("v w ua ub uc")
    ground, o = inertial_frame()
    table, swung, upper, fore = (me.ReferenceFrame(name) for name in "TSUF")
    for frame, base, angle, axis, rate in (
        (table, ground, ph, "z", w),
        (swung, ground, a, "z", ua),
        (upper, swung, b, "y", ub),
        (fore, upper, c, "z", uc),
    ):
        frame.orient_axis(base, getattr(base, axis), angle)
        frame.set_ang_vel(base, rate * getattr(base, axis))
    centre = o.locatenew("C", x * (ground.x + ground.y))
    centre.set_vel(ground, v * (ground.x + ground.y))
    rim = centre.locatenew("E", R * table.x + R * table.z)
    rim.v2pt_theory(centre, ground, table)
    elbow = o.locatenew("B", -L * upper.y)
    elbow.v2pt_theory(o, ground, upper)
    hand = elbow.locatenew("H", -L * fore.y)
    hand.v2pt_theory(elbow, ground, fore)
    bodies = [me.RigidBody("table", centre, table, M, (me.inertia(table, 1, 1, M), centre))]
    for name, frame, place in (("upper", upper, elbow), ("fore", fore, hand)):
        bodies.append(me.RigidBody(name, place, frame, M / 2, (me.inertia(frame, 1, 2, 3), place)))
    bodies.append(me.RigidBody("swung", o, swung, M / 3, (me.inertia(swung, 1, 1, 1), o)))
    loads = [(p, -M * G * ground.y) for p in (elbow, hand)] + [(table, sm.sin(ph) * table.z)]
    order = [*chosen, *(k for k in range(5) if k not in chosen)]
    q, u = [q[k] for k in order], [u[k] for k in order]
    rates = [(hand.vel(ground) - rim.vel(ground)).dot(e) for e in (ground.x, ground.y, ground.z)]
    kane = me.KanesMethod(
        ground, q, u[:2],
        kd_eqs=[e.diff(T) - s for e, s in zip(q, u, strict=True)],
        u_dependent=u[2:], velocity_constraints=rates,
        constraint_solver="CRAMER", bodies=bodies, forcelist=loads,
    )  # fmt: skip
    return kane, rates


@cache
def equations():
    """K, b, M and F of all five speeds: those of the mechanism without its constraints."""
    kane, rates = on_a_turntable((0, 1))
    free = me.KanesMethod(
        kane._inertial, kane.q, kane.u,
        kd_eqs=[e.diff(T) - s for e, s in zip(kane.q, kane.u, strict=True)],
    )  # fmt: skip
    free.kanes_equations(kane.bodies, kane.loads)
    known = {e.diff(T): s for e, s in zip(kane.q, kane.u, strict=True)}
    k = sm.Matrix(rates).jacobian(kane.u)
    b = sm.Matrix(
        [r.diff(T).xreplace(dict.fromkeys([s.diff(T) for s in kane.u], 0)) for r in rates]
    )
    held = [m.xreplace(known) for m in (k, b, free.mass_matrix, free.forcing)]
    return list(kane.q), list(kane.u), held


@cache
def _in_numbers(symbols):
    """The same as a function of mpmath's numbers, which SymPy's would take twenty times as long."""
    return sm.lambdify([symbols], equations()[2], modules="mpmath", cse=True)


def solution(values, digits):
    """All u', then the multipliers, from rational numbers in so many digits."""
    with mp.workdps(digits):
        numbers = [mp.mpf(v.p) / v.q for v in values.values()]
        k, b, mass, force = _in_numbers(tuple(values))(numbers)
        system, right = mp.zeros(mass.rows + k.rows), mp.zeros(mass.rows + k.rows, 1)
        system[: mass.rows, : mass.rows] = mass
        system[: mass.rows, mass.rows :] = k.T
        system[mass.rows :, : mass.rows] = k
        right[: mass.rows, 0], right[mass.rows :, 0] = force, -b
        return list(mp.lu_solve(system, right))


def exactly(values):
    """u' by name, with multipliers, in sixty digits."""
    _, u, _ = equations()
    found = solution({s: sm.Rational(float(v)) for s, v in values.items()}, 60)
    return dict(zip(u, (float(a) for a in found[:5]), strict=True))


NUMBERS = {M: 1.25, G: 9.81, L: 0.75, R: 0.375}


def state_of(bend, seed):
    """A state whose forearm is at an angle to where the arm is stretched."""
    rng = np.random.default_rng(seed)
    q, u, _ = equations()
    values = dict(zip(q, rng.uniform(-0.6, 0.6, 5), strict=True))
    values[q[4]] = bend
    return values | dict(zip(u, rng.uniform(-1, 1, 5), strict=True))


@pytest.mark.parametrize("chosen", [(0, 1), (1, 3)])
@pytest.mark.parametrize("seed", range(3))
def test_accelerations_do_not_depend_on_how_nearly_parallel_motions_are(chosen, seed):
    system = System(on_a_turntable(chosen)[0], constants=NUMBERS)
    system.generate_ode_function(generator="lambdify")
    for bend in (0.5, 1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 1e-4, 1e-6, 1e-8):
        values = state_of(bend, seed)
        expected = exactly(values | NUMBERS)
        found = system.evaluate_ode([values[s] for s in system.states])
        rates = dict(zip(system.states, found, strict=True))
        size = max(map(abs, expected.values()))
        for speed, value in expected.items():
            assert abs(rates[speed] - value) < 3e-13 * size


def test_few_states_take_the_fallback_which_takes_longer_than_all_the_rest():
    system = System(on_a_turntable((0, 1))[0], constants=NUMBERS)
    program = system.model.compiled("rates").program
    within = {k for nodes in program.fallback.values() for k in nodes}
    guards = {k: args for k, (op, args) in enumerate(zip(program.ops, program.args, strict=True))
              if op == "guard" and k not in within}  # fmt: skip
    ((*_, condition, _),) = guards.values()
    x = np.random.default_rng(1).uniform(-0.6, 0.6, (2000, len(system.states)))
    numbers = np.array([NUMBERS[s] for s in system.model.layout.constants])
    sound = replace(program, outputs=(condition,))
    values, _ = run(sound, np.zeros(len(x)), x, np.zeros((len(x), 0)), numbers)
    assert 1.0 - values.mean() < 0.04  # without taking motions apart 0.13
