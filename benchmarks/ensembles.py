"""Ensembles of pendulums: in lanes against a loop, heyoka's batches, and a million in 2 GiB."""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from harness.driver import ROOT, Worker, in_turn
from harness.report import pairwise, save, table

REFERENCE = 1e-13
OURS = [("dop853", tol) for tol in (1e-6, 1e-7, 1e-8, 1e-9, 1e-10)]
OURS += [("vern9", k * tol) for tol in (1e-6, 1e-7, 1e-8, 1e-9, 1e-10) for k in (1, 0.5, 0.25)]
OURS += [("vern9", 1e-11)]
SCALED = ("vern9", 1e-8)  # for threads and the loop
THEIRS = (1e-6, 1e-7, 1e-9)


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--peer-python", type=Path, default=ROOT / ".venv-peers/bin/python")
    parser.add_argument("--python", type=Path, default=Path(sys.executable), help="ours")
    parser.add_argument("--count", type=int, default=10_000, help="trajectories, a multiple of 8")
    parser.add_argument("--links", type=int, nargs="+", default=[1, 5])
    parser.add_argument("--checked", type=int, default=200, help="trajectories for errors")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--million", type=int, default=1_000_000, help="0 leaves this part out")
    options = parser.parse_args()
    results: dict[str, Any] = {}
    for links in options.links:
        results[f"n={links}"] = _compare(links, options)
    if options.million:
        results["million"] = _million(options.million, options.python)
    save("ensembles", results)


def _compare(links: int, options: Any) -> dict[str, Any]:
    core = max(os.sched_getaffinity(0))
    count, checked = options.count, options.checked
    ours = Worker("ours", options.python, "ensembles_ours.py", core=core)
    free = Worker("ours-threads", options.python, "ensembles_ours.py")
    peer = Worker("heyoka-batch", options.peer_python, "ensembles_heyoka.py", core=core)
    with ours, free, peer, tempfile.TemporaryDirectory() as folder:
        for worker in (ours, free, peer):
            worker.ask("load", links=links, count=count)

        def states(worker: Worker) -> np.ndarray:
            path = str(Path(folder, "states.npy"))
            worker.ask("save", path=path, count=checked)
            return np.load(path)

        ours.ask("loop", method="vern9", tol=REFERENCE, count=checked)
        reference = states(ours)

        def error(worker: Worker) -> float:
            return float(np.median(np.abs(states(worker) - reference).max(axis=(1, 2))))

        measures = {
            f"lanes {method} {tol:g}": (
                ours,
                {"do": "lanes", "method": method, "tol": tol, "threads": 1},
            )
            for method, tol in OURS
        }
        method, tol = SCALED
        measures |= {
            f"lanes {method} {tol:g}, {threads} threads": (
                free,
                {"do": "lanes", "method": method, "tol": tol, "threads": threads},
            )
            for threads in (1, 2)
        }
        request = {"do": "loop", "method": method, "tol": tol, "count": min(count, 1000)}
        measures[f"loop {method} {tol:g}"] = (ours, request)
        measures |= {
            f"heyoka {tol:g}{' 512 bits' if wide else ''}": (
                peer,
                {"do": "lanes", "tol": tol, "wide": wide},
            )
            for tol in THEIRS
            for wide in (False, True)
        }
        errors: dict[str, float] = {}

        def measure(name: str) -> float:
            worker, request = measures[name]
            taken = worker.ask(**request)["seconds"]
            errors.setdefault(name, error(worker))
            return taken

        rounds = in_turn(
            {name: lambda name=name: measure(name) for name in measures},
            least=options.rounds,
            most=options.rounds,
        )
        bare = [free.ask("kernel", threads=threads) for threads in (1, 2)]
    seconds = {name: [r[name] for r in rounds] for name in measures}
    rows = []
    for name, taken in seconds.items():
        ratio = ""
        if name.startswith("heyoka"):  # against the fastest of ours that is no less accurate
            good = [
                n
                for n in seconds
                if n.startswith("lanes") and "," not in n and errors[n] <= errors[name]
            ]
            if good:
                best = min(good, key=lambda n: min(seconds[n]))
                ratio = f"{pairwise(taken, seconds[best]):.2f} ({best})"
        elif name.startswith("loop"):
            ratio = f"{pairwise(taken, seconds[name.replace('loop', 'lanes')]):.2f}"
        rows.append([name, f"{count / np.median(taken):,.0f}", f"{errors[name]:.1e}", ratio])
    table(
        f"n = {links}: {count:,} trajectories",
        ("", "a second", "median error", "lanes are faster by"),
        rows,
    )
    one, two = (seconds[f"lanes {SCALED[0]} {SCALED[1]:g}, {k} threads"] for k in (1, 2))
    print(f"  two threads: {pairwise(one, two):.2f}; the bare kernel {bare[0] / bare[1]:.2f}")
    return {"seconds": seconds, "errors": errors, "kernel": bare}


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
