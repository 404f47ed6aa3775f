"""The problems of `multibody.py` in EXUDYN: planar bodies in redundant coordinates, implicit."""

from __future__ import annotations

import math
import time
from typing import Any

import exudyn as exu
from exudyn import itemInterface as items  # noqa: N813, its own name
from harness.serve import serve


class Problem:
    """Rods and particles under gravity; each run builds the system again, which is not timed."""

    def run(self, name: str, accuracy: float, end: float) -> dict[str, Any]:
        """Take as many equal steps of the generalized-α method; the place of the marked point."""
        self.system = exu.SystemContainer().AddSystem()
        self.ground = self.system.AddObject(items.ObjectGround())
        point = self._pendulum() if name == "pendulum" else self._windows(int(name))
        self.system.Assemble()
        settings = exu.SimulationSettings()
        settings.timeIntegration.endTime = end
        settings.timeIntegration.numberOfSteps = round(accuracy)
        settings.timeIntegration.newton.useModifiedNewton = True
        settings.timeIntegration.verboseMode = 0
        settings.solution.file.write = False
        if name not in ("pendulum", "2"):  # dense matrices are faster for the small ones
            settings.linearSolverType = exu.LinearSolverType.EigenSparse
        start = time.process_time()
        self.system.SolveDynamic(settings)
        seconds = time.process_time() - start
        kind = exu.OutputVariableType.Position
        place = self.system.GetMarkerOutput(point, kind)
        return {"seconds": seconds, "place": list(place[:2])}

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


if __name__ == "__main__":
    serve({"run": Problem().run})
