"""Optimal control and identification beside opty and CasADi.

Everybody has the same equations, transcription, mesh and guess, and the IPOPT and MUMPS of CasADi's
wheel. Ratios above one say that the other takes longer.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from harness.driver import BUILD, Worker, WorkerError, in_turn
from harness.optimal import TASKS
from harness.options import add_measuring, add_pythons, rounds, take_parts
from harness.report import pairwise, seconds, table
from harness.standing import GAINS

Lines = list[dict[str, Any]]
CRANES = ("crane-1", "crane-5", "crane-10")
PEERS = ("opty", "casadi")
TOLERANCE = {"tol": 1e-8}
# Short intervals in the layers at both ends of 10,000 s, which are a second or so wide.
SIDE = [0.0, 1e-4, 2e-4, 4e-4, 7e-4, 1.2e-3, 2e-3, 4e-3]
LAYERS = [*SIDE, 0.5, *(1.0 - s for s in reversed(SIDE))]
# Two that minimise the same function from the same point to 1e-8, in units that may differ.
SAME = 1e-5


def worker(name: str, options: argparse.Namespace, cache: str | Path = "") -> Worker:
    """Start a worker in its environment."""
    python = options.python if name == "ours" else options.peer_python
    own = {"timeout": options.timeout, "core": options.core}
    return Worker(name, python, f"control_{name}.py", *([str(cache)] if cache else []), **own)


@contextmanager
def everybody(options: argparse.Namespace) -> Iterator[dict[str, Worker]]:
    """Start a worker of each kind; ours with an empty cache."""
    with ExitStack() as stack:
        cache = stack.enter_context(tempfile.TemporaryDirectory())
        names = ("ours", *PEERS)
        yield {n: stack.enter_context(worker(n, options, cache * (n == "ours"))) for n in names}


def load(
    one: Worker, task: str, method: str, options: argparse.Namespace, nodes: int | None = None
) -> None:
    """Have a worker build a problem; opty's compiled code is kept, as it takes minutes."""
    kept = {}
    if one.name == "opty":
        folder = BUILD / "opty" / f"{task}-{method}"
        folder.mkdir(parents=True, exist_ok=True)
        kept = {"folder": str(folder)}
    one.ask("load", task=task, nodes=nodes or options.nodes, method=method, **kept)


def note(failed: list[str], what: str, error: WorkerError) -> None:
    """Keep why a peer has no figure."""
    failed.append(f"{what}: {error}")


# -- build --------------------------------------------------------------------------------------


def build(options: argparse.Namespace) -> Iterator[Lines]:
    """From equations to compiled functions: ours with the Hessian, opty's without."""
    for task in options.tasks or CRANES:
        taken: dict[str, list[float]] = {}

        def built(name: str, cache: str | Path, task: str = task) -> float:
            with worker(name, options, cache) as one:
                found: float = one.ask("load", task=task, nodes=101, method="backward-euler")[
                    "seconds"
                ]
            return found

        with tempfile.TemporaryDirectory() as kept:

            def cold() -> float:
                with tempfile.TemporaryDirectory() as folder:
                    return built("ours", folder)

            built("ours", kept)
            few = {"least": 1, "most": 1 if options.quick else 3, "budget": options.budget}
            measures = {
                "cold": cold,
                "warm": lambda kept=kept: built("ours", kept),
                **{name: lambda name=name: built(name, "") for name in PEERS},
            }
            found = in_turn(measures, **few)
        taken = {name: [r[name] for r in found] for name in measures}
        yield [{"task": task, "seconds": taken}]


def show_build(lines: Lines) -> None:
    """Print the table."""
    rows = [
        [
            line["task"],
            *(seconds(median(line["seconds"][k])) for k in ("cold", "warm", *PEERS)),
            f"{pairwise(line['seconds']['opty'], line['seconds']['cold']):.1f}",
        ]
        for line in lines
    ]
    header = ("task", "ours, cold", "from the cache", *PEERS, "opty / ours, cold")
    table("Build: ours and CasADi with the Hessian, opty without", header, rows)


# -- evaluations --------------------------------------------------------------------------------


def evaluate(options: argparse.Namespace) -> Iterator[Lines]:
    """Rows, Jacobian and Hessian; all must agree to 1e-9 of the largest."""
    for task in options.tasks or CRANES:
        with everybody(options) as workers:
            answers, failed = {}, []
            for name, one in workers.items():
                try:
                    load(one, task, "backward-euler", options)
                    answers[name] = one.ask("evaluations")
                except WorkerError as error:
                    note(failed, name, error)
            for name in PEERS:
                if name in answers:
                    compare(task, name, answers["ours"], answers[name])
            measures = {
                (name, kind): partial(workers[name].ask, "run", kind=kind)
                for name in answers
                for kind in ("rows", "jacobian", "hessian")
                if (name, kind) != ("opty", "hessian")
            }
            found = in_turn(measures, **rounds(options))
        taken = {f"{n} {kind}": [r[n, kind] for r in found] for n, kind in measures}
        yield [{"task": task, "nodes": options.nodes, "seconds": taken, "failed": failed}]


def compare(task: str, name: str, ours: dict[str, Any], theirs: dict[str, Any]) -> None:
    """Stop where a peer's functions have other values."""
    for kind in theirs:
        a, b = (np.atleast_1d(side[kind]) for side in (ours, theirs))
        error = np.abs(a - b).max() / np.abs(a).max()
        if not error < 1e-9:
            raise SystemExit(f"{task}: {name} has other {kind}, by {error:.1e} of the largest.")


def show_evaluate(lines: Lines) -> None:
    """Print the table."""
    header = ["task"]
    for kind in ("rows", "jacobian", "hessian"):
        header += [f"{kind}: ours", *(f"{p} / ours" for p in PEERS)]
    rows = []
    for line in lines:
        taken, row = line["seconds"], [line["task"]]
        for kind in ("rows", "jacobian", "hessian"):
            own = taken[f"ours {kind}"]
            row.append(seconds(median(own)))
            others = [taken.get(f"{p} {kind}") for p in PEERS]
            row += ["–" if t is None else f"{pairwise(t, own):.1f}" for t in others]
        rows.append(row)
    table("One evaluation over the whole mesh", header, rows)


# -- solves -------------------------------------------------------------------------------------


def solve(options: argparse.Namespace) -> Iterator[Lines]:
    """Whole solves of built problems; all must find the same optimum."""
    methods = ("backward-euler", "midpoint")
    for task in options.tasks or (*CRANES, "swing-up", "sliding"):
        for method in methods:
            with everybody(options) as workers:
                firsts, failed = {}, []
                for name, one in workers.items():
                    try:
                        load(one, task, method, options)
                        firsts[name] = one.ask("solve", options=TOLERANCE)
                    except WorkerError as error:
                        note(failed, name, error)
                measures = {n: partial(workers[n].ask, "solve", options=TOLERANCE) for n in firsts}
                measures["search"] = partial(workers["ours"].ask, "search", options=TOLERANCE)
                found = in_turn(measures, **rounds(options))
            yield [
                {
                    **{"task": task, "method": method, "nodes": options.nodes, "failed": failed},
                    "seconds": {n: [r[n]["seconds"] for r in found] for n in measures},
                    "objectives": {n: first["objective"] for n, first in firsts.items()},
                    "iterations": {n: first["iterations"] for n, first in firsts.items()},
                }
            ]


def show_solve(lines: Lines) -> None:
    """Print the table."""
    rows = []
    for line in lines:
        taken, objectives = line["seconds"], line["objectives"]
        row = [f"{line['task']}, {line['method']}", seconds(median(taken["ours"]))]
        for name in PEERS:
            if name not in taken:
                row.append("–")
                continue
            same = abs(objectives[name] / objectives["ours"] - 1.0) < SAME
            row.append(f"{pairwise(taken[name], taken['ours']):.2f}{'' if same else '*'}")
        both = (taken.get("casadi"), taken["search"])
        row.append(f"{pairwise(*both):.2f}" if both[0] else "–")
        row.append(" ".join(str(line["iterations"].get(n) or "–") for n in ("ours", *PEERS)))
        rows.append(row)
    header = ("task", "ours", *(f"{p} / ours" for p in PEERS), "casadi / our search", "iterations")
    table("Whole solves; a star: another optimum", header, rows)


# -- where the time of a search goes ------------------------------------------------------------


def shares(options: argparse.Namespace) -> Iterator[Lines]:
    """Processor time by IPOPT's own account, on a fine mesh."""
    for task in options.tasks or (*CRANES, "swing-up"):
        with tempfile.TemporaryDirectory() as cache, worker("ours", options, cache) as ours:
            ours.ask("load", task=task, nodes=10 * options.nodes, method="backward-euler")
            few = 1 if options.quick else 5
            yield [{"task": task, "shares": [ours.ask("shares") for _ in range(few)]}]


def show_shares(lines: Lines) -> None:
    """Print the table."""
    rows = []
    for line in lines:
        keys = ("linear algebra", "evaluations")
        parts = [median(s[key] / s["seconds"] for s in line["shares"]) for key in keys]
        rows.append([line["task"], *(f"{100 * part:.1f} %" for part in parts)])
    table("Shares of a search's processor time", ("task", "linear algebra", "evaluations"), rows)


# -- known optima -------------------------------------------------------------------------------

OPTIMA: dict[str, dict[str, list[tuple[Any, ...]]]] = {
    # The smallest of these that reaches the optimum is timed; the peer's alike.
    "swing-up": {
        "ours": [("radau", *pair) for pair in ((3, 20), (3, 30), (3, 40), (5, 30))],
        "opty": [("midpoint", n) for n in (101, 201, 401, 801, 1601, 3201)],
    },
    "betts-10.7": {
        "ours": [("radau", order, LAYERS) for order in (8, 10, 12)],
        "opty": [("midpoint", 10_001)],
    },
}


def optimum(options: argparse.Namespace) -> Iterator[Lines]:
    """The time of the coarsest mesh that reaches a known optimum to 1e-5, of its own best kind."""
    for task, tried in OPTIMA.items():
        if options.tasks and task not in options.tasks:
            continue
        known = TASKS[task].optimum
        with tempfile.TemporaryDirectory() as cache:
            found: dict[str, Any] = {}
            for name, settings in tried.items():
                with worker(name, options, cache * (name == "ours")) as one:
                    for setting in settings:
                        method, *rest = setting
                        try:
                            if name == "ours":
                                order, mesh = rest
                                given = {"order": order, "mesh": mesh, "nodes": 2}
                                one.ask("load", task=task, method=method, **given)
                            else:
                                load(one, task, method, options, rest[0])
                            first = one.ask("solve", options=TOLERANCE)
                        except WorkerError as error:
                            found[name] = {"failed": str(error)}
                            continue
                        error = abs(first["objective"] / known - 1.0)
                        runs = [first["seconds"]]
                        found[name] = {
                            "setting": rest[0] if name == "opty" else rest,
                            "error": error,
                        }
                        if error < 1e-5 or setting == settings[-1]:
                            few = 1 if options.quick else 5
                            runs = [one.ask("solve", options=TOLERANCE) for _ in range(few)]
                            found[name]["seconds"] = [run["seconds"] for run in runs]
                            break
            yield [{"task": task, **found}]


def show_optimum(lines: Lines) -> None:
    """Print the table."""
    rows = []
    for line in lines:
        row = [line["task"]]
        times = []
        for name in ("ours", "opty"):
            one = line.get(name, {})
            if "seconds" not in one:
                row += [one.get("failed", "–")[:40], "–"]
                continue
            times.append(median(one["seconds"]))
            row += [f"{one['error']:.1e}", seconds(times[-1])]
        row.append(f"{times[1] / times[0]:.0f}" if len(times) == 2 else "–")
        rows.append(row)
    header = ("task", "our error", "ours", "opty's error", "opty", "opty / ours")
    table("Known optima to 1e-5, each on the coarsest mesh that reaches it", header, rows)


# -- identification -----------------------------------------------------------------------------


def standing(options: argparse.Namespace) -> Iterator[Lines]:
    """Gains of a standing person, from zeros and near the truth; processor times."""
    own = {"timeout": options.timeout, "core": options.core}
    with ExitStack() as stack:
        cache = stack.enter_context(tempfile.TemporaryDirectory())
        folder = BUILD / "opty" / "standing"
        folder.mkdir(parents=True, exist_ok=True)
        path = str(folder / "samples.npy")
        ours = Worker("standing-ours", options.python, "standing_ours.py", cache, **own)
        opty = Worker("standing-opty", options.peer_python, "standing_opty.py", **own)
        for one in (ours, opty):
            stack.enter_context(one)
        ours.ask("load")
        ours.ask("trial", seed=0, path=path)
        lines: dict[str, Any] = {}
        first = ours.ask("fit", method="collocation", share=0.0)
        few = 1 if options.quick else 3
        for name, method, share in (
            *(("collocation, from zeros", "collocation", 0.0),),
            *(("collocation, from 0.7", "collocation", 0.7),),
            *(("shooting, from 0.7", "shooting", 0.7),),
        ):
            try:
                lines[name] = [ours.ask("fit", method=method, share=share) for _ in range(few)]
            except WorkerError as error:
                lines[name] = str(error)
        lines["collocation, first"] = [first]
        try:
            built = opty.ask("load", path=path, folder=str(folder))
            lines["opty, from 0.7"] = [{**opty.ask("fit", share=0.7), "built": built["seconds"]}]
        except WorkerError as error:
            lines["opty, from 0.7"] = str(error)
        yield [{"fits": lines}]
        within = []
        for seed in range(options.seeds):
            ours.ask("trial", seed=seed, path="")
            found = ours.ask("fit", method="collocation", share=0.0)
            away = np.subtract(found["gains"], GAINS.ravel()) / found["errors"]
            within.append(float(np.abs(away).max()))
        yield [{"largest distance in standard errors": within}]


def show_standing(lines: Lines) -> None:
    """Print the table."""
    rows = []
    for name, fits in lines[0]["fits"].items():
        if isinstance(fits, str):
            rows.append([name, fits[:60], "–"])
            continue
        last = fits[-1]
        away = np.abs(np.subtract(last["gains"], GAINS.ravel()) / GAINS.ravel()).max()
        took = seconds(median(f["seconds"] for f in fits))
        rows.append([f"{name}; {last.get('status', 'converged')}", took, f"{100 * away:.2g} %"])
    header = ("fit", "processor time", "largest error of a gain")
    table("Gains of a standing person", header, rows)
    within = lines[1]["largest distance in standard errors"]
    count = sum(w < 3.0 for w in within)
    print(f"  all eight gains within 3 standard errors: {count} of {len(within)} seeds")


# -- a large model ------------------------------------------------------------------------------


def pedals(options: argparse.Namespace) -> Iterator[Lines]:
    """Ten bodies, two loops and eight musculotendons on 50 intervals, from an empty cache."""
    own = {"timeout": options.timeout, "core": options.core}
    with (
        tempfile.TemporaryDirectory() as cache,
        Worker("pedals", options.python, "control_pedals.py", cache, **own) as ours,
    ):
        built = ours.ask("load", intervals=50, order=2)
        few = 1 if options.quick else 3
        yield [{"built": built, "solved": [ours.ask("solve") for _ in range(few)]}]


def show_pedals(lines: Lines) -> None:
    """Print the table."""
    built, solved = lines[0]["built"], lines[0]["solved"]
    took = [median(s[key] for s in solved) for key in ("seconds", "processor")]
    row = ["pedals", *(seconds(built[k]) for k in ("seconds", "processor")), *map(seconds, took)]
    header = ("", "built", "processor time", "solved", "processor time", "iterations")
    table("Ten bodies, two loops, eight musculotendons", header, [[*row, solved[0]["iterations"]]])


SHOWN = {
    "pedals": show_pedals,
    "standing": show_standing,
    "build": show_build,
    "evaluate": show_evaluate,
    "solve": show_solve,
    "shares": show_shares,
    "optimum": show_optimum,
}
PARTS = {
    "pedals": pedals,
    "standing": standing,
    "build": build,
    "evaluate": evaluate,
    "solve": solve,
    "shares": shares,
    "optimum": optimum,
}


def main(argv: Sequence[str] | None = None) -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    add_pythons(parser, "--peer-python", "--python")
    add_measuring(parser, budget=20.0, timeout=600.0)
    parser.add_argument("--parts", nargs="+", choices=[*PARTS], default=[*PARTS])
    parser.add_argument("--tasks", nargs="+", help="of harness/optimal.py")
    parser.add_argument("--nodes", type=int, default=101)
    parser.add_argument("--seeds", type=int, default=100, help="of the standing person")
    options = parser.parse_args(argv)

    def shown(part: str) -> Any:
        def measure(given: argparse.Namespace) -> Iterator[Lines]:
            lines: Lines = []
            for more in PARTS[part](given):
                lines += more
                yield more
            SHOWN[part](lines)

        return measure

    take_parts("control", options.parts, {part: shown(part) for part in PARTS}, options)


if __name__ == "__main__":
    main()
