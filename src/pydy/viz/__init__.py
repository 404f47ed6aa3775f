"""Animate mechanisms: shapes attached to frames and points, written to a single HTML file.

Import what you need from here::

    from pydy.viz import Scene, Visual, Sphere, Cylinder, Line

A `Scene` takes trajectories and expressions; ``system.scene(...)`` is the short way from a System.
"""

from pydy.viz.live import Live, Slider
from pydy.viz.scene import Scene
from pydy.viz.shapes import (
    Arrow,
    Bar,
    Box,
    Capsule,
    Circle,
    Cone,
    Cube,
    Cylinder,
    Damper,
    Icosahedron,
    Line,
    Mesh,
    Octahedron,
    Plane,
    Shape,
    Sphere,
    Spring,
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
    "Bar",
    "Box",
    "Capsule",
    "Circle",
    "Cone",
    "Cube",
    "Cylinder",
    "Damper",
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
    "Spring",
    "Tetrahedron",
    "Torus",
    "TorusKnot",
    "Trace",
    "Tube",
    "Visual",
    "VisualizationFrame",
]
