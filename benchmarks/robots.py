"""Robots from files against Pinocchio and MuJoCo, which share no line with ours.

All URDF files of the package example-robot-data, and all MJCF files of dm_control and brax, at a
random state with random forces: accelerations, the time from the file to the first of them, and why
a file is refused, with a table of all packages at the end. Fails where the largest difference is
above 1e-11 of the largest acceleration, above what rounding does to a mass matrix of this
condition, and above what it makes that MuJoCo moves mass centres by nanometres, to the origin of
their body.
With `--terms`: inverse dynamics, bias forces, gravity, mass matrices, places and Jacobians of
frames of the URDF files, and how many operations the first take, against Pinocchio.
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
        quaternions = sum(len(joint.coordinates) > 1 for joint in robot.joints.values())
        case["tied"] = len(robot.definition.holonomic_constraints) > quaternions
    return case, ours, f"{len(system.speeds)} speeds, {seconds:.1f} s{_rest(robot)}"


def terms(file: str, rng: np.random.Generator) -> tuple[dict[str, Any], dict[str, Any], str]:
    """Return a case for the worker, our forces, matrices and places, and a line about them.

    The frame is that of the last link. Its place needs no joint to move.
    """
    robot = read(file, parameters="numbers")
    system = robot.system()
    joints = [name for name, joint in robot.joints.items() if joint.speeds[0] in system.speeds]
    speeds = [robot.joints[name].speeds[0] for name in joints]
    n = len(joints)
    if n != len(system.speeds) or n != len(robot.joints):
        raise ValueError(": joints of several speeds, or that mimic others")
    q, v, a = rng.normal(size=(3, n)) / 2
    order = [system.speeds.index(u) for u in speeds]
    link = list(robot.frames)[-1]
    found = {
        "inverse_dynamics": system.inverse_dynamics(q, v, a)[order],
        "bias": system.bias(q, v)[order],
        "gravity": system.gravity(q)[order],
        "mass_matrix": system.mass_matrix(q)[np.ix_(order, order)],
        "frame_jacobian": system.frame_jacobian(link, q)[:, order],
        "frame_position": system.frame_position(link, q),
        "frame_rotation": system.frame_rotation(link, q),
    }
    case: dict[str, Any] = {"file": file, "frame": link}
    for key, values in (("q", q), ("v", v), ("a", a)):
        case[key] = {name: float(values[k]) for name, k in zip(joints, order, strict=True)}
    counts = [_operations(system, "inverse dynamics"), _operations(system, ("rates",))]
    share = f"{counts[0]} operations to {counts[1]} of the accelerations"
    return case, found, f"{n} speeds, {share}, {counts[0] / counts[1]:.2f}"


def _operations(system: Any, what: Any) -> int:
    kernels = system.model._kernels
    if isinstance(what, tuple):
        program = system.model.programs.of(*what)
    else:
        (program,) = (k.program for key, k in kernels.items() if key[0] == what)
    return int(sum(program.operation_count["run"].values()))


def _rest(robot: Robot) -> str:
    return f", {len(robot.left_out)} left out" if robot.left_out else ""


class Table:
    """How many files of each package were compared, read here alone, or refused."""

    def __init__(self) -> None:
        self.rows: dict[str, list[Any]] = {}

    def _row(self, file: str) -> list[Any]:
        packages = ("example-robot-data", "dm_control", "brax")
        package = next((p for p in packages if p in Path(file).parts), "others")
        return self.rows.setdefault(package, [0, 0, 0, []])

    def compared(self, file: str, error: float) -> None:
        self._row(file)[0] += 1
        self._row(file)[3].append(error)

    def alone(self, file: str) -> None:
        self._row(file)[1] += 1

    def refused(self, file: str) -> None:
        self._row(file)[2] += 1

    def __str__(self) -> str:
        lines = [
            "| package | compared | not read by the peer | refused | median | largest difference |",
            "|---|---|---|---|---|---|",
        ]
        for package, (compared, alone, refused, errors) in self.rows.items():
            figures = f"{np.median(errors):.0e} | {max(errors):.0e}" if errors else "– | –"
            lines.append(f"| {package} | {compared} | {alone} | {refused} | {figures} |")
        return "\n".join(lines)


def main() -> int:
    """Compare; return how many robots differ."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--peer-python", default=sys.executable)
    parser.add_argument("--terms", action="store_true", help="inverse dynamics, matrices, frames")
    parser.add_argument("--only", default="", metavar="TEXT", help="files with this in their path")
    parser.add_argument("--under", type=Path, metavar="FOLDER", help="all files in a folder")
    options = parser.parse_args()
    rng = np.random.default_rng(3)
    done, table = [], Table()
    if options.under:
        paths = (p for end in ("urdf", "xml") for p in options.under.resolve().rglob(f"*.{end}"))
        files = sorted(map(str, paths))
    else:
        files = asked(options.peer_python)
    for file in files:
        if options.only not in file or (options.terms and not file.endswith("urdf")):
            continue
        name = "/".join(Path(file).parts[-3:])
        try:
            done.append((name, *(terms if options.terms else own)(file, rng)))
        except ValueError as error:
            table.refused(file)
            print(f"{name}: {str(error).removeprefix(str(file))}", flush=True)
    what = "terms" if options.terms else "compare"
    peers = asked(options.peer_python, what, given=[case for _, case, _, _ in done])
    failed = 0
    for (name, case, ours, line), theirs in zip(done, peers, strict=True):
        if isinstance(theirs, str):
            table.alone(case["file"])
            print(f"{name}: {line}; the peer: {theirs}")
            continue
        allowed, rounding = TOLERANCE, ""
        if not options.terms:
            limits = {
                "rounding times the condition": np.finfo(float).eps * theirs["condition"],
                "mass centres that the peer moves": theirs.get("rounded", 0.0),
            }
            theirs = theirs["rates"]
            for what, limit in limits.items():
                if limit > allowed:
                    allowed, rounding = limit, f"; {what}: {limit:.0e}"
        pairs = {key: (np.ravel(ours[key]), np.ravel(theirs[key])) for key in theirs}
        sizes = {key: np.abs(b).max() for key, (_, b) in pairs.items()}
        if not options.terms:
            sizes = dict.fromkeys(sizes, max(sizes.values()))
        errors = {k: np.abs(a - b).max() / (sizes[k] or 1.0) for k, (a, b) in pairs.items()}
        worst = max(errors, key=errors.__getitem__)
        failed += not errors[worst] <= allowed
        where = f" ({worst})" if options.terms else ""
        table.compared(case["file"], errors[worst])
        print(f"{name}: {line}; differs by {errors[worst]:.1e} of the largest{where}{rounding}")
    print(table)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
