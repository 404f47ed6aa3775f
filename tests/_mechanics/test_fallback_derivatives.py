"""Derivatives where constrained accelerations take a fallback, against differences of 60 digits."""

from functools import cache

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics.mechanics.models import n_link_pendulum_on_cart as written_pendulum

from _mechanics.test_reduction import NUMBERS, M, equations, on_a_turntable, solution, state_of
from pydy import System
from pydy._graph.products import derivative_program
from pydy._graph.rewrite import make_canonical, rebuild
from pydy.errors import SingularMatrixError
from pydy.models import n_link_pendulum_on_cart
from system.test_formed import at_rest_with_the_constraints, nearly_dependent
from zoo.by_hand import coupler

STEP = sm.Rational(1, 10**25)


def differences(function, values, by):
    """Derivatives of a column of 80 digits by central differences."""
    columns = []
    for symbol in by:
        ends = [function({**values, symbol: values[symbol] + d * STEP}) for d in (1, -1)]
        columns.append([float(a) for a in (ends[0] - ends[1]) / (2 * STEP)])
    return np.array(columns).T


@cache
def turntable():
    return System(on_a_turntable((0, 1))[0], constants=NUMBERS)


@cache
def turntable_slopes(bend, held=False):
    """A state, at which the constraints may have to hold, and the derivatives of all u' by it."""
    system, values = turntable(), held_at(bend) if held else state_of(bend, 0)
    speeds = equations()[1]
    exact = {s: sm.Rational(float(v)) for s, v in (values | NUMBERS).items()}

    def accelerations(point):
        found = solution(point, 80)
        return sm.Matrix([sm.Float(found[speeds.index(s)], 80) for s in system.states[5:]])

    x = np.array([float(values[s]) for s in system.states])
    return x, differences(accelerations, exact, system.states)


@pytest.mark.parametrize("generator", ["llvm", "lambdify"])
@pytest.mark.parametrize("bend", [0.5, 3e-2, 1e-3, 1e-4, 1e-6])
def test_a_jacobian_is_exact_however_nearly_the_arm_is_stretched(bend, generator):
    system = turntable()
    system.generate_ode_function(generator=generator)
    x, expected = turntable_slopes(bend)
    found = system.evaluate_jacobian(x)
    size = np.abs(expected).max()
    np.testing.assert_allclose(found[5:], expected, rtol=0, atol=1e-12 * size)
    several = system.evaluate_jacobian(np.array([x, turntable_slopes(0.5)[0]]))
    np.testing.assert_allclose(several[0], found, rtol=0, atol=1e-13 * size)
    v = np.linspace(0.3, 0.9, 10)
    for product, whole in (
        (system.evaluate_jacobian_vector(v, x), found @ v),
        (system.evaluate_vector_jacobian(v, x), v @ found),
    ):
        np.testing.assert_allclose(product, whole, rtol=0, atol=1e-12 * size)


@pytest.mark.parametrize("size", [1e-4, 1e-6, 1e-8])
def test_a_jacobian_is_exact_where_dependent_speeds_hardly_follow(size):
    kane, e, rows = nearly_dependent(2, 2)
    x = at_rest_with_the_constraints(kane, rows, {e: sm.Float(size)})
    rates = {q.diff(me.dynamicsymbols._t): u for q, u in zip(kane.q, kane.u, strict=True)}
    held = [m.xreplace(rates) for m in (kane.mass_matrix, kane.forcing)]

    def accelerations(point):
        matrix, forcing = (m.xreplace(point).evalf(80) for m in held)
        return matrix.LUsolve(forcing)

    states = [*kane.q, *kane.u]
    exact = dict(zip(states, map(sm.Rational, map(float, x)), strict=True)) | {e: sm.Rational(size)}
    found = System(kane, {e: size}, equations="graph").evaluate_jacobian(x)[4:]
    expected = differences(accelerations, exact, states)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * np.abs(expected).max())


@cache
def links():
    """Five links on a cart, with exact accelerations that depend on the states and constants."""
    kane = written_pendulum(5, cart_force=False)
    numbers = {f"m{k}": 0.5 + 0.125 * k for k in range(6)} | {f"l{k}": 0.5 for k in range(5)}
    system = System(kane, equations="graph")
    constants = {s: numbers.get(str(s), 9.8125) for s in system.constants_symbols}
    matrices = kane.mass_matrix, kane.forcing

    def accelerations(point):
        matrix, forcing = (m.xreplace(point).evalf(80) for m in matrices)
        return matrix.LUsolve(forcing)

    return system, constants, accelerations


@pytest.mark.parametrize("turned", [1.0, 1e-2, 1e-4, 1e-6])
def test_derivatives_are_exact_where_a_joint_has_no_mass(turned):
    """By the elimination of bodies: no digit is left of the mass matrix, which is near singular."""
    system, constants, accelerations = links()
    system.constants = constants | {sm.Symbol("m2"): 0.0}
    x = np.array([0.1, *turned * np.linspace(0.6, 1.3, 5) ** 3, 0.2, 0.3, -0.4, 0.5, -0.2, 0.1])
    values = {**system.constants, **dict(zip(system.states, x, strict=True))}
    exact = {s: sm.Rational(float(v)) for s, v in values.items()}
    expected = differences(accelerations, exact, system.states)
    size = np.abs(expected).max()
    found = system.evaluate_jacobian(x)[6:]
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * size)
    back = system.evaluate_vector_jacobian(np.repeat([0.0, 1.0], 6), x)
    np.testing.assert_allclose(back, expected.sum(axis=0), rtol=0, atol=1e-12 * size)


def test_derivatives_by_a_singular_mass_matrix_are_an_error():
    system, constants, _ = links()
    system.constants = constants | {sm.Symbol("m5"): 0.0}
    x = np.linspace(0.1, 1.2, 12)
    for evaluate in (
        lambda: system.evaluate_jacobian(x),
        lambda: system.evaluate_jacobian_vector(x, x),
        lambda: system.evaluate_vector_jacobian(x, x),
    ):
        with pytest.raises(SingularMatrixError):
            evaluate()


def held_at(bend):
    """The turntable with a state that its constraints hold at."""
    _, speeds, held = equations()
    values = state_of(bend, 0)
    k = np.array(held[0].xreplace(values | NUMBERS).evalf(), dtype=float)
    u = np.array([values[s] for s in speeds])
    values |= dict(zip(speeds, u - np.linalg.pinv(k) @ (k @ u), strict=True))
    return values


def test_a_linear_model_is_exact_where_the_arm_is_nearly_stretched():
    system = turntable()
    x, expected = turntable_slopes(1e-6, held=True)
    model = system.linearize(x)
    tangents = np.asarray(model.C)
    chosen = [system.states.index(me.dynamicsymbols(name)) for name in model.states]
    whole = np.vstack([np.hstack([np.zeros((5, 5)), np.eye(5)]), expected])
    whole[:5] = system.evaluate_jacobian(x)[:5]
    expected = (whole @ tangents)[chosen]
    scale = np.abs(whole) @ np.abs(tangents)
    assert (np.abs(model.A - expected) < 1e-11 * scale[chosen].max()).all()


def test_sensitivities_and_adjoint_gradients_hold_where_the_arm_is_nearly_stretched():
    values, tight = held_at(1e-6), {"rtol": 1e-11, "atol": 1e-11}

    def made(mass):
        return System(
            on_a_turntable((0, 1))[0], constants=NUMBERS | {M: mass},
            initial_conditions=values, times=[0.0, 0.05, 0.1], ode_solver="dop853",
        )  # fmt: skip

    system = made(NUMBERS[M])
    trajectory = system.simulate(sensitivities=["m"], **tight)
    ends = [made(NUMBERS[M] + d).simulate(**tight).states for d in (1e-3, -1e-3)]
    expected = (ends[0] - ends[1]) / 2e-3
    found = np.asarray(trajectory.sensitivity.values)[..., 0]
    size = np.abs(expected).max()
    np.testing.assert_allclose(found, expected, rtol=0, atol=2e-6 * size)
    for k in (1, 3, 6):
        gradient = system.adjoint_gradient(["m"], final=system.states[k], **tight)
        np.testing.assert_allclose(gradient.values, found[-1, k], rtol=0, atol=1e-7 * size)


def test_derivatives_of_ordinary_models_take_no_more_operations():
    def count(system, *, guarded):
        assembly = system.model.assembly
        graph, nodes = assembly.simplified("rates")
        if not guarded:
            nodes = rebuild(graph, nodes, lambda node, op, args: as_found(graph, node, op, args))
        parts = [("x", k) for k in range(len(nodes))], "jacobian", assembly.sizes
        return derivative_program(graph, nodes, *parts).operation_count["run"].total()

    def as_found(graph, node, op, args):
        if op == "item" and graph.ops[args[0]] == "guard":
            return graph.args[args[0]][4][args[1]]
        return make_canonical(graph, op, args)

    kane = coupler().kane
    for system in (n_link_pendulum_on_cart(4), turntable(), System(kane, equations="graph")):
        assert count(system, guarded=True) <= 1.02 * count(system, guarded=False)


def test_sensitivities_of_ensembles_hold_where_the_arm_is_nearly_stretched():
    system = System(
        on_a_turntable((0, 1))[0], constants=NUMBERS, initial_conditions=held_at(1e-6),
        times=[0.0, 0.05], ode_solver="dop853",
    )  # fmt: skip
    tight = {"rtol": 1e-11, "atol": 1e-11}
    one = np.asarray(system.simulate(sensitivities=["m"], **tight).sensitivity.values)
    masses = NUMBERS[M] + np.array([0.0, 0.0, 0.1])
    many = system.integrate_ensemble(constants={M: masses}, sensitivities=["m"], **tight)
    found = np.asarray(many.sensitivity.values)[:, :, : one.shape[1]]
    assert np.isfinite(found).all()
    for sample in found[:2]:
        np.testing.assert_allclose(sample, one, rtol=0, atol=1e-7 * np.abs(one).max())
