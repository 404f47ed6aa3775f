"""The sine and cosine of compiled code against mpmath, at millions of arguments up to 1e5.

Three families: spread evenly, spread evenly in the exponent, and the doubles nearest to kπ/2 with
a neighbour on each side, for every k up to 63,000. Errors are in units in the last place of the
exact value. Needs neither peers nor a quiet machine; two million arguments take some minutes.
"""

from __future__ import annotations

import argparse
from typing import Any

import mpmath as mp
import numpy as np
from harness.report import save, table
from mpmath.libmp import from_float, mpf_cos_sin, mpf_sub, to_float

from pydy._backends.llvm.native import LLVMBackend
from pydy._graph.lowering import lower
from pydy._graph.node import Graph

LARGEST = 1e5
BITS = 160  # enough for the sine of a double 1e-21 away from a multiple of π


def main() -> None:
    """Compare, print a table and write the results."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--points", type=int, default=1_000_000, help="of each random family")
    parser.add_argument("--multiples", type=int, default=63_000, help="the largest k")
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    kernels = {lanes: _kernel(lanes) for lanes in (1, 8)}
    results = []
    for family, angles in _families(options).items():
        exact = _exact(angles)
        for lanes, kernel in kernels.items():
            t = np.zeros(len(angles))
            found, _ = kernel.evaluate(t, angles[:, None], np.empty((1, 0)), np.empty(0))
            results.append({"family": family, "points": len(angles), "lanes": lanes})
            for name, column, (head, tail) in zip(("sin", "cos"), found.T, exact, strict=True):
                error = np.abs((column - head) - tail) / np.spacing(np.abs(head))
                worst = int(error.argmax())
                results[-1] |= {name: error[worst], f"{name}_at": angles[worst].hex()}
    rows = [
        (r["family"], r["lanes"], f"{r['points']:,}", f"{r['sin']:.3f}", f"{r['cos']:.3f}")
        for r in results
    ]
    header = ("arguments", "lanes", "points", "sin", "cos")
    table("Largest error in units in the last place", header, rows)
    save("sincos", results)


def _kernel(lanes: int) -> Any:
    graph = Graph()
    angle = graph.input("x", 0)
    nodes = [graph.call("sin", angle), graph.call("cos", angle)]
    return LLVMBackend(lanes=lanes).compile(lower(graph, (1, 0, 0), [("values", (2,), nodes)]))


def _families(options: argparse.Namespace) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(options.seed)
    sign = rng.choice([-1.0, 1.0], options.points)
    with mp.workprec(BITS):
        near = np.array([float(k * mp.pi / 2) for k in range(1, options.multiples + 1)])
    beside = [near, np.nextafter(near, 0.0), np.nextafter(near, np.inf)]
    return {
        "uniform": rng.uniform(-LARGEST, LARGEST, options.points),
        "log-uniform": sign * 10.0 ** rng.uniform(-20.0, np.log10(LARGEST), options.points),
        "beside kπ/2": np.concatenate(beside),
    }


def _exact(angles: np.ndarray) -> tuple[tuple[np.ndarray, np.ndarray], ...]:
    """Return sine and cosine, each as the nearest double and what is left to the exact value."""
    parts = np.empty((4, len(angles)))
    for k, angle in enumerate(angles.tolist()):
        cosine, sine = mpf_cos_sin(from_float(angle), BITS)
        for row, value in ((0, sine), (2, cosine)):
            head = to_float(value)
            parts[row, k] = head
            parts[row + 1, k] = to_float(mpf_sub(value, from_float(head)))
    return (parts[0], parts[1]), (parts[2], parts[3])


if __name__ == "__main__":
    main()
