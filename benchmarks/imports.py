"""How long `import pydy.system` takes, beside `import sympy.physics.mechanics` alone."""

from __future__ import annotations

import argparse
import subprocess
import sys
from statistics import median

from harness.driver import in_turn
from harness.report import pairwise, save, seconds, table
from harness.serve import time_of

STATEMENTS = {
    "nothing": "pass",
    "sympy.physics.mechanics": "import sympy.physics.mechanics",
    "numpy and scipy.integrate": "import numpy, scipy.integrate",
    "pydy": "import pydy",
    "pydy.system": "import pydy.system",
}


def main() -> None:
    """Time fresh interpreters, in turn."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=9)
    options = parser.parse_args()

    def run(statement: str) -> float:
        return time_of(lambda: subprocess.run([sys.executable, "-c", statement], check=True))

    for statement in STATEMENTS.values():
        run(statement)  # the files are in memory from now on
    measures = {name: lambda s=s: run(s) for name, s in STATEMENTS.items()}
    rounds = in_turn(measures, least=options.rounds, most=options.rounds)
    times = {name: [r[name] for r in rounds] for name in STATEMENTS}
    base = times["sympy.physics.mechanics"]
    rows = [(name, seconds(median(v)), f"{pairwise(v, base):.2f}") for name, v in times.items()]
    table("Import, in a fresh interpreter", ("what", "time", "of sympy's"), rows)
    save("imports", times)


if __name__ == "__main__":
    main()
