"""Machines of vehicles: the torque of a motor, a differential, and the air.

`motor_torque` and `differential_torques` take numbers, arrays and expressions; `aerodynamic_loads`
makes the load of a `pydy.mechanics.Definition`.
"""

from pydy.vehicles.aerodynamics import aerodynamic_loads
from pydy.vehicles.drivetrain import differential_torques, motor_torque

__all__ = ["aerodynamic_loads", "differential_torques", "motor_torque"]
