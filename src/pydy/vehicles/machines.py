"""Machines of vehicles: motors, gears, clutches, brakes, bushings, anti-roll bars, and the air.

Laws take numbers, arrays and expressions: `motor_torque` and `power_limited_torque`, `gear_ratio`
and `gear_torque`, `differential_torques`. `clutch` and `brake` are dry friction that locks, for
`pydy.contact.Contacts`. `bushing_loads`, `anti_roll_bar_loads` and `aerodynamic_loads` make loads
of a `pydy.mechanics.Definition`.

Gears without losses and locked differentials are constraints among the
`nonholonomic_constraints` of a Definition: ω_in − i ω_out = 0 and ω_l − ω_r = 0.
"""

from pydy.vehicles.aerodynamics import aerodynamic_loads
from pydy.vehicles.bushings import anti_roll_bar_loads, bushing_loads, torsion_bar_stiffness
from pydy.vehicles.clutches import brake, clutch, clutch_capacity
from pydy.vehicles.drivetrain import (
    differential_torques,
    gear_ratio,
    gear_torque,
    motor_torque,
    power_limited_torque,
)

__all__ = [
    "aerodynamic_loads",
    "anti_roll_bar_loads",
    "brake",
    "bushing_loads",
    "clutch",
    "clutch_capacity",
    "differential_torques",
    "gear_ratio",
    "gear_torque",
    "motor_torque",
    "power_limited_torque",
    "torsion_bar_stiffness",
]
