"""Robots from files against Pinocchio and MuJoCo, which share no line with ours.

All URDF files of the package example-robot-data, and all MJCF files of dm_control's suite, at a
random state with random forces: accelerations, the time from the file to the first of them, and why
a file is refused. Fails where the largest difference is above 1e-11 of the largest acceleration.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np

from pydy.robots import Robot, read

TOLERANCE = 1e-11
WORKER = Path(__file__).parent / "workers" / "robots.py"


def asked(python: str, *options: str, given: Any = None) -> Any:
    """Return what the worker answers."""
    done = subprocess.run(
        [python, str(WORKER), *options],
        input=json.dumps(given),
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        sys.exit(done.stderr)
    return json.loads(done.stdout.splitlines()[-1])


def own(file: str, rng: np.random.Generator) -> tuple[dict[str, Any], dict[str, Any], str]:
    """Return a case for the worker, our accelerations by joint, and a line about both."""
    start = time.perf_counter()
    robot = read(file, parameters="numbers")
    system = robot.system()
    x = dict(zip(system.states, rng.normal(size=len(system.states)) / 2, strict=True))
    for joint in robot.joints.values():  # quaternions have unit length
        turn = joint.coordinates[-4:] if len(joint.coordinates) > 1 else ()
        size = np.linalg.norm([x[e] for e in turn])
        x.update((e, x[e] / size) for e in turn)
    urdf = file.endswith("urdf")
    forces = {name: float(rng.normal()) if urdf else 0.0 for name in robot.actuators}
    system.specifieds = {robot.actuators[name]: force for name, force in forces.items()}
    rates = system.evaluate_ode([x[s] for s in system.states])
    seconds = time.perf_counter() - start
    found = dict(zip(system.states, rates, strict=True))
    joints = {
        name: joint
        for name, joint in robot.joints.items()
        if set(joint.speeds) <= found.keys() and (not urdf or name in robot.actuators)
    }
    case: dict[str, Any] = {"file": file}
    for what in ("q", "v"):
        place = what == "v"
        case[what] = {n: [float(x[s]) for s in joints[n][place]] for n in joints}
    ours = {n: [float(found[s]) for s in joints[n].speeds] for n in joints}
    if urdf:
        for part in (case["q"], case["v"], ours):
            part.update({name: value[0] for name, value in part.items()})
        case["tau"] = forces
    else:
        case["taken"] = list(robot.actuators)
    return case, ours, f"{len(system.speeds)} speeds, {seconds:.1f} s{_rest(robot)}"


def _rest(robot: Robot) -> str:
    return f", {len(robot.left_out)} left out" if robot.left_out else ""


def main() -> int:
    """Compare; return how many robots differ."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--peer-python", default=sys.executable)
    options = parser.parse_args()
    rng = np.random.default_rng(3)
    done = []
    for file in asked(options.peer_python):
        name = "/".join(Path(file).parts[-3:])
        try:
            done.append((name, *own(file, rng)))
        except ValueError as error:
            print(f"{name}: {str(error).removeprefix(str(file))}")
    peers = asked(options.peer_python, "compare", given=[case for _, case, _, _ in done])
    failed = 0
    for (name, _, ours, line), theirs in zip(done, peers, strict=True):
        if isinstance(theirs, str):
            print(f"{name}: {line}; the peer: {theirs}")
            continue
        pairs = [(np.ravel(ours[joint]), np.ravel(theirs[joint])) for joint in theirs]
        largest = max(np.abs(b).max() for _, b in pairs)
        difference = max(np.abs(a - b).max() for a, b in pairs) / largest
        failed += difference > TOLERANCE
        print(f"{name}: {line}; differs by {difference:.1e} of the largest")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
