"""Whether a potential energy is that of some loads: its rate must be minus their power.

It is decided by numbers at generic states that keep the constraints, as in `classify`: velocities
that a user simplified with a constraint agree only there.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from pydy._graph.derivative import dense_jacobian
from pydy._mechanics.equations import Equations
from pydy._mechanics.generic import GenericStates
from pydy._mechanics.tuning import AGREEING

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
    terms = [*gained, *states.read.all(powers)]
    values = next(states.samples([("terms", (len(terms),), terms)], _TRIALS), None)
    if values is None:
        return False
    found = values["terms"]
    return bool(abs(found.sum()) <= AGREEING * max(np.abs(found).sum(), np.finfo(float).tiny))


def has_momenta_of(equations: Equations, lagrangian: Any, kinetic: Any) -> bool:
    """Return whether a Lagrangian and a kinetic energy have the same derivatives by the speeds."""
    states = GenericStates(equations, (lagrangian, kinetic), "the energy")
    nodes = states.read.all((lagrangian, kinetic))
    shape = 2, len(states.speeds)
    block = ("momenta", shape, dense_jacobian(states.graph, nodes, states.speeds))
    values = next(states.samples([block], _TRIALS), None)
    if values is None:
        return False
    found, expected = values["momenta"]
    return bool(np.abs(found - expected).max() <= AGREEING * np.abs(expected).max())
