"""Animate mechanisms: shapes attached to frames and points, written to a single HTML file.

Import what you need from here::

    from pydy.viz import Scene, Visual, Sphere, Cylinder, Line

A `Scene` takes trajectories and expressions; ``system.scene(...)`` is the short way from a System.
"""

from pydy.viz.live import Live, Slider
from pydy.viz.scene import Scene
from pydy.viz.shapes import (
    Arrow,
    Box,
    Capsule,
    Circle,
    Cone,
    Cube,
    Cylinder,
    Icosahedron,
    Line,
    Mesh,
    Octahedron,
    Plane,
    Shape,
    Sphere,
    Tetrahedron,
    Torus,
    TorusKnot,
    Trace,
    Tube,
)
from pydy.viz.views import (
    OrthoGraphicCamera,
    PerspectiveCamera,
    PointLight,
    VisualizationFrame,
)
from pydy.viz.visuals import Visual

__all__ = [
    "Arrow",
    "Box",
    "Capsule",
    "Circle",
    "Cone",
    "Cube",
    "Cylinder",
    "Icosahedron",
    "Line",
    "Live",
    "Mesh",
    "Octahedron",
    "OrthoGraphicCamera",
    "PerspectiveCamera",
    "Plane",
    "PointLight",
    "Scene",
    "Shape",
    "Slider",
    "Sphere",
    "Tetrahedron",
    "Torus",
    "TorusKnot",
    "Trace",
    "Tube",
    "Visual",
    "VisualizationFrame",
]
