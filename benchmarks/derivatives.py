"""Sensitivities and Jacobians against other packages': ``make bench-analysis``."""

from __future__ import annotations

import argparse
import os
import sys
from contextlib import ExitStack
from functools import partial
from statistics import median
from typing import Any

import numpy as np
from harness.contest import OURS, TARGETS, Contest
from harness.driver import Worker, WorkerError, in_turn
from harness.options import add_measuring, add_pythons, rounds, take_parts
from harness.precision import difference
from harness.program import compiled_jacobian
from harness.report import pairwise, seconds, table
from harness.sensitive import COLUMNS
from harness.serve import Repeated
from trees import HUMANOID, definition, tree

from pydy._assembly.programs import jacobian_program
from pydy._backends.llvm.native import LLVMBackend
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System

PARTS = ("columns", "ensemble", "adjoint", "equal-error", "diffrax", "forward-dynamics")
MODELS = ("pendulum-5", "bicycle")
DIFFRAX_MODELS = ("pendulum-1", "pendulum-5")  # the bicycle takes it many minutes to compile
# What is asked: state and columns, and a gradient by 100 parameters, over the state alone; ours
# over the peers'.
ADJOINT_ASKED = 5.0
COLUMNS_ASKED, EQUAL_ASKED, DIFFRAX_ASKED, DYNAMICS_ASKED = 2.5, 1.0, 1 / 20, 1.0
TOLERANCES = (1e-6, 1e-10)
STATES = 1024
TRAJECTORIES = 512
ROUNDS = 5, 25


def main() -> None:
    """Measure each part, print its table, and write all results."""
    parser = argparse.ArgumentParser(description=__doc__)
    add_pythons(parser, "--peer-python")
    parser.add_argument("--parts", nargs="+", default=PARTS, choices=PARTS)
    parser.add_argument("--models", nargs="+", default=MODELS, choices=MODELS)
    parser.add_argument("--diffrax-models", nargs="+", default=DIFFRAX_MODELS)
    parser.add_argument("--compiling", type=float, default=120.0, help="seconds, for diffrax")
    parser.add_argument("--peers", nargs="+", default=("heyoka", "casadi"))
    add_measuring(parser, budget=15.0, timeout=1200.0)
    options = parser.parse_args()
    measures = {
        "columns": _columns,
        "ensemble": _ensemble,
        "adjoint": _adjoint,
        "equal-error": _equal_error,
        "diffrax": _diffrax,
        "forward-dynamics": _forward_dynamics,
    }
    take_parts("derivatives", options.parts, measures, options)


def _worker(options: argparse.Namespace, name: str, script: str = "") -> Worker:
    python = sys.executable if name == OURS else options.peer_python
    script = script or f"sensitivities_{name}.py"
    return Worker(name, python, script, timeout=options.timeout, core=options.core)


def _columns(options: argparse.Namespace) -> Any:
    """State and columns over the state alone, in steps of the same size."""
    found, rows = [], []
    for model in options.models:
        with _worker(options, OURS) as ours:
            ours.ask("load", name=model)
            for method in ("dop853", "vern9"):
                ways = {"whole": method, "plain": f"{method} plain"}
                for way in ways.values():
                    ours.ask("reach", method=way, tolerance=1e-9)
                ask = {
                    key: partial(ours.ask, "time", method=way, tolerance=1e-9)
                    for key, way in ways.items()
                }
                taken = in_turn(ask, **rounds(options, *ROUNDS))
                whole, plain = ([r[key] for r in taken] for key in ways)
                found.append({"model": model, "method": method, "whole": whole, "plain": plain})
                ratio = f"{pairwise(whole, plain):.2f}"
                rows.append([model, method, *map(seconds, map(median, (plain, whole))), ratio])
    head = ["model", "method", "state", f"with {COLUMNS} columns", "ratio"]
    table(f"Sensitivities over the plain run; asked {COLUMNS_ASKED}", head, rows)
    yield found


def _ensemble(options: argparse.Namespace) -> Any:
    """A trajectory of an ensemble with columns over one without, both in lanes and on one core."""
    os.sched_setaffinity(0, {options.core})
    found, rows = [], []
    for links in (1, 5):
        system = n_link_pendulum_on_cart(links, cart_force=False)
        system.times, system.ode_solver = [0.0, 1.0], "dop853"
        angles = np.linspace(-0.5, 0.5, TRAJECTORIES)
        names = sorted(str(symbol) for symbol in system.constants_symbols)[:COLUMNS]
        run = partial(
            system.integrate_ensemble,
            initial_conditions={"q1": angles}, reduce="final", workers=1, rtol=1e-9, atol=1e-9,
        )  # fmt: skip
        ways = {"plain": run, "whole": partial(run, sensitivities=names)}
        taken = in_turn(
            {way: Repeated(call) for way, call in ways.items()}, **rounds(options, *ROUNDS)
        )
        plain, whole = ([r[way] / TRAJECTORIES for r in taken] for way in ways)
        found.append({"links": links, "columns": len(names), "plain": plain, "whole": whole})
        ratio = f"{pairwise(whole, plain):.2f}"
        cells = map(seconds, map(median, (plain, whole)))
        rows.append([f"pendulum, {links} links", str(len(names)), *cells, ratio])
    head = ["ensemble", "columns", "a trajectory", "with columns", "ratio"]
    table(f"Ensembles with sensitivities over plain ones, {TRAJECTORIES:,} each", head, rows)
    yield found


def _adjoint(options: argparse.Namespace) -> Any:
    """Gradients of a scalar by 100 parameters over `integrate`, all from Python."""
    os.sched_setaffinity(0, {options.core})
    found, rows = [], []
    for name, (system, wrt, last) in {"50 links": _links(50), "100 springs": _row(100)}.items():
        near = {"rtol": 1e-9, "atol": 1e-9}
        ways = {
            "plain": partial(system.integrate, **near),
            "final": partial(system.adjoint_gradient, wrt, final=last, **near),
            "integral": partial(system.adjoint_gradient, wrt, integral=last**2, **near),
        }
        taken = in_turn(
            {way: Repeated(call) for way, call in ways.items()}, **rounds(options, *ROUNDS)
        )
        times = {way: [r[way] for r in taken] for way in ways}
        found.append({"model": name, "parameters": len(wrt), **times})
        cells = [name, str(len(wrt)), seconds(median(times["plain"]))]
        for way in ("final", "integral"):
            ratio = pairwise(times[way], times["plain"])
            cells.append(f"{seconds(median(times[way]))} ({ratio:.2f})")
        rows.append(cells)
    head = ["model", "parameters", "plain", "of a state at the end", "of an integral"]
    table(f"Adjoint gradients over the plain run; asked {ADJOINT_ASKED:g}", head, rows)
    yield found


def _links(n: int) -> tuple[System, list[str], Any]:
    """Return a chain that swings on a cart, its masses and lengths, and its last angle."""
    system = n_link_pendulum_on_cart(n, cart_force=False)
    lengths, masses = [f"l{k}" for k in range(n)], [f"m{k}" for k in range(1, n + 1)]
    system.constants = {"g": 9.81, "m0": 1.0, **dict.fromkeys([*lengths, *masses], 1.0 / n)}
    system.initial_conditions = {f"q{k}": 0.3 for k in range(1, n + 1)}
    system.times, system.ode_solver = [0.0, 0.3], "dop853"
    return system, [*lengths, *masses], system.coordinates[n]


def _row(n: int) -> tuple[System, list[str], Any]:
    """Return a row of masses on springs, the springs' rates, and the last one's stretch."""
    system = multi_mass_spring_damper(n)
    system.initial_conditions = {"x0": 1.0}
    system.times, system.ode_solver = [0.0, 10.0], "dop853"
    return system, [f"k{k}" for k in range(n)], system.coordinates[n - 1]


def _equal_error(options: argparse.Namespace) -> Any:
    """Ours against heyoka's variational integrator and CVODES, at equal error."""
    lines: list[dict[str, Any]] = []
    summaries = []
    for model in options.models:
        with ExitStack() as stack:
            names = (OURS, *options.peers)
            workers = [stack.enter_context(_worker(options, name)) for name in names]
            contest = Contest(model, workers, step=1.0)
            contest.find_reference()
            contest.scan()
            lines += contest.race(rounds(options, *ROUNDS))
            summaries.append(contest.summary())
            for what, why in contest.failed.items():
                print(f"{model}: {what} failed: {why}", file=sys.stderr)
    for target in TARGETS:
        rows = []
        for line in lines:
            if line["target"] == target:
                cells = [line["model"]]
                for name in (OURS, *options.peers):
                    times, ratio = line["best_seconds"].get(name), line["ratios"].get(name)
                    text = f"{seconds(median(times))} {line['best'][name]}" if times else "–"
                    cells.append(f"{text} ({ratio:.3f})" if ratio else text)
                rows.append(cells)
        head = ["model", *(f"{n} (ours/it)" if n != OURS else n for n in (OURS, *options.peers))]
        table(f"State and {COLUMNS} columns to an error of {target:g}; asked 1", head, rows)
    yield [*lines, *summaries]


def _diffrax(options: argparse.Namespace) -> Any:
    """Ours against diffrax, both by tsit5 at the same tolerances.

    Forward and reverse mode are compiled in a process each: one may take too long.
    """
    found, rows = [], []
    for model in options.diffrax_models:
        with _worker(options, OURS) as ours:
            ours.ask("load", name=model)
            for mode in ("forward", "reverse"):
                try:
                    line = _diffrax_mode(options, model, mode, ours)
                except WorkerError as error:
                    print(f"{model}, {mode}: {error}", file=sys.stderr)
                    continue
                found += line
                rows += [
                    [
                        f"{model}, {mode}", f"{one['tolerance']:g}", f"{one['compiled']:.0f} s",
                        seconds(median(one[OURS])), seconds(median(one["peer"])),
                        f"{pairwise(one['peer'], one[OURS]):.0f}", f"{one['apart']:.0e}",
                    ]
                    for one in line
                ]  # fmt: skip
    head = ["model", "tolerance", "compiling it", "ours", "diffrax", "it/ours", "apart by"]
    title = f"{COLUMNS} columns and diffrax, tsit5; asked {1 / DIFFRAX_ASKED:.0f} times faster"
    table(title, head, rows)
    yield found


def _diffrax_mode(
    options: argparse.Namespace, model: str, mode: str, ours: Worker
) -> list[dict[str, Any]]:
    """Return a line for each tolerance."""
    lines = []
    with _worker(options, "diffrax") as peer:
        peer.timeout = options.compiling
        peer.ask("load", name=model)
        compiled = peer.ask("reach", method=mode, tolerance=TOLERANCES[0])["built"]
        peer.timeout = options.timeout
        for tolerance in TOLERANCES:
            asks = {OURS: (ours, "tsit5"), "peer": (peer, mode)}
            reached = {
                name: worker.ask("reach", method=method, tolerance=tolerance)["state"]
                for name, (worker, method) in asks.items()
            }
            expected, answer = reached[OURS], reached["peer"]
            if mode == "reverse":  # the gradient of the sum of all states at the end
                columns = len(answer) - 1
                n = len(expected) // (1 + columns)
                expected = np.reshape(expected[n:], (n, columns)).sum(axis=0)
                answer = answer[1:]
            taken = in_turn(
                {
                    name: partial(worker.ask, "time", method=method, tolerance=tolerance)
                    for name, (worker, method) in asks.items()
                },
                **rounds(options, *ROUNDS),
            )
            times = {name: [r[name] for r in taken] for name in asks}
            line = {"model": model, "mode": mode, "tolerance": tolerance, "compiled": compiled}
            lines.append({**line, "apart": difference(answer, expected), **times})
    return lines


def _forward_dynamics(options: argparse.Namespace) -> Any:
    """The Jacobian of u' by q and u of trees against Pinocchio's `computeABADerivatives`."""
    rng = np.random.default_rng(3)
    cases = {
        "arm of 7 joints": tree(list(range(-1, 6)), rng, aligned=True),
        "the same, any axes": tree(list(range(-1, 6)), rng),
        "tree of 29 joints": tree(HUMANOID, rng, aligned=True),
    }
    single = tree([-1], rng, aligned=True)
    found, rows = [], []
    for name, made in cases.items():
        sweeps = _jacobians(made)
        with _worker(options, "pinocchio", "arm_pinocchio.py") as peer:
            expected = peer.ask("load", tree=made, single=single)
            n = len(made["q"])
            jacobian = sweeps.pop("values")[n:]
            apart = max(
                np.abs(jacobian[:, part] - expected[key]).max() / np.abs(expected[key]).max()
                for key, part in (("q", slice(n)), ("v", slice(n, None)))
            )
            measures = {key: Repeated(sweep) for key, sweep in sweeps.items()}
            os.sched_setaffinity(0, {options.core})
            taken = in_turn(
                {**measures, "peer": lambda peer=peer: peer.ask("run")}, **rounds(options, *ROUNDS)
            )
        theirs = [whole - one for whole, one in (r["peer"] for r in taken)]
        own = {key: [r[key] / STATES for r in taken] for key in sweeps}
        found.append({"name": name, "peer": [r["peer"] for r in taken], **own})
        cells = [name, seconds(median(theirs)), seconds(median([r["peer"][0] for r in taken]))]
        cells += [f"{seconds(median(v))} ({pairwise(v, theirs):.2f})" for v in own.values()]
        rows.append([*cells, f"{apart:.0e}"])
    head = [
        "tree", "Pinocchio", "from Python", "ours, one by one (ours/it)", "in lanes", "apart by"
    ]  # fmt: skip
    table(f"Jacobian of forward dynamics, one state; asked {DYNAMICS_ASKED:g}", head, rows)
    yield found


def _jacobians(made: dict[str, Any]) -> dict[str, Any]:
    """Return what sweeps our Jacobian over states, and its values at the tree's own."""
    assembly = System(definition(made)).model.assembly
    kernels = {
        "one by one": compiled_jacobian(assembly, "rates", "x"),
        "in lanes": LLVMBackend(lanes=8).compile(jacobian_program(assembly, "rates", "x")),
    }
    state = np.array([*made["q"], *made["v"]])
    n = len(state)
    x = state + np.random.default_rng(0).normal(0.0, 0.1, (STATES, n))
    t, r, p = np.zeros(STATES), np.zeros((1, assembly.sizes[1])), np.zeros(assembly.sizes[2])
    found: dict[str, Any] = {}
    for name, kernel in kernels.items():
        kernel.link()
        out = np.empty((STATES, n * n))
        found[name] = partial(kernel.evaluate, t, x, r, p, out)
        found["values"] = kernel.evaluate(t[:1], state[None], r, p)[0].reshape(n, n)
    return found


if __name__ == "__main__":
    main()
