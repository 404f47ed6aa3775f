"""Multipliers and reactions against SymPy's free equations, and Newton's and Euler's laws."""

import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import mechanisms
import zoo
from cases import close, wide
from mechanisms import MECHANISMS, derived, state
from newton import motion, needed
from oracle import Oracle
from pydy.system import System
from zoo import T


def model_of(name):
    return zoo.MODELS[name]() if name in zoo.MODELS else derived(MECHANISMS[name]())


def system_of(model, **options):
    system = System(model.kane, **options)
    for name in ("constants", "specifieds"):
        own = getattr(system, f"{name}_symbols")
        setattr(system, name, {k: v for k, v in getattr(model, name).items() if k in own})
    return system


def unbound(model):
    """The same bodies and loads, and no constraints: every speed is independent."""
    kane = model.kane
    rates = kane.kindiffdict()
    still = dict.fromkeys([*model.forces, *kane._uaux], 0)
    free = me.KanesMethod(
        kane._inertial,
        list(kane.q),
        list(kane.u),
        kd_eqs=[rate - rates[rate].xreplace(still) for rate in kane._qdot],
        kd_eqs_solver="CRAMER",
    )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        free.kanes_equations(
            kane.bodies, [load for load in kane.forcelist or () if load[1] != 0] or None
        )
    return free, still


def balance(model, x, t):
    """M u' − F with all speeds free, at the accelerations of the constrained motion."""
    free, still = unbound(model)
    rows = free.mass_matrix * free.u.diff(T) - free.forcing
    rows = [r.xreplace(still).doit().xreplace(still) for r in rows]
    return Oracle(model).evaluate(rows, x, t)


def gradients(model, system, x, t):
    """∂c'/∂u of the rows of `system.constraints`."""
    kane, rates = model.kane, model.kane.kindiffdict()
    count = system.num_holonomic_constraints
    rows = [c.diff(T) if k < count else c for k, c in enumerate(system.constraints)]
    rows = [sm.sympify(r).xreplace(rates) for r in rows]
    cells = [r.diff(u) for r in rows for u in kane.u]
    return Oracle(model).evaluate(cells, x, t).reshape(len(rows), len(kane.u))


NAMES = ["fourbar", "track", "track_reversed", "sleigh", "disc", "lifted", "coupler"]


@pytest.mark.parametrize("source", ["graph", "method"])
@pytest.mark.parametrize("name", NAMES)
def test_multipliers_close_the_equations_of_all_speeds(name, source):
    model = model_of(name)
    system = system_of(model, equations=source)
    system.outputs = dict(system.constraint_forces)
    x, t = (model.x0, 0.3) if model.start else model.sample(3)
    multipliers = system.evaluate_outputs(x, t)[: system.num_constraints]
    close(gradients(model, system, x, t).T @ multipliers, balance(model, x, t), 1e-12)


def test_a_quaternions_norm_has_no_multiplier():
    assert system_of(zoo.gyro()).constraint_forces == {}


@pytest.mark.parametrize("source", ["graph", "method"])
def test_the_contact_of_a_disc_pushes_as_sympys_auxiliary_speeds_say(source):
    model = zoo.disc_contact()
    system = system_of(model, equations=source)
    (disc,) = model.kane.bodies
    axes = disc.inertia[0].args[0][1].args[0][1]
    contact = disc.masscenter.locatenew("P", -sm.Symbol("r") * axes.z)
    reaction = system.reaction(disc, contact)
    system.outputs = {**system.constraint_forces, **reaction.outputs("contact")}
    x = model.x0
    friction, force, torque = np.split(system.evaluate_outputs(x)[:8], [2, 5])
    expected = Oracle(model).forces(x)
    close(force[[0, 2]], expected, 1e-12)
    close(friction, force[:2], 1e-12)
    close(torque, np.zeros(3), 1e-12)


def branch():
    model = mechanisms.branches.__wrapped__()  # kanes_equations() takes its actuators apart
    bodies = model.kane.bodies[2:]
    above = model.kane.bodies[0]
    hinge = above.masscenter.locatenew(
        "H", sm.Symbol("l1") / 2 * above.frame.x - sm.Symbol("l1") / 7 * above.frame.z
    )
    loads = [*model.kane.forcelist[2:5]]
    loads += [load for load in model.kane.forcelist[5].to_loads() if load.point.name == "E4"]
    return model, bodies, hinge, loads


def plate():
    model = mechanisms.tilted_plates()
    second = model.kane.bodies[1]
    c, d = sm.symbols("c d")
    hinge = second.masscenter.locatenew("H2", -d * second.frame.y - c * second.frame.z)
    return model, [second], hinge, model.kane.forcelist[1:]


def cart():
    model = zoo.free_pendulum()
    bodies = model.kane.bodies
    return model, bodies[2:], bodies[1].masscenter, model.kane.forcelist[2:]


@pytest.mark.parametrize("cut", [branch, plate, cart])
def test_a_joint_holds_what_lies_beyond_it_as_newton_and_euler_say(cut):
    model, bodies, point, loads = cut()
    system = system_of(model)
    system.outputs = system.reaction(bodies, point).outputs("joint")
    system.constants = {k: v for k, v in model.constants.items() if k in system.constants_symbols}
    x, t = state(model, 6)
    path = motion(system.coordinates, x, system.evaluate_ode(x, t)[: len(x)])
    frame = model.kane._inertial
    origin = next(p for p in points_from(bodies[0].masscenter) if p._vel_dict.get(frame) == 0)
    numbers = {
        **model.constants,
        **dict(zip(system.speeds, x[len(system.coordinates) :], strict=True)),
    }
    expected = needed(bodies, point, origin, frame, path, numbers, [tuple(b) for b in loads])
    close(system.evaluate_outputs(x, t), expected, 1e-12)


def points_from(point):
    found, todo = {point: None}, [point]
    while todo:
        for other in todo.pop()._pos_dict:
            if other not in found:
                found[other] = None
                todo.append(other)
    return found


def test_the_pins_of_a_four_bar_follow_one_another():
    model = derived(mechanisms.coupler())
    system = system_of(model, equations="graph")
    first, second, third = model.kane.bodies
    frame = model.kane._inertial
    lengths = sm.symbols("l1:5")

    def end(body, k, sign):
        name = f"{body.name}{'+' if sign > 0 else '-'}"
        arm = sign * lengths[k] / 2 * body.frame.x - lengths[k] / 9 * body.frame.y
        return body.masscenter.locatenew(name, arm)

    ground, last = end(first, 0, -1), end(third, 2, 1)
    lam = system.constraint_forces
    closing = [(last, lam["lambda0"] * frame.x + lam["lambda1"] * frame.y)]
    root = system.reaction([first, second, third], ground, loads=closing)
    elbow = system.reaction([second, third], end(second, 1, -1), loads=closing)
    tip = system.reaction("bar2", end(third, 2, -1), loads=closing)
    back = system.reaction(
        second, end(second, 1, -1), loads=[(end(second, 1, 1), -tip.force)], frame=frame
    )
    outputs = {}
    for name, item in {"root": root, "elbow": elbow, "tip": tip, "back": back}.items():
        outputs |= item.outputs(name)
    system.outputs = outputs
    system.constants.update(dict(zip(lengths, (0.8, 2.1, 1.9, 2.4), strict=True)))
    system.initial_conditions = {
        **dict(zip(system.coordinates, (0.7, 0.3, -1.4), strict=True)),
        system.speeds[0]: 0.9,
    }
    system.set_dependent_initial_conditions()
    values = system.evaluate_outputs()[:24].reshape(4, 6)
    close(values[:, 5], np.zeros(4), 1e-9)  # no pin holds a torque about its axis
    close(values[3, :3], values[1, :3], 1e-9)


def test_a_string_pulls_as_the_pendulums_closed_form_says():
    x, y, u, v = me.dynamicsymbols("x y u v")
    m, g, length = sm.symbols("m g l")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    bob = origin.locatenew("P", x * frame.x + y * frame.y)
    kane = me.KanesMethod(
        frame,
        [x],
        [u],
        kd_eqs=[x.diff(T) - u, y.diff(T) - v],
        q_dependent=[y],
        u_dependent=[v],
        configuration_constraints=[sm.sqrt(x**2 + y**2) - length],
        velocity_constraints=[(x * u + y * v) / sm.sqrt(x**2 + y**2)],
        bodies=[me.Particle("bob", bob, m)],
        forcelist=[(bob, -m * g * frame.y)],
    )
    system = System(kane, {m: 1.3, g: 9.7, length: 0.8})
    string = system.reaction("bob", bob)
    tension = sm.Symbol("tension")
    system.outputs = {tension: -system.constraint_forces["lambda0"], **string.outputs("string")}
    angle, rate = 0.6, 1.7
    s, c = np.sin(angle), np.cos(angle)
    state = [0.8 * s, -0.8 * c, 0.8 * rate * c, 0.8 * rate * s]
    values = system.evaluate_outputs(state)[:7]
    expected = 1.3 * 9.7 * c + 1.3 * 0.8 * rate**2
    close(values, [expected, -expected * s, expected * c, 0, 0, 0, 0], 1e-12)


def test_noncontributing_forces_in_the_loads_are_what_is_computed():
    model = zoo.skate()
    system = system_of(model)
    system.outputs = dict(system.constraint_forces)
    assert system.outputs_symbols[0] not in system.specifieds_symbols
    assert system.specifieds_symbols == System(model.kane).specifieds_symbols
    assert np.isfinite(system.evaluate_outputs(wide(system, model.x0))).all()
