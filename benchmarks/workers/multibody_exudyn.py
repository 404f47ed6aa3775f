"""The problems of `multibody.py` in EXUDYN: bodies in redundant coordinates, an implicit method."""

from __future__ import annotations

import math
import time
from typing import Any

import exudyn as exu
import numpy as np
from exudyn import itemInterface as items  # noqa: N813, its own name
from exudyn.rigidBodyUtilities import RigidBodyInertia, RotationMatrixY
from harness.serve import serve


class Problem:
    """Rods and particles under gravity; each run builds the system again, which is not timed."""

    def run(self, name: str, accuracy: float, end: float) -> dict[str, Any]:
        """Take as many equal steps of the generalized-α method; the place of the marked point."""
        self.system = exu.SystemContainer().AddSystem()
        self.ground = self.system.AddObject(items.ObjectGround())
        made = {"pendulum": self._pendulum, "bricard": self._bricard, "governor": self._governor}
        point = made[name]() if name in made else self._windows(int(name))
        self.system.Assemble()
        settings = exu.SimulationSettings()
        settings.timeIntegration.endTime = end
        settings.timeIntegration.numberOfSteps = round(accuracy)
        settings.timeIntegration.newton.useModifiedNewton = True
        settings.timeIntegration.verboseMode = 0
        settings.solution.file.write = False
        if name == "40":  # dense matrices are faster for the small ones
            settings.linearSolver.solverType = exu.LinearSolverType.EigenSparse
        if name == "bricard":  # six joints leave five rows too many by one
            settings.linearSolver.solverType = exu.LinearSolverType.EigenDense
            settings.linearSolver.ignoreSingularJacobian = True
        start = time.process_time()
        self.system.SolveDynamic(settings)
        seconds = time.process_time() - start
        kind = exu.OutputVariableType.Position
        place = self.system.GetMarkerOutput(point, kind)
        return {"seconds": seconds, "place": list(place)}

    def _rod(self, x: float, y: float, angle: float, vx: float, rate: float) -> list[int]:
        """Add a rod of one metre and one kilogram; markers at both ends."""
        node = self.system.AddNode(
            items.NodeRigidBody2D(
                referenceCoordinates=[x, y, angle], initialVelocities=[vx, 0.0, rate]
            )
        )
        body = self.system.AddObject(
            items.ObjectRigidBody2D(mass=1.0, inertia=1 / 12, nodeNumber=node)
        )
        centre, *ends = (
            self.system.AddMarker(
                items.MarkerBodyPosition(bodyNumber=body, localPosition=[s, 0, 0])
            )
            for s in (0.0, -0.5, 0.5)
        )
        self.system.AddLoad(items.LoadForceVector(markerNumber=centre, loadVector=[0, -9.81, 0]))
        return ends

    def _foot(self, x: float) -> int:
        return self._marker(self.ground, x)

    def _marker(self, body: int, x: float) -> int:
        marker = items.MarkerBodyPosition(bodyNumber=body, localPosition=[x, 0, 0])
        return int(self.system.AddMarker(marker))

    def _joint(self, a: int, b: int) -> None:
        self.system.AddObject(items.ObjectJointRevolute2D(markerNumbers=[a, b]))

    def _windows(self, n: int) -> int:
        posts = [self._rod(k, 0.5, math.pi / 2, 0.5, -1.0) for k in range(n + 1)]
        beams = [self._rod(k + 0.5, 1.0, 0.0, 1.0, 0.0) for k in range(n)]
        for k, (foot, _) in enumerate(posts):
            self._joint(self._foot(k), foot)
        for k, (first, last) in enumerate(beams):
            self._joint(posts[k][1], first)
            self._joint(last, posts[k + 1][1])
        return posts[0][1]

    def _pendulum(self) -> int:
        node = self.system.AddNode(items.NodePoint2D(referenceCoordinates=[-1.0, 0.0]))
        body = self.system.AddObject(items.ObjectMassPoint2D(mass=1.0, nodeNumber=node))
        marker = self._marker(body, 0.0)
        self.system.AddLoad(items.LoadForceVector(markerNumber=marker, loadVector=[0, -9.81, 0]))
        ends = [self._foot(0.0), marker]
        self.system.AddObject(items.ObjectConnectorDistance(markerNumbers=ends, distance=1.0))
        return marker

    def _bricard(self) -> int:
        """Five slender rods along edges of a cube, which hang on each other and the ground."""
        edges = np.array([(1, 0, 0), (0, -1, 0), (0, 0, 1), (-1, 0, 0), (0, 1, 0)], dtype=float)
        hinges = np.eye(3)[[1, 2, 0, 1, 2, 0]].tolist()
        place, last = np.zeros(3), self.ground
        for k, edge in enumerate(edges):
            rod = self._body(1.0, np.diag(1 - np.abs(edge)) / 12, place + edge / 2, [0, -9.81, 0])
            self._hinge(last, rod, place, hinges[k])
            if k == 2:
                point = self._at(rod, edge / 2)
            place, last = place + edge, rod
        self._hinge(last, self.ground, place, hinges[5])
        return point

    def _governor(self) -> int:
        """A shaft that turns, a base that slides on it, and two rods with balls at their ends."""
        rate, weight = [0.0, 0.0, 2 * math.pi], [0, 0, -9.81]
        half = np.array([0.0, 0.0, 0.5])
        shaft = self._body(0.3, _box(0.3, 0.01, 0.01, 1.0), half, weight, rate)
        base = self._body(3.0, _box(3.0, 0.1, 0.1, 0.1), half, weight, rate)
        self._hinge(self.ground, shaft, np.zeros(3), [0, 0, 1])
        self.system.CreatePrismaticJoint(
            itemNumbers=[shaft, base], position=half.tolist(), axis=[0, 0, 1]
        )
        off = 2.5 / 5.3  # the mass centre of a rod with its ball, from the rod's middle
        inertia = _box(0.3, 1.0, 0.01, 0.01)
        inertia += np.diag([0, 1, 1]) * (0.3 * off**2 + 5 * (0.5 - off) ** 2)
        for side in (-1, 1):
            turn = RotationMatrixY(side * math.pi / 6)
            pin = np.array([side * 0.05, 0, 1])
            centre = pin + turn @ [side * (0.5 + off), 0, 0]
            rod = self._body(5.3, inertia, centre, weight, rate, turn)
            self._hinge(shaft, rod, pin, [0, 1, 0])
            self.system.CreateSpringDamper(
                itemNumbers=[base, rod],
                localPosition0=[side * 0.05, 0, 0],
                localPosition1=[-side * off, 0, 0],
                referenceLength=0.5,
                stiffness=8e5,
                damping=4e4,
            )
        return self._at(rod, np.array([0.5 - off, 0, 0]))

    def _body(
        self,
        mass: float,
        inertia: np.ndarray,
        place: np.ndarray,
        weight: list[float],
        rate: Any = (0, 0, 0),
        turn: Any = None,
    ) -> int:
        return self.system.CreateRigidBody(
            inertia=RigidBodyInertia(mass=mass, inertiaTensor=inertia),
            referencePosition=place.tolist(),
            referenceRotationMatrix=np.eye(3) if turn is None else turn,
            initialVelocity=np.cross(rate, place).tolist(),
            initialAngularVelocity=list(rate),
            gravity=weight,
        )

    def _hinge(self, one: int, other: int, place: np.ndarray, axis: list[float]) -> None:
        self.system.CreateRevoluteJoint(
            itemNumbers=[one, other], position=place.tolist(), axis=axis
        )

    def _at(self, body: int, place: np.ndarray) -> int:
        marker = items.MarkerBodyPosition(bodyNumber=body, localPosition=place.tolist())
        return int(self.system.AddMarker(marker))


def _box(mass: float, x: float, y: float, z: float) -> np.ndarray:
    return np.diag([y * y + z * z, x * x + z * z, x * x + y * y]) * mass / 12


if __name__ == "__main__":
    serve({"run": Problem().run})
