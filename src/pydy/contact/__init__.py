"""Contact and friction: laws as expressions, and exact contacts with modes.

Laws are functions that return SymPy expressions of a gap, a speed and a normal force;
`CompliantContact` makes loads of them, for any method of mechanics. `Contacts` simulates a System
with contacts that open, close, stick and slide at exact times: gaps, `Unilateral`, and friction
that sticks, `Stick`. `Roll` and `Clearance` make these of a geometry.
"""

import lazy_loader

__getattr__, _, _ = lazy_loader.attach_stub(__name__, __file__)
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

__dir__ = __all__.copy  # the stub lists what other rooms take, too
