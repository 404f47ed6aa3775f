"""Largest accelerations of vehicles against friction circles and an independent search."""

from functools import cache

import numpy as np
import pytest
import sympy as sm
from scipy.optimize import minimize
from sympy.physics.mechanics import dynamicsymbols

from pydy.errors import OptimizationError
from pydy.vehicles import CARS, MagicFormula, single_track
from pydy.vehicles.tracks import gg_diagram
from zoo.race_cars import friction_circle, point_mass
from zoo.tires import TABLE_A31

CAR = CARS["bmw_320i"]
GRIP = 1.1  # of the rear axle in the friction ellipse


@cache
def car_on_tires():
    return single_track(CAR, MagicFormula(TABLE_A31), speed=20.0, free_speed=True)


def rear_circle():
    F_x, F_r = dynamicsymbols("F_x"), sm.Symbol("F_r")
    load = CAR.mass * 9.81 * CAR.front / (CAR.front + CAR.rear)
    return [(F_x**2 + F_r**2) / load**2 <= GRIP**2]


@cache
def axle(load):
    """Return the function of the slip angle that is the side force and moment of an axle."""
    slip = sm.Symbol("slip", real=True)
    one, other = (MagicFormula(TABLE_A31).forces(load / 2, 0, x) for x in (slip, -slip))
    return sm.lambdify(slip, [one.Fy - other.Fy, one.Mz - other.Mz], "math")


def independent(speed, angle):
    """Return the largest acceleration of that car, in the directions of its body."""
    m, a, b = CAR.mass, CAR.front, CAR.rear
    c, s = np.cos(angle), np.sin(angle)

    loads = m * 9.81 * np.array([b, a]) / (a + b)

    def terms(z):
        A, beta, delta, push = z * scale
        r = A * s / speed
        u, v = speed * np.cos(beta), speed * np.sin(beta)
        front, M_f = axle(loads[0])(np.arctan((v + a * r) / u) - delta)
        rear, M_r = axle(loads[1])(np.arctan((v - b * r) / u))
        X, Y = push - front * np.sin(delta), front * np.cos(delta) + rear
        # Along the path and across it, and the yaw moment.
        return (
            [
                (X * np.cos(beta) + Y * np.sin(beta)) / m - A * c,
                (Y * np.cos(beta) - X * np.sin(beta)) / m - A * s,
                (a * front * np.cos(delta) - b * rear + M_f + M_r) / (m * a),
            ],
            GRIP**2 - (push**2 + rear**2) / loads[1] ** 2,
        )

    scale = np.array([1.0, 0.1, 0.1, m])
    best = 0.0
    for start in (0.0, 3.0):
        result = minimize(
            lambda z: -z[0],
            [start, 0.0, 0.1 * s, start * c],
            method="SLSQP",
            constraints=[
                {"type": "eq", "fun": lambda z: terms(z)[0]},
                {"type": "ineq", "fun": lambda z: terms(z)[1]},
            ],
            options={"maxiter": 500, "ftol": 1e-13},
        )
        if np.abs(terms(result.x)[0]).max() < 1e-8 and terms(result.x)[1] > -1e-8:
            best = max(best, result.x[0])
    return best


def test_a_friction_circle_is_the_diagram_of_a_point_mass():
    angles = np.linspace(0.0, 2 * np.pi, 13)
    gg = gg_diagram(point_mass(), [10.0, 40.0], directions=angles, path=friction_circle(8.0))
    assert gg.acceleration == pytest.approx(np.full((2, 13), 8.0), abs=1e-6)
    assert gg.longitudinal == pytest.approx(np.tile(8.0 * np.cos(angles), (2, 1)), abs=1e-6)
    assert gg.lateral == pytest.approx(np.tile(8.0 * np.sin(angles), (2, 1)), abs=1e-6)
    assert gg.states[:, :, -1] == pytest.approx(np.array([[10.0], [40.0]]) * np.ones(13))


@pytest.mark.parametrize("speed", [15.0, 30.0])
def test_a_car_on_magic_formula_tires_agrees_with_an_independent_search(speed):
    angles = np.array([0.0, 0.6, 1.5, 2.2, np.pi])
    gg = gg_diagram(car_on_tires(), speed, directions=angles, path=rear_circle())
    expected = [independent(speed, angle) for angle in angles]
    assert gg.acceleration[0] == pytest.approx(expected, rel=1e-6)


def test_left_and_right_turns_are_mirror_images():
    angles = np.array([0.7, 1.6, 2.5])
    left, right = (
        gg_diagram(car_on_tires(), 20.0, directions=side * angles, path=rear_circle())
        for side in (1.0, -1.0)
    )
    assert left.acceleration == pytest.approx(right.acceleration, rel=1e-7)
    assert left.inputs["delta"] == pytest.approx(-right.inputs["delta"], abs=1e-5)


def test_states_of_the_diagram_are_quasi_steady():
    car = car_on_tires()
    gg = gg_diagram(car, 25.0, directions=[0.9, 2.3], path=rear_circle())
    names = [str(s) for s in car.states]
    for k in range(2):
        r = {name: values[0, k] for name, values in gg.inputs.items()}
        rates = dict(zip(names, car.evaluate_ode(gg.states[0, k], 0.0, r=r), strict=True))
        u, v, yaw_rate = gg.states[0, k, 3:]
        assert np.hypot(u, v) == pytest.approx(25.0)
        assert rates["r(t)"] == pytest.approx(0.0, abs=1e-6)
        assert u * rates["v(t)"] - v * rates["u(t)"] == pytest.approx(0.0, abs=1e-5)
        assert gg.lateral[0, k] == pytest.approx(25.0 * yaw_rate, rel=1e-7)
        rise = (u * rates["u(t)"] + v * rates["v(t)"]) / 25.0
        assert gg.longitudinal[0, k] == pytest.approx(rise, abs=1e-6)


def test_bounds_limit_the_controls():
    limits = {"F_x": (-3000.0, 2000.0)}
    gg = gg_diagram(car_on_tires(), 20.0, directions=[0.0, np.pi], bounds=limits)
    assert gg.acceleration[0] == pytest.approx([2000.0 / CAR.mass, 3000.0 / CAR.mass], rel=1e-9)


def test_without_limits_the_search_is_refused():
    with pytest.raises(OptimizationError, match="No largest acceleration was found at 20 m/s"):
        gg_diagram(point_mass(), 20.0, directions=[0.0])


def test_a_speed_that_cannot_be_kept_is_refused():
    a_x = dynamicsymbols("a_x")
    with pytest.raises(OptimizationError, match="in the direction 0 rad"):
        gg_diagram(point_mass(), 20.0, directions=[0.0], path=[a_x <= -1.0])


def test_unknown_symbols_of_a_limit_are_refused():
    with pytest.raises(ValueError, match="`path` has power"):
        gg_diagram(point_mass(), 20.0, path=[sm.Symbol("power") <= 1.0])


def test_a_diagram_is_plotted():
    ax = gg_diagram(point_mass(), [10.0, 20.0], path=friction_circle(5.0), directions=[0, 1]).plot()
    assert [line.get_label() for line in ax.get_lines()] == ["10 m/s", "20 m/s"]
    assert ax.get_lines()[1].get_ydata() == pytest.approx([5.0, 5.0 * np.cos(1.0)])
