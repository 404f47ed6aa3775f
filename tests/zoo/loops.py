"""Closed loops with more constraints than their rank, and with positions where the rank falls.

The first is IFToMM's benchmark of a mechanism that is always redundantly constrained; most others
pass positions in which they could change over to another branch.
"""

from copy import copy
from functools import cache

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from zoo import inertial_frame

GRAVITY = sm.Symbol("g")


def system_of(name, times, solver, **shape):
    """A System of one of these, whose equations are formed once, in a state that closes it."""
    system = copy(_closed(name, **shape))
    system.constants = dict(system.constants)
    system.initial_conditions = dict(system.initial_conditions)
    system.times, system.ode_solver = times, solver
    return system


@cache
def _closed(name, **shape):
    definition, start = globals()[name](**shape)
    system = System(definition, {GRAVITY: 9.81}, initial_conditions=start)
    system.set_dependent_initial_conditions()
    return system


def _chain(axes, arms):
    """Uniform rods of unit mass, each turning about an axis of the one before it."""
    frame, point = inertial_frame()
    inertial, origin = frame, point
    q = list(me.dynamicsymbols(f"q1:{len(axes) + 1}"))
    u = list(me.dynamicsymbols(f"u1:{len(axes) + 1}"))
    bodies = []
    for k, (axis, arm) in enumerate(zip(axes, arms, strict=True)):
        own = me.ReferenceFrame(f"B{k}")
        own.orient_axis(frame, getattr(frame, axis), q[k])
        own.set_ang_vel(frame, u[k] * getattr(frame, axis))
        reach = arm[0] * own.x + arm[1] * own.y + arm[2] * own.z
        centre = point.locatenew(f"C{k}", reach / 2)
        square = sum(a * a for a in arm)
        inertia = me.inertia(own, *(sm.Rational(square - a * a) / 12 for a in arm))
        bodies.append(me.RigidBody(f"rod{k}", centre, own, 1, (inertia, centre)))
        point, frame = point.locatenew(f"E{k}", reach), own
    return inertial, origin, q, u, bodies, frame, point


def _defined(frame, q, u, bodies, rows):
    loads = [(b.masscenter, -b.mass * GRAVITY * frame.y) for b in bodies]
    return Definition(frame, q, u, bodies=bodies, loads=loads, holonomic_constraints=rows)


def bricard(edges=(1, 1, 1), rate=0.0):
    """Bricard's mechanism: six revolute joints on edges of a box, five rows of rank four."""
    a, b, c = edges
    arms = [(a, 0, 0), (0, b, 0), (0, 0, c), (-a, 0, 0), (0, -b, 0)]
    frame, origin, q, u, bodies, last, end = _chain("yzxyz", arms)
    gap = end.pos_from(origin) - c * frame.z
    rows = [gap.dot(e) for e in frame] + [last.x.dot(frame.y), last.x.dot(frame.z)]
    return _defined(frame, q, u, bodies, rows), dict.fromkeys(q, 0.0) | dict.fromkeys(u, rate)


def parallelogram(rate=6.0, crank=1, base=2, angle=np.pi / 3):
    """A parallelogram of four revolutes, all five rows of the last one, along skew axes."""
    arms = [(crank, 0, 0), (base, 0, 0), (crank, 0, 0)]
    frame, origin, q, u, bodies, last, end = _chain("zzz", arms)
    skew = me.ReferenceFrame("S")
    skew.orient_body_fixed(frame, (0.3, 0.5, 0.7), "123")
    gap = end.pos_from(origin) - base * frame.x
    rows = [gap.dot(e) for e in skew] + [last.z.cross(frame.z).dot(e) for e in (skew.x, skew.y)]
    angles = (angle, -angle, angle - np.pi)
    start = dict(zip([*q, *u], [*angles, rate, -rate, rate], strict=True))
    return _defined(frame, q, u, bodies, rows), start


def spatial_four_bar(rate=3.0, lengths=(1.0, 1.5), twist=0.5, angle=0.9):
    """Bennett's linkage: four revolutes in space, whose five rows have rank two."""
    frame, point = inertial_frame()
    inertial, origin = frame, point
    q, u = list(me.dynamicsymbols("q1:4")), list(me.dynamicsymbols("u1:4"))
    twists = (twist, float(np.arcsin(lengths[1] / lengths[0] * np.sin(twist))))
    bodies = []
    for k in range(4):
        length, twist = lengths[k % 2], twists[k % 2]
        own = me.ReferenceFrame(f"B{k}")
        if k < 3:  # the fourth link is the ground
            own.orient_axis(frame, frame.z, q[k])
            own.set_ang_vel(frame, u[k] * frame.z)
            centre = point.locatenew(f"C{k}", length / 2 * own.x)
            flat = length**2 / 12
            inertia = me.inertia(own, 0, flat, flat)
            bodies.append(me.RigidBody(f"rod{k}", centre, own, 1, (inertia, centre)))
            point = point.locatenew(f"E{k}", length * own.x)
            frame = me.ReferenceFrame(f"J{k}")
            frame.orient_axis(own, own.x, twist)
    # The ground's own link leads from the last joint back to the first.
    length, twist = lengths[1], twists[1]
    back = me.ReferenceFrame("J3")
    back.orient_axis(inertial, inertial.x, -twist)
    target = origin.locatenew("F", -length * inertial.x)
    gap = point.pos_from(origin) - target.pos_from(origin)
    rows = [gap.dot(e) for e in inertial] + [frame.z.dot(back.x), frame.z.dot(back.y)]
    half = np.sin(sum(twists) / 2) / np.sin((twists[1] - twists[0]) / 2) / np.tan(angle / 2)
    start = dict(zip([*q, *u], [angle, 2 * np.arctan(half), -angle, rate, 0.0, -rate], strict=True))
    return _defined(inertial, q, u, bodies, rows), start


def three_cranks(rate=6.0, crank=1, base=1, angle=np.pi / 3):
    """A coupler on three parallel cranks: four rows of rank three."""
    frame, origin = inertial_frame()
    q, u = list(me.dynamicsymbols("q1:5")), list(me.dynamicsymbols("u1:5"))
    tips, bodies = [], []
    for k in range(4):
        own = me.ReferenceFrame(f"B{k}")
        own.orient_axis(frame, frame.z, q[k])
        own.set_ang_vel(frame, u[k] * frame.z)
        length = crank if k < 3 else 2 * base
        root = origin.locatenew(f"O{k}", k * base * frame.x) if k < 3 else tips[0]
        if k < 3:
            root.set_vel(frame, 0)
        centre = root.locatenew(f"C{k}", sm.Rational(length) / 2 * own.x)
        centre.v2pt_theory(root, frame, own)
        if k < 3:
            tips.append(root.locatenew(f"T{k}", crank * own.x))
            tips[-1].v2pt_theory(root, frame, own)
        flat = sm.Rational(length) ** 3 / 12
        inertia = me.inertia(own, 0, flat, flat)
        bodies.append(me.RigidBody(f"rod{k}", centre, own, length, (inertia, centre)))
    along = bodies[3].frame.x
    gaps = [tips[k].pos_from(tips[0]) - k * base * along for k in (1, 2)]
    rows = [gap.dot(e) for gap in gaps for e in (frame.x, frame.y)]
    start = dict(zip([*q, *u], [*[angle] * 3, 0.0, *[rate] * 3, 0.0], strict=True))
    return _defined(frame, q, u, bodies, rows), start


def kite(rate=4.0, angle=1.0):
    """A four-bar of two short and two long neighbours: the long ones may fold together."""
    arms = [(1, 0, 0), (1, 0, 0), (2, 0, 0)]
    frame, origin, q, u, bodies, _, end = _chain("zzz", arms)
    rows = [(end.pos_from(origin) - 2 * frame.x).dot(e) for e in (frame.x, frame.y)]
    # It is symmetric to the line from the crank's tip to the other bearing.
    tip = np.exp(1j * angle)
    side = (2 - tip) / abs(2 - tip)
    second = np.angle(-tip.conjugate() * side**2)
    places = [angle, second - angle, np.angle(2 - tip - np.exp(1j * second)) - second]
    start = dict(zip([*q, *u], [*places, rate, 0.0, 0.0], strict=True))
    return _defined(frame, q, u, bodies, rows), start


def even_slider_crank(rate=6.0, angle=0.7):
    """Crank and rod of one length: with the slider at the crank's bearing both turn on it alone."""
    frame, origin = inertial_frame()
    q, u = list(me.dynamicsymbols("q1:4")), list(me.dynamicsymbols("u1:4"))
    bodies, point = [], origin
    for k in range(2):
        own = me.ReferenceFrame(f"B{k}")
        own.orient_axis(frame, frame.z, q[k])
        own.set_ang_vel(frame, u[k] * frame.z)
        centre = point.locatenew(f"C{k}", own.x / 2)
        flat = sm.Rational(1, 12)
        inertia = me.inertia(own, 0, flat, flat)
        bodies.append(me.RigidBody(f"rod{k}", centre, own, 1, (inertia, centre)))
        point = point.locatenew(f"E{k}", own.x)
    slider = origin.locatenew("S", q[2] * frame.x)
    bodies.append(me.Particle("slider", slider, sm.Rational(1, 2)))
    rows = [point.pos_from(slider).dot(e) for e in (frame.x, frame.y)]
    places = [angle, -angle, 2 * np.cos(angle), rate, -rate, 0.0]
    return _defined(frame, q, u, bodies, rows), dict(zip([*q, *u], places, strict=True))


def engine(crank=0.05, rod=0.2):
    """Crank and rod of an engine, of SI size, with the gas force F on the piston and a torque T."""
    frame, origin = inertial_frame()
    q, u = me.dynamicsymbols("q1 q2"), me.dynamicsymbols("u1 u2")
    turning, swinging = me.ReferenceFrame("C"), me.ReferenceFrame("R")
    turning.orient_axis(frame, frame.z, q[0])
    swinging.orient_axis(frame, frame.z, -q[1])
    pin = origin.locatenew("A", crank * turning.x)
    piston = pin.locatenew("B", rod * swinging.x)
    middle = pin.locatenew("G", rod / 2 * swinging.x)
    flywheel = (me.inertia(turning, 0, 0, 1e-3), origin)
    bodies = [
        me.RigidBody("crank", origin, turning, 1, flywheel),
        me.RigidBody("rod", middle, swinging, 0.5, (me.inertia(swinging, 0, 0, 2e-3), middle)),
        me.Particle("piston", piston, 0.4),
    ]
    loads = [(turning, sm.Symbol("T") * frame.z), (piston, -sm.Symbol("F") * frame.x)]
    closed = [crank * sm.sin(q[0]) - rod * sm.sin(q[1])]
    return Definition(frame, q, u, bodies=bodies, loads=loads, holonomic_constraints=closed)


def sarrus(rate=2.0, angle=0.6, unit=1):
    """Sarrus' linkage: two chains of three hinges lift a plate, six rows of rank five."""
    frame, origin = inertial_frame()
    q, u = list(me.dynamicsymbols("q1:7")), list(me.dynamicsymbols("u1:7"))
    bodies, middles, plates = [], [], []
    for chain, (axis, arm) in enumerate(("xz", "zx")):
        own, point = frame, origin.locatenew(f"A{chain}", unit * getattr(frame, arm))
        for j in range(3):
            above, own, k = own, me.ReferenceFrame(f"B{chain}{j}"), 3 * chain + j
            own.orient_axis(above, getattr(above, axis), q[k])
            own.set_ang_vel(above, u[k] * getattr(above, axis))
            if j == 2:
                break
            centre = point.locatenew(f"C{chain}{j}", unit * own.y / 2)
            inertia = me.inertia(own, *(unit**2 * sm.Rational(1, n) for n in (12, 50, 12)))
            bodies.append(me.RigidBody(f"link{chain}{j}", centre, own, 1, (inertia, centre)))
            point = point.locatenew(f"P{chain}{j}", unit * own.y)
        middle = point.locatenew(f"M{chain}", -unit * getattr(own, arm))
        inertia = me.inertia(own, *(unit**2 * sm.Rational(1, n) for n in (3, 2, 3)))
        bodies.append(me.RigidBody(f"half{chain}", middle, own, 1, (inertia, middle)))
        middles.append(middle)
        plates.append(own)
    a, b = plates
    rows = [middles[1].pos_from(middles[0]).dot(e) for e in frame]
    rows += [a.x.dot(b.y), a.y.dot(b.z), a.z.dot(b.x)]
    bent = np.array([1.0, -2.0, 1.0, -1.0, 2.0, -1.0])
    start = dict(zip([*q, *u], [*angle * bent, *rate * bent], strict=True))
    return _defined(frame, q, u, bodies, rows), start


SCHATZ = {
    # Denavit and Hartenberg's lengths of links, offsets along axes, and twists.
    "lengths": (0.0, 1.0, 1.0, 1.0, 0.0, 3.0**0.5),
    "offsets": (0.4, 0.0, 0.0, 0.0, 0.0, -0.4),
    "twists": (*[np.pi / 2] * 5, 0.0),
}


def schatz(unit=1.0, last=True):
    """Schatz's linkage, which turns all the way round: six hinges, six rows of rank five.

    The five rows that are kept lose rank at positions in which all together have theirs. The last
    link is the ground: a body of its own, or none, so that its speed moves no mass.
    """
    inertial, point = inertial_frame()
    origin, frame, bodies = point, inertial, []
    q, u = list(me.dynamicsymbols("q1:7")), list(me.dynamicsymbols("u1:7"))
    for k, (a, d, twist) in enumerate(zip(*SCHATZ.values(), strict=True)):
        turned, own = me.ReferenceFrame(f"X{k}"), me.ReferenceFrame(f"Z{k}")
        turned.orient_axis(frame, frame.z, q[k])
        turned.set_ang_vel(frame, u[k] * frame.z)
        own.orient_axis(turned, turned.x, sm.pi / 2 if twist else 0)
        point = point.locatenew(f"P{k}", unit * d * frame.z + unit * a * turned.x)
        inertia = me.inertia(own, *(unit**2 * i for i in (0.1, 0.12, 0.15)))
        if k < 5 or last:
            bodies.append(me.RigidBody(f"link{k}", point, own, 1 + 0.1 * k, (inertia, point)))
        frame = own
    rows = [point.pos_from(origin).dot(e) for e in inertial]
    rows += [frame.x.dot(inertial.y), frame.y.dot(inertial.z), frame.z.dot(inertial.x)]
    found = [-3.27477591, 0.5387395, -6.73531984, -4.21907166, 4.93845625, -1.83259898]
    start = dict(zip([*q, *u], [*found, 1.0, *[0.0] * 5], strict=True))
    loads = [(b.masscenter, -b.mass * GRAVITY * (inertial.z + 0.03 * inertial.x)) for b in bodies]
    return Definition(
        inertial, q, u, bodies=bodies, loads=loads, holonomic_constraints=rows, configuration=start
    ), start


def peaucellier(rate=0.3, angle=2.6):
    """Peaucellier and Lipkin's linkage, whose last joint moves along x = -27/8.

    Seven bars: a crank of length 1 about (-1, 0), two arms of length 3 about the origin, and a
    rhombus of sides 3/2. Where it folds into a line, it may change over to another motion.
    """
    frame, origin = inertial_frame()
    q, u = list(me.dynamicsymbols("q1:8")), list(me.dynamicsymbols("u1:8"))
    bodies = []

    def bar(start, length):
        k = len(bodies)
        own = me.ReferenceFrame(f"B{k}")
        own.orient_axis(frame, frame.z, q[k])
        own.set_ang_vel(frame, u[k] * frame.z)
        centre = start.locatenew(f"C{k}", length / 2 * own.x)
        inertia = me.inertia(own, 0, 0, length**2 / 12)
        bodies.append(me.RigidBody(f"bar{k}", centre, own, 1, (inertia, centre)))
        return start.locatenew(f"E{k}", length * own.x)

    side = sm.Rational(3, 2)
    tip = bar(origin.locatenew("Q", -frame.x), sm.Integer(1))
    above, below = bar(origin, sm.Integer(3)), bar(origin, sm.Integer(3))
    pairs = [(bar(tip, side), above), (bar(tip, side), below), (bar(above, side), bar(below, side))]
    rows = [a.pos_from(b).dot(e) for a, b in pairs for e in (frame.x, frame.y)]
    definition = _defined(frame, q, u, bodies, rows)
    corner = np.array([np.cos(angle) - 1.0, np.sin(angle)])
    along = corner / np.linalg.norm(corner)
    part = (9.0 - 2.25 + corner @ corner) / 2.0 / np.linalg.norm(corner)
    aside = np.sqrt(9.0 - part**2) * np.array([-along[1], along[0]])
    upper, lower = part * along + aside, part * along - aside
    last = upper + lower - corner
    spans = [upper, lower, upper - corner, lower - corner, last - upper, last - lower]
    angles = [angle, *(float(np.arctan2(s[1], s[0])) for s in spans)]
    return definition, dict(zip(q, angles, strict=True)) | {u[0]: rate}


def scissor_lift(stages, angle=0.6, configuration=None):
    """A lift of crossed bars: the bars of a stage could also lie on each other.

    Three rows for each stage, one of them redundant if its bars are crossed, all but two if not.
    """
    frame, origin = inertial_frame()
    q, u = (
        list(me.dynamicsymbols(f"q:{2 * stages + 1}")),
        list(me.dynamicsymbols(f"u:{2 * stages + 1}")),
    )
    left, right = origin, origin.locatenew("foot", q[0] * frame.x)
    bodies, rows = [me.Particle("foot", right, sm.Rational(1, 10))], []
    for k in range(stages):
        ends, middles = [], []
        for start, place in ((left, 2 * k + 1), (right, 2 * k + 2)):
            own = me.ReferenceFrame(f"B{place}")
            own.orient_axis(frame, frame.z, q[place])
            own.set_ang_vel(frame, u[place] * frame.z)
            centre = start.locatenew(f"C{place}", own.x)
            ends.append(start.locatenew(f"E{place}", 2 * own.x))
            middles.append(centre)
            inertia = me.inertia(own, 0, 0, sm.Rational(1, 3))
            bodies.append(me.RigidBody(f"bar{place}", centre, own, 1, (inertia, centre)))
        gap = middles[0].pos_from(middles[1])
        rows += [gap.dot(frame.x), gap.dot(frame.y), ends[0].pos_from(ends[1]).dot(frame.y)]
        right, left = ends
    loads = [(b.masscenter, -b.mass * GRAVITY * frame.y) for b in bodies]
    start = dict.fromkeys(u, 0.0) | {q[0]: 2 * np.cos(angle)}
    for k in range(stages):
        start |= {q[2 * k + 1]: angle, q[2 * k + 2]: np.pi - angle}
    definition = Definition(
        frame, q, u, bodies=bodies, loads=loads, holonomic_constraints=rows,
        configuration=start if configuration else None,
    )  # fmt: skip
    return definition, start
