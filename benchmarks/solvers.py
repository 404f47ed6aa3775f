"""Native solvers against other packages' and against odeint: ``make bench-solvers``."""

from __future__ import annotations

import argparse
import sys
import tempfile
from contextlib import ExitStack
from statistics import median
from typing import Any

from harness.contest import OURS, RADAU, TARGETS, Contest, limits_met
from harness.driver import Worker, WorkerError, in_turn
from harness.options import add_measuring, add_pythons, rounds, take_parts
from harness.report import pairwise, seconds, table

# Model, and what our best may take of the fastest peer's time.
LIMITS = {
    **{"pendulum-1": 1.0, "pendulum-5": 0.6, "pendulum-10": 0.6, "bicycle": 0.6, "rods-3": 0.6},
    **{"rider-bicycle": 1.0, "springs-100-absolute": 1.0},
}
PEERS = ("heyoka", "casadi", "diffsol", "sundae")
RELEASED = "0.9.4"
SCRIPTS = {
    OURS: ("solve_ours.py",),
    RADAU: ("solve_ours.py", "radau"),
    RELEASED: ("solve_released.py",),
    **{peer: (f"solve_{peer}.py",) for peer in PEERS},
}
PARTS = ("precision", "integrate", "first-use")
# What `integrate()` is asked to gain on the default odeint, by the number of links.
GAINS = {"1": 15.0, "10": 2.0}
WARM, COLD = 0.05, 2.0
ROUNDS = 5, 25


def main() -> None:
    """Measure each part, print its tables, and write all results."""
    parser = argparse.ArgumentParser(description=__doc__)
    add_pythons(parser, "--peer-python", "--reference", "--python")
    parser.add_argument("--parts", nargs="+", default=PARTS, choices=PARTS)
    parser.add_argument("--models", nargs="+", default=list(LIMITS), choices=list(LIMITS))
    others = (*PEERS, RELEASED)
    parser.add_argument("--peers", nargs="+", default=others, choices=others)
    add_measuring(parser, budget=30.0, timeout=600.0)
    options = parser.parse_args()
    measures = {
        "precision": _precision,
        "integrate": _integrate,
        "first-use": _first_use,
    }
    take_parts("solvers", options.parts, measures, options)


def _worker(options: argparse.Namespace, name: str, *script: str) -> Worker:
    own = {OURS: options.python, RADAU: options.python, RELEASED: options.reference}
    timeout = min(options.timeout, 60.0) if name == RADAU else options.timeout
    python = own.get(name, options.peer_python)
    return Worker(name, python, *script, timeout=timeout, core=options.core)


# -- time at equal error ------------------------------------------------------------------------


def _precision(options: argparse.Namespace) -> Any:
    lines: list[dict[str, Any]] = []
    summaries = []
    for model in options.models:
        with ExitStack() as stack:
            workers = [
                stack.enter_context(_worker(options, name, *SCRIPTS[name]))
                for name in (OURS, RADAU, *options.peers)
            ]
            contest = Contest(model, workers, step=1.0 if options.quick else 0.5)
            contest.find_reference()
            contest.scan()
            taken = contest.race(rounds(options, *ROUNDS))
            summaries.append(contest.summary())
        lines += taken
        yield [*taken, summaries[-1]]
    for target in TARGETS:
        _report_target(target, [line for line in lines if line["target"] == target], options.peers)
    _report_builds(summaries, options.peers)
    _report_misses(limits_met(lines, LIMITS))


def _report_target(target: float, lines: list[dict[str, Any]], peers: list[str]) -> None:
    others = (*peers, "odeint")
    rows = []
    for line in lines:
        times, ratios, best = line["best_seconds"], line["ratios"], line["best"]
        cells = [line["model"], f"{_time(times.get(OURS))} {best.get(OURS, '')}"]
        for name in others:
            if name in ratios:
                cells.append(f"{_time(times[name])} {best[name]} ({ratios[name]:.2f})")
            else:
                cells.append("–")
        cells.append(f"{line['ratio']:.2f}" if line["ratio"] is not None else "–")
        cells.append(f"{LIMITS[line['model']]}")
        rows.append(cells)
    header = ("model", "ours", *(f"{name} (ours/it)" for name in others), "fastest", "asked")
    table(f"One integration to an error of {target:g}", header, rows)
    methods = sorted({who for line in lines for who in line["seconds"] if _is_own(who)})
    own = [
        [line["model"], *(_time(line["seconds"].get(method)) for method in methods)]
        for line in lines
    ]
    table(f"Our methods, to an error of {target:g}", ("model", *methods), own)


def _is_own(contestant: str) -> bool:
    return contestant.startswith((f"{OURS} ", f"{RADAU} "))


def _time(values: list[float] | None) -> str:
    return seconds(median(values)) if values else "–"


def _report_builds(summaries: list[dict[str, Any]], peers: list[str]) -> None:
    rows = [
        [s["model"], f"{s['spread']:.1e}", *(seconds(s["built"].get(n)) for n in (OURS, *peers))]
        for s in summaries
    ]
    table("Spread of references; builds, not counted", ("model", "spread", OURS, *peers), rows)
    for summary in summaries:
        for who, why in summary["failed"].items():
            print(f"  {summary['model']}, {who}: {why}")


def _report_misses(misses: list[str]) -> None:
    for miss in misses:
        print(f"  above what is asked: {miss}")


# -- integrate() of a System --------------------------------------------------------------------


def _integrate(options: argparse.Namespace) -> Any:
    lines: list[dict[str, Any]] = []
    for model in GAINS:
        print(f"integrate, {model} links …", file=sys.stderr)
        with ExitStack() as stack:

            def start(name: str, solver: str | None, stack: ExitStack = stack) -> Worker | None:
                worker = stack.enter_context(_worker(options, name, "pydy_worker.py"))
                try:
                    worker.ask("load", name=model)  # noqa: B023 used at once
                    worker.ask("prepare_integration", solver=solver, tolerance=1e-9)
                except WorkerError as error:
                    print(f"  {name} is left out: {error}", file=sys.stderr)
                    return None
                return worker

            workers = {"dop853": start(OURS, "dop853"), "odeint": start(OURS, None)}
            if RELEASED in options.peers:
                workers[RELEASED] = start(RELEASED, None)
            measures = {
                name: lambda worker=worker: worker.ask("integrate_again")
                for name, worker in workers.items()
                if worker is not None
            }
            taken = in_turn(measures, **rounds(options, *ROUNDS))
        times = {name: [r[name] for r in taken] for name in measures}
        gains = {name: pairwise(v, times["dop853"]) for name, v in times.items()}
        lines.append({"model": model, "seconds": times, "gains": gains})
        yield lines[-1:]
    rows = [
        [
            line["model"],
            *(_time(line["seconds"].get(name)) for name in ("dop853", "odeint", RELEASED)),
            f"{line['gains']['odeint']:.1f}",
            f"{GAINS[line['model']]:g}",
            f"{line['gains'][RELEASED]:.1f}" if RELEASED in line["gains"] else "–",
        ]
        for line in lines
    ]
    header = ("links", "dop853", "odeint", RELEASED, "odeint / dop853", "asked", f"{RELEASED} / it")
    table("integrate(), 10 s, 1,001 points, tolerances 1e-9", header, rows)


# -- first use ----------------------------------------------------------------------------------


def _first_use(options: argparse.Namespace) -> Any:
    lines = []
    for method in ("dop853", "radau"):
        print(f"first use, {method} …", file=sys.stderr)
        with tempfile.TemporaryDirectory() as warm:

            def measure(cache: str, method: str = method) -> dict[str, float]:
                with _worker(options, OURS, "first_use.py") as worker:
                    answer: dict[str, float] = worker.ask(
                        "first_use", name="1", cache=cache, method=method
                    )
                    return answer

            def cold() -> dict[str, float]:
                with tempfile.TemporaryDirectory() as empty:
                    return measure(empty)

            measure(warm)
            taken = in_turn({"cold": cold}, **rounds(options, 3, 3))
            warmed = in_turn({"warm": lambda w=warm: measure(w)}, **rounds(options, 9, 9))
        by_cache = {"warm": [r["warm"] for r in warmed], "cold": [r["cold"] for r in taken]}
        for cache, answers in by_cache.items():
            times = {key: [a[key] for a in answers] for key in answers[0]}
            lines.append({"method": method, "cache": cache, "seconds": times})
            yield lines[-1:]
    keys = ("solvers", "first", "second", "added")
    rows = [
        [
            f"{line['method']}, {line['cache']} cache",
            *(seconds(median(line["seconds"][key])) for key in keys),
            seconds(WARM if line["cache"] == "warm" else COLD),
        ]
        for line in lines
    ]
    header = ("solver", "import solvers", "first", "second", "added", "asked")
    table("First native integration of a process, the equations' code ready", header, rows)


if __name__ == "__main__":
    main()
