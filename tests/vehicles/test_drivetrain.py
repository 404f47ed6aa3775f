"""Motors, differentials and air: laws as numbers, arrays and expressions."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.mechanics import Definition
from pydy.vehicles.machines import (
    aerodynamic_loads,
    differential_torques,
    gear_ratio,
    gear_torque,
    motor_torque,
    power_limited_torque,
)

SPEEDS, TORQUES = [100.0, 300.0, 500.0, 900.0], [80.0, 120.0, 120.0, 20.0]


def test_torques_lie_on_lines_between_the_speeds_of_the_table():
    omega = np.linspace(-50.0, 1200.0, 300)
    expected = 3.0 * np.interp(3.0 * omega, SPEEDS, TORQUES)
    assert motor_torque(omega, SPEEDS, TORQUES, ratio=3.0) == pytest.approx(expected)
    assert motor_torque(400.0, SPEEDS, TORQUES) == 120.0


def test_a_motor_in_a_model_reaches_the_speed_where_its_torque_balances_the_load():
    q, omega = me.dynamicsymbols("q omega")
    N, W, O = me.ReferenceFrame("N"), me.ReferenceFrame("W"), me.Point("O")
    W.orient_axis(N, N.y, q)
    W.set_ang_vel(N, omega * N.y)
    O.set_vel(N, 0)
    body = me.RigidBody("shaft", O, W, 1, (me.inertia(W, 0, 0.5, 0), O))
    torque = motor_torque(omega, SPEEDS, TORQUES, ratio=2.0) - 140
    shaft = Definition(N, [q], [omega], bodies=[body], loads=[(W, torque * N.y)])
    system = System(shaft, ode_solver="dop853", times=np.linspace(0.0, 20.0, 3))
    # 2 T(2 ω) = 140 where T = 70: half of the way from 500 to 900 rad/s.
    assert system.simulate()["omega"][-1] == pytest.approx(350.0, rel=1e-5)


@pytest.mark.parametrize("torque", [400.0, -250.0])
@pytest.mark.parametrize("speeds", [(30.0, 50.0), (50.0, 30.0), (40.0, 40.0), (40.02, 40.0)])
def test_a_differential_divides_the_torque_and_dissipates(torque, speeds):
    left, right = speeds
    shafts = differential_torques(torque, left, right, preload=20.0, bias=0.3, viscosity=2.0)
    assert sum(shafts) == pytest.approx(torque)
    given = torque * (left + right) / 2
    assert given - (shafts[0] * left + shafts[1] * right) >= 0.0
    assert differential_torques(torque, left, right) == (torque / 2, torque / 2)


@pytest.mark.parametrize("bias", [0.0, 0.25, 0.6])
def test_the_slower_shaft_has_the_torque_by_the_bias_ratio(bias):
    fast, slow = differential_torques(300.0, 60.0, 40.0, bias=bias)
    assert slow / fast == pytest.approx((1 + bias) / (1 - bias))


def test_expressions_of_a_differential_have_the_values_of_numbers():
    T, left, right = sm.symbols("T left right")
    law = {"preload": 15.0, "bias": 0.4, "viscosity": 0.7, "transition": 0.5}
    shafts = differential_torques(T, left, right, **law)
    for values in ((300.0, 20.0, 20.3), (-100.0, 5.0, 4.0)):
        at = dict(zip((T, left, right), values, strict=True))
        expected = differential_torques(*values, **law)
        assert [float(shaft.subs(at)) for shaft in shafts] == pytest.approx(expected)


def test_a_car_that_coasts_in_the_air_slows_down_by_its_closed_form():
    # m u' = −k u² with k = ρ c_d A/2: u = u_0/(1 + k u_0 t/m), and x = m/k ln(1 + k u_0 t/m).
    x, u, m = *me.dynamicsymbols("x u"), 1200.0
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    P = O.locatenew("P", x * N.x)
    P.set_vel(N, u * N.x)
    loads = aerodynamic_loads(P, N.x, N.z, N, drag_area=0.7, lift_area=-1.5, density=1.2)
    car = Definition(N, [x], [u], bodies=[me.Particle("car", P, m)], loads=loads)
    system = System(
        car, ode_solver="dop853", initial_conditions={u: 50.0}, times=np.linspace(0.0, 30.0, 4)
    )
    motion = system.simulate(rtol=1e-11, atol=1e-11)
    growth = 1 + 0.42 * 50.0 * motion.times / m
    assert motion["u"] == pytest.approx(50.0 / growth, rel=1e-9)
    assert motion["x"] == pytest.approx(m / 0.42 * np.log(growth), rel=1e-9, abs=1e-9)
    assert float(loads[0][1].dot(N.z).subs(u, 10.0)) == pytest.approx(-90.0)
    for axes, argument in (((2 * N.x, N.z), "forward"), ((N.x, N.z / 2), "up")):
        with pytest.raises(ValueError, match=f"`{argument}` must be of unit length, got"):
            aerodynamic_loads(P, *axes, N, drag_area=0.7)


@pytest.mark.parametrize(
    ("speeds", "torques", "message"),
    [
        ([1.0], [2.0], "`speeds` must be at least two finite numbers"),
        ([2.0, 1.0], [0.0, 1.0], "`speeds` must ascend"),
        ([1.0, 2.0], [0.0], "`torques` must be 2 finite numbers, one for each of `speeds`"),
    ],
)
def test_a_table_that_is_none_is_refused(speeds, torques, message):
    with pytest.raises(ValueError, match=message):
        motor_torque(1.0, speeds, torques)


def test_laws_of_a_differential_are_checked():
    with pytest.raises(ValueError, match=r"`bias` must be at most 1, got 1\.5"):
        differential_torques(1.0, 2.0, 3.0, bias=1.5)
    with pytest.raises(ValueError, match="`preload` must not be negative"):
        differential_torques(1.0, 2.0, 3.0, preload=-1.0)


def test_the_power_of_a_motor_is_constant_above_its_base_speed():
    omega = np.linspace(-200.0, 200.0, 401)
    torque = power_limited_torque(omega, 250.0, 80e3, ratio=8.0)
    above = np.abs(omega) > 40.0
    assert torque[above] * np.abs(omega[above]) == pytest.approx(80e3)
    assert torque[~above] == pytest.approx(2000.0)


def test_a_car_of_constant_power_gains_the_energy_that_the_motor_gives():
    # m u u' = P: u² = u_0² + 2 P t/m.
    x, u = me.dynamicsymbols("x u")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    P = O.locatenew("P", x * N.x)
    P.set_vel(N, u * N.x)
    force = power_limited_torque(u / 0.3, 200.0, 60e3, ratio=9.0) / 0.3
    car = Definition(N, [x], [u], bodies=[me.Particle("car", P, 1200.0)], loads=[(P, force * N.x)])
    system = System(
        car, ode_solver="dop853", initial_conditions={u: 15.0}, times=np.linspace(0.0, 10.0, 5)
    )
    motion = system.simulate(rtol=1e-11, atol=1e-11)
    assert motion["u"] == pytest.approx(np.sqrt(225.0 + 2 * 60e3 / 1200.0 * motion.times), rel=1e-9)


def test_each_gear_has_its_ratio():
    gears = np.array([-1.0, 0.0, 1.0, 2.0, 2.4, 3.0, 9.0])
    expected = [0.0, 0.0, 14.0, 8.0, 8.0, -4.0, -4.0]
    assert gear_ratio(gears, [3.5, 2.0, -1.0], final=4.0) == pytest.approx(expected)
    gear = sm.Symbol("gear")
    ratio = gear_ratio(gear, [3.5, 2.0, -1.0], final=4.0)
    assert [float(ratio.subs(gear, g)) for g in gears] == pytest.approx(expected)
    with pytest.raises(ValueError, match="`ratios` must be finite numbers that are not zero"):
        gear_ratio(1, [3.5, 0.0])


@pytest.mark.parametrize("torque", [80.0, -80.0, 0.0])
@pytest.mark.parametrize("ratio", [6.0, -3.0])
def test_a_gear_gives_less_power_than_it_receives(torque, ratio):
    speeds = np.linspace(-1.0, 1.0, 81)
    outside = gear_torque(torque, speeds, ratio, efficiency=0.9)
    given, taken = torque * ratio * speeds, outside * speeds
    assert (given - taken >= -1e-12 * abs(torque)).all()
    turning = np.abs(speeds) >= 0.1
    driving = turning & (given > 0)
    assert taken[driving] == pytest.approx(0.9 * given[driving])
    driven = turning & (given < 0)
    assert 0.9 * taken[driven] == pytest.approx(given[driven])
    assert gear_torque(torque, 5.0, ratio) == ratio * torque
    T, omega = sm.symbols("T omega")
    law = gear_torque(T, omega, ratio, efficiency=0.9)
    values = [float(law.subs({T: torque, omega: w})) for w in speeds]
    assert values == pytest.approx(list(outside))


def test_an_efficiency_above_one_is_refused():
    with pytest.raises(ValueError, match=r"`efficiency` must be at most 1, got 1\.2"):
        gear_torque(1.0, 2.0, 3.0, efficiency=1.2)


def test_behind_a_gear_the_inertia_of_the_motor_counts_by_the_square_of_the_ratio():
    q, w = me.dynamicsymbols("q1 q2"), me.dynamicsymbols("w1 w2")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    bodies = []
    for k, inertia in enumerate((0.05, 3.0)):
        W = me.ReferenceFrame(f"W{k}")
        W.orient_axis(N, N.x, q[k])
        W.set_ang_vel(N, w[k] * N.x)
        bodies.append(me.RigidBody(f"shaft{k}", O, W, 1, (me.inertia(W, inertia, 1, 1), O)))
    gear = Definition(
        N, q, w, bodies=bodies, loads=[(bodies[0].frame, 40.0 * N.x)],
        nonholonomic_constraints=[w[0] - gear_ratio(2, [12.0, 7.0]) * w[1]],
    )  # fmt: skip
    rates = System(gear).evaluate_ode([0.0, 0.0, 7.0, 1.0])
    assert rates[3] == pytest.approx(7.0 * 40.0 / (3.0 + 49.0 * 0.05), rel=1e-12)
    assert rates[2] == pytest.approx(7.0 * rates[3], rel=1e-12)
