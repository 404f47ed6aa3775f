"""Models of the benchmark set derived otherwise: what is fast on one form must be so on others.

The same chains with other joints and other speeds, a second bicycle and a second rider, a
quadrotor. Derived with SymPy and frozen, as `models` are.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sm
import sympy.physics.mechanics as me

from harness.kane import from_kane
from harness.model import Model


def rods(n: int, *, universal: bool = False, absolute: bool = False) -> Model:
    """Return a chain of n rigid rods in space, hung up, with ball joints between them.

    Each rod has its own three moments of inertia and is turned by body-fixed angles about x, y, z.
    The speeds are components of its angular velocity along its own axes.

    Parameters
    ----------
    n : int
    universal : bool
        Whether the first joint is a universal joint, which has two angles whose rates are its
        speeds, instead of a ball joint.
    absolute : bool
        Whether angles and angular velocities are those against the ground, instead of those
        against the rod above.
    """
    m, l, ix, iy, iz = (sm.symbols(f"{name}0:{n}") for name in ("m", "l", "I_x", "I_y", "I_z"))
    g = sm.Symbol("g")
    ground = above = me.ReferenceFrame("N")
    joint = me.Point("O")
    joint.set_vel(ground, 0)
    q, u, rates, bodies, loads = [], [], [], [], []
    for k in range(n):
        frame, base = me.ReferenceFrame(f"B{k}"), ground if absolute else above
        if universal and k == 0:
            angles, speeds = me.dynamicsymbols("a0 b0"), me.dynamicsymbols("u0 v0")
            cross = me.ReferenceFrame("X")
            cross.orient_axis(base, base.x, angles[0])
            frame.orient_axis(cross, cross.y, angles[1])
            rates += [angle.diff() - speed for angle, speed in zip(angles, speeds, strict=True)]
            frame.set_ang_vel(base, speeds[0] * cross.x + speeds[1] * cross.y)
        else:
            angles = me.dynamicsymbols(f"a{k} b{k} c{k}")
            speeds = me.dynamicsymbols(f"u{k} v{k} w{k}")
            frame.orient_body_fixed(base, angles, "123")
            turning = frame.ang_vel_in(base)
            rates += [turning.dot(axis) - s for axis, s in zip(frame, speeds, strict=True)]
            frame.set_ang_vel(base, _vector(speeds, frame))
        centre = joint.locatenew(f"C{k}", -l[k] / 2 * frame.z)
        centre.v2pt_theory(joint, ground, frame)
        below = joint.locatenew(f"O{k}", -l[k] * frame.z)
        below.v2pt_theory(joint, ground, frame)
        inertia = me.inertia(frame, ix[k], iy[k], iz[k])
        bodies.append(me.RigidBody(f"rod{k}", centre, frame, m[k], (inertia, centre)))
        loads.append((centre, -m[k] * g * ground.z))
        q += angles
        u += speeds
        above, joint = frame, below
    kane = me.KanesMethod(ground, q_ind=q, u_ind=u, kd_eqs=rates)
    kane.kanes_equations(bodies, loads)
    typical = {"m": 1.0, "l": 0.5, "I_x": 0.021, "I_y": 0.022, "I_z": 0.002}
    name = "rods" + "-universal" * universal + "-absolute" * absolute + f"-{n}"
    return from_kane(
        name,
        kane,
        lambda name: 9.81 if name == "g" else typical[name.rstrip("0123456789")],
        source="rigid rods in space, speeds along their own axes",
    )


def pendulum_relative(n: int) -> Model:
    """Return a planar pendulum of n links on a cart, its angles those against the link above."""
    m, l, g = sm.symbols(f"m0:{n + 1}"), sm.symbols(f"l0:{n}"), sm.Symbol("g")
    q, u, force = me.dynamicsymbols(f"q0:{n + 1}"), me.dynamicsymbols(f"u0:{n + 1}"), "F"
    push = me.dynamicsymbols(force)
    ground = above = me.ReferenceFrame("N")
    origin = me.Point("O")
    origin.set_vel(ground, 0)
    joint = origin.locatenew("P0", q[0] * ground.x)
    joint.set_vel(ground, u[0] * ground.x)
    bodies = [me.Particle("cart", joint, m[0])]
    loads = [(joint, push * ground.x - m[0] * g * ground.y)]
    for k in range(n):
        frame = me.ReferenceFrame(f"B{k}")
        frame.orient_axis(above, above.z, q[k + 1])
        frame.set_ang_vel(above, u[k + 1] * above.z)
        end = joint.locatenew(f"P{k + 1}", -l[k] * frame.y)
        end.v2pt_theory(joint, ground, frame)
        bodies.append(me.Particle(f"bob{k}", end, m[k + 1]))
        loads.append((end, -m[k + 1] * g * ground.y))
        above, joint = frame, end
    rates = [a.diff() - b for a, b in zip(q, u, strict=True)]
    kane = me.KanesMethod(ground, q_ind=list(q), u_ind=list(u), kd_eqs=rates)
    kane.kanes_equations(bodies, loads)
    return from_kane(
        f"pendulum-relative-{n}",
        kane,
        lambda name: 9.81 if name == "g" else 1.0 / n,
        source="a pendulum on a cart with angles against the link above",
    )


def bicycle_from_contact() -> Model:
    """Return a Carvallo-Whipple bicycle set up from the rear wheel's contact.

    Yaw, lean, pitch and steer; the speeds are their rates and those of the wheels' angles. The
    rear wheel rolls by construction, without a coordinate for its place, and three velocity
    constraints hold the front contact. The frames' products of inertia are along the steer axis.
    """
    yaw, lean, pitch, steer, rear, front = q = me.dynamicsymbols("q1:7")
    u = me.dynamicsymbols("u1:7")
    names = "r_R r_F d1 d2 d3 x_B z_B x_H z_H m_R m_B m_H m_F g"
    r_r, r_f, d1, d2, d3, x_b, z_b, x_h, z_h, m_r, m_b, m_h, m_f, g = sm.symbols(names)
    i_r, j_r, i_f, j_f = sm.symbols("I_R J_R I_F J_F")
    b = sm.symbols("B_xx B_yy B_zz B_zx")
    h = sm.symbols("H_xx H_yy H_zz H_zx")
    n, a, c, body, fork, wheel_r, wheel_f = map(me.ReferenceFrame, "NACBHRF")
    a.orient_axis(n, n.z, yaw)
    c.orient_axis(a, a.x, lean)
    body.orient_axis(c, c.y, pitch)
    fork.orient_axis(body, body.z, steer)
    wheel_r.orient_axis(body, body.y, rear)
    wheel_f.orient_axis(fork, fork.y, front)
    for outer, inner, axis, speed in (
        *((a, n, n.z, u[0]), (c, a, a.x, u[1]), (body, c, c.y, u[2]), (fork, body, body.z, u[3])),
        *((wheel_r, body, body.y, u[4]), (wheel_f, fork, fork.y, u[5])),
    ):
        outer.set_ang_vel(inner, speed * axis)
    contact = me.Point("P")
    contact.set_vel(n, 0)
    hub_r = contact.locatenew("R", -r_r * c.z)
    hub_r.set_vel(n, wheel_r.ang_vel_in(n).cross(-r_r * c.z).express(c))
    mass_b = hub_r.locatenew("Bo", x_b * body.x + z_b * body.z)
    mass_b.v2pt_theory(hub_r, n, body)
    steered = hub_r.locatenew("S", d1 * body.x)
    steered.v2pt_theory(hub_r, n, body)
    mass_h = steered.locatenew("Ho", x_h * fork.x + z_h * fork.z)
    mass_h.v2pt_theory(steered, n, fork)
    hub_f = steered.locatenew("F", d2 * fork.z + d3 * fork.x)
    hub_f.v2pt_theory(steered, n, fork)
    # From the hub down to the ground, in the wheel's plane.
    cosine = fork.y.dot(a.z)
    down = (a.z - cosine * fork.y) / sm.sqrt(1 - cosine**2)
    touching = hub_f.locatenew("Q", r_f * down.express(fork))
    touching.set_vel(n, hub_f.vel(n) + wheel_f.ang_vel_in(n).cross(r_f * down.express(fork)))
    constraints = [touching.vel(n).dot(axis) for axis in (a.x, a.y, a.z)]
    bodies = [
        me.RigidBody("rear", hub_r, wheel_r, m_r, (me.inertia(body, i_r, j_r, i_r), hub_r)),
        me.RigidBody(
            "frame", mass_b, body, m_b, (me.inertia(body, b[0], b[1], b[2], 0, 0, b[3]), mass_b)
        ),
        me.RigidBody(
            "fork", mass_h, fork, m_h, (me.inertia(fork, h[0], h[1], h[2], 0, 0, h[3]), mass_h)
        ),
        me.RigidBody("front", hub_f, wheel_f, m_f, (me.inertia(fork, i_f, j_f, i_f), hub_f)),
    ]
    loads = [(part.masscenter, part.mass * g * n.z) for part in bodies]
    kane = me.KanesMethod(
        n,
        q_ind=list(q),
        u_ind=[u[1], u[3], u[4]],
        u_dependent=[u[0], u[2], u[5]],
        kd_eqs=[x.diff() - y for x, y in zip(q, u, strict=True)],
        velocity_constraints=constraints,
    )
    kane.kanes_equations(bodies, loads)
    values = {
        **{"r_R": 0.3, "r_F": 0.35, "d1": 0.95, "d2": 0.27, "d3": 0.05, "x_B": 0.46, "z_B": -0.75},
        **{"x_H": 0.05, "z_H": -0.2, "m_R": 2.0, "m_B": 85.0, "m_H": 4.0, "m_F": 3.0, "g": 9.81},
        **{"I_R": 0.06, "J_R": 0.12, "I_F": 0.14, "J_F": 0.28},
        **{"B_xx": 9.2, "B_yy": 11.0, "B_zz": 2.8, "B_zx": 2.4},
        **{"H_xx": 0.06, "H_yy": 0.06, "H_zz": 0.008, "H_zx": -0.008},
    }
    return from_kane(
        "bicycle-from-contact",
        kane,
        values.__getitem__,
        source="a Whipple bicycle from its rear contact on; rates of angles for speeds",
    )


def rider_adduction() -> Model:
    """Return another rider-bicycle of `symbrim`: shoulders by flexion and adduction."""
    from harness.rider import derive

    kane, values = derive("FlexAdd")
    return from_kane("rider-adduction", kane, values, source="symbrim")


def quadrotor() -> Model:
    """Return a quadrotor that carries a load on a rigid, massless cable.

    The body's place is in the ground's axes, its attitude by angles about z, y, x; its speeds are
    the rate of its place and its angular velocity in its own axes. The cable has two angles. Four
    thrusts are inputs, each with a drag moment in proportion.
    """
    place, attitude, cable = (
        me.dynamicsymbols(names) for names in ("x y z", "psi theta phi", "a b")
    )
    velocity, spin, swing = (me.dynamicsymbols(names) for names in ("v1:4", "w1:4", "s1:3"))
    thrusts = me.dynamicsymbols("T1:5")
    m, load, ix, iy, iz, arm, drag, l, h, g, c = sm.symbols("m M I_x I_y I_z d k l h g c")
    n, body, middle, rope = map(me.ReferenceFrame, "NBCR")
    body.orient_body_fixed(n, attitude, "321")
    turning = body.ang_vel_in(n)
    rates = [turning.dot(axis) - w for axis, w in zip(body, spin, strict=True)]
    body.set_ang_vel(n, _vector(spin, body))
    middle.orient_axis(n, n.x, cable[0])
    rope.orient_axis(middle, middle.y, cable[1])
    rope.set_ang_vel(n, swing[0] * n.x + swing[1] * middle.y)
    origin = me.Point("O")
    origin.set_vel(n, 0)
    centre = origin.locatenew("C", _vector(place, n))
    centre.set_vel(n, _vector(velocity, n))
    hook = centre.locatenew("H", -h * body.z)
    hook.v2pt_theory(centre, n, body)
    weight = hook.locatenew("L", -l * rope.z)
    weight.v2pt_theory(hook, n, rope)
    rates += [p.diff() - v for p, v in zip(place, velocity, strict=True)]
    rates += [p.diff() - v for p, v in zip(cable, swing, strict=True)]
    t = thrusts
    bodies = [
        me.RigidBody("drone", centre, body, m, (me.inertia(body, ix, iy, iz), centre)),
        me.Particle("load", weight, load),
    ]
    moment = arm * (t[1] - t[3]) * body.x + arm * (t[2] - t[0]) * body.y
    loads = [
        (centre, sum(t) * body.z - m * g * n.z - c * centre.vel(n)),
        (body, moment + drag * (t[0] - t[1] + t[2] - t[3]) * body.z),
        (weight, -load * g * n.z),
    ]
    kane = me.KanesMethod(
        n,
        q_ind=[*attitude, *place, *cable],
        u_ind=[*spin, *velocity, *swing],
        kd_eqs=rates,
    )
    kane.kanes_equations(bodies, loads)
    values = {"g": 9.81, "m": 1.2, "M": 0.4, "l": 0.8, "h": 0.05, "d": 0.2, "k": 0.02, "c": 0.1}
    inertia = {"I_x": 0.012, "I_y": 0.013, "I_z": 0.022}
    return from_kane(
        "quadrotor",
        kane,
        lambda name: (values | inertia)[name],
        source="a quadrotor with a slung load",
    )


def _vector(components: Sequence[Any], frame: me.ReferenceFrame) -> Any:
    return sum((c * e for c, e in zip(components, frame, strict=True)), 0 * frame.x)
