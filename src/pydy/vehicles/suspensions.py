"""Suspensions: hard points, their kinematics, and models of quarter cars and whole cars.

`DoubleWishbone` and `McPherson` are made of hard points. Their method `curves` returns camber, toe,
roll center and motion ratio over the travel of the wheel; `build` returns bodies, coordinates,
constraints of the loops and loads for a `pydy.mechanics.Definition`. `sprung_double_track` makes a
System of a car with 14 degrees of freedom, whose body moves on springs, dampers and anti-roll bars;
`SPRUNG_AXLES` has published values.
"""

from pydy.vehicles.linkages import DoubleWishbone, McPherson
from pydy.vehicles.sprung_car import SPRUNG_AXLES, SprungAxles, sprung_double_track
from pydy.vehicles.suspension_curves import SuspensionCurves
from pydy.vehicles.suspension_model import SuspensionModel

__all__ = [
    "SPRUNG_AXLES",
    "DoubleWishbone",
    "McPherson",
    "SprungAxles",
    "SuspensionCurves",
    "SuspensionModel",
    "sprung_double_track",
]
