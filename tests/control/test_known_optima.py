"""Problems with known optima, each with its source, from a plain guess."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from oracles import optima
from oracles.optima import TF, T
from pydy.control import OptimalControl
from pydy.errors import PyDyUserWarning
from pydy.inputs import SampledInput

METHODS = [("radau", 3), ("hermite-simpson", 1), ("midpoint", 1), ("backward-euler", 1)]


@pytest.mark.parametrize(("method", "order"), METHODS)
def test_the_least_energy_of_a_double_integrator_is_12(method, order):
    # F = 6 − 12 t: Bryson and Ho, Applied Optimal Control, 5.2.
    system, (x, v, F) = optima.double_integrator()
    problem = OptimalControl(
        system, sm.Integral(F**2, T), 1.0, end={x: 1.0, v: 0.0}, method=method, order=order
    )
    solution = problem.solve()
    if order == 1 and method != "hermite-simpson":  # Σ over 20 equal steps has another optimum
        assert solution.objective == pytest.approx(12.0 / (1.0 - 1.0 / 400.0), rel=1e-9)
    else:
        assert solution.objective == pytest.approx(12.0, rel=1e-9)
        np.testing.assert_allclose(solution[F], 6.0 - 12.0 * solution.times, atol=1e-6)


@pytest.mark.parametrize("method", ["radau", "hermite-simpson"])
def test_the_costates_of_a_double_integrator(method):
    # H = F²/2 + a v + b F: a' = 0, b' = −a and F = −b, so that a = −12 and b = −6 + 12 t (Bryson
    # and Ho, 5.2); a is the derivative of 6 (1 − x₀)² by x₀.
    system, (x, v, F) = optima.double_integrator()
    solution = system.optimize_trajectory(
        sm.Integral(F**2, T) / 2,
        1.0,
        end={x: 1.0, v: 0.0},
        mesh=[0.0, 0.2, 0.7, 1.0],
        method=method,
    )
    np.testing.assert_allclose(solution.costates[x], -12.0, rtol=1e-7)
    np.testing.assert_allclose(solution.costates[v], -6.0 + 12.0 * solution.mesh, rtol=1e-6)


@pytest.mark.parametrize(
    ("method", "mesh"),
    [("radau", 12), ("hermite-simpson", 12), ("midpoint", 24), ("backward-euler", 24)],
)
def test_costates_are_derivatives_of_the_objective_by_the_start(method, mesh):
    system, (q1, q2, u1, u2, F) = optima.cart_pole()
    ends = {"end": {q1: 0.5, q2: 0.3, u1: 0.0, u2: 0.0}, "method": method, "mesh": mesh}
    objective = sm.Integral(F**2, T) + u2.subs(T, 1.0) ** 2
    solution = system.optimize_trajectory(objective, 1.0, **ends)
    for state in (q1, q2, u1, u2):
        sides = [
            system.optimize_trajectory(objective, 1.0, start={state: h}, guess=solution, **ends)
            for h in (1e-4, -1e-4)
        ]
        slope = (sides[0].objective - sides[1].objective) / 2e-4
        assert solution.costates[state][0] == pytest.approx(slope, rel=1e-5, abs=1e-5)


def test_the_least_time_of_a_double_integrator_is_2():
    # One switch, in the middle: Bryson and Ho, 3.9.
    system, (x, v, F) = optima.double_integrator()
    solution = system.optimize_trajectory(
        TF, TF, end={x: 1.0, v: 0.0}, bounds={F: (-1.0, 1.0), TF: (0.1, 10.0)}
    )
    assert solution.objective == pytest.approx(2.0, rel=1e-6)
    assert solution.duration == solution.objective


def test_a_mass_of_2_kg_slides_a_metre_in_0_4_s():
    # ±50 N: half the way in √(2 · 0.5 / 25) = 0.2 s, and as long for the other half.
    system, (x, v, F) = optima.double_integrator(2)
    solution = system.optimize_trajectory(
        TF, TF, end={x: 1.0, v: 0.0}, bounds={F: (-50.0, 50.0), TF: (0.05, 5.0)}
    )
    assert solution.objective == pytest.approx(0.4, rel=1e-6)


@pytest.mark.parametrize("limit", [1 / 9, 1 / 12])
def test_the_problem_of_bryson_and_denham(limit):
    # x(0) = x(1) = 0, v(0) = 1 = −v(1), x ≤ l ≤ 1/6, min ½ ∫ a² dt: 4 / (9 l), with F = 0 between
    # 3 l and 1 − 3 l. Bryson and Ho, 3.11.
    system, (x, v, F) = optima.double_integrator()
    ends = {"start": {v: 1.0}, "end": {x: 0.0, v: -1.0}}
    nodes = np.concatenate(
        [np.linspace(0, 3 * limit, 9), np.linspace(3 * limit, 1 - 3 * limit, 4)[1:-1]]
    )
    nodes = np.concatenate([nodes, np.linspace(1 - 3 * limit, 1, 9)])
    solution = system.optimize_trajectory(
        sm.Integral(F**2, T) / 2, 1.0, **ends, bounds={x: (None, limit)}, mesh=nodes
    )
    assert solution.objective == pytest.approx(4.0 / (9.0 * limit), rel=1e-6)


@pytest.mark.parametrize(("method", "mesh"), [("radau", 20), ("hermite-simpson", 40)])
def test_the_brachistochrone_is_a_cycloid(method, mesh):
    system, (x, y, v, angle) = optima.brachistochrone()
    bounds = {TF: (0.1, 5.0)}
    problem = OptimalControl(
        system, TF, TF, end={x: 2.0, y: 2.0}, bounds=bounds, method=method, mesh=mesh, order=4
    )
    solution = problem.solve({v: [0.0, 6.0], angle: [0.0, 1.5]})
    exact = optima.cycloid_time(2.0, 2.0, 9.81)
    assert exact == pytest.approx(0.824338669439, rel=1e-12)
    assert solution.objective == pytest.approx(exact, rel=1e-7)


def test_the_hypersensitive_problem_of_betts():
    # Problem 10.7 of Betts, Practical Methods for Optimal Control, 2nd ed.: x' = −x³ + u from 1 to
    # 1.5 in 10,000 s. Between two boundary layers it rests at 0, so that each end has its own
    # optimum, by its Hamilton–Jacobi equation: u = x³ − √(x⁶ + x²) leads to 0 and
    # u = x³ + √(x⁶ + x²) away from it. Their costs are 2 ∫ (√(x⁶ + x²) ∓ x³) dx.
    system, (x, u) = optima.hypersensitive()
    layer = 25.0 * np.linspace(0.0, 1.0, 61) ** 1.5
    middle = np.geomspace(40.0, 5000.0, 6)
    nodes = np.concatenate([layer, middle, 10_000.0 - middle[-2::-1], 10_000.0 - layer[::-1]])
    solution = system.optimize_trajectory(
        sm.Integral(x**2 + u**2, T), 1e4, start={x: 1.0}, end={x: 1.5}, mesh=nodes, order=5
    )
    assert solution.objective == pytest.approx(leaving(1.5, 1.0) + leaving(1.0, -1.0), rel=1e-6)
    assert solution.objective == pytest.approx(6.7241, abs=1e-4)


def leaving(x, sign):
    """Return 2 ∫ (√(s⁶ + s²) + sign · s³) ds from 0 to x."""
    s, w = np.polynomial.legendre.leggauss(60)
    s, w = x * (1 + s) / 2, x * w / 2
    return float(2.0 * w @ (np.sqrt(s**6 + s**2) + sign * s**3))


def test_goddards_rocket_rises_to_1_01283():
    # Dolan, Moré and Munson, Benchmarking Optimization Software with COPS 3.0, ANL/MCS-TM-273.
    system, (h, m, v, thrust) = optima.goddard()
    problem = OptimalControl(
        system,
        -h.subs(T, TF),
        TF,
        start={h: 1.0, m: 1.0, v: 0.0},
        end={m: 0.6},
        bounds={thrust: (0.0, 3.5), TF: (0.05, 0.4), m: (0.6, 1.0), v: (0.0, None)},
        mesh=200,
        method="hermite-simpson",
    )
    with pytest.warns(PyDyUserWarning, match=r"`thrust\(t\)` enters linearly and chatters"):
        solution = problem.solve({v: 0.05, thrust: 1.7})
    assert -solution.objective == pytest.approx(1.01283, abs=1e-5)


def test_the_robot_arm_of_cops_takes_9_1409_s():
    # Dolan, Moré and Munson, Benchmarking Optimization Software with COPS 3.0, ANL/MCS-TM-273.
    system, (rho, theta, phi, a, b, c, *controls) = optima.robot_arm()
    rest = {a: 0.0, b: 0.0, c: 0.0}
    problem = OptimalControl(
        system,
        TF,
        TF,
        start={rho: 4.5, theta: 0.0, phi: np.pi / 4, **rest},
        end={rho: 4.5, theta: 2 * np.pi / 3, phi: np.pi / 4, **rest},
        bounds={
            **dict.fromkeys(controls, (-1.0, 1.0)),
            rho: (0.0, 5.0),
            theta: (-np.pi, np.pi),
            phi: (0.0, np.pi),
            TF: (1.0, 20.0),
        },
        mesh=80,
    )
    assert problem.solve().objective == pytest.approx(9.1409, abs=1e-4)


@pytest.mark.parametrize("method", ["radau", "hermite-simpson"])
def test_the_cart_pole_of_kelly_swings_up(method):
    problem, _ = optima.kelly(mesh=40, method=method)
    assert problem.solve().objective == pytest.approx(58.80766746, rel=1e-5)


@pytest.mark.parametrize(("mesh", "tolerance"), [(20, None), (7, None), (7, 1e-8)])
def test_a_known_input_that_jumps_gets_a_node_there(mesh, tolerance):
    # x'' = F + r, r = 2 before t = 0.3, then −1: the least ∫ F² with ∫ F (1 − t) = 1 − ∫ r (1 − t)
    # and ∫ F = −∫ r. At t = 0.3, a node of 20 intervals, each side has its own value.
    x, v, F, r = me.dynamicsymbols("x v F r")
    system = optima.first_order([x], v, F + r)
    system.specifieds = {r: SampledInput([0.0, 0.3, 1.0], [2.0, -1.0, -1.0], "previous")}
    problem = OptimalControl(system, sm.Integral(F**2, T), 1.0, end={x: 1.0, v: 0.0}, mesh=mesh)
    solution = problem.solve(mesh_tol=tolerance)
    asked = np.array([1.0 - (0.51 - 0.245), 0.7 - 0.6])
    least = asked @ np.linalg.solve([[1 / 3, 1 / 2], [1 / 2, 1.0]], asked)
    assert solution.objective == pytest.approx(least, rel=1e-8)
    assert solution.error.max() < 1e-9
    assert len(solution.mesh) < 30
