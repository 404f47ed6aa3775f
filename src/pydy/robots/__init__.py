"""Robots from URDF and MJCF files, as multibody systems in symbols."""

from pydy.robots.assemble import JointSymbols, Place, TendonSymbols
from pydy.robots.robot import Robot, read

__all__ = ["JointSymbols", "Place", "Robot", "TendonSymbols", "read"]
