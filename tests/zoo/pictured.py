"""Twenty mechanisms as users write them down, without a shape: what pictures of them must show."""

from __future__ import annotations

from collections.abc import Callable
from copy import copy
from functools import cache

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.examples import whipple_bicycle
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System
from zoo import joints, loops

g = sm.Symbol("g")
MODELS: dict[str, Callable[[], System]] = {}
"""A function that returns the System, with times and a state to show, by the picture's title."""
OPTIONS: dict[str, dict] = {}
"""What `animate` must be told of some of them: here it is no shape, but where zero is."""


def _named(title):
    def keep(build):
        MODELS[title] = cache(build)
        return build

    return keep


def system_of(title):
    """A System of one of these, derived once."""
    return copy(MODELS[title]())


def animated(model, **options):
    """Its scene in motion, as `animate` makes it without shapes."""
    return system_of(model).animate(**OPTIONS.get(model, {}), **options)


def _system(definition, constants, start, duration=2.0):
    times = np.linspace(0.0, duration, 41)
    return System(definition, constants, initial_conditions=start, times=times)


def _turning(name, before, angle, rate, axis="z"):
    frame = me.ReferenceFrame(name)
    frame.orient_axis(before, getattr(before, axis), angle)
    frame.set_ang_vel(before, rate * getattr(before, axis))
    return frame


def _flat(name, centre, frame, mass, moment):
    return me.RigidBody(name, centre, frame, mass, (me.inertia(frame, 0, 0, moment), centre))


def _weights(frame, bodies):
    return [(body.masscenter, -body.mass * g * frame.y) for body in bodies]


@_named("Pendulums on a cart")
def _():
    system = n_link_pendulum_on_cart(2)
    system.constants = {"g": 9.81}
    system.initial_conditions = dict.fromkeys(system.coordinates[1:], 0.7)
    system.times = np.linspace(0.0, 2.0, 41)
    return system


@_named("Masses and springs")
def _():
    system = multi_mass_spring_damper(3, True, True)
    system.initial_conditions = dict.fromkeys(system.coordinates, 0.4)
    system.times = np.linspace(0.0, 2.0, 41)
    return system


@_named("Planar double pendulum")
def _():
    return planar_double_pendulum()


def planar_double_pendulum(unit=1.0, moment=1):
    """Two links in a plane whose inertias have one entry alone; lengths in a unit."""
    N, O = zoo.inertial_frame()
    q, u = me.dynamicsymbols("q1:3"), me.dynamicsymbols("u1:3")
    lengths, point, bodies = sm.symbols("l1:3"), O, []
    for k, (angle, rate, length) in enumerate(zip(q, u, lengths, strict=True), 1):
        own = _turning(f"A{k}", N, angle, rate)
        centre = point.locatenew(f"G{k}", -length / 2 * own.y)
        point = point.locatenew(f"P{k}", -length * own.y)
        bodies.append(_flat(f"link {k}", centre, own, 1, moment * unit**2 * sm.Symbol("I")))
    definition = Definition(N, q, u, bodies=bodies, loads=_weights(N, bodies))
    values = {g: 9.81 * unit, lengths[0]: unit, lengths[1]: 0.8 * unit, "I": 1.0}
    return _system(definition, values, {q[0]: 0.9, q[1]: 1.6})


@_named("Four-bar linkage of planar links")
def _():
    N, O = zoo.inertial_frame()
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    point, bodies = O, []
    for k, length in enumerate((1, 3, 2)):
        own = _turning(f"B{k}", N, q[k], u[k])
        centre = point.locatenew(f"C{k}", sm.Rational(length, 2) * own.x)
        bodies.append(_flat(("crank", "coupler", "rocker")[k], centre, own, 1, 1))
        point = point.locatenew(f"E{k}", length * own.x)
    bearing = O.locatenew("D", 3 * N.x)
    rows = [point.pos_from(bearing).dot(e) for e in (N.x, N.y)]
    start = {q[0]: 1.0, q[1]: 0.4, q[2]: -1.6}
    made = Definition(N, q, u, bodies=bodies, loads=_weights(N, bodies), holonomic_constraints=rows,
                      configuration=start)  # fmt: skip
    system = _system(made, {g: 9.81}, {q[0]: 1.0, u[0]: 2.0})
    system.set_dependent_initial_conditions()
    return system


def crane():
    """A trolley with a load on a rope whose length a winch changes; the place is in fixed axes."""
    N, O = zoo.inertial_frame()
    (x, angle, length), (v, w, s) = me.dynamicsymbols("x theta l"), me.dynamicsymbols("v w s")
    trolley = O.locatenew("T", x * N.x)
    load = trolley.locatenew("L", length * sm.sin(angle) * N.x - length * sm.cos(angle) * N.y)
    bodies = [me.Particle("trolley", trolley, 5), me.Particle("load", load, 2)]
    tension = me.dynamicsymbols("F")
    along = load.pos_from(trolley) / length
    loads = [*_weights(N, bodies), (load, -tension * along), (trolley, tension * along)]
    return Definition(N, [x, angle, length], [v, w, s], bodies=bodies, loads=loads), angle, length


@_named("Crane with a winch")
def _():
    definition, angle, length = crane()
    system = _system(definition, {g: 9.81}, {angle: 0.5, length: 2.0})
    system.specifieds = {"F": 25.0}
    return system


@_named("Pendulum on a spring, by SymPy's elements")
def _():
    N, O = zoo.inertial_frame()
    (angle, r), (w, s) = me.dynamicsymbols("theta r"), me.dynamicsymbols("w s")
    own = _turning("A", N, angle, w)
    bob = me.Particle("bob", O.locatenew("P", -r * own.y), 1)
    path = me.LinearPathway(O, bob.masscenter)
    elements = [me.LinearSpring(60, path, 1), me.LinearDamper(sm.Rational(1, 2), path)]
    loads = [*_weights(N, [bob]), *elements]
    made = Definition(N, [angle, r], [w, s], bodies=[bob], loads=loads)
    return _system(made, {g: 9.81}, {angle: 0.6, r: 1.3})


@_named("Pendulum in fixed axes, by Lagrange")
def _():
    N, O = zoo.inertial_frame()
    theta, m, l = me.dynamicsymbols("theta"), *sm.symbols("m l")
    bob = O.locatenew("P", l * sm.sin(theta) * N.x - l * sm.cos(theta) * N.y)
    bob.set_vel(N, bob.pos_from(O).dt(N))
    particle = me.Particle("bob", bob, m)
    particle.potential_energy = -m * g * l * sm.cos(theta)
    method = me.LagrangesMethod(me.Lagrangian(N, particle), [theta], bodies=[particle], frame=N)
    method.form_lagranges_equations()
    return _system(method, {g: 9.81, l: 1.0, m: 1.0}, {theta: 0.8})


def rolling_disc():
    """SymPy's documented rolling disc, whose contact point is the only one that rests."""
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    m, r, N = *sm.symbols("m r"), me.ReferenceFrame("N")
    Y = N.orientnew("Y", "Axis", [q[0], N.z])
    L = Y.orientnew("L", "Axis", [q[1], Y.x])
    R = L.orientnew("R", "Axis", [q[2], L.y])
    speed = R.ang_vel_in(N)
    R.set_ang_vel(N, u[0] * L.x + u[1] * L.y + u[2] * L.z)
    C = me.Point("C")
    C.set_vel(N, 0)
    centre = C.locatenew("Dmc", r * L.z)
    centre.v2pt_theory(C, N, R)
    inertia = me.inertia(L, m / 4 * r**2, m / 2 * r**2, m / 4 * r**2)
    body = me.RigidBody("disc", centre, R, m, (inertia, centre))
    kd = [(R.ang_vel_in(N) - speed).dot(uv) for uv in L]
    kane = me.KanesMethod(N, q, u, kd)
    kane.kanes_equations([body], [(centre, -m * g * Y.z)])
    return kane, q, u


@_named("Rolling disc of SymPy's documentation")
def _():
    kane, q, u = rolling_disc()
    return _system(kane, {g: 9.81, "r": 0.3, "m": 1.0}, {q[1]: 0.2, u[1]: 6.0, u[2]: 1.0})


@_named("Whipple's bicycle")
def _():
    bicycle = whipple_bicycle.derive()
    values = whipple_bicycle.benchmark_parameters(bicycle)
    start = whipple_bicycle.equilibrium(bicycle, 5.0)
    times = np.linspace(0.0, 1.0, 41)
    OPTIONS["Whipple's bicycle"] = {"origin": bicycle.points["O"], "up": "-z"}
    return System(bicycle.kane, values, initial_conditions=start, times=times)


@_named("Slider-crank")
def _():
    definition, start = loops.even_slider_crank()
    system = _system(definition, {g: 9.81}, start, 1.0)
    system.set_dependent_initial_conditions()
    return system


@_named("Scissor lift")
def _():
    definition, start = loops.scissor_lift(3)
    system = _system(definition, {g: 1.0}, start, 0.5)
    system.set_dependent_initial_conditions()
    return system


@_named("Furuta pendulum")
def _():
    N, O = zoo.inertial_frame()
    q, u = me.dynamicsymbols("q1:3"), me.dynamicsymbols("u1:3")
    arm = _turning("A", N, q[0], u[0])
    rod = _turning("B", arm, q[1], u[1], "x")
    tip = O.locatenew("P", sm.Symbol("l1") * arm.x)
    end = tip.locatenew("G", -sm.Symbol("l2") * rod.z)
    bodies = [
        _flat("arm", O, arm, 1, sm.Symbol("J1")),
        me.RigidBody("rod", end, rod, 1, (me.inertia(rod, 1, 1, 0) * sm.Symbol("J2"), end)),
    ]
    loads = [(b.masscenter, -b.mass * g * N.z) for b in bodies]
    values = {g: 9.81, "l1": 0.2, "l2": 0.15, "J1": 0.01, "J2": 0.001}
    return _system(Definition(N, q, u, bodies=bodies, loads=loads), values, {q[1]: 2.0, u[0]: 4.0})


@_named("Robot arm from URDF")
def _():
    from pathlib import Path

    import pydy.examples
    from pydy import robots

    robot = robots.read(Path(pydy.examples.__file__).with_name("pendulum.urdf"))
    system = robot.system() if callable(getattr(robot, "system", None)) else robot.system
    system.times = np.linspace(0.0, 2.0, 41)
    system.initial_conditions = {system.coordinates[0]: 0.8}
    return system


@_named("Car, single track")
def _():
    N, O = zoo.inertial_frame()
    (x, y, psi), (vx, vy, w) = me.dynamicsymbols("x y psi"), me.dynamicsymbols("vx vy w")
    own = _turning("B", N, psi, w)
    centre = O.locatenew("G", x * N.x + y * N.y)
    centre.set_vel(N, vx * own.x + vy * own.y)
    a, b, C = sm.symbols("a b C")
    front, rear = centre.locatenew("front", a * own.x), centre.locatenew("rear", -b * own.x)
    steer = sm.Rational(1, 20)
    loads = [
        (front, -C * (sm.atan((vy + a * w) / vx) - steer) * own.y),
        (rear, -C * sm.atan((vy - b * w) / vx) * own.y),
    ]
    car = _flat("car", centre, own, 1500, 2500)
    kinematic = [e - f for e, f in zip(
        (x.diff(), y.diff(), psi.diff()),
        (vx * sm.cos(psi) - vy * sm.sin(psi), vx * sm.sin(psi) + vy * sm.cos(psi), w),
        strict=True)]  # fmt: skip
    made = Definition(
        N, [x, y, psi], [vx, vy, w], bodies=[car], loads=loads, kinematic_equations=kinematic
    )
    return _system(made, {a: 1.2, b: 1.4, C: 8e4}, {vx: 15.0}, 3.0)


@_named("Quadcopter")
def _():
    N, O = zoo.inertial_frame()
    q, u = me.dynamicsymbols("x y z phi theta psi"), me.dynamicsymbols("u1:7")
    own = me.ReferenceFrame("B")
    own.orient_body_fixed(N, q[3:], "123")
    rates = own.ang_vel_in(N)
    own.set_ang_vel(N, u[3] * own.x + u[4] * own.y + u[5] * own.z)
    centre = O.locatenew("G", q[0] * N.x + q[1] * N.y + q[2] * N.z)
    centre.set_vel(N, u[0] * N.x + u[1] * N.y + u[2] * N.z)
    l, m = sm.symbols("l m")
    body = me.RigidBody("copter", centre, own, m, (me.inertia(own, 5e-3, 5e-3, 9e-3), centre))
    loads, thrust = [(centre, -m * g * N.z)], m * g / 4
    for k, arm in enumerate((own.x, own.y, -own.x, -own.y)):
        loads.append((centre.locatenew(f"rotor{k}", l * arm), thrust * own.z))
    kinematic = [q[k].diff() - u[k] for k in range(3)]
    kinematic += [(rates - own.ang_vel_in(N)).dot(e) for e in own]
    made = Definition(N, q, u, bodies=[body], loads=loads, kinematic_equations=kinematic)
    return _system(made, {g: 9.81, l: 0.2, m: 0.5}, {q[3]: 0.1, q[4]: 0.15, u[0]: 0.3})


@_named("Gyroscope")
def _():
    model = zoo.gyro()
    return _system(model.kane, {**model.constants}, model.start)


@_named("Chaplygin's sleigh")
def _():
    N, O = zoo.inertial_frame()
    (x, y, angle), (v, w) = me.dynamicsymbols("x y theta"), me.dynamicsymbols("v w")
    own, a = _turning("B", N, angle, w), sm.Symbol("a")
    blade = O.locatenew("A", x * N.x + y * N.y)
    blade.set_vel(N, v * own.x)
    centre = blade.locatenew("G", a * own.x)
    centre.v2pt_theory(blade, N, own)
    body = _flat("sleigh", centre, own, 1, 1)
    kinematic = [x.diff() - v * sm.cos(angle), y.diff() - v * sm.sin(angle), angle.diff() - w]
    made = Definition(N, [x, y, angle], [v, w], bodies=[body], kinematic_equations=kinematic)
    return _system(made, {a: 0.3}, {v: 0.5, w: 2.0}, 4.0)


@_named("Chain of SymPy's joints")
def _():
    system = System(joints.chain(), times=np.linspace(0.0, 1.0, 41))
    system.initial_conditions = {system.coordinates[0]: 0.6}
    return system


@_named("Wheel on a level road")
def _():
    return rolling_wheel()


def rolling_wheel(unit=1.0):
    """A wheel in a plane, given by the place where it touches the road; slip has a force."""
    N, O = zoo.inertial_frame()
    (x, angle), (v, w) = me.dynamicsymbols("x phi"), me.dynamicsymbols("v w")
    r, own = sm.Symbol("r"), _turning("W", N, angle, w)
    centre = O.locatenew("G", x * N.x + r * N.y)
    touching = centre.locatenew("C", -r * N.y)
    wheel = _flat("wheel", centre, own, 1, 40 * r**2)
    slip = me.dynamicsymbols("v") + r * w
    loads = [(centre, -g * N.y), (touching, -slip * N.x)]
    loads.append((own, r * slip * N.z))
    made = Definition(N, [x, angle], [v, w], bodies=[wheel], loads=loads)
    return _system(made, {g: 9.81 * unit, r: 0.4 * unit}, {v: 2.0 * unit, w: -1.0})


@_named("Quarter of a car")
def _():
    N, O = zoo.inertial_frame()
    (z, s), (v, w) = me.dynamicsymbols("z_axle z_body"), me.dynamicsymbols("v w")
    axle, body = O.locatenew("A", z * N.y), O.locatenew("B", s * N.y)
    bodies = [me.Particle("axle", axle, 40), me.Particle("car", body, 400)]
    path, tyre = me.LinearPathway(axle, body), me.LinearPathway(O, axle)
    elements = [me.LinearSpring(2e4, path, sm.Rational(1, 2)), me.LinearDamper(1500, path),
                me.LinearSpring(2e5, tyre, sm.Rational(3, 10))]  # fmt: skip
    made = Definition(N, [z, s], [v, w], bodies=bodies, loads=[*_weights(N, bodies), *elements])
    return _system(made, {g: 9.81}, {z: 0.3, s: 0.7})
