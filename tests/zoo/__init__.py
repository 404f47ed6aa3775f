"""Sample systems for the tests, each small, each with something of its own that may go wrong.

A model is a function, so that nothing is derived at collection; it is derived once in a session
(`derivations.py`). Numbers are generic (no ones, no zeros, no simple ratios): a mistaken order or a
lost factor shows.

Further ones, by subject: `by_hand` (equations formed from bodies), `joints` (SymPy's), `loops`
(redundant constraints), `singular` (badly scaled or singular ones), `circle`, `hoop`, `rolling`,
`ziegler`, `ball`, `touching` (contacts), `tires`, `pictured` (without shapes), `exported_models`,
`ensemble_cases`, `suspended` (hard points). `cases` makes a System of a model, and `graphs` (beside
this folder) a Program without a mechanical system.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics.mechanics import models as sympy_models

from derivations import derived_once

T = me.dynamicsymbols._t


def inertial_frame():
    """A frame and a point that rests in it."""
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    return frame, origin


@dataclass(frozen=True, eq=False)
class Model:
    """A KanesMethod with numbers for its constants and specifieds, and what is known about it."""

    kane: me.KanesMethod
    constants: dict = field(default_factory=dict)
    specifieds: dict = field(default_factory=dict)
    forces: tuple = ()
    energy: sm.Expr | None = None
    """Total energy in terms of states and constants, when it is conserved."""
    momenta: tuple = ()
    """Further conserved quantities."""
    start: dict = field(default_factory=dict)
    """A consistent initial state, for models with constraints and for the conserved quantities."""
    quaternion: tuple = ()
    """Coordinates that orient a frame at unit length alone."""

    @property
    def states(self):
        return [*self.kane.q, *self.kane.u]

    @property
    def x0(self):
        return np.array([self.start.get(s, 0.0) for s in self.states])

    def sample(self, seed=0, m=None):
        """One generic state and time, or m of them; constraints are not looked at."""
        rng = np.random.default_rng(seed)
        x = rng.uniform(0.2, 0.9, (m or 1, len(self.states)))
        t = np.sort(rng.uniform(0.3, 2.0, m or 1))
        columns = [self.states.index(q) for q in self.quaternion]
        if columns:
            x[:, columns] /= np.linalg.norm(x[:, columns], axis=1, keepdims=True)
        return (x[0], float(t[0])) if m is None else (x, t)


def _numbers(*symbols, start=0.7):
    """Generic positive numbers, each symbol its own."""
    return {s: round(start + 0.37 * i + 0.013 * i**2, 4) for i, s in enumerate(symbols)}


def _kinetic(kane, frame):
    energy = me.kinetic_energy(frame, *kane.bodies)
    return energy.xreplace(kane.kindiffdict())


@derived_once
def chain():
    """Three masses on springs and dampers, with gravity and forces, from SymPy."""
    kane = sympy_models.multi_mass_spring_damper(3, apply_gravity=True, apply_external_forces=True)
    f = me.dynamicsymbols("f:3")
    return Model(kane, _numbers(*sm.symbols("m:3 k:3 c:3 g")), _numbers(*f, start=-0.4))


@derived_once
def undamped_chain():
    """Two masses and springs in absolute coordinates: nothing but energy."""
    x1, x2, v1, v2 = me.dynamicsymbols("x1 x2 v1 v2")
    m1, m2, k1, k2 = sm.symbols("m1 m2 k1 k2", positive=True)
    frame, p1, p2 = me.ReferenceFrame("N"), me.Point("P1"), me.Point("P2")
    p1.set_vel(frame, v1 * frame.x)
    p2.set_vel(frame, v2 * frame.x)
    kane = me.KanesMethod(frame, [x1, x2], [v1, v2], kd_eqs=[x1.diff(T) - v1, x2.diff(T) - v2])
    pull = k2 * (x2 - x1)
    kane.kanes_equations(
        [me.Particle("A", p1, m1), me.Particle("B", p2, m2)],
        [(p1, (pull - k1 * x1) * frame.x), (p2, -pull * frame.x)],
    )
    energy = m1 * v1**2 / 2 + m2 * v2**2 / 2 + k1 * x1**2 / 2 + k2 * (x2 - x1) ** 2 / 2
    start = {x1: 0.3, x2: -0.2, v1: 0.1, v2: 0.8}
    return Model(kane, _numbers(m1, m2, k1, k2), energy=energy, start=start)


@derived_once
def pendulum():
    """Two links on a cart with a force on the cart and torques at the joints, from SymPy."""
    kane = sympy_models.n_link_pendulum_on_cart(2, cart_force=True, joint_torques=True)
    f = me.dynamicsymbols("F T1 T2")
    return Model(kane, _numbers(*sm.symbols("m:3 l:2"), sm.Symbol("g")), _numbers(*f, start=-0.4))


@derived_once
def free_pendulum():
    """Three links on a cart that nothing pushes: energy and horizontal momentum are conserved."""
    kane = sympy_models.n_link_pendulum_on_cart(3, cart_force=False)
    m, g = sm.symbols("m:4"), sm.Symbol("g")
    lengths = sm.symbols("l:3")
    q, u = list(kane.q), list(kane.u)
    height = [sum(lengths[j] * sm.cos(q[j + 1]) for j in range(i)) for i in range(4)]
    vx = [u[0] - sum(lengths[j] * u[j + 1] * sm.cos(q[j + 1]) for j in range(i)) for i in range(4)]
    vy = [-sum(lengths[j] * u[j + 1] * sm.sin(q[j + 1]) for j in range(i)) for i in range(4)]
    energy = sum(m[i] * ((vx[i] ** 2 + vy[i] ** 2) / 2 + g * height[i]) for i in range(4))
    momentum = sum(m[i] * vx[i] for i in range(4))
    start = dict(zip(q + u, [0.1, 2.5, 2.9, 3.3, 0.2, -0.4, 0.3, 0.5], strict=True))
    return Model(kane, _numbers(*m, *lengths, g), energy=energy, momenta=(momentum,), start=start)


@derived_once
def free_body():
    """A rigid body thrown in space: body-fixed angular velocity, full inertia matrix."""
    q = me.dynamicsymbols("q1:7")
    u = me.dynamicsymbols("u1:7")
    m, g = sm.symbols("m g")
    inertias = sm.symbols("Ixx Iyy Izz Ixy Iyz Izx")
    frame, body = me.ReferenceFrame("N"), me.ReferenceFrame("B")
    body.orient_body_fixed(frame, q[3:], "312")
    rate = body.ang_vel_in(frame)
    origin, centre = me.Point("O"), me.Point("C")
    origin.set_vel(frame, 0)
    centre.set_pos(origin, q[0] * frame.x + q[1] * frame.y + q[2] * frame.z)
    kd = [a.diff(T) - b for a, b in zip(q[:3], u[:3], strict=True)]
    kd += [rate.dot(e) - w for e, w in zip(body, u[3:], strict=True)]
    centre.set_vel(frame, u[0] * frame.x + u[1] * frame.y + u[2] * frame.z)
    spin = u[3] * body.x + u[4] * body.y + u[5] * body.z
    body.set_ang_vel(frame, spin)
    rigid = me.RigidBody("R", centre, body, m, (me.inertia(body, *inertias), centre))
    kane = me.KanesMethod(frame, q, u, kd_eqs=kd, kd_eqs_solver="CRAMER")
    kane.kanes_equations([rigid], [(centre, -m * g * frame.z)])
    energy = _kinetic(kane, frame) + m * g * q[2]
    momentum = rigid.central_inertia.dot(spin).to_matrix(frame)
    numbers = dict(zip(inertias, [1.9, 2.3, 3.1, 0.11, -0.13, 0.17], strict=True)) | _numbers(m, g)
    start = dict(
        zip(q + u, [0.1, 0.2, 0.3, 0.4, 0.2, -0.3, 1.0, -0.7, 2.0, 0.9, -1.1, 0.6], strict=True)
    )
    return Model(kane, numbers, energy=energy, momenta=(m * u[0], m * u[1], *momentum), start=start)


def _disc(auxiliary):
    """Rolling disc; `auxiliary` brings the contact force into evidence (two components)."""
    q = me.dynamicsymbols("q1:6")  # yaw, lean, spin, contact x and y
    u = me.dynamicsymbols("u1:6")
    ux, uz, fx, fz = me.dynamicsymbols("ux uz Fx Fz")
    m, r, g = sm.symbols("m r g")
    frame = me.ReferenceFrame("N")
    yawed = frame.orientnew("Y", "Axis", [q[0], frame.z])
    leaned = yawed.orientnew("L", "Axis", [q[1], yawed.x])
    disc = leaned.orientnew("D", "Axis", [q[2], leaned.y])
    rate = disc.ang_vel_in(frame)
    kd = [rate.dot(e) - w for e, w in zip(leaned, u[:3], strict=True)]
    kd += [q[3].diff(T) - u[3], q[4].diff(T) - u[4]]
    spin = u[0] * leaned.x + u[1] * leaned.y + u[2] * leaned.z
    # Solved by hand rather than by LU: yaw' = u3/cos(lean), lean' = u1, spin' = u2 - u3 tan(lean).
    frame_spin = u[2] / sm.cos(q[1]) * yawed.z + u[0] * yawed.x
    disc.set_ang_vel(frame, spin)
    leaned.set_ang_vel(frame, frame_spin)
    extra = (ux * frame.x + uz * frame.z) if auxiliary else 0 * frame.x
    centre, contact = me.Point("C"), me.Point("P")
    # The geometric contact point moves with u4, u5; the material one must stand still.
    velocity = u[3] * frame.x + u[4] * frame.y + frame_spin.cross(r * leaned.z) + extra
    centre.set_vel(frame, velocity)
    contact.set_vel(frame, velocity + spin.cross(-r * leaned.z))
    still = {ux: 0, uz: 0}
    slip = [contact.vel(frame).dot(e).xreplace(still) for e in (frame.x, frame.y)]
    inertia = me.inertia(leaned, m * r**2 / 4, m * r**2 / 2, m * r**2 / 4)
    rigid = me.RigidBody("R", centre, disc, m, (inertia, centre))
    loads = [(centre, -m * g * frame.z)]
    if auxiliary:
        loads.append((contact, fx * frame.x + fz * frame.z))
    kane = me.KanesMethod(
        frame,
        q,
        u[:3],
        kd_eqs=kd,
        u_dependent=u[3:],
        velocity_constraints=slip,
        u_auxiliary=[ux, uz] if auxiliary else None,
        constraint_solver="CRAMER",
    )
    kane.kanes_equations([rigid], loads)
    energy = (_kinetic(kane, frame) + m * g * r * sm.cos(q[1])).xreplace(still)
    yaw, lean, w = 0.3, 0.2, (0.1, 3.0, 0.4)
    start = dict(zip(q[:3] + u[:3], (yaw, lean, 0.5, *w), strict=True))
    values = {r: 0.6, **start}
    solved = sm.solve([row.xreplace(values) for row in slip], u[3:])
    start |= {k: float(v) for k, v in solved.items()}
    return Model(
        kane,
        {m: 1.7, r: 0.6, g: 9.3},
        forces=(fx, fz) if auxiliary else (),
        energy=energy,
        start=start,
    )


@derived_once
def disc():
    """A rolling disc: two nonholonomic constraints, body-fixed (lean frame) angular speeds."""
    return _disc(auxiliary=False)


@derived_once
def disc_contact():
    """The rolling disc with two components of its contact force as noncontributing forces."""
    return _disc(auxiliary=True)


@derived_once
def sleigh():
    """Chaplygin's sleigh: one nonholonomic constraint, nothing holonomic."""
    x, y, a, vx, vy, w = me.dynamicsymbols("x y theta vx vy omega")
    m, inertia, d = sm.symbols("m I d")
    frame = me.ReferenceFrame("N")
    body = frame.orientnew("B", "Axis", [a, frame.z])
    body.set_ang_vel(frame, w * frame.z)
    centre = me.Point("C")
    centre.set_vel(frame, vx * frame.x + vy * frame.y)
    edge = centre.locatenew("E", -d * body.x)
    edge.v2pt_theory(centre, frame, body)
    rigid = me.RigidBody("R", centre, body, m, (me.inertia(body, 0, 0, inertia), centre))
    kane = me.KanesMethod(
        frame,
        [x, y, a],
        [vx, w],
        kd_eqs=[x.diff(T) - vx, y.diff(T) - vy, a.diff(T) - w],
        u_dependent=[vy],
        velocity_constraints=[edge.vel(frame).dot(body.y)],
    )
    kane.kanes_equations([rigid], None)
    start = {x: 0.1, y: 0.2, a: 0.3, vx: 0.9, w: 0.7}
    start[vy] = float((0.9 * np.sin(0.3) + 0.7 * 0.45) / np.cos(0.3))
    return Model(kane, {m: 1.3, inertia: 0.8, d: 0.45}, energy=_kinetic(kane, frame), start=start)


def _skate(rubbing):
    """Two blades at a fixed angle; the rear one's auxiliary speed is in the front constraint."""
    x, y, a, v, w, side, force = me.dynamicsymbols("x y theta v omega us Fs")
    m, inertia, c, d, steer = sm.symbols("m I c d delta")
    frame = me.ReferenceFrame("N")
    body = frame.orientnew("B", "Axis", [a, frame.z])
    body.set_ang_vel(frame, w * frame.z)
    rear = me.Point("R")
    rear.set_vel(frame, v * body.x + side * body.y)
    centre, front = rear.locatenew("C", c * body.x), rear.locatenew("F", d * body.x)
    centre.v2pt_theory(rear, frame, body)
    front.v2pt_theory(rear, frame, body)
    drag = -v - force / 5 if rubbing else -v
    rigid = me.RigidBody("S", centre, body, m, (me.inertia(body, 0, 0, inertia), centre))
    kane = me.KanesMethod(
        frame,
        [x, y, a],
        [v],
        kd_eqs=[x.diff(T) - v * sm.cos(a), y.diff(T) - v * sm.sin(a), a.diff(T) - w],
        u_dependent=[w],
        velocity_constraints=[
            front.vel(frame).dot(-sm.sin(steer) * body.x + sm.cos(steer) * body.y)
        ],
        u_auxiliary=[side],
    )
    kane.kanes_equations([rigid], [(rear, force * body.y), (centre, drag * body.x)])
    start = {x: 0.1, y: 0.2, a: 0.3, v: 0.9, w: float(0.9 * np.tan(0.35) / 1.4)}
    return Model(
        kane, {m: 1.3, inertia: 0.8, c: 0.55, d: 1.4, steer: 0.35}, forces=(force,), start=start
    )


@derived_once
def skate():
    """Two blades; the side force of the rear one is noncontributing."""
    return _skate(rubbing=False)


@derived_once
def rubbing_skate():
    """The same with friction from that force, which therefore stays in the equations."""
    return _skate(rubbing=True)


@derived_once
def fourbar():
    """A four-bar linkage: two holonomic constraints, and no velocity ones but their rates."""
    q1, q2, q3, u1, u2, u3 = me.dynamicsymbols("q1:4 u1:4")
    la, lb, lc, ln, m1, m2, g = sm.symbols("la lb lc ln m1 m2 g")
    frame = me.ReferenceFrame("N")
    angles, rates, lengths = [q1, q1 + q2, q1 + q2 + q3], [u1, u1 + u2, u1 + u2 + u3], [la, lb, lc]
    arms = [
        n * (sm.cos(a) * frame.x + sm.sin(a) * frame.y)
        for n, a in zip(lengths, angles, strict=True)
    ]
    swings = [
        n * w * (-sm.sin(a) * frame.x + sm.cos(a) * frame.y)
        for n, a, w in zip(lengths, angles, rates, strict=True)
    ]
    p1, p2 = me.Point("P1"), me.Point("P2")
    p1.set_vel(frame, swings[0])
    p2.set_vel(frame, swings[0] + swings[1])
    loop = arms[0] + arms[1] + arms[2] - ln * frame.x
    closure = [loop.dot(frame.x), loop.dot(frame.y)]
    kane = me.KanesMethod(
        frame,
        [q1],
        [u1],
        kd_eqs=[q1.diff(T) - u1, q2.diff(T) - u2, q3.diff(T) - u3],
        q_dependent=[q2, q3],
        configuration_constraints=closure,
        u_dependent=[u2, u3],
        velocity_constraints=[c.diff(T) for c in closure],
        constraint_solver="CRAMER",
    )
    kane.kanes_equations(
        [me.Particle("A", p1, m1), me.Particle("B", p2, m2)],
        [(p1, -m1 * g * frame.y), (p2, -m2 * g * frame.y)],
    )
    energy = _kinetic(kane, frame)
    energy += m1 * g * arms[0].dot(frame.y) + m2 * g * (arms[0] + arms[1]).dot(frame.y)
    numbers = {la: 0.8, lb: 2.1, lc: 1.9, ln: 2.4, m1: 1.3, m2: 0.7, g: 9.7}
    # Two circles cut in P2; then the rates by a 2 x 2 solve.
    start = {q1: 0.7, u1: 1.2}
    joint = np.array([0.8 * np.cos(0.7), 0.8 * np.sin(0.7)])
    across = np.array([2.4, 0.0]) - joint
    reach = np.hypot(*across)
    along = (2.1**2 - 1.9**2 + reach**2) / (2 * reach)
    e = across / reach
    elbow = joint + along * e + np.sqrt(2.1**2 - along**2) * np.array([-e[1], e[0]])
    second = np.arctan2(*(elbow - joint)[::-1])
    third = np.arctan2(*(np.array([2.4, 0.0]) - elbow)[::-1])
    start |= {q2: float(second - 0.7), q3: float(third - second)}
    rows = [
        c.diff(T).xreplace(kane.kindiffdict()).xreplace(numbers).xreplace(start) for c in closure
    ]
    start |= {k: float(v) for k, v in sm.solve(rows, [u2, u3]).items()}
    return Model(kane, numbers, energy=energy, start=start)


@derived_once
def timed():
    """An oscillator whose stiffness and force depend on time explicitly."""
    x, v = me.dynamicsymbols("x v")
    m, k, push, w = sm.symbols("m k p w")
    frame, p = me.ReferenceFrame("N"), me.Point("P")
    p.set_vel(frame, v * frame.x)
    kane = me.KanesMethod(frame, [x], [v], kd_eqs=[x.diff(T) - v])
    load = push * sm.sin(w * T) - k * (1 + sm.cos(T) / 3) * x - sm.exp(-T) * v
    kane.kanes_equations([me.Particle("A", p, m)], [(p, load * frame.x)])
    return Model(kane, _numbers(m, k, push, w))


@derived_once
def shaken():
    """A pendulum whose pivot moves as prescribed, y(t): its derivatives enter the equations."""
    q, u, y = me.dynamicsymbols("q u y")
    m, n, g, c, k = sm.symbols("m l g c k")
    frame = me.ReferenceFrame("N")
    pivot, bob = me.Point("O"), me.Point("B")
    pivot.set_vel(frame, y.diff(T) * frame.y)
    swing = n * u * (sm.cos(q) * frame.x + sm.sin(q) * frame.y)
    bob.set_vel(frame, y.diff(T) * frame.y + swing)
    bob.set_acc(
        frame,
        y.diff(T, 2) * frame.y
        + n * u.diff(T) * (sm.cos(q) * frame.x + sm.sin(q) * frame.y)
        + n * u**2 * (-sm.sin(q) * frame.x + sm.cos(q) * frame.y),
    )
    kane = me.KanesMethod(frame, [q], [u], kd_eqs=[q.diff(T) - u])
    spring = -k * (y - n * sm.cos(q)) * frame.y
    kane.kanes_equations(
        [me.Particle("P", bob, m)], [(bob, -m * g * frame.y - c * bob.vel(frame) + spring)]
    )
    numbers = {y: 0.31, y.diff(T): -0.42, y.diff(T, 2): 0.57}
    return Model(kane, _numbers(m, n, g, c, k), numbers)


@derived_once
def added_mass():
    """Two bodies in a fluid: the loads are linear in the accelerations, across the bodies too."""
    x1, x2, v1, v2 = me.dynamicsymbols("x1 x2 v1 v2")
    m1, m2, a1, a2, k = sm.symbols("m1 m2 a1 a2 k")
    frame, p1, p2 = me.ReferenceFrame("N"), me.Point("P1"), me.Point("P2")
    p1.set_vel(frame, v1 * frame.x)
    p2.set_vel(frame, v2 * frame.x)
    kane = me.KanesMethod(frame, [x1, x2], [v1, v2], kd_eqs=[x1.diff(T) - v1, x2.diff(T) - v2])
    f1 = -a1 * (v1.diff(T) + sm.cos(x2) * v2.diff(T)) - k * x1
    f2 = -a2 * v2.diff(T) - k * x2 - v2 * v1.diff(T)
    kane.kanes_equations(
        [me.Particle("A", p1, m1), me.Particle("B", p2, m2)],
        [(p1, f1 * frame.x), (p2, f2 * frame.x)],
    )
    return Model(kane, _numbers(m1, m2, a1, a2, k))


@derived_once
def squared_acceleration():
    """A load that depends on the square of an acceleration: nothing can be done with it."""
    x, v = me.dynamicsymbols("x v")
    frame, p = me.ReferenceFrame("N"), me.Point("P")
    p.set_vel(frame, v * frame.x)
    kane = me.KanesMethod(frame, [x], [v], kd_eqs=[x.diff(T) - v])
    kane.kanes_equations([me.Particle("A", p, sm.Symbol("m"))], [(p, -(v.diff(T) ** 2) * frame.x)])
    return Model(kane, {sm.Symbol("m"): 1.3})


@derived_once
def bare():
    """No constants and no specifieds: a unit particle on a unit pendulum."""
    q, u = me.dynamicsymbols("q u")
    frame, p = me.ReferenceFrame("N"), me.Point("P")
    arm = frame.orientnew("A", "Axis", [q, frame.z])
    arm.set_ang_vel(frame, u * frame.z)
    origin = me.Point("O")
    origin.set_vel(frame, 0)
    p.set_pos(origin, -arm.y)
    p.v2pt_theory(origin, frame, arm)
    kane = me.KanesMethod(frame, [q], [u], kd_eqs=[q.diff(T) - u])
    kane.kanes_equations([me.Particle("P", p, sm.Integer(1))], [(p, -9 * frame.y)])
    return Model(kane, energy=u**2 / 2 - 9 * sm.cos(q), start={q: 0.8, u: 0.3})


def track_with(order):
    """A particle on a surface (holonomic) that may not slip across blades (nonholonomic).

    `order` gives the velocity constraints as a function of (rate of the surface, blade).
    """
    x, y, z, vx, vy, vz = me.dynamicsymbols("x y z vx vy vz")
    m, k, g = sm.symbols("m k g")
    frame, p = me.ReferenceFrame("N"), me.Point("P")
    p.set_vel(frame, vx * frame.x + vy * frame.y + vz * frame.z)
    surface = z - k * (x**2 + y**2) / 2
    rate, blade = vz - k * (x * vx + y * vy), vy - x * vx
    kane = me.KanesMethod(
        frame,
        [x, y],
        [vx],
        kd_eqs=[x.diff(T) - vx, y.diff(T) - vy, z.diff(T) - vz],
        q_dependent=[z],
        configuration_constraints=[surface],
        u_dependent=[vy, vz],
        velocity_constraints=order(rate, blade),
        constraint_solver="CRAMER",
    )
    kane.kanes_equations([me.Particle("P", p, m)], [(p, -m * g * frame.z)])
    start = {x: 0.4, y: 0.3, vx: 0.9, vy: 0.36}
    start[z] = 0.8 * 0.25 / 2
    start[vz] = 0.8 * (0.4 * 0.9 + 0.3 * 0.36)
    energy = m * (vx**2 + vy**2 + vz**2) / 2 + m * g * z
    return Model(kane, {m: 1.3, k: 0.8, g: 9.7}, energy=energy, start=start)


@derived_once
def track():
    """Holonomic and nonholonomic constraints together."""
    return track_with(lambda rate, blade: [rate, blade])


@derived_once
def track_reversed():
    """The same, the nonholonomic row first and the other a multiple of the surface's rate."""
    return track_with(lambda rate, blade: [blade, -2 * rate])


@derived_once
def gyro():
    """A body turning about its centre, quaternion: a holonomic constraint without its rate."""
    e = me.dynamicsymbols("e0:4")
    w = me.dynamicsymbols("w1:4")
    inertias = sm.symbols("A B C")
    frame, body = me.ReferenceFrame("N"), me.ReferenceFrame("Q")
    body.orient_quaternion(frame, e)
    body.set_ang_vel(frame, w[0] * body.x + w[1] * body.y + w[2] * body.z)
    centre = me.Point("C")
    centre.set_vel(frame, 0)
    rigid = me.RigidBody("R", centre, body, 1, (me.inertia(body, *inertias), centre))
    half = sm.Rational(1, 2)
    rates = {
        e[0]: -half * (e[1] * w[0] + e[2] * w[1] + e[3] * w[2]),
        e[1]: half * (e[0] * w[0] + e[2] * w[2] - e[3] * w[1]),
        e[2]: half * (e[0] * w[1] + e[3] * w[0] - e[1] * w[2]),
        e[3]: half * (e[0] * w[2] + e[1] * w[1] - e[2] * w[0]),
    }
    kane = me.KanesMethod(
        frame,
        e[1:],
        w,
        kd_eqs=[i.diff(T) - rates[i] for i in (*e[1:], e[0])],
        q_dependent=[e[0]],
        configuration_constraints=[sum(i**2 for i in e) - 1],
    )
    kane.kanes_equations([rigid], None)
    start = {e[1]: 0.1, e[2]: 0.3, e[3]: -0.4, w[0]: 0.8, w[1]: 2.0, w[2]: -0.5}
    start[e[0]] = float(np.sqrt(1 - 0.01 - 0.09 - 0.16))
    energy = sum(i * j**2 for i, j in zip(inertias, w, strict=True)) / 2
    size = sum(i**2 * j**2 for i, j in zip(inertias, w, strict=True))
    momenta = (size, sum(i**2 for i in e))
    return Model(
        kane,
        _numbers(*inertias),
        energy=energy,
        momenta=momenta,
        start=start,
        quaternion=tuple(e),
    )


@derived_once
def lifted():
    """A particle on a line that rises as prescribed and tilts with time: a rheonomic constraint."""
    x, y, vx, vy, s = me.dynamicsymbols("x y vx vy s")
    m, slope, g = sm.symbols("m slope g")
    frame, p = me.ReferenceFrame("N"), me.Point("P")
    p.set_vel(frame, vx * frame.x + vy * frame.y)
    line = y - s - slope * x * sm.sin(T)
    kane = me.KanesMethod(
        frame,
        [x],
        [vx],
        kd_eqs=[x.diff(T) - vx, y.diff(T) - vy],
        q_dependent=[y],
        configuration_constraints=[line],
        u_dependent=[vy],
        velocity_constraints=[line.diff(T)],
    )
    kane.kanes_equations([me.Particle("P", p, m)], [(p, -m * g * frame.y)])
    numbers = {s: 0.31, s.diff(T): -0.42, s.diff(T, 2): 0.57}
    return Model(kane, {m: 1.3, slope: 0.6, g: 9.7}, numbers)


MODELS: dict[str, Callable[[], Model]] = {
    f.__name__: f
    for f in (
        chain,
        undamped_chain,
        pendulum,
        free_pendulum,
        free_body,
        disc,
        disc_contact,
        sleigh,
        skate,
        fourbar,
        timed,
        shaken,
        added_mass,
        bare,
        track,
        track_reversed,
        gyro,
        lifted,
    )
}

CONSERVATIVE = [
    "undamped_chain",
    "free_pendulum",
    "free_body",
    "disc",
    "disc_contact",
    "sleigh",
    "fourbar",
    "bare",
    "track",
    "track_reversed",
    "gyro",
]
