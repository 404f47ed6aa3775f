"""The disc of `rolling_disc.py` in EXUDYN: a free body and its joint of a rolling disc."""

from __future__ import annotations

import exudyn as exu
import numpy as np
from exudyn import itemInterface as items  # noqa: N813, its own name
from exudyn.rigidBodyUtilities import RigidBodyInertia, RotationMatrixX
from harness.serve import serve

TOLERANCE = 1e-12  # of its Newton iterations


def motion(
    steps: int,
    end: float,
    lean: float,
    rates: list[float],
    mass: float,
    radius: float,
    gravity: float,
) -> list[float]:
    """Take equal steps of the trapezoidal rule; the position and velocity of the centre."""
    system = exu.SystemContainer().AddSystem()
    turn = RotationMatrixX(lean)
    heading, axle, up = turn.T
    moment = mass * radius**2 / 4
    disc = system.CreateRigidBody(
        inertia=RigidBodyInertia(mass=mass, inertiaTensor=moment * np.diag([1, 2, 1])),
        referencePosition=(radius * up).tolist(),
        referenceRotationMatrix=turn,
        initialVelocity=(radius * (rates[1] * heading - rates[0] * axle)).tolist(),
        initialAngularVelocity=(turn @ rates).tolist(),
        gravity=[0, 0, -gravity],
    )
    markers = [
        system.AddMarker(items.MarkerBodyRigid(bodyNumber=body, localPosition=[0, 0, 0]))
        for body in (system.AddObject(items.ObjectGround()), disc)
    ]
    system.AddObject(
        items.ObjectJointRollingDisc(
            markerNumbers=markers, discRadius=radius, discAxis=[0, 1, 0], planeNormal=[0, 0, 1]
        )
    )
    system.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = end
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.newton.relativeTolerance = TOLERANCE
    settings.timeIntegration.newton.absoluteTolerance = TOLERANCE
    settings.timeIntegration.verboseMode = 0
    settings.solution.file.write = False
    system.SolveDynamic(settings, solverType=exu.DynamicSolverType.TrapezoidalIndex2)
    kinds = exu.OutputVariableType.Position, exu.OutputVariableType.Velocity
    found = [system.GetObjectOutputBody(disc, kind, [0, 0, 0]) for kind in kinds]
    return np.concatenate(found).tolist()


if __name__ == "__main__":
    serve({"motion": motion})
