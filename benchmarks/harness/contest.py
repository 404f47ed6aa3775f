"""Solvers against each other on one model: a reference, a scan over tolerances, times at an error.

A contestant is a package and one of its methods.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from statistics import median
from typing import Any

from harness.driver import Worker, WorkerError, in_turn
from harness.precision import Point, bracket, difference, interpolate
from harness.report import pairwise

# Radau has a worker of its own: compiling a Jacobian may take too long, which ends its worker.
OURS, RADAU, TARGETS = "ours", "radau", (1e-6, 1e-10)
# What all of these answer is the reference: package, method, tolerance.
REFERENCES = (
    *((OURS, "vern9", 1e-14), (OURS, "dop853", 1e-14)),
    *(("heyoka", "taylor", 1e-15), ("heyoka", "taylor, compact", 1e-15)),
)
# An integration that takes this long, in seconds, ends its contestant's scan.
PATIENCE = 5.0
Contestant = tuple[str, str]


class Contest:
    """One model.

    Parameters
    ----------
    model : str
    workers : list of Worker
        Ours first.
    step : float
        Of a scan, in decades; four times as much where every tolerance is compiled.
    """

    def __init__(self, model: str, workers: list[Worker], step: float) -> None:
        self.model = model
        self.workers = {worker.name: worker for worker in workers}
        self.step = step
        self.methods: dict[str, dict[str, Any]] = {}
        self.failed: dict[str, str] = {}
        self.built: dict[str, float] = {}
        for name, worker in self.workers.items():
            self._say(f"building {name}")
            try:
                self.methods[name] = worker.ask("load", name=model)
                self.built[name] = self.methods[name]["seconds"]
            except WorkerError as error:
                self.failed[name] = str(error)

    def _say(self, what: str) -> None:
        print(f"{self.model}: {what} …", file=sys.stderr)

    def _reach(self, contestant: Contestant, tolerance: float) -> dict[str, Any]:
        name, method = contestant
        answer: dict[str, Any] = self.workers[name].ask("reach", method=method, tolerance=tolerance)
        if self.methods[name]["costly"]:  # the build that counts is the longest of one tolerance
            self.built[name] = max(self.built[name], answer["built"])
        return answer

    def find_reference(self) -> None:
        """Set `reference`, by components the median of several, and `spread` between them."""
        self._say("reference")
        states = []
        for name, method, tolerance in REFERENCES:
            if method in self.methods.get(name, {"methods": ()})["methods"]:
                try:
                    states.append(self._reach((name, method), tolerance)["state"])
                except WorkerError as error:
                    self.failed[f"{name} {method} at {tolerance:g}"] = str(error)
        self.reference = [median(values) for values in zip(*states, strict=True)]
        self.spread = max(difference(state, self.reference) for state in states)

    def scan(self) -> None:
        """Set `scans`: from loose tolerances on, until errors are well below the last target."""
        self.scans: dict[Contestant, list[Point]] = {}
        for name, about in self.methods.items():
            for method in about["methods"]:
                self._say(f"scan of {name} {method}")
                self.scans[name, method] = self._scan((name, method), about["costly"])

    def _scan(self, contestant: Contestant, costly: bool) -> list[Point]:
        points: list[Point] = []
        step, enough = (4.0 * self.step, 1) if costly else (self.step, 2)
        good, exponent = 0, -3.0 if costly else -2.0
        while exponent >= -14.5 and good < enough:
            tolerance = 10.0**exponent
            try:
                answer = self._reach(contestant, tolerance)
            except WorkerError as error:  # perhaps at this tolerance only
                self.failed[f"{' '.join(contestant)} at {tolerance:.1g}"] = str(error)
                if not self.workers[contestant[0]].alive:
                    break
            else:
                error_there = difference(answer["state"], self.reference)
                points.append(Point(tolerance, error_there, answer["seconds"]))
                good = good + 1 if error_there < 0.3 * min(TARGETS) else 0
                if answer["seconds"] > PATIENCE:
                    break
            exponent -= step
        return points

    def race(self, rounds: dict[str, Any]) -> list[dict[str, Any]]:
        """Time everyone at every target, in turn; returns a line for each target."""
        self._say("times")
        lines = []
        for target in TARGETS:
            brackets = {who: bracket(points, target) for who, points in self.scans.items()}
            brackets = {
                who: points
                for who, points in brackets.items()
                if points and self.workers[who[0]].alive
            }
            settings = {(who, p.tolerance): p for who, points in brackets.items() for p in points}
            taken = in_turn({key: lambda key=key: self._time(*key) for key in settings}, **rounds)
            times = {}
            for who, points in brackets.items():
                rows = [[r[who, p.tolerance] for p in points] for r in taken]
                if not any(None in row for row in rows):
                    times[who] = [interpolate(points, row, target) for row in rows]
            lines.append(self._line(target, times))
        return lines

    def _time(self, contestant: Contestant, tolerance: float) -> float | None:
        name, method = contestant
        try:
            seconds: float = self.workers[name].ask("time", method=method, tolerance=tolerance)
        except WorkerError as error:
            self.failed[f"{name} {method} when timed"] = str(error)
            return None
        return seconds

    def _line(self, target: float, times: dict[Contestant, list[float]]) -> dict[str, Any]:
        groups: dict[str, list[Contestant]] = {}
        for who in sorted(times, key=lambda who: median(times[who])):
            name = who[0]
            if who == (OURS, "odeint"):  # the default is shown beside the native methods
                name = "odeint"
            groups.setdefault(OURS if name == RADAU else name, []).append(who)
        best = {name: group[0][1] for name, group in groups.items()}
        bests = {name: times[group[0]] for name, group in groups.items()}
        ours = bests.get(OURS)
        ratios = {n: pairwise(ours, v) for n, v in bests.items() if n != OURS} if ours else {}
        peers = {name: ratio for name, ratio in ratios.items() if name != "odeint"}
        fastest = max(peers, key=lambda name: peers[name]) if peers else None
        return {
            "model": self.model,
            "target": target,
            "seconds": {" ".join(who): v for who, v in times.items()},
            "best": best,
            "best_seconds": bests,
            "ratios": ratios,
            "fastest_peer": fastest,
            "ratio": peers[fastest] if fastest else None,
        }

    def summary(self) -> dict[str, Any]:
        """Return what was found beside the times."""
        return {
            "model": self.model,
            "spread": self.spread,
            "built": self.built,
            "failed": self.failed,
            "scans": {
                " ".join(who): [vars(point) for point in points]
                for who, points in self.scans.items()
            },
        }


def limits_met(lines: Sequence[dict[str, Any]], limits: dict[str, float]) -> list[str]:
    """Return a sentence for each line whose ratio is above its model's limit."""
    return [
        f"{line['model']} at {line['target']:g}: {line['ratio']:.2f}, asked {limits[line['model']]}"
        for line in lines
        if line["ratio"] is not None and line["ratio"] > limits[line["model"]]
    ]
