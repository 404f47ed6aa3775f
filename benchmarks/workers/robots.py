"""Accelerations of robots from files by Pinocchio (URDF) and MuJoCo (MJCF).

Without an argument: the files of the packages example-robot-data, dm_control and brax, as JSON.
With one: reads states as JSON from standard input, and writes the accelerations.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np


def files() -> list[str]:
    """Return all robots of both packages."""
    import site

    found: list[str] = []
    for folder in map(Path, site.getsitepackages()):
        found += sorted(map(str, folder.glob("cmeel.prefix/share/example-robot-data/**/*.urdf")))
        for package in ("dm_control", "brax"):
            found += sorted(map(str, folder.glob(f"{package}/**/*.xml")))
    return found


def by_pinocchio(file: str, q: dict[str, Any], v: dict[str, Any], tau: dict[str, Any]) -> Any:
    """Return the accelerations by joint; joints that mimic others take their part."""
    import pinocchio as pin

    model = pin.buildModelFromUrdf(file, mimic=True)
    joints = [k for k in range(1, model.njoints) if model.names[k] in q and model.joints[k].nv]
    place, speed, force = pin.neutral(model), np.zeros(model.nv), np.zeros(model.nv)
    for k in joints:
        joint, name = model.joints[k], model.names[k]
        turn = [np.cos(q[name]), np.sin(q[name])] if joint.nq == 2 else [q[name]]
        place[joint.idx_q : joint.idx_q + joint.nq] = turn
        speed[joint.idx_v] = v[name]
        force[joint.idx_v] = tau[name] - model.damping[joint.idx_v] * v[name]
    for master, damping in damping_of_mimics(file):
        force[model.joints[model.getJointId(master)].idx_v] -= damping * v[master]
    data = model.createData()
    mass = np.triu(pin.crba(model, data, place))
    mass += np.triu(mass, 1).T
    if len(joints) < model.njoints - 1:
        found = np.linalg.solve(
            mass, force - pin.rnea(model, data, place, speed, np.zeros(model.nv))
        )
    else:
        found = pin.aba(model, data, place, speed, force)
    rates = {model.names[k]: float(found[model.joints[k].idx_v]) for k in joints}
    return {"rates": rates, "condition": condition(mass)}


def condition(mass: np.ndarray) -> float:
    """Return the condition of a mass matrix, whatever the units of its rows."""
    sizes = np.sqrt(np.abs(np.diagonal(mass)))
    return float(np.linalg.cond(mass / np.outer(sizes, sizes))) if sizes.all() else np.inf


def terms_by_pinocchio(
    file: str, q: dict[str, Any], v: dict[str, Any], a: dict[str, Any], frame: str
) -> dict[str, Any]:
    """Return forces and the like by joint, in the order of `q`, and a frame's place and Jacobian.

    Joints that are not in `q` rest. What joints themselves damp is no part of it.
    """
    import pinocchio as pin

    full = pin.buildModelFromUrdf(file)
    rest = [k for k in range(1, full.njoints) if full.names[k] not in q]
    model = pin.buildReducedModel(full, rest, pin.neutral(full))
    data, place = model.createData(), pin.neutral(model)
    speed, rate, order = np.zeros(model.nv), np.zeros(model.nv), []
    for name in q:
        joint = model.joints[model.getJointId(name)]
        turn = [np.cos(q[name]), np.sin(q[name])] if joint.nq == 2 else [q[name]]
        place[joint.idx_q : joint.idx_q + joint.nq] = turn
        speed[joint.idx_v], rate[joint.idx_v] = v[name], a[name]
        order.append(joint.idx_v)
    mass = np.triu(pin.crba(model, data, place))
    mass += np.triu(mass, 1).T
    number, axes = (
        model.getFrameId(frame, pin.FrameType.BODY),
        pin.ReferenceFrame.LOCAL_WORLD_ALIGNED,
    )
    slopes = pin.computeFrameJacobian(model, data, place, number, axes)
    pin.framesForwardKinematics(model, data, place)
    damped = model.damping[order] * speed[order]
    return {
        "inverse_dynamics": (pin.rnea(model, data, place, speed, rate)[order] + damped).tolist(),
        "bias": (pin.nonLinearEffects(model, data, place, speed)[order] + damped).tolist(),
        "gravity": pin.computeGeneralizedGravity(model, data, place)[order].tolist(),
        "mass_matrix": mass[np.ix_(order, order)].tolist(),
        "frame_jacobian": slopes[:, order].tolist(),
        "frame_position": data.oMf[number].translation.tolist(),
        "frame_rotation": data.oMf[number].rotation.tolist(),
    }


def damping_of_mimics(file: str) -> Iterator[tuple[str, float]]:
    """Yield what joints that mimic others add to the damping of these, which Pinocchio drops."""
    for joint in ElementTree.parse(file).getroot().findall("joint"):
        mimic, dynamics = joint.find("mimic"), joint.find("dynamics")
        if mimic is not None and dynamics is not None:
            factor, damping = float(mimic.get("multiplier", 1)), float(dynamics.get("damping", 0))
            yield mimic.attrib["joint"], factor**2 * damping


def by_mujoco(file: str, q: dict[str, Any], v: dict[str, Any], taken: list[str], tied: bool) -> Any:
    """Return the accelerations by joint, without what `pydy.robots` leaves out."""
    import mujoco

    if tied:
        raise ValueError("its equalities are springs here, and constraints there")

    mujoco.set_mju_user_warning(lambda text: None)  # it would write a file of its own
    model = mujoco.MjModel.from_xml_path(file)
    off = mujoco.mjtDisableBit
    model.opt.disableflags |= int(
        off.mjDSBL_CONTACT | off.mjDSBL_EQUALITY | off.mjDSBL_FRICTIONLOSS | off.mjDSBL_LIMIT
        | off.mjDSBL_CLAMPCTRL
    )  # fmt: skip
    model.opt.density = model.opt.viscosity = 0.0
    model.tendon_stiffness[:] = model.tendon_damping[:] = 0.0
    for k in range(model.nu):
        name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_ACTUATOR, k) or f"actuator{k}"
        if name not in taken:
            model.actuator_gainprm[k] = model.actuator_biasprm[k] = 0.0
    model.actuator_forcelimited[:] = 0
    data = mujoco.MjData(model)
    names = list(q)
    data.qpos[:] = [x for name in names for x in q[name]]
    data.qvel[:] = [x for name in names for x in v[name]]
    mujoco.mj_forward(model, data)
    found, first = {}, 0
    for name in names:
        found[name] = data.qacc[first : first + len(v[name])].tolist()
        first += len(v[name])
    mass = np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, data, mass)
    # Mass centres a few nanometres from the origin of a body are taken as being there.
    moved = model.body_ipos[model.body_sameframe == mujoco.mjtSameFrame.mjSAMEFRAME_BODY]
    rates = np.abs(data.qvel).max() ** 2 + np.abs(data.qacc).max()
    rounded = float(np.abs(moved).max(initial=0.0) * rates / np.abs(data.qacc).max())
    return {"rates": found, "condition": condition(mass), "rounded": rounded}


def main() -> None:
    """Write the files, the accelerations, or with the argument 'terms' what these are made of."""
    if len(sys.argv) < 2:
        print(json.dumps(files()))
        return
    found = []
    for case in json.load(sys.stdin):
        try:
            by_urdf = terms_by_pinocchio if sys.argv[1] == "terms" else by_pinocchio
            found.append((by_urdf if case["file"].endswith("urdf") else by_mujoco)(**case))
        except Exception as error:  # noqa: BLE001 (what a peer does not read is told)
            found.append(f"{type(error).__name__}: {error}")
    print(json.dumps(found))


if __name__ == "__main__":
    main()
