"""Pinocchio's articulated-body algorithm, on the planar chain that the pendulum models are.

Nothing is derived or compiled: the chain is built from its joints. They turn each link against the
one above, so that states are converted first, outside of what is timed. States are taken one by one
in a loop of Pinocchio's own, `abaInParallel` in one thread; no Python is timed.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pinocchio as pin
from harness.peer import Peer, serve_peer


class Pinocchio(Peer):
    def load(self, name: str, count: int = Peer.count) -> Any:
        if not name.startswith("pendulum-"):
            raise ValueError("only the pendulums are planar chains")
        return super().load(name, count)

    def _chain(self) -> pin.Model:
        """Return a cart on a rail and point masses above it, joined by massless links."""
        value = dict(zip(map(str, self.model.constants), self.p, strict=True))
        model = pin.Model()
        model.gravity.linear = np.array([0.0, -value["g"], 0.0])
        joint = model.addJoint(0, pin.JointModelPX(), pin.SE3.Identity(), "cart")
        cart = pin.Inertia(value["m0"], np.zeros(3), np.zeros((3, 3)))
        model.appendBodyToJoint(joint, cart, pin.SE3.Identity())
        place = pin.SE3.Identity()
        for k in range(1, len(self.model.speeds)):
            joint = model.addJoint(joint, pin.JointModelRZ(), place, f"joint {k}")
            end = np.array([0.0, value[f"l{k - 1}"], 0.0])
            mass = pin.Inertia(value[f"m{k}"], end, np.zeros((3, 3)))
            model.appendBodyToJoint(joint, mass, pin.SE3.Identity())
            place = pin.SE3(np.eye(3), end)
        return model

    def build(self) -> Any:
        return pin.ModelPool(self._chain(), 1)

    def build_time(self) -> float:
        raise RuntimeError("nothing is compiled")

    def scalar(self) -> Any:
        pool = self.build()
        n = len(self.model.speeds)
        relative = np.eye(n) - np.eye(n, k=-1)
        relative[1, 0] = 0.0  # the cart does not turn
        q, v = (np.asfortranarray(relative @ part.T) for part in (self.x[:, :n], self.x[:, n:]))
        force = np.zeros((n, self.count), order="F")
        force[0] = self.r[:, 0]
        self._accelerations = np.zeros((n, self.count), order="F")
        self._to_absolute = np.linalg.inv(relative)

        def evaluate() -> None:
            pin.abaInParallel(1, pool, q, v, force, self._accelerations)

        return evaluate

    def batched(self) -> Any:
        raise RuntimeError("takes one state at a time")

    def values(self) -> np.ndarray:
        n = len(self.model.speeds)
        return np.hstack([self.x[:, n:], (self._to_absolute @ self._accelerations).T])


if __name__ == "__main__":
    serve_peer(Pinocchio())
