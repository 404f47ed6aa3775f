"""Animate mechanisms: shapes attached to frames and points, written to a single HTML file.

Import what you need from here::

    from pydy.viz import Scene, Visual, Sphere, Cylinder, Line

A `Scene` takes trajectories and expressions; ``system.scene(...)`` is the short way from a System.
"""

import lazy_loader

__getattr__, _, _ = lazy_loader.attach_stub(__name__, __file__)
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

__dir__ = __all__.copy  # the stub lists what other rooms take, too
