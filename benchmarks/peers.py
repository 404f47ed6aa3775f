"""Ours against heyoka, CasADi, JAX and Pinocchio on frozen models: ``make bench-peers``."""

from __future__ import annotations

import argparse
import sys
from contextlib import ExitStack
from pathlib import Path
from statistics import median
from typing import Any

from harness.driver import Worker, WorkerError, in_turn
from harness.options import add_measuring, add_pythons, rounds
from harness.report import pairwise, save, seconds, table

MODELS = (
    *("pendulum-1", "pendulum-5", "pendulum-10", "pendulum-20", "rods-3", "bicycle"),
    *("springs-100-absolute", "rider-bicycle", "pendulum-50", "rods-10"),
    # The same mechanisms derived otherwise, and some more: see `harness.models.VARIANTS`.
    *("pendulum-relative-5", "rods-universal-3", "rods-absolute-3", "rods-universal-absolute-3"),
    *("rods-5", "rods-universal-5", "rods-absolute-5", "rods-universal-absolute-5"),
    *("bicycle-from-contact", "rider-adduction", "arm-7", "quadrotor"),
)
PEERS = {
    "heyoka": ("heyoka_.py",),
    "casadi": ("casadi_.py",),
    "casadi-c": ("casadi_.py", "c"),
    "jax": ("jax_.py",),
    "pinocchio": ("pinocchio_.py",),
}
# Too much for what compiles: minutes and gigabytes.
ONLY = {"pendulum-50": ("pinocchio",), "rods-10": ()}
KINDS = ("build", "scalar", "batched")
# A build that took longer than this is not repeated.
PATIENCE = 20.0


def main() -> None:
    """Measure and print a table for each kind of measure."""
    parser = argparse.ArgumentParser(description=__doc__)
    add_pythons(parser, "--peer-python", "--python")
    parser.add_argument("--models", nargs="+", default=MODELS)
    parser.add_argument("--peers", nargs="+", default=list(PEERS), choices=list(PEERS))
    parser.add_argument(
        "--widths", nargs="+", type=int, default=[], choices=(2, 4, 8), help="of batched code too"
    )
    parser.add_argument("--states", type=int, default=4096, help="512 stay in the cache")
    add_measuring(parser, budget=15.0, timeout=120.0)
    options = parser.parse_args()
    lines: list[dict[str, Any]] = []
    for model in options.models:
        with ExitStack() as stack:

            def start(name: str, python: Path, *script: str, stack: ExitStack = stack) -> Worker:
                return stack.enter_context(
                    Worker(name, python, *script, timeout=options.timeout, core=options.core)
                )

            workers = [start("ours", options.python, "ours.py")]
            workers += [
                start(f"ours-{width}", options.python, "ours.py", str(width))
                for width in options.widths
            ]
            workers += [
                start(name, options.peer_python, *PEERS[name])
                for name in options.peers
                if name in ONLY.get(model, options.peers)
            ]
            lines += _measure(model, workers, options)
        save("peers", lines)  # after each model, so that a run can be broken off
    for kind in KINDS:
        chosen = [line for line in lines if line["kind"] == kind]
        _report(kind, chosen, [*(f"ours-{w}" for w in options.widths), *options.peers])


def _measure(
    model: str, workers: list[Worker], options: argparse.Namespace
) -> list[dict[str, Any]]:
    lines = []
    failed: dict[str, str] = {}

    def attempt(worker: Worker, do: str, **arguments: Any) -> Any:
        """Ask, and drop a worker that fails for the rest of this kind of measure."""
        if worker.name in failed:
            return None
        try:
            return worker.ask(do, **arguments)
        except WorkerError as error:
            failed[worker.name] = str(error)
            return None

    for worker in workers:
        attempt(worker, "load", name=model, count=options.states)
    unloaded = dict(failed)
    for kind in KINDS:
        print(f"{model}: {kind} …", file=sys.stderr)
        failed = dict(unloaded)
        if kind == "build":
            limits = rounds(options, most=7)
            slow: dict[str, float] = {}

            def ask(worker: Worker, slow: dict[str, float] = slow) -> float | None:
                if worker.name not in slow:
                    taken = attempt(worker, "build_time")
                    if taken is None or taken < PATIENCE:
                        return taken
                    slow[worker.name] = taken
                return slow[worker.name]
        else:
            limits = rounds(options, most=25)
            values = {w.name: attempt(w, "start", kind=kind) for w in workers}
            # Ours comes first; when it fails, the others are held against the first that works.
            first = next((v for v in values.values() if v is not None), None)
            for name, other in values.items():
                if other is not None:
                    worst = _difference(first, other)
                    if not worst < 1e-9:
                        failed[name] = f"differs from the first by {worst:.1e} relative"

            def ask(worker: Worker, kind: str = kind) -> float | None:
                return attempt(worker, "run", kind=kind)

        taken = in_turn({w.name: lambda w=w, ask=ask: ask(w) for w in workers}, **limits)
        columns = {w.name: [round_[w.name] for round_ in taken] for w in workers}
        times = {name: v for name, v in columns.items() if None not in v}
        lines.append({"model": model, "kind": kind, "seconds": times, "failed": failed})
    return lines


def _difference(ours: list[list[float]], theirs: list[list[float]]) -> float:
    """Return the largest difference, relative to the largest derivative of its state."""
    worst = 0.0
    for a, b in zip(ours, theirs, strict=True):
        scale = max(map(abs, a))
        for u, v in zip(a, b, strict=True):
            if not abs(u - v) <= worst * scale:
                worst = abs(u - v) / scale
    return worst


def _report(kind: str, lines: list[dict[str, Any]], peers: list[str]) -> None:
    titles = {
        "build": "Build and compile, from SymPy expressions, no caches",
        "scalar": "Scalar: one state at a time in a native loop, for each state",
        "batched": "Batched: all states in one thread, widest vectors, for each state",
    }
    rows = []
    for line in lines:
        times = line["seconds"]
        ours = times.get("ours")
        cells = [line["model"], seconds(median(ours)) if ours else "fails"]
        ratios = {}
        for peer in peers:
            if peer in times and ours:
                ratios[peer] = pairwise(ours, times[peer])
                cells.append(f"{seconds(median(times[peer]))} ({ratios[peer]:.2f})")
            elif peer in times:
                cells.append(seconds(median(times[peer])))
            else:
                cells.append("fails")
        # The fastest peer is the one that ours looks worst against. Builds are not ranked: an
        # interpreted function is ready at once, and pays at every call.
        others = [ratio for name, ratio in ratios.items() if not name.startswith("ours")]
        cells.append(f"{max(others):.2f}" if others and kind != "build" else "")
        rows.append(cells)
    last = "ours / fastest" if kind != "build" else ""
    header = ("model", "ours", *(f"{p} (ours/it)" for p in peers), last)
    table(titles[kind], header, rows)
    notes = {f"{x['model']}, {name}: {why}" for x in lines for name, why in x["failed"].items()}
    for note in sorted(notes):
        print(f"  {note}")


if __name__ == "__main__":
    main()
