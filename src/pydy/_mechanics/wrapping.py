"""Forces along paths that wrap a surface, which SymPy 1.14 directs the other way round.

An actuator can be recognised by its type. Its loads are three forces in equilibrium: at both ends,
and at the surface. With the tension p along the path, of length L,

    p² = |F|²,    −p L' = P, the power of the three,

so that a spring's stiffness p'/L' is −(|F|²/2)'/P, and a damper's coefficient p/L' is −|F|²/P.
If one of them is the same negative constant at all states, the force has the wrong sign. Muscles
cannot be recognised by their loads.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np
from sympy.physics.mechanics import Force

from pydy._errors import UnsupportedFunctionError
from pydy._graph import Graph, inputs_of, signatures
from pydy._mechanics.components import dot, flat
from pydy._mechanics.equations import Equations
from pydy._mechanics.formulations import moving
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.reader import InputReader, is_reversed, warn_of_reversed, wrapped_force_pulls
from pydy._rank import HALF

if TYPE_CHECKING:
    from sympy.physics.mechanics import ActuatorBase, ReferenceFrame, Vector

    from pydy._sympy_types import Load

_STATES = 4


def warn_of_reversed_forces(equations: Equations, actuators: Iterable[ActuatorBase] = ()) -> None:
    """Warn of forces of springs, dampers and muscles that a WrappingPathway reverses.

    Actuators among the loads were reported when these were read; the `actuators` are those of a
    SymPy System whose equations were formed from their loads.
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
            locations = ", ".join(str(location) for location, _ in three)
            warn_of_reversed(f"The force of a spring or damper, at {locations},")
            return


def _of_three(body: Multibody) -> list[tuple[Load, ...]]:
    """Return triples of consecutive forces that a pathway may have produced."""
    three = zip(body.loads, body.loads[1:], body.loads[2:], strict=False)
    return [
        loads
        for loads in three
        if all(isinstance(load, Force) for load in loads)
        and len({location for location, _ in loads}) == 3
        and _in_balance([vector for _, vector in loads])
    ]


def _in_balance(vectors: Iterable[Vector]) -> bool:
    """Return whether the sum of vectors vanishes identically."""
    graph = Graph()
    read = InputReader(graph, {}, ())
    sums: dict[ReferenceFrame, list[int]] = {}
    for part, frame in (part for vector in vectors for part in vector.args):
        total = sums.setdefault(frame, [graph.zero] * 3)
        try:
            nodes = read.all(part)
        except UnsupportedFunctionError:
            return False  # no pathway's
        sums[frame] = [graph.add(a, b) for a, b in zip(total, nodes, strict=True)]
    return not any(signatures(graph, flat([*sums.values()])))


def _is_negative(body: Multibody, loads: Sequence[Load]) -> bool:
    """Return whether three forces are a spring's or a damper's with a negative coefficient."""
    k = moving(body, in_bodies=False)
    g = k.graph
    forces = [k.vector(vector, k.inertial) for _, vector in loads]
    motions = [
        k.expressed(v, frame, k.inertial) for frame, v in (k.velocity_of(w) for w, _ in loads)
    ]
    square = dot(g, forces[0], forces[0])
    power = g.add(*(dot(g, f, v) for f, v in zip(forces, motions, strict=True)))
    nodes = [*flat(forces), square, k.dt([square])[0], power]
    inputs = inputs_of(g, nodes)
    values = np.random.default_rng(0).uniform(0.5, 1.5, (len(inputs), _STATES))
    constant = [g.constant[n] for n in inputs]
    values[constant] = values[constant, :1]
    values = g.evaluator(nodes)(dict(zip(inputs, values, strict=True)), _STATES)
    pulls, (squares, rates, powers) = values[:, :9].reshape(_STATES, 3, 3), values[:, 9:].T
    sizes = np.linalg.norm(pulls, axis=2)
    balanced = np.linalg.norm(pulls.sum(axis=1), axis=1) <= HALF * sizes.max(axis=1)
    alike = np.abs(sizes[:, 0] - sizes[:, 1]) <= HALF * sizes[:, 0]
    if not (balanced & alike & np.isfinite(values).all(axis=1) & (powers != 0.0)).all():
        return False
    coefficients = np.array([-rates / 2.0, -squares]) / powers
    same = np.abs(coefficients - coefficients[:, :1]) <= HALF * np.abs(coefficients[:, :1])
    return bool((same.all(axis=1) & (coefficients[:, 0] < 0.0)).any())
