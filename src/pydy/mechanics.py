"""Multibody systems from their bodies, loads, kinematics and constraints."""

from pydy._mechanics import Definition, Implicit

__all__ = ["Definition", "Implicit"]
