"""Systems with contacts that several tests look at."""

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import Contacts, Stick, Unilateral
from pydy.mechanics import Definition
from zoo import inertial_frame

x, y, a = me.dynamicsymbols("x y a")
vx, vy, w = me.dynamicsymbols("v_x v_y w")
m, g, mu, r, k, J, e, slope = sm.symbols("m g mu r k J e slope")
N, O = inertial_frame()
TIGHT = {"rtol": 1e-12, "atol": 1e-13}


def body_in_plane(points=()):
    """A body with x, y, a; its points, given in its own axes."""
    B = me.ReferenceFrame("B")
    B.orient_axis(N, N.z, a)
    B.set_ang_vel(N, w * N.z)
    C = O.locatenew("C", x * N.x + y * N.y)
    C.set_vel(N, vx * N.x + vy * N.y)
    body = me.RigidBody("body", C, B, m, (me.inertia(B, 0, 0, J), C))
    found = []
    for k_, (px, py) in enumerate(points):
        P = C.locatenew(f"P{k_}", px * B.x + py * B.y)
        P.v2pt_theory(C, N, B)
        found.append(P)
    return C, body, found


def falling_body(points, *, tilt=0, **contact):
    """A body with feet on a floor, with gravity."""
    mu_ = contact.pop("mu", None)
    C, body, feet = body_in_plane(points)
    pull = -m * g * (sm.sin(tilt) * N.x + sm.cos(tilt) * N.y)
    system = System(
        Definition(N, [x, y, a], [vx, vy, w], bodies=[body], loads=[(C, pull)]), ode_solver="dop853"
    )
    system.constants[g] = 9.81
    found = []
    for j, foot in enumerate(feet):
        gap = Unilateral(foot.pos_from(O).dot(N.y), name=f"foot{j}", **contact)
        found.append(gap)
        if mu_ is not None:
            found.append(Stick(foot, on=gap, mu=mu_, along=N.x))
    return system, found


def billiard_ball():
    """A ball on a table that slides at first, y above it being its radius, and its contacts."""
    C, body, _ = body_in_plane()
    system = System(
        Definition(N, [x, y, a], [vx, vy, w], bodies=[body], loads=[(C, -m * g * N.y)]),
        {g: 9.81, J: 0.4 * 0.01}, ode_solver="dop853",
        initial_conditions={y: 0.1, vx: 2.0}, times=np.linspace(0.0, 0.5, 6),
    )  # fmt: skip
    table = Unilateral(y - r, name="table")
    return Contacts(system, [table, Stick(vx + r * w, on=table, mu=mu)], {mu: 0.2, r: 0.1})


def ball(**options):
    """A particle that moves up and down."""
    P = O.locatenew("P", y * N.y)
    P.set_vel(N, vy * N.y)
    system = System(
        Definition(N, [y], [vy], bodies=[me.Particle("ball", P, m)], loads=[(P, -m * g * N.y)]),
        {g: 9.81}, ode_solver="dop853",
    )  # fmt: skip
    return system, Unilateral(y, name="floor", **options)


def block(tilt=0):
    """A particle on a slope, with two coordinates."""
    P = O.locatenew("P", x * N.x + y * N.y)
    P.set_vel(N, vx * N.x + vy * N.y)
    pull = -m * g * (sm.sin(tilt) * N.x + sm.cos(tilt) * N.y)
    system = System(
        Definition(N, [x, y], [vx, vy], bodies=[me.Particle("block", P, m)], loads=[(P, pull)]),
        {g: 9.81}, ode_solver="dop853",
    )  # fmt: skip
    return system, P


def pulled(pull, start, constants, value=0.3, **friction):
    """A particle on a floor in space, under a pull along it."""
    z, vz = me.dynamicsymbols("z v_z")
    P = O.locatenew("P", x * N.x + y * N.y + z * N.z)
    P.set_vel(N, vx * N.x + vy * N.y + vz * N.z)
    load = pull[0] * N.x + pull[1] * N.y - m * g * N.z
    system = System(
        Definition(N, [x, y, z], [vx, vy, vz], bodies=[me.Particle("b", P, m)], loads=[(P, load)]),
        {g: 10.0, **constants}, {}, "dop853", start, [0.0, 3.0],
    )  # fmt: skip
    stick = Stick(P, on=Unilateral(z, name="floor"), along=(N.x, N.y), mu=mu, **friction)
    return Contacts(system, [stick], {mu: value})
