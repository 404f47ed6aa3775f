"""Ratios against the released pydy 0.9.4, measured side by side in one run: ``make bench``."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from statistics import median
from typing import Any

from harness.driver import Worker, WorkerError, in_turn
from harness.options import add_measuring, add_pythons, rounds
from harness.report import pairwise, save, seconds, table
from harness.ways import WAYS

MODELS = ("1", "5", "10", "20", "bicycle")
WAYS_OF = ("1", "10", "bicycle")  # the models of which every way of calling is measured


def main() -> None:
    """Measure every model and print a table for each kind of measure."""
    parser = argparse.ArgumentParser(description=__doc__)
    add_pythons(parser, "--reference", "--python")
    parser.add_argument("--models", nargs="+", default=MODELS, choices=MODELS)
    parser.add_argument("--ways", action="store_true", help="only the ways of calling")
    add_measuring(parser, budget=30.0)
    parser.set_defaults(core=None)  # starting up may use them all
    options = parser.parse_args()
    limits = rounds(options)
    lines: list[dict[str, Any]] = []
    for model in options.models:
        print(f"measuring {model} …", file=sys.stderr)
        with (
            Worker("ours", options.python, "pydy_worker.py", core=options.core) as ours,
            Worker("released", options.reference, "pydy_worker.py", core=options.core) as theirs,
        ):
            if not options.ways:
                lines += _measure(model, ours, theirs, limits)
            if model in WAYS_OF:
                lines += _ways(model, ours, theirs, limits)
    lines.sort(key=lambda line: line["measure"])
    _report(lines)
    save("run", lines)


def _measure(
    model: str, ours: Worker, theirs: Worker, limits: dict[str, Any]
) -> list[dict[str, Any]]:
    ours.ask("load", name=model)
    note = theirs.ask("load", name=model)
    lines: list[dict[str, Any]] = []

    def line(measure: str, a: list[float], b: list[float]) -> None:
        lines.append({"measure": measure, "model": model, "ours": a, "released": b, "note": note})

    def compare(measure: str, request: Callable[[Worker], Any], **others: Any) -> list[Any]:
        try:
            return in_turn(
                {"ours": lambda: request(ours), "released": lambda: request(theirs)},
                **{**limits, **others},
            )
        except WorkerError as error:
            lines.append({"measure": measure, "model": model, "note": str(error)})
            return []

    # A pair at 20 links takes two minutes, nearly all of it in the released package.
    few = {"least": 1} if model == "20" else {}
    taken = compare("integrate", lambda w: w.ask("integrate", state="warm"), **few)
    if taken:
        for which in ("first", "second"):
            a, b = ([pair[who][which] for pair in taken] for who in ("ours", "released"))
            line(f"integrate, {which} call", a, b)
    if model != "20":  # where starting up no longer shows
        for state, what in (("process", "process"), ("machine", "machine, empty cache")):
            taken = compare(
                f"integrate, first call of a {what}",
                lambda w, state=state: w.ask("integrate", state=state),
            )
            if taken:
                a, b = ([pair[who]["first"] for pair in taken] for who in ("ours", "released"))
                line(f"integrate, first call of a {what}", a, b)
    if model in ("10", "20"):
        generators = {ours.name: "llvm", theirs.name: "lambdify"}
        measure = "generation, llvm : lambdify"
        taken = compare(measure, lambda w: w.ask("generate", generator=generators[w.name]))
        if taken:
            line(measure, [p["ours"] for p in taken], [p["released"] for p in taken])
    measure = "right-hand side, llvm : cython"
    try:
        values = ours.ask("prepare", generator="llvm"), theirs.ask("prepare", generator="cython")
        _check(*values)
    except WorkerError as error:
        lines.append({"measure": measure, "model": model, "note": str(error)})
    else:
        taken = compare(measure, lambda w: w.ask("call"), most=25)
        if taken:
            line(measure, [p["ours"] for p in taken], [p["released"] for p in taken])
    return lines


def _ways(model: str, ours: Worker, theirs: Worker, limits: dict[str, Any]) -> list[dict[str, Any]]:
    """Measure every documented way of calling, the released package with its Cython generator."""
    ours.ask("load", name=model)
    note = theirs.ask("load", name=model)
    lines: list[dict[str, Any]] = []
    for way in WAYS:
        if way.startswith("evaluate_constraints") and model != "bicycle":
            continue
        line = {"measure": way, "model": model, "note": note}
        try:
            values = (
                ours.ask("prepare_way", way=way, generator="llvm"),
                theirs.ask("prepare_way", way=way, generator="cython"),
            )
            _check(*values, 1e-6 if way.startswith("integrate") else 1e-9)
            taken = in_turn(
                {w.name: lambda w=w: w.ask("call_way") for w in (ours, theirs)},
                **{**limits, "most": 15, "budget": 5.0},
            )
        except WorkerError as error:
            line["note"] = str(error)
        else:
            line |= {name: [pair[name] for pair in taken] for name in ("ours", "released")}
        lines.append(line)
    return lines


def _check(ours: list[float], theirs: list[float], tolerance: float = 1e-9) -> None:
    scale = max(map(abs, theirs)) or 1.0
    worst = max(abs(a - b) for a, b in zip(ours, theirs, strict=True)) / scale
    if not worst < tolerance:
        raise WorkerError(f"the derivatives differ by {worst:.1e} relative")


def _report(lines: list[dict[str, Any]]) -> None:
    rows = []
    for line in lines:
        if "ours" not in line:
            rows.append((line["measure"], line["model"], "–", "–", "fails", 0))
            continue
        a, b = line["ours"], line["released"]
        star = "*" if line["note"] else ""
        ratio = f"{pairwise(b, a):.1f}{star}"
        rows.append(
            (line["measure"], line["model"], seconds(median(a)), seconds(median(b)), ratio, len(a))
        )
    header = ("measure", "model", "ours", "0.9.4", "0.9.4 / ours", "pairs")
    table("Medians; the ratio is the median over pairs taken in turn", header, rows)
    for note in sorted({f"{x['model']}: {x['note']}" for x in lines if x["note"]}):
        print(f"  * {note}")


if __name__ == "__main__":
    main()
