"""Multipliers and reactions against SymPy's free equations, and Newton's and Euler's laws."""

import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from oracles.newton import motion, needed
from oracles.oracle import Oracle
from pydy._mechanics.cuts import Motions
from pydy._mechanics.reader import check_bodies
from pydy.mechanics import Definition
from pydy.system import System
from zoo import T, by_hand, inertial_frame
from zoo.by_hand import MECHANISMS, derived, state
from zoo.cases import close, wide


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
            kane.bodies, [load for load in kane.loads or () if load[1] != 0] or None
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
    model = by_hand.branches.__wrapped__()  # kanes_equations() takes its actuators apart
    bodies = model.kane.bodies[2:]
    above = model.kane.bodies[0]
    hinge = above.masscenter.locatenew(
        "H", sm.Symbol("l1") / 2 * above.frame.x - sm.Symbol("l1") / 7 * above.frame.z
    )
    loads = [*model.kane.loads[2:5]]
    loads += [load for load in model.kane.loads[5].to_loads() if load.point.name == "E4"]
    return model, bodies, hinge, loads


def plate():
    model = by_hand.tilted_plates()
    second = model.kane.bodies[1]
    c, d = sm.symbols("c d")
    hinge = second.masscenter.locatenew("H2", -d * second.frame.y - c * second.frame.z)
    return model, [second], hinge, model.kane.loads[1:]


def cart():
    model = zoo.free_pendulum()
    bodies = model.kane.bodies
    return model, bodies[2:], bodies[1].masscenter, model.kane.loads[2:]


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
    model = derived(by_hand.coupler())
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
    frame, origin = inertial_frame()
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


def test_a_load_on_what_hangs_on_a_carriage_of_nanometres_is_counted():
    """Beside a coordinate of size one, on a rail so bent, the arms would be lost in rounding."""
    s, a, v, w = me.dynamicsymbols("s a v w")
    frame, origin, unit = me.ReferenceFrame("N"), me.Point("O"), 1e-9
    origin.set_vel(frame, 0)
    turned = frame.orientnew("B", "Axis", (a, frame.z))
    level = frame.orientnew("A", "Axis", (0, frame.z))
    cart = origin.locatenew("cart", s * frame.x + 0.46 / unit * s**2 * frame.y)
    hook = cart.locatenew("hook", 0.8 * unit * level.y)
    centre, end = (hook.locatenew(n, at * unit * turned.x) for n, at in (("c", 0.3), ("e", 0.7)))
    bodies = [
        me.RigidBody("cart", cart, level, 1, (me.inertia(level, 1, 1, 1), cart)),
        me.RigidBody("plate", centre, turned, 1, (me.inertia(turned, 1, 1, unit**2), centre)),
    ]
    definition = Definition(
        frame, [s, a], [v, w], bodies=bodies, loads=[(end, 5 * frame.x)],
        kinematic_equations=[s.diff(T) - v, a.diff(T) - w],
    )  # fmt: skip
    system = System(definition)
    held = system.reaction(bodies[1], hook).outputs("pin")
    system.outputs = held | {"forward": v.diff(T), "turn": w.diff(T)}
    found = system.evaluate_outputs(np.zeros(4), 0.0)
    close(found[:2], [found[6] - 5, 0.3 * unit * found[7]], 1e-14)


def test_noncontributing_forces_in_the_loads_are_what_is_computed():
    model = zoo.skate()
    system = system_of(model)
    system.outputs = dict(system.constraint_forces)
    assert system.outputs_symbols[0] not in system.specifieds_symbols
    assert system.specifieds_symbols == System(model.kane).specifieds_symbols
    assert np.isfinite(system.evaluate_outputs(wide(system, model.x0))).all()


def bead(held):
    """A bead on a level wire, lifted by a given push; the wire's force has an auxiliary speed."""
    x, y, u, v, lift, push, force = me.dynamicsymbols("x y u v lift push force")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x + (y * frame.y if held else 0))
    place.set_vel(frame, u * frame.x + ((v if held else 0) + lift) * frame.y)
    more = {"u_dependent": [v], "velocity_constraints": [v]} if held else {}
    rates = [x.diff(T) - u, y.diff(T) - v][: 1 + held]
    kane = me.KanesMethod(
        frame, [x, y][: 1 + held], [u], rates, u_auxiliary=[lift], **more,
        bodies=[me.Particle("bead", place, 3)],
        forcelist=[(place, (push + force - 30) * frame.y)],
    )  # fmt: skip
    return System(kane), place, push, force


@pytest.mark.parametrize("held", [False, True])
def test_a_push_without_a_part_in_the_motion_is_a_load_all_the_same(held):
    system, place, push, force = bead(held)
    system.noncontributing_forces = [force]
    wanted = dict(system.constraint_forces) | system.reaction("bead", place).outputs("wire")
    system.outputs = wanted
    system.specifieds = {push: 12.0}
    values = dict(zip(map(str, system.outputs_symbols), system.evaluate_outputs(), strict=True))
    assert values["wire_Fy"] == 18.0
    assert values.get("lambda0", 18.0) == 18.0
    assert force not in system.specifieds_symbols


def test_a_force_that_nobody_named_is_a_load():
    system, place, push, force = bead(held=True)
    system.outputs = system.reaction("bead", place).outputs("wire")
    system.specifieds = {push: 12.0, force: 1.0}
    assert system.evaluate_outputs()[1] == 17.0


DECIMALS = [
    ((1.09, -1.24), (0.07, -0.47)),
    ((1.09e-9, -1.24e-9), (0.07e-9, -0.47e-9)),
    ((1.3e9, -0.7e9), (0.1e9, 0.6e9)),
]


@pytest.mark.parametrize(("place", "offset"), DECIMALS)
def test_a_load_at_decimal_offsets_is_counted(place, offset):
    q, u = me.dynamicsymbols("q u")
    frame, origin = inertial_frame()
    turned = frame.orientnew("B", "Axis", (q, frame.z))
    centre = origin.locatenew("C", place[0] * turned.x + place[1] * turned.y)
    point = centre.locatenew("a", offset[0] * turned.x + offset[1] * turned.y)
    body = me.RigidBody("plate", centre, turned, 1, (me.inertia(turned, 1, 1, 1), centre))
    load = (point, 5 * frame.z)
    system = System(
        Definition(
            frame, [q], [u], bodies=[body], loads=[load], kinematic_equations=[q.diff(T) - u]
        )
    )
    system.outputs = system.reaction(body, origin).outputs("pin")
    angle = 0.3
    arm = np.add(place, offset) @ [[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]]
    expected = [0.0, 0.0, -5.0, -5.0 * arm[1], 5.0 * arm[0], 0.0]
    found = system.evaluate_outputs([angle, 0.0], 0.0)
    assert np.allclose(found, expected, rtol=1e-12, atol=1e-15 * max(map(abs, place)))


def two_carriages():
    """Two carriages on one rail, the first with a motor to the ground and a spring to a wall."""
    x, y, a, v, w, s = me.dynamicsymbols("x y a v w s")
    frame, origin = inertial_frame()
    bodies = []
    for name, place in (("first", x), ("second", y)):
        centre = origin.locatenew(f"{name} centre", place * frame.x)
        own = frame.orientnew(f"{name} frame", "Axis", (0, frame.z))
        bodies.append(me.RigidBody(name, centre, own, 2, (me.inertia(own, 1, 1, 1), centre)))
    wheel = frame.orientnew("A", "Axis", (a, frame.z))
    hub = origin.locatenew("hub", 3 * frame.y)
    tip = hub.locatenew("tip", -0.3 * wheel.x)
    bodies.append(me.RigidBody("wheel", hub, wheel, 1, (me.inertia(wheel, 1, 1, 1), hub)))
    mount = bodies[0].frame.orientnew("mount", "Axis", (0.3, frame.z))
    wall = origin.locatenew("wall", 0.4 * frame.x + 3.1 * frame.y)
    loads = [
        *me.TorqueActuator(5, frame.z, wheel, frame).to_loads(),
        (mount, 7 * frame.x),
        (wall, 11 * frame.x),
        (tip, -11 * frame.z),
        (bodies[0].masscenter, 13 * frame.y),
    ]
    speeds = [v, w, s]
    kinematics = [q.diff(T) - u for q, u in zip((x, y, a), speeds, strict=True)]
    model = Definition(
        frame, [x, y, a], speeds, bodies=bodies, loads=loads, kinematic_equations=kinematics
    )
    return System(model), bodies, frame


CARRIED = {  # minus the loads on each, about its mass centre, at rest and in the place of angle 0
    "first": [0.0, -13.0, 0.0, -7.0, 0.0, 0.0],
    "second": [0.0] * 6,
    "wheel": [0.0, 0.0, 11.0, 0.0, 11.0 * 0.3, 0.0],
}


@pytest.mark.parametrize("name", CARRIED)
def test_loads_on_the_ground_and_on_other_carriages_are_not_counted(name):
    system, bodies, _ = two_carriages()
    body = next(b for b in bodies if b.name == name)
    system.outputs = system.reaction(body, body.masscenter).outputs("held")
    close(system.evaluate_outputs(np.zeros(6), 0.0), CARRIED[name], 1e-14)


def test_a_load_on_the_ground_is_counted_where_the_ground_is_listed():
    system, bodies, frame = two_carriages()
    system.outputs = system.reaction([bodies[1], frame], bodies[1].masscenter).outputs("held")
    # The motor's torque, and the force on the wall, 3.1 above.
    close(system.evaluate_outputs(np.zeros(6), 0.0)[5], 5.0 + 11.0 * 3.1, 1e-14)


def test_a_load_on_the_ground_is_none_of_a_body_that_is_welded_to_it():
    # A motor's torque on the ground and a force at a point of it ask for its frame twice.
    q, u = me.dynamicsymbols("q u")
    frame, origin = inertial_frame()
    wheel = frame.orientnew("A", "Axis", (q, frame.z))
    post = frame.orientnew("B", "Axis", (0, frame.z))
    hub, foot = origin.locatenew("hub", 3 * frame.y), origin.locatenew("foot", 0 * frame.x)
    wall = origin.locatenew("wall", frame.x - frame.z)
    bodies = [
        me.RigidBody("wheel", hub, wheel, 1, (me.inertia(wheel, 1, 1, 1), hub)),
        me.RigidBody("post", foot, post, 2, (me.inertia(post, 1, 1, 1), foot)),
    ]
    loads = [*me.TorqueActuator(5, frame.z, wheel, frame).to_loads(), (wall, 11 * frame.x)]
    system = System(Definition(frame, [q], [u], bodies=bodies, loads=loads))
    system.outputs = system.reaction(bodies[1], foot).outputs("held")
    close(system.evaluate_outputs(np.zeros(2), 0.0), [0.0] * 6, 1e-14)


def test_loads_on_a_body_that_stands_still_are_its_own():
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    q, u = me.dynamicsymbols("q u")
    origin.set_vel(frame, 0)
    beam = frame.orientnew("B", "Axis", (0, frame.z))
    middle, tip = (origin.locatenew(n, s * beam.x) for n, s in (("middle", 0.35), ("tip", 0.7)))
    for point in (middle, tip):
        point.set_vel(frame, 0)
    bob = me.Particle("bob", origin.locatenew("P", q * frame.y), 1)
    bodies = [me.RigidBody("beam", middle, beam, 1, (me.inertia(beam, 1, 1, 1), middle)), bob]
    loads = [(tip, -10 * frame.y)]
    system = System(
        Definition(frame, [q], [u], bodies=bodies, loads=loads, kinematic_equations=[q.diff(T) - u])
    )
    system.outputs = system.reaction("beam", origin).outputs("clamp")
    close(system.evaluate_outputs(np.zeros(2), 0.0), [0.0, 10.0, 0.0, 0.0, 0.0, 7.0], 1e-14)


def test_an_inertia_written_in_decimals_is_symmetric_up_to_rounding():
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    m = sm.Symbol("m")
    for size in (1e-20, 1, 1e20, m):
        skew = size * (0.1 * 3 - 0.3) * (frame.x | frame.y)
        inertia = me.inertia(frame, size, size, size, 0.3 * size) + skew
        check_bodies([me.RigidBody("b", origin, frame, 1, (inertia, origin))])
    lost = me.inertia(frame, 1, 1, 1) + 1e-9 * (frame.x | frame.y)
    with pytest.raises(ValueError, match="The inertia of the body b is not symmetric"):
        check_bodies([me.RigidBody("b", origin, frame, 1, (lost, origin))])


def test_a_load_on_a_body_turned_by_a_quaternion_is_counted():
    """Without a constraint of its length: the matrix is a rotation only where it is one."""
    e, w = me.dynamicsymbols("e0:4"), me.dynamicsymbols("w1:4")
    n, b, o = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    o.set_vel(n, 0)
    b.orient_quaternion(n, e)
    b.set_ang_vel(n, sum((u * axis for u, axis in zip(w, b, strict=True)), me.Vector(0)))
    c, tip = (o.locatenew(name, y * b.y - 1.1 * b.x) for name, y in (("C", 0), ("tip", 0.3)))
    q1, q2, q3 = e[1:]
    q_dot = sm.Matrix([[-q1, -q2, -q3], [e[0], -q3, q2], [q3, e[0], -q1], [-q2, q1, e[0]]])
    rates = dict(zip(sm.Matrix(e).diff(T), q_dot * sm.Matrix(w) / 2, strict=True))
    c.set_vel(n, c.pos_from(o).express(n).dt(n).subs(rates))
    tip.v2pt_theory(o, n, b)
    body = me.RigidBody("body", c, b, 2, (me.inertia(b, 1, 2, 3), c))
    system = System(
        Definition(
            n,
            e,
            w,
            bodies=[body],
            loads=[(tip, 5.0 * n.y)],
            kinematic_equations=[rate - value for rate, value in rates.items()],
        )
    )
    system.outputs = system.reaction(body, o, loads=[]).outputs("pin")
    found = system.evaluate_outputs([0.5, 0.5, -0.5, 0.5, 0.0, 0.0, 0.0], 0.0)
    rate = system.evaluate_ode([0.5, 0.5, -0.5, 0.5, 0.0, 0.0, 0.0], 0.0)[4:]
    turn = np.array(b.dcm(n).T.subs(dict(zip(e, (0.5, 0.5, -0.5, 0.5), strict=True))), float)
    expected = 2.0 * np.cross(turn @ rate, turn @ [-1.1, 0.0, 0.0]) - [0.0, 5.0, 0.0]
    np.testing.assert_allclose(found[:3], expected, atol=1e-13)


def test_a_torque_on_a_massless_link_of_particles_is_warned_of_if_it_does_not_count():
    # A motor of 7 N m between two bars without mass. It is a load of both: the pin holds no torque.
    angles, rates = me.dynamicsymbols("a b"), me.dynamicsymbols("u v")
    frame, origin = inertial_frame()
    bars, pins, bobs = [frame], [origin], []
    for name, angle, rate in zip("AB", angles, rates, strict=True):
        bars.append(bars[-1].orientnew(name, "Axis", (angle, frame.z)))
        bars[-1].set_ang_vel(bars[-2], rate * frame.z)
        pins.append(pins[-1].locatenew(f"P{name}", 0.5 * bars[-1].x))
        bobs.append(me.Particle(f"bob{name}", pins[-1], 2))
    first, second = bars[1:]
    loads = [(pin, -20 * frame.y) for pin in pins[1:]]
    motor = [(first, -7 * frame.z), (second, 7 * frame.z)]
    system = System(Definition(frame, angles, rates, bodies=bobs, loads=[*loads, *motor]))
    with pytest.warns(UserWarning, match="not count the torque on the frame B, .* Add B to `bod"):
        system.reaction(bobs[1], pins[1])
    pin = system.reaction([bobs[1], second], pins[1])  # a warning is an error, from here on
    assert system.reaction([bobs[1]], pins[1], loads=motor[1:]).torque != 0
    system.outputs = {**pin.outputs("pin"), **system.reaction(bobs, origin).outputs("ground")}
    values = system.evaluate_outputs([0.3, 0.5, 1.0, 0.0]).reshape(2, 6)
    close(values[:, 5], np.zeros(2), 1e-12)  # on both bobs, the two torques cancel
    system.reaction(bobs[0], pins[1], loads=[])  # a bob alone, without the bar that ends there
    system.reaction(bobs[1], pins[2])


def test_a_load_belongs_to_the_nearest_of_two_bodies_welded_together():
    x, u = me.dynamicsymbols("x u")
    frame, origin = inertial_frame()
    base = origin.locatenew("base", x * frame.x)
    top = base.locatenew("top", 0.3 * frame.y)
    spot = top.locatenew("spot", 0.2 * frame.x)
    for point in (base, top, spot):
        point.set_vel(frame, u * frame.x)
    bodies = [
        me.RigidBody(p.name, p, frame, m, (me.inertia(frame, 1, 1, 1), p))
        for p, m in ((base, 2), (top, 3))
    ]
    definition = Definition(
        frame,
        [x],
        [u],
        bodies=bodies,
        loads=[(spot, 10 * frame.x)],
        kinematic_equations=[x.diff(T) - u],
    )
    system = System(definition)
    for body, force in zip(bodies, (4.0, -4.0), strict=True):
        system.outputs = system.reaction(body, base).outputs("weld")
        found = system.evaluate_outputs([0.0, 0.0], 0.0)
        np.testing.assert_allclose(found[:3], [force, 0.0, 0.0], atol=1e-14)


def test_a_load_beside_a_particle_on_the_ground_is_none_of_a_beams_there():
    """Both stand still: that the point was located from the particle tells whose load it is."""
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    q, u = me.dynamicsymbols("q u")
    origin.set_vel(frame, 0)
    beam = frame.orientnew("B", "Axis", (0, frame.z))
    middle = origin.locatenew("middle", 0.35 * beam.x)
    peg = origin.locatenew("peg", 0.2 * frame.y)
    tip = peg.locatenew("tip", 0.7 * frame.x)
    for point in (middle, peg, tip):
        point.set_vel(frame, 0)
    bodies = [
        me.RigidBody("beam", middle, beam, 1, (me.inertia(beam, 1, 1, 1), middle)),
        me.Particle("peg", peg, 1),
        me.Particle("bob", origin.locatenew("P", q * frame.y), 1),
    ]
    loads = [(tip, -10 * frame.y)]
    system = System(
        Definition(frame, [q], [u], bodies=bodies, loads=loads, kinematic_equations=[q.diff(T) - u])
    )
    for members, force in ((["beam"], 0.0), (["beam", "peg", tip], 10.0)):
        system.outputs = system.reaction(members, origin).outputs("clamp")
        close(system.evaluate_outputs(np.zeros(2), 0.0)[1], force, 1e-14)


def open_four_bar():
    """A four-bar linkage cut at the pin between coupler and rocker, which constraints close."""
    angles, rates = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    frame, origin = inertial_frame()
    bars = [me.ReferenceFrame(f"B{k}") for k in range(3)]
    for bar, angle in zip(bars, angles, strict=True):
        bar.orient_axis(frame, angle, frame.z)
    far = origin.locatenew("D", 0.6 * frame.x)
    crank_pin = origin.locatenew("A", 0.2 * bars[0].x)
    ends = [crank_pin.locatenew("B", 0.6 * bars[1].x), far.locatenew("B2", 0.5 * bars[2].x)]
    centres = [
        start.locatenew(f"G{k}", length / 2 * bars[k].x)
        for k, (start, length) in enumerate([(origin, 0.2), (crank_pin, 0.6), (far, 0.5)])
    ]
    masses = (0.4, 1.2, 1.0)
    inertias = (0.4 * 0.04 / 12, 1.2 * 0.36 / 12, 0.25 / 12)
    bodies = [
        me.RigidBody(f"bar{k}", centre, bar, mass, (me.inertia(bar, 0, 0, about), centre))
        for k, (centre, bar, mass, about) in enumerate(
            zip(centres, bars, masses, inertias, strict=True)
        )
    ]
    gap = ends[0].pos_from(ends[1])
    definition = Definition(
        frame,
        angles,
        rates,
        bodies=bodies,
        loads=[(centre, -9.81 * m * frame.y) for centre, m in zip(centres, masses, strict=True)],
        holonomic_constraints=[gap.dot(frame.x), gap.dot(frame.y)],
    )
    system = System(definition, initial_conditions={"q1": 1.0, "u1": 6.0, "q2": 0.5, "q3": 1.8})
    system.set_dependent_initial_conditions(dep_vars=["q2", "q3", "u2", "u3"])
    return system, bodies, (origin, crank_pin, far), ends[0]


def test_a_loop_that_is_left_out_is_warned_of():
    system, bodies, (origin, crank_pin, far), pin = open_four_bar()
    frame, lam = system.eom_method.frame, system.constraint_forces
    closing = [(pin, lam["lambda0"] * frame.x + lam["lambda1"] * frame.y)]
    for members, point in (([bodies[1]], crank_pin), ([bodies[2]], far)):
        with pytest.warns(
            UserWarning, match=r"constraint of lambda0 and of 1 more, not at .* alone"
        ):
            system.reaction(members, point)
    with pytest.warns(UserWarning, match="held by the constraint of lambda1, not at"):
        system.reaction(bodies[1], crank_pin, loads=[(pin, lam["lambda0"] * frame.x)])
    for members in (bodies, bodies[0]):  # the far pin, or the crank pin, holds them as well
        with pytest.warns(UserWarning, match=r"joined to others, not at O alone: .* all bodies on"):
            system.reaction(members, origin)
    coupler = system.reaction(bodies[1], crank_pin, loads=closing)
    rest = [(crank_pin, -coupler.force)]
    crank = system.reaction(bodies[0], origin, loads=rest)
    system.outputs = coupler.outputs("A") | crank.outputs("O")
    values = system.evaluate_outputs()[:12].reshape(2, 6)
    close(values[:, 5], np.zeros(2), 1e-12)  # pins hold no torque about their axes
    resultant = system.reaction(bodies[1], crank_pin, loads=[])
    system.outputs = resultant.outputs("A")
    assert abs(system.evaluate_outputs()[5]) > 0.1


def test_a_reaction_elsewhere_does_not_stand_for_a_constraint():
    """One at the pin that the constraints close does."""
    system, bodies, (origin, crank_pin, _), pin = open_four_bar()
    at_pin = system.reaction(bodies[2], pin, loads=[])
    system.reaction(bodies[1], crank_pin, loads=[(pin, -at_pin.force)])  # a warning is an error
    with pytest.warns(UserWarning, match=r"constraint of lambda0 and of 1 more, not at A alone"):
        system.reaction(bodies[1], crank_pin, loads=[(origin, -at_pin.force)])


@pytest.mark.parametrize("is_pinned", [False, True])
def test_a_constraint_of_two_particles_is_their_joint(is_pinned):
    """Bodies of 1 and 3 kg that move as one along x, or everywhere, share a force of 8 N."""
    (x, y, X, Y), speeds = me.dynamicsymbols("x y X Y"), me.dynamicsymbols("u v U V")
    frame, origin = inertial_frame()
    places = [origin.locatenew("P", x * frame.x + y * frame.y)]
    places.append(origin.locatenew("Q", X * frame.x + Y * frame.y))
    p, q = (me.Particle(f"m{m}", at, m) for m, at in zip((1, 3), places, strict=True))
    system = System(
        Definition(
            frame, [x, y, X, Y], speeds, bodies=[p, q], loads=[(places[1], 8 * frame.x)],
            holonomic_constraints=[x - X, y - Y][: 1 + is_pinned],
        )
    )  # fmt: skip
    on_p = system.reaction(p, places[0])  # a warning is an error
    system.outputs = on_p.outputs("p") | {"lambda": system.constraint_forces["lambda0"]}
    values = system.evaluate_outputs()
    close(values[:3], [2.0, 0.0, 0.0], 1e-12)
    close(abs(values[6]), 2.0, 1e-12)


def test_several_reactions_differentiate_the_constraints_once(monkeypatch):
    made = []
    build = Motions.__init__
    monkeypatch.setattr(
        Motions, "__init__", lambda self, *parts: (made.append(parts), build(self, *parts))[1]
    )
    system, bodies, (_, crank_pin, far), pin = open_four_bar()
    lam, frame = system.constraint_forces, system.eom_method.frame
    closing = [(pin, lam["lambda0"] * frame.x + lam["lambda1"] * frame.y)]
    system.reaction(bodies[1], crank_pin, loads=closing)
    system.reaction(bodies[2], far, loads=closing)
    assert len(made) == 1


def test_a_constraint_on_one_side_of_a_cut_is_not_warned_of():
    x, y, angle = me.dynamicsymbols("x y p")
    frame, ground = inertial_frame()
    cart = me.Particle("cart", ground.locatenew("C", x * frame.x), 3.0)
    slider = me.Particle("slider", ground.locatenew("S", y * frame.y), 1.0)
    hook = cart.masscenter.locatenew("H", -frame.y)
    bar = me.ReferenceFrame("P")
    bar.orient_axis(frame, angle, frame.z)
    centre = hook.locatenew("G", -0.3 * bar.y)
    pendulum = me.RigidBody("pendulum", centre, bar, 1.0, (me.inertia(bar, 0, 0, 0.1), centre))
    system = System(
        Definition(
            frame,
            [x, angle, y],
            me.dynamicsymbols("v w z"),
            bodies=[cart, pendulum, slider],
            holonomic_constraints=[x**2 + y**2 - 4.0],  # a rod from the cart to the slider
        )
    )
    system.reaction(pendulum, hook)
    with pytest.warns(UserWarning, match="constraint of lambda0, not at Z alone"):
        system.reaction([cart, pendulum], ground.locatenew("Z", 0.5 * frame.y))
