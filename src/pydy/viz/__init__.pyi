from . import (
    animation as animation,
    camera as camera,
    light as light,
    scene as scene,
    shapes as shapes,
    views as views,
    visualization_frame as visualization_frame,
    visuals as visuals,
)
from .defaults import (
    gravities as gravities,
    guess_up as guess_up,
    load_arrows as load_arrows,
    visuals_of as visuals_of,
)
from .live import Live as Live, LiveSystem as LiveSystem, Slider as Slider
from .motion import (
    Geometry as Geometry,
    Names as Names,
    SceneModel as SceneModel,
    SceneMotion as SceneMotion,
    compute_placement as compute_placement,
)
from .outlines import Outline as Outline, outline as outline
from .scene import Scene as Scene
from .shapes import (
    Arrow as Arrow,
    Bar as Bar,
    Box as Box,
    Capsule as Capsule,
    Circle as Circle,
    Cone as Cone,
    Cube as Cube,
    Cylinder as Cylinder,
    Damper as Damper,
    Icosahedron as Icosahedron,
    Line as Line,
    Mesh as Mesh,
    Octahedron as Octahedron,
    Plane as Plane,
    Shape as Shape,
    Sphere as Sphere,
    Spring as Spring,
    Tetrahedron as Tetrahedron,
    Torus as Torus,
    TorusKnot as TorusKnot,
    Trace as Trace,
    Tube as Tube,
    read_mesh as read_mesh,
)
from .views import (
    OrthoGraphicCamera as OrthoGraphicCamera,
    PerspectiveCamera as PerspectiveCamera,
    PointLight as PointLight,
    VisualizationFrame as VisualizationFrame,
)
from .visuals import Visual as Visual
