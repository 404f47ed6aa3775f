"""Lagrange's equations from an energy against Kane's from bodies: the same accelerations.

Each model is given twice, with nothing in common but symbols: as a Lagrangian that is written down
in coordinates, and as bodies in frames.
"""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from zoo import inertial_frame
from zoo.cases import close

T = me.dynamicsymbols._t


def _speeds(q):
    return [me.dynamicsymbols(f"u_{c.name}") for c in q]


def spherical_pendulum():
    q = theta, phi = me.dynamicsymbols("theta phi")
    m, l, g = sm.symbols("m l g")
    kinetic = m * l**2 * (theta.diff(T) ** 2 + sm.sin(theta) ** 2 * phi.diff(T) ** 2) / 2
    lagrange = me.LagrangesMethod(kinetic + m * g * l * sm.cos(theta), q)
    frame, origin = inertial_frame()
    turned, tilted = me.ReferenceFrame("A"), me.ReferenceFrame("B")
    turned.orient_axis(frame, frame.z, phi)
    tilted.orient_axis(turned, turned.x, theta)
    bob = origin.locatenew("P", -l * tilted.z)
    bodies, loads = [me.Particle("bob", bob, m)], [(bob, -m * g * frame.z)]
    return lagrange, Definition(frame, q, _speeds(q), bodies=bodies, loads=loads)


def shaken_pendulum():
    """A pivot that moves as prescribed, and a length that depends on time."""
    theta, height = me.dynamicsymbols("theta h")
    m, l, g = sm.symbols("m l g")
    reach = l * (1 + sm.cos(T) / 5)
    x, y = reach * sm.sin(theta), height - reach * sm.cos(theta)
    kinetic = m * (x.diff(T) ** 2 + y.diff(T) ** 2) / 2
    lagrange = me.LagrangesMethod(kinetic - m * g * y, [theta])
    frame, origin = inertial_frame()
    rod = me.ReferenceFrame("R")
    rod.orient_axis(frame, frame.z, theta)
    bob = origin.locatenew("P", height * frame.y - reach * rod.y)
    bodies, loads = [me.Particle("bob", bob, m)], [(bob, -m * g * frame.y)]
    return lagrange, Definition(frame, [theta], _speeds([theta]), bodies=bodies, loads=loads)


def heavy_top():
    """Euler angles against angular velocities along the body's axes as speeds."""
    q = phi, theta, psi = me.dynamicsymbols("phi theta psi")
    across, along, m, l, g = sm.symbols("A C m l g")
    spin = psi.diff(T) + phi.diff(T) * sm.cos(theta)
    tilting = theta.diff(T) ** 2 + phi.diff(T) ** 2 * sm.sin(theta) ** 2
    energy = across * tilting / 2 + along * spin**2 / 2 - m * g * l * sm.cos(theta)
    frame, origin = inertial_frame()
    top = me.ReferenceFrame("B")
    top.orient_body_fixed(frame, q, "zxz")
    written = [top.ang_vel_in(frame).dot(axis) for axis in top]
    u = _speeds(q)
    top.set_ang_vel(frame, u[0] * top.x + u[1] * top.y + u[2] * top.z)
    centre = origin.locatenew("C", l * top.z)
    fixed = (me.inertia(top, across, across, along), origin)
    return me.LagrangesMethod(energy, q), Definition(
        frame,
        q,
        u,
        kinematic_equations=[a - b for a, b in zip(u, written, strict=True)],
        bodies=[me.RigidBody("top", centre, top, m, fixed)],
        loads=[(centre, -m * g * frame.z)],
    )


def masses_on_rods():
    """Two holonomic constraints."""
    q = x, y, a, b = me.dynamicsymbols("x y a b")
    m, n, l, g = sm.symbols("m n l g")
    kinetic = m * (x.diff(T) ** 2 + y.diff(T) ** 2) + n * (a.diff(T) ** 2 + b.diff(T) ** 2)
    rods = [x**2 + y**2 - l**2, (a - x) ** 2 + (b - y) ** 2 - l**2]
    lagrange = me.LagrangesMethod(kinetic / 2 - g * (m * y + n * b), q, hol_coneqs=rods)
    frame, origin = inertial_frame()
    ends = [
        origin.locatenew(name, i * frame.x + j * frame.y)
        for name, i, j in (("P", x, y), ("Q", a, b))
    ]
    bodies = [me.Particle(f"b{k}", p, s) for k, (p, s) in enumerate(zip(ends, (m, n), strict=True))]
    return lagrange, Definition(
        frame,
        q,
        _speeds(q),
        bodies=bodies,
        loads=[(p.point, -p.mass * g * frame.y) for p in bodies],
        holonomic_constraints=rods,
        dependent_coordinates=[y, b],
        dependent_speeds=_speeds([y, b]),
    )


def skate():
    """A blade that cannot slip sideways, with a driving force along it."""
    q = x, y, turn = me.dynamicsymbols("x y theta")
    drive = me.dynamicsymbols("P")
    m, size, c, g = sm.symbols("m I c g")
    frame, blade, point = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("C")
    blade.orient_axis(frame, frame.z, turn)
    point.set_vel(frame, x.diff(T) * frame.x + y.diff(T) * frame.y)
    vx = x.diff(T) - c * turn.diff(T) * sm.sin(turn)
    vy = y.diff(T) + c * turn.diff(T) * sm.cos(turn)
    kinetic = m * (vx**2 + vy**2) / 2 + size * turn.diff(T) ** 2 / 2
    slip = y.diff(T) * sm.cos(turn) - x.diff(T) * sm.sin(turn)
    lagrange = me.LagrangesMethod(
        kinetic - m * g * (y + c * sm.sin(turn)),
        q,
        forcelist=[(point, drive * blade.x)],
        frame=frame,
        nonhol_coneqs=[slip],
    )
    ground, origin = inertial_frame()
    body = me.ReferenceFrame("S")
    body.orient_axis(ground, ground.z, turn)
    edge = origin.locatenew("E", x * ground.x + y * ground.y)
    centre = edge.locatenew("G", c * body.x)
    u = _speeds(q)
    return lagrange, me.KanesMethod(
        ground,
        q,
        u[1:],
        u_dependent=u[:1],
        kd_eqs=[a.diff(T) - b for a, b in zip(q, u, strict=True)],
        velocity_constraints=[u[1] * sm.cos(turn) - u[0] * sm.sin(turn)],
        bodies=[me.RigidBody("sledge", centre, body, m, (me.inertia(body, 0, 0, size), centre))],
        forcelist=[(edge, drive * body.x), (centre, -m * g * ground.y)],
    )


def rail():
    """Both kinds of constraints, of which the holonomic one moves with time."""
    q = x, y, turn = me.dynamicsymbols("x y theta")
    m, size, c = sm.symbols("m I c")
    kinetic = m * (x.diff(T) ** 2 + y.diff(T) ** 2) / 2 + size * turn.diff(T) ** 2 / 2
    track = y - sm.sin(c * x) - c * T
    slip = y.diff(T) * sm.cos(turn) - x.diff(T) * sm.sin(turn)
    lagrange = me.LagrangesMethod(kinetic, q, hol_coneqs=[track], nonhol_coneqs=[slip])
    frame, origin = inertial_frame()
    body = me.ReferenceFrame("S")
    body.orient_axis(frame, frame.z, turn)
    centre = origin.locatenew("G", x * frame.x + y * frame.y)
    own = (me.inertia(body, 0, 0, size), centre)
    return lagrange, Definition(
        frame,
        q,
        _speeds(q),
        bodies=[me.RigidBody("sledge", centre, body, m, own)],
        holonomic_constraints=[track],
        nonholonomic_constraints=[slip],
    )


MODELS = {
    f.__name__: f
    for f in (spherical_pendulum, shaken_pendulum, heavy_top, masses_on_rods, skate, rail)
}


def numbered(system, numbers):
    system.constants = {s: numbers[s] for s in system.constants_symbols}
    system.specifieds = {s: numbers[s] for s in system.specifieds_symbols}
    return system


@pytest.mark.parametrize("name", MODELS)
def test_both_give_the_same_accelerations(name):
    lagrange, kane = map(System, MODELS[name]())
    rng, time = np.random.default_rng(4), 0.7
    symbols = sorted([*lagrange.constants_symbols, *lagrange.specifieds_symbols], key=str)
    numbers = {s: float(rng.uniform(0.5, 2.0)) for s in symbols}
    numbered(lagrange, numbers)
    numbered(kane, numbers)
    q, names = kane.coordinates, {u: sm.Dummy() for u in kane.speeds}
    rates = dict(zip(q, kane._equations.kinematics.coordinate_derivatives, strict=True))
    written = {c.diff(T): rate for c, rate in rates.items()}
    kane.outputs = {f"a_{c.name}": rates[c].diff(T).subs(written) for c in q}
    for _ in range(3):
        state = {s: float(rng.uniform(0.3, 0.9)) for s in sorted(lagrange.states, key=str)}
        lagrange.initial_conditions, lagrange.times = state, [time, time + 1.0]
        if lagrange.num_constraints:
            lagrange.set_dependent_initial_conditions()
        state |= lagrange.initial_conditions
        found = dict(
            zip(
                lagrange.states,
                lagrange.evaluate_ode([state[s] for s in lagrange.states], time),
                strict=True,
            )
        )
        known = {**numbers, **{c: state[c] for c in q}, T: time}
        moving = [rates[c].xreplace({**names, **known}) - state[c.diff(T)] for c in q]
        speeds = sm.Matrix.LUsolve(*sm.linear_eq_to_matrix(moving, list(names.values())))
        x = [*(state[c] for c in q), *map(float, speeds)]
        expected = dict(zip(kane.outputs_symbols, kane.evaluate_outputs(x, time), strict=True))
        close(
            [found[c.diff(T)] for c in q],
            [expected[s] for s in kane.outputs_symbols if s.name.startswith("a_")],
            1e-12,
        )


@pytest.mark.parametrize("order", ["XYZ", "ZYX", "ZXZ"])
@pytest.mark.parametrize("fixed", ["body", "space"])
def test_kinematic_equations_are_solved_where_sympys_pivots_are_zero(order, fixed):
    """For speeds along axes at rest, SymPy divides by sums that it cannot see to be zero."""
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    frame = me.ReferenceFrame("N")
    turned = frame.orientnew("A", "Body", q, order)
    axes = turned if fixed == "body" else frame
    rate = turned.ang_vel_in(frame)
    kinematic = [rate.dot(axis) - speed for axis, speed in zip(axes, u, strict=True)]
    turned.set_ang_vel(frame, sum((s * a for s, a in zip(u, axes, strict=True)), me.Vector(0)))
    centre = me.Point("C")
    centre.set_vel(frame, 0)
    inertia = me.inertia(turned, 1, 2, 3)
    body = me.RigidBody("body", centre, turned, 1, (inertia, centre))
    kane = me.KanesMethod(frame, q, u, kd_eqs=kinematic)
    kane.kanes_equations([body], [])
    state = np.array([0.3, 0.4, 0.5, 0.1, 0.2, 0.3])
    rates = System(kane).evaluate_ode(state)
    known = dict(zip([*(s.diff() for s in q), *u], [*rates[:3], *state[3:]], strict=True))
    for row in kinematic:
        left = row.subs(known).subs(dict(zip(q, state[:3], strict=True)))
        assert float(left) == pytest.approx(0.0, abs=1e-14)
