"""See a mechanism move: shapes on frames and points, and one HTML file that anyone can open.

Import what you need from here::

    from pydy.viz import Scene, Visual, Sphere, Cylinder, Line

A `Scene` takes trajectories and expressions; ``system.scene(...)`` is the short way from a System.
"""

from __future__ import annotations

from pydy.viz.scene import Scene
from pydy.viz.shapes import (
    Arrow,
    Box,
    Capsule,
    Cone,
    Cylinder,
    Line,
    Mesh,
    Plane,
    Shape,
    Sphere,
    Torus,
    Trace,
)
from pydy.viz.visuals import Visual

__all__ = [
    "Arrow",
    "Box",
    "Capsule",
    "Cone",
    "Cylinder",
    "Line",
    "Mesh",
    "Plane",
    "Scene",
    "Shape",
    "Sphere",
    "Torus",
    "Trace",
    "Visual",
]
