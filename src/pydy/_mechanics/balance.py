"""Whether a potential energy is that of some loads: its rate must be minus their power.

It is decided by numbers at generic states that keep the constraints, as in `classify`: velocities
that a user simplified with a constraint agree only there.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from pydy._graph.derivative import dense_jacobian
from pydy._graph.rounding import rounding_bounds
from pydy._mechanics.equations import Equations
from pydy._mechanics.generic import GenericStates
from pydy._mechanics.tuning import CANCELLING

__all__ = ["has_momenta_of", "is_potential_of"]

_TRIALS = 3


def is_potential_of(equations: Equations, potential: Any, powers: Sequence[Any]) -> bool:
    """Return whether ``d potential/dt = -sum(powers)``.

    Parameters
    ----------
    equations : Equations
    potential : expression in q, t, constants and specifieds
    powers : sequence of expressions in q, u, t, constants and specifieds
    """
    states = GenericStates(equations, (potential, *powers), "the energy")
    gained = states.rates([states.read(potential)])
    lost = states.graph.sum([(n, 1.0) for n in (*gained, *states.read.all(powers))])
    return _vanish(states, [lost])


def has_momenta_of(equations: Equations, lagrangian: Any, kinetic: Any) -> bool:
    """Return whether a Lagrangian and a kinetic energy have the same derivatives by the speeds."""
    states = GenericStates(equations, (lagrangian, kinetic), "the energy")
    nodes = states.read.all((lagrangian, kinetic))
    shape = 2, len(states.speeds)
    momenta = np.reshape(dense_jacobian(states.graph, nodes, states.speeds), shape).tolist()
    return _vanish(states, [states.graph.sub(a, b) for a, b in zip(*momenta, strict=True)])


def _vanish(states: GenericStates, nodes: Sequence[int]) -> bool:
    """Return whether nodes are no more than rounding errors of their own terms."""
    pairs = [*nodes, *rounding_bounds(states.graph, nodes)]
    samples = states.samples([("pairs", (2, len(nodes)), pairs)], _TRIALS)
    found = [np.abs(sample["pairs"]) for sample in samples]
    return bool(found) and all((left <= CANCELLING * bound).all() for left, bound in found)
