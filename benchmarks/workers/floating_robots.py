"""Accelerations of floating robots by Pinocchio, and by adam-robotics in CasADi and in JAX.

With `files`: the URDF files of example-robot-data, as JSON. With the name of a peer: reads a case
as JSON from standard input, and writes the accelerations of the joints and times.
"""

from __future__ import annotations

import json
import site
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

GRAVITY = 9.81


class Case:
    """The states of a robot: bases as places and twists in their own axes, joints as arrays."""

    def __init__(self, given: dict[str, Any]) -> None:
        self.file, self.names = given["file"], given["names"]
        place, self.speed = np.array(given["place"]), np.array(given["speed"])
        self.origin, self.quaternion = place[:, :3], place[:, 3:]  # the scalar part comes first
        self.q, self.v = np.array(given["q"]), np.array(given["v"])
        self.torques = np.tile(given["torques"], (len(self.q), 1))

    @property
    def bases(self) -> np.ndarray:
        """The places of bases as homogeneous matrices."""
        w, x, y, z = self.quaternion.T
        made = np.tile(np.eye(4), (len(self.q), 1, 1))
        made[:, 0, :3] = np.array(
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)]
        ).T
        made[:, 1, :3] = np.array(
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)]
        ).T
        made[:, 2, :3] = np.array(
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]
        ).T
        made[:, :3, 3] = self.origin
        return made


def by_pinocchio(case: Case) -> Callable[[], np.ndarray]:
    import pinocchio as pin

    full = pin.buildModelFromUrdf(case.file, pin.JointModelFreeFlyer())
    rest = [k for k in range(2, full.njoints) if full.names[k] not in case.names]
    model = pin.buildReducedModel(full, rest, pin.neutral(full))
    model.gravity.linear = np.array([0.0, 0.0, -GRAVITY])
    count = len(case.q)
    q = np.asfortranarray(np.tile(pin.neutral(model)[:, None], (1, count)))
    v, tau = np.zeros((model.nv, count), order="F"), np.zeros((model.nv, count), order="F")
    q[:7] = np.hstack([case.origin, case.quaternion[:, [1, 2, 3, 0]]]).T
    v[:6] = case.speed.T
    order = []
    for k, name in enumerate(case.names):
        joint = model.joints[model.getJointId(name)]
        order.append(joint.idx_v)
        turn = case.q[:, k]
        q[joint.idx_q : joint.idx_q + joint.nq] = (
            np.array([np.cos(turn), np.sin(turn)]) if joint.nq == 2 else turn
        )
        v[joint.idx_v] = case.v[:, k]
        tau[joint.idx_v] = case.torques[:, k] - model.damping[joint.idx_v] * case.v[:, k]
    pool, found = pin.ModelPool(model, 1), np.zeros((model.nv, count), order="F")

    def evaluate() -> np.ndarray:
        pin.abaInParallel(1, pool, q, v, tau, found)
        return found[order].T

    return evaluate


def by_casadi(case: Case) -> Callable[[], np.ndarray]:
    from adam import Representations
    from adam.casadi import KinDynComputations

    made = KinDynComputations(case.file, case.names, gravity=_gravity())
    made.set_frame_velocity_representation(Representations.BODY_FIXED_REPRESENTATION)
    each = made.aba_fun()
    many = each.map(len(case.q))
    # A map takes the arguments of all states side by side.
    given = [np.hstack(list(case.bases)), case.q.T, case.speed.T, case.v.T]
    given.append((case.torques - _damping(case) * case.v).T)
    return lambda: np.array(many(*given))[6:].T


def by_jax(case: Case) -> Callable[[], np.ndarray]:
    import jax
    from adam import Representations
    from adam.jax import KinDynComputations

    jax.config.update("jax_enable_x64", True)
    made = KinDynComputations(case.file, case.names, gravity=_gravity())
    made.set_frame_velocity_representation(Representations.BODY_FIXED_REPRESENTATION)
    many = jax.jit(jax.vmap(made.aba))
    torques = case.torques - _damping(case) * case.v
    given = [jax.numpy.asarray(a) for a in (case.bases, case.q, case.speed, case.v, torques)]
    return lambda: np.asarray(many(*given))[:, 6:]


def _gravity() -> np.ndarray:
    return np.array([0.0, 0.0, -GRAVITY, 0.0, 0.0, 0.0])


def _damping(case: Case) -> np.ndarray:
    """Return the damping of joints, which adam leaves to its users."""
    from xml.etree import ElementTree

    tags = {j.get("name"): j.find("dynamics") for j in ElementTree.parse(case.file).iter("joint")}
    found = [tags[name] for name in case.names]
    return np.array([0.0 if tag is None else float(tag.get("damping", 0)) for tag in found])


def main() -> None:
    if sys.argv[1] == "files":
        folders = map(Path, site.getsitepackages())
        pattern = "cmeel.prefix/share/example-robot-data/**/*.urdf"
        print(json.dumps([str(f) for folder in folders for f in sorted(folder.glob(pattern))]))
        return
    given = json.load(sys.stdin)
    case = Case(given)
    make = {"pinocchio": by_pinocchio, "adam, CasADi": by_casadi, "adam, JAX": by_jax}[sys.argv[1]]
    start = time.perf_counter()
    evaluate = make(case)
    rates = evaluate()
    first = time.perf_counter() - start
    times = []
    for _ in range(given["repeats"]):
        start = time.perf_counter()
        evaluate()
        times.append((time.perf_counter() - start) / len(case.q))
    print(json.dumps({"rates": rates.tolist(), "first": first, "each": float(np.median(times))}))


if __name__ == "__main__":
    main()
