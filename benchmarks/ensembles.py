"""Ensembles of pendulums: trajectories a second at equal errors, and a million in 2 GiB."""

from __future__ import annotations

import argparse
import os
import tempfile
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from harness.driver import Worker, in_turn
from harness.options import add_pythons
from harness.precision import Point, bracket, interpolate
from harness.report import pairwise, save, table

REFERENCE = ("vern9", 1e-13)
TARGETS = (4e-6, 4e-8, 4e-9)
# Links, and how many times heyoka's trajectories a second are asked for.
GOALS = {1: 2.0, 5: 3.0}
METHODS = ("dop853", "vern9", "tsit5")
TOLERANCES = tuple(10.0**-k for k in np.arange(3.0, 11.6, 0.5))
THEIRS = TOLERANCES[2::2]  # each is compiled
SCALED = ("vern9", 1e-8)  # for threads and the loop
Contestant = tuple[str, str | int]


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    add_pythons(parser, "--peer-python", "--python")
    parser.add_argument("--count", type=int, default=10_000, help="trajectories, a multiple of 8")
    parser.add_argument("--links", type=int, nargs="*", default=list(GOALS))
    parser.add_argument("--methods", nargs="+", default=METHODS)
    parser.add_argument("--checked", type=int, default=400, help="trajectories for errors")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--scaling", type=int, default=3, help="its rounds; 0 leaves it out")
    parser.add_argument("--held", type=int, default=2000, help="closed loops; 0 leaves it out")
    parser.add_argument("--million", type=int, default=1_000_000, help="0 leaves this part out")
    options = parser.parse_args()
    results: dict[str, Any] = {}
    for links in options.links:
        results[f"n={links}"] = _compare(links, options)
        if options.scaling:
            results[f"n={links}, scaling"] = _scaling(links, options)
    if options.held:
        results["held"] = _held(options)
    if options.million:
        results["million"] = _million(options.million, options.python)
    save("ensembles", results)


# -- at equal error -----------------------------------------------------------------------------


def _compare(links: int, options: Any) -> dict[str, Any]:
    """Scan tolerances with few trajectories, then time what encloses each target, in turn."""
    core = max(os.sched_getaffinity(0))
    ours = Worker("ours", options.python, "ensembles_ours.py", core=core)
    peer = Worker("heyoka-batch", options.peer_python, "ensembles_heyoka.py", core=core)
    with ours, peer, tempfile.TemporaryDirectory() as folder:
        ours.ask("load", links=links, count=options.count)
        sizes = peer.ask("load", links=links, count=options.count)["sizes"]
        path = str(Path(folder, "states.npy"))

        def states(worker: Worker) -> np.ndarray:
            worker.ask("save", path=path, count=options.checked)
            return np.load(path)

        def run(who: Contestant, tolerance: float, count: int) -> float:
            name, choice = who
            if name == "ours":
                request = {"method": choice, "tol": tolerance, "threads": 1, "count": count}
                return ours.ask("lanes", **request)["seconds"]
            return peer.ask("lanes", size=choice, tol=tolerance, count=count)["seconds"]

        method, tolerance = REFERENCE
        ours.ask("loop", method=method, tol=tolerance, count=options.checked)
        reference = states(ours)
        scans: dict[Contestant, list[Point]] = {}
        for who in [*(("ours", m) for m in options.methods), *(("heyoka", s) for s in sizes)]:
            worker, tolerances = (ours, TOLERANCES) if who[0] == "ours" else (peer, THEIRS)
            points = scans[who] = []
            for tolerance in tolerances:
                taken = run(who, tolerance, options.checked)
                error = np.abs(states(worker) - reference).max(axis=(1, 2))
                points.append(Point(tolerance, float(np.median(error)), taken))
                if points[-1].error < 0.3 * min(TARGETS):
                    break
        brackets = {
            (who, target): bracket(points, target)
            for who, points in scans.items()
            for target in TARGETS
        }
        wanted = {(who, p.tolerance) for (who, _), points in brackets.items() for p in points}
        rounds = in_turn(
            {key: partial(run, *key, options.count) for key in sorted(wanted, key=str)},
            least=options.rounds,
            most=options.rounds,
        )
    lines = [
        _line(links, target, {w: b for (w, t), b in brackets.items() if t == target and b}, rounds)
        for target in TARGETS
    ]
    _report(links, options.count, lines)
    return {
        "targets": lines,
        "scans": {f"{w[0]} {w[1]}": [vars(p) for p in points] for w, points in scans.items()},
    }


def _line(
    links: int, target: float, brackets: dict[Contestant, list[Point]], rounds: list[Any]
) -> dict[str, Any]:
    """Return everyone's times at one error, and by how much our fastest leads theirs."""
    times = {
        who: [interpolate(points, [r[who, p.tolerance] for p in points], target) for r in rounds]
        for who, points in brackets.items()
    }
    best = {
        name: min((w for w in times if w[0] == name), key=lambda w: median(times[w]))
        for name in ("ours", "heyoka")
    }
    return {
        "target": target,
        "seconds": {f"{who[0]} {who[1]}": taken for who, taken in times.items()},
        "tolerances": {f"{w[0]} {w[1]}": [p.tolerance for p in b] for w, b in brackets.items()},
        "best": {name: who[1] for name, who in best.items()},
        "ratio": pairwise(times[best["heyoka"]], times[best["ours"]]),
        "asked": GOALS.get(links),
    }


def _report(links: int, count: int, lines: list[dict[str, Any]]) -> None:
    names = sorted({name for line in lines for name in line["seconds"]}, reverse=True)
    rows = [
        [
            f"{line['target']:g}",
            *(
                f"{count / median(line['seconds'][name]):,.0f}" if name in line["seconds"] else "–"
                for name in names
            ),
            f"{line['ratio']:.2f}",
            line["asked"] or "–",
        ]
        for line in lines
    ]
    shown = [f"{name} lanes" if name.startswith("heyoka") else name for name in names]
    title = f"n = {links}: trajectories a second, {count:,} of them, one thread, at a median error"
    table(title, ("error", *shown, "ours / heyoka's", "asked"), rows)


# -- threads, and a loop ------------------------------------------------------------------------


def _scaling(links: int, options: Any) -> dict[str, Any]:
    """Compare one thread with two, and lanes with a loop over the solver for one."""
    method, tol = SCALED
    core = max(os.sched_getaffinity(0))
    ours = Worker("ours", options.python, "ensembles_ours.py", core=core)
    free = Worker("ours-threads", options.python, "ensembles_ours.py")
    with ours, free:
        for worker in (ours, free):
            worker.ask("load", links=links, count=options.count)
        request = {"method": method, "tol": tol, "count": options.count}
        few = min(options.count, 1000)
        measures = {
            "lanes": lambda: ours.ask("lanes", **request, threads=1)["seconds"],
            "loop": lambda: (
                ours.ask("loop", method=method, tol=tol, count=few)["seconds"]
                * (options.count / few)
            ),
            **{
                f"{k} threads": lambda k=k: free.ask("lanes", **request, threads=k)["seconds"]
                for k in (1, 2)
            },
        }
        rounds = in_turn(measures, least=options.scaling, most=options.scaling)
        bare = [free.ask("kernel", threads=threads) for threads in (1, 2)]
    seconds = {name: [r[name] for r in rounds] for name in measures}
    print(
        f"  {method} at {tol:g}: lanes are faster than a loop by "
        f"{pairwise(seconds['loop'], seconds['lanes']):.2f}; two threads than one by "
        f"{pairwise(seconds['1 threads'], seconds['2 threads']):.2f}, "
        f"of the bare kernel {bare[0] / bare[1]:.2f}"
    )
    return {"seconds": seconds, "kernel": bare}


def _held(options: Any) -> dict[str, Any]:
    """Compare lanes that are projected onto constraints with a loop over the System."""
    core = max(os.sched_getaffinity(0))
    with Worker("ours", options.python, "ensembles_ours.py", core=core) as ours:
        few = min(options.held, 200)
        measures = {
            "lanes": lambda: ours.ask("held", count=options.held, loop=False),
            "loop": lambda: ours.ask("held", count=few, loop=True) * (options.held / few),
        }
        rounds = in_turn(measures, least=max(1, options.scaling), most=max(1, options.scaling))
    seconds = {name: [r[name] for r in rounds] for name in measures}
    print(
        f"Bricard's mechanism, projected: {options.held / min(seconds['lanes']):,.0f} a second; "
        f"lanes are faster than a loop by {pairwise(seconds['loop'], seconds['lanes']):.2f}"
    )
    return {"seconds": seconds}


def _million(count: int, python: Path) -> dict[str, Any]:
    threads = len(os.sched_getaffinity(0))
    found = {}
    for many in (10_000, count):
        with Worker("million", python, "ensembles_ours.py") as worker:
            worker.ask("load", links=1, count=min(many, 100_000))
            worker.ask("final", tol=1e-8, count=10_000, threads=threads, limit=None)
            limit = 2.0 if many == count else None
            found[many] = worker.ask("final", tol=1e-8, count=many, threads=threads, limit=limit)
    rate = {many: many / answer["seconds"] for many, answer in found.items()}
    rows = [[f"{m:,}", f"{rate[m]:,.0f}", f"{found[m]['peak_GiB']:.2f} GiB"] for m in found]
    table("Reduced to final states, n = 1", ("trajectories", "a second", "peak memory"), rows)
    print(f"  throughput of many against few: {rate[count] / rate[10_000]:.2f}")
    return {str(many): answer for many, answer in found.items()}


if __name__ == "__main__":
    main()
