"""Mechanisms for the tests of equations formed from bodies, each with something of its own.

`kanes_equations()` is not called on any of them: `derived` does that for an oracle.
"""

import warnings

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics.mechanics import LinearPathway, LinearSpring, TorqueActuator
from sympy.physics.mechanics.loads import gravity

from derivations import derived_once
from zoo import Model, T, _numbers, inertial_frame

N_AXES = "xyz"


def derived(model):
    """The same model with SymPy's own equations of motion."""
    kane = model.kane
    if kane._fr is None:
        loads = []
        for load in kane.loads or ():  # SymPy takes no actuators here
            loads += load.to_loads() if hasattr(load, "to_loads") else [load]
        with warnings.catch_warnings():  # SymPy warns of points that hang on several others
            warnings.simplefilter("ignore", UserWarning)
            kane.kanes_equations(kane.bodies, loads or None)
    return model


def state(model, seed=0):
    """One generic state and time; quaternions are of unit length."""
    x, t = model.sample(seed)
    quaternion = [k for k, s in enumerate(model.states) if s.name in ("e0", "e1", "e2", "e3")]
    if quaternion:
        x[quaternion] /= np.linalg.norm(x[quaternion])
    return x, t


def _kane(frame, q, u, bodies, loads, kd=None, **options):
    kd = [a.diff(T) - b for a, b in zip(q, u, strict=True)] if kd is None else kd
    return me.KanesMethod(frame, q, u, kd_eqs=kd, bodies=bodies, forcelist=loads or None, **options)


def _ground():
    frame, origin = inertial_frame()
    return frame, origin, sm.Symbol("g")


@derived_once
def tilted_plates():
    """Two hinged plates: inertias with products, the second referred to its hinge."""
    frame, origin, g = _ground()
    q, u = list(me.dynamicsymbols("q1:3")), list(me.dynamicsymbols("u1:3"))
    m, n, c, d = sm.symbols("m n c d")
    first, second = sm.symbols("A1:7"), sm.symbols("B1:7")
    a, b = me.ReferenceFrame("A"), me.ReferenceFrame("B")
    a.orient_axis(frame, frame.z, q[0])
    b.orient_axis(a, a.x + a.y, q[1])
    a.set_ang_vel(frame, u[0] * frame.z)
    b.set_ang_vel(a, u[1] * (a.x + a.y).normalize())
    hinge = origin.locatenew("H", c * a.x + d * a.z)
    centre_a = origin.locatenew("Ca", c / 3 * a.x - d * a.y)
    centre_b = hinge.locatenew("Cb", d * b.y + c * b.z)
    for p, base, f in ((hinge, origin, a), (centre_a, origin, a), (centre_b, hinge, b)):
        p.v2pt_theory(base, frame, f)
    bodies = [
        me.RigidBody("a", centre_a, a, m, (me.inertia(a, *first), centre_a)),
        me.RigidBody("b", centre_b, b, n, (me.inertia(b, *second), hinge)),
    ]
    loads = [(centre_a, -m * g * frame.x), (centre_b, -n * g * frame.x)]
    numbers = dict(zip(first, [2.1, 1.9, 2.5, 0.2, -0.3, 0.1], strict=True))
    numbers |= dict(zip(second, [9.3, 9.1, 8.7, -0.2, 0.15, 0.3], strict=True))
    return Model(_kane(frame, q, u, bodies, loads), numbers | _numbers(m, n, c, d, g))


@derived_once
def slider_on_a_turntable():
    """A particle that slides along an arm that turns on a disc that turns as prescribed."""
    frame, origin, g = _ground()
    q, s, uq, us, spin = me.dynamicsymbols("q s uq us Omega")
    m, n, c, k = sm.symbols("m n c k")
    disc, arm = me.ReferenceFrame("D"), me.ReferenceFrame("A")
    disc.orient_axis(frame, frame.z, spin)
    arm.orient_axis(disc, disc.y, q)
    tip = origin.locatenew("P", (c + s) * arm.x + s**2 / 5 * arm.z)
    fixed = origin.locatenew("Q", c * arm.x)
    bodies = [me.Particle("p", tip, m), me.Particle("q", fixed, n)]
    loads = [(tip, -m * g * frame.z - k * s * arm.x), (fixed, -n * g * frame.z)]
    kane = _kane(frame, [q, s], [uq, us], bodies, loads)
    numbers = {spin: 0.31, spin.diff(T): -0.42, spin.diff(T, 2): 0.57}
    return Model(kane, _numbers(m, n, c, k, g), numbers)


@derived_once
def satellite():
    """A floating base with a quaternion, and an arm; nothing is said of the arm's velocity."""
    frame, origin, g = _ground()
    e, w = list(me.dynamicsymbols("e0:4")), list(me.dynamicsymbols("w1:4"))
    x, v = list(me.dynamicsymbols("x1:4")), list(me.dynamicsymbols("v1:4"))
    q, u = me.dynamicsymbols("q u")
    m, n, c = sm.symbols("m n c")
    inertias, own = sm.symbols("A B C"), sm.symbols("D E F")
    base, arm = me.ReferenceFrame("B"), me.ReferenceFrame("A")
    base.orient_quaternion(frame, e)
    base.set_ang_vel(frame, w[0] * base.x + w[1] * base.y + w[2] * base.z)
    arm.orient_axis(base, base.y, q)
    centre = origin.locatenew("C", x[0] * frame.x + x[1] * frame.y + x[2] * frame.z)
    centre.set_vel(frame, v[0] * base.x + v[1] * base.y + v[2] * base.z)
    tip = centre.locatenew("T", c * base.x + c / 2 * arm.z)
    half = sm.Rational(1, 2)
    rates = [
        -half * (e[1] * w[0] + e[2] * w[1] + e[3] * w[2]),
        half * (e[0] * w[0] + e[2] * w[2] - e[3] * w[1]),
        half * (e[0] * w[1] + e[3] * w[0] - e[1] * w[2]),
        half * (e[0] * w[2] + e[1] * w[1] - e[2] * w[0]),
    ]
    along = [sum((a * b for a, b in zip(v, base, strict=True)), 0 * base.x).dot(d) for d in frame]
    kd = [a.diff(T) - b for a, b in zip([*e, *x, q], [*rates, *along, u], strict=True)]
    bodies = [
        me.RigidBody("base", centre, base, m, (me.inertia(base, *inertias), centre)),
        me.RigidBody("arm", tip, arm, n, (me.inertia(arm, *own), tip)),
    ]
    loads = [(centre, -m * g * frame.z), (tip, -n * g * frame.z)]
    kane = me.KanesMethod(
        frame,
        [*e[1:], *x, q],
        [*w, *v, u],
        kd_eqs=[*kd[1:], kd[0]],
        q_dependent=e[:1],
        configuration_constraints=[sum(i**2 for i in e) - 1],
        bodies=bodies,
        forcelist=loads,
    )
    values = _numbers(m, n, c, g, *inertias, *own)
    return Model(kane, values, start={e[0]: 1.0}, quaternion=tuple(e))


@derived_once
def camera():
    """Frames set up by an explicit matrix, by space-fixed angles, and a fixed misalignment."""
    frame, origin, g = _ground()
    q, u = list(me.dynamicsymbols("q1:5")), list(me.dynamicsymbols("u1:5"))
    m, c, tilt = sm.symbols("m c tilt")
    inertias = sm.symbols("A B C")
    mount, head, eye = (me.ReferenceFrame(name) for name in "MHE")
    turn = sm.Matrix([[sm.cos(q[0]), -sm.sin(q[0]), 0], [sm.sin(q[0]), sm.cos(q[0]), 0], [0, 0, 1]])
    mount.orient_explicit(frame, turn)
    head.orient_space_fixed(mount, q[1:4], "123")
    eye.orient_axis(head, head.y, tilt)
    centre = origin.locatenew("C", c * mount.x + c / 2 * eye.z)
    body = me.RigidBody("camera", centre, eye, m, (me.inertia(eye, *inertias), centre))
    kane = _kane(frame, q, u, [body], [(centre, -m * g * frame.z)])
    return Model(kane, _numbers(m, c, tilt, g, *inertias))


@derived_once
def mixed_speeds():
    """Speeds that are combinations of the rates, with coefficients that depend on the state."""
    frame, origin, g = _ground()
    q, u = list(me.dynamicsymbols("q1:4")), list(me.dynamicsymbols("u1:4"))
    m, n, c, k = sm.symbols("m n c k")
    a, b = me.ReferenceFrame("A"), me.ReferenceFrame("B")
    a.orient_axis(frame, frame.z, q[0])
    b.orient_axis(a, a.x, q[1])
    first = origin.locatenew("P", c * a.x)
    second = first.locatenew("Q", q[2] * b.y)
    kd = [
        u[0] - 2 * q[0].diff(T) - k * q[1].diff(T),
        u[1] - q[1].diff(T) * sm.cos(q[0]) - sm.sin(T) / 3,
        u[2] - q[2].diff(T) - q[1] * q[0].diff(T),
    ]
    bodies = [me.Particle("p", first, m), me.Particle("q", second, n)]
    loads = [(first, -m * g * frame.y), (second, -n * g * frame.y - k * q[2] * b.y)]
    return Model(_kane(frame, q, u, bodies, loads, kd), _numbers(m, n, c, k, g))


@derived_once
def gimbals():
    """A rotor in massless gimbals, with a torque between two of the frames."""
    frame, origin, g = _ground()
    q, u = list(me.dynamicsymbols("q1:4")), list(me.dynamicsymbols("u1:4"))
    torque = me.dynamicsymbols("tau")
    m, c, k, across, along = sm.symbols("m c k across along")
    outer, inner, rotor = (me.ReferenceFrame(name) for name in ("Out", "In", "R"))
    outer.orient_axis(frame, frame.z, q[0])
    inner.orient_axis(outer, outer.x, q[1])
    rotor.orient_axis(inner, inner.z, q[2])
    for f, base, w in ((outer, frame, u[0] * frame.z), (inner, outer, u[1] * outer.x)):
        f.set_ang_vel(base, w)
    rotor.set_ang_vel(inner, u[2] * inner.z)
    centre = origin.locatenew("C", c * inner.z)
    ring = me.RigidBody("ring", origin, outer, 0, (me.inertia(outer, 0, 0, 0), origin))
    wheel = me.RigidBody(
        "rotor", centre, rotor, m, (me.inertia(rotor, across, across, along), centre)
    )
    loads = [
        (centre, -m * g * frame.z),
        me.Torque(inner, torque * outer.x),
        (outer, -torque * outer.x - k * u[0] * frame.z),
    ]
    kane = _kane(frame, q, u, [ring, wheel], loads)
    return Model(kane, _numbers(m, c, k, across, along, g), {torque: 0.43})


@derived_once
def branches():
    """A trunk with two branches, one of which forks; a slide, and springs between bodies."""
    frame, origin, g = _ground()
    q, u = list(me.dynamicsymbols("q1:6")), list(me.dynamicsymbols("u1:6"))
    masses, lengths = sm.symbols("m1:6"), sm.symbols("l1:6")
    inertias = [sm.symbols(f"A{k} B{k} C{k}") for k in range(5)]
    stiff, damp, rest = sm.symbols("k c r")
    parents, axes = (None, 0, 0, 2, 2), "zxyxz"
    frames, ends, bodies, loads = [], [], [], []
    for k, parent in enumerate(parents):
        base = frame if parent is None else frames[parent]
        start = origin if parent is None else ends[parent]
        own = me.ReferenceFrame(f"B{k}")
        own.orient_axis(base, getattr(base, axes[k]), q[k] if k != 3 else rest)
        slide = q[k] * base.y if k == 3 else 0 * base.y
        centre = start.locatenew(f"C{k}", slide + lengths[k] / 2 * own.x + lengths[k] / 7 * own.z)
        end = start.locatenew(f"E{k}", slide + lengths[k] * own.x)
        frames.append(own)
        ends.append(end)
        body = me.RigidBody(
            f"b{k}", centre, own, masses[k], (me.inertia(own, *inertias[k]), centre)
        )
        bodies.append(body)
    loads = [
        *gravity(-g * frame.y, *bodies),
        LinearSpring(stiff, LinearPathway(ends[1], ends[4]), rest),
        TorqueActuator(-damp * u[1], frames[0].x, frames[1], frames[0]),
    ]
    numbers = _numbers(*masses, *lengths, *(i for part in inertias for i in part))
    return Model(
        _kane(frame, q, u, bodies, loads), numbers | {stiff: 3.1, damp: 0.4, rest: 0.6, g: 9.3}
    )


@derived_once
def burning_rocket():
    """A mass and an inertia that change as prescribed, loads that depend on everything."""
    frame, origin, g = _ground()
    x, q, vx, w = me.dynamicsymbols("x q vx w")
    mass, thrust = me.dynamicsymbols("mu thrust")
    k, c = sm.symbols("k c")
    hull = me.ReferenceFrame("H")
    hull.orient_axis(frame, frame.z, q)
    hull.set_ang_vel(frame, w * frame.z)
    centre = origin.locatenew("C", x * frame.x + c * hull.y)
    centre.set_vel(frame, vx * frame.x + (w * hull.z).cross(c * hull.y))
    inertia = me.inertia(hull, 0, 0, k * mass + sm.exp(-T))
    body = me.RigidBody("hull", centre, hull, mass, (inertia, centre))
    loads = [
        (centre, thrust * (1 + sm.sin(T)) * hull.x - mass * g * frame.x - k * vx * frame.x * x),
        (hull, -k * w * sm.Abs(w) * hull.z),
    ]
    kane = _kane(frame, [x, q], [vx, w], [body], loads)
    return Model(kane, _numbers(k, c, g), {mass: 2.3, mass.diff(T): -0.31, thrust: 1.7})


@derived_once
def own_velocities():
    """Velocities and accelerations that the user wrote, in forms of the user's own."""
    frame, origin, g = _ground()
    q, u = list(me.dynamicsymbols("q1:3")), list(me.dynamicsymbols("u1:3"))
    m, n, c, d = sm.symbols("m n c d")
    a, b = me.ReferenceFrame("A"), me.ReferenceFrame("B")
    a.orient_axis(frame, frame.z, q[0])
    b.orient_axis(a, a.z, q[1])
    b.set_ang_vel(frame, (u[0] + u[1]) * frame.z)
    b.set_ang_acc(frame, (u[0].diff(T) + u[1].diff(T)) * frame.z)
    first, second = me.Point("P"), me.Point("Q")
    first.set_pos(origin, c * a.x)
    second.set_pos(first, d * b.x)
    whole = q[0] + q[1]
    # The angles' sum: equal to the structural velocity, which values modulo a prime do not see.
    first.set_vel(frame, c * u[0] * (-sm.sin(q[0]) * frame.x + sm.cos(q[0]) * frame.y))
    second.set_vel(
        frame,
        first.vel(frame) + d * (u[0] + u[1]) * (-sm.sin(whole) * frame.x + sm.cos(whole) * frame.y),
    )
    first.set_acc(frame, c * q[0].diff(T, 2) * a.y - c * u[0] ** 2 * a.x)
    bodies = [me.Particle("p", first, m), me.Particle("q", second, n)]
    loads = [(first, -m * g * frame.y), (second, -n * g * frame.y)]
    return Model(_kane(frame, q, u, bodies, loads), _numbers(m, n, c, d, g))


@derived_once
def coupler():
    """A four-bar linkage of rigid bodies whose velocities are nowhere written."""
    frame, origin, g = _ground()
    q, u = list(me.dynamicsymbols("q1:4")), list(me.dynamicsymbols("u1:4"))
    lengths, masses = sm.symbols("l1:5"), sm.symbols("m1:4")
    inertias = sm.symbols("I1:4")
    point, above, bodies, loads = origin, frame, [], []
    for k in range(3):
        bar = me.ReferenceFrame(f"B{k}")
        bar.orient_axis(above, above.z, q[k])
        bar.set_ang_vel(above, u[k] * above.z)
        centre = point.locatenew(f"C{k}", lengths[k] / 2 * bar.x + lengths[k] / 9 * bar.y)
        point, above = point.locatenew(f"E{k}", lengths[k] * bar.x), bar
        own = me.inertia(bar, 0, 0, inertias[k])
        bodies.append(me.RigidBody(f"bar{k}", centre, bar, masses[k], (own, centre)))
        loads.append((centre, -masses[k] * g * frame.y))
    loop = point.pos_from(origin) - lengths[3] * frame.x
    closure = [loop.dot(frame.x), loop.dot(frame.y)]
    rates = {a.diff(T): b for a, b in zip(q, u, strict=True)}
    kane = me.KanesMethod(
        frame,
        q[:1],
        u[:1],
        kd_eqs=[a.diff(T) - b for a, b in zip(q, u, strict=True)],
        q_dependent=q[1:],
        configuration_constraints=closure,
        u_dependent=u[1:],
        velocity_constraints=[e.diff(T).xreplace(rates) for e in closure],
        constraint_solver="CRAMER",
        bodies=bodies,
        forcelist=loads,
    )
    return Model(kane, _numbers(*lengths, *masses, *inertias, g))


@derived_once
def wheel():
    """A rolling wheel with its inertia in its own axes, and the contact point said to be at rest.

    The point is the contact's: its velocity is not the derivative of its place.
    """
    frame, _, g = _ground()
    q, u = list(me.dynamicsymbols("q1:4")), list(me.dynamicsymbols("u1:4"))
    m, r, across, along = sm.symbols("m r across along")
    yawed, leaned, disc = (me.ReferenceFrame(name) for name in "YLD")
    yawed.orient_axis(frame, frame.z, q[0])
    leaned.orient_axis(yawed, yawed.x, q[1])
    disc.orient_axis(leaned, leaned.y, q[2])
    spin = u[0] * leaned.x + u[1] * leaned.y + u[2] * leaned.z
    leaned.set_ang_vel(frame, u[0] * leaned.x + u[2] / sm.cos(q[1]) * yawed.z)
    disc.set_ang_vel(frame, spin)
    contact = me.Point("P")
    contact.set_vel(frame, 0)
    centre = contact.locatenew("C", r * leaned.z)
    centre.v2pt_theory(contact, frame, disc)
    kd = [
        q[0].diff(T) - u[2] / sm.cos(q[1]),
        q[1].diff(T) - u[0],
        q[2].diff(T) - u[1] + u[2] * sm.tan(q[1]),
    ]
    own = me.inertia(disc, across, along, across)
    body = me.RigidBody("wheel", centre, disc, m, (own, centre))
    kane = _kane(frame, q, u, [body], [(centre, -m * g * frame.z)], kd)
    return Model(kane, _numbers(m, r, across, along, g))


@derived_once
def given_accelerations():
    """A particle on a line, with an acceleration constraint of the user's own."""
    frame, _, g = _ground()
    x, y, vx, vy = me.dynamicsymbols("x y vx vy")
    m, slope, gain = sm.symbols("m slope gain")
    point = me.Point("P")
    point.set_vel(frame, vx * frame.x + vy * frame.y)
    rate = vy - slope * vx * sm.cos(x)
    kane = me.KanesMethod(
        frame,
        [x, y],
        [vx],
        kd_eqs=[x.diff(T) - vx, y.diff(T) - vy],
        u_dependent=[vy],
        velocity_constraints=[rate],
        # The rate of the above, and what draws the motion back to it.
        acceleration_constraints=[
            vy.diff(T) - slope * (vx.diff(T) * sm.cos(x) - vx**2 * sm.sin(x)) + gain * rate
        ],
        bodies=[me.Particle("p", point, m)],
        forcelist=[(point, -m * g * frame.y)],
    )
    return Model(kane, _numbers(m, slope, gain, g))


@derived_once
def towed_sledge():
    """A sledge that cannot slip, with an added mass that depends on accelerations, as a Force."""
    frame, origin, g = _ground()
    q, u = list(me.dynamicsymbols("x y theta beta")), list(me.dynamicsymbols("v1:5"))
    m, n, size, c, added, k = sm.symbols("m n I c added k")
    hull, boom = me.ReferenceFrame("H"), me.ReferenceFrame("B")
    hull.orient_axis(frame, frame.z, q[2])
    boom.orient_dcm(hull, sm.rot_axis2(q[3]).T)
    edge = origin.locatenew("E", q[0] * frame.x + q[1] * frame.y)
    centre, tip = edge.locatenew("C", c * hull.x), edge.locatenew("T", c / 3 * boom.z - c * boom.x)
    slip = u[1] * sm.cos(q[2]) - u[0] * sm.sin(q[2])
    push = -added * (u[0].diff(T) + c * u[2].diff(T)) * hull.x
    kane = me.KanesMethod(
        frame,
        q,
        [u[0], u[2], u[3]],
        kd_eqs=[a.diff(T) - b for a, b in zip(q, u, strict=True)],
        u_dependent=[u[1]],
        velocity_constraints=[slip],
        bodies=[
            me.RigidBody("hull", centre, hull, m, (me.inertia(hull, 0, 0, size), edge)),
            me.Particle("tip", tip, n),
        ],
        forcelist=[
            me.Force(centre, push),
            me.Torque(hull, -added * u[2].diff(T) * hull.z / 3),
            (tip, -n * g * frame.z - k * sm.sin(q[3]) * boom.x),
        ],
    )
    numbers = _numbers(m, n, c, added, k, g) | {size: 9.7}
    return Model(kane, numbers)


@derived_once
def driven_crane():
    """A load on a rope of prescribed length below a trolley on a rail that moves with time."""
    frame, origin, g = _ground()
    q, u = list(me.dynamicsymbols("s h a b")), list(me.dynamicsymbols("w1:5"))
    reach = me.dynamicsymbols("rope")
    m, n, k = sm.symbols("m n k")
    inertias = sm.symbols("A B C D E F")
    load = me.ReferenceFrame("L")
    load.orient_body_fixed(frame, (q[2], q[3], 0), "xyz")
    trolley = origin.locatenew("W", q[0] * frame.x + q[1] * frame.z)
    hook = trolley.locatenew("K", -reach * load.z)
    centre = hook.locatenew("C", -k * load.z + k / 4 * load.y)
    rail = q[1] - sm.sin(q[0]) / 3 - sm.cos(2 * T) / 5
    rate = u[1] - u[0] * sm.cos(q[0]) / 3 + 2 * sm.sin(2 * T) / 5
    kd = [
        q[0].diff(T) - u[0],
        q[1].diff(T) - u[1],
        u[2] - q[2].diff(T) * sm.cos(q[3]) - k * q[3].diff(T),
        u[3] - q[3].diff(T) + q[2].diff(T) / 7,
    ]
    kane = me.KanesMethod(
        frame,
        [q[0], *q[2:]],
        [u[0], *u[2:]],
        kd_eqs=kd,
        q_dependent=[q[1]],
        configuration_constraints=[rail],
        u_dependent=[u[1]],
        velocity_constraints=[rate],
        bodies=[
            me.Particle("trolley", trolley, m),
            me.RigidBody("load", centre, load, n, (me.inertia(load, *inertias), hook)),
        ],
        forcelist=[(trolley, -m * g * frame.z - k * u[0] * frame.x), (centre, -n * g * frame.z)],
    )
    numbers = dict(zip(inertias, [9.3, 9.1, 8.7, -0.2, 0.15, 0.3], strict=True))
    prescribed = {reach: 1.31, reach.diff(T): -0.42, reach.diff(T, 2): 0.57}
    return Model(kane, numbers | _numbers(m, n, k, g), prescribed)


MECHANISMS = {
    f.__name__: f
    for f in (
        tilted_plates,
        slider_on_a_turntable,
        satellite,
        camera,
        mixed_speeds,
        gimbals,
        branches,
        burning_rocket,
        own_velocities,
        coupler,
        wheel,
        given_accelerations,
        towed_sledge,
        driven_crane,
    )
}
