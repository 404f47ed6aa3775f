"""Forces along paths that wrap a surface, which SymPy 1.14 directs the other way round.

An actuator tells what it is. Of the loads that it makes, three forces are left: at both ends, and
at the surface, which they are in balance with. With the pull p along the path, of length L,

    p² = |F|²,    −p L' = P, the power of the three,

so that a spring's stiffness p'/L' is −(|F|²/2)'/P, and a damper's coefficient p/L' is −|F|²/P.
Where one of them is the same constant at all states, and negative, the force pushes where it should
pull. Muscles cannot be told from their loads.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from sympy.physics.mechanics import Force

from pydy._errors import UnsupportedFunctionError
from pydy._graph import Graph, signatures
from pydy._mechanics.components import dot, flat
from pydy._mechanics.equations import Equations
from pydy._mechanics.form import moving
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.reader import InputReader, is_reversed, warn_of_reversed, wrapped_force_pulls
from pydy._rank import HALF

_STATES = 4


def warn_of_reversed_forces(equations: Equations, actuators: Iterable[Any] = ()) -> None:
    """Warn of forces of springs, dampers and muscles that a WrappingPathway turns around.

    Actuators among the loads were told when these were read; the `actuators` are those of a System
    of SymPy, whose equations were formed from their loads.
    """
    for actuator in actuators:
        if is_reversed(actuator):
            warn_of_reversed(f"A {type(actuator).__name__}")
            return
    body = equations.multibody
    if body is None:
        return
    for three in _of_three(body):
        if wrapped_force_pulls() and _is_negative(body, three):
            places = ", ".join(str(where) for where, _ in three)
            warn_of_reversed(f"The force of a spring or damper, at {places},")
            return


def _of_three(body: Multibody) -> list[tuple[Any, ...]]:
    """Return three forces one after the other that a pathway may have made."""
    three = zip(body.loads, body.loads[1:], body.loads[2:], strict=False)
    return [
        loads
        for loads in three
        if all(isinstance(load, Force) for load in loads)
        and len({where for where, _ in loads}) == 3
        and _in_balance([vector for _, vector in loads])
    ]


def _in_balance(vectors: Iterable[Any]) -> bool:
    """Return whether vectors add up to nothing, as they are written."""
    graph = Graph()
    read = InputReader(graph, {}, ())
    sums: dict[Any, list[int]] = {}
    for part, frame in (part for vector in vectors for part in vector.args):
        own = sums.setdefault(frame, [graph.zero] * 3)
        try:
            nodes = read.all(part)
        except UnsupportedFunctionError:
            return False  # no pathway's
        sums[frame] = [graph.add(a, b) for a, b in zip(own, nodes, strict=True)]
    return not any(signatures(graph, flat([*sums.values()])))


def _is_negative(body: Multibody, loads: Sequence[Any]) -> bool:
    """Return whether three forces are a spring's or a damper's with a negative coefficient."""
    k = moving(body, in_bodies=False)
    g = k.graph
    forces = [k.vector(vector, k.inertial) for _, vector in loads]
    motions = [k.expressed(v, frame, k.inertial) for frame, v in (k.at(w) for w, _ in loads)]
    square = dot(g, forces[0], forces[0])
    power = g.add(*(dot(g, f, v) for f, v in zip(forces, motions, strict=True)))
    nodes = [*flat(forces), square, k.dt([square])[0], power]
    inputs = g.inputs(nodes)
    values = np.random.default_rng(0).uniform(0.5, 1.5, (len(inputs), _STATES))
    constant = [g.constant[n] for n in inputs]
    values[constant] = values[constant, :1]
    found = g.evaluator(nodes)(dict(zip(inputs, values, strict=True)), _STATES)
    pulls, (squares, rates, powers) = found[:, :9].reshape(_STATES, 3, 3), found[:, 9:].T
    sizes = np.linalg.norm(pulls, axis=2)
    balanced = np.linalg.norm(pulls.sum(axis=1), axis=1) <= HALF * sizes.max(axis=1)
    alike = np.abs(sizes[:, 0] - sizes[:, 1]) <= HALF * sizes[:, 0]
    if not (balanced & alike & np.isfinite(found).all(axis=1) & (powers != 0.0)).all():
        return False
    coefficients = np.array([-rates / 2.0, -squares]) / powers
    same = np.abs(coefficients - coefficients[:, :1]) <= HALF * np.abs(coefficients[:, :1])
    return bool((same.all(axis=1) & (coefficients[:, 0] < 0.0)).any())
