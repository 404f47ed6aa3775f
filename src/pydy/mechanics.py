"""Multibody systems from their bodies, loads, kinematics and constraints."""

from pydy._mechanics.definition import Definition

__all__ = ["Definition"]
