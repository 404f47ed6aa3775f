"""Problems of the IFToMM library of multibody benchmarks, beside EXUDYN at equal error.

A01 is a pendulum that begins horizontally, A02 a chain of N four-bars that passes positions in
which it gains N degrees of freedom, A04 Bricard's mechanism with a redundant constraint in each
position, A05 a stiff flyball governor. The error is that of a point after 10 s; of A04 after 9 s,
since it stands still after 10.
"""

from __future__ import annotations

import argparse
import math
from functools import partial
from typing import Any

from harness.driver import Worker, WorkerError, in_turn
from harness.options import add_measuring, add_pythons, rounds
from harness.precision import Point, bracket, interpolate
from harness.report import pairwise, save, seconds, table

# Where the point is at the end: of the pendulum by Jacobi's functions; of the windows, which move
# as one, by ((N+1)/3 + N) φ″ = ((N+1)/2 + N) g sin φ in 30 digits (lengths and masses are one); of
# Bricard's third rod and of the governor's first ball to the digits in which dop853, vern9 and
# radau agree, to which EXUDYN converges with the square of its step.
ENDS = {
    "pendulum": (-0.275087462576, -0.961419205099),
    "2": (0.32845811154, 0.94451853818),
    "40": (0.18051222668, 0.98357274058),
    "bricard": (0.555490531462, -1.631884102291, 0.168477138344),
    "governor": (0.79723563278, -0.56107787486, 0.61974341841),
}
NAMES = {
    "pendulum": "A01, pendulum",
    "2": "A02, 2 windows",
    "40": "A02, 40 windows",
    "bricard": "A04, Bricard",
    "governor": "A05, governor",
}
END = {"bricard": 9.0}  # s
TARGETS = (1e-3, 1e-5)
OURS = tuple(10.0**-k for k in range(3, 13))  # tolerances
THEIRS = tuple(500.0 * 2.0**k for k in range(10))  # steps
PATIENCE = 30.0  # s


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    add_pythons(parser, "--peer-python", "--python")
    add_measuring(parser, budget=60.0)
    parser.add_argument("problems", nargs="*", default=list(ENDS), help=", ".join(ENDS))
    options = parser.parse_args()
    results: dict[str, Any] = {}
    rows = []
    for name in options.problems:
        results[name] = _compare(name, options)
        for target, (ours, theirs, ratio) in results[name]["times"].items():
            shown = [seconds(ours), seconds(theirs), "–" if ratio is None else f"{ratio:.3g}"]
            rows.append([NAMES[name], f"{target:g}", *shown, f"{results[name]['first']:.2f} s"])
    header = ["", "error", "pydy", "EXUDYN", "EXUDYN over ours", "first result"]
    table("IFToMM problems, 10 s", header, rows)
    save("multibody", results)


def _compare(name: str, options: argparse.Namespace) -> dict[str, Any]:
    """Scan both, then time in turn what encloses each target."""
    with (
        Worker("multibody-ours", options.python, "multibody_ours.py", core=options.core) as ours,
        Worker("exudyn", options.peer_python, "multibody_exudyn.py", core=options.core) as theirs,
    ):
        first = ours.ask("first", name=name, end=END.get(name, 10.0))
        settings = {ours.name: OURS, theirs.name: THEIRS}
        scans = {w.name: _scan(w, name, settings[w.name]) for w in (ours, theirs)}
        times = {}
        for target in TARGETS:
            ends = {w: bracket(scans[w.name], target) for w in (ours, theirs)}
            measures = {
                (w.name, p.tolerance): partial(_seconds, w, name, p.tolerance)
                for w, points in ends.items()
                for p in points
            }
            taken = in_turn(measures, **rounds(options))
            found = {
                w.name: [
                    interpolate(points, [one[w.name, p.tolerance] for p in points], target)
                    for one in taken
                ]
                for w, points in ends.items()
                if points
            }
            both = len(found) == 2
            ratio = pairwise(found[theirs.name], found[ours.name]) if both else None
            best = [min(found[w.name]) if w.name in found else None for w in (ours, theirs)]
            times[target] = (*best, ratio)
    return {"first": first["seconds"], "times": times, "scans": {
        who: [vars(point) for point in points] for who, points in scans.items()
    }}  # fmt: skip


def _setting(worker: Worker, tolerance: float) -> float:
    """Return a tolerance as it is, and for equal steps their number."""
    return tolerance if worker.name.endswith("ours") else 1.0 / tolerance


def _seconds(worker: Worker, name: str, tolerance: float) -> float:
    accuracy = _setting(worker, tolerance)
    return float(
        worker.ask("run", name=name, accuracy=accuracy, end=END.get(name, 10.0))["seconds"]
    )


def _scan(worker: Worker, name: str, settings: tuple[float, ...]) -> list[Point]:
    found = []
    for setting in settings:
        try:
            answer = worker.ask("run", name=name, accuracy=setting, end=END.get(name, 10.0))
        except WorkerError as error:  # its Newton iterations may fail in a singular position
            print(f"{NAMES[name]}: {worker.name} {setting:g}: {error}", flush=True)
            break
        error = math.dist(answer["place"][: len(ENDS[name])], ENDS[name])
        tolerance = setting if worker.name.endswith("ours") else 1.0 / setting
        found.append(Point(tolerance, error, answer["seconds"]))
        print(f"{NAMES[name]}: {worker.name} {setting:g}: error {error:.2g}", flush=True)
        if error < 0.1 * min(TARGETS) or answer["seconds"] > PATIENCE:
            break
    return found


if __name__ == "__main__":
    main()
