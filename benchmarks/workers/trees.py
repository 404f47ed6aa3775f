"""Accelerations of trees by Pinocchio's articulated-body algorithm and by MuJoCo.

Reads the trees from standard input as JSON, and writes for each the accelerations of both:
``benchmarks/trees.py`` compares them.
"""

from __future__ import annotations

import json
import sys
from typing import Any

import mujoco
import numpy as np
import pinocchio as pin

GRAVITY = np.array([0.3, -0.2, -9.81])


def inertia(link: dict[str, Any]) -> Any:
    """Return the inertia about the mass centre, which is given as xx, yy, zz, xy, yz, zx."""
    xx, yy, zz, xy, yz, zx = link["inertia"]
    return np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]])


def by_pinocchio(tree: dict[str, Any]) -> Any:
    """Return the accelerations of the speeds."""
    model = pin.Model()
    model.gravity.linear = GRAVITY
    joints = [0]
    for k, link in enumerate(tree["links"]):
        kind = (
            pin.JointModelFreeFlyer()
            if link["axis"] is None
            else pin.JointModelRevoluteUnaligned(np.array(link["axis"]))
        )
        place = pin.SE3(pin.exp3(np.array(link["turn"])), np.array(link["place"]))
        joints.append(model.addJoint(joints[link["parent"] + 1], kind, place, f"joint {k}"))
        body = pin.Inertia(link["mass"], np.array(link["centre"]), inertia(link))
        model.appendBodyToJoint(joints[-1], body, pin.SE3.Identity())
    q, v = np.array(tree["q"]), np.array(tree["v"])
    if tree["links"][0]["axis"] is None:
        q[3:7] = q[[4, 5, 6, 3]]  # the scalar part comes last
    return pin.aba(model, model.createData(), q, v, np.array(tree["torques"]))


def by_mujoco(tree: dict[str, Any]) -> Any:
    """Return the accelerations of the speeds."""
    spec = mujoco.MjSpec()
    spec.compiler.balanceinertia = False
    spec.option.gravity = GRAVITY
    bodies = [spec.worldbody]
    for link in tree["links"]:
        angle = float(np.linalg.norm(link["turn"]))
        axis = np.array(link["turn"]) / angle if angle else np.array([1.0, 0.0, 0.0])
        turn = [np.cos(angle / 2), *(np.sin(angle / 2) * axis)]
        body = bodies[link["parent"] + 1].add_body(pos=link["place"], quat=turn)
        if link["axis"] is None:
            body.add_freejoint()
        else:
            body.add_joint(type=mujoco.mjtJoint.mjJNT_HINGE, axis=link["axis"])
        xx, yy, zz, xy, yz, zx = link["inertia"]
        body.explicitinertial = True
        body.mass, body.ipos, body.fullinertia = (
            link["mass"],
            link["centre"],
            [xx, yy, zz, xy, zx, yz],
        )
        bodies.append(body)
    model = spec.compile()
    data = mujoco.MjData(model)
    data.qpos[:], data.qvel[:] = tree["q"], tree["v"]
    data.qfrc_applied[:] = tree["torques"]
    free = tree["links"][0]["axis"] is None
    if free:  # MuJoCo's base velocity is in the world's axes
        turn = np.zeros(9)
        mujoco.mju_quat2Mat(turn, np.array(tree["q"][3:7]))
        turn = turn.reshape(3, 3)
        data.qvel[:3] = turn @ data.qvel[:3]
        data.qfrc_applied[:3] = turn @ data.qfrc_applied[:3]
    mujoco.mj_forward(model, data)
    found = np.array(data.qacc)
    if free:
        v, w = np.array(tree["v"][:3]), np.array(tree["v"][3:6])
        found[:3] = turn.T @ found[:3] - np.cross(w, v)
    return found


if __name__ == "__main__":
    print(
        json.dumps(
            [[list(by_pinocchio(tree)), list(by_mujoco(tree))] for tree in json.load(sys.stdin)]
        )
    )
