"""Wheels on surfaces: against planes, and the pendulum that a disc in a round valley is."""

from functools import cache

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve

from pydy.contact import kelvin_voigt
from pydy.mechanics import Definition, Implicit
from pydy.system import System
from pydy.vehicles import LinearTire, RoadSurface, WheelContact, iso_road
from zoo import inertial_frame
from zoo.wheels import COORDINATES, SPEEDS, free_wheel, values

R, G, M = 0.3, 9.81, 10.0
X, Y = me.dynamicsymbols("X Y")
STATE = {
    "x": 0.1, "y": -0.2, "z": 0.33, "yaw": 0.4, "lean": 0.3, "spin": 1.2,
    "vx": 8.0, "vy": 1.0, "vz": -0.3, "w1": 0.5, "w2": 20.0, "w3": -0.4,
}  # fmt: skip


def law(gap, rate):
    return kelvin_voigt(gap, rate, 1e5, 50.0)


def on(height, crown=0.0):
    """A free wheel with a spring on a surface."""
    w = free_wheel()
    w.road = RoadSurface(height, (X, Y), w.O, w.N)
    w.contact = WheelContact(
        w.body, w.B.y, R, w.road.point, w.road.normal, w.N, law, crown_radius=crown
    )
    w.residuals = w.road.residuals(w.contact)
    return w


def touched(w, state):
    """Return a state with the place where the wheel touches, and its rate, by differences."""

    def place(moved):
        def equations(at):
            return [values(w, e, {**moved, "X": at[0], "Y": at[1]}) for e in w.residuals.values()]

        return fsolve(equations, [moved["x"], moved["y"]], xtol=1e-10)

    return {**state, **dict(zip(("X", "Y"), place(state), strict=True))}


@pytest.mark.parametrize("crown", [0.0, 0.06])
def test_a_surface_that_is_a_plane_is_that_plane(crown):
    w = on(0.2 * X - 0.1 * Y + 0.05, crown)
    state = touched(w, STATE)
    base = w.O.locatenew("base", 0.05 * w.N.z)
    base.set_vel(w.N, 0)
    normal = (w.N.z - 0.2 * w.N.x + 0.1 * w.N.y) / sm.sqrt(1 + 0.2**2 + 0.1**2)
    plane = WheelContact(w.body, w.B.y, R, base, normal, w.N, law, crown_radius=crown)
    t = me.dynamicsymbols._t
    for name in ("gap", "rate", "normal_force", "speed", "kappa", "alpha", "gamma", "contact"):
        found = getattr(w.contact, name)
        if name == "rate":  # of a normal that does not turn
            found = found.subs({X.diff(t): 0, Y.diff(t): 0})
        expected = values(w, getattr(plane, name), state)
        assert values(w, found, state) == pytest.approx(expected, rel=1e-12), name


BUMPS = 0.05 * sm.sin(2 * X) * sm.cos(3 * Y) + 0.1 * X


@cache
def bumpy(lean):
    w = on(BUMPS)
    t = me.dynamicsymbols._t
    # A System knows the rates of what residuals give.
    coordinates = w.names
    definition = Definition(
        w.N,
        coordinates,
        w.rates,
        bodies=[w.body],
        loads=[(w.G, w.contact.rate * w.N.x)],
        kinematic_equations=w.kinematics,
    )
    outputs = {
        "gap": w.contact.gap,
        "rate": w.contact.rate,
        "C": (w.G.pos_from(w.road.point) + w.contact.contact).magnitude(),
        "X'": X.diff(t),
    }
    state = {**STATE, "lean": lean}
    return w, System(
        definition,
        implicit=Implicit(w.residuals),
        outputs=outputs,
        initial_conditions={me.dynamicsymbols(k): v for k, v in state.items()},
        times=[0.0, 1e-6, 2e-6],
    )


@pytest.mark.parametrize("lean", [0.3, -0.5])
def test_the_rate_of_the_gap_includes_the_turning_of_the_normal(lean):
    _, system = bumpy(lean)
    system.ode_solver = "dop853"
    motion = system.simulate(rtol=1e-12, atol=1e-12)
    # The wheel touches the surface itself, in its own plane.
    assert np.abs(motion["C"]).max() < 1e-12
    slope = (motion["gap"][2] - motion["gap"][0]) / 2e-6
    assert motion["rate"][1] == pytest.approx(slope, abs=1e-8)
    assert abs(motion["gap"][0]) > 0.01
    assert abs(motion["X'"][0]) > 1.0


def in_a_valley(height, contact_options=(), **options):
    """A rigid disc in plane motion that rolls in a valley without slip."""
    x, z, q, vx, vz, w = me.dynamicsymbols("x z q vx vz w")
    N, O = inertial_frame()
    W = me.ReferenceFrame("W")
    W.orient_axis(N, N.y, q)
    W.set_ang_vel(N, w * N.y)
    C = O.locatenew("C", x * N.x + z * N.z)
    C.set_vel(N, vx * N.x + vz * N.z)
    body = me.RigidBody("disc", C, W, M, (me.inertia(W, 0, M * R**2 / 2, 0), C))
    road = RoadSurface(height, (X, Y), O, N)
    contact = WheelContact(body, N.y, R, road.point, road.normal, N)
    definition = Definition(
        N,
        [x, z, q],
        [vx, vz, w],
        bodies=[body],
        loads=[(C, -M * G * N.z)],
        holonomic_constraints=contact.holonomic_constraints,
        nonholonomic_constraints=contact.nonholonomic_constraints[:1],
        dependent_coordinates=[z],
        dependent_speeds=[vz, w],
    )
    implicit = Implicit(road.residuals(contact))
    return System(definition, implicit=implicit, ode_solver="dop853", **options)


def test_a_disc_in_a_round_valley_is_a_pendulum():
    size, start = 2.0, 0.6
    arm = size - R
    times = np.linspace(0.0, 3.0, 31)
    system = in_a_valley(
        size - sm.sqrt(size**2 - X**2),
        initial_conditions={"x": arm * np.sin(start)},
        times=times,
    )
    system.set_dependent_initial_conditions()
    system.outputs = {"up": next(iter(system.constraint_forces.values()))}
    motion = system.simulate(rtol=1e-11, atol=1e-11)
    # 3/2 (R − r) θ'' = −g sin θ
    pendulum = solve_ivp(
        lambda t, s: [s[1], -G * np.sin(s[0]) / (1.5 * arm)],
        (0.0, 3.0),
        [start, 0.0],
        t_eval=times,
        rtol=1e-12,
        atol=1e-12,
        method="DOP853",
    )
    angle, rate = pendulum.y
    np.testing.assert_allclose(motion["x"], arm * np.sin(angle), atol=1e-9)
    np.testing.assert_allclose(motion["z"], size - arm * np.cos(angle), atol=1e-9)
    np.testing.assert_allclose(motion["w"], arm * rate / R, atol=1e-8)
    force = M * (G * np.cos(angle) + arm * rate**2)
    np.testing.assert_allclose(motion["up"], force, rtol=1e-8)


@pytest.mark.parametrize("crown", [0.0, 0.06])
def test_a_wheel_that_rolls_over_bumps_keeps_its_energy(crown):
    w = free_wheel(M, M * R**2 / 2, M * R**2 / 4)
    road = RoadSurface(BUMPS, (X, Y), w.O, w.N)
    contact = WheelContact(w.body, w.B.y, R, road.point, road.normal, w.N, crown_radius=crown)
    definition = Definition(
        w.N,
        w.names,
        w.rates,
        bodies=[w.body],
        loads=[(w.G, -M * G * w.N.z)],
        kinematic_equations=w.kinematics,
        holonomic_constraints=contact.holonomic_constraints,
        nonholonomic_constraints=contact.nonholonomic_constraints,
        dependent_coordinates=[w.z],
        dependent_speeds=w.rates[:3],
    )
    system = System(
        definition,
        implicit=Implicit(road.residuals(contact)),
        ode_solver="dop853",
        initial_conditions={"lean": 0.2, "w1": 0.5, "w2": 8.0, "w3": 0.5},
        times=np.linspace(0.0, 1.0, 11),
    )
    system.set_dependent_initial_conditions()
    system.outputs = {"gap": contact.gap}
    motion = system.simulate(rtol=1e-11, atol=1e-11, constraints="project")
    assert np.abs(motion["gap"]).max() < 1e-13
    assert np.ptp(motion["lean"]) > 0.1
    energy = motion.energy[:, 2]
    np.testing.assert_allclose(energy, energy[0], rtol=1e-10)


def test_a_profile_is_an_input_of_the_place_with_its_slope():
    profile = iso_road("D", 50.0, longest=50.0, shortest=2.0, seed=2)
    x, z, vx, vz, h = me.dynamicsymbols("x z vx vz h")
    t = me.dynamicsymbols._t
    N, O = inertial_frame()
    W = me.ReferenceFrame("W")
    W.orient_axis(N, N.y, 0)
    C = O.locatenew("C", x * N.x + z * N.z)
    C.set_vel(N, vx * N.x + vz * N.z)
    ground = O.locatenew("ground", h * N.z)
    ground.set_vel(N, h.diff(t) * N.z)
    body = me.RigidBody("wheel", C, W, M, (me.inertia(W, 0, 1, 0), C))
    contact = WheelContact(body, N.y, R, ground, N.z, N, law)
    system = System(
        Definition(
            N, [x, z], [vx, vz], bodies=[body],
            loads=[(C, M * (N.x - G * N.z)), *contact.loads()],
        ),
        {},
        {h: profile.height(x), h.diff(t): profile.slope(x) * vx},
        ode_solver="dop853",
        initial_conditions={z: R, vx: 3.0},
        times=np.linspace(0.0, 2.0, 2001),
    )  # fmt: skip
    system.outputs = {"gap": contact.gap, "rate": contact.rate}
    motion = system.simulate(rtol=1e-10, atol=1e-10)
    heights = profile.height(motion["x"])
    np.testing.assert_allclose(motion["gap"], motion["z"] - R - heights, atol=1e-12)
    differences = np.diff(motion["gap"]) / np.diff(system.times)
    between = (motion["rate"][1:] + motion["rate"][:-1]) / 2
    assert np.abs(differences - between).max() < 1e-3 * np.abs(between).max()
    assert motion["vx"][-1] == pytest.approx(5.0)


def test_a_plane_that_turns_is_refused():
    w = free_wheel()
    tilt = me.dynamicsymbols("tilt")
    P = w.N.orientnew("P", "Axis", (tilt, w.N.x))
    for angle in (tilt, 0.1 * sm.sin(me.dynamicsymbols._t)):
        plate = w.N.orientnew("plate", "Axis", (angle, w.N.x))
        with pytest.raises(ValueError, match=r"`normal` must be constant in `frame`, .* turns"):
            WheelContact(w.body, w.B.y, R, w.O, plate.z, w.N, law)
    # That of a surface goes with its point.
    surface = RoadSurface(0.1 * X**2, (X, Y), w.O, w.N)
    other = RoadSurface(0.2 * X**2, (X, Y), w.O, w.N)
    for point in (w.O, other.point):
        with pytest.raises(ValueError, match="give the `point` and the `normal` of a RoadSurface"):
            WheelContact(w.body, w.B.y, R, point, surface.normal, w.N, law)
    # A constant normal may have components in axes that turn, and a slope that is a symbol.
    up = sm.cos(tilt) * P.z + sm.sin(tilt) * P.y
    steep = w.N.orientnew("steep", "Axis", (sm.Symbol("slope"), w.N.x)).z
    for normal, same in ((up, w.N.z), (w.N.orientnew("A", "Axis", (tilt, w.N.z)).z, w.N.z)):
        found = WheelContact(w.body, w.B.y, R, w.O, normal, w.N, law)
        expected = values(w, WheelContact(w.body, w.B.y, R, w.O, same, w.N, law).rate, STATE)
        assert values(w, found.rate, {**STATE, "tilt": 0.7}) == pytest.approx(expected, rel=1e-12)
    assert WheelContact(w.body, w.B.y, R, w.O, steep, w.N, law).gap.has(sm.Symbol("slope"))


def test_several_wheels_touch_one_road():
    height = 0.05 * sm.cos(X)
    first, second = on(height), me.dynamicsymbols("X2 Y2")
    other = RoadSurface(height.subs(X, second[0]), second, first.O, first.N)
    contact = WheelContact(first.body, first.B.y, R, other.point, other.normal, first.N, law)
    joined = {**first.residuals, **other.residuals(contact)}
    assert list(joined) == [X, Y, *second]
    with pytest.raises(ValueError, match="`wheel` must touch this surface"):
        first.road.residuals(contact)


def test_a_tire_compiles_on_a_surface():
    w = on(BUMPS)
    definition = Definition(
        w.N,
        w.names,
        w.rates,
        bodies=[w.body],
        loads=[(w.G, -M * G * w.N.z), *w.contact.loads(LinearTire(M * G, 1e3, 1e3))],
        kinematic_equations=w.kinematics,
    )
    system = System(
        definition,
        implicit=Implicit(w.residuals),
        ode_solver="radau",
        initial_conditions={"z": R, "w2": 5.0, "vx": 1.5, "lean": 0.1},
        times=np.linspace(0.0, 0.5, 6),
    )
    motion = system.simulate()
    assert np.isfinite(motion.states).all()
    for names in (COORDINATES, SPEEDS):
        assert set(names.split()) <= set(motion.names)


def test_arguments_are_checked():
    N, O = inertial_frame()
    with pytest.raises(TypeError, match="`place` must be two functions of time"):
        RoadSurface(X**2, (X, X), O, N)
    with pytest.raises(ValueError, match="`height` must be a real number"):
        RoadSurface("flat", (X, Y), O, N)
    with pytest.raises(TypeError, match="`origin` must be a Point"):
        RoadSurface(X**2, (X, Y), N, N)
