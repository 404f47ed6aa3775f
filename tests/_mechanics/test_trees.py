"""Random trees of bodies against Newton's and Euler's equations, written down with NumPy."""

from dataclasses import dataclass

import numpy as np
import pytest
import sympy.physics.mechanics as me
from scipy.spatial.transform import Rotation

from pydy._graph.interpret import run
from pydy._graph.lower import lower
from pydy._mechanics.form import forms
from pydy._mechanics.kane import multibody_of_kane
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
            )
        )
    return links


def as_vector(numbers, frame):
    return sum((float(n) * e for n, e in zip(numbers, frame, strict=True)), 0 * frame.x)


def as_kane(links, *, set_velocities):
    """The tree for SymPy; velocities are said in some way, or not at all."""
    n = len(links)
    q, u = me.dynamicsymbols(f"q:{n}"), me.dynamicsymbols(f"u:{n}")
    ground, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(ground, 0)
    frames, joints, bodies, loads = [], [], [], []
    for k, link in enumerate(links):
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
        if set_velocities and not link.slides:
            joint.v2pt_theory(start, ground, base)
            centre.v2pt_theory(joint, ground, frame)
        elif set_velocities:
            joint.set_vel(base, u[k] * axis)
            carried = base.ang_vel_in(ground).cross(way)
            joint.set_vel(ground, start.vel(ground) + carried + u[k] * axis)
            centre.v2pt_theory(joint, ground, frame)
        i = link.inertia
        own = me.inertia(frame, i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[1, 2], i[2, 0])
        bodies.append(me.RigidBody(f"b{k}", centre, frame, link.mass, (own, centre)))
        loads.append((centre, as_vector(link.mass * GRAVITY, ground)))
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
        inertia = turn @ link.inertia @ turn.T
        of_centre = acc + np.cross(alpha, arm) + np.cross(w, np.cross(w, arm))
        forces.append(link.mass * (of_centre - GRAVITY))
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


@pytest.mark.parametrize(
    ("seed", "n", "set_velocities"),
    [(0, 4, True), (1, 7, True), (2, 7, False), (3, 12, False), (4, 29, False)],
)
def test_random_trees_obey_newtons_and_eulers_equations(seed, n, set_velocities):
    links = random_tree(seed, n)
    body = multibody_of_kane(as_kane(links, set_velocities=set_velocities))
    rng = np.random.default_rng(seed)
    x = rng.uniform(-1.0, 1.0, 2 * n)
    for in_bodies in (True, False):
        for formed in forms(body, in_bodies=in_bodies):
            graph, solved = formed.graph, formed.accelerations
            assert formed.honoured == ()
            if solved is None:
                solved = graph.solve(formed.matrix, [formed.forcing], "ldl")[0]
            program = lower(graph, (2 * n, 0, 0), [("a", (n,), solved)])
            out, failed = run(program, np.zeros(1), x[None], np.empty((1, 0)), np.empty(0))
            assert not failed.any()
            missing, size = imbalance(links, x[:n], x[n:], out[0])
            np.testing.assert_array_less(abs(missing), 1e-10 * size.max())
