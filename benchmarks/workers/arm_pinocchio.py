"""Pinocchio's derivatives of forward dynamics, `computeABADerivatives`, on trees of joints.

Calls are from Python. What such a call costs by itself is at most the time that a chain of one
joint takes; `run` returns both.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pinocchio as pin
from harness.serve import Repeated, serve
from trees import GRAVITY, inertia


def model_of(tree: dict[str, Any]) -> pin.Model:
    """Return a tree of revolute joints."""
    model = pin.Model()
    model.gravity.linear = GRAVITY
    joints = [0]
    for k, link in enumerate(tree["links"]):
        kind = pin.JointModelRevoluteUnaligned(np.array(link["axis"]))
        if sorted(np.abs(link["axis"])) == [0.0, 0.0, 1.0]:
            axis = int(np.argmax(np.abs(link["axis"])))
            kind = (pin.JointModelRX, pin.JointModelRY, pin.JointModelRZ)[axis]()
        place = pin.SE3(pin.exp3(np.array(link["turn"])), np.array(link["place"]))
        joints.append(model.addJoint(joints[link["parent"] + 1], kind, place, f"joint {k}"))
        body = pin.Inertia(link["mass"], np.array(link["centre"]), inertia(link))
        model.appendBodyToJoint(joints[-1], body, pin.SE3.Identity())
    return model


class Arm:
    def load(self, tree: dict[str, Any], single: dict[str, Any]) -> dict[str, Any]:
        """Take a tree and a chain of one joint; returns ∂u'/∂q and ∂u'/∂u of the tree."""
        self.runs = []
        for given in (tree, single):
            model = model_of(given)
            data = model.createData()
            q, v, torque = (np.array(given[name]) for name in ("q", "v", "torques"))
            call = pin.computeABADerivatives

            def run(args: Any = (model, data, q, v, torque), call: Any = call) -> None:
                call(*args)

            run()
            self.runs.append(Repeated(run))
            if given is tree:
                found = {"q": data.ddq_dq.tolist(), "v": data.ddq_dv.tolist()}
        return found

    def run(self) -> list[float]:
        """Return the seconds of one call for the tree, and for one joint."""
        return [run() for run in self.runs]


if __name__ == "__main__":
    arm = Arm()
    serve({"load": arm.load, "run": arm.run})
