"""Contact and friction: laws as expressions, and exact contacts with modes.

Laws are functions that return SymPy expressions of a gap, a speed and a normal force;
`CompliantContact` makes loads of them, for any method of mechanics. `Contacts` simulates a System
with contacts that open, close, stick and slide at exact times: gaps, `Unilateral`, and friction
that sticks, `Stick`. `Roll` and `Clearance` make these of a geometry.
"""

from pydy.contact.compliant import CompliantContact
from pydy.contact.conditions import Stick, Unilateral
from pydy.contact.contacts import Contacts
from pydy.contact.joints import Clearance, Roll
from pydy.contact.laws import (
    brown_mcphee,
    hunt_crossley,
    joint_friction,
    kelvin_voigt,
    rolling_resistance,
    stribeck,
)
from pydy.contact.trajectory import ContactTrajectory

__all__ = [
    "Clearance",
    "CompliantContact",
    "ContactTrajectory",
    "Contacts",
    "Roll",
    "Stick",
    "Unilateral",
    "brown_mcphee",
    "hunt_crossley",
    "joint_friction",
    "kelvin_voigt",
    "rolling_resistance",
    "stribeck",
]
