"""Multibody systems from their bodies, loads, kinematics and constraints."""

from pydy._mechanics.definition import Definition
from pydy._mechanics.implicit import Implicit

__all__ = ["Definition", "Implicit"]
