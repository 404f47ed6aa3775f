"""A ball that rolls on a turntable, with the contact's forces by auxiliary speeds."""

import sympy as sm
import sympy.physics.mechanics as me

from zoo import Model, T, _numbers, inertial_frame


def ball_on_a_turntable():
    """Its inertia is written in axes that turn with it, where products of equal terms cancel."""
    frame, origin = inertial_frame()
    x, y, table = me.dynamicsymbols("x y Omega")
    q, w, v = (list(me.dynamicsymbols(f"{name}1:4")) for name in "qwv")
    slip, forces = list(me.dynamicsymbols("s1:4")), list(me.dynamicsymbols("R1:4"))
    m, r, size, k, g = sm.symbols("m r I k g")
    body = me.ReferenceFrame("B")
    body.orient_body_fixed(frame, q, "zxy")
    spin = w[0] * frame.x + w[1] * frame.y + w[2] * frame.z
    body.set_ang_vel(frame, spin)
    centre = origin.locatenew("C", x * frame.x + y * frame.y + r * frame.z)
    along = v[0] * frame.x + v[1] * frame.y
    centre.set_vel(frame, along + slip[0] * frame.x + slip[1] * frame.y + slip[2] * frame.z)
    contact = centre.locatenew("P", -r * frame.z)
    contact.set_vel(frame, centre.vel(frame) + spin.cross(-r * frame.z))
    ground = (table * frame.z).cross(x * frame.x + y * frame.y)
    rolling = along + spin.cross(-r * frame.z) - ground
    level, across = (w[1] * sm.cos(q[0]) - w[0] * sm.sin(q[0])), sm.cos(q[1])
    rates = [
        w[2] - level * sm.tan(q[1]),
        w[0] * sm.cos(q[0]) + w[1] * sm.sin(q[0]),
        level / across,
    ]
    kane = me.KanesMethod(
        frame,
        [x, y, *q],
        w,
        kd_eqs=[a.diff(T) - b for a, b in zip([x, y, *q], [*v[:2], *rates], strict=True)],
        u_dependent=v[:2],
        velocity_constraints=[rolling.dot(frame.x), rolling.dot(frame.y)],
        u_auxiliary=slip,
    )
    ball = me.RigidBody("ball", centre, body, m, (me.inertia(body, size, size, size), centre))
    push = sum((f * e for f, e in zip(forces, frame, strict=True)), 0 * frame.x)
    kane.kanes_equations([ball], [(centre, -m * g * frame.z - k * v[0] * frame.x), (contact, push)])
    numbers = {table: 0.4, table.diff(T): 0.2, **dict.fromkeys(forces, 0.37)}
    return Model(kane, _numbers(m, r, size, k, g), numbers, forces=tuple(forces))
