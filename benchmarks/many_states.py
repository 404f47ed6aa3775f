"""Many states at once: public calls over their kernels in the cache; ``make bench-states``.

Each call takes arrays of 1,000, 4,096 and 100,000 states, with contiguous rows (C) or columns (F).
It is compared with the same kernel, of eight lanes, whose states and results stay in the cache.
Times are processor time of one thread; ratios are medians of pairs that are taken in turn.
"""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from harness.driver import in_turn
from harness.options import add_measuring, rounds
from harness.report import pairwise, save, seconds, table

from pydy import System
from pydy._backends.llvm.native import LLVMBackend
from pydy._backends.tuning import COMPILED_FROM
from pydy._kernel import Kernel
from pydy._program import Program
from pydy.examples import whipple_bicycle
from pydy.models import n_link_pendulum_on_cart

COUNTS = (1_000, 4_096, 100_000)
IN_CACHE = 256
# Goals by the order of the states: the kernel's time so many times.
GOALS = {"C": 1.3, "F": 1.5}
Call = Callable[[np.ndarray, np.ndarray], Any]


def bicycle() -> System:
    """Return the Carvallo–Whipple bicycle."""
    made = whipple_bicycle.derive()
    return System(made.definition, constants=whipple_bicycle.benchmark_parameters(made))


MODELS: dict[str, Callable[[], System]] = {
    "20 links": partial(n_link_pendulum_on_cart, 20, cart_force=False),
    "bicycle": bicycle,
}


def calls(system: System) -> dict[str, tuple[Call, Kernel]]:
    """Return public calls, each with the kernel that it evaluates."""
    model = system._now().model
    code = model.code
    found = {
        "evaluate_ode": (system.evaluate_ode, code.compiled("rates")),
        "evaluate_energy": (system.evaluate_energy, model.energies.kernel(code)),
        "evaluate_jacobian": (system.evaluate_jacobian, code.compiled_jacobian("rates", "x")),
    }
    if system.num_constraints:
        constraints = code.compiled("constraints")
        found["evaluate_constraints"] = (system.evaluate_constraints, constraints)
    return found


def in_lanes(kernel: Kernel) -> Kernel:
    """Return the Kernel that evaluates many states; columns of a Jacobian are lanes already."""
    program = kernel.program
    return LLVMBackend(lanes=8).compile(program) if isinstance(program, Program) else kernel


def processor_time(call: Callable[[], Any], states: int) -> float:
    """Return the seconds a state, of at least two thousand states."""
    number = max(1, 2_000 // states)
    start = time.process_time()
    for _ in range(number):
        call()
    return (time.process_time() - start) / (number * states)


def measure(name: str, system: System, options: argparse.Namespace) -> list[dict[str, Any]]:
    """Return a line for each call, number of states and order."""
    rng, lines = np.random.default_rng(0), []
    problem = system._now()
    for what, (call, kernel) in calls(system).items():
        wide, p = in_lanes(kernel), problem.p
        program = kernel.program
        few = rng.normal(0.3, 0.1, (IN_CACHE, program.signature.num_states))
        out = np.empty((IN_CACHE, program.signature.num_outputs))
        r = np.zeros((1, program.signature.num_specifieds))
        cached = partial(wide.evaluate, np.zeros(IN_CACHE), few, r, p, out)
        for count in options.counts:
            if count * program.signature.num_outputs > options.most:
                continue
            x, t = rng.normal(0.3, 0.1, (count, program.signature.num_states)), np.zeros(count)
            evaluated = 0
            while evaluated < COMPILED_FROM and wide is not kernel:  # from which lanes are used
                call(x, t)
                evaluated += count
            contest = {
                "cached": partial(processor_time, cached, IN_CACHE),
                "C": partial(processor_time, partial(call, x, t), count),
                "F": partial(processor_time, partial(call, np.asfortranarray(x), t), count),
            }
            taken = in_turn(contest, **rounds(options, most=options.pairs))
            times = {key: [each[key] for each in taken] for key in contest}
            lines.append({"model": name, "call": what, "states": count, **times})
    return lines


def main() -> None:
    """Measure and print the ratios."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--models", nargs="+", default=[*MODELS], choices=[*MODELS])
    parser.add_argument("--counts", nargs="+", type=int, default=COUNTS)
    parser.add_argument("--pairs", type=int, default=51)
    parser.add_argument(
        "--most", type=int, default=20_000_000, help="results of a call: larger ones are left out"
    )
    add_measuring(parser, budget=5.0)
    options = parser.parse_args()
    os.sched_setaffinity(0, {options.core})
    lines = []
    for name in options.models:
        lines += measure(name, MODELS[name](), options)
    rows = []
    for line in lines:
        ratios = [f"{pairwise(line[order], line['cached']):.2f}" for order in GOALS]
        cached = seconds(float(np.median(line["cached"])))
        rows.append((line["model"], line["call"], f"{line['states']:,}", cached, *ratios))
    goals = [f"{order} order (≤ {goal})" for order, goal in GOALS.items()]
    title = "Times a state over the kernel's in the cache"
    table(title, ("model", "call", "states", "kernel in cache", *goals), rows)
    save("many_states", lines)


if __name__ == "__main__":
    main()
