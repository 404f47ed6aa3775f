"""From a tableau to the arrays that the compiled stepper reads."""

from __future__ import annotations

from functools import cache

import numpy as np

from pydy.solvers.run.layout import DEPTH, Method
from pydy.solvers.tableaus import tableau_of
from pydy.solvers.tuning import GROW, SAFETY, SHRINK

__all__ = ["IMPLICIT", "method_arrays"]

IMPLICIT = "radau"
_DEPTH = 3  # its collocation polynomial is a cubic


@cache
def method_arrays(name: str, length: int) -> Method:
    """Return a method's arrays for vectors of some padded length."""
    if name == IMPLICIT:
        nothing, none = np.zeros(0), np.zeros(0, dtype=np.int64)
        shape = np.zeros(5, dtype=np.int64)
        shape[DEPTH] = _DEPTH
        return _frozen(Method(shape, none, none, nothing, nothing, nothing))
    tableau = tableau_of(name)
    stages = len(tableau.stages)
    rows, offsets, weights = [0], [], []
    for row in (
        *tableau.stages,
        tableau.weights,
        *tableau.errors,
        *tableau.dense_stages,
        *tableau.interpolant,
    ):
        row = row or {0: 0.0}  # compiled code takes the last term of each by itself
        offsets += [stage * length for stage in row]
        weights += list(row.values())
        rows.append(len(offsets))
    counts = (
        stages,
        len(tableau.errors),
        len(tableau.dense_stages),
        len(tableau.interpolant) + 3,
        any(stages in row for row in tableau.errors),
    )
    exponent = 1.0 / ((tableau.error_order or 0) + 1)
    # K. Gustafsson's PI controller with the weights of DOPRI5 (Hairer, Nørsett, Wanner, IV.2).
    alpha = exponent - 0.75 * tableau.damping
    control = (exponent, alpha, tableau.damping, SAFETY, SHRINK, GROW)
    return _frozen(
        Method(
            shape=np.array(counts, dtype=np.int64),
            rows=np.array(rows),
            offsets=np.array(offsets),
            weights=np.array(weights),
            nodes=np.array(tableau.nodes),
            control=np.array(control),
        )
    )


def _frozen(method: Method) -> Method:
    for array in method:
        array.setflags(write=False)
    return method
