"""Projection near singular configurations and with large constants: what ends how, counted.

Every native solver at every tolerance and step limit. A run that stops must be within 1e-6 of a
singular configuration and say so, or be refused for its energy; else the script exits with 1.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from pydy.errors import IntegrationError
from pydy.solvers.outcome import Outcome

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from zoo import singular

SOLVERS = ("dop853", "tsit5", "vern9", "radau")
TOLERANCES = (1e-6, 1e-8, 1e-10, 1e-12)


def cases(quick: bool) -> Iterator[tuple[str, Any, float]]:
    """Names, systems and times."""
    for windows in (1, 2, 3):
        yield f"N-four-bar, {windows} windows", singular.n_four_bar(windows), 10.0
    for speed in (4.0, 6.0):
        yield "slider-crank, r = l", singular.slider_crank(1.0, speed), 10.0
    for form in ("squared", "root"):
        for exponent in (0, 4, 8) if quick else range(9):
            for start, speed in ((1e-3, 0.0), (0.5, 0.0), (0.0, 1.0)):
                case = singular.bead(form, 10.0**exponent, start, speed)
                yield f"bead, {form}", case, 30.0


def outcome(case: Any, solver: str, end: float, options: dict[str, float]) -> str:
    """How one run ended."""
    case.system.ode_solver, case.system.times = solver, np.linspace(0.0, end, 11)
    try:
        case.system.integrate(constraints="project", max_steps=400_000, **options)
    except IntegrationError as error:
        if error.info["code"] == Outcome.ENERGY_CHANGED:
            return "refused"
        said = error.info["code"] == Outcome.SINGULAR_CONFIGURATION
        return "stopped, said" if said and case.distance(error.state) < 1e-6 else "FAILED"
    return "finished"


def main() -> int:
    """Print a table of counts."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="fewer circles, no steps of 1e-4")
    quick = parser.parse_args().quick
    counts: dict[str, Counter[str]] = {}
    for name, case, whole in cases(quick):
        for limit in (None, 1e-2) if quick else (None, 1e-2, 1e-4):
            end = min(whole, 10.0) if limit == 1e-4 else whole
            runs = [(s, {"rtol": tol, "atol": tol}) for s in SOLVERS for tol in TOLERANCES]
            runs = [(s, o if limit is None else {**o, "max_step": limit}) for s, o in runs]
            for solver, options in [*runs, ("rk4", {"step": limit or 1e-3})]:
                how = outcome(case, solver, end, options)
                counts.setdefault(name, Counter())[how] += 1
                if how == "FAILED":
                    print(name, solver, options)
    columns = ("finished", "refused", "stopped, said", "FAILED")
    print(f"{'':24}" + "".join(f"{c:>15}" for c in columns))
    for name, counter in counts.items():
        print(f"{name:24}" + "".join(f"{counter[c]:15}" for c in columns))
    return int(any(counter["FAILED"] for counter in counts.values()))


if __name__ == "__main__":
    sys.exit(main())
