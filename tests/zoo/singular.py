"""Mechanisms whose constraints are badly scaled, or pass through singular configurations."""

from functools import cache
from typing import Any, NamedTuple

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from zoo import inertial_frame

__all__ = ["Singular", "bead", "bricard", "defined_windows", "n_four_bar", "slider_crank"]

T = me.dynamicsymbols._t


class Singular(NamedTuple):
    """A system, and how far a state is from the nearest singular configuration, in radians."""

    system: Any
    distance: Any


@cache
def _bead(form):
    """A bead on a circle of radius R that touches the origin from above, under gravity."""
    x, y, v, w = me.dynamicsymbols("x y v w")
    m, g, R = sm.symbols("m g R", positive=True)
    frame, place = me.ReferenceFrame("N"), me.Point("P")
    place.set_vel(frame, v * frame.x + w * frame.y)
    row = x**2 + (y - R) ** 2 - R**2
    if form == "root":
        row = sm.sqrt(x**2 + (y - R) ** 2) - R
    rates = {x.diff(T): v, y.diff(T): w}
    kane = me.KanesMethod(
        frame, [x], [v],
        kd_eqs=[x.diff(T) - v, y.diff(T) - w],
        q_dependent=[y], configuration_constraints=[row],
        u_dependent=[w], velocity_constraints=[row.diff(T).xreplace(rates)],
    )  # fmt: skip
    kane.kanes_equations([me.Particle("bead", place, m)], [(place, -m * g * frame.y)])
    return kane


def bead(form, radius, start=1.0, speed=0.0):
    """A bead on a wire, x² + (y − R)² = R² or its root; where x is R its y is no longer a
    function of x, which is the only singular configuration.
    """
    kane = _bead(form)
    x, _ = kane.q
    system = System(
        kane,
        constants=dict(zip(sm.symbols("m g R", positive=True), (1.3, 9.81, radius), strict=True)),
        initial_conditions={x: start, kane.u[0]: speed},
    )
    system.set_dependent_initial_conditions()
    return Singular(system, lambda state: abs(abs(state[0] / radius) - 1.0))


def _rod(frame, name, start, angle, rate, length, mass):
    """A uniform rod that begins at a point; returns the body and the point at its end."""
    body = frame.orientnew(name, "Axis", (angle, frame.z))
    body.set_ang_vel(frame, rate * frame.z)
    centre = start.locatenew(f"{name}c", length / 2 * body.x)
    centre.v2pt_theory(start, frame, body)
    end = start.locatenew(f"{name}e", length * body.x)
    end.v2pt_theory(start, frame, body)
    inertia = (me.inertia(body, 0, 0, mass * length**2 / 12), centre)
    return me.RigidBody(name, centre, body, mass, inertia), end


class Windows(NamedTuple):
    """The parts of a chain of four-bars: posts at angles a, beams at angles b."""

    frame: me.ReferenceFrame
    coordinates: list[Any]
    speeds: list[Any]
    bodies: list[Any]
    loads: list[Any]
    rows: list[Any]
    rates: list[Any]


def chain_of_windows(n):
    """N windows of rods of equal length on the ground, in their absolute angles."""
    q = me.dynamicsymbols(f"a:{n + 1} b:{n}")
    u = me.dynamicsymbols(f"ua:{n + 1} ub:{n}")
    m, l, g = sm.symbols("m l g", positive=True)
    frame, origin = inertial_frame()
    bodies, tops = [], []
    for k in range(n + 1):
        foot = origin.locatenew(f"F{k}", k * l * frame.x)
        foot.set_vel(frame, 0)
        body, top = _rod(frame, f"post{k}", foot, q[k], u[k], l, m)
        bodies.append(body)
        tops.append(top)
    rows, rates = [], []
    for k in range(n):
        body, end = _rod(frame, f"beam{k}", tops[k], q[n + 1 + k], u[n + 1 + k], l, m)
        bodies.append(body)
        for axis in (frame.x, frame.y):
            rows.append(end.pos_from(tops[k + 1]).dot(axis))
            rates.append((end.vel(frame) - tops[k + 1].vel(frame)).dot(axis))
    loads = [(b.masscenter, -b.mass * g * frame.y) for b in bodies]
    return Windows(frame, list(q), list(u), bodies, loads, rows, rates)


def defined_windows(n):
    """The chain as a Definition, which finds for itself what depends on what."""
    parts = chain_of_windows(n)
    return Definition(
        parts.frame, parts.coordinates, parts.speeds,
        bodies=parts.bodies, loads=parts.loads, holonomic_constraints=parts.rows,
        kinematic_equations=[
            a.diff(T) - w for a, w in zip(parts.coordinates, parts.speeds, strict=True)
        ],
    )  # fmt: skip


@cache
def _n_four_bar(windows):
    frame, q, u, bodies, loads, rows, rates = chain_of_windows(windows)
    kane = me.KanesMethod(
        frame, q[:1], u[:1],
        kd_eqs=[a.diff(T) - w for a, w in zip(q, u, strict=True)],
        q_dependent=q[1:], configuration_constraints=rows,
        u_dependent=u[1:], velocity_constraints=rates,
        constraint_solver="CRAMER",
    )  # fmt: skip
    kane.kanes_equations(bodies, loads)
    return kane


def n_four_bar(windows, speed=1.0):
    """The benchmark of the IFToMM library: upright, and its top pushed at 1 m/s.

    All rods lie on one line at a = 0 and a = π: there it gains a degree of freedom a window.
    """
    kane = _n_four_bar(windows)
    n = windows
    start = dict.fromkeys(kane.q[: n + 1], np.pi / 2) | dict.fromkeys(kane.q[n + 1 :], 0.0)
    start |= dict.fromkeys(kane.u[: n + 1], -speed) | dict.fromkeys(kane.u[n + 1 :], 0.0)
    constants = dict(zip(sm.symbols("m l g", positive=True), (1.0, 1.0, 9.81), strict=True))
    system = System(kane, constants=constants, initial_conditions=start)
    return Singular(system, lambda state: np.abs(np.sin(state[: 2 * n + 1])).max())


@cache
def _slider_crank():
    a, b, s, ua, ub, v = me.dynamicsymbols("a b s ua ub v")
    m, r, l, g = sm.symbols("m r l g", positive=True)
    frame, origin = inertial_frame()
    crank, pin = _rod(frame, "crank", origin, a, ua, r, m)
    coupler, end = _rod(frame, "coupler", pin, b, ub, l, m)
    piston = origin.locatenew("P", s * frame.x)
    piston.set_vel(frame, v * frame.x)
    gap = end.pos_from(piston)
    speed = end.vel(frame) - piston.vel(frame)
    kane = me.KanesMethod(
        frame, [a], [ua],
        kd_eqs=[a.diff(T) - ua, b.diff(T) - ub, s.diff(T) - v],
        q_dependent=[b, s], configuration_constraints=[gap.dot(e) for e in (frame.x, frame.y)],
        u_dependent=[ub, v], velocity_constraints=[speed.dot(e) for e in (frame.x, frame.y)],
        constraint_solver="CRAMER",
    )  # fmt: skip
    bodies = [crank, coupler, me.Particle("piston", piston, m)]
    loads = [(b.masscenter, -m * g * frame.y) for b in bodies]
    kane.kanes_equations(bodies, loads)
    return kane


def slider_crank(coupler=1.0, speed=4.0):
    """A crank of length 1 m and its piston. With a coupler as long as the crank the piston may
    stay at the shaft once the crank is upright, which is its singular configuration.
    """
    kane = _slider_crank()
    a, b, s = kane.q
    constants = dict(
        zip(sm.symbols("m r l g", positive=True), (1.0, 1.0, coupler, 9.81), strict=True)
    )
    angle = np.pi / 4
    start = {a: angle, kane.u[0]: speed, b: -np.arcsin(np.sin(angle) / coupler), s: 1.4}
    system = System(kane, constants=constants, initial_conditions=start)
    system.set_dependent_initial_conditions()
    return Singular(system, lambda state: abs(np.cos(state[0])))


@cache
def _bricard(rows):
    """Six rods along a cube's edges, the last one fixed, and a hinge at each corner."""
    q, u = me.dynamicsymbols("q1:6"), me.dynamicsymbols("u1:6")
    m, l, g = sm.symbols("m l g", positive=True)
    ground, origin = inertial_frame()
    # Directions of the rods in the cube, and of the hinges where they begin.
    edges = [(1, 0, 0), (0, -1, 0), (0, 0, 1), (-1, 0, 0), (0, 1, 0), (0, 0, -1)]
    hinges = [tuple(np.cross(edges[k - 1], edges[k])) for k in range(6)]

    def along(frame, v):
        return sum(int(c) * e for c, e in zip(v, frame, strict=True))

    bodies, frame, place = [], ground, origin
    for k in range(5):
        axis = along(frame, hinges[k])
        body = frame.orientnew(f"B{k + 1}", "Axis", (q[k], axis))
        body.set_ang_vel(frame, u[k] * axis)
        direction = along(body, edges[k])
        centre = place.locatenew(f"C{k + 1}", l / 2 * direction)
        centre.v2pt_theory(place, ground, body)
        end = place.locatenew(f"P{k + 1}", l * direction)
        end.v2pt_theory(place, ground, body)
        moments = [0 if e else m * l**2 / 12 for e in edges[k]]
        inertia = (me.inertia(body, *moments), centre)
        bodies.append(me.RigidBody(f"rod{k + 1}", centre, body, m, inertia))
        frame, place = body, end
    closing = along(frame, hinges[5])
    gap = place.pos_from(origin) - l * ground.z
    turned = frame.ang_vel_in(ground)
    across = [e for e in (ground.x, ground.y, ground.z) if along(ground, hinges[5]).dot(e) == 0]
    all_rows = [gap.dot(e) for e in (ground.x, ground.y, ground.z)]
    all_rows += [closing.dot(e) for e in across]
    all_rates = [place.vel(ground).dot(e) for e in (ground.x, ground.y, ground.z)]
    all_rates += [turned.cross(closing).dot(e) for e in across]
    kane = me.KanesMethod(
        ground, q[:1], u[:1],
        kd_eqs=[a.diff(T) - w for a, w in zip(q, u, strict=True)],
        q_dependent=q[1:], configuration_constraints=[all_rows[k] for k in rows],
        u_dependent=u[1:], velocity_constraints=[all_rates[k] for k in rows],
        constraint_solver="CRAMER",
    )  # fmt: skip
    kane.kanes_equations(bodies, [(b.masscenter, -b.mass * g * ground.y) for b in bodies])
    return kane, all_rows


def bricard(rows=(0, 1, 2, 3)):
    """The benchmark of the IFToMM library: one degree of freedom, whatever Grübler counts.

    Four of five rows hold it, but where these lose rank.
    """
    kane, _ = _bricard(rows)
    constants = dict(zip(sm.symbols("m l g", positive=True), (1.0, 1.0, 9.81), strict=True))
    system = System(kane, constants=constants)
    return Singular(system, None)
