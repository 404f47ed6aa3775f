"""Constraints stabilised by constraint forces, after Baumgarte.

J. Baumgarte, "Stabilization of constraints and integrals of motion in dynamical systems", Computer
Methods in Applied Mechanics and Engineering 1 (1972) 1–16, with both gains chosen for critical
damping.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pydy._assembly.assembly import Assembly
from pydy._assembly.tuning import NO_SHARE, SAME_RATE, SAME_SHARE
from pydy._graph.derivative import dense_jacobian
from pydy._graph.lower import lower
from pydy._graph.rewrite import substitute
from pydy._graph.solve.choose import solve_accelerations
from pydy._mechanics.generic import generic_inputs, values_of

__all__ = ["stabilised"]

_TRIALS = 3


def stabilised(assembly: Assembly, gain: float) -> Assembly:
    """Return the system whose constraint residuals c obey c'' + 2 g c' + g² c = 0.

    A nonholonomic residual v obeys v' + 2 g v = 0.
    """
    graph, n = assembly.graph, len(assembly.speeds)
    count = len(assembly.velocity)
    share = _shares(assembly)
    forcing = list(assembly.forcing)
    for i, node in enumerate(assembly.velocity):
        terms = [(forcing[n - count + i], 1.0), (node, -2.0 * gain)]
        terms += [
            (h, -gain * gain * float(s))
            for h, s in zip(assembly.holonomic, share[i], strict=True)
            if s
        ]
        forcing[n - count + i] = graph.sum(terms)
    rows = [assembly.mass_matrix[i * n : (i + 1) * n] for i in range(n)]
    first = graph.args[assembly.speeds[0]][1]
    before = assembly.rates[first : first + n]
    after = solve_accelerations(graph, rows, forcing, "lu", assembly.passes)
    mapping = dict(zip(before, after, strict=True))
    return replace(
        assembly,
        forcing=forcing,
        rates=substitute(graph, assembly.rates, mapping),
        outputs=substitute(graph, assembly.outputs, mapping),
        ordinary=substitute(graph, assembly.ordinary, mapping),
    )


def _shares(assembly: Assembly) -> np.ndarray:
    """Return, for each velocity constraint, of which holonomic ones it is the rate, and how much.

    Raises
    ------
    ValueError
        The last rows of the mass matrix are not those of the velocity constraints, or a velocity
        constraint is the rate of holonomic ones with factors that change.
    """
    graph, speeds = assembly.graph, assembly.speeds
    n, count = len(speeds), len(assembly.velocity)
    first = graph.args[speeds[0]][1]
    coordinates = [graph.input("x", k) for k in range(first)]
    names = {
        "motion": (assembly.velocity, speeds),
        "gradient": (assembly.holonomic, coordinates),
        "kinematics": (assembly.rates[:first], speeds),
    }
    blocks = []
    for name, (nodes, by) in names.items():
        cells = dense_jacobian(graph, nodes, by)
        blocks.append((name, (len(nodes), len(by)), cells))
    blocks.append(("rows", (count, n), assembly.mass_matrix[(n - count) * n :]))
    program = lower(graph, assembly.sizes, blocks)
    found: list[np.ndarray] = []
    for seed in range(_TRIALS):
        values = values_of(program, *generic_inputs(assembly.sizes, [seed]))
        part = {name: block[0] for name, block in values.items()}
        if not np.allclose(part["rows"], part["motion"], rtol=SAME_RATE, atol=NO_SHARE):
            raise ValueError(
                "`constraints='baumgarte'` needs acceleration constraints that are the rates of "
                "the velocity constraints, in the same order and not scaled; these are not. Use "
                "constraints='project'."
            )
        reach = part["gradient"] @ part["kinematics"]
        share, *_ = np.linalg.lstsq(reach.T, part["motion"].T, rcond=SAME_RATE)
        residual = part["motion"] - share.T @ reach
        left, size = (np.linalg.norm(rows, axis=1) for rows in (residual, part["motion"]))
        genuine = left > SAME_SHARE * size
        found.append(np.where(genuine[:, None], 0.0, share.T))
    if not all(np.allclose(found[0], other, atol=SAME_SHARE) for other in found[1:]):
        raise ValueError(
            "`constraints='baumgarte'` needs velocity constraints that are the rates of holonomic "
            "ones with constant factors; here the factors depend on the state. Use "
            "constraints='project', or write the velocity constraints as `holonomic.diff(t)`."
        )
    return np.where(np.abs(found[0]) < NO_SHARE, 0.0, found[0])
