"""Random trees of bodies, for SymPy's KanesMethod and for Newton's and Euler's laws with NumPy."""

from dataclasses import dataclass

import numpy as np
import sympy.physics.mechanics as me
from scipy.spatial.transform import Rotation

from pydy._graph.interpret import run
from pydy._graph.lower import lower
from zoo import T

GRAVITY = np.array([0.3, -0.4, -9.2])
AXES = np.eye(3)


@dataclass
class Link:
    """A body on a joint that turns or slides along an axis of its parent's frame."""

    parent: int
    axis: int
    slides: bool
    joint: np.ndarray  # in the parent's axes, from the parent's joint
    centre: np.ndarray  # in the body's own axes, from its joint
    mass: float
    inertia: np.ndarray  # about the mass centre, in the body's own axes
    torque: float
    push: np.ndarray  # a force at the mass centre, in the body's own axes
    said: bool = True  # whether the user sets the velocities, if those before are set
    referred: bool = False  # the inertia to the joint in place of the mass centre
    skewed: bool = False  # the inertia in axes of its own, fixed in the body
    particle: bool = False


def random_tree(seed, n, share_of_slides=0.3):
    rng = np.random.default_rng(seed)
    links = []
    for k in range(n):
        root = rng.normal(size=(3, 3))
        slides = bool(rng.random() < share_of_slides)
        links.append(
            Link(
                parent=int(rng.integers(max(k - 4, -1), k)) if k else -1,
                axis=int(rng.integers(3)),
                slides=slides,
                joint=rng.normal(size=3),
                centre=rng.normal(size=3),
                mass=float(rng.uniform(0.5, 2.0)),
                inertia=root @ root.T + np.eye(3),
                torque=0.0 if slides else float(rng.normal()),
                push=np.zeros(3),
            )
        )
    return links


def as_vector(numbers, frame):
    return sum((float(n) * e for n, e in zip(numbers, frame, strict=True)), 0 * frame.x)


def as_body(name, link, frame, joint, centre):
    """The body of a link, whose inertia may be referred to its joint, and to axes of its own."""
    if link.particle:
        return me.Particle(name, centre, link.mass)
    size, axes, about = link.inertia, frame, centre
    if link.referred:
        c = link.centre
        size, about = size + link.mass * (c @ c * np.eye(3) - np.outer(c, c)), joint
    if link.skewed:
        axes = me.ReferenceFrame(f"S{name}")
        turn = me.ReferenceFrame(f"T{name}")
        turn.orient_axis(frame, frame.z, 0.7)
        axes.orient_axis(turn, turn.x, -0.4)
        rotation = (
            Rotation.from_rotvec([0, 0, 0.7]) * Rotation.from_rotvec([-0.4, 0, 0])
        ).as_matrix()
        size = rotation.T @ size @ rotation
    own = me.inertia(axes, size[0, 0], size[1, 1], size[2, 2], size[0, 1], size[1, 2], size[2, 0])
    return me.RigidBody(name, centre, frame, link.mass, (own, about))


def as_kane(links, *, set_velocities):
    """The tree for SymPy; velocities are said in some way, or not at all."""
    n = len(links)
    q, u = me.dynamicsymbols(f"q:{n}"), me.dynamicsymbols(f"u:{n}")
    ground, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(ground, 0)
    frames, joints, bodies, loads, said = [], [], [], [], []
    for k, link in enumerate(links):
        said.append(set_velocities and link.said and (link.parent < 0 or said[link.parent]))
        base = ground if link.parent < 0 else frames[link.parent]
        start = origin if link.parent < 0 else joints[link.parent]
        axis = (base.x, base.y, base.z)[link.axis]
        frame = me.ReferenceFrame(f"B{k}")
        frame.orient_axis(base, axis, 0 if link.slides else q[k])
        if not link.slides:
            frame.set_ang_vel(base, u[k] * axis)
        way = as_vector(link.joint, base) + (q[k] * axis if link.slides else 0 * axis)
        joint = start.locatenew(f"J{k}", way)
        centre = joint.locatenew(f"C{k}", as_vector(link.centre, frame))
        if said[k] and not link.slides:
            joint.v2pt_theory(start, ground, base)
            centre.v2pt_theory(joint, ground, frame)
        elif said[k]:
            joint.set_vel(base, u[k] * axis)
            carried = base.ang_vel_in(ground).cross(way)
            joint.set_vel(ground, start.vel(ground) + carried + u[k] * axis)
            centre.v2pt_theory(joint, ground, frame)
        bodies.append(as_body(f"b{k}", link, frame, joint, centre))
        loads.append((centre, as_vector(link.mass * GRAVITY, ground)))
        if link.push.any():
            loads.append(me.Force(centre, as_vector(link.push, frame)))
        if link.torque:
            loads += [(frame, link.torque * axis)]
            loads += [(base, -link.torque * axis)] if base is not ground else []
        frames.append(frame)
        joints.append(joint)
    return me.KanesMethod(
        ground,
        q,
        u,
        kd_eqs=[a.diff(T) - b for a, b in zip(q, u, strict=True)],
        bodies=bodies,
        forcelist=loads,
        kd_eqs_solver=lambda a, b: b,
    )


def imbalance(links, q, u, a):
    """Return for each joint the force that Newton's and Euler's equations miss, and its size."""
    turns, spins, twists, places, accelerations = [], [], [], [], []
    forces, moments, centres, axes = [], [], [], []
    rest = (np.eye(3), np.zeros(3), np.zeros(3), np.zeros(3), np.zeros(3))
    for k, link in enumerate(links):
        p = link.parent
        kept = (turns, spins, twists, places, accelerations)
        turn, w, alpha, place, acc = rest if p < 0 else (part[p] for part in kept)
        axis = turn @ AXES[link.axis]
        way = turn @ link.joint + (axis * q[k] if link.slides else 0.0)
        acc = acc + np.cross(alpha, way) + np.cross(w, np.cross(w, way))
        place = place + way
        if link.slides:
            acc = acc + 2 * np.cross(w, axis * u[k]) + axis * a[k]
        else:
            alpha = alpha + axis * a[k] + np.cross(w, axis * u[k])
            w = w + axis * u[k]
            turn = turn @ Rotation.from_rotvec(AXES[link.axis] * q[k]).as_matrix()
        arm = turn @ link.centre
        inertia = (not link.particle) * turn @ link.inertia @ turn.T
        of_centre = acc + np.cross(alpha, arm) + np.cross(w, np.cross(w, arm))
        forces.append(link.mass * (of_centre - GRAVITY) - turn @ link.push)
        moments.append(inertia @ alpha + np.cross(w, inertia @ w))
        centres.append(place + arm)
        axes.append(axis)
        for part, value in zip(kept, (turn, w, alpha, place, acc), strict=True):
            part.append(value)
    found, size = np.zeros(len(links)), np.zeros(len(links))
    for k, link in enumerate(links):
        parts = [-link.torque]
        for i in range(k, len(links)):
            j = i
            while j > k:
                j = links[j].parent
            if j == k:
                moment = moments[i] + np.cross(centres[i] - places[k], forces[i])
                parts.append(axes[k] @ (forces[i] if link.slides else moment))
        found[k], size[k] = sum(parts), np.abs(parts).sum()
    return found, size


def accelerations(formed, x):
    """u' of formed equations without constants at one state, from the interpreter."""
    graph, solved, n = formed.graph, formed.accelerations, len(formed.forcing)
    if solved is None:
        solved = graph.solve(formed.matrix, [formed.forcing], "ldl")[0]
    program = lower(graph, (2 * n, 0, 0), [("a", (n,), solved)])
    out, failed = run(program, np.zeros(1), x[None], np.empty((1, 0)), np.empty(0))
    assert not failed.any()
    return out[0]
