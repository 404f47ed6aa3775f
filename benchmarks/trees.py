"""Accelerations of trees of bodies against Pinocchio's and MuJoCo's, which share no line with ours.

A chain in space, a branched tree of 29 joints like a humanoid's, and a floating base with a
quaternion; general inertias, offset mass centres, random joint axes, torques, gravity on a slant.
Fails where the largest difference is above 1e-11 of the largest acceleration.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System

GRAVITY = (0.3, -0.2, -9.81)
TOLERANCE = 1e-11
# Parents of the joints: two legs of six, a torso of three, two arms of seven.
HUMANOID = [
    *(-1, 0, 1, 2, 3, 4, -1, 6, 7, 8, 9, 10, -1, 12, 13),
    *(14, 15, 16, 17, 18, 19, 20, 14, 22, 23, 24, 25, 26, 27),
]


def tree(
    parents: list[int],
    rng: np.random.Generator,
    *,
    floating: bool = False,
    aligned: bool = False,
) -> dict[str, Any]:
    """Return a tree of revolute joints, about random axes or x, y and z, and a state."""
    links = []
    for k, parent in enumerate(parents):
        free = floating and k == 0
        axis = np.eye(3)[k % 3] if aligned else rng.normal(size=3)
        half = rng.normal(size=(3, 3))
        size = half @ half.T + np.eye(3)  # with products, and the triangle inequality held
        size = np.trace(size) * np.eye(3) - size
        links.append(
            {
                "parent": parent,
                "axis": None if free else list(axis / np.linalg.norm(axis)),
                "turn": [0.0] * 3 if free or aligned else list(rng.normal(size=3)),
                "place": [0.0] * 3 if free else list(rng.normal(size=3)),
                "mass": rng.uniform(0.5, 2.0),
                "centre": list(rng.normal(size=3) / 3),
                "inertia": [
                    size[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))
                ],
            }
        )
    joints = len(parents) - floating
    q, v = list(rng.normal(size=joints)), list(rng.normal(size=joints + 6 * floating))
    if floating:
        quaternion = rng.normal(size=4)
        q = [*rng.normal(size=3), *quaternion / np.linalg.norm(quaternion), *q]
    return {"links": links, "q": q, "v": v, "torques": list(rng.normal(size=len(v)))}


def definition(made: dict[str, Any]) -> Definition:
    """Return the tree as bodies, loads and kinematics."""
    floating = made["links"][0]["axis"] is None
    n = len(made["links"]) - floating
    q, u = list(me.dynamicsymbols(f"q:{n}")), list(me.dynamicsymbols(f"u:{n}"))
    world, rest = me.ReferenceFrame("N"), me.Point("O")
    rest.set_vel(world, 0)
    frames, points, bodies, loads = [world], [rest], [], []
    kinematic = [a.diff() - b for a, b in zip(q, u, strict=True)]
    coordinates, speeds, torques = q, u, list(made["torques"])
    for k, link in enumerate(made["links"]):
        above, point = frames[link["parent"] + 1], points[link["parent"] + 1]
        own = me.ReferenceFrame(f"B{k}")
        if link["axis"] is None:
            p, e = list(me.dynamicsymbols("p:3")), list(me.dynamicsymbols("e:4"))
            v, w = list(me.dynamicsymbols("v:3")), list(me.dynamicsymbols("w:3"))
            own.orient_quaternion(above, e)
            spin = vector(w, own)
            own.set_ang_vel(above, spin)
            end = point.locatenew(f"P{k}", vector(p, above))
            end.set_vel(world, vector(v, own))
            rates = own.dcm(above).T * sm.Matrix(v)
            half = sm.Rational(1, 2)
            turning = [
                -half * (e[1] * w[0] + e[2] * w[1] + e[3] * w[2]),
                half * (e[0] * w[0] + e[2] * w[2] - e[3] * w[1]),
                half * (e[0] * w[1] + e[3] * w[0] - e[1] * w[2]),
                half * (e[0] * w[2] + e[1] * w[1] - e[2] * w[0]),
            ]
            kinematic = [
                *(a.diff() - b for a, b in zip([*p, *e], [*rates, *turning], strict=True)),
                *kinematic,
            ]
            coordinates, speeds = [*p, *e, *q], [*v, *w, *u]
            loads += [(end, vector(torques[:3], own)), (own, vector(torques[3:6], own))]
            torques = torques[6:]
        else:
            fixed, angle = above, float(np.linalg.norm(link["turn"]))
            if angle:
                fixed = me.ReferenceFrame(f"F{k}")
                fixed.orient_axis(above, vector(link["turn"], above).normalize(), angle)
            axis, place = vector(link["axis"], fixed), k - floating
            own.orient_axis(fixed, axis, q[place])
            own.set_ang_vel(fixed, u[place] * axis)
            end = point.locatenew(f"P{k}", vector(link["place"], above))
            loads += [(own, torques[place] * axis), (above, -torques[place] * axis)]
        centre = end.locatenew(f"C{k}", vector(link["centre"], own))
        inertia = me.inertia(own, *link["inertia"])
        bodies.append(me.RigidBody(f"b{k}", centre, own, link["mass"], (inertia, centre)))
        loads.append((centre, link["mass"] * vector(GRAVITY, world)))
        frames.append(own)
        points.append(end)
    return Definition(
        world, coordinates, speeds, bodies=bodies, loads=loads, kinematic_equations=kinematic
    )


def rods(n: int) -> Definition:
    """Return a chain of rods in space: a universal joint, then ball joints.

    Angles are body-fixed x-y-z against the rod before, speeds the relative angular velocity in the
    outer rod's axes.
    """
    frame = above = me.ReferenceFrame("N")
    joint = me.Point("O")
    joint.set_vel(frame, 0)
    g = sm.Symbol("g")
    q, u, rates, bodies, loads = [], [], [], [], []
    for k in range(n):
        m, length, *inertias = sm.symbols(f"m{k} l{k} A{k} B{k} C{k}")
        own = me.ReferenceFrame(f"B{k}")
        a, b, c = me.dynamicsymbols(f"a{k} b{k} c{k}")
        x, y, z = me.dynamicsymbols(f"u{k} v{k} w{k}")
        if k:
            own.orient_body_fixed(above, (a, b, c), "123")
            own.set_ang_vel(above, x * own.x + y * own.y + z * own.z)
            across = (x * sm.cos(c) - y * sm.sin(c)) / sm.cos(b)
            rates += [across, x * sm.sin(c) + y * sm.cos(c), z - sm.sin(b) * across]
            q += [a, b, c]
            u += [x, y, z]
        else:
            fork = me.ReferenceFrame("F")
            fork.orient_axis(above, above.x, a)
            fork.set_ang_vel(above, x * above.x)
            own.orient_axis(fork, fork.y, b)
            own.set_ang_vel(fork, y * fork.y)
            rates += [x, y]
            q += [a, b]
            u += [x, y]
        centre = joint.locatenew(f"C{k}", -length / 2 * own.z)
        joint = joint.locatenew(f"O{k}", -length * own.z)
        bodies.append(me.RigidBody(f"rod{k}", centre, own, m, (me.inertia(own, *inertias), centre)))
        loads.append((centre, -m * g * frame.z))
        above = own
    kinematic = [i.diff() - rate for i, rate in zip(q, rates, strict=True)]
    return Definition(frame, q, u, bodies=bodies, loads=loads, kinematic_equations=kinematic)


def vector(components: Any, frame: me.ReferenceFrame) -> me.Vector:
    """Return a vector from its components."""
    return sum((c * e for c, e in zip(components, frame, strict=True) if c != 0), me.Vector(0))


def main() -> int:
    """Compare; return how many trees differ."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--peer-python", default=sys.executable)
    options = parser.parse_args()
    rng = np.random.default_rng(3)
    cases = {
        "chain of 12 joints": tree(list(range(-1, 11)), rng),
        "tree of 29 joints": tree(HUMANOID, rng),
        "the same about x, y and z": tree(HUMANOID, rng, aligned=True),
        "floating base with 8 joints": tree([-1, 0, 1, 2, 3, 0, 5, 6, 0], rng, floating=True),
    }
    worker = Path(__file__).parent / "workers" / "trees.py"
    done = subprocess.run(
        [options.peer_python, str(worker)],
        input=json.dumps(list(cases.values())),
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        sys.exit(done.stderr)
    failed = 0
    for (name, made), peers in zip(cases.items(), json.loads(done.stdout), strict=True):
        system = System(definition(made))
        found = system.evaluate_ode([*made["q"], *made["v"]])[len(made["q"]) :]
        for peer, expected in zip(("Pinocchio", "MuJoCo"), peers, strict=True):
            difference = np.abs(found - expected).max() / np.abs(expected).max()
            failed += difference > TOLERANCE
            print(f"{name}: largest difference from {peer} {difference:.1e} of the largest")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
