"""Largest accelerations of vehicles against closed forms and independent searches."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.optimize import brentq, minimize_scalar

from pydy import System
from pydy.errors import PyDyUserWarning
from pydy.mechanics import Definition
from pydy.vehicles import (
    CARS,
    BrushTire,
    MagicFormula,
    TMeasy,
    double_track,
    single_track,
)
from pydy.vehicles.gg import gg_diagram
from zoo.race_cars import friction_circle, point_mass
from zoo.tires import TABLE_A31

G, SPEED = 9.81, 20.0
CAR = CARS["bmw_320i"]
LOW = replace(CAR, height=1e-6)  # without load transfer
TORQUES = {"T_drive": (0.0, 6e3), "T_brake": (0.0, 12e3)}
BOUNDS = {"delta": (-0.5, 0.5), **TORQUES}
EXCLUSIVE = [("T_drive", "T_brake")]
FRICTION = 0.9


def driven_force(ellipse=(1.0, 1.0), hill=0.0):
    """Return a point whose controls are the size and the direction of its force, up a hill."""
    x, y, psi, u, force, angle = me.dynamicsymbols("x y psi u F gamma")
    N, B, O = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    O.set_vel(N, 0)
    B.orient_axis(N, N.z, psi)
    P = O.locatenew("P", x * N.x + y * N.y)
    P.set_vel(N, u * B.x)
    m = sm.Symbol("m")
    definition = Definition(
        N,
        [x, y, psi],
        [u],
        bodies=[me.Particle("point", P, m)],
        loads=[(P, (ellipse[0] * force * sm.cos(angle) - hill * x) * B.x)],
        kinematic_equations=[
            x.diff() - u * sm.cos(psi),
            y.diff() - u * sm.sin(psi),
            psi.diff() - ellipse[1] * force * sm.sin(angle) / (m * u),
        ],
    )
    return System(definition, {m: 800.0}, initial_conditions={u: SPEED})


@pytest.mark.parametrize("axes", [(1.0, 1.0), (0.7, 1.2)])
def test_the_diagram_of_a_point_mass_is_the_ellipse_of_its_forces(axes):
    angles = np.linspace(0.0, 2 * np.pi, 9) + 0.1
    bounds = {"F": (0.0, 800.0 * 9.0), "gamma": (-4.0, 4.0)}
    gg = gg_diagram(driven_force(axes), [10.0, 40.0], bounds, directions=angles)
    along, across = gg.longitudinal / axes[0], gg.lateral / axes[1]
    assert np.hypot(along, across) == pytest.approx(np.full((2, 9), 9.0), rel=1e-9)
    assert np.arctan2(gg.lateral, gg.longitudinal) == pytest.approx(
        np.tile(np.angle(np.exp(1j * angles)), (2, 1))
    )
    assert gg.states[:, :, -1] == pytest.approx(np.array([[10.0], [40.0]]) * np.ones(9))
    assert all("F" in names for names in gg.active.ravel())


def test_bounds_and_a_relation_limit_the_inputs():
    bounds = {"a_x": (-6.0, 3.0), "a_y": (-20.0, 20.0)}
    angles = [0.0, np.pi / 4, np.pi / 2, 2.5, np.pi]
    gg = gg_diagram(point_mass(), SPEED, bounds, directions=angles, path=friction_circle(8.0))
    expected = np.minimum(8.0, [3.0, 3.0 * np.sqrt(2.0), np.inf, 6.0 / abs(np.cos(2.5)), 6.0])
    assert gg.acceleration[0] == pytest.approx(expected, rel=1e-9)
    assert gg.active.tolist() == [[("a_x",), ("a_x",), ("path[0]",), ("a_x",), ("a_x",)]]


@cache
def tmeasy():
    """Return a tire whose largest forces at 0, 1 and 2 times 3 kN are those of a parabola."""
    return TMeasy(
        3000, rise_x=(90e3, 160e3), peak_x=(3300, 6200), peak_slip_x=(0.11, 0.12),
        sliding_x=(3000, 5600), sliding_slip_x=(0.5, 0.6), rise_y=(70e3, 120e3),
        peak_y=(3000, 5700), peak_slip_y=(0.16, 0.18), sliding_y=(2800, 5200),
        sliding_slip_y=(0.6, 0.8),
    )  # fmt: skip


def largest_side_force(load):
    """Return the peak of a tire: a parabola of the load through zero, 3000 N and 5700 N."""
    n = load / 3000
    return (2 * 3000 - 5700 / 2) * n - (3000 - 5700 / 2) * n**2


def test_the_lateral_limit_is_that_of_the_axle_which_slides_first():
    # The front axle bears b/L of m a_n. Its force is across its wheels, that of the car across its
    # path; tires at the rear are strong.
    strong = BrushTire(4000, stiffness=150e3, friction=2.0)
    car = double_track(replace(LOW, front=1.0, rear=1.5), (tmeasy(), strong))
    gg = gg_diagram(car, 60.0, BOUNDS, directions=[np.pi / 2, -np.pi / 2], exclusive=EXCLUSIVE)
    u, v = gg.states[0, 0, 5:7]
    delta = gg.inputs["delta"][0]
    force = 2 * largest_side_force(CAR.mass * G * 0.6 / 2) * np.cos(delta[0])
    limit = force / (0.6 * CAR.mass * np.cos(np.arctan2(v, u)))
    # A little less than the peak, where a smaller steering angle is worth more.
    assert limit * (1 - 5e-4) < gg.acceleration[0, 0] <= limit
    assert gg.acceleration[0, 0] == pytest.approx(gg.acceleration[0, 1], rel=1e-9)
    assert delta[0] > 0.0
    assert delta[0] == pytest.approx(-delta[1], rel=1e-4)


@pytest.mark.parametrize("share", [0.5, 0.66, 0.95])
def test_the_braking_limit_is_that_of_the_axle_which_locks_first(share):
    # Deceleration a moves the load m a h/L to the front; an axle with the share k of the torque
    # brakes by k m a, which is μ times its load at the limit.
    car = replace(CAR, front_brake_share=share)
    tire = BrushTire(4000, stiffness=80e3, friction=FRICTION)
    gg = gg_diagram(double_track(car, tire), SPEED, BOUNDS, directions=[np.pi], exclusive=EXCLUSIVE)
    a, b, h = car.front, car.rear, car.height
    front = FRICTION * G * b / (share * (a + b) - FRICTION * h)
    rear = FRICTION * G * a / ((1 - share) * (a + b) + FRICTION * h)
    expected = min(limit for limit in (front, rear) if limit > 0)
    assert gg.acceleration[0, 0] == pytest.approx(expected, rel=1e-9)


def test_the_limit_of_acceleration_is_that_of_the_driven_axle():
    tire = BrushTire(4000, stiffness=80e3, friction=FRICTION)
    gg = gg_diagram(double_track(CAR, tire), SPEED, BOUNDS, directions=[0.0], exclusive=EXCLUSIVE)
    a, b, h = CAR.front, CAR.rear, CAR.height
    assert gg.acceleration[0, 0] == pytest.approx(
        FRICTION * G * a / (a + b - FRICTION * h), rel=1e-9
    )


# A user's own car: two axles on Magic Formula tires that spin, the rear one driven and braked.
M, INERTIA, FRONT, REAR, RADIUS, J = 1100.0, 1800.0, 1.16, 1.42, 0.34, 3.4
LOADS = M * G * REAR / (FRONT + REAR), M * G * FRONT / (FRONT + REAR)
TIRE = MagicFormula(TABLE_A31)
SIDESLIP = 0.2


def axle(load, kappa, alpha):
    """Return the forces of a tire and its mirror image: numbers, arrays or expressions."""
    one, other = (TIRE.forces(load / 2, kappa, side * alpha) for side in (1, -1))
    return one.Fx + other.Fx, one.Fy - other.Fy


@cache
def own_car():
    X, Y, theta, vx, vy, omega, n_f, n_r = me.dynamicsymbols("X Y theta vx vy omega n_f n_r")
    steer, torque = me.dynamicsymbols("steer torque")
    N, B, O = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    O.set_vel(N, 0)
    B.orient_axis(N, N.z, theta)
    B.set_ang_vel(N, omega * N.z)
    P = O.locatenew("P", X * N.x + Y * N.y)
    P.set_vel(N, vx * B.x + vy * B.y)
    bodies = [me.RigidBody("car", P, B, M, (me.inertia(B, 0, 0, INERTIA), P))]
    loads = []
    for name, x, angle, spin, driven, load in (
        ("f", FRONT, steer, n_f, 0, LOADS[0]),
        ("r", -REAR, sm.Integer(0), n_r, torque, LOADS[1]),
    ):
        aside, c, s = vy + omega * x, sm.cos(angle), sm.sin(angle)
        rolling = vx * c + aside * s
        slip, slip_angle = RADIUS * spin / rolling - 1, sm.atan((aside * c - vx * s) / rolling)
        F_x, F_y = axle(load, slip, slip_angle)
        at = P.locatenew(name, x * B.x)
        loads.append((at, (F_x * c - F_y * s) * B.x + (F_x * s + F_y * c) * B.y))
        wheel = me.ReferenceFrame(f"W_{name}")
        wheel.orient_axis(B, B.y, 0)
        wheel.set_ang_vel(B, spin * B.y)
        at.set_vel(N, P.vel(N) + omega * x * B.y)
        bodies.append(me.RigidBody(f"w_{name}", at, wheel, 0, (me.inertia(B, 0, J, 0), at)))
        loads.append((wheel, (driven - RADIUS * F_x) * B.y))
    definition = Definition(
        N,
        [X, Y, theta],
        [vx, vy, omega, n_f, n_r],
        bodies=bodies,
        loads=loads,
        kinematic_equations=[
            X.diff() - vx * sm.cos(theta) + vy * sm.sin(theta),
            Y.diff() - vx * sm.sin(theta) - vy * sm.cos(theta),
            theta.diff() - omega,
        ],
    )
    start = {vx: SPEED, n_f: SPEED / RADIUS, n_r: SPEED / RADIUS}
    return System(definition, {}, initial_conditions=start)


def accelerations(angle, kappa, alpha):
    """Return acceleration, sideslip, a residual and the steering angle at slips of the rear axle.

    The rear side force balances the yaw moment of the front one, so that it says the whole side
    force, and with the direction the acceleration. The undriven front axle pushes across its wheel
    alone: the steering angle is that of its force, whose size is the residual.
    """
    x_r, y_r = axle(LOADS[1], kappa, alpha)
    side, beta = y_r * (FRONT + REAR) / FRONT, 0.0 * alpha
    for _ in range(15):
        a = side / (M * np.sin(angle + beta))
        r = a * np.sin(angle) / SPEED
        beta = np.arcsin(np.clip(np.tan(alpha) * np.cos(beta) + REAR * r / SPEED, -1, 1))
    front_x = M * a * np.cos(angle + beta) - x_r
    front_y = side * REAR / (FRONT + REAR)
    steer = np.arctan2(-front_x * np.sign(front_y), np.abs(front_y))
    moving = np.arctan2(SPEED * np.sin(beta) + FRONT * r, SPEED * np.cos(beta))
    free = 0.0 * alpha
    for _ in range(7):  # the slip without a longitudinal force, by secants
        force, more = (axle(LOADS[0], free + step, moving - steer)[0] for step in (0.0, 1e-5))
        free = free - 1e-5 * force / (more - force)
    return a, beta, axle(LOADS[0], free, moving - steer)[1] - front_y / np.cos(steer), steer


def largest_at(angle, kappa, xtol):
    """Return the largest acceleration over a grid of slip angles of the rear axle."""

    def at(alpha):
        return [float(v[0]) for v in accelerations(angle, kappa, np.array([alpha]))]

    grid = np.linspace(-0.35, 0.05, 81)
    with np.errstate(all="ignore"):
        a, beta, residual, _ = accelerations(angle, kappa, grid)
        crossings = np.flatnonzero(residual[:-1] * residual[1:] < 0.0)
        for k in sorted(crossings, key=lambda k: -a[k]):
            root = brentq(lambda alpha: at(alpha)[2], grid[k], grid[k + 1], xtol=xtol)
            largest, beta, rest, steer = at(root)
            if abs(rest) > 1e-3 * LOADS[0]:  # a pole
                continue
            if abs(beta) <= SIDESLIP and abs(steer) <= OWN_BOUNDS["steer"][1]:
                return largest
    return 0.0


def largest_by_grid(angle):
    """Return the largest acceleration on a grid of slips, and refined from there."""
    slips = np.linspace(-0.28, 0.28, 29)
    on_grid = [largest_at(angle, kappa, 1e-7) for kappa in slips]
    k = int(np.argmax(on_grid))
    refined = minimize_scalar(
        lambda kappa: -largest_at(angle, kappa, 1e-14),
        bounds=(slips[k - 1], slips[k + 1]),
        method="bounded",
        options={"xatol": 1e-6},
    )
    return on_grid[k], -float(refined.fun)


OWN_BOUNDS = {"steer": (-0.5, 0.5), "torque": (-6e3, 6e3)}
OWN_POSITION = ("X", "Y", "theta")


@cache
def own_diagram():
    angles = [0.5, np.pi / 2, 2.0, -2.0, np.pi, 2.2]
    return gg_diagram(own_car(), SPEED, OWN_BOUNDS, directions=angles, position=OWN_POSITION)


@pytest.mark.parametrize("k", [0, 1, 2, 5])
def test_a_car_on_magic_formula_tires_agrees_with_a_search_over_slips(k):
    gg = own_diagram()
    on_grid, refined = largest_by_grid(gg.directions[k])
    assert gg.acceleration[0, k] == pytest.approx(on_grid, rel=5e-3)
    assert gg.acceleration[0, k] == pytest.approx(refined, rel=1e-8)
    assert gg.active[0, k] == ()


def test_the_front_axle_slides_over_its_peak_where_that_brakes_more():
    # Its side force across steered wheels brakes a car whose brakes are at the rear alone. No
    # path from straight ahead along which the acceleration grows leads there.
    gg = own_diagram()
    vx, vy, omega = gg.states[0, 2, 3:6]
    angle = np.arctan2(vy + FRONT * omega, vx) - gg.inputs["steer"][0, 2]
    slips = np.linspace(-0.5, 0.0, 501)
    peak = slips[np.argmax(axle(LOADS[0], 0.0, slips)[1])]
    assert angle < peak < 0.0


def test_brakes_at_the_rear_alone_stop_a_car_with_the_peak_of_the_tires():
    peak = minimize_scalar(
        lambda slip: float(axle(LOADS[1], slip, 0.0)[0]), bounds=(-0.3, 0.0), method="bounded"
    )
    assert own_diagram().acceleration[0, 4] == pytest.approx(-float(peak.fun) / M, rel=1e-9)


def test_left_and_right_turns_are_mirror_images():
    gg = own_diagram()
    assert gg.acceleration[0, 2] == pytest.approx(gg.acceleration[0, 3], rel=1e-10)
    assert gg.lateral[0, 2] == pytest.approx(-gg.lateral[0, 3])
    assert gg.inputs["steer"][0, 2] == pytest.approx(-gg.inputs["steer"][0, 3], rel=1e-5)


def test_states_of_the_diagram_are_quasi_steady():
    car, gg = own_car(), own_diagram()
    names = [str(s).removesuffix("(t)") for s in car.states]
    for k in range(len(gg.directions)):
        r = {name: values[0, k] for name, values in gg.inputs.items()}
        rates = dict(zip(names, car.evaluate_ode(gg.states[0, k], 0.0, r=r), strict=True))
        u, v, yaw_rate = gg.states[0, k, 3:6]
        assert np.hypot(u, v) == pytest.approx(SPEED, rel=1e-12)
        assert abs(v / u) <= np.tan(SIDESLIP) + 1e-9
        assert [rates[name] for name in ("omega", "n_f", "n_r")] == pytest.approx([0] * 3, abs=1e-7)
        assert u * rates["vy"] - v * rates["vx"] == pytest.approx(0.0, abs=1e-7)
        assert gg.lateral[0, k] == pytest.approx(SPEED * yaw_rate)
        rise = (u * rates["vx"] + v * rates["vy"]) / SPEED
        assert gg.longitudinal[0, k] == pytest.approx(rise, abs=1e-8)


def test_a_speed_that_cannot_be_kept_is_not_a_number_and_warns():
    # Without a drive the air brakes the car: only directions that slow it down are possible.
    car = double_track(CAR, BrushTire(4000, stiffness=80e3, friction=FRICTION), drag_area=0.7)
    bounds = {"delta": (-0.5, 0.5), "T_brake": (0.0, 12e3)}
    with pytest.warns(PyDyUserWarning, match="found in 1 of 2 directions, the first at 40 m/s and"):
        gg = gg_diagram(car, 40.0, bounds, directions=[0.0, np.pi], inputs=["delta", "T_brake"])
    assert np.isnan(gg.acceleration[0, 0])
    assert np.isnan(gg.inputs["delta"][0, 0])
    assert gg.acceleration[0, 1] > 5.0


def test_inputs_without_bounds_are_refused():
    with pytest.raises(ValueError, match="two finite values for each input, got none for 'F_x'"):
        gg_diagram(single_track(CAR, free_speed=True), SPEED, {"delta": (-0.5, 0.5)})


def test_inputs_that_exclude_each_other_begin_at_zero():
    bounds = {**BOUNDS, "T_drive": (-1.0, 6e3)}
    with pytest.raises(ValueError, match="`bounds` of T_drive and T_brake must begin at 0"):
        gg_diagram(double_track(CAR), SPEED, bounds, exclusive=EXCLUSIVE)


def test_a_system_that_depends_on_the_position_is_refused():
    bounds = {"F": (0.0, 7e3), "gamma": (-4.0, 4.0)}
    with pytest.raises(ValueError, match=r"derivative of u\(t\) depends on x\(t\), y\(t\) or time"):
        gg_diagram(driven_force(hill=3.0), SPEED, bounds, directions=[0.0])


def test_unknown_symbols_of_a_limit_are_refused():
    bounds = {"a_x": (-6.0, 3.0), "a_y": (-20.0, 20.0)}
    with pytest.raises(ValueError, match="`path` has power"):
        gg_diagram(point_mass(), SPEED, bounds, path=[sm.Symbol("power") <= 1.0])


def test_a_diagram_is_plotted():
    bounds = {"a_x": (-6.0, 3.0), "a_y": (-5.0, 5.0)}
    ax = gg_diagram(point_mass(), [10.0, 20.0], bounds, directions=[0.0, np.pi / 2]).plot()
    assert [line.get_label() for line in ax.get_lines()] == ["10 m/s", "20 m/s"]
    assert ax.get_lines()[1].get_xdata() == pytest.approx([0.0, 5.0])
    assert ax.get_lines()[1].get_ydata() == pytest.approx([3.0, 0.0])
