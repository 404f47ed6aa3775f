"""Equations of motion from a `Multibody`, whatever it was read from."""

from __future__ import annotations

from dataclasses import replace

from pydy._mechanics.choice import chosen
from pydy._mechanics.classify import classify
from pydy._mechanics.equations import Equations
from pydy._mechanics.form import auxiliary_equations
from pydy._mechanics.mechanism import Mechanism
from pydy._mechanics.reader import Multibody
from pydy._mechanics.symbols import rate_of

__all__ = ["equations_of", "kinematics_of"]


def kinematics_of(body: Multibody) -> Equations:
    """Return the kinematics and constraints alone, without equations of motion."""
    auxiliary = body.auxiliary
    return Equations(
        time=body.time,
        coordinates=body.coordinates,
        speeds=body.speeds,
        coordinate_rates=body.coordinate_rates,
        speed_rates=body.speed_rates,
        coordinate_derivatives=body.coordinate_derivatives,
        mass_matrix=(),
        forcing=(),
        positive_definite=not body.dependent_speeds,
        holonomic=body.holonomic,
        velocity=body.velocity,
        dependent_coordinates=body.dependent_coordinates,
        dependent_speeds=body.dependent_speeds,
        auxiliary_speeds=auxiliary,
        # In motion the auxiliary speeds are zero at all times.
        zeros=(*auxiliary, *(rate_of(u, body.time) for u in auxiliary)),
        multibody=body if body.bodies or body.lagrangian is not None else None,
    )


def equations_of(body: Multibody) -> Equations:
    """Return the equations of motion, formed on a graph."""
    base = kinematics_of(body)
    found = chosen(body)
    energy = found.energy(body.time, body.coordinates, body.speeds)
    return classify(
        replace(
            base,
            formed=found,
            mechanism=Mechanism(body.frame, body.bodies, body.loads, energy),
            auxiliary_equations=tuple(auxiliary_equations(body)) if body.auxiliary else (),
        )
    )
