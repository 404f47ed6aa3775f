"""Contact and friction: laws as expressions.

`laws` are functions that return SymPy expressions of a gap, a speed and a normal force;
`CompliantContact` makes loads of them, for any method of mechanics.
"""

from __future__ import annotations

from pydy.contact.compliant import CompliantContact
from pydy.contact.laws import (
    brown_mcphee,
    hunt_crossley,
    joint_friction,
    kelvin_voigt,
    rolling_resistance,
    stribeck,
)

__all__ = [
    "CompliantContact",
    "brown_mcphee",
    "hunt_crossley",
    "joint_friction",
    "kelvin_voigt",
    "rolling_resistance",
    "stribeck",
]
