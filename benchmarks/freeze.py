"""Derive the benchmark set again and write it to ``frozen/``: ``python benchmarks/freeze.py``.

SymPy's own count of operations is taken here, from the expressions as they were derived.
"""

from __future__ import annotations

import argparse
import time

import sympy as sm
from harness import frozen
from harness.model import Model
from harness.models import MODELS, STANDARD


def cse_operations(model: Model) -> int:
    """Return the operations that SymPy's `cse` leaves in M and F together."""
    shape = (len(model.speeds), len(model.speeds))
    matrices = [sm.Matrix(*shape, model.mass_matrix), sm.Matrix(model.forcing)]
    replacements, reduced = sm.cse(matrices)
    return int(sum(sm.count_ops(e) for _, e in replacements) + sm.count_ops(reduced))


def main() -> None:
    """Freeze the models named on the command line, all standard ones by default."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("models", nargs="*", default=STANDARD, metavar="MODEL")
    parser.add_argument("--no-cse", action="store_true", help="skip SymPy's count")
    options = parser.parse_args()
    for name in options.models:
        start = time.perf_counter()
        model = MODELS[name]()
        derived = time.perf_counter()
        if not options.no_cse:
            model.about["cse_operations"] = cse_operations(model)
        counted = time.perf_counter()
        nodes = frozen.write(model)
        size = (frozen.FOLDER / f"{name}.json.gz").stat().st_size
        print(
            f"{name}: {nodes} nodes, {size / 1024:.0f} KiB, derived in {derived - start:.1f} s, "
            f"cse {model.about.get('cse_operations')} in {counted - derived:.1f} s"
        )


if __name__ == "__main__":
    main()
