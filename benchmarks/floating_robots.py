"""Accelerations of floating robots from URDF files: ours beside Pinocchio's and adam's.

Robots of the package example-robot-data, their root free. `adam-robotics` writes the
articulated-body algorithm in CasADi, whose virtual machine evaluates it, and in JAX, which compiles
it for all states at once (`vmap`); Pinocchio's takes states one by one in a loop of its own. All
take the same random states; the time from the file to the first accelerations, and a state's share
of 1,000 of them, on one thread. Fails where accelerations of joints differ by more than 1e-9 of the
largest.
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

from pydy.robots import read

ROBOTS = ("bolt.urdf", "solo12.urdf", "go2.urdf", "simple_humanoid.urdf", "talos_reduced.urdf")
TOLERANCE = 1e-9
COUNT = 1000
WORKER = Path(__file__).parent / "workers" / "floating_robots.py"


def ours(file: str, rng: np.random.Generator, repeats: int) -> tuple[dict[str, Any], Any]:
    """Return a case for the workers, and our times and accelerations of joints."""
    start = time.perf_counter()
    robot = read(file, parameters="numbers", floating=True)
    system = robot.system()
    names = [name for name in robot.joints if name != "root"]
    x = rng.normal(size=(COUNT, len(system.states))) / 2
    torques = dict.fromkeys(robot.actuators, 0.25)
    system.specifieds = {robot.actuators[name]: value for name, value in torques.items()}
    column = {str(s.func): k for k, s in enumerate(system.states)}
    turn = [column[f"q_root_e{k}"] for k in range(4)]
    x[:, turn] /= np.linalg.norm(x[:, turn], axis=1)[:, None]
    system.evaluate_ode(x[0])
    first = time.perf_counter() - start
    rates = system.evaluate_ode(x)
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        system.evaluate_ode(x)
        times.append((time.perf_counter() - start) / COUNT)

    def columns(symbols: list[str]) -> list[list[float]]:
        return x[:, [column[s] for s in symbols]].tolist()

    root = robot.joints["root"]
    case = {
        "file": file,
        "names": names,
        "place": columns([str(s.func) for s in root.coordinates]),
        "speed": columns([str(s.func) for s in root.speeds]),
        "q": columns([str(robot.joints[n].coordinates[0].func) for n in names]),
        "v": columns([str(robot.joints[n].speeds[0].func) for n in names]),
        "torques": [torques.get(n, 0.0) for n in names],
    }
    speeds = [column[str(robot.joints[n].speeds[0].func)] for n in names]
    return case, (first, float(np.median(times)), rates[:, speeds])


def main() -> int:
    """Compare; return how many robots differ."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--peer-python", default=sys.executable)
    parser.add_argument("--adam-python", help="that of the peers, unless given")
    parser.add_argument("--quick", action="store_true", help="a single round")
    options = parser.parse_args()
    python, adam = options.peer_python, options.adam_python or options.peer_python
    packages = json.loads(subprocess.check_output([python, WORKER, "files"], text=True))
    rng, failed = np.random.default_rng(4), 0
    print("| robot, joints | | to the first, s | a state, µs | over ours |\n|---|---|---|---|---|")
    for robot in ROBOTS:
        file = next(f for f in packages if Path(f).name == robot)
        case, (first, own, expected) = ours(file, rng, 1 if options.quick else 20)
        case["repeats"] = 1 if options.quick else 20
        print(f"| {robot[:-5]}, {len(case['names'])} | pydy | {first:.2f} | {own * 1e6:.2f} | 1 |")
        for peer in ("pinocchio", "adam, CasADi", "adam, JAX"):
            done = subprocess.run(
                [adam if "adam" in peer else python, str(WORKER), peer],
                input=json.dumps(case),
                capture_output=True,
                text=True,
                check=False,
            )
            if done.returncode:
                print(f"| | {peer} | {done.stderr.splitlines()[-1]} | | |", flush=True)
                continue
            answer = json.loads(done.stdout.splitlines()[-1])
            error = np.abs(np.array(answer["rates"]) - expected).max() / np.abs(expected).max()
            failed += not error < TOLERANCE
            wrong = f", differs by {error:.0e}" if not error < TOLERANCE else ""
            first, each = answer["first"], answer["each"]
            figures = f"{first:.2f} | {each * 1e6:.2f} | {each / own:.1f} |"
            print(f"| | {peer}{wrong} | {figures}", flush=True)
    return failed


if __name__ == "__main__":
    sys.exit(main())
